/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_saddle_point_system_h
#define contact_saddle_point_system_h

#include <deal.II/base/timer.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>

#include "solvers/direct/linear_solver.h"
#include "solvers/newton/linear_system.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The linear system of a Newton step in displacements and multipliers, a
   * saddle point: every contact discretization can have it, on one process. It
   * is solved directly, and as a factorization is what costs, it is kept while
   * it serves. But for the unknowns of contact, its matrix is that of the
   * bodies, and symmetric, see DirectSolver. See CondensedSystem for the other
   * form.
   */
  class SaddlePointSystem : public LinearSystem<2>
  {
  public:
    /// @p geometry_follows: points are paired with bodies that have moved. @p
    /// keeps_factorization: one may serve for steps that reduce the residual
    /// well. @p linearization may change from step to step. Phases are measured
    /// by @p timer. @p by_umfpack: it alone factorizes, whatever the size.
    /// Steps of Newton's method are told on the @p screen.
    SaddlePointSystem(const ContactModel<2>      &model,
                      const ContactLinearization &linearization,
                      const bool                  geometry_follows,
                      const bool                  keeps_factorization,
                      TimerOutput                &timer,
                      const bool                  by_umfpack = false,
                      ConditionalOStream         *screen     = nullptr);

    std::string name() const override
    {
      return "saddle point, " + solver.name();
    }

    bool has_multipliers() const override
    {
      return true;
    }

    void begin_newton() override
    {
      searches = true;
    }

    bool statuses_settle() const override
    {
      return searches;
    }

    unsigned int make_step(const Step        &step,
                           GhostedVector     &rhs,
                           IncrementState<2> &state) override;

    /// The tangent of the state itself is looked at, and made if need be. Under
    /// friction its part that is not symmetric decides as well.
    bool tangent_is_indefinite(const IncrementState<2> &state,
                               const bool               may_cost) override;

    std::string open_stability() const override
    {
      return was_indefinite ? friction_leaves_stability_open : "";
    }

    /// When a point faces another edge than before, the matrix couples other
    /// unknowns than before: a new pattern, and a new analysis in the solver.
    void update_pattern(const bool pairing_has_changed) override;

    void clear_pattern() override;

    /**
     * The Newton update under the present statuses, from minus the residual
     * of bodies and contact. The factorization at hand may serve if the last
     * one reduced the residual well: @p residual, @p last_residual [-]. With
     * @p searches the active set is searched in the linearised problem; returns
     * whether that, if any, has come to an end.
     *
     * In large displacements and with geometry in the tangent the linearised
     * problem need not be that of a body at rest on springs: gaps close along
     * other directions than pressures act in, and stresses that turn with the
     * body may let it yield to its loads. If little holds the body, there may
     * be no active set at all, or one that is far away. So where stabilization
     * is at work, and where the search does not settle, projections, normals
     * and stresses stand still for the search: then it always has a solution
     * if something holds each body, see ContactComplementarity.
     */
    bool solve(const GhostedVector &solution,
               const GhostedVector &u_start,
               const double         load_factor,
               const double         residual,
               const double         last_residual,
               const bool           searches,
               GhostedVector       &rhs_and_update);

    /// Assemble and factorize the tangent in a state, under the present
    /// statuses.
    void factorize(const GhostedVector &solution,
                   const GhostedVector &u_start,
                   const double         load_factor);

    /// Whether the factorization at hand is that of the tangent in a state with
    /// its statuses, as good as is_nearby() tells.
    bool has_tangent_of(const IncrementState<2> &state) const;

    /// Replace the functional @p b of all unknowns by the solution of the
    /// transposed system, which meets homogeneous constraints.
    void solve_transposed(GhostedVector &b) const;

  private:
    /// Whether there is a motion that keeps all gaps, and the places of the
    /// points that stick, to which the tangent in a state is no resistance.
    /// Where points follow the bodies, geometry is in that tangent, whatever is
    /// in that of Newton's method.
    bool is_indefinite(const GhostedVector &solution,
                       const GhostedVector &u_start,
                       const double         load_factor);

    void note_unknowns_of_contact();
    bool factorization_serves(const double residual,
                              const double last_residual) const;
    void assemble_and_factorize(const GhostedVector        &solution,
                                const GhostedVector        &u_start,
                                const double                load_factor,
                                const ContactLinearization &linearization,
                                const StressStiffness       stress_stiffness,
                                GhostedVector              &rhs);
    void solve_factorized(GhostedVector &rhs_and_update);
    bool has_frozen_geometry() const;
    bool search_with_frozen_geometry(const GhostedVector &solution,
                                     const GhostedVector &u_start,
                                     const double         load_factor,
                                     GhostedVector       &rhs_and_update);
    void add_tangent_of_linear_bodies(const GhostedVector &solution);

    const ContactModel<2>      &model;
    const Discretization<2>    &discretization;
    const Elasticity<2>        &elasticity;
    ContactInterface<2>        *interface; // may be null
    const ContactLinearization &linearization;
    const bool                  geometry_follows;
    const bool                  keeps_factorization;
    const bool                  by_umfpack;
    TimerOutput                &timer;
    ConditionalOStream         *screen;

    bool searches       = true;
    bool was_indefinite = false; // the tangent that was looked at last

    SparsityPattern      pattern;
    SparseMatrix<double> matrix;
    DirectSolver         solver;
    std::vector<bool>    of_contact; // by unknown

    // The tangent of linear bodies without contact, and of which version.
    SparsityPattern      bodies_pattern;
    SparseMatrix<double> bodies_tangent;
    unsigned int         bodies_version = 0;

    // The state that the matrix was factorized in.
    GhostedVector            factorized_at;
    std::vector<signed char> factorized_contact;
    bool                     stresses_turn      = false; // in the matrix
    unsigned int             factorized_version = 0;
    unsigned int             pattern_version    = 0; // of constraints
  };
} // namespace Contact

#endif
