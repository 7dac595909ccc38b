#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The oracle in 3-D, tested without the program.

- Forces are the derivatives of an energy, tangents those of the forces, of
  hexahedra of 8, 20 and 27 nodes.
- A patch of skewed elements carries a uniform stress, of all materials; a rotation costs nothing;
  a bar stretches and a cantilever bends as beams do, also where it hardly
  changes its volume.
- Closest places, what is inside, and angles to cones are those of closed forms.
- A right result passes the checks, and each kind of damage to it is found."""
import csv
import json
import math
import pathlib
import random
import sys
import tempfile

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spl

import check
import materials
import motions
import oracle
import space_motion
import space_surfaces
import test_fem
from results import Run
from scene import RAMP, scaled
from space_fem import SpaceModel
from space_grids import brick
from space_scene import SpaceScene, rotation
from space_zone import DualWeights, SpaceZoneCheck, cone_angle, unit
from test_fem import energy, expect

# Degree, and nodes in centres; of tetrahedra the latter say so.
ELEMENTS = ((1, None), (2, "serendipity"), (2, "free"), (1, "tetrahedra"),
            (2, "tetrahedra"))


def body(degree, centre, kinematics, poisson=0.3, bend=0.0):
    scene = SpaceScene("test", 0, [brick(
        "B", (0, 0, 0), (2, 1, 1), (3, 2, 2), shape=lambda x, y, z: (
            x + bend * y * math.sin(3 * x), y + bend * math.sin(x * z + x),
            z + bend * x * y))], {"B": (100.0, poisson)})
    scene.entries.update({"Element/Degree": degree,
                          "Solids/Kinematics": kinematics})
    if centre == "tetrahedra":
        rng = random.Random(3)
        scene.mesh.shaken("B", rng, 0.2).cut(["B"], rng)
    elif centre:
        scene.entries["Element/Centre node"] = centre
    return scene


def ways():
    for degree, centre in ELEMENTS:
        for kinematics in ("small strain", "large displacement"):
            yield degree, centre, kinematics


def derivatives():
    rng = np.random.default_rng(1)
    worst = [0.0, 0.0]
    for way in ways():
        for poisson in (0.3, 0.4999):
            model = SpaceModel(body(*way, poisson, 0.1))
            u, du = (model.following(a * rng.standard_normal(model.X.shape))
                     for a in (0.03, 1.0))
            h = 1e-5
            slope = (energy(model, u + h * du) - energy(model, u - h * du)
                     ) / (2 * h)
            worst[0] = max(worst[0], abs((model.forces(u) * du).sum() / slope
                                         - 1))
            change = (model.forces(u + h * du) - model.forces(u - h * du)
                      ) / (2 * h)
            tangent = (model.tangent(u) @ du.ravel()).reshape(-1, 3)
            worst[1] = max(worst[1], np.abs(change - tangent).max() /
                           np.abs(change).max())
    expect("forces are derivatives of the energy", worst[0] < 1e-6,
           "%.1e" % worst[0])
    expect("tangents are derivatives of the forces", worst[1] < 1e-6,
           "%.1e" % worst[1])


def patch():
    worst = 0.0
    for way in ways():
        model = SpaceModel(body(*way, 0.3, 0.1))
        u = model.X @ np.array([[0.02, 0.3, 0.1], [-0.28, 0.01, 0],
                                [0.05, -0.1, -0.03]])
        inside = np.ones(len(model.X), bool)
        for faces in model.lines.values():
            inside[faces] = False
        f = model.forces(u)
        worst = max(worst, np.abs(f[inside]).max() / np.abs(f).max())
    expect("patch", worst < 1e-12, "%.1e" % worst)


def laws():
    """A skewed patch that yields, and one of rubber: the mean of f X^T is the
    stress, which is on the yield surface, or the derivative of the energy."""
    H = np.array([[0.02, 0.03, 0.01], [-0.01, 0.01, 0], [0.005, -0.01, -0.02]])
    worst = 0.0
    for degree, centre in ELEMENTS:
        for law in (materials.Plastic(100.0, 0.3, 0.5, curve=((1e-3, 0.7),)),
                    materials.Rubber(100.0, 0.45, 5.0)):
            scene = body(degree, centre, "small strain" if law.has_history else
                         "large displacement", 0.3, 0.1)
            scene.laws["B"] = law
            model = SpaceModel(scene)
            f = model.forces(model.X @ H.T)
            inside = np.ones(len(model.X), bool)
            for faces in model.lines.values():
                inside[faces] = False
            volume = sum(block.w.sum() for block in model.blocks)
            P = f.T @ model.X / volume
            if law.has_history:
                s = materials.deviator(P)
                off = abs(math.sqrt(1.5 * (s * s).sum()) / 0.7 - 1) + abs(
                    np.trace(P) / (3 * law.bulk * np.trace(H)) - 1)
            else:
                off = np.abs(P / stress_of(law, H) - 1).max() / 1e6
            worst = max(worst, off, np.abs(f[inside]).max() / np.abs(f).max())
    expect("patches of new materials", worst < 1e-12, "%.1e" % worst)


def stress_of(law, H, h=1e-6):
    """By differences of the energy."""
    def W(F):
        E = (F.T @ F - np.eye(3)) / 2
        return law.shear_energy(E) + law.volume_energy(law.volume(E)[0])
    P = np.zeros((3, 3))
    for i in range(3):
        for j in range(3):
            step = np.zeros((3, 3))
            step[i, j] = h
            P[i, j] = (W(np.eye(3) + H + step) - W(np.eye(3) + H - step)) / (
                2 * h)
    return P


def rigid():
    worst = 0.0
    turn = rotation(random.Random(5))
    for degree, centre in ELEMENTS:
        model = SpaceModel(body(degree, centre, "large displacement", 0.4999,
                                0.1))
        worst = max(worst, np.abs(model.forces(model.X @ turn.T - model.X)
                                  ).max() / 100 / 5000)
    expect("a rotation costs nothing", worst < 1e-14, "%.1e" % worst)


def bar():
    """By a traction; and by a weight, whose sum the support carries."""
    worst = 0.0
    for degree, centre in ELEMENTS:
        scene = body(degree, centre, "small strain")
        scene.hold("B_left", 0).hold("B_front", None, 0)
        scene.hold("B_below", None, None, 0)
        scene.load("Traction x", "B_right", 2.0)
        u = SpaceModel(scene).solve()
        worst = max(worst, abs(u[:, 0].max() / (2 * 2.0 / 100) - 1),
                    abs(u[:, 1].min() / (-0.3 * 2.0 / 100) - 1))
    expect("bar", worst < 1e-12, "%.1e" % worst)
    scene = body(2, "serendipity", "small strain")
    scene.hold("B_below", 0, 0, 0).load("Body force z", "B", -3.0)
    scene.load("Pressure", "B_above", 1.0)
    model = SpaceModel(scene)
    force = (model.forces(model.solve()) - model.external(1))[
        model.nodes_of("B_below"), 2].sum()
    expect("weight and pressure", abs(force / (2 * 3.0 + 2 * 1.0) - 1) < 1e-12)


def cantilever():
    """Timoshenko's beam of square section."""
    for nu in (0.0, 0.4999):
        L, E, F = 20.0, 100.0, 1e-3
        scene = SpaceScene("beam", 0, [brick("B", (0, 0, 0), (L, 1, 1), (
            20, 1, 2)).point("middle", 0, 0, 1)], {"B": (E, nu)})
        scene.entries.update({"Element/Degree": 2,
                              "Solids/Kinematics": "small strain"})
        scene.hold("B_left", 0).hold("middle", None, None, 0)
        scene.hold("B_front B_back" if nu == 0 else "middle", None, 0)
        scene.load("Resultant force z", "B_right", -F)
        scene.load("Displacement y", "B_front", 0)
        u = SpaceModel(scene).solve()
        exact = -F * (4 * L ** 3 / E + 6 * L / 5 / (E / 2 / (1 + nu)))
        # A fine cross section would take more elements where nu is not 0.
        off = abs(u[:, 2].min() / exact - 1)
        expect("cantilever, nu %g" % nu, off < 0.01, "%.1e" % off)


