"""A scene: mesh, materials, supports, loads, contact, and its files."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import copy

import numpy as np

from grids import Mesh


class Formula:
    """The same function as text for the program and as code for the oracle."""

    def __init__(self, text, function):
        self.text = text
        self.function = function

    def __call__(self, *arguments):
        return self.function(*arguments)


RAMP_THEN_HOLD = Formula("min(1, 2*t)", lambda t: min(1.0, 2 * t))
HOLD_THEN_RAMP = Formula("max(0, 2*t - 1)", lambda t: max(0.0, 2 * t - 1))
THERE_AND_BACK = Formula("table(0 0, 0.5 1, 1 0)",
                         lambda t: 2 * t if t < 0.5 else 2 - 2 * t)
AT_ONCE = Formula("1", lambda t: 1.0)
RAMP = Formula("t", lambda t: t)
# As a formula that may have a factor before it.
TENT = Formula("1 - abs(2*t - 1)", lambda t: 1 - abs(2 * t - 1))


def scaled(factor, formula):
    return Formula("%.12g*(%s)" % (factor, formula.text),
                   lambda t: factor * formula(t))


def number(value):
    if isinstance(value, str):
        return value
    return value.text if isinstance(value, Formula) else "%.12g" % value


class Zone:
    """All histories are formulas in t: `motion` and `force` of an obstacle by
    'x', 'y' and 'angle' [degrees], 'moment'; `apart` is the interference."""

    def __init__(self, slave, master=None, mu=0.0, name="", rule=None,
                 obstacle=None, tied=False, motion=None, force=None,
                 centre=None, axis=None, apart=None, preload=None,
                 preload_end=1.0):
        self.slave = slave
        self.master = master
        self.mu = mu
        self.name = name
        self.rule = rule
        # 'half plane: x, y, nx, ny' or 'circle: x, y, radius'
        self.obstacle = obstacle
        self.tied = tied
        self.motion = motion or {}
        self.force = force or {}
        # None: the point that the obstacle begins with.
        self.centre = centre
        # In 3-D; None: that of a cylinder.
        self.axis = axis
        self.apart = apart
        self.preload = preload
        self.preload_end = preload_end

    @property
    def in_space(self):
        """Of an obstacle."""
        return self.obstacle.startswith(("half space", "sphere", "cylinder"))

    @property
    def section(self):
        return ("Contact " + self.name).strip()

    def motion_entries(self):
        """Of an obstacle that moves, a cut, an interference."""
        entries = {}
        if self.motion:
            entries["Obstacle motion"] = listing(self.motion, "; ")
        forces = {k: f for k, f in self.force.items() if k != "moment"}
        if forces:
            entries["Obstacle force"] = listing(forces, "; ")
        if "moment" in self.force:
            entries["Obstacle moment"] = self.force["moment"].text
        if self.centre is not None:
            entries["Obstacle centre"] = ", ".join(map(number, self.centre))
        if self.axis is not None:
            entries["Obstacle axis"] = ", ".join(map(number, self.axis))
        if self.apart:
            entries["Interference"] = self.apart.text
        if self.preload:
            entries["Preload"] = self.preload.text
            if self.preload_end < 1:
                entries["Preload end"] = number(self.preload_end)
        return entries

    def mirror(self, axis):
        """In x or y, where all turns change their sense."""
        flipped = ("xy"[axis], "angle", "moment")
        for items in (self.motion, self.force):
            for name in set(flipped) & set(items):
                items[name] = scaled(-1, items[name])
        if self.centre is not None:
            self.centre = tuple(-c if d == axis else c
                                for d, c in enumerate(self.centre))


def listing(items, separator=", "):
    return separator.join("%s: %s" % (name, number(value))
                          for name, value in items.items())


# The ends that a scene may have.
SOLVED = "solved"  # results
REFUSED = "refused"  # exit status 2
HOPELESS = "hopeless"  # exit status 2 or 3: there is no solution
EITHER = "either"  # results, or exit status 2 or 3


class Scene:
    axes = "xy"
    mesh_of = Mesh

    def __init__(self, kind, seed, bodies, materials, rule="mortar",
                 arcs=None):
        self.kind = kind
        self.seed = seed
        self.name = "%s_%d" % (kind, seed)
        self.mesh = self.mesh_of(bodies, arcs)
        self.materials = materials
        self.rule = rule
        # By body: a law of materials.py, a free strain by the time, a kinematics
        # other than that of the scene.
        self.laws = {}
        self.thermal = {}
        self.kinematics = {}
        # Boundaries that move as rigid bodies, and their points.
        self.rigid = {}
        self.boundary = {}
        self.histories = {}
        self.zones = []
        self.entries = {}
        # Whether groups go round edges on both sides (sides_check.py); how far the
        # bodies would overlap without contact [mm], None if nobody knows.
        self.round_edges = False
        self.approach = None
        self.expected = SOLVED
        # Whether all loops, rules and systems are left to the program.
        self.is_default = True

    @property
    def degree(self):
        return int(self.entries.get("Element/Degree", 1))

    @property
    def axisymmetric(self):
        return self.entries.get("Solids/Symmetry") == "axisymmetric"

    @property
    def large(self):
        """Whether a body is."""
        return any(map(self.is_large, self.materials))

    def is_large(self, body):
        return self.kinematics.get(body, self.entries.get(
            "Solids/Kinematics")) != "small strain"

    @property
    def undeformed(self):
        return self.entries.get("Solution/Geometry") == "undeformed"

    @property
    def size(self):
        return float(np.ptp(self.mesh.X, axis=0).max())

    def material(self, body):
        return self.materials[body]

    def rule_of(self, zone):
        return zone.rule or self.rule

    def factor(self, entry, t):
        return self.histories[entry](t) if entry in self.histories else t

    def hold(self, groups, *values):
        """Prescribe the displacements of boundaries or points; None: not."""
        for name in groups.split():
            for axis, value in zip(self.axes, values):
                if value is not None:
                    self.boundary.setdefault("Displacement " + axis,
                                             {})[name] = value
        return self

    def load(self, entry, name, value):
        self.boundary.setdefault(entry, {})[name] = value
        return self

    def make_rigid(self, group, point):
        self.rigid[group] = point
        return self.load("Rigid", group, point)

    def contact(self, *arguments, **keywords):
        self.zones.append(Zone(*arguments, **keywords))
        return self

    def prescribed(self):
        """The largest displacement of a support or an obstacle."""
        return max([abs(v) for entry, items in self.boundary.items()
                    if entry.startswith("Displacement")
                    for v in items.values()] +
                   [abs(f(k / 20)) for zone in self.zones
                    for name, f in zone.motion.items() if name != "angle"
                    for k in range(21)] + [0.0])

    def parameters(self):
        sections = {"Mesh": {"File": "mesh.msh"}, "Solids": {
            "Young's modulus": listing({k: v[0] for k, v in
                                        self.materials.items()}),
            "Poisson's ratio": listing({k: v[1] for k, v in
                                        self.materials.items()}),
            **self.law_entries()}}
        sections["Mesh"].update(self.round_entries())
        conditions = sections["Boundary conditions"] = {
            entry: listing(items, "; " if entry.split()[0] in (
                "Pressure", "Traction", "Body") else ", ")
            for entry, items in self.boundary.items()}
        if self.histories:
            conditions["Histories"] = "; ".join(
                "%s: %s" % (entry, f.text)
                for entry, f in self.histories.items())
        for zone in self.zones:
            sections[zone.section] = self.entries_of(zone)
        for entry, value in self.entries.items():
            section, name = entry.split("/", 1)
            sections.setdefault(section, {})[name] = value
        probed = range(len(self.mesh.X) if self.is_probed else 0)
        sections["Probes"] = {"Probes": "; ".join(
            "%s%d: displacement %s, n%d" % (d, k, d, k)
            for k in probed for d in self.axes)}
        sections["Output"] = dict(Screen="none", Profile="true", **self.files())
        return "".join("subsection %s\n%send\n" % (name, "".join(
            "  set %s = %s\n" % item for item in section.items()))
            for name, section in sections.items())

    # The file that the middles of edges are in: VTU in single precision, or
    # Nodes.
    middles_in = "VTU"

    # Whether the displacements of all vertices are in the summary.
    is_probed = True

    def files(self):
        """Of degree 2 the middles of edges are in a file."""
        return {self.middles_in: "true" if self.degree == 2 else "false"}

    def round_entries(self):
        if not self.mesh.arcs:
            return {}
        return {"Arcs": "; ".join("%s: %s" % (name, ", ".join(map(number, arc)))
                                  for name, arc in self.mesh.arcs.items())}

    def entries_of(self, zone):
        entries = {"Slave": zone.slave}
        if zone.obstacle:
            entries["Obstacle"] = zone.obstacle
        else:
            entries["Master"] = zone.master
        entries["Discretization"] = self.rule_of(zone)
        entries["Friction coefficient"] = number(zone.mu)
        if zone.tied:
            entries["Tied"] = "true"
        entries.update(zone.motion_entries())
        return entries

    def law_entries(self):
        """The materials that are not linear elastic, and free strains."""
        found = {}
        for body, law in self.laws.items():
            for entry, value in law.entries().items():
                found.setdefault(entry, {})[body] = value
        entries = {entry: listing(items, "; " if entry == "Hardening curve"
                                  else ", ") for entry, items in found.items()}
        if self.thermal:
            entries["Thermal strain"] = listing(self.thermal, "; ")
        if self.kinematics:
            entries["Kinematics"] = listing({
                body: "large displacement" if self.is_large(body) else
                "small strain" for body in self.materials})
        return entries

    def write(self, directory):
        directory.mkdir(parents=True, exist_ok=True)
        (directory / "mesh.msh").write_text(self.mesh.text())
        (directory / "case.prm").write_text(self.parameters())

    # The same scene in other words.
    def varied(self, mesh):
        other = copy.deepcopy(self)
        other.mesh = mesh
        return other

    def mirrored(self):
        """In x; rings in y."""
        axis = 1 if self.axisymmetric else 0
        if any(isinstance(v, Formula) for items in self.boundary.values()
               for v in items.values()):
            return None
        other = self.varied(self.mesh.mirrored(axis))
        for entry, items in other.boundary.items():
            if entry.endswith((" " + "xy"[axis], " z")):
                for name in items:
                    items[name] = -items[name]
        for zone in other.zones:
            zone.mirror(axis)
            if zone.obstacle:
                kind, numbers = zone.obstacle.split(": ")
                values = [float(v) for v in numbers.split(",")]
                for k in range(axis, len(values) - (kind == "circle"), 2):
                    values[k] *= -1
                zone.obstacle = kind + ": " + ", ".join(map(number, values))
        return other

    def renumbered(self, rng):
        return self.varied(self.mesh.renumbered(rng))

    def reordered(self):
        """The bodies in the opposite order."""
        other = self.varied(copy.copy(self.mesh))
        other.mesh.bodies = self.mesh.bodies[::-1]
        return other
