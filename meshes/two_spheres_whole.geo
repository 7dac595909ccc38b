// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The whole of the spheres of two_spheres.geo, for torsion. The mesh next to
// this file is written, in this directory, by
//
//   gmsh -3 -format msh41 -o two_spheres_whole.msh two_spheres_whole.geo

shown = 4;
lower = 4;
upper = 3;
around = 8;
ratio = 2;
Include "two_spheres.geo";
