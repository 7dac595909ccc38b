"""Scenes whose surfaces of contact go round edges on both sides: trays, keys,
slots, steps, teeth. Each group is one, however many sides it has."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import bisect
import math

import draw
from draw import material, size, swap, uniform
from grids import Body, ticks
from kinds_blocks import stiffness
from scene import HOLD_THEN_RAMP, RAMP_THEN_HOLD, Scene, THERE_AND_BACK

FRICTION = (0.0, 0.0, 0.0, 0.1, 0.2, 0.3, 0.5, 1.0)
RULES = ("mortar",) * 7 + ("nodal",) * 2 + ("Gauss",)


def stations(cell, *places):
    """Ticks between places that are not further apart than about a cell."""
    points = [places[0]]
    for end in places[1:]:
        n = max(1, round((end - points[-1]) / cell))
        points = points[:-1] + ticks(points[-1], n, end)
    return points


def cell(rng, s):
    return rng.choice([0.06, 0.08, 0.1, 0.14, 0.2, 0.3]) * s


def clearance(rng, s):
    return rng.choice([0, uniform(rng, 0.001, 0.02) * s])


def slant(rng):
    """A few degrees, or none."""
    return rng.choice([0, 0, uniform(rng, -0.08, 0.08)])


def leaning(rng):
    """The whole scene sheared: faces are no longer along the axes, nor at right
    angles to each other."""
    a, b = slant(rng), slant(rng)
    return lambda x, y: (x + a * y, y + b * x)


def friction(rng):
    return rng.choice(FRICTION)


def scene_of(rng, kind, seed, low, up):
    scene = Scene(kind, seed, [low, up], {"Low": material(rng, False),
                                          "Up": material(rng, False)})
    scene.round_edges = True
    scene.contact(*swap(rng, "Out", "In"), friction(rng))
    return scene.hold("Base", 0, 0)


def drive(rng, scene, way):
    """The head goes along a way; at once, in one direction after the other, or
    there and back."""
    scene.hold("Head", *way)
    choice = rng.random()
    first = rng.choice("xy")
    if all(way) and choice < 0.5:
        for axis in "xy":
            scene.histories["Displacement " + axis] = (
                RAMP_THEN_HOLD if axis == first else HOLD_THEN_RAMP)
    elif choice > 0.9:
        for axis in "xy":
            scene.histories["Displacement " + axis] = THERE_AND_BACK
    return scene


def push(rng, scene, load, sideways):
    """By a force, guided sideways."""
    scene.hold("Head", sideways)
    scene.load("Pressure", "Head", load * stiffness(scene))
    scene.approach = None
    return scene


def settle(rng, scene, increments=(1, 2, 4)):
    draw.settle(rng, scene, increments)
    if scene.is_default:
        scene.rule = rng.choice(RULES)
    scene.middles_in = "Nodes"
    return scene


def tray(rng, seed):
    """A block in the corner of a tray, or between its walls."""
    s = size(rng)
    two = rng.random() < 0.4
    gx, gy = clearance(rng, s), clearance(rng, s)
    lean = leaning(rng)
    h = cell(rng, s)
    low = Body("Low", stations(h, 0, 0.3 * s, 0.9 * s, 1.2 * s), stations(
        h, 0, 0.3 * s, uniform(rng, 0.5, 0.9) * s), shape=lean,
        keep=lambda x, y: y < 0.3 * s or x < 0.3 * s or two and x > 0.9 * s)
    low.group("Base", lambda x, y, side: side == "below")
    low.group("In", lambda x, y, side: side == "above" and y < 0.31 * s or
              side == "right" and x < 0.31 * s or two and side == "left" and
              x > 0.89 * s)
    width = 0.6 * s - gx - clearance(rng, s) if two else uniform(
        rng, 0.25, 0.5) * s
    # Its own slant opens away from floor and wall.
    a, b = (0, 0) if two else (abs(slant(rng)), abs(slant(rng)))
    h = cell(rng, s)
    x0, y0 = 0.3 * s + gx, 0.3 * s + gy
    # No node of the head is on the surface of contact.
    y1 = y0 + uniform(rng, 0.2, 0.5) * s
    up = Body("Up", stations(h, x0, x0 + width), stations(
        h, y0, y1, y1 + 0.1 * s), shape=lambda x, y: lean(
            x + a * (y - y0), y + b * (x - x0)))
    up.group("Head", lambda x, y, side: side == "above")
    up.group("Out", lambda x, y, side: side == "below" or y < y1 and (
        side == "left" or two and side == "right"))
    scene = scene_of(rng, "tray", seed, low, up)
    if rng.random() < 0.25 and gy == 0:
        return settle(rng, push(rng, scene, uniform(rng, 0.001, 0.01),
                                rng.choice([0, -gx - 0.005 * s])))
    down, aside = (uniform(rng, 0.002, 0.02) * s for _ in range(2))
    scene.approach = down
    return settle(rng, drive(rng, scene, (rng.choice(
        [0, -gx - aside, -gx - aside, aside]), -gy - down)))


def shouldered(rng, seed):
    """A tongue with shoulders in a groove."""
    s = size(rng)
    gaps = [clearance(rng, s) for _ in range(4)]
    left, right, foot, shoulder = gaps
    lean = leaning(rng)
    h = cell(rng, s)
    depth = uniform(rng, 0.2, 0.4) * s
    bottom = 0.6 * s - depth
    low = Body("Low", stations(h, 0, 0.35 * s, 0.65 * s, s), stations(
        h, 0, bottom, 0.6 * s), shape=lean, keep=lambda x, y: y < bottom or
        not 0.35 * s < x < 0.65 * s)
    low.group("Base", lambda x, y, side: side == "below")
    low.group("In", lambda x, y, side: side == "above" or side in (
        "left", "right") and 0.1 * s < x < 0.9 * s)
    h = cell(rng, s)
    x = (0.1 * s, 0.35 * s + left, 0.65 * s - right, uniform(
        rng, 0.8, 1.1) * s)
    y = (bottom + foot, 0.6 * s + shoulder, 0.9 * s)
    up = Body("Up", stations(h, *x), stations(h, *y), shape=lean,
              keep=lambda a, b: b > y[1] or x[1] < a < x[2])
    up.group("Head", lambda x, y, side: side == "above")
    up.group("Out", lambda a, b, side: side == "below" or side in (
        "left", "right") and b < y[1])
    scene = scene_of(rng, "key", seed, low, up)
    down, aside = (uniform(rng, 0.002, 0.015) * s for _ in range(2))
    scene.approach = max(down, aside)
    way = rng.choice([0, -left - aside, right + aside]), rng.choice(
        [0, -min(foot, shoulder) - down])
    if not any(way):
        way = right + aside, 0
    return settle(rng, drive(rng, scene, way))


def key(rng, seed):
    """A tongue in a groove, or a shaft that turns, with its key, in a hub."""
    if rng.random() < 0.5:
        return shouldered(rng, seed)
    s = size(rng)
    half, height = uniform(rng, 0.2, 0.35), uniform(rng, 0.08, 0.16) * s
    play, above = uniform(rng, 0, 0.02), uniform(rng, 0.01, 0.02) * s
    # More than the polygons overlap by.
    n, m = rng.choice([20, 24, 32]), rng.choice([20, 24, 32])
    radius, bore = 0.6 * s, 0.6 * s + uniform(rng, 0.012, 0.02) * s
    low = ring("Low", n, half + play, (bore, bore + height + above, 1.1 * s),
               lambda a, r: not (r < bore + height + above and
                                 abs(a) < half + play))
    low.group("Base", lambda a, r, side: side == "above" and r > 1.05 * s)
    low.group("In", lambda a, r, side: r < 1.05 * s)
    up = ring("Up", m, half, (0.3 * s, radius, bore + height),
              lambda a, r: r < radius or abs(a) < half)
    up.group("Head", lambda a, r, side: side == "below" and r < 0.4 * s)
    up.group("Out", lambda a, r, side: r > 0.4 * s)
    scene = scene_of(rng, "key", seed, low, up)
    scene.mesh.points["P"] = scene.mesh.lines["Head"][0][0]
    settle(rng, scene)
    scene.make_rigid("Head", "P")
    turn = play + uniform(rng, 0.004, 0.015)
    sign = rng.choice([-1, 1])
    # About the axis, not about its point.
    x, y = scene.mesh.X[scene.mesh.points["P"]]
    scene.load("Rotation z", "Head", sign * turn)
    for axis, way in (("x", x * (math.cos(turn) - 1) - sign * y *
                       math.sin(turn)), ("y", y * (math.cos(turn) - 1) +
                                         sign * x * math.sin(turn))):
        if not scene.large:
            way = sign * turn * (-y if axis == "x" else x)
        scene.load("Displacement " + axis, "Head", way)
    scene.approach = (turn - play) * 0.6 * s
    return scene


def ring(name, n, half, radii, keep):
    """Angles from -pi to pi, closed; the key or its way is at the angle 0."""
    step = 2 * math.pi / n
    k = max(1, round((math.pi - half) / step))
    j = max(1, round(2 * half / step))
    angles = ticks(math.pi, k, half, j, -half, k, -math.pi)
    return Body(name, angles, ticks(radii[0], 2, radii[1], 1, radii[2]),
                closed=True, keep=keep, shape=lambda a, r: (
                    r * math.cos(a), r * math.sin(a)))


def tslot(rng, seed):
    """A T-piece in a slot: pulled, pushed aside, pressed down."""
    s = size(rng)
    lean = leaning(rng)
    lip, floor, left, right, stem = (clearance(rng, s) for _ in range(5))
    h = cell(rng, s)
    low = Body("Low", stations(h, 0, 0.2 * s, 0.4 * s, 0.6 * s, 0.8 * s, s),
               stations(h, 0, 0.2 * s, 0.5 * s, 0.7 * s), shape=lean,
               keep=lambda x, y: not (0.2 * s < x < 0.8 * s and 0.2 * s < y <
                                      0.5 * s or y > 0.5 * s and
                                      0.4 * s < x < 0.6 * s))
    low.group("Base", lambda x, y, side: side == "below" and y < 0.1 * s)
    low.group("In", lambda x, y, side: 0.1 * s < x < 0.9 * s and (
        0.1 * s < y < 0.65 * s))
    h = cell(rng, s)
    x = (0.2 * s + left, 0.4 * s + stem, 0.6 * s - clearance(rng, s),
         0.8 * s - right)
    y = (0.2 * s + floor, 0.5 * s - lip, 0.9 * s)
    up = Body("Up", stations(h, *x), stations(h, *y), shape=lean,
              keep=lambda a, b: b < y[1] or x[1] < a < x[2])
    up.group("Head", lambda x, y, side: side == "above" and y > 0.8 * s)
    up.group("Out", lambda x, y, side: y < 0.8 * s)
    scene = scene_of(rng, "tslot", seed, low, up)
    up_, aside = (uniform(rng, 0.003, 0.02) * s for _ in range(2))
    scene.approach = up_
    way = rng.choice([0, 0, left + aside, -right - aside]), rng.choice(
        [lip + up_, lip + up_, -floor - up_])
    return settle(rng, drive(rng, scene, way))


def stepped(rng, kind, seed, s, places, levels, taper=0.0, lean=None):
    """Two bodies with a surface of steps between them: at each place the level
    goes to the next one. Walls are `gx` apart, floors `gy`; `taper`: teeth are
    narrower at their tips."""
    gx, gy = clearance(rng, s), clearance(rng, s)
    rises = [b > a for a, b in zip(levels, levels[1:])]
    lean = lean or (lambda x, y: (x, y))

    def flank(x, y):
        """Leans to the right at a rise and to the left at a fall."""
        knots = [0.0] + list(places) + [s]
        values = [0] + [1 if r else -1 for r in rises] + [0]
        k = min(max(bisect.bisect(knots, x) - 1, 0), len(knots) - 2)
        t = (x - knots[k]) / (knots[k + 1] - knots[k])
        d = values[k] + min(max(t, 0), 1) * (values[k + 1] - values[k])
        up = min(max(y, min(levels)), max(levels)) - min(levels)
        return lean(x + taper * d * up, y)
    other = [x - gx if r else x + gx for x, r in zip(places, rises)]
    level = lambda x, at: levels[bisect.bisect(at, x)]
    all_ = sorted(set(levels))
    h = cell(rng, s)
    low = Body("Low", stations(h, 0, *places, s), stations(h, 0, *all_),
               shape=flank, keep=lambda x, y: y < level(x, places))
    low.group("Base", lambda x, y, side: side == "below")
    low.group("In", lambda x, y, side: side == "above" or side in (
        "left", "right") and 0 < round(x / s, 9) < 1)
    h = cell(rng, s)
    up = Body("Up", stations(h, 0, *other, s), stations(
        h, *(y + gy for y in all_), 0.9 * s), shape=flank,
        keep=lambda x, y: y > level(x, other) + gy)
    up.group("Head", lambda x, y, side: side == "above")
    up.group("Out", lambda x, y, side: side == "below" or side in (
        "left", "right") and 0 < round(x / s, 9) < 1)
    scene = scene_of(rng, kind, seed, low, up)
    down, aside = (uniform(rng, 0.002, 0.015) * s for _ in range(2))
    scene.approach = down
    if rng.random() < 0.25 and gy == 0:
        return settle(rng, push(rng, scene, uniform(rng, 0.001, 0.01), 0))
    return settle(rng, drive(rng, scene, (rng.choice(
        [0, gx + aside, -gx - aside]), -gy - down)))


def labyrinth(rng, seed):
    """Steps, up or down."""
    s = size(rng)
    n = rng.randint(1, 3)
    places = [s * (k + uniform(rng, 0.8, 1.2)) / (n + 1) for k in range(n)]
    levels = [0.4 * s]
    for _ in range(n):
        rise = rng.choice([-1, 1]) * uniform(rng, 0.08, 0.15) * s
        if not 0.15 * s < levels[-1] + rise < 0.65 * s:
            rise = -rise
        levels.append(levels[-1] + rise)
    return stepped(rng, "labyrinth", seed, s, places, levels,
                   lean=leaning(rng))


def teeth(rng, seed):
    """Teeth, narrower at their tips, in grooves like them."""
    s = size(rng)
    n = rng.randint(1, 3)
    places = [s * (k + 1) / (2 * n + 1) for k in range(2 * n)]
    height = uniform(rng, 0.1, 0.2) * s
    levels = [0.4 * s + (k % 2) * height for k in range(2 * n + 1)]
    # By less than half of their width.
    return stepped(rng, "teeth", seed, s, places, levels, uniform(
        rng, 0.05, min(0.8, 0.35 * s / (2 * n + 1) / height)))


KINDS = (tray, key, tslot, labyrinth, teeth)
