#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundaries that move as rigid bodies, run by the program.

Proves that

- a moment bends a beam, and an eccentric force tilts the head of a column, by the
  closed forms without Poisson's ratio, in 2-D, in 3-D, with nodes that
  hang and on two processes, also about a point that is not of the mesh; a force
  pushes the head of a ring;
- a rotation of any size turns a block without stress, to where formulas of the
  place would; the moment that this needs of a beam turns it as far again;
- a force at the end of an arm takes at most 5 steps an increment in large
  displacement, and its moment is that of where the arm is;
- a punch that an eccentric force tilts has the forces of one that is moved so,
  and a block in 3-D that is refined adaptively is the same on two processes;
- a moment that supports and contact share is noted, and what it is of supports;
- a plane of symmetry may hold a boundary that turns about its normal: half of
  the beam takes half of the moment; what contradicts it is refused.

Usage: rigid.py CONTACT PARAMETERS MESHES
"""

import math
import sys

from block_scenes import Mesh, box, check, failures, rows, run
from volume_scenes import Volumes

E = 1000.
SOLID = {"Solids/Young's modulus": f"A: {E}", "Solids/Poisson's ratio": "A: 0",
         "Solids/Kinematics": "small strain"}
BC = "Boundary conditions/"


def values(summary):
    return {p["name"]: p["value"] for p in summary["probes"]}


def near(found, expected, tolerance):
    return bool(found) and all(
        abs(found[k] - v) <= tolerance * (abs(v) or 1)
        for k, v in expected.items())


def columns():
    """A column of the height h and the width b: the head turns by M h/(E I),
    I = b^3/12, and the force F at the distance e has M = F e."""
    mesh = Mesh()
    mesh.block("A", 2, 4, box(-1, 0, 1, 6), {"bottom": "Foot", "top": "Head"})
    mesh.write("column")
    block = Volumes()
    block.block("A", (2, 2, 3), lambda r, s, t: (2 * r - 1, 2 * s - 1, 6 * t))
    block.write("column_space")
    h, b, F, M = 6., 2., -3., 0.4
    plane = {**SOLID, "Mesh/File": "column.msh", "Mesh/Points": "P: 1, 6",
             "Element/Degree": 2, BC + "Displacement x": "Foot: 0",
             BC + "Displacement y": "Foot: 0", BC + "Rigid": "Head: P",
             BC + "Force y": f"Head: {F}", BC + "Moment z": f"Head: {M}",
             "Probes/Probes": "turn: rotation z, Head; down: displacement y, P;"
             " N: reaction y, Head; M: reaction moment z, Head"}
    turn = (F * b / 2 + M) * h / (E * b ** 3 / 12)
    expected = {"turn": turn, "down": F * h / (E * b) + turn, "N": 0, "M": 0}
    turned = {**plane, BC + "Rotation z": f"Head: {turn!r}"}
    del turned[BC + "Moment z"]
    for what, scene, more, ranks in (
            ("of degree 2", plane, {}, 1), ("on two processes", plane, {}, 2),
            ("refined", plane, {"Refinement/Levels": 2}, 1),
            ("with hanging nodes", plane, {
                "Refinement/Levels": 2, "Refinement/Strategy": "adaptive"}, 1),
            ("turned", turned, {}, 1)):
        status, said, summary = run("column", {**scene, **more}, ranks)
        found = values(summary) if status == 0 else {}
        check(f"an eccentric force on a column, {what}", near(
            found, {**expected, "M": M if what == "turned" else 0}, 1e-8),
            f"{found} {expected} {said[:300]}")

    # The point is beside the mesh.
    x = 3.
    status, said, summary = run("column", {
        **plane, "Mesh/Points": f"P: {x}, 7",
        "Probes/Probes": "turn: rotation z, Head; N: reaction y, Head"})
    found = values(summary) if status == 0 else {}
    check("a force beside a column", near(
        found, {"turn": (F * x + M) * h / (E * b ** 3 / 12), "N": 0}, 1e-8),
        f"{found} {said[:300]}")

    # A spin of 1e-5, whose unknowns are all known to their round-off.
    status, said, summary = run("column", {
        **plane, "Element/Degree": 1, "Solution/Increments": 8,
        BC + "Force y": "Head: -0.003", BC + "Moment z": "Head: 0.0037"})
    steps = [i["newton_iterations"] for i in summary.get("increments", [])]
    check("a small moment takes a step an increment", status == 0 and
          len(steps) == 8 and max(steps) <= 2, steps)

    space = {**SOLID, "Mesh/File": "column_space.msh", "Element/Degree": 2,
             BC + "Rigid": "A_z1: A_111", BC + "Force z": f"A_z1: {F}",
             BC + "Moment y": f"A_z1: {M}", "Probes/Probes":
             "x: rotation x, A_z1; y: rotation y, A_z1; z: rotation z, A_z1;"
             " down: displacement z, A_111; M: reaction moment y, A_z1"}
    for c in "xyz":
        space[BC + f"Displacement {c}"] = "A_z0: 0"
    EI = E * b ** 4 / 12
    x, y = F * b / 2 * h / EI, (M - F * b / 2) * h / EI
    expected = {"x": x, "y": y, "z": 0, "down": F * h / (E * b * b) + x - y,
                "M": 0}
    for ranks in (1, 2):
        status, said, summary = run("column_space", space, ranks)
        found = values(summary) if status == 0 else {}
        check(f"the same in 3-D, {ranks} processes",
              near(found, expected, 1e-7), f"{found} {expected} {said[:300]}")

    mesh = Mesh()
    mesh.block("A", 2, 3, box(0, 0, 2, 6), {"bottom": "Foot", "top": "Head"})
    mesh.write("disc")
    status, said, summary = run("disc", {
        **plane, "Mesh/File": "disc.msh", "Mesh/Points": "P: 0, 6",
        "Solids/Symmetry": "axisymmetric", "Probes/Probes":
        "down: displacement y, P; N: reaction y, Head",
        BC + "Moment z": ""})
    found = values(summary) if status == 0 else {}
    check("a force on the head of a disc", near(found, {
        "down": F * h / (E * math.pi * 4), "N": 0}, 1e-8),
        f"{found} {said[:300]}")


def turns():
    """By 1.3 rad about a corner, and a beam by more than a right angle."""
    mesh = Mesh()
    mesh.block("A", 4, 2, box(0, 0, 4, 2), {"left": "L", "right": "R",
                                            "corner": "C"})
    mesh.write("block")
    large = {"Solids/Young's modulus": f"A: {E}",
             "Solids/Poisson's ratio": "A: 0.3", "Output/Nodes": "true",
             "Mesh/File": "block.msh", "Solution/Increments": 4}
    about = {**large, BC + "Rigid": "L: C, R: C",
             BC + "Displacement x": "L: 0, R: 0",
             BC + "Displacement y": "L: 0, R: 0",
             BC + "Rotation z": "L: 1.3, R: 1.3"}
    c, s = math.cos(1.3), math.sin(1.3)
    for ranks in (1, 2):
        status, said, _ = run("block", about, ranks)
        worst = max(max(abs(n["displacement_x_mm"] - (c - 1) * n["X_mm"] +
                            s * n["Y_mm"]),
                        abs(n["displacement_y_mm"] - s * n["X_mm"] -
                            (c - 1) * n["Y_mm"]))
                    for n in rows("block", "nodes.csv")) if status == 0 else 9
        check(f"a block turns, {ranks} processes", worst < 1e-10,
              f"{worst} {said[:300]}")

    block = Volumes()
    block.block("A", (3, 1, 1), lambda r, s, t: (4 * r, s, t))
    block.write("block_space")
    phi = (0.3, -0.5, 0.7)
    angle = math.hypot(*phi)
    n = [a / angle for a in phi]
    space = {**large, "Mesh/File": "block_space.msh",
             BC + "Rigid": "A_x0: A_000, A_x1: A_000"}
    for k, a in enumerate("xyz"):
        space[BC + f"Displacement {a}"] = "A_x0: 0, A_x1: 0"
        space[BC + f"Rotation {a}"] = f"A_x0: {phi[k]}, A_x1: {phi[k]}"
    for ranks in (1, 2):
        status, said, _ = run("block_space", space, ranks)
        worst = 9. * (status != 0)
        for node in rows("block_space", "nodes.csv") if status == 0 else ():
            X = [node[f"{a}_mm"] for a in "XYZ"]
            nX = sum(a * b for a, b in zip(n, X))
            cross = [n[1] * X[2] - n[2] * X[1], n[2] * X[0] - n[0] * X[2],
                     n[0] * X[1] - n[1] * X[0]]
            for k, a in enumerate("xyz"):
                u = ((math.cos(angle) - 1) * (X[k] - n[k] * nX) +
                     math.sin(angle) * cross[k])
                worst = max(worst, abs(node[f"displacement_{a}_mm"] - u))
        check(f"the same in 3-D, {ranks} processes", worst < 1e-10,
              f"{worst} {said[:300]}")

    mesh = Mesh()
    mesh.block("A", 12, 1, box(0, 0, 12, 1), {"left": "L", "right": "R"})
    mesh.write("beam")
    bent = {**large, "Mesh/File": "beam.msh", "Mesh/Points": "P: 12, 1",
            "Element/Degree": 2, "Solution/Increments": 8,
            BC + "Displacement x": "L: 0", BC + "Displacement y": "L: 0",
            BC + "Rigid": "R: P", "Probes/Probes":
            "turn: rotation z, R; M: reaction moment z, R;"
            " x: displacement x, P; y: displacement y, P"}
    status, said, summary = run("beam", {**bent, BC + "Rotation z": "R: 2.2"})
    by_turn = values(summary) if status == 0 else {}
    moment = by_turn.get("M", 0)
    status, said, summary = run("beam", {**bent,
                                         BC + "Moment z": f"R: {moment!r}"})
    found = values(summary) if status == 0 else {}
    steps = [i["newton_iterations"] for i in summary.get("increments", [])]
    check("a moment turns a beam as far as the turn that needs it",
          near(found, {**by_turn, "turn": 2.2, "M": 0}, 1e-6) and moment > 0,
          f"{by_turn} {found} {steps} {said[:300]}")


def arm():
    """A dead force at the end of an arm, or the reaction of its displacement: the
    clamped side has its moment about O, where the arm is then, and steps converge
    quadratically."""
    mesh = Mesh()
    mesh.block("A", 8, 4, box(0, 0, 2, 1), {"left": "L", "right": "R"})
    mesh.write("arm")
    held = {BC + "Displacement x": "L: 0", BC + "Displacement y": "L: 0"}
    for what, ranks, pushed in (
            ("force", 1, {BC + "Force x": "R: 0.5", BC + "Force y": "R: -0.2"}),
            ("force", 2, {BC + "Force x": "R: 0.5", BC + "Force y": "R: -0.2"}),
            ("displacement", 1, {BC + "Displacement x": "L: 0, R: 1.5",
                                 BC + "Displacement y": "L: 0, R: -1.5"}),
            ("displacement x", 2, {BC + "Displacement x": "L: 0, R: 1"})):
        status, said, summary = run("arm", {
            "Mesh/File": "arm.msh", "Mesh/Points": "P: 5, 4; O: -1, 0; E: 2, 0",
            "Element/Degree": 2, "Solids/Young's modulus": "A: 100",
            "Solids/Poisson's ratio": "A: 0.3", "Solution/Increments": 4,
            BC + "Rigid": "L: O, R: P", **held, BC + "Rotation z": "L: 0", **pushed,
            "Probes/Probes": "turn: rotation z, R; M: reaction moment z, L;"
            " x: displacement x, E; y: displacement y, E;"
            " Fx: reaction x, L; Fy: reaction y, L"}, ranks)
        found = values(summary) if status == 0 else {}
        steps = [i["newton_iterations"] for i in summary.get("increments", [])]
        if found:
            c, s = math.cos(found["turn"]), math.sin(found["turn"])
            x = 2 + found["x"] + c * 3 - s * 4
            y = found["y"] + s * 3 + c * 4
            expected = (x + 1) * found["Fy"] - y * found["Fx"]
        check(f"an arm turns by {what}, {ranks} processes",
              found and near(found, {"M": expected}, 1e-7) and max(steps) <= 5
              and found["turn"] < -0.2, f"{found} {steps} {said[:300]}")


def punch():
    mesh = Mesh()
    mesh.block("A", 8, 3, box(-6, -5, 6, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 4, 2, box(-3, 0, 3, 4), {"bottom": "Sole", "top": "Head"})
    mesh.write("punch")
    scene = {"Mesh/File": "punch.msh", "Mesh/Points": "P: -3, 4; Q: 3, 4",
             "Solids/Young's modulus": "A: 1000, B: 3000",
             "Solids/Poisson's ratio": "A: 0.3, B: 0.2",
             "Contact/Slave": "Sole", "Contact/Master": "Ground",
             BC + "Displacement x": "Base: 0", BC + "Displacement y": "Base: 0",
             BC + "Rigid": "Head: P", "Output/Nodes": "true",
             "Probes/Probes": "turn: rotation z, Head; x: displacement x, P;"
             " y: displacement y, P; N: reaction y, Head;"
             " M: reaction moment z, Head"}
    F, at = -20., 2.2
    for what, more, ranks in (("", {}, 1), (", on two processes", {}, 2), (
            ", with friction", {"Contact/Friction coefficient": 0.3}, 1)):
        status, said, summary = run("punch", {
            **scene, **more, BC + "Force y": f"Head: {F}",
            BC + "Force x": "Head: 1" if more else "Head: 0",
            BC + "Displacement x": "Base: 0" + ("" if more else ", Head: 0"),
            **({} if more else {BC + "Force x": ""}),
            BC + "Moment z": f"Head: {F * at}"}, ranks)
        found = values(summary) if status == 0 else {"turn": 0, "x": 0, "y": 0}
        nodes = rows("punch", "nodes.csv") if status == 0 else []
        status, said_then, summary = run("punch", {
            **scene, **more,
            BC + "Displacement x": f"Base: 0, Head: {found['x']!r}",
            BC + "Displacement y": f"Base: 0, Head: {found['y']!r}",
            BC + "Rotation z": f"Head: {found['turn']!r}"}, ranks)
        moved = values(summary) if status == 0 else {}
        others = rows("punch", "nodes.csv") if nodes and moved else []
        worst = max((abs(a[f"displacement_{c}_mm"] - b[f"displacement_{c}_mm"])
                     for a, b in zip(nodes, others) for c in "xy"), default=9)
        check(f"an eccentric punch{what}", worst < 1e-7 and
              near(moved, {"N": F, "M": F * at}, 1e-6) and found["turn"] > 0,
              f"{worst} {found} {moved} {said[:300]} {said_then[:300]}")

    # The ground is rigid and held: its body exerts nothing on it, what holds it
    # has the force and the moment of contact, about its point.
    status, said, summary = run("punch", {
        **scene, BC + "Displacement x": "Ground: 0, Head: 0",
        BC + "Displacement y": "Ground: 0", BC + "Rotation z": "Ground: 0",
        BC + "Rigid": "Head: P, Ground: O", "Mesh/Points": "P: -3, 4; O: -6, 0",
        BC + "Force y": f"Head: {F}", BC + "Moment z": f"Head: {F * at}",
        "Probes/Probes": "N: reaction y, Ground; M: reaction moment z, Ground"})
    found = values(summary) if status == 0 else {}
    held = summary["increments"][-1]["reactions"]["Ground"] if found else {}
    check("forces that a support and contact share are noted",
          near(found, {"N": 0, "M": 0}, 1e-6) and
          near(held, {"y": -F, "moment z": -F * (at + 3)}, 1e-6) and
          all(f"the probe '{probe}' is" in said for probe in "NM"),
          f"{found} {held} {said}")

    for more, reason in (
            ({BC + "Tied y": "Head: Q"}, "contradict each other"),
            ({BC + "Moment z": "Head: 1", BC + "Rotation z": "Head: 1"},
             "contradict each other"),
            ({BC + "Force y": "Head: 1", BC + "Displacement y": "Head: 1"},
             "contradict each other"),
            ({BC + "Moment z": "Sole: 1"}, "not in Boundary conditions/Rigid"),
            ({BC + "Moment x": "Head: 1"}, "the mesh is plane"),
            ({BC + "Rigid": "Sole: P"}, "is on a rigid boundary"),
            ({"Probes/Probes": "r: rotation z, Base"}, "no rigid boundary"),
            ({"Probes/Probes": "c: contact force y, Ground",
              BC + "Displacement y": "Ground: 0, Head: -0.01"},
             "supports hold all of it in this direction")):
        status, said, _ = run("refused", {**scene, **more})
        check(f"{more} is refused", status == 2 and reason in said, said[:300])


def block_in_space():
    """Nodes of the master hang, which the other process does not know by its
    own cells."""
    blocks = Volumes()
    blocks.block("A", (4, 4, 1), lambda r, s, t: (4 * r - 2, 4 * s - 2, t))
    blocks.block("B", (3, 2, 1),
                 lambda r, s, t: (2.3 * r - 1.2, 1.9 * s - 1, 1 + t))
    blocks.write("on_block")
    places = []
    for ranks in (1, 2):
        status, said, summary = run("on_block", {
            "Mesh/File": "on_block.msh",
            "Solids/Young's modulus": f"A: {2 * E}, B: {2 * E}",
            "Solids/Poisson's ratio": "A: 0.4, B: 0.3",
            "Solids/Kinematics": "small strain",
            BC + "Displacement x": "A_z0: 0", BC + "Displacement y": "A_z0: 0",
            BC + "Displacement z": "A_z0: 0", BC + "Rigid": "B_z1: B_001",
            BC + "Force x": "B_z1: -3", BC + "Force y": "B_z1: 3",
            BC + "Force z": "B_z1: -60", BC + "Moment x": "B_z1: -55",
            BC + "Moment y": "B_z1: 64", BC + "Moment z": "B_z1: -3",
            "Contact/Slave": "A_z1", "Contact/Master": "B_z0",
            "Contact/Friction coefficient": 0.4,
            "Contact/Discretization": "mortar",
            "Refinement/Levels": 1, "Refinement/Strategy": "adaptive",
            "Probes/Probes": "u: displacement z, B_000"}, ranks)
        places.append(values(summary)["u"] if status == 0 else math.nan)
    check("a block on a block refined adaptively, 1 and 2 processes",
          abs(places[1] / places[0] - 1) < 1e-6, f"{places} {said[-300:]}")


def half_beam():
    """Held at its plane of symmetry, turned about the normal of that at its
    end; and what the plane would not let it do."""
    for kinematics in ("small strain", "large displacement"):
        moments = {}
        for name, low in (("whole", -0.5), ("half", 0.)):
            beam = Volumes()
            beam.block("A", (6, 1 if name == "half" else 2, 2),
                       lambda r, s, t: (4 * r, low + (0.5 - low) * s, t - 0.5))
            beam.write(name)
            entries = {**SOLID, "Mesh/File": f"{name}.msh",
                       "Solids/Poisson's ratio": "A: 0.3",
                       "Solids/Kinematics": kinematics,
                       "Mesh/Points": "P: 4, 0.5, 0",
                       BC + "Displacement x": "A_x0: 0",
                       BC + "Displacement y": "A_x0: 0" + (
                           ", A_y0: 0" if name == "half" else ", A_x1: 0"),
                       BC + "Displacement z": "A_x0: 0",
                       BC + "Rigid": "A_x1: P", BC + "Rotation y": "A_x1: 0.1",
                       "Probes/Probes": "M: reaction moment y, A_x1"}
            status, said, summary = run(name, entries)
            check(f"{name} of a beam, {kinematics}", status == 0, said[-400:])
            moments[name] = values(summary)["M"] if status == 0 else math.nan
        check("half of it takes half of the moment",
              abs(2 * moments["half"] / moments["whole"] - 1) < 1e-6, moments)
    status, said, _ = run("refused", {**entries, BC + "Rotation x": "A_x1: 0.1"})
    check("the plane does not let it twist",
          status == 2 and "more ways than it has motions" in said, said[-300:])


columns()
turns()
arm()
half_beam()
punch()
block_in_space()
sys.exit(len(failures) > 0)
