#!/bin/sh
# The curves along the slave surface on the reference mesh: multiplier, shear
# and nodal force of modelings A to F lie within 0.5 % of their peak (A: 1 %)
# of the reference profiles, node by node, and so does the border of stick in C
# and D.
#   profiles.sh CONTACT CASES REFERENCE
# CASES are the folders of parameter files for the reference mesh.
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
cases=$2
reference=$3

# The reference profiles were computed with these two kinds of geometry.
"$contact" "$cases"/published/[aef].prm "$cases"/newton_geometry/[bcd].prm \
  --set "Mesh/File=$reference/ssnp154-linear.msh" --set "Output/VTU=false" \
  --quiet

failures=0
for modeling in a b c d e f; do
  tolerance=0.005
  [ $modeling = a ] && tolerance=0.01
  awk -F, -v modeling=$modeling -v tolerance=$tolerance '
    function abs(x) { return x < 0 ? -x : x }
    FNR == 1 { file++ }
    file == 1 && FNR == 1 {
      for (i = 1; i <= NF; i++) column[$i] = i
      ours[1] = column["pressure_MPa"]
      ours[2] = column["shear_MPa"]
      ours[3] = column["nodal_force_N_per_mm"]
    }
    file == 1 && $1 == "slave" {
      n++
      arc[n] = $2
      for (k = 1; k <= 3; k++) value[n, k] = $(ours[k])
    }
    # arc length, u_x, u_y, multiplier, shear, nodal force
    file == 2 && !/^#/ {
      m++
      if (abs(arc[m] - $1) > 1e-3) misplaced = 1
      for (k = 1; k <= 3; k++)
        if ($(k + 3) != "") {
          seen[k] = 1
          if (abs($(k + 3)) > peak[k]) peak[k] = abs($(k + 3))
          d = abs(value[m, k] - $(k + 3))
          if (d > worst[k]) { worst[k] = d; place[k] = $1 }
        }
    }
    END {
      split("multiplier,shear,nodal force", name, ",")
      # The reference stops where nothing touches any more.
      bad = m == 0 || m > n || misplaced
      for (k = 1; k <= 3; k++)
        if (seen[k] && peak[k] > 0) {
          deviation = worst[k] / peak[k]
          bad = bad || deviation > tolerance
          printf "%s %-12s worst deviation %.5f %% of the peak, at %.2f mm\n",
            modeling, name[k], 100 * deviation, place[k]
        }
      exit bad
    }' output/$modeling/profile.csv "$reference/profiles/$modeling.csv" ||
    failures=$((failures + 1))
done

# border MODELING LAST_STICK FIRST_SLIP [mm]
border() {
  awk -F, -v modeling="$1" -v last_stick="$2" -v first_slip="$3" '
    function near(a, b) { return a - b < 0.01 && b - a < 0.01 }
    FNR == 1 { for (i = 1; i <= NF; i++) if ($i ~ /^status/) status = i }
    $1 == "slave" && $status == 2 { stick = $2 }
    $1 == "slave" && $status == 1 && $2 > stick && $2 > 0.5 && !slip { slip = $2 }
    $1 == "slave" && $status == 2 { slip = 0 }
    END {
      printf "%s last stick %.2f mm, first slip %.2f mm\n", modeling, stick, slip
      exit !(near(stick, last_stick) && near(slip, first_slip))
    }' "output/$1/profile.csv" || failures=$((failures + 1))
}
border c 2.46 3.11
border d 3.11 3.44

[ $failures -eq 0 ]
