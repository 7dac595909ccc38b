#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The oracle itself, tested without the program.

- Forces are the derivatives of an energy summed up here once more; tangents
  those of the forces (differences).
- A rotated patch of any elements carries a uniform stress; a bar stretches, a
  ring widens under pressure as Lame has it, a cantilever bends as beams do.
- A right result passes the checks, and each kind of damage to it is found."""
import json
import math
import pathlib
import random
import sys
import tempfile

import numpy as np

import check
import fem
from grids import block
from kinds_shapes import annulus
from results import Run
from scene import Scene

failures = 0


def expect(what, ok, detail=""):
    global failures
    failures += not ok
    print("%-4s %s %s" % ("ok" if ok else "BAD", what, detail))


def ways():
    """All elements, symmetries and kinematics."""
    for degree in (1, 2):
        for split in (None, lambda x, y: True):
            for symmetry in ("plane strain", "axisymmetric"):
                for kinematics in ("small strain", "large displacement"):
                    yield degree, split, symmetry, kinematics


def body(degree, split, symmetry, kinematics, poisson=0.3, bend=0.0):
    scene = Scene("test", 0, [block(
        "B", 1, 0, 3, 1, 4, 2, split, shape=lambda x, y: (
            x + bend * y * math.sin(3 * x), y + bend * math.sin(x * y + x)))],
        {"B": (100.0, poisson)})
    scene.entries.update({"Element/Degree": degree,
                          "Solids/Symmetry": symmetry,
                          "Solids/Kinematics": kinematics})
    return scene


def energy(model, u):
    """1/2 lambda (P tr E)^2 + mu E : E, by the tables of the elements alone."""
    total = 0.0
    for b in model.blocks:
        for e, cell in enumerate(b.cells):
            traces, rest = [], []
            for q in range(len(b.N)):
                H = u[cell].T @ b.dN[e, q]
                h = b.hoop[e, q] @ u[cell][:, 0] if b.hoop is not None else 0.0
                E = (H + H.T) / 2 + model.large * H.T @ H / 2
                h += model.large * h * h / 2
                traces.append(np.trace(E) + h)
                rest.append((E * E).sum() + h * h)
            w = b.w[e]
            P = np.array(traces)
            if b.modes is not None:
                P = b.modes[e] @ (b.modes[e].T @ (w * P))
            total += b.lame / 2 * w @ P ** 2 + b.shear * w @ np.array(rest)
    return total


def derivatives():
    rng = np.random.default_rng(1)
    worst = [0.0, 0.0]
    for way in ways():
        for poisson in (0.3, 0.49):
            model = fem.Model(body(*way, poisson, 0.1))
            u = 0.05 * rng.standard_normal(model.X.shape)
            du = rng.standard_normal(model.X.shape)
            h = 1e-5
            slope = (energy(model, u + h * du) - energy(model, u - h * du)
                     ) / (2 * h)
            worst[0] = max(worst[0], abs((model.forces(u) * du).sum() / slope
                                         - 1))
            change = (model.forces(u + h * du) - model.forces(u - h * du)
                      ) / (2 * h)
            tangent = (model.tangent(u) @ du.ravel()).reshape(-1, 2)
            worst[1] = max(worst[1], np.abs(change - tangent).max() /
                           np.abs(change).max())
    expect("forces are derivatives of the energy", worst[0] < 1e-6,
           "%.1e" % worst[0])
    expect("tangents are derivatives of the forces", worst[1] < 1e-6,
           "%.1e" % worst[1])


def patch():
    """A linear field on distorted elements: no force inside."""
    worst = 0.0
    for degree, split, symmetry, kinematics in ways():
        if symmetry != "plane strain":
            continue
        model = fem.Model(body(degree, split, symmetry, kinematics, 0.3, 0.1))
        u = model.X @ np.array([[0.02, 0.3], [-0.28, 0.01]])
        inside = np.ones(len(model.X), bool)
        for lines in model.lines.values():
            inside[lines] = False
        f = model.forces(u)
        worst = max(worst, np.abs(f[inside]).max() / np.abs(f).max())
    expect("patch", worst < 1e-12, "%.1e" % worst)


def rigid():
    worst = 0.0
    a = 0.7
    turn = np.array([[math.cos(a), -math.sin(a)], [math.sin(a), math.cos(a)]])
    for degree in (1, 2):
        model = fem.Model(body(degree, None, "plane strain",
                               "large displacement", 0.49, 0.1))
        worst = max(worst, np.abs(model.forces(model.X @ turn.T -
                                               model.X)).max() / 100)
    expect("a rotation costs nothing", worst < 1e-13, "%.1e" % worst)


def bar():
    """Uniaxial plane strain by a traction, and by a large stretch."""
    scene = body(1, None, "plane strain", "small strain")
    scene.hold("B_left", 0).hold("B_below", None, 0)
    scene.load("Traction x", "B_right", 2.0)
    u = fem.Model(scene).solve()
    exact = 2 * 2.0 * (1 - 0.09) / 100
    expect("bar", abs(u[:, 0].max() / exact - 1) < 1e-12)
    scene = body(2, None, "plane strain", "large displacement", 0.0)
    scene.hold("B_left", 0).hold("B_below", None, 0).hold("B_right", 1.0)
    model = fem.Model(scene)
    u = model.solve(1, 2)
    # F = 1.5: P = F S = F E (F^2 - 1) / 2.
    force = model.forces(u)[model.nodes_of("B_right"), 0].sum()
    expect("large stretch", abs(force / (1.5 * 100 * 0.625) - 1) < 1e-12)


def ring():
    """Lame: a thick ring under inner pressure, plane strain, both as a plane
    section and as half a section of rings."""
    E, nu, p, a, b = 100.0, 0.3, 2.0, 1.0, 2.0
    A = p * a * a / (b * b - a * a)
    exact = (1 + nu) / E * A * ((1 - 2 * nu) * a + b * b / a)
    scene = Scene("ring", 0, [annulus("R", a, b, 8, 6, 0, math.pi / 2)],
                  {"R": (E, nu)}, arcs={"R_bore": (0, 0, a),
                                        "R_skin": (0, 0, b)})
    scene.entries.update({"Element/Degree": 2,
                          "Solids/Kinematics": "small strain"})
    scene.hold("R_start", None, 0).hold("R_end", 0)
    scene.load("Pressure", "R_bore", p)
    model = fem.Model(scene)
    u = model.solve()[model.nodes_of("R_bore")]
    off = np.abs(np.hypot(*u.T) / exact - 1).max()
    expect("Lame, plane", off < 1e-3, "%.1e" % off)
    scene = Scene("tube", 0, [block("T", a, 0, b, 1, 12, 2)], {"T": (E, nu)})
    scene.entries.update({"Element/Degree": 2, "Solids/Kinematics":
                          "small strain", "Solids/Symmetry": "axisymmetric"})
    scene.hold("T_below T_above", None, 0).load("Pressure", "T_left", p)
    model = fem.Model(scene)
    off = np.abs(model.solve()[model.nodes_of("T_left"), 0] / exact - 1).max()
    expect("Lame, rings", off < 1e-5, "%.1e" % off)


def cantilever():
    """Timoshenko's beam in plane strain; locking is gone with P."""
    for degree, poisson in ((2, 0.3), (2, 0.4999)):
        L, h, E, F = 20.0, 1.0, 100.0, 1e-3
        scene = Scene("beam", 0, [block("B", 0, 0, L, h, 40, 2).point(
            "middle", 0, 1)], {"B": (E, poisson)})
        scene.entries.update({"Element/Degree": degree,
                              "Solids/Kinematics": "small strain"})
        scene.hold("B_left", 0).hold("middle", None, 0)
        scene.load("Resultant force y", "B_right", -F)
        u = fem.Model(scene).solve()
        plane = E / (1 - poisson ** 2)
        shear = E / (2 * (1 + poisson))
        exact = -F * (4 * L ** 3 / plane / h ** 3 + 6 * L / 5 / shear / h)
        off = abs(u[:, 1].min() / exact - 1)
        expect("cantilever, nu %g" % poisson, off < 4e-3, "%.1e" % off)


