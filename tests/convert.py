#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes from elsewhere.

Proves that meshes/convert.py keeps what a MED file says: the cylinder on the
block, written as MED by the library of that format (MED-fichier) with linear
elements, with 6 and 8 nodes, and with 7 and 9, gives the results of the own
mesh file. A point is a group of one node as well as a point element, elements
are in two groups, and a group of faces overlaps with the bodies. A file of
version 2.3, by the same library, gives them as well. Besides, that an Abaqus file
keeps its names, what is said of round sides that become straight, and of a mesh
that is no use. Where the
reference mesh is at hand, which is Code_Aster's, that it gives the published
values on its way through MED as well.

Usage: convert.py CONTACT PARAMETERS MESHES
"""

import json
import math
import os
import pathlib
import subprocess
import sys

try:
    import h5py
    import meshio
    from med.medenum import MED_PYRA5, MED_TRIA3
    from med_files import (CENTRED, LINEAR, QUADRATIC, write_med, write_med_2)
except ImportError as missing:
    print(f"skipped: {missing}; apt-get install python3-meshio python3-h5py "
          "python3-med")
    sys.exit(0)

CONVERTER = pathlib.Path(__file__).resolve().parents[1] / "meshes/convert.py"
CASES = pathlib.Path(__file__).resolve().parent / "reference/published"

# The same computations up to the order of the cells: far above round-off, far
# below what another mesh would change.
TOLERANCE = 1e-9

ABAQUS = """*NODE
1, 0, 0
2, 1, 0
3, 1, 1
4, 0, 1
5, 1, 2
6, 0, 2
*ELEMENT, TYPE=CPS4, ELSET=Lower
1, 1, 2, 3, 4
*ELEMENT, TYPE=CPS4, ELSET=Upper
2, 4, 3, 5, 6
*ELEMENT, TYPE=T2D2, ELSET=Top
3, 5, 6
*NSET, NSET=Corner
6
"""

failures = 0


def check(what, ok, detail=""):
    global failures
    print(("ok: " if ok else "FAILED: ") + what + (f" ({detail})" if detail
                                                   and not ok else ""))
    failures += not ok


def read_own(path):
    """Points, elements with their groups, and named nodes of an own mesh."""
    mesh = meshio.read(path)
    names = {(d, tag): name for name, (tag, d) in mesh.field_data.items()}
    dimension = {"vertex": 0, "line": 1, "triangle": 2, "quad": 2}
    elements, named = {}, {}
    for block, tags in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
        for nodes, tag in zip(block.data, tags):
            name = names.get((dimension[block.type], int(tag)))
            groups = [name] if name else []
            nodes = [int(n) for n in nodes]
            if block.type == "vertex":
                named[name] = nodes[0]
            elif dimension[block.type] == 2:
                groups.append("Everything")
            elif name == "Bottom_C":
                groups.append("Also")
            elements.setdefault(block.type, []).append((nodes, groups))
    elements["vertex"] = [([named.pop("C")], ["C"])]
    points = [[float(x), float(y)] for x, y, _ in mesh.points]
    groups = {}
    for name, node in named.items():
        groups.setdefault(node, ["Several"]).append(name)
    return points, elements, groups


def second_order(points, elements, with_centre):
    """Nodes midway on the sides, and in the centre of cells."""
    points, between = list(points), {}

    def node(*corners):
        key = tuple(sorted(corners))
        if key not in between:
            between[key] = len(points)
            points.append([sum(points[c][d] for c in corners) / len(corners)
                           for d in range(2)])
        return between[key]

    raised = {}
    for kind, entries in elements.items():
        for corners, groups in entries:
            n = len(corners)
            sides = {1: [], 2: [(0, 1)]}.get(
                n, [(i, (i + 1) % n) for i in range(n)])
            nodes = corners + [node(corners[a], corners[b]) for a, b in sides]
            if with_centre and n > 2:
                nodes.append(node(*corners))
            raised.setdefault(kind, []).append((nodes, groups))
    return points, raised


def convert(*arguments):
    return subprocess.run([sys.executable, CONVERTER, *arguments], text=True,
                          capture_output=True)


def results(contact, case, mesh):
    """Probes and contact of a case on a mesh."""
    run = subprocess.run(
        [contact, case, "--quiet", "--set", f"Mesh/File={mesh}", "--set",
         f"Output/Directory={mesh.stem}", "--set", "Output/VTU=false"],
        text=True, capture_output=True)
    if run.returncode not in (0, 1):
        return {"error": run.stderr}
    summary = json.loads(
        (pathlib.Path(mesh.stem) / case.stem / "summary.json").read_text())
    return ({p["name"]: p["value"] for p in summary["probes"]}
            | summary["contact"])


def compare(contact, case, mesh, reference, what):
    values = results(contact, case, mesh)
    off = {name: values.get(name) for name, value in reference.items()
           if not abs(values.get(name, 1e300) - value)
           <= TOLERANCE * abs(value)}
    check(what, not off, f"{off or values} instead of {reference}")


def reference_mesh(contact, med, msh):
    """The published values on the reference mesh, written as MED."""
    source = pathlib.Path(os.environ.get("REFERENCE_DIRECTORY", "none"),
                          "ssnp154-linear.msh")
    if not source.is_file():
        print(f"not compared: no {source}")
        return
    points, elements, node_groups = read_own(source)
    write_med(med, points, elements, node_groups, LINEAR)
    run = convert("--bodies", "Block,Cylinder", med, msh)
    check("the reference mesh as MED", run.returncode == 0, run.stderr)
    cases = sorted(CASES.glob("[a-g].prm"))
    run = subprocess.run([contact, *cases, "--quiet", "--set",
                          f"Mesh/File={msh.absolute()}"], text=True,
                         capture_output=True)
    check(f"its published values, {len(cases)} modelings", run.returncode == 0,
          run.stdout + run.stderr)


def ring(n, quarter_only):
    """Half a ring, 10 to 20, of 2 n quadrangles of 8 nodes. The group Bore is all
    of the inner arc, or a quarter of it; Outside is the outer arc with the end
    on the right, which is straight."""
    points, index = [], {}

    def node(radius, step):  # steps of half a side
        if (radius, step) not in index:
            index[radius, step] = len(points)
            angle = math.pi * step / (4 * n)
            points.append([radius * math.cos(angle), radius * math.sin(angle)])
        return index[radius, step]

    quads, lines = [], []
    for s in range(0, 4 * n, 2):
        quads.append(([node(10, s), node(20, s), node(20, s + 2),
                       node(10, s + 2), node(15, s), node(20, s + 1),
                       node(15, s + 2), node(10, s + 1)], ["Ring"]))
        lines.append(([node(20, s), node(20, s + 2), node(20, s + 1)],
                      ["Outside"]))
        if s < 2 * n or not quarter_only:
            lines.append(([node(10, s), node(10, s + 2), node(10, s + 1)],
                          ["Bore"]))
    lines.append(([node(10, 0), node(20, 0), node(15, 0)], ["Outside"]))
    return points, {"quad": quads, "line": lines}


def round_sides(med, msh):
    """What is said of sides that become straight."""
    n = 8
    for quarter_only in (False, True):
        points, elements = ring(n, quarter_only)
        write_med(med, points, elements, {}, QUADRATIC)
        run = convert(med, msh)
        which = "a quarter" if quarter_only else "all"
        check(f"round, {which} in a group: converted", run.returncode == 0,
              run.stderr)
        check(f"round, {which} in a group: its circle",
              "Mesh/Arcs = Bore: 0, 0, 10\n" in run.stdout, run.stdout)
        # From the middle of a chord to its circle.
        rises = [r * (1 - math.cos(math.pi / (4 * n))) for r in (20, 10)]
        notes = [line for line in run.stderr.splitlines() if "note: " in line]
        check(f"round, {which} in a group: the group with a straight line",
              f"{2 * n} round sides" in notes[0] and "'Outside'" in notes[0]
              and f"by up to {rises[0]:.3g}." in notes[0], run.stderr)
        check(f"round, {which} in a group: sides of no group",
              len(notes) == 1 + quarter_only and
              (not quarter_only or f"{n} round sides" in notes[1]
               and "in no group" in notes[1]
               and f"by up to {rises[1]:.3g}." in notes[1]), run.stderr)
        check(f"round, {which} in a group: where",
              ("from (-3.82683, 9.2388) to (-1.9509, 9.80785): 0.0482"
               in run.stderr) == quarter_only, run.stderr)


def refuse(what, text, *arguments):
    run = convert(*arguments)
    check(what, run.returncode == 2 and text in run.stderr
          and "remedy: " in run.stderr, run.stderr)


def main():
    contact, parameters, meshes = map(pathlib.Path, sys.argv[1:4])
    case = parameters / "ssnp154_g.prm"
    own = meshes / "ssnp154.msh"
    points, elements, node_groups = read_own(own)
    reference = results(contact, case, own)
    check("the own mesh", "DY(B)" in reference, reference)

    med, msh = pathlib.Path("mesh.med"), pathlib.Path("mesh.msh")
    kinds = {"linear elements": (points, elements, LINEAR),
             "6 and 8 nodes": (*second_order(points, elements, False),
                               QUADRATIC),
             "7 and 9 nodes": (*second_order(points, elements, True), CENTRED)}
    for kind, (p, e, types) in kinds.items():
        middle = {} if p is points else {len(points): ["Halfway"]}
        write_med(med, p, e, {**node_groups, **middle}, types)
        msh.unlink(missing_ok=True)
        run = convert("--bodies", "Block,Cylinder", med, msh)
        check(f"MED, {kind}: converted", run.returncode == 0, run.stderr)
        check(f"MED, {kind}: a group of several corners is written, one with "
              "the middle of an edge is reported",
              '"Several"' in msh.read_text() and
              ("'Halfway'" in run.stdout) == bool(middle), run.stdout)
        compare(contact, case, msh.absolute(), reference,
                f"MED, {kind}: results of the own mesh")
    old = pathlib.Path("old.med")
    write_med_2(old, points, elements, node_groups, LINEAR)
    run = convert("--bodies", "Block,Cylinder", old, msh)
    check("MED 2.3: converted", run.returncode == 0, run.stderr)
    compare(contact, case, msh.absolute(), reference,
            "MED 2.3: results of the own mesh")
    with h5py.File(old, "r+") as file:
        file["INFOS_GENERALES"].attrs["MIN"] = 1
    refuse("MED 2.1", "MED 2.1 is not read", old, msh)
    round_sides(pathlib.Path("round.med"), msh)
    reference_mesh(contact, pathlib.Path("reference.med"), msh)
    refuse("overlapping groups", "--bodies", med, msh)
    refuse("an unknown body", "'Blok'", "--bodies", "Blok,Cylinder", med, msh)

    # As Code_Aster names them.
    aster = pathlib.Path("mesh.mmed")
    med.rename(aster)
    check(".mmed", convert("--bodies", "Block,Cylinder", aster, msh).returncode
          == 0)

    pathlib.Path("two.inp").write_text(ABAQUS)
    run = convert("two.inp", "two.msh")
    found = run.stdout.strip().splitlines()[-3:]
    check("Abaqus: names", found == ["bodies: Lower (1), Upper (1)",
                                     "boundaries: Top (1)",
                                     "points: Corner (1)"],
          run.stdout + run.stderr)

    bare = {"quad": [(nodes, []) for nodes, _ in elements["quad"]]}
    write_med(med, points, bare, {}, LINEAR)
    refuse("no groups", "groups of faces: none", med, msh)
    solid = {"pyramid": [([0, 1, 2, 3, 4], ["Solid"])]}
    write_med(med, [[0., 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1]], solid,
              {}, {"pyramid": MED_PYRA5})
    run = convert(med, msh)
    check("a mesh of pyramids", "bodies: Solid (1)" in run.stdout,
          run.stdout + run.stderr)
    tilted = {"triangle": [([0, 1, 2], ["Plate"])]}
    write_med(med, [[0., 0, 0], [1, 0, 0], [0, 1, 1]], tilted, {},
              {"triangle": MED_TRIA3})
    refuse("a mesh out of a plane", "not plane", med, msh)
    pathlib.Path("text.med").write_text("no mesh")
    refuse("no mesh at all", "cannot be read", "text.med", msh)
    refuse("no file", "does not exist", "absent.med", msh)
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()
