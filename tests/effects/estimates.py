#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimated effects beside true ones: each scene once with 'Solution/Estimate
effects', then each of its variants by a run of its own, with the entries that
the estimate names.

Prints a table with a row for each effect and probe that changes by more than
0.1 %, and then how many estimates are within a factor of two, and how many
verdicts at 1 % and 0.1 % of the probe are right, wrong, or not given.

Usage: estimates.py CONTACT [SCENE...]
"""

import json
import pathlib
import subprocess
import sys
import tempfile

contact = pathlib.Path(sys.argv[1]).resolve()
parameters = pathlib.Path(__file__).resolve().parents[2] / "parameters"
scenes = sys.argv[2:] or [
    "ssnp154_a", "ssnp154_b", "ssnp154_c", "ssnp154_d",
    "verification/nested_cylinders",
    "verification/hertz", "verification/hertz_friction",
    "verification/punch", "verification/punch_friction", "verification/stack",
    "verification/disk_in_ring", "verification/sphere_on_plane"]


def solve(scene, directory, *settings):
    """The summary of a run, or none if it does not converge."""
    file = parameters / f"{scene}.prm" if "." not in scene else scene
    command = [str(contact), str(file), "--quiet"]
    for setting in (f"Output/Directory={directory}", "Output/VTU=false",
                    "Output/Profile=false", "Probes/References=",
                    "Probes/Tolerances=", "Probes/Concentric cylinders=",
                    "Probes/Hertz=", "Probes/Frictional theory=false",
                    *settings):
        command += ["--set", setting]
    try:
        ended = subprocess.run(command, capture_output=True, text=True,
                               check=False, timeout=120)
    except subprocess.TimeoutExpired:
        return None, "takes more than two minutes"
    if ended.returncode not in (0, 1):
        return None, ended.stderr.strip().splitlines()[0]
    summary = next(pathlib.Path(directory).glob("*/summary.json"))
    return json.loads(summary.read_text()), ""


def verdict(change, uncertainty, accepted):
    if abs(change) - abs(uncertainty) > accepted:
        return True
    if abs(change) + abs(uncertainty) <= accepted:
        return False
    return None


ratios = []
verdicts = {0.01: [], 0.001: []}
print("| scene | effect | here | probe | estimated | true | estimated / true |")
print("|---|---|---|---|---|---|---|")
for scene in scenes:
    with tempfile.TemporaryDirectory() as directory:
        base, why = solve(scene, directory, "Solution/Estimate effects=true")
    if base is None:
        sys.exit(f"{scene}: {why}")
    values = {probe["name"]: probe["value"] for probe in base["probes"]}
    for effect in base["estimated_effects"]:
        with tempfile.TemporaryDirectory() as directory:
            other, why = solve(scene, directory, *effect["entries"])
        here = "on" if effect["on"] else "off"
        start = f"| {pathlib.Path(scene).stem} | {effect['effect']} | {here} | "
        if other is None or effect["unknown"]:
            print(f"{start} | {effect['unknown'] or 'known'} | "
                  f"{why or 'converges'} | |", flush=True)
        if other is None:
            continue
        true = {probe["name"]: probe["value"] - values[probe["name"]]
                for probe in other["probes"]}
        for name, value in values.items():
            estimated = effect["changes"].get(name)
            for accepted, found in verdicts.items():
                limit = accepted * abs(value)
                said = None if estimated is None else verdict(
                    estimated, effect["uncertainties"][name], limit)
                found.append(None if said is None else
                             said == (abs(true[name]) > limit))
            if abs(true[name]) <= 1e-3 * abs(value):
                continue
            if estimated is None:
                print(f"{start}{name} | - | {true[name]:.3g} | |")
                continue
            ratio = estimated / true[name]
            ratios.append(ratio)
            print(f"{start}{name} | {estimated:.3g} +- "
                  f"{abs(effect['uncertainties'][name]):.1g} | "
                  f"{true[name]:.3g} | {ratio:.2f} |", flush=True)
good = sum(0.5 <= ratio <= 2 for ratio in ratios)
print(f"\nWithin [0.5, 2]: {good} of {len(ratios)}.")
for accepted, found in verdicts.items():
    print(f"Verdicts at {accepted:.1%}: {found.count(True)} right, "
          f"{found.count(False)} wrong, {found.count(None)} not given.")
