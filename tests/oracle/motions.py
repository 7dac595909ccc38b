"""Obstacles that move as rigid bodies, by given histories or as far as forces
take them, and surfaces that an interference keeps apart."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import surfaces


def rotation(angle, axis=None):
    """In 2-D, or in 3-D about an axis (Rodrigues)."""
    cos, sin = np.cos(angle), np.sin(angle)
    if axis is None:
        return np.array([[cos, -sin], [sin, cos]])
    x, y, z = n = np.array(axis) / np.linalg.norm(axis)
    return (cos * np.eye(3) + (1 - cos) * np.outer(n, n) + sin * np.array(
        [[0, -z, y], [z, 0, -x], [-y, x, 0]]))


class Placement:
    """Where an obstacle is: its point X is at c + d + R (X - c)."""

    def __init__(self, centre, shift, R):
        self.c, self.d, self.R = np.array(centre), np.array(shift), R

    @property
    def centre(self):
        """Where the point is that it turns about."""
        return self.c + self.d

    def at(self, X):
        return self.c + self.d + (X - self.c) @ self.R.T

    def back(self, x):
        return self.c + (x - self.c - self.d) @ self.R


class MovedObstacle(surfaces.Obstacle):
    def __init__(self, shape, placement):
        self.shape, self.placement = shape, placement

    def gap(self, points):
        return self.shape.gap(self.placement.back(points))

    def normals(self, points):
        return (self.shape.normals(self.placement.back(points)) @
                self.placement.R.T)


class KeptApart:
    """A master whose surface is in truth that much further out."""

    def __init__(self, master, distance):
        self.master, self.distance = master, distance

    def gap(self, points):
        return self.master.gap(points) - self.distance

    def __getattr__(self, name):
        return getattr(self.master, name)


def placement(zone, t, free):
    """By the histories; `free`: the motions that follow from forces, 'x', 'y'
    [mm] and 'angle' [degrees]."""
    found = {name: f(t) for name, f in zone.motion.items()}
    for name in zone.force:
        name = "angle" if name == "moment" else name
        found[name] = free.get(name, 0.0)
    centre = zone.centre
    numbers = [float(v) for v in zone.obstacle.split(": ")[1].split(",")]
    axes = "xyz" if zone.in_space else "xy"
    axis = None
    if zone.in_space:
        # What does not turn has none.
        axis = zone.axis or (numbers[3:6] if zone.obstacle.startswith("cyl")
                             else (0.0, 0.0, 1.0))
    return Placement(numbers[:len(axes)] if centre is None else centre,
                     [found.get(a, 0.0) for a in axes],
                     rotation(np.radians(found.get("angle", 0.0)), axis))


def said(zone, record):
    """What the program says about a zone after an increment."""
    return record.get(("contact " + zone.name).strip(), {})


def placements(scene, t, record):
    """By zone: where its obstacle is."""
    found = {}
    for zone in scene.zones:
        if zone.obstacle:
            values = said(zone, record)
            found[zone.name] = placement(zone, t, {
                "angle": values.get("obstacle_turn", 0.0), **{
                    axis: values.get("obstacle_motion_" + axis, 0.0)
                    for axis in scene.axes}})
    return found


def obstacle_of(zone, state):
    master = surfaces.obstacle(zone.obstacle)
    if zone.motion or zone.force:
        return MovedObstacle(master, state.placements[zone.name])
    return master


def master_of(model, zone, state):
    if zone.obstacle:
        master = obstacle_of(zone, state)
    else:
        master = surfaces.DeformedBody(model, zone, state.x)
    return KeptApart(master, zone.apart(state.t)) if zone.apart else master
