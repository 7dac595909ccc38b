# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ten plane and axisymmetric scenes of analysts.py. Lengths in mm, stresses in MPa."""

import math

from analysts_scene import Scene, materials, mesh, section

STEEL, ALUMINIUM, PLASTIC = (210000, 0.3), (70000, 0.33), (2000, 0.4)


class Drawing:
    """Bodies with straight, round and free sides, as a geometry for gmsh."""

    def __init__(self):
        self.lines = ["Mesh.RecombineAll = 1;", "Mesh.Algorithm = 6;",
                      "Mesh.SubdivisionAlgorithm = 1;"]
        self.n, self.groups, self.arcs = 0, {}, {}

    def new(self, what, *values):
        self.n += 1
        self.lines.append(f"{what}({self.n}) = {{{', '.join(map(str, values))}}};")
        return self.n

    def point(self, place, size):
        return self.new("Point", *place, 0, 2 * size)  # cells are halved

    def loop(self, size, corners):
        """Corners: x, y, the group of the side behind it, the centre of that or a list
        of places in between, and the size of cells there, as a factor."""
        corners = [corner + ("", None, 1)[len(corner) - 2:] for corner in corners]
        ends = [self.point(corner[:2], size * corner[4]) for corner in corners]
        sides = []
        for k, (x, y, group, via, _) in enumerate(corners):
            a, b = ends[k], ends[(k + 1) % len(ends)]
            if isinstance(via, list):
                between = [self.point(place, size) for place in via]
                sides.append(self.new("Spline", a, *between, b))
            elif via:
                sides.append(self.new("Circle", a, self.point(via, size), b))
                if group:
                    self.arcs[group] = (*via, math.dist((x, y), via))
            else:
                sides.append(self.new("Line", a, b))
            if group:
                self.groups.setdefault(group, []).append(sides[-1])
        return self.new("Curve Loop", *sides)

    def body(self, name, size, corners, *holes):
        loops = [self.loop(size, side) for side in (corners, *holes)]
        surface = self.new("Plane Surface", *loops)
        self.lines.append(f'Physical Surface("{name}") = {{{surface}}};')

    def block(self, name, size, x0, y0, x1, y1, *groups):
        """Groups: below, right, above, left."""
        places = (x0, y0), (x1, y0), (x1, y1), (x0, y1)
        self.body(name, size, [(float(x), float(y), group) for (x, y), group in
                               zip(places, (*groups, "", "", "", ""))])

    def write(self, name):
        groups = [f'Physical Curve("{group}") = {{{", ".join(map(str, sides))}}};'
                  for group, sides in self.groups.items()]
        arcs = "; ".join(f"{group}: {x:.10g}, {y:.10g}, {r:.10g}"
                         for group, (x, y, r) in self.arcs.items())
        return section("Mesh", File=mesh(name, "\n".join(self.lines + groups) + "\n"),
                       **({"Arcs": arcs} if arcs else {}))


def circle(x, y, r, *groups, factor=1):
    """Corners of one, quarter by quarter from the right on."""
    groups = groups * 4 if len(groups) == 1 else groups
    return [(x + r * math.cos(a), y + r * math.sin(a), group, (x, y), factor)
            for a, group in zip((0, math.pi / 2, math.pi, 3 * math.pi / 2), groups)]


def finer(size, change, degree=2):
    """The source of a value of this program: factor on the sizes of cells, change [%] to
    the mesh before."""
    return f"refined: degree {degree}, sizes times {size}, change {change} %"


def line_contact(force, radius, stiffness):
    """Hertz: largest pressure of two cylinders; force by length, relative radius,
    and modulus E* of both."""
    return math.sqrt(force * stiffness / (math.pi * radius))


