"""A zone whose surfaces go round edges, in 2-D and in 3-D: nothing is
asked of nodes that have one normal. Depths are taken at many places of both
surfaces and compared with what the bodies approach each other by; forces with the
cone of the normals of all facets that face each other around a node; the whole
of them with a solution of our own where there is no friction."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import copy

import numpy as np

import own_contact
import results
import sides
import space_surfaces
import surfaces
from space_surfaces import TRIANGLES
from space_zone import cone_angle, to_functions
from zone_check import (ANGLE, APART, COUNTS, Problem, connected, noise_of,
                        work_of)

# Of the approach (without a known one of the largest displacement): how deep a
# place may be inside of the other body. Nodes of the slave; places of both
# surfaces, with one, two, more facets along the sides of the slave, on which gaps
# are weighted.
NODES = 0.02
PLACES = (0.7, 0.5, 0.35)
# Places of a line or of each side of a face.
DENSE = {2: 17, 3: 6}
# Of the contact forces times the largest displacement of an increment: work that
# contact may do (gaps are zero in the weighted mean alone).
WORK = 0.1
# Of the sum of the forces in our own solution, at least of this share of all of
# them without regard to directions: by how much the sum may be another one.
NET, JAMMED = 0.15, 0.33


def corners_of(facets, dim):
    """The vertices of lines and faces of either degree."""
    n = facets.shape[1]
    if n in (4, 9):
        return facets if n == 4 else facets[:, [0, 2, 6, 8]]
    return facets[:, :dim]


def places_of(model, facets, x):
    if model.dim == 2:
        return surfaces.samples(model, facets, x, DENSE[2])[0]
    return space_surfaces.samples(facets, x, DENSE[3])


class Side:
    """The slave or the master of a zone: facets, places on them, its body."""

    def __init__(self, model, zone, group, x):
        self.facets = model.lines[group]
        self.nodes = np.unique(self.facets)
        self.places = places_of(model, self.facets, x)
        self.normals = sides.normals_of(x, corners_of(self.facets, model.dim))
        self.turn = sides.turn_of(model.X, corners_of(self.facets, model.dim))
        self.corners = x[self.corner_nodes(model.X)]
        as_master = copy.copy(zone)
        as_master.master = group
        module = surfaces if model.dim == 2 else space_surfaces
        self.body = module.DeformedBody(model, as_master, x)
        self.kind = surfaces.Polyline if model.dim == 2 else (
            space_surfaces.Facets)
        self.x = x
        edges = np.ptp(x[corners_of(self.facets, model.dim)], axis=1)
        # Chords of a round surface.
        self.sagitta = self.turn * np.linalg.norm(edges, axis=1).max() / 4

    def corner_nodes(self, X):
        """Where the surface as drawn ends, or turns as at an edge."""
        vertices = corners_of(self.facets, X.shape[1])
        normals = sides.normals_of(X, vertices)
        found = []
        for node in np.unique(vertices):
            of_node = normals[(vertices == node).any(1)]
            if len(of_node) == 1 or (of_node @ of_node.T).min() < (
                    np.cos(sides.EDGE)):
                found.append(node)
        return np.array(found, int)

    def distances_of_corners(self, other):
        """From each of our facets to the closest corner of the other side; in
        3-D none has a force of its own."""
        if self.x.shape[1] == 3 or not len(other.corners):
            return np.full(len(self.facets), np.inf)
        return np.array([self.kind(facet[None], self.x).closest(
            other.corners)[0].min() for facet in self.facets])

    def distances(self, other):
        """Of places of the other side, the least by its facets, from each of
        our facets: (other facets, facets)."""
        flat = other.places.reshape(-1, other.places.shape[-1])
        columns = [self.kind(facet[None], self.x).closest(flat)[0].reshape(
            other.places.shape[:2]).min(1) for facet in self.facets]
        return np.stack(columns, 1)

    def gaps(self, other):
        """Of places of the other side, negative inside of our body."""
        flat = other.places.reshape(-1, other.places.shape[-1])
        return self.body.gap(flat).reshape(other.places.shape[:2])


class SidesCheck:
    """Forces and gaps of a zone."""

    def __init__(self, scene, model, state, zone, largest, shared):
        self.scene, self.model, self.state = scene, model, state
        self.zone = zone
        self.rule = scene.rule_of(zone)
        self.slave = Side(model, zone, zone.slave, state.x)
        self.master = Side(model, zone, zone.master, state.x)
        self.nodes = self.slave.nodes
        self.largest = largest
        self.slack = largest + 1e-9 * scene.size
        self.sagitta = self.slave.sagitta + self.master.sagitta
        self.turn = self.slave.turn + self.master.turn
        self.force = state.residual[self.nodes]
        self.judged = ~state.held[self.nodes].any(1)
        if model.dim == 3:
            functions = to_functions(self.nodes, self.slave.facets)
            self.force = functions @ self.force
            self.judged = (abs(functions) @ ~self.judged) == 0
        self.gaps = self.master.gaps(self.slave)
        self.around = [np.flatnonzero((self.slave.facets == n).any(1))
                       for n in self.nodes]
        self.pair_facets()
        if self.rule != "nodal" or model.degree == 2:
            self.take_together()
        self.size = np.linalg.norm(self.force, axis=1)
        noise = 10 * np.linalg.norm(state.error[self.nodes], axis=1)
        self.counts = self.judged & (self.size > np.maximum(
            noise, COUNTS * max(self.size.max(), 1e-4 * state.scale)))

    def pair_facets(self):
        """Which facets of slave and master touch, and which of these face each
        other; surfaces that overlap touch as far as they do."""
        self.near = np.minimum(self.master.distances(self.slave),
                               self.slave.distances(self.master).T)
        self.reach = APART * self.slack + self.sagitta + 1.5 * np.maximum(
            -self.gaps.min(1), 0)
        touch = self.near <= self.reach[:, None]
        faces = self.slave.normals @ self.master.normals.T < (
            own_contact.FACING)
        self.touch, self.faces = touch, faces & touch

    def take_together(self):
        """What acts on a part of a facet goes to all of its nodes, with the
        signs of shape functions and of dual ones: the nodes of facets that
        touch in part, or hold a corner of the master, are judged by their
        sum."""
        reach = APART * self.slack + self.sagitta
        touch = self.touch.any(1)
        partly = touch & (
            (self.gaps > reach).any(1) |
            (self.slave.distances_of_corners(self.master) <= reach))
        if self.model.dim == 3 and self.slave.facets.shape[1] in TRIANGLES:
            # Beside a triangle that touches one that does not, with a vertex in
            # common: it spreads the force of that over its nodes if the master
            # covers a part of it; dual functions do not if all of it, or nothing.
            beside = np.isin(self.slave.facets,
                             self.slave.facets[touch]).any(1)
            partly |= beside & ~touch & self.covered_in_part()
        for nodes in connected(self.slave.facets[partly]):
            together = np.isin(self.nodes, list(nodes))
            around = np.flatnonzero(np.isin(self.slave.facets,
                                            list(nodes)).any(1))
            self.force[together] = self.force[together].sum(0)
            self.judged[together] = self.judged[together].all()
            for k in np.flatnonzero(together):
                self.around[k] = around

    def covered_in_part(self):
        """Of facets of the slave, whether the master is straight ahead of some
        of their places."""
        places = self.slave.places
        flat = places.reshape(-1, places.shape[-1])
        ahead = self.master.body.covers(flat).reshape(places.shape[:2])
        normals = self.master.body.normals(flat).reshape(places.shape)
        ahead &= np.einsum("fpi,fi->fp", normals, self.slave.normals) < (
            own_contact.FACING)
        return ahead.any(1) & ~ahead.all(1)

    def problems(self, before):
        found = self.check_depth()
        for k in np.flatnonzero(self.counts):
            problem = self.check_force(k)
            if problem:
                found.append(problem)
                break
        if not found:
            found += self.check_work(before)
        if not found:
            found += self.check_net()
        return found

    def check_depth(self):
        approach = self.scene.approach or self.slack
        found = []
        for what, depth, share in self.depths():
            allowed = share * approach + self.sagitta + 1e-9 * self.scene.size
            if depth > allowed:
                found.append(Problem("depth", "%s %.3g mm inside of the other "
                                     "body, approach %.3g mm, rule %s" % (
                                         what, depth, approach, self.rule)))
        return found

    def depths(self):
        """What, how deep it is, and its share of the approach."""
        if self.rule == "nodal":
            # That of places between the nodes is not held.
            n = self.nodes[~self.state.held[self.nodes].all(1)]
            gaps = self.master.body.gap(self.state.x[n])
            return [("a node of the slave is", -gaps.min(), NODES)]
        share = PLACES[min(self.facets_along(), len(PLACES)) - 1]
        return [("a place of the slave is", -self.gaps.min(), share),
                ("a place of the master is",
                 -self.slave.gaps(self.master).min(), share)]

    def facets_along(self):
        """The fewest along a side of the slave that touches."""
        side = sides.sides_of(self.model.X, corners_of(self.slave.facets,
                                                       self.model.dim))
        count = np.bincount(side)[np.unique(side[self.touch.any(1)])]
        # Two triangles in the place of a quadrangle.
        halves = 1 + (self.slave.facets.shape[1] in TRIANGLES and
                      self.model.dim == 3)
        return max(1, int((count.min(initial=1000) / halves) ** (
            1 / (self.model.dim - 1))))

    def check_force(self, k):
        where = self.around[k]
        if not self.touch[where].any():
            return self.problem("force without contact", k, "gap %.3g mm" %
                                self.near[where].min())
        if self.rule == "Gauss" and self.model.degree == 2:
            return None
        pairs = self.faces[where]
        if not pairs.any():
            pairs = self.touch[where]
        directions = np.concatenate([
            self.master.normals[pairs.any(0)],
            -self.slave.normals[where[pairs.any(1)]]])
        angle = cone_angle(self.force[k], directions)
        friction = np.arctan(self.zone.mu)
        if angle <= friction + ANGLE + self.turn:
            return None
        return self.problem("cone", k, "%.3g rad outside of the cone, mu %.3g" %
                            (angle - friction, self.zone.mu))

    def problem(self, reason, k, detail):
        return Problem(reason, "%s; %.3g N, largest %.3g N at (%s)" % (
            detail, self.size[k], self.size.max(), ", ".join(
                "%.5g" % x for x in self.model.X[self.nodes[k]])))

    def all_nodes(self):
        return np.union1d(self.slave.nodes, self.master.nodes)

    def check_work(self, before):
        """Contact takes work: forces at the end of an increment on the way of
        the surfaces, which were apart or on each other before."""
        nodes = self.all_nodes()
        if self.state.held[nodes].any():
            return []
        work, most = self.work(before)
        if work <= WORK * most:
            return []
        return [Problem("work", "contact does %.3g N mm, forces times ways "
                        "%.3g" % (work, most))]

    def work(self, before):
        return work_of(self.state, before, self.all_nodes(), self.slack)

    def noise(self):
        return noise_of(self.state, self.all_nodes())

    def net(self, forces):
        """On the side that no support holds: its sum, and the sum of sizes."""
        side = self.slave if not self.state.held[self.slave.nodes].any() else (
            self.master)
        if self.state.held[side.nodes].any():
            return None
        force = forces[side.nodes]
        return force.sum(0), np.linalg.norm(force, axis=1).sum()

    def check_net(self):
        if self.zone.mu or self.scene.rigid or self.rule == "nodal":
            return []
        ours = self.net(self.state.residual)
        if ours is None or ours[1] <= max(1e-3 * self.state.scale,
                                          self.noise()):
            return []
        try:
            own = own_contact.OwnContact(self.model, self.state.t,
                                         self.slack).solve()
        except (ArithmeticError, RuntimeError):
            return []
        net, size = self.net(own.force())
        off = np.linalg.norm(ours[0] - net)
        if off <= NET * max(np.linalg.norm(net), JAMMED * size):
            return []
        return [Problem("net force", "(%s) N, in our own solution (%s)" % tuple(
            ", ".join("%.4g" % f for f in force) for force in (ours[0], net)))]


def shears(scene, model, state, run):
    """In profile.csv no shear is more than friction times the pressure; the
    Gauss-point discretization bounds it at its points, not at nodes, but without
    friction there is none at nodes either."""
    found = []
    said = results.profile(run.directory)
    round_off = 1e-12 * max(young for young, _ in scene.materials.values())
    for zone in scene.zones:
        if scene.rule_of(zone) == "Gauss" and zone.mu > 0:
            continue
        rows = said.get(("slave " + zone.name).strip(), [])
        most = max([abs(row["pressure_MPa"]) for row in rows] + [0.0])
        for row in rows:
            p, q = abs(row["pressure_MPa"]), abs(row["shear_MPa"])
            if q > zone.mu * p * (1 + 1e-6) + 1e-4 * most + round_off:
                found.append(Problem("profile", "shear %.4g at the pressure "
                                     "%.4g, mu %.3g" % (q, p, zone.mu)))
                break
    return found
