"""Shape functions and quadrature of the plane elements: Q4, Q8, T3, T6, of
their edges, of hexahedra with 8 and 27 nodes, of tetrahedra with 4 and 10, and
of their faces.

Nodes: corners anticlockwise, then the middles of the edges 01, 12, 23, 30 (01,
12, 20 of triangles). Quadrangles live in [-1, 1]^2, triangles in x, y >= 0,
x + y <= 1, edges in [-1, 1] with the nodes begin, end, middle. Hexahedra and
their faces have their nodes in rows: x first, then y, then z. Tetrahedra live in
x, y, z >= 0, x + y + z <= 1, their nodes are the corners, then the middles of
TETRAHEDRON's edges; their faces are T3 and T6."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import itertools

import numpy as np

CORNERS = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], float)
TRIANGLE = ((0, 1), (1, 2), (2, 0))
TETRAHEDRON = (*TRIANGLE, (0, 3), (1, 3), (2, 3))


def q4(x, y):
    shape = np.array([(1 + a * x) * (1 + b * y) / 4 for a, b in CORNERS])
    slope = np.array([[a * (1 + b * y) / 4, b * (1 + a * x) / 4]
                      for a, b in CORNERS])
    return shape, slope


def q8(x, y):
    """The serendipity element."""
    shape = [(1 + a * x) * (1 + b * y) * (a * x + b * y - 1) / 4
             for a, b in CORNERS]
    slope = [[a * (1 + b * y) * (2 * a * x + b * y) / 4,
              b * (1 + a * x) * (a * x + 2 * b * y) / 4] for a, b in CORNERS]
    for a, b in ((0, -1), (1, 0), (0, 1), (-1, 0)):
        if a == 0:
            shape.append((1 - x * x) * (1 + b * y) / 2)
            slope.append([-x * (1 + b * y), b * (1 - x * x) / 2])
        else:
            shape.append((1 - y * y) * (1 + a * x) / 2)
            slope.append([a * (1 - y * y) / 2, -y * (1 + a * x)])
    return np.array(shape), np.array(slope)


def t3(x, y):
    return (np.array([1 - x - y, x, y]),
            np.array([[-1, -1], [1, 0], [0, 1]], float))


def t6(x, y):
    return quadratic(*t3(x, y), TRIANGLE)


def tetrahedron(place, degree):
    c = np.array([1 - sum(place), *place])
    slope = np.concatenate([-np.ones((1, 3)), np.eye(3)])
    return (c, slope) if degree == 1 else quadratic(c, slope, TETRAHEDRON)


def quadratic(c, slope, pairs):
    """Of a simplex with these linear functions and their gradients."""
    return (np.array([a * (2 * a - 1) for a in c] +
                     [4 * c[i] * c[j] for i, j in pairs]),
            np.array([(4 * a - 1) * s for a, s in zip(c, slope)] +
                     [4 * (c[i] * slope[j] + c[j] * slope[i])
                      for i, j in pairs]))


def edge(x, degree):
    if degree == 1:
        return (np.array([(1 - x) / 2, (1 + x) / 2]), np.array([-0.5, 0.5]))
    return (np.array([x * (x - 1) / 2, x * (x + 1) / 2, 1 - x * x]),
            np.array([x - 0.5, x + 0.5, -2 * x]))


def gauss_square(n):
    points, weights = np.polynomial.legendre.leggauss(n)
    return [((x, y), v * w) for y, v in zip(points, weights)
            for x, w in zip(points, weights)]


def gauss_triangle(degree):
    if degree == 1:
        return [((1 / 3, 1 / 3), 0.5)]
    points = ((1 / 6, 1 / 6), (2 / 3, 1 / 6), (1 / 6, 2 / 3))
    return [(p, 1 / 6) for p in points]


def hammer_seven():
    """Exact to degree 5 (Radon): for body forces on triangles."""
    r = 15 ** 0.5
    points = [((1 / 3, 1 / 3), 9 / 80)]
    for a, w in (((6 - r) / 21, (155 - r) / 2400), ((6 + r) / 21,
                                                    (155 + r) / 2400)):
        points += [((a, a), w), ((1 - 2 * a, a), w), ((a, 1 - 2 * a), w)]
    return points


def gauss_tetrahedron(degree):
    """Exact to degree 1 and 3: the points of the program (Witherden and Vincent
    2015)."""
    if degree == 1:
        return [((1 / 4,) * 3, 1 / 6)]
    points = []
    for a, w in ((0.32816330251638171, 0.13621784253708741),
                 (0.10804724989842859, 0.11378215746291259)):
        b = 1 - 3 * a
        points += [(place, w / 6) for place in ((a, a, a), (b, a, a), (a, b, a),
                                                (a, a, b))]
    return points


def collapsed(n, dim):
    """Gauss points of a square or cube that is collapsed to a simplex: exact to
    degree 2 n - dim."""
    found = []
    for place, w in gauss_cube(n, dim):
        at, left = [], 1.0
        for x in place:
            w *= left / 2
            at.append(left * (1 + x) / 2)
            left -= at[-1]
        found.append((at, w))
    return found


def face(place, n):
    """Of a face with n nodes."""
    if n in (3, 6):
        return (t3 if n == 3 else t6)(*place)
    return tensor(place, 1 if n == 4 else 2)


def face_rule(n, points):
    """So many points along each side of a face with n nodes."""
    return collapsed(points, 2) if n in (3, 6) else gauss_cube(points, 2)


def tensor(place, degree):
    """The products of edges: shape functions and gradients at a place of a face
    or a hexahedron."""
    order = [0, 1] if degree == 1 else [0, 2, 1]
    axes = [[table[order] for table in edge(x, degree)] for x in place]
    product = lambda factors: np.einsum(
        "k,j->kj", factors[-1], product(factors[:-1])).ravel() if (
            len(factors) > 1) else factors[0]
    values = [value for value, _ in axes]
    slopes = [product(values[:d] + [axes[d][1]] + values[d + 1:])
              for d in range(len(axes))]
    return product(values), np.stack(slopes, 1)


def gauss_cube(n, dim):
    points, weights = np.polynomial.legendre.leggauss(n)
    return [([points[k] for k in place], np.prod(weights[list(place)]))
            for place in itertools.product(range(n), repeat=dim)]


def rule(kind, degree):
    """Shape functions and points of an element: those of the stiffness."""
    if kind == "tet":
        return ((lambda *place: tetrahedron(place, degree)),
                gauss_tetrahedron(degree))
    if kind == "hex":
        return ((lambda *place: tensor(place, degree)),
                gauss_cube(degree + 1, 3))
    if kind == "quad":
        return (q4 if degree == 1 else q8), gauss_square(degree + 1)
    return (t3 if degree == 1 else t6), gauss_triangle(degree)
