// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The section of a round seal of diameter 5 mm; its surface has four parts.
// Lengths in mm, quadrangles.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o seal.msh seal.geo

r = 2.5;
i = 1.1; // of the core
n = 9;   // nodes on a quarter

For k In {0 : 3}
  a = Pi / 4 + k * Pi / 2;
  Point(1 + k) = {r * Cos(a), r * Sin(a), 0};
  Point(5 + k) = {i * Cos(a), i * Sin(a), 0};
EndFor
Point(9) = {0, 0, 0};
For k In {0 : 3}
  next = (k + 1) % 4;
  Circle(1 + k) = {1 + k, 9, 1 + next}; // above, left, below, right
  Line(5 + k)   = {5 + k, 5 + next};
  Line(9 + k)   = {5 + k, 1 + k};
EndFor
For k In {0 : 3}
  next = (k + 1) % 4;
  Curve Loop(1 + k)    = {5 + k, 9 + next, -(1 + k), -(9 + k)};
  Plane Surface(1 + k) = {1 + k};
EndFor
Curve Loop(5)    = {5, 6, 7, 8};
Plane Surface(5) = {5};
Transfinite Curve {1 : 8}  = n;
Transfinite Curve {9 : 12} = 6;
Transfinite Surface {:};
Recombine Surface {:};

Physical Surface("Seal")  = {1 : 5};
Physical Curve("Skin")    = {1 : 4};
Physical Curve("Wetted")  = {2};
Physical Point("Top")     = {1};

Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
