#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contact program beside CalculiX in 3-D, on the same meshes.

    space.py [--sizes N,N...] [--seconds S] [--scene NAME] CONTACT

Two scenes of hexahedra with 8 nodes, large displacement, one thread each:

- sphere: a quarter of a block with a spherical bottom pressed into a block;
- blocks: a block pressed on another one and then dragged along it, friction 0.3.

N is the number of cells along an edge of the upper body (a multiple of 3), the
lower one has 4/3 as many: 12 are 21330 unknowns. CalculiX has surface to surface
contact with springs of 50 times Young's modulus of the softer body (its default
for hard contact) and its own increments in each step. The reference is the
contact program's own on meshes with half as long edges. No run takes more than S
seconds of CPU. A Markdown table; exit status 1 if a run of the contact program
has failed, or if it took more CPU seconds than CalculiX.
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

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))
from volume_scenes import Volumes  # noqa: E402

MODULUS = {"Low": 70000., "Up": 210000.}
RATIO = 0.3
PENALTY = 50 * MODULUS["Low"]
FRICTION = 0.3
ONE_CORE = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
            "DEAL_II_NUM_THREADS": "1"}
# Sides of a cell in the numbering of CalculiX, by corners.
SIDES = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6),
         (3, 0, 4, 7))


def box(lo, hi):
    return lambda *r: tuple(a + (b - a) * c for a, b, c in zip(lo, hi, r))


def rounded(r, s, t):
    """A block of side 6 with a bottom of radius 20."""
    x, y = 6 * r, 6 * s
    bottom = 20 - math.sqrt(400 - x * x - y * y)
    return x, y, bottom + (6 - bottom) * t


# By name the upper and the lower body, displacements held at zero, the steps,
# each by what the head is moved by, the direction of the force that is compared.
SCENES = {
    "sphere": (rounded, box((0, 0, -8), (8, 8, 0)), 0.,
               {"x": ("Up_x0", "Low_x0"), "y": ("Up_y0", "Low_y0"),
                "z": ("Low_z0",)},
               ({"z": -.2},), "z"),
    "blocks": (box((0, 0, 0), (6, 6, 6)), box((-2, -1, -8), (8, 7, 0)), FRICTION,
               {"x": ("Low_z0",), "y": ("Low_z0", "Up_y0"), "z": ("Low_z0",)},
               ({"z": -.05}, {"z": -.05, "x": .03}), "x"),
}


