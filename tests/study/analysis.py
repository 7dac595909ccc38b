# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the runs to numbers: the CSV file, errors, orders, decisions.

A row is a dictionary of strings and numbers; what is unknown is an empty
string, in the file and in memory.
"""

from __future__ import annotations

import csv
import math
from pathlib import Path

import matrix

PHASES = ["setup", "search", "assembly", "residual", "factorization",
          "preconditioner", "solution", "active set", "estimate", "refinement",
          "output"]
QUANTITIES = ["dy", "max_pressure", "width", "stick_width"]
NAMES = {"dy": "DY(B)", "max_pressure": "peak pressure", "width": "width",
         "stick_width": "width of sticking"}
COLUMNS = (
    ["id", "problem", "element", "rule", "refinement", "system", "solver",
     "friction", "level", "increments", "knob", "setting", "role", "ok",
     "status", "message", "cells", "unknowns", "multipliers", "newton",
     "newton_finest", "linear", "dy", "dy_estimate", "siyy", "approach",
     "normal_force", "tangential_force", "max_pressure", "max_shear", "width",
     "stick_width"] +
    [f"exact_{q}" for q in ("half_width", "max_pressure", "stick_half_width",
                            "max_shear")] +
    [f"error_{q}" for q in ("displacement", "energy", "pressure", "shear")] +
    [f"deviation_{q}" for q in QUANTITIES] +
    ["seconds", "wall", "cpu", "memory_mb"] + [f"time {p}" for p in PHASES] +
    ["time other", "command"])
TEXT = {"id", "problem", "element", "rule", "refinement", "system", "solver",
        "friction", "knob", "setting", "role", "message", "command"}


def row(run: matrix.Run, result: dict) -> dict:
    """The line of a run in the table."""
    summary = result["summary"]
    levels = summary.get("levels") or [{}]
    probes = {p["name"]: p for p in summary.get("probes", [])}
    increments = [i for i in summary.get("increments", [])
                  if i.get("level", 0) == len(levels) - 1]
    line = {name: getattr(run, name) for name in (
        "id", "problem", "element", "rule", "refinement", "system", "solver",
        "friction", "level", "knob", "setting", "role")}
    line.update(
        increments=run.increments or len(increments), ok=int(not result["message"]),
        status=result["status"], message=result["message"],
        cells=levels[-1].get("cells", ""),
        unknowns=summary.get("unknowns", {}).get("displacement", ""),
        multipliers=summary.get("unknowns", {}).get("multipliers", ""),
        newton=sum(level.get("newton_iterations", 0) for level in levels),
        newton_finest=levels[-1].get("newton_iterations", ""),
        linear=sum(level.get("linear_iterations", 0) for level in levels),
        dy_estimate=probes.get("DY(B)", {}).get("estimated_error"),
        **{column: probes.get(name, {}).get("value") for column, name in
           [("dy", "DY(B)"), ("siyy", "SIYY(B)"), ("approach", "approach")]},
        wall=result["wall"], cpu=result["cpu"], memory_mb=result["memory_mb"],
        command=result["command"])
    line.update(summary.get("contact", {}))
    compared = result.get("closed_form", {})
    for part, prefix in (("exact", "exact_"), ("errors", "error_")):
        line.update({prefix + k: v for k, v in compared.get(part, {}).items()})
    other = 0.0
    for phase, seconds in summary.get("time", {}).items():
        if phase in PHASES:
            line[f"time {phase}"] = seconds["wall"]
        else:
            other += seconds["wall"]
    line["time other"] = other
    # Without starting the program, which is the same for all, and without the
    # files that only the comparison with a closed form asks for.
    line["seconds"] = sum(seconds["wall"] for phase, seconds in
                          summary.get("time", {}).items()
                          if phase != "output" or not run.closed_form) or ""
    return {k: "" if v is None else v for k, v in line.items()}


def text_of(value) -> str:
    return f"{value:.10g}" if isinstance(value, float) else str(value)


def write_csv(rows: list[dict], path: Path) -> None:
    """One line a run, with the deviations from the references."""
    for r in rows:
        for quantity in QUANTITIES:
            e = deviation(rows, r, quantity)
            r[f"deviation_{quantity}"] = "" if e is None else e
    with open(path, "w", newline="") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(COLUMNS)
        for r in rows:
            writer.writerow(text_of(r.get(column, "")) for column in COLUMNS)


def read_csv(path: Path) -> list[dict]:
    def value(column, text):
        return text if column in TEXT or text == "" else float(text)

    with open(path, newline="") as file:
        return [{c: value(c, t) for c, t in r.items()}
                for r in csv.DictReader(file)]


# ------------------------------------------------------------------ sequences

def label(r: dict) -> str:
    """The name of the method, without the element."""
    words = [r["rule"]]
    if r["system"] == "saddle point":
        words.append("saddle point")
    elif r["refinement"] != "uniform":
        words.append(r["refinement"])
    words += [w for w in (r["solver"], r["friction"]) if w]
    return ", ".join(words)


def sequences(rows: list[dict], problem: str) -> dict[tuple, list[dict]]:
    """The runs of each method that converged, from coarse to fine."""
    found: dict[tuple, list[dict]] = {}
    for r in rows:
        if r["problem"] == problem and not r["role"] and not r["knob"] and r["ok"]:
            key = (r["element"], label(r))
            found.setdefault(key, []).append(r)
    for runs in found.values():
        runs.sort(key=lambda r: r["level"])
    return found


# ----------------------------------------------------------------- references

def reference(rows: list[dict], problem: str, quantity: str):
    """Value and relative uncertainty: the overkill run, and how far the others
    that check it differ from it. None if one is missing."""
    def values(role):
        return [r[quantity] for r in rows if r["problem"] == problem
                and r["role"] == role and r["ok"] and r.get(quantity)]

    best, checks = values("reference"), values("check") + values("bound")
    if not best or not checks:
        return None
    return best[0], max(abs(v / best[0] - 1) for v in checks)


def deviation(rows: list[dict], r: dict, quantity: str):
    """Relative, with sign, from the reference of the problem; or None."""
    if not r["ok"] or r.get(quantity, "") == "":
        return None
    found = reference(rows, r["problem"], quantity)
    return r[quantity] / found[0] - 1 if found else None


def errors(rows: list[dict], runs: list[dict], quantity: str) -> list[float]:
    """Relative errors of a sequence, those below twice the uncertainty of the
    reference being lifted to that: nothing smaller can be known."""
    found = reference(rows, runs[0]["problem"], quantity)
    if not found:
        return []
    value, uncertainty = found
    return [max(abs(r[quantity] / value - 1), 2 * uncertainty) for r in runs]


def envelope(values: list[float]) -> list[float]:
    """The largest from each on: a change of sign is no accuracy."""
    return [max(values[i:]) for i in range(len(values))]


# -------------------------------------------------------------------- orders

def orders(values: list[float]) -> list[float]:
    """Between consecutive meshes, each with half the mesh size."""
    return [math.log2(a / b) for a, b in zip(values, values[1:])]


def slope(x: list[float], y: list[float]) -> float:
    """Of the line through the points, by least squares."""
    n, mx, my = len(x), sum(x) / len(x), sum(y) / len(y)
    return (sum((a - mx) * (b - my) for a, b in zip(x, y)) /
            sum((a - mx) ** 2 for a in x)) if n > 1 else math.nan


def fitted_order(runs: list[dict], column: str):
    """Over the last three meshes; None with fewer, or with an error of 0."""
    last = [r for r in runs if r.get(column)][-3:]
    if len(last) < 3:
        return None
    return -slope([r["level"] for r in last],
                  [math.log2(r[column]) for r in last])


# ------------------------------------------------------------------ decisions

def decision(rows: list[dict], problem: str, quantity: str, target: float,
             elements=None):
    """The cheapest run with an error below the target on its mesh and all finer
    ones of its sequence, of which there must be one; or None. Only of some
    elements, if they are named."""
    best = None
    for (element, _), runs in sequences(rows, problem).items():
        if elements and element not in elements:
            continue
        largest = envelope(errors(rows, runs, quantity))
        for r, e in zip(runs[:-1], largest[:-1]):
            if e <= target and (best is None or r["seconds"] < best["seconds"]):
                best = {**r, "largest_error": e}
    return best


def stick_ratio(r: dict) -> float:
    return r["stick_width"] / r["width"] if r["width"] else math.nan


# --------------------------------------------------------------------- checks

def checks(rows: list[dict], quick: bool) -> list[str]:
    """What is not as it should be."""
    complaints = []
    for (element, name), runs in sequences(rows, "rings").items():
        if name != "mortar":
            continue
        for column, expected in matrix.STABLE_ORDERS[element].items():
            found = fitted_order(runs, f"error_{column}")
            fine = found is not None and (
                abs(found - expected) <= matrix.ORDER_TOLERANCE or
                (found > expected and column in matrix.MORE_IS_FINE))
            if not fine:
                found = "unknown" if found is None else f"{found:.2f}"
                complaints.append(f"rings, {element}, mortar: the order of "
                                  f"{column} is {found}, expected {expected}")
    tolerance = (matrix.STICK_TOLERANCE_QUICK if quick
                 else matrix.STICK_TOLERANCE)
    partial_slip = [r for r in rows
                    if r["problem"] == "hertz_friction" and r["ok"]]
    finest = max((r["level"] for r in partial_slip), default=0)
    for r in partial_slip:
        if r["level"] == finest:
            expected = matrix.STICK_RATIO[int(r["increments"])]
            if not abs(stick_ratio(r) - expected) <= tolerance:
                complaints.append(
                    f"{r['id']}: {stick_ratio(r):.3f} of the contact sticks, "
                    f"expected {expected} +- {tolerance}")
    for problem, (limit, width) in matrix.PUBLISHED.items():
        found = reference(rows, problem, "dy")
        if found and abs(found[0] - limit) > width:
            complaints.append(f"{problem}: the reference {found[0]:.7f} mm is "
                              f"outside of {limit} +- {width} mm")
    return complaints
