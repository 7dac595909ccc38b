/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/round_boundaries.h"

#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "mesh/arcs.h"
#include "mesh/coarse_mesh.h"
#include "mesh/round_surface.h"

namespace Contact
{
  namespace
  {
    void check_arc(const Arc &arc, const Point<2> &p, const std::string &name)
    {
      if (!arc.on_circle(p))
        throw InputError("the point " + to_string(p) + " of the arc '" + name +
                           "' is " +
                           brief(p.distance(arc.center) - arc.radius) +
                           " mm away from its circle",
                         "entry 'Mesh/Arcs'",
                         "correct the circle, or the group in the mesh");
    }



    void check_round(const RoundSurface &surface,
                     const Point<3>     &p,
                     const std::string  &name,
                     const std::string  &entry)
    {
      const double distance = p.distance(surface.closest(p));
      if (!(distance < Arc::tolerance * surface.size(p)))
        throw InputError("the point " + to_string(p) + " of the boundary '" +
                           name + "' is " + brief(distance) +
                           " mm away from its surface",
                         "entry '" + entry + "'",
                         "correct the surface, or the group in the mesh");
    }



    template<class Side, int dim>
    auto find_middle(const Side &side, const MidSides<dim> &mid_sides)
    {
      std::vector<unsigned int> vertices;
      for (const unsigned int v : side->vertex_indices())
        vertices.push_back(side->vertex_index(v));
      std::sort(vertices.begin(), vertices.end());
      return mid_sides.find(vertices);
    }



    /// The way to the mid-side node of a line from its middle; zero where that
    /// is within the digits of the file. The coordinate along a parabola grows
    /// as long as its node is in the middle half.
    template<class Line, int dim>
    Tensor<1, dim> bulge_of(const Line &line, const MidSides<dim> &mid_sides)
    {
      if (mid_sides.empty())
        return Tensor<1, dim>();
      const auto middle = find_middle(line, mid_sides);
      if (middle == mid_sides.end())
        return Tensor<1, dim>();
      const Tensor<1, dim> chord = line->vertex(1) - line->vertex(0),
                           bulge = middle->second - line->center();
      if (!(4 * std::abs(bulge * chord) < chord.norm_square()))
        throw InputError("the mid-side node at " + to_string(middle->second) +
                           " is not in the middle half of its side",
                         "entry 'Mesh/Mid-side nodes'",
                         "mesh anew, or remove the entry");
      return bulge.norm() < Arc::tolerance * chord.norm() ? Tensor<1, dim>()
                                                          : bulge;
    }



    using SurfaceIn =
      std::function<RoundSurface(const std::vector<double> &numbers,
                                 const types::material_id   body)>;

    /// Make the boundaries of one entry round: those of a surface by its
    /// numbers, where the body that they bound has it.
    void
    make_parts_round(const std::map<std::string, std::vector<double>> &surfaces,
                     const std::string                                &entry,
                     const SurfaceIn    &surface_in,
                     Mesh<3>            &mesh,
                     types::manifold_id &n_manifolds)
    {
      for (const auto &[name, numbers] : surfaces)
        {
          const auto &ids = mesh.boundary(name, entry);
          std::map<types::material_id, types::manifold_id> manifold_of;
          for (const auto &cell : mesh.triangulation.active_cell_iterators())
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
                {
                  const auto body    = cell->material_id();
                  const auto surface = surface_in(numbers, body);
                  const auto [id, is_new] =
                    manifold_of.emplace(body, n_manifolds + 1);
                  if (is_new)
                    mesh.triangulation.set_manifold(++n_manifolds,
                                                    RoundManifold(surface));
                  for (const unsigned int v : face->vertex_indices())
                    check_round(surface, face->vertex(v), name, entry);
                  face->set_all_manifold_ids(id->second);
                }
        }
    }



    /// The corners of a face and the bulges of its lines; false if it has none.
    template<class Face, std::size_t n>
    bool find_bulges(const Face                  &face,
                     const MidSides<3>           &mid_sides,
                     std::array<Point<3>, n>     &corners,
                     std::array<Tensor<1, 3>, n> &bulges)
    {
      double largest = 0;
      for (unsigned int i = 0; i < n; ++i)
        {
          corners[i] = face->vertex(i);
          bulges[i]  = bulge_of(face->line(i), mid_sides);
          largest    = std::max(largest, bulges[i].norm());
        }
      return largest > 0;
    }



    /// The curved face of a hexahedron or tetrahedron; none if it is flat.
    template<class Face>
    std::unique_ptr<CurvedFace> curved_face(const Face        &face,
                                            const MidSides<3> &mid_sides)
    {
      if (face->n_vertices() == 3)
        {
          std::array<Point<3>, 3>     corners;
          std::array<Tensor<1, 3>, 3> bulges;
          if (find_bulges(face, mid_sides, corners, bulges))
            return std::make_unique<CurvedTriangle>(corners, bulges);
          return nullptr;
        }
      std::array<Point<3>, 4>     corners;
      std::array<Tensor<1, 3>, 4> bulges;
      std::optional<Point<3>>     centre;
      if (!find_bulges(face, mid_sides, corners, bulges))
        return nullptr;
      if (const auto found = find_middle(face, mid_sides);
          found != mid_sides.end())
        centre = found->second;
      return std::make_unique<CurvedQuadrangle>(corners, bulges, centre);
    }



