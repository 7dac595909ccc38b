/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cell_tangent_h
#define contact_cell_tangent_h

#include <array>
#include <boost/container/static_vector.hpp>

#include "solid/cell_point.h"

namespace Contact
{
  using namespace dealii;

  /// The moduli at a point of a linear elastic body, applied to a row: JxW D
  /// B_a.
  template<class Symmetry>
  struct IsotropicModuli
  {
    using Row = typename Symmetry::StrainRow;
    double JxW, lambda, mu;

    DEAL_II_ALWAYS_INLINE Row operator()(const Row &B) const
    {
      Row          DB;
      const double tr = lambda * Symmetry::trace(B);
      for (unsigned int d = 0; d < Symmetry::dim; ++d)
        DB[d] = JxW * (tr + 2 * mu * B[d]);
      for (unsigned int k = Symmetry::dim; k < Symmetry::components.size(); ++k)
        DB[k] = JxW * mu * B[k];
      if constexpr (Symmetry::has_hoop)
        DB[3] = JxW * (tr + 2 * mu * B[3]);
      return DB;
    }
  };



  /// Those of any other.
  template<class Symmetry>
  class Moduli
  {
  public:
    using Row = typename Symmetry::StrainRow;

    Moduli(const double JxW, const SymmetricTensor<4, 3> &moduli)
    {
      for (unsigned int k = 0; k < D.size(); ++k)
        for (unsigned int l = 0; l < D.size(); ++l)
          {
            const auto [i, j] = indices(k);
            const auto [r, s] = indices(l);
            D[k][l]           = JxW * moduli[i][j][r][s];
          }
    }

    DEAL_II_ALWAYS_INLINE Row operator()(const Row &B) const
    {
      Row DB;
      for (unsigned int k = 0; k < B.size(); ++k)
        {
          double sum = 0;
          for (unsigned int l = 0; l < B.size(); ++l)
            sum += D[k][l] * B[l];
          DB[k] = sum;
        }
      return DB;
    }

  private:
    /// Of the strains that vary.
    static std::array<unsigned int, 2> indices(const unsigned int k)
    {
      return k < Symmetry::components.size()
               ? Symmetry::components[k]
               : std::array<unsigned int, 2>{{2, 2}};
    }

    std::array<Row, std::tuple_size<Row>::value> D;
  };



  /// Stresses T_m of a cell and what they add to its tangent, see
  /// CellIntegrals: sum_mn H_mn g_m g_n^T.
  template<class Kinematics, class Symmetry>
  class StressFields
  {
  public:
    static constexpr int dim = Symmetry::dim;

    explicit StressFields(const CellTable<dim> &cell)
      : cell(cell)
      , projected(!cell.modes.empty())
      , fields(projected                   ? dim + 1
               : cell.stress_modes.empty() ? 0
                                           : dim * dim)
    {
      if (!projected)
        for (unsigned int m = 0; m < fields.size(); ++m)
          fields[m].H[m] = -1;
    }

    /// Add a point with dd/dE = @p slope and U'' = @p modulus.
    void add(const unsigned int               q,
             const SymmetricTensor<2, 3>     &slope,
             const double                     modulus,
             CellPoint<Kinematics, Symmetry> &at)
    {
      for (unsigned int m = 0; m < fields.size(); ++m)
        {
          at.set_stress(projected ? cell.modes[q][m] * slope
                                  : cell.stress_modes[q][m]);
          at.add_forces(fields[m].g);
          if (projected)
            for (unsigned int l = 0; l < fields.size(); ++l)
              fields[m].H[l] +=
                at.JxW * modulus * cell.modes[q][m] * cell.modes[q][l];
        }
    }

    /// Add them to the upper half.
    void add_to(FullMatrix<double> &tangent) const
    {
      for (const Field &field : fields)
        for (unsigned int i = 0; i < tangent.m(); ++i)
          {
            double Hg = 0;
            for (unsigned int l = 0; l < fields.size(); ++l)
              Hg += field.H[l] * fields[l].g[i];
            for (unsigned int j = i; j < tangent.m(); ++j)
              tangent(i, j) += Hg * field.g[j];
          }
    }

  private:
    struct Field
    {
      std::array<double, dim * CellPoint<Kinematics, Symmetry>::n_max> g{};
      std::array<double, dim * dim>                                    H{};
    };

    const CellTable<dim>                             &cell;
    const bool                                        projected;
    boost::container::static_vector<Field, dim * dim> fields;
  };
} // namespace Contact

#endif
