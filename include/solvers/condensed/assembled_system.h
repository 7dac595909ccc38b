/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_assembled_system_h
#define contact_assembled_system_h

#include <map>
#include <optional>

#include "solid/elasticity.h"
#include "solvers/condensed/condensed_system.h"
#include "solvers/condensed/degree_transfer.h"
#include "solvers/condensed/interface_couplings.h"
#include "solvers/direct/definite_solver.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The condensed system as a sparse matrix. The tangents of cells that see the
   * active set are added to the matrix of all others. Linear bodies have them
   * all once on a mesh, and a change of the active set costs the sum over the
   * cells at the interface (and what the solver makes of it). Where bodies
   * yield in small strain, only cells that yield, or did in the last step, are
   * assembled anew.
   */
  template<int dim>
  class AssembledSystem : public CondensedSystem<dim>
  {
  public:
    AssembledSystem(const Discretization<dim>   &discretization,
                    const Elasticity<dim>       &elasticity,
                    const ContactInterface<dim> *interface,
                    ContactElimination<dim>     &elimination,
                    const Parameters::SolverKind solver_kind,
                    TimerOutput                 &timer);

    bool is_indefinite(const bool may_cost) override
    {
      std::optional<TimerOutput::Scope> scope;
      if (may_cost && solver_kind == Parameters::SolverKind::amg)
        scope.emplace(timer, "stability");
      return is_set && solver->is_indefinite(may_cost);
    }

    bool knows_definiteness() const override
    {
      return !is_set || solver->knows_definiteness();
    }

    /// The matrix of the last solve.
    const DefiniteSolver::Matrix &system_matrix() const
    {
      return matrix;
    }

  private:
    using Base = CondensedSystem<dim>;
    using Dofs = typename Base::Dofs;
    using Base::bulk_cells;
    using Base::discretization;
    using Base::elasticity;
    using Base::elimination;
    using Base::interface_cells;
    using Base::interface_dofs;
    using Base::interface_tangents;
    using Base::on_any_rank;
    using Base::owned;
    using Base::tangent_version;
    using Base::tangents_are_known;
    using Base::timer;

    bool         has_room_for_points() const override;
    void         make_room() override;
    bool         make_room_for_lines() override;
    bool         needs_all_tangents() const override;
    bool         any_rank_may_add() const override;
    Dofs         all_of_interface(Dofs &&of_cells) const override;
    void         reset() override;
    void         assemble_bulk(const GhostedVector  &solution,
                               const StressStiffness stress_stiffness) override;
    void         add_interface(const bool bulk_is_new) override;
    void         prepare() override;
    unsigned int solve_reduced(const GhostedVector &rhs,
                               const double         tolerance,
                               GhostedVector       &x) override;

    void add_interface(const AffineConstraints<double> &test_constraints,
                       const std::vector<PairingStiffness<dim>> &pairing_terms,
                       DefiniteSolver::Matrix                   &matrix) const;
    DefiniteSolver::CoarseSpace coarse_space();

    void reset_matrix(const DynamicSparsityPattern &pattern);
    void add_interface_couplings(DynamicSparsityPattern &pattern) const;
    void assemble_all(const GhostedVector  &solution,
                      const StressStiffness stress_stiffness);
    bool change_bulk(const GhostedVector &solution);
    std::map<unsigned int, FullMatrix<double>>
         yielding_changes(const std::vector<unsigned int> &cells,
                          const GhostedVector             &solution) const;
    void set_bound_centres();
    void keep_interface_rows();
    void restore_interface_rows();
    void for_interface_rows(
      const std::function<void(const int n, double *values)> &visit);

    InterfaceCouplings<dim> couplings; // that the matrix has room for
    DefiniteSolver::Matrix  matrix;

    /// That of Tresca's problem, whose bounds of friction stay, where the other
    /// is not symmetric.
    DefiniteSolver::Matrix           tresca_matrix;
    std::vector<std::vector<double>> kept_rows; // by owned interface unknown

    /// By bulk cell what yielding has changed in its tangent in the matrix.
    std::map<unsigned int, FullMatrix<double>> changes;

    const Parameters::SolverKind         solver_kind;
    std::unique_ptr<DegreeTransfer<dim>> transfer; // of AMG at degree 2
    std::unique_ptr<DefiniteSolver>      solver;   // when it is first needed

    /// Whether it has the matrix, and that a pattern that it does not know.
    bool is_set = false, pattern_is_new = true;
  };
} // namespace Contact

#endif
