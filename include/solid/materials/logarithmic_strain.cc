/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/materials/logarithmic_strain.h"

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "solid/materials/neo_hookean.h"

namespace Contact
{
  // (1/b) log1p(z)/z with z = (a - b)/b, which is smooth at 0.
  double divided_logarithm(const double a, const double b)
  {
    const double z = (a - b) / b;
    return z == 0 ? 1 / b : std::log1p(z) / z / b;
  }



  // With b between a and c, x = (a - b)/b and y = (c - b)/b
  //   b^2 ln[a, b, c] = sum_k>0 (-1)^k/(k + 1) (x^k - y^k)/(x - y),
  // which takes the place of the difference where that would lose digits; the
  // quotients by s_1 = 1, s_k+1 = x s_k + y^k.
  double divided_logarithm(double a, double b, double c)
  {
    if (a < b)
      std::swap(a, b);
    if (b < c)
      std::swap(b, c);
    if (a < b)
      std::swap(a, b);
    const double x = (a - b) / b, y = (c - b) / b;

    const double loses_a_digit = 0.1;
    if (x - y > loses_a_digit)
      return (divided_logarithm(a, b) - divided_logarithm(b, c)) / (a - c);
    double       sum = 0, quotient = 1, power_of_y = y, sign = -1;
    unsigned int k = 1;
    // The quotients are at most k (x - y)^(k-1).
    for (double bound = 1; bound > std::numeric_limits<double>::epsilon();
         bound *= x - y)
      {
        sum += sign * quotient / (k + 1);
        quotient = x * quotient + power_of_y;
        power_of_y *= y;
        sign = -sign;
        ++k;
      }
    return sum / (b * b);
  }



  namespace
  {
    constexpr unsigned int n_components =
      SymmetricTensor<2, 3>::n_independent_components;

    using Pair = std::pair<unsigned int, unsigned int>;
    constexpr std::array<Pair, n_components> pairs{
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

    /// A tensor of the fourth order by the components of its pairs.
    using PairMatrix = Tensor<2, n_components>;



    PairMatrix by_components(const SymmetricTensor<4, 3> &A)
    {
      PairMatrix moduli;
      for (unsigned int m = 0; m < n_components; ++m)
        for (unsigned int n = 0; n < n_components; ++n)
          moduli[m][n] =
            A[pairs[m].first][pairs[m].second][pairs[n].first][pairs[n].second];
      return moduli;
    }



    SymmetricTensor<4, 3> by_indices(const PairMatrix &moduli)
    {
      SymmetricTensor<4, 3> A;
      for (unsigned int m = 0; m < n_components; ++m)
        for (unsigned int n = 0; n < n_components; ++n)
          A[pairs[m].first][pairs[m].second][pairs[n].first][pairs[n].second] =
            moduli[m][n];
      return A;
    }



    SymmetricTensor<2, 3> turned(const Tensor<2, 3>          &Q,
                                 const SymmetricTensor<2, 3> &X)
    {
      return symmetrize(Q * static_cast<Tensor<2, 3>>(X) * transpose(Q));
    }



    /// The same of moduli: R A R^T, R by what Q X Q^T is of each component of
    /// X, which stands for both places of a shear.
    PairMatrix turned(const Tensor<2, 3> &Q, const PairMatrix &A)
    {
      PairMatrix R;
      for (unsigned int m = 0; m < n_components; ++m)
        for (unsigned int n = 0; n < n_components; ++n)
          {
            const auto [i, j] = pairs[m];
            const auto [k, l] = pairs[n];
            R[m][n]           = Q[i][k] * Q[j][l];
            if (k != l)
              R[m][n] += Q[i][l] * Q[j][k];
          }
      return R * A * transpose(R);
    }



    /// The eigenvectors of E, and by them e(E) and its derivatives.
    class Spectrum
    {
    public:
      explicit Spectrum(const SymmetricTensor<2, 3> &E)
      {
        const auto system =
          eigenvectors(E, SymmetricTensorEigenvectorMethod::jacobi);
        for (unsigned int i = 0; i < 3; ++i)
          {
            const double x = std::max(2 * system[i].first, nothing);
            e[i]           = 0.5 * std::log1p(x);
            c[i]           = 1 + x;
            for (unsigned int k = 0; k < 3; ++k)
              Q[k][i] = system[i].second[k];
          }
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            f[i][j] = divided_logarithm(c[i], c[j]);
      }

      SymmetricTensor<2, 3> strain() const
      {
        SymmetricTensor<2, 3> along;
        for (unsigned int i = 0; i < 3; ++i)
          along[i][i] = e[i];
        return turned(Q, along);
      }

      /// T : P.
      SymmetricTensor<2, 3> stress(const SymmetricTensor<2, 3> &T) const
      {
        SymmetricTensor<2, 3> along = turned(transpose(Q), T);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            along[i][j] *= f[i][j];
        return turned(Q, along);
      }

      /// P : D : P + T : L, of which the latter is
      ///   X : T : L : Y = 2 sum_ijk f_ijk T_ij X_ik Y_jk.
      SymmetricTensor<4, 3> moduli(const SymmetricTensor<4, 3> &D,
                                   const SymmetricTensor<2, 3> &T) const
      {
        PairMatrix along = turned(transpose(Q), by_components(D));
        for (unsigned int m = 0; m < n_components; ++m)
          for (unsigned int n = 0; n < n_components; ++n)
            along[m][n] *= f[pairs[m].first][pairs[m].second] *
                           f[pairs[n].first][pairs[n].second];
        if (T.norm() > 0)
          add_turning(turned(transpose(Q), T), along);
        return by_indices(turned(Q, along));
      }

    private:
      /// Add T : L, symmetric in each pair of indices.
      void add_turning(const SymmetricTensor<2, 3> &T, PairMatrix &moduli) const
      {
        Tensor<3, 3> F; // 2 f_ijk T_ij / 4
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            for (unsigned int k = 0; k < 3; ++k)
              F[i][j][k] = F[j][i][k] =
                divided_logarithm(c[i], c[j], c[k]) * T[i][j];
        for (unsigned int m = 0; m < n_components; ++m)
          for (unsigned int n = 0; n < n_components; ++n)
            {
              const auto [i, k] = pairs[m];
              const auto [j, l] = pairs[n];
              moduli[m][n] +=
                (k == l ? F[i][j][k] : 0.) + (i == l ? F[k][j][i] : 0.) +
                (k == j ? F[i][l][k] : 0.) + (i == j ? F[k][l][i] : 0.);
            }
      }

      /// Round-off of a cell that has become flat, and is refused, is not to
      /// have the logarithm of a number below zero.
      static constexpr double nothing =
        std::numeric_limits<double>::epsilon() - 1;

      Tensor<2, 3>          Q; // columns are eigenvectors
      std::array<double, 3> c, e;
      SymmetricTensor<2, 3> f;
    };



    SymmetricTensor<2, 3> inverse(const SymmetricTensor<2, 3> &E)
    {
      return invert(2 * E + unit_symmetric_tensor<3>());
    }
  } // namespace



