/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/coarse_cells.h"

#include <deal.II/base/patterns.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/dimension.h"
#include "base/errors.h"

namespace Contact
{
  namespace
  {
    using Corners = decltype(CellData<2>::vertices);

    /// The volumes (areas) that the edges of a cell span at its corners, by the
    /// power dim of the longest of these edges; a cell whose Jacobian
    /// determinant changes sign in a corner has some of either sign.
    template<int dim>
    std::vector<double> corner_volumes(const std::vector<Point<dim>> &points,
                                       const Corners                 &corners);

    template<>
    std::vector<double> corner_volumes<2>(const std::vector<Point<2>> &points,
                                          const Corners               &corners)
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
      for (double &area : areas)
        area /= scale;
      return areas;
    }

    /// The same of a tetrahedron, whose corners are alike.
    double volume_of_tetrahedron(const std::vector<Point<3>> &points,
                                 const Corners               &corners)
    {
      std::array<Tensor<1, 3>, 3> edges;
      double                      scale = 0;
      for (unsigned int i = 0; i < 3; ++i)
        {
          edges[i] = points[corners[i + 1]] - points[corners[0]];
          scale    = std::max(scale, edges[i].norm_square());
        }
      return cross_product_3d(edges[0], edges[1]) * edges[2] /
             std::pow(scale, 1.5);
    }

    template<>
    std::vector<double> corner_volumes<3>(const std::vector<Point<3>> &points,
                                          const Corners               &corners)
    {
      std::vector<double> volumes;
      double              scale = 0;
      if (corners.size() == 4)
        return {volume_of_tetrahedron(points, corners)};
      for (unsigned int i = 0; i < 8; ++i)
        {
          const unsigned int layer  = i / 4 * 4;
          const Point<3>    &corner = points[corners[i]];
          const auto         to     = [&](const unsigned int j) {
            return points[corners[j]] - corner;
          };
          const Tensor<1, 3> next = to(layer + (i + 1) % 4);
          const Tensor<1, 3> last = to(layer + (i + 3) % 4);
          const Tensor<1, 3> up   = to((i + 4) % 8);
          volumes.push_back((layer == 0 ? 1 : -1) *
                            (cross_product_3d(next, last) * up));
          scale = std::max({scale, next.norm_square(), up.norm_square()});
        }
      for (double &volume : volumes)
        volume /= std::pow(scale, 1.5);
      return volumes;
    }



    /// Turn a cell of the other orientation round: its corners in the opposite
    /// sense, two of a tetrahedron exchanged, or the top of a hexahedron for
    /// its bottom.
    template<int dim>
    void turn_round(Corners &corners)
    {
      if (dim == 2)
        std::reverse(corners.begin(), corners.end());
      else if (corners.size() == 4)
        std::swap(corners[0], corners[1]);
      else
        std::rotate(corners.begin(), corners.begin() + 4, corners.end());
    }



    /// Turn a cell round if it is left-handed (clockwise). A tangled one, whose
    /// Jacobian determinant changes sign inside, is refused.
    template<int dim>
    void make_right_handed(const std::vector<Point<dim>> &points,
                           const MshFile::Element        &element,
                           const MshFile                 &msh,
                           Corners                       &corners)
    {
      const auto volumes = corner_volumes<dim>(points, corners);
      const auto [low, high] =
        std::minmax_element(volumes.begin(), volumes.end());
      if (*high < -1e-12)
        turn_round<dim>(corners);
      else if (*low < 1e-12)
        {
          std::string places;
          for (const unsigned int corner : corners)
            places += " " + to_string(points[corner]);
          throw InputError("element " + std::to_string(element.number) +
                             " is tangled or flat, its corners are" + places,
                           msh.where(element),
                           Dimension<dim>::shapes_of_cells);
        }
    }
  } // namespace



  template<int dim>
  std::vector<CellData<dim>>
  make_cells(const MshFile                                   &msh,
             const VertexNumbers                             &vertices,
             const std::vector<Point<dim>>                   &points,
             const std::map<std::string, types::material_id> &bodies)
  {
    std::vector<CellData<dim>> cells;
    for (const auto &element : msh.elements[dim])
      {
        const auto &groups = element.groups;
        if (groups.size() != 1)
          throw InputError(groups.empty()
                             ? std::string("a cell belongs to no physical ") +
                                 Dimension<dim>::body + " with a name"
                             : "a cell belongs to two bodies, '" +
                                 *groups.begin() + "' and '" +
                                 *groups.rbegin() + "'",
                           msh.where(element),
                           std::string("every cell needs one body: Physical ") +
                             Dimension<dim>::body_keyword +
                             "(\"...\") = {...}; in the .geo file");

        CellData<dim> cell(element.nodes.size());
        cell.material_id = bodies.at(*groups.begin());
        std::transform(element.nodes.begin(),
                       element.nodes.end(),
                       cell.vertices.begin(),
                       [&](const long node) { return vertices.at(node); });
        make_right_handed(points, element, msh, cell.vertices);
        cells.push_back(cell);
      }
    return cells;
  }



  template<int dim>
  std::string to_string(const Point<dim> &p)
  {
    return "(" + Patterns::Tools::to_string(p) + ")";
  }

  template std::vector<CellData<2>>
  make_cells(const MshFile &,
             const VertexNumbers &,
             const std::vector<Point<2>> &,
             const std::map<std::string, types::material_id> &);
  template std::vector<CellData<3>>
                       make_cells(const MshFile &,
                                  const VertexNumbers &,
                                  const std::vector<Point<3>> &,
                                  const std::map<std::string, types::material_id> &);
  template std::string to_string(const Point<2> &);
  template std::string to_string(const Point<3> &);
} // namespace Contact
