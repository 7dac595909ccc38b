#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Converts a mesh with named groups into the MSH format that contact reads.

    convert.py [--bodies NAME,NAME] IN OUT.msh

IN is a MED file (Code_Aster, Salome; 2.2 to 4), an Abaqus deck (.inp; what it has
beside the mesh goes to OUT.prm) or of any format that meshio reads. Groups keep
their names: in 2-D groups of faces become bodies and groups of lines the parts of
their boundaries, in 3-D (hexahedra) groups of volumes and groups of faces; point
elements and groups of corners of cells become points. Every cell needs one body;
--bodies says which groups of cells are bodies where others overlap with them.
Elements of first and second order keep
their nodes, but contact takes the corners alone: what is round is reported,
with the circle for Mesh/Arcs (in 3-D the sphere, cylinder or cone for
Mesh/Spheres, Cylinders or Cones) where a group is one, and with a note on stderr
where it becomes straight. Exit status: 0, or 2 if IN cannot be converted.

For Debian's Python with python3-h5py (MED) and python3-meshio (the others); Abaqus
decks need neither.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

sys.dont_write_bytecode = True
# Of the folder of this file.
import abaqus  # noqa: E402
import roundness  # noqa: E402
from named_mesh import TYPES, BadMesh, Element, Mesh, msh_text  # noqa: E402

# MED's name -> meshio's.
MED_TYPES = {"PO1": "vertex", "SE2": "line", "SE3": "line3", "TR3": "triangle",
             "TR6": "triangle6", "TR7": "triangle7", "QU4": "quad",
             "QU8": "quad8", "QU9": "quad9", "TE4": "tetra", "T10": "tetra10",
             "PE6": "wedge", "PY5": "pyramid", "HE8": "hexahedron",
             "H20": "hexahedron20", "H27": "hexahedron27"}
# The centres of the faces of a hexahedron in VTK's order, by their place in
# MED's.
MED_ORDER = {"hexahedron27": [*range(20), 24, 22, 21, 23, 20, 25, 26]}
MED_ENDS = (".med", ".mmed", ".rmed")


# ------------------------------------------------------------------------ MED

def only(group, what: str, path: Path):
    """The one member of a group of the file."""
    if len(group) != 1:
        raise BadMesh(f"the file has {len(group)} {what}: "
                      + ", ".join(group), str(path), "write a file with one")
    return next(iter(group.values()))


def read_families(families) -> dict[int, list[str]]:
    """Number of a family -> its groups, names of 80 characters each: a row for
    each of them, before version 3 one after the other."""
    found = {}
    for family in families.values():
        names = []
        if "GRO" in family:
            text = family["GRO/NOM"][()].tobytes()
            names = [text[80 * i:80 * i + 80]
                     for i in range(int(family["GRO"].attrs["NBR"]))]
        found[int(family.attrs["NUM"])] = [
            name.split(b"\0")[0].decode(errors="replace").strip()
            for name in names]
    return found


def check_version(file, path: Path) -> None:
    """The layout that is read is that of 2.2 and later."""
    if "INFOS_GENERALES" not in file:
        raise BadMesh("the file says no version of MED", str(path),
                      "write it again, as MED 3 or 4")
    version = [int(file["INFOS_GENERALES"].attrs[name]) for name in
               ("MAJ", "MIN")]
    if not [2, 2] <= version < [5, 0]:
        raise BadMesh("MED {}.{} is not read, only 2.2 to 4".format(*version),
                      str(path), "convert it to MED 3 or 4: medimport IN OUT "
                      "(of Debian's libmed-tools) does so with older files")


