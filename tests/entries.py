#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries that a scene may call for, run by the program.

Proves that

- displacements may be formulas of the place and of the load factor: two ends of
  a block that are turned by any angle turn it as a rigid body, in 2-D, in
  3-D and on two processes; a linear field gives the uniform stress of Hooke's
  law; nodes that hang follow others; two boundaries may share nodes where they
  move alike, by numbers or by formulas; groups may be made of others;
- points may be named by their place: supports, forces and probes there are those
  of the points of the mesh file; a place without a node is refused, and the
  closest node named, and so is the name of a boundary;
- an interference presses two blocks on each other, and a block on an obstacle,
  with the closed form's pressure, and is released again; with every
  discretization, in 2-D and in 3-D, and as the mesh would that overlaps;
- a curve in 3-D may be held, and has a reaction: a plate on two edges, of
  degree 1 and 2, on finer meshes and on two processes;
- a group of points is held, or excluded from contact, as its points one by one
  are, and so are the nodes of a curve;
- boundaries by a condition of their place are those of the file, in 2-D, of all
  bodies and of one, and in 3-D;
- a boundary may be tied to a point: a platen that a force pushes goes as far as
  the displacement that needs this force, with all nodes where they are then, in
  2-D, in 3-D, with nodes that hang, on two processes, and in contact.

