"""The elements of a body, tabulated: linear elasticity and St. Venant-Kirchhoff.

The energy of a body is the integral of
    1/2 lambda (P tr E)^2 + mu E : E
over the undeformed volume, E the linear or Green's strain with the hoop strain
of rings in it, P the identity or the projection of each cell onto the mean
(degree 2, quadrangles: onto 1, xi, eta, hexahedra: and zeta). Forces are its
derivatives, in N per mm of thickness, of whole rings and in 3-D in N."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import elements


class Block:
    """The elements of one shape and one body, tabulated."""

    def __init__(self, model, kind, cells, lame, shear, large):
        self.cells = cells
        self.dim = model.X.shape[1]
        self.lame, self.shear, self.large = lame, shear, large
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
        if self.is_projected(dilatation):
            self.make_modes([p for p, _ in points], kind, model.degree)
        self.dofs = (self.dim * cells[:, :, None] + np.arange(
            self.dim)).reshape(len(cells), -1)

    def is_projected(self, dilatation):
        return dilatation == "B-bar" or (dilatation == "automatic" and
                                         self.lame > 10 * self.shear)

    def make_modes(self, points, kind, degree):
        """Polynomials, orthonormal by the weights of each cell."""
        is_simplex = kind in ("triangle", "tet")
        n = 1 + self.dim if not is_simplex and degree == 2 else 1
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

    def forces(self, u):
        _, E, e, F, f = self.strain(u, self.large)
        S, s = self.stress(E, e)
        P = np.einsum("eqik,eqkj->eqij", F, S)
        forces = np.einsum("eq,eqij,eqaj->eai", self.w, P, self.dN)
        if self.hoop is not None:
            forces[:, :, 0] += np.einsum("eq,eq,eqa->ea", self.w, f * s,
                                         self.hoop)
        return forces

    def tangent(self, u):
        _, E, e, F, f = self.strain(u, self.large)
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
        if self.large:
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

    # What depends on the time and on the increments before: not here.
    has_history = False

    def at(self, t):
        pass

    def reset(self):
        pass

    def advance(self, u):
        pass
