# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the study runs: problems, methods, meshes, and what is expected of them.

A run is a parameter file and the entries that it changes. Runs that differ in
the level only are a sequence: a curve in the pictures.
"""

from __future__ import annotations

from dataclasses import dataclass

ELEMENTS = {
    "linear": {"Element/Degree": "1", "Element/Centre node": "serendipity"},
    "q8": {"Element/Degree": "2", "Element/Centre node": "serendipity"},
    "q9": {"Element/Degree": "2", "Element/Centre node": "free"},
}
RULES = ["nodal", "mortar", "Gauss"]

# Unknowns of the displacements with linear elements on the mesh of the file;
# a refinement makes four times as many, and so do quadratic elements.
COARSE_UNKNOWNS = {
    "rings": 88, "rings_matching": 80, "disk": 66, "hertz": 1510, "hertz_load": 1510,
    "hertz_friction": 1510, "cattaneo_mindlin": 2200, "ssnp154": 374,
    "ssnp154_friction": 374, "knobs": 374, "knobs_friction": 374,
    "knobs_large": 5272,
}
# Unknowns on adaptive meshes with quadratic elements by the number of levels,
# as far as they are known; in between and beyond they grow by a third a level.
ADAPTIVE_UNKNOWNS = {0: 1404, 6: 2160, 10: 5488, 14: 16228, 18: 48146}

MAX_UNKNOWNS = 350_000
MAX_UNKNOWNS_QUICK = 21_000

# The published limits of DY(B) [mm], and how well they are known.
PUBLISHED = {"ssnp154": (-1.27434, 6e-5), "ssnp154_friction": (-1.27016, 6e-5)}

# Orders in the mesh size: displacement in L2, energy norm, pressure in L2.
# Displacement k + 1 and energy k are those of the elements; the pressure is of
# order k with the polygons (degree 1) or parabolas (2) that stand for the circle.
STABLE_ORDERS = {
    "linear": {"displacement": 2, "energy": 1, "pressure": 1},
    "q8": {"displacement": 3, "energy": 2, "pressure": 2},
    "q9": {"displacement": 3, "energy": 2, "pressure": 2},
}
# Where meshes do not match, the nodal rule hands the forces of a slave node to
# the master nodes beside it, which is wrong by a part of itself that oscillates
# with the mesh: order 1/2 in the energy, none in the pressure.
NODAL_ORDERS = {"displacement": None, "energy": 0.5, "pressure": 0}
# Three Gauss points an edge ask for more than the pressure of an edge can give.
GAUSS_ORDERS = {"displacement": None, "energy": None, "pressure": None}


def expected_orders(problem: str, element: str, rule: str) -> dict:
    """What theory says, None where it is silent."""
    if rule == "mortar" or problem == "rings_matching":
        return STABLE_ORDERS[element]
    return NODAL_ORDERS if rule == "nodal" else GAUSS_ORDERS


ORDER_TOLERANCE = 0.15
MORE_IS_FINE = {"pressure"}

# Half width of sticking by that of contact after so many increments, of two
# half planes; and how far a computed one may be away.
STICK_RATIO = {1: 0.153, 2: 0.333, 4: 0.367, 10: 0.387, 50: 0.393}
STICK_TOLERANCE = 0.01
STICK_TOLERANCE_QUICK = 0.02

# Errors that the decision table asks for, relative.
TARGETS = [1e-1, 1e-2, 1e-3, 1e-4]

# Closed forms of the problems, see tests/closed_forms/errors.cc; of Hertz the
# radius, and the force of the full cylinder where the run does not find it.
CLOSED_FORMS = {
    "rings": "concentric cylinders: 20, 50, 100, 100, 20",
    "rings_matching": "concentric cylinders: 20, 50, 100, 100, 20",
    "disk": "concentric cylinders: 0, 50, 100, 100, 20",
    "hertz": "Hertz: 50, 350",
    "hertz_friction": "Hertz with friction: 50, 21.875",
    "cattaneo_mindlin": "Hertz with friction: 25",
}

# Combinations that are not run, and the reason.
LEFT_OUT = [
    ("Gauss rule, condensed system", "its points share the multipliers of the "
     "nodes: a point cannot be eliminated as a constraint of its own"),
    ("Gauss rule, several levels or adaptive refinement", "both use the "
     "condensed system; Mesh/Refinements refines beforehand instead"),
    ("mortar rule, Friction = Newton", "the tangent does not know how segments "
     "move, and the condensed system has no such tangent"),
    ("Friction = Newton, condensed system", "the matrix would lose its "
     "symmetry: each step or fixed point instead"),
    ("AMG or CHOLMOD, saddle point system", "it is not positive definite: "
     "UMFPACK only"),
    ("Gauss rule, cattaneo_mindlin", "the case asks how shear and pressure "
     "follow theory in the nodes; the Gauss rule decides in its points"),
    ("rings with the slave on the coarser side", "the nodal rule needs the "
     "finer one as slave, and all rules get the same problem"),
    ("several processes", "the study is about accuracy; what processes gain is "
     "in the table of the costs"),
]


@dataclass(frozen=True)
class Run:
    """One call of the program, and the columns that describe it."""

    problem: str
    file: str  # below the directory of the parameters
    element: str
    rule: str
    refinement: str = "uniform"  # uniform, nested, adaptive
    level: int = 0
    system: str = ""  # condensed, saddle point; empty: automatic
    solver: str = ""  # empty: automatic
    friction: str = ""  # how its bound is found
    increments: int = 0  # 0: those of the file
    knob: str = ""
    setting: str = ""
    role: str = ""  # reference, check, bound; empty: part of a sequence
    extra: tuple = ()  # further entries and their values

    @property
    def id(self) -> str:
        """A name that is a file name, too."""
        parts = [self.problem, self.role, self.element, self.rule,
                 self.refinement, self.system, self.solver, self.friction,
                 f"inc{self.increments}" if self.increments else "",
                 self.knob, self.setting, f"L{self.level}"]
        return "-".join(p for p in parts if p).replace(" ", "_")

    @property
    def closed_form(self) -> str:
        """What it is compared with; empty: nothing."""
        if self.problem == "hertz_load":
            return f"Hertz: 50, {350 * int(self.setting)}"
        return CLOSED_FORMS.get(self.problem, "")

    def entries(self) -> dict[str, str]:
        """The parameters that differ from those of the file."""
        entries = dict(ELEMENTS[self.element])
        entries["Contact/Discretization"] = self.rule
        if self.refinement == "uniform":
            entries["Mesh/Refinements"] = str(self.level)
            entries["Refinement/Levels"] = "0"
        else:
            entries["Refinement/Levels"] = str(self.level)
        if self.refinement == "adaptive":
            entries["Refinement/Strategy"] = "adaptive"
        for name, value in [("System", self.system),
                            ("Linear solver", self.solver),
                            ("Friction", self.friction),
                            ("Increments", str(self.increments or ""))]:
            if value:
                entries[f"Solution/{name}"] = value
        entries.update(self.extra)
        return entries

    def prior_unknowns(self) -> float:
        """About how many unknowns it will have."""
        factor = 1 if self.element == "linear" else 4
        if self.refinement == "adaptive":
            known = max(n for n in ADAPTIVE_UNKNOWNS if n <= self.level)
            return ADAPTIVE_UNKNOWNS[known] * 1.31 ** (self.level - known)
        return COARSE_UNKNOWNS[self.problem] * factor * 4 ** self.level

    def prior_seconds(self) -> float:
        """About what it will cost, before anything has been measured."""
        per_unknown = 1.5e-5 if self.refinement == "nested" else 2.5e-5
        if self.rule != "mortar" and self.refinement == "uniform":
            per_unknown = 6e-5
        increments = self.increments or (2 if "fric" in self.problem else 1)
        return 0.6 + self.prior_unknowns() * per_unknown * increments


def levels(problem: str, element: str, last: int, quick: bool,
           first: int = 0) -> range:
    """Levels up to the last one that stays below the limit of unknowns."""
    limit = MAX_UNKNOWNS_QUICK if quick else MAX_UNKNOWNS
    unknowns = COARSE_UNKNOWNS[problem] * (1 if element == "linear" else 4)
    while last > first and unknowns * 4 ** last > limit:
        last -= 1
    return range(first, last + 1)


def concentric(problem: str, file: str, quick: bool) -> list[Run]:
    """Rings, or a disk in a ring: orders of convergence."""
    runs = []
    for element in ["linear", "q9"] if quick else ELEMENTS:
        last = 5 if quick or element != "linear" else 6
        first = last - 3 if quick else 1
        if quick and element != "linear":
            first, last = 1, 4
        for rule in ["nodal", "mortar"] if quick else RULES:
            runs += [Run(problem, file, element, rule, level=level)
                     for level in range(first, last + 1)]
    return runs


def matching_rings() -> list[Run]:
    """Where meshes match, the nodal rule is as good as the mortar rule."""
    return [Run("rings_matching", "verification/rings_matching.prm", element,
                rule, level=level)
            for element in ELEMENTS for rule in ["nodal", "mortar"]
            for level in range(1, 6)]


def hertz() -> list[Run]:
    runs = [Run("hertz", "verification/hertz.prm", element, rule, level=level)
            for element in ELEMENTS for rule in RULES
            for level in levels("hertz", element, 4, False)]
    for load in [1, 4, 16]:
        extra = (("Boundary conditions/Force y", f"Force: {-175 * load}"),)
        runs.append(Run("hertz_load", "verification/hertz.prm", "q9", "mortar",
                        level=3, knob="load", setting=str(load), extra=extra))
    return runs


def hertz_friction(quick: bool) -> list[Run]:
    """The end of sticking lies between two nodes: it takes many of them."""
    return [Run("hertz_friction", "verification/hertz_friction.prm", "q9",
                "mortar", "adaptive", level, increments=increments)
            for level in ([10] if quick else [10, 12])
            for increments in ([1, 4] if quick else STICK_RATIO)]


def cattaneo_mindlin() -> list[Run]:
    return [Run("cattaneo_mindlin", "verification/cattaneo_mindlin.prm",
                element, rule, level=level, system="condensed")
            for element in ELEMENTS for rule in ["nodal", "mortar"]
            for level in levels("cattaneo_mindlin", element, 3, False)]


# Geometry and friction of the references are converged further than anybody
# needs, so that what is compared with is the limit of the discretization only.
TIGHT = (("Solution/Geometry tolerance", "1e-6"),
         ("Solution/Newton tolerance", "1e-10"))


def references(problem: str, file: str, quick: bool) -> list[Run]:
    """The overkill run, and others to see how far it is to be trusted.

    Those with the role 'check' are as good: one with other elements, one with
    another sequence of meshes. The finest uniform mesh is not, but it is refined
    at the nodal force as well, where the adaptive ones are left coarse.
    """
    finest, other = (16, 9) if quick else (24, 16)

    def adaptive(role, element, level, fraction):
        return Run(problem, file, element, "mortar", "adaptive", level,
                   knob="fraction", setting=fraction, role=role,
                   extra=TIGHT + (("Refinement/Fraction", fraction),))

    runs = [adaptive("reference", "q9", finest, "0.5"),
            adaptive("check", "q8", finest, "0.5"),
            adaptive("check", "q9", other, "0.7")]
    if not quick:
        runs.append(Run(problem, file, "q9", "mortar", "nested", 5,
                        role="bound", extra=TIGHT))
    return runs


def ssnp154(quick: bool) -> list[Run]:
    problem, file = "ssnp154", "nested.prm"
    runs = references(problem, file, quick)
    for element in ["linear", "q9"] if quick else ELEMENTS:
        last = 5 if element == "linear" else 4
        for rule in ["mortar"] if quick else ["nodal", "mortar"]:
            for solver in ["CHOLMOD"] if quick else ["CHOLMOD", "AMG"]:
                runs += [Run(problem, file, element, rule, "nested", level,
                             "condensed", solver)
                         for level in levels(problem, element, last, quick)]
            if not (quick and element == "linear"):
                runs += [Run(problem, file, element, rule, "adaptive", level,
                             "condensed")
                         for level in range(2, 15 if quick or element == "linear"
                                            else 21, 2)]
        for rule in [] if quick else ["nodal", "Gauss"]:
            runs += [Run(problem, file, element, rule, "uniform", level,
                         "saddle point")
                     for level in levels(problem, element, 4, quick)]
    return runs


def ssnp154_friction() -> list[Run]:
    problem, file = "ssnp154_friction", "nested_friction.prm"
    runs = references(problem, file, False)
    for element in ELEMENTS:
        last = 4 if element == "linear" else 3
        for rule in ["nodal", "mortar"]:
            runs += [Run(problem, file, element, rule, "nested", level,
                         "condensed", "", friction)
                     for friction in ["Newton", "fixed point"]
                     for level in levels(problem, element, last, False)]
        runs += [Run(problem, file, element, "mortar", "adaptive", level,
                     "condensed", "", "Newton")
                 for level in range(2, 15 if element == "linear" else 18, 3)]
        runs += [Run(problem, file, element, rule, "uniform", level,
                     "saddle point", "", friction)
                 for rule in ["nodal", "Gauss"]
                 for friction in ["fixed point", "Newton"]
                 for level in levels(problem, element, last - 1, False)]
    return runs


def powers(first: int, last: int, step: int = 1) -> list[str]:
    """1e-first, ... 1e-last as text, the tightest last."""
    return [f"1e-{n}" for n in range(first, last + 1, step)]


KNOBS = {
    "Newton tolerance": powers(2, 12, 2),
    "Geometry tolerance": powers(1, 8),
    "Friction tolerance": powers(1, 12),
    "Increments": ["1", "2", "4", "8", "16"],
    "Linear tolerance": powers(1, 8),
}


def knobs() -> list[Run]:
    """One knob at a time, the others as in the file."""
    cases = [("knobs", "nested.prm", "q9", "mortar", "nested", 2),
             ("knobs_friction", "nested_friction.prm", "q9", "mortar",
              "nested", 2),
             ("knobs_large", "ssnp154_d.prm", "q8", "nodal", "uniform", 0)]
    runs = []
    for problem, file, element, rule, refinement, level in cases:
        def add(knob, setting, at=level, extra=(), **columns):
            runs.append(Run(problem, file, element, rule, refinement, at,
                            knob=knob, setting=setting, extra=extra, **columns))

        for knob, settings in KNOBS.items():
            columns = {}
            if knob == "Friction tolerance":
                if problem == "knobs":
                    continue
                columns["friction"] = "fixed point"
            if knob == "Linear tolerance":
                if problem == "knobs_large":
                    continue
                columns["solver"] = "AMG"
            for setting in settings:
                if knob == "Increments":
                    add(knob, setting, increments=int(setting))
                else:
                    add(knob, setting,
                        extra=((f"Solution/{knob}", setting),), **columns)
        # The error of the mesh, to compare the knobs with.
        add("mesh", "as it is")
        add("mesh", "refined once", level + 1)
    return runs


def all_runs(quick: bool = False) -> list[Run]:
    """Everything, the references first."""
    runs = concentric("rings", "verification/rings.prm", quick)
    if quick:
        runs = ssnp154(True) + runs + hertz_friction(True)
    else:
        runs = (ssnp154(False) + ssnp154_friction() + runs +
                matching_rings() +
                concentric("disk", "verification/disk_in_ring.prm", False) +
                hertz() + hertz_friction(False) + cattaneo_mindlin() + knobs())
    runs.sort(key=lambda run: run.role == "")
    return runs


def problems(quick: bool = False) -> list[str]:
    return list(dict.fromkeys(run.problem for run in all_runs(quick)))
