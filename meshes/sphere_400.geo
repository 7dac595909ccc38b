// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The mesh of sphere.geo for a sphere of 400 mm and a radius of contact of 1 mm,
// that of sphere_quarter.geo. Made by
//
//   gmsh -3 -format msh41 -o sphere_400.msh sphere_400.geo
//
// The arc Surface is about the centre: Surface: 0, 400, 400.

R = 400;
approach = 0.0025;
depth = 200;
m = 40;
q = 1.15;
Include "sphere.geo";
