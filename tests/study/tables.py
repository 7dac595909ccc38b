# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of the report, in Markdown, each from the rows of the CSV file."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import analysis
import matrix

sys.path.append(str(Path(__file__).resolve().parents[1]))
import line_contact  # noqa: E402

SSNP = {"ssnp154": "SSNP154 without friction",
        "ssnp154_friction": "SSNP154 with friction 0.1, two increments"}


# --------------------------------------------------------------- small helpers

def table(head: list[str], body: list[list]) -> str:
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(str(c) for c in cells) + " |" for cells in body]
    return "\n".join(lines)


def short(value, digits=2) -> str:
    """An error: 1.2e-03; '-' if it is not known."""
    if value is None or value == "" or math.isnan(value):
        return "-"
    return f"{value:.{digits - 1}e}"


def fixed(value, digits=2) -> str:
    if value is None or value == "" or math.isnan(value):
        return "-"
    return f"{value:.{digits}f}"


def percent(target: float) -> str:
    return f"{100 * target:g} %"


def of_problem(rows, problem):
    return [r for r in rows if r["problem"] == problem and r["ok"]]


# --------------------------------------------------------------------- tables

def reference_table(rows) -> str:
    """The references, and how far they are to be trusted."""
    body = []
    for problem, title in SSNP.items():
        for r in of_problem(rows, problem):
            if not r["role"]:
                continue
            limit, width = matrix.PUBLISHED[problem]
            cells = [title, r["role"], r["element"], analysis.label(r),
                     int(r["unknowns"]), f"{r['dy']:.7f}",
                     f"{r['dy'] - limit:+.1e} of {width:.0e}"]
            for q in ("dy", "max_pressure", "width", "stick_width"):
                cells.append(short(r[f"deviation_{q}"]) if r["role"] !=
                             "reference" else f"{r[q]:.6g}")
            body.append(cells)
    if not body:
        return ""
    return ("The row 'reference' has values, the others their relative "
            "differences from it, the largest of which is the uncertainty.\n\n" +
            table(["problem", "role", "element", "method", "unknowns", "DY(B)",
                   "minus that limit [mm]", "DY(B) [mm]",
                   "peak pressure [MPa]", "width [mm]", "sticking [mm]"], body))


def decision_rows(rows, problem: str, title: str, quantity: str,
                  elements=None) -> list[list]:
    """A line for each target."""
    found = analysis.reference(rows, problem, quantity)
    if not found:
        return []
    picks = [analysis.decision(rows, problem, quantity, target, elements)
             for target in matrix.TARGETS]
    body = []
    for i, (target, pick) in enumerate(zip(matrix.TARGETS, picks)):
        name = [title, analysis.NAMES[quantity], percent(target)]
        if target <= 2 * found[1] or not pick:
            why = ("below the uncertainty of the reference"
                   if target <= 2 * found[1] else "none of those that were run")
            body.append(name + [why] + ["-"] * 5)
            continue
        after = picks[i + 1] if i + 1 < len(picks) else None
        ratio = f"x {after['seconds'] / pick['seconds']:.1f}" if after else "-"
        body.append(name + [f"{pick['element']}, {analysis.label(pick)}",
                            int(pick["level"]), int(pick["unknowns"]),
                            f"{pick['seconds']:.2f}",
                            short(pick["largest_error"]), ratio])
    return body


def decision_table(rows) -> str:
    """What to choose for an accuracy, and what the next digit costs."""
    body = []
    for problem, title in SSNP.items():
        for quantity in ("dy", "max_pressure"):
            body += decision_rows(rows, problem, title, quantity)
        body += decision_rows(rows, problem, title + ", linear elements only",
                              "dy", ["linear"])
    if not body:
        return ""
    return ("The cheapest run whose error stays below the target on its mesh "
            "and on all finer ones of its sequence, of which there is one at "
            "least. Seconds are wall seconds after the start of the program.\n\n" +
            table(["problem", "value", "error below", "method", "levels",
                   "unknowns", "seconds", "largest error from there on",
                   "seconds, ten times less error"], body))


def order_table(rows) -> str:
    """Observed orders, the fitted one, and what is expected."""
    body = []
    for problem in ("rings", "disk", "rings_matching"):
        for (element, rule), runs in analysis.sequences(rows, problem).items():
            for q in ("displacement", "energy", "pressure"):
                column = f"error_{q}"
                runs_with = [r for r in runs if r[column]]
                if not runs_with:
                    continue
                expected = matrix.expected_orders(problem, element, rule)[q]
                observed = analysis.orders([r[column] for r in runs_with])
                body.append([problem, element, rule, q,
                             f"{int(runs_with[0]['level'])} to "
                             f"{int(runs_with[-1]['level'])}",
                             short(runs_with[-1][column]),
                             ", ".join(fixed(o) for o in observed),
                             fixed(analysis.fitted_order(runs, column)),
                             "not known" if expected is None else expected])
    return table(["problem", "element", "rule", "error of", "refinements",
                  "on the finest", "orders from mesh to mesh",
                  "over the last three", "expected"], body) if body else ""


