"""A solution of our own of contact without friction, by penalties at points of
both surfaces, each along the normal of its own facet to the nearest facet of the
other surface that faces it: nothing is asked of nodes, edges or corners."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spl

import elements
import space_surfaces
import surfaces

# Points of a facet along each side.
POINTS = {2: 8, 3: 6}
# Facets face each other whose normals have a product below it.
FACING = -0.17
# Of the modulus by the size of a facet.
STIFFNESS = 200.0
# Pairings, on the surfaces as they are deformed so far; steps for each.
PAIRINGS, STEPS = 4, 60
# Of the largest displacement.
DONE = 1e-7


def tables(model, n):
    """Shape functions of a facet with n nodes at its points, their slopes, the
    weights."""
    dim = model.dim
    if dim == 2:
        places, weights = np.polynomial.legendre.leggauss(POINTS[2])
        both = [elements.edge(x, model.degree) for x in places]
        return (np.array([N for N, _ in both]),
                np.array([s[:, None] for _, s in both]), weights)
    rule = elements.face_rule(n, POINTS[3])
    both = [elements.face(place, n) for place, _ in rule]
    return (np.array([N for N, _ in both]), np.array([s for _, s in both]),
            np.array([w for _, w in rule]))


class Points:
    """Those of a group on its deformed facets: places, normals, sizes."""

    def __init__(self, model, facets, x):
        N, slopes, w = tables(model, facets.shape[1])
        n_points = len(w)
        self.x = np.einsum("qa,fai->fqi", N, x[facets]).reshape(-1, model.dim)
        along = np.einsum("qad,fai->fqdi", slopes, x[facets])
        if model.dim == 2:
            t = along[:, :, 0]
            n = np.stack([t[..., 1], -t[..., 0]], -1)
        else:
            n = np.cross(along[:, :, 0], along[:, :, 1])
        size = np.linalg.norm(n, axis=-1)
        self.n = (n / size[..., None]).reshape(-1, model.dim)
        self.w = (size * w).ravel()
        extent = (size * w).sum(1)
        self.h = np.repeat(extent ** (1 / (model.dim - 1)), n_points)
        self.nodes = np.repeat(facets, n_points, axis=0)
        self.N = np.tile(N, (len(facets), 1))


def hits_of_lines(model, lines, x, points, n):
    """For each point and line, the distance along n (nan: none), and the shape
    functions there."""
    group = surfaces.Polyline(lines, x)
    along = group.end - group.begin
    r = group.begin[None] - points[:, None]
    det = np.cross(along[None], n[:, None])
    with np.errstate(divide="ignore", invalid="ignore"):
        s = np.cross(n[:, None], r) / det
        d = np.cross(along[None], r) / det
    good = (s > -1e-9) & (s < 1 + 1e-9) & (n @ group.normal.T < FACING)
    return np.where(good, d, np.nan), group, s


def shapes_of_lines(model, group, piece, s):
    s = s[np.arange(len(piece)), piece]
    if model.degree == 2:
        s = (piece % surfaces.PIECES + s) / surfaces.PIECES
    return np.array([elements.edge(2 * a - 1, model.degree)[0] for a in s])


def hits_of_faces(model, faces, x, points, n):
    group = space_surfaces.Facets(faces, x)
    u, v = group.b - group.a, group.c - group.a
    p = np.cross(n[:, None], v[None])
    det = np.einsum("ti,pti->pt", u, p)
    r = points[:, None] - group.a[None]
    q = np.cross(r, u[None])
    with np.errstate(divide="ignore", invalid="ignore"):
        s = np.einsum("pti,pti->pt", r, p) / det
        t = np.einsum("pi,pti->pt", n, q) / det
        d = np.einsum("ti,pti->pt", v, q) / det
    # Along a facet: none.
    s, t = (np.where(det == 0, -1, a) for a in (s, t))
    good = ((s > -1e-9) & (t > -1e-9) & (s + t < 1 + 1e-9) &
            (n @ group.normal.T < FACING))
    return np.where(good, d, np.nan), group, np.stack([1 - s - t, s, t], -1)


def shapes_of_faces(model, group, piece, s):
    s = s[np.arange(len(piece)), piece]
    return np.einsum("pk,pka->pa", s, group.shapes[group.triangles[piece]])


class OwnContact:
    """Of a scene with one zone or several, at the time t."""

    def __init__(self, model, t, way):
        """`way`: nothing moves by more, nor is deeper in the other body."""
        self.model, self.t, self.way = model, t, way
        model.at(t)
        self.external = model.external(t)
        self.held, self.value = model.supports(t)
        self.young = min(young for young, _ in model.scene.materials.values())
        self.u = np.zeros_like(model.X)

    def pair(self):
        """The rows of all points: gap = gap0 + C u, and what each weighs."""
        self.C, self.gap0, self.weight, self.of_slave = [], [], [], []
        for zone in self.model.scene.zones:
            groups = [self.model.lines[zone.slave],
                      self.model.lines[zone.master]]
            self.add(*groups, True)
            self.add(*groups[::-1], False)
        if not self.C:
            raise ArithmeticError("nothing faces anything")
        self.C = sp.vstack(self.C).tocsr()
        self.gap0 = np.concatenate(self.gap0) - self.C @ self.u.ravel()
        self.weight = np.concatenate(self.weight)

    def add(self, own, other, of_slave):
        model = self.model
        x = model.X + self.u
        points = Points(model, own, x)
        hits, shapes = ((hits_of_lines, shapes_of_lines) if model.dim == 2 else
                        (hits_of_faces, shapes_of_faces))
        d, group, s = hits(model, other, x, points.x, points.n)
        d = np.where((d < 3 * self.way) & (d > -self.way), d, np.inf)
        piece = np.abs(d).argmin(1)
        found = np.flatnonzero(np.isfinite(d[np.arange(len(d)), piece]))
        if not len(found):
            return
        piece = piece[found]
        N = shapes_of_lines(model, group, piece, s[found]) if (
            model.dim == 2) else shapes(model, group, piece, s[found])
        facet = group.line[piece] if model.dim == 2 else group.face[piece]
        nodes = np.concatenate([points.nodes[found], other[facet]], axis=1)
        values = np.concatenate([-points.N[found], N], axis=1)
        n = points.n[found]
        columns = (model.dim * nodes[:, :, None] + np.arange(model.dim))
        rows = np.broadcast_to(np.arange(len(found))[:, None, None],
                               columns.shape)
        entries = values[:, :, None] * n[:, None]
        self.C.append(sp.csr_matrix((entries.ravel(), (
            rows.ravel(), columns.ravel())), shape=(len(found), x.size)))
        self.gap0.append(d[found, piece])
        # Half of it for either surface.
        self.weight.append(0.5 * STIFFNESS * self.young * points.w[found] /
                           points.h[found])

    def solve(self):
        for _ in range(PAIRINGS):
            before = self.u.copy()
            self.pair()
            self.iterate()
            if np.abs(self.u - before).max() <= 1e-4 * np.abs(self.u).max():
                break
        return self

    def gaps(self, u):
        return self.gap0 + self.C @ u.ravel()

    def residual(self, u):
        g = np.minimum(self.gaps(u), 0)
        return (self.external - self.model.forces(u)).ravel() - self.C.T @ (
            self.weight * g)

    def iterate(self):
        """Newton's method; a step is halved as long as what remains grows along
        it (the energy is convex in small strain)."""
        free = ~(self.held | self.model.bound).ravel()
        u = np.where(self.held, self.value, self.u)
        for _ in range(STEPS):
            K = self.model.tangent(u)
            active = self.gaps(u) < 0
            A = self.C[active]
            K = K + A.T @ sp.diags(self.weight[active]) @ A
            K = K[free][:, free].tocsc()
            # Of a body that nothing holds yet.
            K = K + 1e-9 * sp.diags(K.diagonal())
            r = self.residual(u)[free]
            step = np.zeros(u.size)
            step[free] = spl.spsolve(K.tocsc(), r)
            slope = r @ step[free]
            length = 1.0
            for _ in range(8):
                ahead = self.model.following(u + length * step.reshape(u.shape))
                if abs(self.residual(ahead)[free] @ step[free]) <= (
                        0.9 * abs(slope)):
                    break
                length /= 2
            u = ahead
            if np.abs(length * step).max() <= DONE * np.abs(u).max():
                self.u = u
                return
        raise ArithmeticError("our own contact does not converge")

    def force(self):
        """Of all points on the slave's and the master's nodes."""
        g = np.minimum(self.gaps(self.u), 0)
        return -(self.C.T @ (self.weight * g)).reshape(self.u.shape)
