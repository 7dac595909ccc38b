#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries that meshes/convert.py makes of Abaqus decks.

Proves that a deck with a rigid surface, amplitudes, weight, and much that the
program has no entry for is the case that is expected, word for word, with what is
left out; that rigid surfaces are obstacles on the side where the body is not; and
that a wrong deck is an error with its place, exit status 2, and no file.

Usage: abaqus_entries.py CONTACT
"""

import pathlib
import sys

from abaqus_scenes import Box, check, convert, elastic
from block_scenes import box, failures, solve

ALL = """*HEADING
all that there is
*AMPLITUDE, NAME=There-and-back
0., 0., 0.25, 1., 1., 0.
*NODE
9001, 0., 20.
*SURFACE, TYPE=SEGMENTS, NAME=Tool
START, -5., 20.
CIRCL, 5., 20., 0., 20.1
*RIGID BODY, ANALYTICAL SURFACE=Tool, REF NODE=9001
*SOLID SECTION, ELSET=Low, MATERIAL=Steel
2.,
*MATERIAL, NAME=Steel
*DENSITY
8e-9,
*ELASTIC
210000., 0.3
*EXPANSION
1e-5,
*SURFACE INTERACTION, NAME=Rough
*FRICTION, TAUMAX=20.
0.1,
*CONTACT PAIR, INTERACTION=Rough, TYPE=NODE TO SURFACE, ADJUST=0.1
Low_y1_face, Tool
*BOUNDARY
Low_y0, PINNED
9001, 1
9001, 6
*STEP, NLGEOM=YES
*STATIC
0.25, 2.
*BOUNDARY
9001, 2, 2, -7.2
*DLOAD
Low, GRAV, 9810., 0., -1.
*OUTPUT, FIELD
*NODE OUTPUT
U,
*END STEP
*STEP, NLGEOM=YES
*STATIC
0.5, 1.
*CLOAD
{tip}, 1, 6.
*BOUNDARY, AMPLITUDE=There-and-back
9001, 1, 1, 0.2
*DSLOAD
Low_x0_face, P, 3.
*DLOAD
Low_x1_cells, P2, 4.
*EL PRINT
S
*END STEP
"""
CASE = """# Written by meshes/convert.py from all.inp
# left out: *ELEMENT, line 12: CPS4: plane stress is that of elastic bodies in small strain, this case is plane strain
# left out: *SOLID SECTION, line 62: a thickness of 2: forces here are per mm of thickness, those of *CLOAD are divided by it
# left out: *EXPANSION, line 69: give Solids/Thermal strain
# left out: *FRICTION, line 72: TAUMAX: friction is one number, Contact/Friction coefficient
# left out: *CONTACT PAIR, line 74: ADJUST: no such entry; surfaces are where they are drawn, and slide as far as they do
# left out: *OUTPUT, line 87: see the sections Output and Probes
# left out: *NODE OUTPUT, line 88: U: see the sections Output and Probes
# left out: *DSLOAD, line 99: a pressure that turns with its surface: it keeps the normal of the undeformed one
# left out: *DLOAD, line 101: a pressure that turns with its surface: it keeps the normal of the undeformed one
# left out: *EL PRINT, line 102: see the sections Output and Probes

subsection Mesh
  set File = all.msh
end

subsection Element
  set Degree = 1
end

subsection Solids
  set Young's modulus = Low: 210000
  set Poisson's ratio = Low: 0.3
  set Kinematics = large displacement
end

subsection Boundary conditions
  set Body force y = Low: -7.848e-05
  set Displacement x = Low_y0: 0
  set Displacement y = Low_y0: 0
  set Force x = Node_9: 3
  set Pressure = Low_x0_face: 3; Low_x1_cells_P2: 4
  set Histories = Body force y: table(0 0, 0.5 1, 1 1); Force x: table(0 0, 0.5 0, 1 1); Pressure: table(0 0, 0.5 0, 1 1)
end

subsection Contact
  set Slave = Low_y1_face
  set Obstacle = circle: 0, 20.1, 5.00099990002
  set Friction coefficient = 0.1
  set Discretization = nodal
  set Obstacle motion = x: table(0 0, 0.5 0, 0.625 0.2, 1 0); y: table(0 0, 0.5 -7.2, 1 -7.2)
  set Obstacle centre = 0, 20
end

subsection Solution
  set Increments = 16
end

subsection Probes
  set Probes = support x Low_y0: support x, Low_y0; support y Low_y0: support y, Low_y0; contact force x Low_y1_face: contact force x, Low_y1_face; contact force y Low_y1_face: contact force y, Low_y1_face
end

subsection Output
  set VTU = true
  set Profile = true