def gears():
    """Two involute teeth (module 4, 20 teeth, 20 degrees) that touch in the pitch point;
    a moment turns the lower one about its centre."""
    pitch, root, tip, torque, slope = 40., 35., 44., 15000., math.radians(20)
    base = pitch * math.cos(slope)

    def half(r):  # angle of the flank at a radius
        t = math.acos(base / r)
        return math.pi / 40 + math.tan(slope) - slope - math.tan(t) + t

    def flank(r0, r1, power=2):  # points that are close to each other at r0
        radii = [r0 + (r1 - r0) * (k / 20) ** power for k in range(1, 20)]
        return [(r, half(r)) for r in radii]

    foot, side = half(base) + .03, math.pi / 10
    polar = [(0, 0, "Cut"), (root, -side), (root, -foot), (base, -half(base)),
             (tip, -half(tip)), (tip, half(tip), "Flank", flank(pitch, tip)[::-1], .3),
             (pitch, half(pitch), "Flank", flank(pitch, base), .015),
             (base, half(base), "", None, .3), (root, foot), (root, side, "Cut")]

    def place(r, a, sign):
        a -= math.pi / 40
        return (pitch + sign * (r * math.cos(a) - pitch), sign * r * math.sin(a))

    drawing = Drawing()
    for k, sign in (1, 1), (2, -1):
        drawing.body(f"Gear {k}", 2, [
            (*place(r, a, sign), more[0] and f"{more[0]} {k}", more[1] and [
                place(*via, sign) for via in more[1]], more[2])
            for r, a, *more in (corner + ("", None, 1)[len(corner) - 2:]
                                for corner in polar)])
    force, stiffness = torque / base, STEEL[0] / (1 - STEEL[1] ** 2) / 2
    radius = pitch * math.sin(slope) / 2
    return Scene({
        **drawing.write("gears"), **materials(**{"Gear 1": STEEL, "Gear 2": STEEL}),
        "Mesh/Points": "O: 0, 0; Q: 80, 0; P in Gear 2: 40, 0",
        **section("Boundary conditions", Rigid="Cut 1: O, Cut 2: Q",
                  Displacement_x="Cut 1: 0, Cut 2: 0", Displacement_y="Cut 1: 0, Cut 2: 0",
                  Moment_z=f"Cut 1: {torque}", Rotation_z="Cut 2: 0"),
        **section("Contact", Slave="Flank 2", Master="Flank 1"),
        "Solution/Increments": 4,
        "Probes/Probes": "hold: reaction moment z, Cut 2; part: contact force x, Flank 2; "
                         "peak: pressure, P"},
        {"hold": (torque, "balance"), "part": (force * math.sin(slope), "balance"),
         "peak": (line_contact(force, radius, stiffness), "Hertz")})


def clip():
    """A hook is pushed past a ridge, snaps in, and is pulled back against it."""
    drawing = Drawing()
    drawing.body("Hook", .35, [
        (0., 0.), (30., 0.), (30., 2., "Nose"), (27.6, 3.5, "Nose"), (26.6, 3.5, "Nose"),
        (25., 2., "Nose"), (23., 2.), (0., 2., "Root")])
    drawing.body("Ridge", .6, [
        (30., 8., "Lip", None, .6), (32., 3.5, "Lip", None, .4),
        (33., 2.5, "Lip", None, .4), (34.5, 2.5, "Lip", None, .4),
        (35.5, 3.5, "Lip", None, .4), (37.5, 8., "", None, .6), (37.5, 10., "Base"),
        (30., 10.)])
    return Scene({
        **drawing.write("clip"), **materials(Hook=PLASTIC, Ridge=PLASTIC),
        "Mesh/Points": "T: 30, 0",
        **section("Boundary conditions", Displacement_x="Root: 1, Base: 0",
                  Displacement_y="Root: 0, Base: 0",
                  Histories="Displacement x: table(0 0, 0.75 12, 1 8.2)"),
        **section("Contact", Slave="Nose", Master="Lip", Friction_coefficient=0.2),
        "Solution/Increments": 40,
        "Probes/Probes": "pull: reaction x, Root; up: reaction y, Base; "
                         "tip: displacement y, T"},
        {"pull": (-0.1962, finer(0.5, 0.1)), "up": (-0.1519, finer(0.5, 0.1)),
         "tip": (-0.7910, finer(0.5, 0.02))})


