#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thermal strains, run by the program.

Proves that free bodies swell without stress, held ones have Hooke's stress, in
plane strain, as rings, in 3-D, in large displacement, neo-Hookean (nearly
incompressible as well) and yielding;
a ring that shrinks on a disc has the pressure of a press fit; a strip of two
bodies bends as Timoshenko's; energies balance, on two processes and restarted.

Usage: thermal.py CONTACT PARAMETERS MESHES
"""

import sys

from block_scenes import Mesh, box, check, failures, run
from volume_scenes import Volumes

E, NU, e = 1000., 0.3, 0.01
SOLID = {"Solids/Young's modulus": f"A: {E}",
         "Solids/Poisson's ratio": f"A: {NU}", "Solids/Thermal strain":
         f"A: {e}*t", "Solution/Increments": 2}
BC = "Boundary conditions/"


def values(summary):
    return {p["name"]: p["value"] for p in summary["probes"]}


def compare(what, scene, expected, tolerance=1e-9, ranks=1):
    status, said, summary = run(what.split(",")[0].replace(" ", "_"), scene,
                                ranks)
    found = values(summary) if status == 0 else {}
    check(what + f", {ranks} processes" * (ranks > 1), bool(found) and all(
        abs(found[k] - v) <= tolerance * max(abs(v), e)
        for k, v in expected.items()), f"{found} {expected} {said[:300]}")


def bars():
    mesh = Mesh()
    mesh.block("A", 3, 2, box(0, 0, 3, 2), {
        "bottom": "Bottom", "top": "Top", "left": "Left", "right": "Right",
        "corner": "C"})
    mesh.write("bar")
    block = Volumes()
    block.block("A", (3, 2, 2), lambda r, s, t: (3 * r, 2 * s, t))
    block.write("bar_space")
    plane = {**SOLID, "Mesh/File": "bar.msh", "Mesh/Points": "P: 3, 2",
             "Solids/Kinematics": "small strain",
             BC + "Displacement x": "Left: 0", BC + "Displacement y": "Bottom: 0",
             "Probes/Probes": "x: displacement x, P; y: displacement y, P;"
             " xx: stress xx, C; yy: stress yy, C; zz: stress zz, C"}
    held = {**plane, BC + "Displacement x": "Left: 0, Right: 0"}
    # Plane strain holds the thickness: E_x = (1 + nu) e.
    free = {"x": 3 * (1 + NU) * e, "y": 2 * (1 + NU) * e, "xx": 0, "yy": 0,
            "zz": -E * e}
    sigma = -E * e / (1 - NU)
    clamped = {"x": 0, "xx": sigma, "yy": 0, "zz": sigma,
               "y": 2 * (e - 2 * NU * sigma / E)}
    for degree in (1, 2):
        compare(f"free bar, degree {degree}",
                {**plane, "Element/Degree": degree}, free)
        compare(f"clamped bar, degree {degree}",
                {**held, "Element/Degree": degree}, clamped)
    compare("clamped bar", held, clamped, ranks=2)
    compare("clamped bar, B-bar", {**held, "Solids/Dilatation": "B-bar"},
            clamped)
    compare("clamped bar, incompatible modes", {
        **held, "Solids/Incompatible modes": "A"}, clamped)
    compare("bar heated and cooled", {
        **held, "Solids/Thermal strain": f"A: {e}*sin(pi*t)"},
        {"xx": 0, "yy": 0, "y": 0})
    compare("yielding bar, below the yield stress", {
        **held, "Solids/Material": "A: elastic-plastic",
        "Solids/Yield stress": "A: 1e4"}, clamped)
    yielding = {**held, "Solids/Material": "A: elastic-plastic",
                "Solids/Yield stress": "A: 4", "Solids/Hardening modulus":
                "A: 10", "Solution/Increments": 4}
    status, said, _ = run("yielding", yielding)
    check("a bar that yields by heat", status == 0, said[:300])

    disc = {**plane, "Solids/Symmetry": "axisymmetric"}
    compare("free disc", disc, {"x": 3 * e, "y": 2 * e, "xx": 0, "yy": 0,
                                "zz": 0})
    compare("disc between plates", {
        **disc, BC + "Displacement y": "Bottom: 0, Top: 0"},
        {"yy": -E * e, "xx": 0, "zz": 0, "x": 3 * (1 + NU) * e})

    space = {**plane, "Mesh/File": "bar_space.msh", "Mesh/Points": "P: 3, 2, 1",
             BC + "Displacement x": "A_x0: 0", BC + "Displacement y": "A_y0: 0",
             BC + "Displacement z": "A_z0: 0", "Probes/Probes":
             "x: displacement x, P; y: displacement y, P; xx: stress xx, P"}
    for ranks in (1, 2):
        compare("free block", space, {"x": 3 * e, "y": 2 * e, "xx": 0},
                ranks=ranks)
        compare("held block", {**space, BC + "Displacement x":
                               "A_x0: 0, A_x1: 0"},
                {"xx": -E * e, "x": 0, "y": 2 * (1 + NU) * e}, ranks=ranks)
    large = {**space, "Solids/Kinematics": "large displacement",
             "Solution/Newton tolerance": 1e-12}
    compare("free block, large displacement", large,
            {"x": 3 * e, "y": 2 * e, "xx": 0})
    compare("free block, neo-Hookean", {
        **large, "Solids/Material": "A: neo-Hookean"},
        {"x": 3 * e, "y": 2 * e, "xx": 0})
    # Here the pressure of a heat that nothing gives way to is 150 times the shear
    # modulus.
    rubber = {"Solids/Kinematics": "large displacement",
              "Solids/Material": "A: neo-Hookean",
              "Solids/Young's modulus": "A: 3", "Solids/Poisson's ratio":
              "A: 0.4999", "Solution/Increments": 1}
    for ranks in (1, 2):
        compare("free rubber in 3-D", {**space, **rubber},
                {"x": 3 * e, "y": 2 * e, "xx": 0}, ranks=ranks)
    compare("free rubber disc", {**disc, **rubber},
            {"x": 3 * e, "y": 2 * e, "xx": 0, "zz": 0})
    compare("free block, large displacement, incompatible modes", {
        **large, "Solids/Incompatible modes": "A"},
        {"x": 3 * e, "y": 2 * e, "xx": 0})
    compare("free disc, large displacement", {
        **disc, "Solids/Kinematics": "large displacement",
        "Solution/Newton tolerance": 1e-12},
        {"x": 3 * e, "y": 2 * e, "xx": 0, "zz": 0})
    # Elastic and slender: a pressure that bends it.
    mesh = Mesh()
    mesh.block("A", 30, 1, box(0, 0, 60, 1), {"left": "Left", "corner": "C"})
    mesh.write("slender")
    grown = (1 + 2 * (1 + NU) * (e + e * e / 2)) ** 0.5 - 1
    compare("slender bar, large displacement", {
        **SOLID, "Mesh/File": "slender.msh", "Mesh/Points": "P: 60, 1",
        "Solution/Newton tolerance": 1e-12,
        BC + "Displacement x": "Left: 0", BC + "Displacement y": "C: 0",
        "Probes/Probes": "x: displacement x, P; y: displacement y, P"},
        {"x": 60 * grown, "y": grown})
    for material in ("elastic", "neo-Hookean"):
        status, said, _ = run("held_large", {
            **held, "Solids/Kinematics": "large displacement",
            "Solids/Material": f"A: {material}"})
        check(f"held in large displacement, {material}", status == 0, said[:300])
    status, said, _ = run("held_large", {
        **held, "Solids/Kinematics": "large displacement",
        "Solids/Incompatible modes": "A"})
    check("held in large displacement, modes", status == 0, said[:300])


def bimetal():
    """Timoshenko: of two layers of one thickness and modulus, together h, the
    curvature is 3/2 times the difference of the strains by h; away from the ends,
    which warp, exactly so without Poisson's ratio."""
    mesh = Mesh()
    mesh.block("A", 40, 1, box(0, 0, 40, 1), {"left": "Left", "top": "Inner"})
    mesh.block("B", 40, 1, box(0, 1, 40, 2), {"left": "Left"})
    mesh.merge()
    mesh.write("strip")
    curvature = 1.5 * 1e-3 / 2
    strip = {
        "Mesh/File": "strip.msh", "Mesh/Points": "P: 30, 1; Q: 20, 1; R: 10, 1",
        "Solids/Young's modulus": f"A: {E}, B: {E}",
        "Solids/Poisson's ratio": "A: 0, B: 0", "Element/Degree": 2,
        "Solids/Thermal strain": "A: 1e-3*t; B: table(0 0, 1 0)",
        "Solids/Kinematics": "small strain", BC + "Displacement x": "Left: 0",
        BC + "Displacement y": "Left: 0", "Probes/Probes":
        "a: displacement y, P, Q; b: displacement y, Q, R"}
    bent = {"a": curvature * (30 ** 2 - 20 ** 2) / 2,
            "b": curvature * (20 ** 2 - 10 ** 2) / 2}
    compare("bimetal strip", strip, bent, 1e-6)
    compare("bimetal strip, incompatible modes", {
        **strip, "Element/Degree": 1, "Solids/Incompatible modes": "A, B"},
        bent, 1e-6)


