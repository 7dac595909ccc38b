#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables and pictures of the study, from DIR/study.csv alone.

    report.py DIR                        study.md, *.svg and *.png in DIR
    report.py DIR --readme FILE          tables into FILE, between their marks
    report.py DIR --check-readme FILE    exit status 1 if they differ

FILE may be a folder: then all README.md in it and below that have marks.

The marks are <!-- study:NAME:begin --> and <!-- study:NAME:end -->, NAME being
one of those in TABLES of tables.py. <!-- study:NAME:begin /PATTERN/ --> takes
only the rows that match the regular expression.
"""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path

import analysis
import matrix
import plots
from tables import SSNP, TABLES, all_tables


# ------------------------------------------------------------------- pictures

QUANTITIES = ("dy", "max_pressure")


def front_figures(rows) -> list[plots.Front]:
    """Error against time: all methods in grey, and the runs than which none is
    faster and as accurate. The error of a run is the largest from its mesh on:
    a change of sign is no accuracy. What the reference cannot judge is left
    out."""
    figures = []
    for problem, title in SSNP.items():
        for quantity in QUANTITIES:
            found = analysis.reference(rows, problem, quantity)
            if not found:
                continue
            curves, points = [], []
            for (element, name), runs in \
                    analysis.sequences(rows, problem).items():
                largest = analysis.envelope(
                    analysis.errors(rows, runs, quantity))
                curve = [(r["seconds"], e) for r, e in zip(runs, largest)
                         if e > 2 * found[1]]
                curves.append(curve)
                points += [(x, e, element, f"{element}, {name}")
                           for x, e in curve]
            figures.append(plots.Front(
                f"{problem}_{quantity}_front", title, "wall time [s]",
                f"relative error of {analysis.NAMES[quantity]}",
                [curve for curve in curves if curve], points))
    return figures


def digit_figures(rows) -> list[plots.Figure]:
    """The time of the cheapest run for each digit, a curve an element."""
    figures = []
    for problem, title in SSNP.items():
        for quantity in QUANTITIES:
            curves = []
            for style, element in enumerate(matrix.ELEMENTS):
                picks = [(target, analysis.decision(rows, problem, quantity,
                                                    target, [element]))
                         for target in matrix.TARGETS]
                points = [(target, pick["seconds"]) for target, pick in picks
                          if pick]
                if len(points) > 1:
                    curves.append(plots.Curve(element, points, style))
            if curves:
                figures.append(plots.Figure(
                    f"{problem}_{quantity}_time_of_digits", title,
                    f"error of {analysis.NAMES[quantity]} that is asked for",
                    "wall time of the cheapest run [s]",
                    [plots.Panel("", curves)], falling_x=True))
    return figures


def order_figures(rows) -> list[plots.Figure]:
    """Errors against refinements as the mesh size by that of the file."""
    figures = []
    for problem in ("rings", "disk", "rings_matching"):
        panels = {q: plots.Panel(q) for q in ("displacement", "energy",
                                              "pressure")}
        sequences = analysis.sequences(rows, problem)
        for style, ((element, rule), runs) in enumerate(sequences.items()):
            for q, panel in panels.items():
                points = [(2 ** r["level"], r[f"error_{q}"]) for r in runs
                          if r[f"error_{q}"]]
                if points:
                    panel.curves.append(
                        plots.Curve(f"{element}, {rule}", points, style))
        figures.append(plots.Figure(
            f"{problem}_orders", problem, "first mesh size by mesh size",
            "relative error", list(panels.values())))
    return figures


def table_rows(text: str) -> list[dict]:
    """Of all tables of a page, by the names of their columns."""
    rows, columns = [], None
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if not line.startswith("|"):
            columns = None
        elif columns is None:
            columns = cells
        elif not line.startswith("|--"):
            rows.append(dict(zip(columns, cells)))
    return rows


def scaling_figures(directory: Path) -> list[plots.Figure]:
    """Wall time against unknowns on one process, of ./run scaling."""
    panels = {}
    for name, place in (("scaling", "plane"), ("scaling_space", "space")):
        page = directory / f"{name}.md"
        for row in table_rows(page.read_text()) if page.exists() else []:
            if row["case"] not in ("tied", "no friction") or row.get(
                    "ranks", "1") != "1":
                continue
            title = f"{place}, degree {row.get('degree', 2)}"
            curves = panels.setdefault(title, {})
            curves.setdefault(row["case"], set()).add(
                (float(row["unknowns"]), float(row["wall [s]"])))
    return [plots.Figure(
        "scaling", "Contact on fine meshes, multigrid without a matrix",
        "unknowns", "wall seconds of the complete run",
        [plots.Panel(title, [plots.Curve(case, sorted(points), style)
                             for style, (case, points) in enumerate(curves.items())])
         for title, curves in panels.items()])] if panels else []


# ----------------------------------------------------------------- what to do

def write_all(directory: Path) -> None:
    """study.md and the pictures."""
    rows = read(directory)
    start = next((r for r in rows if r["problem"] == "start-up"), None)
    parts = ["# Accuracy against cost\n"]
    if start:
        parts.append("Seconds are wall seconds from reading the mesh to the last "
                     "result, after a start of "
                     f"{start['wall']:.2f} s ({start['cpu']:.2f} s of CPU) and "
                     "without comparing with theory.\n")
    for title, make in TABLES.values():
        if text := make(rows):
            parts.append(f"## {title}\n\n{text}\n")
    drawn = plots.draw(front_figures(rows) + digit_figures(rows) +
                       order_figures(rows) + scaling_figures(directory),
                       directory)
    parts += [f"![{name}]({name}.svg)\n" for name in drawn]
    (directory / "study.md").write_text("\n".join(parts))


def read(directory: Path) -> list[dict]:
    path = directory / "study.csv"
    if not path.is_file():
        sys.exit(f"report.py: {path} does not exist: run study.py first, or give "
                 "the directory that has it")
    return analysis.read_csv(path)


def select_rows(text: str, pattern: str) -> str:
    """Of tables, of Markdown or printed by the program, the rows that match,
    with their heads; and the first line, which names the command, if it is no
    table."""
    lines = text.splitlines()
    kept = [] if lines[0].startswith("|") else [lines[0]]
    head: list[str] = []
    printed = below = False  # a table of the program, and its rows
    for i, line in enumerate(lines):
        if line == "```":
            kept += [line] if printed else ["", line]
            printed, below = not printed, False
        elif printed:
            if not below or re.search(pattern, line):
                kept.append(line)
            below = below or line.startswith("--")
        elif line.startswith("|") and lines[i + 1:i + 2] and \
                lines[i + 1].startswith("|--"):
            head = ["", line, lines[i + 1]]
        elif line.startswith("| ") and re.search(pattern, line):
            kept += head + [line]
            head = []
    return "\n".join(kept).strip()


def replace_tables(text: str, tables: dict[str, str], file: Path) -> str:
    """The text with the tables between their marks."""
    marks = re.findall(r"<!-- study:(\w+):begin(?: /(.*)/)? -->", text)
    for name, pattern in marks:
        if name not in tables:
            sys.exit(f"report.py: {file}: there is no table '{name}': one of "
                     f"{', '.join(tables)}")
        table = select_rows(tables[name], pattern) if pattern else tables[name]
        begin, end, rest = (rf"(<!-- study:{name}:begin[^\n]* -->)",
                            rf"(<!-- study:{name}:end -->)", ".*?")
        if not re.search(begin + rest + end, text, re.S):
            sys.exit(f"report.py: {file}: <!-- study:{name}:begin --> has no "
                     "end: add the line that closes it")
        text = re.sub(begin + rest + end,
                      lambda m, table=table: f"{m[1]}\n{table}\n{m[2]}",
                      text, flags=re.S)
    if not marks:
        sys.exit(f"report.py: {file} has no mark <!-- study:NAME:begin -->: add "
                 f"one where a table shall be, NAME of {', '.join(tables)}")
    return text


def pages(path: Path) -> list[Path]:
    """The file, or of a folder the pages with marks, but those of a build."""
    if not path.is_dir():
        return [path]
    found = [page for page in sorted(path.rglob("README.md"))
             if page.relative_to(path).parts[0] not in ("build", "output")
             and "<!-- study:" in page.read_text()]
    if not found:
        sys.exit(f"report.py: {path}: no README.md in this folder has a mark "
                 "<!-- study:NAME:begin -->")
    return found


def main(argv=None) -> int:
    parser = argparse.ArgumentParser(description="Tables and pictures of a study.")
    parser.add_argument("directory", type=Path, help="has study.csv")
    parser.add_argument("--readme", type=Path, metavar="FILE")
    parser.add_argument("--check-readme", type=Path, metavar="FILE")
    options = parser.parse_args(argv)
    file = options.readme or options.check_readme
    if not file:
        write_all(options.directory)
        return 0
    # Beside the study's own, what other commands printed is a table, too.
    tables = all_tables(read(options.directory)) | {
        path.stem: path.read_text().strip()
        for path in options.directory.glob("*.md") if path.stem != "study"}
    status = 0
    for page in pages(file):
        old = page.read_text()
        new = replace_tables(old, tables, page)
        if options.readme:
            page.write_text(new)
        elif new != old:
            print(f"{page}: its tables are not those of "
                  f"{options.directory / 'study.csv'}: report.py "
                  f"{options.directory} --readme {file} renews them")
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
