"""Runs the program and reads what it has written."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import base64
import csv
import json
import os
import re
import resource
import signal
import struct
import subprocess
import time
import zlib

import numpy as np
from scipy.spatial import cKDTree

MEMORY = 1500 << 20
# Of CPU time; of the clock where the machine is busy.
SECONDS = 60
PATIENCE = 900
SINGLE = 1.2e-7


class Run:
    """One run: exit status (None: it hung), what it said, seconds, results."""

    def __init__(self, status, said, seconds, directory):
        self.status = status
        self.said = said
        self.seconds = seconds
        self.directory = directory / "output" / "case"
        self.summary = None
        try:
            self.summary = json.loads((self.directory / "summary.json")
                                      .read_text())
        except (OSError, ValueError):
            pass

    @property
    def megabytes(self):
        return (self.summary or {}).get("peak_memory_mb", 0)

    @property
    def steps(self):
        return sum(i["newton_iterations"] for i in
                   (self.summary or {}).get("increments", []))

    @property
    def message(self):
        text = (self.summary or {}).get("message") or self.said
        return " ".join(text.split())[:300]


def run(binary, directory, ranks=1):
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1",
                       OMP_NUM_THREADS="1",
                       OMPI_ALLOW_RUN_AS_ROOT="1",
                       OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_rmaps_base_oversubscribe="1",
                       OMPI_MCA_mpi_yield_when_idle="1")
    command = [str(binary), "case.prm"]
    if ranks > 1:
        command = ["mpirun", "-np", str(ranks)] + command

    def limits():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
        if ranks == 1:
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    start = time.monotonic()
    try:
        done = subprocess.run(command, cwd=directory, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=PATIENCE,
                              preexec_fn=limits, env=environment)
        status, said = done.returncode, done.stdout.decode("utf-8", "replace")
        if status in (-signal.SIGXCPU, -signal.SIGKILL):
            status, said = None, "more than %d s of CPU time" % SECONDS
    except subprocess.TimeoutExpired:
        status, said = None, "more than %d s" % PATIENCE
    return Run(status, said, time.monotonic() - start, directory)


def vertex_displacements(increment, n, axes="xy"):
    u = np.full((n, len(axes)), np.nan)
    for k in range(n):
        for d, axis in enumerate(axes):
            value = increment["probes"].get("%s%d" % (axis, k))
            u[k, d] = np.nan if value is None else value
    return u


def profile(directory):
    """The rows of profile.csv by surface."""
    surfaces = {}
    try:
        with open(directory / "profile.csv", newline="") as file:
            for row in csv.DictReader(file):
                surfaces.setdefault(row.pop("surface"), []).append(
                    {key: float(value or "nan") for key, value in row.items()})
    except OSError:
        pass
    return surfaces


class Nodes:
    """The rows of nodes.csv: body, place, displacement and force of contact."""

    def __init__(self, directory, dim=3):
        with open(directory / "nodes.csv", newline="") as file:
            rows = list(csv.reader(file))[1:]
        self.body = np.array([row[0] for row in rows])
        self.X, self.u, self.force = np.array(
            [row[-3 * dim:] for row in rows], float).reshape(-1, 3, dim).transpose(
                1, 0, 2)

    def rows_of(self, body, X):
        """The row of each place in a body, and how far off it is."""
        here = np.flatnonzero(self.body == body)
        distance, nearest = cKDTree(self.X[here]).query(X)
        return here[nearest], distance


def middles_of_nodes(run_, model, u):
    """Fill in the middles of the edges from nodes.csv; False if one is not in
    it."""
    nodes = Nodes(run_.directory, 2)
    for b, body in enumerate(model.scene.mesh.bodies):
        middles = np.flatnonzero(model.body_of == b)
        middles = middles[middles >= model.n_vertices]
        rows, off = nodes.rows_of(body, model.X[middles])
        if off.max(initial=0) > 1e-8 * model.scene.size:
            return False
        u[middles] = nodes.u[rows]
    return True


TYPES = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "Int64": "i8",
         "UInt8": "u1", "UInt32": "u4", "UInt64": "u8", "Int8": "i1"}


def vtu_arrays(path):
    """The arrays of a file: base64, blocks of zlib."""
    arrays = {}
    text = path.read_text()
    for tag, body in re.findall(r"<DataArray ([^>]*)>(.*?)</DataArray>", text,
                                re.S):
        attributes = dict(re.findall(r'(\w+)="([^"]*)"', tag))
        name = attributes.get("Name", "points")
        dtype = "<" + TYPES[attributes["type"]]
        if attributes["format"] == "ascii":
            arrays[name] = np.array(body.split(), float)
            continue
        arrays[name] = np.frombuffer(decode(body.strip()), dtype)
    return arrays


def pieces(path):
    """The arrays of a file, or of the pieces of several processes."""
    if path.suffix != ".pvtu":
        return vtu_arrays(path)
    parts = [vtu_arrays(path.parent / name) for name in re.findall(
        '<Piece Source="([^"]*)"', path.read_text())]
    return {name: np.concatenate([part[name] for part in parts])
            for name in ("points", "displacement")}


def parts(directory):
    """Points, displacements and number of the body of each in the last
    increment of bodies.pvd, whose bodies have a file each."""
    files = re.findall(r'part="(\d+)".*file="([^"]*)"', (
        directory / "bodies.pvd").read_text())
    first = max(i for i, (number, _) in enumerate(files) if number == "0")
    found = [(int(number), pieces(directory / file))
             for number, file in files[first:]]
    return (*(np.concatenate([arrays[name].reshape(-1, 3)[:, :2].astype(float)
                              for _, arrays in found])
              for name in ("points", "displacement")),
            np.concatenate([np.full(len(arrays["points"]) // 3, number)
                            for number, arrays in found]))


def decode(text):
    n = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    length = (4 * (3 + n) + 2) // 3 * 4
    header = struct.unpack("<%dI" % (3 + n), base64.b64decode(text[:length]))
    data = base64.b64decode(text[length:])
    out, position = b"", 0
    for size in header[3:]:
        out += zlib.decompress(data[position:position + size])
        position += size
    return out


def middle_displacements(run_, model, u):
    """Fill in the middles of the edges from the last file of the bodies, in
    single precision; False if a node is not in it."""
    try:
        points, values, bodies = parts(run_.directory)
    except OSError:
        return False
    for number, body in match_bodies(model, points, bodies).items():
        nodes = np.flatnonzero(model.body_of == body)
        nodes = nodes[nodes >= model.n_vertices]
        here = bodies == number
        distance, nearest = cKDTree(points[here]).query(model.X[nodes])
        if distance.max() > 1e-5 * np.abs(points).max():
            return False
        u[nodes] = values[here][nearest]
    return True


def match_bodies(model, points, bodies):
    """Which of our bodies a number of the file is, by the box of its points:
    the program numbers them as it likes."""
    boxes = []
    for b in range(len(model.scene.mesh.bodies)):
        X = model.X[model.body_of == b]
        boxes.append(np.concatenate([X.min(0), X.max(0)]))
    number = {}
    for b in np.unique(bodies):
        p = points[bodies == b]
        box = np.concatenate([p.min(0), p.max(0)])
        order = [np.abs(box - other).max() for other in boxes]
        number[int(b)] = int(np.argmin(order))
    return number
