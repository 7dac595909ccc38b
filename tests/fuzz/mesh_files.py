"""Small meshes of two bodies, as gmsh files.

A body is a grid of nx times ny cells between two curves y(x). The grid may be
graded, distorted, split into triangles, and its numbers shuffled: whatever a
mesh generator could have done to it.
"""
# SPDX-License-Identifier: LGPL-2.1-or-later
import math


class Body:
    """A named grid. `bottom` and `top` are functions y(x), `narrowing` is how
    much narrower the top is than the bottom, as a part of the width."""

    def __init__(self, name, left, right, bottom, top, cells, narrowing=0.0):
        self.name = name
        self.left, self.right = left, right
        self.bottom, self.top = bottom, top
        self.nx, self.ny = cells
        self.narrowing = narrowing
        self.nodes = {}
        self.cells = []

    def build(self, rng, distortion=0.0, triangles=0.0, grading=1.0):
        """Place the nodes and cut the cells; `triangles` is the share of the
        cells which are split in two."""
        nx, ny = self.nx, self.ny
        width = self.right - self.left
        total = sum(grading ** i for i in range(nx))
        places = [sum(grading ** k for k in range(i)) / total
                  for i in range(nx + 1)]
        steps = [min(places[min(i + 1, nx)] - places[min(i + 1, nx) - 1],
                     places[max(i, 1)] - places[max(i, 1) - 1])
                 for i in range(nx + 1)]
        for j in range(ny + 1):
            for i in range(nx + 1):
                xi, eta = places[i], j / ny
                # The sides stay straight, the curves stay curves.
                if 0 < i < nx:
                    xi += distortion * rng.uniform(-1, 1) * steps[i]
                if 0 < j < ny:
                    eta += distortion * rng.uniform(-1, 1) / ny
                x = self.left + xi * width
                low, high = self.bottom(x), self.top(x)
                y = low + eta * (high - low)
                middle = 0.5 * (self.left + self.right)
                x = middle + (x - middle) * (1 - self.narrowing * eta)
                self.nodes[i, j] = (x, y)
        for j in range(ny):
            for i in range(nx):
                a, b = (i, j), (i + 1, j)
                c, d = (i + 1, j + 1), (i, j + 1)
                if rng.random() >= triangles:
                    self.cells.append((a, b, c, d))
                elif rng.random() < 0.5:
                    self.cells += [(a, b, c), (a, c, d)]
                else:
                    self.cells += [(a, b, d), (b, c, d)]

    def side(self, name):
        """The edges of a side, as pairs of grid positions."""
        nx, ny = self.nx, self.ny
        if name in ("Bottom", "Top"):
            j = 0 if name == "Bottom" else ny
            return [((i, j), (i + 1, j)) for i in range(nx)]
        i = 0 if name == "Left" else nx
        return [((i, j), (i, j + 1)) for j in range(ny)]


