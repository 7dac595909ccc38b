#!/bin/sh
# 'Errors = next mesh' says of each probe twice its difference from the mesh refined
# once, which a run on that mesh tells independently; the values stay those of
# the first mesh, and the table has a column for the estimates.
#   estimate_errors.sh CONTACT PARAMETERS
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
case=$2/ssnp154_c.prm

# run DIRECTORY OPTION...: modeling C; its references are those of its own mesh
run() {
  directory=$1
  shift
  "$contact" "$case" --quiet --set "Output/Directory=$directory" \
    --set Output/VTU=false --set Probes/References= --set Probes/Tolerances= "$@"
}

run coarse
run fine --set Mesh/Refinements=1
run both --set "Probes/Errors=next mesh" >table
cat table
grep -q 'error est. | reference' table

python3 - <<'PYTHON'
import json
coarse, fine, both = (
    {p["name"]: p for p in json.load(open(f"{name}/ssnp154_c/summary.json"))["probes"]}
    for name in ("coarse", "fine", "both"))
for name, probe in both.items():
    assert coarse[name]["estimated_error"] is None, name
    assert probe["value"] == coarse[name]["value"], name
    difference = 2 * abs(coarse[name]["value"] - fine[name]["value"])
    assert difference > 0, name
    assert abs(probe["estimated_error"] / difference - 1) < 1e-6, name
PYTHON
