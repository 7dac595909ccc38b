#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Slave groups that go round convex corners: the sole of a block and its sides.

Proves that

- of a block under a uniform stress on a half plane, or half space, with friction
  and without, pressure and shear are uniform up to the corners and edges, by
  probe, profile and in the largest values, and so is the stress there; width and
  area are those of the sole, and no errors are estimated;
- where the end of such a slave is in a plane of symmetry its corner has the pressure
  of the sole;
- a block that stands on a corner has the force on both sides that meet there as
  long as they are face to face with the ground, which ends at 75 degrees; with
  the Gauss-point discretization, no point of which looks at the corner, it is a
  violated invariant that it sinks in;
- beyond the end of a master there is no contact: a long slave on a short master
  touches it by no more than its width, where nodes of the slave are at its end, or
  beside it;
- the force of a corner of the master on a slave edge of degree 2 is pressure at its
  nodes, without tension and without shear;
- of a polygon that turns in a polygonal hole, whose convex corners alone carry the
  load, one contact group around it has the forces of a pair for each side;
- a block that is pushed against the foot of a ramp runs up it, with the force of a
  rigid block, whether the ground is one slave or two;
- what springs do in a corner of a plane does not depend on the augmentation;
- with friction on all sides a cube in a corner of three walls goes where forces push
  it, in few steps and the same way with the walls as the slave; and along an edge of
  two walls, of one body or obstacles, it is dragged by the coefficient of friction
  times what it presses them with.

Usage: slave_corners.py CONTACT PARAMETERS MESHES
"""

import itertools
import math
import sys

from block_scenes import Mesh, box, check, failures, rows, run
from volume_scenes import Volumes

NU, P, Q, MU = 0.3, 2, 0.5, 0.3
SOLIDS = {"Solids/Young's modulus": "B: 1000",
          "Solids/Poisson's ratio": f"B: {NU}",
          "Solids/Kinematics": "small strain"}


def value(summary, name):
    return next(p["value"] for p in summary["probes"] if p["name"] == name)


def of_sole(table):
    """The largest pressure at each place: a corner has a row for each side."""
    pressures = {}
    for row in table:
        if row["Y_mm"] == 0:
            pressures[row["X_mm"]] = max(row["pressure_MPa"],
                                         pressures.get(row["X_mm"], 0))
    return pressures.values()


def sole():
    """Sides that hold the sole's length: it sticks, under p and the shear q."""
    mesh = Mesh()
    mesh.block("B", 4, 4, box(0, 0, 1, 1),
               {"bottom": "Skin", "left": "Skin", "right": "Skin", "top": "Top"})
    mesh.block("B", 4, 4, box(0, 0, 1, 1), {"left": "Left", "right": "Right"})
    mesh.merge()
    mesh.elements = list(dict.fromkeys(mesh.elements))
    mesh.write("sole")
    across = NU / (1 - NU) * P
    for degree in (1, 2):
        for rule in ("mortar", "nodal", "Gauss"):
            status, said, summary = run("sole", {
                "Mesh/File": "sole.msh", "Mesh/Points": "C in B: 0, 0; "
                "D in B: 1, 0", **SOLIDS, "Element/Degree": degree,
                "Contact/Slave": "Skin",
                "Contact/Obstacle": "half plane: 0, 0, 0, 1",
                "Contact/Discretization": rule,
                "Contact/Friction coefficient": MU,
                "Boundary conditions/Pressure":
                    f"Top: {P}; Left: {across!r}; Right: {across!r}",
                "Boundary conditions/Traction x": f"Top: {Q}",
                "Boundary conditions/Traction y": f"Left: {-Q}; Right: {Q}",
                "Probes/Probes": "; ".join(
                    f"{q}{c}: {of}, {c}" for c in "CD" for q, of in
                    (("p", "pressure"), ("q", "shear"), ("s", "stress yy"))),
                "Output/Profile": "true"})
            what = f"sole, degree {degree}, {rule}"
            check(f"{what}: converges", status == 0, said[-300:])
            if status != 0:
                continue
            zone = summary["contact"]
            worst = max([abs(value(summary, q + c) / reference - 1)
                         for c in "CD" for q, reference in
                         (("p", P), ("q", Q), ("s", -P))] +
                        [abs(zone[name] / reference - 1)
                         for name, reference in
                         (("max_pressure", P), ("max_shear", Q),
                          ("width", 1), ("stick_width", 1))] +
                        [abs(pressure / P - 1)
                         for pressure in of_sole(rows("sole"))])
            check(f"  uniform up to the corners: {worst:.1e}", worst < 1e-8)


