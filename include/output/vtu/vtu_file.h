/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_vtu_file_h
#define contact_vtu_file_h

#include <deal.II/base/point.h>

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /// Values at points or of cells, all components of the first one first: of a
  /// vector 3, of a tensor 9, row by row.
  struct VtuField
  {
    std::string        name;
    std::string        unit; // or nothing
    unsigned int       n_components;
    std::vector<float> values;
  };



  /**
   * Cells of degree 1 or 2 with fields, as VTK has them. deal.II's DataOut
   * writes a point for each node of each cell, and all fields by points; here
   * cells share their points, and what is of cells is so.
   */
  struct VtuGrid
  {
    std::vector<float>        points; // three coordinates each
    std::vector<std::int32_t> nodes;  // of one cell after the other
    std::vector<std::int32_t> ends;   // of each cell among them
    std::vector<std::uint8_t> types;  // VTK's numbers of shapes
    std::vector<VtuField>     at_points, of_cells;

    std::size_t n_points() const
    {
      return points.size() / 3;
    }

    /// Add a point, whose further coordinates are zero.
    template<int dim>
    void add_point(const Point<dim> &X)
    {
      for (unsigned int d = 0; d < 3; ++d)
        points.push_back(d < dim ? X[d] : 0.);
    }

    /// Add a cell by the numbers of its points, the nodes of a reference cell
    /// with the coordinates @p units. The order is theirs, whatever it is.
    template<int dim>
    void add_cell(const std::vector<std::int32_t> &numbers,
                  const std::vector<Point<dim>>   &units);
  };

  /// Write it with its time, the load factor.
  void
  write_vtu(const VtuGrid &grid, const double load_factor, std::ostream &out);

  /// Write a record of several files with the fields of @p grid.
  void write_pvtu(const VtuGrid                  &grid,
                  const std::vector<std::string> &files,
                  std::ostream                   &out);



  /// A file of a series: which part it is at its time, and the name of this.
  struct VtuPart
  {
    double       load_factor;
    unsigned int number;
    std::string  name;
    std::string  file;

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &load_factor &number &name &file;
    }
  };

  /// Write the record of a series, whose parts ParaView shows by their names.
  void write_pvd(const std::vector<VtuPart> &series, std::ostream &out);
} // namespace Contact

#endif
