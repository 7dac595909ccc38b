# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scenes of analysts.py are made of: the scene, and helpers for meshes and
entries."""

import dataclasses
import pathlib
import subprocess

SIZE = 1  # factor on the sizes of cells: smaller ones are for references


@dataclasses.dataclass
class Scene:
    """ENTRIES: {"Section/Entry": value}. REFERENCES: {probe: (value, source)}; the
    value may be a function of all probes {name: value}, for balances."""
    entries: dict
    references: dict


def mesh(name, geo, dim=2):
    """Writes NAME.geo and NAME.msh; the name of the latter."""
    pathlib.Path(f"{name}.geo").write_text(geo)
    subprocess.run(["gmsh", f"-{dim}", "-format", "msh22", "-clscale", str(SIZE),
                    f"{name}.geo", "-o", f"{name}.msh"], check=True,
                   capture_output=True)
    return f"{name}.msh"


def materials(**bodies):
    """Of BODY=(E, nu), as entries."""
    return {f"Solids/{key}": ", ".join(f"{body}: {values[i]}"
                                       for body, values in bodies.items())
            for i, key in enumerate(("Young's modulus", "Poisson's ratio"))}


def section(name, **values):
    """Entries of it; in their names '_' is a blank."""
    return {f"{name}/{key.replace('_', ' ')}": value for key, value in values.items()}


def parameter_file(entries):
    lines = []
    for entry, value in entries.items():
        section, key = entry.split("/", 1)
        lines += [f"subsection {section}", f"  set {key} = {value}", "end"]
    return "\n".join(lines) + "\n"
