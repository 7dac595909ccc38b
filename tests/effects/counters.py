#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scene does only what it asks for: counters of small scenes, exactly.

    counters.py CONTACT PARAMETERS MESHES

Each claim can fail: a counter that is zero where an effect is off has to count
where it is on, which the scenes with the effect show.
"""

import pathlib
import sys
import tempfile

import scenes

FAILURES = []


def check(claim, found, wanted):
    good = found == wanted
    print("  %-62s %s" % (claim, "yes" if good else
                          "NO: %s, not %s" % (found, wanted)))
    if not good:
        FAILURES.append(claim)


def check_not(claim, found, limit):
    check("%s (%s)" % (claim, found), found > limit, True)


class Scenes:
    def __init__(self, contact, directory):
        self.contact, self.directory = contact, pathlib.Path(directory)
        self.mesh = self.directory / "blocks.msh"
        scenes.write_blocks(self.mesh, 6)
        self.block = self.directory / "block.msh"
        scenes.write_block(self.block, 8)

    def run(self, headline, *entries, mesh=None):
        merged = {}
        for part in entries:
            merged.update(part)
        print(headline)
        result = scenes.run(self.contact, mesh or self.mesh, merged,
                            self.directory)
        if result.status not in (0, 1) or not result.summary["converged"]:
            print(scenes.log(self.directory))
            raise SystemExit("the scene does not converge")
        return result

    def cells(self, result):
        return result.summary["levels"][-1]["cells"]


# Effects that none of the scenes below has, unless it says so.
NEWER = ("material_cells", "enhanced_cells", "return_mappings",
         "history_updates", "thermal_cells", "rigid_updates", "obstacle_moves",
         "free_motions", "interferences", "slip_stiffnesses")
OFF = NEWER + ("large_displacement_cells", "tangential_rows",
               "geometry_updates", "stress_recoveries", "error_estimates")
NO_CONTACT = ("pairings", "candidate_pairs", "projections",
              "active_set_changes")


def all_zero(result, names):
    check("nothing of what is off",
          {name: result.counters[name] for name in names
           if result.counters[name] != 0}, {})


def once(result, cells, solves):
    check("one tangent", result.counters["tangents"], 1)
    check("of each cell once", result.counters["cell_tangents"], cells)
    check("one analysis", result.counters["symbolic_factorizations"], 1)
    check("one factorization", result.counters["numeric_factorizations"], 1)
    check("%d linear solve(s)" % solves, result.counters["linear_solves"],
          solves)


def linear(s):
    for increments in (1, 3):
        more = {"Solution/Increments": str(increments)}
        for system in ("condensed", "saddle point"):
            what = {"Solution/System": system, **more}
            r = s.run("no contact, moved supports, %s, increments: %d"
                      % (system, increments), scenes.BLOCKS, what)
            once(r, s.cells(r), increments)
            all_zero(r, OFF + NO_CONTACT)
            check("files: summary twice, history, parameters; restart, history "
                  "and summary between", r.counters["files"],
                  4 + 3 * (increments - 1))
        tied = {"Contact/Tied": "true", **more}
        for rule in ("nodal", "mortar"):
            r = s.run("tied, rule %s, increments: %d" % (rule, increments),
                      scenes.BLOCKS, scenes.CONTACT, tied,
                      {"Contact/Discretization": rule})
            once(r, s.cells(r), increments)
            all_zero(r, NEWER + ("large_displacement_cells",
                                 "geometry_updates", "stress_recoveries",
                                 "error_estimates", "active_set_changes"))
            check("paired once", r.counters["pairings"], 1)
    r = s.run("no contact, a load, three increments", scenes.HELD_BLOCK,
              {"Solution/Increments": "3"}, mesh=s.block)
    once(r, s.cells(r), 3)
    all_zero(r, OFF + NO_CONTACT)


def frozen_pairing(s):
    """Small strain, paired once: the matrix follows the decisions alone."""
    for rule, system in (("mortar", "condensed"), ("nodal", "condensed"),
                         ("nodal", "saddle point"), ("Gauss", "saddle point")):
        for friction in ({}, {"Contact/Tresca limit": "20"},
                         {"Contact/Friction coefficient": "0.2"}):
            r = s.run("contact paired once, rule %s, %s, %s" %
                      (rule, system, friction or "no friction"),
                      scenes.BLOCKS, scenes.CONTACT, friction,
                      {"Contact/Discretization": rule, "Solution/System": system,
                       "Solution/Increments": "3"})
            c = r.counters
            check("one tangent", c["tangents"], 1)
            check("of each cell once", c["cell_tangents"], s.cells(r))
            check("one analysis", c["symbolic_factorizations"], 1)
            check_not("at most one factorization for each change of the active "
                      "set, and the first", 2 + c["active_set_changes"],
                      c["numeric_factorizations"])
            check("paired once", c["pairings"], 1)
            check("no geometry update", c["geometry_updates"], 0)
            all_zero(r, NEWER + ("large_displacement_cells",
                                 "stress_recoveries", "error_estimates"))
            if friction:
                check_not("tangential rows", c["tangential_rows"], 0)
            else:
                check("no tangential row", c["tangential_rows"], 0)


def switched_on(s):
    """The counters that were zero count."""
    r = s.run("geometry by the fixed point, small strain", scenes.BLOCKS,
              scenes.CONTACT, {"Solution/Geometry": "fixed point"})
    check("an update a turn", r.counters["geometry_updates"],
          sum(i["geometry_iterations"] for i in r.summary["increments"]))
    check_not("geometry updates", r.counters["geometry_updates"], 0)
    check("one tangent", r.counters["tangents"], 1)

    r = s.run("large displacement", scenes.BLOCKS,
              {"Solids/Kinematics": "large displacement",
               "Solution/Geometry": "fixed point"})
    check("all cells", r.counters["large_displacement_cells"],
          r.counters["cell_forces"])
    check("a tangent for each Newton step, and behind a long one that of the end",
          r.counters["tangents"],
          1 + sum(i["newton_iterations"] for i in r.summary["increments"]))

    r = s.run("a stress probed, VTU, profile", scenes.BLOCKS, scenes.CONTACT,
              {"Probes/Probes": "s: stress yy, Head", "Output/VTU": "true",
               "Output/Profile": "true"})
    check("stresses recovered once", r.counters["stress_recoveries"], 1)
    check("files: four, VTU of two bodies and of contact, two series, profile",
          r.counters["files"], 4 + 3 + 2 + 1)

    r = s.run("one adaptive level", scenes.BLOCKS, scenes.CONTACT,
              {"Refinement/Levels": "1", "Refinement/Strategy": "adaptive"})
    check("one estimate", r.counters["error_estimates"], 1)
    check("one recovery", r.counters["stress_recoveries"], 1)
    check("a tangent a mesh", r.counters["tangents"], 2)


def only(result, *names):
    """Of the newer effects the scene has these."""
    all_zero(result, [name for name in NEWER if name not in names])


def materials(s):
    points, increments = 4, {"Solution/Increments": "2"}
    r = s.run("bodies that may yield", scenes.BLOCKS, scenes.CONTACT,
              scenes.PLASTIC, increments)
    c = r.counters
    check("a return in each point whenever forces are computed",
          c["return_mappings"], points * c["cell_forces"])
    check("one history of each point an increment", c["history_updates"],
          2 * points * s.cells(r))
    check("all cells have a material", c["material_cells"], c["cell_forces"])
    steps = sum(i["newton_iterations"] for i in r.summary["increments"])
    check_not("at most a tangent for each Newton step", steps + 1,
              c["tangents"])
    check_not("and more than that of elastic bodies", c["tangents"], 1)
    only(r, "return_mappings", "history_updates", "material_cells")

    r = s.run("the same, condensed", scenes.BLOCKS, scenes.CONTACT,
              scenes.PLASTIC, increments, {"Solution/System": "condensed"})
    c = r.counters
    check("a tangent for each Newton step", c["tangents"],
          sum(i["newton_iterations"] for i in r.summary["increments"]))
    check_not("of cells that yield or see the contact alone, after the first",
              s.cells(r) * c["tangents"] / 2, c["cell_tangents"])

    one = {entry: value.split(", ")[1] for entry, value in
           scenes.PLASTIC.items()}
    r = s.run("one of the bodies may yield", scenes.BLOCKS, scenes.CONTACT, one,
              increments)
    c = r.counters
    upper = 7 * 7
    check("histories of its points alone", c["history_updates"],
          2 * points * upper)
    check("returns in these", c["return_mappings"],
          points * c["material_cells"])
    check_not("the other body's cells are none", c["cell_forces"],
              c["material_cells"])

    for material in (scenes.NEO_HOOKEAN, scenes.MOONEY_RIVLIN):
        r = s.run(material["Solids/Material"], scenes.BLOCKS, scenes.CONTACT,
                  material, {"Solids/Kinematics": "large displacement",
                             "Solution/Geometry": "each step"})
        check("all cells have a material", r.counters["material_cells"],
              r.counters["cell_forces"])
        only(r, "material_cells")

    r = s.run("incompatible modes", scenes.BLOCKS, scenes.CONTACT, scenes.MODES,
              increments)
    check("in all cells", r.counters["enhanced_cells"],
          r.counters["cell_forces"])
    once(r, s.cells(r), 2)
    only(r, "enhanced_cells")

    r = s.run("a body that swells", scenes.BLOCKS, scenes.CONTACT, scenes.HOT,
              increments)
    check("its cells once an increment", r.counters["thermal_cells"], 2 * upper)
    once(r, s.cells(r), 2)
    only(r, "thermal_cells")


def motions(s):
    increments = {"Solution/Increments": "2"}
    r = s.run("a rigid boundary", scenes.BLOCKS, scenes.CONTACT, scenes.RIGID,
              increments)
    once(r, s.cells(r), 2)
    check_not("its motion", r.counters["rigid_updates"], 0)
    only(r, "rigid_updates")

    r = s.run("an obstacle at rest", scenes.BLOCKS, scenes.OBSTACLE, increments)
    only(r)
    r = s.run("an obstacle that moves", scenes.BLOCKS, scenes.MOVING, increments)
    check("once an increment", r.counters["obstacle_moves"], 2)
    only(r, "obstacle_moves")
    for system in ("condensed", "saddle point"):
        r = s.run("an obstacle under a force, %s" % system, scenes.BLOCKS,
                  scenes.PUSHED, increments, {"Solution/System": system})
        check("once an increment", r.counters["obstacle_moves"], 2)
        check("one motion for each linear system", r.counters["free_motions"],
              r.counters["numeric_factorizations"] if system == "saddle point"
              else sum(i["newton_iterations"]
                       for i in r.summary["increments"]))
        only(r, "obstacle_moves", "free_motions")

    r = s.run("an interference", scenes.BLOCKS, scenes.CONTACT, scenes.OVERLAP,
              increments)
    check("once an increment", r.counters["interferences"], 2)
    only(r, "interferences")


def modeling_a(s, parameters):
    print("modeling A, which has no friction")
    result = scenes.measure([str(s.contact), str(parameters / "ssnp154_a.prm"),
                             "--set", "Output/Screen=none"], s.directory)
    summary = scenes.json.loads((s.directory / "output" / "ssnp154_a" /
                                 "summary.json").read_text())
    check("exit status", result.status, 0)
    check("nothing of what is off",
          {name: summary["counters"][name] for name in NEWER +
           ("tangential_rows",) if summary["counters"][name] != 0}, {})
    check("a multiplier a node", summary["unknowns"]["multipliers"] > 0, True)


def main():
    contact, parameters = (pathlib.Path(p).resolve() for p in sys.argv[1:3])
    with tempfile.TemporaryDirectory() as directory:
        s = Scenes(contact, directory)
        linear(s)
        frozen_pairing(s)
        switched_on(s)
        materials(s)
        motions(s)
        modeling_a(s, parameters)
    print("%d claims fail" % len(FAILURES))
    sys.exit(1 if FAILURES else 0)


if __name__ == "__main__":
    main()
