/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_refined_state_h
#define contact_refined_state_h

#include <vector>

#include "contact/interface/contact_kernel.h"
#include "contact/interface/surface_transfer.h"
#include "model/increment_state.h"
#include "parameters/parameters.h"

namespace Contact
{
  using namespace dealii;

  /**
   * A converged state on the mesh refined once, where it is not solved: the
   * same displacements and multipliers, and the statuses that follow from them.
   */
  class RefinedState
  {
  public:
    /// Refine the mesh of the @p state; the @p duals, solutions of transposed
    /// problems on that mesh, are transferred with it.
    RefinedState(const Parameters::All      &parameters,
                 const ContactModel<2>      &coarse,
                 const IncrementState<2>    &state,
                 const ContactLinearization &linearization,
                 std::vector<GhostedVector> &duals);

    ContactModel<2>   model;
    IncrementState<2> state;

  private:
    using SurfaceStates = std::vector<std::vector<SurfaceState<2>>>;

    void make_interface(const Parameters::All &parameters);
    void transfer_contact(const ContactInterface<2>  &coarse,
                          const GhostedVector        &coarse_solution,
                          const SurfaceStates        &duals_on_surfaces,
                          std::vector<GhostedVector> &duals);
    void update_statuses();
    void set_multipliers(const ContactPoint<2> &point,
                         const double           value,
                         GhostedVector         &vector) const;

    const ContactLinearization linearization;
  };
} // namespace Contact

#endif
