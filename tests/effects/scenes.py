# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two blocks that touch, or one, as scenes of the program; what a run of it
costs and counts."""

import json
import os
import pathlib
import resource
import subprocess
import time

ENVIRONMENT = {name: "1" for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS",
                                      "DEAL_II_NUM_THREADS")}
# Settings of MPI for one process: the program's own, for plain programs, too.
ENVIRONMENT.update({"OMPI_MCA_ess_singleton_isolated": "1",
                    "OMPI_MCA_orte_create_session_dirs": "0",
                    "OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self",
                    "OMPI_MCA_osc": "^ucx"})


# One block, held below and pressed above.
HELD_BLOCK = {"Solids/Young's modulus": "Block: 210000",
              "Solids/Poisson's ratio": "Block: 0.3",
              "Solids/Kinematics": "small strain",
              "Boundary conditions/Displacement x": "Base: 0",
              "Boundary conditions/Displacement y": "Base: 0",
              "Boundary conditions/Resultant force y": "Top: -1"}


class MshFile:
    """Structured blocks of quadrangles in MSH format 2.2."""

    def __init__(self):
        self.names, self.nodes, self.elements = [], [], []

    def group(self, dimension, name):
        self.names.append((dimension, len(self.names) + 1, name))
        return len(self.names)

    def block(self, body, x, y, n, groups, points=()):
        """[x0, x1] x [y0, y1] in n[0] x n[1] cells; groups: names of its
        boundaries below, right, above and left; points: (name, i, j) of grid
        points."""
        first = len(self.nodes) + 1
        columns, rows = n[0] + 1, n[1] + 1
        for j in range(rows):
            for i in range(columns):
                self.nodes.append((x[0] + (x[1] - x[0]) * i / n[0],
                                   y[0] + (y[1] - y[0]) * j / n[1]))

        def node(i, j):
            return first + j * columns + i

        sides = ([(node(i, 0), node(i + 1, 0)) for i in range(n[0])],
                 [(node(n[0], j), node(n[0], j + 1)) for j in range(n[1])],
                 [(node(i, n[1]), node(i + 1, n[1])) for i in range(n[0])],
                 [(node(0, j), node(0, j + 1)) for j in range(n[1])])
        for name, side in zip(groups, sides):
            if name:
                number = self.group(1, name)
                self.elements += [(1, number, edge) for edge in side]
        for name, i, j in points:
            self.elements.append((15, self.group(0, name), (node(i, j),)))
        number = self.group(2, body)
        self.elements += [
            (3, number, (node(i, j), node(i + 1, j), node(i + 1, j + 1),
                         node(i, j + 1)))
            for j in range(n[1]) for i in range(n[0])]

    def write(self, path):
        with open(path, "w") as out:
            out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
            out.write("$PhysicalNames\n%d\n" % len(self.names))
            for name in self.names:
                out.write('%d %d "%s"\n' % name)
            out.write("$EndPhysicalNames\n$Nodes\n%d\n" % len(self.nodes))
            for k, (x, y) in enumerate(self.nodes):
                out.write("%d %.17g %.17g 0\n" % (k + 1, x, y))
            out.write("$EndNodes\n$Elements\n%d\n" % len(self.elements))
            for k, (kind, number, nodes) in enumerate(self.elements):
                out.write("%d %d 2 %d %d %s\n" % (
                    k + 1, kind, number, number, " ".join(map(str, nodes))))
            out.write("$EndElements\n")


def write_block(path, n):
    """The unit square, Base (boundary 1) below and Top (boundary 2) above."""
    mesh = MshFile()
    mesh.block("Block", (0, 1), (0, 1), (n, n), ("Base", None, "Top", None),
               [("Corner", n, n)])
    # GridIn knows boundaries by their numbers alone.
    assert [name[1] for name in mesh.names if name[0] == 1] == [1, 2]
    mesh.write(path)


def write_blocks(path, n):
    """A block on a wider one, with meshes that do not match."""
    mesh = MshFile()
    mesh.block("Lower", (-1, 3), (-2, 0), (2 * n, n),
               ("Base", None, "Master", None))
    mesh.block("Upper", (0, 2), (0, 2), (n + 1, n + 1),
               ("Slave", None, "Top", None),
               [("Foot", 0, 0), ("Head", n + 1, n + 1)])
    mesh.write(path)


# Everything is prescribed, so that it stands without contact as well.
BLOCKS = {
    "Solids/Young's modulus": "Lower: 210000, Upper: 70000",
    "Solids/Poisson's ratio": "Lower: 0.3, Upper: 0.3",
    "Solids/Kinematics": "small strain",
    "Boundary conditions/Displacement x": "Base: 0, Top: 0.0005",
    "Boundary conditions/Displacement y": "Base: 0, Top: -0.002",
    "Solution/Increments": "1",
    "Solution/Geometry": "undeformed",
    "Probes/Probes": "head: displacement y, Head",
    "Probes/Errors": "none",
}
CONTACT = {"Contact/Slave": "Slave", "Contact/Master": "Master",
           "Contact/Discretization": "mortar"}

# More of the two blocks, which touch unless it says so: a part of the upper one
# yields; rubber; cells that bend; a top that moves as before, as a rigid body;
# the upper block on a rigid plane, one that moves, one under a force; an upper
# block that swells; one that is longer than it is drawn.
PLASTIC = {"Solids/Material": "Lower: elastic-plastic, Upper: elastic-plastic",
           "Solids/Yield stress": "Lower: 60, Upper: 60",
           "Solids/Hardening modulus": "Lower: 2000, Upper: 700"}
NEO_HOOKEAN = {"Solids/Material": "Lower: neo-Hookean, Upper: neo-Hookean"}
MOONEY_RIVLIN = {
    "Solids/Material": "Lower: Mooney-Rivlin, Upper: Mooney-Rivlin",
    "Solids/Mooney-Rivlin constant": "Lower: 10000, Upper: 3000"}
MODES = {"Solids/Incompatible modes": "Lower, Upper"}
RIGID = {"Boundary conditions/Rigid": "Top: Head",
         "Boundary conditions/Rotation z": "Top: 0"}
OBSTACLE = {"Contact/Slave": "Slave", "Contact/Discretization": "mortar",
            "Contact/Obstacle": "half plane: 0, 0, 0, 1"}
MOVING = {**OBSTACLE, "Contact/Obstacle motion": "x: 5e-4*t; y: -2e-4*t"}
PUSHED = {**OBSTACLE, "Contact/Obstacle force": "y: 150*t"}
HOT = {"Solids/Thermal strain": "Upper: 1e-4*t"}
OVERLAP = {"Contact/Interference": "1e-3*t"}


class Run:
    """What a run has left: its exit status, summary, and what it cost."""

    def __init__(self, status, summary, wall, cpu, memory):
        self.status, self.summary = status, summary
        self.wall, self.cpu, self.memory = wall, cpu, memory

    @property
    def counters(self):
        return self.summary["counters"]

    def cheaper(self, other):
        """The smaller of each cost."""
        return Run(self.status, self.summary, min(self.wall, other.wall),
                   min(self.cpu, other.cpu), min(self.memory, other.memory))


def measure(command, directory):
    """Wall and CPU time [s] and peak memory [MB] of a command."""
    with open(pathlib.Path(directory) / "log", "w") as log:
        begin = time.perf_counter()
        process = subprocess.Popen(command, stdout=log, stderr=log,
                                   cwd=directory,
                                   env={**os.environ, **ENVIRONMENT})
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - begin
    process.returncode = os.waitstatus_to_exitcode(status)
    return Run(process.returncode, None, wall, usage.ru_utime + usage.ru_stime,
               usage.ru_maxrss / 1024)


def run(contact, mesh, entries, directory, screen="none"):
    """Run the program on a scene, given by its entries."""
    directory = pathlib.Path(directory)
    case = directory / "scene.prm"
    case.write_text("subsection Mesh\n  set File = %s\nend\n" % mesh)
    command = [str(contact), str(case)]
    for entry, value in {"Output/Screen": screen, **entries}.items():
        command += ["--set", "%s=%s" % (entry, value)]
    result = measure(command, directory)
    summary = directory / "output" / "scene" / "summary.json"
    if result.status in (0, 1, 3):
        result.summary = json.loads(summary.read_text())
    return result


def log(directory):
    return (pathlib.Path(directory) / "log").read_text()
