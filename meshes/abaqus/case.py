# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an Abaqus deck says beside its mesh, as entries of a case, and a list of
what is left out."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from named_mesh import BadMesh

from . import contact, loads, probes, solids
from .contact import Obstacle
from .deck import Block, Row
from .parts import Scope
from .steps import Amplitude, Load, Step, text

if TYPE_CHECKING:
    from .groups import Groups

KEYWORDS = {**solids.KEYWORDS, **contact.KEYWORDS, **loads.KEYWORDS}
# What others refer to comes first, wherever it stands; the others have 2.
ORDER = {"SURFACE": 0, "AMPLITUDE": 0, "RIGIDBODY": 1, "TRANSFORM": 1,
         "CONTACTPAIR": 3, "TIE": 3, "CONTACTINCLUSIONS": 4,
         "CONTACTPROPERTYASSIGNMENT": 5}
QUIET = {"CONTACT", "HEADING", "PREPRINT", "ENDSTEP", "SOLIDSECTION"}
OUTPUT = ("OUTPUT", "PRINT", "FILE", "RESTART", "MONITOR")
WHY = {"EXPANSION": "give Solids/Thermal strain",
       "TEMPERATURE": "give Solids/Thermal strain",
       "CONTACTCONTROLS": "contact needs no controls",
       "CONTROLS": "see the section Solution",
       "EQUATION": "give Boundary conditions/Tied x, Tied y or Rigid",
       "MPC": "give Boundary conditions/Tied x, Tied y or Rigid",
       "COUPLING": "give Boundary conditions/Rigid",
       "CONTACTEXCLUSIONS": "give *CONTACT PAIR",
       "CONTACTINTERFERENCE": "give Contact/Interference",
       "CLEARANCE": "give Contact/Interference, negative",
       "MODELCHANGE": "pairs are there in all steps",
       "PRE-TENSIONSECTION": "give Contact/Preload",
       "ORIENTATION": "materials are isotropic"}

SECTIONS = ("Mesh", "Element", "Solids", "Boundary conditions", "Contact",
            "Solution", "Probes", "Output")
# Entries whose values have a comma.
WITH_COMMAS = ("Points", "Hardening curve", "Displacement formula", "Pressure",
               "Traction", "Body force", "Histories", "Obstacle motion",
               "Obstacle force", "Probes")
MARK = "# Written by meshes/convert.py from "


