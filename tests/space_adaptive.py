#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Adaptive refinement in 3-D: a quarter of a round block that is pressed on a
flat one, with friction.

Proves that at default settings, with elements of degree 1 and 2 and with the mortar
and the nodal discretization,

- the runs converge and violate no invariant, with hanging nodes on the surface of
  the slave in contact;
- the force approaches that of as many uniform levels, on far fewer unknowns;
- two processes have the results of one to 1e-8;
- a scene that has two planes of symmetry is refined alike on both sides of them, and
  alike on one, two and three processes, which indicators cut apart by round-off
  would not be;
- supports that hold hanging nodes do not keep Newton's method from its end;
- a facet of which the master covers no more than the corner at a hanging node, whose
  heirs have the same test function there, does not stop the run.

The patch test with hanging nodes on both surfaces is tests/space_hanging.cc.

Usage: space_adaptive.py CONTACT PARAMETERS MESHES
"""

import sys

from block_scenes import check, failures, rows, run
from space_scenes import converged, probes
from volume_scenes import Volumes


def solve(what, degree, rule, levels, strategy, ranks=1):
    entries = {
        "Mesh/File": "round.msh", "Element/Degree": degree,
        "Solids/Young's modulus": "Low: 1000, Up: 3000",
        "Solids/Poisson's ratio": "Low: 0.3, Up: 0.2",
        "Boundary conditions/Displacement x": "Low_x0: 0, Up_x0: 0",
        "Boundary conditions/Displacement y": "Low_y0: 0, Up_y0: 0",
        "Boundary conditions/Displacement z": "Low_z0: 0, Up_z1: -0.05",
        "Contact/Slave": "Up_z0", "Contact/Master": "Low_z1",
        "Contact/Discretization": rule, "Contact/Friction coefficient": 0.2,
        "Solution/Newton tolerance": 1e-12,
        "Refinement/Levels": levels, "Refinement/Strategy": strategy,
        "Output/Profile": "true",
        "Probes/Probes": "F: reaction z, Low_z0; u: displacement x, Low_101"}
    status, said, summary = run("round", entries, ranks)
    if not converged(what, status, summary, said):
        return None
    return summary


def cells_of_block(ranks):
    """Of each level of a block that is pressed on the middle of another one."""
    both = "Low_z0: 0, Up_z1: "
    status, said, summary = run("middle", {
        "Mesh/File": "middle.msh", "Element/Degree": 2,
        "Solids/Young's modulus": "Low: 1000, Up: 3000",
        "Solids/Poisson's ratio": "Low: 0.3, Up: 0.2",
        "Boundary conditions/Displacement x": both + "0",
        "Boundary conditions/Displacement y": both + "0",
        "Boundary conditions/Displacement z": both + "-0.05",
        "Contact/Slave": "Up_z0", "Contact/Master": "Low_z1",
        "Contact/Friction coefficient": 0.3,
        "Refinement/Levels": 2, "Refinement/Strategy": "adaptive"}, ranks)
    converged(f"symmetric, {ranks} processes", status, summary, said)
    return [level["cells"] for level in summary.get("levels", [])]


def drag_block():
    """With supports on hanging nodes, whose displacements have the round-off of
    those that they follow."""
    status, said, summary = run("middle", {
        "Mesh/File": "middle.msh", "Element/Degree": 2,
        "Solids/Young's modulus": "Low: 1000, Up: 1000",
        "Solids/Poisson's ratio": "Low: 0.3, Up: 0.3",
        "Boundary conditions/Displacement x": "Low_z0: 0, Up_z1: 0.1",
        "Boundary conditions/Displacement y": "Low_z0: 0, Up_z1: 0.05",
        "Boundary conditions/Displacement z": "Low_z0: 0, Up_z1: -0.1",
        "Boundary conditions/Histories":
            "Displacement z: min(1, 2*t); Displacement x: max(0, 2*t - 1); "
            "Displacement y: max(0, 2*t - 1)",
        "Contact/Slave": "Up_z0", "Contact/Master": "Low_z1",
        "Contact/Friction coefficient": 0.3, "Solution/Increments": 2,
        "Refinement/Levels": 1, "Refinement/Strategy": "adaptive"}, 1)
    converged("dragged by hanging nodes", status, summary, said)
    steps = [i["newton_iterations"] for i in summary.get("increments", [])]
    check("dragged by hanging nodes: at most 8 steps",
          steps and max(steps) <= 8, steps)


def press_single_cells():
    """A small block on a slave of one cell, refined where it touches."""
    status, said, summary = run("single", {
        "Mesh/File": "single.msh", "Element/Degree": 1,
        "Solids/Young's modulus": "Low: 70000, Up: 210000",
        "Solids/Poisson's ratio": "Low: 0.3, Up: 0.3",
        "Boundary conditions/Displacement x": "Low_z0: 0, Up_z1: 0.01",
        "Boundary conditions/Displacement y": "Low_z0: 0, Up_z1: 0.005",
        "Boundary conditions/Displacement z": "Low_z0: 0, Up_z1: -0.01",
        "Contact/Slave": "Low_z1", "Contact/Master": "Up_z0",
        "Solution/Increments": 3,
        "Refinement/Levels": 2, "Refinement/Strategy": "adaptive"}, 1)
    converged("corner at a hanging node", status, summary, said)
    steps = [i["newton_iterations"] for i in summary.get("increments", [])]
    check("corner at a hanging node: no increment of three levels is cut",
          len(steps) == 9, steps)


def unknowns(summary):
    return summary["levels"][-1]["displacements"]


mesh = Volumes()
mesh.block("Low", (4, 4, 3), lambda r, s, t: (1.6 * r, 1.6 * s, t - 1))
mesh.block("Up", (3, 3, 3), lambda r, s, t: (
    1.1 * r, s, t + (1 - t) * (0.1 * (1.1 * r) ** 2 + 0.15 * s ** 2)))
mesh.write("round")
for degree, rule in ((1, "mortar"), (2, "mortar"), (1, "nodal")):
    name = f"degree {degree}, {rule}"
    n = 2 if degree == 1 else 1
    n_adaptive = 4 if degree == 1 else 2
    coarse = solve(f"{name}, coarse", degree, rule, 0, "uniform")
    uniform = solve(f"{name}, uniform", degree, rule, n, "uniform")
    adaptive = solve(f"{name}, adaptive", degree, rule, n_adaptive,
                     "adaptive")
    if not (coarse and uniform and adaptive):
        continue
    hanging = [r for r in rows("round") if r["surface"] == "slave" and
               r["pressure_MPa"] > 0 and r["nodal_force_N"] == 0]
    check(f"{name}: hanging nodes in contact", hanging, len(hanging))
    two = solve(f"{name}, two processes", degree, rule, n_adaptive,
                     "adaptive", 2)
    F = [probes(s)["F"] for s in (coarse, uniform, adaptive)]
    check(f"{name}: approaches the uniform mesh",
          abs(F[2] - F[1]) < 0.5 * abs(F[0] - F[1]), F)
    sizes = [unknowns(s) for s in (coarse, uniform, adaptive)]
    check(f"{name}: fewer unknowns", sizes[2] < 0.7 * sizes[1], sizes)
    if two:
        a, b = probes(adaptive), probes(two)
        worst = max(abs(b[k] / a[k] - 1) for k in a)
        check(f"{name}: the same on two processes", worst < 1e-8, worst)
mesh = Volumes()
mesh.block("Low", (4, 4, 1), lambda r, s, t: (2 * r - 1, 2 * s - 1, t - 1))
mesh.block("Up", (2, 2, 2), lambda r, s, t: (r - 0.5, s - 0.5, t))
mesh.write("middle")
mesh = Volumes()
mesh.block("Low", (1, 1, 1), lambda r, s, t: (r, s, t - 1))
mesh.block("Up", (1, 1, 1), lambda r, s, t: (0.2 + 0.7 * r, 0.1 + 0.7 * s, t))
mesh.write("single")
press_single_cells()
cells = [cells_of_block(ranks) for ranks in (1, 2, 3)]
drag_block()
check("symmetric: the same cells on any number of processes",
      cells[0] and cells[0] == cells[1] == cells[2], cells)
# A mirrored set of cells is one of fours; each refined cell makes seven more.
check("symmetric: cells are refined by fours",
      all(n % 28 == 24 % 28 for n in cells[0]), cells[0])
sys.exit(bool(failures))
