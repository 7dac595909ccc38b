#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Accuracy on request.

Proves that

- a run that is asked for an accuracy ends with errors that are no larger, by
  closed forms (cylinders, Lame) and by the limit of fine meshes (SSNP154), of
  displacements and of stresses in a zone of contact, on meshes of quadrangles,
  which it refines where the error comes from, and of triangles;
- so it does at a corner in contact, where values converge slowly and estimates see
  the next step alone, and its error is marked there, as elsewhere it is not;
- so it does where friction ends at a corner of the master, and on polygons of a
  circle; where no mesh resolves the zone of contact it says so;
- no printed error is smaller than the one a request believes;
- so it does without dual problems, in 3-D and with plastic bodies, by the values on
  three meshes;
- without a request the difference from a coarser mesh is marked where that is not
  coarser everywhere;
- a per cent of what is zero by symmetry ends soon, with the remedy;
- it ends with status 1, and says how far it got, at a limit;
- its results are those of its last mesh;
- what cannot be asked for is refused.

Usage: accuracy.py CONTACT PARAMETERS MESHES
"""

import pathlib
import re
import sys

from block_scenes import Mesh, box, check, failures, run as run_scene, solve

parameters, meshes = (pathlib.Path(path).resolve() for path in sys.argv[2:4])


def run(case, *settings):
    return solve(parameters / f"{case}.prm", "Refinement/Levels=0", *settings)


# The references of the files, but for DY(B), are closed forms.
cylinders = "verification/nested_cylinders_plane_quadratic"
for case, probe, percent in (
        (cylinders, "u(20)", 0.1), (cylinders, "u(20)", 0.01),
        (cylinders, "u(50)", 0.1), (cylinders, "u(50)", 0.01),
        (cylinders, "p(50)", 0.5), (cylinders, "p(50)", 0.05),
        ("verification/nested_spheres_quadratic", "u(20)", 0.01),
        ("nested", "DY(B)", 0.1), ("nested", "DY(B)", 0.01)):
    status, said, summary = run(
        case, f"Probes/Accuracy={probe}: {percent} %", "Probes/Tolerances=" + (
            "DY(B): 1" if case == "nested"
            else "u(20): 1, u(50): 1, u(100): 1, p(50): 1"))
    check(f"{case}, {probe} to {percent} %: runs", status == 0, said)
    if status != 0:
        continue
    result = {p["name"]: p for p in summary["probes"]}[probe]
    check("  is as accurate", 100 * abs(result["relative_deviation"]) < percent,
          f"{100 * result['relative_deviation']:g} %")
    check("  says so", 100 * result["estimated_error"] <
          percent * abs(result["value"]))
    levels = summary["levels"]
    check("  on few unknowns", levels[-1]["displacements"] < 6000,
          str([level["displacements"] for level in levels]))

# A block on another one, without friction: the limit of the corner is this
# program's own, of meshes refined by the energy estimate, on which three
# discretizations agree to 3e-4 of it.
mesh = Mesh()
mesh.block("A", 6, 3, box(-3, -3, 3, 0), {"bottom": "Base", "top": "Ground"})
mesh.block("B", 2, 2, box(-1, 0, 1, 1),
           {"bottom": "Sole", "top": "Head", "corner": "C"})
mesh.write("punch")
CORNER = -0.0072505
SCENE = {
    "Mesh/File": "punch.msh", "Element/Degree": 2,
    "Solids/Young's modulus": "A: 70000, B: 210000",
    "Solids/Poisson's ratio": "A: 0.3, B: 0.3",
    "Solids/Kinematics": "small strain",
    "Boundary conditions/Displacement x": "Base: 0, Head: 0",
    "Boundary conditions/Displacement y": "Base: 0, Head: -0.01",
    "Contact/Slave": "Sole", "Contact/Master": "Ground",
    "Solution/Geometry": "undeformed"}
for probe, place, limit in (("corner", "C", CORNER), ("middle", "M", None)):
    name = f"punch_{probe}"
    status, said, summary = run_scene(name, {
        **SCENE, "Mesh/Points": "M: 0, 0.5",
        "Probes/Probes": f"u: displacement y, {place}",
        "Probes/Accuracy": "u: 0.1 %"})
    check(f"punch, {probe}: runs", status == 0, said)
    if status != 0:
        continue
    result = summary["probes"][0]
    middle = result["value"]  # of the last one
    if limit is not None:
        check("  is as accurate", abs(result["value"] / limit - 1) < 1e-3,
              f"{100 * (result['value'] / limit - 1):g} %")
        check("  its error is marked", not result["error_is_confirmed"])
    check("  corners are named", ("corner in contact" in said) ==
          (limit is not None), said)

# Without dual problems: by the values on three meshes. In 3-D the reference is Lame's
# closed form; the punch is in elastic-plastic bodies that do not yield, and has the
# middle of the elastic one above, which dual problems have told.
status, said, summary = run("verification/3d/thick_spheres",
                            "Probes/Accuracy=p(50): 1 %", "Probes/Tolerances="
                            "u(20): 1, u(50): 1, u(100): 1, p(50): 1, U_inner: 1, "
                            "U_outer: 1")
check("spheres in 3-D: runs", status == 0, said)
if status == 0:
    result = {p["name"]: p for p in summary["probes"]}["p(50)"]
    error = abs(result["value"] - result["reference"])
    check("  is as accurate", error < 0.01 * abs(result["reference"]), str(result))
    check("  says so", error <= result["estimated_error"] <
          0.01 * abs(result["value"]), str(result))
    check("  on three meshes, refined everywhere", all(
        8 * a["cells"] == b["cells"] for a, b in
        zip(summary["levels"], summary["levels"][1:])) and
        len(summary["levels"]) >= 3)
status, said, summary = run_scene("punch_plastic", {
    **SCENE, "Solids/Material": "A: elastic-plastic, B: elastic-plastic",
    "Solids/Yield stress": "A: 1e5, B: 1e5", "Mesh/Points": "M: 0, 0.5",
    "Probes/Probes": "u: displacement y, M; a: plastic strain, M",
    "Probes/Accuracy": "u: 1 %"})
check("punch, plastic: runs", status == 0, said)
if status == 0:
    u, a = summary["probes"]
    check("  is as accurate", abs(u["value"] / middle - 1) < 1e-2,
          f"{100 * (u['value'] / middle - 1):g} %")
    check("  zero strains have no error", a["value"] == 0 and
          a["estimated_error"] is None, str(a))

status, said, summary = run_scene("zero", {
    **SCENE, "Mesh/Points": "M: 0, 0.5", "Probes/Probes": "u: displacement x, M",
    "Probes/Accuracy": "u: 1 %"})
check("zero by symmetry: status 1 soon, with the remedy", status == 1 and
      "u is zero within its error: ask for it in its unit" in said and
      len(summary["levels"]) <= 6, said)

# Triangles that lock: meshes agree on values that are far off.
soft = Mesh()
soft.nodes = [(0., 0.), (1., 0.), (1., 1.), (0., 1.)]
for corners in ((1, 2, 3), (1, 3, 4)):
    soft.elements.append((2, soft.groups.setdefault((2, "A"), 1), corners))
soft.add(1, "Left", (4, 1))
soft.add(1, "Right", (2, 3))
soft.add(0, "P", (3,))
soft.write("soft")
locks = {"Mesh/File": "soft.msh", "Element/Degree": 1,
         "Solids/Young's modulus": "A: 1000",
         "Solids/Poisson's ratio": "A: 0.4999", "Solids/Kinematics": "small strain",
         "Boundary conditions/Displacement x": "Left: 0",
         "Boundary conditions/Displacement y": "Left: 0",
         "Boundary conditions/Traction y": "Right: -0.5",
         "Probes/Probes": "u: displacement y, P"}
status, said, summary = run_scene("locks", locks)
check("triangles that lock: a note, and no estimated error", status == 0 and
      summary["probes"][0]["estimated_error"] is None and any(
          "lock: results are too stiff" in f["text"] for f in summary["findings"]),
      said)
status, said, _ = run_scene("locks", {**locks, "Probes/Accuracy": "u: 5 %"})
check("  an accuracy of theirs is refused", status == 2 and
      "hardly changes its volume, lock" in said, said)
status, said, summary = run_scene("locks", {
    **locks, "Solids/Poisson's ratio": "A: 0.45"})
check("  not of a softer one", status == 0 and
      summary["probes"][0]["estimated_error"] is not None, said)

# The pole of a roller on its line of symmetry is no corner, though the chords of its
# arc are not perpendicular to that.
def ask_shared(scene, request, *settings):
    """Of a scene that a user has sent: status, what is said, unknowns and probe."""
    path = pathlib.Path(__file__).resolve().parents[2] / "shared/accuracy" / scene
    if not path.exists():
        print(f"left out: {path} is not there")
        return None
    status, said, summary = solve(path, f"Probes/Accuracy={request}", *settings)
    name = request.split(":")[0]
    return (status, said, summary["levels"][-1]["displacements"],
            {p["name"]: p for p in summary["probes"]}[name])


if found := ask_shared("corner_note/roller.prm", "p: 1 %"):
    status, said, _, result = found
    check("the pole of a roller is confirmed", status == 0 and
          result["error_is_confirmed"] and "corner in contact" not in said, said)

# Rings of degree 1, whose polygons are refined alike: the closed form is 76.68.
if found := ask_shared("rings_linear/rings.prm", "p: 1 %"):
    status, said, unknowns, result = found
    check("polygons of a circle: is as accurate", status == 0 and
          abs(result["value"] / 76.68 - 1) < 0.01 and unknowns < 6000, said)

# Friction at the end of the master: points of the refined mesh that close there slide.
# The limit is that of the finest meshes.
if found := ask_shared("dovetail_overestimate/dovetail.prm", "p: 1 %"):
    status, said, unknowns, result = found
    check("friction at a corner of the master: is as accurate", status == 0 and
          abs(result["value"] / 75.49 - 1) < 0.01 and unknowns < 6000, said)

# A zone of contact that is far narrower than a facet: the pressure is 21.1 where the
# mesh resolves it, and grows in equal steps before.
if found := ask_shared("beam_pressure_log/beam.prm", "p: 2 %",
                       "Refinement/Limits=unknowns: 4000"):
    status, said, _, result = found
    check("a pressure that no mesh resolves: status 1, and why", status == 1 and
          ("less than four facets wide" in said or "equal steps" in said) and
          not result["error_is_confirmed"], said)

# The error that is printed beside a probe without a request is believed as well.
status, said, summary = run("nested", "Probes/Accuracy=SIYY(B): 2 MPa",
                            "Probes/References=", "Probes/Tolerances=")
result = {p["name"]: p for p in summary["probes"]}["DY(B)"]
check("an error without a request is no smaller than the true one", status == 0 and
      abs(result["value"] + 1.27434) <= result["estimated_error"] + 6e-5,
      f"{result['value']} {result['estimated_error']}")
check("no mark in a table of status 0", ">" not in said.split("error est.")[1], said)

free = ("Probes/References=", "Probes/Tolerances=")
status, said, summary = run("nested", "Probes/Accuracy=DY(B): 1 %", *free,
                              f"Mesh/File={meshes}/ssnp154.msh")
sizes = [level["cells"] for level in summary["levels"]]
check("triangles: refined uniformly", status == 0 and
      all(b == 4 * a for a, b in zip(sizes, sizes[1:])), f"{said} {sizes}")

for strategy, levels in (("uniform", 2), ("adaptive", 8)):
    status, said, summary = solve(parameters / "nested.prm",
                                  f"Refinement/Levels={levels}",
                                  f"Refinement/Strategy={strategy}", *free)
    check(f"levels, {strategy}: errors are marked or not", status == 0 and all(
        probe["estimated_error"] and
        probe["error_is_confirmed"] == (strategy == "uniform")
        for probe in summary["probes"]), said)

status, said, summary = run("nested", "Probes/Accuracy=DY(B): 1e-5 mm", *free,
                              "Refinement/Limits=unknowns: 3000")
check("limit: status 1", status == 1, said)
check("  says how far it got", re.search(
    r"DY\(B\) to .+ instead of 1e-05: the next mesh would take some \S+ "
    "unknowns, and the limit is 3e.03", said) is not None, said)
check("  keeps it", summary["levels"][-1]["displacements"] <= 3000 and
      summary["converged"] and summary["probes"][0]["value"] ==
      summary["levels"][-1]["probes"]["DY(B)"])

for setting, word in (("DY(B): 1 MPa", "is not a positive number of % or mm"),
                      ("DY(B): 1", "is not a positive number"),
                      ("DY(B): -1 %", "is not a positive number"),
                      ("DY(C): 1 %", "but not in Probes/Probes")):
    status, said, _ = run("nested", f"Probes/Accuracy={setting}", *free)
    check(f"'{setting}' is refused", status == 2 and word in said, said)
status, said, _ = run("nested", "Probes/Accuracy=DY(B): 1 %", *free,
                        "Refinement/Limits=hours: 3")
check("a limit of hours is refused", status == 2, said)
sys.exit(len(failures) > 0)
