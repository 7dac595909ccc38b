#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of Abaqus decks that meshes/convert.py converts.

Proves that

- a deck with two steps and friction (CPE4), also with an elastic slip, gives those of
  the same case by hand;
- two discs (CAX8), distorted hexahedra (C3D20R) and tetrahedra beside them (C3D4,
  C3D10M) under pressure are in a uniform state, and rings whose sides are round
  (CPE8R, C3D20R, C3D10) in Lame's: the nodes are where gmsh's order has them;
- parts, instances that are moved and turned, and sets by GENERATE give those of the
  same deck without parts;
- bars that yield (CAX4) and bars of rubber have the forces of their closed forms;
- forces at nodes, also at mid-side nodes, are those of a traction;
- two contact pairs with friction of their own above a tie drag with their parts of
  the given forces, to 2e-5, and a tie of hexahedra that do not match passes a uniform
  tension, to 1e-9.

Usage: abaqus.py CONTACT
"""

import math
import pathlib
import sys

from abaqus_scenes import Box, Tetrahedra, check, compare, convert, elastic, values
from block_scenes import Mesh, box, failures, run

# The edges of gmsh's hexahedron of 20 and tetrahedron of 10 nodes, behind the
# corners.
GMSH_EDGES = {"17": ((0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7),
                     (4, 5), (4, 7), (5, 6), (6, 7)),
              "11": ((0, 1), (1, 2), (2, 0), (3, 0), (3, 2), (3, 1))}


PRESS_AND_DRAG = """*SURFACE INTERACTION, NAME=Rough
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
"""


def friction():
    """A block pressed on another one, then dragged."""
    deck = ("*Heading\nA block\n** a comment\n"
            + Box("Low", "CPE4", (8, 3), box(-20, -10, 20, 0)).text()
            + Box("Up", "CPE4R", (5, 3), box(-8, 0, 9, 7), 1000).text()
            + elastic("Low", "Up") + PRESS_AND_DRAG)
    mesh = Mesh()
    mesh.block("Low", 8, 3, box(-20, -10, 20, 0),
               {"bottom": "Base", "top": "Ground"})
    mesh.block("Up", 5, 3, box(-8, 0, 9, 7), {"bottom": "Sole", "top": "Head"})
    mesh.write("by_hand")
    by_hand = {
        "Mesh/File": "by_hand.msh",
        "Solids/Young's modulus": "Low: 1000, Up: 1000",
        "Solids/Poisson's ratio": "Low: 0.25, Up: 0.25",
        "Boundary conditions/Displacement x": "Base: 0, Head: 0.01",
        "Boundary conditions/Displacement y": "Base: 0, Head: -0.02",
        "Boundary conditions/Histories":
        "Displacement x: max(0, 2*t - 1); Displacement y: min(1, 2*t)",
        "Contact/Slave": "Sole", "Contact/Master": "Ground",
        "Contact/Friction coefficient": "0.3", "Solution/Increments": "4",
        "Probes/Probes": "x: reaction x, Head; y: reaction y, Head"}
    probes = "x: reaction x, Up_y1; y: reaction y, Up_y1"

    def written(**more):
        _, said, summary = run("by_hand", {**by_hand, **more})
        expected = {p["name"]: p["value"] for p in summary.get("probes", ())}
        check("by hand", len(expected) == 2, said)
        return expected
    for option, slip in (("ELASTIC SLIP=0.002", "0.002"),
                         ("SLIP TOLERANCE=5e-4", "0.05 %")):
        compare(option, values("slip", deck.replace(
            "*FRICTION", f"*FRICTION, {option}"), probes),
            written(**{"Contact/Elastic slip": slip}), 1e-10)
    expected = written()
    compare("CPE4 with friction, two steps", values(
        "friction", deck, probes), expected, 1e-10)
    pair = deck[deck.index("*CONTACT PAIR"):deck.index("*STEP")]
    compare("general contact", values("general", deck.replace(pair, (
        "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n"
        "*CONTACT PROPERTY ASSIGNMENT\n, , rough\n")), probes), expected, 1e-9)


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
    for low, up, kinds in (
            (Box("Low", "C3D20R", (2, 2, 2), brick(0, 4)),
             Box("Up", "C3D20R", (3, 2, 2), brick(4, 9), 5000), "17"),
            (Box("Low", "C3D20R", (2, 2, 2), brick(0, 4)),
             Tetrahedra("Up", "C3D10M", (3, 2, 2), brick(4, 9), 5000), "17 11"),
            (Tetrahedra("Low", "C3D4", (2, 2, 2), brick(0, 4)),
             Box("Up", "C3D8", (3, 2, 2), brick(4, 9), 5000), "4 5")):
        deck = (straight(low).text() + straight(up).text()
                + elastic("Low", "Up") + end.format("z", "Z", sides))
        what = f"{up.code} on {low.code}"
        found, said = values(
            "bricks", deck, "u: displacement z, Tip; p: pressure, Foot; "
            "s: stress zz, Tip", "Mesh/Points=Tip: 6, 6, 9; Foot in Up: 4, 3, 4")
        compare(f"{what}, distorted", (found, said),
                {"u": -30 * 9 / 1000, "p": 30, "s": -30}, 1e-9)
        check(f"{what}: gmsh's order",
              all(middles_are_right("bricks.msh", k) for k in kinds.split()))
        check(f"{what}: what is modified is told",
              ("C3D10M: modified formulation" in said) == (up.code == "C3D10M"),
              said)


def straight(bricks):
    """The same with its mid-side nodes midway."""
    for i in bricks.places:
        odd = [d for d in range(3) if i[d] % 2]
        if odd:
            ends = [tuple(c + s * (d in odd) for d, c in enumerate(i))
                    for s in (-1, 1)]
            bricks.places[i] = tuple(
                sum(c) / 2 for c in zip(*(bricks.places[e] for e in ends)))
    return bricks


def middles_are_right(name, kind):
    """Of the cells of gmsh's kind, which there are."""
    edges = GMSH_EDGES.get(kind, ())
    n_corners = {"4": 4, "11": 4}.get(kind, 8)
    lines = pathlib.Path(name).read_text().split("$Nodes\n")[1].splitlines()
    points = {row[0]: [float(x) for x in row[1:]]
              for row in (line.split() for line in lines[1:int(lines[0]) + 1])}
    cells = [line.split()[5:] for line in lines if line.split()[1:2] == [kind]]
    return cells and all(
        math.dist(points[cell[n_corners + k]], [(a + b) / 2 for a, b in zip(
            points[cell[i]], points[cell[j]])]) < 1e-12
        for cell in cells for k, (i, j) in enumerate(edges))


