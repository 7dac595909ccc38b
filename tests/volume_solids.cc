/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Bodies of hexahedra, of degree 1 and of degree 2 with 27 and with 20 nodes,
// at small strain and large displacement:
//  - rigid motions make no forces, a linear displacement of a distorted mesh
//    none inside of it;
//  - forces are the derivatives of the energy, the tangent those of the forces,
//    with the full and with the projected dilatation;
//  - one layer of cells held in z has the displacements of plane strain;
//  - the displacements of a thick cylinder under pressure converge with their
//    order to those of Lame, also next to incompressibility;
//  - loads in z, and reactions that balance them; hanging nodes.

#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

#include <cmath>

#include "solid/followers.h"
#include "solid/resultant.h"
#include "solid/strain_range.h"
#include "tests.h"
#include "volume_mesh.h"

using namespace Tests;

namespace
{
  struct Element
  {
    const char            *name;
    unsigned int           degree;
    Parameters::CentreNode centre;
  };

  const std::array<Element, 3> elements = {
    {{"8 nodes", 1, Parameters::CentreNode::serendipity},
     {"27 nodes", 2, Parameters::CentreNode::free},
     {"20 nodes", 2, Parameters::CentreNode::serendipity}}};



  Parameters::All make_parameters(const VolumeText  &mesh,
                                  const Element     &element,
                                  const std::string &kinematics,
                                  const double       poisson    = 0.3,
                                  const std::string &dilatation = "automatic")
  {
    mesh.write("volume.msh");
    Parameters::All parameters;
    parameters.mesh.file                     = "volume.msh";
    parameters.element.degree                = element.degree;
    parameters.element.centre_node           = element.centre;
    parameters.solids.kinematics             = kinematics;
    parameters.solids.dilatation             = dilatation;
    parameters.solids.youngs_modulus["Body"] = 1000;
    parameters.solids.poisson["Body"]        = poisson;
    return parameters;
  }



  // A box whose inner node planes are bent: faces stay plane, cells do not.
  VolumeText distorted()
  {
    VolumeText text;
    text.block("Body", {{2, 2, 2}}, [](const Point<3> &s) {
      const double bump =
        64 * s[0] * (1 - s[0]) * s[1] * (1 - s[1]) * s[2] * (1 - s[2]);
      return Point<3>(2 * s[0] + 0.2 * bump,
                      s[1] + 0.1 * bump,
                      1.5 * s[2] - 0.15 * bump);
    });
    return text;
  }



  Tensor<2, 3> any_rotation()
  {
    const double x = 0.7, y = -0.4;
    Tensor<2, 3> A({{1, 0, 0},
                    {0, std::cos(x), -std::sin(x)},
                    {0, std::sin(x), std::cos(x)}});
    Tensor<2, 3> B({{std::cos(y), 0, std::sin(y)},
                    {0, 1, 0},
                    {-std::sin(y), 0, std::cos(y)}});
    return A * B;
  }



  Tensor<2, 3> any_gradient()
  {
    return Tensor<2, 3>(
      {{0.05, 0.02, -0.03}, {0.01, -0.04, 0.06}, {0.02, 0.03, 0.07}});
  }



  /// The largest force on an unknown inside, by the largest of all.
  double largest_inside(const BodiesIn<3> &bodies, const GhostedVector &u)
  {
    GhostedVector forces = bodies.elasticity->forces(u, 0);
    hand_over_from_followers(bodies.discretization, forces);
    const IndexSet boundary =
      DoFTools::extract_boundary_dofs(bodies.discretization.dof_handler);
    double inside = 0;
    for (unsigned int i = 0; i < forces.size(); ++i)
      if (!boundary.is_element(i))
        inside = std::max(inside, std::abs(forces[i]));
    return inside / forces.linfty_norm();
  }



  void motions()
  {
    headline("Rigid and homogeneous motions");
    for (const Element &element : elements)
      for (const std::string kinematics :
           {"small strain", "large displacement"})
        {
          const BodiesIn<3> bodies(
            make_parameters(distorted(), element, kinematics));
          const bool   is_small = kinematics == "small strain";
          Tensor<2, 3> spin;
          spin[0][1] = spin[1][2] = 0.3;
          spin[1][0] = spin[2][1] = -0.3;
          const auto rigid        = bodies.displacement([&](const Point<3> &X) {
            return Point<3>(is_small ? X + spin * X : any_rotation() * X) +
                   Tensor<1, 3>({0.5, -1, 2});
          });
          const auto linear       = bodies.displacement(
            [&](const Point<3> &X) { return X + any_gradient() * X; });
          const double scale =
            bodies.elasticity->forces(linear, 0).linfty_norm();
          std::cout << element.name << ", " << kinematics << std::endl;
          check_small("rigid motion, its force",
                      bodies.elasticity->forces(rigid, 0).linfty_norm() / scale,
                      1e-12);
          check_small("linear displacement, the force inside",
                      largest_inside(bodies, linear),
                      1e-12);
          if (!is_small)
            check_small("angle of the rotation",
                        std::abs(
                          strain_range(bodies.discretization, rigid).rotation -
                          std::acos((trace(any_rotation()) - 1) / 2)),
                        1e-12);
        }
  }



