# SPDX-License-Identifier: LGPL-2.1-or-later
"""MED files by the library of that format (MED-fichier), of Debian's python3-med."""

import ctypes

from med.medenum import (MED_ACC_CREAT, MED_CARTESIAN, MED_CELL,
                         MED_FULL_INTERLACE, MED_NO_DT, MED_NO_IT, MED_NODAL,
                         MED_NODE, MED_NONE, MED_POINT1, MED_QUAD4, MED_QUAD8,
                         MED_QUAD9, MED_SEG2, MED_SEG3, MED_SORT_DTIT, MED_TRIA3,
                         MED_TRIA6, MED_TRIA7, MED_UNSTRUCTURED_MESH)
from med.medfamily import MEDfamilyCr
from med.medfile import MEDfileClose, MEDfileOpen
from med.medmesh import (MEDCHAR, MEDFLOAT, MEDINT, MEDmeshCr,
                         MEDmeshElementConnectivityWr,
                         MEDmeshEntityFamilyNumberWr,
                         MEDmeshNodeCoordinateWr)

# MED's types by meshio's, for each kind of mesh.
LINEAR = {"vertex": MED_POINT1, "line": MED_SEG2, "triangle": MED_TRIA3,
          "quad": MED_QUAD4}
QUADRATIC = {"vertex": MED_POINT1, "line": MED_SEG3, "triangle": MED_TRIA6,
             "quad": MED_QUAD8}
CENTRED = {"vertex": MED_POINT1, "line": MED_SEG3, "triangle": MED_TRIA7,
           "quad": MED_QUAD9}


class Families:
    """MED's: every set of groups that occurs has a number."""

    def __init__(self, sign):
        self.sign = sign
        self.numbers = {frozenset(): 0}

    def number(self, groups):
        return self.numbers.setdefault(frozenset(groups),
                                       self.sign * len(self.numbers))

    def write(self, file):
        for groups, number in self.numbers.items():
            names = "".join(f"{name:<80}" for name in sorted(groups))
            MEDfamilyCr(file, "mesh", f"FAM_{number}", number, len(groups),
                        MEDCHAR(names))


def write_med(path, points, elements, node_groups, types):
    """A MED file. @p elements: meshio's type -> [(nodes, groups)]; @p
    node_groups: node -> groups."""
    path.unlink(missing_ok=True)
    file = MEDfileOpen(str(path), MED_ACC_CREAT)
    dimension = len(points[0])
    MEDmeshCr(file, "mesh", dimension, dimension, MED_UNSTRUCTURED_MESH, "", "",
              MED_SORT_DTIT, MED_CARTESIAN, f"{'':<16}" * dimension,
              f"{'mm':<16}" * dimension)
    when = ("mesh", MED_NO_DT, MED_NO_IT)
    MEDmeshNodeCoordinateWr(file, *when, 0.0, MED_FULL_INTERLACE, len(points),
                            MEDFLOAT([x for point in points for x in point]))
    nodes, cells = Families(1), Families(-1)
    MEDmeshEntityFamilyNumberWr(
        file, *when, MED_NODE, MED_NONE, len(points),
        MEDINT([nodes.number(node_groups.get(i, ()))
                for i in range(len(points))]))
    for kind, entries in elements.items():
        MEDmeshElementConnectivityWr(
            file, *when, 0.0, MED_CELL, types[kind], MED_NODAL,
            MED_FULL_INTERLACE, len(entries),
            MEDINT([n + 1 for numbers, _ in entries for n in numbers]))
        # Where nothing is in a group there need not be families.
        if any(groups for _, groups in entries):
            MEDmeshEntityFamilyNumberWr(
                file, *when, MED_CELL, types[kind], len(entries),
                MEDINT([cells.number(groups) for _, groups in entries]))
    del nodes.numbers[frozenset()]  # FAM_0 serves both
    cells.write(file)
    nodes.write(file)
    MEDfileClose(file)


def write_med_2(path, points, elements, node_groups, types):
    """As write_med, but a file of version 2.3 by the calls that the library has
    for it: lines as edges of faces, three coordinates, no dimension of space."""
    path.unlink(missing_ok=True)
    library = ctypes.CDLL("libmed.so.11")
    library.MEDouvrir.restype = ctypes.c_int64
    file = ctypes.c_int64(library.MEDouvrir(str(path).encode(), 3))  # create
    cell, edge, node, no_interlace, nodal = 0, 2, 3, 0, 0

    def call(name, *arguments):
        assert getattr(library, name)(file, b"mesh", *arguments) >= 0, name

    def numbers(values):
        return (ctypes.c_int * len(values))(*values)

    call("MEDmaaCr", 2, 0, b"of 2.3")
    coordinates = [x for point in points for x in (*point, 7.)]
    call("MEDcoordEcr", 3, (ctypes.c_double * len(coordinates))(*coordinates),
         no_interlace, len(points), 0, b" " * 48, b"mm" + b" " * 46)
    nodes, cells = Families(1), Families(-1)
    call("MEDfamEcr", numbers([nodes.number(node_groups.get(i, ()))
                               for i in range(len(points))]),
         len(points), node, 0)
    for kind, entries in elements.items():
        entity = edge if kind == "line" else cell
        call("MEDconnEcr", 2, numbers([n + 1 for ends, _ in entries
                                       for n in ends]), no_interlace,
             len(entries), entity, types[kind], nodal)
        call("MEDfamEcr", numbers([cells.number(groups)
                                   for _, groups in entries]),
             len(entries), entity, types[kind])
    del nodes.numbers[frozenset()]
    for groups, number in [*nodes.numbers.items(), *cells.numbers.items()]:
        call("MEDfamCr", ctypes.create_string_buffer(b"FAM_%d" % number, 64),
             number, numbers([0]), numbers([0]), b"", 0,
             "".join(f"{name:<80}" for name in sorted(groups)).encode(),
             len(groups))
    library.MEDfermer(file)
