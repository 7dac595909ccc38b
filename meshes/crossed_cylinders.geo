// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Two cylinders that cross at a right angle and touch in the origin: the quarter
// x, y > 0 of the half of each at the other, for an elliptical contact with the
// half axes a = 1.49 mm along x and b = 0.94 mm along y. Of each the section is
// meshed, fine at the contact, and extruded along the axis; the meshes do not
// match. gmsh makes one point of two at the same place when it extrudes: the
// upper cylinder is 1 mm too high, to be moved by the case.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -3 -format msh41 -o crossed_cylinders.msh crossed_cylinders.geo
//
// The boundaries are cylinders: Lower_contact, Lower_surface:
// 0, 0, -800, 0, 1, 0, 800; Upper_contact, Upper_surface:
// 0, 0, 401, 1, 0, 0, 400.

fineX = 2;    // the fine block: 4/3 a, 4/3 b, and in the depth
fineY = 1.25;
fineZ = 1.5;
above = 1;     // the upper cylinder

// Call HalfCylinder: half a cylinder of radius R, above its contact (up = 1) or
// below (-1), from x = 0 (alongX = 1) or y = 0 to the length R, with n edges in
// each direction of the fine block and layers of cells around it. Leaves the
// lists bodyVolumes, poleFaces, roundFaces, topFaces, axisFaces (the plane
// through the axis and the contact), startFaces.
Macro HalfCylinder
  If (alongX == 1)
    width = fineY;
    step = fineX;
  Else
    width = fineX;
    step = fineY;
  EndIf
  drop = R - Sqrt(R * R - width * width);
  across[] = {0, 0, width, width, R, 0.55 * R, 0};
  high[] = {0, fineZ, drop, drop + fineZ, R, R, R};
  For k In {0 : 6}
    Point(base + k) = {(1 - alongX) * across[k], alongX * across[k],
                       up * high[k] + shift};
  EndFor
  Line(base)       = {base, base + 1};
  Circle(base + 1) = {base, base + 6, base + 2};
  Line(base + 2)   = {base + 1, base + 3};
  Line(base + 3)   = {base + 2, base + 3};
  Circle(base + 4) = {base + 2, base + 6, base + 4};
  Line(base + 5)   = {base + 3, base + 5};
  Line(base + 6)   = {base + 1, base + 6};
  Line(base + 7)   = {base + 4, base + 5};
  Line(base + 8)   = {base + 6, base + 5};
  Transfinite Curve {base : base + 3, base + 7, base + 8} = n + 1;
  Transfinite Curve {base + 4 : base + 6} = layers + 1 Using Progression growth;
  Curve Loop(base)     = {base + 1, base + 3, -(base + 2), -base};
  Curve Loop(base + 1) = {base + 4, base + 7, -(base + 5), -(base + 3)};
  Curve Loop(base + 2) = {base + 2, base + 5, -(base + 8), -(base + 6)};
  startFaces[] = {base : base + 2};
  For k In {base : base + 2}
    Plane Surface(k) = {k};
  EndFor
  Transfinite Surface {startFaces[]};
  Recombine Surface {startFaces[]};

  // Heights of the layers along the axis: n equal ones, then growing ones.
  number[] = {n};
  height[] = {step / R};
  thickness = (1 - step / R) * (growth - 1) / (growth^layers - 1);
  For k In {1 : layers}
    number[] += {1};
    height[] += {height[k - 1] + thickness * growth^(k - 1)};
  EndFor
  height[layers] = 1;
  bodyVolumes[] = {};
  sides[] = {};
  For k In {base : base + 2}
    e[] = Extrude {alongX * R, (1 - alongX) * R, 0} {
      Surface {k}; Layers {number[], height[]}; Recombine;
    };
    bodyVolumes[] += {e[1]};
    sides[] += {e[{2 : 5}]};
  EndFor
  // In the order of the curves of each loop.
  contactFaces[] = {sides[0]};
  roundFaces[] = {sides[4]};
  topFaces[] = {sides[5], sides[10]};
  axisFaces[] = {sides[3], sides[11]};
Return

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
base = 1000;
R = 800;
shift = 0;
up = -1;
alongX = 0;
n = 4;
layers = 11;
growth = 1.8;
Call HalfCylinder;
Physical Point("Lower_pole", 1) = {base};
Physical Surface("Lower_contact", 2) = {contactFaces[]};
Physical Surface("Lower_surface", 3) = {roundFaces[]};
Physical Surface("Bottom", 4) = {topFaces[]}; // through the axis
Physical Volume("Lower", 5) = {bodyVolumes[]};
planeX[] = {axisFaces[]};
planeY[] = {startFaces[]};

base = 2000;
R = 400;
shift = above;
up = 1;
alongX = 1;
n = 3;
layers = 11;
growth = 1.8;
Call HalfCylinder;
Physical Point("Upper_pole", 6) = {base};
Physical Surface("Upper_contact", 7) = {contactFaces[]};
Physical Surface("Upper_surface", 8) = {roundFaces[]};
Physical Surface("Top", 9) = {topFaces[]};
Physical Volume("Upper", 10) = {bodyVolumes[]};
planeX[] += {startFaces[]};
planeY[] += {axisFaces[]};
Physical Surface("Plane_x", 11) = {planeX[]}; // x = 0
Physical Surface("Plane_y", 12) = {planeY[]}; // y = 0

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.SubdivisionAlgorithm = 0;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
