// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A ring in a ring about the origin (shrink fit or Lame's problem with
// contact), as a coarse mesh to be refined by the program: the quarter x >= 0,
// y >= 0. The rings touch on a circle and share no node; their edges do not
// match there. Lengths in mm, first-order cells, all quadrangles and
// counter-clockwise; no free mesher takes part.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o rings.msh rings.geo
//
// All arcs are about the origin: Bore: 0, 0, 20; Inner_out: 0, 0, 50;
// Outer_in: 0, 0, 50; Outside: 0, 0, 100.

// ---------------------------------------------------------------- parameters

a      = 20;  // inner radius of the inner ring
b      = 50;  // radius of the contact
c      = 100; // outer radius of the outer ring
nInner = 4;   // edges around a quarter of the inner ring
DefineConstant[ nOuter = 5 ]; // and of the outer one, unless set before
mInner = 3;   // layers of the inner ring
mOuter = 3;   // and of the outer one

// --------------------------------------------------------------------- rings

Point(1) = {0, 0, 0}; // centre, for the arcs only

// A ring from the radius `from` to the radius `to` with `around` edges and
// `layers` layers, whose thicknesses grow with the radius: all cells of a ring
// have the same shape. The numbers of its parts start at `base`.
Macro Ring
  Point(base + 1) = {from, 0, 0};
  Point(base + 2) = {to, 0, 0};
  Point(base + 3) = {0, to, 0};
  Point(base + 4) = {0, from, 0};

  Line(base + 1)   = {base + 1, base + 2};
  Circle(base + 2) = {base + 2, 1, base + 3};
  Line(base + 3)   = {base + 4, base + 3};
  Circle(base + 4) = {base + 1, 1, base + 4};

  growth = (to / from)^(1 / layers);
  Transfinite Curve {base + 1, base + 3} = layers + 1 Using Progression growth;
  Transfinite Curve {base + 2, base + 4} = around + 1;

  Curve Loop(base)    = {base + 1, base + 2, -(base + 3), -(base + 4)};
  Plane Surface(base) = {base};
  Transfinite Surface {base};
  Recombine Surface {base};
Return

// gmsh returns from a macro to the next line: nothing may follow a Call on
// its line.
base = 10;
from = a;
to = b;
around = nInner;
layers = mInner;
Call Ring;

base = 20;
from = b;
to = c;
around = nOuter;
layers = mOuter;
Call Ring;

// ----------------------------------------------------------- physical groups

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Curve("Axis_x", 1) = {11, 21}; // y = 0, both bodies
Physical Curve("Axis_y", 2) = {13, 23}; // x = 0, both bodies
Physical Curve("Bore", 3) = {14};       // r = a
Physical Curve("Inner_out", 4) = {12};  // r = b of Inner
Physical Curve("Outer_in", 5) = {24};   // r = b of Outer
Physical Curve("Outside", 6) = {22};    // r = c

Physical Surface("Inner", 7) = {10};
Physical Surface("Outer", 8) = {20};

Physical Point("Bore_x", 9) = {11};   // on the axis y = 0: r = a
Physical Point("Inner_x", 10) = {12}; // r = b of Inner
Physical Point("Outer_x", 11) = {21}; // r = b of Outer
Physical Point("Outside_x", 12) = {22};

// ------------------------------------------------------------------- options

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.SubdivisionAlgorithm = 0;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
