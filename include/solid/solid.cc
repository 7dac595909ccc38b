/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The integrals over a cell of class Elasticity.

#include "solid/elasticity.h"
#include "solid/symmetry.h"

namespace Contact
{
  namespace
  {
    /// The bodies with one kinematics and one symmetry, which no quadrature
    /// loop has to ask for.
    template<class Kinematics, class Symmetry>
    class Solid : public Elasticity<Symmetry::dim>
    {
    public:
      static constexpr int dim = Symmetry::dim;

      Solid(const Discretization<dim> &discretization,
            const Parameters::Solids  &parameters)
        : Elasticity<dim>(discretization, parameters)
      {
      }

      bool is_linear() const override
      {
        return !Kinematics::has_geometric_stiffness;
      }

      double energy_density(const types::material_id     body,
                            const SymmetricTensor<2, 3> &stress) const override
      {
        return Symmetry::energy_density(this->material(body), stress);
      }

    private:
      static constexpr unsigned int n_max    = dim == 2 ? 9 : 27; // nodes
      static constexpr unsigned int n_modes  = dim + 1;
      static constexpr unsigned int n_shears = dim == 2 ? 1 : 3;

      using AtPoints = std::array<double, n_max>; // by quadrature point

      double cell_forces(const CellTable<dim> &cell,
                         const Vector<double> &u,
                         const StressStiffness stress_stiffness,
                         FullMatrix<double>   *tangent,
                         Vector<double>       &forces) const override;

      double cell_energy(const CellTable<dim> &cell,
                         const Vector<double> &u) const override;

      std::vector<SymmetricTensor<2, 3>>
      cell_stresses(const CellTable<dim> &cell,
                    const Vector<double> &u) const override;

      /// By direction, what an unknown of a node adds to the strains.
      using StrainRows = std::array<typename Symmetry::StrainRow, dim>;

      /// A quadrature point: the gradient F of the motion, the stress S, and
      /// for the tangent the derivatives N_a,i and N_a/X of the shape functions
      /// and the rows B_a. What is across the plane only rings use.
      struct PointState
      {
        double                            JxW;
        const double                     *N_X;
        Tensor<2, dim>                    F;
        double                            f33;
        SymmetricTensor<2, dim>           S;
        double                            S33;
        std::array<Tensor<1, dim>, n_max> N;
        std::array<StrainRows, n_max>     B;

        void drop_stresses()
        {
          S   = 0;
          S33 = 0;
        }
      };

      template<bool with_tangent, bool projected>
      double assemble_cell(const CellTable<dim> &cell,
                           const Vector<double> &u,
                           const StressStiffness stress_stiffness,
                           FullMatrix<double>   &matrix,
                           Vector<double>       &residual) const;

      static Tensor<2, dim> displacement_gradient(const CellTable<dim> &cell,
                                                  const unsigned int    q,
                                                  const Vector<double> &u)
      {
        const Tensor<1, dim> *unit = cell.unit_gradients_at(q);
        const unsigned int    n    = cell.n_nodes();
        Tensor<2, dim>        H;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int i = 0; i < dim; ++i)
            H[i] += u[dim * a + i] * unit[a];
        return H * transpose(cell.gradient_maps[q]);
      }

      /// The hoop part of it, u_x/X; zero if nothing strains across the plane.
      static double hoop_gradient(const CellTable<dim> &cell,
                                  const unsigned int    q,
                                  const Vector<double> &u)
      {
        double h = 0;
        if constexpr (Symmetry::has_hoop)
          for (unsigned int a = 0; a < cell.n_nodes(); ++a)
            h += u[dim * a] * cell.hoop_gradients[q * cell.n_nodes() + a];
        return h;
      }

