// SPDX-License-Identifier: LGPL-2.1-or-later
//
// NAFEMS contact benchmark 1, cylinder roller (SSNP154), as a coarse mesh to
// be refined by the program: right half of a cylinder of radius 50 mm resting
// on a block, touching it at the origin. Lengths in mm, first-order cells, all
// quadrangles and counter-clockwise; no free mesher takes part.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o ssnp154_quads.msh ssnp154_quads.geo
//
// Names and groups are those of ssnp154.geo.

// ---------------------------------------------------------------- parameters

// Block [0, side] x [-depth, 0]
side   = 100;
depth  = 200;
fine   = 30;  // side of the uniform square below the contact
nFine  = 5;   // edges on a side of that square (6 mm each)
nTrans = 5;   // edges from that square to the square of side `side`
qTrans = 1.3; // their growth: 7.7 mm to 22 mm
nDeep  = 3;   // rows of cells below the latter
qDeep  = 1.2; // their growth: 27 mm to 40 mm

// Cylinder about (0, R): a core of nCap x nSide cells on the axis within a
// ring of nRing layers. The ring has three blocks: the cap at C, the side and
// the cap at the load; they meet on the circle at bottomAngle and topAngle,
// counted from C about the centre. The side has nSideLower edges below (R, R)
// and nSideUpper above.
R          = 50;
h0         = 5.3 * Pi / 180; // first edge on the arc at C (4.6 mm)
nCap       = 5;
nSideLower = 5;
nSideUpper = 2;
nRing      = 2;
nSide      = nSideLower + nSideUpper;
nArc       = nCap + nSideLower; // arc from C to (R, R)
nArcUpper  = nSideUpper + nCap; // arc from (R, R) to the loaded point

ringC      = 10.2; // thickness of the ring on the axis at C
ringBottom = 8.5;  // between the cap at C and the side
ringTop    = 16;   // between the side and the cap at the load
ringForce  = 21;   // on the axis at the load
qRing      = 1.10; // growth of its layers inwards

// The core. All these were tried until the angles came closest to right ones:
// 58 to 127 degrees in the cylinder (45 to 135 in the block).
bulge      = 0.09; // rise of its side, by the length of that
sag        = 0.02; // rise of its ends, by the length of those
qAxis      = 1.09; // growth of its edges upwards on the axis
qSide      = 1.08; // and on its side

// ------------------------------------------------------------------- grading

// Ratio of the geometric progression of nArc edges which starts with h0 and
// adds up to a quarter of the circle; the sum grows with the ratio: bisection.
low = 1 + 1e-6;
high = 2;
For i In {1:60}
  qArc = (low + high) / 2;
  If (h0 * (qArc^nArc - 1) / (qArc - 1) > Pi / 2)
    high = qArc;
  Else
    low = qArc;
  EndIf
EndFor

bottomAngle = h0 * (qArc^nCap - 1) / (qArc - 1);
topAngle    = Pi / 2 * (1 + nSideUpper / nArcUpper);

// --------------------------------------------------------------------- block

// Point 1 is B. The cylinder has a point of its own at the same place: the
// bodies must not share a node, hence no Coherence anywhere in this file.
Point(1) = {0, 0, 0};
Point(2) = {fine, 0, 0};
Point(3) = {side, 0, 0};
Point(4) = {0, -fine, 0};
Point(5) = {fine, -fine, 0};
Point(6) = {0, -side, 0};
Point(7) = {side, -side, 0};
Point(8) = {0, -depth, 0};
Point(9) = {side, -depth, 0};

Line(1)  = {1, 2};
Line(2)  = {2, 3};
Line(3)  = {4, 5};
Line(4)  = {6, 7};
Line(5)  = {8, 9};
Line(6)  = {4, 1};
Line(7)  = {5, 2};
Line(8)  = {7, 3};
Line(9)  = {4, 6};
Line(10) = {5, 7};
Line(11) = {6, 8};
Line(12) = {7, 9};

Transfinite Curve {1, 3, 4, 5, 6, 7, 8} = nFine + 1;
Transfinite Curve {2, 9, 10} = nTrans + 1 Using Progression qTrans;
Transfinite Curve {11, 12} = nDeep + 1 Using Progression qDeep;

