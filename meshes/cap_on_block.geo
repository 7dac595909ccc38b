// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A quarter of a block with a spherical bottom on a quarter of a block with a
// plane top, in space: what is left of a sphere on a foundation once the
// symmetry planes x = 0 and y = 0 and all that is far away are cut off. The
// bodies touch at the origin B and share no node; their cells do not match.
// Lengths in mm, transfinite hexahedra with 8 nodes; few of them, for the
// program refines them (parameters/nested_space.prm).
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -3 -format msh41 -o cap_on_block.msh cap_on_block.geo
//
// The bottom is part of a sphere: Bottom: 0, 0, 20, 20.

// ---------------------------------------------------------------- parameters

R = 20; // radius of the sphere
a = 6;  // side of the upper block
H = 6;  // its height
b = 8;  // side of the foundation
F = 8;  // its height

DefineConstant[ nUp = 3 ];  // cells along each edge of the upper block
DefineConstant[ nLow = 4 ]; // and of the foundation

// --------------------------------------------------------------- upper block

Point(1) = {0, 0, 0};
Point(2) = {a, 0, R - Sqrt(R^2 - a^2)};
Point(3) = {a, a, R - Sqrt(R^2 - 2 * a^2)};
Point(4) = {0, a, R - Sqrt(R^2 - a^2)};
Point(5) = {0, 0, R}; // centre of the sphere, and of the sections x = 0, y = 0
Point(6) = {a, 0, R}; // centre of the section x = a
Point(7) = {0, a, R}; // and of y = a
Circle(1) = {1, 5, 2};
Circle(2) = {2, 6, 3};
Circle(3) = {3, 7, 4};
Circle(4) = {4, 5, 1};
Curve Loop(1) = {1, 2, 3, 4};
Surface(1) = {1} In Sphere {5};

Point(11) = {0, 0, H};
Point(12) = {a, 0, H};
Point(13) = {a, a, H};
Point(14) = {0, a, H};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(13) = {13, 14};
Line(14) = {14, 11};
Line(21) = {1, 11};
Line(22) = {2, 12};
Line(23) = {3, 13};
Line(24) = {4, 14};
Curve Loop(2) = {11, 12, 13, 14};
Curve Loop(3) = {1, 22, -11, -21};
Curve Loop(4) = {2, 23, -12, -22};
Curve Loop(5) = {3, 24, -13, -23};
Curve Loop(6) = {4, 21, -14, -24};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Plane Surface(4) = {4};
Plane Surface(5) = {5};
Plane Surface(6) = {6};
Surface Loop(1) = {1:6};
Volume(1) = {1};
Transfinite Curve {1:4, 11:14, 21:24} = nUp + 1;

// ---------------------------------------------------------------- foundation

Point(31) = {0, 0, 0};
Point(32) = {b, 0, 0};
Point(33) = {b, b, 0};
Point(34) = {0, b, 0};
Point(41) = {0, 0, -F};
Point(42) = {b, 0, -F};
Point(43) = {b, b, -F};
Point(44) = {0, b, -F};
Line(31) = {31, 32};
Line(32) = {32, 33};
Line(33) = {33, 34};
Line(34) = {34, 31};
Line(41) = {41, 42};
Line(42) = {42, 43};
Line(43) = {43, 44};
Line(44) = {44, 41};
Line(51) = {31, 41};
Line(52) = {32, 42};
Line(53) = {33, 43};
Line(54) = {34, 44};
Curve Loop(11) = {31, 32, 33, 34};
Curve Loop(12) = {41, 42, 43, 44};
Curve Loop(13) = {31, 52, -41, -51};
Curve Loop(14) = {32, 53, -42, -52};
Curve Loop(15) = {33, 54, -43, -53};
Curve Loop(16) = {34, 51, -44, -54};
Plane Surface(11) = {11};
Plane Surface(12) = {12};
Plane Surface(13) = {13};
Plane Surface(14) = {14};
Plane Surface(15) = {15};
Plane Surface(16) = {16};
Surface Loop(2) = {11:16};
Volume(2) = {2};
Transfinite Curve {31:34, 41:44, 51:54} = nLow + 1;

Transfinite Surface {1:6, 11:16};
Recombine Surface {1:6, 11:16};
Transfinite Volume {1, 2};

// ----------------------------------------------------------- physical groups

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Volume("Sphere", 1) = {1};
Physical Volume("Foundation", 2) = {2};
Physical Surface("Bottom", 3) = {1};
Physical Surface("Head", 4) = {2};
Physical Surface("Top", 5) = {11};
Physical Surface("Base", 6) = {12};
Physical Surface("Plane_x", 7) = {6, 16}; // x = 0
Physical Surface("Plane_y", 8) = {3, 13}; // y = 0
Physical Point("B", 9) = {31};
Physical Point("C", 10) = {1};

// ------------------------------------------------------------------- options

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