class Case:
    """Entries of a .prm file by section, and what is left out."""

    def __init__(self, groups: Groups):
        self.groups, self.deck = groups, groups.deck
        self.entries: dict[str, dict[str, list[str]]] = {}
        self.left_out: list[tuple[str, str, str]] = []
        self.materials: dict[str, dict[str, Block]] = {}
        self.material: dict[str, Block] | None = None
        # Entries, by surface interaction.
        self.friction: dict[str, dict[str, str]] = {}
        self.interaction: str | None = None
        self.general = ""  # the section of general contact
        self.obstacles: dict[str, Obstacle] = {}
        self.reference_nodes: dict[int, Obstacle] = {}
        self.moving: list[tuple[str, Obstacle]] = []
        self.amplitudes: dict[str, Amplitude] = {}
        self.steps: list[Step] = []
        self.loads: dict[tuple[str, str], Load] = {}
        self.body_forces: list[tuple] = []
        self.weighed: set[int] = set()  # materials whose density is used
        self.ending: list[tuple[int, Load, Block]] = []
        # What output is asked for: quantity -> groups.
        self.wanted: dict[str, list[str]] = {}
        self.held: dict[str, set[int]] = {}  # nodes by direction
        self.transformed: set[int] = set()
        self.large = self.is_round = False
        self.thickness = self.find_thickness()
        # Of a deck that is a mesh alone no case is written.
        self.is_one = any(block.keyword in ("STEP", "SOLIDSECTION")
                          for block, _ in self.deck.rest)
        self.read()

    def read(self) -> None:
        def turn(pair: tuple[Block, Scope]) -> int:
            return ORDER.get(pair[0].keyword, 2)

        for block, scope in sorted(self.deck.rest, key=turn):
            if block.keyword in KEYWORDS:
                KEYWORDS[block.keyword](self, block, scope)
            elif block.keyword in probes.KEYWORDS:
                probes.KEYWORDS[block.keyword](self, block, scope)
            elif block.keyword.endswith(OUTPUT):
                self.leave(block, "see the sections Output and Probes")
            elif block.keyword not in QUIET:
                self.leave(block, WHY.get(block.keyword, "no such entry"))
        if not self.is_one:
            return
        bodies = solids.put_solids(self)
        loads.put_body_forces(self, bodies)
        loads.put_loads(self)
        for section, obstacle in self.moving:
            obstacle.entries(self, section)
        probes.put_probes(self)
        self.put("Output", "VTU", "true")
        self.put("Output", "Profile", "true")
        entries = self.entries.get("Boundary conditions", {})
        if "Histories" in entries:  # behind all others
            entries["Histories"] = entries.pop("Histories")

    @property
    def n_steps(self) -> int:
        return max(1, len(self.steps))

    def leave(self, at: Block | Row, why: str) -> None:
        """Notes what is not in the case."""
        path, line, title = at.where.rsplit(", ", 2)
        if path != str(self.deck.path):
            line += f" of {path}"
        if (line, title, why) not in self.left_out:
            self.left_out.append((line, title, why))

    def put(self, section: str, entry: str, text: str) -> None:
        self.entries.setdefault(section, {}).setdefault(entry, []).append(text)

    def section_of_pair(self, slave: str) -> str:
        if "Contact" not in self.entries:
            return "Contact"
        name, n = f"Contact {slave}", 1
        while name in self.entries:
            n += 1
            name = f"Contact {slave} {n}"
        return name

    def place(self, name: str, node: int, row: Row) -> None:
        """A name for a mid-side node."""
        owner = next((body for body, cells in self.groups.body_cells.items()
                      if any(node in self.deck.cells[c].nodes for c in cells)), None)
        if owner is None:
            row.fault(f"node {self.groups.labels[node]} is in no area or volume",
                      "name a node of an element, or of a rigid surface")
        place = f"{name} in {owner}: " + ", ".join(
            text(x) for x in self.deck.points[node][:self.deck.dimension])
        if place not in self.entries.get("Mesh", {}).get("Points", ()):
            self.put("Mesh", "Points", place)

    def find_thickness(self) -> float:
        """Of plane sections, which the program has of 1 mm."""
        found = {block.rows[0].number(0, 1.0): block
                 for block, _ in self.deck.rest if block.keyword == "SOLIDSECTION"
                 and block.rows and self.deck.dimension == 2
                 and not self.deck.cells[0].code.startswith("CAX")}
        if len(found) > 1:
            block = list(found.values())[1]
            block.fault("sections have more than one thickness: "
                        + ", ".join(text(t) for t in found),
                        "plane sections have one")
        for thickness, block in found.items():
            if thickness <= 0:
                block.rows[0].fault("the thickness is not positive",
                                    "write one above zero")
            if thickness != 1:
                self.leave(block, f"a thickness of {text(thickness)}: forces here "
                           "are per mm of thickness, those of *CLOAD are divided "
                           "by it")
        return next(iter(found), 1.0)

    # --------------------------------------------------------- the result

    def report(self) -> list[str]:
        """What is left out, one line for each reason of a keyword."""
        found: dict[tuple[str, str], list[str]] = {}
        for line, title, why in self.left_out:
            found.setdefault((title, why), []).append(line.split(" ", 1)[1])

        def first(lines: list[str]) -> int:
            return int(lines[0].split()[0])

        return [f"left out: {title}, line {', '.join(lines)}: {why}"
                for (title, why), lines in sorted(
                    found.items(), key=lambda item: first(item[1]))]

    def prm(self, mesh: Path) -> str:
        lines = [MARK + self.deck.path.name]
        lines += ["# " + line for line in self.report()]
        self.entries.setdefault("Mesh", {})["File"] = [mesh.name]
        for section in sorted(self.entries, key=lambda s: SECTIONS.index(
                "Contact" if s.startswith("Contact") else s)):
            lines.append(f"\nsubsection {section}")
            lines += [f"  set {entry} = "
                      + ("; " if entry.startswith(WITH_COMMAS) else ", ").join(values)
                      for entry, values in self.entries[section].items()]
            lines.append("end")
        return "\n".join([*lines, ""])

    def check_place(self, path: Path) -> None:
        """A case that somebody has written stays."""
        if path.exists() and not path.read_text(errors="replace").startswith(MARK):
            raise BadMesh("the case would take the place of a file that "
                          "convert.py has not written", str(path),
                          "name another OUT.msh, or remove the file")
