#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of hexahedra and tetrahedra from elsewhere.

Proves that meshes/convert.py keeps what a MED file says of two blocks of
hexahedra of 8, 20 and 27 nodes, written by the library of that format: names,
the results of the own mesh file, and nodes where gmsh's order has them (as meshio
reads them). Volumes are in two groups, a point is a group of one node. Spheres,
cylinders and cones that groups of faces are get their numbers; those of a
paraboloid become flat, which it says. An Abaqus file keeps its names; wedges are
taken. Tetrahedra of 10 nodes, numbered in MED's sense, keep their sphere and
their middles of sides.

Usage: convert_space.py CONTACT
"""

import itertools
import math
import pathlib
import sys

try:
    import convert as plane  # exits where a module is missing
    import meshio
    import numpy
    from med.medenum import (MED_HEXA8, MED_HEXA20, MED_HEXA27, MED_PENTA6,
                             MED_QUAD4, MED_QUAD8, MED_QUAD9, MED_TETRA10,
                             MED_TRIA6)
    from med_files import write_med
except ImportError as missing:
    print(f"skipped: {missing}; apt-get install python3-meshio python3-h5py "
          "python3-med")
    sys.exit(0)
from abaqus import middles_are_right
from abaqus_scenes import Tetrahedra
from convert import check, compare, convert, refuse, results

# As MED numbers the nodes of hexahedra, on a lattice of three nodes a side.
SOLID = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2),
         (2, 2, 2), (0, 2, 2), (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0),
         (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2), (0, 0, 1), (2, 0, 1),
         (2, 2, 1), (0, 2, 1), (1, 1, 0), (1, 0, 1), (2, 1, 1), (1, 2, 1),
         (0, 1, 1), (1, 1, 2), (1, 1, 1)]
SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1), (1, 1)]
SOLIDS = {8: {"hexahedron": MED_HEXA8, "quad": MED_QUAD4},
          20: {"hexahedron": MED_HEXA20, "quad": MED_QUAD8},
          27: {"hexahedron": MED_HEXA27, "quad": MED_QUAD9}}

BLOCKS = """
subsection Mesh
  set File = own.msh
end
subsection Element
  set Degree = 1
end
subsection Solids
  set Young's modulus = Low: 1000, Up: 3000
  set Poisson's ratio = Low: 0.3, Up: 0.1
end
subsection Boundary conditions
  set Displacement x = Low_z0: 0, Up_z1: 0.01
  set Displacement y = Low_z0: 0, Up_z1: 0
  set Displacement z = Low_z0: 0, Up_z1: -0.02
end
subsection Contact
  set Slave  = Up_z0
  set Master = Low_z1
end
subsection Solution
  set Increments = 1
end
subsection Probes
  set Probes = u: displacement z, Tip; s: stress zz, Tip
