/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The quantities that the tests measure on a mesh, with the mappings of degree
// 2 that the program uses on quadrangles and triangles.

#ifndef contact_tests_mesh_facts_h
#define contact_tests_mesh_facts_h

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "mesh/mesh.h"
#include "mpi_session.h"

using namespace dealii;

using CellIterator = Triangulation<2>::active_cell_iterator;

inline bool is_triangle(const CellIterator &cell)
{
  return cell->reference_cell() == ReferenceCells::Triangle;
}



/// The mid-side point of a line of a cell, by the mapping of degree 2.
inline Point<2> mid_side(const CellIterator &cell, const unsigned int line)
{
  static const MappingQ<2>  quadrangle_mapping(2);
  static const MappingFE<2> triangle_mapping(FE_SimplexP<2>(2));

  // On the reference cells, in deal.II's order of lines.
  static const std::vector<Point<2>> on_quadrangle = {Point<2>(0, .5),
                                                      Point<2>(1, .5),
                                                      Point<2>(.5, 0),
                                                      Point<2>(.5, 1)};
  static const std::vector<Point<2>> on_triangle   = {Point<2>(.5, 0),
                                                      Point<2>(.5, .5),
                                                      Point<2>(0, .5)};

  if (is_triangle(cell))
    return triangle_mapping.transform_unit_to_real_cell(cell,
                                                        on_triangle[line]);
  return quadrangle_mapping.transform_unit_to_real_cell(cell,
                                                        on_quadrangle[line]);
}



/// The area of a body, or of all; and the smallest Jacobian determinant at a
/// quadrature point, as a fraction of the mean one of its cell.
struct Area
{
  double total          = 0;
  double least_fraction = std::numeric_limits<double>::max();
};

inline Area area(const Triangulation<2>  &triangulation,
                 const types::material_id body = numbers::invalid_material_id)
{
  const MappingQ<2>    quadrangle_mapping(2);
  const MappingFE<2>   triangle_mapping(FE_SimplexP<2>(2));
  const FE_Q<2>        quadrangle_element(2);
  const FE_SimplexP<2> triangle_element(2);
  const UpdateFlags    flags = update_jacobians | update_JxW_values;

  FEValues<2> on_quadrangle(quadrangle_mapping,
                            quadrangle_element,
                            QGauss<2>(3),
                            flags);
  FEValues<2> on_triangle(triangle_mapping,
                          triangle_element,
                          QGaussSimplex<2>(3),
                          flags);

  Area result;
  for (const auto &cell : triangulation.active_cell_iterators())
    if (body == numbers::invalid_material_id || cell->material_id() == body)
      {
        FEValues<2> &values = is_triangle(cell) ? on_triangle : on_quadrangle;
        values.reinit(cell);

        double size = 0;
        for (const unsigned int q : values.quadrature_point_indices())
          size += values.JxW(q);
        const double mean = size / (is_triangle(cell) ? 0.5 : 1.);
        for (const unsigned int q : values.quadrature_point_indices())
          result.least_fraction =
            std::min(result.least_fraction,
                     values.jacobian(q).determinant() / mean);
        result.total += size;
      }
  return result;
}



/// Of the lines in degree 2: how far mid-sides and ends on the boundary @p ids
/// are from a circle, and mid-sides elsewhere from their chords.
struct Roundness
{
  unsigned int n_lines = 0, n_of_triangles = 0;
  double       off_circle = 0, bent = 0;
};

inline Roundness roundness(const Triangulation<2>             &triangulation,
                           const std::set<types::boundary_id> &ids,
                           const Point<2>                     &center,
                           const double                        radius)
{
  const auto off_circle = [&](const Point<2> &p) {
    return std::abs(p.distance(center) - radius);
  };

  Roundness result;
  for (const auto &cell : triangulation.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      {
        const auto     face = cell->face(f);
        const Point<2> a = face->vertex(0), b = face->vertex(1);
        const Point<2> middle = mid_side(cell, f);
        if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
          {
            ++result.n_lines;
            result.n_of_triangles += is_triangle(cell);
            for (const Point<2> &p : {a, b, middle})
              result.off_circle = std::max(result.off_circle, off_circle(p));
          }
        else
          result.bent = std::max(result.bent, middle.distance(0.5 * (a + b)));
      }
  return result;
}

#endif
