#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A rigid roller driven over an elastic block: Carter's line contact.

Proves that a roller which turns faster than it rolls, by a creepage xi, exerts in
the steady state the tangential force and the shear of Carter (Proc. R. Soc. A 112
(1926) 151; K. L. Johnson, Contact Mechanics, 1985, section 8.3). The block is
incompressible, so that normal and tangential problem are not coupled (Dundurs'
beta = 0), E* = E/(1 - nu^2); with the force P of the roller of radius R

    a^2 = 4 P R/(pi E*),  p0 = 2 P/(pi a),  p = p0 sqrt(1 - (x/a)^2),
    q = mu p - mu p0 (c/a) sqrt(1 - ((x - d)/c)^2)  where |x - d| < c,
    d = a - c,  xi = mu d/R,  Q = mu P (1 - (c/a)^2),

x in the direction of rolling: it sticks where it enters, over the width 2 c. The
block is 33 half widths a deep and the way 8 long. The steady state is approached
over several a; the roller is therefore turned on the spot first, to about the
same force. What is left of the approach at the end is about 2 % of Q.

With nodes that come into contact one by one, shears in the stick zone alternate
from node to node about the mean, by an amount that falls with the root of the
edges only: compared is the mean of each node and its neighbors by 1, 2, 1.

Usage: rolling.py CONTACT PARAMETERS MESHES
"""

import math
import sys

from block_scenes import Mesh, check, failures, rows, run, violations

R, MU, MODULUS, RATIO = 200., 0.3, 1000., 0.499
STIFFNESS = MODULUS / (1 - RATIO**2)
DEPTH, WAY, EDGE = 40., 10., 1 / 24
CREEPAGE = MU * 0.5 / R
PRESSED, TURNED = 0.0137, 0.0052  # before it rolls [mm]


def away(end):
    """From EDGE on edges that grow by a quarter."""
    ends, edge = [0.], EDGE
    while ends[-1] < end:
        edge *= 1.25
        ends.append(min(ends[-1] + edge, end))
    return ends[1:]


def roll():
    n = round((WAY + 3.5) / EDGE)
    xs = [-1.5 - x for x in away(DEPTH)][::-1] + \
        [-1.5 + i * EDGE for i in range(n + 1)]
    xs += [xs[-1] + x for x in away(DEPTH)]
    ys = [-y for y in away(DEPTH)][::-1] + [0.]
    mesh = Mesh()
    mesh.block("Block", len(xs) - 1, len(ys) - 1,
               lambda s, t: (xs[round(s * (len(xs) - 1))],
                             ys[round(t * (len(ys) - 1))]),
               {"bottom": "Bottom", "top": "Top"})
    mesh.write("rolling")
    steps, pressing = round(WAY / EDGE), 4
    start = pressing / (steps + pressing)
    way = f"{WAY}*max(0, t - {start!r})/{1 - start!r}"
    degrees = 180 / math.pi / R
    status, said, summary = run("rolling", {
        "Mesh/File": "rolling.msh", "Element/Degree": 1,
        "Solids/Young's modulus": f"Block: {MODULUS}",
        "Solids/Poisson's ratio": f"Block: {RATIO}",
        "Solids/Kinematics": "small strain",
        "Boundary conditions/Displacement x": "Bottom: 0",
        "Boundary conditions/Displacement y": "Bottom: 0",
        "Contact/Slave": "Top", "Contact/Friction coefficient": MU,
        "Contact/Obstacle": f"circle: 0, {R}, {R}",
        "Contact/Obstacle motion":
        f"x: {way}; y: {-PRESSED}*min(1, t/{start!r}); "
        f"angle: {-degrees!r}*({1 + CREEPAGE!r}*{way} + "
        f"{TURNED}*max(0, min(1, 2*t/{start!r} - 1)))",
        "Solution/Increments": steps + pressing, "Output/Profile": "true"})
    check("rolling converges, and no invariant is violated", status == 0 and
          not violations(summary), said)
    zones = [i["contact"].get("", i["contact"]) for i in summary["increments"]]
    for k in range(pressing - 1, len(zones), len(zones) // 8):
        print(f"  way {summary['increments'][k]['load_factor']:.3f}, Q/(mu P)",
              zones[k]["obstacle_force_x"] / zones[k]["obstacle_force_y"] / MU)
    return zones[-1]


def compare(zone):
    P, Q = -zone["obstacle_force_y"], -zone["obstacle_force_x"]
    a = math.sqrt(4 * P * R / math.pi / STIFFNESS)
    p0, d = 2 * P / math.pi / a, CREEPAGE * R / MU
    c = a - d

    def shear(x):
        p = math.sqrt(max(0., 1 - (x / a)**2))
        q = c / a * math.sqrt(max(0., 1 - ((x - d) / c)**2))
        return MU * p0 * (p - q)
    found = MU * a / R * (1 - math.sqrt(1 - Q / MU / P))
    print(f"  a {a:.4f} mm, c/a {c / a:.3f}, Q/(mu P) {Q / MU / P:.4f}, Carter "
          f"{1 - (c / a)**2:.4f}, creepage {CREEPAGE:.4e}, by Q {found:.4e}")
    check("rolling: Carter's creepage of this force",
          abs(found / CREEPAGE - 1) < 0.05, f"{found / CREEPAGE - 1:+.1%}")
    top = [(row["X_mm"] - WAY, -row["shear_MPa"], shear(row["X_mm"] - WAY))
           for row in rows("rolling") if row["surface"] == "slave"]
    top.sort()
    peak = max(shear(k * a / 1000) for k in range(-1000, 1000))
    worst = 0.
    for before, here, after in zip(top, top[1:], top[2:]):
        x = here[0]
        # Not at the ends of contact and of sticking.
        if min(abs(x - a), abs(x + a), abs(x - (d - c))) < 0.1 * a:
            continue
        mean = [(before[k] + 2 * here[k] + after[k]) / 4 for k in (1, 2)]
        worst = max(worst, abs(mean[0] - mean[1]) / peak)
    check("rolling: Carter's shear, by its peak", worst < 0.03, f"{worst:.1%}")


compare(roll())
print(len(failures), "failures")
sys.exit(1 if failures else 0)