def geometry():
    """Of quadrangles and triangles, of either degree."""
    for degree in (1, 2):
        for tetrahedra in (False, True):
            scene = SpaceScene("cube", 0, [brick(
                "B", (0, 0, 0), (1, 1, 1), (2, 3, 2))], {"B": (1.0, 0.0)})
            if tetrahedra:
                scene.mesh.cut(["B"], random.Random(degree))
            scene.entries["Element/Degree"] = degree
            geometry_of(SpaceModel(scene))


def geometry_of(model):
    cube = space_surfaces.Facets(model.complete(
        model.scene.mesh.boundary["B"]), model.X)
    p = np.random.default_rng(3).uniform(-0.5, 1.5, (400, 3))
    inside = ((p > 0) & (p < 1)).all(1)
    expect("inside", (cube.contains(p) == inside).all())
    depth = np.minimum(p, 1 - p).min(1)
    outside = np.linalg.norm(p - np.clip(p, 0, 1), axis=1)
    off = np.abs(cube.closest(p)[0] - np.where(inside, depth, outside)).max()
    expect("distance", off < 1e-12, "%.1e" % off)
    above = space_surfaces.Facets(model.lines["B_above"], model.X)
    expect("normals", np.allclose(above.normal, (0, 0, 1)))
    _, triangle, foot, shapes = above.closest(p)
    places = np.einsum("pa,pai->pi", shapes, model.X[
        above.faces[above.face[triangle]]])
    expect("places on a face", np.allclose(places, foot))
    cone = [(1, 0, 0), (0, 1, 0)]
    angles = [cone_angle(np.array(f, float), cone) for f in (
        (3, 1, 0), (1, 1, math.sqrt(2)), (-1, 0, 0), (1, -1, 0))]
    exact = [0, math.pi / 4, math.pi / 2, math.pi / 4]
    expect("angles to a cone", np.allclose(angles, exact, atol=1e-7),
           str(angles))


