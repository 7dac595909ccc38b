#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a solution must not depend on.

Proves of the cylinder on the block (SSNP154, coarse quadrangles, friction 0.15)

- that the results of the rules nodal and mortar do not depend on the parameter
  c of the augmented Lagrangian, over seven decades around its default; what
  the rule Gauss makes of it is shown;
- that the unit of length and that of force are the user's choice: the same
  Newton iterations, the same results;
- that a mesh turned by 30 degrees gives the same results, and shifted by
  1000 mm as well.

Differences are relative: of contact forces, pressures and displacements to
themselves, of turned displacements to the smaller one of the two prescribed.

A shift of L = 1000 mm leaves the coordinates with an error of eps L = 1e-13 mm.
That is 1e-13 of displacements of 1 mm, and by the stiffness of an element the
same in pressures: 1e-8 is far above it. It would not be for displacements below
1e-5 mm.

Usage: invariance.py CONTACT PARAMETERS MESHES
"""

import json
import math
import pathlib
import subprocess
import sys

TOLERANCE = 1e-8

# Prescribed displacements of all supports, so that they may turn. The cap is
# pressed down and dragged along, away from the end of the master; no axis of
# symmetry. A pressure, because the
# residual is measured by the loads, and without any by what comes first.
CASE = """include {parameters}/ssnp154.prm
subsection Mesh
  set File = {meshes}/ssnp154_quads.msh
  set Move = Cylinder: 10, 0
end
subsection Solids
  set Kinematics = large displacement
end
subsection Boundary conditions
  set Displacement x = Encast: 0, Cap: 0.3
  set Displacement y = Encast: 0, Cap: -0.8
  set Force y        =
  set Pressure       = Top_B: 10
end
subsection Contact
  set Discretization                 = mortar
  set Friction coefficient = 0.15
end
subsection Solution
  set Increments         = 2
  set Geometry           = each step
  set Geometry tolerance = 1e-9
  set Newton tolerance   = 1e-10
end
subsection Probes
  set Probes = CX: displacement x, C; CY: displacement y, C; BX: displacement x, B; BY: displacement y, B
