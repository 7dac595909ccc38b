/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_tests_volume_mesh_h
#define contact_tests_volume_mesh_h

#include <deal.II/base/point.h>

#include <array>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /// A place in 3-D for every place in the unit cube.
  using VolumeChart = std::function<Point<3>(const Point<3> &)>;

  inline VolumeChart box(const Point<3> &low, const Point<3> &high)
  {
    return [=](const Point<3> &s) {
      Point<3> p;
      for (unsigned int d = 0; d < 3; ++d)
        p[d] = low[d] + s[d] * (high[d] - low[d]);
      return p;
    };
  }



  /// A mesh made of blocks of hexahedra or tetrahedra, written as a gmsh file.
  class VolumeText
  {
  public:
    /// How the corners of a cell are listed, by their place in gmsh's order.
    using Order = std::array<unsigned int, 8>;

    static constexpr Order gmsh_order = {{0, 1, 2, 3, 4, 5, 6, 7}};

    /**
     * The body @p name of @p n hexahedra along each direction, or six
     * tetrahedra for each, round the diagonal from its first corner. Sides are
     * the groups "NAME left" (s = 0), "right", "front" (t = 0), "back",
     * "bottom" and "top", the corner at the origin of the cube the group "NAME
     * corner".
     */
    void block(const std::string                 &name,
               const std::array<unsigned int, 3> &n,
               const VolumeChart                 &chart,
               const Order                       &order         = gmsh_order,
               const bool                         of_tetrahedra = false)
    {
      const unsigned int first = nodes.size() + 1;
      for (unsigned int k = 0; k <= n[2]; ++k)
        for (unsigned int j = 0; j <= n[1]; ++j)
          for (unsigned int i = 0; i <= n[0]; ++i)
            nodes.push_back(
              chart(Point<3>(1. * i / n[0], 1. * j / n[1], 1. * k / n[2])));
      const auto node =
        [=](const unsigned int i, const unsigned int j, const unsigned int k) {
          return first + (k * (n[1] + 1) + j) * (n[0] + 1) + i;
        };

      for (unsigned int k = 0; k < n[2]; ++k)
        for (unsigned int j = 0; j < n[1]; ++j)
          for (unsigned int i = 0; i < n[0]; ++i)
            {
              const std::array<unsigned int, 8> corners = {
                {node(i, j, k),
                 node(i + 1, j, k),
                 node(i + 1, j + 1, k),
                 node(i, j + 1, k),
                 node(i, j, k + 1),
                 node(i + 1, j, k + 1),
                 node(i + 1, j + 1, k + 1),
                 node(i, j + 1, k + 1)}};
              if (of_tetrahedra)
                {
                  add_tetrahedra(name, corners);
                  continue;
                }
              std::vector<unsigned int> listed;
              for (const unsigned int c : order)
                listed.push_back(corners[c]);
              add(3, name, listed);
            }

      const std::array<std::array<const char *, 2>, 3> sides = {
        {{{"left", "right"}}, {{"front", "back"}}, {{"bottom", "top"}}}};
      for (unsigned int d = 0; d < 3; ++d)
        for (unsigned int end = 0; end < 2; ++end)
          {
            const unsigned int e = (d + 1) % 3, f = (d + 2) % 3;
            for (unsigned int a = 0; a < n[e]; ++a)
              for (unsigned int b = 0; b < n[f]; ++b)
                {
                  const auto at = [&](const unsigned int x,
                                      const unsigned int y) {
                    std::array<unsigned int, 3> i;
                    i[d] = end * n[d];
                    i[e] = x;
                    i[f] = y;
                    return node(i[0], i[1], i[2]);
                  };
                  const std::string side = name + ' ' + sides[d][end];
                  if (!of_tetrahedra)
                    add(
                      2,
                      side,
                      {at(a, b), at(a + 1, b), at(a + 1, b + 1), at(a, b + 1)});
                  else
                    for (const unsigned int other :
                         {at(a + 1, b), at(a, b + 1)})
                      add(2, side, {at(a, b), other, at(a + 1, b + 1)}, 2);
                }
          }
      add(0, name + " corner", {node(0, 0, 0)});
    }

    /// The tetrahedra of a hexahedron, each from corner to corner along three
    /// edges in another order.
    void add_tetrahedra(const std::string                 &name,
                        const std::array<unsigned int, 8> &corners)
    {
      const std::array<std::array<unsigned int, 2>, 6> paths = {
        {{{1, 2}}, {{1, 5}}, {{3, 2}}, {{3, 7}}, {{4, 5}}, {{4, 7}}}};
      for (const auto &[a, b] : paths)
        add(3, name, {corners[0], corners[a], corners[b], corners[6]}, 4);
    }

    /// An element of any dimension and of gmsh's type by its corners.
    void add(const unsigned int               dimension,
             const std::string               &group,
             const std::vector<unsigned int> &corners)
    {
      const std::map<unsigned int, unsigned int> types = {{1, 15},
                                                          {2, 1},
                                                          {4, 3},
                                                          {8, 5},
                                                          {20, 17}};
      add(dimension, group, corners, types.at(corners.size()));
    }

    void add(const unsigned int               dimension,
             const std::string               &group,
             const std::vector<unsigned int> &corners,
             const unsigned int               type)
    {
      const auto tag =
        groups.emplace(std::make_pair(dimension, group), groups.size() + 1)
          .first->second;
      std::string text =
        std::to_string(type) + " 2 " + std::to_string(tag) + " 1";
      for (const unsigned int corner : corners)
        text += ' ' + std::to_string(corner);
      elements.push_back(text);
    }

    void write(const std::string &file) const
    {
      std::ofstream out(file);
      out.precision(17);
      out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
          << groups.size() << '\n';
      for (const auto &[group, tag] : groups)
        out << group.first << ' ' << tag << " \"" << group.second << "\"\n";
      out << "$EndPhysicalNames\n$Nodes\n" << nodes.size() << '\n';
      for (unsigned int i = 0; i < nodes.size(); ++i)
        out << i + 1 << ' ' << nodes[i] << '\n';
      out << "$EndNodes\n$Elements\n" << elements.size() << '\n';
      for (unsigned int i = 0; i < elements.size(); ++i)
        out << i + 1 << ' ' << elements[i] << '\n';
      out << "$EndElements\n";
    }

  private:
    std::vector<Point<3>>                                        nodes;
    std::map<std::pair<unsigned int, std::string>, unsigned int> groups;
    std::vector<std::string>                                     elements;
  };
} // namespace Contact

#endif
