#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Effectivity of the estimated errors of probes: estimated by true error, on
sequences of meshes refined uniformly.

The true error is against a mesh that is refined once more than those of the
table, with Richardson's extrapolation from the last three meshes; what this
extrapolation adds is its uncertainty. Errors below five times that are left
out. Columns are the meshes, the coarsest first; behind an estimate '?' where the
run prints it: the mesh before leads to another limit, or there is none.

Usage: effectivity.py CONTACT [PROBLEM...]
"""

import sys
import tempfile

from requests import solve  # the one beside this file

ELEMENTS = {
    "linear": ["Element/Degree=1", "Element/Centre node=serendipity"],
    "q8": ["Element/Degree=2", "Element/Centre node=serendipity"],
    "q9": ["Element/Degree=2", "Element/Centre node=free"],
}
# Problem: the file, the finest level with linear and with quadratic elements,
# and further entries.
PROBLEMS = {
    "ring": ("verification/nested_cylinders_plane", 5, 4,
             ["Contact/Slave=", "Contact/Master=", "Probes/Probes=u(20): "
              "displacement x, Bore_x; s(20): stress yy, Bore_x"]),
    "nested cylinders": ("verification/nested_cylinders", 5, 4, []),
    "nested cylinders, plane": ("verification/nested_cylinders_plane", 5, 4, []),
    "nested spheres": ("verification/nested_spheres", 5, 4, []),
    "SSNP154": ("nested", 5, 4, []),
    "SSNP154, friction": ("nested_friction", 5, 4, []),
    "SSNP154, large displacement": ("nested_large", 5, 4, []),
    "Hertz": ("verification/hertz", 4, 3, []),
    "punch": ("verification/punch", 3, 2, []),
    "punch, friction": ("verification/punch_friction", 3, 2, []),
}


def limit(values):
    """Richardson's, and its uncertainty."""
    first, second = values[-2] - values[-3], values[-1] - values[-2]
    ratio = second / first if first else 0
    more = second * ratio / (1 - ratio) if 0 < ratio < 0.8 else second
    return values[-1] + more, abs(more)


def main():
    ratios = []
    print("| problem | element | discretization | probe | estimated by true "
          "error |")
    print("|---|---|---|---|---|")
    for problem in sys.argv[2:] or PROBLEMS:
        file, last_linear, last_quadratic, more = PROBLEMS[problem]
        for element, entries in ELEMENTS.items():
            last = last_linear if element == "linear" else last_quadratic
            rules = ["mortar"] if problem == "ring" else ["mortar", "nodal"]
            for rule in rules:
                settings = [*entries, *more, f"Contact/Discretization={rule}"]
                with tempfile.TemporaryDirectory() as directory:
                    estimated = solve(
                        file, directory, f"Refinement/Levels={last - 1}",
                        "Probes/Errors=dual weighted residuals", *settings)
                with tempfile.TemporaryDirectory() as directory:
                    fine = solve(file, directory, f"Refinement/Levels={last}",
                                 *settings)
                for name in estimated["levels"][0]["probes"]:
                    true, uncertainty = limit(
                        [level["probes"][name] for level in fine["levels"]])
                    row = []
                    before = None
                    for level in estimated["levels"]:
                        error = true - level["probes"][name]
                        estimate = level["estimated_errors"][name]
                        now = level["probes"][name] + estimate
                        known = (before is not None and
                                 abs(now - before) <= 2 * abs(estimate))
                        before = now
                        if abs(error) < 5 * uncertainty:
                            row.append("-")
                            continue
                        ratios.append((rule, known, estimate / error))
                        row.append(f"{estimate / error:.2f}" +
                                   ("" if known else "?"))
                    print(f"| {problem} | {element} | {rule} | {name} | "
                          f"{' '.join(row)} |", flush=True)
    for rule in ("mortar", "nodal"):
        found = [ratio for of_rule, _, ratio in ratios if of_rule == rule]
        sure = [ratio for of_rule, known, ratio in ratios
                if of_rule == rule and known]
        good, surely = (sum(0.5 <= ratio <= 2 for ratio in some)
                        for some in (found, sure))
        print(f"\n{rule}: {good} of {len(found)} within [0.5, 2], "
              f"{sum(ratio < 0.3 for ratio in found)} below 0.3; without "
              f"those that the run marks by '?': {surely} of {len(sure)}, "
              f"{sum(ratio < 0.3 for ratio in sure)}.")


if __name__ == "__main__":
    main()
