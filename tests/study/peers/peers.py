#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contact program beside GetFEM and CalculiX, on the same meshes.

    peers.py [--quick] [--levels N] [--seconds S] [--output DIR] CONTACT

CONTACT is the program. The problem is that of parameters/nested_large.prm:
large displacement, the load spread over Cap, without and with friction, in
INCREMENTS steps. All runs are made anew, one at a time and on one thread; none
takes more than S seconds of CPU, and a finer mesh is left out if it would, by
GROWTH times those of the mesh before, or of a failed run by GROWTH_OF_FAILED
times. Runs of less than a CPU second are the best of BEST_OF. DIR gets the
meshes, peers.json (all results) and peers.md.

Exit status: 0, 1 if a run of the contact program has failed, 2 if the call is
wrong.
"""

import argparse
import dataclasses
import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

import mesh as meshes
from peers_table import report

HERE = pathlib.Path(__file__).resolve().parent
CASE = HERE.parents[2] / "parameters" / "nested_large.prm"
LOAD = -17500.
INCREMENTS = 2
FRICTION = 0., .1
ELEMENTS = {1: "4 nodes", 2: "8 nodes"}
NINE_NODES = (("Element/Centre node", "free"),)
# Of CalculiX [N/mm^3]: 5 and 50 times Young's modulus of the block, between
# which its manual wants them.
PENALTIES = "3.5e5", "3.5e6"
REQUESTS = "1 %", "0.1 %", "0.01 %"
# Adaptive refinements that make the reference.
REFERENCE_LEVELS, REFERENCE_LEVELS_QUICK = 16, 12
RULES = "mortar", "Gauss"
BEST_OF = 2
GROWTH, GROWTH_OF_FAILED = 4, 16
OURS = "contact"
ENVIRONMENT = {name: "1" for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS",
                                      "DEAL_II_NUM_THREADS")}
# Entries of all runs of the contact program, beside CASE.
ENTRIES = {
    "Mesh/Arcs": meshes.ARCS,
    "Contact/Discretization": "mortar",
    "Solution/Geometry": "automatic",
    "Solution/Friction": "Newton",
    "Solution/Increments": str(INCREMENTS),
    "Refinement/Levels": "0",
    "Probes/References": "",
    "Probes/Tolerances": "",
    "Output/Screen": "none",
}


@dataclasses.dataclass(frozen=True)
class Case:
    """A run of a sequence: what it is called, its mesh, and further entries of
    the contact program, in pairs."""
    label: str
    level: int
    entries: tuple = ()


@dataclasses.dataclass(frozen=True)
class Sequence:
    """Runs that differ in their accuracy only, the cheapest first; with
    arguments for the driver of a peer, or entries of the contact program."""
    program: str
    formulation: str
    element: str
    degree: int
    friction: float
    cases: tuple
    arguments: tuple = ()
    entries: tuple = ()


def words(entries):
    """Entries as options of the contact program."""
    return [word for name, value in entries.items()
            for word in ("--set", f"{name}={value}")]


def contact_sequences(cases, friction):
    """Mortar and Gauss points on the meshes of the peers, and mortar on the
    program's own."""
    for rule in RULES:
        for degree, element in ELEMENTS.items():
            yield Sequence(OURS, rule, element, degree, friction, cases,
                           entries=(("Contact/Discretization", rule),))
    requests = tuple(
        Case(f"asked {text}", 0, (("Probes/Accuracy", f"DY(B): {text}"),))
        for text in REQUESTS)
    yield Sequence(f"{OURS}, adaptive", "mortar", "9 nodes", 2, friction,
                   requests, entries=NINE_NODES)


def calculix_formulations(friction, quick):
    """Their names, elements, and the arguments of the driver."""
    steps = ("--increments", str(INCREMENTS))
    soft, stiff = (("--penalty", penalty) for penalty in PENALTIES)
    yield "surface to surface, 50 E", ELEMENTS, (*stiff, *steps)
    if friction == 0:
        # Of elements of 4 nodes, as these runs are long.
        yield "surface to surface, 50 E, own increments", (1,), stiff
        if not quick:
            yield "surface to surface, 5 E", ELEMENTS, (*soft, *steps)
    if not quick:
        yield ("node to surface, 50 E", ELEMENTS,
               ("--contact", "node", *stiff, *steps))
    yield "mortar", ELEMENTS, ("--contact", "mortar", *steps)


