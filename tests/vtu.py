#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result files, seen by VTK.

Proves of linear and quadratic elements, on one process and on two, that VTK's
own readers open the series of the bodies and of the contact surface without a
complaint and find

- the arrays that the program promises, at points and of cells, with their
  components, all finite; the
  von Mises stress as the components of the stress have it;
- a part with its name for each body, whose cells share their points: as many as
  there are nodes;
- cells of the degree of the elements, as many as the program has computed with,
  none of them inverted, and of quadratic ones the area of the round boundary;
- the points inside of the box of the mesh, those of the slave on its arc;
- the printed probes at their point, the largest pressure on the surface, and
  load factors as times.

Usage: vtu.py CONTACT PARAMETERS MESHES
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as xml

try:
    from vtkmodules.vtkCommonCore import reference
    from vtkmodules.vtkCommonDataModel import (
        VTK_BIQUADRATIC_QUAD, VTK_LINE, VTK_QUAD, VTK_QUADRATIC_TRIANGLE,
        VTK_TRIANGLE)
    from vtkmodules.vtkFiltersCore import vtkAppendFilter
    from vtkmodules.vtkIOXML import (vtkXMLPUnstructuredGridReader,
                                     vtkXMLUnstructuredGridReader)
except ImportError as missing:
    print(f"skipped: {missing}; apt-get install python3-vtk9")
    sys.exit(0)

BODY_ARRAYS = {"displacement": 3, "contact_force": 3, "stress": 9, "von_mises": 1}
CELL_ARRAYS = {"body": 1, "level": 1, "process": 1}
CONTACT_ARRAYS = {"displacement": 3, "pressure": 1, "shear": 1, "gap": 1,
                  "slip": 1, "status": 1}
TYPES = {1: {VTK_QUAD, VTK_TRIANGLE},
         2: {VTK_BIQUADRATIC_QUAD, VTK_QUADRATIC_TRIANGLE}}

# Single precision has 6e-8; a formula of several numbers loses some of it.
SINGLE = 2e-6

# The cylinder (SSNP154): the quarter below the centre is round; the one above,
# which no body touches, has 12 chords.
RADIUS = 50.0
UPPER_CHORDS = 12
BLOCK = 100.0 * 200.0

failures = 0


def check(what, ok, detail=""):
    global failures
    if not ok:
        print(f"  FAILED: {what} ({detail})")
    failures += not ok


def near(a, b, scale=0.0):
    return abs(a - b) <= SINGLE * max(abs(b), scale)


def mesh_nodes(path):
    """Coordinates of the nodes of an MSH 4.1 file: the lines of three."""
    inside = False
    for line in path.read_text().splitlines():
        if line.startswith("$"):
            inside = line == "$Nodes"
        elif inside and len(line.split()) == 3:
            yield tuple(map(float, line.split()))


def read(path):
    """The grid of a file, which VTK's reader accepts in silence."""
    reader = (vtkXMLPUnstructuredGridReader() if path.suffix == ".pvtu"
              else vtkXMLUnstructuredGridReader())
    complaints = []
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda *_: complaints.append(event))
    reader.SetFileName(str(path))
    reader.Update()
    check(f"{path.name} is read", not complaints and
          reader.CanReadFile(str(path)), complaints)
    return reader.GetOutput()


