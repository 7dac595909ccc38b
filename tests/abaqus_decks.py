#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Abaqus decks, converted and run.

Proves that meshes/convert.py makes of a deck

- with two steps and friction (CPE4) the results of the same case by hand;
- of two discs (CAX8) and of distorted hexahedra (C3D20R) under pressure the
  uniform state, and of rings whose sides are round (CPE8R, C3D20R) Lame's: the
  nodes are where gmsh's order has them;
- with parts, instances that are moved and turned, and sets by GENERATE the
  results of the same deck without parts;
- of bars that yield (CAX4) and of rubber the forces of their closed forms;
- the entries of a rigid surface, amplitudes, weight and a deck for all else, word
  for word, with what is left out;
- of a wrong deck an error with its place, and no file.

Usage: abaqus_decks.py CONTACT
"""

import itertools
import math
import pathlib
import subprocess
import sys

import block_scenes
from block_scenes import Mesh, box, failures, run, solve

CONVERTER = pathlib.Path(__file__).resolve().parents[1] / "meshes/convert.py"

# Nodes of elements in half steps, as Abaqus numbers them, and the faces of boxes.
QUAD = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))
BRICK = ((0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0),
         (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
         (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0),
         (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
         (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1))
QUAD_FACES = {"y0": "S1", "x1": "S2", "y1": "S3", "x0": "S4"}
BRICK_FACES = {"z0": "S1", "z1": "S2", "y0": "S3", "x1": "S4", "y1": "S5",
               "x0": "S6"}
# The edges of gmsh's hexahedron of 20 nodes, behind the corners.
GMSH_EDGES = ((0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7),
              (4, 5), (4, 7), (5, 6), (6, 7))


def check(what, ok, detail=""):
    block_scenes.check(what, ok, "" if ok else detail)


class Box:
    """A lattice of elements, the image of a unit square or cube."""

    def __init__(self, name, code, n, chart, first=1):
        self.name, self.n, self.code = name, n, code
        offsets = QUAD if len(n) == 2 else BRICK
        offsets = offsets[:int(code.strip("CPESAXD3RI"))] if "C3D" not in code \
            else offsets[:20 if "20" in code else 8]
        self.faces = QUAD_FACES if len(n) == 2 else BRICK_FACES
        self.places, self.label, self.cells = {}, {}, {}
        for cell in itertools.product(*(range(0, 2 * m, 2) for m in n)):
            nodes = []
            for offset in offsets:
                i = tuple(map(sum, zip(cell, offset)))
                if i not in self.label:
                    self.label[i] = first + len(self.label)
                    self.places[i] = chart(*(c / (2 * m) for c, m in zip(i, n)))
                nodes.append(self.label[i])
            self.cells[cell] = first + len(self.cells), nodes

    def is_on(self, i, side):
        d = "xyz".index(side[0])
        return i[d] == 2 * self.n[d] * int(side[1])

    def text(self):
        """Nodes, elements, sets and surfaces NAME_x0 ..."""
        lines = ["*NODE"]
        lines += [f"{self.label[i]}, " + ", ".join(map(repr, map(float, p)))
                  for i, p in self.places.items()]
        lines += [f"*ELEMENT, TYPE={self.code}, ELSET={self.name}"]
        for label, nodes in self.cells.values():
            numbers = [label, *nodes]
            lines += [", ".join(map(str, numbers[:12])) + ","
                      * (len(numbers) > 12)]
            lines += [", ".join(map(str, numbers[12:]))] * (len(numbers) > 12)
        for side, face in self.faces.items():
            d = "xyz".index(side[0])
            last = 2 * self.n[d] - 2 if side[1] == "1" else 0
            lines += [f"*NSET, NSET={self.name}_{side}"]
            lines += [f"{self.label[i]}" for i in self.label
                      if self.is_on(i, side)]
            lines += [f"*ELSET, ELSET={self.name}_{side}_cells"]
            lines += [f"{label}" for cell, (label, _) in self.cells.items()
                      if cell[d] == last]
            lines += [f"*SURFACE, NAME={self.name}_{side}_face",
                      f"{self.name}_{side}_cells, {face}"]
        return "\n".join([*lines, ""])


def elastic(*bodies, modulus=1000, ratio=0.25):
    return "".join(f"*SOLID SECTION, ELSET={body}, MATERIAL=Steel\n"
                   for body in bodies) + \
        f"*MATERIAL, NAME=Steel\n*ELASTIC\n{modulus}, {ratio}\n"


def convert(name, deck, *options):
    pathlib.Path(f"{name}.inp").write_text(deck)
    return subprocess.run([sys.executable, CONVERTER, f"{name}.inp",
                           f"{name}.msh", *options], text=True,
                          capture_output=True)


def values(name, deck, probes, *settings):
    """Values of the converted deck by the names of the probes."""
    done = convert(name, deck)
    if done.returncode:
        return {}, done.stderr
    _, said, summary = solve(pathlib.Path(f"{name}.prm"), "Output/VTU=false",
                             f"Probes/Probes={probes}", *settings)
    return {p["name"]: p["value"] for p in summary.get("probes", ())}, \
        done.stdout + done.stderr + said


def compare(what, found, expected, tolerance):
    found, said = found
    off = {name: abs(found.get(name, math.nan) - value)
           / max(1e-300, abs(value)) for name, value in expected.items()}
    check(what, all(x <= tolerance for x in off.values()),
          f"off by {off} {said}")


# ------------------------------------------------------------------ results

def friction():
    """A block pressed on another one, then dragged."""
    deck = ("*Heading\nA block\n** a comment\n"
            + Box("Low", "CPE4", (8, 3), box(-20, -10, 20, 0)).text()
            + Box("Up", "CPE4R", (5, 3), box(-8, 0, 9, 7), 1000).text()
            + elastic("Low", "Up") + """*SURFACE INTERACTION, NAME=Rough
