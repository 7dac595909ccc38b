/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "closed_forms/concentric_cylinders.h"

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <cmath>

namespace Contact
{
  namespace
  {
    /// The directions of r and theta in a point; any in the origin.
    struct PolarFrame
    {
      explicit PolarFrame(const Point<2> &X)
        : r(X.norm())
        , theta(std::atan2(X[1], X[0]))
        , e_r(Point<2>(std::cos(theta), std::sin(theta)))
        , e_t(Point<2>(-std::sin(theta), std::cos(theta)))
      {
      }

      const double       r, theta;
      const Tensor<1, 2> e_r, e_t;
    };
  } // namespace



  double ConcentricCylinders::Ring::Term::stress_scale(const double r) const
  {
    return amplitude * std::pow(r / radius, power);
  }



  double
  ConcentricCylinders::Ring::Term::displacement_scale(const double r) const
  {
    return amplitude * radius * std::pow(r / radius, power + 1);
  }



  ConcentricCylinders::Ring::Ring(const double    inner_radius,
                                  const double    outer_radius,
                                  const Material &material)
    : inner_radius(inner_radius)
    , outer_radius(outer_radius)
    , shear_modulus(material.youngs_modulus / (2 * (1 + material.poisson)))
  {
    // Of r^2, ln r and of r^2, r^4, r^-2, 1 times cos(2 theta).
    const double            kappa = 3 - 4 * material.poisson;
    const std::vector<Term> michell{{0, 0, 2, 0, 2, kappa - 1, 0},
                                    {0, -2, 1, 0, -1, -1, 0},
                                    {1, 0, -2, 2, 2, -2, 2},
                                    {1, 2, 0, 6, 12, kappa - 3, kappa + 3},
                                    {1, -4, -6, -6, 6, 2, 2},
                                    {1, -2, -4, -2, 0, kappa + 1, 1 - kappa}};

    // Every term is of order one on the circle where it is largest: the
    // smallest of holes leaves the amplitudes well conditioned.
    for (Term term : michell)
      if (term.power >= 0 || inner_radius > 0)
        {
          term.radius = term.power >= 0 ? outer_radius : inner_radius;
          terms.push_back(term);
        }
  }



  void ConcentricCylinders::Ring::load(const Harmonics &inner_pressure,
                                       const Harmonics &outer_pressure)
  {
    // On every circle three tractions are given: both harmonics of the normal
    // one, and the shear, which has only the second.
    FullMatrix<double> tractions(terms.size());
    Vector<double>     given(terms.size());
    unsigned int       row  = 0;
    const auto add_a_circle = [&](const double r, const Harmonics &pressure) {
      for (unsigned int t = 0; t < terms.size(); ++t)
        {
          terms[t].amplitude                    = 1;
          const double scale                    = terms[t].stress_scale(r);
          tractions(row + terms[t].harmonic, t) = scale * terms[t].stress_rr;
          tractions(row + 2, t)                 = scale * terms[t].stress_rt;
        }
      given[row]     = -pressure[0];
      given[row + 1] = -pressure[1];
      row += 3;
    };
    add_a_circle(outer_radius, outer_pressure);
    if (inner_radius > 0)
      add_a_circle(inner_radius, inner_pressure);

    Vector<double> amplitudes(terms.size());
    tractions.gauss_jordan();
    tractions.vmult(amplitudes, given);
    for (unsigned int t = 0; t < terms.size(); ++t)
      terms[t].amplitude = amplitudes[t];
  }



  ConcentricCylinders::Harmonics
  ConcentricCylinders::Ring::radial_displacement(const double r) const
  {
    Harmonics u_r{};
    for (const Term &term : terms)
      u_r[term.harmonic] +=
        term.displacement_scale(r) * term.u_r / (2 * shear_modulus);
    return u_r;
  }



  Tensor<1, 2> ConcentricCylinders::Ring::displacement(const Point<2> &X) const
  {
    const PolarFrame frame(X);
    Tensor<1, 2>     u;
    for (const Term &term : terms)
      {
        const double angle = 2 * term.harmonic * frame.theta;
        u += term.displacement_scale(frame.r) *
             (term.u_r * std::cos(angle) * frame.e_r +
              term.u_t * std::sin(angle) * frame.e_t);
      }
    return u / (2 * shear_modulus);
  }



  SymmetricTensor<2, 2>
  ConcentricCylinders::Ring::stress(const Point<2> &X) const
  {
    const PolarFrame frame(X);
    Tensor<2, 2>     stress;
    for (const Term &term : terms)
      {
        const double angle = 2 * term.harmonic * frame.theta;
        stress +=
          term.stress_scale(frame.r) * (term.stress_rr * std::cos(angle) *
                                          outer_product(frame.e_r, frame.e_r) +
                                        term.stress_tt * std::cos(angle) *
                                          outer_product(frame.e_t, frame.e_t) +
                                        2 * term.stress_rt * std::sin(angle) *
                                          outer_product(frame.e_r, frame.e_t));
      }
    return symmetrize(stress);
  }



  ConcentricCylinders::ConcentricCylinders(const double    a,
                                           const double    b,
                                           const double    c,
                                           const Material &inner_material,
                                           const Material &outer_material,
                                           const double    p,
                                           const double    alpha)
    : inner(a, b, inner_material)
    , outer(b, c, outer_material)
  {
    AssertThrow(0 <= a && a < b && b < c,
                ExcMessage("The radii have to be 0 <= a < b < c."));

    // The displacement of both bodies at r = b under a unit of contact
    // pressure, and of the outer one under the load.
    inner.load({}, {{1, 1}});
    outer.load({{1, 1}}, {});
    const Harmonics inner_yield = inner.radial_displacement(b);
    const Harmonics outer_yield = outer.radial_displacement(b);
    outer.load({}, {{p, alpha}});
    const Harmonics outer_load = outer.radial_displacement(b);

    for (unsigned int h = 0; h < 2; ++h)
      contact_pressure[h] = outer_load[h] / (inner_yield[h] - outer_yield[h]);
    AssertThrow(contact_pressure[0] >= std::abs(contact_pressure[1]),
                ExcMessage("The contact pressure would become negative: the "
                           "bodies would part."));

    inner.load({}, contact_pressure);
    outer.load(contact_pressure, {{p, alpha}});
  }



  double ConcentricCylinders::pressure(const Point<2> &X) const
  {
    return contact_pressure[0] +
           contact_pressure[1] * std::cos(2 * PolarFrame(X).theta);
  }



  Tensor<1, 2> ConcentricCylinders::displacement(const Point<2> &X,
                                                 const bool      outer) const
  {
    return (outer ? this->outer : inner).displacement(X);
  }



  SymmetricTensor<2, 2> ConcentricCylinders::stress(const Point<2> &X,
                                                    const bool      outer) const
  {
    return (outer ? this->outer : inner).stress(X);
  }
} // namespace Contact
