/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/face_segments.h"

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace Contact
{
  namespace
  {
    /// The parts of a facet that are projected as quadrangles: one, or at
    /// degree 2 four. Their corners are nodes of the facet.
    struct Part
    {
      std::array<unsigned int, 4> corners;
      Point<2>                    middle; // in the coordinates of the facet
      double                      scale;  // of the coordinates of the part
    };

    const std::vector<Part> &parts_of_facet(const unsigned int degree)
    {
      static const std::vector<Part> one{{{{0, 1, 2, 3}}, Point<2>(), 1}};
      static const std::vector<Part> four{
        {{{0, 6, 4, 8}}, Point<2>(-0.5, -0.5), 0.5},
        {{{6, 1, 8, 5}}, Point<2>(0.5, -0.5), 0.5},
        {{{4, 8, 2, 7}}, Point<2>(-0.5, 0.5), 0.5},
        {{{8, 5, 7, 3}}, Point<2>(0.5, 0.5), 0.5}};
      return degree == 1 ? one : four;
    }



    PlaneQuadrangle project(const ProjectionPlane               &plane,
                            const Part                          &part,
                            const PerFacetNode<3, unsigned int> &nodes,
                            const std::vector<Point<3>>         &x)
    {
      PlaneQuadrangle quadrangle;
      for (unsigned int a = 0; a < 4; ++a)
        quadrangle[a] = plane.project(x[nodes[part.corners[a]]]);
      return quadrangle;
    }



    /// By how much the determinant of the bilinear map of a quadrangle varies,
    /// relative to that in the middle: zero of a parallelogram.
    double variation(const PlaneQuadrangle &q)
    {
      const auto cross = [](const Tensor<1, 2> &a, const Tensor<1, 2> &b) {
        return a[0] * b[1] - a[1] * b[0];
      };
      const Tensor<1, 2> x     = (q[1] - q[0]) + (q[3] - q[2]);
      const Tensor<1, 2> y     = (q[2] - q[0]) + (q[3] - q[1]);
      const Tensor<1, 2> mixed = (q[3] - q[2]) - (q[1] - q[0]);
      return (std::abs(cross(x, mixed)) + std::abs(cross(mixed, y))) /
             std::abs(cross(x, y));
    }



    /// Whether a point is in the box around a quadrangle.
    bool is_in_box(const PlaneQuadrangle &q, const Point<2> &x)
    {
      for (unsigned int i = 0; i < 2; ++i)
        if (x[i] < std::min({q[0][i], q[1][i], q[2][i], q[3][i]}) ||
            x[i] > std::max({q[0][i], q[1][i], q[2][i], q[3][i]}))
          return false;
      return true;
    }



    /**
     * The Gauss points of a triangle, exact for degree 2 n - 1. On
     * parallelograms products of two shape functions are polynomials of degree
     * p = 4, of quadratic ones 8. On others the coordinates are power series in
     * the place, whose k-th term has the factor (variation / 2)^k and raises
     * the degree by k: what is not integrated exactly is round-off, or else n
     * is the largest.
     */
    const Quadrature<2> &rule(const unsigned int degree, const double variation)
    {
      static const std::vector<Quadrature<2>> rules{
        QWitherdenVincentSimplex<2>(3),
        QWitherdenVincentSimplex<2>(4),
        QWitherdenVincentSimplex<2>(5),
        QWitherdenVincentSimplex<2>(6),
        QWitherdenVincentSimplex<2>(7)};
      const double       round_off = 1e-13;
      const unsigned int p         = 4 * degree;
      unsigned int       n         = p / 2 + 1;
      while (n < 7 && std::pow(variation / 2, 2. * n - p) > round_off)
        ++n;
      return rules[n - 3];
    }



    /// The determinant of the bilinear map of a quadrangle.
    double jacobian(const PlaneQuadrangle &q, const Point<2> &xi)
    {
      const FacetShape<3> shape(1, xi);
      Tensor<1, 2>        a, b;
      for (unsigned int k = 0; k < 4; ++k)
        {
          a += shape.first[0][k] * q[k];
          b += shape.first[1][k] * q[k];
        }
      return std::abs(a[0] * b[1] - a[1] * b[0]);
    }



    Point<3> position(const SurfaceSearch<3> &search,
                      const unsigned int      facet,
                      const Point<2>         &xi)
    {
      Projection<3> place;
      place.facet = facet;
      place.xi    = xi;
      return search.position(place);
    }
  } // namespace



  struct FaceSegments::SlaveFacet
  {
    SlaveFacet(const unsigned int       index,
               const Surface<3>        &slave,
               const FaceConfiguration &now)
      : index(index)
      , normal(now.slave_middles[index])
      , plane(position(now.slave_search, index, Point<2>()), normal)
    {
      for (const Part &part : parts_of_facet(slave.degree))
        parts.push_back(
          project(plane, part, slave.facets[index].nodes, now.slave_x));
    }

    const unsigned int           index;
    const Tensor<1, 3>           normal;
    const ProjectionPlane        plane;
    std::vector<PlaneQuadrangle> parts;
  };



  FaceConfiguration::FaceConfiguration(const Surface<3>     &slave,
                                       const Surface<3>     &master,
                                       const SymmetryPlanes &planes,
                                       const GhostedVector  &u)
    : slave_normals(planes.facet_normals(slave, u))
    , master_normals(planes.facet_normals(master, u))
    , slave_search(slave, u)
    , search(master, u)
  {
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      slave_x.push_back(slave.position(i, u));
    for (unsigned int i = 0; i < master.nodes.size(); ++i)
      master_x.push_back(master.position(i, u));
    for (unsigned int e = 0; e < slave.facets.size(); ++e)
      slave_middles.push_back(slave_search.normal(e, Point<2>()));
    for (unsigned int e = 0; e < master.facets.size(); ++e)
      master_middles.push_back(search.normal(e, Point<2>()));
  }



  FaceSegments::FaceSegments(const Surface<3>        &slave,
                             const Surface<3>        &master,
                             const FaceConfiguration &now)
    : slave(slave)
    , master(master)
    , now(now)
  {
  }



  // The master facets that face a slave facet are in its box, widened by the
  // distance of the surfaces there.
  std::vector<FaceSample> FaceSegments::samples(const unsigned int e) const
  {
    std::vector<Point<3>> x;
    for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
      x.push_back(now.slave_x[slave.facets[e].nodes[a]]);
    NormalCone<3> directions;
    directions.normals = {now.slave_middles[e]};

    double distance = 0;
    for (const Point<3> &node : x)
      {
        const Projection<3> foot = now.search.closest_facing(node, directions);
        distance =
          std::max(distance, std::sqrt(now.search.distance_square(node, foot)));
      }
    BoundingBox<3> box(x);
    box.extend(distance + 0.1 * slave.reference_length(e));
    std::vector<FaceSample> samples;
    const SlaveFacet        own(e, slave, now);
    for (const unsigned int m : now.search.facets_in(box))
      if (directions.faces(now.master_middles[m]))
        add_segment(own, m, samples);
    remove_hidden(own, samples);
    return samples;
  }



  void FaceSegments::add_segment(const SlaveFacet        &own,
                                 const unsigned int       m,
                                 std::vector<FaceSample> &samples) const
  {
    const auto &facet  = slave.facets[own.index];
    const auto &parts  = parts_of_facet(slave.degree);
    const auto &others = parts_of_facet(master.degree);
    for (const Part &other : others)
      {
        const PlaneQuadrangle t =
          project(own.plane, other, master.facets[m].nodes, now.master_x);
        for (unsigned int k = 0; k < parts.size(); ++k)
          {
            const Part            &part      = parts[k];
            const PlaneQuadrangle &s         = own.parts[k];
            const auto             triangles = intersection(s, t);
            if (triangles.empty())
              continue;
            const Quadrature<2> &quadrature =
              rule(std::max(slave.degree, master.degree),
                   std::max(variation(s), variation(t)));
            const auto distance = [&](const Point<2> &xi,
                                      const Point<2> &master_xi) {
              return position(now.slave_search, own.index, xi) -
                     position(now.search, m, master_xi);
            };
            const auto distance_at = [&](const Point<2> &place) {
              return distance(part.middle +
                                part.scale * coordinates_in(s, place),
                              other.middle +
                                other.scale * coordinates_in(t, place));
            };
            for (const PlaneTriangle &triangle : triangles)
              for (unsigned int q = 0; q < quadrature.size(); ++q)
                {
                  const Point<2> &eta = quadrature.point(q);
                  const Point<2>  place(triangle[0] +
                                       eta[0] * (triangle[1] - triangle[0]) +
                                       eta[1] * (triangle[2] - triangle[0]));
                  const Point<2>  in_s = coordinates_in(s, place);
                  FaceSample      sample;
                  sample.slave_xi = part.middle + part.scale * in_s;
                  sample.weight =
                    2 * area(triangle) * quadrature.weight(q) /
                    jacobian(s, in_s) * part.scale * part.scale *
                    slave.reference_jacobian(facet,
                                             FacetShape<3>(slave.degree,
                                                           sample.slave_xi));
                  sample.master_facet = m;
                  sample.master_xi =
                    other.middle + other.scale * coordinates_in(t, place);
                  sample.distance = distance(sample.slave_xi, sample.master_xi);
                  sample.distance_at_corner =
                    q < 3 ? distance_at(triangle[q]) : sample.distance;
                  samples.push_back(sample);
                }
          }
      }
  }



  // Facets next to each other are no further apart than they are large.
  void FaceSegments::remove_hidden(const SlaveFacet        &own,
                                   std::vector<FaceSample> &samples) const
  {
    std::map<unsigned int, std::vector<PlaneQuadrangle>> facets;
    double                                               least = 0, largest = 0;
    for (const FaceSample &sample : samples)
      {
        const double along = sample.distance * own.normal;
        least              = facets.empty() ? along : std::min(least, along);
        largest            = facets.empty() ? along : std::max(largest, along);
        facets[sample.master_facet];
      }
    const double thin = 0.1;
    if (facets.size() < 2 ||
        largest - least <= thin * slave.reference_length(own.index))
      return;
    for (auto &[m, parts] : facets)
      for (const Part &part : parts_of_facet(master.degree))
        parts.push_back(
          project(own.plane, part, master.facets[m].nodes, now.master_x));
    const auto is_hidden = [&](const FaceSample &sample) {
      const Point<3> on_slave =
        position(now.slave_search, own.index, sample.slave_xi);
      const Point<2> place = own.plane.project(on_slave);
      return std::any_of(facets.begin(), facets.end(), [&](const auto &facet) {
        return facet.first != sample.master_facet &&
               is_behind(sample, own, on_slave, place, facet);
      });
    };
    const std::vector<FaceSample> all = samples;
    samples.clear();
    std::remove_copy_if(all.begin(),
                        all.end(),
                        std::back_inserter(samples),
                        is_hidden);
  }



  // A place on a line that facets share is behind none of them.
  bool FaceSegments::is_behind(const FaceSample     &sample,
                               const SlaveFacet     &own,
                               const Point<3>       &on_slave,
                               const Point<2>       &place,
                               const ProjectedFacet &facet) const
  {
    const auto &[m, quadrangles] = facet;
    const auto &parts            = parts_of_facet(master.degree);
    for (unsigned int k = 0; k < parts.size(); ++k)
      {
        if (!is_in_box(quadrangles[k], place))
          continue;
        const Point<2> xi = coordinates_in(quadrangles[k], place);
        if (!(std::max(std::abs(xi[0]), std::abs(xi[1])) < 1))
          continue;
        const double other =
          (on_slave -
           position(now.search, m, parts[k].middle + parts[k].scale * xi)) *
          own.normal;
        if (std::abs(other) < std::abs(sample.distance * own.normal))
          return true;
      }
    return false;
  }
} // namespace Contact
