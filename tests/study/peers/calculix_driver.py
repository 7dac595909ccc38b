#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""One run of the benchmark with CalculiX, reported as one line of JSON.

    calculix_driver.py MESH [--contact surface|node|mortar] [--penalty K]
                       [--small] [--friction MU] [--increments N] ...

MESH is a .npz file of mesh.py; its cells have 4 or 8 nodes: CPE4 or CPE8, and
with --reduced CPE4R or CPE8R. ccx turns them into a layer of solid elements,
whose equations are the unknowns reported. The mortar contact of ccx is for
solid elements only: there the layer (C3D8, C3D20) is written out, held in z.

The contact conditions:

- surface, node: springs of K N/mm^3 in points of the slave faces, or in the
  slave nodes; shear by springs of K times --stick;
- mortar: multipliers; the node at C, which a support may not hold in x as it
  is one of the slave's, is held by a spring of HOLD instead.

The cylinder is held by contact alone, and no spring is made where there is a
gap: a first step presses it into the block, --start mm at its top; the second
one lets go of it there and applies the load.

Time and memory are those of ccx alone. SIYY(B) is the Cauchy stress that ccx
extrapolates from the integration points to the node.
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import tempfile

import numpy as np

import mesh as meshes

MATERIAL = {"Block": (70000., .3), "Cylinder": (210000., .3)}
LOAD = -17500.
HOLD = 1e9  # N/mm
TYPES = {"surface": "SURFACE TO SURFACE", "node": "NODE TO SURFACE",
         "mortar": "MORTAR"}


def options_of_call():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("mesh")
    parser.add_argument("--contact", default="surface", choices=TYPES)
    parser.add_argument("--penalty", type=float, default=3.5e6)
    parser.add_argument("--stick", type=float, default=.1)
    parser.add_argument("--small", action="store_true", help="small strain")
    parser.add_argument("--friction", type=float, default=0.)
    parser.add_argument("--reduced", action="store_true")
    parser.add_argument("--first", type=float, default=.1,
                        help="first load increment; further ones by ccx")
    parser.add_argument("--increments", type=int, default=0,
                        help="this many equal ones instead")
    parser.add_argument("--start", type=float, default=.05)
    parser.add_argument("--seconds", type=int, default=300, help="of CPU")
    parser.add_argument("--folder", help="where the files of ccx stay")
    return parser.parse_args()


