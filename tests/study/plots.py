# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures with gnuplot: curves with their names, and fronts of many methods.

Names stand beside the ends of the curves, joined to them by a thin line, and
are moved apart where they would overlap. Curves differ in dashes and in points,
so that grey is enough.
"""

from __future__ import annotations

import math
import os
import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

COLOURS = ["#000000", "#b03030", "#2060b0", "#208040", "#d08000", "#803090",
           "#606060", "#00a0a0"]
POINTS = [7, 4, 9, 6, 5, 8, 11, 12]
DASHES = ["1", "(12,4)", "(4,4)", "(12,4,3,4)", "(2,3)", "(16,3,2,3,2,3)",
          "(8,8)", "(6,2,2,2)"]
PLOT, HEIGHT, SPACING = 330, 460, 0.05  # width of axes [px]; of names [graph]
STEPS = [m * 10.0 ** n for n in range(-9, 12) for m in (1, 2, 5)]


@dataclass
class Curve:
    name: str
    points: list[tuple[float, float]]
    style: int = 0


@dataclass
class Panel:
    title: str
    curves: list[Curve] = field(default_factory=list)


@dataclass
class Figure:
    name: str  # of the file
    title: str
    x: str
    y: str
    panels: list[Panel]
    falling_x: bool = False


@dataclass
class Front:
    """Curves in grey, and in colour those of the points (x, y, group, name)
    that no other one is below and left of."""
    name: str
    title: str
    x: str
    y: str
    curves: list[list[tuple[float, float]]]
    points: list[tuple[float, float, str, str]]

    def best(self) -> list[tuple[float, float, str, str]]:
        found = []
        for point in sorted(self.points):
            if not found or point[1] < found[-1][1]:
                found.append(point)
        return found


def spread(heights: list[float], spacing: float) -> list[float]:
    """Move heights in [0, 1] apart, as little as possible, order kept."""
    order = sorted(range(len(heights)), key=lambda i: heights[i])
    # Names that touch form a block, which lies where they would on average.
    blocks: list[list] = []  # sum of (wanted - offset), number
    for i in order:
        blocks.append([heights[i], 1])
        while len(blocks) > 1:
            (s, n), (t, m) = blocks[-2:]
            if s / n + n * spacing <= t / m:
                break
            blocks[-2:] = [[s + t - m * n * spacing, n + m]]
    placed, result = [], [0.0] * len(heights)
    for s, n in blocks:
        low = min(max(s / n, 0), 1 - (n - 1) * spacing)
        placed += [low + k * spacing for k in range(n)]
    for k, i in enumerate(order):
        result[i] = placed[k]
    return result


def around(values: list[float]) -> tuple[float, float]:
    """Bounds of a logarithmic axis: the next of 1, 2, 5, 10, ..."""
    return (max(s for s in STEPS if s <= 1.001 * min(values)),
            min(s for s in STEPS if s >= 0.999 * max(values)))


def bounds(values: list[float]) -> tuple[float, float]:
    """Of an axis: whole decades."""
    low, high = math.log10(min(values)), math.log10(max(values))
    low, high = math.floor(low + 0.02), math.ceil(high - 0.02)
    return 10.0 ** low, 10.0 ** max(high, low + 1)


def panel_script(figure: Figure, panel: Panel, number: int, x_range, y_range):
    """Gnuplot commands for one panel, and its data blocks."""
    def fraction(y):
        low, high = y_range
        return math.log(y / low) / math.log(high / low)

    lines = ["unset label", "unset arrow", f'set title "{panel.title}"']
    heights = spread([fraction(c.points[-1][1]) for c in panel.curves], SPACING)
    plots = []
    for i, (curve, height) in enumerate(zip(panel.curves, heights)):
        style = curve.style % len(COLOURS)
        block = f"$data{number}_{i}"
        lines += [f"{block} << EOD",
                  *(f"{x:.8g} {y:.8g}" for x, y in curve.points), "EOD"]
        x, y = curve.points[-1]
        colour = f'"{COLOURS[style]}"'
        lines.append(f"set arrow from first {x:.8g}, first {y:.8g} to graph "
                     f"1.03, graph {height:.4f} nohead lw 0.5 dt 1 lc rgb "
                     f"{colour}")
        lines.append(f'set label "{curve.name}" at graph 1.04, graph '
                     f"{height:.4f} left tc rgb {colour} font ',10'")
        plots.append(f"{block} using 1:2 with linespoints lw 1.6 ps 0.7 dt "
                     f"{DASHES[style]} pt {POINTS[style]} lc rgb {colour}")
    lines.append("plot " + ", \\\n  ".join(plots))
    return lines


def script(figure: Figure, terminal: str, path: Path) -> str:
    """The whole of it for gnuplot."""
    points = [p for panel in figure.panels for c in panel.curves
              for p in c.points]
    x_range = around([p[0] for p in points])
    y_range = bounds([p[1] for p in points])
    if figure.falling_x:
        x_range = x_range[::-1]
    longest = max(len(c.name) for p in figure.panels for c in p.curves)
    n_panels = len(figure.panels)
    width = max(800, (PLOT + 7 * longest) * n_panels) if n_panels > 1 else 800
    lines = [
        f'set terminal {terminal} size {width},{HEIGHT} font "DejaVu Sans,11" '
        'background "white"',
        f'set output "{path}"',
        "set encoding utf8", "unset key", "set border 3", "set tics nomirror",
        'set grid xtics ytics back lw 1 lc rgb "#dddddd" dt 1',
        f"set rmargin {0.86 * longest + 4:.0f}", "set lmargin 9", "set logscale x 10",
        'set format x "10^{%T}"',
        f"set xrange [{x_range[0]:g}:{x_range[1]:g}]",
        f"set yrange [{y_range[0]:g}:{y_range[1]:g}]",
        f'set xlabel "{figure.x}"', f'set ylabel "{figure.y}"']
    if max(x_range) < 50 * min(x_range):  # decades alone would be too few
        ticks = [s for s in STEPS if min(x_range) <= s <= max(x_range)]
        lines.append("set xtics (" + ", ".join(f'"{t:g}" {t:g}' for t in ticks)
                     + ")")
    lines += ["set logscale y 10", 'set format y "10^{%T}"']
    lines.append(f"set multiplot layout 1,{len(figure.panels)} "
                 f'title "{figure.title}"')
    for number, panel in enumerate(figure.panels):
        lines += panel_script(figure, panel, number, x_range, y_range)
        lines.append('set ylabel ""')
    return "\n".join(lines + ["unset multiplot", ""])


def front_script(front: Front, terminal: str, path: Path) -> str:
    """The whole of it for gnuplot. A method is named where it comes first."""
    best = front.best()
    groups = list(dict.fromkeys(group for _, _, group, _ in best))
    low, high = bounds([y for curve in front.curves for _, y in curve])
    lines = [f'set terminal {terminal} size 800,500 font "DejaVu Sans,11" '
             'background "white"', f'set output "{path}"', "set encoding utf8",
             "unset key", "set border 3", "set tics nomirror", "set rmargin 3",
             f'set title "{front.title}"', f'set xlabel "{front.x}"',
             f'set ylabel "{front.y}"', "set logscale xy 10",
             'set format x "10^{%T}"', 'set format y "10^{%T}"',
             f"set yrange [{low:g}:{high:g}]", "set xrange [{:g}:{:g}]".format(
                 *around([x for curve in front.curves for x, _ in curve]))]
    plots = []
    for i, curve in enumerate(front.curves):
        lines += [f"$grey{i} << EOD", *(f"{x:.8g} {y:.8g}" for x, y in curve),
                  "EOD"]
        plots.append(f"$grey{i} with lines lw 1 lc rgb '#cccccc'")
    lines += ["$front << EOD", *(f"{x:.8g} {y:.8g}" for x, y, _, _ in best),
              "EOD"]
    plots.append("$front with lines lw 1.5 dt (4,4) lc rgb '#444444'")
    named: list[tuple[float, str]] = []  # height and method
    for i, (x, y, group, name) in enumerate(best):
        colour = COLOURS[1 + groups.index(group) % (len(COLOURS) - 1)]
        lines += [f"$point{i} << EOD", f"{x:.8g} {y:.8g}", "EOD"]
        plots.append(f"$point{i} with points pt 7 ps 1 lc rgb '{colour}'")
        height = math.log(y / low) / math.log(high / low)
        if all(name != other and abs(height - h) > SPACING
               for h, other in named):
            named.append((height, name))
            lines.append(f'set label "{name}" at {x:.8g},{y:.8g} left offset '
                         f"0.8,0.5 front tc rgb '{colour}' font ',10'")
    return "\n".join(lines + ["plot " + ", \\\n  ".join(plots), ""])


def gnuplot(commands: str) -> str:
    """Runs them, and returns what gnuplot complains of."""
    # Signs such as that of a degree, whatever the language of the machine.
    outcome = subprocess.run(["gnuplot"], input=commands, text=True,
                             capture_output=True, encoding="utf-8",
                             env=os.environ | {"LC_ALL": "C.UTF-8"})
    status = outcome.returncode
    return outcome.stderr.strip() or (f"exit status {status}" if status else "")


def draw(figures: list, directory: Path) -> list[str]:
    """SVG and PNG of all that have a curve; the names of those."""
    if not shutil.which("gnuplot"):
        print("No pictures: gnuplot is missing (Debian: gnuplot-nox).")
        return []
    drawn = []
    for figure in figures:
        if isinstance(figure, Front):
            make, empty = front_script, not figure.points
        else:
            figure.panels = [p for p in figure.panels if p.curves]
            make, empty = script, not figure.panels
        if empty:
            continue
        for terminal, suffix in (("svg", "svg"), ("pngcairo", "png")):
            path = directory / f"{figure.name}.{suffix}"
            complaint = gnuplot(make(figure, terminal, path))
            if complaint:
                print(f"gnuplot, {path.name}: {complaint[:500]}")
        drawn.append(figure.name)
    return drawn
