/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The reader of gmsh files, on small meshes written by this test itself: both
// formats, elements of second order, the order of cells.

#include <iostream>
#include <sstream>

#include "mesh_facts.h"
#include "mesh_files.h"

using namespace Contact;

/// All that a mesh knows, in a few lines.
std::string describe(const Mesh<2> &mesh)
{
  std::ostringstream      out;
  const Triangulation<2> &triangulation = mesh.triangulation;

  out << triangulation.n_used_vertices() << " vertices, "
      << triangulation.n_active_cells() << " cells, "
      << triangulation.n_active_lines() << " lines" << std::endl;
  for (const auto &[name, id] : mesh.bodies)
    out << "body " << name << ": area " << area(triangulation, id).total
        << std::endl;
  for (const auto &[name, ids] : mesh.boundaries)
    {
      double length = 0;
      for (const auto &face : triangulation.active_face_iterators())
        if (ids.count(face->boundary_id()) > 0)
          length += face->measure();
      out << "boundary " << name << ": " << ids.size() << " ids, length "
          << length << std::endl;
    }
  for (const auto &[name, vertices] : mesh.points)
    if (vertices.size() > 1)
      out << "points " << name << std::endl;
    else
      out << "point " << name << ": vertex " << vertices[0] << " at "
          << triangulation.get_vertices()[vertices[0]] << std::endl;
  out << "determinants "
      << (area(triangulation).least_fraction > 0 ? "positive" : "NOT positive")
      << std::endl;
  return out.str();
}



// Names, groups and points come out of both formats alike: clockwise cells are
// turned round, vertices at the same place are two, lines inside bodies are
// ignored, a line of two groups belongs to both.
void test_formats()
{
  std::cout << "Format 2.2" << std::endl;
  const std::string from_22 = describe(Mesh<2>(parameters_for(msh_22)));
  std::cout << from_22;

  std::cout << "Format 4.1" << std::endl;
  const std::string from_41 = describe(Mesh<2>(parameters_for(msh_41)));
  std::cout << (from_41 == from_22 ? "the same\n" : from_41);

  std::cout << "Line ends of Windows" << std::endl;
  std::string windows;
  for (const char c : msh_22)
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const std::string from_windows = describe(Mesh<2>(parameters_for(windows)));
  std::cout << (from_windows == from_22 ? "the same\n" : from_windows);

  std::cout << "Refined twice" << std::endl
            << describe(Mesh<2>(parameters_for(msh_22, 2)));
}



// Of elements of second order the corners are read: a quadrangle with 8 nodes,
// one with 9 and a triangle with 6; mid-sides are no vertices.
void test_second_order()
{
  std::cout << "Second order" << std::endl;
  std::ostringstream msh;
  msh << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
      << "$PhysicalNames\n2\n1 1 \"Bottom\"\n2 2 \"Body\"\n$EndPhysicalNames\n"
      << "$Nodes\n21\n";
  for (unsigned int i = 0; i < 21; ++i)
    msh << i + 1 << ' ' << 0.5 * (i % 7) << ' ' << 0.5 * (i / 7) << " 0\n";
  msh << "$EndNodes\n$Elements\n6\n"
      << "1 8 2 1 1 1 3 2\n2 8 2 1 1 3 5 4\n3 8 2 1 1 5 7 6\n"
      << "4 16 2 2 1 1 3 17 15 2 10 16 8\n"
      << "5 10 2 2 1 3 5 19 17 4 12 18 10 11\n"
      << "6 9 2 2 1 5 7 19 6 13 12\n$EndElements\n";
  std::cout << describe(Mesh<2>(parameters_for(msh.str())));
}



// Quadrangles whose first corners are at random places, beside triangles: only
// if the edges agree on their directions does refinement keep cells in order.
void test_order()
{
  std::cout << "Quadrangles in any order" << std::endl;
  const unsigned int n = 5;
  std::ostringstream msh, cells;
  msh << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
      << "$PhysicalNames\n1\n2 1 \"Body\"\n$EndPhysicalNames\n"
      << "$Nodes\n"
      << (n + 1) * (n + 1) << '\n';
  for (unsigned int i = 0; i < (n + 1) * (n + 1); ++i)
    msh << i + 1 << ' ' << i % (n + 1) << ' ' << i / (n + 1) << " 0\n";
  unsigned int n_cells = 0;
  for (unsigned int y = 0; y < n; ++y)
    for (unsigned int x = 0; x < n; ++x)
      {
        const unsigned int first = y * (n + 1) + x + 1;

        std::array<unsigned int, 4> c = {
          {first, first + 1, first + n + 2, first + n + 1}};
        std::rotate(c.begin(),
                    c.begin() + (7 * x + 3 * y + x * y) % 4,
                    c.end());
        if ((x + 2 * y) % 5 != 0)
          cells << ++n_cells << " 3 2 1 1 " << c[0] << ' ' << c[1] << ' '
                << c[2] << ' ' << c[3] << '\n';
        else
          {
            cells << ++n_cells << " 2 2 1 1 " << c[0] << ' ' << c[1] << ' '
                  << c[2] << '\n';
            cells << ++n_cells << " 2 2 1 1 " << c[2] << ' ' << c[0] << ' '
                  << c[3] << '\n';
          }
      }
  msh << "$EndNodes\n$Elements\n"
      << n_cells << '\n'
      << cells.str() << "$EndElements\n";
  std::cout << describe(Mesh<2>(parameters_for(msh.str(), 2)));
}



int main()
{
  test_formats();
  test_second_order();
  test_order();
  return 0;
}
