/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/effect_estimates.h"

#include <algorithm>
#include <chrono>

#include "adaptivity/variant_model.h"
#include "base/errors.h"
#include "base/interruption.h"
#include "contact/probes.h"

namespace Contact
{
  namespace
  {
    /// Seconds of wall time since a moment.
    using Clock = std::chrono::steady_clock;
    double seconds_since(const Clock::time_point begin)
    {
      return std::chrono::duration<double>(Clock::now() - begin).count();
    }



    double largest_displacement(const VariantModel &of)
    {
      return of.model.discretization->displacements(of.state.solution)
        .linfty_norm();
    }



    /// Newton's method in the scene itself, until its steps are nothing beside
    /// the displacements. Returns the wall time of the first one [s].
    double converge(VariantModel &scene)
    {
      const unsigned int max_steps = 20;
      const auto         begin     = Clock::now();
      double             step      = scene.make_step();
      const double       seconds   = seconds_since(begin);
      for (unsigned int n = 1; step > 1e-8 * largest_displacement(scene); ++n)
        {
          if (n == max_steps)
            throw NotConverged("Newton's method does not come to an end here");
          step = scene.make_step();
        }
      return seconds;
    }



    /// By key the difference of two maps.
    std::map<std::string, double>
    difference(std::map<std::string, double>        a,
               const std::map<std::string, double> &b)
    {
      for (auto &[name, value] : a)
        value -= b.at(name);
      return a;
    }
  } // namespace



  EffectEstimates::EffectEstimates(const Parameters::All   &parameters,
                                   ContactModel<2>         &model,
                                   const IncrementState<2> &state,
                                   const StressPeaks<2>    &peaks,
                                   TimerOutput             &timer)
    : parameters(parameters)
    , model(model)
    , state(state)
    , peaks(peaks)
    , timer(timer)
    , probes(parameters.probes.definitions())
  {
  }



  // Plastic strains are those of an increment that has been accepted.
  template<class Other>
  std::map<std::string, double>
  EffectEstimates::probes_of(const Other &other) const
  {
    std::map<std::string, double> values;
    Elasticity<2>                &bodies  = *other.model.elasticity;
    const CellValues              history = bodies.history();
    bodies.accept(other.state.solution);
    for (const auto &[name, probe] : probes)
      values[name] = probe_value(probe, other.model, other.state);
    bodies.restore(history);
    return values;
  }



  // Bodies of the scene that yield have a history, unless one increment is the
  // whole way. Bodies that begin to yield in a variant return from the strains
  // of the end, as if these had grown in proportion.
  void EffectEstimates::check_knowledge(const SceneVariant &variant) const
  {
    if (!variant.unknown.empty())
      throw NotConverged(variant.unknown);
    const Parameters::Solids &solids = variant.parameters.solids;
    if (remembers() && solids.may_yield())
      throw NotConverged("plastic strains remember the way");

    if (!solids.may_yield() || model.elasticity->has_history())
      return;
    if (parameters.restart)
      throw NotConverged("the stresses before the restart are not known");
    const double few = 0.05;
    for (const auto &of_body : solids.yield_stress)
      if (peaks.share_gone(of_body.first) > few)
        throw NotConverged("stresses above the yield stress on the way are "
                           "gone at the end");
  }



  // With other cells such a body would change, but not by yielding.
  bool EffectEstimates::is_idle(const SceneVariant &variant) const
  {
    const Parameters::Solids &solids = variant.parameters.solids;
    if (!variant.unknown.empty() || parameters.restart)
      return false;
    bool is_one = false;
    for (const auto &[body, stress] : solids.yield_stress)
      if (parameters.solids.model_of(body) != solids.model_of(body))
        {
          if (!peaks.is_elastic(body))
            return false;
          is_one = true;
        }
    return is_one;
  }



  bool EffectEstimates::remembers() const
  {
    return model.elasticity->has_history() && state.start_factor > 0;
  }



