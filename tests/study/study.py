#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the matrix of cases (matrix.py), one at a time, and reports.

    study.py [--quick] [--problem NAME ...] [--output DIR] CONTACT

CONTACT is the program; closed_form_errors, which compares its results, is
looked for where the build of CONTACT puts it. A finished run is kept in
DIR/runs and used again as long as program, input files and arguments are the
same: after an interruption the next call goes on with what is missing. Exit
status: 0, 1 if a check or a run has failed, 2 if the call is wrong, 130 or 143
if interrupted.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import analysis
import matrix
import report

DEFAULT_PARAMETERS = Path(__file__).resolve().parents[2] / "parameters"
# Entries of every run: no file but the summary, and no values to pass.
COMMON = {
    "Probes/References": "",
    "Probes/Tolerances": "",
    "Output/Screen": "table",
    "Output/VTU": "false",
    "Output/Profile": "false",
}
ENVIRONMENT = {name: "1" for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS",
                                      "DEAL_II_NUM_THREADS")}
# Of runs shorter than a second, in problems where their time is looked at.
BEST_OF = 3
TIMED = ("ssnp154", "knobs")
TIME_LIMIT = 300


def compare(program: Path, run: matrix.Run, file: Path, results: Path) -> dict:
    """Values of the closed form of a run, and the errors against them."""
    ended = subprocess.run([program, run.closed_form, file, *arguments(run),
                            results], capture_output=True, text=True,
                           env={**os.environ, **ENVIRONMENT})
    if ended.returncode != 0:
        sys.exit(f"study.py: {run.id} is not compared: {ended.stderr}")
    return json.loads(ended.stdout)


class Interrupted(Exception):
    """By a signal, whose number it carries."""


def on_signal(number, _frame):
    raise Interrupted(number)


def input_files(path: Path) -> list[Path]:
    """A parameter file, what it includes, and the meshes that these name."""
    if not path.is_file():
        sys.exit(f"study.py: {path} does not exist: give the directory of the "
                 "parameter files with --parameters")
    files = [path]
    for line in path.read_text().splitlines():
        include = re.match(r"\s*include\s+(\S+)", line)
        mesh = re.match(r"\s*set\s+File\s*=\s*(\S+)", line)
        if include:
            files += input_files(path.parent / include[1])
        elif mesh:
            files.append(path.parent / mesh[1])
    return files


def digest(*parts: bytes) -> str:
    """One hash of several pieces, each by its own, so that borders count."""
    total = hashlib.sha256()
    for part in parts:
        total.update(hashlib.sha256(part).digest())
    return total.hexdigest()


def arguments(run: matrix.Run) -> list[str]:
    """The options that make the run what it is."""
    entries = {**COMMON, **run.entries()}
    if run.closed_form:
        entries["Output/Profile"] = "true"
    if run.closed_form.startswith("concentric"):
        entries["Output/Nodes"] = "true"
    return [word for entry, value in entries.items()
            for word in ("--set", f"{entry}={value}")]


def command_text(run: matrix.Run) -> str:
    """The command to type, without what has no influence on the results."""
    words = ["contact", f"parameters/{run.file}"]
    for entry, value in run.entries().items():
        words += ["--set", f"{entry}={value}"]
    return shlex.join(words)


def write_atomically(path: Path, text: str) -> None:
    """All of it or nothing, whatever happens."""
    scratch = path.with_suffix(".part")
    scratch.write_text(text)
    os.replace(scratch, path)


def timed(command: list[str], log: Path) -> dict:
    """Run a command: its status, wall and CPU seconds, and memory [MB]."""
    with open(log, "wb") as output:
        start = time.perf_counter()
        # A session of its own: Ctrl-C reaches the study only, which ends it.
        process = subprocess.Popen(command, stdout=output, stderr=output,
                                   stdin=subprocess.DEVNULL,
                                   env={**os.environ, **ENVIRONMENT},
                                   start_new_session=True)
    timer = threading.Timer(TIME_LIMIT, process.kill)
    timer.start()
    try:
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
    except BaseException:
        process.kill()
        process.wait()
        raise
    finally:
        timer.cancel()
    return {"status": process.returncode, "wall": wall,
            "cpu": usage.ru_utime + usage.ru_stime,
            "memory_mb": usage.ru_maxrss / 1024}