  void derivatives()
  {
    headline("Energy, forces and tangent");
    for (const Element &element : elements)
      for (const std::string kinematics :
           {"small strain", "large displacement"})
        for (const std::string dilatation : {"full", "B-bar"})
          {
            const BodiesIn<3>    bodies(make_parameters(distorted(),
                                                     element,
                                                     kinematics,
                                                     0.45,
                                                     dilatation));
            const Elasticity<3> &elasticity = *bodies.elasticity;
            Random               random;
            GhostedVector        u(bodies.n_dofs()), v(u.size());
            for (unsigned int i = 0; i < u.size(); ++i)
              {
                u[i] = random(-0.05, 0.05);
                v[i] = random(-1, 1);
              }
            bodies.discretization.distribute(bodies.discretization.constraints,
                                             u);
            bodies.discretization.distribute(bodies.discretization.constraints,
                                             v);
            const double step    = 1e-5;
            const auto   shifted = [&](const double t) {
              GhostedVector w = u;
              w.add(t, v);
              return w;
            };

            const double work  = elasticity.forces(u, 0) * v;
            const double slope = (elasticity.strain_energy(shifted(step)) -
                                  elasticity.strain_energy(shifted(-step))) /
                                 (2 * step);
            GhostedVector product(u.size());
            elasticity.visit_cells(
              u,
              true,
              [&](const std::vector<types::global_dof_index> &dofs,
                  const FullMatrix<double>                   &tangent,
                  const Vector<double> &) {
                for (unsigned int i = 0; i < dofs.size(); ++i)
                  for (unsigned int j = 0; j < dofs.size(); ++j)
                    product[dofs[i]] += tangent(i, j) * v[dofs[j]];
              });
            GhostedVector difference = elasticity.forces(shifted(step), 0);
            difference -= elasticity.forces(shifted(-step), 0);
            difference /= 2 * step;
            difference -= product;
            std::cout << element.name << ", " << kinematics << ", "
                      << dilatation << std::endl;
            check_small("energy", std::abs(slope / work - 1), 1e-7);
            check_small("tangent",
                        difference.l2_norm() / product.l2_norm(),
                        1e-8);
          }
  }



  /// The displacements in small strain, from rest, under the whole load.
  template<int dim>
  GhostedVector solve(BodiesIn<dim> &bodies)
  {
    Discretization<dim> &discretization = bodies.discretization;
    const unsigned int   n              = bodies.n_dofs();
    discretization.constrain_update(GhostedVector(n), 1);
    DynamicSparsityPattern couplings(n, n);
    bodies.elasticity->add_couplings(couplings);
    for (unsigned int i = 0; i < n; ++i)
      couplings.add(i, i);
    SparsityPattern pattern;
    pattern.copy_from(couplings);
    SparseMatrix<double> matrix(pattern);
    GhostedVector        u(n);
    bodies.elasticity->assemble(GhostedVector(n), 1, u, &matrix);
    for (const auto &line : discretization.constraints.get_lines())
      matrix.diag_element(line.index) = 1;
    SparseDirectUMFPACK().solve(matrix, u);
    discretization.distribute(discretization.constraints, u);
    return u;
  }



  // The same distorted mesh in 2-D, and as a layer held in z.
  void plane_strain()
  {
    headline("A layer held in z");
    const auto chart = [](const Point<2> &s) {
      const double bump = 16 * s[0] * (1 - s[0]) * s[1] * (1 - s[1]);
      return Point<2>(2 * s[0] + 0.1 * bump, s[1] * (1 + 0.2 * s[0]));
    };
    for (const Element &element : elements)
      {
        MeshText flat;
        flat.block("Body", 3, 2, [&](const double s, const double t) {
          return chart({s, t});
        });
        VolumeText layer;
        layer.block("Body", {{3, 2, 1}}, [&](const Point<3> &s) {
          const Point<2> p = chart({s[0], s[1]});
          return Point<3>(p[0], p[1], 0.5 * s[2]);
        });

        Parameters::All plane     = Tests::make_parameters(flat,
                                                       {"Body"},
                                                       element.degree,
                                                       "small strain");
        plane.element.centre_node = element.centre;
        Parameters::All space = make_parameters(layer, element, "small strain");
        plane.boundary.displacement[0] = {{"Body left", 0}};
        plane.boundary.displacement[1] = {{"Body bottom", 0}};
        plane.boundary.traction[0]     = {{"Body right", "3 + y"}};
        plane.boundary.pressure        = {{"Body top", "2*x"}};
        space.boundary.displacement[0] = {{"Body left", 0}};
        space.boundary.displacement[1] = {{"Body front", 0}};
        space.boundary.displacement[2] = {{"Body bottom", 0}, {"Body top", 0}};
        space.boundary.traction[0]     = plane.boundary.traction[0];
        space.boundary.pressure        = {{"Body back", "2*x"}};

        Bodies      in_plane(plane);
        BodiesIn<3> in_space(space);
        const auto  u = solve(in_plane), w = solve(in_space);
        const auto  X = in_plane.support_points();
        const auto  Y = in_space.support_points();
        const auto  c = in_plane.components(), d = in_space.components();
        double      largest = 0;
        for (unsigned int i = 0; i < u.size(); ++i)
          for (unsigned int j = 0; j < w.size(); ++j)
            if (c[i] == d[j] &&
                std::hypot(X[i][0] - Y[j][0], X[i][1] - Y[j][1]) < 1e-9)
              largest = std::max(largest, std::abs(u[i] - w[j]));
        std::cout << element.name << std::endl;
        check_small("largest difference of displacements",
                    largest / u.linfty_norm(),
                    1e-12);
      }
  }



