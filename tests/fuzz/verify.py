"""Whether results of a scene can be true.

Nothing here trusts what the program says about its convergence: it looks at the
nodes of both surfaces in profile.csv, their displacements, tractions and
forces.

Penetration of a slave node is its distance from the deformed master surface
(the undeformed one, with the displacements of the foot, where theory says so:
geometry undeformed), negative inside of the master, for nodes whose foot is
not at an end of the master. The program may leave what its geometry loop is
allowed to: a part of the largest displacement of the surfaces.
"""
# SPDX-License-Identifier: LGPL-2.1-or-later
import csv
import math

# Of the largest traction. A bound follows the pressure up to the friction
# tolerance, or to the last step of Newton's method, whose residual is measured
# by forces which may be larger than those of contact.
TRACTION = 1e-4
# Of the largest displacement of the surfaces, and per squared slope.
PENETRATION = {"nodal": 0.02, "mortar": 0.1, "Gauss": 0.1}
FORCE = 1e-6


def rows_of(directory, scene):
    path = directory / "output" / scene.name / "profile.csv"
    slave, master = [], []
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            values = {key: float(value) for key, value in row.items()
                      if key != "surface"}
            (slave if row["surface"] == "slave" else master).append(values)
    return slave, master


def place(row, deformed):
    if not deformed:
        return row["X_mm"], row["Y_mm"]
    return (row["X_mm"] + row["displacement_x_mm"],
            row["Y_mm"] + row["displacement_y_mm"])


def polyline(rows, degree, deformed):
    """Points (x, y, u, v) along a surface; a quadratic edge in eight pieces."""
    nodes = [(*place(row, deformed), row["displacement_x_mm"],
              row["displacement_y_mm"]) for row in rows]
    if degree == 1 or len(nodes) % 2 == 0:
        return nodes
    points = nodes[:1]
    for i in range(0, len(nodes) - 2, 2):
        for k in range(1, 9):
            s = k / 8
            shape = ((1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1))
            points.append(tuple(sum(n * node[d] for n, node in
                                    zip(shape, nodes[i:i + 3]))
                                for d in range(4)))
    return points


def foot(point, line):
    """The closest place on a polyline: its normal upwards, the distance along
    that, the displacement there, and whether it is inside of the line."""
    best = None
    for k in range(len(line) - 1):
        a, b = line[k], line[k + 1]
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = math.hypot(dx, dy)
        if length == 0:
            continue
        along = ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / length ** 2
        clipped = min(1.0, max(0.0, along))
        rx = point[0] - a[0] - clipped * dx
        ry = point[1] - a[1] - clipped * dy
        distance = math.hypot(rx, ry)
        if best is None or distance < best[0]:
            normal = (-dy / length, dx / length)
            if normal[1] < 0:
                normal = (-normal[0], -normal[1])
            inside = not ((k == 0 and along < 0) or
                          (k == len(line) - 2 and along > 1))
            sign = rx * normal[0] + ry * normal[1]
            best = (distance, normal, math.copysign(distance, sign),
                    tuple(a[d] + clipped * (b[d] - a[d]) for d in (2, 3)),
                    inside)
    return best[1:]


def not_numbers(summary, found, path=""):
    if isinstance(summary, dict):
        for key, value in summary.items():
            not_numbers(value, found, path + "/" + key)
    elif isinstance(summary, list):
        for i, value in enumerate(summary):
            not_numbers(value, found, path + "/%d" % i)
    elif isinstance(summary, float) and not math.isfinite(summary):
        found.append(path)
    return found


def problems(scene, directory, summary):
    """What is wrong with the results; nothing, if all is well."""
    if summary is None:
        return ["summary.json cannot be read"]
    found = ["not a number in summary.json: " + path
             for path in not_numbers(summary, [])]
    if not summary["converged"]:
        found.append("exit status 0, but the summary has not converged")
    try:
        slave, master = rows_of(directory, scene)
    except (OSError, ValueError) as error:
        return found + ["profile.csv cannot be read: %s" % error]
    if any(not math.isfinite(v) for row in slave + master
           for v in row.values()):
        return found + ["not a number in profile.csv"]
    found += check_tractions(scene, slave)
    found += check_penetration(scene, slave, master)
    found += check_forces(scene, slave, master, summary)
    return found


def check_tractions(scene, slave):
    found = []
    largest = max((abs(r["pressure_MPa"]) for r in slave), default=0)
    # Round-off of bodies which do not touch any more.
    if largest < 1e-9 * scene.traction:
        return found
    # With quadratic elements and the Gauss rule a multiplier at a node may be
    # negative although every point presses.
    lowest = min((r["pressure_MPa"] for r in slave), default=0)
    if scene.features["rule"] != "Gauss" and lowest < -TRACTION * largest:
        found.append("negative pressure %.3g, largest %.3g" % (lowest, largest))
    if scene.features["rule"] == "Gauss":
        return found
    for r in slave:
        p, q = r["pressure_MPa"], r["shear_MPa"]
        bound = scene.tresca + scene.mu * p
        status = r["status_0_open_1_slip_2_stick"]
        # On a line of symmetry there is nothing to slip.
        is_held = (scene.features["support"] == "roller" and q == 0 and
                   abs(r["displacement_x_mm"]) < 1e-12 * scene.size)
        small = TRACTION * max(largest * max(scene.mu, 0.1), scene.tresca)
        if status < 1 and max(abs(p), abs(q)) > TRACTION * largest:
            found.append("tractions %.3g, %.3g at an open node, largest %.3g" %
                         (p, q, largest))
        elif status >= 1 and abs(q) > bound + small:
            found.append("shear %.6g above its bound %.6g" % (q, bound))
        elif status == 1 and not is_held and abs(abs(q) - bound) > small:
            found.append("shear %.6g of a slipping node below its bound %.6g" %
                         (q, bound))
        elif (status == 1 and not is_held and bound > small and
              q * r["slip_mm"] > small * 1e-3 * scene.size):
            found.append("shear along the slip")
        elif status == 2 and abs(r["slip_mm"]) > 1e-6 * scene.size:
            found.append("slip %.3g of a sticking node" % r["slip_mm"])
        else:
            continue
        break
    return found


