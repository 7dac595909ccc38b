#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of the comparison: ssnp154_quads.msh, halved again and again.

    mesh.py FOLDER [--levels N]

Each level is written as level_N.msh (MSH 4.1, 4-node cells) for the contact
program and as level_N_1.npz and level_N_2.npz for the drivers of the peers: 4
and 8 nodes a cell. New nodes on the outline of the cylinder are moved to its
circle, mid-side nodes of 8-node cells too; all other edges are straight. That
is what the contact program makes of the .msh file if the three pieces of the
outline are in Mesh/Arcs (ARCS below): the geometry is the same.
"""

import argparse
import dataclasses
import pathlib

import meshio
import numpy as np

SOURCE = (pathlib.Path(__file__).resolve().parents[3] / "meshes" /
          "ssnp154_quads.msh")
CENTRE, RADIUS = np.array([0., 50.]), 50.
# Side_C is the piece between slave and load, which has no name in SOURCE.
ARCS = "; ".join(f"{name}: 0, 50, 50" for name in
                 ("Bottom_C", "Side_C", "Cap"))
BODIES = "Block", "Cylinder"


@dataclasses.dataclass
class Mesh:
    """Nodes, and by name the cells, the edges (corners first) and points."""
    nodes: np.ndarray
    cells: dict
    edges: dict
    points: dict

    def save(self, path):
        """A file for load()."""
        np.savez(path, nodes=self.nodes,
                 **{f"cells {n}": a for n, a in self.cells.items()},
                 **{f"edges {n}": a for n, a in self.edges.items()},
                 **{f"points {n}": a for n, a in self.points.items()})


def load(path):
    """The mesh of a file that save() has written."""
    groups = {"cells": {}, "edges": {}, "points": {}}
    with np.load(path) as file:
        for key in file.files:
            if key != "nodes":
                kind, name = key.split(" ", 1)
                groups[kind][name] = file[key]
        return Mesh(file["nodes"], **groups)


def on_circle(points):
    return abs(np.hypot(*(points - CENTRE).T) - RADIUS) < 1e-6 * RADIUS


def to_circle(points):
    rays = points - CENTRE
    return CENTRE + RADIUS * rays / np.linalg.norm(rays, axis=-1)[..., None]


def sides(cells):
    """The sides of quadrangles, n x 4 x 2, along the cells' circumference."""
    corners = cells[:, :4]
    return np.stack([corners, np.roll(corners, -1, axis=1)], axis=2)


def outline(cells):
    """The sides that only one cell has."""
    all_sides = sides(cells).reshape(-1, 2)
    _, first, count = np.unique(np.sort(all_sides), axis=0, return_index=True,
                                return_counts=True)
    return all_sides[first[count == 1]]


def read_source(path=SOURCE):
    """Level 0, its cells counter-clockwise."""
    data = meshio.read(path)
    nodes = data.points[:, :2]
    names = {(int(dim), int(tag)): name
             for name, (tag, dim) in data.field_data.items()}
    found = {}
    for block, tags in zip(data.cells, data.cell_data["gmsh:physical"]):
        dim = {"vertex": 0, "line": 1, "quad": 2}[block.type]
        for tag in np.unique(tags):
            found.setdefault((dim, names[dim, int(tag)]), []).append(
                block.data[tags == tag])
    groups = [{name: np.concatenate(parts).astype(int)
               for (d, name), parts in found.items() if d == dim}
              for dim in range(3)]
    points, edges, cells = groups
    for name, quads in cells.items():
        x, y = nodes[quads].transpose(2, 0, 1)
        area = sum(x[:, i] * y[:, (i + 1) % 4] - x[:, (i + 1) % 4] * y[:, i]
                   for i in range(4))
        cells[name] = np.where(area[:, None] > 0, quads, quads[:, ::-1])

    round_sides = outline(cells["Cylinder"])
    round_sides = round_sides[on_circle(nodes[round_sides[:, 0]]) &
                              on_circle(nodes[round_sides[:, 1]])]
    named = {tuple(sorted(edge)) for name in ("Bottom_C", "Cap")
             for edge in edges[name].tolist()}
    edges["Side_C"] = np.array([s for s in round_sides
                                if tuple(sorted(s.tolist())) not in named])
    return Mesh(nodes, cells, edges, {n: p.ravel() for n, p in points.items()})


def with_mid_sides(mesh):
    """The mesh with 8-node cells and 3-node edges."""
    nodes, number = [mesh.nodes], {}

    def mid_side(a, b):
        return number.setdefault((min(a, b), max(a, b)),
                                 len(mesh.nodes) + len(number))

    cells = {name: np.hstack([quads, [[mid_side(*side) for side in quad]
                                      for quad in sides(quads).tolist()]])
             for name, quads in mesh.cells.items()}
    edges = {name: np.array([[a, b, mid_side(a, b)]
                             for a, b in lines[:, :2].tolist()])
             for name, lines in mesh.edges.items()}
    middles = mesh.nodes[np.array(list(number))].mean(axis=1)
    curved = np.unique(np.concatenate(
        [edges[name][:, 2] for name in ("Bottom_C", "Side_C", "Cap")]))
    curved -= len(mesh.nodes)
    middles[curved] = to_circle(middles[curved])
    nodes.append(middles)
    return Mesh(np.concatenate(nodes), cells, edges, mesh.points)


