#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""contact.cc as a tutorial, and the documentation of the classes.

Proves that doxygen has no complaint; that its main page has every section of
contact.cc, in that order, the whole program, and the pictures of the results; and
that all rooms of include/ have classes there.

Usage: tutorial.py CONTACT PARAMETERS MESHES
"""

import html
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent.parent


def text_of(page):
    """The text of a page of HTML, without white space."""
    return re.sub(r"\s|\u200b", "", html.unescape(re.sub(r"<[^>]*>", "", page)))


def main():
    if not shutil.which("doxygen"):
        print("skipped: no doxygen; apt-get install doxygen")
        return
    directory = pathlib.Path("tutorial").resolve()
    shutil.rmtree(directory, ignore_errors=True)
    settings = (HERE / "tests/Doxyfile").read_text(encoding="utf-8")
    run = subprocess.run(["doxygen", "-"], cwd=HERE, text=True, capture_output=True,
                         input=f"{settings}\nOUTPUT_DIRECTORY = {directory}\n")
    failures = []
    if run.returncode:
        failures.append(f"doxygen: {run.stderr[-1000:]}")
    page = (directory / "html/index.html").read_text(encoding="utf-8")
    program = (HERE / "contact.cc").read_text(encoding="utf-8")

    sections = re.findall(r"@sect\d\{(.*)\}", program)
    headings = [html.unescape(heading) for heading in
                re.findall(r"<h[34]>(.*?)</h[34]>", page)]
    first = headings.index(sections[0]) if sections[0] in headings else 0
    if headings[first:first + len(sections)] != sections:
        failures.append(f"sections {sections}, on the page {headings}")

    text = text_of(page)
    code = [line for line in program[program.index("#include"):].splitlines()
            if line.strip() and not line.strip().startswith("//")]
    missing = [line for line in code if re.sub(r"\s", "", line) not in text]
    if missing:
        failures.append(f"{len(missing)} lines of code, the first: {missing[0]}")

    for picture in re.findall(r"@image html (\S+)",
                              (HERE / "include/tutorial/results.dox").read_text()):
        if f'="{picture}"' not in page or \
           not (directory / "html" / picture).exists():
            failures.append(f"the picture {picture}")

    classes = (directory / "html/annotated.html").read_text(encoding="utf-8")
    for name in ("MortarDiscretization", "ActiveSet", "CondensedSystem", "Elasticity",
                 "GoalErrors", "InvariantCheck", "MshFile", "Report"):
        if name not in classes:
            failures.append(f"the class {name}")

    for failure in failures:
        print(f"FAILED: {failure}")
    sys.exit(bool(failures))


if __name__ == "__main__":
    main()
