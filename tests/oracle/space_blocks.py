"""Scenes of blocks in 3-D."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import math

import numpy as np

from draw import size, swap, uniform
from scene import (EITHER, Formula, HOLD_THEN_RAMP, HOPELESS, RAMP_THEN_HOLD,
                   THERE_AND_BACK)
from space_draw import direction, friction, material, settle, two_blocks
from space_grids import SpaceBody, brick, ticks
from space_scene import SpaceScene


def stiffness(scene):
    return min(young for young, _ in scene.materials.values())


def then_drag(scene, rng, name, length):
    """Sideways in any direction, after the pressing."""
    scene.hold(name, *direction(rng, length))
    scene.histories["Displacement z"] = RAMP_THEN_HOLD
    for axis in "xy":
        scene.histories["Displacement " + axis] = HOLD_THEN_RAMP
    return scene


def blocks(rng, seed):
    """Pressed by displacement, then perhaps dragged in any direction."""
    scene, s = two_blocks(rng, "blocks", seed, rng.choice([0, 0, 0.001]))
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    scene.hold("Up_above", 0, 0, -uniform(rng, 0.002, 0.02) * s)
    if rng.random() < 0.4:
        then_drag(scene, rng, "Up_above", uniform(rng, 0.003, 0.03) * s)
    elif rng.random() < 0.3:
        for axis in "xyz":
            scene.histories["Displacement " + axis] = THERE_AND_BACK
    return settle(rng, scene)


def pressed(rng, seed):
    """By a pressure, guided."""
    scene, s = two_blocks(rng, "pressed", seed)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    scene.hold("Up_above", 0, 0)
    scene.load("Pressure", "Up_above", uniform(rng, 0.0005, 0.01) *
               stiffness(scene))
    return settle(rng, scene)


def carried(rng, seed):
    """Held by friction alone on a base that moves."""
    scene, s = two_blocks(rng, "carried", seed)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng, 0.2))
    p = uniform(rng, 0.001, 0.005) * stiffness(scene)
    scene.load("Pressure", "Up_above", p)
    scene.histories["Pressure"] = RAMP_THEN_HOLD
    scene.hold("Low_below", *direction(rng, uniform(rng, 0.01, 0.2) * s), 0)
    return settle(rng, scene)


def reversal(rng, seed):
    """Pressed, dragged there and back along a way that bends."""
    scene, s = two_blocks(rng, "reversal", seed, most=6)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng, 0.1))
    scene.hold("Up_above", *direction(rng, uniform(rng, 0.002, 0.03) * s),
               -uniform(rng, 0.003, 0.015) * s)
    h = scene.histories
    h["Displacement z"] = Formula("min(1, 4*t)", lambda t: min(1.0, 4 * t))
    h["Displacement x"] = Formula(
        "table(0 0, 0.25 0, 0.5 1, 1 -1)", lambda t: 0.0 if t < 0.25 else
        4 * t - 1 if t < 0.5 else 3 - 4 * t)
    h["Displacement y"] = HOLD_THEN_RAMP
    return settle(rng, scene, (4,))


def matching(rng, seed):
    """Meshes whose nodes lie on each other, or on middles of edges."""
    s, n, k = size(rng), rng.randint(1, 3), rng.choice([1, 1, 2])
    low = brick("Low", (0, 0, 0), (2 * s, 2 * s, 0.6 * s), (
        2 * n, 2 * n, rng.randint(1, 2)))
    x, y = (rng.choice([0, s / n, s, 0.5 * s / n]) for _ in range(2))
    up = brick("Up", (x, y, 0.6 * s), (x + s, y + s, 1.2 * s), (
        k * n, k * n, rng.randint(1, 2)))
    scene = SpaceScene("matching", seed, [low, up], {"Low": material(rng),
                                                     "Up": material(rng)})
    scene.hold("Low_below", 0, 0, 0)
    scene.hold("Up_above", *rng.choice([(0, 0), direction(rng, 0.02 * s)]),
               -uniform(rng, 0.002, 0.1) * 0.1 * s)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    return settle(rng, scene)


def eccentric(rng, seed):
    """Under a pressure that is larger at one end: part lifts off."""
    scene, s = two_blocks(rng, "eccentric", seed)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng, 0.2))
    p = uniform(rng, 0.0005, 0.005) * stiffness(scene)
    a, b = direction(rng, uniform(rng, 0.5, 1.0))
    half = 0.5 * s
    text = "%.10g*(1 + %.10g*(x - %.10g)/%.10g + %.10g*(y - %.10g)/%.10g)" % (
        p, a, half, half, b, half, half)
    scene.load("Pressure", "Up_above", Formula(text, lambda x, y, z: p * (
        1 + a * (x - half) / half + b * (y - half) / half)))
    return settle(rng, scene)


def two_on_one(rng, seed):
    """Two bodies on one ground, in one zone or in two."""
    s = size(rng)
    n = rng.randint(3, 8)
    low = brick("Low", (0, 0, 0), (2 * s, s, 0.5 * s), (n, n // 2 + 1, 2))
    bodies = [brick(name, (x0 * s, y0 * s, 0.5 * s), (x1 * s, y1 * s, s), (
        rng.randint(1, 4), rng.randint(1, 4), 2)) for name, x0, x1, y0, y1 in (
            ("L", 0.1, 0.8, 0.1, 0.7), ("R", 1.1, 1.9, 0.2, 0.9))]
    for body in bodies:
        body.group("Soles", lambda x, y, z, side: side == "below")
    scene = SpaceScene("two_on_one", seed, [low] + bodies, {
        name: material(rng) for name in ("Low", "L", "R")})
    scene.hold("Low_below", 0, 0, 0)
    down = -uniform(rng, 0.002, 0.02) * s
    scene.hold("L_above", 0, 0, down).hold("R_above", *direction(
        rng, rng.choice([0, 0.02 * s])), down)
    mu = friction(rng)
    if rng.random() < 0.5:
        scene.contact(*swap(rng, "Soles", "Low_above"), mu)
    else:
        scene.contact("L_below", "Low_above", mu, "left")
        scene.contact("R_below", "Low_above", mu, "right")
    return settle(rng, scene)


def tipped(name, s, turn, n, shift):
    """A cube that is turned, its lower faces together as NAME_low."""
    body = brick(name, (-s / 2,) * 3, (s / 2,) * 3, n)
    normals = {"left": (-1, 0, 0), "right": (1, 0, 0), "front": (0, -1, 0),
               "back": (0, 1, 0), "below": (0, 0, -1), "above": (0, 0, 1)}
    down = {side: (turn @ np.array(v))[2] for side, v in normals.items()}
    body.group(name + "_low", lambda x, y, z, side: down[side] < -0.3)
    body.group(name + "_high", lambda x, y, z, side: down[side] > 0.3)
    body.placed(turn, (0, 0, 0))
    lowest = min(x[2] for x in body.X)
    return body.placed(shift=(*shift, -lowest))


def about(axis, angle):
    c, s = math.cos(angle), math.sin(angle)
    R = np.eye(3)
    a, b = [k for k in range(3) if k != axis]
    R[a, a] = R[b, b] = c
    R[a, b], R[b, a] = -s, s
    return R


def standing(rng, kind, seed, turn):
    s = size(rng)
    n = rng.randint(2, 4)
    up = tipped("Up", 0.6 * s, turn, (n, n, n), direction(rng, 0.1 * s))
    low = brick("Low", (-s, -s, -0.6 * s), (s, s, 0), (
        rng.randint(3, 6), rng.randint(3, 6), 2))
    scene = SpaceScene(kind, seed, [low, up], {
        "Low": material(rng, False), "Up": material(rng, False)})
    scene.hold("Low_below", 0, 0, 0)
    scene.hold("Up_high", 0, 0, -uniform(rng, 0.001, 0.02) * s)
    scene.contact(*swap(rng, "Up_low", "Low_above"), friction(rng))
    if rng.random() < 0.3:
        then_drag(scene, rng, "Up_high", uniform(rng, 0.002, 0.02) * s)
    return settle(rng, scene, levels=False)


def corner(rng, seed):
    """A corner on a face."""
    return standing(rng, "corner", seed, about(2, rng.uniform(0, 2)) @ about(
        1, math.atan(math.sqrt(0.5)) + rng.uniform(-0.1, 0.1)) @ about(
            0, math.pi / 4 + rng.uniform(-0.1, 0.1)))


def edge(rng, seed):
    """An edge on a face, along a line of nodes or across."""
    return standing(rng, "edge", seed, about(2, rng.choice(
        [0, 0, rng.uniform(0, 2)])) @ about(0, math.pi / 4 + rng.choice(
            [0, rng.uniform(-0.3, 0.3)])))


def overlap(rng, seed):
    """Partly overlapping surfaces, perhaps dragged over the rim."""
    s = size(rng)
    n, m = ([rng.randint(1, 5) for _ in range(2)] for _ in range(2))
    low = brick("Low", (0, 0, 0), (s, s, 0.5 * s), (*n, 2))
    x, y = (uniform(rng, -0.7, 0.7) * s for _ in range(2))
    up = brick("Up", (x, y, 0.5 * s), (x + s, y + s, s), (*m, 2))
    scene = SpaceScene("overlap", seed, [low, up], {"Low": material(rng),
                                                    "Up": material(rng)})
    scene.hold("Low_below", 0, 0, 0)
    scene.hold("Up_above", 0, 0, -uniform(rng, 0.002, 0.02) * s)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    increments = (1, 2)
    if rng.random() < 0.3:
        then_drag(scene, rng, "Up_above", uniform(rng, 0.02, 0.2) * s)
        increments = (2, 4)
    return settle(rng, scene, increments)


def ratio(rng, seed):
    """Cells up to eight times as large as those that they touch."""
    s, k = size(rng), rng.choice([4, 8])
    coarse, fine = rng.choice([(1, k), (2, 2 * k)])
    n, m = (coarse, fine) if rng.random() < 0.5 else (fine, coarse)
    low = brick("Low", (0, 0, 0), (s, s, 0.5 * s), (n, n, 1))
    up = brick("Up", (0.1 * s, 0.2 * s, 0.5 * s), (0.8 * s, 0.9 * s, s), (
        m, m, 1))
    scene = SpaceScene("ratio", seed, [low, up], {"Low": material(rng),
                                                  "Up": material(rng)})
    scene.hold("Low_below", 0, 0, 0)
    scene.hold("Up_above", *direction(rng, rng.choice([0, 0.01 * s])),
               -uniform(rng, 0.002, 0.02) * s)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    return settle(rng, scene, (1, 2))


def stack(rng, seed):
    """Three blocks, the middle one held by friction alone."""
    s = size(rng)
    height, bodies = 0.0, []
    for name in "ABC":
        h = uniform(rng, 0.2, 0.5) * s
        inset = uniform(rng, 0.0, 0.2) * s
        n = [rng.randint(1, 4) for _ in range(3)]
        bodies.append(brick(name, (inset, inset, height), (
            s - inset, s - 0.5 * inset, height + h), n))
        height += h
    scene = SpaceScene("stack", seed, bodies, {b.name: material(rng)
                                               for b in bodies})
    scene.hold("A_below", 0, 0, 0)
    mu = friction(rng, 0.2)
    scene.contact(*swap(rng, "B_below", "A_above"), mu, "low")
    scene.contact(*swap(rng, "C_below", "B_above"), mu, "upp")
    scene.hold("C_above", 0, 0, -uniform(rng, 0.002, 0.02) * s)
    if rng.random() < 0.4:
        then_drag(scene, rng, "C_above", uniform(rng, 0.001, 0.02) * s)
    return settle(rng, scene)


def glued(rng, seed):
    """Glued on each other, pressed, pulled or sheared."""
    scene, s = two_blocks(rng, "glued", seed)
    scene.contact(*swap(rng, "Up_below", "Low_above"), 0.0, tied=True)
    scene.hold("Up_above", *direction(rng, uniform(rng, 0, 0.02) * s),
               uniform(rng, -0.02, 0.02) * s)
    return settle(rng, scene)


def wedge(rng, seed):
    """A wedge pressed between two blocks: two zones."""
    s = size(rng)
    slope = uniform(rng, 0.2, 0.6)
    n = rng.randint(2, 4)

    def side(name, sign):
        def shape(x, y, z):
            inner = sign * slope * z
            return (inner + sign * x if sign > 0 else inner + sign * (s - x),
                    y, z)
        return SpaceBody(name, ticks(0, 2, s), ticks(0, rng.randint(2, 5), s),
                         ticks(0.2 * s, rng.randint(2, 5), 1.2 * s),
                         shape=shape).sides()
    left, right = side("L", -1), side("R", 1)
    wedge_ = SpaceBody("W", ticks(-1, n, 1), ticks(0.1 * s, n, 0.8 * s),
                       ticks(0.4 * s, n, s), shape=lambda x, y, z: (
                           x * slope * z, y, z)).sides()
    scene = SpaceScene("wedge", seed, [left, right, wedge_], {
        name: material(rng, False) for name in ("L", "R", "W")})
    scene.hold("L_left R_right", 0, 0, 0)
    scene.hold("W_above", 0, 0, -uniform(rng, 0.002, 0.02) * s)
    mu = friction(rng)
    scene.contact(*swap(rng, "W_left", "L_right"), mu, "left")
    scene.contact(*swap(rng, "W_right", "R_left"), mu, "right")
    return settle(rng, scene)


# What has no solution, or only by chance.
def pulled_off(rng, seed):
    """Nothing holds the upper block against what pulls it."""
    scene, s = two_blocks(rng, "pulled_off", seed, most=5)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    scene.load("Resultant force " + rng.choice("xyz"), "Up_above", uniform(
        rng, 0.001, 0.01) * stiffness(scene) * s * s)
    scene.expected = HOPELESS
    return settle(rng, scene, (1, 2))


def neutral(rng, seed):
    """Without friction on flat ground, and nothing sideways: it may stay where
    it is, or be named."""
    scene, s = two_blocks(rng, "neutral", seed, most=5)
    scene.contact(*swap(rng, "Up_below", "Low_above"), 0.0)
    scene.load("Body force z", "Up", -uniform(rng, 0.0005, 0.005) *
               stiffness(scene) / s)
    scene.expected = EITHER
    return settle(rng, scene, (1, 2))


def loose(rng, seed):
    """One body of two pieces, one of which nothing holds but contact, or
    nothing at all."""
    s = size(rng)
    n = rng.randint(2, 4)
    low = brick("Low", (0, 0, 0), (s, s, 0.4 * s), (2 * n, n, 1))
    up = SpaceBody("Up", ticks(0, n, 0.45 * s, 1, 0.55 * s, n, s),
                   ticks(0.1 * s, 2, 0.8 * s), ticks(0.4 * s, 2, 0.8 * s),
                   keep=lambda x, y, z: not 0.45 * s < x < 0.55 * s).sides()
    up.group("Held", lambda x, y, z, side: side == "above" and x < 0.5 * s)
    scene = SpaceScene("loose", seed, [low, up], {"Low": material(rng),
                                                  "Up": material(rng)})
    scene.hold("Low_below", 0, 0, 0)
    scene.hold("Held", 0, 0, -uniform(rng, 0.002, 0.02) * s)
    if rng.random() < 0.6:
        scene.load("Body force z", "Up", -1e-4 * stiffness(scene) / s)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    scene.expected = EITHER
    return settle(rng, scene, (1, 2))


def beam(rng, seed):
    """A slender beam, bent by its end, or on a block that it bends over."""
    s = size(rng)
    n = rng.randint(8, 16)
    thick = 0.06 * s
    bar = brick("Bar", (0, 0, 0), (s, 0.1 * s, thick), (n, 1, rng.randint(1, 2)))
    bodies, materials = [bar], {"Bar": material(rng)}
    touches = rng.random() < 0.6
    if touches:
        x = uniform(rng, 0.4, 0.8) * s
        bodies.append(brick("Low", (x, -0.05 * s, -0.2 * s), (
            x + 0.3 * s, 0.15 * s, 0), (rng.randint(1, 4), rng.randint(1, 3),
                                        2)))
        materials["Low"] = material(rng)
    scene = SpaceScene("beam", seed, bodies, materials)
    scene.hold("Bar_left", 0, 0, 0)
    if touches:
        scene.hold("Low_below", 0, 0, 0)
        scene.contact(*swap(rng, "Bar_below", "Low_above"), friction(rng))
    scene.hold("Bar_right", 0 if touches else None, None,
               -uniform(rng, 0.01, 0.05) * s)
    return settle(rng, scene, (2, 4), levels=False)


KINDS = (blocks, pressed, carried, reversal, matching, eccentric, two_on_one,
         corner, edge, overlap, ratio, stack, glued, wedge, pulled_off, neutral,
         loose, beam)