def read_med(path: Path) -> Mesh:
    """A MED file is an HDF5 file, its layout that of MED-fichier 2.2 to 4. An
    element or node has one family, a family several groups. Before version 3
    families stand with the mesh, ESP (the number of coordinates) may be
    missing, and lines may stand as edges of faces."""
    try:
        import h5py
    except ImportError:
        raise BadMesh("h5py is missing", sys.executable,
                      "apt-get install python3-h5py") from None
    with h5py.File(path, "r") as file:
        check_version(file, path)
        data = only(file["ENS_MAA"], "meshes", path)
        name = data.name.split("/")[-1]
        families = data["FAS"] if "FAS" in data else file["FAS/" + name]
        if "NOE" not in data:  # since version 3 a mesh has time steps
            data = only(data, "time steps of the mesh", path)

        # All of the first coordinate, all of the second, ...
        n = int(data["NOE/COO"].attrs["NBR"])
        mesh = Mesh(data["NOE/COO"][()].reshape(-1, n).T.tolist())
        names = read_families(families.get("NOEUD", {}))
        for node, family in enumerate(data["NOE"].get("FAM", ())):
            for group in names.get(int(family), ()):
                mesh.node_groups.setdefault(group, []).append(node)
        names = read_families(families.get("ELEME", {}))
        blocks = [block for kinds in ("MAI", "FAC", "ARE") if kinds in data
                  for block in data[kinds].items()]
        for kind, block in blocks:
            n = int(block["NOD"].attrs["NBR"])
            groups = [names.get(int(f), ()) for f in block.get("FAM", [0] * n)]
            name = MED_TYPES.get(kind, kind)
            nodes = block["NOD"][()].reshape(-1, n).T - 1
            mesh.add(name, nodes[:, MED_ORDER.get(name, slice(None))], groups,
                     path)
    return mesh


# ------------------------------------------------------------- other formats

def block_groups(mesh, number: int) -> list[set[str]]:
    """The groups of each element of a block of meshio's, from wherever the
    format keeps them."""
    groups = [set() for _ in mesh.cells[number].data]

    # gmsh: tags, whose names are told apart by dimension.
    if "gmsh:physical" in mesh.cell_data:
        dimension = TYPES[mesh.cells[number].type][1]
        names = {tag: name for name, (tag, d) in mesh.field_data.items()
                 if d == dimension}
        for i, tag in enumerate(mesh.cell_data["gmsh:physical"][number]):
            groups[i].update({names[tag]} if tag in names else ())

    # Exodus, ...: sets of elements; meshio's own ones have a colon.
    for name, blocks in mesh.cell_sets.items():
        if ":" not in name and blocks[number] is not None:
            for i in blocks[number]:
                groups[i].add(name)
    return groups


def read_by_meshio(path: Path) -> Mesh:
    try:
        import meshio
    except ImportError:
        raise BadMesh("meshio is missing", sys.executable,
                      "apt-get install python3-meshio") from None
    found = meshio.read(path)
    mesh = Mesh(found.points.tolist())
    for number, block in enumerate(found.cells):
        known = block.type in TYPES
        mesh.add(block.type, block.data,
                 block_groups(found, number) if known else (), path)
    for name, nodes in found.point_sets.items():
        mesh.node_groups[name] = [int(node) for node in nodes]
    return mesh


# ---------------------------------------------------------------- both of them

def read(path: Path, bodies: list[str]) -> tuple[Mesh, abaqus.Case | None]:
    """The mesh, and of an Abaqus deck the case."""
    if not path.is_file():
        raise BadMesh("the file does not exist", str(path), "check the name")
    end = path.suffix.lower()
    try:
        if end == ".inp":
            return abaqus.read(path, bodies)
        return (read_med if end in MED_ENDS else read_by_meshio)(path), None
    except BadMesh:
        raise
    # Readers are many, and each has errors of its own.
    except (Exception, SystemExit) as reason:
        raise BadMesh(f"the mesh cannot be read: {reason!r}", str(path),
                      "write it again, as MED or in another format of "
                      "meshio's") from None


CORNERS = {"triangle": 3, "quad": 4, "tetra": 4, "hexahedron": 8, "wedge": 6,
           "pyramid": 5}


def name_points(mesh: Mesh) -> None:
    """A point element for each node of a group of nodes, if all are corners."""
    taken = {n for e in mesh.elements for n in e.groups}
    corners = {int(n) for e in mesh.elements if e.dimension == mesh.dimension
               for n in e.nodes[:CORNERS[e.kind.rstrip("0123456789")]]}
    for name, nodes in sorted(mesh.node_groups.items()):
        if name in taken:
            continue
        if corners.issuperset(map(int, nodes)):
            mesh.elements += [Element("vertex", [n], {name}) for n in nodes]
        else:
            print(f"left out: the group '{name}' of {len(nodes)} nodes, as some "
                  "are in the middle of edges; a boundary is a group of "
                  + ("lines" if mesh.dimension == 2 else "faces"))


