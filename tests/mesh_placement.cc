/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The placement of the mesh of a file: bodies are moved first, then everything
// is scaled, turned and shifted, and arcs go with their bodies.

#include <cmath>

#include "mesh_files.h"
#include "tests.h"

using namespace Tests;

namespace
{
  // Two squares with a round lower side each, on one circle of radius 1 about
  // the origin before the upper one is moved; "Arcs" is both of them.
  const std::string two_arcs = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 1 "Arcs"
2 2 "Left"
2 3 "Right"
$EndPhysicalNames
$Nodes
8
1 -0.8 -0.6 0
2 -0.28 -0.96 0
3 -0.28 0 0
4 -0.8 0 0
5 0.28 -0.96 0
6 0.8 -0.6 0
7 0.8 0 0
8 0.28 0 0
$EndNodes
$Elements
4
1 1 2 1 1 1 2
2 1 2 1 2 5 6
3 3 2 2 1 1 2 3 4
4 3 2 3 2 5 6 7 8
$EndElements
)";



  template<typename Place>
  double largest_distance(const Mesh<2> &mesh,
                          const Mesh<2> &plain,
                          const Place   &place)
  {
    double distance = 0;
    auto   other    = plain.triangulation.begin_active();
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        for (const unsigned int v : cell->vertex_indices())
          distance = std::max(distance,
                              cell->vertex(v).distance(
                                place(other->vertex(v), other->material_id())));
        ++other;
      }
    return distance;
  }



  // Proves the order of the steps, and that refined points are round about the
  // centre that their body has taken along, also of a group of both bodies.
  void check_placement()
  {
    headline("placement");
    auto parameters = parameters_for(two_arcs, 3);
    parameters.arcs = {{"Arcs", {0, 0, 1}}};
    const Mesh<2> plain(parameters);
    const auto   &right = plain.body("Right", "a test");

    parameters.move     = {{"Right", {0.5, 0.25}}};
    parameters.scale    = 2;
    parameters.rotation = {30};
    parameters.shift    = {10, -20};
    const Mesh<2> mesh(parameters);
    const double  c = std::sqrt(3.) / 2, s = 0.5;
    check_small("as moved by hand",
                largest_distance(
                  mesh,
                  plain,
                  [&](const Point<2> &p, const types::material_id body) {
                    const double x = 2 * (p[0] + (body == right ? 0.5 : 0));
                    const double y = 2 * (p[1] + (body == right ? 0.25 : 0));
                    return Point<2>(c * x - s * y + 10, s * x + c * y - 20);
                  }),
                1e-13);

    // The round lines are those of the plain mesh, and these are round.
    double misfit = 0;
    for (const auto &face : plain.triangulation.active_face_iterators())
      if (face->at_boundary() &&
          plain.boundary("Arcs", "a test").count(face->boundary_id()) > 0)
        for (const unsigned int v : {0, 1})
          misfit = std::max(misfit, std::abs(face->vertex(v).norm() - 1));
    check_small("round", misfit, 1e-13);
  }



  // Proves that the defaults leave every bit, and that micrometres and
  // kilometres are as good as millimetres.
  void check_scales()
  {
    headline("scales");
    auto parameters = parameters_for(two_arcs, 3);
    parameters.arcs = {{"Arcs", {0, 0, 1}}};
    const Mesh<2> plain(parameters);
    for (const double scale : {1., 0x1p-20, 0x1p20})
      {
        parameters.scale = scale;
        const Mesh<2> mesh(parameters);
        check("scale " + std::to_string(scale),
              largest_distance(mesh,
                               plain,
                               [&](const Point<2> &p,
                                   const types::material_id) {
                                 return Point<2>(scale * p);
                               }) == 0);
      }
  }



  void report(const Parameters::Mesh &parameters)
  {
    try
      {
        parameters.check();
        Mesh<2> mesh(parameters);
        std::cout << "  accepted" << std::endl;
      }
    catch (const InputError &error)
      {
        const std::string what = error.what();
        std::cout << "  " << what.substr(0, what.find('\n')) << std::endl;
      }
  }



  // Proves that wrong entries are refused, and so is a move that would tear
  // bodies apart which share nodes.
  void check_errors()
  {
    headline("errors");
    std::string glued = two_arcs;
    glued.replace(glued.find("5 6 7 8"), 7, "2 6 7 3");
    glued.replace(glued.find("2 1 2 1 2 5 6"), 13, "2 1 2 1 2 6 7");
    auto parameters = parameters_for(glued);
    report(parameters);
    parameters.move = {{"Right", {0, 1}}};
    report(parameters);
    parameters.move = {{"Right", {0, 1}}, {"Left", {0, 1}}};
    report(parameters);
    parameters.move = {{"Right", {0}}};
    report(parameters);
    parameters.move = {{"Middle", {0, 1}}};
    report(parameters);
    parameters.move  = {};
    parameters.shift = {1, 2, 3};
    report(parameters);
    parameters.shift = {1, 2};
    for (const double scale : {0., -1.})
      {
        parameters.scale = scale;
        report(parameters);
      }
  }
} // namespace



int main()
{
  check_placement();
  check_scales();
  check_errors();
  return 0;
}
