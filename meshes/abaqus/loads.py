# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps, supports and loads as entries of the section Boundary conditions."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .deck import Block, Row
from .parts import Scope
from .steps import (Amplitude, Load, Step, as_formula, as_table, share_histories,
                    text)

if TYPE_CHECKING:
    from .case import Case

# Degrees of freedom of *BOUNDARY by name; 4 to 6 are rotations, which volumes
# have none of.
NAMED_SUPPORTS = {"ENCASTRE": (1, 2, 3, 4, 5, 6), "PINNED": (1, 2, 3),
                  "XSYMM": (1, 5, 6), "YSYMM": (2, 4, 6), "ZSYMM": (3, 4, 5),
                  "XASYMM": (2, 3, 4), "YASYMM": (1, 3, 5), "ZASYMM": (1, 2, 6)}


def take_amplitude(case: Case, block: Block, scope: Scope) -> None:
    if block.options.get("DEFINITION", "TABULAR").upper() != "TABULAR" or \
            block.has("VALUE", "ABSOLUTE"):
        block.fault("only tables of factors are read as amplitudes",
                    "write pairs of time and factor")
    case.amplitudes[block.need("NAME").upper()] = Amplitude.read(block)


def take_step(case: Case, block: Block, scope: Scope) -> None:
    start = sum(step.period for step in case.steps)
    case.steps.append(Step(start=start, at_once=block.has("AMPLITUDE", "STEP")))
    if "NLGEOM" in block.options and not block.has("NLGEOM", "NO"):
        case.large = True
    if "PERTURBATION" in block.options:
        block.fault("perturbation steps are not read", "delete the step")


def take_static(case: Case, block: Block, scope: Scope) -> None:
    if not case.steps:
        block.fault("no step is begun", "write *STEP before")
    case.steps[-1].read_static(block)
    for option in ("RIKS", "STABILIZE"):
        if option in block.options:
            case.leave(block, f"{option}: no such entry")


def take_procedure(case: Case, block: Block, scope: Scope) -> None:
    block.fault(f"{block.title} is no static step",
                "delete the step, or make it *STATIC")


class Target:
    """What a row acts on, and how it goes on in this step."""

    def __init__(self, case: Case, block: Block, scope: Scope, row: Row):
        self.case, self.block, self.scope, self.row = case, block, scope, row
        name = block.options.get("AMPLITUDE", "").upper()
        if name and name not in case.amplitudes:
            block.fault(f"there is no amplitude '{block.options['AMPLITUDE']}'",
                        "amplitudes: " + (", ".join(case.amplitudes) or "none"))
        self.amplitude = case.amplitudes.get(name)
        self.n = max(0, len(case.steps) - 1)
        self.step = case.steps[-1] if case.steps else Step()

    def go_on(self, loads: dict, key, entry: str, group: str, value: float) -> None:
        if self.block.keyword == "BOUNDARY" and self.n > 0 and key not in loads:
            self.case.leave(self.row, f"the support '{group}' begins in step "
                            f"{self.n + 1}; here it is there, at rest, from the "
                            "start")
        load = loads.setdefault(key, Load(entry, group, self.row,
                                          self.block.keyword, self.n))
        load.go_on(self.n, self.step, value, self.amplitude)

    def put(self, entry: str, group: str, value: float) -> None:
        self.go_on(self.case.loads, (entry, group), entry, group, value)

    def nodes(self) -> tuple[str, list[int]]:
        """Of the set or label in the first field, with a name."""
        deck, name = self.case.deck, self.row.text(0)
        nodes = deck.numbers(self.scope, "node", name, self.row)
        if name.rpartition(".")[2].isdigit():
            return f"Node_{name}", nodes
        found = deck.find(self.scope, "node", name, self.row)
        return deck.title(found.scope, found.name), nodes