class Deck:
    """The input of ccx: lines, and the number of the node of each point."""

    def __init__(self, mesh, options):
        self.mesh, self.options, self.lines = mesh, options, []
        self.number = 0
        self.solid = options.contact == "mortar"
        self.n = len(mesh.nodes)
        corners = np.concatenate([c[:, :4] for c in mesh.cells.values()])
        self.corners = np.unique(corners)
        self.quadratic = mesh.cells["Block"].shape[1] == 8

    def put(self, *lines):
        self.lines += lines

    def put_list(self, numbers):
        numbers = [str(int(n)) for n in np.ravel(numbers)]
        for i in range(0, len(numbers), 12):
            self.put(", ".join(numbers[i:i + 12]) + ",")

    def layers(self):
        """By layer in z its height and the numbers (from 0) of its points."""
        everything = np.arange(self.n)
        if not self.solid:
            return [(0., everything)]
        middle = [(.5, self.corners)] if self.quadratic else []
        return [(0., everything), *middle, (1., everything)]

    def numbers(self, points):
        """Numbers of the nodes of points, in all layers."""
        return np.concatenate([
            layer * self.n + 1 + np.intersect1d(points, members)
            for layer, (_, members) in enumerate(self.layers())])

    def nodes(self):
        self.put("*NODE, NSET=ALL")
        for layer, (z, members) in enumerate(self.layers()):
            for i in members:
                x, y = self.mesh.nodes[i]
                self.put(f"{layer * self.n + i + 1}, {x:.15g}, {y:.15g}, {z}")

    def elements(self):
        kind = (("C3D20" if self.quadratic else "C3D8") if self.solid else
                ("CPE8" if self.quadratic else "CPE4"))
        kind += "R" * self.options.reduced
        self.sides = {}
        for body, cells in self.mesh.cells.items():
            self.put(f"*ELEMENT, TYPE={kind}, ELSET={body}")
            top = (len(self.layers()) - 1) * self.n
            for cell, sides in zip(cells + 1, meshes.sides(cells)):
                self.number += 1
                if self.solid:
                    cell = np.concatenate(
                        [cell[:4], cell[:4] + top, cell[4:], cell[4:] + top] +
                        [cell[:4] + self.n] * self.quadratic)
                self.put_element(self.number, cell)
                for i, side in enumerate(sides):
                    face = i + (3 if self.solid else 1)
                    key = body, frozenset(side.tolist())
                    self.sides[key] = self.number, face

    def put_element(self, number, cell):
        words = [str(n) for n in (number, *cell)]
        self.put(", ".join(words[:11]) + ("," if len(words) > 11 else ""))
        if len(words) > 11:
            self.put(", ".join(words[11:]))

    def surface(self, name, body):
        self.put(f"*SURFACE, NAME={name}, TYPE=ELEMENT")
        for edge in self.mesh.edges[name]:
            number, face = self.sides[body, frozenset(edge[:2].tolist())]
            self.put(f"{number}, S{face}")

    def materials(self):
        for body, (young, poisson) in MATERIAL.items():
            self.put(f"*MATERIAL, NAME={body}", "*ELASTIC",
                     f"{young}, {poisson}",
                     f"*SOLID SECTION, ELSET={body}, MATERIAL={body}")
            if not self.solid:
                self.put("1.")

    def contact(self):
        options = self.options
        self.surface("Bottom_C", "Cylinder")
        self.surface("Top_B", "Block")
        self.put("*SURFACE INTERACTION, NAME=LAW")
        if self.solid:
            self.put("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD")
        else:
            # Node to surface also wants the tension far from contact, and how
            # far springs are made.
            self.put("*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
                     f"{options.penalty}" +
                     (", 1., 1e-3" if options.contact == "node" else ""))
        if options.friction > 0:
            self.put("*FRICTION",
                     f"{options.friction}, {options.penalty * options.stick}")
        self.put("*CONTACT PAIR, INTERACTION=LAW, "
                 f"TYPE={TYPES[options.contact]}", "Bottom_C, Top_B")

    def begin(self, static, *held):
        """The head of a step and its supports."""
        options = self.options
        self.put("*STEP, INC=1000" + (", NLGEOM" * (not options.small)),
                 *static)
        self.put("*BOUNDARY, OP=NEW", "Axe, 1, 1", "Encast, 1, 2", *held)
        if self.solid:
            self.put("ALL, 3, 3")

    def spring(self):
        """Instead of a support in x, which mortar contact does not stand in
        nodes of the slave."""
        self.put("*ELEMENT, TYPE=SPRING1, ELSET=Hold")
        for node in self.numbers(self.mesh.points["C"]):
            self.number += 1
            self.put(f"{self.number}, {node}")
        self.put("*SPRING, ELSET=Hold", "1", f"{HOLD}")

    def steps(self):
        options, mesh = self.options, self.mesh
        groups = {name: np.unique(mesh.edges[name])
                  for name in ("Axe", "Encast")} | {"Top": mesh.points["Force"]}
        if self.solid:
            groups["Axe"] = np.setdiff1d(groups["Axe"], mesh.points["C"])
        for name, points in groups.items():
            self.put(f"*NSET, NSET={name}")
            self.put_list(self.numbers(points))
        self.begin(["*STATIC"], f"Top, 2, 2, {-options.start}")
        self.put("*END STEP")
        self.begin(["*STATIC, DIRECT", f"{1 / options.increments}, 1."]
                   if options.increments else
                   ["*STATIC", f"{options.first}, 1."])
        self.put("*CLOAD")
        for node, force in self.loads():
            self.put(f"{node}, 2, {force:.15g}")
        flat = "" if self.solid else ", OUTPUT=2D"
        self.put(f"*NODE FILE{flat}, FREQUENCY=9999", "U",
                 f"*EL FILE{flat}, FREQUENCY=9999", "S",
                 "*NODE PRINT, NSET=Encast, TOTALS=ONLY, FREQUENCY=9999", "RF",
                 "*END STEP")

    def loads(self):
        nodes, loads = meshes.edge_loads(self.mesh, "Cap", LOAD)
        if not self.solid:
            return zip(nodes + 1, loads)
        top = (len(self.layers()) - 1) * self.n
        if not self.quadratic:
            return [(node + 1 + z, force / 2)
                    for node, force in zip(nodes, loads) for z in (0, top)]
        # On 8-node faces, even in z: the middle layer has 2/3 of the load of
        # a linear edge, which the corners of the others are short of.
        _, middle = meshes.edge_loads(self.mesh, "Cap", LOAD, linear=True)
        return ([(node + 1 + z, force / 2 - part / 3)
                 for node, force, part in zip(nodes, loads, middle)
                 for z in (0, top)] +
                [(node + 1 + self.n, 2 * part / 3)
                 for node, part in zip(nodes, middle) if part])

    def text(self):
        self.nodes()
        self.elements()
        self.materials()
        if self.solid:
            self.spring()
        self.contact()
        self.steps()
        return "\n".join(self.lines) + "\n"


