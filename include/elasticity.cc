/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "elasticity.h"

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include "errors.h"

namespace Contact
{
  namespace
  {
    /// The bodies with one kinematics, which no quadrature loop has to ask for.
    template<class Kinematics>
    class Solid : public Elasticity
    {
    public:
      Solid(const Discretization     &discretization,
            const Parameters::Solids &parameters)
        : Elasticity(discretization, parameters)
      {
      }

      std::vector<std::vector<SymmetricTensor<2, 3>>>
      stresses(const Vector<double> &u) const override;

      bool is_linear() const override
      {
        return !Kinematics::has_geometric_stiffness;
      }

    private:
      void cell_forces(const Cell           &cell,
                       const Vector<double> &u,
                       FullMatrix<double>   *tangent,
                       Vector<double>       &forces) const override;

      Tensor<2, 2> displacement_gradient(const Cell           &cell,
                                         const unsigned int    q,
                                         const Vector<double> &u) const;

      template<bool with_tangent>
      void assemble_cell(const Cell           &cell,
                         const Vector<double> &u,
                         FullMatrix<double>   &matrix,
                         Vector<double>       &residual) const;
    };



    template<class Kinematics>
    Tensor<2, 2>
    Solid<Kinematics>::displacement_gradient(const Cell           &cell,
                                             const unsigned int    q,
                                             const Vector<double> &u) const
    {
      const unsigned int  n = cell.n_nodes();
      const Tensor<1, 2> *N = &cell.gradients[q * n];
      Tensor<2, 2>        H;
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int i = 0; i < 2; ++i)
          H[i] += u[cell.dofs[2 * a + i]] * N[a];
      return H;
    }



    // With F = (f_ij), the strains (E11, E22, 2 E12) vary with node a by
    //   B_a = [ f11 N,1            f21 N,1
    //           f12 N,2            f22 N,2
    //           f11 N,2 + f12 N,1  f21 N,2 + f22 N,1 ],
    // and the tangent of the nodes a and b is
    //   K_ab = B_a^T D B_b + (grad N_a . S grad N_b) I,
    // symmetric: the upper half is computed and mirrored.
    template<class Kinematics>
    template<bool with_tangent>
    void Solid<Kinematics>::assemble_cell(const Cell           &cell,
                                          const Vector<double> &u,
                                          FullMatrix<double>   &matrix,
                                          Vector<double>       &residual) const
    {
      using StrainRows = std::array<std::array<double, 3>, 2>;

      const unsigned int n      = cell.n_nodes();
      const double       lambda = cell.material->lambda;
      const double       mu     = cell.material->mu;

      std::array<StrainRows, 9> B;
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          const Tensor<2, 2>  H = displacement_gradient(cell, q, u);
          const Tensor<2, 2>  F = Kinematics::gradient_of_motion(H);
          const auto          S = cell.material->stress(Kinematics::strain(H));
          const Tensor<1, 2> *N = &cell.gradients[q * n];
          const double        JxW = cell.JxW[q];

          for (unsigned int a = 0; a < n; ++a)
            for (unsigned int i = 0; i < 2; ++i)
              {
                B[a][i] = {{F[i][0] * N[a][0],
                            F[i][1] * N[a][1],
                            F[i][0] * N[a][1] + F[i][1] * N[a][0]}};
                residual[2 * a + i] +=
                  JxW * (B[a][i][0] * S[0][0] + B[a][i][1] * S[1][1] +
                         B[a][i][2] * S[0][1]);
              }

          if constexpr (with_tangent)
            for (unsigned int a = 0; a < n; ++a)
              {
                StrainRows DB;
                for (unsigned int i = 0; i < 2; ++i)
                  {
                    const double tr = lambda * (B[a][i][0] + B[a][i][1]);
                    DB[i]           = {{JxW * (tr + 2 * mu * B[a][i][0]),
                                        JxW * (tr + 2 * mu * B[a][i][1]),
                                        JxW * mu * B[a][i][2]}};
                  }
                const Tensor<1, 2> SN = JxW * (S * N[a]);
                for (unsigned int b = a; b < n; ++b)
                  {
                    for (unsigned int i = 0; i < 2; ++i)
                      for (unsigned int j = 0; j < 2; ++j)
                        matrix(2 * a + i, 2 * b + j) += DB[i][0] * B[b][j][0] +
                                                        DB[i][1] * B[b][j][1] +
                                                        DB[i][2] * B[b][j][2];
                    if constexpr (Kinematics::has_geometric_stiffness)
                      {
                        const double geometric = SN * N[b];
                        matrix(2 * a, 2 * b) += geometric;
                        matrix(2 * a + 1, 2 * b + 1) += geometric;
                      }
                  }
              }
        }

