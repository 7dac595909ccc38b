/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Cells of distorted quadrangles and hexahedra with incompatible modes, in
// 2-D, of rings and in 3-D, in small strain and large displacement:
//  - a linear displacement has the uniform stress of the material, and no
//    forces inside (patch test);
//  - forces are the derivative of the energy, and the tangent that of the
//    forces;
//  - what is stored is the work of the forces, in increments of any size.

#include "derivatives.h"
#include "volume_mesh.h"

using namespace Tests;

namespace
{
  Parameters::All plane()
  {
    MeshText mesh;
    mesh.block("Body", 3, 3, [](const double s, const double t) {
      const double bump = s * (1 - s) * t * (1 - t);
      return Point<2>(1 + 2 * s + 2 * bump, 2 * t - 0.2 * s - 1.5 * bump);
    });
    return make_parameters(mesh, {"Body"}, 1, "small strain", 1000, 0.4);
  }



  Parameters::All space()
  {
    VolumeText text;
    text.block("Body", {{2, 2, 2}}, [](const Point<3> &s) {
      const double bump =
        s[0] * (1 - s[0]) * s[1] * (1 - s[1]) * s[2] * (1 - s[2]);
      return Point<3>(s[0] + 0.1 * s[1] * s[2] + 8 * bump,
                      s[1] - 0.1 * s[0] - 6 * bump,
                      2 * s[2] + 10 * bump);
    });
    text.write("volume.msh");
    Parameters::All parameters = plane();
    parameters.mesh.file       = "volume.msh";
    return parameters;
  }



  /// Of rings stretched evenly along r, and along the axis.
  template<int dim>
  void patch_test(const BodiesIn<dim> &bodies)
  {
    const bool     rings = bodies.discretization.axisymmetric;
    Tensor<2, dim> H;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        H[i][j] = rings && i != j ? 0. : 0.01 * (1 + i) - 0.03 * j;
    GhostedVector u(bodies.n_dofs());
    const auto    X = bodies.support_points();
    const auto    c = bodies.components();
    for (unsigned int i = 0; i < u.size(); ++i)
      u[i] = H[c[i]] * X[i];

    const auto stresses = bodies.elasticity->stresses(u);
    const auto first    = stresses[0][0];
    double     scatter  = 0;
    for (const auto &of_cell : stresses)
      for (const auto &stress : of_cell)
        scatter = std::max(scatter, (stress - first).norm());
    check_small("uniform stress", scatter / first.norm(), 1e-13);

    // Of a linear material Hooke's law, of which that of rings has the hoops.
    if (bodies.elasticity->is_linear())
      {
        SymmetricTensor<2, 3> strain;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            strain[i][j] = (H[i][j] + H[j][i]) / 2;
        if (rings)
          strain[2][2] = H[0][0];
        const Material material(1000, 0.4);
        check_small("Hooke's law",
                    (first - material.stress(strain)).norm() / first.norm(),
                    1e-13);
      }

    // Inside are the nodes that no face of the boundary has.
    std::set<types::global_dof_index>    outside;
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell :
         bodies.discretization.dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->at_boundary(f))
          {
            dofs.resize(cell->get_fe().n_dofs_per_face(f));
            cell->face(f)->get_dof_indices(dofs);
            outside.insert(dofs.begin(), dofs.end());
          }
    const GhostedVector forces = bodies.elasticity->forces(u, 0);
    double              inside = 0;
    for (unsigned int i = 0; i < u.size(); ++i)
      if (outside.count(i) == 0)
        inside = std::max(inside, std::abs(forces[i]));
    check_small("forces inside", inside / forces.linfty_norm(), 1e-13);
  }



  template<int dim>
  void check_bodies(const std::string &what, Parameters::All parameters)
  {
    parameters.solids.incompatible_modes = {"Body"};
    for (const std::string kinematics : {"small strain", "large displacement"})
      {
        headline(what + ", " + kinematics);
        parameters.solids.kinematics = kinematics;
        parameters.check();
        const BodiesIn<dim> bodies(parameters);
        const auto         &elasticity = *bodies.elasticity;
        const auto          energy     = [&](const GhostedVector &u) {
          return elasticity.strain_energy(u);
        };
        patch_test(bodies);

        static Random random;
        const auto    any = [&]() {
          GhostedVector u(bodies.n_dofs());
          for (double &value : u)
            value = random(-0.1, 0.1);
          return u;
        };
        const GhostedVector u_0 = any(), u_1 = any();
        const auto found = compare_with_differences(bodies, u_1, energy);
        check_small("forces against differences of the energy",
                    found.forces,
                    1e-8);
        check_small("tangent against those of the forces", found.tangent, 1e-7);
        check_small("asymmetry", found.asymmetry, 1e-13);
        check("linear in small strain",
              elasticity.is_linear() == (kinematics == "small strain"));

        GhostedVector mean = elasticity.forces(u_0, 0), d = u_1;
        mean += elasticity.forces(u_1, 0);
        d -= u_0;
        check_small("balance of the energy",
                    std::abs(energy(u_1) - energy(u_0) - 0.5 * (mean * d) -
                             elasticity.works(u_0, u_1).path) /
                      energy(u_1),
                    1e-12);
      }
  }
} // namespace



int main()
{
  check_bodies<2>("plane strain", plane());
  Parameters::All rings = plane();
  rings.solids.symmetry = "axisymmetric";
  check_bodies<2>("rings", rings);
  check_bodies<3>("space", space());
  return 0;
}
