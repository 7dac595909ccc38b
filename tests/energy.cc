/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the internal forces are the derivative of the strain energy, and
// the tangent that of the forces, with the dilatation as it is and projected;
// that the projection is one; and that the smallest volume ratio is found.

#include <deal.II/hp/fe_values.h>

#include "derivatives.h"

using namespace Tests;

namespace
{
  enum class Cells
  {
    mixed,
    triangles,
    quadrangles
  };



  // A block of 3 times 2 cells, its nodes moved at random.
  Parameters::All make_case(const unsigned int degree,
                            const std::string &centre_node,
                            const std::string &kinematics,
                            const std::string &dilatation,
                            const Cells        cells  = Cells::mixed,
                            const double       moving = 0.1)
  {
    Random   random;
    MeshText mesh;
    mesh.block(
      "block",
      3,
      2,
      [&](const double s, const double t) {
        return Point<2>(3 * s + random(-moving, moving),
                        2 * t + random(-moving, moving));
      },
      [=](const unsigned int i, const unsigned int j) {
        return cells == Cells::triangles ||
               (cells == Cells::mixed && i + j == 2);
      });
    Parameters::All parameters =
      make_parameters(mesh, {"block"}, degree, kinematics, 1000, 0.46);
    parameters.element.centre_node = centre_node;
    parameters.solids.dilatation   = dilatation;
    return parameters;
  }



  GhostedVector random_displacement(const Bodies &bodies)
  {
    Random        random;
    GhostedVector u(bodies.n_dofs());
    for (double &value : u)
      value = random(-0.1, 0.1);
    return u;
  }



  void derivatives(const unsigned int degree,
                   const std::string &centre_node,
                   const std::string &kinematics,
                   const std::string &dilatation)
  {
    headline("degree " + std::to_string(degree) +
             (degree == 2 ? ", centre " + centre_node : "") + ", " +
             kinematics + ", " + dilatation);
    const Bodies bodies(make_case(degree, centre_node, kinematics, dilatation));
    const auto   found =
      compare_with_differences(bodies,
                               random_displacement(bodies),
                               [&](const GhostedVector &u) {
                                 return bodies.elasticity->strain_energy(u);
                               });
    check_small("forces against central differences of the energy",
                found.forces,
                1e-8);
    check_small("tangent against those of the forces", found.tangent, 1e-8);
    check_small("asymmetry", found.asymmetry, 1e-14);
    check("projected as announced",
          bodies.elasticity->elastic_body(0).is_projected ==
            (dilatation != "full"));
  }



  double energy(const Parameters::All                           &parameters,
                const std::function<Point<2>(const Point<2> &)> &position)
  {
    const Bodies bodies(parameters);
    return bodies.elasticity->strain_energy(bodies.displacement(position));
  }



  // A displacement with the same dilatation everywhere, or at degree 2 a linear
  // one on quadrangles that are parallelograms, is projected onto itself; what
  // has more is not, and loses energy. Triangles of degree 1 have the same
  // everywhere.
  void projection(const unsigned int degree)
  {
    headline("projection, degree " + std::to_string(degree));
    const auto homogeneous = [](const Point<2> &X) {
      return Point<2>(1.1 * X[0] + 0.2 * X[1], 0.9 * X[1] - 0.1 * X[0]);
    };
    const auto bent = [](const Point<2> &X) {
      return Point<2>(X[0] + 0.1 * X[0] * X[1], X[1] - 0.05 * X[0] * X[0]);
    };
    Random     random;
    const auto any = [&](const Point<2> &X) {
      return X + Point<2>(random(-0.1, 0.1), random(-0.1, 0.1));
    };

    const auto lost = [&](const auto        &position,
                          const std::string &kinematics,
                          const Cells        cells,
                          const double       moving) {
      random            = Random();
      const double full = energy(
        make_case(degree, "serendipity", kinematics, "full", cells, moving),
        position);
      random               = Random();
      const double reduced = energy(
        make_case(degree, "serendipity", kinematics, "B-bar", cells, moving),
        position);
      return 1 - reduced / full;
    };

    for (const std::string kinematics : {"small strain", "large displacement"})
      check_small("homogeneous, " + kinematics,
                  std::abs(lost(homogeneous, kinematics, Cells::mixed, 0.1)),
                  1e-14);
    if (degree == 2)
      check_small("linear dilatation",
                  std::abs(lost(bent, "small strain", Cells::quadrangles, 0)),
                  1e-13);
    for (const std::string kinematics : {"small strain", "large displacement"})
      {
        check("any loses energy, " + kinematics,
              lost(any, kinematics, Cells::mixed, 0.1) > 0.01);
        if (degree == 1)
          check("but not of triangles, " + kinematics,
                lost(any, kinematics, Cells::triangles, 0.1) == 0);
      }
  }



