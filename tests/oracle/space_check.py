"""What is special in 3-D of the judgement in check.py: where displacements
come from, and what the program says about forces of contact."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

import check
import results
import space_motion
import surfaces
from check import EQUILIBRIUM, State, Tools
from space_fem import SpaceModel
from zone_check import Problem

# Of a straight body's size: where nodes are.
STRAIGHT = 1e-8
# Of an edge: how far the middles of round bodies may be from where we guess.
ROUND = 0.3


class ReportedModel(SpaceModel):
    """On the mesh that the results are of. The middles inside of a round body
    are where the program says, those of its round surfaces on these."""

    def __init__(self, scene, run):
        self.nodes = results.Nodes(run.directory)
        super().__init__(scene.judged())

    def add_middles(self, mesh, cells):
        complete = super().add_middles(mesh, cells)
        round_ = [(surfaces.obstacle("%s: %s" % (entry.lower()[:-1], ", ".join(
            "%.17g" % v for v in numbers))),
            np.unique(self.complete(mesh.lines[name])))
            for name, (entry, numbers) in mesh.arcs.items()]
        for surface, nodes in round_:
            on = nodes[nodes >= self.n_vertices]
            self.X[on] -= (surface.gap(self.X[on])[:, None] *
                           surface.normals(self.X[on]))
        for (body, _), array in complete.items() if round_ else ():
            middles = np.unique(array[array >= self.n_vertices])
            rows, off = self.nodes.rows_of(body, self.X[middles])
            if off.max() > ROUND * np.ptp(self.X[array], axis=1).max():
                raise ValueError("a middle is %.3g mm away" % off.max())
            self.X[middles] = self.nodes.X[rows]
        for surface, nodes in round_:
            off = np.abs(surface.gap(self.X[nodes])).max()
            if off > STRAIGHT * self.scene.size:
                raise ValueError("a node is %.3g mm off its surface" % off)
        return complete

    def reported(self):
        """The rows of our nodes; None if one is missing."""
        rows = np.zeros(len(self.X), int)
        for b, body in enumerate(self.scene.mesh.bodies):
            nodes = np.flatnonzero(self.body_of == b)
            rows[nodes], off = self.nodes.rows_of(body, self.X[nodes])
            if off.max() > STRAIGHT * self.scene.size:
                return None
        if len(np.unique(rows)) < len(rows) or len(rows) != len(self.nodes.X):
            return None
        return rows


def states_of(scene, model, run):
    """The states of all increments; of degree 2 and of levels the last one."""
    increments = [i for i in run.summary["increments"] if i["converged"]]
    rows = model.reported()
    if rows is None:
        return None
    fields = [(model.nodes.u[rows], increments[-1])]
    if scene.is_probed:
        fields = [(results.vertex_displacements(i, len(model.X), "xyz"), i)
                  for i in increments]
    elif model.has_history and len(increments) > 1:
        # Cut: nobody knows the middles of edges in between.
        return []
    found, so_far = [], 0.0
    model.reset()
    for u, increment in fields:
        size = np.abs(u).max() + np.abs(model.X).max()
        error = np.full(len(u), 32 * np.finfo(float).eps * size)
        found.append(State(model, u, increment["load_factor"], error,
                           increment))
        found[-1].scale = so_far = max(so_far, found[-1].scale)
        model.advance(u)
    if not scene.is_probed:
        found[-1].scale = max([so_far] + [
            sum(abs(f) for force in i.get("reactions", {}).values()
                for f in force.values()) for i in increments])
    return found


def check_output(scene, model, state, run):
    """The forces of contact, and those that follow from the profile."""
    found = check_following(model, state)
    said = model.nodes.force[model.reported()]
    free = ~state.held & state.on_surface[:, None] & ~model.bound
    ours = np.where(free, state.residual, 0)
    off = np.where(free, np.abs(said - ours), 0) - 3 * state.error
    if off.max(initial=0) > EQUILIBRIUM * state.scale:
        n, d = np.unravel_index(off.argmax(), off.shape)
        found.append(Problem("contact force", "%.6g N at %s, said to be %.6g" %
                             (ours[n, d], check.place(model.X[n]),
                              said[n, d])))
    beside = np.abs(said[~state.on_surface]).max(initial=0)
    if beside > EQUILIBRIUM * state.scale:
        found.append(Problem("contact force", "%.3g N beside the surfaces" %
                             beside))
    return found


def check_following(model, state):
    off = np.abs(model.following(state.u) - state.u).max()
    if off > 1e-9 * np.abs(state.u).max() + 1e-14 * model.scene.size:
        return [Problem("centre", "a node in the middle is %.3g mm off" % off)]
    return []


TOOLS = Tools(ReportedModel, states_of, space_motion.zone_check_of,
              check_output)
