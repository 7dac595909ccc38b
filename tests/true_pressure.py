#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pressure and extent of contact on the deformed surface.

Proves that a block of rubber pressed on an obstacle to 60 % of its height, in
plane strain, as a disk and as a cube, has

- a true pressure that is minus the Cauchy stress in it, as a probe and in the
  profile, where the pressure by undeformed area is that times the stretch;
- a deformed width, or area, that the block has grown to, on which the true
  pressure carries the force;
- no estimated error of the true pressure, which is said.

Usage: true_pressure.py CONTACT
"""

import math
import sys

from block_scenes import Mesh, box, check, failures, rows, run
from volume_scenes import Volumes

SIZE, DOWN = 10., 4.


def close(what, value, exact, tolerance=1e-8):
    check(what, abs(value - exact) <= tolerance * abs(exact),
          f"{value:.10g} {exact:.10g}")


def entries(mesh, sides, top, slave, obstacle, up, corner, more):
    held = {f"Boundary conditions/Displacement {axis}": f"{side}: 0"
            for axis, side in sides.items()}
    return {"Mesh/File": f"{mesh}.msh", "Solids/Young's modulus": "Block: 6",
            "Solids/Poisson's ratio": "Block: 0.45",
            "Solids/Material": "Block: neo-Hookean", **held,
            f"Boundary conditions/Displacement {up}": f"{top}: -{DOWN}",
            "Contact/Slave": slave, "Contact/Obstacle": obstacle,
            "Solution/Increments": 4, "Solution/Newton tolerance": 1e-11,
            "Output/Profile": "true",
            "Probes/Probes": f"p: pressure, {corner}; "
                             f"true: true pressure, {corner}; "
                             f"s: stress {up}{up}, {corner}; "
                             f"u: displacement x, {corner}; "
                             f"F: reaction {up}, {top}", **more}


def judge(name, scene, extent, undeformed, dimensions):
    status, said, summary = run(name, scene)
    check(f"{name} is solved", status == 0, said)
    if status != 0:
        return
    found = {probe["name"]: probe["value"] for probe in summary["probes"]}
    grown = (1 + found["u"] / SIZE) ** dimensions
    check("  it grows", grown > 1.2, f"{grown:.4f}")
    close("  the true pressure is that of the stress", found["true"],
          -found["s"])
    close("  the other one is by undeformed area", found["p"],
          found["true"] * grown)
    contact = summary["increments"][-1]["contact"]
    deformed = undeformed * (grown if extent == "area" else
                             1 + found["u"] / SIZE)
    close(f"  the {extent}", contact[extent], undeformed)
    close("  deformed", contact[f"deformed_{extent}"], deformed)
    area = math.pi * deformed ** 2 if name == "disk" else deformed
    close("  carries the force", found["true"] * area, abs(found["F"]))
    table = [row for row in rows(name) if row["surface"] == "slave"]
    worst = max(abs(row["true_pressure_MPa"] - row["extrapolated_pressure_MPa"])
                for row in table)
    check("  so has the profile", worst < 1e-8 * found["true"], f"{worst:.2g}")


plane = Mesh()
plane.block("Block", 3, 3, box(0, 0, SIZE, SIZE),
            {"bottom": "Sole", "top": "Head", "left": "Middle"})
plane.add(0, "P", (4,))
plane.write("block")
flat = entries("block", {"x": "Middle"}, "Head", "Sole",
               "half plane: 0, 0, 0, 1", "y", "P", {})
judge("block", flat, "width", SIZE, 1)
del flat["Boundary conditions/Displacement x"]
judge("disk", {**flat, "Solids/Symmetry": "axisymmetric"}, "width", SIZE, 2)

cube = Volumes()
cube.block("Block", (2, 2, 2), lambda r, s, t: (SIZE * r, SIZE * s, SIZE * t))
cube.write("cube")
judge("cube", entries("cube", {"x": "Block_x0", "y": "Block_y0"}, "Block_z1",
                      "Block_z0", "half space: 0, 0, 0, 0, 0, 1", "z",
                      "Block_110", {"Element/Degree": 1}), "area",
      SIZE * SIZE, 2)

flat["Boundary conditions/Displacement x"] = "Middle: 0"
del flat["Solids/Material"]
status, said, summary = run("asked", {
    **flat, "Probes/Errors": "dual weighted residuals"})
check("no dual problem of the true pressure", status == 2 and
      "true pressure" in said, said)

sys.exit(bool(failures))