class Study:
    """The runs, where their results are, and how far they have come."""

    def __init__(self, options):
        self.contact = options.contact.resolve()
        self.closed_forms = (options.closed_forms or self.contact.parent /
                             "tests/closed_form_errors").resolve()
        if not self.closed_forms.is_file():
            sys.exit(f"study.py: {self.closed_forms} is missing: build it, or "
                     "say where it is with --closed-forms")
        self.parameters = options.parameters.resolve()
        self.output = options.output.resolve()
        self.quick = options.quick
        self.program_hash = self.hash_of_program()
        (self.output / "runs").mkdir(parents=True, exist_ok=True)
        self.start = time.perf_counter()
        self.spent = self.expected = 0.0  # of finished runs, by clock and prior

    def best_of(self, run: matrix.Run) -> int:
        """How often a short run is repeated."""
        return (BEST_OF if run.problem.startswith(TIMED) and not self.quick
                else 1)

    def hash_of_program(self) -> str:
        return hashlib.sha256(self.contact.read_bytes()).hexdigest()

    def key(self, run: matrix.Run) -> str:
        """What the result depends on."""
        # Read anew each time: somebody may edit the files while the study runs.
        files = input_files(self.parameters / run.file)
        text = [self.program_hash, digest(*(f.read_bytes() for f in files)),
                f"best of {self.best_of(run)}", *arguments(run)]
        if run.closed_form:
            text += [run.closed_form, digest(self.closed_forms.read_bytes())]
        return digest(*(t.encode() for t in text))

    def path(self, run: matrix.Run) -> Path:
        return self.output / "runs" / f"{run.id}.json"

    def finished(self, run: matrix.Run) -> dict | None:
        """Its result of an earlier call, if that still holds."""
        try:
            result = json.loads(self.path(run).read_text())
        except (OSError, ValueError):
            return None
        return result if result.get("key") == self.key(run) else None

    def execute(self, run: matrix.Run) -> dict:
        """Run it, several times if it is short, and keep the result."""
        scratch = self.output / "scratch"
        shutil.rmtree(scratch, ignore_errors=True)
        scratch.mkdir()
        log = scratch / "log"
        command = [str(self.contact), str(self.parameters / run.file), "--quiet",
                   *arguments(run), "--set", f"Output/Directory={scratch}"]
        key = self.key(run)  # before: an edit meanwhile must not go unnoticed
        begin = time.perf_counter()
        measured = timed(command, log)
        for _ in range(self.best_of(run) - 1):
            if measured["status"] not in (0, 1) or measured["wall"] > 1:
                break
            measured = min(measured, timed(command, log),
                           key=lambda m: (m["status"] > 1, m["wall"]))
        summaries = list(scratch.glob("*/summary.json"))
        summary = json.loads(summaries[0].read_text()) if summaries else {}
        result = {"key": key, "command": command_text(run),
                  "spent": time.perf_counter() - begin, **measured,
                  "message": failure(measured, summary, log),
                  "summary": summary}
        if summary.get("converged") and run.closed_form:
            result["closed_form"] = compare(
                self.closed_forms, run, self.parameters / run.file,
                summaries[0].parent)
        shutil.rmtree(scratch)
        write_atomically(self.path(run), json.dumps(result, indent=1))
        return result

    def start_up(self) -> dict:
        """What the program takes to do nothing, the best of three."""
        log = self.output / "log"
        best = min((timed([str(self.contact), "--help"], log) for _ in range(3)),
                   key=lambda m: m["wall"])
        log.unlink()
        return {"id": "start-up", "problem": "start-up", "ok": 1,
                "status": best["status"], "wall": best["wall"],
                "cpu": best["cpu"], "memory_mb": best["memory_mb"],
                "command": "contact --help"}

    def count(self, run: matrix.Run, result: dict) -> None:
        self.spent += result["spent"]
        self.expected += self.prior(run)

    def prior(self, run: matrix.Run) -> float:
        """Seconds to expect of a run, with its repetitions."""
        seconds = run.prior_seconds()
        return seconds * (self.best_of(run) if seconds < 1 else 1)

    def remaining(self, runs: list[matrix.Run]) -> float:
        """Seconds for these runs, by what others took beside their prior."""
        scale = self.spent / self.expected if self.expected > 0 else 1
        return scale * sum(self.prior(run) for run in runs)

    def all(self, runs: list[matrix.Run]) -> list[dict]:
        """A row of the table for each run."""
        done = {run: self.finished(run) for run in runs}
        for run, result in done.items():
            if result:
                self.count(run, result)
        missing = [run for run in runs if not done[run]]
        if len(missing) < len(runs):
            print(f"{len(runs) - len(missing)} of {len(runs)} runs are there "
                  "already.")
        for i, run in enumerate(missing):
            position = f"[{len(runs) - len(missing) + i + 1}/{len(runs)}]"
            self.show(f"{position} {run.id}", missing[i:], "starts")
            done[run] = self.execute(run)
            self.count(run, done[run])
            outcome = done[run]["message"] or f"{done[run]['wall']:.2f} s"
            self.show(f"{position} {run.id}: {outcome}", missing[i + 1:],
                      "failed" if done[run]["message"] else "done")
        if sys.stdout.isatty():
            print("\r\033[K", end="")
        self.require_same_inputs(runs)
        return [analysis.row(run, done[run]) for run in runs]

    def require_same_inputs(self, runs: list[matrix.Run]) -> None:
        """Results of different programs or inputs make no table."""
        if self.hash_of_program() != self.program_hash:
            sys.exit(f"study.py: {self.contact} was rebuilt while the study ran: "
                     "no table is written; call again, with a copy of it")
        stale = [run.file for run in runs if not self.finished(run)]
        if stale:
            sys.exit("study.py: changed while the study ran: "
                     f"{', '.join(sorted(set(stale)))}, or a file that it names; "
                     "no table is written; the same call repeats its runs")

    def show(self, text: str, missing: list[matrix.Run], state: str) -> None:
        """Progress: in place on a terminal, otherwise a line for each run."""
        times = (f"elapsed {clock(time.perf_counter() - self.start)}, about "
                 f"{clock(self.remaining(missing))} left")
        if sys.stdout.isatty():
            width = shutil.get_terminal_size().columns - len(times) - 3
            line = f"{text[:width]}  {times}"
            print(f"\r\033[K{line}", end="\n" if state == "failed" else "",
                  flush=True)
        elif state != "starts":
            print(f"{text}  ({times})", flush=True)


