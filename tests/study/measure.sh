#!/bin/sh
# Renews what README shows beside the study: runs the commands below one after
# the other, keeps what they print in results/, and puts it into README. Needs
# the build that ./run makes, the results of the tests on the reference meshes in
# it, and a quarter of an hour in which the machine does nothing else.
#   measure.sh [NAME...]    all, or only these
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
cd "$here/../.."
results=tests/study/results

# record NAME FORM SHOWN COMMAND...: FORM is table (Markdown) or text; SHOWN is
# what to type for the same.
record() {
  name=$1
  form=$2
  shown=$3
  shift 3
  case " $wanted " in
    *" $name "* | "  ") ;;
    *) return 0 ;;
  esac
  {
    printf '`%s`, load of the machine before: %s\n\n' "$shown" \
      "$(cut -d ' ' -f 1 /proc/loadavg)"
    [ "$form" = table ] || echo '```'
    "$@"
    [ "$form" = table ] || echo '```'
  } >"$results/$name.part"
  mv "$results/$name.part" "$results/$name.md"
}

wanted=$*
contact=$PWD/build/contact
record modelings text ./run "$contact" parameters/ssnp154_[a-g].prm --quiet
record verification text './run parameters/verification/*.prm --quiet' \
  "$contact" parameters/verification/*.prm --quiet
record reference_mesh table 'tests/reference_table.py build' \
  tests/reference_table.py build
record benchmark text './run benchmark' tests/benchmark.sh "$contact"
record oscillation table './run oscillation' tests/oscillation.sh "$contact"
record hard table './run hard' tests/hard/hard.py --table \
  --output output/hard "$contact"
record scaling table './run scaling' tests/scaling.sh "$contact"
record effects table './run effects' tests/effects/effects.py "$contact"
record yardstick table './run yardstick' tests/effects/yardstick.py \
  build/tests/plain_elasticity "$contact"
tests/study/report.py "$results" --readme README.md