end
"""

SHELLS = """*NODE
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*ELEMENT, TYPE=C3D8, ELSET=Cube
1, 1, 2, 3, 4, 5, 6, 7, 8
*ELEMENT, TYPE=S4, ELSET=Top
2, 5, 6, 7, 8
*NSET, NSET=Corner
7
"""


class Solids:
    """Blocks of hexahedra, the images of the unit cube by a chart, with the groups
    NAME, Everything, and NAME_x0 to NAME_z1 of their sides."""

    def __init__(self, n_nodes):
        self.n_nodes = n_nodes
        self.n_on_face = {8: 4, 20: 8, 27: 9}[n_nodes]
        self.points, self.elements = [], {"hexahedron": [], "quad": []}

    def block(self, name, n, chart):
        index = {}

        def node(place):
            if place not in index:
                index[place] = len(self.points)
                self.points.append([float(x) for x in chart(
                    *(p / (2 * m) for p, m in zip(place, n)))])
            return index[place]

        for first in itertools.product(*(range(0, 2 * m, 2) for m in n)):
            nodes = [node(tuple(f + a for f, a in zip(first, offset)))
                     for offset in SOLID[:self.n_nodes]]
            self.elements["hexahedron"].append((nodes, [name, "Everything"]))
        for d, end in itertools.product(range(3), range(2)):
            others = [c for c in range(3) if c != d]
            for first in itertools.product(
                    *(range(0, 2 * n[c], 2) for c in others)):
                nodes = []
                for offset in SQUARE[:self.n_on_face]:
                    place = [0, 0, 0]
                    place[d] = end * 2 * n[d]
                    for c, f, a in zip(others, first, offset):
                        place[c] = f + a
                    nodes.append(node(tuple(place)))
                self.elements["quad"].append((nodes, [f"{name}_{'xyz'[d]}{end}"]))
        return node(tuple(2 * m for m in n))


def blocks(n_nodes):
    """Two of them that touch, and the node at the tip of the upper one."""
    solids = Solids(n_nodes)
    solids.block("Low", (2, 2, 1), lambda r, s, t: (2 * r, 2 * s, t))
    tip = solids.block("Up", (3, 3, 1),
                       lambda r, s, t: (0.2 + 1.5 * r, 0.3 + 1.5 * s, 1 + t))
    return solids, tip


def solids_of_meshio(solids, tip):
    """Blocks of 8 nodes as an own mesh file, by meshio."""
    names = sorted({(3 if kind == "hexahedron" else 2, groups[0])
                    for kind, entries in solids.elements.items()
                    for _, groups in entries})
    tags = {name: tag for tag, (_, name) in enumerate(names, 1)}
    cells = [(kind, [nodes for nodes, _ in entries])
             for kind, entries in solids.elements.items()]
    physical = [[tags[groups[0]] for _, groups in entries]
                for entries in solids.elements.values()]
    cells.append(("vertex", [[tip]]))
    physical.append([len(names) + 1])
    mesh = meshio.Mesh(
        numpy.array(solids.points), [(k, numpy.array(c)) for k, c in cells],
        cell_data={key: [numpy.array(p) for p in physical]
                   for key in ("gmsh:physical", "gmsh:geometrical")},
        field_data={name: numpy.array([tags[name], d]) for d, name in names}
        | {"Tip": numpy.array([len(names) + 1, 0])})
    meshio.write("own.msh", mesh, file_format="gmsh22", binary=False)


def nodes_in_place(path):
    """Whether the nodes of straight hexahedra stand where meshio, which knows
    gmsh's order, expects them: at the means of corners."""
    edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4),
             (0, 4), (1, 5), (2, 6), (3, 7)]
    sides = [(0, 3, 4, 7), (1, 2, 5, 6), (0, 1, 4, 5), (2, 3, 6, 7),
             (0, 1, 2, 3), (4, 5, 6, 7)]
    expected = [*edges, *sides, tuple(range(8))]
    mesh = meshio.read(path)
    worst, n_cells = 0.0, 0
    for block in mesh.cells:
        for cell in block.data if block.type.startswith("hexahedron") else ():
            n_cells += 1
            for node, corners in zip(cell[8:], expected):
                mean = mesh.points[cell[list(corners)]].mean(axis=0)
                worst = max(worst, abs(mesh.points[node] - mean).max())
    return n_cells == 13 and worst < 1e-12


def in_space(contact, med, msh):
    case = pathlib.Path("blocks.prm")
    case.write_text(BLOCKS)
    solids_of_meshio(*blocks(8))
    reference = results(contact, case, pathlib.Path("own.msh").absolute())
    check("in 3-D, the own mesh", "u" in reference, reference)
    for n_nodes, types in SOLIDS.items():
        solids, tip = blocks(n_nodes)
        write_med(med, solids.points, solids.elements, {tip: ["Tip"]}, types)
        run = convert("--bodies", "Low,Up", med, msh)
        check(f"MED, {n_nodes} nodes: names", run.returncode == 0 and
              "bodies: Low (4), Up (9)" in run.stdout and
              "Up_z0 (9)" in run.stdout and "points: Tip (1)" in run.stdout,
              run.stdout + run.stderr)
        check(f"MED, {n_nodes} nodes: in gmsh's order", nodes_in_place(msh))
        compare(contact, case, msh.absolute(), reference,
                f"MED, {n_nodes} nodes: results of the own mesh")
    refuse("overlapping groups of volumes", "groups of volumes", med, msh)
    round_faces(med, msh)
    pathlib.Path("cube.inp").write_text(SHELLS)
    run = convert("cube.inp", "cube.msh")
    check("Abaqus in 3-D: names", run.stdout.strip().splitlines()[-4:] == [
        "bodies: Cube (1)", "boundaries: Top (1)", "curves: none",
        "points: Corner (1)"], run.stdout + run.stderr)


