#!/bin/sh
# A run that does not converge ends with exit status 3, says which loop has not
# and by how much, in the table and in the summary, and prints no value: the three
# loops, each with a single turn and no shorter increments to go on with; and a body
# that turns inside out.
#   not_converged.sh CONTACT PARAMETERS MESHES
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
case=$2/ssnp154_d.prm
failures=0

# expect REASON LIMIT: of the case, where LIMIT is 1
expect() {
  name=$(basename "$case" .prm)
  summary=output/$name/summary.json
  status=0
  "$contact" "$case" --quiet --set "Solution/$2=1" \
    --set "Solution/Max cut-backs=0" --set Output/VTU=false \
    >out 2>err || status=$?
  if [ "$status" -ne 3 ]; then
    echo "FAILED: exit status $status instead of 3 with $2 = 1"
  elif ! grep -q "^$name: .*$1" out ||
    ! grep -q "\"message\": .*$1" "$summary"; then
    echo "FAILED: no '$1' with $2 = 1"
    cat out err
  elif ! grep -q '^  "converged": false' "$summary" ||
    grep -q '"value"' "$summary" || ! grep -q '| NO' out; then
    echo "FAILED: a result with $2 = 1"
    cat out
  else
    grep "^$name: " out
    return 0
  fi
  failures=$((failures + 1))
}

expect "the geometry loop ends" "Max geometry iterations"
expect "the friction loop ends" "Max friction iterations"
expect "Newton's method ends" "Max Newton iterations"

# Supports that press the body through itself: half a step is no solution.
case=through.prm
cat >$case <<PRM
subsection Mesh
  set File = $3/bar.msh
end
subsection Solids
  set Young's modulus = Bar: 1000
  set Poisson's ratio = Bar: 0.3
end
subsection Boundary conditions
  set Displacement x = Bottom: 0, Top: 0
  set Displacement y = Bottom: 0, Top: -101
end
subsection Solution
  set System = saddle point
end
subsection Probes
  set Probes = top: displacement y, Top_right
end
PRM
expect "turns inside out" Increments
[ $failures -eq 0 ]