def sheet():
    """A sheet that yields is bent over the round edge of a die by a punch."""
    drawing = Drawing()
    drawing.body("Sheet", .17, [(-15., 0., "Below"), (15., 0.), (15., 1., "Above"),
                                (-4., 1., "Held"), (-15., 1., "End")])
    drawing.body("Die", 1., [(-15., -12., "Base"), (0., -12., "", None, .4),
                             (0., -4., "Edge", (-4., -4.), .3), (-4., 0., "Top", None, .3),
                             (-15., 0.)])
    return Scene({
        **drawing.write("sheet"), **materials(Sheet=ALUMINIUM, Die=STEEL),
        **section("Solids", Material="Sheet: elastic-plastic", Yield_stress="Sheet: 150",
                  Hardening_modulus="Sheet: 700"),
        "Mesh/Groups": "Bed: Edge, Top", "Mesh/Points": "T: 15, 0",
        **section("Boundary conditions", Displacement_x="Base: 0, End: 0",
                  Displacement_y="Base: 0, Held: 0"),
        **section("Contact die", Slave="Below", Master="Bed", Friction_coefficient=0.1),
        **section("Contact punch", Slave="Above", Obstacle="circle: 6.5, 5, 4",
                  Obstacle_motion="y: -9*t", Friction_coefficient=0.1),
        "Solution/Increments": 30,
        "Probes/Probes": "press: obstacle force y, Contact punch; "
                         "spread: obstacle force x, Contact punch; tip: displacement y, T"},
        {"press": (-5.581, finer(0.35, 0.1, 1)), "spread": (-7.743, finer(0.35, 1.0, 1)),
         "tip": (-14.341, finer(0.35, 0.01, 1))})


def flat_tube():
    """Half of a tube that yields, squeezed between two plates to 0.4 of its height."""
    drawing = Drawing()
    o = (0., 0.)
    drawing.body("Tube", .17, [
        (0., -10., "Skin", o), (10., 0., "Skin", o), (0., 10., "Middle"),
        (0., 9., "", o), (9., 0., "", o), (0., -9., "Middle")])
    drawing.block("Lower", .8, 0, -13, 18, -10, "Base", "", "Bed", "Middle")
    drawing.block("Upper", .8, 0, 10, 18, 13, "Sole", "", "Head", "Middle")
    return Scene({
        **drawing.write("flat_tube"), **materials(Tube=ALUMINIUM, Lower=STEEL, Upper=STEEL),
        **section("Solids", Material="Tube: elastic-plastic", Yield_stress="Tube: 200",
                  Hardening_modulus="Tube: 1000"),
        "Mesh/Points": "E: 10, 0",
        **section("Boundary conditions", Displacement_x="Middle: 0",
                  Displacement_y="Base: 0, Head: -12"),
        **section("Contact below", Slave="Skin", Master="Bed", Friction_coefficient=0.2),
        **section("Contact above", Slave="Skin", Master="Sole", Friction_coefficient=0.2),
        "Solution/Increments": 24,
        "Probes/Probes": "press: reaction y, Head; base: reaction y, Base; "
                         "wide: displacement x, E"},
        {"press": (-25.84, finer(0.4, 0.3, 1)), "base": (25.84, finer(0.4, 0.3, 1)),
         "wide": (3.900, finer(0.4, 0.1, 1))})


