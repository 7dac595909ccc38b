"""Scenes in 3-D whose surfaces of contact go round edges on both sides: trays,
keys, slots, steps, rims. Each group is one, however many sides it has."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import space_draw
from draw import size, swap, uniform
from kinds_sides import RULES, clearance, friction, slant, stations
from scene import HOLD_THEN_RAMP, RAMP_THEN_HOLD
from space_blocks import stiffness
from space_draw import material
from space_grids import SpaceBody
from space_scene import SpaceScene


def cell(rng, s):
    return rng.choice([0.2, 0.3, 0.45]) * s


def leaning(rng):
    """The whole scene sheared."""
    a, b, c = slant(rng), slant(rng), slant(rng)
    return lambda x, y, z: (x + a * z, y + b * z, z + c * x)


def scene_of(rng, kind, seed, low, up):
    scene = SpaceScene(kind, seed, [low, up], {"Low": material(rng, False),
                                               "Up": material(rng, False)})
    scene.round_edges = True
    scene.contact(*swap(rng, "Out", "In"), friction(rng))
    return scene.hold("Base", 0, 0, 0)


def drive(rng, scene, way):
    """The head goes along a way: at once, or down after or before the rest."""
    scene.hold("Head", *way)
    choice = rng.random()
    if choice < 0.4:
        down, rest = ((RAMP_THEN_HOLD, HOLD_THEN_RAMP) if choice < 0.2 else
                      (HOLD_THEN_RAMP, RAMP_THEN_HOLD))
        for axis, history in zip("xyz", (rest, rest, down)):
            scene.histories["Displacement " + axis] = history
    return settle(rng, scene)


def push(rng, scene):
    """By a force, guided sideways."""
    scene.hold("Head", 0, 0)
    scene.load("Pressure", "Head", uniform(rng, 0.001, 0.01) *
               stiffness(scene))
    scene.approach = None
    return settle(rng, scene)


def settle(rng, scene):
    """Coarse meshes, since there are many sides: no levels."""
    is_small = sum(map(len, scene.mesh.cells.values())) < 30
    turned = space_draw.settle(rng, scene, (1, 2), levels=False)
    if turned.is_default:
        turned.rule = rng.choice([r for r in RULES if r != "Gauss"])
    if not is_small:
        turned.entries.pop("Element/Degree", None)
        turned.entries.pop("Element/Centre node", None)
    return turned


def ways(rng, s, gaps):
    """Into a gap by more than it, away from it, or not along this axis."""
    more = uniform(rng, 0.002, 0.015) * s
    return rng.choice([0, -gaps[0] - more, (gaps[1] + more) if len(
        gaps) > 1 else more])


def walled(rng, kind, seed, walls, aside=True):
    """A block on a floor between one and four walls: left, front, right,
    back."""
    s = size(rng)
    lean = leaning(rng)
    gaps = [clearance(rng, s) for _ in range(5)]
    left, front, right, back, floor = gaps
    h = cell(rng, s)
    has = lambda name: name in walls
    x = [0.0] * has("left") + [0.2 * s, 0.8 * s] + [s] * has("right")
    y = [0.0] * has("front") + [0.2 * s, 0.8 * s] + [s] * has("back")
    low = SpaceBody("Low", stations(h, *x), stations(h, *y), stations(
        h, 0, 0.25 * s, uniform(rng, 0.45, 0.8) * s), shape=lean,
        keep=lambda a, b, c: c < 0.25 * s or not (
            0.2 * s < a < 0.8 * s and 0.2 * s < b < 0.8 * s))
    low.group("Base", lambda x, y, z, side: side == "below")
    inside = {"left": "right", "right": "left", "front": "back",
              "back": "front"}
    low.group("In", lambda x, y, z, side: side == "above" and z < 0.3 * s or
              any(side == inside[w] and abs((x if w in (
                  "left", "right") else y) - (0.2 if w in (
                      "left", "front") else 0.8) * s) < 0.01 * s
                  for w in walls))
    h = cell(rng, s)
    reach = lambda wall, gap: gap if wall in walls else (
        uniform(rng, 0.05, 0.2) * s)
    low_ = (0.2 * s + reach("left", left), 0.2 * s + reach("front", front),
            0.25 * s + floor)
    high = (0.8 * s - reach("right", right), 0.8 * s - reach("back", back),
            uniform(rng, 0.45, 0.75) * s)
    # No node of the head is on the surface of contact.
    up = SpaceBody("Up", stations(h, low_[0], high[0]), stations(
        h, low_[1], high[1]), stations(h, low_[2], high[2],
                                       high[2] + 0.15 * s), shape=lean)
    up.group("Head", lambda x, y, z, side: side == "above")
    up.group("Out", lambda x, y, z, side: side == "below" or z < high[2] and (
        side in walls))
    scene = scene_of(rng, kind, seed, low, up)
    down = uniform(rng, 0.002, 0.02) * s
    scene.approach = down
    if floor == 0 and rng.random() < 0.2:
        return push(rng, scene)
    way = (ways(rng, s, (left, right) if has("right") else (left,)),
           ways(rng, s, (front, back) if has("back") else (front,)))
    if not aside:
        way = 0, 0
    return drive(rng, scene, (*way, -floor - down))


def tray(rng, seed):
    """A block in the corner of a tray, or between its walls."""
    return walled(rng, "tray", seed, rng.choice([
        ("left", "front"), ("left", "right"), ("left", "front", "right"),
        ("left", "front", "right", "back")]))


def beside_wall(rng, seed):
    """Pressed on a floor beside a wall, which it hardly touches."""
    return walled(rng, "beside_wall", seed, ("left",), aside=rng.random() < 0.3)


def key(rng, seed):
    """A tongue with shoulders in a pocket or in a groove."""
    s = size(rng)
    lean = leaning(rng)
    blind = rng.random() < 0.5
    left, right, front, back, foot, shoulder = (clearance(rng, s)
                                                for _ in range(6))
    h = cell(rng, s)
    y = (0, 0.25 * s, 0.75 * s, s) if blind else (0.2 * s, 0.8 * s)
    inside = lambda b: not blind or 0.25 * s < b < 0.75 * s
    low = SpaceBody("Low", stations(h, 0, 0.3 * s, 0.7 * s, s), stations(
        h, *y), stations(h, 0, 0.25 * s, 0.5 * s), shape=lean,
        keep=lambda a, b, c: c < 0.25 * s or not (0.3 * s < a < 0.7 * s and
                                                  inside(b)))
    low.group("Base", lambda x, y, z, side: side == "below")
    low.group("In", lambda a, b, c, side: side == "above" or side in (
        "left", "right") and 0.1 * s < a < 0.9 * s or side in (
            "front", "back") and 0.23 * s < b < 0.77 * s and blind)
    h = cell(rng, s)
    x = (0.1 * s, 0.3 * s + left, 0.7 * s - right, 0.9 * s)
    y = (0.1 * s, 0.25 * s + front, 0.75 * s - back, 0.9 * s) if blind else (
        0.15 * s, uniform(rng, 0.6, 0.9) * s)
    z = (0.25 * s + foot, 0.5 * s + shoulder, 0.8 * s)
    up = SpaceBody("Up", stations(h, *x), stations(h, *y), stations(h, *z),
                   shape=lean, keep=lambda a, b, c: c > z[1] or
                   x[1] < a < x[2] and (not blind or y[1] < b < y[2]))
    up.group("Head", lambda x, y, z, side: side == "above")
    up.group("Out", lambda a, b, c, side: side == "below" or c < z[1] and (
        side in ("left", "right") or blind and side in ("front", "back")))
    scene = scene_of(rng, "key", seed, low, up)
    down = uniform(rng, 0.002, 0.015) * s
    way = [ways(rng, s, (left, right)), ways(rng, s, (front, back)) if (
        blind) else 0, rng.choice([0, -min(foot, shoulder) - down])]
    if not any(way):
        way[2] = -min(foot, shoulder) - down
    scene.approach = 0.015 * s
    return drive(rng, scene, way)


def tslot(rng, seed):
    """A T-piece in a slot: pulled, pushed aside, pressed down."""
    s = size(rng)
    lean = leaning(rng)
    lip, floor, left, right, stem, other = (clearance(rng, s)
                                            for _ in range(6))
    h = cell(rng, s)
    low = SpaceBody("Low", stations(h, 0, 0.15 * s, 0.4 * s, 0.6 * s, 0.85 * s,
                                    s), stations(h, 0, 0.6 * s),
                    stations(h, 0, 0.2 * s, 0.45 * s, 0.65 * s), shape=lean,
                    keep=lambda x, y, z: not (
                        0.15 * s < x < 0.85 * s and 0.2 * s < z < 0.45 * s or
                        z > 0.45 * s and 0.4 * s < x < 0.6 * s))
    low.group("Base", lambda x, y, z, side: side == "below" and z < 0.1 * s)
    low.group("In", lambda x, y, z, side: side not in ("front", "back") and (
        0.1 * s < x < 0.9 * s) and 0.1 * s < z < 0.6 * s)
    h = cell(rng, s)
    x = (0.15 * s + left, 0.4 * s + stem, 0.6 * s - other, 0.85 * s - right)
    z = (0.2 * s + floor, 0.45 * s - lip, 0.85 * s)
    up = SpaceBody("Up", stations(h, *x), stations(
        h, uniform(rng, -0.1, 0.1) * s, uniform(rng, 0.4, 0.7) * s),
        stations(h, *z), shape=lean,
        keep=lambda a, b, c: c < z[1] or x[1] < a < x[2])
    up.group("Head", lambda x, y, z, side: side == "above" and z > 0.8 * s)
    up.group("Out", lambda x, y, z, side: z < 0.8 * s and side not in (
        "front", "back"))
    scene = scene_of(rng, "tslot", seed, low, up)
    more = uniform(rng, 0.003, 0.02) * s
    scene.approach = more
    return drive(rng, scene, (rng.choice([0, ways(rng, s, (left, right))]), 0,
                              rng.choice([lip + more, lip + more,
                                          -floor - more])))


def labyrinth(rng, seed):
    """Steps up or down, one to three of them."""
    s = size(rng)
    n = rng.randint(1, 2)
    places = [s * (k + uniform(rng, 0.8, 1.2)) / (n + 1) for k in range(n)]
    levels = [0.4 * s]
    for _ in range(n):
        levels.append(levels[-1] + rng.choice([-1, 1]) * uniform(
            rng, 0.1, 0.15) * s)
    gx, gz = clearance(rng, s), clearance(rng, s)
    lean = leaning(rng)
    rises = [b > a for a, b in zip(levels, levels[1:])]
    other = [x - gx if r else x + gx for x, r in zip(places, rises)]
    level = lambda x, at: levels[sum(x > a for a in at)]
    heights = sorted(set(levels))
    ends = lambda x: 0 < round(x / s, 9) < 1
    step = lambda x, y, z, side: side in ("left", "right") and ends(x)
    h = cell(rng, s)
    low = SpaceBody("Low", stations(h, 0, *places, s), stations(h, 0, 0.6 * s),
                    stations(h, 0, *heights), shape=lean,
                    keep=lambda x, y, z: z < level(x, places))
    low.group("Base", lambda x, y, z, side: side == "below")
    low.group("In", lambda *at: at[3] == "above" or step(*at))
    h = cell(rng, s)
    up = SpaceBody("Up", stations(h, 0, *other, s), stations(
        h, uniform(rng, -0.1, 0.1) * s, uniform(rng, 0.4, 0.7) * s), stations(
            h, *(z + gz for z in heights), 0.9 * s), shape=lean,
        keep=lambda x, y, z: z > level(x, other) + gz)
    up.group("Head", lambda x, y, z, side: side == "above")
    up.group("Out", lambda *at: at[3] == "below" or step(*at))
    scene = scene_of(rng, "labyrinth", seed, low, up)
    down = uniform(rng, 0.002, 0.015) * s
    scene.approach = down
    if gz == 0 and rng.random() < 0.2:
        return push(rng, scene)
    return drive(rng, scene, (ways(rng, s, (gx, gx)), 0, -gz - down))


def rim(rng, seed):
    """The corner of a block over the corner of another one: groups of the face
    and both flanks of either."""
    s = size(rng)
    lean = leaning(rng)
    h = cell(rng, s)
    low = SpaceBody("Low", stations(h, 0, s), stations(h, 0, s), stations(
        h, 0, 0.5 * s), shape=lean)
    low.group("Base", lambda x, y, z, side: side == "below")
    low.group("In", lambda x, y, z, side: side in ("above", "right", "back"))
    h = cell(rng, s)
    gap = clearance(rng, s)
    x, y = uniform(rng, 0.3, 0.8) * s, uniform(rng, 0.3, 0.8) * s
    z = 0.5 * s + gap
    up = SpaceBody("Up", stations(h, x, x + 0.8 * s), stations(
        h, y, y + 0.8 * s), stations(h, z, z + 0.3 * s, z + 0.5 * s),
        shape=lean)
    up.group("Head", lambda x, y, z, side: side == "above")
    up.group("Out", lambda a, b, c, side: side == "below" or (
        side in ("left", "front") and c < z + 0.3 * s))
    scene = scene_of(rng, "rim", seed, low, up)
    down = uniform(rng, 0.002, 0.02) * s
    scene.approach = down
    aside = [rng.choice([0, uniform(rng, -0.02, 0.02) * s]) for _ in range(2)]
    return drive(rng, scene, (*aside, -gap - down))


KINDS = (key, tslot, tray, labyrinth, beside_wall, rim)
