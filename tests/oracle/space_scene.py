"""A scene in 3-D: turned as a whole, with round surfaces and obstacles."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

from scene import Formula, Scene, number, scaled
from space_grids import SpaceMesh


# A third of a turn about (1, 1, 1): x becomes y, y becomes z.
THIRD = np.array([[0.0, 0, 1], [1, 0, 0], [0, 1, 0]])


class SpaceScene(Scene):
    axes = "xyz"
    mesh_of = SpaceMesh

    @property
    def serendipity(self):
        return self.entries.get("Element/Centre node") != "free"

    @property
    def levels(self):
        return int(self.entries.get("Refinement/Levels", 0))

    @property
    def is_probed(self):
        return self.degree == 1 and self.levels == 0

    def files(self):
        return {"Nodes": "true"}

    def round_entries(self):
        entries = {}
        for name, (entry, numbers) in self.mesh.arcs.items():
            entries.setdefault(entry, []).append(
                "%s: %s" % (name, ", ".join(map(number, numbers))))
        return {entry: "; ".join(texts) for entry, texts in entries.items()}

    def judged(self):
        """The scene with the mesh that the results are of."""
        other = self
        for _ in range(self.levels):
            other = other.varied(other.mesh.refined())
        return other

    # Turned by a rotation R about the origin.
    def turned(self, R):
        """None if there are supports or loads that this would make oblique."""
        R = np.array(R, float)
        other = self.varied(SpaceMesh([]))
        other.mesh.__dict__.update(self.mesh.__dict__)
        other.mesh.X = self.mesh.X @ R.T
        other.mesh.arcs = {name: (entry, turned_numbers(entry, numbers, R))
                           for name, (entry, numbers) in self.mesh.arcs.items()}
        for zone in other.zones:
            if zone.obstacle:
                kind, text = zone.obstacle.split(": ")
                numbers = [float(v) for v in text.split(",")]
                zone.obstacle = kind + ": " + ", ".join(map(number,
                    turned_numbers(kind, numbers, R)))
            self.turn_motion(zone, R)
        square = np.abs(np.abs(R) - np.round(np.abs(R))).max() < 1e-12
        pushed = any(zone.force for zone in self.zones)
        if not square and (self.histories or self.has_formulas() or pushed):
            return None
        if self.has_formulas():
            return None
        other.boundary, other.histories = {}, {}
        for entry, items in self.boundary.items():
            kind, axis = entry.rsplit(" ", 1) if entry[-2] == " " else (
                entry, None)
            if axis is None:
                other.boundary[entry] = dict(items)
                continue
            for name, value in items.items():
                if not self.turn_value(other, kind, axis, name, value, R,
                                       square):
                    return None
        for entry, formula in self.histories.items():
            if entry[-2] != " ":
                other.histories[entry] = formula
                continue
            to = np.abs(R[:, self.axes.index(entry[-1])]).argmax()
            other.histories[entry[:-1] + self.axes[to]] = formula
        return other

    def turn_motion(self, zone, R):
        """Of an obstacle: its formulas in each direction are sums of those of
        before."""
        for items in (zone.motion, zone.force):
            before = [(d, items.pop(axis)) for d, axis in enumerate(self.axes)
                      if axis in items]
            for k, axis in enumerate(self.axes):
                parts = [scaled(R[k, d], formula) for d, formula in before
                         if abs(R[k, d]) > 1e-12]
                if parts:
                    items[axis] = summed(parts)
        if zone.centre is not None:
            zone.centre = tuple(map(float, R @ np.array(zone.centre)))
        if zone.axis is not None:
            zone.axis = tuple(map(float, R @ np.array(zone.axis)))

    def turn_value(self, other, kind, axis, name, value, R, square):
        d = self.axes.index(axis)
        if not square and kind == "Displacement" and any(
                name not in self.boundary.get("Displacement " + a, {})
                for a in self.axes):
            return False
        for k, a in enumerate(self.axes):
            if square and abs(R[k, d]) < 0.5:
                continue
            factor = float(np.round(R[k, d])) if square else R[k, d]
            items = other.boundary.setdefault("%s %s" % (kind, a), {})
            items[name] = items.get(name, 0.0) + factor * value
        return True

    def has_formulas(self):
        return any(isinstance(v, Formula) for items in self.boundary.values()
                   for v in items.values())

    def mirrored(self):
        return None


def turned_numbers(kind, numbers, R):
    """Points and directions turned; what is left, a radius, stays."""
    n = len(numbers) // 3 * 3
    vectors = np.array(numbers[:n]).reshape(-1, 3) @ R.T
    return [float(v) for v in vectors.ravel()] + list(numbers[n:])


def summed(formulas):
    return Formula(" + ".join("(%s)" % f.text for f in formulas),
                   lambda t: sum(f(t) for f in formulas))


def rotation(rng):
    """Any rotation (a random quaternion)."""
    q = np.array([rng.gauss(0, 1) for _ in range(4)])
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
