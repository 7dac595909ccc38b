#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Obstacles that move: slip against their surface, forces, moments and works.

Proves that

- a block that a moving plane drags against a wall is pushed by mu N, exactly, and
  what the plane does to it is dissipated: works of the plane, of friction and of
  the pressures agree;
- once a plane that presses a block has come to rest no Newton step is needed,
  whether points stick or slip;
- a plane or a circle that is moved to a block, and along it, does the same as the
  block that is moved to the one that stands still, to 1e-10: nodal and mortar
  discretization, both systems, small strain and large displacement;
- a block between two planes that turn together by 90 degrees is carried along as
  a rigid body: no slip, no work, to 1e-9;
- a circle that turns against a block slips everywhere once its torque is
  mu sum w p R, and sticks before; in 3-D a cylinder does to an extruded block
  what the circle does to the plane one, by its thickness;
- a profile with round corners is the circle, hole, half plane or cylinder that it
  can be;
- forces and moments are those of the nodes of the slave about the centre;
- in 3-D a sphere that turns about a slanted axis exerts mu sum w p r there once
  all slips, the same turned, and with both systems' loops of friction;
- what a round tool works that irons a soft block is stored or rubbed away, but for
  the error of the rule in time, which halves with the increments; its forces stay
  once it is under way, with the nodal discretization as well;
- results do not depend on the number of processes, nor on units, turn with the
  scene, and a restart goes on;
- what is no motion is refused.

