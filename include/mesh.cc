/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh.h"

#include <deal.II/base/geometry_info.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "errors.h"
#include "msh_file.h"

namespace Contact
{
  bool Arc::on_circle(const Point<2> &p) const
  {
    return std::abs(p.distance(center) - radius) < tolerance * radius;
  }



  bool Arc::over_one_chord(const Point<2> &p, const Point<2> &q) const
  {
    // Of the points of the circle, those beyond the chord as seen from the
    // centre are the piece over it. The ends are on the chord up to round-off.
    const auto beyond = [this](const Point<2> &a, const auto &chord) {
      const Tensor<1, 2> middle = 0.5 * (chord[0] + chord[1] - 2. * center);
      return (a - center - middle) * middle > -1e-10 * radius * radius;
    };

    return on_circle(p) && on_circle(q) &&
           std::any_of(chords.begin(), chords.end(), [&](const auto &chord) {
             return beyond(p, chord) && beyond(q, chord);
           });
  }



  ArcManifold::ArcManifold(const std::vector<Arc> &arcs)
    : arcs(arcs)
  {}



  std::unique_ptr<Manifold<2>> ArcManifold::clone() const
  {
    return std::make_unique<ArcManifold>(arcs);
  }



  Point<2> ArcManifold::get_new_point(
    const ArrayView<const Point<2>> &surrounding_points,
    const ArrayView<const double>   &weights) const
  {
    // The corners of a triangle are all handed over, with the weight zero for
    // the one opposite to a mid-side.
    Point<2>              mean;
    std::vector<Point<2>> contributing;
    for (unsigned int i = 0; i < weights.size(); ++i)
      if (std::abs(weights[i]) > 1e-12)
        {
          mean += weights[i] * surrounding_points[i];
          contributing.push_back(surrounding_points[i]);
        }

    if (contributing.size() == 2)
      for (const Arc &arc : arcs)
        if (arc.over_one_chord(contributing[0], contributing[1]))
          {
            const Tensor<1, 2> ray = mean - arc.center;
            return arc.center + arc.radius / ray.norm() * ray;
          }
    return mean;
  }



  namespace
  {
    /// A line by its vertices, the smaller one first.
    using Edge = std::pair<unsigned int, unsigned int>;

    Edge edge(const unsigned int a, const unsigned int b)
    {
      return std::minmax({ a, b });
    }



    /// A cell in our vertex numbers, anticlockwise.
    struct Cell
    {
      std::vector<unsigned int> corners;
      types::material_id        body;
    };



    std::string to_string(const Point<2> &p)
    {
      std::ostringstream out;
      out << "(" << p << ")";
      std::string text = out.str();
      std::replace(text.begin(), text.end(), ' ', ',');
      return text;
    }



    /// Where something is wrong in the file, beyond its syntax.
    std::string where(const MshFile &msh, const MshFile::Element &element)
    {
      return msh.name + ", element " + std::to_string(element.number);
    }



    /// 'a', 'b' and what else the keys of a map are; for messages.
    template <typename T>
    std::string list(const std::map<std::string, T> &groups)
    {
      std::string names;
      for (const auto &group : groups)
        names += (names.empty() ? "'" : ", '") + group.first + "'";
      return names.empty() ? "none" : names;
    }



    template <typename T>
    const T &find(const std::map<std::string, T> &groups,
                  const std::string              &kind,
                  const std::string              &name,
                  const std::string              &entry)
    {
      const auto group = groups.find(name);
      if (group == groups.end())
        throw InputError("the mesh has no " + kind + " '" + name + "'",
                         "entry '" + entry + "'",
                         "of this kind the mesh has: " + list(groups));
      return group->second;
    }



    /// A group that is named but empty is a slip in the geometry's file.
    void check_groups(const MshFile &msh)
    {
      for (unsigned int dimension = 0; dimension < msh.names.size(); ++dimension)
        {
          std::set<int> used;
          if (dimension < msh.elements.size())
            for (const auto &element : msh.elements[dimension])
              used.insert(element.groups.begin(), element.groups.end());

          for (const auto &[tag, name] : msh.names[dimension])
            if (used.count(tag) == 0)
              throw InputError("the physical group '" + name +
                                 "' of dimension " +
                                 std::to_string(dimension) + " is empty",
                               msh.name,
                               "give it elements or delete it");
        }
    }



    /// Number the nodes that are corners of cells, in the order of the file's
    /// numbers. The others (mid-sides, centres of circles) are no vertices.
    std::map<long, unsigned int> number_vertices(const MshFile &msh)
    {
      std::map<long, unsigned int> vertices;
      for (const auto &cell : msh.elements[2])
        for (const long node : cell.nodes)
          {
            if (msh.nodes.count(node) == 0)
              throw InputError("node " + std::to_string(node) +
                                 " does not exist",
                               where(msh, cell),
                               "write the mesh file again");
            vertices.emplace(node, 0);
          }

      unsigned int n = 0;
      for (auto &vertex : vertices)
        vertex.second = n++;
      return vertices;
    }



