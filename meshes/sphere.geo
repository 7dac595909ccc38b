// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The lower half of a sphere for contact at its lowest point (Hertz): the
// section x >= 0, x is the radius, y the axis. Lengths in mm, first-order
// cells, all quadrangles and counter-clockwise; no free mesher takes part.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o sphere.msh sphere.geo
//
// The arc Surface is about the centre: Surface: 0, 30, 30.

// ---------------------------------------------------------------- parameters

DefineConstant[
  R = 30,         // of the sphere
  approach = 0.1, // for the radius of contact
  depth = 15,     // where the outer block ends on the plane through the centre
  m = 14,         // edges from the fine block to the plane through the centre
  q = 1.2         // how these grow
]; // unless set before
a     = Sqrt(R * approach);
s     = 2 * a;         // size of the fine block at the contact
nx    = 20;  // edges of the fine block along the surface, two in a/5
ny    = 14;  // and into the depth

// -------------------------------------------------------------------- sphere

alpha = Asin(s / R); // where the fine block ends on the surface
Point(1) = {0, R, 0};                                // centre
Point(2) = {0, 0, 0};                                // contact
Point(3) = {R * Sin(alpha), R - R * Cos(alpha), 0};
Point(4) = {s, s + R - R * Cos(alpha), 0};
Point(5) = {0, s, 0};
Point(6) = {R, R, 0};
Point(7) = {depth, R, 0};

// Nodes at r = 0.2 a, 0.4 a, 0.6 a, 0.8 a.
For k In {1 : 4}
  beta = Asin(0.2 * k * a / R);
  Point(10 + k) = {R * Sin(beta), R - R * Cos(beta), 0};
EndFor
Circle(11) = {2, 1, 11};
Circle(12) = {11, 1, 12};
Circle(13) = {12, 1, 13};
Circle(14) = {13, 1, 14};
Circle(15) = {14, 1, 3};
Line(2)   = {3, 4};
Line(3)   = {5, 4};
Line(4)   = {2, 5};
Circle(5) = {3, 1, 6};
Line(6)   = {6, 7};
Line(7)   = {4, 7};
Line(8)   = {1, 7};
Line(9)   = {5, 1};

Transfinite Curve {11 : 14} = 3;
Transfinite Curve {15} = nx - 8 + 1;
Transfinite Curve {3, 8} = nx + 1;
Transfinite Curve {2, 4, 6} = ny + 1;
Transfinite Curve {5, 7, 9} = m + 1 Using Progression q;

Curve Loop(1) = {11 : 15, 2, -3, -4}; // at the contact
Curve Loop(2) = {5, 6, -7, -2};  // along the surface
Curve Loop(3) = {3, 7, -8, -9};  // along the axis

For i In {1 : 3}
  Plane Surface(i) = {i};
  Recombine Surface {i};
EndFor
Transfinite Surface {1} = {2, 3, 4, 5};
Transfinite Surface {2, 3};

// ----------------------------------------------------------- physical groups

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Point("Contact", 1) = {2};
Physical Point("Centre", 2) = {1};

Physical Curve("Axis", 3) = {4, 9};
Physical Curve("Surface", 4) = {11 : 15, 5};
Physical Curve("Top", 5) = {6, 8}; // the plane through the centre

Physical Surface("Sphere", 6) = {1 : 3};

For k In {1 : 4}
  Physical Point(Sprintf("r0.%g", 2 * k), 6 + k) = {10 + k};
EndFor

// ------------------------------------------------------------------- options

// The defaults, repeated because a user's own gmsh settings would otherwise
// change the mesh.
Mesh.Smoothing = 1;
Mesh.SubdivisionAlgorithm = 0;
Mesh.FlexibleTransfinite = 0;
Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