  // Of the scene, Newton's method goes on to the end of all loops.
  std::vector<EffectEstimate> EffectEstimates::estimate()
  {
    TimerOutput::Scope scope(timer, "effects");
    VariantModel       scene(parameters, model, state, timer);
    if (remembers())
      scene.model.elasticity->restore(model.elasticity->history());
    const double seconds = converge(scene);
    const auto   values  = probes_of(scene);
    for (const auto &[name, probe] : probes)
      left[name] = values.at(name) - probe_value(probe, model, state);

    std::vector<EffectEstimate> estimates;
    for (const SceneVariant &variant : scene_variants(parameters))
      {
        EffectEstimate estimate{variant.effect, variant.is_on, variant.entries};
        if (is_idle(variant))
          {
            estimate.entries.clear();
            for (const auto &[name, probe] : probes)
              estimate.changes[name] = estimate.uncertainties[name] = 0;
            estimates.push_back(estimate);
            continue;
          }
        try
          {
            check_knowledge(variant);
            VariantModel other(variant.parameters,
                               scene.model,
                               scene.state,
                               timer);
            const auto   begin   = Clock::now();
            const double step    = other.make_step();
            estimate.price       = seconds_since(begin) / seconds;
            const auto   first   = probes_of(other);
            const double next    = other.make_step();
            const double nothing = 1e-8 * largest_displacement(other);
            if (next > std::max(step / 2, nothing))
              throw NotConverged("the steps do not become shorter: it is far "
                                 "from here, or nothing holds a body");
            other.check_supports();
            const auto second         = probes_of(other);
            estimate.changes          = difference(second, values);
            estimate.uncertainties    = difference(second, first);
            estimate.n_status_changes = other.n_status_changes;
          }
        catch (const NotConverged &failure)
          {
            estimate.unknown = failure.what();
          }
        estimates.push_back(estimate);
      }
    if (parameters.element.degree == 1)
      estimates.push_back(of_quadratic_elements(scene, values, seconds));
    estimates.push_back(of_increments());
    return estimates;
  }



  // Quadratic elements have other shapes to bend in and other points of
  // contact: more than two steps away. The last one is the uncertainty; with
  // friction in several increments the start of the last one is that of linear
  // elements, and all of the change uncertain.
  EffectEstimate EffectEstimates::of_quadratic_elements(
    const VariantModel                  &scene,
    const std::map<std::string, double> &values,
    const double                         seconds) const
  {
    EffectEstimate  estimate{"quadratic elements", false, {"Element/Degree=2"}};
    Parameters::All variant = parameters;
    variant.element.degree  = 2;
    if (!variant.solids.incompatible_modes.empty())
      estimate.entries.push_back("Solids/Incompatible modes=");
    variant.solids.incompatible_modes.clear();
    try
      {
        if (remembers())
          throw NotConverged("plastic strains remember the way");
        VariantModel other(variant, scene.model, scene.state, timer);
        estimate.price = converge(other) / seconds;
        other.check_supports();
        const auto before = probes_of(other);
        other.make_step();
        const auto after       = probes_of(other);
        estimate.changes       = difference(after, values);
        estimate.uncertainties = difference(after, before);
        if (model.has_friction() && state.start_factor > 0)
          estimate.uncertainties = estimate.changes;
        estimate.n_status_changes = other.n_status_changes;
      }
    catch (const NotConverged &failure)
      {
        estimate.unknown = failure.what();
      }
    return estimate;
  }



  EffectEstimate EffectEstimates::of_increments() const
  {
    EffectEstimate estimate{"increments doubled",
                            false,
                            {"Solution/Increments=" +
                             std::to_string(2 *
                                            parameters.solution.n_increments)}};
    estimate.price = 2;
    if (model.has_friction())
      estimate.unknown = "the shear remembers the way";
    else if (model.elasticity->has_history())
      estimate.unknown = "plastic strains remember the way";
    else
      for (const auto &[name, probe] : probes)
        estimate.changes[name] = estimate.uncertainties[name] = 0;
    return estimate;
  }
} // namespace Contact
