#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact in space.

Proves that

- a uniform pressure passes between two blocks whose meshes do not match and are
  skewed, with either side as slave, with elements of 8, 20 and 27 nodes (patch test
  of the mortar discretization), also on two processes;
- SSNP154 as one layer of cells without displacement across it has the values of
  the plane program, with the nodal discretization, without and with friction;
- a paraboloid pressed on a half space has the pressure and the area of contact
  that Hertz' theory gives for the force on it, and the pressure falls
  monotonically from the middle;
- a block dragged over a plane is held by the friction coefficient times the
  normal force, against its way, in whatever direction that is;
- forces and moments of contact balance, and no invariant is violated;
- what is there in the plane alone is refused.

Usage: space.py CONTACT PARAMETERS MESHES
"""

import math
import pathlib
import sys

from block_scenes import check, failures, rows, run, solve
from volume_scenes import Volumes, layer

parameters = pathlib.Path(sys.argv[2]).resolve()
meshes = pathlib.Path(sys.argv[3]).resolve()


def probes(summary):
    return {p["name"]: p["value"] for p in summary["probes"]}


def converged(what, status, summary, said):
    violations = [v for i in summary.get("increments", [])
                  for v in i.get("violations", [])]
    check(f"{what}: converges, and no invariant is violated",
          status == 0 and not violations, said if status else violations)


def skewed(lo, hi, skew):
    """A block whose inner nodes are moved around its axis."""
    def chart(r, s, t):
        bubble = 16 * r * (1 - r) * s * (1 - s)
        x = (r + skew * bubble * (s - 0.3), s - skew * bubble * (r - 0.6), t)
        return tuple(a + (b - a) * c for a, b, c in zip(lo, hi, x))
    return chart


def patch_test():
    mesh = Volumes()
    mesh.block("Low", (3, 3, 2), skewed((0, 0, 0), (1, 1, 1), 0.3))
    mesh.block("Up", (4, 5, 2), skewed((0, 0, 1), (1, 1, 2), -0.4))
    mesh.write("patch")
    for nodes, slave, ranks in ((8, "Up_z0", 1), (8, "Low_z1", 2),
                                (20, "Up_z0", 1), (20, "Low_z1", 2),
                                (27, "Up_z0", 1), (27, "Low_z1", 1)):
        entries = {
            "Mesh/File": "patch.msh",
            "Element/Degree": 1 if nodes == 8 else 2,
            "Solids/Young's modulus": "Low: 1000, Up: 3000",
            "Solids/Poisson's ratio": "Low: 0.3, Up: 0.1",
            "Solids/Kinematics": "small strain",
            "Boundary conditions/Displacement x": "Low_x0: 0, Up_x0: 0",
            "Boundary conditions/Displacement y": "Low_y0: 0, Up_y0: 0",
            "Boundary conditions/Displacement z": "Low_z0: 0",
            "Boundary conditions/Pressure": "Up_z1: 10",
            "Contact/Slave": slave,
            "Contact/Master": "Low_z1" if slave == "Up_z0" else "Up_z0",
            "Solution/Geometry": "undeformed", "Solution/Increments": 1,
            "Solution/Newton tolerance": 1e-12, "Output/Profile": "true",
            "Probes/Probes": "low: stress zz, Low_000; "
                             "at: stress zz, Low_111; up: stress zz, Up_000; "
                             "u: displacement z, Up_111"}
        if nodes == 27:
            entries["Element/Centre node"] = "free"
        status, said, summary = run("patch", entries, ranks)
        what = f"patch test, {nodes} nodes, slave {slave}, {ranks} processes"
        converged(what, status, summary, said)
        values = probes(summary)
        exact = {"low": -10, "at": -10, "up": -10, "u": -10 / 1000 - 10 / 3000}
        worst = max(abs(values[n] / exact[n] - 1) for n in exact)
        check(f"{what}: stresses and displacement", worst < 1e-10, worst)
        pressures = [row["pressure_MPa"] for row in rows("patch")]
        worst = max(abs(p / 10 - 1) for p in pressures)
        check(f"{what}: pressures at all nodes", worst < 1e-9, worst)
        balance = summary["increments"][-1]["invariants"]
        check(f"{what}: forces and moments balance",
              max(balance["force_imbalance"],
                  balance["moment_imbalance"]) < 1e-12, balance)


def extruded():
    depth = 5.
    layer(meshes / "ssnp154_quads.msh", depth).write("layer")
    plane = [f"Mesh/File={meshes / 'ssnp154_quads.msh'}",
             "Contact/Discretization=nodal", "Solution/Newton tolerance=1e-11"]
    force = -17500 * depth / 2
    entries = {
        "Mesh/File": "layer.msh",
        "Mesh/Cylinders": "Bottom_C: 0, 50, 0, 0, 0, 1, 50",
        "Element/Degree": 1,
        "Solids/Young's modulus": "Block: 70000, Cylinder: 210000",
        "Solids/Poisson's ratio": "Block: 0.3, Cylinder: 0.3",
        "Solids/Kinematics": "large displacement",
        "Boundary conditions/Displacement x": "Axe: 0, Encast: 0",
        "Boundary conditions/Displacement y": "Encast: 0",
        "Boundary conditions/Displacement z": "Front: 0, Back: 0",
        "Boundary conditions/Force y": f"Force_0: {force}, Force_1: {force}",
        "Contact/Slave": "Bottom_C", "Contact/Master": "Top_B",
        "Contact/Discretization": "nodal",
        "Solution/Increments": 2, "Solution/Geometry": "fixed point",
        "Solution/Geometry tolerance": 0.01, "Solution/Friction": "fixed point",
        "Solution/Newton tolerance": 1e-11,
        "Probes/Probes": "DY(B): displacement y, B_0; SIYY(B): stress yy, B_0"}
    for coefficient in (0, 0.1):
        entries["Contact/Friction coefficient"] = coefficient
        status, said, summary = run("layer", entries)
        what = f"SSNP154 as a layer, friction {coefficient}"
        converged(what, status, summary, said)
        _, _, of_plane = solve(parameters / "ssnp154.prm", *plane,
                               f"Contact/Friction coefficient={coefficient}")
        ours, theirs = probes(summary), probes(of_plane)
        worst = max(abs(ours[n] / theirs[n] - 1) for n in theirs)
        check(f"{what}: the plane values", worst < 1e-8, worst)


def hertz():
    """A quarter of a paraboloid z = (x^2 + y^2)/(2 R), elements as large as a/8
    in the contact and growing away from it."""
    radius, size, modulus, ratio = 50., 8., 1000., 0.3

    def grow(s):
        return size * (0.3 * s + 0.7 * s**3)

    def chart(r, s, t):
        x, y = grow(r), grow(s)
        height = (x * x + y * y) / (2 * radius)
        return x, y, height + (size - height) * (0.15 * t + 0.85 * t**3)
    mesh = Volumes()
    mesh.block("Body", (18, 18, 10), chart)
    mesh.write("paraboloid")
    status, said, summary = run("hertz", {
        "Mesh/File": "paraboloid.msh", "Element/Degree": 1,
        "Solids/Young's modulus": f"Body: {modulus}",
        "Solids/Poisson's ratio": f"Body: {ratio}",
        "Solids/Kinematics": "small strain",
        "Boundary conditions/Displacement x": "Body_x0: 0",
        "Boundary conditions/Displacement y": "Body_y0: 0",
        "Boundary conditions/Displacement z": "Body_z1: -0.02",
        "Contact/Slave": "Body_z0",
        "Contact/Obstacle": "half space: 0, 0, 0, 0, 0, 1",
        "Solution/Increments": 1, "Output/Profile": "true"})
    converged("Hertz", status, summary, said)
    force = 4 * summary["contact"][""]["normal_force"] \
        if "" in summary["contact"] else 4 * summary["contact"]["normal_force"]
    effective = modulus / (1 - ratio**2)
    a = (3 * force * radius / (4 * effective))**(1 / 3)
    p0 = 3 * force / (2 * math.pi * a * a)
    profile = [(math.hypot(row["X_mm"], row["Y_mm"]), row["pressure_MPa"])
               for row in rows("hertz")]
    middle = max(p for _, p in profile)
    check("Hertz: largest pressure", abs(middle / p0 - 1) < 0.02, middle / p0)
    inside = [abs(p / p0 - math.sqrt(max(0, 1 - (r / a)**2)))
              for r, p in profile if r < 0.8 * a]
    check("Hertz: pressure over the footprint",
          len(inside) > 10 and max(inside) < 0.03,
          (len(inside), max(inside), a))
    axis = sorted((row["X_mm"], row["pressure_MPa"]) for row in rows("hertz")
                  if row["Y_mm"] == 0)
    rise = max(b[1] - a[1] for a, b in zip(axis, axis[1:]))
    check("Hertz: the pressure falls from the middle", rise < 0.01 * p0,
          rise / p0)


def friction():
    mesh = Volumes()
    mesh.block("Block", (4, 4, 4), lambda r, s, t: (r, s, t))
    mesh.write("block")
    for degrees in (0, 30, 75, 200):
        angle = math.radians(degrees)
        way = 0.5 * math.cos(angle), 0.5 * math.sin(angle)
        entries = {
            "Mesh/File": "block.msh", "Element/Degree": 1,
            "Solids/Young's modulus": "Block: 1000",
            "Solids/Poisson's ratio": "Block: 0",
            "Solids/Kinematics": "small strain",
            "Boundary conditions/Displacement x": f"Block_z1: {way[0]!r}",
            "Boundary conditions/Displacement y": f"Block_z1: {way[1]!r}",
            "Boundary conditions/Displacement z": "Block_z1: -0.01",
            "Contact/Slave": "Block_z0",
            "Contact/Obstacle": "half space: 0, 0, 0, 0, 0, 1",
            "Contact/Friction coefficient": 0.3,
            "Probes/Probes": "x: reaction x, Block_z1; "
                             "y: reaction y, Block_z1; z: reaction z, Block_z1"}
        status, said, summary = run("drag", entries)
        what = f"block dragged at {degrees} degrees"
        converged(what, status, summary, said)
        values = probes(summary)
        force = -0.3 * values["z"]
        worst = max(abs(values["x"] - force * math.cos(angle)),
                    abs(values["y"] - force * math.sin(angle))) / force
        # The sheared block is not symmetric to its way: nodes slip in
        # directions that differ by a little, and so do their shears.
        check(f"{what}: friction against the way", worst < 1e-4, worst)


def refusals():
    mesh = Volumes()
    mesh.block("Block", (1, 1, 1), lambda r, s, t: (r, s, t))
    mesh.write("cube")
    base = {"Mesh/File": "cube.msh",
            "Solids/Young's modulus": "Block: 1000",
            "Solids/Poisson's ratio": "Block: 0.3",
            "Boundary conditions/Displacement z": "Block_z1: -0.01",
            "Boundary conditions/Displacement x": "Block_x0: 0",
            "Boundary conditions/Displacement y": "Block_y0: 0",
            "Contact/Slave": "Block_z0",
            "Contact/Obstacle": "half space: 0, 0, 0, 0, 0, 1"}
    for entry, value in (("Solids/Symmetry", "axisymmetric"),
                         ("Solution/System", "saddle point"),
                         ("Solution/Geometry", "Newton"),
                         ("Contact/Obstacle", "circle: 0, 0, 1"),
                         ("Probes/Dual weighted residuals", "true"),
                         ("Refinement/Strategy", "adaptive")):
        entries = {**base, entry: value}
        if entry.startswith("Refinement"):
            entries["Refinement/Levels"] = 1
        if entry.startswith("Probes"):
            entries["Probes/Probes"] = "u: displacement z, Block_111"
        status, said, _ = run("refused", entries)
        check(f"{entry} = {value} is refused", status == 2, (status, said))


patch_test()
extruded()
hertz()
friction()
refusals()
sys.exit(bool(failures))