def sole_in_space():
    """A block on a half space, all its sides but the upper one in the slave."""
    mesh = Volumes()
    mesh.block("B", (2, 3, 2), lambda r, s, t: (r, s, t),
               {side: "skin" for side in ("x0", "x1", "y0", "y1", "z0")} |
               {"z1": "top"})
    mesh.write("sole_in_space")
    for degree in (1, 2):
        for rule in ("mortar", "nodal"):
            status, said, summary = run("sole_in_space", {
                "Mesh/File": "sole_in_space.msh", **SOLIDS,
                "Element/Degree": degree, "Contact/Slave": "B_skin",
                "Contact/Obstacle": "half space: 0, 0, 0, 0, 0, 1",
                "Contact/Discretization": rule,
                "Boundary conditions/Displacement x": "B_000: 0, B_001: 0",
                "Boundary conditions/Displacement y": "B_000: 0, B_100: 0",
                "Boundary conditions/Pressure": f"B_top: {P}",
                "Probes/Probes": "; ".join(f"p{c}: pressure, B_{c}"
                                           for c in ("000", "100", "110"))})
            what = f"sole in 3-D, degree {degree}, {rule}"
            check(f"{what}: converges", status == 0, said[-300:])
            if status != 0:
                continue
            worst = max([abs(probe["value"] / P - 1)
                         for probe in summary["probes"]] +
                        [abs(summary["contact"]["max_pressure"] / P - 1),
                         abs(summary["contact"]["area"] - 1)])
            check(f"  uniform up to edges and corners: {worst:.1e}",
                  worst < 1e-8)


def not_refined():
    """Under a pressure alone, whose solution the mesh has: no errors."""
    mesh = Mesh()
    mesh.block("B", 4, 4, box(0, 0, 1, 1),
               {"bottom": "Skin", "left": "Skin", "right": "Skin", "top": "Top"})
    mesh.write("not_refined")
    for degree in (1, 2):
        status, said, summary = run("not_refined", {
            "Mesh/File": "not_refined.msh", "Mesh/Points": "M in B: 0.5, 1",
            **SOLIDS, "Element/Degree": degree, "Contact/Slave": "Skin",
            "Contact/Obstacle": "half plane: 0, 0, 0, 1",
            "Boundary conditions/Displacement x": "M: 0",
            "Boundary conditions/Pressure": f"Top: {P}",
            "Refinement/Levels": 2, "Refinement/Strategy": "adaptive"})
        cells = [level["cells"] for level in summary.get("levels", [])]
        check(f"not refined, degree {degree}: no error is estimated",
              status == 0 and cells == [16, 16, 16], f"{cells} {said[-300:]}")


