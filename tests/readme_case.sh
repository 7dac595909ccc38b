#!/bin/sh
# The case that README shows how to write runs as it is printed there.
#   readme_case.sh CONTACT PARAMETERS
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

readme=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)/README.md

# block LANGUAGE: the lines between ```LANGUAGE and ```
block() {
  awk -v fence='```' -v from="\`\`\`$1" '
    $0 == from { inside = 1; next }
    $0 == fence { inside = 0 }
    inside' "$readme"
}

command -v gmsh >/dev/null || {
  echo "skipped: no gmsh"
  exit 0
}
block geo >mine.geo
block prm >mine.prm
[ -s mine.geo ] && [ -s mine.prm ]
gmsh -2 -format msh41 -o mine.msh mine.geo >gmsh.log
"$1" mine.prm
[ -s output/mine/bodies.pvd ]
grep -q '"stick": [1-9]' output/mine/summary.json
grep -q '"slip": [1-9]' output/mine/summary.json

# A circle that is no arc is noted; one that is, is not.
"$1" "$2/ssnp154_b.prm" --set Output/VTU=false >with_arc
"$1" "$2/ssnp154_b.prm" --set Output/VTU=false --set Mesh/Arcs= \
  --set Probes/References= --set Probes/Tolerances= >without
grep -q "^Note: 'Bottom_C' bends by up to" without
! grep -q '^Note' with_arc
