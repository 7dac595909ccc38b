#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The entry of the code gallery is made, built as it is and run: the forces of
the program on the same mesh, after pressing and dragging.

Usage: gallery_entry.py CONTACT PARAMETERS MESHES BUILD
"""

import pathlib
import sys

from block_scenes import failures
from own_programs import build, call, compare, library

print(call(library / "gallery" / "make_entry.py", "entry"))
executable = build("entry", pathlib.Path(sys.argv[4]), "sliding_blocks")
for dim in (2, 3):
    down = "xyz"[dim - 1]
    compare(executable, dim, increments=4,
            histories=f"Displacement {down}: min(1, 2*t); "
                      "Displacement x: max(0, 2*t - 1)")
sys.exit(len(failures) > 0)