def series(directory, name, increments):
    """The grids of NAME.pvd, all parts of an increment in one, whose times are
    those of the summary; and the names of the parts."""
    sets = xml.parse(directory / f"{name}.pvd").findall(".//DataSet")
    times = [float(s.get("timestep")) for s in sets if s.get("part") == "0"]
    check(f"times of {name}.pvd", times == increments, f"{times}")
    together = []
    for s in sets:
        grid, time = read(directory / s.get("file")), float(s.get("timestep"))
        field = grid.GetFieldData().GetArray("TIME")
        if field:  # a .pvtu file has none
            check("TIME", near(field.GetValue(0), time), field.GetValue(0))
        if s.get("part") == "0":
            together.append(vtkAppendFilter())
        together[-1].AddInputData(grid)
    for append in together:
        append.Update()
    return [append.GetOutput() for append in together], \
        [s.get("name") for s in sets][:len(sets) // len(times)]


def check_arrays(data, expected):
    found = {data.GetArrayName(i): data.GetArray(i).GetNumberOfComponents()
             for i in range(data.GetNumberOfArrays())}
    check("arrays", found == expected, f"{found} instead of {expected}")
    for i in range(data.GetNumberOfArrays()):
        array = data.GetArray(i)
        check(f"{array.GetName()} is finite",
              all(math.isfinite(x) for k in range(array.GetNumberOfTuples())
                  for x in array.GetTuple(k)))


# Gauss-Legendre, 3 points: exact for the area of cells of degree 2, whose edges
# are parabolas. Of triangles the midpoints of the sides.
GAUSS = [(0.5 - math.sqrt(0.15), 5 / 18), (0.5, 8 / 18),
         (0.5 + math.sqrt(0.15), 5 / 18)]
SQUARE = [(x, y, u * v) for x, u in GAUSS for y, v in GAUSS]
TRIANGLE = [(0.5, 0.0, 1 / 6), (0.5, 0.5, 1 / 6), (0.0, 0.5, 1 / 6)]


def slope(cell, place, d):
    """The derivative of VTK's map onto a cell by its coordinate d. Differences
    about a place are exact for degree 2."""
    h, ends, subcell = 0.25, [], reference(0)
    weights = [0.0] * cell.GetNumberOfPoints()
    for sign in (1, -1):
        local, x = [*place, 0.0][:3], [0.0] * 3
        local[d] += sign * h
        cell.EvaluateLocation(subcell, local, x, weights)
        ends.append(x)
    return [(p - m) / (2 * h) for p, m in zip(*ends)]


def determinants(cell):
    """Weights and determinants of VTK's map onto a cell."""
    for xi, eta, weight in TRIANGLE if cell.GetNumberOfEdges() == 3 else SQUARE:
        a, b = slope(cell, (xi, eta), 0), slope(cell, (xi, eta), 1)
        yield weight, a[0] * b[1] - a[1] * b[0]


def body_of(grid, i):
    return int(grid.GetCellData().GetArray("body").GetValue(i))


def check_shared(grid, n_ranks):
    """No two points of a body and process are at one place, but where a face
    hangs: its nodes are those of both sides."""
    process = grid.GetCellData().GetArray("process")
    check("processes", {int(process.GetValue(i)) for i in
                        range(grid.GetNumberOfCells())} == set(range(n_ranks)))
    places = {}
    for i in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(i)
        for k in range(cell.GetNumberOfPoints()):
            point = cell.GetPointId(k)
            key = body_of(grid, i), process.GetValue(i), grid.GetPoint(point)
            places.setdefault(key, set()).add(point)
    level = grid.GetCellData().GetArray("level").GetRange()
    check("points are shared", max(map(len, places.values())) <= 1 +
          (level[0] < level[1]))


def check_cells(grid, degree, n_cells):
    """Their number, types and orientation. Returns the areas of the bodies."""
    n = grid.GetNumberOfCells()
    check("number of cells", n == n_cells, f"{n} instead of {n_cells}")
    found = {grid.GetCellType(i) for i in range(n)}
    check("types of cells", found and found <= TYPES[degree], f"{found}")
    areas, n_inverted = {0: 0.0, 1: 0.0}, 0
    for i in range(n):
        values = list(determinants(grid.GetCell(i)))
        n_inverted += any(d <= 0 for _, d in values)
        areas[body_of(grid, i)] += sum(w * d for w, d in values)
    check("no cell is inverted", n_inverted == 0, n_inverted)
    return areas


def check_stress(grid):
    data = grid.GetPointData()
    stress, mises = data.GetArray("stress"), data.GetArray("von_mises")
    largest = mises.GetRange()[1]
    check("there is a stress", largest > 0 and mises.GetRange()[0] >= 0,
          mises.GetRange())
    worst = 0.0
    for i in range(grid.GetNumberOfPoints()):
        x, xy, xz, yx, y, yz, zx, zy, z = stress.GetTuple(i)
        check("the stress is symmetric", (xy, yz, xz) == (yx, zy, zx))
        square = ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2 \
            + 3 * (xy ** 2 + yz ** 2 + xz ** 2)
        worst = max(worst, abs(math.sqrt(square) - mises.GetValue(i)))
    check("von Mises", worst <= SINGLE * largest, worst)


def check_box(grid, nodes):
    bounds = grid.GetBounds()
    size = max(abs(x) for node in nodes for x in node)
    for d in range(3):
        values = [node[d] for node in nodes]
        check("box of the mesh", near(bounds[2 * d], min(values), size) and
              near(bounds[2 * d + 1], max(values), size), bounds)


def check_probes(grid, probes):
    """The probes in B, the corner of the block at the origin."""
    data = grid.GetPointData()
    at_b = {grid.GetCell(i).GetPointId(k)
            for i in range(grid.GetNumberOfCells()) if body_of(grid, i) == 0
            for k in range(grid.GetCell(i).GetNumberOfPoints())}
    at_b = [i for i in at_b if grid.GetPoint(i) == (0, 0, 0)]
    check("B is there", at_b)
    for i in at_b:
        u = data.GetArray("displacement").GetComponent(i, 1)
        stress = data.GetArray("stress").GetComponent(i, 4)
        check("DY(B)", near(u, probes["DY(B)"]), u)
        check("SIYY(B)", near(stress, probes["SIYY(B)"]), stress)


def check_bodies(grid, degree, summary, nodes, n_ranks):
    """Returns the areas of the bodies."""
    check_arrays(grid.GetPointData(), BODY_ARRAYS)
    check_arrays(grid.GetCellData(), CELL_ARRAYS)
    found = grid.GetCellData().GetArray("body").GetRange()
    check("body", found == (0, 1), found)
    check_shared(grid, n_ranks)
    areas = check_cells(grid, degree, summary["levels"][-1]["cells"])
    check_stress(grid)
    check_box(grid, nodes)
    return areas


def check_contact(grid, summary):
    check_arrays(grid.GetPointData(), CONTACT_ARRAYS)
    types = {grid.GetCellType(i) for i in range(grid.GetNumberOfCells())}
    check("lines", types == {VTK_LINE}, types)
    radii = [math.hypot(x, y - RADIUS) for x, y, _ in
             map(grid.GetPoint, range(grid.GetNumberOfPoints()))]
    check("the slave is round", all(near(r, RADIUS) for r in radii))
    data = grid.GetPointData()
    status = data.GetArray("status")
    found = {status.GetValue(i) for i in range(status.GetNumberOfTuples())}
    # -1: no point of contact is there
    check("status", {0, 1, 2} <= found <= {-1, 0, 1, 2}, found)
    check("largest pressure", near(data.GetArray("pressure").GetRange()[1],
                                   summary["contact"]["max_pressure"]))


def run(contact, case, n_ranks, settings):
    """The directory of the results, the summary, and the mesh's nodes."""
    entries = {"Output/VTU": "true", "Output/Screen": "none",
               "Output/Directory": f"output/{n_ranks}",
               "Probes/References": "", "Probes/Tolerances": "", **settings}
    call = [contact, case, "--quiet"]
    for entry, value in entries.items():
        call += ["--set", f"{entry}={value}"]
    if n_ranks > 1:
        call = ["mpirun", "-np", str(n_ranks), *call]
    status = subprocess.run(call).returncode
    check("exit status", status == 0, status)
    directory = pathlib.Path(f"output/{n_ranks}") / case.stem
    return directory, json.loads((directory / "summary.json").read_text())


def check_case(contact, case, mesh, degree, n_ranks=1, **settings):
    print(f"{case.stem}, degree {degree}, {n_ranks} process(es)")
    directory, summary = run(contact, case, n_ranks, {
        name.replace("__", "/").replace("_", " "): value
        for name, value in settings.items()})
    last = [i for i in summary["increments"]
            if i["level"] == summary["increments"][-1]["level"]]
    times = [i["load_factor"] for i in last]
    nodes = list(mesh_nodes(mesh))
    bodies, names = series(directory, "bodies", times)
    check("names", names == ["Block", "Cylinder"], names)
    for grid in bodies:
        areas = check_bodies(grid, degree, summary, nodes, n_ranks)
    check_probes(bodies[-1], {p["name"]: p["value"] for p in summary["probes"]})
    contact_grids, names = series(directory, "contact", times)
    check("names", names == ["Contact"], names)
    check_contact(contact_grids[-1], summary)
    return areas


def main():
    contact, parameters, meshes = (pathlib.Path(a) for a in sys.argv[1:4])
    own, quads = meshes / "ssnp154.msh", meshes / "ssnp154_quads.msh"
    check_case(contact, parameters / "ssnp154_g.prm", own, 1)
    areas = check_case(contact, parameters / "ssnp154_d.prm", own, 2)
    chords = UPPER_CHORDS / 2 * RADIUS ** 2 * math.sin(
        math.pi / 2 / UPPER_CHORDS)
    check("area of the block", near(areas[0], BLOCK), areas[0])
    check("area of the cylinder",
          near(areas[1], math.pi / 4 * RADIUS ** 2 + chords), areas[1])

    # Hanging nodes, and pieces put together by a record.
    check_case(contact, parameters / "nested_friction.prm", quads, 2, 2,
               Refinement__Levels="3", Refinement__Strategy="adaptive")
    print(f"{failures} failures" if failures else "all as it should be")
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()
