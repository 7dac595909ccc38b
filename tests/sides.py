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
  touch, in at most 12 Newton steps an increment;
- the forces on all bodies are in balance;
- with slave and master exchanged the forces are the same within a tenth of the error
  of the meshes, which is what a refinement changes; both are printed;
- the forces of a scene that is turned, or mirrored and turned, are turned alike, to
  1e-8 of the largest one.

The sides are found here, from the facets of the mesh: they end where two facets
meet at more than 35 degrees.

Usage: sides.py CONTACT PARAMETERS MESHES [--by-sides] [PART OF A NAME ...]
With --by-sides all runs have a pair for each side, with part of a name only the
scenes with it.
"""

import math
import sys

from block_scenes import check, failures
from sides_scenes import INCREMENTS, Body, Scene, divided, turn

MOST_STEPS = 12  # of Newton's method, an increment
# Of the error of the meshes, for the difference between the roles.
PART_OF_ERROR = 0.1
PRESS, PUSH = "min(1,2*t)", "max(0,2*t-1)"
SLANTED = ((-0.03, 0), (0, -0.06))


def up(p, n):
    return n[-1] == 1


def down(p, n):
    return n[-1] == -1


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
                   divided(-.8, 1, 0, body[1], .8)),
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
        shift, a = flare * .3 * (.8 - y), abs(x)
        a += shift * (a / .3 if a < .3 else (.6 - a) / .3 if a < .9 else
                      (a - 1.4) / .5)
        return math.copysign(a, x), y
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
    """A key between two bodies, in a groove of each, that is sheared. Only contact
    holds it."""
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


def barbs(gap=(0.02, 0.03), way=((0.05, 0), (0, 0.05))):
    """A hook that is pulled aside and up in another one."""
    x, y = gap
    lip = inside(((-1, -.5), (-.8, 1.1)), ((-.5, .5), (.6, 1.1)),
                 ((.2, .5), (.2, .6)))
    foot = inside(((-.4, 1.3), (-.3, .2 - y)), ((-.3, .2 - x), (-.3, .6 - y)),
                  ((.8, 1.3), (-.3, 1.5)))
    return Scene([
        Body("A", (divided(-1, 1, -.5, 2, .2, 1, .5),
                   divided(-.8, 2, .2, 1, .6, 1, 1.1)), lip,
             {"Base": lambda p, n: p[1] == -.8,
              "In": lambda p, n: p[0] > -.6 and p[1] < 1.1}),
        Body("B", (divided(-.4, 1, -.3, 2, .2 - x, 2, .8, 1, 1.3),
                   divided(-.3, 1, .2 - y, 1, .6 - y, 1, 1.5)), foot,
             {"Head": lambda p, n: p[1] == 1.5,
              "Out": lambda p, n: p[1] > -.3 and p[0] < 1.3})],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


# ---- 3-D ------------------------------------------------------------------

def corner_3d(walls=2, gap=(0.01, 0.02, 0.01),
              way=((-0.03, -0.02, 0), (0, 0, -0.03)), body=2, block=(3, 2, 2),
              lean=0., round_the_ends=False):
    """A block on a floor and at one or two walls."""
    x, y, z = gap
    ends = round_the_ends
    faces = range(3) if walls == 2 else (0, 2)
    line, height = divided(-.7, 1, 0, body, 1.5), divided(-.7, 1, 0, body, .7)
    across = divided(-.3, 2, 1.4)
    return Scene([
        Body("A", (line, line if walls == 2 else across, height),
             outside((POSITIVE, POSITIVE if walls == 2 else None, POSITIVE)),
             {"Base": lambda p, n: any(p[d] == -.7 for d in faces),
              "In": lambda p, n: ends or any(p[d] == 0 for d in faces)}),
        Body("B", (divided(x, block[0], x + 1.2), divided(y, block[1], y + 1.1),
                   divided(z, block[2], z + 1)),
             inside((None,) * 3),
             {"Head": up, "Out": lambda p, n: ends or max(n) < 1},
             lambda x, y, z: (x, y, z + lean * x))],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def tray_3d(gap=(0.02, 0.02, 0.01), way=((0, 0, 0), (0, 0, -0.04)), flare=0.,
            open_ends=False, cells=(2, 1), block=(3, 2, 2), rims=False):
    """A block in a tray, or in a groove along y."""
    def chart(x, y, z):
        return x * (1 + flare * z), y * (1 + flare * z), z
    x, y, z = gap
    cavity = ((-.6, .6), None if open_ends else (-.5, .5), POSITIVE)
    return Scene([
        Body("A", (divided(-1, 1, -.6, cells[0], .6, 1, 1),
                   divided(-.7, 2, .6) if open_ends else
                   divided(-.9, 1, -.5, cells[1], .5, 1, .9),
                   divided(-.6, 1, 0, 1, .5)), outside(cavity),
             {"Base": lambda p, n: p[2] == -.6,
              "In": lambda p, n: inside(cavity[:2])(*(.99 * c for c in p[:2])) and
              p[2] >= 0 or rims and up(p, n)}, chart),
        Body("B", (divided(-.6 + x, block[0], .6 - x),
                   divided(-.5 + y, block[1], .5 - y),
                   divided(z, block[2], z + .8)), inside((None,) * 3),
             {"Head": up, "Out": lambda p, n: True}, chart)],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def cap_3d(gap=(0.02, 0.01), way=((0.03, 0.03, 0), (0, 0, -0.03)), block=(2, 2)):
    """A cap over a post."""
    side, above = gap
    hole = (-.5 - side, .5 + side)
    lines = divided(-.9, 1, hole[0], block[0], hole[1], 1, .9)
    return Scene([
        Body("A", (divided(-.5, 3, .5), divided(-.5, 2, .5),
                   divided(-.6, 1, 0, 1, .7)), inside((None,) * 3),
             {"Base": lambda p, n: p[2] == -.6, "Out": lambda p, n: p[2] >= 0}),
        Body("B", (lines, divided(-.9, 1, hole[0], block[1], hole[1], 1, .9),
                   divided(.2, 1, .7 + above, 1, 1.2)),
             outside((hole, hole, (-FAR, .7 + above))),
             {"Head": up, "In": lambda p, n: all(hole[0] <= c <= hole[1]
                                                 for c in p[:2])})],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def bracket_3d(gap=(0.02, 0.01, 0.01), way=((-0.03, -0.02, 0), (0, 0, -0.03)),
               sides=3):
    """A bracket around a corner of a block, or around an edge of it."""
    x, y, z = gap
    along = sides == 3
    return Scene([
        Body("A", (divided(-1.2, 2, 0), divided(-1.2, 2, 0), divided(-1, 2, 0)),
             inside((None,) * 3),
             {"Base": lambda p, n: p[2] == -1, "Out": lambda p, n: True}),
        Body("B", (divided(-.9, 2, x, 1, .5),
                   divided(-.8, 2, y, 1, .5) if along else divided(-1, 3, -.1),
                   divided(-.7, 1, z, 1, .5)),
             outside(((-FAR, x), (-FAR, y) if along else None, (-FAR, z))),
             {"Head": lambda p, n: p[2] == .5,
              "In": lambda p, n: p[0] == x or along and p[1] == y or p[2] == z})],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def tslot_3d(gap=0.02, way=((0.02, 0.01, 0), (0, 0, 0.05)), along=1):
    """A T-piece that is pushed aside and pulled up in a T-slot along y."""
    return Scene([
        Body("A", (divided(-1.5, 1, -1.1, 1, -.4, 1, .4, 1, 1.1, 1, 1.5),
                   divided(-.5, along, .5),
                   divided(-.4, 1, 0, 1, .6, 1, 1.1)),
             outside(((-1.1, 1.1), None, (0, .6)), ((-.4, .4), None, POSITIVE)),
             {"Base": lambda p, n: p[2] == -.4,
              "In": lambda p, n: abs(p[0]) <= 1.1 and 0 <= p[2] < 1.1}),
        Body("B", (divided(-1.08, 2, -.37, 1, .37, 2, 1.08),
                   divided(-.45, along + 1, .45),
                   divided(.02, 1, .6 - gap, 2, 1.4)),
             inside((None, None, (-FAR, .6 - gap)), ((-.37, .37), None, None)),
             {"Head": lambda p, n: p[2] == 1.4, "Out": lambda p, n: True})],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def step_3d(gap=(0.02, 0.01), way=((0.04, 0.01, 0), (0, 0, -0.03))):
    """A step on a step."""
    x, z = gap
    return Scene([
        Body("A", (divided(-1.1, 2, 0, 2, 1), divided(-.6, 2, .6),
                   divided(-.6, 1, 0, 1, .5)),
             outside((NEGATIVE, None, POSITIVE)),
             {"Base": lambda p, n: p[2] == -.6,
              "In": lambda p, n: up(p, n) or p[0] == 0}),
        Body("B", (divided(-1, 3, -x, 2, .9), divided(-.5, 3, .5),
                   divided(z, 1, .5 + z, 1, 1)),
             outside(((-x, FAR), None, (-FAR, .5 + z))),
             {"Head": up, "Out": lambda p, n: down(p, n) or p[0] == -x})],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def lid_3d(gap=(0.02, 0.01), way=((0.03, 0.02, 0), (0, 0, -0.04))):
    """A lid with a plug in a frame: its flange rests on the rims."""
    side, above = gap
    half = .5 - side
    return Scene([
        Body("A", (divided(-1, 1, -.5, 1, .5, 1, 1),) * 2 +
             (divided(0, 2, .7),),
             outside(((-.5, .5), (-.5, .5), None)),
             {"Base": lambda p, n: p[2] == 0,
              "In": lambda p, n: max(map(abs, p[:2])) <= .5 or up(p, n)}),
        Body("B", (divided(-.9, 1, -half, 2, half, 1, .9),) * 2 +
             (divided(.3, 1, .7 + above, 1, 1.1),),
             inside((None, None, (.7 + above, FAR)),
                    ((-half, half), (-half, half), None)),
             {"Head": up, "Out": lambda p, n: max(map(abs, p[:2])) < .9})],
        [("In", "Out")],
        {"Base": [], "Head": [(way[0], PRESS), (way[1], PUSH)]})


def key_3d(gap=0.01, way=((0.04, 0.01, 0), (0, 0, -0.03))):
    """A key in a groove of either body, along y, that is sheared; it is held along
    the grooves alone."""
    return Scene([
        Body("A", (divided(-1.2, 1, -.5, 1, .5, 1, 1.2), divided(-.5, 1, .5),
                   divided(-.9, 1, -.4, 1, 0)),
             outside(((-.5, .5), None, (-.4, FAR))),
             {"Base": lambda p, n: p[2] == -.9,
              "LowIn": lambda p, n: abs(p[0]) <= .5 and p[2] > -.9 and not n[1]}),
        Body("C", (divided(-1.2, 1, -.5, 1, .5, 1, 1.2), divided(-.5, 1, .5),
                   divided(.02, 1, .42, 1, .9)),
             outside(((-.5, .5), None, (-FAR, .42))),
             {"Head": lambda p, n: p[2] == .9,
              "HighIn": lambda p, n: abs(p[0]) <= .5 and p[2] < .9 and not n[1]}),
        Body("B", (divided(-.5 + gap, 2, .5 - gap), divided(-.45, 2, .4),
                   divided(-.4 + gap, 2, .01, 2, .42 - gap)),
             inside((None,) * 3),
             {"End": lambda p, n: n[1] == -1, "Low": lambda p, n: p[2] < .01,
              "High": lambda p, n: p[2] > .01})],
        [("LowIn", "Low"), ("HighIn", "High")],
        {"Base": [], "End": "y",
         "Head": [(way[0], PRESS), (way[1], PUSH)]})


# ---- The scenes -----------------------------------------------------------

# Name, scene, slave, degree, discretization, friction coefficient; besides: roles
# exchanged (R), turned and mirrored (T).
IN_2D = (
    ("corner", corner(), "In", 1, "mortar", 0, "RT"),
    ("corner, from touch", corner(gap=(0, 0)), "In", 1, "nodal", 0, ""),
    ("corner", corner(), "In", 2, "Gauss", 0, ""),
    ("corner", corner(block=(2, 2), body=(4, 3)), "Out", 1, "mortar", 0.3, "T"),
    ("corner, slanted sole", corner(lean=.03, way=SLANTED, young=1e4), "In", 1,
     "mortar", 0, "R"),
    ("corner, slanted sole", corner(lean=.03, way=SLANTED), "Out", 2, "nodal", 0,
     ""),
    ("corner, round the ends", corner(round_the_ends=True), "Out", 2, "mortar",
     0.3, ""),
    ("corner, round the ends", corner(round_the_ends=True, gap=(0, 0)), "In", 1,
     "mortar", 1, ""),
    ("groove", groove(), "In", 1, "mortar", 0, "R"),
    ("groove", groove(), "In", 2, "mortar", 0.3, "T"),
    ("groove", groove(tongue=(2, 3)), "Out", 1, "nodal", 0.3, ""),
    ("groove with rims", groove(flare=.5, rims=True), "In", 1, "mortar", 0.3, ""),
    ("groove, wide at the bottom", groove(flare=-.4, way=((.02, 0), (0, .05))),
     "In", 1, "mortar", 0, "R"),
    ("groove, wide at the bottom", groove(flare=-.4, way=((.02, 0), (0, .05))),
     "Out", 2, "nodal", 0, ""),
    ("tray", groove(gap=(.05, .05, .01), way=((0, 0), (0, -.05))), "In", 1,
     "mortar", 0, "T"),
    ("tray", groove(gap=(.05, .05, 0), way=((0, 0), (0, -.05))), "In", 2, "Gauss",
     0, ""),
    ("cap", cap(), "In", 1, "mortar", 0.3, ""),
    ("cap", cap(), "Out", 1, "Gauss", 0, ""),
    ("T-slot", tslot(), "In", 1, "mortar", 0, "RT"),
    ("T-slot", tslot(), "Out", 1, "mortar", 0.3, ""),
    ("T-slot", tslot(), "In", 2, "nodal", 0, ""),
    ("teeth", teeth(), "In", 1, "mortar", 0.3, ""),
    ("teeth, narrow tips", teeth(flare=.5), "Out", 1, "mortar", 0, "T"),
    ("step", step(), "In", 2, "mortar", 0.3, ""),
    ("step", step(), "Out", 1, "nodal", 1, ""),
    ("key", key(), "LowIn", 1, "mortar", 0, "R"),
    ("key, from touch", key(gap=0), "Low", 1, "mortar", 0.3, ""),
    ("cross", cross(), "In", 1, "mortar", 0, "RT"),
    ("lid", lid(), "Out", 1, "mortar", 0.3, "T"),
    ("barbs", barbs(), "Out", 1, "mortar", 0, "R"))
IN_3D = (
    ("corner of two walls", corner_3d(), "In", 1, "mortar", 0, "RT"),
    ("corner of two walls", corner_3d(block=(2, 2, 1), body=1), "In", 2, "mortar",
     0, ""),
    ("corner of two walls", corner_3d(block=(2, 1, 2), body=3), "Out", 1, "mortar",
     0.3, "T"),
    ("corner of two walls", corner_3d(), "In", 1, "nodal", 0, ""),
    ("corner of two walls, round the ends",
     corner_3d(round_the_ends=True), "Out", 1, "mortar", 0, ""),
    ("corner of two walls, from touch", corner_3d(gap=(0, 0, 0)), "In", 1, "mortar",
     0.3, ""),
    ("beside a wall", corner_3d(1), "In", 1, "mortar", 0, "R"),
    ("beside a wall, slanted sole", corner_3d(1, lean=.05), "Out", 1, "mortar", 1,
     ""),
    ("beside a wall", corner_3d(1), "In", 1, "nodal", 0.3, ""),
    ("tray", tray_3d(), "In", 1, "mortar", 0, "R"),
    ("tray", tray_3d(), "In", 1, "mortar", 0.3, "T"),
    ("tray", tray_3d(block=(2, 1, 1)), "In", 2, "mortar", 0, ""),
    ("tray", tray_3d(), "Out", 1, "nodal", 0.3, ""),
    ("tray with leaning walls", tray_3d(flare=.3, gap=(.01, .01, .01), rims=True),
     "In", 1, "mortar", 0, "T"),
    ("groove", tray_3d(open_ends=True, way=((.03, .02, 0), (0, 0, -.04))), "In", 1,
     "mortar", 0, "R"),
    ("groove", tray_3d(open_ends=True, way=((.03, .02, 0), (0, 0, -.04)),
                       block=(2, 2, 1)), "Out", 2, "mortar", 0.3, ""),
    ("groove, from touch", tray_3d(open_ends=True, gap=(0, .1, 0)), "In", 1,
     "mortar", 1, ""),
    ("cap", cap_3d(), "In", 1, "mortar", 0, ""),
    ("cap", cap_3d(), "Out", 1, "mortar", 0.3, ""),
    ("bracket round a corner", bracket_3d(way=((0, 0, -.03), (0, 0, -.01))), "In",
     1, "mortar", 0.3, "T"),
    ("bracket round a corner", bracket_3d(), "Out", 1, "mortar", 0, "R"),
    ("bracket round an edge", bracket_3d(sides=2), "In", 2, "mortar", 0, ""),
    ("T-slot", tslot_3d(), "In", 1, "mortar", 0, "RT"),
    ("T-slot", tslot_3d(), "In", 1, "mortar", 0.3, ""),
    ("T-slot", tslot_3d(), "Out", 1, "mortar", 0, ""),
    ("step", step_3d(), "In", 1, "mortar", 0.3, ""),
    ("step", step_3d(), "Out", 2, "mortar", 0, ""),
    ("lid", lid_3d(), "Out", 1, "mortar", 0, "T"),
    ("lid", lid_3d(), "In", 1, "mortar", 0.3, ""),
    ("key", key_3d(), "LowIn", 1, "mortar", 0, ""))


def solved(what, scene, settings, entries, cut, **more):
    """A Result, whether it converged and how, and the balance of its forces."""
    result = scene.solve("sides", settings, cut=cut, **more, **entries)
    check(f"  {what}: converges", result.converged() and
          (cut or result.steps <= MOST_STEPS * INCREMENTS),
          (f"{result.steps} Newton steps" + ", a depth is violated" *
           (result.status == 1)) if result.converged() else
          f"{result.status} {result.said[:300]}")
    if result.forces and not result.imbalance() < 1e-8:
        check("    forces are in balance", False, f"{result.imbalance():.1e}")
    return result


# Friction with nodes that slide over edges in 3-D, and corners that sink in between
# two nodes: no result, and said.
# In 2-D a corner of the master that touches two sides of the slave at once has
# a point for the closer one alone.
UNSOLVED = {("3-D", "corner of two walls", "In", "nodal", 0),
            ("3-D", "beside a wall", "In", "nodal", 0.3),
            ("3-D", "key", "LowIn", "mortar", 0)}


def both(*results):
    return all(result.forces for result in results)


def exchanged(scene, settings, entries, cut, first):
    """The roles, on the mesh as it is and refined once, which shows its error."""
    results = {(True, 0): first}
    for refinements in (0, 1):
        for as_it_is in (True, False):
            if (as_it_is, refinements) not in results:
                results[as_it_is, refinements] = solved(
                    f"{'as it is' if as_it_is else 'exchanged'}, refined "
                    f"{refinements} times", scene if as_it_is else scene.exchanged(),
                    settings, {**entries, "Mesh/Refinements": refinements}, cut)
    if not both(*results.values()):
        return

    def difference(one, other):
        return results[one].difference_of_totals(results[other], scene.spins)
    off = [difference((False, r), (True, r)) for r in (0, 1)]
    error = min(difference((role, 0), (role, 1)) for role in (True, False))
    check(f"  roles exchanged: off by {off[0]:.2%}, on the refined mesh by "
          f"{off[1]:.2%}; the error of the meshes: {error:.2%}",
          off[1] < PART_OF_ERROR * error)


def judge(name, scene, slave, degree, rule, friction, also):
    if slave in (pair[1] for pair in scene.pairs):
        scene = scene.exchanged()
    settings = {"Discretization": rule}
    if friction:
        settings["Friction coefficient"] = friction
    entries = {"Element/Degree": degree}
    cells = sum(len(body.cells) for body in scene.bodies)
    print(f"{scene.dim}-D, {name}, slave {slave} of {scene.sides()} sides, degree "
          f"{degree}, {rule}, friction {friction}, {cells} cells", flush=True)
    if (f"{scene.dim}-D", name, slave, rule, friction) in UNSOLVED:
        result = scene.solve("sides", settings, cut=False, **entries)
        check(f"  has no result, with exit status {result.status}",
              result.status in (1, 3), result.said[-300:])
        return
    cut = solved("a pair for each side", scene, settings, entries, True)
    one = cut if by_sides else \
        solved("one group", scene, settings, entries, False)
    if both(one, cut):
        off = one.difference(cut)
        check(f"  one group as a pair for each side: {off:.1e}",
              off < 1e-6)
    if not both(one):
        return
    if "R" in also:
        exchanged(scene, settings, entries, by_sides, one)
    for mirrored in (False, True) if "T" in also else ():
        what = "mirrored and turned" if mirrored else "turned"
        turned = solved(what, scene, settings, entries, by_sides,
                        turned=turn(scene.dim, mirrored))
        if both(turned):
            off = turned.difference(one)
            check(f"  {what}: {off:.1e}", off < 1e-8)


by_sides = "--by-sides" in sys.argv
wanted = [word for word in sys.argv[4:] if word != "--by-sides"]
for row in IN_2D + IN_3D:
    title = f"{row[1].dim}-D, {row[0]}"
    if not wanted or any(word in title for word in wanted):
        judge(*row)
print(f"{len(failures)} failures")
sys.exit(len(failures) > 0)
