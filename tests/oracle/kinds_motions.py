"""Scenes of rigid boundaries, of obstacles that move or are pushed, of bolts."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import math

from draw import (friction, material, new_bodies, settle, settle_new, size,
                  split, swap, uniform)
from grids import Body, block, ticks
from kinds_blocks import stiffness, two_blocks
from scene import (EITHER, HOLD_THEN_RAMP, RAMP, RAMP_THEN_HOLD, Scene, TENT,
                   scaled)


def platen(rng, seed):
    """The head of the upper block, or the end of a beam, is rigid: pressed by a
    force beside its middle, turned, or by a moment."""
    scene, s = two_blocks(rng, "platen", seed)
    X = scene.mesh.X
    head = sorted({n for line in scene.mesh.lines["Up_above"] for n in line})
    scene.mesh.points["P"] = rng.choice(head)
    width = X[head, 0].max() - X[head, 0].min()
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    settle_new(rng, scene, (2, 4), 0.5)
    scene.make_rigid("Up_above", "P")
    scene.load("Displacement x", "Up_above", rng.choice([0, uniform(
        rng, -0.005, 0.005) * s]))
    if rng.random() < 0.5:
        scene.load("Displacement y", "Up_above",
                   -uniform(rng, 0.003, 0.015) * s)
    else:
        soft = min([stiffness(scene)] + [
            200 * law.initial for law in scene.laws.values()
            if law.has_history])
        force = uniform(rng, 0.0005, 0.005) * soft * width
        scene.load("Force y", "Up_above", -force)
    if rng.random() < 0.5:
        scene.load("Rotation z", "Up_above", uniform(rng, -0.01, 0.01))
    elif "Force y" in scene.boundary:
        # As if the force were within the middle half of the width.
        middle = X[head, 0].mean() + uniform(rng, -0.2, 0.2) * width
        arm = middle - X[scene.mesh.points["P"], 0]
        scene.load("Moment z", "Up_above", -arm * force)
        if not scene.large:
            # It may tilt by more than small strain is made for.
            scene.expected = EITHER
    return scene


def rigid_end(rng, seed):
    """A beam whose end is rigid, without contact: bent by a moment, a turn of
    any size, forces."""
    length = size(rng)
    h = length / uniform(rng, 3, 15)
    body = block("Beam", 0, 0, length, h, rng.randint(6, 14),
                 rng.randint(1, 2), split(rng))
    scene = Scene("rigid_end", seed, [body], {"Beam": material(rng)})
    scene.mesh.points["P"] = rng.choice(sorted(
        {n for line in scene.mesh.lines["Beam_right"] for n in line}))
    scene.hold("Beam_left", 0, 0)
    settle_new(rng, scene, (4, 8), 0.5)
    scene.make_rigid("Beam_right", "P")
    young = scene.materials["Beam"][0]
    bends = young * h ** 3 / 12 / length
    if any(law.has_history for law in scene.laws.values()):
        bends = min(bends, 0.5 * scene.laws["Beam"].initial * h * h / 6)
    turn = uniform(rng, -1, 1) * (1.5 if scene.large else 0.1)
    if rng.random() < 0.5:
        scene.load("Rotation z", "Beam_right", turn)
    else:
        scene.load("Moment z", "Beam_right", turn * bends)
    if rng.random() < 0.4:
        scene.load("Force y", "Beam_right",
                   uniform(rng, -0.2, 0.2) * bends / length)
    elif rng.random() < 0.3:
        scene.load("Displacement y", "Beam_right",
                   uniform(rng, -0.1, 0.1) * length)
    return scene


def body_and_obstacle(rng, kind, seed, down):
    """A block, and a plane, a leaning one or a circle above it, which goes down
    by a part of its width: an edge spans less of the circle."""
    s = size(rng)
    h = uniform(rng, 0.4, 1) * s
    shape = rng.choice(["plane", "leaning", "circle", "circle"])
    n, radius = rng.randint(3, 10), uniform(rng, 0.4, 3) * s
    if shape == "circle":
        n = max(n, math.ceil((s / (1.6 * radius * down)) ** 0.5))
    body = block("Body", 0, 0, s, h, n, rng.randint(1, 5), split(rng))
    scene = Scene(kind, seed, [body], {"Body": material(rng)})
    scene.hold("Body_below", 0, 0)
    if shape == "circle":
        x = uniform(rng, 0.3, 0.7) * s
        return scene, s, "circle: %.12g, %.12g, %.12g" % (
            x, h + radius, radius), (x, h + radius)
    lean = 0 if shape == "plane" else uniform(rng, -0.05, 0.05)
    return scene, s, "half plane: %.12g, %.12g, %.12g, -1" % (
        0.5 * s, h + 0.5 * s * abs(lean), lean), (0.5 * s, h)


def moved(rng, seed):
    """An obstacle comes down, then passes along the block or turns; there and
    back."""
    down = uniform(rng, 0.004, 0.02)
    scene, s, text, centre = body_and_obstacle(rng, "moved", seed, down)
    circle = text.startswith("circle")
    motion = {"y": scaled(-down * s, rng.choice([RAMP_THEN_HOLD, TENT, RAMP]))}
    if rng.random() < 0.6:
        motion["x"] = scaled(uniform(rng, -0.05, 0.05) * s, HOLD_THEN_RAMP)
    if rng.random() < (0.6 if circle else 0.4):
        most = 40 if circle else 1.5
        motion["angle"] = scaled(uniform(rng, -1, 1) * most, rng.choice(
            [HOLD_THEN_RAMP, RAMP]))
    scene.contact("Body_above", None, friction(rng), obstacle=text,
                  motion=motion, centre=rng.choice([None, centre]))
    return settle_new(rng, scene, (4, 8), 0.5)


def driven(rng, seed):
    """A force presses an obstacle on the block, then perhaps pushes it along
    within the friction, or a moment tilts or turns it."""
    scene, s, text, centre = body_and_obstacle(rng, "driven", seed, 0.004)
    circle = text.startswith("circle")
    mu = friction(rng)
    settle_new(rng, scene, (4, 8), 0.5)
    soft = min([stiffness(scene)] + [200 * law.initial for law in
                                     scene.laws.values() if law.has_history])
    press = uniform(rng, 0.0005, 0.005) * soft * s
    force = {"y": scaled(-press, RAMP_THEN_HOLD)}
    motion = {}
    if mu and rng.random() < 0.6:
        force["x"] = scaled(uniform(rng, -0.7, 0.7) * mu * press,
                            HOLD_THEN_RAMP)
    if circle and mu and "x" not in force and rng.random() < 0.5:
        radius = float(text.split(",")[-1])
        force["moment"] = scaled(uniform(rng, -0.7, 0.7) * mu * press * radius,
                                 HOLD_THEN_RAMP)
    elif not circle and rng.random() < 0.5:
        force["moment"] = scaled(-uniform(rng, -0.2, 0.2) * s * press,
                                 RAMP_THEN_HOLD)
    elif "x" not in force and rng.random() < 0.3:
        motion["x"] = scaled(uniform(rng, -0.03, 0.03) * s, HOLD_THEN_RAMP)
    # The start is at a distance, which the force closes.
    if rng.random() < 0.3:
        kind, numbers = text.split(": ")
        values = [float(v) for v in numbers.split(",")]
        values[1] += 0.02 * s
        text = kind + ": " + ", ".join("%.12g" % v for v in values)
        centre = (centre[0], centre[1] + 0.02 * s)
    scene.contact("Body_above", None, mu, obstacle=text, force=force,
                  motion=motion, centre=centre)
    return scene


def bolt(rng, seed):
    """A bolt in two halves with a preload in its cut, around it a sleeve that
    its head presses on; then the head is loaded."""
    s = size(rng)
    n = rng.randint(2, 5)
    low = block("Lower", -0.3 * s, 0, 0.3 * s, s, n, 3)
    # The upper half has a head that overhangs.
    up = Body("Upper", ticks(-0.8 * s, 2, -0.3 * s, n, 0.3 * s, 2, 0.8 * s),
              ticks(s, 2, 2 * s, 2, 2.5 * s),
              keep=lambda x, y: y > 2 * s or abs(x) < 0.3 * s)
    up.group("Cut", lambda x, y, side: side == "below" and y < 1.5 * s)
    up.group("Seat", lambda x, y, side: side == "below" and y > 1.5 * s)
    up.group("Head", lambda x, y, side: side == "above")
    left = block("Left", -0.9 * s, 0, -0.4 * s, 2 * s, rng.randint(1, 3), 4)
    right = block("Right", 0.4 * s, 0, 0.9 * s, 2 * s, rng.randint(1, 3), 4)
    for body in (left, right):
        body.group("Rim", lambda x, y, side: side == "above")
        body.group("Base", lambda x, y, side: side == "below")
    scene = Scene("bolt", seed, [low, up, left, right], {
        name: material(rng, False) for name in ("Lower", "Upper", "Left",
                                                "Right")})
    scene.hold("Lower_below Base", 0, 0)
    settle(rng, scene, (4, 8))
    if scene.rule == "Gauss":
        scene.rule = "mortar"
    scene.middles_in = "Nodes"
    if rng.random() < 0.4:
        new_bodies(rng, scene, ("plastic",))
    soft = min([stiffness(scene)] + [200 * law.initial for law in
                                     scene.laws.values() if law.has_history])
    tension = uniform(rng, 0.0005, 0.003) * soft * s
    end = rng.choice([1.0, 0.5])
    scene.contact("Cut", "Lower_above", 0.0, "cut", tied=True, preload=scaled(
        tension, RAMP_THEN_HOLD), preload_end=end)
    scene.contact(*swap(rng, "Seat", "Rim"), friction(rng), "seat")
    if rng.random() < 0.6:
        scene.load("Resultant force y", "Head", uniform(rng, -1, 0.6) * tension)
        scene.histories["Resultant force y"] = HOLD_THEN_RAMP
    return scene


KINDS = (platen, rigid_end, moved, driven, bolt)
