#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random scenes and damaged files: does the program answer, and rightly?

    fuzz.py [--scenes N] [--damaged N] [--first SEED] [--quick] [--output DIR]
            [--processes P] [--limit SECONDS] [--least SHARE] CONTACT

See scenes.py and damaged.py. CONTACT may be a build with sanitizers, see
README.md here. Reports are DIR/scenes.md, scenes.csv, damaged.md and
damaged.csv, DIR being output/fuzz if not told. Exit status: 0, or 1 if a run
crashed, hung, was answered badly, or converged to what can not be true, or if
less than SHARE of the scenes converged.
"""
import argparse
import pathlib
import sys

import damaged
import scenes


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("contact")
    parser.add_argument("--scenes", type=int)
    parser.add_argument("--damaged", type=int)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--quick", action="store_true",
                        help="25 scenes and 60 damaged files")
    parser.add_argument("--output", default="output/fuzz")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--least", type=float, default=0.9)
    options = parser.parse_args()
    n_scenes, n_damaged = (25, 60) if options.quick else (300, 500)
    if options.scenes is not None:
        n_scenes = options.scenes
    if options.damaged is not None:
        n_damaged = options.damaged
    output = pathlib.Path(options.output)

    solved, text = scenes.run_scenes(
        options.contact, range(options.first, options.first + n_scenes),
        output, options.processes, options.limit)
    print(text)
    answered, text = damaged.run_damaged(
        options.contact, range(options.first, options.first + n_damaged),
        output, options.processes, options.limit)
    print(text)

    bad = scenes.failures(solved, options.least) + damaged.failures(answered)
    for line in bad:
        print("FAILED:", line[:600])
    print("%d scenes, %d damaged files, %d failures" %
          (n_scenes, n_damaged, len(bad)))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
