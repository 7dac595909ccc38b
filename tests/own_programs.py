# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two blocks of the programs in tests/library, run by the program itself
and compared with theirs, for the scripts beside this one."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from block_scenes import Mesh, box, check, run
from volume_scenes import Volumes

GAP = 0.001  # between the blocks
DIGITS = 1e-6
# The program searches the active set in the linearised problem, within a step.
MORE_STEPS = 1
library = pathlib.Path(__file__).resolve().parent / "library"


def call(*command):
    result = subprocess.run([str(c) for c in command], capture_output=True,
                            text=True)
    if result.returncode:
        print(result.stdout[-5000:], result.stderr[-5000:])
        sys.exit(f"FAILED: {' '.join(map(str, command))}")
    return result.stdout


def build(source, build_of_program, target, *options):
    """Configure and build a program in the directory 'own'."""
    cmake = shutil.which("cmake")
    if cmake is None:
        print("skipped: no cmake")
        sys.exit(0)
    cache = (build_of_program / "CMakeCache.txt").read_text()
    deal_ii = re.search(r"^deal.II_DIR:\w+=(.*)$", cache, re.MULTILINE)[1]
    shutil.rmtree("own", ignore_errors=True)
    call(cmake, "-G", "Ninja", "-S", source, "-B", "own",
         f"-Ddeal.II_DIR={deal_ii}",
         "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -g0",
         *options)
    call(cmake, "--build", "own", "--parallel", "2")
    return pathlib.Path("own").resolve() / target


def cuboid(lower, upper):
    return lambda *s: tuple(a + t * (b - a)
                            for a, b, t in zip(lower, upper, s))


def mesh_2d(name):
    mesh = Mesh()
    mesh.block("Foundation", 8, 4, box(-2, -2, 2, 0),
               {"bottom": "Base", "top": "Ground"})
    mesh.block("Block", 5, 3, box(-1, GAP, 1, 1 + GAP),
               {"bottom": "Sole", "top": "Head"})
    mesh.write(name)
    return "Sole", "Ground", "Base", "Head"


def mesh_3d(name):
    mesh = Volumes()
    mesh.block("Foundation", (8, 8, 4), cuboid((-2, -2, -2), (2, 2, 0)))
    mesh.block("Block", (5, 5, 3), cuboid((-1, -1, GAP), (1, 1, 1 + GAP)))
    mesh.write(name)
    return "Block_z0", "Foundation_z1", "Foundation_z0", "Block_z1"


def compare(executable, dim, increments, histories=None):
    """Run both; their last forces and numbers of Newton steps."""
    name, axes = f"blocks_{dim}d", "xyz"[:dim]
    sole, ground, base, head = {2: mesh_2d, 3: mesh_3d}[dim](name)
    moved = {"x": 0.02, axes[-1]: -0.05}
    entries = {
        "Mesh/File": f"{name}.msh",
        "Solids/Young's modulus": "Foundation: 70000, Block: 210000",
        "Solids/Poisson's ratio": "Foundation: 0.3, Block: 0.3",
        "Solids/Kinematics": "small strain",
        "Contact/Slave": sole,
        "Contact/Master": ground,
        "Contact/Friction coefficient": "0.3",
        "Solution/Geometry": "undeformed",
        "Solution/Increments": str(increments),
        "Probes/Probes": "; ".join(
            f"f{a}: contact force {a}, {sole}" for a in axes)}
    for a in axes:
        entries[f"Boundary conditions/Displacement {a}"] = (
            f"{base}: 0, {head}: {moved.get(a, 0)}")
    if histories:
        entries["Boundary conditions/Histories"] = histories
    status, said, summary = run(name, entries)
    check(f"the program converges in {dim}-D", status == 0, said)
    other = subprocess.run([executable, str(dim)], capture_output=True,
                           text=True,
                           env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    check(f"{executable.name} converges in {dim}-D", other.returncode == 0,
          other.stdout + other.stderr if other.returncode else "")
    if not summary or other.returncode:
        return
    force = [float(f) for f in
             re.findall(r"force (.*)", other.stdout)[-1].split()]
    values = {p["name"]: p["value"] for p in summary["probes"]}
    of_program = [values[f"f{a}"] for a in axes]
    largest = max(map(abs, of_program))
    difference = max(abs(a - b) for a, b in zip(force, of_program))
    check(f"forces in {dim}-D", difference < DIGITS * largest,
          f"{force} {of_program}")
    steps = other.stdout.count("step ") - increments  # and one check each
    of_steps = sum(i["newton_iterations"] for i in summary["increments"])
    check(f"Newton steps in {dim}-D",
          steps <= of_steps + MORE_STEPS * increments,
          f"{steps}, the program {of_steps}")