      /// P tr E: with the orthonormal modes phi_m of the cell
      ///   P tr E = sum_m theta_m phi_m,   theta_m = sum_q JxW phi_m tr E.
      static AtPoints dilatations(const CellTable<dim> &cell,
                                  const Vector<double> &u)
      {
        AtPoints                    dilatations{};
        std::array<double, n_modes> theta{};
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          {
            dilatations[q] =
              trace(Kinematics::strain(displacement_gradient(cell, q, u))) +
              Kinematics::strain(hoop_gradient(cell, q, u));
            if (!cell.modes.empty())
              for (unsigned int m = 0; m < n_modes; ++m)
                theta[m] += cell.JxW[q] * cell.modes[q][m] * dilatations[q];
          }
        if (!cell.modes.empty())
          for (unsigned int q = 0; q < cell.JxW.size(); ++q)
            {
              dilatations[q] = 0;
              for (unsigned int m = 0; m < n_modes; ++m)
                dilatations[q] += theta[m] * cell.modes[q][m];
            }
        return dilatations;
      }

      template<bool projected>
      static void find_state_at(const CellTable<dim> &cell,
                                const unsigned int    q,
                                const Vector<double> &u,
                                const AtPoints       &P_tr_E,
                                PointState           &at)
      {
        const Tensor<2, dim> H    = displacement_gradient(cell, q, u);
        const double         h    = hoop_gradient(cell, q, u);
        const auto           E    = Kinematics::strain(H);
        const double         E33  = Kinematics::strain(h);
        const double         tr_E = projected ? P_tr_E[q] : trace(E) + E33;

        at.JxW = cell.JxW[q];
        at.N_X = Symmetry::has_hoop ? &cell.hoop_gradients[q * cell.n_nodes()]
                                    : nullptr;
        at.F   = Kinematics::gradient_of_motion(H);
        at.f33 = Kinematics::gradient_of_motion(h);
        at.S   = cell.material->stress(E, tr_E);
        at.S33 = cell.material->hoop_stress(E33, tr_E);
      }

      /// What the tangent needs besides.
      static void
      add_rows(const CellTable<dim> &cell, const unsigned int q, PointState &at)
      {
        const Tensor<1, dim> *unit = cell.unit_gradients_at(q);
        const Tensor<2, dim>  map  = cell.gradient_maps[q];
        for (unsigned int a = 0; a < cell.n_nodes(); ++a)
          {
            at.N[a] = map * unit[a];
            for (unsigned int i = 0; i < dim; ++i)
              {
                for (unsigned int d = 0; d < dim; ++d)
                  at.B[a][i][d] = at.F[i][d] * at.N[a][d];
                for (unsigned int k = dim; k < dim + n_shears; ++k)
                  {
                    const auto [d, e] = Symmetry::components[k];
                    at.B[a][i][k] =
                      at.F[i][d] * at.N[a][e] + at.F[i][e] * at.N[a][d];
                  }
              }
            if constexpr (Symmetry::has_hoop)
              {
                at.B[a][0][3] = at.f33 * at.N_X[a];
                at.B[a][1][3] = 0;
              }
          }
      }

      /// Add the contributions of a point to the forces of the nodes of its
      /// cell: JxW F S grad N_a.
      static void add_forces(const CellTable<dim> &cell,
                             const unsigned int    q,
                             const PointState     &at,
                             Vector<double>       &residual)
      {
        const Tensor<2, dim> P =
          at.JxW * (at.F * Tensor<2, dim>(at.S) * cell.gradient_maps[q]);
        const Tensor<1, dim> *unit = cell.unit_gradients_at(q);
        const unsigned int    n    = cell.n_nodes();
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int i = 0; i < dim; ++i)
            residual[dim * a + i] += P[i] * unit[a];
        if constexpr (Symmetry::has_hoop)
          for (unsigned int a = 0; a < n; ++a)
            residual[dim * a] += at.JxW * at.f33 * at.S33 * at.N_X[a];
      }

