// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A cylindrical punch with a rounded edge on a cylindrical foundation (NAFEMS,
// Advanced Finite Element Contact Benchmarks, no. 2): the section x >= 0, x is
// the radius, y the axis. The bodies touch at y = 0 and share no node. Lengths
// in mm, first-order cells, all quadrangles and counter-clockwise; no free
// mesher takes part.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o punch.msh punch.geo
//
// The fillet is about (40, 10): Fillet: 40, 10, 10.

// ---------------------------------------------------------------- parameters

flat = 40;  // radius of the flat of the punch
R    = 10;  // of the fillet
H    = 100; // height of the punch
Rf   = 100; // radius of the foundation
Hf   = 200; // and its height
rP   = 45;  // where the radial displacement is asked for
core = 5;   // side of the block at the centre of the fillet
hand = 4;   // both coordinates of its corner, from there

// Length of the edges, unless set before. The benchmark's values are those of a
// mesh as coarse as this one.
DefineConstant[ h = 5 ];

// --------------------------------------------------------------------- punch

Point(1)  = {0, 0, 0};
Point(2)  = {flat, 0, 0};
Point(3)  = {flat, R, 0}; // centre of the fillet
Point(4)  = {flat + R * Sin(Pi / 4), R - R * Cos(Pi / 4), 0};
Point(5)  = {flat + R, R, 0};
Point(6)  = {flat, R - core, 0};
Point(7)  = {flat + hand, R - hand, 0};
Point(8)  = {flat + core, R, 0};
Point(9)  = {0, R - core, 0};
Point(10) = {0, R, 0};
Point(11) = {0, H, 0};
Point(12) = {flat, H, 0};
Point(13) = {flat + core, H, 0};
Point(14) = {flat + R, H, 0};

Line(1)    = {2, 1};
Circle(2)  = {2, 3, 4};
Circle(3)  = {4, 3, 5};
Line(4)    = {2, 6};
Line(5)    = {6, 3};
Line(6)    = {4, 7};
Line(7)    = {6, 7};
Line(8)    = {7, 8};
Line(9)    = {3, 8};
Line(10)   = {5, 8};
Line(11)   = {1, 9};
Line(12)   = {9, 10};
Line(13)   = {6, 9};
Line(14)   = {3, 10};
Line(15)   = {10, 11};
Line(16)   = {3, 12};
Line(17)   = {8, 13};
Line(18)   = {5, 14};
Line(19)   = {12, 11};
Line(20)   = {12, 13};
Line(21)   = {14, 13};

nFlat  = Round(flat / h); // edges along the flat
nArc   = Round(R / h);    // of each half of the fillet
nLayer = Round(core / h); // between the fillet and the block at its centre
nTop   = Round((H - R) / h);
Transfinite Curve {1, 13, 14, 19}            = nFlat + 1;
Transfinite Curve {2, 3, 5, 7, 8, 9, 12, 20} = nArc + 1;
Transfinite Curve {4, 6, 10, 11, 21}         = nLayer + 1;
Transfinite Curve {15, 16, 17, 18}           = nTop + 1;

Curve Loop(1) = {-1, 4, 13, -11};    // over the flat
Curve Loop(2) = {-13, 5, 14, -12};
Curve Loop(3) = {2, 6, -7, -4};      // the fillet
Curve Loop(4) = {3, 10, -8, -6};
Curve Loop(5) = {7, 8, -9, -5};
Curve Loop(6) = {-14, 16, 19, -15};  // up to the top
Curve Loop(7) = {9, 17, -20, -16};
Curve Loop(8) = {-10, 18, 21, -17};

// ---------------------------------------------------------------- foundation

Point(21) = {0, 0, 0};
Point(22) = {flat, 0, 0};
Point(23) = {Rf, 0, 0};
Point(24) = {0, -Hf, 0};
Point(25) = {flat, -Hf, 0};
Point(26) = {Rf, -Hf, 0};
Point(27) = {rP, 0, 0};
Point(28) = {rP, -Hf, 0};

Line(31) = {22, 21};
Line(32) = {22, 27};
Line(33) = {27, 23};
Line(34) = {21, 24};
Line(35) = {22, 25};
Line(36) = {27, 28};
Line(37) = {23, 26};
Line(38) = {25, 24};
Line(39) = {25, 28};
Line(40) = {28, 26};

Transfinite Curve {31, 38}         = Round(flat / h) + 1;
Transfinite Curve {32, 39}         = Round((rP - flat) / h) + 1;
Transfinite Curve {33, 40}         = Round((Rf - rP) / h) + 1;
Transfinite Curve {34, 35, 36, 37} = Round(Hf / h) + 1;

Curve Loop(9)  = {31, 34, -38, -35};
Curve Loop(10) = {35, 39, -36, -32};
Curve Loop(11) = {36, 40, -37, -33};

For s In {1:11}
  Plane Surface(s) = {s};
  Transfinite Surface {s};
  Recombine Surface {s};
EndFor

// ----------------------------------------------------------- physical groups

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Curve("Axis", 1) = {11, 12, 15, 34};
Physical Curve("Punch_bottom", 2) = {1, 2, 3}; // flat and fillet
Physical Curve("Fillet", 3) = {2, 3};
Physical Curve("Load", 4) = {19, 20, 21};      // y = H
Physical Curve("Foundation_top", 5) = {31, 32, 33};
Physical Curve("Base", 6) = {38, 39, 40};          // y = -Hf

Physical Surface("Punch", 7) = {1:8};
Physical Surface("Foundation", 8) = {9:11};

Physical Point("Punch_centre", 9) = {1};
Physical Point("Foundation_centre", 10) = {21};
Physical Point("Foundation_45", 11) = {27};

// ------------------------------------------------------------------- options

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.SubdivisionAlgorithm = 0;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
