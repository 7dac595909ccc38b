/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The reader of gmsh files, on small meshes written by this test itself.

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_tools.h>

#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>

#include "errors.h"
#include "mesh_facts.h"

using namespace Contact;

// Two bodies, drawn with the numbers of the nodes. Nodes 4 and 7 lie at the
// same place. The quadrangle of the upper body is clockwise, and so is the
// triangle 2 6 3; node 11, somewhere else, belongs to no cell.
//
//    9---10
//    |    |
//    7----8
//
//    4----5----6
//    |    |  / |
//    |    |/   |
//    1----2----3
//
// The line 1-2 is in the groups Bottom and Foot, 2-5 is inside the lower body
// and in the groups Foot and Inside, 3-6 is in no group.
const std::string msh_22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Comments
a section nobody needs
$EndComments
$PhysicalNames
10
0 1 "P"
0 2 "Q"
0 3 "Pair"
0 4 "Centre"
1 5 "Bottom"
1 6 "Foot"
1 7 "Inside"
1 8 "The top"
2 9 "Lower"
2 10 "Upper"
$EndPhysicalNames
$Nodes
11
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
7 0 1 0
8 1 1.5 0
9 0 2 0
10 1 2 0
11 5 5 0
$EndNodes
$Elements
17
1 15 2 1 1 4
2 15 2 2 2 7
3 15 2 3 3 1
4 15 2 3 4 3
5 15 2 4 5 11
6 1 2 5 1 1 2
7 1 2 6 1 1 2
8 1 2 5 1 2 3
9 1 2 6 2 2 5
10 1 2 7 2 2 5
11 1 2 8 3 5 4
12 1 2 8 3 5 6
13 1 2 0 4 3 6
14 3 2 9 1 1 2 5 4
15 2 2 9 1 2 6 3
16 2 2 9 1 2 6 5
17 3 2 10 2 7 9 10 8
$EndElements
)";

// The same in format 4.1: groups belong to entities, which have several.
const std::string msh_41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
10
0 1 "P"
0 2 "Q"
0 3 "Pair"
0 4 "Centre"
1 5 "Bottom"
1 6 "Foot"
1 7 "Inside"
1 8 "The top"
2 9 "Lower"
2 10 "Upper"
$EndPhysicalNames
$Entities
5 5 2 0
1 0 1 0 1 1
2 0 1 0 1 2
3 0 0 0 1 3
4 2 0 0 1 3
5 5 5 0 1 4
1 0 0 0 1 0 0 2 5 6 2 1 -2
2 1 0 0 2 0 0 1 5 2 2 -3
3 1 0 0 1 1 0 2 -6 7 2 1 -2
4 0 1 0 2 1 0 1 8 2 1 -2
5 2 0 0 2 1 0 0 2 1 -2
1 0 0 0 2 1 0 1 9 4 1 2 5 4
2 0 1 0 1 2 0 1 10 0
$EndEntities
$Nodes
3 11 1 11
2 1 0 6
1
2
3
4
5
6
0 0 0
1 0 0
2 0 0
0 1 0
1 1 0
2 1 0
2 2 1 4
7
8
9
10
0 1 0 0.1 0.1
1 1.5 0 0.1 0.1
0 2 0 0.1 0.1
1 2 0 0.1 0.1
0 5 0 1
11
5 5 0
$EndNodes
$Elements
13 15 1 15
0 1 15 1
1 4
0 2 15 1
2 7
0 3 15 1
3 1
0 4 15 1
4 3
0 5 15 1
5 11
1 1 1 1
6 1 2
1 2 1 1
7 2 3
1 3 1 1
8 2 5
1 4 1 2
9 5 4
10 5 6
1 5 1 1
11 3 6
2 1 3 1
12 1 2 5 4
2 1 2 2
13 2 6 3
14 2 6 5
2 2 3 1
15 7 9 10 8
$EndElements
)";



Parameters::Mesh parameters_for(const std::string &content,
                                const unsigned int refinements = 0)
{
  std::ofstream("mesh_reader.msh") << content;

  Parameters::Mesh parameters;
  parameters.file        = "mesh_reader.msh";
  parameters.refinements = refinements;
  return parameters;
}



