#!/bin/sh
# Static analysis of the sources: cppcheck, clang-tidy
# with the checks of .clang-tidy, and the complaints of doxygen. Exit status 1 if
# one of them has something to say.
#   static_analysis.sh DIRECTORY [FILE...]
# Writes into DIRECTORY; without FILE all sources, 15 minutes on one core.
# SPDX-License-Identifier: LGPL-2.1-or-later
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
mkdir -p "$1"
directory=$(CDPATH='' cd -- "$1" && pwd)
shift
[ $# -gt 0 ] || set -- "$root"/contact.cc "$root"/include/*/*.cc \
  "$root"/include/*/*/*.cc
status=0

# clang cannot read the headers that GCC has precompiled: they are named in the
# commands of a build with them, so this one is without.
cmake -S "$root" -B "$directory" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
  >"$directory/cmake.log"

# deal.II's headers are not looked at, so that its types stay unknown.
echo "cppcheck"
cppcheck --enable=warning,performance,portability --inline-suppr --quiet \
  --std=c++17 --language=c++ --error-exitcode=1 --suppress=missingInclude \
  -I "$root/include" "$@" || status=1

echo "clang-tidy"
# GCC's options that clang does not have are none of its business.
clang-tidy -p "$directory" --quiet --extra-arg=-Wno-unknown-warning-option \
  --extra-arg=-Wno-ignored-optimization-argument "$@" \
  2>"$directory/clang-tidy.log" || status=1
grep "error:" "$directory/clang-tidy.log" || true

echo "doxygen"
(cd "$root" && { cat tests/Doxyfile
  echo "OUTPUT_DIRECTORY = $directory"; } | doxygen - >/dev/null) || status=1
exit $status
