# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of a case, by gnuplot: its history, and the tractions on its surfaces."""

from __future__ import annotations

import sys
from pathlib import Path

import pandas

sys.path.append(str(Path(__file__).resolve().parents[1] / "study"))
import plots  # noqa: E402
from contact_results import Results  # noqa: E402
from plots import COLOURS, DASHES, POINTS  # noqa: E402

WIDTH, PANEL_HEIGHT = 1000, 280  # pixels
STATUS = {0: ("open", "808080"), 1: ("slip", "d08000"), 2: ("stick", "2060b0")}
TERMINALS = {".png": "pngcairo", ".svg": "svg"}
# Columns of history.csv by their first word; the others are probes.
KINDS = {"contact": "contact", "reaction": "reactions", "work": "works",
         "Newton": None, "t": None}
ROUND_OFF = 1e-9  # of the largest value with this unit
MARGIN = 0.05  # of the range of the values
BESIDE = 0.25  # of the zone in contact, on both sides of it


def gnuplot(lines: list[str], path: Path, size="1000,560") -> None:
    head = [f'set terminal {TERMINALS[path.suffix]} size {size} '
            'font "DejaVu Sans,12" background "white"', f'set output "{path}"',
            "set encoding utf8", "set border 3", "set tics nomirror",
            'set grid back lw 1 lc rgb "#dddddd" dt 1']
    complaint = plots.gnuplot("\n".join(head + lines + [""]))
    if complaint:
        raise SystemExit(f"gnuplot, {path.name}: {complaint}")


def block(name: str, table: pandas.DataFrame, *columns: str) -> list[str]:
    """Columns of a table as data with a name."""
    return [f"{name} << EOD", *table[list(columns)].to_csv(
        sep=" ", header=False, index=False, na_rep="NaN").splitlines(), "EOD"]


def quoted(text: str) -> str:
    return "'" + text.replace("'", "''") + "'"


def axis(name: str, values) -> str:
    """The range of an axis: zero and all values, with a margin."""
    low, high = min(0.0, values.min()), max(0.0, values.max())
    margin = MARGIN * (high - low) or 1.0
    return (f"set {name}range [{low - margin * (low < 0):.9g}:"
            f"{high + margin:.9g}]")


def draw_panels(panels: list[list[str]], path: Path) -> list[Path]:
    """One above the other, as a picture and as a drawing."""
    lines = [f"set multiplot layout {len(panels)},1", "set lmargin 12",
             "set rmargin 30",
             "set key at graph 1.03, graph 1 left top Left reverse noenhanced",
             *(line for panel in panels for line in panel), "unset multiplot"]
    paths = [path.with_suffix(suffix) for suffix in TERMINALS]
    for written in paths:
        gnuplot(lines, written, f"{WIDTH},{PANEL_HEIGHT * len(panels)}")
    return paths


def history_groups(history: pandas.DataFrame) -> dict[tuple[str, str], list[str]]:
    """The columns that are not zero all the time, by kind and unit."""
    groups: dict[tuple[str, str], list[str]] = {}
    units = history.attrs["units"]
    sizes = history.abs().max()
    largest = {unit: max(sizes.get(c, 0) for c in units if units[c] == unit)
               for unit in units.values()}
    for column, unit in units.items():
        kind = KINDS.get(column.split(maxsplit=1)[0], "probes")
        if kind and sizes[column] > ROUND_OFF * largest[unit]:
            groups.setdefault((kind, unit), []).append(column)
    return dict(sorted(groups.items(), key=lambda g: g[0][0] != "probes"))


def draw_history(case: Results, path: Path) -> list[Path]:
    """A panel for the probes, forces of contact, reactions and works of a unit,
    over the load factor."""
    history = case.history
    table, panels = history.reset_index(), []
    for n, ((kind, unit), columns) in enumerate(history_groups(history).items()):
        # What all names begin with is in the title.
        word = columns[0].split()[0] + " " if kind != "probes" else ""
        lines = [f"set title {quoted(kind)} noenhanced", 'set xlabel "t"',
                 f"set ylabel {quoted('[' + unit + ']')} noenhanced",
                 axis("x", table["t"]), axis("y", history[columns].stack())]
        curves = []
        for i, column in enumerate(columns):
            lines += block(f"$history{n}_{i}", table, "t", column)
            curves.append(
                f"$history{n}_{i} with linespoints lw 1.6 ps 0.7 "
                f"pt {POINTS[i % len(POINTS)]} "
                f"dt {DASHES[i // len(COLOURS) % len(DASHES)]} "
                f'lc rgb "{COLOURS[i % len(COLOURS)]}" '
                f"title {quoted(column.removeprefix(word))}")
        panels.append(lines + ["plot " + ", \\\n  ".join(curves)])
    if not panels:
        raise ValueError("all of history.csv is zero")
    return draw_panels(panels, path)


def touching_zone(rows: pandas.DataFrame) -> pandas.DataFrame:
    """The rows in contact and those beside them; all where one point touches."""
    arc = rows["arc_length"]
    inside = arc[rows["status"] > 0]
    if inside.min() == inside.max():
        return rows
    beside = BESIDE * (inside.max() - inside.min())
    return rows[arc.between(inside.min() - beside, inside.max() + beside)]


def draw_tractions(case: Results, path: Path) -> list[Path]:
    """Pressure and shear over the arc length of each slave that touches at the
    end, in 2-D."""
    panels, profile = [], case.profile()
    slaves = profile[profile["surface"].str.startswith("slave")]
    touching = slaves[slaves["status"] > 0]["surface"].unique()
    for n, surface in enumerate(touching):
        rows = touching_zone(case.profile(surface))
        columns = ["pressure", "shear"]
        lines = [f"set title {quoted(surface)} noenhanced",
                 'set xlabel "arc length [mm]"', 'set ylabel "[MPa]"',
                 f'set xrange [{rows["arc_length"].min():.9g}:'
                 f'{rows["arc_length"].max():.9g}]',
                 axis("y", rows[columns].stack())]
        curves = []
        for i, column in enumerate(columns):
            lines += block(f"$traction{n}_{i}", rows, "arc_length", column)
            curves.append(f"$traction{n}_{i} with lines lw 1.6 dt {DASHES[i]} lc "
                          f'rgb "{COLOURS[i]}" title "{column}"')
        for status, (name, colour) in STATUS.items():
            chosen = rows[rows["status"] == status]
            if chosen.empty:
                continue
            lines += block(f"$status{n}_{status}", chosen, "arc_length", "pressure")
            curves.append(f"$status{n}_{status} with points pt 7 ps 0.6 lc rgb "
                          f'"#{colour}" title "{name}"')
        panels.append(lines + ["plot " + ", \\\n  ".join(curves)])
    if not panels:
        raise ValueError("nothing touches at the end")
    return draw_panels(panels, path)
