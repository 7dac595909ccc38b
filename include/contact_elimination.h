/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_elimination_h
#define contact_contact_elimination_h

#include <functional>
#include <set>

#include "contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The active points as constraints on the displacements, for rules whose
   * points belong to one slave node each (nodal, mortar).
   *
   * An active point says where the slave node goes when the master nodes go
   * somewhere; with the coefficients C_a of the point, C_0 that of its own
   * node, gap g and slip s,
   *   C_0 n . du_0 = -g - sum_(a>0) C_a n . du_a,
   *   C_0 t . du_0 = -s - sum_(a>0) C_a t . du_a      if it sticks.
   * A sticking node is eliminated, of a slipping one the component along n,
   * through the coordinate in which n is larger. The multipliers follow from
   * the forces of the bodies on the slave nodes k,
   *   sum over the points of w C_k (p n + q t) = forces on k.
   * This is the way of step-42, with any normal and a deformable master.
   */
  class ContactElimination
  {
  public:
    using Dofs = std::vector<types::global_dof_index>;

    /// @p interface may be null: then there is nothing to eliminate.
    ContactElimination(const Discretization   &discretization,
                       const ContactInterface *interface);

    /// The unknowns of the slave nodes of all points.
    std::set<types::global_dof_index> slave_dofs;

    /// Make the constraints of the present decisions, together with those that
    /// Discretization puts on the unknowns @p surroundings.
    void make(const Vector<double> &solution,
              const Vector<double> &u_start,
              const Dofs           &surroundings);

    const AffineConstraints<double> &constraints() const
    {
      return lines;
    }

    /// Call @p visit with each eliminated unknown and each one that moves it.
    void for_each_entry(
      const std::function<void(const types::global_dof_index line,
                               const types::global_dof_index dof)> &visit)
      const;

    /// All that the eliminated matrix depends on, as numbers.
    std::vector<double> signature() const;

    /// The transpose of the elimination: the force on an eliminated unknown
    /// goes to those that move it.
    void condense(Vector<double> &rhs) const;

    /// Complete an update whose free unknowns are known.
    void distribute(Vector<double> &update) const;

    /**
     * Set the multipliers in @p solution from @p residual, minus the residual
     * of the bodies alone, under the decisions and bounds the points have now.
     */
    void recover_pressures(const Vector<double> &residual,
                           Vector<double>       &solution) const;
    void recover_shears(const Vector<double> &residual,
                        Vector<double>       &solution) const;

  private:
    /// No surface of a zone may share a node with the slave of another one.
    void check_zones() const;

    /// u_dof = constant + sum of entries.
    struct Line
    {
      std::map<types::global_dof_index, double> entries;
      double                                    constant = 0;
    };

    void add_base_line(const types::global_dof_index dof);
    void add_normal_line(const ContactPoint &point, const double gap);
    void add_stick_lines(const ContactPoint &point,
                         const double        gap,
                         const double        slip);
    void eliminate(const types::global_dof_index dof, Line line);

    std::vector<Tensor<1, 2>> tractions(const Vector<double> &residual) const;

    const Discretization   &discretization;
    const ContactInterface *interface;

    AffineConstraints<double>               lines;
    Dofs                                    eliminated;
    std::map<types::global_dof_index, Line> contact_lines;

    /// Slave unknowns that are in the lines of others.
    std::map<types::global_dof_index, std::set<types::global_dof_index>>
      users_of_slave_dofs;
  };
} // namespace Contact

#endif
