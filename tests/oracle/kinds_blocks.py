"""Scenes of blocks: pressed, carried, stacked, loose, with feet and teeth."""
# SPDX-License-Identifier: LGPL-2.1-or-later
from draw import friction, material, settle, size, split, swap, uniform
from grids import Body, block, ticks
from scene import (EITHER, HOLD_THEN_RAMP, HOPELESS, RAMP_THEN_HOLD, Scene,
                   THERE_AND_BACK)


def two_blocks(rng, kind, seed, gap=0.0, overhang=0.0):
    """A block on a wider one."""
    s = size(rng)
    width = uniform(rng, 0.4, 0.9) * s
    left = uniform(rng, 0.05, 0.95) * (s - width) - overhang * s
    h, top = uniform(rng, 0.3, 1) * s, uniform(rng, 0.2, 0.8) * s
    n, m = rng.randint(2, 9), rng.randint(1, 7)
    low = block("Low", 0, 0, s, h, n, rng.randint(1, 4), split(rng))
    up = block("Up", left, h + gap * s, left + width, h + gap * s + top, m,
               rng.randint(1, 4), split(rng))
    scene = Scene(kind, seed, [low, up], {"Low": material(rng),
                                          "Up": material(rng)})
    scene.hold("Low_below", 0, 0)
    return scene, s


def stiffness(scene):
    return min(young for young, _ in scene.materials.values())


def blocks(rng, seed):
    """Pressed by displacement or pressure, then perhaps dragged."""
    scene, s = two_blocks(rng, "blocks", seed, rng.choice([0, 0, 0.001]))
    mu = friction(rng)
    scene.contact(*swap(rng, "Up_below", "Low_above"), mu)
    down = -uniform(rng, 0.002, 0.02) * s
    scene.hold("Up_above", 0, down)
    if rng.random() < 0.4:
        scene.hold("Up_above", uniform(rng, -0.03, 0.03) * s)
        scene.histories["Displacement y"] = RAMP_THEN_HOLD
        scene.histories["Displacement x"] = HOLD_THEN_RAMP
    elif rng.random() < 0.3:
        scene.histories["Displacement y"] = THERE_AND_BACK
    return settle(rng, scene)


def pressed(rng, seed):
    """By a pressure, guided."""
    scene, s = two_blocks(rng, "pressed", seed)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    scene.hold("Up_above", 0)
    scene.load("Pressure", "Up_above",
               uniform(rng, 0.001, 0.02) * stiffness(scene))
    return settle(rng, scene)


def carried(rng, seed):
    """Held by friction alone on a base that moves, under a dead load."""
    scene, s = two_blocks(rng, "carried", seed)
    scene.boundary.clear()
    scene.hold("Low_below", uniform(rng, -0.05, 0.05) * s,
               rng.choice([0, uniform(rng, -0.02, 0.02) * s]))
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng, 0.1))
    if rng.random() < 0.5:
        scene.load("Pressure", "Up_above",
                   uniform(rng, 0.001, 0.01) * stiffness(scene))
    else:
        scene.load("Body force y", "Up", -uniform(
            rng, 0.0005, 0.01) * stiffness(scene) / s)
    return settle(rng, scene)


def dragged(rng, seed):
    """Pressed by a pressure, then moved along the base by supports at its side,
    whose nodes are in contact or not; the base held at its ends or not."""
    scene, s = two_blocks(rng, "dragged", seed, overhang=rng.choice([0, 0, 0.1]))
    scene.hold(rng.choice(["Up_left", "Up_right"]),
               uniform(rng, -0.05, 0.05) * s)
    for side in rng.choice([(), ("Low_left", "Low_right"), ("Low_left",)]):
        scene.hold(side, 0)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng, 0.1))
    scene.load("Pressure", "Up_above",
               uniform(rng, 0.001, 0.02) * stiffness(scene))
    scene.histories["Pressure"] = RAMP_THEN_HOLD
    scene.histories["Displacement x"] = HOLD_THEN_RAMP
    return settle(rng, scene)


