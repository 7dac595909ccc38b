#!/bin/sh
# Several processes compute what one does: probes and reactions agree to 1e-8,
# all points of contact do the same, finer levels start from the same state, and
# every process writes its piece of the bodies. Of the displacements each holds
# its own, their neighbors and the surfaces of contact.
#   ranks.sh CONTACT PARAMETERS
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
parameters=$2

# values FILE: the probes of a summary, and the reactions in y, one a line; in
# space the probes alone, for the other reactions are zero
values() {
  awk -F'[:,]' -v values="$values" '$1 ~ "\"(" values ")\"" { print $2 }' "$1"
}

# decisions DIRECTORY: what the points do, counted in all increments, and one by
# one in the last
decisions() {
  grep -E '"(level|active|stick|slip)": [0-9]+,?$' "$1/summary.json"
  # In 3-D the order of the nodes depends on the processes: by their places.
  awk -F, '
    NR == 1 {
      for (i = 1; i <= NF; ++i) {
        if ($i ~ /^status/) column = i
        if ($i == "Z_mm") space = 1
      }
      next
    }
    space { printf "%s %.4f %.4f %.4f ", $1, $2 + 1e-6, $3 + 1e-6, $4 + 1e-6 }
    !space { printf "%06d ", NR }
    { print $column }' "$1/profile.csv" | LC_ALL=C sort
}

# starts LOG: on finer levels the residual that each increment starts with
starts() {
  awk '
    /^Level / { level = $2 }
    /^Increment / { begins = level != "" }
    begins && $1 == "Newton" { print level, $4; begins = 0 }' "$1"
}

# pieces DIRECTORY RANKS: whether each process has written its part
pieces() {
  last=$1/bodies_0002_0
  if [ "$2" -eq 1 ]; then
    [ -s "$last.vtu" ]
  else
    [ -s "$last.pvtu" ] && [ "$(find "$1" -name 'bodies_0002_*.*.vtu' \
      -size +0 | sed 's/.*_[0-9]*[.]//' | sort -u | wc -l)" -eq "$2" ]
  fi && [ -s "$1/contact_0002_0.vtu" ]
}

# held SUMMARY: the largest share of the displacements on a process
held() {
  awk -F'[:,]' '
    $1 ~ "\"displacement\"" { all = $2 }
    $1 ~ "\"displacements_on_a_process\"" { held = $2 }
    END { printf "%.3f", held / all }' "$1"
}

failures=0
fail() {
  echo "  FAILED: $1"
  failures=$((failures + 1))
}

# compare NAME FILE ARGUMENT...: a case with several numbers of processes. Conjugate
# gradients depend on the number of processes through their preconditioner, and
# the geometry loop ends with an error that depends on its start: to agree to
# 1e-8, Newton's method has to be pushed far below the default tolerance on all
# levels.
compare() {
  name=$1
  file=$2
  shift 2
  echo "$name:"
  stem=$(basename "$file" .prm)
  for n in $processes; do
    mpirun -np $n "$contact" "$parameters/$file" \
      --set "Solution/Newton tolerance=1e-11" \
      --set Refinement/Tolerance=1e-11 \
      --set "Solution/Linear solver=$solver" --set Solution/Increments=2 \
      --set Probes/References= --set Probes/Tolerances= \
      --set Output/VTU=true --set Output/Profile=true \
      --set "Output/Directory=$name/$n" "$@" >screen.$n ||
      fail "exit status $? with $n processes"
    directory=$name/$n/$stem
    values "$directory/summary.json" >probes.$n
    decisions "$directory" >decisions.$n
    pieces "$directory" $n || fail "a file is missing with $n processes"
    starts "$directory/log.txt" >starts.$n
    # Four digits are printed, of which round-off may change the last by one.
    paste starts.1 starts.$n | awk -v increments="$(
      sed '/"levels"/q' "$directory/summary.json" | grep -c '"level": [1-9]')" '
      { d = $2 / $4 - 1; bad += !($1 == $3 && d * d < 1.1e-3 * 1.1e-3) }
      END { exit bad > 0 || NR != increments }' ||
      fail "levels start elsewhere with $n processes: residuals $(
        paste -s -d ' ' starts.1), not $(paste -s -d ' ' starts.$n)"
    share=$(held "$directory/summary.json")
    echo "  $n processes: one holds $share of the displacements"
    awk -v share="$share" -v n=$n -v beside=$beside \
      'BEGIN { exit share > 1 / n + (n > 1) * beside }' ||
      fail "a process holds $share of the displacements with $n processes"
    cmp -s decisions.1 decisions.$n ||
      fail "other decisions with $n processes: $(diff decisions.1 decisions.$n |
        head -n 6 | tr '\n' ' ')"
    paste probes.1 probes.$n | awk -v ranks=$n '
      { d = $1 / $2 - 1; if (d < 0) d = -d; if (d > worst) worst = d; n++ }
      END {
        printf "  %d processes: largest relative difference %.1e\n", ranks, worst
        exit !(n > 2 && worst <= 1e-8)
      }' || fail "other probes or reactions with $n processes"
  done
}

# More than there are cores is slow, and the same for all cases with levels. What a
# process holds beside its share is measured: 0.31 and 0.19 of all unknowns at most,
# less on finer meshes. With triangles each holds all.
solver=AMG
values=value
beside=0.35
processes='1 2'
compare "levels in 3-D, friction" nested_space_friction.prm \
  --set Refinement/Levels=1
values='value|y'
beside=0.2
processes='1 3'
compare "uniform levels, friction" nested_friction.prm \
  --set Refinement/Levels=2 --set Element/Degree=1 \
  --set "Element/Centre node=serendipity"
processes='1 2'
compare "uniform levels, friction, large displacement" nested_large.prm \
  --set Refinement/Levels=2
processes='1 2 3'
compare "adaptive levels, friction" nested_friction.prm \
  --set Refinement/Levels=5 --set Refinement/Strategy=adaptive
processes='1 2'
compare "adaptive levels, degree 1, large displacement" nested.prm \
  --set Refinement/Levels=4 --set Refinement/Strategy=adaptive \
  --set Element/Degree=1 --set "Element/Centre node=serendipity" \
  --set "Solids/Kinematics=large displacement"
compare "8 nodes, body forces, three zones" verification/stack.prm \
  --set Element/Degree=2 --set Mesh/Refinements=2 \
  --set "Boundary conditions/Body force y=One: -0.1; Two: -0.2; Three: -0.3"
beside=1
processes='1 2 4'
compare "triangles and quadrangles, nodal rule, friction" ssnp154_c.prm \
  --set Solution/System=condensed
solver=MUMPS
processes='1 3'
compare "MUMPS" ssnp154_c.prm --set Solution/System=condensed
[ $failures -eq 0 ]
