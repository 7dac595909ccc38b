#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Good files of scenes in 3-D, damaged: as damaged.py, whose options it has.

Half of the cases are damaged byte by byte, as there; in the others the mesh is
one that no scene can have, or that a mesh generator may write by mistake: cells
inverted or flat, faces with three cells, groups lost, of the wrong dimension or
of other bodies, tetrahedra and wedges, nodes of second order in wrong order."""
import random
import sys

import damaged
import space_scenes
from space_scenes import KINDS

# Small scenes that converge.
GOOD = (1, 3, 4, 5, 6, 7, 8, 9, 10)
TETRAHEDRA = ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6),
              (0, 4, 5, 6), (0, 5, 1, 6))
WEDGES = ((0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7))
PYRAMIDS = ((0, 1, 2, 3, 6), (0, 4, 5, 1, 6), (0, 3, 7, 4, 6))
# What no run can make sense of.
REFUSED = {"tetrahedra", "twisted_cell", "flat_cell", "collapsed_edge",
           "third_cell", "cell_twice", "no_body", "foreign_face",
           "no_such_node", "not_a_number", "crossed_face"}
# Of a mesh, what is no damage.
NO_WAYS = {"apply", "change", "nodes", "split", "swapped", "lose"}


class Volume:
    """Ways to damage a mesh of cells. Each changes the mesh."""

    def __init__(self, rng, mesh):
        self.rng = rng
        self.mesh = mesh
        self.cells = [i for i, e in enumerate(mesh.elements)
                      if len(e[2]) in (8, 20, 27) and e[0] != KINDS[8, 2]]
        self.faces = [i for i, e in enumerate(mesh.elements)
                      if e[0] in (KINDS[4, 2], KINDS[8, 2], KINDS[9, 2])]

    def change(self, i, connected, kind=None):
        old, tag, _ = self.mesh.elements[i]
        self.mesh.elements[i] = kind or old, tag, connected

    def nodes(self, i):
        return list(self.mesh.elements[i][2])

    def split(self, cells, parts, kind):
        for i in cells:
            c = self.nodes(i)
            _, tag, _ = self.mesh.elements[i]
            self.change(i, [c[k] for k in parts[0]], kind)
            for part in parts[1:]:
                self.mesh.elements.append((kind, tag, [c[k] for k in part]))

    def tetrahedra(self):
        self.split(self.cells, TETRAHEDRA, 4)

    def some_tetrahedra(self):
        self.split([self.rng.choice(self.cells)], TETRAHEDRA, 4)

    def wedges(self):
        self.split(self.cells, WEDGES, 6)

    def pyramids(self):
        self.split([self.rng.choice(self.cells)], PYRAMIDS, 7)

    def swapped(self, a, b):
        i = self.rng.choice(self.cells)
        c = self.nodes(i)
        c[a], c[b] = c[b], c[a]
        self.change(i, c)

    def twisted_cell(self):
        self.swapped(4, 5)

    def mirrored_cells(self):
        for i in self.cells:
            c = self.nodes(i)
            if len(c) == 8:
                self.change(i, c[4:] + c[:4])

    def flat_cell(self):
        c = self.nodes(self.rng.choice(self.cells))
        for k in range(4):
            self.mesh.nodes[c[k + 4] - 1] = self.mesh.nodes[c[k] - 1]

    def inverted_node(self):
        """A node of a cell on the other side of it."""
        c = self.nodes(self.rng.choice(self.cells))
        a, b = (self.mesh.nodes[c[k] - 1] for k in (0, 6))
        self.mesh.nodes[c[0] - 1] = tuple(2 * y - x for x, y in zip(a, b))

    def collapsed_edge(self):
        i = self.rng.choice(self.cells)
        c = self.nodes(i)
        c[1] = c[0]
        self.change(i, c)

    def cell_twice(self):
        self.mesh.elements.append(
            self.mesh.elements[self.rng.choice(self.cells)])

    def third_cell(self):
        """Two more cells on one face."""
        _, tag, c = self.mesh.elements[self.rng.choice(self.cells)]
        for height in (1., 2.):
            new = []
            for k in range(4, 8):
                place = self.mesh.nodes[c[k] - 1]
                self.mesh.nodes.append((place[0], place[1], place[2] + height))
                new.append(len(self.mesh.nodes))
            self.mesh.elements.append((KINDS[8, 3], tag, list(c[4:8]) + new))

    def lose(self, dimension):
        names = [key for key in self.mesh.groups if key[0] == dimension]
        name = self.rng.choice(names)
        tag = self.mesh.groups[name]
        self.mesh.elements = [e for e in self.mesh.elements if e[1] != tag]
        if self.rng.random() < 0.5:
            del self.mesh.groups[name]

    def no_body(self):
        self.lose(3)

    def no_surface(self):
        self.lose(2)

    def no_point(self):
        self.lose(0)

    def no_name(self):
        del self.mesh.groups[self.rng.choice(list(self.mesh.groups))]

    def other_dimension(self):
        """The name of a surface, for a group of another dimension."""
        names = [key for key in self.mesh.groups if key[0] == 2]
        name = self.rng.choice(names)
        tag = self.mesh.groups.pop(name)
        self.mesh.groups[self.rng.choice((0, 1, 3)), name[1]] = tag

    def plane_body(self):
        """Quadrangles that belong to no cell, as a group of their own."""
        first = len(self.mesh.nodes)
        self.mesh.nodes += [(50., 0., 0.), (51., 0., 0.), (51., 1., 0.),
                            (50., 1., 0.)]
        self.mesh.add(2, "Plane", [first + k for k in range(1, 5)])

    def lines_in_surface(self):
        _, tag, c = self.mesh.elements[self.rng.choice(self.faces)]
        self.mesh.elements.append((1, tag, list(c[:2])))

    def triangles_in_surface(self):
        i = self.rng.choice(self.faces)
        _, tag, c = self.mesh.elements[i]
        self.change(i, list(c[:3]), 2)
        self.mesh.elements.append((2, tag, [c[0], c[2], c[3]]))

    def foreign_face(self):
        """A face with a node that its cell has not."""
        i = self.rng.choice(self.faces)
        c = self.nodes(i)
        c[0] = self.rng.choice([n for n in range(1, len(self.mesh.nodes) + 1)
                                if n not in c])
        self.change(i, c)

    def crossed_face(self):
        i = self.rng.choice(self.faces)
        c = self.nodes(i)
        c[0], c[1] = c[1], c[0]
        self.change(i, c)

    def face_twice(self):
        self.mesh.elements.append(
            self.mesh.elements[self.rng.choice(self.faces)])

    def inner_face(self):
        """A face between two cells, in a surface."""
        c = self.nodes(self.rng.choice(self.cells))
        _, tag, _ = self.mesh.elements[self.rng.choice(self.faces)]
        self.mesh.elements.append((KINDS[4, 2], tag, c[:4]))

    def face_of_other_body(self):
        i, j = self.rng.choice(self.faces), self.rng.choice(self.faces)
        kind, _, c = self.mesh.elements[i]
        self.mesh.elements.append((kind, self.mesh.elements[j][1], c))

    def shared_node(self):
        """The two bodies have a node in common."""
        of_body = {}
        for i in self.cells:
            of_body.setdefault(self.mesh.elements[i][1], set()).update(
                self.nodes(i))
        if len(of_body) == 2:
            a, b = (self.rng.choice(sorted(nodes))
                    for nodes in of_body.values())
            for i, (kind, tag, c) in enumerate(self.mesh.elements):
                self.change(i, [a if n == b else n for n in c])

    def no_such_node(self):
        i = self.rng.choice(self.cells)
        c = self.nodes(i)
        c[self.rng.randrange(len(c))] = self.rng.choice(
            (0, -1, 10 * len(self.mesh.nodes)))
        self.change(i, c)

    def not_a_number(self):
        i = self.rng.choice(self.cells)
        n = self.rng.choice(self.nodes(i)) - 1
        place = list(self.mesh.nodes[n])
        place[self.rng.randrange(3)] = float(
            self.rng.choice(("nan", "inf", "-inf")))
        self.mesh.nodes[n] = tuple(place)

    def far_node(self):
        n = self.rng.randrange(len(self.mesh.nodes))
        self.mesh.nodes[n] = tuple(
            self.rng.choice((1e300, -1e30, 1e-300)) for _ in range(3))

    def flat_mesh(self):
        self.mesh.nodes = [(x, y, 0.) for x, y, _ in self.mesh.nodes]

    def interpenetrating(self):
        nodes = {n for i in self.cells for n in self.nodes(i)
                 if self.mesh.elements[i][1] == self.mesh.groups[3, "Upper"]}
        depth = self.rng.choice((0.1, 1., 3.)) * max(
            abs(x) for x, _, _ in self.mesh.nodes)
        for n in nodes:
            x, y, z = self.mesh.nodes[n - 1]
            self.mesh.nodes[n - 1] = x, y, z - depth

    def second_order(self):
        """Middle nodes in a wrong order, or too few of them."""
        if len(self.nodes(self.cells[0])) == 8:
            self.mesh.add_middles(self.rng.random() < 0.5)
        way = self.rng.randrange(3)
        for i in self.cells:
            c = self.nodes(i)
            middles = c[8:]
            if way == 0:
                self.rng.shuffle(middles)
            elif way == 1:
                middles.reverse()
            elif i == self.cells[0]:
                middles.pop()
            self.change(i, c[:8] + middles)

    def unused_nodes(self):
        self.mesh.nodes += [(0., 0., 1000.)] * 5

    def apply(self):
        ways = sorted(name for name in dir(self)
                      if not name.startswith("_") and callable(
                          getattr(self, name)) and name not in NO_WAYS)
        way = self.rng.choice(ways)
        getattr(self, way)()
        return way


class SpaceCase(damaged.Case):
    PREFIX = "damaged_space"
    GOOD = GOOD
    SCENE = space_scenes.SpaceScene
    DAMAGE = Volume
    REFUSED = REFUSED

    def damage(self, rng):
        if self.part != ".msh" or rng.random() < 0.3:
            return super().damage(rng)
        mesh = self.scene.volumes()
        way = self.DAMAGE(rng, mesh).apply()
        self.files[".msh"] = mesh.text().encode()
        return way

    def faults(self, result):
        if self.way in self.REFUSED and result.outcome != "refused":
            return ["a mesh with the damage '%s' is not refused" % self.way]
        return []


if __name__ == "__main__":
    sys.exit(damaged.main(SpaceCase, __doc__))
