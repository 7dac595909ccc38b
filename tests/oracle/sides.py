"""Groups that go round edges, cut into their sides by the oracle itself; and the
same scene with a contact zone for each side, or with its surfaces exchanged."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import copy
import math

import numpy as np

# Of neighbouring facets: more is an edge.
EDGE = math.radians(35)


def normals_of(X, facets):
    """Outward ones of straight lines (the body on the left), of triangles, or of
    faces in rows."""
    corners = X[np.array(facets)]
    if X.shape[1] == 2:
        along = corners[:, 1] - corners[:, 0]
        n = np.stack([along[:, 1], -along[:, 0]], 1)
    elif corners.shape[1] == 3:
        n = np.cross(corners[:, 1] - corners[:, 0],
                     corners[:, 2] - corners[:, 0])
    else:
        n = np.cross(corners[:, 3] - corners[:, 0],
                     corners[:, 2] - corners[:, 1])
        # Of the first row and the first column.
        first = np.cross(corners[:, 1] - corners[:, 0],
                         corners[:, 2] - corners[:, 0])
        n *= np.sign(np.einsum("fi,fi->f", n, first))[:, None]
    return n / np.linalg.norm(n, axis=1)[:, None]


def borders(facet):
    """What a facet shares with its neighbours: nodes, or the ends of edges."""
    if len(facet) == 2:
        return [frozenset([n]) for n in facet]
    ring = [facet[k] for k in ((0, 1, 2) if len(facet) == 3 else (0, 1, 3, 2))]
    return [frozenset(pair) for pair in zip(ring, ring[1:] + ring[:1])]


def neighbours(X, facets):
    """Pairs of facets with a common border, and the angle between them."""
    n = normals_of(X, facets)
    at = {}
    for k, facet in enumerate(facets):
        for border in borders(list(facet)):
            at.setdefault(border, []).append(k)
    return [(a, b, math.acos(min(1, max(-1, n[a] @ n[b]))))
            for these in at.values() for a in these for b in these if a < b]


def sides_of(X, facets):
    """The number of the side of each facet."""
    side = list(range(len(facets)))
    for a, b, angle in neighbours(X, facets):
        if angle <= EDGE and side[a] != side[b]:
            old, new = side[b], side[a]
            side = [new if k == old else k for k in side]
    numbers = {k: i for i, k in enumerate(dict.fromkeys(side))}
    return np.array([numbers[k] for k in side])


def turn_of(X, facets):
    """The largest angle between neighbours of one side."""
    return max([angle for _, _, angle in neighbours(X, facets)
                if angle <= EDGE] + [0.0])


def cut(scene):
    """With a zone for each side of a slave, against the whole of its master."""
    other = scene.varied(copy.copy(scene.mesh))
    other.mesh.lines = dict(scene.mesh.lines)
    other.zones = []
    for zone in scene.zones:
        facets = scene.mesh.lines[zone.slave]
        side = sides_of(scene.mesh.X, facets)
        for k in range(side.max() + 1):
            name = "%s_%d" % (zone.slave, k)
            other.mesh.lines[name] = [f for f, s in zip(facets, side)
                                      if s == k]
            part = copy.deepcopy(zone)
            part.slave, part.name = name, (zone.name + " " + name).strip()
            other.zones.append(part)
    return other


def exchanged(scene):
    """Slaves and masters in each other's place."""
    other = copy.deepcopy(scene)
    for zone in other.zones:
        zone.slave, zone.master = zone.master, zone.slave
    return other
