"""The bodies of a scene in 3-D: hexahedra of 8, 20 and 27 nodes, tetrahedra of
4 and 10.

A hexahedron of 20 nodes is one of 27 whose centres follow: that of a face half
the sum of the middles of its edges minus a quarter of the sum of its corners,
that of the cell a quarter of both sums, the second one subtracted. Forces on
what follows are handed over. Centres of faces that may touch are free, and
those of faces that supports hold; the centre of the cell follows a free one that
may touch by half, less half of what would be in its place."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import itertools

import numpy as np
import scipy.sparse as sp

import elements
import fem


def places(dim):
    """Of the nodes in rows of an element of degree 2: the corners that they are
    in the middle of."""
    corners = list(itertools.product((0, 2), repeat=dim))
    return [[k for k, c in enumerate(corners) if all(
        a in (1, b) for a, b in zip(place, c))]
        for place in itertools.product(range(3), repeat=dim)]


HEXAHEDRON, QUADRANGLE = places(3), places(2)
SIMPLICES = {n: [[k] for k in range(n)] + [list(pair) for pair in pairs]
             for n, pairs in ((3, elements.TRIANGLE),
                              (4, elements.TETRAHEDRON))}


class SpaceModel(fem.Model):
    """As in 2-D; `lines` are faces here. `middle` knows the nodes of
    degree 2 by the corners that they are in the middle of."""

    def add_middles(self, mesh, cells):
        X = list(mesh.X)
        complete = {}
        for key, array in cells.items():
            of_cell = HEXAHEDRON if key[1] == "hex" else SIMPLICES[4]
            complete[key] = np.array([
                [self.node_between(frozenset(cell[k] for k in corners), mesh,
                                   X) for corners in of_cell]
                for cell in array.tolist()])
        self.X = np.array(X)
        return complete

    def node_between(self, corners, mesh, X):
        if len(corners) == 1:
            return next(iter(corners))
        if corners not in self.middle:
            self.middle[corners] = len(X)
            X.append(mesh.X[list(corners)].mean(0))
        return self.middle[corners]

    def complete(self, faces):
        if self.degree == 1:
            return np.array(faces)
        faces = np.array(faces)
        of_face = QUADRANGLE if faces.shape[1] == 4 else SIMPLICES[3]
        return np.array([[self.node_between(frozenset(
            face[k] for k in corners), None, None) for corners in of_face]
            for face in faces.tolist()])

    def edge_load(self, name, traction):
        total = np.zeros_like(self.X)
        faces = self.lines[name]
        nodes = faces.shape[1]
        # What one side of a collapsed square loses.
        points = self.degree + 1 + (nodes in (3, 6))
        for place, w in elements.face_rule(nodes, points):
            N, slope = elements.face(place, nodes)
            tangents = np.einsum("ad,fai->fdi", slope, self.X[faces])
            normal = np.cross(tangents[:, 0], tangents[:, 1])
            area = np.linalg.norm(normal, axis=1)
            for face, X, n, a in zip(faces, N @ self.X[faces], normal, area):
                total[face] += np.outer(N, w * a * traction(X, n / a))
        return total

    # What follows other nodes.
    def make_loads(self):
        self.follows = None
        loads = super().make_loads()
        if self.degree == 2 and self.scene.serendipity:
            self.bind()
            loads = {entry: self.hand_over(load)
                     for entry, load in loads.items()}
        return loads

    def bind(self):
        """The matrix of the displacements that follow, by degrees of freedom."""
        held, _ = self.supports(0.0)
        free = set()
        for zone in self.scene.zones:
            for group in (zone.slave, zone.master):
                faces = self.lines[group] if group else np.empty((0, 0))
                free.update(faces[:, 4] if faces.shape[1] == 9 else ())
        self.bound = np.zeros(self.X.shape, bool)
        rows, columns, values = [], [], []
        rule = centres()
        for cell in [cell for (_, kind), cells in self.cells.items()
                     if kind == "hex" for cell in cells]:
            leaders_of = {c: [(cell[k], factor) for k in middles] +
                          [(cell[k], -0.25) for k in corners]
                          for c, middles, factor, corners in rule}
            for centre, *_ in rule[1:]:
                if cell[centre] in free:
                    leaders_of[rule[0][0]] += [(cell[centre], 0.5)] + [
                        (n, -f / 2) for n, f in leaders_of[centre]]
            for centre, leaders in leaders_of.items():
                node = cell[centre]
                if node in free:
                    continue
                for d in np.flatnonzero(~held[node] & ~self.bound[node]):
                    self.bound[node, d] = True
                    rows += [3 * node + d] * len(leaders)
                    columns += [3 * n + d for n, _ in leaders]
                    values += [f for _, f in leaders]
        own = np.flatnonzero(~self.bound.ravel())
        size = self.X.size
        self.follows = sp.csr_matrix(
            (values + [1.0] * len(own), (rows + list(own),
                                         columns + list(own))), (size, size))

    def hand_over(self, forces):
        if self.follows is None:
            return forces
        return (self.follows.T @ forces.ravel()).reshape(forces.shape)

    def following(self, u):
        """The displacements with those that follow put in their places."""
        if self.follows is None:
            return u
        return (self.follows @ u.ravel()).reshape(u.shape)

    def forces(self, u):
        return self.hand_over(super().forces(u))

    def magnitude(self, u, error):
        total = super().magnitude(u, error)
        if self.follows is None:
            return total
        return (abs(self.follows).T @ total.ravel()).reshape(total.shape)

    def tangent(self, u):
        K = super().tangent(u)
        if self.follows is None:
            return K
        return (self.follows.T @ K @ self.follows).tocsc()


def centres():
    """Of a cell: the node that follows, the middles of edges and their factor,
    the corners (factor -1/4)."""
    digits = np.array(list(itertools.product(range(3), repeat=3)))[:, ::-1]
    ones = (digits == 1).sum(1)
    found = [(13, np.flatnonzero(ones == 1), 0.25, np.flatnonzero(ones == 0))]
    for d, side in itertools.product(range(3), (0, 2)):
        on = digits[:, d] == side
        of = [np.flatnonzero(on & (ones == n)) for n in range(3)]
        found.append((of[2][0], of[1], 0.5, of[0]))
    return found
