#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs that ask for an accuracy on scenes that nothing was tuned on: true errors
beside the printed ones, misses, and give-ups that were not needed.

The reference of a probe is the better one of two sequences of meshes with 9-node
elements: refined uniformly, and by the energy estimate. Each has the limit of a
geometric sequence through its last three values, and what that adds as its
uncertainty; where the two differ by more than both uncertainties the difference
is that of the reference. It is 'unknown' where it is not known to a tenth of the
request.

Usage: own_scenes.py CONTACT [SCENE...]
"""

import itertools
import json
import math
import pathlib
import subprocess
import sys

from effectivity import limit  # the one beside this file

contact = pathlib.Path(sys.argv[1]).resolve()
REQUESTS = (1, 0.1, 0.03)
LIMIT = 20000  # unknowns of a run
STEEL, ALUMINIUM = (210000, 0.3), (70000, 0.33)


class Sections:
    """Polygons with straight and round sides, as a geometry for gmsh."""

    def __init__(self):
        self.lines = ["Mesh.RecombineAll = 1;", "Mesh.Algorithm = 6;",
                      "Mesh.SubdivisionAlgorithm = 1;"]
        self.n, self.groups, self.arcs = 0, {}, {}

    def body(self, name, size, *corners):
        """Corners: x, y, the group of the side behind it, the centre of that, and
        the size of cells there, as a factor."""
        first, sides = self.n + 1, []
        corners = [corner + ("", None, 1)[len(corner) - 2:]
                   for corner in corners]
        for k, (x, y, _, _, factor) in enumerate(corners):
            self.lines.append(f"Point({first + k}) = "
                              f"{{{x!r}, {y!r}, 0, {2 * size * factor!r}}};")
        number = first + len(corners)
        for k, (x, y, group, centre, _) in enumerate(corners):
            ends = first + k, first + (k + 1) % len(corners)
            if centre:
                self.lines += [f"Point({number}) = {{{centre[0]!r}, "
                               f"{centre[1]!r}, 0, {size}}};",
                               f"Circle({number + 1}) = {{{ends[0]}, {number}, "
                               f"{ends[1]}}};"]
                self.arcs[group] = (*centre, math.dist((x, y), centre))
            else:
                self.lines.append(
                    f"Line({number + 1}) = {{{ends[0]}, {ends[1]}}};")
            sides.append(number + 1)
            if group:
                self.groups.setdefault(group, []).append(number + 1)
            number += 2
        loop = ", ".join(map(str, sides))
        self.lines += [f"Curve Loop({number}) = {{{loop}}};",
                       f"Plane Surface({number}) = {{{number}}};",
                       f'Physical Surface("{name}") = {{{number}}};']
        self.n = number

    def write(self, name):
        groups = [f'Physical Curve("{group}") = {{{", ".join(map(str, lines))}}};'
                  for group, lines in self.groups.items()]
        pathlib.Path(f"{name}.geo").write_text("\n".join(self.lines + groups))
        subprocess.run(["gmsh", "-2", "-format", "msh22", f"{name}.geo", "-o",
                        f"{name}.msh"], check=True, capture_output=True)


def entries(bodies, points, probes, supports, degree=1, **more):
    """Of a scene; in the names of MORE '_' is a blank and '__' a slash."""
    result = {
        "Solids/Young's modulus": ", ".join(
            f"{body}: {e}" for body, (e, _) in bodies.items()),
        "Solids/Poisson's ratio": ", ".join(
            f"{body}: {nu}" for body, (_, nu) in bodies.items()),
        "Mesh/Points": points, "Probes/Probes": probes,
        "Element/Degree": degree, "Solution/Increments": 1,
        "Solids/Kinematics": "small strain"}
    for direction, values in supports.items():
        result[f"Boundary conditions/Displacement {direction}"] = values
    for key, value in more.items():
        result[key.replace("__", "/").replace("_", " ")] = value
    return result


def notch(s):
    s.body("Plate", 2, (2., -10., "Base"), (20., -10.), (20., 0., "Top"),
           (0., 0., "Middle", None, .3), (0., -8., "Root", (0., -10.), .3))
    s.body("Roller", 2, (0., 0., "Sole", (0., 30.), .3),
           (10., 30 - math.sqrt(800)), (10., 8., "Head"), (0., 8., "Middle"))
    return entries(
        {"Plate": ALUMINIUM, "Roller": STEEL},
        "R in Plate: 0, -8; C in Roller: 0, 0; E in Plate: 20, 0",
        "root: stress xx, R; pressure: pressure, C; push: reaction y, Head",
        {"x": "Middle: 0", "y": "Base: 0, Head: -0.05"}, 2,
        Contact__Slave="Sole", Contact__Master="Top")


def keyway(s):
    s.body("Lower", 3, (-20., -15., "Base"), (20., -15.), (20., 0.),
           (5., 0., "Slot", None, .5), (5., -4., "Slot", None, .5),
           (-5., -4., "Slot", None, .5), (-5., 0., "", None, .5), (-20., 0.))
    s.body("Key", 1.5, (-5., -4., "Below"), (5., -4., "Below"), (5., 0., "Above"),
           (5., 4., "Above"), (-5., 4., "Above"), (-5., 0., "Below"))
    s.body("Upper", 3, (-20., 1.), (-5., 1., "Hub", None, .5),
           (-5., 4., "Hub", None, .5), (5., 4., "Hub", None, .5),
           (5., 1., "", None, .5), (20., 1.), (20., 16., "Head"), (-20., 16.))
    return entries(
        {"Lower": STEEL, "Key": STEEL, "Upper": ALUMINIUM},
        "K in Key: 0, 0; M in Upper: 12, 8",
        "pull: reaction x, Base; key: displacement x, K; mises: von Mises, M",
        {"x": "Base: 0, Head: 0.05", "y": "Base: 0, Head: -0.02"},
        **{"Contact below/Slave": "Below", "Contact below/Master": "Slot",
           "Contact above/Slave": "Above", "Contact above/Master": "Hub",
           "Contact below/Friction coefficient": 0.1,
           "Contact above/Friction coefficient": 0.1})


def wheel(s):
    centre = (0., 20.)
    s.body("Wheel", 3, (-20., 20., "Tread", centre), (0., 0., "Tread", centre, .2),
           (20., 20.), (6., 20., "Hub", centre), (0., 14., "Hub", centre),
           (-6., 20.))
    s.body("Rail", 3, (-15., -10., "Base"), (15., -10.), (15., 0., "Head"),
           (0., 0., "Head", None, .2), (-15., 0.))
    return entries(
        {"Wheel": STEEL, "Rail": STEEL}, "C in Wheel: 0, 0; Q in Rail: 0, -2",
        "drag: reaction x, Hub; press: reaction y, Hub; deep: stress yy, Q",
        {"x": "Base: 0, Hub: 0.02", "y": "Base: 0, Hub: -0.05"}, 2,
        Contact__Slave="Tread", Contact__Master="Head",
        Contact__Friction_coefficient=0.3, Solution__Increments=2,
        Boundary_conditions__Histories=(
            "Displacement y: min(1, 2*t); Displacement x: max(0, 2*t - 1)"))


def clip(s):
    c, a = (0., 0.), math.radians(40)
    s.body("Clip", .6, (-5., 0., "Back"), (-6.5, 0., "Outer", c), (0., 6.5,
           "Outer", c), (6.5 * math.cos(a), 6.5 * math.sin(a)),
           (5 * math.cos(a), 5 * math.sin(a), "Inner", c), (0., 5., "Inner", c))
    s.body("Pin", 1.2, (-5., 0., "Middle"), (5., 0., "Skin", c),
           (0., 5., "Skin", c))
    return entries(
        {"Clip": STEEL, "Pin": ALUMINIUM},
        f"T in Clip: {6.5 * math.cos(a)!r}, {6.5 * math.sin(a)!r}; "
        "B in Clip: -6.5, 0; N in Pin: 5, 0; A in Clip: -5, 0",
        "tip: displacement y, T; hoop: stress yy, B; inside: stress yy, A",
        {"x": "N: 0", "y": "Back: 0, Middle: 0"}, 2, Contact__Slave="Skin",
        Contact__Master="Inner", Contact__Interference="0.05*t",
        Solids__Kinematics="large displacement")


def o_ring(s):
    c = (12., 0.)
    s.body("Ring", .5, (10., 0., "Skin", c), (12., -2., "Skin", c),
           (14., 0., "Cut"))
    s.body("Plate", 1, (7., -6., "Base"), (17., -6.), (17., -2., "Face"),
           (7., -2.))
    return entries(
        {"Ring": (10, 0.4), "Plate": (50, 0.3)},
        "I in Ring: 10, 0; C in Ring: 12, -2",
        "force: reaction y, Cut; bulge: displacement x, I; p: pressure, C",
        {"x": "Base: 0", "y": "Base: 0, Cut: -0.25"}, Contact__Slave="Skin",
        Contact__Master="Face", Solids__Symmetry="axisymmetric",
        Solids__Kinematics="large displacement")


def fit(s):
    s.body("Shaft", 3, (0., 0., "Middle"), (10., 0., "Journal"),
           (10., 12., "Journal", None, .4), (10., 25.), (0., 25.))
    s.body("Hub", 2, (10., 0., "Middle"), (18., 0.), (18., 12.),
           (10., 12., "Bore", None, .5))
    return entries(
        {"Shaft": STEEL, "Hub": ALUMINIUM}, "R in Hub: 18, 0; B in Hub: 10, 0; "
        "E in Hub: 18, 12",
        "rim: displacement x, R; hoop: stress zz, B; end: displacement y, E",
        {"y": "Middle: 0"}, Contact__Slave="Bore", Contact__Master="Journal",
        Contact__Interference="0.02*t", Contact__Friction_coefficient=0.15,
        Solids__Symmetry="axisymmetric")


def stack(s):
    for name, x, y0, y1, below, above in (
            ("Lower", 20., 0., 5., "Base", "Top1"),
            ("Middle", 14., 5., 8., "Sole1", "Top2"),
            ("Upper", 8., 8., 12., "Sole2", "Head")):
        s.body(name, 1.5, (0., y0, below), (x, y0), (x, y1, above),
               (0., y1, "Symmetry"))
    return entries(
        {"Lower": (3000, 0.4), "Middle": STEEL, "Upper": ALUMINIUM},
        "H in Upper: 0, 12; S in Middle: 0, 5; E in Middle: 14, 8",
        "head: displacement y, H; bend: stress xx, S; end: displacement y, E",
        {"x": "Symmetry: 0, Base: 0", "y": "Base: 0"},
        Boundary_conditions__Pressure="Head: 20",
        **{"Contact 1/Slave": "Sole1", "Contact 1/Master": "Top1",
           "Contact 2/Slave": "Sole2", "Contact 2/Master": "Top2",
           "Contact 2/Friction coefficient": 0.2})


def wedge(s):
    s.body("Wedge", 1, (0., 2.), (2.4, 2., "Flank", None, .5), (5., 15., "Head"),
           (0., 15., "Symmetry"))
    s.body("Block", 2, (2., 0., "Foot"), (14., 0., "Wall"), (14., 12.),
           (4.4, 12., "Jaw", None, .5))
    return entries(
        {"Wedge": STEEL, "Block": ALUMINIUM}, "P in Block: 8, 9; "
        "Q in Wedge: 0, 8",
        "spread: reaction x, Wall; drive: reaction y, Head; "
        "mises: von Mises, P",
        {"x": "Symmetry: 0, Wall: 0", "y": "Foot: 0, Head: -0.05"},
        Contact__Slave="Jaw", Contact__Master="Flank",
        Contact__Friction_coefficient=0.1)


def strip(s):
    s.body("Strip", .7, (0., 0., "Below"), (30., 0., "End"), (30., 1.),
           (0., 1., "Symmetry"))
    return entries(
        {"Strip": (2000, 0.3)}, "M in Strip: 15, 1; T in Strip: 0, 1",
        "end: reaction y, End; middle: displacement y, M; fibre: stress xx, T",
        {"x": "Symmetry: 0", "y": "End: -6"}, 2, Contact__Slave="Below",
        Contact__Obstacle="circle: 0, -20, 20", Solution__Increments=4,
        Solids__Kinematics="large displacement")


def bolt(s):
    s.body("Bolt", 1.5, (0., -20., "End"), (5., -20.), (5., 0., "Seat", None, .4),
           (8., 0., "", None, .5), (8., 5.), (0., 5.))
    s.body("Plate", 2, (5.5, -10.), (12., -10., "Base"), (20., -10.), (20., 0.),
           (8., 0., "Face", None, .4), (5.5, 0., "", None, .5))
    s.groups["Face"] = [s.groups["Face"][0]]
    return entries(
        {"Bolt": STEEL, "Plate": ALUMINIUM}, "A in Bolt: 0, -10; "
        "B in Plate: 5.5, -10; H in Bolt: 8, 5",
        "pull: reaction y, End; axis: stress yy, A; bore: displacement y, B",
        {"y": "Base: 0, End: -0.03"}, Contact__Slave="Face",
        Contact__Master="Seat", Solids__Symmetry="axisymmetric")


def cylinders(s):
    s.body("Upper", 2, (0., 0., "Sole", (0., 10.), .1), (10., 10., "Head"),
           (0., 10., "Middle"))
    s.body("Lower", 3, (0., -15., "Base"), (15., -15., "Crown", (0., -15.)),
           (0., 0., "Middle", None, .1))
    return entries(
        {"Upper": STEEL, "Lower": ALUMINIUM}, "C in Upper: 0, 0; "
        "Q in Lower: 0, -2",
        "peak: pressure, C; force: reaction y, Head; deep: stress yy, Q",
        {"x": "Middle: 0", "y": "Base: 0, Head: -0.05"}, Contact__Slave="Sole",
        Contact__Master="Crown")


def dovetail(s):
    s.body("Male", 1, (0., 0.), (5., 0., "Flank", None, .5),
           (3., 4., "", None, .5), (3., 10., "Head"), (0., 10., "Middle"))
    s.body("Female", 2, (0., -6., "Base"), (14., -6.), (14., 4.),
           (3., 4., "Groove", None, .3), (5.25, -.5, "", None, .4),
           (0., -.5, "Middle"))
    return entries(
        {"Male": STEEL, "Female": ALUMINIUM}, "N in Male: 3, 7; "
        "S in Female: 14, 4; F in Male: 0, 0",
        "pull: reaction y, Head; open: displacement x, S; "
        "foot: displacement y, F",
        {"x": "Middle: 0", "y": "Base: 0, Head: 0.03"}, 2,
        Contact__Slave="Flank", Contact__Master="Groove",
        Contact__Friction_coefficient=0.2)


PLANE = notch, keyway, wheel, clip, o_ring, fit, stack, wedge, strip, bolt, \
    cylinders, dovetail


def parameter_file(values):
    text = ""
    for entry, value in values.items():
        if entry == "include":
            text += f"include {value}\n"
            continue
        section, key = entry.split("/")
        text += f"subsection {section}\n  set {key} = {value}\nend\n"
    return text


def write(scene):
    """The name of its files, and its probes."""
    sections, name = Sections(), scene.__name__
    values = scene(sections)
    if not pathlib.Path(f"{name}.msh").exists():
        sections.write(name)
    values["Mesh/File"] = pathlib.Path(f"{name}.msh").resolve()
    if sections.arcs:
        values["Mesh/Arcs"] = "; ".join(
            f"{g}: " + ", ".join(map(repr, arc))
            for g, arc in sections.arcs.items())
    pathlib.Path(f"{name}.prm").write_text(parameter_file(values))
    return name, [probe.split(":")[0].strip()
                  for probe in values["Probes/Probes"].split(";")]


def summary(run):
    """Of a run that has ended, or none."""
    file = pathlib.Path(f"output/{run}/summary.json")
    found = json.loads(file.read_text()) if file.exists() else {}
    return found if found.get("levels") and not found["interrupted"] else None


def solve(runs):
    """All RUNS, {name: entries}, SCENE-... of a scene, in one process; what has
    been run before is kept."""
    for name, values in runs.items():
        pathlib.Path(f"{name}.prm").write_text(parameter_file(
            {"include": f"{name.split('-')[0]}.prm", **values}))
    todo = [f"{name}.prm" for name in runs if summary(name) is None]
    if todo:
        subprocess.run([str(contact), *todo, "--quiet"], capture_output=True)


REFERENCES = {
    name: {"Element/Degree": 2, "Element/Centre node": "free",
           "Refinement/Levels": levels, "Refinement/Strategy": name,
           "Refinement/Tolerance": 1e-8, "Solution/Geometry tolerance": 1e-6,
           "Probes/Errors": "none"}
    for name, levels in (("uniform", 4), ("adaptive", 12))}


def reference(sequences, probe):
    """The limit, and its uncertainty."""
    known = []
    for name, run in sequences.items():
        if run is None or not run["converged"] or len(run["levels"]) < 3:
            continue
        values = [level["probes"][probe] for level in run["levels"]]
        value, more = limit(values)
        if name == "adaptive":  # its meshes are no geometric sequence
            value = values[-1]
            more = max(abs(values[-1] - values[-2]),
                       abs(values[-2] - values[-3]))
        known.append((value, more))
    known.sort(key=lambda pair: pair[1])
    if len(known) < 2:
        return known[0] if known else (math.nan, math.inf)
    (value, own), (other, its) = known
    apart = abs(value - other)
    return value, apart if apart > own + its else own


def seconds(run):
    return sum(phase["cpu"] for level in run["levels"]
               for phase in level["time"].values())


def status(run):
    if run is None:
        return "no result"
    if not run["converged"]:
        return "3"
    if run["accuracy_missed"] or any(f["severity"] == "violated"
                                     for f in run["findings"]):
        return "1"
    return "0"


class Bars:
    """Counts what the bars are about."""

    def __init__(self):
        self.met, self.missed, self.ratios, self.given_up = 0, [], [], []
        self.ended, self.unknown, self.other = 0, 0, []

    def row(self, scene, probe, percent, run, value, known):
        name, how = f"{scene}-{probe}-{percent:g}", status(run)
        if how not in "01":
            self.other.append(f"{name}: {how}")
            return ""
        self.ended += 1
        found = next(p for p in run["probes"] if p["name"] == probe)
        scale = 100 / abs(value)
        true, printed = (scale * abs(found["value"] - value),
                         scale * abs(found["estimated_error"] or math.nan))
        if not scale * known <= percent / 10:
            self.unknown += 1
            text = f"{true:.2g} % +-{scale * known:.1g}, unknown"
        else:
            text = f"{true:.2g} % +-{scale * known:.1g}"
            if how == "0":
                self.met += true <= percent
                if not true <= percent:
                    self.missed.append(f"{name} ({true:.2g} %)")
                if scale * known < max(true, printed) / 4:
                    self.ratios.append((true / printed, name))
            elif true < percent / 3:
                self.given_up.append(f"{name} ({true:.2g} %)")
        return (f"| {scene} | {probe} | {percent:g} % | {printed:.2g} % | {text} "
                f"| {how} | {run['unknowns']['displacement']} | "
                f"{seconds(run):.1f} |")

    def summary(self):
        ratios = sorted(self.ratios)
        above = [f"{name} ({ratio:.1f})" for ratio, name in ratios if ratio > 2]
        return "\n".join([
            "", "| of all rows | |", "|---|---|",
            f"| runs with exit status 0 or 1; reference unknown | {self.ended}; "
            f"{self.unknown} |",
            f"| exit 0, met | {self.met} |",
            f"| exit 0, not met | {len(self.missed)}: "
            f"{', '.join(self.missed)} |",
            f"| true above twice the printed error | {len(above)} of "
            f"{len(ratios)}: {', '.join(above)} |",
            f"| exit 1, true error below a third of the request | "
            f"{len(self.given_up)}: {', '.join(self.given_up)} |",
            f"| no result | {len(self.other)} |"])


def main():
    scenes = [scene for scene in PLANE if scene.__name__ in sys.argv[2:] or
              len(sys.argv) == 2]
    probes = dict(map(write, scenes))
    # Each probe and each request of a scene once, the references, and the rest.
    first, references, rest = {}, {}, {}
    for scene, names in probes.items():
        for (i, probe), (j, percent) in itertools.product(enumerate(names),
                                                          enumerate(REQUESTS)):
            (first if i == j else rest)[f"{scene}-{probe}-{percent:g}"] = {
                "Probes/Accuracy": f"{probe}: {percent} %",
                "Refinement/Limits": f"unknowns: {LIMIT}"}
        for key, values in REFERENCES.items():
            references[f"{scene}-{key}"] = values
    solve({**first, **references, **rest})
    bars = Bars()
    print("| scene | probe | asked | printed | true | exit status | unknowns | "
          "s |\n|---|---|---|---|---|---|---|---|")
    for scene, names in probes.items():
        sequences = {key: summary(f"{scene}-{key}") for key in REFERENCES}
        for probe, percent in itertools.product(names, REQUESTS):
            row = bars.row(scene, probe, percent,
                           summary(f"{scene}-{probe}-{percent:g}"),
                           *reference(sequences, probe))
            if row:
                print(row)
    print(bars.summary())


if __name__ == "__main__":
    main()
