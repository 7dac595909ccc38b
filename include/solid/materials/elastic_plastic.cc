/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/materials/elastic_plastic.h"

#include <cmath>
#include <limits>

namespace Contact
{
  Hardening::Values Hardening::at(const double a) const
  {
    if (curve.empty())
      {
        const double decay = rate > 0 ? std::exp(-rate * a) : 1;
        return {initial + linear * a + saturation * (1 - decay),
                linear + saturation * rate * decay,
                0.5 * linear * a * a +
                  (rate > 0 ? saturation * (a - (1 - decay) / rate) : 0.)};
      }

    Values values{initial, 0, 0};
    for (unsigned int k = 1; k < curve.size(); ++k)
      {
        const auto [from, before] = curve[k - 1];
        const auto [to, after]    = curve[k];
        if (a < from)
          break;
        const double part = std::min(a, to) - from;
        values.slope      = a < to ? (after - before) / (to - from) : 0.;
        values.energy += part * (before - initial +
                                 0.5 * part * (after - before) / (to - from));
        values.stress = before + part * (after - before) / (to - from);
      }
    if (a > curve.back().first)
      values.energy +=
        (a - curve.back().first) * (curve.back().second - initial);
    return values;
  }



  ElasticPlastic::ElasticPlastic(const Material  &elastic,
                                 const Hardening &hardening,
                                 const bool       loads_on)
    : mu(elastic.mu)
    , bulk_modulus(elastic.lambda + 2. / 3 * elastic.mu)
    , hardening(hardening)
    , loads_on(loads_on)
    , at_first(hardening.at(0))
    , moduli_of_deviators(2 * elastic.mu * deviator_tensor<3>())
  {
  }



  MaterialLaw::Volume
  ElasticPlastic::volume(const SymmetricTensor<2, 3> &E) const
  {
    return {trace(E), unit_symmetric_tensor<3>()};
  }



  MaterialLaw::VolumeEnergy ElasticPlastic::volume_energy(const double d) const
  {
    return {0.5 * bulk_modulus * d * d, bulk_modulus * d, bulk_modulus};
  }



  unsigned int ElasticPlastic::n_history() const
  {
    return 1 + SymmetricTensor<2, 3>::n_independent_components;
  }



  // The solution x = da of q - (3 mu + H_k) x = Y(a + x), q = sqrt(3/2) |xi| of
  // the trial state. The left side falls, the right one does not: on a curve it
  // is in the first piece whose end the right side is above at; otherwise
  // Newton's method, kept between bounds. Newton's method would jump to and fro
  // over a steep piece between two flat ones.
  double ElasticPlastic::plastic_increment(const double q, const double a) const
  {
    const double stiffness = 3 * mu + hardening.kinematic;
    const auto  &curve     = hardening.curve;
    if (!curve.empty())
      {
        unsigned int k = 1;
        while (k < curve.size() &&
               (curve[k].first <= a ||
                q - stiffness * (curve[k].first - a) > curve[k].second))
          ++k;
        const auto [from, before] = curve[k - 1];
        const double slope = k < curve.size() ? (curve[k].second - before) /
                                                  (curve[k].first - from)
                                              : 0.;
        return (q - before - slope * (a - from)) / (stiffness + slope);
      }
    double low  = 0;
    double high = (q - hardening.at(a).stress) / stiffness;
    double x    = 0;
    while (true)
      {
        const auto   Y = hardening.at(a + x);
        const double r = q - stiffness * x - Y.stress;
        if (std::abs(r) <=
            4 * std::numeric_limits<double>::epsilon() * (q + Y.stress))
          return x;
        (r > 0 ? low : high) = x;
        x += r / (stiffness + Y.slope);
        if (x < low || x > high)
          x = 0.5 * (low + high);
      }
  }



  // The state that the increment would end in if it were elastic.
  struct ElasticPlastic::Trial
  {
    SymmetricTensor<2, 3> e;       // deviator of the strain
    SymmetricTensor<2, 3> plastic; // at the start
    SymmetricTensor<2, 3> xi;
    double                q_square; // 3/2 |xi|^2
    double                a;        // at the start
    Hardening::Values     Y;        // there

    // One that was returned before is on the surface but for round-off, and
    // elastic.
    bool is_elastic(const double mu) const
    {
      return q_square <= Y.stress * Y.stress ||
             std::sqrt(q_square) <= Y.stress + round_off(mu);
    }

    bool was_returned(const double mu) const
    {
      return a > 0 && std::abs(std::sqrt(q_square) - Y.stress) <= round_off(mu);
    }

    double round_off(const double mu) const
    {
      return 8 * std::numeric_limits<double>::epsilon() *
             (std::sqrt(q_square) + 3 * mu * (e.norm() + plastic.norm()));
    }
  };



