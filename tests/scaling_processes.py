#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where strong and weak scaling end, from what a machine of a few cores can
measure: complete runs on 1, 2 and 4 processes on two meshes, and the messages
that they send.

    scaling_processes.py CONTACT [--levels PLANE,SPACE] [--ranks N,N...]
                         [--repeat N] [--latency US] [--bandwidth GB/S]

The time of P processes on N unknowns, S of them on the slave, is modelled by

    T = v N / P + p S / P + s S + c + C,

v the bodies and p the pairing, which are distributed, s what every process does
for the whole surface, c the start and the coarsest mesh. The four, not negative,
are fitted by least squares of the relative errors to the work P T of the runs,
whose C is part of the others; where there are more processes than cores, the
work is the wall time by the number of cores. C is that of a cluster,

    C = latency (m + 2 q log2(P)) + bytes / bandwidth,

from the run of most processes, counted by the monitoring of Open MPI: of the
process that sends most, m messages to neighbors, which grow with the number of
levels and from the neighbors there to all 8 of the plane or 26 of space, q
collective operations, bytes to neighbors as (N / P)^(1 - 1/d) and to all as S.
The peak of the memory by processes is fitted in the same way, without p.

Markdown. Not a test: nothing is asserted but convergence. Results go to a
scratch directory.
"""

import argparse
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import numpy
from scipy.optimize import nnls

PARAMETERS = pathlib.Path(__file__).resolve().parent.parent / "parameters"
ONE_CORE = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1",
            "DEAL_II_NUM_THREADS": "1"}
# The program takes ob1 alone, unless it is told.
MONITORING = ["--mca", "pml", "ob1,monitoring",
              "--mca", "pml_monitoring_enable", "2",
              "--mca", "pml_monitoring_enable_output", "3",
              "--mca", "pml_monitoring_filename", "messages"]
SIZES = 1e6, 1e7, 1e8, 1e9


class Messages:
    """Those that the busiest process sends in a run."""

    def __init__(self, directory):
        self.count = self.bytes = self.of_collectives = self.collectives = 0
        self.neighbors = 1
        for file in directory.glob("messages.*.prof"):
            text = file.read_text()
            sent = re.findall(r"^E\t\d+\t\d+\t(\d+) bytes\t(\d+) msgs", text,
                              re.M)
            self.count = max(self.count, sum(int(n) for _, n in sent))
            self.bytes = max(self.bytes, sum(int(b) for b, _ in sent))
            self.neighbors = max(self.neighbors, len(sent))
            inside = re.findall(r"^C\t\d+\t\d+\t(\d+) bytes", text, re.M)
            self.of_collectives = max(self.of_collectives,
                                      sum(map(int, inside)))
            # Communicators of one process send nothing.
            collectives = 0
            for part in text.split("\nD\t")[1:]:
                if "," in part.split("\n")[0].split("procs:")[1]:
                    collectives += sum(
                        int(n) for n in re.findall(r"bytes\t(\d+) msgs", part))
            self.collectives = max(self.collectives, collectives)


class Run:
    def __init__(self, options, case, level, ranks):
        command = [str(options.contact.resolve()),
                   str(PARAMETERS / f"{case}.prm"), "--quiet",
                   "--set", "Output/Screen=none",
                   "--set", "Element/Degree=2",
                   "--set", "Element/Centre node=free",
                   "--set", "Solution/Linear solver=GMG",
                   "--set", "Probes/References=",
                   "--set", "Probes/Tolerances=",
                   "--set", f"Refinement/Levels={level}"]
        if ranks > 1:
            command = ["mpirun", "-n", str(ranks), *MONITORING] + command
        with tempfile.TemporaryDirectory() as scratch:
            start = time.perf_counter()
            subprocess.run(command, cwd=scratch, check=True,
                           stdout=subprocess.DEVNULL,
                           env={**os.environ, **ONE_CORE})
            self.wall = time.perf_counter() - start
            directory = pathlib.Path(scratch)
            summary = json.loads((directory / "output" / case /
                                  "summary.json").read_text())
            self.messages = Messages(directory)
        if ranks > 1 and self.messages.count == 0:
            sys.exit("Open MPI has counted no messages")
        finest = summary["levels"][-1]
        self.ranks = ranks
        self.unknowns = finest["displacements"]
        self.points = finest["multipliers"]
        self.levels = len(summary["levels"])
        self.memory = summary["peak_memory_mb"] * 2**20
        self.linear = sum(i["linear_iterations"]
                          for i in summary["increments"])
        self.work = self.wall * min(ranks, os.cpu_count())


def fit(runs, columns, values):
    """Factors >= 0 of least relative errors, and the largest of these."""
    matrix = numpy.array([[column(run) for column in columns] for run in runs])
    values = numpy.array(values)
    factors, _ = nnls(matrix / values[:, None], numpy.ones(len(values)))
    return factors, numpy.max(numpy.abs(matrix @ factors / values - 1))


class Model:
    def __init__(self, runs, dim, options):
        self.last = max(runs, key=lambda run: (run.ranks, run.unknowns))
        self.dim = dim
        self.options = options
        (self.v, self.p, self.s, self.c), self.error = fit(
            runs,
            [lambda r: r.unknowns, lambda r: r.points,
             lambda r: r.points * r.ranks, lambda r: r.ranks],
            [run.work for run in runs])
        self.memory, self.memory_error = fit(
            runs,
            [lambda r: r.unknowns, lambda r: r.points * r.ranks,
             lambda r: r.ranks],
            [run.memory for run in runs])

    def points(self, unknowns):
        return self.last.points * (unknowns / self.last.unknowns) ** (
            1 - 1 / self.dim)

    def communication(self, unknowns, ranks):
        if ranks == 1:
            return 0
        last, messages = self.last, self.last.messages
        levels = 1 + (math.log2(unknowns / last.unknowns) /
                      self.dim / last.levels)
        neighbors = (min(ranks - 1, 3**self.dim - 1) / messages.neighbors)
        part = (unknowns / ranks) / (last.unknowns / last.ranks)
        sent = (messages.bytes * part ** (1 - 1 / self.dim) +
                messages.of_collectives * self.points(unknowns) / last.points)
        return (self.options.latency * 1e-6 * levels *
                (messages.count * neighbors +
                 messages.collectives * 2 * math.log2(ranks)) +
                sent / (self.options.bandwidth * 1e9))

    def time(self, unknowns, ranks):
        points = self.points(unknowns)
        return ((self.v * unknowns + self.p * points) / ranks +
                self.s * points + self.c + self.communication(unknowns, ranks))

    def bytes(self, unknowns, ranks):
        return (self.memory[0] * unknowns / ranks +
                self.memory[1] * self.points(unknowns) + self.memory[2])

    def end_of_strong(self, unknowns):
        """The largest power of two with an efficiency of a half."""
        ranks = 1
        while self.time(unknowns, 1) > ranks * self.time(unknowns, 2 * ranks):
            ranks *= 2
        return ranks


def rounded(number):
    return f"{number:.3g}"


def table(columns, rows):
    print("| " + " | ".join(columns) + " |")
    print("|---" * len(columns) + "|")
    for row in rows:
        print("| " + " | ".join(map(str, row)) + " |")
    print(flush=True)


def measured(case, runs):
    one = {run.unknowns: run for run in runs if run.ranks == 1}
    return [[case, run.unknowns, run.points, run.ranks, f"{run.wall:.2f}",
             f"{one[run.unknowns].wall / run.wall:.2f}", run.linear,
             f"{run.memory / 1e6:.0f}",
             *((run.messages.count, rounded(run.messages.bytes / 1e6),
                run.messages.collectives,
                rounded(run.messages.of_collectives / 1e6))
               if run.ranks > 1 else "----")] for run in runs]


def study(case, dim, level, options):
    runs = []
    for size in (level - 1, level):
        for ranks in options.ranks:
            runs.append(min((Run(options, case, size, ranks)
                             for _ in range(options.repeat)),
                            key=lambda run: run.wall))
    return runs, Model(runs, dim, options)


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("contact", type=pathlib.Path)
    parser.add_argument("--levels", default="5,3",
                        help="of refinement in 2-D and in 3-D [5,3]")
    parser.add_argument("--ranks", default="1,2,4",
                        help="numbers of processes [1,2,4]")
    parser.add_argument("--repeat", type=int, default=2,
                        help="runs, of which the fastest counts [2]")
    parser.add_argument("--latency", type=float, default=2,
                        help="of a message [2 us]")
    parser.add_argument("--bandwidth", type=float, default=10,
                        help="of a process [10 GB/s]")
    options = parser.parse_args()
    options.levels = [int(n) for n in options.levels.split(",")]
    options.ranks = [int(n) for n in options.ranks.split(",")]
    return options


def main():
    options = parse()
    print(f"`./run scaling processes`, load average before: "
          f"{os.getloadavg()[0]:.2f}, cores: {os.cpu_count()}\n", flush=True)
    studies = {"plane": study("nested", 2, options.levels[0], options),
               "space": study("nested_space", 3, options.levels[1], options)}
    table(["", "unknowns", "points", "processes", "wall [s]", "speed-up",
           "linear iterations", "memory of all [MB]", "messages", "[MB]",
           "collectives", "[MB]"],
          [row for name, (runs, _) in studies.items()
           for row in measured(name, runs)])
    table(["", "v [us]", "p [us]", "s [us]", "c [s]", "largest error",
           "memory: by unknown [B]", "by point and process [B]",
           "by process [MB]", "largest error"],
          [[name, rounded(m.v * 1e6), rounded(m.p * 1e6), rounded(m.s * 1e6),
            rounded(m.c), f"{m.error:.0%}", rounded(m.memory[0]),
            rounded(m.memory[1]), rounded(m.memory[2] / 1e6),
            f"{m.memory_error:.0%}"] for name, (_, m) in studies.items()])
    rows = []
    for name, (_, m) in studies.items():
        for n in SIZES:
            end = m.end_of_strong(n)
            weak = max(1, round(n / 1e6))
            rows.append([name, f"{n:.0e}", rounded(m.time(n, 1)), end,
                         rounded(m.time(n, end)),
                         rounded(m.s * m.points(n)),
                         rounded(m.communication(n, end)),
                         rounded(m.bytes(n, end) / 1e9),
                         f"{m.time(1e6, 1) / m.time(n, weak):.0%}",
                         rounded(m.time(n, weak)),
                         rounded(m.bytes(n, weak) / 1e9)])
    table(["", "unknowns", "one process [s]",
           "processes at an efficiency of 50 %", "their time [s]",
           "of it the whole surface [s]", "messages [s]", "memory of each [GB]",
           "a million unknowns each: efficiency", "time [s]",
           "memory of each [GB]"], rows)


if __name__ == "__main__":
    sys.exit(main())
