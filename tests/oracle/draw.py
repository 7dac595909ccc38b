"""What all kinds of scenes draw: materials, sizes, rules, loops."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import math
import random

import materials
from scene import RAMP

# Steel, aluminium, concrete, wood, hard and soft plastics, rubber: E, nu.
MATERIALS = ((210000, 0.3), (70000, 0.33), (30000, 0.2), (10000, 0.1),
             (2500, 0.38), (500, 0.42), (5, 0.49))


def log_uniform(rng, low, high):
    return round_to(math.exp(rng.uniform(math.log(low), math.log(high))))


def round_to(x, digits=4):
    return float("%.*g" % (digits, x))


def uniform(rng, low, high):
    return round_to(rng.uniform(low, high))


def size(rng):
    """Of a scene in mm: from small parts to buildings."""
    return rng.choice([1.0, 10.0, 10.0, 100.0, log_uniform(rng, 0.1, 3000)])


def material(rng, soft=True):
    return rng.choice(MATERIALS if soft else MATERIALS[:-2])


def split(rng):
    """Triangles: nowhere, everywhere, in part of a body."""
    choice = rng.random()
    if choice < 0.7:
        return None
    if choice < 0.85:
        return lambda x, y: True
    return lambda x, y: math.sin(7 * x + 3 * y) > 0


def friction(rng, low=0.0):
    return rng.choice([mu for mu in (0.0, 0.0, 0.1, 0.2, 0.3, 0.5)
                       if mu >= low])


def triangles(scene):
    return any(kind == "triangle" for _, kind in scene.mesh.cells)


def settle(rng, scene, increments=(1, 2, 4), large=None):
    """Degree, kinematics, rule and increments; a quarter of the scenes gets
    other loops, rules and systems than the default."""
    scene.rule = rng.choice(["mortar", "nodal"])
    entries = scene.entries
    if large is None:
        large = rng.random() < 0.6
    if not large:
        entries["Solids/Kinematics"] = "small strain"
    # Points of the stiffness of curved or rings' triangles of degree 2 are
    # nobody's convention.
    if rng.random() < 0.25 and not (triangles(scene) and (
            large or scene.axisymmetric)):
        entries["Element/Degree"] = 2
    entries["Solution/Increments"] = rng.choice(increments)
    if rng.random() < 0.25:
        other_loops(rng, scene)
    if scene.rule == "nodal":
        prefer_finer(scene)
    return scene


def prefer_finer(scene):
    """A body does not stand on a node or two: the other surface is the slave
    where too few nodes of this one face it."""
    X = scene.mesh.X
    for zone in scene.zones:
        if zone.obstacle:
            continue
        slave, master = ({n for line in scene.mesh.lines[name] for n in line}
                         for name in (zone.slave, zone.master))
        low, high = X[list(master)].min(0), X[list(master)].max(0)
        size = 0.01 * scene.size
        facing = [n for n in slave if (X[n] > low - size).all() and
                  (X[n] < high + size).all()]
        if len(facing) < 3 and len(master) > len(facing):
            zone.slave, zone.master = zone.master, zone.slave


def other_loops(rng, scene):
    entries = scene.entries
    scene.is_default = False
    scene.rule = rng.choice(["mortar", "nodal", "Gauss"])
    loops = ["fixed point", "each step"]
    system = rng.choice(["automatic", "saddle point", "condensed"])
    if scene.rule == "Gauss" and system == "condensed":
        system = "saddle point"
    shares_nodes = len(scene.zones) > 1
    if shares_nodes:
        system = "automatic"
    if system != "automatic":
        entries["Solution/System"] = system
    if system == "condensed":
        entries["Solution/Linear solver"] = rng.choice(["CHOLMOD", "AMG"])
    geometry = list(loops)
    friction_loops = ["fixed point", "Newton"]
    if system == "saddle point":
        if scene.rule != "mortar":
            geometry.append("Newton")
    if not scene.large:
        geometry.append("undeformed")
    entries["Solution/Geometry"] = rng.choice(geometry)
    if any(zone.mu for zone in scene.zones):
        entries["Solution/Friction"] = rng.choice(friction_loops)
    if rng.random() < 0.2:
        entries["Solids/Dilatation"] = rng.choice(["full", "B-bar"])


def swap(rng, a, b):
    """Which of two surfaces is the slave."""
    return (a, b) if rng.random() < 0.5 else (b, a)


def some(rng, names):
    return [n for n in names if rng.random() < 0.7] or [names[0]]


# Laws of materials.py.
def plastic_law(rng, young, poisson, hardens=False):
    """Yields at a strain of 0.05 to 0.5 %; perfectly plastic at times unless it
    has to harden; one in four by a curve."""
    initial = round_to(young * math.exp(rng.uniform(math.log(5e-4),
                                                    math.log(5e-3))))
    modulus = lambda: round_to(young * log_uniform(rng, 2e-3, 0.2))
    choice = rng.choice(["linear", "linear", "kinematic", "both", "Voce", "all"]
                        + ([] if hardens else ["perfect"]))
    keywords = {}
    if choice in ("linear", "both", "all"):
        keywords["linear"] = modulus()
    if choice in ("kinematic", "both", "all"):
        keywords["kinematic"] = modulus()
    if choice in ("Voce", "all"):
        keywords["saturation"] = round_to(initial * rng.uniform(1.1, 2.5))
        keywords["rate"] = log_uniform(rng, 5, 300)
        if choice == "Voce":
            keywords["linear"] = round_to(2e-3 * young)
    # Drawn apart: scenes that are known by their numbers stay what they are.
    own = random.Random("curve %r %r" % (initial, keywords))
    if own.random() < 0.25:
        keywords = {"curve": hardening_curve(own, initial, young, hardens),
                    "kinematic": keywords.get("kinematic", 0.0)}
    return materials.Plastic(young, poisson, initial, **keywords)


def hardening_curve(rng, initial, young, hardens):
    """One to five pairs of plastic strain and yield stress, with steps of any
    size, of the stress none at times."""
    strain, stress, pairs = 0.0, initial, []
    for _ in range(rng.randint(1, 5)):
        strain = round_to(strain + log_uniform(rng, 2e-4, 2e-2))
        stress = round_to(stress + rng.choice([0, 1, 1]) * rng.uniform(
            0.02, 0.5) * initial)
        pairs.append((strain, stress))
    if hardens:
        pairs.append((strain + 0.1, round_to(max(2 * stress, 4 * initial,
                                                 stress + 2e-4 * young))))
    return tuple(pairs)


def rubber_law(rng, young, poisson):
    if rng.random() < 0.5:
        return materials.Rubber(young, poisson)
    half = young / (4 * (1 + poisson))
    return materials.Rubber(young, poisson, round_to(rng.uniform(0.05, 0.9) *
                                                     half))


# Moduli and ratios of rubber and foams.
RUBBERS = ((5, 0.49), (2, 0.499), (10, 0.45), (1, 0.3), (8, 0.4))


def plastic_bodies(rng, scene, names, hardens=False):
    for name in names:
        scene.laws[name] = plastic_law(rng, *scene.materials[name],
                                       hardens=hardens)
    return in_small_strain(scene)


def in_small_strain(scene):
    """All bodies, where some yield; degree 2 in a single increment: nobody knows
    the middles of edges in between."""
    scene.entries["Solids/Kinematics"] = "small strain"
    if scene.degree == 2:
        scene.entries["Solution/Increments"] = 1
        scene.histories = {entry: RAMP for entry in scene.histories}
    return scene


def settle_new(rng, scene, increments, share):
    """Settled; this share of the scenes gets other materials."""
    settle(rng, scene, increments)
    scene.middles_in = "Nodes"
    return new_bodies(rng, scene) if rng.random() < share else scene


def new_bodies(rng, scene, kinds=("plastic", "rubber")):
    """Some bodies get one of the laws, all one kind of them. Degree 2 is judged
    by the file of the nodes."""
    scene.middles_in = "Nodes"
    names = [n for n in scene.materials if rng.random() < 0.7] or list(
        scene.materials)[:1]
    if rng.choice(kinds) == "plastic":
        return plastic_bodies(rng, scene, names)
    scene.entries.pop("Solids/Kinematics", None)
    if scene.undeformed:
        # Which small strain alone allows.
        del scene.entries["Solution/Geometry"]
    for name in names:
        scene.materials[name] = rng.choice(RUBBERS)
        scene.laws[name] = rubber_law(rng, *scene.materials[name])
    if rng.random() < 0.3:
        scene.kinematics = {n: "small strain" for n in scene.materials
                            if n not in names}
    return scene
