#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a run says, on the screen and in log.txt.

Proves that a block pressed on another one, in four increments with friction, has

- on the screen a line an increment with the values of history.csv to six digits,
  below a head with units, all as long as the head; no iteration, no counter, no
  byte that moves the cursor;
- in log.txt every iteration and the counters, and the same with --verbose on the
  screen; nothing but the table with --quiet, where log.txt is the same;
- on a terminal a bar that is drawn with increments done, time left, and wiped out;
- two levels: a line for the second mesh; 12 pairs: no line beyond 110 characters.

And that a scene says before its first increment

- by how much, where and in which pair bodies overlap in the mesh, and nothing
  where they only touch;
- which bodies nothing holds together, with exit status 2;
- a note once a run, not in each of ten increments; and at the end that nothing
  touches, where a body was pushed away without a force.

Usage: screen.py CONTACT PARAMETERS MESHES
"""

import csv
import os
import pathlib
import pty
import re
import subprocess
import sys

from block_scenes import Mesh, box, check, contact, failures

ENTRIES = {
    "Solids/Young's modulus": "A: 70000, B: 210000",
    "Solids/Poisson's ratio": "A: 0.3, B: 0.3",
    "Boundary conditions/Displacement x": "Base: 0, Head: 0.02",
    "Boundary conditions/Displacement y": "Base: 0, Head: -0.05",
    "Boundary conditions/Histories":
        "Displacement y: min(1, 2*t); Displacement x: max(0, 2*t - 1)",
    "Contact/Slave": "Sole", "Contact/Master": "Ground",
    "Contact/Friction coefficient": 0.3, "Solution/Increments": 4,
    "Probes/Probes": "pressure: pressure, Corner; stress: stress yy, Corner"}


def write(name, entries, above=0.):
    """A case of two blocks, the upper one so far above the lower one."""
    mesh = Mesh()
    mesh.block("A", 12, 6, box(-20, -20, 20, 0), {"bottom": "Base", "top": "Ground"})
    mesh.block("B", 8, 4, box(-10, above, 10, above + 10),
               {"bottom": "Sole", "top": "Head", "corner": "Corner"})
    mesh.write(name)
    sections = {}
    for entry, value in {**ENTRIES, "Mesh/File": f"{name}.msh", **entries}.items():
        section, key = entry.split("/")
        sections.setdefault(section, []).append(f"  set {key} = {value}\n")
    pathlib.Path(f"{name}.prm").write_text("".join(
        f"subsection {section}\n{''.join(lines)}end\n"
        for section, lines in sections.items()))


def run(name, *options):
    done = subprocess.run([contact, f"{name}.prm", *options], text=True,
                          capture_output=True, check=False)
    return done.returncode, done.stdout, done.stderr


def log(name):
    return pathlib.Path(f"output/{name}/log.txt").read_text()


def without_times(text):
    """Time, memory and the directory differ from run to run."""
    text = text.split("Wall time in seconds")[0]
    return re.sub(r" +[0-9.]+(?=\n)", "", text)


def lines_of_increments():
    # Errors of probes at a corner would be notes, which are on the other stream.
    write("blocks", {"Probes/Errors": "none"})
    status, screen, said = run("blocks")
    check("blocks: converge", status == 0, said)
    lines = screen.splitlines()
    head = next(i for i, line in enumerate(lines) if "Newton" in line)
    table = [line.split() for line in lines[head + 2:head + 6]]
    with open("output/blocks/history.csv", encoding="utf-8") as file:
        history = list(csv.DictReader(file))
    names = ("t [-]", "Newton steps [-]", "contact normal_force [N/mm]",
             "contact max_pressure [MPa]", "pressure [MPa]", "stress [MPa]")
    check("a row an increment, with stresses", len(history) == 4 and
          all(row[name] for row in history for name in names), history)
    for row, shown in zip(history, table):
        check("its line on the screen",
              [f"{float(row[name]):.6g}" for name in names] == shown[:-1], shown)
    check("columns are aligned",
          len({len(line) for line in lines[head:head + 6]}) == 1, screen)
    check("a line of units", lines[head + 1].split() == [
        "[-]", "[steps]", "[N/mm]", "[MPa]", "[MPa]", "[MPa]", "[s]"], lines[head + 1])
    check("no iteration, no counter, no escape, few lines",
          not re.search("residual|Not at all|Done:|\r|\033", screen) and
          len(lines) < 16, screen)
    quiet = log("blocks")
    check("log.txt has iterations, counters, screen",
          quiet.count("residual") >= 8 and "Not at all" in quiet and
          lines[head + 2] in quiet, quiet)
    _, verbose, _ = run("blocks", "--verbose")
    check("--verbose: what log.txt has",
          without_times(verbose) == without_times(log("blocks")) ==
          without_times(quiet), verbose)
    _, table, _ = run("blocks", "--quiet")
    check("--quiet: the table alone, the same log.txt",
          table.startswith("case ") and
          without_times(log("blocks")) == without_times(quiet), table)


def terminal():
    parent, child = pty.openpty()
    with subprocess.Popen([contact, "blocks.prm"], stdout=child,
                          stderr=subprocess.DEVNULL) as process:
        os.close(child)
        said = b""
        while True:
            try:
                piece = os.read(parent, 65536)
            except OSError:  # the other side is closed
                break
            if not piece:
                break
            said += piece
    text = said.decode()
    check("terminal: a bar, and the time left",
          re.search(r"\[#*\.*\] +\d+ %, t [0-9.]+, Newton step", text) is not None,
          repr(text[-600:]))
    check("  nothing of it behind a line", not re.search(r"Newton step[^\r]*\n", text),
          repr(text))


def more_columns():
    write("levels", {"Refinement/Levels": 1, "Solution/Increments": 2})
    status, screen, said = run("levels")
    check("levels: a line each, increments of both",
          status == 0 and screen.count("Level 1: ") == 1 and
          len(re.findall(r"^ +(?:0\.5|1) +\d+ ", screen, re.M)) == 4, screen + said)
    probes = "; ".join(f"way_of_the_head_{i}: displacement y, Corner"
                       for i in range(12))
    write("wide", {"Probes/Probes": probes, "Solution/Increments": 1})
    status, screen, said = run("wide")
    lines = screen.split("Results:")[0].splitlines()[1:]
    check("many probes: no line beyond 110 characters, and where the rest is",
          status == 0 and max(map(len, lines)) <= 110 and
          "history.csv" in screen, screen + said)


def scenes():
    note = "the bodies overlap by"
    write("apart", {}, above=-0.01)
    _, _, said = run("apart")
    first = said.splitlines()[0] if said else ""
    check("an overlap is told before the first increment", "by 0.01 mm" in first and
          "'Contact'" in first and "X = (" in first and "t = " not in first, said)
    check("no overlap where bodies touch", note not in run("blocks")[2])
    write("unheld", {"Boundary conditions/Displacement x": "Base: 0",
                     "Boundary conditions/Displacement y": "",
                     "Boundary conditions/Resultant force y": "Head: -500",
                     "Boundary conditions/Histories": ""})
    status, _, said = run("unheld")
    check("two bodies that nothing holds", status == 2 and
          "'A'" in said and "'B'" in said and "displacement in y" in said, said)
    write("pushed", {"Boundary conditions/Displacement x": "Base: 0",
                     "Boundary conditions/Displacement y": "Head: -0.05",
                     "Boundary conditions/Histories": ""})
    status, _, said = run("pushed")
    check("a body that is pushed away without a force", "nothing touches" in said and
          "nothing holds the body 'A' at the end" in said, said)
    write("repeated", {"Probes/Probes": "side: reaction x, Sole",
                       "Solution/Increments": 10,
                       "Boundary conditions/Displacement x": "Base: 0, Sole: 0.02"})
    status, _, said = run("repeated")
    check("a note of each increment is told once",
          len(re.findall("note: the probe 'side'", said)) == 1, said)


lines_of_increments()
terminal()
more_columns()
scenes()
print(len(failures), "failures")
sys.exit(bool(failures))