def o_ring():
    """A round rubber ring in its groove, squeezed by the lid by a fifth."""
    drawing = Drawing()
    drawing.body("Ring", .25, circle(20., 2.5, 2.5, "Top", "Top", "Sole", "Sole"))
    drawing.body("Housing", 1., [
        (12., -5., "Base"), (28., -5.), (28., 4.), (23.25, 4., "Groove", None, .5),
        (23.25, 0., "Groove", None, .5), (16.75, 0., "Groove", None, .5),
        (16.75, 4., "", None, .5), (12., 4.)])
    drawing.block("Lid", 1., 12, 5, 28, 9, "Face", "", "Head")
    return Scene({
        **drawing.write("o_ring"),
        **materials(Ring=(8, 0.499), Housing=STEEL, Lid=STEEL),
        **section("Solids", Material="Ring: neo-Hookean", Symmetry="axisymmetric"),
        "Mesh/Points": "C in Ring: 20, 0; I in Ring: 17.5, 2.5",
        **section("Boundary conditions", Displacement_x="Base: 0, Head: 0",
                  Displacement_y="Base: 0, Head: -1"),
        **section("Contact groove", Slave="Sole", Master="Groove", Friction_coefficient=0.2),
        **section("Contact lid", Slave="Top", Master="Face", Friction_coefficient=0.2),
        "Solution/Increments": 10,
        "Probes/Probes": "lid: reaction y, Head; base: reaction y, Base; "
                         "seal: pressure, C; bulge: displacement x, I"},
        {"lid": (-766.6, finer(0.5, 0.03)), "base": (766.6, finer(0.5, 0.03)),
         "seal": (3.009, finer(0.5, 0.5)), "bulge": (-0.2980, finer(0.5, 0.02))})


def hub_and_key():
    """A shaft drives a hub by a key: a moment at the hub's rim, the core is held."""
    drawing, torque = Drawing(), 4000.
    o, x = (0., 0.), math.sqrt(91)
    drawing.body("Shaft", 1., [
        *((x, y, "Journal", o, .4) for x, y in ((-10., 0.), (0., -10.), (10., 0.))),
        (3., x, "Seat", None, .4), (3., 6.5, "Seat", None, .4), (-3., 6.5, "Seat", None, .4),
        (-3., x, "Journal", o, .4)], circle(0., 0., 4., "Core"))
    drawing.body("Key", .4, [
        (-3., 6.5, "Foot"), (3., 6.5, "Foot"), (3., x, "Flank"), (3., 12.5),
        (-3., 12.5, "Flank"), (-3., x, "Foot")])
    drawing.body("Hub", 1.2, circle(0., 0., 20., "Rim"), [
        *((x, y, "Bore", o, .3) for x, y in ((-10., 0.), (0., -10.), (10., 0.))),
        (3., x, "Slot", None, .4), (3., 12.8, "", None, .4), (-3., 12.8, "Slot", None, .4),
        (-3., x, "Bore", o, .4)])
    friction = {"Friction_coefficient": 0.1}
    return Scene({
        **drawing.write("hub_and_key"), **materials(Shaft=STEEL, Key=STEEL, Hub=STEEL),
        "Mesh/Points": "A: 4, 0; B: 20, 0",
        **section("Boundary conditions", Rigid="Core: A, Rim: B", Displacement_x="Core: 0",
                  Displacement_y="Core: 0", Rotation_z="Core: 0", Moment_z=f"Rim: {torque}"),
        **section("Contact bore", Slave="Bore", Master="Journal", **friction),
        **section("Contact foot", Slave="Foot", Master="Seat", **friction),
        **section("Contact flank", Slave="Flank", Master="Slot", **friction),
        "Solution/Increments": 4,
        "Probes/Probes": "hold: reaction moment z, Core; turn: rotation z, Rim"},
        {"hold": (-torque, "balance"), "turn": (0.002385, finer(0.6, 0.7, 1))})


