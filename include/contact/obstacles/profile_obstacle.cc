/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/obstacles/profile_obstacle.h"

#include <cmath>
#include <limits>

#include "base/errors.h"

namespace Contact
{
  template<int dim>
  ProfileObstacle<dim>::ProfileObstacle(const std::vector<double> &numbers)
    : first(numbers[0], numbers[1])
  {
    const auto refuse = [](const std::string &problem) {
      throw InputError(
        problem,
        "Contact/Obstacle",
        "write 'profile: x, y, radius, x, y, radius, ...', with "
        "the obstacle on its left, the radii of the ends of an open "
        "line 0, all others positive and small enough");
    };
    const unsigned int    n = numbers.size() / 3;
    std::vector<Point<2>> points;
    std::vector<double>   radii;
    for (unsigned int k = 0; k < n; ++k)
      {
        points.emplace_back(numbers[3 * k], numbers[3 * k + 1]);
        radii.push_back(numbers[3 * k + 2]);
      }
    const bool is_closed = points.front() == points.back();
    for (unsigned int k = 0; k + 1 < n; ++k)
      {
        const Tensor<1, 2> way = points[k + 1] - points[k];
        if (way.norm() == 0)
          refuse("two points of a profile are one");
        edges.push_back({points[k], way / way.norm(), 0, way.norm()});
      }
    const double round_off = 1e-12;
    const double infinity  = std::numeric_limits<double>::infinity();
    if (!is_closed)
      {
        if (radii.front() != 0 || radii.back() != 0)
          refuse("the end of a profile is a corner");
        edges.front().begin = -infinity;
        edges.back().end    = infinity;
      }
    for (unsigned int k = is_closed ? 0 : 1; k + 1 < n; ++k)
      {
        Edge              &in = edges[k == 0 ? n - 2 : k - 1], &out = edges[k];
        const Tensor<1, 2> a = in.tangent, b = out.tangent;
        const double       sine = a[0] * b[1] - a[1] * b[0], cosine = a * b;
        const double       alpha = std::atan2(sine, cosine);
        if (std::abs(alpha) <= round_off)
          continue;
        if (!(radii[k] > 0) || numbers::PI - std::abs(alpha) <= round_off)
          refuse("a corner of a profile is not round");
        const double cut = radii[k] * std::tan(std::abs(alpha) / 2);
        in.end -= cut;
        out.begin += cut;
        // Of a convex corner the arc is about a point on the left.
        const double       side = std::copysign(1., alpha);
        const Tensor<1, 2> outward({a[1] + b[1], -a[0] - b[0]});
        const Tensor<1, 2> middle = side * outward / outward.norm();
        arcs.push_back({points[k] - radii[k] / std::cos(alpha / 2) * middle,
                        side * radii[k],
                        middle,
                        std::cos(alpha / 2)});
      }
    for (const Edge &edge : edges)
      if (edge.end < edge.begin * (1 - round_off))
        refuse("an edge of a profile is shorter than its arcs");
  }



  // At the ends of the pieces either one will do.
  template<int dim>
  typename Obstacle<dim>::ClosestPoint
  ProfileObstacle<dim>::closest_point(const Point<dim> &x) const
  {
    const Point<2>            at(x[0], x[1]);
    double                    smallest = std::numeric_limits<double>::max();
    Obstacle<2>::ClosestPoint closest{};
    const auto                take = [&](const Point<2>     &projection_point,
                          const Tensor<1, 2> &normal,
                          const double        radius) {
      const double distance = at.distance(projection_point);
      if (distance < smallest)
        {
          smallest = distance;
          closest  = {projection_point, normal, radius};
        }
    };
    const double slack = 1e-12; // round-off
    for (const Edge &edge : edges)
      {
        const double s = (at - edge.from) * edge.tangent;
        const double room =
          slack * (std::isfinite(edge.end - edge.begin) ? edge.end - edge.begin
                                                        : std::abs(s));
        if (s >= edge.begin - room && s <= edge.end + room)
          take(edge.from + s * edge.tangent,
               Tensor<1, 2>({edge.tangent[1], -edge.tangent[0]}),
               0);
      }
    for (const Arc &arc : arcs)
      {
        Tensor<1, 2> direction = at - arc.centre;
        const double distance  = direction.norm();
        direction = distance > 0 ? direction / distance : arc.middle;
        if (direction * arc.middle >= arc.cosine - slack)
          take(arc.centre + std::abs(arc.radius) * direction,
               std::copysign(1., arc.radius) * direction,
               arc.radius);
      }
    typename Obstacle<dim>::ClosestPoint in_space{};
    in_space.x = x;
    for (unsigned int i = 0; i < 2; ++i)
      {
        in_space.x[i]      = closest.x[i];
        in_space.normal[i] = closest.normal[i];
      }
    in_space.radius = closest.radius;
    return in_space;
  }



  template<int dim>
  Point<dim> ProfileObstacle<dim>::centre() const
  {
    Point<dim> centre;
    for (unsigned int i = 0; i < 2; ++i)
      centre[i] = first[i];
    return centre;
  }

  template class ProfileObstacle<2>;
  template class ProfileObstacle<3>;
} // namespace Contact
