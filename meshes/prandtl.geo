// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A block under a flat punch of the half width 1, of which the half x >= 0 is
// meshed: rectangles that get smaller towards the edge of the punch. Lengths in
// mm.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -2 -format msh41 -o prandtl.msh prandtl.geo

width  = 6;
height = 5;
b      = 1;
n1     = 8;  // edges under the punch,
n2     = 16; // beside it,
n3     = 16; // and along the depth

Point(1) = {0, 0, 0};
Point(2) = {b, 0, 0};
Point(3) = {width, 0, 0};
Point(4) = {width, -height, 0};
Point(5) = {b, -height, 0};
Point(6) = {0, -height, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {2, 5};
Transfinite Curve {1} = n1 + 1 Using Progression 1/1.25;
Transfinite Curve {5} = n1 + 1 Using Progression 1.25;
Transfinite Curve {2} = n2 + 1 Using Progression 1.2;
Transfinite Curve {4} = n2 + 1 Using Progression 1/1.2;
Transfinite Curve {3, 7} = n3 + 1 Using Progression 1.2;
Transfinite Curve {6} = n3 + 1 Using Progression 1/1.2;
Curve Loop(1)    = {1, 7, 5, 6};
Plane Surface(1) = {1};
Curve Loop(2)    = {2, 3, 4, -7};
Plane Surface(2) = {2};
Transfinite Surface {1, 2};
Recombine Surface {1, 2};

Physical Curve("Punch", 1)  = {1};
Physical Curve("Axis", 2)   = {6};
Physical Curve("Bottom", 3) = {4, 5};
Physical Curve("Side", 4)   = {3};
Physical Surface("Block", 5) = {1, 2};

Mesh.ElementOrder = 1;
Mesh.Binary = 0;
Mesh.SaveAll = 0; // only elements of physical groups
