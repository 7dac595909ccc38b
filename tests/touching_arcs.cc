/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Two arcs that touch: near the point where they do, what lies on one of the
// circles lies on the other one up to the tolerance as well.

#include "mesh/arcs.h"
#include "mesh_facts.h"
#include "tests.h"

using namespace Tests;

namespace
{
  constexpr double radius = 50;

  // The circle below touches the one above in the origin.
  Point<2> center(const bool upper)
  {
    return {0, upper ? radius : -radius};
  }



  // The point of a circle near the origin.
  Point<2> on_circle(const bool upper, const double x)
  {
    const double rise = x * x / (radius + std::sqrt(radius * radius - x * x));
    return {x, upper ? rise : -rise};
  }



  // Chords from the origin to the side, each -0.1 to -0.05 and so on.
  Arc make_arc(const bool upper)
  {
    Arc arc{center(upper), radius, {}};
    for (int i = -2; i < 2; ++i)
      arc.chords.push_back(
        {{on_circle(upper, 0.05 * i), on_circle(upper, 0.05 * (i + 1))}});
    return arc;
  }



  // Proves that the new point between the ends of a chord lies on the circle of
  // the chord, whichever arc comes first, although the ends pass for points of
  // the other one.
  void check_new_points()
  {
    headline("new points");
    const Arc lower = make_arc(false), upper = make_arc(true);
    for (const bool upper_first : {false, true})
      {
        const ArcManifold manifold(upper_first
                                     ? std::vector<Arc>{upper, lower}
                                     : std::vector<Arc>{lower, upper});
        for (const bool is_upper : {false, true})
          {
            const Arc &arc       = is_upper ? upper : lower;
            const Arc &other     = is_upper ? lower : upper;
            bool       ambiguous = true;
            double     error     = 0;
            for (const auto &chord : arc.chords)
              for (const double weight : {0.25, 0.5})
                {
                  ambiguous =
                    ambiguous && other.over_one_chord(chord[0], chord[1]);
                  const std::vector<Point<2>> ends{chord[0], chord[1]};
                  const std::vector<double>   weights{weight, 1 - weight};
                  const Point<2>              p =
                    manifold.get_new_point(make_array_view(ends),
                                           make_array_view(weights));
                  error =
                    std::max(error, std::abs(p.distance(arc.center) - radius));
                }
            const std::string name =
              std::string(is_upper ? "upper" : "lower") + " arc, " +
              (upper_first ? "upper" : "lower") + " first";
            check(name + ", the ends fit both", ambiguous);
            check_small(name, error, 1e-12);
          }
      }
  }



  // Proves the same of a mesh of two bodies: all nodes of their surfaces,
  // refined and of degree 2, lie on the circles of their bodies, and so do the
  // mid-sides of quadrangles and of triangles.
  void check_mesh(const bool triangles)
  {
    headline(triangles ? "triangles" : "quadrangles");
    const auto chart = [](const bool upper) {
      return [upper](const double s, const double t) {
        const Point<2> projection = on_circle(upper, 0.2 * s - 0.1);
        const double   out        = upper ? t : t - 1;
        return Point<2>(projection[0],
                        0.1 * out + (1 - std::abs(out)) * projection[1]);
      };
    };
    const auto split = [=](unsigned int, unsigned int) { return triangles; };
    MeshText   text;
    text.block("lower", 4, 1, chart(false), split);
    text.block("upper", 4, 1, chart(true), split);
    text.write("arcs.msh");

    Parameters::Mesh parameters;
    parameters.file        = "arcs.msh";
    parameters.refinements = 2;
    parameters.arcs        = {{"lower top", {0, -radius, radius}},
                              {"upper bottom", {0, radius, radius}}};
    const Mesh<2> mesh(parameters);
    for (const bool upper : {false, true})
      {
        const std::string name  = upper ? "upper bottom" : "lower top";
        const Roundness   found = roundness(mesh.triangulation,
                                          mesh.boundary(name, "test"),
                                          center(upper),
                                          radius);
        std::cout << "  " << name << ": " << found.n_lines << " lines, "
                  << found.n_of_triangles << " of triangles" << std::endl;
        check_small(name, found.off_circle, 1e-12);
      }
  }
} // namespace



int main()
{
  check_new_points();
  for (const bool triangles : {false, true})
    check_mesh(triangles);
  return 0;
}
