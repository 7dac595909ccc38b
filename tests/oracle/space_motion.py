"""Zones in 3-D on obstacles, at rest or moving."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import motions
import space_surfaces
from motion_check import RESULTANT
from space_zone import SpaceZoneCheck
from zone_check import PENETRATION, Problem


def zone_check_of(scene, model, state, zone, largest, shared):
    kind = ObstacleCheck if zone.obstacle else SpaceZoneCheck
    return kind(scene, model, state, zone, largest, shared)


class ObstacleCheck(SpaceZoneCheck):
    """Also what the program says of the obstacle, and what is given."""

    def problems(self, before):
        self.placed_before = before.placements[self.zone.name] if before else (
            motions.placement(self.zone, 0.0, {}))
        found = super().problems(before)
        if not found and not self.shared[self.nodes].any():
            found += self.check_forces()
        return found + self.check_way()

    @property
    def placement(self):
        return self.state.placements[self.zone.name]

    def facets(self):
        """The diagonal of a face spans an arc of what is rigid and round, whose
        nodes alone touch it: its square / 8 R."""
        rise = super().facets()
        kind, numbers = self.zone.obstacle.split(": ")
        radius = float(numbers.split(",")[-1])
        if kind != "half space" and radius > 0:
            diagonals = 1 if self.own.n in space_surfaces.TRIANGLES else 2
            rise = max(rise, diagonals * self.own.face_size.max() ** 2 / (
                8 * radius))
        return rise

    def slip(self, step):
        """On the material of the obstacle."""
        x = self.state.x[self.nodes]
        way = x - self.placed_before.at(self.placement.back(x))
        n = self.normals_of_functions()
        return self.of_functions(step[self.nodes] - way), n

    def normals_of_functions(self):
        """In the places that belong to the functions: forces on these do the
        same work on the motions of such places as those of nodes on theirs."""
        return self.master.normals(self.of_functions(self.state.x[self.nodes]))

    def check_weighted(self):
        """The distances from what is rigid of all nodes, combined likewise: none
        is negative, and where a force acts it is zero."""
        x = self.state.x[self.nodes]
        ways = self.of_functions(self.master.gap(x)[:, None] *
                                 self.master.normals(x))
        gaps = np.einsum("ki,ki->k", ways, self.normals_of_functions())
        allowed = PENETRATION["nodal"] * self.slack
        for bad, reason in ((self.judged & (gaps < -allowed), "penetration"),
                            (self.counts & (gaps > allowed), "force at a gap")):
            if bad.any():
                k = np.flatnonzero(bad)[np.abs(gaps[bad]).argmax()]
                return [self.problem(reason, k, "gap %.3g mm, displacements "
                                     "%.3g mm" % (gaps[k], self.largest))]
        return []

    def check_forces(self):
        """Forces on the slave, as they are said and given, and their moments."""
        forces = self.state.residual[self.nodes]
        force = forces.sum(0)
        error = 3 * self.state.error[self.nodes].sum(0)
        held = self.state.held[self.nodes].any(0)
        said = motions.said(self.zone, self.state.record)
        found = []
        for d, axis in enumerate("xyz"):
            allowed = RESULTANT * self.state.scale + error[d]
            key = "obstacle_force_" + axis
            if held[d]:
                continue
            if key in said and abs(said[key] - force[d]) > allowed:
                found.append(Problem("obstacle", "%s %.8g, said to be %.8g" % (
                    key, force[d], said[key])))
            wanted = self.zone.force.get(axis, lambda t: force[d])(self.state.t)
            if abs(wanted - force[d]) > allowed:
                found.append(Problem("obstacle", "%s %.8g instead of the given "
                                     "%.8g" % (key, force[d], wanted)))
        arm = self.state.x[self.nodes] - self.placement.centre
        moment = np.cross(arm, forces).sum(0)
        allowed = np.abs(arm).max() * (RESULTANT * self.state.scale +
                                       error.sum())
        for d, axis in enumerate("xyz"):
            key = "obstacle_moment_" + axis
            if not held.any() and key in said and abs(
                    said[key] - moment[d]) > allowed:
                found.append(Problem("obstacle", "%s %.8g, said to be %.8g" % (
                    key, moment[d], said[key])))
        return found

    def check_way(self):
        """The motions that are given are those that the program says."""
        said = motions.said(self.zone, self.state.record)
        found = []
        for name, formula in self.zone.motion.items():
            key = ("obstacle_turn" if name == "angle" else
                   "obstacle_motion_" + name)
            way = formula(self.state.t) - formula(0.0)
            if key in said and abs(way - said[key]) > 1e-9 * (
                    abs(way) + 1e-3 * self.scene.size):
                found.append(Problem("obstacle", "%s %.8g, said to be %.8g" % (
                    key, way, said[key])))
        return found
