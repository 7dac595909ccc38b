// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Two equal half cylinders that touch in the origin, as a coarse mesh to be
// refined by the program; strongly graded towards a contact whose half width
// is some 0.6 mm. They share no node and their edges do not match. Lengths in
// mm, first-order cells, all quadrangles and counter-clockwise; no free mesher
// takes part.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o cylinders.msh cylinders.geo
//
// Arcs: Lower_top: 0, -50, 50; Upper_bottom: 0, 50, 50; likewise Lower_side and
// Upper_side, the steep ends of the arcs, which cannot get into contact.

// ---------------------------------------------------------------- parameters

R = 50; // radius of both

// At the contact each has two squares of uniform cells, one on each side of
// the axis x = 0: edges on a side of one square, their length, and the edges
// from the square to the flat side, which grow.
nLower = 7;
hLower = 0.153;
mLower = 14;

nUpper = 8;
hUpper = 0.12;
mUpper = 15;

// ------------------------------------------------------------------- grading

// Ratio of the geometric progression of n edges which starts with ratio * h,
// next to an edge h, and adds up to `length`; the sum grows with the ratio:
// bisection.
Macro Ratio
  low = 1 + 1e-6;
  high = 4;
  For i In {1:60}
    ratio = (low + high) / 2;
    If (h * ratio * (ratio^n - 1) / (ratio - 1) > length)
      high = ratio;
    Else
      low = ratio;
    EndIf
  EndFor
Return

// ----------------------------------------------------------------- cylinders