/// All that a mesh knows, in a few lines.
std::string describe(const Mesh &mesh)
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
  for (const auto &[name, vertex] : mesh.points)
    if (vertex == numbers::invalid_unsigned_int)
      out << "points " << name << std::endl;
    else
      out << "point " << name << ": vertex " << vertex << " at "
          << triangulation.get_vertices()[vertex] << std::endl;
  out << "determinants "
      << (area(triangulation).least_fraction > 0 ? "positive" : "NOT positive")
      << std::endl;
  return out.str();
}



void first_line(const std::function<void()> &read)
{
  try
    {
      read();
      std::cout << "NO ERROR" << std::endl;
    }
  catch (const InputError &error)
    {
      const std::string what = error.what();
      std::cout << what.substr(0, what.find('\n')) << std::endl;
    }
}



/// The text with one piece replaced, which has to be there.
std::string
replaced(std::string text, const std::string &piece, const std::string &by)
{
  const auto position = text.find(piece);
  AssertThrow(position != std::string::npos, ExcMessage("no " + piece));
  return text.replace(position, piece.size(), by);
}



// Names, groups and points come out of both formats alike: clockwise cells are
// turned round, vertices at the same place are two, lines inside bodies are
// ignored, a line of two groups belongs to both.
void test_formats()
{
  std::cout << "Format 2.2" << std::endl;
  const std::string from_22 = describe(Mesh(parameters_for(msh_22)));
  std::cout << from_22;

  std::cout << "Format 4.1" << std::endl;
  const std::string from_41 = describe(Mesh(parameters_for(msh_41)));
  std::cout << (from_41 == from_22 ? "the same\n" : from_41);

  std::cout << "Line ends of Windows" << std::endl;
  std::string windows;
  for (const char c : msh_22)
    windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  const std::string from_windows = describe(Mesh(parameters_for(windows)));
  std::cout << (from_windows == from_22 ? "the same\n" : from_windows);

  std::cout << "Refined twice" << std::endl
            << describe(Mesh(parameters_for(msh_22, 2)));
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
  std::cout << describe(Mesh(parameters_for(msh.str())));
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
          { first, first + 1, first + n + 2, first + n + 1 }
        };
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
  std::cout << describe(Mesh(parameters_for(msh.str(), 2)));
}



/**
 * Half a disc of radius 2 about (1,3), meshed with @p n sectors: triangles at
 * the centre and beyond them, in turns, a quadrangle, two triangles, and a
 * triangle that has two lines on the arc. The last sector belongs to the same
 * circle but not to the group "Arc".
 */
std::string half_disc(const unsigned int n)
{
  const double       radius = 2;
  std::ostringstream nodes, elements;
  unsigned int       n_elements = 0;
  nodes.precision(16);
  nodes << "1 1 3 0\n";
  const auto add = [&](const unsigned int ring, const unsigned int i) {
    const double r = radius * ring / 2., angle = numbers::PI * i / (2. * n);
    nodes << 2 + i + (ring - 1) * (2 * n + 1) << ' ' << 1 + r * std::cos(angle)
          << ' ' << 3 + r * std::sin(angle) << " 0\n";
  };
  const auto node = [&](const unsigned int ring, const unsigned int i) {
    return ' ' + std::to_string(2 + i + (ring - 1) * (2 * n + 1));
  };
  const auto element = [&](const std::string &text) {
    elements << ++n_elements << ' ' << text << '\n';
  };

  for (const unsigned int ring : { 1, 2 })
    for (unsigned int i = 0; i <= 2 * n; ++i)
      add(ring, i);
  for (unsigned int i = 0; i < 2 * n; ++i)
    {
      if (i / 2 + 1 < n)
        element("1 2 1 1" + node(2, i) + node(2, i + 1));
      element("2 2 2 1 1" + node(1, i) + node(1, i + 1));
    }
  for (unsigned int i = 0; i < 2 * n; i += 2)
    if (i % 6 == 0)
      for (const unsigned int j : { i, i + 1 })
        element("3 2 2 1" + node(1, j) + node(2, j) + node(2, j + 1) +
                node(1, j + 1));
    else if (i % 6 == 2)
      for (const unsigned int j : { i, i + 1 })
        {
          element("2 2 2 1" + node(1, j) + node(2, j) + node(2, j + 1));
          element("2 2 2 1" + node(1, j) + node(2, j + 1) + node(1, j + 1));
        }
    else
      {
        element("2 2 2 1" + node(2, i) + node(2, i + 1) + node(2, i + 2));
        element("3 2 2 1" + node(1, i) + node(2, i) + node(2, i + 2) +
                node(1, i + 1));
        element("2 2 2 1" + node(1, i + 1) + node(2, i + 2) + node(1, i + 2));
      }

  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n"
         "1 1 \"Arc\"\n2 2 \"Disc\"\n$EndPhysicalNames\n$Nodes\n" +
         std::to_string(1 + 2 * (2 * n + 1)) + '\n' + nodes.str() +
         "$EndNodes\n$Elements\n" + std::to_string(n_elements) + '\n' +
         elements.str() + "$EndElements\n";
}



