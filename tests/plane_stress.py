#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plane stress, and increments by a list of their ends.

Proves that

- a bar that is pulled stretches by sigma/E and narrows by nu sigma/E, whatever
  holds it from becoming thinner (in plane strain (1 - nu^2) and nu (1 + nu)),
  with no stress across the plane; its energy is sigma^2/(2 E) by volume;
- two blocks pressed on each other do the same, with the pressure that presses;
- a thick ring under inner pressure has Lame's radial displacement of plane
  stress;
- bodies that yield, large displacement, thermal strains and volumes are refused;
- results are those of the load factors that are listed, and a list that does
  not ascend to 1 is refused.

Usage: plane_stress.py CONTACT
"""

import math
import sys

from block_scenes import Mesh, box, check, failures, run

E, nu, sigma = 200000., 0.3, 100.


def close(what, value, exact, tolerance=1e-9):
    check(what, abs(value - exact) <= tolerance * abs(exact),
          f"{value:.10g} {exact:.10g}")


def values(summary):
    return {probe["name"]: probe["value"] for probe in summary["probes"]}


material = {"Solids/Young's modulus": f"Bar: {E}",
            "Solids/Poisson's ratio": f"Bar: {nu}",
            "Solids/Symmetry": "plane stress",
            "Solids/Kinematics": "small strain", "Element/Degree": 1}

mesh = Mesh()
mesh.block("Bar", 4, 2, box(0, 0, 10, 2),
           {"left": "Left", "right": "Right", "bottom": "Bottom",
            "corner": "O"})
mesh.add(0, "P", (15,))
mesh.write("bar")
pulled = {**material, "Mesh/File": "bar.msh",
          "Boundary conditions/Displacement x": "Left: 0",
          "Boundary conditions/Displacement y": "Bottom: 0",
          "Boundary conditions/Traction x": f"Right: {sigma}",
          "Probes/Probes": "u: displacement x, P; v: displacement y, P; "
                           "xx: stress xx, P; zz: stress zz, P; "
                           "W: strain energy, Bar",
          "Probes/Errors": "none"}
status, said, summary = run("bar", pulled)
check("a bar", status == 0, said)
found = values(summary)
close("  its stretch", found["u"], 10 * sigma / E)
close("  it narrows", found["v"], -2 * nu * sigma / E)
close("  the stress", found["xx"], sigma)
check("  none across", found["zz"] == 0, found["zz"])
close("  the energy", found["W"], 20 * sigma ** 2 / (2 * E))
status, said, summary = run("strain", {**pulled,
                                       "Solids/Symmetry": "plane strain"})
found = values(summary)
close("in plane strain its stretch", found["u"],
      10 * (1 - nu ** 2) * sigma / E)
close("  the stress across", found["zz"], nu * sigma)

# Pressed on each other, one of another material.
mesh = Mesh()
mesh.block("Low", 3, 2, box(0, 0, 10, 2),
           {"left": "Low_left", "bottom": "Base", "top": "Master"})
mesh.block("Bar", 5, 2, box(0, 2, 10, 6),
           {"left": "Left", "bottom": "Slave", "top": "Head", "corner": "O"})
mesh.write("pressed")
pressed = {**material, "Mesh/File": "pressed.msh",
           "Solids/Young's modulus": f"Bar: {E}, Low: {E / 3}",
           "Solids/Poisson's ratio": f"Bar: {nu}, Low: {nu / 3}",
           "Boundary conditions/Displacement x": "Left: 0, Low_left: 0",
           "Boundary conditions/Displacement y": "Base: 0",
           "Boundary conditions/Pressure": f"Head: {sigma}",
           "Contact/Slave": "Slave", "Contact/Master": "Master",
           "Contact/Discretization": "mortar",
           "Probes/Probes": "p: pressure, O; v: displacement y, O",
           "Probes/Errors": "none"}
status, said, summary = run("pressed", pressed)
check("two blocks", status == 0, said)
found = values(summary)
close("  their pressure", found["p"], sigma)
close("  the lower one's shortening", found["v"], -2 * sigma / (E / 3))

# Lame's ring of plane stress: u(a) = p a/E ((b^2 + a^2)/(b^2 - a^2) + nu).
a, b, p = 10., 20., 50.
mesh = Mesh()
mesh.block("Bar", 24, 16, lambda s, t: (
    (a + t * (b - a)) * math.cos(math.pi / 2 * s),
    (a + t * (b - a)) * math.sin(math.pi / 2 * s)),
    {"bottom": "Bore", "top": "Rim", "left": "X", "right": "Y", "corner": "O"})
mesh.write("ring")
status, said, summary = run("ring", {
    **material, "Mesh/File": "ring.msh", "Element/Degree": 2,
    "Mesh/Arcs": f"Bore: 0, 0, {a}; Rim: 0, 0, {b}",
    "Boundary conditions/Displacement y": "X: 0",
    "Boundary conditions/Displacement x": "Y: 0",
    "Boundary conditions/Pressure": f"Bore: {p}",
    "Probes/Probes": "u: displacement x, O", "Probes/Errors": "none"})
check("a ring", status == 0, said)
close("  its bore", values(summary)["u"],
      p * a / E * ((b * b + a * a) / (b * b - a * a) + nu), 1e-4)

for what, entries in (
        ("bodies that yield", {"Solids/Material": "Bar: elastic-plastic",
                               "Solids/Yield stress": "Bar: 300"}),
        ("large displacement", {"Solids/Kinematics": "large displacement"}),
        ("thermal strains", {"Solids/Thermal strain": "Bar: 0.001*t"})):
    status, said, _ = run("refused", {**pulled, **entries})
    check(f"{what}: refused", status == 2 and "Plane stress" in said, said)

status, said, summary = run("listed", {**pulled,
                                       "Solution/Increments": "0.01, 0.3, 1"})
check("increments by a list", status == 0 and
      [i["load_factor"] for i in summary["increments"]] == [0.01, 0.3, 1],
      said)
for increments in ("0.5, 0.3, 1", "0.1, 0.9", "0, 1", "1.5", "none"):
    status, said, _ = run("refused", {**pulled,
                                      "Solution/Increments": increments})
    check(f"  not '{increments}'", status == 2 and "Increments" in said, said)
sys.exit(bool(failures))
