#!/bin/sh
# Renews the tables of the pages beside those of the study: runs the commands
# below one after the other, keeps their output in results/, and puts it between
# the marks of every README.md. Needs the build that ./run makes, the results of
# the tests on the reference meshes in it, and a quarter of an hour in which the
# machine does nothing else.
#   measure.sh [NAME...]    all, or only these
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
cd "$here/../.."
results=tests/study/results

# record NAME FORM COMMAND...: FORM is table (Markdown) or text
record() {
  name=$1
  form=$2
  shift 2
  case " $wanted " in
    *" $name "* | "  ") ;;
    *) return 0 ;;
  esac
  {
    printf '`%s`, load average before: %s\n\n' "$*" \
      "$(cut -d ' ' -f 1 /proc/loadavg)"
    [ "$form" = table ] || echo '```'
    # shellcheck disable=SC2048,SC2086
    $*
    [ "$form" = table ] || echo '```'
  } >"$results/$name.part"
  mv "$results/$name.part" "$results/$name.md"
}

wanted=$*
record modelings text ./run
record verification text './run parameters/verification/*.prm --quiet'
record reference_mesh table tests/reference_table.py build
record benchmark text ./run benchmark
record oscillation table ./run oscillation
record hard table ./run hard --table
record scaling table ./run scaling
record scaling_space table ./run scaling space
record peers_space table ./run study --peers-in-space
record effects table ./run effects
record yardstick table ./run yardstick
tests/study/report.py "$results" --readme .
