// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The sphere of sphere.geo as a quarter in space, x, y > 0: radius 30 mm, and
// four edges in 4/3 of the radius of contact of 1.732 mm. Made by
//
//   gmsh -3 -format msh41 -o sphere_quarter_30.msh sphere_quarter_30.geo
//
// The boundaries are a sphere: Contact, Surface: 0, 0, 30, 30.

R = 30;
s = 4 / 3 * Sqrt(R * 0.1);
layers = 6;
growth = 1.5;
Include "sphere_quarter.geo";
