/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Meshes of hexahedra: whatever way the corners of a cell are listed, volumes
// are positive and right, names, faces and points are found; round boundaries
// stay round under refinement, volumes converge with the square of the mesh
// size, with elements of degree 2 with its fourth power, and cells are as well
// shaped as where volumes are filled from the coarse mesh; faults are reported.

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <iostream>

#include "mesh/mesh.h"
#include "mpi_session.h"
#include "tests.h"
#include "volume_mesh.h"

using namespace Tests;

namespace
{
  Parameters::Mesh parameters_for(const VolumeText  &mesh,
                                  const unsigned int refinements = 0)
  {
    mesh.write("volume.msh");
    Parameters::Mesh parameters;
    parameters.file        = "volume.msh";
    parameters.refinements = refinements;
    return parameters;
  }



  double volume(const Mesh<3> &mesh)
  {
    double volume = 0;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      volume += cell->measure();
    return volume;
  }



  double area(const Mesh<3> &mesh, const std::string &name)
  {
    const auto &ids  = mesh.boundary(name, "test");
    double      area = 0;
    for (const auto &face : mesh.triangulation.active_face_iterators())
      if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
        area += face->measure();
    return area;
  }



  // All 48 ways to list the corners of a cube: those that keep its edges edges.
  std::vector<VolumeText::Order> all_orders()
  {
    const auto place = [](const unsigned int corner) {
      const unsigned int layer = corner % 4;
      return std::array<unsigned int, 3>{
        {layer == 1 || layer == 2, layer == 2 || layer == 3, corner / 4}};
    };
    std::vector<VolumeText::Order> orders;
    std::array<unsigned int, 3>    axes = {{0, 1, 2}};
    do
      for (unsigned int flips = 0; flips < 8; ++flips)
        {
          VolumeText::Order order;
          for (unsigned int c = 0; c < 8; ++c)
            for (unsigned int other = 0; other < 8; ++other)
              {
                bool is_same = true;
                for (unsigned int d = 0; d < 3; ++d)
                  is_same = is_same && place(other)[axes[d]] ==
                                         (place(c)[d] ^ ((flips >> d) & 1));
                if (is_same)
                  order[c] = other;
              }
          orders.push_back(order);
        }
    while (std::next_permutation(axes.begin(), axes.end()));
    return orders;
  }



  void test_orders()
  {
    headline("Corners in any order");
    const auto orders = all_orders();
    check("48 orders", orders.size() == 48);
    bool all_right = true;
    for (const auto &order : orders)
      {
        VolumeText text;
        text.block("Lower", {{2, 1, 1}}, box({0, 0, 0}, {2, 1, 1}), order);
        text.block("Upper", {{1, 2, 1}}, box({0, 0, 1}, {2, 1, 3}));
        const Mesh<3> mesh(parameters_for(text, 1));
        all_right = all_right && std::abs(volume(mesh) - 6) < 1e-12;
        for (const auto &cell : mesh.triangulation.active_cell_iterators())
          all_right = all_right && cell->measure() > 0;
        all_right = all_right &&
                    std::abs(area(mesh, "Lower left") - 1) < 1e-12 &&
                    std::abs(area(mesh, "Lower top") - 2) < 1e-12 &&
                    std::abs(area(mesh, "Upper back") - 4) < 1e-12;
      }
    check("volumes and areas are right", all_right);
  }



  void test_names()
  {
    headline("Names");
    VolumeText text;
    text.block("Lower", {{1, 1, 1}}, box({0, 0, 0}, {1, 1, 1}));
    text.block("Upper", {{1, 1, 1}}, box({0, 0, 1}, {1, 1, 2}));
    const Mesh<3> mesh(parameters_for(text));
    check("two bodies, two pieces",
          mesh.bodies.size() == 2 && mesh.pieces.size() == 2);
    check("16 vertices: two at each place of the interface",
          mesh.triangulation.n_vertices() == 16);
    check("a point",
          mesh.triangulation.get_vertices()[mesh.point("Upper corner", "test")]
              .distance({0, 0, 1}) < 1e-15);
    std::cout << mesh.piece_name(0) << std::endl;
  }



