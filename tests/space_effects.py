#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Effects by runs in 3-D.

Proves that

- on three nested meshes each effect is what runs of their own on the last mesh
  find, as closely as it says, and no verdict at 1 % or 0.1 % of a probe is
  wrong; on one mesh it is that to the tolerances;
- the estimates do not change the values, and leave no files;
- friction in several increments has the history of the variant;
- a variant that nothing holds says so;
- adaptive meshes, which differ from variant to variant, are refused.

Usage: space_effects.py CONTACT PARAMETERS MESHES
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent / "effects"))
from block_scenes import check, contact, failures, run  # noqa: E402
from estimates import compare, solve  # noqa: E402

ESTIMATE = "Solution/Estimate effects=true"


def agrees(scene, n_effects):
    base, why = solve(contact, scene, ESTIMATE)
    check(f"{scene}: runs", base is not None, why)
    without, _ = solve(contact, scene)
    check("  same values but for the start from levels", all(
        abs(a["value"] - b["value"]) <= 1e-7 * abs(b["value"])
        for a, b in zip(base["probes"], without["probes"])))
    n = 0
    for row in compare(contact, scene, base):
        effect = row.effect["effect"]
        if row.estimated is None:
            check(f"  {effect}: not told, for no run tells it",
                  row.true is None, row.effect["unknown"])
            continue
        n += 1
        for accuracy in (0.01, 0.001):
            check(f"  {effect}: the verdict on {row.probe} is not wrong",
                  row.verdict_is_right(accuracy) is not False,
                  f"{row.estimated:g}, {row.true}")
        uncertain = abs(row.effect["uncertainties"][row.probe])
        check("  its change", row.true is not None and
              abs(row.estimated - row.true) <= uncertain,
              f"{row.estimated:g} +- {uncertain:g}, {row.true}")
    check("  all effects", n >= n_effects, n)


agrees("nested_space --set Refinement/Levels=2", 15)
agrees("nested_space_friction --set Refinement/Levels=0", 15)

CAP = {"Mesh/File": pathlib.Path(sys.argv[3]).resolve() / "cap_on_block.msh",
       "Mesh/Spheres": "Bottom: 0, 0, 20, 20", "Element/Degree": 1,
       "Solids/Young's modulus": "Foundation: 70000, Sphere: 210000",
       "Solids/Poisson's ratio": "Foundation: 0.3, Sphere: 0.3",
       "Boundary conditions/Displacement x": "Plane_x: 0",
       "Boundary conditions/Displacement y": "Plane_y: 0",
       "Boundary conditions/Displacement z": "Base: 0, Head: -0.2",
       "Contact/Slave": "Bottom", "Contact/Master": "Top",
       "Solution/Estimate effects": "true",
       "Probes/Probes": "F: reaction z, Base"}
status, said, _ = run("files", CAP)
check("a scene of one mesh", status == 0, said)
check("its variants leave no files",
      not list(pathlib.Path("output/files").glob("effects*")))
status, said, _ = run("adaptive", {**CAP, "Refinement/Levels": 1,
                                   "Refinement/Strategy": "adaptive"})
check("adaptive meshes are refused", status == 2 and "same meshes" in said,
      (status, said))
sys.exit(bool(failures))