def msh_text(bodies, lines, points, version, rng, second_order=False):
    """The text of a mesh file. `lines` maps a group to (body, side), `points`
    maps a group to (body, grid position)."""
    number, order = {}, []
    for body in bodies:
        for position in body.nodes:
            order.append((body.name, position))
    rng.shuffle(order)
    step = rng.choice([1, 1, 3])
    for k, key in enumerate(order):
        number[key] = 1 + k * step
    coordinates = {number[body.name, p]: xy
                   for body in bodies for p, xy in body.nodes.items()}
    middles = {}

    def middle(*corners):
        key = tuple(sorted(corners))
        if key not in middles:
            middles[key] = max(coordinates) + 1
            coordinates[middles[key]] = tuple(
                sum(coordinates[c][d] for c in corners) / len(corners)
                for d in (0, 1))
        return middles[key]

    def complete(nodes):
        """Add the mid-sides, as gmsh orders them, and name the type."""
        nodes = list(nodes)
        n = len(nodes)
        if second_order and n == 2:
            nodes.append(middle(*nodes))
        elif second_order and n > 2:
            nodes += [middle(nodes[i], nodes[(i + 1) % n]) for i in range(n)]
        kind = {1: 15, 2: 1, 3: 2, 4: 3}[n]
        if second_order:
            kind = {1: 15, 2: 8, 3: 9, 4: 16}[n]
        return kind, nodes

    # Groups in one list: dimension, tag, name, elements.
    groups = []
    for name, (body, position) in points.items():
        groups.append((0, name, [[number[body.name, position]]]))
    for name, (body, side) in lines.items():
        groups.append((1, name, [[number[body.name, a], number[body.name, b]]
                                 for a, b in body.side(side)]))
    for body in bodies:
        cells = []
        for cell in body.cells:
            nodes = [number[body.name, p] for p in cell]
            turn = rng.randrange(len(nodes))
            nodes = nodes[turn:] + nodes[:turn]
            cells.append(nodes[::-1] if rng.random() < 0.2 else nodes)
        groups.append((2, body.name, cells))
    groups = [(dimension, tag, name, [complete(e) for e in elements])
              for tag, (dimension, name, elements) in enumerate(groups, 1)]

    text = ["$MeshFormat", version + " 0 8", "$EndMeshFormat",
            "$PhysicalNames", str(len(groups))]
    text += ['%d %d "%s"' % group[:3] for group in groups]
    text.append("$EndPhysicalNames")
    write = write_22 if version == "2.2" else write_41
    return "\n".join(text + write(coordinates, groups)) + "\n"


def write_22(coordinates, groups):
    text = ["$Nodes", str(len(coordinates))]
    text += ["%d %.16g %.16g 0" % (n, *xy) for n, xy in coordinates.items()]
    text += ["$EndNodes", "$Elements", str(sum(len(g[3]) for g in groups))]
    element = 0
    for _, tag, _, elements in groups:
        for kind, nodes in elements:
            element += 1
            text.append(" ".join(map(str, [element, kind, 2, tag, tag, *nodes])))
    return text + ["$EndElements"]


def write_41(coordinates, groups):
    counts = [sum(1 for g in groups if g[0] == d) for d in range(3)]
    text = ["$Entities", "%d %d %d 0" % tuple(counts)]
    for dimension, tag, _, _ in groups:
        box = "0 0 0" if dimension == 0 else "0 0 0 0 0 0"
        text.append("%d %s 1 %d%s" % (tag, box, tag,
                                      " 0" if dimension > 0 else ""))
    text += ["$EndEntities", "$Nodes"]
    first_body = next(g[1] for g in groups if g[0] == 2)
    n = len(coordinates)
    text.append("1 %d %d %d" % (n, min(coordinates), max(coordinates)))
    text.append("2 %d 0 %d" % (first_body, n))
    text += [str(k) for k in coordinates]
    text += ["%.16g %.16g 0" % xy for xy in coordinates.values()]
    text += ["$EndNodes", "$Elements"]
    blocks, element = [], 0
    for dimension, tag, _, elements in groups:
        by_kind = {}
        for kind, nodes in elements:
            by_kind.setdefault(kind, []).append(nodes)
        for kind, list_of_nodes in by_kind.items():
            block = ["%d %d %d %d" % (dimension, tag, kind, len(list_of_nodes))]
            for nodes in list_of_nodes:
                element += 1
                block.append(" ".join(map(str, [element, *nodes])))
            blocks.append(block)
    text.append("%d %d 1 %d" % (len(blocks), element, element))
    for block in blocks:
        text += block
    return text + ["$EndElements"]


def flat(y, slope=0.0):
    return lambda x: y + slope * x


def parabola(y, centre, radius):
    """Convex downwards for a positive radius, with its vertex at `centre`."""
    return lambda x: y + (x - centre) ** 2 / (2 * radius)


def arc(y, centre, radius):
    return lambda x: y + radius - math.sqrt(radius ** 2 - (x - centre) ** 2)
