// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A snap hook: a beam of 30 x 2 mm with a nose near its end. Lengths in mm,
// quadrangles.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o snap_hook.msh snap_hook.geo

Point(1) = {0, 0, 0};
Point(2) = {25, 0, 0};
Point(3) = {30, 0, 0};
Point(4) = {30, 2, 0};
Point(5) = {25, 2, 0};
Point(6) = {0, 2, 0};
Point(7) = {27.6, 3.5, 0};
Point(8) = {26.6, 3.5, 0};
Line(1)  = {1, 2};
Line(2)  = {2, 3};
Line(3)  = {3, 4};
Line(4)  = {4, 5};
Line(5)  = {5, 6};
Line(6)  = {6, 1};
Line(7)  = {2, 5};
Line(8)  = {4, 7};
Line(9)  = {7, 8};
Line(10) = {8, 5};
Curve Loop(1)    = {1, 7, 5, 6};
Plane Surface(1) = {1};
Curve Loop(2)    = {2, 3, 4, -7};
Plane Surface(2) = {2};
Curve Loop(3)    = {-4, 8, 9, 10};
Plane Surface(3) = {3};
Transfinite Curve {1, 5}    = 26;
Transfinite Curve {2, 4, 9} = 11;
Transfinite Curve {3, 6, 7} = 5;
Transfinite Curve {8, 10}   = 9;
Transfinite Surface {:};
Recombine Surface {:};

Physical Surface("Hook") = {1 : 3};
Physical Curve("Root")   = {6};
Physical Curve("Nose")   = {8 : 10};
Physical Point("Tip")    = {4};

Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
