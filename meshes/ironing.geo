// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A block of 120 x 12 mm, with cells of 1 mm along its top, flatter there than
// below. Lengths in mm, quadrangles.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o ironing.msh ironing.geo

SetFactory("OpenCASCADE");
Rectangle(1) = {0, -12, 0, 120, 12}; // its lines are 1 to 4: below, right, above, left
Transfinite Curve {1, 3} = 121;
Transfinite Curve {2} = 9 Using Progression 0.85;
Transfinite Curve {4} = 9 Using Progression 1 / 0.85;
Transfinite Surface {:};
Recombine Surface {:};

Physical Surface("Block") = {1};
Physical Curve("Bottom") = {1};
Physical Curve("Top")    = {3};

Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
