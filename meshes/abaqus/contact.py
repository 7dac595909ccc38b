# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact pairs, ties, friction, and rigid surfaces as obstacles."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from .deck import Block, Row
from .parts import Scope
from .steps import Load, as_table, text

if TYPE_CHECKING:
    from .case import Case

Place = tuple[float, float]


@dataclass
class Obstacle:
    """An analytical rigid surface, and what moves its reference node."""
    block: Block
    scope: Scope
    node: int | None = None
    motions: dict[int, Load] = field(default_factory=dict)  # by degree of freedom
    forces: dict[int, Load] = field(default_factory=dict)

    def segments(self) -> list[tuple[Place, Place, Place | None]]:
        """Start, end and, of an arc, centre."""
        found, here = [], None

        def place(row: Row, i: int) -> Place:
            point = [row.number(i), row.number(i + 1), 0.0]
            x, y, _ = self.scope.move.place(point) if self.scope.move else point
            return x, y

        for row in self.block.rows:
            word, there = row.text(0).upper(), place(row, 1)
            if word not in ("START", "LINE", "CIRCL") or \
                    (word == "START") != (here is None):
                row.fault(f"'{row.text(0)}' is no part of a rigid surface that is "
                          "read", "begin with START, x, y; go on with LINE, x, y "
                          "or CIRCL, x, y, centre x, centre y")
            if here is not None:
                found.append((here, there,
                              place(row, 3) if word == "CIRCL" else None))
            here = there
        if not found:
            self.block.fault("a rigid surface needs a line", "write START, x, y, "
                             "then LINE, x, y")
        return found

    def shape(self, slave: list[Place]) -> str:
        """The obstacle on the side of the segments where the slave is not. Throws
        NotAnObstacle."""
        if self.block.options["TYPE"].upper() != "SEGMENTS":
            raise NotAnObstacle("only rigid surfaces of TYPE=SEGMENTS are "
                                "obstacles: give Contact/Obstacle")
        parts = self.segments()
        if sum(side(parts, point) for point in slave) > 0:
            parts = [(b, a, c) for a, b, c in reversed(parts)]
        (a, b, centre) = parts[0]
        if len(parts) == 1 and not centre:
            length = math.dist(a, b)
            return "half plane: " + join(*a, (b[1] - a[1]) / length,
                                         (a[0] - b[0]) / length)
        if centre and all(c == centre for _, _, c in parts):
            return "circle: " + join(*centre, math.copysign(
                math.dist(a, centre), cross(a, b, centre)))
        return "profile: " + join(*self.corners(parts))

    def corners(self, parts) -> list[float]:
        """Corners and their radii: an arc rounds the corner of its tangents."""
        points: list[tuple[float, float, float]] = [(*parts[0][0], 0.0)]
        for a, b, c in parts:
            if c:
                points.append(corner_of_arc(a, b, c))
            points.append((*b, 0.0))
        fillet = float(self.block.options.get("FILLETRADIUS", 0) or 0)
        found = points[:1]
        for here, after in zip(points[1:], points[2:]):
            before = found[-1]
            bend = cross(before, here, after) / (
                math.dist(before[:2], here[:2]) * math.dist(here[:2], after[:2]))
            if here[2] == 0 and abs(bend) < 1e-6:
                continue
            if not (here[2] or fillet):
                raise NotAnObstacle(f"the corner at ({here[0]:g}, {here[1]:g}) is "
                                    "not round: give FILLET RADIUS")
            found.append((*here[:2], here[2] or fillet))
        return [number for point in (*found, points[-1]) for number in point]

    def entries(self, case: Case, section: str) -> None:
        is_ring = case.deck.cells[0].code.startswith("CAX")
        names = {2: "y"} if is_ring else {1: "x", 2: "y", 6: "angle"}
        for dof, name in names.items():
            load = self.motions.get(dof) or self.forces.get(dof)
            if load is None:
                case.leave(self.block, f"the motion {name} of the reference node, "
                           "which is free: here there is none")
                continue
            is_motion = dof in self.motions
            scale = math.degrees(1) if dof == 6 and is_motion else 1
            corners = [(t, v * scale) for t, v in load.table(case.n_steps)]
            value = (f"{text(corners[-1][1])}*t" if len(corners) == 2 and
                     corners[0][1] == 0 else as_table(corners))
            if not any(v for _, v in corners):
                continue
            if dof == 6 and not is_motion:
                case.put(section, "Obstacle moment", value)
            else:
                case.put(section, "Obstacle motion" if is_motion
                         else "Obstacle force", f"{name}: {value}")
        if self.node is not None and (self.motions or self.forces):
            case.put(section, "Obstacle centre",
                     join(*case.deck.points[self.node][:2]))


