#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Patch tests of contact in 3-D.

Proves that two blocks whose meshes do not match, in a scene that is turned by odd
angles about all axes, with elements of 8, 20 and 27 nodes and either side as
slave, have the uniform stress that they are loaded with, to 1e-10:

- meshes that are skewed inside, and one block turned against the other about the
  normal;
- surfaces that overlap in part: the slave wider than the master in one and in two
  directions, the master wider, and blocks shifted against each other;
- under pressure without friction; and under pressure and shear, where sticking
  alone holds the upper block;
- also on two processes; turned by 20 degrees, the upper block covers slivers.

And that a soft block presses on quadratic facets of a wider slave, of which it
covers strips, in at most ten Newton steps, with the force that it has if slave and
master are exchanged; and a punch on linear facets that it covers in part, with the
peak of the pressure, and none outside.

Bodies are held by as many components of points as they have rigid motions, all
sides carry the tractions of the stress, and what is not covered carries a load
that does the same work as the stress there.

Usage: space_patch.py CONTACT PARAMETERS MESHES
"""

import math
import sys

import numpy

from block_scenes import check, failures, rows, run
from space_scenes import (SURFACES, block_supports, check_patch, completing_share,
                          converged, merged, rotation, uniform_loads)
from volume_scenes import Volumes

ANGLES = (27., -40., 63.)
TURN = rotation(ANGLES)
PRESSURE, SHEAR = 10., (2.4, 3.2)
STRESSES = ("xx", "yy", "zz", "xy", "xz", "yz")


class Block:
    """A block of the scene before it is turned, between two heights, with what
    its contact surface covers, a polygon."""

    def lines(self, x, y, heights):
        """Of rectangles with these lines."""
        def chart(r, s, t):
            return (x[round(r * (len(x) - 1))], y[round(s * (len(y) - 1))],
                    heights[0] + (heights[1] - heights[0]) * t)
        self.chart, self.grid = chart, (x, y)
        self.cells = len(x) - 1, len(y) - 1, 2
        self.polygon = [(x[0], y[0]), (x[-1], y[0]), (x[-1], y[-1]),
                        (x[0], y[-1])]
        self.angle = 0.
        return self

    def skewed(self, cells, size, angle, heights, skew):
        """A rectangle about (0.5, 0.5) that is turned, with skewed cells."""
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))

        def plane(x, y):
            x, y = (x - 0.5) * size[0], (y - 0.5) * size[1]
            return 0.5 + c * x - s * y, 0.5 + s * x + c * y

        def chart(r, s, t):
            bubble = 16 * r * (1 - r) * s * (1 - s)
            return (*plane(r + skew * bubble * (s - 0.3),
                           s - skew * bubble * (r - 0.6)),
                    heights[0] + (heights[1] - heights[0]) * t)
        self.chart, self.grid, self.cells = chart, None, (*cells, 2)
        self.polygon = [plane(*p) for p in ((0, 0), (1, 0), (1, 1), (0, 1))]
        self.angle = angle
        return self


UNIT = [0., 0.35, 0.7, 1.], [0., 0.3, 0.75, 1.]
LOW, UP = (-1., 0.), (0., 1.)
SCENES = {
    "covered": (Block().skewed((3, 3), (1, 1), 0., LOW, 0.3),
                Block().skewed((4, 5), (1, 1), 0., UP, -0.4)),
    # The Gauss points of segments are fewer, the less cells are skewed.
    "hardly skewed": (Block().skewed((3, 3), (1, 1), 0., LOW, 0.01),
                      Block().skewed((4, 5), (1, 1), 0., UP, -0.02)),
    "lower one wider in x": (
        Block().lines([-0.25, 0.2, 0.6, 1.15], UNIT[1], LOW),
        Block().skewed((4, 5), (1, 1), 0., UP, -0.4)),
    "lower one wider, upper one turned": (
        Block().lines([-0.3, 0.05, 0.4, 0.65, 0.9, 1.25],
                      [-0.2, 0.15, 0.45, 0.8, 1.2], LOW),
        Block().skewed((3, 3), (0.9, 0.8), 20., UP, -0.3)),
    "shifted": (
        Block().lines(*UNIT, LOW),
        Block().lines([0.3, 0.55, 1., 1.4], [-0.2, 0.15, 0.45, 0.8], UP))}

# Element, slave, whether there is shear, processes.
RUNS = {
    "covered": ((8, "Low", True, 2), (20, "Up", False, 2), (27, "Low", False, 1),
                (27, "Up", True, 1)),
    "hardly skewed": ((8, "Low", True, 1), (27, "Up", False, 1)),
    "lower one wider in x": ((8, "Low", False, 1), (27, "Low", False, 1),
                             (20, "Up", True, 1)),
    "lower one wider, upper one turned": (
        (8, "Low", True, 1), (8, "Up", True, 1), (20, "Low", False, 1),
        (27, "Low", True, 2), (27, "Up", False, 1)),
    "shifted": ((8, "Low", False, 1), (8, "Up", True, 1), (20, "Low", True, 1),
                (20, "Up", False, 1), (27, "Up", False, 2))}


def loads(low, up, stress, degree):
    """Tractions on the free sides, and where the surfaces do not overlap."""
    sides = [side for side in SURFACES if side not in ("z0", "z1")]
    entries = merged(
        uniform_loads("Low", stress, TURN, sides + ["z0"],
                      rotation((0, 0, low.angle))),
        uniform_loads("Up", stress, TURN, sides + ["z1"],
                      rotation((0, 0, up.angle))))
    for body, block, other, side, normal in (("Low", low, up, "z1", 1),
                                             ("Up", up, low, "z0", -1)):
        if block.grid is None:
            continue
        share = completing_share(*block.grid, other.polygon, degree, TURN)
        traction = TURN @ stress @ [0, 0, normal]
        entries = merged(entries, {
            f"Boundary conditions/Traction {c}":
            f"{body}_{side}: {float(traction[i])!r}*({share})"
            for i, c in enumerate("xyz")})
    return entries


def patch_test(scene, nodes, slave, with_shear, ranks):
    low, up = SCENES[scene]
    mesh = Volumes()
    mesh.block("Low", low.cells, low.chart)
    mesh.block("Up", up.cells, up.chart)
    mesh.write("patch")
    stress = numpy.diag([0., 0., -PRESSURE])
    if with_shear:
        stress[2, :2] = stress[:2, 2] = SHEAR
    # Under shear nothing may slip: both widen alike.
    moduli, ratios = ((1000, 500), (0.3, 0.15)) if with_shear else \
        ((1000, 3000), (0.3, 0.1))
    degree = 1 if nodes == 8 else 2
    entries = {
        "Mesh/File": "patch.msh", "Mesh/Rotation": "{}, {}, {}".format(*ANGLES),
        "Element/Degree": degree,
        "Element/Centre node": "free" if nodes == 27 else "serendipity",
        "Solids/Young's modulus": "Low: {}, Up: {}".format(*moduli),
        "Solids/Poisson's ratio": "Low: {}, Up: {}".format(*ratios),
        "Solids/Kinematics": "small strain",
        **loads(low, up, stress, degree), **block_supports(low, up, TURN, with_shear),
        "Contact/Slave": "Up_z0" if slave == "Up" else "Low_z1",
        "Contact/Master": "Low_z1" if slave == "Up" else "Up_z0",
        "Contact/Friction coefficient": 0.8 if with_shear else 0,
        "Solution/Geometry": "undeformed", "Solution/Increments": 1,
        "Solution/Newton tolerance": 1e-12, "Output/Profile": "true",
        "Probes/Probes": "; ".join(
            f"{body}_{corner} {c}: stress {c}, {body}_{corner}"
            for body in ("Low", "Up") for corner in ("000", "101", "111")
            for c in STRESSES)}
    status, said, summary = run("patch", entries, ranks)
    what = (f"patch test, {scene}, {nodes} nodes, slave {slave}, "
            f"{'shear' if with_shear else 'no friction'}, {ranks} processes")
    if not converged(what, status, summary, said):
        return
    check_patch(what, stress, TURN, PRESSURE, slave, summary)


def strips():
    def box(low, high):
        return lambda *r: tuple(a + x * (b - a) for x, a, b in zip(r, low, high))
    mesh = Volumes()
    mesh.block("Low", (6, 4, 1), box((0, 0, -73), (100, 100, 0)))
    mesh.block("Up", (2, 3, 2), box((10.138, 9.4226, 0), (94.608, 49.4826, 24.02)))
    mesh.write("strips")
    held = ", ".join(f"{side}: 0" for side in ("Low_z0", "Up_z1"))
    forces = {}
    for slave, master in (("Low_z1", "Up_z0"), ("Up_z0", "Low_z1")):
        status, said, summary = run("strips", {
            "Mesh/File": "strips.msh", "Element/Degree": 2,
            "Solids/Young's modulus": "Low: 2500, Up: 5",
            "Solids/Poisson's ratio": "Low: 0.38, Up: 0.49",
            "Solids/Kinematics": "small strain",
            "Boundary conditions/Displacement x": held,
            "Boundary conditions/Displacement y": held,
            "Boundary conditions/Displacement z": "Low_z0: 0, Up_z1: -1.265",
            "Contact/Slave": slave, "Contact/Master": master,
            "Solution/Increments": 1}, 1)
        what = f"strips of facets, slave {slave}"
        if converged(what, status, summary, said):
            increments = summary["increments"]
            steps = sum(i["newton_iterations"] for i in increments)
            check(f"{what}: {steps} steps", steps <= 10)
            forces[slave] = increments[-1]["reactions"]["Up_z1"]["z"]
    if len(forces) == 2:
        off = forces["Low_z1"] / forces["Up_z0"] - 1
        check("strips of facets: force as with the other slave", abs(off) < 1e-3,
              off)


def narrow_punch(half):
    """A block that ends within the facets of a plate, or by its bulging a little
    beyond a line of them: the plate as slave has the pressure of the other
    slave, and no force where no master is."""
    mesh = Volumes()
    mesh.block("Low", (8, 8, 2), lambda r, s, t: (4 * r - 2, 4 * s - 2, t - 1))
    mesh.block("Up", (4, 4, 2), lambda r, s, t: (half * (2 * r - 1),
                                                 half * (2 * s - 1), t))
    mesh.write("punch")
    peaks = {}
    for slave, master in (("Low_z1", "Up_z0"), ("Up_z0", "Low_z1")):
        status, said, summary = run("punch", {
            "Mesh/File": "punch.msh", "Element/Degree": 1,
            "Solids/Young's modulus": "Low: 1000, Up: 1000",
            "Solids/Poisson's ratio": "Low: 0.3, Up: 0.3",
            "Boundary conditions/Displacement x": "Low_z0: 0, Up_z1: 0",
            "Boundary conditions/Displacement y": "Low_z0: 0, Up_z1: 0",
            "Boundary conditions/Displacement z": "Low_z0: 0, Up_z1: -0.02",
            "Contact/Slave": slave, "Contact/Master": master,
            "Output/Profile": "true", "Solution/Increments": 1}, 1)
        what = f"punch of {2 * half} mm on a plate, slave {slave}"
        if not converged(what, status, summary, said):
            return
        of_slave = [row for row in rows("punch") if row["surface"] == "slave"]
        peaks[slave] = max(row["pressure_MPa"] for row in of_slave)
        outside = sum(row["nodal_force_N"] for row in of_slave
                      if max(abs(row["X_mm"]), abs(row["Y_mm"])) > half + 0.4)
        check(f"{what}: no force outside", outside == 0, outside)
    check("  the same peak within a third", 2 / 3 < peaks["Low_z1"] /
          peaks["Up_z0"] < 4 / 3, peaks)


strips()
for punch in (1., 1.02, 1.1):
    narrow_punch(punch)
for scene_name, runs in RUNS.items():
    for settings in runs:
        patch_test(scene_name, *settings)
sys.exit(bool(failures))