    void make_sides_curved(const MidSides<3>  &mid_sides,
                           Mesh<3>            &mesh,
                           types::manifold_id &n_manifolds)
    {
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          {
            if (face->manifold_id() != numbers::flat_manifold_id)
              continue;
            const auto curved = curved_face(face, mid_sides);
            if (!curved)
              continue;
            mesh.triangulation.set_manifold(++n_manifolds, *curved);
            face->set_manifold_id(n_manifolds);
            for (unsigned int i = 0; i < face->n_lines(); ++i)
              if (bulge_of(face->line(i), mid_sides).norm() > 0)
                face->line(i)->set_manifold_id(n_manifolds);
          }
    }
  } // namespace



  void make_round(const Parameters::Mesh &parameters,
                  const Placement<2>     &placement,
                  const MidSides<2>      &mid_sides,
                  Mesh<2>                &mesh)
  {
    for (const auto *surfaces : {&parameters.spheres,
                                 &parameters.cylinders,
                                 &parameters.cones,
                                 &parameters.tori})
      if (!surfaces->empty())
        throw InputError("the boundary '" + surfaces->begin()->first +
                           "' of a plane mesh is no surface",
                         "section 'Mesh'",
                         "name it in Mesh/Arcs");
    const types::manifold_id arc_id = 1;
    std::vector<Arc>         arcs;
    for (const auto &[name, circle] : parameters.arcs)
      {
        const auto &ids = mesh.boundary(name, "Mesh/Arcs");
        std::map<types::material_id, Arc> of_body;
        for (const auto &cell : mesh.triangulation.active_cell_iterators())
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
              {
                const auto body = cell->material_id();
                Arc       &arc  = of_body[body];
                arc.center = placement(Point<2>(circle[0], circle[1]), body);
                arc.radius = placement.scale * circle[2];
                for (const unsigned int v : face->vertex_indices())
                  check_arc(arc, face->vertex(v), name);
                arc.chords.push_back({{face->vertex(0), face->vertex(1)}});
                face->set_manifold_id(arc_id);
              }
        for (const auto &[body, arc] : of_body)
          arcs.push_back(arc);
      }
    std::vector<Parabola> parabolas;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->manifold_id() != arc_id)
          if (const auto bulge = bulge_of(face, mid_sides); bulge.norm() > 0)
            {
              parabolas.push_back(
                {face->vertex(0), face->vertex(1), face->center() + bulge});
              face->set_manifold_id(arc_id);
            }
    if (arcs.empty() && parabolas.empty())
      return;

    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      if (cell->reference_cell() == ReferenceCells::Triangle)
        cell->set_all_manifold_ids(arc_id);
    mesh.triangulation.set_manifold(arc_id, ArcManifold(arcs, parabolas));
  }



  void make_round(const Parameters::Mesh &parameters,
                  const Placement<3>     &placement,
                  const MidSides<3>      &mid_sides,
                  Mesh<3>                &mesh)
  {
    if (!parameters.arcs.empty())
      throw InputError("the mesh is no plane one, and has no arcs",
                       "entry 'Mesh/Arcs'",
                       "use Mesh/Cylinders, Spheres, Cones or Tori");
    const double       scale       = placement.scale;
    types::manifold_id n_manifolds = 0;
    make_sides_curved(mid_sides, mesh, n_manifolds);
    const auto place = [&](const auto &n, const types::material_id body) {
      return placement(Point<3>(n[0], n[1], n[2]), body);
    };
    const auto axis = [&](const auto &n) {
      return placement.turned(Point<3>(n[3], n[4], n[5]));
    };
    const auto make_all = [&](const auto        &surfaces,
                              const std::string &entry,
                              const SurfaceIn   &surface_in) {
      make_parts_round(surfaces, entry, surface_in, mesh, n_manifolds);
    };
    make_all(parameters.spheres,
             "Mesh/Spheres",
             [&](const auto &n, const auto body) {
               return sphere(place(n, body), scale * n[3]);
             });
    make_all(parameters.cylinders,
             "Mesh/Cylinders",
             [&](const auto &n, const auto body) {
               return cylinder(place(n, body), axis(n), scale * n[6]);
             });
    make_all(parameters.cones,
             "Mesh/Cones",
             [&](const auto &n, const auto body) {
               return cone(place(n, body), axis(n), n[6] * numbers::PI / 180);
             });
    make_all(parameters.tori, "Mesh/Tori", [&](const auto &n, const auto body) {
      return torus(place(n, body), axis(n), scale * n[6], scale * n[7]);
    });
  }
} // namespace Contact
