"""Whether results of a scene in 3-D can be true: as verify.py, from the nodes
of both surfaces in profile.csv and all nodes in nodes.csv.

Penetration of a slave node is its vertical distance from the deformed master,
whose facets are split in triangles; with mortar, whose gaps are weighted, the mean
of that distance around the node.
"""
# SPDX-License-Identifier: LGPL-2.1-or-later
import csv
import math

import verify

# Of the largest displacement of the surfaces: see verify.py.
PENETRATION = {"nodal": 0.02, "mortar": 0.1}
# Of the largest traction, of all forces.
TRACTION = 1e-4
FORCE = 1e-6
# Of the geometry loop, as it is if not told: Solution/Geometry tolerance.
GEOMETRY = 1e-3


def rows_of(directory, scene, file):
    path = directory / "output" / scene.name / file
    with open(path, newline="") as lines:
        return [{key: value if key in ("surface", "body") else float(value)
                 for key, value in row.items()}
                for row in csv.DictReader(lines)]


def vector(row, key, unit):
    return [row[f"{key}_{c}_{unit}"] for c in "xyz"]


def place(row):
    return [row[f"{c}_mm"] for c in "XYZ"]


def deformed(row):
    return [a + b for a, b in zip(place(row), vector(row, "displacement", "mm"))]


def norm(x):
    return math.sqrt(sum(c * c for c in x))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0]]


def problems(scene, directory, summary):
    """What is wrong with the results; nothing, if all is well."""
    if summary is None:
        return ["summary.json cannot be read"]
    found = ["not a number in summary.json: " + path
             for path in verify.not_numbers(summary, [])]
    if not summary["converged"]:
        found.append("exit status 0, but the summary has not converged")
    try:
        profile = rows_of(directory, scene, "profile.csv")
        nodes = rows_of(directory, scene, "nodes.csv")
    except (OSError, ValueError) as error:
        return found + ["results cannot be read: %s" % error]
    if any(not math.isfinite(v) for row in profile + nodes
           for v in row.values() if not isinstance(v, str)):
        return found + ["not a number in profile.csv or nodes.csv"]
    slave = [row for row in profile if row["surface"] == "slave"]
    master = [row for row in profile if row["surface"] != "slave"]
    found += check_tractions(scene, slave)
    found += check_forces(scene, nodes)
    found += check_penetration(scene, slave, master)
    return found


def check_tractions(scene, slave):
    largest = max((abs(r["pressure_MPa"]) for r in slave), default=0)
    if largest < 1e-9 * scene.traction:
        return []
    for r in slave:
        p, q = r["pressure_MPa"], vector(r, "shear", "MPa")
        slip = vector(r, "slip", "mm")
        bound = scene.tresca + scene.mu * p
        status = r["status_0_open_1_slip_2_stick"]
        small = TRACTION * max(largest * max(scene.mu, 0.1), scene.tresca)
        if p < -TRACTION * largest:
            return ["negative pressure %.3g, largest %.3g" % (p, largest)]
        if status < 1 and max(p, norm(q)) > TRACTION * largest:
            return ["tractions %.3g, %.3g at an open node, largest %.3g" %
                    (p, norm(q), largest)]
        if status >= 1 and norm(q) > bound + small:
            return ["shear %.6g above its bound %.6g" % (norm(q), bound)]
        if status == 1 and norm(q) < bound - small:
            return ["shear %.6g of a slipping node below its bound %.6g" %
                    (norm(q), bound)]
        # Against the slip, within what the directions of a step can differ.
        along = sum(a * b for a, b in zip(q, slip))
        if (status == 1 and bound > small and
                norm(slip) > 1e-6 * scene.size and
                along > -(1 - 1e-4) * norm(q) * norm(slip) and
                scene.features["increments"] == 1):
            return ["shear is not against the slip: cosine %.6g" %
                    (along / norm(q) / norm(slip))]
        if status == 2 and norm(slip) > 1e-6 * scene.size:
            return ["slip %.3g of a sticking node" % norm(slip)]
    return []