Usage: moving_obstacles.py CONTACT PARAMETERS MESHES
"""

import itertools
import json
import math
import pathlib
import subprocess
import sys
import time

import numpy

from block_scenes import Mesh, box, check, contact, failures, rows, run
from space_scenes import converged, probes, rotation
from volume_scenes import Volumes

FRICTION = 0.3
WIDTH, HEIGHT, THICKNESS = 4., 2., 1.5
SOLVED = {"Solution/Newton tolerance": 1e-12,
          "Solution/Geometry tolerance": 1e-11}


def block(name, nx=8, ny=4):
    mesh = Mesh()
    mesh.block("Block", nx, ny, box(0., 0., WIDTH, HEIGHT),
               {"bottom": "Bottom", "right": "Right", "top": "Top",
                "left": "Left"})
    for group, corner in (("A", 1), ("B", nx + 1)):
        mesh.add(0, group, (corner,))
    mesh.write(name)
    return {"Mesh/File": f"{name}.msh",
            "Solids/Young's modulus": "Block: 1000",
            "Solids/Poisson's ratio": "Block: 0.3",
            "Contact/Slave": "Bottom",
            "Contact/Friction coefficient": FRICTION}


def scene(what, name, entries, ranks=1):
    """The summary of a run with moving obstacles that must converge."""
    status, said, summary = run(name, {**SOLVED, **entries}, ranks)
    converged(what, status, summary, said)
    return summary


def of_obstacle(summary, pair=""):
    """Force x, y and moment z of the obstacle after the last increment."""
    found = summary["increments"][-1]["contact"]
    found = found[pair] if pair in found else found
    return numpy.array([found["obstacle_force_x"], found["obstacle_force_y"],
                        found["obstacle_moment_z"]])


def near(what, found, wanted, tolerance, size=None):
    found, wanted = numpy.asarray(found), numpy.asarray(wanted)
    size = size or numpy.abs(wanted).max()
    error = numpy.abs(found - wanted).max() / size
    check(what, error < tolerance, f"{error:.1e}")


def dragged_block():
    """Pressed by P on its top against a plane that then moves to the right, and
    against a wall there."""
    P, way = 10., 0.6
    for degree, system in itertools.product(
            (1, 2), ("saddle point", "condensed")):
        what = f"dragged block, degree {degree}, {system}"
        summary = scene(what, "dragged", {
            **block("dragged"), "Element/Degree": degree,
            "Boundary conditions/Displacement x": "Right: 0",
            "Boundary conditions/Pressure": f"Top: {P}",
            "Boundary conditions/Histories": "Pressure: min(1, 2*t)",
            "Solids/Kinematics": "small strain",
            "Contact/Obstacle": "half plane: 0, 0, 0, 1",
            "Contact/Obstacle motion": f"x: max(0, 2*t - 1)*{way}",
            "Solution/System": system, "Solution/Increments": 20,
            "Probes/Probes": "F: obstacle force x, Contact"})
        force = of_obstacle(summary)
        near(f"{what}: the force is mu N", force[:2],
             (FRICTION * P * WIDTH, P * WIDTH), 1e-9)
        near(f"{what}: so is that on the wall, and the probe",
             (probes(summary)["F"],
              -summary["increments"][-1]["reactions"]["Right"]["x"]),
             (force[0], force[0]), 1e-9)
        # In the last quarter all of it slips.
        half, after = (summary["increments"][i]["works"] for i in (14, -1))
        near(f"{what}: the work of the plane",
             after["external"] - half["external"],
             force[0] * way / 2, 1e-6)
        near(f"{what}: it is dissipated",
             (after["dissipation"] - half["dissipation"],
              half["friction"] - after["friction"]),
             (force[0] * way / 2,) * 2, 1e-6)


def moved_the_other_way():
    """The obstacle comes closer by DY and then passes along the block by DX, or
    the block does."""
    DX, DY = 0.5, 0.15
    come, pass_by = "min(1, 2*t)", "max(0, 2*t - 1)"
    obstacles = {"plane": "half plane: 0, 0, 0.1, 1",
                 "circle": "circle: 1.5, -3, 3"}
    for (shape, obstacle), rule, system, kinematics in itertools.product(
            obstacles.items(), ("nodal", "mortar"),
            ("saddle point", "condensed"),
            ("small strain", "large displacement")):
        what = f"{shape}, {rule}, {system}, {kinematics}"
        entries = {
            **block("way"), "Contact/Obstacle": obstacle,
            "Contact/Discretization": rule, "Solution/System": system,
            "Solids/Kinematics": kinematics, "Solution/Increments": 8,
            "Output/Nodes": "true"}
        still = scene(f"{what}, the obstacle stands still", "way", {
            **entries,
            "Boundary conditions/Displacement x": f"Top: {DX!r}",
            "Boundary conditions/Displacement y": f"Top: {-DY!r}",
            "Boundary conditions/Histories":
            f"Displacement x: {pass_by}; Displacement y: {come}"})
        u = displacements("way") - (DX, -DY)
        moved = scene(f"{what}, the obstacle moves", "way", {
            **entries,
            "Boundary conditions/Displacement x": "Top: 0",
            "Boundary conditions/Displacement y": "Top: 0",
            "Contact/Obstacle motion":
            f"x: {-DX!r}*{pass_by}; y: {DY!r}*{come}"})
        near(f"{what}: the same displacements", displacements("way"), u, 1e-10)
        near(f"{what}: the same forces", of_obstacle(moved)[:2],
             of_obstacle(still)[:2], 1e-9)
        centre = numpy.array([0., 0.] if shape == "plane" else [1.5, -3.])
        near(f"{what}: force and moment of the nodes", of_obstacle(moved),
             of_nodes("way", centre + (-DX, DY)), 1e-3)
        # The plane and the supports at rest here are the supports that move and
        # the plane at rest there.
        for work in ("external", "contact", "friction", "dissipation"):
            near(f"{what}: the same work, {work}",
                 moved["increments"][-1]["works"][work],
                 still["increments"][-1]["works"][work], 1e-8,
                 still["increments"][-1]["works"]["external"])


def displacements(name):
    return numpy.array([[row["displacement_x_mm"], row["displacement_y_mm"]]
                        for row in rows(name, "nodes.csv")])


def of_nodes(name, centre):
    """Force and moment of the nodes on the slave, by nodes.csv."""
    total = numpy.zeros(3)
    for row in rows(name, "nodes.csv"):
        f = [row[f"contact_force_{c}_N_per_mm"] for c in "xy"]
        x = [row[f"{c.upper()}_mm"] + row[f"displacement_{c}_mm"] - m
             for c, m in zip("xy", centre)]
        total += (*f, x[0] * f[1] - x[1] * f[0])
    return total


def carried_block():
    """Clamped by two planes that come closer, and turn together about a point
    beside the block."""
    centre, angle, squeeze = (5., -1.), 90., 0.05
    closer, turn = "min(1, 4*t)", f"{angle}*max(0, (4*t - 1)/3)"
    near_plane = {"Contact/Obstacle": "half plane: 0, 0, 0, 1",
                  "Contact/Obstacle centre": "5, -1",
                  "Contact/Obstacle motion": f"angle: {turn}"}
    for degree, system in itertools.product(
            (1, 2), ("saddle point", "condensed")):
        what = f"carried block, degree {degree}, {system}"
        entries = {
            **block("carried"), **near_plane, "Element/Degree": degree,
            "Solids/Kinematics": "large displacement",
            "Contact top/Slave": "Top",
            "Contact top/Obstacle": f"half plane: 0, {HEIGHT}, 0, -1",
            "Contact top/Obstacle centre": "5, -1",
            "Contact top/Friction coefficient": FRICTION,
            "Contact top/Obstacle motion":
            f"angle: {turn}; y: -{squeeze}*{closer}*cos({turn}*pi/180); "
            f"x: {squeeze}*{closer}*sin({turn}*pi/180)",
            "Solution/System": system, "Solution/Increments": 12,
            "Output/Nodes": "true"}
        scene(f"{what}, clamped", "carried", {
            **entries, "Contact/Obstacle motion": "angle: 0", "Contact top/Obstacle motion":
            f"y: -{squeeze}*{closer}"})
        clamped = places("carried")
        summary = scene(what, "carried", entries)
        a, R = numpy.array(centre), numpy.array([[0., -1.], [1., 0.]])
        near(f"{what}: goes along as a rigid body", places("carried"),
             a + (clamped - a) @ R.T, 1e-9)
        first, last = (summary["increments"][i]["works"] for i in (2, -1))
        near(f"{what}: and nothing works",
             [last[k] for k in last if k != "path"],
             [first[k] for k in first if k != "path"], 1e-9)


def places(name):
    return numpy.array([[row["X_mm"] + row["displacement_x_mm"],
                         row["Y_mm"] + row["displacement_y_mm"]]
                        for row in rows(name, "nodes.csv")])


ROUND = {"Contact/Obstacle": "circle: 2, -3, 3",
         "Contact/Obstacle motion": "y: 0.1*min(1, 4*t); "
                                    "angle: -10*max(0, (4*t - 1)/3)^2"}


def turning_circle():
    """Pressed into a block that is held at its top, then turned."""
    entries = {
        **block("turning", 16, 8), **ROUND,
        "Boundary conditions/Displacement x": "Top: 0",
        "Boundary conditions/Displacement y": "Top: 0",
        "Solids/Kinematics": "large displacement",
        "Solution/Increments": 20, "Output/Nodes": "true", "Output/Profile":
        "true", "Probes/Probes": "M: obstacle moment z, Contact"}
    for rule, system in itertools.product(
            ("nodal", "mortar"), ("saddle point", "condensed")):
        what = f"turning circle, {rule}, {system}"
        summary = scene(what, "turning", {
            **entries, "Contact/Discretization": rule,
            "Solution/System": system})
        steps = summary["increments"]
        zones = [i["contact"].get("", i["contact"]) for i in steps]
        check(f"{what}: it sticks first, slips at last",
              steps[5]["stick"] > 0 and steps[-1]["stick"] == 0 and
              steps[-1]["active"] > 4)
        # What the circle exerts on the block is along its turn.
        near(f"{what}: torque at full slip", of_obstacle(summary)[2],
             -FRICTION * 3. * zones[-1]["normal_force"], 1e-12)
        check(f"{what}: less before",
              0 < -zones[5]["obstacle_moment_z"] <
              0.9 * FRICTION * 3. * zones[5]["normal_force"])
        near(f"{what}: force and moment of the nodes", of_obstacle(summary),
             of_nodes("turning", (2., -2.9)), 1e-9)
        near(f"{what}: the probe", probes(summary)["M"],
             of_obstacle(summary)[2], 1e-14)
        last, before = steps[-1]["works"], steps[-2]["works"]
        angle = math.radians(10 * (1 - (14 / 15)**2))
        near(f"{what}: the work of the torque", last["external"] -
             before["external"], -of_obstacle(summary)[2] * angle, 1e-2)
        near(f"{what}: it is dissipated", last["dissipation"] -
             before["dissipation"], -of_obstacle(summary)[2] * angle, 1e-2)
    return entries, summary


def other_scenes(entries, plane):
    """The turning circle on two processes, turned, in other units, after a
    restart, and extruded."""
    entries = {**entries, "Contact/Discretization": "mortar",
               "Solution/System": "condensed"}
    wanted = of_obstacle(plane)
    near("turning circle on two processes",
         of_obstacle(scene("on two processes", "turning", entries, 2)), wanted,
         1e-9)
    angle = 37.
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    closer = "0.1*min(1, 4*t)"
    turned = of_obstacle(scene("turned", "turning", {
        **entries, "Mesh/Rotation": angle,
        "Contact/Obstacle": f"circle: {2 * c + 3 * s!r}, {2 * s - 3 * c!r}, 3",
        "Contact/Obstacle motion":
        f"x: {-s!r}*{closer}; y: {c!r}*{closer}; "
        "angle: -10*max(0, (4*t - 1)/3)^2"}))
    near("turning circle, the scene turned",
         (c * turned[0] + s * turned[1], -s * turned[0] + c * turned[1],
          turned[2]), wanted, 1e-9)
    in_metres = of_obstacle(scene("in metres", "turning", {
        **entries, "Mesh/Scale": 1e-3,
        "Solids/Young's modulus": "Block: 1e9",
        "Contact/Obstacle": "circle: 2e-3, -3e-3, 3e-3",
        "Contact/Obstacle motion":
        ROUND["Contact/Obstacle motion"].replace("0.1", "0.1e-3")}))
    near("turning circle, in metres and Pa", in_metres / (1e3, 1e3, 1), wanted,
         1e-9)

    mesh = Volumes()
    nx, ny = 16, 8
    mesh.block("Block", (nx, ny, 2), lambda r, s, t: (
        WIDTH * r, HEIGHT * s, THICKNESS * t))
    mesh.write("extruded")
    flat = {"Boundary conditions/Displacement z": "Block_z0: 0, Block_z1: 0",
            "Boundary conditions/Displacement x": "Block_y1: 0",
            "Boundary conditions/Displacement y": "Block_y1: 0",
            "Mesh/File": "extruded.msh", "Contact/Slave": "Block_y0",
            "Contact/Obstacle": "cylinder: 2, -3, 0.7, 0, 0, 1, 3",
            "Output/Profile": "false", "Probes/Probes": ""}
    for rule, shape in (("nodal", flat["Contact/Obstacle"]),
                        ("mortar", flat["Contact/Obstacle"]),
                        ("mortar", "profile: -1, -6, 3, 5, -6, 3, 5, 0, 3, "
                                   "-1, 0, 3, -1, -6, 3")):
        found = scene(f"extruded, {rule}, {shape}", "extruded", {
            **entries, **flat, "Contact/Obstacle": shape,
            "Contact/Obstacle centre": "2, -3, 0",
            "Contact/Discretization": rule})
        found = found["increments"][-1]["contact"]
        found = found.get("", found)
        near(f"turning {shape.split(':')[0]}, {rule}: as the circle",
             [found[f"obstacle_{k}"] / THICKNESS for k in
              ("force_x", "force_y", "moment_z")], wanted, 1e-9)


def held_block():
    """Pressed by a plane that then stays where it is: nothing is left to do."""
    for rule, kinematics in (("nodal", "small strain"),
                             ("mortar", "large displacement")):
        what = f"a plane comes to rest, {rule}, {kinematics}"
        summary = scene(what, "held", {
            **block("held"), "Contact/Slave": "Top",
            "Contact/Discretization": rule, "Solids/Kinematics": kinematics,
            "Boundary conditions/Displacement x": "Bottom: 0",
            "Boundary conditions/Displacement y": "Bottom: 0",
            "Contact/Obstacle": f"half plane: 0, {HEIGHT}, 0, -1",
            "Contact/Obstacle motion": "y: -0.02*min(1, 2*t)",
            "Solution/Newton tolerance": 1e-8, "Solution/Increments": 8})
        steps = [i["newton_iterations"] for i in summary["increments"]]
        check(what, len(steps) == 8 and max(steps[:4]) <= 4 and
              steps[4:] == [0] * 4, steps)


dragged_block()
held_block()
moved_the_other_way()
carried_block()
def profiles(entries, plane):
    """A square with corners so round that it is a circle, about a body or a hole;
    a straight line is a half plane."""
    def square(x, y, r, order):
        return "profile: " + ", ".join(
            f"{x + r * i}, {y + r * j}, {r}" for i, j in order)
    around = ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))
    near("profile: a round square is a circle", of_obstacle(scene(
        "round square", "profile", {
            **entries, "Contact/Obstacle": square(2, -3, 3, around),
            "Contact/Obstacle centre": "2, -3"})), of_obstacle(plane), 1e-9)
    way = {"Contact/Obstacle motion": "y: 0.1*t; x: 0.03*t^2",
           "Solution/Increments": 4}
    for what, shape, same in (
            ("a round square hole is a hole", "circle: 2, 29.9, -30",
             square(2, 29.9, 30, around[::-1])),
            ("a straight line is a half plane", "half plane: 0, 0, 0.1, 1",
             "profile: 0, 0, 0, -10, 1, 0")):
        found = [of_obstacle(scene(what, "profile", {
            **entries, **way, "Contact/Obstacle": obstacle,
            "Contact/Obstacle centre": "0, 0"})) for obstacle in (shape, same)]
        near(f"profile: {what}", found[1], found[0], 1e-9)
    for wrong in ("0, 0, 0", "0, 0, 0, 1, 0, 0, 1, 1, 0",
                  "0, 0, 0, 1, 0, 2, 1, 1, 2, 0, 1, 0", "0, 0, 1, 1, 0, 0"):
        status, said, _ = run("profile", {
            **entries, "Contact/Obstacle": f"profile: {wrong}"})
        check(f"profile: refused: {wrong}", status == 2 and "profile" in said,
              said)


def restarted(entries):
    """Ended from outside after some increments, and gone on with."""
    entries = {**entries, "Solution/Increments": 80}
    whole = scene("whole run", "restarted", entries)["increments"]
    file = pathlib.Path("output/restarted/restart.bin")
    with subprocess.Popen([contact, "restarted.prm", "--quiet"]) as started:
        while started.poll() is None and not file.exists():
            time.sleep(0.01)
        started.terminate()
    check("restart: the run was ended before its end", started.returncode == 5)
    ended = subprocess.run([contact, "restarted.prm", "--quiet", "--restart"],
                           capture_output=True, text=True)
    again = json.loads(pathlib.Path("output/restarted/summary.json")
                       .read_text())["increments"]
    check("restart: it goes on", ended.returncode == 0 and
          len(again) == len(whole), ended.stderr)
    for kind in ("contact", "works"):
        a, b = whole[-1][kind], again[-1][kind]
        a, b = a.get("", a), b.get("", b)
        near(f"restart: the same {kind}", [b[k] for k in sorted(b)],
             [a[k] for k in sorted(a)], 1e-10)


def spinning_sphere():
    """In 3-D, pressed into a block that is held at its top, then turned about
    an axis through its centre that is slanted by 60 degrees; as it is, and turned
    about all axes."""
    mesh = Volumes()
    mesh.block("Block", (6, 6, 2), lambda r, s, t: (
        4 * r - 2, 4 * s - 2, 1.5 * t))
    mesh.write("spinning")
    slant = math.radians(60)
    axis = numpy.array([math.sin(slant), 0., math.cos(slant)])
    centre, found = numpy.array([0.1, -0.2, -3.]), []
    for degrees, loop in itertools.product(
            ((0., 0., 0.), (20., -30., 40.)), ("Newton", "fixed point")):
        R = rotation(degrees)
        c, a, up = R @ centre, R @ axis, R @ (0., 0., 1.)
        what = f"spinning sphere, rotated by {degrees}, {loop}"
        summary = scene(what, "spinning", {
            "Mesh/File": "spinning.msh",
            "Mesh/Rotation": ", ".join(map(str, degrees)),
            "Solids/Young's modulus": "Block: 1000",
            "Solids/Poisson's ratio": "Block: 0.3",
            **{f"Boundary conditions/Displacement {k}": "Block_z1: 0"
               for k in "xyz"},
            "Contact/Slave": "Block_z0",
            "Contact/Friction coefficient": FRICTION,
            "Contact/Obstacle": "sphere: " + ", ".join(
                map(repr, (*map(float, c), 3.))),
            "Contact/Obstacle axis": ", ".join(map(repr, map(float, a))),
            "Contact/Obstacle motion": "; ".join(
                f"{k}: {float(0.15 * u)!r}*min(1, 4*t)"
                for k, u in zip("xyz", up)) + "; angle: 15*max(0, (4*t - 1)/3)",
            "Solution/Friction": loop, "Solution/Friction tolerance": 1e-10,
            "Solution/Increments": 12, "Output/Nodes": "true"})
        zone = summary["increments"][-1]["contact"]
        zone = zone.get("", zone)
        check(f"{what}: it slips at last",
              summary["increments"][-1]["stick"] == 0)
        forces = numpy.array([R.T @ [zone[f"obstacle_{k}_{x}"]
                                     for x in "xyz"]
                              for k in ("force", "moment")])
        found.append(forces)
        # Shears are along the motion of the surface, axis x r, but for the
        # displacements of the block within the increment.
        total, torque = numpy.zeros((2, 3)), 0.
        end = c + 0.15 * up
        for row in rows("spinning", "nodes.csv"):
            x = numpy.array([row[f"{k.upper()}_mm"] +
                             row[f"displacement_{k}_mm"] for k in "xyz"]) - end
            f = numpy.array([row[f"contact_force_{k}_N"] for k in "xyz"])
            total += (f, numpy.cross(x, f))
            torque += FRICTION * (f @ x / 3.) * numpy.linalg.norm(
                numpy.cross(a, x))
        near(f"{what}: force and moment of the nodes", forces,
             total @ R, 1e-9)
        near(f"{what}: the torque", forces[1] @ axis, torque, 2e-3)
    for k, loop in ((1, "fixed point"), (2, "turned"), (3, "turned, fixed point")):
        near(f"spinning sphere: the same, {loop}", found[k], found[0], 1e-8)


def ironing():
    """parameters/verification/ironing.prm in short, on cells of 2 mm: the work of
    the tool by its forces and motions, the energy by the probe."""
    mesh = Mesh()
    mesh.block("Block", 24, 4, box(0., -12., 48., 0.),
               {"bottom": "Bottom", "top": "Top"})
    mesh.write("ironing")
    missing = []
    for rule, increments in (("mortar", 48), ("mortar", 96), ("nodal", 48)):
        what = f"ironing, {rule}, {increments} increments"
        summary = scene(what, "ironing", {
            "Mesh/File": "ironing.msh", "Element/Degree": 2,
            "Solids/Young's modulus": "Block: 1",
            "Solids/Poisson's ratio": "Block: 0.3",
            "Solids/Material": "Block: neo-Hookean",
            "Boundary conditions/Displacement x": "Bottom: 0",
            "Boundary conditions/Displacement y": "Bottom: 0",
            "Contact/Slave": "Top", "Contact/Discretization": rule,
            "Contact/Friction coefficient": 0.3,
            "Contact/Obstacle": "circle: 20, 10, 10",
            "Contact/Obstacle motion":
            "y: -1.5*min(1, 3*t); x: 4*max(0, 3*t - 1)",
            "Solution/Increments": increments,
            "Probes/Probes": "stored: strain energy, Block"})
        steps = summary["increments"]
        check(f"{what}: at most 8 Newton steps, none cut", len(steps) ==
              increments and max(i["newton_iterations"] for i in steps) <= 8)
        zones = [i["contact"].get("", i["contact"]) for i in steps]
        forces, motions = (numpy.array([[0., 0.]] + [
            [zone[f"obstacle_{kind}_{x}"] for x in "xy"] for zone in zones])
            for kind in ("force", "motion"))
        # Of the tool on the block.
        work = numpy.sum((forces[1:] + forces[:-1]) / 2 * numpy.diff(motions, axis=0))
        stored = steps[-1]["probes"]["stored"]
        missing.append(work - stored - steps[-1]["works"]["dissipation"])
        late = forces[1:][motions[1:, 0] > 4]
        waves = numpy.ptp(late, axis=0) / 2 / abs(late.mean(axis=0))
        check(f"{what}: steady forces", waves.max() < 0.02, waves)
        check(f"{what}: stored, rubbed away", 0 < missing[-1] < 0.01 * work,
              f"{missing[-1] / work:.2%} of {work:.4f} missing")
    check("ironing: what is missing halves", 1.6 < missing[0] / missing[1] < 2.4,
          missing[0] / missing[1])


def refusals():
    base = {**block("refused"), "Contact/Obstacle": "circle: 2, -3, 3",
            "Boundary conditions/Displacement x": "Top: 0",
            "Boundary conditions/Displacement y": "Top: 0"}
    for wrong, named in (
            ({"Contact/Obstacle motion": "z: t"}, "no direction z"),
            ({"Contact/Obstacle motion": "turn: t"}, "'turn' is no motion"),
            ({"Contact/Obstacle motion": "x: t +"}, "is no formula"),
            ({"Contact/Obstacle motion": "x: 1/(1 - 2*t)"}, "infinite"),
            ({"Contact/Obstacle centre": "1, 2, 3"}, "no point"),
            ({"Contact/Obstacle motion": "x: t", "Contact/Obstacle axis":
              "0, 0, 1"}, "no direction in 3-D"),
            ({"Contact/Obstacle motion": "x: t", "Contact/Tied": "true",
              "Contact/Friction coefficient": 0}, "glued"),
            ({"Contact/Obstacle motion": "angle: t",
              "Solids/Symmetry": "axisymmetric"}, "along it"),
            ({"Probes/Probes": "F: obstacle force x, Bottom"}, "there is no"),
            ({"Probes/Probes": "F: obstacle force x, Contact",
              "Probes/Errors": "dual weighted residuals"}, "no dual problem")):
        status, said, _ = run("refused", {**base, **wrong})
        check(f"refused: {named}", status == 2 and named in said, said)


entries, turned_circle = turning_circle()
other_scenes(entries, turned_circle)
profiles(entries, turned_circle)
restarted(entries)
spinning_sphere()
ironing()
refusals()
print(len(failures), "failures")
sys.exit(1 if failures else 0)
