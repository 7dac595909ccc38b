/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_effect_estimates_h
#define contact_effect_estimates_h

#include <deal.II/base/timer.h>

#include <map>
#include <memory>

#include "adaptivity/effect_estimate.h"
#include "adaptivity/scene_variants.h"
#include "adaptivity/stress_peaks.h"
#include "adaptivity/variant_model.h"
#include "model/contact_model.h"
#include "model/increment_state.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Estimates of what each effect does to the probes, without a run of its own.
   *
   * A state x solves the problem of the scene, A(x) = 0; a variant of the scene
   * has other equations B on the same mesh. Its solution is approached by
   * Newton's method from x,
   *   x_1 = x - B'(x)^-1 B(x),   x_2 = x_1 - B'(x_1)^-1 B(x_1),
   * the active set being searched in each linearised problem. The first step is
   * the estimate by residuals; the second one corrects it, and says by its
   * length how far the estimate can be trusted: where the steps do not become
   * shorter, nothing is known. The scene's own state is first brought to the
   * end of all loops in the same way: what they have left is no effect.
   * Quadratic elements take as many steps as they need, from the displacements
   * and pressures of linear ones; without that, errors of linear elements by
   * dual weighted residuals were off by factors from -45 to 5 on coarse meshes.
   *
   * Friction remembers the way, of which the state knows the start of its last
   * increment alone: add_way() guesses how the effect would have moved that.
   * Not seen: the history of plastic strains. A body that yields in the variant
   * alone would have done so in one increment: nothing is told where points
   * that were above the yield stress have been unloaded, and of a scene that
   * yields in several increments only what it is without plasticity.
   */
  class EffectEstimates
  {
  public:
    /// The @p state has converged, the @p peaks are those of its way.
    EffectEstimates(const Parameters::All   &parameters,
                    ContactModel<2>         &model,
                    const IncrementState<2> &state,
                    const StressPeaks<2>    &peaks,
                    TimerOutput             &timer);

    /// Of all variants of the scene, of quadratic elements instead of linear
    /// ones, and of twice the increments.
    std::vector<EffectEstimate> estimate();

    /// By probe, the error [mm or MPa] that the loops and the linear solver
    /// have left. After estimate().
    const std::map<std::string, double> &remainders() const
    {
      return left;
    }

  private:
    template<class Other>
    std::map<std::string, double> probes_of(const Other &other) const;
    void           check_knowledge(const SceneVariant &variant) const;
    bool           is_idle(const SceneVariant &variant) const;
    bool           remembers() const;
    void           solve_at_once();
    EffectEstimate of_nothing(const SceneVariant &variant) const;
    EffectEstimate of_variant(const SceneVariant &variant) const;
    EffectEstimate of_quadratic_elements() const;
    EffectEstimate of_increments() const;
    bool           remembers_slip(const VariantModel &of) const;
    void           add_way(const SceneVariant &variant,
                           VariantModel       &other,
                           EffectEstimate     &estimate) const;

    const Parameters::All                &parameters;
    ContactModel<2>                      &model;
    const IncrementState<2>              &state;
    const StressPeaks<2>                 &peaks;
    TimerOutput                          &timer;
    const Parameters::Probes::Definitions probes;

    /// The scene at the end of all loops, and as if one increment were the
    /// whole way; none if that is not to be had.
    std::unique_ptr<VariantModel> scene, scene_at_once;
    std::map<std::string, double> values, values_at_once;
    double                        seconds = 0; // of a Newton step

    std::map<std::string, double> left;
  };
} // namespace Contact

#endif
