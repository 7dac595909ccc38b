#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Friction in 3-D: paths that turn, scenes that are turned, balance.

Proves that

- a node that is dragged over a plane in directions that turn, by a cell whose
  stiffness couples all directions, ends each increment where Coulomb's law and
  that stiffness put it, whichever loop of friction is taken, to 1e-10; and that
  with more increments it comes to where the rates of slip lead, with order 1;
- a punch of square section that is pressed on a block and dragged across it, with
  large displacements, does the same when the scene is turned by 30 degrees about
  all axes, to 1e-9: nodal and mortar discretization, degree 1 and 2;
- the plate of SSNV128 (lift-off, slip and stick on a rigid plane) has in 3-D the
  displacements of the plane scene to 1e-10;
- a block that slides far over the facets of a finer one has the same reactions by
  CHOLMOD, AMG and GMG, to 1e-8: the couplings of the matrix have room for what the
  pairing changes with;
- a block that comes from afar into the corner of three walls, where the shears of
  its nodes differ by any power of ten, ends there, pressed against all of them;
- forces and moments of contact between round surfaces that slide far balance to
  1e-10, by the invariants of each increment and by nodes.csv, where the forces
  on the upper body are also what its support exerts.

Usage: space_friction.py CONTACT PARAMETERS MESHES
"""

import itertools
import math
import pathlib
import sys

import numpy

from block_scenes import check, failures, rows, run, solve
from space_scenes import AXES, converged, probes, rotation
from volume_scenes import Volumes

MODULUS, RATIO, FRICTION = 1000., 0.1, 0.4
PATH = ("0.1*t*(1-cos(2*pi*t))", "0.2*t*sin(3*t)",
        "-0.05*(min(1,10*t)+0.3*t*sin(6*t))")


def motion(t):
    """PATH, of all nodes but one."""
    return numpy.array([0.1 * t * (1 - math.cos(2 * math.pi * t)),
                        0.2 * t * math.sin(3 * t),
                        -0.05 * (min(1, 10 * t) + 0.3 * t * math.sin(6 * t))])


def cell_chart(r, s, t):
    """A unit cube whose node at the origin is lower by 0.1."""
    return float(r), float(s), t - 0.1 * (1 - r) * (1 - s) * (1 - t)


def stiffness():
    """Of that node, all others at rest: 3 x 3 [N/mm]."""
    lame = MODULUS * RATIO / (1 + RATIO) / (1 - 2 * RATIO)
    shear = MODULUS / 2 / (1 + RATIO)
    corners = numpy.array([(i, j, k) for k, j, i in
                           itertools.product((0, 1), repeat=3)])
    places = numpy.array([cell_chart(*corner) for corner in corners])
    K = numpy.zeros((3, 3))
    for xi in itertools.product((0.5 - 12**-0.5, 0.5 + 12**-0.5), repeat=3):
        factors = numpy.where(corners == 1, xi, 1 - numpy.array(xi))
        slopes = 2. * corners - 1
        gradients = numpy.stack([
            slopes[:, d] * numpy.delete(factors, d, 1).prod(axis=1)
            for d in range(3)], axis=1)
        jacobian = gradients.T @ places
        g = numpy.linalg.solve(jacobian, gradients[0])
        K += numpy.linalg.det(jacobian) / 8 * (
            (lame + shear) * numpy.outer(g, g) +
            shear * (g @ g) * numpy.eye(3))
    return K


def point_by_increments(n):
    """Slip and force of the node after each of n increments: it stays where it
    is or slips along the force on it, |F_t| = mu N."""
    K, slip, history = stiffness(), numpy.zeros(2), []
    for i in range(1, n + 1):
        d = motion(i / n)

        def force(way):
            return K @ (d - numpy.array([*(slip + way), 0.]))

        def along(x):
            return x[0] * numpy.array([math.cos(x[1]), math.sin(x[1])])

        def residual(x):
            F = force(along(x))
            return F[:2] + FRICTION * F[2] * along((1, x[1]))
        F = force(numpy.zeros(2))
        excess = math.hypot(*F[:2]) + FRICTION * F[2]
        if excess > 0:
            x, h = numpy.array([excess / K[0, 0], math.atan2(F[1], F[0])]), 1e-7
            for _ in range(20):
                J = numpy.array([(residual(x + e) - residual(x - e)) / (2 * h)
                                 for e in h * numpy.eye(2)]).T
                x = x - numpy.linalg.solve(J, residual(x))
            assert x[0] > 0
            F = force(along(x))
            slip = slip + along(x)
        history.append((*slip, *F))
    return history


def point_by_rates(n):
    """The slip at the end: while |F_t| = mu N, s' = gamma e along F_t, such that
    this remains so; by Runge and Kutta's method in n steps."""
    K, slip, h = stiffness(), numpy.zeros(2), 1 / n

    def rate(t, slip):
        F = K @ (motion(t) - numpy.array([*slip, 0.]))
        size = math.hypot(*F[:2])
        if size == 0 or size < -FRICTION * F[2] * (1 - 1e-12):
            return numpy.zeros(2)
        e = F[:2] / size
        dF = K @ (motion(t + 1e-6) - motion(t - 1e-6)) / 2e-6
        return e * max(0., (e @ dF[:2] + FRICTION * dF[2]) /
                       (e @ K[:2, :2] @ e + FRICTION * K[2, :2] @ e))
    for i in range(n):
        a = rate(i * h, slip)
        b = rate((i + 0.5) * h, slip + h / 2 * a)
        c = rate((i + 0.5) * h, slip + h / 2 * b)
        d = rate((i + 1) * h, slip + h * c)
        slip = slip + h / 6 * (a + 2 * b + 2 * c + d)
    return slip


