#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundaries that are curved by the mid-side nodes of elements of second order.

Proves that

- a quarter ring under pressure of quadrangles of 8 and 9 nodes, triangles of 6
  and hexahedra of 20 and 27, whose boundaries have no formula, is the one of
  named arcs (or cylinders), in an other place as well, and on two processes;
- on finer meshes the sides stay on their parabolas, whose distance from the
  circle falls with the fourth power of the size of the elements in the file,
  and a note says so where surfaces touch;
- so does the error of the area between two ellipses;
- meshes without such nodes, and with nodes far from the middle, are refused.

Usage: mid_side_nodes.py CONTACT PARAMETERS MESHES
"""

import itertools
import math
import pathlib
import sys

from block_scenes import Mesh, check, failures, run

A, B, P = 10., 20., 3.
HEXAHEDRON = (  # corners, edges, faces, centre, in half steps, as gmsh has them
    (0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0),
    (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
    (1, 0, 0), (0, 1, 0), (0, 0, 1), (2, 1, 0), (2, 0, 1), (1, 2, 0),
    (2, 2, 1), (0, 2, 1), (1, 0, 2), (0, 1, 2), (2, 1, 2), (1, 2, 2),
    (1, 1, 0), (1, 0, 1), (0, 1, 1), (2, 1, 1), (1, 2, 1), (1, 1, 2),
    (1, 1, 1))
FACE = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1), (1, 1))


class Second(Mesh):
    """A body of second order, the image of a unit square or cube, whose sides
    x0, x1, y0 ... are groups."""

    def __init__(self, kind, n, chart):
        super().__init__()
        self.chart, self.n = chart, n
        steps = [range(2 * m + 1) for m in n]
        self.number = {}
        for i in itertools.product(*steps):
            self.nodes.append(chart(*(c / (2 * m) for c, m in zip(i, n))))
            self.number[i] = len(self.nodes)
        for i in itertools.product(*(range(0, 2 * m, 2) for m in n)):
            if kind == 9:
                ends = [self.nodes[self.number[i[0] + k, i[1] + k] - 1]
                        for k in (0, 2)]
                self.nodes[self.number[i[0] + 1, i[1] + 1] - 1] = tuple(
                    sum(c) / 2 for c in zip(*ends))
                self.put(2, "A", 9, i, [FACE[k] for k in (0, 1, 2, 4, 5, 8)])
                self.put(2, "A", 9, i, [FACE[k] for k in (0, 2, 3, 8, 6, 7)])
            elif len(n) == 2:
                self.put(2, "A", kind, i, FACE[:{16: 8, 10: 9}[kind]])
            else:
                self.put(3, "A", kind, i, HEXAHEDRON[:{17: 20, 12: 27}[kind]])
        for d, side in itertools.product(range(len(n)), range(2)):
            others = [range(0, 2 * m, 2) for k, m in enumerate(n) if k != d]
            for i in itertools.product(*others):
                here = [*i]
                here.insert(d, 2 * n[d] * side)
                pattern = ([(0,), (2,), (1,)] if len(n) == 2 else
                           FACE[:8 if kind == 17 else 9])
                self.put(len(n) - 1, "xyz"[d] + str(side),
                         {9: 8, 16: 8, 10: 8, 17: 16, 12: 10}[kind], here,
                         [(*p[:d], 0, *p[d:]) for p in pattern])

    def put(self, dimension, group, kind, first, pattern):
        tag = self.groups.setdefault((dimension, group), len(self.groups) + 1)
        self.elements.append((kind, tag, [
            self.number[tuple(a + b for a, b in zip(first, p))]
            for p in pattern]))

    def write(self, name):
        places, self.nodes = self.nodes, [p[:2] for p in self.nodes]
        super().write(name)
        self.nodes = places
        file = pathlib.Path(f"{name}.msh")
        lines = file.read_text().split("\n")
        first = lines.index("$Nodes") + 2
        for i, p in enumerate(places):
            lines[first + i] = " ".join(map(repr, (i + 1, *p, 0)[:4]))
        file.write_text("\n".join(lines))


def quarter(s, t, *z):
    """The bore is x0; y grows against the clock."""
    r, angle = A + s * (B - A), math.pi / 2 * t
    return (r * math.cos(angle), r * math.sin(angle), *z)


def ring(name, more, ranks=1):
    status, said, summary = run(name, {
        "Mesh/File": "ring.msh", "Element/Degree": 2,
        "Solids/Young's modulus": "A: 1000", "Solids/Poisson's ratio": "A: 0.3",
        "Solids/Kinematics": "small strain",
        "Boundary conditions/Displacement normal": "y0: 0, y1: 0",
        "Boundary conditions/Pressure": f"x0: {P}",
        "Mesh/Points": f"O: {A}, 0",
        "Probes/Probes": "u: displacement x, O; s: stress yy, O", **more},
        ranks)
    check(f"{name}: converged", status == 0, said[:300])
    return {p["name"]: p["value"] for p in summary.get("probes", [])}


def difference(a, b):
    return max((abs(a[c] / b[c] - 1) for c in b), default=9)


def rings():
    arcs = {"Mesh/Arcs": f"x0: 0, 0, {A}; x1: 0, 0, {B}"}
    nodes = {"Mesh/Mid-side nodes": "true"}
    for kind in (16, 10, 9):
        Second(kind, (1, 4), quarter).write("ring")
        named, found = (ring(f"ring{kind}", more) for more in (arcs, nodes))
        check(f"elements of type {kind} are on the arcs",
              difference(found, named) < 1e-11, (found, named))
        if kind != 16:
            continue
        placed = ring("placed", {
            **nodes, "Mesh/Move": "A: 3, 4", "Mesh/Scale": 2,
            "Mesh/Shift": "5, 6"})
        check("and so they are in another place",
              abs(placed["u"] / found["u"] - 2) < 1e-10, (placed, found))
        both = ring("both", {**nodes, **arcs})
        check("names come first", difference(both, named) < 1e-13)
        check("straight sides are others",
              difference(ring("none", {}), named) > 0.01)
    space = {"Boundary conditions/Displacement z": "z0: 0, z1: 0",
             "Mesh/Points": f"O: {A}, 0, 0"}
    cylinders = {"Mesh/Cylinders": f"x0: 0, 0, 0, 0, 0, 1, {A}; "
                                   f"x1: 0, 0, 0, 0, 0, 1, {B}"}
    for kind in (17, 12):
        Second(kind, (1, 4, 1), lambda s, t, r: quarter(s, t, 5 * r)).write(
            "ring")
        named, found = (ring(f"ring{kind}", {**space, **more})
                        for more in (cylinders, nodes))
        check(f"elements of type {kind} are on the cylinders",
              difference(found, named) < 1e-10, (found, named))
    finer = [ring("finer", {**space, **nodes, "Mesh/Refinements": 1}, ranks)
             for ranks in (1, 2)]
    check("finer, on two processes", difference(*finer) < 1e-8, finer)

    # A cap of a sphere, whose faces have their centres there.
    def cap(s, t, r):
        p = (0.8 * s - 0.4, 0.8 * t - 0.4, 1)
        return tuple((A + r * (B - A)) * c / math.hypot(*p) for c in p)
    Second(12, (1, 1, 1), cap).write("cap")
    found = [ring("cap", {
        "Mesh/File": "cap.msh", "Mesh/Points": "", **more,
        "Boundary conditions/Displacement normal": "",
        "Boundary conditions/Displacement x": "z1: 0",
        "Boundary conditions/Displacement y": "z1: 0",
        "Boundary conditions/Displacement z": "z1: 0",
        "Boundary conditions/Pressure": f"z0: {P}",
        "Probes/Probes": "e: strain energy, A"}) for more in (
            nodes, {"Mesh/Spheres": f"z0: 0, 0, 0, {A}; z1: 0, 0, 0, {B}"})]
    check("faces have their centres", difference(*found) < 1e-11, found)

    # Lame: 2 (1 - nu^2) p a^2 b/E ... of the bore in plane strain.
    exact = P * A / 1000 * 1.3 * (A * A * (1 - 2 * 0.3) + B * B) / (B * B - A * A)
    errors = []
    for n in (2, 4, 8):
        Second(16, (n, n), quarter).write("ring")
        errors.append(abs(ring("lame", {**nodes, "Mesh/Refinements": 2})["u"] /
                          exact - 1))
    check("with the order of the parabolas",
          errors[0] > 12 * errors[1] > 140 * errors[2], errors)


def tubes():
    """Of 3 and of 4 cells around: gaps of the size of their distance from the
    circle, which stays where the sides are refined."""
    mesh = Second(16, (1, 3), quarter)
    outer = Second(16, (1, 4), lambda s, t: quarter(s + 1, t))
    names = {tag: key for key, tag in outer.groups.items()}
    for kind, tag, nodes in outer.elements:
        dimension, name = names[tag]
        key = dimension, "B" if name == "A" else "outer_" + name
        mesh.elements.append((
            kind, mesh.groups.setdefault(key, len(mesh.groups) + 1),
            [n + len(mesh.nodes) for n in nodes]))
    mesh.nodes += outer.nodes
    mesh.write("tubes")
    for refinements in 0, 2:
        status, said, _ = run("tubes", {
            "Mesh/File": "tubes.msh", "Element/Degree": 2,
            "Mesh/Mid-side nodes": "true", "Mesh/Refinements": refinements,
            "Solids/Young's modulus": "A: 1000, B: 1000",
            "Solids/Poisson's ratio": "A: 0.3, B: 0.3",
            "Solids/Kinematics": "small strain",
            "Boundary conditions/Displacement normal":
                "y0: 0, y1: 0, outer_y0: 0, outer_y1: 0",
            "Boundary conditions/Pressure": f"x0: {P}",
            "Contact/Slave": "x1", "Contact/Master": "outer_x0"})
        check(f"the sides of the file are off their circles, {refinements}",
              status == 0 and "mm off their circles" in said, said[-400:])


def ellipses():
    """The force of a body force of one is the area."""
    def chart(s, t):
        angle = math.pi / 2 * t
        return (4 + 3 * s) * math.cos(angle), (2 + 4 * s) * math.sin(angle)
    exact = math.pi / 4 * (7 * 6 - 4 * 2)

    def area(more, ranks=1):
        status, said, summary = run("ellipses", {
            "Mesh/File": "ellipses.msh", "Solids/Young's modulus": "A: 1e4",
            "Solids/Poisson's ratio": "A: 0.3",
            "Solids/Kinematics": "small strain", "Element/Degree": 2,
            "Boundary conditions/Displacement x": "y0: 0",
            "Boundary conditions/Displacement y": "y0: 0",
            "Boundary conditions/Body force y": "A: 1",
            "Probes/Probes": "f: reaction y, y0", **more}, ranks)
        check("ellipses: converged", status == 0, said[:300])
        return -summary["probes"][0]["value"] if status == 0 else 0
    nodes = {"Mesh/Mid-side nodes": "true"}
    errors = []
    for n in (2, 4, 8):
        Second(10, (2, n), chart).write("ellipses")
        errors.append(abs(area(nodes) / exact - 1))
        if n == 4:
            one = area(nodes)
            for more, ranks in (({"Mesh/Refinements": 2}, 1),
                                ({"Refinement/Levels": 3,
                                  "Refinement/Strategy": "adaptive"}, 1),
                                ({"Mesh/Refinements": 1}, 2)):
                check(f"children are on the same parabolas, {more}, {ranks} "
                      "processes",
                      abs(area({**nodes, **more}, ranks) / one - 1) <
                      (1e-11 if ranks == 1 else 1e-8))
    check("the area of ellipses", errors[0] > 13 * errors[1] > 180 * errors[2],
          errors)
    check("is off without", abs(area({}) / exact - 1) > 20 * errors[2])


def refused():
    entries = {"Solids/Young's modulus": "A: 1", "Solids/Poisson's ratio": "A: 0",
               "Boundary conditions/Displacement x": "y0: 0",
               "Boundary conditions/Displacement y": "y0: 0",
               "Mesh/Mid-side nodes": "true"}
    mesh = Mesh()
    mesh.block("A", 1, 1, lambda s, t: (s, t), {"bottom": "y0"})
    mesh.write("first")
    status, said, _ = run("refused", {**entries, "Mesh/File": "first.msh"})
    check("a mesh of first order is refused", status == 2 and
          "no elements of second order" in said, said[:300])
    mesh = Second(16, (1, 1), lambda s, t: (s, t))
    mesh.nodes[mesh.number[1, 2] - 1] = 0.2, 1
    mesh.write("far")
    status, said, _ = run("refused", {**entries, "Mesh/File": "far.msh"})
    check("a node far from the middle is refused", status == 2 and
          "middle half" in said, said[:300])


rings()
tubes()
ellipses()
refused()
sys.exit(bool(failures))
