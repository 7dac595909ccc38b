"""Boundaries that move as rigid bodies: how they move, and what acts on them."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

from zone_check import Problem

# Of the size of the scene: how far a node may be from the rigid motion.
RIGID = 1e-9
# Of the sum of all forces (times the largest arm): resultants on them.
RESULTANT = 1e-6


def cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


class RigidMotion:
    """The motion of a boundary about its point that fits its nodes best: the
    displacement of the point, the turn [rad]."""

    def __init__(self, model, state, name, point):
        self.nodes = model.nodes_of(name)
        self.large = any(model.scene.is_large(model.scene.mesh.bodies[b])
                         for b in np.unique(model.body_of[self.nodes]))
        P = model.nodes_of(point)[0]
        drawn = model.X[self.nodes] - model.X[P]
        self.shift = state.u[P]
        moved = state.u[self.nodes] - self.shift
        if self.large:
            self.arm = drawn + moved
            self.turn = np.arctan2(cross(drawn, self.arm).sum(),
                                   (drawn * self.arm).sum())
            cos, sin = np.cos(self.turn), np.sin(self.turn)
        else:
            self.arm = drawn
            self.turn = cross(drawn, moved).sum() / (drawn * drawn).sum()
            cos, sin = 1.0, self.turn
        fit = drawn @ np.array([[cos, sin], [-sin, cos]]) - drawn
        self.off = np.hypot(*(moved - fit).T)
        self.drawn = drawn


def problems(scene, model, state):
    found = []
    for name, point in scene.rigid.items():
        motion = RigidMotion(model, state, name, point)
        found += check_motion(scene, model, state, name, motion)
        found += check_resultant(scene, model, state, name, motion)
    return found


def given(scene, entry, name, t):
    """What an entry gives a boundary; None: nothing."""
    value = scene.boundary.get(entry, {}).get(name)
    return None if value is None else value * scene.factor(entry, t)


def check_motion(scene, model, state, name, motion):
    size = scene.size
    found = []
    over = motion.off - 3 * state.position_error[motion.nodes]
    if over.max() > RIGID * size:
        found.append(Problem("rigid", "a node of %s is %.3g mm off" % (
            name, motion.off.max())))
    shift = motion.shift
    if model.axisymmetric:
        shift = np.array([0.0, shift[1]])
        if max(np.abs(state.u[motion.nodes, 0]).max(),
               abs(motion.turn) * size) > RIGID * size:
            found.append(Problem("rigid", "%s of rings widens or turns" % name))
    for d, axis in enumerate(scene.axes):
        value = given(scene, "Displacement " + axis, name, state.t)
        if value is not None and abs(shift[d] - value) > RIGID * size:
            found.append(Problem("rigid", "%s goes %.8g mm in %s instead of "
                                 "%.8g" % (name, shift[d], axis, value)))
    value = given(scene, "Rotation z", name, state.t)
    if value is not None:
        off = (motion.turn - value + np.pi) % (2 * np.pi) - np.pi
        if abs(off) > 10 * RIGID:
            found.append(Problem("rigid", "%s turns by %.8g instead of %.8g" % (
                name, motion.turn, value)))
    return found


def check_resultant(scene, model, state, name, motion):
    """What the body exerts on the boundary is what is given, along the motions
    that are free."""
    force = state.residual[motion.nodes]
    error = 3 * state.error[motion.nodes].sum(0)
    reach = np.abs(motion.arm).max()
    found = []
    for d, axis in enumerate(scene.axes):
        if "Displacement " + axis in scene.boundary and name in (
                scene.boundary["Displacement " + axis]) or (
                    model.axisymmetric and d == 0):
            continue
        wanted = given(scene, "Force " + axis, name, state.t) or 0.0
        if abs(force[:, d].sum() - wanted) > RESULTANT * state.scale + error[d]:
            found.append(Problem("rigid", "%.8g N in %s on %s instead of %.8g" %
                                 (force[:, d].sum(), axis, name, wanted)))
    if model.axisymmetric or given(scene, "Rotation z", name,
                                   state.t) is not None:
        return found
    wanted = given(scene, "Moment z", name, state.t) or 0.0
    moment = cross(motion.arm, force).sum()
    if abs(moment - wanted) > reach * (RESULTANT * state.scale + error.sum()):
        found.append(Problem("rigid", "%.8g N mm on %s instead of %.8g" % (
            moment, name, wanted)))
    return found
