/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh.h"

#include <deal.II/grid/grid_tools.h>

#include <algorithm>

#include "errors.h"
#include "msh_file.h"

namespace Contact
{
  ArcManifold::ArcManifold(const Point<2> &center, const double radius)
    : center(center)
    , radius(radius)
  {
  }



  std::unique_ptr<Manifold<2>> ArcManifold::clone() const
  {
    return std::make_unique<ArcManifold>(center, radius);
  }



  Point<2> ArcManifold::get_new_point(
    const ArrayView<const Point<2>> &surrounding_points,
    const ArrayView<const double>   &weights) const
  {
    Point<2>     mean;
    unsigned int n_used = 0, n_on_circle = 0;
    for (unsigned int i = 0; i < weights.size(); ++i)
      if (std::abs(weights[i]) > 1e-10)
        {
          mean += weights[i] * surrounding_points[i];
          ++n_used;
          n_on_circle += std::abs(surrounding_points[i].distance(center) -
                                  radius) < 1e-6 * radius;
        }
    if (n_used == 2 && n_on_circle == 2)
      return center + radius / mean.distance(center) * (mean - center);
    return mean;
  }



  namespace
  {
    using Edge = std::pair<unsigned int, unsigned int>;

    Edge edge(const unsigned int a, const unsigned int b)
    {
      return { std::min(a, b), std::max(a, b) };
    }



    [[noreturn]] void wrong_cell(const MshFile          &msh,
                                 const MshFile::Element &element,
                                 const std::string      &what)
    {
      std::string corners;
      for (const long node : element.nodes)
        corners += " (" + std::to_string(msh.nodes.at(node)[0]) + ", " +
                   std::to_string(msh.nodes.at(node)[1]) + ")";
      throw InputError(what + ": element " + std::to_string(element.number) +
                         " with the corners" + corners,
                       msh.name,
                       "mend the mesh there");
    }



    /// Twice the signed area of a triangle.
    double twice_area(const Point<3> &a, const Point<3> &b, const Point<3> &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }



    /// Turn a clockwise cell round; refuse one that is neither: tangled.
    void orient(const MshFile &msh, MshFile::Element &element)
    {
      const unsigned int n          = element.nodes.size();
      unsigned int       n_positive = 0, n_negative = 0;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double area =
            twice_area(msh.nodes.at(element.nodes[i]),
                       msh.nodes.at(element.nodes[(i + 1) % n]),
                       msh.nodes.at(element.nodes[(i + 2) % n]));
          n_positive += area > 0;
          n_negative += area < 0;
        }
      if (n_negative == n)
        std::reverse(element.nodes.begin(), element.nodes.end());
      else if (n_positive != n)
        wrong_cell(msh, element, "a cell is tangled, concave or without area");
    }



    /// Collects from the file what a triangulation is made of.
    class Builder
    {
    public:
      explicit Builder(MshFile &msh)
        : msh(msh)
      {
      }

      void add_cells(std::map<std::string, types::material_id> &bodies);
      void add_lines(
        std::map<std::string, std::set<types::boundary_id>> &boundaries);
      void add_points(std::map<std::string, std::vector<unsigned int>> &points);
      void create(Triangulation<2> &triangulation);

    private:
      unsigned int vertex(const long node);

      MshFile                     &msh;
      std::map<long, unsigned int> vertex_of_node;
      std::vector<Point<2>>        vertices;
      std::vector<CellData<2>>     quadrangles, triangles;
      std::map<Edge, unsigned int> n_cells_at;
      SubCellData                  subcells;
    };



    unsigned int Builder::vertex(const long node)
    {
      const auto known = vertex_of_node.emplace(node, vertices.size());
      if (known.second)
        {
          const Point<3> &x = msh.nodes.at(node);
          vertices.emplace_back(x[0], x[1]);
        }
      return known.first->second;
    }



    void Builder::add_cells(std::map<std::string, types::material_id> &bodies)
    {
      std::map<long, int> group_of_element;
      for (MshFile::Element &element : msh.elements[2])
        {
          if (element.groups.empty())
            wrong_cell(msh, element, "a cell belongs to no physical surface");
          const int  group = element.groups.front();
          const auto known = group_of_element.emplace(element.number, group);
          if (element.groups.size() > 1 || known.first->second != group)
            wrong_cell(msh, element, "a cell belongs to two bodies");

          const auto name = msh.names[2].find(group);
          if (name == msh.names[2].end())
            throw InputError("physical surface " + std::to_string(group) +
                               " has no name",
                             msh.name,
                             "name the physical surfaces: they are the bodies");
          orient(msh, element);

          const unsigned int n = element.nodes.size();
          CellData<2>        cell(n);
          // deal.II numbers the corners of a quadrangle lexicographically.
          for (unsigned int i = 0; i < n; ++i)
            cell.vertices[n == 4 && i > 1 ? 5 - i : i] =
              vertex(element.nodes[i]);
          cell.material_id =
            bodies.emplace(name->second, bodies.size()).first->second;
          for (unsigned int i = 0; i < n; ++i)
            ++n_cells_at[edge(vertex(element.nodes[i]),
                              vertex(element.nodes[(i + 1) % n]))];
          (n == 4 ? quadrangles : triangles).push_back(cell);
        }
      if (bodies.empty())
        throw InputError("the mesh has no physical surface",
                         msh.name,
                         "name at least one surface: it is a body");
    }



