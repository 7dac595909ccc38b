#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The picture of estimated effects: how much each changes a probe of a case,
against the time that it costs, on logarithmic axes; in colour the effects that
1 % of the probe calls for.

Usage: picture.py CONTACT CASE PROBE FILE.svg
"""

import json
import pathlib
import subprocess
import sys
import tempfile
from math import log

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "study"))
from plots import spread  # noqa: E402

COLOURS = {"called for": "#b03030", "can be left out": "#606060",
           "cannot be told": "#2060b0"}


def estimates(contact, case, probe):
    """By effect: price, change by the value of the probe, verdict."""
    with tempfile.TemporaryDirectory() as directory:
        subprocess.run([contact, case, "--quiet",
                        "--set", f"Output/Directory={directory}",
                        "--set", "Solution/Estimate effects=true"],
                       check=False, capture_output=True)
        summary = json.loads(next(pathlib.Path(directory).glob("*/summary.json"))
                             .read_text())
    value, = (p["value"] for p in summary["probes"] if p["name"] == probe)
    for effect in summary["estimated_effects"]:
        change = abs(effect["changes"].get(probe, 0) / value)
        if change > 0 and effect["price"]:
            name = effect["effect"].replace("Contact/", "")
            yield (effect["price"], change, effect["verdicts"][probe],
                   name + (", taken off" if effect["on"] else
                           "" if "%" in name else ", added"))


def main():
    contact, case, probe, file = sys.argv[1:]
    points = sorted(estimates(contact, case, probe), key=lambda p: p[1])
    low = min(change for _, change, _, _ in points) / 3
    high = max(change for _, change, _, _ in points) * 3
    lines = ['set terminal svg size 800,500 font "DejaVu Sans,11" background '
             '"white"', f'set output "{file}"', "set encoding utf8", "unset key",
             "set border 3", "set tics nomirror", "set rmargin 40",
             f'set title "{pathlib.Path(case).stem}: what effects change in '
             f'{probe}, and what they cost" noenhanced',
             'set xlabel "time of a Newton step with the change by that without"',
             f'set ylabel "change of {probe}, relative"', "set logscale xy 10",
             'set format y "10^{%T}"', f"set yrange [{low:g}:{high:g}]",
             f"set xrange [{min(p[0] for p in points) / 2:g}:"
             f"{max(p[0] for p in points) * 2:g}]",
             "set arrow from graph 0, first 0.01 to graph 1, first 0.01 nohead "
             "lw 0.5 dt (4,4)"]
    heights = spread([log(change / low) / log(high / low)
                      for _, change, _, _ in points], 0.05)
    plots = []
    for i, ((price, change, verdict, name), height) in enumerate(
            zip(points, heights)):
        colour = COLOURS[verdict]
        lines += [f"$p{i} << EOD", f"{price} {change}", "EOD",
                  f'set label "{name}" noenhanced at graph 1.04, graph {height:.4f} left tc '
                  f'rgb "{colour}"',
                  f"set arrow from first {price}, first {change} to graph 1.03, "
                  f'graph {height:.4f} nohead lw 0.5 lc rgb "{colour}"']
        plots.append(f'$p{i} with points pt 7 ps 1 lc rgb "{colour}"')
    subprocess.run(["gnuplot"], input="\n".join(
        lines + ["plot " + ", ".join(plots), ""]), text=True, check=True)


if __name__ == "__main__":
    main()
