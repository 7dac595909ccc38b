#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command in README runs, and every test is in its list.

Commands are the lines of its code blocks and the code in its text that begin
with one of STARTS. Each is run in the directory of README as it stands there,
or in the short form that SHORT gives it, or by the test that ELSEWHERE names; a
command that README does not have any longer is an error as well. What needs a
program that is not installed is named and not run.

Usage: readme.py CONTACT PARAMETERS MESHES
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

STARTS = ("./run", "gmsh ", "mpirun -", "build/contact", "meshes/convert.py ", "cmake",
          "pvpython", "apt-get", "ctest", "tests/reference_table.py ",
          "tests/fuzz/scenes.py ", "tests/fuzz/damaged.py ")

# What it stands for with the case that README uses beside it.
SHORT = {
    './run parameters/nested.prm --set "Refinement/Levels=5"':
        './run parameters/nested.prm --set "Refinement/Levels=3"',
    "mpirun -np N build/contact case.prm":
        "mpirun -np 2 build/contact parameters/nested.prm",
    './run FILE --set "Mesh/File=..."':
        './run parameters/ssnp154_a.prm --set "Mesh/File=$PWD/meshes/ssnp154.msh"',
    "./run benchmark": "REPETITIONS=1 ./run benchmark",
    "./run effects": "./run effects tied --repetitions 1",
    "./run yardstick":
        "./run yardstick CHOLMOD --repetitions 1 --refinements 2",
    "./run scaling": "./run scaling 2000",
    "./run adaptive": "./run adaptive 2000",
    "./run oscillation": "./run oscillation mortar block",
    "./run gallery": "./run gallery --pictures $SCRATCH",
    "cmake --install build --strip --prefix ~/.local":
        "cmake --install build --strip --prefix $SCRATCH",
    "tests/fuzz/scenes.py --number 600 build/contact":
        "tests/fuzz/scenes.py --number 2 --output $SCRATCH build/contact",
    "tests/fuzz/damaged.py --number 500 build/contact":
        "tests/fuzz/damaged.py --number 4 --output $SCRATCH build/contact",
    "tests/fuzz/damaged.py --json --number 220 build/contact":
        "tests/fuzz/damaged.py --json --number 4 --output $SCRATCH build/contact",
    "cmake --build build": "cmake --build build --target contact",
    "ctest -R NAME": "cd build && ctest -R formula",
}

ELSEWHERE = {
    "./run test": "the suite itself",
    "cmake -S . -B build -DDEAL_II_DIR=DIR": "./run, where deal.II is installed",
    "gmsh -2 -format msh41 -o mine.msh mine.geo": "program/readme_case",
    "./run mine.prm": "program/readme_case",
    "ctest -R half_plane": "tests/half_plane", "ctest -R locking": "tests/locking",
    "ctest -R restart": "program/restart",
    "ctest -R invariance": "program/invariance",
    "./run parameters/verification/*.prm --quiet": "modelings/verification",
    "./run hard": "program/hard",
    "apt-get install python3-h5py python3-meshio": "./run test",
    "./run fuzz": "program/quick_fuzz",
    "./run oracle": "program/oracle_quick",
    "./run study": "program/quick_study",
    "./run study --quick": "program/quick_study",
    "./run study --problem hertz": "program/quick_study",
    "meshes/convert.py [--bodies NAME,NAME] IN OUT.msh": "program/convert",
    "meshes/convert.py --bodies Block,Cylinder ssnp154a.mmed aster.msh":
        "program/convert, with a file of its own",
    "./run tests/reference/published/[a-g].prm --set Mesh/File=$PWD/aster.msh":
        "program/convert, with a file of its own",
    "ctest -R convert": "program/convert",
    "tests/reference_table.py build": "modelings/reference_mesh, its input",
}

NEEDS = {"./run gallery": "xvfb-run", "./run doxygen": "doxygen",
         "pvpython": "pvpython"}


def commands(readme: str) -> list[str]:
    """Those of the blocks without a language, without what is said beside them,
    and of the text."""
    found, fence = [], None
    for line in readme.splitlines():
        if line.startswith("```"):
            fence = line if fence is None else None
        elif fence == "```":
            found.append(line.split("   ")[0].strip())
        elif fence is None:
            found += re.findall(r"`([^`]+)`", line)
    return list(dict.fromkeys(c for c in found if c.startswith(STARTS)))


def unlisted_tests(readme: str, directory: pathlib.Path) -> list[str]:
    listed = subprocess.run(["ctest", "-N"], cwd=directory, text=True,
                            capture_output=True, check=True).stdout
    names = {re.sub(r"^tests/|\.\w+$|_(published|newton_geometry|small_strain)$",
                    "", name) for name in re.findall(r"#\d+: (\S+)", listed)}
    return sorted(name for name in names if f"`{name}`" not in readme)


def main() -> int:
    contact = pathlib.Path(sys.argv[1]).resolve()
    root = pathlib.Path(sys.argv[2]).resolve().parent
    readme = (root / "README.md").read_text()
    failures = [f"README does not list the test {name}"
                for name in unlisted_tests(readme, contact.parent)]
    found = commands(readme)
    failures += [f"README no longer has the command {command}: remove it here"
                 for command in (SHORT | ELSEWHERE) if command not in found]
    if contact.parent != root / "build":
        found = []
        print("NOT RUN: the commands of README take the program in build/")

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
        run = subprocess.run(SHORT.get(command, command), shell=True, cwd=root,
                             env=environment, text=True, capture_output=True)
        print(f"{command}: exit status {run.returncode}, "
              f"{time.monotonic() - start:.1f} s", flush=True)
        if run.returncode:
            failures.append(f"{command}\n{run.stdout[-2000:]}{run.stderr[-2000:]}")
    shutil.rmtree(environment["SCRATCH"])
    for failure in failures:
        print(f"FAILED: {failure}", file=sys.stderr)
    return bool(failures)


if __name__ == "__main__":
    sys.exit(main())