      if constexpr (with_tangent)
        for (unsigned int i = 0; i < 2 * n; ++i)
          for (unsigned int j = 0; j < i; ++j)
            matrix(i, j) = matrix(j, i);
    }



    template<class Kinematics>
    void Solid<Kinematics>::cell_forces(const Cell           &cell,
                                        const Vector<double> &u,
                                        FullMatrix<double>   *tangent,
                                        Vector<double>       &forces) const
    {
      if (tangent == nullptr)
        {
          FullMatrix<double> no_tangent;
          assemble_cell<false>(cell, u, no_tangent, forces);
        }
      else
        assemble_cell<true>(cell, u, *tangent, forces);
    }



    template<class Kinematics>
    std::vector<std::vector<SymmetricTensor<2, 3>>>
    Solid<Kinematics>::stresses(const Vector<double> &u) const
    {
      std::vector<std::vector<SymmetricTensor<2, 3>>> stresses(
        discretization.mesh.triangulation.n_active_cells());
      for (const Cell &cell : cells)
        {
          auto &of_cell = stresses[cell.active_index];
          of_cell.resize(cell.JxW.size());
          for (unsigned int q = 0; q < cell.JxW.size(); ++q)
            {
              const Tensor<2, 2>    H      = displacement_gradient(cell, q, u);
              const auto            strain = Kinematics::strain(H);
              const auto            plane  = cell.material->stress(strain);
              SymmetricTensor<2, 3> S;
              for (unsigned int i = 0; i < 2; ++i)
                for (unsigned int j = 0; j <= i; ++j)
                  S[i][j] = plane[i][j];
              S[2][2]    = cell.material->stress_out_of_plane(strain);
              of_cell[q] = Kinematics::cauchy(H, S);
            }
        }
      return stresses;
    }
  } // namespace



  std::unique_ptr<Elasticity>
  Elasticity::create(const Discretization     &discretization,
                     const Parameters::Solids &parameters)
  {
    if (parameters.kinematics == "small strain")
      return std::make_unique<Solid<SmallStrain>>(discretization, parameters);
    return std::make_unique<Solid<LargeDisplacement>>(discretization,
                                                      parameters);
  }



  Elasticity::Elasticity(const Discretization     &discretization,
                         const Parameters::Solids &parameters)
    : discretization(discretization)
  {
    const std::string entry = "Solids/Young's modulus";
    for (const auto &[name, young] : parameters.young)
      {
        const auto body = discretization.mesh.body(name, entry);
        materials.emplace(body, Material(young, parameters.poisson.at(name)));
        young_moduli[body] = young;
      }
    for (const auto &[name, body] : discretization.mesh.bodies)
      if (materials.count(body) == 0)
        throw InputError("body '" + name + "' has no material",
                         entry,
                         "add '" + name + ": <value>' to the moduli");
    tabulate();
  }



  double Elasticity::young(const types::material_id body) const
  {
    return young_moduli.at(body);
  }



  const Material &Elasticity::material(const types::material_id body) const
  {
    return materials.at(body);
  }



  void Elasticity::visit_cell(const Cell           &cell,
                              const Vector<double> &u,
                              const bool            with_tangent,
                              FullMatrix<double>   &tangent,
                              Vector<double>       &forces,
                              const CellVisitor    &visitor) const
  {
    const unsigned int n = cell.dofs.size();
    forces.reinit(n);
    if (with_tangent)
      tangent.reinit(n, n);
    cell_forces(cell, u, with_tangent ? &tangent : nullptr, forces);
    visitor(cell.dofs, tangent, forces);
  }



  void Elasticity::visit_cells(const Vector<double> &u,
                               const bool            with_tangent,
                               const CellVisitor    &visitor) const
  {
    FullMatrix<double> tangent;
    Vector<double>     forces;
    for (unsigned int c = 0; c < n_own_cells; ++c)
      visit_cell(cells[c], u, with_tangent, tangent, forces, visitor);
  }



  void Elasticity::visit_cells(const Vector<double>            &u,
                               const bool                       with_tangent,
                               const std::vector<unsigned int> &chosen,
                               const CellVisitor               &visitor) const
  {
    FullMatrix<double> tangent;
    Vector<double>     forces;
    for (const unsigned int c : chosen)
      visit_cell(cells[c], u, with_tangent, tangent, forces, visitor);
  }



  unsigned int Elasticity::n_cells() const
  {
    return n_own_cells;
  }



  const std::vector<types::global_dof_index> &
  Elasticity::dofs_of_cell(const unsigned int number) const
  {
    return cells[number].dofs;
  }



  void Elasticity::assemble(const Vector<double> &u,
                            const double          load_factor,
                            Vector<double>       &rhs,
                            SparseMatrix<double> *matrix) const
  {
    const auto    &constraints = discretization.constraints;
    Vector<double> cell_rhs;
    visit_cells(u,
                matrix != nullptr,
                [&](const std::vector<types::global_dof_index> &dofs,
                    const FullMatrix<double>                   &tangent,
                    const Vector<double>                       &forces) {
                  cell_rhs.reinit(forces.size());
                  cell_rhs.add(-1, forces);
                  if (matrix == nullptr)
                    constraints.distribute_local_to_global(cell_rhs, dofs, rhs);
                  else
                    constraints.distribute_local_to_global(tangent,
                                                           cell_rhs,
                                                           dofs,
                                                           *matrix,
                                                           rhs);
                });

    const auto  load  = discretization.dead_load(load_factor);
    const auto &owned = discretization.dof_handler.locally_owned_dofs();
    for (unsigned int i = 0; i < load.size(); ++i)
      if (load[i] != 0 && owned.is_element(i))
        constraints.distribute_local_to_global(i, load[i], rhs);
  }



  Vector<double> Elasticity::forces(const Vector<double> &u,
                                    const double          load_factor) const
  {
    Vector<double> forces(discretization.dof_handler.n_dofs());
    visit_cells(u,
                false,
                [&](const std::vector<types::global_dof_index> &dofs,
                    const FullMatrix<double> &,
                    const Vector<double> &cell_forces) {
                  forces.add(dofs, cell_forces);
                });
    Utilities::MPI::sum(forces, discretization.communicator, forces);
    forces -= discretization.dead_load(load_factor);
    return forces;
  }



  void Elasticity::tabulate()
  {
    hp::FEValues<2> hp_fe_values(discretization.mapping,
                                 discretization.fe,
                                 discretization.quadrature,
                                 update_gradients | update_JxW_values);

    std::vector<types::global_dof_index> dofs;
    std::vector<Cell>                    neighbors;
    for (const auto &dof_cell :
         discretization.dof_handler.active_cell_iterators())
      {
        if (dof_cell->is_artificial())
          continue;
        hp_fe_values.reinit(dof_cell);
        const auto &fe_values = hp_fe_values.get_present_fe_values();
        const auto &fe        = fe_values.get_fe();

        const bool bound = discretization.bound_centre &&
                           dof_cell->reference_cell().is_hyper_cube();
        const unsigned int n_nodes = fe.base_element(0).n_dofs_per_cell();
        const unsigned int n_free  = bound ? n_nodes - 1 : n_nodes;

        Cell cell;
        cell.active_index = dof_cell->active_cell_index();
        cell.material     = &materials.at(dof_cell->material_id());
        cell.JxW          = fe_values.get_JxW_values();

        dofs.resize(fe.n_dofs_per_cell());
        dof_cell->get_dof_indices(dofs);
        for (unsigned int a = 0; a < n_free; ++a)
          for (unsigned int c = 0; c < 2; ++c)
            cell.dofs.push_back(dofs[fe.component_to_system_index(c, a)]);

        // Bound, the centre moves with the corners (-1/4) and the mid-sides
        // (1/2) and hands its shape function on to them.
        for (const unsigned int q : fe_values.quadrature_point_indices())
          for (unsigned int a = 0; a < n_free; ++a)
            {
              const auto gradient = [&](const unsigned int node) {
                return fe_values.shape_grad(fe.component_to_system_index(0,
                                                                         node),
                                            q);
              };
              cell.gradients.push_back(
                bound ? gradient(a) + (a < 4 ? -0.25 : 0.5) * gradient(8)
                      : gradient(a));
            }
        (dof_cell->is_locally_owned() ? cells : neighbors)
          .push_back(std::move(cell));
      }
    n_own_cells = cells.size();
    std::move(neighbors.begin(), neighbors.end(), std::back_inserter(cells));
  }



  void Elasticity::add_couplings(DynamicSparsityPattern &pattern) const
  {
    for (unsigned int c = 0; c < n_own_cells; ++c)
      discretization.constraints.add_entries_local_to_global(
        cells[c].dofs,
        pattern,
        /*keep_constrained_entries=*/false);
  }
} // namespace Contact
