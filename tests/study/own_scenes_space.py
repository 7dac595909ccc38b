#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Accuracy on request in 3-D, on eight scenes: true errors beside the printed
ones, as own_scenes.py beside this script has them in the plane.

The reference is the limit of a geometric sequence through the values of three or
four meshes, refined uniformly and one beyond the last request; what the sequence
adds to its last value is its uncertainty. Scenes are left in the working
directory.

Usage: own_scenes_space.py CONTACT [SCENE...]
"""

import itertools
import math
import pathlib
import re
import subprocess
import sys

from own_scenes import Bars, parameter_file, solve, summary
from effectivity import limit  # the one beside this file

REQUESTS = (2, 0.5)
LIMIT = 600000  # unknowns of a run
LEVELS = {"crossed": 2, "lug": 2}  # of references; else 3
ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = ROOT / "parameters" / "verification" / "3d"

SECTOR = """
Mesh.RecombineAll = 1; Mesh.Algorithm = 8;
Macro Sector
  Point(n + 1) = {0, 0, n}; Point(n + 2) = {r, 0, n}; Point(n + 3) = {R, 0, n};
  Point(n + 4) = {0, R, n}; Point(n + 5) = {0, r, n};
  If (r > 0)
    Circle(n + 1) = {n + 5, n + 1, n + 2};
  EndIf
  Line(n + 2) = {n + 2, n + 3}; Circle(n + 3) = {n + 3, n + 1, n + 4};
  Line(n + 4) = {n + 4, n + 5};
  Transfinite Curve{n + 1, n + 3} = around + 1;
  Transfinite Curve{n + 2, n + 4} = across + 1;
  Curve Loop(n + 1) = {n + 1, n + 2, n + 3, n + 4};
  Plane Surface(n + 1) = {n + 1};
  Transfinite Surface{n + 1};
  out[] = Extrude {0, 0, h} { Surface{n + 1}; Layers{layers}; Recombine; };
