#!/bin/sh
# A run that does not converge ends with exit status 3, says which loop has not
# and by how much, in the table and in the summary, and prints no value: the three
# loops, each with a single turn and no shorter increments to go on with.
#   not_converged.sh CONTACT PARAMETERS
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
parameters=$2
summary=output/ssnp154_d/summary.json
failures=0

# expect REASON LIMIT: modeling D where LIMIT is 1
expect() {
  status=0
  "$contact" "$parameters/ssnp154_d.prm" --quiet --set "Solution/$2=1" \
    --set "Solution/Max cut-backs=0" --set Output/VTU=false \
    >out 2>err || status=$?
  if [ "$status" -ne 3 ]; then
    echo "FAILED: exit status $status instead of 3 with $2 = 1"
  elif ! grep -q "^ssnp154_d: .*$1" out ||
    ! grep -q "\"message\": .*$1" "$summary"; then
    echo "FAILED: no '$1' with $2 = 1"
    cat out err
  elif ! grep -q '^  "converged": false' "$summary" ||
    grep -q '"value"' "$summary" || ! grep -q '| NO' out; then
    echo "FAILED: a result with $2 = 1"
    cat out
  else
    grep "^ssnp154_d: " out
    return 0
  fi
  failures=$((failures + 1))
}

expect "the geometry loop ends" "Max geometry iterations"
expect "the friction loop ends" "Max friction iterations"
expect "Newton's method ends" "Max Newton iterations"
[ $failures -eq 0 ]