def round_faces(med, msh):
    """Pieces between two surfaces about a slanted axis."""
    axis = (1 / 3, 2 / 3, 2 / 3)
    across = (2 / 3, 1 / 3, -2 / 3), (2 / 3, -2 / 3, 1 / 3)
    center = 5, -3, 2

    def place(along, angle, radius):
        return [c + along * a + radius * (math.cos(angle) * e + math.sin(angle) * f)
                for c, a, e, f in zip(center, axis, *across)]

    def sphere(r, s, t):
        latitude = 0.8 * s - 0.3
        radius = 10 + 5 * t
        return place(radius * math.sin(latitude), 1.1 * r,
                     radius * math.cos(latitude))

    charts = {
        "Spheres": (sphere, "5, -3, 2, 10"),
        "Cylinders": (lambda r, s, t: place(20 * s, 1.1 * r, 10 + 5 * t), None),
        "Cones": (lambda r, s, t: place(20 * s, 1.1 * r, (1 + t) * (30 - 20 * s)),
                  None)}
    for entry, (chart, numbers) in charts.items():
        solids = Solids(20)
        solids.block("Body", (3, 2, 1), chart)
        write_med(med, solids.points, solids.elements, {}, SOLIDS[20])
        run = convert("--bodies", "Body", med, msh)
        found = [line.split(" = Body_z0: ")[1] for line in run.stdout.splitlines()
                 if f"with Mesh/{entry} = Body_z0: " in line]
        check(f"round: {entry}", len(found) == 1, run.stdout + run.stderr)
        if numbers:
            check(f"round: {entry}, numbers", found == [numbers], found)
            continue
        values = [float(x) for x in found[0].split(", ")]
        sign = 1 if entry == "Cylinders" else -1  # the cone opens backwards
        same = [v * w for v, w in zip(values[3:6], axis)]
        check(f"round: {entry}, axis", abs(abs(sum(same)) - 1) < 1e-7 and
              (sign > 0 or sum(same) < 0), values)
        if entry == "Cylinders":
            off = [v - c for v, c in zip(values[:3], center)]
            along = sum(o * a for o, a in zip(off, axis))
            off = [o - along * a for o, a in zip(off, axis)]
            check(f"round: {entry}, place and radius", max(map(abs, off)) < 1e-6
                  and abs(values[6] - 10) < 1e-6, values)
        else:
            apex = place(30, 0, 0)
            check(f"round: {entry}, apex and angle",
                  math.dist(values[:3], apex) < 1e-5 and
                  abs(values[6] - 45) < 1e-5, values)
    solids = Solids(20)
    solids.block("Body", (2, 2, 1),
                 lambda r, s, t: (10 * r, 10 * s, t + r * r + s * s))
    write_med(med, solids.points, solids.elements, {}, SOLIDS[20])
    run = convert("--bodies", "Body", med, msh)
    check("round: a paraboloid becomes flat", run.returncode == 0 and
          "which is not one sphere, cylinder or cone" in run.stderr, run.stderr)


def tetrahedra(med, msh):
    """Two of their corners are exchanged, as MED has them, and what is between."""
    def sphere(r, s, t):
        a, b, radius = 1.1 * r, 0.8 * s - 0.3, 10 + 5 * t
        return (5 + radius * math.cos(a) * math.cos(b),
                radius * math.sin(a) * math.cos(b) - 3, 2 + radius * math.sin(b))

    for what, chart in (("a sphere", sphere),
                        ("a block", lambda r, s, t: (2 * r, s + r, t))):
        body = Tetrahedra("Body", "C3D10", (3, 2, 1), chart)
        number = {label: i for i, label in enumerate(body.label.values())}
        cells = [[number[n] for n in nodes] for _, nodes in body.cells.values()]
        on = {number[body.label[i]] for i in body.label if body.is_on(i, "z0")}
        faces = [[nodes[k] for k in face] for nodes in cells for face in (
            (0, 1, 2, 4, 5, 6), (1, 2, 3, 5, 9, 8), (0, 1, 3, 4, 8, 7),
            (2, 0, 3, 6, 7, 9)) if on.issuperset(nodes[k] for k in face)]
        write_med(med, list(map(list, body.places.values())), {
            "tetra10": [([c[k] for k in (1, 0, 2, 3, 4, 6, 5, 8, 7, 9)], ["Body"])
                        for c in cells],
            "triangle6": [(face, ["Body_z0"]) for face in faces]}, {},
            {"tetra10": MED_TETRA10, "triangle6": MED_TRIA6})
        run = convert(med, msh)
        check(f"tetrahedra of {what}", "bodies: Body (36)" in run.stdout and
              "boundaries: Body_z0 (12)" in run.stdout, run.stdout + run.stderr)
        check(f"tetrahedra of {what}: what is round",
              ("with Mesh/Spheres = Body_z0: 5, -3, 2, 10" in run.stdout) ==
              (chart == sphere), run.stdout)
    check("tetrahedra: in gmsh's order", middles_are_right(msh, "11"))


def main():
    med, msh = pathlib.Path("space.med"), pathlib.Path("space.msh")
    in_space(pathlib.Path(sys.argv[1]), med, msh)
    tetrahedra(med, msh)
    wedge = {"wedge": [([0, 1, 2, 3, 4, 5], ["Wedge"])]}
    write_med(med, [[0., 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1],
                    [0, 1, 1]], wedge, {}, {"wedge": MED_PENTA6})
    run = convert(med, msh)
    check("a mesh of wedges", "bodies: Wedge (1)" in run.stdout,
          run.stdout + run.stderr)
    sys.exit(plane.failures > 0)


if __name__ == "__main__":
    main()
