#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result files in 3-D, seen by VTK.

Proves of the cap of a hollow sphere that is pressed on a block or a plane and
dragged, of linear and quadratic elements, on one process and on two, that VTK's
own readers open both series without a complaint and find

- the arrays that the program promises, vectors with three components, all finite;
  the von Mises stress as the six components of the stress have it;
- cells of the degree of the elements, as many as the program has computed with,
  none of them inverted, and the volume of the cap (of quadratic ones that of the
  round one);
- quadrilaterals of this degree as the surface of contact, all of their points on
  the sphere, middles of sides too;
- pressure and shear whose integrals over these cells are the forces of contact;
  shear along the plane, as large as the friction coefficient times the pressure
  where points slip, and against the slip; no slip where they stick;
- in profile.csv the same values, and of the master those of the slave above it.

Usage: vtu_space.py CONTACT
"""

import csv
import itertools
import json
import math
import pathlib
import subprocess
import sys

import numpy
import vtu
from volume_scenes import Volumes
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import (
    VTK_BIQUADRATIC_QUAD, VTK_HEXAHEDRON, VTK_QUAD, VTK_TRIQUADRATIC_HEXAHEDRON)
from vtu import (BODY_ARRAYS, CELL_ARRAYS, GAUSS, SINGLE, check, check_arrays,
                 check_shared, near, series, slope)

CONTACT_ARRAYS = {"displacement": 3, "pressure": 1, "shear": 3, "gap": 1,
                  "slip": 3, "status": 1}
SOLIDS = {1: VTK_HEXAHEDRON, 2: VTK_TRIQUADRATIC_HEXAHEDRON}
SURFACES = {1: VTK_QUAD, 2: VTK_BIQUADRATIC_QUAD}

# The cap: half its width as seen from the centre, outer and inner radius.
WIDTH, RADIUS, INNER = 0.3, 10., 7.
SOLID_ANGLE = 4 * math.asin(WIDTH ** 2 / (1 + WIDTH ** 2))
FRICTION = 0.3


def deformed(row):
    """The place of a node in a row of profile.csv [mm]."""
    return [float(row[f"{c.upper()}_mm"]) + float(row[f"displacement_{c}_mm"])
            for c in "xyz"]


def mesh(with_block):
    volumes = Volumes()

    def cap(r, s, t):
        ray = WIDTH * (2 * r - 1), WIDTH * (2 * s - 1), -1
        radius = RADIUS + (INNER - RADIUS) * t
        return tuple(radius * x / math.hypot(*ray) for x in ray)

    volumes.block("Cap", (6, 6, 2), cap)
    if with_block:
        volumes.block("Plate", (7, 7, 2),
                      lambda r, s, t: (10 * r - 5, 10 * s - 5, 4 * t - 14))
    volumes.write("cap")


def run(contact, degree, with_block, n_ranks):
    mesh(with_block)
    name = f"cap_{degree}_{n_ranks}"
    entries = {
        "Mesh/File": "cap.msh", "Element/Degree": degree,
        "Mesh/Spheres": f"Cap_z0: 0, 0, 0, {RADIUS}; Cap_z1: 0, 0, 0, {INNER}",
        "Solids/Young's modulus": "Cap: 1000",
        "Solids/Poisson's ratio": "Cap: 0.3",
        "Solids/Kinematics": "small strain",
        "Boundary conditions/Displacement x": "Cap_z1: 0.04",
        "Boundary conditions/Displacement y": "Cap_z1: 0.02",
        "Boundary conditions/Displacement z": "Cap_z1: -0.1",
        "Boundary conditions/Histories":
            "Displacement z: min(1, 2*t); Displacement x: max(0, 2*t - 1); "
            "Displacement y: max(0, 2*t - 1)",
        "Contact/Slave": "Cap_z0", "Contact/Friction coefficient": FRICTION,
        "Probes/Probes": "x: contact force x, Cap_z0; y: contact force y, Cap_z0; "
                         "z: contact force z, Cap_z0",
        "Solution/Increments": 2, "Output/VTU": "true", "Output/Profile": "true"}
    if with_block:
        entries["Contact/Master"] = "Plate_z1"
        entries["Solids/Young's modulus"] += ", Plate: 3000"
        entries["Solids/Poisson's ratio"] += ", Plate: 0.3"
        for c in "xyz":
            entries[f"Boundary conditions/Displacement {c}"] += ", Plate_z0: 0"
    else:
        entries["Contact/Obstacle"] = f"half space: 0, 0, {-RADIUS}, 0, 0, 1"
    sections = {}
    for entry, value in entries.items():
        section, key = entry.split("/", 1)
        sections.setdefault(section, []).append(f"  set {key} = {value}\n")
    case = pathlib.Path(f"{name}.prm")
    case.write_text("".join(f"subsection {section}\n{''.join(lines)}end\n"
                            for section, lines in sections.items()))
    call = [contact, case, "--quiet"]
    if n_ranks > 1:
        call = ["mpirun", "-np", str(n_ranks), *call]
    status = subprocess.run(call).returncode
    check("exit status", status == 0, status)
    directory = pathlib.Path("output") / name
    return directory, json.loads((directory / "summary.json").read_text())


def gauss_points(n):
    """Places and weights in the unit square or cube."""
    for points in itertools.product(GAUSS, repeat=n):
        yield [x for x, _ in points], math.prod(w for _, w in points)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def check_cells(grid, degree, n_cells):
    """Returns the volumes of the bodies."""
    n = grid.GetNumberOfCells()
    check("number of cells", n == n_cells, f"{n} instead of {n_cells}")
    found = {grid.GetCellType(i) for i in range(n)}
    check("types of cells", found == {SOLIDS[degree]}, found)
    volumes, n_inverted = {}, 0
    for i in range(n):
        cell, values = grid.GetCell(i), []
        for place, weight in gauss_points(3):
            a, b, c = (slope(cell, place, d) for d in range(3))
            values.append((weight, sum(x * y for x, y in zip(cross(a, b), c))))
        n_inverted += any(d <= 0 for _, d in values)
        body = vtu.body_of(grid, i)
        volumes[body] = volumes.get(body, 0) + sum(w * d for w, d in values)
    check("no cell is inverted", n_inverted == 0, n_inverted)
    return volumes


def check_stress(grid):
    data = grid.GetPointData()
    stress = data.GetArray("stress")
    mises = data.GetArray("von_mises")
    largest = mises.GetRange()[1]
    check("there is a stress", largest > 0, largest)
    # Between the corners all of them are interpolated.
    corners = {grid.GetCell(i).GetPointId(k)
               for i in range(grid.GetNumberOfCells()) for k in range(8)}
    worst = 0.0
    for i in corners:
        x, xy, xz, _, y, yz, _, _, z = stress.GetTuple(i)
        square = ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2 \
            + 3 * (xy ** 2 + xz ** 2 + yz ** 2)
        worst = max(worst, abs(math.sqrt(square) - mises.GetValue(i)))
    check("von Mises", worst <= SINGLE * largest, worst)


def check_driven(grid):
    """The inner sphere has moved as it was told to."""
    u = grid.GetPointData().GetArray("displacement")
    inner = [u.GetTuple(i) for i in range(grid.GetNumberOfPoints())
             if near(math.hypot(*grid.GetPoint(i)), INNER)]
    check("displacements", len(inner) >= 49 and all(
        near(a, b) for v in inner for a, b in zip(v, (0.04, 0.02, -0.1))),
        inner[:1])


def integral(grid, array, component):
    """Of a field over the surface, as VTK interpolates it."""
    total, subcell = 0.0, reference(0)
    for i in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(i)
        nodes = [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]
        for place, weight in gauss_points(2):
            weights, x = [0.0] * len(nodes), [0.0] * 3
            cell.EvaluateLocation(subcell, [*place, 0.0], x, weights)
            area = math.hypot(*cross(slope(cell, place, 0), slope(cell, place, 1)))
            total += weight * area * sum(
                w * array.GetComponent(n, component)
                for w, n in zip(weights, nodes))
    return total


def check_surface(grid, degree, summary, with_block):
    check_arrays(grid.GetPointData(), CONTACT_ARRAYS)
    types = {grid.GetCellType(i) for i in range(grid.GetNumberOfCells())}
    check("quadrilaterals", types == {SURFACES[degree]}, types)
    n = grid.GetNumberOfPoints()
    side = math.isqrt(grid.GetNumberOfCells()) * degree + 1
    check("their points are shared", n == side ** 2, n)
    radii = [math.hypot(*grid.GetPoint(i)) for i in range(n)]
    check("the slave is round", all(near(r, RADIUS) for r in radii))
    data = grid.GetPointData()
    pressure, shear, slip, status = (data.GetArray(name) for name in (
        "pressure", "shear", "slip", "status"))
    largest = pressure.GetRange()[1]
    check("largest pressure", near(largest, summary["contact"]["max_pressure"]))
    found = [status.GetValue(i) for i in range(n)]
    check("status", {0, 1, 2} <= set(found) <= {-1, 0, 1, 2}, set(found))
    for i in range(n):
        p, q, s = pressure.GetValue(i), shear.GetTuple(i), slip.GetTuple(i)
        if found[i] == 1:
            check("shear of slip", near(math.hypot(*q), FRICTION * p, largest), q)
            against = sum(a * b for a, b in zip(q, s))
            check("shear against the slip", against <= 0, against)
        elif found[i] == 2:
            check("shear of stick", math.hypot(*q) <= FRICTION * p, q)
            check("no slip", math.hypot(*s) < 1e-6, s)
        else:
            check("open", p == 0 and math.hypot(*q) == 0, (p, q))
    if with_block:
        return
    # On a plane the normal is that of the plane, and pressures and shears are
    # weighted with the area of the sphere.
    check("shear in 2-D", all(abs(shear.GetComponent(i, 2)) <=
                                    SINGLE * largest for i in range(n)))
    probes = {p["name"]: p["value"] for p in summary["probes"]}
    for name, array, component, sign in (("x", shear, 0, 1), ("y", shear, 1, 1),
                                         ("z", pressure, 0, 1)):
        total = integral(grid, array, component)
        check(f"force {name}", abs(total - sign * probes[name])
              <= 1e-5 * probes["z"], (total, probes[name]))


def check_profile(directory, grid, with_block):
    with open(directory / "profile.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    slave = [row for row in rows if row["surface"] == "slave"]
    data, places = grid.GetPointData(), {}
    for i in range(grid.GetNumberOfPoints()):
        places[tuple(round(x, 4) for x in grid.GetPoint(i))] = i
    check("a row for each node", len(slave) == len(places), len(slave))
    for row in slave:
        i = places[tuple(round(float(row[f"{c}_mm"]), 4) + 0. for c in "XYZ")]
        values = [float(row[f"{name}_{c}_{unit}"]) for name, unit in
                  (("displacement", "mm"), ("shear", "MPa"), ("slip", "mm"))
                  for c in "xyz"]
        seen = [x for name in ("displacement", "shear", "slip")
                for x in data.GetArray(name).GetTuple(i)]
        values.append(float(row["pressure_MPa"]))
        seen.append(data.GetArray("pressure").GetValue(i))
        check("profile and VTU", all(near(a, b, 1e-3) for a, b in
                                     zip(seen, values)), (seen, values))
    master = [row for row in rows if row["surface"] == "master"]
    check("rows of the master", bool(master) == with_block, len(master))
    if with_block:
        forces = [sum(float(row["nodal_force_N"]) for row in part)
                  for part in (slave, master)]
        check("forces on both sides", near(*forces), forces)
        # Those of the slave next to it: the bilinear function through the four
        # nodes around, which are nearest, seen along the normal.
        pressed = [row for row in master if float(row["pressure_MPa"]) > 0]
        check("the master is pressed", len(pressed) > 0)
        nodes = [(numpy.array(deformed(row)), float(row["pressure_MPa"]))
                 for row in slave]
        for row in pressed:
            place = numpy.array(deformed(row))
            around = sorted(nodes, key=lambda n: numpy.linalg.norm(
                (n[0] - place)[:2]))[:4]
            r = [x - place for x, _ in around]
            value = numpy.linalg.solve([[1, x, y, x * y] for x, y, _ in r],
                                       [p for _, p in around])[0]
            check("pressures on the master",
                  abs(float(row["pressure_MPa"]) / value - 1) < 1e-2,
                  (row["pressure_MPa"], value))


def check_case(contact, degree, with_block, n_ranks):
    print(f"cap on a {'block' if with_block else 'plane'}, degree {degree}, "
          f"{n_ranks} process(es)")
    directory, summary = run(contact, degree, with_block, n_ranks)
    times = [i["load_factor"] for i in summary["increments"]]
    bodies, names = series(directory, "bodies", times)
    check("names", names == ["Cap", "Plate"][:1 + with_block], names)
    for grid in bodies:
        check_arrays(grid.GetPointData(), BODY_ARRAYS)
        check_arrays(grid.GetCellData(), CELL_ARRAYS)
        check_shared(grid, n_ranks)
        volumes = check_cells(grid, degree, summary["levels"][-1]["cells"])
    check("bodies", sorted(volumes) == list(range(1 + with_block)), volumes)
    exact = SOLID_ANGLE * (RADIUS ** 3 - INNER ** 3) / 3
    error = abs(volumes[0] / exact - 1)
    check("volume of the cap", error < (1e-5 if degree == 2 else 1e-2) and
          (degree == 2 or error > 1e-4), error)
    if with_block:
        check("volume of the block", near(volumes[1], 400.), volumes)
    check_stress(bodies[-1])
    check_driven(bodies[-1])
    surfaces, _ = series(directory, "contact", times)
    check_surface(surfaces[-1], degree, summary, with_block)
    check_profile(directory, surfaces[-1], with_block)


def main():
    contact = pathlib.Path(sys.argv[1])
    check_case(contact, 1, True, 1)
    check_case(contact, 2, False, 1)
    check_case(contact, 2, False, 2)
    print(f"{vtu.failures} failures" if vtu.failures else "all as it should be")
    sys.exit(vtu.failures > 0)


if __name__ == "__main__":
    main()
