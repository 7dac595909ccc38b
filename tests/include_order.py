#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layers of the library: a file of a room of include/ includes files of the
same room or of one further up in the list below, and no two files include each
other, by whatever way.

Usage: include_order.py CONTACT PARAMETERS MESHES
"""

import pathlib
import re
import sys

ROOMS = ("base", "parameters", "mesh", "bodies", "solid/materials", "solid",
         "contact/surfaces", "contact/obstacles", "contact/points",
         "contact/mortar", "contact/interface", "contact/results",
         "model", "probes",
         "solvers/newton", "solvers/direct", "solvers/saddle_point",
         "solvers/rigid_pieces", "solvers/condensed", "solvers/multigrid",
         "solvers",
         "adaptivity", "verification", "output/vtu", "output")
# Rooms may have so many files.
MAX_FILES = 40

root = pathlib.Path(__file__).resolve().parent.parent / "include"
failures = 0


def fail(what):
    global failures
    print("FAILED:", what)
    failures += 1


def included(file):
    return re.findall(r'^#include "(.*)"', file.read_text(), re.MULTILINE)


def has_circle(name, way=()):
    if name in way:
        fail("circle: " + " -> ".join(way + (name,)))
        return True
    return any(has_circle(other, way + (name,)) for other in graph[name])


files = sorted(f for f in root.rglob("*") if f.suffix in (".h", ".cc"))
graph = {}
for file in files:
    name = file.relative_to(root).as_posix()
    room = name.rpartition("/")[0]
    if room not in ROOMS:
        fail(f"{name} is in no room of the list")
        continue
    graph[name] = included(file)
    for other in graph[name]:
        above = other.rpartition("/")[0]
        if not (root / other).is_file():
            fail(f"{name} includes {other}, which is no file of include/")
        elif above not in ROOMS:
            fail(f"{name} includes {other}, which is in no room of the list")
        elif ROOMS.index(above) > ROOMS.index(room):
            fail(f"{name} includes {other}, of a room further down")
for room in ROOMS:
    count = sum(name.rpartition("/")[0] == room for name in graph)
    if count > MAX_FILES:
        fail(f"the room {room} has {count} files")
print(f"{len(files)} files in {len(ROOMS)} rooms")
if not failures:
    any([has_circle(name) for name in graph])
sys.exit(failures > 0)
