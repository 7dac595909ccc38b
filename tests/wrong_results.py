#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes whose results were wrong with exit status 0, or that crashed.

Proves that

- a block that friction alone carries stays on its base, with every loop of
  friction, and a stack of blocks is pressed, not thrown;
- an overlap goes, in any units, whether there are other forces or not, and
  displacements scale with the lengths;
- a cantilever bends as beam theory has it, in few Newton steps, without contact
  and with contact it never comes to;
- in two halves, one glued to the other, it does so, too;
- masters with teeth do not end in an error of the program, nor in much memory;
- a slave with lines of its master's own body is refused;
- loads that round-off swallows are named, and so are given displacements, for a
  body too stiff or a way too small; forces that add up to round-off are no error
  of the program;
- a contact zone that ends where supports hold both bodies converges, and one
  where slave and master end at the same place;
- slave nodes that supports hold or move along the surface carry shear, mu times
  the pressure where they slip, and are glued;
- a node in the corner of two obstacles with friction is no error, nor is one in
  the corner of a body that two pairs share; a slave much stiffer and finer than
  its master is noted;
- a block in a concave corner, with one surface around the corner of each body, is
  as with a contact pair for each side, whatever the number of increments;
- a mesh too coarse for a corner of the master, with most of the motion in the
  overlap, is noted, with the remedy;
- a block over the corner of another one, of which slave facets see a part in their
  middle, takes few steps, and has the same force with the roles exchanged, within
  the error of the mesh;
- a block on a larger one, turned, groups all around both, has no force before they
  touch and then that of the sole, with both discretizations and roles: a far side of
  a body is no overlap;
- the force of a point that is tied to a support is one of the support, on two
  processes as well;
- a slave node that is supported on one side only pushes along the normal of the
  surface, not along the direction that the support leaves free, and so does one
  of a surface that meets a symmetry line or a wall at a slant;
- two layers clamped in one wall share a load as beam theory has it, without a
  pressure in the wall;
- an obstacle that would go through its slave within an increment is cut off, and
  pushes;
- a circle that passes between two nodes unseen is a violation, of any radius and
  whatever its way until it touched, and so is a body that goes through a foil whose both sides are the master;
- nodes that come out from under the trailing corner of a sliding block have not gone
  through it;
- ridges that cross between all points of contact are told;
- a bar of St. Venant and Kirchhoff's material is as its law says, and no result where
  the law has none and cells shrink to nothing;
- a history that turns back inside an increment is noted, and so is an increment in
  which a shallow arch snaps through;
- a press fit of polygons that leave more open than it overlaps is a violation, and
  one of elements of degree 2 that are off their circle by as much is noted;
- the flat ends of round shafts are not said to be off their circles;
- glue across a gap is noted, and a violation where the moment that is lost matters;
- a scene that nothing loads, and one where nothing touches, are noted;
- nodes that supports hold inside of an obstacle are noted, and bodies that nothing
  holds at the end, along a line or where a gap has opened on both sides;
- the moment on an obstacle is that of the loads, in small strain where the pairing
  is undeformed, however far the block moves;
- a round side that a coarse mesh does not let touch is refined where it is close,
  on several processes alike, until it has the force of a uniform mesh;
- given displacements that go through zero in the course of their history violate
  nothing;
- loads follow their history as exactly if their nominal values are large, and
  forces of obstacles that round-off swallows are named;
- reactions of supports along normals are those of the probes on refined meshes,
  on several processes as well;
- a block in the edge of two rigid walls slides along it with friction of both, mu
  times the force of each, and comes to rest in the corner of three;
- slave nodes that slide off the end of the master, where they face it with one
  pairing and nothing with the next, are not called converged; the mortar
  discretization has a solution there;
- a body on a corner of its polygon that each pairing moves on is not called
  converged before it has come to rest, whatever the solver;
- the width of contact has the edge that closes a surface;
- a straight column is refused beyond Euler's load by systems with multipliers as
  well, and with friction it is noted.

