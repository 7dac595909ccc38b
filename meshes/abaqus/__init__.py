# SPDX-License-Identifier: LGPL-2.1-or-later
"""An Abaqus deck as a mesh with named groups, and as a case.

Bodies are the element sets of *SOLID SECTION, without sections those that
*ELEMENT names, and boundaries the surfaces; node sets become the boundary (in 3-D
also the curve) that they are all nodes of, and of what remains each node a point
NAME_label."""

from __future__ import annotations

from pathlib import Path

from named_mesh import Mesh

from .case import Case
from .groups import Groups
from .parts import Deck


def read(path: Path, bodies: list[str]) -> tuple[Mesh, Case]:
    groups = Groups(Deck(path), bodies)
    case = Case(groups)
    groups.add_node_sets()
    return groups.mesh, case
