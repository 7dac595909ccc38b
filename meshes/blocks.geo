// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A block on a block, which touch along y = 0 and share no node; quadrangles,
// or triangles. All is set by numbers, see the table of meshes in
// parameters/hard/meshes.sh, which writes them. Lengths in mm.
//
// Made for gmsh 4.8.4.

DefineConstant[ left = 0 ];   // upper block [left, left + width] x [0, height]
DefineConstant[ width = 20 ];
DefineConstant[ height = 10 ];
DefineConstant[ nx = 5 ];     // its edges
DefineConstant[ ny = 3 ];
DefineConstant[ lowerWidth = 40 ]; // lower block [-lowerWidth/2, ...]
DefineConstant[ lowerHeight = 20 ];
DefineConstant[ mx = 8 ];
DefineConstant[ my = 4 ];
DefineConstant[ triangles = 0 ];

Macro Bar
  Point(base + 1) = {x0, y0, 0};
  Point(base + 2) = {x1, y0, 0};
  Point(base + 3) = {x1, y1, 0};
  Point(base + 4) = {x0, y1, 0};
  Line(base + 1) = {base + 1, base + 2};
  Line(base + 2) = {base + 2, base + 3};
  Line(base + 3) = {base + 4, base + 3};
  Line(base + 4) = {base + 1, base + 4};
  Transfinite Curve {base + 1, base + 3} = n + 1;
  Transfinite Curve {base + 2, base + 4} = m + 1;
  Curve Loop(base) = {base + 1, base + 2, -(base + 3), -(base + 4)};
  Plane Surface(base) = {base};
  Transfinite Surface {base};
  If (triangles == 0)
    Recombine Surface {base};
  EndIf
Return

base = 10;
x0 = -lowerWidth / 2;
x1 = lowerWidth / 2;
y0 = -lowerHeight;
y1 = 0;
n = mx;
m = my;
Call Bar;

base = 20;
x0 = left;
x1 = left + width;
y0 = 0;
y1 = height;
n = nx;
m = ny;
Call Bar;

Physical Point("L", 1) = {21};      // corners of the upper block
Physical Point("R", 2) = {22};
Physical Point("TL", 3) = {24};
Physical Point("TR", 4) = {23};
Physical Point("M", 5) = {14};      // upper left corner of the lower block

Physical Curve("Base", 11) = {11};
Physical Curve("Master", 12) = {13};
Physical Curve("Slave", 13) = {21};
Physical Curve("Top", 14) = {23};
Physical Curve("Left", 15) = {24};  // of the upper block
Physical Curve("Right", 16) = {22};
Physical Curve("Left_low", 17) = {14};
Physical Curve("Right_low", 18) = {12};

Physical Surface("Lower", 21) = {10};
Physical Surface("Upper", 22) = {20};

Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0;