class NotAnObstacle(Exception):
    """Why a rigid surface is none."""


def join(*numbers: float) -> str:
    return ", ".join(text(x) for x in numbers)


def cross(a, b, p) -> float:
    """Twice the area of a b p: positive if p is on the left of a b."""
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def corner_of_arc(a: Place, b: Place, c: Place) -> tuple[float, float, float]:
    radius, mid = math.dist(a, c), [(x + y) / 2 for x, y in zip(a, b)]
    rise = math.dist(mid, c)
    if rise < 1e-6 * radius:
        raise NotAnObstacle("an arc is half a circle: write it as two arcs")
    far = (radius / rise) ** 2
    # A little smaller, so that the edges are not shorter than their arcs.
    return (c[0] + far * (mid[0] - c[0]), c[1] + far * (mid[1] - c[1]),
            radius * (1 - 1e-9))


def side(parts, p: Place) -> float:
    """Where a point is off the closest segment: positive on the left."""
    found = []
    for a, b, c in parts:
        along = [y - x for x, y in zip(a, b)]
        s = sum(d * (q - x) for d, q, x in zip(along, p, a)) / math.dist(a, b) ** 2
        s = min(1, max(0, s))
        distance = math.dist(p, [x + s * d for x, d in zip(a, along)])
        where = cross(a, b, p)
        if c:
            off = math.dist(p, c) - math.dist(a, c)
            distance, where = abs(off), -off * cross(a, b, c)
        found.append((distance, math.copysign(distance, where)))
    return min(found)[1]


# ------------------------------------------------------------------ keywords

def take_surface(case: Case, block: Block, scope: Scope) -> None:
    case.obstacles[block.need("NAME").upper()] = Obstacle(block, scope)


def take_rigid_body(case: Case, block: Block, scope: Scope) -> None:
    name = block.options.get("ANALYTICALSURFACE", "")
    obstacle = case.obstacles.get(name.rpartition(".")[2].upper())
    if obstacle is None:
        case.leave(block, "rigid bodies are analytical surfaces that stand before; "
                   "of a boundary of a mesh give Boundary conditions/Rigid")
        return
    row = Row(block.where, [block.need("REFNODE")])
    nodes = case.deck.numbers(scope, "node", row.text(0), row)
    obstacle.node = nodes[0]
    case.reference_nodes[nodes[0]] = obstacle


def take_interaction(case: Case, block: Block, scope: Scope) -> None:
    case.interaction = block.need("NAME").upper()
    case.friction[case.interaction] = {}


def take_friction(case: Case, block: Block, scope: Scope) -> None:
    if case.interaction is None or not block.rows or case.steps:
        case.leave(block, "friction is a number in a *SURFACE INTERACTION, "
                   "for all steps")
        return
    coefficient = block.rows[0].number(0)
    entries = {"Friction coefficient": text(coefficient)}
    if "ELASTICSLIP" in block.options:
        entries["Elastic slip"] = text(block.number_of("ELASTICSLIP"))
    elif "SLIPTOLERANCE" in block.options:
        share = block.number_of("SLIPTOLERANCE")
        entries["Elastic slip"] = f"{text(100 * share)} %"
    case.friction[case.interaction] = entries if coefficient else {}
    for option in sorted(set(block.options) & {
            "ROUGH", "TAUMAX", "EXPONENTIALDECAY", "USER", "ANISOTROPIC"}):
        case.leave(block, f"{option}: friction is one number, Contact/Friction "
                   "coefficient")
    if len(block.rows) > 1:
        case.leave(block.rows[1], "friction is one number, that of the first row")