def all_sequences(levels, quick):
    cases = tuple(Case(str(level), level) for level in range(levels + 1))
    for friction in FRICTION:
        yield from contact_sequences(cases, friction)
        for degree, element in ELEMENTS.items():
            yield Sequence("GetFEM", "raytracing", element, degree, friction,
                           cases, ("--increments", str(INCREMENTS)))
        for formulation, degrees, arguments in calculix_formulations(friction,
                                                                     quick):
            for degree in degrees:
                yield Sequence("CalculiX", formulation, ELEMENTS[degree],
                               degree, friction, cases, arguments)


def measured(command, folder, seconds):
    """Run a command: output, wall and CPU seconds, memory [MB], and what went
    wrong."""
    with open(folder / "out", "wb") as out, open(folder / "err", "wb") as err:
        start = time.perf_counter()
        process = subprocess.Popen(["prlimit", f"--cpu={seconds}", *command],
                                   stdin=subprocess.DEVNULL, stdout=out,
                                   stderr=err,
                                   env={**os.environ, **ENVIRONMENT})
        _, status, usage = os.wait4(process.pid, 0)
    wall = time.perf_counter() - start
    process.returncode = os.waitstatus_to_exitcode(status)
    text, errors = ((folder / name).read_text(errors="replace")
                    for name in ("out", "err"))
    cpu = usage.ru_utime + usage.ru_stime
    reason = ""
    if process.returncode < 0 and cpu > seconds - 1:
        reason = f"no end within {seconds} s of CPU"
    elif process.returncode not in (0, 1):
        reason = f"status {process.returncode}: {errors.strip()[-100:]}"
    return text, {"wall": wall, "cpu": cpu, "memory": usage.ru_maxrss / 1024,
                  "reason": reason}


def contact_result(summary, serendipity):
    """The keys of the drivers, from summary.json."""
    last = summary["levels"][-1]
    of_last = [step for step in summary["increments"]
               if step["level"] == len(summary["levels"]) - 1]
    # Centre nodes that the others bind are no unknowns.
    bound = 2 * last["cells"] if serendipity else 0
    return {"unknowns": last["displacements"] + last["multipliers"] - bound,
            "newton": sum(l["newton_iterations"] for l in summary["levels"]),
            "increments": len(of_last), **last["probes"],
            "force_error":
                of_last[-1]["reactions"]["Encast"]["y"] / -LOAD - 1,
            "reason": summary["accuracy_missed"] if summary["converged"] else
                      summary["message"]}


def name_of(sequence, case):
    """The columns that say which run a row is."""
    return {"program": sequence.program, "formulation": sequence.formulation,
            "element": sequence.element, "friction": sequence.friction,
            "label": case.label}


def too_long(row, seconds):
    """Whether the run behind this one would be."""
    growth = GROWTH if row["ok"] else GROWTH_OF_FAILED
    return row["cpu"] * growth > seconds


