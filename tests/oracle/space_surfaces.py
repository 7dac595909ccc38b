"""Deformed surfaces in 3-D as triangles: distances, normals, what lies
inside."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
from scipy.spatial import cKDTree

import elements
import motions
import surfaces

# Cuts of a face along each side, by its number of nodes; the corners of faces
# around them, and those of 3 and 6 nodes, whose places have x, y >= 0, x + y <= 1.
CUTS = {3: 1, 4: 2, 6: 4, 9: 4}
RINGS = {3: [0, 1, 2], 6: [0, 1, 2], 4: [0, 1, 3, 2], 9: [0, 2, 8, 6]}
TRIANGLES = (3, 6)
# Pairs of points and triangles at a time.
PAIRS = 200000
# Of a face: facets that come so close to a place meet there.
MEET = 1e-6
# Along an edge.
RIM = 65
# Of Newton's method for a place on a face.
STEPS = 6


def grid(n, nodes):
    """Places of a face in rows, and the triangles between them."""
    if nodes in TRIANGLES:
        places = [(x / n, y / n) for y in range(n + 1) for x in range(n + 1 - y)]
        at = {(round(n * x), round(n * y)): k for k, (x, y) in enumerate(places)}
        return places, np.array(
            [[at[x, y], at[x + 1, y], at[x, y + 1]] for x, y in at
             if x + y < n] +
            [[at[x + 1, y], at[x + 1, y + 1], at[x, y + 1]] for x, y in at
             if x + y < n - 1])
    axis = np.linspace(-1, 1, n + 1)
    places = [(x, y) for y in axis for x in axis]
    at = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    a, b, c, d = at[:-1, :-1], at[:-1, 1:], at[1:, :-1], at[1:, 1:]
    return places, np.concatenate([np.stack([a, b, d], -1).reshape(-1, 3),
                                   np.stack([a, d, c], -1).reshape(-1, 3)])


def shape_functions(places, n):
    """Those of faces with n nodes at many places, (places, nodes), and their
    first and second derivatives."""
    if n in TRIANGLES:
        return of_triangles(places, n)
    degree = 1 if n == 4 else 2
    values, slopes, bends = ([] for _ in range(3))
    for x in places.T:
        one, zero = np.ones_like(x), np.zeros_like(x)
        if degree == 1:
            values.append(np.stack([(1 - x) / 2, (1 + x) / 2], 1))
            slopes.append(np.stack([-one / 2, one / 2], 1))
            bends.append(np.stack([zero, zero], 1))
        else:
            values.append(np.stack([x * (x - 1) / 2, 1 - x * x,
                                    x * (x + 1) / 2], 1))
            slopes.append(np.stack([x - one / 2, -2 * x, x + one / 2], 1))
            bends.append(np.stack([one, -2 * one, one], 1))
    # The first coordinate runs first.
    product = lambda f, g: np.einsum("pk,pj->pkj", g, f).reshape(len(f), -1)
    (fx, fy), (dx, dy), (bx, by) = values, slopes, bends
    mixed = product(dx, dy)
    return (product(fx, fy),
            np.stack([product(dx, fy), product(fx, dy)], 2),
            np.stack([np.stack([product(bx, fy), mixed], 2),
                      np.stack([mixed, product(fx, by)], 2)], 3))


def of_triangles(places, n):
    c = np.concatenate([1 - places.sum(1, keepdims=True), places], 1)
    slope = np.array([[-1, -1], [1, 0], [0, 1]], float)
    flat = np.broadcast_to(slope, (len(c), 3, 2))
    if n == 3:
        return c, flat, np.zeros((len(c), 3, 2, 2))
    a, b = np.array(elements.TRIANGLE).T
    mixed = 4 * np.einsum("nd,ne->nde", slope[a], slope[b])
    bends = np.concatenate([4 * np.einsum("nd,ne->nde", slope, slope),
                            mixed + mixed.swapaxes(1, 2)])
    return (np.concatenate([c * (2 * c - 1), 4 * c[:, a] * c[:, b]], 1),
            np.concatenate([(4 * c[:, :, None] - 1) * slope,
                            4 * (c[:, a, None] * slope[b] +
                                 c[:, b, None] * slope[a])], 1),
            np.broadcast_to(bends, (len(c), *bends.shape)))


def within(places, n):
    """The nearest places of the face, about."""
    if n not in TRIANGLES:
        return np.clip(places, -1, 1)
    places = np.maximum(places, 0)
    beyond = np.maximum(places.sum(1, keepdims=True) - 1, 0)
    places = np.maximum(places - beyond / 2, 0)
    return places / np.maximum(places.sum(1, keepdims=True), 1)


class Facets:
    """The faces of a group, each with its normal away from its body."""

    def __init__(self, faces, x, cuts=None):
        self.faces = faces
        n = self.n = faces.shape[1]
        places, triangles = grid(cuts or CUTS[n], n)
        self.places = np.array(places)
        self.shapes = np.array([elements.face(p, n)[0] for p in places])
        self.x = x[faces]
        points = np.einsum("ca,fai->fci", self.shapes, self.x)
        corners = points[:, triangles].reshape(-1, 3, 3)
        self.triangles = np.tile(triangles, (len(faces), 1))
        self.face = np.repeat(np.arange(len(faces)), len(triangles))
        self.a, self.b, self.c = corners.transpose(1, 0, 2)
        normal = np.cross(self.b - self.a, self.c - self.a)
        self.area = np.linalg.norm(normal, axis=1) / 2
        self.normal = normal / np.maximum(2 * self.area, 1e-300)[:, None]
        self.middle = corners.mean(1)
        self.reach = np.linalg.norm(corners - self.middle[:, None],
                                    axis=2).max()
        self.tree = cKDTree(self.middle)
        # Of each face: a length, and the sum of its normals by area.
        of_face = np.zeros((len(faces), 3))
        np.add.at(of_face, self.face, self.normal * self.area[:, None])
        self.face_area = np.linalg.norm(of_face, axis=1)
        self.face_normal = of_face / np.maximum(self.face_area,
                                                1e-300)[:, None]
        # Of a triangle with a right angle the longest side.
        self.face_size = np.sqrt(self.face_area) * (1 + (n in TRIANGLES))

    def closest(self, points):
        """For each point: distance, triangle, foot, shape functions of the
        face there."""
        of, t, distance, feet, weights, first = self.pairs(points)
        t = t[first]
        shapes = np.einsum("pk,pka->pa", weights[first],
                           self.shapes[self.triangles[t]])
        return distance[first], t, feet[first], shapes

    def feet(self, points):
        """For each point: face, place on it and shape functions of the closest
        place, on the face itself and not on the triangles that it is cut into:
        by Newton's method for the place, from that on the triangle; where that
        leaves the face or goes further away, the latter."""
        _, t, _, _, weights, first = self.pairs(points)
        t = t[first]
        face = self.face[t]
        start = np.einsum("pk,pkd->pd", weights[first],
                          self.places[self.triangles[t]])
        place = start.copy()
        for _ in range(STEPS):
            N, dN, ddN = shape_functions(place, self.n)
            off = points - np.einsum("pa,pai->pi", N, self.x[face])
            along = np.einsum("pad,pai->pdi", dN, self.x[face])
            bend = np.einsum("pade,pai->pdei", ddN, self.x[face])
            A = along @ along.swapaxes(1, 2) - np.einsum("pdei,pi->pde", bend,
                                                         off)
            b = np.einsum("pdi,pi->pd", along, off)
            regular = np.abs(np.linalg.det(A)) > 1e-12 * self.face_size[
                face] ** 4
            A[~regular], b[~regular] = np.eye(2), 0
            place = within(place + np.linalg.solve(A, b[:, :, None])[:, :, 0],
                           self.n)
        distance = [np.linalg.norm(points - np.einsum(
            "pa,pai->pi", shape_functions(at, self.n)[0], self.x[face]),
            axis=1) for at in (start, place)]
        worse = distance[1] > distance[0]
        place[worse] = start[worse]
        return face, place, shape_functions(place, self.n)[0]

    def signed(self, points):
        """For each point: the foot on the face itself, and the distance, minus
        it behind the face."""
        face, place, shapes = self.feet(points)
        foot = np.einsum("pa,pai->pi", shapes, self.x[face])
        along = np.einsum("pad,pai->dpi", shape_functions(
            place, self.n)[1], self.x[face])
        normal = np.cross(*along)
        normal *= np.sign(np.einsum("pi,pi->p", normal, self.face_normal[
            face]))[:, None]
        off = points - foot
        return foot, np.copysign(np.linalg.norm(off, axis=1),
                                 np.einsum("pi,pi->p", off, normal))

    def rim(self):
        """Places along the edges that belong to one face only."""
        ring = RINGS[self.n]
        ends = np.array([ring, ring[1:] + ring[:1]]).T
        edges = np.concatenate([self.faces[:, pair] for pair in ends])
        of_face = np.tile(np.arange(len(self.faces)), len(ring))
        _, first, count = np.unique(np.sort(edges, axis=1), axis=0,
                                    return_index=True, return_counts=True)
        corners = np.array([(0, 0), (1, 0), (0, 1)] if self.n in TRIANGLES else
                           [(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
        along = np.linspace(0, 1, RIM)[:, None]
        shapes = np.array([shape_functions(
            (1 - along) * a + along * b, self.n)[0] for a, b in zip(
                corners, np.roll(corners, -1, axis=0))])
        rim = first[count == 1]
        return np.einsum("esa,eai->esi", shapes[rim // len(self.faces)],
                         self.x[of_face[rim]]).reshape(-1, 3)

    def crossed(self, points):
        """Faces with a place straight before one of these points, which is
        nearer to it than the size of the face."""
        face, place, shapes = self.feet(points)
        foot = np.einsum("pa,pai->pi", shapes, self.x[face])
        if self.n in TRIANGLES:
            inside = (place > MEET).all(1) & (place.sum(1) < 1 - MEET)
        else:
            inside = (np.abs(place) < 1 - MEET).all(1)
        near = np.linalg.norm(points - foot, axis=1) < self.face_size[face]
        return np.isin(np.arange(len(self.faces)), face[inside & near])

    def mean_normals(self, points):
        """Where the closest place is on an edge or a corner, the mean of the
        facets that meet there: no single one is the master's normal."""
        of, t, _, feet, _, first = self.pairs(points)
        off = np.linalg.norm(feet - feet[first][of], axis=1)
        meet = off <= MEET * self.face_size[self.face[t]]
        # Each face once, of however many triangles it is.
        _, k = np.unique(of[meet] * len(self.faces) + self.face[t[meet]],
                         return_index=True)
        total = np.zeros((len(points), 3))
        np.add.at(total, of[meet][k], self.normal[t[meet][k]])
        size = np.linalg.norm(total, axis=1, keepdims=True)
        return total / np.maximum(size, 1e-300)

    def pairs(self, points):
        """Points and the triangles that may be closest: numbers of both,
        distances, feet, their places in the triangles, and which pair is the
        closest one of each point."""
        nearest, _ = self.tree.query(points)
        near = self.tree.query_ball_point(points, nearest + 2 * self.reach)
        count = np.array([len(n) for n in near])
        pairs = np.concatenate([np.array(n, int) for n in near])
        of = np.repeat(np.arange(len(points)), count)
        feet, distance = np.empty((len(of), 3)), np.empty(len(of))
        weights = np.empty((len(of), 3))
        for k in range(0, len(of), PAIRS):
            part = slice(k, k + PAIRS)
            t = pairs[part]
            weights[part] = barycentric(points[of[part]], self.a[t],
                                        self.b[t], self.c[t])
            feet[part] = (weights[part, :1] * self.a[t] +
                          weights[part, 1:2] * self.b[t] +
                          weights[part, 2:] * self.c[t])
            distance[part] = np.linalg.norm(points[of[part]] - feet[part],
                                            axis=1)
        order = np.lexsort((distance, of))
        first = order[np.searchsorted(of[order], np.arange(len(points)))]
        return of, pairs, distance, feet, weights, first

    def contains(self, points):
        """Of closed surfaces: what is inside (the solid angle)."""
        total = np.zeros(len(points))
        step = max(1, PAIRS // len(self.a))
        for k in range(0, len(points), step):
            p = points[k:k + step, None]
            r = [corner[None] - p for corner in (self.a, self.b, self.c)]
            n = [np.linalg.norm(v, axis=2) for v in r]
            volume = np.einsum("pti,pti->pt", r[0], np.cross(r[1], r[2]))
            rest = n[0] * n[1] * n[2]
            for i in range(3):
                rest += np.einsum("pti,pti->pt", r[i], r[i - 1]) * n[i - 2]
            total[k:k + step] = 2 * np.arctan2(volume, rest).sum(1)
        return total > 2 * np.pi


def barycentric(p, a, b, c):
    """Of the point of each triangle that is closest."""
    u, v, r = b - a, c - a, p - a
    dot = lambda x, y: np.einsum("ki,ki->k", x, y)
    uu, uv, vv = dot(u, u), dot(u, v), dot(v, v)
    ru, rv = dot(r, u), dot(r, v)
    det = np.maximum(uu * vv - uv * uv, 1e-300)
    s, t = (vv * ru - uv * rv) / det, (uu * rv - uv * ru) / det
    inside = (s >= 0) & (t >= 0) & (s + t <= 1)
    best = np.stack([1 - s - t, s, t], 1)
    least = np.where(inside, -1.0, np.inf)
    for i, (begin, end) in enumerate(((a, b), (b, c), (c, a))):
        along = end - begin
        k = np.clip(dot(p - begin, along) / np.maximum(dot(along, along),
                                                       1e-300), 0, 1)
        off = dot(*(2 * [p - begin - k[:, None] * along]))
        closer = ~inside & (off < least)
        least = np.where(closer, off, least)
        other = np.zeros_like(best)
        other[:, i], other[:, (i + 1) % 3] = 1 - k, k
        best[closer] = other[closer]
    return best


def outlines(model, faces, x):
    """The closed boundaries of the bodies that faces of a group belong to."""
    mesh = model.scene.mesh
    return [Facets(model.complete(mesh.boundary[mesh.bodies[body]]), x)
            for body in np.unique(model.body_of[faces[:, 0]])]


class DeformedBody:
    """The master of a zone: its group, and the whole outline of its bodies."""

    def __init__(self, model, zone, x):
        self.group = Facets(model.lines[zone.master], x)
        self.size = model.scene.size
        self.outlines = outlines(model, model.lines[zone.master], x)

    def gap(self, points):
        """The distance to the group; minus the depth inside of the body."""
        gap = self.group.closest(points)[0]
        for outline in self.outlines:
            depth = depths(outline, points)
            gap = np.where(depth > 0, -depth, gap)
        return gap

    def exact_gap(self, points):
        """The same on the faces of the group themselves: triangles have chords,
        behind which a place on the face may be."""
        gap, (distance, _, chord, _) = self.gap(points), self.group.closest(
            points)
        foot, exact = self.group.signed(points)
        of_group = np.abs(gap) >= (1 - MEET) * distance
        at_chord = np.abs(gap) <= np.linalg.norm(foot - chord, axis=1)
        gap[of_group] = np.copysign(exact, gap)[of_group]
        return np.where(at_chord, exact, gap)

    def covers(self, points):
        """Whether the closest place of the group is straight ahead."""
        distance, triangle, foot, _ = self.group.closest(points)
        ahead = np.abs(np.einsum("ki,ki->k", points - foot,
                                 self.group.normal[triangle]))
        beside = np.sqrt(np.maximum(distance ** 2 - ahead ** 2, 0))
        return beside <= surfaces.BESIDE * distance + 1e-9 * self.size

    def normals(self, points):
        return self.group.normal[self.group.closest(points)[1]]


def depths(outline, points):
    """How deep points are inside of a closed surface; zero outside."""
    low, high = (f(np.concatenate([outline.a, outline.b, outline.c]), axis=0)
                 for f in (np.min, np.max))
    near = np.flatnonzero(((points > low) & (points < high)).all(1))
    depth = np.zeros(len(points))
    if len(near):
        near = near[outline.contains(points[near])]
    if len(near):
        depth[near] = outline.closest(points[near])[0]
    return depth


def master_of(model, zone, state):
    if zone.obstacle:
        return motions.obstacle_of(zone, state)
    return DeformedBody(model, zone, state.x)


def samples(faces, x, n=4):
    """Points on each face of a group, (faces, points, 3)."""
    nodes = faces.shape[1]
    shapes = np.array([elements.face(p, nodes)[0] for p in grid(n, nodes)[0]])
    return np.einsum("ca,fai->fci", shapes, x[faces])
