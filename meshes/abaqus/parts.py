# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh of an Abaqus deck: nodes, elements, sets and surfaces, of parts and
their instances. Names of two instances are told apart as INSTANCE.NAME."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from pathlib import Path

from named_mesh import TYPES

from .deck import Block, Reader, Row

# Letters and number of nodes of a type -> its shape; letters behind the number
# say how it is integrated.
PLANE = {3: "triangle", 4: "quad", 6: "triangle6", 8: "quad8"}
SHAPES = {"CPE": PLANE, "CPS": PLANE, "CAX": PLANE,
          "C3D": {4: "tetra", 6: "wedge", 8: "hexahedron", 10: "tetra10",
                  15: "wedge15", 20: "hexahedron20"}}
VARIANTS = {"", "R", "I", "H", "M", "RH", "IH", "MH"}

# Elements that draw a boundary alone.
SURFACES = {"line": ("T2D2", "B21", "R2D2", "RAX2", "SAX1", "MAX1"),
            "line3": ("T2D3", "B22", "SAX2", "MAX2"),
            "triangle": ("S3", "S3R", "M3D3", "R3D3", "SFM3D3"),
            "triangle6": ("STRI65", "M3D6", "SFM3D6"),
            "quad": ("S4", "S4R", "M3D4", "M3D4R", "R3D4", "SFM3D4", "SFM3D4R"),
            "quad8": ("S8R", "M3D8", "M3D8R", "SFM3D8", "SFM3D8R")}
SURFACE_SHAPES = {name: kind for kind, names in SURFACES.items()
                  for name in names}

# Corners of the edges, behind which the mid-side nodes stand in this order, and
# of the faces S1, S2, ... Abaqus has the order of VTK.
EDGES = {"line": ((0, 1),),
         "triangle": ((0, 1), (1, 2), (2, 0)),
         "quad": ((0, 1), (1, 2), (2, 3), (3, 0)),
         "tetra": ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)),
         "wedge": ((0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3),
                   (1, 4), (2, 5)),
         "hexahedron": ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7),
                        (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))}
FACES = {"line": (), "triangle": EDGES["triangle"], "quad": EDGES["quad"],
         "tetra": ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)),
         "wedge": ((0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2),
                   (2, 5, 3, 0)),
         "hexahedron": ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2),
                        (2, 6, 7, 3), (3, 7, 4, 0))}

# What makes nodes or elements that are not in the deck, or moves them.
GENERATORS = {"NGEN", "NFILL", "NMAP", "NCOPY", "ELGEN", "ELCOPY", "SYSTEM",
              "SUBSTRUCTURE"}


@dataclass
class Cell:
    """An element of the deck."""
    label: int
    kind: str
    code: str  # Abaqus' name of the type
    nodes: list[int]
    row: Row
    scope: Scope
    own_set: str  # the set that its *ELEMENT names

    @property
    def where(self) -> str:
        return f"{self.row.where}, TYPE={self.code}"

    @property
    def shape(self) -> str:
        return self.kind.rstrip("0123456789")

    def facet(self, corners) -> list[int]:
        """Its nodes on a face or edge with these corners, those first."""
        n = 1 + max(max(edge) for edge in EDGES[self.shape])
        middles = {frozenset(edge): n + i
                   for i, edge in enumerate(EDGES[self.shape])}
        sides = zip(corners, [*corners[1:], *corners[:1]][:len(corners)])
        behind = [middles[frozenset(side)] for side in sides
                  if frozenset(side) in middles] if len(self.nodes) > n else []
        if len(corners) == 2:
            behind = behind[:1]
        return [self.nodes[i] for i in (*corners, *behind)]


@dataclass
class Set:
    """Numbers of nodes or cells; of a surface facets, each its nodes."""
    name: str
    scope: Scope
    members: list = field(default_factory=list)


@dataclass(eq=False)
class Scope:
    """What names and labels stand for in the assembly, or in an instance."""
    name: str = ""
    nodes: dict[int, int] = field(default_factory=dict)
    elements: dict[int, int] = field(default_factory=dict)
    sets: dict[str, dict[str, Set]] = field(
        default_factory=lambda: {"node": {}, "element": {}, "surface": {}})
    move: Motion | None = None

    def set(self, kind: str, name: str) -> Set:
        """That of the name, a new one if there is none."""
        return self.sets[kind].setdefault(name.upper(), Set(name, self))


