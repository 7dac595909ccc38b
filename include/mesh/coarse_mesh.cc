/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/coarse_mesh.h"

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <utility>

#include "base/errors.h"

namespace Contact
{
  namespace
  {
    /// Number of a node in the file -> our number of the vertex.
    using Vertices = std::map<long, unsigned int>;

    /// An edge by its vertices, the smaller one first.
    using Edge = std::pair<unsigned int, unsigned int>;

    Edge edge(const unsigned int a, const unsigned int b)
    {
      return std::minmax({a, b});
    }



    /// Number the nodes that are corners of cells, in the order of the file's
    /// numbers. The others (mid-sides, centres of circles) are no vertices.
    Vertices number_vertices(const MshFile &msh)
    {
      Vertices vertices;
      for (const auto &cell : msh.elements[2])
        for (const long node : cell.nodes)
          vertices[node];

      unsigned int n = 0;
      for (auto &vertex : vertices)
        vertex.second = n++;
      return vertices;
    }



    std::vector<Point<2>> vertex_points(const MshFile  &msh,
                                        const Vertices &vertices)
    {
      std::vector<Point<2>> points;
      for (const auto &vertex : vertices)
        {
          const Point<3> &p = msh.nodes.at(vertex.first);
          points.emplace_back(p[0], p[1]);
        }
      return points;
    }



    /**
     * Turn a cell round if it is clockwise. The two edges that meet at a
     * corner span an area, and that of all corners has the same sign, or the
     * cell is tangled: its Jacobian determinant changes sign inside.
     */
    void make_anticlockwise(const std::vector<Point<2>>     &points,
                            const MshFile::Element          &element,
                            const MshFile                   &msh,
                            decltype(CellData<2>::vertices) &corners)
    {
      const unsigned int  n = corners.size();
      std::vector<double> areas;
      double              scale = 0;
      for (unsigned int i = 0; i < n; ++i)
        {
          const Point<2>    &corner = points[corners[i]];
          const Tensor<1, 2> next   = points[corners[(i + 1) % n]] - corner;
          const Tensor<1, 2> last   = points[corners[(i + n - 1) % n]] - corner;
          areas.push_back(next[0] * last[1] - next[1] * last[0]);
          scale = std::max(scale, next.norm_square());
        }

      const auto [low, high] = std::minmax_element(areas.begin(), areas.end());
      if (*high < -1e-12 * scale)
        std::reverse(corners.begin(), corners.end());
      else if (*low < 1e-12 * scale)
        {
          std::string places;
          for (const unsigned int corner : corners)
            places += " " + to_string(points[corner]);
          throw InputError("element " + std::to_string(element.number) +
                             " is tangled or flat, its corners are" + places,
                           msh.where(element),
                           "quadrangles have to be convex with four corners, "
                           "triangles need an area");
        }
    }



    /// The cells with corners in cyclic order, anticlockwise.
    std::vector<CellData<2>>
    make_cells(const MshFile                                   &msh,
               const Vertices                                  &vertices,
               const std::vector<Point<2>>                     &points,
               const std::map<std::string, types::material_id> &bodies)
    {
      std::vector<CellData<2>> cells;
      for (const auto &element : msh.elements[2])
        {
          const auto &groups = element.groups;
          if (groups.size() != 1)
            throw InputError(
              groups.empty()
                ? "a cell belongs to no physical surface with a name"
                : "a cell belongs to two bodies, '" + *groups.begin() +
                    "' and '" + *groups.rbegin() + "'",
              msh.where(element),
              "every cell needs one body: Physical Surface(\"...\") = {...}; "
              "in the .geo file");

          CellData<2> cell(element.nodes.size());
          cell.material_id = bodies.at(*groups.begin());
          std::transform(element.nodes.begin(),
                         element.nodes.end(),
                         cell.vertices.begin(),
                         [&](const long node) { return vertices.at(node); });
          make_anticlockwise(points, element, msh, cell.vertices);
          cells.push_back(cell);
        }
      return cells;
    }



