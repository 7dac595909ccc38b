// SPDX-License-Identifier: LGPL-2.1-or-later
//
// NAFEMS contact benchmark 1, cylinder roller (SSNP154): right half of a
// cylinder of radius 50 mm resting on a block, touching it at the origin.
// Lengths in mm, first-order cells, all counter-clockwise.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o ssnp154.msh ssnp154.geo
//
// Another version of gmsh places the free nodes of the cylinder differently;
// block, outline and patch at the contact point stay the same.

// ---------------------------------------------------------------- parameters

// Block [0, side] x [-depth, 0]
side       = 100;
depth      = 200;
fine       = 30; // side of the uniform square below the contact
nFine      = 20; // edges on a side of that square (1.5 mm each)
nTrans     = 20; // edges from that square to the square of side `side`
nDeep      = 10; // rows of cells below the latter

// Cylinder about (0, R)
R          = 50;
h0         = 0.590; // first edge at C, the same along the arc and the axis
nArc       = 59;    // arc from C to (R, R)
nAxis      = 38;    // axis from C to the centre
nRadius    = 20;    // radius y = R, which splits the two quarters
nArcUpper  = 12;    // arc from (R, R) to the loaded point
nAxisUpper = 10;    // axis from the centre to the loaded point

// Mapped patch at C. The stress at the contact point follows the first few
// cells behind it, so these are not left to the free mesher. The patch covers
// 8.2 mm of arc, more than the half-width of contact (about 6.2 mm, Hertz).
nPatchArc  = 12;
nPatchAxis = 8;

// ------------------------------------------------------------------- grading

// Ratio of the geometric progression of progEdges edges which starts with h0
// and adds up to progLength. Solved for rather than typed in, so that arc and
// axis start with the very same edge and each stays one progression although
// it is cut in pieces by the patch. The sum grows with the ratio: bisection.
Macro SolveRatio
  low = 1 + 1e-6;
  high = 2;
  For i In {1:60}
    ratio = (low + high) / 2;
    If (h0 * (ratio^progEdges - 1) / (ratio - 1) > progLength)
      high = ratio;
    Else
      low = ratio;
    EndIf
  EndFor
Return

// gmsh returns from a macro to the next line: nothing may follow a Call on
// its line.
progEdges = nArc;
progLength = R * Pi / 2;
Call SolveRatio;
qArc = ratio; // 1.0253, first edge 0.676 degrees

progEdges = nAxis;
progLength = R;
Call SolveRatio;
qAxis = ratio; // 1.0394, last edge 2.46 mm

patchAngle = h0 / R * (qArc^nPatchArc - 1) / (qArc - 1);
patchDepth = h0 * (qAxis^nPatchAxis - 1) / (qAxis - 1);
hCentre    = h0 * qAxis^(nAxis - 1); // axis edge next to the centre

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
Line(9)  = {6, 4};
Line(10) = {7, 5};
Line(11) = {8, 6};
Line(12) = {9, 7};

Transfinite Curve {1, 3, 4, 5, 6, 7, 8} = nFine + 1;
Transfinite Curve {2, 9, 10} = nTrans + 1;
Transfinite Curve {11, 12} = nDeep + 1;

Curve Loop(1) = {3, 7, -1, -6};    // square below the contact
Curve Loop(2) = {-10, 8, -2, -7};  // transition to the right
Curve Loop(3) = {4, 10, -3, -9};   // transition downwards
Curve Loop(4) = {5, 12, -4, -11};  // deep part

For s In {1:4}
  Plane Surface(s) = {s};
  Transfinite Surface {s};
  Recombine Surface {s};
EndFor

// ------------------------------------------------------------------ cylinder

Point(21) = {0, 0, 0}; // C, on purpose a second point at the origin
Point(22) = {R * Sin(patchAngle), R - R * Cos(patchAngle), 0};
Point(23) = {R, R, 0};
Point(24) = {0, 2 * R, 0}; // Force
Point(25) = {0, R, 0};     // centre
Point(26) = {0, patchDepth, 0};
Point(27) = {(R - patchDepth) * Sin(patchAngle),
             R - (R - patchDepth) * Cos(patchAngle), 0};
Point(28) = {0, R - hCentre, 0};
Point(29) = {R / nRadius, R, 0};

// Outline; on a circle the progression is one of angles.
Circle(21) = {21, 25, 22};
Circle(22) = {22, 25, 23};
Circle(23) = {23, 25, 24};
Line(24)   = {21, 26};
Line(25)   = {26, 28};
Line(26)   = {28, 25};
Line(27)   = {25, 24};
Line(28)   = {25, 29};
Line(29)   = {29, 23};
// Inner sides of the patch, concentric and radial: near-rectangular cells.
Circle(30) = {26, 25, 27};
Line(31)   = {22, 27};
// Long side of the triangle at the centre, see below.
Line(32)   = {28, 29};

Transfinite Curve {21, 30} = nPatchArc + 1 Using Progression qArc;
Transfinite Curve {22} = nArc - nPatchArc + 1 Using Progression qArc;
Transfinite Curve {23} = nArcUpper + 1;
Transfinite Curve {24, 31} = nPatchAxis + 1 Using Progression qAxis;
Transfinite Curve {25} = nAxis - nPatchAxis - 1 + 1 Using Progression qAxis;
Transfinite Curve {26, 28, 32} = 1 + 1;
Transfinite Curve {27} = nAxisUpper + 1;
Transfinite Curve {29} = nRadius - 1 + 1;

Curve Loop(11) = {21, 31, -30, -24};
Plane Surface(11) = {11};
Transfinite Surface {11};
Recombine Surface {11};

// The lower quarter is bounded by 59 + 20 + 38 = 117 edges. An odd outline
// cannot be filled with quadrangles alone: blossom gives up and a fallback
// leaves some 200 triangles. So one triangle is cut off by hand, at the
// centre, far from contact and load; what remains has 116 edges.
Curve Loop(12) = {22, -29, -32, -25, 30, -31};
Plane Surface(12) = {12};
Recombine Surface {12};

Curve Loop(13) = {32, -28, -26};
Plane Surface(13) = {13};

Curve Loop(14) = {28, 29, 23, -27};
Plane Surface(14) = {14};
Recombine Surface {14};

// ----------------------------------------------------------- physical groups

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Point("B", 1) = {1};
Physical Point("C", 2) = {21};
Physical Point("Force", 3) = {24};

Physical Curve("Axe", 4) = {6, 9, 11, 24, 25, 26, 27}; // x = 0, both bodies
Physical Curve("Encast", 5) = {5};                     // y = -depth
Physical Curve("Top_B", 6) = {1};                      // master
Physical Curve("Bottom_C", 7) = {21, 22};              // slave

Physical Surface("Block", 8) = {1, 2, 3, 4};
Physical Surface("Cylinder", 9) = {11, 12, 13, 14};

// ------------------------------------------------------------------- options

// Mostly the defaults, repeated because a user's own gmsh settings would
// otherwise change the mesh.
Mesh.Algorithm = 6;                 // Frontal-Delaunay
Mesh.RecombinationAlgorithm = 1;    // blossom
Mesh.RecombineOptimizeTopology = 5;
Mesh.Smoothing = 1;                 // more spoils the worst quadrangle
Mesh.MeshSizeExtendFromBoundary = 1; // inner sizes follow the outline
Mesh.MeshSizeFactor = 1;
Mesh.RandomSeed = 1;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0;                   // only elements of physical groups
