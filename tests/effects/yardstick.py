#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scene without contact against a plain deal.II program of the same problem.

    yardstick.py [--repetitions N] [--refinements N,...] [--degree N]
                 [--check BAR] PLAIN CONTACT [SOLVER...]

PLAIN is plain_elasticity. Both run alternately, of each the smallest CPU and
wall time and memory counts. A Markdown table; with --check the exit status is 1
if the program takes more than BAR times the CPU time of the plain one. Solvers:
UMFPACK, CHOLMOD, AMG, all by default.
"""

import argparse
import pathlib
import sys
import tempfile

import scenes

CELLS, REFINEMENTS = 49, (1, 2, 3)  # 19 602, 77 618, 308 898 unknowns, degree 1


def entries(solver, refinements, degree):
    found = scenes.HELD_BLOCK | {
        "Mesh/Refinements": refinements,
        "Element/Degree": degree,
        "Element/Centre node": "free",
        "Solution/Increments": 1,
        "Solution/Linear solver": solver,
        "Probes/Probes": "corner: displacement y, Corner",
    }
    if degree == 1:
        del found["Element/Centre node"]
    return found


def row(solver, refinements, degree, options, directory):
    mesh = directory / "block.msh"
    scenes.write_block(mesh, CELLS)
    plain_command = [options.plain, mesh, refinements, degree, solver]
    plain = ours = None
    for _ in range(options.repetitions):
        one = scenes.measure([str(word) for word in plain_command], directory)
        if one.status != 0:
            raise SystemExit(scenes.log(directory))
        unknowns, corner = scenes.log(directory).split()
        plain = plain.cheaper(one) if plain else one
        one = scenes.run(options.contact, mesh,
                         entries(solver, refinements, degree), directory)
        if one.status != 0:
            raise SystemExit(scenes.log(directory))
        ours = ours.cheaper(one) if ours else one

    summary = ours.summary
    value = summary["probes"][0]["value"]
    same = (abs(value / float(corner) - 1) < 1e-7 and
            summary["unknowns"]["displacement"] == int(unknowns))
    ratio = ours.cpu / plain.cpu
    print("| %s | %d | %s | %.2f | %.2f | %.3f | %.2f | %.2f | %.3f | %.0f | "
          "%.0f | %.2f | %s |" %
          (solver, degree, unknowns, plain.cpu, ours.cpu, ratio, plain.wall,
           ours.wall, ours.wall / plain.wall, plain.memory, ours.memory,
           ours.memory / plain.memory, "yes" if same else "NO"), flush=True)
    return same and (options.check is None or ratio <= options.check)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--refinements", default=REFINEMENTS,
                        type=lambda text: [int(n) for n in
                                           text.split(",")])
    parser.add_argument("--degree", type=int, default=1)
    parser.add_argument("--check", type=float)
    parser.add_argument("plain", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("contact", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("solver", nargs="*",
                        default=["UMFPACK", "CHOLMOD", "AMG"])
    options = parser.parse_args()

    print("| solver | degree | unknowns | CPU, plain [s] | CPU [s] | ratio | "
          "wall, plain [s] | wall [s] | ratio | memory, plain [MB] | "
          "memory [MB] | ratio | same result |")
    print("|" + "---|" * 13)
    good = True
    with tempfile.TemporaryDirectory() as directory:
        for solver in options.solver:
            for refinements in options.refinements:
                good = row(solver, refinements, options.degree, options,
                           pathlib.Path(directory)) and good
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
