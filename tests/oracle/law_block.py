"""Elements of a body with a material of materials.py, or with a thermal strain.

Forces are, with F the gradient of the motion and 1 in small strain,
    integral of F (shear part + P U'(P d) dd/dE) : grad v
over the undeformed volume. Tangents are derivatives by complex steps: exact, and
no formula that could be wrong alike."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import blocks
import materials

STEP = 1e-30


class LawBlock(blocks.Block):
    """A strain e without stress is taken off in all directions, in large
    displacement Green's strain of the stretch 1 + e."""

    def __init__(self, model, kind, cells, law, large, thermal=None):
        self.law, self.thermal_at = law, thermal
        super().__init__(model, kind, cells, law.lame, law.mu, large)
        self.thermal = 0.0
        self.reset()

    def is_projected(self, dilatation):
        return super().is_projected(dilatation) or (
            dilatation == "automatic" and self.law.has_history)

    @property
    def has_history(self):
        return self.law.has_history

    def reset(self):
        self.history = self.law.start(self.w.shape)

    def at(self, t):
        if self.thermal_at is not None:
            e = self.thermal_at(t)
            self.thermal = e + self.large * e * e / 2

    def advance(self, u):
        if self.law.has_history:
            self.history = self.law.advance(self.strains(
                self.gradient(u[self.cells])), self.history)

    def gradient(self, v):
        """Of displacements (cells, nodes, dim), in 3-D."""
        H = np.zeros(self.w.shape + (3, 3), v.dtype)
        H[..., :self.dim, :self.dim] = np.einsum("eai,eqaj->eqij", v, self.dN)
        if self.hoop is not None:
            H[..., 2, 2] = np.einsum("eqa,ea->eq", self.hoop, v[:, :, 0])
        return H

    def strains(self, H):
        """Those that have a stress."""
        T = H.swapaxes(-1, -2)
        return (H + T + (T @ H if self.large else 0)) / 2 - (
            self.thermal * materials.ONE)

    def local_forces(self, v):
        H = self.gradient(v)
        E = self.strains(H)
        d, slope = self.law.volume(E)
        p = self.project(self.law.pressure(self.project(d)))
        S = self.law.shear(E, self.history) + materials.times(p, slope)
        P = S + H @ S if self.large else S
        forces = np.einsum("eq,eqij,eqaj->eai", self.w,
                           P[..., :self.dim, :self.dim], self.dN)
        if self.hoop is not None:
            forces[:, :, 0] += np.einsum("eq,eq,eqa->ea", self.w, P[..., 2, 2],
                                         self.hoop)
        return forces

    def forces(self, u):
        return self.local_forces(u[self.cells])

    def tangent(self, u):
        v = u[self.cells].astype(complex)
        n = v[0].size
        K = np.empty((len(v), n, n))
        for k in range(n):
            step = np.zeros(n, complex)
            step[k] = 1j * STEP
            change = self.local_forces(v + step.reshape(v.shape[1:]))
            K[:, :, k] = change.imag.reshape(len(v), n) / STEP
        return K