class Motion:
    """Where an instance stands: moved, then turned about an axis."""

    def __init__(self, rows: list[Row]):
        numbers = [[row.number(i) for i in range(7)] for row in rows[:2]]
        self.shift = (numbers[0] if numbers else [0.0] * 3)[:3]
        self.turn = numbers[1] if len(numbers) > 1 else None
        if self.turn and self.turn[:3] == self.turn[3:6]:
            rows[1].fault("the axis of the rotation has no length",
                          "give two points of it, then the angle in degrees")

    def place(self, point: list[float]) -> list[float]:
        p = [a + b for a, b in zip(point, self.shift)]
        if not self.turn:
            return p
        a, b, angle = self.turn[:3], self.turn[3:6], math.radians(self.turn[6])
        k = [(y - x) / math.dist(a, b) for x, y in zip(a, b)]
        v = [x - y for x, y in zip(p, a)]
        across = [k[i - 2] * v[i - 1] - k[i - 1] * v[i - 2] for i in range(3)]
        along = sum(x * y for x, y in zip(k, v)) * (1 - math.cos(angle))
        return [a[i] + v[i] * math.cos(angle) + across[i] * math.sin(angle)
                + k[i] * along for i in range(3)]


class Deck:
    """All that a deck says of the mesh, and the blocks that it leaves."""

    def __init__(self, path: Path):
        self.path = path
        self.points: list[list[float]] = []
        self.cells: list[Cell] = []
        self.root = Scope()
        self.scopes = {"": self.root}
        self.rest: list[tuple[Block, Scope]] = []
        self.free: tuple[int, list] = -1, []  # for that many cells
        self.take(self.root, self.instances(Reader(path).blocks))
        self.dimension = max([2] + [TYPES[c.kind][1] if c.kind in TYPES else 3
                                    for c in self.cells])

    # ------------------------------------------------- parts and instances

    def instances(self, blocks: list[Block]) -> list[Block]:
        """Takes the blocks of instances; returns those of the assembly."""
        parts: dict[str, list[Block]] = {}
        own: list[Block] = []
        start, inside = None, own
        for block in blocks:
            if block.keyword in ("PART", "INSTANCE"):
                if start:
                    start.fault(f"{start.title} does not end",
                                start.title.replace("*", "write *END ")
                                + f" before line {block.line}")
                start, inside = block, []
                block.need("NAME")
            elif block.keyword in ("ENDPART", "ENDINSTANCE"):
                if not start or block.keyword != "END" + start.keyword:
                    block.fault(f"nothing ends with {block.title}",
                                "delete it, or write what it ends before")
                if block.keyword == "ENDPART":
                    parts[start.need("NAME").upper()] = inside
                else:
                    self.add_instance(start, parts, inside)
                start, inside = None, own
            elif block.keyword not in ("ASSEMBLY", "ENDASSEMBLY"):
                inside.append(block)
        if start:
            start.fault(f"{start.title} does not end",
                        start.title.replace("*", "write *END "))
        return own

    def add_instance(self, start: Block, parts, own: list[Block]) -> None:
        name, part = start.need("NAME"), start.options.get("PART", "")
        if part.upper() not in parts:
            start.fault(f"there is no part '{part}'",
                        "parts stand before the assembly: "
                        + (", ".join(parts) or "none"))
        scope = Scope(name, move=Motion(start.rows))
        self.scopes[name.upper()] = scope
        self.take(scope, parts[part.upper()] + own)

    def take(self, scope: Scope, blocks: list[Block]) -> None:
        """Nodes, then what stands on them, wherever it stands in the deck."""
        steps = ({"NODE": self.add_nodes}, {"ELEMENT": self.add_elements},
                 {"NSET": self.add_set, "ELSET": self.add_set},
                 {"SURFACE": self.add_surface})
        for step in steps:
            for block in blocks:
                if block.keyword in GENERATORS:
                    block.fault(f"{block.title} is not read",
                                "write a deck with all nodes and elements, and "
                                "global coordinates, as the preprocessor or "
                                "Abaqus' data file has them")
                if block.keyword in step:
                    step[block.keyword](scope, block)
        taken = {k for step in steps for k in step}
        self.rest += [(b, scope) for b in blocks if b.keyword not in taken
                      or is_analytical(b)]

    # ------------------------------------------------- nodes and elements

    def add_nodes(self, scope: Scope, block: Block) -> None:
        if block.options.get("SYSTEM", "R").upper() != "R":
            block.fault("nodes in cylindrical or spherical coordinates are not "
                        "read", "write them in global ones")
        group = scope.set("node", block.options["NSET"]).members \
            if block.options.get("NSET") else []
        for row in block.rows:
            label = row.integer(0)
            if label in scope.nodes:
                row.fault(f"there are two nodes {label}", "delete one of them")
            point = [row.number(i) for i in (1, 2, 3)]
            scope.nodes[label] = len(self.points)
            group.append(len(self.points))
            self.points.append(scope.move.place(point) if scope.move else point)

    def add_elements(self, scope: Scope, block: Block) -> None:
        code = block.need("TYPE").upper()
        kind = shape_of(code, block)
        digits = re.search(r"\d+$", kind)
        n = int(digits[0]) if digits else TYPES[kind][2]
        own = block.options.get("ELSET", "")
        group = scope.set("element", own).members if own else []
        for row in whole_rows(block, n):
            label, *nodes = (row.integer(i) for i in range(n + 1))
            if label in scope.elements:
                row.fault(f"there are two elements {label}", "delete one of them")
            numbers = [self.member(scope, "node", node, row,
                                   f"element {label} has the ")
                       for node in nodes]
            scope.elements[label] = len(self.cells)
            group.append(len(self.cells))
            self.cells.append(Cell(label, kind, code, numbers, row,
                                   scope, own))

    def member(self, scope: Scope, kind: str, label: int, row: Row,
               before: str = "") -> int:
        found = scope.nodes if kind == "node" else scope.elements
        if label not in found:
            row.fault(f"{before}{kind} {label}, which does not exist" if before
                      else f"there is no {kind} {label}"
                      + (f" in the instance '{scope.name}'" * bool(scope.name)),
                      f"the deck has {len(found)} {kind}s"
                      + (f", {min(found)} to {max(found)}" if found else "")
                      + "; correct the number")
        return found[label]

    # -------------------------------------------------- sets and surfaces

    def title(self, scope: Scope, name: str) -> str:
        """A name, with the instance where another one has it as well."""
        if not scope.name or not name:
            return name
        is_taken = any(name.upper() in sets for s in self.scopes.values()
                       if s is not scope for sets in s.sets.values())
        return f"{scope.name}.{name}" if is_taken else name

    def find(self, scope: Scope, kind: str, text: str, row: Row | Block) -> Set:
        """The set or surface that a name, maybe INSTANCE.NAME, stands for."""
        instance, _, name = text.rpartition(".")
        for s in (scope, self.scopes.get(instance.upper())):
            key = text.upper() if s is scope else name.upper()
            if s and key in s.sets[kind]:
                return s.sets[kind][key]
        known = [found.name if s is scope or not s.name
                 else f"{s.name}.{found.name}" for s in self.scopes.values()
                 for found in s.sets[kind].values()]
        what = {"node": "node set", "element": "element set",
                "surface": "surface"}[kind]
        row.fault(f"there is no {what} '{text}'",
                  f"of this kind there are: {', '.join(known) or 'none'}")

    def numbers(self, scope: Scope, kind: str, text: str,
                row: Row) -> list[int]:
        """Of a label, INSTANCE.label, or a set."""
        instance, _, label = text.rpartition(".")
        if re.fullmatch(r"\d+", label):
            inner = self.scopes.get(instance.upper()) if instance else scope
            if inner is None:
                row.fault(f"there is no instance '{instance}'",
                          "instances: " + ", ".join(
                              s.name for s in self.scopes.values() if s.name))
            return [self.member(inner, kind, int(label), row)]
        return self.find(scope, kind, text, row).members

    def add_set(self, scope: Scope, block: Block) -> None:
        kind = "node" if block.keyword == "NSET" else "element"
        group = scope.set(kind, block.need(block.keyword))
        inner = scope
        if "INSTANCE" in block.options:
            inner = self.scopes.get(block.options["INSTANCE"].upper())
            if inner is None:
                block.fault(f"there is no instance '{block.options['INSTANCE']}'",
                            "name one that the assembly has")
        found: list[int] = []
        if kind == "node" and "ELSET" in block.options:
            cells = self.find(inner, "element", block.options["ELSET"], block)
            found += [n for c in cells.members for n in self.cells[c].nodes]
        for row in block.rows:
            if "GENERATE" in block.options:
                found += self.generated(inner, kind, row)
                continue
            for text in filter(None, row.fields):
                found += self.numbers(inner, kind, text, row)
        group.members[:] = dict.fromkeys(group.members + found)

    def generated(self, scope: Scope, kind: str, row: Row) -> list[int]:
        """First, last, step; labels between that do not exist are passed over,
        as Abaqus does."""
        first, last = row.integer(0), row.integer(1)
        step = row.integer(2) if row.text(2) else 1
        if step < 1 or last < first:
            row.fault("GENERATE needs first <= last and a step of 1 or more",
                      "write first, last, step")
        labels = scope.nodes if kind == "node" else scope.elements
        self.member(scope, kind, first, row)
        return [labels[i] for i in range(first, last + 1, step) if i in labels]

    def add_surface(self, scope: Scope, block: Block) -> None:
        if is_analytical(block):
            return
        kind = block.options.get("TYPE", "ELEMENT").upper()
        if kind not in ("ELEMENT", "NODE") or "COMBINE" in block.options:
            block.fault("this surface is not read",
                        "write it with TYPE=ELEMENT, TYPE=NODE or TYPE=SEGMENTS, "
                        "without COMBINE")
        surface = scope.set("surface", block.need("NAME"))
        for row in block.rows:
            if kind == "NODE":
                nodes = self.numbers(scope, "node", row.text(0), row)
                surface.members += self.facets_within(set(nodes))
            else:
                cells = self.numbers(scope, "element", row.text(0), row) \
                    if row.text(0) else range(len(self.cells))
                surface.members += self.facets_of(cells, row.text(1).upper(), row)
        if not surface.members:
            block.fault(f"the surface '{surface.name}' has no faces",
                        "name faces S1 to S6 of elements, or all nodes of faces")

    def facets_of(self, cells, face: str, row: Row) -> list[list[int]]:
        """The face of each cell, or their free faces."""
        if not face:
            own = set(cells)
            return [facet for facet, cell in self.free_facets() if cell in own]
        found = []
        for cell in (self.cells[c] for c in cells):
            faces = FACES.get(cell.shape, ())
            number = int(face[1:]) if re.fullmatch(r"S[1-9]", face) else 0
            if cell.code in SURFACE_SHAPES and face in ("SPOS", "SNEG"):
                found.append(cell.nodes)
            elif cell.shape not in FACES:
                pass  # a volume that is refused
            elif 1 <= number <= len(faces):
                found.append(cell.facet(faces[number - 1]))
            else:
                row.fault(f"element {cell.label} of type {cell.code} has no face "
                          f"{face}", f"its faces are S1 to S{len(faces)}"
                          if faces else "its faces are SPOS and SNEG")
        return found

    def free_facets(self) -> list[tuple[list[int], int]]:
        """Faces that one cell alone has, and its number."""
        if self.free[0] == len(self.cells):
            return self.free[1]
        found: dict[frozenset[int], list] = {}
        for number, cell in enumerate(self.cells):
            if cell.code not in SURFACE_SHAPES:
                for corners in FACES.get(cell.shape, ()):
                    key = frozenset(cell.nodes[i] for i in corners)
                    found.setdefault(key, []).append((cell, corners, number))
        self.free = len(self.cells), [
            (cell.facet(corners), number) for [(cell, corners, number)]
            in (f for f in found.values() if len(f) == 1)]
        return self.free[1]

    def facets_within(self, nodes: set[int]) -> list[list[int]]:
        return [facet for facet, _ in self.free_facets()
                if nodes.issuperset(facet)]