# Damage.
def pressed_block():
    """A block between flat supports on another of the same mesh: the mean of
    both surfaces' nodes is a solution of contact, by the oracle alone."""
    low = block("Low", 0, 0, 4, 1, 8, 2)
    up = block("Up", 1, 1, 3, 2, 4, 2)
    scene = Scene("damage", 0, [low, up], {"Low": (100.0, 0.3),
                                           "Up": (100.0, 0.3)}, rule="nodal")
    scene.entries["Solids/Kinematics"] = "small strain"
    scene.hold("Low_below", 0, 0).hold("Up_above", 0, -0.02)
    scene.contact("Up_below", "Low_above", 0.0)
    return scene


def glued(scene):
    """The upper block's sole tied to the ground in y, free in x: linear, so
    constraints by elimination."""
    import scipy.sparse as sp
    import scipy.sparse.linalg as spl
    model = fem.Model(scene)
    held, value = model.supports(1.0)
    n = 2 * len(model.X)
    master = {}
    ground = model.nodes_of("Low_above")
    for s in model.nodes_of("Up_below"):
        m = ground[np.abs(model.X[ground] - model.X[s]).max(1) < 1e-9][0]
        master[2 * s + 1] = 2 * m + 1
    free = [k for k in range(n) if not held.ravel()[k] and k not in master]
    number = {k: i for i, k in enumerate(free)}
    rows, columns = [], []
    for k in range(n):
        target = master.get(k, k)
        if target in number:
            rows.append(k)
            columns.append(number[target])
    T = sp.csc_matrix((np.ones(len(rows)), (rows, columns)),
                      shape=(n, len(free)))
    K = model.tangent(np.zeros_like(model.X))
    fixed = value.ravel() * held.ravel()
    x = spl.spsolve((T.T @ K @ T).tocsc(), -(T.T @ (K @ fixed)))
    return model, (T @ x + fixed).reshape(-1, 2)