def clock(seconds: float) -> str:
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


def failure(measured: dict, summary: dict, log: Path) -> str:
    """What went wrong, in one line; empty if nothing did."""
    status = measured["status"]
    if status in (0, 1) and summary.get("converged"):
        return ""
    if status == -signal.SIGKILL and measured["wall"] >= TIME_LIMIT:
        return f"stopped after {TIME_LIMIT} s"
    lines = [line.strip() for line in
             log.read_text(errors="replace").splitlines() if line.strip()]
    text = summary.get("message") or " ".join(lines[-3:]) or "no message"
    return f"status {status}: {text[:300]}"


def parse(argv):
    parser = argparse.ArgumentParser(
        description="Accuracy against cost: runs the matrix of cases.",
        epilog="Problems: " + ", ".join(matrix.problems()))
    parser.add_argument("contact", nargs="?", help="the program")
    parser.add_argument("--quick", action="store_true",
                        help="a few small runs, with checks (minutes)")
    parser.add_argument("--problem", nargs="+", action="extend", default=[],
                        metavar="NAME", help="only these")
    parser.add_argument("--output", type=Path, default=Path("study"),
                        metavar="DIR", help="where results go [study]")
    parser.add_argument("--parameters", type=Path, default=DEFAULT_PARAMETERS,
                        metavar="DIR", help="where the parameter files are")
    parser.add_argument("--closed-forms", type=Path, metavar="PROGRAM",
                        help="compares results with closed forms "
                        "[beside CONTACT: tests/closed_form_errors]")
    parser.add_argument("--list", action="store_true",
                        help="print the commands of all runs and stop")
    options = parser.parse_args(argv)
    # After names of problems the program is taken for one of them.
    if not options.contact and options.problem:
        options.contact = options.problem.pop()
    if not options.contact:
        parser.error("CONTACT is missing: the program, as in build/contact")
    options.contact = Path(options.contact)
    unknown = set(options.problem) - set(matrix.problems())
    if unknown:
        parser.error(f"--problem {' '.join(sorted(unknown))}: no such problem; "
                     f"there are {', '.join(matrix.problems())}")
    if not os.access(options.contact, os.X_OK) or options.contact.is_dir():
        parser.error(f"{options.contact} is not a program: build it first")
    return options


def main(argv=None) -> int:
    options = parse(argv)
    runs = [run for run in matrix.all_runs(options.quick)
            if not options.problem or run.problem in options.problem]
    if options.list:
        print("\n".join(command_text(run) for run in runs))
        return 0
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, on_signal)
    try:
        study = Study(options)
        rows = [study.start_up()] + study.all(runs)
        analysis.write_csv(rows, study.output / "study.csv")
        report.write_all(study.output)
    except Interrupted as interruption:
        print("\nInterrupted: the same call goes on with what is missing.",
              file=sys.stderr)
        return 128 + interruption.args[0]
    print(f"{len(rows) - 1} runs in {clock(time.perf_counter() - study.start)}; "
          f"tables in {options.output / 'study.md'}")
    failed = [row for row in rows if not row["ok"]]
    for row in failed:
        print(f"failed: {row['id']}: {row['message']}")
    complaints = analysis.checks(
        analysis.read_csv(study.output / "study.csv"), options.quick)
    print("\n".join(complaints) or "All checks passed.")
    return 1 if options.quick and (complaints or failed) else 0


if __name__ == "__main__":
    sys.exit(main())