def take_surface_behavior(case: Case, block: Block, scope: Scope) -> None:
    hard = block.options.get("PRESSURE-OVERCLOSURE", "HARD").upper()
    if hard != "HARD" or "NOSEPARATION" in block.options:
        case.leave(block, "contact is hard and may open")


def take_pair(case: Case, block: Block, scope: Scope) -> None:
    for row in block.rows:
        interaction = block.options.get("INTERACTION", "").upper()
        if interaction and interaction not in case.friction:
            block.fault(f"there is no surface interaction '{interaction}'",
                        "it stands before: *SURFACE INTERACTION, NAME="
                        + interaction)
        entries = dict(case.friction.get(interaction, {}))
        if block.has("TYPE", "NODETOSURFACE"):
            entries["Discretization"] = "nodal"
        if "TIED" in block.options:
            entries["Tied"] = "true"
        add_pair(case, scope, row, entries)
    for option in ("ADJUST", "SMALLSLIDING", "HCRIT", "EXTENSIONZONE", "SMOOTH"):
        if option in block.options:
            case.leave(block, f"{option}: no such entry; surfaces are where they "
                       "are drawn, and slide as far as they do")


def take_inclusions(case: Case, block: Block, scope: Scope) -> None:
    """General contact, of all bodies or of surfaces."""
    named = [row for row in block.rows if row.text(0)]
    for row in named:
        add_pair(case, scope, row, {})
    if not named:
        case.general = case.section_of_pair("all")
        case.put(case.general, "Surfaces", "automatic")
        case.leave(block, "contact of a body with itself: give two groups of it")


def take_assignment(case: Case, block: Block, scope: Scope) -> None:
    for row in block.rows:
        friction = case.friction.get(row.text(2).upper())
        if row.text(0) or row.text(1) or not case.general or friction is None:
            case.leave(row, "an interaction of some surfaces: give *CONTACT PAIR")
        else:
            for entry, value in friction.items():
                case.put(case.general, entry, value)


def take_tie(case: Case, block: Block, scope: Scope) -> None:
    for row in block.rows:
        add_pair(case, scope, row, {"Tied": "true"})


def add_pair(case: Case, scope: Scope, row: Row, entries: dict[str, str]) -> None:
    """A section: slave, then master, as Abaqus has it."""
    slave, master = row.text(0), row.text(1)
    if not master or slave.upper() == master.upper():
        case.leave(row, "contact of a surface with itself: give two groups of it")
        return
    surface = case.deck.find(scope, "surface", slave, row)
    names = {"Slave": case.groups.surface(surface)}
    obstacle = case.obstacles.get(master.rpartition(".")[2].upper())
    section = case.section_of_pair(names["Slave"])
    if obstacle:
        nodes = {n for facet in surface.members for n in facet}
        try:
            names["Obstacle"] = obstacle.shape(
                [tuple(case.deck.points[n][:2]) for n in sorted(nodes)])
        except NotAnObstacle as why:
            case.leave(row, str(why))
            return
        if names["Obstacle"].startswith("profile"):
            case.leave(obstacle.block, "the ends of the profile: they go on "
                       "straight for ever")
        case.moving.append((section, obstacle))
    else:
        names["Master"] = case.groups.surface(
            case.deck.find(scope, "surface", master, row))
    for entry, value in {**names, **entries}.items():
        case.put(section, entry, value)


KEYWORDS = {"SURFACE": take_surface, "RIGIDBODY": take_rigid_body,
            "SURFACEINTERACTION": take_interaction, "FRICTION": take_friction,
            "SURFACEBEHAVIOR": take_surface_behavior, "CONTACTPAIR": take_pair,
            "CONTACTINCLUSIONS": take_inclusions,
            "CONTACTPROPERTYASSIGNMENT": take_assignment, "TIE": take_tie}
