#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motions that follow from forces: obstacles under a force or a moment, and a
bolt's preload.

Proves that

- a plane that a force presses on a block comes as far as the closed form says,
  from a distance, with that force, exactly: degrees 1 and 2, both systems, both
  kinematics, every discretization, rings, space, two processes, two levels, and
  as the plane that is moved so far;
- under a force and a moment beside its middle a plane turns and sinks as the one
  whose motion is given, in small strain and large displacement, in 3-D, too;
- with friction a circle pressed and then pushed sideways moves, increment by
  increment, as the one that is given these motions, with the same forces
  (Cattaneo and Mindlin by forces), and a restart goes on;
- the preload of a bolt is exact: its stress, by how much it is shortened; with
  its length kept, a later load is shared as the stiffnesses of bolt and sleeve
  are; in 2-D, in 3-D, on two processes, both systems, and each mesh of
  several levels keeps its own length;
- no increment takes more than 8 Newton steps;
- a force that pulls, and one along a direction in which nothing resists, end
  with what is missing; what is no force is refused.

Usage: given_forces.py CONTACT PARAMETERS MESHES
"""

import json
import pathlib
import subprocess
import sys
import time

import numpy

from block_scenes import Mesh, box, check, contact, failures, run
from space_scenes import converged, probes
from volume_scenes import Volumes

E, NU = 1000., 0.3
WIDTH, HEIGHT, DEPTH, DISTANCE = 4., 2., 1.5, 0.1
SOLVED = {"Solution/Newton tolerance": 1e-12,
          "Solution/Geometry tolerance": 1e-11}
MATERIAL = {"Solids/Young's modulus": f"A: {E}",
            "Solids/Poisson's ratio": f"A: {NU}"}
most_steps = 0


def scene(what, name, entries, ranks=1):
    """Probes after each increment of a run that must converge."""
    global most_steps
    status, said, summary = run(name, {**SOLVED, **entries}, ranks)
    if not converged(what, status, summary, said[-600:]):
        return None
    steps = [i["newton_iterations"] for i in summary["increments"]]
    most_steps = max([most_steps] + steps)
    return [i["probes"] for i in summary["increments"]
            if i["probes"]] + [probes(summary)]


def near(what, found, wanted, tolerance, size=None):
    found, wanted = numpy.asarray(found), numpy.asarray(wanted)
    error = numpy.abs(found - wanted).max() / (size or numpy.abs(wanted).max())
    check(what, error < tolerance, f"{error:.1e}")


def block(name, nx=8, ny=4):
    mesh = Mesh()
    mesh.block("A", nx, ny, box(0, 0, WIDTH, HEIGHT),
               {"bottom": "Bottom", "top": "Top", "corner": "C"})
    mesh.write(name)
    volume = Volumes()
    volume.block("A", (4, 2, 2), lambda r, s, t: (WIDTH * r, HEIGHT * s,
                                                  DEPTH * t))
    volume.write(name + "_space")
    return {**MATERIAL, "Mesh/File": f"{name}.msh", "Contact/Slave": "Top",
            "Boundary conditions/Displacement x": "C: 0",
            "Boundary conditions/Displacement y": "Bottom: 0"}


IN_SPACE = {"Contact/Slave": "A_y1",
            "Boundary conditions/Displacement x": "A_000: 0, A_001: 0",
            "Boundary conditions/Displacement y": "A_y0: 0",
            "Boundary conditions/Displacement z": "A_000: 0"}


def pressed():
    force, stretch = 120., E / (1 - NU**2)
    plane = {**block("pressed"),
             "Contact/Obstacle": f"half plane: 0, {HEIGHT + DISTANCE}, 0, -1",
             "Contact/Obstacle force": f"y: {-force}*t",
             "Probes/Probes": "F: obstacle force y, Contact; "
                              "Y: obstacle motion y, Contact",
             "Solution/Increments": 2}
    small = {"Solids/Kinematics": "small strain"}
    way = -DISTANCE - force / WIDTH / stretch * HEIGHT
    space = {**IN_SPACE, "Mesh/File": "pressed_space.msh",
             "Contact/Obstacle": f"half space: 0, {HEIGHT + DISTANCE}, 0, "
                                 "0, -1, 0", **small}
    in_space = -DISTANCE - force / WIDTH / DEPTH / E * HEIGHT
    rings = -DISTANCE - force / (numpy.pi * WIDTH**2) / E * HEIGHT
    condensed = {"Solution/System": "condensed"}
    levels = {**condensed, "Refinement/Levels": 2}
    for what, more, wanted, ranks in (
            ("saddle point", {**small, "Solution/System": "saddle point"},
             way, 1),
            ("degree 2, condensed", {**small, **condensed, "Element/Degree": 2},
             way, 1),
            ("Gauss points", {**small, "Contact/Discretization": "Gauss"}, way,
             1),
            ("two levels", {**small, **levels}, way, 1),
            ("rings", {**small, "Solids/Symmetry": "axisymmetric",
                       "Boundary conditions/Displacement x": ""}, rings, 1),
            ("in 3-D, two processes", space, in_space, 2),
            ("in 3-D, two levels", {**space, "Refinement/Levels": 2},
             in_space, 1)):
        found = scene(f"pressed plane, {what}", "pressed", {**plane, **more},
                      ranks)
        if found:
            near(f"pressed plane, {what}: the force", found[-1]["F"], -force,
                 1e-9)
            near(f"pressed plane, {what}: the way", found[-1]["Y"], wanted,
                 1e-9)
    for system in ("condensed",):
        large = {**plane, "Solution/System": system}
        found = scene(f"pressed far, {system}", "pressed", {
            **large, "Contact/Obstacle force": f"y: {-4 * force}*t"})
        moved = scene(f"moved far, {system}", "pressed", {
            **{k: v for k, v in large.items() if "force" not in k},
            "Contact/Obstacle motion": f"y: {found[-1]['Y']!r}*t"})
        near(f"pressed far, {system}: the same force", moved[-1]["F"],
             -4 * force, 1e-9)


def turned():
    """A force whose arm is less than lifts the edge, and more."""
    both = "F: obstacle force y, Contact; M: obstacle moment z, Contact; " \
           "Y: obstacle motion y, Contact; A: obstacle turn, Contact"
    plane = {**block("turned"), "Solution/Increments": 2,
             "Contact/Obstacle": f"half plane: {WIDTH / 2}, {HEIGHT}, 0, -1",
             "Probes/Probes": both, "Solution/Newton tolerance": 1e-8}
    space = {**IN_SPACE, "Mesh/File": "turned_space.msh",
             "Contact/Obstacle": f"half space: {WIDTH / 2}, {HEIGHT}, 0, "
                                 "0, -1, 0",
             "Contact/Obstacle axis": "0, 0, 1"}
    for what, more, arm in (
            ("saddle point", {"Solution/System": "saddle point"}, 1.),
            ("condensed, small strain",
             {"Solution/System": "condensed",
              "Solids/Kinematics": "small strain"}, 0.3),
            ("in 3-D", space, 1.)):
        what = f"turned plane, arm {arm}, {what}"
        by_force = {**plane, **more, "Contact/Obstacle force": "y: -40*t",
                    "Contact/Obstacle moment": f"{-40 * arm}*t"}
        found = scene(what, "turned", by_force)
        if not found:
            continue
        near(f"{what}: force and moment", (found[-1]["F"], found[-1]["M"]),
             (-40, -40 * arm), 1e-7)
        moved = scene(f"{what}, given motions", "turned", {
            **plane, **more, "Contact/Obstacle motion":
            f"y: {found[-1]['Y']!r}*t; angle: {found[-1]['A']!r}*t"})
        if moved:
            near(f"{what}: the same by motions", (moved[-1]["F"],
                                                  moved[-1]["M"]),
                 (-40, -40 * arm), 1e-7)


def table(values):
    """A history through the values at the ends of equal increments."""
    return "table(0 0, " + ", ".join(
        f"{(i + 1) / len(values)!r} {v!r}" for i, v in enumerate(values)) + ")"


ROUND = {"Contact/Obstacle": f"circle: {WIDTH / 2}, {HEIGHT + 3}, 3",
         "Contact/Friction coefficient": 0.3,
         "Solution/Increments": 8,
         "Probes/Probes": "X: obstacle motion x, Contact; "
                          "Y: obstacle motion y, Contact; "
                          "Fx: obstacle force x, Contact; "
                          "Fy: obstacle force y, Contact"}
PUSH = {"Contact/Obstacle force":
        "x: 3*max(0, 2*t - 1); y: -20*min(1, 2*t)"}


def shifted():
    """Pressed by 20 N/mm in the first half, then pushed by half of what makes
    it slide."""
    entries = {**block("shifted", 16, 8), **ROUND}
    for system in "saddle point", "condensed":
        what, more = f"shifted circle, {system}", {"Solution/System": system}
        found = scene(what, "shifted", {**entries, **more, **PUSH})
        if not found:
            continue
        forces = [[i["Fx"], i["Fy"]] for i in found[:-1]]
        near(f"{what}: the forces", forces,
             [[3 * max(0, n / 4 - 1), -20 * min(1, n / 4)]
              for n in range(1, 9)], 1e-9)
        moved = scene(f"{what}, given motions", "shifted", {
            **entries, **more, "Contact/Obstacle motion":
            f"x: {table([i['X'] for i in found[:-1]])}; "
            f"y: {table([i['Y'] for i in found[:-1]])}"})
        if moved:
            near(f"{what}: the same by motions",
                 [[i["Fx"], i["Fy"]] for i in moved[:-1]], forces, 1e-6)


def restarted():
    """Ended from outside after some increments, and gone on with."""
    entries = {**block("restarted", 16, 8), **ROUND, **PUSH,
               "Solution/Increments": 40}
    whole = scene("whole run", "restarted", entries)
    file = pathlib.Path("output/restarted/restart.bin")
    with subprocess.Popen([contact, "restarted.prm", "--quiet"]) as started:
        while started.poll() is None and not file.exists():
            time.sleep(0.01)
        started.terminate()
    check("restart: the run was ended before its end", started.returncode == 5)
    subprocess.run([contact, "restarted.prm", "--quiet", "--restart"],
                   check=False, capture_output=True)
    summary = run_summary("restarted")
    near("restart: the same", [probes(summary)[k] for k in ("X", "Y")],
         [whole[-1][k] for k in ("X", "Y")], 1e-9)


def run_summary(name):
    return json.loads(
        pathlib.Path(f"output/{name}/summary.json").read_text())


def bolt(name):
    """A bolt of two halves, cut in the middle, in a sleeve of the same length,
    here beside it; both stand on the ground, and their tops are one."""
    halves = {"Lower": (0, 0, 1, 3), "Upper": (0, 3, 1, 6),
              "Sleeve": (3, 0, 5, 6)}
    mesh, volume = Mesh(), Volumes()
    for body, (x0, y0, x1, y1) in halves.items():
        mesh.block(body, 2, 4, box(x0, y0, x1, y1),
                   {"bottom": f"{body}_y0", "top": f"{body}_y1",
                    "left": f"{body}_x0", "corner": f"{body}_000"})
        volume.block(body, (2, 4, 2), lambda r, s, t, x0=x0, y0=y0, x1=x1,
                     y1=y1: (x0 + r * (x1 - x0), y0 + s * (y1 - y0), DEPTH * t))
    mesh.add(0, "P", (1 + 4 * 3 + 15,))
    mesh.write(name)
    volume.write(f"{name}_space")
    bodies = ", ".join(f"{b}: {{}}" for b in halves)
    return {"Mesh/File": f"{name}.msh",
            "Solids/Young's modulus": bodies.replace("{}", str(E)),
            "Solids/Poisson's ratio": bodies.replace("{}", str(NU)),
            "Boundary conditions/Displacement x":
            "Lower_x0: 0, Upper_x0: 0, Sleeve_x0: 0",
            "Boundary conditions/Displacement y": "Lower_y0: 0, Sleeve_y0: 0",
            "Contact/Slave": "Upper_y0", "Contact/Master": "Lower_y1",
            "Contact/Tied": "true"}


def preloaded():
    """The bolt alone between two walls, then with its sleeve."""
    force, load = 12., 30.
    entries = {**bolt("bolt"), "Solids/Kinematics": "small strain",
               "Contact/Preload": f"{force}*min(1, 2*t)",
               "Solution/Increments": 2,
               "Probes/Probes": "F: preload, Contact; S: shortening, Contact"}
    space = {"Mesh/File": "bolt_space.msh",
             "Boundary conditions/Displacement z":
             "Lower_z0: 0, Upper_z0: 0, Sleeve_z0: 0"}
    condensed = {"Solution/System": "condensed"}
    for what, more, area, modulus, ranks in (
            ("saddle point, degree 2", {"Solution/System": "saddle point",
                                        "Element/Degree": 2}, 1,
             E / (1 - NU**2), 1),
            ("two processes", condensed, 1, E / (1 - NU**2), 2),
            ("in 3-D", space, DEPTH, E, 1)):
        what = f"bolt, {what}"
        walls = entries["Boundary conditions/Displacement y"]
        alone = scene(what, "bolt", {
            **entries, **more, "Boundary conditions/Displacement y":
            walls + ", Upper_y1: 0",
            "Probes/Probes": entries["Probes/Probes"] +
            "; s: stress yy, Lower_000"})
        if alone:
            near(f"{what}: preload, stress, shortening",
                 [alone[-1][k] for k in "FsS"],
                 [force, force / area, force / area / modulus * 6], 1e-9)
        shared = scene(f"{what}, in a sleeve", "bolt", {
            **entries, **more, "Boundary conditions/Tied y":
            "Upper_y1: Upper_011, Sleeve_y1: Upper_011" if "3-D" in what
            else "Upper_y1: P, Sleeve_y1: P",
            "Boundary conditions/Force y":
            f"{'Upper_011' if '3-D' in what else 'P'}: {load}",
            "Boundary conditions/Histories": "Force y: max(0, 2*t - 1)",
            "Contact/Preload end": 0.5})
        if shared:
            # Stiffness of the bolt 1, of the sleeve 2: by their widths.
            near(f"{what}, in a sleeve: before and after the load",
                 [shared[0]["F"], shared[0]["S"], shared[1]["F"],
                  shared[1]["S"]],
                 [force, force / area / modulus * 6 * 1.5, force + load / 3,
                  force / area / modulus * 6 * 1.5], 1e-9)

    # Clamped ends: each mesh shortens the bolt by its own length.
    clamped = scene("bolt with clamped ends, levels", "bolt", {
        **entries, **condensed, "Solution/Increments": 4,
        "Contact/Preload end": 0.5, "Refinement/Levels": 2,
        "Boundary conditions/Displacement x":
        "Lower_y0: 0, Upper_y1: 0, Sleeve_x0: 0",
        "Boundary conditions/Displacement y":
        "Lower_y0: 0, Upper_y1: 0, Sleeve_y0: 0"})
    if clamped:
        near("bolt with clamped ends, levels: what is kept",
             [i["F"] for i in clamped[-4:]], [force] * 4, 1e-9)


def refused():
    plane = {**block("refused"), "Solids/Kinematics": "small strain",
             "Contact/Obstacle": f"half plane: 0, {HEIGHT}, 0, -1",
             "Solution/Max cut-backs": 1}
    for what, more, words in (
            ("a force that pulls", {"Contact/Obstacle force": "y: t"},
             ("nothing resists",)),
            ("nothing resists sideways", {"Contact/Obstacle force": "x: t; "
                                          "y: -t"}, ("resist",)),
            ("a given motion and its force",
             {"Contact/Obstacle force": "y: t",
              "Contact/Obstacle motion": "y: t"},
             ("Obstacle force", "Obstacle motion")),
            ("no force", {"Contact/Obstacle force": "angle: t"},
             ("Obstacle force", "Obstacle moment")),
            ("z in 2-D", {"Contact/Obstacle force": "z: t"},
             ("Obstacle force", "plane")),
            ("preload without a cut", {"Contact/Preload": "t"},
             ("Contact/Preload", "Contact/Tied")),
            ("the end of none", {"Contact/Preload end": "0.5"},
             ("Contact/Preload",)),
            ("a preload that ends before it acts",
             {"Contact/Preload": "1", "Contact/Preload end": "0"},
             ("Contact/Preload end",)),
            ("inside of its obstacle", {"Contact/Obstacle":
                                        f"half plane: 0, {HEIGHT + 0.1}, 0, 1"},
             ("inside of its obstacle", "normal")),
            ("a probe without a cut", {"Probes/Probes": "F: preload, Contact"},
             ("preload",))):
        status, said, _ = run("refused", {**plane, **more})
        check(f"refused: {what}", status != 0 and
              all(w in said for w in words), said[-300:])


pressed()
turned()
shifted()
restarted()
preloaded()
refused()
check("Newton steps", most_steps <= 8, most_steps)
sys.exit(bool(failures))
