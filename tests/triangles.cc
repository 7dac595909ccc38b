/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that it does not matter which corner of a triangle comes first: its
// strain energy at large displacements, where no rule is exact, is the same.

#include "tests.h"

using namespace Tests;

namespace
{
  double energy(const unsigned int degree, const std::string &corners)
  {
    std::ofstream("test.msh") << R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
1
2 1 "body"
$EndPhysicalNames
$Nodes
3
1 0 0 0
2 1.3 0.2 0
3 0.4 0.9 0
$EndNodes
$Elements
1
1 2 2 1 1 )" << corners << "\n$EndElements\n";
    Parameters::All parameters;
    parameters.mesh.file             = "test.msh";
    parameters.element.degree        = degree;
    parameters.solids.kinematics     = Parameters::Strains::large;
    parameters.solids.youngs_modulus = {{"body", 1000}};
    parameters.solids.poisson        = {{"body", 0.3}};
    const Bodies bodies(parameters);
    return bodies.elasticity->strain_energy(
      bodies.displacement([](const Point<2> &X) {
        return X + Point<2>(0.3 * X[0] * X[1], 0.2 * X[0] * X[0] - 0.1 * X[1]);
      }));
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    {
      headline("degree " + std::to_string(degree));
      const double first = energy(degree, "1 2 3");
      for (const std::string corners : {"2 3 1", "3 1 2", "1 3 2"})
        check_small("strain energy of the corners " + corners,
                    std::abs(energy(degree, corners) / first - 1),
                    1e-12);
    }
  return 0;
}
