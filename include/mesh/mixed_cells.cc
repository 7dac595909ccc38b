/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/mixed_cells.h"

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/dimension.h"
#include "base/errors.h"
#include "mesh/coarse_cells.h"

namespace Contact
{
  namespace
  {
    using Nodes = std::vector<long>;

    constexpr unsigned int n_of_tetrahedron = 4, n_of_hexahedron = 8;



    /// Nodes that cells join, each with another of the same set or, the last,
    /// with itself.
    class JoinedNodes
    {
    public:
      explicit JoinedNodes(const std::vector<MshFile::Element> &cells)
      {
        for (const auto &cell : cells)
          for (const long node : cell.nodes)
            next[last_of(node)] = last_of(cell.nodes[0]);
      }

      long last_of(long node)
      {
        next.emplace(node, node);
        while (next[node] != node)
          node = next[node] = next[next[node]];
        return node;
      }

    private:
      std::map<long, long> next;
    };



    Nodes ascending(Nodes nodes)
    {
      std::sort(nodes.begin(), nodes.end());
      return nodes;
    }



    /// The triangles of a face, of a quadrangle those on either side of the
    /// diagonal from its corner of the smallest number.
    std::vector<Nodes> triangles_of(Nodes face)
    {
      if (face.size() == 3)
        return {face};
      std::rotate(face.begin(),
                  std::min_element(face.begin(), face.end()),
                  face.end());
      return {{face[0], face[1], face[2]}, {face[0], face[2], face[3]}};
    }



    /// The nodes of the faces of a cell.
    std::vector<Nodes> nodes_of_faces(const MshFile::Element &cell)
    {
      std::vector<Nodes> faces;
      for (const auto &corners : faces_of_volume(cell.nodes.size()))
        {
          faces.emplace_back();
          for (const unsigned int corner : corners)
            faces.back().push_back(cell.nodes[corner]);
        }
      return faces;
    }



    /// Splits the cells and surfaces of a file.
    class CellSplitter
    {
    public:
      explicit CellSplitter(MshFile &msh);

      void split_cells();
      void split_surfaces();

    private:
      using Element = MshFile::Element;

      bool is_mixed(const Element &element)
      {
        return mixed.count(joined.last_of(element.nodes[0])) > 0;
      }

      void check_diagonal(const Element &cell, const Nodes &face) const;
      void add_middles(const Element &cell, const std::vector<Nodes> &faces);
      void add_middle(const Nodes              &diagonal,
                      const Nodes              &corners,
                      const std::vector<Nodes> &faces);
      std::vector<Element> tetrahedra_of(const Element            &cell,
                                         const std::vector<Nodes> &faces) const;

      MshFile        &msh;
      JoinedNodes     joined;
      std::set<long>  mixed;     // the last nodes of what is to be split
      std::set<Nodes> triangles; // that its cells have as faces
    };



    CellSplitter::CellSplitter(MshFile &msh)
      : msh(msh)
      , joined(msh.elements[3])
    {
      std::map<long, std::size_t> n_corners;
      for (const auto &cell : msh.elements[3])
        {
          const long        last = joined.last_of(cell.nodes[0]);
          const std::size_t n    = cell.nodes.size();
          if ((n != n_of_tetrahedron && n != n_of_hexahedron) ||
              n_corners.emplace(last, n).first->second != n)
            mixed.insert(last);
        }
      for (const auto &cell : msh.elements[3])
        if (is_mixed(cell))
          for (const Nodes &face : nodes_of_faces(cell))
            if (face.size() == 3)
              triangles.insert(ascending(face));
    }



    /// The neighbor of a quadrangle is not two triangles with its other
    /// diagonal.
    void CellSplitter::check_diagonal(const Element &cell,
                                      const Nodes   &face) const
    {
      const auto halves = triangles_of(face);
      const long a = halves[0][1], b = halves[1][2];
      for (const long other : {halves[0][0], halves[0][2]})
        if (triangles.count(ascending({a, b, other})) > 0)
          throw InputError(
            "a quadrangle of a cell meets two triangles of others at " +
              to_string(msh.nodes.at(a)) + " and " +
              to_string(msh.nodes.at(b)) + ", which do not fit into it",
            msh.where(cell),
            "put pyramids between, or mesh what has hexahedra and what has "
            "tetrahedra as two bodies without common nodes, and tie them: a "
            "section 'Contact' with 'Tied = true'");
    }



