#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the results of a case, and a page with them.

    plot.py CASE...

CASE is a parameter file, whose results are in output/NAME below the working
directory, or a folder of results. Written beside them:

    history.png, .svg      probes, forces, reactions, works over the load factor
    tractions.png, .svg    pressure and shear over the slaves, in 2-D
    pressure.png           the pressure on the slaves, in 3-D
    von_mises.png          the deformed bodies
    report.html            tables and pictures, one file

VTK of Debian (python3-vtk9) draws on X only: xvfb-run plot.py ..., as ./run plot
does. Exit status: 0, 2 without results.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.dont_write_bytecode = True
import bodies  # noqa: E402
import curves  # noqa: E402
from contact_results import Results  # noqa: E402
from page import write_page  # noqa: E402

CASES = (".prm", ".json")
ASKED_FOR = '--set Output/VTU=true --set Output/Profile=true'
PAGE = "report.html"
# Of an earlier call they would stay where there is nothing to draw now.
WRITTEN = ("von_mises.png", "pressure.png", "tractions.png", "tractions.svg",
           "history.png", "history.svg", PAGE)


def results_of(argument: str) -> Results:
    """Of a folder or, for a parameter file, those of its name in output."""
    path = Path(argument)
    if path.suffix not in CASES or path.is_dir():
        if not path.is_dir():
            raise FileNotFoundError(f"no folder {argument}, and no parameter file")
        return Results(path)
    if not path.exists():
        raise FileNotFoundError(f"no file {argument}")
    folder = Path("output") / path.stem
    if not (folder / "summary.json").exists():
        raise FileNotFoundError(
            f"{argument} has no results in {folder}: compute it first,\n"
            f"    ./run {argument} {ASKED_FOR}\n"
            "or name the folder where they are")
    return Results(folder)


def draw_contact(case: Results, folder: Path) -> list[Path]:
    if bodies.in_space(case):
        return bodies.draw_pressure(case, folder / "pressure.png")
    return curves.draw_tractions(case, folder / "tractions.png")


# Captions, in the order of the page.
PICTURES = {
    "The deformed bodies, and where they touch; beyond the largest von Mises stress "
    "there colours do not change":
        lambda case, folder: bodies.draw_bodies(case, folder / "von_mises.png"),
    "Contact on the slaves": draw_contact,
    "History, over the load factor t":
        lambda case, folder: curves.draw_history(case, folder / "history.png"),
}


def plot(case: Results) -> Path:
    """The page."""
    if case.summary["increments"] == []:
        raise ValueError(f"{case.folder} has no increments: the run has not begun")
    for old in WRITTEN:
        (case.folder / old).unlink(missing_ok=True)
    pictures, missing = {}, []
    for words, draw in PICTURES.items():
        try:
            files = draw(case, case.folder)
        except (FileNotFoundError, ValueError) as error:
            missing.append(f"No picture '{words.split(';')[0]}': {error}.")
            continue
        # A drawing is sharp at any size.
        pictures[files[-1]] = words
        print(*files, sep="\n")
    for why in missing:
        print(why, file=sys.stderr)
    page = case.folder / PAGE
    write_page(case, pictures, missing, page)
    print(page)
    return page


def main() -> None:
    arguments = sys.argv[1:]
    if not arguments or arguments[0].startswith("-"):
        print(__doc__)
        sys.exit(0 if arguments[:1] in (["-h"], ["--help"]) else 2)
    for argument in arguments:
        try:
            plot(results_of(argument))
        except (OSError, ValueError, KeyError) as error:
            print(f"plot: {error}", file=sys.stderr)
            sys.exit(2)


if __name__ == "__main__":
    main()
