/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh.h"

#include <deal.II/base/patterns.h>
#include <deal.II/distributed/shared_tria.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_description.h>
#include <deal.II/grid/tria_iterator.h>

#include <algorithm>
#include <utility>

#include "errors.h"
#include "msh_file.h"

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



    std::string to_string(const Point<2> &p)
    {
      return "(" + Patterns::Tools::to_string(p) + ")";
    }



    /// The group of this name, or an InputError with the names there are.
    template<typename T>
    const T &find(const std::map<std::string, T> &groups,
                  const std::string              &kind,
                  const std::string              &name,
                  const std::string              &entry)
    {
      if (groups.count(name) > 0)
        return groups.at(name);

      std::string names;
      for (const auto &group : groups)
        names += (names.empty() ? "'" : ", '") + group.first + "'";
      throw InputError("the mesh has no " + kind + " '" + name + "'",
                       "entry '" + entry + "'",
                       "of this kind it has: " +
                         (names.empty() ? "none" : names));
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
                       "mesh the line and the surface together, or take the "
                       "line out of the group");
    }



    /// Number the combinations of groups, and tell each group its numbers.
    SubCellData number_boundaries(
      const MshFile                                       &msh,
      const Vertices                                      &vertices,
      const Edges                                         &edges,
      std::map<std::string, std::set<types::boundary_id>> &boundaries)
    {
      SubCellData                                         subcelldata;
      std::map<std::set<std::string>, types::boundary_id> ids;
      for (const auto &line : msh.elements[1])
        if (!line.groups.empty())
          {
            // A group of lines inside of a body is known, but empty: deal.II
            // wants no ids there.
            const auto edge = find_edge(line, msh, vertices, edges);
            for (const std::string &group : line.groups)
              boundaries[group];
            if (edge->second == 2)
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



    /**
     * Put the cells as deal.II wants them. Its quadrangles have to agree on
     * the direction of the edges they share, which triangles need not: they
     * come last. Otherwise refinement would invert cells.
     */
    void order_cells(std::vector<CellData<2>> &cells)
    {
      const auto triangles =
        std::stable_partition(cells.begin(), cells.end(), [](const auto &cell) {
          return cell.vertices.size() == 4;
        });
      std::vector<CellData<2>> quadrangles(cells.begin(), triangles);
      for (auto &cell : quadrangles)
        std::swap(cell.vertices[2], cell.vertices[3]);
      if (!quadrangles.empty())
        GridTools::consistently_order_cells(quadrangles);
      std::copy(quadrangles.begin(), quadrangles.end(), cells.begin());
    }



    bool has_triangles(const MshFile &msh)
    {
      return std::any_of(msh.elements[2].begin(),
                         msh.elements[2].end(),
                         [](const auto &cell) {
                           return cell.nodes.size() == 3;
                         });
    }



    std::unique_ptr<Triangulation<2>>
    make_triangulation(const MshFile &msh, const MPI_Comm communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return std::make_unique<Triangulation<2>>();
      if (has_triangles(msh))
        return std::make_unique<parallel::shared::Triangulation<2>>(
          communicator,
          Triangulation<2>::none,
          /*allow_artificial_cells=*/false,
          parallel::shared::Triangulation<2>::partition_zorder);
      return std::make_unique<parallel::distributed::Triangulation<2>>(
        communicator);
    }



    /// Put the vertices where they belong; one that two bodies share can not
    /// move with both.
    void place_vertices(const std::vector<CellData<2>> &cells,
                        const Placement                &placement,
                        const MshFile                  &msh,
                        std::vector<Point<2>>          &points)
    {
      std::vector<types::material_id> body(points.size(),
                                           numbers::invalid_material_id);
      for (const auto &cell : cells)
        for (const unsigned int v : cell.vertices)
          if (body[v] == numbers::invalid_material_id)
            body[v] = cell.material_id;
          else if (!placement.move_alike(body[v], cell.material_id))
            throw InputError("two bodies share the node at " +
                               to_string(points[v]) +
                               ", but only one of them is moved",
                             msh.name,
                             "move both alike in entry 'Mesh/Move', or none");
      for (unsigned int v = 0; v < points.size(); ++v)
        points[v] = placement(points[v], body[v]);
    }



    void check_arc(const Arc &arc, const Point<2> &p, const std::string &name)
    {
      if (!arc.on_circle(p))
        throw InputError("the point " + to_string(p) + " of the arc '" + name +
                           "' is " +
                           std::to_string(p.distance(arc.center) - arc.radius) +
                           " away from its circle",
                         "entry 'Mesh/Arcs'",
                         "correct the circle, or the group in the mesh");
    }
  } // namespace



  Placement::Placement(const Parameters::Mesh &parameters,
                       const std::map<std::string, types::material_id> &bodies)
    : scale(parameters.scale)
    , cosine(std::cos(parameters.rotation * numbers::PI / 180))
    , sine(std::sin(parameters.rotation * numbers::PI / 180))
    , shift({parameters.shift[0], parameters.shift[1]})
    , moves(bodies.size())
  {
    for (const auto &[name, move] : parameters.move)
      moves[find(bodies, "body", name, "Mesh/Move")] =
        Tensor<1, 2>({move[0], move[1]});
  }



  Point<2> Placement::operator()(const Point<2>          &p,
                                 const types::material_id body) const
  {
    const Tensor<1, 2> q = scale * (p + moves[body]);
    return Point<2>(cosine * q[0] - sine * q[1] + shift[0],
                    sine * q[0] + cosine * q[1] + shift[1]);
  }



  bool Placement::move_alike(const types::material_id a,
                             const types::material_id b) const
  {
    return moves[a] == moves[b];
  }



  Mesh::Mesh(const Parameters::Mesh &parameters, const MPI_Comm communicator)
    : Mesh(parameters, read_msh(parameters.file), communicator)
  {
  }



  Mesh::Mesh(const Parameters::Mesh &parameters,
             const MshFile          &msh,
             const MPI_Comm          communicator)
    : communicator(communicator)
    , owned_triangulation(make_triangulation(msh, communicator))
    , triangulation(*owned_triangulation)
  {
    for (const auto &body : msh.names[2])
      bodies.emplace(body.second, bodies.size());

    const Placement placement(parameters, bodies);

    const auto vertices    = number_vertices(msh);
    auto       coordinates = vertex_points(msh, vertices);
    auto       cells       = make_cells(msh, vertices, coordinates, bodies);
    const auto edges       = count_edges(cells, coordinates, msh);
    const auto lines = number_boundaries(msh, vertices, edges, boundaries);
    points           = find_points(msh, vertices);

    place_vertices(cells, placement, msh, coordinates);
    order_cells(cells);
    triangulation.create_triangulation(coordinates, cells, lines);
    set_arcs(parameters, placement);
    triangulation.refine_global(parameters.refinements);
  }



  void Mesh::set_arcs(const Parameters::Mesh &parameters,
                      const Placement        &placement)
  {
    const types::manifold_id arc_id = 1;
    std::vector<Arc>         arcs;
    for (const auto &[name, circle] : parameters.arcs)
      {
        const auto                       &ids = boundary(name, "Mesh/Arcs");
        std::map<types::material_id, Arc> of_body;
        for (const auto &cell : triangulation.active_cell_iterators())
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
    if (arcs.empty())
      return;

    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->reference_cell() == ReferenceCells::Triangle)
        cell->set_all_manifold_ids(arc_id);
    triangulation.set_manifold(arc_id, ArcManifold(arcs));
  }



  types::material_id Mesh::body(const std::string &name,
                                const std::string &entry) const
  {
    return find(bodies, "body", name, entry);
  }



  const std::set<types::boundary_id> &
  Mesh::boundary(const std::string &name, const std::string &entry) const
  {
    const auto &ids = find(boundaries, "boundary", name, entry);
    if (ids.empty())
      throw InputError("the boundary '" + name +
                         "' has only lines inside bodies",
                       "entry '" + entry + "'",
                       "name a group of lines that bound a body");
    return ids;
  }



  unsigned int Mesh::point(const std::string &name,
                           const std::string &entry) const
  {
    const unsigned int vertex = find(points, "point", name, entry);
    if (vertex == numbers::invalid_unsigned_int)
      throw InputError("the point group '" + name + "' has more than one point",
                       "entry '" + entry + "'",
                       "name a group of one point");
    return vertex;
  }



  bool Mesh::is_all_quadrilateral() const
  {
    return triangulation.all_reference_cells_are_hyper_cube();
  }



  bool Mesh::is_complete() const
  {
    return dynamic_cast<const parallel::distributed::Triangulation<2> *>(
             &triangulation) == nullptr;
  }



  std::string Mesh::body_name(const types::material_id id) const
  {
    for (const auto &[name, body] : bodies)
      if (body == id)
        return name;
    Assert(false, ExcMessage("There is no such body."));
    return "";
  }
} // namespace Contact
