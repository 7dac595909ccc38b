"""The same scene in other words: mirrored (in 3-D turned), renumbered, its
bodies in another order, on two processes. Its results have to be the same."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import copy
import random

import numpy as np

import check
import results
import space_scene

# Of the largest displacement of all increments. The program drives residuals to
# 1e-8 of the load, and pairs once more before each step of Newton's method.
SAME = 1e-6
NAMES = ("mirrored", "renumbered", "reordered", "two ranks")


def make(scene, name):
    """Another scene, the matrix that its displacements have to be multiplied
    with (or the factors), and the number of processes; None if there is none."""
    one = np.ones(len(scene.axes))
    if name == "mirrored" and len(scene.axes) == 3:
        turn = space_scene.rotation(random.Random(scene.seed))
        for R in (turn, space_scene.THIRD):
            other = scene.turned(R)
            if other:
                return other, R, 1
        return None
    if name == "mirrored":
        other = scene.mirrored()
        sign = np.array([1.0, -1.0] if scene.axisymmetric else [-1.0, 1.0])
        return other and (other, sign, 1)
    if name == "renumbered":
        return scene.renumbered(random.Random(scene.seed)), one, 1
    if name == "reordered":
        return scene.reordered(), one, 1
    return scene, one, 2


def displacements(scene, run):
    """Those of the last increment, and the largest of all increments."""
    if len(scene.axes) == 3:
        model = check.tools_of(scene).model(scene, run)
        u = model.nodes.u[model.reported()][:len(scene.mesh.X)]
        return u, np.abs(u).max()
    fields = [results.vertex_displacements(i, len(scene.mesh.X))
              for i in run.summary["increments"] if i["converged"]]
    return fields[-1], max(np.abs(u).max() for u in fields)


def compare(scene, base, name, binary, directory):
    """(column, sentence), None if there is nothing to say: 'wrong' if the
    variant is found wrong by itself, 'differs' if both may be right."""
    made = make(scene, name)
    if made is None:
        return None
    other, sign, ranks = made
    run = run_variant(other, binary, directory, ranks)
    if ranks > 1 and run.status == 2:
        return None
    if run.status != 0:
        crashed = run.status not in (1, 2, 3)
        return "crash" if crashed else "differs", "%s: exit status %s: %s" % (
            name, run.status, run.message)
    off = distance(scene, base, other, run, sign)
    if off <= SAME:
        return None
    found = check.problems(other, run)
    if found:
        return "wrong", "%s (%.1e off): %s" % (name, off, found[0])
    close = tightened(made, scene, binary, directory)
    if close <= SAME:
        return None
    return "differs", "%s: %.1e of the largest displacement, %.1e under " \
        "tight tolerances; both in equilibrium" % (name, off, close)


def run_variant(scene, binary, directory, ranks):
    scene.write(directory)
    return results.run(binary, directory, ranks)


def distance(scene, base, other, run, sign):
    """Of two results, by the largest displacement; by the resolution of the
    mesh file where nothing moves."""
    (u, largest), (v, _) = displacements(scene, base), displacements(other, run)
    v = v[getattr(other.mesh, "order", slice(None))]
    v = v * sign if sign.ndim == 1 else v @ sign
    return np.abs(u - v).max() / max(largest, 1e-9 * scene.size)


def tightened(made, scene, binary, directory):
    """The distance once more where loops stop later: what they may leave is not
    the same in the system of one process and that of two."""
    other, sign, ranks = made
    tight = [copy.deepcopy(s) for s in (scene, other)]
    for s in tight:
        s.entries.update({"Solution/Geometry tolerance": "1e-8",
                          "Solution/Newton tolerance": "1e-11"})
    runs = [run_variant(s, binary, directory / name, n) for s, name, n in zip(
        tight, ("first", "second"), (1, ranks))]
    if any(run.status != 0 for run in runs):
        return np.inf
    return distance(tight[0], runs[0], tight[1], runs[1], sign)
