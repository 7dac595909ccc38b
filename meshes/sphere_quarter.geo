// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A quarter of the lower half of a sphere for contact at its lowest point
// (Hertz), x, y > 0: radius 400 mm, and four edges in 4/3 of a radius of contact
// of 1 mm, to be refined by the program.
//
// Made for gmsh 4.8.4; the mesh next to this file is written, in this
// directory, by
//
//   gmsh -3 -format msh41 -o sphere_quarter.msh sphere_quarter.geo
//
// The boundaries are a sphere: Contact, Surface: 0, 0, 400, 400.

Include "hemisphere.macro";
DefineConstant[ R = 400, s = 4 / 3, layers = 12, growth = 1.65 ]; // unless set

base = 1000;
up = 1;
quadrants = 1;
n = 4;
Call Hemisphere;

// The numbers are unique over all dimensions, so that an id in the program
// names one group only.
Physical Point("Pole", 1) = {base};
Physical Point("Centre", 2) = {base + 2};
Physical Surface("Plane_y", 3) = {firstPlane[]}; // y = 0
Physical Surface("Plane_x", 4) = {lastPlane[]};  // x = 0
Physical Surface("Contact", 5) = {poleFaces[]};
Physical Surface("Surface", 6) = {sphereFaces[]};
Physical Surface("Top", 7) = {topFaces[]}; // the plane through the centre
Physical Volume("Sphere", 8) = {bodyVolumes[]};
