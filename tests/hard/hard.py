#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hard cases: does it converge, and is what must hold so?

Runs the cases of parameters/hard with every contact rule, kinematics and
treatment of friction, and writes a row for each to hard.csv and hard.md.
Combinations that the program refuses are rows with its reason. A row is
required to converge if it has the settings of its file with the rule nodal or
mortar and the loop of friction that is the program's default; the exit status
is 1 if one of these fails, or if something that must hold does not.

Usage: hard.py [--quick] [--required] [--output DIRECTORY] [--jobs N]
               [--parameters DIRECTORY] [--timeout SECONDS] CONTACT [CASE...]

--quick     few cases, required rows only
--required  all cases, required rows only
--plane, --space  only the cases in 2-D, only those in 3-D
--table     print the tables of the pages, and the progress to stderr
CASE        these cases only (and those they are compared with)
"""

import argparse
import concurrent.futures
import csv
import itertools
import json
import math
import pathlib
import re
import subprocess
import sys
import time

from cases import CASES

RULES = ("nodal", "Gauss", "mortar")
KINEMATICS = ("large displacement", "small strain")
# The program's default first.
FRICTION = ("Newton", "fixed point")

# The message of rows that converged by other loops than they asked for.
HANDED_OVER = "solved once more by Newton's method"

# Sums over increments and largest values; from the program that knows them.
COLUMNS = ("case", "rule", "kinematics", "friction", "required", "status",
           "increments", "cut-backs", "cycles", "Newton", "violations",
           "energy imbalance",
           "penetration", "seconds", "holds", "message")


FORCES = ("normal_force", "tangential_force")


def combinations(case, required_only):
    for rule in RULES:
        if rule == "Gauss" and case.in_space:
            continue
        for kinematics in KINEMATICS:
            for friction in FRICTION[:1] if case.frictionless else FRICTION:
                required = (rule != "Gauss" and rule not in case.unsolved and
                            friction == FRICTION[0] and
                            kinematics == KINEMATICS[0])
                if required or not required_only:
                    yield rule, kinematics, friction, required


def largest(summary, key):
    """The largest value of an invariant over the increments, if it is known."""
    values = [i["invariants"][key] for i in summary.get("increments", [])
              if i.get("invariants", {}).get(key) is not None]
    return max(values, key=abs) if values else None


def discretization(path, rule):
    """Its entry in each section of contact that the file has."""
    sections = re.findall("^subsection (Contact.*)$", path.read_text(),
                          re.MULTILINE)
    further = [section for section in sections if section != "Contact"]
    return ["%s/Discretization=%s" % (section, rule)
            for section in further or ["Contact"]]


def settings(path, rule, kinematics, friction):
    """The entries of a row."""
    return discretization(path, rule) + ["Solids/Kinematics=" + kinematics,
                                         "Solution/Friction=" + friction]


def run(options, case, rule, kinematics, friction, required):
    """One row."""
    directory = options.output / "runs" / "_".join(
        (case.name, rule, kinematics, friction)).replace(" ", "-")
    directory.mkdir(parents=True, exist_ok=True)
    file = options.parameters / "hard" / (case.name + ".prm")
    command = [str(options.contact), str(file), "--quiet"]
    for entry in settings(file, rule, kinematics, friction):
        command += ["--set", entry]
    command += ["--set", "Output/Directory=" + str(directory)]
    row = dict.fromkeys(COLUMNS)
    row.update({"case": case.name, "rule": rule, "kinematics": kinematics,
                "friction": "none" if case.frictionless else friction,
                "required": "yes" if required else ""})
    path = directory / case.name / "summary.json"
    if path.exists():
        path.unlink()
    start = time.monotonic()
    try:
        result = subprocess.run(command, capture_output=True, text=True,
                                timeout=options.timeout)
        status, errors = result.returncode, result.stderr.strip()
    except subprocess.TimeoutExpired:
        status, errors = None, "no end after %g s" % options.timeout
    row["seconds"] = time.monotonic() - start
    row["status"] = {0: "converged", 1: "converged", 2: "refused",
                     3: "NOT converged", None: "TIMEOUT"}.get(
                         status, "FAILED (status %s)" % status)
    row["message"] = errors.split("\n")[0].replace("error:", "").strip()
    handed_over = "\nOnce more from the start" in errors
    row["summary"] = None
    if status in (0, 1, 3) and path.exists():
        summary = json.loads(path.read_text())
        increments = summary.get("increments", [])
        row["summary"] = summary
        row["message"] = summary.get("message", "").split("\n")[0]
        if status in (0, 1) and handed_over:
            row["message"] = HANDED_OVER
        row["increments"] = sum(bool(i["converged"]) for i in increments)
        row["Newton"] = sum(i["newton_iterations"] for i in increments)
        row["cut-backs"] = sum(not i["converged"] for i in increments)
        row["cycles"] = sum(i["cycles"] for i in increments)
        row["violations"] = sum(
            f["severity"] == "violated" for f in summary.get("findings", []))
        row["energy imbalance"] = largest(summary, "energy_imbalance")
        row["penetration"] = largest(summary, "penetration")
    if status is None:
        row["status"] = "TIMEOUT"
    return row


def difference(case, summary, other):
    """Largest relative difference to another case, of displacements relative
    to their largest."""
    worst = 0.0
    for name in FORCES:
        expected = case.forces * other["contact"].get(name, 0)
        size = max(abs(case.forces * other["contact"].get(f, 0))
                   for f in FORCES)
        if size > 0:
            worst = max(worst,
                        abs(summary["contact"].get(name, 0) - expected) / size)
    if case.zone_only:
        for name in ("max_pressure", "area" if case.in_space else "width"):
            expected = other["contact"][name]
            worst = max(worst, abs(summary["contact"][name] / expected - 1))
    if case.forces_only or case.zone_only:
        return worst
    values = {p["name"]: case.lengths * p["value"] for p in other["probes"]}
    size = max((abs(v) for v in values.values()), default=0)
    for probe in summary["probes"]:
        if size > 0:
            worst = max(worst, abs(probe["value"] - values[probe["name"]]) /
                        size)
    return worst


def cattaneo_mindlin_loop(contact, friction, modulus):
    """What friction dissipates [N mm per mm] as the tangential force goes from 0
    to Q, to -Q and back under the normal force P. By Masing's rule, with m = 1 -
    Q/(mu P), a whole cycle takes D = 2 (mu P)^2/(pi E*) (2 m ln m + 1 - m^2)
    and the first loading D/4."""
    limit = friction * contact["normal_force"]
    m = 1 - abs(contact["tangential_force"]) / limit
    cycle = (2 * limit**2 / (math.pi * modulus) *
             (2 * m * math.log(m) + 1 - m**2))
    return 1.25 * cycle


def check(rows, cases):
    """Fill the column of what must hold."""
    def key(name, row):
        return name, row["rule"], row["kinematics"], row["friction"]

    found = {key(row["case"], row): row for row in rows}
    by_name = {case.name: case for case in cases}
    for row in rows:
        case = by_name[row["case"]]
        if row["status"] != "converged":
            continue
        verdicts, good = [], True
        if case.same is not None:
            other = found.get(key(case.same, row))
            if other is not None and other["status"] == "converged":
                worst = difference(case, row["summary"], other["summary"])
                verdicts.append("%.1e to %s" % (worst, case.same))
                good = good and (worst <= case.tolerance or case.informative)
        force = row["summary"]["contact"].get("normal_force", 0)
        if case.force_free is not None:
            verdicts.append("normal force %.1e" % force)
            good = good and abs(force) <= case.force_free
        elif not force > 0 and case.lift is None:
            verdicts.append("no contact at the end")
            good = False
        if case.normal_force is not None:
            deviation = force / case.normal_force - 1
            verdicts.append("normal force %+.1e" % deviation)
            good = good and abs(deviation) <= 0.03
        if case.lift is not None:
            groups = row["summary"]["increments"][-1]["reactions"].values()
            deviation = sum(group.get("z", 0) for group in groups) / case.lift - 1
            verdicts.append("reactions %+.1e" % deviation)
            good = good and abs(deviation) <= 1e-6
        if case.full_slip is not None:
            deviation = (row["summary"]["contact"]["tangential_force"] /
                         (case.full_slip * force) - 1)
            verdicts.append("friction %+.1e" % deviation)
            good = good and abs(deviation) <= 0.01
        off = [probe["name"] for probe in row["summary"]["probes"]
               if probe["reference"] is not None and
               abs(probe["relative_deviation"]) > probe["tolerance"]]
        if off:
            verdicts.append("off their references: " + ", ".join(off))
            good = False
        if row["violations"]:
            verdicts.append("%d violations" % row["violations"])
            good = False
        work = [i["works"]["dissipation"] for i in row["summary"]["increments"]
                if i["works"]]
        energy = max([abs(i["works"][name]) for name in ("strain_energy", "external")
                      for i in row["summary"]["increments"] if i["works"]])
        if any(b < a - 1e-9 * energy
               for a, b in zip(work, work[1:])) and not case.levels:
            verdicts.append("friction gives energy back")
            good = False
        if case.loop is not None:
            deviation = work[-1] / cattaneo_mindlin_loop(
                row["summary"]["contact"], *case.loop) - 1
            verdicts.append("dissipation %+.1e" % deviation)
            good = good and abs(deviation) <= 0.1
        row["holds"] = ("" if not verdicts else
                        ("yes: " if good else "NO: ") + ", ".join(verdicts))


def failed(row):
    """Whether a row makes the suite fail."""
    return bool(row["required"]) and (row["status"] != "converged" or
                                      (row["holds"] or "").startswith("NO"))


def text(value):
    if value is None:
        return ""
    return "%.2g" % value if isinstance(value, float) else str(value)


def write(rows, output):
    with open(output / "hard.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        writer.writerows([text(row[c]) for c in COLUMNS] for row in rows)
    with open(output / "hard.md", "w") as file:
        file.write("| " + " | ".join(COLUMNS) + " |\n")
        file.write("|" + " --- |" * len(COLUMNS) + "\n")
        for row in rows:
            file.write("| " + " | ".join(
                text(row[c]).replace("|", "\\|") for c in COLUMNS) + " |\n")


def print_tables(rows, cases):
    """The tables of the pages: the required rows of each case, how many of all
    combinations converge, and those that do not."""
    print("Nodal / mortar rule at default settings (large displacement, friction "
          "by Newton's method).\n")
    columns = ("increments", "cut-backs", "cycles", "Newton", "energy imbalance",
               "penetration", "seconds")
    print("| case | converged | " + " | ".join(
        c + (" [mm]" if c == "penetration" else "") for c in columns) +
        " | what must hold |")
    print("|---|---|" + "---|" * len(columns) + "---|")
    for case in cases:
        pair = [row for row in rows if row["case"] == case.name and row["required"]]
        print("| " + " | ".join(
            [case.name, " / ".join("yes" if r["status"] == "converged" else "NO"
                                   for r in pair)] +
            [" / ".join(text(r[c]) for r in pair) for c in columns] +
            ["; ".join(dict.fromkeys(r["holds"] for r in pair if r["holds"]))]) +
            " |")

    print("\nAll combinations: converged / of these by Newton's method, once more "
          "from the start / not converged / refused.\n")
    print("| rule | kinematics | " + " | ".join(FRICTION) + " |")
    print("|---|---|" + "---|" * len(FRICTION))
    in_space = {case.name for case in cases if case.in_space}
    for rule, space, kinematics in itertools.product(RULES, (False, True),
                                                     KINEMATICS):
        if any((row["rule"], row["case"] in in_space) == (rule, space)
               for row in rows):
            cells = []
            for friction in FRICTION:
                some = [row for row in rows
                        if (row["case"] in in_space) == space and
                        row["rule"] == rule and
                        row["kinematics"] == kinematics and
                        row["friction"] in (friction, "none"
                                            if friction == FRICTION[0] else "")]
                states = [row["status"] for row in some]
                n, refused = states.count("converged"), states.count("refused")
                cells.append("%d / %d / %d / %d" % (
                    n, sum(row["message"] == HANDED_OVER for row in some),
                    len(states) - n - refused, refused))
            print("| " + " | ".join(
                [rule + (", in 3-D" if space else ""), kinematics] + cells) +
                " |")
    print("\nWithout friction: under \"%s\". What does not converge, or is refused "
          "(once for each reason):\n" % FRICTION[0])
    reasons = {}
    for row in rows:
        if row["status"] != "converged":
            reason = row["message"] if row["status"] == "refused" else ": ".join(
                row["message"].split(": ")[1:]).rstrip("0123456789. ")
            reasons.setdefault((row["rule"], reason), []).append(row)
    for (rule, reason), found in reasons.items():
        names = list(dict.fromkeys(row["case"] for row in found))
        print("- %s, %d rows (%s): %s" % (
            rule, len(found), ", ".join(names) if len(names) < 6
            else "%d cases" % len(names), reason))


def argument_parser(description, output):
    """The options of the scripts on these cases."""
    parser = argparse.ArgumentParser(
        description=description, formatter_class=argparse.RawTextHelpFormatter)
    here = pathlib.Path(__file__).resolve().parent
    parser.add_argument("contact", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("cases", nargs="*")
    parser.add_argument("--space", action="store_true")
    parser.add_argument("--output", type=pathlib.Path,
                        default=pathlib.Path(output))
    parser.add_argument("--parameters", type=lambda p: pathlib.Path(p).resolve(),
                        default=here.parent.parent / "parameters")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--timeout", type=float, default=120)
    return parser


def main():
    parser = argument_parser(__doc__, "hard")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--required", action="store_true")
    parser.add_argument("--plane", action="store_true")
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    unknown = set(options.cases) - {case.name for case in CASES}
    if unknown:
        parser.error("unknown cases: " + ", ".join(sorted(unknown)))

    wanted = set(options.cases)
    wanted |= {case.same for case in CASES if case.name in wanted}
    cases = [case for case in CASES
             if (not wanted or case.name in wanted) and
             (case.quick or not options.quick) and
             not (case.in_space if options.plane else
                  options.space and not case.in_space)]
    options.output.mkdir(parents=True, exist_ok=True)
    options.output = options.output.resolve()

    jobs = [(case, *combination) for case in cases
            for combination in combinations(case, options.quick or
                                            options.required)]
    progress = sys.stderr if options.table else sys.stdout
    rows = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        futures = [pool.submit(run, options, *job) for job in jobs]
        for n, future in enumerate(futures, 1):
            row = future.result()
            rows.append(row)
            print("[%d/%d] %-18s %-6s %-18s %-11s %s%s" %
                  (n, len(jobs), row["case"], row["rule"], row["kinematics"],
                   row["friction"], row["status"],
                   ": " + row["message"] if row["message"] else ""),
                  file=progress, flush=True)
    check(rows, cases)
    write(rows, options.output)

    failures = [row for row in rows if failed(row)]
    for row in failures:
        print("FAILED: %s, %s: %s %s" % (row["case"], row["rule"],
                                         row["status"], row["holds"] or ""),
              file=progress)
    n_converged = sum(row["status"] == "converged" for row in rows)
    print("%d rows: %d converged, %d refused, %d required ones failed; see %s" %
          (len(rows), n_converged,
           sum(row["status"] == "refused" for row in rows), len(failures),
           options.output / "hard.md"), file=progress)
    if options.table:
        print_tables(rows, cases)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
