# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of hexahedra for the scripts beside this one: mapped blocks, and plane
meshes with a layer of cells. MSH 2.2."""

import itertools
import pathlib
import subprocess

CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
           (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
KINDS = {0: 15, 2: 3, 3: 5}


class Volumes:
    """Blocks with the groups BODY, BODY_x0, BODY_x1, BODY_y0 ... and the points
    BODY_000 ... BODY_111 at their corners."""

    def __init__(self):
        self.nodes, self.elements, self.groups = [], [], {}

    def add(self, dimension, group, nodes):
        tag = self.groups.setdefault((dimension, group), len(self.groups) + 1)
        self.elements.append((KINDS[dimension], tag, nodes))

    def block(self, body, n, chart):
        number = {}
        for k, j, i in itertools.product(*(range(m + 1) for m in reversed(n))):
            self.nodes.append(chart(i / n[0], j / n[1], k / n[2]))
            number[i, j, k] = len(self.nodes)
        for k, j, i in itertools.product(*(range(m) for m in reversed(n))):
            self.add(3, body, [number[i + a, j + b, k + c]
                               for a, b, c in CORNERS])
        for d, side in itertools.product(range(3), range(2)):
            others = [c for c in range(3) if c != d]
            for a, b in itertools.product(range(n[others[0]]),
                                          range(n[others[1]])):
                face = []
                for da, db in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    place = [0, 0, 0]
                    place[d] = side * n[d]
                    place[others[0]], place[others[1]] = a + da, b + db
                    face.append(number[tuple(place)])
                self.add(2, f"{body}_{'xyz'[d]}{side}", face)
        for corner in itertools.product(range(2), repeat=3):
            place = tuple(c * m for c, m in zip(corner, n))
            self.add(0, f"{body}_" + "".join(map(str, corner)),
                     [number[place]])

    def write(self, name):
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
                 str(len(self.groups))]
        lines += [f'{d} {tag} "{g}"' for (d, g), tag in self.groups.items()]
        lines += ["$EndPhysicalNames", "$Nodes", str(len(self.nodes))]
        lines += [f"{i + 1} {x!r} {y!r} {z!r}"
                  for i, (x, y, z) in enumerate(self.nodes)]
        lines += ["$EndNodes", "$Elements", str(len(self.elements))]
        lines += [f"{i + 1} {kind} 2 {tag} {tag} " + " ".join(map(str, nodes))
                  for i, (kind, tag, nodes) in enumerate(self.elements)]
        lines += ["$EndElements", ""]
        pathlib.Path(f"{name}.msh").write_text("\n".join(lines))


def read_plane(file):
    """Names, nodes and elements of a plane mesh, by gmsh as MSH 2.2."""
    subprocess.run(["gmsh", "-0", "-format", "msh22", str(file), "-o",
                    "plane.msh"], check=True, capture_output=True)
    lines = pathlib.Path("plane.msh").read_text().split("\n")

    def section(name):
        first = lines.index(f"${name}")
        return lines[first + 2:first + 2 + int(lines[first + 1])]
    names = {}
    for line in section("PhysicalNames"):
        dimension, tag, name = line.split(maxsplit=2)
        names[int(dimension), int(tag)] = name.strip('"')
    nodes = {}
    for line in section("Nodes"):
        number, x, y, _ = line.split()
        nodes[int(number)] = float(x), float(y)
    elements = []
    for line in section("Elements"):
        words = [int(word) for word in line.split()]
        elements.append((words[1], words[3], words[3 + words[2]:]))
    return names, nodes, elements


def layer(file, depth):
    """A plane mesh of quadrangles as one layer of cells: lines become surfaces,
    points two points, NAME_0 and NAME_1; the groups Front and Back."""
    names, nodes, elements = read_plane(file)
    mesh = Volumes()
    used = sorted({n for _, _, connected in elements for n in connected})
    first = {n: i + 1 for i, n in enumerate(used)}
    second = {n: i + 1 + len(used) for i, n in enumerate(used)}
    mesh.nodes = [(*nodes[n], z) for z in (0., depth) for n in used]
    for kind, tag, connected in elements:
        front = [first[n] for n in connected]
        back = [second[n] for n in connected]
        if kind == 15:
            mesh.add(0, names[0, tag] + "_0", front)
            mesh.add(0, names[0, tag] + "_1", back)
        elif kind == 1:
            mesh.add(2, names[1, tag], front + back[::-1])
        else:
            mesh.add(3, names[2, tag], front + back)
            mesh.add(2, "Front", front)
            mesh.add(2, "Back", back)
    return mesh
