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

# In space the bound of friction is in the tangent, the pairing is renewed before
# each step, and its stiffness is in the tangent. Multigrid serves the unsymmetric matrix with points that begin to slip
# (in the second increment), whose shears turn as if a spring held them.
"$contact" "$parameters/sphere_on_block.prm" --quiet \
  --set "Solution/Linear solver=AMG" --set Output/Screen=none
awk -F'[:,]' '
  /"levels"/ { exit }
  /"newton_iterations"/ { newton = newton " " $2; steps = $2; bad = bad || $2 > 8 }
  /"linear_iterations"/ { linear = linear " " $2; bad = bad || $2 > 20 * steps }
  END { print "sphere on block: Newton steps" newton ", iterations" linear
        exit !linear || bad }' \
  "output/sphere_on_block/summary.json"
