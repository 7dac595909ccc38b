// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The square [0, 40] x [0, 40] of the GRECO benchmark of a block on a rigid
// plane, with nodes at the places A to E where its displacement is known; all
// quadrangles. Lengths in mm.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o square.msh square.geo

// Of hexahedra, beside the square, unless set before (square_extruded.geo).
DefineConstant[ layers = 0 ];
side = 40;
h = 1.25; // edge of the cells

x[] = {0, 1.25, 5, 7.5, 11.25, side};
For i In {0 : 5}
  Point(1 + i) = {x[i], 0, 0};
EndFor
Point(7) = {side, side, 0};
Point(8) = {0, side, 0};
For i In {1 : 5}
  Line(i) = {i, i + 1};
  Transfinite Curve {i} = Round((x[i] - x[i - 1]) / h) + 1;
EndFor
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 1};
Transfinite Curve {6, 7, 8} = Round(side / h) + 1;

Curve Loop(1) = {1 : 8};
Plane Surface(1) = {1};
Transfinite Surface {1} = {1, 6, 7, 8};
Recombine Surface {1};

Physical Point("A", 1) = {1};
Physical Point("B", 2) = {2};
Physical Point("C", 3) = {3};
Physical Point("D", 4) = {4};
Physical Point("E", 5) = {5};
Physical Point("S", 6) = {6};
If (layers == 0)
  Physical Curve("Bottom", 7) = {1 : 5};
  Physical Curve("Right", 8) = {6};
  Physical Curve("Top", 9) = {7};
  Physical Curve("Left", 10) = {8};
  Physical Surface("Block", 11) = {1};
Else
  s[] = Extrude {0, 0, layers * h} { Surface{1}; Layers{layers}; Recombine; };
  Physical Surface("Bottom", 7) = {s[{2 : 6}]};
  Physical Surface("Right", 8) = {s[7]};
  Physical Surface("Top", 9) = {s[8]};
  Physical Surface("Left", 10) = {s[9]};
  Physical Surface("Sides", 11) = {1, s[0]};
  Physical Volume("Block", 12) = {s[1]};
EndIf
