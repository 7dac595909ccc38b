// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A block of 24 x 6 mm, finer below its top. Lengths in mm, quadrangles.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o rail.msh rail.geo

SetFactory("OpenCASCADE");
Rectangle(1) = {0, -6, 0, 24, 6}; // its lines are 1 to 4: below, right, above, left
Transfinite Curve {1, 3} = 97;
Transfinite Curve {2} = 15 Using Progression 0.83;
Transfinite Curve {4} = 15 Using Progression 1 / 0.83;
Transfinite Surface {:};
Recombine Surface {:};

Physical Surface("Rail") = {1};
Physical Curve("Bottom") = {1};
Physical Curve("Top")    = {3};
Physical Point("End")    = {3};

Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
