#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cost of contact on fine meshes in 3-D: parameters/nested_space.prm
without friction on finer and finer meshes, each with the same bodies glued
together on the finest mesh alone; with friction on the largest one, and on
several processes.

    scaling_space.py CONTACT [--levels N] [--degree N] [--ranks N,N...]
                     [--set ENTRY=VALUE ...]

A Markdown table. Seconds are CPU but where they are called wall: those of the
case of all processes together, those of the phases, of all levels, of the first
one. Iterations are those of the finest level, for each linear solve. Of degree 2
three levels are a million unknowns, of degree 1 four. Not a test: nothing is
asserted but convergence. Results go to a scratch directory.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

PARAMETERS = pathlib.Path(__file__).resolve().parent.parent / "parameters"
ONE_CORE = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
            "DEAL_II_NUM_THREADS": "1"}
PHASES = "setup", "assembly", "factorization", "solution", "search"
COLUMNS = ("case", "ranks", "unknowns", "points", "Newton steps, finest mesh",
           "solver", "iterations per solve", "CPU [s]", "by tied", "wall [s]",
           *(f"{phase} [s]" for phase in PHASES), "memory [MB]",
           "kB per unknown")


class Scaling:
    def __init__(self, options):
        self.contact = str(options.contact.resolve())
        self.entries = [f"Element/Degree={options.degree}",
                        "Element/Centre node=free", *options.set]
        self.failures = 0

    def run(self, case, entries, ranks=1):
        """Summary, CPU and wall seconds of a run; None if it has failed."""
        command = [self.contact, str(PARAMETERS / f"{case}.prm"), "--quiet",
                   "--set", "Output/Screen=none"]
        if ranks > 1:
            command = ["mpirun", "-n", str(ranks)] + command
        for entry in (*entries, *self.entries):
            command += ["--set", entry]
        with tempfile.TemporaryDirectory() as scratch:
            start = time.perf_counter()
            process = subprocess.Popen(command, cwd=scratch,
                                       stdout=subprocess.DEVNULL,
                                       env={**os.environ, **ONE_CORE})
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            wall = time.perf_counter() - start
            if process.returncode != 0:
                self.failures += 1
                print(f"| {case} | {ranks} | status {process.returncode} |",
                      flush=True)
                return None
            summary = json.loads((pathlib.Path(scratch) / "output" / case /
                                  "summary.json").read_text())
        return summary, usage.ru_utime + usage.ru_stime, wall

    def row(self, label, case, entries, ranks=1, tied=None):
        """Prints a row; returns its CPU seconds."""
        result = self.run(case, entries, ranks)
        if result is None:
            return None
        summary, cpu, wall = result
        finest = summary["levels"][-1]
        of_finest = [i for i in summary["increments"]
                     if i["level"] == len(summary["levels"]) - 1]
        newton = sum(i["newton_iterations"] for i in of_finest)
        linear = sum(i["linear_iterations"] for i in of_finest)
        unknowns = finest["displacements"]
        phases = {name: time["cpu"] for name, time in summary["time"].items()}
        cells = [label, ranks, unknowns, finest["multipliers"], newton,
                 finest["system"].split()[-1],
                 f"{linear / max(newton, 1):.1f}", f"{cpu:.1f}",
                 f"{cpu / tied:.2f}" if tied else "-", f"{wall:.1f}",
                 *(f"{phases.get(phase, 0.):.1f}" for phase in PHASES),
                 f"{summary['peak_memory_mb']:.0f}",
                 f"{summary['peak_memory_mb'] * 2**20 / 1e3 / unknowns:.2f}"]
        print("| " + " | ".join(map(str, cells)) + " |", flush=True)
        return cpu


def head(title):
    print(f"{title}, load average before: {os.getloadavg()[0]:.2f}\n")
    print("| " + " | ".join(COLUMNS) + " |")
    print("|---" * len(COLUMNS) + "|", flush=True)


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("contact", type=pathlib.Path)
    parser.add_argument("--levels", type=int, default=3,
                        help="of the finest mesh [3]")
    parser.add_argument("--degree", type=int, default=2,
                        help="of the elements [2]")
    parser.add_argument("--ranks", default="1,2",
                        help="numbers of processes on it [1,2]; '' for none")
    parser.add_argument("--set", action="append", default=[],
                        metavar="ENTRY=VALUE", help="of all runs")
    return parser.parse_args()


def main():
    options = parse()
    scaling = Scaling(options)
    head("One process")
    for level in range(min(1, options.levels), options.levels + 1):
        levels = [f"Refinement/Levels={level}"]
        tied = scaling.row("tied", "nested_space_tied",
                           [f"Mesh/Refinements={level}"])
        scaling.row("no friction", "nested_space", levels, tied=tied)
    scaling.row("friction 0.1, one increment", "nested_space_friction",
                [*levels, "Solution/Increments=1"], tied=tied)
    scaling.row("friction 0.1, two increments", "nested_space_friction", levels,
                tied=tied)
    ranks = [int(n) for n in options.ranks.split(",") if n]
    if ranks:
        print()
        head("Several processes; memory is that of all")
        for n in ranks:
            scaling.row("no friction", "nested_space", levels, ranks=n)
    return int(scaling.failures > 0)


if __name__ == "__main__":
    sys.exit(main())
