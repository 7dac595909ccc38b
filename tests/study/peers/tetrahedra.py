#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contact program beside CalculiX on tetrahedra of 10 nodes: Hertz' contact.

    tetrahedra.py [--sizes H,H...] [--seconds S] [--penalty K,K...] CONTACT

A quarter of a half sphere of radius 10 is pressed by APPROACH into a quarter of a
cylinder, without friction, in small strain. gmsh makes the mesh, edges of H mm in
the contact (0.18: 30 000 unknowns); both programs get the same nodes, middles of
sides included, surface to surface contact with the sphere as slave, one increment
to begin with, one thread. CalculiX has springs of K times Young's modulus of the
softer body (50 is its default for hard contact), its direct solver and CG with
incomplete Cholesky.

The reference is the same scene as rings: triangles of 6 nodes, edges REFERENCE
times as long, which both programs solve. The force F under the approach d becomes
the error of the approach by the exponent of the reference, F ~ d^m. Hertz'
half spaces are a row: the bodies are finite.

A Markdown table; exit status 1 if a run of the contact program has failed, or if
it took more CPU seconds than CalculiX.
"""

import argparse
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from space import MODULUS, RATIO, timed, timed_case

RADIUS, SIZE, APPROACH, REFERENCE = 10., 8., 0.1, 0.2
# A point at the pole; sizes grow from H within 1.3 mm of it, over the radius of
# the contact, to 14 H at 10 mm.
GEOMETRY = """SetFactory("OpenCASCADE");
R = {radius}; B = {size}; h = {h}; e = 1e-3; M = 100;
{bodies}
p() = Point In BoundingBox {{-e, -e, -e, e, e, e}};
Field[1] = Distance; Field[1].PointsList = {{p()}};
Field[2] = Threshold; Field[2].InField = 1; Field[2].SizeMin = h;
Field[2].SizeMax = 14*h; Field[2].DistMin = 1.3; Field[2].DistMax = 10;
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0; Mesh.MeshSizeFromPoints = 0;
Mesh.MshFileVersion = 2.2; Mesh.ElementOrder = 2; Mesh.HighOrderOptimize = 1;
"""
SOLIDS = """Sphere(1) = {0, 0, R, R, -Pi/2, 0, Pi/2};
Cylinder(2) = {0, 0, -B, 0, 0, B, B, Pi/2};
Physical Volume("Up") = {1}; Physical Volume("Low") = {2};
s() = Abs(Boundary{ Volume{1}; });
"""
RINGS = """Disk(1) = {0, R, 0, R};
Rectangle(3) = {0, 0, 0, R, R};
BooleanIntersection{ Surface{1}; Delete; }{ Surface{3}; Delete; }
Rectangle(2) = {0, -B, 0, B, B};
Physical Surface("Up") = {1}; Physical Surface("Low") = {2};
s() = Abs(Boundary{ Surface{1}; });
"""
# Sides of the bodies: what is between these values of the axis, 'u' that of the
# load, and of the body.
SIDES = {"Up_u1": ("u", "R"), "Low_u0": ("u", "-B"), "Low_u1": ("u", "0"),
         "Up_x0": ("x", "0"), "Low_x0": ("x", "0"), "Up_y0": ("y", "0"),
         "Low_y0": ("y", "0")}
TETRAHEDRON = {frozenset(f): i for i, f in enumerate(
    ((0, 1, 2), (0, 1, 3), (1, 2, 3), (2, 0, 3)), 1)}
TRIANGLE = {frozenset(f): i for i, f in enumerate(((0, 1), (1, 2), (2, 0)), 1)}


def geometry(h, is_ring):
    """The text of the file of gmsh."""
    axes = "xu" if is_ring else "xyu"
    kind = "Curve" if is_ring else "Surface"
    text = GEOMETRY.format(radius=RADIUS, size=SIZE, h=h,
                           bodies=RINGS if is_ring else SOLIDS)
    for name, (axis, value) in SIDES.items():
        if axis not in axes:
            continue
        low, high = ({a: sign + "M" for a in axes} for sign in ("-", ""))
        body = ("-e", "M") if name.startswith("Up") else ("-M", "e")
        low["u"], high["u"] = body
        low[axis], high[axis] = f"{value} - e", f"{value} + e"
        corners = [[box[a] for a in axes] + ["-e", "e"][i:i + 1] * is_ring
                   for i, box in enumerate((low, high))]
        text += (f'Physical {kind}("{name}") = {{{kind} In BoundingBox {{'
                 + ", ".join(sum(corners, [])) + "}};\n")
    # What is left of the sphere is its skin.
    first = 'Physical {0}("Up_skin") = {{s()}};\n'.format(kind)
    others = "".join(
        f's() -= {kind} In BoundingBox {{' + box + "};\n"
        for box in re.findall(r'"Up_\w+"\) = \{\w+ In BoundingBox \{([^}]*)\}',
                              text))
    return text + others + first


class Mesh:
    """Of gmsh: nodes, and elements by group."""

    def __init__(self, folder, h, is_ring):
        (folder / "mesh.geo").write_text(geometry(h, is_ring))
        subprocess.run(["gmsh", "-2" if is_ring else "-3", "mesh.geo", "-v", "1",
                        "-o", "mesh.msh"], cwd=folder, check=True)
        text = (folder / "mesh.msh").read_text()
        names = dict(re.findall(r'^\d (\d+) "(\w+)"$', text, re.MULTILINE))
        self.is_ring, self.groups = is_ring, {}
        rows = [line.split() for line in text.split("$Nodes\n")[1].split(
            "$EndNodes")[0].splitlines()[1:]]
        self.nodes = {int(row[0]): list(map(float, row[1:])) for row in rows}
        for line in text.split("$Elements\n")[1].splitlines()[1:-1]:
            _, _, _, tag, _, *nodes = map(int, line.split())
            self.groups.setdefault(names[str(tag)], []).append(nodes)


def run_contact(contact, is_ring, folder, seconds, increments=1):
    axis = "y" if is_ring else "z"
    bodies = {"Young's modulus": MODULUS,
              "Poisson's ratio": {body: RATIO for body in MODULUS}}
    entries = {
        "Mesh/File": "mesh.msh", "Mesh/Mid-side nodes": "true",
        "Element/Degree": 2, "Solids/Kinematics": "small strain",
        **{f"Solids/{name}": ", ".join(f"{b}: {v}" for b, v in values.items())
           for name, values in bodies.items()},
        f"Boundary conditions/Displacement {axis}":
            f"Up_u1: {-APPROACH}, Low_u0: 0",
        "Boundary conditions/Displacement x": "Up_x0: 0, Low_x0: 0",
        "Contact/Slave": "Up_skin", "Contact/Master": "Low_u1",
        "Solution/Increments": increments, "Output/Screen": "none",
        "Probes/Probes": f"F: reaction {axis}, Up_u1"}
    if is_ring:
        entries["Solids/Symmetry"] = "axisymmetric"
    else:
        entries["Boundary conditions/Displacement y"] = "Up_y0: 0, Low_y0: 0"
    result = timed_case(contact, entries, folder, seconds)
    path = folder / "output" / "case" / "summary.json"
    if result["status"] not in (0, 1) or not path.exists():
        said = (folder / "out").read_text(errors="replace").strip()[-200:]
        return {**result, "reason": f"status {result['status']}: {said}"}
    summary = json.loads(path.read_text())
    whole = 1 if is_ring else 4
    return {**result, "reason": summary.get("message", "")
            if not summary["converged"] else "",
            "forces": [-whole * i["probes"]["F"] for i in summary["increments"]],
            "newton": sum(i["newton_iterations"] for i in summary["increments"]),
            "unknowns": summary["unknowns"]["displacement"],
            "summary": summary}


def deck(mesh, penalty, solver):
    """The input of CalculiX."""
    axis = 2 if mesh.is_ring else 3
    kind, faces = ("CAX6", TRIANGLE) if mesh.is_ring else ("C3D10", TETRAHEDRON)
    lines = ["*NODE, NSET=ALL"]
    # Fields have at most 20 characters.
    lines += [f"{n}, " + ", ".join(f"{x:.12g}" for x in place)
              for n, place in mesh.nodes.items()]
    sides, number = {}, 0
    for body, modulus in MODULUS.items():
        lines.append(f"*ELEMENT, TYPE={kind}, ELSET={body}")
        for nodes in mesh.groups[body]:
            number += 1
            if not mesh.is_ring:
                nodes = [*nodes[:8], nodes[9], nodes[8]]
            lines.append(", ".join(map(str, (number, *nodes))))
            for corners, side in faces.items():
                sides[frozenset(nodes[c] for c in corners)] = number, side
        lines += [f"*MATERIAL, NAME={body}", "*ELASTIC", f"{modulus}, {RATIO}",
                  f"*SOLID SECTION, ELSET={body}, MATERIAL={body}"]
    for name in ("Up_skin", "Low_u1"):
        lines.append(f"*SURFACE, NAME={name}, TYPE=ELEMENT")
        for nodes in mesh.groups[name]:
            cell, side = sides[frozenset(nodes[:len(next(iter(faces)))])]
            lines.append(f"{cell}, S{side}")
    for name, elements in mesh.groups.items():
        if name in SIDES:
            lines += [f"*NSET, NSET=N{name}",
                      *(f"{n}," for n in sorted(set(sum(elements, []))))]
    held = [("Up_u1", axis, -APPROACH), ("Low_u0", axis, 0)] + [
        (name, 1 + "xy".index(a), 0) for name, (a, _) in SIDES.items()
        if a != "u" and name in mesh.groups]
    lines += ["*SURFACE INTERACTION, NAME=LAW",
              "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
              f"{penalty * min(MODULUS.values())}",
              "*CONTACT PAIR, INTERACTION=LAW, TYPE=SURFACE TO SURFACE",
              "Up_skin, Low_u1", "*STEP, INC=1000", f"*STATIC{solver}", "1., 1.",
              "*BOUNDARY"]
    lines += [f"N{name}, {d}, {d}, {u}" for name, d, u in held]
    lines += ["*NODE PRINT, NSET=NUp_u1, TOTALS=ONLY, FREQUENCY=9999", "RF",
              "*END STEP"]
    return "\n".join(lines) + "\n"


def run_calculix(mesh, penalty, solver, folder, seconds):
    for old in folder.glob("job.*"):
        old.unlink()
    (folder / "job.inp").write_text(deck(mesh, penalty, solver))
    result = timed(["ccx", "-i", "job"], folder, seconds)
    text = (folder / "out").read_text(errors="replace")
    rows = [line.split() for line in
            (folder / "job.sta").read_text().splitlines()
            if re.match(r"\s+\d", line)] if (folder / "job.sta").exists() else []
    done = [row for row in rows if not row[2].endswith("U")]
    if result["status"] or not done or float(done[-1][4]) < 1 - 1e-6:
        return {**result, "reason": f"no end within {seconds} s of CPU"
                if result["cpu"] > seconds - 1 else
                f"status {result['status']} after {len(done)} increments"}
    totals = [line.split() for line in
              (folder / "job.dat").read_text().splitlines() if line.strip()]
    # Of rings it has a sector of two degrees.
    whole, axis = (180, 1) if mesh.is_ring else (4, 2)
    return {**result, "forces": [-whole * float(totals[-1][axis])],
            "reason": "", "newton": sum(int(row[3]) for row in rows),
            "unknowns": int(re.findall(r"number of equations\s+(\d+)",
                                       text)[-1])}


def hertz():
    """The force of half spaces."""
    compliance = sum((1 - RATIO**2) / e for e in MODULUS.values())
    return 4 / 3 / compliance * math.sqrt(RADIUS) * APPROACH**1.5


def print_row(h, program, result, reference):
    cells = [h, program]
    if result["reason"]:
        cells += ["-", result["reason"], f"{result['cpu']:.1f}",
                  f"{result['memory']:.0f}", "-", "-"]
    else:
        force = result["forces"][-1]
        error = "-"
        if reference:
            full, exponent = reference
            error = f"{100 * ((full / force)**(1 / exponent) - 1):+.3f} %"
        cells += [result["unknowns"], result["newton"], f"{result['cpu']:.1f}",
                  f"{result['memory']:.0f}", f"{force:.2f}", error]
    print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("contact", type=pathlib.Path)
    parser.add_argument("--sizes", default="0.18,0.12", help="[0.18,0.12]")
    parser.add_argument("--penalty", default="50", help="[50]")
    parser.add_argument("--seconds", type=int, default=600, help="[600]")
    options = parser.parse_args()
    contact = options.contact.resolve()
    print(f"Load of the machine before: {os.getloadavg()[0]:.2f}\n")
    columns = ("h [mm]", "program", "unknowns", "Newton steps", "CPU [s]",
               "memory [MB]", "force [N]", "error of the approach")
    print("| " + " | ".join(columns) + " |\n" + "|---" * len(columns) + "|",
          flush=True)
    sizes = [float(h) for h in options.sizes.split(",")]
    penalties = [float(k) for k in options.penalty.split(",")]
    ahead = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        h = REFERENCE * min(sizes)
        mesh = Mesh(folder, h, True)
        rings = run_contact(contact, True, folder, options.seconds, 2)
        print_row(h, "rings, contact program", rings, None)
        print_row(h, f"rings, CalculiX, {max(penalties):g} E", run_calculix(
            mesh, max(penalties), "", folder, options.seconds), None)
        if rings["reason"]:
            return 1
        half, full = rings["forces"][-2:]
        reference = full, math.log2(full / half)
        print_row("", "Hertz, half spaces", {
            "reason": "", "forces": [hertz()], "newton": "-", "unknowns": "-",
            "cpu": 0, "memory": 0}, reference)
        for h in sizes:
            mesh = Mesh(folder, h, False)
            ours = run_contact(contact, False, folder, options.seconds)
            print_row(h, "contact program", ours, reference)
            ahead.append(not ours["reason"])
            for penalty in penalties:
                for what, solver in (("direct", ""), (
                        "iterative", ", SOLVER=ITERATIVE CHOLESKY")):
                    theirs = run_calculix(mesh, penalty, solver, folder,
                                          options.seconds)
                    print_row(h, f"CalculiX, {penalty:g} E, {what}", theirs,
                              reference)
                    ahead.append(ours["cpu"] < theirs["cpu"] or
                                 bool(theirs["reason"]))
    return int(not all(ahead))


if __name__ == "__main__":
    sys.exit(main())
