# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a mesh of second order is round: circles, spheres, cylinders and cones
that groups of its boundary are, and what becomes straight or flat without them."""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from named_mesh import Mesh

TOLERANCE = 1e-5  # of the radius, as the program has it (Arc::tolerance)


def report(mesh: Mesh) -> None:
    (report_round_sides if mesh.dimension == 2 else report_round_faces)(mesh)


@dataclass
class Side:
    """A side of second order: its ends, and the node between them."""
    ends: list[int]
    middle: int
    off: float  # distance of the node from the middle of the ends


def round_sides(mesh: Mesh) -> list[Side]:
    """The sides between a body and what is not this body whose node between the
    ends is not in their middle. Others than these can be straight without any
    change of a body."""
    bodies: dict[frozenset[int], list[set[str]]] = {}
    sides = {}
    for face in (e for e in mesh.elements if e.dimension == 2):
        n = 3 if face.kind.startswith("triangle") else 4
        for i in range(n):
            ends = [face.nodes[i], face.nodes[(i + 1) % n]]
            bodies.setdefault(frozenset(ends), []).append(face.groups)
            if len(face.nodes) >= 2 * n:
                sides[frozenset(ends)] = (ends, face.nodes[n + i])

    # As exact as sides and coordinates with nine digits are.
    size = max(abs(c) for point in mesh.points for c in point)
    found = []
    for key, (ends, middle) in sides.items():
        if len(bodies[key]) == 2 and bodies[key][0] == bodies[key][1]:
            continue
        a, b, c = (mesh.points[node] for node in (*ends, middle))
        off = math.dist(c, [(x + y) / 2 for x, y in zip(a, b)])
        if off > 1e-6 * math.dist(a, b) + 1e-9 * size:
            found.append(Side(ends, middle, off))
    return found


def circle(points) -> tuple[float, float, float] | None:
    """Centre and radius of the circle that all the points are on, with the
    tolerance of Mesh/Arcs."""
    a = points[0]
    b = max(points, key=lambda p: math.dist(p, a))

    def area(p) -> float:
        return abs((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]))

    c = max(points, key=area)
    if area(c) == 0:
        return None
    # The perpendicular bisectors of a b and of a c meet in the centre.
    (ux, uy), (vx, vy) = ((p[0] - a[0], p[1] - a[1]) for p in (b, c))
    u, v, d = ux * ux + uy * uy, vx * vx + vy * vy, 2 * (ux * vy - uy * vx)
    x, y = a[0] + (u * vy - v * uy) / d, a[1] + (v * ux - u * vx) / d
    radius = math.dist((x, y), a[:2])
    if all(abs(math.dist((x, y), p[:2]) - radius) <= TOLERANCE * radius
           for p in points):
        return x, y, radius
    return None


def report_round_sides(mesh: Mesh) -> None:
    """The program takes the corners of elements alone, and boundaries that are
    arcs of circles from Mesh/Arcs. Prints the circles of the groups that can be
    given so, and which sides become straight."""
    groups: dict[frozenset[int], set[str]] = {}
    nodes: dict[str, set[int]] = {}
    for line in (e for e in mesh.elements if e.dimension == 1):
        groups.setdefault(frozenset(line.nodes[:2]), set()).update(line.groups)
        for name in line.groups:
            nodes.setdefault(name, set()).update(line.nodes)
    circles = {}
    lost: dict[str, list[Side]] = {}
    for side in round_sides(mesh):
        names = sorted(groups.get(frozenset(side.ends), ()))
        for name in set(names) - set(circles):
            circles[name] = circle([mesh.points[i] for i in sorted(nodes[name])])
        if not any(circles[name] for name in names):
            why = (f"in the group '{names[0]}', which is not one circle"
                   if names else "in no group of lines")
            lost.setdefault(why, []).append(side)

    for name, found in sorted(circles.items()):
        if found:
            print(f"round: {name}; it stays so with Mesh/Arcs = {name}: "
                  + ", ".join(f"{c:.9g}" if abs(c) > 1e-9 * found[2] else "0"
                              for c in found))
    for why, straight in lost.items():
        print_lost_sides(mesh, why, straight,
                         "an arc, put all of it, and nothing else, in a group for "
                         "Mesh/Arcs")


def print_lost_sides(mesh: Mesh, why: str, sides: list[Side],
                     remedy: str) -> None:
    n_shown = 10
    sides.sort(key=lambda side: -side.off)
    print(f"note: {len(sides)} round sides become straight, {why}: their middle "
          f"nodes are left out, by up to {sides[0].off:.3g}. To keep {remedy}.",
          file=sys.stderr)
    for side in sides[:n_shown]:
        a, b = (", ".join(f"{c:g}" for c in mesh.points[node][:mesh.dimension])
                for node in side.ends)
        print(f"  from ({a}) to ({b}): {side.off:.3g}", file=sys.stderr)
    if len(sides) > n_shown:
        print(f"  and {len(sides) - n_shown} more", file=sys.stderr)


# ------------------------------------------------------ faces that are round

def fit_sphere(points):
    """Centre and radius, by the equation that is linear in what is sought."""
    import numpy
    middle = points.mean(axis=0)
    x = points - middle
    unknown = numpy.linalg.lstsq(
        numpy.column_stack((2 * x, numpy.ones(len(x)))), (x ** 2).sum(axis=1),
        rcond=None)[0]
    centre = unknown[:3]
    return centre + middle, math.sqrt(unknown[3] + centre @ centre)


def fit_axis(centres, normals):
    """Direction and a point of the axis of a cylinder or a cone: normals make
    one angle with it, and their lines meet it."""
    import numpy
    axis = numpy.linalg.svd(normals - normals.mean(axis=0))[2][2]
    # A line from c along n and the axis are in one plane: axis x n is
    # perpendicular to it.
    across = numpy.cross(axis, normals)
    point = numpy.linalg.lstsq(across, (across * centres).sum(axis=1),
                               rcond=None)[0]
    return axis, point


def revolve(points, centres, normals):
    """The axis (a point, a direction) of a cylinder or a cone, and the radius
    there and its slope along the axis, by Gauss-Newton steps from the normals of
    the faces; and how far the points are off."""
    import numpy

    def parts(unknown):
        point, axis = unknown[:3], unknown[3:6] / numpy.linalg.norm(unknown[3:6])
        along = (points - point) @ axis
        across = points - point - numpy.outer(along, axis)
        return numpy.linalg.norm(across, axis=1), along, axis

    def off(unknown):
        distance, along, _ = parts(unknown)
        return distance - unknown[6] - unknown[7] * along

    axis, point = fit_axis(centres, normals)
    distance, along, _ = parts(numpy.array([*point, *axis]))
    unknown = numpy.array([*point, *axis, *numpy.polyfit(along, distance, 1)[::-1]])
    size = numpy.ptp(points, axis=0).max()
    steps = 1e-6 * numpy.array([size] * 3 + [1] * 3 + [size, 1])
    for _ in range(5):
        slopes = numpy.column_stack([
            (off(unknown + step) - off(unknown - step)) / (2 * step.max())
            for step in numpy.diag(steps)])
        # Of the smallest length: some of the unknowns change nothing.
        unknown = unknown - numpy.linalg.lstsq(slopes * steps, off(unknown),
                                               rcond=1e-6)[0] * steps
    return unknown[:3], parts(unknown)[2], unknown[6], unknown[7], off(unknown)


def round_surface(points, centres, normals) -> str | None:
    """The entry of the section Mesh for the sphere, cylinder or cone that all
    points are on, with the program's tolerance; NAME stands for the group."""
    import numpy

    def text(*numbers):
        size = abs(points).max()
        return ", ".join(f"{x:.9g}" if abs(x) > 1e-9 * size else "0"
                         for x in numbers)

    centre, radius = fit_sphere(points)
    off = abs(numpy.linalg.norm(points - centre, axis=1) - radius)
    if off.max() <= TOLERANCE * radius:
        return f"Mesh/Spheres = NAME: {text(*centre, radius)}"
    point, axis, radius, slope, off = revolve(points, centres, normals)
    along = (points - point) @ axis
    if not abs(off).max() <= TOLERANCE * (radius + slope * along).max():
        return None
    if abs(slope) * numpy.ptp(along) <= TOLERANCE * radius:
        # The point of the axis that is the nearest to the origin.
        point = point - (point @ axis) * axis
        return f"Mesh/Cylinders = NAME: {text(*point, *axis, radius)}"
    apex = point - radius / slope * axis
    angle = math.degrees(math.atan(abs(slope)))
    return f"Mesh/Cones = NAME: {text(*apex, *(numpy.sign(slope) * axis), angle)}"


