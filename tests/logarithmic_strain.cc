/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// A law between two spectral decompositions, at a point; in bodies
// tests/materials.cc has it:
//  - second divided differences of the logarithm are those of an integral, also
//    where arguments coincide or nearly so;
//  - with three, two and one different eigenvalues, exactly or nearly, elastic
//    and yielding, from a history along other axes: stress and pressure are
//    derivatives of what is stored and dissipated, the moduli those of the
//    stress, the moduli without stress positive semidefinite;
//  - rigid rotations after the motion turn the true stress, before the motion
//    nothing else than the axes of the history;
//  - stretched to and fro up to e^1 along any axis and without volume change,
//    the true stress is that of the law by the logarithm of the stretch;
//  - where it loads on, the moduli at the start of an increment are those of
//    the stress as it grows;
//  - the energy of a strain of 1e-9 has its digits.

#include "solid/materials/logarithmic_strain.h"

#include <deal.II/base/point.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/physics/transformations.h>

#include <cmath>

#include "solid/materials/elastic_plastic.h"
#include "tests.h"

using namespace Tests;

namespace
{
  using Strain = SymmetricTensor<2, 3>;

  const Material  elastic(1000, 0.3);
  const Hardening hardening{10, 50, 10, 40, 30};



  LogarithmicStrain make_law(const Hardening &hardening)
  {
    return LogarithmicStrain(
      std::make_unique<ElasticPlastic>(elastic, hardening));
  }



  // With s = exp(r)
  //   ln[a, b, c] = - integral of 1/((a + s) (b + s) (c + s)) ds from 0,
  // whose integrand falls by exponents at both ends: by the trapezoidal rule.
  double integrated(const double a, const double b, const double c)
  {
    double       sum  = 0;
    const double step = 0.05;
    for (int k = -900; k <= 900; ++k)
      {
        const double s = std::exp(k * step);
        sum -= step * s / ((a + s) * (b + s) * (c + s));
      }
    return sum;
  }



  void divided_differences()
  {
    headline("divided differences");
    double error = 0;
    for (const double scale : {1e-4, 1., 30.})
      for (const double b : {0., 1e-15, 1e-9, 1e-4, 0.01, 0.06, 0.3, 2., 50.})
        for (const double c : {0., 1e-12, 1e-4, 0.03, 0.0999, 0.1001, 5.})
          {
            const double x = scale, y = scale * (1 + b), z = scale * (1 + c);
            const double exact = integrated(x, y, z);
            for (const double found : {divided_logarithm(x, y, z),
                                       divided_logarithm(z, x, y),
                                       divided_logarithm(y, z, x)})
              error = std::max(error, std::abs(found / exact - 1));
          }
    check_small("of three numbers", error, 1e-13);
    check_small("of equal ones",
                std::abs(divided_logarithm(2, 2, 2) + 0.125) +
                  std::abs(divided_logarithm(2, 2) - 0.5),
                1e-15);
  }



  Strain strain(const std::array<double, 6> &components)
  {
    Strain E;
    for (unsigned int k = 0; k < 6; ++k)
      E.access_raw_entry(k) = components[k];
    return E;
  }



  Tensor<2, 3> any_rotation(const double angle)
  {
    return static_cast<Tensor<2, 3>>(
      Physics::Transformations::Rotations::rotation_matrix_3d(
        Tensor<1, 3>({1, -2, 0.5}) / std::sqrt(5.25),
        angle));
  }



  Strain turned(const Tensor<2, 3> &R, const Strain &E)
  {
    return symmetrize(R * static_cast<Tensor<2, 3>>(E) * transpose(R));
  }



  Strain strain_of(const Tensor<2, 3> &F)
  {
    return 0.5 * (symmetrize(transpose(F) * F) - unit_symmetric_tensor<3>());
  }



  /// The history at the end of an increment.
  std::vector<double> after(const MaterialLaw         &law,
                            const Strain              &E,
                            const std::vector<double> &history)
  {
    auto end = history;
    law.advance(E, end.data());
    return end;
  }



  Strain stress(const MaterialLaw         &law,
                const Strain              &E,
                const std::vector<double> &history)
  {
    const auto volume = law.volume(E);
    return law.shear_stress(E, history.data()) +
           law.volume_energy(volume.value).pressure * volume.slope;
  }



