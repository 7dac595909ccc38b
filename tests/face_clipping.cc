/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The intersection of two facets in 2-D: its area against the closed form
// for squares whose sides lie on each other up to round-off, in any direction
// (as slave and master facets do on a symmetry plane), and for turned squares;
// in either order and with either sense of the corners.

#include "contact/surfaces/face_clipping.h"

#include <cmath>
#include <iostream>
#include <random>

using namespace Contact;

namespace
{
  double common_area(const PlaneFacet &a, const PlaneFacet &b)
  {
    double result = 0;
    for (const PlaneTriangle &triangle : intersection(a, b))
      result += area(triangle);
    return result;
  }



  // Corners in the order of deal.II, from the place of the first one.
  PlaneFacet square(const Point<2> &corner,
                    const double    side,
                    const double    angle,
                    const bool      mirrored)
  {
    const Tensor<1, 2> s({side * std::cos(angle), side * std::sin(angle)});
    const Tensor<1, 2> t({-s[1], s[0]});
    return mirrored
             ? PlaneFacet{corner, corner + t, corner + s, corner + s + t}
             : PlaneFacet{corner, corner + s, corner + t, corner + s + t};
  }



  void move(PlaneFacet &q, const double by, std::mt19937 &random)
  {
    std::uniform_int_distribution<> step(-1, 1);
    for (Point<2> &corner : q)
      corner += Tensor<1, 2>({by * step(random), by * step(random)});
  }



  // Two squares on one line, the second displaced along it.
  void sides_on_each_other(const double noise)
  {
    std::mt19937                     random(1);
    std::uniform_real_distribution<> number(0, 1);
    double                           worst = 0;
    for (unsigned int k = 0; k < 100000; ++k)
      {
        const double angle = 2 * M_PI * number(random), shift = number(random);
        const Tensor<1, 2> along({std::cos(angle), std::sin(angle)});
        const Point<2>     origin(-0.5, -0.5);
        const bool         mirrored = k % 2;
        PlaneFacet         a        = square(origin, 1, angle, mirrored);
        PlaneFacet b = square(origin + shift * along, 1.2, angle, k % 3 == 0);
        move(a, noise, random);
        move(b, noise, random);
        worst = std::max({worst,
                          std::abs(common_area(a, b) - (1 - shift)),
                          std::abs(common_area(b, a) - (1 - shift))});
      }
    std::cout << "sides on each other up to " << noise << ": "
              << (worst < 1e-12 + 10 * noise ? "ok" : "FAILED") << std::endl;
  }



  // A square and itself turned by 45 degrees about its middle: an octagon.
  void octagon()
  {
    const PlaneFacet a = square(Point<2>(-1, -1), 2, 0, false);
    const PlaneFacet b = square(Point<2>(0, -std::sqrt(2.)), 2, M_PI / 4, true);
    const double     exact = 8 * (std::sqrt(2.) - 1);
    std::cout << "octagon: "
              << (std::abs(common_area(a, b) - exact) < 1e-13 ? "ok" : "FAILED")
              << std::endl;
  }
} // namespace



int main()
{
  for (const double noise : {0., 1e-16, 1e-15, 1e-14, 1e-12})
    sides_on_each_other(noise);
  octagon();
  const PlaneFacet a = square(Point<2>(0, 0), 1, 0, false);
  std::cout << "side by side: "
            << (intersection(a, square(Point<2>(1, 0), 1, 0, false)).empty()
                  ? "ok"
                  : "FAILED")
            << std::endl;
  return 0;
}
