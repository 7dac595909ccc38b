#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The multigrid without a matrix.

Proves that

- it has the probes of CHOLMOD to 1e-8: without and with friction, with large
  displacements, with hanging nodes in the plane and at the surfaces of contact in
  space, at both degrees, on one process and on several;
- its conjugate gradients take at most 12 iterations a solve, on coarse meshes and
  fine ones, and if the master is up to a thousand times as stiff as the slave or
  its cells eight times as small;
- each process has its part of the unknowns alone;
- springs that hold a body before it touches another one are left to AMG;
- what it does not know is refused, with a remedy, and left to other solvers by
  default.

Usage: multigrid.py CONTACT PARAMETERS MESHES
"""

import pathlib
import sys

from block_scenes import Mesh, check, failures, run, solve

PARAMETERS = pathlib.Path(sys.argv[2])
EXACT = ("Solution/Newton tolerance=1e-12", "Solution/Geometry tolerance=1e-9",
         "Output/VTU=false", "Probes/References=", "Probes/Tolerances=")


def iterations(summary):
    """The mean of a solve on the finest level."""
    last = summary["levels"][-1]
    return last["linear_iterations"] / max(1, last["newton_iterations"])


def compare(what, reference, other, tolerance=1e-8, displacement=0):
    """Relative, of displacements to one that is prescribed, if given."""
    a, b = ({p["name"]: p["value"] for p in s["probes"]}
            for s in (reference, other))
    worst = max(abs(a[k] - b[k]) / max(abs(a[k]), displacement * (k[0] == "u"))
                for k in a)
    check(f"{what}: the same probes", worst < tolerance, f"to {worst:.1e}")


def both(what, case, *settings, ranks=(1,), most=12):
    """By CHOLMOD and without a matrix."""
    results = []
    for solver, n in [("CHOLMOD", 1)] + [("GMG", n) for n in ranks]:
        status, said, summary = solve(
            PARAMETERS / f"{case}.prm", f"Solution/Linear solver={solver}",
            *EXACT, *settings, ranks=n)
        check(f"{what}, {solver}, {n} process(es): converged", status == 0,
              said[-800:] if status else "")
        if status:
            return None
        results.append(summary)
    for n, summary in zip(ranks, results[1:]):
        compare(f"{what}, {n} process(es)", results[0], summary)
        mean = iterations(summary)
        check(f"{what}: few iterations", mean <= most, f"{mean:.1f}")
    return results


both("no friction", "nested", "Refinement/Levels=2", ranks=(1, 3))
both("friction", "nested_friction", "Refinement/Levels=1", ranks=(1, 2))
both("large displacement", "nested_large", "Refinement/Levels=1", ranks=(1, 2))
both("hanging nodes", "nested_adaptive", "Refinement/Levels=4")
both("degree 1", "nested", "Refinement/Levels=3", "Element/Degree=1",
     "Element/Centre node=serendipity")
space = both("space", "nested_space", "Refinement/Levels=1", "Element/Degree=2",
             "Element/Centre node=free", ranks=(1, 2))
if space:
    held = [s["displacements_on_a_process"] / s["unknowns"]["displacement"]
            for s in space[1:]]
    check("a process holds its part", held[1] < 0.8 < held[0], held)
both("space, hanging nodes, friction", "nested_space_friction",
     "Refinement/Levels=2", "Refinement/Strategy=adaptive", ranks=(1, 2))


# Blocks: the upper one is the slave, pressed down by a displacement that varies,
# so that it parts from the master beside the middle.
def blocks(columns_up, columns_low):
    mesh = Mesh()
    mesh.block("Low", columns_low, max(1, columns_low // 2),
               lambda r, s: (20 * r - 10, -10 + 10 * s),
               {"bottom": "Base", "top": "Top", "corner": "A"})
    mesh.block("Up", columns_up, max(1, columns_up // 2),
               lambda r, s: (10 * r - 5, 5 * s + (0.2 * (2 * r - 1) ** 2) * (1 - s)),
               {"bottom": "Bottom", "top": "Head", "corner": "B"})
    name = f"blocks_{columns_up}_{columns_low}"
    mesh.write(name)
    return name + ".msh"


def pressed(name, mesh, stiffness, solver, levels=2):
    return run(name, {
        "Mesh/File": mesh, "Element/Degree": 2, "Element/Centre node": "free",
        "Solids/Kinematics": "small strain",
        "Solids/Young's modulus": f"Low: {stiffness}, Up: 1000",
        "Solids/Poisson's ratio": "Low: 0.3, Up: 0.3",
        "Boundary conditions/Displacement x": "Base: 0, Head: 0",
        "Boundary conditions/Displacement y": "Base: 0, Head: -0.05",
        "Contact/Slave": "Bottom", "Contact/Master": "Top",
        "Refinement/Levels": levels, "Solution/Linear solver": solver,
        "Solution/Newton tolerance": 1e-12, "Output/VTU": "false",
        "Probes/Probes": "F: reaction y, Base; u: displacement x, B"})


for label, mesh, stiffness in (
        [(f"master {r} times as stiff", blocks(4, 8), 1000 * r)
         for r in (1, 30, 1000, 0.1)] +
        [("fine master", blocks(2, 32), 1000), ("fine slave", blocks(16, 4), 1000)]):
    results = []
    for solver in "CHOLMOD", "GMG":
        status, said, summary = pressed("blocks", mesh, stiffness, solver)
        check(f"{label}, {solver}: converged", status == 0, said[-800:] if status else "")
        results.append(summary)
    if all(results):
        compare(label, *results, displacement=0.05)
        check(f"{label}: few iterations", iterations(results[1]) <= 12,
              f"{iterations(results[1]):.1f}")

for what, case, *settings in (
        ("triangles", "ssnp154", "Contact/Discretization=mortar"),
        ("rings", "verification/nested_cylinders", "Contact/Discretization=mortar"),
        ("elements without centre node", "nested", "Element/Centre node=serendipity")):
    status, said, _ = solve(PARAMETERS / f"{case}.prm",
                            "Solution/Linear solver=GMG", *settings)
    check(f"{what} are refused", status == 2 and what in said and
          "Linear solver = AMG" in said, said[-400:])
sys.exit(bool(failures))
