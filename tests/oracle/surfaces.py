"""Deformed surfaces as polylines: distances, normals, what lies inside."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import elements

# Pieces of an edge of degree 2.
PIECES = 24
# Sine of the angle beyond which the closest place is not straight ahead.
BESIDE = 0.3


class Polyline:
    """The lines of a group, each with its body on the left."""

    def __init__(self, lines, x):
        self.lines = lines
        if lines.shape[1] == 2:
            begin, end = x[lines[:, 0]], x[lines[:, 1]]
            self.line = np.arange(len(lines))
        else:
            cuts = np.array([elements.edge(s, 2)[0] for s in
                             np.linspace(-1, 1, PIECES + 1)])
            points = np.einsum("ca,eai->eci", cuts, x[lines])
            begin = points[:, :-1].reshape(-1, 2)
            end = points[:, 1:].reshape(-1, 2)
            self.line = np.repeat(np.arange(len(lines)), PIECES)
        self.begin, self.end = begin, end
        along = end - begin
        self.length = np.maximum(np.hypot(*along.T), 1e-300)
        self.tangent = along / self.length[:, None]
        self.normal = np.stack([self.tangent[:, 1], -self.tangent[:, 0]], 1)

    def closest(self, points):
        """For each point: distance, piece, place on the piece in [0, 1]."""
        r = points[:, None] - self.begin[None]
        s = np.einsum("psi,si->ps", r, self.tangent) / self.length
        s = np.clip(s, 0, 1)
        foot = self.begin + s[..., None] * (self.end - self.begin)
        distance = np.hypot(*np.moveaxis(points[:, None] - foot, 2, 0))
        piece = distance.argmin(1)
        k = np.arange(len(points))
        return distance[k, piece], piece, s[k, piece]

    def contains(self, points):
        """Of closed lines: what is inside (crossings of a ray)."""
        a, b = self.begin[None], self.end[None]
        x, y = points[:, 0, None], points[:, 1, None]
        straddles = (a[..., 1] > y) != (b[..., 1] > y)
        with np.errstate(divide="ignore", invalid="ignore"):
            cut = (a[..., 0] + (y - a[..., 1]) / (b[..., 1] - a[..., 1]) *
                   (b[..., 0] - a[..., 0]))
        return (straddles & (x < cut)).sum(1) % 2 == 1


class Obstacle:
    """A rigid body, which faces every point."""

    def faces(self, points):
        return np.ones(len(points), bool)

    def exact_gap(self, points):
        return self.gap(points)


class Half(Obstacle):
    """Of the plane or of space: a point of its boundary, the normal."""

    def __init__(self, *numbers):
        self.point, n = np.reshape(numbers, (2, -1))
        self.n = n / np.linalg.norm(n)

    def gap(self, points):
        return (points - self.point) @ self.n

    def normals(self, points):
        return np.broadcast_to(self.n, points.shape)


class Round(Obstacle):
    """A rigid disk or ball; a hole in a rigid body if the radius is
    negative."""

    def __init__(self, *numbers):
        self.centre = np.array(numbers[:-1])
        self.radius = abs(numbers[-1])
        self.sign = 1 if numbers[-1] > 0 else -1

    def arm(self, points):
        return points - self.centre

    def gap(self, points):
        return self.sign * (np.linalg.norm(self.arm(points), axis=1) -
                            self.radius)

    def normals(self, points):
        r = self.arm(points)
        return self.sign * r / np.linalg.norm(r, axis=1)[:, None]


class Cylinder(Round):
    """A point of the axis, its direction, the radius."""

    def __init__(self, *numbers):
        super().__init__(*numbers[:3], numbers[6])
        self.axis = np.array(numbers[3:6]) / np.linalg.norm(numbers[3:6])

    def arm(self, points):
        r = points - self.centre
        return r - np.outer(r @ self.axis, self.axis)


def obstacle(text):
    kind, numbers = text.split(": ")
    shape = {"half plane": Half, "half space": Half, "circle": Round,
             "sphere": Round, "cylinder": Cylinder}[kind]
    return shape(*(float(v) for v in numbers.split(",")))


def outlines(model, lines, x):
    """The closed boundaries of the bodies that lines of a group belong to."""
    mesh = model.scene.mesh
    return [Polyline(model.complete(mesh.boundary[mesh.bodies[body]]), x)
            for body in np.unique(model.body_of[lines[:, 0]])]


class DeformedBody:
    """The master of a zone: its group, and the whole outline of its bodies."""

    def __init__(self, model, zone, x):
        self.group = Polyline(model.lines[zone.master], x)
        self.outlines = outlines(model, model.lines[zone.master], x)

    def gap(self, points):
        """The distance to the group; minus the depth inside of the body."""
        gap, _, _ = self.group.closest(points)
        for outline in self.outlines:
            inside = outline.contains(points)
            if inside.any():
                gap[inside] = -outline.closest(points[inside])[0]
        return gap

    def faces(self, points):
        """Whether the closest place of the group is straight ahead, not an end
        or a corner that a point is beside of."""
        distance, piece, s = self.group.closest(points)
        foot = self.group.begin[piece] + s[:, None] * (
            self.group.end - self.group.begin)[piece]
        aside = np.abs(((points - foot) * self.group.tangent[piece]).sum(1))
        return aside <= BESIDE * distance

    def normals(self, points):
        _, piece, _ = self.group.closest(points)
        return self.group.normal[piece]


def samples(model, lines, x, per_line=9):
    """Points on each line of a group, (lines, points, 2), and the weights of
    the line's nodes there."""
    shapes = np.array([elements.edge(s, model.degree)[0]
                       for s in np.linspace(-1, 1, per_line)])
    return np.einsum("ca,eai->eci", shapes, x[lines]), shapes
