#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A surface in contact with itself: one group is slave and master alike.

Proves that

- a thick ring that is squeezed until its inner wall lies on itself takes the force
  of its half, whose inner wall comes to lie on a rigid plane, the mirror: within
  1.5 %, and on a finer mesh within a quarter of that; of degree 1 and 2, nodal and
  mortar, turned by 0 and 40 degrees, with two processes, and, mortar, in one
  increment, in which the walls go through each other at first;
- a hairpin whose legs are closed, with friction, takes the force of the same scene
  with a group for each leg, one or the other as the slave, within 1e-6, also on a
  mesh refined by the indicators; the profile has its pressure on both legs, and on
  one mesh the estimated error is the same;
- a strip in three layers, each on the next, takes that of the same scene with a group
  for each side of each layer, within 1 %: both sides are in the one group, and what
  is behind the strip is no partner;
- a hairpin all edges of which are in a group takes the same force with automatic
  pairs, within 1e-9;
- a strip with both sides in the group that is bent touches nothing: the force of the
  same scene without contact, within 1e-10;
- a comb, a sheared L and a fold of three layers, all outer edges in the group, have no
  contact where nothing touches, nodal and mortar;
- the faces of a slit, one cell apart, press on each other as two groups do: the force
  within 1 %, the largest pressure within 10 %;
- in 3-D, without Poisson's ratio, ring and hairpin take the plane force times their
  thickness, within 1 %;
- what cannot be is refused with its reason.