def fields(path, node):
    """The last values that the .frd file has for a node, by field."""
    found, name = {}, None
    with open(path, encoding="ascii", errors="replace") as file:
        for line in file:
            if line.startswith(" -4"):
                name = line.split()[1]
            elif (name and line.startswith(" -1") and
                  int(line[3:13]) == node):
                found[name] = [float(line[i:i + 12])
                               for i in range(13, len(line) - 1, 12)]
            elif line.startswith(" -3"):
                name = None
    return found


def steps(path):
    """From the .sta file: increments, their attempts, Newton steps, load."""
    increments, attempts, newton, load = 0, 0, 0, 0.
    for line in path.read_text().splitlines() if path.exists() else []:
        words = line.split()
        if len(words) == 7 and words[0].isdigit():
            attempts += 1
            newton += int(words[3])
            if not words[2].endswith("U"):
                increments += 1
                load = float(words[5]) if words[0] == "2" else 0.
    return increments, attempts, newton, load


def run(options, folder):
    mesh = meshes.load(options.mesh)
    (folder / "job.inp").write_text(Deck(mesh, options).text())
    # Of a small program, or its memory would be that of this one.
    ended = subprocess.run(
        ["/usr/bin/time", "-f", "%e %U %S %M", "-o", "time", "prlimit",
         f"--cpu={options.seconds}", "ccx", "-i", "job"],
        cwd=folder, capture_output=True, text=True, errors="replace",
        check=False, env={**os.environ, "OMP_NUM_THREADS": "1"})
    wall, user, system, kilobytes = map(
        float, (folder / "time").read_text().splitlines()[-1].split())
    increments, attempts, newton, load = steps(folder / "job.sta")
    equations = re.findall(r"number of equations\s+(\d+)", ended.stdout)
    errors = re.findall(r"\*ERROR[^\n]*", ended.stdout)
    result = {"unknowns": int(equations[-1]) if equations else None,
              "newton": newton, "increments": increments,
              "cuts": attempts - increments, "reason": "", "wall": wall,
              "cpu": user + system, "memory": kilobytes / 1024}
    if "Job finished" not in ended.stdout or errors or load < 1 - 1e-6:
        said = errors[0][1:].strip() if errors else (
            f"no end within {options.seconds} s of CPU"
            if user + system > options.seconds - 1 else
            f"status {ended.returncode}")
        result["reason"] = f"load factor {load:.3g}: {said}"
    result["ok"] = not result["reason"]
    if result["ok"]:
        values = fields(folder / "job.frd", int(mesh.points["B"][0]) + 1)
        total = [line.split() for line in
                 (folder / "job.dat").read_text().splitlines() if line.strip()]
        result.update({"DY(B)": values["DISP"][1],
                       "SIYY(B)": values["STRESS"][1],
                       "force_error": float(total[-1][1]) / -LOAD - 1})
    return result


def main():
    options = options_of_call()
    if options.folder:
        folder = pathlib.Path(options.folder)
        folder.mkdir(parents=True, exist_ok=True)
        print(json.dumps(run(options, folder)))
    else:
        with tempfile.TemporaryDirectory() as folder:
            print(json.dumps(run(options, pathlib.Path(folder))))


if __name__ == "__main__":
    main()
