// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The square of square.geo, a layer of hexahedra thick.
//
//   gmsh -3 -format msh41 -o square_extruded.msh square_extruded.geo

layers = 1;
Include "square.geo";