  // The entry "automatic".
  void choice()
  {
    headline("automatic");
    for (const double poisson : {0.3, 0.454, 0.455, 0.499})
      {
        Parameters::All parameters =
          make_case(1, "serendipity", "small strain", "automatic");
        parameters.solids.poisson["block"] = poisson;
        const Bodies bodies(parameters);
        std::cout << "  nu = " << poisson << ": "
                  << (bodies.elasticity->elastic_body(0).is_projected
                        ? "projected"
                        : "full")
                  << std::endl;
      }
  }



  // Against the gradients of deal.II.
  void volume_ratio(const unsigned int degree)
  {
    headline("volume ratio, degree " + std::to_string(degree));
    const Bodies bodies(
      make_case(degree, "free", "large displacement", "full"));
    GhostedVector u = random_displacement(bodies);
    u *= 5;

    hp::FEValues<2>                  hp_fe_values(bodies.discretization.mapping,
                                 bodies.discretization.fe,
                                 bodies.discretization.quadrature,
                                 update_gradients);
    const FEValuesExtractors::Vector displacement(0);
    std::vector<Tensor<2, 2>>        H;
    VolumeRatio<2>                   expected;
    for (const auto &cell :
         bodies.discretization.dof_handler.active_cell_iterators())
      {
        hp_fe_values.reinit(cell);
        const auto &fe_values = hp_fe_values.get_present_fe_values();
        H.resize(fe_values.n_quadrature_points);
        fe_values[displacement].get_function_gradients<Vector<double>>(u, H);
        for (unsigned int q = 0; q < H.size(); ++q)
          {
            const double det_F = determinant(
              H[q] + static_cast<Tensor<2, 2>>(unit_symmetric_tensor<2>()));
            if (det_F < expected.value)
              expected = {det_F, cell->material_id(), cell->center()};
          }
      }

    GhostedVector rhs(bodies.n_dofs());
    const auto    found = bodies.elasticity->assemble(u, 0, rhs, nullptr);
    const auto    with_tangent =
      bodies.elasticity->visit_cells(u, true, [](const auto &...) {});
    const auto of_all = smallest_of_all_ranks(found, MPI_COMM_WORLD);
    check("inside out", expected.value < 0);
    check_small("value", std::abs(found.value - expected.value), 1e-13);
    check_small("centre of the cell", found.X.distance(expected.X), 1e-13);
    check("body", found.body == expected.body);
    check("the same with the tangent",
          with_tangent.value == found.value && with_tangent.X == found.X);
    check("the same of all ranks",
          of_all.value == found.value && of_all.X == found.X &&
            of_all.body == found.body);

    u = 0;
    check("one if nothing moves",
          bodies.elasticity->assemble(u, 0, rhs, nullptr).value == 1);

    const Bodies linear(make_case(degree, "free", "small strain", "full"));
    u = random_displacement(linear);
    u *= 5;
    check("one in small strain",
          linear.elasticity->assemble(u, 0, rhs, nullptr).value == 1);
  }
} // namespace



int main()
{
  for (const std::string kinematics : {"small strain", "large displacement"})
    for (const std::string dilatation : {"full", "B-bar"})
      {
        derivatives(1, "serendipity", kinematics, dilatation);
        derivatives(2, "serendipity", kinematics, dilatation);
        derivatives(2, "free", kinematics, dilatation);
      }
  choice();
  for (const unsigned int degree : {1, 2})
    {
      projection(degree);
      volume_ratio(degree);
    }
  return 0;
}
