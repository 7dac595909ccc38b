# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boxes of elements as Abaqus decks, converted and run, for the scripts beside
this one. The first argument of a script is the program."""

import itertools
import math
import pathlib
import subprocess
import sys

import block_scenes
from block_scenes import solve

CONVERTER = pathlib.Path(__file__).resolve().parents[1] / "meshes/convert.py"

# Nodes of elements in half steps, as Abaqus numbers them, and the faces of boxes.
QUAD = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))
BRICK = ((0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0),
         (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
         (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0),
         (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
         (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1))
QUAD_FACES = {"y0": "S1", "x1": "S2", "y1": "S3", "x0": "S4"}
BRICK_FACES = {"z0": "S1", "z1": "S2", "y0": "S3", "x1": "S4", "y1": "S5",
               "x0": "S6"}
EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
TETRAHEDRON_FACES = ((0, 1, 2), (0, 1, 3), (1, 2, 3), (2, 0, 3))


def check(what, ok, detail=""):
    block_scenes.check(what, ok, "" if ok else detail)


class Box:
    """A lattice of elements, the image of a unit square or cube."""

    def __init__(self, name, code, n, chart, first=1):
        self.name, self.n, self.code = name, n, code
        offsets = QUAD if len(n) == 2 else BRICK
        offsets = offsets[:int(code.strip("CPESAXD3RI"))] if "C3D" not in code \
            else offsets[:20 if "20" in code else 8]
        self.faces = QUAD_FACES if len(n) == 2 else BRICK_FACES
        self.places, self.label, self.cells = {}, {}, {}
        for cell in itertools.product(*(range(0, 2 * m, 2) for m in n)):
            nodes = []
            for offset in offsets:
                i = tuple(map(sum, zip(cell, offset)))
                if i not in self.label:
                    self.label[i] = first + len(self.label)
                    self.places[i] = chart(*(c / (2 * m) for c, m in zip(i, n)))
                nodes.append(self.label[i])
            self.cells[cell] = first + len(self.cells), nodes

    def is_on(self, i, side):
        d = "xyz".index(side[0])
        return i[d] == 2 * self.n[d] * int(side[1])

    def text(self):
        """Nodes, elements, sets and surfaces NAME_x0 ..."""
        lines = ["*NODE"]
        lines += [f"{self.label[i]}, " + ", ".join(map(repr, map(float, p)))
                  for i, p in self.places.items()]
        lines += [f"*ELEMENT, TYPE={self.code}, ELSET={self.name}"]
        for label, nodes in self.cells.values():
            numbers = [label, *nodes]
            lines += [", ".join(map(str, numbers[:12])) + ","
                      * (len(numbers) > 12)]
            lines += [", ".join(map(str, numbers[12:]))] * (len(numbers) > 12)
        for side in self.faces:
            lines += [f"*NSET, NSET={self.name}_{side}"]
            lines += [f"{self.label[i]}" for i in self.label
                      if self.is_on(i, side)]
            lines += self.surface(side)
        return "\n".join([*lines, ""])

    def surface(self, side):
        d = "xyz".index(side[0])
        last = 2 * self.n[d] - 2 if side[1] == "1" else 0
        return [f"*ELSET, ELSET={self.name}_{side}_cells",
                *(f"{label}" for cell, (label, _) in self.cells.items()
                  if cell[d] == last),
                f"*SURFACE, NAME={self.name}_{side}_face",
                f"{self.name}_{side}_cells, {self.faces[side]}"]


class Tetrahedra(Box):
    """Six tetrahedra for each cell, of 4 or 10 nodes."""

    def __init__(self, name, code, n, chart, first=1):
        self.name, self.n, self.code, self.faces = name, n, code, BRICK_FACES
        self.places, self.label, self.cells = {}, {}, {}
        pairs = EDGES if code.startswith("C3D10") else ()
        for cell in itertools.product(*(range(0, 2 * m, 2) for m in n)):
            for order in itertools.permutations(range(3)):
                path = [cell]
                for d in order:
                    path.append(tuple(c + 2 * (k == d)
                                      for k, c in enumerate(path[-1])))
                if order not in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
                    path[2:] = path[:1:-1]
                path += [tuple((a + b) // 2 for a, b in zip(path[i], path[j]))
                         for i, j in pairs]
                for i in path:
                    if i not in self.label:
                        self.label[i] = first + len(self.label)
                        self.places[i] = chart(*(c / (2 * m)
                                                 for c, m in zip(i, n)))
                self.cells[cell, order] = (first + len(self.cells),
                                           [self.label[i] for i in path])

    def surface(self, side):
        on = {label for i, label in self.label.items() if self.is_on(i, side)}
        return [f"*SURFACE, NAME={self.name}_{side}_face",
                *(f"{label}, S{k + 1}" for label, nodes in self.cells.values()
                  for k, face in enumerate(TETRAHEDRON_FACES)
                  if on.issuperset(nodes[i] for i in face))]


def elastic(*bodies, modulus=1000, ratio=0.25):
    return "".join(f"*SOLID SECTION, ELSET={body}, MATERIAL=Steel\n"
                   for body in bodies) + \
        f"*MATERIAL, NAME=Steel\n*ELASTIC\n{modulus}, {ratio}\n"


def convert(name, deck, *options):
    pathlib.Path(f"{name}.inp").write_text(deck)
    return subprocess.run([sys.executable, CONVERTER, f"{name}.inp",
                           f"{name}.msh", *options], text=True,
                          capture_output=True)


def values(name, deck, probes, *settings):
    """Values of the converted deck by the names of the probes."""
    done = convert(name, deck)
    if done.returncode:
        return {}, done.stderr
    _, said, summary = solve(pathlib.Path(f"{name}.prm"), "Output/VTU=false",
                             f"Probes/Probes={probes}", *settings)
    return {p["name"]: p["value"] for p in summary.get("probes", ())}, \
        done.stdout + done.stderr + said


def compare(what, found, expected, tolerance):
    found, said = found
    off = {name: abs(found.get(name, math.nan) - value)
           / max(1e-300, abs(value)) for name, value in expected.items()}
    check(what, all(x <= tolerance for x in off.values()),
          f"off by {off} {said}")
