/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The line contact of Hertz against its published figures for the benchmark,
// and against the conditions that define it.

#include <deal.II/base/quadrature_lib.h>

#include <iomanip>
#include <iostream>

#include "closed_forms/line_contact.h"

using namespace dealii;



// The force that the pressure adds up to. With x = a sin(phi) the integrand is
// smooth up to the ends, so that few points integrate it to round-off.
double total_force(const Contact::HertzLineContact &hertz)
{
  const QGauss<1> quadrature(20);
  double          force = 0;
  for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const double phi = numbers::PI * (quadrature.point(q)[0] - 0.5);
      force += numbers::PI * quadrature.weight(q) * hertz.half_width() *
               std::cos(phi) *
               hertz.pressure(hertz.half_width() * std::sin(phi));
    }
  return force;
}



int main()
{
  const Contact::HertzLineContact hertz{50, 35000, 70000, 0.3, 210000, 0.3};

  // Proves the formulas: SSNP154 states 3585.362 MPa and 6.21463 mm.
  std::cout << std::fixed << std::setprecision(3) << "p0 "
            << hertz.max_pressure() << " MPa\n"
            << std::setprecision(5) << "a " << hertz.half_width() << " mm\n"
            << std::setprecision(3) << "E* " << hertz.contact_modulus()
            << " MPa\n";

  // Proves that the pressure carries the force.
  std::cout << "integral of the pressure " << total_force(hertz) << " N/mm\n";

  // Proves the shape: even, p0 on the axis, 0.8 p0 at 0.6 a, and nothing at the
  // border or beyond.
  const double a = hertz.half_width();
  std::cout << "p/p0";
  for (const double x : {-0.6 * a, 0., 0.6 * a, a, 1.5 * a})
    std::cout << ' ' << hertz.pressure(x) / hertz.max_pressure();
  std::cout << std::endl;
  return 0;
}
