"""Scenes of machine parts: rollers, seals, joints, spheres, clamped blocks; and
what has to be refused."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import math

from draw import friction, material, settle, size, split, swap, uniform
from grids import Body, block, ticks
from kinds_blocks import stiffness, two_blocks
from scene import (EITHER, Formula, HOLD_THEN_RAMP, RAMP_THEN_HOLD, REFUSED,
                   Scene)


def half_disk(name, x, y, radius, n, m, below=True):
    """The lower (upper) half of a wheel with the centre (x, y): from the hub to
    the round side."""
    sign = 1 if below else -1

    def shape(u, v):
        angle, r = math.pi * (u - 0.5), radius * (0.4 + 0.6 * v)
        return x + r * math.sin(angle), y - sign * r * math.cos(angle)
    # From right to left, so that cells are anticlockwise.
    us = ticks(0, n, 1)
    body = Body(name, us if not below else us[::-1], ticks(0, m, 1),
                shape=shape)
    body.group(name + "_arc", lambda x, y, side: side == "above")
    body.group(name + "_flat", lambda x, y, side: side != "above")
    return body


def roller(rng, seed):
    """Half a roller pressed into a block, then dragged along."""
    s = size(rng)
    radius = 0.4 * s
    wheel = half_disk("Wheel", 0, radius, radius, rng.choice([8, 12, 16]), 2)
    low = block("Low", -s, -0.5 * s, s, 0, rng.randint(10, 24),
                rng.randint(2, 4), split(rng))
    scene = Scene("roller", seed, [low, wheel], {
        "Low": material(rng, False), "Wheel": material(rng, False)},
        arcs={"Wheel_arc": (0, radius, radius)})
    scene.hold("Low_below", 0, 0)
    scene.hold("Wheel_flat", uniform(rng, -0.3, 0.3) * s,
               -uniform(rng, 0.003, 0.02) * s)
    scene.histories["Displacement y"] = RAMP_THEN_HOLD
    scene.histories["Displacement x"] = HOLD_THEN_RAMP
    scene.contact(*swap(rng, "Wheel_arc", "Low_above"), friction(rng))
    return settle(rng, scene, (4, 8, 12))


def cylinders(rng, seed):
    """Two half cylinders, one above the other and perhaps beside it."""
    s = size(rng)
    radius = uniform(rng, 0.5, 2) * s
    up = half_disk("Up", 0, s, s, rng.choice([6, 10, 14]), 2)
    low = half_disk("Low", 0, -radius, radius, rng.choice([6, 10, 14]), 2,
                    below=False)
    scene = Scene("cylinders", seed, [low, up], {
        "Low": material(rng), "Up": material(rng)},
        arcs={"Up_arc": (0, s, s), "Low_arc": (0, -radius, radius)})
    scene.hold("Low_flat", 0, 0)
    scene.hold("Up_flat", rng.choice([0, uniform(rng, -0.02, 0.02) * s]),
               -uniform(rng, 0.003, 0.03) * s)
    scene.contact(*swap(rng, "Up_arc", "Low_arc"), friction(rng))
    return settle(rng, scene)


def disk(name, radius, n, m):
    """A disk about the origin: a square in the middle of rings."""
    def shape(u, v):
        r = max(abs(u), abs(v))
        if r == 0:
            return 0.0, 0.0
        # The square in the middle bulges on its way to the circle.
        round_ = radius * r / math.hypot(u, v)
        blend = r
        return (u * ((1 - blend) * radius * 0.8 + blend * round_),
                v * ((1 - blend) * radius * 0.8 + blend * round_))
    body = Body(name, ticks(-1, n, 1), ticks(-1, n, 1), shape=shape)
    body.group(name + "_skin", lambda x, y, side: True)
    for side in ("below", "above", "left", "right"):
        body.group(name + "_" + side, lambda x, y, s, side=side: s == side)
    return body


def seal(rng, seed):
    """A round seal between floor, lid, and perhaps a wall: one zone for all, or
    zones that share nodes."""
    s = size(rng)
    ring = disk("Seal", 0.5 * s, rng.choice([4, 6, 8]), 2)
    n = rng.randint(4, 10)
    floor = block("Floor", -0.8 * s, -0.8 * s, 0.8 * s, -0.5 * s, n, 1)
    lid = block("Lid", -0.8 * s, 0.5 * s, 0.8 * s, 0.8 * s, n, 1)
    scene = Scene("seal", seed, [ring, floor, lid], {
        "Seal": rng.choice([(5, 0.49), (5, 0.45), (500, 0.42)]),
        "Floor": (210000, 0.3), "Lid": (210000, 0.3)},
        arcs={"Seal_skin": (0, 0, 0.5 * s)})
    scene.hold("Floor_below", 0, 0)
    scene.hold("Lid_above", 0, -uniform(rng, 0.02, 0.15) * s)
    mu = friction(rng, 0.1)
    scene.contact("Seal_below", "Floor_above", mu, "floor")
    scene.contact("Seal_above", "Lid_below", mu, "lid")
    return settle(rng, scene, (4, 8), large=True)


def joint(rng, seed):
    """Two plates lapped, clamped by a pressure, then pulled."""
    s = size(rng)
    n = rng.randint(4, 10)
    low = block("Low", 0, 0, s, 0.1 * s, 2 * n, 1)
    up = Body("Up", ticks(0.4 * s, 2, 0.55 * s, n, 0.85 * s, n, 1.4 * s),
              ticks(0.1 * s, 1, 0.2 * s))
    up.group("Up_below", lambda x, y, side: side == "below")
    up.group("Up_right", lambda x, y, side: side == "right")
    up.group("Washer", lambda x, y, side: side == "above" and
             0.55 * s < x < 0.85 * s)
    bed = block("Bed", 0.3 * s, -0.3 * s, s, 0, n, 2)
    scene = Scene("joint", seed, [low, up, bed], {
        "Low": material(rng, False), "Up": material(rng, False),
        "Bed": material(rng, False)})
    scene.hold("Low_left Bed_below", 0, 0)
    scene.hold("Up_right", uniform(rng, 0.0005, 0.005) * s, 0)
    scene.load("Pressure", "Washer", uniform(rng, 0.0002, 0.001) *
               stiffness(scene))
    scene.histories["Pressure"] = RAMP_THEN_HOLD
    scene.histories["Displacement x"] = HOLD_THEN_RAMP
    mu = friction(rng, 0.1)
    scene.contact("Low_above", "Up_below", mu, "plates")
    scene.contact("Bed_above", "Low_below", mu, "bed")
    return settle(rng, scene, (4, 8))


def sphere(rng, seed):
    """Half a hollow ball on a foundation or on a rigid plane (axisymmetric)."""
    s = size(rng)
    n, m = rng.randint(4, 10), rng.randint(2, 3)

    def shape(u, v):
        angle, r = 0.5 * math.pi * u, s * (0.4 + 0.6 * v)
        return r * math.sin(angle), s - r * math.cos(angle)
    ball = Body("Ball", ticks(1, n, 0), ticks(0, m, 1), shape=shape)
    ball.group("Ball_skin", lambda x, y, side: side == "above")
    ball.group("Ball_flat", lambda x, y, side: side == "below")
    bodies, materials = [ball], {"Ball": material(rng, False)}
    rigid = rng.random() < 0.3
    if not rigid:
        bodies.append(block("Low", 0, -s, 1.5 * s, 0, rng.randint(4, 12), 3))
        materials["Low"] = material(rng, False)
    scene = Scene("sphere", seed, bodies, materials,
                  arcs={"Ball_skin": (0, s, s)})
    scene.entries["Solids/Symmetry"] = "axisymmetric"
    scene.hold("Ball_flat", None, -uniform(rng, 0.002, 0.02) * s)
    if rigid:
        scene.contact("Ball_skin", None, friction(rng),
                      obstacle="half plane: 0, 0, 0, 1")
    else:
        scene.hold("Low_below", 0, 0)
        scene.contact(*swap(rng, "Ball_skin", "Low_above"), friction(rng))
    return settle(rng, scene)


def matching(rng, seed):
    """Meshes whose nodes lie on each other, or on middles of edges."""
    s, n, k = size(rng), rng.randint(2, 6), rng.choice([1, 1, 2])
    low = block("Low", 0, 0, 2 * s, 0.6 * s, 2 * n, rng.randint(1, 4))
    left = rng.choice([0, s / n, s, 0.5 * s / n])
    up = block("Up", left, 0.6 * s, left + s, 1.2 * s, k * n,
               rng.randint(1, 4))
    scene = Scene("matching", seed, [low, up], {"Low": material(rng),
                                                "Up": material(rng)})
    scene.hold("Low_below", 0, 0)
    scene.hold("Up_above", rng.choice([0, uniform(rng, -0.02, 0.02) * s]),
               -uniform(rng, 0.002, 0.3) * 0.1 * s)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    return settle(rng, scene)


def eccentric(rng, seed):
    """A block under a pressure that is larger at one end: part lifts off."""
    scene, s = two_blocks(rng, "eccentric", seed)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng, 0.2))
    p = uniform(rng, 0.0005, 0.005) * stiffness(scene)
    width = uniform(rng, 0.5, 1.0)
    text = "%.10g*(1 + %.10g*(x - %.10g)/%.10g)" % (
        p, width, 0.5 * s, 0.5 * s)
    scene.load("Pressure", "Up_above", Formula(
        text, lambda x, y: p * (1 + width * (x - 0.5 * s) / (0.5 * s))))
    return settle(rng, scene)


def neutral(rng, seed):
    """Without friction on flat ground, and nothing sideways: it may stay where
    it is, or be named."""
    scene, s = two_blocks(rng, "neutral", seed)
    scene.contact(*swap(rng, "Up_below", "Low_above"), 0.0)
    scene.load("Body force y", "Up", -uniform(rng, 0.0005, 0.005) *
               stiffness(scene) / s)
    scene.expected = EITHER
    return settle(rng, scene)


def two_on_one(rng, seed):
    """Two bodies on one ground, in one zone or in two."""
    s = size(rng)
    low = block("Low", 0, 0, 2 * s, 0.5 * s, rng.randint(4, 14),
                rng.randint(1, 3))
    left = block("L", 0.1 * s, 0.5 * s, 0.8 * s, s, rng.randint(1, 6), 2,
                 split(rng))
    right = block("R", 1.1 * s, 0.5 * s, 1.9 * s, 1.2 * s, rng.randint(1, 6), 2)
    for body in (left, right):
        body.group("Soles", lambda x, y, side: side == "below")
    scene = Scene("two_on_one", seed, [low, left, right], {
        name: material(rng) for name in ("Low", "L", "R")})
    scene.hold("Low_below", 0, 0)
    down = -uniform(rng, 0.002, 0.02) * s
    scene.hold("L_above", 0, down).hold("R_above", rng.choice(
        [0, uniform(rng, -0.02, 0.02) * s]), down)
    mu = friction(rng)
    if rng.random() < 0.5:
        scene.contact(*swap(rng, "Soles", "Low_above"), mu)
    else:
        scene.contact("L_below", "Low_above", mu, "left")
        scene.contact("R_below", "Low_above", mu, "right")
    return settle(rng, scene)


def reversal(rng, seed):
    """Pressed, dragged there and back, with friction."""
    scene, s = two_blocks(rng, "reversal", seed)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng, 0.1))
    scene.hold("Up_above", uniform(rng, 0.002, 0.03) * s,
               -uniform(rng, 0.003, 0.015) * s)
    scene.histories["Displacement y"] = Formula(
        "min(1, 4*t)", lambda t: min(1.0, 4 * t))
    scene.histories["Displacement x"] = Formula(
        "table(0 0, 0.25 0, 0.5 1, 1 -1)", lambda t: 0.0 if t < 0.25 else
        4 * t - 1 if t < 0.5 else 3 - 4 * t)
    return settle(rng, scene, (4, 8))


def own_master(rng, seed):
    """A slave with lines of the body of its master: to be refused."""
    scene, s = two_blocks(rng, "own_master", seed)
    mesh = scene.mesh
    mesh.lines["Both"] = mesh.lines["Up_below"] + mesh.lines["Low_left"]
    scene.hold("Up_above", 0, -0.01 * s)
    scene.contact("Both", "Low_above", friction(rng))
    scene.expected = REFUSED
    return settle(rng, scene)


KINDS = (roller, cylinders, seal, joint, sphere, matching, eccentric, neutral,
         two_on_one, reversal, own_master)
