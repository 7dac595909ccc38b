# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures with gnuplot: one panel an element, one curve a method.

Names stand beside the ends of the curves, joined to them by a thin line, and
are moved apart where they would overlap. Curves differ in dashes and in points,
so that grey is enough.
"""

from __future__ import annotations

import math
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
    logarithmic_y: bool = True


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


def bounds(values: list[float], logarithmic: bool) -> tuple[float, float]:
    """Of an axis: whole decades, or from 0."""
    if not logarithmic:
        return 0.0, 1.08 * max(values)
    low, high = math.log10(min(values)), math.log10(max(values))
    low, high = math.floor(low + 0.02), math.ceil(high - 0.02)
    return 10.0 ** low, 10.0 ** max(high, low + 1)


def panel_script(figure: Figure, panel: Panel, number: int, x_range, y_range):
    """Gnuplot commands for one panel, and its data blocks."""
    def fraction(y):
        low, high = y_range
        if figure.logarithmic_y:
            y, low, high = math.log(y), math.log(low), math.log(high)
        return (y - low) / (high - low)

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
    y_range = bounds([p[1] for p in points], figure.logarithmic_y)
    longest = max(len(c.name) for p in figure.panels for c in p.curves)
    width = (PLOT + 7 * longest) * len(figure.panels)
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
    if x_range[1] < 50 * x_range[0]:  # decades alone would be too few
        ticks = [s for s in STEPS if x_range[0] <= s <= x_range[1]]
        lines.append("set xtics (" + ", ".join(f'"{t:g}" {t:g}' for t in ticks)
                     + ")")
    if figure.logarithmic_y:
        lines += ["set logscale y 10", 'set format y "10^{%T}"']
    lines.append(f"set multiplot layout 1,{len(figure.panels)} "
                 f'title "{figure.title}"')
    for number, panel in enumerate(figure.panels):
        lines += panel_script(figure, panel, number, x_range, y_range)
        lines.append('set ylabel ""')
    return "\n".join(lines + ["unset multiplot", ""])


def draw(figures: list[Figure], directory: Path) -> list[str]:
    """SVG and PNG of all that have a curve; the names of those."""
    if not shutil.which("gnuplot"):
        print("No pictures: gnuplot is missing (Debian: gnuplot-nox).")
        return []
    drawn = []
    for figure in figures:
        figure.panels = [p for p in figure.panels if p.curves]
        if not figure.panels:
            continue
        for terminal, suffix in (("svg", "svg"), ("pngcairo", "png")):
            path = directory / f"{figure.name}.{suffix}"
            outcome = subprocess.run(
                ["gnuplot"], input=script(figure, terminal, path), text=True,
                capture_output=True)
            if outcome.returncode != 0 or outcome.stderr:
                print(f"gnuplot, {path.name}: {outcome.stderr.strip()[:500]}")
        drawn.append(figure.name)
    return drawn
