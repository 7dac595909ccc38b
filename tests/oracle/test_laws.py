#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The oracle's materials, rigid boundaries and moving obstacles, without the
program.

- A radial return ends on the yield surface, flows along its normal, and no
  volume is lost; sheared bodies have the closed form, there and back; a tube of
  no hardening bears Hill's limit load.
- Forces of rubber are the derivatives of an energy summed up here once more, and
  a stretched strip has its closed form; bodies that grow freely are without
  stress, in all materials.
- Slips weighted by dual functions are those of closed forms.
- Another yield stress, a rigid boundary that is none or has another force, a
  surface that parts are found."""
import math
import sys

import numpy as np

import check
import dual_weights
import fem
import materials
import motions
import rigid_check
import test_fem
import zone_check
from grids import block
from scene import Formula, RAMP, Scene, Zone
from test_fem import body, expect

ROOT = math.sqrt(1.5)
# Steep behind a part without hardening.
CURVE = (5e-4, 1.5), (1e-3, 2.0), (2e-3, 2.1), (3e-3, 4.0)


def symmetric(rng, size):
    A = rng.standard_normal((20, 3, 3)) * size
    return (A + A.swapaxes(1, 2)) / 2


def returns():
    """Three increments of random strains: the conditions of the implicit Euler
    method at the end of each."""
    rng = np.random.default_rng(4)
    worst = {}
    for keywords in ({}, {"linear": 30.0}, {"kinematic": 20.0},
                     {"linear": 10.0, "kinematic": 15.0, "saturation": 2.5,
                      "rate": 40.0},
                     {"kinematic": 15.0, "curve": CURVE}):
        law = materials.Plastic(1000.0, 0.3, 1.5, **keywords)
        mu = 1000 / 2.6
        history = law.start((20,))
        for _ in range(3):
            E = symmetric(rng, 2e-3)
            S = law.shear(E, history)
            a, p = law.advance(E, history)
            flow, da = p - history[1], a - history[0]
            xi = S - 2 / 3 * keywords.get("kinematic", 0) * p
            q = ROOT * np.sqrt((xi * xi).sum((1, 2)))
            Y = 1.5 + keywords.get("linear", 0) * a + (keywords.get(
                "saturation", 1.5) - 1.5) * (1 - np.exp(-keywords.get(
                    "rate", 0) * a))
            if "curve" in keywords:
                Y = np.interp(a, *np.array(((0, 1.5),) + CURVE).T)
            size = np.sqrt((flow * flow).sum((1, 2)))
            yields = da > 0
            along = 1.5 * materials.times(da / q, xi)
            for what, off in (
                    ("on the surface", np.where(yields, np.abs(q / Y - 1),
                                                np.maximum(q / Y - 1, 0))),
                    ("along the normal", np.abs(flow - along) / 1e-3),
                    ("without volume", np.abs(materials.trace(flow)) / 1e-3),
                    ("its size", np.abs(da - size / ROOT) / 1e-3),
                    ("the stress", np.abs(S - 2 * mu * (
                        materials.deviator(E) - p)) / 1.5)):
                worst[what] = max(worst.get(what, 0), off.max())
            history = a, p
            assert yields.any()
    for what, off in worst.items():
        expect("radial return: " + what, off < 1e-11, "%.1e" % off)


def sheared():
    """tau by gamma: bilinear, the elastic range wider by isotropic and shifted
    by kinematic hardening when it turns round."""
    G, Y, H, Hk, most = 1000 / 2.6, 1.5, 40.0, 25.0, 0.03
    scene = body(1, None, "plane strain", "small strain")
    scene.laws["B"] = materials.Plastic(1000.0, 0.3, Y, H, Hk)
    model = fem.Model(scene)
    # Per plastic shear: tau - 2/3 Hk e_p = (Y + H a)/sqrt 3, a = g/sqrt 3.
    h = (H + Hk) / 3
    first = Y / math.sqrt(3)
    g = (G * most - first) / (G + h)
    there = G * (most - g)
    isotropic = first + H / 3 * g
    back = G * (0 - g)
    # Reversed: tau - Hk/3 g' = -(isotropic + H/3 (g - g')).
    g_back = g - max(0.0, (-back + Hk / 3 * g - isotropic) / (G + h))
    area = 2.0
    off = 0.0
    for gamma, wanted in ((most, there), (0.0, G * (0 - g_back))):
        u = np.stack([gamma * model.X[:, 1], 0 * model.X[:, 1]], 1)
        f = model.forces(u)[model.nodes_of("B_above"), 0].sum()
        model.advance(u)
        off = max(off, abs(f / area / wanted - 1))
    expect("sheared there and back", off < 1e-12, "%.1e" % off)


def hill():
    """2/sqrt 3 Y ln(b/a): a tube whose bore is widened far beyond."""
    Y, a, b = 1.5, 1.0, 2.0
    scene = Scene("hill", 0, [block("T", a, 0, b, 0.25, 16, 1)],
                  {"T": (1000.0, 0.3)})
    scene.entries.update({"Solids/Kinematics": "small strain",
                          "Solids/Symmetry": "axisymmetric"})
    scene.laws["T"] = materials.Plastic(1000.0, 0.3, Y)
    scene.hold("T_below T_above", None, 0).hold("T_left", 0.05)
    model = fem.Model(scene)
    u = np.zeros_like(model.X)
    for k in range(1, 21):
        u = model.solve(k / 20, 1, u=u)
        force = model.forces(u)[model.nodes_of("T_left"), 0].sum()
        model.advance(u)
    p = force / (2 * math.pi * a * 0.25)
    off = abs(p / (2 / math.sqrt(3) * Y * math.log(b / a)) - 1)
    expect("Hill's limit load", off < 2e-3, "%.1e" % off)


def laws():
    return (materials.Elastic(1000.0, 0.3), materials.Rubber(3.0, 0.45),
            materials.Rubber(3.0, 0.3, 0.3), materials.Plastic(
                1000.0, 0.3, 1.5, 40.0))


def rubber():
    """Forces against differences of the energy, with projection and heat."""
    rng = np.random.default_rng(5)
    worst = 0.0
    for way in test_fem.ways():
        if way[3] == "small strain":
            continue
        for law in laws()[1:3]:
            scene = body(*way, 0.3, 0.1)
            scene.laws["B"] = law
            scene.thermal["B"] = Formula("", lambda t: 0.02)
            scene.entries["Solids/Dilatation"] = "B-bar"
            model = fem.Model(scene)
            model.at(1.0)
            u = 0.01 * rng.standard_normal(model.X.shape)
            du = rng.standard_normal(model.X.shape)
            h = 1e-6
            slope = (energy(model, law, u + h * du) -
                     energy(model, law, u - h * du)) / (2 * h)
            off = abs((model.forces(u) * du).sum() / slope - 1)
            worst = max(worst, off if np.isfinite(off) else np.inf)
    expect("forces of rubber are derivatives", worst < 1e-6, "%.1e" % worst)


def energy(model, law, u):
    """Cell by cell, with the projection of the tables."""
    total = 0.0
    for b in model.blocks:
        for e, cell in enumerate(b.cells):
            J, shear = [], []
            for q in range(len(b.N)):
                F = np.eye(3)
                F[:2, :2] += u[cell].T @ b.dN[e, q]
                if b.hoop is not None:
                    F[2, 2] += b.hoop[e, q] @ u[cell][:, 0]
                C = F.T @ F - 2 * (0.02 + 0.0002) * np.eye(3)
                J.append(np.linalg.det(C) ** 0.5)
                I1, I2 = np.trace(C), (np.trace(C) ** 2 - np.trace(C @ C)) / 2
                shear.append((law.mu / 2 - law.c01) * (I1 * J[-1] ** (-2 / 3) -
                                                       3) +
                             law.c01 * (I2 * J[-1] ** (-4 / 3) - 3))
            w, J = b.w[e], np.array(J)
            P = b.modes[e] @ (b.modes[e].T @ (w * J))
            total += w @ (np.array(shear) + law.bulk / 4 * (
                P * P - 1 - 2 * np.log(P)))
    return total


def strip():
    """An incompressible strip in plane strain: mu (s - s^-3)."""
    for c01 in (0.0, 0.2):
        law = materials.Rubber(3.0, 0.49999, c01)
        scene = body(1, None, "plane strain", "large displacement", 0.49999)
        scene.laws["B"] = law
        scene.hold("B_left", 0).hold("B_right", 1.6).hold("B_below", None, 0)
        model = fem.Model(scene)
        s = 1.8
        u = model.solve(u=(model.X - (1, 0)) * (s - 1, 1 / s - 1))
        off = abs(model.forces(u)[model.nodes_of("B_right"), 0].sum() / (
            1 / 1.0 * (s - s ** -3)) - 1)
        expect("stretched strip, C01 %g" % c01, off < 1e-4, "%.1e" % off)


def grown():
    """Rings that grow by a tenth are without stress."""
    worst = 0.0
    for law in laws():
        for large in (False, True):
            if large and law.has_history or not large and isinstance(
                    law, materials.Rubber):
                continue
            scene = body(1, None, "axisymmetric", "large displacement" if large
                         else "small strain", 0.3, 0.1)
            scene.laws["B"] = law
            scene.thermal["B"] = Formula("", lambda t: 0.1)
            model = fem.Model(scene)
            model.at(1.0)
            worst = max(worst, np.abs(model.forces(0.1 * model.X)).max() /
                        law.mu)
    expect("free growth", worst < 1e-12, "%.1e" % worst)


def weights():
    """Dual functions: of edges that are covered a field of the slave is that of
    the nodes, and a shear works on the slip; a master above the middle of two
    edges has one function, a constant."""
    for low, high in ((-0.5, 2.5), (0.3, 1.7)):
        up = block("U", low, 1, high, 2, 3, 1)
        scene = Scene("weights", 0, [block("L", 0, 0, 2, 1, 2, 1), up],
                      {"L": (100.0, 0.3), "U": (100.0, 0.3)})
        scene.hold("L_below", 0, 0).contact("L_above", "U_below", 0.3)
        model = fem.Model(scene)
        check_ = zone_check.ZoneCheck(
            scene, model, state_of(model, 0 * model.X), scene.zones[0], 1.0,
            np.zeros(len(model.X), bool))
        w = dual_weights.DualWeights(check_)
        order = np.argsort(model.X[w.nodes, 0])
        field = np.stack([model.X[:, 0] ** 2, 0 * model.X[:, 0]], 1)
        of_slave = np.where(model.body_of[:, None] == 0, field, 0)
        jump, D = w.jump(of_slave)[order, 0], w.D[order]
        if low < 0:
            off = np.abs(jump - (0, 1, 4)).max() + np.abs(D - (
                0.5, 1, 0.5)).max()
            force = np.zeros((3, 2))
            force[order, 0] = 1, 2, 3
            off += np.abs(w.forces(force) - force).max()
        else:
            # Linear from 0 to 1 to 4, from 0.3 to 1.7.
            mean = (0.5 * (1 - 0.3 ** 2) + 0.7 + 1.5 * 0.7 ** 2) / 1.4
            off = np.abs(jump - (0, mean, 0)).max() + np.abs(D - (
                0, 1.4, 0)).max()
            # A uniform shear of 1/1.4 on the three nodes.
            force = np.zeros((3, 2))
            force[order, 0] = np.array([0.245, 0.91, 0.245]) / 1.4
            off += np.abs(w.forces(force)[order, 0] - (0, 1, 0)).max()
            work = (force * of_slave[w.nodes]).sum()
            off += abs(work - mean)
        expect("dual functions below %g to %g" % (low, high),
               off < 0.02 and w.known.all(), "%.1e" % off)


# Damage.
def state_of(model, u, t=1.0, record=None):
    return check.State(model, u, t, np.full(len(u), 1e-16), record)


def other_yield_stress():
    scene = body(1, None, "plane strain", "small strain")
    scene.laws["B"] = materials.Plastic(1000.0, 0.3, 1.5, 40.0)
    scene.hold("B_left", 0, 0).hold("B_right", None, 0.01)
    model = fem.Model(scene)
    u = model.solve()
    found = check.check_equilibrium(model, state_of(model, u))
    expect("a right plastic result passes", not found, str(found))
    for what, law in (("yield stress", materials.Plastic(1000.0, 0.3, 1.502,
                                                         40.0)),
                      ("hardening", materials.Plastic(1000.0, 0.3, 1.5, 0.0,
                                                      40.0))):
        scene.laws["B"] = law
        other = fem.Model(scene)
        u_1 = u.copy()
        if what == "hardening":
            # The same in the first increment, but not on the way back.
            for m in (model, other):
                m.reset()
            other.advance(u)
            model.advance(u)
            scene.boundary["Displacement y"]["B_right"] = -0.01
            u_1 = model.solve(1.0, 1, u=u)
        found = check.check_equilibrium(other, state_of(other, u_1))
        expect("found: another " + what, bool(found))


def rigid():
    scene = body(1, None, "plane strain", "large displacement")
    scene.mesh.points["P"] = scene.mesh.lines["B_right"][0][0]
    scene.hold("B_left", 0, 0)
    model = fem.Model(scene)
    nodes, P = model.nodes_of("B_right"), scene.mesh.points["P"]
    u = np.zeros_like(model.X)
    cos, sin = math.cos(0.3), math.sin(0.3)
    u[nodes] = (model.X[nodes] - model.X[P]) @ np.array(
        [[cos - 1, sin], [-sin, cos - 1]]) + (0.1, 0.05)
    u = model.solve(fixed=test_fem.on(model, nodes), u=u)
    f = model.forces(u)[nodes]
    arm = model.X[nodes] + u[nodes] - model.X[P] - u[P]
    scene.make_rigid("B_right", "P")
    scene.load("Rotation z", "B_right", 0.3)
    scene.load("Force x", "B_right", f[:, 0].sum())
    scene.load("Displacement y", "B_right", 0.05)
    model = fem.Model(scene)
    judge = lambda v=u: rigid_check.problems(scene, model, state_of(model, v))
    expect("a rigid boundary passes", not judge(), str(list(map(str, judge()))))
    v = u.copy()
    v[nodes[-1], 0] += 1e-5
    expect("found: a boundary that bends", bool(judge(v)))
    for entry in ("Force x", "Displacement y", "Rotation z"):
        value = scene.boundary[entry]["B_right"]
        scene.boundary[entry]["B_right"] = value * 1.001
        expect("found: another " + entry, bool(judge()))
        scene.boundary[entry]["B_right"] = value
    del scene.boundary["Rotation z"]
    moment = rigid_check.cross(arm, f).sum()
    scene.load("Moment z", "B_right", moment)
    expect("its moment passes", not judge())
    scene.boundary["Moment z"]["B_right"] = 1.001 * moment
    expect("found: another moment", bool(judge()))


def in_space(point):
    """A cylinder about its own axis, and a ball, whose points turn to the side
    of the right-handed axis."""
    turn = {"angle": Formula("", lambda t: 90 * t)}
    point = np.array([[*point, 0.5]])
    drum = motions.placement(Zone("S", obstacle="cylinder: 1, 0, 0, 0, 0, 2, 1",
                                  motion=turn), 1.0, {})
    wanted = np.array([[1 - point[0, 1], point[0, 0] - 1, 0.5]])
    off = np.abs(drum.at(point) - wanted).max()
    ball = motions.placement(Zone("S", obstacle="sphere: 0, 0, 0, 1", motion={
        "z": RAMP, **turn}, axis=(1.0, 1.0, 0.0)), 1.0, {})
    r = 0.5 ** 0.5
    off = max(off, np.abs(ball.at(np.eye(3)) - [
        [0.5, 0.5, 1 - r], [0.5, 0.5, 1 + r], [r, -r, 1]]).max())
    expect("a drum and a ball turned", off < 1e-14, "%.1e" % off)


def obstacles():
    """Placed and back; a plane that has turned about a point of its own."""
    zone = Zone("S", obstacle="half plane: 0, 0, 0, 1", centre=(2.0, 0.0),
                motion={"x": Formula("", lambda t: 3 * t), "angle": Formula(
                    "", lambda t: 90 * t)}, force={"y": RAMP})
    place = motions.placement(zone, 1.0, {"y": 1.0})
    x = np.random.default_rng(6).standard_normal((5, 2))
    expect("placed and back", np.abs(place.at(place.back(x)) - x).max() < 1e-14)
    state = type("State", (), {"placements": {"": place}, "t": 1.0})()
    master = motions.master_of(None, zone, state)
    off = max(np.abs(master.gap(x) + x[:, 0] - 5).max(),
              np.abs(master.normals(x) - (-1, 0)).max())
    expect("a plane turned about its centre", off < 1e-14, "%.1e" % off)
    in_space(x[0])
    zone.apart = Formula("", lambda t: 0.25)
    off = np.abs(motions.master_of(None, zone, state).gap(x) + x[:, 0] - 4.75)
    expect("kept apart", off.max() < 1e-14)


if __name__ == "__main__":
    for test in (returns, sheared, hill, rubber, strip, grown,
                 other_yield_stress, rigid, obstacles, weights):
        test()
    sys.exit(test_fem.failures > 0)
