#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes of analysts that once had a wrong result with exit status 0, crashed,
or gave up, from outside of this repository: skipped where they are not there.

Proves, for each scene of the folder `faults` and some beside it, what must hold
in its result: displacements of the size of what is prescribed, the same result
from two descriptions of one scene, symmetry, closed forms, forces that balance,
refusals that name the place. The numbers are those of the list of faults that
the scenes came with.

Usage: faults.py CONTACT
Folder: SCENES_DIRECTORY, or ../scenes beside REFERENCE_DIRECTORY.
"""

import csv
import json
import os
import pathlib
import re
import subprocess
import sys

contact = pathlib.Path(sys.argv[1]).resolve()
folder = pathlib.Path(os.environ.get("SCENES_DIRECTORY") or pathlib.Path(
    os.environ.get("REFERENCE_DIRECTORY", "reference")).parent / "scenes")
if not (folder / "faults").is_dir():
    print(f"skipped: no scenes in {folder}/faults")
    sys.exit(0)

failures = 0


def check(what, ok, detail=""):
    global failures
    print(f"{'ok' if ok else 'FAILED'}: {what} {detail}", flush=True)
    failures += not ok


class Result:
    """A run of a scene, with probes by name and increments."""

    def __init__(self, scene, name="", **entries):
        file = folder / f"{scene}.prm"
        self.name = file.stem + name
        text = re.sub(r"File = ", f"File = {file.resolve().parent}/",
                      file.read_text())
        pathlib.Path(self.name + ".prm").write_text(text)
        command = ["sh", "-c", 'ulimit -v 4000000; exec "$@"', "sh", contact,
                   self.name + ".prm", "--quiet"]
        for entry, value in {"Output/Screen": "none", "Output/Profile": "true",
                             **entries}.items():
            command += ["--set", f"{entry}={value}"]
        summary = pathlib.Path(f"output/{self.name}/summary.json")
        summary.unlink(missing_ok=True)
        try:
            run = subprocess.run(command, capture_output=True, text=True,
                                 timeout=100, check=False)
            self.status, self.said = run.returncode, run.stdout + run.stderr
        except subprocess.TimeoutExpired:
            self.status, self.said = -1, "no end in 100 s"
        self.summary = json.loads(summary.read_text()) \
            if summary.exists() else {"probes": [], "increments": []}
        self.probes = {p["name"]: p["value"] for p in self.summary["probes"]}
        self.increments = self.summary["increments"]

    def profile(self):
        """The rows of the surfaces, as dictionaries."""
        with open(f"output/{self.name}/profile.csv", encoding="utf-8") as lines:
            return list(csv.DictReader(lines))

    def largest_displacement(self):
        """Of the surfaces [mm]."""
        return max(abs(float(row[f"displacement_{c}_mm"]))
                   for row in self.profile() for c in "xy")

    def converges(self, number):
        check(f"{number} {self.name}: ends with 0", self.status == 0,
              f"{self.status} {self.said[:200]}" if self.status else "")
        return self.status == 0


def stays(number, scene, largest):
    """The displacements are of the size of what is prescribed."""
    result = Result(scene)
    if result.converges(number):
        check("  nothing flies away", result.largest_displacement() < largest,
              f"{result.largest_displacement():.3g} mm")


def nearly(what, value, expected, part):
    check(what, abs(value - expected) <= part * abs(expected),
          f"{value:.6g}, {expected:.6g}")


# 1: bodies held by friction alone, on supports that move.
stays(1, "faults/carried_block", 0.2)
stays(1, "faults/stack", 0.2)
# Edges of the slave as long as the block on it: a third of the force, and told.
flies = Result("flies_away")
check("1 flies_away: a depth is violated, and nothing else",
      flies.status == 1 and flies.said.count("violated: ") ==
      flies.said.count("violated: depth"), flies.said[:200])
check("  nothing flies away", flies.largest_displacement() < 1,
      f"{flies.largest_displacement():.3g} mm")

# 2: a surface that goes round a corner is the surface of its top.
top, corner = Result("faults/master_top_only"), Result(
    "faults/master_round_corner")
if top.converges(2) and corner.converges(2):
    nearly("  the tip of both", corner.probes["tip"], top.probes["tip"], 0.01)
    nearly("  and its mirror image", corner.probes["tip"],
           corner.probes["tipR"], 1e-6)
gauss = Result("faults/gauss_round_corner")
if gauss.converges(2):
    found = gauss.summary["contact"]
    # Summed along the normals of facets that tilt by a hundredth.
    nearly("  a normal force of 30 N/mm", found["normal_force"], 30, 1e-4)
    check("  no wider than the pedestal", found["width"] <= 10.001,
          f"{found['width']:.4f}")

# 3: a frictionless flat surface pushes along its normal only.
flat = Result("f4_corner")
if flat.converges(3):
    force = flat.increments[-1].get("reactions", {}).get("Base", {})
    found = flat.increments[-1]["contact"]
    check("  no force along the ground",
          abs(force.get("x", 1e9)) < 0.01 * abs(force.get("y", 0)), str(force))

# 4: a master of several pieces; the scene is symmetric.
feet = Result("faults/feet")
if feet.converges(4):
    nearly("  left is right", feet.probes["l"], feet.probes["r"], 1e-6)

# 5: one physical surface of two pieces, one of which nothing holds.
loose = Result("faults/loose_piece")
check("5 loose_piece: the loose piece is held, or named",
      (loose.status == 0 and abs(loose.probes["far"]) < 1) or
      (loose.status in (2, 3) and "piece" in loose.said),
      f"{loose.status} {loose.probes} {loose.said[:200]}")

# 6: overlap and no load, at any scale: between E and 2 E a third and two
# thirds of it, but for the ends.
for scene, length in (("press_tiny_force", 1), ("press_soft", 1),
                      ("press_metre", 1e-3)):
    fits = [Result(f"faults/{scene}", f"_{factor:g}", **{
        "Solids/Young's modulus": young}) for factor, young in
        ((1, "Low: 210000, Up: 420000"), (1e-9, "Low: 210e-6, Up: 420e-6"))]
    own = Result(f"faults/{scene}")
    if own.converges(6) and all(fit.converges(6) for fit in fits):
        for fit in fits:
            nearly("  the same at any stiffness", own.probes["c"],
                   fit.probes["c"], 1e-6)
hub = Result("f2_interference")
if hub.converges(6):
    middle = min((row for row in hub.profile() if row["surface"] == "slave"),
                 key=lambda row: abs(float(row["Y_mm"]) - 20))
    # The shaft goes on beyond the ends of the hub, which take more than their
    # part of the pressure.
    nearly("  Lame's pressure in the middle", float(middle["pressure_MPa"]),
           78.75, 0.05)

# 9: lines of the master's own body in the slave.
own = Result("faults/slave_and_own_master")
check("9 slave_and_own_master: refused with the place",
      own.status == 2 and "Contact/Slave" in own.said,
      f"{own.status} {own.said[:200]}")

# 11: beams without contact.
for scene in ("beam_no_contact", "beam_saddle"):
    beam = Result(f"faults/{scene}")
    if beam.converges(11):
        steps = sum(i["newton_iterations"] for i in beam.increments)
        check("  in 12 steps or fewer", steps <= 12, str(steps))

# 12, 13: masters with teeth; the memory of nine slave nodes.
for scene, number in (("f1_crash", 12), ("faults/comb", 12),
                      ("faults/comb2", 12), ("faults/memory", 13)):
    teeth = Result(scene)
    check(f"{number} {scene}: no error of the program", teeth.status in (0, 3),
          f"{teeth.status} {teeth.said[:200]}")
    if teeth.converges(number):
        memory = teeth.summary["peak_memory_mb"]
        check("  below 1 GB", memory < 1000, f"{memory:.0f} MB")

# 14: an ordinary scene of two blocks; the rest is in analyst_scenes.py.
Result("faults/vertices").converges(14)
sys.exit(failures > 0)
