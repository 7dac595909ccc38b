#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the oracle does about surfaces that go round edges, without the program.

- Groups are cut into the sides that they are drawn of, and no others.
- Our own solution of contact: a block that fills a tray carries what a confined
  one does, in 2-D and in 3-D, on meshes that do not match; turned as a
  whole it is the same.
- Such a solution passes the checks of a result; with a block that is deeper at an
  edge, forces that are turned there, a shear without friction, it does not."""
import json
import pathlib
import random
import sys
import tempfile

import numpy as np

import check
import fem
import kinds_sides
import oracle
import own_contact
import sides
import sides_check
from grids import Body, block, ticks
from results import Run
from scene import Scene
from space_fem import SpaceModel
from space_grids import SpaceBody, brick
from space_scene import SpaceScene, THIRD

failures = 0
YOUNG, POISSON, DOWN = 1000.0, 0.3, 0.01
CONFINED = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))


def expect(what, ok, detail=""):
    global failures
    failures += not ok
    print("%-4s %s %s" % ("ok" if ok else "BAD", what, detail))


def cuts():
    for kind, wanted in (("tslot", {7}), ("tray", {2, 3}), ("key", {4, 5}),
                         ("labyrinth", {3, 5, 7}), ("teeth", {5, 9, 13}),
                         ("space_tslot", {7}), ("space_tray", {3, 4, 5}),
                         ("space_key", {5, 6}), ("space_labyrinth", {3, 5}),
                         ("space_beside_wall", {2}), ("space_rim", {3})):
        found, parts = set(), True
        for seed in range(8):
            scene = oracle.make(kind, seed)
            X, lines = scene.mesh.X, scene.mesh.lines
            count = [sides.sides_of(X, lines[g]).max() + 1 for g in (
                "In", "Out")]
            found |= set(count)
            zones = sides.cut(scene).zones
            parts &= len(zones) == count[scene.zones[0].slave == "Out"]
        expect("sides of " + kind, found <= wanted and parts, sorted(found))


def tray(degree=1, space=False, soft=1.0):
    """A block that fills a tray whose walls are `soft` times as hard."""
    wide = lambda n: ticks(0, 1, 1, n, 2, 1, 3)
    if space:
        low = SpaceBody("Low", wide(3), wide(3), ticks(0, 1, 1, 2, 2),
                        keep=lambda x, y, z: z < 1 or not (
                            1 < x < 2 and 1 < y < 2))
        low.group("In", lambda x, y, z, side: 0.9 < x < 2.1 and (
            0.9 < y < 2.1) and 0.9 < z < 1.99)
        low.group("Base", lambda x, y, z, side: not (
            0.1 < x < 2.9 and 0.1 < y < 2.9 and z > 0.5))
        up = brick("Up", (1, 1, 1), (2, 2, 2), (2, 2, 3))
        up.group("Out", lambda x, y, z, side: side != "above")
        scene = SpaceScene("tray", 0, [low, up], {})
        scene.hold("Base", 0, 0, 0).hold("Up_above", None, None, -DOWN)
    else:
        low = Body("Low", wide(5), ticks(0, 1, 1, 3, 2),
                   keep=lambda x, y: y < 1 or not 1 < x < 2)
        low.group("In", lambda x, y, side: 0.9 < x < 2.1 and 0.9 < y < 1.99)
        low.group("Base", lambda x, y, side: not (0.1 < x < 2.9 and y > 0.5))
        up = block("Up", 1, 1, 2, 2, 3, 4)
        up.group("Out", lambda x, y, side: side != "above")
        scene = Scene("tray", 0, [low, up], {})
        scene.hold("Base", 0, 0).hold("Up_above", None, -DOWN)
    scene.materials = {"Low": (soft * YOUNG, POISSON), "Up": (YOUNG, POISSON)}
    scene.entries.update({"Element/Degree": degree,
                          "Solids/Kinematics": "small strain"})
    scene.round_edges, scene.approach = True, DOWN
    return scene.contact("Out", "In")


def model_of(scene):
    return (fem.Model if len(scene.axes) == 2 else SpaceModel)(scene)


def solved(scene):
    model = model_of(scene)
    return model, own_contact.OwnContact(model, 1.0, 2 * DOWN).solve()


def confined():
    for degree, space in ((1, False), (2, False), (1, True), (2, True)):
        scene = tray(degree, space, 1e4)
        model, own = solved(scene)
        force = own.force()[model.nodes_of("In")].sum(0)
        ratio = force[-1] / (-CONFINED * DOWN)
        expect("confined, degree %d%s" % (degree, ", space" * space),
               abs(ratio - 1) < 0.05 and np.abs(force[:-1]).max() < 1e-6 * abs(
                   force[-1]), "%.4f" % ratio)


def turned():
    scene = tray(1, True)
    model, own = solved(scene)
    other, same = solved(scene.turned(THIRD))
    off = np.abs(same.u - own.u @ THIRD.T).max()
    expect("turned", off < 1e-9 * DOWN, "%.1e" % off)


def state_of(model, u):
    return check.State(model, u, 1.0, np.full(len(u), 1e-16))


def zone_problems(scene, model, state):
    zone = sides_check.SidesCheck(scene, model, state, scene.zones[0], DOWN,
                                  check.shared_nodes(scene, model))
    return zone, [p.reason for p in zone.problems(None)]


def damages():
    for space in (False, True):
        scene = tray(1, space)
        model, own = solved(scene)
        where = ", space" * space
        zone, found = zone_problems(scene, model, state_of(model, own.u))
        # Nodes of the head are of the slave.
        expect("a right result" + where, not found, found)

        # An edge of the block in the floor by half of the way.
        edge = (np.abs(model.X - 1).max(1) < 1e-9) & (model.body_of == 1)
        u = own.u.copy()
        u[edge, -1] -= 0.6 * DOWN
        zone, found = zone_problems(scene, model, state_of(model, u))
        expect("an edge that sinks in" + where, "depth" in found, found)

        state = state_of(model, own.u)
        floor = np.flatnonzero((np.abs(model.X[:, -1] - 1) < 1e-9) & (
            model.body_of == 1) & (np.abs(model.X[:, 0] - 1.5) < 0.3))
        state.residual[floor, -1] *= -1
        _, found = zone_problems(scene, model, state)
        expect("a force that pulls" + where, "cone" in found, found)

        state = state_of(model, own.u)
        state.residual[model.nodes_of("In")] *= 0.7
        _, found = zone_problems(scene, model, state)
        expect("forces that are too small" + where, "net force" in found, found)


def profiles():
    scene = kinds_sides.tray(random.Random(1), 1)
    for rule, mu, shear, wanted in (("mortar", 0.1, 0.2, 0), ("mortar", 0.1, 0.3, 1),
                                    ("Gauss", 0.1, 0.3, 0), ("Gauss", 0, 0.3, 1)):
        scene.rule, scene.zones[0].mu = rule, mu
        with tempfile.TemporaryDirectory() as place:
            out = pathlib.Path(place) / "output" / "case"
            out.mkdir(parents=True)
            (out / "summary.json").write_text(json.dumps({}))
            (out / "profile.csv").write_text(
                "surface,pressure_MPa,shear_MPa\nslave,2,%g\n" % shear)
            found = sides_check.shears(scene, None, None, Run(
                0, "", 0, pathlib.Path(place)))
        expect("a shear of %.2f at a pressure of 2, mu %g, %s" % (shear, mu, rule),
               len(found) == wanted)


if __name__ == "__main__":
    cuts()
    confined()
    turned()
    damages()
    profiles()
    sys.exit(failures > 0)