    /// Those of the edges that the cell will be split along.
    void CellSplitter::add_middles(const Element            &cell,
                                   const std::vector<Nodes> &faces)
    {
      for (const Nodes &face : faces)
        if (face.size() == 4)
          {
            const auto half = triangles_of(face)[0];
            add_middle(ascending({half[0], half[2]}), face, {face});
          }
      if (cell.nodes.size() != n_of_hexahedron)
        return;
      // Only one corner has no face with the first, none if one is repeated.
      const long first =
        *std::min_element(cell.nodes.begin(), cell.nodes.end());
      std::set<long> others(cell.nodes.begin(), cell.nodes.end());
      for (const Nodes &face : faces)
        if (std::count(face.begin(), face.end(), first) > 0)
          for (const long node : face)
            others.erase(node);
      for (const long last : others)
        add_middle({first, last}, cell.nodes, faces);
    }



    // Serendipity functions: in the middle corners have -1/4, edges the rest.
    void CellSplitter::add_middle(const Nodes              &diagonal,
                                  const Nodes              &corners,
                                  const std::vector<Nodes> &faces)
    {
      if (msh.mid_sides.count(diagonal) > 0)
        return;
      if (const auto node = msh.mid_sides.find(ascending(corners));
          node != msh.mid_sides.end())
        {
          msh.mid_sides[diagonal] = node->second;
          return;
        }
      std::set<Nodes> edges;
      for (const Nodes &face : faces)
        for (unsigned int i = 0; i < face.size(); ++i)
          edges.insert(ascending({face[i], face[(i + 1) % face.size()]}));
      Point<3> middle;
      for (const long corner : corners)
        middle -= msh.nodes.at(corner) / 4;
      for (const Nodes &edge : edges)
        {
          const auto node = msh.mid_sides.find(edge);
          if (node == msh.mid_sides.end())
            return;
          middle += (1 + corners.size() / 4.) / edges.size() *
                    msh.nodes.at(node->second);
        }
      const long number       = msh.nodes.rbegin()->first + 1;
      msh.nodes[number]       = middle;
      msh.mid_sides[diagonal] = number;
    }



    std::vector<MshFile::Element>
    CellSplitter::tetrahedra_of(const Element            &cell,
                                const std::vector<Nodes> &faces) const
    {
      const long first =
        *std::min_element(cell.nodes.begin(), cell.nodes.end());
      const auto edge = [&](const long node) {
        return msh.nodes.at(node) - msh.nodes.at(first);
      };
      std::vector<Element> tetrahedra;
      std::set<bool>       orientations;
      for (const Nodes &face : faces)
        if (std::count(face.begin(), face.end(), first) == 0)
          for (const Nodes &t : triangles_of(face))
            {
              orientations.insert(
                cross_product_3d(edge(t[0]), edge(t[1])) * edge(t[2]) > 0);
              tetrahedra.push_back(
                {cell.number, {first, t[0], t[1], t[2]}, cell.groups});
            }
      if (orientations.size() > 1)
        throw InputError("element " + std::to_string(cell.number) +
                           " is tangled: it falls into tetrahedra of either "
                           "orientation",
                         msh.where(cell),
                         Dimension<3>::shapes_of_cells);
      return tetrahedra;
    }



    void CellSplitter::split_cells()
    {
      std::vector<Element> cells;
      for (const Element &cell : msh.elements[3])
        if (is_mixed(cell))
          {
            const auto faces = nodes_of_faces(cell);
            for (const Nodes &face : faces)
              if (face.size() == 4)
                check_diagonal(cell, face);
            add_middles(cell, faces);
            const auto parts = tetrahedra_of(cell, faces);
            cells.insert(cells.end(), parts.begin(), parts.end());
            if (parts.size() > 1)
              for (const std::string &body : cell.groups)
                ++msh.n_split[body];
          }
        else
          cells.push_back(cell);
      msh.elements[3] = cells;
    }



    void CellSplitter::split_surfaces()
    {
      std::vector<Element> surfaces;
      for (const Element &surface : msh.elements[2])
        if (is_mixed(surface))
          for (const Nodes &triangle : triangles_of(surface.nodes))
            surfaces.push_back({surface.number, triangle, surface.groups});
        else
          surfaces.push_back(surface);
      msh.elements[2] = surfaces;
    }
  } // namespace



  const std::vector<std::vector<unsigned int>> &
  faces_of_volume(const unsigned int n_corners)
  {
    static const std::map<unsigned int, std::vector<std::vector<unsigned int>>>
      faces = {
        {4, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}},
        {5, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}},
        {6, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}},
        {8,
         {{0, 3, 2, 1},
          {4, 5, 6, 7},
          {0, 1, 5, 4},
          {1, 2, 6, 5},
          {2, 3, 7, 6},
          {3, 0, 4, 7}}}};
    return faces.at(n_corners);
  }



  void split_mixed_cells(MshFile &msh)
  {
    std::set<std::size_t> n_corners;
    for (const auto &cell : msh.elements[3])
      n_corners.insert(cell.nodes.size());
    if (n_corners.size() + n_corners.count(5) + n_corners.count(6) < 2)
      return;
    CellSplitter splitter(msh);
    splitter.split_surfaces();
    splitter.split_cells();
  }
} // namespace Contact
