// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Line contact of Hertz at a small load, as a coarse mesh to be refined by the
// program: outline and groups of ssnp154_quads.geo (right half of a cylinder
// of radius 50 mm resting on a block, touching it at the origin), strongly
// graded towards a contact whose half width is a = 0.6215 mm. Lengths in mm,
// first-order cells, all quadrangles and counter-clockwise; no free mesher
// takes part.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o hertz.msh hertz.geo
//
// Arcs: Bottom_C: 0, 50, 50; likewise Cap.

// ---------------------------------------------------------------- parameters

// Block [0, side] x [-depth, 0]: a square of uniform cells at the contact, a
// transition to the square of side `top`, one to the square of side `side`,
// and the deep part.
side   = 100;
depth  = 200;
top    = 30;    // Top_B is the top for x <= top
hBlock = 0.124; // edge of the uniform cells (a / 5)
nBlock = 8;     // edges on a side of their square (1.6 a)
mTop   = 13;    // layers from there to `top`
mSide  = 4;     // layers from `top` to `side`
qSide  = 1.35;  // their growth: 11 mm to 26 mm
nDeep  = 3;     // rows of cells below
qDeep  = 1.1;   // their growth: 30 mm to 37 mm

// Cylinder about (0, R): a square of uniform cells at C, whose edges do not
// match those of the block.
R         = 50;
hCylinder = 0.158; // edge of the uniform cells (a / 4)
nCylinder = 7;     // edges on a side of their square (1.8 a)
mCylinder = 15;    // edges from there to the height of the centre

// The quarter above the centre has three blocks: layers next to the height of
// the centre, in two of them, then as many edges as there are below.
mUpper   = 3;
qUpper   = 0.72;           // growth of the layers, which get thinner
angleCap = 126 * Pi / 180; // where they end on the arc and Cap begins, from C
nodeAxis = 26;             // on the axis, height above the centre
nodeX    = 20;             // where the three blocks meet
nodeY    = 16;             // and its height above the centre

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

// --------------------------------------------------------------------- block

// Point 1 is B. The cylinder has a point of its own at the same place: the
// bodies must not share a node, hence no Coherence anywhere in this file.
s = nBlock * hBlock;
Point(1)  = {0, 0, 0};
Point(2)  = {s, 0, 0};
Point(3)  = {top, 0, 0};
Point(4)  = {side, 0, 0};
Point(5)  = {0, -s, 0};
Point(6)  = {s, -s, 0};
Point(7)  = {0, -top, 0};
Point(8)  = {top, -top, 0};
Point(9)  = {0, -side, 0};
Point(10) = {side, -side, 0};
Point(11) = {0, -depth, 0};
Point(12) = {side, -depth, 0};

// Along the top
Line(1)  = {1, 2};
Line(2)  = {2, 3};
Line(3)  = {3, 4};
// Down the axis
Line(4)  = {1, 5};
Line(5)  = {5, 7};
Line(6)  = {7, 9};
Line(7)  = {9, 11};
// Along the diagonal and down the side
Line(8)  = {6, 8};
Line(9)  = {8, 10};
Line(10) = {10, 12};
// The squares and the foot
Line(11) = {5, 6};
Line(12) = {6, 2};
Line(13) = {7, 8};
Line(14) = {8, 3};
Line(15) = {9, 10};
Line(16) = {10, 4};
Line(17) = {11, 12};

// Each line of the first transition has a ratio of its own, so that all start
// with the same edge.
h = hBlock;
n = mTop;

length = top - s; // top and axis
Call Ratio;
Transfinite Curve {2, 5} = mTop + 1 Using Progression ratio;

length = Sqrt(2) * (top - s); // diagonal
Call Ratio;
Transfinite Curve {8} = mTop + 1 Using Progression ratio;

Transfinite Curve {1, 4, 11, 12, 13, 14, 15, 16, 17} = nBlock + 1;
Transfinite Curve {3, 6, 9} = mSide + 1 Using Progression qSide;
Transfinite Curve {7, 10} = nDeep + 1 Using Progression qDeep;

Curve Loop(1) = {11, 12, -1, 4};    // square at the contact
Curve Loop(2) = {8, 14, -2, -12};   // first transition, to the right
Curve Loop(3) = {5, 13, -8, -11};   // and downwards
Curve Loop(4) = {9, 16, -3, -14};   // second transition, to the right
Curve Loop(5) = {6, 15, -9, -13};   // and downwards
Curve Loop(6) = {7, 17, -10, -15};  // deep part

