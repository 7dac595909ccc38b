"""Slips of the mortar discretization in 2-D (degree 1): weighted by dual
functions, of what the master covers of each edge.

A force lambda_k on the dual function Phi_k of a node acts on the slave's node a
with the integral of Phi_k N_a, and works on the jump of the displacements
weighted by Phi_k. On an edge that the master covers as a whole Phi_k is
biorthogonal to the N_a. Of an edge that it covers in part the nodes beyond that
part have none, and leave their N_a to the other node: (a_k0 + a_k1 xi), as many
terms as there are nodes, with integral Phi_k M_j = delta_kj integral M_j."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

# Points of an edge, from which also what is covered is known.
PLACES = 120
# Of the coordinate from -1 to 1: a node that is that much further beyond the part
# than the nearest one has no function; between them nobody knows.
WITH, WITHOUT = 0.05, 0.15
# Of the length of an edge of the master: hits of its ends.
ENDS = 1e-9
# More than this angle between two edges is a corner (its sine): each edge is
# projected along its own normal.
CORNER = 0.6


class DualWeights:
    """Of the slave of a zone (class ZoneCheck), in its state."""

    def __init__(self, check):
        self.nodes, self.lines = check.nodes, check.lines
        self.master = check.master.group
        self.of_master = check.lines_of_master()
        self.x = check.state.x
        n = len(self.nodes)
        # By dual function and node; by function and places of the master.
        self.B, self.D = np.zeros((n, n)), np.zeros(n)
        self.rows = []
        self.known = np.ones(n, bool)
        carries = check.judged
        xi = (np.arange(PLACES) + 0.5) / PLACES * 2 - 1
        self.N = np.stack([(1 - xi) / 2, (1 + xi) / 2], 1)
        normals = self.normals_of_nodes(check.own)
        for line, normal in zip(self.lines, check.own.normal):
            at = np.searchsorted(self.nodes, line)
            if carries[at].all():
                self.add(at, line, xi, self.directions(at, normal, normals))
            else:
                self.known[at] = False

    def normals_of_nodes(self, own):
        total = np.zeros((len(self.nodes), 2))
        for line, normal in zip(self.lines, own.normal):
            total[np.searchsorted(self.nodes, line)] += normal
        return total / np.maximum(np.hypot(*total.T), 1e-300)[:, None]

    def directions(self, at, own, normals):
        """Of the lines to the master, by places of an edge."""
        ends = np.array([own if abs(np.cross(own, n)) > CORNER / 2 else n
                         for n in normals[at]])
        n = self.N @ ends
        return n / np.hypot(*n.T)[:, None]

    def hits(self, points, n):
        """For each point the piece of the master on the line along n that is
        nearest and face to face (-1: none), and the place on it."""
        a, along = self.master.begin, self.master.end - self.master.begin
        r = a[None] - points[:, None]
        det = np.cross(along[None], n[:, None])
        with np.errstate(divide="ignore", invalid="ignore"):
            s = np.cross(n[:, None], r) / det
            distance = np.abs(np.cross(along[None], r) / det)
        meets = ((s > -ENDS) & (s < 1 + ENDS) &
                 (n @ self.master.normal.T < 0))
        distance = np.where(meets, distance, np.inf)
        piece = distance.argmin(1)
        k = np.arange(len(points))
        return np.where(meets.any(1), piece, -1), np.clip(s[k, piece], 0, 1)

    def add(self, at, line, xi, n):
        X = self.x[line]
        piece, s = self.hits(self.N @ X, n)
        covered = piece >= 0
        if not covered.any():
            return
        places = np.flatnonzero(covered)
        beyond = np.array([xi[places[0]] + 1, 1 - xi[places[-1]]])
        if len(places) == PLACES:
            beyond[:] = 0
        more = beyond - beyond.min()
        if len(places) <= np.ptp(places) or ((more > WITH) & (
                more < WITHOUT)).any():
            self.known[at] = False
            return
        has = np.flatnonzero(more <= WITH)
        M = self.N[covered] if len(has) == 2 else np.ones((len(places), 1))
        terms = xi[covered, None] ** np.arange(len(has))
        w = np.hypot(*(X[1] - X[0])) / PLACES
        integrals = w * M.sum(0)
        dual = terms @ np.linalg.solve(w * M.T @ terms, np.diag(integrals))
        for j, k in enumerate(at[has]):
            weights = w * dual[:, j]
            self.D[k] += integrals[j]
            np.add.at(self.B[k], at, weights @ self.N[covered])
            self.rows.append((k, weights, piece[covered], s[covered]))

    def jump(self, field):
        """Of the slave minus the master, weighted, by dual functions."""
        total = self.B @ field[self.nodes]
        for k, w, piece, s in self.rows:
            line = self.of_master[self.master.line[piece]]
            total[k] -= w @ ((1 - s)[:, None] * field[line[:, 0]] +
                             s[:, None] * field[line[:, 1]])
        return total / np.where(self.D > 0, self.D, 1)[:, None]

    def normals(self, smooth):
        """The weighted mean of those of the master; `smooth`: of places on its
        pieces."""
        total = np.zeros((len(self.nodes), 2))
        for k, w, piece, s in self.rows:
            total[k] += w @ smooth(piece, s)
        return total / np.maximum(np.hypot(*total.T), 1e-300)[:, None]

    def forces(self, force):
        """lambda_k D_k, of the forces on the nodes: what acts on a node whose
        edges are not known is left out."""
        has = self.D > 0
        A = (self.B[has] / self.D[has, None])[:, self.known].T
        found = np.zeros_like(force)
        found[has] = np.linalg.lstsq(A, force[self.known], rcond=1e-10)[0]
        return found

    @property
    def judged(self):
        return self.known & (self.D > 0)
