// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A slice of a thick tube, the section x >= 0 of which is meshed: x is the
// radius, y the axis. Lengths in mm, quadrangles.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o tube.msh tube.geo

a      = 100; // bore
b      = 200;
height = 10;
layers = 10;

Point(1) = {a, 0, 0};
Point(2) = {b, 0, 0};
Point(3) = {b, height, 0};
Point(4) = {a, height, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {4, 3};
Line(4) = {1, 4};
Transfinite Curve {1, 3} = layers + 1;
Transfinite Curve {2, 4} = 2;
Curve Loop(1)    = {1, 2, -3, -4};
Plane Surface(1) = {1};
Transfinite Surface {1};
Recombine Surface {1};

Physical Curve("Ends", 1)    = {1, 3};
Physical Curve("Bore", 2)    = {4};
Physical Curve("Outside", 3) = {2};
Physical Surface("Tube", 4)  = {1};
Physical Point("Bore_x", 5)    = {1};
Physical Point("Outside_x", 6) = {2};

Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
