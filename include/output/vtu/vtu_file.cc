/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/vtu/vtu_file.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <ostream>
#include <utility>
#include <zlib.h>

namespace Contact
{
  namespace
  {
    /// A shape of VTK: its number, and its nodes in their order.
    struct VtkShape
    {
      std::uint8_t          type;
      std::vector<Point<3>> nodes;
    };



    /// The middles of pairs, and of groups, of the first nodes.
    void add_middles(const std::vector<std::vector<unsigned int>> &groups,
                     std::vector<Point<3>>                        &nodes)
    {
      for (const auto &group : groups)
        {
          Point<3> middle;
          for (const unsigned int node : group)
            middle += nodes[node] / static_cast<double>(group.size());
          nodes.push_back(middle);
        }
    }



    const std::vector<Point<3>> square{{0, 0, 0},
                                       {1, 0, 0},
                                       {1, 1, 0},
                                       {0, 1, 0}};

    std::vector<Point<3>> triangle(const bool is_quadratic)
    {
      std::vector<Point<3>> nodes{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
      if (is_quadratic)
        add_middles({{0, 1}, {1, 2}, {2, 0}}, nodes);
      return nodes;
    }

    std::vector<Point<3>> quadrangle(const bool is_quadratic)
    {
      std::vector<Point<3>> nodes = square;
      if (is_quadratic)
        add_middles({{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 1, 2, 3}}, nodes);
      return nodes;
    }

    std::vector<Point<3>> tetrahedron(const bool is_quadratic)
    {
      std::vector<Point<3>> nodes{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
      if (is_quadratic)
        add_middles({{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}, nodes);
      return nodes;
    }

    std::vector<Point<3>> hexahedron(const bool is_quadratic)
    {
      std::vector<Point<3>> nodes = square;
      for (const Point<3> &corner : square)
        nodes.push_back(corner + Point<3>::unit_vector(2));
      if (is_quadratic)
        add_middles({{0, 1},
                     {1, 2},
                     {2, 3},
                     {3, 0},
                     {4, 5},
                     {5, 6},
                     {6, 7},
                     {7, 4},
                     {0, 4},
                     {1, 5},
                     {2, 6},
                     {3, 7},
                     {0, 3, 4, 7},
                     {1, 2, 5, 6},
                     {0, 1, 4, 5},
                     {2, 3, 6, 7},
                     {0, 1, 2, 3},
                     {4, 5, 6, 7},
                     {0, 1, 2, 3, 4, 5, 6, 7}},
                    nodes);
      return nodes;
    }



    /// The shapes by dimension and number of nodes.
    const VtkShape &vtk_shape(const unsigned int dim,
                              const unsigned int n_nodes)
    {
      static const std::map<std::pair<unsigned int, unsigned int>, VtkShape>
        shapes{{{1, 2}, {3, {{0, 0, 0}, {1, 0, 0}}}},
               {{2, 3}, {5, triangle(false)}},
               {{2, 6}, {22, triangle(true)}},
               {{2, 4}, {9, quadrangle(false)}},
               {{2, 9}, {28, quadrangle(true)}},
               {{3, 4}, {10, tetrahedron(false)}},
               {{3, 10}, {24, tetrahedron(true)}},
               {{3, 8}, {12, hexahedron(false)}},
               {{3, 27}, {29, hexahedron(true)}}};
      return shapes.at({dim, n_nodes});
    }



    /// Numbers as VTK reads them: the sizes of one block, and this compressed.
    template<typename Number>
    std::string encoded(const std::vector<Number> &numbers)
    {
      uLong                      n_bytes = numbers.size() * sizeof(Number);
      uLongf                     size    = compressBound(n_bytes);
      std::vector<unsigned char> block(size);
      compress2(block.data(),
                &size,
                reinterpret_cast<const Bytef *>(numbers.data()),
                n_bytes,
                Z_BEST_SPEED);
      block.resize(size);

      const std::vector<std::uint32_t> sizes{
        1,
        static_cast<std::uint32_t>(n_bytes),
        static_cast<std::uint32_t>(n_bytes),
        static_cast<std::uint32_t>(size)};
      const auto *const first =
        reinterpret_cast<const unsigned char *>(sizes.data());
      return Utilities::encode_base64({first, first + 4 * sizes.size()}) +
             Utilities::encode_base64(block);
    }



    std::string in_xml(const std::string &text)
    {
      std::string                       result;
      const std::map<char, std::string> escapes{{'&', "&amp;"},
                                                {'<', "&lt;"},
                                                {'>', "&gt;"},
                                                {'"', "&quot;"}};
      for (const char c : text)
        if (const auto escape = escapes.find(c); escape != escapes.end())
          result += escape->second;
        else
          result += c;
      return result;
    }



    void begin_file(const std::string &type, std::ostream &out)
    {
      out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type
          << "\" version=\"0.1\" compressor=\"vtkZLibDataCompressor\" "
             "byte_order=\""
#ifdef DEAL_II_WORDS_BIGENDIAN
          << "BigEndian"
#else
          << "LittleEndian"
#endif
          << "\">\n";
    }



    std::string attributes(const VtuField &field)
    {
      return "type=\"Float32\" Name=\"" + in_xml(field.name) +
             "\" NumberOfComponents=\"" + std::to_string(field.n_components) +
             "\"" +
             (field.unit.empty() ? ""
                                 : " units=\"" + in_xml(field.unit) + "\"");
    }



    template<typename Number>
    void write_array(const std::string         &attributes,
                     const std::vector<Number> &numbers,
                     std::ostream              &out)
    {
      out << "<DataArray " << attributes << " format=\"binary\">\n"
          << encoded(numbers) << "\n</DataArray>\n";
    }



    void write_fields(const std::string           &section,
                      const std::vector<VtuField> &fields,
                      std::ostream                &out)
    {
      out << '<' << section << ">\n";
      for (const VtuField &field : fields)
        write_array(attributes(field), field.values, out);
      out << "</" << section << ">\n";
    }
  } // namespace



  template<int dim>
  void VtuGrid::add_cell(const std::vector<std::int32_t> &numbers,
                         const std::vector<Point<dim>>   &units)
  {
    const VtkShape &shape = vtk_shape(dim, numbers.size());
    const double    near  = 1e-6; // of the unit cell
    for (const Point<3> &node : shape.nodes)
      {
        const auto unit =
          std::find_if(units.begin(), units.end(), [&](const Point<dim> &p) {
            double off = 0;
            for (unsigned int d = 0; d < dim; ++d)
              off += std::abs(p[d] - node[d]);
            return off < near;
          });
        Assert(unit != units.end(), ExcInternalError());
        nodes.push_back(numbers[unit - units.begin()]);
      }
    ends.push_back(nodes.size());
    types.push_back(shape.type);
  }



  void
  write_vtu(const VtuGrid &grid, const double load_factor, std::ostream &out)
  {
    begin_file("UnstructuredGrid", out);
    out << "<UnstructuredGrid>\n<FieldData>\n<DataArray type=\"Float32\" "
           "Name=\"TIME\" NumberOfTuples=\"1\" format=\"ascii\">"
        << std::setprecision(std::numeric_limits<double>::max_digits10)
        << load_factor << "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\""
        << grid.n_points() << "\" NumberOfCells=\"" << grid.types.size()
        << "\">\n<Points>\n";
    write_array("type=\"Float32\" NumberOfComponents=\"3\"", grid.points, out);
    out << "</Points>\n<Cells>\n";
    write_array("type=\"Int32\" Name=\"connectivity\"", grid.nodes, out);
    write_array("type=\"Int32\" Name=\"offsets\"", grid.ends, out);
    write_array("type=\"UInt8\" Name=\"types\"", grid.types, out);
    out << "</Cells>\n";
    write_fields("PointData", grid.at_points, out);
    write_fields("CellData", grid.of_cells, out);
    out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  }



  void write_pvtu(const VtuGrid                  &grid,
                  const std::vector<std::string> &files,
                  std::ostream                   &out)
  {
    begin_file("PUnstructuredGrid", out);
    out << "<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints>\n<PDataArray "
           "type=\"Float32\" NumberOfComponents=\"3\"/>\n</PPoints>\n";
    const auto declare = [&](const std::string           &section,
                             const std::vector<VtuField> &fields) {
      out << '<' << section << ">\n";
      for (const VtuField &field : fields)
        out << "<PDataArray " << attributes(field) << "/>\n";
      out << "</" << section << ">\n";
    };
    declare("PPointData", grid.at_points);
    declare("PCellData", grid.of_cells);
    for (const std::string &file : files)
      out << "<Piece Source=\"" << in_xml(file) << "\"/>\n";
    out << "</PUnstructuredGrid>\n</VTKFile>\n";
  }



  void write_pvd(const std::vector<VtuPart> &series, std::ostream &out)
  {
    begin_file("Collection", out);
    out << "<Collection>\n"
        << std::setprecision(std::numeric_limits<double>::max_digits10);
    for (const VtuPart &part : series)
      out << "<DataSet timestep=\"" << part.load_factor << "\" part=\""
          << part.number << "\" name=\"" << in_xml(part.name) << "\" file=\""
          << in_xml(part.file) << "\"/>\n";
    out << "</Collection>\n</VTKFile>\n";
  }

  template void VtuGrid::add_cell<1>(const std::vector<std::int32_t> &,
                                     const std::vector<Point<1>> &);
  template void VtuGrid::add_cell<2>(const std::vector<std::int32_t> &,
                                     const std::vector<Point<2>> &);
  template void VtuGrid::add_cell<3>(const std::vector<std::int32_t> &,
                                     const std::vector<Point<3>> &);
} // namespace Contact
