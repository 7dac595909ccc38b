// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A cube of one cell whose corner at the origin is lower by 0.1: the one node that
// touches a plane there. Lengths in mm.
//   gmsh -3 -format msh41 pointed_cell.geo

Point(1) = {0, 0, -0.1};
Point(2) = {1, 0, 0};
Point(3) = {1, 1, 0};
Point(4) = {0, 1, 0};
Point(5) = {0, 0, 1};
Point(6) = {1, 0, 1};
Point(7) = {1, 1, 1};
Point(8) = {0, 1, 1};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 8}; Line(8) = {8, 5};
Line(9) = {1, 5}; Line(10) = {2, 6}; Line(11) = {3, 7}; Line(12) = {4, 8};
Curve Loop(1) = {1, 2, 3, 4};    Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, 8};    Plane Surface(2) = {2};
Curve Loop(3) = {1, 10, -5, -9}; Plane Surface(3) = {3};
Curve Loop(4) = {2, 11, -6, -10}; Plane Surface(4) = {4};
Curve Loop(5) = {3, 12, -7, -11}; Plane Surface(5) = {5};
Curve Loop(6) = {4, 9, -8, -12}; Plane Surface(6) = {6};
Surface Loop(1) = {1, 2, 3, 4, 5, 6};
Volume(1) = {1};
Transfinite Curve {1:12} = 2;
Transfinite Surface {1:6};
Recombine Surface {1:6};
Transfinite Volume {1};

Physical Volume("Cell", 1) = {1};
Physical Surface("Below", 2) = {1}; // slave
Physical Surface("Above", 3) = {2};
Physical Point("Tip", 4) = {1};
Physical Point("B", 5) = {2};
Physical Point("C", 6) = {3};
Physical Point("D", 7) = {4};

Mesh.ElementOrder = 1;
