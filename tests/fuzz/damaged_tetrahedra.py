#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Good files of scenes with tetrahedra, damaged: as damaged_space.py.

Tetrahedra of 4 or 10 nodes beside tetrahedra or hexahedra. Of the damaged meshes
those that mean the same (cells mirrored or numbered in another way) have to give
the same results, those that no run can make sense of have to be refused, with the
place and the remedy."""
import random
import sys

import damaged
import damaged_space
import space_scenes
from tetrahedra_scenes import Solid  # noqa: E402, in the folder above

# Small scenes.
GOOD = (1, 3, 4, 5, 6, 7, 8, 9, 10)
EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))
KINDS = {4: 4, 10: 11, 3: 2, 6: 9}
# What no run can make sense of.
REFUSED = {"flat_cell", "inverted_node", "collapsed_edge", "cell_twice",
           "third_cell", "folded_cell", "hanging_node", "no_body",
           "foreign_face", "face_twice", "no_such_node", "not_a_number", "one_point",
           "prism", "pyramid", "glued_hexahedron", "short_cell", "quads",
           "bent_inside_out", "wrong_middles", "tag_of_cell"}
# What means the same.
SAME = {"mirrored_cells", "renumbered_corners", "unused_nodes", "mixed_orders",
        "mixed_faces"}


def straighten(mesh):
    """Middles of sides midway."""
    for kind, _, c in mesh.elements:
        for k, ends in enumerate(EDGES if kind == 11 else ()):
            mesh.nodes[c[4 + k] - 1] = tuple(
                sum(mesh.nodes[c[e] - 1][d] for e in ends) / 2 for d in range(3))


class TetrahedraScene(space_scenes.SpaceScene):
    """Of one body or of both: 4, 8 or 10 nodes of a cell below and above."""

    def choose_contact(self, rng):
        self.nodes_of_cells = rng.choice([(4, 4), (10, 10), (4, 8), (8, 4),
                                          (10, 8), (10, 4), (8, 10)])
        super().choose_contact(rng)
        # Vertices of slaves of 6 nodes take no force.
        self.features["rule"] = "mortar"
        self.set("Contact/Discretization", "mortar")
        self.set("Mesh/Mid-side nodes", "true")

    def volumes(self):
        rng = random.Random(self.seed)
        mesh = Solid()
        size = self.size
        mesh.block("Lower", self.cells[0], self.moved(
            rng, self.cells[0], lambda r, s, t: (
                size * (r - 0.5), size * (s - 0.5),
                -self.lower_height + t * (
                    self.lower_height + self.slope * size * (r - 0.5)))),
            self.nodes_of_cells[0], points=True)
        mesh.block("Upper", self.cells[1],
                   self.moved(rng, self.cells[1], self.upper),
                   self.nodes_of_cells[1], points=True)
        self.join(mesh)
        straighten(mesh)
        return mesh

    def join(self, mesh):
        """Sides that are one surface."""
        new = {}
        for side, name in self.sides().items():
            tag = mesh.groups.pop((2, "Upper_" + side))
            new.setdefault("Upper_" + name, []).append(tag)
        for name, tags in new.items():
            mesh.groups[2, name] = tags[0]
            mesh.elements = [(kind, tags[0] if tag in tags else tag, nodes)
                             for kind, tag, nodes in mesh.elements]


class Tetrahedra(damaged_space.Volume):
    """Ways to damage a mesh with tetrahedra."""

    def __init__(self, rng, mesh):
        super().__init__(rng, mesh)
        self.cells = [i for i, e in enumerate(mesh.elements) if e[0] in (4, 11)]
        bodies = {n for i in self.cells for n in mesh.elements[i][2]}
        self.faces = [i for i, e in enumerate(mesh.elements)
                      if e[0] in (2, 9) and bodies.issuperset(e[2])]

    # What hexahedra alone have.
    tetrahedra = some_tetrahedra = wedges = pyramids = twisted_cell = None
    triangles_in_surface = None

    def a_cell(self):
        i = self.rng.choice(self.cells)
        return i, self.nodes(i)

    def place(self, n, place):
        self.mesh.nodes[n - 1] = tuple(place)

    def at(self, *nodes):
        return [sum(self.mesh.nodes[n - 1][d] for n in nodes) / len(nodes)
                for d in range(3)]

    def new_node(self, place):
        self.mesh.nodes.append(tuple(place))
        return len(self.mesh.nodes)

    def renumber(self, i, order):
        """The corners in another order, middles along."""
        c = self.nodes(i)
        if len(c) == 10:
            middle = {frozenset((c[a], c[b])): c[4 + k]
                      for k, (a, b) in enumerate(EDGES)}
        new = [c[k] for k in order]
        if len(c) == 10:
            new += [middle[frozenset((new[a], new[b]))] for a, b in EDGES]
        self.change(i, new)

    def mirrored_cells(self):
        for i in self.cells:
            self.renumber(i, (1, 0, 2, 3))

    def renumbered_corners(self):
        for i in self.cells:
            order = list(range(4))
            self.rng.shuffle(order)
            self.renumber(i, order)

    def flat_cell(self):
        """A corner in the middle of the opposite side."""
        _, c = self.a_cell()
        self.place(c[0], self.at(*c[1:4]))
        straighten(self.mesh)

    def inverted_node(self):
        _, c = self.a_cell()
        self.place(c[0], [3 * m - 2 * x for m, x in zip(
            self.at(*c[1:4]), self.mesh.nodes[c[0] - 1])])
        straighten(self.mesh)

    def collapsed_edge(self):
        i, c = self.a_cell()
        c[1] = c[0]
        self.change(i, c)

    def third_cell(self):
        """One more cell on a face that two have, or twice one on a face."""
        _, c = self.a_cell()
        for height in (1., 2.):
            top = self.at(*c[:3])
            top[2] += height
            self.mesh.elements.append(
                (4, self.mesh.elements[self.cells[0]][1],
                 [*c[:3], self.new_node(top)]))

    def folded_cell(self):
        """A cell on a side of the body, to its inside."""
        kind, _, face = self.mesh.elements[self.rng.choice(self.faces)]
        i = next(i for i in self.cells if set(face[:3]) <= set(self.nodes(i)[:4]))
        other, = set(self.nodes(i)[:4]) - set(face[:3])
        top = [0.4 * a + 0.6 * b for a, b in zip(self.at(other),
                                                 self.at(*face[:3]))]
        c = [*face[:3], self.new_node(top)]
        self.mesh.elements.append((4, self.mesh.elements[i][1], c))

    def hanging_node(self):
        """One cell cut into two on the diagonal of a cube, that others have as
        well."""
        i, c = self.a_cell()
        middle = c[7] if len(c) == 10 else self.new_node(self.at(c[0], c[3]))
        tag = self.mesh.elements[i][1]
        self.change(i, [c[0], c[1], c[2], middle], 4)
        self.mesh.elements.append((4, tag, [middle, *c[1:4]]))

    def doubled_nodes(self):
        """Half of a body has nodes of its own, as volumes that are not fused."""
        body = self.mesh.elements[self.cells[0]][1]
        own = [i for i in self.cells if self.mesh.elements[i][1] == body]
        part = own[:max(1, len(own) // 12) * 6]
        nodes = {n for i in part for n in self.nodes(i)}
        new = {n: self.new_node(self.at(n)) for n in sorted(nodes)}
        faces = [i for i in self.faces if any(
            set(self.nodes(i)) <= set(self.nodes(j)) for j in part)]
        for i in part + faces:
            self.change(i, [new[n] for n in self.nodes(i)])

    def inner_face(self):
        """A face between two cells, in a surface."""
        i, c = self.a_cell()
        kind, tag, _ = self.mesh.elements[self.rng.choice(self.faces)]
        middles = [c[4], c[8], c[7]] if len(c) == 10 else []
        self.mesh.elements.append((KINDS[3 + len(middles)], tag,
                                   [c[0], c[1], c[3]] + middles))

    def shared_node(self):
        """The two bodies have a node in common."""
        of_body = {}
        for kind, tag, c in self.mesh.elements:
            if kind in (4, 5, 11):
                of_body.setdefault(tag, set()).update(c)
        a, b = (self.rng.choice(sorted(nodes)) for nodes in of_body.values())
        for i, (kind, tag, c) in enumerate(self.mesh.elements):
            self.change(i, [a if n == b else n for n in c])

    def lost_cell(self):
        self.mesh.elements.pop(self.rng.choice(self.cells))

    def one_point(self):
        self.mesh.nodes = [(1., 2., 3.)] * len(self.mesh.nodes)

    def mixed_orders(self):
        """A cell of 4 nodes among those of 10, or the other way round."""
        i, c = self.a_cell()
        if len(c) == 4:
            c += [self.new_node(self.at(c[a], c[b])) for a, b in EDGES]
        else:
            c = c[:4]
        self.change(i, c, KINDS[len(c)])

    def mixed_faces(self):
        """The same of faces."""
        for i in self.faces:
            c = self.nodes(i)
            if len(c) == 3:
                c += [self.new_node(self.at(c[k], c[(k + 1) % 3]))
                      for k in range(3)]
            else:
                c = c[:3]
            self.change(i, c, KINDS[len(c)])

    def second_order(self):
        """Middles in the order of another program."""
        for i in self.cells:
            c = self.nodes(i)
            if len(c) == 10:
                self.change(i, [*c[:8], c[9], c[8]])

    def wrong_middles(self):
        self.with_middles()
        for i in self.cells:
            c = self.nodes(i)
            middles = c[4:]
            self.rng.shuffle(middles)
            self.change(i, c[:4] + middles)

    def with_middles(self):
        """All tetrahedra and their faces of second order."""
        known = {}
        for i in self.cells + self.faces:
            c = self.nodes(i)
            n = 4 if i in set(self.cells) else 3
            if len(c) == n:
                c += [known.setdefault(frozenset((c[a], c[b])), None) or
                      known.update({frozenset((c[a], c[b])): self.new_node(
                          self.at(c[a], c[b]))}) or
                      known[frozenset((c[a], c[b]))]
                      for a, b in EDGES[:3 * (n - 2)]]
            self.change(i, c, KINDS[len(c)])

    def bent_inside_out(self):
        """A middle of a side beyond the opposite one."""
        self.with_middles()
        _, c = self.a_cell()
        self.place(c[4], [2 * a - b for a, b in zip(
            self.at(c[2], c[3]), self.at(c[0], c[1]))])

    def two_middles(self):
        """One side with two nodes between its ends."""
        self.with_middles()
        i, c = self.a_cell()
        c[4] = self.new_node(self.at(c[4]))
        self.change(i, c)

    def short_cell(self):
        i, c = self.a_cell()
        self.change(i, c[:-1])

    def quads(self):
        i = self.rng.choice(self.faces)
        c = self.nodes(i)[:3]
        self.change(i, c + [self.rng.choice([n for n in self.a_cell()[1]
                                             if n not in c])], 3)

    def prism(self):
        i, c = self.a_cell()
        self.change(i, c[:3] + [self.new_node([x, y, z + 1.]) for x, y, z in (
            self.at(n) for n in c[:3])], 6)

    def pyramid(self):
        i, c = self.a_cell()
        self.change(i, [*c[:4], self.new_node((0., 0., 9.))], 7)

    def glued_hexahedron(self):
        """On a triangle and one node more."""
        i, c = self.a_cell()
        new = [self.new_node((x + 9., y, z)) for x, y, z in (
            self.at(n) for n in c[:4])]
        self.mesh.elements.append((5, self.mesh.elements[i][1], c[:4] + new))

    def tag_of_cell(self):
        """Negative, none, huge, of no name."""
        self.tag(self.rng.choice(self.cells))

    def tag_of_face(self):
        self.tag(self.rng.choice(self.faces))

    def tag(self, i):
        kind, _, c = self.mesh.elements[i]
        self.mesh.elements[i] = kind, self.rng.choice(
            (-1, 0, 2**31 - 1, -2**31, 77)), c


# Hexahedra's own ways, and helpers.
damaged_space.NO_WAYS |= {"a_cell", "place", "at", "new_node", "renumber",
                          "with_middles", "tag"}


class TetrahedraCase(damaged_space.SpaceCase):
    PREFIX = "damaged_tetrahedra"
    GOOD = GOOD
    SCENE = TetrahedraScene
    DAMAGE = Tetrahedra
    REFUSED = REFUSED

    def faults(self, result):
        if self.way in SAME and result.outcome in ("refused", "crashed", "hung"):
            return ["a mesh that means the same is not taken"]
        return super().faults(result)


if __name__ == "__main__":
    sys.exit(damaged.main(TetrahedraCase, __doc__))