Usage: wrong_results.py CONTACT PARAMETERS MESHES
"""

import itertools
import math
import sys

from block_scenes import (Mesh, box, check, failures, ring, rows, run,
                          violations)
from volume_scenes import Volumes


def solids(young="A: 1000, B: 1000", poisson="A: 0.3, B: 0.3",
           kinematics="small strain"):
    return {"Solids/Young's modulus": young, "Solids/Poisson's ratio": poisson,
            "Solids/Kinematics": kinematics}


CONTACT = {"Contact/Slave": "Sole", "Contact/Master": "Ground"}


def carried():
    """A pressed block on a base that moves by 0.1 mm: it goes along."""
    mesh = Mesh()
    mesh.block("A", 6, 2, box(-6, -5, 6, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 5, 2, box(-3, 0, 3, 4), {"bottom": "Sole", "top": "Head"})
    mesh.write("carried")
    for rule in ("mortar", "nodal", "Gauss"):
        for loop in ("fixed point", "Newton"):
            status, said, _ = run("carried", {
                "Mesh/File": "carried.msh", **solids(), **CONTACT,
                "Boundary conditions/Displacement x": "Base: 0.1",
                "Boundary conditions/Displacement y": "Base: 0",
                "Boundary conditions/Pressure": "Head: 1",
                "Contact/Discretization": rule, "Contact/Friction coefficient": "0.3",
                "Solution/Friction": loop, "Solution/System": "saddle point",
                "Output/Nodes": "true"})
            check(f"{rule}, friction by {loop}: converges", status == 0,
                  said[:300])
            if status == 0:
                block = [n for n in rows("carried", "nodes.csv")
                         if n["body"] == "B"]
                mean = sum(n["displacement_x_mm"] for n in block) / len(block)
                check("  it goes along with its base", abs(mean - 0.1) < 1e-3,
                      str(mean))


def overlap():
    """Two blocks that overlap by a hundredth of their height: the face goes to
    where the stresses of both are equal; in other units as well."""
    reference = None
    for length, young in ((1, 1e3), (1, 1e-9), (1e3, 210e3), (1e-3, 1e6)):
        mesh = Mesh()
        low = box(-6 * length, -4 * length, 6 * length, 0)
        high = box(-6 * length, -0.04 * length, 6 * length, 3.96 * length)
        mesh.block("A", 8, 4, low, {"bottom": "Base", "top": "Ground"})
        mesh.block("B", 7, 4, high, {"bottom": "Sole", "top": "Head"})
        mesh.write("overlap")
        for rule in ("mortar", "nodal", "Gauss"):
            status, said, summary = run("overlap", {
                "Mesh/File": "overlap.msh",
                **solids(f"A: {young}, B: {2 * young}"), **CONTACT,
                "Boundary conditions/Displacement x": "Base: 0, Head: 0",
                "Boundary conditions/Displacement y": "Base: 0, Head: 0",
                "Contact/Discretization": rule, "Solution/Increments": "1",
                "Output/Nodes": "true"})
            what = f"lengths times {length:g}, E = {young:g} MPa, {rule}"
            check(what + ": converges", status == 0, said[:300])
            if status != 0:
                continue
            face = [n["displacement_y_mm"] / length
                    for n in rows("overlap", "nodes.csv")
                    if n["body"] == "A" and abs(n["Y_mm"]) < 1e-9 * length]
            middle = sorted(face)[len(face) // 2]
            # E and 2 E: a third and two thirds of the overlap, but for the ends.
            check("  the overlap goes", -0.03 < middle < -0.02, str(middle))
            force = summary["contact"]["normal_force"] / length / young
            if rule == "mortar":
                reference = reference or force
                check("  the force scales", abs(force / reference - 1) < 1e-6,
                      f"{force} {reference}")


def cantilever():
    """100 x 5, E = 70000, nu = 0.3, F = 20 at the tip: 12 F L^3 (1 - nu^2) /
    (3 E h^3) up to the shortening of large displacements."""
    theory = 4 * 20 * 100**3 * (1 - 0.3**2) / (70000 * 5**3)
    for what, contact in (("without contact", {}),
                          ("with contact far away", {
                              "Contact/Slave": "Below",
                              "Contact/Obstacle": "half plane: 0, -50, 0, 1",
                              "Contact/Discretization": "nodal"})):
        mesh = Mesh()
        mesh.block("A", 40, 2, box(0, 0, 100, 5),
                   {"left": "Wall", "right": "Tip", "bottom": "Below"})
        mesh.write("cantilever")
        status, said, summary = run("cantilever", {
            "Mesh/File": "cantilever.msh",
            **solids("A: 70000", "A: 0.3", "large displacement"),
            "Element/Degree": "2",
            "Boundary conditions/Displacement x": "Wall: 0",
            "Boundary conditions/Displacement y": "Wall: 0",
            "Boundary conditions/Resultant force y": "Tip: -20",
            "Solution/Increments": "1", "Output/Nodes": "true", **contact})
        check(what + ": converges", status == 0, said[:300])
        if status == 0:
            steps = sum(i["newton_iterations"] for i in summary["increments"])
            check("  in few steps", steps <= 12, str(steps))
            tip = min(n["displacement_y_mm"]
                      for n in rows("cantilever", "nodes.csv"))
            check("  as beam theory has it", abs(tip / theory + 1) < 0.02,
                  f"{tip} {-theory}")


def halves():
    """The cantilever above in two halves, one clamped, the other glued to it: it
    turns in small strain as far as one in one piece."""
    theory = 4 * 0.5 * 20**3 / (1000 * 2**3)
    mesh = Mesh()
    mesh.block("A", 10, 2, box(0, 0, 10, 2), {"left": "Wall", "right": "Ground"})
    mesh.block("B", 10, 3, box(10, 0, 20, 2), {"left": "Sole", "right": "Tip"})
    mesh.write("halves")
    status, said, _ = run("halves", {
        "Mesh/File": "halves.msh", **solids(poisson="A: 0, B: 0"), **CONTACT,
        "Contact/Tied": "true", "Element/Degree": "2",
        "Boundary conditions/Displacement x": "Wall: 0",
        "Boundary conditions/Displacement y": "Wall: 0",
        "Boundary conditions/Resultant force y": "Tip: -0.5",
        "Output/Nodes": "true"})
    check("a glued half is held", status == 0, said[:300])
    if status == 0:
        tip = min(n["displacement_y_mm"] for n in rows("halves", "nodes.csv"))
        check("  bends as beam theory has it", abs(tip / theory + 1) < 0.02,
              f"{tip} {-theory}")


def teeth():
    """A block on combs: a slave edge faces several pieces of the master."""
    for n in (2, 3, 5):
        mesh = Mesh()
        for k in range(n):
            mesh.block("A", 2, 2, box(k * 10 / n, -2, (k + 0.6) * 10 / n, 0),
                       {"bottom": "Base", "top": "Ground"})
        mesh.block("B", 4, 2, box(0, 0, 10, 3), {"bottom": "Sole", "top": "Head"})
        mesh.write("teeth")
        for geometry in ("undeformed", "each step"):
            for system in ("condensed", "saddle point"):
                status, said, summary = run("teeth", {
                    "Mesh/File": "teeth.msh", **solids(), **CONTACT,
                    "Boundary conditions/Displacement x": "Base: 0, Head: 0.01",
                    "Boundary conditions/Displacement y": "Base: 0, Head: -0.1",
                    "Contact/Discretization": "mortar", "Solution/System": system,
                    "Solution/Geometry": geometry})
                check(f"{n} teeth, {geometry}, {system}: converges",
                      status == 0, said[:300])
                if status == 0:
                    check("  without much memory",
                          summary["peak_memory_mb"] < 1000)


def own_master():
    mesh = Mesh()
    mesh.block("A", 6, 2, box(-6, -5, 6, 0), {"bottom": "Sole", "top": "Ground"})
    mesh.block("B", 5, 2, box(-3, 0, 3, 4), {"bottom": "Sole", "top": "Head"})
    mesh.write("own_master")
    status, said, _ = run("own_master", {
        "Mesh/File": "own_master.msh", **solids(), **CONTACT,
        "Boundary conditions/Displacement x": "Sole: 0, Head: 0",
        "Boundary conditions/Displacement y": "Sole: 0, Head: -0.1"})
    check("lines of the master's own body are refused",
          status == 2 and "'A'" in said and "Contact/Slave" in said, said[:300])


def round_off():
    """1 N on a body 1e15 times as stiff as the one below it."""
    mesh = Mesh()
    mesh.block("A", 6, 2, box(-6, -5, 6, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 5, 2, box(-3, 0, 3, 4), {"bottom": "Sole", "top": "Head"})
    mesh.write("round_off")
    status, said, _ = run("round_off", {
        "Mesh/File": "round_off.msh", **solids("A: 1, B: 1e15"), **CONTACT,
        "Boundary conditions/Displacement x": "Base: 0, Head: 0",
        "Boundary conditions/Displacement y": "Base: 0",
        "Boundary conditions/Resultant force y": "Head: -0.1"})
    check("loads that round-off swallows are no result with status 0",
          status in (1, 3), f"{status} {said[:200]}")


def lost_ways():
    """A block pressed and dragged by given ways: one 1e14 times as stiff as the
    one below it, and ways of 1e-12 mm, which round-off swallows; ways of 1e-6 mm,
    which it does not."""
    mesh = Mesh()
    mesh.block("A", 8, 4, box(-10, -10, 10, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 6, 6, box(-5, 0, 5, 8), {"bottom": "Sole", "top": "Head"})
    mesh.write("lost_ways")
    for young, way, good in (("A: 1, B: 1e14", 0.1, False),
                             ("A: 1, B: 1e6", 0.1, True),
                             ("A: 7e4, B: 2.1e5", 1e-12, False),
                             ("A: 7e4, B: 2.1e5", 1e-6, True)):
        for solver in ("CHOLMOD", "AMG", "GMG"):
            if solver != "CHOLMOD" and young.startswith("A: 1,") or (
                    solver == "CHOLMOD" and not good and young[3] == "7"):
                continue  # stalls; has them
            status, said, _ = run("lost_ways", {
                "Mesh/File": "lost_ways.msh", "Mesh/Refinements": "1",
                **solids(young, kinematics="large displacement"), **CONTACT,
                "Element/Degree": "2", "Element/Centre node": "free",
                "Contact/Friction coefficient": "0.3",
                "Boundary conditions/Displacement x": f"Base: 0, Head: {way}",
                "Boundary conditions/Displacement y": f"Base: 0, Head: {-way}",
                "Solution/Linear solver": solver, "Solution/System": "condensed",
                "Solution/Newton tolerance": "1e-11"})
            check(f"{young}, {way} mm, {solver}: " +
                  ("a result" if good else "no result with status 0"),
                  status == 0 if good else
                  status == 3 or status == 1 and "violated: resolution" in said,
                  f"{status} {said[:300]}")


def on_a_corner():
    """A cap of chords of a parabola, pressed by a force, on a block: a symmetric
    scene, and no horizontal force."""
    mesh = Mesh()
    mesh.block("A", 4, 2, box(-10, -10, 10, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 4, 3, lambda s, t: (
        -5 + 10 * s, (1 - t) * (10 * s - 5)**2 / 40 + 8 * t + 0.01 * (1 - t)),
        {"bottom": "Sole", "top": "Head"})
    mesh.add(0, "T", (15 + 3 + 5 * 3,))
    mesh.write("on_a_corner")
    for solver in ("CHOLMOD", "AMG", "GMG"):
        status, said, summary = run("on_a_corner", {
            "Mesh/File": "on_a_corner.msh", "Mesh/Refinements": "3",
            **solids("A: 70000, B: 210000", kinematics="large displacement"),
            **CONTACT, "Element/Degree": "2", "Element/Centre node": "free",
            "Boundary conditions/Displacement x": "Base: 0, T: 0",
            "Boundary conditions/Displacement y": "Base: 0",
            "Boundary conditions/Resultant force y": "Head: -2500",
            "Solution/Increments": "1", "Solution/Max cut-backs": "0",
            "Solution/Linear solver": solver, "Solution/System": "condensed",
            "Solution/Newton tolerance": "1e-11"})
        drift = abs(summary["increments"][-1]["reactions"]["Base"]["x"])
        check(f"a cap on its corner, {solver}: converges", status == 0, said[:300])
        check("  without a horizontal force", drift < 1e-6 * 2500, str(drift))


def beyond_round_off():
    """No invariant is smaller than round-off, whatever Newton's tolerance."""
    mesh = Mesh()
    mesh.block("A", 6, 2, box(-6, -5, 6, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 5, 2, box(-3, 0, 3, 4), {"bottom": "Sole", "top": "Head"})
    mesh.write("beyond_round_off")
    status, said, _ = run("beyond_round_off", {
        "Mesh/File": "beyond_round_off.msh", **solids(), **CONTACT,
        "Boundary conditions/Displacement x": "Base: 0, Head: 0.05",
        "Boundary conditions/Displacement y": "Base: 0, Head: -0.1",
        "Contact/Friction coefficient": "0.3",
        "Solution/Newton tolerance": "1e-18"})
    check("a tolerance below round-off violates nothing",
          status == 0 and "violated" not in said, f"{status} {said[:300]}")


def held_ends():
    """Two leaves, one above the other, their left ends clamped; and a slave
    that reaches beyond its master, both with nodes where that ends."""
    mesh = Mesh()
    mesh.block("A", 10, 2, box(0, -4, 100, 0), {"left": "Wall", "top": "Ground"})
    mesh.block("B", 10, 2, box(0, 0, 100, 4),
               {"left": "Wall", "bottom": "Sole", "right": "Tip"})
    mesh.write("leaves")
    for rule in ("nodal", "mortar"):
        status, said, _ = run("leaves", {
            "Mesh/File": "leaves.msh", **solids(), **CONTACT,
            "Boundary conditions/Displacement x": "Wall: 0",
            "Boundary conditions/Displacement y": "Wall: 0",
            "Boundary conditions/Resultant force y": "Tip: -0.01",
            "Contact/Discretization": rule})
        check(f"leaves, {rule}: converges", status == 0, said[:300])

    mesh = Mesh()
    mesh.block("A", 8, 4, box(-20, -10, 20, 0), {"bottom": "Base", "top": "Top"})
    mesh.block("B", 5, 3, box(-10, 0, 10, 8), {"bottom": "Foot", "top": "Head"})
    mesh.write("ends")
    for rule in ("nodal", "mortar"):
        status, said, summary = run("ends", {
            "Mesh/File": "ends.msh", **solids(), "Contact/Slave": "Top",
            "Contact/Master": "Foot", "Contact/Friction coefficient": "0.3",
            "Boundary conditions/Displacement x": "Base: 0, Head: 0.02",
            "Boundary conditions/Displacement y": "Base: 0, Head: -0.1",
            "Contact/Discretization": rule})
        check(f"a slave longer than its master, {rule}: converges", status == 0,
              said[:300])
        steps = sum(i["newton_iterations"] for i in summary["increments"])
        check("  in few steps", steps <= 30, str(steps))


def shares(summary):
    """Normal and tangential force of contact [N/mm]."""
    contact = summary["contact"]
    return contact["normal_force"], abs(contact["tangential_force"])


def dragged():
    """A block under 10 MPa, dragged by its side, over an obstacle and over a base
    whose slave is held at its ends: all of it slips, and the shear is mu times
    the pressure at supported nodes as well."""
    for shapes, ground in (("half plane", {
            "Contact/Slave": "Sole",
            "Contact/Obstacle": "half plane: 0, 0, 0, 1"}),
                           ("master", CONTACT),
                           ("slave held", {"Contact/Slave": "Ground",
                                           "Contact/Master": "Sole"})):
        mesh = Mesh()
        mesh.block("B", 10, 3, box(-5, 0, 5, 3),
                   {"bottom": "Sole", "top": "Head", "left": "Side"})
        if shapes != "half plane":
            mesh.block("A", 16, 3, box(-8, -4, 8, 0),
                       {"bottom": "Base", "top": "Ground", "left": "End",
                        "right": "Other end"})
        mesh.write("dragged")
        base = shapes != "half plane"
        for rule in ("mortar", "nodal"):
            for degree in ("1", "2"):
                for kinematics in ("small strain", "large displacement"):
                    status, said, summary = run("dragged", {
                        "Mesh/File": "dragged.msh",
                        **solids(*(() if base else ("B: 1000", "B: 0.3")),
                                 kinematics=kinematics), **ground,
                        "Element/Degree": degree,
                        "Boundary conditions/Displacement x": "Side: 0.5" + (
                            ", Base: 0, End: 0, Other end: 0" if base else ""),
                        **({"Boundary conditions/Displacement y": "Base: 0"}
                           if base else {}),
                        "Boundary conditions/Pressure": "Head: 10",
                        "Contact/Discretization": rule,
                        "Contact/Friction coefficient": "0.3"})
                    what = f"{shapes}, {rule}, degree {degree}, {kinematics}"
                    # The end of the master goes down between two nodes.
                    is_told = "nodal" in what and status == 1 and \
                        said.count("violated: ") == said.count("violated: depth")
                    check(what + ": converges", status == 0 or is_told,
                          said[:300])
                    if status == 0:
                        normal, shear = shares(summary)
                        check("  T = mu N", abs(shear - 0.3 * normal) <
                              1e-6 * normal, f"{shear} of {normal}")


def driven():
    """A foundation whose surface supports press against a block and move along
    it: it slips under mu N, or is glued, whichever side is the slave."""
    glue = {}
    for slave, master in (("Sole", "Ground"), ("Ground", "Sole")):
        for tied in (False, True):
            mesh = Mesh()
            mesh.block("A", 11, 4, box(-8, -4, 8, 0),
                       {"bottom": "Base", "top": "Ground"})
            mesh.block("B", 10, 3, box(-5, 0, 5, 3),
                       {"bottom": "Sole", "top": "Head"})
            mesh.write("driven")
            status, said, summary = run("driven", {
                "Mesh/File": "driven.msh", **solids(), "Contact/Slave": slave,
                "Contact/Master": master,
                **({"Contact/Tied": "true"} if tied else
                   {"Contact/Friction coefficient": "0.3"}),
                "Boundary conditions/Displacement x": "Ground: 0.05, Head: 0",
                "Boundary conditions/Displacement y": "Ground: 0.01, Head: 0"})
            what = f"slave {slave}" + (", tied" if tied else "")
            check(what + ": converges", status == 0, said[:300])
            if status == 0:
                normal, shear = shares(summary)
                if tied:
                    glue[slave] = shear
                else:
                    check("  T = mu N", abs(shear - 0.3 * normal) < 1e-6 * normal,
                          f"{shear} of {normal}")
    # Other meshes at the interface: the difference is that of discretization.
    check("glue holds from either side",
          len(glue) == 2 and abs(glue["Sole"] / glue["Ground"] - 1) < 0.05,
          str(glue))


def cornered():
    """A block pressed into the corner of a rigid floor and a rigid wall: the node
    in the corner is held by two normals, its shear is redundant."""
    for rule in ("mortar", "nodal"):
        for mu in (0.05, 0.3):
            mesh = Mesh()
            mesh.block("B", 6, 5, box(0, 0, 10, 8),
                       {"bottom": "Sole", "top": "Head", "left": "Side",
                        "right": "Front"})
            mesh.write("cornered")
            status, said, summary = run("cornered", {
                "Mesh/File": "cornered.msh", **solids("B: 1000", "B: 0.3"),
                "Contact/Slave": "Sole",
                "Contact/Obstacle": "half plane: 0, 0, 0, 1",
                "Contact/Friction coefficient": str(mu),
                "Contact/Discretization": rule,
                "Contact wall/Slave": "Side",
                "Contact wall/Obstacle": "half plane: 0, 0, 1, 0",
                "Contact wall/Friction coefficient": str(mu),
                "Contact wall/Discretization": rule,
                "Boundary conditions/Pressure": "Head: 10; Front: 6"})
            check(f"{rule}, mu = {mu}: converges", status == 0, said[:300])
            if status != 0:
                continue
            floor, wall = summary["contact"], summary["contact wall"]
            for of, on, force in ((floor, wall, 100), (wall, floor, 48)):
                both = of["normal_force"] + abs(on["tangential_force"])
                check("  balance of forces", abs(both - force) < 1e-6 * force,
                      f"{both} of {force}")
                check("  within the cone", abs(of["tangential_force"]) <=
                      mu * of["normal_force"] * (1 + 1e-9))


def in_a_corner():
    """The same in the corner of a deformable frame: the node in the corner is
    a slave of both pairs. The pressures are carried, by either system."""
    mesh = Mesh()
    mesh.block("B", 6, 5, box(0, 0, 10, 8),
               {"bottom": "Sole", "top": "Head", "left": "Side",
                "right": "Front"})
    for part, sides in ((box(0, -4, 15, 0), {"top": "Floor", "bottom": "Base"}),
                        (box(-4, 0, 0, 12), {"right": "Wall"}),
                        (box(-4, -4, 0, 0), {"bottom": "Base"})):
        wide = part(1, 1)[0] - part(0, 0)[0]
        high = part(1, 1)[1] - part(0, 0)[1]
        mesh.block("F", max(2, round(wide / 2)), max(2, round(high / 2)), part,
                   sides)
    block = mesh.nodes[:42]
    # The frame is one part; the block has nodes of its own.
    mesh.nodes[:42] = [(x, y + 1000) for x, y in block]
    mesh.merge()
    mesh.nodes[:42] = block
    mesh.write("in_a_corner")
    for rule in ("mortar", "nodal"):
        for system in ("automatic", "condensed"):
            status, said, summary = run("in_a_corner", {
                "Mesh/File": "in_a_corner.msh",
                **solids("B: 3000, F: 1000", "B: 0.3, F: 0.3"),
                "Boundary conditions/Displacement x": "Base: 0",
                "Boundary conditions/Displacement y": "Base: 0",
                "Boundary conditions/Pressure": "Head: 4; Front: 2",
                "Contact/Slave": "Sole", "Contact/Master": "Floor",
                "Contact/Friction coefficient": "0.2",
                "Contact/Discretization": rule,
                "Contact wall/Slave": "Side", "Contact wall/Master": "Wall",
                "Contact wall/Friction coefficient": "0.2",
                "Contact wall/Discretization": rule,
                "Solution/System": system})
            check(f"{rule}, {system}: converges", status == 0, said[:400])
            if status != 0:
                continue
            force = summary["increments"][-1]["reactions"]["Base"]
            check("  the base carries the pressures",
                  abs(force["x"] - 16) + abs(force["y"] - 40) < 1e-6, str(force))


def frame_in_plane(names):
    """A frame with a concave corner at the origin, and a block 0.3 mm off it."""
    mesh = Mesh()
    for part, sides, n in (
            (box(0, -2, 6, 0), {"top": names[1], "bottom": "Base_y"}, (4, 2)),
            (box(-2, 0, 0, 6), {"right": names[0], "left": "Base_x"}, (2, 4)),
            (box(-2, -2, 0, 0), {"left": "Base_x", "bottom": "Base_y"}, (2, 2))):
        mesh.block("F", *n, part, sides)
    mesh.merge()
    mesh.block("B", 3, 3, box(0.3, 0.3, 4.3, 4.3),
               {"left": "B" + names[0], "bottom": "B" + names[1],
                "right": "Head_x", "top": "Head_y"})
    mesh.write("frame")


def frame_in_space(names):
    """The same with three walls."""
    mesh = Volumes()
    for part in itertools.product((0, 1), repeat=3):
        if all(part):
            continue
        sides = {}
        for d in range(3):
            if not part[d]:
                sides["xyz"[d] + "0"] = "Base_" + "xyz"[d]
                if sum(part) == 2:
                    sides["xyz"[d] + "1"] = names[d]
        mesh.block("F", tuple(4 if p else 1 for p in part),
                   lambda *r, part=part: tuple(
                       6 * x if p else 2 * x - 2 for p, x in zip(part, r)),
                   sides, {})
    mesh.block("B", (3, 3, 3),
               lambda *r: tuple(0.3 + 4 * x for x in r),
               {**{"xyz"[d] + "0": names[d] for d in range(3)},
                **{"xyz"[d] + "1": "Head_" + "xyz"[d] for d in range(3)}}, {})
    mesh.write("frame")


def concave_corner():
    """A block pressed into a concave corner, by different ways along the axes."""
    for space, exchanged, degree, n, friction in (
            *itertools.product((False, True), (False, True), ("1", "2"), (1, 3),
                               (0,)),
            (False, False, "1", 1, 0.3)):  # two points at a node stick
        if space and degree == "2" and n > 1:
            continue
        axes = "xyz" if space else "xy"
        names = ("Wall", "Floor", "Back")
        forces = []
        for one in (True, False):
            groups = ("In",) * 3 if one else names
            (frame_in_space if space else frame_in_plane)(groups)
            body = (lambda b, g: f"{b}_{g}") if space else (
                lambda b, g: g if b == "F" else b + g)
            contact = {}
            for name in ("In",) if one else names[:len(axes)]:
                section = "Contact" if one else "Contact " + name
                roles = ("F", "B") if exchanged else ("B", "F")
                contact |= {section + "/Slave": body(roles[0], name),
                            section + "/Master": body(roles[1], name),
                            section + "/Discretization": "nodal",
                            section + "/Friction coefficient": friction}
            base, head = ("F_Base_", "B_Head_") if space else ("Base_", "Head_")
            status, said, summary = run("frame", {
                "Mesh/File": "frame.msh", "Element/Degree": degree,
                **solids("F: 1000, B: 1000", "F: 0, B: 0",
                         "large displacement"), **contact,
                **{f"Boundary conditions/Displacement {x}":
                   f"{base}{x}: 0, {head}{x}: {-0.34 - 0.04 * k}"
                   for k, x in enumerate(axes)},
                "Solution/Increments": n})
            what = (f"{'space' if space else 'plane'}, slave "
                    f"{'frame' if exchanged else 'block'}, degree {degree}, "
                    f"increments {n}, {'one surface' if one else 'by sides'}"
                    f"{', friction' if friction else ''}")
            # With long edges corners of the master go down between the nodes.
            is_told = exchanged and degree == "1" and status == 1 and \
                said.count("violated: ") == said.count("violated: depth")
            check(what + ": converges", status == 0 or is_told, said[-400:])
            if status == 0 or is_told:
                force = summary["increments"][-1]["reactions"]
                forces.append([force[base + x][x] for x in axes])
        if len(forces) == 2:
            off = max(abs(a - b) for a, b in zip(*forces)) / max(
                map(abs, forces[1]))
            check("  the forces are the same", off < 1e-6, str(forces))


def too_coarse():
    """A small block on a plate with one node below it: the corners of its sole have
    points, the edges between them go down between the nodes: a violation."""
    mesh = Volumes()
    mesh.block("Low", (4, 4, 3),
               lambda r, s, t: (6 * r - 3, 6 * s - 3, 3 * t - 3))
    mesh.block("Up", (2, 2, 2), lambda r, s, t: (2 * r - 1, 2 * s - 1, 1.5 * t))
    mesh.write("too_coarse")
    forces = {}
    for rule, refinements, noted in (
            ("nodal", 0, True), ("nodal", 1, False), ("mortar", 0, False)):
        status, said, summary = run("too_coarse", {
            "Mesh/File": "too_coarse.msh", "Mesh/Refinements": refinements,
            **solids("Low: 3000, Up: 1000", "Low: 0.3, Up: 0.3"),
            "Contact/Slave": "Low_z1", "Contact/Master": "Up_z0",
            "Contact/Discretization": rule,
            **{f"Boundary conditions/Displacement {x}":
               f"Low_z0: 0, Up_z1: {way}"
               for x, way in (("x", 0), ("y", 0), ("z", -0.03))}})
        what = f"{rule}, refined {refinements} times"
        check(what + (": a violated invariant" if noted else ": converges"),
              status == noted and noted == ("violated: depth" in said and
                                            "refine the slave" in said and
                                            "off by a factor" in said),
              said[-500:])
        forces[rule, refinements] = summary["increments"][-1][
            "reactions"]["Low_z0"]["z"]
    check("  refined it is right, unrefined it is not",
          abs(forces["nodal", 1] / forces["mortar", 0] - 1) < 0.2 and
          forces["nodal", 0] < 0.5 * forces["mortar", 0], str(forces))


def over_rim():
    """A block over a corner of another one, shifted along it, groups round the
    edges, mortar: parts of the master lie within facets of the slave, which have
    one multiplier there. Each role in 20 steps, the same force within the error of
    the mesh."""
    lean = 0.0022
    mesh = Volumes()
    mesh.block("Low", (2, 2, 1),
               lambda r, s, t: (10 * r + 5 * lean * t, 10 * s, 5 * t - 5),
               sides={"z0": "Base", "z1": "In", "x1": "In", "y1": "In"})
    mesh.block("Up", (3, 3, 2), lambda r, s, t: (
        3.12 + 8 * r + 5 * lean * t, 7.44 + 8 * s, 0.19 + 5 * t),
               sides={"z1": "Head", "z0": "Out", "x0": "Out", "y0": "Out"})
    mesh.write("over_rim")
    forces = {}
    for levels in (1, 2):
        for slave, master in (("Low_In", "Up_Out"), ("Up_Out", "Low_In")):
            status, said, summary = run("over_rim", {
                "Mesh/File": "over_rim.msh", "Refinement/Levels": levels,
                **solids("Low: 2500, Up: 70000", "Low: 0.38, Up: 0.33"),
                "Contact/Slave": slave, "Contact/Master": master,
                "Contact/Discretization": "mortar",
                **{f"Boundary conditions/Displacement {x}":
                   f"Low_Base: 0, Up_Head: {way}"
                   for x, way in (("x", 0.19), ("y", 0.02), ("z", -0.36))}})
            what = f"slave {slave}, {levels} levels"
            check(what + ": converges", status == 0, said[-500:])
            if status == 0:
                last = summary["increments"][-1]
                check("  in 20 steps", last["newton_iterations"] <= 20, str(last))
                forces[levels, slave] = last["reactions"]["Low_Base"]["z"]
    if len(forces) == 4:
        def of(levels):
            return [forces[levels, slave] for slave in ("Low_In", "Up_Out")]
        off = abs(of(2)[0] / of(2)[1] - 1)
        error = max(abs(a / b - 1) for a, b in zip(of(1), of(2)))
        check("  roles exchanged: within the error of the mesh", off < error,
              str(forces))


def far_sides():
    """A block on a larger one, turned by 0.3 rad, groups all around both: the flanks
    of one face far sides of the other, through the bodies, also where the block slides
    further than it is thick."""
    around = dict.fromkeys(("x0", "x1", "y0", "y1"), "All")
    c, s = math.cos(0.3), math.sin(0.3)

    def turned(r, s_, t):
        r, s_ = r - 0.5, s_ - 0.5
        return 1.2 + c * r - s * s_, 1.9 + s * r + c * s_, t
    forces = {}
    for gap, way, slide, flanks in (
            (0.01, 0, 0, around), (0, -0.03, 0.5, {}), (0, -0.03, 0.5, around),
            (0, -0.03, 1.5, {}), (0, -0.03, 1.5, around)):
        mesh = Volumes()
        mesh.block("Low", (2, 2, 1), lambda r, s, t: (4 * r, 4 * s, 2 * t - 2),
                   sides={"z0": "Base", "z1": "All", **flanks})
        mesh.block("Up", (2, 2, 2), lambda r, s, t: turned(r, s, t + gap),
                   sides={"z1": "Head", "z0": "All", **flanks})
        mesh.write("far_sides")
        for discretization in ("nodal", "mortar"):
            for slave, master in (("Up_All", "Low_All"), ("Low_All", "Up_All")):
                status, said, summary = run("far_sides", {
                    "Mesh/File": "far_sides.msh",
                    **solids("Low: 1000, Up: 1000", "Low: 0.3, Up: 0.3"),
                    "Contact/Slave": slave, "Contact/Master": master,
                    "Contact/Discretization": discretization,
                    "Boundary conditions/Displacement x":
                        f"Low_Base: 0, Up_Head: {slide}",
                    "Boundary conditions/Displacement y": "Low_Base: 0, Up_Head: 0",
                    "Boundary conditions/Displacement z":
                        f"Low_Base: 0, Up_Head: {way}"})
                what = (f"{discretization}, slave {slave}, gap {gap}, slid {slide}"
                        f"{'' if flanks else ', sole alone'}")
                # Edges of the master may sink into a slave that is coarser.
                sinks = discretization == "nodal" and slave == "Low_All" and way
                check(what + ": status", status == (1 if sinks else 0), said[-500:])
                if status != 0:
                    continue
                force = summary["increments"][-1]["reactions"]["Low_Base"]
                if not way:
                    check("  no force", max(map(abs, force.values())) < 1e-9,
                          str(force))
                else:
                    alone = forces.setdefault((discretization, slave, slide), force)
                    off = max(abs(force[x] - alone[x]) for x in "xyz")
                    check("  that of the sole alone", off < 0.02 * alone["z"],
                          f"{force} {alone}")


def roles():
    """A slave much stiffer and finer than its master is noted."""
    mesh = Mesh()
    mesh.block("A", 4, 2, box(0, 0, 8, 4), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 9, 2, box(1, 4, 7, 6), {"bottom": "Sole", "top": "Head"})
    mesh.write("roles")
    for slave, master, young, noted in (
            ("Sole", "Ground", "A: 1000, B: 9000", True),
            ("Sole", "Ground", "A: 1000, B: 1000", False),
            ("Ground", "Sole", "A: 1000, B: 9000", False)):
        status, said, _ = run("roles", {
            "Mesh/File": "roles.msh", **solids(young, "A: 0.3, B: 0.3"),
            "Boundary conditions/Displacement x": "Base: 0, Head: 0",
            "Boundary conditions/Displacement y": "Base: 0, Head: -0.01",
            "Contact/Slave": slave, "Contact/Master": master})
        check(f"slave {slave}, {young}: {'a' if noted else 'no'} note",
              status == 0 and ("stiffer than its master" in said) == noted,
              said[:300])


def tied():
    """A point that follows a support in y: its force is one of the support, on
    one process and on two."""
    mesh = Mesh()
    mesh.block("A", 8, 4, box(0, 0, 8, 4),
               {"bottom": "Base"})
    for x, name in ((0, "Left"), (8, "Right")):
        mesh.add(0, name, (mesh.nodes.index((x, 4)) + 1,))
    mesh.write("tied")
    for ranks in (1, 2):
        for degree in ("1", "2"):
            status, said, summary = run("tied", {
                "Mesh/File": "tied.msh", **solids("A: 1000", "A: 0.3"),
                "Element/Degree": degree,
                "Boundary conditions/Displacement x": "Base: 0",
                "Boundary conditions/Displacement y": "Base: 0, Left: -0.1",
                "Boundary conditions/Tied y": "Right: Left"}, ranks)
            check(f"degree {degree}, {ranks} processes: converges", status == 0,
                  said[:400])
            if status == 0:
                force = summary["increments"][-1]["reactions"]
                check("  the reactions are in balance", force["Left"]["y"] < -1 and
                      abs(force["Left"]["y"] + force["Base"]["y"]) < 1e-9 *
                      force["Base"]["y"], str(force))


def flank():
    """A half wedge without friction, pushed by supports of its head, whose last
    node is on the flank too: that node pushes along the flank's normal as the
    others do. It is no symmetry line, which the other side of the wedge is."""
    slope = math.tan(math.radians(15))
    mesh = Mesh()
    mesh.block("W", 4, 5, lambda s, t: (s * (3 + 8 * t * slope), 8 * t),
               {"left": "Middle", "right": "Flank", "top": "Head"})
    mesh.block("A", 4, 7, lambda s, t: (
        (1 - s) * (3 + (9.6 * t - 0.8) * slope) + 12 * s, 9.6 * t - 0.8),
               {"left": "Seat", "right": "Outer"})
    mesh.write("flank")
    for slave, master in (("Flank", "Seat"), ("Seat", "Flank")):
        for rule in ("mortar", "nodal", "Gauss"):
            for degree in ("1", "2"):
                status, said, summary = run("flank", {
                    "Mesh/File": "flank.msh",
                    **solids("W: 1000, A: 5000", "W: 0.3, A: 0.3"),
                    "Element/Degree": degree,
                    "Boundary conditions/Displacement x": "Middle: 0, Outer: 0",
                    "Boundary conditions/Displacement y":
                        "Head: -0.01, Outer: 0",
                    "Contact/Slave": slave, "Contact/Master": master,
                    "Contact/Discretization": rule})
                what = f"slave {slave}, {rule}, degree {degree}"
                check(what + ": converges", status == 0, said[:300])
                if status == 0:
                    force = summary["increments"][-1]["reactions"]["Outer"]
                    turned = abs(force["y"] / force["x"]) - slope
                    check("  it pushes along the normal of the flank",
                          abs(turned) < 1e-3, str(turned))


def slanted(slope):
    """Two blocks whose interface meets the line x = 0 at a slant."""
    mesh = Mesh()
    mesh.block("A", 5, 3, lambda s, t: (8 * s, -6 + t * (8 * slope * s + 6)),
               {"bottom": "Base", "left": "Line", "right": "Side",
                "top": "Ground"})
    mesh.block("B", 4, 3,
               lambda s, t: (8 * s, 8 * slope * s + t * (8 - 8 * slope * s)),
               {"bottom": "Sole", "left": "Wall", "right": "Side",
                "top": "Head"})
    mesh.write("slanted")


def groove():
    """A half tongue in a half groove that meets the symmetry line at a slant,
    under the same pressure all around: so is the pressure of contact, at the
    node on the line as well."""
    for slope in (0.5, -0.4):
        slanted(slope)
        for slave, master in (("Sole", "Ground"), ("Ground", "Sole")):
            for degree in ("1", "2"):
                for mu in ("0", "0.3"):
                    status, said, _ = run("slanted", {
                        "Mesh/File": "slanted.msh",
                        **solids("A: 1e6, B: 1e6"), "Element/Degree": degree,
                        "Contact/Slave": slave, "Contact/Master": master,
                        "Contact/Friction coefficient": mu,
                        "Boundary conditions/Displacement x": "Line: 0, Wall: 0",
                        "Boundary conditions/Displacement y": "Base: 0",
                        "Boundary conditions/Pressure": "Side: 1; Head: 1",
                        "Output/Profile": "true"})
                    what = f"{slope}, slave {slave}, degree {degree}, mu = {mu}"
                    check(what + ": converges", status == 0, said[:300])
                    if status == 0:
                        off = max(abs(row["pressure_MPa"] - 1)
                                  for row in rows("slanted")
                                  if row["surface"] == "slave")
                        check("  the pressure is the same everywhere",
                              off < 1e-5, str(off))


def slide():
    """A block slides along a slope between walls, which are no symmetry lines:
    statics gives the force on its wall, V tan(slope - phi)."""
    for slope in (0.1, -0.2):
        slanted(slope)
        for mu in (0, 0.05):
            for geometry in ("automatic", "undeformed"):
                for degree in ("1", "2"):
                    away = -0.02 if slope > 0 else 0.02
                    status, said, summary = run("slanted", {
                        "Mesh/File": "slanted.msh",
                        **solids("A: 1e5, B: 1e5"), "Element/Degree": degree,
                        **CONTACT, "Contact/Friction coefficient": str(mu),
                        "Solution/Geometry": geometry,
                        "Boundary conditions/Displacement x":
                            f"Line: 0, Wall: {away}",
                        "Boundary conditions/Displacement y": "Base: 0",
                        "Boundary conditions/Pressure": "Head: 1"})
                    what = f"{slope}, mu = {mu}, {geometry}, degree {degree}"
                    check(what + ": converges", status == 0, said[:300])
                    if status == 0:
                        wall = summary["increments"][-1]["reactions"]["Wall"]
                        force = 8 * math.tan(math.atan(slope) -
                                             math.copysign(math.atan(mu), slope))
                        check("  the wall carries what statics says",
                              abs(wall["x"] - force) < 2e-3 * 8,
                              f"{wall['x']} {force}")


def pinned():
    """A block under 10 MPa, one corner of which a support pushes into the base:
    the support is along the normal, which stays that of the surface."""
    for rule in ("mortar", "nodal"):
        for depth in (0.01, 0.03, 0.1):
            mesh = Mesh()
            mesh.block("A", 10, 2, box(-20, -5, 20, 0),
                       {"bottom": "Base", "top": "Ground"})
            mesh.block("B", 5, 3, box(-5, 0, 5, 5),
                       {"bottom": "Sole", "top": "Head", "right": "Side",
                        "corner": "Pin"})
            mesh.write("pinned")
            status, said, summary = run("pinned", {
                "Mesh/File": "pinned.msh", **solids(), **CONTACT,
                "Boundary conditions/Displacement x": "Base: 0, Side: 0",
                "Boundary conditions/Displacement y": f"Base: 0, Pin: -{depth}",
                "Boundary conditions/Pressure": "Head: 10",
                "Contact/Discretization": rule})
            what = f"{rule}, {depth} mm"
            check(what + ": converges", status == 0, said[:300])
            if status == 0:
                force = summary["increments"][-1]["reactions"]
                check("  balance of forces", abs(
                    force["Base"]["y"] + force["Pin"]["y"] - 100) < 1e-6,
                      str(force))
                check("  no shear", abs(force["Base"]["x"]) < 0.02 *
                      force["Base"]["y"], str(force))


def clamped():
    """Two equal cantilevers, one on the other, meshes that do not match, clamped
    in the same wall: beams touch at the tip, and each carries half of the load
    there."""
    load, length, height, E = 20., 100., 4., 200000.
    deflection = load / 2 * length**3 / (3 * E * height**3 / 12)
    for degree in (1, 2):
        mesh = Mesh()
        mesh.block("A", 40, 3, box(0, -height, length, 0),
                   {"top": "Ground", "left": "WallA"})
        mesh.block("B", 50, 3, box(0, 0, length, height),
                   {"bottom": "Sole", "left": "WallB", "right": "End"})
        mesh.write("clamped")
        for rule in ("mortar", "nodal"):
            status, said, summary = run("clamped", {
                "Mesh/File": "clamped.msh", **CONTACT,
                **solids("A: 200000, B: 200000", "A: 0, B: 0"),
                "Element/Degree": str(degree),
                "Boundary conditions/Displacement x": "WallA: 0, WallB: 0",
                "Boundary conditions/Displacement y": "WallA: 0, WallB: 0",
                "Boundary conditions/Resultant force y": f"End: {-load}",
                "Contact/Discretization": rule, "Output/Profile": "true",
                "Output/Nodes": "true"})
            check(f"{rule}, degree {degree}: converges", status == 0, said[:300])
            if status != 0:
                continue
            tip = min(n["displacement_y_mm"] for n in rows("clamped", "nodes.csv"))
            # Elements of degree 1 are too stiff in bending.
            check("  bends", abs(tip / -deflection - 1) < (0.2, 0.02)[degree - 1],
                  f"{tip} {-deflection}")
            # Where beams touch all along, rounding decides on the force.
            wall = summary["increments"][-1]["reactions"]["WallA"]["y"]
            check("  shares the load", abs(wall - load / 2) < 0.75 * load,
                  str(wall))
            peak = max(r["pressure_MPa"] for r in rows("clamped"))
            check("  no pressure in the wall", peak < 2 * load, str(peak))


def between_nodes():
    """A circle under the middle of an edge as long as its diameter, and the cap of
    one of ten times its radius, which none of the nodes has come to."""
    for edges, radius, way, status_wanted in (
            (5, 1, 0.5, 1), (50, 1, 0.5, 0), (3, 10, 0.05, 1), (30, 10, 0.05, 0)):
        mesh = Mesh()
        mesh.block("B", edges, 5, box(-5, 0, 5, 10),
                   {"bottom": "Sole", "top": "Head"})
        mesh.write("between")
        status, said, _ = run("between", {
            "Mesh/File": "between.msh",
            **solids("B: 1000", "B: 0.3"),
            "Contact/Slave": "Sole",
            "Contact/Obstacle": f"circle: 0, {-radius}, {radius}",
            "Boundary conditions/Displacement x": "Head: 0",
            "Boundary conditions/Displacement y": f"Head: {-way}"})
        check(f"{edges} edges, radius {radius}: exit status {status_wanted}",
              status == status_wanted, said[:300])
        check("  the depth is named, and nothing about round surfaces",
              ("inside of the obstacle" in said) == (status_wanted == 1) and
              "ound surfaces" not in said, said[:300])
        if edges == 5:
            status, said, summary = run("between", {
                "Mesh/File": "between.msh", **solids("B: 1000", "B: 0.3"),
                "Contact/Slave": "Sole",
                "Contact/Obstacle": f"circle: 0, {-radius}, {radius}",
                "Boundary conditions/Displacement x": "Head: 0",
                "Boundary conditions/Displacement y": f"Head: {-way}",
                "Refinement/Levels": 2})
            check("  on the first of three meshes alone: exit status 0",
                  status == 0 and "level 0" in said and
                  violations(summary), said[:300])


def approached():
    """A circle comes down between two nodes of a block, or slides there."""
    for edges, status_wanted in ((6, 1), (60, 0)):
        mesh = Mesh()
        mesh.block("B", edges, 3, box(-3, -3, 3, 0), {"bottom": "Base", "top": "Top"})
        mesh.write("approached")
        for path, way in ("0.5, 3, 2", "y: -1.05*t"), ("-3.5, 1.95, 2", "x: 4*t"):
            status, said, summary = run("approached", {
                "Mesh/File": "approached.msh", **solids("B: 1000", "B: 0.3"),
                "Contact/Slave": "Top", "Contact/Obstacle": f"circle: {path}",
                "Contact/Obstacle motion": way, "Solution/Increments": 4,
                "Boundary conditions/Displacement x": "Base: 0",
                "Boundary conditions/Displacement y": "Base: 0"})
            check(f"{edges} edges, {way}: exit status {status_wanted}, not idle",
                  status == status_wanted and "nothing is loaded" not in said and
                  (summary["contact"]["normal_force"] > 0) == (status == 0),
                  said[:300])


def through():
    """A plate and a circle are pushed into a block by more than they are thick, and
    a sphere in 3-D."""
    mesh = Mesh()
    mesh.block("B", 12, 6, box(-3, 0, 3, 3), {"bottom": "Sole", "top": "Head"})
    mesh.write("through")
    held = {f"Boundary conditions/Displacement {d}": "Head: 0" for d in "xy"}
    plate = ("profile: 0, -0.5, 0.05, 8, -0.5, 0.05, 8, 0, 0.05, -8, 0, 0.05, "
             "-8, -0.5, 0.05, 0, -0.5, 0.05")
    forces = []
    for increments in (1, 2, 10):
        status, said, summary = run("through", {
            "Mesh/File": "through.msh", **solids("B: 1000", "B: 0.3",
                                                 "large displacement"), **held,
            "Contact/Slave": "Sole", "Contact/Obstacle": plate,
            "Contact/Obstacle motion": "y: 0.63*t", "Solution/Increments": increments,
            "Probes/Probes": "F: obstacle force y, Contact"})
        check(f"a plate, {increments} increments", status == 0, said[-300:])
        forces.append(summary["probes"][0]["value"])
    worst = max(abs(force / forces[-1] - 1) for force in forces)
    check(f"  pushes all the same: {worst:.1e}", forces[0] > 0 and worst < 1e-6)

    volumes = Volumes()
    volumes.block("B", (6, 6, 3), lambda r, s, t: (4 * r - 2, 4 * s - 2, 2 * t))
    volumes.write("through_space")
    for what, entries in (
            ("circle", {"Mesh/File": "through.msh", "Contact/Slave": "Sole", **held,
                        "Contact/Obstacle": "circle: 0, -0.45, 0.45",
                        "Contact/Obstacle motion": "y: table(0 0, 0.5 0.1, 1 1.4)"}),
            ("sphere", {"Mesh/File": "through_space.msh", "Contact/Slave": "B_z0",
                        **{f"Boundary conditions/Displacement {d}": "B_z1: 0"
                           for d in "xyz"},
                        "Contact/Obstacle": "sphere: 0, 0, -0.45, 0.45",
                        "Contact/Obstacle motion":
                            "z: table(0 0, 0.5 0.1, 1 1.4)"})):
        status, said, summary = run("through", {
            **entries, **solids("B: 1000", "B: 0.3", "large displacement"),
            "Solution/Increments": 2, "Solution/Max cut-backs": 3})
        check(f"a {what} pushes, or its way ends",
              summary["contact"]["normal_force"] > 0 if status == 0 else status == 3,
              said[-300:])


def foil():
    """A block pressed on a clamped foil far thinner than it sags: with both sides
    as master, points behind it see the far one."""
    for sides, status_wanted in ((("top",), 0), (("top", "bottom"), 1)):
        mesh = Mesh()
        mesh.block("A", 60, 1, box(-10, -0.01, 10, 0),
                   {**{side: "Ground" for side in sides},
                    "left": "Left", "right": "Right"})
        mesh.block("B", 8, 4, box(-3, 0, 3, 3), {"bottom": "Sole", "top": "Head"})
        mesh.write("foil")
        status, said, _ = run("foil", {
            "Mesh/File": "foil.msh", **CONTACT,
            **solids("A: 200000, B: 1000", kinematics="large displacement"),
            "Boundary conditions/Displacement x": "Left: 0, Right: 0, Head: 0",
            "Boundary conditions/Displacement y": "Left: 0, Right: 0",
            "Boundary conditions/Resultant force y": "Head: -60",
            "Solution/Increments": "2"})
        check(f"{sides}: exit status {status_wanted}", status == status_wanted,
              said[:400])
        check("  what went through is named",
              ("gone through the other body" in said) == (status_wanted == 1),
              said[:400])


def from_under():
    """A block that slides on a longer one, whose nodes come out from under its
    trailing corner: they cut a corner, and have not gone through the block. The
    forces are those with its sole alone as slave."""
    forces = []
    for ends in (("bottom",), ("bottom", "left", "right")):
        mesh = Mesh()
        mesh.block("A", 20, 1, box(0, -0.4, 40, 0), {"bottom": "Base", "top": "Ground"})
        mesh.block("B", 6, 1, box(5, 0, 15, 0.4),
                   {**{side: "Sole" for side in ends}, "top": "Head"})
        mesh.write("from_under")
        status, said, summary = run("from_under", {
            "Mesh/File": "from_under.msh", **CONTACT,
            **solids("A: 1000, B: 1000", kinematics="large displacement"),
            "Boundary conditions/Displacement x": "Base: 0, Head: 6",
            "Boundary conditions/Displacement y": "Base: 0, Head: -0.01",
            "Boundary conditions/Histories": "Displacement y: min(1, 6*t)",
            "Contact/Friction coefficient": 0.3,
            "Probes/Probes": "Fy: reaction y, Head", "Solution/Increments": "6"})
        check(f"{ends}: nothing goes through", status == 0, said[-400:])
        forces.append(summary["probes"][0]["value"] if status == 0 else 0)
    check("  the same force", forces[0] < 0 and
          abs(forces[1] / forces[0] - 1) < 1e-8, f"{forces}")


def crossed_ridges():
    """Two bars on edge, one across the other, pushed by less than a facet is
    wide: no point of contact looks where they cross. That no force acts there is
    a violation, wherever along the facets they cross."""
    def roof(along, side):
        def chart(r, s, t):
            u, v = 4 * r - 2 + 0.15 * side, 2 * s - 1
            z = side * ((1 - t) * abs(v) + 1.5 * t)
            return (u, v, z) if along == "x" else (v, u, z)
        return chart
    for rule in ("nodal", "mortar"):
        volumes = Volumes()
        volumes.block("A", (10, 4, 2), roof("x", -1))
        volumes.block("B", (10, 4, 2), roof("y", 1))
        volumes.write("crossed_ridges")
        status, said, summary = run("crossed_ridges", {
            "Mesh/File": "crossed_ridges.msh", "Contact/Slave": "B_z0",
            "Contact/Master": "A_z0", "Contact/Discretization": rule,
            **solids("A: 1000, B: 1000", "A: 0.3, B: 0.3"),
            **{f"Boundary conditions/Displacement {d}":
               f"A_z1: 0, B_z1: {-0.03 if d == 'z' else 0}" for d in "xyz"}})
        check(f"ridges, {rule}: told", status == 1 and
              "inside of the other body" in said, said[-400:])


def turning():
    mesh = Mesh()
    mesh.block("B", 4, 4, box(0, 0, 1, 1), {"bottom": "Base", "top": "Head"})
    mesh.write("turning")
    for increments, noted in ((1, True), (3, True), (2, False), (4, False)):
        status, said, _ = run("turning", {
            "Mesh/File": "turning.msh", **solids("B: 1000", "B: 0.3"),
            "Boundary conditions/Displacement x": "Base: 0",
            "Boundary conditions/Displacement y": "Base: 0, Head: 0.01",
            "Boundary conditions/Histories":
                "Displacement y: table(0 0, 0.5 1, 1 -0.3)",
            "Solution/Increments": str(increments)})
        check(f"{increments} increments", status == 0 and
              ("turns back inside an increment, at about t = 0.5" in said)
              == noted, said[:300])


def shrunk():
    """In plane strain the stretch l under the force F is E/(1 - nu^2) l (l^2 - 1)/2
    times the height, and the one across the square root of 1 - nu/(1 - nu)
    (l^2 - 1): zero under 44.7 N."""
    E, nu, height = 10, 0.3, 2
    mesh = Mesh()
    mesh.block("B", 10, 2, box(0, 0, 10, height), {"left": "L", "right": "R"})
    mesh.write("shrunk")
    for force, n in ((40, 1), (50, 1), (50, 2), (60, 4)):
        status, said, summary = run("shrunk", {
            "Mesh/File": "shrunk.msh", "Mesh/Points": "tip: 10, 2; o: 0, 0",
            **solids(f"B: {E}", f"B: {nu}", kinematics="large displacement"),
            "Boundary conditions/Displacement x": "L: 0",
            "Boundary conditions/Displacement y": "o: 0",
            "Boundary conditions/Resultant force x": f"R: {force}",
            "Solution/Increments": n,
            "Probes/Probes": "u: displacement x, tip; v: displacement y, tip"})
        if force > 44.7:
            check(f"a bar under {force} N in {n} increment(s) is no result",
                  status == 3 and "turns inside out" in said, said[-300:])
            continue
        u, v = (p["value"] for p in summary["probes"])
        stretch = 1 + u / 10
        check("a bar as its law says", status == 0 and
              abs(E / (1 - nu**2) * stretch * (stretch**2 - 1) / 2 * height
                  / force - 1) < 1e-6 and
              abs(1 + v / height -
                  math.sqrt(1 - nu / (1 - nu) * (stretch**2 - 1))) < 1e-6,
              f"{u} {v}")
        check("  its law is left, and a note says so", "gets softer" in said, said)
        body = summary["bodies"]["B"]
        check("  no stress is told where none is checked",
              body["strain"] > 0.1 and body["von_mises"] is None and
              body["contact_share_above_yield"] is None, str(body))


def snap_through():
    """Half of a shallow arch, whose limit load, by prescribed displacements, is
    between 0.0135 and 0.0137 N/mm: below it no note, beyond it one, in one increment or more."""
    half, rise = 20, 1
    mesh = Mesh()
    mesh.block("A", 40, 2, lambda s, t: (
        half * s, rise * (1 - s**2) + 0.5 * (t - 0.5)),
        {"left": "Mid", "right": "End", "corner": "P"})
    mesh.write("arch")
    entries = {
        "Mesh/File": "arch.msh", "Element/Degree": 2,
        "Solids/Young's modulus": "A: 1000", "Solids/Poisson's ratio": "A: 0",
        "Boundary conditions/Displacement x": "End: 0, Mid: 0"}
    status, said, summary = run("arch", {
        **entries, "Boundary conditions/Displacement y": "End: 0, P: -0.8",
        "Solution/Increments": 16, "Probes/Probes": "r: reaction y, End"})
    largest = max(i["probes"]["r"] for i in summary["increments"])
    check("the limit load of an arch", status == 0 and 0.0135 < largest < 0.0137 and
          "snapped through" not in said, f"{largest} {said[:300]}")
    for force, n, jumps in ((0.012, 1, False), (0.0135, 4, False),
                            (0.0137, 1, True), (0.0137, 4, True)):
        status, said, summary = run("arch", {
            **entries, "Boundary conditions/Displacement y": "End: 0",
            "Boundary conditions/Force y": f"P: {-force}",
            "Solution/Increments": n, "Solution/Max cut-backs": 6,
            "Probes/Probes": "u: displacement y, P"})
        check(f"an arch under {force} N/mm in {n} increment(s): "
              f"{'a' if jumps else 'no'} jump is noted",
              status == 0 and ("snapped through" in said) == jumps and
              (summary["probes"][0]["value"] < -1) == jumps, said[:400])


def coarse_fit():
    """A quarter of a pin, 0.01 mm too thick for its ring: edges of 15 degrees are
    0.09 mm beside the circle, and no force acts, a violation; those of 1 degree
    push."""
    def sector(inner, outer):
        def chart(r, s):
            radius, angle = inner + (outer - inner) * r, math.pi / 2 * s
            return radius * math.cos(angle), radius * math.sin(angle)
        return chart
    sides = {"bottom": "Below", "top": "Left"}
    for n, degree, noted, words, status_wanted in (
            (6, 1, True, "no force acts there", 1),
            (90, 1, False, "no force acts there", 0),
            (2, 2, True, "off their circles", 0),
            (15, 2, False, "off their circles", 0)):
        mesh = Mesh()
        mesh.block("A", 2, n + n // 3, sector(10, 20), {**sides, "left": "Bore"})
        mesh.block("B", 2, n, sector(5, 10.01), {**sides, "right": "Pin"})
        mesh.write("coarse_fit")
        status, said, _ = run("coarse_fit", {
            "Mesh/File": "coarse_fit.msh", **solids(),
            "Mesh/Arcs": "Pin: 0, 0, 10.01; Bore: 0, 0, 10",
            "Element/Degree": degree,
            "Contact/Slave": "Pin", "Contact/Master": "Bore",
            "Boundary conditions/Displacement x": "Left: 0",
            "Boundary conditions/Displacement y": "Below: 0",
            "Solution/Increments": "1"})
        check(f"{n} edges of degree {degree}, noted: {noted}",
              status == status_wanted and (words in said) == noted, said[:400])


def flat_ends():
    """The flat ends of two round shafts, one on the other, whose meshes do not
    match: the ends are on no circle."""
    def shaft(z0, z1):
        def chart(r, s, t):
            a, b = 2 * r - 1, 2 * s - 1
            return (5 * a * math.sqrt(1 - b * b / 2),
                    5 * b * math.sqrt(1 - a * a / 2), z0 + (z1 - z0) * t)
        return chart
    sides = {**{side: "side" for side in ("x0", "x1", "y0", "y1")},
             "z0": "z0", "z1": "z1"}
    mesh = Volumes()
    mesh.block("A", (6, 6, 1), shaft(-4, 0), sides, {})
    mesh.block("B", (4, 4, 1), shaft(0, 4), sides, {})
    mesh.write("flat_ends")
    status, said, _ = run("flat_ends", {
        "Mesh/File": "flat_ends.msh", **solids(),
        "Mesh/Cylinders": "A_side: 0, 0, 0, 0, 0, 1, 5; "
                          "B_side: 0, 0, 0, 0, 0, 1, 5",
        "Contact/Slave": "B_z0", "Contact/Master": "A_z1",
        **{f"Boundary conditions/Displacement {x}": "A_z0: 0, B_z1: 0"
           for x in "xy"},
        "Boundary conditions/Displacement z": "A_z0: 0, B_z1: -0.01"})
    check("flat ends are on no circle", status == 0 and
          "off their circles" not in said, said[:300])


def glued_apart():
    """A block under a shear, glued to its base across a gap: the moment of the
    shear over the gap is lost, which is noted, and a violation where it is more
    than a hundredth."""
    for gap, status_wanted in ((0, 0), (0.001, 0), (0.3, 1)):
        mesh = Mesh()
        mesh.block("A", 6, 2, box(-6, -5, 6, 0), {"bottom": "Base", "top": "Ground"})
        mesh.block("B", 5, 2, box(-3, gap, 3, 4), {"bottom": "Sole", "top": "Head"})
        mesh.write("glued_apart")
        status, said, summary = run("glued_apart", {
            "Mesh/File": "glued_apart.msh", **solids(), **CONTACT,
            "Contact/Tied": "true",
            "Boundary conditions/Displacement x": "Base: 0",
            "Boundary conditions/Displacement y": "Base: 0",
            "Boundary conditions/Resultant force x": "Head: 10"})
        check(f"glued across {gap} mm: exit status {status_wanted}",
              status == status_wanted, said[:400])
        check("  the gap is noted, and the moment named",
              (f"up to {gap} mm apart" in said) == (gap > 0) and
              ("balance of moments" in said) == (status_wanted == 1), said[:400])


def idle():
    mesh = Mesh()
    mesh.block("A", 4, 2, box(-4, -5, 4, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 3, 2, box(-3, 0.1, 3, 4), {"bottom": "Sole", "top": "Head"})
    mesh.write("idle")
    for way, words in ((0, "nothing is loaded"), (-0.05, "nothing touches"),
                       (-0.15, "")):
        head = f"Base: 0, Head: {way}"
        status, said, _ = run("idle", {
            "Mesh/File": "idle.msh", **solids(), **CONTACT,
            "Boundary conditions/Displacement x": "Base: 0, Head: 0",
            "Boundary conditions/Displacement y": head})
        check(f"a way of {way} mm over a gap of 0.1 mm", status == 0 and
              (words in said if words else "note: nothing" not in said), said[:300])
    named = {entry.replace("Contact", "Contact low"): value
             for entry, value in CONTACT.items()}
    _, _, summary = run("idle", {
        "Mesh/File": "idle.msh", **solids(), **named,
        "Boundary conditions/Displacement x": "Base: 0, Head: 0",
        "Boundary conditions/Displacement y": head})
    check("results of a named pair alone are under its name",
          all(of["contact"] == {} and of["contact low"]["normal_force"] > 0
              for of in (summary, summary["increments"][-1])))


def held_nodes():
    """Supports drive nodes of a slave into its obstacle: all of them, or one."""
    mesh = Mesh()
    mesh.block("B", 4, 2, box(0, 0, 4, 2), {"bottom": "Sole", "top": "Head"})
    mesh.write("held_nodes")
    for held, violates, words in (
            ("Sole: -0.1", True, "supports hold all of the slave"),
            ("Corner: -0.1, Head: -0.05", False, "")):
        status, said, summary = run("held_nodes", {
            "Mesh/File": "held_nodes.msh", "Mesh/Points": "Corner: 0, 0",
            **solids("B: 1000", "B: 0.3"), "Contact/Slave": "Sole",
            "Contact/Obstacle": "half plane: 0, 0, 0, 1",
            "Boundary conditions/Displacement x": "Corner: 0",
            "Boundary conditions/Displacement y": held})
        check(f"what supports hold inside of the obstacle is noted ({held})",
              status == violates and "inside of its obstacle, up to 0.1 mm" in said and
              words in said and "no point of the slave" not in said, said[:600])
        if not words:
            check("  the other nodes are pushed",
                  summary["contact"]["normal_force"] > 0)


def left_free():
    """Contact without friction holds a body but along one line."""
    mesh = Mesh()
    mesh.block("B", 4, 2, box(0, 0, 4, 2), {"bottom": "Sole", "top": "Head"})
    mesh.write("left_free")
    for friction in (0, 0.3):
        status, said, _ = run("left_free", {
            "Mesh/File": "left_free.msh", **solids("B: 1000", "B: 0.3"),
            "Contact/Slave": "Sole", "Contact/Obstacle": "half plane: 0, 0, 0, 1",
            "Contact/Friction coefficient": friction,
            "Boundary conditions/Pressure": "Head: 3"})
        check(f"a body that may slide anywhere is noted, friction {friction}",
              status == 0 and ("nothing holds the body 'B' at the end against: "
                               "displacement in x" in said) == (friction == 0),
              said[:400])


def stands_on_corner():
    """A block that its weight and a pull at its upper left corner turn by a right
    angle about its lower right one: it then stands on one node, below the support."""
    mesh = Mesh()
    mesh.block("B", 2, 2, box(0, 0, 1, 1), {"bottom": "Side", "right": "Side"})
    mesh.write("stands_on_corner")
    turn = "pi/2*max(0,(10*t-1)/9)"
    status, said, summary = run("stands_on_corner", {
        "Mesh/File": "stands_on_corner.msh", "Mesh/Points": "Pulled: 0, 1",
        **solids("B: 1000", "B: 0.3", "large displacement"),
        "Contact/Slave": "Side", "Contact/Obstacle": "half plane: 0, 0, 0, 1",
        "Contact/Friction coefficient": 1,
        "Boundary conditions/Body force y": "B: -0.2",
        "Boundary conditions/Displacement formula x":
            f"Pulled: 1-cos({turn})+sin({turn})",
        "Boundary conditions/Histories": "Body force y: min(1,10*t)",
        "Solution/Increments": 10,
        "Probes/Probes": "u: displacement x, Pulled; pull: reaction x, Pulled"})
    last = summary["increments"][-1] if summary else {}
    check("a block that has turned and is held where it stands: no note",
          status == 0 and "nothing holds" not in said, said[:400])
    check("the reaction of a point is a probe, and that of its support",
          status == 0 and
          abs(last["probes"]["pull"] / last["reactions"]["Pulled"]["x"] - 1) < 1e-6,
          last)


def left_floating():
    """The middle one of three blocks shrinks, below an obstacle: it and the upper
    one are anywhere in the gap of 0.024 mm."""
    mesh = Mesh()
    for name, n, y in (("A", 4, 0), ("B", 4, 2), ("C", 4, 4)):
        mesh.block(name, n, 2, box(0, y, 4, y + (2 if name < "C" else 1)), {
            side: name + side for side in ("bottom", "top", "left")})
    mesh.write("left_floating")
    status, said, _ = run("left_floating", {
        "Mesh/File": "left_floating.msh",
        **solids("A: 1000, B: 2000, C: 500", "A: 0.3, B: 0.2, C: 0.4"),
        "Solids/Thermal strain": "B: -0.01*t", "Solution/Increments": 2,
        "Boundary conditions/Displacement x": "Aleft: 0, Bleft: 0, Cleft: 0",
        "Boundary conditions/Displacement y": "Abottom: 0",
        "Contact/Slave": "Atop", "Contact/Master": "Bbottom",
        "Contact 2/Slave": "Cbottom", "Contact 2/Master": "Btop",
        "Contact 3/Slave": "Ctop", "Contact 3/Obstacle": "half plane: 0, 5, 0, -1"})
    check("blocks that float in a gap are noted", status == 0 and all(
        f"nothing holds the body '{name}' at the end" in said for name in "BC"),
          said[:600])


def eccentric():
    """A soft block on a half plane, its top rigid, with a force and a moment."""
    mesh = Mesh()
    mesh.block("B", 8, 4, box(-8, 0, 8, 6), {"bottom": "Sole", "top": "Head"})
    mesh.write("eccentric")
    status, said, summary = run("eccentric", {
        "Mesh/File": "eccentric.msh", "Mesh/Points": "P: 0, 6",
        **solids("B: 200", "B: 0"), "Solution/Geometry": "undeformed",
        "Boundary conditions/Rigid": "Head: P",
        "Boundary conditions/Displacement x": "Head: 0",
        "Boundary conditions/Force y": "Head: -40",
        "Boundary conditions/Moment z": "Head: -100",
        "Contact/Slave": "Sole", "Contact/Obstacle": "half plane: 0, 0, 0, 1",
        "Probes/Probes": "M: obstacle moment z, Contact"})
    moment = summary["probes"][0]["value"] if status == 0 else 0
    check("the moment on an obstacle is that of the loads",
          abs(abs(moment) - 100) < 1e-6, f"{moment} {said[-300:]}")


def round_and_apart():
    """A round bottom of three chords, of which the middle one does not touch."""
    radius, ends = 4, (-2.2, -0.9, 0.8, 1.9)
    mesh = Mesh()
    mesh.block("A", 3, 1, box(-4, -2, 4, 0), {"bottom": "Base", "top": "Ground"})

    def bottom(s, t):
        x = ends[round(3 * s)]
        y = radius - math.sqrt(radius**2 - x**2)
        return x, y + t * (3 - y)
    mesh.block("B", 3, 1, bottom, {"bottom": "Sole", "top": "Head"})
    mesh.write("round_and_apart")

    def force(strategy, levels, ranks=1):
        status, said, summary = run("round_and_apart", {
            "Mesh/File": "round_and_apart.msh",
            "Mesh/Arcs": f"Sole: 0, {radius}, {radius}", **solids(), **CONTACT,
            "Contact/Discretization": "mortar",
            "Boundary conditions/Displacement x": "Base: 0, Head: 0",
            "Boundary conditions/Displacement y": "Base: 0, Head: -0.05",
            "Refinement/Strategy": strategy, "Refinement/Levels": levels}, ranks)
        return (status == 0 and summary["contact"]["normal_force"],
                [level["displacements"] for level in summary["levels"]], said)
    coarse, _, said = force("uniform", 0)
    check("chords of a round side that do not touch", coarse == 0 and
          "nothing touches" in said, said[:300])
    uniform, _, _ = force("uniform", 4)
    adaptive, sizes, _ = force("adaptive", 6)
    check("a round side that finer meshes let touch, adaptive by uniform: "
          f"{adaptive:.4f} / {uniform:.4f}",
          uniform > 1 and abs(adaptive / uniform - 1) < 0.03)
    other, sizes_there, _ = force("adaptive", 6, ranks=2)
    check("the same meshes and force on two processes", sizes == sizes_there and
          abs(other / adaptive - 1) < 1e-8, f"{sizes} {sizes_there}")


def through_zero():
    """A block that is pressed, lifted and pressed: at 0.4 its way is round-off."""
    mesh = Mesh()
    mesh.block("A", 4, 2, box(-4, -5, 4, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 2, 2, box(-3, 0, 3, 4), {"bottom": "Sole", "top": "Head"})
    mesh.write("through_zero")
    status, said, _ = run("through_zero", {
        "Mesh/File": "through_zero.msh", **solids("A: 1000, B: 3000"), **CONTACT,
        "Contact/Discretization": "mortar", "Contact/Friction coefficient": 0.3,
        "Boundary conditions/Displacement x": "Base: 0, Head: 0",
        "Boundary conditions/Displacement y": "Base: 0, Head: -0.05",
        "Boundary conditions/Histories":
            "Displacement y: table(0 0, 0.3 1, 0.6 -2, 0.8 -2, 1 1)",
        "Solution/Increments": 10})
    check("given displacements that go through zero", status == 0, said[-300:])


def nominal_loads():
    """A load in Pa that its history makes MPa of, and loads of round-off."""
    mesh = Mesh()
    mesh.block("A", 4, 3, box(0, 0, 8, 4),
               {"bottom": "Sole", "top": "Head", "left": "Side", "corner": "O"})
    mesh.write("nominal_loads")
    scene = {"Mesh/File": "nominal_loads.msh", **solids("A: 1000", "A: 0.3"),
             "Boundary conditions/Displacement x": "Side: 0",
             "Boundary conditions/Displacement y": "Head: 0",
             "Probes/Probes": "u: displacement y, O; F: reaction y, Head"}
    # With the side of 8 mm free to slide; plane strain.
    exact = (10 * 4 * (1 - 0.3**2) / 1000, -80)
    for load, history in (("10", "t"), ("1e9", "1e-8*t"),
                          ("1e9", "table(0 0, 0.5 1e-17, 1 1e-8)")):
        status, said, summary = run("nominal_loads", {
            **scene, "Boundary conditions/Pressure": f"Sole: {load}",
            "Boundary conditions/Histories": f"Pressure: {history}"})
        found = [probe["value"] for probe in summary["probes"]]
        check(f"a pressure of {load} times {history}", status == 0 and all(
            abs(a / b - 1) < 1e-8 for a, b in zip(found, exact)), said[-300:])
    half_plane = {"Contact/Slave": "Sole",
                  "Contact/Obstacle": "half plane: 0, 0, 0, 1"}
    held = {**scene, **solids("A: 210000", "A: 0.3"), **half_plane,
            "Probes/Probes": "F: obstacle force y, Contact"}
    for force, lost in (("1e-9", True), ("1e-3", False)):
        status, said, summary = run("nominal_loads", {
            **held, "Contact/Obstacle force": f"y: {force}*t"})
        found = summary["probes"][0]["value"]
        check(f"an obstacle force of {force} N/mm",
              status == 1 and "resolution" in said if lost else
              status == 0 and abs(found / float(force) - 1) < 1e-6, said[-300:])


def normal_supports():
    """Reactions along normals of a mesh that has been refined."""
    mesh = Mesh()
    mesh.block("A", 2, 2, box(0, 0, 2, 2),
               {"bottom": "Low", "left": "Left", "right": "Right"})
    mesh.write("normal_supports")
    scene = {"Mesh/File": "normal_supports.msh", "Mesh/Rotation": 30,
             **solids("A: 1000", "A: 0.3"), "Solution/Increments": 1,
             "Boundary conditions/Displacement normal": "Low: 0, Left: 0",
             "Boundary conditions/Traction x": "Right: 1",
             "Boundary conditions/Traction y": "Right: -2",
             "Probes/Probes": "; ".join(f"{g} {c}: reaction {c}, {g}"
                                        for g in ("Low", "Left") for c in "xy")}
    for levels, ranks in ((1, 1), (3, 1), (3, 2)):
        status, said, summary = run("normal_supports", {
            **scene, "Refinement/Levels": levels,
            "Refinement/Strategy": "adaptive"}, ranks)
        by_group = summary["increments"][-1]["reactions"]
        # The node in the corner counts for both groups, in either result.
        worst = max(abs(by_group[p["name"].split()[0]][p["name"].split()[1]]
                        - p["value"]) for p in summary["probes"])
        check(f"{levels} levels, {ranks} processes: reactions are those of probes",
              status == 0 and worst < 1e-9, f"{worst} {said[-300:]}")


def along_edges():
    """A block in the edge of a floor and a wall is dragged along it, and into the
    corner with a third one."""
    mesh = Volumes()
    mesh.block("B", (3, 3, 3), lambda r, s, t: (2 * r, 2 * s, 2 * t))
    mesh.write("along_edges")
    walls = {"F": ("B_z0", "0, 0, 0, 0, 0, 1"), "W": ("B_x0", "0, 0, 0, 1, 0, 0"),
             "V": ("B_y1", "0, 2.2, 0, 0, -1, 0")}
    for rule, way, named in (("nodal", 0.05, "FW"), ("mortar", 0.15, "FW"),
                             ("nodal", 0.23, "FWV")):
        contact = {}
        for name in named:
            contact.update({
                f"Contact {name}/Slave": walls[name][0],
                f"Contact {name}/Obstacle": f"half space: {walls[name][1]}",
                f"Contact {name}/Discretization": rule,
                f"Contact {name}/Friction coefficient": 0.2})
        status, said, summary = run("along_edges", {
            "Mesh/File": "along_edges.msh", **solids("B: 1000", "B: 0.3"), **contact,
            **{f"Boundary conditions/Displacement {d}": "B_z1: 1" for d in "xyz"},
            "Boundary conditions/Histories":
                "Displacement x: table(0 0, 1 -0.05); Displacement y: "
                f"table(0.5 0, 1 {way}); Displacement z: table(0 0, 0.5 -0.04, "
                "1 -0.04)",
            "Solution/Increments": 4, "Probes/Probes": "; ".join(
                f"{name}{d}: obstacle force {d}, Contact {name}"
                for name in named for d in "xyz")})
        check(f"{len(named)} walls, {rule}: converges", status == 0, said[-300:])
        force = {probe["name"]: probe["value"] for probe in summary["probes"]}
        if way == 0.15:
            worst = max(abs(force["Fy"] / force["Fz"] + 0.2),
                        abs(force["Wy"] / force["Wx"] + 0.2))
            check(f"  all slips along the edge: friction by pressure - 0.2 = "
                  f"{worst:.1e}", worst < 1e-3)


def beyond_end():
    """A stiff stamp presses rubber, whose side bulges out beyond the stamp's."""
    mesh = Volumes()
    mesh.block("Low", (3, 4, 2),
               lambda r, s, t: (10 * r, 10 * s, 3.215 * t))
    mesh.block("Up", (1, 1, 2),
               lambda r, s, t: (0.7038734 + 6.242 * r, 0.22188108 + 6.487 * s,
                                3.215 + 3 * t))
    mesh.write("beyond_end")
    ways = {"x": "Low_z0: 0, Up_z1: 0", "y": "Low_z0: 0, Up_z1: 0",
            "z": "Low_z0: 0, Up_z1: -0.241"}
    for rule, converges in (("nodal", False), ("mortar", True)):
        status, said, summary = run("beyond_end", {
            "Mesh/File": "beyond_end.msh",
            "Solids/Young's modulus": "Low: 1, Up: 210000",
            "Solids/Poisson's ratio": "Low: 0.3, Up: 0.3",
            "Solids/Material": "Low: Mooney-Rivlin",
            "Solids/Mooney-Rivlin constant": "Low: 0.1127",
            "Contact/Slave": "Low_z1", "Contact/Master": "Up_z0",
            "Contact/Discretization": rule, "Solution/Increments": 4,
            **{f"Boundary conditions/Displacement {d}": way
               for d, way in ways.items()}})
        moments = [i["invariants"]["moment_imbalance"]
                   for i in summary["increments"] if i["converged"]]
        check(f"off the end of the master, {rule}: "
              + ("converges" if converges else "does not converge, says why"),
              status == 0 if converges else
              status == 3 and "closest points do not come to rest" in said,
              said[-600:])
        # The overlap of facets in part moves the feet of a mortar point.
        check(f"  moments of increments that converged: {max(moments):.1e}",
              max(moments) < (1e-3 if converges else 1e-9))


def buckling():
    """A straight column of the height h and the width b, the foot clamped, under a
    plate that keeps the head level and lets it sway: pi^2 E I / h^2. With friction
    it does not sway: four times as much. Shortened by 3 %, it is a little more."""
    h, b = 12., 1.
    mesh = Mesh()
    mesh.block("A", 2, 8, box(-b / 2, 0, b / 2, h),
               {"bottom": "Foot", "top": "Head"})
    mesh.block("P", 3, 1, box(-2, h, 2, h + 1), {"bottom": "Sole", "top": "Top"})
    mesh.write("buckling")
    critical = math.pi**2 / 12 * (b / h)**2 * h

    def under(part, more):
        return run("buckling", {
            **solids("A: 1000, P: 1e6", "A: 0, P: 0", "large displacement"),
            "Mesh/File": "buckling.msh", "Element/Degree": 2,
            "Boundary conditions/Displacement x": "Foot: 0, Top: 0",
            "Boundary conditions/Displacement y":
                f"Foot: 0, Top: {-part * critical}",
            "Contact/Slave": "Head", "Contact/Master": "Sole", **more})[:2]

    for what, more in (
            ("", {}), (", condensed", {"Solution/System": "condensed"}),
            (", nodal", {"Contact/Discretization": "nodal"}),
            (", Gauss rule", {"Contact/Discretization": "Gauss"}),
            (", fixed point", {"Solution/Geometry": "fixed point"})):
        status, said = under(0.95, more)
        check(f"a column under 0.95 of Euler's load{what}", status == 0, said)
        status, said = under(1.03, more)
        check(f"a column under 1.03 of it is refused{what}",
              status == 3 and "lost its stability" in said, said[-300:])
    friction = {"Contact/Friction coefficient": 0.5}
    for part, is_open in ((3.5, False), (4.2, True)):
        status, said = under(part, friction)
        check(f"with friction, under {part} of it", status == 0 and
              ("stability of the solution is not known" in said) == is_open,
              said[-300:])


def closed():
    """A tube in a rigid hole that is smaller: all of it is in contact, where its
    surface closes as well. Between two walls, one where it closes, the other
    opposite: both as wide."""
    mesh = Mesh()
    mesh.block("Tube", 24, 3, ring(1.5, 2.5), {"bottom": "In", "top": "Out"},
               closed=True)
    mesh.write("closed")
    for degree, rule in ((1, "mortar"), (2, "mortar"), (2, "Gauss")):
        tube = {"Mesh/File": "closed.msh", "Element/Degree": degree,
                "Mesh/Arcs": "Out: 0, 0, 2.5; In: 0, 0, 1.5",
                "Solids/Young's modulus": "Tube: 1000",
                "Solids/Poisson's ratio": "Tube: 0.3",
                "Solids/Kinematics": "small strain"}
        status, said, summary = run("closed", {
            **tube, "Contact/Slave": "Out", "Contact/Friction coefficient": 0.2,
            "Contact/Obstacle": "circle: 0, 0, -2.5",
            "Contact/Discretization": rule, "Contact/Interference": 0.01,
            "Output/Profile": "true"})
        width = summary["contact"]["width"] if status == 0 else 0
        # Of polygons with an edge, or two halves of a parabola, a cell.
        n = 24 * degree
        polygon = 2 * n * 2.5 * math.sin(math.pi / n)
        check(f"closed, degree {degree}, {rule}: the whole circumference",
              abs(width / polygon - 1) < 1e-4, f"{width} {polygon} {said[-300:]}")

        walls = {**tube, "Boundary conditions/Displacement x": "In: 0",
                 "Boundary conditions/Displacement y": "In: 0"}
        first = rows("closed")[0]
        X, Y = first["X_mm"] / 2.5, first["Y_mm"] / 2.5
        for name, side in (("here", 1), ("opposite", -1)):
            walls |= {f"Contact {name}/Slave": "Out",
                      f"Contact {name}/Discretization": rule,
                      f"Contact {name}/Obstacle":
                          f"half plane: {side * 2.45 * X!r}, {side * 2.45 * Y!r},"
                          f" {-side * X!r}, {-side * Y!r}"}
        status, said, summary = run("walls", walls)
        here, opposite = (
            summary[f"contact {name}"]["width"] if status == 0 else 0
            for name in ("here", "opposite"))
        check(f"closed, degree {degree}, {rule}: as wide at both walls",
              here > 0 and abs(opposite / here - 1) < 1e-6,
              f"{here} {opposite}")


for scene in (carried, closed, buckling, overlap, cantilever, halves, teeth, own_master, round_off,
              lost_ways, on_a_corner, beyond_round_off, held_ends, dragged, driven, cornered,
              in_a_corner, concave_corner, too_coarse, over_rim, far_sides, roles, tied, flank, groove,
              slide, pinned, clamped, between_nodes, approached, through, foil,
              from_under, crossed_ridges, turning, shrunk, snap_through, coarse_fit, flat_ends, glued_apart, idle,
              held_nodes, left_free, stands_on_corner, left_floating, eccentric, round_and_apart, through_zero, nominal_loads, normal_supports,
              along_edges, beyond_end):
    print(scene.__name__)
    scene()
sys.exit(len(failures) > 0)
