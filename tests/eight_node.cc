/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the quadrangle with a serendipity constraint is the 8-node
// serendipity element: residual and stiffness of a distorted, curved cell equal
// those that are integrated here from the explicit shape functions. And that
// all elements reproduce a linear displacement on a distorted mesh, and feel no
// rotation.

#include "tests.h"

using namespace Tests;

namespace
{
  const double youngs_modulus = 1000, poisson = 0.3;

  // Corners counterclockwise, then the mid-sides that follow them.
  const std::array<Point<2>, 8> unit_nodes{
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};



  // Gradient in the unit cell of
  //   (1 + x a)(1 + y b)(x a + y b - 1)/4        at the corners (a, b),
  //   (1 - x^2)(1 + y b)/2, (1 + x a)(1 - y^2)/2  at the mid-sides.
  Tensor<1, 2> unit_gradient(const unsigned int node, const Point<2> &p)
  {
    const double a = unit_nodes[node][0], b = unit_nodes[node][1];
    const double x = p[0], y = p[1];
    if (node < 4)
      return Tensor<1, 2>({a * (1 + y * b) * (2 * x * a + y * b) / 4,
                           b * (1 + x * a) * (x * a + 2 * y * b) / 4});
    if (a == 0)
      return Tensor<1, 2>({-x * (1 + y * b), b * (1 - x * x) / 2});
    return Tensor<1, 2>({a * (1 - y * y) / 2, -y * (1 + x * a)});
  }



  // The elasticities C_ijkl, without any of the symmetries used.
  double elasticity(const unsigned int i,
                    const unsigned int j,
                    const unsigned int k,
                    const unsigned int l)
  {
    const double lambda =
      youngs_modulus * poisson / ((1 + poisson) * (1 - 2 * poisson));
    const double mu = youngs_modulus / (2 * (1 + poisson));
    return lambda * (i == j) * (k == l) +
           mu * ((i == k) * (j == l) + (i == l) * (j == k));
  }



  /// The 8-node element from its definition, through the first
  /// Piola-Kirchhoff stress P = F S and dP/dF.
  struct Reference
  {
    Reference(const std::array<Point<2>, 8>     &X,
              const std::array<Tensor<1, 2>, 8> &u,
              const bool                         large)
      : residual(16)
      , matrix(16, 16)
    {
      const std::array<double, 3> points{{-std::sqrt(0.6), 0, std::sqrt(0.6)}};
      const std::array<double, 3> weights{{5. / 9, 8. / 9, 5. / 9}};
      for (unsigned int q = 0; q < 9; ++q)
        add_point(X,
                  u,
                  large,
                  Point<2>(points[q % 3], points[q / 3]),
                  weights[q % 3] * weights[q / 3]);
    }

    void add_point(const std::array<Point<2>, 8>     &X,
                   const std::array<Tensor<1, 2>, 8> &u,
                   const bool                         large,
                   const Point<2>                    &p,
                   const double                       weight)
    {
      Tensor<2, 2> J; // J_ij = dX_i/dxi_j
      for (unsigned int a = 0; a < 8; ++a)
        J += outer_product(X[a], unit_gradient(a, p));
      const double                JxW                = determinant(J) * weight;
      const Tensor<2, 2>          inverse_transposed = transpose(invert(J));
      std::array<Tensor<1, 2>, 8> gradient;
      Tensor<2, 2>                H;
      for (unsigned int a = 0; a < 8; ++a)
        {
          gradient[a] = inverse_transposed * unit_gradient(a, p);
          H += outer_product(u[a], gradient[a]);
        }

      Tensor<2, 2> I, S;
      I[0][0] = I[1][1]    = 1;
      const Tensor<2, 2> F = large ? H + I : I;
      const Tensor<2, 2> E =
        large ? 0.5 * (transpose(F) * F - I) : 0.5 * (H + transpose(H));
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          for (unsigned int k = 0; k < 2; ++k)
            for (unsigned int l = 0; l < 2; ++l)
              S[i][j] += elasticity(i, j, k, l) * E[k][l];

      for (unsigned int a = 0; a < 8; ++a)
        for (unsigned int i = 0; i < 2; ++i)
          {
            residual[2 * a + i] += JxW * (F * S * gradient[a])[i];
            for (unsigned int b = 0; b < 8; ++b)
              for (unsigned int k = 0; k < 2; ++k)
                for (unsigned int j = 0; j < 2; ++j)
                  for (unsigned int l = 0; l < 2; ++l)
                    {
                      // dP_ij/dF_kl
                      double A = large && i == k ? S[l][j] : 0;
                      for (unsigned int m = 0; m < 2; ++m)
                        for (unsigned int n = 0; n < 2; ++n)
                          A += F[i][m] * elasticity(m, j, n, l) * F[k][n];
                      matrix(2 * a + i, 2 * b + k) +=
                        JxW * A * gradient[a][j] * gradient[b][l];
                    }
          }
    }

