/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The integrals over a cell of class Elasticity.

#include "base/counters.h"
#include "solid/elasticity.h"
#include "solid/symmetry.h"

namespace Contact
{
  namespace
  {
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
        return Symmetry::energy_density(material(body), stress);
      }

    private:
      /// By quadrature point, of which there are nine at most.
      using AtPoints = std::array<double, 9>;

      SmallestInCell cell_forces(const CellTable      &cell,
                                 const Vector<double> &u,
                                 const StressStiffness stress_stiffness,
                                 FullMatrix<double>   *tangent,
                                 Vector<double>       &forces) const override;

      double cell_energy(const CellTable      &cell,
                         const Vector<double> &u) const override;

      template<bool with_tangent, bool projected>
      SmallestInCell assemble_cell(const CellTable      &cell,
                                   const Vector<double> &u,
                                   const StressStiffness stress_stiffness,
                                   FullMatrix<double>   &matrix,
                                   Vector<double>       &residual) const;

      static Tensor<2, 2> displacement_gradient(const CellTable      &cell,
                                                const unsigned int    q,
                                                const Vector<double> &u)
      {
        const unsigned int  n = cell.n_nodes();
        const Tensor<1, 2> *N = cell.gradients.data() + q * n;
        Tensor<2, 2>        H;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            H[i] += u[cell.dofs[2 * a + i]] * N[a];
        return H;
      }

      /// The hoop part of it, u_x/X; zero if nothing strains across the plane.
      static double hoop_gradient(const CellTable      &cell,
                                  const unsigned int    q,
                                  const Vector<double> &u)
      {
        double h = 0;
        if constexpr (Symmetry::has_hoop)
          for (unsigned int a = 0; a < cell.n_nodes(); ++a)
            h +=
              u[cell.dofs[2 * a]] * cell.hoop_gradients[q * cell.n_nodes() + a];
        return h;
      }

      /// tr E without projection.
      static double dilatation(const CellTable      &cell,
                               const unsigned int    q,
                               const Vector<double> &u)
      {
        return trace(Kinematics::strain(displacement_gradient(cell, q, u))) +
               Kinematics::strain(hoop_gradient(cell, q, u));
      }

      /// P tr E: with the orthonormal modes phi_m of the cell
      ///   P tr E = sum_m theta_m phi_m,   theta_m = sum_q JxW phi_m tr E.
      static AtPoints dilatations(const CellTable      &cell,
                                  const Vector<double> &u)
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
    };



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
    Solid<Kinematics, Symmetry>::assemble_cell(
      const CellTable      &cell,
      const Vector<double> &u,
      const StressStiffness stress_stiffness,
      FullMatrix<double>   &matrix,
      Vector<double>       &residual) const
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
                Tensor<1, 2> SN;
                double       S33_N = 0;
                if (stress_stiffness == StressStiffness::with)
                  {
                    SN = JxW * (S * N[a]);
                    if constexpr (Symmetry::has_hoop)
                      S33_N = JxW * S33 * N_X[a];
                  }
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
                          matrix(2 * a, 2 * b) += S33_N * N_X[b];
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
    Solid<Kinematics, Symmetry>::cell_forces(
      const CellTable      &cell,
      const Vector<double> &u,
      const StressStiffness stress_stiffness,
      FullMatrix<double>   *tangent,
      Vector<double>       &forces) const
    {
      counters().large_displacement_cells += !is_linear();
      const bool projected = !cell.modes.empty();
      if (tangent == nullptr)
        {
          FullMatrix<double> no_tangent;
          return projected ? assemble_cell<false, true>(cell,
                                                        u,
                                                        stress_stiffness,
                                                        no_tangent,
                                                        forces)
                           : assemble_cell<false, false>(cell,
                                                         u,
                                                         stress_stiffness,
                                                         no_tangent,
                                                         forces);
        }
      return projected ? assemble_cell<true, true>(cell,
                                                   u,
                                                   stress_stiffness,
                                                   *tangent,
                                                   forces)
                       : assemble_cell<true, false>(cell,
                                                    u,
                                                    stress_stiffness,
                                                    *tangent,
                                                    forces);
    }



    template<class Kinematics, class Symmetry>
    double
    Solid<Kinematics, Symmetry>::cell_energy(const CellTable      &cell,
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
      for (const auto *part : {&tables.own, &tables.neighbors})
        for (const CellTable &cell : *part)
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



  std::unique_ptr<Elasticity>
  Elasticity::create(const Discretization     &discretization,
                     const Parameters::Solids &parameters)
  {
    const auto create_with =
      [&](const auto symmetry) -> std::unique_ptr<Elasticity> {
      using Symmetry = std::decay_t<decltype(symmetry)>;
      if (parameters.kinematics == Parameters::Strains::small)
        return std::make_unique<Solid<SmallStrain, Symmetry>>(discretization,
                                                              parameters);
      return std::make_unique<Solid<LargeDisplacement, Symmetry>>(
        discretization,
        parameters);
    };
    return discretization.axisymmetric ? create_with(Axisymmetric())
                                       : create_with(PlaneStrain());
  }
} // namespace Contact
