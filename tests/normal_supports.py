#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Supports along the normal of flat boundaries.

Proves that

- a scene that is turned by odd angles, with its supports turned along, has the
  displacements, forces and stresses of the scene along the axes, turned, to 1e-9:
  in 2-D and in 3-D, a block under pressure and two blocks in contact, one
  of them round, with friction, with the mortar and the nodal discretization, pushed
  by a support, elements of degree 1 and 2, levels, and two processes;
- supports along axes and along normals combine at a node: in a scene along the axes
  each plane may be held by either entry;
- a quarter of a sphere on a rigid plane, turned, has the force and the pressure of
  the one along the axes;
- a turned press fit of quarter rings, of metal that yields and of rubber, lets go
  when its interference is taken back, and keeps all invariants then: nodes that
  return to where they came from are on their planes but for the round-off of the
  way, and the energy of next to no strain is next to none;
- a boundary that is not flat, a point, and groups that contradict each other are
  refused.

Usage: normal_supports.py CONTACT PARAMETERS MESHES
"""

import itertools
import math
import pathlib
import sys

import numpy

from block_scenes import Mesh, box, check, failures, run, solve
from space_scenes import converged, merged, probes, rotation
from volume_scenes import Volumes

AXES = "xyz"
ANGLES = {2: (37.,), 3: (27., -40., 63.)}
parameters, meshes = (pathlib.Path(a).resolve() for a in sys.argv[2:4])


def turn_of(dim):
    return rotation(ANGLES[3]) if dim == 3 else \
        rotation((0, 0, *ANGLES[2]))[:2, :2]


class Scene:
    """Entries without supports, the supports {boundary: (axis, sign of its outward
    normal, displacement along the axis)}, the places where displacements are
    compared, and the boundaries whose reactions are."""

    def __init__(self, name, dim, entries, supports, points, reactions,
                 scalars):
        self.name, self.dim, self.entries = name, dim, entries
        self.supports, self.points = supports, points
        self.reactions, self.scalars = reactions, scalars

    def by_axes(self, groups):
        entries = {}
        for group in groups:
            axis, _, value = self.supports[group]
            entries = merged(entries, {
                f"Boundary conditions/Displacement {axis}":
                f"{group}: {value!r}"})
        return entries

    def by_normals(self, groups):
        entries = {}
        for group in groups:
            _, sign, value = self.supports[group]
            entries = merged(entries, {
                "Boundary conditions/Displacement normal":
                f"{group}: {sign * value!r}"})
        return entries

    def solve(self, what, wanted, more, ranks=1):
        """The wanted probes by name."""
        status, said, summary = run(self.name, {
            **self.entries, **more,
            "Solution/Newton tolerance": 1e-12,
            "Probes/Probes": "; ".join(wanted)}, ranks)
        if not converged(f"{self.name}, {what}", status, summary, said):
            return {}
        return probes(summary)

    def compare(self, what, more=None, ranks=1, tolerance=1e-9):
        """Along the axes, by either entry, and turned."""
        more, turn = more or {}, turn_of(self.dim)
        groups = list(self.supports)
        # Along the axes a reaction is in one direction.
        one_way = [f"R {g}: reaction {self.supports[g][0]}, {g}"
                   for g in self.reactions]
        vectors = [f"u {p} {a}: displacement {a}, {p}" for p in self.points
                   for a in AXES[:self.dim]]
        scalars = [f"{n}: {v}" for n, v in self.scalars.items()]
        plain = self.solve(f"{what}, along the axes",
                           one_way + vectors + scalars,
                           {**more, **self.by_axes(groups)})
        mixed = self.solve(f"{what}, along the axes by either entry",
                           one_way + vectors + scalars,
                           {**more, **self.by_axes(groups[::2]),
                            **self.by_normals(groups[1::2])}, ranks)
        all_ways = [f"R {g} {a}: reaction {a}, {g}" for g in self.reactions
                    for a in AXES[:self.dim]]
        turned = self.solve(f"{what}, turned", all_ways + vectors + scalars, {
            **more, **self.by_normals(groups),
            "Mesh/Rotation": ", ".join(map(str, ANGLES[self.dim]))}, ranks)
        if not (plain and mixed and turned):
            return

        def vector(values, name):
            return numpy.array([values[f"{name} {a}"]
                                for a in AXES[:self.dim]])
        size = max(numpy.linalg.norm(vector(plain, f"u {p}"))
                   for p in self.points)
        worst = max([abs(mixed[k] - plain[k]) / abs(plain[k])
                     for k in (*self.scalars,
                               *(f"R {g}" for g in self.reactions))] +
                    [numpy.linalg.norm(vector(mixed, f"u {p}") -
                                       vector(plain, f"u {p}")) / size
                     for p in self.points])
        check(f"{self.name}, {what}: the same by either entry",
              worst < tolerance, worst)
        worst = max([abs(turned[k] - plain[k]) / abs(plain[k])
                     for k in self.scalars] +
                    [numpy.linalg.norm(turn.T @ vector(turned, f"u {p}") -
                                       vector(plain, f"u {p}")) / size
                     for p in self.points])
        # Nodes that other groups hold as well have reactions in other
        # directions.
        for group in self.reactions:
            reaction = turn.T @ vector(turned, f"R {group}")
            worst = max(worst, abs(
                reaction[AXES.index(self.supports[group][0])] /
                plain[f"R {group}"] - 1))
        check(f"{self.name}, {what}: the same turned", worst < tolerance,
              worst)


def patch_in_the_plane():
    mesh = Mesh()
    mesh.block("Block", 3, 2, box(0., 0., 3., 2.),
               {"left": "Block_x0", "bottom": "Block_y0", "top": "Block_y1"})
    mesh.add(0, "Far", (12,))
    mesh.write("plane_patch")
    return Scene("plane_patch", 2, {
        "Mesh/File": "plane_patch.msh",
        "Solids/Young's modulus": "Block: 1000",
        "Solids/Poisson's ratio": "Block: 0.3",
        "Boundary conditions/Pressure": "Block_y1: 100",
        "Solution/Increments": 1},
        {"Block_x0": ("x", -1, 0.), "Block_y0": ("y", -1, 0.)},
        ["Far"], ["Block_y0"], {"s": "von Mises, Far"})


def contact_in_the_plane():
    """Half of a round block that is pushed on a flat one."""
    mesh = Mesh()
    mesh.block("Low", 8, 3, box(0., -1., 2., 0.),
               {"left": "Low_x0", "bottom": "Low_y0", "top": "Low_y1"})
    mesh.block("Up", 5, 3,
               lambda s, t: (1.2 * s, t + (1 - t) * 0.1 * (1.2 * s) ** 2),
               {"left": "Up_x0", "top": "Up_y1", "bottom": "Up_y0",
                "corner": "Pole"})
    mesh.add(0, "Side", (9,))
    mesh.write("plane_contact")
    return Scene("plane_contact", 2, {
        "Mesh/File": "plane_contact.msh",
        "Solids/Young's modulus": "Low: 1000, Up: 3000",
        "Solids/Poisson's ratio": "Low: 0.3, Up: 0.2",
        "Contact/Slave": "Up_y0", "Contact/Master": "Low_y1",
        "Contact/Friction coefficient": 0.2,
        "Solution/Increments": 2},
        {"Low_x0": ("x", -1, 0.), "Low_y0": ("y", -1, 0.),
         "Up_x0": ("x", -1, 0.), "Up_y1": ("y", 1, -0.05)},
        ["Pole", "Side"], ["Low_y0", "Up_y1"], {"p": "pressure, Pole"})


def patch_in_space():
    mesh = Volumes()
    mesh.block("Block", (2, 3, 2), lambda r, s, t: (2 * r, 3 * s, t))
    mesh.write("patch")
    return Scene("patch", 3, {
        "Mesh/File": "patch.msh",
        "Solids/Young's modulus": "Block: 1000",
        "Solids/Poisson's ratio": "Block: 0.3",
        "Boundary conditions/Pressure": "Block_z1: 100",
        "Solution/Increments": 1},
        {"Block_x0": ("x", -1, 0.), "Block_y0": ("y", -1, 0.),
         "Block_z0": ("z", -1, 0.)},
        ["Block_111"], ["Block_z0"], {"s": "von Mises, Block_111"})


def contact_in_space():
    """A quarter of a round block that is pushed on a flat one."""
    mesh = Volumes()
    mesh.block("Low", (4, 4, 2), lambda r, s, t: (1.6 * r, 1.6 * s, t - 1))
    mesh.block("Up", (3, 3, 2), lambda r, s, t: (
        1.1 * r, s, t + (1 - t) * (0.1 * (1.1 * r) ** 2 + 0.15 * s ** 2)))
    mesh.write("quarter")
    return Scene("quarter", 3, {
        "Mesh/File": "quarter.msh",
        "Solids/Young's modulus": "Low: 1000, Up: 3000",
        "Solids/Poisson's ratio": "Low: 0.3, Up: 0.2",
        "Contact/Slave": "Up_z0", "Contact/Master": "Low_z1",
        "Contact/Friction coefficient": 0.2,
        "Solution/Increments": 2},
        {"Low_x0": ("x", -1, 0.), "Low_y0": ("y", -1, 0.),
         "Low_z0": ("z", -1, 0.), "Up_x0": ("x", -1, 0.),
         "Up_y0": ("y", -1, 0.), "Up_z1": ("z", 1, -0.05)},
        ["Up_000", "Low_111"], ["Low_z0", "Up_z1"],
        {"p": "pressure, Up_000"})


def blocks():
    for scene in (patch_in_the_plane(), patch_in_space()):
        for degree, kinematics in itertools.product(
                (1, 2), ("small strain", "large displacement")):
            scene.compare(f"degree {degree}, {kinematics}",
                          {"Element/Degree": degree,
                           "Solids/Kinematics": kinematics})


def contacts():
    for scene in (contact_in_the_plane(), contact_in_space()):
        for degree, rule in itertools.product((1, 2), ("mortar", "nodal")):
            scene.compare(f"degree {degree}, {rule}",
                          {"Element/Degree": degree,
                           "Contact/Discretization": rule})
        scene.compare("a level, two processes", {
            "Element/Degree": 1, "Solution/System": "condensed",
            "Refinement/Levels": 1}, ranks=2)


def sphere():
    case = parameters / "verification" / "3d" / "sphere_on_plane.prm"
    turn = rotation(ANGLES[3])
    n = ", ".join(f"{float(c)!r}" for c in turn[:, 2])
    # Multigrid stops at the tolerance, against whose scale this contact is small.
    common = ("Solution/Linear solver=CHOLMOD", "Solution/Newton tolerance=1e-12",
              "Refinement/Levels=1", "Output/Profile=false")
    status, said, plain = solve(case, *common)
    check("sphere, along the axes: runs", status in (0, 1), said)
    status, said, turned = solve(
        case, *common, "Mesh/Rotation=" + ", ".join(map(str, ANGLES[3])),
        "Boundary conditions/Displacement x=",
        "Boundary conditions/Displacement y=",
        "Boundary conditions/Displacement z=",
        "Boundary conditions/Displacement normal="
        "Plane_x: 0, Plane_y: 0, Top: -0.0025",
        f"Contact/Obstacle=half space: 0, 0, 0, {n}",
        "Probes/References=", "Probes/Tolerances=",
        "Probes/Probes=Rx: reaction x, Top; Ry: reaction y, Top; "
        "Rz: reaction z, Top; p(0): pressure, Pole")
    check("sphere, turned: runs", status == 0, said)
    plain, turned = probes(plain), probes(turned)
    force = turn.T @ numpy.array([turned[f"R{a}"] for a in AXES])
    worst = max(abs(force[2] / plain["P/4"] - 1),
                abs(turned["p(0)"] / plain["p(0)"] - 1))
    check("sphere: force and pressure", worst < 1e-9, worst)


def press_fit():
    mesh = Mesh()
    for body, r0, r1, layers, sides in (
            ("Shaft", 20., 50., 3, {"top": "Journal", "left": "Sx",
                                    "right": "Sy"}),
            ("Hub", 50., 100., 4, {"bottom": "Bore", "left": "Hx",
                                   "right": "Hy"})):
        mesh.block(body, 8, layers, lambda s, t: (
            (r0 + t * (r1 - r0)) * math.sin(math.pi / 2 * s),
            (r0 + t * (r1 - r0)) * math.cos(math.pi / 2 * s)), sides)
    mesh.write("press_fit")
    entries = {
        "Mesh/File": "press_fit.msh", "Mesh/Rotation": ANGLES[2][0],
        "Mesh/Arcs": "Bore: 0, 0, 50; Journal: 0, 0, 50", "Element/Degree": 2,
        "Solids/Young's modulus": "Shaft: 210000, Hub: 210000",
        "Solids/Poisson's ratio": "Shaft: 0.3, Hub: 0.3",
        "Boundary conditions/Displacement normal":
        "Sx: 0, Sy: 0, Hx: 0, Hy: 0",
        "Contact/Slave": "Bore", "Contact/Master": "Journal",
        "Contact/Interference": "table(0 0, 0.5 0.06, 1 -0.06)",
        "Solution/Increments": 12}
    for what, of_hub in (
            ("yields", {"Solids/Kinematics": "small strain",
                        "Solids/Material": "Hub: elastic-plastic",
                        "Solids/Yield stress": "Hub: 250",
                        "Solids/Hardening modulus": "Hub: 2000"}),
            ("is of rubber", {"Solids/Kinematics": "large displacement",
                              "Solids/Material": "Hub: neo-Hookean"})):
        status, said, summary = run("press_fit", {**entries, **of_hub})
        forces = [i["contact"]["normal_force"]
                  for i in summary.get("increments", [])]
        check(f"press fit, the hub {what}: it lets go", status == 0 and
              max(forces) > 1000 and forces[-1] == 0, f"{status} {said[-300:]}")


def refusals():
    scene = contact_in_space()
    for what, group, words in (
            ("round", "Up_z0: 0", "not flat"),
            ("a point", "Up_000: 0", "no normal"),
            ("a contradiction", "Low_z0: 0, Up_z1: 0.1, Up_x0: 0",
             "moved differently")):
        status, said, _ = run("refused", {
            **scene.entries, "Boundary conditions/Displacement z": "Up_z1: 0.2",
            "Boundary conditions/Displacement normal": group})
        check(f"{what} is refused", status == 2 and words in said, said)


blocks()
contacts()
sphere()
press_fit()
refusals()
sys.exit(bool(failures))
