// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A hollow pin in the middle of the hole of a square plate, with play all
// around. They share no node, and the edges do not match. Lengths in mm.
//
// Made for gmsh 4.8.4; parameters/hard/meshes.sh writes the meshes.

DefineConstant[ play = 0.1 ]; // radius of the hole minus that of the pin

R      = 10; // radius of the hole
bore   = 3;  // radius of the bore of the pin
side   = 25; // half the side of the plate
nPin   = 6;  // edges on a quarter of the pin's circle
nHole  = 8;  // and of the hole
layers = 3;

// The pin begins off the axes: no node looks in the direction of another body's.
Point(1) = {0, 0, 0};
For i In {0:3}
  a = i * Pi / 2 + 0.1;
  Point(10 + i) = {bore * Cos(a), bore * Sin(a), 0};
  Point(20 + i) = {(R - play) * Cos(a), (R - play) * Sin(a), 0};
EndFor
For i In {0:3}
  Circle(10 + i) = {10 + i, 1, 10 + ((i + 1) % 4)};
  Circle(20 + i) = {20 + i, 1, 20 + ((i + 1) % 4)};
  Line(30 + i) = {10 + i, 20 + i};
EndFor
For i In {0:3}
  Curve Loop(10 + i) = {30 + i, 20 + i, -(30 + ((i + 1) % 4)), -(10 + i)};
  Plane Surface(10 + i) = {10 + i};
EndFor
Transfinite Curve {10:13, 20:23} = nPin + 1;
Transfinite Curve {30:33} = layers + 1;

// The plate
For i In {0:3}
  a = i * Pi / 2 + Pi / 4;
  Point(50 + i) = {R * Cos(a), R * Sin(a), 0};
  Point(60 + i) = {side * Sqrt(2) * Cos(a), side * Sqrt(2) * Sin(a), 0};
EndFor
For i In {0:3}
  Circle(50 + i) = {50 + i, 1, 50 + ((i + 1) % 4)};
  Line(60 + i) = {60 + i, 60 + ((i + 1) % 4)};
  Line(70 + i) = {50 + i, 60 + i};
EndFor
For i In {0:3}
  Curve Loop(50 + i) = {70 + i, 60 + i, -(70 + ((i + 1) % 4)), -(50 + i)};
  Plane Surface(50 + i) = {50 + i};
EndFor
Transfinite Curve {50:53, 60:63} = nHole + 1;
Transfinite Curve {70:73} = layers + 1 Using Progression 1.3;

Transfinite Surface {10:13, 50:53};
Recombine Surface {10:13, 50:53};

Physical Point("P_bore", 1) = {10};
Physical Curve("Pin_out", 11) = {20:23};
Physical Curve("Bore", 12) = {10:13};
Physical Curve("Hole", 13) = {50:53};
Physical Curve("Outer", 14) = {60:63};
Physical Surface("Pin", 21) = {10:13};
Physical Surface("Plate", 22) = {50:53};

Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0;