def run_with(model, u, directory):
    """What a run of the program with these displacements would have left."""
    state = check.State(model, u, 1.0, np.full(len(u), 1e-16))
    probes = {"%s%d" % ("xy"[d], k): u[k, d] for k in range(len(u))
              for d in range(2)}
    reactions = {g: {"x": state.residual[model.nodes_of(g), 0].sum(),
                     "y": state.residual[model.nodes_of(g), 1].sum()}
                 for g in ("Low_below", "Up_above")}
    output = directory / "output" / "case"
    output.mkdir(parents=True, exist_ok=True)
    lines = ["surface,X_mm,Y_mm,displacement_x_mm,displacement_y_mm,"
             "pressure_MPa,shear_MPa,nodal_force_N_per_mm"]
    lines += ["slave,%r,%r,%r,%r,1,0,%r" % (
        *map(float, model.X[n]), *map(float, u[n]),
        float(np.hypot(*state.residual[n])))
        for n in model.nodes_of("Up_below")]
    (output / "profile.csv").write_text("\n".join(lines) + "\n")
    (output / "summary.json").write_text(json.dumps({
        "converged": True, "increments": [{
            "converged": True, "load_factor": 1.0, "probes": probes,
            "reactions": reactions}]}))
    return Run(0, "", 0.0, directory)


def reasons(scene, model, u, directory, change=None):
    run = run_with(model, u, directory)
    if change:
        change(run.summary["increments"][0])
    return [p.reason for p in check.problems(scene, run, model)]


