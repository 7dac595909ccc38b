/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_multigrid_h
#define contact_contact_multigrid_h

#include "contact/interface/contact_interface.h"
#include "solvers/direct/factorizations.h"
#include "solvers/multigrid/level_transfer.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Geometric multigrid for C^T K C: K the tangent of the bodies, C the
   * elimination of the active points. All levels know the contact (see
   * LevelTransfer): what a coarse mesh corrects does not part the bodies, and a
   * body that contact alone holds is held on all levels. The idea is that of
   * monotone multigrid methods (R. Kornhuber, R. Krause, Comput. Visual. Sci.
   * 4, 2001; C. Graeser, R. Kornhuber, J. Comput. Math. 27, 2009), applied to
   * the linear problem of an active set.
   *
   * Vectors of levels have values in all unknowns, and fulfil the lines: see
   * SurfaceProjection. Those outside have zero in the eliminated ones.
   *
   * Levels are the LevelMeshes. On the coarsest one every rank solves by
   * itself, by CHOLMOD.
   */
  template<int dim>
  class ContactMultigrid
  {
  public:
    using Dof  = types::global_dof_index;
    using Dofs = std::vector<Dof>;
    using Fine = LinearAlgebra::distributed::Vector<double>;

    /// @p interface may be null. Collective, as all functions.
    ContactMultigrid(
      const Discretization<dim>                       &discretization,
      const std::map<types::material_id, ElasticBody> &elastic_bodies,
      const ContactInterface<dim>                     *interface);

    /// Linearise bodies of large displacement in @p solution. The lines have to
    /// be set anew.
    void linearize(const Fine &solution);

    /// Take over the elimination of the active points: of @p eliminated in the
    /// closed @p constraints of the displacements and in those of the virtual
    /// ones, which may be the same. Of all these the lines are read whose
    /// eliminated unknown is this rank's; it need not give others. And of the
    /// @p springs between the surfaces, of which each rank gives its own.
    void set_lines(const Dofs                       &eliminated,
                   const AffineConstraints<double>  &constraints,
                   const AffineConstraints<double>  &test_constraints,
                   const std::vector<SurfaceSpring> &springs);

    /// One V-cycle.
    void vmult(Fine &dst, const Fine &src) const;

  private:
    SurfaceCells<dim> cells_of(const ContactInterface<dim> *interface) const;
    void              make_levels(const SurfaceCells<dim> &of_finest);
    void              collect_coarse_cells();
    void              make_coarse_matrix();

    /// Know the unknowns that springs couple on the coarsest mesh. Returns
    /// whether there are couplings that were not known yet. Collective.
    bool                      add_couplings(const SurfaceRows &springs);
    AffineConstraints<double> coarse_constraints() const;
    void                      cycle(const unsigned int l) const;
    void                      solve_coarse() const;

    const Discretization<dim>                        &discretization;
    const typename LevelMeshes<dim>::List             meshes;
    const std::map<types::material_id, ElasticBody>   elastic_bodies;
    std::vector<std::unique_ptr<MultigridLevel<dim>>> levels;
    std::vector<std::unique_ptr<LevelTransfer<dim>>>  transfers; // l: to l + 1

    /// Whether all levels have lines for their present operators.
    bool is_complete = false;

    // Of the coarsest mesh, on all ranks.
    Dofs        coarse_supports;
    SurfaceRows coarse_centres; // that are bound
    Dofs        coarse_cells;   // the unknowns of one behind those of the other

    /// Of virtual displacements on the finest level, if they have other lines.
    SurfaceProjection<typename MultigridLevel<dim>::Number> test_projection;

    AffineConstraints<double>                  no_constraints;
    CentreBinding<dim, double>                 no_binding{no_constraints};
    std::unique_ptr<BodyOperator<dim, double>> coarse_bodies;
    SurfaceRows                                coarse_lines; // in the matrix
    std::set<Dofs>                 coarse_couplings; // of springs, in it
    TrilinosWrappers::SparseMatrix coarse_matrix;
    std::unique_ptr<Factorization> coarse_solver;
  };
} // namespace Contact

#endif
