// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A bar: the rectangle 0 <= x <= 10, 0 <= y <= 100. Lengths in mm, first-order
// cells, all quadrangles and counter-clockwise; no free mesher takes part.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o bar.msh bar.geo

// ---------------------------------------------------------------- parameters

width  = 10;
height = 100;
nx     = 2;  // edges
ny     = 10;

// ----------------------------------------------------------------------- bar

Point(1) = {0, 0, 0};
Point(2) = {width, 0, 0};
Point(3) = {width, height, 0};
Point(4) = {0, height, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};

Transfinite Curve {1, 3} = nx + 1;
Transfinite Curve {2, 4} = ny + 1;

Curve Loop(1)    = {1:4};
Plane Surface(1) = {1};
Transfinite Surface {1};
Recombine Surface {1};

// ----------------------------------------------------------- physical groups

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Curve("Bottom", 1) = {1};
Physical Curve("Right", 2) = {2};
Physical Curve("Top", 3) = {3};
Physical Curve("Left", 4) = {4};

Physical Surface("Bar", 5) = {1};

Physical Point("Bottom_left", 6) = {1};
Physical Point("Bottom_right", 7) = {2};
Physical Point("Top_right", 8) = {3};
Physical Point("Top_left", 9) = {4};

// ------------------------------------------------------------------- options

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.SubdivisionAlgorithm = 0;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
