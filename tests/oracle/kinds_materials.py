"""Scenes of bodies that yield, of rubber, heated, with an interference, glued."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import math

from draw import (RUBBERS, friction, log_uniform, material, new_bodies,
                  plastic_bodies, rubber_law, settle, settle_new, size, some,
                  split, swap, uniform)
from grids import Body, block, ticks
from kinds_blocks import two_blocks
from kinds_parts import half_disk
from kinds_shapes import annulus
from scene import (Formula, HOLD_THEN_RAMP, RAMP, RAMP_THEN_HOLD, Scene, TENT,
                   THERE_AND_BACK, scaled)


def plastic(rng, seed):
    """A block on a block, one or both yield; pressed, unloaded, dragged, or
    under a pressure that goes there and back."""
    scene, s = two_blocks(rng, "plastic", seed)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    way = rng.choice(["pressed", "unloaded", "dragged", "pressure"])
    if way == "pressure":
        scene.hold("Up_above", 0)
    else:
        scene.hold("Up_above", 0, -uniform(rng, 0.002, 0.02) * s)
    if way == "unloaded":
        scene.histories["Displacement y"] = THERE_AND_BACK
    elif way == "dragged":
        scene.hold("Up_above", uniform(rng, -0.02, 0.02) * s)
        scene.histories["Displacement y"] = RAMP_THEN_HOLD
        scene.histories["Displacement x"] = HOLD_THEN_RAMP
    settle(rng, scene, (2, 4, 8), large=False)
    scene.middles_in = "Nodes"
    plastic_bodies(rng, scene, some(rng, ["Low", "Up"]),
                   hardens=way == "pressure")
    if way == "pressure":
        least = min(law.initial for law in scene.laws.values())
        scene.load("Pressure", "Up_above", uniform(rng, 0.3, 1.8) * least)
        if scene.degree == 1:
            scene.histories["Pressure"] = THERE_AND_BACK
    return scene


def plastic_round(rng, seed):
    """A roller or half a ball of rings on a foundation; pressed and released."""
    s = size(rng)
    rings = rng.random() < 0.5
    n = rng.randint(4, 10)
    if rings:
        def shape(u, v):
            angle, r = 0.5 * math.pi * u, s * (0.4 + 0.6 * v)
            return r * math.sin(angle), s - r * math.cos(angle)
        ball = Body("Ball", ticks(1, n, 0), ticks(0, 2, 1), shape=shape)
        ball.group("Ball_arc", lambda x, y, side: side == "above")
        ball.group("Ball_flat", lambda x, y, side: side == "below")
    else:
        ball = half_disk("Ball", 0, s, s, 2 * n, 2)
    low = block("Low", 0 if rings else -1.2 * s, -s, 1.2 * s, 0,
                rng.randint(4, 12), 3)
    scene = Scene("plastic_round", seed, [low, ball], {
        "Low": material(rng, False), "Ball": material(rng, False)},
        arcs={"Ball_arc": (0, s, s)})
    if rings:
        scene.entries["Solids/Symmetry"] = "axisymmetric"
    scene.hold("Low_below", 0, 0)
    scene.hold("Ball_flat", None if rings else 0,
               -uniform(rng, 0.002, 0.02) * s)
    if rng.random() < 0.6:
        scene.histories["Displacement y"] = THERE_AND_BACK
    scene.contact(*swap(rng, "Ball_arc", "Low_above"), friction(rng))
    settle(rng, scene, (2, 4, 8), large=False)
    scene.middles_in = "Nodes"
    return plastic_bodies(rng, scene, some(rng, ["Low", "Ball"]))


def plastic_beam(rng, seed):
    """Bent or pulled there and back without contact: every increment against a
    solution of the oracle's own."""
    length = size(rng)
    h = length / uniform(rng, 3, 12)
    body = block("Beam", 0, 0, length, h, rng.randint(4, 14), rng.randint(1, 3),
                 split(rng))
    scene = Scene("plastic_beam", seed, [body], {"Beam": material(rng)})
    scene.hold("Beam_left", 0, 0)
    if rng.random() < 0.6:
        scene.hold("Beam_right", None, -uniform(rng, 0.002, 0.05) * length)
    else:
        scene.hold("Beam_right", uniform(rng, -0.01, 0.01) * length, None)
    for entry in list(scene.boundary):
        if rng.random() < 0.7:
            scene.histories[entry] = rng.choice([THERE_AND_BACK, Formula(
                "table(0 0, 0.25 1, 0.75 -1, 1 0)", lambda t: 4 * t if t < 0.25
                else 2 - 4 * t if t < 0.75 else 4 * t - 4)])
    if rng.random() < 0.3:
        scene.entries["Solids/Symmetry"] = "axisymmetric"
        scene.mesh.X[:, 0] += uniform(rng, 0.1, 2) * length
    settle(rng, scene, (2, 4, 8), large=False)
    scene.middles_in = "Nodes"
    plastic_bodies(rng, scene, ["Beam"])
    if rng.random() < 0.3:
        scene.thermal["Beam"] = scaled(uniform(rng, -0.01, 0.01), RAMP)
    return scene


