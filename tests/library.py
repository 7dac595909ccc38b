#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The library as others have it: the build is installed, tests/library is built
against what was installed, and its two blocks, with an elasticity and a mesh of
their own, have the forces of the program on the same mesh: with multipliers as
unknowns, and eliminated.

Usage: library.py CONTACT PARAMETERS MESHES BUILD
"""

import pathlib
import shutil
import sys

from block_scenes import check, failures
from own_programs import build, call, compare, library

build_of_program = pathlib.Path(sys.argv[4])
prefix = pathlib.Path("prefix").resolve()
shutil.rmtree(prefix, ignore_errors=True)
if shutil.which("cmake"):
    call("cmake", "--install", build_of_program, "--prefix", prefix,
         "--component", "library")
built = build(library, build_of_program, "", f"-DCMAKE_PREFIX_PATH={prefix}")
compiled = call("ninja", "-C", "own", "-t", "deps")
check("its headers are the installed ones",
      f"{prefix}/include/contact/" in compiled and
      f"{library.parents[1]}/include/" not in compiled)
for program in "two_blocks", "two_blocks_condensed":
    for dim in (2, 3):
        compare(built / program, dim, increments=1)
sys.exit(len(failures) > 0)
