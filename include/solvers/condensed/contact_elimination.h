/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_elimination_h
#define contact_contact_elimination_h

#include <functional>

#include "bodies/discretized_bodies.h"
#include "contact/interface/contact_interface.h"
#include "solvers/condensed/contradiction.h"
#include "solvers/condensed/multiplier_recovery.h"
#include "solvers/condensed/pairing_stiffness.h"
#include "solvers/condensed/row_elimination.h"
#include "solvers/condensed/slip_direction_stiffness.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The active points as constraints on the displacements, for discretizations
   * whose points belong to one slave node each (nodal, mortar).
   *
   * With the coefficients C_a of a point, its gap g and slip s, the Newton
   * update du has to fulfil
   *   n . sum_a C_a du_a = -g,
   *   t . sum_a C_a du_a = -s      if it sticks
   * (there both are written by coordinates). The pivot of Gauss' elimination is
   * an unknown of the point's own slave node, that with the larger coefficient
   * after substitution of what is known. Where a support or another point has
   * taken it, another unknown of the equation serves. An equation without one
   * follows from others: it is dropped. This is the way of step-42, with any
   * normal and a deformable master.
   *
   * A slipping point whose bound moves with the pressure, q = s bound(p),
   * exerts per unit of pressure a force along m = n + s bound'(p) t (t with the
   * turn of SlipDirectionStiffness), while its constraint is along n. The
   * virtual displacements under which the pressures do no work fulfil m . sum_a
   * C_a v_a = 0 and are eliminated by the same pivots into lines of their own.
   * The matrix is unsymmetric, as that of the saddle point is, and the Newton
   * step the same.
   */
  template<int dim>
  class ContactElimination
  {
  public:
    using Dof  = types::global_dof_index;
    using Dofs = std::vector<Dof>;

    /// @p interface may be null: then there is nothing to eliminate.
    ContactElimination(const DiscretizedBodies<dim> &discretization,
                       const ContactInterface<dim>  *interface);

    /// The unknowns of the slave nodes of all points: those that are eliminated
    /// as a rule.
    std::set<Dof> slave_dofs;

    /**
     * Make the constraints of the present statuses, together with those that
     * Discretization puts on the unknowns @p surroundings; the gaps and slips
     * to be closed are those of @p moved, where free motions may be others. For
     * @p any_rank_may_add see SlipDirectionStiffness::terms().
     * Throws NotConverged where a point penetrates and supports leave none of
     * its unknowns free.
     */
    void make(const GhostedVector &solution,
              const GhostedVector &u_start,
              const Dofs          &surroundings,
              const GhostedVector &moved,
              const bool           any_rank_may_add);

    /// Of the displacements, and of the virtual ones.
    const AffineConstraints<double> &constraints() const
    {
      return lines;
    }

    const AffineConstraints<double> &test_constraints() const
    {
      return symmetric ? lines : test_lines;
    }

    /// Whether both are the same, and so the matrix symmetric.
    bool is_symmetric() const
    {
      return symmetric;
    }

    /// What the turning of the shears adds to the system, to be assembled
    /// like cells.
    const std::vector<typename SlipDirectionStiffness<dim>::Term> &
    slip_direction_terms() const
    {
      return turning;
    }

    /// The same of the turning of the pairing, in unsymmetric matrices.
    const std::vector<PairingStiffness<dim>> &pairing_terms() const
    {
      return of_pairing;
    }

    /// The unknowns of the slave nodes of points that are not open, and what is
    /// eliminated, in ascending order.
    Dofs dofs_in_contact() const;

    /// The unknowns that the points eliminate, in ascending order.
    const Dofs &eliminated_dofs() const
    {
      return eliminated;
    }

    /// Call @p visit with each eliminated unknown and each one that moves it.
    void for_each_entry(
      const std::function<void(const Dof line, const Dof dof)> &visit) const;

    /// All that the eliminated matrix depends on, as numbers.
    std::vector<double> signature() const;

    /// The transpose of the elimination: the force on an eliminated unknown
    /// goes to those that move it.
    void condense(GhostedVector &rhs) const;

    /// Complete an update whose free unknowns are known.
    void distribute(GhostedVector &update) const;

    /**
     * Set the multipliers in @p solution from @p residual, minus the residual
     * of the bodies alone, under the statuses and bounds the points have now,
     * and the lines of the last make(). See MultiplierRecovery.
     */
    void recover_multipliers(const GhostedVector &residual,
                             const GhostedVector &u_start,
                             GhostedVector       &solution) const;

    /// A description of the last equations that contradict each other, for the
    /// message of a Newton's method that does not converge. Else empty.
    std::string contradiction() const
    {
      return contradictions.message();
    }

  private:
    using Row = RowElimination::Row;

    void add_base_lines(const Dofs                &surroundings,
                        AffineConstraints<double> &to) const;
    void add_contact_lines(const RowElimination      &rows,
                           AffineConstraints<double> &to) const;
    void eliminate_point(const ContactPoint<dim>  &point,
                         const Tensor<1, dim - 1> &rotation,
                         const GhostedVector      &solution,
                         const GhostedVector      &u_start);

    /// The direction that the way of a point along @p direction changes by,
    /// with what the slip makes of it in unsymmetric matrices.
    Tensor<1, dim> with_slide(const ContactPoint<dim> &point,
                              const Tensor<1, dim>    &direction,
                              const GhostedVector     &solution,
                              const GhostedVector     &u_start) const;
    void eliminate(const ContactPoint<dim> &point, Row row, Row test_row);
    void
    drop(const ContactPoint<dim> &point, const Row &row, const bool is_held);

    /// The equation along @p direction: its part on the displacements.
    Row equation(const ContactPoint<dim> &point,
                 const Tensor<1, dim>    &direction,
                 const double             constant) const;

    Dof pivot(const ContactPoint<dim> &point,
              const Row               &row,
              const Row               &test_row,
              const double             smallest) const;

    const DiscretizedBodies<dim> &discretization;
    const ContactInterface<dim>  *interface;

    AffineConstraints<double> lines, test_lines;
    Dofs                      eliminated;
    RowElimination            rows, test_rows;
    bool                      symmetric = true;

    std::vector<typename SlipDirectionStiffness<dim>::Term> turning;
    std::vector<PairingStiffness<dim>>                      of_pairing;

    Contradiction<dim> contradictions; // of the last make()
  };
} // namespace Contact

#endif