def surface_displacement(rows):
    """The largest displacement, and the largest difference of two."""
    u = [(r["displacement_x_mm"], r["displacement_y_mm"]) for r in rows]
    largest = max(math.hypot(*v) for v in u)
    spread = max(max(v[d] for v in u) - min(v[d] for v in u) for d in (0, 1))
    return largest, spread


def gap_of(scene, row, line, up, deformed):
    """None beside the master, and where a node of the slave is not meant to be
    near it."""
    normal, distance, u, inside = foot(place(row, deformed), line)
    if not inside or abs(distance) > 0.3 * scene.lower_height:
        return None
    gap = up * distance
    if not deformed:
        gap += up * ((row["displacement_x_mm"] - u[0]) * normal[0] +
                     (row["displacement_y_mm"] - u[1]) * normal[1])
    return gap


def check_penetration(scene, slave, master):
    deformed = scene.features["geometry"] != "undeformed"
    line = polyline(master, scene.features["degree"], deformed)
    up = 1 if scene.slave_is_upper else -1
    largest = max(surface_displacement(slave)[0],
                  surface_displacement(master)[0])
    edge = max(math.dist(place(a, False), place(b, False))
               for a, b in zip(slave, slave[1:]))
    master_edge = max(math.dist(place(a, False), place(b, False))
                      for a, b in zip(master, master[1:]))
    rule = scene.features["rule"]
    allowed = PENETRATION[rule] * largest + 1e-9 * scene.size
    if rule == "nodal":
        lowest = min((gap for row in slave
                      for gap in [gap_of(scene, row, line, up, deformed)]
                      if gap is not None), default=0)
    else:
        # The mean over the pressure: single places may be inside, as the gap
        # is weighted along the surface, of edges which do not match.
        moment = force = 0.0
        for a, b in zip(slave, slave[1:]):
            for k in range(16):
                s = (k + 0.5) / 16
                row = {key: (1 - s) * a[key] + s * b[key] for key in a}
                gap = gap_of(scene, row, line, up, deformed)
                p = max(0.0, row["pressure_MPa"])
                length = math.dist(place(a, False), place(b, False))
                if gap is not None:
                    moment += p * gap * length
                    force += p * length
        if force == 0:
            return []
        lowest = moment / force
        if scene.radius:
            allowed += max(edge, master_edge) ** 2 / (4 * scene.radius)
    if lowest < -allowed:
        return ["penetration %.3g mm, %.2g of the largest displacement, %.2g of "
                "an edge" % (-lowest, -lowest / max(largest, 1e-300),
                             -lowest / edge)]
    return []


def check_forces(scene, slave, master, summary):
    """The resultant on the upper body against its loads, and the resultants of
    both sides against each other."""
    found = []
    on_slave = sum(r["nodal_force_N_per_mm"] for r in slave)
    on_master = sum(r["nodal_force_N_per_mm"] for r in master)
    scale = sum(abs(r["nodal_force_N_per_mm"]) for r in slave)
    if abs(abs(on_slave) - abs(on_master)) > 1e-6 * scale:
        found.append("nodal forces %.8g on the slave, %.8g on the master" %
                     (on_slave, on_master))
    if scene.force_y is None:
        return found
    deformed = scene.features["geometry"] != "undeformed"
    line = polyline(master, scene.features["degree"], deformed)
    up = 1 if scene.slave_is_upper else -1
    total = [0.0, 0.0]
    for row in slave:
        p, q = row["pressure_MPa"], row["shear_MPa"]
        force = row["nodal_force_N_per_mm"]
        normal, _, _, _ = foot(place(row, deformed), line)
        n = (up * normal[0], up * normal[1])
        t = (-n[1], n[0])
        shear = q * force / p if p > 0 else 0.0
        for d in (0, 1):
            total[d] += force * n[d] + shear * t[d]
    # The force on the upper body.
    total = [up * c for c in total]
    # A flat contact knows its normal exactly; otherwise ours is that of a
    # polyline, or of the nodes instead of the points.
    exact = (scene.features["shape"] == "blocks" and not deformed and
             scene.features["rule"] != "Gauss")
    tolerance = FORCE if exact else 0.03 + 0.1 * scene.mu
    for name, is_, load in (("y", total[1], scene.force_y),
                            ("x", total[0], scene.force_x)):
        if load is not None and abs(is_ + load) > tolerance * max(
                abs(scene.force_y), abs(load)):
            found.append("contact force %s %.8g, load %.8g" % (name, is_, load))
    return found