def halved(mesh):
    """Each cell in four, by the mid-side nodes of with_mid_sides and the point
    in the middle of its 8-node cell."""
    fine = with_mid_sides(mesh)
    nodes, cells, total = [fine.nodes], {}, len(fine.nodes)
    for name, c in fine.cells.items():
        nodes.append(fine.nodes[c[:, 4:]].sum(axis=1) / 2 -
                     fine.nodes[c[:, :4]].sum(axis=1) / 4)
        centre = total + np.arange(len(c))
        total += len(c)
        cells[name] = np.concatenate(
            [np.stack([c[:, i], c[:, 4 + i], centre, c[:, 4 + (i + 3) % 4]],
                      axis=1) for i in range(4)])
    edges = {name: np.concatenate([e[:, [0, 2]], e[:, [2, 1]]])
             for name, e in fine.edges.items()}
    return Mesh(np.concatenate(nodes), cells, edges, mesh.points)


def edge_loads(mesh, name, total, linear=False):
    """Nodes of a boundary and their parts of a force spread evenly over it, by
    the shape functions of its edges, or by the linear ones of their corners."""
    xi, weights = np.polynomial.legendre.leggauss(4)
    edges = mesh.edges[name]
    if edges.shape[1] == 2:
        shape = np.array([(1 - xi) / 2, (1 + xi) / 2])
        slope = np.array([0 * xi - .5, 0 * xi + .5])
    else:
        shape = np.array([xi * (xi - 1) / 2, xi * (xi + 1) / 2, 1 - xi**2])
        slope = np.array([xi - .5, xi + .5, -2 * xi])
    lengths = shape if not linear else np.array(
        [(1 - xi) / 2, (1 + xi) / 2] + [0 * xi] * (edges.shape[1] - 2))
    x = mesh.nodes[edges]
    speed = np.linalg.norm(np.einsum("end,nq->eqd", x, slope), axis=2)
    parts = np.einsum("eq,nq,q->en", speed, lengths, weights)
    loads = np.bincount(edges.ravel(), parts.ravel(), len(mesh.nodes))
    loaded = np.unique(edges)
    return loaded, total * loads[loaded] / loads.sum()


def write_msh(mesh, path):
    """MSH 4.1 of 4-node cells: one entity for each group, all of one number."""
    groups = [(0, mesh.points, 15), (1, mesh.edges, 1), (2, mesh.cells, 3)]
    names = [(dim, name, kind, elements.reshape(len(elements), -1) + 1)
             for dim, group, kind in groups
             for name, elements in group.items()]
    text = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames",
            str(len(names))]
    text += [f'{dim} {tag} "{name}"'
             for tag, (dim, name, _, _) in enumerate(names, 1)]
    text += ["$EndPhysicalNames", "$Entities",
             " ".join(str(len(group)) for _, group, _ in groups) + " 0"]
    for tag, (dim, _, _, elements) in enumerate(names, 1):
        x = mesh.nodes[np.unique(elements) - 1]
        low, high = x.min(axis=0), x.max(axis=0)
        box = [*low, 0] if dim == 0 else [*low, 0, *high, 0]
        text.append(f"{tag} " + " ".join(f"{value:.17g}" for value in box) +
                    f" 1 {tag}" + ("" if dim == 0 else " 0"))
    n = len(mesh.nodes)
    text += ["$EndEntities", "$Nodes", f"1 {n} 1 {n}",
             f"2 {len(names)} 0 {n}", *map(str, range(1, n + 1))]
    text += [f"{x:.17g} {y:.17g} 0" for x, y in mesh.nodes]
    n = sum(len(elements) for *_, elements in names)
    text += ["$EndNodes", "$Elements", f"{len(names)} {n} 1 {n}"]
    number = 0
    for tag, (dim, _, kind, elements) in enumerate(names, 1):
        text.append(f"{dim} {tag} {kind} {len(elements)}")
        for element in elements:
            number += 1
            text.append(" ".join(map(str, [number, *element])))
    path.write_text("\n".join(text + ["$EndElements", ""]))


def write_levels(folder, levels):
    """The files of levels 0 to LEVELS."""
    folder.mkdir(parents=True, exist_ok=True)
    mesh = read_source()
    for level in range(levels + 1):
        if level > 0:
            mesh = halved(mesh)
        write_msh(mesh, folder / f"level_{level}.msh")
        mesh.save(folder / f"level_{level}_1.npz")
        with_mid_sides(mesh).save(folder / f"level_{level}_2.npz")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--levels", type=int, default=2)
    options = parser.parse_args()
    write_levels(options.folder, options.levels)


if __name__ == "__main__":
    main()
