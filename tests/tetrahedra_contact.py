#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact of tetrahedra, with each other and with hexahedra.

Proves that two blocks whose meshes do not match, in a scene that is turned by odd
angles about all axes, of degree 1 and 2 and with either side as slave, have the
uniform stress that they are loaded with, and its pressure and shear at each node,
to 1e-10:

- skewed meshes that cover each other, tetrahedra on tetrahedra, tetrahedra on
  hexahedra and hexahedra on tetrahedra;
- a lower block that is wider than the upper one, which is turned against it: facets
  that are covered in part, whose test functions are linear between the nodes;
- under pressure without friction, and under pressure and shear, where sticking alone
  holds the upper block; with the nodal discretization on matching nodes;
- on two processes.

And on a rigid half space, where nodal points of 6 nodes are combinations, a uniform
pressure; and that a paraboloid on a block, tetrahedra of degree 2, has the largest
pressure of Hertz within 2 %, pressures that converge, and with either side as slave
and with nodal points the same force within 1 %.

Usage: tetrahedra_contact.py CONTACT PARAMETERS MESHES
"""

import itertools
import math
import sys

import numpy

from block_scenes import check, failures, rows, run
from space_scenes import (block_supports, check_patch, clip, converged, merged,
                          rotation, uniform_loads)
from tetrahedra_scenes import Solid

ANGLES = (27., -40., 63.)
TURN = rotation(ANGLES)
PRESSURE, SHEAR = 10., (2.4, 3.2)
STRESSES = ("xx", "yy", "zz", "xy", "xz", "yz")
SIDES = ("x0", "x1", "y0", "y1")


class Block:
    """A rectangle about (0.5, 0.5) that is turned, with skewed cells, between two
    heights; 'cells' are its numbers along x and y."""

    def __init__(self, cells, size, angle, heights, skew):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        self.cells, self.angle, self.skew = (*cells, 2), angle, skew

        def plane(x, y):
            x, y = (x - 0.5) * size[0], (y - 0.5) * size[1]
            return 0.5 + c * x - s * y, 0.5 + s * x + c * y

        def chart(r, s, t):
            bubble = 16 * r * (1 - r) * s * (1 - s)
            return (*plane(r + skew * bubble * (s - 0.3),
                           s - skew * bubble * (r - 0.6)),
                    heights[0] + (heights[1] - heights[0]) * t)
        self.chart = chart
        self.polygon = [plane(*p) for p in ((0, 0), (1, 0), (1, 1), (0, 1))]

    def add_to(self, mesh, body, kind):
        return mesh.block(body, self.cells, self.chart, kind, points=True)

    def facets(self, side, kind):
        """The faces of a side z0 or z1, as places in the plane of the block."""
        n, t = self.cells, int(side[1])
        for i, j in itertools.product(range(n[0]), range(n[1])):
            corners = [self.chart((i + a) / n[0], (j + b) / n[1], t)[:2]
                       for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            if kind == 8:
                yield (i, j, 0), corners
            else:
                for half, other in enumerate((1, 3)):
                    chosen = [corners[0], corners[other], corners[2]]
                    yield (i, j, half), chosen if half == 0 else chosen[::-1]


LOW, UP = (-1., 0.), (0., 1.)
COVERED = (Block((3, 3), (1, 1), 0., LOW, 0.3),
           Block((4, 5), (1, 1), 0., UP, -0.4))
WIDER = (Block((5, 5), (1.55, 1.4), 0., LOW, 0.),
         Block((3, 3), (0.9, 0.8), 20., UP, -0.3))
UP_BLOCK = COVERED[1]
MATCHING = (Block((3, 4), (1, 1), 0., LOW, 0.3),
            Block((3, 4), (1, 1), 0., UP, 0.3))

# Scene, kinds of cells below and above, degree, slave, shear, processes.
RUNS = [(COVERED, *settings) for settings in (
    (4, 4, 1, "Low", True, 1), (4, 4, 1, "Up", False, 2),
    (4, 4, 2, "Low", False, 1), (4, 4, 2, "Up", True, 2),
    (4, 8, 1, "Low", False, 1), (4, 8, 2, "Up", True, 1),
    (4, 8, 2, "Low", True, 1), (8, 4, 1, "Low", True, 1),
    (8, 4, 2, "Low", False, 1), (8, 4, 2, "Up", True, 1))] + [
        (WIDER, *settings) for settings in (
            (4, 4, 1, "Low", True, 1), (4, 4, 1, "Up", False, 1),
            (4, 4, 2, "Low", False, 2), (4, 4, 2, "Low", True, 1),
            (4, 4, 2, "Up", True, 1), (4, 8, 2, "Low", True, 1),
            (8, 4, 2, "Low", False, 1), (8, 4, 2, "Up", False, 1))]


def integrals(polygon, functions):
    """Over a convex polygon, by Gauss points in triangles of its corners."""
    points, weights = numpy.polynomial.legendre.leggauss(6)
    total = 0.
    for k in range(1, len(polygon) - 1):
        a, b, c = (numpy.array(polygon[i]) for i in (0, k, k + 1))
        area = numpy.cross(b - a, c - a) / 2
        for (s, u), (t, v) in itertools.product(
                zip((points + 1) / 2, weights / 2), repeat=2):
            total = total + 2 * area * u * v * s * functions(
                a + s * (b - a) + s * t * (c - b))
    return total


def share_outside(facet, covering, degree):
    """A formula: against all shape functions of a facet it has the same integrals
    as the function that is 1 outside of a convex polygon. None if all of the facet
    is inside."""
    inside = clip(facet, covering)
    middle = numpy.mean(facet, axis=0)
    powers = [p for p in itertools.product(range(degree + 1), repeat=2)
              if len(facet) == 4 or sum(p) <= degree]

    def functions(x):
        return numpy.array([numpy.prod((x - middle) ** p) for p in powers])
    whole = integrals(facet, functions)
    outside = whole - integrals(inside, functions)
    if abs(outside[0]) < 1e-13 * whole[0]:
        return None
    mass = integrals(facet, lambda x: numpy.outer(functions(x), functions(x)))
    factors = numpy.linalg.solve(mass, outside)
    local = ["(" + "+".join(f"({float(TURN[c, d])!r})*{'xyz'[c]}"
                            for c in range(3)) + f"-({float(middle[d])!r}))"
             for d in range(2)]
    return "+".join("*".join([f"({float(f)!r})"] + [local[0]] * i +
                             [local[1]] * j)
                    for f, (i, j) in zip(factors, powers))


def completing_loads(mesh, body, block, kind, number, covering, stress, degree):
    """Groups of one facet each with the load that completes the pressure there."""
    entries = {}
    side, sign = ("z1", 1) if body == "Low" else ("z0", -1)
    traction = TURN @ stress @ [0, 0, sign]
    n = block.cells
    for (i, j, half), facet in block.facets(side, kind):
        share = share_outside(facet, covering, degree)
        if share is None:
            continue
        corners = ((0, 0), (2, 0), (2, 2), (0, 2))
        chosen = corners if kind == 8 else [
            corners[k] for k in ((0, 1, 2), (0, 3, 2))[half]]
        group = f"{body}_{i}_{j}_{half}"
        mesh.add(2, group, [number[2 * i + a, 2 * j + b,
                                   2 * n[2] * int(side[1])]
                            for a, b in chosen])
        entries = merged(entries, {
            f"Boundary conditions/Traction {c}":
            f"{group}: {float(traction[k])!r}*({share})"
            for k, c in enumerate("xyz")})
    return entries


def patch_test(scene, below, above, degree, slave, with_shear, ranks,
               discretization="mortar"):
    low, up = scene
    stress = numpy.diag([0., 0., -PRESSURE])
    if with_shear:
        stress[2, :2] = stress[:2, 2] = SHEAR
    # Under shear nothing may slip: both widen alike.
    moduli, ratios = ((1000, 500), (0.3, 0.15)) if with_shear else \
        ((1000, 3000), (0.3, 0.1))
    mesh = Solid()
    numbers = low.add_to(mesh, "Low", below), up.add_to(mesh, "Up", above)
    loads = merged(uniform_loads("Low", stress, TURN, [*SIDES, "z0"],
                                 rotation((0, 0, low.angle))),
                   uniform_loads("Up", stress, TURN, [*SIDES, "z1"],
                                 rotation((0, 0, up.angle))))
    if scene is WIDER:
        loads = merged(loads, completing_loads(
            mesh, "Low", low, below, numbers[0], up.polygon, stress, degree))
    mesh.write("patch")
    entries = {
        "Mesh/File": "patch.msh", "Mesh/Rotation": "{}, {}, {}".format(*ANGLES),
        "Element/Degree": degree,
        "Element/Centre node": "free" if degree == 2 else "serendipity",
        "Solids/Young's modulus": "Low: {}, Up: {}".format(*moduli),
        "Solids/Poisson's ratio": "Low: {}, Up: {}".format(*ratios),
        "Solids/Kinematics": "small strain",
        **loads, **block_supports(low, up, TURN, with_shear),
        "Contact/Slave": "Up_z0" if slave == "Up" else "Low_z1",
        "Contact/Master": "Low_z1" if slave == "Up" else "Up_z0",
        "Contact/Friction coefficient": 0.8 if with_shear else 0,
        "Contact/Discretization": discretization,
        "Solution/Geometry": "undeformed", "Solution/Increments": 1,
        "Solution/Newton tolerance": 1e-13, "Output/Profile": "true",
        "Probes/Probes": "; ".join(
            f"{body}_{corner} {c}: stress {c}, {body}_{corner}"
            for body in ("Low", "Up") for corner in ("000", "101", "111")
            for c in STRESSES)}
    status, said, summary = run("patch", entries, ranks)
    names = {4: "tetrahedra", 8: "hexahedra"}
    what = (f"{discretization}, {names[above]} on {names[below]}"
            f"{' that are wider' if scene is WIDER else ''}, degree {degree}, "
            f"slave {slave}, {'shear' if with_shear else 'no friction'}, "
            f"{ranks} processes")
    if not converged(what, status, summary, said):
        return
    check_patch(what, stress, TURN, PRESSURE, slave, summary)


def on_half_space(degree):
    """A skewed block that is pressed on a rigid half space."""
    mesh = Solid()
    UP_BLOCK.add_to(mesh, "Up", 4)
    mesh.write("patch")
    status, said, summary = run("patch", {
        "Mesh/File": "patch.msh", "Element/Degree": degree,
        "Solids/Young's modulus": "Up: 1000", "Solids/Poisson's ratio": "Up: 0.3",
        "Solids/Kinematics": "small strain",
        "Boundary conditions/Displacement x": "Up_x0: 0",
        "Boundary conditions/Displacement y": "Up_y0: 0",
        "Boundary conditions/Traction z": f"Up_z1: {-PRESSURE}",
        "Contact/Slave": "Up_z0",
        "Contact/Obstacle": "half space: 0, 0, 0, 0, 0, 1",
        "Solution/Increments": 1, "Solution/Newton tolerance": 1e-13,
        "Output/Profile": "true"})
    what = f"a block on a half space, degree {degree}"
    if converged(what, status, summary, said):
        off = [abs(row["pressure_MPa"] / PRESSURE - 1) for row in rows("patch")
               if row["surface"] == "slave"]
        check(f"{what}: pressure of {len(off)} nodes",
              len(off) > 8 and max(off) < 1e-10, max(off))


def paraboloid(n, slave, discretization="mortar"):
    """A quarter of z = (x^2 + y^2)/(2 R) on a flat block of the same material,
    with n cells a side that grow away from the contact: the largest pressure by
    Hertz' under the force that there is, the deviation from his pressures within
    0.8 of the radius (root mean square), and the force."""
    radius, size, modulus, ratio = 50., 8., 1000., 0.3

    def grow(s):
        return size * (0.3 * s + 0.7 * s**3)

    def chart(curvature, sign):
        def place(r, s, t):
            x, y = grow(r), grow(s)
            height = curvature * (x * x + y * y) / 2
            return x, y, sign * (height + (size - height) *
                                 (0.15 * t + 0.85 * t**3))
        return place
    layers = n // 2 + 1
    mesh = Solid()
    mesh.block("Up", (n, n, layers), chart(1 / radius, 1), 10)
    mesh.block("Low", (n - 1, n - 1, layers), chart(0, -1), 10)
    mesh.write("paraboloid")
    other = {"Up": "Low", "Low": "Up"}[slave]
    status, said, summary = run("paraboloid", {
        "Mesh/File": "paraboloid.msh", "Mesh/Mid-side nodes": "true",
        "Solids/Young's modulus": f"Up: {modulus}, Low: {modulus}",
        "Solids/Poisson's ratio": f"Up: {ratio}, Low: {ratio}",
        "Solids/Kinematics": "small strain",
        "Boundary conditions/Displacement x": "Up_x0: 0, Low_x0: 0",
        "Boundary conditions/Displacement y": "Up_y0: 0, Low_y0: 0",
        "Boundary conditions/Displacement z": "Up_z1: -0.04, Low_z1: 0",
        "Contact/Slave": f"{slave}_z0", "Contact/Master": f"{other}_z0",
        "Contact/Discretization": discretization, "Solution/Increments": 1,
        "Output/Profile": "true"})
    converged(f"paraboloid of {n} cells, slave {slave}", status, summary, said)
    slave_rows = [row for row in rows("paraboloid") if row["surface"] == "slave"]
    force = 4 * sum(row["nodal_force_N"] for row in slave_rows)
    effective = modulus / (1 - ratio**2) / 2
    a = (3 * force * radius / (4 * effective))**(1 / 3)
    p0 = 3 * force / (2 * math.pi * a * a)
    profile = [(math.hypot(row["X_mm"], row["Y_mm"]) / a, row["pressure_MPa"] / p0)
               for row in slave_rows]
    inside = [p - math.sqrt(1 - r * r) for r, p in profile if r < 0.8]
    return (max(p for _, p in profile),
            math.sqrt(numpy.mean(numpy.square(inside))), force)


def hertz():
    _, coarse, _ = paraboloid(6, "Up")
    peak, fine, force = paraboloid(12, "Up")
    check("Hertz: largest pressure", abs(peak - 1) < 0.02, peak)
    check("Hertz: pressures of order 1", fine < coarse / 2, (coarse, fine))
    _, _, swapped = paraboloid(12, "Low")
    check("Hertz: force as with the other slave", abs(swapped / force - 1) < 0.01,
          (swapped, force))
    for slave in ("Up", "Low"):
        _, _, nodal = paraboloid(12, slave, "nodal")
        check(f"Hertz: force of nodal points on {slave}",
              abs(nodal / force - 1) < 0.01, (nodal, force))


for settings in RUNS:
    patch_test(*settings)
for of_slave in ("Low", "Up"):
    for of_degree in (1, 2):
        patch_test(MATCHING, 4, 4, of_degree, of_slave, True, of_degree, "nodal")
on_half_space(1)
on_half_space(2)
hertz()
sys.exit(bool(failures))
