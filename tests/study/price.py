#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What accuracy costs in a case of one's own: a run that asks for ever smaller
errors of all probes until the time is over; a table, and a picture in
output/price: the error of each probe, as the run believes it, against the time
that all meshes up to that one take.

Usage: price.py CONTACT CASE [--seconds N] [--set SECTION/ENTRY=VALUE]...
"""

import argparse
import json
import pathlib
import subprocess
import sys

import plots

SMALLEST = 1e-6  # [%], never reached


def solve(arguments, directory, *settings):
    command = [arguments.contact, arguments.case, "--quiet"]
    for setting in (*arguments.set, f"Output/Directory={directory}",
                    "Probes/References=", "Probes/Tolerances=", *settings):
        command += ["--set", setting]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    summary = directory / pathlib.Path(arguments.case).stem / "summary.json"
    if ended.returncode not in (0, 1) or not summary.exists():
        sys.exit(ended.stdout + ended.stderr)
    return json.loads(summary.read_text())


def curve_of(probe, levels):
    """Errors [%] and seconds so far, of the levels that know both."""
    points, so_far = [], 0.
    for level in levels:
        so_far += sum(phase["wall"] for phase in level["time"].values())
        error, value = level["errors"].get(probe), level["probes"][probe]
        if error and value:
            points.append((100 * error / abs(value), so_far))
    return points


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("contact")
    parser.add_argument("case")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--set", action="append", default=[])
    arguments = parser.parse_args()
    directory = pathlib.Path("output/price")
    names = [probe["name"] for probe in solve(
        arguments, directory, "Refinement/Levels=0", "Probes/Accuracy=",
        "Probes/Errors=none")["probes"]]
    if not names:
        sys.exit("There are no probes: name some in Probes/Probes.")
    levels = solve(
        arguments, directory, "Refinement/Levels=0",
        "Probes/Accuracy=" + ", ".join(f"{n}: {SMALLEST} %" for n in names),
        f"Refinement/Limits=unknowns: 1e6, seconds: {arguments.seconds:g}")["levels"]

    curves = []
    for name in names:
        points = curve_of(name, levels)
        print(f"{name}: error [%] and seconds")
        for error, seconds in points:
            print(f"  {error:10.3g} {seconds:10.3g}")
        if points:
            curves.append(plots.Curve(name, points, len(curves)))
    case = pathlib.Path(arguments.case).stem
    drawn = plots.draw([plots.Figure(
        case, f"The price of accuracy: {case}", "error of the probe [%]",
        "seconds, all meshes together", [plots.Panel("", curves)],
        falling_x=True)] if curves else [], directory)
    for name in drawn:
        print(directory / f"{name}.svg")


if __name__ == "__main__":
    main()
