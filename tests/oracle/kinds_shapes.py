"""Scenes with corners, wedges, rings, rounds, beams, press fits, obstacles."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import math

from draw import (friction, log_uniform, material, settle, size, split, swap,
                  uniform)
from grids import Body, block, ticks
from kinds_blocks import stiffness
from scene import (EITHER, HOLD_THEN_RAMP, RAMP_THEN_HOLD, Scene,
                   THERE_AND_BACK)


def round_corner(rng, seed):
    """A pedestal whose group goes round its corners, below a plate."""
    s = size(rng)
    n = rng.randint(2, 6)
    pedestal = Body("Ped", ticks(-0.3 * s, n, 0.3 * s), ticks(
        0, rng.randint(2, 5), 0.5 * s))
    pedestal.group("Base", lambda x, y, side: side == "below")
    choice = rng.choice(["all", "upper", "top"])
    pedestal.group("Skin", lambda x, y, side: side == "above" or (
        side != "below" and (choice == "all" or choice == "upper" and
                             y > 0.25 * s)))
    plate = block("Plate", -uniform(rng, 0.5, 0.9) * s, 0.5 * s,
                  uniform(rng, 0.5, 0.9) * s, 0.7 * s, rng.randint(3, 12), 2)
    scene = Scene("round_corner", seed, [pedestal, plate], {
        "Ped": material(rng, False), "Plate": material(rng, False)})
    scene.hold("Base", 0, 0)
    scene.hold("Plate_above", 0)
    if rng.random() < 0.5:
        scene.load("Pressure", "Plate_above", uniform(rng, 0.0002, 0.002) *
                   stiffness(scene))
    else:
        scene.hold("Plate_above", 0, -uniform(rng, 0.001, 0.01) * s)
    scene.contact(*swap(rng, "Plate_below", "Skin"), friction(rng))
    return settle(rng, scene)


def corner(rng, seed):
    """A square that stands on its corner, or a blunt wedge, on flat ground."""
    s = size(rng)
    tip = uniform(rng, 0.2, 1.0)
    n = rng.randint(2, 5)
    turn = uniform(rng, -0.2, 0.2)

    def shape(x, y):
        # The unit square on its corner, flattened, leaning.
        a, b = (x - y) / 2, tip * (x + y) / 2
        return s * (a * math.cos(turn) - b * math.sin(turn)), s * (
            0.5 + a * math.sin(turn) + b * math.cos(turn))
    square = Body("Square", ticks(0, n, 1), ticks(0, n, 1), shape=shape)
    square.group("Skin", lambda x, y, side: side in ("below", "left"))
    square.group("Head", lambda x, y, side: side in ("above", "right"))
    low = block("Low", -0.5 * s, 0, 0.5 * s, 0.5 * s, rng.randint(3, 12), 3)
    scene = Scene("corner", seed, [low, square], {"Low": material(rng, False),
                                                  "Square": material(rng)})
    scene.hold("Low_below", 0, 0)
    scene.hold("Head", 0, -uniform(rng, 0.002, 0.03) * s)
    scene.contact(*swap(rng, "Skin", "Low_above"), friction(rng))
    return settle(rng, scene)


def wedge(rng, seed):
    """Driven into a slot, two zones; perhaps taken back."""
    s = size(rng)
    slope = uniform(rng, 0.05, 0.5)
    n = rng.randint(2, 6)

    def flank(x, y):
        return (0.2 + slope * y) * s * x, s * y
    body = Body("Wedge", ticks(-1, 2, 1), ticks(0.1, n, 0.9), shape=flank)
    body.group("Head", lambda x, y, side: side == "above")
    body.group("WedgeLeft", lambda x, y, side: side == "left")
    body.group("WedgeRight", lambda x, y, side: side == "right")
    m = rng.randint(2, 8)
    sides = []
    for name, sign in (("Left", -1), ("Right", 1)):
        # From the flank to a straight outer side.
        def side_of(x, y, sign=sign):
            inner = 0.2 + slope * y
            return sign * s * (inner + (x if sign > 0 else 1 - x) *
                               (0.8 - inner + slope)), s * y
        wall = Body(name, ticks(0, 2, 1), ticks(0, m, 1), shape=side_of)
        inside = "left" if sign > 0 else "right"
        outside = "right" if sign > 0 else "left"
        wall.group(name + "Flank", lambda x, y, s, i=inside: s == i)
        wall.group("Outer", lambda x, y, s, o=outside: s == o)
        sides.append(wall)
    scene = Scene("wedge", seed, [body] + sides, {
        "Wedge": material(rng, False), "Left": material(rng, False),
        "Right": material(rng, False)})
    scene.hold("Outer", 0, 0)
    scene.hold("Head", None if rng.random() < 0.5 else 0,
               -uniform(rng, 0.002, 0.02) * s)
    mu = friction(rng)
    for name in ("Left", "Right"):
        scene.contact(*swap(rng, "Wedge" + name, name + "Flank"), mu,
                      name.lower())
    if rng.random() < 0.3:
        scene.histories["Displacement y"] = THERE_AND_BACK
    return settle(rng, scene, (2, 4, 8))


def annulus(name, inner, outer, around, across, begin=0.0, end=2 * math.pi):
    """A ring about the origin, or a part of it."""
    closed = end - begin > 6.28
    body = Body(name, ticks(end, around, begin), ticks(
        inner, across, outer), closed=closed, shape=lambda a, r: (
            r * math.cos(a), r * math.sin(a)))
    body.group(name + "_bore", lambda x, y, side: side == "below")
    body.group(name + "_skin", lambda x, y, side: side == "above")
    if not closed:
        body.group(name + "_end", lambda x, y, side: side == "left")
        body.group(name + "_start", lambda x, y, side: side == "right")
    return body


def rings(rng, seed):
    """Concentric rings, whole or a quarter, under outer or inner pressure."""
    s = size(rng)
    whole = rng.random() < 0.6
    end = 2 * math.pi if whole else math.pi / 2
    n = rng.choice([8, 12, 16]) if whole else rng.randint(2, 6)
    m = rng.choice([n, n, n + 4, 2 * n])
    gap = rng.choice([0, 0, 0.001]) * s
    inner = annulus("In", 0.3 * s, 0.6 * s, n, 2, 0, end)
    outer = annulus("Out", 0.6 * s + gap, s, m, 2, 0, end)
    arcs = {"In_skin": (0, 0, 0.6 * s), "In_bore": (0, 0, 0.3 * s),
            "Out_bore": (0, 0, 0.6 * s + gap), "Out_skin": (0, 0, s)}
    scene = Scene("rings", seed, [inner, outer], {
        "In": material(rng, False), "Out": material(rng, False)}, arcs=arcs)
    mu = friction(rng)
    if whole:
        scene.hold("In_bore", 0, 0)
        # Nothing turns the outer ring: it may stay, or be named.
        scene.expected = EITHER
    else:
        scene.hold("In_start Out_start", None, 0)
        scene.hold("In_end Out_end", 0)
    scene.load("Pressure", "Out_skin", uniform(rng, 0.001, 0.01) *
               stiffness(scene))
    scene.contact(*swap(rng, "In_skin", "Out_bore"), mu)
    return settle(rng, scene)


def pin(rng, seed):
    """A pin in the hole of a ring: less, equal, or more than its bore."""
    s = size(rng)
    n, m = rng.choice([8, 12, 16]), rng.choice([8, 12, 16, 24])
    play = rng.choice([-0.002, 0.002, 0.01]) * s
    pin_ = annulus("Pin", 0.15 * s, 0.5 * s, n, 2)
    eye = annulus("Eye", 0.5 * s + play, s, m, 2)
    arcs = {"Pin_skin": (0, 0, 0.5 * s), "Eye_bore": (0, 0, 0.5 * s + play)}
    scene = Scene("pin", seed, [pin_, eye], {
        "Pin": material(rng, False), "Eye": material(rng, False)}, arcs=arcs)
    scene.hold("Eye_skin", 0, 0)
    scene.hold("Pin_bore", uniform(rng, -0.01, 0.01) * s,
               -uniform(rng, 0.002, 0.015) * s)
    scene.contact(*swap(rng, "Pin_skin", "Eye_bore"), friction(rng))
    return settle(rng, scene, (2, 4))


def press_fit(rng, seed):
    """Blocks that overlap between fixed supports, nothing else; any scale."""
    s = rng.choice([1e-3, 1.0, 10.0, 1000.0, 5000.0])
    scale = rng.choice([1, 1, 1e-9, 1e-5, 1e6])
    overlap = log_uniform(rng, 1e-5, 5e-3) * s
    low = block("Low", 0, 0, s, 0.5 * s, rng.randint(2, 7), rng.randint(1, 3))
    up = block("Up", 0.2 * s, 0.5 * s - overlap, 0.8 * s, s, rng.randint(2, 7),
               rng.randint(1, 3))
    materials = {name: (young * scale, nu) for name, (young, nu) in (
        ("Low", material(rng, False)), ("Up", material(rng, False)))}
    scene = Scene("press_fit", seed, [low, up], materials)
    scene.hold("Low_below Up_above", 0, 0)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    return settle(rng, scene, (1, 2))


def shaft(rng, seed):
    """A shaft in a hub by interference; perhaps pushed (axisymmetric)."""
    s = size(rng)
    overlap = log_uniform(rng, 1e-4, 3e-3) * s
    hollow = rng.choice([0, 0.3 * s])
    shaft_ = block("Shaft", hollow, -0.2 * s, s, 1.4 * s, 3, rng.randint(4, 12))
    hub = block("Hub", s - overlap, 0, 2 * s, s, 3, rng.randint(2, 8))
    scene = Scene("shaft", seed, [shaft_, hub], {
        "Shaft": material(rng, False), "Hub": material(rng, False)})
    scene.entries["Solids/Symmetry"] = "axisymmetric"
    hub.group("unused", lambda x, y, side: True)
    scene.hold("Shaft_below", None, rng.choice([0, uniform(rng, 0, 0.02) * s]))
    scene.hold("Hub_right", None, 0)
    scene.histories["Displacement y"] = HOLD_THEN_RAMP
    scene.contact(*swap(rng, "Hub_left", "Shaft_right"), friction(rng))
    return settle(rng, scene, (2, 4))


def beam(rng, seed):
    """A slender beam without any contact."""
    length = size(rng)
    h = length / uniform(rng, 5, 25)
    body = block("Beam", 0, 0, length, h, rng.randint(6, 20),
                 rng.randint(1, 2), split(rng))
    young, nu = material(rng)
    scene = Scene("beam", seed, [body], {"Beam": (young, nu)})
    scene.hold("Beam_left", 0, 0)
    # Of a bending stiffness E h^3 / 12 it goes down by a part of its length.
    large = rng.random() < 0.7
    part = uniform(rng, 0.01, 0.3) * (1 if large else 0.2)
    force = part * young * h ** 3 / 4 / length ** 2
    load = rng.choice(["Resultant force y", "Pressure", "Displacement y"])
    if load == "Resultant force y":
        scene.load(load, "Beam_right", -force)
    elif load == "Pressure":
        scene.load(load, "Beam_above", force / length)
    else:
        scene.hold("Beam_right", None, -part * length)
    return settle(rng, scene, (1, 2, 4), large)


def beam_contact(rng, seed):
    """A cantilever that comes down on a block, or on another cantilever."""
    length = size(rng)
    h = length / uniform(rng, 6, 15)
    gap = uniform(rng, 0, 0.02) * length
    body = block("Beam", 0, 0, length, h, rng.randint(8, 20), rng.randint(1, 2))
    second = rng.random() < 0.5
    if second:
        low = block("Low", 0.3 * length, -gap - h, 1.4 * length, -gap,
                    rng.randint(8, 16), 1)
    else:
        low = block("Low", 0.6 * length, -gap - 4 * h, 1.2 * length, -gap,
                    rng.randint(3, 8), 2)
    young, nu = material(rng, False)
    scene = Scene("beam_contact", seed, [body, low], {
        "Beam": (young, nu), "Low": material(rng, False)})
    scene.hold("Beam_left", 0, 0)
    scene.hold("Low_right" if second else "Low_below", 0, 0)
    if rng.random() < 0.5:
        scene.hold("Beam_right", None, -gap - uniform(rng, 0.2, 1) * h)
    else:
        scene.load("Pressure", "Beam_above", uniform(rng, 0.02, 0.1) * young *
                   (h / length) ** 3)
    scene.contact(*swap(rng, "Beam_below", "Low_above"), friction(rng))
    return settle(rng, scene, (2, 4), large=True)


def obstacle(rng, seed):
    """A block on a rigid plane, a disk or in a hollow."""
    s = size(rng)
    n = rng.randint(2, 8)
    kind = rng.choice(["plane", "tilted", "disk", "hollow"])
    radius = uniform(rng, 1.0, 4) * s
    curve = {"plane": 0.0, "tilted": 0.0, "disk": 0.0,
             "hollow": 1.5 / radius}[kind]

    def shape(x, y):
        return s * x, s * y + (1 - y) * curve * (s * (x - 0.5)) ** 2
    body = block("Body", 0, 0, 1, 1, n, rng.randint(1, 5), shape=shape)
    scene = Scene("obstacle", seed, [body], {"Body": material(rng)})
    if kind == "plane":
        text = "half plane: 0, 0, 0, 1"
    elif kind == "tilted":
        a = uniform(rng, -0.2, 0.2)
        text = "half plane: 0, %.12g, %.12g, %.12g" % (
            -max(0.0, math.tan(a) * s), -math.sin(a), math.cos(a))
    elif kind == "disk":
        text = "circle: %.12g, %.12g, %.12g" % (0.5 * s, -radius, radius)
    else:
        text = "circle: %.12g, %.12g, %.12g" % (0.5 * s, radius, -radius)
    scene.contact("Body_below", None, friction(rng), obstacle=text)
    scene.hold("Body_above", 0, -uniform(rng, 0.002, 0.02) * s - (
        abs(math.tan(a)) * s if kind == "tilted" else 0))
    return settle(rng, scene, (2, 4))


def axisymmetric(rng, seed):
    """A punch or a plate on a foundation, on the axis."""
    s = size(rng)
    r = uniform(rng, 0.3, 0.8) * s
    round_ = rng.choice([0, 0, 0.1, 0.4]) / s

    def shape(x, y):
        return x, y + (0.9 * s - y) / (0.4 * s) * round_ * x * x
    low = block("Low", 0, 0, s, 0.5 * s, rng.randint(3, 9), rng.randint(1, 4))
    up = block("Up", 0, 0.5 * s, r, 0.9 * s, rng.randint(2, 7),
               rng.randint(1, 4), shape=shape)
    scene = Scene("axisymmetric", seed, [low, up], {
        "Low": material(rng), "Up": material(rng)})
    scene.entries["Solids/Symmetry"] = "axisymmetric"
    scene.hold("Low_below", 0, 0)
    if rng.random() < 0.5:
        scene.hold("Up_above", None, -uniform(rng, 0.002, 0.02) * s)
    else:
        scene.load("Pressure", "Up_above", uniform(rng, 0.001, 0.01) *
                   stiffness(scene))
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    return settle(rng, scene)


def notch(rng, seed):
    """A tongue in a groove with some play, pushed to a side: one zone around
    corners, or one for each side."""
    s = size(rng)
    play = uniform(rng, 0.002, 0.01) * s
    n = rng.randint(1, 3)
    xs = ticks(0, 2, 0.35 * s, 2 * n, 0.65 * s, 2, s)
    low = Body("Low", xs, ticks(0, 2, 0.3 * s, 2 * n, 0.6 * s), keep=lambda x,
               y: y < 0.3 * s or not 0.35 * s < x < 0.65 * s)
    low.group("Base", lambda x, y, side: side == "below")
    inside = lambda x: 0.3 * s < x < 0.7 * s
    low.group("Groove", lambda x, y, side: side in ("left", "right") and
              inside(x))
    tongue = Body("Tongue", ticks(0.35 * s + play, rng.randint(2, 4),
                                  0.65 * s - play), ticks(
        0.3 * s + play, rng.randint(2, 5), 0.75 * s, 1, 0.9 * s))
    tongue.group("Tongue_above", lambda x, y, side: side == "above")
    tongue.group("Sides", lambda x, y, side: side in ("left", "right") and
                 y < 0.75 * s)
    scene = Scene("notch", seed, [low, tongue], {
        "Low": material(rng, False), "Tongue": material(rng, False)})
    scene.hold("Base", 0, 0)
    scene.hold("Tongue_above", rng.choice([-1, 1]) * (
        play + uniform(rng, 0.001, 0.02) * s), 0)
    scene.contact(*swap(rng, "Sides", "Groove"), friction(rng))
    return settle(rng, scene, (2, 4))


def bump(rng, seed):
    """A curved bottom on flat or hollow ground, pressed and dragged."""
    s = size(rng)
    sag, n = uniform(rng, 0.02, 0.4), rng.randint(4, 14)

    def shape(x, y):
        return s * x, s * (0.5 + y + (1 - 2 * y) * sag * x * x)
    body = Body("Bump", ticks(-0.5, n, 0.5), ticks(0, rng.randint(2, 4), 0.5),
                shape=shape, split=split(rng))
    body.group("Sole", lambda x, y, side: side == "below")
    body.group("Head", lambda x, y, side: side == "above")
    low = block("Low", -0.8 * s, 0, 0.8 * s, 0.5 * s, rng.randint(5, 16),
                rng.randint(2, 4), split(rng))
    scene = Scene("bump", seed, [low, body], {"Low": material(rng, False),
                                              "Bump": material(rng)})
    scene.hold("Low_below", 0, 0)
    scene.hold("Head", rng.choice([0, uniform(rng, -0.1, 0.1) * s]),
               -uniform(rng, 0.002, 0.02) * s)
    if rng.random() < 0.6:
        scene.histories["Displacement y"] = RAMP_THEN_HOLD
        scene.histories["Displacement x"] = HOLD_THEN_RAMP
    scene.contact(*swap(rng, "Sole", "Low_above"), friction(rng))
    return settle(rng, scene, (2, 4, 8))


KINDS = (round_corner, corner, wedge, rings, pin, press_fit, shaft, beam,
         beam_contact, obstacle, axisymmetric, notch, bump)
