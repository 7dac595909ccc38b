#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact/Elastic slip: below its bound the shear grows with the slip.

Proves that

- stiff blocks under the force N that are pushed to and fro on a plane or a block
  are held by mu N z, z = z at the start + slip/length, returned to |z| <= 1, after
  each increment to 2e-5: in 2-D and 3-D (where the path turns), nodal and mortar
  discretization, in 2-D also in Gauss points, degree 1 and 2, by CHOLMOD, UMFPACK,
  AMG and GMG, on two levels of meshes, under Tresca's bound, with the bound as a
  fixed point, and in large displacement to 2e-3; under half of N they keep z;
- this takes at most seven Newton steps an increment, and none is cut;
- an elastic block that is dragged across another, part of it slipping, has the same
  forces in all linear systems and on two processes, to 1e-8;
- these tend to the forces of exact sticking in proportion to the length;
- a share of the edge is the length that it stands for;
- estimated by two Newton steps, the effect of elastic slip is the true one within
  its uncertainty;
- there is a message for lengths that are none, without friction and for ties.

Usage: elastic_slip.py CONTACT PARAMETERS MESHES
"""

import csv
import itertools
import math
import pathlib
import sys

import numpy

from block_scenes import Mesh, box, check, failures, rows, run, solve, violations
from space_scenes import probes
from volume_scenes import Volumes

FRICTION, PRESSURE, AREA, LENGTH = 0.3, 4., 10., 0.01
# By the length, along x and, in 3-D, y; and the part of the pressure.
WAY = ((0, 0), (0.4, 0), (0.8, 0.1), (1.6, 0.4), (2, 0.4), (1.5, 0.5), (0.6, 1.4),
       (-0.5, 1.9), (0, 1), (0, 1))
PRESSED = (1,) * 9 + (0.5,)


def shares(dim):
    """Of the bound, after each increment."""
    z, last, all_of_them = numpy.zeros(dim - 1), numpy.zeros(dim - 1), []
    for way in WAY:
        way = numpy.array(way[:dim - 1])
        z = z + way - last
        z, last = z / max(1., float(numpy.linalg.norm(z))), way
        all_of_them.append(z)
    return all_of_them


def table(values):
    return "table(0 0, " + ", ".join(
        f"{(i + 1) / len(values)} {v}" for i, v in enumerate(values)) + ")"


def stiff_blocks(dim, master, degree, modulus=2e9):
    """Mesh and entries: a block of 10 mm (10 mm^2) on a plane or a block."""
    name = f"stiff_{dim}_{master}"
    if dim == 2:
        mesh = Mesh()
        mesh.block("Up", 4, 1, box(1, 0, 11, 2), {"bottom": "Sole", "top": "Head"})
        if master == "block":
            mesh.block("Low", 5, 1, box(0, -2, 12, 0),
                       {"bottom": "Base", "top": "Ground"})
        sole, head, ground, base = "Sole", "Head", "Ground", "Base"
        plane = "half plane: 0, 0, 0, 1"
    else:
        mesh = Volumes()
        mesh.block("Up", (3, 2, 1), lambda r, s, t: (1 + 5 * r, 1 + 2 * s, 0.3 * t))
        if master == "block":
            mesh.block("Low", (4, 3, 1),
                       lambda r, s, t: (7 * r, 4 * s, 2 * t - 2.))
        sole, head, ground, base = "Up_z0", "Up_z1", "Low_z1", "Low_z0"
        plane = "half space: 0, 0, 0, 0, 0, 1"
    mesh.write(name)
    entries = {
        "Mesh/File": f"{name}.msh", "Element/Degree": degree,
        "Solids/Young's modulus": f"Up: {modulus}", "Solids/Poisson's ratio": "Up: 0.2",
        "Solids/Kinematics": "small strain", "Solution/Geometry": "undeformed",
        "Boundary conditions/Pressure": f"{head}: {PRESSURE}",
        "Contact/Slave": sole, "Contact/Elastic slip": LENGTH,
        "Contact/Friction coefficient": FRICTION,
        "Solution/Increments": len(WAY), "Solution/Newton tolerance": 1e-10}
    histories = [f"Pressure: {table(PRESSED)}"]
    supports = {}
    for c in "xyz"[:dim - 1]:
        supports[c] = f"{head}: {LENGTH}"
        values = [way["xy".index(c)] for way in WAY]
        histories.append(f"Displacement {c}: {table(values)}")
    if master == "block":
        entries["Contact/Master"] = ground
        entries["Solids/Young's modulus"] += f", Low: {modulus}"
        entries["Solids/Poisson's ratio"] += ", Low: 0.2"
        for c in "xyz"[:dim]:
            supports[c] = ", ".join(
                [*([supports[c]] if c in supports else []), f"{base}: 0"])
    else:
        entries["Contact/Obstacle"] = plane
    for c, value in supports.items():
        entries[f"Boundary conditions/Displacement {c}"] = value
    entries["Boundary conditions/Histories"] = "; ".join(histories)
    entries["Probes/Probes"] = "; ".join(
        f"R{c}: reaction {c}, {head}" for c in "xyz"[:dim - 1])
    return name, entries


def history(name):
    with open(f"output/{name}/history.csv", encoding="utf-8") as lines:
        return list(csv.DictReader(lines))


def holds(what, dim, name, entries, bound=None, steps=7, tolerance=2e-5):
    """Whether the reactions are those of the law."""
    status, said, summary = run(name, entries)
    violated = violations(summary)
    check(f"{what}: converges", status == 0 and not violated,
          said[-400:] if status else violated)
    if status:
        return
    n = len(history(name))
    check("  no increment is cut", n == len(WAY), n)
    if n > len(WAY):
        return
    found = [[float(next(v for k, v in row.items() if k.startswith(f"R{c} [")))
              for c in "xyz"[:dim - 1]] for row in history(name)]
    wanted = [z * (FRICTION * PRESSURE * AREA * pressed if bound is None else bound)
              for z, pressed in zip(shares(dim), PRESSED)]
    worst = float(numpy.abs(numpy.subtract(found, wanted)).max())
    check("  the forces are those of the law", worst < tolerance * FRICTION *
          PRESSURE * AREA, worst)
    most = max(i["newton_iterations"] for i in summary["increments"])
    check(f"  at most {steps} Newton steps an increment", most <= steps, most)


def law():
    for dim, master, degree in itertools.product((2, 3), ("plane", "block"), (1, 2)):
        rules = ("nodal", "mortar") + (("Gauss",) if dim == 2 else ())
        for rule in rules:
            name, entries = stiff_blocks(dim, master, degree)
            holds(f"{dim}-D, {rule} on a {master}, degree {degree}", dim, name,
                  {**entries, "Contact/Discretization": rule})
    for dim, more in (
            (2, {"Solution/Linear solver": "UMFPACK"}),
            (2, {"Solution/Linear solver": "AMG"}),
            (2, {"Solution/Linear solver": "GMG"}),
            (3, {"Solution/Linear solver": "AMG"}),
            (3, {"Solution/Linear solver": "GMG"}),
            (2, {"Refinement/Levels": 1}), (3, {"Refinement/Levels": 1})):
        name, entries = stiff_blocks(dim, "block", 1)
        holds(f"{dim}-D, {more}", dim, name, {**entries, **more})
    for dim in (2, 3):
        name, entries = stiff_blocks(dim, "block", 1, modulus=2e6)
        holds(f"{dim}-D, large displacement", dim, name, {
            **entries, "Solids/Kinematics": "large displacement",
            "Solution/Geometry": "automatic"}, tolerance=2e-3)
    for dim in (2, 3):
        name, entries = stiff_blocks(dim, "plane", 1)
        holds(f"{dim}-D, fixed point", dim, name,
              {**entries, "Solution/Friction": "fixed point"}, steps=100)
        del entries["Contact/Friction coefficient"]
        holds(f"{dim}-D, Tresca", dim, name, {**entries, "Contact/Tresca limit": 2},
              bound=2 * AREA)


def drag(dim, name, more, ranks=1):
    """A block dragged across another; part of it slips."""
    if dim == 2:
        mesh = Mesh()
        mesh.block("Up", 12, 6, box(2, 0, 14, 6), {"bottom": "Sole", "top": "Head"})
        mesh.block("Low", 14, 5, box(0, -5, 16, 0),
                   {"bottom": "Base", "top": "Ground"})
        sole, head, ground, base = "Sole", "Head", "Ground", "Base"
    else:
        mesh = Volumes()
        mesh.block("Up", (6, 5, 3),
                   lambda r, s, t: (2 + 6 * r, 2 + 5 * s, 3. * t))
        mesh.block("Low", (7, 6, 3), lambda r, s, t: (10 * r, 9 * s, 3 * t - 3.))
        sole, head, ground, base = "Up_z0", "Up_z1", "Low_z1", "Low_z0"
    mesh.write(name)
    down, ways = "xyz"[dim - 1], ((0.055,) if dim == 2 else (0.03, 0.02))
    entries = {
        "Mesh/File": f"{name}.msh",
        "Solids/Young's modulus": "Up: 2000, Low: 1000",
        "Solids/Poisson's ratio": "Up: 0.3, Low: 0.3",
        f"Boundary conditions/Displacement {down}": f"{head}: -0.05, {base}: 0",
        "Boundary conditions/Histories": "; ".join(
            [f"Displacement {down}: min(1, 2*t)"] +
            [f"Displacement {c}: max(0, 2*t - 1)" for c in "xyz"[:dim - 1]]),
        "Contact/Slave": sole, "Contact/Master": ground,
        "Contact/Friction coefficient": 0.3,
        "Solution/Increments": 4, "Solution/Newton tolerance": 1e-11,
        "Solution/Geometry tolerance": 1e-11, "Output/Profile": "true",
        "Probes/Probes": "; ".join(
            f"R{c}: reaction {c}, {head}" for c in "xyz"[:dim]), **more}
    for c, way in zip("xyz"[:dim - 1], ways):
        entries[f"Boundary conditions/Displacement {c}"] = f"{head}: {way}, {base}: 0"
    status, said, summary = run(name, entries, ranks)
    violated = violations(summary)
    check(f"  {dim}-D dragged, {more}, {ranks} processes: converges",
          status == 0 and not violated, said[-400:] if status else violated)
    return numpy.array(list(probes(summary).values())) if status == 0 else \
        numpy.full(dim, math.nan)


def off(a, b):
    return float(numpy.abs(a - b).max() / numpy.abs(b).max())


def systems():
    for dim in (2, 3):
        first = drag(dim, "drag", {"Contact/Elastic slip": 0.002})
        status = [r["status_0_open_1_slip_2_stick"] for r in rows("drag")
                  if r["surface"] == "slave"]
        check("part of it sticks, part slips", {1, 2} <= set(status), status)
        solvers = ("CHOLMOD", "AMG", "GMG") + (("UMFPACK",) if dim == 2 else ())
        for solver in solvers:
            other = drag(dim, "drag", {"Contact/Elastic slip": 0.002,
                                       "Solution/Linear tolerance": 1e-6,
                                       "Solution/Linear solver": solver})
            check(f"{dim}-D, {solver}: the same forces", off(other, first) < 1e-8,
                  off(other, first))
        for solver in ("AMG", "GMG"):
            other = drag(dim, "drag", {"Contact/Elastic slip": 0.002,
                                       "Solution/Linear solver": solver}, ranks=2)
            check(f"{dim}-D, {solver}, two processes: the same forces",
                  off(other, first) < 1e-8, off(other, first))
        # The edges are 1 mm long.
        share = drag(dim, "drag", {"Contact/Elastic slip": "0.2 %"})
        check(f"{dim}-D: a share of the edge is a length", off(share, first) < 1e-12)


def limit():
    for dim in (2, 3):
        exact = drag(dim, "drag", {})
        errors = [off(drag(dim, "drag", {"Contact/Elastic slip": e}), exact)
                  for e in (4e-5, 2e-5, 1e-5)]
        check(f"{dim}-D: exact sticking is the limit, of order one",
              1.9 < errors[0] / errors[1] < 2.1 and 1.9 < errors[1] / errors[2] < 2.1
              and errors[2] < 1e-2, errors)


def effect():
    elastic = {"Contact/Elastic slip": 0.01, "Solution/Increments": 1,
               "Boundary conditions/Histories": ""}
    with_it = drag(2, "drag", elastic)
    true = drag(2, "stuck", {**elastic, "Contact/Elastic slip": ""}) - with_it
    _, said, summary = solve(pathlib.Path("drag.prm"), "Solution/Estimate effects=true")
    found = [e for e in summary["estimated_effects"]
             if e["effect"] == "Contact/elastic slip"]
    check("the effect of elastic slip is estimated", len(found) == 1 and all(
        abs(change - value) <= abs(doubt) + 1e-6 * abs(value) for change, doubt, value
        in zip(found[0]["changes"].values(), found[0]["uncertainties"].values(), true)),
          (found, true, said))


def refused():
    name, entries = stiff_blocks(2, "block", 1)
    for value, more, text in (
            ("-1", {}, "no length above 0"), ("0", {}, "no length above 0"),
            ("0.1 mm", {}, "no length above 0"), ("soft", {}, "no length above 0"),
            ("0.1", {"Contact/Friction coefficient": 0}, "no friction"),
            ("0.1", {"Contact/Tied": "true"}, "no friction")):
        status, said, _ = run(name, {**entries, "Contact/Elastic slip": value, **more})
        check(f"'{value}' {more} is refused", status == 2 and text in said and
              "Elastic slip" in said and "remedy" in said, said)


law()
systems()
limit()
effect()
refused()
sys.exit(bool(failures))
