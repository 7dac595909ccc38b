/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_condensed_system_h
#define contact_condensed_system_h

#include <deal.II/base/timer.h>

#include <map>

#include "solvers/definite_solver.h"
#include "solvers/interface_couplings.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The linear system of a Newton step without multipliers: the active points
   * are eliminated, see ContactElimination. It is symmetric and positive
   * definite, with friction as well: where a node slips, the shear is a load (a
   * step of Tresca's problem). If its bound moves with the pressure, the matrix
   * is unsymmetric as long as a point slips, and Newton's method exact.
   *
   * Only cells at the slave nodes see the active set: their tangents are kept
   * beside the matrix of all others. Linear bodies have them all once on a
   * mesh, and a change of the active set costs the sum over the cells at the
   * interface (and what the solver makes of it). Where bodies yield in small
   * strain, only cells that yield, or did in the last step, are assembled anew.
   */
  template<int dim>
  class CondensedSystem
  {
  public:
    /// @p interface may be null. Phases are measured by @p timer.
    CondensedSystem(const Discretization<dim>   &discretization,
                    const Elasticity<dim>       &elasticity,
                    const ContactInterface<dim> *interface,
                    ContactElimination<dim>     &elimination,
                    const Parameters::SolverKind solver_kind,
                    TimerOutput                 &timer);

    /// Follow the pairing of the points; the pattern is made anew only if it
    /// has to be.
    void update_pattern();

    /**
     * The Newton update under the present statuses, from minus the residual
     * of bodies and contact. @p tolerance is that of the linear residual [N per
     * mm of thickness]; 0: six digits. With @p keep_tangents those of the
     * bodies are the last ones. @p moved, if any, is the solution with other
     * free motions: for the update after these. Returns the number of linear
     * iterations.
     */
    unsigned int solve(const GhostedVector &solution,
                       const GhostedVector &u_start,
                       const GhostedVector &residual,
                       const double         tolerance,
                       GhostedVector       &update,
                       const bool           keep_tangents = false,
                       const GhostedVector *moved         = nullptr);

    /**
     * Minus the residual of the bodies in @p solution, in the unknowns at the
     * interface and as the tangent K of the last solve has it,
     *   load - f(u) - K (solution - u),
     * where u is where K was assembled. Collective.
     */
    GhostedVector linear_forces(const GhostedVector &solution,
                                const double         load_factor) const;

    /// Whether the matrix of the last solve is known to be indefinite.
    bool is_indefinite() const
    {
      return current != nullptr && current->is_indefinite();
    }

    /// The matrix of the last solve.
    const DefiniteSolver::Matrix &system_matrix() const
    {
      return matrix;
    }

  private:
    using Dofs = std::vector<types::global_dof_index>;

    void collect_interface();
    bool add_eliminable();
    bool on_any_rank(const bool condition) const;
    void make_pattern();
    void reset_matrix(const DynamicSparsityPattern &pattern);

    /// Returns all unknowns that are coupled.
    std::set<types::global_dof_index>
    add_interface_couplings(DynamicSparsityPattern &pattern) const;

    void eliminate(const GhostedVector &solution,
                   const GhostedVector &u_start,
                   const GhostedVector &moved);

    /// Returns whether the matrix is another one than before.
    bool assemble(const GhostedVector &solution,
                  const bool           keep_tangents,
                  GhostedVector       &rhs);
    void add_interface_forces(const Dofs           &dofs,
                              const Vector<double> &forces,
                              const GhostedVector  &solution);
    void assemble_tangents(const GhostedVector &solution);
    void assemble_bulk(const GhostedVector  &solution,
                       const StressStiffness stress_stiffness);
    bool change_bulk(const GhostedVector &solution);
    std::map<unsigned int, FullMatrix<double>>
         yielding_changes(const std::vector<unsigned int> &cells,
                          const GhostedVector             &solution) const;
    void add_interface(const FullMatrix<double> &tangent,
                       const Dofs               &dofs,
                       const Vector<double>     &load,
                       const bool                with_matrix,
                       GhostedVector            &forces);
    void add_pairing(const PairingStiffness<dim> &term,
                     const bool                   with_matrix,
                     GhostedVector               &forces);
    void add_unsymmetric(const FullMatrix<double> &tangent, const Dofs &dofs);
    void give_matrix_to_solver();
    void restore_interface_rows();
    void for_interface_rows(
      const std::function<void(const int n, double *values)> &visit);

    const Discretization<dim> &discretization;
    const Elasticity<dim>     &elasticity;
    ContactElimination<dim>   &elimination;
    TimerOutput               &timer;
    const IndexSet             owned;

    /// The unknowns that have been eliminated or may be.
    std::set<types::global_dof_index> eliminable;

    /// The cells that see the active set, and the others.
    std::vector<unsigned int> interface_cells, bulk_cells;

    /// The couplings that the pattern provides for, and all unknowns at the
    /// interface.
    InterfaceCouplings<dim> couplings;
    Dofs                    interface_dofs;

    DefiniteSolver::Matrix           matrix;
    std::vector<double>              assembled_lines; // their signature
    std::vector<std::vector<double>> kept_rows; // by owned interface unknown
    std::vector<FullMatrix<double>>  interface_tangents; // by interface cell
    std::vector<Vector<double>>      interface_forces;   // f(u) - K u

    /// By bulk cell what yielding has changed in its tangent in the matrix.
    std::map<unsigned int, FullMatrix<double>> changes;

    bool         has_pattern        = false;
    unsigned int pattern_version    = 0; // of constraints
    unsigned int thermal_version    = 0;
    bool         tangents_are_known = false;
    unsigned int tangent_version    = 0;

    /// For symmetric matrices and for the others.
    struct Solver
    {
      std::unique_ptr<DefiniteSolver> solver; // when it is first needed
      bool                            pattern_is_new = true;
    };
    const Parameters::SolverKind solver_kind;
    std::array<Solver, 2>        solvers;
    DefiniteSolver              *current = nullptr; // the owner of the matrix
  };
} // namespace Contact

#endif