*FRICTION
 0.3,
*CONTACT PAIR, INTERACTION=rough, TYPE=SURFACE TO SURFACE
Up_y0_face, LOW_Y1_FACE
*STEP, NLGEOM=YES
*STATIC
0.5, 1.
*BOUNDARY
Low_y0, ENCASTRE
Up_y1, 1
Up_y1, 2, 2, -0.02
*END STEP
*STEP,
 NLGEOM=YES
*STATIC
0.5, 1.
*BOUNDARY
Up_y1, 1, 1, 0.01
*END STEP
""")
    mesh = Mesh()
    mesh.block("Low", 8, 3, box(-20, -10, 20, 0),
               {"bottom": "Base", "top": "Ground"})
    mesh.block("Up", 5, 3, box(-8, 0, 9, 7), {"bottom": "Sole", "top": "Head"})
    mesh.write("by_hand")
    _, said, summary = run("by_hand", {
        "Mesh/File": "by_hand.msh",
        "Solids/Young's modulus": "Low: 1000, Up: 1000",
        "Solids/Poisson's ratio": "Low: 0.25, Up: 0.25",
        "Boundary conditions/Displacement x": "Base: 0, Head: 0.01",
        "Boundary conditions/Displacement y": "Base: 0, Head: -0.02",
        "Boundary conditions/Histories":
        "Displacement x: max(0, 2*t - 1); Displacement y: min(1, 2*t)",
        "Contact/Slave": "Sole", "Contact/Master": "Ground",
        "Contact/Friction coefficient": "0.3", "Solution/Increments": "4",
        "Probes/Probes": "x: reaction x, Head; y: reaction y, Head"})
    expected = {p["name"]: p["value"] for p in summary.get("probes", ())}
    check("by hand", len(expected) == 2, said)
    compare("CPE4 with friction, two steps", values(
        "friction", deck, "x: reaction x, Up_y1; y: reaction y, Up_y1"),
        expected, 1e-10)


def uniform():
    """p on discs and on bricks whose inner nodes are off: u = - p h / E."""
    end = """*CONTACT PAIR
