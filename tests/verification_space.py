#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact of round bodies in 3-D against closed forms.

Proves that, in the cases of parameters/verification/3d,

- a sphere on a rigid plane, two equal spheres whose meshes do not match and
  crossed cylinders have Hertz' approach under the force that they have, his
  pressure, and his area of contact within one element, and that the pressure
  falls monotonically from the middle;
- the quarter of a sphere has the values of the axisymmetric program;
- spheres shifted against each other have the tangential force, the radius of
  sticking and the shears of Cattaneo and Mindlin, spheres twisted against each
  other those of Lubkin;
- hollow spheres whose meshes do not match have Lame's solution, and their
  energies converge with the order of the elements.

Approach, peak and radius have the bars of BARS where the radius of contact has
twelve elements of degree 1; errors of the approach fall with the square of the
size of the elements, so with six it has four times that.

Usage: verification_space.py CONTACT PARAMETERS MESHES [--full] [--case NAME]
                             [--write FILE]

--full takes the finer meshes as well, --case one case or several of them, --write
makes the page of the values.
"""

import argparse
import math
import pathlib
import sys

import numpy as np

import point_contact as theory
from block_scenes import check, failures, rows, solve, violations

parser = argparse.ArgumentParser()
parser.add_argument("contact")
parser.add_argument("parameters", type=pathlib.Path)
parser.add_argument("meshes")
parser.add_argument("--full", action="store_true")
parser.add_argument("--case", action="append")
parser.add_argument("--write", type=pathlib.Path)
arguments = parser.parse_args()
cases = arguments.parameters.resolve() / "verification" / "3d"

# Relative deviations; of the radius in elements; of the rise of the pressure
# and of the mean deviation of a distribution by their largest value.
BARS = {"approach": 0.005, "peak": 0.01, "radius": 1., "rise": 0.01}

STEEL = 210000., 0.3
QUADRATIC = "Element/Degree=2", "Element/Centre node=free"
page = []


def run(case, levels, *settings):
    """Name, summary and rows of the slave of a run; ends the script if it has no
    results."""
    name = f"{case}, levels {levels}" + \
        "".join(f", degree {s[-1]}" for s in settings if "Degree" in s)
    status, said, summary = solve(cases / f"{case}.prm",
                                  f"Refinement/Levels={levels}", *settings)
    violated = violations(summary)
    check(f"{name}: converges, and no invariant is violated",
          status in (0, 1) and not violated,
          violated or (said[-300:] if status > 1 else ""))
    if status > 1:
        sys.exit(1)
    slave = [r for r in rows(case) if r["surface"] == "slave"]
    return name, summary, slave


def record(case, quantity, value, exact, bar=None, error=None):
    """A row of the page; with a bar it is checked."""
    if error is None:
        error = abs(value / exact - 1)
    page.append((case, quantity, value, exact, error, bar))
    if bar is not None:
        check(f"{case}: {quantity}", error <= bar,
              f"{value:.6g}, {exact:.6g}, error {error:.3g}, bar {bar:g}")


def on_axis(slave, along, across):
    """Places and pressures on an axis of the slave, by distance."""
    return sorted((abs(r[f"{along}_mm"]), r["pressure_MPa"]) for r in slave
                  if abs(r[f"{across}_mm"]) < 1e-6)


def rise(line):
    """By how much a pressure rises along a line away from the middle, in sum."""
    return sum(max(0, b[1] - a[1]) for a, b in zip(line, line[1:]))


def normal_contact(name, slave, p0, half_axes, times):
    """Peak, end of the contact and fall of the pressure on both axes."""
    record(name, "largest pressure [MPa]", max(r["pressure_MPa"] for r in slave),
           p0, times * BARS["peak"])
    for (along, across), exact in zip(("XY", "YX"), half_axes):
        line = on_axis(slave, along, across)
        inside = [x for x, p in line if p > 0]
        after = min(x for x, p in line if x > inside[-1])
        # The contact ends between the last node with a pressure and the next.
        size = after - inside[-1]
        error = max(inside[-1] - exact, exact - after, 0) / size
        record(name, f"half axis along {along.lower()} [mm], error in elements",
               inside[-1], exact, BARS["radius"], error)
        rises = rise(line) / p0
        record(name, f"rises of p along {along.lower()}, by p0", rises, 0.,
               BARS["rise"], rises)


def over_footprint(name, slave, exact, p0, reach):
    """Mean and largest deviation of the pressures from those of theory, inside
    of an area within which 'reach' of the relative radius is less than one."""
    deviations = [r["pressure_MPa"] - exact(r["X_mm"], r["Y_mm"]) for r in slave
                  if reach(r["X_mm"], r["Y_mm"])]
    record(name, "root mean square of p - Hertz up to 0.85 of the radius, by p0",
           math.sqrt(np.mean(np.square(deviations))) / p0, 0., None,
           math.sqrt(np.mean(np.square(deviations))) / p0)


def coarser(levels, element):
    """The factor of the bars, which hold for nodes at a twelfth of the radius of
    contact; these meshes begin with a third of it."""
    return 4.**(2 - levels - (element == QUADRATIC))


def reaction(summary, group, component):
    return abs(summary["increments"][-1]["reactions"][group][component])


def limit_of_force():
    """Of the quarter of a sphere: that of the axisymmetric program, with ten
    elements of degree 2 along the radius of contact (refined once more, it
    changes by 3e-6). Half a sphere is not a half space: 7e-4 more than Hertz."""
    status, said, summary = solve(
        cases.parent / "sphere_on_plane.prm",
        f"Mesh/File={pathlib.Path(arguments.meshes).resolve()}/sphere_400.msh",
        "Mesh/Arcs=Surface: 0, 400, 400",
        "Boundary conditions/Displacement y=Top: -0.0025",
        "Probes/Probes=", "Probes/References=", "Probes/Tolerances=")
    check("axisymmetric sphere of 400 mm: converges", status == 0,
          said[-300:] if status else "")
    return reaction(summary, "Top", "y") / 4


def order_of_energy(name, summary, least):
    """Where displacements are prescribed the error of the force is that of the
    energy: it converges twice as fast as errors in the norm of the energy. By
    symmetry two spheres have the limit of one."""
    limit = limit_of_force()
    errors = [abs(abs(level["probes"]["P/4"]) - limit)
              for level in summary["levels"]]
    for before, after in zip(errors, errors[1:]):
        order = math.log2(before / after) / 2
        record(name, "order in the norm of the energy, by the force", order,
               least, None)
    if len(errors) > 1:
        check(f"{name}: order {order:.2f}", order > least - 0.15)


def hertz(case, levels, support, radius, bodies, approach, *element):
    name, summary, slave = run(case, levels, *element)
    modulus = STEEL[0] / (1 - STEEL[1]**2) / bodies
    ideal = theory.Hertz(radius, modulus, approach)
    force = 4 * reaction(summary, support, "z")
    record(name, "force [N]", force, ideal.force)
    record(name, "approach of Hertz under this force [mm]", approach,
           theory.Hertz.of_force(radius, modulus, force).approach,
           coarser(levels, element) * BARS["approach"])
    normal_contact(name, slave, ideal.p0, (ideal.a, ideal.a),
                   coarser(levels, element))
    order_of_energy(name, summary, 1.5 if element == QUADRATIC else 1.)
    over_footprint(name, slave,
                   lambda x, y: ideal.pressure(math.hypot(x, y)), ideal.p0,
                   lambda x, y: math.hypot(x, y) < 0.85 * ideal.a)
    ordered = sorted((math.hypot(r["X_mm"], r["Y_mm"]), r["pressure_MPa"])
                     for r in slave)
    lowest, most = math.inf, 0.
    for _, p in ordered:
        lowest = min(lowest, p)
        most = max(most, p - lowest)
    record(name, "largest rise of p over all nodes by radius, by p0",
           most / ideal.p0, 0., None, most / ideal.p0)


def sphere_on_plane(levels, *element):
    hertz("sphere_on_plane", levels, "Top", 400., 1, 0.0025, *element)


def two_spheres(levels, *element):
    hertz("two_spheres", levels, "Bottom", 200., 2, 0.005, *element)


def crossed_cylinders(levels, *element):
    name, summary, slave = run("crossed_cylinders", levels, *element)
    modulus = STEEL[0] / (1 - STEEL[1]**2) / 2
    ideal = theory.Ellipse(800., 400., modulus, 0.0025)
    force = 4 * reaction(summary, "Bottom", "z")
    record(name, "force [N]", force, ideal.force)
    # The force is proportional to the approach to the power of 3/2.
    record(name, "approach of Hertz under this force [mm]", 0.0025,
           0.0025 * (force / ideal.force)**(2 / 3),
           coarser(levels, element) * BARS["approach"])
    normal_contact(name, slave, ideal.p0, (ideal.a, ideal.b),
                   coarser(levels, element))


def distribution(name, slave, direction, shear, friction, ideal, stick, size):
    """Shears along the direction of slip against theory, and where sticking
    ends: between the outermost node that sticks and the innermost that slips."""
    def radius(r):
        return math.hypot(r["X_mm"], r["Y_mm"])
    status = "status_0_open_1_slip_2_stick"
    sticks = max((radius(r) for r in slave if r[status] == 2), default=0.)
    slips = min(radius(r) for r in slave if r[status] == 1)
    error = max(sticks - stick, stick - slips, 0) / size
    record(name, "radius of sticking [mm], error in elements",
           (sticks + slips) / 2, stick, BARS["radius"], error)
    away = [r for r in slave if abs(radius(r) - stick) > size
            and radius(r) < ideal.a - size]
    deviation = [direction(r) - shear(radius(r)) for r in away]
    value = math.sqrt(np.mean(np.square(deviation))) / (friction * ideal.p0)
    record(name, "root mean square of q - theory away from the ends of stick "
           "and contact, by mu p0", value, 0., 0.05, value)


def cattaneo_mindlin(levels):
    name, summary, slave = run("cattaneo_mindlin", levels)
    modulus, friction = STEEL[0], 0.3
    force = 2 * reaction(summary, "Bottom", "z")
    ideal = theory.Hertz(200., modulus / 2, 0.005)
    shifted = theory.Mindlin(ideal, friction, modulus / 2, 0., 7.65e-4)
    record(name, "normal force [N]", force, ideal.force)
    tangential = 2 * reaction(summary, "Bottom", "x")
    record(name, "tangential force [N]", tangential, shifted.force)
    # What theory has under the forces that there are.
    under = theory.Hertz.of_force(200., modulus / 2, force)
    shift = theory.Mindlin.of_force(under, friction, modulus / 2, 0.,
                                    tangential).shift
    record(name, "shift of Mindlin under these forces [mm]", 7.65e-4, shift,
           coarser(levels, ()) * BARS["approach"])
    distribution(name, slave, lambda r: abs(r["shear_x_MPa"]),
                 shifted.shear, friction, ideal, shifted.stick,
                 1 / 3 / 2**levels)


def lubkin(levels):
    name, summary, slave = run("lubkin", levels)
    modulus, friction = STEEL[0] / (1 - STEEL[1]**2) / 2, 0.3
    shear_modulus = STEEL[0] / 2 / (1 + STEEL[1])
    ideal = theory.Hertz(200., modulus, 0.005)
    twisted = theory.Lubkin(ideal, friction, shear_modulus, 0.7)
    force = reaction(summary, "Bottom", "z")
    record(name, "normal force [N]", force, ideal.force)
    # By the points that turn the upper sphere, 400 mm from the axis.
    torque = 400 * (reaction(summary, "East", "y")
                    + reaction(summary, "West", "y"))
    record(name, "torque [N mm]", torque, twisted.torque)
    under = theory.Lubkin.of_torque(
        theory.Hertz.of_force(200., modulus, force), friction, shear_modulus,
        torque)
    record(name, "twist of Lubkin under these forces", 0.28214 / 400,
           2 * under.twist, coarser(levels, ()) * BARS["approach"])

    def around(r):
        radius = math.hypot(r["X_mm"], r["Y_mm"])
        return abs(r["X_mm"] * r["shear_y_MPa"]
                   - r["Y_mm"] * r["shear_x_MPa"]) / max(radius, 1e-12)
    distribution(name, slave, around, twisted.shear, friction, ideal,
                 twisted.stick, 1 / 3 / 2**levels)


def quarter_of_axisymmetric(levels, *element):
    """Against the plane program with the same elements, ten along the radius of
    contact; pressures linear between nodes."""
    status, said, plane = solve(
        cases.parent / "sphere_on_plane.prm", *element, "Output/Profile=true")
    check("axisymmetric sphere: converges", status in (0, 1),
          said[-300:] if status > 1 else "")
    along = sorted((r["X_mm"], r["pressure_MPa"])
                   for r in rows("sphere_on_plane") if r["surface"] == "slave")
    name, summary, slave = run("quarter_of_axisymmetric", levels, *element)
    times = coarser(levels, element)
    record(name, "force [N], and axisymmetric",
           4 * reaction(summary, "Top", "z"), reaction(plane, "Top", "y"),
           times * 1.5 * BARS["approach"])
    line = on_axis(slave, "X", "Y")
    a = math.sqrt(30 * 0.1)
    for part in (0.25, 0.5, 0.75):
        record(name, f"p({part} a) [MPa], and axisymmetric",
               *(np.interp(part * a, *zip(*points)) for points in (line, along)),
               times * BARS["peak"])
    normal_contact(name, slave, max(p for _, p in along), (a, a), times)


def thick_spheres(some_levels, *element):
    inner, outer = theory.nested_spheres((20, 50, 100), (1000, 2000),
                                         (0.3, 0.25), 100.)
    energy = (inner.energy() + outer.energy()) / 8
    errors = []
    for levels in some_levels:
        name, summary, slave = run("thick_spheres", levels, *element)
        probes = {p["name"]: p["value"] for p in summary["probes"]}
        value = probes["U_inner"] + probes["U_outer"]
        record(name, "strain energy [N mm]", value, energy)
        record(name, "u(20) [mm]", probes["u(20)"], inner.displacement(20))
        record(name, "u(100) [mm]", probes["u(100)"], outer.displacement(100))
        contact = inner.outer_pressure
        pressures = [r["pressure_MPa"] for r in slave]
        record(name, "mean pressure at the nodes [MPa]", np.mean(pressures),
               contact)
        record(name, "standard deviation of these pressures, by their mean",
               np.std(pressures) / contact, 0., None,
               np.std(pressures) / contact)
        errors.append(abs(value - energy))
    # Energies converge twice as fast as errors in the norm of the energy.
    degree = 2 if element == QUADRATIC else 1
    for before, after in zip(errors, errors[1:]):
        order = math.log2(before / after) / 2
        record(name, "order of the error in the norm of the energy", order,
               degree, None)
        check(f"{name}: order {order:.2f}", order > degree - 0.25)


def write(path):
    """The page with the sections of the cases of this run; those of other cases
    stay as they are."""
    sections = {}
    if path.exists():
        for part in path.read_text().split("\n## ")[1:]:
            sections[part.split("\n")[0]] = part.rstrip("\n")
    for name in PLAN:
        mine = [row for row in page if row[0].split(",")[0] == name]
        if mine:
            sections[name] = "\n".join([
                name, "",
                "| mesh | quantity | computed | closed form | error | bar |",
                "|---|---|---|---|---|---|"] + [
                f"| {case.split(', ', 1)[1]} | {quantity} | {value:.6g} | "
                f"{exact:.6g} | {error:.2g} | "
                f"{'-' if bar is None else f'{bar:.2g}'} |"
                for case, quantity, value, exact, error, bar in mine])
    title = ("# Contact of round bodies in 3-D against closed forms\n\n"
             "`tests/verification_space.py build/contact parameters meshes "
             "--full \\\n--write tests/study/results/verification_space.md`, or "
             "case by case with `--case`\n\nThe cases are those of "
             "`parameters/verification/3d`, the closed forms those of\n"
             "`tests/point_contact.py`. Errors are relative where nothing else "
             "is said; levels are\nrefinements. The radius of contact has three "
             "elements on the coarsest mesh.\n\n## ")
    path.write_text(title + "\n\n## ".join(
        sections[name] for name in PLAN if name in sections) + "\n")


LINEAR = "Element/Degree=1", "Element/Centre node=serendipity"

# Functions and their arguments: for the suite, and what --full adds.
PLAN = {
    "sphere_on_plane": (sphere_on_plane, [(2, *LINEAR), (0, *QUADRATIC)],
                        [(1, *QUADRATIC)]),
    "two_spheres": (two_spheres, [(1, *LINEAR)],
                    [(2, *LINEAR), (0, *QUADRATIC)]),
    "quarter_of_axisymmetric": (quarter_of_axisymmetric, [(1, *LINEAR)],
                                [(2, *LINEAR), (1, *QUADRATIC)]),
    "crossed_cylinders": (crossed_cylinders, [(0, *LINEAR)], [(1, *LINEAR)]),
    "cattaneo_mindlin": (cattaneo_mindlin, [(1,)], []),
    "lubkin": (lubkin, [(0,)], [(1,)]),
    "thick_spheres": (thick_spheres, [((0, 1), *QUADRATIC)],
                      [((2, 3), *LINEAR)])}
for name in arguments.case or PLAN:
    compute, quick, more = PLAN[name]
    for values in quick + (more if arguments.full else []):
        compute(*values)
if arguments.write:
    write(arguments.write)
sys.exit(bool(failures))
