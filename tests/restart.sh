#!/bin/sh
# A run that ends from outside leaves its finished increments readable, and goes
# on from there with --restart to the same result: after SIGTERM, after SIGKILL,
# and where the disk was full, on one process and on two, with and without levels.
#   restart.sh CONTACT PARAMETERS MESHES
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

contact=$1
parameters=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
failures=0

fail() {
  echo "FAILED: $1"
  failures=$((failures + 1))
}

# run DIRECTORY OPTION...: the case, with more than one increment to lose. To
# agree to 1e-10 it has to be solved further: a restart builds a new hierarchy of
# grids, where the whole run keeps an older one.
run() {
  directory=$1
  shift
  $launcher "$contact" "$case" --quiet --set "Output/Directory=$directory" \
    --set Solution/Increments=6 --set Probes/References= \
    --set Probes/Tolerances= --set "Solution/Newton tolerance=1e-11" \
    "$@" >"$directory.log" 2>&1
}

# finished DIRECTORY: how many increments its summary calls converged
finished() {
  grep -c '"converged": true' "$1/$name/summary.json" || true
}

# is_converged DIRECTORY: whether its summary says so of the whole run
is_converged() {
  grep -q '^  "converged": true' "$1/$name/summary.json"
}

# start DIRECTORY: the case in the background as $pid, with the file
# DIRECTORY.ended once it is over
start() {
  rm -rf "$1" "$1.ended"
  (
    status=0
    run "$1" || status=$?
    touch "$1.ended"
    exit "$status"
  ) & pid=$!
}

# send SIGNAL DIRECTORY: once the summary has two increments, however long they take;
# $status is that of the run. One that was over before the signal came, on a busy
# machine, is started again; mpirun may still have been there to get the signal.
send() {
  for _ in 1 2 3 4 5; do
    start "$2"
    until [ -e "$2.ended" ]; do
      n=$(finished "$2" 2>/dev/null)
      if [ "${n:-0}" -ge 2 ] && [ -e "$2/$name/restart.bin" ]; then
        # shellcheck disable=SC2046 # two of mpirun, which would be slower
        kill "-$1" $(pgrep -P $pid -x contact ||
          pgrep -P "$(pgrep -P $pid)" -x contact) 2>/dev/null || true
        break
      fi
      sleep 0.05
    done
    status=0
    wait $pid || status=$?
    if [ "$status" -ne 0 ] &&
       { [ -z "$launcher" ] || ! is_converged "$2"; }; then
      return 0
    fi
  done
  fail "$2: over before the signal $1, five times"
}

# compare DIRECTORY: probes, contact, works and reactions are those of the whole
# run within 1e-10.
compare() {
  python3 - "whole/$name/summary.json" "$1/$name/summary.json" <<'PYTHON' ||
import json, sys
whole, other = (json.load(open(name)) for name in sys.argv[1:3])
agreement = 1e-10
def numbers(s):
    last = s["increments"][-1]
    return ([p["value"] for p in s["probes"]] + list(s["contact"].values()) +
            [last["works"]["external"], last["works"]["dissipation"]] +
            [r for group in last["reactions"].values() for r in group.values()])
worst = max(abs(a - b) / max(abs(a), 1e-3)
            for a, b in zip(numbers(whole), numbers(other)))
same = len(whole["increments"]) == len(other["increments"])
good = worst < agreement and same and other["converged"]
print("  largest relative difference %s %.0e, increments %s" %
      ("<" if worst < agreement else "%.1e, not <" % worst, agreement,
       "the same" if same else "NOT the same"))
sys.exit(0 if good else 1)
PYTHON
    fail "$1 differs from the whole run"
  grep -c DataSet "whole/$name/bodies.pvd" >a
  grep -c DataSet "$1/$name/bodies.pvd" >b
  cmp -s a b || fail "$1: the series is not complete"
  [ ! -e "$1/$name/restart.bin" ] || fail "$1: the restart file is left"
}

interrupted() {
  signal=$1
  directory=$signal
  send "$signal" "$directory"
  if [ "$signal" = TERM ] && [ -z "$launcher" ]; then
    [ "$status" -eq 5 ] || fail "$signal: exit status $status instead of 5"
  fi
  n=$(finished "$directory")
  [ "$n" -ge 2 ] || fail "$signal: $n increments in the summary"
  ! is_converged "$directory" || fail "$signal: the summary looks converged"
  run "$directory" --restart || fail "$signal: --restart ends with $?"
  compare "$directory"
}

# everything SIGNAL...
everything() {
  name=$(basename "$case" .prm)
  rm -rf whole
  run whole
  for signal in "$@"; do
    echo "$name, $signal${launcher:+, two processes}:"
    interrupted $signal
  done
}

launcher=
case=$parameters/ssnp154_d.prm
everything TERM KILL

# The results of the fifth increment meet a full disk.
echo "$name, full disk:"
mkdir -p "full/$name"
ln -s /dev/full "full/$name/bodies_0005_0.vtu.part"
status=0
run full || status=$?
[ "$status" -eq 2 ] || fail "full disk: exit status $status instead of 2"
grep -q 'cannot be written' full.log || fail "full disk: no message"
[ "$(finished full)" -eq 4 ] ||
  fail "full disk: $(finished full) increments in the summary instead of 4"
run full --restart || fail "full disk: --restart ends with $?"
compare full

# A restart file on a full disk is an error.
rm -rf full
mkdir -p "full/$name"
ln -s /dev/full "full/$name/restart.bin.part"
status=0
run full || status=$?
[ "$status" -eq 2 ] && grep -q 'restart.bin' full.log ||
  fail "full disk, restart file: exit status $status instead of 2"
[ ! -e "full/$name/restart.bin" ] || fail "full disk: half a restart file"

# Other parameters are not gone on with.
echo "other parameters:"
send KILL other
find other -type f -exec cksum {} + | sort >before
status=0
run other --restart --set "Contact/Friction coefficient=0.2" || status=$?
[ "$status" -eq 2 ] && grep -q 'other parameters' other.log ||
  fail "other parameters: exit status $status"
find other -type f -exec cksum {} + | sort >after
cmp before after || fail "other parameters: results were touched"
echo "  refused"

case=$parameters/nested_friction.prm
cat >levels.prm <<PRM
include $case
subsection Refinement
  set Levels = 2
end
subsection Output
  set VTU = true
end
PRM
case=levels.prm
everything TERM KILL

# Two processes may share one core, where each waits for the other.
sed -i 's/Levels = 2/Levels = 1/' levels.prm
launcher="mpirun -np 2"
everything TERM

[ "$failures" -eq 0 ]