// The mid-sides on an arc lie on its circle, also those of triangles; all
// others are straight: of lines inside that join two points of the circle, and
// of a boundary that lies on the circle but is not in the group.
void test_arcs()
{
  std::cout << "Arcs" << std::endl;
  const Point<2> center(1, 3);
  for (unsigned int refinements = 0; refinements < 4; ++refinements)
    {
      auto parameters = parameters_for(half_disc(6), refinements);
      parameters.arcs = { { "Arc", { center[0], center[1], 2 } } };
      const Mesh mesh(parameters);

      const auto  &ids     = mesh.boundary("Arc", "a test");
      double       off_arc = 0, bent = 0;
      unsigned int n_on_arc = 0, n_on_triangles = 0;
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          {
            const auto     face = cell->face(f);
            const Point<2> p    = mid_side(cell, f);
            if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
              {
                ++n_on_arc;
                n_on_triangles += is_triangle(cell);
                off_arc =
                  std::max({ off_arc,
                             std::abs(p.distance(center) - 2),
                             std::abs(face->vertex(0).distance(center) - 2),
                             std::abs(face->vertex(1).distance(center) - 2) });
              }
            else
              bent =
                std::max(bent,
                         p.distance(0.5 * (face->vertex(0) + face->vertex(1))));
          }

      // Ten of twelve lines are round, the other two stay straight.
      const double exact =
        10 * numbers::PI / 6. + 2 * 2 * std::sin(numbers::PI / 12.);
      const Area computed = area(mesh.triangulation);
      std::cout << mesh.triangulation.n_active_cells() << " cells, " << n_on_arc
                << " lines on the arc, " << n_on_triangles << " of triangles: "
                << (off_arc < 2e-12 ? "round" : "NOT round") << ", the others "
                << (bent < 1e-12 ? "straight" : "NOT straight")
                << ", determinants "
                << (computed.least_fraction > 0 ? "positive" : "NOT positive")
                << ", area off by " << computed.total / exact - 1 << std::endl;
    }
}



