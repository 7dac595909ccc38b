"""Whether a result can be true: judged by a finite element code of its own.

What remains of the internal forces after the loads are taken off is zero at a
free node, the force of the support at a held one, and the force of contact on a
contact surface. These are compared with each other, with the deformed surfaces,
and with what the program says."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import collections

import numpy as np
from scipy.spatial import cKDTree

import fem
import motion_check
import motions
import results
import rigid_check
import sides
import surfaces
from zone_check import Problem

# Of the sum of all forces: a hundred times the program's own tolerance.
EQUILIBRIUM = 1e-6
# The program's own, on the norm of all residuals.
TOLERANCE = 1e-8
# Turned by more than this, small strain means nothing.
ROTATION = 0.2
# Surfaces that bend by more have forces whose sum is not that of their sizes.
BENT = 0.05
# Displacements of a scene, by its size.
FLOWN_AWAY = 1.0


class State:
    """The displacements of one increment, and all forces."""

    def __init__(self, model, u, t, error, record=None):
        """`record`: what the program says about the increment."""
        self.u = u
        self.t = t
        scene = model.scene
        self.x = model.X + u
        self.record = record or {}
        # The time at which the increment began.
        self.begin = 0.0
        self.placements = motions.placements(scene, t, self.record)
        model.at(t)
        internal = model.forces(u)
        self.residual = internal - model.external(t)
        self.held, self.value = model.supports(t)
        self.position_error = error
        self.error = model.magnitude(u, error)
        # Free strains that are held back are loads.
        self.loads = model.load_scale(t) + (np.abs(
            model.forces(np.zeros_like(u))).sum() if scene.thermal else 0)
        surface = np.zeros(len(model.X), bool)
        for zone in scene.zones:
            for group in (zone.slave, zone.master):
                if group:
                    surface[model.lines[group]] = True
        self.on_surface = surface
        self.rigid = model.in_groups(scene.rigid)
        free = ~self.held & ~(surface | self.rigid)[:, None]
        self.free_residual = np.where(free, self.residual, 0)
        self.scale = self.loads + np.abs(np.where(free, 0,
                                                  self.residual)).sum()


def states_of(scene, model, run):
    """The states of all increments; of degree 2 of the last one."""
    increments = [i for i in run.summary["increments"] if i["converged"]]
    ulp = np.finfo(float).eps
    found = []
    chosen = range(len(increments))
    model.reset()
    if model.degree == 2:
        chosen = chosen[-1:]
        if model.has_history and len(increments) > 1:
            # Cut: nobody knows the middles of edges in between.
            return []
    for k in chosen:
        u = np.full((len(model.X), 2), np.nan)
        u[:model.n_vertices] = results.vertex_displacements(
            increments[k], model.n_vertices)
        size = np.abs(u[:model.n_vertices]).max()
        error = np.full(len(model.X), 32 * ulp * (size + np.abs(
            model.X).max()))
        t = increments[k]["load_factor"]
        if model.degree == 2 and scene.middles_in == "Nodes":
            if not results.middles_of_nodes(run, model, u):
                return None
        elif model.degree == 2:
            if not results.middle_displacements(run, model, u):
                return None
            error[model.n_vertices:] = results.SINGLE * np.abs(
                u[model.n_vertices:]).max(1)
            refine_middles(model, run, t, u, error)
        found.append(State(model, u, t, error, increments[k]))
        if k > 0:
            found[-1].begin = increments[k - 1]["load_factor"]
        model.advance(u)
    # The program measures its residual by the forces that have acted so far.
    so_far = 0.0
    for state in found:
        state.scale = so_far = max(so_far, state.scale)
    if model.degree == 2 and found:
        found[-1].scale = max([found[-1].scale] + [
            sum(abs(f) for force in i["reactions"].values()
                for f in force.values()) for i in increments])
    return found


def refine_middles(model, run, t, u, error):
    """More digits than the file of the bodies has: of surfaces from the
    profile; the other middles from their own equilibrium, if that is within
    what the file leaves open."""
    said = results.profile(run.directory)
    for zone in model.scene.zones:
        for side, group in (("slave", zone.slave), ("master", zone.master)):
            rows = said.get((side + " " + zone.name).strip(), [])
            if group and rows:
                take_profile(model, rows, model.nodes_of(group), u, error)
    held, value = model.supports(t)
    fits = held & (np.abs(u - value) <= 3 * error[:, None])
    u[fits] = value[fits]
    error[fits.all(1)] = 0
    loose = error > 1e-9 * np.abs(u).max()
    fixed = np.repeat(~loose[:, None], 2, axis=1) & ~held
    if not loose.any():
        return
    try:
        better = model.solve(t, 1, fixed, u)
    except (ArithmeticError, RuntimeError):
        return
    off = np.abs(better - u)[loose]
    if (off <= 3 * error[loose, None] + 1e-300).all():
        u[loose] = better[loose]
        error[loose] = 1e-11 * np.abs(u).max()


def take_profile(model, rows, nodes, u, error):
    """The displacements of the nodes of a surface from its rows."""
    tree = cKDTree(model.X[nodes])
    ulp = np.finfo(float).eps
    for row in rows:
        value = np.array([row["displacement_x_mm"], row["displacement_y_mm"]])
        distance, k = tree.query((row["X_mm"], row["Y_mm"]))
        n = nodes[k]
        if (n >= model.n_vertices and distance <= 1e-8 * model.scene.size and
                np.abs(value - u[n]).max() <= 3 * error[n]):
            u[n] = value
            error[n] = 1e-11 * np.abs(value).max() + ulp * np.abs(model.X).max()


# What differs between the plane and space: the model of a scene and a run, the
# states of the increments, the check of a zone, of what the program says.
Tools = collections.namedtuple("Tools", "model states zone output")


def tools_of(scene):
    if len(scene.axes) == 2:
        tools = Tools(lambda scene, run: fem.Model(scene), states_of,
                      motion_check.zone_check_of, check_profile)
    else:
        import space_check
        tools = space_check.TOOLS
    if scene.round_edges:
        import sides_check
        tools = tools._replace(zone=sides_check.SidesCheck)
        if len(scene.axes) == 2:
            tools = tools._replace(output=sides_check.shears)
    return tools


def problems(scene, run, model=None):
    """What is wrong with a run whose exit status is 0."""
    summary = run.summary
    if summary is None or not summary.get("converged"):
        return [Problem("no summary", "exit status 0")]
    tools = tools_of(scene)
    model = model or tools.model(scene, run)
    states = tools.states(scene, model, run)
    if states is None:
        return [Problem("file of the bodies", "lacks a node")]
    if not states:
        return []
    found = []
    for k, state in enumerate(states):
        if not np.isfinite(state.u).all():
            return [Problem("not a number", "displacements")]
        before = states[k - 1] if k else None
        found = check_state(scene, model, state, states, before, tools.zone)
        if found:
            for problem in found:
                problem.detail += " (t = %.4g)" % state.t
            break
    else:
        found += check_reactions(scene, model, states[-1], run)
        found += tools.output(scene, model, states[-1], run)
    if not scene.zones and not scene.rigid:
        found += check_without_contact(model, states)
    return found


def check_state(scene, model, state, states, before, zone_of):
    found = check_displacements(scene, model, state)
    found += check_equilibrium(model, state)
    if found:
        return found
    largest = max(np.abs(s.u).max() for s in states)
    found += check_balance(scene, model, state)
    found += rigid_check.problems(scene, model, state)
    shared = shared_nodes(scene, model)
    for zone in scene.zones:
        if not scene.undeformed:
            found += zone_of(scene, model, state, zone, largest,
                             shared).problems(before)
    return found


def check_displacements(scene, model, state):
    found = []
    largest = np.abs(state.u).max()
    allowed = FLOWN_AWAY * scene.size + 2 * scene.prescribed()
    if largest > allowed:
        found.append(Problem("flown away", "%.3g mm in a scene of %.3g mm" %
                             (largest, scene.size)))
    if not model.large:
        turn = max(mean_rotation(block, state.u) for block in model.blocks)
        if turn > ROTATION:
            found.append(Problem("turned", "by %.3g in small strain" % turn))
    off = (np.abs(np.where(state.held, state.u - state.value, 0)) -
           3 * state.position_error[:, None]).max()
    if off > 1e-9 * max(scene.prescribed(), 1e-6 * scene.size):
        found.append(Problem("support", "a held node is %.3g mm off" % off))
    return found


def mean_rotation(block, u):
    H = block.strain(u, False)[0]
    turn = np.einsum("eq,eqij->ij", block.w, H - H.swapaxes(2, 3)) / 2
    return np.linalg.norm(turn) / 2 ** 0.5 / block.w.sum()


def check_equilibrium(model, state):
    over = np.abs(state.free_residual) - 3 * state.error
    worst = over.max()
    if worst <= EQUILIBRIUM * state.scale:
        return []
    n = np.unravel_index(over.argmax(), over.shape)[0]
    return [Problem("equilibrium", "%.3g N on a free node at %s, all "
                    "forces %.3g N" % (worst, place(model.X[n]), state.scale),
                    worst / state.scale)]


def place(X):
    return "(%s)" % ", ".join("%.5g" % x for x in X)


def clusters(scene, model):
    """Zones that share nodes, together: lists of zones and all their nodes."""
    found = []
    for zone in scene.zones:
        nodes = set(model.lines[zone.slave].ravel())
        if zone.master:
            nodes |= set(model.lines[zone.master].ravel())
        zones = [zone]
        for other in [c for c in found if c[1] & nodes]:
            found.remove(other)
            zones += other[0]
            nodes |= other[1]
        found.append((zones, nodes))
    return found


def check_balance(scene, model, state):
    """What the bodies exert on each other adds up to nothing, but for what the
    program leaves; most of it where the forces are gone that once acted."""
    found = []
    for zones, nodes in clusters(scene, model):
        if any(zone.obstacle for zone in zones):
            continue
        nodes = np.array(sorted(nodes))
        force = state.residual[nodes]
        scale = np.abs(force).sum()
        # Of n nodes what is left adds up to sqrt(n) times its norm.
        allowed = (max(EQUILIBRIUM * scale, TOLERANCE * state.scale *
                       len(nodes) ** 0.5) + 3 * state.error[nodes].sum(0))
        for d in range(model.dim):
            # A ring carries radial forces by itself, and so does the axis.
            if state.held[nodes, d].any() or (model.axisymmetric and d == 0):
                continue
            if abs(force[:, d].sum()) > allowed[d]:
                found.append(Problem("balance", "contact forces in %s leave "
                                     "%.3g of %.3g N" % (
                                         "xyz"[d], force[:, d].sum(), scale)))
    return found


def shared_nodes(scene, model):
    """Nodes of more than one contact surface."""
    count = np.zeros(len(model.X), int)
    for zone in scene.zones:
        for group in (zone.slave, zone.master):
            if group:
                count[np.unique(model.lines[group])] += 1
    return count > 1


def check_reactions(scene, model, state, run):
    """What the program says about the forces of supports, against ours."""
    found = []
    reactions = run.summary["increments"][-1].get("reactions", {})
    for group, values in reactions.items():
        if group in scene.rigid:
            continue
        nodes = model.nodes_of(group)
        if state.on_surface[nodes].any():
            continue
        for d, axis in enumerate(scene.axes):
            entry = "Displacement " + axis
            if group not in scene.boundary.get(entry, {}):
                continue
            ours = state.residual[nodes, d].sum()
            allowed = (EQUILIBRIUM * state.scale +
                       3 * state.error[nodes, d].sum())
            if abs(ours - values[axis]) > allowed:
                found.append(Problem("reaction", "%s of %s is %.8g N, said to "
                                     "be %.8g" % (axis, group, ours,
                                                  values[axis])))
    return found


def check_profile(scene, model, state, run):
    """Normal forces and shears of the slave's nodes make their forces: node by
    node with the rule nodal; all together with the rule mortar, which spreads
    the force of a node over edges that face the master in part."""
    said = results.profile(run.directory)
    shared = shared_nodes(scene, model)
    for zone in scene.zones:
        nodes = np.unique(model.lines[zone.slave])
        rule = scene.rule_of(zone)
        left_out = shared[nodes] | state.held[nodes].any(1)
        if rule == "Gauss" or rule == "mortar" and left_out.any():
            continue
        ours = np.hypot(*state.residual[nodes].T)
        forces, is_normal = forces_said(
            said.get(("slave " + zone.name).strip(), []), model.X[nodes],
            1e-8 * scene.size)
        along = np.einsum("ni,ni->n", state.residual[nodes],
                          mean_normals(model.lines[zone.slave], state.x, nodes))
        ours = np.where(is_normal, np.abs(along), ours)
        theirs = np.hypot(*forces.T)
        allowed = (EQUILIBRIUM * state.scale + 10 *
                   state.error[nodes].max(1))
        off = np.where(left_out, 0, np.abs(ours - theirs))
        k = off.argmax()
        if rule == "nodal" and (off > allowed + 1e-4 * ours.max()).any():
            return [Problem("profile", "force %.6g N at (%.5g, %.5g), said to "
                            "be %.6g" % (ours[k], *model.X[nodes[k]],
                                         theirs[k]))]
        total = np.hypot(*state.residual[nodes].sum(0))
        said_total = np.hypot(*forces.sum(0))
        if rule == "mortar" and is_straight(model, zone.slave, state) and (
                abs(total - said_total) > 0.05 * total + allowed.sum()):
            return [Problem("profile", "a force of %.6g N, said to be %.6g" % (
                total, said_total))]
    return []


def forces_said(rows, X, resolution):
    """By nodes: the normal and the tangential force in the profile, and whether
    it has the normal one alone: beside a force without a pressure, as of a corner
    of the master at the far node of its edge, no shear is said."""
    tree = cKDTree(X)
    forces = np.zeros((len(X), 2))
    is_normal = np.zeros(len(X), bool)
    for row in rows:
        distance, k = tree.query((row["X_mm"], row["Y_mm"]))
        p, q = row["pressure_MPa"], row["shear_MPa"]
        force = row.get("nodal_force_N_per_mm", row.get("nodal_force_N"))
        if distance <= resolution and (p or force):
            forces[k] = force * np.array([1, q / p if p else 0])
            is_normal[k] = not p
    return forces, is_normal


def mean_normals(lines, x, nodes):
    """Of the straight lines between the vertices around each node."""
    normals = sides.normals_of(x, lines[:, :2])
    mean = np.array([normals[(lines == n).any(1)].sum(0) for n in nodes])
    return mean / np.linalg.norm(mean, axis=1)[:, None]


def is_straight(model, group, state):
    """Drawn so, and not bent much: forces along normals can be summed up."""
    drawn, line = (surfaces.Polyline(model.lines[group], x)
                   for x in (model.X, state.x))
    return (np.abs(drawn.tangent - drawn.tangent[0]).max() < 1e-9 and
            np.abs(line.tangent - line.tangent[0]).max() < BENT)


def check_without_contact(model, states):
    """Nothing but the bodies: the oracle has a solution of its own, and where
    bodies yield the same increments."""
    state = states[-1]
    try:
        if model.has_history:
            model.reset()
            u = np.zeros_like(state.u)
            for s in states:
                u = model.solve(s.t, 1, u=u)
                model.advance(u)
        else:
            u = model.solve(state.t, 4)
    except (ArithmeticError, RuntimeError):
        return []
    largest = max(np.abs(s.u).max() for s in states)
    off = np.abs(u - state.u).max() / max(largest, 1e-300)
    if off > 1e-5:
        return [Problem("another solution", "%.3g relative to ours" % off)]
    return []
