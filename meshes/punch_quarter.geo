// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A quarter of the punch with a rounded edge on its foundation (punch.geo, NAFEMS
// contact benchmark 2) in space: x, y >= 0, z is the axis. The bodies touch at
// z = 0 and share no node. Hexahedra; lengths in mm.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -3 -format msh41 -o punch_quarter.msh punch_quarter.geo
//
// The boundaries are a torus and cylinders about the axis.

flat = 40;  // radius of the flat of the punch
R    = 10;  // of the fillet
H    = 100; // height of the punch
Rf   = 100; // radius of the foundation
Hf   = 200; // and its height
rP   = 45;  // where the radial displacement is asked for
core = 5;   // side of the block at the centre of the fillet
hand = 4;   // both coordinates of its corner, from there
n    = 4;   // edges in 45 degrees

// The quadrangles of a quarter of a disc around the axis, up to the radius
// radius: three about the axis, up to middle, and two around them.
// ---------------------------------------------------------------------
// In: z, middle, radius, nRadial. Out: disc[]; p, l: the first point and curve.
Macro QuarterDisc
  p = newp;
  s = 0.55 * middle;
  c = Cos(Pi / 4);
  Point(p)     = {0, 0, z};
  Point(p + 1) = {s, 0, z};
  Point(p + 2) = {0.9 * s, 0.9 * s, z};
  Point(p + 3) = {0, s, z};
  Point(p + 4) = {middle, 0, z};
  Point(p + 5) = {middle * c, middle * c, z};
  Point(p + 6) = {0, middle, z};
  Point(p + 7) = {radius, 0, z};
  Point(p + 8) = {radius * c, radius * c, z};
  Point(p + 9) = {0, radius, z};
  l = newl;
  Line(l)        = {p, p + 1};
  Line(l + 1)    = {p + 1, p + 2};
  Line(l + 2)    = {p + 2, p + 3};
  Line(l + 3)    = {p + 3, p};
  Line(l + 4)    = {p + 1, p + 4};
  Line(l + 5)    = {p + 2, p + 5};
  Line(l + 6)    = {p + 3, p + 6};
  Circle(l + 7)  = {p + 4, p, p + 5};
  Circle(l + 8)  = {p + 5, p, p + 6};
  Line(l + 9)    = {p + 4, p + 7};
  Line(l + 10)   = {p + 5, p + 8};
  Line(l + 11)   = {p + 6, p + 9};
  Circle(l + 12) = {p + 7, p, p + 8};
  Circle(l + 13) = {p + 8, p, p + 9};
  Transfinite Curve {l, l + 1, l + 2, l + 3, l + 7, l + 8, l + 12, l + 13} = n + 1;
  Transfinite Curve {l + 4, l + 5, l + 6} = nMiddle + 1;
  Transfinite Curve {l + 9, l + 10, l + 11} = nRadial + 1;
  disc[] = {};
  f = news;
  Curve Loop(f)     = {l, l + 1, l + 2, l + 3};
  Curve Loop(f + 1) = {l + 4, l + 7, -(l + 5), -(l + 1)};
  Curve Loop(f + 2) = {l + 5, l + 8, -(l + 6), -(l + 2)};
  Curve Loop(f + 3) = {l + 9, l + 12, -(l + 10), -(l + 7)};
  Curve Loop(f + 4) = {l + 10, l + 13, -(l + 11), -(l + 8)};
  For k In {0:4}
    Plane Surface(f + k) = {f + k};
    Transfinite Surface {f + k};
    Recombine Surface {f + k};
    disc[] += {f + k};
  EndFor
Return

// --------------------------------------------------------------------- punch

z = 0;
middle = 20;
radius = flat;
nMiddle = 2;
nRadial = 4;
Call QuarterDisc;
sole[] = disc[];
punchCentre = p;
punch[] = {};
bottom[] = sole[];
heights[] = {core, R - core, H - R};
layers[]  = {1, 2, 9};
For step In {0:2}
  top[] = {};
  For k In {0:4}
    e[] = Extrude {0, 0, heights[step]} {
      Surface{bottom[k]}; Layers{layers[step]}; Recombine;
    };
    top[] += {e[0]};
    punch[] += {e[1]};
  EndFor
  bottom[] = top[];
EndFor
load[] = top[];

