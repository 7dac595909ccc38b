#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact in 3-D.

Proves that

- one layer of cells without displacement across it has the values of the plane
  program, with elements of 8, 20 and 27 nodes, with and without friction: to
  1e-8 SSNP154 with the nodal discretization and a flat punch with the mortar
  discretization as well. (On round surfaces the two mortar discretizations are
  not one: they project in directions that differ, in 2-D along a normal
  that turns along an edge, in 3-D along that of the middle of a facet.)
- a paraboloid pressed on a half space has the pressure and the area of contact
  that Hertz' theory gives for the force on it, and the pressure falls
  monotonically from the middle;
- a block dragged over a plane is held by the friction coefficient times the
  normal force, against its way, in whatever direction that is;
- flat blocks of rubber on each other, without friction, are stretched uniformly as
  the closed form has it, at 30 %, with few Newton steps;
- a clamped column below a flat plate, without friction, is refused where it is
  compressed by half as much again as by Euler's load, and not by 0.9 of it;
- forces and moments of contact balance, and no invariant is violated;
- what is there in 2-D alone is refused.

Usage: space.py CONTACT PARAMETERS MESHES
"""

import math
import pathlib
import sys

from block_scenes import Mesh, box, check, failures, rows, run
from space_scenes import converged, probes
from volume_scenes import Volumes, layer

meshes = pathlib.Path(sys.argv[3]).resolve()


def extruded():
    """SSNP154: the nodal force of the benchmark at degree 1; at degree 2 it is
    spread over the cap, since points of a mesh file are no mid-side nodes. Both
    have their pairing to round-off, in 2-D by Newton's method, in 3-D by
    the fixed point: renewed before each step ('each step') it was left with up
    to 2e-8 of the stress, however small the tolerance."""
    depth, force = 5., -17500
    layer(meshes / "ssnp154_quads.msh", depth).write("layer")
    both = {
        "Solids/Young's modulus": "Block: 70000, Cylinder: 210000",
        "Solids/Poisson's ratio": "Block: 0.3, Cylinder: 0.3",
        "Solids/Kinematics": "large displacement",
        "Boundary conditions/Displacement x": "Axe: 0, Encast: 0",
        "Boundary conditions/Displacement y": "Encast: 0",
        "Contact/Slave": "Bottom_C", "Contact/Master": "Top_B",
        "Solution/Increments": 2, "Solution/Geometry": "fixed point",
        "Solution/Geometry tolerance": 1e-11,
        "Solution/Newton tolerance": 1e-12}
    plane = {"Mesh/File": meshes / "ssnp154_quads.msh",
             "Mesh/Arcs": "Bottom_C: 0, 50, 50",
             "Solution/System": "saddle point", "Solution/Geometry": "Newton",
             "Probes/Probes": "DY: displacement y, B; SIYY: stress yy, B"}
    space = {"Mesh/File": "layer.msh",
             "Mesh/Cylinders": "Bottom_C: 0, 50, 0, 0, 0, 1, 50",
             "Boundary conditions/Displacement z": "Front: 0, Back: 0",
             "Probes/Probes": "DY: displacement y, B_0; SIYY: stress yy, B_0"}
    half = force * depth / 2
    for nodes, friction in ((8, 0), (8, 0.1), (20, 0), (20, 0.1), (27, 0.1)):
        law = {**both, **element(nodes), "Contact/Discretization": "nodal",
               "Contact/Friction coefficient": friction}
        if nodes == 8:
            loads = ({"Boundary conditions/Force y": f"Force: {force}"},
                     {"Boundary conditions/Force y":
                      f"Force_0: {half}, Force_1: {half}"})
        else:
            loads = tuple({"Boundary conditions/Resultant force y":
                           f"Cap: {total}"} for total in (force, force * depth))
        compare_with_plane(
            f"SSNP154 as a layer, {nodes} nodes, friction {friction}",
            {**law, **plane, **loads[0]}, {**law, **space, **loads[1]})


def element(nodes):
    """As the entries have it, in 2-D the element of 4, 8 or 9 nodes."""
    return {"Element/Degree": 1 if nodes == 8 else 2,
            "Element/Centre node": "free" if nodes == 27 else "serendipity"}


def compare_with_plane(what, plane, space):
    tolerance = 1e-8
    ends = [run("of_plane", plane), run("of_layer", space)]
    for (status, said, summary), where in zip(ends, ("plane", "space")):
        converged(f"{what}, in the {where}" if where == "plane" else
                  f"{what}, in {where}", status, summary, said)
    theirs, ours = (probes(summary) for _, _, summary in ends)
    worst = max(abs(ours[n] / theirs[n] - 1) for n in theirs)
    check(f"{what}: the plane values to {tolerance:.0e}",
          bool(theirs) and worst < tolerance, worst)


def flat_layer():
    """A flat punch dragged over a block, as a layer: between flat surfaces the
    mortar discretization of the plane and that of space are one, too."""
    mesh = Mesh()
    mesh.block("Low", 9, 3, box(-3, -2, 3, 0), {"bottom": "Base", "top": "Top"})
    mesh.block("Up", 4, 2, box(-1.3, 0, 1.2, 1.2),
               {"bottom": "Sole", "top": "Head", "corner": "P"})
    mesh.write("flat")
    layer("flat.msh", 1.5).write("flat_layer")
    both = {
        "Solids/Young's modulus": "Low: 1000, Up: 2000",
        "Solids/Poisson's ratio": "Low: 0.3, Up: 0.25",
        "Solids/Kinematics": "small strain",
        "Boundary conditions/Displacement x": "Base: 0, Head: 0.04",
        "Boundary conditions/Displacement y": "Base: 0, Head: -0.05",
        "Contact/Slave": "Sole", "Contact/Master": "Top",
        "Contact/Friction coefficient": 0.2,
        "Solution/Geometry": "undeformed", "Solution/Newton tolerance": 1e-12}
    quantities = ("x: displacement x, {0}; y: displacement y, {0}; "
                  "s: stress yy, {0}")
    plane = {"Mesh/File": "flat.msh", "Solution/System": "condensed",
             "Probes/Probes": quantities.format("P")}
    space = {"Mesh/File": "flat_layer.msh",
             "Boundary conditions/Displacement z": "Front: 0, Back: 0",
             "Probes/Probes": quantities.format("P_0")}
    for nodes, rule in ((8, "mortar"), (20, "mortar"), (27, "mortar"),
                        (20, "nodal")):
        law = {**both, **element(nodes), "Contact/Discretization": rule}
        compare_with_plane(f"flat punch as a layer, {nodes} nodes, {rule}",
                           {**law, **plane}, {**law, **space})


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


def squeezed_rubber():
    """W = mu/2 (J^(-2/3) I_1 - 3) + K/4 (J^2 - 1 - 2 ln J), free to the sides. The
    tangent of the middle block is indefinite without the change of its pairing."""
    modulus, ratio, stretch = 1000., 0.3, 0.7
    mu, bulk = modulus / 2 / (1 + ratio), modulus / 3 / (1 - 2 * ratio)

    def stress(a, along):
        j, trace = a * a * stretch, 2 * a * a + stretch**2
        return (mu * j**(-5 / 3) * (along**2 - trace / 3) +
                bulk / 2 * (j - 1 / j))
    low, high = 1., 1.5
    while high - low > 1e-15:
        a = (low + high) / 2
        low, high = (a, high) if stress(a, a) < 0 else (low, a)
    force = -4 * low**2 * stress(low, stretch)

    mesh = Volumes()
    for name, n, z in (("A", 3, 0), ("B", 4, 1), ("C", 5, 2)):
        mesh.block(name, (n, n, n // 2), lambda r, s, t, z=z: (2 * r, 2 * s, z + t))
    mesh.write("rubber")
    status, said, summary = run("rubber", {
        "Mesh/File": "rubber.msh",
        "Solids/Young's modulus": f"A: {modulus}, B: {modulus}, C: {modulus}",
        "Solids/Poisson's ratio": f"A: {ratio}, B: {ratio}, C: {ratio}",
        "Solids/Kinematics": "large displacement",
        "Solids/Material": "A: neo-Hookean, B: neo-Hookean, C: neo-Hookean",
        "Boundary conditions/Displacement x": "A_x0: 0, B_x0: 0, C_x0: 0",
        "Boundary conditions/Displacement y": "A_y0: 0, B_y0: 0, C_y0: 0",
        "Boundary conditions/Displacement z": f"A_z0: 0, C_z1: {3 * stretch - 3}",
        "Contact/Slave": "B_z0", "Contact/Master": "A_z1",
        "Contact two/Slave": "B_z1", "Contact two/Master": "C_z0",
        "Probes/Probes": "F: reaction z, C_z1"})
    converged("squeezed rubber", status, summary, said)
    error = abs(probes(summary)["F"] / -force - 1) if status == 0 else 1
    check("squeezed rubber: the force", error < 1e-8, error)
    steps = sum(i["newton_iterations"] for i in summary.get("increments", []))
    check("squeezed rubber: few Newton steps", steps < 40, steps)


def column():
    """1 x 1 x 12 mm, free to sway: pi^2 E I / h^2 is a strain of pi^2 / 12 / h^2."""
    mesh = Volumes()
    mesh.block("A", (2, 1, 12), lambda r, s, t: (r, s, 12 * t))
    mesh.block("P", (3, 1, 1), lambda r, s, t: (4 * r - 1.5, s, 12 + t))
    mesh.write("column")
    euler = math.pi**2 / 12 / 12**2 * 12
    for part, is_stable in ((0.9, True), (1.5, False)):
        status, said, _ = run("column", {
            "Mesh/File": "column.msh", "Element/Degree": 2,
            "Solids/Young's modulus": "A: 1000, P: 1e6",
            "Solids/Poisson's ratio": "A: 0, P: 0",
            "Solids/Kinematics": "large displacement",
            "Boundary conditions/Displacement x": "A_z0: 0, P_z1: 0",
            "Boundary conditions/Displacement y": "A_y0: 0, P_y0: 0",
            "Boundary conditions/Displacement z":
                f"A_z0: 0, P_z1: {-part * euler}",
            "Solution/Increments": 2,
            "Contact/Slave": "A_z1", "Contact/Master": "P_z0"})
        check(f"a column under {part} of Euler's load", status == 0 if is_stable
              else status == 3 and "lost its stability" in said, said[-200:])


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
                         ("Probes/Errors", "dual weighted residuals")):
        entries = {**base, entry: value}
        if entry.startswith("Probes"):
            entries["Probes/Probes"] = "u: displacement z, Block_111"
        status, said, _ = run("refused", entries)
        check(f"{entry} = {value} is refused", status == 2, (status, said))


extruded()
flat_layer()
hertz()
friction()
squeezed_rubber()
column()
refusals()
sys.exit(bool(failures))
