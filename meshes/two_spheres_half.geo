// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Half of the spheres of two_spheres.geo, y > 0, for loads in direction x. The
// mesh next to this file is written, in this directory, by
//
//   gmsh -3 -format msh41 -o two_spheres_half.msh two_spheres_half.geo

shown = 2;
lower = 4;
upper = 3;
around = 12;
ratio = 1.65;
Include "two_spheres.geo";
