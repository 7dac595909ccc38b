"""Scenes in 3-D of bodies that yield, of rubber, of obstacles that move."""
# SPDX-License-Identifier: LGPL-2.1-or-later
from draw import (RUBBERS, in_small_strain, plastic_bodies, plastic_law,
                  rubber_law, size, some, swap, uniform)
from scene import (HOLD_THEN_RAMP, RAMP, RAMP_THEN_HOLD, TENT, THERE_AND_BACK,
                   scaled)
from space_blocks import stiffness, then_drag
from space_draw import direction, friction, material, settle, two_blocks
from space_grids import brick
from space_round import cap, flat
from space_scene import SpaceScene


def ball_on_block(rng, kind, seed):
    s = size(rng)
    ball = cap("Up", (0, 0, s), s, rng.randint(2, 5), 2)
    scene = SpaceScene(kind, seed, [flat(rng, s), ball], {
        "Low": material(rng, False), "Up": material(rng, False)},
        arcs={"Up_skin": ("Spheres", (0, 0, s, s))})
    scene.hold("Low_below", 0, 0, 0)
    return scene, s, ("Up_skin", "Low_above"), "Up_hub"


def block_on_block(rng, kind, seed):
    scene, s = two_blocks(rng, kind, seed, most=4)
    for name in scene.materials:
        scene.materials[name] = material(rng, False)
    return scene, s, ("Up_below", "Low_above"), "Up_above"


def plastic(rng, seed):
    """A block or a ball on a block, one or both yield; pressed, unloaded,
    dragged, or one block pressed by a pressure."""
    scene, s, pair, top = rng.choice([ball_on_block, block_on_block,
                                      block_on_block])(rng, "plastic", seed)
    scene.contact(*swap(rng, *pair), friction(rng))
    way = rng.choice(["pressed", "unloaded", "dragged"] + (
        ["pressure"] if top == "Up_above" else []))
    if way == "pressure":
        scene.hold(top, 0, 0)
        scene.load("Pressure", top, 1.0)
    else:
        scene.hold(top, 0, 0, -uniform(rng, 0.002, 0.02) * s)
    if way == "unloaded":
        scene.histories["Displacement z"] = THERE_AND_BACK
    elif way == "dragged":
        then_drag(scene, rng, top, uniform(rng, 0.002, 0.02) * s)
    scene = settle(rng, scene, (2, 4), large=False, levels=False)
    plastic_bodies(rng, scene, some(rng, ["Low", "Up"]),
                   hardens=way == "pressure")
    if way == "pressure":
        scene.load("Pressure", top, uniform(rng, 0.3, 1.5) * min(
            law.initial for law in scene.laws.values()))
    return scene


def rubber(rng, seed):
    """A block of rubber under a block or a ball; squeezed by up to a fifth and
    perhaps sheared."""
    scene, s, pair, top = rng.choice([ball_on_block, block_on_block])(
        rng, "rubber", seed)
    for name in some(rng, ["Low", "Up"]):
        scene.materials[name] = rng.choice(RUBBERS)
        scene.laws[name] = rubber_law(rng, *scene.materials[name])
    scene.contact(*swap(rng, *pair), friction(rng))
    scene.hold(top, 0, 0, -uniform(rng, 0.01, 0.12) * s)
    if rng.random() < 0.5:
        then_drag(scene, rng, top, uniform(rng, 0.01, 0.1) * s)
    return settle(rng, scene, (2, 4), large=True, levels=False)


