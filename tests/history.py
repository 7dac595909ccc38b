#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""history.csv: the increments of a run as a table.

Proves that a column under a plane with a force of 120 t, in plane strain, as a ring
and in 3-D, has in its table

- a row for each increment at its load factor, and an earlier run's rows no more;
- the force of contact, the reaction and the obstacle's force 120 t, and the
  pressure this by the area, to 1e-9, under names with the right units;
- the moment of a rigid foot about its corner 120 t times half of the width, by
  symmetry, to 1e-6, in the unit of a moment;
- the same probes as summary.json, to the last bit, with the same units; this
  names case, mesh, program and date.

And of a block that is dragged along its support, probes in the order of the file in
all results; the force of the support alone is minus that of the obstacle, to 1e-9,
where the reaction has friction of the nodes that it holds as well.

Usage: history.py CONTACT PARAMETERS MESHES
"""

import csv
import json
import math
import pathlib
import re
import sys

from block_scenes import Mesh, box, check, failures, run
from volume_scenes import Volumes

WIDTH, HEIGHT, DEPTH, FORCE = 4., 2., 1.5, 120.
MATERIAL = {"Solids/Young's modulus": "A: 1000",
            "Solids/Poisson's ratio": "A: 0.3",
            "Solids/Kinematics": "small strain"}
PLANE = f"half plane: 0, {HEIGHT}, 0, -1"


def table(name):
    with open(f"output/{name}/history.csv", encoding="utf-8") as lines:
        return list(csv.DictReader(lines))


def near(what, found, wanted):
    check(what, abs(found - wanted) < 1e-9 * abs(wanted), f"{found} {wanted}")


def column(name, more, area, unit, increments):
    what = f"{name}, {increments} increments"
    status, said, _ = run(name, {
        "Mesh/File": f"{name}.msh", **MATERIAL,
        "Contact/Obstacle force": f"y: {-FORCE}*t",
        "Probes/Probes": "way, down: obstacle motion y, Contact; "
                         "all: obstacle force y, Contact",
        "Solution/Increments": increments, **more})
    check(f"{what}: converges", status == 0, said[-300:])
    rows = table(name)
    check("  a row an increment", len(rows) == increments, len(rows))
    summary = json.loads(pathlib.Path(f"output/{name}/summary.json").read_text())
    for probe in summary["probes"]:
        check(f"  the unit of {probe['name']}",
              f"{probe['name']} [{probe['unit']}]" in rows[0], probe["unit"])
    check("  case, mesh, program, date",
          summary["case"] == name and summary["mesh"] == f"{name}.msh" and
          summary["program"].startswith("contact ") and
          re.fullmatch(r"\d+/\d+/\d+", summary["date"]) is not None,
          str({key: summary[key] for key in ("case", "mesh", "program", "date")}))
    group = more["Boundary conditions/Displacement y"].split(":")[0]
    for k, row in enumerate(rows):
        t = (k + 1) / increments
        near("  load factor", float(row["t [-]"]), t)
        for force, sign in ((f"contact normal_force [{unit}]", 1),
                            (f"reaction {group} y [{unit}]", 1),
                            (f"all [{unit}]", -1)):
            near(f"  {force}", float(row[force]), sign * FORCE * t)
        near("  pressure", float(row["contact max_pressure [MPa]"]),
             FORCE * t / area)
        probes = summary["increments"][k]["probes"]
        check("  the probes of summary.json",
              float(row["way, down [mm]"]) == probes["way, down"] and
              float(row[f"all [{unit}]"]) == probes["all"], row)


plane = Mesh()
plane.block("A", 8, 4, box(0, 0, WIDTH, HEIGHT),
            {"bottom": "Bottom", "top": "Top", "left": "Left", "corner": "C"})
plane.write("plane")
plane.write("ring")
space = Volumes()
space.block("A", (4, 2, 2), lambda r, s, t: (WIDTH * r, HEIGHT * s, DEPTH * t))
space.write("space")
SUPPORTS = {"Boundary conditions/Displacement y": "Bottom: 0",
            "Contact/Slave": "Top", "Contact/Obstacle": PLANE}
for n in (3, 2):
    column("plane", {**SUPPORTS, "Boundary conditions/Displacement x": "C: 0"},
           WIDTH, "N/mm", n)
column("ring", {**SUPPORTS, "Solids/Symmetry": "axisymmetric"},
       math.pi * WIDTH**2, "N", 2)
column("space", {
    "Boundary conditions/Displacement x": "A_x0: 0",
    "Boundary conditions/Displacement y": "A_y0: 0",
    "Boundary conditions/Displacement z": "A_z0: 0", "Contact/Slave": "A_y1",
    "Contact/Obstacle": f"half space: 0, {HEIGHT}, 0, 0, -1, 0"},
       WIDTH * DEPTH, "N", 2)
status, said, _ = run("foot", {
    "Mesh/File": "plane.msh", **MATERIAL,
    "Boundary conditions/Displacement x": "Bottom: 0",
    "Boundary conditions/Displacement y": "Bottom: 0",
    "Boundary conditions/Rotation z": "Bottom: 0",
    "Boundary conditions/Rigid": "Bottom: C",
    "Contact/Slave": "Top", "Contact/Obstacle": PLANE,
    "Contact/Obstacle force": f"y: {-FORCE}*t", "Solution/Increments": 2})
check("rigid foot: converges", status == 0, said[-300:])
for k, row in enumerate(table("foot")):
    moment = float(row["reaction Bottom moment z [N mm/mm]"])
    wanted = FORCE * (k + 1) / 2 * WIDTH / 2
    check("  its moment", abs(moment - wanted) < 1e-6 * wanted, moment)

status, said, summary = run("dragged", {
    "Mesh/File": "plane.msh", **MATERIAL,
    "Boundary conditions/Displacement x": "Left: 0",
    "Boundary conditions/Displacement y": "Bottom: 0",
    "Contact/Slave": "Top", "Contact/Obstacle": PLANE,
    "Contact/Friction coefficient": 0.3,
    "Contact/Obstacle motion": "y: -0.02*min(1, 2*t); x: 0.04*max(0, 2*t - 1)",
    "Probes/Probes": "support: support x, Left; all: reaction x, Left; "
                     "drag: obstacle force x, Contact",
    "Solution/Increments": 4})
check("dragged: converges", status == 0, said[-300:])
names, last = ["support", "all", "drag"], summary["increments"][-1]
check("  probes in the order of the file", all(list(found) == names for found in (
    [p["name"] for p in summary["probes"]], last["probes"],
    summary["levels"][-1]["probes"],
    [c.split(" [")[0] for c in table("dragged")[0]][2:5])) and
    re.findall(r"^dragged .*?\| (\w+) \[", said, re.M) == names, said)
probes = last["probes"]
near("  the support holds the drag", probes["support"], -probes["drag"])
near("  reactions of summary.json", probes["support"],
     last["reactions"]["Left"]["x"])
check("  the reaction is another force",
      abs(probes["all"] / probes["support"] - 1) > 0.01, str(probes))
print(len(failures), "failures")
sys.exit(bool(failures))