  SymmetricTensor<4, 3> moduli(const MaterialLaw         &law,
                               const Strain              &E,
                               const std::vector<double> &history)
  {
    const auto volume = law.volume(E);
    const auto U      = law.volume_energy(volume.value);
    return law.shear_part(E, history.data(), true).tangent +
           U.modulus * outer_product(volume.slope, volume.slope) +
           U.pressure * law.volume_curvature(E);
  }



  /// The work that is stored, and dissipated since @p history.
  double work(const MaterialLaw         &law,
              const Strain              &E,
              const std::vector<double> &history)
  {
    return law.shear_part(E, history.data(), false).energy +
           law.volume_energy(law.volume(E).value).energy +
           hardening.initial * (after(law, E, history)[0] - history[0]);
  }



  /// The least eigenvalue of moduli by the largest one.
  double least_eigenvalue(const SymmetricTensor<4, 3> &A)
  {
    LAPACKFullMatrix<double> matrix(6, 6);
    for (unsigned int m = 0; m < 6; ++m)
      for (unsigned int n = 0; n < 6; ++n)
        {
          const auto i = Strain::unrolled_to_component_indices(m);
          const auto j = Strain::unrolled_to_component_indices(n);
          matrix(m, n) = A[i[0]][i[1]][j[0]][j[1]] *
                         (m < 3 ? 1 : std::sqrt(2.)) *
                         (n < 3 ? 1 : std::sqrt(2.));
        }
    Vector<double>     values;
    FullMatrix<double> vectors;
    matrix.compute_eigenvalues_symmetric(-1e20, 1e20, 0, values, vectors);
    return values[0] / values[5];
  }



  void derivatives()
  {
    headline("derivatives");
    const auto                law = make_law(hardening);
    const std::vector<double> first(law.n_history());
    const Strain              before =
      turned(any_rotation(0.4), strain({0.3, -0.1, -0.1, 0.2, 0, 0}));
    double       of_stress = 0, of_moduli = 0, least = 0, asymmetry = 0;
    unsigned int n_yielding = 0, n_elastic = 0;
    for (const bool has_history : {false, true})
      for (const double size : {0.002, 0.3})
        for (const auto &l : {Point<3>(1, 1, 1),
                              Point<3>(1, -0.5, -0.5),
                              Point<3>(1, -0.5, -0.5 + 1e-9),
                              Point<3>(1, -0.5, -0.5 + 1e-5),
                              Point<3>(1, 1 + 1e-11, 1 - 1e-6),
                              Point<3>(1, -0.4, 0.2),
                              Point<3>(3, -1.2, 0.2)})
          {
            const auto history =
              has_history ? after(law, before, first) : first;
            Strain E;
            for (unsigned int i = 0; i < 3; ++i)
              E[i][i] = size * l[i];
            E = turned(any_rotation(1.1), E);
            if (has_history && size < 0.1)
              E += before;
            (after(law, E, history)[0] > history[0] ? n_yielding : n_elastic)++;

            const auto   S     = stress(law, E, history);
            const auto   A     = moduli(law, E, history);
            const double h     = 1e-5;
            const double scale = std::max(S.norm(), hardening.initial);
            for (unsigned int m = 0; m < 6; ++m)
              {
                const auto index = Strain::unrolled_to_component_indices(m);
                Strain     low = E, high = E;
                low[index] -= h;
                high[index] += h;
                const double slope =
                  (work(law, high, history) - work(law, low, history)) /
                  (2 * h);
                of_stress =
                  std::max(of_stress,
                           std::abs(slope - (m < 3 ? 1 : 2) * S[index]) /
                             scale);
                const auto change =
                  (stress(law, high, history) - stress(law, low, history)) /
                  (2 * h);
                for (unsigned int n = 0; n < 6; ++n)
                  {
                    const auto other = Strain::unrolled_to_component_indices(n);
                    of_moduli =
                      std::max(of_moduli,
                               std::abs(
                                 change[other] -
                                 (m < 3 ? 1 : 2) *
                                   A[other[0]][other[1]][index[0]][index[1]]) /
                                 A.norm());
                    asymmetry =
                      std::max(asymmetry,
                               std::abs(
                                 A[other[0]][other[1]][index[0]][index[1]] -
                                 A[index[0]][index[1]][other[0]][other[1]]) /
                                 A.norm());
                  }
              }
            least = std::min(least,
                             least_eigenvalue(
                               law.moduli_without_stress(E, history.data())));
          }
    check("elastic and yielding", n_yielding > 5 && n_elastic > 5);
    check_small("stress against differences of the work", of_stress, 1e-7);
    check_small("moduli against those of the stress", of_moduli, 1e-7);
    check_small("asymmetry", asymmetry, 1e-14);
    check_small("least eigenvalue without stress", -least, 1e-14);
  }



