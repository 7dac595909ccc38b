#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors of probes by dual weighted residuals.

Proves that

- the estimate of each level, less what it adds for finer meshes than the next
  one (1 / (1 - 2^-q), q the order), is the change of the probe on the next
  level, which is computed without it: displacements, stresses at points,
  pressures and forces of contact, reactions, strain energies; at degrees 1 and 2, axisymmetric
  and plane, with meshes that match and that do not, at large displacement, with
  friction, and with thermal strains;
- where errors fall at their rate, the forecast of the next level's is right to a
  factor of two;
- the estimates do not change the values;
- a run on one mesh has them by default, twice what is estimated, from the
  factorization at hand; off they cost nothing, and where there are none it says why;
- reactions and forces of contact balance the loads where nodes hang, and with
  body forces on 8-node elements;
- estimates are refused where there are none.

Usage: goal_errors.py CONTACT PARAMETERS MESHES
"""

import pathlib
import sys

from block_scenes import check, failures, solve

parameters = pathlib.Path(sys.argv[2]).resolve()


def run(case, levels, *settings):
    return solve(parameters / f"{case.split(',')[0]}.prm", f"Refinement/Levels={levels}",
                 "Probes/References=", "Probes/Tolerances=", *settings)


estimate = "Probes/Errors=dual weighted residuals"

# Pressures and stresses, all of them on boundaries, are of the order p. By case:
# the degree, the levels, and how far the estimated change may be from
# the one that comes about. Where the solution is smooth it is close; where the
# contact area ends elsewhere on the next mesh, as in SSNP154, it is less so.
cases = {
    "verification/nested_cylinders": (1, 2, 0.03),
    "verification/nested_cylinders_quadratic": (2, 2, 0.06),
    "verification/nested_cylinders_plane_quadratic": (2, 2, 0.21),
    "verification/nested_spheres_quadratic": (2, 2, 0.08),
    "verification/nested_cylinders_plane":
        (2, 2, 0.06, "Element/Degree=2",
         "Probes/Probes=inner: strain energy, Inner; "
         "both: strain energy, Outer, Inner"),
    "verification/sphere_on_plane":
        (1, 2, 0.05, "Element/Degree=1", "Element/Centre node=serendipity",
         "Probes/Probes=force: contact force y, Surface; "
         "reaction: reaction y, Top"),
    "verification/nested_cylinders, hot":
        (1, 2, 0.03, "Solids/Thermal strain=Inner: 0.005*t"),
    "verification/nested_cylinders_plane, hot":
        (2, 2, 0.09, "Element/Degree=2", "Solids/Thermal strain=Inner: 0.005*t",
         "Probes/Probes=inner: strain energy, Inner; "
         "both: strain energy, Outer, Inner"),
    "nested_large, hot":
        (2, 1, 0.2, "Solids/Thermal strain=Cylinder: 0.002*t; Block: 0.001*t"),
    "nested": (2, 3, 0.15),
    "nested_large": (2, 1, 0.2),
    "nested_friction": (2, 2, 0.22),
}
# Those whose errors fall at their rate from the first mesh on.
asymptotic = ["verification/nested_cylinders",
              "verification/nested_cylinders_quadratic",
              "verification/nested_spheres_quadratic"]
for case, (degree, n_levels, tolerance, *more) in cases.items():
    status, said, summary = run(case, n_levels, estimate, *more)
    _, _, without = run(case, n_levels, *more)
    check(f"{case}: runs", status in (0, 1), said)
    levels = summary["levels"]
    if "force" in levels[0]["probes"]:
        check("contact carries what the supports do",
              all(abs(level["probes"]["force"] / level["probes"]["reaction"] + 1)
                  < 1e-8 for level in levels))
    for name in levels[0]["probes"]:
        values = [level["probes"][name] for level in levels]
        check(f"{name} is unchanged", values ==
              [level["probes"][name] for level in without["levels"]])
        for level, after in zip(levels[1:], levels[2:]):
            ratio = (level["forecast"]["errors"][name] /
                     abs(after["estimated_errors"][name]))
            check("  forecast of the error", case not in asymptotic or
                  0.5 < ratio < 2, f"{ratio:g}")
        for level, value, after in zip(levels, values, values[1:]):
            order = degree if name[0] in "pS" else 2 * degree
            estimated = (1 - 2**-order) * level["estimated_errors"][name]
            check("  changes as estimated",
                  abs(estimated / (after - value) - 1) < tolerance,
                  f"{estimated:g} {after - value:g}")
    for probe in summary["probes"]:
        check("  the mesh before confirms it, or a mark says that it does not",
              probe["error_is_confirmed"] != (
                  f">{probe['estimated_error']:.1e}" in said))
        check("  says how, and no less than a request believes",
              probe["estimator"] == "dual weighted residuals" and
              probe["estimated_error"] >= 2 * (1 - 1e-12) *
              abs(levels[-1]["estimated_errors"][probe["name"]]))

status, said, summary = run(
    "nested", 3, "Refinement/Strategy=adaptive",
    "Element/Centre node=serendipity", "Boundary conditions/Body force y=Block: -1",
    "Probes/Probes=base: reaction y, Encast; slave: contact force y, Bottom_C; "
    "master: contact force y, Top_B")
values = summary["levels"][-1]["probes"]
load, weight = 17500, 20000
check("loads are balanced", status == 0 and all(
    abs(values[name] / force - 1) < 1e-6 for name, force in
    {"base": load + weight, "slave": load, "master": -load}.items()),
    f"{values}")

for case, kept in (("nested_large", True), ("nested_friction", True),
                   ("nested_tied", False)):
    settings = ("Solution/Increments=1",)
    status, said, summary = run(case, 0, "Probes/Errors=automatic", *settings)
    _, quiet, without = run(case, 0, *settings)
    check(f"{case}, one mesh: runs", status == 0, said)
    for probe, plain in zip(summary["probes"], without["probes"]):
        level = summary["levels"][0]["estimated_errors"][probe["name"]]
        check(f"{probe['name']} has an error, twice what is estimated",
              probe["estimated_error"] == 2 * abs(level) > 0 and
              not probe["error_is_confirmed"] and
              f"{probe['estimated_error']:.1e}" in said and
              "dual weighted residuals on this mesh alone" in said, said)
        check("  is unchanged", probe["value"] == plain["value"] and
              plain["estimated_error"] is None and "error est." not in quiet)
    more = {name: number - without["counters"][name]
            for name, number in summary["counters"].items()
            if number != without["counters"][name]}
    check("  takes a solve for each probe and the factorization at hand, if it serves",
          more["linear_solves"] == len(summary["probes"]) and
          ("symbolic_factorizations" in more) != kept, f"{more}")

status, said, summary = run("nested", 0, "Probes/Errors=automatic",
                            "Contact/Discretization=Gauss")
check("Gauss points: no errors, and why", status == 0 and "error est.: not estimated: "
      "There are no dual problems" in said and all(
          probe["estimated_error"] is None and probe["not_estimated"]
          for probe in summary["probes"]), said)

status, said, _ = run("nested", 0, estimate, "Contact/Discretization=Gauss")
check("Gauss points: refused", status == 2 and "dual problems" in said, said)
status, said, _ = run("nested", 0, estimate, "Boundary conditions/Rigid=Encast: E",
                      "Probes/Probes=r: rotation z, Encast")
check("rotations: refused", status == 2 and "no dual problem for the rotation"
      in said, said)
sys.exit(len(failures) > 0)