def turning_path():
    mesh = Volumes()
    mesh.block("Cell", (1, 1, 1), cell_chart)
    mesh.write("cell")
    held = ["Cell_{}{}{}".format(*c)
            for c in itertools.product((0, 1), repeat=3)][1:]
    base = {
        "Mesh/File": "cell.msh", "Element/Degree": 1,
        "Solids/Young's modulus": f"Cell: {MODULUS}",
        "Solids/Poisson's ratio": f"Cell: {RATIO}",
        "Solids/Kinematics": "small strain",
        **{f"Boundary conditions/Displacement {c}":
           ", ".join(f"{node}: 1" for node in held) for c in AXES},
        "Boundary conditions/Histories": "; ".join(
            f"Displacement {c}: {f}" for c, f in zip(AXES, PATH)),
        "Contact/Slave": "Cell_z0", "Contact/Discretization": "nodal",
        "Contact/Obstacle": "half space: 0, 0, -0.1, 0, 0, 1",
        "Contact/Friction coefficient": FRICTION,
        "Solution/Geometry": "undeformed", "Solution/Newton tolerance": 1e-12,
        "Solution/Friction tolerance": 1e-12,
        "Probes/Probes": "x: displacement x, Cell_000; "
                         "y: displacement y, Cell_000; " + "; ".join(
                             f"F{c}: contact force {c}, Cell_z0" for c in AXES)}
    limit, errors = point_by_rates(8000), []
    for loop, n in (("Newton", 20), ("Newton", 40), ("Newton", 80),
                    ("fixed point", 20)):
        status, said, summary = run("cell", {
            **base, "Solution/Friction": loop, "Solution/Increments": n})
        what = f"path that turns, {loop}, {n} increments"
        if not converged(what, status, summary, said):
            continue
        worst, stuck = 0, 0
        for increment, exact in zip(summary["increments"],
                                    point_by_increments(n)):
            of = increment["probes"]
            stuck += increment["stick"]
            worst = max(worst, abs(of["x"] - exact[0]), abs(of["y"] - exact[1]),
                        *(abs(of[f"F{c}"] / exact[4] + exact[2 + i] / exact[4])
                          for i, c in enumerate(AXES)))
        check(f"{what}: slips and forces of all increments",
              0 < stuck < n and worst < 1e-10, (worst, stuck))
        if loop == "Newton":
            errors.append(math.hypot(of["x"] - limit[0], of["y"] - limit[1]))
    orders = [math.log2(a / b) for a, b in zip(errors, errors[1:])]
    check("path that turns: order in the increments",
          all(abs(order - 1) < 0.05 for order in orders), (errors, orders))


