// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A disk in a ring about the origin, as a coarse mesh to be refined by the
// program: the quarter x >= 0, y >= 0. Disk and ring touch on a circle and
// share no node; their edges do not match there. Lengths in mm, first-order
// cells, all quadrangles and counter-clockwise; no free mesher takes part.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o disk_in_ring.msh disk_in_ring.geo
//
// All arcs are about the origin: Inner_out: 0, 0, 50; Outer_in: 0, 0, 50;
// Outside: 0, 0, 100.

// ---------------------------------------------------------------- parameters

b      = 50;  // radius of the disk and of the contact
c      = 100; // outer radius of the ring
nDisk  = 2;   // edges on each side of the three blocks of the disk: 2 nDisk
              // edges around a quarter of it
nOuter = 5;   // edges around a quarter of the ring
mOuter = 3;   // layers of the ring
core   = 26;  // side of the core of the disk on the axes
corner = 22;  // both coordinates of its corner off the axes

// ---------------------------------------------------------------------- disk

// Three blocks: the core at the centre and two between it and the circle,
// which meet on the bisector.
Point(1) = {0, 0, 0};
Point(2) = {core, 0, 0};
Point(3) = {b, 0, 0};
Point(4) = {b * Cos(Pi / 4), b * Sin(Pi / 4), 0};
Point(5) = {0, b, 0};
Point(6) = {0, core, 0};
Point(7) = {corner, corner, 0};

Line(1)   = {1, 2};
Line(2)   = {2, 3};
Circle(3) = {3, 1, 4};
Circle(4) = {4, 1, 5};
Line(5)   = {5, 6};
Line(6)   = {6, 1};
Line(7)   = {2, 7};
Line(8)   = {4, 7};
Line(9)   = {6, 7};

Transfinite Curve {1:9} = nDisk + 1;

Curve Loop(1) = {1, 7, -9, 6};   // core
Curve Loop(2) = {2, 3, 8, -7};   // at the axis y = 0
Curve Loop(3) = {4, 5, 9, -8};   // at the axis x = 0

For s In {1:3}
  Plane Surface(s) = {s};
  Transfinite Surface {s};
  Recombine Surface {s};
EndFor

// ---------------------------------------------------------------------- ring

Point(21) = {b, 0, 0};
Point(22) = {c, 0, 0};
Point(23) = {0, c, 0};
Point(24) = {0, b, 0};

Line(21)   = {21, 22};
Circle(22) = {22, 1, 23};
Line(23)   = {24, 23};
Circle(24) = {21, 1, 24};

// The layers grow with the radius: all cells have the same shape.
growth = (c / b)^(1 / mOuter);
Transfinite Curve {21, 23} = mOuter + 1 Using Progression growth;
Transfinite Curve {22, 24} = nOuter + 1;

Curve Loop(20)    = {21, 22, -23, -24};
Plane Surface(20) = {20};
Transfinite Surface {20};
Recombine Surface {20};

// ----------------------------------------------------------- physical groups

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Curve("Axis_x", 1) = {1, 2, 21}; // y = 0, both bodies
Physical Curve("Axis_y", 2) = {5, 6, 23}; // x = 0, both bodies
Physical Curve("Inner_out", 4) = {3, 4};  // r = b of Inner
Physical Curve("Outer_in", 5) = {24};     // r = b of Outer
Physical Curve("Outside", 6) = {22};      // r = c

Physical Surface("Inner", 7) = {1, 2, 3};
Physical Surface("Outer", 8) = {20};

// ------------------------------------------------------------------- options

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.SubdivisionAlgorithm = 0;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
