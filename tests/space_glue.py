#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Glue, and contact that sticks, in 3-D: patch tests on coarse surfaces whose
meshes do not match.

Proves that displacements are linear as the supports prescribe it

- where supports hold all nodes of a slave that is coarser than its master, and in
  2-D its ends;
- of three blocks that are glued on three surfaces, two of which have a slave in
  common, and of the same blocks with friction, all of it sticking;

and that a slave is noted whose points are all held, and so glue nothing.

Usage: space_glue.py CONTACT PARAMETERS MESHES
"""

import itertools
import sys

from block_scenes import Mesh, box, check, failures, rows, run
from volume_scenes import Volumes

SOLIDS = {"Solids/Kinematics": "small strain", "Solution/Increments": 1,
          "Output/Nodes": "true"}


def solids(bodies, poisson):
    return {**SOLIDS,
            "Solids/Young's modulus": ", ".join(f"{b}: 1000" for b in bodies),
            "Solids/Poisson's ratio": ", ".join(f"{b}: {poisson}" for b in bodies)}


def cuboid(low, high):
    return lambda *at: tuple(a + s * (b - a) for a, b, s in zip(low, high, at))


def worst_node(name, exact):
    """The largest deviation of a node's displacement by the largest of them."""
    names = "displacement_x_mm", "displacement_y_mm", "displacement_z_mm"
    off = size = 0
    for node in rows(name, "nodes.csv"):
        at = node["X_mm"], node["Y_mm"], node["Z_mm"]
        for u, v in zip((node[k] for k in names), exact(*at)):
            off, size = max(off, abs(u - v)), max(size, abs(v))
    return off / size


def held_rim():
    mesh = Volumes()
    mesh.block("L", (1, 1, 1), cuboid((0, 0, -1), (4, 4, 0)))
    mesh.block("U", (2, 2, 1), cuboid((0, 0, 0), (4, 4, 1)))
    mesh.write("held_rim")
    gradient = ((1e-3, 2e-3, -1e-3), (5e-4, -2e-3, 1.5e-3), (1e-3, -5e-4, 3e-3))
    faces = [f"{body}_{side}" for body, ends in (("L", "z0"), ("U", "z1"))
             for side in ("x0", "x1", "y0", "y1", ends)]
    ways = {}
    for d, (a, b, c) in zip("xyz", gradient):
        formula = f"({a})*x+({b})*y+({c})*z"
        ways[f"Boundary conditions/Displacement formula {d}"] = "; ".join(
            f"{face}: t*({formula})" for face in faces)
    for slave, master in (("L_z1", "U_z0"), ("U_z0", "L_z1")):
        status, said, _ = run("held_rim", {
            "Mesh/File": "held_rim.msh", **solids("LU", 0.3), **ways,
            "Contact/Slave": slave, "Contact/Master": master, "Contact/Tied": "true"})
        check(f"glue between held nodes, slave {slave}", status == 0, said[-300:])
        off = worst_node("held_rim", lambda *X: [
            sum(g * x for g, x in zip(row, X)) for row in gradient])
        check(f"  displacements are linear: {off:.1e}", off < 1e-9)


def held_ends():
    """The same in 2-D."""
    mesh = Mesh()
    mesh.block("A", 5, 2, box(0, 0, 4, 1), {
        "bottom": "A_b", "left": "A_l", "right": "A_r", "top": "A_t"})
    mesh.block("B", 7, 3, box(0, 1, 4, 2), {
        "bottom": "B_b", "left": "B_l", "right": "B_r", "top": "B_t"})
    mesh.write("held_ends")
    gradient = ((1e-3, 3e-3), (5e-4, -2e-3))
    ways = {f"Boundary conditions/Displacement formula {d}": "; ".join(
        f"{side}: t*(({a})*x+({b})*y)"
        for side in ("A_b", "A_l", "A_r", "B_l", "B_r", "B_t"))
        for d, (a, b) in zip("xy", gradient)}
    for degree, slave, master in itertools.product((1, 2), ("A_t", "B_b"),
                                                   ("B_b", "A_t")):
        if slave == master:
            continue
        status, said, _ = run("held_ends", {
            "Mesh/File": "held_ends.msh", **solids("AB", 0.3), **ways,
            "Element/Degree": degree, "Contact/Slave": slave,
            "Contact/Master": master, "Contact/Tied": "true"})
        check(f"glue between held ends, slave {slave}, degree {degree}",
              status == 0, said[-300:])
        off = max(abs(node[f"displacement_{d}_mm"] - a * node["X_mm"] -
                      b * node["Y_mm"]) for node in rows("held_ends", "nodes.csv")
                  for d, (a, b) in zip("xy", gradient))
        check(f"  displacements are linear: {off:.1e} mm", off < 1e-11)


