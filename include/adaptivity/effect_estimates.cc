/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/effect_estimates.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "base/errors.h"
#include "base/interruption.h"
#include "model/rotated_tie.h"
#include "parameters/formula.h"
#include "probes/probes.h"

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



    /// Whether a history grows for a while, from zero, and falls for another.
    bool turns_back(const std::string &history)
    {
      if (history.empty())
        return false;
      const unsigned int n_samples = 64;
      const auto         value     = parse_history(history, "history");
      double             rise = 0, fall = 0, last = 0;
      for (unsigned int k = 0; k <= n_samples; ++k)
        {
          const double next = value(Point<1>(double(k) / n_samples));
          (next > last ? rise : fall) += std::abs(next - last);
          last = next;
        }
      const double round_off = 1e-10;
      return std::min(rise, fall) > round_off * std::max(rise, fall);
    }



    /// The same of one of the loads, supports and obstacles of a scene.
    bool turns_back(const Parameters::All &scene)
    {
      std::vector<std::string> histories;
      const auto               add = [&](const auto &of_names) {
        for (const auto &of_name : of_names)
          histories.push_back(of_name.second);
      };
      add(scene.boundary.histories);
      add(scene.solids.thermal_strain);
      for (const Parameters::Contact &pair : scene.pairs())
        {
          add(pair.obstacle_motion);
          add(pair.obstacle_force);
          for (const auto &history :
               {pair.obstacle_moment, pair.interference, pair.preload})
            histories.push_back(history);
        }
      return std::any_of(histories.begin(),
                         histories.end(),
                         [](const std::string &history) {
                           return turns_back(history);
                         });
    }



    /// Two Newton steps into a variant, behind the first one @p between.
    void make_two_steps(VariantModel                &variant,
                        const std::function<void()> &between)
    {
      const double step = variant.make_step();
      between();
      const double next    = variant.make_step();
      const double nothing = 1e-8 * largest_displacement(variant);
      if (next > std::max(step / 2, nothing))
        throw NotConverged("the steps do not become shorter: it is far from "
                           "here, or nothing holds a body");
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
    IncrementState<2>   state = other.state;
    const RotatedTie<2> glue(other.model, state.solution);
    for (const auto &[name, probe] : probes)
      values[name] = probe_value(probe, other.model, state);
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



  bool EffectEstimates::remembers_slip(const VariantModel &of) const
  {
    return of.model.has_friction() && state.start_factor > 0;
  }



  // Of the scene, Newton's method goes on to the end of all loops.
  std::vector<EffectEstimate> EffectEstimates::estimate()
  {
    TimerOutput::Scope scope(timer, "effects");
    scene = std::make_unique<VariantModel>(parameters, model, state, timer);
    if (remembers())
      scene->model.elasticity->restore(model.elasticity->history());
    seconds = converge(*scene);
    values  = probes_of(*scene);
    {
      IncrementState<2>   present = state;
      const RotatedTie<2> glue(model, present.solution);
      for (const auto &[name, probe] : probes)
        left[name] = values.at(name) - probe_value(probe, model, present);
    }
    if (state.start_factor > 0 && model.interface && !remembers())
      solve_at_once();

    std::vector<EffectEstimate> estimates;
    for (const SceneVariant &variant : scene_variants(parameters))
      estimates.push_back(is_idle(variant) ? of_nothing(variant)
                                           : of_variant(variant));
    if (parameters.element.degree == 1)
      estimates.push_back(of_quadratic_elements());
    estimates.push_back(of_increments());
    return estimates;
  }



  void EffectEstimates::solve_at_once()
  {
    IncrementState<2> from = scene->state;
    from.start             = scene->model.zero();
    from.start_factor      = 0;
    try
      {
        scene_at_once =
          std::make_unique<VariantModel>(parameters, scene->model, from, timer);
        converge(*scene_at_once);
        values_at_once = probes_of(*scene_at_once);
      }
    catch (const NotConverged &)
      {
        scene_at_once.reset();
      }
  }



  EffectEstimate EffectEstimates::of_nothing(const SceneVariant &variant) const
  {
    EffectEstimate estimate{variant.effect, variant.is_on, {}};
    for (const auto &[name, probe] : probes)
      estimate.changes[name] = estimate.uncertainties[name] = 0;
    return estimate;
  }



  EffectEstimate EffectEstimates::of_variant(const SceneVariant &variant) const
  {
    EffectEstimate estimate{variant.effect, variant.is_on, variant.entries};
    try
      {
        check_knowledge(variant);
        std::map<std::string, double> first;
        VariantModel                  other(variant.parameters,
                           scene->model,
                           scene->state,
                           timer);
        const auto                    begin = Clock::now();
        make_two_steps(other, [&]() {
          estimate.price = seconds_since(begin) / seconds;
          first          = probes_of(other);
        });
        other.check_supports();
        const auto second         = probes_of(other);
        estimate.changes          = difference(second, values);
        estimate.uncertainties    = difference(second, first);
        estimate.n_status_changes = other.n_status_changes;
        add_way(variant, other, estimate);
      }
    catch (const NotConverged &failure)
      {
        estimate.unknown = failure.what();
      }
    return estimate;
  }



  // Quadratic elements have other shapes to bend in and other points of
  // contact: more than two steps away. The last one is the uncertainty; with
  // friction in several increments, where other points stick, all of the change
  // is uncertain.
  EffectEstimate EffectEstimates::of_quadratic_elements() const
  {
    const SceneVariant variant = quadratic_elements(parameters);
    EffectEstimate     estimate{variant.effect, variant.is_on, variant.entries};
    try
      {
        if (remembers())
          throw NotConverged("plastic strains remember the way");
        VariantModel other(variant.parameters,
                           scene->model,
                           scene->state,
                           timer);
        estimate.price = converge(other) / seconds;
        other.check_supports();
        const auto before = probes_of(other);
        other.make_step();
        const auto after       = probes_of(other);
        estimate.changes       = difference(after, values);
        estimate.uncertainties = difference(after, before);
        if (remembers_slip(other))
          estimate.uncertainties = estimate.changes;
        estimate.n_status_changes = other.n_status_changes;
      }
    catch (const NotConverged &failure)
      {
        estimate.unknown = failure.what();
      }
    return estimate;
  }



  // Friction remembers the way there, of which the state tells the start of the
  // last increment. With the effect that would be elsewhere: as far as the
  // effect moves the end of a way of one increment, by the share of the load
  // that acted at the start. Uncertain is how far this moves the probes, and
  // how far they are from those of one increment.
  void EffectEstimates::add_way(const SceneVariant &variant,
                                VariantModel       &other,
                                EffectEstimate     &estimate) const
  {
    if (!remembers_slip(other))
      return;
    if (turns_back(parameters) || turns_back(variant.parameters))
      throw NotConverged("a load has turned back, and friction remembers the "
                         "way");
    try
      {
        if (!scene_at_once)
          throw NotConverged("one increment is not enough");
        VariantModel at_once(variant.parameters,
                             scene_at_once->model,
                             scene_at_once->state,
                             timer);
        make_two_steps(at_once, []() {});
        const auto in_one = difference(probes_of(at_once), values_at_once);
        other.change_start(*scene, at_once, *scene_at_once);
        other.make_step();
        const auto changes = difference(probes_of(other), values);
        for (auto &[name, uncertainty] : estimate.uncertainties)
          {
            const double change = changes.at(name);
            uncertainty         = std::abs(uncertainty) +
                          std::max(std::abs(change - estimate.changes.at(name)),
                                   std::abs(change - in_one.at(name)));
          }
        estimate.changes = changes;
      }
    catch (const NotConverged &)
      {
        estimate.uncertainties = estimate.changes;
      }
  }



  EffectEstimate EffectEstimates::of_increments() const
  {
    const SceneVariant variant = doubled_increments(parameters);
    EffectEstimate     estimate{variant.effect, variant.is_on, variant.entries};
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
