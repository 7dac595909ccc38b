#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that ask for an accuracy, their true errors and their price, beside the
cheapest of uniform meshes and of meshes refined by the energy estimate that
happen to be as accurate.

The true error is against the limit of uniform meshes, with the estimated error
of the finest one added, which is accurate to the figure behind +-: the change of
that sum from the mesh before. Times are wall times of all levels together, of
one run each, in seconds.

Usage: requests.py CONTACT [CASE...]
"""

import json
import pathlib
import subprocess
import sys
import tempfile

contact = pathlib.Path(sys.argv[1]).resolve()
parameters = pathlib.Path(__file__).resolve().parents[2] / "parameters"

# Case: the probes, the requests [%], and the levels of the uniform meshes.
cases = {
    "nested": (["DY(B)", "SIYY(B)"], [1, 0.1, 0.01], 4),
    "nested_friction": (["DY(B)", "SIYY(B)"], [1, 0.1, 0.01], 3),
    "nested_large": (["DY(B)", "SIYY(B)"], [1, 0.1, 0.01], 3),
    "verification/nested_cylinders_plane_quadratic":
        (["u(20)", "u(50)", "p(50)"], [1, 0.1, 0.01], 4),
    "verification/nested_spheres_quadratic":
        (["u(20)", "p(50)"], [1, 0.1, 0.01], 4),
    "verification/sphere_on_plane": (["p(0.4)"], [1, 0.1, 0.01], 2),
    "verification/hertz": (["approach"], [1, 0.1, 0.01], 4),
    "verification/punch_friction_quadratic":
        (["u_y(centre)"], [1, 0.1, 0.01], 2),
}


def solve(case, directory, *settings):
    command = [str(contact), str(parameters / f"{case}.prm"), "--quiet"]
    for setting in (f"Output/Directory={directory}", "Output/VTU=false",
                    "Output/Profile=false", "Probes/References=",
                    "Probes/Tolerances=", *settings):
        command += ["--set", setting]
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    name = pathlib.Path(case).name
    if ended.returncode not in (0, 1):
        sys.exit(f"{case}: {ended.stderr}")
    return json.loads((pathlib.Path(directory) / name / "summary.json")
                      .read_text())


def seconds(levels):
    return sum(phase["wall"] for level in levels
               for phase in level["time"].values())


def cheapest(levels, probe, limit, error):
    """Unknowns and seconds of the first level that is accurate, and stays so."""
    ok = [abs(level["probes"][probe] / limit - 1) <= error for level in levels]
    for k in range(len(levels)):
        if all(ok[k:]):
            return (f"{levels[k]['displacements']}", seconds(levels[:k + 1]))
    return "-", None


def main():
    print("| case | probe | asked | true | unknowns | s | uniform: unknowns | s |"
          " energy: unknowns | s |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as directory:
        for case in sys.argv[2:] or cases:
            probes, requests, n_levels = cases[case]
            fine = solve(case, directory, f"Refinement/Levels={n_levels}",
                         "Probes/Errors=dual weighted residuals")["levels"]
            uniform = solve(case, directory,
                            f"Refinement/Levels={n_levels}")["levels"]
            energy = solve(case, directory, f"Refinement/Levels={3 * n_levels}",
                           "Refinement/Strategy=adaptive")["levels"]
            for probe in probes:
                last, limit = (level["probes"][probe] +
                               level["estimated_errors"][probe]
                               for level in fine[-2:])
                known = 100 * abs(limit / last - 1)
                for percent in requests:
                    run = solve(case, directory, "Refinement/Levels=0",
                                f"Probes/Accuracy={probe}: {percent} %")
                    levels = run["levels"]
                    true = 100 * abs(levels[-1]["probes"][probe] / limit - 1)
                    line = [case.split("/")[-1], probe, f"{percent:g} %",
                            f"{true:.2g} % +-{known:.1g}" +
                            (", not reached" if run["accuracy_missed"] else ""),
                            str(levels[-1]["displacements"]),
                            f"{seconds(levels):.2f}"]
                    for others in (uniform, energy):
                        unknowns, time = cheapest(others, probe, limit,
                                                  percent / 100)
                        line += [unknowns, "-" if time is None else f"{time:.2f}"]
                    print("| " + " | ".join(line) + " |", flush=True)


if __name__ == "__main__":
    main()
