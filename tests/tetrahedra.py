#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of tetrahedra of 4 and 10 nodes.

Proves that

- a distorted block under a uniform stress has it, and its displacements, to 1e-12:
  at degree 1 and 2, small and large displacement, on two processes, turned and held
  along normals, by tractions and by pressure;
- a quarter ring under pressure converges to the closed form with the orders of
  hexahedra, by named cylinders and by mid-side nodes, also where it is refined by
  levels, whose error is the one of the mesh refined at once;
- the same of an eighth of a thick sphere that gmsh makes of its geometry, nearly
  incompressible as well;
- a cantilever has the deflection of one of hexahedra, beside which it stands in the
  same scene; degree 2 is the default, and degree 1 is told to be too stiff;
- a boundary is rigid, bodies have a weight, and a place has its probes;
- what there is not is refused; so are cells that their curved sides turn inside out.

Usage: tetrahedra.py CONTACT PARAMETERS MESHES
"""

import itertools
import math
import pathlib
import subprocess
import sys

from block_scenes import check, failures, run, violations
from tetrahedra_scenes import Solid

E, NU = 1000., 0.3


def solved(what, name, entries, ranks=1):
    """The probes, of a run that converges and keeps the invariants."""
    bodies = entries.pop("bodies", "A").split()
    status, said, summary = run(name, {
        "Solids/Young's modulus": ", ".join(f"{b}: {E}" for b in bodies),
        "Solids/Poisson's ratio": ", ".join(f"{b}: {NU}" for b in bodies),
        "Solids/Kinematics": "small strain", **entries}, ranks)
    violated = violations(summary)
    check(f"{what}: converges, and no invariant is violated",
          status == 0 and not violated, said[:400] if status else violated)
    found = {p["name"]: p["value"] for p in summary.get("probes", [])}
    found["cells"] = summary["levels"][-1]["cells"]
    return found, said


def distorted(x, y, z):
    """Sides stay flat; the nodes within move."""
    bump = 0.3 * math.prod(math.sin(math.pi * c) for c in (x, y, z))
    return 2 * x + bump, y - bump, z + 0.5 * bump


def patch():
    """Uniaxial stress: u = s/E (x, -nu y, -nu z)."""
    stress, exact = 10., 10. / E
    mesh = Solid()
    mesh.block("A", (3, 2, 2), distorted)
    mesh.write("patch")
    # The corners of no face: the last of the distorted nodes within.
    inner = distorted(2 / 3, 0.5, 0.5)
    probes = ("ux: displacement x, P; uy: displacement y, P; "
              "s: stress xx, P; t: stress yy, P; Q: displacement x, Q")
    points = f"P: {', '.join(map(repr, inner))}; Q: 1.23, 0.4, 0.7"
    held = {f"Boundary conditions/Displacement {c}": f"A_{c}0: 0" for c in "xyz"}
    for degree, ranks, load in itertools.product(
            (1, 2), (1, 2), ("Traction x", "Pressure")):
        found, _ = solved(f"patch of degree {degree}, {ranks} ranks, {load}",
                          "patch", {
            **held, "Mesh/File": "patch.msh", "Element/Degree": degree,
            "Mesh/Points": points, "Probes/Probes": probes,
            "Solution/Newton tolerance": 1e-13,
            f"Boundary conditions/{load}":
                f"A_x1: {stress if load[0] == 'T' else -stress}"}, ranks)
        wanted = {"ux": exact * inner[0], "uy": -NU * exact * inner[1],
                  "s": stress, "Q": exact * 1.23}
        worst = max(abs(found[k] / v - 1) for k, v in wanted.items())
        check("the stress is uniform", worst < 1e-12 and
              abs(found["t"]) < 1e-12 * stress, (worst, found["t"]))
    turned = []
    for kinematics in ("small strain", "large displacement"):
        for rotation in ("0", "27, -40, 63"):
            found, _ = solved(f"patch, {kinematics}, turned by {rotation}",
                              "patch", {
                "Mesh/File": "patch.msh", "Mesh/Rotation": rotation,
                "Mesh/Points": points, "Solids/Kinematics": kinematics,
                "Solution/Newton tolerance": 1e-12,
                "Boundary conditions/Displacement normal":
                    "A_x0: 0, A_y0: 0, A_z0: 0, A_x1: 0.02",
                "Probes/Probes": "e: strain energy, A"})
            turned.append(found["e"])
    check("the energy", abs(turned[0] / (0.5 * E * 1e-4 * 2) - 1) < 1e-12 and
          abs(turned[2] / turned[0] - 1) < 0.05, turned)
    check("turned", abs(turned[1] / turned[0] - 1) +
          abs(turned[3] / turned[2] - 1) < 1e-11, turned)


A, B, P = 10., 20., 3.


def quarter(s, t, r):
    radius, angle = A + s * (B - A), math.pi / 2 * t
    return (radius * math.cos(angle), radius * math.sin(angle), 5 * r)


def ring(what, more, ranks=1):
    """The error of the displacement of the bore (Lame, plane strain)."""
    exact = P * A / E * (1 + NU) * (A * A * (1 - 2 * NU) + B * B) / (B * B - A * A)
    found, _ = solved(f"ring, {what}", "ring", {
        "Mesh/File": "ring.msh",
        "Boundary conditions/Displacement x": "A_y1: 0",
        "Boundary conditions/Displacement y": "A_y0: 0",
        "Boundary conditions/Displacement z": "A_z0: 0, A_z1: 0",
        "Boundary conditions/Pressure": f"A_x0: {P}",
        "Mesh/Points": f"O: {A}, 0, 0",
        "Probes/Probes": "u: displacement x, O; e: strain energy, A",
        **more}, ranks)
    # The work of the pressure on a bore of this height.
    work = 0.5 * P * exact * math.pi / 2 * A * 5
    return abs(found["u"] / exact - 1), abs(found["e"] / work - 1), found


def straighten(mesh, number, on_curves):
    """Put the mid-side nodes in the middle of their edges, but where the first
    coordinate is one of these."""
    for place, node in number.items():
        odd = [c % 2 for c in place]
        ends = [number.get(tuple(c + sign * o for c, o in zip(place, odd)))
                for sign in (-1, 1)]
        if any(odd) and place[0] not in on_curves and None not in ends:
            a, b = (mesh.nodes[n - 1] for n in ends)
            mesh.nodes[node - 1] = tuple((x + y) / 2 for x, y in zip(a, b))


def rings():
    cylinders = {"Mesh/Cylinders": f"A_x0: 0, 0, 0, 0, 0, 1, {A}; "
                                   f"A_x1: 0, 0, 0, 0, 0, 1, {B}"}
    nodes = {"Mesh/Mid-side nodes": "true"}
    errors = {}
    for kind in (10, 8):
        mesh = Solid()
        number = mesh.block("A", (2, 4, 1), quarter, kind)
        if kind == 10:
            straighten(mesh, number, on_curves=(0, 4))
        mesh.write("ring")
        for degree in (1, 2):
            errors[kind, degree] = [ring(f"{kind} nodes, degree {degree}, {n}", {
                **cylinders, "Element/Degree": degree,
                "Mesh/Refinements": n})[1] for n in (0, 1, 2 - degree // 2)]
        if kind == 10:
            named, found, levels, at_once, ranks = (
                ring(what, more, n)[2] for what, more, n in (
                    ("named", cylinders, 1), ("mid-side nodes", nodes, 1),
                    ("levels", {**cylinders, "Refinement/Levels": 1}, 1),
                    ("refined", {**cylinders, "Mesh/Refinements": 1}, 1),
                    ("ranks", {**cylinders, "Mesh/Refinements": 1}, 2)))
            check("mid-side nodes are on the cylinders",
                  abs(found["u"] / named["u"] - 1) < 1e-10, (found, named))
            check("by levels", abs(levels["u"] / at_once["u"] - 1) < 1e-8,
                  (levels, at_once))
            check("on two processes", abs(ranks["u"] / at_once["u"] - 1) < 1e-8,
                  (ranks, at_once))
    for degree in (1, 2):
        tetrahedra, hexahedra = errors[10, degree], errors[8, degree]
        check(f"orders of degree {degree}",
              tetrahedra[0] > 3**degree * tetrahedra[1] and
              tetrahedra[1] < 8 * hexahedra[1], (tetrahedra, hexahedra))


SPHERE = """SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 20, 0, Pi/2, Pi/2};
Sphere(2) = {0, 0, 0, 10, 0, Pi/2, Pi/2};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Physical Volume("A") = {3};
e = 1e-3;
Physical Surface("x") = Surface In BoundingBox{-e, -e, -e, e, 20+e, 20+e};
Physical Surface("y") = Surface In BoundingBox{-e, -e, -e, 20+e, e, 20+e};
Physical Surface("z") = Surface In BoundingBox{-e, -e, -e, 20+e, 20+e, e};
Physical Surface("bore") = {5};
Physical Surface("outside") = {1};
Mesh.CharacteristicLengthMin = SIZE;
Mesh.CharacteristicLengthMax = SIZE;
"""


def sphere():
    """Lame: u(a) = p a/(2 E (b^3 - a^3)) (2 (1 - 2 nu) a^3 + (1 + nu) b^3). The
    error of the energy falls with the number of cells to the power -2/3 times the
    order; of nearly incompressible bodies, with one pressure a cell, order 1 is
    certain."""
    def error(size, degree, nu):
        pathlib.Path("sphere.geo").write_text(SPHERE.replace("SIZE", str(size)))
        subprocess.run(["gmsh", "-3", "-order", "2", "-format", "msh41", "-v", "1",
                        "sphere.geo"], check=True)
        exact = P * A / (2 * E * (B**3 - A**3)) * (
            2 * (1 - 2 * nu) * A**3 + (1 + nu) * B**3)
        found, said = solved(f"sphere of gmsh, cells of {size} mm, degree {degree}, "
                             f"nu {nu}", "sphere", {
            "Mesh/File": "sphere.msh",
            "Mesh/Spheres": f"bore: 0, 0, 0, {A}; outside: 0, 0, 0, {B}",
            "Element/Degree": degree, "Solids/Poisson's ratio": f"A: {nu}",
            **{f"Boundary conditions/Displacement {c}": f"{c}: 0"
               for c in "xyz"},
            "Boundary conditions/Pressure": f"bore: {P}",
            "Probes/Probes": "e: strain energy, A"})
        check("degree 1 has a note", ("too stiff where" in said) == (degree == 1),
              said)
        return (abs(found["e"] / (math.pi / 4 * A * A * P * exact) - 1),
                found["cells"])
    fine = {}
    for degree, nu, order in ((1, 0.3, 1), (2, 0.3, 2), (2, 0.4999, 1)):
        (before, few), (after, many) = (error(size, degree, nu)
                                        for size in (4, 2))
        fine[degree, nu] = after
        found = 1.5 * math.log(before / after) / math.log(many / few)
        check(f"a thick sphere of degree {degree}, nu {nu}: order {order}",
              found > order - 0.15, (before, after, found))
    check("that of degree 2 does not lock", fine[2, 0.4999] < 2 * fine[2, 0.3],
          fine)


def cantilevers():
    """One of tetrahedra beside one of hexahedra, under their weight."""
    mesh = Solid()
    for body, kind, offset in (("A", 4, 0), ("B", 8, 5)):
        mesh.block(body, (8, 1, 2), lambda x, y, z: (10 * x, y + offset, z), kind)
    mesh.write("beams")
    entries = {
        "bodies": "A B", "Mesh/File": "beams.msh",
        "Mesh/Points": "P: 10, 0, 0; Q: 10, 5, 0; M: 4.4, 0.3, 0.6",
        "Boundary conditions/Body force z": "A: -0.01, B: -0.01",
        "Probes/Probes": "P: displacement z, P; Q: displacement z, Q; "
                         "M: stress xx, M; N: displacement z, M; "
                         "R: reaction z, A_x0"}
    entries["Boundary conditions/Body force z"] = "A: -0.01; B: -0.01"
    for c in "xyz":
        entries[f"Boundary conditions/Displacement {c}"] = "A_x0: 0, B_x0: 0"
    found, said = solved("cantilevers", "beams", dict(entries))
    check("degree 2 is the default, without a note",
          "too stiff where" not in said, said)
    both, _ = solved("cantilevers, degree 2", "beams",
                     {**entries, "Element/Degree": 2})
    check("it is the one of that degree", both == found, (both, found))
    check("as hexahedra", abs(found["P"] / found["Q"] - 1) < 0.02, found)
    check("the reaction is the weight", abs(found["R"] / 0.1 - 1) < 1e-9, found)
    coarse, said = solved("cantilevers, degree 1", "beams",
                          {**entries, "Element/Degree": 1})
    check("degree 1 is too stiff, and a note says so",
          coarse["P"] / found["P"] < 0.8 and "too stiff where" in said,
          (coarse, said))
    ends = {"P": (10, 0, 0), "C": (10, 1, 0), "D": (10, 1, 1), "M": (10, 0.5, 0.3)}
    rigid, _ = solved("a rigid end", "beams", {
        **entries, "Boundary conditions/Rigid": "A_x1: P",
        "Solids/Kinematics": "large displacement",
        "Mesh/Points": "; ".join(f"{p}: {', '.join(map(str, X))}"
                                 for p, X in ends.items()),
        "Probes/Probes": "; ".join(f"{p}{c}: displacement {c}, {p}"
                                   for p in ends for c in "xyz")})
    now = {p: [x + rigid[p + c] for x, c in zip(X, "xyz")]
           for p, X in ends.items()}
    stretch = [math.dist(now[p], now[q]) / math.dist(ends[p], ends[q]) - 1
               for p, q in itertools.combinations(ends, 2)]
    check("the end keeps its distances, and has moved",
          max(map(abs, stretch)) < 1e-9 and abs(rigid["Pz"]) > 1e-3,
          (stretch, rigid))


def refused():
    def refusal(what, words, more, ranks=1):
        entries = {"Mesh/File": "refused.msh",
                   "Boundary conditions/Displacement x": "A_x0: 0",
                   "Boundary conditions/Displacement y": "A_x0: 0",
                   "Boundary conditions/Displacement z": "A_x0: 0", **more}
        status, said, _ = run("refused", {
            "Solids/Young's modulus": "A: 1, B: 1",
            "Solids/Poisson's ratio": "A: 0, B: 0", **entries}, ranks)
        check(f"{what} is refused", status == 2 and words in said, said[:400])

    def box(offset):
        return lambda x, y, z: (x + offset, y, z)
    mesh = Solid()
    mesh.block("A", (1, 1, 1), box(0))
    mesh.block("B", (1, 1, 1), box(1))
    mesh.write("refused")
    refusal("adaptive refinement", "has tetrahedra",
            {"Refinement/Levels": 2, "Refinement/Strategy": "adaptive"})
    refusal("incompatible modes", "no incompatible modes of tetrahedra",
            {"Solids/Incompatible modes": "A", "Element/Degree": 1})
    for ranks in (1, 2):
        refusal("a nearly incompressible body of degree 1", "would lock",
                {"Solids/Poisson's ratio": "A: 0.3, B: 0.4999",
                 "Element/Degree": 1}, ranks)
    mesh = Solid()
    number = mesh.block("A", (1, 1, 1), box(0), 10)
    mesh.block("B", (1, 1, 1), box(2))
    mesh.nodes[number[1, 1, 0] - 1] = 0.5, 0.5, 0.9
    mesh.write("refused")
    for ranks in (1, 2):
        refusal("a cell turned inside out", "inside out",
                {"Mesh/Mid-side nodes": "true"}, ranks)


patch()
rings()
sphere()
cantilevers()
refused()
sys.exit(bool(failures))