def order_summary(rows) -> str:
    """One line a method: the orders over the last three meshes."""
    body = []
    for problem in ("rings", "disk", "rings_matching"):
        for (element, rule), runs in analysis.sequences(rows, problem).items():
            expected = matrix.expected_orders(problem, element, rule)
            cells = []
            for q in ("displacement", "energy", "pressure"):
                found = fixed(analysis.fitted_order(runs, f"error_{q}"))
                cells.append(found if expected[q] is None
                             else f"{found} ({expected[q]:g})")
            body.append([problem, element, rule] + cells)
    return ("Over the last three meshes; in brackets what theory says, where "
            "it does.\n\n" +
            table(["problem", "element", "rule", "displacement", "energy",
                   "pressure"], body)) if body else ""


def hertz_table(rows) -> str:
    body = []
    for problem in ("hertz", "hertz_load"):
        for r in of_problem(rows, problem):
            load = float(r["setting"] or 1)
            theory = line_contact.ssnp154(350 * load).approach
            body.append(
                [r["element"], r["rule"], int(r["level"]), int(r["unknowns"]),
                 f"{load:g}", f"{r['exact_half_width'] / 50:.4f}",
                 short(r["error_pressure"]),
                 f"{r['max_pressure'] / r['exact_max_pressure'] - 1:+.2e}",
                 f"{r['width'] / r['exact_half_width'] - 1:+.2e}",
                 f"{r['approach'] / theory - 1:+.2e}", f"{r['seconds']:.2f}"])
    return ("Relative deviations from Hertz' theory, which is right up to terms "
            "that grow with a/R.\n\n" +
            table(["element", "rule", "refinements", "unknowns", "load", "a/R",
                   "pressure (L2)", "peak pressure", "half width", "approach",
                   "seconds"], body)) if body else ""


def increment_table(rows) -> str:
    body = []
    for r in of_problem(rows, "hertz_friction"):
        own = (r["exact_stick_half_width"] / r["exact_half_width"]
               if r["exact_stick_half_width"] else None)
        body.append([r["element"], int(r["unknowns"]), int(r["increments"]),
                     fixed(analysis.stick_ratio(r), 3),
                     matrix.STICK_RATIO[int(r["increments"])], fixed(own, 3),
                     fixed(r["max_shear"], 2), fixed(r["exact_max_shear"], 2),
                     short(r["error_shear"]), f"{r['seconds']:.2f}"])
    return table(["element", "unknowns", "increments", "sticking by contact",
                  "two half planes, many points", "two half planes, program",
                  "peak shear [MPa]", "of two half planes", "shear (L2)",
                  "seconds"], body) if body else ""


def cattaneo_table(rows) -> str:
    body = []
    for r in of_problem(rows, "cattaneo_mindlin"):
        stick = (r["stick_width"] / 2 / r["exact_stick_half_width"] - 1
                 if r["exact_stick_half_width"] else None)
        body.append([r["element"], r["rule"], int(r["level"]),
                     int(r["unknowns"]), short(r["error_pressure"]),
                     short(r["error_shear"]),
                     "-" if stick is None else f"{stick:+.2e}",
                     f"{r['seconds']:.2f}"])
    return table(["element", "rule", "refinements", "unknowns", "pressure (L2)",
                  "shear (L2)", "width of sticking", "seconds"],
                 body) if body else ""


def knob_table(rows) -> str:
    """What each setting changes, what it saves, beside the error of the mesh."""
    body = []
    for problem in ("knobs", "knobs_friction", "knobs_large"):
        runs = [r for r in rows if r["problem"] == problem]
        mesh = {r["setting"]: r for r in runs if r["knob"] == "mesh" and r["ok"]}
        of_mesh = {q: abs(mesh["as it is"][q] / mesh["refined once"][q] - 1)
                   if len(mesh) == 2 else None for q in ("dy", "max_pressure")}
        for knob in matrix.KNOBS:
            turned = [r for r in runs if r["knob"] == knob]
            tightest = next((r for r in reversed(turned) if r["ok"]), None)
            for r in turned:
                if not r["ok"]:
                    body.append([problem, knob, r["setting"], "failed"] +
                                ["-"] * 6)
                    continue
                body.append([problem, knob, r["setting"]] +
                            [short(abs(r[q] / tightest[q] - 1))
                             for q in ("dy", "max_pressure")] +
                            [short(of_mesh[q]) for q in ("dy", "max_pressure")] +
                            [int(r["newton"]), f"{r['seconds']:.2f}",
                             f"{r['seconds'] / tightest['seconds']:.2f}"])
    return ("Relative changes against the tightest setting (the last that "
            "converged), and the change when the mesh is refined once. Where "
            "the increments count, their number is part of the problem.\n\n" +
            table(["problem", "knob", "setting", "DY(B)", "peak pressure",
                   "mesh, DY(B)", "mesh, peak pressure", "Newton steps",
                   "seconds", "by those of the tightest one"],
                  body)) if body else ""


