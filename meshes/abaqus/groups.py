# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh of an Abaqus deck with its groups: bodies, boundaries and points."""

from __future__ import annotations

from named_mesh import TYPES, BadMesh, Element, Mesh

from .deck import Block
from .parts import EDGES, Cell, Deck, Set

FACET_KINDS = {(2, 2): "line", (2, 3): "line3", (3, 3): "triangle",
               (3, 6): "triangle6", (4, 4): "quad", (4, 8): "quad8"}

N_CORNERS = {shape: 1 + max(max(edge) for edge in edges)
             for shape, edges in EDGES.items()}


class Groups:
    """The mesh of a deck, to which a case adds the groups that it needs."""

    def __init__(self, deck: Deck, bodies: list[str]):
        self.deck, self.mesh = deck, Mesh(deck.points)
        self.facets: dict[frozenset[int], Element] = {}
        self.taken: dict[str, frozenset] = {}  # boundary -> its facets
        self.supported: dict[str, tuple[list[str], list[int]]] = {}
        self.used = {n for c in deck.cells for n in c.nodes}
        self.corners = {n for c in deck.cells if self.is_cell(c)
                        for n in c.nodes[:N_CORNERS.get(c.shape, 8)]}
        self.labels = {n: label for s in deck.scopes.values()
                       for label, n in s.nodes.items()}
        self.sections = self.find_sections()
        self.body_cells: dict[str, list[int]] = {}
        self.add_cells(bodies)
        for scope in deck.scopes.values():
            for surface in scope.sets["surface"].values():
                self.surface(surface)

    # ------------------------------------------------------------- bodies

    def is_cell(self, cell: Cell) -> bool:
        """Shells and lines beside cells of their dimension draw boundaries."""
        return self.deck.dimension == 3 and cell.kind not in TYPES or \
            TYPES[cell.kind][1] == self.deck.dimension

    def find_sections(self) -> dict[int, tuple[Block, str]]:
        """Of each cell its *SOLID SECTION, and the name of the set of this."""
        found: dict[int, tuple[Block, str]] = {}
        for block, scope in self.deck.rest:
            if block.keyword == "SOLIDSECTION":
                cells = self.deck.find(scope, "element", block.need("ELSET"),
                                       block)
                name = self.deck.title(cells.scope, cells.name)
                for cell in cells.members:
                    if cell in found and found[cell][1] != name:
                        block.fault(
                            f"element {self.deck.cells[cell].label} has two "
                            f"sections, '{found[cell][1]}' and '{name}'",
                            "give each element one *SOLID SECTION")
                    found[cell] = block, name
        return found

    def add_cells(self, bodies: list[str]) -> None:
        """Each cell with its body, or with all of its sets to choose from."""
        sets: list[set[str]] = [set() for _ in self.deck.cells]
        for scope in self.deck.scopes.values() if bodies else ():
            for group in scope.sets["element"].values():
                for cell in group.members:
                    sets[cell].add(self.deck.title(scope, group.name))
        for number, cell in enumerate(self.deck.cells):
            names = sets[number]
            if not bodies or not self.is_cell(cell):
                own = self.deck.title(cell.scope, cell.own_set)
                names = {self.sections[number][1] if number in self.sections
                         else own or cell.scope.name or "Body"}
            if self.is_cell(cell):
                self.mesh.add(cell.kind, [cell.nodes], [names], cell.where)
                for name in names & set(bodies) if bodies else names:
                    self.body_cells.setdefault(name, []).append(number)
            else:
                self.add_facets(min(names), [cell.nodes],
                                TYPES[cell.kind][1])
        if not any(self.is_cell(cell) for cell in self.deck.cells):
            raise BadMesh("the deck has no areas or volumes",
                          str(self.deck.path), "it needs *ELEMENT, TYPE=CPE4 or "
                          "another one of CPE, CAX, CPS or C3D")

    # --------------------------------------------------------- boundaries

    def add_facets(self, name: str, facets, dimension: int) -> None:
        for nodes in facets:
            n = 2 if dimension == 1 else 3 if len(nodes) in (3, 6) else 4
            key = frozenset(nodes[:n])
            if key not in self.facets:
                self.facets[key] = Element(FACET_KINDS[n, len(nodes)], list(nodes))
                self.mesh.elements.append(self.facets[key])
            self.facets[key].groups.add(name)

    def boundary(self, name: str, facets, other: str) -> str:
        """The group of these facets; @p other is the end of its name if another
        group has it already."""
        key = frozenset(frozenset(facet) for facet in facets)
        if self.taken.setdefault(name, key) != key:
            name += other
            self.taken[name] = key
        self.add_facets(name, facets, self.deck.dimension - 1)
        return name

    def surface(self, surface: Set) -> str:
        return self.boundary(self.deck.title(surface.scope, surface.name),
                             surface.members, "_surface")

    def point(self, name: str, node: int) -> str:
        if name not in self.mesh.node_groups:
            self.mesh.node_groups[name] = [node]
            self.mesh.elements.append(Element("vertex", [node], {name}))
        return name

    def supports(self, name: str, nodes: list[int]) -> tuple[list[str], list[int]]:
        """The groups that these nodes are, and mid-side nodes which are in none."""
        if name in self.supported:
            return self.supported[name]
        within = set(nodes)
        facets = self.deck.facets_within(within)
        groups = [self.boundary(name, facets, "_nodes")] if facets else []
        left = within.difference(*facets)
        edges = self.edges_within(within, left) if self.deck.dimension == 3 else []
        if edges:
            groups.append(name + "_edges" * bool(groups))
            self.add_facets(groups[-1], edges, 1)
            left = left.difference(*edges)
        corners = sorted(left & self.corners)
        alone = len(corners) == 1 and not groups
        groups += [self.point(name if alone else f"{name}_{self.labels[n]}", n)
                   for n in corners]
        self.supported[name] = groups, sorted(
            left & self.used - self.corners)
        return self.supported[name]

    def edges_within(self, nodes: set[int], new: set[int]) -> list[list[int]]:
        """Edges of free faces between these nodes that have new ones."""
        found = {}
        for facet, _ in self.deck.free_facets():
            n = 3 if len(facet) in (3, 6) else 4
            for i in range(n):
                edge = [facet[i], facet[(i + 1) % n], *facet[n + i:n + i + 1]]
                if nodes.issuperset(edge) and not new.isdisjoint(edge):
                    found[frozenset(edge)] = edge
        return list(found.values())

    def add_node_sets(self) -> None:
        """Those that the case has not asked for keep their names where they are
        one node or boundaries, but not of whole bodies."""
        bodies = [{n for c in cells for n in self.deck.cells[c].nodes}
                  for cells in self.body_cells.values()]
        for scope in self.deck.scopes.values():
            for group in scope.sets["node"].values():
                name = self.deck.title(scope, group.name)
                nodes = set(group.members)
                facets = self.deck.facets_within(nodes)
                if name in self.supported or name in self.mesh.node_groups:
                    continue
                if len(nodes) == 1 and nodes <= self.corners:
                    self.point(name, group.members[0])
                elif facets and not any(nodes >= body for body in bodies):
                    self.boundary(name, facets, "_nodes")
                elif nodes & self.corners:
                    self.mesh.node_groups[name] = group.members
