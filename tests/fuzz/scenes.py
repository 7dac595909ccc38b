#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random scenes of two bodies in contact, solved and checked.

    scenes.py [--number N] [--first SEED] [--only SEED,...] [--output DIR]
              [--processes P] [--limit SECONDS] [--set Section/Entry=value]
              CONTACT

The number of a scene is its seed: each can be made alone. A scene has a
solution as far as one can tell beforehand (bodies are held, friction that holds
a body is strong enough, mean strains of some percent at most), so that "did not
converge" is a failure of the program or a scene worth looking at. What
"converged" is worth is checked by verify.py. Writes scenes.csv and scenes.md.
Exit status: 0, 1 if a scene crashed, hung, was refused or is wrong.
"""
import argparse
import collections
import csv
import math
import pathlib
import random
import sys

import mesh_files
import runner
import verify

def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def number(value):
    return "%.10g" % value


class Scene:
    """Everything about a scene; all of it follows from the seed."""

    FEATURES = ("shape", "slave", "rule", "friction", "friction_solver",
                "degree", "kinematics", "geometry", "system", "support", "load",
                "history", "increments", "levels", "cells", "mesh_ratio",
                "stiffness_ratio")
    PREFIX = "scene"

    def __init__(self, seed):
        self.seed = seed
        self.name = "%s_%d" % (self.PREFIX, seed)
        self.entries = {}
        self.features = {}
        # Resultants for verify.py; None: not determined by statics.
        self.force_x = self.force_y = None
        rng = self.rng = random.Random(seed)
        self.choose_geometry(rng)
        self.choose_materials(rng)
        self.choose_contact(rng)
        self.choose_load(rng)
        self.choose_solution(rng)

    def problems(self, directory, summary):
        """What is wrong with its results."""
        return verify.problems(self, directory, summary)

    def set(self, entry, value):
        self.entries[entry] = value

    def add(self, entry, text, separator=", "):
        before = self.entries.get("Boundary conditions/" + entry)
        self.set("Boundary conditions/" + entry,
                 before + separator + text if before else text)

    # The shapes and the meshes.
    def choose_geometry(self, rng):
        f = self.features
        size = self.size = log_uniform(rng, 0.1, 100)
        shape = f["shape"] = rng.choice(["blocks", "blocks", "bump", "bump",
                                         "half bump", "unlike", "wedge"])
        width = size
        left = 0.0
        if shape in ("blocks", "wedge", "unlike"):
            kind = rng.choice(["equal", "smaller", "larger", "shifted"])
            if kind == "smaller":
                width = size * rng.uniform(0.3, 0.9)
                left = rng.uniform(0, size - width)
            elif kind == "larger":
                width = size * rng.uniform(1.1, 2)
                left = -rng.uniform(0, width - size)
            elif kind == "shifted":
                left = size * rng.uniform(-0.3, 0.3)
        self.width, self.left = width, left
        self.lower_height = size * rng.uniform(0.3, 1.5)
        self.height = size * rng.uniform(0.3, 1.5)
        h = self.lower_height
        slope = rng.uniform(-0.3, 0.3) if shape == "wedge" else 0.0
        self.slope = slope
        self.gap = 0.0
        self.radius = None
        lower_top = mesh_files.flat(h, slope)
        bottom = mesh_files.flat(h, slope)
        is_arc = False
        if shape in ("bump", "half bump", "unlike"):
            reach = width if shape == "half bump" else width / 2
            centre = left if shape == "half bump" else left + width / 2
            sag = reach * log_uniform(rng, 0.01, 0.3)
            self.radius = (reach ** 2 + sag ** 2) / (2 * sag)
            is_arc = rng.random() < 0.5
            curve = mesh_files.arc if is_arc else mesh_files.parabola
            bottom = curve(h, centre, self.radius)
            if shape == "unlike":
                # A round hollow, wider than what lies in it, or a hill.
                flatness = rng.choice([-3, -1, 1.5, 3])
                lower_top = mesh_files.parabola(h, centre,
                                                flatness * self.radius)
                self.radius = 1 / (1 / self.radius
                                   - 1 / (flatness * self.radius))
                lowest = min(lower_top(0), lower_top(size))
                if lowest < 0.3 * h:
                    lower_top = mesh_files.flat(h)
                    self.radius = (reach ** 2 + sag ** 2) / (2 * sag)
            self.centre = centre
            if is_arc:
                radius = (reach ** 2 + sag ** 2) / (2 * sag)
                self.arc = (centre, h + radius, radius)
        if shape == "blocks" and rng.random() < 0.15:
            self.gap = self.height * log_uniform(rng, 1e-4, 3e-3)
        floor, top = mesh_files.flat(0), h + self.gap + self.height
        if slope:
            top += abs(slope) * 2 * size
        gap = self.gap
        upper_bottom = lambda x: bottom(x) + gap

        ratio = log_uniform(rng, 0.1, 10)
        coarse = round(log_uniform(rng, 1, 12))
        n_lower, n_upper = ((coarse, max(1, round(coarse * ratio)))
                            if ratio > 1 else
                            (max(1, round(coarse / ratio)), coarse))
        while n_lower > 60 or n_upper > 60:
            n_lower, n_upper = max(1, n_lower // 2), max(1, n_upper // 2)
        f["mesh_ratio"] = n_upper / n_lower
        rows = [max(1, min(round(n * log_uniform(rng, 0.3, 1.5)), 140 // n, 12))
                for n in (n_lower, n_upper)]
        self.quads_only = rng.random() < 0.5
        triangles = [0, 0] if self.quads_only else [
            rng.choice([0, 0.5, 1]) for _ in range(2)]
        distortion = rng.choice([0, 0, 0.1, 0.2])
        self.lower = mesh_files.Body("Lower", 0, size, floor, lower_top,
                                     (n_lower, rows[0]))
        narrowing = rng.uniform(-0.3, 0.4) if shape == "unlike" else 0.0
        self.upper = mesh_files.Body("Upper", left, left + width, upper_bottom,
                                     mesh_files.flat(top), (n_upper, rows[1]),
                                     narrowing)
        self.lower.build(rng, distortion, triangles[0],
                         rng.choice([1, 1, 1.1, 0.9]))
        grading = 1 if shape == "bump" else rng.choice([1, 1, 1.1, 0.9])
        self.upper.build(rng, distortion, triangles[1], grading)
        f["cells"] = len(self.lower.cells) + len(self.upper.cells)
        if is_arc:
            self.set("Mesh/Arcs", "Upper_face: " +
                     ", ".join(map(number, (self.arc[0], self.arc[1] + gap,
                                            self.arc[2]))))
        self.version = rng.choice(["2.2", "4.1"])
        self.second_order = rng.random() < 0.1

    def mesh(self):
        nx, ny = self.upper.nx, self.upper.ny
        lines = {"Floor": (self.lower, "Bottom"),
                 "Left_L": (self.lower, "Left"),
                 "Lower_face": (self.lower, "Top"),
                 "Top": (self.upper, "Top"), "Left_U": (self.upper, "Left"),
                 "Right_U": (self.upper, "Right"),
                 "Upper_face": (self.upper, "Bottom")}
        points = {"Top_point": (self.upper, (nx // 2, ny)),
                  "Face_point": (self.upper, (nx // 2, 0)),
                  "Corner": (self.upper, (0, 0)),
                  "Floor_point": (self.lower, (0, 0))}
        return mesh_files.msh_text([self.lower, self.upper], lines, points,
                                   self.version, random.Random(self.seed),
                                   self.second_order)

    def choose_materials(self, rng):
        ratio = log_uniform(rng, 1e-3, 1e3)
        young = log_uniform(rng, 1e2, 2e5)
        self.young = (young, young * ratio)
        self.poisson = [rng.choice([0, 0.3, 0.3, rng.uniform(0, 0.45), 0.49])
                        for _ in range(2)]
        self.features["stiffness_ratio"] = ratio
        self.set("Solids/Young's modulus", "Lower: %s, Upper: %s" %
                 tuple(map(number, self.young)))
        self.set("Solids/Poisson's ratio", "Lower: %s, Upper: %s" %
                 tuple(map(number, self.poisson)))
        self.features["kinematics"] = rng.choice(["small strain",
                                                  "large displacement"])
        self.set("Solids/Kinematics", self.features["kinematics"])
        degree = self.features["degree"] = rng.choice([1, 1, 2])
        self.set("Element/Degree", str(degree))
        if degree == 2:
            self.set("Element/Centre node", rng.choice(["serendipity", "free"]))

    def choose_contact(self, rng):
        f = self.features
        upper_slave = rng.random() < 0.6
        f["slave"] = "upper" if upper_slave else "lower"
        self.slave_is_upper = upper_slave
        faces = ["Upper_face", "Lower_face"]
        self.set("Contact/Slave", faces[0 if upper_slave else 1])
        self.set("Contact/Master", faces[1 if upper_slave else 0])
        f["rule"] = rng.choice(["nodal"] * 4 + ["mortar"] * 5 + ["Gauss"])
        self.set("Contact/Discretization", f["rule"])
        f["friction"] = rng.choice(["none"] * 3 + ["Coulomb"] * 5 +
                                   ["Tresca"])
        self.mu = 0.0
        if f["friction"] == "Coulomb":
            self.mu = rng.choice([0.1, 0.3, rng.uniform(0.01, 1), 1.0])
            self.set("Contact/Friction coefficient", number(self.mu))

    # Supports and loads, sized by the strain of the softer body.
    def choose_load(self, rng):
        f = self.features
        soft = min(self.young)
        strain = log_uniform(rng, 2e-4, 0.02)
        self.traction = traction = strain * soft
        self.tresca = 0.0
        if f["friction"] == "Tresca":
            self.tresca = traction * log_uniform(rng, 0.03, 1)
            self.set("Contact/Tresca limit", number(self.tresca))
        loaded = self.width * (1 - self.upper.narrowing)
        force = traction * min(loaded, self.width)
        round_body = self.radius is not None
        if round_body:
            # Half the width of contact by Hertz, a part of the body's.
            plane = sum((1 - nu ** 2) / e
                        for e, nu in zip(self.young, self.poisson))
            half = log_uniform(rng, 0.05, 0.4) * self.width / 2
            hertz = math.pi * half ** 2 / (4 * plane * self.radius)
            if f["shape"] == "half bump":
                half *= 2
                hertz = math.pi * half ** 2 / (8 * plane * self.radius)
            force = min(force, hertz)

        supports = ["pressed top", "roller", "top in x"]
        if f["shape"] in ("bump", "unlike"):
            supports = ["pressed top", "roller"]
        if f["shape"] == "half bump":
            supports = ["roller"]
        if f["shape"] == "wedge":
            supports = ["pressed top", "top in x"]
        if f["shape"] == "blocks" and self.gap == 0:
            supports.append("point in x")
            # Held by friction alone: strong, and the resultant well inside.
            if self.mu >= 0.2:
                supports.append("friction")
        if self.gap > 0:
            supports = ["pressed top"]
        if self.upper.narrowing != 0 and "roller" in supports:
            supports = ["pressed top"]
        support = rng.choice(supports)
        # A body that contact alone keeps from turning over.
        turning = {"top in x": abs(self.slope) + self.mu +
                   self.tresca / traction, "point in x": 0, "friction": 0}
        if support in turning and self.overlap() <= max(
                0.2 * self.width, 3 * turning[support] * self.height):
            support = "pressed top"
        f["support"] = support

        # The lower body.
        self.add("Displacement y", "Floor: 0")
        self.add("Displacement x",
                 rng.choice(["Floor: 0", "Floor: 0", "Floor_point: 0"]))

        histories = {
            "t": "", "load, unload": "if(t < 0.5, 2*t, 1.5 - t)",
            "early": "min(1, 2*t)", "quadratic": "t*t"}
        f["history"] = history = rng.choice(["t", "t"] + list(histories))
        factor_at_end = 0.5 if history == "load, unload" else 1.0
        pressing = []

        # A shift in x: where friction slips in part, or everywhere.
        shift = 0.0
        if support in ("pressed top", "top in x") and rng.random() < 0.6:
            shear = max(self.mu * traction, self.tresca, 0.2 * traction)
            shift = (rng.choice([-1, 1]) * log_uniform(rng, 0.1, 3) * shear *
                     2.6 * (self.height / self.young[1] +
                            self.lower_height / self.young[0]))
            limit = 0.05 * min(self.height, self.lower_height)
            shift = max(-limit, min(limit, shift))

        if support == "pressed top":
            f["load"] = "displacement"
            flexible = (self.height / self.young[1] +
                        self.lower_height / self.young[0])
            depth = flexible * force / self.width + self.gap
            self.add("Displacement y", "Top: " + number(-depth))
            self.add("Displacement x", "Top: " + number(shift))
            pressing.append("Displacement y")
        else:
            choices = ["spread force", "pressure", "force"]
            if support == "friction":
                choices = ["spread force", "pressure"]
            load = f["load"] = rng.choice(choices)
            if self.upper.narrowing:
                load = f["load"] = "spread force"
            if load == "force":
                # It bends what is under it more than a pressure does.
                force *= 0.2
                # Off the middle, it could turn the body over.
                if support != "roller" and self.upper.nx % 2:
                    load = f["load"] = "spread force"
            if load == "force":
                self.add("Force y", "Top_point: " + number(-force))
                pressing.append("Force y")
            elif load == "spread force":
                self.add("Resultant force y", "Top: " + number(-force))
                pressing.append("Resultant force y")
            else:
                self.add("Pressure", "Top: " + number(force / loaded), "; ")
                pressing.append("Pressure")
            self.force_y = -force * factor_at_end
            if support == "roller":
                self.add("Displacement x", "Left_U: 0")
            elif support == "top in x":
                self.add("Displacement x", "Top: " + number(shift))
            elif support == "point in x":
                self.add("Displacement x", "Corner: 0")
            elif support == "friction":
                push = 0.4 * self.mu * min(
                    1, self.overlap() / self.height / self.mu / 2)
                push *= force * rng.uniform(-1, 1)
                self.add("Resultant force x", "Top: " + number(push))
                pressing.append("Resultant force x")
                self.force_x = push * factor_at_end
        entries = []
        if histories[history]:
            entries += ["%s: %s" % (p, histories[history]) for p in pressing]
        if shift and rng.random() < 0.5:
            f["history"] += ", shift back and forth"
            entries.append("Displacement x: sin(2*pi*t)"
                           if rng.random() < 0.5 else
                           "Displacement x: if(t < 0.5, 0, 2*t - 1)")
        if entries:
            self.set("Boundary conditions/Histories", "; ".join(entries))

    def facing(self):
        """The x of the nodes of the slave which are opposite to the master."""
        slave, master = ((self.upper, self.lower) if self.slave_is_upper else
                         (self.lower, self.upper))
        low, high = master.nodes[0, 0][0], master.nodes[master.nx, 0][0]
        row = 0 if self.slave_is_upper else slave.ny
        xs = [slave.nodes[i, row][0] for i in range(slave.nx + 1)]
        return [x for x in xs if low <= x <= high]

    def overlap(self):
        """How far the resultant, in the middle of the upper body, is from the
        last places that can carry it, twice."""
        middle = self.left + self.width / 2
        xs = self.facing()
        if not xs:
            return 0.0
        return max(0.0, 2 * min(middle - xs[0], xs[-1] - middle))

    # Choose entries of the solution that go together.
    def choose_solution(self, rng):
        f = self.features
        f["increments"] = rng.choice([1, 2, 2, 3, 4])
        self.set("Solution/Increments", str(f["increments"]))
        system = "saddle point"
        if f["rule"] != "Gauss" and rng.random() < (
                0.75 if f["rule"] == "mortar" else 0.5):
            system = "condensed"
        f["system"] = system
        self.set("Solution/System", system)
        geometries = ["fixed point", "fixed point", "each step"]
        if f["kinematics"] == "small strain":
            geometries += ["undeformed", "undeformed"]
        if system == "saddle point" and f["rule"] != "mortar":
            geometries += ["Newton", "Newton"]
        f["geometry"] = rng.choice(geometries)
        self.set("Solution/Geometry", f["geometry"])
        f["friction_solver"] = "-"
        if f["friction"] != "none":
            f["friction_solver"] = rng.choice(["fixed point", "Newton", "Newton"])
            self.set("Solution/Friction", f["friction_solver"])
        f["levels"] = 0
        if system == "condensed":
            if rng.random() < 0.15:
                self.set("Solution/Linear solver", rng.choice(["AMG", "MUMPS"]))
            if rng.random() < 0.15 and f["cells"] < 150:
                f["levels"] = 1
                self.set("Refinement/Levels", "1")
                if self.quads_only and rng.random() < 0.5:
                    self.set("Refinement/Strategy", "adaptive")
        self.set("Mesh/File", self.name + ".msh")
        self.set("Probes/Probes", "top: displacement y, Top_point; "
                 "face: stress yy, Face_point")
        self.set("Output/Profile", "true")

    def parameters(self):
        sections = collections.OrderedDict()
        for path, value in self.entries.items():
            section, entry = path.split("/", 1)
            sections.setdefault(section, []).append((entry, value))
        text = "# %s of tests/fuzz\n" % self.name
        for section, entries in sections.items():
            text += "\nsubsection %s\n" % section
            text += "".join("  set %s = %s\n" % e for e in entries)
            text += "end\n"
        return text

    def write(self, directory):
        directory.mkdir(parents=True, exist_ok=True)
        (directory / (self.name + ".msh")).write_text(self.mesh())
        (directory / (self.name + ".prm")).write_text(self.parameters())


def solve(kind, seed, binary, output, limit, sanitized, overrides):
    """One scene: what it is, how it ended, and what is wrong with it."""
    scene = kind(seed)
    directory = output / scene.name
    scene.write(directory)
    options = ["--quiet"]
    for assignment in overrides:
        options += ["--set", assignment]
    result = runner.run(binary, directory, scene.name + ".prm", limit,
                        sanitized, options)
    problems = []
    summary = runner.read_summary(directory, scene.name)
    if result.outcome == "converged":
        problems = scene.problems(directory, summary)
    newton = sum(i["newton_iterations"] for i in summary["increments"]
                 ) if summary else 0
    return scene, result, problems, newton


def rates(solved, feature):
    """How the scenes of each value of a feature ended."""
    groups = collections.defaultdict(list)
    for scene, result, problems, _ in solved:
        value = scene.features[feature]
        if feature in ("mesh_ratio", "stiffness_ratio"):
            decade = math.floor(math.log10(value) + 0.5)
            value = "about 1e%+d" % decade
        elif feature == "cells":
            value = "up to %d" % (50 * math.ceil(value / 50))
        groups[str(value)].append((result, problems))
    rows = []
    for value in sorted(groups):
        results = groups[value]
        n = len(results)
        converged = [p for r, p in results if r.outcome == "converged"]
        rows.append([feature, value, n,
                     "%.1f %%" % (100 * len(converged) / n),
                     sum(1 for p in converged if p)] +
                    [sum(1 for r, _ in results if r.outcome == o)
                     for o in ("not converged", "refused", "crashed", "hung")])
    return rows


def report(kind, solved, output):
    n = len(solved)
    ok = [s for s in solved if s[1].outcome == "converged"]
    wrong = [s for s in ok if s[2]]
    text = ["# Random scenes\n",
            "%d scenes, %d converged (%.1f %%), %d of these with results that "
            "fail a check.\n" % (n, len(ok), 100 * len(ok) / max(n, 1),
                                 len(wrong))]
    rows = []
    for feature in kind.FEATURES:
        rows += rates(solved, feature)
    text.append(runner.table(["", "value", "scenes", "converged", "wrong",
                              "not converged", "refused", "crashed", "hung"],
                             rows))
    text.append("\n## What did not converge, by message\n")
    messages = collections.defaultdict(list)
    for scene, result, problems, _ in solved:
        if result.outcome != "converged":
            messages[result.outcome + ": " +
                     runner.kind(result.message)].append(scene)
        for problem in problems:
            messages["WRONG: " + runner.kind(problem)].append(scene)
    rows = []
    for text_of, scenes in sorted(messages.items(), key=lambda k: -len(k[1])):
        scenes.sort(key=lambda s: s.features["cells"])
        rows.append([text_of, len(scenes), " ".join(
            str(s.seed) for s in scenes[:15])])
    text.append(runner.table(["message", "scenes",
                              "seeds, those with fewest cells first"], rows))
    text = "\n".join(text) + "\n"
    (output / (kind.PREFIX + "s.md")).write_text(text)
    with open(output / (kind.PREFIX + "s.csv"), "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["seed", "outcome", "status", "seconds", "newton",
                         *kind.FEATURES, "problems", "message"])
        for scene, result, problems, newton in solved:
            writer.writerow([scene.seed, result.outcome, result.status,
                             "%.2f" % result.seconds, newton,
                             *(scene.features[f] for f in kind.FEATURES),
                             "; ".join(problems),
                             result.message.replace("\n", " | ")[:400]])
    return text


def run_scenes(kind, binary, seeds, output, processes=2, limit=60,
               overrides=()):
    sanitized = runner.is_sanitized(binary)
    output.mkdir(parents=True, exist_ok=True)
    solved = runner.in_parallel(
        lambda seed: solve(kind, seed, binary, output, limit, sanitized,
                           overrides),
        seeds, processes)
    return solved, report(kind, solved, output)


def failures(solved, least=0.0):
    """What must not happen, whatever the scene is; `least` is the share of the
    scenes that has to converge, or to be told that its mesh is too coarse for what
    meets there (a violated depth)."""
    lines = []
    for scene, result, problems, _ in solved:
        # The condensed system cannot take a slave node that is held in x and
        # sticks to a master that is not, and says what can.
        if (result.outcome == "refused" and
                "is held by a support" in result.message):
            continue
        if result.outcome in ("crashed", "hung", "refused"):
            lines.append("%s %s: %s" % (scene.name, result.outcome,
                                        result.message))
        lines += ["%s: %s" % (scene.name, p) for p in problems]
    def is_told(text):
        violated = text.count(": violated: ")
        return violated > 0 and violated == text.count(": violated: depth: ")

    answered = sum(1 for _, result, _, _ in solved
                   if result.outcome == "converged" or
                   (result.outcome == "violated" and is_told(result.output)))
    if answered < least * len(solved):
        lines.append("only %d of %d scenes converged or are told to be too coarse"
                     % (answered, len(solved)))
    return lines


def main(kind, purpose):
    parser = argparse.ArgumentParser(description=purpose.split("\n")[0])
    parser.add_argument("contact")
    parser.add_argument("--number", type=int, default=300)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--only", help="seeds, separated by ','")
    parser.add_argument("--output", default="output/fuzz")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--set", action="append", default=[])
    options = parser.parse_args()
    seeds = ([int(s) for s in options.only.split(",")] if options.only else
             range(options.first, options.first + options.number))
    solved, text = run_scenes(kind, options.contact, seeds,
                              pathlib.Path(options.output),
                              options.processes, options.limit, options.set)
    print(text)
    if options.only:
        for scene, result, problems, _ in solved:
            print(scene.name, scene.features)
            print(result.outcome, result.message, *problems, sep="\n")
    bad = failures(solved)
    for line in bad:
        print("FAILED:", line)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(Scene, __doc__))
