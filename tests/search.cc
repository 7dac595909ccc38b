/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the search through the tree of bounding boxes finds the same
// closest point as asking every edge, and that no point of a finely sampled
// surface is closer: around a bent surface whose ends come close to each
// other.

#include <limits>

#include "contact/surfaces/deformed_surface.h"
#include "tests.h"

using namespace Tests;

namespace
{
  void compare(const unsigned int degree)
  {
    headline("degree " + std::to_string(degree));
    MeshText mesh;
    mesh.block("block", 24, 1, rectangle({0, 0}, {1, 0.1}));
    const Bodies bodies(
      make_parameters(mesh, {"block"}, degree, "small strain"));
    const Surface<2> surface = bodies.surface("block bottom");

    // A wavy spiral of a little more than one turn.
    const GhostedVector      u = bodies.displacement([](const Point<2> &X) {
      const double angle  = 7.2 * X[0];
      const double radius = 1 + 0.16 * X[0] + 0.04 * std::sin(5 * angle);
      return Point<2>(radius * std::cos(angle), radius * std::sin(angle));
    });
    const DeformedSurface<2> search(surface, u);

    std::vector<Point<2>> samples;
    for (const auto &edge : surface.facets)
      for (int k = -50; k <= 50; ++k)
        {
          const EdgeShape shape(degree, k / 50.);
          Point<2>        x;
          for (unsigned int a = 0; a <= degree; ++a)
            x += shape.value[a] * surface.position(edge.nodes[a], u);
          samples.push_back(x);
        }

    const unsigned int n_points = 2000;
    unsigned int       n_same = 0, n_minimal = 0, n_off = 0;
    Random             random;
    for (unsigned int i = 0; i < n_points; ++i)
      {
        // A half of the points everywhere, the other half near the ends.
        Point<2> x(random(-1.6, 1.6), random(-1.6, 1.6));
        if (i % 2 == 0)
          x = Point<2>(random(0.8, 1.2), random(-0.3, 1.2));
        const Projection<2> found    = search.closest_point(x);
        const double        distance = search.distance_square(x, found);
        n_off += found.beyond_end;

        double best = std::numeric_limits<double>::max();
        for (unsigned int e = 0; e < surface.facets.size(); ++e)
          best =
            std::min(best, search.distance_square(x, search.project(x, e)));
        n_same += distance == best;

        double sampled = std::numeric_limits<double>::max();
        for (const Point<2> &sample : samples)
          sampled = std::min(sampled, x.distance_square(sample));
        n_minimal += distance <= sampled + 1e-13;
      }
    std::cout << "  " << n_same << " of " << n_points
              << " points as by asking every edge" << std::endl
              << "  " << n_minimal << " of " << n_points
              << " points without a closer sample" << std::endl;
    check("some points lie off the end", n_off > 0 && n_off < n_points / 4);
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    compare(degree);
  return 0;
}
