#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saddle point systems of many unknowns, factorized body by body.

Proves that

- CHOLMOD for the bodies with LAPACK for the contact, which is the choice beyond
  30000 unknowns, leads to the values that UMFPACK leads to, in as many Newton
  steps: pressures in Gauss points in large displacement, friction whose bound
  and whose geometry are in the tangent, and the loops of the benchmark;
- it analyses the bodies once though the pairing changes, and in small strain it
  factorizes them once though the statuses change;
- below 30000 unknowns the choice is UMFPACK, to the last bit.

Usage: large_saddle_point.py CONTACT PARAMETERS MESHES
"""

import pathlib
import sys

from block_scenes import check, failures, solve

PARAMETERS = pathlib.Path(sys.argv[2])
NEWTON = ("Contact/Discretization=mortar", "Contact/Friction coefficient=0.1",
          "Solution/Geometry=Newton", "Solution/Friction=Newton")


def solved(case, *settings):
    """Values, Newton steps and counters of a case without files."""
    status, said, summary = solve(
        PARAMETERS / f"{case}.prm", "Solution/System=saddle point",
        "Output/VTU=false", "Probes/References=", "Probes/Tolerances=", *settings)
    check(f"{case}: converged", status == 0, said[-600:])
    return ([p["value"] for p in summary["probes"]],
            [i["newton_iterations"] for i in summary["increments"]],
            summary["counters"])


def both(what, case, *settings):
    """By UMFPACK, and by choice. Returns the counters."""
    reference, steps, of_umfpack = solved(
        case, "Solution/Linear solver=UMFPACK", *settings)
    values, by_choice, counters = solved(case, *settings)
    check(f"{what}: the same values",
          all(abs(a - b) < 1e-9 * abs(b) for a, b in zip(values, reference)),
          (values, reference))
    check(f"{what}: as many Newton steps", by_choice == steps, (by_choice, steps))
    return of_umfpack, counters, values == reference


FINE = ("Mesh/Refinements=1", "Solution/Increments=1")
old, new, _ = both("large displacement", "ssnp154_b", *FINE)
check("one analysis", new["symbolic_factorizations"] == 1, new)
both("friction", "ssnp154_b", *NEWTON, *FINE)
old, new, _ = both("small strain", "ssnp154_b",
                   "Solids/Kinematics=small strain", *FINE)
check("the bodies are factorized once",
      new["numeric_factorizations"] == 1 < old["numeric_factorizations"],
      (old, new))
check("small: the same bits", both("small", "ssnp154_b",
                                   "Solution/Increments=1")[2])
sys.exit(bool(failures))