Return
"""


def sector(first, r, outer, height, around, across, layers, names):
    """A quarter of a tube on z = FIRST, apart, as gmsh makes one curve of two at
    the same place; NAMES are those of the volume, of the face
    there, of that beyond the height, inner and outer faces."""
    text = (f"n = {first}; r = {r}; R = {outer}; h = {height}; around = {around}; "
            f"across = {across}; layers = {layers}; Call Sector;\n"
            f'Physical Volume("{names[0]}") = {{out[1]}};\n')
    for name, face in zip(names[1:], (f"{first + 1}", "out[0]", "out[2]",
                                      "out[4]")):
        if name:
            text += f"{name}[] += {{{face}}};\n"
    return text + "Plane_y[] += {out[3]}; Plane_x[] += {out[5]};\n"


def mesh(name, *parts):
    groups = sorted(set(re.findall(r"^(\w+)\[\] \+=", "".join(parts), re.M)) |
                    {"Plane_x", "Plane_y"})
    pathlib.Path(f"{name}.geo").write_text("\n".join([
        *(f"{group}[] = {{}};" for group in groups), SECTOR, *parts,
        *(f'Physical Surface("{group}") = {{{group}[]}};' for group in groups)]))
    subprocess.run(["gmsh", "-3", "-format", "msh22", f"{name}.geo", "-o",
                    f"{name}.msh"], check=True, capture_output=True)


def bolt():
    """The head of a hollow bolt on a plate, in two tubes that are tied."""
    mesh("bolt",
         sector(0, 2, 5, -20, 4, 2, 6, ("Shank", "Root", "End", "", "")),
         sector(100, 2, 9, 5, 4, 3, 2, ("Head", "Seat", "", "", "")),
         sector(200, 5.5, 20, -10, 5, 4, 3, ("Plate", "Face", "", "", "Rim")))
    return {
        "Mesh/File": "bolt.msh",
        "Mesh/Move": "Head: 0, 0, -100; Plate: 0, 0, -200",
        "Mesh/Points": "H in Head: 9, 0, 105; S in Plate: 5.5, 0, 190",
        "Solids/Young's modulus": "Shank: 210000, Head: 210000, Plate: 70000",
        "Solids/Poisson's ratio": "Shank: 0.3, Head: 0.3, Plate: 0.33",
        "Boundary conditions/Displacement x": "Plane_x: 0",
        "Boundary conditions/Displacement y": "Plane_y: 0",
        "Boundary conditions/Displacement z": "Rim: 0, End: -0.05",
        "Contact seat/Slave": "Face", "Contact seat/Master": "Seat",
        "Contact seat/Friction coefficient": 0.15,
        "Contact root/Slave": "Root", "Contact root/Master": "Seat",
        "Contact root/Tied": "true",
        "Probes/Probes": "pull: reaction z, End; head: displacement z, H; "
                         "bore: displacement x, S"}


def bush():
    mesh("bush",
         sector(0, 10, 14, 20, 5, 2, 5, ("Bush", "Plane_z", "", "", "Journal")),
         sector(100, 14, 25, 12, 4, 3, 3, ("Hub", "Plane_z", "", "Bore", "")))
    return {
        "Mesh/File": "bush.msh", "Element/Degree": 2, "Mesh/Move": "Hub: 0, 0, -100",
        "Mesh/Cylinders": "Journal: 0, 0, 0, 0, 0, 1, 14; "
                          "Bore: 0, 0, 0, 0, 0, 1, 14",
        "Mesh/Points": "E in Bush: 10, 0, 20; R in Hub: 25, 0, 100; "
                       "Q in Hub: 14, 0, 100",
        "Solids/Young's modulus": "Bush: 110000, Hub: 210000",
        "Solids/Poisson's ratio": "Bush: 0.34, Hub: 0.3",
        "Boundary conditions/Displacement x": "Plane_x: 0",
        "Boundary conditions/Displacement y": "Plane_y: 0",
        "Boundary conditions/Displacement z": "Plane_z: 0",
        "Contact/Slave": "Bore", "Contact/Master": "Journal",
        "Contact/Interference": "0.02*t",
        "Contact/Friction coefficient": 0.15,
        "Probes/Probes": "end: displacement x, E; rim: displacement x, R; "
                         "hoop: stress yy, Q"}


def case(path, probes, **more):
    result = {"include": path, "Probes/Probes": probes, "Probes/References": "",
              "Probes/Tolerances": "", "Output/Profile": "false",
              "Solution/Increments": 1}
    for key, value in more.items():
        result[key.replace("__", "/").replace("_", " ")] = value
    return result


SPACE = {
    "sphere": lambda: case(CASES / "sphere_on_plane.prm",
                           "force: reaction z, Top; peak: pressure, Pole"),
    "crossed": lambda: case(CASES / "crossed_cylinders.prm",
                            "force: reaction z, Bottom; "
                            "peak: pressure, Lower_pole"),
    "punch": lambda: case(CASES / "square_punch.prm",
                          "push: reaction z, Head; drag: reaction x, Head"),
    "bolt": bolt, "bush": bush,
    "spheres": lambda: case(CASES / "thick_spheres.prm",
                            "bore: displacement x, Bore_x; "
                            "p: pressure, Inner_x; energy: strain energy, Inner"),
    "cap": lambda: case(ROOT / "parameters" / "nested_space_friction.prm",
                        "u: displacement z, B; p: pressure, C; "
                        "force: reaction z, Base", Solution__Increments=2),
    "lug": lambda: case(ROOT / "parameters" / "examples" / "lug.prm",
                        "pull: reaction x, Foot; energy: strain energy, Lug",
                        Mesh__Size=12, Output__VTU="false")}



def main():
    scenes = {name: scene() for name, scene in SPACE.items()
              if name in sys.argv[2:] or len(sys.argv) == 2}
    runs, probes = {}, {}
    for scene, values in scenes.items():
        pathlib.Path(f"{scene}.prm").write_text(parameter_file(values))
        probes[scene] = [probe.split(":")[0].strip()
                         for probe in values["Probes/Probes"].split(";")]
        for probe, percent in itertools.product(probes[scene], REQUESTS):
            runs[f"{scene}-{probe}-{percent:g}"] = {
                "Probes/Accuracy": f"{probe}: {percent} %",
                "Refinement/Levels": 0,
                "Refinement/Limits": f"unknowns: {LIMIT}"}
        runs[f"{scene}-uniform"] = {"Refinement/Levels": LEVELS.get(scene, 3),
                                    "Refinement/Tolerance": 1e-8}
    solve(runs)
    bars = Bars()
    print("| scene | probe | asked | printed | true | exit status | unknowns | "
          "s |\n|---|---|---|---|---|---|---|---|")
    for scene, names in probes.items():
        sequence = summary(f"{scene}-uniform")
        for probe, percent in itertools.product(names, REQUESTS):
            known = (limit([level["probes"][probe]
                            for level in sequence["levels"]])
                     if sequence and sequence["converged"] else
                     (math.nan, math.inf))
            row = bars.row(scene, probe, percent,
                           summary(f"{scene}-{probe}-{percent:g}"), *known)
            if row:
                print(row)
    print(bars.summary())


if __name__ == "__main__":
    main()
