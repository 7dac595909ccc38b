#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random scenes and damaged files: does the program answer, and rightly?

    fuzz.py [--scenes N] [--space N] [--damaged N] [--damaged-space N]
            [--damaged-tetrahedra N] [--first SEED] [--quick] [--output DIR]
            [--processes P] [--limit SECONDS] [--least SHARE] CONTACT

See scenes.py, space_scenes.py, damaged.py, damaged_space.py and
damaged_tetrahedra.py. CONTACT may be a build with sanitizers, see README.md here.
Reports are DIR/scenes.md, space_scenes.md, damaged.md and so on, and the same as
.csv, DIR being output/fuzz if not told. Exit status: 0, or 1 if a run
crashed, hung, was answered badly, or converged to what cannot be true, or if
less than SHARE of the scenes converged or had a mesh that the program calls too
coarse (a violated depth).
"""
import argparse
import pathlib
import sys

import damaged
import damaged_space
import damaged_tetrahedra
import scenes
import space_scenes

# How many of each kind, in full and quickly.
NUMBERS = {"scenes": (300, 12), "space": (200, 4), "damaged": (500, 30),
           "damaged_space": (300, 8), "damaged_tetrahedra": (200, 8)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("contact")
    for kind in NUMBERS:
        parser.add_argument("--" + kind.replace("_", "-"), type=int)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--quick", action="store_true",
                        help="few of each")
    parser.add_argument("--output", default="output/fuzz")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--least", type=float, default=0.9)
    options = parser.parse_args()
    output = pathlib.Path(options.output)

    def seeds(kind):
        told = getattr(options, kind)
        number = NUMBERS[kind][options.quick] if told is None else told
        return range(options.first, options.first + number)

    bad, said = [], []
    for kind, scene in (("scenes", scenes.Scene),
                        ("space", space_scenes.SpaceScene)):
        solved, text = scenes.run_scenes(
            scene, options.contact, seeds(kind), output, options.processes,
            options.limit)
        print(text)
        bad += scenes.failures(solved, options.least)
        said.append("%d %s" % (len(solved), kind))
    for kind, case in (("damaged", damaged.Case),
                       ("damaged_space", damaged_space.SpaceCase),
                       ("damaged_tetrahedra",
                        damaged_tetrahedra.TetrahedraCase)):
        answered, text = damaged.run_damaged(
            case, options.contact, seeds(kind), output, options.processes,
            options.limit)
        print(text)
        bad += damaged.failures(answered)
        said.append("%d %s" % (len(answered), kind.replace("_", " ")))

    for line in bad:
        print("FAILED:", line[:600])
    print("%s, %d failures" % (", ".join(said), len(bad)))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
