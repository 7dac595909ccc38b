#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The meshes of the hard cases in 3-D: parameters/hard/meshes.sh calls it.

Usage: space_meshes.py DIRECTORY
"""

import math
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from volume_scenes import Volumes, layer  # noqa: E402

DIGITS = 9


def turned(place, axis, angle):
    """Turned about a coordinate axis [degrees]."""
    a, b = (axis + 1) % 3, (axis + 2) % 3
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    place = list(place)
    place[a], place[b] = c * place[a] - s * place[b], s * place[a] + c * place[b]
    return place


def box(lo, hi, turns=(), lift=None):
    """The chart of a box, turned about the coordinate axes one after the other,
    and then lifted until its lowest corner is at 'lift'."""
    def place(r, s, t):
        x = [a + (b - a) * c for a, b, c in zip(lo, hi, (r, s, t))]
        for axis, angle in turns:
            x = turned(x, axis, angle)
        return x
    rise = 0. if lift is None else lift - min(
        place(r, s, t)[2] for r in (0, 1) for s in (0, 1) for t in (0, 1))

    def chart(r, s, t):
        x, y, z = place(r, s, t)
        return tuple(round(c, DIGITS) for c in (x, y, z + rise))
    return chart


LOWER = box((-10, -10, -8), (10, 10, 0))


def blocks(name, upper, n=(4, 4, 3), lower=LOWER, m=(5, 5, 2), sides=None):
    mesh = Volumes()
    mesh.block("Lower", m, lower)
    mesh.block("Upper", n, upper, sides)
    mesh.write(name)


def ball(mesh, radius, n, centre):
    """A cube in the middle and six blocks around it; the groups Ball_out, and
    Ball_top for the upper of the six, the point Ball_low."""
    half = 0.45 * radius

    def move(x):
        return tuple(round(a + b, DIGITS) for a, b in zip(x, centre))
    mesh.block("Ball", (n, n, n),
               lambda r, s, t: move([half * (2 * c - 1) for c in (r, s, t)]),
               {}, {})
    for d in range(3):
        for side in (-1, 1):
            a, b = (d + 1) % 3, (d + 2) % 3

            # The tangents make cells of one size on the sphere.
            def chart(r, s, t):
                inner, outer = [0.] * 3, [0.] * 3
                # The orientation of the cells is the same on both sides.
                u, v = 2 * s - 1, side * (2 * t - 1)
                inner[d], inner[a], inner[b] = half * side, half * u, half * v
                outer[d] = side
                outer[a] = math.tan(math.pi / 4 * u)
                outer[b] = math.tan(math.pi / 4 * v)
                length = math.hypot(*outer)
                return move([(1 - r) * i + r * radius * o / length
                             for i, o in zip(inner, outer)])
            top = d == 2 and side == 1
            mesh.block("Ball", (max(1, n // 2), n, n), chart,
                       {"x1": "top" if top else "out"}, {})
    low = mesh.places["Ball", *(round(c, 9) for c in
                                move((0, 0, -radius)))] if n % 2 == 0 else None
    if low:
        mesh.add(0, "Ball_low", [low])


def balls():
    mesh = Volumes()
    mesh.block("Lower", (5, 5, 3), LOWER)
    ball(mesh, 10, 4, (0, 0, 10))
    mesh.write("space_ball")


def two_supports():
    mesh = Volumes()
    mesh.block("Left", (3, 4, 2), box((-12, -5, -6), (-5, 5, 0)))
    mesh.block("Right", (3, 4, 2), box((6, -5, -6), (12, 5, 0)))
    mesh.block("Beam", (8, 3, 2), box((-12, -4, 0), (12, 4, 4)))
    mesh.write("space_two")


def pin():
    """The pin and the plate of pin_play.msh, 5 mm thick."""
    layer(pathlib.Path("pin_play.msh").resolve(), 5.).write("space_pin")
    os.remove("plane.msh")


def main():
    os.chdir(sys.argv[1])
    cube = (-5, -5, 0), (5, 5, 6)
    blocks("space_blocks", box(*cube, [(2, 20)]))
    blocks("space_one", box((-10, -10, 0), (10, 10, 8)), (1, 1, 1), m=(1, 1, 1))
    blocks("space_ratio", box((-4.8, -4.8, 0), (4.8, 4.8, 5)), (2, 2, 1),
           box((-6, -6, -5), (6, 6, 0)), (20, 20, 1))
    blocks("space_edge", box((-5, -4, -4), (5, 4, 4), [(0, 45)], 0), (5, 4, 4),
           sides={"y0": "low", "z0": "low", "y1": "high", "z1": "high"})
    blocks("space_corner", box((-4, -4, -4), (4, 4, 4),
                               [(2, 45), (0, math.degrees(math.atan(2**0.5)))],
                               0), (4, 4, 4),
           sides={f"{d}{i}": ("low", "high")[i] for d in "xyz" for i in (0, 1)})
    blocks("space_tilted", box(*cube, [(1, 3), (0, 2)], 0))
    balls()
    two_supports()
    pin()


if __name__ == "__main__":
    main()
