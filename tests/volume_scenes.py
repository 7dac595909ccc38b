# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of hexahedra for the scripts beside this one: mapped blocks, and plane
meshes with a layer of cells. MSH 2.2."""

import itertools
import pathlib
import subprocess

CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
           (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
KINDS = {0: 15, 1: 1, 2: 3, 3: 5}


class Volumes:
    """Blocks with the groups BODY, BODY_x0, BODY_x1, BODY_y0 ... and the points
    BODY_000 ... BODY_111 at their corners."""

    def __init__(self):
        self.nodes, self.elements, self.groups = [], [], {}
        self.places = {}

    def add(self, dimension, group, nodes):
        tag = self.groups.setdefault((dimension, group), len(self.groups) + 1)
        self.elements.append((KINDS[dimension], tag, nodes))

    def block(self, body, n, chart, sides=None, corners=None):
        """A block of n[0] x n[1] x n[2] cells, the image of the unit cube. By
        default each side is a group of its own, named x0 to z1, and each corner
        a point; else those of 'sides' and 'corners', as {name here: name of the
        group}. Blocks of one body share the nodes at one place."""
        number = {}
        for k, j, i in itertools.product(*(range(m + 1) for m in reversed(n))):
            place = chart(i / n[0], j / n[1], k / n[2])
            key = body, *(round(x, 9) for x in place)
            if key not in self.places:
                self.nodes.append(place)
                self.places[key] = len(self.nodes)
            number[i, j, k] = self.places[key]
        for k, j, i in itertools.product(*(range(m) for m in reversed(n))):
            self.add(3, body, [number[i + a, j + b, k + c]
                               for a, b, c in CORNERS])
        for d, side in itertools.product(range(3), range(2)):
            here = f"{'xyz'[d]}{side}"
            if sides is not None and here not in sides:
                continue
            group = here if sides is None else sides[here]
            others = [c for c in range(3) if c != d]
            for a, b in itertools.product(range(n[others[0]]),
                                          range(n[others[1]])):
                face = []
                for da, db in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    place = [0, 0, 0]
                    place[d] = side * n[d]
                    place[others[0]], place[others[1]] = a + da, b + db
                    face.append(number[tuple(place)])
                self.add(2, f"{body}_{group}", face)
        for corner in itertools.product(range(2), repeat=3):
            here = "".join(map(str, corner))
            if corners is not None and here not in corners:
                continue
            place = tuple(c * m for c, m in zip(corner, n))
            self.add(0, f"{body}_{here if corners is None else corners[here]}",
                     [number[place]])

    def half_space(self, body, n, size, outside, growth, chart):
        """A quarter of a half space z > 0: a cube of n cells a side and the given
        size, and layers of cells around it that grow out to a cube of the size
        'outside'; each place is moved by the chart. The groups x0, y0, z0 are
        the planes through the origin, of z = 0 that outside of the cube; 'middle'
        is that of the cube, 'far' the rest, the point 'origin'."""
        ratio = [1.]
        step = 1 / n
        while ratio[-1] < outside / size:
            step *= growth
            ratio.append(ratio[-1] + step)
        layers = len(ratio) - 1
        ratio = [1 + (r - 1) * (outside / size - 1) / (ratio[-1] - 1)
                 for r in ratio]
        self.block(body, (n, n, n),
                   lambda r, s, t: chart(size * r, size * s, size * t),
                   {"x0": "x0", "y0": "y0", "z0": "middle"}, {"000": "origin"})
        for d in range(3):
            a, b = (d + 1) % 3, (d + 2) % 3

            def place(r, s, t):
                x = [0., 0., 0.]
                scale = size * ratio[round(r * layers)]
                x[d], x[a], x[b] = scale, scale * s, scale * t
                return chart(*x)
            self.block(body, (layers, n, n), place,
                       {"x1": "far", "y0": f"{'xyz'[a]}0",
                        "z0": f"{'xyz'[b]}0"}, {})

    def write(self, name):
        pathlib.Path(f"{name}.msh").write_text(self.text())

    def text(self):
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
        return "\n".join(lines)


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
