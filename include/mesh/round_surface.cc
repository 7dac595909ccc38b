/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/round_surface.h"

#include <cmath>

#include "base/errors.h"
#include "base/string_utilities.h"

namespace Contact
{
  namespace
  {
    /// A point by its position along an axis and the vector from the axis.
    struct FromAxis
    {
      FromAxis(const Tensor<1, 3> &from_origin, const Tensor<1, 3> &axis)
        : height(from_origin * axis)
        , ray(from_origin - height * axis)
      {
      }

      double       height;
      Tensor<1, 3> ray;
    };



    /// Of Newton's method on a curved face, whose coordinates are of the unit
    /// square or triangle: quadratic but for round-off.
    constexpr unsigned int max_steps = 50;
    constexpr double       accuracy  = 1e-13;



    Tensor<1, 3> normalized(const Tensor<1, 3> &vector)
    {
      return vector / vector.norm();
    }
  } // namespace



  RoundSurface sphere(const Point<3> &center, const double radius)
  {
    return {[=](const Point<3> &p) -> Point<3> {
              return center + radius * normalized(p - center);
            },
            [=](const Point<3> &) { return radius; }};
  }



  RoundSurface
  cylinder(const Point<3> &point, const Tensor<1, 3> &axis, const double radius)
  {
    const Tensor<1, 3> along = normalized(axis);
    return {[=](const Point<3> &p) -> Point<3> {
              const FromAxis q(p - point, along);
              return point + q.height * along + radius * normalized(q.ray);
            },
            [=](const Point<3> &) { return radius; }};
  }



  // The projection onto the straight line of the cone in the half plane of p.
  RoundSurface
  cone(const Point<3> &apex, const Tensor<1, 3> &axis, const double angle)
  {
    const Tensor<1, 3> along = normalized(axis);
    return {[=](const Point<3> &p) -> Point<3> {
              const FromAxis     q(p - apex, along);
              const Tensor<1, 3> line =
                std::cos(angle) * along + std::sin(angle) * normalized(q.ray);
              return apex + ((p - apex) * line) * line;
            },
            [=](const Point<3> &p) { return p.distance(apex); }};
  }



  RoundSurface torus(const Point<3>     &center,
                     const Tensor<1, 3> &axis,
                     const double        ring,
                     const double        tube)
  {
    const Tensor<1, 3> along = normalized(axis);
    return {[=](const Point<3> &p) -> Point<3> {
              const FromAxis q(p - center, along);
              const Point<3> middle = center + ring * normalized(q.ray);
              return middle + tube * normalized(p - middle);
            },
            [=](const Point<3> &) { return tube; }};
  }



  RoundManifold::RoundManifold(const RoundSurface &surface)
    : surface(surface)
  {
  }



  std::unique_ptr<Manifold<3>> RoundManifold::clone() const
  {
    return std::make_unique<RoundManifold>(surface);
  }



  Point<3> RoundManifold::get_new_point(
    const ArrayView<const Point<3>> &surrounding_points,
    const ArrayView<const double>   &weights) const
  {
    Point<3> mean;
    for (unsigned int i = 0; i < weights.size(); ++i)
      mean += weights[i] * surrounding_points[i];
    return surface.closest(mean);
  }



  CurvedQuadrangle::CurvedQuadrangle(const std::array<Point<3>, 4>     &corners,
                                     const std::array<Tensor<1, 3>, 4> &bulges,
                                     const std::optional<Point<3>>     &centre)
    : corners(corners)
    , bulges(bulges)
    , centre(centre)
  {
    if (centre)
      bubble = *centre - push_forward(Point<2>(0.5, 0.5));
  }



  std::unique_ptr<Manifold<3>> CurvedQuadrangle::clone() const
  {
    return std::make_unique<CurvedQuadrangle>(corners, bulges, centre);
  }



  Point<2> CurvedQuadrangle::middle() const
  {
    return {0.5, 0.5};
  }



  // Lines 0 and 1 are where xi_0 is 0 and 1, lines 2 and 3 where xi_1 is.
  Point<3> CurvedQuadrangle::push_forward(const Point<2> &xi) const
  {
    Point<3> x(16 * xi[0] * (1 - xi[0]) * xi[1] * (1 - xi[1]) * bubble);
    for (unsigned int v = 0; v < 4; ++v)
      x += (v % 2 == 0 ? 1 - xi[0] : xi[0]) * (v < 2 ? 1 - xi[1] : xi[1]) *
           corners[v];
    for (unsigned int l = 0; l < 4; ++l)
      {
        const double across = xi[l / 2], along = xi[1 - l / 2];
        x += 4 * (l % 2 == 0 ? 1 - across : across) * along * (1 - along) *
             bulges[l];
      }
    return x;
  }