# A few settings that tell the story; all of them are in study.md.
TELLING = {"Newton tolerance": ("1e-2", "1e-4", "1e-8"),
           "Geometry tolerance": ("1e-2", "1e-3", "1e-5"),
           "Friction tolerance": ("1e-1", "1e-4", "1e-10"),
           "Increments": ("1", "2", "4", "8"),
           "Linear tolerance": ("1e-1", "1e-3", "1e-6")}


def knob_summary(rows) -> str:
    """The table above with a few settings only."""
    lines = knob_table(rows).splitlines()
    def tells(line):
        cells = [cell.strip() for cell in line.split("|")]
        return len(cells) < 4 or cells[3] in TELLING.get(cells[2], [cells[3]])
    return "\n".join(line for line in lines
                     if tells(line) or line.startswith("|---"))


def estimate_table(rows) -> str:
    """Estimated by true errors of DY(B)."""
    body = []
    for problem, title in SSNP.items():
        found = analysis.reference(rows, problem, "dy")
        if not found:
            continue
        value, uncertainty = found
        for (element, name), runs in analysis.sequences(rows, problem).items():
            ratios = sorted(r["dy_estimate"] / abs(r["dy"] - value) for r in runs
                            if r["dy_estimate"] != "" and
                            abs(r["dy"] / value - 1) > 2 * uncertainty)
            if ratios:
                n = len(ratios)
                middle = (ratios[(n - 1) // 2] + ratios[n // 2]) / 2
                body.append([title, element, name, n, fixed(ratios[0]),
                             fixed(middle), fixed(ratios[-1]),
                             sum(q < 1 for q in ratios)])
    return ("Estimated error of DY(B) divided by the true one, where that is above the "
            "uncertainty of the reference.\n\n" +
            table(["problem", "element", "method", "runs", "smallest", "median",
                   "largest", "below 1"], body)) if body else ""


def run_table(rows) -> str:
    """All runs of SSNP154, with what is behind the pictures."""
    body = []
    for problem in SSNP:
        for (element, name), runs in analysis.sequences(rows, problem).items():
            for r in runs:
                cells = [problem, element, name, int(r["level"]),
                         int(r["unknowns"])]
                for q in ("dy", "max_pressure", "width"):
                    found = analysis.reference(rows, problem, q)
                    e = r[f"deviation_{q}"]
                    below = found and e != "" and abs(e) < 2 * found[1]
                    cells.append("< " + short(2 * found[1]) if below
                                 else short(e))
                body.append(cells + [int(r["newton"]), int(r["linear"]),
                                     f"{r['seconds']:.2f}", f"{r['cpu']:.2f}",
                                     f"{r['memory_mb']:.0f}"])
    return ("'<': below the uncertainty of the reference.\n\n" +
            table(["problem", "element", "method", "levels", "unknowns", "DY(B)",
                   "peak pressure", "width", "Newton steps", "linear iterations",
                   "wall [s]", "CPU [s]", "memory [MB]"], body)) if body else ""


def left_out_table(rows) -> str:
    """What makes no sense, and what failed: one line a sequence."""
    failed: dict[tuple, list[dict]] = {}
    for r in rows:
        if not r["ok"]:
            key = (r["problem"], r["role"], r["element"], analysis.label(r),
                   r["knob"])
            failed.setdefault(key, []).append(r)
    body = [[what, why] for what, why in matrix.LEFT_OUT]
    for key, runs in failed.items():
        which = ", ".join(r["setting"] or f"{r['level']:.0f}" for r in runs)
        body.append([", ".join(k for k in key if k) + f" ({which})",
                     "failed: " + runs[0]["message"].replace("|", "/")])
    return table(["what", "why it is not there"], body)


TABLES = {
    "decision": ("What to choose", decision_table),
    "reference": ("References", reference_table),
    "orders": ("Orders of convergence", order_table),
    "hertz": ("Hertz", hertz_table),
    "increments": ("Sticking and the number of increments", increment_table),
    "cattaneo": ("Cattaneo and Mindlin", cattaneo_table),
    "knobs": ("Tolerances and increments", knob_table),
    "estimates": ("Estimated errors", estimate_table),
    "runs": ("All runs of SSNP154", run_table),
    "left_out": ("What is missing", left_out_table),
}


def all_tables(rows) -> dict[str, str]:
    """Those of study.md, and shorter ones for the pages."""
    return {name: make(rows) for name, (_, make) in TABLES.items()} | {
        "order_summary": order_summary(rows), "knob_summary": knob_summary(rows)}
