#!/bin/sh
# Coulomb friction as a fixed point over Tresca problems, and by Newton's method
# with the moving bound, end in the same solution: all probes agree to 1e-8.
#   friction_loops.sh CONTACT PARAMETERS
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
parameters=$2

# values FILE: the probes of a summary, one a line
values() {
  awk -F'[:,]' '/"value"/ { print $2 }' "$1"
}

# steps FILE: Newton steps and friction iterations of all increments
steps() {
  awk -F'[:,]' '/"levels"/ { exit } # sums of the same
                /"newton_iterations"/ { n += $2 }
                /"friction_iterations"/ { f += $2 }
                END { print n " Newton steps, " f " friction iterations" }' "$1"
}

failures=0
for modeling in c d g h; do
  for geometry in "fixed point" Newton; do
    for friction in "fixed point" Newton; do
      "$contact" "$parameters/ssnp154_$modeling.prm" --quiet \
        --set "Solution/Geometry=$geometry" \
        --set "Solution/Friction=$friction" \
        --set "Output/Screen=none" --set "Output/VTU=false" \
        --set "Output/Directory=$friction"
    done
    # The two output directories are named after the friction loop.
    one="fixed point/ssnp154_$modeling/summary.json"
    two="Newton/ssnp154_$modeling/summary.json"
    values "$one" >one
    values "$two" >two
    echo "modeling $modeling, geometry by $geometry:"
    echo "  fixed point: $(steps "$one")"
    echo "  Newton:      $(steps "$two")"
    paste one two | awk '
      { d = $1 / $2 - 1; if (d < 0) d = -d; if (d > worst) worst = d; n++ }
      END {
        printf "  largest relative difference %.1e\n", worst
        exit !(n == 2 && worst <= 1e-8)
      }' || failures=$((failures + 1))
  done
done
[ $failures -eq 0 ]