  DerivativeForm<1, 2, 3>
  CurvedQuadrangle::push_forward_gradient(const Point<2> &xi) const
  {
    std::array<Tensor<1, 3>, 2> by;
    for (unsigned int i = 0; i < 2; ++i)
      by[i] = 16 * (1 - 2 * xi[i]) * xi[1 - i] * (1 - xi[1 - i]) * bubble;
    for (unsigned int v = 0; v < 4; ++v)
      {
        const double sign_0 = v % 2 == 0 ? -1 : 1, sign_1 = v < 2 ? -1 : 1;
        by[0] += sign_0 * (v < 2 ? 1 - xi[1] : xi[1]) * corners[v];
        by[1] += sign_1 * (v % 2 == 0 ? 1 - xi[0] : xi[0]) * corners[v];
      }
    for (unsigned int l = 0; l < 4; ++l)
      {
        const double across = xi[l / 2], along = xi[1 - l / 2];
        by[l / 2] += (l % 2 == 0 ? -4 : 4) * along * (1 - along) * bulges[l];
        by[1 - l / 2] +=
          4 * (l % 2 == 0 ? 1 - across : across) * (1 - 2 * along) * bulges[l];
      }
    DerivativeForm<1, 2, 3> gradient;
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int i = 0; i < 2; ++i)
        gradient[d][i] = by[i][d];
    return gradient;
  }



  CurvedTriangle::CurvedTriangle(const std::array<Point<3>, 3>     &corners,
                                 const std::array<Tensor<1, 3>, 3> &bulges)
    : corners(corners)
    , bulges(bulges)
  {
  }



  std::unique_ptr<Manifold<3>> CurvedTriangle::clone() const
  {
    return std::make_unique<CurvedTriangle>(corners, bulges);
  }



  Point<2> CurvedTriangle::middle() const
  {
    return {1. / 3, 1. / 3};
  }



  Point<3> CurvedTriangle::push_forward(const Point<2> &xi) const
  {
    const std::array<double, 3> lambda{{1 - xi[0] - xi[1], xi[0], xi[1]}};
    Point<3>                    x;
    for (unsigned int l = 0; l < 3; ++l)
      x += lambda[l] * corners[l] +
           4 * lambda[l] * lambda[(l + 1) % 3] * bulges[l];
    return x;
  }



  DerivativeForm<1, 2, 3>
  CurvedTriangle::push_forward_gradient(const Point<2> &xi) const
  {
    const std::array<double, 3> lambda{{1 - xi[0] - xi[1], xi[0], xi[1]}};
    std::array<Tensor<1, 3>, 3> by; // lambda
    for (unsigned int l = 0; l < 3; ++l)
      {
        const unsigned int next = (l + 1) % 3;
        by[l] += corners[l] + 4 * lambda[next] * bulges[l];
        by[next] += 4 * lambda[l] * bulges[l];
      }
    DerivativeForm<1, 2, 3> gradient;
    for (unsigned int d = 0; d < 3; ++d)
      for (unsigned int i = 0; i < 2; ++i)
        gradient[d][i] = by[i + 1][d] - by[0][d];
    return gradient;
  }



  Point<2> CurvedFace::pull_back(const Point<3> &p) const
  {
    Point<2> xi = middle();
    for (unsigned int step = 0; step < max_steps; ++step)
      {
        const auto         gradient = push_forward_gradient(xi);
        const Tensor<1, 3> r        = p - push_forward(xi);
        Tensor<1, 2>       rhs;
        Tensor<2, 2>       matrix;
        for (unsigned int i = 0; i < 2; ++i)
          for (unsigned int d = 0; d < 3; ++d)
            {
              rhs[i] += gradient[d][i] * r[d];
              for (unsigned int j = 0; j < 2; ++j)
                matrix[i][j] += gradient[d][i] * gradient[d][j];
            }
        const Tensor<1, 2> change = invert(matrix) * rhs;
        xi += change;
        if (change.norm() < accuracy)
          return xi;
      }
    throw InputError("a face with mid-side nodes is too much bent: no place "
                     "on it for the point " +
                       brief(p),
                     "entry 'Mesh/Mid-side nodes'",
                     "make the mesh finer there");
  }
} // namespace Contact
