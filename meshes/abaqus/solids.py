# SPDX-License-Identifier: LGPL-2.1-or-later
"""Materials, sections and elements as entries of the sections Solids and
Element."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .deck import Block, Row
from .parts import Cell, Scope
from .steps import text

if TYPE_CHECKING:
    from .case import Case

NEARLY_INCOMPRESSIBLE = 0.4999  # Poisson's ratio, for D1 = 0
ROUND = 1e-6  # a mid-side node is off by more of the length of its side


def take_material(case: Case, block: Block, scope: Scope) -> None:
    case.material = case.materials.setdefault(block.need("NAME").upper(), {})


def take_law(case: Case, block: Block, scope: Scope) -> None:
    """A keyword of the material before."""
    if case.material is None:
        block.fault("no material is begun", "write *MATERIAL, NAME=NAME before")
    case.material[block.keyword] = block


def first_temperature(case: Case, block: Block, field: int) -> list[Row]:
    """The rows of the first temperature, which stands in this field."""
    rows = [row for row in block.rows
            if row.number(field) == block.rows[0].number(field)]
    if len(rows) < len(block.rows):
        case.leave(block, "other temperatures than the first")
    return rows


class Body:
    """A body with its material, and the entries of both."""

    def __init__(self, case: Case, name: str, cells: list[int]):
        self.case, self.name = case, name
        self.cells = [case.deck.cells[cell] for cell in cells]
        self.material = self.find_material(cells)
        for keyword, read in (("ELASTIC", self.elastic),
                              ("HYPERELASTIC", self.hyperelastic),
                              ("PLASTIC", self.plastic)):
            if keyword in self.material and self.material[keyword].rows:
                read(self.material[keyword])

    @property
    def is_plastic(self) -> bool:
        return "PLASTIC" in self.material and bool(self.material["PLASTIC"].rows)

    def find_material(self, cells: list[int]) -> dict[str, Block]:
        case = self.case
        blocks = {id(b): b for c in cells if c in case.groups.sections
                  for b in [case.groups.sections[c][0]]}
        names = {b.options.get("MATERIAL", "").upper() for b in blocks.values()}
        if not names and len(case.materials) == 1:
            return next(iter(case.materials.values()))
        if len(names) > 1:
            next(iter(blocks.values())).fault(
                f"the body '{self.name}' has more than one material: "
                + ", ".join(sorted(names)), "choose bodies with --bodies NAME,NAME")
        for block in blocks.values():
            if not names <= set(case.materials):
                block.fault(f"there is no material '{block.options.get('MATERIAL')}'",
                            "materials: " + (", ".join(case.materials) or "none"))
        if not names and case.materials:
            case.leave(self.cells[0].row, f"the body '{self.name}' has no *SOLID "
                       "SECTION: its material is missing")
        return case.materials[names.pop()] if names else {}

    def put(self, entry: str, value: float | str) -> None:
        self.case.put("Solids", entry, f"{self.name}: " + (
            value if isinstance(value, str) else text(value)))

    def elastic(self, block: Block) -> None:
        if block.options.get("TYPE", "ISOTROPIC").upper() not in ("ISOTROPIC",
                                                                   "ISO"):
            self.case.leave(block, "materials are isotropic")
            return
        row = first_temperature(self.case, block, 2)[0]
        self.put("Young's modulus", row.number(0))
        self.put("Poisson's ratio", row.number(1))

    def hyperelastic(self, block: Block) -> None:
        case, row = self.case, block.rows[0]
        is_mooney = "MOONEY-RIVLIN" in block.options
        if not (is_mooney or "NEOHOOKE" in block.options) \
                or "TESTDATAINPUT" in block.options:
            case.leave(block, "rubber is NEO HOOKE or MOONEY-RIVLIN, with its "
                       "constants")
            return
        c10, c01 = row.number(0), row.number(1) if is_mooney else 0.0
        d1, mu = row.number(1 + is_mooney), 2 * (c10 + c01)
        nu = NEARLY_INCOMPRESSIBLE
        if d1 > 0:
            bulk = 2 / d1
            nu = (3 * bulk - 2 * mu) / (2 * (3 * bulk + mu))
        else:
            case.leave(row, f"D1 = 0: the Poisson's ratio is {nu}")
        self.put("Young's modulus", 2 * mu * (1 + nu))
        self.put("Poisson's ratio", nu)
        if not case.large:
            case.leave(block, "without NLGEOM=YES the body is linear elastic")
            return
        self.put("Material", "Mooney-Rivlin" if is_mooney else "neo-Hookean")
        if is_mooney:
            self.put("Mooney-Rivlin constant", c01)

    def plastic(self, block: Block) -> None:
        case, rows = self.case, first_temperature(self.case, block, 2)
        curve = [(row.number(1), row.number(0)) for row in rows]
        hardening = block.options.get("HARDENING", "ISOTROPIC").upper()
        kinematic = hardening == "KINEMATIC" and len(curve) <= 2
        if hardening != "ISOTROPIC" and not kinematic or "RATE" in block.options:
            case.leave(block, "hardening is isotropic or, of two rows, kinematic: "
                       "the body is elastic")
            return
        strains = [strain for strain, _ in curve]
        if strains[0] != 0 or strains != sorted(set(strains)):
            rows[0].fault("plastic strains have to begin with 0 and grow",
                          "write yield stress, plastic strain")
        self.put("Material", "elastic-plastic")
        self.put("Yield stress", curve[0][1])
        if kinematic and len(curve) == 2:
            self.put("Kinematic hardening modulus",
                     (curve[1][1] - curve[0][1]) / curve[1][0])
        elif len(curve) > 1:
            self.put("Hardening curve", ", ".join(
                text(x) for point in curve[1:] for x in point))

    def density(self, row: Row) -> float:
        if not ("DENSITY" in self.material and self.material["DENSITY"].rows):
            row.fault(f"the body '{self.name}' has no density",
                      "add *DENSITY to its material")
        self.case.weighed.add(id(self.material))
        return self.material["DENSITY"].rows[0].number(0)


def put_elements(case: Case, bodies: list[Body]) -> None:
    """What the types of elements say."""
    first: dict[str, Cell] = {}
    for body in bodies:
        for cell in body.cells:
            first.setdefault(cell.code, cell)
    families = {code[:3] for code in first}
    if len(families) > 1:
        a, b = [next(c for c in first.values() if c.code.startswith(f))
                for f in sorted(families)][:2]
        b.row.fault(f"elements {a.label} of type {a.code} and {b.label} "
                               f"of type {b.code} do not go together",
                               "take one family in a deck")
    if families == {"CAX"}:
        case.put("Solids", "Symmetry", "axisymmetric")
    is_stress = not case.large and not any(body.is_plastic for body in bodies)
    if families == {"CPS"} and is_stress:
        case.put("Solids", "Symmetry", "plane stress")
    for code, cell in sorted(first.items()):
        if code.startswith("CPS") and not is_stress:
            case.leave(cell.row, f"{code}: plane stress is that of elastic bodies "
                       "in small strain, this case is plane strain")
        if code.endswith(("R", "RH")):
            case.leave(cell.row, f"{code}: reduced integration; cells are "
                       "integrated in full")
        if code.startswith("C3D10M"):
            case.leave(cell.row, f"{code}: modified formulation; cells are "
                       "tetrahedra of 10 nodes")
    soft = [body.name for body in bodies
            if any(cell.code.endswith(("I", "IH")) for cell in body.cells)]
    for name in soft:
        case.put("Solids", "Incompatible modes", name)
    second = [cell.kind != cell.shape for cell in first.values()]
    case.put("Element", "Degree", "2" if any(second) else "1")
    for cell, is_second in zip(first.values(), second):
        if any(second) and not is_second:
            case.leave(cell.row, f"{cell.code}: first order beside second; all "
                       "cells are of second")
    if any(second) and has_round_sides(case):
        case.put("Mesh", "Mid-side nodes", "true")
        case.is_round = True


def has_round_sides(case: Case) -> bool:
    points = case.deck.points
    for facet, _ in case.deck.free_facets():
        n = {3: 2, 6: 3, 8: 4}.get(len(facet)) if case.deck.dimension == 3 \
            or len(facet) == 3 else None
        for i in range(n or 0):
            if n + i < len(facet):
                a, b, c = (points[facet[j]] for j in (i, (i + 1) % n, n + i))
                middle = [(x + y) / 2 for x, y in zip(a, b)]
                if math.dist(c, middle) > ROUND * math.dist(a, b):
                    return True
    return False


def put_solids(case: Case) -> list[Body]:
    bodies = [Body(case, name, cells)
              for name, cells in case.groups.body_cells.items()]
    case.put("Solids", "Kinematics",
             "large displacement" if case.large else "small strain")
    put_elements(case, bodies)
    return bodies


KEYWORDS = {"MATERIAL": take_material, "ELASTIC": take_law, "PLASTIC": take_law,
            "HYPERELASTIC": take_law, "DENSITY": take_law}
