#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""'Contact/Surfaces = automatic': contact of all outer faces of all bodies.

Proves that
- in 2-D and 3-D all results are those of pairs of groups that somebody has made
  of all faces of each body, to 1e-9, on one and on two processes;
- forces are those of pairs of the faces that touch, where no edge is in between;
- the softer body is the slave, of two alike the one with the smaller faces;
- a block that reaches over the rim of another, is dragged over it and lifted, has
  the force of the pair of the two faces that touch, within a tenth of a per cent;
- two blocks on a floor and against each other, with friction, have the forces of
  the pairs of faces that touch, within a thousandth, and as few steps;
- a pair that is named keeps its own entries, and bodies that share nodes have
  none;
- what makes no sense is refused with the entry.

Usage: automatic_pairs.py CONTACT
"""

import sys

from block_scenes import Mesh, box, check, failures, run, violations
from volume_scenes import Volumes

BC = "Boundary conditions/"


def outcome(summary):
    """The probes, and the normal forces of the pairs that touch."""
    last = summary["increments"][-1]
    forces = sorted(abs(entry["normal_force"]) for name, entry in last.items()
                    if name.startswith("contact") and isinstance(entry, dict)
                    and "normal_force" in entry)
    return ([p["value"] for p in summary["probes"]] +
            [f for f in forces if f > 1e-9 * forces[-1]])


def same(what, a, b, tolerance):
    a, b = outcome(a), outcome(b)
    size = max(map(abs, b))
    check(what, len(a) == len(b) and all(
        abs(x - y) <= tolerance * size for x, y in zip(a, b)), f"{a} {b}")


def paired(name, entries, pairs, ranks=1):
    for pair, of_pair in pairs.items():
        section = "Contact " + pair if pair else "Contact"
        entries = {**entries, **{f"{section}/{key}": value
                                 for key, value in of_pair.items()}}
    status, said, summary = run(name, entries, ranks)
    check(f"{name}: exit 0, no violation", status == 0 and not violations(summary),
          f"{status} {said[-300:]}")
    return summary


AUTOMATIC = {"": {"Surfaces": "automatic", "Friction coefficient": 0.3}}


def names(summary):
    return {key for key in summary["increments"][-1] if key.startswith("contact ")}


def plane():
    """Three blocks on each other, pressed and dragged."""
    mesh = Mesh()
    for body, n, place in (("A", 6, (0, 0, 10, 3)), ("B", 5, (2, 3, 8, 5)),
                           ("C", 4, (3, 5, 7, 8))):
        mesh.block(body, n, 3, box(*place), {
            side: f"{body} {side}" for side in ("bottom", "top", "left", "right")})
    for body in "ABC":
        for element in [e for e in mesh.elements if e[0] == 1]:
            group = next(g for g, tag in mesh.groups.items() if tag == element[1])[1]
            if group.startswith(body):
                mesh.add(1, body + " all", element[2])
    mesh.write("three")
    scene = {"Mesh/File": "three.msh", "Solids/Young's modulus": "A: 3000, B: 2000, C: 1000",
             "Solids/Poisson's ratio": "A: 0.3, B: 0.3, C: 0.3",
             BC + "Displacement x": "A bottom: 0, C top: 0.02",
             BC + "Displacement y": "A bottom: 0, C top: -0.05",
             "Solution/Increments": 2, "Probes/Errors": "none",
             "Probes/Probes": "x: reaction x, C top; y: reaction y, C top"}
    automatic = paired("three", scene, AUTOMATIC)
    check("  the softer body is the slave", names(automatic) == {
        "contact C A", "contact C B", "contact B A"}, names(automatic))
    friction = {"Friction coefficient": 0.3}
    same("  groups of all faces", automatic, paired("three_groups", scene, {
        f"{a} {b}": {"Slave": f"{a} all", "Master": f"{b} all", **friction}
        for a, b in ("CA", "CB", "BA")}), 1e-9)
    same("  the faces that touch", automatic, paired("three_faces", scene, {
        f"{a} {b}": {"Slave": f"{a} bottom", "Master": f"{b} top", **friction}
        for a, b in ("CB", "BA")}), 1e-4)
    some = paired("three_bodies", scene, {"": {
        **AUTOMATIC[""], "Bodies": "A, B"}, "smooth": {
            "Slave": "C bottom", "Master": "B top"}})
    check("  among some bodies", names(some) == {"contact B A", "contact smooth"},
          names(some))
    smooth = paired("three_named", scene, {**AUTOMATIC, "smooth": {
        "Slave": "B bottom", "Master": "A top"}})
    check("  a named pair has its own friction, and no other beside it",
          names(smooth) == {"contact C A", "contact C B", "contact smooth"} and
          abs(smooth["increments"][-1]["contact smooth"]["tangential_force"]) < 1e-9,
          names(smooth))
    alike = paired("three_alike", {
        **scene, "Solids/Young's modulus": "A: 1000, B: 1000, C: 1000"}, AUTOMATIC)
    check("  of bodies alike the smaller faces are the slave", names(alike) == {
        "contact C A", "contact C B", "contact B A"} or names(alike) == {
        "contact B A", "contact B C", "contact C A"}, names(alike))
    return scene


def refusals(scene):
    for what, entries, word in (
            ("a slave beside it", {"Contact/Surfaces": "automatic",
                                   "Contact/Slave": "C bottom"}, "Contact/Surfaces"),
            ("twice", {"Contact/Surfaces": "automatic",
                       "Contact other/Surfaces": "automatic"}, "Two sections"),
            ("no body", {"Contact/Surfaces": "automatic", "Contact/Bodies": "A, D"},
             "no body 'D'"),
            ("bodies of named surfaces", {
                "Contact/Slave": "C bottom", "Contact/Master": "A top",
                "Contact/Bodies": "A, C"}, "Contact/Bodies"),
            ("rings", {"Contact/Surfaces": "automatic",
                       "Solids/Symmetry": "axisymmetric"}, "name slave and master"),
            ("an interference", {"Contact/Surfaces": "automatic",
                                 "Contact/Interference": "0.1"}, "What is named here"),
            ("a group of that name", {"Contact/Surfaces": "automatic",
                                      "Mesh/File": "taken.msh"}, "rename it"),
            ("bodies that share nodes", {"Contact/Surfaces": "automatic",
                                         "Mesh/File": "joined.msh"}, "no two bodies")):
        mesh = Mesh()
        for body, y in (("A", 0), ("C", 1)):
            mesh.block(body, 2, 1, box(0, y, 2, y + 1), {
                "bottom": f"{body} bottom", "top": "A surface" if what.startswith(
                    "a group") and body == "A" else f"{body} top"})
        if what.startswith("bodies"):
            mesh.merge()
        mesh.write("joined" if what.startswith("bodies") else "taken")
        if "Mesh/File" in entries:
            entries = {**entries, "Solids/Young's modulus": "A: 1, C: 1",
                       "Solids/Poisson's ratio": "A: 0, C: 0"}
        status, said, _ = run("refused", {**scene, **entries})
        check(f"refused: {what}", status == 2 and word in said, f"{status} {said[-300:]}")


def space():
    """A block on a floor, against a wall, that is turned against both."""
    mesh = Volumes()
    bodies = {"Block": ((4, 3, 3), (0, 0, 0), (4, 3, 3)),
              "Floor": ((3, 3, 1), (-1, -2, -2), (7, 5, 0)),
              "Wall": ((1, 3, 3), (-3, -1, 0.2), (0, 4, 4.2))}
    for body, (n, low, high) in bodies.items():
        mesh.block(body, n, lambda *r, low=low, high=high: tuple(
            a + s * (b - a) for s, a, b in zip(r, low, high)))
        for kind, tag, nodes in list(mesh.elements):
            group = next(g for g, t in mesh.groups.items() if t == tag)
            if group[0] == 2 and group[1].startswith(body + "_") and not group[1].endswith("_all"):
                mesh.add(2, body + "_all", nodes)
    mesh.write("tray")
    held = ("Floor_z0: 0, Wall_x0: 0, Block_z1: ")
    scene = {"Mesh/File": "tray.msh",
             "Solids/Young's modulus": "Block: 1000, Floor: 2000, Wall: 3000",
             "Solids/Poisson's ratio": "Block: 0.3, Floor: 0.3, Wall: 0.3",
             BC + "Displacement x": held + "-0.03", BC + "Displacement y": held + "0.02",
             BC + "Displacement z": held + "-0.05", "Solution/Increments": 2,
             "Probes/Errors": "none",
             "Probes/Probes": "; ".join(
                 f"{d}: reaction {d}, Block_z1" for d in "xyz")}
    automatic = paired("tray", scene, AUTOMATIC)
    by_hand = {f"{a} {b}": {"Slave": f"{a}_all", "Master": f"{b}_all",
                            "Friction coefficient": 0.3}
               for a, b in (("Block", "Floor"), ("Block", "Wall"), ("Floor", "Wall"))}
    same("  groups of all faces", automatic, paired("tray_groups", scene, by_hand), 1e-9)
    same("  two processes", paired("tray_two", scene, AUTOMATIC, ranks=2), automatic, 1e-6)


def over_a_rim():
    mesh = Volumes()
    for body, n, low, high in (("U", (3, 3, 2), (0.2, -0.6, 1), (2.2, 1.4, 2)),
                               ("L", (5, 5, 2), (-1.5, -1.5, 0), (1.5, 1.5, 1))):
        mesh.block(body, n, lambda *r, low=low, high=high: tuple(
            a + s * (b - a) for s, a, b in zip(r, low, high)))
    mesh.write("rim")
    scene = {"Mesh/File": "rim.msh", "Solids/Young's modulus": "U: 1000, L: 1000",
             "Solids/Poisson's ratio": "U: 0.3, L: 0.3",
             BC + "Displacement x": "L_z0: 0, U_z1: 1",
             BC + "Displacement y": "L_z0: 0, U_z1: 0.3",
             BC + "Displacement z": "L_z0: 0, U_z1: 1",
             BC + "Histories": "; ".join(
                 [f"Displacement {c}: table(0 0, 0.25 0, 0.75 1, 1 1)" for c in "xy"] +
                 ["Displacement z: table(0 0, 0.25 -0.1, 0.75 -0.1, 1 0.3)"]),
             "Solution/Increments": 8, "Probes/Errors": "none",
             "Probes/Probes": "; ".join(f"{c}: reaction {c}, L_z0" for c in "xyz")}
    for mu in (0, 0.3):
        automatic, by_hand = (paired(name, scene, pairs) for name, pairs in (
            ("rim", {"": {"Surfaces": "automatic", "Friction coefficient": mu}}),
            ("rim_faces", {"": {"Slave": "L_z1", "Master": "U_z0",
                                "Friction coefficient": mu}})))
        forces, others = ([i["probes"]["z"] for i in of["increments"]]
                          for of in (automatic, by_hand))
        check(f"  the faces that touch, friction {mu}", all(
            abs(a - b) < 1e-3 * max(others) for a, b in zip(forces, others)),
            f"{forces} {others}")
        steps = [i["newton_iterations"] for i in automatic["increments"]]
        check("  as many steps", max(steps) <= 15 and len(steps) == 8, steps)


def three_in_an_edge():
    """Where all of three bodies touch, what sticks and slips on two of them is not
    free on the third one."""
    mesh = Volumes()
    for body, n, low, high in (("A", (4, 3, 1), (-3, -0.5, -1), (3, 2.5, 0)),
                               ("B", (3, 3, 3), (-2, 0, 0), (0, 2, 2)),
                               ("C", (4, 4, 3), (0, 0, 0), (2, 2, 2))):
        mesh.block(body, n, lambda *r, low=low, high=high: tuple(
            a + s * (b - a) for s, a, b in zip(r, low, high)))
    mesh.write("edge")
    for degree, mu in ((1, 0.3), (1, 1), (2, 0.3)):
        scene = {"Mesh/File": "edge.msh", "Element/Degree": degree,
                 "Solids/Young's modulus": "A: 2000, B: 1000, C: 1500",
                 "Solids/Poisson's ratio": "A: 0.3, B: 0.3, C: 0.3",
                 BC + "Displacement x": "A_z0: 0, B_x0: 0.02, C_x1: -0.03",
                 BC + "Displacement y": "A_z0: 0, B_x0: 0, C_x1: 0",
                 BC + "Displacement z": "A_z0: 0, B_z1: -0.03, C_z1: -0.04",
                 "Solution/Increments": 2, "Probes/Errors": "none",
                 "Probes/Probes": "; ".join(
                     f"{b}{c}: reaction {c}, {b}_{side}" for b, c, side in (
                         ("B", "x", "x0"), ("B", "z", "z1"), ("C", "x", "x1"),
                         ("C", "z", "z1")))}
        friction = {"Friction coefficient": mu}
        all_of = [paired(name, scene, pairs) for name, pairs in (
            ("edge", {"": {"Surfaces": "automatic", **friction}}),
            ("edge_faces", {pair: {"Slave": slave, "Master": master, **friction}
                            for pair, slave, master in (
                                ("b a", "B_z0", "A_z1"), ("c a", "C_z0", "A_z1"),
                                ("b c", "B_x1", "C_x0"))}))]
        forces, others = ([p["value"] for p in of["probes"]] for of in all_of)
        check(f"  degree {degree}, friction {mu}: the faces that touch", all(
            abs(a - b) < 1e-3 * max(map(abs, others)) for a, b in zip(forces, others)),
            f"{forces} {others}")
        steps = [[i["newton_iterations"] for i in of["increments"]] for of in all_of]
        check("  few steps", all(len(n) == 2 and max(n) <= 8 for n in steps), steps)


refusals(plane())
space()
three_in_an_edge()
over_a_rim()
sys.exit(bool(failures))