def begin(case: Case, block: Block) -> None:
    """With OP=NEW the loads of this keyword end, and go back to zero."""
    n = len(case.steps) - 1
    if not block.has("OP", "NEW") or n < 1:
        return
    of_obstacles = [load for o in case.obstacles.values()
                    for load in (*o.motions.values(), *o.forces.values())]
    for load in [*case.loads.values(), *of_obstacles]:
        if load.kind != block.keyword or load.step == n:
            continue
        if block.keyword == "BOUNDARY":
            case.ending.append((n, load, block))
        else:
            load.go_on(n, case.steps[-1], 0.0, None)
            load.step = n - 1


def take_boundary(case: Case, block: Block, scope: Scope) -> None:
    if not block.options.get("TYPE", "DISPLACEMENT").upper() == "DISPLACEMENT" \
            or {"FIXED", "SUBMODEL", "USER"} & set(block.options):
        case.leave(block, "supports are given displacements")
        return
    begin(case, block)
    for row in block.rows:
        target = Target(case, block, scope, row)
        dofs = NAMED_SUPPORTS.get(row.text(1).upper())
        if dofs is None:
            first = row.integer(1)
            dofs = range(first, (row.integer(2) if row.text(2) else first) + 1)
        value = 0.0 if row.text(1).upper() in NAMED_SUPPORTS else row.number(3)
        if not dofs or min(dofs) < 1 or max(dofs) > 6:
            case.leave(row, "degrees of freedom are 1 to 3, of rigid surfaces 6")
            continue
        support(target, dofs, value)


def support(target: Target, dofs, value: float) -> None:
    case, (name, nodes) = target.case, target.nodes()
    if len(nodes) == 1 and nodes[0] in case.reference_nodes:
        obstacle = case.reference_nodes[nodes[0]]
        for dof in set(dofs) & {1, 2, 6}:
            target.go_on(obstacle.motions, dof, "", name, value)
        return
    dofs = [dof for dof in dofs if dof <= case.deck.dimension]
    if not dofs:
        return
    if case.transformed.intersection(nodes):
        case.leave(target.row, "directions of *TRANSFORM: give Boundary "
                   "conditions/Displacement normal")
        return
    for dof in dofs:
        case.held.setdefault("xyz"[dof - 1], set()).update(nodes)
    groups, lost = case.groups.supports(name, nodes)
    if not groups:
        case.leave(target.row, f"the set '{name}' has no nodes of areas or volumes")
    elif lost:
        case.leave(target.row, f"{len(lost)} mid-side nodes of the set '{name}', "
                   "which is not all nodes of their sides")
    for group in groups:
        for dof in dofs:
            target.put("Displacement " + "xyz"[dof - 1], group, value)


def take_cload(case: Case, block: Block, scope: Scope) -> None:
    begin(case, block)
    for row in block.rows:
        target = Target(case, block, scope, row)
        (name, nodes), dof, value = target.nodes(), row.integer(1), row.number(2)
        if len(nodes) == 1 and nodes[0] in case.reference_nodes:
            obstacle = case.reference_nodes[nodes[0]]
            if dof in (1, 2, 6):
                target.go_on(obstacle.forces, dof, "", name, value)
            continue
        if not 1 <= dof <= case.deck.dimension:
            case.leave(row, "volumes have no moments at nodes: give Boundary "
                       "conditions/Rigid, with Moment z")
            continue
        for node in nodes:
            group = name if len(nodes) == 1 else \
                f"{name}_{case.groups.labels[node]}"
            if node in case.groups.corners:
                case.groups.point(group, node)
            else:
                case.place(group, node, row)
            target.put("Force " + "xyz"[dof - 1], group, value / case.thickness)


def take_dload(case: Case, block: Block, scope: Scope) -> None:
    begin(case, block)
    for row in block.rows:
        target, kind = Target(case, block, scope, row), row.text(1).upper()
        cells = case.deck.numbers(scope, "element", row.text(0), row) \
            if row.text(0) else list(range(len(case.deck.cells)))
        if kind[0:1] == "P" and kind[1:].isdigit():
            facets = case.deck.facets_of(cells, "S" + kind[1:], row)
            name = row.text(0)
            name = f"Element_{name}" if name.isdigit() else name
            target.put("Pressure", case.groups.boundary(
                f"{name}_{kind}", facets, "_faces"), row.number(2))
        elif kind in ("BX", "BY", "BZ"):
            case.body_forces.append((target, cells, "xyz".index(kind[1].lower()),
                                     row.number(2), False))
        elif kind == "GRAV":
            axis = [row.number(i) for i in (3, 4, 5)]
            for d in range(case.deck.dimension):
                if axis[d]:
                    case.body_forces.append(
                        (target, cells, d, row.number(2) * axis[d]
                         / math.hypot(*axis), True))
        else:
            case.leave(row, f"{kind}: loads are P1 to P6, BX, BY, BZ and GRAV")