    /// The vertices' coordinates in the plane, which may have any height.
    std::vector<Point<2>>
    vertex_points(const MshFile                      &msh,
                  const std::map<long, unsigned int> &vertices)
    {
      std::vector<Point<2>> points;
      double                extent = 0, lowest = 0, highest = 0;
      for (const auto &vertex : vertices)
        {
          const Point<3> &p = msh.nodes.at(vertex.first);
          points.emplace_back(p[0], p[1]);
          extent  = std::max(extent, points.front().distance(points.back()));
          lowest  = points.size() == 1 ? p[2] : std::min(lowest, p[2]);
          highest = points.size() == 1 ? p[2] : std::max(highest, p[2]);
        }

      if (highest - lowest > 1e-9 * extent)
        throw InputError("the mesh is not plane: z goes from " +
                           std::to_string(lowest) + " to " +
                           std::to_string(highest),
                         msh.name,
                         "mesh surfaces in a plane of constant z");
      return points;
    }



    /// Physical surface tag -> material id: 0, 1, ... in the order of tags.
    std::map<int, types::material_id> number_bodies(const MshFile &msh)
    {
      std::map<int, types::material_id> bodies;
      for (const auto &body : msh.names[2])
        bodies.emplace(body.first, bodies.size());
      if (bodies.empty())
        throw InputError("the mesh has no physical surface with a name",
                         msh.name,
                         "name the bodies: Physical Surface(\"...\") = {...}; "
                         "in the .geo file");
      return bodies;
    }



    types::material_id
    body_of(const MshFile::Element                  &cell,
            const std::map<int, types::material_id> &bodies,
            const MshFile                           &msh)
    {
      if (cell.groups.empty() || bodies.count(cell.groups[0]) == 0)
        throw InputError("a cell belongs to no physical surface with a name",
                         where(msh, cell),
                         "every cell needs a body: Physical Surface(\"...\") "
                         "= {...}; in the .geo file");
      for (const int tag : cell.groups)
        if (tag != cell.groups[0])
          throw InputError("a cell belongs to two physical surfaces",
                           where(msh, cell),
                           "every cell belongs to precisely one body");
      return bodies.at(cell.groups[0]);
    }



    /**
     * Turn a cell round if it is clockwise. At each corner the two edges that
     * meet there span the same orientation, or the cell is tangled: then its
     * Jacobian vanishes somewhere inside.
     */
    void make_anticlockwise(const std::vector<Point<2>> &points,
                            std::vector<unsigned int>   &corners,
                            const MshFile::Element      &element,
                            const MshFile               &msh)
    {
      const unsigned int  n = corners.size();
      std::vector<double> determinants;
      double              size = 0;
      std::string         list;
      for (unsigned int i = 0; i < n; ++i)
        {
          const Point<2>    &corner = points[corners[i]];
          const Tensor<1, 2> next   = points[corners[(i + 1) % n]] - corner;
          const Tensor<1, 2> last   = points[corners[(i + n - 1) % n]] - corner;
          determinants.push_back(cross_product_2d(last) * next);
          size = std::max(size, next.norm_square());
          list += " " + to_string(corner);
        }

      const auto [low, high] =
        std::minmax_element(determinants.begin(), determinants.end());
      if (*high < -1e-12 * size)
        std::reverse(corners.begin(), corners.end());
      else if (*low < 1e-12 * size)
        throw InputError("a cell is tangled or has no area, its corners are" +
                           list,
                         where(msh, element),
                         "quadrangles have to be convex, with four corners");
    }



    std::vector<Cell>
    make_cells(const MshFile                           &msh,
               const std::map<long, unsigned int>      &vertices,
               const std::vector<Point<2>>             &points,
               const std::map<int, types::material_id> &bodies)
    {
      std::vector<Cell> cells;

      // A cell of two groups stands twice in a file of format 2.2.
      std::map<std::set<unsigned int>, types::material_id> known;
      for (const auto &element : msh.elements[2])
        {
          Cell cell;
          cell.body = body_of(element, bodies, msh);
          for (const long node : element.nodes)
            cell.corners.push_back(vertices.at(node));
          make_anticlockwise(points, cell.corners, element, msh);

          const auto [entry, is_new] =
            known.insert({ { cell.corners.begin(), cell.corners.end() },
                           cell.body });
          if (is_new)
            cells.push_back(cell);
          else if (entry->second != cell.body)
            throw InputError("a cell belongs to two physical surfaces",
                             where(msh, element),
                             "every cell belongs to precisely one body");
        }
      return cells;
    }
  } // namespace
} // namespace Contact