class Comparison:
    """Where programs and files are, and how to run one of them."""

    def __init__(self, options):
        self.contact = str(options.contact.resolve())
        self.folder = options.output.resolve()
        self.seconds = options.seconds
        self.best_of = 1 if options.quick else BEST_OF

    def run_contact(self, sequence, case, seconds):
        scratch = self.folder / "scratch"
        entries = {**ENTRIES,
                   "Mesh/File": self.folder / f"level_{case.level}.msh",
                   "Element/Degree": sequence.degree,
                   "Element/Centre node": "serendipity",
                   "Contact/Friction coefficient": sequence.friction,
                   "Output/Directory": scratch,
                   **dict(sequence.entries), **dict(case.entries)}
        _, result = measured([self.contact, str(CASE), "--quiet",
                              *words(entries)], scratch, seconds)
        path = scratch / CASE.stem / "summary.json"
        if not result["reason"] and path.exists():
            serendipity = sequence.element == ELEMENTS[2]
            result.update(contact_result(json.loads(path.read_text()),
                                         serendipity))
        return result

    def run_driver(self, sequence, case, seconds):
        """A peer: its driver writes a line of JSON."""
        mesh = self.folder / f"level_{case.level}_{sequence.degree}.npz"
        command = ["/usr/bin/python3", "", str(mesh), "--friction",
                   str(sequence.friction), *sequence.arguments]
        scratch = self.folder / "scratch"
        if sequence.program == "GetFEM":
            command[1] = str(HERE / "getfem_driver.py")
            text, result = measured(command, scratch, seconds)
            said = json.loads(text) if text.startswith("{") else {}
            return {**said, **result,
                    "reason": result["reason"] or said.get("reason", "")}
        # The driver limits and measures ccx alone.
        command[1] = str(HERE / "calculix_driver.py")
        text, result = measured([*command, "--seconds", str(seconds)], scratch,
                                seconds + 30)
        return {**result, **(json.loads(text) if text.startswith("{") else {})}

    def run_once(self, sequence, case, seconds):
        scratch = self.folder / "scratch"
        shutil.rmtree(scratch, ignore_errors=True)
        scratch.mkdir()
        run = (self.run_contact if sequence.program.startswith(OURS) else
               self.run_driver)
        result = run(sequence, case, seconds)
        shutil.rmtree(scratch)
        if "DY(B)" not in result and not result["reason"]:
            result["reason"] = "no result"
        result["ok"] = not result["reason"]
        return result

    def run(self, sequence, case, seconds=None):
        """A row of the table."""
        seconds = seconds or self.seconds
        result = self.run_once(sequence, case, seconds)
        for _ in range(self.best_of - 1):
            if not result["ok"] or result["cpu"] > 1:
                break
            result = min(result, self.run_once(sequence, case, seconds),
                         key=lambda r: (not r["ok"], r["cpu"]))
        row = {**name_of(sequence, case), **result}
        print(f"{row['program']}, {row['formulation']}, {row['element']}, "
              f"mu {row['friction']}, {row['label']}: "
              f"{row['reason'] or 'done'} ({row['wall']:.1f} s)", flush=True)
        return row

    def rows(self, sequence):
        """Up to the first run that would take too long."""
        rows = []
        for case in sequence.cases:
            if rows and too_long(rows[-1], self.seconds):
                before = rows[-1]
                rows.append({**name_of(sequence, case), "ok": False,
                             "skipped": True,
                             "reason": f"not run, as {before['label']} took "
                                       f"{before['cpu']:.0f} s of CPU"})
                break
            rows.append(self.run(sequence, case))
        return rows

    def reference(self, friction, levels):
        """The contact program on meshes of its own; and four levels less."""
        cases = [Case(f"{n} adaptive", 0, (("Refinement/Strategy", "adaptive"),
                                           ("Refinement/Levels", n)))
                 for n in (levels, levels - 4)]
        sequence = Sequence(OURS, "mortar, reference", "9 nodes", 2, friction,
                            tuple(cases), entries=NINE_NODES)
        runs = [self.run(sequence, case, 300) for case in cases]
        if not all(run["ok"] for run in runs):
            sys.exit("peers.py: there is no reference: " + ", ".join(
                run["reason"] for run in runs if run["reason"]))
        return runs


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("contact", type=pathlib.Path, help="the program")
    parser.add_argument("--quick", action="store_true",
                        help="levels 0 and 1 and fewer formulations: a minute")
    parser.add_argument("--levels", type=int, help="the finest one [3]")
    parser.add_argument("--seconds", type=int,
                        help="limit of a run [40, with --quick 5]")
    parser.add_argument("--output", type=pathlib.Path, default="peers",
                        metavar="DIR", help="where results go [peers]")
    options = parser.parse_args()
    if options.levels is None:
        options.levels = 1 if options.quick else 3
    if options.seconds is None:
        options.seconds = 5 if options.quick else 40
    if not os.access(options.contact, os.X_OK) or options.contact.is_dir():
        parser.error(f"{options.contact} is not a program: build it first")
    if not importlib.util.find_spec("getfem"):
        parser.error("GetFEM is missing: apt-get install python3-getfem, and "
                     "call with /usr/bin/python3")
    if not shutil.which("ccx"):
        parser.error("CalculiX is missing: apt-get install calculix-ccx")
    return options


def main():
    options = parse()
    load_before = os.getloadavg()[0]
    meshes.write_levels(options.output, options.levels)
    comparison = Comparison(options)
    levels = REFERENCE_LEVELS_QUICK if options.quick else REFERENCE_LEVELS
    references = [{"friction": friction,
                   "runs": comparison.reference(friction, levels)}
                  for friction in FRICTION]
    rows = [row for sequence in all_sequences(options.levels, options.quick)
            for row in comparison.rows(sequence)]
    results = {"references": references, "rows": rows,
               "increments": INCREMENTS, "seconds": options.seconds,
               "load": [load_before, os.getloadavg()[0]]}
    (options.output / "peers.json").write_text(json.dumps(results, indent=1))
    (options.output / "peers.md").write_text(report(results))
    print(f"The table is in {options.output / 'peers.md'}")
    return int(any(not row["ok"] and not row.get("skipped") for row in rows
                   if row["program"].startswith(OURS)))


if __name__ == "__main__":
    sys.exit(main())
