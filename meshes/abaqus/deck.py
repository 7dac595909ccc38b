# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form of an Abaqus deck: keywords with options, and their rows of data."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn

from named_mesh import BadMesh


@dataclass
class Row:
    """A line of data, its fields without blanks and quotes."""
    where: str
    fields: list[str]

    def text(self, i: int) -> str:
        return self.fields[i] if i < len(self.fields) else ""

    def fault(self, what: str, remedy: str) -> NoReturn:
        raise BadMesh(what, self.where, remedy)

    def number(self, i: int, without: float = 0.0) -> float:
        """The number in a field, with the exponents of Fortran."""
        text = self.text(i)
        if not text:
            return without
        try:
            value = float(re.sub("[dD]", "e", text))
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            self.fault(f"'{text}' is no number", f"write a number in field {i + 1}")
        return value

    def integer(self, i: int) -> int:
        text = self.text(i)
        if not re.fullmatch(r"[+-]?\d+", text):
            self.fault(f"'{text}' is no whole number",
                       f"write a number in field {i + 1}")
        return int(text)


@dataclass
class Block:
    """A keyword with its options and rows."""
    keyword: str  # in capitals without blanks and star: SOLIDSECTION
    title: str    # in capitals, as it is read: *SOLID SECTION
    options: dict[str, str]
    path: Path
    line: int
    rows: list[Row] = field(default_factory=list)

    @property
    def where(self) -> str:
        return f"{self.path}, line {self.line}, {self.title}"

    def has(self, option: str, value: str) -> bool:
        """Whether an option says so, in capitals or not."""
        return self.options.get(option, "").replace(" ", "").upper() == value

    def fault(self, what: str, remedy: str) -> NoReturn:
        raise BadMesh(what, self.where, remedy)

    def need(self, option: str) -> str:
        if not self.options.get(option):
            self.fault(f"the option {option} is missing",
                       f"write {self.title}, {option}=NAME")
        return self.options[option]

    def number_of(self, option: str) -> float:
        return Row(self.where, [self.need(option)]).number(0)


def split(line: str) -> list[str]:
    """Fields between commas that are not in quotes."""
    fields = re.findall(r'((?:"[^"]*"|[^,"])*),', line + ",")
    return [f.strip().replace('"', "") for f in fields]


class Reader:
    """The blocks of a deck and of the files that it includes."""

    def __init__(self, path: Path):
        self.blocks: list[Block] = []
        self.folder = path.parent
        self.read(path, ())

    def read(self, path: Path, within: tuple[Path, ...]) -> None:
        lines = enumerate(path.read_text(errors="replace").splitlines(), 1)
        self.read_lines(path, [(n, line.strip()) for n, line in lines
                               if line.strip() and not line.startswith("**")]
                        [::-1], (*within, path))

    def read_lines(self, path: Path, lines: list, within: tuple) -> None:
        """Takes lines, the last one first."""
        while lines:
            number, line = lines.pop()
            if line.startswith("*"):
                while line.endswith(",") and lines and lines[-1][1][0] != "*":
                    line += lines.pop()[1]
                self.add_block(path, number, line, within)
            elif not self.blocks:
                raise BadMesh("data stand before the first keyword",
                              f"{path}, line {number}",
                              "begin an Abaqus deck with a keyword, as *HEADING")
            else:
                block = self.blocks[-1]
                block.rows.append(Row(f"{path}, line {number}, {block.title}",
                                      split(line.removesuffix(","))))

    def add_block(self, path: Path, number: int, line: str, within) -> None:
        head, *options = split(line.removesuffix(","))
        title = "*" + " ".join(head[1:].upper().split())
        pairs = [option.partition("=") for option in options]
        block = Block(title[1:].replace(" ", ""), title,
                      {key.strip().upper().replace(" ", ""): value.strip()
                       for key, _, value in pairs}, path, number)
        if block.keyword != "INCLUDE":
            self.blocks.append(block)
        if block.keyword == "INCLUDE":
            block.need("INPUT")
        if "INPUT" in block.options:
            name = self.folder / block.options["INPUT"]
            if not name.is_file() or name in within:
                block.fault(f"the file '{name}' "
                            + ("does not exist" if name not in within
                               else "includes itself"), "correct INPUT=")
            self.read(name, within)
