// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Three blocks [0, 20] x [0, 10], [10, 20] and [20, 30] on top of each other,
// which share no node and whose meshes do not match; all quadrangles. Lengths
// in mm.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o stack.msh stack.geo

width = 20;
height = 10;
nx[] = {5, 7, 4}; // edges along x
ny = 3;

For b In {0 : 2}
  p = 10 * (b + 1);
  Point(p + 1) = {0, b * height, 0};
  Point(p + 2) = {width, b * height, 0};
  Point(p + 3) = {width, (b + 1) * height, 0};
  Point(p + 4) = {0, (b + 1) * height, 0};
  Line(p + 1) = {p + 1, p + 2};
  Line(p + 2) = {p + 2, p + 3};
  Line(p + 3) = {p + 3, p + 4};
  Line(p + 4) = {p + 4, p + 1};
  Transfinite Curve {p + 1, p + 3} = nx[b] + 1;
  Transfinite Curve {p + 2, p + 4} = ny + 1;
  Curve Loop(p) = {p + 1, p + 2, p + 3, p + 4};
  Plane Surface(p) = {p};
  Transfinite Surface {p};
  Recombine Surface {p};
EndFor

Physical Point("Corner", 1) = {33};
Physical Curve("Axis", 2) = {14, 24, 34};
Physical Curve("Bottom_1", 3) = {11};
Physical Curve("Top_1", 4) = {13};
Physical Curve("Bottom_2", 5) = {21};
Physical Curve("Top_2", 6) = {23};
Physical Curve("Bottom_3", 7) = {31};
Physical Curve("Top_3", 8) = {33};
Physical Surface("One", 9) = {10};
Physical Surface("Two", 10) = {20};
Physical Surface("Three", 11) = {30};
