/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/coarse_mesh.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/dimension.h"
#include "base/errors.h"
#include "mesh/mixed_cells.h"

namespace Contact
{
  namespace
  {
    /// A face of a cell by its vertices, in ascending order: an edge in
    /// 2-D, a triangle or a quadrangle in 3-D.
    using Face = std::vector<unsigned int>;

    using Corners = decltype(CellData<2>::vertices);



    /// The faces of a cell whose corners are in gmsh's order.
    template<int dim>
    std::vector<Face> faces_of(const Corners &corners);

    template<>
    std::vector<Face> faces_of<2>(const Corners &corners)
    {
      std::vector<Face> faces;
      for (unsigned int i = 0; i < corners.size(); ++i)
        faces.push_back({corners[i], corners[(i + 1) % corners.size()]});
      return faces;
    }

    template<>
    std::vector<Face> faces_of<3>(const Corners &corners)
    {
      std::vector<Face> faces;
      for (const auto &face : faces_of_volume(corners.size()))
        {
          faces.emplace_back();
          for (const unsigned int corner : face)
            faces.back().push_back(corners[corner]);
        }
      return faces;
    }



    /// Number the nodes that are corners of cells, in the order of the file's
    /// numbers. The others (mid-sides, centres of circles) are no vertices.
    template<int dim>
    VertexNumbers number_vertices(const MshFile &msh)
    {
      VertexNumbers vertices;
      for (const auto &cell : msh.elements[dim])
        for (const long node : cell.nodes)
          vertices[node];

      unsigned int n = 0;
      for (auto &vertex : vertices)
        vertex.second = n++;
      return vertices;
    }



    template<int dim>
    Point<dim> place_of(const long node, const MshFile &msh)
    {
      Point<dim> p;
      for (unsigned int d = 0; d < dim; ++d)
        p[d] = msh.nodes.at(node)[d];
      return p;
    }



    template<int dim>
    std::vector<Point<dim>> vertex_points(const MshFile       &msh,
                                          const VertexNumbers &vertices)
    {
      std::vector<Point<dim>> points;
      for (const auto &vertex : vertices)
        points.push_back(place_of<dim>(vertex.first, msh));
      return points;
    }



    /// The vertices are in the order of the nodes. Lines may be of no cell.
    template<int dim>
    void find_mid_sides(const MshFile       &msh,
                        const VertexNumbers &vertices,
                        CoarseMesh<dim>     &coarse)
    {
      for (const auto &[nodes, middle] : msh.mid_sides)
        {
          Face side;
          for (const long node : nodes)
            if (const auto vertex = vertices.find(node);
                vertex != vertices.end())
              side.push_back(vertex->second);
          if (side.size() == nodes.size())
            coarse.mid_sides[side] = place_of<dim>(middle, msh);
        }
    }



    /// How many cells have a face, and its corners one after the other.
    struct FaceOfCells
    {
      unsigned int n_cells = 0;
      Face         corners;
    };

    using Faces = std::map<Face, FaceOfCells>;

    template<int dim>
    Faces count_faces(const std::vector<CellData<dim>> &cells,
                      const std::vector<Point<dim>>    &points,
                      const MshFile                    &msh)
    {
      Faces faces;
      for (const auto &cell : cells)
        for (const Face &corners : faces_of<dim>(cell.vertices))
          {
            Face face = corners;
            std::sort(face.begin(), face.end());
            faces[face].corners = corners;
            if (++faces[face].n_cells > 2)
              throw InputError(std::string("three cells share the ") +
                                 Dimension<dim>::facet + " from " +
                                 to_string(points[corners[0]]) + " to " +
                                 to_string(points[corners[corners.size() / 2]]),
                               msh.name,
                               std::string(Dimension<dim>::body) +
                                 "s must not overlap");
          }
      return faces;
    }



    /// Half-way round a face from the first of the @p corners: what is opposite
    /// of it in a quadrangle, and the other end of an edge. Triangles have no
    /// such corner.
    unsigned int opposite_of_first(const Face &corners, const Face &round)
    {
      if (round.size() % 2 == 1)
        return numbers::invalid_unsigned_int;
      const auto first = std::find(round.begin(), round.end(), corners[0]);
      return round[(first - round.begin() + round.size() / 2) % round.size()];
    }



    /// The face that an element of the file is.
    template<int dim>
    Faces::const_iterator find_face(const MshFile::Element &element,
                                    const MshFile          &msh,
                                    const VertexNumbers    &vertices,
                                    const Faces            &faces)
    {
      Face corners;
      for (const long node : element.nodes)
        if (const auto vertex = vertices.find(node); vertex != vertices.end())
          corners.push_back(vertex->second);
      Face face = corners;
      std::sort(face.begin(), face.end());
      if (const auto found = faces.find(face); found != faces.end())
        {
          if (opposite_of_first(corners, corners) !=
              opposite_of_first(corners, found->second.corners))
            throw InputError(std::string("a ") + Dimension<dim>::boundary +
                               " has the corners of a " +
                               Dimension<dim>::facet +
                               " of a cell, but in an order that crosses it",
                             msh.where(element),
                             "list the corners one after the other: write the "
                             "file again");
          return found;
        }

      throw InputError(std::string("a ") + Dimension<dim>::boundary +
                         " of the physical group '" + *element.groups.begin() +
                         "' is no " + Dimension<dim>::facet + " of a cell",
                       msh.where(element),
                       std::string("mesh the ") + Dimension<dim>::boundary +
                         " and the " + Dimension<dim>::body +
                         " together, give the " + Dimension<dim>::body +
                         " a physical group, or take the " +
                         Dimension<dim>::boundary + " out of its own");
    }



