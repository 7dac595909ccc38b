# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of tetrahedra beside hexahedra, for the scripts beside this one. MSH
2.2."""

import itertools
import pathlib

from volume_scenes import CORNERS

EDGES = ((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))  # in gmsh's order
KINDS = {(0, 1): 15, (2, 3): 2, (2, 6): 9, (2, 4): 3, (3, 4): 4, (3, 10): 11,
         (3, 8): 5}


class Solid:
    """Blocks, each the image of a unit cube, whose cells are hexahedra or six
    tetrahedra of 4 or 10 nodes; sides are the groups BODY_x0, BODY_x1, ..., the
    corners of a block the points BODY_000 to BODY_111 if they are asked for."""

    def __init__(self):
        self.nodes, self.elements, self.groups = [], [], {}

    def add(self, dimension, group, nodes):
        tag = self.groups.setdefault((dimension, group), len(self.groups) + 1)
        self.elements.append((KINDS[dimension, len(nodes)], tag, nodes))

    def block(self, body, n, chart, nodes_of_cell=4, points=False):
        """Nodes are at half steps."""
        number = {}

        def node(place):
            if place not in number:
                self.nodes.append(chart(*(c / (2 * m)
                                          for c, m in zip(place, n))))
                number[place] = len(self.nodes)
            return number[place]

        def simplex(dimension, group, corners):
            nodes = [node(c) for c in corners]
            if nodes_of_cell == 10:
                nodes += [node(tuple((a + b) // 2 for a, b in zip(
                    corners[i], corners[j])))
                          for i, j in EDGES[:3 * (dimension - 1)]]
            self.add(dimension, group, nodes)
        for i in itertools.product(*(range(0, 2 * m, 2) for m in n)):
            if nodes_of_cell == 8:
                self.add(3, body, [node(tuple(a + 2 * b for a, b in zip(i, c)))
                                   for c in CORNERS])
                continue
            for order in itertools.permutations(range(3)):
                path = [i]
                for d in order:
                    path.append(tuple(c + 2 * (k == d)
                                      for k, c in enumerate(path[-1])))
                simplex(3, body, path)
        for d, side in itertools.product(range(3), range(2)):
            group = f"{body}_{'xyz'[d]}{side}"
            others = [range(0, 2 * m, 2) for k, m in enumerate(n) if k != d]
            for i in itertools.product(*others):
                def at(a, b):
                    place = [i[0] + a, i[1] + b]
                    place.insert(d, 2 * n[d] * side)
                    return tuple(place)
                if nodes_of_cell == 8:
                    self.add(2, group, [node(at(*c)) for c in
                                        ((0, 0), (2, 0), (2, 2), (0, 2))])
                else:
                    simplex(2, group, [at(0, 0), at(2, 0), at(2, 2)])
                    simplex(2, group, [at(0, 0), at(0, 2), at(2, 2)])
        for corner in itertools.product(range(2), repeat=3) if points else ():
            self.add(0, f"{body}_{''.join(map(str, corner))}",
                     [node(tuple(2 * c * m for c, m in zip(corner, n)))])
        return number

    def text(self):
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
                 str(len(self.groups))]
        lines += [f'{d} {tag} "{g}"' for (d, g), tag in self.groups.items()]
        lines += ["$EndPhysicalNames", "$Nodes", str(len(self.nodes))]
        lines += [f"{i + 1} " + " ".join(map(repr, p))
                  for i, p in enumerate(self.nodes)]
        lines += ["$EndNodes", "$Elements", str(len(self.elements))]
        lines += [f"{i + 1} {kind} 2 {tag} {tag} " + " ".join(map(str, nodes))
                  for i, (kind, tag, nodes) in enumerate(self.elements)]
        lines += ["$EndElements", ""]
        return "\n".join(lines)

    def write(self, name):
        pathlib.Path(f"{name}.msh").write_text(self.text())
