#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The price list: what an effect costs where everything else stays.

    effects.py [--repetitions N] [--cells N] CONTACT [EFFECT...]

The scene is two blocks in small strain whose supports are moved, with linear
elements, one increment and no files; one effect at a time is switched on, and
compared with the scene without it. Of several runs, by turns with those of the
other scenes, the smallest CPU and wall time and memory count. A Markdown table.
"""

import argparse
import pathlib
import sys
import tempfile

import scenes

CONTACT = {**scenes.CONTACT}
TIED = {**CONTACT, "Contact/Tied": "true"}
SADDLE_POINT = {"Solution/System": "saddle point"}
NODAL = {**CONTACT, "Contact/Discretization": "nodal"}
GAUSS = {**CONTACT, "Contact/Discretization": "Gauss"}
TRESCA = {**CONTACT, "Contact/Tresca limit": "20"}
COULOMB = {**CONTACT, "Contact/Friction coefficient": "0.2"}
LOOP = {"Solution/Geometry": "fixed point"}
LARGE = {"Solids/Kinematics": "large displacement", **LOOP}
LEVEL = {"Refinement/Levels": "1"}
FOUR = {"Solution/Increments": "4"}

# Effect, its entries, and the effect it is compared with; None: the scene.
EFFECTS = (
    ("bodies alone", {}, None),
    ("tied", TIED, "bodies alone"),
    ("contact, mortar rule", CONTACT, "bodies alone"),
    ("contact, nodal rule, condensed",
     {**NODAL, "Solution/System": "condensed"}, "contact, mortar rule"),
    ("contact, nodal rule, saddle point", {**NODAL, **SADDLE_POINT},
     "contact, nodal rule, condensed"),
    ("contact, Gauss rule", GAUSS, "contact, nodal rule, saddle point"),
    ("friction of Tresca", TRESCA, "contact, mortar rule"),
    ("friction of Coulomb", COULOMB, "contact, mortar rule"),
    ("quadratic elements", {"Element/Degree": "2"}, "bodies alone"),
    ("large displacement", {**LARGE}, "bodies alone"),
    ("geometry loop", {**CONTACT, **LOOP}, "contact, mortar rule"),
    ("large displacement, contact", {**CONTACT, **LARGE}, "geometry loop"),
    # About the left edge of the lower block.
    ("axisymmetry", {"Solids/Symmetry": "axisymmetric", "Mesh/Shift": "1, 0"},
     "bodies alone"),
    ("rigid obstacle instead of a master", scenes.OBSTACLE,
     "contact, mortar rule"),
    ("obstacle that moves", scenes.MOVING,
     "rigid obstacle instead of a master"),
    ("obstacle under a force", scenes.PUSHED,
     "rigid obstacle instead of a master"),
    ("interference", {**CONTACT, **scenes.OVERLAP}, "contact, mortar rule"),
    ("rigid boundary", {**CONTACT, **scenes.RIGID}, "contact, mortar rule"),
    ("thermal strain", {**CONTACT, **scenes.HOT}, "contact, mortar rule"),
    ("incompatible modes", {**CONTACT, **scenes.MODES},
     "contact, mortar rule"),
    ("neo-Hookean bodies", {**CONTACT, **LARGE, **scenes.NEO_HOOKEAN},
     "large displacement, contact"),
    ("Mooney-Rivlin bodies", {**CONTACT, **LARGE, **scenes.MOONEY_RIVLIN},
     "large displacement, contact"),
    ("four increments", FOUR, "bodies alone"),
    ("four increments, contact", {**CONTACT, **FOUR}, "contact, mortar rule"),
    ("four increments, large displacement", {**CONTACT, **LARGE, **FOUR},
     "four increments, contact"),
    ("four increments, plasticity", {**CONTACT, **FOUR, **scenes.PLASTIC},
     "four increments, contact"),
    ("stress probed", {"Probes/Probes": "head: stress yy, Head"},
     "bodies alone"),
    ("profile", {**CONTACT, "Output/Profile": "true"}, "contact, mortar rule"),
    ("VTU", {"Output/VTU": "true"}, "bodies alone"),
    ("one more level, uniform", {**CONTACT, **LEVEL}, "contact, mortar rule"),
    ("one more level, adaptive, estimator",
     {**CONTACT, **LEVEL, "Refinement/Strategy": "adaptive"},
     "contact, mortar rule"),
    ("errors of the probes", {"Probes/Errors": "next mesh"},
     "bodies alone"),
)


def describe(run, without):
    """Counters that differ from those without the effect."""
    base = without.counters if without else {}
    return ", ".join(
        "%s %d" % (name.replace("_", " "), n)
        for name, n in run.counters.items()
        if n != base.get(name, 0))


def ratio(a, b):
    return "-" if b is None else "%.2f" % (a / b)


def print_row(effect, without, runs):
    run, base = runs[effect], runs.get(without)
    unknowns = run.summary["unknowns"]
    print("| %s | %s | %d | %d | %.2f | %s | %.2f | %s | %.0f | %s | %s |" % (
        effect, without or "-", unknowns["displacement"],
        unknowns["multipliers"], run.cpu, ratio(run.cpu, base and base.cpu),
        run.wall, ratio(run.wall, base and base.wall), run.memory,
        ratio(run.memory, base and base.memory), describe(run, base)))


def wanted(names):
    """The effects of these names, and those they are compared with."""
    known = {effect: without for effect, _, without in EFFECTS}
    found = set()
    for name in names or known:
        if name not in known:
            raise SystemExit("unknown effect '%s', there are: %s" %
                             (name, "; ".join(known)))
        found.add(name)
        if known[name]:
            found.add(known[name])
    return [effect for effect in EFFECTS if effect[0] in found]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--cells", type=int, default=80,
                        help="along an edge of a block")
    parser.add_argument("contact", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("effect", nargs="*")
    options = parser.parse_args()
    effects = wanted(options.effect)

    runs = {}
    with tempfile.TemporaryDirectory() as directory:
        mesh = pathlib.Path(directory) / "blocks.msh"
        scenes.write_blocks(mesh, options.cells)
        for _ in range(options.repetitions):
            for effect, entries, _ in effects:
                run = scenes.run(options.contact, mesh,
                                 {**scenes.BLOCKS, **entries}, directory)
                if run.status != 0:
                    raise SystemExit("%s: status %d\n%s" %
                                     (effect, run.status,
                                      scenes.log(directory)))
                runs[effect] = runs[effect].cheaper(run) if effect in runs \
                    else run

    print("| effect | compared with | displacements | multipliers | CPU [s] | "
          "ratio | wall [s] | ratio | memory [MB] | ratio | counters that "
          "differ |")
    print("|" + "---|" * 11)
    for effect, _, without in effects:
        print_row(effect, without, runs)


if __name__ == "__main__":
    main()