def stack(rng, seed):
    """Three blocks; the middle one is held by friction alone."""
    s = size(rng)
    bodies, y = [], 0.0
    for k, name in enumerate("ABC"):
        h = uniform(rng, 0.2, 0.5) * s
        w = uniform(rng, 0.5, 1.0) * s
        x = uniform(rng, 0, 0.2) * s
        bodies.append(block(name, x, y, x + w, y + h, rng.randint(1, 6),
                            rng.randint(1, 3), split(rng)))
        y = y + h
    scene = Scene("stack", seed, bodies, {name: material(rng)
                                          for name in "ABC"})
    scene.hold("A_below", 0, 0)
    for name, pair in (("low", ("A_above", "B_below")),
                       ("upp", ("B_above", "C_below"))):
        scene.contact(*swap(rng, *pair), friction(rng, 0.2), name)
    if rng.random() < 0.6:
        scene.hold("C_above", uniform(rng, -0.01, 0.01) * s,
                   -uniform(rng, 0.003, 0.02) * s)
        if rng.random() < 0.5:
            scene.histories["Displacement y"] = RAMP_THEN_HOLD
            scene.histories["Displacement x"] = HOLD_THEN_RAMP
    else:
        scene.load("Pressure", "C_above", uniform(rng, 0.001, 0.01) *
                   stiffness(scene))
        for body in "ABC":
            scene.load("Body force y", body, -1e-5 * stiffness(scene) / s)
    return settle(rng, scene)


def loose(rng, seed):
    """One body of two pieces, one of which nothing holds but contact, or
    nothing at all."""
    s = size(rng)
    n = rng.randint(2, 6)
    low = block("Low", 0, 0, s, 0.4 * s, 2 * n, 2)
    xs = ticks(0, n, 0.45 * s, 1, 0.55 * s, n, s)
    up = Body("Up", xs, ticks(0.4 * s, 2, 0.8 * s),
              keep=lambda x, y: not 0.45 * s < x < 0.55 * s)
    up.group("Up_below", lambda x, y, side: side == "below")
    up.group("Up_above", lambda x, y, side: side == "above" and x < 0.5 * s)
    scene = Scene("loose", seed, [low, up], {"Low": material(rng),
                                             "Up": material(rng)})
    scene.hold("Low_below", 0, 0)
    scene.hold("Up_above", 0, -uniform(rng, 0.002, 0.02) * s)
    if rng.random() < 0.6:
        scene.load("Body force y", "Up", -1e-4 * stiffness(scene) / s)
    mu = friction(rng)
    scene.contact(*swap(rng, "Up_below", "Low_above"), mu)
    # The loose piece may lie as it is, or be named.
    scene.expected = EITHER
    return settle(rng, scene)


def pulled_off(rng, seed):
    """Nothing holds the upper block against what pulls it."""
    scene, s = two_blocks(rng, "pulled_off", seed)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    scene.load(rng.choice(["Resultant force y", "Resultant force x"]), "Up_above",
               uniform(rng, 0.001, 0.01) * stiffness(scene) * s)
    scene.expected = HOPELESS
    return settle(rng, scene)


def lifted(rng, seed):
    """Supports take the upper block away again."""
    scene, s = two_blocks(rng, "lifted", seed)
    scene.contact(*swap(rng, "Up_below", "Low_above"), friction(rng))
    scene.hold("Up_above", 0, uniform(rng, 0.002, 0.2) * s)
    return settle(rng, scene)


