"""Forces and gaps of a contact zone in 3-D, seen on the deformed surfaces."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spl
from scipy.optimize import nnls

import elements
import space_surfaces
from zone_check import (ANGLE, APART, CORNER, COUNTS, PENETRATION, PLACES, Problem,
                        ROUND, connected, work_of)

# Of mu N times the slip: what friction may dissipate less, since forces are
# those of the end of an increment, and slips and pressures those of nodes.
DISSIPATION = 0.1
# Between two normals, of which one is right.
SHARES = np.linspace(0, 1, 9)
# Of the largest displacement: by how much glued surfaces may part in places.
GLUE = 0.05
# Points of a face along each side, and the share of it that is too little.
POINTS = 6
SLIVER = 0.05
# Of the largest displacement: the gaps of nodes as the discretization has them.
WEIGHTED = 0.05
# Of the forces times the largest displacement: what feet of points may be off.
LEVER = 0.01
# The shape functions of vertices have the integral zero on triangles of 6 nodes:
# they get this part of those of the sides that meet there.
PART = 0.2


def cone_angle(force, directions):
    """The angle between a force and the convex cone of some directions."""
    directions = np.array(directions)
    size = np.linalg.norm(force)
    weights, rest = nnls(directions.T, force / size)
    if weights.any():
        return np.arcsin(min(1.0, rest))
    return np.arccos(np.clip((directions @ force).max() / size, -1, 1))


def unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1,
                                               keepdims=True), 1e-300)


def basis(n):
    """The functions that dual ones are of, as combinations of the shape
    functions of a face with n nodes."""
    T = np.eye(n)
    if n == 6:
        T[3:, 3:] *= 1 - 2 * PART
        for side, ends in enumerate(elements.TRIANGLE, 3):
            T[ends, side] = PART
    return T


def to_functions(nodes, faces):
    """The matrix that makes forces on the functions of these nodes of those on
    the nodes; its inverse, transposed, makes the same of places."""
    T = sp.identity(len(nodes), format="lil")
    if faces.shape[1] == 6:
        at = np.searchsorted(nodes, faces)
        for side, ends in enumerate(elements.TRIANGLE, 3):
            T[at[:, side], at[:, side]] = 1 - 2 * PART
            for end in ends:
                T[at[:, end], at[:, side]] = PART
    return T.tocsc()


class DualWeights:
    """The dual functions of the nodes of a slave, of what the master covers of
    each face: combinations of its shape functions, by D M^-1."""

    def __init__(self, check):
        self.nodes, self.faces = check.nodes, check.faces
        n = self.faces.shape[1]
        rule = elements.face_rule(n, POINTS)
        tables = [elements.face(place, n) for place, _ in rule]
        self.shapes = np.array([N for N, _ in tables])
        x = check.state.x[self.faces]
        self.points = np.einsum("qa,fai->fqi", self.shapes, x)
        tangents = np.einsum("qad,fai->fqdi", np.array([s for _, s in tables]),
                             x)
        area = np.linalg.norm(np.cross(tangents[:, :, 0], tangents[:, :, 1]),
                              axis=2) * np.array([w for _, w in rule])
        covered = check.master.covers(self.points.reshape(-1, 3)).reshape(
            area.shape)
        w = area * covered
        self.share = w.sum(1) / area.sum(1)
        self.partly = check.partly(self.share)
        w[self.share < SLIVER] = 0
        B = self.shapes @ basis(n).T
        D = np.einsum("fq,qa->fa", w, B)
        M = np.einsum("fq,qa,qb->fab", w, B, B)
        inverse = np.linalg.pinv(M, rcond=1e-8, hermitian=True)
        dual = np.einsum("fa,fab,qb->fqa", D, inverse, B)
        self.w = w[:, :, None] * dual
        self.number = np.searchsorted(self.nodes, self.faces)
        self.D = np.zeros(len(self.nodes))
        np.add.at(self.D, self.number, D)
        if n == 6:
            # What is covered in part has linear functions.
            self.share[self.partly] = 0
        # What all faces around are covered of.
        self.least = np.ones(len(self.nodes))
        np.minimum.at(self.least, self.number, self.share[:, None])

    def of_nodes(self, values):
        values = values.reshape(self.w.shape[:2] + (3,))
        total = np.zeros((len(self.nodes), 3))
        np.add.at(total, self.number, np.einsum("fqa,fqi->fai", self.w, values))
        # Of degree 2 what is covered in part may have no weight, or a negative.
        has = self.D > 1e-9 * self.D.max()
        return total * np.where(has, 1 / np.where(has, self.D, 1), 0)[:, None]


class SpaceZoneCheck:
    """Forces and gaps of a zone."""

    def __init__(self, scene, model, state, zone, largest, shared):
        self.scene, self.model, self.state = scene, model, state
        self.zone = zone
        self.rule = scene.rule_of(zone)
        self.faces = model.lines[zone.slave]
        self.nodes = np.unique(self.faces)
        self.master = space_surfaces.master_of(model, zone, state)
        self.largest = largest
        # The largest displacement, but at least the resolution of the mesh file.
        self.slack = largest + 1e-9 * scene.size
        self.points = space_surfaces.samples(self.faces, state.x)
        flat = self.points.reshape(-1, 3)
        self.gaps = self.master.gap(flat).reshape(self.points.shape[:2])
        self.normals = self.master.normals(flat).reshape(self.points.shape)
        self.own = space_surfaces.Facets(self.faces, state.x)
        self.shared = shared
        self.weights = self.weighted_normals = None
        self.transform = to_functions(self.nodes, self.faces)
        left_out = shared[self.nodes] | state.held[self.nodes].any(1)
        self.judged = (abs(self.transform) @ left_out) == 0
        self.force = self.transform @ state.residual[self.nodes]
        self.touching = self.gaps <= APART * self.slack
        self.lying = self.touching.sum(1) > 3
        self.around = [np.flatnonzero((self.faces == n).any(1))
                       for n in self.nodes]
        self.own_normals = np.array([self.mean_normal(where)
                                     for where in self.around])
        self.size = np.linalg.norm(self.force, axis=1)
        noise = 10 * abs(self.transform) @ np.linalg.norm(
            state.error[self.nodes], axis=1)
        self.counts = self.judged & (self.size > np.maximum(
            noise, COUNTS * max(self.size.max(), 1e-4 * state.scale)))

        # What acts on a node, or on several together.
        self.acting = self.force.copy()
        # Nodes whose function has the force of one dual function, along a normal
        # between the slave's own one and the weighted one of the master.
        self.alone = np.zeros(len(self.nodes), bool)
        if self.rule == "mortar" and not zone.obstacle:
            self.take_together()

    def partly(self, share):
        """Faces that the master covers in part; strips narrower than the
        distance of the points are seen by its rim."""
        return (share > 0) & (share < 1) | self.own.crossed(
            self.master.group.rim())

    def take_together(self):
        """What acts on a part of a face goes to all of its nodes: of degree 2
        with the signs of the shape functions there, and of either degree a node
        that is covered little leaves its dual function to others, with which
        its shape function may have a negative integral, while that of the sum of
        both is positive. The nodes of faces that the master covers in part are
        judged by their sum."""
        self.weights = DualWeights(self)
        partly = self.weights.partly
        self.alone = ~np.isin(self.nodes, self.faces[partly]) & self.smooth()
        for nodes in connected(self.faces[partly]):
            together = np.isin(self.nodes, list(nodes))
            self.acting[together] = self.force[together].sum(0)
            self.counts[together] &= self.judged[together].all() and (
                np.linalg.norm(self.force[together].sum(0)) >
                COUNTS * self.size.max())
            around = np.flatnonzero(np.isin(self.faces, list(nodes)).any(1))
            for k in np.flatnonzero(together):
                self.around[k] = around

    def problems(self, before):
        found = self.check_moments()
        if self.zone.tied:
            return found + self.check_glue()
        found += self.check_penetration() + self.check_weighted()
        for k in np.flatnonzero(self.counts):
            problem = self.check_force(k)
            if problem:
                found.append(problem)
                break
        if not found:
            found += self.check_resultant()
        if not found:
            found += self.check_friction(before)
        if not found:
            found += self.check_work(before)
        return found

    def check_moments(self):
        """What the surfaces exert on each other turns nothing."""
        if self.zone.obstacle:
            return []
        nodes = np.union1d(self.nodes, self.model.lines[self.zone.master])
        if self.shared[nodes].any() or self.state.held[nodes].any():
            return []
        f = self.state.residual[nodes]
        arm = self.state.x[nodes] - self.state.x[nodes].mean(0)
        total = np.linalg.norm(f, axis=1).sum()
        moment = np.linalg.norm(np.cross(arm, f).sum(0))
        noise = (np.linalg.norm(arm, axis=1) * np.linalg.norm(
            self.state.error[nodes], axis=1)).sum()
        allowed = LEVER * self.slack * total + 3 * noise + 1e-6 * (
            max(total, 1e-2 * self.state.scale) * np.ptp(arm))
        if self.rule == "mortar":
            # What facets of round surfaces overlap by is a lever of the shear,
            # and its part along the surface one of the pressure.
            n = np.array([self.mean_normal(where) for where in self.around])
            push = np.einsum("ki,ki->k", self.force, n)
            shear = self.force - push[:, None] * n
            allowed += (self.facets() * np.linalg.norm(shear, axis=1).sum() +
                        self.offsets() * np.abs(push).sum())
        if moment <= allowed:
            return []
        return [Problem("moment", "%.3g N mm of %.3g N on arms up to %.3g mm" %
                        (moment, total, np.ptp(arm)))]

    def check_glue(self):
        """Places of the slave go where those of the master go that they face
        undeformed; with the mortar discretization in the weighted mean."""
        X, u = self.model.X, self.state.u
        lines = self.model.lines[self.zone.master]
        if self.rule == "mortar":
            jump, _ = self.at_nodes(lambda nodes: u[nodes])
            off = np.linalg.norm(jump, axis=1)[
                self.judged & (self.weights.least > 1 - SLIVER)]
            return self.parted(off.max(initial=0))
        drawn = space_surfaces.Facets(lines, X)
        distance, triangle, _, shapes = drawn.closest(X[self.nodes])
        of_master = np.einsum("pa,pai->pi", shapes,
                              u[lines[drawn.face[triangle]]])
        off = np.linalg.norm(u[self.nodes] - of_master, axis=1)
        off[distance > 1e-9 * self.scene.size] = 0
        return self.parted(off.max())

    def parted(self, off):
        if off <= GLUE * self.slack:
            return []
        return [Problem("glue", "parts by %.3g mm, displacements %.3g mm" % (
            off, self.largest))]

    def check_penetration(self):
        allowed = PENETRATION[self.rule] * self.slack
        if self.rule == "nodal":
            # That of the middle of a side is 0.6 of the gap of its function and
            # 0.2 of those of both vertices: negative only if one of these is.
            gaps = self.of_functions(self.master.exact_gap(
                self.state.x[self.nodes]))
            lowest = gaps[self.state.held[self.nodes].sum(1) < 3].min(initial=0)
        else:
            # In the mean over a face, and at single places of it.
            deepest = min(self.gaps.min(), -self.depth_of_master())
            lowest = min(self.gaps.mean(1).min(),
                         deepest * PENETRATION[self.rule] / PLACES)
            allowed += self.facets() + self.sagitta()
        if lowest >= -allowed:
            return []
        return [Problem("penetration", "%.3g mm, displacements %.3g mm, "
                        "rule %s" % (-lowest, self.largest, self.rule))]

    def check_weighted(self):
        """Gaps as the mortar discretization weights them: none is negative, and
        where a force acts none is open."""
        if self.rule == "nodal" or self.zone.obstacle:
            return []
        jump, n = self.at_nodes(lambda nodes: self.state.x[nodes])
        gaps = np.einsum("ki,ki->k", jump, n)
        judged = self.judged & (self.weights.least > 1 - SLIVER)
        # Where the master is round we look for it along other lines.
        near = np.array([np.abs(self.gaps[where]).max() <= self.slack
                         for where in self.around])
        judged &= near
        # The gap is known where each function has the force of one dual function
        # as well as that of a node.
        allowed = np.where(self.alone, PENETRATION["nodal"], WEIGHTED) * (
            self.slack) + self.sagitta()
        for bad, reason in ((judged & (gaps < -allowed), "weighted penetration"),
                            (judged & self.counts & (gaps > allowed),
                             "force at a gap")):
            if bad.any():
                k = np.flatnonzero(bad)[np.abs(gaps[bad]).argmax()]
                return [self.problem(reason, k, "weighted gap %.3g mm, displace"
                                     "ments %.3g mm" % (gaps[k],
                                                        self.largest))]
        return []

    def depth_of_master(self):
        """How deep nodes of the master are inside of the slave's bodies."""
        if self.zone.obstacle:
            return 0.0
        nodes = np.unique(self.model.lines[self.zone.master])
        return max(space_surfaces.depths(outline, self.state.x[nodes]).max()
                   for outline in space_surfaces.outlines(
                       self.model, self.faces, self.state.x))

    def surfaces(self):
        return [self.own] + ([self.master.group] if hasattr(
            self.master, "group") else [])

    def turns(self):
        """Of neighboring facets of round surfaces the angle between them, and
        the longer of their edges."""
        yield 0.0, 0.0
        for group in self.surfaces():
            at = {}
            corners = group.faces[:, space_surfaces.RINGS[group.n]]
            for f, face in enumerate(corners.tolist()):
                for a, b in zip(face, face[1:] + face[:1]):
                    at.setdefault(frozenset((a, b)), []).append(f)
            for pair in at.values():
                turn = np.linalg.norm(np.cross(*group.face_normal[
                    [pair[0], pair[-1]]]))
                if turn < ROUND:
                    yield turn, group.face_size[pair].max()

    def facets(self):
        """By how much the corners of facets overlap where round surfaces touch:
        edge^2 / 8 R of either side, R from the turns between neighbors."""
        return max(turn * edge / 4 for turn, edge in self.turns())

    def offsets(self):
        """The part along the surface of such an overlap."""
        return max(turn**2 * edge / 4 for turn, edge in self.turns())

    def sagitta(self):
        """Of the triangles that a face which is not flat is cut into."""
        deepest = 0.0
        for group in self.surfaces():
            turn = np.linalg.norm(np.cross(group.normal, group.face_normal[
                group.face]), axis=1)
            cuts = space_surfaces.CUTS[group.n]
            deepest = max(deepest, (turn * group.face_size[
                group.face]).max() / (4 * cuts ** 2))
        return deepest

    def check_force(self, k):
        """The force on a slave node: where there is contact, into the body,
        inside of the cone."""
        where = self.around[k]
        gap = min(self.gaps[where].min(), self.distance_of_master(where))
        if gap > APART * self.slack + self.facets():
            return self.problem("force without contact", k, "gap %.3g mm" % gap)
        directions, reference = self.directions(k, where)
        angle = cone_angle(self.acting[k], directions)
        friction = np.arctan(self.zone.mu)
        if angle <= friction + ANGLE:
            return None
        inward = self.acting[k] @ reference
        return self.problem("tension" if inward < 0 else "cone", k,
                            "%.3g rad outside of the cone, mu %.3g" % (
                                angle - friction, self.zone.mu))

    def distance_of_master(self, where):
        """Of places of the master from faces of the slave: an edge or a corner
        may lie between the places on these."""
        if self.zone.obstacle:
            return np.inf
        return self.distances_of_master(where).min()

    def distances_of_master(self, where):
        """By faces of the master."""
        part = space_surfaces.Facets(self.faces[where], self.state.x)
        places = space_surfaces.samples(self.model.lines[self.zone.master],
                                        self.state.x)
        return part.closest(places.reshape(-1, 3))[0].reshape(
            places.shape[:2]).min(1)

    def directions(self, k, where):
        """In which the master may push here: its normals where the slave's
        faces face it, the slave's own, turned round, where those lie on it,
        and those around corners of the master that touch them."""
        if self.alone[k]:
            if self.weighted_normals is None:
                # Means by the dual functions may be outside of the range of what
                # they are means of.
                self.weighted_normals = self.at_nodes(
                    lambda nodes: self.state.x[nodes])[1]
            weighted = self.weighted_normals[k]
            return [self.own_normals[k], weighted], weighted
        normals = self.normals[where].reshape(-1, 3)
        gaps = self.gaps[where].ravel()
        near = gaps <= gaps.min() + 0.5 * self.own.face_size[where].max()
        found = list(normals[near])
        reference = normals[gaps.argmin()]
        lying = where[self.lying[where]]
        own = list(-self.own.normal[np.isin(self.own.face, lying)])
        if self.rule == "mortar":
            own.append(self.mean_normal(where))
        own += self.around_master(where)
        found += [n for n in own if n @ reference > 0]
        return found, reference

    def mean_normal(self, where):
        """Along which the mortar discretization pushes a node: the mean of the
        normals of its faces, turned round."""
        return -unit(self.own.face_normal[where].sum(0))

    def smooth(self):
        """Nodes around which the slave as drawn has no corner, where each side
        has a dual function and a normal of its own."""
        drawn = space_surfaces.Facets(self.faces, self.model.X).face_normal
        return np.array([np.linalg.norm(np.cross(
            drawn[where][:, None], drawn[where][None]), axis=2).max() < CORNER
            for where in self.around])

    def mean_normals(self):
        """Those of the nodes on which forces act."""
        if self.rule != "mortar":
            return np.empty((0, 3))
        return np.array([self.mean_normal(self.around[k])
                         for k in np.flatnonzero(self.counts)])

    def around_master(self, where):
        if self.zone.obstacle:
            return []
        faces = self.distances_of_master(where) <= APART * self.slack
        return list(self.master.group.face_normal[faces])

    def problem(self, reason, k, detail):
        return Problem(reason, "%s; %.3g N, largest %.3g N at (%s)" % (
            detail, self.size[k], self.size.max(), ", ".join(
                "%.5g" % x for x in self.model.X[self.nodes[k]])))

    def is_flat(self):
        if self.zone.obstacle:
            return self.zone.obstacle.startswith("half")
        return self.is_drawn_flat(self.model.lines[self.zone.master])

    def is_drawn_flat(self, faces):
        drawn = space_surfaces.Facets(faces, self.model.X).normal
        return np.abs(drawn - drawn[0]).max() < 1e-9

    def check_resultant(self):
        """A flat master pushes along its own normal."""
        faces = self.touching.any(1)
        of_contact = np.isin(self.nodes, self.faces[faces])
        if not (self.counts & of_contact).any() or not self.is_flat() or (
                not self.judged[of_contact].all()):
            return []
        # The slave's own normals, for a face that lies on an end of the master,
        # or that bends over it.
        directions = np.concatenate([
            self.normals[self.touching],
            -self.own.normal[np.isin(self.own.face,
                                     np.flatnonzero(self.lying))],
            self.mean_normals()])
        total = self.force[self.judged].sum(0)
        angle = cone_angle(total, directions)
        if angle <= np.arctan(self.zone.mu) + 0.02:
            return []
        return [Problem("resultant", "%.3g rad outside of the master's normals,"
                        " mu %.3g, %.3g N" % (angle, self.zone.mu,
                                              np.linalg.norm(total)))]

    def slip(self, step):
        """Ways of the slave's nodes on the master, and the normals there."""
        return self.at_nodes(lambda nodes: step[nodes])

    def at_nodes(self, field):
        """A field of the slave minus that of the master (none of what is rigid),
        and the master's normal: at the nodes, or weighted around them by dual
        functions."""
        if self.rule == "nodal" or self.zone.obstacle:
            jump, n = self.jump(self.state.x[self.nodes], field(self.nodes),
                                field)
            return self.of_functions(jump), unit(self.of_functions(n))
        if self.weights is None:
            self.weights = DualWeights(self)
        w = self.weights
        jump, n = self.jump(w.points.reshape(-1, 3), np.einsum(
            "qa,fai->fqi", w.shapes, field(self.faces)).reshape(-1, 3),
            field)
        return w.of_nodes(jump), unit(w.of_nodes(n))

    def of_functions(self, of_nodes):
        """Gaps, places, ways of the functions that forces are on."""
        if self.faces.shape[1] != 6:
            return of_nodes
        return spl.spsolve(self.transform.T.tocsc(), of_nodes)

    def jump(self, x, of_slave, field):
        if self.zone.obstacle:
            return of_slave, self.master.normals(x)
        group = self.master.group
        face, _, shapes = group.feet(x)
        of_master = np.einsum("pa,pai->pi", shapes, field(group.faces[face]))
        return of_slave - of_master, group.mean_normals(x)

    def has_step(self, before):
        """Whether the way of the increment is known."""
        return before is not None or int(self.scene.entries.get(
            "Solution/Increments", 2)) == 1

    def check_work(self, before):
        """Contact takes work: where a force acts the gap has closed, and friction
        is against the slip. Forces of both surfaces on their ways are the same
        sum, whatever places face each other."""
        if self.zone.obstacle or not self.has_step(before):
            return []
        nodes = np.union1d(self.nodes, self.model.lines[self.zone.master])
        if self.state.held[nodes].any() or self.shared[nodes].any():
            return []
        work, most = work_of(self.state, before, nodes, self.slack)
        pushed = 0.0 if before else self.overlap_of_mesh() * np.linalg.norm(
            self.force, axis=1).sum()
        if work <= LEVER * most + pushed:
            return []
        return [Problem("work", "contact does %.3g N mm, forces times ways "
                        "%.3g" % (work, most))]

    def overlap_of_mesh(self):
        """The depth of the undeformed bodies inside of each other: forces push
        them apart."""
        X = self.model.X
        faces, of_master = self.faces, self.model.lines[self.zone.master]
        return max(space_surfaces.depths(outline, places).max()
                   for own, places in (
                       (of_master, space_surfaces.samples(faces, X)),
                       (faces, space_surfaces.samples(of_master, X)))
                   for outline in space_surfaces.outlines(self.model, own, X)
                   for places in [places.reshape(-1, 3)])

    def check_friction(self, before):
        """Friction acts against the slip, and what slips is under mu p."""
        if self.zone.mu == 0 or not self.has_step(before):
            return []
        step = self.state.u - (before.u if before is not None else 0)
        push, work, most = self.dissipation(step)
        judged = self.counts & (push > 0)
        if self.weights is not None:
            judged &= self.weights.least > 1 - SLIVER
        # The error of known slips; a sticking point may have one of either sense.
        moved = max(np.abs(step).max(), 1e-6 * self.largest)
        small = 1e-2 * self.zone.mu * push * moved
        lacks = work + (1 - DISSIPATION) * most - (2 - DISSIPATION) * small
        exact = judged & (self.alone if self.weights else self.touch())
        if (lacks[exact] > 0).any():
            k = np.where(exact, lacks, 0).argmax()
            return [self.problem("friction", k, "dissipates %.4g N mm, mu N "
                                 "times the slip is %.4g" % (-work[k],
                                                             most[k]))]
        work, most, small, lacks = (v[judged].sum() for v in (
            work, most, small, lacks))
        if work > DISSIPATION * most + small:
            return [Problem("friction", "does work: %.3g of %.3g N mm" % (
                work, most))]
        if self.is_flat() and lacks > 0:
            return [Problem("friction", "dissipates %.4g N mm, mu N times the "
                            "slip is %.4g" % (-work, most))]
        return []

    def touch(self):
        """Nodes that touch: a corner of the master between them pushes on all the
        nodes of a face."""
        gaps = self.master.gap(self.state.x[self.nodes])
        return self.of_functions(gaps) <= self.slack

    def dissipation(self, step):
        """Of each node: the push, the work of its shear on its slip, and mu times
        the push times the slip: what a slip should dissipate. With the mortar
        discretization forces are along normals between the slave's own ones and
        those of the master: along the one that these two agree best with."""
        ways, n = self.slip(step)
        found = []
        for share in SHARES if self.weights is not None else (1.0,):
            normals = unit((1 - share) * self.own_normals + share * n)
            push = np.einsum("ki,ki->k", self.force, normals)
            shear = self.force - push[:, None] * normals
            along = ways - np.einsum("ki,ki->k", ways, normals)[:, None] * (
                normals)
            found.append((push, np.einsum("ki,ki->k", shear, along),
                          self.zone.mu * push * np.linalg.norm(along, axis=1)))
        found = np.array(found)
        best = (found[:, 1] + found[:, 2]).argmin(0)
        return found[best, :, np.arange(len(best))].T
