/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cell_integrals_h
#define contact_cell_integrals_h

#include <deal.II/base/quadrature_lib.h>

#include <array>

#include "base/dimension.h"
#include "solid/cell_kernel.h"
#include "solid/symmetry.h"

namespace Contact
{
  using namespace dealii;

  /// The parts of the integrals over a cell, with one kinematics and one
  /// symmetry, which no quadrature loop has to ask for.
  template<class Kinematics, class Symmetry>
  class CellIntegrals : public CellKernel<Symmetry::dim>
  {
  public:
    static constexpr int dim = Symmetry::dim;

    CellIntegrals(const Material &elastic)
      : elastic(elastic)
    {
    }

    bool is_small_strain() const override
    {
      return !Kinematics::has_geometric_stiffness;
    }

    double energy_density(const SymmetricTensor<2, 3> &stress) const override
    {
      return Symmetry::energy_density(elastic, stress);
    }

    /// Of elastic bodies, whose forces are at most cubic in the displacement.
    typename CellKernel<dim>::Works
    works(const CellTable<dim> &cell,
          const Vector<double> &u_0,
          const Vector<double> &u_1) const override
    {
      typename CellKernel<dim>::Works works;
      if (this->is_linear() && cell.thermal == cell.thermal_before)
        return works;
      const Rates rates = work_rates(cell, u_0, u_1, 3);
      works.path        = path_work(rates.work);
      works.thermal     = integral(rates.thermal);
      return works;
    }

    std::vector<SymmetricTensor<2, 3>>
    strains(const CellTable<dim> &cell, const Vector<double> &u) const override
    {
      std::vector<SymmetricTensor<2, 3>> strains;
      strains.reserve(cell.JxW.size());
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        strains.push_back(strain(cell, q, u));
      return strains;
    }

  protected:
    const Material &elastic;

    static constexpr unsigned int n_max    = Utilities::pow(3, dim); // nodes
    static constexpr unsigned int n_modes  = dim + 1;
    static constexpr unsigned int n_shears = Dimension<dim>::n_rotations;

    using AtPoints = std::array<double, n_max>; // by quadrature point

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

    static DEAL_II_ALWAYS_INLINE Tensor<2, dim>
    displacement_gradient(const CellTable<dim> &cell,
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

    /// The strain that has a stress, E - e I with the thermal strain e.
    static SymmetricTensor<2, 3> strain(const CellTable<dim> &cell,
                                        const unsigned int    q,
                                        const Vector<double> &u)
    {
      return strain(cell, q, u, cell.thermal);
    }

    static DEAL_II_ALWAYS_INLINE SymmetricTensor<2, 3>
                                 strain(const CellTable<dim> &cell,
                                        const unsigned int    q,
                                        const Vector<double> &u,
                                        const double          thermal)
    {
      const auto in_space =
        Kinematics::strain(displacement_gradient(cell, q, u));
      SymmetricTensor<2, 3> E;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          E[i][j] = in_space[i][j];
      if constexpr (Symmetry::has_hoop)
        E[2][2] = Kinematics::strain(hoop_gradient(cell, q, u));
      for (unsigned int i = 0; i < 3; ++i)
        E[i][i] -= thermal;
      return E;
    }

    /// The orthonormal modes phi_m of the cell take the place of all else:
    ///   P d = sum_m theta_m phi_m,   theta_m = sum_q JxW phi_m d.
    static void project(const CellTable<dim> &cell, AtPoints &values)
    {
      std::array<double, n_modes> theta{};
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        for (unsigned int m = 0; m < n_modes; ++m)
          theta[m] += cell.JxW[q] * cell.modes[q][m] * values[q];
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          values[q] = 0;
          for (unsigned int m = 0; m < n_modes; ++m)
            values[q] += theta[m] * cell.modes[q][m];
        }
    }

    /// The part that the tangent needs besides.
    static DEAL_II_ALWAYS_INLINE void
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
    static DEAL_II_ALWAYS_INLINE void add_forces(const CellTable<dim> &cell,
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

    /// Add those to the upper half of the tangent of the @p n nodes, the moduli
    /// as a function of a row B_a: JxW D B_a.
    template<class Moduli>
    static void add_tangent(const PointState   &at,
                            const unsigned int  n,
                            const Moduli       &moduli,
                            FullMatrix<double> &matrix)
    {
      for (unsigned int a = 0; a < n; ++a)
        {
          StrainRows DB;
          for (unsigned int i = 0; i < dim; ++i)
            DB[i] = moduli(at.B[a][i]);
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

    static void mirror(FullMatrix<double> &matrix)
    {
      for (unsigned int i = 0; i < matrix.m(); ++i)
        for (unsigned int j = 0; j < i; ++j)
          matrix(i, j) = matrix(j, i);
    }

    /// Along the straight path from @p u_0 to @p u_1, on which thermal strains
    /// go straight as well, in the points of the rule of Gauss and Lobatto: the
    /// work of the forces by length, and minus the trace of the stresses times
    /// the change of the thermal strain.
    struct Rates
    {
      std::vector<double> work, thermal;
    };
    Rates work_rates(const CellTable<dim> &cell,
                     const Vector<double> &u_0,
                     const Vector<double> &u_1,
                     const unsigned int    n_points) const
    {
      Vector<double> d(u_1);
      d -= u_0;
      const QGaussLobatto<1> rule(n_points);
      Rates                  rates;
      Vector<double>         u(d.size()), forces(d.size());
      const double           change = cell.thermal - cell.thermal_before;
      CellTable<dim>         copy;
      const CellTable<dim>  *at = &cell;
      if (change != 0)
        {
          copy = cell;
          at   = &copy;
        }
      for (unsigned int k = 0; k < n_points; ++k)
        {
          const double s = rule.point(k)[0];
          u              = u_0;
          u.add(s, d);
          if (change != 0)
            copy.thermal = cell.thermal_before + s * change;
          forces = 0;
          this->forces(*at, u, StressStiffness::with, nullptr, forces);
          rates.work.push_back(forces * d);
          rates.thermal.push_back(
            change == 0 ? 0. : -change * integral_of_trace(*at, u));
        }
      return rates;
    }

    /// The integral of the trace of the material stress over the cell.
    virtual double integral_of_trace(const CellTable<dim> &cell,
                                     const Vector<double> &u) const = 0;

    /// The integral of rates by that rule.
    static double integral(const std::vector<double> &rates)
    {
      const QGaussLobatto<1> rule(rates.size());
      double                 sum = 0;
      for (unsigned int k = 0; k < rates.size(); ++k)
        sum += rule.weight(k) * rates[k];
      return sum;
    }

    /// The work by that rule, exact for rates of the degree 2 n - 3, minus that
    /// by the trapezoidal one.
    static double path_work(const std::vector<double> &rates)
    {
      return integral(rates) - 0.5 * (rates.front() + rates.back());
    }
  };
} // namespace Contact

#endif