def damage():
    scene = pressed_block()
    model, u = glued(scene)
    sole = model.nodes_of("Up_below")
    above = np.flatnonzero(model.body_of == 1)
    inner = np.flatnonzero((model.X == (2, 1.5)).all(1))

    def expect_reason(what, reason, displacements, model=model, change=None):
        found = reasons(model.scene, model, displacements, place, change)
        expect("found: " + what, reason in found, str(found))
    with tempfile.TemporaryDirectory() as place:
        place = pathlib.Path(place)
        found = reasons(scene, model, u, place)
        expect("a right result passes", not found, str(found))
        v = u.copy()
        v[inner] += 1e-6
        expect_reason("a node that is not in equilibrium", "equilibrium", v)
        v = u.copy()
        v[above] += (0, 1e13)
        expect_reason("a body that has flown away", "flown away", v)
        v = u.copy()
        v[above, 1] += 0.02
        v[model.nodes_of("Up_above")] = (0, -0.02)
        expect_reason("a wrong support, or unequal forces", "equilibrium", v)
        v = u.copy()
        v[inner] = np.nan
        expect_reason("not a number", "not a number", v)
        pulled = pressed_block()
        pulled.boundary["Displacement y"]["Up_above"] = 0.02
        expect_reason("tension", "tension", -u, fem.Model(pulled))
        # Each body in equilibrium, but not with the other one.
        deeper = model.solve(fixed=on(model, sole), u=shifted(u, sole, -0.003))
        expect_reason("unequal forces", "balance", deeper)
        expect_reason("penetration", "penetration", deeper)
        sheared = scene_with_shear(model, u)
        expect_reason("shear without friction", "cone", sheared)
        expect_reason("a wrong reaction", "reaction", u, change=lambda i: i[
            "reactions"]["Up_above"].update(y=-1.0))


def on(model, nodes):
    fixed = np.zeros(model.X.shape, bool)
    fixed[nodes] = True
    return fixed


def shifted(u, nodes, dy):
    v = u.copy()
    v[nodes, 1] += dy
    return v


def scene_with_shear(model, u):
    """The sole moved sideways against the ground by equal forces."""
    sole, ground = model.nodes_of("Up_below"), model.nodes_of("Low_above")
    v = u.copy()
    for s in sole:
        m = ground[np.abs(model.X[ground] - model.X[s]).max(1) < 1e-9][0]
        v[s, 0] += 0.002
        v[m, 0] += 0.002
    nodes = np.concatenate([sole, ground])
    return model.solve(fixed=on(model, nodes), u=v)


def scenes():
    """Every kind makes scenes, the same ones each time, whose mesh is whole."""
    import oracle
    for kind in oracle.KINDS:
        texts = []
        for _ in range(2):
            scene = oracle.make(kind, 3)
            fem.Model(scene)
            texts.append(scene.mesh.text() + scene.parameters())
        expect("scenes of the kind " + kind, texts[0] == texts[1])


def variants():
    """Mirrored, renumbered, reordered: the same energy for the same field."""
    import oracle
    scene = oracle.make("wedge", 1)
    model = fem.Model(scene)
    u = 1e-3 * np.random.default_rng(2).standard_normal(model.X.shape)[
        :model.n_vertices]
    if scene.degree == 2:
        return
    base = energy(model, u)
    mirrored = fem.Model(scene.mirrored())
    expect("mirrored", abs(energy(mirrored, u * (-1, 1)) / base - 1) < 1e-12)
    renumbered = fem.Model(scene.renumbered(random.Random(3)))
    tree = {tuple(np.round(x, 9)): k for k, x in enumerate(model.X)}
    order = [tree[tuple(np.round(x, 9))] for x in renumbered.X]
    expect("renumbered", len(order) == len(u))


if __name__ == "__main__":
    for test in (derivatives, patch, rigid, bar, ring, cantilever, damage,
                 scenes, variants):
        test()
    sys.exit(failures > 0)
