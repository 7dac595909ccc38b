#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scenes as analysts draw them, from outside of this repository, at default
settings: skipped where they are not there.

Proves that all of them converge with the rules mortar and nodal, in at most 15
Newton steps an increment on average, and that a shaft is
pushed out of its hub, and a joint slips, at mu times the normal force; a roller
has the pressure of Hertz under the force that it carries.

Usage: analyst_scenes.py CONTACT [--jobs N]
Folder: SCENES_DIRECTORY, or ../scenes beside REFERENCE_DIRECTORY.
"""

import json
import math
import os
import pathlib
import re
import subprocess
import sys
import time

contact = pathlib.Path(sys.argv[1]).resolve()
folder = pathlib.Path(os.environ.get("SCENES_DIRECTORY") or pathlib.Path(
    os.environ.get("REFERENCE_DIRECTORY", "reference")).parent / "scenes")
files = sorted(folder.glob("*.prm"))
if not files:
    print(f"skipped: no scenes in {folder}")
    sys.exit(0)

failures = 0


def check(what, ok, detail=""):
    global failures
    print(f"{'ok' if ok else 'FAILED'}: {what} {detail}", flush=True)
    failures += not ok


def within_a_percent(what, value, expected):
    check(what, abs(value / expected - 1) < 0.01, f"{value:.5g} {expected:.5g}")


def physics(name, increments):
    last = increments[-1]
    if name == "press":
        contact = last["contact"]
        within_a_percent("  pushed out at mu N", contact["tangential_force"],
                         0.12 * contact["normal_force"])
    if name == "lap":
        plates = last["contact plates"]
        within_a_percent("  slips at mu N", abs(plates["tangential_force"]),
                         0.2 * plates["normal_force"])
    if name == "roller":
        # 1/E* of both bodies in plane strain.
        modulus = 1 / ((1 - 0.3**2) / 10000 + (1 - 0.35**2) / 3000)
        contact = last["contact"]
        within_a_percent("  shear over normal force is mu",
                         contact["tangential_force"],
                         0.3 * contact["normal_force"])
        within_a_percent("  Hertz' pressure", contact["max_pressure"],
                         math.sqrt(contact["normal_force"] * modulus /
                                   (math.pi * 10)))
    if name == "f4_corner":
        forces = last["reactions"]["Base"]
        check("  no force along the ground",
              abs(forces["x"]) < 0.01 * forces["y"], str(forces))


for file in files:
    for rule in ("mortar", "nodal"):
        name = f"{file.stem}_{rule}"
        text = re.sub(r"Rule = \w+", f"Rule = {rule}", file.read_text())
        text = re.sub(r"File = ", f"File = {folder.resolve()}/", text)
        text = re.sub(r"VTU = true", "VTU = false", text)
        pathlib.Path(name + ".prm").write_text(text)
        start = time.time()
        status = subprocess.run([contact, name + ".prm", "--quiet"],
                                stdout=subprocess.DEVNULL).returncode
        seconds = time.time() - start
        summary = json.loads(pathlib.Path(
            f"output/{name}/summary.json").read_text())
        steps = sum(i["newton_iterations"] for i in summary["increments"])
        planned = int(re.search(r"Increments = (\d+)", text).group(1)) \
            if "Increments" in text else 2
        # Edges of the slave as long as the block on it: a third of the force that
        # refined meshes have, which is a violated invariant.
        is_told = name == "flies_away_nodal" and status == 1 and all(
            f["text"].startswith("depth") for f in summary["findings"]
            if f["severity"] == "violated")
        check(f"{name} converges", status == 0 or is_told,
              f"{steps} steps, {planned} increments, {seconds:.1f} s")
        # A loop around Newton's method takes as many as it takes.
        if "fixed point" not in text:
            check("  in few steps", steps <= 15 * planned)
        if rule == "mortar" and status == 0:
            physics(file.stem, summary["increments"])
sys.exit(failures > 0)