// What is wrong in a file is said, and where.
void test_file_errors()
{
  std::cout << "Errors in files" << std::endl;
  const auto read = [](const std::string &content) {
    first_line([&] { Mesh mesh(parameters_for(content)); });
  };

  first_line([] {
    Parameters::Mesh parameters;
    parameters.file = "mesh_reader_which_is_not_there.msh";
    Mesh mesh(parameters);
  });
  first_line([] {
    Parameters::Mesh parameters;
    parameters.file = ".";
    Mesh mesh(parameters);
  });
  read("");
  read("solid by another program\n");
  read(replaced(msh_22, "2.2 0 8", "2.2 1 8"));
  read(replaced(msh_22, "2.2 0 8", "4.0 0 8"));

  // Truncated, and counts which are wrong.
  read(msh_22.substr(0, msh_22.find("6 2 1 0")));
  read(msh_41.substr(0, msh_41.find("2 2 3 1\n15")));
  read(replaced(msh_22, "$EndElements\n", ""));
  read(msh_22.substr(0, msh_22.find("a section nobody")));
  read(replaced(msh_22, "$Nodes\n11", "$Nodes\n10"));
  read(replaced(msh_22, "$Nodes\n11", "$Nodes\n12"));

  // Words and nodes.
  read(replaced(msh_22, "3 2 0 0", "3 2 zero 0"));
  read(replaced(msh_41, "9 5 4", "9 5"));
  read(replaced(msh_22, "14 3 2 9 1 1 2 5 4", "14 3 2 9 1 1 2 5 44"));
  read(replaced(msh_22, "3 2 0 0", "2 2 0 0"));
  read(replaced(msh_22, "3 2 0 0", "3 2 0 0.5"));

  // Elements.
  read(replaced(msh_22, "14 3 2 9 1 1 2 5 4", "14 4 2 9 1 1 2 5 4"));
  read(replaced(msh_22, "14 3 2 9 1 1 2 5 4", "14 3 2 9 1 1 5 2 4"));
  read(replaced(msh_22, "15 2 2 9 1 2 6 3", "15 2 2 9 1 1 2 3"));
  read(replaced(msh_22, "14 3 2 9 1 1 2 5 4", "14 3 2 9 1 1 2 3 5"));
  read(replaced(msh_22, "16 2 2 9 1 2 6 5", "16 2 2 9 1 2 6 4"));
  read(replaced(replaced(msh_22, "$Elements\n17", "$Elements\n18"),
                "14 3 2 9 1 1 2 5 4",
                "14 3 2 9 1 1 2 5 4\n18 2 2 9 1 2 6 4"));
}



// And what is wrong with groups.
void test_group_errors()
{
  std::cout << "Errors in groups" << std::endl;
  const auto read = [](const std::string &content) {
    first_line([&] { Mesh mesh(parameters_for(content)); });
  };

  // Bodies: none, a cell of none, cells of two (in each format).
  read(replaced(
    replaced(replaced(msh_22, "2 9 \"Lower\"\n", ""), "2 10 \"Upper\"\n", ""),
    "$PhysicalNames\n10",
    "$PhysicalNames\n8"));
  read(replaced(msh_22, "14 3 2 9 1", "14 3 2 0 1"));
  read(replaced(replaced(msh_22, "$Elements\n17", "$Elements\n18"),
                "$EndElements",
                "18 3 2 10 1 2 5 4 1\n$EndElements"));
  read(replaced(msh_41, "1 9 4 1 2 5 4", "2 9 10 4 1 2 5 4"));

  // Names: empty groups, a name twice, none at all, of a volume.
  read(replaced(msh_22, "17 3 2 10 2", "17 3 2 9 2"));
  read(
    replaced(replaced(msh_22, "11 1 2 8", "11 1 2 0"), "12 1 2 8", "12 1 2 0"));
  read(replaced(msh_22, "\"Foot\"", "\"Bottom\""));
  read(replaced(msh_22, "\"Foot\"", ""));
  read(replaced(msh_22, "2 9 \"Lower\"", "3 9 \"Lower\""));

  // A line of a group that bounds no cell.
  read(replaced(msh_22, "11 1 2 8 3 5 4", "11 1 2 8 3 6 4"));

  // Groups asked for: what there is not, and what is of no use.
  const Mesh mesh(parameters_for(msh_22));
  first_line([&] { mesh.body("Middle", "an entry"); });
  first_line([&] { mesh.boundary("Top", "an entry"); });
  first_line([&] { mesh.boundary("Inside", "an entry"); });
  first_line([&] { mesh.point("Bottom", "an entry"); });
  first_line([&] { mesh.point("Centre", "an entry"); });
  first_line([&] { mesh.point("Pair", "an entry"); });
  std::cout << mesh.body_name(mesh.body("Upper", "an entry")) << std::endl;

  // The whole message once: what, where, remedy.
  try
    {
      mesh.boundary("Top", "Contact/Slave");
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
  try
    {
      Mesh damaged(parameters_for(replaced(msh_22, "5 1 1 0", "5 1 1")));
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }

  // An arc which is not one, and one which is no group.
  for (const std::string group : { "The top", "Round" })
    first_line([&] {
      auto parameters = parameters_for(msh_22);
      parameters.arcs = { { group, { 1, 0, 1 } } };
      Mesh with_arc(parameters);
    });
}



int main()
{
  test_formats();
  test_second_order();
  test_order();
  test_arcs();
  test_file_errors();
  test_group_errors();
}