def check(mesh: Mesh, path: Path, bodies: list[str]) -> None:
    """Every cell has one body, and plane cells are in one plane. Drops the groups
    of cells that are not in @p bodies, if this names any."""
    cells = mesh.of_dimension(mesh.dimension)
    cell, cell_plural = (("face", "faces") if mesh.dimension == 2
                         else ("volume", "volumes"))
    if not cells:
        raise BadMesh("the mesh has no faces", str(path),
                      "mesh surfaces with triangles or quadrangles, or volumes "
                      "with tetrahedra or hexahedra")
    known = sorted({name for element in cells for name in element.groups})
    there = f"groups of {cell_plural}: " + (", ".join(known) or "none")
    for name in bodies:
        if name not in known:
            raise BadMesh(f"no {cell} is in the group '{name}'", str(path), there)
    for element in cells:
        if bodies:
            element.groups &= set(bodies)
        if len(element.groups) != 1:
            names = ", ".join(sorted(element.groups)) or "none"
            raise BadMesh(f"a {cell} needs one body, but its groups are: " + names,
                          f"{path}, {cell} with the corner "
                          f"{mesh.points[element.nodes[0]]}",
                          f"put each {cell} in one group, or choose the bodies "
                          f"with --bodies NAME,NAME; {there}")
    if mesh.dimension == 2:
        check_plane(mesh, path)
    shapes = {e.kind.rstrip("0123456789") for e in mesh.of_dimension(3)}
    for face in mesh.of_dimension(2) if mesh.dimension == 3 else ():
        if face.groups and face.kind.startswith("triangle") \
                and "tetra" not in shapes:
            raise BadMesh(f"the group '{min(face.groups)}' has triangles, which "
                          "are no faces of hexahedra", str(path),
                          "mesh the surfaces of volumes with quadrangles")


def check_plane(mesh: Mesh, path: Path) -> None:
    if len(mesh.points[0]) == 3:
        used = [mesh.points[node] for face in mesh.of_dimension(2)
                for node in face.nodes]
        z = [point[2] for point in used]
        # As exact as coordinates with nine digits are.
        if max(z) - min(z) > 1e-9 * max(abs(c) for p in used for c in p):
            raise BadMesh(f"the mesh is not plane: z from {min(z):g} to "
                          f"{max(z):g}", str(path),
                          "turn it into a plane of constant z, or mesh volumes")


def write(texts: dict[Path, str]) -> None:
    """All of the files, or none of them."""
    parts = {path: path.with_name(path.name + ".part") for path in texts}
    try:
        for path, part in parts.items():
            part.write_text(texts[path])
        for path, part in parts.items():
            part.replace(path)
    finally:
        for part in parts.values():
            part.unlink(missing_ok=True)


def describe(mesh: Mesh) -> None:
    """What the program will find."""
    for dimension in reversed(range(mesh.dimension + 1)):
        counts: dict[str, int] = {}
        for e in mesh.elements:
            for name in e.groups if e.dimension == dimension else ():
                counts[name] = counts.get(name, 0) + 1
        print(f"{mesh.kinds[dimension]}: " + (", ".join(
            f"{name} ({n})" for name, n in sorted(counts.items())) or "none"))


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("input", metavar="IN", type=Path)
    parser.add_argument("output", metavar="OUT.msh", type=Path)
    parser.add_argument("--bodies", metavar="NAME,NAME", default="",
                        help="the groups of faces (of volumes) that are bodies; "
                        "all without")
    arguments = parser.parse_args()
    bodies = [name for name in arguments.bodies.split(",") if name]
    mesh, case = read(arguments.input, bodies)
    name_points(mesh)
    check(mesh, arguments.input, bodies)
    texts = {arguments.output: msh_text(mesh)}
    if case and case.is_one:
        prm = arguments.output.with_suffix(".prm")
        case.check_place(prm)
        texts[prm] = case.prm(arguments.output)
    write(texts)
    for line in case.report() if case else ():
        print(line)
    if not (case and case.is_round):
        roundness.report(mesh)
    describe(mesh)
    for path in list(texts)[1:]:
        print(f"case: {path}")


if __name__ == "__main__":
    try:
        main()
    except (BadMesh, OSError) as error:
        print(error, file=sys.stderr)
        sys.exit(2)
