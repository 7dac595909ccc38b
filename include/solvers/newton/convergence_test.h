/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_convergence_test_h
#define contact_convergence_test_h

#include <optional>
#include <vector>

#include "contact/interface/contact_interface.h"
#include "model/increment_state.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Whether Newton's method has converged: the norm of the residual, forces
   * and constraints together, is at most the tolerance times a force F
   * [N per mm of thickness; rings: N].
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
  class ConvergenceTest
  {
  public:
    explicit ConvergenceTest(const ContactModel<dim> &model)
      : model(model)
    {
    }

    /// On a new mesh, with points that are paired in the undeformed state. The
    /// tolerance is that of this mesh. Collective.
    void begin_level(const double tolerance);

    /// Compare the residual @p rhs of a state. Returns its norm [N per mm of
    /// thickness], the same on all ranks: it decides for all of them what comes
    /// next.
    double evaluate(const GhostedVector &rhs, const IncrementState<dim> &state);

    /// The norm of a residual [N per mm of thickness]. Collective.
    double norm_of(const GhostedVector &rhs) const;

    /// The norm and the force F of the last evaluation, and the norm by F.
    double residual() const
    {
      return norm / force;
    }

    double residual_norm() const
    {
      return norm;
    }

    double force_scale() const
    {
      return force;
    }

    /// The largest force that the data alone tell of, with that of the softest
    /// body when it gives way by the ways that they prescribe, under a load
    /// factor: no state can inflate it. Zero where no way is; not of overlaps.
    /// Collective.
    double given_force(const double load_factor) const;

    double tolerance() const
    {
      return newton_tolerance;
    }

    /// D [mm].
    double size_of_bodies() const
    {
      return size;
    }

    bool has_converged() const
    {
      return residual() <= newton_tolerance;
    }

    /// The last evaluation was at the end of an increment.
    void accept()
    {
      so_far = std::max(so_far, force);
    }

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &so_far;
    }

  private:
    void measure_bodies();
    /// F in a state. Collective.
    double scale(const IncrementState<dim> &state) const;
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

    const ContactModel<dim> &model;
    double                   newton_tolerance = 0;
    double                   norm             = 0; // [N per mm of thickness]
    double                   force            = 0; // likewise

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
