/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_force_scale_h
#define contact_force_scale_h

#include <optional>
#include <vector>

#include "contact/interface/contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The force F that residuals are compared with [N per mm of thickness; rings:
   * N]: a state is accepted if the norm of its residual is at most the Newton
   * tolerance times F.
   *
   * F is the largest of
   *  - the dead loads, the sum of the magnitudes that they have in the state,
   *    and the forces of free motions, also at the ends of earlier increments;
   *  - the forces that act in the state: of contact, and of supports that move
   *    (the sum of their magnitudes), also at the ends of earlier increments;
   *  - the force that round-off alone makes, divided by the Newton tolerance:
   *      eps M (X + d) sqrt(N),
   *    M the largest P-wave modulus, X the largest coordinate, d the way that
   *    the data prescribe, N the number of unknowns. This is what is left of F
   *    in a scene in which no force acts.
   *
   * A state must not make its own residual small. The forces that act count up
   * to what the data can cause only,
   *    M (d + o) D / h,
   * d with the given motions of obstacles, o being the overlap of the
   * undeformed surfaces and the interferences, D the size of the bodies and h
   * that of the smallest cell; and no term grows with the displacements of the
   * state. All but the dead loads is times the largest circumference of rings,
   * in 3-D times D.
   */
  template<int dim>
  class ForceScale
  {
  public:
    /// @p interface may be null; its points have to be paired in the
    /// undeformed state. Collective.
    ForceScale(const Discretization<dim>   &discretization,
               const Elasticity<dim>       &elasticity,
               const ContactInterface<dim> *interface);

    /// F in the state @p solution under @p load_factor. Collective.
    double in(const GhostedVector &solution,
              const GhostedVector &u_start,
              const double         load_factor,
              const double         newton_tolerance) const;

    /// The largest force that the data alone tell of, with that of the softest
    /// body when it gives way by the ways that they prescribe, under a load
    /// factor: no state can inflate it. Zero where no way is; not of overlaps.
    double given(const double load_factor) const;

    /// The state of which this was the scale is the end of an increment.
    void accept(const double scale)
    {
      so_far = std::max(so_far, scale);
    }

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &so_far;
    }

  private:
    /// By how much obstacles that are moved, and interferences, displace the
    /// bodies [mm].
    double way_of_contact() const;
    /// The sum of the magnitudes of loads, thermal forces, and those of free
    /// motions.
    double dead_forces(const double load_factor) const;
    double contact_forces(const GhostedVector &solution,
                          const GhostedVector &u_start) const;
    double reactions(const GhostedVector &solution,
                     const double         load_factor) const;
    bool   is_supported(const types::global_dof_index dof) const;
    const std::vector<unsigned int> &cells_at_supports() const;

    const Discretization<dim>   &discretization;
    const Elasticity<dim>       &elasticity;
    const ContactInterface<dim> *interface;

    Point<dim> middle;         // of the bodies
    double     size       = 0; // D [mm]
    double     modulus    = 0; // M, of rings times the circumference, in 3-D D
    double     softest    = 0; // the least Young's modulus, times the same
    double     coordinate = 0; // X [mm]
    double     overlap    = 0; // o [mm]
    double     slender    = 1; // D / h
    double     so_far     = 0; // at the ends of earlier increments

    /// When they are first needed.
    mutable std::optional<std::vector<unsigned int>> supported_cells;
  };
} // namespace Contact

#endif