def bent_face():
    """Gaps of a bent face, which has chords; and faces that a rim passes over,
    however narrow the strip is that it cuts off."""
    for tetrahedra in (False, True):
        bent_faces(tetrahedra)


def bent_faces(tetrahedra):
    def block(low, side, n):
        scene = SpaceScene("face", 0, [brick(
            "B", low, (low[0] + side, low[1] + side, low[2] + 1), (n, n, 1))],
            {"B": (1.0, 0.0)})
        scene.entries["Element/Degree"] = 2
        if tetrahedra:
            scene.mesh.cut(["B"], random.Random(1))
        return SpaceModel(scene.contact("B_below", "B_above", 0.0))

    model = block((0, 0, 0), 2, 2)
    bend = lambda X, Y: 0.1 * (X * X + X * Y)
    x = model.X.copy()
    x[:, 2] -= bend(x[:, 0], x[:, 1])
    master = space_surfaces.DeformedBody(model, model.scene.zones[0], x)
    a, b = np.random.default_rng(4).uniform(0.01, 1.99, (2, 300))
    on = np.stack([a, b, 1 - bend(a, b)], 1)
    chords = np.abs(master.gap(on)).max()
    expect("a bent face has chords", chords > 1e-3, "%.1e" % chords)
    normal = unit(np.stack([0.1 * (2 * a + b), 0.1 * a, np.ones_like(a)], 1))
    for up in (-0.01, -1e-5, 0, 1e-5, 0.01):
        off = np.abs(master.exact_gap(on + up * normal) - up)
        # Beyond its edges the closest place is another one.
        off = off[np.abs(on + up * normal - 1)[:, :2].max(1) < 0.98].max()
        expect("gap %g of a bent face" % up, off < 1e-9, "%.1e" % off)
    beside = np.array([[-0.1, 1.0, 0.99], [2.001, 1.0, 0.0]])
    expect("beside a face", (master.exact_gap(beside) > 0).all())

    ground = block((0, 0, 0), 3, 3)
    ground = space_surfaces.Facets(ground.lines["B_above"], ground.X)
    for low, high, faces in ((1, 2, []), (0.999, 2, [0, 1, 3]),
                             (1.001, 1.999, [4]), (1, 2.001, [5, 7, 8])):
        block_ = block((low, low, 1.0001), high - low, 1)
        rim = space_surfaces.Facets(block_.lines["B_below"], block_.X).rim()
        # Two triangles of each quadrangle, of which one has most of a strip.
        found = list(np.unique(np.flatnonzero(ground.crossed(rim)) //
                               (1 + tetrahedra)))
        expect("faces that a rim from %g to %g passes over" % (low, high),
               found == faces, str(found))


def functions():
    """Under a uniform pressure vertices of triangles of 6 nodes have no force,
    their functions have; dual functions weight a field of the slave by them."""
    scene = pressed_block()
    scene.mesh.cut(["Up"], random.Random(1))
    scene.entries["Element/Degree"] = 2
    scene.rule = "mortar"
    model = SpaceModel(scene.load("Pressure", "Up_below", 1.0))
    u = 0 * model.X
    zone = SpaceZoneCheck(scene, model, check.State(model, u, 1.0, np.full(
        len(u), 1e-16)), scene.zones[0], 0.01, np.zeros(len(u), bool))
    f = -model.loads["Pressure"][zone.nodes, 2]
    force = zone.transform @ f
    expect("forces on functions", abs(f).min() < 1e-12 < 0.01 < -force.max() and
           abs(force.sum() + 4) < 1e-12, "%.2g %.2g" % (f.max(), force.max()))
    field = np.random.default_rng(6).standard_normal(u.shape)
    w = DualWeights(zone)
    off = np.abs(w.of_nodes(np.einsum(
        "qa,fai->fqi", w.shapes, field[w.faces]).reshape(-1, 3)) -
        zone.of_functions(field[zone.nodes])).max()
    expect("dual functions weight places", off < 1e-12, "%.1e" % off)


