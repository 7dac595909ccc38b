// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A pin in the hole of a square plate, of the same radius or smaller by `play`:
// the right half. They share no node, and the edges do not match. Lengths in mm.
//
// Made for gmsh 4.8.4; parameters/hard/meshes.sh writes the meshes.

DefineConstant[ play = 0 ]; // radius of the hole minus that of the pin

R      = 10; // radius of the hole
side   = 30; // half the side of the plate
nPin   = 7;  // edges on an eighth of the pin's circle, and around its core
nHole  = 6;  // and of the hole
layers = 4;
core   = 4.5;

// The pin: a core and a ring of four blocks. It rests on the hole's bottom.
r = R - play;
z = -play;
Point(1) = {0, z, 0};
For i In {0:4}
  a = -Pi / 2 + i * Pi / 4;
  Point(10 + i) = {r * Cos(a), z + r * Sin(a), 0};
EndFor
Point(20) = {0, z - core, 0};
Point(21) = {core * 0.85, z - core * 0.85, 0};
Point(22) = {core, z, 0};
Point(23) = {core * 0.85, z + core * 0.85, 0};
Point(24) = {0, z + core, 0};
For i In {0:3}
  Circle(10 + i) = {10 + i, 1, 11 + i};
  Line(20 + i) = {20 + i, 21 + i};
EndFor
For i In {0:4}
  Line(30 + i) = {20 + i, 10 + i};
EndFor
Line(40) = {20, 1};
Line(41) = {1, 24};
Line(42) = {1, 22};
For i In {0:3}
  Curve Loop(10 + i) = {30 + i, 10 + i, -(31 + i), -(20 + i)};
  Plane Surface(10 + i) = {10 + i};
EndFor
Curve Loop(20) = {20, 21, -42, -40};
Plane Surface(20) = {20};
Curve Loop(21) = {22, 23, -41, 42};
Plane Surface(21) = {21};
Transfinite Curve {10:13, 20:23, 40, 41, 42} = nPin + 1;
Transfinite Curve {30:34} = 3;

// The plate
Point(2) = {0, 0, 0};
For i In {0:4}
  a = -Pi / 2 + i * Pi / 4;
  Point(50 + i) = {R * Cos(a), R * Sin(a), 0};
EndFor
Point(60) = {0, -side, 0};
Point(61) = {side, -side, 0};
Point(62) = {side, 0, 0};
Point(63) = {side, side, 0};
Point(64) = {0, side, 0};
For i In {0:3}
  Circle(50 + i) = {50 + i, 2, 51 + i};
  Line(60 + i) = {60 + i, 61 + i};
EndFor
For i In {0:4}
  Line(70 + i) = {50 + i, 60 + i};
EndFor
For i In {0:3}
  Curve Loop(50 + i) = {70 + i, 60 + i, -(71 + i), -(50 + i)};
  Plane Surface(50 + i) = {50 + i};
EndFor
Transfinite Curve {50:53, 60:63} = nHole + 1;
Transfinite Curve {70:74} = layers + 1 Using Progression 1.3;

Transfinite Surface {10:13, 20, 21, 50:53};
Recombine Surface {10:13, 20, 21, 50:53};

Physical Point("P_bottom", 1) = {10};
Physical Point("P_centre", 2) = {1};
Physical Point("P_top", 3) = {14};
Physical Curve("Pin_out", 11) = {10:13};
Physical Curve("Hole", 12) = {50:53};
Physical Curve("Axis", 13) = {30, 40, 41, 34, 70, 74}; // x = 0
Physical Curve("Base", 14) = {60};
Physical Curve("Top", 15) = {63};
Physical Curve("Pin_low", 16) = {10, 11};
Physical Surface("Pin", 21) = {10:13, 20, 21};
Physical Surface("Plate", 22) = {50:53};

Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0;