def in_a_plane_of_symmetry():
    """The end of the slave is held along its normal, its sole is free there."""
    mesh = Mesh()
    mesh.block("A", 3, 3, box(0, -1, 1, 0),
               {"bottom": "Base", "top": "Ground", "left": "Middle"})
    mesh.block("B", 3, 3, box(0, 0, 1, 1),
               {"bottom": "Skin", "left": "Skin", "top": "Top"})
    for j in range(3):
        mesh.add(1, "Left", (17 + 4 * j, 21 + 4 * j))
    mesh.write("in_a_plane_of_symmetry")
    for degree in (1, 2):
        status, said, summary = run("in_a_plane_of_symmetry", {
            "Mesh/File": "in_a_plane_of_symmetry.msh",
            "Mesh/Points": "C in B: 0, 0",
            "Solids/Young's modulus": "A: 1000, B: 1000",
            "Solids/Poisson's ratio": f"A: {NU}, B: {NU}",
            "Solids/Kinematics": "small strain", "Element/Degree": degree,
            "Contact/Slave": "Skin", "Contact/Master": "Ground",
            "Boundary conditions/Displacement x": "Middle: 0, Left: 0",
            "Boundary conditions/Displacement y": "Base: 0",
            "Boundary conditions/Pressure": f"Top: {P}",
            "Probes/Probes": "p: pressure, C"})
        pressure = value(summary, "p") if status == 0 else 0
        check(f"in a plane of symmetry, degree {degree}: uniform",
              abs(pressure / P - 1) < 1e-8 and
              abs(summary["contact"]["width"] - 1) < 1e-8,
              f"{pressure} {said[-300:]}")


def standing(name):
    """A square with sides of 1 mm on its corner; returns its height."""
    mesh = Mesh()
    c = math.sqrt(0.5)
    mesh.block("B", 4, 4, lambda s, t: (c * (s - t), c * (s + t)),
               {"bottom": "Skin", "left": "Skin", "top": "Top", "right": "Top"})
    mesh.write(name)
    return 2 * c


def on_its_corner():
    """Symmetric, and upright by a support: force by the lengths of both sides."""
    height = standing("on_its_corner")
    for degree, share in ((1, 0.25), (2, 0.25 / 3)):
        status, said, summary = run("on_its_corner", {
            "Mesh/File": "on_its_corner.msh", "Mesh/Points":
            f"C in B: 0, 0; T in B: 0, {height!r}", **SOLIDS,
            "Element/Degree": degree, "Contact/Slave": "Skin",
            "Contact/Obstacle": "half plane: 0, 0, 0, 1",
            "Boundary conditions/Displacement x": "C: 0, T: 0",
            "Boundary conditions/Pressure": "Top: 0.1",
            "Probes/Probes": "p: pressure, C"})
        force = 0.1 * height
        check(f"on its corner, degree {degree}: force by both sides",
              status == 0 and
              abs(value(summary, "p") * share / force - 1) < 1e-6,
              f"{value(summary, 'p') * share if status == 0 else said[-300:]} "
              f"{force}")


def tilted():
    """A stiff block that is dragged on its corner, with a given shear of 2 MPa:
    sides of edges of 1 and 0.5 mm; on a half plane, and by the mortar
    discretization on another stiff block."""
    for on_block in (False, True):
        tilted_on(on_block)


def tilted_on(on_block):
    for degrees in (10, 20, 25, 34, 37, 45, 60):
        mesh = Mesh()
        a = math.radians(degrees)
        mesh.block("B", 2, 4, lambda s, t: (
            2 * s * math.cos(a) - 2 * t * math.sin(a),
            2 * s * math.sin(a) + 2 * t * math.cos(a)),
            {"bottom": "Skin", "left": "Skin", "top": "Top"})
        if on_block:
            mesh.block("Base", 7, 1, lambda s, t: (20 * s - 10, 3 * t - 3),
                       {"top": "Ground", "bottom": "Held"})
        mesh.write("tilted")
        status, said, summary = run("tilted", {
            "Mesh/File": "tilted.msh", **SOLIDS, "Contact/Slave": "Skin",
            **({"Contact/Master": "Ground",
                "Solids/Young's modulus": "B: 1e9, Base: 1e9",
                "Solids/Poisson's ratio": "B: 0, Base: 0"} if on_block else
               {"Contact/Obstacle": "half plane: 0, 0, 0, 1",
                "Solids/Young's modulus": "B: 1e9"}),
            "Contact/Tresca limit": "2",
            "Boundary conditions/Displacement x":
                "Top: 0.1" + (", Held: 0" if on_block else ""),
            "Boundary conditions/Displacement y":
                "Top: -1e-7" + (", Held: 0" if on_block else "")})
        # The sides are off the normal by the tilt, and by 90 degrees less it. On
        # the block one has it all that is more opposite by 17.5 degrees.
        most = min(degrees, 90 - degrees) + 17.5 if on_block else 75
        length = sum(share for share, angle in ((0.5, degrees),
                                                (0.25, 90 - degrees))
                     if angle < most)
        shear = abs(summary["contact"]["tangential_force"]) if status == 0 else 0
        check(f"tilted by {degrees} degrees{' on a block' * on_block}: the "
              "length of the corner",
              abs(shear / (2 * length) - 1) < 1e-6,
              f"{shear / 2} {length} {said[-300:]}")


