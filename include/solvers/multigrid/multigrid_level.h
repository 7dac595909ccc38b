/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_multigrid_level_h
#define contact_multigrid_level_h

#include <deal.II/lac/precondition.h>

#include "solid/elasticity.h"
#include "solvers/multigrid/body_operator.h"
#include "solvers/multigrid/surface_lines.h"
#include "solvers/multigrid/surface_projection.h"
#include "solvers/multigrid/surface_springs.h"

namespace Contact
{
  using namespace dealii;

  /**
   * A level of ContactMultigrid: a mesh with the tangent of the bodies, the
   * lines of contact, and Chebyshev's iteration as smoother, of which all
   * iterates fulfil the lines. Right-hand sides and residuals are projected,
   * see SurfaceProjection. In single precision.
   */
  template<int dim>
  class MultigridLevel : public Subscriptor
  {
  public:
    using Dof    = types::global_dof_index;
    using Dofs   = std::vector<Dof>;
    using Number = float;
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    /// Of the bodies on a coarser mesh, with the elements of the @p finest one,
    /// or on that.
    MultigridLevel(
      const Triangulation<dim>                        &mesh,
      const Discretization<dim>                       &finest,
      const std::map<types::material_id, ElasticBody> &elastic_bodies);

    /// Support the unknowns @p fixed, of which each rank gives its own.
    /// Collective.
    void make_operator(const Dofs &fixed);

    /// Linearise bodies of large displacement in the present solution.
    void linearize();

    /// Take over the elimination of the active points, @p new_lines in
    /// ascending order on all ranks. Returns whether they are others than
    /// before, or the operator is. Collective.
    bool set_lines(SurfaceRows new_lines);

    /// Take over springs between the surfaces, of which each rank gives its
    /// own, before the lines. Collective.
    void set_springs(const std::vector<SurfaceSpring> &new_springs);

    /// Those of this rank.
    const std::vector<SurfaceSpring> &own_springs() const
    {
      return springs.list();
    }

    /// P^T (K + W), W the springs; of displacements that fulfil the lines
    /// P^T (K + W) P.
    void vmult(Vector &dst, const Vector &src) const;

    /// The unknowns, for PreconditionChebyshev.
    Dof m() const
    {
      return dof_handler.n_dofs();
    }
    Number el(const Dof, const Dof) const;

    /// Smooth from zero, and from the present solution.
    void smooth_from_zero() const
    {
      smoother.vmult(solution, rhs);
    }
    void smooth() const
    {
      smoother.step(solution, rhs);
    }

    /// Hanging nodes, supports and bound centres.
    const AffineConstraints<Number> &supports() const
    {
      return constraints;
    }

    /// Of serendipity elements, on all ranks. Collective.
    SurfaceRows bound_centres() const;

    /// The lines as they were given, and those whose eliminated unknown is of
    /// this rank.
    const SurfaceRows &all_lines() const
    {
      return lines_of_all;
    }
    SurfaceRows own_lines() const
    {
      return lines_of_all.owned_by(dof_handler.locally_owned_dofs());
    }

    const SurfaceLines<Number> &contact_lines() const
    {
      return lines;
    }

    const Vector &inverse_diagonal() const
    {
      return inverse->get_vector();
    }

    const SurfaceProjection<Number> &contact_projection() const
    {
      return projection;
    }

  private:
    DoFHandler<dim> own_dof_handler; // of coarser meshes

  public:
    const DoFHandler<dim> &dof_handler;
    const Mapping<dim>    &mapping;
    const Quadrature<dim> &quadrature;
    mutable Vector         rhs, solution, residual;

  private:
    void make_smoother();
    void invert_diagonal();
    Dofs on_ghosts(const Dofs &own) const;

    const Discretization<dim>                       &finest;
    const MPI_Comm                                   communicator;
    const std::map<types::material_id, ElasticBody> &elastic_bodies;
    AffineConstraints<Number>                        constraints;
    std::unique_ptr<CentreBinding<dim, Number>>      centres;
    std::unique_ptr<BodyOperator<dim, Number>>       bodies;
    Vector                                           diagonal;
    double largest_eigenvalue = 1; // of the bodies by their diagonal
    std::shared_ptr<DiagonalMatrix<Vector>> inverse; // with the springs
    SurfaceSprings<Number>                  springs;
    SurfaceRows                             lines_of_all;
    bool                                    has_lines = false;
    SurfaceLines<Number>                    lines;
    SurfaceProjection<Number>               projection;
    PreconditionChebyshev<MultigridLevel, Vector, DiagonalMatrix<Vector>>
      smoother;
  };
} // namespace Contact

#endif