def dovetail():
    """Half of a blade's root that the blade pulls out of the disc."""
    drawing, pull = Drawing(), 600.
    drawing.body("Root", .6, [
        (0., 0.), (5., 0., "", None, .6), (5.8, .8, "Flank", None, .3),
        (3.8, 4.8, "", (5.58885, 5.69443), .3), (3.58885, 5.69443), (3.58885, 12., "Head"),
        (0., 12., "Middle")])
    drawing.body("Disc", 1., [
        (0., -8., "Base"), (16., -8., "Side"), (16., 5.6), (4.6, 5.6, "", None, .5),
                             (4., 4.4, "Slot", None, .3),
        (6.3, -.2, "Fillet", (5.1, -.2), .2), (5.1, -1.4, "", None, .3),
        (0., -1.4, "Middle")])
    return Scene({
        **drawing.write("dovetail"), **materials(Root=STEEL, Disc=ALUMINIUM),
        **section("Boundary conditions", Displacement_x="Middle: 0, Side: 0",
                  Displacement_y="Base: 0", Resultant_force_y=f"Head: {pull}"),
        **section("Contact", Slave="Flank", Master="Slot", Friction_coefficient=0.15),
        "Solution/Increments": 5,
        "Probes/Probes": "hold: reaction y, Base; wedge: reaction x, Side; "
                         "lift: displacement y, H",
        "Mesh/Points": "H: 0, 12"},
        {"hold": (-pull, "balance"), "wedge": (-715.2, finer(0.5, 0.02)),
         "lift": (0.1068, finer(0.5, 0.1))})


def flange():
    """Two flanges, pressed together by swing bolts in slots of their rims, as a ring;
    then pressure inside, which also pulls at the ends."""
    drawing, inner, pressure, preload = Drawing(), 40., 10, 150000
    for k, name in (1, "upper"), (-1, "lower"):
        drawing.body(f"Flange {name}", 2., [(x, k * y, *more) for x, y, *more in [
            (inner, 0., f"Seat {name}", None, .6), (55., 0., "", None, .6),
            (55., 1., "", None, .6), (70., 1.), (70., 13., f"Rest {name}"), (60., 13.),
            (45., 13., "", None, .8), (45., 50., f"End {name}"), (inner, 50., "Inside")]])
        drawing.body(f"Bolt {name}", 1.5, [(x, k * y, *more) for x, y, *more in [
            (71., 0., f"Cut {name}"), (77., 0.), (77., 20.), (62., 20.),
            (62., 13., f"Head {name}"), (71., 13.)]])
    thrust = pressure * math.pi * inner ** 2
    friction = {"Friction_coefficient": 0.15}
    bolts = (60000, 0.)  # eight of them: their share of the ring
    return Scene({
        **drawing.write("flange"),
        **materials(**{"Flange upper": STEEL, "Flange lower": STEEL, "Bolt upper": bolts,
                       "Bolt lower": bolts}),
        "Solids/Symmetry": "axisymmetric",
        **section("Boundary conditions", Displacement_y="End lower: 0",
                  Pressure=f"Inside: {pressure}", Resultant_force_y=f"End upper: {thrust}",
                  Histories="; ".join(f"{entry}: max(0, 2*t - 1)" for entry in (
                      "Pressure", "Resultant force y"))),
        **section("Contact seat", Slave="Seat upper", Master="Seat lower", **friction),
        **section("Contact head", Slave="Head upper", Master="Rest upper", **friction),
        **section("Contact nut", Slave="Head lower", Master="Rest lower", **friction),
        **section("Contact bolt", Slave="Cut upper", Master="Cut lower", Tied="true",
                  Preload=f"{preload}*min(1, 2*t)", Preload_end=0.5),
        "Solution/Increments": 8,
        "Mesh/Points": "E: 55, 1; I in Flange upper: 40, 0",
        "Probes/Probes": "seat: contact force y, Seat upper; bolt: preload, Contact bolt; "
                         "foot: reaction y, End lower; open: displacement y, E"},
        {"seat": (lambda probes: probes["bolt"] - thrust, "balance"),
         "foot": (-thrust, "balance"), "bolt": (127540, finer(0.35, 0.1)),
         "open": (0.0882, finer(0.35, 0.1))})