  LogarithmicStrain::LogarithmicStrain(std::unique_ptr<const MaterialLaw> law)
    : law(std::move(law))
  {
  }



  MaterialLaw::Response
  LogarithmicStrain::shear_part(const SymmetricTensor<2, 3> &E,
                                const double                *history,
                                const bool                   with_tangent) const
  {
    const Spectrum spectrum(E);
    Response       response =
      law->shear_part(spectrum.strain(), history, with_tangent);
    if (with_tangent)
      response.tangent = spectrum.moduli(response.tangent, response.stress);
    response.stress = spectrum.stress(response.stress);
    return response;
  }



  SymmetricTensor<2, 3>
  LogarithmicStrain::shear_stress(const SymmetricTensor<2, 3> &E,
                                  const double                *history) const
  {
    const Spectrum spectrum(E);
    return spectrum.stress(law->shear_stress(spectrum.strain(), history));
  }



  SymmetricTensor<4, 3>
  LogarithmicStrain::moduli_without_stress(const SymmetricTensor<2, 3> &E,
                                           const double *history) const
  {
    const Spectrum spectrum(E);
    const auto     response =
      law->shear_part(spectrum.strain(), history, /*with_tangent=*/true);
    return spectrum.moduli(response.tangent, SymmetricTensor<2, 3>());
  }



  // ln J by the invariants of E, without a difference of numbers near one.
  MaterialLaw::Volume
  LogarithmicStrain::volume(const SymmetricTensor<2, 3> &E) const
  {
    const double tr       = trace(E);
    const double det_less = 2 * tr + 2 * (tr * tr - E * E) + 8 * determinant(E);
    const double nothing  = std::numeric_limits<double>::epsilon() - 1;
    return {0.5 * std::log1p(std::max(det_less, nothing)), inverse(E)};
  }



  SymmetricTensor<4, 3>
  LogarithmicStrain::volume_curvature(const SymmetricTensor<2, 3> &E) const
  {
    return -2 * inverse_twice(inverse(E));
  }



  MaterialLaw::VolumeEnergy
  LogarithmicStrain::volume_energy(const double d) const
  {
    return law->volume_energy(d);
  }



  double LogarithmicStrain::volume_ratio(const double d) const
  {
    return std::exp(d);
  }



  unsigned int LogarithmicStrain::n_history() const
  {
    return law->n_history();
  }



  void LogarithmicStrain::advance(const SymmetricTensor<2, 3> &E,
                                  double                      *history) const
  {
    law->advance(Spectrum(E).strain(), history);
  }



  MaterialLaw::Works LogarithmicStrain::works(const SymmetricTensor<2, 3> &E_0,
                                              const SymmetricTensor<2, 3> &E_1,
                                              const double *history) const
  {
    return law->works(Spectrum(E_0).strain(), Spectrum(E_1).strain(), history);
  }
} // namespace Contact
