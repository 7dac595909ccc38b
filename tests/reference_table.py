#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Modelings A to G on the reference mesh as a table, from the results that the
tests modelings/reference_mesh_* have left in the build directory:

    reference_table.py BUILD
"""

import json
import sys
from pathlib import Path

KINDS = {"published": "from the published values (geometry loop, 1 %)",
         "newton_geometry": "geometry converged", "small_strain": "small strain"}


def probes(build: Path, kind: str, modeling: str) -> dict:
    file = (build / f"tests/modelings/reference_mesh_{kind}/output" / modeling /
            "summary.json")
    if not file.is_file():
        sys.exit(f"reference_table.py: {file} does not exist: run the tests "
                 "where the reference meshes are")
    summary = json.loads(file.read_text())
    return {probe["name"]: probe for probe in summary["probes"]}


def main() -> None:
    build = Path(sys.argv[1])
    print("| | DY(B) | SIYY(B) | " + " | ".join(KINDS.values()) + " |")
    print("|---" * (3 + len(KINDS)) + "|")
    for modeling in "abcdefg":
        found = {kind: probes(build, kind, modeling) for kind in KINDS}
        first = found["published"]
        cells = [f"{first['DY(B)']['value']:.9f}",
                 f"{first['SIYY(B)']['value']:.5f}"]
        cells += [", ".join(f"{abs(p[name]['relative_deviation']):.0e}"
                            for name in ("DY(B)", "SIYY(B)"))
                  for p in found.values()]
        print(f"| {modeling.upper()} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