end
"""

CAP = (0.3, -0.8)

FORCES = ("normal_force", "tangential_force")


class Runs:
    """Runs the case with overrides and reads what comes out."""

    def __init__(self, contact, parameters, meshes):
        self.contact = contact
        pathlib.Path("case.prm").write_text(
            CASE.format(parameters=parameters, meshes=meshes))
        self.failures = 0

    def __call__(self, **overrides):
        """Overrides as Section_Entry="value"; "_" is a blank."""
        command = [self.contact, "case.prm", "--quiet"]
        for key, value in overrides.items():
            section, entry = key.split("_", 1)
            command += ["--set", "{}/{}={}".format(
                section.replace("Boundary", "Boundary conditions"),
                entry.replace("_", " "), value)]
        result = subprocess.run(command, capture_output=True, text=True)
        if result.returncode != 0:
            self.failures += 1
            print("FAILED: exit status", result.returncode, "of",
                  " ".join(command))
            print(result.stdout + result.stderr)
            return None
        summary = json.loads(
            pathlib.Path("output/case/summary.json").read_text())
        return {
            "newton": [i["newton_iterations"] for i in summary["increments"]],
            "contact": summary["contact"],
            "probes": {p["name"]: p["value"] for p in summary["probes"]},
        }

    def check(self, what, difference, same_steps=True):
        good = difference <= TOLERANCE and same_steps
        print("{:6} {:52} {:.1e}{}".format(
            "ok" if good else "FAILED", what, difference,
            "" if same_steps else ", other Newton iterations"))
        self.failures += not good


def difference(run, base, length=1.0, force=1.0, stress=1.0):
    """Largest relative difference of all results, with the factors from those
    of the base to those of the run."""
    pairs = []
    for name, value in base["contact"].items():
        factor = length if "width" in name else (
            force if name in FORCES else stress)
        pairs.append((run["contact"][name], factor * value))
    for name, value in base["probes"].items():
        pairs.append((run["probes"][name], length * value))
    return max(abs(a - b) / abs(b) for a, b in pairs if b != 0)


# Every rule with a system it can have, and the loop of friction for that.
FORMS = [("nodal", "condensed", "Newton"),
         ("mortar", "condensed", "Newton"),
         ("nodal", "saddle point", "Newton"),
         ("mortar", "saddle point", "Newton"),
         ("Gauss", "saddle point", "Newton")]


def form_entries(form):
    return {"Contact_Discretization": form[0], "Solution_System": form[1],
            "Solution_Friction": form[2]}


def check_complementarity(runs):
    print("Parameter c by E/h, largest relative difference to 1e-3; Gauss: of "
          "probes, forces and the rest")
    for form in FORMS:
        base = runs(**form_entries(form), Contact_Augmentation_parameter=1e-3)
        # Below, the saddle point of the rule Gauss loses digits.
        for c in (1e-7,) * (form[0] != "Gauss") + (1e-6, 1e-5, 1e-4, 1e-2,
                                                   1e-1, 1):
            run = runs(**form_entries(form), Contact_Augmentation_parameter=c)
            if not run or not base:
                continue
            what = "{}, {} at {:.0e}".format(form[0], form[1], c)
            if form[0] != "Gauss":
                runs.check(what, difference(run, base))
                continue
            parts = [[abs(run[kind][name] / value - 1)
                      for name, value in base[kind].items()
                      if value != 0 and (kind == "probes" or
                                         (name in FORCES) == forces)]
                     for kind, forces in (("probes", True), ("contact", True),
                                          ("contact", False))]
            print("       {:44}".format(what),
                  *("{:.1e}".format(max(part)) for part in parts))


def check_units(runs, form):
    entries = form_entries(form)
    name = ", ".join(form[:2])
    base = runs(**entries)
    for power in (-6, 6):
        s = 10.0**power
        run = runs(**entries, Mesh_Scale=s,
                   Boundary_Displacement_x="Encast: 0, Cap: %r" % (CAP[0] * s),
                   Boundary_Displacement_y="Encast: 0, Cap: %r" % (CAP[1] * s))
        if run and base:
            runs.check("{}, lengths by 1e{:+d}".format(name, power),
                       difference(run, base, length=s, force=s),
                       run["newton"] == base["newton"])
        run = runs(**entries, Boundary_Pressure="Top_B: %r" % (10 * s), **{
            "Solids_Young's_modulus":
                "Block: %r, Cylinder: %r" % (70000 * s, 210000 * s)})
        if run and base:
            runs.check("{}, forces by 1e{:+d}".format(name, power),
                       difference(run, base, force=s, stress=s),
                       run["newton"] == base["newton"])


def check_place(runs, form):
    entries = form_entries(form)
    base = runs(**entries)
    c, s = math.cos(math.pi / 6), math.sin(math.pi / 6)
    x, y = c * CAP[0] - s * CAP[1], s * CAP[0] + c * CAP[1]
    for shift in ("0, 0", "1000, 1000"):
        run = runs(**entries, Mesh_Rotation=30, Mesh_Shift=shift,
                   Boundary_Displacement_x="Encast: 0, Cap: %r" % x,
                   Boundary_Displacement_y="Encast: 0, Cap: %r" % y)
        if not run or not base:
            continue
        worst = max(abs(run["contact"][name] / value - 1)
                    for name, value in base["contact"].items() if value != 0)
        for point in "BC":
            u, v = (base["probes"][point + d] for d in "XY")
            worst = max(worst,
                        abs(run["probes"][point + "X"] - c * u + s * v) / 0.3,
                        abs(run["probes"][point + "Y"] - s * u - c * v) / CAP[0])
        runs.check("{}, {}, turned, shifted by {} mm".format(
            *form[:2], shift), worst)


def main():
    runs = Runs(*sys.argv[1:4])
    check_complementarity(runs)
    print("Units, and the place of the mesh:")
    for form in FORMS:
        check_units(runs, form)
        check_place(runs, form)
    return 1 if runs.failures else 0


if __name__ == "__main__":
    sys.exit(main())
