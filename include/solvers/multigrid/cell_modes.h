/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cell_modes_h
#define contact_cell_modes_h

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solid/cell_tables.h"

namespace Contact
{
  using namespace dealii;

  /**
   * What the cells of MatrixFree assume of their strains E as a whole has the
   * stress
   *   sum_m alpha_m sigma_m,   alpha_m = s sum_q JxW sigma_m : E.
   * Of a projected dilatation the modes sigma_m are sqrt(lambda) phi_m 1 and
   * the sign s is 1; of incompatible modes, which soften a cell, they are their
   * stresses and s is -1 (see Elasticity and CellIntegrals). A batch of which
   * no cell has modes costs nothing; cells without beside others have zeros.
   */
  template<int dim, typename Numbers>
  class CellModes
  {
  public:
    using Stress     = SymmetricTensor<2, dim, Numbers>;
    using Amplitudes = std::array<Numbers, dim * dim>;

    /// @p n_modes is the largest number of a cell.
    void reinit(const unsigned int n_batches,
                const unsigned int n_points,
                const unsigned int n_modes)
    {
      this->n_points = n_points;
      this->n_modes  = n_modes;
      sign.resize(n_batches);
      begin.assign(n_batches, none);
    }

    /// The modes of the cell @p v of a batch, if the table has any.
    void set(const unsigned int    batch,
             const unsigned int    v,
             const CellTable<dim> &cell)
    {
      for (unsigned int q = 0; q < cell.modes.size(); ++q)
        for (unsigned int m = 0; m < std::min<unsigned int>(n_modes, dim + 1);
             ++m)
          set(batch,
              v,
              q,
              m,
              std::sqrt(cell.material->lambda) * cell.modes[q][m] *
                unit_symmetric_tensor<3>());
      for (unsigned int q = 0; q < cell.stress_modes.size(); ++q)
        for (unsigned int m = 0; m < n_modes; ++m)
          set(batch, v, q, m, cell.stress_modes[q][m]);
      sign[batch][v] = cell.stress_modes.empty() ? 1 : -1;
    }

    /// The number in a batch of cells.
    unsigned int size(const unsigned int batch) const
    {
      return begin[batch] == none ? 0 : n_modes;
    }

    /// sigma_m in the point @p q.
    const Stress &stress(const unsigned int batch,
                         const unsigned int q,
                         const unsigned int m) const
    {
      return stresses[begin[batch] + q * n_modes + m];
    }

    /// alpha_m, of strains by point. The evaluation @p u has JxW.
    template<class Evaluation, class Strain>
    Amplitudes amplitudes(const unsigned int batch,
                          const Evaluation  &u,
                          const Strain      &strain) const
    {
      Amplitudes result{};
      if (size(batch) == 0)
        return result;
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const Stress E = strain(q) * (u.JxW(q) * sign[batch]);
          for (unsigned int m = 0; m < n_modes; ++m)
            result[m] += stress(batch, q, m) * E;
        }
      return result;
    }

    /// sum_m alpha_m sigma_m.
    void add_stress(const unsigned int batch,
                    const unsigned int q,
                    const Amplitudes  &amplitudes,
                    Stress            &result) const
    {
      for (unsigned int m = 0; m < size(batch); ++m)
        result += amplitudes[m] * stress(batch, q, m);
    }

    /// s sum_m a_m b_m: the product of integrals of sigma_m : E.
    Numbers product(const unsigned int batch,
                    const Amplitudes  &a,
                    const Amplitudes  &b) const
    {
      Numbers sum = Numbers();
      for (unsigned int m = 0; m < size(batch); ++m)
        sum += a[m] * b[m];
      return sign[batch] * sum;
    }

  private:
    static constexpr std::size_t none = -1;

    void set(const unsigned int           batch,
             const unsigned int           v,
             const unsigned int           q,
             const unsigned int           m,
             const SymmetricTensor<2, 3> &of_cell)
    {
      if (begin[batch] == none)
        {
          begin[batch] = stresses.size();
          stresses.resize(stresses.size() + n_points * n_modes);
        }
      Stress &mode = stresses[begin[batch] + q * n_modes + m];
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          mode[i][j][v] = of_cell[i][j];
    }

    unsigned int             n_points = 0, n_modes = 0;
    AlignedVector<Numbers>   sign;     // s, by batch
    AlignedVector<Stress>    stresses; // of batches that have modes
    std::vector<std::size_t> begin;    // of them by batch, or none
  };
} // namespace Contact

#endif
