/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_matrix_free_system_h
#define contact_matrix_free_system_h

#include <optional>

#include "solvers/condensed/condensed_system.h"
#include "solvers/multigrid/contact_multigrid.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The condensed system as an operator, C^T K C: K is applied cell by cell,
   * without a matrix, C on the surfaces alone. Conjugate gradients with
   * ContactMultigrid; GMRES where friction makes the matrix unsymmetric. A
   * change of the active set changes C and nothing else.
   */
  template<int dim>
  class MatrixFreeSystem : public CondensedSystem<dim>
  {
  public:
    MatrixFreeSystem(const Discretization<dim>   &discretization,
                     const Elasticity<dim>       &elasticity,
                     const ContactInterface<dim> *interface,
                     ContactElimination<dim>     &elimination,
                     TimerOutput                 &timer);

    /// The part of a scene that it is not for, behind "of"; empty if it serves.
    /// Collective, as what follows.
    static std::string refusal(const Discretization<dim> &discretization,
                               const Elasticity<dim>     &elasticity);

    /// deal.II's transfer between levels numbers the cells of uniform
    /// refinement to the finest level: beyond the range of its indices, which
    /// adaptive meshes come to after some 12 levels, there is none.
    static bool is_too_deep(const Mesh<dim> &mesh);

    /**
     * Whether it is the best choice: the scene is one for it, and multigrid is
     * faster than CHOLMOD. From 20000 unknowns in 2-D and 5000 in 3-D
     * on it is, if the coarsest mesh has less than CHOLMOD takes a moment for.
     * In large displacement CHOLMOD is the choice as long as it is with AMG: it
     * tells of a tangent that is no longer definite before the end of a step.
     * Of several ranks each solves such a coarsest mesh by CHOLMOD, faster than
     * all together with AMG.
     */
    static bool is_preferred(const Discretization<dim> &discretization,
                             const Elasticity<dim>     &elasticity);

    /// Those of linear bodies, by the operator.
    bool subtract_forces(const GhostedVector &u,
                         GhostedVector       &rhs) const override;

    bool is_indefinite(const bool may_cost) override;
    bool knows_definiteness() const override
    {
      return elimination.is_symmetric();
    }

    using Vector = LinearAlgebra::distributed::Vector<double>;

    /// dst = C^T K C src.
    void vmult(Vector &dst, const Vector &src) const;

  private:
    using Base = CondensedSystem<dim>;
    using Dof  = types::global_dof_index;
    using Dofs = typename Base::Dofs;
    using Base::discretization;
    using Base::elasticity;
    using Base::elimination;
    using Base::owned;
    using Base::timer;

    /// By size alone.
    static bool is_worth_it(const Discretization<dim> &discretization,
                            const Elasticity<dim>     &elasticity);

    // Without a matrix there is room for whatever points see.
    bool has_room_for_points() const override
    {
      return true;
    }
    void make_room() override
    {
    }
    bool make_room_for_lines() override
    {
      return false;
    }
    // The operator has its own; these are for the forces of contact. In large
    // displacement they are those of the first solution of a step.
    bool needs_all_tangents() const override
    {
      return !elasticity.is_linear();
    }
    bool any_rank_may_add() const override
    {
      return true;
    }
    Dofs         all_of_interface(Dofs &&of_cells) const override;
    void         reset() override;
    void         assemble_bulk(const GhostedVector  &solution,
                               const StressStiffness stress_stiffness) override;
    void         add_interface(const bool bulk_is_new) override;
    void         prepare() override;
    unsigned int solve_reduced(const GhostedVector &rhs,
                               const double         tolerance,
                               GhostedVector       &x) override;

    Dofs dofs_of_terms() const;
    void add_terms(Vector &dst) const;

    std::vector<SurfaceSpring> springs() const;

    static constexpr unsigned int max_iterations = 200;

    const ContactInterface<dim>                *interface;
    std::unique_ptr<CentreBinding<dim, double>> centres;
    std::unique_ptr<BodyOperator<dim, double>>  bodies;
    std::unique_ptr<ContactMultigrid<dim>>      multigrid;
    SurfaceLines<double>                        lines, test_lines;

    /// Whether the present operator is indefinite, once somebody has asked.
    std::optional<bool> indefinite = false;

    /// Whether there are turning shears or a turning pairing.
    bool                  has_terms = false;
    SurfaceValues<double> surface, surface_forces;

    mutable Vector work;
  };
} // namespace Contact

#endif
