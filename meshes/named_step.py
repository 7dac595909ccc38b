#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP files with labels, from descriptions of gmsh: as a CAD program writes
them, which names parts and faces; gmsh itself writes no names.

    named_step.py DIRECTORY      writes lug.step there

Body number i has the label bodies[i - 1], surface number i faces[i]. Needs gmsh.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

LUG = """
// A lug, 8 mm thick, with a round head and a bore, and a pin that fits with 0.1
// mm of clearance. Lengths in mm.
SetFactory("OpenCASCADE");
Box(1) = {-40, -12, -4, 40, 24, 8};
Cylinder(2) = {0, 0, -4, 0, 0, 8, 12};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {0, 0, -4, 0, 0, 8, 5};
BooleanDifference(5) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
Cylinder(6) = {0, 0, -9, 0, 0, 18, 4.95};
"""


def write_step(description, file, bodies=(), faces=None):
    """Let gmsh write what it draws, then put in the labels."""
    with tempfile.TemporaryDirectory() as directory:
        geo = pathlib.Path(directory, "part.geo")
        geo.write_text(f'{description}\nSave "part.step";\n')
        subprocess.run(["gmsh", "-", geo], check=True, cwd=directory,
                       stdout=subprocess.DEVNULL)
        text = geo.with_suffix(".step").read_text()
    # What changes with the day and the version is no part of the geometry.
    text = re.sub(r"FILE_NAME\(.*?\);", "FILE_NAME('','',(''),(''),'','','');",
                  text, flags=re.DOTALL)
    names = sorted(set(re.findall(r"PRODUCT\('([^']*)'", text)),
                   key=lambda name: (len(name), name))
    parts = names[1:] if len(names) > 1 else names
    for label, name in zip(bodies, parts):
        text = text.replace(f"'{name}'", f"'{label}'")
    number = iter(range(1, text.count("ADVANCED_FACE(") + 1))
    text = re.sub(r"ADVANCED_FACE\(''", lambda match: "ADVANCED_FACE('{}'".format(
        (faces or {}).get(next(number), "")), text)
    pathlib.Path(file).write_text(text)


if __name__ == "__main__":
    write_step(LUG, pathlib.Path(sys.argv[1], "lug.step"), ("Lug", "Pin"),
               {1: "Foot", 7: "Bore", 8: "Shank", 9: "Ends", 10: "Ends"})