Usage: self_contact.py CONTACT
"""

import itertools
import json
import math
import pathlib
import sys

from block_scenes import Mesh, check, failures, rows, run, violations
from volume_scenes import layer

LENGTH, RADIUS, HALF = 20., 1.5, .5  # of legs, of bends, of the thickness


def turned(x, y, angle):
    c, s = math.cos(angle), math.sin(angle)
    return c * x - s * y, s * x + c * y


def ring(name, whole, angle=0., n=32, m=2):
    """Of radii 8 and 10, or its upper half; the middle third of its outer wall
    above is Top, that below Bottom."""
    mesh = Mesh()
    n = n if whole else n // 2

    def chart(s, t):
        a = -2 * math.pi * s if whole else math.pi * (1 - s)
        return turned((8 + 2 * t) * math.cos(a), (8 + 2 * t) * math.sin(a),
                      angle)
    cut = {} if whole else {"left": "Cut", "right": "Cut"}
    mesh.block("Ring", n, m, chart, {"bottom": "Inner", **cut}, closed=whole)
    columns = n if whole else n + 1
    for i in range(n):
        x, y = turned(*chart((i + .5) / n, 1), -angle)
        if abs(x) < 2:
            mesh.add(1, "Top" if y > 0 else "Bottom",
                     [1 + m * columns + k % columns for k in (i, i + 1)])
    mesh.write(name)


def ring_entries(whole, angle=0., **more):
    way = turned(0, -8.1, angle)
    supports = {direction: f"Top: {a!r}" + (f", Bottom: {-a!r}" if whole else "")
                for direction, a in zip("xy", way)}
    if not whole:
        supports["normal"] = "Cut: 0"
    x, y = turned(0, 1, angle)
    return {
        "Mesh/File": "ring.msh", "Solids/Young's modulus": "Ring: 100",
        "Solids/Poisson's ratio": "Ring: 0.3", "Contact/Slave": "Inner",
        "Contact/Master" if whole else "Contact/Obstacle":
            "Inner" if whole else f"half plane: 0, 0, {x!r}, {y!r}",
        "Solution/Increments": 8, "Solution/Newton tolerance": 1e-10,
        "Probes/Probes": "x: reaction x, Top; y: reaction y, Top",
        **{f"Boundary conditions/Displacement {d}": value
           for d, value in supports.items()}, **more}


def serpentine(layers):
    """The length of the middle line of a strip in layers, and its place and
    direction by arc length."""
    bend = math.pi * RADIUS

    def at(s):
        for k in range(layers):
            way, y = (-1)**k, 2 * RADIUS * k
            if s <= LENGTH or k == layers - 1:
                return (s if way > 0 else LENGTH - s), y, way, 0.
            s -= LENGTH
            if s <= bend:
                c, d = math.cos(s / RADIUS), math.sin(s / RADIUS)
                return ((LENGTH if way > 0 else 0) + way * RADIUS * d,
                        y + RADIUS * (1 - c), way * c, d)
            s -= bend
        raise ValueError(s)
    return layers * LENGTH + (layers - 1) * bend, at


def strip(name, layers, n, groups, m=2):
    """The groups of an edge by its side, 0: right, 1: left of the way, its arc
    length and the layer that is in."""
    length, at = serpentine(layers)
    mesh = Mesh()

    def chart(s, t):
        x, y, a, b = at(s * length)
        h = (2 * t - 1) * HALF
        return x - b * h, y + a * h
    mesh.block("Strip", n, m, chart, {})
    for i, side in itertools.product(range(n), range(2)):
        s = (i + .5) / n * length
        bend = math.pi * RADIUS
        leg, rest = divmod(s + bend / 2, LENGTH + bend)
        apart = min(rest, LENGTH + bend - rest) > 1
        for group in groups(side, s, leg if apart else None):
            first = 1 + side * m * (n + 1) + i
            mesh.add(1, group, (first, first + 1))
    mesh.write(name)


def strip_entries(name, way, increments, **more):
    return {
        "Mesh/File": f"{name}.msh", "Solids/Young's modulus": "Strip: 1000",
        "Solids/Poisson's ratio": "Strip: 0.3",
        "Solution/Increments": increments,
        "Boundary conditions/Displacement x": "Base: 0, Push: 0",
        "Boundary conditions/Displacement y": f"Base: 0, Push: {-way}",
        "Probes/Probes": "y: reaction y, Push", **more}


def solved(what, name, entries, ranks=1):
    status, said, summary = run(name, entries, ranks)
    check(f"{what}: runs", status == 0 and not violations(summary),
          "" if status == 0 else said[-600:])
    return {probe["name"]: probe["value"]
            for probe in summary.get("probes", [])}


def close(what, found, expected, part):
    if found and expected:
        size = max(map(abs, expected.values()))
        check(what, all(abs(found[key] - value) < part * size
                        for key, value in expected.items()),
              f"{found} {expected}")


def rings():
    for rule in ("mortar", "nodal"):
        scenes = (
                ("ring", .015, {}, 1, {}),
                ("ring, two processes", .015, {}, 2, {}),
                ("ring, turned", .015, {"angle": math.radians(40)}, 1, {}),
                ("ring, degree 2", .015, {}, 1, {"Element/Degree": 2}),
                ("ring, finer", .004, {"n": 64, "m": 4}, 1, {})) + (
                    (("ring, one increment", .015, {}, 1,
                      {"Solution/Increments": 1}),) if rule == "mortar" else ())
        for what, part, mesh, ranks, more in scenes:
            what += f", {rule}"
            more = {"Contact/Discretization": rule, "Element/Degree": 1, **more}
            forces = []
            for whole in (False, True):
                ring("ring", whole, **mesh)
                forces.append(solved(
                    what, "ring", ring_entries(whole, mesh.get("angle", 0.),
                                               **more), ranks))
            close(what, *forces[::-1], part)


def hairpin(name):
    strip(name, 2, 48, lambda side, s, leg: (
        (["Inside"] + ([] if leg is None else ["Lower" if leg == 0 else "Upper"])
         if side == 1 else
         ["Push"] if s > 2 * LENGTH + 1 else ["Base"] if s < 10 else [])))


def hairpins():
    hairpin("hairpin")
    scenes = [(f"hairpin, {rule}, friction {friction}",
               {"Contact/Discretization": rule,
                "Contact/Friction coefficient": friction})
              for rule in ("mortar", "nodal") for friction in (0, .3)]
    scenes.append(("hairpin, adaptive", {"Refinement/Strategy": "adaptive",
                                         "Refinement/Levels": 2}))
    for what, more in scenes:
        entries = strip_entries("hairpin", 2.3, 5, **{
            "Output/Profile": "true", **more})

        def of(slave, master):
            found = solved(f"{what}, {slave}", "hairpin", {
                **entries, "Contact/Slave": slave, "Contact/Master": master})
            for row in rows("hairpin") if found else ():
                found[row["surface"]] = max(found.get(row["surface"], 0),
                                            row["pressure_MPa"])
            if found:
                summary = json.loads(
                    pathlib.Path("output/hairpin/summary.json").read_text())
                error = summary["probes"][0]["estimated_error"]
                found.update({} if error is None else {"error": error})
            return found
        alone = of("Inside", "Inside")
        pairs = [of("Lower", "Upper"), of("Upper", "Lower")]
        if alone and what == "hairpin, mortar, friction 0":
            check(f"{what}: has an error", alone.get("error", 0) > 0)
        if alone and all(pairs):
            close(what, alone,
                  min(pairs, key=lambda one: abs(one["y"] - alone["y"])), 1e-6)


def layers():
    strip("layers", 3, 75, lambda side, s, leg: (
        (["Skin"] if leg is None or (leg, side) not in ((0, 0), (2, 1)) else [])
        + ([f"Side{leg:.0f}{side}"] if leg is not None else [])
        + (["Base"] if leg == 0 and side == 0 and s < 15 else [])
        + (["Push"] if leg == 2 and side == 1 and s > 55 else [])))
    entries = strip_entries("layers", 3.5, 7)
    alone = solved("layers", "layers", {
        **entries, "Contact/Slave": "Skin", "Contact/Master": "Skin"})
    pairs = solved("layers in pairs", "layers", {
        **entries, "Contact low/Slave": "Side01", "Contact low/Master": "Side11",
        "Contact high/Slave": "Side20", "Contact high/Master": "Side10"})
    close("layers", alone, pairs, 1e-2)


def automatic():
    """A hairpin between two plates, that closes: by groups, and automatically."""
    strip("automatic", 2, 48, lambda side, s, leg: (
        ["Skin"] + (["Push"] if side == 0 and s > 2 * LENGTH + 1 else
                    ["Base"] if side == 0 and s < 10 else [])))
    entries = strip_entries("automatic", 2.3, 5, **{
        "Contact/Friction coefficient": .3})
    one = solved("a group of all edges", "automatic", {
        **entries, "Contact/Slave": "Skin", "Contact/Master": "Skin"})
    close("automatic", solved("automatic", "automatic", {
        **entries, "Contact/Surfaces": "automatic with self-contact"}), one, 1e-9)


def nothing():
    strip("bent", 1, 20, lambda side, s, leg: (
        ["Skin"] + (["Base"] if s < 2 else ["Push"] if s > 18 else [])))
    entries = strip_entries("bent", 5, 4)
    close("a bent strip",
          solved("a bent strip", "bent", {
              **entries, "Contact/Slave": "Skin", "Contact/Master": "Skin"}),
          solved("without contact", "bent", entries), 1e-10)


def pixels(name, rows, skew=0., height=1.):
    """Unit cells where a row, the uppermost first, has a #; all outer edges are Skin,
    those at the bottom Base, at the top Head, and those of a hole Over, Under."""
    mesh = Mesh()
    cells = {(i, len(rows) - 1 - j) for j, row in enumerate(rows)
             for i, c in enumerate(row) if c == "#"}
    number = {}

    def node(i, j):
        if (i, j) not in number:
            mesh.nodes.append((i + skew * j, j * height))
            number[i, j] = len(mesh.nodes)
        return number[i, j]
    for i, j in sorted(cells):
        mesh.add(2, "Strip", (node(i, j), node(i + 1, j), node(i + 1, j + 1),
                              node(i, j + 1)))
        for (a, b), ends in (((0, -1), ((0, 0), (1, 0))), ((1, 0), ((1, 0), (1, 1))),
                             ((0, 1), ((1, 1), (0, 1))), ((-1, 0), ((0, 1), (0, 0)))):
            if (i + a, j + b) in cells:
                continue
            edge = [node(i + c, j + d) for c, d in ends]
            mesh.add(1, "Skin", edge)
            if b:
                outer = j == (0 if b < 0 else len(rows) - 1)
                mesh.add(1, {(True, -1): "Base", (True, 1): "Head", (False, -1): "Over",
                             (False, 1): "Under"}[outer, b], edge)
    mesh.write(name)


def at_rest():
    for what, rows, skew in (
            ("a comb", ("#.#.#", "#####"), 0.), ("an L", ("#.", "##"), .6),
            ("three layers", ("####", "#...", "####", "...#", "####"), 0.)):
        pixels("rest", rows, skew)
        for rule in ("mortar", "nodal"):
            status, said, summary = run("rest", {
                "Mesh/File": "rest.msh", "Solids/Young's modulus": "Strip: 1000",
                "Solids/Poisson's ratio": "Strip: 0.3",
                "Boundary conditions/Displacement x": "Base: 0",
                "Boundary conditions/Displacement y": "Base: 0",
                "Boundary conditions/Traction y": "Head: 1e-6",
                "Contact/Slave": "Skin", "Contact/Master": "Skin",
                "Contact/Discretization": rule})
            force = summary["increments"][-1]["contact"] if status == 0 else said
            check(f"{what} at rest, {rule}",
                  status == 0 and force["normal_force"] == 0, f"{force}")


def slit():
    pixels("slit", ("#" * 12, "#" * 12, "#" + "." * 10 + "#", "#" * 12, "#" * 12),
           height=.5)
    found = []
    for slave, master in (("Skin", "Skin"), ("Over", "Under")):
        status, said, summary = run("slit", {
            "Mesh/File": "slit.msh", "Solids/Young's modulus": "Strip: 1000",
            "Solids/Poisson's ratio": "Strip: 0.3",
            "Boundary conditions/Displacement x": "Base: 0, Head: 0",
            "Boundary conditions/Displacement y": "Base: 0, Head: -0.6",
            "Contact/Slave": slave, "Contact/Master": master,
            "Solution/Increments": 3})
        found.append(summary["increments"][-1]["contact"] if status == 0 else said)
    check("a slit", all(isinstance(one, dict) for one in found) and
          0 < found[0]["normal_force"] and all(
              abs(found[0][key] / found[1][key] - 1) < part for key, part in
              (("normal_force", .01), ("max_pressure", .1))), f"{found}")


def in_space():
    depth, stiff = 2., {"Solids/Poisson's ratio": "Ring: 0"}
    planes = {"Boundary conditions/Displacement z": "Front: 0, Back: 0"}
    for rule in ("mortar", "nodal"):
        entries = ring_entries(True, **{
            **stiff, "Contact/Discretization": rule, "Element/Degree": 1})
        ring("ring", True)
        plane = solved("plane ring", "ring", entries)
        layer("ring.msh", depth).write("ring")
        close(f"ring in space, {rule}",
              solved("ring in space", "ring", {**entries, **planes}),
              {key: depth * value for key, value in plane.items()}, 1e-2)
    hairpin("hairpin")
    entries = strip_entries("hairpin", 2.3, 5, **{
        "Solids/Poisson's ratio": "Strip: 0", "Contact/Slave": "Inside",
        "Contact/Master": "Inside"})
    plane = solved("plane hairpin", "hairpin", entries)
    layer("hairpin.msh", depth).write("hairpin")
    close("hairpin in space",
          solved("hairpin in space", "hairpin", {
              **entries, **planes, "Element/Degree": 1}),
          {key: depth * value for key, value in plane.items()}, 1e-2)


def refused():
    hairpin("hairpin")
    entries = strip_entries("hairpin", 2.3, 5, **{
        "Contact/Slave": "Inside", "Contact/Master": "Inside"})
    for what, entry, value in (("glue", "Contact/Tied", "true"),
                               ("in Gauss points", "Contact/Discretization",
                                "Gauss")):
        status, said, _ = run("hairpin", {**entries, entry: value})
        check(f"{what} is refused", status == 2 and "with itself" in said,
              said[:300])


for scene in (rings, hairpins, layers, automatic, nothing, at_rest, slit, in_space, refused):
    scene()
print(f"{len(failures)} failed")
sys.exit(1 if failures else 0)