  ElasticPlastic::Trial ElasticPlastic::trial(const SymmetricTensor<2, 3> &E,
                                              const double *history) const
  {
    Trial trial;
    trial.e = deviator(E);
    trial.a = history[0];
    for (unsigned int k = 0;
         k < SymmetricTensor<2, 3>::n_independent_components;
         ++k)
      trial.plastic.access_raw_entry(k) = history[1 + k];
    trial.xi = 2 * mu * trial.e -
               (2 * mu + 2. / 3 * hardening.kinematic) * trial.plastic;
    trial.q_square = 1.5 * (trial.xi * trial.xi);
    trial.Y        = trial.a == 0 ? at_first : hardening.at(trial.a);
    return trial;
  }



  struct ElasticPlastic::Return
  {
    SymmetricTensor<2, 3> e;       // deviator of the strain
    SymmetricTensor<2, 3> plastic; // at the start
    SymmetricTensor<2, 3> n;       // xi/|xi|
    double                q;       // sqrt(3/2) |xi| of the trial state
    double                a;       // at the start
    double                da;
    Hardening::Values     Y;      // at the end
    bool                  yields; // so is the tangent

    SymmetricTensor<2, 3> plastic_at_end() const
    {
      return plastic + std::sqrt(1.5) * da * n;
    }
  };



  ElasticPlastic::Return
  ElasticPlastic::return_to_surface(const SymmetricTensor<2, 3> &E,
                                    const double                *history) const
  {
    const Trial trial = this->trial(E, history);
    Return      state{};
    state.e               = trial.e;
    state.plastic         = trial.plastic;
    state.a               = trial.a;
    state.Y               = trial.Y;
    const bool is_elastic = trial.is_elastic(mu);
    state.yields          = !is_elastic || (loads_on && trial.was_returned(mu));
    if (!state.yields)
      return state;
    state.q = std::sqrt(trial.q_square);
    state.n = trial.xi / trial.xi.norm();
    if (is_elastic)
      return state;
    state.da = plastic_increment(state.q, state.a);
    state.Y  = hardening.at(state.a + state.da);
    return state;
  }



  bool ElasticPlastic::yields(const SymmetricTensor<2, 3> &E,
                              const double                *history) const
  {
    return !trial(E, history).is_elastic(mu);
  }



  SymmetricTensor<2, 3>
  ElasticPlastic::shear_stress(const SymmetricTensor<2, 3> &E,
                               const double                *history) const
  {
    const Trial trial = this->trial(E, history);
    if (trial.is_elastic(mu))
      return 2 * mu * (trial.e - trial.plastic);
    const Return state = return_to_surface(E, history);
    return 2 * mu * (state.e - state.plastic_at_end());
  }



  MaterialLaw::Response
  ElasticPlastic::shear_part(const SymmetricTensor<2, 3> &E,
                             const double                *history,
                             const bool                   with_tangent) const
  {
    const Return state   = return_to_surface(E, history);
    const auto   plastic = state.plastic_at_end();
    const auto   elastic = state.e - plastic;

    Response response;
    response.stress = 2 * mu * elastic;
    response.energy = mu * (elastic * elastic) + state.Y.energy +
                      hardening.kinematic / 3 * (plastic * plastic);
    if (!with_tangent)
      return response;
    response.tangent = moduli_of_deviators;
    if (state.yields)
      {
        const double turning = 3 * mu * state.da / state.q;
        const double along =
          3 * mu / (3 * mu + hardening.kinematic + state.Y.slope);
        response.tangent *= 1 - turning;
        response.tangent -=
          2 * mu * (along - turning) * outer_product(state.n, state.n);
      }
    return response;
  }



  void ElasticPlastic::advance(const SymmetricTensor<2, 3> &E,
                               double                      *history) const
  {
    const Return state   = return_to_surface(E, history);
    const auto   plastic = state.plastic_at_end();
    history[0]           = state.a + state.da;
    for (unsigned int k = 1; k < n_history(); ++k)
      history[k] = plastic.access_raw_entry(k - 1);
  }



  // With the hardening part R = Y - Y_0 of the yield stress
  //   path = 1/2 (xi_1 - xi_0) : (e_p1 - e_p0) + (integral of R) - R_1 da.
  MaterialLaw::Works ElasticPlastic::works(const SymmetricTensor<2, 3> &E_0,
                                           const SymmetricTensor<2, 3> &E_1,
                                           const double *history) const
  {
    const Return state = return_to_surface(E_1, history);
    Works        works;
    works.trapezoid =
      mu * ((deviator(E_0) + state.e - state.plastic - state.plastic_at_end()) *
            (E_1 - E_0));
    if (state.da == 0)
      return works;
    const auto   before = hardening.at(state.a);
    const auto   after  = hardening.at(state.a + state.da);
    const double back   = 2. / 3 * hardening.kinematic;
    const auto xi_0 = 2 * mu * deviator(E_0) - (2 * mu + back) * state.plastic;
    const auto xi_1 = std::sqrt(2. / 3) * after.stress * state.n;
    works.dissipation = hardening.initial * state.da;
    works.path = 0.5 * std::sqrt(1.5) * state.da * ((xi_1 - xi_0) * state.n) +
                 after.energy - before.energy -
                 (after.stress - hardening.initial) * state.da;
    return works;
  }
} // namespace Contact