Curve Loop(1) = {3, 7, -1, -6};    // square below the contact
Curve Loop(2) = {10, 8, -2, -7};   // transition to the right
Curve Loop(3) = {4, -10, -3, 9};   // transition downwards
Curve Loop(4) = {5, -12, -4, 11};  // deep part

For s In {1:4}
  Plane Surface(s) = {s};
  Transfinite Surface {s};
  Recombine Surface {s};
EndFor

// ------------------------------------------------------------------ cylinder

Point(21) = {0, 0, 0}; // C, on purpose a second point at the origin
Point(22) = {R * Sin(bottomAngle), R - R * Cos(bottomAngle), 0};
Point(23) = {R, R, 0};
Point(24) = {R * Sin(topAngle), R - R * Cos(topAngle), 0};
Point(25) = {0, 2 * R, 0}; // Force
Point(26) = {0, R, 0};     // centre, for the arcs only

// Corners of the core
r = R - ringBottom;
Point(27) = {0, ringC, 0};
Point(28) = {r * Sin(bottomAngle), R - r * Cos(bottomAngle), 0};
r = R - ringTop;
Point(29) = {r * Sin(topAngle), R - r * Cos(topAngle), 0};
Point(30) = {0, 2 * R - ringForce, 0};

// Outline; on a circle the progression is one of angles.
Circle(21) = {21, 26, 22};
Circle(22) = {22, 26, 23};
Circle(23) = {23, 26, 24};
Circle(24) = {24, 26, 25};
Line(25)   = {21, 27};
Line(26)   = {27, 30};
Line(27)   = {25, 30};
// From the outline to the core
Line(28)   = {22, 28};
Line(29)   = {24, 29};
// Sides of the core, slightly round to even out the angles at its corners:
// through a point beside the middle of the chord, to the right of the way.
Macro RoundLine
  a() = Point{from};
  b() = Point{to};
  middle = newp;
  Point(middle) = {(a[0] + b[0]) / 2 + rise * (b[1] - a[1]),
                   (a[1] + b[1]) / 2 - rise * (b[0] - a[0]), 0};
  Spline(number) = {from, middle, to};
Return

// gmsh returns from a macro to the next line: nothing may follow a Call on
// its line.
from = 27;
to = 28;
number = 30;
rise = sag;
Call RoundLine;

from = 28;
to = 29;
number = 31;
rise = bulge;
Call RoundLine;

from = 29;
to = 30;
number = 32;
rise = sag;
Call RoundLine;

Transfinite Curve {21, 30} = nCap + 1 Using Progression qArc;
Transfinite Curve {22} = nSideLower + 1 Using Progression qArc;
Transfinite Curve {23} = nSideUpper + 1;
Transfinite Curve {24, 32} = nCap + 1;
Transfinite Curve {25, 27, 28, 29} = nRing + 1 Using Progression qRing;
Transfinite Curve {26} = nSide + 1 Using Progression qAxis;
Transfinite Curve {31} = nSide + 1 Using Progression qSide;

Curve Loop(11) = {21, 28, -30, -25};     // cap at C
Curve Loop(12) = {22, 23, 29, -31, -28}; // side
Curve Loop(13) = {24, 27, -32, -29};     // cap at the load
Curve Loop(14) = {30, 31, 32, -26};      // core

For s In {11:14}
  Plane Surface(s) = {s};
  Recombine Surface {s};
EndFor
Transfinite Surface {11, 13, 14};
Transfinite Surface {12} = {22, 24, 29, 28};

// ----------------------------------------------------------- physical groups

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Point("B", 1) = {1};
Physical Point("C", 2) = {21};
Physical Point("Force", 3) = {25};

Physical Curve("Axe", 4) = {6, 9, 11, 25, 26, 27}; // x = 0, both bodies
Physical Curve("Encast", 5) = {5};                 // y = -depth
Physical Curve("Top_B", 6) = {1};                  // master
Physical Curve("Bottom_C", 7) = {21, 22};          // slave

Physical Curve("Cap", 10) = {24};                  // for a spread force

Physical Surface("Block", 8) = {1, 2, 3, 4};
Physical Surface("Cylinder", 9) = {11, 12, 13, 14};

// ------------------------------------------------------------------- options

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.SubdivisionAlgorithm = 0;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