# Corners of the faces of a volume in order, and the nodes behind the corners on
# its edges, as meshio (VTK) numbers them.
FACES = {"hexahedron": ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5),
                        (2, 3, 7, 6), (3, 0, 4, 7)),
         "tetra": ((0, 1, 2), (0, 1, 3), (1, 2, 3), (2, 0, 3))}
MIDDLES = {shape: {frozenset(ends): n + i for i, ends in enumerate(edges)}
           for shape, n, edges in (
               ("hexahedron", 8, [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6),
                                  (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]),
               ("tetra", 4, [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]))}


def corners_of(face) -> list[int]:
    return face.nodes[:3 if face.kind.startswith("triangle") else 4]


def boundary_sides(mesh: Mesh) -> dict[frozenset[int], tuple]:
    """Of the faces that one volume alone has: each side with its ends, its middle
    node and the corners of these faces."""
    faces = {}
    for cell in mesh.of_dimension(3):
        shape = cell.kind.rstrip("0123456789")
        for face in FACES[shape] if shape != cell.kind else ():
            corners = frozenset(cell.nodes[i] for i in face)
            faces.setdefault(corners, []).append((cell, shape, face))
    sides = {}
    for corners, found in faces.items():
        if len(found) > 1:
            continue
        cell, shape, face = found[0]
        for a, b in zip(face, face[1:] + face[:1]):
            ends = cell.nodes[a], cell.nodes[b]
            middle = cell.nodes[MIDDLES[shape][frozenset((a, b))]]
            sides.setdefault(frozenset(ends), (ends, middle, []))[2].append(
                corners)
    return sides


