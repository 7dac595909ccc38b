#!/bin/sh
# The cost of a modeling: CPU seconds on one core of starting up, and of each
# modeling after that by phase, the best of three runs (or REPETITIONS), and its
# memory. MODELINGS="a h": of these alone.
#   benchmark.sh CONTACT [OPTION...]
# Not a test: nothing is asserted. Results go to a scratch directory.
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
shift
parameters=$(CDPATH='' cd -- "$(dirname -- "$0")/../parameters" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# One core, whatever the machine has.
OPENBLAS_NUM_THREADS=1
DEAL_II_NUM_THREADS=1
export OPENBLAS_NUM_THREADS DEAL_II_NUM_THREADS
load=$(cut -d ' ' -f 1 /proc/loadavg)

# children: CPU seconds of all children of this shell so far
children() {
  times >times # a pipe would make it the times of a subshell
  awk 'NR == 2 {
    for (i = 1; i <= 2; i++) { split($i, t, /[ms]/); s += 60 * t[1] + t[2] }
    print s }' times
}

children >0
for i in 1 2 3 4 5; do "$contact" --help >/dev/null; done
children >1
startup=$(paste 0 1 | awk '{ printf "%.2f", ($2 - $1) / 5 }')
echo "start-up: $startup s of CPU (load average before: $load)"

printf '%-9s %8s %7s %9s %7s  %s\n' modeling 'CPU [s]' solving output \
  'MB' 'Newton steps, friction iterations'
for modeling in ${MODELINGS:-a b c d e f g h}; do
  for i in $(seq "${REPETITIONS:-3}"); do
    "$contact" "$parameters/ssnp154_$modeling.prm" --quiet \
      --set Output/Screen=none "$@" || true
    awk -F'[:,]' -v modeling=$modeling '
      /^  "time"/ { in_time = 1 }
      /^  "peak_memory_mb"/ { in_time = 0; memory = $2 }
      in_time && /{/ { phase = $1; gsub(/[ "]/, "", phase) }
      in_time && /"cpu"/ { all += $2; if (phase == "output") output = $2 }
      /^  "increments"/ { in_increments = 1 }
      /^  "levels"/ { in_increments = 0 }
      in_increments && /"newton_iterations"/ { newton += $2 }
      /"friction_iterations"/ { friction += $2 }
      END { printf "%-9s %8.2f %7.2f %9.2f %7.0f  %d, %d\n", modeling, all,
            all - output, output, memory, newton, friction }' \
      "output/ssnp154_$modeling/summary.json"
  done | sort -k 2n | head -n 1
done
