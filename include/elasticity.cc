/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "elasticity.h"

#include <deal.II/base/mpi.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>

#include "counters.h"
#include "errors.h"
#include "symmetry.h"

namespace Contact
{
  namespace
  {
    /**
     * The first @p n_modes of the polynomials 1, xi, eta, made orthonormal with
     * respect to the weights @p JxW of the points of a cell (modified Gram and
     * Schmidt); none if there are as many as points, where projecting changes
     * nothing.
     */
    std::vector<std::array<double, 3>>
    orthonormal_modes(const Quadrature<2>       &quadrature,
                      const std::vector<double> &JxW,
                      const unsigned int         n_modes)
    {
      if (n_modes >= quadrature.size())
        return {};

      // What is left out stays zero.
      std::vector<std::array<double, 3>> modes(quadrature.size(), {{0, 0, 0}});
      const auto product = [&](const unsigned int m, const unsigned int n) {
        double sum = 0;
        for (unsigned int q = 0; q < JxW.size(); ++q)
          sum += JxW[q] * modes[q][m] * modes[q][n];
        return sum;
      };
      for (unsigned int m = 0; m < n_modes; ++m)
        {
          for (unsigned int q = 0; q < JxW.size(); ++q)
            modes[q][m] = m == 0 ? 1 : quadrature.point(q)[m - 1] - 0.5;
          for (unsigned int n = 0; n < m; ++n)
            {
              const double part = product(m, n);
              for (auto &mode : modes)
                mode[m] -= part * mode[n];
            }
          const double norm = std::sqrt(product(m, m));
          for (auto &mode : modes)
            mode[m] /= norm;
        }
      return modes;
    }



    /// The bodies with one kinematics and one symmetry, which no quadrature
    /// loop has to ask for.
    template<class Kinematics, class Symmetry>
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

      double energy_density(const types::material_id     body,
                            const SymmetricTensor<2, 3> &stress) const override
      {
        return Symmetry::energy_density(materials.at(body), stress);
      }

    private:
      /// By quadrature point, of which there are nine at most.
      using AtPoints = std::array<double, 9>;

      SmallestInCell cell_forces(const Cell           &cell,
                                 const Vector<double> &u,
                                 FullMatrix<double>   *tangent,
                                 Vector<double>       &forces) const override;

      double cell_energy(const Cell           &cell,
                         const Vector<double> &u) const override;

      /// P tr E.
      AtPoints dilatations(const Cell &cell, const Vector<double> &u) const;

      Tensor<2, 2> displacement_gradient(const Cell           &cell,
                                         const unsigned int    q,
                                         const Vector<double> &u) const;

      /// The hoop part of it, u_x/X; zero if nothing strains across the plane.
      double hoop_gradient(const Cell           &cell,
                           const unsigned int    q,
                           const Vector<double> &u) const;

      /// tr E without projection.
      double dilatation(const Cell           &cell,
                        const unsigned int    q,
                        const Vector<double> &u) const;

      template<bool with_tangent, bool projected>
      SmallestInCell assemble_cell(const Cell           &cell,
                                   const Vector<double> &u,
                                   FullMatrix<double>   &matrix,
                                   Vector<double>       &residual) const;
    };