  Strain cauchy(const MaterialLaw         &law,
                const Tensor<2, 3>        &F,
                const std::vector<double> &history)
  {
    return turned(F, stress(law, strain_of(F), history)) / determinant(F);
  }



  void rotations()
  {
    headline("rotations");
    const auto                law = make_law(hardening);
    const std::vector<double> first(law.n_history());
    Tensor<2, 3> G     = static_cast<Tensor<2, 3>>(unit_symmetric_tensor<3>());
    G[0][1]            = 0.7;
    Tensor<2, 3> F     = G;
    F[2][0]            = -0.4;
    F[1][1]            = 1.5;
    const auto history = after(law, strain_of(G), first);
    const auto sigma   = cauchy(law, F, history);
    const auto R       = any_rotation(2.1);
    check_small("after the motion",
                (cauchy(law, R * F, history) - turned(R, sigma)).norm() /
                  sigma.norm(),
                1e-13);
    const auto along = after(law, strain_of(G * transpose(R)), first);
    check_small("before the motion",
                (cauchy(law, F * transpose(R), along) - sigma).norm() /
                  sigma.norm(),
                1e-13);
  }



  // The true stress along the stretch minus that across is |.| = Y(a) + back
  // stress, both those of a bar in small strain with the strain ln(stretch).
  void stretched()
  {
    headline("stretch to and fro");
    const auto           law = make_law(hardening);
    const ElasticPlastic small(elastic, hardening);
    const auto           R = any_rotation(0.7);
    std::vector<double>  history(law.n_history()), of_small(history);
    double               error = 0;
    for (const double e : {0.005, 0.4, 1., 0.98, 0.5, -0.7, 0.3})
      {
        Strain       along;
        Tensor<2, 3> F;
        for (unsigned int i = 0; i < 3; ++i)
          {
            along[i][i] = i == 0 ? e : -0.5 * e;
            F[i][i]     = std::exp(along[i][i]);
          }
        const auto sigma = cauchy(law, F * transpose(R), history);
        const auto T     = small.shear_stress(along, of_small.data());
        error            = std::max(error, (sigma - T).norm() / T.norm());
        law.advance(strain_of(F * transpose(R)), history.data());
        small.advance(along, of_small.data());
        error = std::max(error, std::abs(history[0] - of_small[0]));
      }
    check_small("error", error, 1e-12);
  }



  // A difference to one side, by a way that is long beside the round-off of the
  // yield stress.
  void loads_on()
  {
    headline("moduli as the stress grows");
    const Strain E =
      turned(any_rotation(0.4), strain({0.3, -0.1, -0.1, 0.2, 0, 0}));
    const Strain way = 1e-7 * E;
    for (const bool loads_on : {true, false})
      {
        const LogarithmicStrain law(
          std::make_unique<ElasticPlastic>(elastic, hardening, loads_on));
        const auto history =
          after(law, E, std::vector<double>(law.n_history()));
        const Strain change =
          stress(law, E + way, history) - stress(law, E, history);
        const double error =
          (change - moduli(law, E, history) * way).norm() / change.norm();
        if (loads_on)
          check_small("error", error, 1e-5);
        else
          check("else elastic ones", error > 0.1);
      }
  }



  // W = mu e : e + lambda/2 tr(e)^2 with e = E - E . E + ...
  void tiny()
  {
    headline("tiny strains");
    const auto                law = make_law(hardening);
    const std::vector<double> history(law.n_history());
    const double              size = 1e-9;
    const Strain              E    = size * strain({2, -1, 0.5, 3, -2, 0.7});
    const Strain              e = E - symmetrize(static_cast<Tensor<2, 3>>(E) *
                                    static_cast<Tensor<2, 3>>(E));
    const double              exact =
      elastic.mu * (e * e) + 0.5 * elastic.lambda * trace(e) * trace(e);
    check_small("energy", std::abs(work(law, E, history) / exact - 1), 1e-13);
  }
} // namespace



int main()
{
  divided_differences();
  derivatives();
  rotations();
  stretched();
  loads_on();
  tiny();
  return 0;
}