def feet(rng, seed):
    """A table on its feet, pressed or weighed down."""
    s = size(rng)
    feet_ = rng.randint(2, 4)
    foot, gap = 0.5 * s / feet_, 0.5 * s / (feet_ - 1)
    n, xs = rng.randint(1, 3), [0.0]
    stations = []
    for k in range(feet_):
        stations += [n, round(k * (foot + gap) + foot, 12)]
        if k < feet_ - 1:
            stations += [rng.randint(1, 3), round((k + 1) * (foot + gap), 12)]
    xs = ticks(0.0, *stations)
    table = Body("Table", xs, ticks(0.5 * s, 2, 0.7 * s, 2, s),
                 keep=lambda x, y: y > 0.7 * s or x % (foot + gap) < foot)
    table.group("Soles", lambda x, y, side: side == "below" and y < 0.6 * s)
    table.group("Top", lambda x, y, side: side == "above" and y > 0.9 * s)
    low = block("Low", -0.2 * s, 0, 1.2 * s, 0.5 * s, rng.randint(4, 14),
                rng.randint(1, 3), split(rng))
    scene = Scene("feet", seed, [low, table], {"Low": material(rng),
                                               "Table": material(rng)})
    scene.hold("Low_below", 0, 0)
    scene.contact(*swap(rng, "Soles", "Low_above"), friction(rng))
    if rng.random() < 0.5:
        scene.hold("Top", rng.choice([0, uniform(rng, -0.01, 0.01) * s]),
                   -uniform(rng, 0.002, 0.02) * s)
    else:
        scene.hold("Top", 0)
        scene.load("Pressure", "Top", uniform(rng, 0.001, 0.01) *
                   stiffness(scene))
    return settle(rng, scene)


def comb(rng, seed):
    """A master in several pieces, of one body or of several."""
    s = size(rng)
    teeth = rng.randint(2, 4)
    pitch = s / teeth
    bodies, materials = [], {}
    several = rng.random() < 0.5
    h, n = 0.4 * s, rng.randint(1, 4)
    for k in range(teeth):
        name = "L%d" % k if several else "L"
        x = k * pitch
        tooth = Body(name, ticks(x, n, x + uniform(rng, 0.5, 0.95) * pitch),
                     ticks(0, rng.randint(1, 3), h), split=split(rng))
        tooth.group("Base", lambda x, y, side: side == "below")
        tooth.group("Crest", lambda x, y, side: side == "above")
        bodies.append(tooth)
        materials[name] = materials.get(name) or material(rng, False)
    beam = block("B", 0.02 * s, h, 0.97 * s, 0.8 * s, rng.randint(2, 12),
                 rng.randint(1, 3), split(rng))
    materials["B"] = material(rng, False)
    scene = Scene("comb", seed, bodies + [beam], materials)
    scene.hold("Base", 0, 0)
    scene.contact(*swap(rng, "B_below", "Crest"), friction(rng))
    scene.hold("B_above", rng.choice([0, uniform(rng, -0.05, 0.05) * pitch]),
               -uniform(rng, 0.002, 0.02) * s)
    return settle(rng, scene)


def bricks(rng, seed):
    """A beam on a row of bricks, three zones or more."""
    s = size(rng)
    n = rng.randint(2, 3)
    bodies, materials = [], {}
    ground = block("G", -0.1 * s, -0.3 * s, 1.1 * s, 0, rng.randint(3, 10), 2)
    for k in range(n):
        x = s * k / n
        bodies.append(block("P%d" % k, x, 0, x + uniform(rng, 0.4, 0.8) * s / n,
                            0.3 * s, rng.randint(1, 4), rng.randint(1, 3)))
    beam = block("Top", -0.05 * s, 0.3 * s, 1.05 * s, 0.5 * s,
                 rng.randint(4, 12), rng.randint(1, 2))
    bodies = [ground] + bodies + [beam]
    materials = {b.name: material(rng, False) for b in bodies}
    scene = Scene("bricks", seed, bodies, materials)
    scene.hold("G_below", 0, 0)
    scene.hold("Top_above", 0, -uniform(rng, 0.001, 0.01) * s)
    mu = friction(rng, 0.2)
    for k in range(n):
        scene.contact("P%d_below" % k, "G_above", mu, "low%d" % k)
        scene.contact("P%d_above" % k, "Top_below", mu, "upp%d" % k)
    return settle(rng, scene)


KINDS = (blocks, pressed, carried, dragged, stack, loose, pulled_off, lifted,
         feet, comb, bricks)
