/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the closest point of an edge is the projection of the normal
// where there is one, on straight and on parabolic edges; that the ends of the
// surface reach as far as the documented overhang and no further; that at a
// corner the corner is found; and that all normals of a face, however it is
// bent, and of its overhang are in its range.

#include "contact/surfaces/deformed_surface.h"
#include "tests.h"

using namespace Tests;

namespace
{
  // Four straight edges of different lengths, turned by 30 degrees.
  void straight(const unsigned int degree)
  {
    headline("straight edges, degree " + std::to_string(degree));
    const std::array<double, 5> ends{{0., 1., 1.5, 3.5, 4.}};

    MeshText mesh;
    mesh.block("block", 4, 1, [&](const double s, const double t) {
      return Point<2>(ends[std::lround(4 * s)], t);
    });
    const Bodies bodies(
      make_parameters(mesh, {"block"}, degree, "small strain"));
    const Surface<2>         surface = bodies.surface("block bottom");
    const Tensor<2, 2>       R       = rotation(numbers::PI / 6);
    const Point<2>           origin(3, -2);
    const DeformedSurface<2> search(surface,
                                    bodies.displacement([&](const Point<2> &X) {
                                      return origin + R * X;
                                    }));

    double error      = 0;
    bool   right_edge = true, clamped = true, faces = true;
    Random random;
    for (unsigned int e = 0; e < 4; ++e)
      for (unsigned int k = 0; k < 50; ++k)
        {
          // On both sides, but not far inside the body.
          const double   length = ends[e + 1] - ends[e];
          const double   xi     = random(-0.99, 0.99);
          const Point<2> x =
            origin +
            R * Point<2>(ends[e] + (1 + xi) / 2 * length, random(-3, 0.5));
          const Projection<2> found = search.closest_point(x);
          right_edge                = right_edge && found.facet == e;
          faces = faces && !found.beyond_end && !found.clipped;
          error = std::max(error, std::abs(found.xi - xi));

          // Asked for another edge, the answer is its nearer end.
          if (e > 1)
            clamped = clamped && search.project(x, e - 1).xi == 1 &&
                      search.project(x, e - 1).clipped &&
                      !search.project(x, e - 1).beyond_end;
          if (e + 1 < 3)
            clamped = clamped && search.project(x, e + 1).xi == -1 &&
                      search.project(x, e + 1).clipped &&
                      !search.project(x, e + 1).beyond_end;
        }
    check("the edge of the projection point is found", right_edge && faces);
    check_small("coordinate of the projection point", error, 1e-13);
    check("other edges answer with their nearer end", clamped);

    // The distance is measured to the projection.
    const Point<2> above = origin + R * Point<2>(2.5, -0.75);
    check_small("squared distance",
                std::abs(
                  search.distance_square(above, search.closest_point(above)) -
                  0.5625),
                1e-13);

    // Beyond the ends: the last edge is extrapolated by the overhang, 0.1 in
    // its coordinate, half an edge long.
    headline("  beyond the ends, by parts of the last edge's half length");
    for (const double beyond : {0.05, 0.09, 0.11, 3.})
      for (const bool at_start : {true, false})
        {
          const double   half = at_start ? 0.5 : 0.25;
          const Point<2> x =
            origin +
            R * Point<2>(at_start ? -beyond * half : 4 + beyond * half, -0.3);
          const Projection<2> found = search.closest_point(x);
          std::cout << "  " << beyond << ": edge " << found.facet << ", "
                    << found.xi << (found.beyond_end ? ", off" : ", faces")
                    << std::endl;
        }
  }