    template<class Kinematics, class Symmetry>
    Tensor<2, 2> Solid<Kinematics, Symmetry>::displacement_gradient(
      const Cell           &cell,
      const unsigned int    q,
      const Vector<double> &u) const
    {
      const unsigned int  n = cell.n_nodes();
      const Tensor<1, 2> *N = cell.gradients.data() + q * n;
      Tensor<2, 2>        H;
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int i = 0; i < 2; ++i)
          H[i] += u[cell.dofs[2 * a + i]] * N[a];
      return H;
    }



    template<class Kinematics, class Symmetry>
    double
    Solid<Kinematics, Symmetry>::hoop_gradient(const Cell           &cell,
                                               const unsigned int    q,
                                               const Vector<double> &u) const
    {
      double h = 0;
      if constexpr (Symmetry::has_hoop)
        for (unsigned int a = 0; a < cell.n_nodes(); ++a)
          h +=
            u[cell.dofs[2 * a]] * cell.hoop_gradients[q * cell.n_nodes() + a];
      return h;
    }



    template<class Kinematics, class Symmetry>
    double
    Solid<Kinematics, Symmetry>::dilatation(const Cell           &cell,
                                            const unsigned int    q,
                                            const Vector<double> &u) const
    {
      return trace(Kinematics::strain(displacement_gradient(cell, q, u))) +
             Kinematics::strain(hoop_gradient(cell, q, u));
    }



    // With the orthonormal modes phi_m of the cell,
    //   P tr E = sum_m theta_m phi_m,   theta_m = sum_q JxW phi_m tr E.
    template<class Kinematics, class Symmetry>
    typename Solid<Kinematics, Symmetry>::AtPoints
    Solid<Kinematics, Symmetry>::dilatations(const Cell           &cell,
                                             const Vector<double> &u) const
    {
      AtPoints              dilatations{};
      std::array<double, 3> theta{};
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          dilatations[q] = dilatation(cell, q, u);
          if (!cell.modes.empty())
            for (unsigned int m = 0; m < 3; ++m)
              theta[m] += cell.JxW[q] * cell.modes[q][m] * dilatations[q];
        }
      if (!cell.modes.empty())
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          {
            dilatations[q] = 0;
            for (unsigned int m = 0; m < 3; ++m)
              dilatations[q] += theta[m] * cell.modes[q][m];
          }
      return dilatations;
    }



    // With F = (f_ij), the strains (E11, E22, 2 E12) vary with node a by
    //   B_a = [ f11 N,1            f21 N,1
    //           f12 N,2            f22 N,2
    //           f11 N,2 + f12 N,1  f21 N,2 + f22 N,1 ],
    // and the tangent of the nodes a and b is
    //   K_ab = B_a^T D B_b + (grad N_a . S grad N_b) I,
    // symmetric: the upper half is computed and mirrored. Of rings E33 varies
    // by the row (f33 N/X, 0) of B_a, and S33 N_a N_b/X^2 is added to K_ab in
    // x. Projected, the part of D with lambda becomes
    //   lambda sum_m g_m g_m^T,   g_m = sum_q JxW phi_m (trace of B),
    // while S has the projected dilatation and all else stays.
    template<class Kinematics, class Symmetry>
    template<bool with_tangent, bool projected>
    typename Solid<Kinematics, Symmetry>::SmallestInCell
    Solid<Kinematics, Symmetry>::assemble_cell(const Cell           &cell,
                                               const Vector<double> &u,
                                               FullMatrix<double>   &matrix,
                                               Vector<double> &residual) const
    {
      using StrainRows = std::array<typename Symmetry::StrainRow, 2>;

      const unsigned int n      = cell.n_nodes();
      const double       lambda = projected ? 0. : cell.material->lambda;
      const double       mu     = cell.material->mu;

      // Without projection they are neither filled nor read.
      AtPoints                              P_tr_E;
      std::array<std::array<double, 18>, 3> g;
      if constexpr (projected)
        {
          P_tr_E = dilatations(cell, u);
          if constexpr (with_tangent)
            g = {};
        }

      SmallestInCell            smallest;
      std::array<StrainRows, 9> B;
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          const Tensor<2, 2>  H   = displacement_gradient(cell, q, u);
          const Tensor<2, 2>  F   = Kinematics::gradient_of_motion(H);
          const auto          E   = Kinematics::strain(H);
          const Tensor<1, 2> *N   = cell.gradients.data() + q * n;
          const double        JxW = cell.JxW[q];

          // Across the plane; of these, plane strain uses nothing.
          const double  h   = hoop_gradient(cell, q, u);
          const double  f33 = Kinematics::gradient_of_motion(h);
          const double  E33 = Kinematics::strain(h);
          const double *N_X =
            Symmetry::has_hoop ? &cell.hoop_gradients[q * n] : nullptr;

          const double tr_E = projected ? P_tr_E[q] : trace(E) + E33;
          const auto   S    = cell.material->stress(E, tr_E);
          const double S33  = cell.material->hoop_stress(E33, tr_E);
          if constexpr (Kinematics::has_geometric_stiffness)
            {
              const double det_F = determinant(F) * f33;
              if (det_F < smallest.value)
                smallest = {det_F, q};
            }

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
          if constexpr (Symmetry::has_hoop)
            for (unsigned int a = 0; a < n; ++a)
              {
                B[a][0][3] = f33 * N_X[a];
                residual[2 * a] += JxW * B[a][0][3] * S33;
              }

          if constexpr (with_tangent && projected)
            for (unsigned int m = 0; m < 3; ++m)
              for (unsigned int a = 0; a < n; ++a)
                for (unsigned int i = 0; i < 2; ++i)
                  g[m][2 * a + i] +=
                    JxW * cell.modes[q][m] * Symmetry::trace(B[a][i]);

          if constexpr (with_tangent)
            for (unsigned int a = 0; a < n; ++a)
              {
                StrainRows DB;
                for (unsigned int i = 0; i < 2; ++i)
                  {
                    const double tr = lambda * Symmetry::trace(B[a][i]);
                    DB[i]           = {{JxW * (tr + 2 * mu * B[a][i][0]),
                                        JxW * (tr + 2 * mu * B[a][i][1]),
                                        JxW * mu * B[a][i][2]}};
                    if constexpr (Symmetry::has_hoop)
                      DB[i][3] = JxW * (tr + 2 * mu * B[a][i][3]);
                  }
                const Tensor<1, 2> SN = JxW * (S * N[a]);
                for (unsigned int b = a; b < n; ++b)
                  {
                    for (unsigned int i = 0; i < 2; ++i)
                      for (unsigned int j = 0; j < 2; ++j)
                        matrix(2 * a + i, 2 * b + j) += DB[i][0] * B[b][j][0] +
                                                        DB[i][1] * B[b][j][1] +
                                                        DB[i][2] * B[b][j][2];
                    if constexpr (Symmetry::has_hoop)
                      for (unsigned int i = 0; i < 2; ++i)
                        matrix(2 * a + i, 2 * b) += DB[i][3] * B[b][0][3];
                    if constexpr (Kinematics::has_geometric_stiffness)
                      {
                        const double geometric = SN * N[b];
                        matrix(2 * a, 2 * b) += geometric;
                        matrix(2 * a + 1, 2 * b + 1) += geometric;
                        if constexpr (Symmetry::has_hoop)
                          matrix(2 * a, 2 * b) += JxW * S33 * N_X[a] * N_X[b];
                      }
                  }
              }
        }

      if constexpr (with_tangent && projected)
        for (unsigned int m = 0; m < 3; ++m)
          for (unsigned int i = 0; i < 2 * n; ++i)
            for (unsigned int j = i; j < 2 * n; ++j)
              matrix(i, j) += cell.material->lambda * g[m][i] * g[m][j];

      if constexpr (with_tangent)
        for (unsigned int i = 0; i < 2 * n; ++i)
          for (unsigned int j = 0; j < i; ++j)
            matrix(i, j) = matrix(j, i);
      return smallest;
    }



    template<class Kinematics, class Symmetry>
    typename Solid<Kinematics, Symmetry>::SmallestInCell
    Solid<Kinematics, Symmetry>::cell_forces(const Cell           &cell,
                                             const Vector<double> &u,
                                             FullMatrix<double>   *tangent,
                                             Vector<double>       &forces) const
    {
      counters().large_displacement_cells += !is_linear();
      const bool projected = !cell.modes.empty();
      if (tangent == nullptr)
        {
          FullMatrix<double> no_tangent;
          return projected
                   ? assemble_cell<false, true>(cell, u, no_tangent, forces)
                   : assemble_cell<false, false>(cell, u, no_tangent, forces);
        }
      return projected ? assemble_cell<true, true>(cell, u, *tangent, forces)
                       : assemble_cell<true, false>(cell, u, *tangent, forces);
    }



    template<class Kinematics, class Symmetry>
    double
    Solid<Kinematics, Symmetry>::cell_energy(const Cell           &cell,
                                             const Vector<double> &u) const
    {
      const AtPoints P_tr_E = dilatations(cell, u);
      double         energy = 0;
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        energy +=
          cell.JxW[q] * cell.material->stored_energy(
                          Kinematics::strain(displacement_gradient(cell, q, u)),
                          Kinematics::strain(hoop_gradient(cell, q, u)),
                          P_tr_E[q]);
      return energy;
    }



    template<class Kinematics, class Symmetry>
    std::vector<std::vector<SymmetricTensor<2, 3>>>
    Solid<Kinematics, Symmetry>::stresses(const Vector<double> &u) const
    {
      std::vector<std::vector<SymmetricTensor<2, 3>>> stresses(
        discretization.mesh.triangulation.n_active_cells());
      for (const Cell &cell : cells)
        {
          auto &of_cell = stresses[cell.active_index];
          of_cell.resize(cell.JxW.size());
          const AtPoints P_tr_E = dilatations(cell, u);
          for (unsigned int q = 0; q < cell.JxW.size(); ++q)
            {
              const Tensor<2, 2> H      = displacement_gradient(cell, q, u);
              const double       h      = hoop_gradient(cell, q, u);
              const auto         strain = Kinematics::strain(H);
              const auto plane = cell.material->stress(strain, P_tr_E[q]);
              SymmetricTensor<2, 3> S;
              for (unsigned int i = 0; i < 2; ++i)
                for (unsigned int j = 0; j <= i; ++j)
                  S[i][j] = plane[i][j];
              S[2][2] =
                cell.material->hoop_stress(Kinematics::strain(h), P_tr_E[q]);
              of_cell[q] = Kinematics::cauchy(H, h, S);
            }
        }
      return stresses;
    }
  } // namespace



  // Lexicographic, so that it does not depend on the number of ranks which of
  // several equal ones is named.
  VolumeRatio smallest_of_all_ranks(const VolumeRatio &of_rank,
                                    const MPI_Comm     communicator)
  {
    using Numbers     = std::array<double, 4>; // value, body, X
    const auto of_all = Utilities::MPI::all_gather(
      communicator,
      Numbers{{of_rank.value, 1. * of_rank.body, of_rank.X[0], of_rank.X[1]}});
    const Numbers numbers = *std::min_element(of_all.begin(), of_all.end());
    return {numbers[0],
            static_cast<types::material_id>(numbers[1]),
            Point<2>(numbers[2], numbers[3])};
  }



  std::unique_ptr<Elasticity>
  Elasticity::create(const Discretization     &discretization,
                     const Parameters::Solids &parameters)
  {
    const auto create_with =
      [&](const auto symmetry) -> std::unique_ptr<Elasticity> {
      using Symmetry = std::decay_t<decltype(symmetry)>;
      if (parameters.kinematics == "small strain")
        return std::make_unique<Solid<SmallStrain, Symmetry>>(discretization,
                                                              parameters);
      return std::make_unique<Solid<LargeDisplacement, Symmetry>>(
        discretization,
        parameters);
    };
    return discretization.axisymmetric ? create_with(Axisymmetric())
                                       : create_with(PlaneStrain());
  }



  Elasticity::Elasticity(const Discretization     &discretization,
                         const Parameters::Solids &parameters)
    : dead_loads(discretization)
    , discretization(discretization)
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

    for (const auto &[body, material] : materials)
      if (parameters.dilatation == "projected" ||
          (parameters.dilatation == "automatic" &&
           material.lambda > 10 * material.mu))
        projected.insert(body);
    tabulate();
    sum_volumes();
  }



  double Elasticity::young(const types::material_id body) const
  {
    return young_moduli.at(body);
  }



  const Material &Elasticity::material(const types::material_id body) const
  {
    return materials.at(body);
  }



  bool Elasticity::is_projected(const types::material_id body) const
  {
    return projected.count(body) > 0;
  }



  void Elasticity::visit_cell(const Cell           &cell,
                              const Vector<double> &u,
                              const bool            with_tangent,
                              FullMatrix<double>   &tangent,
                              Vector<double>       &forces,
                              const CellVisitor    &visitor,
                              VolumeRatio          &smallest) const
  {
    ++counters().cell_forces;
    counters().cell_tangents += with_tangent;
    const unsigned int n = cell.dofs.size();
    forces.reinit(n);
    if (with_tangent)
      tangent.reinit(n, n);
    FullMatrix<double>  *wanted  = with_tangent ? &tangent : nullptr;
    const SmallestInCell of_cell = cell_forces(cell, u, wanted, forces);
    if (of_cell.value < smallest.value)
      smallest = {of_cell.value, cell.body, cell.points[of_cell.point]};
    if (!hold_stiffness.empty())
      add_springs(cell, u, wanted, forces);
    visitor(cell.dofs, tangent, forces);
  }



  VolumeRatio Elasticity::visit_cells(const Vector<double> &u,
                                      const bool            with_tangent,
                                      const CellVisitor    &visitor) const
  {
    FullMatrix<double> tangent;
    Vector<double>     forces;
    VolumeRatio        smallest;
    for (unsigned int c = 0; c < n_own_cells; ++c)
      visit_cell(cells[c], u, with_tangent, tangent, forces, visitor, smallest);
    return smallest;
  }



  VolumeRatio Elasticity::visit_cells(const Vector<double> &u,
                                      const bool            with_tangent,
                                      const std::vector<unsigned int> &chosen,
                                      const CellVisitor &visitor) const
  {
    FullMatrix<double> tangent;
    Vector<double>     forces;
    VolumeRatio        smallest;
    for (const unsigned int c : chosen)
      visit_cell(cells[c], u, with_tangent, tangent, forces, visitor, smallest);
    return smallest;
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



  VolumeRatio Elasticity::assemble(const Vector<double> &u,
                                   const double          load_factor,
                                   Vector<double>       &rhs,
                                   SparseMatrix<double> *matrix) const
  {
    add_dead_load(load_factor, rhs);

    // Bodies at rest exert nothing.
    if (matrix == nullptr && hold_stiffness.empty() && u.all_zero())
      return VolumeRatio();

    const auto    &constraints = discretization.constraints;
    Vector<double> cell_rhs;
    const auto     smallest =
      visit_cells(u,
                  matrix != nullptr,
                  [&](const std::vector<types::global_dof_index> &dofs,
                      const FullMatrix<double>                   &tangent,
                      const Vector<double>                       &forces) {
                    cell_rhs.reinit(forces.size());
                    cell_rhs.add(-1, forces);
                    if (matrix == nullptr)
                      constraints.distribute_local_to_global(cell_rhs,
                                                             dofs,
                                                             rhs);
                    else
                      constraints.distribute_local_to_global(tangent,
                                                             cell_rhs,
                                                             dofs,
                                                             *matrix,
                                                             rhs);
                  });
    return smallest;
  }



  void Elasticity::add_dead_load(const double    load_factor,
                                 Vector<double> &rhs) const
  {
    const auto  load  = dead_loads.at(load_factor);
    const auto &owned = discretization.dof_handler.locally_owned_dofs();
    for (unsigned int i = 0; i < load.size(); ++i)
      if (load[i] != 0 && owned.is_element(i))
        discretization.constraints.distribute_local_to_global(i, load[i], rhs);
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
    forces -= dead_loads.at(load_factor);
    return forces;
  }



  double Elasticity::strain_energy(const Vector<double> &u) const
  {
    double energy = 0;
    for (unsigned int c = 0; c < n_own_cells; ++c)
      energy += cell_energy(cells[c], u);
    return Utilities::MPI::sum(energy, discretization.communicator);
  }



  void
  Elasticity::hold_softly(const std::map<types::material_id, double> &stiffness,
                          const Vector<double>                       &rest)
  {
    Assert(rest.size() >= discretization.dof_handler.n_dofs(),
           ExcDimensionMismatch(rest.size(),
                                discretization.dof_handler.n_dofs()));
    std::map<types::material_id, double> positive;
    for (const auto &[body, k] : stiffness)
      {
        Assert(volumes.count(body) > 0, ExcMessage("no such body"));
        Assert(k >= 0, ExcMessage("a negative stiffness"));
        if (k > 0)
          positive[body] = k;
      }
    if (positive != hold_stiffness)
      ++version;
    hold_stiffness = positive;
    hold_rest      = rest;
  }



  void Elasticity::release()
  {
    if (!hold_stiffness.empty())
      ++version;
    hold_stiffness.clear();
    hold_rest.reinit(0);
  }



  const std::map<types::material_id, double> &Elasticity::softly_held() const
  {
    return hold_stiffness;
  }



  unsigned int Elasticity::tangent_version() const
  {
    return version;
  }



  double Elasticity::spring(const Cell &cell) const
  {
    const auto held = hold_stiffness.find(cell.body);
    if (held == hold_stiffness.end())
      return 0;
    double volume = 0;
    for (const double JxW : cell.JxW)
      volume += JxW;
    return held->second * volume / volumes.at(cell.body) / cell.n_corners();
  }



  void Elasticity::add_springs(const Cell           &cell,
                               const Vector<double> &u,
                               FullMatrix<double>   *tangent,
                               Vector<double>       &forces) const
  {
    const double k = spring(cell);
    for (unsigned int i = 0; i < 2 * cell.n_corners(); ++i)
      {
        forces[i] += k * (u[cell.dofs[i]] - hold_rest[cell.dofs[i]]);
        if (tangent != nullptr)
          (*tangent)(i, i) += k;
      }
  }



  std::map<types::material_id, double>
  Elasticity::hold_energy(const Vector<double> &u) const
  {
    std::map<types::material_id, double> energies;
    for (const auto &[body, k] : hold_stiffness)
      energies[body] = 0;
    for (unsigned int c = 0; c < n_own_cells; ++c)
      if (const double k = spring(cells[c]); k > 0)
        for (unsigned int i = 0; i < 2 * cells[c].n_corners(); ++i)
          {
            const auto dof = cells[c].dofs[i];
            energies[cells[c].body] +=
              0.5 * k * std::pow(u[dof] - hold_rest[dof], 2);
          }
    for (auto &[body, energy] : energies)
      energy = Utilities::MPI::sum(energy, discretization.communicator);
    return energies;
  }



  double Elasticity::mean_circumference(const types::material_id body) const
  {
    return volumes.at(body) / areas.at(body);
  }



  void Elasticity::sum_volumes()
  {
    for (const auto &[name, body] : discretization.mesh.bodies)
      areas[body] = volumes[body] = 0;
    for (unsigned int c = 0; c < n_own_cells; ++c)
      for (unsigned int q = 0; q < cells[c].JxW.size(); ++q)
        {
          volumes[cells[c].body] += cells[c].JxW[q];
          areas[cells[c].body] +=
            cells[c].JxW[q] / discretization.circumference(cells[c].points[q]);
        }
    for (auto *sums : {&areas, &volumes})
      for (auto &[body, sum] : *sums)
        sum = Utilities::MPI::sum(sum, discretization.communicator);
  }



  void Elasticity::tabulate()
  {
    hp::FEValues<2> hp_fe_values(
      discretization.mapping,
      discretization.fe,
      discretization.quadrature,
      update_gradients | update_JxW_values | update_quadrature_points |
        (discretization.axisymmetric ? update_values : update_default));

    std::vector<types::global_dof_index> dofs;
    std::vector<Cell>                    neighbors;
    cells.reserve(discretization.mesh.triangulation.n_active_cells());
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
        cell.body         = dof_cell->material_id();
        cell.material     = &materials.at(cell.body);
        cell.JxW          = fe_values.get_JxW_values();
        cell.points       = fe_values.get_quadrature_points();
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          cell.JxW[q] *= discretization.circumference(cell.points[q]);
        if (is_projected(cell.body))
          cell.modes =
            orthonormal_modes(fe_values.get_quadrature(),
                              cell.JxW,
                              discretization.degree == 2 &&
                                  dof_cell->reference_cell().is_hyper_cube()
                                ? 3
                                : 1);

        dofs.resize(fe.n_dofs_per_cell());
        dof_cell->get_dof_indices(dofs);
        for (unsigned int a = 0; a < n_free; ++a)
          for (unsigned int c = 0; c < 2; ++c)
            cell.dofs.push_back(dofs[fe.component_to_system_index(c, a)]);

        // Bound, the centre moves with the corners (-1/4) and the mid-sides
        // (1/2) and hands its shape function on to them.
        const auto handed_over = [&](const unsigned int a, const auto &of) {
          return bound ? of(a) + (a < 4 ? -0.25 : 0.5) * of(8) : of(a);
        };
        for (const unsigned int q : fe_values.quadrature_point_indices())
          for (unsigned int a = 0; a < n_free; ++a)
            {
              cell.gradients.push_back(
                handed_over(a, [&](const unsigned int node) {
                  return fe_values
                    .shape_grad(fe.component_to_system_index(0, node), q);
                }));
              if (discretization.axisymmetric)
                cell.hoop_gradients.push_back(
                  handed_over(a,
                              [&](const unsigned int node) {
                                return fe_values.shape_value(
                                  fe.component_to_system_index(0, node),
                                  q);
                              }) /
                  cell.points[q][0]);
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
