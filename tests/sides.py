#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact groups that go round feature edges: 30 scenes in 2-D and 30 in 3-D.

Proves that

- a slave group round concave edges (the inside of a corner, a groove, a tray, a
  cap), round convex edges (a block in a corner, a tongue, a peg) and round both (a
  T-slot, teeth, a step, a cross, a lid) has the nodal forces of a contact pair for
  each smooth side of it against the whole master, to 1e-6 of the largest one: of
  degree 1 and 2, with the mortar and the nodal discretization and, in 2-D, in Gauss
  points, without friction and with coefficients of 0.3 and 1, from a gap and from
  touch, in at most 60 Newton steps an increment;
- the forces on all bodies are in balance;
- with slave and master exchanged the forces are the same but for the error of the
  meshes: the difference, which is printed, becomes smaller on refined meshes;
- the forces of a scene that is turned, or mirrored and turned, are turned alike, to
  1e-8 of the largest one.

The sides are found here, from the facets of the mesh: they end where two facets
meet at more than 35 degrees.

Usage: sides.py CONTACT PARAMETERS MESHES [PART OF A SCENE'S NAME]
"""

import os
import sys
import time

from block_scenes import check, failures
from sides_scenes import Body, Scene, divided, turn

MOST_STEPS = 60  # of Newton's method, an increment
PRESS, PUSH = "min(1,2*t)", "max(0,2*t-1)"


def up(p, n):
    return n[-1] == 1


def down(p, n):
    return n[-1] == -1


def beside(axis, *signs):
    return lambda p, n: n[axis] in (signs or (-1, 1))


def outside(*boxes):
    """Outside of all boxes, each of an interval for each axis; None: all."""
    return lambda *p: not any(
        all(i is None or i[0] < x < i[1] for x, i in zip(p, box))
        for box in boxes)


def inside(*boxes):
    return lambda *p: not outside(*boxes)(*p)


FAR = 100
POSITIVE, NEGATIVE = (0, FAR), (-FAR, 0)


# ---- 2-D ------------------------------------------------------------------

def corner(gap=(0.01, 0.01), way=((-0.03, 0), (0, -0.03)), lean=0., body=(3, 2),
           block=(4, 3), round_the_ends=False, young=1000.):
    """A block in the corner of a floor and a wall; the sole leans."""
    x, y = gap
    ends = round_the_ends
    return Scene([
        Body("A", (divided(-.8, 1, 0, body[0], 1.7, 1, 2.3),
                   divided(-.8, 1, 0, body[1], 1.5)),
             outside((POSITIVE, POSITIVE)),
             {"Base": lambda p, n: p[1] == -.8 or p[0] == -.8,
              "In": lambda p, n: ends or p[0] == 0 or p[1] == 0}),
        Body("B", (divided(x, block[0], x + 1.6), divided(y, block[1], y + 1.2)),
             inside((None, None)),
             {"Head": up, "Out": lambda p, n: ends or n[0] < 1},
             lambda x, y: (x, y + lean * x), young)],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def groove(gap=(0.01, 0.02, 0.01), way=((0.04, 0), (0, -0.04)), flare=0.,
           body=(2, 2), tongue=(3, 3), rims=False):
    """A tongue in a groove; gaps left, right and below; flare: its walls lean, and
    with a negative one hold the tongue back."""
    def chart(x, y):
        return x * (1 + flare * y), y
    left, right, below = gap
    return Scene([
        Body("A", (divided(-1.4, 1, -.6, body[0], .6, 1, 1.4),
                   divided(-.8, 1, 0, body[1], .9)),
             outside(((-.6, .6), POSITIVE)),
             {"Base": lambda p, n: p[1] == -.8,
              "In": lambda p, n: abs(p[0]) <= .6 and p[1] >= 0 or rims and up(p, n)},
             chart),
        Body("B", (divided(-.6 + left, tongue[0], .6 - right),
                   divided(below, tongue[1], below + 1.3)),
             inside((None, None)), {"Head": up, "Out": lambda p, n: True}, chart)],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def lid(gap=(0.02, 0.02, 0.01), way=((0.03, 0), (0, -0.04))):
    """A tongue with a flange over the rims of the groove."""
    left, right, above = gap
    return Scene([
        Body("A", (divided(-1.4, 1, -.6, 2, .6, 1, 1.4),
                   divided(-.8, 1, 0, 2, .9)),
             outside(((-.6, .6), POSITIVE)),
             {"Base": lambda p, n: p[1] == -.8,
              "In": lambda p, n: abs(p[0]) <= .6 and p[1] >= 0 or up(p, n)}),
        Body("B", (divided(-1.2, 2, -.6 + left, 3, .6 - right, 2, 1.2),
                   divided(.15, 2, .9 + above, 1, 1.4)),
             inside((None, (.9, FAR)), ((-.6, .6), None)),
             {"Head": up, "Out": lambda p, n: abs(p[0]) < 1.2})],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def cap(gap=(0.01, 0.02, 0.01), way=((0.04, 0), (0, -0.04))):
    """A cap over a post: its inside is concave, the post convex."""
    left, right, above = gap
    return Scene([
        Body("A", (divided(-.5, 3, .5), divided(-.8, 1, 0, 2, 1)),
             inside((None, None)),
             {"Base": lambda p, n: p[1] == -.8,
              "Out": lambda p, n: p[1] >= 0}),
        Body("B", (divided(-1, 1, -.5 - left, 2, .5 + right, 1, 1.1),
                   divided(.25, 2, 1 + above, 1, 1.6)),
             outside(((-.5 - left, .5 + right), (-FAR, 1 + above))),
             {"Head": up, "In": lambda p, n: -.5 - left <= p[0] <= .5 + right})],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def tslot(gap=0.02, way=((0.03, 0), (0, 0.05)), beside_stem=0.03):
    """A T-piece that is pushed aside and pulled up in a T-slot."""
    stem = .4 - beside_stem
    return Scene([
        Body("A", (divided(-1.6, 1, -1.1, 2, -.4, 2, .4, 2, 1.1, 1, 1.6),
                   divided(-.5, 1, 0, 2, .7, 1, 1.3)),
             outside(((-1.1, 1.1), (0, .7)), ((-.4, .4), POSITIVE)),
             {"Base": lambda p, n: p[1] == -.5,
              "In": lambda p, n: abs(p[0]) <= 1.1 and 0 <= p[1] < 1.3}),
        Body("B", (divided(-1.08, 2, -stem, 1, stem, 2, 1.08),
                   divided(.02, 2, .7 - gap, 2, 1.6)),
             inside((None, (-FAR, .7 - gap)), ((-stem, stem), None)),
             {"Head": lambda p, n: p[1] == 1.6, "Out": lambda p, n: True})],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def teeth(gap=0.02, flare=0., way=((0.02, 0), (0, -0.06))):
    """Two teeth in two grooves. Flare: they become narrower downwards."""
    def chart(x, y):
        return x + flare * (y - .8) * (abs(abs(x) - .6) - .3) * \
            (1 if abs(x) > .6 else -1) * (1 if x > 0 else -1), y
    return Scene([
        Body("A", (divided(-1.4, 1, -.9, 2, -.3, 1, .3, 2, .9, 1, 1.4),
                   divided(-.6, 1, 0, 2, .8)),
             outside(((-.9, -.3), POSITIVE), ((.3, .9), POSITIVE)),
             {"Base": lambda p, n: p[1] == -.6,
              "In": lambda p, n: abs(p[0]) < 1.4 and p[1] >= 0}, chart),
        Body("B", (divided(-1.3, 1, -.9 + gap, 3, -.3 - gap, 2, .3 + gap, 3,
                           .9 - gap, 1, 1.3), divided(gap, 3, .8 + gap, 1, 1.4)),
             inside((None, (.8, FAR)), ((-.9, -.3), None), ((.3, .9), None)),
             {"Head": up, "Out": lambda p, n: abs(p[0]) < 1.3}, chart)],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def step(gap=(0.02, 0.01), way=((0.04, 0), (0, -0.04))):
    """A step on a step: each surface has a concave and a convex edge."""
    x, y = gap
    return Scene([
        Body("A", (divided(-1.3, 2, 0, 2, 1.2), divided(-.7, 1, 0, 2, .6)),
             outside((NEGATIVE, POSITIVE)),
             {"Base": lambda p, n: p[1] == -.7,
              "In": lambda p, n: up(p, n) or p[0] == 0}),
        Body("B", (divided(-1.2, 3, -x, 3, 1.1), divided(y, 2, .6 + y, 1, 1.2)),
             outside(((-x, FAR), (-FAR, .6 + y))),
             {"Head": up, "Out": lambda p, n: down(p, n) or p[0] == -x})],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def key(gap=0.01, way=((0.05, 0), (0, -0.03))):
    """A key between two bodies, in a groove of each, that is sheared: free but for
    a side that is held along itself."""
    return Scene([
        Body("A", (divided(-1.5, 1, -.5, 2, .5, 1, 1.5), divided(-1.2, 1, -.5, 2, 0)),
             outside(((-.5, .5), (-.5, FAR))),
             {"Base": lambda p, n: p[1] == -1.2,
              "LowIn": lambda p, n: abs(p[0]) <= .5 and p[1] > -1.2}),
        Body("C", (divided(-1.5, 1, -.5, 2, .5, 1, 1.5),
                   divided(.02, 2, .52, 1, 1.2)),
             outside(((-.5, .5), (-FAR, .52))),
             {"Head": lambda p, n: p[1] == 1.2,
              "HighIn": lambda p, n: abs(p[0]) <= .5 and p[1] < 1.2}),
        Body("B", (divided(-.5 + gap, 3, .5 - gap),
                   divided(-.5 + gap, 3, .01, 3, .52 - gap)),
             inside((None, None)), {"Low": lambda p, n: p[1] < .01,
                                    "High": lambda p, n: p[1] > .01})],
        [("LowIn", "Low"), ("HighIn", "High")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def cross(gap=0.01, angle=0.05):
    """A cross that is turned in a hole of its shape."""
    def arms(half, wide):
        return inside(((-wide, wide), (-half, half)), ((-half, half), (-wide, wide)))
    long, wide = 1 - gap, .35 - gap
    hole = arms(1, .35)
    return Scene([
        Body("A", (divided(-1.6, 1, -1, 1, -.35, 2, .35, 1, 1, 1, 1.6),) * 2,
             lambda *p: not hole(*p),
             {"Base": lambda p, n: max(map(abs, p)) == 1.6,
              "In": lambda p, n: True}),
        Body("B", (divided(-long, 2, -wide, 3, wide, 2, long),) * 2,
             lambda *p: arms(long, wide)(*p) and
             not all(abs(x) < wide / 3 for x in p),
             {"Inside": lambda p, n: max(map(abs, p)) <= wide / 3 + 1e-9,
              "Out": lambda p, n: True})],
        [("In", "Out")], {"Base": [], "Inside": []}, {"Inside": f"{angle}*t"})


def hook(gap=(0.02, 0.02), way=((0, 0.04), (0.04, 0))):
    """Two hooks, one pulled up and aside in the other."""
    x, y = gap
    return Scene([
        Body("A", (divided(-1, 1, -.4, 2, .6), divided(-.8, 2, 0, 2, .7, 1, 1.2)),
             outside((NEGATIVE_OF(-.4), (-.8, .7)), ((-.4, .6), None)),
             {})], [], {})


# ---- 3-D ------------------------------------------------------------------
