#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The library as others have it: the build is installed, tests/library is built
against what was installed, and its two blocks, with an elasticity and a mesh of
their own, have the forces of the program on the same mesh.

Usage: library.py CONTACT PARAMETERS MESHES BUILD
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from block_scenes import Mesh, box, check, failures, run
from volume_scenes import Volumes

build = pathlib.Path(sys.argv[4])
source = pathlib.Path(__file__).resolve().parent / "library"
prefix, own = pathlib.Path("prefix").resolve(), pathlib.Path("own").resolve()
GAP = 0.001  # between the blocks of two_blocks.cc
DIGITS = 1e-6
# What the program does more than the plain Newton's method of the example is to
# search the active set in the linearised problem.
MORE_STEPS = 4

cmake = shutil.which("cmake")
if cmake is None:
    print("skipped: no cmake")
    sys.exit(0)


def call(*command):
    result = subprocess.run([str(c) for c in command], capture_output=True,
                            text=True)
    if result.returncode:
        print(result.stdout[-5000:], result.stderr[-5000:])
        sys.exit(f"FAILED: {' '.join(map(str, command))}")
    return result.stdout


def cached(name):
    text = (build / "CMakeCache.txt").read_text()
    found = re.search(rf"^{name}:\w+=(.*)$", text, re.MULTILINE)
    return found[1] if found else ""


for directory in (prefix, own):
    shutil.rmtree(directory, ignore_errors=True)
call(cmake, "--install", build, "--prefix", prefix, "--component", "library")
call(cmake, "-S", source, "-B", own, f"-DCMAKE_PREFIX_PATH={prefix}",
     "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -g0",
     f"-Ddeal.II_DIR={cached('deal.II_DIR')}")
call(cmake, "--build", own)
commands = (own / "CMakeFiles/two_blocks.dir/flags.make").read_text()
check("it is built without the repository's headers",
      str(source.parent.parent / "include") not in commands and
      str(prefix) in commands)


def cuboid(lower, upper):
    return lambda *s: tuple(a + t * (b - a)
                            for a, b, t in zip(lower, upper, s))


def mesh_2d():
    mesh = Mesh()
    mesh.block("Foundation", 8, 4, box(-2, -2, 2, 0),
               {"bottom": "Base", "top": "Ground"})
    mesh.block("Block", 5, 3, box(-1, GAP, 1, 1 + GAP),
               {"bottom": "Sole", "top": "Head"})
    mesh.write("blocks_2d")
    return "Sole", "Ground", "Base", "Head"


def mesh_3d():
    mesh = Volumes()
    mesh.block("Foundation", (8, 8, 4), cuboid((-2, -2, -2), (2, 2, 0)))
    mesh.block("Block", (5, 5, 3),
               cuboid((-1, -1, GAP), (1, 1, 1 + GAP)))
    mesh.write("blocks_3d")
    return "Block_z0", "Foundation_z1", "Foundation_z0", "Block_z1"


for dim, make_mesh in ((2, mesh_2d), (3, mesh_3d)):
    sole, ground, base, head = make_mesh()
    name, axes = f"blocks_{dim}d", "xyz"[:dim]
    moved = {"x": 0.02, axes[-1]: -0.05}
    entries = {
        "Mesh/File": f"{name}.msh",
        "Solids/Young's modulus": "Foundation: 70000, Block: 210000",
        "Solids/Poisson's ratio": "Foundation: 0.3, Block: 0.3",
        "Solids/Kinematics": "small strain",
        "Solids/Dilatation": "full",
        "Contact/Slave": sole,
        "Contact/Master": ground,
        "Contact/Friction coefficient": "0.3",
        "Solution/Geometry": "undeformed",
        "Solution/Increments": "1",
        "Probes/Probes": "; ".join(
            f"f{a}: contact force {a}, {sole}" for a in axes)}
    for a in axes:
        entries[f"Boundary conditions/Displacement {a}"] = (
            f"{base}: 0, {head}: {moved.get(a, 0)}")
    status, said, summary = run(name, entries)
    check(f"the program converges in {dim}-D", status == 0, said)
    said = subprocess.run(
        [own / "two_blocks", str(dim)], capture_output=True, text=True,
        env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    check(f"the library's does in {dim}-D", said.returncode == 0,
          said.stdout + said.stderr)
    if not summary or said.returncode:
        continue
    force = [float(f) for f in
             re.search(r"^force (.*)$", said.stdout, re.MULTILINE)[1].split()]
    values = {p["name"]: p["value"] for p in summary["probes"]}
    of_program = [values[f"f{a}"] for a in axes]
    largest = max(map(abs, of_program))
    difference = max(abs(abs(a) - abs(b)) for a, b in zip(force, of_program))
    check(f"forces in {dim}-D", difference < DIGITS * largest,
          f"{force} {of_program}")
    steps, of_steps = said.stdout.count("step ") - 1, sum(
        i["newton_iterations"] for i in summary["increments"])
    check(f"Newton steps in {dim}-D", steps <= of_steps + MORE_STEPS,
          f"{steps}, the program {of_steps}")
sys.exit(len(failures) > 0)
