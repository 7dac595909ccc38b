"""Obstacles that move as rigid bodies, by given histories or as far as forces
take them, and surfaces that an interference keeps apart."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import surfaces


class Placement:
    """Where an obstacle is: its point X is at c + d + R (X - c)."""

    def __init__(self, centre, shift=(0.0, 0.0), angle=0.0):
        self.c, self.d, self.angle = np.array(centre), np.array(shift), angle
        cos, sin = np.cos(angle), np.sin(angle)
        self.R = np.array([[cos, -sin], [sin, cos]])

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
    if centre is None:
        centre = [float(v) for v in zone.obstacle.split(": ")[1].split(",")][:2]
    return Placement(centre, (found.get("x", 0.0), found.get("y", 0.0)),
                     np.radians(found.get("angle", 0.0)))


def said(zone, record):
    """What the program says about a zone after an increment."""
    return record.get(("contact " + zone.name).strip(), {})


def placements(scene, t, record):
    """By zone: where its obstacle is."""
    found = {}
    for zone in scene.zones:
        if zone.obstacle and len(scene.axes) == 2:
            values = said(zone, record)
            found[zone.name] = placement(zone, t, {
                "x": values.get("obstacle_motion_x", 0.0),
                "y": values.get("obstacle_motion_y", 0.0),
                "angle": values.get("obstacle_turn", 0.0)})
    return found


def master_of(model, zone, state):
    if zone.obstacle:
        master = surfaces.obstacle(zone.obstacle)
        if zone.motion or zone.force:
            master = MovedObstacle(master, state.placements[zone.name])
    else:
        master = surfaces.DeformedBody(model, zone, state.x)
    return KeptApart(master, zone.apart(state.t)) if zone.apart else master