def balanced(scene, row):
    """Where the forces on a node have no moment together with those opposite: where
    slave and foot meet along the normal, and are not apart along the surface. If
    the bodies are paired undeformed, slip is a distance along the surface: then the
    node has moved along the normal alone, which is that of the flat surface."""
    if scene.features["geometry"] != "undeformed":
        return deformed(row)
    normal = [-scene.slope, 0., 1.]
    u = vector(row, "displacement", "mm")
    along = sum(a * b for a, b in zip(u, normal)) / norm(normal) ** 2
    return [a + along * b for a, b in zip(place(row), normal)]


def offset(scene, nodes):
    """How far slave and foot may be apart along the surface: both have moved since
    they were paired by the tolerance of the geometry loop in each direction. A mean
    over slave or master counts nodes with weights of either sign, the sum of whose
    sizes is 3 in the middle of a facet of eight nodes, and (5/3)^2 for the integral
    of a dual function of four."""
    if scene.features["geometry"] != "fixed point":
        return 0.
    moved = GEOMETRY * max(abs(u) for row in nodes
                           for u in vector(row, "displacement", "mm"))
    master = 3 if scene.features["degree"] == 2 else 1
    means = (5 / 3) ** 2 if scene.features["rule"] == "mortar" else 1
    return math.sqrt(2) * moved * (1 + master) * means


def check_forces(scene, nodes):
    """Forces and moments of contact on both bodies, and the load."""
    force = {"Lower": [0.] * 3, "Upper": [0.] * 3}
    moment = {"Lower": [0.] * 3, "Upper": [0.] * 3}
    scale = 0.
    for row in nodes:
        f = vector(row, "contact_force", "N")
        x = balanced(scene, row)
        scale += norm(f)
        for sums, add in ((force, f), (moment, cross(x, f))):
            sums[row["body"]] = [a + b for a, b in zip(sums[row["body"]], add)]
    found = []
    tolerance = FORCE * scale + 1e-12 * scene.traction * scene.size ** 2
    for what, sums, most in (
            ("forces", force, tolerance),
            ("moments", moment, tolerance * scene.size +
             offset(scene, nodes) * scale / 2)):
        off = norm([a + b for a, b in zip(sums["Lower"], sums["Upper"])])
        if off > most:
            found.append("%s of contact %s on Lower, %s on Upper" %
                         (what, sums["Lower"], sums["Upper"]))
    for c, load in enumerate(scene.load or ()):
        if load is not None and abs(force["Upper"][c] + load) > max(
                tolerance, FORCE * norm([x for x in scene.load if x])):
            found.append("contact force %.8g along %s, load %.8g" %
                         (force["Upper"][c], "xyz"[c], load))
    return found


def height_above(x, triangles):
    """The vertical distance of x from the triangles; None beside them."""
    for a, b, c in triangles:
        u, v, w = ([p - q for p, q in zip(y, a)] for y in (b, c, x))
        det = u[0] * v[1] - u[1] * v[0]
        if det == 0:
            continue
        s = (w[0] * v[1] - w[1] * v[0]) / det
        t = (u[0] * w[1] - u[1] * w[0]) / det
        if min(s, t, 1 - s - t) >= -1e-9:
            return w[2] - s * u[2] - t * v[2]
    return None


