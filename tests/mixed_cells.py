#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of hexahedra, wedges, pyramids and tetrahedra that share nodes.

Proves that they are split into tetrahedra that fit together, and a note says so:

- blocks of layers of hexahedra, pyramids and wedges, whose cells are listed from any
  corner, some of them left-handed, with inner nodes moved, of nodes of first and second
  order, and one that gmsh makes of hexahedra, pyramids and tetrahedra, have the volume
  that they have, and under a uniform stress have it to 1e-10, at degree 1 and 2, on two
  processes;
- the same on a block of hexahedra, which stay hexahedra, on either side of contact and
  tied to them: pressure of each node to 1e-10;
- a quarter of a ring has its volume and its displacement under pressure with curved
  sides, whether or not the file has nodes in the middle of faces and cells;
- a beam of wedges, extruded along any axis, bends as one of hexahedra;
- tetrahedra that meet with crossed diagonals are refused;
- hexahedra glued to tetrahedra are split if the triangles of these fit, and refused
  with place and remedy if they do not; so is a cell that is tangled.

Usage: mixed_cells.py CONTACT PARAMETERS MESHES
"""

import itertools
import math
import pathlib
import random
import subprocess
import sys

from block_scenes import check, failures, rows, run, violations
from tetrahedra_scenes import Solid

E, NU, LOAD = 1000., 0.3, 10.
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
           (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
# gmsh's: the sides with a node in their middle, by the number of corners, edges
# first, and the types by the numbers of nodes of first and second order, without
# and with the middles of faces.
SIDES = {
    3: ("01", "12", "02"), 4: ("01", "12", "23", "03", "0123"),
    5: ("01", "03", "04", "12", "14", "23", "24", "34", "0123"),
    6: ("01", "02", "03", "12", "14", "25", "34", "35", "45", "0134", "0235", "1245"),
    8: ("01", "03", "04", "12", "15", "23", "26", "37", "45", "47", "56", "67",
        "0123", "0145", "0347", "1256", "2367", "4567", "01234567")}
TYPES = {3: (2, 9, 9), 4: (3, 16, 10), 5: (7, 19, 14), 6: (6, 18, 13),
         8: (5, 17, 12)}
# The same cell from another corner, and left-handed.
TURNS = {5: ((0, 1, 2, 3, 4), (2, 3, 0, 1, 4), (0, 3, 2, 1, 4)),
         6: ((0, 1, 2, 3, 4, 5), (4, 3, 5, 1, 0, 2), (3, 4, 5, 0, 1, 2)),
         8: ((0, 1, 2, 3, 4, 5, 6, 7), (1, 2, 3, 0, 5, 6, 7, 4),
             (4, 5, 6, 7, 0, 1, 2, 3))}


class Cells(Solid):
    """Blocks of n[0] x n[1] x n[2] cubes, each a hexahedron, two wedges or six
    pyramids by the layer along z: 'h', 'p', or the axis 'x', 'y', 'z' of wedges.
    'order' is 1, or 2 without and 3 with the middles of faces and cells."""

    def fill(self, body, n, chart, layers, order=1):
        rng, number = random.Random(body), {}

        def node(place):
            if place not in number:
                self.nodes.append(chart(*(c / m for c, m in zip(place, n))))
                number[place] = len(self.nodes)
            return number[place]

        def add(dimension, group, corners, turn):
            corners = [corners[c] for c in turn]
            count = len(corners)
            sides = [s for s in SIDES[count] if order == 3 or order == len(s)]
            places = corners + [tuple(
                sum(corners[int(c)][d] for c in side) / len(side) for d in range(3))
                for side in sides if order > 1]
            tag = self.groups.setdefault((dimension, group), len(self.groups) + 1)
            self.elements.append((TYPES[count][order - 1], tag,
                                  [node(p) for p in places]))
        # The order of the numbers decides upon the diagonals.
        places = list(itertools.product(*(range(m + 1) for m in n)))
        rng.shuffle(places)
        for place in places:
            node(tuple(map(float, place)))

        def cell(i, corners):
            corners = [tuple(float(a + b) for a, b in zip(i, c)) for c in corners]
            add(3, body, corners, rng.choice(TURNS[len(corners)]))
        faces = {}
        for i in itertools.product(*map(range, n)):
            kind, half = layers[i[2]], (0.5, 0.5, 0.5)
            if kind == "h":
                cell(i, CORNERS)
            axis = "xyz".find(kind)
            for a, b in (((1, 0), (1, 1)), ((1, 1), (0, 1))) if axis >= 0 else ():
                cell(i, [tuple(z if d == axis else p[(d - axis - 1) % 3]
                               for d in range(3))
                         for z in (0, 1) for p in ((0, 0), a, b)])
            for d, end in itertools.product(range(3), range(2)):
                face = [tuple(end if k == d else p[(k - d - 1) % 3]
                              for k in range(3))
                        for p in ((0, 0), (1, 0), (1, 1), (0, 1))]
                if kind == "p":
                    cell(i, [*(face if end == 0 else face[::-1]), half])
                corners = [tuple(float(a + b) for a, b in zip(i, c)) for c in face]
                if i[d] + end in (0, n[d]):
                    faces.setdefault(f"{body}_{'xyz'[d]}{end}", []).append(
                        (corners, axis == d))
        for group, parts in faces.items():
            for corners, is_cut in parts:
                if is_cut:
                    for three in ((0, 1, 2), (0, 2, 3)):
                        add(2, group, [corners[c] for c in three], (0, 1, 2))
                else:
                    add(2, group, corners, (0, 1, 2, 3))


def solved(what, name, entries, ranks=1, bodies=("A",)):
    status, said, summary = run(name, {
        "Mesh/File": f"{name}.msh",
        "Solids/Young's modulus": ", ".join(f"{b}: {E}" for b in bodies),
        "Solids/Poisson's ratio": ", ".join(f"{b}: {NU}" for b in bodies),
        "Solids/Kinematics": "small strain", "Solution/Newton tolerance": 1e-13,
        **entries}, ranks)
    violated = violations(summary)
    check(f"{what}: converges, and no invariant is violated",
          status == 0 and not violated, said[:600] if status else violated)
    found = {p["name"]: p["value"] for p in summary.get("probes", [])}
    if status == 0:
        found["cells"] = summary["levels"][-1]["cells"]
    return found, said


def moved(x, y, z):
    """Sides stay flat; the nodes within move."""
    bump = 0.2 * math.prod(math.sin(math.pi * c) for c in (x, y, z))
    return 2 * x + bump, y - bump, z + 0.5 * bump


HELD = {f"Boundary conditions/Displacement {c}": f"A_{c}0: 0" for c in "xyz"}


def uniaxial(what, name, volume, inner, more, ranks=1):
    """Uniform stress along x: its value, the displacement within, and the volume
    by the energy."""
    found, said = solved(what, name, {
        **HELD, "Mesh/Points": f"P: {', '.join(map(repr, inner))}",
        "Boundary conditions/Traction x": f"A_x1: {LOAD}",
        "Probes/Probes": "ux: displacement x, P; uy: displacement y, P; "
                         "s: stress xx, P; t: stress zz, P; e: strain energy, A",
        **more}, ranks)
    wanted = {"ux": LOAD / E * inner[0], "uy": -NU * LOAD / E * inner[1], "s": LOAD,
              "e": LOAD**2 / (2 * E) * volume}
    off = max([abs(found.get(k, 0) / v - 1) for k, v in wanted.items()] +
              [abs(found.get("t", LOAD)) / LOAD])
    check(f"{what}: stress, displacement and volume", off < 1e-10, off)
    check(f"{what}: a note", "were split into tetrahedra" in said, said[:400])
    return found


def patches():
    for order, layers in itertools.product(
            (1, 2, 3), ("hpx", "ypp", "xyx", "hhp", "zz")):
        mesh = Cells()
        mesh.fill("A", (3, 2, len(layers)), moved, layers, order)
        mesh.write("patch")
        for degree, ranks in ((1, 2), (2, 1)):
            found = uniaxial(f"layers {layers}, order {order}, degree {degree}",
                             "patch", 2., moved(1 / 3, 0.5, 1 / len(layers)),
                             {"Element/Degree": degree}, ranks)
            # Six in a cube, twelve in one of pyramids, six cubes in a layer.
            check("tetrahedra", found.get("cells") ==
                  36 * (len(layers) + layers.count("p")), found)


GEOMETRY = """Mesh.MshFileVersion = 2.2;
Point(1) = {0, 0, 0, 0.5}; Point(2) = {1, 0, 0, 0.5};
Point(3) = {1, 1, 0, 0.5}; Point(4) = {0, 1, 0, 0.5};
For i In {1:4}
  Line(i) = {i, i % 4 + 1};