def shrunk():
    """A ring with the inner radius b and the outer one c, of the same material
    as the disc: p = E e (1 - b^2/c^2)/2 of an interference e b, without
    Poisson's ratio in plane stress."""
    mesh = Mesh()
    mesh.block("A", 4, 1, box(0, 0, 2, 0.5), {"bottom": "Base", "right": "Out"})
    mesh.block("B", 4, 1, box(2, 0, 4, 0.5), {"bottom": "Base", "left": "In"})
    mesh.write("shrunk")
    b, c, e = 2., 4., 1e-3
    compare("shrunk ring", {
        "Mesh/File": "shrunk.msh",
        "Solids/Young's modulus": f"A: {E}, B: {E}",
        "Solids/Poisson's ratio": "A: 0, B: 0", "Element/Degree": 2,
        "Solids/Thermal strain": f"B: -{e}*t", "Solution/Increments": 2,
        "Solids/Kinematics": "small strain", "Solids/Symmetry": "axisymmetric",
        BC + "Displacement y": "Base: 0", "Contact/Slave": "In",
        "Contact/Master": "Out", "Output/Profile": "true",
        "Probes/Probes": "F: contact force x, In"},
        {"F": 2 * 3.141592653589793 * b * 0.5 * E * e * (1 - b ** 2 / c ** 2) /
         2}, 2e-3)


bars()
bimetal()
shrunk()
sys.exit(len(failures) > 0)