def check_penetration(scene, slave, master):
    """Where the surfaces are nearly horizontal: that they do not overlap."""
    if scene.features["shape"] in ("edge", "corner"):
        return []
    triangles, warp = triangles_of(scene, master)
    mean = mean_heights(scene, slave, triangles)
    up = 1 if scene.slave_is_upper else -1
    largest = max(norm(vector(r, "displacement", "mm")) for r in slave + master)
    rule = scene.features["rule"]
    lowest = moment = force = 0.
    for row, around in zip(slave, mean):
        height = (around if rule == "mortar"
                  else height_above(deformed(row), triangles))
        if height is not None:
            lowest = min(lowest, up * height)
            moment += row["nodal_force_N"] * min(0., up * height)
            force += row["nodal_force_N"]
    # With mortar in the mean over the forces, as in 2-D.
    if rule == "mortar":
        lowest = moment / force if force > 0 else 0.
    allowed = PENETRATION[rule] * largest + warp + 1e-9 * scene.size
    if scene.radius:
        cells = scene.cells[1 if scene.slave_is_upper else 0]
        allowed += (scene.width / min(cells[:2])) ** 2 / (4 * scene.radius)
    if lowest < -allowed:
        return ["penetration %.3g mm, %.2g of the largest displacement" %
                (-lowest, -lowest / max(largest, 1e-300))]
    return []


def mean_heights(scene, slave, triangles):
    """Of the deformed slave around each node, its hat function the weight; None
    where it is beside the master. Each facet is sampled at n x n places."""
    def key(x):
        return tuple(round(c / scene.size, 6) for c in x)
    n = 4
    at = {key(place(row)): i for i, row in enumerate(slave)}
    sums, weights = [0.] * len(slave), [0.] * len(slave)
    for facet in scene.facets_of("Slave"):
        grid = grid_of(facet, at, key)
        for four in ((*a, *b) for low, high in zip(grid, grid[1:])
                     for a, b in zip(zip(low, low[1:]), zip(high, high[1:]))):
            corners = [deformed(slave[i]) for i in four]
            a, b, c, d = corners
            area = norm(cross([y - x for x, y in zip(a, d)],
                              [y - x for x, y in zip(b, c)])) / 2
            for k in range(n * n):
                r, s = (k % n + 0.5) / n, (k // n + 0.5) / n
                hats = (1 - r) * (1 - s), r * (1 - s), (1 - r) * s, r * s
                height = height_above(
                    [sum(h * x[d] for h, x in zip(hats, corners))
                     for d in range(3)], triangles)
                if height is not None:
                    for i, hat in zip(four, hats):
                        sums[i] += hat * area * height
                        weights[i] += hat * area
    return [a / b if b > 0 else None for a, b in zip(sums, weights)]


def grid_of(corners, at, key):
    """The deformed nodes of a facet in lines: 3 x 3 at degree 2, if the middle ones
    are where the mesh file has straight sides, else its corners."""
    def between(r, s):
        (a, b), (d, c) = corners[:2], corners[:1:-1]
        return [(1 - r) * ((1 - s) * u + s * x) + r * ((1 - s) * v + s * w)
                for u, v, w, x in zip(a, b, c, d)]
    for n in (3, 2):
        places = [[key(between(i / (n - 1), j / (n - 1))) for i in range(n)]
                  for j in range(n)]
        if all(x in at for line in places for x in line):
            return [[at[x] for x in line] for line in places]
    raise KeyError(f"no nodes at {corners}")


def triangles_of(scene, master):
    """Two of each deformed quadrangle between nodes, and how far a facet is from
    them at most: a quadrangle that is not flat by a quarter of its twist, a
    parabola by an eighth of its second difference."""
    def key(x):
        return tuple(round(c / scene.size, 6) for c in x)
    at = {key(place(row)): deformed(row) for row in master}
    triangles, warp = [], 0.
    for facet in scene.facets_of("Master"):
        grid = grid_of(facet, at, key)
        for low, high in zip(grid, grid[1:]):
            for a, b, c, d in zip(low, low[1:], high[1:], high):
                triangles += [(a, b, c), (a, c, d)]
                warp = max(warp, abs(a[2] - b[2] + c[2] - d[2]) / 4)
        for line in (*grid, *zip(*grid)):
            if len(line) == 3:
                a, m, b = line
                warp = max(warp, abs(a[2] - 2 * m[2] + b[2]) / 4)
    return triangles, warp