def is_analytical(block: Block) -> bool:
    return block.keyword == "SURFACE" and block.options.get("TYPE", "").upper() \
        in ("SEGMENTS", "CYLINDER", "REVOLUTION")


def shape_of(code: str, block: Block) -> str:
    if code in SURFACE_SHAPES:
        return SURFACE_SHAPES[code]
    match = re.fullmatch(r"(CPE|CPS|CAX|C3D)(\d+)([A-Z]*)", code)
    if match and match[3] in VARIANTS and int(match[2]) in SHAPES[match[1]]:
        return SHAPES[match[1]][int(match[2])]
    block.fault(f"elements of type {code} are not read",
                "mesh with CPE, CAX or CPS of 3, 4, 6 or 8 nodes or with C3D4, "
                "C3D8, C3D10 or C3D20, and delete elements that are no volumes or "
                "areas")


def whole_rows(block: Block, n: int) -> list[Row]:
    """A row for each element, of n nodes, from lines that may go on."""
    found: list[Row] = []
    for row in block.rows:
        if found and len(found[-1].fields) < n + 1:
            found[-1].fields += row.fields
        else:
            found.append(Row(row.where, list(row.fields)))
    for row in found:
        if len(row.fields) != n + 1:
            row.fault(f"element {row.text(0)} has {len(row.fields) - 1} nodes, "
                      f"one of type {block.options['TYPE'].upper()} has {n}",
                      "write the number of the element and its nodes")
    return found