    GhostedVector      residual;
    FullMatrix<double> matrix;
  };



  void compare_cell(const std::string &kinematics)
  {
    headline("one cell, " + kinematics);

    // A distorted cell, its lower side on a circle.
    const Point<2> center(0.2, 3);
    const double   radius = 3;
    const auto     on_arc = [&](const double angle) {
      return center + radius * Point<2>(std::sin(angle), -std::cos(angle));
    };
    std::array<Point<2>, 8> X;
    X[0] = on_arc(-0.3);
    X[1] = on_arc(0.4);
    X[2] = Point<2>(1.1, 1.6);
    X[3] = Point<2>(-0.5, 1.2);
    X[4] = on_arc(0.05);
    for (unsigned int a = 1; a < 4; ++a)
      X[4 + a] = X[a] + 0.5 * (X[(a + 1) % 4] - X[a]);

    MeshText mesh;
    mesh.block("block", 1, 1, [&](const double s, const double t) {
      return t == 0 ? (s == 0 ? X[0] : X[1]) : (s == 0 ? X[3] : X[2]);
    });
    Parameters::All parameters =
      make_parameters(mesh, {"block"}, 2, kinematics, youngs_modulus, poisson);
    parameters.mesh.arcs["block bottom"] = {center[0], center[1], radius};
    const Bodies bodies(parameters);

    // The unknowns of the eight nodes, found by their places.
    const auto points     = bodies.support_points();
    const auto components = bodies.components();

    std::array<std::array<unsigned int, 2>, 8> dofs;
    unsigned int                               n_found = 0;
    for (unsigned int a = 0; a < 8; ++a)
      for (unsigned int i = 0; i < bodies.n_dofs(); ++i)
        if (points[i].distance(X[a]) < 1e-12)
          {
            dofs[a][components[i]] = i;
            ++n_found;
          }
    check("the nodes are where they should be", n_found == 16);

    Random                      random;
    GhostedVector               u(bodies.n_dofs());
    std::array<Tensor<1, 2>, 8> nodal;
    for (unsigned int a = 0; a < 8; ++a)
      for (unsigned int i = 0; i < 2; ++i)
        u[dofs[a][i]] = nodal[a][i] = random(-0.1, 0.1);
    bodies.discretization.distribute(bodies.discretization.constraints, u);

    DynamicSparsityPattern couplings(u.size(), u.size());
    bodies.elasticity->add_couplings(couplings);
    SparsityPattern pattern;
    pattern.copy_from(couplings);
    SparseMatrix<double> matrix(pattern);
    GhostedVector        rhs(u.size());
    bodies.elasticity->assemble(u, 1, rhs, &matrix);

    const Reference reference(X, nodal, kinematics == "large displacement");
    double          residual_error = 0, matrix_error = 0;
    for (unsigned int i = 0; i < 16; ++i)
      {
        const unsigned int row = dofs[i / 2][i % 2];
        residual_error =
          std::max(residual_error, std::abs(-rhs[row] - reference.residual[i]));
        for (unsigned int j = 0; j < 16; ++j)
          matrix_error = std::max(matrix_error,
                                  std::abs(matrix.el(row, dofs[j / 2][j % 2]) -
                                           reference.matrix(i, j)));
      }
    check_small("residual",
                residual_error / reference.residual.linfty_norm(),
                1e-12);
    check_small("stiffness",
                matrix_error / reference.matrix.linfty_norm(),
                1e-12);
  }



