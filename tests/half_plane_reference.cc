/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The half planes in many increments against the reference for a load that
// grows steadily, if it is at hand.

#include <fstream>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

#include "closed_forms/half_plane.h"

using namespace Contact;

int main()
{
  std::ifstream file(REFERENCE_DIRECTORY "/hertz-friction-halfplane-mu0.1.csv");
  if (!file)
    {
      std::cout << "skipped: no reference of the half planes" << std::endl;
      return 0;
    }

  const HertzLineContact hertz{50, 100, 70000, 0.3, 210000, 0.3};
  const HalfPlaneContact contact(hertz, 0.1, 400, 200);

  // At the axis the first increments show, at the end the last elements.
  struct Range
  {
    std::string name;
    double      bound;
    double      pressure = 0, shear = 0;
  };
  std::vector<Range> ranges{{"below 0.05 a", 2e-3},
                            {"below 0.95 a", 2e-4},
                            {"beyond", 1e-2}};

  file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  unsigned int n_points = 0;
  double       x, p, q;
  while (file >> x >> p >> q)
    {
      ++n_points;
      Range       &range = ranges[x < 0.05 ? 0 : x < 0.95 ? 1 : 2];
      const double place = x * hertz.half_width();
      const double p0    = hertz.max_pressure();
      range.pressure =
        std::max(range.pressure, std::abs(contact.pressure(place) / p0 - p));
      range.shear =
        std::max(range.shear, std::abs(contact.shear(place) / p0 - q));
    }

  std::cout << "all points read: " << (n_points == 400 ? "yes" : "no")
            << std::endl;
  for (const Range &range : ranges)
    std::cout << range.name << ", pressure and shear off by " << range.pressure
              << " and " << range.shear << " p0, both less than " << range.bound
              << ": "
              << (std::max(range.pressure, range.shear) < range.bound ? "yes"
                                                                      : "no")
              << std::endl;
}
