// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The rings of rings.geo with the same edges on both sides of the contact: what
// the nodal rule can do where meshes match. Made by
//
//   gmsh -2 -format msh41 -o rings_matching.msh rings_matching.geo

nOuter = 4;
Include "rings.geo";
