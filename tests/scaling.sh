#!/bin/sh
# The cost of contact on fine meshes: nested iteration without friction on finer
# and finer meshes, compared with the same bodies glued together on the finest
# mesh alone; on the largest one with friction and large displacements as well,
# and on two ranks. A Markdown table, and the exponent of the unknowns in the
# wall time, from 80000 unknowns on.
#   scaling.sh CONTACT [MAX_UNKNOWNS [OPTION...]]
#   scaling.sh CONTACT space [OPTION...]   in 3-D, see scaling_space.py
#   scaling.sh CONTACT processes [OPTION...]   see scaling_processes.py
# MAX_UNKNOWNS is 1400000 by default; 5300000 takes 10 GB. Not a test: nothing
# is asserted but convergence. Results go to a scratch directory.
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
case ${2-} in
  space | processes)
    study=scaling_$2.py
    shift 2
    exec "$(dirname -- "$0")/$study" "$contact" "$@"
    ;;
esac
max_unknowns=${2-1400000}
shift $(($# < 2 ? $# : 2))
parameters=$(CDPATH='' cd -- "$(dirname -- "$0")/../parameters" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# One core a rank, whatever the machine has.
OPENBLAS_NUM_THREADS=1
OMP_NUM_THREADS=1
DEAL_II_NUM_THREADS=1
export OPENBLAS_NUM_THREADS OMP_NUM_THREADS DEAL_II_NUM_THREADS

# clock: 'wall CPU', seconds since the machine started, and CPU seconds of all
# children of this shell so far
clock() {
  times >children # a pipe would make it the times of a subshell
  awk 'FNR == 1 { file++ }
    file == 1 { wall = $1 }
    file == 2 && FNR == 2 {
      for (i = 1; i <= 2; i++) { split($i, t, /[ms]/); s += 60 * t[1] + t[2] }
      print wall, s }' /proc/uptime children
}

load() { cut -d ' ' -f 1 /proc/loadavg; }

failures=0

# row LABEL DEGREE RANKS CASE OPTION...: runs the case and prints a line of the
# table, and sets unknowns and wall. The file 'tied' has the wall time to which
# the ratio refers, 0 for none.
row() {
  label=$1
  degree=$2
  ranks=$3
  case=$4
  shift 4
  if [ "$degree" = 1 ]; then centre=serendipity; else centre=free; fi
  mpi=''
  [ "$ranks" = 1 ] || mpi="mpirun -n $ranks"
  status=0
  clock >before
  # shellcheck disable=SC2086
  $mpi "$contact" "$parameters/$case.prm" --quiet \
    --set "Element/Degree=$degree" --set "Element/Centre node=$centre" \
    --set Probes/References= --set Probes/Tolerances= \
    --set Output/Screen=table "$@" >messages 2>&1 || status=$?
  clock >after
  summary=output/$case/summary.json
  if [ $status -ne 0 ]; then
    failures=$((failures + 1))
    echo "| $label | $degree | status $status |"
    cat messages >&2
    wall=0
    return 0
  fi
  paste before after >clocks
  # Newton steps and linear iterations are those of the last level, all of its
  # increments together.
  awk -F'[:,]' -v label="$label" -v degree="$degree" -v ranks="$ranks" '
    FILENAME == "clocks" {
      split($0, t, /[ \t]+/)
      wall = t[3] - t[1]
      cpu = t[4] - t[2]
      next
    }
    FILENAME == "tied" { tied = $1; next }
    { sub(/,$/, "") }
    /^  "[a-z_]*"/ { part = $1; gsub(/[ "]/, "", part) }
    part == "increments" && /"level"/ && $2 + 0 != level {
      level = $2 + 0
      newton = linear = 0
    }
    part == "increments" && /"newton_iterations"/ { newton += $2 }
    part == "increments" && /"linear_iterations"/ { linear += $2 }
    part == "levels" && /"displacements"/ { finest = 0 }
    part == "levels" && /"wall"/ { finest += $2 }
    part == "unknowns" && /"displacement"/ { unknowns = $2 + 0 }
    part == "peak_memory_mb" { memory = $2; part = "" }
    part == "levels" && /"system"/ {
      n = split($0, words, /[ "]+/)
      method = words[n - 1]
    }
    END {
      printf "| %s | %d | %d | %s | %d | %.1f | %.2f | %.2f | %s | %s | %.0f |",
        label, degree, unknowns, method, newton, linear / (newton ? newton : 1),
        wall, cpu, (finest > 0 ? sprintf("%.2f", finest) : "-"),
        (tied > 0 ? sprintf("%.2f", wall / tied) : "-"), memory
      printf " %.0f |\n", memory * 1048576 / unknowns
      print unknowns, wall >"result"
    }' clocks tied "$summary"
  read -r unknowns wall <result
}

echo "Load of the machine before: $(load)"
echo
echo "| case | degree | unknowns | solver | Newton steps, finest mesh |" \
  "linear iterations per step | wall [s] | CPU [s] | of wall, finest mesh |" \
  "wall by tied | memory [MB] | bytes per unknown |"
echo "|---|---|---|---|---|---|---|---|---|---|---|---|"
for degree in 1 2; do
  : >"measured.$degree"
  level=$((4 - degree)) # 80000 unknowns
  [ "$max_unknowns" -ge 80000 ] || level=$((2 - degree))
  while
    echo 0 >tied
    row tied "$degree" 1 nested_tied --set "Mesh/Refinements=$level" "$@"
    [ "$wall" = 0 ] || echo "$wall" >tied
    row 'no friction' "$degree" 1 nested --set "Refinement/Levels=$level" "$@"
    [ "$wall" = 0 ] || echo "$unknowns $wall" >>"measured.$degree"
    [ $((4 * unknowns)) -le "$max_unknowns" ]
  do
    level=$((level + 1))
  done
  row 'friction 0.1, one increment' "$degree" 1 nested_friction \
    --set "Refinement/Levels=$level" --set Solution/Increments=1 "$@"
  row 'friction 0.1, two increments' "$degree" 1 nested_friction \
    --set "Refinement/Levels=$level" "$@"
  row 'large displacement, friction 0.1, one increment' "$degree" 1 nested_large \
    --set "Refinement/Levels=$level" --set Solution/Increments=1 "$@"
  row 'large displacement, friction 0.1, two increments' "$degree" 1 \
    nested_large --set "Refinement/Levels=$level" "$@"
  echo "$level" >"level.$degree"
done

echo
for degree in 1 2; do
  awk -v degree=$degree '
    $1 >= 80000 {
      n++
      x = log($1)
      y = log($2)
      sx += x; sy += y; sxx += x * x; sxy += x * y
      if (n == 1) first = $1
      last = $1
    }
    END {
      if (n < 2)
        exit
      printf "Degree %d, no friction, %d to %d unknowns:", degree, first, last
      printf " wall time ~ unknowns^%.2f\n",
        (n * sxy - sx * sy) / (n * sxx - sx * sx) }' "measured.$degree"
done

# Two ranks, at most 1.3 million unknowns.
if command -v mpirun >/dev/null; then
  echo
  echo "One rank and two, load average before: $(load)," \
    "cores: $(getconf _NPROCESSORS_ONLN); memory is that of all ranks."
  echo
  echo "| case | degree | unknowns | solver | Newton steps, finest mesh |" \
    "linear iterations per step | wall [s] | CPU [s] | of wall, finest mesh |" \
    "wall by one rank | memory [MB] | bytes per unknown |"
  echo "|---|---|---|---|---|---|---|---|---|---|---|---|"
  cases='nested nested_friction nested_large'
  [ "$max_unknowns" -ge 80000 ] || cases=nested
  for degree in 1 2; do
    level=$(cat "level.$degree")
    [ "$level" -lt $((7 - degree)) ] || level=$((7 - degree))
    for case in $cases; do
      echo 0 >tied
      for ranks in 1 2; do
        row "$case, $ranks rank(s)" "$degree" "$ranks" "$case" \
          --set "Refinement/Levels=$level" --set Solution/Increments=1 "$@"
        [ "$ranks" = 2 ] || [ "$wall" = 0 ] || echo "$wall" >tied
      done
    done
  done
fi

[ $failures -eq 0 ]