def sunk():
    """A corner of 90 degrees that no Gauss point looks at."""
    standing("sunk")
    status, said, summary = run("sunk", {
        "Mesh/File": "sunk.msh", **SOLIDS, "Contact/Slave": "Skin",
        "Contact/Obstacle": "half plane: 0, 0, 0, 1",
        "Contact/Discretization": "Gauss",
        "Boundary conditions/Displacement x": "Top: 0",
        "Boundary conditions/Displacement y": "Top: -0.01"})
    check("a corner sinks in by the Gauss rule: said", status == 1 and "depth: "
          "the place of the slave at X = (0, 0) mm is" in said,
          f"{status} {said[-300:]}")


def by_a_corner():
    """A corner between two slave nodes, in a quarter of their edge."""
    mesh = Mesh()
    c = math.sqrt(0.5)
    mesh.block("A", 3, 3, lambda s, t: (0.125 + 2 * c * (s - t), 2 * c * (s + t)),
               {"bottom": "Tip", "left": "Tip", "top": "Top", "right": "Top"})
    mesh.block("B", 6, 3, box(-1.5, -2, 1.5, 0), {"bottom": "Base", "top": "Ground"})
    mesh.write("by_a_corner")
    status, said, summary = run("by_a_corner", {
        "Mesh/File": "by_a_corner.msh", "Element/Degree": 2,
        "Solids/Young's modulus": "A: 1000, B: 1000",
        "Solids/Poisson's ratio": "A: 0.3, B: 0.3",
        "Solids/Kinematics": "small strain",
        "Contact/Slave": "Ground", "Contact/Master": "Tip",
        "Boundary conditions/Displacement x": "Base: 0, Top: 0",
        "Boundary conditions/Displacement y": "Base: 0, Top: -0.01",
        "Output/Profile": "true"})
    check("by a corner: converges", status == 0, said[-300:])
    if status == 0:
        slave = [row for row in rows("by_a_corner") if row["surface"] == "slave"]
        force = sum(row["nodal_force_N_per_mm"] for row in slave)
        worst = min(row["pressure_MPa"] for row in slave)
        check("  no tension", worst >= 0, str(worst))
        worst = max(abs(row["shear_MPa"]) for row in slave)
        check("  no shear", worst < 1e-9, str(worst))
        check("  the force is that of contact",
              force > 0 and
              abs(force / summary["contact"]["normal_force"] - 1) < 1e-9,
              f"{force} {summary['contact']['normal_force']}")


def short_master():
    """A long slave of n edges, 6 mm, pressed on a master 2 mm long."""
    for n in (12, 11):
        mesh = Mesh()
        mesh.block("A", 8, 4, box(-1, -2, 1, 0), {"bottom": "Base", "top": "Head"})
        mesh.block("A", 8, 4, box(-1, -2, 1, 0),
                   {side: "Round" for side in ("left", "top", "right")})
        mesh.merge()
        mesh.elements = list(dict.fromkeys(mesh.elements))
        mesh.block("B", n, 3, box(-3, 0, 3, 2), {"bottom": "Sole", "top": "Top"})
        mesh.write("short_master")
        for degree in (1, 2):
            for rule in ("mortar", "nodal"):
                status, said, summary = run("short_master", {
                    "Mesh/File": "short_master.msh",
                    "Mesh/Points": "Z in B: 0, 2" if n == 12 else
                                   "Z in B: 0.27272727272727, 2",
                    "Solids/Young's modulus": "A: 1000, B: 1000",
                    "Solids/Poisson's ratio": "A: 0.3, B: 0.3",
                    "Solids/Kinematics": "small strain",
                    "Element/Degree": degree, "Contact/Slave": "Sole",
                    "Contact/Master": "Head" if n == 12 else "Round",
                    "Contact/Discretization": rule,
                    "Boundary conditions/Displacement x": "Base: 0, Z: 0",
                    "Boundary conditions/Displacement y": "Base: 0, Top: -0.01"})
                width = summary["contact"]["width"] if status == 0 else 0
                check(f"{n} edges, degree {degree}, {rule}: no wider than the "
                      "master, up to half an edge less",
                      2 - 3 / n < width < 2.01, f"{width} {said[-300:]}")