Usage: entries.py CONTACT PARAMETERS MESHES
"""

import math
import pathlib
import sys

from block_scenes import Mesh, box, check, failures, rows, run, solve
from volume_scenes import Volumes

E, NU = 1000., 0.3
LAME = E * NU / ((1 + NU) * (1 - 2 * NU))
SOLID = {"Solids/Young's modulus": f"A: {E}",
         "Solids/Poisson's ratio": f"A: {NU}"}


def values(summary):
    return {p["name"]: p["value"] for p in summary["probes"]}


def alike():
    mesh = Mesh()
    # A left side that is on the axis but for round-off.
    mesh.block("A", 4, 3, box(1e-14, 0, 4, 2),
               {"left": "L", "right": "R", "bottom": "B", "top": "T"})
    mesh.add(0, "P", (12,))
    mesh.write("alike")
    entries = {**SOLID, "Mesh/File": "alike.msh", "Mesh/Groups": "Rims: B, T",
               "Solids/Kinematics": "small strain",
               "Boundary conditions/Displacement x": "L: 0, R: 0.04",
               "Boundary conditions/Displacement y": "Rims: 0",
               "Boundary conditions/Displacement formula x": "Rims: 0.01*x*t",
               "Solution/Increments": 2,
               "Probes/Probes": "xx: stress xx, P"}
    status, said, summary = run("alike", entries)
    check("supports that move alike where they meet, and a union of groups",
          status == 0, said[:300])
    if status == 0:
        check("  Hooke's stress", abs(values(summary)["xx"] / (
            0.01 * E * (1 - NU) / ((1 + NU) * (1 - 2 * NU))) - 1) < 1e-9)
    for what, change, expected in (
            ("one that moves away", {
                "Boundary conditions/Displacement formula x":
                "Rims: 0.01*x*t + 0.001*sin(6.283185307*t)"},
             "moved differently"),
            ("a union with the name of a group", {"Mesh/Groups": "L: B, T"},
             "of its own"),
            ("a union of what is not there", {"Mesh/Groups": "Rims: B, Top"},
             "no boundary 'Top'")):
        status, said, _ = run("refused", {**entries, **change})
        check(f"  {what} is refused", status == 2 and expected in said,
              said[:300])


def turned():
    mesh = Mesh()
    mesh.block("A", 4, 3, box(0, 0, 4, 2), {"left": "L", "right": "R",
                                            "corner": "C"})
    mesh.write("turned")
    block = Volumes()
    block.block("A", (3, 2, 2), lambda r, s, t: (4 * r, 2 * s, 2 * t),
                {"x0": "L", "x1": "R"})
    block.write("turned_space")
    angle = 1.3
    dx = f"x*(cos({angle}*t) - 1) - y*sin({angle}*t)"
    dy = f"x*sin({angle}*t) + y*(cos({angle}*t) - 1)"
    entries = {
        **SOLID, "Mesh/File": "turned.msh",
        "Boundary conditions/Displacement formula x": f"L: {dx}; R: {dx}",
        "Boundary conditions/Displacement formula y": f"L: {dy}; R: {dy}",
        "Solution/Increments": 4, "Output/Nodes": "true"}
    in_space = {"Mesh/File": "turned_space.msh",
                "Boundary conditions/Displacement z": "A_L: 0, A_R: 0"}
    for entry, value in (("x", dx), ("y", dy)):
        in_space["Boundary conditions/Displacement formula " +
                 entry] = f"A_L: {value}; A_R: {value}"
    c, s = math.cos(angle), math.sin(angle)
    for what, more, ranks in (
            ("in 2-D", {}, 1), ("of degree 2", {"Element/Degree": 2}, 1),
            ("on two processes", {}, 2), ("in 3-D", in_space, 1)):
        status, said, _ = run("turned", {**entries, **more}, ranks)
        worst = max(max(abs(n["displacement_x_mm"] - (c - 1) * n["X_mm"] +
                            s * n["Y_mm"]),
                        abs(n["displacement_y_mm"] - s * n["X_mm"] -
                            (c - 1) * n["Y_mm"]))
                    for n in rows("turned", "nodes.csv")) if status == 0 else 9
        check(f"a block turns as its ends do, {what}", worst < 1e-10,
              f"{worst} {said[:300]}")


def stretched():
    """u = (0.001 x t, 0): sigma_xx = (lambda + 2 mu) 0.001, sigma_yy = lambda
    0.001; only of t = 1."""
    mesh = Mesh()
    mesh.block("A", 4, 3, box(0, 0, 4, 2), {
        "left": "S", "right": "S", "top": "S", "bottom": "S", "corner": "C"})
    mesh.write("stretched")
    status, said, summary = run("stretched", {
        **SOLID, "Mesh/File": "stretched.msh",
        "Solids/Kinematics": "small strain",
        "Boundary conditions/Displacement formula x": "S: 0.001*x*t^2",
        "Boundary conditions/Displacement y": "S: 0", "Solution/Increments": 3,
        "Probes/Probes": "xx: stress xx, C; yy: stress yy, C"})
    found = values(summary) if status == 0 else {"xx": 0, "yy": 0}
    check("a linear displacement has Hooke's stress",
          abs(found["xx"] - 0.001 * (LAME + E / (1 + NU))) < 1e-12 * E and
          abs(found["yy"] - 0.001 * LAME) < 1e-12 * E, f"{found} {said[:300]}")

    for formula, reason in (("S: 0.001*z", "without z"), ("S: 1/x", "finite"),
                            ("S: 0.001*r", "no formula in x,y,z,t")):
        status, said, _ = run("refused", {
            **SOLID, "Mesh/File": "stretched.msh",
            "Boundary conditions/Displacement formula x": formula,
            "Boundary conditions/Displacement y": "S: 0"})
        check(f"'{formula}' is refused", status == 2 and reason in said,
              said[:300])


def hanging():
    """Refined where a corner is: nodes that hang follow others, not the
    formula."""
    mesh = Mesh()
    mesh.block("A", 4, 3, box(0, 0, 4, 2), {"left": "L", "right": "R",
                                            "corner": "C"})
    mesh.write("hanging")
    for degree, ranks in ((1, 1), (2, 1), (1, 2)):
        status, said, summary = run("hanging", {
            **SOLID, "Mesh/File": "hanging.msh", "Element/Degree": degree,
            "Boundary conditions/Displacement formula x":
                "L: -0.01*t*y^3; R: 0.01*t*sin(y)",
            "Boundary conditions/Displacement y": "L: 0, R: 0",
            "Refinement/Levels": 3, "Refinement/Strategy": "adaptive",
            "Probes/Probes": "yy: stress yy, C"}, ranks)
        check(f"hanging nodes, degree {degree}, {ranks} processes", status == 0,
              said[:300])


def shared_corner():
    """Two boundaries with a node in common."""
    mesh = Mesh()
    mesh.block("A", 4, 3, box(0, 0, 4, 2), {"left": "L", "bottom": "B",
                                            "corner": "C"})
    mesh.write("shared")
    for formulas, taken in (("L: 0.01*t; B: 0.01*t", True),
                            ("L: 0.01*t; B: 0.01*t + 0.001*x", True),
                            ("L: 0.01*t; B: 0.011*t + 0.001*x", False)):
        status, said, summary = run("shared", {
            **SOLID, "Mesh/File": "shared.msh",
            "Boundary conditions/Displacement formula x": formulas,
            "Boundary conditions/Displacement y": "B: 0",
            "Probes/Probes": "C: displacement x, C"})
        if taken:
            check("formulas that agree at a node", status == 0 and
                  abs(values(summary)["C"] - 0.01) < 1e-14, said[:300])
        else:
            check("other formulas are refused", status == 2 and
                  "moved differently" in said, said[:300])


def named_points():
    mesh = Mesh()
    mesh.block("A", 4, 3, box(0, 0, 4, 2), {"left": "L", "corner": "C"})
    mesh.write("points")
    scene = {**SOLID, "Mesh/File": "points.msh", "Mesh/Rotation": 30,
             "Boundary conditions/Displacement x": "L: 0",
             "Boundary conditions/Displacement y": "L: 0",
             "Mesh/Points": "tip: 4, 1.3333; foot: 0, 0",
             "Boundary conditions/Force y": "tip: -0.1",
             "Probes/Probes": "tip: displacement y, tip; foot: stress xx, foot;"
                              " C: stress xx, C"}
    status, said, summary = run("points", scene)
    found = values(summary) if status == 0 else {"tip": 0, "foot": 0, "C": 1}
    check("points by their place", found["tip"] < 0 and
          found["foot"] == found["C"], f"{found} {said[:300]}")
    for points, reason in (("tip: 5, 1.2", "at (4, 1.33333)"),
                           ("tip: 4", "no place"), ("C: 4, 2", "of its own"),
                           (scene["Mesh/Points"] + "; L: 4, 2",
                            "a point as well as a boundary")):
        status, said, _ = run("points", {**scene, "Mesh/Points": points})
        check(f"'{points}' is refused", status == 2 and reason in said,
              said[:300])


def platen():
    """A block on ground that it presses aslant, by the force on its head, which
    is guided: all nodes have one displacement, and the reaction is the force."""
    mesh = Mesh()
    mesh.block("A", 6, 2, box(-6, -5, 6, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 5, 2, box(-3, 0, 3, 4), {"bottom": "Sole", "top": "Head",
                                             "right": "Side"})
    mesh.write("platen")
    block = Volumes()
    block.block("A", (3, 3, 2), lambda r, s, t: (
        12 * r - 6, 12 * s - 6, 5 * t - 5), {"z0": "Base", "z1": "Ground"}, {})
    block.block("B", (3, 2, 2), lambda r, s, t: (
        6 * r - 3, 6 * s - 3, 4 * t), {"z0": "Sole", "z1": "Head"}, {})
    block.write("platen_space")
    plane = {"Mesh/File": "platen.msh", "Mesh/Points": "P: -3, 4; Q: -6, -5"}
    adaptive = {"Refinement/Levels": 4, "Refinement/Strategy": "adaptive"}
    space = {"Mesh/File": "platen_space.msh", "Mesh/Points": "P: -3, -3, 4"}
    for what, more, ranks in (
            ("in 2-D", plane, 1), ("on two processes", plane, 2),
            ("of degree 2", {**plane, "Element/Degree": 2}, 1),
            ("with hanging nodes", {**plane, **adaptive}, 1),
            ("in 3-D", space, 1), ("in 3-D, two processes", space, 2)):
        down = "z" if "3-D" in what else "y"
        head, base, sole, ground = (
            ("Head", "Base", "Sole", "Ground") if down == "y" else
            ("B_Head", "A_Base", "B_Sole", "A_Ground"))
        axes = "xyz" if down == "z" else "xy"
        scene = {"Solids/Young's modulus": "A: 1000, B: 3000",
                 "Solids/Poisson's ratio": "A: 0.3, B: 0.2", **more,
                 "Contact/Slave": sole, "Contact/Master": ground,
                 "Contact/Friction coefficient": 0.3, "Output/Nodes": "true"}
        force = {down: -30., "x": 4.}
        pushed, moved = dict(scene), dict(scene)
        for c in axes:
            held = "Q" if "hanging" in what else base
            pushed[f"Boundary conditions/Displacement {c}"] = f"{held}: 0"
            pushed[f"Boundary conditions/Tied {c}"] = (
                f"{head}: P" + (", Base: Q" if held == "Q" else ""))
            if c in force:
                pushed[f"Boundary conditions/Resultant force {c}"] = (
                    f"{head}: {force[c]}")
        pushed["Probes/Probes"] = "; ".join(
            f"{c}: displacement {c}, P" for c in axes)
        status, said, summary = run("platen", pushed, ranks)
        if status != 0:
            check(f"a platen, {what}", False, said[:400])
            continue
        found, nodes = values(summary), rows("platen", "nodes.csv")
        if ranks > 1:  # of which one alone has the ties
            status, said, _ = run("platen_gmg", {
                **pushed, "Solution/Linear solver": "GMG"}, ranks)
            check(f"a platen, {what}: refused without a matrix",
                  status == 2 and "tied together" in said, said[-400:])
        for c in axes:
            moved[f"Boundary conditions/Displacement {c}"] = (
                f"{base}: 0, {head}: {found[c]!r}")
        if "hanging" in what:  # the mesh of other loads would be another one
            foot = [n for n in nodes if n["Y_mm"] == -5]
            worst = max(abs(n[f"displacement_{c}_mm"]) for n in foot
                        for c in axes)
            check(f"a platen, {what}", 7 < len(foot) < 97 and worst < 1e-13,
                  f"{worst} {len(foot)}")
            continue
        status, said, summary = run("platen", moved, ranks)
        others = rows("platen", "nodes.csv") if status == 0 else []
        worst = max(abs(a[f"displacement_{c}_mm"] - b[f"displacement_{c}_mm"])
                    for a, b in zip(nodes, others) for c in axes) if others else 9
        wrong = max(abs(summary["increments"][-1]["reactions"][head][c] - f)
                    for c, f in force.items()) if others else 9
        check(f"a platen, {what}", worst < 1e-9 and wrong < 1e-6,
              f"{worst} {wrong} {said[:300]}")


def curves():
    """A plate on two of its edges, under pressure."""
    block = Volumes()
    block.block("A", (4, 2, 2), lambda r, s, t: (4 * r, 2 * s, t),
                {"z1": "Top"}, {})
    for x, name in ((0, "Left"), (4, "Right")):
        ends = [block.places["A", x, y, 0] for y in (0, 1, 2)]
        for pair in zip(ends, ends[1:]):
            block.add(1, name, list(pair))
    block.write("curves")
    scene = {**SOLID, "Mesh/File": "curves.msh",
             "Boundary conditions/Displacement x": "Left: 0",
             "Boundary conditions/Displacement y": "Left: 0",
             "Boundary conditions/Displacement z": "Left: 0, Right: 0",
             "Boundary conditions/Pressure": "A_Top: 0.01",
             "Probes/Probes": "Left: reaction z, Left; Right: reaction z, Right",
             "Output/Nodes": "true"}
    adaptive = {"Refinement/Levels": 2, "Refinement/Strategy": "adaptive"}
    for what, more, ranks in (
            ("", {}, 1), (", degree 2", {"Element/Degree": 2}, 1),
            (", refined", {"Mesh/Refinements": 1}, 2),
            (", adaptive", adaptive, 1), (", adaptive", adaptive, 2)):
        status, said, summary = run("curves", {**scene, **more}, ranks)
        if status != 0:
            check(f"a plate on edges{what}, {ranks} processes", False, said[:400])
            continue
        nodes = rows("curves", "nodes.csv")
        on_edge = [n for n in nodes if n["X_mm"] in (0, 4) and n["Z_mm"] == 0]
        held = [n for n in nodes if n["displacement_z_mm"] == 0]
        forces = summary["increments"][-1]["reactions"]
        lift = sum(forces[name]["z"] for name in ("Left", "Right"))
        check(f"a plate on edges{what}, {ranks} processes",
              held == on_edge and abs(lift - 0.08) < 1e-10 and all(
                  abs(values(summary)[name] - forces[name]["z"]) < 1e-12
                  for name in ("Left", "Right")),
              f"{len(held)} {len(on_edge)} {lift} {values(summary)}")
    status, said, _ = run("curves", {
        **scene, "Boundary conditions/Tied z": "Right: A_000",
        "Boundary conditions/Displacement z": "Left: 0",
        "Mesh/Points": "A_000: 4, 0, 0"})
    check("a curve is tied", status == 2 and "rotation" in said, said[:300])


def groups_of_nodes():
    mesh = Mesh()
    mesh.block("A", 3, 2, box(-1, 0, 5, 2), {"bottom": "Base", "top": "Ground"})
    first = len(mesh.nodes) + 1
    mesh.block("B", 4, 2, box(0, 2, 4, 5), {"bottom": "Sole", "top": "Head"})
    for k, name in ((0, "P"), (1, "Q"), (3, "R"), (4, "S")):
        mesh.add(0, name, (first + k,))
    for k in (0, 4):
        mesh.add(0, "Ends", (first + k,))
    mesh.add(1, "Heel", (first, first + 1))
    mesh.add(1, "Toe", (first + 3, first + 4))
    mesh.write("groups")
    scene = {"Mesh/File": "groups.msh",
             "Solids/Young's modulus": "A: 1000, B: 3000",
             "Solids/Poisson's ratio": "A: 0.3, B: 0.2",
             "Boundary conditions/Displacement x": "Base: 0, Head: 0.01",
             "Boundary conditions/Displacement y": "Base: 0, Head: -0.1",
             "Contact/Slave": "Sole", "Contact/Master": "Ground",
             "Solution/Newton tolerance": 1e-12, "Solution/Geometry tolerance": 1e-10,
             "Probes/Probes": "force: contact force y, Sole; "
                              "p: pressure, Q"}

    def solved(more, ranks=1):
        # What is left out of contact may be inside of the other body.
        status, said, summary = run("groups", {**scene, **more}, ranks)
        return values(summary) if status < 2 else {"failed": said[:300]}

    free = solved({"Probes/Probes": "force: contact force y, Sole"})
    for what, entry, each, group, degree in (
            ("excluded points", "Contact/Excluded points", "P, S", "Ends", 1),
            ("an excluded curve", "Contact/Excluded points", "R, S", "Toe", 1),
            ("excluded, degree 2", "Contact/Excluded points", "P, S", "Ends", 2),
            ("a curve and one of its points", "Contact/Excluded points", "R, S",
             "Toe, S", 1),
            ("held points", "Boundary conditions/Displacement x",
             "Base: 0, Head: 0.01, P: 0.002, S: 0.002",
             "Base: 0, Head: 0.01, Ends: 0.002", 1)):
        expected = solved({entry: each, "Element/Degree": degree})
        for ranks in (1, 2):
            found = solved({entry: group, "Element/Degree": degree}, ranks)
            check(f"{what}, {ranks} processes", "force" in found
                  and all(abs(found[name] - value) < 1e-8 * abs(value)
                          for name, value in expected.items()) and
                  abs(found["force"] - free["force"]) > 1e-3 * found["force"],
                  f"{found} {expected} {free}")
    for what, more, reason in (
            ("none on the slave", {"Contact/Excluded points": "Base"},
             "no node of 'Base' is on the slave"),
            ("a probe at several points", {
                "Probes/Probes": "u: displacement x, Ends"},
             "more than one point")):
        status, said, _ = run("groups", {**scene, **more})
        check(f"{what} is refused", status == 2 and reason in said, said[:300])


def places():
    names = {"bottom": "Base", "top": "Top"}
    plane, bare = Mesh(), Mesh()
    for mesh, of_lower, of_upper in (
            (plane, names, {"bottom": "Sole", "top": "Head", "right": "Side"}),
            (bare, {}, {})):
        mesh.block("A", 3, 2, box(-1, 0, 5, 2), of_lower)
        mesh.block("B", 4, 2, box(0, 2, 4, 5), of_upper)
    plane.write("named")
    bare.write("bare")
    sides = {"y0": "Base", "y1": "Top", "z0": "Front"}
    for name, groups in (("space_named", sides), ("space_bare", {})):
        block = Volumes()
        block.block("A", (2, 2, 2), lambda r, s, t: (r, 2 * s, t), groups, {})
        block.write(name)
    two = {"Solids/Young's modulus": "A: 1000, B: 3000",
           "Solids/Poisson's ratio": "A: 0.3, B: 0.2",
           "Boundary conditions/Displacement x": "Base: 0, Head: 0",
           "Boundary conditions/Displacement y": "Base: 0, Head: -0.1",
           "Boundary conditions/Pressure": "Side: 3",
           "Contact/Slave": "Sole", "Contact/Master": "Top",
           "Probes/Probes": "force: contact force y, Sole"}
    one = {"Solids/Young's modulus": "A: 1000", "Solids/Poisson's ratio": "A: 0.3",
           "Boundary conditions/Displacement x": "A_Base: 0",
           "Boundary conditions/Displacement y": "A_Base: 0, A_Top: 0.1",
           "Boundary conditions/Displacement z": "A_Front: 0",
           "Probes/Probes": "force: reaction y, A_Top"}
    for what, scene, named, bare, faces in (
            ("in 2-D", two, "named", "bare",
             "Base: y < 0.01; Top in A: abs(y - 2) < 0.01; Sole in B: y < 2.01; "
             "Head: y > 4.99; Side in B: x > 3.99 && y > 1"),
            ("in 3-D", one, "space_named", "space_bare",
             "A_Base: y < 0.01; A_Top: y > 1.99; A_Front: z < 0.01")):
        found = []
        for mesh, more in ((named, {}), (bare, {"Mesh/Faces": faces})):
            status, said, summary = run(
                mesh, {**scene, "Mesh/File": f"{mesh}.msh", **more})
            found.append(values(summary)["force"] if status == 0 else said)
        check(f"boundaries by place {what}",
              isinstance(found[0], float) and found[0] == found[1], str(found))
    for what, faces, reason in (
            ("with no face", "Base: y < -1", "no outer face"),
            ("of no body", "Base in C: y < 1", "no outer face"),
            ("that cannot be read", "Base: y <", "Mesh/Faces"),
            ("that is assigned", "Base: y = 0", "single '='"),
            ("with a name of the file", "Head: y > 4.99", "is a group 'Head'")):
        status, said, _ = run("named", {
            **two, "Mesh/File": "named.msh", "Mesh/Faces": faces})
        check(f"a boundary {what} is refused", status == 2 and reason in said,
              said[:300])


def interference():
    """Two blocks between walls, L1 = 2 and L2 = 3 long, free across:
    p = delta/(L1/E1 + L2/E2). Without Poisson's ratio they stay as wide."""
    for n, name in ((4, "interference"), (3, "interference_matching")):
        mesh = Mesh()
        mesh.block("A", 3, 2, box(0, 0, 3, 2), {
            "bottom": "Base", "top": "Ground", "left": "Side"})
        mesh.block("B", n, 2, box(0, 2, 3, 5), {
            "bottom": "Sole", "top": "Head", "left": "Side"})
        mesh.write(name)
    mesh = Mesh()
    mesh.block("A", 3, 2, box(0, 0, 3, 2), {"bottom": "Base", "top": "Ground",
                                            "left": "Side"})
    mesh.write("on_plane")
    for m, name in ((3, "space"), (2, "space_matching")):
        block = Volumes()
        for body, n, z in (("A", 2, (0, 2)), ("B", m, (2, 5))):
            block.block(body, (n, n, 1), lambda r, s, t: (
                3 * r, 3 * s, z[0] + (z[1] - z[0]) * t),
                        {"z0": "Low", "z1": "High", "x0": "X", "y0": "Y"}, {})
        block.write("interference_" + name)
    nu, delta = 0., 0.01
    plane = {"Mesh/File": "interference.msh",
             "Boundary conditions/Displacement x": "Side: 0",
             "Boundary conditions/Displacement y": "Base: 0, Head: 0",
             "Contact/Slave": "Sole", "Contact/Master": "Ground"}
    rigid = {"Mesh/File": "on_plane.msh",
             "Boundary conditions/Displacement x": "Side: 0",
             "Boundary conditions/Displacement y": "Base: 0",
             "Contact/Slave": "Ground",
             "Contact/Obstacle": "half plane: 0, 2, 0, -1"}
    space = {"Mesh/File": "interference_space.msh",
             "Boundary conditions/Displacement x": "A_X: 0, B_X: 0",
             "Boundary conditions/Displacement y": "A_Y: 0, B_Y: 0",
             "Boundary conditions/Displacement z": "A_Low: 0, B_High: 0",
             "Contact/Slave": "B_Low", "Contact/Master": "A_High"}
    matching = {**plane, "Mesh/File": "interference_matching.msh"}
    history = f"table(0 0, 0.5 {delta}, 1 0)"
    for what, more in (
            ("mortar", plane),
            ("nodal", {**matching, "Contact/Discretization": "nodal"}),
            ("Gauss", {**matching, "Contact/Discretization": "Gauss"}),
            ("degree 2", {**plane, "Element/Degree": 2}),
            ("with friction", {**plane, "Contact/Friction coefficient": 0.1}),
            ("on a plane", rigid), ("in 3-D", space),
            ("in 3-D, nodal", {**space, "Contact/Discretization": "nodal",
                                 "Mesh/File": "interference_space_matching.msh"})):
        bodies = ["A"] if what == "on a plane" else ["A", "B"]
        scene = {**more, "Solids/Kinematics": "small strain",
                 "Solids/Young's modulus": ", ".join(
                     f"{b}: {E}" for b, E in zip(bodies, (1000., 3000.))),
                 "Solids/Poisson's ratio": ", ".join(
                     f"{b}: {nu}" for b in bodies),
                 "Contact/Interference": history, "Solution/Increments": 4}
        status, said, summary = run("interference", scene)
        if status != 0:
            check(f"interference, {what}", False, said[:400])
            continue
        give = 2 / 1000. + (3 / 3000. if len(bodies) > 1 else 0)
        across = 9 if "3-D" in what else 3
        expected = delta / give * across
        base = "A_Low" if "3-D" in what else "Base"
        forces = [i["reactions"][base]["z" if "3-D" in what else "y"]
                  for i in summary["increments"]]
        check(f"interference, {what}",
              abs(forces[1] - expected) < 1e-9 * expected and
              abs(forces[0] - expected / 2) < 1e-9 * expected and
              abs(forces[3]) < 1e-9 * expected, f"{forces} {expected}")
    # A clearance: the head goes down by a half of it, then by twice as much.
    for what, more in (("", plane), (" on a plane", rigid)):
        head = "Base" if what else "Head"
        sign = 1 if what else -1
        scene = {**more, "Solids/Kinematics": "small strain",
                 "Solids/Young's modulus": "A: 1000" if what else
                 "A: 1000, B: 3000",
                 "Solids/Poisson's ratio": "A: 0" if what else "A: 0, B: 0",
                 "Contact/Interference": "-0.01",
                 "Boundary conditions/Displacement y": f"{head}: {0.02 * sign}" +
                 ("" if what else ", Base: 0"),
                 "Boundary conditions/Histories":
                 "Displacement y: table(0 0, 0.5 0.25, 1 1)"}
        status, said, summary = run("clearance", scene)
        forces = [abs(i["reactions"][head]["y"])
                  for i in summary.get("increments", [])]
        expected = 3 * 0.01 / (0.002 if what else 0.003)
        check("clearance" + what, status == 0 and forces[0] < 1e-9 and
              abs(forces[1] - expected) < 1e-9 * expected, f"{forces} {said[:300]}")
    status, said, _ = run("interference", {
        **plane, **SOLID, "Solids/Young's modulus": "A: 1, B: 1",
        "Solids/Poisson's ratio": "A: 0, B: 0", "Contact/Tied": "true",
        "Contact/Interference": "0.1"})
    check("none of glue", status == 2 and "Interference" in said, said[:300])