  // The projection on y = k x^2 is a root of x - a + 2 k x (k x^2 - b), found
  // by bisection: on the side of the point where it lies beyond the center of
  // curvature, and everywhere else the only one.
  double foot_on_parabola(const double k, const Point<2> &p)
  {
    double low = -20, high = 20;
    if (p[1] > 1 / (2 * k))
      (p[0] > 0 ? low : high) = 0;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const double x      = (low + high) / 2;
        const bool   less   = x - p[0] + 2 * k * x * (k * x * x - p[1]) < 0;
        (less ? low : high) = x;
      }
    return (low + high) / 2;
  }



  // One edge that is y = k x^2 for x in [-1, 1], its coordinate is x.
  void parabola(const double k)
  {
    headline("parabola, k = " + std::to_string(k));
    MeshText mesh;
    mesh.block("block", 1, 1, rectangle({-1, 0}, {1, 1}));
    const Bodies bodies(make_parameters(mesh, {"block"}, 2, "small strain"));
    const Surface<2>         surface = bodies.surface("block bottom");
    const Tensor<2, 2>       R       = rotation(2.);
    const DeformedSurface<2> search(surface,
                                    bodies.displacement([&](const Point<2> &X) {
                                      return Point<2>(
                                        R *
                                        Point<2>(X[0], X[1] + k * X[0] * X[0]));
                                    }));

    double       near = 0, far = 0;
    bool         ends_right = true;
    unsigned int n_off = 0, n_over = 0;
    Random       random;
    for (unsigned int i = 0; i < 2000; ++i)
      {
        // The far ones lie beyond the center of curvature of the vertex, where
        // there are up to three projections.
        const bool          is_far = i % 4 == 0;
        const Point<2>      p(random(-1.6, 1.6),
                         is_far ? random(1.05, 3) / (2 * k)
                                     : random(-2, 0.95 / (2 * k)));
        const double        projection = foot_on_parabola(k, p);
        const Projection<2> found      = search.closest_point(Point<2>(R * p));
        const double        reach      = 1 + DeformedSurface<2>::overhang;
        const double        error =
          std::abs(found.xi - std::max(-reach, std::min(reach, projection)));
        (is_far ? far : near) = std::max(is_far ? far : near, error);

        ends_right =
          ends_right && found.beyond_end == (std::abs(projection) > reach);
        n_off += found.beyond_end;
        n_over += !found.beyond_end && std::abs(projection) > 1;
      }
    check_small("coordinate of the projection point", near, 1e-10);
    check_small("the same beyond the center of curvature", far, 1e-10);
    check("off the end where the projection point is beyond the overhang",
          ends_right);
    check("points off the end and in the overhang were among them",
          n_off > 100 && n_over > 20);
  }



  // A roof of two edges, seen from outside and from inside.
  void corner(const unsigned int degree)
  {
    headline("corner, degree " + std::to_string(degree));
    MeshText mesh;
    mesh.block("block", 2, 1, rectangle({-1, 0}, {1, 1}));
    const Bodies bodies(
      make_parameters(mesh, {"block"}, degree, "small strain"));
    const Surface<2>         surface = bodies.surface("block bottom");
    const DeformedSurface<2> search(surface,
                                    bodies.displacement([&](const Point<2> &X) {
                                      return Point<2>(X[0],
                                                      X[1] + std::abs(X[0]));
                                    }));

    // The surface is y = |x|, the body lies above: outside is the convex side.
    bool corner_found = true;
    for (const double angle : {-0.7, -0.3, 0., 0.2, 0.7})
      {
        const Point<2>      x(2 * std::sin(angle), -2 * std::cos(angle));
        const Projection<2> found = search.closest_point(x);
        corner_found = corner_found && !found.beyond_end && found.clipped &&
                       std::abs(search.distance_square(x, found) - 4) < 1e-13 &&
                       std::abs(found.xi - (found.facet == 0 ? 1 : -1)) < 1e-13;
      }
    check("from the outside the corner is the closest point", corner_found);

    bool face_found = true;
    for (const double a : {-0.5, -0.1, 0.1, 0.5})
      {
        // A point at height 1: its projection on the nearer face.
        const Projection<2> found = search.closest_point(Point<2>(a, 1));
        const double        x     = (std::abs(a) + 1) / 2;
        face_found =
          face_found && found.facet == (a > 0 ? 1 : 0) && !found.beyond_end &&
          std::abs(found.xi - (a > 0 ? 2 * x - 1 : 1 - 2 * x)) < 1e-13;
      }
    check("from the inside the projection point on the nearer face",
          face_found);
  }



  // Nodes off a plane, at random, by a part of half an edge.
  void normals(const unsigned int n_vertices,
               const unsigned int degree,
               const double       part)
  {
    headline("normals of faces of " + std::to_string(n_vertices) +
             " corners, degree " + std::to_string(degree));
    const double        end  = 1 + DeformedSurface<3>::overhang;
    const FacetKind<3> &kind = facet_kind<3>(n_vertices, degree);
    Random              random;
    bool                contained = true;
    double              largest   = 0;
    for (unsigned int k = 0; k < 300; ++k)
      {
        PerFacetNode<3, Point<3>> x;
        for (unsigned int a = 0; a < kind.n_nodes; ++a)
          x[a] = Point<3>(kind.places[a][0] + random(-part, part),
                          kind.places[a][1] + random(-part, part),
                          random(-part, part));
        const DirectionRange<3> found = normal_range<3>(kind, x);
        for (unsigned int q = 0; q < 100; ++q)
          {
            const Point<2> xi(random(-end, end), random(-end, end));
            if (kind.outwardness(xi) > end)
              continue;
            const double angle = std::acos(
              std::min(1., facet_normal<3>(kind, x, xi) * found.mean));
            contained = contained && angle <= found.range + 1e-7;
            largest   = std::max(largest, angle);
          }
      }
    check("in their range", contained);
    if (degree == 2)
      check("bent by more than half a right angle", largest > numbers::PI / 4);
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    straight(degree);
  parabola(0.4);
  parabola(0.05);
  for (const unsigned int degree : {1, 2})
    corner(degree);
  for (const unsigned int n_vertices : {3, 4})
    for (const unsigned int degree : {1, 2})
      normals(n_vertices, degree, 0.15);
  return 0;
}