Up_{0}0_face, Low_{0}1_face
*STEP
*STATIC
*BOUNDARY
Low_{0}0, {1}SYMM
{2}*DSLOAD
Up_{0}1_face, P, 30.
*END STEP
"""
    deck = (Box("Low", "CAX8", (3, 2), box(0, 0, 10, 6)).text()
            + Box("Up", "CAX8R", (4, 1), box(0, 6, 10, 10), 1000).text()
            + elastic("Low", "Up") + end.format("y", "Y", ""))
    compare("CAX8, two discs", values(
        "discs", deck, "u: displacement y, Tip; p: pressure, Foot; "
        "r: reaction y, Low_y0", "Mesh/Points=Tip: 10, 10; Foot in Up: 5, 6"),
        {"u": -30 * 10 / 1000, "p": 30, "r": 30 * math.pi * 100}, 1e-9)

    def brick(z0, z1):
        def chart(x, y, z):
            bump = 2.5 * x * (1 - x) * y * (1 - y) * z * (1 - z)
            return 6 * x + bump, 6 * y - bump, z0 + (z1 - z0) * z + bump
        return chart

    sides = "Low_x0, XSYMM\nUp_x0, XSYMM\nLow_y0, YSYMM\nUp_y0, YSYMM\n"
    deck = (straight(Box("Low", "C3D20R", (2, 2, 2), brick(0, 4))).text()
            + straight(Box("Up", "C3D20R", (3, 2, 2), brick(4, 9), 5000)).text()
            + elastic("Low", "Up") + end.format("z", "Z", sides))
    compare("C3D20R, distorted", values(
        "bricks", deck, "u: displacement z, Tip; p: pressure, Foot; "
        "s: stress zz, Tip", "Mesh/Points=Tip: 6, 6, 9; Foot in Up: 4, 3, 4"),
        {"u": -30 * 9 / 1000, "p": 30, "s": -30}, 1e-9)
    check("C3D20R: gmsh's order", middles_are_right("bricks.msh"))


def straight(bricks):
    """The same with its mid-side nodes midway."""
    for i in bricks.places:
        odd = [d for d in range(3) if i[d] % 2]
        if odd:
            ends = [tuple(c + s * (d == odd[0]) for d, c in enumerate(i))
                    for s in (-1, 1)]
            bricks.places[i] = tuple(
                sum(c) / 2 for c in zip(*(bricks.places[e] for e in ends)))
    return bricks


def middles_are_right(name):
    lines = pathlib.Path(name).read_text().split("$Nodes\n")[1].splitlines()
    points = {row[0]: [float(x) for x in row[1:]]
              for row in (line.split() for line in lines[1:int(lines[0]) + 1])}
    cells = [line.split()[5:] for line in lines if line.split()[1:2] == ["17"]]
    return cells and all(
        math.dist(points[cell[8 + k]], [(a + b) / 2 for a, b in zip(
            points[cell[i]], points[cell[j]])]) < 1e-12
        for cell in cells for k, (i, j) in enumerate(GMSH_EDGES))


def rings():
    """A quarter of a tube under pressure inside, with mid-side nodes on circles."""
    a, b, p, modulus, ratio = 10., 20., 8., 1000., 0.25
    u = (1 + ratio) * p * a * a / (modulus * (b * b - a * a)) * (
        (1 - 2 * ratio) * a + b * b / a)

    def chart(s, t, z=None):
        r, angle = a + (b - a) * s, math.pi / 2 * t
        place = (r * math.cos(angle), r * math.sin(angle))
        return place if z is None else (*place, 2 * z)

    for code, n in (("CPE8R", (4, 5)), ("C3D20R", (4, 5, 1))):
        deck = (Box("Tube", code, n, chart).text() + elastic("Tube") + """*STEP
*STATIC
*BOUNDARY
Tube_y0, YSYMM
Tube_y1, XSYMM
""" + "Tube_z0, ZSYMM\nTube_z1, ZSYMM\n" * (len(n) == 3) + """*DSLOAD
Tube_x0_face, P, 8.
*END STEP
""")
        at = "10, 0, 2" if len(n) == 3 else "10, 0"
        compare(f"{code}, round sides", values(
            "tube", deck, "u: displacement x, Bore", f"Mesh/Points=Bore: {at}"),
            {"u": u}, 2e-4)


PARTS = """*PART, NAME=Brick
{}*SOLID SECTION, ELSET=Brick, MATERIAL=Steel
*END PART
*ASSEMBLY, NAME=Assembly
*INSTANCE, NAME=Low, PART=Brick
*END INSTANCE
*INSTANCE, NAME=Up, PART=BRICK
 8., 8., 0.
 8., 8., 0., 8., 8., 1., 90.
