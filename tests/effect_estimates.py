#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Effects by estimate.

Proves that

- the estimated change of each probe by each effect is, to a fifth, what a run
  with the entries of the variant finds (quadratic elements: to a factor of two),
  and no verdict at 1 % or 0.1 % of the probe is wrong;
- the estimates do not change the values, and there are none where they are off;
- what the loops leave is what a run with sharper tolerances finds;
- several processes are refused.

Usage: effect_estimates.py CONTACT PARAMETERS MESHES
"""

import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent / "effects"))
from block_scenes import check, contact, failures  # noqa: E402
from estimates import compare, solve  # noqa: E402

ESTIMATE = "Solution/Estimate effects=true"

for scene in ("ssnp154_a", "verification/nested_cylinders",
              "verification/punch"):
    base, why = solve(contact, scene, ESTIMATE)
    check(f"{scene}: runs", base is not None, why)
    without, _ = solve(contact, scene)
    check("  same values", [p["value"] for p in base["probes"]] ==
          [p["value"] for p in without["probes"]])
    check("  nothing where it is off", "estimated_effects" not in without)
    n = 0
    for row in compare(contact, scene, base):
        effect = row.effect["effect"]
        for accuracy in (0.01, 0.001):
            check(f"  {effect}: the verdict on {row.probe} is not wrong",
                  row.verdict_is_right(accuracy) is not False)
        if (row.true is None or row.estimated is None or
                abs(row.true) <= 1e-3 * abs(row.value)):
            continue
        n += 1
        low, high = (0.5, 2) if effect == "quadratic elements" else (0.8, 1.25)
        check("  its change", low < row.estimated / row.true < high,
              f"{row.estimated:g} {row.true:g}")
    check("  there are some", n >= 6, str(n))

# A friction loop that ends early, and a geometry loop, against Newton's method;
# in one increment, for what is left in one has consequences in the next.
early = ("Solution/Friction=fixed point", "Solution/Friction tolerance=1e-2",
         "Solution/Geometry=fixed point", "Solution/Geometry tolerance=1e-2",
         "Contact/Discretization=mortar", "Solution/Increments=1")
exact = ("Solution/Friction=Newton", "Solution/Geometry=Newton",
         "Contact/Discretization=mortar", "Solution/Increments=1")
loops, why = solve(contact, "ssnp154_c", *early, ESTIMATE,
                   "Probes/Dual weighted residuals=true")
newton, _ = solve(contact, "ssnp154_c", *exact)
for probe, sharp in zip(loops["probes"], newton["probes"]):
    left = sharp["value"] - probe["value"]
    by_loop = loops["levels"][-1]["loop_errors"][probe["name"]]
    check(f"loops leave of {probe['name']}",
          0.5 < sum(by_loop.values()) / left < 2 and
          0.5 < probe["loop_error"] / abs(left) < 2,
          f"{left:g} {probe['loop_error']:g} {by_loop}")

refused = subprocess.run(
    ["mpirun", "-np", "2", str(contact), f"{sys.argv[2]}/nested.prm", "--quiet",
     "--set", ESTIMATE], capture_output=True, text=True, check=False)
check("two processes: refused", refused.returncode == 2 and
      "Effects are estimated" in refused.stderr, refused.stderr)
sys.exit(len(failures) > 0)