    /// Those of the boundary in the form that deal.II takes.
    template<int dim>
    auto &boundary_faces(SubCellData &faces)
    {
      if constexpr (dim == 2)
        return faces.boundary_lines;
      else
        return faces.boundary_quads;
    }



    /// The corners of an element of the boundary, as deal.II numbers them.
    template<int dim>
    std::vector<unsigned int> corners_of(const MshFile::Element &element,
                                         const VertexNumbers    &vertices)
    {
      std::vector<unsigned int> corners;
      for (const long node : element.nodes)
        corners.push_back(vertices.at(node));
      if (dim == 2)
        std::sort(corners.begin(), corners.end());
      else if (corners.size() == 4)
        std::swap(corners[2], corners[3]);
      return corners;
    }



    /// Number the combinations of groups, and tell each group its numbers.
    template<int dim>
    void number_boundaries(const MshFile       &msh,
                           const VertexNumbers &vertices,
                           const Faces         &faces,
                           CoarseMesh<dim>     &coarse)
    {
      std::map<std::set<std::string>, types::boundary_id> ids;
      for (const auto &element : msh.elements[dim - 1])
        if (!element.groups.empty())
          {
            // A group of faces inside of a body is known, but empty: deal.II
            // wants no ids there.
            const bool is_inner =
              find_face<dim>(element, msh, vertices, faces)->second.n_cells ==
              2;
            for (const std::string &group : element.groups)
              {
                coarse.boundaries[group];
                if (is_inner)
                  coarse.with_inner_faces.insert(group);
              }
            if (is_inner)
              continue;

            CellData<dim - 1> data;
            data.vertices = corners_of<dim>(element, vertices);
            data.boundary_id =
              ids.emplace(element.groups, ids.size() + 1).first->second;
            boundary_faces<dim>(coarse.faces).push_back(data);
            for (const std::string &group : element.groups)
              coarse.boundaries[group].insert(data.boundary_id);
          }
    }



    /// The edges of cells on the boundary.
    std::set<Face> boundary_edges(const Faces &faces)
    {
      std::set<Face> edges;
      for (const auto &[sorted, face] : faces)
        for (unsigned int i = 0, n = face.corners.size();
             face.n_cells == 1 && i < n;
             ++i)
          {
            const unsigned int a = face.corners[i],
                               b = face.corners[(i + 1) % n];
            edges.insert({std::min(a, b), std::max(a, b)});
          }
      return edges;
    }



    /// The same of the curves on the boundary of volumes. Edges that refinement
    /// makes inside of a face have the number of the face: those of curves come
    /// behind.
    void number_curves(const MshFile       &msh,
                       const VertexNumbers &vertices,
                       const Faces         &faces,
                       CoarseMesh<3>       &coarse)
    {
      const std::set<Face> edges = boundary_edges(faces);
      std::map<std::set<std::string>, types::boundary_id> ids;
      types::boundary_id                                  n_faces = 0;
      for (const auto &face : coarse.faces.boundary_quads)
        n_faces = std::max(n_faces, face.boundary_id);
      for (const auto &element : msh.elements[1])
        if (!element.groups.empty())
          {
            Face edge;
            for (const long node : element.nodes)
              if (const auto vertex = vertices.find(node);
                  vertex != vertices.end())
                edge.push_back(vertex->second);
            std::sort(edge.begin(), edge.end());
            if (edges.count(edge) == 0)
              {
                coarse.inner_curves.insert(element.groups.begin(),
                                           element.groups.end());
                continue;
              }
            CellData<1> data;
            data.vertices = edge;
            data.boundary_id =
              ids.emplace(element.groups, n_faces + ids.size() + 1)
                .first->second;
            coarse.faces.boundary_lines.push_back(data);
            for (const std::string &group : element.groups)
              coarse.curves[group].insert(data.boundary_id);
          }
      for (const std::string &group : coarse.inner_curves)
        coarse.curves.erase(group);
    }



    // A group with nodes in the middle of edges is left out: its other nodes
    // alone are another one.
    std::map<std::string, std::vector<unsigned int>>
    find_points(const MshFile &msh, const VertexNumbers &vertices)
    {
      std::map<std::string, std::set<unsigned int>> found;
      std::set<std::string>                         incomplete;
      for (const auto &element : msh.elements[0])
        for (const std::string &group : element.groups)
          if (const auto vertex = vertices.find(element.nodes[0]);
              vertex != vertices.end())
            found[group].insert(vertex->second);
          else
            incomplete.insert(group);

      std::map<std::string, std::vector<unsigned int>> points;
      for (const auto &[group, corners] : found)
        if (incomplete.count(group) == 0)
          points.try_emplace(group, corners.begin(), corners.end());
      return points;
    }
  } // namespace



  template<int dim>
  CoarseMesh<dim>
  make_coarse_mesh(const MshFile                                   &msh,
                   const std::map<std::string, types::material_id> &bodies)
  {
    CoarseMesh<dim> coarse;
    const auto      vertices = number_vertices<dim>(msh);
    coarse.vertices          = vertex_points<dim>(msh, vertices);
    coarse.cells     = make_cells(msh, vertices, coarse.vertices, bodies);
    const auto faces = count_faces(coarse.cells, coarse.vertices, msh);
    number_boundaries(msh, vertices, faces, coarse);
    if constexpr (dim == 3)
      number_curves(msh, vertices, faces, coarse);
    find_mid_sides(msh, vertices, coarse);
    coarse.points = find_points(msh, vertices);
    return coarse;
  }



  template CoarseMesh<2>
  make_coarse_mesh<2>(const MshFile &,
                      const std::map<std::string, types::material_id> &);
  template CoarseMesh<3>
  make_coarse_mesh<3>(const MshFile &,
                      const std::map<std::string, types::material_id> &);
} // namespace Contact