  void linear_displacement(const unsigned int degree,
                           const std::string &centre_node,
                           const std::string &kinematics)
  {
    headline("patch of degree " + std::to_string(degree) +
             (degree == 2 ? ", centre " + centre_node : "") + ", " +
             kinematics);

    // Quadrangles and two triangles, the lower side of the outer quadrangles
    // on a circle.
    Random         random;
    const Point<2> center(1.5, 5);
    const double   radius = 5;
    MeshText       mesh;
    mesh.block(
      "block",
      3,
      3,
      [&](const double s, const double t) {
        const bool   inside = t > 0 && t < 1 && s > 0 && s < 1;
        const double x = 3 * s, arc = 5 - std::sqrt(25 - std::pow(x - 1.5, 2));
        return Point<2>(x + (inside ? random(-0.2, 0.2) : 0),
                        arc + t * (3 - arc) + (inside ? random(-0.2, 0.2) : 0));
      },
      [](const unsigned int i, const unsigned int j) {
        return i == 1 && j == 1;
      });
    Parameters::All parameters           = make_parameters(mesh,
                                                 {"block"},
                                                 degree,
                                                 kinematics,
                                                 youngs_modulus,
                                                 poisson);
    parameters.element.centre_node       = centre_node;
    parameters.mesh.arcs["block bottom"] = {center[0], center[1], radius};
    const Bodies bodies(parameters);

    const auto test_motion =
      [&](const std::string &name, const Tensor<2, 2> &F, const bool is_rigid) {
        const GhostedVector u = bodies.displacement(
          [&](const Point<2> &X) { return Point<2>(0.3, -0.2) + F * X; });

        const GhostedVector    forces = bodies.elasticity->forces(u, 1);
        const auto             points = bodies.support_points();
        std::set<unsigned int> boundary;
        for (const std::string side : {"bottom", "right", "top", "left"})
          for (const auto &node : bodies.surface("block " + side).nodes)
            boundary.insert(node.dofs.begin(), node.dofs.end());
        double interior = 0;
        for (unsigned int i = 0; i < forces.size(); ++i)
          if (boundary.count(i) == 0)
            interior = std::max(interior, std::abs(forces[i]));

        const auto stresses = bodies.elasticity->stresses(u);
        const auto first    = stresses[0][0];
        double     scatter  = 0;
        for (const auto &cell : stresses)
          for (const auto &stress : cell)
            scatter = std::max(scatter, (stress - first).norm());
        check_small(name + ", forces inside over Young's modulus",
                    interior / youngs_modulus,
                    1e-13);
        check_small(name + ", scatter of the stress over Young's modulus",
                    scatter / youngs_modulus,
                    1e-13);
        if (is_rigid)
          check_small(name + ", stress over Young's modulus",
                      first.norm() / youngs_modulus,
                      1e-13);
        else
          std::cout << "  " << name << ", stress " << first[0][0] << ' '
                    << first[1][1] << ' ' << first[0][1] << ' ' << first[2][2]
                    << std::endl;
      };

    Tensor<2, 2> F;
    F[0][0] = 1.02;
    F[0][1] = 0.01;
    F[1][0] = 0.03;
    F[1][1] = 0.97;
    test_motion("strain", F, false);
    if (kinematics == "large displacement")
      test_motion("rotation", rotation(1.), true);
  }
} // namespace



int main()
{
  for (const std::string kinematics : {"small strain", "large displacement"})
    {
      compare_cell(kinematics);
      linear_displacement(1, "serendipity", kinematics);
      linear_displacement(2, "serendipity", kinematics);
      linear_displacement(2, "free", kinematics);
    }
  return 0;
}