    void Builder::add_lines(
      std::map<std::string, std::set<types::boundary_id>> &boundaries)
    {
      // A group without a boundary line is still a group of the mesh.
      for (const auto &[tag, name] : msh.names[1])
        boundaries[name];

      std::map<Edge, std::set<int>> groups_of;
      for (const MshFile::Element &element : msh.elements[1])
        {
          const auto a = vertex_of_node.find(element.nodes[0]);
          const auto b = vertex_of_node.find(element.nodes[1]);
          if (a == vertex_of_node.end() || b == vertex_of_node.end())
            continue;
          const Edge line    = edge(a->second, b->second);
          const auto n_cells = n_cells_at.find(line);
          // Lines inside a body carry no boundary.
          if (n_cells != n_cells_at.end() && n_cells->second == 1)
            groups_of[line].insert(element.groups.begin(),
                                   element.groups.end());
        }

      std::map<std::set<int>, types::boundary_id> id_of;
      for (const auto &[line, groups] : groups_of)
        {
          CellData<1> boundary_line;
          boundary_line.vertices = { line.first, line.second };
          boundary_line.boundary_id =
            id_of.emplace(groups, id_of.size() + 1).first->second;
          subcells.boundary_lines.push_back(boundary_line);
          for (const int group : groups)
            if (msh.names[1].count(group) > 0)
              boundaries[msh.names[1].at(group)].insert(
                boundary_line.boundary_id);
        }
    }



    void Builder::add_points(
      std::map<std::string, std::vector<unsigned int>> &points)
    {
      for (const MshFile::Element &element : msh.elements[0])
        for (const int group : element.groups)
          {
            const auto name = msh.names[0].find(group);
            const auto v    = vertex_of_node.find(element.nodes[0]);
            if (name != msh.names[0].end() && v != vertex_of_node.end())
              points[name->second].push_back(v->second);
          }
    }



    void Builder::create(Triangulation<2> &triangulation)
    {
      // Only quadrangles have to be turned to agree on the direction of their
      // shared lines; the function knows of no triangles.
      GridTools::consistently_order_cells(quadrangles);
      std::vector<CellData<2>> cells = quadrangles;
      cells.insert(cells.end(), triangles.begin(), triangles.end());
      triangulation.create_triangulation(vertices, cells, subcells);
    }



    std::string listed(const std::vector<std::string> &names)
    {
      std::string text;
      for (const std::string &name : names)
        text += (text.empty() ? "" : ", ") + name;
      return text.empty() ? "none" : text;
    }



    template<typename Map>
    const typename Map::mapped_type &find_group(const Map         &groups,
                                                const std::string &kind,
                                                const std::string &name,
                                                const std::string &entry)
    {
      const auto group = groups.find(name);
      if (group == groups.end())
        {
          std::vector<std::string> names;
          for (const auto &known : groups)
            names.push_back(known.first);
          throw InputError("the mesh has no " + kind + " '" + name + "'",
                           entry,
                           "use one of the groups of the mesh: " +
                             listed(names));
        }
      return group->second;
    }
  } // namespace



  Mesh::Mesh(const Parameters::Mesh &parameters)
  {
    MshFile msh = read_msh(parameters.file);
    Builder builder(msh);
    builder.add_cells(bodies);
    builder.add_lines(boundaries);
    builder.add_points(points);
    builder.create(triangulation);
    for (const auto &[name, arc] : parameters.arcs)
      attach_arc(name, Point<2>(arc[0], arc[1]), arc[2]);
    triangulation.refine_global(parameters.refinements);
  }



  void Mesh::attach_arc(const std::string &name,
                        const Point<2>    &center,
                        const double       radius)
  {
    const auto              &ids = boundary(name, "Mesh/Arcs");
    const types::manifold_id id  = triangulation.get_manifold_ids().size();
    for (const auto &cell : triangulation.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary() &&
            ids.count(cell->face(f)->boundary_id()) > 0)
          {
            for (const unsigned int v : cell->face(f)->vertex_indices())
              {
                const Point<2> &x   = cell->face(f)->vertex(v);
                const double    off = std::abs(x.distance(center) - radius);
                if (off > 1e-3 * radius)
                  throw InputError("'" + name +
                                     "' is no such arc: the point (" +
                                     std::to_string(x[0]) + ", " +
                                     std::to_string(x[1]) + ") is " +
                                     std::to_string(off) + " mm off",
                                   "Mesh/Arcs",
                                   "correct centre and radius");
              }
            if (cell->reference_cell().is_simplex())
              cell->set_all_manifold_ids(id);
            else
              cell->face(f)->set_manifold_id(id);
          }
    triangulation.set_manifold(id, ArcManifold(center, radius));
  }



  types::material_id Mesh::body(const std::string &name,
                                const std::string &entry) const
  {
    return find_group(bodies, "body", name, entry);
  }



  const std::set<types::boundary_id> &
  Mesh::boundary(const std::string &name, const std::string &entry) const
  {
    const auto &ids = find_group(boundaries, "boundary", name, entry);
    if (ids.empty())
      throw InputError("the group '" + name + "' has no line on the boundary",
                       entry,
                       "name a group of boundary lines");
    return ids;
  }



  unsigned int Mesh::point(const std::string &name,
                           const std::string &entry) const
  {
    const auto &vertices = find_group(points, "point", name, entry);
    if (vertices.size() != 1)
      throw InputError("the point group '" + name + "' has " +
                         std::to_string(vertices.size()) + " points",
                       entry,
                       "name a group of one point");
    return vertices.front();
  }



  std::string Mesh::body_name(const types::material_id id) const
  {
    for (const auto &[name, body] : bodies)
      if (body == id)
        return name;
    return "";
  }
} // namespace Contact
