#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of contact around edges that once had a wrong result with exit status 0,
cycled or crashed, from outside of this repository: skipped where they are not there.

Proves, for the scenes of the folders `plane` and `space`, that

- forces on a concave slave are those on the convex one, within the error of the
  mesh, and those of the block that touches the floor alone; turned scenes have the
  forces of those as drawn;
- scenes with teeth, glue beside friction, a ball between plates, and a block that
  reaches over a rim turned by 45 degrees, converge in at most 60 Newton steps an
  increment; the latter has the same force with the roles exchanged;
- no shear is reported without friction, and the pressure is continuous over a line
  where several contact pairs meet;
- the nodal discretization has the force of the mortar discretization where a corner
  lies over a corner, or reports that the bodies overlap;

and for those of the folder `reports` that tubes under a moment have the rotation of
another program, and pairs that share a node have the uniform pressure.

Usage: corner_faults.py CONTACT PARAMETERS MESHES [PART OF A NAME ...]
Folder: SCENES_DIRECTORY, or ../scenes beside REFERENCE_DIRECTORY, which is
../shared/reference beside the repository by default.
"""

import csv
import json
import math
import os
import pathlib
import re
import subprocess
import sys

contact = pathlib.Path(sys.argv[1]).resolve()
reference = os.environ.get("REFERENCE_DIRECTORY") or \
    pathlib.Path(__file__).resolve().parents[2] / "shared" / "reference"
folder = pathlib.Path(os.environ.get("SCENES_DIRECTORY") or
                      pathlib.Path(reference).parent / "scenes")
MOST_STEPS = 60  # of Newton's method, an increment
SECONDS = 100    # for a run that does not end

failures = 0


def check(what, ok, detail=""):
    global failures
    print(f"{'ok' if ok else 'FAILED'}: {what} {detail}", flush=True)
    failures += not ok


def nearly(what, value, expected, part):
    check(what, abs(value - expected) <= part * abs(expected),
          f"{value:.6g}, {expected:.6g}")


class Result:
    """A run of a scene."""

    def __init__(self, scene, **entries):
        file = folder / f"{scene}.prm"
        self.scene, self.name = scene, scene.replace("/", "_")
        text = re.sub(r"File = ", f"File = {file.resolve().parent}/",
                      file.read_text())
        pathlib.Path(self.name + ".prm").write_text(text)
        planned = int(re.search(r"Increments = (\d+)", text).group(1)) \
            if "Increments" in text else 2
        command = [contact, self.name + ".prm", "--quiet"]
        for entry, value in {"Output/Screen": "none", "Output/Nodes": "true",
                             "Output/Profile": "true", **entries}.items():
            command += ["--set", f"{entry}={value}"]
        summary = pathlib.Path(f"output/{self.name}/summary.json")
        summary.unlink(missing_ok=True)
        try:
            run = subprocess.run(command, capture_output=True, text=True,
                                 timeout=SECONDS, check=False)
            self.status, self.said = run.returncode, run.stdout + run.stderr
        except subprocess.TimeoutExpired:
            self.status, self.said = -1, f"no end in {SECONDS} s"
        self.summary = json.loads(summary.read_text()) \
            if summary.exists() else {"probes": [], "increments": []}
        self.probes = {p["name"]: p["value"] for p in self.summary["probes"]}
        self.increments = self.summary["increments"]
        self.steps = sum(i["newton_iterations"] for i in self.increments) / planned

    def table(self, file):
        with open(f"output/{self.name}/{file}.csv", encoding="utf-8") as lines:
            return [{k: v if k in ("surface", "body") else float(v or "nan")
                     for k, v in row.items()} for row in csv.DictReader(lines)]

    def converges(self):
        check(f"{self.scene}: ends with 0", self.status == 0,
              f"{self.status} {self.said[-300:]}" * (self.status != 0))
        check("  in few Newton steps an increment", self.steps <= MOST_STEPS,
              f"{self.steps:.1f}")
        return self.status == 0

    def reaction(self, group):
        return self.increments[-1]["reactions"][group]

    def force(self, body="B"):
        """The vector of all contact forces on a body."""
        columns = [c for c in self.table("nodes")[0] if
                   c.startswith("contact_force")]
        return [sum(row[c] for row in self.table("nodes") if row["body"] == body)
                for c in columns]


def slaves(scene, vertical, mesh_error=0.03):
    """The force on the head, by either role, in y."""
    for role in ("concave", "convex"):
        result = Result(f"plane/{scene}/{role}_slave")
        if result.converges():
            nearly(f"  force with the {role} slave", result.reaction("Head")["y"],
                   vertical, mesh_error)


def concave_corner_a3():
    slaves("concave_corner_mortar_a3", -137.6)


def concave_corner_b3():
    slaves("concave_corner_mortar_b3", -106.7)


def tongue_in_groove_b():
    # The coarsest mesh for what touches: the roles are 10 % apart.
    slaves("tongue_in_groove_mortar_b", -90.2, 0.12)


def tongue_in_groove_d():
    slaves("tongue_in_groove_mortar_d", -44.3)


def teeth():
    Result("plane/teeth_two_bodies_nodal/scene").converges()
    Result("plane/teeth_two_bodies_small_strain_mortar/scene").converges()


def frictionless_shear_reported():
    result = Result("plane/frictionless_shear_reported/scene")
    if result.converges():
        slave = [row for row in result.table("profile")
                 if row["surface"].startswith("slave")]
        shear = max(abs(row["shear_MPa"]) for row in slave)
        pressure = max(row["pressure_MPa"] for row in slave)
        check("  no shear without friction", shear <= 1e-9 * pressure,
              f"{shear:.3g} of {pressure:.3g} MPa")


def block_in_tray():
    for scene, force in (("c", 163.9), ("f", 153.1)):
        both = [Result(f"space/block_in_tray/tray_{scene}{k}") for k in (0, 1)]
        if all([result.converges() for result in both]):
            one, floor = (math.hypot(*result.force()) for result in both)
            nearly("  force on the floor alone", floor, force, 1e-3)
            nearly("  one group round sole and sides has that", one, floor, 1e-3)


def beside_wall():
    both = [Result(f"space/beside_wall/lq_b{k}") for k in (0, 1)]
    if all([result.converges() for result in both]):
        one, pairs = (result.force()[2] for result in both)
        nearly("  force on floor and wall, a pair each", pairs, 106.8, 1e-3)
        nearly("  one group has that", one, pairs, 1e-2)


def tslot_turned():
    both = [Result(f"space/tslot_turned/tslotup0{turned}",
                   **{"Solution/Geometry tolerance": 1e-9})
            for turned in ("", "_rot")]
    if all([result.converges() for result in both]):
        drawn, turned = (math.hypot(*result.force()) for result in both)
        # By the nodal discretization on this coarse mesh.
        nearly("  force", drawn, 42.1, 0.1)
        nearly("  turned", turned, drawn, 1e-6)


def corner_turned():
    forces = []
    for entries in ({}, {"Contact/Slave": "A_z1", "Contact/Master": "B_z0"}):
        result = Result("space/corner_turned/cornrot", **entries)
        if result.converges():
            forces.append(math.hypot(*result.force()))
    if len(forces) == 2:
        nearly("  roles exchanged", *forces, 0.05)


def ball_between_plates():
    Result("space/ball_between_plates/ballpl0").converges()


def nodal_corner():
    for nodal, mortar in ((Result("space/nodal_corner/Ncorner0"),
                           Result("space/nodal_corner/corner0")),
                          (Result("space/nodal_corner/rnd23"),
                           Result("space/nodal_corner/rnd23", **{
                               "Contact/Discretization": "mortar"}))):
        check(f"{nodal.scene}: ends with 0, or an invariant is violated",
              nodal.status in (0, 1), f"{nodal.status} {nodal.said[-300:]}")
        check("  mortar: ends with 0", mortar.status == 0, mortar.said[-300:])
        if nodal.status == 0 and mortar.status == 0:
            nearly("  force by the nodal discretization as by the mortar",
                   nodal.summary["contact"]["normal_force"],
                   mortar.summary["contact"]["normal_force"], 0.1)


def shared_line_pressure():
    pairs = Result("space/shared_line_pressure/fourpairs0")
    one = Result("space/shared_line_pressure/onepair0")
    if all([pairs.converges(), one.converges()]):
        def place(row):
            return tuple(round(row[c], 6) for c in ("X_mm", "Y_mm", "Z_mm"))
        of_one = {place(row): row["pressure_MPa"] for row in one.table("profile")
                  if row["surface"].startswith("slave")}
        slave = [row for row in pairs.table("profile")
                 if row["surface"].startswith("slave")]
        places = [place(row) for row in slave]
        shared = [row for row in slave if places.count(place(row)) > 1]
        largest = max(of_one.values())
        nearly("  largest pressure of the pair", largest, 20.0, 0.01)
        worst = max(abs(row["pressure_MPa"] - of_one[place(row)])
                    for row in shared) / largest
        check(f"  {len(shared)} pressures on common lines: off by {worst:.1e}",
              len(shared) > 0 and worst < 0.01)


def glue_beside_friction():
    Result("space/glue_beside_friction/gp_a").converges()


def tubes_crash():
    result = Result("reports/tubes_crash/m")
    check("reports/tubes_crash: no error of the program", result.status != 4,
          result.said[-300:])
    if result.converges():
        # Of a section 90 mm high.
        nearly("  rotation [rad]", math.asin(abs(result.probes["rot"]) / 90), 0.30,
               0.03)


def pairs_share_node():
    result = Result("reports/pairs_share_node/m")
    if result.converges():
        for increment in result.increments:
            for side in ("left", "right"):
                nearly(f"  {side} at {increment['load_factor']}",
                       increment[f"contact {side}"]["normal_force"],
                       10.989 * increment["load_factor"], 1e-4)
        worst = max(abs(row["pressure_MPa"] / 10.989 - 1)
                    for row in result.table("profile"))
        check(f"  uniform pressure: off by {worst:.1e}", worst < 1e-4)


scenes = (concave_corner_a3, concave_corner_b3, tongue_in_groove_b,
          tongue_in_groove_d, teeth, frictionless_shear_reported, block_in_tray,
          beside_wall, tslot_turned, corner_turned, ball_between_plates,
          nodal_corner, shared_line_pressure, glue_beside_friction, tubes_crash, pairs_share_node)
if not all((folder / part).is_dir() for part in ("plane", "space", "reports")):
    print(f"skipped: no scenes in {folder}/plane, space and reports")
    sys.exit(0)
for scene in scenes:
    if len(sys.argv) < 5 or any(word in scene.__name__ for word in sys.argv[4:]):
        scene()
print(f"{failures} failures")
sys.exit(failures > 0)
