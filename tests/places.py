#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Probes and forces at places between nodes (Mesh/Points), run by the program.

Proves that, between nodes,

- displacements and stresses of linear fields are exact, in distorted
  quadrangles, triangles and hexahedra, of degrees 1 and 2, of rings, moved and
  turned, on two processes; those of quadratic fields at degree 2;
- the values are those of a node where a finer mesh has one, those of one
  process on two, also where nodes hang, and on boundaries that are round;
- the pressure of contact is the nodes', interpolated, on round sides too;
- a force is balanced by the supports, and the displacement at P by a force at Q
  is that at Q by the force at P (Maxwell and Betti);
- estimated effects are those of runs of their own;
- displacements and stresses in and on a ring are those of the closed form, and
  their estimated errors what they are off it;
- what no body holds, or two, is refused, and so are supports there.

Usage: places.py CONTACT PARAMETERS MESHES
"""

import math
import sys

from block_scenes import Mesh, box, check, failures, ring, rows, run
from volume_scenes import Volumes

E, NU = 1000., 0.3
LAME, MU = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (2 * (1 + NU))
SOLID = {"Solids/Young's modulus": f"A: {E}", "Solids/Poisson's ratio": f"A: {NU}",
         "Solids/Kinematics": "small strain"}
SIDES = {"left": "S", "right": "S", "top": "S", "bottom": "S"}


def why(status, said):
    return said[:300] if status != 0 else ""


def values(summary):
    return {p["name"]: p["value"] for p in summary.get("probes", [])}


def distorted(s, t):
    """Of 4 x 2, with inner nodes off their places."""
    off = 0.3 * math.sin(math.pi * s) * math.sin(math.pi * t)
    return 4 * s + off, 2 * t - off / 2


def meshes():
    mesh = Mesh()
    mesh.block("A", 4, 3, distorted, SIDES)
    mesh.write("quads")
    mesh.elements = [half for kind, tag, c in mesh.elements for half in (
        [(kind, tag, c)] if kind != 3 else
        [(2, tag, (c[0], c[1], c[2])), (2, tag, (c[0], c[2], c[3]))])]
    mesh.write("triangles")
    mesh = Mesh()
    mesh.block("A", 4, 3, box(0, 0, 4, 2), SIDES)
    mesh.write("straight")
    for n, name in ((1, "coarse"), (2, "fine")):
        mesh = Mesh()
        mesh.block("A", 4 * n, 3 * n, box(0, 0, 4, 2), {
            **SIDES, "left": "L", "right": "R", "bottom": "B", "top": "T"})
        mesh.write(name)
    block = Volumes()
    block.block("A", (3, 2, 2), lambda r, s, t: (
        *distorted(r, s), 2 * t + 0.2 * math.sin(math.pi * s) * t * (1 - t)),
        {f"{d}{i}": "S" for d in "xyz" for i in (0, 1)}, {})
    block.write("hexahedra")


def linear_field():
    """u = G X t, with sigma = lambda tr(e) 1 + 2 mu e; of rings (a r, b z)."""
    place = (1.234, 0.567, 0.891)
    grad = ((1e-3, 2e-3, 5e-4), (-1.5e-3, 5e-4, 1e-3), (7e-4, -3e-4, -4e-4))
    for what, more, ranks in (
            ("quadrangles", {}, 1), ("quadrangles", {}, 2),
            ("degree 2, turned", {"Element/Degree": 2, "Mesh/Rotation": 30}, 1),
            ("triangles", {"Mesh/File": "triangles.msh"}, 2),
            ("triangles, degree 2", {"Mesh/File": "triangles.msh",
                                     "Element/Degree": 2}, 1),
            ("rings", {"Solids/Symmetry": "axisymmetric",
                       "Mesh/Move": "A: 1, 0"}, 1),
            ("space", {}, 1), ("space, degree 2", {"Element/Degree": 2}, 1)):
        dim = 3 if "space" in what else 2
        g = [row[:dim] for row in grad[:dim]]
        if what == "rings":
            g = [[1e-3, 0], [0, 5e-4]]
        X = (place[0] + (what == "rings"), *place[1:])
        if "turned" in what:
            cos, sin = math.cos(math.pi / 6), math.sin(math.pi / 6)
            X = cos * X[0] - sin * X[1], sin * X[0] + cos * X[1]
        group = "A_S" if dim == 3 else "S"
        scene = {**SOLID, "Mesh/File": "quads.msh", **more, "Mesh/Points":
                 "P: " + ", ".join(map(str, place[:dim]))}
        if dim == 3:
            scene["Mesh/File"] = "hexahedra.msh"
        for c in range(dim):
            scene["Boundary conditions/Displacement formula " + "xyz"[c]] = (
                f"{group}: t*(" + " + ".join(
                    f"({g[c][d]})*{'xyz'[d]}" for d in range(dim)) + ")")
        stresses = ["xx", "yy", "zz", "xy"] + (["xz", "yz"] if dim == 3 else [])
        scene["Probes/Probes"] = "; ".join(
            [f"u{d}: displacement {d}, P" for d in "xyz"[:dim]] +
            [f"{s}: stress {s}, P" for s in stresses])
        status, said, summary = run("linear", scene, ranks)
        found = values(summary) if status == 0 else {}
        trace = sum(g[c][c] for c in range(dim)) + (
            g[0][0] if what == "rings" else 0)
        wrong = 9. if not found else 0.
        for name, value in found.items():
            if name[0] == "u":
                c = "xyz".index(name[1])
                exact, size = sum(a * b for a, b in zip(g[c], X)), 1e-3
            else:
                a, b = ("xyz".index(d) for d in name)
                strain = ((g[a][b] + g[b][a]) / 2 if max(a, b) < dim else
                          g[0][0] if what == "rings" else 0)
                exact = LAME * trace * (a == b) + 2 * MU * strain
                size = 1e-3 * E
            wrong = max(wrong, abs(value - exact) / size)
        check(f"linear field, {what}, {ranks} processes", wrong < 1e-11,
              f"{wrong:.1e} {why(status, said)}")


def quadratic_field():
    """u = (c x^2, 0), held by a body force of -(lambda + 2 mu) 2 c."""
    c, x, y = 1e-3, 1.7, 0.41
    status, said, summary = run("quadratic", {
        **SOLID, "Mesh/File": "straight.msh", "Element/Degree": 2,
        "Mesh/Points": f"P: {x}, {y}; Q: 0.5, {y}",
        "Boundary conditions/Displacement formula x": f"S: {c}*x^2*t",
        "Boundary conditions/Displacement y": "S: 0",
        "Boundary conditions/Body force x": f"A: {-(LAME + 2 * MU) * 2 * c}",
        "Probes/Probes": "u: displacement x, P; xx: stress xx, P; "
                         "yy: stress yy, P; difference: displacement x, P, Q"})
    found = values(summary) if status == 0 else {}
    exact = {"u": c * x * x, "xx": (LAME + 2 * MU) * 2 * c * x,
             "yy": LAME * 2 * c * x, "difference": c * (x * x - 0.25)}
    wrong = max([abs(found.get(name, 9) / value - 1)
                 for name, value in exact.items()])
    check("quadratic field at degree 2", wrong < 1e-11,
          f"{wrong:.1e} {why(status, said)}")


BENT = {**SOLID, "Boundary conditions/Displacement formula x":
            "L: -0.01*t*y^3; R: 0.01*t*sin(y)",
        "Boundary conditions/Displacement y": "L: 0, R: 0"}
PROBES = "; ".join(f"{name}: {name}, P" for name in (
    "displacement x", "displacement y", "stress xx", "stress yy", "von Mises"))


def nodes_of_finer_meshes():
    """The middle of a cell, and of a side."""
    for place, degree in (("1.5, 1", 1), ("2, 1", 2)):
        found = []
        for mesh in ({"Mesh/File": "coarse.msh", "Mesh/Refinements": 1},
                     {"Mesh/File": "fine.msh"}):
            status, said, summary = run("finer", {
                **BENT, **mesh, "Element/Degree": degree,
                "Mesh/Points": f"P: {place}", "Probes/Probes": PROBES})
            found.append(values(summary) if status == 0 else {})
        a, b = found
        check(f"a node of a finer mesh at ({place}), degree {degree}",
              len(a) == 5 and all(abs(a[k] / b[k] - 1) < 1e-10 for k in a),
              f"{a} {b} {why(status, said)}")


def processes():
    """Where nodes hang, with a force between nodes too."""
    block = Volumes()
    block.block("A", (3, 2, 2), lambda r, s, t: (4 * r, 2 * s, 2 * t),
                {"x0": "L"}, {})
    block.write("bar")
    space = {**SOLID, "Mesh/File": "bar.msh", "Boundary conditions/Force z": "Q: -1",
             "Mesh/Points": "P: 1.234, 0.71, 1.63; Q: 3.9, 1.2, 0.7"}
    for c in "xyz":
        space["Boundary conditions/Displacement " + c] = "A_L: 0"
    plane = {**BENT, "Mesh/File": "coarse.msh", "Mesh/Points": "P: 3.777, 1.93"}
    for what, scene in (("in 2-D", plane), ("in 3-D", space)):
        found = []
        for ranks in (1, 2):
            status, said, summary = run("ranks", {
                **scene, "Refinement/Levels": 2, "Probes/Probes": PROBES,
                "Refinement/Strategy": "adaptive"}, ranks)
            found.append(values(summary) if status == 0 else {})
        a, b = found
        check(f"two processes, {what}", len(a) == 5 and all(
            abs(a[k] / b[k] - 1) < 1e-8 for k in a), f"{a} {b} {why(status, said)}")


def forces():
    """Maxwell and Betti: the displacement at P along y by a force at Q along x
    is that at Q along x by the same force at P along y."""
    for what, more, ranks in (
            ("", {}, 1), (", degree 2", {"Element/Degree": 2}, 1),
            (", two processes", {"Refinement/Levels": 3,
                                 "Refinement/Strategy": "adaptive"}, 2)):
        scene = {**SOLID, "Mesh/File": "coarse.msh", **more,
                 "Mesh/Points": "P: 3.21, 1.77; Q: 2.345, 0.678",
                 "Boundary conditions/Displacement x": "L: 0",
                 "Boundary conditions/Displacement y": "L: 0",
                 "Probes/Probes": "P: displacement y, P; Q: displacement x, Q; "
                                  "x: reaction x, L; y: reaction y, L"}
        found = []
        for force in ({"Boundary conditions/Force x": "Q: 2"},
                      {"Boundary conditions/Force y": "P: 2"}):
            status, said, summary = run("force", {**scene, **force}, ranks)
            found.append(values(summary) if status == 0 else
                         dict.fromkeys("PQxy", 9))
        x, y = found
        check("forces between nodes" + what,
              max(abs(x["x"] + 2), abs(y["y"] + 2), abs(x["y"]),
                  abs(y["x"])) < 1e-9 and ("two" in what or
                                           abs(x["P"] / y["Q"] - 1) < 1e-9),
              f"{found} {why(status, said)}")


def effects():
    """The change by large displacement, estimated and by a run of its own."""
    scene = {**SOLID, "Mesh/File": "coarse.msh",
             "Mesh/Points": "P: 2.2, 1.3; Q: 3.77, 1.9",
             "Boundary conditions/Displacement x": "L: 0",
             "Boundary conditions/Displacement y": "L: 0",
             "Boundary conditions/Force y": "Q: -1",
             "Probes/Probes": "y: displacement y, P; xx: stress xx, P"}
    status, said, base = run("effects", {**scene, "Solution/Estimate effects": "true"})
    _, _, large = run("effects", {**scene,
                                  "Solids/Kinematics": "large displacement"})
    small, other = values(base), values(large)
    changes = [e["changes"] for e in base.get("estimated_effects", [])
               if e["effect"] == "large displacement"]
    check("an estimated effect", len(changes) == 1 and all(
        abs(changes[0][k] / (other[k] - small[k]) - 1) < 0.05 for k in small),
        f"{changes} {small} {other} {why(status, said)}")


def shared_nodes():
    """Two bodies that share nodes: a place on their interface is one point."""
    mesh = Mesh()
    mesh.block("A", 4, 2, box(0, 0, 4, 1), {"bottom": "B"})
    mesh.block("C", 4, 2, box(0, 1, 4, 2), {"top": "T"})
    mesh.merge()
    mesh.write("merged")
    status, said, summary = run("merged", {
        "Mesh/File": "merged.msh", "Solids/Young's modulus": "A: 1000, C: 3000",
        "Solids/Poisson's ratio": "A: 0.3, C: 0.3",
        "Boundary conditions/Displacement x": "B: 0, T: 0.1",
        "Boundary conditions/Displacement y": "B: 0, T: 0",
        "Mesh/Points": "P: 1.3, 1; Q in C: 1.3, 1",
        "Probes/Probes": "P: stress xy, P; Q: stress xy, Q; "
                         "u: displacement x, P, Q"})
    found = values(summary) if status == 0 else {"P": 0, "Q": 1, "u": 1}
    check("bodies that share nodes", found["P"] == found["Q"] and
          found["u"] == 0, f"{found} {why(status, said)}")


def contact():
    """A block on another one, whose nodes are elsewhere."""
    mesh = Mesh()
    mesh.block("A", 6, 3, box(-6, -5, 6, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 5, 2, box(-3, 0, 3, 4), {"bottom": "Sole", "top": "Head"})
    mesh.write("contact")
    scene = {"Mesh/File": "contact.msh",
             "Solids/Young's modulus": "A: 1000, B: 3000",
             "Solids/Poisson's ratio": "A: 0.3, B: 0.2",
             "Boundary conditions/Displacement x": "Base: 0, Head: 0.02",
             "Boundary conditions/Displacement y": "Base: 0, Head: -0.05",
             "Contact/Slave": "Sole", "Contact/Master": "Ground",
             "Contact/Friction coefficient": 0.3,
             "Output/Profile": "true", "Output/Nodes": "true",
             "Mesh/Points": "P in B: 0.2, 0; Q in A: 0.2, 0; R in B: 0.6, 0",
             "Probes/Probes": "p: pressure, P; q: shear, P; "
                              "B: displacement y, P; A: displacement y, Q; "
                              "xx: stress xx, P; node: pressure, R"}
    of_ranks = []
    for ranks in (1, 2):
        status, said, summary = run("contact", scene, ranks)
        if status != 0:
            check("contact", False, said[:300])
            return
        found = values(summary)
        of_ranks.append(found)
        profile = {round(r["X_mm"], 6): r for r in rows("contact")
                   if r["surface"].startswith("slave")}
        nodes = {(n["body"], round(n["X_mm"], 6)): n for n in rows(
            "contact", "nodes.csv") if n["Y_mm"] == 0}

        def between(at, key, a, b):
            s = (0.2 - a[0]) / (b[0] - a[0])
            return (1 - s) * at[a[1]][key] + s * at[b[1]][key]
        slave = (-0.6, -0.6), (0.6, 0.6)
        exact = {"p": between(profile, "pressure_MPa", *slave),
                 "q": between(profile, "shear_MPa", *slave),
                 "B": between(nodes, "displacement_y_mm", (-0.6, ("B", -0.6)),
                              (0.6, ("B", 0.6))),
                 "A": between(nodes, "displacement_y_mm", (0, ("A", 0)),
                              (2, ("A", 2))),
                 "node": profile[0.6]["pressure_MPa"]}
        check(f"contact between nodes, {ranks} processes", all(
            abs(found[k] / value - 1) < 1e-9 for k, value in exact.items()),
            f"{found} {exact}")
    one, two = of_ranks  # as far as Newton's method goes
    check("contact on two processes", all(
        abs(one[k] / two[k] - 1) < 1e-7 for k in one), f"{one} {two}")

    base = {**scene, "Probes/Probes": "P: pressure, P"}
    for what, more, reason in (
            ("an interface", {"Mesh/Points": "P: 0.2, 0"}, "name the body"),
            ("no body", {"Mesh/Points": "P: 5, 2"}, "at (3, 2) mm, 2 mm away"),
            ("another body", {"Mesh/Points": "P in B: 0.2, -1"}, "no body is at"),
            ("the master", {"Mesh/Points": "P in A: 0.2, 0"}, "on the master"),
            ("two of a name", {"Mesh/Points": "P in A: 0.2, 0; P in B: 0.2, 0"},
             "named twice"),
            ("a support", {"Boundary conditions/Displacement x":
                           "P: 0, Head: 0.02"}, "lies between nodes"),
            ("a tie", {"Boundary conditions/Displacement x": "Base: 0",
                       "Boundary conditions/Tied x": "Head: P"},
             "lies between nodes"),
            ("a normal", {"Boundary conditions/Displacement normal": "P: 0"},
             "has no normal"),
            ("an excluded point", {"Contact/Excluded points": "P"},
             "lies between nodes")):
        status, said, _ = run("refused", {**base, **more})
        check(f"refused: {what}", status == 2 and reason in said, said[:300])


def lame():
    """A ring under inner pressure, at places all over it and on its circles."""
    a, b, p = 20., 50., 10.
    mesh = Mesh()
    mesh.block("A", 16, 4, ring(a, b), {"bottom": "Inner", "top": "Outer"},
               closed=True)
    mesh.write("ring")
    scene = {**SOLID, "Mesh/File": "ring.msh",
             "Mesh/Arcs": f"Inner: 0, 0, {a}; Outer: 0, 0, {b}",
             "Boundary conditions/Pressure": f"Inner: {p}",
             "Boundary conditions/Displacement x": "N: 0",
             "Boundary conditions/Displacement y": "E: 0, W: 0",
             "Refinement/Levels": 2, "Probes/Errors": "dual weighted residuals"}

    def entries(polar):
        places = [(f"P{k}", (r * math.cos(angle), r * math.sin(angle)))
                  for k, (r, angle) in enumerate(polar)]
        places += [("N", (0, a)), ("E", (a, 0)), ("W", (-a, 0))]
        return {**scene, "Mesh/Points": "; ".join(
            f"{name}: {x!r}, {y!r}" for name, (x, y) in places),
                "Probes/Probes": "; ".join(
            f"x{k}: displacement x, P{k}; y{k}: displacement y, P{k}; "
            f"v{k}: von Mises, P{k}" for k in range(len(polar)))}

    def closed_form(r, angle):
        factor = p * a * a / (b * b - a * a)
        u = (1 + NU) / E * factor * ((1 - 2 * NU) * r + b * b / r)
        rr, tt = (factor * (1 - sign * b * b / r / r) for sign in (1, -1))
        zz = NU * (rr + tt)
        return {"x": u * math.cos(angle), "y": u * math.sin(angle),
                "v": math.sqrt(((rr - tt)**2 + (tt - zz)**2 + (zz - rr)**2) / 2)}
    golden = (math.sqrt(5) - 1) / 2  # places without a pattern
    polar = [(r, 2 * math.pi * golden * (k + 1)) for k, r in enumerate(
        [a, b, a, b] + [22 + 26 * (k * golden % 1) for k in range(12)])]
    for degree, displacement, stress in ((1, 5e-3, 5e-2), (2, 1e-4, 1e-2)):
        status, said, summary = run("lame", {
            **entries(polar), "Element/Degree": degree})
        if status != 0:
            check(f"a ring of degree {degree}", False, said[:300])
            continue
        last = summary["levels"][-1]
        for kind in "xyv":
            exact = [closed_form(*place)[kind] for place in polar]
            of_kind = [f"{kind}{k}" for k in range(len(polar))]
            errors = [value - last["probes"][name]
                      for name, value in zip(of_kind, exact)]
            size, error, wrong = (math.hypot(*v) for v in (exact, errors, [
                e - last["estimated_errors"][name]
                for name, e in zip(of_kind, errors)]))
            check(f"a ring of degree {degree}, {kind}", error / size < (
                stress if kind == "v" else displacement),
                  f"error {error / size:.1e}")
            check("  the estimates of its errors", wrong < 0.3 * error,
                  f"off by {wrong / error:.2f} of them")
    for r in (18.5, 51.5):
        status, said, _ = run("lame", entries([(r, 0.27)]))
        check(f"off the ring, r = {r}", status == 2 and
              "no body is at" in said, said[:300])


def press_fit():
    """A ring in another one: the pressure is the same all around, on the round
    and on the hollow side, whose polygons are inside the circle."""
    mesh = Mesh()
    for body, r0, r1 in (("A", 20., 50.), ("B", 50., 80.)):
        mesh.block(body, 16, 3, ring(r0, r1), {
            "bottom": "Inner" + body, "top": "Outer" + body}, closed=True)
    mesh.write("press_fit")
    place = f"{50 * math.cos(0.27)!r}, {50 * math.sin(0.27)!r}"
    fixed = {"A": 20, "B": 80}
    scene = {"Mesh/File": "press_fit.msh", "Mesh/Arcs":
             "InnerA: 0, 0, 20; OuterA: 0, 0, 50; InnerB: 0, 0, 50; "
             "OuterB: 0, 0, 80",
             "Solids/Young's modulus": "A: 1000, B: 1000",
             "Solids/Poisson's ratio": "A: 0.3, B: 0.3",
             "Solids/Kinematics": "small strain", "Contact/Interference": "0.1",
             "Boundary conditions/Displacement x": "NA: 0, NB: 0",
             "Boundary conditions/Displacement y": "EA: 0, WA: 0, EB: 0, WB: 0"}
    for body, slave, master in (("A", "OuterA", "InnerB"),
                                ("B", "InnerB", "OuterA")):
        status, said, summary = run("press_fit", {
            **scene, "Contact/Slave": slave, "Contact/Master": master,
            "Probes/Probes": "P: pressure, P; N: pressure, N",
            "Mesh/Points": f"P in {body}: {place}; N in {body}: 0, 50; " +
            "; ".join(f"N{b}: 0, {r}; E{b}: {r}, 0; W{b}: {-r}, 0"
                      for b, r in fixed.items())})
        found = values(summary) if status == 0 else {"P": 0, "N": 1}
        check(f"pressure between nodes of a circle, slave {slave}",
              found["N"] > 0 and abs(found["P"] / found["N"] - 1) < 1e-6,
              f"{found} {why(status, said)}")


meshes()
linear_field()
quadratic_field()
nodes_of_finer_meshes()
processes()
forces()
effects()
shared_nodes()
contact()
press_fit()
lame()
sys.exit(len(failures) > 0)
