#!/bin/sh
# Newton's method for geometry, friction and displacement together needs at
# most 8 steps per increment from a cold start, in all modelings.
#   newton_steps.sh CONTACT PARAMETERS
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
parameters=$2
for modeling in a b c d e f g h; do
  "$contact" "$parameters/ssnp154_$modeling.prm" --quiet \
    --set Solution/Geometry=Newton --set Solution/Friction=Newton \
    --set Output/Screen=none --set Output/VTU=false || [ $? -eq 1 ]
  awk -F'[:,]' -v modeling=$modeling '
    /"levels"/ { exit } # sums of the same
    /^  "converged": true/ { converged = 1 }
    /"newton_iterations"/ { steps = steps " " $2; n++; bad = bad || $2 > 8 }
    END { print modeling ": Newton steps" steps
          exit !(converged && n == 2 && !bad) }' \
    "output/ssnp154_$modeling/summary.json"
done

# In 3-D the bound of friction is in the tangent, the pairing is renewed before
# each step, and its stiffness is in the tangent; the active set is searched within
# a step. Multigrid serves the unsymmetric matrix with points that begin to slip
# (in the second increment of the sphere), whose shears turn as if a spring held
# them.
# in_space FILE LINEAR_SOLVER
in_space() {
  name=$(basename "$1" .prm)
  "$contact" "$parameters/$1" --quiet --set Element/Degree=1 \
    --set "Solution/Linear solver=$2" --set Output/Screen=none || [ $? -eq 1 ]
  awk -F'[:,]' -v name="$name" '
    /"levels"/ { in_levels = 1 } # sums of the same
    /^  "converged": true/ { converged = 1 }
    /"newton_iterations"/ && !in_levels { steps = steps " " $2; bad = bad || $2 > 8 }
    /"linear_iterations"/ && !in_levels { iterations += $2 }
    /"linear_solves"/ { solves = $2 }
    END { print name ": Newton steps" steps ", " iterations " iterations in " \
                solves " linear solves"
          exit !(converged && steps && iterations <= 40 * solves) || bad }' \
    "output/$name/summary.json"
}
in_space sphere_on_block.prm AMG
in_space verification/3d/square_punch.prm CHOLMOD
in_space verification/3d/punch_friction.prm AMG
