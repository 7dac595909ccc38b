#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of what accuracy costs somebody who waits: four scenes, one a panel.
Along x the error of a probe, from large to small; along y the seconds from the
start of the program. Three curves: runs that ask for an accuracy, with a bar from
the true error to the one that they print; meshes refined everywhere; meshes
refined by the energy estimate. Their errors are those that no later mesh exceeds.
Grey below: the start-up, of a run of the coarse mesh less what it computes. Grey
at the right: errors that the reference, the limit of uniform meshes by their last
three values, does not know.

Usage: panels.py CONTACT SVG
"""

import pathlib
import sys
import tempfile
import time

from plots import COLOURS, gnuplot
from requests import parameters, seconds, solve

# Title, case, probe, uniform and adaptive levels, errors asked for [%].
ASKED = [3, 1, 0.3, 0.1, 0.03, 0.01]
SCENES = [
    ("plane, frictionless", "nested", "DY(B)", 4, 12, ASKED),
    ("friction", "nested_friction", "DY(B)", 4, 12, ASKED),
    ("large displacement", "nested_large", "DY(B)", 3, 9, ASKED),
    ("space", "nested_space", "F", 3, 5, ASKED[:3]),
]


def limit_of(levels, probe):
    """The limit of three values, and how far it is from that of those before."""
    values = [level["probes"][probe] for level in levels]

    def aitken(a, b, c):
        return c - (c - b) ** 2 / ((c - b) - (b - a))
    last = aitken(*values[-3:])
    return last, abs(last - (aitken(*values[-4:-1]) if len(values) > 3
                             else values[-1]))


def percent(value, limit):
    return 100 * abs(value / limit - 1)


def curve(levels, probe, limit, start):
    """Error and time of each mesh; the error that all later ones stay below."""
    errors = [percent(level["probes"][probe], limit) for level in levels]
    return [(max(errors[k:]), start + seconds(levels[:k + 1]))
            for k in range(len(levels))]


def measure(title, case, probe, n_levels, n_adaptive, goals):
    with tempfile.TemporaryDirectory() as directory:
        def run(*more):
            begin = time.time()
            summary = solve(case, directory, *more)
            return summary, time.time() - begin
        summary, wall = run("Refinement/Levels=0")
        start = wall - seconds(summary["levels"])
        uniform = run(f"Refinement/Levels={n_levels}")[0]["levels"]
        limit, unknown = limit_of(uniform, probe)
        adaptive = run(f"Refinement/Levels={n_adaptive}",
                       "Refinement/Strategy=adaptive")[0]["levels"]
        asked = []
        for goal in goals:
            summary, wall = run("Refinement/Levels=0",
                                f"Probes/Accuracy={probe}: {goal} %")
            found = next(p for p in summary["probes"] if p["name"] == probe)
            if not summary["accuracy_missed"]:
                asked.append((percent(found["value"], limit), wall,
                              100 * found["estimated_error"] / abs(found["value"])))
    unknown = max(100 * unknown / abs(limit), 1e-4)
    print(f"{title}: {asked}, unknown {unknown:.2g} %", flush=True)
    return {"title": title, "start": start, "unknown": unknown,
            "on request": asked,
            "uniform": curve(uniform, probe, limit, start),
            "adaptive": curve(adaptive, probe, limit, start)}


def label(asked):
    """The price of 0.1 %, and of the next digit."""
    costs = [min((p[1] for p in asked if p[2] <= goal), default=None)
             for goal in (0.1, 0.01)]
    if costs[0] is None:
        return ""
    return f"0.1 % costs {costs[0]:.2g} s" + (
        f",\\nthe next digit {costs[1] / costs[0]:.2g} times that"
        if costs[1] else "")


def script(scenes, path):
    lines = ['set terminal svg size 1180,420 font "DejaVu Sans,11" background '
             '"white"', f'set output "{path}"', "set encoding utf8", "unset key",
             "set border 3", "set tics nomirror", "set logscale xy 10",
             "set xrange [10:0.002]", "set yrange [0.2:30]",
             'set format x "%g"', 'set format y "%g"', "set lmargin 6",
             "set rmargin 2",
             'set grid xtics ytics back lw 1 lc rgb "#dddddd" dt 1',
             'set xlabel "error [%]"', 'set ylabel "seconds to wait"',
             f"set multiplot layout 1,{len(scenes)}"]
    for n, scene in enumerate(scenes):
        lines += ["unset label", "unset object", f'set title "{scene["title"]}"',
                  f"set object 1 rectangle from 10,0.2 to 0.002,"
                  f"{scene['start']:g} fc rgb '#e8e8e8' fs solid noborder behind",
                  f"set object 2 rectangle from {scene['unknown']:g},0.2 to "
                  "0.002,30 fc rgb '#f2f2f2' fs solid noborder behind",
                  f'set label 1 "{label(scene["on request"])}" at graph 0.04,0.95 '
                  "font ',10'", 'set label 2 "start-up" at graph 0.04, first '
                  f"{0.8 * scene['start']:g} font ',9' tc rgb '#808080'"]
        plots = []
        for k, name in enumerate(("uniform", "adaptive", "on request")):
            points = [p for p in scene[name] if p[0] > 0]
            colour = COLOURS[(2, 3, 1)[k]]
            lines += [f"$d{n}_{k} << EOD",
                      *(" ".join(f"{x:.6g}" for x in p) for p in points), "EOD"]
            lines.append(f'set label {3 + k} "{name}" at graph 0.04, graph '
                         f"{0.8 - 0.06 * k:g} tc rgb '{colour}' font ',10'"
                         if n == 0 else "")
            plots.append(f"$d{n}_{k} using 1:2:1:3:2:2 with xyerrorbars lw 1.4 "
                         f"pt 7 ps 0.6 lc rgb '{colour}'"
                         if name == "on request" else
                         f"$d{n}_{k} using 1:2 with linespoints lw 1.6 ps 0.6 "
                         f"dt {k + 1} pt {(4, 6)[k]} lc rgb '{colour}'")
        lines += ["plot " + ", \\\n  ".join(plots), 'set ylabel ""']
    return "\n".join(lines + ["unset multiplot", ""])


def main():
    contact, path = (pathlib.Path(p).resolve() for p in sys.argv[1:3])
    assert parameters.exists() and contact.exists()
    scenes = [measure(*scene) for scene in SCENES]
    sys.exit(gnuplot(script(scenes, path)) or 0)


if __name__ == "__main__":
    main()