def mesh_of(scene, n):
    up, low = SCENES[scene][:2]
    mesh = Volumes()
    mesh.block("Up", (n, n, n), up)
    mesh.block("Low", (4 * n // 3,) * 3, low)
    return mesh


def run_contact(contact, scene, folder, seconds):
    *_, friction, held, steps, direction = SCENES[scene]
    entries = {
        "Mesh/File": "mesh.msh", "Element/Degree": 1,
        "Solids/Young's modulus":
            ", ".join(f"{b}: {e}" for b, e in MODULUS.items()),
        "Solids/Poisson's ratio": f"Low: {RATIO}, Up: {RATIO}",
        "Solids/Kinematics": "large displacement",
        "Contact/Slave": "Up_z0", "Contact/Master": "Low_z1",
        "Contact/Friction coefficient": friction,
        "Solution/Increments": len(steps), "Output/Screen": "none",
        "Probes/Probes": f"F: reaction {direction}, Up_z1"}
    histories = {"z": "min(1, 2*t)", "x": "max(0, 2*t - 1)"}
    for axis, groups in held.items():
        values = [f"{g}: 0" for g in groups]
        if axis in steps[-1]:
            values.append(f"Up_z1: {steps[-1][axis]}")
        entries[f"Boundary conditions/Displacement {axis}"] = ", ".join(values)
    if len(steps) > 1:
        entries["Boundary conditions/Histories"] = "; ".join(
            f"Displacement {a}: {h}" for a, h in histories.items())
    result = timed_case(contact, entries, folder, seconds)
    path = folder / "output" / "case" / "summary.json"
    if result["status"] != 0 or not path.exists():
        return {**result, "reason": f"status {result['status']}"}
    summary = json.loads(path.read_text())
    return {**result, "force": summary["probes"][0]["value"],
            "newton": sum(i["newton_iterations"]
                          for i in summary["increments"]),
            "increments": len(summary["increments"]), "reason": "",
            "solver": summary["effects"]["system"].split(", ")[1],
            "unknowns": summary["unknowns"]["displacement"]}


def deck(mesh, scene):
    """The input of CalculiX."""
    *_, friction, held, steps, _ = SCENES[scene]
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{i + 1}, {x:.15g}, {y:.15g}, {z:.15g}"
              for i, (x, y, z) in enumerate(mesh.nodes)]
    names = {tag: name for (_, name), tag in mesh.groups.items()}
    sides, sets, number = {}, {}, 0
    for body, modulus in MODULUS.items():
        lines.append(f"*ELEMENT, TYPE=C3D8, ELSET={body}")
        for kind, tag, nodes in mesh.elements:
            if kind != 5 or names[tag] != body:
                continue
            number += 1
            lines.append(", ".join(map(str, (number, *nodes))))
            for side, corners in enumerate(SIDES):
                sides[body, frozenset(nodes[c] for c in corners)] = \
                    number, side + 1
        lines += [f"*MATERIAL, NAME={body}", "*ELASTIC", f"{modulus}, {RATIO}",
                  f"*SOLID SECTION, ELSET={body}, MATERIAL={body}"]
    for name in ("Up_z0", "Low_z1"):
        lines.append(f"*SURFACE, NAME={name}, TYPE=ELEMENT")
        for kind, tag, nodes in mesh.elements:
            if kind == 3 and names[tag] == name:
                cell, side = sides[name.split("_", maxsplit=1)[0],
                                   frozenset(nodes)]
                lines.append(f"{cell}, S{side}")
    for kind, tag, nodes in mesh.elements:
        if kind == 3:
            sets.setdefault(names[tag], set()).update(nodes)
    for name, nodes in sets.items():
        lines += [f"*NSET, NSET=N{name}", *(f"{n}," for n in sorted(nodes))]
    lines += ["*SURFACE INTERACTION, NAME=LAW",
              "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{PENALTY}"]
    if friction:
        lines += ["*FRICTION", f"{friction}, {PENALTY / 10}"]
    lines += ["*CONTACT PAIR, INTERACTION=LAW, TYPE=SURFACE TO SURFACE",
              "Up_z0, Low_z1"]
    for step in steps:
        lines += ["*STEP, INC=1000, NLGEOM", "*STATIC", "1., 1.", "*BOUNDARY"]
        lines += [f"N{g}, {'xyz'.index(a) + 1}, {'xyz'.index(a) + 1}"
                  for a, groups in held.items() for g in groups]
        lines += [f"NUp_z1, {'xyz'.index(a) + 1}, {'xyz'.index(a) + 1}, {u}"
                  for a, u in step.items()]
        lines += ["*NODE PRINT, NSET=NUp_z1, TOTALS=ONLY, FREQUENCY=9999", "RF",
                  "*END STEP"]
    return "\n".join(lines) + "\n"


def run_calculix(mesh, scene, folder, seconds):
    (folder / "job.inp").write_text(deck(mesh, scene))
    result = timed(["ccx", "-i", "job"], folder, seconds)
    rows = [line.split() for line in
            (folder / "job.sta").read_text().splitlines()
            if re.match(r"\s+\d", line)] if (folder / "job.sta").exists() else []
    done = [row for row in rows if not row[2].endswith("U")]
    n_steps = len(SCENES[scene][4])
    if result["status"] or not done or done[-1][0] != str(n_steps) or \
            float(done[-1][4]) < n_steps - 1e-6:
        return {**result, "reason": f"no end within {seconds} s of CPU"
                if result["cpu"] > seconds - 1 else
                f"status {result['status']} after {len(done)} increments"}
    totals = [line.split() for line in
              (folder / "job.dat").read_text().splitlines() if line.strip()]
    return {**result, "force":
                float(totals[-1]["xyz".index(SCENES[scene][5])]),
            "newton": sum(int(row[3]) for row in rows), "solver": "its default",
            "increments": len(done), "reason": "", "unknowns": int(re.findall(
                r"number of equations\s+(\d+)",
                (folder / "out").read_text(errors="replace"))[-1])}


def timed_case(contact, entries, folder, seconds):
    """The program on a case of these entries, by 'section/entry'."""
    lines = []
    for name, value in entries.items():
        section, entry = name.split("/", 1)
        lines += [f"subsection {section}", f"  set {entry} = {value}", "end"]
    (folder / "case.prm").write_text("\n".join(lines) + "\n")
    return timed([str(contact), "case.prm", "--quiet"], folder, seconds)


def timed(command, folder, seconds):
    with open(folder / "out", "wb") as out:
        process = subprocess.Popen(["prlimit", f"--cpu={seconds}", *command],
                                   cwd=folder, stdout=out,
                                   stderr=subprocess.STDOUT,
                                   env={**os.environ, **ONE_CORE})
        _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return {"status": process.returncode,
            "cpu": usage.ru_utime + usage.ru_stime,
            "memory": usage.ru_maxrss / 1024}


def print_row(scene, n, program, result, reference):
    cells = [scene, n, program]
    if result["reason"]:
        cells += ["-", result["reason"], "-", "-", f"{result['cpu']:.1f}",
                  f"{result['memory']:.0f}", "-", "-"]
    else:
        error = (f"{100 * (result['force'] / reference - 1):+.2f} %"
                 if reference else "-")
        cells += [result["unknowns"], result["solver"], result["increments"],
                  result["newton"], f"{result['cpu']:.1f}",
                  f"{result['memory']:.0f}", f"{result['force']:.2f}", error]
    print("| " + " | ".join(map(str, cells)) + " |", flush=True)


def compare(options, scene, n):
    """Whether the contact program has an answer in less time."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        reference = None
        if options.reference:
            mesh_of(scene, 2 * n).write(folder / "mesh")
            reference = run_contact(options.contact, scene, folder, 100000)
            print_row(scene, 2 * n, "contact program, reference", reference, None)
            reference = reference.get("force")
        mesh = mesh_of(scene, n)
        mesh.write(folder / "mesh")
        ours = run_contact(options.contact, scene, folder, options.seconds)
        print_row(scene, n, "contact program", ours, reference)
        theirs = run_calculix(mesh, scene, folder, options.seconds)
        print_row(scene, n, "CalculiX", theirs, reference)
    return not ours["reason"] and ours["cpu"] < theirs["cpu"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("contact", type=pathlib.Path)
    parser.add_argument("--sizes", default="12,18", help="[12,18]")
    parser.add_argument("--scene", choices=SCENES, action="append")
    parser.add_argument("--seconds", type=int, default=600, help="[600]")
    parser.add_argument("--no-reference", dest="reference", action="store_false")
    options = parser.parse_args()
    options.contact = options.contact.resolve()
    print(f"Load of the machine before: {os.getloadavg()[0]:.2f}\n")
    columns = ("scene", "cells", "program", "unknowns", "linear solver",
               "increments", "Newton steps", "CPU [s]", "memory [MB]",
               "force [N]", "error")
    print("| " + " | ".join(columns) + " |\n" + "|---" * len(columns) + "|",
          flush=True)
    ahead = [compare(options, scene, int(n)) for scene in
             options.scene or SCENES for n in options.sizes.split(",")]
    return int(not all(ahead))


if __name__ == "__main__":
    sys.exit(main())