// A half disc above the origin, to be turned about it by half a turn for
// turn = -1; the numbers of its parts start at `base`. Each half of it, to the
// right and to the left of the axis, has three blocks: the square at the
// origin and two from there to the flat side, one along the arc and one along
// the axis. These meet on an arc of a circle that leaves the origin at 45
// degrees and meets the flat side at a right angle: it is about (-R, R) for
// the right half, its radius is Sqrt(2) R.
//
// The points (right; the left ones are 10 further on):
//
//   5 ---- 6 ----- 7      flat side
//   |      |      /
//   3 ---- 4    9         arc from 1 to 7; from 9 on it is the side, one edge
//   |      |  /           long
//   1 ---- 2
Macro HalfDisc
  s = nCore * hCore; // side of the squares
  phi = s / R;       // angle of their part of the arc

  // Where the circle between the blocks meets height s: the corner of the
  // square
  t = s - R;
  x4 = -R + Sqrt(2 * R^2 - t^2);

  h = hCore;
  n = mGrow;
  length = R * (Pi / 2 - phi); // arc
  Call Ratio;
  qArc = ratio;
  side = phi + h * qArc * (qArc^(n - 1) - 1) / (qArc - 1) / R; // angle of 9

  Point(base + 1)  = {0, 0, 0};
  Point(base + 3)  = {0, turn * s, 0};
  Point(base + 5)  = {0, turn * R, 0};
  Point(base + 2)  = {turn * R * Sin(phi), turn * R * (1 - Cos(phi)), 0};
  Point(base + 4)  = {turn * x4, turn * s, 0};
  Point(base + 6)  = {turn * (Sqrt(2) - 1) * R, turn * R, 0};
  Point(base + 7)  = {turn * R, turn * R, 0};
  Point(base + 8)  = {-turn * R, turn * R, 0}; // about which 14 to 16 is
  Point(base + 9)  = {turn * R * Sin(side), turn * R * (1 - Cos(side)), 0};
  Point(base + 12) = {-turn * R * Sin(phi), turn * R * (1 - Cos(phi)), 0};
  Point(base + 14) = {-turn * x4, turn * s, 0};
  Point(base + 16) = {-turn * (Sqrt(2) - 1) * R, turn * R, 0};
  Point(base + 19) = {-turn * R * Sin(side), turn * R * (1 - Cos(side)), 0};

  // On the axis
  Line(base + 1) = {base + 1, base + 3};
  Line(base + 2) = {base + 3, base + 5};
  // The right half
  Circle(base + 3)  = {base + 1, base + 5, base + 2};
  Circle(base + 4)  = {base + 2, base + 5, base + 9};
  Line(base + 5)    = {base + 2, base + 4};
  Line(base + 6)    = {base + 3, base + 4};
  Circle(base + 7)  = {base + 4, base + 8, base + 6};
  Line(base + 8)    = {base + 7, base + 6};
  Line(base + 9)    = {base + 5, base + 6};
  Circle(base + 10) = {base + 9, base + 5, base + 7};
  // The left half; its end of the flat side is point 8.
  Circle(base + 13) = {base + 1, base + 5, base + 12};
  Circle(base + 14) = {base + 12, base + 5, base + 19};
  Line(base + 15)   = {base + 12, base + 14};
  Line(base + 16)   = {base + 3, base + 14};
  Circle(base + 17) = {base + 14, base + 7, base + 16};
  Line(base + 18)   = {base + 8, base + 16};
  Line(base + 19)   = {base + 5, base + 16};
  Circle(base + 20) = {base + 19, base + 5, base + 8};

  Transfinite Curve {base + 1, base + 3, base + 5, base + 6, base + 8, base + 9,
                     base + 13, base + 15, base + 16, base + 18,
                     base + 19} = nCore + 1;

  // Each of the lines away from the contact has a ratio of its own, so that
  // all start with the same edge.
  Transfinite Curve {base + 4, base + 14} = mGrow Using Progression qArc;
  Transfinite Curve {base + 10, base + 20} = 2;

  length = R - s; // axis
  Call Ratio;
  Transfinite Curve {base + 2} = mGrow + 1 Using Progression ratio;

  length = Sqrt(2) * R * Asin((R - s) / (Sqrt(2) * R)); // between the blocks
  Call Ratio;
  Transfinite Curve {base + 7, base + 17} = mGrow + 1 Using Progression ratio;

  Curve Loop(base + 1) = {base + 3, base + 5, -(base + 6), -(base + 1)};
  Curve Loop(base + 2) = {base + 4, base + 10, base + 8, -(base + 7),
                          -(base + 5)};
  Curve Loop(base + 3) = {base + 6, base + 7, -(base + 9), -(base + 2)};
  Curve Loop(base + 4) = {base + 1, base + 16, -(base + 15), -(base + 13)};
  Curve Loop(base + 5) = {base + 15, base + 17, -(base + 18), -(base + 20),
                          -(base + 14)};
  Curve Loop(base + 6) = {base + 2, base + 19, -(base + 17), -(base + 16)};
  For j In {1:6}
    Plane Surface(base + j) = {base + j};
    Recombine Surface {base + j};
  EndFor
  Transfinite Surface {base + 1, base + 3, base + 4, base + 6};
  Transfinite Surface {base + 2} = {base + 2, base + 7, base + 6, base + 4};
  Transfinite Surface {base + 5} = {base + 12, base + 14, base + 16, base + 8};
Return

// gmsh returns from a macro to the next line: nothing may follow a Call on
// its line.
base = 100;
turn = -1;
nCore = nLower;
hCore = hLower;
mGrow = mLower;
Call HalfDisc;

base = 200;
turn = 1;
nCore = nUpper;
hCore = hUpper;
mGrow = mUpper;
Call HalfDisc;

// ----------------------------------------------------------- physical groups

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Point("O_lower", 1) = {101};
Physical Point("O_upper", 2) = {201};

Physical Curve("Bottom", 3) = {108, 109, 118, 119};       // y = -R
Physical Curve("Top", 4) = {208, 209, 218, 219};          // y = R
Physical Curve("Lower_top", 5) = {103, 104, 113, 114};    // contact
Physical Curve("Upper_bottom", 6) = {203, 204, 213, 214}; // contact
Physical Curve("Lower_side", 9) = {110, 120};
Physical Curve("Upper_side", 10) = {210, 220};

Physical Surface("Lower", 7) = {101:106};
Physical Surface("Upper", 8) = {201:206};

// ------------------------------------------------------------------- options

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.SubdivisionAlgorithm = 0;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