def rings():
    """A quarter of a tube under pressure inside, with mid-side nodes on circles."""
    a, b, p, modulus, ratio = 10., 20., 8., 1000., 0.25
    u = (1 + ratio) * p * a * a / (modulus * (b * b - a * a)) * (
        (1 - 2 * ratio) * a + b * b / a)

    def chart(s, t, z=None):
        r, angle = a + (b - a) * s, math.pi / 2 * t
        place = (r * math.cos(angle), r * math.sin(angle))
        return place if z is None else (*place, 2 * z)

    for code, n in (("CPE8R", (4, 5)), ("C3D20R", (4, 5, 1)),
                    ("C3D10", (6, 8, 1))):
        kind = Tetrahedra if code == "C3D10" else Box
        deck = (kind("Tube", code, n, chart).text() + elastic("Tube") + """*STEP
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
    compare("a bar that yields at large strain", values(
        "yields_large", bar + BAR.format(law.format(""), "YES", 3 * (x - 1)),
        "f: reaction y, Bar_y1"), {"f": 130 / x * area}, 1e-7)
    for law, c10, c01 in (("NEO HOOKE\n0.5, 0.", 0.5, 0),
                          ("MOONEY-RIVLIN\n0.3, 0.2, 0.", 0.3, 0.2)):
        compare(f"a bar of rubber, {law[:6]}", values(
            "rubber", bar.replace("CAX4", "CAX4H") + BAR.format(
                f"*HYPERELASTIC, {law}\n", "YES", 3 * (x - 1)),
            "f: reaction y, Bar_y1"),
            {"f": 2 * (x - x ** -2) * (c10 + c01 / x) * area}, 1e-3)


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


PAIRS = """*TIE, NAME=Glue, ADJUST=NO
Mid_y0_face, Low_y1_face
*SURFACE INTERACTION, NAME=Smooth
*FRICTION
0.1
*SURFACE INTERACTION, NAME=Rough
*FRICTION
0.4
*CONTACT PAIR, INTERACTION=Smooth
A_y0_face, Mid_y1_face
*CONTACT PAIR, INTERACTION=Rough
B_y0_face, Mid_y1_face
*STEP
*STATIC
0.5, 1.
*BOUNDARY
Low_y0, ENCASTRE
A_y1, 1
B_y1, 1
*DSLOAD
A_y1_face, P, 20.
B_y1_face, P, 10.
*END STEP
*STEP
*STATIC
0.25, 1.
*BOUNDARY
A_y1, 1, 1, 0.5
B_y1, 1, 1, -0.5
*END STEP
"""


def ties_and_pairs():
    """Two blocks slide on a plate that is tied to the ground; a tied column is
    pulled, which contact would not hold."""
    deck = (Box("Low", "CPE4", (12, 2), box(0, 0, 30, 5)).text()
            + Box("Mid", "CPE4", (17, 2), box(0, 5, 30, 8), 1000).text()
            + Box("A", "CPE4", (4, 2), box(3, 8, 9, 10), 2000).text()
            + Box("B", "CPE4", (5, 2), box(18, 8, 27, 10), 3000).text()
            + elastic("Low", "Mid", "A", "B", modulus=210000) + PAIRS)
    a, b = 20 * 6, 10 * 9
    # Contact is on the deformed surfaces, whose normals turn by 1e-5.
    compare("a tie and two contact pairs", values(
        "pairs", deck, "a: reaction x, A_y1; b: reaction x, B_y1; "
        "x: reaction x, Low_y0; y: reaction y, Low_y0"),
        {"a": 0.1 * a, "b": -0.4 * b, "x": 0.4 * b - 0.1 * a, "y": a + b}, 2e-5)

    deck = (Box("Low", "C3D8", (2, 2, 1), lambda x, y, z: (6 * x, 6 * y, 4 * z)).text()
            + Box("Up", "C3D8", (3, 2, 2), lambda x, y, z: (6 * x, 6 * y, 4 + 5 * z),
                  1000).text()
            + elastic("Low", "Up") + """*TIE, NAME=Glue
Up_z0_face, Low_z1_face
*STEP
*STATIC
*BOUNDARY
Low_z0, ZSYMM
Low_x0, XSYMM
Up_x0, XSYMM
Low_y0, YSYMM
Up_y0, YSYMM
*DSLOAD
Up_z1_face, P, -30.
*END STEP
""")
    compare("a tie of C3D8, pulled", values(
        "pulled", deck, "u: displacement z, Tip; r: reaction z, Low_z0; "
        "s: stress zz, Tip", "Mesh/Points=Tip: 6, 6, 9"),
        {"u": 30 * 9 / 1000, "r": -30 * 36, "s": 30}, 1e-9)


if __name__ == "__main__":
    friction()
    uniform()
    rings()
    parts()
    bars()
    loads()
    ties_and_pairs()
    sys.exit(bool(failures))
