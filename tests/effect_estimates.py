#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Effects by estimate.

Proves that

- the estimated change of each probe by each effect is, to a fifth or as closely
  as it says, what a run with the entries of the variant finds, and no verdict
  at 1 % or 0.1 % of the probe is wrong;
- the estimates do not change the values, and there are none where they are off;
- what the loops leave is what a run with sharper tolerances finds;
- so is plasticity of a body that has a yield stress as a mere check, to a
  hundredth where a tenth of it yields and to a fifth where all of it does; and
  what scenes would be without their plasticity, thermal strains, interferences,
  moving obstacles, moments on rigid boundaries, rubber and incompatible modes;
- so is glue, added and taken off;
- with friction in several increments, which remembers the way, no estimate is
  further off than it says, and in one increment they are certain;
- plastic strains and rotations are probes, too;
- where nothing is above the yield stress there is no change;
- nothing is told, and why, where plastic strains remember the way, where a body
  that would have yielded was unloaded, and where the variant cannot be;
- several processes are refused, and motions of obstacles that follow from forces.

Usage: effect_estimates.py CONTACT PARAMETERS MESHES
"""

import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent / "effects"))
from block_scenes import check, contact, failures  # noqa: E402
from estimates import compare, solve  # noqa: E402
import scenes  # noqa: E402

ESTIMATE = "Solution/Estimate effects=true"

for scene in ("ssnp154_a", "verification/nested_cylinders",
              "verification/nested_cylinders_plane_quadratic",
              "verification/punch"):
    base, why = solve(contact, scene, ESTIMATE)
    check(f"{scene}: runs", base is not None, why)
    without, _ = solve(contact, scene)
    check("  same values", [p["value"] for p in base["probes"]] ==
          [p["value"] for p in without["probes"]])
    check("  nothing where it is off", "estimated_effects" not in without)
    n = 0
    for row in compare(contact, scene, base):
        effect = row.effect["effect"]
        for accuracy in (0.01, 0.001):
            check(f"  {effect}: the verdict on {row.probe} is not wrong",
                  row.verdict_is_right(accuracy) is not False)
        if (row.true is None or row.estimated is None or
                abs(row.true) <= 1e-3 * abs(row.value)):
            continue
        n += 1
        uncertain = abs(row.effect["uncertainties"][row.probe])
        check("  its change", 0.8 < row.estimated / row.true < 1.25 or
              abs(row.estimated - row.true) <= uncertain <
              abs(row.estimated) / 2,
              f"{row.estimated:g} +- {uncertain:g}, {row.true:g}")
    check("  there are some", n >= 6, str(n))

# A friction loop that ends early, and a geometry loop, against Newton's method;
# in one increment, for what is left in one has consequences in the next.
early = ("Solution/Friction=fixed point", "Solution/Friction tolerance=1e-2",
         "Solution/Geometry=fixed point", "Solution/Geometry tolerance=1e-2",
         "Contact/Discretization=mortar", "Solution/Increments=1")
exact = ("Solution/Friction=Newton", "Solution/Geometry=Newton",
         "Contact/Discretization=mortar", "Solution/Increments=1")
loops, why = solve(contact, "ssnp154_c", *early, ESTIMATE,
                   "Probes/Errors=dual weighted residuals")
newton, _ = solve(contact, "ssnp154_c", *exact)
for probe, sharp in zip(loops["probes"], newton["probes"]):
    left = sharp["value"] - probe["value"]
    by_loop = loops["levels"][-1]["loop_errors"][probe["name"]]
    check(f"loops leave of {probe['name']}",
          0.5 < sum(by_loop.values()) / left < 2 and
          0.5 < probe["loop_error"] / abs(left) < 2,
          f"{left:g} {probe['loop_error']:g} {by_loop}")



def write_scene(name, *parts):
    """A parameter file; the last of several values of an entry counts."""
    entries = {"Mesh/File": "blocks.msh", "Output/Screen": "none"}
    for part in parts:
        entries.update(part)
    sections = {}
    for entry, value in entries.items():
        section, key = entry.split("/")
        sections.setdefault(section, []).append(f"  set {key} = {value}\n")
    path = pathlib.Path(f"{name}.prm").resolve()
    path.write_text("".join(f"subsection {section}\n{''.join(lines)}end\n"
                            for section, lines in sections.items()))
    return str(path)


def estimated(name, *parts):
    base, why = solve(contact, write_scene(name, *parts), ESTIMATE)
    check(f"{name}: runs", base is not None, why)
    return base


def agree(name, base, bounds):
    """The estimates of the effects among BOUNDS, by effect, are as far from 1
    of the true change as it says."""
    found = [e for e in base["estimated_effects"] if e["effect"] in bounds]
    check(f"{name}: all effects", {e["effect"] for e in found} == set(bounds),
          [e["effect"] for e in base["estimated_effects"]])
    n = {}
    for row in compare(contact, str(pathlib.Path(f"{name}.prm").resolve()),
                       {**base, "estimated_effects": found}):
        effect = row.effect["effect"]
        if row.true is None or row.estimated is None:
            check(f"  {effect}: is known", False,
                  row.why or row.effect["unknown"])
            continue
        if abs(row.true) <= 1e-4 * abs(row.value):
            continue
        n[effect] = n.get(effect, 0) + 1
        check(f"  {effect} on {row.probe}",
              abs(row.estimated / row.true - 1) < bounds[effect],
              f"{row.estimated:g} {row.true:g}")
    check("  all of them change something", set(n) == set(bounds), n)


def unknown(base, effect, reason):
    found = [e["unknown"] for e in base["estimated_effects"]
             if e["effect"] == effect]
    check(f"  {effect} is not told", found and reason in found[0], found)


scenes.write_blocks("blocks.msh", 8)
SCENE = {**scenes.BLOCKS, **scenes.CONTACT,
         "Probes/Probes": "corner: displacement x, Foot; middle: displacement "
         "y, Inside; stress: stress yy, Inside; force: reaction y, Base",
         "Mesh/Points": "Inside: 0.888888888888889, 0.888888888888889"}
CHECKED = {"Solids/Yield stress": "Upper: 60"}
YIELDS = {**CHECKED, "Solids/Material": "Upper: elastic-plastic"}
MORE = {"Boundary conditions/Displacement y": "Base: 0, Top: -0.003"}
WAY = {"Solution/Increments": "2"}

for name, stress, low, high, more in (
        ("checked", 125, 0.05, 0.2,
         {"thermal strain of Upper": 1e-3, "Contact/interference": 1e-3,
          "incompatible modes of Lower": 1e-3}),
        ("all_yields", 60, 0.99, 1, {})):
    base = estimated(name, SCENE, MORE, WAY, scenes.HOT, scenes.OVERLAP, {
        "Solids/Incompatible modes": "Lower",
        "Solids/Yield stress": f"Upper: {stress}"})
    share = base["bodies"]["Upper"]["volume_share_above_yield"]
    check("  yields in part, or all", low <= share <= high, share)
    agree(name, base, {"plasticity of Upper": 0.01 if more else 0.2, **more})

base = estimated("stays_elastic", SCENE, {"Solids/Yield stress": "Upper: 300"})
plasticity = [e for e in base["estimated_effects"]
              if e["effect"] == "plasticity of Upper"]
check("  nothing yields, nothing changes", len(plasticity) == 1 and
      set(plasticity[0]["changes"].values()) == {0}, plasticity)

base = estimated("yields", SCENE, YIELDS, MORE)
agree("yields", base, {"plasticity of Upper": 1e-6,
                       "Young's modulus of Upper + 1 %": 0.1,
                       "quadratic elements": 0.01})
base = estimated("yields_on_the_way", SCENE, YIELDS, MORE, WAY,
                 {"Probes/Probes": "strain: plastic strain, Foot; corner: "
                  "displacement x, Foot"})
plasticity = [e["changes"] for e in base["estimated_effects"]
              if e["effect"] == "plasticity of Upper"][0]
strain = [p["value"] for p in base["probes"] if p["name"] == "strain"][0]
check("  without plasticity no plastic strain",
      abs(plasticity["strain"] + strain) < 1e-12 < strain,
      f"{plasticity} {strain}")
unknown(base, "Young's modulus of Upper + 1 %", "remember the way")
unknown(base, "increments doubled", "remember the way")
unknown(base, "quadratic elements", "remember the way")

base = estimated("zero_load", SCENE, MORE, {
    "Contact/Friction coefficient": "0.1", "Boundary conditions/Force x": "Foot: 0"})
zero = [e for e in base["estimated_effects"] if e["effect"].startswith("Force")]
check("  a load that is zero changes nothing", len(zero) == 1 and
      not zero[0]["unknown"] and max(map(abs, zero[0]["changes"].values())) < 1e-8,
      zero)
agree("zero_load", base, {"Contact/glue": 1e-3})
check("  in one increment friction remembers no way",
      all(abs(e["uncertainties"][n]) <= 1e-6 * abs(change)
          for e in base["estimated_effects"]
          if e["effect"].startswith("Young's modulus")
          for n, change in e["changes"].items()))

base = estimated("unloaded", SCENE, CHECKED, MORE, WAY, {
    "Boundary conditions/Histories": "Displacement y: min(2*t, 1.5 - t)"})
unknown(base, "plasticity of Upper", "gone at the end")

base = estimated("large", SCENE, CHECKED, {
    "Solids/Kinematics": "large displacement", "Solution/Geometry": "automatic"})
agree("large", base, {"plasticity of Upper": 0.01})

base = estimated("rubber", SCENE, MORE, scenes.RIGID, {
    "Solids/Kinematics": "large displacement", "Solution/Geometry": "automatic",
    "Solids/Material": "Upper: neo-Hookean",
    "Boundary conditions/Rotation z": "",
    "Boundary conditions/Moment z": "Top: 20",
    "Contact/Friction coefficient": "0.3",
    "Probes/Probes": "turn: rotation z, Top; middle: displacement y, Inside"})
agree("rubber", base, {"neo-Hookean material of Upper": 0.05,
                       "Moment z of Top": 0.05, "quadratic elements": 0.05})

base = estimated("moving", SCENE, scenes.MOVING, {
    "Contact/Master": "", "Contact/Friction coefficient": "0.1",
    "Boundary conditions/Displacement y": "Base: 0, Top: -0.001"})
agree("moving", base, {"Contact/obstacle motion": 0.1})

base = estimated("glued", SCENE, {
    "Contact/Tied": "true",
    "Boundary conditions/Displacement x": "Base: 0, Top: 0.001"})
agree("glued", base, {"Contact/glue": 1e-3})

# Friction that remembers the way, which the end does not know.
for coefficient, effect in (("0.3", "Contact/obstacle motion"),
                            ("0", "Contact/friction 0.1")):
    name = f"way_{coefficient}"
    base = estimated(name, SCENE, scenes.MOVING, {
        "Contact/Master": "", "Contact/Friction coefficient": coefficient,
        "Solution/Increments": "3",
        "Probes/Probes": "corner: displacement x, Foot; stress: stress yy, Inside"})
    found = [e for e in base["estimated_effects"] if e["effect"] == effect]
    check("  the effect is there", len(found) == 1, len(found))
    for row in compare(contact, str(pathlib.Path(f"{name}.prm").resolve()),
                       {**base, "estimated_effects": found}):
        off = abs(row.estimated - row.true)
        uncertain = abs(row.effect["uncertainties"][row.probe])
        check(f"  {effect} on {row.probe} is as uncertain as it is wrong",
              off <= uncertain + 1e-3 * abs(row.value) and
              row.verdict_is_right(0.01) is True,
              f"{row.estimated:g} +- {uncertain:g}, {row.true:g}")

# A load that has turned back leaves shear that its end does not know.
base = estimated("turned_back", SCENE, scenes.MOVING, {
    "Contact/Master": "", "Contact/Friction coefficient": "0.3",
    "Contact/Obstacle motion": "x: 5e-4*sin(pi*t); y: -2e-4*t",
    "Solution/Increments": "3",
    "Probes/Probes": "corner: displacement x, Foot"})
found = {e["effect"]: e for e in base["estimated_effects"]}
for name in ("Contact/obstacle motion", "large displacement"):
    check(f"  {name}, of a way to and fro: cannot be told",
          "turned back" in (found.get(name, {}).get("unknown") or ""),
          found.get(name))

status = subprocess.run(
    [str(contact), write_scene("pushed", SCENE, scenes.PUSHED,
                               {"Contact/Master": ""}),
     "--set", ESTIMATE], capture_output=True, text=True, check=False)
check("an obstacle under a force: refused", status.returncode == 2 and
      "no dual problem for motions" in status.stderr, status.stderr)

refused = subprocess.run(
    ["mpirun", "-np", "2", str(contact), f"{sys.argv[2]}/nested.prm", "--quiet",
     "--set", ESTIMATE], capture_output=True, text=True, check=False)
check("two processes: refused", refused.returncode == 2 and
      "Effects are estimated" in refused.stderr, refused.stderr)
sys.exit(len(failures) > 0)