def on_obstacle(rng, kind, seed):
    """A block, or a ball, on a rigid half space, ball or cylinder, and the axis
    that it may turn about: the normal of the former."""
    s = size(rng)
    arcs = {}
    if rng.random() < 0.6:
        n = rng.randint(3, 6)
        body = brick("Up", (-s / 2, -s / 2, 0), (s / 2, s / 2, 0.7 * s), (
            n, rng.randint(3, 6), 2))
        sole, top = "Up_below", "Up_above"
    else:
        body = cap("Up", (0, 0, s), s, rng.randint(3, 5), 2)
        sole, top = "Up_skin", "Up_hub"
        arcs["Up_skin"] = "Spheres", (0, 0, s, s)
    scene = SpaceScene(kind, seed, [body], {"Up": material(rng)}, arcs=arcs)
    scene.hold(top, 0, 0, 0)
    a, b = direction(rng, 1)
    r = uniform(rng, 1.5, 5) * s
    text, axis = rng.choice([
        ("half space: 0, 0, 0, 0, 0, 1", (0.0, 0.0, 1.0)),
        ("sphere: 0, 0, %.12g, %.12g" % (-r, r), rng.choice([
            (0.0, 0.0, 1.0), (a, b, 0.0)])),
        ("cylinder: 0, 0, %.12g, %.12g, %.12g, 0, %.12g" % (-r, a, b, r),
         None)])
    return scene, s, sole, text, axis


def material_of_one(rng, scene):
    """One in three yields, one in three is of rubber: the kinematics."""
    choice = rng.choice(["elastic", "rubber", "plastic"])
    if choice == "rubber":
        scene.materials["Up"] = rng.choice(RUBBERS)
        scene.laws["Up"] = rubber_law(rng, *scene.materials["Up"])
    elif choice == "plastic":
        scene.materials["Up"] = material(rng, False)
        scene.laws["Up"] = plastic_law(rng, *scene.materials["Up"])
    return choice == "rubber" or choice == "elastic" and rng.random() < 0.6


def finish(rng, scene, large):
    scene = settle(rng, scene, (2, 4), large=large, levels=False)
    if any(law.has_history for law in scene.laws.values()):
        in_small_strain(scene)
    return scene


def moved(rng, seed):
    """An obstacle presses on a body, then passes along it or turns."""
    scene, s, sole, text, axis = on_obstacle(rng, "moved", seed)
    motion = {"z": scaled(uniform(rng, 0.003, 0.015) * s, rng.choice(
        [RAMP_THEN_HOLD, TENT, RAMP]))}
    if rng.random() < 0.6:
        for name, way in zip("xy", direction(rng, uniform(rng, 0.002, 0.05) *
                                             s)):
            motion[name] = scaled(way, HOLD_THEN_RAMP)
    turns = rng.random() < 0.6
    if turns:
        motion["angle"] = scaled(uniform(rng, -1, 1) * 20, rng.choice(
            [HOLD_THEN_RAMP, RAMP]))
    scene.contact(sole, None, friction(rng), obstacle=text, motion=motion,
                  axis=axis if turns else None)
    return finish(rng, scene, material_of_one(rng, scene))


def driven(rng, seed):
    """A force presses an obstacle on a body, perhaps from a distance; then it
    passes along it by what is given, or is pushed within the friction."""
    scene, s, sole, text, _ = on_obstacle(rng, "driven", seed)
    mu = friction(rng)
    large = material_of_one(rng, scene)
    if rng.random() < 0.3:
        kind, numbers = text.split(": ")
        values = [float(v) for v in numbers.split(",")]
        values[2] -= 0.01 * s
        text = kind + ": " + ", ".join("%.12g" % v for v in values)
    soft = min([stiffness(scene)] + [200 * law.initial for law in
                                     scene.laws.values() if law.has_history])
    press = uniform(rng, 0.0003, 0.003) * soft * s * s
    force, motion = {"z": scaled(press, RAMP_THEN_HOLD)}, {}
    for axis in "xy":
        if mu and rng.random() < 0.4:
            force[axis] = scaled(uniform(rng, -0.5, 0.5) * mu * press,
                                 HOLD_THEN_RAMP)
        elif rng.random() < 0.4:
            motion[axis] = scaled(uniform(rng, -0.02, 0.02) * s,
                                  HOLD_THEN_RAMP)
    scene.contact(sole, None, mu, obstacle=text, force=force, motion=motion)
    return finish(rng, scene, large)


KINDS = (plastic, rubber, moved, driven)