def punch(angles, rule, degree):
    """What came out, in the axes before the scene was turned."""
    mesh = Volumes()
    mesh.block("Block", (5, 5, 2), lambda r, s, t: (6 * r - 3, 6 * s - 3,
                                                    2 * t - 2))
    mesh.block("Punch", (3, 3, 1), lambda r, s, t: (2 * r - 1.1, 2 * s - 0.9,
                                                    float(t)))
    mesh.write("punch")
    turn = rotation(angles)
    grip = turn @ [0.04, 0.015, -0.08]
    entries = {
        "Mesh/File": "punch.msh", "Mesh/Rotation": "{}, {}, {}".format(*angles),
        "Element/Degree": degree,
        "Solids/Young's modulus": "Block: 1000, Punch: 3000",
        "Solids/Poisson's ratio": "Block: 0.3, Punch: 0.2",
        "Solids/Kinematics": "large displacement",
        **{f"Boundary conditions/Displacement {c}":
           f"Block_z0: 0, Punch_z1: {float(grip[i])!r}"
           for i, c in enumerate(AXES)},
        "Contact/Slave": "Punch_z0", "Contact/Master": "Block_z1",
        "Contact/Discretization": rule, "Contact/Friction coefficient": 0.3,
        "Solution/Increments": 2, "Solution/Newton tolerance": 1e-12,
        "Solution/Geometry tolerance": 1e-11, "Output/Profile": "true",
        "Probes/Probes": "; ".join(
            f"R{c}: reaction {c}, Punch_z1; u{c}: displacement {c}, Punch_000"
            for c in AXES) + "; Mises: von Mises, Punch_000"}
    status, said, summary = run("punch", entries)
    if not converged(f"square punch, {rule}, degree {degree}, turned by "
                     f"{angles[0]}", status, summary, said):
        return {}
    values = probes(summary)

    def back(vector):
        return turn.T @ vector
    slave = [row for row in rows("punch") if row["surface"] == "slave"]
    return {
        "reaction": back([values[f"R{c}"] for c in AXES]),
        "displacement": back([values[f"u{c}"] for c in AXES]),
        "Mises": values["Mises"],
        "pressure": [row["pressure_MPa"] for row in slave],
        "shear": [back([row[f"shear_{c}_MPa"] for c in AXES]) for row in slave],
        "status": [row["status_0_open_1_slip_2_stick"] for row in slave]}


def turned_punch():
    for rule, degree in itertools.product(("nodal", "mortar"), (1, 2)):
        straight = punch((0, 0, 0), rule, degree)
        turned = punch((30, 30, 30), rule, degree)
        worst = {what: float(abs(numpy.subtract(turned[what], value)).max() /
                             abs(numpy.asarray(value)).max())
                 for what, value in straight.items()} if turned else {}
        check(f"square punch, {rule}, degree {degree}: turned about all axes",
              worst and max(worst.values()) < 1e-9, worst)
        check("  part of it sticks, part slips",
              {1, 2} <= set(straight["status"]), set(straight["status"]))


def round_surfaces(rule, degree, slave, way):
    """Two convex surfaces, pressed, then dragged over each other."""
    mesh = Volumes()

    def low(r, s, t):
        x, y = 6 * r - 3, 6 * s - 3
        return x, y, -2 + t * (2 - 0.05 * x * x - 0.03 * y * y)

    def up(r, s, t):
        x, y = 3 * r - 1.4, 2.6 * s - 1.1
        bottom = 0.12 * x * x + 0.2 * y * y
        return x, y, bottom + t * (2 - bottom)
    mesh.block("Low", (5, 6, 1), low)
    mesh.block("Up", (4, 4, 1), up)
    mesh.write("round")
    entries = {
        "Mesh/File": "round.msh", "Element/Degree": degree,
        "Solids/Young's modulus": "Low: 1000, Up: 2000",
        "Solids/Poisson's ratio": "Low: 0.3, Up: 0.2",
        "Solids/Kinematics": "large displacement",
        "Boundary conditions/Displacement x": f"Low_z0: 0, Up_z1: {way[0]}",
        "Boundary conditions/Displacement y": f"Low_z0: 0, Up_z1: {way[1]}",
        "Boundary conditions/Displacement z": f"Low_z0: 0, Up_z1: {way[2]}",
        "Boundary conditions/Histories":
            "Displacement x: max(0, 2*t-1); Displacement y: max(0, 2*t-1); "
            "Displacement z: min(1, 2*t)",
        "Contact/Slave": "Up_z0" if slave == "Up" else "Low_z1",
        "Contact/Master": "Low_z1" if slave == "Up" else "Up_z0",
        "Contact/Discretization": rule, "Contact/Friction coefficient": 0.3,
        "Solution/Increments": 4, "Solution/Geometry tolerance": 1e-8,
        "Solution/Newton tolerance": 1e-11, "Output/Nodes": "true",
        "Probes/Probes": "; ".join(f"{c}: reaction {c}, Up_z1" for c in AXES)}
    status, said, summary = run("round", entries)
    what = f"round surfaces, {rule}, degree {degree}, slave {slave}"
    if not converged(what, status, summary, said):
        return
    for name in ("force_imbalance", "moment_imbalance"):
        worst = max(i["invariants"][name] for i in summary["increments"]
                    if i["converged"])
        check(f"{what}: {name}", worst < 1e-10, worst)

    nodes = rows("round", "nodes.csv")
    force = numpy.array([[row[f"contact_force_{c}_N"] for c in AXES]
                         for row in nodes])
    place = numpy.array([[row[f"{c.upper()}_mm"] + row[f"displacement_{c}_mm"]
                          for c in AXES] for row in nodes])
    upper = [row["body"] == "Up" for row in nodes]
    size = 6.
    magnitude = numpy.linalg.norm(force, axis=1).sum()
    support = [probes(summary)[c] for c in AXES]
    worst = {"force": numpy.linalg.norm(force.sum(axis=0)) / magnitude,
             "moment": numpy.linalg.norm(numpy.cross(place, force).sum(axis=0)) /
                       magnitude / size,
             "support": numpy.linalg.norm(force[upper].sum(axis=0) + support) /
                        magnitude}
    check(f"{what}: nodes.csv", max(worst.values()) < 1e-10, worst)
    check("  there is friction", math.hypot(*support[:2]) > 0.05 * magnitude / 2,
          support)


