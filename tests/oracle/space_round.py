"""Scenes of round bodies in 3-D, and of rigid obstacles."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import math

from draw import size, swap, uniform
from space_blocks import stiffness, then_drag
from space_draw import direction, friction, material, settle
from space_grids import SpaceBody, brick, ticks
from space_scene import SpaceScene


def cap(name, centre, radius, n, m, reach=0.8, below=True):
    """The lower (upper) cap of a hollow ball: NAME_skin, NAME_hub."""
    up = -1 if below else 1

    def shape(u, v, w):
        r = radius * (1 - 0.6 * w if below else 0.4 + 0.6 * w)
        size_ = math.sqrt(u * u + v * v + 1)
        return (centre[0] + r * u / size_, centre[1] + r * v / size_,
                centre[2] + up * r / size_)
    body = SpaceBody(name, ticks(-reach, n, reach), ticks(-reach, n, reach),
                     ticks(0, m, 1), shape=shape)
    skin, hub = ("below", "above") if below else ("above", "below")
    body.group(name + "_skin", lambda x, y, z, side: side == skin)
    return body.group(name + "_hub", lambda x, y, z, side: side == hub)


def trough(name, centre, radius, length, n, m, below=True, along="y"):
    """The lower (upper) part of a hollow cylinder."""
    up = -1 if below else 1

    def shape(u, v, w):
        r = radius * (1 - 0.6 * w if below else 0.4 + 0.6 * w)
        x, y = r * math.sin(u), v
        if along == "x":
            x, y = -y, x
        return centre[0] + x, centre[1] + y, centre[2] + up * r * math.cos(u)
    body = SpaceBody(name, ticks(-1, n[0], 1), ticks(-length / 2, n[1],
                                                     length / 2),
                     ticks(0, m, 1), shape=shape)
    skin, hub = ("below", "above") if below else ("above", "below")
    body.group(name + "_skin", lambda x, y, z, side: side == skin)
    return body.group(name + "_hub", lambda x, y, z, side: side == hub)


def ring(name, inner, outer, length, n, m):
    """A tube about the z axis: NAME_front is the bore, NAME_back the skin."""
    return SpaceBody(
        name, ticks(0, n, 1), ticks(inner, m[0], outer),
        ticks(-length / 2, m[1], length / 2), closed=True,
        shape=lambda u, r, z: (r * math.cos(2 * math.pi * u),
                               -r * math.sin(2 * math.pi * u), z)).sides()


def press(rng, scene, name, s, depth=(0.002, 0.02)):
    scene.hold(name, 0, 0, -uniform(rng, *depth) * s)
    if rng.random() < 0.4:
        then_drag(scene, rng, name, uniform(rng, 0.002, 0.05) * s)
    return settle(rng, scene, levels=False)


def flat(rng, s, width=1.0):
    return brick("Low", (-width * s, -width * s, -0.6 * s),
                 (width * s, width * s, 0), (rng.randint(3, 6),
                                             rng.randint(3, 6), 2))


def sphere(rng, seed):
    """A ball on a block."""
    s = size(rng)
    ball = cap("Up", (0, 0, s), s, rng.randint(3, 6), 2)
    scene = SpaceScene("sphere", seed, [flat(rng, s), ball], {
        "Low": material(rng, False), "Up": material(rng)},
        arcs={"Up_skin": ("Spheres", (0, 0, s, s))})
    scene.hold("Low_below", 0, 0, 0)
    scene.contact(*swap(rng, "Up_skin", "Low_above"), friction(rng))
    return press(rng, scene, "Up_hub", s)


def balls(rng, seed):
    """A ball on another one, above it or a little beside."""
    s = size(rng)
    radius = uniform(rng, 0.6, 1.5) * s
    x, y = direction(rng, rng.choice([0, 0.2 * s]))
    rise = math.sqrt((s + radius) ** 2 - x * x - y * y) - radius
    up = cap("Up", (x, y, rise), s, rng.randint(3, 6), 2)
    low = cap("Low", (0, 0, -radius), radius, rng.randint(3, 6), 2, below=False)
    scene = SpaceScene("balls", seed, [low, up], {
        "Low": material(rng, False), "Up": material(rng, False)},
        arcs={"Up_skin": ("Spheres", (x, y, rise, s)),
              "Low_skin": ("Spheres", (0, 0, -radius, radius))})
    scene.hold("Low_hub", 0, 0, 0)
    scene.contact(*swap(rng, "Up_skin", "Low_skin"), friction(rng))
    return press(rng, scene, "Up_hub", s)


def roller(rng, seed):
    """A cylinder lying on a block."""
    s = size(rng)
    n = (rng.randint(4, 6), rng.randint(2, 4))
    up = trough("Up", (0, 0, s), s, uniform(rng, 0.5, 2.5) * s, n, 2)
    scene = SpaceScene("roller", seed, [flat(rng, s), up], {
        "Low": material(rng, False), "Up": material(rng)},
        arcs={"Up_skin": ("Cylinders", (0, 0, s, 0, 1, 0, s))})
    scene.hold("Low_below", 0, 0, 0)
    scene.contact(*swap(rng, "Up_skin", "Low_above"), friction(rng))
    return press(rng, scene, "Up_hub", s)


def crossed(rng, seed):
    """A cylinder across another one."""
    s = size(rng)
    n = (rng.randint(4, 7), rng.randint(3, 6))
    up = trough("Up", (0, 0, s), s, 1.5 * s, n, 2)
    low = trough("Low", (0, 0, -s), s, 1.5 * s, n[::-1], 2, False, "x")
    scene = SpaceScene("crossed", seed, [low, up], {
        "Low": material(rng, False), "Up": material(rng, False)},
        arcs={"Up_skin": ("Cylinders", (0, 0, s, 0, 1, 0, s)),
              "Low_skin": ("Cylinders", (0, 0, -s, 1, 0, 0, s))})
    scene.hold("Low_hub", 0, 0, 0)
    scene.contact(*swap(rng, "Up_skin", "Low_skin"), friction(rng))
    return press(rng, scene, "Up_hub", s)


def pin(rng, seed):
    """A hollow pin in a hole, with play or tight, pressed to one side and
    perhaps drawn along."""
    s = size(rng)
    n = rng.choice([12, 16])
    play = rng.choice([0.0, 0.001, 0.01, 0.05]) * s
    hub = ring("Hub", s, 2 * s, s, rng.choice([n, n + 4]), (2, 2))
    bolt = ring("Pin", 0.4 * s, s - play, 1.3 * s, n, (2, rng.randint(2, 3)))
    scene = SpaceScene("pin", seed, [hub, bolt], {
        "Hub": material(rng, False), "Pin": material(rng, False)},
        arcs={"Hub_front": ("Cylinders", (0, 0, 0, 0, 0, 1, s)),
              "Pin_back": ("Cylinders", (0, 0, 0, 0, 0, 1, s - play))})
    scene.hold("Hub_back", 0, 0, 0)
    a, b = direction(rng, play + uniform(rng, 0.001, 0.01) * s)
    scene.hold("Pin_front", a, b, rng.choice([0, uniform(rng, 0, 0.02) * s]))
    scene.contact(*swap(rng, "Pin_back", "Hub_front"), friction(rng))
    return settle(rng, scene, (1, 2), levels=False)


def shrink(rng, seed):
    """A ring that is too narrow for what is in it."""
    s, n = size(rng), rng.choice([12, 16])
    over = uniform(rng, 0.0005, 0.005) * s
    hub = ring("Hub", s, 1.5 * s, 0.6 * s, n, (2, 2))
    tube = ring("Tube", 0.6 * s, s + over, 1.0 * s, n, (2, 3))
    scene = SpaceScene("shrink", seed, [hub, tube], {
        "Hub": material(rng, False), "Tube": material(rng, False)},
        arcs={"Hub_front": ("Cylinders", (0, 0, 0, 0, 0, 1, s)),
              "Tube_back": ("Cylinders", (0, 0, 0, 0, 0, 1, s + over))})
    scene.hold("Hub_back Tube_front", 0, 0, 0)
    scene.contact(*swap(rng, "Tube_back", "Hub_front"), friction(rng))
    return settle(rng, scene, levels=False)


def obstacle(rng, seed):
    """A block or a ball on a rigid plane, ball or cylinder, or in a hole."""
    s = size(rng)
    if rng.random() < 0.5:
        n = rng.randint(2, 7)
        body = brick("Up", (-s / 2, -s / 2, 0), (s / 2, s / 2, 0.8 * s), (
            n, rng.randint(2, 7), 3))
        sole, top, arcs = "Up_below", "Up_above", {}
    else:
        body = cap("Up", (0, 0, s), s, rng.randint(3, 6), 2)
        sole, top = "Up_skin", "Up_hub"
        arcs = {"Up_skin": ("Spheres", (0, 0, s, s))}
    scene = SpaceScene("obstacle", seed, [body], {"Up": material(rng)},
                       arcs=arcs)
    x, y = direction(rng, rng.choice([0, 0.1 * s]))
    a, b = direction(rng, 1)
    r = uniform(rng, 2, 5) * s
    shapes = ["half space: %.12g, %.12g, 0, 0, 0, 1" % (x, y),
              "sphere: 0, 0, %.12g, %.12g" % (-r, r),
              "cylinder: 0, 0, %.12g, %.12g, %.12g, 0, %.12g" % (-r, a, b, r)]
    if arcs:
        shapes.append("sphere: 0, 0, %.12g, %.12g" % (r, -r))
        shapes.append("cylinder: 0, 0, %.12g, %.12g, %.12g, 0, %.12g" % (
            r, a, b, -r))
    scene.contact(sole, None, friction(rng), obstacle=rng.choice(shapes))
    if rng.random() < 0.3:
        scene.hold(top, 0, 0)
        scene.load("Pressure", top, uniform(rng, 0.0005, 0.005) *
                   stiffness(scene))
        return settle(rng, scene, levels=False)
    return press(rng, scene, top, s)


KINDS = (sphere, balls, roller, crossed, pin, shrink, obstacle)
