"""Zones beyond contact with a surface at rest: obstacles that move, glue, the
cut through a bolt."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import elements
import motions
import surfaces
from rigid_check import cross
from zone_check import SLIPS, Problem, ZoneCheck

# Of the sum of all forces: resultants, given and said.
RESULTANT = 1e-6
# Of mu times the pressure of a node that slips: what its shear may lack.
SHEAR = 0.05
# Of the largest displacement: by how much glued surfaces may part, in nodes and
# in the weighted mean (of surfaces that lie on each other).
GLUED = {"nodal": 1e-6, "mortar": 0.01}
# Of the size of a scene: how far from the master a node faces it.
FACES = 1e-9
# Places of an edge for weighted means.
PLACES = 60


def zone_check_of(scene, model, state, zone, largest, shared):
    kind = GlueCheck if zone.tied else (
        ObstacleCheck if zone.obstacle else ZoneCheck)
    return kind(scene, model, state, zone, largest, shared)


class ObstacleCheck(ZoneCheck):
    """Also what the program says of the obstacle, and what is given."""

    def problems(self, before):
        found = super().problems(before)
        if not found and not self.shared[self.nodes].any():
            found += self.check_resultants()
        return found or self.check_way() + self.check_friction(before)

    def facets(self):
        """An edge spans an arc of a rigid circle, whose nodes alone touch it."""
        rise = super().facets()
        kind, numbers = self.zone.obstacle.split(": ")
        radius = float(numbers.split(",")[-1])
        if kind == "circle" and radius > 0:
            rise = max(rise, np.bincount(self.own.line, self.own.length).max() **
                       2 / (8 * radius))
        return rise

    @property
    def placement(self):
        return self.state.placements[self.zone.name]

    def check_resultants(self):
        """Forces on the slave, and their moment about the centre."""
        force = self.state.residual[self.nodes]
        error = 3 * self.state.error[self.nodes].sum(0)
        arm = self.state.x[self.nodes] - self.placement.centre
        held = self.state.held[self.nodes].any(0)
        allowed = RESULTANT * self.state.scale + error
        said = motions.said(self.zone, self.state.record)
        rows = [("x", "obstacle_force_x", force[:, 0].sum(), allowed[0],
                 held[0]), ("y", "obstacle_force_y", force[:, 1].sum(),
                            allowed[1], held[1]),
                ("moment", "obstacle_moment_z", cross(arm, force).sum(),
                 np.abs(arm).max() * allowed.sum() + self.lever_of_shear(),
                 held.any())]
        found = []
        for name, key, ours, allowed, is_held in rows:
            if is_held or self.model.axisymmetric and name != "y":
                continue
            if key in said and abs(said[key] - ours) > allowed:
                found.append(Problem("obstacle", "%s %.8g, said to be %.8g" % (
                    key, ours, said[key])))
            if name in self.zone.force:
                wanted = self.zone.force[name](self.state.t)
                if abs(wanted - ours) > allowed:
                    found.append(Problem("obstacle", "%s %.8g instead of the "
                                         "given %.8g" % (key, ours, wanted)))
        return found

    def lever_of_shear(self):
        """Friction acts on the obstacle in the feet of the slave's places, which
        the Gauss-point discretization leaves gaps to: a moment of mu times the
        pressure times the gap at most."""
        if self.rule != "Gauss":
            return 0.0
        near = self.gaps[self.gaps <= self.reach + self.facets()]
        push = np.hypot(*self.state.residual[self.nodes].T).sum()
        return self.zone.mu * push * np.abs(near).max(initial=0)

    def check_way(self):
        """The motions that are given are those that the program says."""
        said = motions.said(self.zone, self.state.record)
        found = []
        for name, key in (("x", "obstacle_motion_x"), ("y", "obstacle_motion_y"),
                          ("angle", "obstacle_turn")):
            if name not in self.zone.motion or key not in said:
                continue
            way = self.zone.motion[name](self.state.t) - self.zone.motion[
                name](0.0)
            if abs(way - said[key]) > 1e-9 * (abs(way) + 1e-3 *
                                              self.scene.size):
                found.append(Problem("obstacle", "%s %.8g, said to be %.8g" % (
                    key, way, said[key])))
        return found

    def check_friction(self, before):
        """Against the slip on the material of the obstacle, node by node."""
        if not self.zone.mu or before is None or self.model.degree == 2 or (
                self.rule == "Gauss"):
            return []
        x = self.state.x[self.nodes]
        step = self.state.u[self.nodes] - before.u[self.nodes]
        way = x - before.placements[self.zone.name].at(self.placement.back(x))
        n = self.master.normals(x)
        t = np.stack([-n[:, 1], n[:, 0]], 1)
        force = self.state.residual[self.nodes]
        along = lambda vectors, axis: np.einsum("ki,ki->k", vectors, axis)
        slip, push, shear = (along(step - way, t), along(force, n),
                             along(force, t))
        moved = max(np.abs(step).max(), np.abs(way).max(), 1e-6 * self.largest)
        work = (shear * slip)[self.counts].sum()
        if work > 0.1 * np.abs(shear * slip)[self.counts].sum() + 1e-2 * (
                self.zone.mu * np.abs(push).sum() * moved):
            return [Problem("friction", "of the obstacle does work: %.3g N mm" %
                            work)]
        bound = self.zone.mu * push
        slips = self.counts & (np.abs(slip) > SLIPS * moved)
        lacks = np.where(slips, bound + np.sign(slip) * shear, 0)
        k = lacks.argmax()
        if lacks[k] > SHEAR * abs(bound[k]) + 1e-2 * np.abs(bound).max():
            return [self.problem("shear", k, "slips by %.3g mm under %.4g of mu "
                                 "p = %.4g" % (slip[k], shear[k], bound[k]))]
        return []


class GlueCheck(ZoneCheck):
    """Places of the slave go where those of the master go that they face
    undeformed, but for the shortening of a bolt."""

    def problems(self, before):
        self.drawn = surfaces.Polyline(self.lines_of_master(), self.model.X)
        jump, judged = (self.jumps_of_nodes() if self.rule == "nodal" else
                        self.weighted_jumps())
        found = []
        normal = self.normal_as_drawn()
        if self.zone.preload:
            said = motions.said(self.zone, self.state.record)
            jump = jump - said.get("shortening", np.nan) * normal
            found += self.check_cut(before, normal)
        off = np.where(judged, np.hypot(*jump.T), 0)
        k = off.argmax()
        if off[k] <= GLUED[self.rule] * self.slack:
            return found
        if np.isnan(off[k]):
            return found + [Problem("preload", "no shortening is said")]
        return found + [Problem("glue", "parts by %.3g mm at (%.5g, %.5g), "
                                "displacements %.3g mm" % (
                                    off[k], *self.model.X[self.nodes[k]],
                                    self.largest))]

    def normal_as_drawn(self):
        """The mean outward one of the slave."""
        line = surfaces.Polyline(self.lines, self.model.X)
        n = (line.normal * line.length[:, None]).sum(0)
        return n / np.hypot(*n)

    def of_master(self, points):
        """Displacements of the closest places of the undeformed master, and how
        far they are."""
        distance, piece, s = self.drawn.closest(points)
        line = self.drawn.line[piece]
        if self.model.degree == 2:
            s = (piece % surfaces.PIECES + s) / surfaces.PIECES
        shapes = np.array([elements.edge(2 * a - 1, self.model.degree)[0]
                           for a in s])
        return np.einsum("pa,pai->pi", shapes, self.state.u[
            self.lines_of_master()[line]]), distance

    def jumps_of_nodes(self):
        u, distance = self.of_master(self.model.X[self.nodes])
        return (self.state.u[self.nodes] - u,
                (distance <= FACES * self.scene.size) & self.judged)

    def weighted_jumps(self):
        """By dual functions (degree 1): of nodes whose edges face the master as
        a whole."""
        jump = np.zeros((len(self.nodes), 2))
        weight = np.zeros(len(self.nodes))
        faces = np.ones(len(self.nodes), bool)
        if self.model.degree == 2:
            return jump, ~faces
        X = self.model.X
        for line in self.lines:
            at = np.searchsorted(self.nodes, line)
            length = np.hypot(*(X[line[1]] - X[line[0]]))
            for place in (np.arange(PLACES) + 0.5) / PLACES * 2 - 1:
                N = elements.edge(place, 1)[0]
                u, distance = self.of_master((N @ X[line])[None])
                dual = 2 * N - N[::-1]
                jump[at] += np.outer(dual, N @ self.state.u[line] - u[0]) * (
                    length / PLACES)
                faces[at] &= distance[0] <= 1e-3 * length
            weight[at] += length / 2
        return jump / weight[:, None], faces & self.judged

    def check_cut(self, before, normal):
        """The tension in the cut: that which is given, later that which is said
        with the shortening of before."""
        zone, state = self.zone, self.state
        said = motions.said(zone, state.record)
        if state.held[self.nodes].any() or self.shared[self.nodes].any():
            return []
        ours = (state.residual[self.nodes] @ normal).sum()
        allowed = RESULTANT * state.scale + 3 * state.error[self.nodes].sum()
        found = []
        wanted = [("said", said.get("preload", np.nan))]
        keeps = state.begin >= zone.preload_end - 1e-12
        if not keeps:
            wanted.append(("given", zone.preload(state.t)))
        for what, value in wanted:
            if not abs(ours - value) <= allowed:
                found.append(Problem("preload", "%.8g N, %s %.8g" % (
                    ours, what, value)))
        if before is not None and keeps:
            kept = motions.said(zone, before.record).get("shortening", np.nan)
            if not abs(kept - said["shortening"]) <= 1e-9 * self.scene.size:
                found.append(Problem("preload", "the shortening %.8g was %.8g" %
                                     (said["shortening"], kept)))
        return found
