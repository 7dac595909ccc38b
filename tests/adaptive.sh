#!/bin/sh
# The savings of adaptive refinement: the error of DY(B) against the number of
# unknowns with uniform and with adaptive refinement, for linear and for
# quadratic elements, and how many unknowns the adaptive meshes need for the
# error of the uniform ones. Small strain, no friction.
#   adaptive.sh CONTACT [MAX_UNKNOWNS]
# MAX_UNKNOWNS of the uniform meshes, 400000 by default; adaptive meshes go as
# far as the error asks for, to a quarter of that, and the reference to all of
# it. An error is small for no reason where it changes its sign: what is compared
# is the largest error on a mesh and all finer ones of its sequence.
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
max_unknowns=${2-400000}
parameters=$(CDPATH='' cd -- "$(dirname -- "$0")/../parameters" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
OPENBLAS_NUM_THREADS=1
export OPENBLAS_NUM_THREADS

# point DEGREE STRATEGY FRACTION LEVELS: sets unknowns and line, 'unknowns DY(B)'
point() {
  status=0
  "$contact" "$parameters/nested.prm" --quiet --set "Element/Degree=$1" \
    --set "Element/Centre node=$([ "$1" = 1 ] && echo bound || echo free)" \
    --set "Refinement/Strategy=$2" --set "Refinement/Fraction=$3" \
    --set "Refinement/Levels=$4" --set Probes/References= \
    --set Probes/Tolerances= --set Output/Screen=table >messages 2>&1 || status=$?
  if [ $status -ne 0 ]; then
    echo "degree $1, $2, fraction $3, $4 levels: status $status" >&2
    cat messages >&2
    return 1
  fi
  line=$(awk -F'[:,]' '
    /"name": "DY\(B\)"/ { is_dy = 1 }
    is_dy && /"value"/ { dy = $2; is_dy = 0 }
    /"displacement"/ { unknowns = $2 }
    END { printf "%d %.12g", unknowns, dy }' output/nested/summary.json)
  unknowns=${line%% *}
}

# sequence DEGREE STRATEGY FRACTION MAX: a line for each mesh of a sequence,
# the first that has more than MAX unknowns being the last with adaptive
# refinement, and left out with uniform refinement.
sequence() {
  level=0
  while
    point "$1" "$2" "$3" "$level"
    echo "$line"
    if [ "$2" = uniform ]; then
      [ $((unknowns * 4)) -lt $(($4 * 104 / 100)) ]
    else
      [ "$unknowns" -le "$4" ]
    fi
  do
    level=$((level + 1))
  done
}

for degree in 1 2; do
  sequence $degree uniform 0.5 "$max_unknowns" >uniform.$degree
  for fraction in 0.3 0.5 0.7; do
    sequence $degree adaptive $fraction $((max_unknowns / 4)) \
      >adaptive.$degree.$fraction
  done
done

# The finest of all: from the level that the sequence above has ended with.
level=$(wc -l <adaptive.2.0.5)
while point 2 adaptive 0.5 "$level" && [ "$unknowns" -lt "$max_unknowns" ]; do
  level=$((level + 1))
done
reference=${line#* }
echo "Reference: DY(B) = $reference mm, adaptive refinement, quadratic" \
  "elements, $unknowns unknowns."
awk -v reference="$reference" '
  { unknowns = $1; dy = $2 }
  END {
    printf "Uniform refinement, %d unknowns: %.7f mm, which differs by %.1e",
      unknowns, dy, dy - reference
    printf " mm.\nKnown from elsewhere: -1.27434 +- 6e-05 mm; the reference"
    printf " differs by %.1e mm.\n", reference + 1.27434 }' uniform.2

for degree in 1 2; do
  printf '\nDegree %d; in brackets how many times fewer unknowns:\n\n' $degree
  echo "| unknowns, uniform | DY(B) [mm] | error [mm] | largest from there on |" \
    "unknowns for that, fraction 0.3 | 0.5 | 0.7 |"
  echo "|---|---|---|---|---|---|---|"
  awk -v reference="$reference" '
    function abs(x) { return x < 0 ? -x : x }
    FNR == 1 { file++; n[file] = 0 }
    {
      i = ++n[file]
      unknowns[file, i] = $1
      dy[file, i] = $2
      error[file, i] = abs($2 - reference)
    }
    # Unknowns at which the largest error from there on is e, by interpolation
    # of logarithms; 0: none.
    function needed(f, e,    i, low, high, s) {
      if (envelope[f, n[f]] > e)
        return 0
      for (i = n[f]; i > 1 && envelope[f, i - 1] <= e; i--)
        ;
      if (i == 1)
        return unknowns[f, 1]
      high = log(envelope[f, i - 1])
      low = log(envelope[f, i] > 0 ? envelope[f, i] : 1e-12)
      s = (high - log(e)) / (high - low)
      s *= log(unknowns[f, i] / unknowns[f, i - 1])
      return unknowns[f, i - 1] * exp(s)
    }
    END {
      for (f = 1; f <= file; f++)
        for (i = n[f]; i > 0; i--) {
          envelope[f, i] = error[f, i]
          if (i < n[f] && envelope[f, i + 1] > envelope[f, i])
            envelope[f, i] = envelope[f, i + 1]
        }
      for (i = 1; i <= n[1]; i++) {
        printf "| %d | %.7f | %.2e | %.2e |", unknowns[1, i], dy[1, i],
          error[1, i], envelope[1, i]
        for (f = 2; f <= file; f++) {
          m = needed(f, envelope[1, i])
          if (m > 0)
            printf " %d (%.1f) |", m, unknowns[1, i] / m
          else
            printf " > %d |", unknowns[f, n[f]]
        }
        printf "\n"
      }
    }' uniform.$degree adaptive.$degree.0.3 adaptive.$degree.0.5 \
    adaptive.$degree.0.7
done

printf '\nThe adaptive meshes with fraction 0.5:\n\n'
echo "| degree | unknowns | DY(B) [mm] | error [mm] |"
echo "|---|---|---|---|"
for degree in 1 2; do
  awk -v degree=$degree -v reference="$reference" '
    { e = $2 - reference
      printf "| %d | %d | %.7f | %+.1e |\n", degree, $1, $2, e }' \
    adaptive.$degree.0.5
done
