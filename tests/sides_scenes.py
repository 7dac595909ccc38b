# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of bodies that touch around edges, in 2-D and 3-D, for the scripts
beside this one: bodies cut out of grids, contact groups cut into their smooth
sides, a scene that is turned or mirrored, and its nodal contact forces."""

import itertools
import math
import pathlib

from block_scenes import rows, run, violations

INCREMENTS = 2
FEATURE_ANGLE = 35  # degrees between the normals of two facets
AXES = "xyz"
QUADRANGLE = ((0, 0), (1, 0), (1, 1), (0, 1))
HEXAHEDRON = tuple((*c, k) for k in (0, 1) for c in QUADRANGLE)
KINDS = {2: {2: 3, 1: 1}, 3: {3: 5, 2: 3}}


def divided(*parts):
    """Grid lines: place, number of cells, place, number of cells, place ..."""
    lines = [parts[0]]
    for n, end in zip(parts[1::2], parts[2::2]):
        begin = lines[-1]
        lines += [begin + (end - begin) * i / n for i in range(1, n)] + [end]
    return [float(x) for x in lines]


def product(matrix, vector):
    return tuple(sum(m * v for m, v in zip(row, vector)) for row in matrix)


def transposed(matrix):
    return [list(column) for column in zip(*matrix)]


def identity(dim):
    return [[float(i == j) for j in range(dim)] for i in range(dim)]


def turn(dim, mirrored):
    """An odd rotation, about all axes in 3-D, behind a reflection in x."""
    result = identity(dim)
    if mirrored:
        result[0][0] = -1.
    for (a, b), degrees in (((0, 1), 27.3), ((1, 2), 41.9),
                            ((0, 2), -63.1))[:1 if dim == 2 else 3]:
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        one = identity(dim)
        one[a][a], one[a][b], one[b][a], one[b][b] = c, -s, s, c
        result = [[sum(one[i][k] * result[k][j] for k in range(dim))
                   for j in range(dim)] for i in range(dim)]
    return result


class Body:
    """The cells of a grid whose centres are solid. Groups: {name: condition on
    the centre and the outward normal of a boundary facet of the grid}. A chart
    deforms the grid."""

    def __init__(self, name, lines, solid, groups, chart=None, young=1000.):
        self.name, self.young = name, young
        dim = len(lines)
        n = [len(line) - 1 for line in lines]
        corners = QUADRANGLE if dim == 2 else HEXAHEDRON
        chart = chart or (lambda *x: x)

        def centre(cell):
            return [(line[i] + line[i + 1]) / 2 for line, i in zip(lines, cell)]
        cells = [c for c in itertools.product(*map(range, n)) if solid(*centre(c))]
        filled = set(cells)
        self.nodes, self.cells, self.facets = [], [], {name: [] for name in groups}
        number = {}

        def node(key):
            if key not in number:
                number[key] = len(self.nodes)
                self.nodes.append(tuple(map(float, chart(
                    *(line[i] for line, i in zip(lines, key))))))
            return number[key]
        for cell in cells:
            self.cells.append([node(tuple(i + d for i, d in zip(cell, c)))
                               for c in corners])
        for number_of_cell, cell in enumerate(cells):
            for d, side in itertools.product(range(dim), (0, 1)):
                beyond = list(cell)
                beyond[d] += 2 * side - 1
                if tuple(beyond) in filled:
                    continue
                place = centre(cell)
                place[d] = lines[d][cell[d] + side]
                normal = [0] * dim
                normal[d] = 2 * side - 1
                facet = [node(tuple(i + e for i, e in zip(cell, c)))
                         for c in corners if c[d] == side]
                if dim == 3:
                    facet = self.around(facet, self.cells[number_of_cell])
                for name, inside in groups.items():
                    if inside(place, normal):
                        self.facets[name].append((facet, number_of_cell))
                        break

    @staticmethod
    def around(facet, cell):
        """The corners of a quadrangle one behind the other."""
        edges = {frozenset((a, b)) for a, b in
                 ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4),
                  (0, 4), (1, 5), (2, 6), (3, 7))}
        at = {node: i for i, node in enumerate(cell)}
        path = [facet[0]]
        while len(path) < 4:
            path.append(next(v for v in facet if v not in path and
                             frozenset((at[v], at[path[-1]])) in edges))
        return path

    def normal(self, facet, cell):
        """The unit normal of a facet that points out of its cell."""
        x = [self.nodes[v] for v in facet]
        if len(x) == 2:
            (x0, y0), (x1, y1) = x
            n = [y1 - y0, x0 - x1]
        else:
            a, b = ([p - q for p, q in zip(x[i + 2], x[i])] for i in (0, 1))
            n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                 a[0] * b[1] - a[1] * b[0]]
        inside = [sum(self.nodes[v][d] for v in self.cells[cell]) /
                  len(self.cells[cell]) for d in range(len(n))]
        middle = [sum(p[d] for p in x) / len(x) for d in range(len(n))]
        length = math.hypot(*n)
        if sum(m * (p - q) for m, p, q in zip(n, middle, inside)) < 0:
            length = -length
        return [m / length for m in n]

    def sides(self, group):
        """The facets of a group in parts that no feature edge parts."""
        facets = self.facets[group]
        normals = [self.normal(*facet) for facet in facets]
        of_edge = {}
        for k, (facet, _) in enumerate(facets):
            edges = [(v,) for v in facet] if len(facet) == 2 else \
                zip(facet, facet[1:] + facet[:1])
            for edge in edges:
                of_edge.setdefault(frozenset(edge), []).append(k)
        leader = list(range(len(facets)))

        def find(k):
            while leader[k] != k:
                k = leader[k]
            return k
        for together in of_edge.values():
            for a, b in itertools.combinations(together, 2):
                if sum(m * n for m, n in zip(normals[a], normals[b])) > \
                        math.cos(math.radians(FEATURE_ANGLE)):
                    leader[find(a)] = find(b)
        parts = {}
        for k, facet in enumerate(facets):
            parts.setdefault(find(k), []).append(facet)
        return list(parts.values())


class Scene:
    """Bodies, contact pairs as (slave, master) and displacements: {group:
    [(vector, history) ...]}, or the axes that a group is held along, as in "y";
    'spins': {group: history of a small rotation about the origin, 2-D}."""

    def __init__(self, bodies, pairs, moves, spins=None):
        self.bodies, self.pairs, self.moves = bodies, pairs, moves
        self.spins = spins or {}
        self.dim = len(bodies[0].nodes[0])

    def exchanged(self):
        return Scene(self.bodies, [pair[::-1] for pair in self.pairs],
                     self.moves, self.spins)

    def sides(self):
        """The number of smooth sides of all slaves."""
        return sum(len(body.sides(slave)) for slave, _ in self.pairs
                   for body in self.bodies if slave in body.facets)

    def write(self, name, cut, turned):
        """The mesh; returns the contact pairs, with a pair for each side of the
        slave if it is cut."""
        tags, nodes, elements, pairs = {}, [], [], []
        mirrored = determinant(turned) < 0

        def add(dim, group, corners):
            tag = tags.setdefault((dim, group), len(tags) + 1)
            elements.append((KINDS[self.dim][dim], tag, corners))
        for body in self.bodies:
            first = len(nodes) + 1
            nodes += [product(turned, x) for x in body.nodes]
            for cell in body.cells:
                if mirrored:
                    cell = [cell[0], cell[3], cell[2], cell[1]] \
                        if self.dim == 2 else cell[4:] + cell[:4]
                add(self.dim, body.name, [first + v for v in cell])
            for group, facets in body.facets.items():
                parts = [(group, facets)]
                if cut and group in (slave for slave, _ in self.pairs):
                    parts = [(f"{group}_{k}", part)
                             for k, part in enumerate(body.sides(group))]
                for part, of_part in parts:
                    for facet, _ in of_part:
                        add(self.dim - 1, part, [first + v for v in facet])
                pairs += [(part, master) for slave, master in self.pairs
                          if slave == group for part, _ in parts]
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames",
                 str(len(tags))]
        lines += [f'{d} {tag} "{group}"' for (d, group), tag in tags.items()]
        lines += ["$EndPhysicalNames", "$Nodes", str(len(nodes))]
        lines += [" ".join(map(repr, (i + 1, *x, 0.)[:4]))
                  for i, x in enumerate(nodes)]
        lines += ["$EndNodes", "$Elements", str(len(elements))]
        lines += [f"{i + 1} {kind} 2 {tag} {tag} " + " ".join(map(str, corners))
                  for i, (kind, tag, corners) in enumerate(elements)]
        lines += ["$EndElements", ""]
        pathlib.Path(f"{name}.msh").write_text("\n".join(lines))
        return pairs

    def solve(self, name, settings, cut=False, turned=None, **entries):
        """Run the scene. 'settings': entries of each contact pair. Returns
        a Result."""
        turned = turned or identity(self.dim)
        pairs = self.write(name, cut, turned)
        formulas = {d: [] for d in range(self.dim)}
        for group, ways in self.moves.items():
            held = isinstance(ways, str)
            for d in range(self.dim):
                if held and AXES[d] not in ways:
                    continue
                terms = []
                for vector, history in () if held else ways:
                    length = product(turned, vector)[d]
                    if length:
                        terms.append(f"({length!r})*{history}")
                if group in self.spins:
                    sign = -1 if determinant(turned) < 0 else 1
                    terms.append(f"{'-+'[d]}{'yx'[d]}*({sign})*"
                                 f"({self.spins[group]})")
                formulas[d].append(f"{group}: " + ("+".join(terms) or "0"))
        sections = ["Contact"] + [f"Contact {k}" for k in range(1, len(pairs))]
        case = {
            "Mesh/File": f"{name}.msh",
            "Solids/Young's modulus":
                ", ".join(f"{b.name}: {b.young!r}" for b in self.bodies),
            "Solids/Poisson's ratio":
                ", ".join(f"{b.name}: 0.3" for b in self.bodies),
            **{f"Boundary conditions/Displacement formula {AXES[d]}":
               "; ".join(of) for d, of in formulas.items()},
            "Solution/Increments": INCREMENTS, "Solution/Newton tolerance": 1e-10,
            "Solution/Geometry tolerance": 1e-9,
            "Output/Nodes": "true", "Output/Screen": "none", **entries}
        for section, (slave, master) in zip(sections, pairs):
            case.update({f"{section}/Slave": slave, f"{section}/Master": master,
                         **{f"{section}/{entry}": value
                            for entry, value in settings.items()}})
        pathlib.Path(f"output/{name}/nodes.csv").unlink(missing_ok=True)
        return Result(name, transposed(turned), *run(name, case))


def determinant(m):
    if len(m) == 2:
        return m[0][0] * m[1][1] - m[0][1] * m[1][0]
    return sum(m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] -
                          m[1][(i + 2) % 3] * m[2][(i + 1) % 3])
               for i in range(3))


class Result:
    """Nodal forces of contact and displacements of a run, turned back."""

    def __init__(self, name, back, status, said, summary):
        increments = summary.get("increments", [])
        self.status = status
        self.said = said.strip() or \
            increments and increments[-1].get("message") or "nothing"
        self.steps = sum(i["newton_iterations"] for i in increments)
        self.violated = {v.split(":")[0] for v in violations(summary)}
        self.forces, self.of_body, self.moments = {}, {}, {}
        if status not in (0, 1):
            return
        axes = AXES[:len(back)]
        unit = "N_per_mm" if len(axes) == 2 else "N"
        for row in rows(name, "nodes.csv"):
            place, displacement, force = (
                product(back, [row[column.format(c, C)] for c, C in
                               zip(axes, axes.upper())])
                for column in ("{1}_mm", "displacement_{0}_mm",
                               "contact_force_{0}_" + unit))
            body = row["body"]
            self.forces[body, *(round(x, 6) + 0. for x in place)] = force
            place = tuple(map(sum, zip(place, displacement)))
            moment = [place[a] * force[b] - place[b] * force[a]
                      for a, b in itertools.combinations(range(len(place)), 2)]
            for of, vector in (self.of_body, force), (self.moments, moment):
                of[body] = tuple(map(sum, zip(of.get(body, (0.,) * len(vector)),
                                              vector)))

    def converged(self):
        """Whether it did, without a violated invariant but the depth: the meshes
        are coarse, and the forces are compared all the same."""
        return self.status == 0 or \
            self.status == 1 and self.violated == {"depth"}

    def largest(self):
        return max(math.hypot(*force) for force in self.forces.values())

    def imbalance(self):
        """Of the forces of all bodies, relative to the largest nodal one."""
        return math.hypot(*map(sum, zip(*self.of_body.values()))) / self.largest()

    def difference(self, other):
        """The largest one of nodal forces, relative to the largest force."""
        if self.forces.keys() != other.forces.keys():
            return math.nan
        return max(math.dist(force, other.forces[key])
                   for key, force in self.forces.items()) / \
            max(self.largest(), other.largest())

    def difference_of_totals(self, other, of_moments):
        """That of the forces on a body as a whole, or of their moments about the
        origin, relative to the largest of these."""
        mine, others = (result.moments if of_moments else result.of_body
                        for result in (self, other))
        return max(math.dist(vector, others[body])
                   for body, vector in mine.items()) / \
            max(math.hypot(*vector) for vector in others.values())