end
"""


PUNCHES = {
    # From the left side down, along the sole and up; and the other way.
    "profile: -10, 20, 0, -10, 10, 2.999999997, 10, 10, 2.999999997, 10, 20, 0": (
        "START, -10., 20.\nLINE, -10., 13.\nCIRCL, -7., 10., -7., 13.\n"
        "LINE, 7., 10.\nCIRCL, 10., 13., 7., 13.\nLINE, 10., 20.\n",
        "START, 10., 20.\nLINE, 10., 13.\nCIRCL, 7., 10., 7., 13.\n"
        "LINE, -7., 10.\nCIRCL, -10., 13., -7., 13.\nLINE, -10., 20.\n"),
    "half plane: -9, 10, 0, -1": (
        "START, -9., 10.\nLINE, 9., 10.\n",),
    "circle: 0, 13, 3": (
        "START, -3., 13.\nCIRCL, 0., 10., 0., 13.\nCIRCL, 3., 13., 0., 13.\n",),
    "circle: 0, 0, -12": (  # a hole around the body
        "START, 12., 0.\nCIRCL, 0., 12., 0., 0.\nCIRCL, -12., 0., 0., 0.\n",)}


def punches():
    """Rigid surfaces are on the side where the body is not."""
    low = Box("Low", "CPE4", (2, 2), box(-4, 0, 4, 8))
    for shape, outlines in PUNCHES.items():
        for outline in outlines:
            deck = low.text() + elastic("Low") + (
                f"*NODE\n9001, 0., 20.\n*SURFACE, TYPE=SEGMENTS, NAME=Tool\n"
                f"{outline}*RIGID BODY, ANALYTICAL SURFACE=Tool, REF NODE=9001\n"
                "*CONTACT PAIR\nLow_y1_face, Tool\n*STEP\n*STATIC\n1., 1.\n"
                "*BOUNDARY\nLow_y0, PINNED\n9001, 1\n9001, 6\n*CLOAD\n"
                "9001, 2, -5.\n")
            done = convert("punch", deck)
            status, said, _ = solve(pathlib.Path("punch.prm"))
            text = pathlib.Path("punch.prm").read_text()
            check(f"a rigid surface, {shape}", f"  set Obstacle = {shape}\n" in text
                  and "  set Obstacle force = y: -5*t\n" in text and status == 0,
                  done.stderr + text + said)


def entries():
    """Word for word; and the program takes them."""
    low = Box("Low", "CPS4", (2, 2), box(-8, 0, 8, 8))
    done = convert("all", low.text() + ALL.format(tip=low.label[4, 4]))
    text = pathlib.Path("all.prm").read_text()
    check("the entries of a case", text == CASE, done.stderr + text)
    said = "".join(line[2:] + "\n" for line in CASE.splitlines()
                   if line.startswith("# left out"))
    check("what is left out is on the screen", done.stdout.startswith(said), said)
    status, said, _ = solve(pathlib.Path("all.prm"))
    check("the case runs", status == 0, said)

    asked = ALL.format(tip=low.label[4, 4]).replace(
        "*EL PRINT\nS\n", "*NODE PRINT, NSET=Low_y0\nRF2, S\n"
        f"*NSET, NSET=Tip\n{low.label[4, 4]}\n*NODE PRINT, NSET=Tip\nU\n")
    done = convert("asked", low.text() + asked)
    status, said, summary = solve(pathlib.Path("asked.prm"))
    found = {p["name"]: p["value"] for p in summary["probes"]}
    last = summary["increments"][-1]["reactions"]["Low_y0"]
    check("what *NODE PRINT asks for is probed", status == 0 and list(found) == [
        "support y Low_y0", "displacement x Tip", "displacement y Tip",
        "contact force x Low_y1_face", "contact force y Low_y1_face"] and
        abs(found["support y Low_y0"] / last["y"] - 1) < 1e-9, (said, found))
    check("and what else it asks for is left out", "RF" not in done.stdout and
          "*NODE PRINT, line 102: S: see the sections" in done.stdout, done.stdout)

    convert("thin", PLATE.replace("CPE4", "CPS4") + "*STEP\n*STATIC\n*END STEP\n")
    check("plane stress of an elastic body in small strain",
          "  set Symmetry = plane stress\n" in pathlib.Path("thin.prm").read_text())

    bare = PLATE.replace("*SOLID SECTION, ELSET=Plate, MATERIAL=Steel\n", "")
    convert("bare", bare + "*STEP\n*STATIC\n")
    check("the only material is that of a body without a section",
          "  set Young's modulus = Plate: 1000\n"
          in pathlib.Path("bare.prm").read_text())
    convert("mesh_only", bare)
    check("a deck without sections and steps is a mesh alone",
          not pathlib.Path("mesh_only.prm").exists())

    pathlib.Path("own.prm").write_text("# mine\n")
    refuse("a case of the user's stays", "own", PLATE, (), "the case would take the "
           "place of a file that convert.py has not written", "own.prm",
           "name another OUT.msh, or remove the file", files=["own.prm"])
    check("it stays", pathlib.Path("own.prm").read_text() == "# mine\n")


# ------------------------------------------------------------------- faults

PLATE = """*NODE
1, 0., 0.
2, 1., 0.
3, 1., 1.
4, 0., 1.
*ELEMENT, TYPE=CPE4, ELSET=Plate
1, 1, 2, 3, 4
*SOLID SECTION, ELSET=Plate, MATERIAL=Steel
*MATERIAL, NAME=Steel
*ELASTIC
1000., 0.3
"""


def refuse(what, name, deck, options, error, where, remedy, files=()):
    """An error, word for word, exit status 2 and no other files."""
    done = convert(name, deck, *options)
    expected = f"error:  {error}\nwhere:  {where}\nremedy: {remedy}\n"
    check(what, done.returncode == 2 and done.stderr == expected,
          done.stderr + done.stdout)
    found = sorted(str(p) for p in pathlib.Path().glob(f"{name}.*"))
    check(what + ": no file", found == sorted([f"{name}.inp", *files]), found)


TYPES = ("mesh with CPE, CAX or CPS of 3, 4, 6 or 8 nodes or with C3D4, C3D8, "
         "C3D10 or C3D20, and delete elements that are no volumes or areas")
# What is wrong, what of the plate is replaced (or else appended), by what; error,
# place and remedy.
FAULTS = (
    ("an unknown element", "CPE4", "CPE5", "elements of type CPE5 are not read",
     "6, *ELEMENT", TYPES),
    ("a coupled element", "CPE4", "CPE4T",
     "elements of type CPE4T are not read", "6, *ELEMENT", TYPES),
    ("prisms", "CPE4, ELSET=Plate\n1, 1, 2, 3, 4",
     "C3D15, ELSET=Plate\n1, 1, 2, 3, 4, 1, 2, 1, 2, 3, 4, 1, 2, 3, 4, 1",
     "the mesh has prisms or pyramids of second order (elements of type wedge15)",
     "7, *ELEMENT, TYPE=C3D15", "mesh volumes with tetrahedra of 4 or 10 nodes, "
     "with hexahedra of 8, 20 or 27, or with prisms and pyramids of first order, "
     "which contact splits"),
    ("a node that is missing", "1, 2, 3, 4", "1, 2, 3, 17",
     "element 1 has the node 17, which does not exist", "7, *ELEMENT",
     "the deck has 4 nodes, 1 to 4; correct the number"),
    ("too few nodes", "1, 2, 3, 4", "1, 2, 3",
     "element 1 has 3 nodes, one of type CPE4 has 4", "7, *ELEMENT",
     "write the number of the element and its nodes"),
    ("a number", "1., 0.\n", "1.o, 0.\n", "'1.o' is no number", "3, *NODE",
     "write a number in field 2"),
    ("two nodes", "4, 0., 1.", "3, 0., 1.", "there are two nodes 3",
     "5, *NODE", "delete one of them"),
    ("a face", None, "*Surface, Name=Sole\nPlate, S7\n",
     "element 1 of type CPE4 has no face S7", "13, *SURFACE",
     "its faces are S1 to S4"),
    ("a set of a surface", None, "*SURFACE, NAME=Sole\nPlates, S1\n",
     "there is no element set 'Plates'", "13, *SURFACE",
     "of this kind there are: Plate"),
    ("a set of a support", None, "*STEP\n*BOUNDARY\nBase, 1\n",
     "there is no node set 'Base'", "14, *BOUNDARY",
     "of this kind there are: none"),
    ("a node of a set", None, "*NSET, NSET=Base\n1, 5\n",
     "there is no node 5", "13, *NSET",
     "the deck has 4 nodes, 1 to 4; correct the number"),
    ("a surface of a pair", None, "*CONTACT PAIR\nSole, Ground\n",
     "there is no surface 'Sole'", "13, *CONTACT PAIR",
     "of this kind there are: none"),
    ("a material", "MATERIAL=Steel", "MATERIAL=Stel",
     "there is no material 'Stel'", "8, *SOLID SECTION", "materials: STEEL"),
    ("a generator", None, "*NGEN\n1, 2\n", "*NGEN is not read", "12, *NGEN",
     "write a deck with all nodes and elements, and global coordinates, as "
     "the preprocessor or Abaqus' data file has them"),
    ("a procedure", None, "*STEP\n*DYNAMIC\n", "*DYNAMIC is no static step",
     "13, *DYNAMIC", "delete the step, or make it *STATIC"),
    ("a part", None, "*INSTANCE, NAME=A, PART=B\n*END INSTANCE\n",
     "there is no part 'B'", "12, *INSTANCE",
     "parts stand before the assembly: none"),
    ("an instance without its end", None, "*PART, NAME=A\n*INSTANCE, NAME=A1\n",
     "*PART does not end", "12, *PART", "write *END PART before line 13"),
    ("a file", None, "*INCLUDE, INPUT=absent.inp\n",
     "the file 'absent.inp' does not exist", "12, *INCLUDE", "correct INPUT="),
)


def faults():
    for what, old, new, error, where, remedy in FAULTS:
        refuse(what, "wrong", PLATE.replace(old, new) if old else PLATE + new, (),
               error, "wrong.inp, line " + where, remedy)


if __name__ == "__main__":
    punches()
    entries()
    faults()
    sys.exit(bool(failures))