def bearing():
    """The lower half of the rollers between two stiff rings, under a radial load."""
    drawing, load, r, ring, o = Drawing(), 1000., 5., 20., (0., 0.)
    for k in range(5):
        a = math.radians(270 + 40 * (k - 2))
        x, y = (ring + r) * math.cos(a), (ring + r) * math.sin(a)
        drawing.body(f"Roller {k}", 1.6, [
            (x + r * math.cos(a + b), y + r * math.sin(a + b), f"{side} {k}", (x, y), f)
            for b, side, f in ((0, "Out", .05), (math.pi / 2, "In", 1), (math.pi, "In", .05),
                               (1.5 * math.pi, "Out", 1))])
    for name, (r0, group, size), (r1, race) in (
            ("Inner", (12., "Bore", 1), (ring, "Race in")),
            ("Outer", (40., "Seat", 2), (ring + 2 * r, "Race out"))):
        far = [(r0 * math.cos(a), r0 * math.sin(a), group, o, size)
               for a in (math.pi, 1.5 * math.pi)] + [(r0, 0., "", None, size)]
        near = [(r1 * math.cos(a), r1 * math.sin(a), race, o, .05 if k % 2 else 1)
                for k in range(1, 10) for a in [math.radians(370 - 20 * k)]]
        drawing.body(name, 1.6, [*far, (r1, 0., race, o), *near, (-r1, 0.)])
    share = [math.cos(math.radians(40 * k)) ** (19 / 9) for k in range(3)]
    first = load / (1 + 2 * sum(share[1:]))
    return Scene({
        **drawing.write("bearing"),
        **materials(Inner=STEEL, Outer=STEEL, **{f"Roller {k}": STEEL for k in range(5)}),
        "Mesh/Points": "B in Inner: 0, -12",
        **section("Boundary conditions", Displacement_x="Seat: 0, Bore: 0",
                  Displacement_y="Seat: 0", Rigid="Bore: B", Rotation_z="Bore: 0",
                  Force_y=f"Bore: {-load}"),
        **{key: value for k in range(5) for side, race in (("In", "in"), ("Out", "out"))
           for key, value in section(f"Contact {race} {k}", Slave=f"{side} {k}",
                                     Master=f"Race {race}", Friction_coefficient=0.1).items()},
        "Solution/Increments": 4,
        "Probes/Probes": "hold: reaction y, Seat; first: contact force y, Out 2; "
                         "second: contact force y, Out 3"},
        {"hold": (load, "balance"), "first": (first, "Palmgren"),
         "second": (first * share[1], "Palmgren")})


def cable():
    """Seven plastic strands in a clamp of two halves; nodes where they touch."""
    drawing, load, o = Drawing(), 20., (0., 0.)
    turns = [(math.cos(a), math.sin(a), (1, .25)[k % 2])  # finer where they touch
             for k in range(1, 13) for a in [math.radians(30 * k)]]
    places = [o] + [(2 * x, 2 * y) for x, y, _ in turns[::2]]
    for k, (x, y) in enumerate(places):
        drawing.body(f"Strand {k}", .4, [(x + c, y + s, "", (x, y), factor)
                                         for c, s, factor in turns])
    x = math.sqrt(9 - .04)
    for k, name in (1, "upper"), (-1, "lower"):
        drawing.body(f"Clamp {name}", .5, [
            (x, k * .2, "", o, .5),
            *((3 * c, k * 3 * s, "", o, .5 * factor) for c, s, factor in turns[:5]),
            (-x, k * .2, "", None, .5), (-6., k * .2), (-6., k * 6., f"Face {name}"),
            (6., k * 6.), (6., k * .2)])
    return Scene({
        **drawing.write("cable"),
        **materials(**{f"Strand {k}": PLASTIC for k in range(7)},
                    **{"Clamp upper": ALUMINIUM, "Clamp lower": ALUMINIUM}),
        "Mesh/Points": "H in Clamp upper: 0, 3",
        **section("Boundary conditions", Displacement_x="Face upper: 0, Face lower: 0",
                  Displacement_y="Face lower: 0", Resultant_force_y=f"Face upper: {-load}"),
        **section("Contact", Surfaces="automatic", Friction_coefficient=0.2),
        "Solution/Increments": 4,
        "Probes/Probes": "base: reaction y, Face lower; close: displacement y, H"},
        {"base": (load, "balance")})


SCENES = {scene.__name__: scene for scene in (
    gears, clip, sheet, flat_tube, o_ring, hub_and_key, dovetail, flange, bearing, cable)}
