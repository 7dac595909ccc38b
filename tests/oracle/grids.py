"""Meshes: bodies on grids whose cells may be left out, bent into shape, and the
file of a mesh (MSH 2.2, ASCII)."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np


def ticks(*stations):
    """ticks(0, 4, 10, 2, 12): 4 equal cells from 0 to 10, then 2 to 12."""
    points = [stations[0]]
    for n, end in zip(stations[1::2], stations[2::2]):
        begin = points[-1]
        points += [begin + (end - begin) * (k + 1) / n for k in range(n)]
    return points


class Body:
    """Cells (i, j) between the ticks of two axes, those for whose centre `keep`
    is true; `shape` puts a point of the grid in its place. `closed`: the last
    tick in x is the first one again. `split`: cells into two triangles each,
    where that is true of the centre."""

    def __init__(self, name, xs, ys, keep=None, shape=None, closed=False,
                 split=None):
        self.name = name
        shape = shape or (lambda x, y: (x, y))
        nx, ny = len(xs) - 1, len(ys) - 1
        period = nx if closed else nx + 1
        number = {}
        self.X = []
        self.cells = []
        edges = {}

        def node(i, j):
            key = (i % period, j)
            if key not in number:
                number[key] = len(self.X)
                self.X.append(shape(xs[key[0]], ys[j]))
            return number[key]
        for j in range(ny):
            for i in range(nx):
                centre = (xs[i] + xs[i + 1]) / 2, (ys[j] + ys[j + 1]) / 2
                if keep and not keep(*centre):
                    continue
                c = [node(i, j), node(i + 1, j), node(i + 1, j + 1),
                     node(i, j + 1)]
                self.add_cell(c, split and split(*centre), (i + j) % 2)
                places = ((centre[0], ys[j]), (xs[i + 1], centre[1]),
                          (centre[0], ys[j + 1]), (xs[i], centre[1]))
                for k, side in enumerate(("below", "right", "above", "left")):
                    a, b = c[k], c[(k + 1) % 4]
                    if edges.pop((b, a), None) is None:
                        edges[a, b] = (*places[k], side)
        self.boundary = [(a, b, *where) for (a, b), where in edges.items()]
        self.lines = {}
        self.points = {}
        self.node_at = lambda i, j: number[i % period, j]

    def add_cell(self, c, split, other):
        if not split:
            self.cells.append(c)
        elif other:
            self.cells += [[c[0], c[1], c[2]], [c[0], c[2], c[3]]]
        else:
            self.cells += [[c[0], c[1], c[3]], [c[1], c[2], c[3]]]

    def group(self, name, choose):
        """Name the boundary lines for which choose(x, y, side) is true, x and
        y their middle on the grid."""
        lines = [(a, b) for a, b, x, y, side in self.boundary
                 if choose(x, y, side)]
        assert lines, (self.name, name)
        self.lines[name] = lines
        return self

    def point(self, name, i, j):
        self.points[name] = self.node_at(i, j)
        return self

    def move(self, dx, dy):
        self.X = [(x + dx, y + dy) for x, y in self.X]
        return self


def block(name, x0, y0, x1, y1, nx, ny, split=None, shape=None):
    """A rectangle with all four sides: NAME_below, _right, _above, _left."""
    body = Body(name, ticks(x0, nx, x1), ticks(y0, ny, y1), split=split,
                shape=shape)
    for side in ("below", "right", "above", "left"):
        body.group(name + "_" + side, lambda x, y, s, side=side: s == side)
    return body


KINDS = {3: "triangle", 4: "quad", 8: "hex"}


class Mesh:
    """Nodes X, cells by body and shape, oriented lines and points by name."""

    dimension = 2
    # Of a line.
    corners = 2

    def __init__(self, bodies, arcs=None):
        self.bodies = []
        self.arcs = arcs or {}
        self.lines = {}
        self.points = {}
        self.boundary = {}
        X, by_key = [], {}
        for body in bodies:
            offset = len(X)
            X += body.X
            if body.name not in self.bodies:
                self.bodies.append(body.name)
            for cell in body.cells:
                by_key.setdefault((body.name, KINDS[len(cell)]), []).append(
                    [n + offset for n in cell])
            for name, lines in body.lines.items():
                self.lines.setdefault(name, []).extend(
                    tuple(n + offset for n in line) for line in lines)
            self.boundary.setdefault(body.name, []).extend(
                tuple(n + offset for n in line[:self.corners])
                for line in body.boundary)
            for name, node in body.points.items():
                self.points[name] = node + offset
        self.X = np.array(X, float)
        self.cells = {key: np.array(cells) for key, cells in by_key.items()}

    def renumbered(self, rng):
        """The same with other numbers of nodes and cells."""
        order = list(range(len(self.X)))
        rng.shuffle(order)
        return self.mapped(np.array(order), self.X, False, rng)

    def mirrored(self, axis):
        X = self.X.copy()
        X[:, axis] *= -1
        return self.mapped(np.arange(len(X)), X, True, None, axis)

    def mapped(self, order, X, flip, rng, axis=0):
        """Node n gets the number order[n]; `flip`: turned round."""
        other = type(self)([])
        other.bodies = list(self.bodies)
        other.order = order
        other.X = np.empty_like(X)
        other.X[order] = X

        def line(nodes):
            return tuple(order[n] for n in (nodes[::-1] if flip else nodes))
        for key, cells in self.cells.items():
            cells = order[cells]
            if flip:
                cells = cells[:, ::-1]
            if rng:
                cells = np.array([self.turned_cell(c, rng)
                                  for c in rng.sample(list(cells),
                                                      len(cells))])
            other.cells[key] = cells
        for target, source in ((other.lines, self.lines),
                               (other.boundary, self.boundary)):
            for name, lines in source.items():
                target[name] = [line(nodes) for nodes in lines]
                if rng:
                    rng.shuffle(target[name])
        other.points = {name: order[n] for name, n in self.points.items()}
        other.arcs = dict(self.arcs)
        if flip:
            sign = np.ones(3)
            sign[axis] = -1
            other.arcs = {name: tuple(sign * arc)
                          for name, arc in self.arcs.items()}
        return other

    def turned_cell(self, cell, rng):
        """With another node as the first one."""
        return np.roll(cell, rng.randrange(len(cell)))

    def element(self, nodes, kind=None):
        """The type of gmsh, and the nodes in its order; `kind` of cells."""
        if len(nodes) < 3:
            return [15 if len(nodes) == 1 else 1, *nodes]
        return [3 if len(nodes) == 4 else 2, *nodes]

    def text(self):
        """The file, with a point group n<k> for each node k."""
        groups = [(0, name, [self.element([node])])
                  for name, node in self.points.items()]
        groups += [(0, "n%d" % k, [self.element([k])])
                   for k in range(len(self.X))]
        groups += [(self.dimension - 1, name, [self.element(line)
                                               for line in lines])
                   for name, lines in self.lines.items()]
        for body in self.bodies:
            cells = [self.element(c, kind) for (name, kind), array in
                     self.cells.items() if name == body
                     for c in array.tolist()]
            groups.append((self.dimension, body, cells))
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
                 str(len(groups))]
        lines += ['%d %d "%s"' % (dimension, tag, name)
                  for tag, (dimension, name, _) in enumerate(groups, 1)]
        lines += ["$EndPhysicalNames", "$Nodes", str(len(self.X))]
        lines += ["%d %s" % (k + 1, " ".join(
            "%.17g" % x for x in (*place, 0)[:3]))
            for k, place in enumerate(self.X)]
        lines += ["$EndNodes", "$Elements",
                  str(sum(len(g[2]) for g in groups))]
        number = 0
        for tag, (_, _, members) in enumerate(groups, 1):
            for kind, *nodes in members:
                number += 1
                lines.append("%d %d 2 %d %d %s" % (
                    number, kind, tag, tag,
                    " ".join(str(n + 1) for n in nodes)))
        return "\n".join(lines + ["$EndElements"]) + "\n"
