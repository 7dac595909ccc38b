// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A hollow sphere in a hollow sphere about the origin, as rings.geo has it in the
// plane: the octant x, y, z > 0, a coarse mesh to be refined by the program. The
// spheres touch on a sphere and share no node; their cells do not match there.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -3 -format msh41 -o thick_spheres.msh thick_spheres.geo
//
// The boundaries are spheres about the origin: Bore: 0, 0, 0, 20; Inner_out and
// Outer_in: 50; Outside: 100.

a = 20;  // inner radius of the inner sphere
b = 50;  // radius of the contact
c = 100; // outer radius of the outer sphere
nInner = 3; // edges in half a quarter of a circle
nOuter = 4;
mInner = 3; // layers
mOuter = 2;

// Call Shell: the octant between the radii `from` and `to`, in three blocks
// around the direction (1, 1, 1), with `around` edges and `layers` layers, whose
// thicknesses grow with the radius. The numbers of its parts start at `base`.
Macro Shell
  Point(base) = {0, 0, 0}; // centre, for the arcs only
  growth = (to / from)^(1 / layers);
  // The directions of three axes, of the middles between them, and the diagonal.
  For k In {0 : 6}
    one = 1;
    two = 0;
    three = 0;
    If (k > 2)
      two = 1;
    EndIf
    If (k == 6)
      three = 1;
    EndIf
    size = Sqrt(one + two + three);
    // Turned cyclically: axis k, or the middle of the axes k and k + 1.
    v[] = {one, two, three, one, two};
    shift = (3 - k % 3) % 3;
    x[] = {v[shift], v[shift + 1], v[shift + 2]};
    inside = from / size;
    outside = to / size;
    Point(base + 1 + k)  = {inside * x[0], inside * x[1], inside * x[2]};
    Point(base + 11 + k) = {outside * x[0], outside * x[1], outside * x[2]};
    Line(base + 1 + k)   = {base + 1 + k, base + 11 + k};
    Transfinite Curve {base + 1 + k} = layers + 1 Using Progression growth;
  EndFor
  // Arcs from the axis k to the middles before and after it, and from the middle
  // to the diagonal, with the surfaces below them along the radius.
  For k In {0 : 2}
    ends[] = {k, 3 + k, k, 3 + (k + 2) % 3, 3 + k, 6};
    For i In {0 : 2}
      j = base + 20 + 10 * k + i;
      first = base + 1 + ends[2 * i];
      last = base + 1 + ends[2 * i + 1];
      Circle(j)       = {first, base, last};
      Circle(j + 100) = {first + 10, base, last + 10};
      Transfinite Curve {j, j + 100} = around + 1;
      Curve Loop(j) = {j, last, -(j + 100), -first};
      Plane Surface(j) = {j};
    EndFor
  EndFor
  bodyVolumes[] = {};
  insideFaces[] = {};
  outsideFaces[] = {};
  planes[] = {};
  For k In {0 : 2}
    j = base + 20 + 10 * k;
    before = base + 22 + 10 * ((k + 2) % 3);
    For i In {0 : 1}
      Curve Loop(j + 3 + i) = {j + 100 * i, j + 2 + 100 * i,
                               -(before + 100 * i), -(j + 1 + 100 * i)};
      Surface(j + 3 + i) = {j + 3 + i} In Sphere {base};
    EndFor
    Surface Loop(j) = {j, j + 1, j + 2, before, j + 3, j + 4};
    Volume(j) = {j};
    bodyVolumes[] += {j};
    insideFaces[] += {j + 3};
    outsideFaces[] += {j + 4};
    planes[] += {j, base + 21 + 10 * ((k + 1) % 3)}; // axes k and k + 1
    Transfinite Surface {j : j + 4};
    Recombine Surface {j : j + 4};
  EndFor
  Transfinite Volume {bodyVolumes[]};
  Recombine Volume {bodyVolumes[]};
Return

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
base = 1000;
from = a;
to = b;
around = nInner;
layers = mInner;
Call Shell;
Physical Point("Bore_x", 1) = {base + 1};   // on the axis x: r = a
Physical Point("Inner_x", 2) = {base + 11}; // r = b of Inner
Physical Surface("Bore", 3) = {insideFaces[]};
Physical Surface("Inner_out", 4) = {outsideFaces[]};
Physical Volume("Inner", 5) = {bodyVolumes[]};
all[] = {planes[]};

base = 2000;
from = b;
to = c;
around = nOuter;
layers = mOuter;
Call Shell;
Physical Point("Outer_x", 6) = {base + 1};
Physical Point("Outside_x", 7) = {base + 11};
Physical Surface("Outer_in", 8) = {insideFaces[]};
Physical Surface("Outside", 9) = {outsideFaces[]};
Physical Volume("Outer", 10) = {bodyVolumes[]};
all[] += {planes[]};

Physical Surface("Plane_z", 11) = {all[{0, 1, 6, 7}]}; // z = 0
Physical Surface("Plane_x", 12) = {all[{2, 3, 8, 9}]};
Physical Surface("Plane_y", 13) = {all[{4, 5, 10, 11}]};

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.SubdivisionAlgorithm = 0;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
