#!/bin/sh
# Whether the contact pressure oscillates: its deviation d from Hertz' pressure
# along the slave surface, over the nodes with x < 8 mm, as the total variation
#   sum |d_(i+1) - d_i| / p0,
# and what the pressure itself goes up and down more than from its largest value
# to zero, which a curve that only falls does not, also by p0. Small strain, no
# friction. The mortar rule with the block as slave must stay below 0.1 with
# linear and 0.15 with quadratic elements where the edges of the block are
# 0.75 mm long; the other rules and the other choice of the slave are there to
# compare with.
#   oscillation.sh CONTACT [RULE [SLAVE]]
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
shift
only=$* # none: all
here=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
OPENBLAS_NUM_THREADS=1
export OPENBLAS_NUM_THREADS

# Half width and largest pressure of Hertz.
hertz=$(PYTHONPATH=$here/tests PYTHONDONTWRITEBYTECODE=1 python3 -c '
from line_contact import ssnp154
print(ssnp154(35000).half_width, ssnp154(35000).max_pressure)')

failures=0

# row MESH REFINEMENTS EDGE DEGREE CENTRE RULE SLAVE [BAR]
row() {
  case "$6 $7" in
    "$only"*) ;;
    *) return 0 ;;
  esac
  case $7 in
    block) slave=Top_B master=Bottom_C ;;
    *) slave=Bottom_C master=Top_B ;;
  esac
  case "$4 $5" in
    '2 bound') element='8-node' ;;
    '2 free') element='9-node' ;;
    *) element='linear' ;;
  esac
  status=0
  "$contact" "$here/parameters/nested.prm" --quiet \
    --set "Mesh/File=$here/meshes/$1.msh" --set "Mesh/Refinements=$2" \
    --set "Element/Degree=$4" --set "Element/Centre node=$5" \
    --set "Contact/Discretization=$6" --set "Contact/Slave=$slave" \
    --set "Contact/Master=$master" --set Refinement/Levels=0 \
    --set Probes/References= --set Probes/Tolerances= \
    --set Output/Profile=true --set Output/Screen=table >messages 2>&1 || status=$?
  if [ $status -ne 0 ]; then
    echo "| $1 | $3 | $element | $6, $7 | status $status |"
    cat messages >&2
    [ -z "${8-}" ] || failures=$((failures + 1))
    return 0
  fi
  awk -F, -v what="$1 | $3 | $element | $6, $7" -v bar="${8-}" \
    -v a="${hertz% *}" -v p_0="${hertz#* }" '
    function abs(x) { return x < 0 ? -x : x }
    NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
    $1 == "slave" && $column["X_mm"] < 8 {
      p = $column["pressure_MPa"]
      x = $column["X_mm"] / a
      hertz = x < 1 && x > -1 ? p_0 * sqrt(1 - x * x) : 0
      if (hertz > p0) p0 = hertz
      if (p > largest) largest = p
      if (n++) { deviation += abs(p - hertz - last_d); own += abs(p - last_p) }
      last_d = p - hertz
      last_p = p
    }
    END {
      deviation /= p0
      good = bar == "" || deviation < bar
      printf "| %s | %d | %.4f | %.4f | %.3f | %s |\n", what, n, deviation,
        own - largest < 1e-6 * p0 ? 0 : (own - largest) / p0, largest / p0,
        bar == "" ? "-" : (good ? "yes" : "NO") " (" bar ")"
      exit !good
    }' output/nested/profile.csv || failures=$((failures + 1))
}

echo "| mesh | edges of the block [mm] | element | rule, slave | nodes |" \
  "variation of p - Hertz | of p beyond a monotone fall | largest p | below the limit |"
echo "|---|---|---|---|---|---|---|---|---|"
for mesh in 'ssnp154_quads 3 0.75' 'ssnp154 0 1.5' 'ssnp154 1 0.75'; do
  for element in '1 bound 0.1' '2 bound 0.15' '2 free 0.15'; do
    # shellcheck disable=SC2086
    set -- $mesh $element
    [ "$3" = 0.75 ] || set -- "$1" "$2" "$3" "$4" "$5" ''
    row "$1" "$2" "$3" "$4" "$5" mortar block "$6"
    row "$1" "$2" "$3" "$4" "$5" mortar cylinder
    row "$1" "$2" "$3" "$4" "$5" nodal block
    row "$1" "$2" "$3" "$4" "$5" nodal cylinder
    row "$1" "$2" "$3" "$4" "$5" Gauss block
    row "$1" "$2" "$3" "$4" "$5" Gauss cylinder
  done
done

[ $failures -eq 0 ]