*END INSTANCE
*NSET, NSET=Base, INSTANCE=Low, GENERATE
{}
*NSET, NSET=Head
Up.Brick_x1
*ELSET, ELSET=Sole_cells, INSTANCE=Up, GENERATE
1, 4
*SURFACE, NAME=Sole, TYPE=ELEMENT
Sole_cells, S4
*SURFACE, NAME=Ground, TYPE=NODE
Low.Brick_y1
*END ASSEMBLY
"""
SCENE = """*MATERIAL, NAME=Steel
*ELASTIC
1000., .25
*SURFACE INTERACTION, NAME=Rough
*FRICTION
0.3
*CONTACT PAIR, INTERACTION=Rough
{}
*STEP, NLGEOM
*STATIC
1., 1.
*BOUNDARY
{}, ENCASTRE
{}, 1, 1, 0.01
{}, 2, 2, -0.05
*END STEP
"""


def parts():
    """A part that stands on itself, turned, is two boxes."""
    chart, n = box(0, 0, 12, 8), (6, 4)
    brick = Box("Brick", "CPE4", n, chart)
    upper = Box("Up", "CPE4", n, lambda s, t: (8 - 8 * t, 8 + 12 * s), 1000)
    flat = (Box("Low", "CPE4", n, chart).text() + upper.text()
            + elastic("Low", "Up")
            + SCENE.format("Up_x0_face, Low_y1_face", "Low_y0", "Up_x1", "Up_x1"))
    probes = "x: reaction x, {0}; y: reaction y, {0}"
    expected, said = values("flat", flat, probes.format("Up_x1"))
    check("a deck without parts", len(expected) == 2, said)
    # The nodes of the lower side, by rows of GENERATE.
    base = [brick.label[i] for i in brick.label if i[1] == 0]
    deck = PARTS.format(brick.text(), "\n".join(f"{n}, {n}" for n in base)) \
        + SCENE.format("Sole, Ground", "Base", "Head", "Head")
    compare("parts and instances", values("parts", deck, probes.format("Head")),
            expected, 1e-10)
    said = convert("parts", deck).stdout
    check("names of instances", "bodies: Low.Brick (24), Up.Brick (24)\n" in said
          and "Sole (4)" in said and "Ground (6)" in said, said)


BAR = """*SOLID SECTION, ELSET=Bar, MATERIAL=Soft
*MATERIAL, NAME=Soft
{}*STEP, NLGEOM={}
*STATIC
0.1, 1.
*BOUNDARY
Bar_y0, YSYMM
Bar_y1, 2, 2, {}
*END STEP
"""


def bars():
    """Pulled, with free sides: the force is stress times area."""
    bar = Box("Bar", "CAX4", (2, 2), box(0, 0, 2, 3)).text()
    area = 4 * math.pi
    strain, modulus, slope = 0.012, 20000, 30 / 0.01
    plastic = (strain - 100 / modulus) / (1 + slope / modulus)
    law = "*ELASTIC\n20000., 0.3\n*PLASTIC{}\n100., 0.\n130., .01\n"
    for hardening in ("", ", HARDENING=KINEMATIC"):
        compare("a bar that yields" + hardening, values(
            "yields", bar + BAR.format(law.format(hardening), "NO", 3 * strain),
            "f: reaction y, Bar_y1"), {"f": (100 + slope * plastic) * area}, 1e-7)
    x = 1.3
    for law, c10, c01 in (("NEO HOOKE\n0.5, 0.", 0.5, 0),
                          ("MOONEY-RIVLIN\n0.3, 0.2, 0.", 0.3, 0.2)):
        compare(f"a bar of rubber, {law[:6]}", values(
            "rubber", bar.replace("CAX4", "CAX4H") + BAR.format(
                f"*HYPERELASTIC, {law}\n", "YES", 3 * (x - 1)),
            "f: reaction y, Bar_y1"),
            {"f": 2 * (x - x ** -2) * (c10 + c01 / x) * area}, 1e-3)


# ------------------------------------------------------------------ entries

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
# left out: *ELEMENT, line 12: CPS4: there is no plane stress, this case is plane strain
# left out: *SOLID SECTION, line 62: a thickness of 2: forces here are per mm of thickness, those of *CLOAD are divided by it
# left out: *EXPANSION, line 69: give Solids/Thermal strain
# left out: *FRICTION, line 72: TAUMAX: friction is one number, Contact/Friction coefficient
# left out: *CONTACT PAIR, line 74: ADJUST: no such entry; surfaces are where they are drawn, and slide as far as they do
# left out: *OUTPUT, line 87: see the sections Output and Probes
# left out: *NODE OUTPUT, line 88: see the sections Output and Probes
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

subsection Output
  set VTU = true
end
"""


def loads():
    """Nodal forces, also at mid-side nodes, are those of a traction; the first
    part of a deck is in a file of its own. An edge is a curve, the other nodes of
    a set are points."""
    plate = Box("Plate", "CPE8", (2, 2), box(0, 0, 6, 4))
    end = """*STEP
*STATIC
*BOUNDARY
Plate_y0, PINNED
"""
    pathlib.Path("plate.inc").write_text(plate.text() + elastic("Plate"))
    forces = {i: 5 * 3 * (1 / 3 if i[0] in (0, 4) else 4 / 3 if i[0] % 2 else 2 / 3)
              / 2 for i in plate.label if plate.is_on(i, "y1")}
    deck = "*INCLUDE, INPUT=plate.inc\n" + end + "*CLOAD\n" + "".join(
        f"{plate.label[i]}, 1, {f!r}\n" for i, f in forces.items())
    expected, _ = values("traction", "*INCLUDE, INPUT=plate.inc\n" + end
                         + "*DSLOAD\nPlate_y1_face, TRVEC, 5., 1., 0.\n",
                         "u: displacement x, Tip", "Mesh/Points=Tip: 6, 4")
    compare("CLOAD at mid-side nodes", values(
        "nodal", deck, f"u: displacement x, Node_{plate.label[4, 4]}"),
        expected, 1e-10)


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


