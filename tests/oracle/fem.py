"""A small finite element code: linear elasticity and St. Venant-Kirchhoff,
plane strain and axisymmetric, degree 1 and 2; blocks of elements also in space
(space_fem.py).

The energy of a body is the integral of
    1/2 lambda (P tr E)^2 + mu E : E
over the undeformed volume, E the linear or Green's strain with the hoop strain
of rings in it, P the identity or the projection of each cell onto the mean
(degree 2, quadrangles: onto 1, xi, eta, hexahedra: and zeta). Forces are its
derivatives, in N per mm of thickness, of whole rings and in space in N."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spl

import elements


class Block:
    """The elements of one shape and one body, tabulated."""

    def __init__(self, model, kind, cells, young, poisson):
        self.cells = cells
        self.dim = model.X.shape[1]
        self.lame = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
        self.shear = young / (2 * (1 + poisson))
        shape, points = elements.rule(kind, model.degree)
        tables = [shape(*p) for p, _ in points]
        self.N = np.array([t[0] for t in tables])
        slopes = np.array([t[1] for t in tables])
        X = model.X[cells]
        jacobian = np.einsum("eai,qaj->eqij", X, slopes)
        det = np.linalg.det(jacobian)
        if det.min() <= 0:
            raise ValueError("a cell of the mesh is turned inside out")
        self.dN = np.einsum("qaj,eqjk->eqak", slopes, np.linalg.inv(jacobian))
        self.w = det * np.array([w for _, w in points])
        self.hoop = None
        if model.axisymmetric:
            radius = np.einsum("qa,ea->eq", self.N, X[:, :, 0])
            self.hoop = self.N[None] / radius[:, :, None]
            self.w = self.w * 2 * np.pi * radius
        self.modes = None
        dilatation = model.scene.entries.get("Solids/Dilatation", "automatic")
        if dilatation == "B-bar" or (dilatation == "automatic" and
                                         self.lame > 10 * self.shear):
            self.make_modes([p for p, _ in points], kind, model.degree)
        self.dofs = (self.dim * cells[:, :, None] + np.arange(
            self.dim)).reshape(len(cells), -1)

    def make_modes(self, points, kind, degree):
        """Polynomials, orthonormal by the weights of each cell."""
        n = 1 + self.dim if kind != "triangle" and degree == 2 else 1
        raw = np.array([[1, *p] for p in points], float)[:, :n]
        root = np.sqrt(self.w)[:, :, None]
        q, _ = np.linalg.qr(root * raw[None])
        self.modes = q / root

    def project(self, trace):
        """P of values at the points, (cells, points, ...)."""
        if self.modes is None:
            return trace
        weighted = trace * self.w.reshape(self.w.shape + (1,) *
                                          (trace.ndim - 2))
        parts = np.einsum("eqm,eq...->em...", self.modes, weighted)
        return np.einsum("eqm,em...->eq...", self.modes, parts)

    def strain(self, u, large):
        H = np.einsum("eai,eqaj->eqij", u[self.cells], self.dN)
        h = (np.zeros(H.shape[:2]) if self.hoop is None else
             np.einsum("eqa,ea->eq", self.hoop, u[self.cells][:, :, 0]))
        E = 0.5 * (H + H.swapaxes(2, 3))
        F = np.broadcast_to(np.eye(self.dim), H.shape)
        f = np.ones_like(h)
        e = h
        if large:
            E = E + 0.5 * np.einsum("eqki,eqkj->eqij", H, H)
            F = F + H
            f = 1 + h
            e = h + 0.5 * h * h
        return H, E, e, F, f

    def stress(self, E, e):
        trace = self.project(np.trace(E, axis1=-2, axis2=-1) + e)
        S = (2 * self.shear * E +
             self.lame * trace[..., None, None] * np.eye(self.dim))
        return S, self.lame * trace + 2 * self.shear * e

    def forces(self, u, large):
        _, E, e, F, f = self.strain(u, large)
        S, s = self.stress(E, e)
        P = np.einsum("eqik,eqkj->eqij", F, S)
        forces = np.einsum("eq,eqij,eqaj->eai", self.w, P, self.dN)
        if self.hoop is not None:
            forces[:, :, 0] += np.einsum("eq,eq,eqa->ea", self.w, f * s,
                                         self.hoop)
        return forces

    def tangent(self, u, large):
        _, E, e, F, f = self.strain(u, large)
        n, d = self.cells.shape[1], self.dim
        shears = [(k, l) for k in range(d) for l in range(k)]
        hoop = d + len(shears)
        B = np.zeros(self.w.shape + (hoop + 1, n, d))
        for k in range(d):
            B[:, :, k] = np.einsum("eqi,eqa->eqai", F[..., :, k],
                                   self.dN[..., k])
        for row, (k, l) in enumerate(shears, d):
            B[:, :, row] = (
                np.einsum("eqi,eqa->eqai", F[..., k], self.dN[..., l]) +
                np.einsum("eqi,eqa->eqai", F[..., l], self.dN[..., k]))
        if self.hoop is not None:
            B[:, :, hoop, :, 0] = f[..., None] * self.hoop
        B = B.reshape(self.w.shape + (hoop + 1, d * n))
        trace = self.project(B[:, :, :d].sum(2) + B[:, :, hoop])
        D = self.shear * np.array([2] * d + [1] * len(shears) + [2])
        K = np.einsum("eq,k,eqki,eqkj->eij", self.w, D, B, B, optimize=True)
        K += self.lame * np.einsum("eq,eqi,eqj->eij", self.w, trace, trace,
                                   optimize=True)
        if large:
            S, s = self.stress(E, e)
            G = np.einsum("eq,eqak,eqkl,eqbl->eab", self.w, self.dN, S,
                          self.dN, optimize=True)
            K = K.reshape(len(K), n, d, n, d)
            for k in range(d):
                K[:, :, k, :, k] += G
            if self.hoop is not None:
                K[:, :, 0, :, 0] += np.einsum("eq,eqa,eqb->eab", self.w * s,
                                              self.hoop, self.hoop)
            K = K.reshape(len(K), d * n, d * n)
        return K


class Model:
    """The bodies of a scene: mesh of its degree, stiffness, loads, supports."""

    def __init__(self, scene):
        self.scene = scene
        self.degree = scene.degree
        self.axisymmetric = scene.axisymmetric
        self.large = scene.large
        mesh = scene.mesh
        self.n_vertices = len(mesh.X)
        self.X = mesh.X
        self.dim = mesh.X.shape[1]
        self.middle = {}
        cells = mesh.cells
        if self.degree == 2:
            cells = self.add_middles(mesh, cells)
        # Degrees of freedom that follow others: in space.
        self.bound = np.zeros(self.X.shape, bool)
        self.lines = {name: self.complete(lines)
                      for name, lines in mesh.lines.items()}
        self.blocks = [Block(self, kind, array, *scene.material(body))
                       for (body, kind), array in cells.items()]
        self.cells = cells
        self.body_of = np.zeros(len(self.X), int)
        for (body, _), array in cells.items():
            self.body_of[array.ravel()] = mesh.bodies.index(body)
        self.loads = self.make_loads()

    def add_middles(self, mesh, cells):
        X = list(map(tuple, mesh.X))
        arcs = {tuple(sorted(line)): arc for name, arc in mesh.arcs.items()
                for line in mesh.lines[name]}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in self.middle:
                p = (mesh.X[a] + mesh.X[b]) / 2
                if key in arcs:
                    x, y, radius = arcs[key]
                    d = p - (x, y)
                    p = (x, y) + d * abs(radius) / np.hypot(*d)
                self.middle[key] = len(X)
                X.append(tuple(p))
            return self.middle[key]
        complete = {}
        for key, array in cells.items():
            n = array.shape[1]
            complete[key] = np.array(
                [list(c) + [middle(c[i], c[(i + 1) % n]) for i in range(n)]
                 for c in array.tolist()])
        self.X = np.array(X)
        return complete

    def complete(self, lines):
        if self.degree == 1:
            return np.array(lines)
        return np.array([[a, b, self.middle[min(a, b), max(a, b)]]
                         for a, b in lines])

    def following(self, u):
        """The displacements; those that follow others in their places."""
        return u

    def nodes_of(self, name):
        """The nodes of a boundary or point group."""
        if name in self.lines:
            return np.unique(self.lines[name])
        return np.array([self.scene.mesh.points[name]])

    def forces(self, u):
        total = np.zeros_like(self.X)
        for block in self.blocks:
            np.add.at(total, block.cells, block.forces(u, self.large))
        return total

    def magnitude(self, u, error):
        """How far the force on each node is off if each displacement is off by
        `error` (by node)."""
        total = np.zeros(self.X.size)
        for block in self.blocks:
            K = np.abs(block.tangent(u, self.large))
            e = np.repeat(error[block.cells], self.dim, axis=1)
            np.add.at(total, block.dofs, np.einsum("eij,ej->ei", K, e))
        return total.reshape(self.X.shape)

    def tangent(self, u):
        rows, columns, values = [], [], []
        for block in self.blocks:
            K = block.tangent(u, self.large)
            n = K.shape[1]
            rows.append(np.repeat(block.dofs, n, axis=1).ravel())
            columns.append(np.tile(block.dofs, (1, n)).ravel())
            values.append(K.ravel())
        size = self.X.size
        return sp.csc_matrix((np.concatenate(values), (np.concatenate(
            rows), np.concatenate(columns))), shape=(size, size))

    # Loads: by entry, for the factor one.
    def make_loads(self):
        loads = {}
        for entry, items in self.scene.boundary.items():
            if entry.startswith("Displacement"):
                continue
            total = loads.setdefault(entry, np.zeros_like(self.X))
            for name, value in items.items():
                total += self.load(entry, name, value)
        return loads

    def load(self, entry, name, value):
        direction = np.array([entry.endswith(d) for d in "xyz"[:self.dim]],
                             float)
        if entry.startswith("Body force"):
            return self.body_force(name, value, direction)
        if entry.startswith("Force"):
            total = np.zeros_like(self.X)
            total[self.nodes_of(name)[0]] = value * direction
            return total
        if entry == "Pressure":
            return self.edge_load(name, lambda X, n: -scalar(value, X) * n)
        if entry.startswith("Traction"):
            return self.edge_load(name, lambda X, n: scalar(value, X) *
                                  direction)
        unit = self.edge_load(name, lambda X, n: direction)
        return unit * value / unit.sum()

    def edge_load(self, name, traction):
        total = np.zeros_like(self.X)
        for line in self.lines[name]:
            for x, w in zip(*np.polynomial.legendre.leggauss(self.degree + 1)):
                N, slope = elements.edge(x, self.degree)
                X, t = N @ self.X[line], slope @ self.X[line]
                # The body is on the left.
                length = np.hypot(*t)
                normal = np.array([t[1], -t[0]]) / length
                around = 2 * np.pi * X[0] if self.axisymmetric else 1
                total[line] += np.outer(N, w * length * around *
                                        traction(X, normal))
        return total

    def body_force(self, name, value, direction):
        total = np.zeros_like(self.X)
        for (body, kind), cells in self.cells.items():
            if body != name:
                continue
            shape, points = elements.rule(kind, self.degree)
            if kind == "triangle":
                points = elements.hammer_seven()
            for p, w in points:
                N, slope = shape(*p)
                X = np.einsum("a,eai->ei", N, self.X[cells])
                J = np.linalg.det(np.einsum("eai,aj->eij", self.X[cells],
                                            slope))
                f = w * J * (2 * np.pi * X[:, 0] if self.axisymmetric else 1)
                np.add.at(total, cells, value * np.einsum(
                    "e,a,i->eai", f, N, direction))
        return total

    def external(self, t):
        total = np.zeros_like(self.X)
        for entry, load in self.loads.items():
            total += self.scene.factor(entry, t) * load
        return total

    def load_scale(self, t):
        """The sum of the loads without regard to their signs."""
        return sum(abs(self.scene.factor(entry, t)) * np.abs(load).sum()
                   for entry, load in self.loads.items())

    def supports(self, t):
        """Whether a degree of freedom is prescribed, and the value."""
        held = np.zeros(self.X.shape, bool)
        value = np.zeros_like(self.X)
        for d in range(self.dim):
            entry = "Displacement " + "xyz"[d]
            for name, u in self.scene.boundary.get(entry, {}).items():
                nodes = self.nodes_of(name)
                held[nodes, d] = True
                value[nodes, d] = u * self.scene.factor(entry, t)
        if self.axisymmetric:
            held[np.abs(self.X[:, 0]) < 1e-10 * np.abs(self.X).max(), 0] = True
        return held, value

    def solve(self, t=1.0, steps=1, fixed=None, u=None):
        """The displacements without contact, by Newton's method; `fixed`: more
        degrees of freedom that stay as they are in u."""
        u = np.zeros_like(self.X) if u is None else u.copy()
        for k in range(1, steps + 1):
            held, value = self.supports(t * k / steps)
            if fixed is not None:
                held = held | fixed
                value = np.where(fixed, u, value)
            free = ~(held | self.bound).ravel()
            u[held] = value[held]
            u = self.following(u)
            for _ in range(60):
                r = (self.external(t * k / steps) - self.forces(u)).ravel()
                K = self.tangent(u)[free][:, free]
                du = spl.spsolve(K.tocsc(), r[free])
                u.reshape(-1)[free] += du
                u = self.following(u)
                if not np.isfinite(du).all():
                    raise ArithmeticError("the reference does not converge")
                if np.abs(du).max(initial=0) <= 1e-12 * np.abs(u).max():
                    break
            else:
                raise ArithmeticError("the reference does not converge")
        return u


def scalar(value, X):
    return value(*X) if callable(value) else value