  // A quarter of a tube of radii a and b under the pressure p inside, held in
  // z: u_r = p a^2 (1 + nu) / (E (b^2 - a^2)) ((1 - 2 nu) r + b^2/r).
  void lame()
  {
    headline("Thick cylinder under pressure");
    const double a = 1, b = 2, p = 3, E = 1000;
    for (const Element &element : elements)
      for (const double nu : {0.3, 0.4999})
        {
          std::array<double, 3> errors;
          for (unsigned int r = 0; r < 3; ++r)
            {
              VolumeText text;
              text.block("Body", {{2, 3, 1}}, [=](const Point<3> &s) {
                const double radius = a + s[0] * (b - a);
                const double angle  = s[1] * numbers::PI / 2;
                return Point<3>(radius * std::cos(angle),
                                radius * std::sin(angle),
                                s[2]);
              });
              Parameters::All parameters =
                make_parameters(text, element, "small strain", nu);
              parameters.mesh.refinements = r;
              parameters.mesh.cylinders = {{"Body left", {0, 0, 0, 0, 0, 1, a}},
                                           {"Body right",
                                            {0, 0, 0, 0, 0, 1, b}}};
              parameters.boundary.displacement = {
                {{{"Body back", 0}},
                 {{"Body front", 0}},
                 {{"Body bottom", 0}, {"Body top", 0}}}};
              parameters.boundary.pressure = {
                {"Body left", Utilities::to_string(p)}};
              BodiesIn<3> bodies(parameters);
              const auto  u  = solve(bodies);
              const auto  X  = bodies.support_points();
              const auto  c  = bodies.components();
              errors[r]      = 0;
              double largest = 0;
              for (unsigned int i = 0; i < u.size(); ++i)
                if (c[i] < 2)
                  {
                    const double radius = std::hypot(X[i][0], X[i][1]);
                    const double exact =
                      p * a * a * (1 + nu) / (E * (b * b - a * a)) *
                      ((1 - 2 * nu) * radius + b * b / radius) * X[i][c[i]] /
                      radius;
                    errors[r] = std::max(errors[r], std::abs(u[i] - exact));
                    largest   = std::max(largest, std::abs(exact));
                  }
              errors[r] /= largest;
            }
          const double order = std::log2(errors[1] / errors[2]);
          std::cout << element.name << ", nu = " << nu << std::endl;
          check_small("error of the displacement",
                      errors[2],
                      element.degree == 1 ? 5e-3 : 1e-4);
          check("order at least p + 0.7", order > element.degree + 0.7);
        }
  }



  // Forces in z by point, area and volume, and what the support bears; the same
  // with cells of two sizes.
  void loads()
  {
    headline("Loads and reactions");
    for (const Element &element : elements)
      for (const bool hangs : {false, true})
        {
          VolumeText text;
          text.block("Body", {{2, 2, 2}}, box({0, 0, 0}, {2, 1, 1}));
          Parameters::All parameters =
            make_parameters(text, element, "small strain");
          for (auto &support : parameters.boundary.displacement)
            support = {{"Body left", 0}};
          parameters.boundary.resultant_force[2] = {{"Body right", 7}};
          parameters.boundary.traction[1]        = {{"Body top", "z + 1"}};
          parameters.boundary.body_force[2]      = {{"Body", "-x"}};
          BodiesIn<3> bodies(parameters);
          if (hangs)
            {
              bodies.mesh.triangulation.begin_active()->set_refine_flag();
              bodies.mesh.triangulation.execute_coarsening_and_refinement();
              bodies.discretization.redistribute();
              bodies.elasticity =
                std::make_unique<Elasticity<3>>(bodies.discretization,
                                                parameters.solids);
            }
          const auto u        = solve(bodies);
          const auto reaction = [&](const unsigned int c) {
            return Resultant<3>(*bodies.elasticity,
                                bodies.discretization,
                                bodies.mesh.boundary("Body left", "test"),
                                c,
                                /*of_supports=*/true)
              .value(u, 1);
          };
          std::cout << element.name
                    << (hangs ? ", hanging nodes" : ", even mesh") << std::endl;
          check_small("x", std::abs(reaction(0)), 1e-11);
          check_small("y", std::abs(reaction(1) + 4), 1e-11);
          check_small("z", std::abs(reaction(2) + 7 - 2), 1e-11);
        }
  }
} // namespace



int main()
{
  motions();
  derivatives();
  plane_strain();
  lame();
  loads();
  return 0;
}
