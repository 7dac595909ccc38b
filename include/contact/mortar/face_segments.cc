/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/mortar/face_segments.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace Contact
{
  namespace
  {
    PlaneFacet project(const ProjectionPlane               &plane,
                       const FacetPart                     &part,
                       const PerFacetNode<3, unsigned int> &nodes,
                       const std::vector<Point<3>>         &x)
    {
      PlaneFacet outline;
      for (const unsigned int corner : part.corners)
        outline.push_back(plane.project(x[nodes[corner]]));
      return outline;
    }



    /// The sum over the nodes of a facet, which are at @p x.
    Point<3> sum(const FacetShape<3>::Values &values,
                 const SurfaceFacet<3>       &facet,
                 const std::vector<Point<3>> &x)
    {
      Point<3> place;
      for (unsigned int a = 0; a < facet.n_nodes(); ++a)
        place += values[a] * x[facet.nodes[a]];
      return place;
    }



    /// The place of a triangle with these coordinates.
    Point<2> inside(const std::array<Point<2>, 3> &triangle,
                    const Point<2>                &eta)
    {
      return Point<2>(triangle[0] + eta[0] * (triangle[1] - triangle[0]) +
                      eta[1] * (triangle[2] - triangle[0]));
    }



    /**
     * The Gauss points of a triangle, exact for degree 2 n - 1. On triangles
     * and parallelograms products of two shape functions are polynomials of
     * twice the degree of the functions, p. On others the coordinates are power
     * series in the place, whose k-th term has the factor (variation / 2)^k and
     * raises the degree by k: what is not integrated exactly is round-off, or
     * else n is the largest.
     */
    const Quadrature<2> &rule(const unsigned int polynomial_degree,
                              const double       variation)
    {
      static const std::vector<Quadrature<2>> rules{
        QWitherdenVincentSimplex<2>(2),
        QWitherdenVincentSimplex<2>(3),
        QWitherdenVincentSimplex<2>(4),
        QWitherdenVincentSimplex<2>(5),
        QWitherdenVincentSimplex<2>(6),
        QWitherdenVincentSimplex<2>(7)};
      const double       round_off = 1e-13;
      const unsigned int p         = 2 * polynomial_degree;
      unsigned int       n         = p / 2 + 1;
      while (n < 7 && std::pow(variation / 2, 2. * n - p) > round_off)
        ++n;
      return rules[n - 2];
    }
  } // namespace



  struct FaceSegments::SlaveFacet
  {
    SlaveFacet(const unsigned int       index,
               const Surface<3>        &slave,
               const FaceConfiguration &now)
      : index(index)
      , facet(slave.facets[index])
      , normal(now.slave_middles[index])
      , plane(sum(facet.kind->values(facet.kind->middle), facet, now.slave_x),
              normal)
    {
      for (const FacetPart &part : facet.kind->parts)
        parts.emplace_back(project(plane, part, facet.nodes, now.slave_x),
                           part);
      for (unsigned int a = 0; a < facet.n_nodes(); ++a)
        X.push_back(slave.nodes[facet.nodes[a]].X);
    }

    /// The undeformed area per unit of the coordinates.
    double reference_jacobian(const FacetBasis &basis) const
    {
      std::array<Tensor<1, 3>, 2> tangents;
      for (unsigned int a = 0; a < X.size(); ++a)
        for (unsigned int k = 0; k < 2; ++k)
          tangents[k] += basis.first[k][a] * X[a];
      return outward_normal(tangents).norm();
    }

    const unsigned int         index;
    const SurfaceFacet<3>     &facet;
    const Tensor<1, 3>         normal;
    const ProjectionPlane      plane;
    std::vector<ProjectedPart> parts;
    std::vector<Point<3>>      X; // of the nodes, undeformed
  };



  FaceSegments::FaceSegments(const Surface<3>        &slave,
                             const Surface<3>        &master,
                             const FaceConfiguration &now,
                             const BodyOverlap<3>    &bodies)
    : slave(slave)
    , master(master)
    , now(now)
    , bodies(bodies)
    , closest(slave.nodes.size())
  {
  }



  // The master facets that face a slave facet are in its box, widened by the
  // distance of the surfaces there.
  const std::vector<FaceSample> &FaceSegments::samples(const unsigned int e)
  {
    std::vector<Point<3>> x;
    NormalCone<3>         directions;
    directions.normals = {now.slave_middles[e]};
    if (bodies.is_with_itself())
      directions.partners = [&](const unsigned int m) {
        return bodies.may_face(e, m);
      };

    of_facet.clear();
    const SlaveFacet own(e, slave, now);
    bool             sees_closest = true;
    for (unsigned int a = 0; a < own.facet.n_nodes(); ++a)
      {
        x.push_back(now.slave_x[own.facet.nodes[a]]);
        sees_closest = sees_closest &&
                       directions.faces(closest_to(own.facet.nodes[a]).normal);
      }
    if (!sees_closest && !has_partners(own, directions))
      return of_facet;

    double distance = 0;
    for (unsigned int a = 0; a < own.facet.n_nodes(); ++a)
      distance =
        std::max(distance, distance_to_master(own.facet.nodes[a], directions));
    BoundingBox<3> box(x);
    box.extend(distance + 0.1 * slave.reference_length(e));
    for (const unsigned int m : now.search.facets_in(box))
      if (bodies.may_face(e, m) && directions.faces(now.master_middles[m]))
        add_segment(own, m);
    remove_far_sides(own);
    remove_hidden(own);
    return of_facet;
  }



  // From all facets around a node the master is seen at the same place, if that
  // faces them.
  const FaceSegments::Closest &FaceSegments::closest_to(const unsigned int node)
  {
    if (!closest[node])
      {
        const Point<3>     &x                = now.slave_x[node];
        const Projection<3> projection_point = now.search.closest_alone(x);
        closest[node] =
          Closest{std::sqrt(now.search.distance_square(x, projection_point)),
                  now.search.normal(projection_point.facet,
                                    projection_point.xi)};
      }
    return *closest[node];
  }



  double FaceSegments::distance_to_master(const unsigned int   node,
                                          const NormalCone<3> &directions)
  {
    if (directions.faces(closest_to(node).normal))
      return closest_to(node).distance;
    const Point<3> &x = now.slave_x[node];
    return std::sqrt(
      now.search.distance_square(x, now.search.closest_facing(x, directions)));
  }



  // Most facets of a whole body have none: to look for the closest one would
  // take a look at all of them.
  bool FaceSegments::has_partners(const SlaveFacet    &own,
                                  const NormalCone<3> &directions) const
  {
    const FacetBall own_ball(own.facet, now.slave_x);
    for (unsigned int m = 0; m < master.facets.size(); ++m)
      if (const FacetBall &ball = now.master_balls[m];
          own_ball.distance_across(own.normal, ball.centre) <=
            own_ball.radius + ball.radius &&
          bodies.may_face(own.index, m) &&
          directions.faces(now.master_middles[m]))
        return true;
    return false;
  }



  void FaceSegments::add_segment(const SlaveFacet &own, const unsigned int m)
  {
    const SurfaceFacet<3> &faced       = master.facets[m];
    const FacetKind<3>    &slave_kind  = *own.facet.kind;
    const FacetKind<3>    &master_kind = *faced.kind;
    const auto             on_slave = [&](const FacetShape<3>::Values &values) {
      return sum(values, own.facet, now.slave_x);
    };
    const auto on_master = [&](const FacetShape<3>::Values &values) {
      return sum(values, faced, now.master_x);
    };
    for (const FacetPart &other : master_kind.parts)
      {
        const ProjectedPart t(
          project(own.plane, other, faced.nodes, now.master_x),
          other);
        for (const ProjectedPart &s : own.parts)
          {
            if (!s.is_near(t))
              continue;
            const auto triangles = intersection(s.outline, t.outline);
            if (triangles.empty())
              continue;
            const Quadrature<2> &quadrature =
              rule(std::max(slave_kind.polynomial_degree,
                            master_kind.polynomial_degree),
                   std::max(s.map.variation(), t.map.variation()));
            const double scale = s.part.scale;
            for (const PlaneTriangle &triangle : triangles)
              {
                std::array<Point<2>, 3> corners_in_s, corners_in_t;
                for (unsigned int k = 0; k < 3; ++k)
                  {
                    corners_in_s[k] = s.map.coordinates_of(triangle[k]);
                    corners_in_t[k] = t.map.coordinates_of(triangle[k]);
                  }
                for (unsigned int q = 0; q < quadrature.size(); ++q)
                  {
                    const Point<2> &eta   = quadrature.point(q);
                    const Point<2>  place = inside(triangle, eta);
                    const Point<2>  in_s =
                      s.map.coordinates_of(place, inside(corners_in_s, eta));
                    const Point<2>   slave_xi = s.in_facet(in_s);
                    const FacetBasis basis(slave_kind, slave_xi);
                    const double     weight = 2 * area(triangle) *
                                          quadrature.weight(q) /
                                          s.map.jacobian(in_s) * scale * scale *
                                          own.reference_jacobian(basis);
                    const Point<2> master_xi = t.in_facet(
                      t.map.coordinates_of(place, inside(corners_in_t, eta)));
                    of_facet.emplace_back(FacetSample{slave_xi,
                                                      basis.value,
                                                      weight},
                                          master_xi,
                                          m,
                                          master_kind);
                    FaceSample &sample = of_facet.back();
                    sample.distance    = on_slave(sample.slave_values) -
                                      on_master(sample.master_basis.value);
                    if (q == 0)
                      sample.n_of_triangle = quadrature.size();
                    if (q < 3)
                      sample.distance_at_corner =
                        on_slave(
                          slave_kind.values(s.in_facet(corners_in_s[q]))) -
                        on_master(
                          master_kind.values(t.in_facet(corners_in_t[q])));
                  }
              }
          }
      }
  }



  // Facets next to each other are no further apart than they are large.
  void FaceSegments::remove_hidden(const SlaveFacet &own)
  {
    if (of_facet.empty())
      return;
    double least = of_facet[0].distance * own.normal, largest = least;
    bool   are_of_one = true;
    for (const FaceSample &sample : of_facet)
      {
        const double along = sample.distance * own.normal;
        least              = std::min(least, along);
        largest            = std::max(largest, along);
        are_of_one =
          are_of_one && sample.master_facet == of_facet[0].master_facet;
      }
    const double thin = 0.1;
    if (are_of_one ||
        largest - least <= thin * slave.reference_length(own.index))
      return;

    std::map<unsigned int, ProjectedFacet> facets;
    for (const FaceSample &sample : of_facet)
      if (const unsigned int m = sample.master_facet; facets.count(m) == 0)
        facets.emplace(m, projected(own, master, now.master_x, m));
    const auto is_hidden = [&](const FaceSample &sample) {
      const Point<3> on_slave = place_of(sample, own);
      return std::any_of(facets.begin(), facets.end(), [&](const auto &facet) {
        if (facet.first == sample.master_facet)
          return false;
        const auto along =
          distance_along(own, on_slave, master, now.master_x, facet.second);
        return along &&
               std::abs(*along) < std::abs(sample.distance * own.normal);
      });
    };
    of_facet.erase(std::remove_if(of_facet.begin(), of_facet.end(), is_hidden),
                   of_facet.end());
  }



  // The middle of a triangle tells.
  void FaceSegments::remove_far_sides(const SlaveFacet &own)
  {
    const double slack =
      DeformedSurface<3>::overhang * slave.reference_length(own.index);
    const auto is_far = [&](const auto first, const unsigned int n) {
      Point<3>     x;
      Point<2>     slave_xi, master_xi;
      Tensor<1, 3> distance;
      for (auto sample = first; sample != first + n; ++sample)
        {
          x += place_of(*sample, own) / n;
          slave_xi += sample->slave_xi / n;
          master_xi += sample->master_xi / n;
          distance += sample->distance / n;
        }
      return distance * own.normal > slack &&
             !bodies.is_between(
               {x, slave, own.index, slave_xi},
               0,
               {x - distance, master, first->master_facet, master_xi});
    };
    auto end = of_facet.begin();
    for (auto sample = of_facet.begin(); sample != of_facet.end();)
      {
        const auto next = sample + sample->n_of_triangle;
        if (!is_far(sample, sample->n_of_triangle))
          end = end == sample ? next : std::move(sample, next, end);
        sample = next;
      }
    of_facet.erase(end, of_facet.end());
  }



  Point<3> FaceSegments::place_of(const FaceSample &sample,
                                  const SlaveFacet &own) const
  {
    return sum(sample.slave_values, own.facet, now.slave_x);
  }



  FaceSegments::ProjectedFacet
  FaceSegments::projected(const SlaveFacet            &own,
                          const Surface<3>            &surface,
                          const std::vector<Point<3>> &x,
                          const unsigned int           facet) const
  {
    std::vector<ProjectedPart> parts;
    for (const FacetPart &part : surface.facets[facet].kind->parts)
      parts.emplace_back(
        project(own.plane, part, surface.facets[facet].nodes, x),
        part);
    return {facet, std::move(parts)};
  }



  // A place on a line that facets share is on none of them.
  std::optional<double>
  FaceSegments::distance_along(const SlaveFacet            &own,
                               const Point<3>              &on_slave,
                               const Surface<3>            &surface,
                               const std::vector<Point<3>> &x,
                               const ProjectedFacet        &facet) const
  {
    const auto &[f, parts]          = facet;
    const SurfaceFacet<3> &other    = surface.facets[f];
    const Point<2>         in_plane = own.plane.project(on_slave);
    for (const ProjectedPart &part : parts)
      {
        if (!part.is_in_box(in_plane))
          continue;
        const Point<2> xi = part.map.coordinates_of(in_plane);
        if (other.kind->outwardness(xi) < 1)
          return (on_slave -
                  sum(other.kind->values(part.in_facet(xi)), other, x)) *
                 own.normal;
      }
    return {};
  }
} // namespace Contact