def tied_slave():
    """Contact would hold twice what is tied."""
    scene = {"Mesh/File": "platen.msh", "Mesh/Points": "P: -3, 0; Q: -6, 0",
             "Solids/Young's modulus": "A: 1000, B: 3000",
             "Solids/Poisson's ratio": "A: 0.3, B: 0.2",
             "Boundary conditions/Displacement x": "Base: 0, Head: 0",
             "Boundary conditions/Displacement y": "Base: 0, Head: -0.1"}
    pair = {"Contact/Slave": "Sole", "Contact/Master": "Ground"}
    plane = {"Contact/Slave": "Sole",
             "Contact/Obstacle": "half plane: 0, 0, 0, 1"}
    status, said, _ = run("tied_slave", {
        **scene, **pair, "Contact/Friction coefficient": 0.3,
        "Mesh/Points": "P: 3, 4", "Boundary conditions/Displacement x": "Base: 0",
        "Boundary conditions/Tied x": "Side: P"})
    check("a side that is tied, with friction", status == 2 and
          "friction would hold it twice" in said, said[:300])
    for what, more, taken in (
            ("slave", {**pair, "Boundary conditions/Tied y": "Sole: P"}, False),
            ("slave on a plane", {**plane, "Boundary conditions/Tied y":
                                  "Sole: P"}, False),
            ("master", {**pair, "Boundary conditions/Tied y": "Ground: Q"},
             True)):
        status, said, _ = run("tied_slave", {**scene, **more})
        check(f"a tied {what}", status == 0 if taken else
              status == 2 and "tied to another one" in said, said[:400])


