// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A slice of a tube in a tube, the section x >= 0 of which is meshed: x is the
// radius, y the axis. The tubes touch and share no node; their edges do not
// match there. Lengths in mm, first-order cells, all quadrangles and
// counter-clockwise; no free mesher takes part.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o tubes.msh tubes.geo

// ---------------------------------------------------------------- parameters

a      = 20;  // bore
b      = 50;  // radius of the contact
c      = 100; // outer radius
height = 20;
nInner = 2;   // edges along the axis
nOuter = 3;
mInner = 6;   // layers of the inner tube
mOuter = 6;   // and of the outer one

// --------------------------------------------------------------------- tubes

// A tube from the radius `from` to the radius `to`, whose layers grow with the
// radius. The numbers of its parts start at `base`.
Macro Tube
  Point(base + 1) = {from, 0, 0};
  Point(base + 2) = {to, 0, 0};
  Point(base + 3) = {to, height, 0};
  Point(base + 4) = {from, height, 0};

  Line(base + 1) = {base + 1, base + 2};
  Line(base + 2) = {base + 2, base + 3};
  Line(base + 3) = {base + 4, base + 3};
  Line(base + 4) = {base + 1, base + 4};

  growth = (to / from)^(1 / layers);
  Transfinite Curve {base + 1, base + 3} = layers + 1 Using Progression growth;
  Transfinite Curve {base + 2, base + 4} = along + 1;

  Curve Loop(base)    = {base + 1, base + 2, -(base + 3), -(base + 4)};
  Plane Surface(base) = {base};
  Transfinite Surface {base};
  Recombine Surface {base};
Return

base = 10;
from = a;
to = b;
along = nInner;
layers = mInner;
Call Tube;

base = 20;
from = b;
to = c;
along = nOuter;
layers = mOuter;
Call Tube;

// ----------------------------------------------------------- physical groups

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Curve("Ends", 1) = {11, 13, 21, 23}; // y = 0 and y = height
Physical Curve("Bore", 2) = {14};             // x = a
Physical Curve("Inner_out", 3) = {12};        // x = b of Inner
Physical Curve("Outer_in", 4) = {24};         // x = b of Outer
Physical Curve("Outside", 5) = {22};          // x = c

Physical Surface("Inner", 6) = {10};
Physical Surface("Outer", 7) = {20};

Physical Point("Bore_x", 8) = {11};
Physical Point("Inner_x", 9) = {12};
Physical Point("Outer_x", 10) = {21};
Physical Point("Outside_x", 11) = {22};

// ------------------------------------------------------------------- options

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.SubdivisionAlgorithm = 0;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
