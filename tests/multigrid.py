#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The matrix-free multigrid.

Proves that

- it has the probes of CHOLMOD to 1e-8, on tetrahedra and elements without centre
  nodes, with projected dilatation and incompatible modes as well: without and with
  friction, with large displacements, with hanging nodes in 2-D and at the surfaces
  of contact in 3-D, at both degrees, on one process and on several;
- its conjugate gradients take at most 12 iterations a solve, on coarse meshes and
  fine ones, and if one side is up to a thousand times as stiff as the other or
  its cells eight times as small; at most twice as many as with equal bodies, in
  2-D and in 3-D, without and with friction;
- so they do for six digits with glued surfaces, where they touch and across gaps of
  many cells, however fine the mesh is;
- each process has its part of the unknowns alone;
- springs that hold a body before it touches another one are left to AMG;
- a straight column beyond Euler's load is no result, of multigrid with and without a
  matrix, and one below it is;
- where it stalls another solver goes on in the same step;
- what it does not know is refused, with a remedy, and left to other solvers by
  default.

Usage: multigrid.py CONTACT PARAMETERS MESHES
"""

import math
import pathlib
import sys

from block_scenes import Mesh, check, failures, run, solve
from tetrahedra_scenes import Solid

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
NO_CENTRE = "Element/Centre node=serendipity"
both("8 nodes", "nested", "Refinement/Levels=2", NO_CENTRE, ranks=(1, 3))
both("8 nodes, large displacement", "nested_large", "Refinement/Levels=1", NO_CENTRE)
both("8 nodes, hanging nodes", "nested_adaptive", "Refinement/Levels=4", NO_CENTRE,
     ranks=(1, 2))
both("20 nodes", "nested_space", "Refinement/Levels=1", "Element/Degree=2", NO_CENTRE,
     ranks=(1, 2))
both("20 nodes, hanging nodes", "nested_space", "Element/Degree=2", NO_CENTRE,
     "Refinement/Levels=1", "Refinement/Strategy=adaptive", ranks=(1, 2))
both("degree 1", "nested", "Refinement/Levels=3", "Element/Degree=1",
     "Element/Centre node=serendipity")
NEARLY = "Solids/Poisson's ratio=Block: 0.48, Cylinder: 0.3"
for what, case in ("", "nested"), (", large displacement", "nested_large"):
    both(f"B-bar, degree 1{what}", case, "Refinement/Levels=1", "Element/Degree=1",
         NO_CENTRE, "Solids/Dilatation=B-bar", NEARLY)
    both(f"B-bar, degree 2{what}", case, "Refinement/Levels=1", NEARLY, most=24)
    both(f"incompatible modes{what}", case, "Refinement/Levels=2", "Element/Degree=1",
         NO_CENTRE, "Solids/Incompatible modes=Block")
for what, kinematics in ("", "small strain"), (", large displacement", "large displacement"):
    for kind, *entries in (
            ("incompatible modes", "Solids/Incompatible modes=Foundation"),
            ("incompatible modes beside B-bar", "Solids/Incompatible modes=Sphere",
             "Solids/Poisson's ratio=Foundation: 0.48, Sphere: 0.3"),
            ("B-bar, 20 nodes", "Solids/Dilatation=B-bar", "Element/Degree=2",
             NO_CENTRE)):
        both(f"space, {kind}{what}", "nested_space", "Refinement/Levels=1", *entries,
             f"Solids/Kinematics={kinematics}", ranks=(1, 2))
space = both("space", "nested_space", "Refinement/Levels=1", "Element/Degree=2",
             "Element/Centre node=free", ranks=(1, 2))
if space:
    held = [s["displacements_on_a_process"] / s["unknowns"]["displacement"]
            for s in space[1:]]
    check("a process holds its part", held[1] < 0.8 < held[0], held)
slipping = both("space, hanging nodes, friction", "nested_space_friction",
                "Refinement/Levels=2", "Refinement/Strategy=adaptive",
                ranks=(1, 2))
if slipping:
    # Of the first process: what it does not do is for the other. Facets where
    # the shares meet are integrated by both.
    for work, most in ("projections", 0.9), ("slip_stiffnesses", 0.7):
        done = [s["counters"][work] for s in slipping[1:]]
        check(f"{work}: a share for each process",
              0.3 < done[1] / max(1, done[0]) < most, done)


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


def pressed(name, mesh, stiffness, solver, levels=2, **more):
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
        "Probes/Probes": "F: reaction y, Base; u: displacement x, B"} | more)


for label, mesh, stiffness, levels in (
        [(f"master {r} times as stiff", blocks(4, 8), 1000 * r, 2)
         for r in (1, 1000, 0.001)] +
        [(f"fine {side}, slave {r} times as stiff", mesh, 1000 / r, 1)
         for side, mesh in (("master", blocks(2, 32)), ("slave", blocks(16, 4)))
         for r in (1, 1000)]):
    results = []
    for solver in "CHOLMOD", "GMG":
        status, said, summary = pressed("blocks", mesh, stiffness, solver, levels)
        check(f"{label}, {solver}: converged", status == 0, said[-800:] if status else "")
        results.append(summary)
    if all(results):
        compare(label, *results, displacement=0.05)
        check(f"{label}: few iterations", iterations(results[1]) <= 12,
              f"{iterations(results[1]):.1f}")



def tetrahedra(what, degree, **more):
    """A block with a round bottom, pressed askew on a flat one."""
    mesh = Solid()
    mesh.block("Up", (2, 2, 2), lambda r, s, t: (
        6 * r, 6 * s, (1 - t) * (r * r + s * s) + 6 * t), points=True)
    mesh.block("Low", (3, 3, 3), lambda r, s, t: (8 * r - 1, 8 * s - 1, -6 * t))
    mesh.write("tetrahedra")
    results = []
    for solver in "CHOLMOD", "GMG":
        status, said, summary = run("tetrahedra", {
            "Mesh/File": "tetrahedra.msh", "Element/Degree": degree,
            "Solids/Kinematics": "small strain",
            "Solids/Young's modulus": "Up: 3000, Low: 1000",
            "Solids/Poisson's ratio": "Up: 0.3, Low: 0.3",
            "Boundary conditions/Displacement x": "Low_z1: 0, Up_z1: 0.01",
            "Boundary conditions/Displacement y": "Low_z1: 0, Up_z1: 0",
            "Boundary conditions/Displacement z": "Low_z1: 0, Up_z1: -0.2",
            "Contact/Slave": "Up_z0", "Contact/Master": "Low_z0",
            "Refinement/Levels": 3 - degree, "Solution/Linear solver": solver,
            "Solution/Newton tolerance": 1e-12, "Solution/Increments": 1,
            "Probes/Probes": "F: reaction z, Low_z1; u: displacement z, Up_100",
            **more})
        check(f"tetrahedra, {what}, {solver}: converged", status == 0,
              said[-800:] if status else "")
        results.append(summary)
    if all(results):
        compare(f"tetrahedra, {what}", *results, displacement=0.2)
        check(f"tetrahedra, {what}: few iterations", iterations(results[1]) <= 12,
              f"{iterations(results[1]):.1f}")


tetrahedra("degree 2", 2)
tetrahedra("degree 1", 1)
tetrahedra("friction", 2, **{"Contact/Friction coefficient": 0.2})
tetrahedra("large displacement", 2,
           **{"Solids/Kinematics": "large displacement"})
tetrahedra("glue", 2, **{"Contact/Tied": "true"})


def column(part, solver, ranks=1):
    """Clamped, pressed by a part of Euler's load in plane strain; the shear makes
    that a percent less. Beside it a block that is much softer and stable."""
    thickness, length, young = 2, 20, 210000 / (1 - 0.3**2)
    euler = math.pi**2 * young * thickness**3 / 12 / (4 * length**2)
    mesh = Mesh()
    mesh.block("Col", 1, 10, lambda r, s: (thickness * r, length * s),
               {"bottom": "Base", "top": "Head"})
    mesh.block("Pad", 4, 4, lambda r, s: (10 + 20 * r, 20 * s), {"bottom": "Rest"})
    mesh.write("column")
    return run("column", {
        "Mesh/File": "column.msh", "Mesh/Refinements": 2, "Element/Degree": 2,
        "Element/Centre node": "free",
        "Solids/Young's modulus": "Col: 210000, Pad: 100",
        "Solids/Poisson's ratio": "Col: 0.3, Pad: 0.3",
        "Boundary conditions/Displacement x": "Base: 0, Rest: 0",
        "Boundary conditions/Displacement y": "Base: 0, Rest: 0",
        "Boundary conditions/Resultant force y": f"Head: {-part * euler}",
        "Solution/Increments": 1, "Solution/Max cut-backs": 0,
        "Solution/Linear solver": solver, "Output/VTU": "false"}, ranks)


for solver, ranks in (("CHOLMOD", 1), ("AMG", 1), ("GMG", 1), ("GMG", 2)):
    for part in (0.5, 0.95, 1.05, 1.2, 3) if solver == "GMG" and ranks == 1 else (
            0.95, 1.05):
        status, said, _ = column(part, solver, ranks)
        check(f"column under {part} of Euler's load, {solver}, {ranks} process(es)",
              status == 0 if part < 1 else
              status == 3 and "lost its stability" in said, f"{status} {said[-400:]}")

# Cells a thousand times as long as high, bent: points do not smooth there.
layer = Mesh()
layer.block("Layer", 16, 16, lambda r, s: (1000 * r, s),
            {"bottom": "Base", "top": "Head"})
layer.write("layer")
status, said, summary = run("layer", {
    "Mesh/File": "layer.msh", "Mesh/Refinements": 3, "Element/Degree": 2,
    "Element/Centre node": "free", "Solids/Kinematics": "small strain",
    "Solids/Young's modulus": "Layer: 1000", "Solids/Poisson's ratio": "Layer: 0.4",
    "Boundary conditions/Displacement x": "Base: 0",
    "Boundary conditions/Displacement y": "Base: 0",
    "Boundary conditions/Displacement formula y": "Head: 0.01*sin(x)",
    "Solution/Linear solver": "GMG", "Solution/Increments": 2, "Output/VTU": "false"})
log = pathlib.Path("output/layer/log.txt").read_text()
check("where it stalls another solver goes on", status == 0 and
      "geometric multigrid stalls" in log and "goes on from here" in log and
      len(summary["increments"]) == 2, f"{status} {said[-400:]}")

# One body stiffer than the other.
MODULUS = "Solids/Young's modulus="
for what, case, slave, master, *settings in (
        ("plane", "nested", "Cylinder", "Block", "Refinement/Levels=2"),
        ("plane, friction", "nested_friction", "Cylinder", "Block",
         "Refinement/Levels=1"),
        ("space", "nested_space", "Sphere", "Foundation", "Element/Degree=2",
         "Element/Centre node=free"),
        ("space, friction", "nested_space_friction", "Sphere", "Foundation",
         "Element/Degree=2", "Element/Centre node=free")):
    counts = {}
    for ratio in 1, 1000, 1e-3:
        of_slave, of_master = 70000 * max(1, ratio), 70000 * max(1, 1 / ratio)
        status, said, summary = solve(
            PARAMETERS / f"{case}.prm", "Solution/Linear solver=GMG", *settings,
            f"{MODULUS}{slave}: {of_slave}, {master}: {of_master}",
            "Output/VTU=false", "Probes/References=", "Probes/Tolerances=")
        label = f"{what}, slave {ratio:g} times as stiff"
        check(f"{label}: converged", status == 0, said[-800:] if status else "")
        if status == 0:
            counts[ratio] = iterations(summary)
            check(f"{label}: few iterations",
                  counts[ratio] <= min(12, 2 * counts[1]), f"{counts[ratio]:.1f}")

# Glue: one linear problem. Newton's tolerance is a tenth of that of its solution.
SIX_DIGITS = {"Solution/Newton tolerance": 1e-5}
for columns in (4, 8), (16, 32):
    status, said, summary = pressed(
        "glued", blocks(*columns), 1000, "GMG", **SIX_DIGITS, **{"Contact/Tied": "true"})
    label = f"glue of {columns[0]} cells"
    check(f"{label}: converged", status == 0, said[-800:] if status else "")
    check(f"{label}: few iterations", iterations(summary) <= 12,
          f"{iterations(summary):.1f}")
for case, refinements in (("nested_tied", 2), ("nested_tied", 3),
                          ("nested_space_tied", 1)):
    status, said, summary = solve(
        PARAMETERS / f"{case}.prm", "Solution/Linear solver=GMG",
        *[f"{entry}={value}" for entry, value in SIX_DIGITS.items()],
        f"Mesh/Refinements={refinements}", "Output/VTU=false")
    label = f"glue across wide gaps, {case}, refined {refinements} times"
    check(f"{label}: converged", status == 0, said[-800:] if status else "")
    check(f"{label}: few iterations", iterations(summary) <= 12,
          f"{iterations(summary):.1f}")

for what, case, *settings in (
        ("triangles", "ssnp154", "Contact/Discretization=mortar"),
        ("rings", "verification/nested_cylinders", "Contact/Discretization=mortar"),
        ("a displacement formula", "nested_space", "Element/Degree=2", NO_CENTRE,
         "Boundary conditions/Displacement z=Base: 0",
         "Boundary conditions/Displacement formula z=Head: -0.2 + 0.02*sin(x)*sin(y)"),
        ("10000 times as stiff", "nested", MODULUS + "Block: 1, Cylinder: 1e5")):
    status, said, _ = solve(PARAMETERS / f"{case}.prm",
                            "Solution/Linear solver=GMG", *settings)
    check(f"refused: {what}", status == 2 and what in said and
          "Linear solver = AMG" in said, said[-400:])

sys.exit(bool(failures))