      /// Add those to the upper half of the tangent of the @p n nodes.
      static void add_tangent(const PointState   &at,
                              const unsigned int  n,
                              const double        lambda,
                              const double        mu,
                              FullMatrix<double> &matrix);
    };



    template<class Kinematics, class Symmetry>
    void Solid<Kinematics, Symmetry>::add_tangent(const PointState   &at,
                                                  const unsigned int  n,
                                                  const double        lambda,
                                                  const double        mu,
                                                  FullMatrix<double> &matrix)
    {
      for (unsigned int a = 0; a < n; ++a)
        {
          StrainRows DB;
          for (unsigned int i = 0; i < dim; ++i)
            {
              const double tr = lambda * Symmetry::trace(at.B[a][i]);
              for (unsigned int d = 0; d < dim; ++d)
                DB[i][d] = at.JxW * (tr + 2 * mu * at.B[a][i][d]);
              for (unsigned int k = dim; k < dim + n_shears; ++k)
                DB[i][k] = at.JxW * mu * at.B[a][i][k];
              if constexpr (Symmetry::has_hoop)
                DB[i][3] = at.JxW * (tr + 2 * mu * at.B[a][i][3]);
            }
          const Tensor<1, dim> SN = at.JxW * (at.S * at.N[a]);
          for (unsigned int b = a; b < n; ++b)
            {
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j < dim; ++j)
                  {
                    double sum = DB[i][0] * at.B[b][j][0];
                    for (unsigned int k = 1; k < dim + n_shears; ++k)
                      sum += DB[i][k] * at.B[b][j][k];
                    matrix(dim * a + i, dim * b + j) += sum;
                  }
              if constexpr (Symmetry::has_hoop)
                for (unsigned int i = 0; i < dim; ++i)
                  matrix(dim * a + i, dim * b) += DB[i][3] * at.B[b][0][3];
              if constexpr (Kinematics::has_geometric_stiffness)
                {
                  const double geometric = SN * at.N[b];
                  for (unsigned int i = 0; i < dim; ++i)
                    matrix(dim * a + i, dim * b + i) += geometric;
                  if constexpr (Symmetry::has_hoop)
                    matrix(dim * a, dim * b) +=
                      at.JxW * at.S33 * at.N_X[a] * at.N_X[b];
                }
            }
        }
    }



    // With F = (f_ij), the strains (E11, E22, 2 E12) vary with node a by
    //   B_a = [ f11 N,1            f21 N,1
    //           f12 N,2            f22 N,2
    //           f11 N,2 + f12 N,1  f21 N,2 + f22 N,1 ],
    // in space likewise in the order of Symmetry::components, and the tangent
    // of the nodes a and b is
    //   K_ab = B_a^T D B_b + (grad N_a . S grad N_b) I,
    // symmetric: the upper half is computed and mirrored. Of rings E33 varies
    // by the row (f33 N/X, 0) of B_a, and S33 N_a N_b/X^2 is added to K_ab in
    // x. Projected, the part of D with lambda becomes
    //   lambda sum_m g_m g_m^T,   g_m = sum_q JxW phi_m (trace of B),
    // while S has the projected dilatation and all else stays.
    template<class Kinematics, class Symmetry>
    template<bool with_tangent, bool projected>
    double Solid<Kinematics, Symmetry>::assemble_cell(
      const CellTable<dim> &cell,
      const Vector<double> &u,
      const StressStiffness stress_stiffness,
      FullMatrix<double>   &matrix,
      Vector<double>       &residual) const
    {
      const unsigned int n      = cell.n_nodes();
      const double       lambda = projected ? 0. : cell.material->lambda;

      // Without projection they are neither filled nor read.
      AtPoints                                             P_tr_E;
      std::array<std::array<double, dim * n_max>, n_modes> g;
      if constexpr (projected)
        {
          P_tr_E = dilatations(cell, u);
          if constexpr (with_tangent)
            g = {};
        }

      double     smallest = 1;
      PointState at;
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          find_state_at<projected>(cell, q, u, P_tr_E, at);
          if constexpr (Kinematics::has_geometric_stiffness)
            {
              smallest = std::min(smallest, determinant(at.F) * at.f33);
            }
          add_forces(cell, q, at, residual);
          // In the tangent stresses are in nothing else.
          if (stress_stiffness == StressStiffness::without)
            at.drop_stresses();
          if constexpr (with_tangent)
            {
              add_rows(cell, q, at);
              add_tangent(at, n, lambda, cell.material->mu, matrix);
            }
          if constexpr (with_tangent && projected)
            for (unsigned int m = 0; m < n_modes; ++m)
              for (unsigned int a = 0; a < n; ++a)
                for (unsigned int i = 0; i < dim; ++i)
                  g[m][dim * a + i] +=
                    at.JxW * cell.modes[q][m] * Symmetry::trace(at.B[a][i]);
        }

      if constexpr (with_tangent && projected)
        for (unsigned int m = 0; m < n_modes; ++m)
          for (unsigned int i = 0; i < dim * n; ++i)
            for (unsigned int j = i; j < dim * n; ++j)
              matrix(i, j) += cell.material->lambda * g[m][i] * g[m][j];

      if constexpr (with_tangent)
        for (unsigned int i = 0; i < dim * n; ++i)
          for (unsigned int j = 0; j < i; ++j)
            matrix(i, j) = matrix(j, i);
      return smallest;
    }



    template<class Kinematics, class Symmetry>
    double Solid<Kinematics, Symmetry>::cell_forces(
      const CellTable<dim> &cell,
      const Vector<double> &u,
      const StressStiffness stress_stiffness,
      FullMatrix<double>   *tangent,
      Vector<double>       &forces) const
    {
      this->discretization.counters.large_displacement_cells += !is_linear();
      const bool projected     = !cell.modes.empty();
      const auto assemble_with = [&](auto with_tangent, auto projected) {
        FullMatrix<double> none;
        return assemble_cell<with_tangent, projected>(cell,
                                                      u,
                                                      stress_stiffness,
                                                      with_tangent ? *tangent
                                                                   : none,
                                                      forces);
      };
      const std::true_type  yes;
      const std::false_type no;
      if (tangent == nullptr)
        return projected ? assemble_with(no, yes) : assemble_with(no, no);
      return projected ? assemble_with(yes, yes) : assemble_with(yes, no);
    }



    template<class Kinematics, class Symmetry>
    double
    Solid<Kinematics, Symmetry>::cell_energy(const CellTable<dim> &cell,
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
    std::vector<SymmetricTensor<2, 3>>
    Solid<Kinematics, Symmetry>::cell_stresses(const CellTable<dim> &cell,
                                               const Vector<double> &u) const
    {
      std::vector<SymmetricTensor<2, 3>> stresses(cell.JxW.size());
      const AtPoints                     P_tr_E = dilatations(cell, u);
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          const Tensor<2, dim> H      = displacement_gradient(cell, q, u);
          const double         h      = hoop_gradient(cell, q, u);
          const auto           strain = Kinematics::strain(H);
          const auto           inner = cell.material->stress(strain, P_tr_E[q]);
          SymmetricTensor<2, 3> S;
          S[2][2] =
            cell.material->hoop_stress(Kinematics::strain(h), P_tr_E[q]);
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j <= i; ++j)
              S[i][j] = inner[i][j];
          stresses[q] = Kinematics::cauchy(H, h, S);
        }
      return stresses;
    }
  } // namespace



  template<int dim>
  std::unique_ptr<Elasticity<dim>>
  Elasticity<dim>::create(const Discretization<dim> &discretization,
                          const Parameters::Solids  &parameters)
  {
    const auto create_with =
      [&](const auto symmetry) -> std::unique_ptr<Elasticity<dim>> {
      using Symmetry = std::decay_t<decltype(symmetry)>;
      if (parameters.kinematics == Parameters::Strains::small)
        return std::make_unique<Solid<SmallStrain, Symmetry>>(discretization,
                                                              parameters);
      return std::make_unique<Solid<LargeDisplacement, Symmetry>>(
        discretization,
        parameters);
    };
    if constexpr (dim == 3)
      return create_with(Space());
    else
      return discretization.axisymmetric ? create_with(Axisymmetric())
                                         : create_with(PlaneStrain());
  }



  template std::unique_ptr<Elasticity<2>>
  Elasticity<2>::create(const Discretization<2> &, const Parameters::Solids &);
  template std::unique_ptr<Elasticity<3>>
  Elasticity<3>::create(const Discretization<3> &, const Parameters::Solids &);
} // namespace Contact
