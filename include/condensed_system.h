/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_condensed_system_h
#define contact_condensed_system_h

#include <deal.II/base/timer.h>

#include <set>

#include "contact_interface.h"
#include "definite_solver.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The linear system of a Newton step without multipliers, for rules whose
   * points belong to one slave node each (nodal, mortar).
   *
   * An active point says where the slave node goes when the master nodes go
   * somewhere; with the coefficients C_a of the point, C_0 that of its own
   * node, gap g and slip s,
   *   C_0 n . du_0 = -g - sum_(a>0) C_a n . du_a,
   *   C_0 t . du_0 = -s - sum_(a>0) C_a t . du_a      if it sticks.
   * A sticking node is eliminated, of a slipping one the component along n,
   * through the coordinate in which n is larger. What is left is symmetric
   * positive definite, with friction as well: where it slips, the shear is a
   * load (a step of Tresca's problem). The multipliers follow from the forces
   * of the bodies on the slave node,
   *   w C_0 (p n + q t) = forces.
   * This is the way of step-42, with any normal and a deformable master.
   *
   * Only cells at the slave nodes see the active set. All others are assembled
   * once if the bodies are linear, and a change of the active set costs the
   * cells at the interface (and what the solver makes of it).
   */
  class CondensedSystem
  {
  public:
    /// @p interface may be null. Phases are measured by @p timer.
    CondensedSystem(const Discretization   &discretization,
                    const Elasticity       &elasticity,
                    const ContactInterface *interface,
                    const std::string      &solver_name,
                    TimerOutput            &timer);

    /// Follow the pairing of the points; the pattern is made anew only if it
    /// has to be.
    void update_pattern();

    /**
     * Set the multipliers in @p solution from @p residual, minus the residual
     * of the bodies alone, under the decisions and bounds the points have now.
     */
    void recover_pressures(const Vector<double> &residual,
                           Vector<double>       &solution) const;
    void recover_shears(const Vector<double> &residual,
                        Vector<double>       &solution) const;

    /**
     * The Newton update under the present decisions, from minus the residual
     * of bodies and contact. @p tolerance is that of the linear residual [N per
     * mm of thickness]. Returns the number of linear iterations.
     */
    unsigned int solve(const Vector<double> &solution,
                       const Vector<double> &u_start,
                       const Vector<double> &residual,
                       const double          tolerance,
                       Vector<double>       &update);

  private:
    using Dofs = std::vector<types::global_dof_index>;

    std::vector<Tensor<1, 2>> tractions(const Vector<double> &residual) const;

    /// u_dof = constant + sum of entries.
    struct Line
    {
      std::map<types::global_dof_index, double> entries;
      double                                    constant = 0;
    };

    void eliminate(const types::global_dof_index dof, Line line);
    void collect_interface();
    void make_pattern();
    bool pattern_serves() const;
    Dofs reachable_master_dofs(const ContactPoint &point) const;
    void make_lines(const Vector<double> &solution,
                    const Vector<double> &u_start);
    void add_base_line(const types::global_dof_index dof);
    void add_normal_line(const ContactPoint &point, const double gap);
    void add_stick_lines(const ContactPoint &point,
                         const double        gap,
                         const double        slip);
    std::vector<double> signature_of_lines() const;

    /// Returns whether the matrix is another one than before.
    bool assemble(const Vector<double> &solution, Vector<double> &rhs);
    void assemble_bulk(const Vector<double> &solution);
    void restore_interface_rows();
    void for_interface_rows(
      const std::function<void(const int n, double *values)> &visit);
    void condense(Vector<double> &rhs) const;

    DefiniteSolver::Modes rigid_modes() const;

    const Discretization   &discretization;
    const Elasticity       &elasticity;
    const ContactInterface *interface;
    TimerOutput            &timer;
    const IndexSet          owned;

    /// The cells that see the active set, and all unknowns they couple with it.
    std::vector<unsigned int>         interface_cells, bulk_cells;
    std::set<types::global_dof_index> slave_dofs;

    /// Of each point, the unknowns of the master that the pattern provides for.
    std::vector<Dofs> provided;
    Dofs              interface_dofs;

    std::multimap<types::global_dof_index, unsigned int> edges_at_master;

    /// The supports and ties of the unknowns above, and the active points.
    AffineConstraints<double>               lines;
    std::vector<types::global_dof_index>    eliminated;
    std::map<types::global_dof_index, Line> contact_lines;
    std::multimap<types::global_dof_index, types::global_dof_index>
      users_of_slave_dofs;

    DefiniteSolver::Matrix           matrix;
    std::vector<double>              assembled_lines; // see signature_of_lines
    std::vector<std::vector<double>> kept_rows; // by owned interface unknown
    bool                             bulk_is_assembled = false;
    Change                           change            = Change::pattern;

    std::unique_ptr<DefiniteSolver> solver;
  };
} // namespace Contact

#endif
