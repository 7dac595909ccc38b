/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that a group with lines of two bodies is refused against a group of
// one of these, as slave and as master, with the place of a line and the
// remedy; and that groups with several lines of a body are accepted against
// those of another one.

#include "base/errors.h"
#include "tests.h"

using namespace Tests;

namespace
{
  void refused(const std::string                  &slave,
               const std::string                  &master,
               const std::vector<Parameters::All> &scenes)
  {
    for (Parameters::All parameters : scenes)
      {
        parameters.contact.slave  = slave;
        parameters.contact.master = master;
        try
          {
            TwoBodies model(parameters);
            std::cout << "  accepted" << std::endl;
          }
        catch (const InputError &error)
          {
            std::cout << "  " << error.what() << std::endl;
          }
      }
  }



  // Lines of two bodies in one group.
  void own_lines()
  {
    headline("lines of one body in slave and master");
    std::ofstream("test.msh") << R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
6
1 1 "both"
1 2 "ground"
1 3 "sole"
1 4 "walls"
2 5 "A"
2 6 "B"
$EndPhysicalNames
$Nodes
12
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 1 0
6 1 1 0
7 1 2 0
8 0 2 0
9 2 0 0
10 3 0 0
11 3 1 0
12 2 1 0
$EndNodes
$Elements
10
1 1 2 1 1 1 2
2 1 2 1 1 5 6
3 1 2 2 1 3 4
4 1 2 3 1 5 6
5 1 2 4 1 3 4
6 1 2 4 1 11 12
7 3 2 5 1 1 2 3 4
8 3 2 6 1 5 6 7 8
9 3 2 5 1 9 10 11 12
10 1 2 3 1 7 8
$EndElements
)";
    Parameters::All parameters;
    parameters.mesh.file             = "test.msh";
    parameters.solids.kinematics     = Parameters::Strains::small;
    parameters.solids.youngs_modulus = {{"A", 1000}, {"B", 1000}};
    parameters.solids.poisson        = {{"A", 0.3}, {"B", 0.3}};
    refused("both", "ground", {parameters});
    refused("ground", "both", {parameters});
    refused("sole", "ground", {parameters});
    refused("sole", "walls", {parameters});
  }
} // namespace



int main()
{
  own_lines();
  return 0;
}
