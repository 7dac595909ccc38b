# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small scenes of blocks and rings, written, run by the program and read, for
the scripts beside this one. The first argument of a script is the program."""

import csv
import json
import math
import pathlib
import subprocess
import sys

contact = pathlib.Path(sys.argv[1]).resolve()
failures = []


def check(what, ok, detail=""):
    print(f"{'ok' if ok else 'FAILED'}: {what} {detail}")
    if not ok:
        failures.append(what)


class Mesh:
    """Blocks of quadrangles, mapped, with named sides."""

    def __init__(self):
        self.nodes, self.elements, self.groups = [], [], {}

    def add(self, dimension, group, corners):
        tag = self.groups.setdefault((dimension, group), len(self.groups) + 1)
        kind = {0: 15, 1: 1, 2: 3}[dimension]
        self.elements.append((kind, tag, corners))

    def block(self, body, nx, ny, chart, sides, closed=False):
        """Sides: bottom, right, top, left; closed: left is right."""
        columns = nx if closed else nx + 1
        first = len(self.nodes) + 1
        for j in range(ny + 1):
            for i in range(columns):
                self.nodes.append(chart(i / nx, j / ny))

        def node(i, j):
            return first + j * columns + i % columns
        for j in range(ny):
            for i in range(nx):
                self.add(2, body, (node(i, j), node(i + 1, j),
                                   node(i + 1, j + 1), node(i, j + 1)))
        for side, a, b in (
                [("bottom", (i, 0), (i + 1, 0)) for i in range(nx)] +
                [("top", (i, ny), (i + 1, ny)) for i in range(nx)] +
                [("left", (0, j), (0, j + 1)) for j in range(ny)] +
                [("right", (nx, j), (nx, j + 1)) for j in range(ny)]):
            if side in sides:
                self.add(1, sides[side], (node(*a), node(*b)))
        if "corner" in sides:
            self.add(0, sides["corner"], (node(0, 0),))

    def merge(self):
        """One node for those at the same place."""
        first = {}
        same = [first.setdefault(p, i + 1) for i, p in enumerate(self.nodes)]
        self.elements = [(kind, tag, tuple(same[c - 1] for c in corners))
                         for kind, tag, corners in self.elements]

    def write(self, name):
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
                 str(len(self.groups))]
        lines += [f'{d} {tag} "{g}"' for (d, g), tag in self.groups.items()]
        lines += ["$EndPhysicalNames", "$Nodes", str(len(self.nodes))]
        lines += [f"{i + 1} {x!r} {y!r} 0"
                  for i, (x, y) in enumerate(self.nodes)]
        lines += ["$EndNodes", "$Elements", str(len(self.elements))]
        lines += [f"{i + 1} {kind} 2 {tag} {tag} " + " ".join(map(str, corners))
                  for i, (kind, tag, corners) in enumerate(self.elements)]
        lines += ["$EndElements", ""]
        pathlib.Path(f"{name}.msh").write_text("\n".join(lines))


def box(x0, y0, x1, y1):
    return lambda s, t: (x0 + s * (x1 - x0), y0 + t * (y1 - y0))


def ring(r0, r1):
    return lambda s, t: ((r0 + t * (r1 - r0)) * math.cos(2 * math.pi * s),
                         (r0 + t * (r1 - r0)) * math.sin(-2 * math.pi * s))


def run(name, entries, ranks=1):
    """Returns status, what was said, and the summary."""
    sections = {}
    for entry, value in entries.items():
        section, key = entry.split("/")
        sections.setdefault(section, []).append(f"  set {key} = {value}\n")
    pathlib.Path(f"{name}.prm").write_text("".join(
        f"subsection {section}\n{''.join(lines)}end\n"
        for section, lines in sections.items()))
    command = [str(contact), f"{name}.prm", "--quiet"]
    if ranks > 1:
        command = ["mpirun", "-np", str(ranks)] + command
    result = subprocess.run(command, capture_output=True, text=True)
    summary = pathlib.Path(f"output/{name}/summary.json")
    return (result.returncode, result.stdout + result.stderr,
            json.loads(summary.read_text()) if summary.exists() else {})


def violations(summary):
    """The invariants that are violated, each in a sentence."""
    return [f["text"] for f in summary.get("findings", [])
            if f["severity"] == "violated"]


def rows(name, file="profile.csv"):
    with open(f"output/{name}/{file}", encoding="utf-8") as lines:
        return [{k: v if k in ("surface", "body") else float(v or "nan")
                 for k, v in row.items()} for row in csv.DictReader(lines)]


def solve(path, *settings, ranks=1):
    """Run a parameter file with settings on top, for its values alone. Returns
    status, what was said, and the summary."""
    command = [str(contact), str(path), "--quiet"]
    for setting in settings:
        command += ["--set", setting]
    if ranks > 1:
        command = ["mpirun", "-np", str(ranks)] + command
    result = subprocess.run(command, capture_output=True, text=True)
    summary = pathlib.Path(f"output/{path.stem}/summary.json")
    return (result.returncode, result.stdout + result.stderr,
            json.loads(summary.read_text()) if summary.exists() else {})
