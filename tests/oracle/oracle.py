#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random scenes of many kinds, judged by a finite element code of its own.

    oracle.py [--space | --tetrahedra] [--count N] [--seed S] [--kind K,...] [--keep DIRECTORY]
              [--jobs N] [--variants SHARE] [--strict] CONTACT
    oracle.py --scenes "KIND SEED, ..." [...] CONTACT

Scene k is of the kind k modulo their number; with its seed it is always the
same. With --scenes these alone. Exit status 1 if a result with exit status 0 is
wrong, or a run crashed, hung or took too much memory; with --strict also if a
scene that has to converge at default settings does not."""
import argparse
import concurrent.futures
import os
import pathlib
import random
import shutil
import sys
import tempfile
import time
import traceback

# OpenBLAS called by several threads gave wrong numbers with threads of its own.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import check
import kinds_blocks
import kinds_materials
import kinds_motions
import kinds_parts
import kinds_shapes
import kinds_sides
import results
import scene as scenes
import sides_variants
import space_blocks
import space_materials
import space_round
import space_sides
import space_tetrahedra
import variants

KINDS = {f.__name__: f for f in kinds_blocks.KINDS + kinds_shapes.KINDS +
         kinds_parts.KINDS + kinds_materials.KINDS + kinds_motions.KINDS +
         kinds_sides.KINDS}
SPACE = {"space_" + f.__name__: f for f in space_blocks.KINDS +
         space_round.KINDS + space_materials.KINDS + space_sides.KINDS}
TETRAHEDRA = {"tetrahedra_" + f.__name__: f for f in space_tetrahedra.KINDS}
# "violated": converged, and refused by the program itself, as where a mesh lets
# bodies pass through each other.
ENDS = ("converged", "differs", "refused", "not converged", "violated", "wrong",
        "crash")
COLUMNS = ("run", *ENDS, "seconds", "most s", "most MB", "steps")


def make(kind, seed):
    scene = {**KINDS, **SPACE, **TETRAHEDRA}[kind](random.Random("%s %d" % (kind, seed)),
                                     seed)
    scene.kind, scene.name = kind, "%s_%d" % (kind, seed)
    return scene


class Outcome:
    def __init__(self, scene, column, reason, run):
        self.scene = scene
        self.column = column
        self.reason = reason
        self.run = run


def judge(scene, run):
    """The column of a run, and the reason."""
    if run.status is None:
        return "crash", "hung: " + run.said
    if run.status not in (0, 1, 2, 3):
        return "crash", "exit status %s: %s" % (run.status, run.message)
    if run.megabytes > 1000:
        return "crash", "%.0f MB" % run.megabytes
    if run.status == 2:
        return "refused", run.message
    if run.status == 3:
        return "not converged", run.message
    if run.status == 1:
        return "violated", "; ".join(
            f["text"] for f in run.summary["findings"]
            if f["severity"] == "violated")[:300]
    try:
        found = check.problems(scene, run)
    except Exception:
        found = ["the oracle failed: " + traceback.format_exc()[-600:]]
    if found:
        return "wrong", "; ".join(map(str, found[:3]))
    if scene.expected in (scenes.HOPELESS, scenes.REFUSED):
        return "wrong", "converged, although nothing holds a body"
    return "converged", ""


def run_scene(binary, share, kind, seed, directory):
    scene = make(kind, seed)
    scene.write(directory)
    try:
        run = results.run(binary, directory)
    except OSError:  # the program is being replaced
        time.sleep(20)
        run = results.run(binary, directory)
    column, reason = judge(scene, run)
    if column == "converged" and share > 0 and seed % round(1 / share) == 0:
        name = variants.NAMES[seed // round(1 / share) % len(variants.NAMES)]
        found = variants.compare(scene, run, name, binary,
                                 directory / "variant")
        if found:
            column, reason = found
    if column == "converged" and share > 0 and scene.round_edges:
        column, reason = sides_variants.compare(
            scene, run, binary, directory / "sides") or (column, reason)
    return Outcome(scene, column, reason, run)


def is_failure(outcome):
    """Not what is expected of the scene, at the settings of the program."""
    scene = outcome.scene
    if outcome.column in ("wrong", "crash", "differs"):
        return True
    if scene.expected != scenes.SOLVED:
        return False
    return outcome.column in ("refused", "not converged", "violated") and (
        scene.is_default)


def table(kinds, outcomes):
    lines = ["| kind | " + " | ".join(COLUMNS) + " | at default |",
             "|" + "---|" * (len(COLUMNS) + 2)]
    for kind in kinds + ["all"]:
        these = [o for o in outcomes if kind in (o.scene.kind, "all")]
        if these:
            lines.append("| %s | %s | %s |" % (kind, " | ".join(
                cells(these)), at_default(these)))
    return "\n".join(lines)


def cells(outcomes):
    count = lambda column: sum(o.column == column for o in outcomes)
    seconds = [o.run.seconds for o in outcomes]
    return [str(len(outcomes))] + [str(count(c)) for c in ENDS] + [
        "%.1f" % sum(seconds), "%.1f" % max(seconds),
        "%.0f" % max(o.run.megabytes for o in outcomes),
        str(sum(o.run.steps for o in outcomes))]


def at_default(outcomes):
    """How many of those converge that have to."""
    these = [o for o in outcomes if o.scene.is_default and
             o.scene.expected == scenes.SOLVED]
    good = sum(o.column in ("converged", "differs") for o in these)
    return "%d of %d" % (good, len(these))


def report(outcome, keep, binary):
    scene = outcome.scene
    print("%-13s %-16s %s%s: %s\n    cd %s && %s case.prm" % (
        outcome.column, scene.name, scene.rule,
        "" if scene.is_default else " (other loops)", outcome.reason,
        keep / scene.name, binary), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--kind")
    parser.add_argument("--scenes")
    parser.add_argument("--space", action="store_true")
    parser.add_argument("--tetrahedra", action="store_true")
    parser.add_argument("--keep", default="output/oracle", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--variants", type=float, default=0.25)
    parser.add_argument("--strict", action="store_true")
    parser.add_argument("contact", type=pathlib.Path)
    options = parser.parse_args()
    binary = options.contact.resolve()
    kinds = (options.kind.split(",") if options.kind else
             list(SPACE if options.space else
                  TETRAHEDRA if options.tetrahedra else KINDS))
    todo = [(kinds[k % len(kinds)], options.seed + k // len(kinds))
            for k in range(options.count)]
    if options.scenes:
        todo = [(kind, int(seed)) for kind, seed in
                (scene.split() for scene in options.scenes.split(","))]
        kinds = list(dict.fromkeys(kind for kind, _ in todo))
    outcomes = []
    with tempfile.TemporaryDirectory() as place, \
            concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        place = pathlib.Path(place)

        def one(item):
            return run_scene(binary, options.variants, *item,
                             place / ("%s_%d" % item))
        for outcome in pool.map(one, todo):
            outcomes.append(outcome)
            directory = place / outcome.scene.name
            if is_failure(outcome):
                kept = options.keep / outcome.scene.name
                shutil.rmtree(kept, ignore_errors=True)
                shutil.copytree(directory, kept)
                report(outcome, options.keep.resolve(), binary)
            shutil.rmtree(directory)
    print(table(kinds, outcomes))
    return any(o.column in ("wrong", "crash") or options.strict and
               is_failure(o) and o.column != "differs" for o in outcomes)


if __name__ == "__main__":
    sys.exit(main())
