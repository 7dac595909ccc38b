"""The directions in which the master of a zone may push, in 2-D."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import surfaces


class Normals:
    """A part of class ZoneCheck; `reach`: surfaces that are no further apart may
    touch."""

    def range_of_normals(self, k, where):
        """The directions in which the master may push here: its normals where
        the slave's edges face it, and the slave's own, turned round, where
        those lie on it."""
        normals = self.normals[where].reshape(-1, 2)
        gaps = self.gaps[where].ravel()
        near = gaps <= gaps.min() + 0.5 * self.own.length.max()
        candidates = list(normals[near])
        lying = np.intersect1d(where, np.flatnonzero(self.lying))
        own = -self.own.normal[np.isin(self.own.line, lying)]
        if self.rule == "mortar" and len(lying):
            # The last node of a contact has the mean of its two edges.
            own = np.concatenate([own, self.mean_normals(lying)])
        self.reference = normals[gaps.argmin()]
        candidates += [n for n in own if n @ self.reference > 0]
        candidates += self.corners(where)
        if self.rule == "mortar" and not self.zone.obstacle:
            candidates += list(self.smooth_normals(where)[near])
        angles = [self.turn(n, self.reference) for n in candidates]
        angles = [a for a in angles if abs(a) < np.pi / 2]
        return min(angles), max(angles)

    def corners(self, where):
        """The normals on both sides of the master's corners that touch these
        lines: what acts there has any direction between them."""
        if self.zone.obstacle:
            return []
        group = self.master.group
        part = surfaces.Polyline(self.lines[where], self.state.x)
        touch = part.closest(group.begin)[0] - self.apart <= self.reach
        found = []
        for k in np.flatnonzero(touch):
            before = (group.end == group.begin[k]).all(1)
            if before.any():
                found += [group.normal[k], group.normal[before][0]]
        return [n for n in found if n @ self.reference > 0]

    def smooth_normals(self, where):
        """Those of the master between the means at its nodes, which this
        discretization weights with the slave's, where places face it."""
        _, piece, s = self.master.group.closest(
            self.points[where].reshape(-1, 2))
        return self.smooth(piece, s)

    def smooth(self, piece, s):
        group = self.master.group
        ends = [group.begin, group.end]
        mean = [sum((np.abs(p[:, None] - other).max(2) == 0) @ group.normal
                    for other in ends) for p in ends]
        n = ((1 - s)[:, None] * mean[0][piece] + s[:, None] * mean[1][piece])
        return n / np.maximum(np.hypot(*n.T), 1e-300)[:, None]

    def mean_normals(self, lying):
        """Those of the nodes of lines, turned round: of the pieces that end
        there, since edges of degree 2 are bent."""
        found = []
        for n in np.unique(self.lines[lying]):
            off = np.minimum(*(np.abs(p - self.state.x[n]).max(1) for p in (
                self.own.begin, self.own.end)))
            normal = -self.own.normal[off <= 1e-6 * self.own.length].sum(0)
            found.append(normal / max(np.hypot(*normal), 1e-300))
        return found

    @staticmethod
    def turn(a, b):
        return np.arctan2(b[0] * a[1] - b[1] * a[0], a @ b)

    def weighted_angles(self, reference):
        """The mortar discretization pushes along means, weighted by dual
        functions, of the normals of the master between its nodes: a dual function
        (2 to -1 along an edge) has the integral 4/3 where it is positive and
        -1/3 where it is not, so that such a mean leaves the range of what it is
        a mean of by a third of that at most."""
        if self.rule != "mortar" or self.zone.obstacle:
            return []
        where = np.isin(self.lines, self.nodes[self.counts]).any(1)
        angles = [self.turn(n, reference) for n in self.smooth_normals(where)]
        if not angles:
            return []
        more = np.ptp(angles) / 3
        return [min(angles) - more, max(angles) + more]
