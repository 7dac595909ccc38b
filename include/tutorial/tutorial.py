#!/usr/bin/python3
"""The main page of the documentation, for doxygen: contact.cc as a tutorial in
the manner of deal.II's, with introduction, commented program and results.

usage: tutorial.py DIRECTORY/intro.dox

Prints the page; results.dox is beside the introduction, the program and the table
of modelings A to G (of README.md) are two directories above.
SPDX-License-Identifier: LGPL-2.1-or-later
"""

import html
import pathlib
import re
import sys


def sections(text):
    """Sections of deal.II's tutorials as headings of HTML."""
    return re.sub(
        r"@sect(\d)\{(.*)\}",
        lambda m: f"<h{m[1]}>{m[2]}</h{m[1]}>", text)


def formulas(text):
    """Formulas between dollars as doxygen has them."""
    return re.sub(r"\$([^$]+)\$", r"@f$\1@f$", text)


def commented_program(source):
    """Comments at the start of a line as text, all else as code."""
    pieces = re.split(r"((?:^ *//(?: .*)?\n)+)", source, flags=re.M)
    out = []
    for piece in pieces:
        if re.match(r" *//", piece):
            text = re.sub(r"^ *// ?", "", piece, flags=re.M)
            out.append(sections(html.escape(text, quote=False)))
        elif piece.strip():
            code = piece.strip("\n")
            out.append(f"@code{{.cc}}\n{code}\n@endcode\n")
    return "\n".join(out)


def modelings(readme):
    """The table of modelings that README.md shows as the program prints it."""
    block = readme[readme.index("<!-- study:modelings:begin -->"):]
    return re.search(r"```\n(.*?)```", block, flags=re.S)[1]


def main(intro):
    here = pathlib.Path(intro).parent
    top = here.parent.parent
    program = (top / "contact.cc").read_text(encoding="utf-8")
    table = modelings((top / "README.md").read_text(encoding="utf-8"))
    results = (here / "results.dox").read_text(encoding="utf-8")
    print("/** @mainpage Frictional contact of two deformable bodies",
          "<h2>Introduction</h2>",
          formulas(pathlib.Path(intro).read_text(encoding="utf-8")),
          "<h2>The commented program</h2>",
          commented_program(program[program.index("// @sect3"):]),
          "<h2>Results</h2>",
          formulas(results.replace("@MODELINGS@",
                                   f"@verbatim\n{table}@endverbatim")),
          "*/", sep="\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