def on_one_node():
    """A block beyond the end of its master, pressed with one node: the end of the
    master stays outside, and the width is that of the part of an edge that the master
    covers."""
    mesh = Mesh()
    mesh.block("A", 16, 6, box(-4, -3, 4, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 3, 2, box(0.6, 0, 6.6, 2), {"bottom": "Sole", "top": "Head"})
    mesh.write("on_one_node")
    status, said, summary = run("on_one_node", {
        "Mesh/File": "on_one_node.msh",
        "Solids/Young's modulus": "A: 1000, B: 1000",
        "Solids/Poisson's ratio": "A: 0.3, B: 0.3",
        "Boundary conditions/Displacement x": "Base: 0, Head: 0",
        "Boundary conditions/Displacement y": "Base: 0",
        "Boundary conditions/Displacement formula y": "Head: t*(-0.03-0.03*(x-3.6))",
        "Contact/Slave": "Sole", "Contact/Master": "Ground"})
    check("pressed with one node beyond the end of the master: converges",
          status == 0, said[-300:])
    width = summary["contact"]["width"] if status < 2 else math.nan
    check("  the width", 0 < width < 4 - 2.6, f"{width} {said[-300:]}")


def side_of_polygon(sides, j, inner, outer):
    """Between two similar polygons, the part beside their side j."""
    def corner(k):
        angle = 2 * math.pi * (k % sides) / sides
        return math.cos(angle), math.sin(angle)

    def place(s, t):
        a, b = corner(j + 1), corner(j)
        r = inner + t * (outer - inner)
        return tuple(r * ((1 - s) * p + s * q) for p, q in zip(a, b))
    return place


def nut(sides, edges, one_group, of_master=None, friction=0):
    """A polygon turned in a hole. Returns its contact results."""
    of_master = of_master or edges * 3 // 2 - 1
    mesh = Mesh()
    for j in range(sides):
        name = "" if one_group else str(j)
        mesh.block("N", edges, 3, side_of_polygon(sides, j, 4, 10),
                   {"top": "S" + name, "bottom": "Inside"})
        mesh.block("R", of_master, 3,
                   side_of_polygon(sides, j, 10.02, 16),
                   {"bottom": "M" + name, "top": "Outside"})
    mesh.merge()
    mesh.write("nut")
    pairs = {"Contact": ""} if one_group else {
        f"Contact {j}": str(j) for j in range(sides)}
    status, said, summary = run("nut", {
        "Mesh/File": "nut.msh",
        "Solids/Young's modulus": "N: 2000, R: 2000",
        "Solids/Poisson's ratio": "N: 0.3, R: 0.3",
        "Solids/Kinematics": "small strain",
        **{f"{pair}/Slave": "S" + j for pair, j in pairs.items()},
        **{f"{pair}/Master": "M" + j for pair, j in pairs.items()},
        **{f"{pair}/Friction coefficient": friction for pair in pairs},
        "Boundary conditions/Displacement x": "Outside: 0",
        "Boundary conditions/Displacement y": "Outside: 0",
        "Boundary conditions/Displacement formula x": "Inside: -0.03*t*y",
        "Boundary conditions/Displacement formula y": "Inside: 0.03*t*x",
        "Solution/Increments": 2,
        "Probes/Probes": "energy: strain energy, N"})
    check(f"{sides} sides, {'one group' if one_group else 'a pair each'}: "
          "converges", status == 0, said[-300:])
    if status != 0:
        return {}
    zones = [summary[pair.lower()] for pair in pairs]
    return {"energy": value(summary, "energy")} | {
        name: how(zone[name] for zone in zones) for name, how in
        (("normal_force", sum), ("max_pressure", max), ("width", sum))}


def turned_in_a_hole():
    # With friction points that stick on both sides of a corner are redundant:
    # both end in the condensed system.
    for sides, edges, *more in ((6, 4), (8, 4, 3, 0.3), (12, 8)):
        of_one = nut(sides, edges, True, *more)
        of_all = nut(sides, edges, False, *more)
        worst = max((abs(of_one[name] / of_all[name] - 1) for name in of_one
                     if name in of_all), default=1)
        check(f"  one group as a pair for each side: {worst:.1e}", worst < 0.02,
              f"{of_one} {of_all}")


def up_a_ramp():
    """Weight W, and no rotation: the force is W tan(slope + angle of friction)."""
    weight, mu, way, to_foot = 20., 0.15, 0.8, 0.5
    for slope in (30, 55):
        rise = math.tan(math.radians(slope))
        mesh = Mesh()
        mesh.block("Ground", 6, 2, box(-6, -2, 0, 0), {"bottom": "Base", "top": "Floor"})
        mesh.block("Ground", 4, 2, lambda s, t, rise=rise: (
            4 * s, (1 - t) * -2 + t * 4 * s * rise), {"bottom": "Base", "top": "Ramp"})
        mesh.merge()
        mesh.block("Block", 4, 4, box(-3 - to_foot, 0, -to_foot, 3), {
            "bottom": "Sides", "right": "Sides", "top": "Head"})
        mesh.write("ramp")
        expected = weight * math.tan(math.radians(slope) + math.atan(mu))
        scene = {"Mesh/File": "ramp.msh", "Mesh/Points": "P: -2, 3",
                 "Mesh/Groups": "Up: Floor, Ramp",
                 "Solids/Young's modulus": "Ground: 50000, Block: 50000",
                 "Solids/Poisson's ratio": "Ground: 0.3, Block: 0.3",
                 "Solids/Kinematics": "large displacement",
                 "Boundary conditions/Rigid": "Head: P",
                 "Boundary conditions/Rotation z": "Head: 0",
                 "Boundary conditions/Displacement x": f"Base: 0, Head: {way}",
                 "Boundary conditions/Displacement y": "Base: 0",
                 "Boundary conditions/Force y": f"Head: {-weight}",
                 "Boundary conditions/Histories":
                     "Displacement x: max(0, (t - 0.1)/0.9); Force y: min(1, 10*t)",
                 "Solution/Increments": 12, "Probes/Errors": "none",
                 "Probes/Probes": "push: reaction x, Head; up: displacement y, P"}
        friction = {"Friction coefficient": mu}
        for what, pairs in (
                ("one slave", {"Contact": {"Slave": "Up", "Master": "Sides"}}),
                ("two slaves", {"Contact a": {"Slave": "Floor", "Master": "Sides"},
                                "Contact b": {"Slave": "Ramp", "Master": "Sides"}})):
            status, said, summary = run("ramp", {**scene, **{
                f"{pair}/{key}": entry for pair, entries in pairs.items()
                for key, entry in {**entries, **friction}.items()}})
            push, up = (value(summary, name) if status == 0 else math.nan
                        for name in ("push", "up"))
            check(f"up a ramp of {slope} degrees, {what}",
                  abs(push / expected - 1) < 0.01 and
                  abs(up / ((way - to_foot) * rise) - 1) < 0.05,
                  f"{push} {expected} {up} {(way - to_foot) * rise} {said[-200:]}")


def room(walls):
    """A cube, with forces and without rotation on its head, in walls that meet."""
    mesh = Volumes()
    for low in itertools.product(*((-1, 0) if d in walls else (0,) for d in range(3))):
        if min(low) < 0:
            ends = [(a, 0 if a < 0 else 3) for a in low]
            mesh.block(
                "Walls", [1 if a < 0 else 3 for a in low],
                lambda *r, ends=ends: [a + s * (b - a) for s, (a, b) in zip(r, ends)],
                {"xyz"[d] + "1": "in" for d in range(3) if sum(low) == low[d] == -1} |
                {"xyz"[d] + "0": "base" for d in range(3) if low[d] == -1}, {})
    mesh.block("Cube", (2, 2, 2), lambda *r: [2 * s for s in r],
               {"xyz"[d] + "0": "out" for d in walls}, {})
    mesh.block("Cube", (2, 2, 1), lambda r, s, t: (  # it leans away from the walls
        2 * r + (1 - r) * t, 2 * s + (1 - s) * t, 2 + t), {"z1": "head"}, {"111": "P"})
    mesh.write("room")
    held = {f"Boundary conditions/Displacement {c}": "Walls_base: 0" for c in "xyz"}
    return {"Mesh/File": "room.msh",
            "Solids/Young's modulus": "Walls: 200000, Cube: 200000",
            "Solids/Poisson's ratio": "Walls: 0.3, Cube: 0.3", **held,
            "Boundary conditions/Rigid": "Cube_head: Cube_P",
            **{f"Boundary conditions/Rotation {c}": "Cube_head: 0" for c in "xyz"},
            "Solution/Increments": 2, "Probes/Errors": "none"}


def pushed_into_a_plane_corner():
    """The way does not depend on c, by which conditions alone are weighed."""
    mesh = Mesh()
    for low in itertools.product((0, 1), repeat=2):
        if min(low) == 0:
            ends = [(-1 + a, 0 if a == 0 else 3) for a in low]
            mesh.block("Walls", *(1 if a == 0 else 3 for a in low),
                       lambda *r, ends=ends: tuple(
                           a + s * (b - a) for s, (a, b) in zip(r, ends)),
                       {"bottom": "Base", "top": "In"} if low == (1, 0) else
                       {"left": "Base", "right": "In"} if low == (0, 1) else {})
    mesh.merge()
    mesh.block("Block", 4, 6, lambda s, t: (2 * s + max(0, 3 * t - 2), 3 * t), {
        "bottom": "Out", "left": "Out", "top": "Head"})
    mesh.write("plane_corner")
    for rule, slave, master, end in (
            ("mortar", "Out", "In", {"Contact/Excluded points": "End"}),
            ("nodal", "Out", "In", {"Contact/Excluded points": "End"}),
            ("mortar", "In", "Out", {})):
        ways = []
        for c in (1e-3, 1, 100):
            status, said, summary = run("plane_corner", {
                "Mesh/File": "plane_corner.msh", "Mesh/Points": "P: 3, 3; End in Block: 1, 3",
                "Solids/Young's modulus": "Walls: 1000, Block: 1000",
                "Solids/Poisson's ratio": "Walls: 0.3, Block: 0.3",
                "Boundary conditions/Displacement x": "Base: 0",
                "Boundary conditions/Displacement y": "Base: 0",
                "Boundary conditions/Rigid": "Head: P",
                "Boundary conditions/Rotation z": "Head: 0",
                "Boundary conditions/Force x": "Head: -10",
                "Boundary conditions/Force y": "Head: -20",
                "Contact/Slave": slave, "Contact/Master": master,
                "Contact/Discretization": rule, "Contact/Friction coefficient": 0.5,
                "Contact/Augmentation parameter": c, **end,
                "Solution/Increments": 2, "Probes/Errors": "none",
                "Probes/Probes": "ux: displacement x, P; uy: displacement y, P"})
            steps = [i["newton_iterations"] for i in summary.get("increments", [])]
            check(f"into a plane corner, {rule}, slave {slave}, c {c}: {steps} steps",
                  status == 0 and max(steps) <= 12, said[-300:] if status else "")
            if status == 0:
                ways.append([value(summary, u) for u in ("ux", "uy")])
        check("  the same way for all c", len(ways) == 3 and all(
            abs(a / b - 1) < 1e-6 for way in ways for a, b in zip(way, ways[1])), ways)


CUBE_SLAVE = {"Contact/Slave": "Cube_out", "Contact/Master": "Walls_in"}
OBSTACLES = {
    f"Contact {c}/{key}": entry for c, normal in (("x", "1, 0, 0"), ("z", "0, 0, 1"))
    for key, entry in (("Slave", "Cube_out"),
                       ("Obstacle", f"half space: 0, 0, 0, {normal}"))}
WALLS_SLAVE = {"Contact/Slave": "Walls_in", "Contact/Master": "Cube_out"}


def pushed_into_a_corner():
    scene = room((0, 1, 2))
    for mu in (0.05, 0.2, 0.5):
        ways = []
        for what, contact in (("cube", CUBE_SLAVE), ("walls", WALLS_SLAVE)):
            status, said, summary = run("room", {
                **scene, **contact, "Contact/Friction coefficient": mu,
                **{f"Boundary conditions/Force {c}": f"Cube_head: {f}"
                   for c, f in zip("xyz", (-30, -20, -40))},
                "Probes/Probes": "; ".join(
                    f"u{c}: displacement {c}, Cube_P" for c in "xyz")})
            steps = [i["newton_iterations"] for i in summary.get("increments", [])]
            check(f"into a corner, friction {mu}, slave {what}: {steps} steps",
                  status == 0 and max(steps) <= 12, said[-300:])
            if status == 0:
                ways.append([value(summary, f"u{c}") for c in "xyz"])
        check("  the same way", len(ways) == 2 and all(
            abs(a / b - 1) < 1e-4 for a, b in zip(*ways)), ways)


def dragged_along_an_edge():
    scene = room((0, 2))
    for what, degree, rule, contact in (
            ("cube", 1, "mortar", CUBE_SLAVE), ("walls", 1, "mortar", WALLS_SLAVE),
            ("cube", 2, "mortar", CUBE_SLAVE), ("cube", 1, "nodal", CUBE_SLAVE),
            ("obstacles", 1, "mortar", OBSTACLES), ("obstacles", 1, "nodal", OBSTACLES)):
        for mu in (0.2, 0.6):
            status, said, summary = run("room", {
                **scene, **contact, "Element/Degree": degree,
                **{f"{pair}/{key}": entry
                   for pair in {name.split("/")[0] for name in contact}
                   for key, entry in (("Friction coefficient", mu),
                                      ("Discretization", rule))},
                "Solution/Increments": "0.5, 0.75, 1",
                "Boundary conditions/Displacement y": "Walls_base: 0, Cube_head: 0.2",
                "Boundary conditions/Force x": "Cube_head: -30",
                "Boundary conditions/Force z": "Cube_head: -40",
                "Boundary conditions/Histories":
                    "Force x: min(1, 2*t); Force z: min(1, 2*t); "
                    "Displacement y: max(0, 2*t - 1)",
                "Probes/Probes": "drag: reaction y, Cube_head"})
            steps = [i["newton_iterations"] for i in summary.get("increments", [])]
            drag = value(summary, "drag") if status == 0 else math.nan
            check(f"along an edge, {what}, degree {degree}, {rule}, friction {mu}: "
                  f"{steps} steps",
                  abs(drag / (mu * 70) - 1) < 5e-4 and max(steps) <= 15,
                  f"{drag} {mu * 70} {said[-300:]}")


for scene in (sole, sole_in_space, not_refined,
              in_a_plane_of_symmetry, on_its_corner, tilted, sunk,
              by_a_corner, short_master, on_one_node, turned_in_a_hole,
              up_a_ramp, pushed_into_a_plane_corner, pushed_into_a_corner, dragged_along_an_edge):
    scene()
sys.exit(len(failures) > 0)
