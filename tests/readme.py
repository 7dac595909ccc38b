#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command of the pages runs, every relative link leads somewhere, and
every test is in the list of tests/README.md.

Pages are all README.md of the repository, and CONTRIBUTING.md. Commands are the
lines of their code blocks and the code in their text that begin with one of STARTS; a backslash at
the end of a line joins it with the next one. Each is run once, however many
pages have it, in the top folder, as it stands there, or in the short form that
SHORT gives it, or by the test that ELSEWHERE names; a command that no page has
any longer is an error as well. Those that need a program that is not installed
are named and not run.

Links are checked with their anchors: these are the headings of the page, in
lower case, hyphens for blanks, without punctuation. The front page is kept to
MAX_LINES of 100 characters, but for tables, and all README.md together to
MAX_WORDS: a page grows at the expense of another one.

Usage: readme.py [--pages] CONTACT PARAMETERS MESHES

With --pages, no command is run.
"""

import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.parse

MAX_LINES = 160
MAX_WORDS = 32000

STARTS = ("./run", "gmsh ", "mpirun -", "build/contact", "meshes/convert.py ", "cmake",
          "pvpython", "apt-get", "ctest", "tests/reference_table.py ",
          "tests/fuzz/", "tests/oracle/")

# In the text, the name of a file and no command.
FILE = re.compile(r"tests/\w+/\w+\.(py|sh|cc)")

# On one mesh, whose values are not those that the case is compared with.
COARSE = ('--set "Refinement/Levels=1" --set "Probes/References=" '
          '--set "Probes/Tolerances="')

# The command that is run for it: quick, and with a case in place of FILE.
SHORT = {
    './run parameters/nested.prm --set "Refinement/Levels=5"':
        './run parameters/nested.prm --set "Refinement/Levels=3"',
    "mpirun -np N build/contact case.prm":
        'mpirun -np 2 build/contact parameters/nested.prm ' + COARSE,
    './run FILE --set "Mesh/File=..."':
        './run parameters/ssnp154_a.prm --set "Mesh/File=$PWD/meshes/ssnp154.msh"',
    "mpirun -np 2 build/contact parameters/nested_friction.prm":
        'mpirun -np 2 build/contact parameters/nested_friction.prm ' + COARSE,
    "./run parameters/ssnp154_[a-h].prm --quiet":
        "./run parameters/ssnp154_[ah].prm --quiet",
    "./run parameters/examples/lug.prm":
        './run parameters/examples/lug.prm --set "Mesh/Size=6" '
        '--set "Mesh/Sizes=Bore: 3, Shank: 3"',
    "./run price CASE.prm": "./run price parameters/nested.prm --seconds 1",
    "./run benchmark": "MODELINGS=a REPETITIONS=1 ./run benchmark",
    "./run effects": "./run effects tied --repetitions 1",
    "./run estimates": "./run estimates verification/hertz",
    "./run requests": "./run requests verification/nested_spheres_quadratic",
    "./run effectivity": "./run effectivity ring",
    "./run yardstick":
        "./run yardstick CHOLMOD --repetitions 1 --refinements 1",
    "./run scaling": "./run scaling 500",
    "./run scaling space": "./run scaling space --levels 0 --ranks ''",
    "./run scaling processes":
        "./run scaling processes --levels 1,1 --ranks 1,2 --repeat 1",
    "./run adaptive": "./run adaptive 500",
    "./run oscillation": "./run oscillation mortar block",
    "./run hard --materials": "./run hard --materials one_element",
    "./run gallery":
        "./run gallery --coarse --examples seal --pictures $SCRATCH",
    "cmake --install build --strip --prefix ~/.local":
        "cmake --install build --strip --prefix $SCRATCH",
    "tests/fuzz/scenes.py --number 600 build/contact":
        "tests/fuzz/scenes.py --first 5 --number 1 --output $SCRATCH "
        "build/contact",
    "tests/fuzz/damaged.py --number 500 build/contact":
        "tests/fuzz/damaged.py --number 4 --output $SCRATCH build/contact",
    "tests/fuzz/damaged.py --json --number 220 build/contact":
        "tests/fuzz/damaged.py --json --number 4 --output $SCRATCH build/contact",
    "tests/fuzz/scenes.py --only 137 build/contact":
        "tests/fuzz/scenes.py --only 137 --output $SCRATCH build/contact",
    "tests/fuzz/space_scenes.py --only 7 build/contact":
        "tests/fuzz/space_scenes.py --only 7 --output $SCRATCH build/contact",
    "tests/fuzz/damaged_space.py --only 7 build/contact":
        "tests/fuzz/damaged_space.py --only 7 --output $SCRATCH build/contact",
    "tests/fuzz/damaged_tetrahedra.py --only 7 build/contact":
        "tests/fuzz/damaged_tetrahedra.py --only 7 --output $SCRATCH build/contact",
    "tests/fuzz/damaged.py --only 12 build/contact":
        "tests/fuzz/damaged.py --only 12 --output $SCRATCH build/contact",
    "tests/oracle/oracle.py --kind wedge --seed 7 --count 1 --keep /tmp/x "
    "build/contact":
        "tests/oracle/oracle.py --kind wedge --seed 7 --count 1 --keep $SCRATCH "
        "build/contact",
    "cmake --build build": "cmake --build build --target contact",
    "ctest -R NAME": "cd build && ctest -R modeling_h",
}

ELSEWHERE = {
    "./run plot parameters/ssnp154_d.prm": "program/plot",
    "./run plot mine.prm": "program/plot",
    "./run plot CASE": "program/plot",
    "./run plot": "program/plot",
    "./run test": "the suite itself",
    "./run test all": "the suite itself",
    "./run package": "a second build",
    "cmake --install build --prefix DIR": "program/library",
    "cmake --build build --target gallery_entry": "program/gallery_entry",
    "./run build-costs": "a second build",
    "cmake -S . -B build -DDEAL_II_DIR=DIR": "./run, where deal.II is installed",
    "./run mine.prm": "program/readme_case",
    "./run drag.prm": "program/readme_case",
    "ctest -R half_plane": "tests/half_plane", "ctest -R locking": "tests/locking",
    "ctest -R restart": "program/restart",
    "ctest -R invariance": "program/invariance",
    "./run parameters/verification/*.prm --quiet": "modelings/verification",
    "./run hard": "program/hard",
    "./run hard --required": "program/hard",
    "./run hard --space": "program/hard",
    "apt-get install python3-h5py python3-meshio": "./run test",
    "./run fuzz": "program/quick_fuzz",
    "./run fuzz --quick": "program/quick_fuzz",
    "tests/fuzz/damaged.py --json build/contact": "its run with --number 220",
    "./run oracle": "program/oracle_quick",
    "./run oracle --count 68 --kind stack,carried": "program/oracle_quick",
    "./run oracle --space --count 200": "program/oracle_quick",
    "./run oracle --tetrahedra --count 150": "program/oracle_quick",
    "tests/oracle/test_fem.py": "program/oracle_quick",
    "tests/oracle/test_laws.py": "program/oracle_quick",
    "tests/oracle/test_space.py": "program/oracle_quick",
    "cmake --build build --target mesh": "nothing: it writes into meshes",
    "cmake -S . -B build/sanitize -G Ninja -DCMAKE_BUILD_TYPE=Release "
    '"-DCMAKE_CXX_FLAGS_RELEASE=-O1 -g1 -fno-omit-frame-pointer" '
    '"-DCMAKE_CXX_FLAGS=-fsanitize=address,undefined '
    '-fno-sanitize-recover=undefined -D_GLIBCXX_ASSERTIONS"':
        "nothing: a second build",
    "cmake --build build/sanitize --target contact": "nothing: a second build",
    "tests/fuzz/fuzz.py --scenes 60 --damaged 200 --limit 300 "
    "build/sanitize/contact": "nothing: it takes that build",
    "./run study": "program/quick_study",
    "./run study --peers": "nothing: it installs other programs",
    "./run study --peers --quick": "nothing: it installs other programs",
    "./run study --peers-in-space": "nothing: it installs other programs",
    "./run study --quick": "program/quick_study",
    "./run study --problem hertz": "program/quick_study",
    "meshes/convert.py [--bodies NAME,NAME] IN OUT.msh": "program/convert",
    "meshes/convert.py --bodies Block,Cylinder ssnp154a.mmed aster.msh":
        "program/convert, with a file of its own",
    "./run tests/reference/published/[a-g].prm --set Mesh/File=$PWD/aster.msh":
        "program/convert, with a file of its own",
    "meshes/convert.py deck.inp deck.msh": "program/abaqus",
    "./run deck.prm": "program/abaqus",
    "ctest -R convert": "program/convert",
    "tests/reference_table.py build": "modelings/reference_mesh, its input",
}

NEEDS = {"./run gallery": "xvfb-run", "./run doxygen": "doxygen",
         "pvpython": "pvpython"}


def find_pages(root: pathlib.Path) -> dict[str, str]:
    """Path below the repository and text of each, the front page first."""
    found = [page.relative_to(root)
             for page in (*root.rglob("README.md"), root / "CONTRIBUTING.md")]
    return {str(page): (root / page).read_text()
            for page in sorted(found, key=lambda page: (
                len(page.parts), page.name != "README.md", page))
            if page.parts[0] not in ("build", "output")}


def commands(page: str) -> list[str]:
    """Those of the blocks without a language, without the words beside them,
    and of the text."""
    found, fence = [], None
    for line in re.sub(r"\\\n\s*", "", page).splitlines():
        if line.startswith("```"):
            fence = line if fence is None else None
        elif fence == "```":
            found.append(line.split("   ")[0].strip())
        elif fence is None:
            found += [code for code in re.findall(r"`([^`]+)`", line)
                      if not FILE.fullmatch(code)]
    return list(dict.fromkeys(c for c in found if c.startswith(STARTS)))


def prose(page: str) -> str:
    """The page without its blocks of code."""
    return re.sub(r"^```.*?^```", "", page, flags=re.MULTILINE | re.DOTALL)


def anchors(page: str) -> set[str]:
    headings = re.findall(r"^#+ (.*)$", prose(page), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", h.lower()).replace(" ", "-") for h in headings}


def broken_links(pages: dict[str, str], root: pathlib.Path) -> list[str]:
    """Links of Markdown to files, folders or anchors that do not exist."""
    broken = []
    for page, text in pages.items():
        for link in re.findall(r"\]\(([^)\s]+)\)", prose(text)):
            path, _, anchor = urllib.parse.unquote(link).partition("#")
            if re.match(r"\w+:", path):
                continue
            target = (root / page).parent / path if path else root / page
            if not target.exists():
                broken.append(f"{page}: the link {link} leads to no file")
            elif anchor and anchor not in anchors(target.read_text()):
                broken.append(f"{page}: the link {link} leads to no heading")
    return broken


def excess(pages: dict[str, str]) -> list[str]:
    """What the front page, and all README.md together, have beyond their size."""
    lines = pages["README.md"].splitlines()
    failures = [f"README.md has {len(lines)} lines: {MAX_LINES} at most"
                ] if len(lines) > MAX_LINES else []
    words = sum(len(text.split()) for page, text in pages.items()
                if page.endswith("README.md"))
    failures += [f"the pages have {words} words: {MAX_WORDS} at most"
                 ] if words > MAX_WORDS else []
    return failures + [
        f"README.md, line {i}: {len(line)} characters, 100 at most"
        for i, line in enumerate(lines, 1)
        if len(line) > 100 and not line.startswith("|")]


def unlisted_tests(page: str, directory: pathlib.Path) -> list[str]:
    listed = subprocess.run(["ctest", "-N"], cwd=directory, text=True,
                            capture_output=True, check=True).stdout
    names = {re.sub(r"^tests/|\.\w+$|_(published|newton_geometry|small_strain)$",
                    "", name) for name in re.findall(r"#\d+: (\S+)", listed)}
    # Newer versions of deal.II build what tests need by tests.
    return sorted(name for name in names if f"`{name}`" not in page and
                  not name.startswith("test_dependency/"))


def cpu_seconds() -> float:
    """Of all commands so far."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def main() -> int:
    pages_only = sys.argv[1] == "--pages"
    contact, parameters = map(pathlib.Path, sys.argv[1 + pages_only:][:2])
    contact, root = contact.resolve(), parameters.resolve().parent
    pages = find_pages(root)
    failures = broken_links(pages, root) + excess(pages)
    failures += [f"tests/README.md does not list the test {name}"
                 for name in unlisted_tests(pages["tests/README.md"],
                                            contact.parent)]
    found = list(dict.fromkeys(command for page in pages.values()
                               for command in commands(page)))
    print(f"{len(pages)} pages, {len(found)} commands")
    failures += [f"no page has the command {command} any longer: remove it here"
                 for command in (SHORT | ELSEWHERE) if command not in found]
    if pages_only:
        found = []
    elif contact.parent != root / "build":
        found = []
        print("NOT RUN: the commands take the program in build/")

    environment = os.environ | {"SCRATCH": tempfile.mkdtemp()}
    for command in found:
        needed = next((program for start, program in NEEDS.items()
                       if command.startswith(start)), None)
        if command in ELSEWHERE:
            print(f"{command}: {ELSEWHERE[command]}")
            continue
        if needed and not shutil.which(needed):
            print(f"{command}: NOT RUN, needs {needed}")
            continue
        start = time.monotonic()
        used = cpu_seconds()
        run = subprocess.run(SHORT.get(command, command), shell=True, cwd=root,
                             env=environment, text=True, capture_output=True)
        print(f"{command}: exit status {run.returncode}, "
              f"{time.monotonic() - start:.1f} s, "
              f"{cpu_seconds() - used:.1f} of the CPU", flush=True)
        if run.returncode:
            failures.append(f"{command}\n{run.stdout[-2000:]}{run.stderr[-2000:]}")
    shutil.rmtree(environment["SCRATCH"])
    for failure in failures:
        print(f"FAILED: {failure}", file=sys.stderr)
    return bool(failures)


if __name__ == "__main__":
    sys.exit(main())
