// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A punch of square section, off the middle of a block. Hexahedra; lengths in mm.
//   gmsh -3 -format msh41 square_punch.geo

width  = 6; // of the block
height = 2;
side   = 2; // of the punch
top    = 1;

Point(1) = {-width/2, -width/2, -height};
l[] = Extrude {width, 0, 0} { Point{1}; Layers{6}; };
s[] = Extrude {0, width, 0} { Curve{l[1]}; Layers{6}; Recombine; };
b[] = Extrude {0, 0, height} { Surface{s[1]}; Layers{3}; Recombine; };

p = newp;
Point(p) = {-1.1, -0.9, 0};
m[] = Extrude {side, 0, 0} { Point{p}; Layers{4}; };
t[] = Extrude {0, side, 0} { Curve{m[1]}; Layers{4}; Recombine; };
u[] = Extrude {0, 0, top} { Surface{t[1]}; Layers{2}; Recombine; };

Physical Volume("Block", 1) = {b[1]};
Physical Volume("Punch", 2) = {u[1]};
Physical Surface("Base", 3) = {s[1]};
Physical Surface("Ground", 4) = {b[0]};  // master
Physical Surface("Sole", 5) = {t[1]};    // slave
Physical Surface("Head", 6) = {u[0]};
Physical Point("Corner", 7) = {p};

Mesh.ElementOrder = 1;