// The section beyond the flat, turned about the axis in two steps.
p = newp;
Point(p)      = {flat, 0, 0};
Point(p + 1)  = {flat, 0, R};
Point(p + 2)  = {flat + R * Sin(Pi / 4), 0, R - R * Cos(Pi / 4)};
Point(p + 3)  = {flat + R, 0, R};
Point(p + 4)  = {flat, 0, core};
Point(p + 5)  = {flat + hand, 0, R - hand};
Point(p + 6)  = {flat + core, 0, R};
Point(p + 7)  = {flat, 0, H};
Point(p + 8)  = {flat + core, 0, H};
Point(p + 9)  = {flat + R, 0, H};
l = newl;
Circle(l)      = {p, p + 1, p + 2};
Circle(l + 1)  = {p + 2, p + 1, p + 3};
Line(l + 2)    = {p, p + 4};
Line(l + 3)    = {p + 4, p + 1};
Line(l + 4)    = {p + 2, p + 5};
Line(l + 5)    = {p + 4, p + 5};
Line(l + 6)    = {p + 5, p + 6};
Line(l + 7)    = {p + 1, p + 6};
Line(l + 8)    = {p + 3, p + 6};
Line(l + 9)    = {p + 1, p + 7};
Line(l + 10)   = {p + 6, p + 8};
Line(l + 11)   = {p + 3, p + 9};
Line(l + 12)   = {p + 7, p + 8};
Line(l + 13)   = {p + 8, p + 9};
Transfinite Curve {l, l + 1, l + 3, l + 5, l + 6, l + 7, l + 12} = 3;
Transfinite Curve {l + 2, l + 4, l + 8, l + 13} = 2;
Transfinite Curve {l + 9, l + 10, l + 11} = 10;
f = news;
Curve Loop(f)     = {l, l + 4, -(l + 5), -(l + 2)};
Curve Loop(f + 1) = {l + 1, l + 8, -(l + 6), -(l + 4)};
Curve Loop(f + 2) = {l + 5, l + 6, -(l + 7), -(l + 3)};
Curve Loop(f + 3) = {l + 7, l + 10, -(l + 12), -(l + 9)};
Curve Loop(f + 4) = {l + 11, -(l + 13), -(l + 10), -(l + 8)};
section[] = {};
For k In {0:4}
  Plane Surface(f + k) = {f + k};
  Transfinite Surface {f + k};
  Recombine Surface {f + k};
  section[] += {f + k};
EndFor
Coherence;
fillet[] = {};
side[] = {};
For step In {0:1}
  next[] = {};
  For k In {0:4}
    e[] = Extrude {{0, 0, 1}, {0, 0, 0}, Pi / 4} {
      Surface{section[k]}; Layers{n}; Recombine;
    };
    next[] += {e[0]};
    punch[] += {e[1]};
    // The sides follow the curves of the loop.
    If(k < 2)
      fillet[] += {e[2]};
    ElseIf(k == 3)
      load[] += {e[4]};
    ElseIf(k == 4)
      load[] += {e[3]};
      side[] += {e[2]};
    EndIf
  EndFor
  section[] = next[];
EndFor
Coherence;

// ---------------------------------------------------------------- foundation

apart = -2 * Hf; // where the two share no point, until all is made
z = apart;
middle = 22;
radius = rP;
nMiddle = 2;
nRadial = 5;
Call QuarterDisc;
ground[] = disc[];
groundCentre = p;
groundAt45 = p + 7;

q = newp;
Point(q)     = {Rf, 0, z};
Point(q + 1) = {Rf * c, Rf * c, z};
Point(q + 2) = {0, Rf, z};
m = newl;
Line(m)       = {p + 7, q};
Line(m + 1)   = {p + 8, q + 1};
Line(m + 2)   = {p + 9, q + 2};
Circle(m + 3) = {q, p, q + 1};
Circle(m + 4) = {q + 1, p, q + 2};
Transfinite Curve {m, m + 1, m + 2} = 7;
Transfinite Curve {m + 3, m + 4} = n + 1;
f = news;
Curve Loop(f)     = {m, m + 3, -(m + 1), -(l + 12)};
Curve Loop(f + 1) = {m + 1, m + 4, -(m + 2), -(l + 13)};
For k In {0:1}
  Plane Surface(f + k) = {f + k};
  Transfinite Surface {f + k};
  Recombine Surface {f + k};
  ground[] += {f + k};
EndFor
foundation[] = {};
base[] = {};
e[] = Extrude {0, 0, -Hf} { Surface{ground[]}; Layers{20}; Recombine; };
For k In {0:6}
  base[] += {e[6 * k]};
  foundation[] += {e[6 * k + 1]};
EndFor

Geometry.AutoCoherence = 0; // else the two would share the centre
Translate {0, 0, -apart} { Volume{foundation[]}; }

// ----------------------------------------------------------- physical groups

eps = 1e-6;
planeX[] = Surface In BoundingBox{-eps, -eps, -Hf - eps, eps, Rf + eps, H + eps};
planeY[] = Surface In BoundingBox{-eps, -eps, -Hf - eps, Rf + eps, eps, H + eps};

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Point("Foundation_centre", 1) = {groundCentre};
Physical Point("Foundation_45", 2) = {groundAt45};
Physical Surface("Plane_x", 3) = {planeX[]}; // x = 0
Physical Surface("Plane_y", 4) = {planeY[]}; // y = 0
Physical Surface("Punch_bottom", 5) = {sole[], fillet[]};
Physical Surface("Fillet", 6) = {fillet[]};
Physical Surface("Side", 7) = {side[]};
Physical Surface("Load", 8) = {load[]};
Physical Surface("Foundation_top", 9) = {ground[]};
Physical Surface("Base", 10) = {base[]};
Physical Volume("Punch", 11) = {punch[]};
Physical Volume("Foundation", 12) = {foundation[]};

Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
