#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random scenes of two bodies in 3-D, solved and checked: as scenes.py, whose
options it has. What has converged is checked by space_verify.py."""
import collections
import itertools
import math
import pathlib
import random
import sys

import scenes
import space_verify
from scenes import log_uniform, number

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from volume_scenes import Volumes  # noqa: E402

# The corners of a cell, renumbered by the rotations of a cube and by a
# reflection: what a mesh generator may write.
ROTATIONS = ((0, 1, 2, 3, 4, 5, 6, 7), (1, 2, 3, 0, 5, 6, 7, 4),
             (0, 3, 7, 4, 1, 2, 6, 5), (0, 4, 5, 1, 3, 7, 6, 2))
REFLECTION = (4, 5, 6, 7, 0, 1, 2, 3)
EDGES = ((0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7),
         (4, 5), (4, 7), (5, 6), (6, 7))
FACES = ((0, 1, 2, 3), (0, 1, 4, 5), (0, 3, 4, 7), (1, 2, 5, 6), (2, 3, 6, 7),
         (4, 5, 6, 7))
# gmsh's names of elements by the number of nodes and the dimension.
KINDS = {(1, 0): 15, (4, 2): 3, (8, 2): 16, (9, 2): 10, (8, 3): 5, (20, 3): 17,
         (27, 3): 12}


class ShuffledVolumes(Volumes):
    """Blocks, with cells numbered in any way, and middle nodes on request."""

    def shuffle(self, rng):
        order = list(range(1, len(self.nodes) + 1))
        rng.shuffle(order)
        nodes = [None] * len(order)
        for old, new in enumerate(order):
            nodes[new - 1] = self.nodes[old]
        self.nodes = nodes
        self.elements = [(kind, tag, [order[n - 1] for n in connected])
                         for kind, tag, connected in self.elements]
        for i, (kind, tag, connected) in enumerate(self.elements):
            if kind == KINDS[8, 3]:
                for _ in range(rng.randrange(4)):
                    turn = rng.choice(ROTATIONS)
                    connected = [connected[k] for k in turn]
                if rng.random() < 0.2:
                    connected = [connected[k] for k in REFLECTION]
                self.elements[i] = kind, tag, connected

    def add_middles(self, with_centres):
        """Cells of 20 or 27 nodes, as gmsh orders them."""
        middles = {}

        def middle(corners):
            key = tuple(sorted(corners))
            if key not in middles:
                self.nodes.append(tuple(
                    sum(self.nodes[n - 1][d] for n in corners) / len(corners)
                    for d in range(3)))
                middles[key] = len(self.nodes)
            return middles[key]
        for i, (kind, tag, c) in enumerate(self.elements):
            if len(c) == 1:
                continue
            dimension = 3 if len(c) == 8 else 2
            edges = EDGES if dimension == 3 else (
                (0, 1), (1, 2), (2, 3), (3, 0))
            more = [middle([c[a] for a in edge]) for edge in edges]
            if with_centres and dimension == 3:
                more += [middle([c[a] for a in face]) for face in FACES]
            if with_centres:
                more.append(middle(c))
            self.elements[i] = KINDS[len(c) + len(more), dimension], tag, c + more


class SpaceScene(scenes.Scene):
    """Everything about a scene in 3-D; all of it follows from the seed."""

    FEATURES = ("shape", "slave", "rule", "friction", "friction_solver",
                "degree", "kinematics", "geometry", "solver", "support",
                "history", "increments", "levels", "cells", "mesh_ratio",
                "stiffness_ratio")
    PREFIX = "space_scene"

    def problems(self, directory, summary):
        return space_verify.problems(self, directory, summary)

    # The shapes and the meshes.
    def choose_geometry(self, rng):
        f = self.features
        size = self.size = log_uniform(rng, 0.1, 100)
        shape = f["shape"] = rng.choice(
            ["blocks", "blocks", "blocks", "bump", "bump", "ridge", "wedge",
             "edge", "corner"])
        self.width = size * rng.uniform(0.4, 1.2)
        self.height = size * rng.uniform(0.3, 1)
        self.lower_height = size * rng.uniform(0.3, 1)
        self.shift = [size * rng.uniform(-0.3, 0.3) if shape == "blocks" else 0.
                      for _ in range(2)]
        self.angle = rng.choice([0, rng.uniform(0, 90)])
        self.slope = rng.uniform(-0.2, 0.2) if shape == "wedge" else 0.
        self.radius = None
        if shape in ("bump", "ridge"):
            self.radius = self.width * log_uniform(rng, 0.7, 20)
        self.gap = 0.
        if shape == "blocks" and rng.random() < 0.15:
            self.gap = self.height * log_uniform(rng, 1e-4, 3e-3)
        ratio = log_uniform(rng, 1 / 8, 8)
        coarse = rng.randint(1, 3)
        n = [coarse, coarse]
        n[ratio > 1] = max(1, min(9, round(coarse * max(ratio, 1 / ratio))))
        f["mesh_ratio"] = n[1] / n[0]
        self.cells = [(m, max(1, m + rng.choice([-1, 0, 1])), rng.randint(1, 3))
                      for m in n]
        f["cells"] = sum(math.prod(c) for c in self.cells)
        self.distortion = rng.choice([0, 0, 0.1, 0.2])
        self.middles = rng.choice([None] * 8 + [False, True])

    def volumes(self):
        rng = random.Random(self.seed)
        mesh = ShuffledVolumes()
        size = self.size
        mesh.block("Lower", self.cells[0], self.moved(
            rng, self.cells[0], lambda r, s, t: (
                size * (r - 0.5), size * (s - 0.5),
                -self.lower_height + t * (
                    self.lower_height + self.slope * size * (r - 0.5)))))
        mesh.block("Upper", self.cells[1],
                   self.moved(rng, self.cells[1], self.upper), self.sides())
        mesh.shuffle(rng)
        if self.middles is not None:
            mesh.add_middles(self.middles)
        return mesh

    def mesh(self):
        return self.volumes().text()

    def facets_of(self, surface):
        """Of "Slave" or "Master", the places of the corners of each."""
        mesh = self.volumes()
        tag = mesh.groups[2, self.entries["Contact/" + surface]]
        return [[mesh.nodes[n - 1] for n in connected[:4]]
                for _, group, connected in mesh.elements if group == tag]

    def moved(self, rng, n, chart):
        """The chart behind a distortion of the inner nodes: sides stay plane."""
        def place(r, s, t):
            x = [r, s, t]
            for d in range(3):
                if 1e-9 < x[d] < 1 - 1e-9:
                    x[d] += self.distortion * rng.uniform(-1, 1) / n[d]
            return chart(*x)
        places = {}

        def same(r, s, t):
            key = round(r, 6), round(s, 6), round(t, 6)
            if key not in places:
                places[key] = tuple(round(c, 12) for c in place(r, s, t))
            return places[key]
        return same

    def sides(self):
        """On an edge or a corner the lower sides are the surface."""
        lower = {"edge": "xz", "corner": "xyz"}.get(self.features["shape"], "z")
        sides = {}
        for d, side in itertools.product("xyz", (0, 1)):
            sides[f"{d}{side}"] = f"{d}{side}"
            if d in lower:
                sides[f"{d}{side}"] = ("face", "top")[side]
        return sides

    def upper(self, r, s, t):
        """The place of a point of the upper cube."""
        shape, width, height = self.features["shape"], self.width, self.height
        x, y, z = width * (r - 0.5), width * (s - 0.5), height * t
        if shape in ("edge", "corner"):
            x, y, z = width * r, width * s, width * t
            c = math.sqrt(0.5)
            # Stand on the edge r = t = 0, or on the corner r = s = t = 0.
            x, z = c * (x - z), c * (x + z)
            if shape == "corner":
                a = math.atan(math.sqrt(0.5))
                y, z = (y * math.cos(a) - z * math.sin(a),
                        y * math.sin(a) + z * math.cos(a))
            else:
                y -= 0.5 * width
        if self.radius is not None:
            sag = x * x / (2 * self.radius)
            if shape == "bump":
                sag += y * y / (2 * self.radius)
            z += sag * (1 - t)
        if shape == "wedge":
            z += self.slope * x * (1 - t)
        else:
            a = math.radians(self.angle)
            x, y = (x * math.cos(a) - y * math.sin(a),
                    x * math.sin(a) + y * math.cos(a))
        return x + self.shift[0], y + self.shift[1], z + self.gap

    def choose_contact(self, rng):
        f = self.features
        # What stands on an edge or a point is the slave, as is what stands
        # between the nodes of the other.
        length = self.size / min(self.cells[0][:2])
        self.slave_is_upper = (f["shape"] in ("edge", "corner") or
                               self.width < 2.5 * length or rng.random() < 0.4)
        f["slave"] = "upper" if self.slave_is_upper else "lower"
        above = "Upper_" + self.sides()["z0"]
        pair = [above, "Lower_z1"]
        if not self.slave_is_upper:
            pair.reverse()
        self.set("Contact/Slave", pair[0])
        self.set("Contact/Master", pair[1])
        f["rule"] = rng.choice(["nodal", "mortar"])
        self.set("Contact/Discretization", f["rule"])
        f["friction"] = rng.choice(["none"] * 2 + ["Coulomb"] * 4 + ["Tresca"])
        self.mu = 0.
        if f["friction"] == "Coulomb":
            self.mu = rng.choice([0.1, 0.3, rng.uniform(0.01, 1), 1.0])
            self.set("Contact/Friction coefficient", number(self.mu))

    # Supports and loads, sized by the strain of the softer body.
    def choose_load(self, rng):
        f = self.features
        strain = log_uniform(rng, 2e-4, 0.02)
        self.traction = strain * min(self.young)
        self.tresca = 0.
        if f["friction"] == "Tresca":
            self.tresca = self.traction * log_uniform(rng, 0.03, 1)
            self.set("Contact/Tresca limit", number(self.tresca))
        supports = ["pressed", "pressed", "guided"]
        if f["shape"] == "blocks" and not self.gap and self.mu >= 0.2:
            supports.append("friction")
        if f["shape"] == "blocks" and not self.gap and not self.angle and \
                not self.shift[0] and not self.shift[1]:
            supports.append("roller")
        if self.gap:
            supports = ["pressed"]
        support = rng.choice(supports)
        if support == "friction" and not self.stands():
            support = "guided"
        f["support"] = support
        for c in "xyz":
            self.add("Displacement " + c, "Lower_z0: 0")
        histories = {"t": "", "load, unload": "if(t < 0.5, 2*t, 1.5 - t)",
                     "early": "min(1, 2*t)", "quadratic": "t*t"}
        f["history"] = rng.choice(["t", "t"] + list(histories))
        at_end = 0.5 if f["history"] == "load, unload" else 1.
        self.load = None
        top = "Upper_" + self.sides()["z1"]
        if support == "pressed":
            depth = strain * min(self.height, self.lower_height) + self.gap
            if f["shape"] in ("edge", "corner", "bump", "ridge"):
                depth *= 2
            self.add("Displacement z", f"{top}: {number(-depth)}")
            loads = ["Displacement z"]
        else:
            force = self.traction * self.width ** 2
            if f["shape"] in ("edge", "corner", "bump", "ridge"):
                force *= 0.05
            self.add("Resultant force z", f"{top}: {number(-force)}")
            loads = ["Resultant force z"]
            self.load = [0., 0., -force * at_end]
        self.hold_aside(rng, support, top, strain, loads)
        if histories[f["history"]]:
            self.set("Boundary conditions/Histories", "; ".join(
                f"{load}: {histories[f['history']]}" for load in loads))

    def stands(self):
        """Whether the middle of the upper block is well over the lower one."""
        return all(abs(s) < 0.3 * self.size for s in self.shift) and \
            self.height < self.width

    def hold_aside(self, rng, support, top, strain, loads):
        if support == "friction":
            push = 0.3 * self.mu * rng.uniform(-1, 1) * self.load[2]
            self.add("Resultant force x", f"{top}: {number(push)}")
            loads.append("Resultant force x")
            if self.features["history"] == "load, unload":
                push *= 0.5
            self.load[0] = push
            return
        self.load = self.load and [None, None, self.load[2]]
        shift = 0.
        if rng.random() < 0.6:
            shift = (log_uniform(rng, 0.1, 3) * strain *
                     max(self.mu, 0.2) * self.height)
        angle = rng.uniform(0, 2 * math.pi)
        for c, part in (("x", math.cos(angle)), ("y", math.sin(angle))):
            self.add("Displacement " + c, f"{top}: {number(shift * part)}")

    # Choose entries of the solution that go together.
    def choose_solution(self, rng):
        f = self.features
        f["increments"] = rng.choice([1, 2, 2, 3, 4])
        self.set("Solution/Increments", str(f["increments"]))
        geometries = ["automatic", "automatic", "fixed point"]
        if f["kinematics"] == "small strain":
            geometries += ["undeformed"]
        f["geometry"] = rng.choice(geometries)
        self.set("Solution/Geometry", f["geometry"])
        f["friction_solver"] = "-"
        if f["friction"] != "none":
            f["friction_solver"] = rng.choice(["Newton"] * 4 + ["fixed point"])
            self.set("Solution/Friction", f["friction_solver"])
        f["solver"] = rng.choice(["automatic"] * 6 + ["AMG", "MUMPS"])
        self.set("Solution/Linear solver", f["solver"])
        f["levels"] = int(rng.random() < 0.1 and f["cells"] < 40 and
                          f["degree"] == 1)
        if f["levels"]:
            self.set("Refinement/Levels", "1")
        self.set("Mesh/File", self.name + ".msh")
        self.set("Probes/Probes", "low: displacement z, Lower_111; "
                 "top: displacement z, Upper_111; face: stress zz, Lower_111")
        self.set("Output/Profile", "true")
        self.set("Output/Nodes", "true")


if __name__ == "__main__":
    sys.exit(scenes.main(SpaceScene, __doc__))
