#!/bin/sh
# A run that does not converge ends with exit status 3, says which loop has not
# and by how much, in the table and in the summary, and prints no value: Newton's
# method with a single step and no shorter increments to go on with; and a body
# that turns inside out. With friction by a fixed point, a pin that
# rolls in its hole, where none exists, hands over to Newton's method, which ends in the same
# solution; as does the condensed system. A Gauss point that jumps over a vertex of the master for good
# stays on its edge, and a note says so.
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

expect "Newton's method ends" "Max Newton iterations"

# probes NAME: their values
probes() {
  awk -F'[:,]' '/"value"/ { print $2 }' "output/$1/summary.json"
}

# hands_over REASON CASE DISCRETIZATION ENTRY=VALUE...: to Newton's method, whose probes are
# those of the case by default, within 1e-8
hands_over() {
  reason=$1
  case=$2
  discretization=$3
  shift 3
  name=$(basename "$case" .prm)
  "$contact" "$case" --quiet --set "Contact/Discretization=$discretization" \
    --set "Solution/Friction=Newton" --set "Solution/Geometry=automatic" \
    --set Output/VTU=false >out 2>err
  probes "$name" >one
  set -- "$@" "Contact/Discretization=$discretization"
  for entry; do
    set -- "$@" --set "$entry"
    shift
  done
  status=0
  "$contact" "$case" --quiet "$@" --set Output/VTU=false >out 2>err || status=$?
  probes "$name" >two
  if [ "$status" -ne 0 ] || ! grep -q "^$name: .*$reason" err ||
    ! grep -q "^Once more from the start, with Friction = Newton" err ||
    ! paste one two | awk '
      { d = $1 - $2; if (d < 0) d = -d; s = $1 < 0 ? -$1 : $1
        if (s > size) size = s; if (d > worst) worst = d; n++ }
      END { print "  largest relative difference " worst / size
            exit !(n == 2 && worst <= 1e-8 * size) }'; then
    echo "FAILED: $name with $* ends with $status"
    cat out err one two
    failures=$((failures + 1))
  else
    echo "$name: $reason, Newton's method takes over"
  fi
}

hands_over "no solution" "$2/hard/pin_play.prm" nodal \
  "Solution/Friction=fixed point"
hands_over "no solution" "$2/hard/pin_play.prm" mortar \
  "Solution/System=condensed"

if "$contact" "$2/hard/penetration_edge.prm" --quiet --set Output/VTU=false \
  --set "Contact/Discretization=Gauss" --set "Mesh/Move=Upper: 0, -3.5" \
  >out 2>err &&
  grep -q "closest points jump between two places" err; then
  echo "penetration_edge: a Gauss point stays on its edge"
else
  echo "FAILED: penetration_edge with Gauss points"
  cat out err
  failures=$((failures + 1))
fi

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
