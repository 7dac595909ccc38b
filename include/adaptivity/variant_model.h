/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_variant_model_h
#define contact_variant_model_h

#include <deal.II/base/timer.h>

#include <memory>

#include "model/contact_model.h"
#include "model/increment_state.h"
#include "parameters/parameters.h"
#include "solvers/saddle_point/saddle_point_system.h"

namespace Contact
{
  using namespace dealii;

  /// A variant of the scene in the scene's own state, and Newton's method
  /// from there.
  class VariantModel
  {
  public:
    VariantModel(const Parameters::All   &parameters,
                 const ContactModel<2>   &scene,
                 const IncrementState<2> &from,
                 TimerOutput             &timer);

    /// Returns the largest change of a displacement [mm]. Throws NotConverged
    /// if the linearised problem has no solution, or one that is no state.
    double make_step();

    /// Throws NotConverged if nothing holds a body under the statuses of now:
    /// what slips lets it go.
    void check_supports() const;

    /// The increment starts where that of the scene does, but for what the
    /// variant changes by then: of the change at the end, if the whole way were
    /// one increment for both, the share of the load at the start.
    void change_start(const VariantModel &scene,
                      const VariantModel &at_once,
                      const VariantModel &scene_at_once);

    ContactModel<2>   model;
    IncrementState<2> state;

    /// The statuses that have changed in all steps.
    unsigned int n_status_changes = 0;

  private:
    bool has_new_shear(const ContactModel<2> &scene) const;
    bool has_elements_of(const ContactModel<2> &scene) const;
    bool has_points_of(const ContactInterface<2> &from) const;
    void take_displacements(const ContactModel<2> &scene,
                            const GhostedVector   &of_scene,
                            GhostedVector         &here) const;
    void take_surfaces(const ContactInterface<2> &from,
                       const GhostedVector       &solution);
    void take_multipliers(const ContactInterface<2> &from,
                          const ContactPoint<2>     &point,
                          const GhostedVector       &solution,
                          ContactPoint<2>           &here);
    void transfer_surfaces(const ContactInterface<2> &from,
                           const GhostedVector       &solution);
    void begin_increment();
    void pair();
    void update_statuses();

    ContactLinearization               linearization{};
    std::unique_ptr<SaddlePointSystem> system;
  };
} // namespace Contact

#endif
