"""Meshes of hexahedra and tetrahedra: bodies on grids whose cells may be left
out, bent into shape, and the file of a mesh."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import itertools

import numpy as np

from grids import Mesh, ticks

SIDES = ("left", "right", "front", "back", "below", "above")
# From rows of nodes to the order of gmsh.
GMSH = {8: [0, 1, 3, 2, 4, 5, 7, 6], 4: [0, 1, 3, 2], 1: [0]}


def rotations():
    """The 24 rotations of a cube onto itself, as orders of its corners."""
    found = []
    corners = list(itertools.product((-1, 1), repeat=3))
    for axes in itertools.permutations(range(3)):
        for signs in itertools.product((-1, 1), repeat=3):
            R = np.zeros((3, 3))
            R[range(3), axes] = signs
            if np.linalg.det(R) > 0:
                # Corners as (z, y, x): x runs first.
                found.append([corners.index(tuple(int(v) for v in (
                    R @ c[::-1])[::-1])) for c in corners])
    return found


# Of a tetrahedron onto itself, as orders of its corners.
TURNS = [list(p) for p in itertools.permutations(range(4)) if np.linalg.det(
    np.eye(4)[list(p)]) > 0]


def six(start):
    """The tetrahedra of a hexahedron in rows, around the diagonal that begins
    in this corner: along its edges to the other end."""
    found = []
    for axes in itertools.permutations(range(3)):
        path = [start]
        for d in axes:
            path.append(path[-1] ^ 1 << d)
        at = np.array([[k >> d & 1 for d in range(3)] for k in path])
        if np.linalg.det(at[1:] - at[0]) < 0:
            path[2:] = path[:1:-1]
        found.append(path)
    return np.array(found)


def halves(face, edges):
    """The triangles of a face in rows, cut where there is an edge."""
    a, b, c, d = face
    if frozenset((a, d)) in edges:
        return [(a, b, d), (a, d, c)]
    return [(a, b, c), (b, d, c)]


class SpaceBody:
    """Cells between the ticks of three axes, those for whose centre `keep` is
    true; `shape` puts a point of the grid in its place. `closed`: the last tick
    in x is the first one again."""

    def __init__(self, name, xs, ys, zs, keep=None, shape=None, closed=False):
        self.name = name
        shape = shape or (lambda x, y, z: (x, y, z))
        axes = (xs, ys, zs)
        period = len(xs) - 1 if closed else len(xs)
        number = {}
        self.X, self.cells, self.points = [], [], {}
        self.lines = {}
        faces = {}

        def node(i, j, k):
            key = (i % period, j, k)
            if key not in number:
                number[key] = len(self.X)
                self.X.append(shape(*(axis[n] for axis, n in zip(axes, key))))
            return number[key]
        for k, j, i in itertools.product(*(range(len(a) - 1)
                                           for a in axes[::-1])):
            centre = [(a[n] + a[n + 1]) / 2 for a, n in zip(axes, (i, j, k))]
            if keep and not keep(*centre):
                continue
            cell = [node(i + a, j + b, k + c) for c, b, a in
                    itertools.product((0, 1), repeat=3)]
            self.cells.append(cell)
            for side, (d, at) in enumerate(itertools.product(range(3),
                                                             (0, 1))):
                face = self.face(cell, d, at)
                place = list(centre)
                place[d] = axes[d][(i, j, k)[d] + at]
                key = frozenset(face)
                if faces.pop(key, None) is None:
                    faces[key] = (*face, *place, SIDES[side])
        self.boundary = list(faces.values())
        self.node_at = lambda i, j, k: number[i % period, j, k]

    @staticmethod
    def face(cell, d, at):
        """In rows, so that the normal points outward."""
        found = [n for k, n in enumerate(cell) if (k >> d) % 2 == at]
        # Of the axis y the two others are x and z: they make minus y.
        inward = (at == 0) != (d == 1)
        return [found[k] for k in (0, 2, 1, 3)] if inward else found

    def group(self, name, choose):
        """Name the faces of the boundary for which choose(x, y, z, side) is
        true of their middle on the grid."""
        faces = [tuple(b[:4]) for b in self.boundary if choose(*b[4:])]
        assert faces, (self.name, name)
        self.lines[name] = faces
        return self

    def sides(self):
        """All sides that there are: NAME_left, _right, _front and so on."""
        for side in SIDES:
            if any(b[-1] == side for b in self.boundary):
                self.group(self.name + "_" + side,
                           lambda x, y, z, s, side=side: s == side)
        return self

    def point(self, name, i, j, k):
        self.points[name] = self.node_at(i, j, k)
        return self

    def placed(self, turn=np.eye(3), shift=(0, 0, 0)):
        """Turned about the origin, then moved."""
        self.X = [tuple(turn @ np.array(x) + shift) for x in self.X]
        return self


def brick(name, low, high, n, shape=None):
    """A block with all its sides."""
    return SpaceBody(name, *(ticks(a, m, b) for a, m, b in zip(low, n, high)),
                     shape=shape).sides()


class SpaceMesh(Mesh):
    """As in 2-D; `lines` are faces, in rows, with their normals outward;
    `arcs` are round surfaces: {name: (entry, numbers)}."""

    corners = 4

    def refined(self):
        """Each cell into eight. Straight bodies only."""
        from space_fem import places
        other = SpaceMesh([])
        other.bodies, other.points = list(self.bodies), dict(self.points)
        X, number = list(self.X), {}

        def node(corners):
            key = frozenset(corners)
            if len(key) == 1:
                return corners[0]
            if key not in number:
                number[key] = len(X)
                X.append(self.X[list(corners)].mean(0))
            return number[key]

        def split(nodes, dim):
            grid = np.array([node([nodes[k] for k in corners])
                             for corners in places(dim)]).reshape([3] * dim)
            return [grid[tuple(slice(a, a + 2) for a in at)].ravel().tolist()
                    for at in itertools.product((0, 1), repeat=dim)]
        other.cells = {key: np.array([c for cell in array.tolist()
                                      for c in split(cell, 3)])
                       for key, array in self.cells.items()}
        for target, source in ((other.lines, self.lines),
                               (other.boundary, self.boundary)):
            for name, faces in source.items():
                target[name] = [tuple(f) for face in faces
                                for f in split(face, 2)]
        other.X = np.array(X)
        return other

    def turned_cell(self, cell, rng):
        if len(cell) == 4:
            return np.array(cell)[rng.choice(TURNS)]
        return np.array(cell)[rng.choice(rotations())]

    def element(self, nodes, kind=None):
        if kind == "tet" or len(nodes) == 3:
            return [4 if kind else 2, *nodes]
        kind = {8: 5, 4: 3, 1: 15}[len(nodes)]
        return [kind, *(nodes[k] for k in GMSH[len(nodes)])]

    # Tetrahedra.
    def cut(self, bodies, rng):
        """The hexahedra of these bodies cut into six tetrahedra each, around a
        diagonal of their own."""
        for body in bodies:
            start = rng.randrange(8)
            hexahedra = self.cells.pop((body, "hex"))
            tetrahedra = hexahedra[:, six(start)].reshape(-1, 4)
            self.cells[body, "tet"] = tetrahedra
            edges = {frozenset(pair) for cell in tetrahedra.tolist()
                     for pair in itertools.combinations(cell, 2)}
            nodes = set(hexahedra.ravel().tolist())
            for faces in (self.lines, self.boundary):
                for name, members in faces.items():
                    faces[name] = [
                        part for face in members for part in (
                            halves(face, edges) if nodes.issuperset(face)
                            else [face])]
        return self

    def shaken(self, body, rng, share):
        """Nodes of a body moved by up to a share of the shortest edge there: in
        any direction inside of it, along the boundary where that is flat."""
        cells = np.concatenate([array for (name, _), array in
                                self.cells.items() if name == body])
        ends = self.X[cells]
        edges = [np.linalg.norm(ends[:, a] - ends[:, b], axis=1)
                 for a, b in itertools.combinations(range(cells.shape[1]), 2)]
        step = share * np.min(edges)
        normals = {n: [] for n in np.unique(cells).tolist()}
        for face in self.boundary[body]:
            a, b, c = self.X[list(face[:3])]
            n = np.cross(b - a, c - a)
            for node in face:
                normals[node].append(n / np.linalg.norm(n))
        for node, around in normals.items():
            move = step * np.array([rng.uniform(-1, 1) for _ in range(3)])
            if around:
                n = np.array(around)
                if np.abs(n - n[0]).max() > 1e-9:
                    continue
                move -= move @ n[0] * n[0]
            self.X[node] = self.X[node] + move
        return self

    dimension = 3