def held_side():
    """A support holds a side of the upper block, down to the surface of contact,
    and the lower one reaches beyond it on a coarser mesh."""
    mesh = Volumes()
    mesh.block("Low", (8, 8, 4), lambda r, s, t: (8 * r - 2, 8 * s - 1,
                                                  6 * t - 6))
    mesh.block("Up", (9, 9, 5), lambda r, s, t: (6 * r, 6 * s, 5 * t))
    mesh.write("held")
    entries = {
        "Mesh/File": "held.msh", "Element/Degree": 1,
        "Solids/Young's modulus": "Low: 70000, Up: 210000",
        "Solids/Poisson's ratio": "Low: 0.3, Up: 0.3",
        "Boundary conditions/Displacement x": "Low_z0: 0, Up_z1: 0.03",
        "Boundary conditions/Displacement y": "Low_z0: 0.2, Up_y0: 0",
        "Boundary conditions/Displacement z": "Low_z0: 0, Up_z1: -0.05",
        "Boundary conditions/Histories":
            "Displacement z: min(1, 4*t); Displacement x: min(1, max(0, 4*t-1));"
            " Displacement y: max(0, 2*t-1)",
        "Contact/Slave": "Up_z0", "Contact/Master": "Low_z1",
        "Contact/Friction coefficient": 0.3, "Solution/Increments": 4,
        "Solution/Newton tolerance": 1e-10,
        "Output/Profile": "true", "Probes/Probes": "; ".join(
            f"{c}: reaction {c}, Low_z0" for c in AXES)}
    status, said, summary = run("held", entries)
    if not converged("a side that is held", status, summary, said):
        return
    steps = [i["newton_iterations"] for i in summary["increments"]]
    check("  at most 8 Newton steps an increment", max(steps) <= 8, steps)
    force = [probes(summary)[c] for c in AXES]
    check("  all of the edge slips, too",
          0.29 < math.hypot(*force[:2]) / force[2] < 0.3, force)
    status, said, summary = run("held", entries, 2)
    if converged("the same on two processes", status, summary, said):
        others = [probes(summary)[c] for c in AXES]
        check("  the same force", max(abs(a - b) for a, b in zip(force, others))
              < 1e-8 * max(map(abs, force)), others)
    status, said, summary = run("held", {**entries, "Boundary conditions/"
                                         "Displacement y": "Low_z0: 0, Up_y0: 0"})
    edge = [row for row in rows("held") if row["surface"] == "slave" and
            abs(row["Y_mm"]) < 1e-9]
    shears = [row["shear_y_MPa"] for row in sorted(edge, key=lambda row: row["X_mm"])]
    turns = sum(a * b < 0 for a, b in zip(shears, shears[1:]))
    check("  shears along the edge do not alternate", turns <= 2, shears)


def plate():
    cases = pathlib.Path(sys.argv[2]).resolve() / "verification"
    scenes = [solve(cases / name) for name in (
        "3d/plate_on_plane.prm", "block_on_plane.prm")]
    for status, said, summary in scenes:
        converged("plate of SSNV128", status, summary, said)
    space, plane = (probes(summary) for _, _, summary in scenes)
    worst = max(abs(space[name] / plane[name] - 1) for name in plane)
    check("  in 3-D as in 2-D", worst < 1e-10, worst)


