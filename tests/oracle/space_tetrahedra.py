"""The scenes in 3-D with tetrahedra in the place of hexahedra, in some bodies or
in all of them."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import space_blocks
import space_materials
import space_round
import space_sides
from space_surfaces import TRIANGLES

# Hexahedra of a scene of degree 2 at most, of some thousand unknowns.
SMALL = 60
# Of the shortest edge: by how much nodes are moved.
SHAKEN = 0.15
# Beyond this ratio of lambda to mu degree 1 is refused.
LOCKS = 10


def bodies_of(rng, scene):
    """Two in three, at least one; those whose groups are one have faces of one
    kind."""
    mesh = scene.mesh
    names = [n for n in mesh.bodies if rng.random() < 0.67]
    names = set(names or [rng.choice(mesh.bodies)])
    nodes = {body: set(np.unique(array).tolist())
             for (body, _), array in mesh.cells.items()}
    for faces in mesh.lines.values():
        of_group = {body for body in mesh.bodies
                    if any(n in nodes[body] for face in faces for n in face)}
        if names & of_group:
            names |= of_group
    return [body for body in mesh.bodies if body in names]


def locks(scene, bodies):
    """Whether tetrahedra of degree 1 in these bodies are refused."""
    ratios = [scene.material(body)[1] for body in bodies]
    return any(2 * nu / (1 - 2 * nu) > LOCKS for nu in ratios)


def with_tetrahedra(make):
    def scene_of(rng, seed):
        scene = make(rng, seed)
        mesh, entries = scene.mesh, scene.entries
        bodies = bodies_of(rng, scene)
        is_small = sum(map(len, mesh.cells.values())) <= SMALL
        for body in bodies if not mesh.arcs and rng.random() < 0.6 else ():
            mesh.shaken(body, rng, SHAKEN)
        mesh.cut(bodies, rng)
        entries.pop("Refinement/Levels", None)
        entries["Element/Degree"] = 2 if locks(scene, bodies) or (
            is_small and rng.random() < 0.6) else 1
        if scene.degree == 1:
            entries.pop("Element/Centre node", None)
        elif any(law.has_history for law in scene.laws.values()):
            # Nobody knows the middles of edges in between.
            entries["Solution/Increments"] = 1
        for zone in scene.zones:
            if zone.master and scene.degree == 2 and len(
                    mesh.lines[zone.slave][0]) in TRIANGLES:
                zone.rule = "mortar"
        return scene
    scene_of.__name__ = make.__name__
    return scene_of


KINDS = tuple(with_tetrahedra(make) for make in (
    *space_blocks.KINDS, *space_round.KINDS, *space_materials.KINDS,
    *space_sides.KINDS))