// ------------------------------------------------------------------ cylinder

// The lower quarter has three blocks: the square at C and two from there to
// the height of the centre, one along the arc and one along the axis. These
// meet on an arc of a circle that leaves the origin at 45 degrees and meets
// that height at a right angle: it is about (-R, R), its radius is Sqrt(2) R.
s = nCylinder * hCylinder;
phi = s / R; // angle of the square's part of the arc
t = s - R;
x4 = -R + Sqrt(2 * R^2 - t^2); // where that circle meets height s

Point(21) = {0, 0, 0}; // C, on purpose a second point at the origin
Point(22) = {R * Sin(phi), R * (1 - Cos(phi)), 0};
Point(23) = {0, s, 0};
Point(24) = {x4, s, 0};
Point(25) = {0, R, 0}; // Centre
Point(26) = {(Sqrt(2) - 1) * R, R, 0};
Point(27) = {R, R, 0};
Point(28) = {-R, R, 0}; // for the arc between the blocks only

Circle(21) = {21, 25, 22};
Circle(22) = {22, 25, 27};
Line(23)   = {21, 23};
Line(24)   = {23, 25};
Line(25)   = {22, 24};
Line(26)   = {23, 24};
Circle(27) = {24, 28, 26};
Line(28)   = {27, 26};
Line(29)   = {25, 26};

// Each of the lines away from the contact has a ratio of its own, so that all
// start with the same edge.
h = hCylinder;
n = mCylinder;

length = R - s; // axis
Call Ratio;
Transfinite Curve {24} = mCylinder + 1 Using Progression ratio;

length = R * (Pi / 2 - phi); // arc
Call Ratio;
Transfinite Curve {22} = mCylinder + 1 Using Progression ratio;

length = Sqrt(2) * R * Asin((R - s) / (Sqrt(2) * R)); // between the blocks
Call Ratio;
Transfinite Curve {27} = mCylinder + 1 Using Progression ratio;

Curve Loop(21) = {21, 25, -26, -23}; // square at C
Curve Loop(22) = {22, 28, -27, -25}; // along the arc
Curve Loop(23) = {26, 27, -29, -24}; // along the axis

// The upper quarter: blocks at the centre, at (R, R) and at the load
Point(31) = {R * Sin(angleCap), R - R * Cos(angleCap), 0};
Point(32) = {0, 2 * R, 0}; // Force
Point(33) = {0, R + nodeAxis, 0};
Point(34) = {nodeX, R + nodeY, 0};

Circle(31) = {27, 25, 31};
Circle(32) = {31, 25, 32};
Line(33)   = {25, 33};
Line(34)   = {33, 32};
Line(35)   = {26, 34};
Line(36)   = {33, 34};
Line(37)   = {31, 34};

Transfinite Curve {31, 33, 35} = mUpper + 1 Using Progression qUpper;
Transfinite Curve {21, 23, 25, 26, 28, 29, 32, 34, 36, 37} = nCylinder + 1;

Curve Loop(24) = {29, 35, -36, -33};  // at the centre
Curve Loop(25) = {31, 37, -35, -28};  // at (R, R)
Curve Loop(26) = {32, -34, 36, -37};  // at the load

For s In {1:6}
  Plane Surface(s) = {s};
  Transfinite Surface {s};
  Recombine Surface {s};
EndFor
For s In {21:26}
  Plane Surface(s) = {s};
  Transfinite Surface {s};
  Recombine Surface {s};
EndFor

// ----------------------------------------------------------- physical groups

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Point("B", 1) = {1};
Physical Point("C", 2) = {21};
Physical Point("Force", 3) = {32};
Physical Point("Centre", 11) = {25};

Physical Curve("Axe", 4) = {4:7, 23, 24, 33, 34}; // x = 0, both bodies
Physical Curve("Encast", 5) = {17};               // y = -depth
Physical Curve("Top_B", 6) = {1, 2};              // master
Physical Curve("Bottom_C", 7) = {21, 22};         // slave

Physical Curve("Cap", 10) = {32};                 // for a spread force

Physical Surface("Block", 8) = {1:6};
Physical Surface("Cylinder", 9) = {21:26};

// ------------------------------------------------------------------- options

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.SubdivisionAlgorithm = 0;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