def rubber(rng, seed):
    """A block of rubber under a block, a half plane or a disk; squeezed by up to
    a third and perhaps sheared."""
    s = size(rng)
    n = rng.randint(2, 7)
    low = block("Rubber", 0, 0, s, uniform(rng, 0.4, 1) * s, n,
                rng.randint(2, 5), split(rng))
    h = low.X[-1][1]
    squeeze = uniform(rng, 0.02, 0.3) * h
    young, nu = rng.choice(RUBBERS)
    law = rubber_law(rng, young, nu)
    mu = friction(rng)
    if rng.random() < 0.5:
        w = uniform(rng, 0.3, 1.5) * s
        up = block("Up", 0.5 * (s - w), h, 0.5 * (s + w), 1.5 * h,
                   rng.randint(2, 6), 2)
        other = rng.choice([material(rng), rng.choice(RUBBERS)])
        scene = Scene("rubber", seed, [low, up], {"Rubber": (young, nu),
                                                  "Up": other})
        if other in RUBBERS:
            scene.laws["Up"] = rubber_law(rng, *other)
        scene.hold("Up_above", rng.choice([0, uniform(rng, -0.3, 0.3) * h]),
                   -squeeze)
        scene.contact(*swap(rng, "Rubber_above", "Up_below"), mu)
    else:
        scene = Scene("rubber", seed, [low], {"Rubber": (young, nu)})
        radius = uniform(rng, 0.5, 3) * s
        text, way = rng.choice([
            ("half plane: %.12g, %.12g, %.12g, -1" % (
                0.5 * s, h, uniform(rng, -0.1, 0.1)), 0.0),
            ("circle: %.12g, %.12g, %.12g" % (0.5 * s, h + radius, radius),
             0.0)])
        scene.contact("Rubber_above", None, mu, obstacle=text, motion={
            "y": scaled(-squeeze, rng.choice([RAMP, TENT])),
            "x": scaled(rng.choice([0, 1]) * uniform(rng, -0.3, 0.3) * h,
                        RAMP)})
    scene.laws["Rubber"] = law
    scene.hold("Rubber_below", 0, 0)
    settle(rng, scene, (4, 8), large=True)
    scene.middles_in = "Nodes"
    return scene


def rubber_beam(rng, seed):
    """Rubber without contact, stretched, sheared or bent far."""
    length = size(rng)
    h = length / uniform(rng, 1, 6)
    body = block("Beam", 0, 0, length, h, rng.randint(3, 10), rng.randint(1, 4),
                 split(rng))
    young, nu = rng.choice(RUBBERS)
    scene = Scene("rubber_beam", seed, [body], {"Beam": (young, nu)})
    scene.laws["Beam"] = rubber_law(rng, young, nu)
    scene.hold("Beam_left", 0, 0)
    choice = rng.choice(["stretch", "shear", "force", "pressure"])
    if choice == "stretch":
        # Slender ones would buckle.
        scene.hold("Beam_right", uniform(rng, -0.02, 1.0) * length, 0)
    elif choice == "shear":
        scene.hold("Beam_right", None, uniform(rng, -0.5, 0.5) * length)
    elif choice == "force":
        scene.load("Resultant force x", "Beam_right",
                   uniform(rng, 0.02, 0.5) * young * h)
    else:
        scene.load("Pressure", "Beam_above", uniform(rng, 0.01, 0.1) * young *
                   (h / length) ** 2)
    if rng.random() < 0.3:
        scene.entries["Solids/Symmetry"] = "axisymmetric"
        scene.mesh.X[:, 0] += uniform(rng, 0.1, 2) * length
    settle(rng, scene, (4, 8), large=True)
    scene.middles_in = "Nodes"
    if rng.random() < 0.3:
        scene.thermal["Beam"] = scaled(uniform(rng, -0.1, 0.1), RAMP)
    return scene


