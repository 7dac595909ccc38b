#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plasticity at large strain, run by the program.

Proves that, with at most 6 Newton steps an increment (but for contact), none cut,
and energies that balance,

- a cube (8 and 20 nodes) and a disc stretched to twice their length, compressed to
  half of it and unloaded have the true stress, the width and the plastic strain of
  the closed form: the law at the logarithm of the stretch; and plane strain that of
  the cube held across;
- a cube sheared by 1.5, loaded by parts along other ways and back, has the stresses
  of the law in logarithmic strains, by an integral instead of a spectral
  decomposition, and those of its rate equations within a percent;
- a thick tube widened by half has the pressure of Hill by his integral;
- a bar has its maximal force where Considere has it, within a percent, and then a
  neck;
- a ball is pressed into a block, to plastic strains beyond one.

Usage: large_plasticity.py CONTACT PARAMETERS MESHES
"""

import math
import sys

import numpy as np

from block_scenes import Mesh, box, check, failures, rows, run, violations
from volume_scenes import Volumes

E, NU, YIELD, LINEAR, SATURATED, RATE, KINEMATIC = 1000., 0.3, 4., 3., 6., 5., 2.
SOLID = {"Solids/Young's modulus": f"A: {E}", "Solids/Poisson's ratio": f"A: {NU}",
         "Solids/Material": "A: elastic-plastic", "Solids/Yield stress": f"A: {YIELD}",
         "Solids/Hardening modulus": f"A: {LINEAR}",
         "Solids/Saturation stress": f"A: {SATURATED}",
         "Solids/Saturation rate": f"A: {RATE}",
         "Solids/Kinematic hardening modulus": f"A: {KINEMATIC}",
         "Solution/Newton tolerance": 1e-12}
BC = "Boundary conditions/"
MOST_STEPS = 6


def yield_stress(a):
    return YIELD + LINEAR * a + (SATURATED - YIELD) * (1 - np.exp(-RATE * a))


def solve(name, scene):
    """The probes of the last increment."""
    status, said, summary = run(name, scene)
    increments = summary.get("increments", [])
    steps = [i["newton_iterations"] for i in increments]
    check(f"{name}: converges, balances, in few steps",
          status == 0 and not violations(summary) and steps and
          max(steps) <= MOST_STEPS and all(i["converged"] for i in increments),
          f"{status} {steps} {violations(summary)} {said[-300:] if status else ''}")
    return {p["name"]: p["value"] for p in summary.get("probes", [])}


def compare(what, found, expected, tolerance=1e-8):
    worst = max((abs(found.get(k, math.inf) - v) / max(abs(v), 1e-3), k)
                for k, v in expected.items())
    check(f"  {what}", worst[0] <= tolerance, worst)


def root(function, low, high):
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return 0.5 * (low + high)


def bar(stretch):
    """True stress, stretch across and plastic strain of a bar."""
    way = math.log(stretch)
    sign = math.copysign(1, way)
    a = root(lambda a: a - sign * way + (yield_stress(a) + KINEMATIC * a) / E, 0, 9)
    tau = sign * (yield_stress(a) + KINEMATIC * a)
    return (tau / math.exp((1 - 2 * NU) * tau / E),
            math.exp(-NU * tau / E - 0.5 * sign * a), a)


def stretched():
    block = Volumes()
    block.block("A", (1, 1, 1), lambda r, s, t: (r, s, t))
    block.write("cube")
    mesh = Mesh()
    mesh.block("A", 1, 1, box(0, 0, 1, 1), {
        "bottom": "Bottom", "top": "Top", "left": "Left", "right": "Right"})
    mesh.write("square")
    cube = {**SOLID, "Mesh/File": "cube.msh", "Mesh/Points": "P: 1, 1, 1",
            BC + "Displacement x": "A_x0: 0", BC + "Displacement z": "A_z0: 0",
            BC + "Displacement y": "A_y0: 0, A_y1: 1", "Solution/Increments": 10,
            "Probes/Probes": "yy: stress yy, P; xx: stress xx, P; zz: stress zz, P;"
            " x: displacement x, P; a: plastic strain, P"}
    disc = {**cube, "Mesh/File": "square.msh", "Mesh/Points": "P: 1, 1",
            "Solids/Symmetry": "axisymmetric", BC + "Displacement z": "",
            BC + "Displacement x": "", BC + "Displacement y": "Bottom: 0, Top: 1"}
    for name, scene in (("cube", cube), ("quadratic_cube",
                                         {**cube, "Element/Degree": 2}),
                        ("disc", disc)):
        top = "Top" if name == "disc" else "A_y1"
        bottom = "Bottom" if name == "disc" else "A_y0"
        for way, stretch in (("pulled", 2.), ("pressed", 0.5)):
            sigma, width, a = bar(stretch)
            here = {**scene, BC + "Displacement y": f"{bottom}: 0, {top}: {stretch - 1}"}
            compare(f"stretch {stretch}", solve(f"{name}_{way}", here),
                    {"yy": sigma, "xx": 0, "zz": 0, "x": width - 1, "a": a})
            if name == "quadratic_cube":
                break
        if name == "quadratic_cube":
            continue
        # Without stress the length is that of the plastic strain.
        a = bar(2.)[2]
        compare("unloaded", solve(f"{name}_unloaded", {
            **here, BC + "Displacement y": f"{bottom}: 0, {top}: 1",
            BC + "Histories": "Displacement y: if(t < 0.5, 2*t, "
            f"1 - (2*t - 1)*{2 - math.exp(a)!r})"}),
            {"yy": 0, "xx": 0, "zz": 0, "x": math.exp(-a / 2) - 1, "a": a}, 1e-7)
    held = solve("held_cube", {**cube, BC + "Displacement z": "A_z0: 0, A_z1: 0"})
    plane = {**disc, "Solids/Symmetry": "plane strain", BC + "Displacement x": "Left: 0"}
    compare("plane strain", solve("plane", plane), held)
    return cube


ROOTS, WEIGHTS = np.polynomial.legendre.leggauss(60)
PART, WEIGHTS = (ROOTS + 1) / 2, WEIGHTS / 2
ONE = np.eye(3)


def mixed(C):
    """The inverses of I + t (C - I), by whose integrals
         ln C = (C - I) integral,  d ln C = integral (inverse dC inverse)."""
    return np.linalg.inv(ONE + PART[:, None, None] * (C - ONE))


def logarithm(F):
    C = F.T @ F
    return 0.5 * (C - ONE) @ np.tensordot(WEIGHTS, mixed(C), 1)


def true_stress(F, T):
    inverses = mixed(F.T @ F)
    S = np.tensordot(WEIGHTS, inverses @ T @ inverses, 1)
    return F @ S @ F.T / np.linalg.det(F)


def deviator(X):
    return X - np.trace(X) / 3 * ONE


MU, BULK = E / (2 * (1 + NU)), E / (3 * (1 - 2 * NU))


def returned(e, plastic, a):
    """The stress in logarithmic strains after an increment, and its history."""
    xi = 2 * MU * deviator(e) - (2 * MU + 2 / 3 * KINEMATIC) * plastic
    q = math.sqrt(1.5) * np.linalg.norm(xi)
    if q > yield_stress(a):
        da = root(lambda x: (3 * MU + KINEMATIC) * x - q + yield_stress(a + x), 0,
                  q / (3 * MU))
        plastic = plastic + 1.5 * da / q * xi
        a += da
    return (BULK * np.trace(e) * ONE + 2 * MU * (deviator(e) - plastic), plastic, a)


def rates(path, steps):
    """The same by the rate equations along F = path(t): the midpoint rule in small
    steps."""
    def flow(e, plastic, a, change):
        xi = 2 * MU * deviator(e) - (2 * MU + 2 / 3 * KINEMATIC) * plastic
        q = math.sqrt(1.5) * np.linalg.norm(xi)
        if q < yield_stress(a):
            return 0 * xi, 0.
        n = 1.5 * xi / q
        slope = LINEAR + (SATURATED - YIELD) * RATE * math.exp(-RATE * a)
        da = 2 * MU * np.sum(n * change) / (3 * MU + KINEMATIC + slope)
        return max(0., da) * n, max(0., da)

    plastic, a = np.zeros((3, 3)), 0.
    strains = [logarithm(path(k / steps)) for k in range(steps + 1)]
    for before, e in zip(strains, strains[1:]):
        half, da = flow(before, plastic, a, (e - before) / 2)
        whole, da = flow((before + e) / 2, plastic + half, a + da, e - before)
        plastic, a = plastic + whole, a + da
    T = BULK * np.trace(e) * ONE + 2 * MU * (deviator(e) - plastic)
    return true_stress(path(1.), T), a


def sheared(cube):
    names = {"xx": (0, 0), "yy": (1, 1), "zz": (2, 2), "xy": (0, 1), "xz": (0, 2),
             "yz": (1, 2)}
    probes = "; ".join(f"{n}: stress {n}, P" for n in names) + "; a: plastic strain, P"

    def move(x, y, z):
        return lambda t: np.array([[1, x(t), 0], [0, 1 + y(t), 0],
                                   [0, z(t), 1.]])
    scenes = {
        "shear": ((1.5, 0, 0), "t", lambda t: t, 40),
        "shear_and_back": ((1.5, 0, 0), "sin(pi*t)", lambda t: math.sin(math.pi * t),
                           20),
        "shear_and_stretch": ((0.9, 0.3, 0.6), "t*t", lambda t: t * t, 20)}
    for name, (sizes, text, history, n) in scenes.items():
        path = move(*(lambda t, s=s: s * history(t) for s in sizes))
        if name == "shear_and_stretch":  # along x first
            path = move(lambda t: sizes[0] * t, lambda t: sizes[1] * t * t,
                        lambda t: sizes[2] * t * t)
            text = "Displacement y: t*t; Displacement z: t*t"
        else:
            text = f"Displacement x: {text}"
        found = solve(name, {
            **cube, BC + "Displacement x": f"A_y0: 0, A_y1: {sizes[0]}",
            BC + "Displacement y": f"A_y0: 0, A_y1: {sizes[1]}",
            BC + "Displacement z": f"A_y0: 0, A_y1: {sizes[2]}",
            BC + "Histories": text, "Solution/Increments": n, "Probes/Probes": probes})
        plastic, a = np.zeros((3, 3)), 0.
        for k in range(1, n + 1):
            F = path(k / n)
            T, plastic, a = returned(logarithm(F), plastic, a)
        sigma = true_stress(F, T)
        scale = np.linalg.norm(sigma)
        worst = max(abs(found[k] - sigma[i]) for k, i in names.items()) / scale
        check("  the same increments", worst < 1e-8 and abs(found["a"] / a - 1) < 1e-8,
              worst)
        if name == "shear_and_back":
            continue
        exact, a = rates(path, 500)
        worst = max(abs(found[k] - exact[i]) for k, i in names.items()) / scale
        check("  the rate equations", worst < 0.01 and abs(found["a"] / a - 1) < 0.01,
              worst)


def tube():
    inner, outer, n = 10., 20., 12
    mesh = Mesh()
    mesh.block("A", n, 1, box(inner, 0, outer, 1), {
        "bottom": "Ends", "top": "Ends", "left": "Bore", "right": "Outside"})
    mesh.write("tube")
    hard = {**SOLID, "Solids/Young's modulus": "A: 20000"}
    for widening in (0.5,):
        a = (1 + widening) * inner
        b = math.sqrt(outer**2 + a**2 - inner**2)
        x, w = np.polynomial.legendre.leggauss(40)
        r = a + (b - a) * (x + 1) / 2
        strain = np.log(r / np.sqrt(r**2 - a**2 + inner**2)) * 2 / math.sqrt(3)
        # Kinematic hardening of a straight path counts as isotropic one.
        pressure = np.sum((b - a) / 2 * w / r * 2 / math.sqrt(3) *
                          (yield_stress(strain) + KINEMATIC * strain))
        for degree in (1, 2):
            found = solve(f"tube_{degree}", {
                **hard, "Mesh/File": "tube.msh", "Solids/Symmetry": "axisymmetric",
                "Mesh/Points": f"O: {outer}, 0", "Element/Degree": degree,
                BC + "Displacement x": f"Bore: {widening * inner}",
                BC + "Displacement y": "Ends: 0", "Solution/Increments": 10,
                "Probes/Probes": "force: support x, Bore; b: displacement x, O"})
            compare(f"Hill's pressure, degree {degree}",
                    {"p": found["force"] / (2 * math.pi * a), "b": found["b"]},
                    {"p": pressure, "b": b - outer}, 0.01)


def necked():
    """Half of the bar of Simo (Comput. Methods Appl. Mech. Engrg. 68, 1988, 1-31),
    without an imperfection; its ends are held across."""
    radius, half, end = 6.413, 26.667, 7.
    mesh = Mesh()
    mesh.block("A", 5, 16, lambda s, t: (radius * s, half * t**1.6),
               {"bottom": "Neck", "top": "Head", "left": "Axis"})
    mesh.write("bar")
    shear, bulk = 80193.8, 164206.
    young = 9 * bulk * shear / (3 * bulk + shear)
    first, last, rate, linear = 450., 715., 16.93, 129.24
    found = solve("necked", {
        "Mesh/File": "bar.msh", "Mesh/Points": f"P: {radius}, 0; Q: {radius}, {half / 2}",
        "Solids/Symmetry": "axisymmetric", "Solids/Material": "A: elastic-plastic",
        "Solids/Young's modulus": f"A: {young}",
        "Solids/Poisson's ratio": f"A: {young / (2 * shear) - 1}",
        "Solids/Yield stress": f"A: {first}", "Solids/Saturation stress": f"A: {last}",
        "Solids/Saturation rate": f"A: {rate}",
        "Solids/Hardening modulus": f"A: {linear}",
        BC + "Displacement x": "Axis: 0, Head: 0",
        BC + "Displacement y": f"Neck: 0, Head: {end}", "Solution/Increments": 50,
        "Probes/Probes": "force: support y, Head; u: displacement x, P;"
        " far: displacement x, Q"})

    def force(a):  # without elastic strains
        stress = first + linear * a + (last - first) * (1 - math.exp(-rate * a))
        return math.pi * radius**2 * stress * math.exp(-a)
    forces = [row["force [N]"] for row in rows("necked", "history.csv")]
    largest = max(force(k / 1e4) for k in range(10000))
    check("  the maximal force is that of Considere", abs(max(forces) / largest - 1)
          < 0.01, f"{max(forces)} {largest}")
    check("  a neck bears half of it, where the bar is thick",
          forces[-1] < 0.5 * largest and found["u"] < -0.5 * radius < found["far"]
          < -0.05 * radius, f"{forces[-1]} {found}")


def indented():
    """A rigid ball without friction in a perfectly plastic block, until it has sunk
    in by a quarter of its radius. Contact begins at a node, in cells that are as
    large as the contact: there Newton's method takes as many steps as it needs."""
    radius, size, depth, n, bound, ratio = 10., 60., 2.5, 20, 2., 1.16

    def graded(s):
        return size * (ratio**(n * s) - 1) / (ratio**n - 1)
    mesh = Mesh()
    mesh.block("A", n, n, lambda s, t: (graded(s), -graded(1 - t)), {
        "bottom": "Foot", "top": "Top", "left": "Axis"})
    mesh.write("block")
    status, said, summary = run("indented", {
        "Mesh/File": "block.msh", "Solids/Symmetry": "axisymmetric",
        "Solids/Material": "A: elastic-plastic", "Solids/Young's modulus": "A: 1000",
        "Solids/Poisson's ratio": "A: 0.3", "Solids/Yield stress": f"A: {bound}",
        BC + "Displacement x": "Axis: 0", BC + "Displacement y": "Foot: 0",
        "Contact/Slave": "Top", "Contact/Obstacle": f"circle: 0, {radius}, {radius}",
        "Contact/Obstacle motion": f"y: -{depth}*t", "Solution/Increments": 40,
        "Probes/Probes": "force: obstacle force y, Contact", "Output/Profile": "true"})
    steps = [i["newton_iterations"] for i in summary["increments"]]
    strain = summary["bodies"]["A"]["plastic_strain"]
    check("indented: converges, balances, to a plastic strain of one", status == 0 and
          not violations(summary) and strain > 1, f"{strain} {steps} {said[-300:]}")
    check("  none cut, three of four in few steps",
          sorted(steps)[len(steps) * 3 // 4] <= MOST_STEPS and
          all(i["converged"] for i in summary["increments"]), steps)
    touching = [row["X_mm"] + row["displacement_x_mm"] for row in rows("indented")
                if row["surface"] == "slave" and row["pressure_MPa"] > 0]
    hardness = -summary["probes"][0]["value"] / (math.pi * max(touching)**2)
    check("  a hardness of two to three yield stresses",
          2 * bound < hardness < 3 * bound, hardness)


if __name__ == "__main__":
    cube = stretched()
    sheared(cube)
    tube()
    necked()
    indented()
    sys.exit(bool(failures))
