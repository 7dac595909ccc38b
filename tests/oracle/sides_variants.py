"""Scenes whose groups go round edges, once more with a contact pair for each side
of the slave, and with slave and master exchanged: both have to be solved by about
the same forces."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import check
import sides
import variants

# Of the sum of all forces of contact, and of the largest displacement: pairs that
# the oracle cuts, and other surfaces that forces and gaps are weighted on.
SAME, ROLES = 1e-6, 0.25


def response(scene, run):
    """By load factors: the sum of the forces on one side, the sum of their
    sizes, the mean displacement of the head, the largest one."""
    tools = check.tools_of(scene)
    model = tools.model(scene, run)
    head = model.nodes_of("Head")
    found = {}
    for state in tools.states(scene, model, run) or []:
        for group in ("In", "Out"):
            nodes = model.nodes_of(group)
            if not state.held[nodes].any():
                break
        force = state.residual[nodes]
        found[round(state.t, 12)] = (
            force.sum(0), np.linalg.norm(force, axis=1).sum(),
            state.u[head].mean(0), np.abs(state.u).max())
    return found


def distance(scene, one, other):
    """Of two responses, at the load factors of both, each relative to the most
    of all times, or to round-off where bodies have come apart again."""
    round_off = 1e-9
    young = max(modulus for modulus, _ in scene.materials.values())
    common = set(one) & set(other)
    size, largest = (
        max([r[k] for r in one.values()] + [round_off * least])
        for k, least in ((1, young * scene.size ** (len(scene.axes) - 1)),
                         (3, scene.size)))
    return max([0.0] + [max(
        np.linalg.norm(one[t][0] - other[t][0]) / size,
        np.linalg.norm(one[t][2] - other[t][2]) / largest) for t in common])


def fewest(scene):
    """Facets along any side of the surfaces of contact."""
    mesh = scene.mesh
    return min((np.bincount(sides.sides_of(mesh.X, mesh.lines[group])).min() /
                (2 if scene.axes == "xyz" and len(mesh.lines[group][0]) == 3
                 else 1)) ** (1 / (len(scene.axes) - 1))
               for group in ("In", "Out"))


def compare(scene, base, binary, directory):
    """(column, sentence), None if there is nothing to say."""
    for name, make, allowed in (("sides", sides.cut, SAME),
                                ("roles", sides.exchanged, ROLES)):
        if name == "roles" and (scene.rule == "nodal" or fewest(scene) < 2):
            # Places between its nodes are not held: too soft by any amount; one
            # facet along a side has no gap but the mean.
            continue
        other = make(scene)
        run = variants.run_variant(other, binary, directory / name, 1)
        if run.status not in (0, 1, 2, 3):
            return "crash", "%s: exit status %s: %s" % (name, run.status,
                                                        run.message)
        if run.status != 0:
            # Of other surfaces perhaps for reasons of their own.
            if name == "sides":
                return "differs", "sides: exit status %d: %s" % (
                    run.status, run.message)
            continue
        off = distance(scene, response(scene, base),
                       response(scene, run))
        if off > allowed:
            return ("wrong" if off > ROLES else "differs"), (
                "%s: %.2g of the forces off" % (name, off))
    return None
