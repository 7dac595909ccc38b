#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Estimated effects beside true ones: each scene once with 'Solution/Estimate
effects', then each of its variants by a run of its own, with the entries that
the estimate names.

Prints a table with a row for each effect and probe that changes by more than
0.1 %, and then how many estimates are within a factor of two, and how many
verdicts at 1 % and 0.1 % of the probe are right, wrong, or not given. A scene
may have other entries behind it: 'nested --set Refinement/Levels=1'.

Usage: estimates.py [--only EFFECT] CONTACT [SCENE...]
"""

import argparse
import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile

parameters = pathlib.Path(__file__).resolve().parents[2] / "parameters"
SCENES = ["ssnp154_a", "ssnp154_b", "ssnp154_c", "ssnp154_d",
          "verification/nested_cylinders", "verification/hertz",
          "verification/hertz_friction", "verification/punch",
          "verification/punch_friction", "verification/stack",
          "verification/sphere_on_plane", "hard/pin_friction",
          "hard/triangles", "nested_friction"]


def solve(contact, scene, *settings):
    """The summary of a run, or none and a sentence if there is no result. The
    SETTINGS count more than those of the scene."""
    scene, *own = scene.split(" --set ")
    own = ["Output/VTU=false", "Output/Profile=false", "Probes/References=",
           "Probes/Tolerances=", *own]
    file = scene if scene.endswith(".prm") else parameters / f"{scene}.prm"
    names = {setting.split("=")[0] for setting in settings}
    settings = [s for s in own if s.split("=")[0] not in names] + [*settings]
    with tempfile.TemporaryDirectory() as directory:
        command = [str(contact), str(file), "--quiet"]
        for setting in (f"Output/Directory={directory}", *settings):
            command += ["--set", setting]
        try:
            ended = subprocess.run(command, capture_output=True, text=True,
                                   check=False, timeout=120)
        except subprocess.TimeoutExpired:
            return None, "takes more than two minutes"
        if ended.returncode not in (0, 1):
            said = ended.stderr.strip().splitlines()
            return None, said[0] if said else f"exit status {ended.returncode}"
        summary = next(pathlib.Path(directory).glob("*/summary.json"))
        return json.loads(summary.read_text()), ""


def called_for(change, uncertainty, accepted):
    """The verdict of the program, or none."""
    if abs(change) - abs(uncertainty) > accepted:
        return True
    if abs(change) + abs(uncertainty) <= accepted:
        return False
    return None


@dataclasses.dataclass
class Comparison:
    """An effect on a probe; without estimate, or without true change, why."""
    scene: str
    effect: dict
    probe: str = ""
    value: float = 0
    true: float = None
    why: str = ""

    @property
    def estimated(self):
        return self.effect["changes"].get(self.probe)

    def verdict_is_right(self, accuracy):
        """None: there is none."""
        if self.true is None or self.estimated is None:
            return None
        accepted = accuracy * abs(self.value)
        verdict = called_for(self.estimated,
                             self.effect["uncertainties"][self.probe], accepted)
        return None if verdict is None else verdict == (abs(self.true) > accepted)


def compare(contact, scene, base):
    """All effects on all probes of a scene, whose summary is BASE."""
    values = {probe["name"]: probe["value"] for probe in base["probes"]}
    for effect in base["estimated_effects"]:
        other, why = solve(contact, scene, *effect["entries"])
        if other is None:
            yield Comparison(scene, effect, why=why)
            continue
        for probe in other["probes"]:
            name = probe["name"]
            yield Comparison(scene, effect, name, values[name],
                             probe["value"] - values[name])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", default="", help="effects that begin so")
    parser.add_argument("contact", type=lambda p: pathlib.Path(p).resolve())
    parser.add_argument("scene", nargs="*", default=SCENES)
    options = parser.parse_args()
    contact = options.contact
    ratios, comparisons = [], []
    print("| scene | effect | here | probe | estimated | true | "
          "estimated / true |")
    print("|---|---|---|---|---|---|---|")
    for scene in options.scene:
        base, why = solve(contact, scene, "Solution/Estimate effects=true")
        if base is None:
            sys.exit(f"{scene}: {why}")
        base["estimated_effects"] = [
            effect for effect in base["estimated_effects"]
            if effect["effect"].startswith(options.only)]
        for row in compare(contact, scene, base):
            comparisons.append(row)
            here = "on" if row.effect["on"] else "off"
            name = pathlib.Path(scene.split(" --set ")[0]).stem
            start = (f"| {name} | {row.effect['effect']} | {here} | "
                     f"{row.probe} |")
            if row.true is None:
                print(f"{start} {row.effect['unknown'] or '-'} | {row.why} | |",
                      flush=True)
            elif abs(row.true) <= 1e-3 * abs(row.value):
                continue
            elif row.estimated is None:
                print(f"{start} {row.effect['unknown']} | {row.true:.3g} | |",
                      flush=True)
            else:
                ratios.append(row.estimated / row.true)
                uncertainty = abs(row.effect["uncertainties"][row.probe])
                print(f"{start} {row.estimated:.3g} +- {uncertainty:.1g} | "
                      f"{row.true:.3g} | {ratios[-1]:.2f} |", flush=True)
    good = sum(0.5 <= ratio <= 2 for ratio in ratios)
    print("\n| of all rows and effects | |\n|---|---|")
    print(f"| estimated / true within [0.5, 2] | {good} of {len(ratios)} |")
    for accuracy in (0.01, 0.001):
        right = [row.verdict_is_right(accuracy) for row in comparisons]
        wrong = "".join(f"; {row.scene}, {row.effect['effect']}, {row.probe}"
                        for row, is_right in zip(comparisons, right)
                        if is_right is False)
        print(f"| verdicts at {accuracy:.1%} | {right.count(True)} right, "
              f"{right.count(False)} wrong, {right.count(None)} not given"
              f"{wrong} |")


if __name__ == "__main__":
    main()