# Damage.
def pressed_block(mu=0.0, shift=0.0):
    low = brick("Low", (0, 0, 0), (4, 4, 1), (4, 4, 2))
    up = brick("Up", (1 - shift, 1, 1), (3 - shift, 3, 2), (2, 2, 2))
    scene = SpaceScene("damage", 0, [low, up], {"Low": (100.0, 0.3),
                                                "Up": (100.0, 0.3)},
                       rule="nodal")
    scene.entries.update({"Solids/Kinematics": "small strain",
                          "Solution/Increments": 1})
    scene.hold("Low_below", 0, 0, 0).hold("Up_above", 0, 0, -0.02)
    return scene.contact("Up_below", "Low_above", mu)


def pairs(model):
    """The nodes of the sole and those of the ground below them."""
    ground = model.nodes_of("Low_above")
    return [(s, ground[np.abs(model.X[ground] - model.X[s]).max(1) < 0.01][0])
            for s in model.nodes_of("Up_below")]


def tied(scene, axes, jump=None):
    """The sole moves with the ground along these axes, the first ones by a jump
    more: linear, so by elimination."""
    model = SpaceModel(scene)
    held, value = model.supports(1.0)
    n = model.X.size
    master, fixed = {}, (value * held).ravel()
    for s, m in pairs(model):
        for d in axes:
            master[3 * s + d] = 3 * m + d
            fixed[3 * s + d] = (jump or {}).get(d, 0.0)
    free = [k for k in range(n) if not held.ravel()[k] and k not in master]
    number = {k: i for i, k in enumerate(free)}
    entries = [(k, number[master.get(k, k)]) for k in range(n)
               if master.get(k, k) in number]
    rows, columns = zip(*entries)
    T = sp.csc_matrix((np.ones(len(rows)), (rows, columns)), (n, len(free)))
    K = model.tangent(np.zeros_like(model.X))
    x = spl.spsolve((T.T @ K @ T).tocsc(), -(T.T @ (K @ fixed)))
    return model, (T @ x + fixed).reshape(-1, 3)


