/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_condensed_system_h
#define contact_condensed_system_h

#include <deal.II/base/timer.h>

#include "solid/elasticity.h"
#include "solvers/condensed/contact_elimination.h"

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
   * by themselves. A system is assembled (AssembledSystem), or an operator
   * without a matrix (MatrixFreeSystem).
   */
  template<int dim>
  class CondensedSystem
  {
  public:
    /// @p interface may be null. Phases are measured by @p timer.
    static std::unique_ptr<CondensedSystem>
    create(const Discretization<dim>   &discretization,
           const Elasticity<dim>       &elasticity,
           const ContactInterface<dim> *interface,
           ContactElimination<dim>     &elimination,
           const Parameters::SolverKind solver_kind,
           TimerOutput                 &timer);

    virtual ~CondensedSystem() = default;

    /// Follow the pairing of the points; couplings are made anew only if they
    /// have to be.
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
                                const double         load_factor);

    /// See LinearSystem.
    virtual bool subtract_forces(const GhostedVector &, GhostedVector &) const
    {
      return false;
    }

    /// Whether the matrix of the last solve is known to be indefinite, and
    /// whether that would be known, see DefiniteSolver. Collective.
    virtual bool is_indefinite(const bool may_cost) = 0;
    virtual bool knows_definiteness() const         = 0;

  protected:
    using Dofs = std::vector<types::global_dof_index>;

    CondensedSystem(const Discretization<dim> &discretization,
                    const Elasticity<dim>     &elasticity,
                    ContactElimination<dim>   &elimination,
                    TimerOutput               &timer);

    /// Whether there is room for what the points of now couple, and make it.
    virtual bool has_room_for_points() const = 0;
    virtual void make_room()                 = 0;

    /// Make room for the lines of now. Returns whether it was missing.
    virtual bool make_room_for_lines() = 0;

    /// All unknowns at the interface that are needed here, those of its cells
    /// on this rank among them. Collective.
    virtual Dofs all_of_interface(Dofs &&of_cells) const = 0;

    /// The unknowns at the interface, and how they are coupled, are others.
    virtual void reset() = 0;

    /// Linearise the cells that do not see the active set in @p solution.
    virtual void assemble_bulk(const GhostedVector  &solution,
                               const StressStiffness stress_stiffness) = 0;

    /// Take over the elimination of now, the bulk, which @p is_new or that of
    /// before, and the tangents at the interface.
    virtual void add_interface(const bool bulk_is_new) = 0;

    /// Make whatever the solution needs beside.
    virtual void prepare() = 0;

    /// Solve for the owned unknowns of @p x, under a right-hand side that is
    /// zero in what is constrained or eliminated, to a residual below @p
    /// tolerance. Returns the number of iterations.
    virtual unsigned int solve_reduced(const GhostedVector &rhs,
                                       const double         tolerance,
                                       GhostedVector       &x) = 0;

    /// Whether the tangents of all cells at the interface are asked for, or
    /// those of cells alone where unknowns are eliminated or move.
    virtual bool needs_all_tangents() const = 0;

    /// Whether any rank may add what points stiffen, or the owner of the node
    /// of a point alone.
    virtual bool any_rank_may_add() const = 0;

    bool on_any_rank(const bool condition) const;

    const Discretization<dim> &discretization;
    const Elasticity<dim>     &elasticity;
    ContactElimination<dim>   &elimination;
    TimerOutput               &timer;
    const IndexSet             owned;

    /// The cells that see the active set, and the others.
    std::vector<unsigned int> interface_cells, bulk_cells;

    /// In ascending order.
    Dofs interface_dofs;

    /// By interface cell; empty where nobody has asked for it.
    std::vector<FullMatrix<double>> interface_tangents;

    bool         tangents_are_known = false;
    unsigned int tangent_version    = 0;

  private:
    void collect_interface();
    bool add_eliminable();
    void couple();
    void eliminate(const GhostedVector &solution,
                   const GhostedVector &u_start,
                   const GhostedVector &moved);

    /// Returns whether the matrix is another one than before.
    bool            assemble(const GhostedVector &solution,
                             const bool           keep_tangents,
                             GhostedVector       &rhs);
    StressStiffness stress_stiffness() const;
    void            assemble_tangents(const GhostedVector &solution);
    void            add_missing_tangents(const GhostedVector &solution);
    void            renew_interface_forces(const GhostedVector &solution);
    void            set_interface_forces(const unsigned int    k,
                                         const Vector<double> &forces,
                                         const GhostedVector  &solution);

    /// The interface cells with unknowns that are eliminated, that points in
    /// contact act on, or that move by themselves.
    std::vector<bool> cells_in_use() const;

    template<class Tangent>
    void add_moved_forces(const Tangent        &tangent,
                          const Dofs           &rows,
                          const Dofs           &columns,
                          const Vector<double> &load,
                          GhostedVector        &forces) const;

    /// The unknowns that have been eliminated or may be.
    std::set<types::global_dof_index> eliminable;

    std::vector<double>         assembled_lines;  // their signature
    std::vector<Vector<double>> interface_forces; // f(u) - K u

    bool         is_coupled      = false;
    unsigned int pattern_version = 0; // of constraints
    unsigned int thermal_version = 0;
    bool         is_prepared     = false;
  };
} // namespace Contact

#endif