def faults():
    def wrong(what, old, new, error, where, remedy):
        refuse(what, "wrong", PLATE.replace(old, new) if old else PLATE + new, (),
               error, "wrong.inp, line " + where, remedy)

    types = ("mesh with CPE, CAX or CPS of 3, 4, 6 or 8 nodes or with C3D8 or "
             "C3D20, and delete elements that are no volumes or areas")
    wrong("an unknown element", "CPE4", "CPE5", "elements of type CPE5 are not read",
          "6, *ELEMENT", types)
    wrong("a coupled element", "CPE4", "CPE4T",
          "elements of type CPE4T are not read", "6, *ELEMENT", types)
    wrong("tetrahedra", "CPE4", "C3D4",
          "the mesh has tetrahedra, prisms or pyramids (elements of type tetra)",
          "7, *ELEMENT, TYPE=C3D4", "mesh volumes with hexahedra of 8, 20 or 27 "
          "nodes, by extrusion or mapping of quadrangles")
    wrong("a node that is missing", "1, 2, 3, 4", "1, 2, 3, 17",
          "element 1 has the node 17, which does not exist", "7, *ELEMENT",
          "the deck has 4 nodes, 1 to 4; correct the number")
    wrong("too few nodes", "1, 2, 3, 4", "1, 2, 3",
          "element 1 has 3 nodes, one of type CPE4 has 4", "7, *ELEMENT",
          "write the number of the element and its nodes")
    wrong("a number", "1., 0.\n", "1.o, 0.\n", "'1.o' is no number", "3, *NODE",
          "write a number in field 2")
    wrong("two nodes", "4, 0., 1.", "3, 0., 1.", "there are two nodes 3",
          "5, *NODE", "delete one of them")
    wrong("a face", None, "*Surface, Name=Sole\nPlate, S7\n",
          "element 1 of type CPE4 has no face S7", "13, *SURFACE",
          "its faces are S1 to S4")
    wrong("a set of a surface", None, "*SURFACE, NAME=Sole\nPlates, S1\n",
          "there is no element set 'Plates'", "13, *SURFACE",
          "of this kind there are: Plate")
    wrong("a set of a support", None, "*STEP\n*BOUNDARY\nBase, 1\n",
          "there is no node set 'Base'", "14, *BOUNDARY",
          "of this kind there are: none")
    wrong("a node of a set", None, "*NSET, NSET=Base\n1, 5\n",
          "there is no node 5", "13, *NSET",
          "the deck has 4 nodes, 1 to 4; correct the number")
    wrong("a surface of a pair", None, "*CONTACT PAIR\nSole, Ground\n",
          "there is no surface 'Sole'", "13, *CONTACT PAIR",
          "of this kind there are: none")
    wrong("a material", "MATERIAL=Steel", "MATERIAL=Stel",
          "there is no material 'Stel'", "8, *SOLID SECTION", "materials: STEEL")
    wrong("a generator", None, "*NGEN\n1, 2\n", "*NGEN is not read", "12, *NGEN",
          "write a deck with all nodes and elements, and global coordinates, as "
          "the preprocessor or Abaqus' data file has them")
    wrong("a procedure", None, "*STEP\n*DYNAMIC\n", "*DYNAMIC is no static step",
          "13, *DYNAMIC", "delete the step, or make it *STATIC")
    wrong("a part", None, "*INSTANCE, NAME=A, PART=B\n*END INSTANCE\n",
          "there is no part 'B'", "12, *INSTANCE",
          "parts stand before the assembly: none")
    wrong("a file", None, "*INCLUDE, INPUT=absent.inp\n",
          "the file 'absent.inp' does not exist", "12, *INCLUDE", "correct INPUT=")


if __name__ == "__main__":
    friction()
    uniform()
    rings()
    parts()
    bars()
    loads()
    punches()
    entries()
    faults()
    sys.exit(bool(failures))
