"""Forces and gaps of a contact zone, seen on the deformed surfaces."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import dual_weights
import motions
import surfaces
import zone_normals

# Of the largest displacement: what a geometry loop may leave (0.001), and by
# how much a weighted gap lets single places overlap.
PENETRATION = {"nodal": 0.01, "mortar": 0.1, "Gauss": 0.2}
# Of single places between the nodes, likewise.
PLACES = 0.8
# Gap beyond which no force may act, likewise.
APART = 0.05
# Angle by which a force may leave its cone: surfaces turn between two pairings.
ANGLE = 0.03
# More than this angle between two edges is a corner (its sine).
ROUND = 0.6
# An undeformed surface that turns by more has a corner (its sine).
CORNER = np.sin(np.radians(35))
# Forces along surfaces that bend by more are not taken together [rad].
BUNDLE = 2.0
# A slip that counts, of the largest displacement of an increment.
SLIPS = 0.05
# A force that counts, of the largest one.
COUNTS = 1e-3


class Problem:
    def __init__(self, reason, detail, size=0.0):
        self.reason = reason
        self.detail = detail
        self.size = size

    def __str__(self):
        return "%s: %s" % (self.reason, self.detail)


def connected(lines):
    """The nodes of lines that hang together."""
    found = []
    for line in lines.tolist():
        nodes = set(line)
        for other in [c for c in found if c & nodes]:
            found.remove(other)
            nodes |= other
        found.append(nodes)
    return found


def noise_of(state, nodes):
    """Of the forces on these nodes, in sum."""
    return 1e3 * np.linalg.norm(state.error[nodes], axis=1).sum()


def work_of(state, before, nodes, slack):
    """Of the forces on the nodes of both surfaces on their ways in an increment;
    and all of these forces times the largest way."""
    step = state.u - (before.u if before is not None else 0)
    force = state.residual[nodes]
    # The rest of forces that are gone does not count, nor round-off.
    size = max(np.linalg.norm(force, axis=1).sum(), 1e-4 * state.scale,
               noise_of(state, nodes))
    return ((force * step[nodes]).sum(),
            size * max(np.abs(step).max(), 1e-6 * slack))


class ZoneCheck(zone_normals.Normals):
    """Forces and gaps of a zone."""

    def __init__(self, scene, model, state, zone, largest, shared):
        self.scene, self.model, self.state = scene, model, state
        self.zone = zone
        self.rule = scene.rule_of(zone)
        self.lines = model.lines[zone.slave]
        self.nodes = np.unique(self.lines)
        self.master = motions.master_of(model, zone, state)
        self.largest = largest
        # By how much the surfaces of the mesh are apart in contact.
        self.apart = zone.apart(state.t) if zone.apart else 0.0
        # The largest displacement, but at least the resolution of the mesh file.
        self.slack = largest + 1e-9 * scene.size
        self.points, _ = surfaces.samples(model, self.lines, state.x)
        flat = self.points.reshape(-1, 2)
        self.gaps = self.master.gap(flat).reshape(self.points.shape[:2])
        self.normals = self.master.normals(flat).reshape(self.points.shape)
        self.own = surfaces.Polyline(self.lines, state.x)
        self.shared = shared
        self.weights = None
        self.judged = ~shared[self.nodes] & ~state.held[self.nodes].any(1)
        self.force = state.residual[self.nodes]
        # Lines of the slave that lie on the master: more than one place of them
        # touches.
        self.reach = APART * self.slack
        self.touching = self.gaps <= self.reach
        self.lying = self.touching.sum(1) > 1
        self.is_free = self.judged.copy()
        # The lines that what acts on a node may come from.
        self.around = [np.flatnonzero((self.lines == n).any(1))
                       for n in self.nodes]
        if self.rule == "mortar":
            self.add_neighbours()
        elif self.rule == "nodal" and model.degree == 2:
            self.take_together(connected(self.lines[self.holds_corner()]))
        self.size = np.hypot(*self.force.T)
        noise = 10 * np.hypot(*state.error[self.nodes].T)
        self.counts = self.judged & (self.size > np.maximum(
            noise, COUNTS * max(self.size.max(), 1e-4 * state.scale)))

    def problems(self, before):
        found = self.check_penetration()
        for k in np.flatnonzero(self.counts):
            problem = self.check_force(k)
            if problem:
                found.append(problem)
                break
        if not found:
            found += self.check_resultant()
        if before is not None and not found:
            found += self.check_slip(before)
        if not found:
            found += self.check_shear(before)
        return found

    def add_neighbours(self):
        """The rule mortar spreads what acts on part of an edge over all of its
        nodes, with the signs of the shape functions there: where an edge does
        not face the master as a whole, the nodes around are taken together."""
        lengths = np.bincount(self.own.line, self.own.length)
        near = 0.05 * lengths + self.slack
        partly = ((self.gaps.max(1) > self.reach) &
                  (self.gaps.min(1) <= near))
        misses = ((self.gaps > self.reach) & ~self.master.faces(
            self.points.reshape(-1, 2)).reshape(self.gaps.shape)).any(1)
        bundles = connected(self.lines[partly])
        if any(self.bends(nodes) > BUNDLE for nodes in bundles):
            # Conforming surfaces, which are near each other all around.
            bundles = connected(self.lines[partly & misses])
        self.take_together(bundles)

    def holds_corner(self):
        """Lines that a corner of the master is in contact with: its force goes
        to their nodes by shape functions, of which at degree 2 one is
        negative."""
        found = np.zeros(len(self.lines), bool)
        if self.zone.obstacle:
            return found
        drawn = surfaces.Polyline(self.model.lines[self.zone.master],
                                  self.model.X)
        corners = [self.master.group.begin[k] for k, p in enumerate(drawn.begin)
                   for n in np.flatnonzero((drawn.end == p).all(1))
                   if np.cross(drawn.tangent[n], drawn.tangent[k]) > CORNER]
        for k, line in enumerate(self.lines if corners else []):
            part = surfaces.Polyline(line[None], self.state.x)
            found[k] = part.closest(np.array(corners))[0].min() - (
                self.apart) <= self.reach
        return found

    def take_together(self, bundles):
        """Give each node the sum of the forces on a set that it is in."""
        force = self.force.copy()
        for nodes in bundles:
            together = np.isin(self.nodes, list(nodes))
            lines = np.flatnonzero(np.isin(self.lines, self.nodes[
                together]).any(1))
            force[together] = self.force[together].sum(0)
            self.judged[together] = self.judged[together].all()
            for k in np.flatnonzero(together):
                self.around[k] = lines
        self.force = force

    def bends(self, nodes):
        """The largest angle between normals of lines of these nodes."""
        n = self.own.normal[np.isin(self.lines, list(nodes)).all(1)[
            self.own.line]]
        return np.arccos(np.clip((n @ n.T).min(initial=1), -1, 1))

    def check_penetration(self):
        allowed = PENETRATION[self.rule] * self.slack + self.sagitta()
        if self.rule == "nodal":
            n = self.nodes[self.state.held[self.nodes].sum(1) < 2]
            gaps = self.master.gap(self.state.x[n])
            lowest = gaps.min(initial=0)
        else:
            # In the mean over an edge, and at single places of it.
            deepest = min(self.gaps.min(), -self.depth_of_master())
            lowest = min(self.gaps.mean(1).min(),
                         deepest * PENETRATION[self.rule] / PLACES)
            allowed += self.facets()
        if lowest >= -allowed:
            return []
        return [Problem("penetration", "%.3g mm, displacements %.3g mm, "
                        "rule %s" % (-lowest, self.largest, self.rule),
                        -lowest / self.slack)]

    def depth_of_master(self):
        """How deep nodes of the master are inside of the slave's bodies."""
        if self.zone.obstacle:
            return 0.0
        points = self.master.group.begin
        depth = 0.0
        for outline in surfaces.outlines(self.model, self.lines, self.state.x):
            inside = outline.contains(points)
            if inside.any():
                depth = max(depth, outline.closest(points[inside])[0].max() +
                            self.apart)
        return depth

    def facets(self):
        """By how much the corners of polygons overlap where round surfaces
        touch: edge^2 / 8 R of either side, R from the turns."""
        deepest = 0.0
        for line in [self.own] + ([self.master.group] if hasattr(
                self.master, "group") else []):
            follows = {tuple(p): k for k, p in enumerate(line.begin)}
            for k, p in enumerate(line.end):
                n = follows.get(tuple(p))
                turn = 0.0 if n is None else abs(np.cross(line.tangent[k],
                                                          line.tangent[n]))
                if turn < ROUND:
                    deepest = max(deepest, turn / 4 * max(line.length[k],
                                                          line.length[n or 0]))
        return deepest

    def sagitta(self):
        """Of the pieces that an edge of degree 2 is cut into."""
        if self.model.degree == 1 or self.zone.obstacle:
            return 0.0
        line = self.master.group
        turn = np.abs(np.cross(line.tangent[:-1], line.tangent[1:]))
        turn[surfaces.PIECES - 1::surfaces.PIECES] = 0
        return (turn * line.length[1:]).max(initial=0) / 8

    def check_force(self, k):
        """The force on a slave node: where there is contact, into the body,
        inside of the cone."""
        where = self.around[k]
        gap = min(self.gaps[where].min(), self.distance_of_master(where))
        if gap > self.reach + self.facets():
            return self.problem("force without contact", k, "gap %.3g mm" % gap)
        if self.rule == "Gauss" and self.model.degree == 2:
            return None
        low, high = self.range_of_normals(k, where)
        angle = self.turn(self.force[k], self.reference)
        friction = np.arctan(self.zone.mu) + ANGLE
        if low - friction <= angle <= high + friction:
            return None
        inward = self.force[k] @ self.reference
        return self.problem("tension" if inward < 0 else "cone", k,
                            "%.3g rad outside of the cone, mu %.3g" % (
                                max(low - angle, angle - high) - friction +
                                ANGLE, self.zone.mu))

    def distance_of_master(self, where):
        """Of the master's nodes from lines of the slave: a corner may lie
        between the places on these."""
        if self.zone.obstacle:
            return np.inf
        part = surfaces.Polyline(self.lines[where], self.state.x)
        return part.closest(self.master.group.begin)[0].min() - self.apart

    def problem(self, reason, k, detail):
        n = self.nodes[k]
        return Problem(reason, "%s; %.3g N, largest %.3g N at (%.5g, %.5g)"
                       % (detail, self.size[k], self.size.max(),
                          *self.model.X[n]), self.size[k])

    def check_resultant(self):
        """A flat master pushes along its own normal."""
        if not (self.counts & self.is_free).any() or not self.is_flat() or (
                not self.touching.any()):
            return []
        # Reactions of supports act on the other nodes, too.
        lines = self.touching.any(1)
        if not self.is_free[np.isin(self.nodes, self.lines[lines])].all():
            return []
        # The slave's own normal, for an edge that lies on an end of the master.
        normals = np.concatenate([
            self.normals[self.touching],
            -self.own.normal[np.isin(self.own.line,
                                     np.flatnonzero(self.lying))]])
        reference = normals.mean(0)
        reference /= np.hypot(*reference)
        angles = [self.turn(n, reference) for n in normals]
        angles += self.weighted_angles(reference)
        if max(map(abs, angles)) > 0.3:
            return []
        total = self.state.residual[self.nodes[self.is_free]].sum(0)
        if self.model.axisymmetric and abs(reference[0]) > 0.1:
            return []
        angle = self.turn(total, reference)
        friction = np.arctan(self.zone.mu) + 0.02
        if min(angles) - friction <= angle <= max(angles) + friction:
            return []
        return [Problem("resultant", "turned by %.3g from the master's normal, "
                        "mu %.3g, %.3g N" % (angle, self.zone.mu,
                                             np.hypot(*total)))]

    def is_flat(self):
        if self.zone.obstacle:
            return self.zone.obstacle.startswith("half")
        tangents = surfaces.Polyline(self.model.lines[self.zone.master],
                                     self.model.X).tangent
        return np.abs(tangents - tangents[0]).max() < 1e-9

    def check_slip(self, before):
        """Friction acts against the slip; what sticks does not slip."""
        if self.zone.mu == 0 or self.zone.obstacle or self.model.degree == 2:
            return []
        step = self.state.u - before.u
        force = self.state.residual[self.nodes]
        if self.rule == "mortar":
            slip, n, t, judged = self.weighted_slip(step)
            force = self.weights.forces(force)
            judged = judged & self.counts
        else:
            slip, n, t = self.slip(step)
            judged = self.counts
        shear = np.einsum("ki,ki->k", force, t)
        push = np.einsum("ki,ki->k", force, n)
        # At the end of a master the tangent is another one.
        judged = judged & (self.parallel(n) > 0.99)
        if self.zone.apart:
            # At a corner of a polygon the way apart is a slip along either edge.
            self.slip(step)
            judged &= self.inside
        work = (shear * slip)[judged].sum()
        scale = np.abs(shear * slip)[judged].sum()
        # Sticking nodes move by round-off.
        moved = max(np.abs(step).max(), 1e-6 * self.largest)
        total = np.abs(push).sum() * moved
        if work > 0.1 * scale + 1e-2 * self.zone.mu * total:
            return [Problem("friction", "does work: %.3g of %.3g N mm" %
                            (work, total))]
        return []

    def weighted_slip(self, step):
        """Of the mortar discretization, with the normals and tangents of its
        points, and which of them are known: those of a flat slave are its own,
        otherwise the weighted ones of the master."""
        if self.weights is None:
            self.weights = dual_weights.DualWeights(self)
        drawn = surfaces.Polyline(self.lines, self.model.X).tangent
        if np.abs(drawn - drawn[0]).max() < 1e-9:
            n = -self.weights.normals_of_nodes(self.own)
        else:
            n = self.weights.normals(self.smooth)
        t = np.stack([-n[:, 1], n[:, 0]], 1)
        return (np.einsum("ki,ki->k", self.weights.jump(step), t), n, t,
                self.weights.judged)

    def slip(self, step):
        """Of the slave's nodes along the master, with its normal and tangent."""
        group = self.master.group
        _, piece, s = group.closest(self.state.x[self.nodes])
        self.inside = np.abs(s - 0.5) < 0.45
        line = self.lines_of_master()[group.line[piece]]
        of_master = ((1 - s)[:, None] * step[line[:, 0]] +
                     s[:, None] * step[line[:, 1]])
        n = group.normal[piece]
        t = np.stack([-n[:, 1], n[:, 0]], 1)
        return np.einsum("ki,ki->k", step[self.nodes] - of_master, t), n, t

    def check_shear(self, before):
        """The force on a flat master, whose nodes may be free where supports
        hold those of the slave: within the cone, and where all of the contact
        slips to the same side, the shear is mu times the pressure."""
        near = (self.gaps <= self.reach).any(1)
        if self.zone.obstacle or self.model.degree == 2 or (
                not near.any() or not self.is_flat()):
            return []
        master = np.unique(self.lines_of_master())
        if self.state.held[master].any() or self.shared[master].any():
            return []
        step = self.state.u - (before.u if before is not None else 0)
        slip, normals, tangents = self.slip(step)
        judged = np.isin(self.nodes, self.lines[near])
        slip, normals = slip[judged], normals[judged]
        force = -self.state.residual[master].sum(0)
        n, t = normals.mean(0), tangents[judged].mean(0)
        push, shear = abs(force @ n), abs(force @ t)
        if self.model.axisymmetric and abs(n[0]) > 0.1:
            return []
        bound = self.zone.mu * push
        tilt = np.abs(normals - n).max()
        if self.rule == "mortar":
            # Which weights the normals of both sides.
            tilt = max(tilt, np.abs(self.own.normal[near[self.own.line]] +
                                    n).max() / 2)
        allowed = (0.02 * bound + 2 * tilt * push +
                   10 * self.state.error[master].sum() +
                   1e-6 * self.state.scale)
        if shear > bound + allowed + 0.02 * push:
            return [Problem("shear", "%.4g N on the master, mu N = %.4g" % (
                shear, bound))]
        moved = max(np.abs(step).max(), 1e-6 * self.largest)
        slips = (np.abs(slip).min() > SLIPS * moved and
                 np.ptp(np.sign(slip)) == 0)
        if slips and shear < bound - allowed:
            return [Problem("shear", "%.4g N where all slips under mu N = %.4g"
                            % (shear, bound))]
        return []

    def parallel(self, normals):
        """By the nodes: the cosine of the angle between given normals and the
        slave's own ones turned round."""
        own = np.zeros_like(normals)
        for k, n in enumerate(self.nodes):
            pieces = (self.lines == n).any(1)
            own[k] = -self.own.normal[np.isin(self.own.line, np.flatnonzero(
                pieces))].sum(0)
        own /= np.maximum(np.hypot(*own.T), 1e-300)[:, None]
        return np.einsum("ki,ki->k", own, normals)

    def lines_of_master(self):
        return self.model.lines[self.zone.master]
