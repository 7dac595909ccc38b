#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples of parameters/examples.

Proves that each converges at its own settings, no increment cut, in at most 8
Newton steps an increment, and does what its first lines say: the hub stays wider,
with a stress of compression in its bore; the seal is pressed to the wall by less
than the fluid's force; the snap hook is pushed, then drawn in, and is free behind
the lip; the roller leaves plastic strains and rests on nothing at the end. The lug,
of its CAD file, is run with the commands of the pages.

Usage: examples.py CONTACT PARAMETERS MESHES
"""

import pathlib
import sys

from block_scenes import check, failures, solve

EXAMPLES = pathlib.Path(sys.argv[2]) / "examples"


def course(name, *settings):
    """The probes of the increments, by name of the probe; of stresses that of
    the last one."""
    status, said, summary = solve(EXAMPLES / f"{name}.prm", "Output/VTU=false",
                                  *settings)
    increments = summary.get("increments", [])
    steps = max((i["newton_iterations"] for i in increments), default=99)
    factors = [i["load_factor"] for i in increments]
    even = [(k + 1) / len(factors) for k in range(len(factors))]
    check(f"{name} converges", status == 0 and steps <= 8 and
          all(abs(a - b) < 1e-12 for a, b in zip(factors, even)),
          f"{steps} {said[:300]}")
    found = {p["name"]: [p["value"]] for p in summary.get("probes", [])}
    found.update({p: [i["probes"][p] for i in increments]
                  for p in (increments[0]["probes"] if increments else {})})
    return found


def main():
    fit = course("press_fit")
    check("a part of the interference stays", fit and
          0 < fit["bore"][-1] < 0.06 and fit["hoop"][-1] < -50 and
          fit["bore"][5] > fit["bore"][-1], str(fit))
    seal = course("seal")
    # 1 MPa on at most the height of 4 mm.
    check("the wall carries a part of the fluid's force", seal and
          -4 < seal["wall"][-1] < -0.5 and abs(seal["wall"][9]) < 0.5 and
          abs(seal["lid"][9]) > 1, str(seal))
    hook = course("snap_hook")
    check("the hook is pushed, drawn in and free", hook and
          max(hook["push"]) > 0.1 and min(hook["push"]) < -0.05 and
          abs(hook["push"][-1]) < 1e-9 and abs(hook["lift"][-1]) < 1e-9 and
          min(hook["lift"]) < -0.9, str(hook))
    # A way of 2 mm is enough.
    roller = course(
        "roller", "Solution/Increments=16",
        "Contact/Obstacle motion=y: table(0 0, 0.25 -0.024, 0.9 -0.024, 1 0.05);"
        " x: 1.6*max(0, t - 0.25); angle: -1.83346*max(0, t - 0.25)")
    check("the roller presses, and leaves", roller and
          min(roller["press"]) < -100 and abs(roller["press"][-1]) < 1e-9,
          str(roller))


main()
sys.exit(len(failures) > 0)