def group_surface(mesh: Mesh, name: str) -> str | None:
    import numpy
    x = numpy.array(mesh.points)
    faces = [f for f in mesh.of_dimension(2) if name in f.groups]
    corners = [x[corners_of(f)] for f in faces]
    # Along the diagonals, or from the last corner.
    normals = numpy.array([numpy.cross(c[2] - c[0], c[-1] - c[1])
                           for c in corners])
    normals /= numpy.linalg.norm(normals, axis=1)[:, None]
    nodes = sorted({n for f in faces for n in f.nodes[:8]})
    centres = numpy.array([c.mean(axis=0) for c in corners])
    return round_surface(x[nodes], centres, normals)


def report_round_faces(mesh: Mesh) -> None:
    """As report_round_sides: prints the surfaces of the groups of faces that are
    one, and which sides become straight."""
    groups = {frozenset(corners_of(f)): f.groups for f in mesh.of_dimension(2)}
    size = max(abs(c) for point in mesh.points for c in point)
    surfaces: dict[str, str | None] = {}
    lost: dict[str, list[Side]] = {}
    for ends, middle, faces in boundary_sides(mesh).values():
        a, b, c = (mesh.points[node] for node in (*ends, middle))
        off = math.dist(c, [(p + q) / 2 for p, q in zip(a, b)])
        if off <= 1e-6 * math.dist(a, b) + 1e-9 * size:
            continue
        names = sorted({n for face in faces for n in groups.get(face, ())})
        for name in set(names) - set(surfaces):
            surfaces[name] = group_surface(mesh, name)
        if not any(surfaces[name] for name in names):
            why = (f"in the group '{names[0]}', which is not one sphere, cylinder "
                   "or cone" if names else "in no group of faces")
            lost.setdefault(why, []).append(Side(list(ends), middle, off))
    for name, entry in sorted(surfaces.items()):
        if entry:
            print(f"round: {name}; it stays so with "
                  + entry.replace("NAME", name))
    for why, straight in lost.items():
        print_lost_sides(mesh, why, straight,
                         "a sphere, cylinder or cone, put all of it, and nothing "
                         "else, in a group for Mesh/Spheres, Cylinders or Cones")
