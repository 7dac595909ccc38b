/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Small mesh files for the tests of the mesh.

#ifndef contact_tests_mesh_files_h
#define contact_tests_mesh_files_h

#include <fstream>
#include <string>

#include "mpi_session.h"
#include "parameters/parameters.h"

inline const std::string physical_names = R"($PhysicalNames
10
0 1 "P"
0 2 "Q"
0 3 "Pair"
0 4 "Centre"
1 5 "Bottom"
1 6 "Foot"
1 7 "Inside"
1 8 "The top"
2 9 "Lower"
2 10 "Upper"
$EndPhysicalNames
)";

// Two bodies, drawn with the numbers of the nodes. Nodes 4 and 7 lie at the
// same place. The quadrangle of the upper body is clockwise, and so is the
// triangle 2 6 3; node 11, somewhere else, belongs to no cell.
//
//    9---10
//    |    |
//    7----8
//
//    4----5----6
//    |    |  / |
//    |    |/   |
//    1----2----3
//
// The line 1-2 is in the groups Bottom and Foot, 2-5 is inside the lower body
// and in the groups Foot and Inside, 3-6 is in no group.
inline const std::string msh_22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Comments
a section nobody needs
$EndComments
)" + physical_names + R"($Nodes
11
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
7 0 1 0
8 1 1.5 0
9 0 2 0
10 1 2 0
11 5 5 0
$EndNodes
$Elements
17
1 15 2 1 1 4
2 15 2 2 2 7
3 15 2 3 3 1
4 15 2 3 4 3
5 15 2 4 5 11
6 1 2 5 1 1 2
7 1 2 6 1 1 2
8 1 2 5 1 2 3
9 1 2 6 2 2 5
10 1 2 7 2 2 5
11 1 2 8 3 5 4
12 1 2 8 3 5 6
13 1 2 0 4 3 6
14 3 2 9 1 1 2 5 4
15 2 2 9 1 2 6 3
16 2 2 9 1 2 6 5
17 3 2 10 2 7 9 10 8
$EndElements
)";

// The same in format 4.1: groups belong to entities, which have several.
inline const std::string msh_41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
)" + physical_names + R"($Entities
5 5 2 0
1 0 1 0 1 1
2 0 1 0 1 2
3 0 0 0 1 3
4 2 0 0 1 3
5 5 5 0 1 4
1 0 0 0 1 0 0 2 5 6 2 1 -2
2 1 0 0 2 0 0 1 5 2 2 -3
3 1 0 0 1 1 0 2 -6 7 2 1 -2
4 0 1 0 2 1 0 1 8 2 1 -2
5 2 0 0 2 1 0 0 2 1 -2
1 0 0 0 2 1 0 1 9 4 1 2 5 4
2 0 1 0 1 2 0 1 10 0
$EndEntities
$Nodes
3 11 1 11
2 1 0 6
1
2
3
4
5
6
0 0 0
1 0 0
2 0 0
0 1 0
1 1 0
2 1 0
2 2 1 4
7
8
9
10
0 1 0 0.1 0.1
1 1.5 0 0.1 0.1
0 2 0 0.1 0.1
1 2 0 0.1 0.1
0 5 0 1
11
5 5 0
$EndNodes
$Elements
13 15 1 15
0 1 15 1
1 4
0 2 15 1
2 7
0 3 15 1
3 1
0 4 15 1
4 3
0 5 15 1
5 11
1 1 1 1
6 1 2
1 2 1 1
7 2 3
1 3 1 1
8 2 5
1 4 1 2
9 5 4
10 5 6
1 5 1 1
11 3 6
2 1 3 1
12 1 2 5 4
2 1 2 2
13 2 6 3
14 2 6 5
2 2 3 1
15 7 9 10 8
$EndElements
)";



/// A mesh file of this content, and the parameters that name it.
inline Contact::Parameters::Mesh
parameters_for(const std::string &content, const unsigned int refinements = 0)
{
  std::ofstream("mesh.msh") << content;

  Contact::Parameters::Mesh parameters;
  parameters.file        = "mesh.msh";
  parameters.refinements = refinements;
  return parameters;
}

#endif