def left_out():
    """A pair whose slave the command line takes away is none."""
    mesh = Mesh()
    mesh.block("A", 4, 2, box(-4, -5, 4, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 3, 2, box(-3, 0, 3, 4), {"bottom": "Sole", "top": "Head"})
    mesh.write("left_out")
    run("left_out", {
        "Mesh/File": "left_out.msh",
        "Solids/Young's modulus": "A: 1000, B: 1000",
        "Solids/Poisson's ratio": "A: 0.3, B: 0.3",
        "Boundary conditions/Displacement x": "Base: 0, Head: 0",
        "Boundary conditions/Displacement y": "Base: 0, Head: -0.1",
        "Contact low/Slave": "Sole", "Contact low/Master": "Ground",
        "Contact low/Friction coefficient": 0.2,
        "Contact high/Slave": "Head", "Contact high/Friction coefficient": 0.2,
        "Contact high/Obstacle": "half plane: 0, 5, 0, -1"})
    status, said, summary = solve(pathlib.Path("left_out.prm"), "Contact high/Slave=",
                                  "Contact  low / Slave =")
    check("pairs that are left out", status == 0 and
          not any(
              of for name, of in summary.items() if name.startswith("contact")), said[:300])


turned()
alike()
stretched()
left_out()
hanging()
shared_corner()
named_points()
platen()
curves()
groups_of_nodes()
places()
interference()
tied_slave()
sys.exit(len(failures) > 0)
