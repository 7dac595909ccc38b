# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes in 3-D that are turned about all axes, for the scripts beside this
one: rotations, supports that hold rigid motions alone, loads of a uniform
stress, and the loads that complete a pressure where two surfaces overlap in
part."""

import itertools
import math

import numpy

from block_scenes import check, rows, violations

SURFACES = ("x0", "x1", "y0", "y1", "z0", "z1")
AXES = "xyz"
ROUND_OFF = 1e-14


def probes(summary):
    return {p["name"]: p["value"] for p in summary["probes"]}


def converged(what, status, summary, said):
    violated = violations(summary)
    check(f"{what}: converges, and no invariant is violated",
          status == 0 and not violated, said if status else violated)
    return status == 0


def rotation(degrees):
    """As the entry Mesh/Rotation: about x, then y, then z."""
    turned = numpy.eye(3)
    for axis, angle in enumerate(degrees):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        a, b = (axis + 1) % 3, (axis + 2) % 3
        one = numpy.eye(3)
        one[a, a], one[a, b], one[b, a], one[b, b] = c, -s, s, c
        turned = one @ turned
    return turned


def merged(*groups):
    """Entries of the same name joined."""
    entries = {}
    for group in groups:
        for entry, values in group.items():
            separator = "; " if entry.split("/")[1] in LISTS else ", "
            entries[entry] = entries[entry] + separator + values \
                if entry in entries else values
    return entries


LISTS = ("Pressure", "Traction x", "Traction y", "Traction z")


def minimal_supports(points, rows=()):
    """Displacements of points that hold rigid motions, no more of them than it
    takes. 'points': {group: place}; 'rows': what else holds the body, as
    functionals of translation and rotation."""
    rows, entries = [numpy.asarray(row) for row in rows], {}
    for name, place in points.items():
        x, y, z = place
        turns = numpy.array([[0, z, -y], [-z, 0, x], [y, -x, 0]])
        best = sorted(range(3), key=lambda c: -remainder(
            numpy.concatenate((numpy.eye(3)[c], turns[c])), rows))
        for c in best:
            row = numpy.concatenate((numpy.eye(3)[c], turns[c]))
            if remainder(row, rows) > 0.1:
                rows.append(row)
                entry = f"Boundary conditions/Displacement {AXES[c]}"
                entries = merged(entries, {entry: f"{name}: 0"})
    assert numpy.linalg.matrix_rank(numpy.array(rows)) == 6
    return entries


def block_supports(low, up, turn, with_shear):
    """Three corners of each of two blocks, which are turned; contact holds the
    upper one along the normal, and where it sticks, altogether."""
    def corners(body, block, t):
        return {f"{body}_{i}{j}{t}": turn @ block.chart(i, j, t)
                for i, j in ((0, 0), (1, 0), (0, 1))}
    entries = minimal_supports(corners("Low", low, 0))
    if not with_shear:
        normal = turn @ [0, 0, 1.]
        contact = [numpy.concatenate((normal, numpy.cross(turn @ x, normal)))
                   for x in numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]])]
        entries = merged(entries,
                         minimal_supports(corners("Up", up, 1), contact))
    return entries


def remainder(row, rows):
    if not rows:
        return numpy.linalg.norm(row)
    A = numpy.array(rows).T
    return numpy.linalg.norm(row - A @ numpy.linalg.lstsq(A, row,
                                                          rcond=None)[0])


def uniform_loads(body, stress, turn, surfaces, own_turn):
    """Tractions of a uniform stress, in the axes of the scene before it is
    turned, on sides of a block that has a turn of its own in it."""
    entries = {}
    for surface in surfaces:
        normal = numpy.zeros(3)
        normal[AXES.index(surface[0])] = 1 if surface[1] == "1" else -1
        traction = turn @ stress @ own_turn @ normal
        for c in range(3):
            if abs(traction[c]) > ROUND_OFF * abs(stress).max():
                entries = merged(entries, {
                    f"Boundary conditions/Traction {AXES[c]}":
                    f"{body}_{surface}: {float(traction[c])!r}"})
    return entries


def clip(polygon, corners):
    """The part of a convex polygon in a convex polygon (counterclockwise)."""
    for a, b in zip(corners, corners[1:] + corners[:1]):
        def inside(p):
            return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
        result = []
        for p, q in zip(polygon, polygon[1:] + polygon[:1]):
            s, t = inside(p), inside(q)
            if s >= 0:
                result.append(p)
            if s * t < 0:
                result.append(tuple(numpy.add(p, numpy.multiply(
                    s / (s - t), numpy.subtract(q, p)))))
        polygon = result
    return polygon


def legendre(degree, x):
    return (1, x, 1.5 * x * x - 0.5)[degree]


def covered_moments(cell, corners, degree):
    """Coefficients in products of Legendre polynomials of the function that is 1
    inside of a convex polygon, projected on a rectangle."""
    (x0, x1), (y0, y1) = cell
    part = clip([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], corners)
    moments = numpy.zeros((degree + 1, degree + 1))
    points, weights = numpy.polynomial.legendre.leggauss(4)
    for k in range(1, len(part) - 1):
        a, b, c = (numpy.array(part[i]) for i in (0, k, k + 1))
        area = numpy.cross(b - a, c - a) / 2
        for (s, u), (t, v) in itertools.product(
                zip((points + 1) / 2, weights / 2), repeat=2):
            x, y = a + s * (b - a) + s * t * (c - b)
            xi = (2 * x - x0 - x1) / (x1 - x0)
            eta = (2 * y - y0 - y1) / (y1 - y0)
            for i, j in itertools.product(range(degree + 1), repeat=2):
                moments[i, j] += 2 * area * u * v * s * \
                    legendre(i, xi) * legendre(j, eta)
    for i, j in itertools.product(range(degree + 1), repeat=2):
        moments[i, j] *= (2 * i + 1) * (2 * j + 1) / ((x1 - x0) * (y1 - y0))
    return moments


def completing_share(lines_x, lines_y, corners, degree, turn):
    """A formula on a surface z = 0 of rectangles that is turned: against all
    shape functions it has the same integrals as the function that is 1 outside
    of a convex polygon. On rectangles that the border of the polygon cuts it is
    the projection on the polynomials of the degree. As short as it can be: the
    parser takes 5000 characters."""
    local = ["(" + "+".join(f"({float(turn[c, d])!r})*{AXES[c]}"
                            for c in range(3)) + ")" for d in range(2)]
    columns = []
    for x0, x1 in zip(lines_x, lines_x[1:]):
        cells = []
        for y0, y1 in zip(lines_y, lines_y[1:]):
            share = -covered_moments(((x0, x1), (y0, y1)), corners, degree)
            share[0, 0] += 1
            share[abs(share) < ROUND_OFF] = 0
            share = monomials(x0, x1, degree).T @ share @ \
                monomials(y0, y1, degree)
            cells.append(horner([horner([f"{float(c)!r}" if c else "0"
                                         for c in row], local[1])
                                 for row in share], local[0]))
        columns.append(choice(cells, lines_y, local[1]))
    return choice(columns, lines_x, local[0])


def monomials(x0, x1, degree):
    """The Legendre polynomials of an interval, by row, in powers of x."""
    x = numpy.polynomial.Polynomial((-(x0 + x1) / (x1 - x0), 2 / (x1 - x0)))
    table = numpy.zeros((degree + 1, degree + 1))
    for i in range(degree + 1):
        coefficients = numpy.polynomial.polynomial.Polynomial(
            numpy.polynomial.legendre.leg2poly([0] * i + [1]))(x).coef
        table[i, :len(coefficients)] = coefficients
    return table


def horner(coefficients, x):
    text = "0"
    for coefficient in reversed(coefficients):
        if text == "0":
            text = coefficient
        elif coefficient == "0":
            text = f"{x}*({text})"
        else:
            text = f"{coefficient}+{x}*({text})"
    return text


def choice(texts, lines, x):
    """The first one below lines[1] and so on; equal neighbors are one."""
    result = texts[-1]
    for text, line in zip(reversed(texts[:-1]), reversed(lines[1:-1])):
        if text != result:
            result = f"if({x}<{line!r},{text},{result})"
    return result


def check_patch(what, stress, turn, pressure, slave, summary):
    """Of the case 'patch', turned: stresses at the probes, pressure and shear at
    each node, and the balance of forces and moments."""
    turned = turn @ stress @ turn.T
    worst = max(abs(value - turned["xyz".index(name[-2]), "xyz".index(name[-1])])
                for name, value in probes(summary).items()) / pressure
    check(f"{what}: stresses", worst < 1e-10, worst)
    check_interface(what, stress, turn, pressure, -1 if slave == "Up" else 1)
    balance = summary["increments"][-1]["invariants"]
    check(f"{what}: forces and moments balance",
          max(balance["force_imbalance"], balance["moment_imbalance"]) < 1e-12,
          balance)


def check_interface(what, stress, turn, pressure, normal):
    """Pressure and shear of every node, weighted by its area: next to nothing of
    the surface belongs to some, and their pressure is a quotient of round-off."""
    nodes = [row for row in rows("patch")
             if row["surface"] == "slave" and row["pressure_MPa"] > 0]
    mean = sum(row["nodal_force_N"] for row in nodes) / len(nodes) / pressure
    shear = turn @ (normal * stress @ [0, 0, 1] * (1, 1, 0))
    worst = 0
    for row in nodes:
        of_node = min(1, row["nodal_force_N"] / row["pressure_MPa"] / mean)
        errors = [abs(row["pressure_MPa"] - pressure)] + [
            abs(row[f"shear_{c}_MPa"] - shear[i]) for i, c in enumerate("xyz")]
        worst = max(worst, of_node * max(errors) / pressure)
    check(f"{what}: pressure and shear of {len(nodes)} nodes",
          len(nodes) > 8 and worst < 1e-10, worst)
