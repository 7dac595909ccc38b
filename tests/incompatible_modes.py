#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Linear quadrangles and hexahedra that bend, by incompatible modes.

Proves that

- a beam of distorted quadrangles (two over its height, sides that lean by 11
  degrees to and fro), and one of hexahedra, bend as the closed form within 2 %,
  with their stress, which they are far too stiff for without; on two processes,
  and with hanging nodes;
- the slender beam of R. H. MacNeal and R. L. Harder (Finite Elements in Analysis
  and Design 1, 1985, 3-20; six cells) has the deflection known of incompatible
  modes: 0.993, of parallelograms 0.632 and of trapezoids 0.052, which lock;
- so they do far beyond small displacements, and as thin plates of revolution;
- the pressure between two blocks is uniform, whose nodes do not match;
- a note tells that the beam is too stiff without, and by which part of its
  energy, and there is none with them or at degree 2;
- bodies without such modes are refused.

Usage: incompatible_modes.py CONTACT PARAMETERS MESHES
"""

import math
import sys

from block_scenes import Mesh, box, check, failures, run
from volume_scenes import Volumes

E, NU, L = 1000., 0.3, 10.
SOLID = {"Solids/Young's modulus": f"A: {E}",
         "Solids/Poisson's ratio": f"A: {NU}",
         "Solids/Kinematics": "small strain"}
MODES = {"Solids/Incompatible modes": "A"}


def values(summary):
    return {p["name"]: p["value"] for p in summary.get("probes", [])}


def beam(nx, ny, slope):
    """From 0 to L, of height 1; the sides of cells lean to and fro."""
    def chart(s, t):
        i = round(s * nx)
        lean = slope * (-1)**i * (0 < i < nx)
        return (L * s + lean * (t - 0.5),
                t - 0.5 + slope * t * (1 - t) * (t - 0.5) * math.sin(5 * i))
    return chart


def bent(name, more=None, ranks=1):
    """By the moment M = E'/12 * 1e-3, of the curvature 1e-3: u_y = -1e-3 L^2/2
    at the end of the middle line, sigma_xx = -E' * 1e-3 * y."""
    modulus = E / (1 - NU**2)
    status, said, summary = run(name, {
        **SOLID, "Mesh/File": "beam.msh",
        "Mesh/Points": f"O: 0, 0; tip: {L}, 0; low: 0, -0.5",
        "Boundary conditions/Displacement x": "L: 0",
        "Boundary conditions/Displacement y": "O: 0",
        "Boundary conditions/Traction x": f"R: {1e-3 * modulus}*y",
        "Probes/Probes": "u: displacement y, tip; s: stress xx, low",
        **(more or {})}, ranks)
    found = values(summary)
    check(f"{name}: converged", status == 0, said[:300])
    check("it says that it is too stiff, or is not",
          ("too stiff in bending" in said) == (more is None), said)
    return (found.get("u", 0) / (-1e-3 * L * L / 2),
            found.get("s", 0) / (-0.5e-3 * modulus))


def plane_beams():
    mesh = Mesh()
    mesh.block("A", 20, 2, beam(20, 2, 0.2), {"left": "L", "right": "R"})
    mesh.write("beam")
    stiff, _ = bent("stiff")
    check("without modes it is too stiff", stiff < 0.87, stiff)
    bent("quadratic", {"Element/Degree": 2})
    u, s = bent("bends", MODES)
    check("a beam of distorted quadrangles bends", abs(u - 1) < 0.02, u)
    check("with its stress", abs(s - 1) < 0.02, s)
    u_2, s_2 = bent("ranks", MODES, 2)
    check("on two processes", abs(u_2 - u) + abs(s_2 - s) < 1e-9, u_2 - u)
    u, s = bent("hanging", {**MODES, "Refinement/Levels": 3,
                            "Refinement/Strategy": "adaptive"})
    check("with hanging nodes", abs(u - 1) < 0.005 and abs(s - 1) < 0.01, (u, s))

    def tip(name, more):
        status, said, summary = run(name, {
            **SOLID, "Mesh/File": "beam.msh",
            "Solids/Kinematics": "large displacement",
            "Boundary conditions/Displacement x": "L: 0",
            "Boundary conditions/Displacement y": "L: 0",
            "Boundary conditions/Resultant force y": "R: -2",
            "Mesh/Points": f"tip: {L}, 0", "Solution/Increments": 4,
            "Probes/Probes": "x: displacement x, tip; y: displacement y, tip",
            **more})
        check(f"{name}: converged", status == 0, said[:300])
        return values(summary)
    best = tip("large2", {"Element/Degree": 2, "Mesh/Refinements": 1})
    found = tip("large", {**MODES, "Mesh/Refinements": 1})
    check("far beyond small displacements",
          all(abs(found[c] / best[c] - 1) < 0.01 for c in best), (found, best))


def slender():
    """6 x 0.2, by a force at the end; of the beam of Timoshenko."""
    height, force = 0.2, 1e-3
    exact = force * (12 * 6**3 / (3 * height**3) * (1 - NU**2) +
                     6 * 2.4 * (1 + NU) / height) / E
    for what, lean, known in (("rectangles", lambda i: 0, 0.993),
                              ("parallelograms", lambda i: 0.2, 0.632),
                              ("trapezoids", lambda i: 0.2 * (-1)**i, 0.052)):
        mesh = Mesh()
        mesh.block("A", 6, 1, lambda s, t: (
            6 * s + lean(round(6 * s)) * (0 < s < 1) * (t - 0.5), height * t),
            {"left": "L", "right": "R", "corner": "O"})
        mesh.write("slender")
        status, said, summary = run("slender", {
            **SOLID, **MODES, "Mesh/File": "slender.msh",
            "Mesh/Points": "tip: 6, 0",
            "Boundary conditions/Displacement x": "L: 0",
            "Boundary conditions/Displacement y": "L: 0",
            "Boundary conditions/Resultant force y": f"R: {force}",
            "Probes/Probes": "u: displacement y, tip"})
        found = values(summary).get("u", 0) / exact
        check(f"MacNeal and Harder's beam of {what}",
              status == 0 and abs(found - known) < 1e-3, f"{found} {said[:300]}")


