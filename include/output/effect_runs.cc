/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/effect_runs.h"

#include <deal.II/base/mpi.h>

#include <cmath>
#include <iostream>

#include "adaptivity/scene_variants.h"
#include "base/errors.h"
#include "output/estimated_effects.h"

namespace Contact
{
  namespace
  {
    /// The run of a variant, on so many nested meshes.
    Parameters::All run_beside(const Parameters::All &scene,
                               const RunSummary      &summary,
                               const std::size_t      n_meshes,
                               Parameters::All        variant)
    {
      variant.output.directory          = scene.directory() / "effects";
      variant.output.screen             = Parameters::Screen::none;
      variant.output.vtu                = false;
      variant.output.profile            = false;
      variant.probes.errors             = Parameters::Errors::none;
      variant.solution.estimate_effects = false;
      variant.probes.accuracy.clear();
      if (variant.pairs().empty())
        variant.probes = without_tractions(variant.probes);
      variant.refinement.n_levels  = n_meshes - 1;
      variant.refinement.tolerance = scene.solution.newton_tolerance;
      variant.findings             = summary.findings; // told already
      return variant;
    }



    /// The first line of an error of the input.
    std::string reason(const InputError &error)
    {
      const std::string text = error.what(), head = "error:  ";
      const std::string line = text.substr(0, text.find('\n'));
      return line.compare(0, head.size(), head) == 0 ? line.substr(head.size())
                                                     : line;
    }



    double cpu_seconds(const RunSummary &summary, const std::size_t n_meshes)
    {
      double sum = 0;
      for (std::size_t k = 0; k < n_meshes; ++k)
        for (const auto &phase : summary.levels[k].time)
          sum += phase.second.cpu;
      return sum;
    }



    /// The error of a value that the tolerances of the loops leave, relative to
    /// it.
    double share_of_loops(const Parameters::Solution &solution)
    {
      return solution.newton_tolerance +
             (solution.friction == Parameters::FrictionLoop::fixed_point
                ? solution.friction_tolerance
                : 0.) +
             (solution.geometry == Parameters::GeometryLoop::fixed_point
                ? solution.geometry_tolerance
                : 0.);
    }



    void compare(const RunSummary           &scene,
                 const RunSummary           &variant,
                 const Parameters::Solution &solution,
                 EffectEstimate             &estimate)
    {
      const std::size_t last = variant.levels.size() - 1;
      // Without contact there is no traction.
      const auto value_on = [&](const std::size_t  level,
                                const std::string &probe) {
        const auto &probes = variant.levels[level].probes;
        const auto  found  = probes.find(probe);
        return found == probes.end() ? 0. : found->second;
      };
      const auto change = [&](const std::size_t  level,
                              const std::string &probe) {
        return value_on(level, probe) - scene.levels[level].probes.at(probe);
      };
      for (const auto &[name, here] : scene.levels[last].probes)
        {
          const double to_last   = scene.levels.back().probes.at(name) - here;
          const double all       = change(last, name);
          estimate.changes[name] = all;

          // Twice, as of estimated errors. What the effect makes of the probe
          // changes with it up to the last mesh.
          estimate.uncertainties[name] =
            share_of_loops(solution) *
              (std::abs(value_on(last, name)) + std::abs(here)) +
            (last > 0 ? 2 * std::abs(all - change(last - 1, name)) : 0.) +
            (to_last == 0
               ? 0.
               : std::min(1., std::abs(all / here)) * std::abs(to_last));
        }
      estimate.price =
        cpu_seconds(variant, last + 1) / cpu_seconds(scene, last + 1);
    }
  } // namespace



  void estimate_effects_by_runs(const Parameters::All  &scene,
                                const ParameterHandler &prm,
                                const SolveCase        &solve,
                                RunSummary             &summary)
  {
    const std::size_t n        = summary.levels.size();
    const std::size_t n_meshes = n > 2 ? n - 1 : n;
    const bool        is_first_rank =
      Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    auto variants = scene_variants(scene);
    if (scene.element.degree == 1)
      variants.push_back(quadratic_elements(scene));
    variants.push_back(doubled_increments(scene));
    for (std::size_t k = 0; k < variants.size() && !summary.interrupted; ++k)
      {
        const SceneVariant &variant = variants[k];
        if (is_first_rank && scene.output.screen != Parameters::Screen::none)
          std::cout << "  effect " << k + 1 << " of " << variants.size() << ": "
                    << variant.effect << (variant.is_on ? " off" : " on")
                    << std::endl;
        EffectEstimate estimate{variant.effect, variant.is_on, variant.entries};
        estimate.unknown = variant.unknown;
        if (estimate.unknown.empty())
          try
            {
              const RunSummary other =
                solve(run_beside(scene, summary, n_meshes, variant.parameters),
                      prm);
              summary.interrupted = other.interrupted;
              if (other.converged)
                compare(summary, other, scene.solution, estimate);
              else
                estimate.unknown = other.message;
            }
          catch (const InputError &error)
            {
              estimate.unknown = reason(error);
            }
        summary.effect_estimates.push_back(estimate);
      }
    accept_errors(scene.probes, summary);
    if (!is_first_rank)
      return;
    std::filesystem::remove_all(scene.directory() / "effects");
    if (scene.output.screen != Parameters::Screen::none)
      print_estimated_effects(std::cout, summary);
  }
} // namespace Contact
