#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layers of the library: a file of a folder of include/ includes files of
the same folder or of one further up in the list below, and no two files include
each other, by whatever way.

Usage: include_order.py CONTACT PARAMETERS MESHES
"""

import pathlib
import re
import sys

FOLDERS = ("base", "parameters", "mesh", "solid", "contact", "solvers",
           "adaptivity", "verification", "output")

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
    folder = name.split("/")[0]
    if folder not in FOLDERS or name.count("/") != 1:
        fail(f"{name} is in no folder of the list")
        continue
    graph[name] = included(file)
    for other in graph[name]:
        above = other.split("/")[0]
        if not (root / other).is_file():
            fail(f"{name} includes {other}, which is no file of include/")
        elif FOLDERS.index(above) > FOLDERS.index(folder):
            fail(f"{name} includes {other}, of a folder further down")
print(f"{len(files)} files in {len(FOLDERS)} folders")
if not failures:
    any([has_circle(name) for name in graph])
sys.exit(failures > 0)
