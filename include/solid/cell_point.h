/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cell_point_h
#define contact_cell_point_h

#include <deal.II/base/utilities.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>

#include "base/dimension.h"
#include "solid/cell_tables.h"
#include "solid/symmetry.h"

namespace Contact
{
  using namespace dealii;

  /// A quadrature point: the gradient F of the motion, the stress S, and for
  /// the tangent the derivatives N_a,i and N_a/X of the shape functions and the
  /// rows B_a. What is across the plane only rings use.
  template<class Kinematics, class Symmetry>
  class CellPoint
  {
  public:
    static constexpr int          dim      = Symmetry::dim;
    static constexpr unsigned int n_max    = Utilities::pow(3, dim); // nodes
    static constexpr unsigned int n_shears = Dimension<dim>::n_rotations;

    double JxW;

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

    /// Go to a point with the displacement gradient @p H, across the plane @p
    /// h.
    DEAL_II_ALWAYS_INLINE void reinit(const CellTable<dim> &cell,
                                      const unsigned int    q,
                                      const Tensor<2, dim> &H,
                                      const double          h)
    {
      JxW  = cell.JxW[q];
      unit = cell.unit_gradients_at(q);
      map  = &cell.gradient_maps[q];
      n    = cell.n_nodes();
      N_X  = Symmetry::has_hoop ? &cell.hoop_gradients[q * n] : nullptr;
      F    = Kinematics::gradient_of_motion(H);
      f33  = Kinematics::gradient_of_motion(h);
    }

    double volume_ratio() const
    {
      return determinant(F) * f33;
    }

    void set_stress(const SymmetricTensor<2, 3> &stress)
    {
      S   = in_space<dim>(stress);
      S33 = stress[2][2];
    }

    /// Add to the forces of the nodes of the cell: JxW F S grad N_a.
    template<class Forces>
    DEAL_II_ALWAYS_INLINE void add_forces(Forces &forces) const
    {
      const Tensor<2, dim> P = JxW * (F * Tensor<2, dim>(S) * *map);
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          forces[dim * a + i] += P[i] * unit[a];
      if constexpr (Symmetry::has_hoop)
        for (unsigned int a = 0; a < n; ++a)
          forces[dim * a] += JxW * f33 * S33 * N_X[a];
    }

    /**
     * Add to the upper half of the tangent, the moduli as a function of a row
     * B_a: JxW D B_a. With F = (f_ij), the strains (E11, E22, 2 E12) vary with
     * node a by
     *   B_a = [ f11 N,1            f21 N,1
     *           f12 N,2            f22 N,2
     *           f11 N,2 + f12 N,1  f21 N,2 + f22 N,1 ],
     * in 3-D likewise in the order of Symmetry::components, and the tangent of
     * the nodes a and b is
     *   K_ab = B_a^T D B_b + (grad N_a . S grad N_b) I.
     * Of rings E33 varies by the row (f33 N/X, 0) of B_a, and S33 N_a N_b/X^2
     * is added to K_ab in x.
     */
    template<class Moduli>
    void add_tangent(const Moduli &moduli, FullMatrix<double> &matrix)
    {
      find_rows();
      for (unsigned int a = 0; a < n; ++a)
        {
          StrainRows DB;
          for (unsigned int i = 0; i < dim; ++i)
            DB[i] = moduli(B[a][i]);
          const Tensor<1, dim> SN = JxW * (S * N[a]);
          for (unsigned int b = a; b < n; ++b)
            {
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j < dim; ++j)
                  {
                    double sum = DB[i][0] * B[b][j][0];
                    for (unsigned int k = 1; k < dim + n_shears; ++k)
                      sum += DB[i][k] * B[b][j][k];
                    matrix(dim * a + i, dim * b + j) += sum;
                  }
              if constexpr (Symmetry::has_hoop)
                for (unsigned int i = 0; i < dim; ++i)
                  matrix(dim * a + i, dim * b) += DB[i][3] * B[b][0][3];
              if constexpr (Kinematics::has_geometric_stiffness)
                {
                  const double geometric = SN * N[b];
                  for (unsigned int i = 0; i < dim; ++i)
                    matrix(dim * a + i, dim * b + i) += geometric;
                  if constexpr (Symmetry::has_hoop)
                    matrix(dim * a, dim * b) += JxW * S33 * N_X[a] * N_X[b];
                }
            }
        }
    }

  private:
    /// By direction, what an unknown of a node adds to the strains.
    using StrainRows = std::array<typename Symmetry::StrainRow, dim>;

    DEAL_II_ALWAYS_INLINE void find_rows()
    {
      for (unsigned int a = 0; a < n; ++a)
        {
          N[a] = *map * unit[a];
          for (unsigned int i = 0; i < dim; ++i)
            {
              for (unsigned int d = 0; d < dim; ++d)
                B[a][i][d] = F[i][d] * N[a][d];
              for (unsigned int k = dim; k < dim + n_shears; ++k)
                {
                  const auto [d, e] = Symmetry::components[k];
                  B[a][i][k]        = F[i][d] * N[a][e] + F[i][e] * N[a][d];
                }
            }
          if constexpr (Symmetry::has_hoop)
            {
              B[a][0][3] = f33 * N_X[a];
              B[a][1][3] = 0;
            }
        }
    }

    const Tensor<1, dim>             *unit;
    const Tensor<2, dim>             *map;
    unsigned int                      n;
    const double                     *N_X;
    Tensor<2, dim>                    F;
    double                            f33;
    SymmetricTensor<2, dim>           S;
    double                            S33;
    std::array<Tensor<1, dim>, n_max> N;
    std::array<StrainRows, n_max>     B;
  };
} // namespace Contact

#endif