def put_body_forces(case: Case, bodies) -> None:
    """Behind the materials, whose densities weight needs."""
    for target, cells, d, value, is_weight in case.body_forces:
        within = set(cells)
        for body in bodies:
            own = set(case.groups.body_cells[body.name])
            if own <= within:
                target.put("Body force " + "xyz"[d], body.name, value * (
                    body.density(target.row) if is_weight else 1))
            elif own & within:
                case.leave(target.row, "a force on a part of the body "
                           f"'{body.name}': make it a body with --bodies")
    for material in case.materials.values():
        if "DENSITY" in material and id(material) not in case.weighed:
            case.leave(material["DENSITY"], "statics have no inertia; *DLOAD, GRAV "
                       "would use it")


def take_dsload(case: Case, block: Block, scope: Scope) -> None:
    begin(case, block)
    for row in block.rows:
        target, kind = Target(case, block, scope, row), row.text(1).upper()
        group = case.groups.surface(case.deck.find(scope, "surface", row.text(0),
                                                   row))
        if kind == "P":
            target.put("Pressure", group, row.number(2))
        elif kind == "TRVEC":
            axis = [row.number(i) for i in (3, 4, 5)]
            for d in range(case.deck.dimension):
                if axis[d]:
                    target.put("Traction " + "xyz"[d], group,
                               row.number(2) * axis[d] / math.hypot(*axis))
        else:
            case.leave(row, f"{kind}: loads are P and TRVEC")


def put_loads(case: Case) -> None:
    """All loads of each entry, with their history."""
    section, n_steps = "Boundary conditions", case.n_steps
    for n, load, block in case.ending:
        if load.step < n:
            case.leave(block, f"OP=NEW: the support '{load.group}' does not end")
    by_entry: dict[str, list[Load]] = {}
    for load in case.loads.values():
        by_entry.setdefault(load.entry, []).append(load)
    for entry, loads in sorted(by_entry.items()):
        shared, history, others = share_histories(loads, n_steps)
        for load in loads if entry == "Pressure" and case.large else ():
            case.leave(load.row, "a pressure that turns with its surface: it keeps "
                       "the normal of the undeformed one")
        for load in shared:
            case.put(section, entry, f"{load.group}: {text(load.peak())}")
        if history:
            case.put(section, "Histories", f"{entry}: {history}")
        for load in others:
            if entry.startswith("Displacement"):
                case.put(section, f"Displacement formula {entry[-1]}",
                         f"{load.group}: " + as_formula(load.table(n_steps)))
            else:
                case.leave(load.row, f"'{load.group}' has another history than the "
                           f"other values of the entry {entry}: "
                           + as_table(load.table(n_steps)))
    case.put("Solution", "Increments",
             str(n_steps * max((s.n_increments for s in case.steps), default=1)))


def take_transform(case: Case, block: Block, scope: Scope) -> None:
    row = Row(block.where, [block.need("NSET")])
    case.transformed.update(case.deck.numbers(scope, "node", row.text(0), row))


KEYWORDS = {"AMPLITUDE": take_amplitude, "STEP": take_step, "STATIC": take_static,
            "BOUNDARY": take_boundary, "CLOAD": take_cload, "DLOAD": take_dload,
            "DSLOAD": take_dsload, "TRANSFORM": take_transform,
            **dict.fromkeys(("DYNAMIC", "FREQUENCY", "BUCKLE", "HEATTRANSFER",
                             "MODALDYNAMIC", "STEADYSTATEDYNAMICS", "VISCO",
                             "COUPLEDTEMPERATURE-DISPLACEMENT"), take_procedure)}