  // Cells of second order, of which the corners are used: mid-sides that are
  // anywhere change nothing.
  void test_second_order()
  {
    headline("20 nodes");
    VolumeText quadratic;
    quadratic.block("Body", {{1, 1, 1}}, box({0, 0, 0}, {1, 1, 1}));
    quadratic.block("Body", {{1, 1, 1}}, box({2, 0, 0}, {3, 1, 1}));
    // A cell between the two, with twelve nodes behind its corners.
    quadratic.add(3, "Body", {2, 9, 11, 4, 6,  13, 15, 8,  9,  10,
                              9, 9, 9,  9, 10, 10, 10, 10, 10, 10});
    const Mesh<3> mesh(parameters_for(quadratic));
    check("a cell between two", mesh.triangulation.n_active_cells() == 3);
  }



  /// Volume, and the smallest Jacobian determinant by the lengths of the
  /// columns of the Jacobian, of cells of degree 2.
  std::pair<double, double> quadratic_volume(const Mesh<3> &mesh)
  {
    const FE_Nothing<3> element;
    const MappingQ<3>   mapping(2);
    const QGauss<3>     gauss(4);
    FEValues<3>         values(mapping,
                       element,
                       gauss,
                       update_JxW_values | update_jacobians);
    double              volume = 0, worst = 1;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        values.reinit(cell);
        for (unsigned int q = 0; q < gauss.size(); ++q)
          {
            const Tensor<2, 3> J = values.jacobian(q);
            volume += values.JxW(q);
            double lengths = 1;
            for (const Tensor<1, 3> &column :
                 {transpose(J)[0], transpose(J)[1], transpose(J)[2]})
              lengths *= column.norm();
            worst = std::min(worst, determinant(J) / lengths);
          }
      }
    return {volume, worst};
  }



  /// Fill the volumes behind round boundaries from the coarse mesh on.
  void fill_transfinitely(Mesh<3> &mesh)
  {
    const types::manifold_id filled = 100;
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        cell->set_manifold_id(filled);
        for (const auto &face : cell->face_iterators())
          if (face->manifold_id() == numbers::flat_manifold_id)
            face->set_manifold_id(filled);
        for (unsigned int l = 0; l < cell->n_lines(); ++l)
          if (cell->line(l)->manifold_id() == numbers::flat_manifold_id)
            cell->line(l)->set_manifold_id(filled);
      }
    TransfiniteInterpolationManifold<3> manifold;
    manifold.initialize(mesh.triangulation);
    mesh.triangulation.set_manifold(filled, manifold);
  }



  // A block bent to a piece of a shell with one round face. Vertices lie on it
  // after refinement, and the error of the volume, where that is known (> 0),
  // falls by four.
  void test_round(const std::string                             &kind,
                  const VolumeChart                             &chart,
                  const double                                   exact,
                  const std::function<double(const Point<3> &)> &distance,
                  const std::function<void(Parameters::Mesh &)> &set)
  {
    VolumeText text;
    text.block("Body", {{2, 2, 1}}, chart);
    std::array<double, 3> errors, quadratic, filled;
    double                farthest = 0, shape = 1, filled_shape = 1;
    for (unsigned int r = 0; r < 3; ++r)
      {
        Parameters::Mesh parameters = parameters_for(text, r + 1);
        set(parameters);
        const Mesh<3> mesh(parameters);
        errors[r]       = std::abs(volume(mesh) / exact - 1);
        const auto of_2 = quadratic_volume(mesh);
        quadratic[r]    = std::abs(of_2.first / exact - 1);
        shape           = std::min(shape, of_2.second);

        if (exact > 0)
          {
            parameters.refinements = 0;
            Mesh<3> other(parameters);
            fill_transfinitely(other);
            other.triangulation.refine_global(r + 1);
            const auto of_other = quadratic_volume(other);
            filled[r]           = std::abs(of_other.first / exact - 1);
            filled_shape        = std::min(filled_shape, of_other.second);
          }
        const auto &ids = mesh.boundary("Body top", "test");
        for (const auto &face : mesh.triangulation.active_face_iterators())
          if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
            for (unsigned int v = 0; v < 4; ++v)
              farthest =
                std::max(farthest, std::abs(distance(face->vertex(v))));
      }
    check(kind + ": vertices are on it", farthest < 1e-12);
    const auto are_orders = [](const auto &errors, const double order) {
      return std::abs(std::log2(errors[0] / errors[1]) - order) < 0.1 &&
             std::abs(std::log2(errors[1] / errors[2]) - order) < 0.1;
    };
    if (exact > 0)
      {
        check("  orders of the volume are 2", are_orders(errors, 2));
        check("  of degree 2: 4", are_orders(quadratic, 4));
        check("  as exact as volumes filled from the coarse mesh",
              quadratic[2] < filled[2]);
        check("  cells as well shaped", shape > 0.95 * filled_shape);
      }
  }



  void test_surfaces()
  {
    headline("Round boundaries");
    const double pi = numbers::PI;
    // Where the edges of the round face move along it.
    const double unknown = 0;
    // From the plane z = 1/2 up to the surface, over a square.
    const auto half_width = 0.8;
    const auto xy         = [&](const Point<3> &s) {
      return Point<2>(half_width * (2 * s[0] - 1), half_width * (2 * s[1] - 1));
    };
    const auto below = [&](const std::function<double(const Point<2> &)> &top) {
      return [=](const Point<3> &s) {
        const Point<2> p = xy(s);
        return Point<3>(p[0], p[1], 0.5 + s[2] * (top(p) - 0.5));
      };
    };
    const auto integral =
      [&](const std::function<double(const Point<2> &)> &f) {
        const QGauss<2> gauss(40);
        double          sum = 0;
        for (unsigned int q = 0; q < gauss.size(); ++q)
          {
            const Point<2> s = gauss.point(q);
            sum += gauss.weight(q) * (f(xy(Point<3>(s[0], s[1], 0))) - 0.5);
          }
        return 4 * half_width * half_width * sum;
      };

    // Its sides are planes through the centre, which projection leaves as they
    // are; the solid angle of a square of half width w at the distance 1 is 4
    // asin(w^2 / (1 + w^2)).
    const double w = 0.8;
    test_round(
      "sphere",
      [=](const Point<3> &s) {
        const Point<3> ray(w * (2 * s[0] - 1), w * (2 * s[1] - 1), 1);
        return Point<3>((1 + s[2]) / ray.norm() * ray);
      },
      4 * std::asin(w * w / (1 + w * w)) * (8 - 1) / 3.,
      [](const Point<3> &p) { return p.norm() - 2; },
      [](Parameters::Mesh &parameters) {
        parameters.spheres = {{"Body top", {0, 0, 0, 2}},
                              {"Body bottom", {0, 0, 0, 1}}};
      });
    const auto cylinder = [](const Point<2> &p) {
      return std::sqrt(4 - p[0] * p[0]);
    };
    test_round(
      "cylinder",
      below(cylinder),
      integral(cylinder),
      [](const Point<3> &p) { return std::hypot(p[0], p[2]) - 2; },
      [](Parameters::Mesh &parameters) {
        parameters.cylinders = {{"Body top", {0, 9, 0, 0, -3, 0, 2}}};
      });
    // About the axis x through (-3, 0, 0), opening with 30 degrees.
    const double slope = std::tan(pi / 6);
    const auto   cone  = [=](const Point<2> &p) {
      const double r = slope * (p[0] + 3);
      return std::sqrt(r * r - p[1] * p[1]);
    };
    test_round(
      "cone",
      below(cone),
      unknown,
      [=](const Point<3> &p) {
        return (std::hypot(p[1], p[2]) - slope * (p[0] + 3)) * std::cos(pi / 6);
      },
      [](Parameters::Mesh &parameters) {
        parameters.cones = {{"Body top", {-3, 0, 0, 1, 0, 0, 30}}};
      });
    // A ring of radius 3 about the axis y through (0, 0, -2), its tube 1.
    const auto torus = [](const Point<2> &p) {
      const double from_axis = 3 + std::sqrt(1 - p[1] * p[1]);
      return std::sqrt(from_axis * from_axis - p[0] * p[0]) - 2;
    };
    test_round(
      "torus",
      below(torus),
      unknown,
      [](const Point<3> &p) {
        return std::hypot(std::hypot(p[0], p[2] + 2) - 3, p[1]) - 1;
      },
      [](Parameters::Mesh &parameters) {
        parameters.tori = {{"Body top", {0, 0, -2, 0, 1, 0, 3, 1}}};
      });
  }



  // Moved, scaled, turned about x, then y, then z, and shifted.
  void test_placement()
  {
    headline("Placement");
    VolumeText text;
    text.block("Body", {{1, 1, 1}}, box({0, 0, 0}, {1, 2, 3}));
    const Mesh<3>    plain(parameters_for(text));
    Parameters::Mesh parameters = parameters_for(text);
    parameters.move             = {{"Body", {1, 0, -1}}};
    parameters.scale            = 2;
    parameters.rotation         = {90, 90, 90};
    parameters.shift            = {0, 0, 5};
    const Mesh<3> mesh(parameters);
    // (x, y, z) -> (x, -z, y) -> (y, -z, -x) -> (z, y, -x).
    double largest = 0;
    for (unsigned int v = 0; v < 8; ++v)
      {
        const Point<3> X = plain.triangulation.get_vertices()[v];
        const Point<3> x = mesh.triangulation.get_vertices()[v];
        largest =
          std::max(largest,
                   x.distance(
                     Point<3>(2 * (X[2] - 1), 2 * X[1], 5 - 2 * (X[0] + 1))));
      }
    check("vertices are where they belong", largest < 1e-14);
  }



  void expect_error(const std::string           &what,
                    const std::string           &part,
                    const std::function<void()> &read)
  {
    try
      {
        read();
        check(what, false);
      }
    catch (const InputError &error)
      {
        check(what, std::string(error.what()).find(part) != std::string::npos);
      }
  }



  void test_errors()
  {
    headline("Errors");
    const auto unit = box({0, 0, 0}, {1, 1, 1});
    const auto with = [&](const auto &change) {
      VolumeText text;
      text.block("Body", {{1, 1, 1}}, unit);
      change(text);
      Mesh<3> mesh(parameters_for(text));
    };
    expect_error("a tetrahedron on a hexahedron", "meets two triangles", [&] {
      with([](VolumeText &text) { text.add(3, "Body", {1, 2, 3, 5}, 4); });
    });
    expect_error("a triangle on a volume", "no face of a hexahedron", [&] {
      with([](VolumeText &text) { text.add(2, "Tip", {1, 2, 3}, 2); });
    });
    expect_error("a face inside nothing", "is no face of a cell", [&] {
      with([](VolumeText &text) { text.add(2, "Cut", {1, 2, 8, 7}); });
    });
    expect_error("a face in a crossing order", "order that crosses it", [&] {
      VolumeText text;
      text.add(2, "Cut", {1, 2, 3, 4});
      text.block("Body", {{1, 1, 1}}, unit);
      Mesh<3> mesh(parameters_for(text));
    });
    expect_error("a cell twice", "has the corners of element", [&] {
      with([](VolumeText &text) {
        text.add(3, "Body", {1, 2, 4, 3, 5, 6, 8, 7});
      });
    });
    expect_error("a tangled cell", "tangled", [&] {
      VolumeText text;
      text.block("Body", {{1, 1, 1}}, unit, {{0, 1, 3, 2, 4, 5, 6, 7}});
      Mesh<3> mesh(parameters_for(text));
    });
    const auto with_parameters = [&](const auto &set) {
      VolumeText text;
      text.block("Body", {{1, 1, 1}}, unit);
      Parameters::Mesh parameters = parameters_for(text);
      set(parameters);
      Mesh<3> mesh(parameters);
    };
    bool of_volumes = false;
    try
      {
        VolumeText text;
        text.block("Body", {{1, 1, 1}}, unit);
        Mesh<2> mesh(parameters_for(text));
      }
    catch (const MeshOfVolumes &)
      {
        of_volumes = true;
      }
    check("volumes where a plane mesh is wanted", of_volumes);
    expect_error("an arc in 3-D", "no arcs", [&] {
      with_parameters([](auto &p) { p.arcs = {{"Body top", {0, 0, 1}}}; });
    });
    expect_error("a sphere elsewhere", "away from its surface", [&] {
      with_parameters([](auto &p) {
        p.spheres = {{"Body top", {0, 0, 0, 2}}};
      });
    });
  }
} // namespace



int main()
{
  test_orders();
  test_names();
  test_second_order();
  test_surfaces();
  test_placement();
  test_errors();
  return 0;
}
