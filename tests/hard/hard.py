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
--table     print the tables of the pages, and the progress to stderr
CASE        these cases only (and those they are compared with)
"""

import argparse
import concurrent.futures
import csv
import json
import math
import pathlib
import subprocess
import sys
import time

RULES = ("nodal", "Gauss", "mortar")
KINEMATICS = ("large displacement", "small strain")
# The program's default first.
FRICTION = ("Newton", "fixed point", "lagged bound")

# The message of rows that converged by other loops than they asked for.
HANDED_OVER = "solved once more by Newton's method"

# The system that a loop of friction can have: see Parameters::All::check().
SYSTEM = {"Newton": "automatic", "fixed point": "automatic",
          "lagged bound": "condensed"}

# Sums over increments and largest values; from the program that knows them.
COLUMNS = ("case", "rule", "kinematics", "friction", "required", "status",
           "increments", "cut-backs", "cycles", "Newton", "violations",
           "energy imbalance",
           "penetration", "seconds", "holds", "message")


class Case:
    """A case and what must hold.

    same: a case whose probes and contact results are the same, lengths times
    `lengths` and forces times `forces`, within `tolerance` (relative; of the
    forces alone if `forces_only`, for what is turned).
    zone_only: of forces, peak pressure and width of contact alone, where bodies
    come from elsewhere.
    informative: that difference is shown, but nothing is asked of it.
    loop: (coefficient of friction, modulus E*) of two equal cylinders, for the
    energy that Cattaneo and Mindlin's theory says is dissipated, within 10 %
    (the theory's own error, a/R = 0.024, and that of the mesh).
    levels: several meshes, each from the start.
    normal_force: what it has to be at the end [N per mm], within 3 %: the
    integral of the pressure, which on a round surface is a little more than the
    load.
    force_free: the normal force at the end is at most this [N per mm]; in all
    other cases it has to be positive, or nothing was proved.
    frictionless: has no friction, so the loops of it are one.
    quick: part of --quick.
    """

    def __init__(self, name, same=None, tolerance=1e-8, lengths=1.0, forces=1.0,
                 forces_only=False, normal_force=None, force_free=None, frictionless=False,
                 quick=False, informative=False, zone_only=False, levels=False,
                 loop=None):
        self.name = name
        self.same = same
        self.tolerance = tolerance
        self.lengths = lengths
        self.forces = forces
        self.forces_only = forces_only
        self.normal_force = normal_force
        self.force_free = force_free
        self.frictionless = frictionless
        self.quick = quick
        self.informative = informative
        self.zone_only = zone_only
        self.levels = levels
        self.loop = loop


CASES = [
    Case("first_touch", normal_force=8750, frictionless=True, quick=True),
    Case("gap_0.1", normal_force=8750, frictionless=True, same="first_touch",
         zone_only=True, tolerance=1e-4),
    Case("gap_10", normal_force=8750, frictionless=True, same="first_touch",
         zone_only=True, tolerance=1e-4),
    Case("pin", frictionless=True),
    Case("pin_loose", frictionless=True),
    Case("pin_friction"),
    Case("pin_play"),
    Case("pin_tight"),
    Case("one_element", quick=True),
    Case("cycle"),
    Case("friction_0.3", quick=True),
    Case("friction_0.6"),
    Case("friction_1"),
    Case("friction_2"),
    Case("friction_2_path", same="friction_2", informative=True),
    Case("nu_0.49"),
    Case("nu_0.4999"),
    Case("fine_slave"),
    Case("fine_master"),
    Case("swapped"),
    Case("upper_soft"),
    Case("upper_stiff"),
    Case("run_off_right"),
    Case("run_off_left", force_free=1e-8),
    Case("symmetry_friction", quick=True),
    Case("unload", frictionless=True, force_free=1e-6 * 8750),
    Case("unload_reload", normal_force=8750, frictionless=True, same="first_touch",
         tolerance=1e-4),
    Case("reversal", loop=(0.3, 210000 / (2 * (1 - 0.3**2)))),
    Case("triangles", quick=True),
    Case("hanging", levels=True),
    Case("penetration_small", quick=True),
    Case("penetration_edge"),
    Case("deep_5", frictionless=True),
    Case("deep_20", frictionless=True),
    Case("zero_load", force_free=1e-12, quick=True),
    Case("lengths_1e-6", same="friction_0.3", lengths=1e-6, forces=1e-6,
         quick=True),
    Case("lengths_1e6", same="friction_0.3", lengths=1e6, forces=1e6,
         quick=True),
    Case("unturned"),
    Case("turned", same="unturned", forces_only=True),
]

FORCES = ("normal_force", "tangential_force")


def combinations(case, required_only):
    for rule in RULES:
        for kinematics in KINEMATICS:
            for friction in FRICTION[:1] if case.frictionless else FRICTION:
                required = (rule != "Gauss" and friction == FRICTION[0] and
                            kinematics == KINEMATICS[0])
                if required or not required_only:
                    yield rule, kinematics, friction, required


def largest(summary, key):
    """The largest value of an invariant over the increments, if it is known."""
    values = [i["invariants"][key] for i in summary.get("increments", [])
              if i.get("invariants", {}).get(key) is not None]
    return max(values, key=abs) if values else None


def run(options, case, rule, kinematics, friction, required):
    """One row."""
    directory = options.output / "runs" / "_".join(
        (case.name, rule, kinematics, friction)).replace(" ", "-")
    directory.mkdir(parents=True, exist_ok=True)
    command = [str(options.contact),
               str(options.parameters / "hard" / (case.name + ".prm")),
               "--quiet", "--set", "Contact/Discretization=" + rule,
               "--set", "Solids/Kinematics=" + kinematics,
               "--set", "Solution/Friction=" + friction,
               "--set", "Solution/System=" + SYSTEM[friction],
               "--set", "Output/Directory=" + str(directory)]
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
        row["violations"] = sum(len(i["violations"]) for i in increments)
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
        for name in ("max_pressure", "width"):
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
        elif not force > 0:
            verdicts.append("no contact at the end")
            good = False
        if case.normal_force is not None:
            deviation = force / case.normal_force - 1
            verdicts.append("normal force %+.1e" % deviation)
            good = good and abs(deviation) <= 0.03
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
    for rule in RULES:
        for kinematics in KINEMATICS:
            cells = []
            for friction in FRICTION:
                some = [row for row in rows
                        if row["rule"] == rule and
                        row["kinematics"] == kinematics and
                        row["friction"] in (friction, "none"
                                            if friction == FRICTION[0] else "")]
                states = [row["status"] for row in some]
                n, refused = states.count("converged"), states.count("refused")
                cells.append("%d / %d / %d / %d" % (
                    n, sum(row["message"] == HANDED_OVER for row in some),
                    len(states) - n - refused, refused))
            print("| " + " | ".join([rule, kinematics] + cells) + " |")
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


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    here = pathlib.Path(__file__).resolve().parent
    parser.add_argument("contact", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("cases", nargs="*")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--required", action="store_true")
    parser.add_argument("--table", action="store_true")
    parser.add_argument("--output", type=pathlib.Path,
                        default=pathlib.Path("hard"))
    parser.add_argument("--parameters", type=lambda p: pathlib.Path(p).resolve(),
                        default=here.parent.parent / "parameters")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--timeout", type=float, default=120)
    options = parser.parse_args()
    unknown = set(options.cases) - {case.name for case in CASES}
    if unknown:
        parser.error("unknown cases: " + ", ".join(sorted(unknown)))

    wanted = set(options.cases)
    wanted |= {case.same for case in CASES if case.name in wanted}
    cases = [case for case in CASES
             if (not wanted or case.name in wanted) and
             (case.quick or not options.quick)]
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
