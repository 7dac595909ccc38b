// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A hub on a shaft, rings about the axis x = 0 of which y >= 0 is meshed: x is
// the radius. Both are drawn with one radius. Lengths in mm, quadrangles.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o press_fit.msh press_fit.geo

SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 20, 30};  // its lines are 1 to 4: below, right, above, left
Rectangle(2) = {20, 0, 0, 15, 20}; // 5 to 8
Transfinite Curve {1, 3} = 9;
Transfinite Curve {2, 4} = 13;
Transfinite Curve {5, 7} = 8 Using Progression 1.15;
Transfinite Curve {6, 8} = 9;
Transfinite Surface {:};
Recombine Surface {:};

Physical Surface("Shaft")  = {1};
Physical Surface("Hub")    = {2};
Physical Curve("Middle")   = {1, 5};
Physical Curve("Journal")  = {2};
Physical Curve("Bore")     = {8};
Physical Point("Bore_mid") = {5};
Physical Point("Rim")      = {6};

Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
