#!/bin/sh
# Which lines of the program the tests run through, by gcov, in a build
# directory of its own: lines by file and in all, and those that no test has
# seen. Takes the whole suite once more, in a program twice as slow. Exit status
# 1 below 90 % of the lines.
#   coverage.sh DIRECTORY [OPTION OF CTEST...]
# Needs Debian's gcovr.
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
mkdir -p "$1"
directory=$(CDPATH='' cd -- "$1" && pwd)
shift
OPENBLAS_NUM_THREADS=1
export OPENBLAS_NUM_THREADS

# Optimized: what gcov counts is decided before, and tests have time limits.
cmake -S "$root" -B "$directory" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_FLAGS="--coverage -fprofile-update=atomic" \
  -DCMAKE_EXE_LINKER_FLAGS=--coverage >"$directory/build.log"
cmake --build "$directory" --target contact unit_tests >>"$directory/build.log"

find "$directory" -name '*.gcda' -delete
# A failed test is ignored: ./run test judges; here one may run out of time.
(cd "$directory" && ctest "$@" >tests.log 2>&1) || true
tail -n 20 "$directory/tests.log"

# Debug's assertions are no lines of this build.
gcovr --root "$root" --object-directory "$directory" "$directory" \
  --filter "$root/include/" --filter "$root/contact.cc" \
  --exclude-directories '.*CompilerIdCXX' --exclude-throw-branches \
  --sort-uncovered --print-summary --fail-under-line 90