    /// The edges of all cells, and how many cells each has.
    using Edges = std::map<Edge, unsigned int>;

    Edges count_edges(const std::vector<CellData<2>> &cells,
                      const std::vector<Point<2>>    &points,
                      const MshFile                  &msh)
    {
      Edges edges;
      for (const auto &cell : cells)
        for (unsigned int i = 0; i < cell.vertices.size(); ++i)
          {
            const auto a = cell.vertices[i];
            const auto b = cell.vertices[(i + 1) % cell.vertices.size()];
            if (++edges[edge(a, b)] > 2)
              throw InputError("three cells share the edge from " +
                                 to_string(points[a]) + " to " +
                                 to_string(points[b]),
                               msh.name,
                               "surfaces must not overlap");
          }
      return edges;
    }



    /// The edge that a line of the file is.
    Edges::const_iterator find_edge(const MshFile::Element &line,
                                    const MshFile          &msh,
                                    const Vertices         &vertices,
                                    const Edges            &edges)
    {
      const auto a = vertices.find(line.nodes[0]);
      const auto b = vertices.find(line.nodes[1]);
      if (a != vertices.end() && b != vertices.end())
        if (const auto found = edges.find(edge(a->second, b->second));
            found != edges.end())
          return found;

      throw InputError("a line of the physical group '" + *line.groups.begin() +
                         "' is no edge of a cell",
                       msh.where(line),
                       "mesh the line and the surface together, give the "
                       "surface a physical group, or take the line out of "
                       "its own");
    }



    /// Number the combinations of groups, and tell each group its numbers.
    SubCellData number_boundaries(
      const MshFile                                       &msh,
      const Vertices                                      &vertices,
      const Edges                                         &edges,
      std::map<std::string, std::set<types::boundary_id>> &boundaries,
      std::set<std::string>                               &with_inner_lines)
    {
      SubCellData                                         subcelldata;
      std::map<std::set<std::string>, types::boundary_id> ids;
      for (const auto &line : msh.elements[1])
        if (!line.groups.empty())
          {
            // A group of lines inside of a body is known, but empty: deal.II
            // wants no ids there.
            const auto edge     = find_edge(line, msh, vertices, edges);
            const bool is_inner = edge->second == 2;
            for (const std::string &group : line.groups)
              {
                boundaries[group];
                if (is_inner)
                  with_inner_lines.insert(group);
              }
            if (is_inner)
              continue;

            CellData<1> data;
            data.vertices = {edge->first.first, edge->first.second};
            data.boundary_id =
              ids.emplace(line.groups, ids.size() + 1).first->second;
            subcelldata.boundary_lines.push_back(data);
            for (const std::string &group : line.groups)
              boundaries[group].insert(data.boundary_id);
          }
      return subcelldata;
    }



    std::map<std::string, unsigned int> find_points(const MshFile  &msh,
                                                    const Vertices &vertices)
    {
      std::map<std::string, unsigned int> points;
      for (const auto &element : msh.elements[0])
        if (const auto vertex = vertices.find(element.nodes[0]);
            vertex != vertices.end())
          for (const std::string &group : element.groups)
            if (!points.emplace(group, vertex->second).second)
              points[group] = numbers::invalid_unsigned_int;
      return points;
    }
  } // namespace



  CoarseMesh
  make_coarse_mesh(const MshFile                                   &msh,
                   const std::map<std::string, types::material_id> &bodies)
  {
    CoarseMesh coarse;
    const auto vertices = number_vertices(msh);
    coarse.vertices     = vertex_points(msh, vertices);
    coarse.cells        = make_cells(msh, vertices, coarse.vertices, bodies);
    const auto edges    = count_edges(coarse.cells, coarse.vertices, msh);
    coarse.lines        = number_boundaries(msh,
                                     vertices,
                                     edges,
                                     coarse.boundaries,
                                     coarse.with_inner_lines);
    coarse.points       = find_points(msh, vertices);
    return coarse;
  }



  std::string to_string(const Point<2> &p)
  {
    return "(" + Patterns::Tools::to_string(p) + ")";
  }
} // namespace Contact
