// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Two halves of spheres that touch in the origin, the one above the other, for
// contact of Hertz: a quarter of them, x, y > 0, or as many quadrants as set
// before. Radius 400 mm; in 4/3 of a radius of contact of 1 mm the lower sphere
// has four edges and the upper one five, so that the meshes do not match.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -3 -format msh41 -o two_spheres.msh two_spheres.geo
//
// The boundaries are spheres: Lower_contact, Lower_surface: 0, 0, -400, 400;
// Upper_contact, Upper_surface: 0, 0, 400, 400.

Include "hemisphere.macro";
DefineConstant[ shown = 1, lower = 4, upper = 5, around = 12, ratio = 1.65 ];

quadrants = shown;
R = 400;
s = 4 / 3;
layers = around;
growth = ratio;

base = 1000;
up = -1;
n = lower;
Call Hemisphere;

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Point("Lower_pole", 1) = {base};
Physical Point("Lower_centre", 2) = {base + 2};
Physical Surface("Lower_contact", 3) = {poleFaces[]};
Physical Surface("Lower_surface", 4) = {sphereFaces[]};
Physical Surface("Bottom", 5) = {topFaces[]}; // through the centre
Physical Volume("Lower", 6) = {bodyVolumes[]};
planes[] = {firstPlane[], lastPlane[]};

base = 2000;
up = 1;
n = upper;
Call Hemisphere;
Physical Point("Upper_pole", 7) = {base};
Physical Point("Upper_centre", 8) = {base + 2};
Physical Surface("Upper_contact", 9) = {poleFaces[]};
Physical Surface("Upper_surface", 10) = {sphereFaces[]};
Physical Surface("Top", 11) = {topFaces[]};
Physical Volume("Upper", 12) = {bodyVolumes[]};
planes[] += {firstPlane[], lastPlane[]};

If (quadrants == 1)
  Physical Surface("Plane_y", 13) = {planes[{0 : 2, 6 : 8}]};   // y = 0
  Physical Surface("Plane_x", 14) = {planes[{3 : 5, 9 : 11}]};  // x = 0
EndIf
If (quadrants == 2)
  Physical Surface("Plane_y", 13) = {planes[]};
EndIf
If (quadrants == 4)
  Physical Point("East", 15) = {base + 12};       // x = R of the upper sphere
  Physical Point("West", 16) = {base + 92};       // x = -R
  Physical Point("East_inner", 17) = {base + 13}; // x = 0.55 R, in the Top
EndIf
