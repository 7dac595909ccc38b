#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of public reports and of first use that were answered wrongly, from
outside of this repository: skipped where they are not there.

Proves that volumes that no group names have the remedy for it; that a group of a
curve inside of a body is a note, and an error where an entry names it; that values
that no body has are null; that forces of rings are in N, and those on the nodes of
the slave add up to the normal force; and that a deck of Abaqus' CPE4 is read, with
the forces of its supports as probes.

Usage: reports.py CONTACT
"""

import csv
import os
import pathlib
import re
import subprocess
import sys

from abaqus_scenes import CONVERTER
from block_scenes import check, failures, solve

folder = pathlib.Path(os.environ.get("SCENES_DIRECTORY") or pathlib.Path(
    os.environ.get("REFERENCE_DIRECTORY", "reference")).parent / "scenes") / "reports"
if not folder.is_dir():
    print(f"skipped: no scenes in {folder}")
    sys.exit(0)


def report(scene, *settings):
    """Of the case of a folder, whose mesh is beside it."""
    file = next((folder / scene).glob("*.prm")).resolve()
    return solve(file, "Output/VTU=false", "Output/Profile=true",
                 "Output/Nodes=true", *settings)


status, said, _ = report("no_volume_group")
check("volumes without a group: the remedy", status == 2 and
      "Physical Volume(" in said, said)

status, said, summary = report("unused_groups")
check("an unused curve is a note", status == 0 and
      "note: the curve 'inner' has lines that are no edges" in said, said)
status, said, _ = report("unused_groups",
                         "Boundary conditions/Displacement x=yOz: 0, inner: 0")
check("and an error where it is used", status == 2 and
      "error:  the curve 'inner' has lines that are no edges" in said, said)

status, said, summary = report("von_mises_zero")
check("no yield stress, no stress", status == 0 and all(
    body[value] is None for body in summary["bodies"].values() for value in (
        "von_mises", "contact_share_above_yield")), summary.get("bodies"))

status, said, summary = report("units_axisymmetric")
with open("output/fit/profile.csv", encoding="utf-8") as lines:
    rows = list(csv.DictReader(lines))
total = sum(float(row.get("nodal_force_N", "nan")) for row in rows
            if row["surface"] == "slave")
check("forces of rings are in N", status == 0 and
      abs(total / summary["contact"]["normal_force"] - 1) < 1e-6 and
      "N/mm" not in pathlib.Path("output/fit/history.csv").read_text() and
      pathlib.Path("output/fit/nodes.csv").read_text().splitlines()[0].endswith(
          "contact_force_x_N,contact_force_y_N"), total)

done = subprocess.run([sys.executable, CONVERTER, folder / "abaqus_cpe4/abq.inp",
                       "abq.msh"], text=True, capture_output=True)
case = pathlib.Path("abq.prm").read_text()
check("CPE4 is read", done.returncode == 0 and
      "bodies: Block (1), Foundation (1)" in done.stdout and
      re.search("set Probes = .*support y, Base", case), done.stdout + done.stderr)
print(len(failures), "failures")
sys.exit(bool(failures))