def slide():
    """Over several facets of a master that is finer, by solvers of each kind."""
    mesh = Volumes()
    mesh.block("Low", (5, 5, 2), lambda r, s, t: (
        12 * r - 6, 12 * s - 6, 4 * t - 4 + 0.16 * t * (r * (1 - r) +
                                                        s * (1 - s))))
    mesh.block("Up", (3, 3, 2), lambda r, s, t: (
        4 * r - 2.2, 4 * s - 1.8, 4 * t + 0.08 - 0.04 * (1 - t) *
        (r * (1 - r) + s * (1 - s))))
    mesh.write("slide")
    entries = {
        "Mesh/File": "slide.msh", "Mesh/Refinements": 1, "Element/Degree": 1,
        "Solids/Young's modulus": "Low: 70000, Up: 20000",
        "Solids/Poisson's ratio": "Low: 0.3, Up: 0.4",
        "Solids/Kinematics": "large displacement",
        "Boundary conditions/Displacement x": "Low_z0: 0, Up_z1: 0.8",
        "Boundary conditions/Displacement y": "Low_z0: 0, Up_z1: 0.6",
        "Boundary conditions/Displacement z": "Low_z0: 0, Up_z1: -0.2",
        "Boundary conditions/Histories":
            "Displacement z: table(0 0, 0.25 1, 1 1); "
            "Displacement x: table(0 0, 0.25 0, 1 1); "
            "Displacement y: table(0 0, 0.25 0, 1 1)",
        "Contact/Slave": "Up_z0", "Contact/Master": "Low_z1",
        "Contact/Friction coefficient": 0.4,
        "Solution/Increments": 4, "Solution/Newton tolerance": 1e-11,
        "Probes/Probes": "; ".join(f"R{c}: reaction {c}, Up_z1" for c in AXES)}
    found = {}
    for solver in ("CHOLMOD", "AMG", "GMG"):
        status, said, summary = run("slide", {**entries,
                                              "Solution/Linear solver": solver})
        if converged(f"slide over facets, {solver}", status, summary, said):
            found[solver] = probes(summary)
    first = next(iter(found.values()), {})
    worst = max((abs(values[name] / first[name] - 1)
                 for values in found.values() for name in values), default=1)
    check("  the same reactions by all solvers", worst < 1e-8, worst)


def corner_of_walls():
    """By 20 mm along x, first, then y and z; 0.05 mm into two walls and 0.04 mm
    into the floor."""
    mesh = Volumes()
    mesh.block("B", (3, 3, 3), lambda r, s, t: (2 * r - 1, 2 * s - 1, 2 * t),
               sides={**dict.fromkeys(("x0", "x1", "y0", "y1", "z0"), "skin"),
                      "z1": "z1"})
    mesh.write("walls")
    walls = {"F": "0, 0, 0, 0, 0, 1", "W": "-1, 0, 0, 1, 0, 0",
             "V": "0, 1, 0, 0, -1, 0"}
    entries = {
        "Mesh/File": "walls.msh", "Mesh/Move": "B: 20, -15, 10",
        "Element/Degree": 2,
        "Solids/Young's modulus": "B: 1000", "Solids/Poisson's ratio": "B: 0.3",
        "Boundary conditions/Displacement x": "B_z1: 1",
        "Boundary conditions/Displacement y": "B_z1: 1",
        "Boundary conditions/Displacement z": "B_z1: 1",
        "Boundary conditions/Histories":
            "Displacement x: table(0 0, 0.5 -20, 0.75 -20.05, 1 -20.05); "
            "Displacement y: table(0 0, 0.5 15, 0.75 15, 1 15.05); "
            "Displacement z: table(0 0, 0.5 -10, 0.75 -10.04, 1 -10.04)",
        "Solution/Increments": 8,
        "Probes/Probes": "; ".join(f"{w}: obstacle force {c}, Contact {w}"
                                   for w, c in zip("WVF", "xyz"))}
    for name, plane in walls.items():
        entries.update({f"Contact {name}/Slave": "B_skin",
                        f"Contact {name}/Obstacle": f"half space: {plane}",
                        f"Contact {name}/Friction coefficient": 0.2})
    status, said, summary = run("walls", entries)
    if converged("corner of three walls", status, summary, said):
        forces = probes(summary)
        check("  pressed against all walls",
              forces["W"] > 0 > forces["V"] and forces["F"] > 0, forces)


turning_path()
plate()
slide()
corner_of_walls()
turned_punch()
held_side()
DEEP, SHALLOW = (0.7, 0.4, -0.5), (0.5, 0.3, -0.15)
for settings in (("mortar", 1, "Up", DEEP), ("mortar", 2, "Up", DEEP),
                 ("nodal", 1, "Up", SHALLOW), ("nodal", 2, "Up", DEEP)):
    # In the dent of facets of degree 1 a node may be nearest to two in turn.
    round_surfaces(*settings)
sys.exit(bool(failures))
