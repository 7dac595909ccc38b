#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hard cases with bodies that yield, and with bodies of rubber.

Each case of cases.py at default settings, with the nodal and the mortar
discretization, once elastic; then all of its bodies

- elastic-plastic in small strain, with half of the largest von Mises stress in
  any increment of the elastic run as yield stress and a fiftieth of Young's
  modulus as hardening modulus;
- neo-Hookean, in large displacement.

Writes a table to standard output. Exit status 1 if a row ends in another way than
converged, refused or not converged, or if a converged row violates an invariant.

Usage: materials.py [--space] [--jobs N] CONTACT [CASE ...]
"""

import concurrent.futures
import json
import pathlib
import re
import subprocess
import sys

from cases import CASES
from hard import argument_parser, discretization

STATUS = {0: "converged", 1: "converged", 2: "refused", 3: "not converged"}


def numbers(path, entry):
    """{body: number} of an entry of a parameter file or of those it includes."""
    found = {}
    for line in path.read_text().splitlines():
        words = line.split(None, 1)
        if words[:1] == ["include"]:
            found.update(numbers(path.parent / words[1].strip(), entry))
        elif line.strip().startswith("set " + entry):
            found.update((name.strip(), float(value)) for name, value in
                         re.findall(r"([^:,=]+):\s*([^,]+)", line.split("=")[1]))
    return found


def per_body(values):
    return ", ".join(f"{body}: {value!r}" for body, value in values.items())


def run(options, case, rule, what, *entries):
    directory = options.output / f"{case}_{rule}_{what}".replace(" ", "-")
    file = options.parameters / "hard" / f"{case}.prm"
    command = [str(options.contact), str(file), "--quiet", "--set",
               f"Output/Directory={directory}"]
    for entry in discretization(file, rule) + list(entries):
        command += ["--set", entry]
    path = directory / case / "summary.json"
    path.unlink(missing_ok=True)
    try:
        status = subprocess.run(command, capture_output=True,
                                timeout=options.timeout).returncode
    except subprocess.TimeoutExpired:
        return "no end", {}
    summary = json.loads(path.read_text()) if path.exists() and status != 2 \
        else {}
    if any(f["severity"] == "violated" for f in summary.get("findings", [])):
        return "VIOLATED", summary
    return STATUS.get(status, f"FAILED ({status})"), summary


def rows(options, case, rule):
    moduli = numbers(options.parameters / "hard" / f"{case}.prm",
                     "Young's modulus")
    none = ("Probes/References=", "Probes/Tolerances=")
    # A yield stress that is never reached: then the stress is told.
    found = [("elastic", *run(options, case, rule, "elastic", *none,
                              "Solids/Yield stress=" + per_body(moduli)))]
    peaks = {}
    for increment in found[0][2].get("increments", []):
        for name, body in increment.get("bodies", {}).items():
            peaks[name] = max(peaks.get(name, 0), body["von_mises"])
    if set(peaks) == set(moduli) and min(peaks.values()) > 0:
        found.append(("elastic-plastic", *run(
            options, case, rule, "plastic", *none,
            "Solids/Kinematics=small strain", "Solids/Material=" +
            ", ".join(f"{body}: elastic-plastic" for body in moduli),
            "Solids/Yield stress=" + per_body(
                {body: peaks[body] / 2 for body in moduli}),
            "Solids/Hardening modulus=" + per_body(
                {body: E / 50 for body, E in moduli.items()}))))
    found.append(("neo-Hookean", *run(
        options, case, rule, "rubber", *none,
        "Solids/Kinematics=large displacement", "Solids/Material=" +
        ", ".join(f"{body}: neo-Hookean" for body in moduli))))
    return found


def main():
    options = argument_parser(__doc__, "hard_materials").parse_args()
    options.output = options.output.resolve()
    jobs = [(case.name, rule) for case in CASES for rule in ("nodal", "mortar")
            if (case.name in options.cases or not options.cases) and
            case.in_space == options.space]
    counts, bad = {}, False
    print("| case | discretization | material | status | increments | cut | "
          "Newton steps, most in one | plastic strain, largest |")
    print("|---|---|---|---|---|---|---|---|")
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for (case, rule), found in zip(jobs, pool.map(
                lambda job: rows(options, *job), jobs)):
            for material, status, summary in found:
                counts.setdefault(material, []).append(status)
                bad = bad or status not in STATUS.values()
                increments = summary.get("increments", [])
                good = [i["newton_iterations"] for i in increments
                        if i["converged"]]
                plastic = max((body.get("plastic_strain", 0) for body in
                               summary.get("bodies", {}).values()), default=0)
                print(f"| {case} | {rule} | {material} | {status} | {len(good)} "
                      f"| {len(increments) - len(good)} | "
                      f"{max(good, default=0)} | {plastic:.2g} |", flush=True)
    for material, states in counts.items():
        print(f"\n{material}: {states.count('converged')} of {len(states)} "
              "converge")
    return bad


if __name__ == "__main__":
    sys.exit(main())
