#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run says of its scene beside the values.

Proves that a body that friction alone holds is named, and with the fixed point
over Tresca's friction as well, and one that a support or glue holds is not; that units
that do not fit together are a remark, with a result and without one, and a violated
invariant where edges in small strain change by half of their length; that where
two attempts end on their way the results of the first one are kept, and the
summary tells of both; that --restart of a run that has converged is an error that
leaves its results; that bodies which bend are too stiff, yielding or not, and that
polygons stand for curves, is said; that the remedy for a rigid boundary that meets
the slave depends on how much of it they share.

Usage: remarks.py CONTACT
"""

import json
import pathlib
import subprocess
import sys

from block_scenes import Mesh, box, check, contact, failures, ring, run, solve

mesh = Mesh()
mesh.block("Foundation", 12, 4, box(-3, -2, 3, 0),
           {"bottom": "Base", "top": "Ground"})
mesh.block("Block", 5, 3, box(-1, 0, 1, 1),
           {"bottom": "Sole", "top": "Head", "left": "Side"})
mesh.write("remarks")

PRESSURE, FRICTION = 10, 0.3  # 2 mm of the sole: 6 N/mm hold it
scene = {
    "Mesh/File": "remarks.msh",
    "Solids/Young's modulus": "Foundation: 70000, Block: 210000",
    "Solids/Poisson's ratio": "Foundation: 0.3, Block: 0.3",
    "Solids/Kinematics": "small strain",
    "Boundary conditions/Displacement x": "Base: 0",
    "Boundary conditions/Displacement y": "Base: 0",
    "Boundary conditions/Pressure": f"Head: {PRESSURE}",
    "Boundary conditions/Traction x": "Head: 1",
    "Boundary conditions/Histories": "Pressure: min(1, 4*t); Traction x: t",
    "Contact/Slave": "Sole", "Contact/Master": "Ground",
    "Contact/Friction coefficient": str(FRICTION),
    "Solution/Increments": "4",
    "Probes/Probes": "f: contact force x, Sole"}


def texts(summary):
    return [f["text"] for f in summary.get("findings", [])]


HELD = "friction alone holds the body 'Block' against: displacement in x"
for loop in "Newton", "fixed point":
    status, said, summary = run("held", {**scene, "Solution/Friction": loop})
    check(f"friction alone holds it, by {loop}",
          status == 0 and texts(summary) == [HELD], said)
case = pathlib.Path("held.prm")
status, said, summary = solve(
    case, "Boundary conditions/Displacement x=Base: 0, Side: 0")
check("a support holds it", status == 0 and texts(summary) == [], said)
status, said, summary = solve(case, "Contact/Tied=true",
                              "Contact/Friction coefficient=0",
                              "Solution/Estimate effects=true")
check("glue holds it, and its effects have an estimate",
      status == 0 and texts(summary) == [] and
      len(summary.get("estimated_effects", [])) > 0, (said, list(summary)))

before = pathlib.Path("output/held/summary.json").read_text()
again = subprocess.run([contact, case, "--restart"], capture_output=True, text=True)
check("nothing to go on from", again.returncode == 2 and
      "has converged: it has nothing to go on from" in again.stderr and
      before == pathlib.Path("output/held/summary.json").read_text(), again.stderr)

# Moduli in GPa.
UNITS = "check the units: moduli in MPa, lengths in mm, loads in N"
status, said, summary = solve(
    case, "Solids/Young's modulus=Foundation: 70, Block: 210")
check("units of a result", status == 0 and any(UNITS in t for t in texts(summary)),
      said)
status, said, _ = solve(
    case, "Solids/Young's modulus=Foundation: 30, Block: 15",
    "Boundary conditions/Traction x=")
check("edges that change by half of their length", status == 1 and
      "violated: small strain: edges of cells" in said, said)
status, said, summary = solve(
    case, "Solids/Young's modulus=Foundation: 0.7, Block: 0.21",
    "Solution/Max cut-backs=0", "Solution/Increments=1")
check("units where there is none", status == 3 and UNITS in summary["message"], said)

# The block is dragged off at a traction of mu times the pressure.
status, said, summary = solve(case, "Boundary conditions/Traction x=Head: 6",
                              "Output/Profile=true")
kept = pathlib.Path("output/held/first_attempt")
first = json.loads((kept / "summary.json").read_text()) if kept.is_dir() else {}
reached = max([i["load_factor"] for i in first.get("increments", [])
               if i["converged"]], default=0)
check("two attempts", status == 3 and 0.25 <= reached <= 0.5 and
      (kept / "history.csv").exists() and
      any("not solved by the loops and the system that the case asks for" in t and
          "are in first_attempt" in t for t in texts(summary)), (said, reached))
status, said, summary = solve(case)
check("a run that converges leaves no first attempt",
      status == 0 and not kept.exists(), said)

# A beam of one cell across, elastic and yielding, beside one that nothing bends.
beam = Mesh()
beam.block("Beam", 10, 1, box(0, 0, 20, 1), {"left": "Held", "right": "End"})
beam.block("Other", 10, 1, box(0, 5, 20, 6), {"left": "Kept"})
beam.write("beam")
bent = {"Mesh/File": "beam.msh", "Element/Degree": 1,
        "Solids/Young's modulus": "Beam: 1000, Other: 1000",
        "Solids/Poisson's ratio": "Beam: 0.3, Other: 0.3",
        "Solids/Kinematics": "small strain",
        "Boundary conditions/Displacement x": "Held: 0, Kept: 0",
        "Boundary conditions/Displacement y": "Held: 0, End: -1, Kept: 0"}
for what, more, remedy in (
        ("an elastic beam", {}, "or 'Incompatible modes = Beam'"),
        ("one that yields", {"Solids/Yield stress": "Beam: 5",
                             "Solids/Material": "Beam: elastic-plastic"},
         "Set 'Degree = 2'")):
    status, said, summary = run("beam", {**bent, **more})
    found = [t for t in texts(summary) if "too stiff in bending" in t]
    check(f"{what} is too stiff, and the other is not", status == 0 and
          len(found) == 1 and "'Beam'" in found[0] and found[0].endswith(remedy),
          (said, found))

# A polygon of 24 sides in one of 20, with and without a name of the circle.
polygons = Mesh()
polygons.block("Hub", 20, 2, ring(10, 20), {"bottom": "Bore", "top": "Rim"}, closed=True)
polygons.block("Shaft", 24, 2, ring(4, 10), {"bottom": "Core", "top": "Seat"}, closed=True)
polygons.write("polygons")
for what, more in (("", {}), (", named", {"Mesh/Arcs": "Bore: 0, 0, 10; Seat: 0, 0, 10"})):
    status, said, summary = run("polygons", {
        "Mesh/File": "polygons.msh", "Element/Degree": 1,
        "Solids/Young's modulus": "Hub: 1000, Shaft: 1000",
        "Solids/Poisson's ratio": "Hub: 0.3, Shaft: 0.3",
        "Boundary conditions/Displacement x": "Rim: 0, Core: 0",
        "Boundary conditions/Displacement y": "Rim: 0, Core: -0.1",
        "Contact/Slave": "Bore", "Contact/Master": "Seat", **more})
    check(f"polygons that stand for a circle{what}", status in (0, 1) and any(
        "mm off their circles where they touch" in t for t in texts(summary)), said)

for boundary, remedy in (("Side", "let the slave end before the rigid boundary"),
                         ("Sole", "take the rigid surface as master")):
    status, said, _ = solve(case, "Mesh/Points=P: -0.2, 1",
                            f"Boundary conditions/Rigid={boundary}: P")
    check(f"the remedy where {boundary} is rigid",
          status == 2 and remedy in said, said)
sys.exit(len(failures) > 0)
