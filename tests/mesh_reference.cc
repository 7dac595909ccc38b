/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The reference mesh of the cylinder on the block, if it is at hand: what is
// read, that the mid-sides of the contact arc, and no others, lie on its
// circle, and that refinement keeps all that.

#include <filesystem>
#include <iostream>

#include "mesh_facts.h"

using namespace Contact;

int main()
{
  const std::filesystem::path directory(REFERENCE_DIRECTORY);
  if (!std::filesystem::is_directory(directory))
    {
      std::cout << "skipped: no reference meshes" << std::endl;
      return 0;
    }

  const Point<2>    center(0, 50);
  const double      radius = 50;
  const std::string arc    = "Bottom_C";
  for (const std::string name : {"linear", "quadratic"})
    for (const unsigned int refinements : {0, 2})
      {
        Parameters::Mesh parameters;
        parameters.file        = directory / ("ssnp154-" + name + ".msh");
        parameters.refinements = refinements;
        parameters.arcs        = {{arc, {center[0], center[1], radius}}};
        const Mesh<2> mesh(parameters);
        const auto   &triangulation = mesh.triangulation;
        const auto    found         = roundness(triangulation,
                                     mesh.boundary(arc, "a test"),
                                     center,
                                     radius);
        unsigned int  n_triangles   = 0;
        for (const auto &cell : triangulation.active_cell_iterators())
          n_triangles += is_triangle(cell);

        std::cout << name << ", refined " << refinements
                  << " times: " << triangulation.n_used_vertices()
                  << " vertices, "
                  << triangulation.n_active_cells() - n_triangles
                  << " quadrangles, " << n_triangles << " triangles, "
                  << found.n_lines << " lines on the arc, "
                  << found.n_of_triangles << " of triangles" << std::endl;
        std::cout << "mid-sides and vertices of the arc on the circle: "
                  << (found.off_circle < 1e-12 * radius ? "yes" : "no")
                  << ", others on chords: "
                  << (found.bent < 1e-12 * radius ? "yes" : "no")
                  << ", determinants positive: "
                  << (area(triangulation).least_fraction > 0 ? "yes" : "no")
                  << std::endl;

        // The cylinder: a round quarter, and twelve chords of 7.5 degrees.
        const double block = 100 * 200;
        const double cylinder =
          radius * radius / 2 *
          (numbers::PI / 2 + 12 * std::sin(numbers::PI / 24));
        std::cout
          << "areas off by "
          << area(triangulation, mesh.body("Block", "a test")).total / block - 1
          << " and "
          << area(triangulation, mesh.body("Cylinder", "a test")).total /
                 cylinder -
               1
          << std::endl;

        for (const auto &[group, boundary_ids] : mesh.boundaries)
          {
            unsigned int n_lines = 0;
            for (const auto &face : triangulation.active_face_iterators())
              n_lines += boundary_ids.count(face->boundary_id());
            std::cout << group << ": " << n_lines << " lines" << std::endl;
          }
        for (const auto &[point, vertices] : mesh.points)
          std::cout << point << ": "
                    << triangulation.get_vertices()[vertices[0]] << std::endl;
        std::cout << "B and C are two vertices: "
                  << (mesh.points.at("B") != mesh.points.at("C") ? "yes" : "no")
                  << std::endl;
      }
}
