#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ten scenes of analysts.py in 3-D: plane sections of quadrangles that are extruded or
revolved, a ball of mapped hexahedra, and a joint of tetrahedra."""

import math
import pathlib

import analysts_scene
from analysts_scene import Scene, materials

MESHES = pathlib.Path(__file__).resolve().parents[2] / "meshes"
MAPPED = "Mesh.RecombinationAlgorithm = 1;"  # others halve the cells
STEEL, ALUMINIUM, PLASTIC = (210000, 0.3), (70000, 0.33), (2500, 0.38)


def at(**ranges):
    """The box of faces with x, y, z at a value or in a range."""
    ends = [ranges.get(c, (-999, 999)) for c in "xyz"]
    ends = [end if isinstance(end, tuple) else (end, end) for end in ends]
    return [end[0] - 0.02 for end in ends] + [end[1] + 0.02 for end in ends]


def rectangle(x, y, dx, dy):
    return f"Rectangle(k) = {{{x}, {y}, 0, {dx}, {dy}}};"


def disk(x, y, r):
    return f"Disk(k) = {{{x}, {y}, 0, {r}}};"


def polygon(*corners):
    """Corners x, y and, if they are rounded, a radius."""
    text, n = "p() = {}; l() = {};", 0
    for i, (x, y, *radius) in enumerate(corners):
        points = [(x, y)]
        if radius:
            sides = [(px - x, py - y) for px, py, *_ in (
                corners[i - 1], corners[(i + 1) % len(corners)])]
            (ax, ay), (bx, by) = ((u / math.hypot(u, v), v / math.hypot(u, v))
                                  for u, v in sides)
            half = math.acos(ax * bx + ay * by) / 2
            near, far = radius[0] / math.tan(half), radius[0] / math.sin(2 * half)
            points = [(x + near * ax, y + near * ay), (x + far * (ax + bx), y + far * (ay + by)),
                      (x + near * bx, y + near * by)]
        for px, py in points:
            text += f" m = newp; Point(m) = {{{px!r}, {py!r}, 0}}; p() += {{m}};"
        if n:
            text += f" m = newl; Line(m) = {{p({n - 1}), p({n})}}; l() += {{m}};"
        if radius:
            text += f" m = newl; Circle(m) = {{p({n}), p({n + 1}), p({n + 2})}}; l() += {{m}};"
        n += len(points)
    return text + (f" m = newl; Line(m) = {{p({n - 1}), p(0)}}; l() += {{m}};"
                   " m = newll; Curve Loop(m) = {l()}; Plane Surface(k) = {m};")


def layers(n):
    return max(1, round(n / analysts_scene.SIZE))


class Drawing:
    """Bodies for gmsh, that share nothing."""

    def __init__(self, *options):
        self.text = ['SetFactory("OpenCASCADE");', "Mesh.RecombineAll = 1;",
                     "Mesh.Algorithm = 6;", "Mesh.RecombinationAlgorithm = 2;",
                     "old() = {}; before() = {};", *options]
        self.groups = {}

    def section(self, size, shapes, without=(), inside=(), split=(), z=0):
        """The union of SHAPES without those that are cut off, inside of others, and
        split by others; its faces are s()."""
        for name, parts in zip("abcd", (shapes, without, inside, split)):
            self.text += [f"{name}() = {{}};",
                          *(f"k = news; {part} {name}() += {{k}};" for part in parts)]
        self.text += ["s() = {a()};"]
        if len(shapes) > 1:
            self.text += ["s() = BooleanUnion{Surface{a(0)}; Delete;}"
                          "{Surface{a({1 : #a() - 1})}; Delete;};"]
        for name, parts, kind in (("b", without, "Difference"),
                                  ("c", inside, "Intersection"),
                                  ("d", split, "Fragments")):
            if parts:
                self.text += [f"s() = Boolean{kind}{{Surface{{s()}}; Delete;}}"
                              f"{{Surface{{{name}()}}; Delete;}};"]
        self.text += [f"MeshSize{{PointsOf{{Surface{{s()}};}}}} = {size};",
                      f"Translate {{0, 0, {z}}} {{Surface{{s()}};}}"]

    def extrude(self, height, n, box=None):
        if box:
            self.text += [f"s() = Surface In BoundingBox{{{str(box)[1:-1]}}};"]
        self.text += [f"Extrude {{0, 0, {height}}} {{Surface{{s()}}; "
                      f"Layers{{{layers(n)}}}; Recombine;}}"]

    def revolve(self, angle, *ns, at_x=0, ends="1"):
        """About an axis along y, in layers that end at parts of the angle."""
        ns = ", ".join(str(layers(n)) for n in ns)
        self.text += [f"Extrude {{{{0, 1, 0}}, {{{at_x}, 0, 0}}, {angle}}} {{Surface{{s()}}; "
                      f"Layers{{{{{ns}}}, {{{ends}}}}}; Recombine;}}"]

    def mapped(self, corner, size, cells, z=0):
        """A rectangle of CELLS in x and y."""
        self.section(1, [rectangle(*corner, *size)], z=z)
        self.text += ["l() = Boundary{Surface{s()};};",
                      *(f"Transfinite Curve{{l({i}), l({i + 2})}} = {layers(cells[i]) + 1};"
                        for i in (0, 1)), "Transfinite Surface{s()};"]

    def body(self, name, **groups):
        """All volumes since the last body. A face is in the first group, {name: box},
        whose box it is in; "" is no group, for faces inside of the body."""
        self.text += ["v() = Volume{:}; v() -= {before()}; before() += {v()};",
                      f'Physical Volume("{name}") = {{v()}};']
        for group, boxes in groups.items():
            for box in boxes if isinstance(boxes[0], list) else [boxes]:
                if group and group not in self.groups:
                    self.groups[group] = f"{group}()"
                    self.text.insert(0, f"{group}() = {{}};")
                self.text += [f"f() = Surface In BoundingBox{{{str(box)[1:-1]}}}; "
                              "f() -= {old()}; old() += {f()};",
                              f"{group}() += {{f()}};" * bool(group)]
        self.text += ["old() = Surface{:};"]

    def write(self, name):
        return analysts_scene.mesh(name, "\n".join([
            *self.text, *(f'Physical Surface("{group}") = {{{faces}}};'
                          for group, faces in self.groups.items())]) + "\n", 3)


def supports(**directions):
    return {f"Boundary conditions/Displacement {direction}": values
            for direction, values in directions.items()}


def pair(name, slave, master, friction=0.0, **more):
    result = {"Slave": slave, "Master": master}
    if friction:
        result["Friction coefficient"] = friction
    return {f"Contact {name}/{key.replace('_', ' ')}": value
            for key, value in {**result, **more}.items()}


def bolts():
    """A quarter of two plates with four bolts: tightened, then pulled apart."""
    d = Drawing()
    hole, patch = disk(25, 25, 5.5), rectangle(0, 0, 15, 15)
    for name, z, up in (("Upper", 0, 1), ("Lower", 0, -1)):
        d.section(4, [rectangle(0, 0, 40, 40)], [hole], split=[patch])
        d.extrude(10 * up, 3)
        d.body(name, Plane_x=at(x=0), Plane_y=at(y=0),
               **{f"{name}_pull": at(x=(0, 15), y=(0, 15), z=10 * up),
                  f"{name}_seat": at(z=10 * up), f"{name}_sole": at(z=z)})
    for name, up in (("Bolt", 1), ("Nut", -1)):
        d.section(2.5, [disk(25, 25, 8.5)], split=[disk(25, 25, 5)], z=10 * up)
        d.extrude(6 * up, 2)
        d.extrude(-10 * up, 3, at(x=(20, 30), y=(20, 30), z=10 * up))
        d.body(name, **{"": at(x=(20, 30), y=(20, 30), z=10 * up),
                        f"{name}_cut": at(z=0), f"{name}_face": at(z=10 * up)})
    return Scene({
        "Mesh/File": d.write("bolts"),
        **materials(Upper=STEEL, Lower=STEEL, Bolt=STEEL, Nut=STEEL),
        **supports(x="Plane_x: 0", y="Plane_y: 0", z="Lower_pull: 0"),
        "Boundary conditions/Resultant force z": "Upper_pull: 5000",
        "Boundary conditions/Histories": "Resultant force z: max(0, 2*t - 1)",
        **pair("head", "Upper_seat", "Bolt_face", 0.15),
        **pair("nut", "Lower_seat", "Nut_face", 0.15),
        **pair("joint", "Upper_sole", "Lower_sole", 0.15),
        **pair("cut", "Nut_cut", "Bolt_cut", Tied="true",
               Preload="20000*min(1, 2*t)", Preload_end=0.5),
        "Solution/Increments": 4,
        "Probes/Probes": "bolt: preload, Contact cut; base: reaction z, Lower_pull; "
                         "clamp: contact force z, Upper_sole"},
        {"base": (-5000, "balance"),
         "clamp": (lambda v: v["bolt"] - 5000, "balance"),
         "bolt": (20232.6, "refined: 0.7 of the size, change 0.002 %")})


def ball_joint():
    """Half of a ball in a socket of plastic, pressed in with 0.05 mm and turned."""
    d = Drawing("Mesh.RecombineAll = 0;", "Mesh.MeshSizeMax = 3.5;")
    half = "Box(3) = {-50, 0, -50, 100, 50, 100};"
    d.text += ["Sphere(1) = {0, 0, 0, 10}; Cylinder(2) = {0, 0, 0, 0, 0, 25, 4};", half,
               "BooleanUnion(4) = {Volume{1}; Delete;}{Volume{2}; Delete;};",
               "BooleanIntersection(5) = {Volume{4}; Delete;}{Volume{3}; Delete;};",
               "n = newp; Point(n) = {0, 0, 0}; Physical Point(\"Centre\") = {n};",
               "f() = Surface In BoundingBox{-99, -.1, -99, 99, .1, 99};",
               "Point{n} In Surface{f(0)};"]
    d.body("Ball", Plane_y=at(y=0), Top=at(z=25), Neck=at(x=(-4, 4), y=(0, 4), z=(5, 25)),
           Skin=at(x=(-11, 11), y=(0, 11), z=(-11, 11)))
    d.text += ["Sphere(6) = {0, 0, 0, 10}; Cylinder(7) = {0, 0, -15, 0, 0, 20, 16};", half,
               "BooleanDifference(8) = {Volume{7}; Delete;}{Volume{6}; Delete;};",
               "BooleanIntersection(9) = {Volume{8}; Delete;}{Volume{3}; Delete;};"]
    d.body("Socket", Plane_y=at(y=0), Base=at(z=-15), Rim=at(z=5),
           Seat=at(x=(-11, 11), y=(0, 11), z=(-11, 6)))
    return Scene({
        "Mesh/File": d.write("ball_joint"), "Element/Degree": 2,
        "Mesh/Spheres": "Skin: 0, 0, 0, 10; Seat: 0, 0, 0, 10",
        **materials(Ball=STEEL, Socket=PLASTIC),
        **supports(x="Base: 0, Top: 0", y="Plane_y: 0, Base: 0, Top: 0",
                   z="Base: 0, Top: 0"),
        "Boundary conditions/Rigid": "Top: Centre",
        "Boundary conditions/Rotation x": "Top: 0",
        "Boundary conditions/Rotation y": "Top: 0.3",
        "Boundary conditions/Rotation z": "Top: 0",
        "Boundary conditions/Histories": "Rotation y: max(0, 1.5*t - 0.5)",
        **pair("joint", "Seat", "Skin", 0.1, Interference="0.05*min(1, 3*t)"),
        "Solution/Increments": 6,
        "Probes/Probes": "moment: reaction moment y, Top; push: reaction z, Top; "
                         "base: reaction z, Base"},
        {"moment": (4112, "refined: 0.86 of the size, change 0.6 %"),
         "push": (lambda v: -v["base"], "balance")})


def pipe_clamp():
    """Half of a pipe that two half shells and a bolt clamp, and that is then pulled."""
    d = Drawing()
    right = rectangle(0, -50, 50, 100)
    d.section(6, [disk(0, 0, 20)], [disk(0, 0, 17)], [right])
    d.extrude(70, 10)
    d.body("Pipe", Plane_x=at(x=0), End=at(z=0), Far=at(z=70),
           Inside=at(x=(0, 17), y=(-17, 17)), Outside=at(x=(0, 20), y=(-20, 20)))
    for name, y, up in (("Upper", 1, 1), ("Lower", -50, -1)):
        ear = rectangle(22, 1 if up == 1 else -7, 16, 6)
        foot = [] if up == 1 else [rectangle(0, -30, 15, 8)]
        d.section(6, [disk(0, 0, 25), ear, *foot], [disk(0, 0, 20)],
                  [rectangle(0, y, 50, 49)], z=25)
        d.extrude(20, 3)
        d.body(name, Plane_x=at(x=0), Base=at(y=-30),
               **{f"{name}_ear": at(x=(20, 40), y=7 * up),
                  f"{name}_bore": at(x=(0, 20), y=(-20, 20), z=(25, 45))})
    return Scene({
        "Mesh/File": d.write("pipe_clamp"), "Element/Degree": 2,
        "Mesh/Cylinders": "; ".join(f"{group}: 0, 0, 0, 0, 0, 1, 20" for group in (
            "Outside", "Upper_bore", "Lower_bore")),
        **materials(Pipe=STEEL, Upper=ALUMINIUM, Lower=ALUMINIUM),
        **supports(x="Plane_x: 0, Base: 0", y="Base: 0", z="Base: 0, Upper_ear: 0, End: -0.1"),
        "Boundary conditions/Resultant force y": "Upper_ear: -2000, Lower_ear: 2000",
        "Boundary conditions/Histories":
            "Resultant force y: min(1, 2*t); Displacement z: max(0, 2*t - 1)",
        **pair("upper", "Upper_bore", "Outside", 0.2),
        **pair("lower", "Lower_bore", "Outside", 0.2),
        "Solution/Increments": 6,
        "Probes/Probes": "pull: reaction z, End; press: contact force y, Upper_bore; "
                         "base: reaction z, Base; "
                         "ear: reaction z, Upper_ear"},
        {"pull": (-1617.8, "refined: 0.75 of the size to t = 0.83, change 0.05 %"),
         "press": (2000, "balance"),
         "base": (lambda v: -v["pull"] - v["ear"], "balance")})


def tube():
    """Half of a tube of aluminium along y, squeezed between plates to 24 mm of 40."""
    d = Drawing(MAPPED)
    d.mapped((18, 0), (2, 20), (2, 4))
    d.revolve("Pi", 16)
    d.body("Tube", Plane_z=at(z=0), Plane_y=at(y=0),
           **{"": [at(y=20), at(x=(-18, 18), z=(-18, 0))]}, Skin=at())
    for name, x, up in (("Upper", 20, 1), ("Lower", -25, -1)):
        d.mapped((x, 0), (5, 24), (1, 4))
        d.extrude(-32, 6)
        d.body(name, Plane_z=at(z=0), Plane_y=at(y=0),
               **{f"{name}_face": at(x=20 * up), f"{name}_back": at(x=25 * up)})
    return Scene({
        "Mesh/File": d.write("tube"), "Element/Degree": 2,
        "Mesh/Cylinders": "Skin: 0, 0, 0, 0, 1, 0, 20",
        **materials(Tube=ALUMINIUM, Upper=STEEL, Lower=STEEL),
        "Solids/Material": "Tube: elastic-plastic", "Solids/Yield stress": "Tube: 150",
        "Solids/Hardening modulus": "Tube: 500",
        **supports(x="Lower_back: 0, Upper_back: -16", y="Plane_y: 0", z="Plane_z: 0"),
        **pair("upper", "Skin", "Upper_face", 0.2),
        **pair("lower", "Skin", "Lower_face", 0.2),
        "Solution/Increments": 16,
        "Probes/Probes": "press: reaction x, Upper_back; bear: reaction x, Lower_back"},
        {"press": (-507.1, "refined: 0.7 of the size, change 3 %"),
         "bear": (lambda v: -v["press"], "balance")})


def bush():
    """A quarter of a bush in a hub, with 0.02 mm of interference, and pushed out."""
    d = Drawing(MAPPED)
    d.mapped((10, 0), (4, 20), (2, 5))
    d.revolve("Pi/2", 4)
    d.body("Bush", Plane_z=at(z=0), Plane_x=at(x=0), Head=at(y=20),
           **{"": [at(y=0), at(x=(0, 10), z=(-10, 0))]}, Journal=at())
    d.mapped((14, 0), (11, 16), (3, 4))
    d.revolve("Pi/2", 4)
    d.body("Hub", Plane_z=at(z=0), Plane_x=at(x=0), Rest=at(y=0), **{"": at(y=16)},
           Bore=at(x=(0, 14), z=(-14, 0)))
    return Scene({
        "Mesh/File": d.write("bush"), "Element/Degree": 2,
        "Mesh/Cylinders": "Journal: 0, 0, 0, 0, 1, 0, 14; Bore: 0, 0, 0, 0, 1, 0, 14",
        **materials(Bush=(110000, 0.34), Hub=STEEL),
        **supports(x="Plane_x: 0", y="Rest: 0, Head: -0.1", z="Plane_z: 0"),
        "Boundary conditions/Histories": "Displacement y: max(0, 2*t - 1)",
        **pair("fit", "Bore", "Journal", 0.12, Interference="0.02*min(1, 2*t)"),
        "Solution/Increments": 6,
        "Probes/Probes": "push: reaction y, Head; rest: support y, Rest"},
        {"push": (-1948.4, "axisymmetric: 768 cells of degree 2, change 0.04 %"),
         "rest": (lambda v: -v["push"], "balance")})


def key():
    """A shaft that turns a hub by a key."""
    d = Drawing()
    d.section(7, [disk(0, 0, 15)], [rectangle(-4, 10, 8, 9)])
    d.text += ["n = newp; Point(n) = {0, 0, 0}; Point{n} In Surface{s(0)};"]  # of the axis
    d.extrude(40, 5)
    d.body("Shaft", End=at(z=40), **{"": at(z=0)},
           Shaft_slot=at(x=(-4, 4), y=(10, 15)), Journal=at())
    d.section(5, [rectangle(-4, 10, 8, 8)], split=[rectangle(-4, 10, 8, 4.5)])
    d.extrude(24, 4)
    d.body("Key", **{"": [at(z=0), at(z=24), at(y=14.5), at(y=18)]},
           Key_below=at(y=(10, 14.5)), Key_above=at(y=(14.5, 18)))
    d.section(7, [disk(0, 0, 28)], [disk(0, 0, 15.01), rectangle(-4, 10, 8, 8.2)])
    d.extrude(24, 3)
    d.body("Hub", **{"": [at(z=0), at(z=24)]}, Hub_slot=at(x=(-4, 4), y=(14, 18.2)),
           Bore=at(x=(-15, 15), y=(-15, 15)), Rim=at())
    return Scene({
        "Mesh/File": d.write("key"), "Element/Degree": 2,
        "Mesh/Cylinders": "Journal: 0, 0, 0, 0, 0, 1, 15; Bore: 0, 0, 0, 0, 0, 1, 15.01",
        "Mesh/Points": "P in Shaft: 0, 0, 40",
        **materials(Shaft=STEEL, Key=STEEL, Hub=STEEL),
        **supports(x="End: 0, Rim: 0", y="End: 0, Rim: 0", z="End: 0, Rim: 0"),
        "Boundary conditions/Rigid": "End: P",
        "Boundary conditions/Rotation x": "End: 0",
        "Boundary conditions/Rotation y": "End: 0",
        "Boundary conditions/Moment z": "End: 100000",
        **pair("below", "Key_below", "Shaft_slot", 0.1),
        **pair("above", "Key_above", "Hub_slot", 0.1),
        **pair("fit", "Bore", "Journal", 0.1),
        "Solution/Increments": 3,
        "Probes/Probes": "turn: rotation z, End; key: contact force x, Hub_slot; "
                         "foot: contact force x, Shaft_slot"},
        {"foot": (lambda v: -v["key"], "balance")})


def lever():
    """Half of a lever on a pin: a force at the long arm, a support at the short one."""
    d = Drawing()
    d.section(4, [disk(0, 0, 16), rectangle(-45, -7, 130, 14)], [disk(0, 0, 8)])
    d.extrude(8, 2)
    d.body("Lever", Plane_z=at(z=0), Stop=at(x=-45), Grip=at(x=85),
           Bore=at(x=(-8, 8), y=(-8, 8)))
    d.section(4, [disk(0, 0, 7.95)])
    d.extrude(14, 3)
    d.body("Pin", Plane_z=at(z=0), Fork=at(z=14), Journal=at())
    return Scene({
        "Mesh/File": d.write("lever"), "Element/Degree": 2,
        "Mesh/Cylinders": "Journal: 0, 0, 0, 0, 0, 1, 7.95; Bore: 0, 0, 0, 0, 0, 1, 8",
        **materials(Lever=ALUMINIUM, Pin=STEEL),
        **supports(x="Fork: 0", y="Fork: 0, Stop: 0", z="Fork: 0, Plane_z: 0"),
        "Boundary conditions/Resultant force y": "Grip: -500",
        **pair("pin", "Bore", "Journal"),
        "Solution/Increments": 2,
        "Probes/Probes": "pin: reaction y, Fork; stop: reaction y, Stop"},
        {"pin": (500 * 130 / 45, "lever rule"), "stop": (-500 * 85 / 45, "lever rule")})


def ball_bearing():
    """A quarter of a ball, of two tied halves, between the grooves of two races. Hertz, of
    2000 N: radii 5 and -6 across, 5 and 15 or -25 along the way that the ball rolls."""
    d = Drawing()
    for name, left, middle, back, groove in (("Inner", -4, 6, (-4.4, -4), (-.6, 1)),
                                             ("Outer", 9, 4, (13, 14), (8.1, 10))):
        d.section(0.7, [rectangle(left, 0, 5, 4.5)], [disk(middle, 0, 6)])
        d.text += ["p() = Point In BoundingBox{-.1, -.1, -1, 10.1, .1, 1};",
                   "MeshSize{p()} = 0.15;"]
        d.revolve("Pi/12", 9, 5, at_x=-15, ends="0.12, 1")
        d.body(name, Plane_z=at(z=0), Plane_y=at(y=0), **{
            f"{name}_back": at(x=back), f"{name}_groove": at(x=groove, y=(0, 3.4))})
    d.text += ['SetFactory("Built-in");', "Geometry.AutoCoherence = 0;",
               f'Include "{MESHES / "hemisphere.macro"}";',
               f"R = 5; s = 1; n = {layers(10)}; layers = {layers(6)}; quadrants = 1;",
               f"growth = {1.3 ** analysts_scene.SIZE!r};"]
    for base, name, up in ((1000, "Ball", 1), (2000, "Other_half", -1)):
        d.text += [f"base = {base}; up = {up}; Call Hemisphere;", "v() = bodyVolumes[];",
                   f"Translate {{0, 0, {5 - 5 * up}}} {{Volume{{v()}};}}",
                   "Rotate {{0, 1, 0}, {0, 0, 0}, Pi/2} {Volume{v()};}",
                   f'Physical Volume("{name}") = {{v()}};',
                   "Plane_y() += firstPlane[]; Plane_z() += lastPlane[];",
                   f"{name}_skin() = {{poleFaces[], sphereFaces[]}};",
                   f"{name}_cut() = topFaces[];"]
        d.groups.update({f"{name}_{face}": f"{name}_{face}()" for face in ("skin", "cut")})
    return Scene({
        "Mesh/File": d.write("ball_bearing"),
        "Mesh/Points": "I in Ball: 0, 0, 0; O in Other_half: 10, 0, 0",
        **materials(Inner=STEEL, Outer=STEEL, Ball=STEEL, Other_half=STEEL),
        **supports(x="Inner_back: 0", y="Plane_y: 0", z="Plane_z: 0"),
        "Boundary conditions/Resultant force x": "Outer_back: -500",
        **pair("inner", "Ball_skin", "Inner_groove"),
        **pair("outer", "Other_half_skin", "Outer_groove"),
        **pair("middle", "Other_half_cut", "Ball_cut", Tied="true"),
        "Solution/Increments": 2,
        "Probes/Probes": "base: reaction x, Inner_back; inside: pressure, I; "
                         "outside: pressure, O; groove: contact force x, Inner_groove"},
        {"base": (500, "balance"), "groove": (-500, "balance"),
         "inside": (3986.5, "Hertz"), "outside": (3217.7, "Hertz")})


def rubber():
    """Half of a block of rubber on its base: a plate presses and shears it."""
    d = Drawing(MAPPED)
    d.mapped((-20, 0), (40, 20), (12, 6))
    d.extrude(20, 6)
    d.body("Block", Plane_y=at(y=0), Base=at(z=0), Crown=at(z=20))
    d.mapped((-30, 0), (75, 25), (10, 4), 20)
    d.extrude(5, 1)
    d.body("Plate", Plane_y=at(y=0), Sole=at(z=20), Head=at(z=25))
    return Scene({
        "Mesh/File": d.write("rubber"),
        **materials(Block=(3, 0.49), Plate=STEEL),
        "Solids/Material": "Block: neo-Hookean",
        **supports(x="Base: 0, Head: 12", y="Base: 0, Plane_y: 0", z="Base: 0, Head: -4"),
        "Boundary conditions/Histories":
            "Displacement z: min(1, 2*t); Displacement x: max(0, 2*t - 1)",
        **pair("top", "Crown", "Sole", 0.3),
        "Solution/Increments": 10,
        "Probes/Probes": "press: reaction z, Head; drag: reaction x, Head; "
                         "base: reaction z, Base"},
        {"base": (lambda v: -v["press"], "balance")})


def hook():
    """Half of a hook that is pushed over a ridge and stays behind it, bent."""
    d = Drawing("Mesh.MeshSizeFromCurvature = 12;")
    d.section(1, [polygon((0., 0.), (22., 0., 1.), (23.5, -3., 0.8), (26., -3., 0.8),
                          (32., 0.5), (32., 2.), (0., 2.))])
    d.extrude(4, 3)
    d.body("Hook", Plane_z=at(z=0), **{"": [at(z=4), at(y=2), at(x=32)]}, Root=at(x=0),
           Nose=at(x=(15, 32)))
    d.section(1.2, [polygon((30., -8.), (54., -8.), (54., -2.), (40.5, -2.),
                            (39., -.5, 2.), (35., -.5, 2.), (31.5, -4.), (30., -4.))])
    d.extrude(5, 3)
    d.body("Ridge", Plane_z=at(z=0), **{"": [at(z=5), at(x=30), at(x=54)]},
           Foot=at(y=-8), Track=at())
    return Scene({
        "Mesh/File": d.write("hook"), "Solids/Incompatible modes": "Hook",
        **materials(Hook=PLASTIC, Ridge=PLASTIC),
        **supports(x="Foot: 0, Root: 18", y="Foot: 0, Root: 0",
                   z="Foot: 0, Plane_z: 0"),
        **pair("snap", "Nose", "Track", 0.2),
        "Solution/Increments": 36,
        "Probes/Probes": "lift: reaction y, Root; foot: reaction y, Foot"},
        {"foot": (lambda v: -v["lift"], "balance")})


SCENES = {scene.__name__: scene for scene in (
    bolts, ball_joint, pipe_clamp, tube, bush, key, lever, ball_bearing, rubber, hook)}
