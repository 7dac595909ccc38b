/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_kernel_h
#define contact_contact_kernel_h

#include "contact/interface/contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /// The terms that the kernel linearises.
  struct ContactLinearization
  {
    /// Projection, normal and tangent move with the bodies. In 2-D.
    bool moving_geometry;
  };



  /**
   * The equations of the contact points, see ContactInterface, and their
   * tangent: the only place that multiplies coefficients, normals and tractions
   * of a point with each other.
   */
  template<int dim>
  class ContactKernel
  {
  public:
    explicit ContactKernel(const ContactInterface<dim> &interface)
      : interface(interface)
    {
    }

    /// Add minus the residual to @p rhs and, unless @p matrix is null, the
    /// tangent to it; constraints eliminated.
    void assemble(const GhostedVector        &solution,
                  const GhostedVector        &u_start,
                  const ContactLinearization &linearization,
                  GhostedVector              &rhs,
                  SparseMatrix<double>       *matrix) const;

    /**
     * The rows of a point over its unknowns: derivatives of the trial values
     * p and q, and the loads on all equations that a unit of p and q exerts.
     * The equations of the whole problem are
     *   elastic(x) + sum over the points of (load_p p + load_q q) = ...,
     * where p and q depend on x through the trial values alone (and with moving
     * geometry through the turning of the loads): all that the search of the
     * active set needs.
     */
    struct Rows
    {
      std::vector<types::global_dof_index> unknowns;
      Vector<double>                       p_trial, load_p;

      /// By tangent.
      std::array<Vector<double>, dim - 1> q_trial, load_q;
    };

    void rows(const ContactPoint<dim>    &point,
              const GhostedVector        &solution,
              const GhostedVector        &u_start,
              const ContactLinearization &linearization,
              Rows                       &rows) const;

  private:
    /// The derivatives of a trial shear that springs and elastic slip make.
    void follow_springs(const ContactPoint<dim> &point,
                        const ContactState<dim> &now,
                        Rows                    &rows) const;

    /// The equations of a point over its unknowns.
    void assemble_residual(const ContactPoint<dim> &point,
                           const ContactState<dim> &now,
                           const Traction<dim>     &t,
                           const Rows              &rows,
                           Vector<double>          &residual) const;

    /// And their derivatives.
    void assemble_matrix(const ContactPoint<dim>    &point,
                         const GhostedVector        &solution,
                         const GhostedVector        &u_start,
                         const ContactLinearization &linearization,
                         const Traction<dim>        &t,
                         const Rows                 &rows,
                         const Vector<double>       &residual,
                         FullMatrix<double>         &matrix) const;

    /// Call @p visit with the row of each constraint, the number of the
    /// multiplier, the direction, and w/c.
    template<typename Visit>
    void for_constraints(const ContactPoint<dim> &point,
                         const Visit             &visit) const;

    const ContactInterface<dim> &interface;
  };
} // namespace Contact

#endif