def heated(rng, seed):
    """Bodies that grow between walls, or one on another; of any material."""
    scene, s = two_blocks(rng, "heated", seed, rng.choice([0, 0, 0.001]))
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    scene.hold("Up_above", 0, rng.choice([0, -uniform(rng, 0.001, 0.01) * s]))
    settle_new(rng, scene, (2, 4), 0.6)
    history = rng.choice([RAMP, RAMP, TENT])
    for name in some(rng, ["Low", "Up"]):
        most = 0.05 if name in scene.laws and scene.is_large(name) else 0.01
        scene.thermal[name] = scaled(uniform(rng, 0.1, 1) * most, history)
    return scene


def shrunk(rng, seed):
    """Rings or a plane quarter of them, drawn with one radius, with an
    interference; perhaps taken back; of any material."""
    s = size(rng)
    rings = rng.random() < 0.5
    most = uniform(rng, 0.002, 0.01) * s
    if rings:
        inner = block("In", rng.choice([0, 0.3 * s]), 0, 0.6 * s, 0.5 * s, 3,
                      rng.randint(2, 6))
        outer = block("Out", 0.6 * s, 0, s, 0.5 * s, 3, rng.randint(2, 6))
        pair, arcs = ("In_right", "Out_left"), None
    else:
        # Polygons leave much less open than the interference.
        n = math.ceil((0.6 * s / most) ** 0.5) + rng.randint(0, 3)
        inner = annulus("In", 0.3 * s, 0.6 * s, n, 2, 0, math.pi / 2)
        outer = annulus("Out", 0.6 * s, s, rng.choice([n, n + 3]), 2, 0,
                        math.pi / 2)
        pair, arcs = ("In_skin", "Out_bore"), {
            "In_skin": (0, 0, 0.6 * s), "Out_bore": (0, 0, 0.6 * s)}
    scene = Scene("shrunk", seed, [inner, outer], {
        "In": material(rng, False), "Out": material(rng, False)}, arcs=arcs)
    if rings:
        scene.entries["Solids/Symmetry"] = "axisymmetric"
        scene.hold("In_below Out_below", None, 0)
    else:
        scene.hold("In_start Out_start", None, 0)
        scene.hold("In_end Out_end", 0)
    # Polygons drawn with one radius are never quite without an overlap.
    scene.contact(*swap(rng, *pair), friction(rng), apart=scaled(
        most, rng.choice([RAMP, Formula("min(2*t, 1.5 - t)", lambda t: min(
            2 * t, 1.5 - t))])))
    return settle_new(rng, scene, (2, 4), 0.6)


def tied(rng, seed):
    """Glued blocks of any material, pulled, sheared or heated."""
    scene, s = two_blocks(rng, "tied", seed)
    scene.contact("Up_below", "Low_above", 0.0, tied=True)
    scene.hold("Up_above", uniform(rng, -0.02, 0.02) * s,
               rng.choice([None, uniform(rng, -0.02, 0.02) * s]))
    settle(rng, scene, (2, 4))
    if scene.rule == "Gauss":
        scene.rule = "mortar"
    # The slave is the narrower surface: all of it is glued.
    scene.zones[0].slave, scene.zones[0].master = "Up_below", "Low_above"
    scene.middles_in = "Nodes"
    if rng.random() < 0.8:
        new_bodies(rng, scene)
    if rng.random() < 0.4:
        scene.thermal[rng.choice(["Low", "Up"])] = scaled(
            log_uniform(rng, 1e-4, 1e-2), RAMP)
    return scene


KINDS = (plastic, plastic_round, plastic_beam, rubber, rubber_beam, heated,
         shrunk, tied)
