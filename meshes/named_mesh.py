# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh with named groups, whatever file it comes from, and its MSH format."""

from __future__ import annotations

from dataclasses import dataclass, field

# Name of a type (meshio's) -> gmsh's type, dimension, number of nodes that
# gmsh's type has.
TYPES = {"vertex": (15, 0, 1), "line": (1, 1, 2), "line3": (8, 1, 3),
         "triangle": (2, 2, 3), "triangle6": (9, 2, 6), "triangle7": (9, 2, 6),
         "quad": (3, 2, 4), "quad8": (16, 2, 8), "quad9": (10, 2, 9),
         "tetra": (4, 3, 4), "tetra10": (11, 3, 10),
         "wedge": (6, 3, 6), "pyramid": (7, 3, 5),
         "hexahedron": (5, 3, 8), "hexahedron20": (17, 3, 20),
         "hexahedron27": (12, 3, 27)}

# Where gmsh's order is another one: the nodes by their place in meshio's, which
# is VTK's.
GMSH_ORDER = {"tetra10": [*range(8), 9, 8],
              "hexahedron20": [*range(8), 8, 11, 16, 9, 17, 10, 18, 19, 12, 15,
                               13, 14]}
GMSH_ORDER["hexahedron27"] = GMSH_ORDER["hexahedron20"] + [24, 22, 20, 21, 23,
                                                           25, 26]

# Names of volumes that contact does not take, of meshio's and of MED.
OTHER_VOLUMES = ("wedge15", "wedge18", "pyramid13", "pyramid14", "P15", "P18",
                 "P13")


class BadMesh(Exception):
    """What is wrong, where, and the remedy, as the program says it."""

    def __init__(self, what: str, where: str, remedy: str):
        super().__init__(f"error:  {what}\nwhere:  {where}\nremedy: {remedy}")


@dataclass
class Element:
    kind: str  # a name in TYPES
    nodes: list[int]
    groups: set[str] = field(default_factory=set)

    @property
    def dimension(self) -> int:
        return TYPES[self.kind][1]


@dataclass
class Mesh:
    points: list[list[float]]
    elements: list[Element] = field(default_factory=list)
    node_groups: dict[str, list[int]] = field(default_factory=dict)

    @property
    def dimension(self) -> int:
        """That of its bodies: 3 if it has volumes."""
        return max([2] + [e.dimension for e in self.elements])

    @property
    def kinds(self) -> tuple[str, ...]:
        """What groups are, by dimension."""
        return ("points", "boundaries", "bodies") if self.dimension == 2 else \
            ("points", "curves", "boundaries", "bodies")

    def of_dimension(self, dimension: int) -> list[Element]:
        return [e for e in self.elements if e.dimension == dimension]

    def add(self, kind: str, nodes, groups, where) -> None:
        """A block of equal elements with the groups of each."""
        if kind.startswith(OTHER_VOLUMES):
            raise BadMesh("the mesh has prisms or pyramids of second order "
                          f"(elements of type {kind})", str(where),
                          "mesh volumes with tetrahedra of 4 or 10 nodes, with "
                          "hexahedra of 8, 20 or 27, or with prisms and pyramids "
                          "of first order, which contact splits")
        if kind not in TYPES:
            raise BadMesh(f"the mesh has elements of type {kind}", str(where),
                          "mesh a plane surface with lines, triangles and "
                          "quadrangles, or volumes with tetrahedra or hexahedra, "
                          "of first or second order")
        self.elements += [
            Element(kind, [int(n) for n in numbers[:TYPES[kind][2]]], set(names))
            for numbers, names in zip(nodes, groups)]


def msh_text(mesh: Mesh) -> str:
    """MSH 2.2, where an element stands once for each of its groups."""
    names = sorted({(e.dimension, name) for e in mesh.elements
                    for name in e.groups})
    tags = {name: tag for tag, name in enumerate(names, 1)}
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat",
             "$PhysicalNames", str(len(names))]
    lines += [f'{dimension} {tag} "{name}"'
              for (dimension, name), tag in tags.items()]
    lines += ["$EndPhysicalNames", "$Nodes", str(len(mesh.points))]
    for number, point in enumerate(mesh.points, 1):
        x, y, z = [*point, 0.0, 0.0][:3]
        lines.append(f"{number} {x!r} {y!r} {z!r}")
    rows = [(TYPES[e.kind][0], tags[e.dimension, name],
             [e.nodes[i] for i in GMSH_ORDER.get(e.kind, range(len(e.nodes)))])
            for e in mesh.elements for name in sorted(e.groups)]
    lines += ["$EndNodes", "$Elements", str(len(rows))]
    for number, (kind, tag, nodes) in enumerate(rows, 1):
        lines.append(f"{number} {kind} 2 {tag} {tag} "
                     + " ".join(str(node + 1) for node in nodes))
    return "\n".join(lines + ["$EndElements", ""])
