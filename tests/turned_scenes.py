#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes that supports turn as a whole, or by more than half a turn.

Proves that what a rigid rotation may not change stays:

- pressures and shears of a press fit, whose surfaces an interference keeps apart,
  between two bodies and on an obstacle that turns with the body, also behind a
  restart;
- pressure and shear of glued surfaces, in probes, the summary and the profile;

and that the rotation of a rigid boundary goes on beyond half a turn, in 3-D as
well, and the moment
of an obstacle is that of the forces on the body, across an interference as well.

Usage: turned_scenes.py CONTACT PARAMETERS MESHES
"""

import json
import math
import pathlib
import shutil
import subprocess
import sys
import time

from block_scenes import Mesh, box, check, contact, failures, rows, run
from volume_scenes import Volumes

SOLIDS = {"Solids/Young's modulus": "A: 1000, B: 1000",
          "Solids/Poisson's ratio": "A: 0.3, B: 0.3"}


def turned(groups, angle, down="0", aside="0"):
    """Displacements that first push by (aside, down), groups other than the first
    alone, and then turn all of them about the origin; functions of time."""
    phi = f"({angle!r}*max(0,2*t-1))"
    ways = {"x": [], "y": []}
    for k, group in enumerate(groups):
        x, y = f"(x+{aside if k else 0})", f"(y+{down if k else 0})"
        ways["x"].append(f"{group}: {x}*cos{phi}-{y}*sin{phi}-x")
        ways["y"].append(f"{group}: {x}*sin{phi}+{y}*cos{phi}-y")
    return {f"Boundary conditions/Displacement formula {d}": "; ".join(of)
            for d, of in ways.items()}


def two_blocks(name):
    mesh = Mesh()
    mesh.block("A", 4, 2, box(-2, -2, 2, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 5, 2, box(-1.5, 0, 1.5, 2), {"bottom": "Sole", "top": "Head"})
    mesh.write(name)


def values(summary):
    return {probe["name"]: probe["value"] for probe in summary["probes"]}


def difference(first, second):
    return max(abs(first[k] - second[k]) / max(1e-3, abs(first[k])) for k in first)


PROBES = "p: pressure, C; q: shear, C; E: strain energy, B"


def press_fit():
    two_blocks("press_fit")
    found = []
    for angle in (0., math.pi / 2):
        status, said, summary = run("press_fit", {
            "Mesh/File": "press_fit.msh", "Mesh/Points": "C in B: -1.5, 0", **SOLIDS,
            **turned(("Base", "Head"), angle), "Contact/Slave": "Sole",
            "Contact/Master": "Ground", "Contact/Friction coefficient": 0.5,
            "Contact/Interference": "0.05*min(1,2*t)", "Solution/Increments": 8,
            "Probes/Probes": PROBES})
        check(f"a press fit turned by {angle:.3g}", status == 0, said[-300:])
        found.append(values(summary))
    worst = difference(*found)
    check(f"  pressure, shear, energy as before: {worst:.1e}", worst < 1e-6)


def on_an_obstacle():
    two_blocks("on_an_obstacle")
    found = []
    for angle in (0., 1.2):
        status, said, summary = run("on_an_obstacle", {
            "Mesh/File": "on_an_obstacle.msh", "Mesh/Points": "C in B: -1.5, 0",
            **SOLIDS, **turned(("Base", "Head"), angle, "-0.1*min(1,4*t)",
                               "0.03*max(0,min(1,4*t-1))"),
            "Contact/Slave": "Sole", "Contact/Obstacle": "half plane: 0, 0, 0, 1",
            "Contact/Obstacle centre": "0, 0",
            "Contact/Obstacle motion": f"angle: {math.degrees(angle)!r}*max(0,2*t-1)",
            "Contact/Friction coefficient": 0.3,
            "Contact/Interference": "0.05*min(1,2*t)", "Solution/Increments": 16,
            "Probes/Probes": PROBES + "; M: obstacle moment z, Contact"})
        check(f"with an obstacle, turned by {angle:.3g}", status == 0, said[-300:])
        found.append(values(summary))
    worst = difference(*found)
    check(f"  pressure, shear, energy, moment as before: {worst:.1e}", worst < 1e-6)

    # The case that turns, in more increments, to have the time to end it.
    command = [str(contact), "on_an_obstacle.prm", "--quiet", "--set",
               "Solution/Increments=64", "--set", "Output/VTU=true"]
    results = pathlib.Path("output/on_an_obstacle")
    found = []
    for ends in (False, True):
        shutil.rmtree(results)
        with subprocess.Popen(command, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as process:
            while (ends and process.poll() is None and
                   not (results / "bodies_0045_0.vtu").exists()):
                time.sleep(0.002)
            if ends:
                process.terminate()
        if process.returncode != 0:
            subprocess.run([*command, "--restart"], capture_output=True, check=False)
        found.append(values(json.loads((results / "summary.json").read_text())))
    worst = difference(*found)
    check(f"  the same after a restart, exit status {process.returncode} before: "
          f"{worst:.1e}", worst < 1e-6)


def glue():
    two_blocks("glue")
    for rule in "mortar", "nodal":
        found = []
        for angle in (0., math.pi / 2, math.pi):
            status, said, summary = run("glue", {
                "Mesh/File": "glue.msh", "Mesh/Points": "C in B: -1.5, 0", **SOLIDS,
                **turned(("Base", "Head"), angle, "-0.1*min(1,2*t)",
                         "0.05*min(1,2*t)"),
                "Contact/Slave": "Sole", "Contact/Master": "Ground",
                "Contact/Discretization": rule, "Contact/Tied": "true",
                "Solution/Increments": 8, "Output/Profile": "true",
                "Probes/Probes": PROBES})
            check(f"glue turned by {angle:.3g}, {rule}", status == 0, said[-300:])
            of_slave = [row for row in rows("glue")
                        if row["surface"].startswith("slave")]
            found.append({**values(summary),
                          **{k: summary["contact"][k]
                             for k in ("max_pressure", "normal_force",
                                       "tangential_force")},
                          **{k: sum(row[k] for row in of_slave)
                             for k in ("pressure_MPa", "shear_MPa")}})
        worst = max(difference(found[0], of_turn) for of_turn in found[1:])
        check(f"  tractions as before: {worst:.1e}", worst < 1e-6)


def beyond_half_a_turn():
    mesh = Mesh()
    mesh.block("B", 10, 1, box(0, 0, 20, 0.5), {"left": "Root", "right": "Tip"})
    mesh.write("beyond")
    status, said, summary = run("beyond", {
        "Mesh/File": "beyond.msh", "Mesh/Points": "R: 0, 0; T: 20, 0",
        "Element/Degree": 2, "Solids/Young's modulus": "B: 1000",
        "Solids/Poisson's ratio": "B: 0.3",
        "Boundary conditions/Displacement x": "Root: 0",
        "Boundary conditions/Displacement y": "R: 0",
        "Boundary conditions/Rigid": "Tip: T",
        "Boundary conditions/Rotation z": "Tip: 5", "Solution/Increments": 10,
        "Probes/Probes": "phi: rotation z, Tip"})
    check("a rotation by 5 rad", status == 0, said[-300:])
    off = [abs(i["probes"]["phi"] - 5 * i["load_factor"])
           for i in summary["increments"]]
    check(f"  is that in all increments: {max(off):.1e}", max(off) < 1e-9)


def in_space():
    mesh = Volumes()
    mesh.block("B", (1, 1, 3), lambda r, s, t: (r, s, 4 * t))
    mesh.write("in_space")
    status, said, summary = run("in_space", {
        "Mesh/File": "in_space.msh", "Solids/Young's modulus": "B: 1000",
        "Solids/Poisson's ratio": "B: 0.3",
        "Boundary conditions/Rigid": "B_z0: B_000, B_z1: B_001",
        **{f"Boundary conditions/Displacement {d}": "B_z0: 0" for d in "xyz"},
        **{f"Boundary conditions/Rotation {d}": f"B_z0: {5 if d == 'z' else 0}"
           for d in "xyz"},
        "Solution/Increments": 10, "Probes/Probes":
            "low: rotation z, B_z0; high: rotation z, B_z1; "
            "twist: rotation z, B_z1, B_z0"})
    check("a bar turned by 5 rad at one end", status == 0, said[-300:])
    off = [abs(i["probes"][end] - 5 * i["load_factor"])
           for i in summary["increments"] for end in ("low", "high")]
    off += [abs(i["probes"]["twist"]) for i in summary["increments"]]
    check(f"  both ends are, in all increments: {max(off):.1e}", max(off) < 1e-7)


def moment_over_an_interference():
    mesh = Mesh()
    mesh.block("B", 4, 2, box(-1, 0, 1, 1), {"bottom": "Sole", "top": "Head"})
    mesh.write("moment")
    status, said, summary = run("moment", {
        "Mesh/File": "moment.msh", "Mesh/Points": "H: 0, 1",
        "Solids/Young's modulus": "B: 1000", "Solids/Poisson's ratio": "B: 0.3",
        "Boundary conditions/Rigid": "Head: H",
        "Boundary conditions/Displacement x": "Head: 0",
        "Boundary conditions/Displacement y": "Head: -0.02",
        "Boundary conditions/Rotation z": "Head: 0",
        "Contact/Slave": "Sole", "Contact/Obstacle": "half plane: 0, 0, 0, 1",
        "Contact/Obstacle centre": "0, 0", "Contact/Friction coefficient": 0.4,
        "Contact/Interference": "0.1*t", "Contact/Obstacle motion": "x: 0.2*t",
        "Solution/Increments": 4, "Probes/Probes":
            "R: reaction x, Head; N: reaction y, Head; M: reaction moment z, Head; "
            "y: displacement y, H; m: obstacle moment z, Contact"})
    check("friction over an interference", status == 0, said[-300:])
    found = values(summary)
    # About the centre of the obstacle, which the middle of the head is above.
    left = found["M"] - (1 + found["y"]) * found["R"] + found["m"]
    # The obstacle has moved by 0.2 with its centre.
    left -= 0.2 * found["N"]
    check(f"  moments on the body: {left:.1e} of {found['m']:.3g}",
          abs(left) < 1e-6 * abs(found["m"]))


for scene in (press_fit, on_an_obstacle, glue, beyond_half_a_turn, in_space,
              moment_over_an_interference):
    print(scene.__name__)
    scene()
sys.exit(len(failures) > 0)
