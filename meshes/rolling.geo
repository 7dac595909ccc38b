// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A block that a roller is driven over, along x = 0 to 10: cells of 1/12 mm where
// it passes, growing by a quarter from one to the next away from there; all
// quadrangles. Lengths in mm.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o rolling.msh rolling.geo

h = 1. / 12;
growth = 1.25;
depth = 40;
wings = 20; // cells beside the way, and below
x[] = {-1.5 - depth, -1.5, 12, 12 + depth};
n[] = {wings, Round(13.5 / h), wings};

For i In {0 : 3}
  Point(1 + i) = {x[i], 0, 0};
  Point(5 + i) = {x[i], -depth, 0};
  Line(1 + i) = {1 + i, 5 + i};
  Transfinite Curve {1 + i} = wings + 1 Using Progression growth;
EndFor
For i In {0 : 2}
  Line(11 + i) = {1 + i, 2 + i};
  Line(21 + i) = {5 + i, 6 + i};
  p = i == 0 ? 1 / growth : i == 1 ? 1 : growth;
  Transfinite Curve {11 + i, 21 + i} = n[i] + 1 Using Progression p;
  Curve Loop(1 + i) = {1 + i, 21 + i, -(2 + i), -(11 + i)};
  Plane Surface(1 + i) = {1 + i};
  Transfinite Surface {1 + i} = {1 + i, 5 + i, 6 + i, 2 + i};
  Recombine Surface {1 + i};
EndFor

Physical Curve("Top", 1) = {11 : 13};
Physical Curve("Bottom", 2) = {21 : 23};
Physical Surface("Block", 3) = {1 : 3};