def three_blocks(law):
    """Block L carries B and C side by side, which have a surface in common."""
    mesh = Volumes()
    mesh.block("L", (2, 2, 1), cuboid((0, 0, 0), (4, 2, 1)))
    mesh.block("B", (2, 3, 1), cuboid((0, 0, 1), (2, 2, 2)))
    mesh.block("C", (2, 2, 2), cuboid((2, 0, 1), (4, 2, 2)))
    mesh.write("three_blocks")
    poisson = 0.3
    contact = {}
    for name, slave, master in (("p", "L_z1", "B_z0"), ("q", "L_z1", "C_z0"),
                                ("r", "B_x1", "C_x0")):
        contact.update({f"Contact {name}/Slave": slave,
                        f"Contact {name}/Master": master,
                        **{f"Contact {name}/{k}": v for k, v in law.items()}})
    # Pressed along z: friction sticks.
    symmetry = {"x": "L_x0: 0, B_x0: 0", "y": "L_y0: 0, B_y0: 0, C_y0: 0",
                "z": "L_z0: 0"}
    if "Tied" not in law:
        symmetry["x"] += ", L_x1: 0, C_x1: 0"
        symmetry["y"] += ", L_y1: 0, B_y1: 0, C_y1: 0"
    status, said, summary = run("three_blocks", {
        "Mesh/File": "three_blocks.msh", **solids("LBC", poisson), **contact,
        **{f"Boundary conditions/Displacement {d}": way
           for d, way in symmetry.items()},
        "Boundary conditions/Pressure": "B_z1: 1; C_z1: 1"})
    check(f"three blocks, {law}", status == 0, said[-300:])
    strain = -1e-3
    if "Tied" not in law:
        strain *= 1 - 2 * poisson**2 / (1 - poisson)
    side = -poisson * strain if "Tied" in law else 0
    off = worst_node("three_blocks",
                     lambda x, y, z: (side * x, side * y, strain * z))
    check(f"  displacements are linear: {off:.1e}", off < 1e-8)
    works = summary["increments"][-1]["works"]
    work = abs(works["friction"]) / works["strain_energy"]
    check(f"  glue and what sticks do no work: {work:.1e}", work < 1e-8)


def no_point_is_left():
    mesh = Volumes()
    mesh.block("L", (4, 1, 1), cuboid((0, 0, -1), (4, 1, 0)))
    mesh.block("U", (4, 2, 1), cuboid((0, 0, 0), (4, 1, 1)))
    mesh.write("no_point")
    walls = ", ".join(f"{body}_{side}: 0" for body in "LU"
                      for side in ("x0", "x1", "y0", "y1"))
    status, said, _ = run("no_point", {
        "Mesh/File": "no_point.msh", **solids("LU", 0.3), "Contact/Slave": "L_z1",
        "Contact/Master": "U_z0", "Contact/Discretization": "nodal",
        "Contact/Tied": "true", "Boundary conditions/Pressure": "U_z1: 1",
        **{f"Boundary conditions/Displacement {d}": walls for d in "xyz"}})
    check("glue without a point is noted", status == 0 and
          "and nothing is glued" in said and "check the groups" not in said,
          said[:400])


held_rim()
held_ends()
three_blocks({"Tied": "true"})
three_blocks({"Friction coefficient": 0.5})
no_point_is_left()
sys.exit(len(failures) > 0)
