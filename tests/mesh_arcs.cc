/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Boundaries that are arcs of circles, of quadrangles and triangles.

#include <deal.II/base/numbers.h>

#include <iostream>
#include <sstream>

#include "mesh_facts.h"
#include "mesh_files.h"

using namespace Contact;

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

  for (const unsigned int ring : {1, 2})
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
      for (const unsigned int j : {i, i + 1})
        element("3 2 2 1" + node(1, j) + node(2, j) + node(2, j + 1) +
                node(1, j + 1));
    else if (i % 6 == 2)
      for (const unsigned int j : {i, i + 1})
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
      parameters.arcs = {{"Arc", {center[0], center[1], 2}}};
      const Mesh<2> mesh(parameters);

      const Roundness found = roundness(mesh.triangulation,
                                        mesh.boundary("Arc", "a test"),
                                        center,
                                        2);

      // Ten of twelve lines are round, the other two stay straight.
      const double exact =
        10 * numbers::PI / 6. + 2 * 2 * std::sin(numbers::PI / 12.);
      const Area computed = area(mesh.triangulation);
      std::cout << mesh.triangulation.n_active_cells() << " cells, "
                << found.n_lines << " lines on the arc, "
                << found.n_of_triangles << " of triangles: "
                << (found.off_circle < 2e-12 ? "round" : "NOT round")
                << ", the others "
                << (found.bent < 2e-12 ? "straight" : "NOT straight")
                << ", determinants "
                << (computed.least_fraction > 0 ? "positive" : "NOT positive")
                << ", area off by " << computed.total / exact - 1 << std::endl;
    }
}



int main()
{
  test_arcs();
  return 0;
}
