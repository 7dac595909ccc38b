#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The entry of deal.II's code gallery: the tutorial beside this file, and in
kernel/ what it includes of the library, by whatever way, with the sources that
belong to these headers.

Usage: make_entry.py DIRECTORY
"""

import pathlib
import re
import shutil
import sys

source = pathlib.Path(__file__).resolve().parent
include = source.parents[2] / "include"
# The structures of entries are needed, the reader of parameter files is not.
WITHOUT_SOURCES, BUT = "parameters/", "parameters/formula.cc"
MAX_LINES = 1500  # of the tutorial


def included(file):
    return [name for name in re.findall(r'^#include "(.*)"', file.read_text(),
                                        re.MULTILINE)
            if (include / name).is_file()]


def sources_of_headers():
    """By headers, the sources with their name, and those without a header of
    their own that include one of their folder."""
    found = {}
    for file in sorted(include.rglob("*.cc")):
        name = file.relative_to(include).as_posix()
        header = name[:-3] + ".h"
        room = name.rpartition("/")[0]
        of = [header] if (include / header).is_file() else [
            h for h in included(file) if h.rpartition("/")[0] == room]
        for header in of:
            found.setdefault(header, []).append(name)
    return found


sources = sources_of_headers()
kernel, todo = set(), included(source / "sliding_blocks.cc")
while todo:
    file = todo.pop()
    is_left_out = (file.startswith(WITHOUT_SOURCES) and file.endswith(".cc")
                   and file != BUT)
    if file not in kernel and not is_left_out:
        kernel.add(file)
        todo += included(include / file) + sources.get(file, [])

entry = pathlib.Path(sys.argv[1]).resolve()
shutil.rmtree(entry, ignore_errors=True)
shutil.copytree(source, entry, ignore=shutil.ignore_patterns("*.py"))
for file in kernel:
    (entry / "kernel" / file).parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(include / file, entry / "kernel" / file)
lines = {name: len((root / name).read_text().splitlines())
         for root, names in ((source, ["sliding_blocks.cc"]), (include, kernel))
         for name in names}
tutorial = lines.pop("sliding_blocks.cc")
print(f"{entry}: tutorial {tutorial} lines, kernel {sum(lines.values())} lines "
      f"in {len(lines)} files")
sys.exit(f"the tutorial has more than {MAX_LINES} lines"
         if tutorial > MAX_LINES else 0)