def plates():
    """Simply supported, under uniform pressure; by degree 2."""
    mesh = Mesh()
    mesh.block("A", 20, 2, beam(20, 2, 0.2), {"left": "L", "right": "R",
                                              "top": "T"})
    mesh.write("plate")
    found = []
    for more in ({"Element/Degree": 2, "Mesh/Refinements": 1}, MODES, {}):
        status, said, summary = run("plate", {
            **SOLID, "Mesh/File": "plate.msh",
            "Solids/Symmetry": "axisymmetric",
            "Mesh/Points": f"O: 0, 0; rim: {L}, 0",
            "Boundary conditions/Displacement y": "rim: 0",
            "Boundary conditions/Pressure": "T: 1e-3",
            "Probes/Probes": "u: displacement y, O", **more})
        check("plate: converged", status == 0, said[:300])
        found.append(values(summary).get("u", 0))
    best, modes, stiff = found
    check("a plate of revolution bends", abs(modes / best - 1) < 0.02 and
          stiff / best < 0.93, (modes / best, stiff / best))


def volumes():
    """The beam again, free across: the modulus is E."""
    mesh = Volumes()
    plane = beam(20, 2, 0.1)
    mesh.block("A", (20, 2, 2), lambda r, s, t: (
        *plane(r, s), t - 0.5 + 0.3 * t * (1 - t) * (t - 0.5) * math.cos(70 * r)))
    mesh.write("beam_space")
    found = []
    for more in (MODES, {}):
        status, said, summary = run("space", {
            **SOLID, "Mesh/File": "beam_space.msh",
            "Mesh/Points": f"O: 0, 0, 0; tip: {L}, 0, 0; side: 0, 0, 0.5",
            "Boundary conditions/Displacement x": "A_x0: 0",
            "Boundary conditions/Displacement y": "O: 0, side: 0",
            "Boundary conditions/Displacement z": "O: 0",
            "Boundary conditions/Traction x": f"A_x1: {1e-3 * E}*y",
            "Probes/Probes": "u: displacement y, tip", **more})
        check("space: converged", status == 0, said[:300])
        found.append(values(summary).get("u", 0) / (-1e-3 * L * L / 2))
    check("a beam of hexahedra bends", abs(found[0] - 1) < 0.02 and
          found[1] < 0.88, found)


def pressed():
    mesh = Mesh()

    def bumpy(x0, y0):
        return lambda s, t: (x0 + 2 * s + 0.4 * s * (1 - s) * math.sin(3 * t),
                             y0 + t + 0.3 * t * (1 - t) * math.sin(4 * s))
    mesh.block("A", 4, 3, bumpy(0, 0), {"top": "Sl", "bottom": "B",
                                        "left": "L", "right": "L"})
    mesh.block("C", 3, 2, bumpy(0, 1), {"bottom": "Ma", "top": "T",
                                        "left": "L", "right": "L"})
    mesh.write("pressed")
    for kinematics in ("small strain", "large displacement"):
        status, said, summary = run("pressed", {
            "Mesh/File": "pressed.msh",
            "Solids/Young's modulus": f"A: {E}, C: {E}",
            "Solids/Poisson's ratio": "A: 0, C: 0",
            "Solids/Kinematics": kinematics,
            "Solids/Incompatible modes": "A, C",
            "Mesh/Points": "a: 0, 0; c: 0, 2",
            "Boundary conditions/Displacement y": "B: 0",
            "Boundary conditions/Displacement x": "B: 0, T: 0",
            "Boundary conditions/Pressure": "T: 10",
            "Contact/Slave": "Sl", "Contact/Master": "Ma",
            "Probes/Probes": "a: stress yy, a; c: stress yy, c"})
        found = values(summary)
        # P = F S = -10 is the stress by undeformed area, and no side moves.
        worst = max((abs(s + 10) for s in found.values()), default=9)
        check(f"uniform pressure between blocks, {kinematics}",
              status == 0 and worst < 1e-9, (found, said[:300]))


def refused():
    mesh = Mesh()
    mesh.block("A", 2, 2, box(0, 0, 2, 1), {"left": "L"})
    mesh.nodes += [(2., 2.)]
    mesh.add(2, "A", (9, len(mesh.nodes), 8))
    mesh.elements[-1] = (2, *mesh.elements[-1][1:])
    mesh.write("triangle")
    mesh = Mesh()
    mesh.block("A", 2, 2, box(0, 0, 2, 1), {"left": "L"})
    mesh.write("quads")
    for more, reason in (
            ({"Element/Degree": 2}, "bend without"),
            ({"Mesh/File": "triangle.msh"}, "triangles"),
            ({"Solids/Dilatation": "B-bar"}, "no B-bar"),
            ({"Solids/Incompatible modes": "Z"}, "no body 'Z'"),
            ({"Solids/Material": "A: elastic-plastic",
              "Solids/Yield stress": "A: 1"}, "elastic-plastic 'A'")):
        status, said, _ = run("refused", {
            **SOLID, **MODES, "Mesh/File": "quads.msh",
            "Boundary conditions/Displacement x": "L: 0",
            "Boundary conditions/Displacement y": "L: 0", **more})
        check(f"refused: {reason}", status == 2 and reason in said, said[:300])


plane_beams()
slender()
plates()
volumes()
pressed()
refused()
sys.exit(bool(failures))