def run_with(model, u, directory):
    """What a run of the program with these displacements would have left."""
    state = check.State(model, u, 1.0, np.full(len(u), 1e-16))
    output = directory / "output" / "case"
    output.mkdir(parents=True, exist_ok=True)
    force = np.where(state.on_surface[:, None] & ~state.held, state.residual, 0)
    with open(output / "nodes.csv", "w", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(["body", "piece"] + list("XYZxyzabc"))
        for n, X in enumerate(model.X):
            rows.writerow([model.scene.mesh.bodies[model.body_of[n]], 0] + [
                repr(float(v)) for v in (*X, *u[n], *force[n])])
    probes = {"%s%d" % ("xyz"[d], k): u[k, d] for k in range(len(u))
              for d in range(3)}
    reactions = {g: {axis: state.residual[model.nodes_of(g), d].sum()
                     for d, axis in enumerate("xyz")}
                 for g in ("Low_below", "Up_above")}
    (output / "summary.json").write_text(json.dumps({
        "converged": True, "increments": [{
            "converged": True, "load_factor": 1.0, "probes": probes,
            "reactions": reactions}]}))
    return Run(0, "", 0.0, directory)


def reasons(scene, u, directory, change=None):
    run = run_with(SpaceModel(scene), u, directory)
    if change:
        change(run)
    return [p.reason for p in check.problems(scene, run)]


def damage():
    scene = pressed_block()
    model, u = tied(scene, [2])
    sole = model.nodes_of("Up_below")
    above = np.flatnonzero(model.body_of == 1)
    inner = np.flatnonzero((model.X == (2, 2, 1.5)).all(1))
    with tempfile.TemporaryDirectory() as place:
        place = pathlib.Path(place)

        def expect_reason(what, reason, v, scene=scene, change=None):
            found = reasons(scene, v, place, change)
            expect("found: " + what, reason in found, str(found))
        found = reasons(scene, u, place)
        expect("a right result passes", not found, str(found))
        v = u.copy()
        v[inner] += 1e-6
        expect_reason("a node that is not in equilibrium", "equilibrium", v)
        v = u.copy()
        v[above] += (0, 0, 1e13)
        expect_reason("a body that has flown away", "flown away", v)
        v = u.copy()
        v[model.nodes_of("Up_above"), 0] += 1e-4
        expect_reason("a wrong support", "support", v)
        v = u.copy()
        v[inner] = np.nan
        expect_reason("not a number", "not a number", v)
        pulled = pressed_block()
        pulled.boundary["Displacement z"]["Up_above"] = 0.02
        expect_reason("tension", "tension", -u, pulled)
        fixed = np.zeros(model.X.shape, bool)
        fixed[sole] = True
        v = u.copy()
        v[sole, 2] -= 0.003
        v = model.solve(fixed=fixed, u=v)
        expect_reason("unequal forces", "balance", v)
        expect_reason("penetration", "penetration", v)

        def other_force(run):
            file = run.directory / "nodes.csv"
            lines = file.read_text().split("\n")
            for k, line in enumerate(lines):
                if line.startswith("Up,0,2.0,2.0,1.0,"):
                    lines[k] = line.rstrip("\r").rsplit(",", 1)[0] + ",-1.0"
            file.write_text("\n".join(lines))
        expect_reason("a wrong force of contact", "contact force", u,
                      change=other_force)
        expect_reason("a wrong reaction", "reaction", u, change=lambda run: run
                      .summary["increments"][0]["reactions"]["Up_above"].update(
                          z=-1.0))
        _, v = tied(scene, [0, 1, 2])
        expect_reason("shear without friction", "cone", v)
        stuck = [p for p in reasons(pressed_block(1.0), v, place)]
        expect("what sticks passes", not stuck, str(stuck))
        friction_damage(place)


def mortar_damage():
    """Triangles that lie on each other, of either degree: a gap of a fiftieth of
    the displacement where a force acts, and forces that push what they have pushed
    apart."""
    for degree in (1, 2):
        scene = pressed_block(1.0)
        scene.rule = "mortar"
        scene.entries["Element/Degree"] = degree
        scene.mesh.cut(scene.mesh.bodies, SameDiagonals())
        model, u = tied(scene, [0, 1, 2])

        def zone_of(u):
            state = check.State(model, u, 1.0, np.full(len(u), 1e-16))
            return SpaceZoneCheck(scene, model, state, scene.zones[0], 0.02,
                                  np.zeros(len(u), bool))
        zone = zone_of(u)
        expect("functions of one dual function each", zone.alone.all())
        found = list(map(str, zone.problems(None)))
        expect("a right result with triangles passes", not found, str(found))
        fixed = np.zeros(model.X.shape, bool)
        sole = model.nodes_of("Up_below")
        fixed[model.nodes_of("Low_above")] = fixed[sole] = True
        middle = sole[np.abs(model.X[sole] - (2, 2, 1)).max(1) < 0.01]
        for up, reason in ((4e-4, "force at a gap"),
                           (-4e-4, "weighted penetration")):
            v = u.copy()
            v[middle, 2] += up
            found = [p.reason for p in zone_of(model.solve(
                fixed=fixed, u=v)).problems(None)]
            expect("found: a node %g mm up" % up, reason in found, str(found))
        before = check.State(model, u - 0.01 * (model.body_of == 1)[:, None] * (
            0, 0, 1), 0.5, np.full(len(u), 1e-16))
        found = [p.reason for p in zone.problems(before)]
        expect("found: contact that does work", found == ["work"], str(found))


class SameDiagonals:
    """In the place of random numbers."""

    def randrange(self, n):
        return 0


def obstacle_damage():
    """A plane that has come up by 0.01: its force and way as they are said, and
    others; material of it that turns below what is at rest makes shears."""
    scene = SpaceScene("test", 0, [brick("B", (0, 0, 0), (2, 1, 1), (2, 2, 1))],
                       {"B": (100.0, 0.3)})
    scene.entries["Solids/Kinematics"] = "small strain"
    scene.hold("B_above", 0, 0, 0)
    up = scaled(0.01, RAMP)
    scene.contact("B_below", None, 0.0, obstacle="half space: 0, 0, 0, 0, 0, 1",
                  motion={"z": up})
    model = SpaceModel(scene)
    fixed = np.zeros(model.X.shape, bool)
    sole = model.nodes_of("B_below")
    fixed[sole, 2] = True
    u = np.zeros(model.X.shape)
    u[sole, 2] = 0.01
    u = model.solve(fixed=fixed, u=u)
    force = model.forces(u)[sole]
    moment = np.cross(model.X[sole] + u[sole] - (0, 0, 0.01), force).sum(0)
    right = {"obstacle_motion_z": 0.01, **{
        "obstacle_%s_%s" % (name, axis): value
        for name, values in (("force", force.sum(0)), ("moment", moment))
        for axis, value in zip("xyz", values)}}

    def judge(**other):
        state = check.State(model, u, 1.0, np.full(len(u), 1e-16), {
            "contact": {**right, **other}})
        return [p.reason for p in space_motion.zone_check_of(
            scene, model, state, scene.zones[0], 0.01, np.zeros(
                len(u), bool)).problems(None)]
    expect("an obstacle that has moved passes", not judge(), str(judge()))
    for key in ("obstacle_force_z", "obstacle_moment_x", "obstacle_motion_z"):
        expect("found: another " + key, judge(**{key: 1.001 * right[key]}) == [
            "obstacle"])
    scene.zones[0].force["z"] = scaled(1.001 * force[:, 2].sum(), RAMP)
    expect("found: another force that is given", judge() == ["obstacle"])
    del scene.zones[0].force["z"]
    scene.zones[0].motion["z"] = scaled(0.008, RAMP)
    expect("found: a force at a distance", "force without contact" in judge(
        obstacle_motion_z=0.008))
    check_ = space_motion.zone_check_of(
        scene, model, check.State(model, u, 1.0, np.full(len(u), 1e-16), {}),
        scene.zones[0], 0.01, np.zeros(len(u), bool))
    check_.placed_before = motions.placement(scene.zones[0], 0.0, {})
    scene.zones[0].motion["angle"] = scaled(90, RAMP)
    check_.state.placements = motions.placements(scene, 1.0, {})
    slip = check_.slip(u)[0]
    x = model.X[sole] + u[sole]
    # What is at (x, y) now was at (y, -x).
    off = np.abs(slip[:, :2] - u[sole][:, :2] + x[:, :2] - np.stack(
        [x[:, 1], -x[:, 0]], 1)).max()
    expect("slip on what turns", off < 1e-14, "%.1e" % off)


def friction_damage(place):
    """Shears of equal and opposite size that drive the slip, and that are less
    than mu p where all slips."""
    for along, jump, what in ((0.01, -0.002, "friction that does work"),
                              (0.0, 0.0005, "friction less than mu p")):
        scene = pressed_block(1.0, jump)
        scene.hold("Up_above", along)
        _, u = tied(scene, [0, 1, 2], {0: jump})
        found = reasons(scene, u, place)
        expect("found: " + what, found == ["friction"], str(found))


def turned():
    """Turned scenes: the energy of a field that is turned along is the same."""
    rng = random.Random(2)
    scene = oracle.make("space_glued", 1)
    scene.entries["Element/Degree"] = 1
    R = rotation(rng)
    other = scene.turned(R)
    u = 1e-3 * np.random.default_rng(2).standard_normal(scene.mesh.X.shape)
    if other is None:
        expect("turned", False)
        return
    ratio = energy(SpaceModel(other), u @ R.T) / energy(SpaceModel(scene), u)
    expect("turned", abs(ratio - 1) < 1e-12, "%.1e" % (ratio - 1))
    renumbered = scene.renumbered(rng)
    v = np.empty_like(u)
    v[renumbered.mesh.order] = u
    ratio = energy(SpaceModel(renumbered), v) / energy(SpaceModel(scene), u)
    expect("renumbered", abs(ratio - 1) < 1e-12, "%.1e" % (ratio - 1))


def scenes():
    """Every kind makes scenes, the same ones each time, whose mesh is whole."""
    for kind in (*oracle.SPACE, *oracle.TETRAHEDRA):
        texts = []
        for _ in range(2):
            scene = oracle.make(kind, 3)
            SpaceModel(scene.judged())
            texts.append(scene.mesh.text() + scene.parameters())
        expect("scenes of the kind " + kind, texts[0] == texts[1])


if __name__ == "__main__":
    for test in (derivatives, patch, laws, rigid, bar, cantilever, geometry,
                 bent_face, functions, damage, mortar_damage, obstacle_damage, turned,
                 scenes):
        test()
    sys.exit(test_fem.failures > 0)