EndFor
Line Loop(1) = {1:4};
Plane Surface(1) = {1};
Transfinite Line{1:4} = 3;
Transfinite Surface{1};
Recombine Surface{1};
e[] = Extrude {0, 0, 1} { Surface{1}; Layers{2}; Recombine; };
f[] = Extrude {0, 0, 1} { Surface{e[0]}; };
Physical Volume("A") = {e[1], f[1]};
Physical Surface("A_z0") = {1};
Physical Surface("A_x1") = {e[3], f[3]};
Physical Surface("A_x0") = {e[5], f[5]};
Physical Surface("A_y0") = {e[2], f[2]};
"""


def of_gmsh():
    """Hexahedra below, tetrahedra above, pyramids between: uniform stress, of
    curved cells as well, which are straight here."""
    pathlib.Path("hybrid.geo").write_text(GEOMETRY)
    for order, incomplete in ((1, 0), (2, 0), (2, 1)):
        subprocess.run(["gmsh", "-3", "-order", str(order), "-v", "1", "-setnumber",
                        "Mesh.SecondOrderIncomplete", str(incomplete),
                        "hybrid.geo"], check=True)
        kinds = {line.split()[1] for line in pathlib.Path("hybrid.msh").read_text()
                 .split("$Elements")[1].splitlines() if len(line.split()) > 8}
        check("gmsh has three kinds of cells", len(kinds - {"3", "9", "10", "16"}) == 3,
              kinds)
        uniaxial(f"of gmsh, order {order}, incomplete {incomplete}", "hybrid", 2.,
                 (0.5, 0.5, 0.5), {"Mesh/Mid-side nodes": str(order == 2).lower()})


def moved_up(x, y, z):
    bump = 0.08 * math.prod(math.sin(math.pi * c) for c in (x, y, z))
    return x + bump, y - bump, z + 0.5 * bump


def on_hexahedra():
    """A block of mixed cells above one of hexahedra, which do not match."""
    for slave, tied, kinds in itertools.product(
            ("A", "B"), (False, True), ("zz", "ph", "xh")):
        mesh = Cells()
        mesh.fill("A", (3, 4, 2), moved_up, kinds)
        mesh.fill("B", (4, 3, 2), lambda x, y, z: (x, y, z - 1), "hh")
        mesh.write("pair")
        other = "AB".replace(slave, "")
        side = {"A": "A_z0", "B": "B_z1"}
        what = f"layers {kinds} on hexahedra, slave {slave}, tied {tied}"
        found, said = solved(what, "pair", {
            "Boundary conditions/Displacement x": "A_x0: 0, B_x0: 0",
            "Boundary conditions/Displacement y": "A_y0: 0, B_y0: 0",
            "Boundary conditions/Displacement z": "B_z0: 0",
            "Boundary conditions/Traction z": f"A_z1: {-LOAD}",
            "Contact/Slave": side[slave], "Contact/Master": side[other],
            "Contact/Tied": str(tied).lower(), "Element/Degree": 2,
            "Element/Centre node": "free",
            "Solution/Increments": 1, "Output/Profile": "true",
            "Mesh/Points": "P: 0.3, 0.4, 0.45; Q: 0.3, 0.4, -0.45",
            "Probes/Probes": "P: stress zz, P; Q: stress zz, Q; "
                             "u: displacement z, P"}, bodies="AB")
        nodes = [row for row in rows("pair") if row["surface"] == "slave"]
        off = [abs(row["pressure_MPa"] / LOAD - 1) for row in nodes] + [
            abs(found["P"] / LOAD + 1), abs(found["Q"] / LOAD + 1),
            abs(found["u"] / (LOAD / E * 1.45) + 1)]
        check(f"{what}: stress, pressure of {len(nodes)} nodes",
              len(nodes) > 8 and max(off) < 1e-10, max(off))
        check(f"{what}: hexahedra stay", "cells of 'B'" not in said and
              "cells of 'A' were split" in said, said[:300])


A, B, P = 10., 20., 3.


def quarter(s, t, r):
    radius, angle = A + s * (B - A), math.pi / 2 * t
    return radius * math.cos(angle), radius * math.sin(angle), 5 * r


def rings():
    """Lame, plane strain, on parabolas through the nodes: their volume is that of
    the ring to 1e-4."""
    exact = P * A / E * (1 + NU) * (A * A * (1 - 2 * NU) + B * B) / (B * B - A * A)
    volume = math.pi / 4 * (B * B - A * A) * 5
    for layers, order in itertools.product(("hp", "z", "x", "py"), (2, 3)):
        mesh = Cells()
        mesh.fill("A", (3, 4, len(layers)), quarter, layers, order)
        mesh.write("ring")
        entries = {
            "Mesh/Mid-side nodes": "true",
            "Boundary conditions/Displacement x": "A_y1: 0",
            "Boundary conditions/Displacement y": "A_y0: 0",
            "Boundary conditions/Displacement z": "A_z0: 0, A_z1: 0",
            "Boundary conditions/Pressure": f"A_x0: {P}",
            "Mesh/Points": f"O: {A}, 0, 0", "Probes/Probes": "u: displacement x, O"}
        found, _ = solved(f"ring of layers {layers}, order {order}", "ring", entries)
        check("displacement of the bore", abs(found["u"] / exact - 1) < 5e-3,
              found["u"] / exact - 1)
        found, _ = solved("its weight", "ring", {
            **entries, "Boundary conditions/Pressure": "",
            "Boundary conditions/Displacement z": "A_z0: 0",
            "Boundary conditions/Body force z": "A: 1e-3",
            "Probes/Probes": "R: reaction z, A_z0"})
        check("its volume", abs(abs(found["R"]) / (1e-3 * volume) - 1) < 1e-4,
              abs(found["R"]) / (1e-3 * volume) - 1)


def beams():
    """Under their weight: the deflection of wedges by that of hexahedra, at
    degree 2, on the same nodes."""
    def beam(layers, n):
        mesh = Cells()
        mesh.fill("A", (8, 2, n), lambda x, y, z: (10 * x, y, z), layers)
        mesh.write("beam")
        found, _ = solved(f"beam of layers {layers}", "beam", {
            "Element/Degree": 2, "Element/Centre node": "free",
            **{f"Boundary conditions/Displacement {c}": "A_x0: 0" for c in "xyz"},
            "Boundary conditions/Body force z": "A: -0.01",
            "Mesh/Points": "P: 10, 0, 0", "Probes/Probes": "u: displacement z, P"})
        return found["u"]
    straight = beam("hh", 2)
    for axis in "xyz":
        ratio = beam(2 * axis, 2) / straight
        check(f"wedges along {axis} bend as hexahedra", abs(ratio - 1) < 0.015, ratio)


def glued():
    """A hexahedron beside one of tetrahedra that share its nodes."""
    def scene(triangles, of_first=()):
        mesh = Solid()
        mesh.nodes = [(x, y, z) for x in (0., 1., 2.) for z in (0., 1.)
                      for y in (0., 1.)]
        # Corners in gmsh's order, by the place in the list above, of each cube.
        cubes = [[1 + 4 * (i + a) + 2 * c + b for a, b, c in CORNERS]
                 for i in (0, 1)]
        if not of_first:
            mesh.add(3, "A", cubes[0])
        for cube, paths in zip(cubes, (of_first, triangles)):
            for path in paths:
                mesh.add(3, "A", [cube[c] for c in path])
        for group, cube, corners in (
                ("A_x0", 0, (0, 3, 7, 4)), ("A_y0", 0, (0, 1, 5, 4)),
                ("A_z0", 0, (0, 1, 2, 3))):
            corners = [cubes[cube][c] for c in corners]
            for half in ([0, 1, 2], [0, 2, 3]) if of_first else [range(4)]:
                mesh.add(2, group, [corners[k] for k in half])
        mesh.write("glued")
    # Six tetrahedra round a diagonal of the cube, which is on the face x = 0 the
    # diagonal from its corner 0 or from its corner 3.
    fits = ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6),
            (0, 5, 1, 6))
    turn = {0: 3, 1: 0, 2: 1, 3: 2, 4: 7, 5: 4, 6: 5, 7: 6}
    entries = {**HELD, "Boundary conditions/Body force x": "A: 1",
               "Probes/Probes": "R: reaction x, A_x0; e: strain energy, A"}
    scene(fits)
    found, said = solved("tetrahedra that fit", "glued", entries)
    check("they are split, and have their volume",
          found["cells"] == 12 and abs(abs(found["R"]) / 2 - 1) < 1e-12 and
          "1 cells of 'A' were split" in said, (found, said[:400]))
    scene([[turn[c] for c in path] for path in fits])
    refusal("tetrahedra that do not fit", ("meets two triangles", "pyramids between",
                                           "Tied = true", "element 1"), entries)
    scene(fits, fits)
    found, said = solved("tetrahedra beside such", "glued", entries)
    check("they are one body", abs(abs(found["R"]) / 2 - 1) < 1e-12, found)
    scene([[turn[c] for c in path] for path in fits], fits)
    refusal("tetrahedra with crossed diagonals", ("cut open", "(1, ",
                                                  "Transfinite"), entries)
    mesh = Cells()
    mesh.fill("A", (1, 1, 2), lambda x, y, z: (x, y, z), "hp")
    kind, tag, nodes = mesh.elements[0]
    number = nodes[0]
    mesh.nodes[number - 1] = tuple(1.8 * (0.5 - x) + x if d < 2 else x for d, x in
                                   enumerate(mesh.nodes[number - 1]))
    mesh.write("glued")
    refusal("a tangled hexahedron", ("tangled",), entries)


def refusal(what, words, entries):
    status, said, _ = run("refused", {
        "Mesh/File": "glued.msh", "Solids/Young's modulus": f"A: {E}",
        "Solids/Poisson's ratio": f"A: {NU}", **entries})
    check(f"{what} are refused", status == 2 and all(w in said for w in words),
          said[:600])


patches()
of_gmsh()
on_hexahedra()
rings()
beams()
glued()
sys.exit(bool(failures))
