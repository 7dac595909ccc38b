/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the estimated error of hexahedra is that of a smooth displacement
// with elements of degree 1, and by how much it is off with degree 2, also on
// distorted meshes. That it vanishes under a uniform pressure between surfaces
// with hanging nodes: space_hanging.cc.

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include "adaptivity/error_estimator.h"
#include "error_indicators.h"
#include "volume_mesh.h"

using namespace Tests;

namespace
{
  Point<3> smooth(const Point<3> &X)
  {
    return {0.01 * std::sin(2 * X[0]) * std::exp(X[1]),
            0.01 * std::cos(X[0] + 2 * X[1] - X[2]),
            0.01 * std::sin(X[1]) * std::exp(X[2])};
  }



  Tensor<2, 3> gradient_of_smooth(const Point<3> &X)
  {
    const double s = std::sin(X[0] + 2 * X[1] - X[2]);
    Tensor<2, 3> gradient;
    gradient[0][0] = 0.02 * std::cos(2 * X[0]) * std::exp(X[1]);
    gradient[0][1] = 0.01 * std::sin(2 * X[0]) * std::exp(X[1]);
    gradient[1][0] = -0.01 * s;
    gradient[1][1] = -0.02 * s;
    gradient[1][2] = 0.01 * s;
    gradient[2][1] = 0.01 * std::cos(X[1]) * std::exp(X[2]);
    gradient[2][2] = 0.01 * std::sin(X[1]) * std::exp(X[2]);
    return gradient;
  }



  /// Of the interpolated displacement, in the norm of the energy: by Lame's
  /// constants, as the stress of the plane is not that of space.
  double true_error(const BodiesIn<3> &bodies, const GhostedVector &u)
  {
    const hp::QCollection<3>  quadrature(QGauss<3>(4));
    hp::FEValues<3>           hp_fe_values(bodies.discretization.mapping,
                                 bodies.discretization.fe,
                                 quadrature,
                                 update_gradients | update_JxW_values |
                                   update_quadrature_points);
    const Material            material(youngs_modulus, 0.3);
    std::vector<Tensor<2, 3>> gradients;
    double                    square = 0;
    for (const auto &cell :
         bodies.discretization.dof_handler.active_cell_iterators())
      {
        hp_fe_values.reinit(cell);
        const auto &fe_values = hp_fe_values.get_present_fe_values();
        gradients.resize(fe_values.n_quadrature_points);
        fe_values[FEValuesExtractors::Vector(0)]
          .get_function_gradients<Vector<double>>(u, gradients);
        for (const unsigned int q : fe_values.quadrature_point_indices())
          {
            const SymmetricTensor<2, 3> strain = symmetrize(
              gradients[q] - gradient_of_smooth(fe_values.quadrature_point(q)));
            square += (material.lambda * trace(strain) * trace(strain) +
                       2 * material.mu * (strain * strain)) *
                      fe_values.JxW(q);
          }
      }
    return std::sqrt(square);
  }



  /// Where every side is held, so that the boundary adds nothing.
  double effectivity(const unsigned int degree,
                     const VolumeChart &chart,
                     const unsigned int refinements)
  {
    VolumeText mesh;
    mesh.block("Block", {{2, 2, 2}}, chart);
    mesh.write("volume.msh");
    Parameters::All parameters;
    parameters.mesh.file                      = "volume.msh";
    parameters.mesh.refinements               = refinements;
    parameters.element.degree                 = degree;
    parameters.element.centre_node            = "free";
    parameters.solids.kinematics              = Parameters::Strains::small;
    parameters.solids.youngs_modulus["Block"] = youngs_modulus;
    parameters.solids.poisson["Block"]        = 0.3;
    for (const std::string side :
         {"left", "right", "front", "back", "bottom", "top"})
      for (unsigned int c = 0; c < 3; ++c)
        parameters.boundary.displacement[c]["Block " + side] = 0;
    const BodiesIn<3>       bodies(parameters.for_space());
    const StressRecovery<3> recovery(bodies.discretization);
    const GhostedVector     u =
      bodies.displacement([](const Point<3> &X) { return X + smooth(X); });
    const ErrorEstimator<3> estimator(bodies.discretization,
                                      *bodies.elasticity);
    return std::sqrt(sum(estimator.indicators(
             recovery.vertex_stresses(*bodies.elasticity, u),
             nullptr,
             u))) /
           true_error(bodies, u);
  }



  // From 2 to 8 cells a side.
  void print_effectivities(const std::string &name,
                           const unsigned int degree,
                           const VolumeChart &chart)
  {
    std::cout << "  degree " << degree << ", " << name << ':';
    double last = 0;
    for (unsigned int refinements = 0; refinements < 3; ++refinements)
      {
        last = effectivity(degree, chart, refinements);
        std::cout << ' ' << two_digits(last);
      }
    std::cout << std::endl;
    if (degree == 1)
      check("within 0.95..1.05 on the finest mesh", last > 0.95 && last < 1.05);
    else
      check("within 0.35..0.6 on the finest mesh", last > 0.35 && last < 0.6);
  }
} // namespace



int main()
{
  headline("effectivity");
  const VolumeChart cube = box({0, 0, 0}, {1, 1, 1});
  const VolumeChart bent = [](const Point<3> &s) {
    return Point<3>(s[0] + 0.3 * s[0] * s[1],
                    s[1] + 0.2 * s[2] - 0.2 * s[0] * s[1],
                    s[2] + 0.1 * s[0] * s[2]);
  };
  for (const unsigned int degree : {1, 2})
    {
      print_effectivities("cubes", degree, cube);
      print_effectivities("hexahedra", degree, bent);
    }
  return 0;
}
