#!/bin/sh
# The cases that the front page and the one of parameters show how to write run as
# they are printed there.
#   readme_case.sh CONTACT PARAMETERS
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)

# block PAGE LANGUAGE: the lines between ```LANGUAGE and ```
block() {
  awk -v fence='```' -v from="\`\`\`$2" '
    $0 == from { inside = 1; next }
    $0 == fence { inside = 0 }
    inside' "$root/$1"
}

command -v gmsh >/dev/null || {
  echo "skipped: no gmsh"
  exit 0
}
block README.md geo >mine.geo
block README.md prm >mine.prm
[ -s mine.geo ] && [ -s mine.prm ]
"$1" mine.prm
[ -s output/mine/bodies.pvd ]
grep -q '"stick": [1-9]' output/mine/summary.json
grep -q '"slip": [1-9]' output/mine/summary.json

# In 3-D.
block parameters/README.md geo >drag.geo
block parameters/README.md prm >drag.prm
[ -s drag.geo ] && [ -s drag.prm ]
"$1" drag.prm
[ -s output/drag/contact.pvd ]
grep -q '"stick": [1-9]' output/drag/summary.json
grep -q '"slip": [1-9]' output/drag/summary.json

# The same with 27 and with 20 nodes in the mesh file, and in either format.
"$1" drag.prm --set Solution/Increments=1 | grep '^drag' >of_8
gmsh -3 -order 2 -format msh41 -o drag.msh drag.geo >gmsh.log
"$1" drag.prm --set Mesh/File=drag.msh --set Solution/Increments=1 | grep '^drag' >of_27
gmsh -3 -order 2 -setnumber Mesh.SecondOrderIncomplete 1 -format msh22 \
  -o drag.msh drag.geo >gmsh.log
grep -q '^[0-9]* 17 ' drag.msh
"$1" drag.prm --set Mesh/File=drag.msh --set Solution/Increments=1 | grep '^drag' >of_20
[ "$(wc -l <of_8)" -eq 3 ]
cmp of_8 of_27
cmp of_8 of_20

# A circle that is no arc is noted; one that is, is not.
"$1" "$2/ssnp154_b.prm" --set Output/VTU=false >with_arc 2>&1
"$1" "$2/ssnp154_b.prm" --set Output/VTU=false --set Mesh/Arcs= \
  --set Probes/References= --set Probes/Tolerances= >without 2>&1
grep -q "note: 'Bottom_C' bends by up to" without
! grep -q 'note: .*is no arc' with_arc
