/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the tangent of the bodies is the derivative of their residual, at
// a random finite displacement of quadrangles and triangles, that it is
// symmetric, and that the residual is that of the unconstrained forces.

#include "tests.h"

using namespace Tests;

namespace
{
  // The matrix and the residual, constraints eliminated.
  struct System
  {
    explicit System(const Bodies &bodies)
      : bodies(bodies)
      , residual(bodies.n_dofs())
    {
      DynamicSparsityPattern couplings(bodies.n_dofs(), bodies.n_dofs());
      bodies.elasticity->add_couplings(couplings);
      pattern.copy_from(couplings);
      matrix.reinit(pattern);
    }

    void assemble(const GhostedVector &u)
    {
      matrix   = 0;
      residual = 0;
      bodies.elasticity->assemble(u, 0.7, residual, &matrix);
      residual *= -1;
    }

    const Bodies        &bodies;
    SparsityPattern      pattern;
    SparseMatrix<double> matrix;
    GhostedVector        residual;
  };



  void compare(const unsigned int degree,
               const std::string &centre_node,
               const std::string &kinematics)
  {
    headline("degree " + std::to_string(degree) +
             (degree == 2 ? ", centre " + centre_node : "") + ", " +
             kinematics);

    Random   random;
    MeshText mesh;
    mesh.block(
      "block",
      3,
      2,
      [&](const double s, const double t) {
        return Point<2>(3 * s + random(-0.1, 0.1), 2 * t + random(-0.1, 0.1));
      },
      [](const unsigned int i, const unsigned int j) { return i + j == 2; });
    Parameters::All parameters =
      make_parameters(mesh, {"block"}, degree, kinematics);
    parameters.element.centre_node                  = centre_node;
    parameters.boundary.force[0]["block top right"] = 3;
    const Bodies bodies(parameters);

    GhostedVector u(bodies.n_dofs());
    for (double &value : u)
      value = random(-0.1, 0.1);

    System here(bodies), beside(bodies);
    here.assemble(u);

    double       error = 0, asymmetry = 0, largest = 0;
    const double h = 1e-5;
    for (unsigned int j = 0; j < u.size(); ++j)
      if (!bodies.discretization.constraints.is_constrained(j))
        {
          GhostedVector moved(u);
          moved[j] = u[j] + h;
          beside.assemble(moved);
          GhostedVector column(beside.residual);
          moved[j] = u[j] - h;
          beside.assemble(moved);
          column -= beside.residual;
          column /= 2 * h;

          for (unsigned int i = 0; i < u.size(); ++i)
            {
              const double k = here.matrix.el(i, j);
              error          = std::max(error, std::abs(k - column[i]));
              asymmetry =
                std::max(asymmetry, std::abs(k - here.matrix.el(j, i)));
              largest = std::max(largest, std::abs(k));
            }
        }
    check_small("tangent against central differences", error / largest, 1e-8);
    check_small("asymmetry", asymmetry / largest, 1e-14);

    // With a serendipity constraint this holds at the other nodes.
    GhostedVector difference = bodies.elasticity->forces(u, 0.7);
    difference -= here.residual;
    check_small("residual against forces",
                difference.linfty_norm() / here.residual.linfty_norm(),
                1e-14);
    check("linear as announced",
          bodies.elasticity->is_linear() == (kinematics == "small strain"));
  }
} // namespace



int main()
{
  for (const std::string kinematics : {"small strain", "large displacement"})
    {
      compare(1, "serendipity", kinematics);
      compare(2, "serendipity", kinematics);
      compare(2, "free", kinematics);
    }
  return 0;
}
