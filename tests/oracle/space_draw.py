"""What scenes in 3-D draw: sizes of cells, degree, kinematics, rules, loops,
and how the scene lies in 3-D."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import math

import numpy as np

import draw
from space_grids import brick
from space_scene import SpaceScene, rotation

FRICTION = (0.0, 0.0, 0.1, 0.2, 0.3, 0.5, 1.0)
# As in 2-D, and what hardly changes its volume.
MATERIALS = draw.MATERIALS + ((50, 0.499), (100, 0.4999))


def friction(rng, low=0.0):
    return rng.choice([mu for mu in FRICTION if mu >= low])


def material(rng, soft=True):
    return rng.choice(MATERIALS if soft else MATERIALS[:-4])


def direction(rng, length):
    """Two components, in any direction of the plane."""
    angle = rng.uniform(0, 2 * math.pi)
    return (draw.round_to(length * math.cos(angle)),
            draw.round_to(length * math.sin(angle)))


def two_blocks(rng, kind, seed, gap=0.0, most=5):
    """A block on a wider one."""
    s = draw.size(rng)
    width, depth = (draw.uniform(rng, 0.4, 0.9) * s for _ in range(2))
    x, y = (draw.uniform(rng, 0.05, 0.95) * (s - w) for w in (width, depth))
    h, top = draw.uniform(rng, 0.3, 0.8) * s, draw.uniform(rng, 0.2, 0.6) * s
    n = [rng.randint(2, most) for _ in range(2)]
    m = [rng.randint(1, most - 2) for _ in range(2)]
    low = brick("Low", (0, 0, 0), (s, s, h), (*n, rng.randint(1, 2)))
    up = brick("Up", (x, y, h + gap * s),
               (x + width, y + depth, h + gap * s + top),
               (*m, rng.randint(1, 2)))
    scene = SpaceScene(kind, seed, [low, up], {"Low": material(rng),
                                               "Up": material(rng)})
    return scene.hold("Low_below", 0, 0, 0), s


def settle(rng, scene, increments=(1, 1, 2), large=None, levels=True):
    """Degree, kinematics, rule and increments; a quarter of the scenes gets
    other loops and solvers than the default; many are turned."""
    entries = scene.entries
    scene.rule = rng.choice(["mortar", "mortar", "nodal"])
    if large is None:
        large = rng.random() < 0.6
    if not large:
        entries["Solids/Kinematics"] = "small strain"
    cells = sum(map(len, scene.mesh.cells.values()))
    if rng.random() < 0.3 and cells < 50:
        entries["Element/Degree"] = 2
        if rng.random() < 0.5:
            entries["Element/Centre node"] = "free"
    elif levels and rng.random() < 0.15 and cells < 30 and (
            not scene.mesh.arcs):
        entries["Refinement/Levels"] = 1
    entries["Solution/Increments"] = rng.choice(increments)
    if rng.random() < 0.25:
        other_loops(rng, scene)
    if scene.rule == "nodal":
        draw.prefer_finer(scene)
    return turn(rng, scene)


def other_loops(rng, scene):
    entries = scene.entries
    scene.is_default = False
    geometry = ["fixed point", "each step"]
    if not scene.large:
        geometry.append("undeformed")
    entries["Solution/Geometry"] = rng.choice(geometry)
    if any(zone.mu for zone in scene.zones):
        entries["Solution/Friction"] = rng.choice(
            ["fixed point", "Newton"])
    entries["Solution/Linear solver"] = rng.choice(["CHOLMOD", "AMG", "MUMPS"])
    if rng.random() < 0.2:
        entries["Solids/Dilatation"] = rng.choice(["full", "B-bar"])


def turn(rng, scene):
    """By any angles where supports allow it, or by right angles, or not."""
    choice = rng.random()
    if choice < 0.3:
        return scene
    if choice < 0.65:
        turned = scene.turned(rotation(rng))
        if turned:
            return turned
    axes = rng.sample(range(3), 3)
    R = np.zeros((3, 3))
    R[range(3), axes] = [rng.choice([-1, 1]) for _ in range(3)]
    if np.linalg.det(R) < 0:
        R = -R
    return scene.turned(R) or scene
