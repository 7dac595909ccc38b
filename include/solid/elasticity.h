/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_elasticity_h
#define contact_elasticity_h

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "solid/cell_kernel.h"
#include "solid/cell_values.h"
#include "solid/dead_loads.h"
#include "solid/materials/body_materials.h"
#include "solid/stabilization_springs.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The smallest ratio det F [-] of deformed to undeformed volume among the
   * quadrature points, the body and the centre X [mm] of the undeformed cell;
   * 1 and no body if no point is compressed. At zero or below a cell is turned
   * inside out: no solution, whatever the residual says.
   */
  template<int dim>
  struct VolumeRatio
  {
    double             value = 1;
    types::material_id body  = numbers::invalid_material_id;
    Point<dim>         X;

    /// Of a cell that has shrunk to nothing, where St. Venant and Kirchhoff's
    /// law has no stress, Newton's method leaves more than round-off.
    bool is_inside_out() const
    {
      const double nothing = 1e-6;
      return value <= nothing;
    }
  };

  /// The smallest of all ranks, on all of them. Collective.
  template<int dim>
  VolumeRatio<dim> smallest_of_all_ranks(const VolumeRatio<dim> &of_rank,
                                         const MPI_Comm          communicator);



  /**
   * The bodies: residual and consistent tangent of
   *   integral S(u) : delta E dX - dead load . delta u = 0.
   *
   * Forces are in N per mm of thickness and energies in N mm per mm; of rings,
   * whose integrals hold the circumference, in N and N mm (symmetry.h).
   *
   * Dilatation. The stresses are the derivatives of the energy
   *   integral 1/2 lambda (P tr E)^2 + mu E : E dX,
   * where P is the identity ("full") or, cell by cell, the L2 projection onto
   * the polynomials of degree k-1 in the coordinates of the reference cell
   * ("projected"), weighted with the undeformed volume and integrated with the
   * points of the cell; of rings tr E has the hoop strain in it. As nu
   * approaches 1/2, tr E has to vanish wherever P asks for it: with the
   * identity in more points than elements of degree 1 can afford, and they
   * lock. P asks for one condition in a cell of degree 1 (selective
   * integration, B-bar: T. J. R. Hughes, Int. J. Numer. Methods Eng. 15, 1980)
   * and for dim + 1 at degree 2 (Q2-P1). "automatic" projects where lambda > 10
   * mu, that is nu > 5/11.
   *
   * Triangles and tetrahedra of degree 1 have one point: P is the identity, and
   * they lock either way; nearly incompressible tetrahedra of degree 1 are
   * refused. In those of degree 2 P is the mean: three conditions would be too
   * many for the four unknowns of displacement that a triangle has (see
   * tests/locking.cc), one is stable, at the price of an order. Prefer
   * quadrangles where nu is close to 1/2.
   */
  template<int dim>
  class Elasticity : public BodyStiffness
  {
  public:
    Elasticity(const Discretization<dim> &discretization,
               const Parameters::Solids  &parameters);

    /// The forces on the bodies.
    const DeadLoads<dim> dead_loads;

    /// The forces on the bodies under a load factor: dead ones, and those on
    /// rigid boundaries.
    GhostedVector loads(const GhostedVector &u, const double load_factor) const;

    /// Add the couplings of the bodies.
    void add_couplings(DynamicSparsityPattern &pattern) const;

    /// The work on a cell, given its unknowns, its tangent (empty if there was
    /// none asked for) and its internal forces.
    using CellVisitor =
      std::function<void(const std::vector<types::global_dof_index> &dofs,
                         const FullMatrix<double>                   &tangent,
                         const Vector<double>                       &forces)>;

    /// Visit all cells of this rank, or only those with the numbers @p chosen.
    /// Returns the smallest volume ratio among them; in small strain, 1.
    VolumeRatio<dim> visit_cells(
      const GhostedVector             &u,
      const bool                       with_tangent,
      const CellVisitor               &visitor,
      const std::vector<unsigned int> *chosen = nullptr,
      const StressStiffness stress_stiffness  = StressStiffness::with) const;

    /// The number of cells of this rank, and the unknowns of one of them.
    unsigned int n_cells() const
    {
      return tables.own.size();
    }
    const std::vector<types::global_dof_index> &
    dofs_of_cell(const unsigned int number) const
    {
      return tables.own[number].dofs;
    }

    /**
     * Add minus the residual (dead forces under @p load_factor minus internal
     * forces) to @p rhs and, unless @p matrix is null, the tangent to it;
     * constraints eliminated. Of several ranks each adds its own part, and
     * returns the smallest volume ratio among its own cells.
     */
    VolumeRatio<dim> assemble(
      const GhostedVector  &u,
      const double          load_factor,
      GhostedVector        &rhs,
      SparseMatrix<double> *matrix,
      const StressStiffness stress_stiffness = StressStiffness::with) const;

    /// Add what forces on rigid boundaries do to the tangent as these turn.
    /// Collective.
    template<typename Matrix>
    void add_rigid_stiffness(const GhostedVector &u, Matrix &matrix) const
    {
      const auto &all = discretization.rigid_boundaries();
      if (std::none_of(all.begin(), all.end(), [&](const auto &boundary) {
            return discretization.turns_with_loads(boundary);
          }))
        return;
      GhostedVector boundaries(discretization.distribution);
      GhostedVector forces(discretization.distribution);
      for (const auto &boundary : all)
        for (const auto &node : boundary.nodes)
          for (const auto dof : node.dofs)
            if (boundaries.holds(dof))
              boundaries[dof] = 1;
      const std::vector<unsigned int> cells = cells_at(boundaries);
      visit_cells(
        u,
        /*with_tangent=*/false,
        [&](const std::vector<types::global_dof_index> &dofs,
            const FullMatrix<double> &,
            const Vector<double> &of_cell) {
          for (unsigned int i = 0; i < dofs.size(); ++i)
            forces[dofs[i]] += of_cell[i];
        },
        &cells);
      forces.compress_add();
      discretization.add_rigid_stiffness(u, forces, matrix);
    }

    /// The parts of the residual alone, constraints eliminated: add what the
    /// owned loads are, and subtract the internal forces of the own cells.
    void             add_loads(const GhostedVector &u,
                               const double         load_factor,
                               GhostedVector       &rhs) const;
    VolumeRatio<dim> subtract_forces(const GhostedVector &u,
                                     GhostedVector       &rhs) const;

    /**
     * The forces on all nodes, unconstrained: internal minus load. Where a
     * node is supported or in contact, the force that acts there. Those of the
     * cells with the numbers @p chosen alone are whole where all cells of a
     * node are among them, as of those that cells_at() finds.
     */
    GhostedVector
    forces(const GhostedVector             &u,
           const double                     load_factor,
           const std::vector<unsigned int> *chosen = nullptr) const;

    /// The numbers of the cells of this rank where @p v is not zero.
    std::vector<unsigned int> cells_at(const GhostedVector &v) const;

    /**
     * The energy stored in the bodies, or in one of them [N mm per mm of
     * thickness]: its derivative are the internal forces. Without that of
     * stabilization. Collective.
     */
    double
    strain_energy(const GhostedVector                    &u,
                  const std::optional<types::material_id> body = {}) const;

    /// The energies of a body, if it were elastic under its strains: that which
    /// its quadrangles or hexahedra of degree 1 would not have if they could
    /// bend, by incompatible modes, as those that bend are too stiff; and the
    /// whole. Zero of rubber, and of bodies that hardly change their volume.
    /// Collective.
    struct BendingEnergy
    {
      double missing = 0, whole = 0;
    };
    BendingEnergy bending_energy(const GhostedVector     &u,
                                 const types::material_id body) const;

    /// Add the derivative of the energy of a body, its internal forces, times
    /// @p factor. Of several ranks each adds its own part.
    void add_internal_forces(const types::material_id body,
                             const double             factor,
                             const GhostedVector     &u,
                             GhostedVector           &forces) const;

    /// Grows whenever the tangent becomes another one under the same u: with
    /// the stabilization, and see end_first_step().
    unsigned int tangent_version() const
    {
      return springs.version() + n_first_steps;
    }

    /// A body that is elastic.
    ElasticBody elastic_body(const types::material_id body) const
    {
      return {material(body),
              is_small_strain(body),
              projected.count(body) > 0,
              enhanced.count(body) > 0};
    }

    /// Cauchy stress [MPa] in all quadrature points, by active cell; nothing
    /// for the cells that this rank does not know.
    std::vector<std::vector<SymmetricTensor<2, 3>>>
    stresses(const GhostedVector &u) const;

    /// The same in those of one cell, that this rank knows.
    std::vector<SymmetricTensor<2, 3>> stresses(const unsigned int active_index,
                                                const GhostedVector &u) const;

    /// The tangent does not depend on the displacement.
    bool is_linear() const
    {
      return std::all_of(kernels.begin(),
                         kernels.end(),
                         [](const auto &kernel) {
                           return kernel.second->is_linear();
                         });
    }

    bool may_yield(const types::material_id body) const
    {
      return laws.at(body)->n_history() > 0;
    }

    /// Whether all bodies are linear elastic or St. Venant-Kirchhoff's.
    bool is_elastic() const
    {
      return std::all_of(laws.begin(), laws.end(), [](const auto &law) {
        return law.second->is_linear();
      });
    }

    /// Whether there are materials of large strain. Where they keep their
    /// volume, the pressure of one that Newton's method has still to correct
    /// makes the tangent indefinite, and so does a neck.
    bool has_large_strains() const
    {
      return std::any_of(laws.begin(), laws.end(), [&](const auto &law) {
        return !law.second->is_linear() &&
               !kernels.at(law.first)->is_small_strain();
      });
    }

    /// Whether the tangent changes in cells that yield alone, and these cells
    /// among those with the numbers @p chosen.
    bool                      changes_by_yielding() const;
    std::vector<unsigned int> yielding(const std::vector<unsigned int> &chosen,
                                       const GhostedVector &u) const;

    /// The reason for much too stiff results that meshes agree on: triangles of
    /// degree 1 lock in a body that hardly changes its volume, but in plane
    /// stress. A sentence, or nothing. Collective.
    std::string locking() const;

    bool is_small_strain(const types::material_id body) const
    {
      return kernels.at(body)->is_small_strain();
    }

    /// The cells of this rank.
    const std::vector<CellTable<dim>> &cells() const
    {
      return tables.own;
    }

    /// An increment changes the thermal strains from those at one load factor
    /// to those at another; at the start of a run there are none.
    void set_thermal_strain(const double from, const double to);

    /// In the first Newton step of an increment, from a state in which the
    /// bodies have not yet moved, tangents of large displacement are those of
    /// the thermal strains before: with the stresses of a heat that nothing has
    /// given way to, that of a nearly incompressible body would not be
    /// definite.
    void begin_first_step();
    void end_first_step()
    {
      n_first_steps += tangents_are_of_start;
      tangents_are_of_start = false;
    }

    /// Whether a body has a thermal strain that may change, and the forces that
    /// those of now exert on undeformed bodies, the sum of their magnitudes.
    bool has_thermal_strain() const
    {
      return !thermal_strains.empty();
    }
    double thermal_forces() const
    {
      return present_thermal_forces;
    }

    /// Grows whenever they change.
    unsigned int thermal_version() const
    {
      return n_heats;
    }

    /// Whether any body may yield, and the equivalent plastic strains [-] of
    /// the last increment that was accepted, as stresses() has it.
    bool has_history() const
    {
      return std::any_of(laws.begin(), laws.end(), [](const auto &law) {
        return law.second->n_history() > 0;
      });
    }
    std::vector<std::vector<double>> plastic_strains() const;

    /// An increment ends with the displacements @p u: the history of all points
    /// is that of its end. The same stresses and energies under the same @p u.
    void accept(const GhostedVector &u);

    /// The dissipation of an increment from @p u_0 to @p u_1 that has not been
    /// accepted yet, and the rest of its work, see CellKernel. Collective.
    using Works = typename CellKernel<dim>::Works;
    Works works(const GhostedVector &u_0, const GhostedVector &u_1) const;

    /// The history of the cells of this rank, or @p of_yielded_alone: at the
    /// start of a run that of the others is zero. Take over what is of the
    /// cells that this rank knows.
    CellValues history(const bool of_yielded_alone = false) const;
    void       restore(const CellValues &history);

    /// s : D^-1 : s [MPa], twice the elastic energy by volume of a stress s in
    /// a body.
    double energy_density(const types::material_id     body,
                          const SymmetricTensor<2, 3> &stress) const
    {
      return kernels.at(body)->energy_density(stress);
    }

    /// Young's modulus [MPa] of a body.
    double youngs_modulus(const types::material_id body) const override
    {
      return material(body).youngs_modulus;
    }

    /// The material of a body.
    const Material &material(const types::material_id body) const
    {
      return materials.at(body);
    }

  private:
    double cell_forces(const CellTable<dim> &cell,
                       const Vector<double> &u,
                       const StressStiffness stress_stiffness,
                       FullMatrix<double>   *tangent,
                       Vector<double>       &forces) const;

    /// Without those of the loads.
    GhostedVector
    internal_forces(const GhostedVector             &u,
                    const std::vector<unsigned int> *chosen = nullptr) const;

    /// Of all active cells.
    std::vector<CellId> cell_ids() const;

    const Discretization<dim>                   &discretization;
    const std::map<types::material_id, Material> materials;
    const std::map<types::material_id, std::unique_ptr<MaterialLaw>> laws;
    const std::set<types::material_id>                               enhanced;
    const std::map<types::material_id, std::unique_ptr<CellKernel<dim>>>
                                       kernels;
    const std::set<types::material_id> projected;

    const std::map<types::material_id, std::function<double(const Point<1> &)>>
                    thermal_strains;
    double          present_thermal_forces = 0;
    unsigned int    n_heats                = 0;
    bool            tangents_are_of_start  = false;
    unsigned int    n_first_steps          = 0;
    CellTables<dim> tables;

  public:
    /// The springs at the cells, which are part of their residual and of their
    /// tangent, whoever visits them.
    StabilizationSprings<dim> springs;

  private:
    std::vector<SymmetricTensor<2, 3>>
    stresses_in(const CellTable<dim> &cell, const GhostedVector &u) const;

    const bool is_plane_stress;
  };
} // namespace Contact

#endif
