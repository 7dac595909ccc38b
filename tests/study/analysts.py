#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes as analysts draw them, each at the defaults of the program, beside
references that do not come from the same mesh. A study: its exit status is 0.

Newton steps: the mean is the steps of all attempts, those that were cut and those of
first_attempt/ included, divided by the increments that converged; the most is that of
one attempt. Unknowns are displacements.

Usage: analysts.py CONTACT [--size FACTOR] [--set SECTION/ENTRY=VALUE]... [SCENE...]

With --size cells are smaller by that factor (where sizes are not fixed by mapping),
--set adds entries: both are for references.
"""

import argparse
import json
import math
import os
import pathlib
import resource
import shutil
import subprocess

import analysts_plane
import analysts_scene

SCENES = dict(analysts_plane.SCENES)
try:
    import analysts_space
    assert not SCENES.keys() & analysts_space.SCENES.keys(), "names that both have"
    SCENES.update(analysts_space.SCENES)
except ModuleNotFoundError:
    pass
SECONDS = 300  # of CPU
NEAR = 0.02  # of a reference
MEAN, MOST = 12, 40  # Newton steps


def run(contact, name, entries):
    """Exit status (negative: out of time), CPU seconds, summary (empty if there is none), and all
    increments that were tried."""
    pathlib.Path(f"{name}.prm").write_text(analysts_scene.parameter_file(entries))
    shutil.rmtree(f"output/{name}", ignore_errors=True)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(f"{name}.log", "w") as log:
        status = subprocess.run(
            [contact, f"{name}.prm"], stdout=log, stderr=log,
            env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
            preexec_fn=lambda: resource.setrlimit(
                resource.RLIMIT_CPU, (SECONDS, SECONDS + 5))).returncode
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    files = [pathlib.Path(f"output/{name}/{folder}summary.json")
             for folder in ("", "first_attempt/")]
    last, first = (json.loads(file.read_text()) if file.exists() else {}
                   for file in files)
    return status, seconds, last, (last.get("increments", []), first.get("increments", []))


def steps(tried, before):
    """Increments that converged; Newton steps of one: mean, most."""
    done = sum(i["converged"] for i in tried)
    counts = [i["newton_iterations"] for i in tried + before] or [0]
    return done, sum(counts) / done if done else math.nan, max(counts)


def reason(name, summary):
    """Of an exit status that is not 0."""
    violated = [f["text"] for f in summary.get("findings", [])
                if f["severity"] == "violated"]
    errors = [line for line in pathlib.Path(f"{name}.log").read_text().splitlines()
              if line.startswith("error")]
    return (summary.get("message") or "\n".join(violated[-1:] + errors[-1:])
            or f"see {name}.log").splitlines()[0]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("contact", type=pathlib.Path)
    parser.add_argument("scenes", nargs="*", default=list(SCENES))
    parser.add_argument("--size", type=float, default=1)
    parser.add_argument("--set", action="append", default=[])
    arguments = parser.parse_args()
    analysts_scene.SIZE = arguments.size
    extra = dict(entry.split("=", 1) for entry in arguments.set)
    n_passed = n_quick = n_probes = n_near = 0
    messages = []
    print("| scene | exit status | unknowns | increments | Newton steps an increment: "
          "mean, most | CPU s | probe | value | reference | difference | source |\n"
          "|---|---|---|---|---|---|---|---|---|---|---|")
    for name in arguments.scenes:
        scene = SCENES[name]()
        status, seconds, summary, increments = run(
            arguments.contact.resolve(), name, {**scene.entries, **extra})
        done, mean, most = steps(*increments)
        n_passed += status == 0
        n_quick += mean <= MEAN and most <= MOST
        if status:
            messages.append(f"- {name}: {reason(name, summary)}")
        values = {probe["name"]: probe["value"] for probe in summary.get("probes", [])}
        head = (f"{name} | {status} | {summary.get('unknowns', {}).get('displacement')} | "
                f"{done} | {mean:.1f}, {most} | {seconds:.1f}")
        for probe, (value, source) in scene.references.items():
            if callable(value):
                value = value(values) if values else math.nan
            found = values.get(probe, math.nan)
            off = found / value - 1 if value else math.nan
            n_probes += 1
            n_near += status in (0, 1) and abs(off) <= NEAR
            print(f"| {head} | {probe} | {found:.5g} | {value:.5g} | {100 * off:+.2f} % | "
                  f"{source} |", flush=True)
            head = " | " * 5
    print("\n".join(["", *messages, ""]))
    print(f"Exit status 0: {n_passed} of {len(arguments.scenes)} scenes; mean at most "
          f"{MEAN} Newton steps an increment, none above {MOST}: {n_quick}; probes within "
          f"{100 * NEAR:g} % of the reference: {n_near} of {n_probes}.")


if __name__ == "__main__":
    main()
