# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hard cases, and what must hold in each."""


class Case:
    """A case and what must hold.

    same: a case whose probes and contact results are the same, lengths times
    `lengths` and forces times `forces`, within `tolerance` (relative; of the
    forces alone if `forces_only`, for what is turned).
    zone_only: of forces, peak pressure and width of contact alone, where bodies
    come from elsewhere.
    informative: that difference is shown, but nothing is asked of it.
    loop: (coefficient of friction, modulus E*) of two equal cylinders, for the
    energy that Cattaneo and Mindlin's theory says is dissipated, within 10 %
    (the theory's own error, a/R = 0.024, and that of the mesh).
    levels: several meshes, each from the start.
    normal_force: what it has to be at the end [N per mm], within 3 %: the
    integral of the pressure, which on a round surface is a little more than the
    load.
    force_free: the normal force at the end is at most this [N per mm]; in all
    other cases it has to be positive, or nothing was proved.
    frictionless: has no friction, so the loops of it are one.
    lift: the sum of the reactions along z at the end, by statics [N].
    full_slip: the coefficient of friction, in 3-D where all of the surface
    slips: the tangential force is that times the normal force, within 1 %
    (shears of one direction add up, and those of nodes differ by a little).
    unsolved: the rules that are known not to converge; the file says why.
    quick: part of --quick.
    Cases in 3-D are named space_...; the Gauss-point rule is refused there.
    """

    def __init__(self, name, same=None, tolerance=1e-8, lengths=1.0, forces=1.0,
                 forces_only=False, normal_force=None, force_free=None, frictionless=False,
                 quick=False, informative=False, zone_only=False, levels=False,
                 loop=None, lift=None, full_slip=None, unsolved=()):
        self.name = name
        self.same = same
        self.tolerance = tolerance
        self.lengths = lengths
        self.forces = forces
        self.forces_only = forces_only
        self.normal_force = normal_force
        self.force_free = force_free
        self.frictionless = frictionless
        self.quick = quick
        self.informative = informative
        self.zone_only = zone_only
        self.levels = levels
        self.loop = loop
        self.lift = lift
        self.unsolved = unsolved
        self.full_slip = full_slip
        self.in_space = name.startswith("space_")


CASES = [
    Case("first_touch", normal_force=8750, frictionless=True, quick=True),
    Case("gap_0.1", normal_force=8750, frictionless=True, same="first_touch",
         zone_only=True, tolerance=1e-4),
    Case("gap_10", normal_force=8750, frictionless=True, same="first_touch",
         zone_only=True, tolerance=1e-4),
    Case("pin", frictionless=True),
    Case("pin_loose", frictionless=True),
    Case("pin_friction"),
    Case("pin_play"),
    Case("pin_tight"),
    Case("one_element", quick=True),
    Case("cycle"),
    Case("friction_0.3", quick=True),
    Case("friction_0.6"),
    Case("friction_1"),
    Case("friction_2"),
    Case("friction_2_path", same="friction_2", informative=True),
    Case("nu_0.49"),
    Case("nu_0.4999"),
    Case("fine_slave"),
    Case("fine_master"),
    Case("swapped"),
    Case("upper_soft"),
    Case("upper_stiff"),
    Case("run_off_right"),
    Case("run_off_left", force_free=1e-8),
    Case("symmetry_friction", quick=True),
    Case("unload", frictionless=True, force_free=1e-6 * 8750),
    Case("unload_reload", normal_force=8750, frictionless=True, same="first_touch",
         tolerance=1e-4),
    Case("reversal", loop=(0.3, 210000 / (2 * (1 - 0.3**2)))),
    Case("triangles", quick=True),
    Case("hanging", levels=True),
    Case("penetration_small", quick=True),
    Case("penetration_edge"),
    Case("deep_5", frictionless=True),
    Case("deep_20", frictionless=True),
    Case("zero_load", force_free=1e-12, quick=True),
    Case("lengths_1e-6", same="friction_0.3", lengths=1e-6, forces=1e-6,
         quick=True),
    Case("lengths_1e6", same="friction_0.3", lengths=1e6, forces=1e6,
         quick=True),
    Case("unturned"),
    Case("turned", same="unturned", forces_only=True),
    Case("space_first_touch", normal_force=200, lift=200, frictionless=True,
         quick=True),
    Case("space_gap_0.1", lift=200, frictionless=True, same="space_first_touch",
         zone_only=True, tolerance=1e-4),
    Case("space_gap_10", lift=200, frictionless=True, same="space_first_touch",
         zone_only=True, tolerance=1e-4),
    Case("space_ball_push"),
    Case("space_ball_free", lift=60, frictionless=True,
         unsolved=("nodal", "mortar")),
    Case("space_ball_free_friction", lift=60, unsolved=("nodal", "mortar")),
    Case("space_pin", unsolved=("nodal",)),
    Case("space_pin_smooth", frictionless=True, unsolved=("nodal", "mortar")),
    Case("space_edge"),
    Case("space_corner", quick=True),
    Case("space_two_supports", lift=200),
    Case("space_tilted", lift=500, unsolved=("mortar",)),
    Case("space_tilted_smooth", lift=500, frictionless=True,
         unsolved=("nodal", "mortar")),
    Case("space_one_element"),
    Case("space_friction_0.3", full_slip=0.3, quick=True),
    Case("space_friction_1", full_slip=1),
    Case("space_quadratic", full_slip=0.3),
    Case("space_levels", full_slip=0.3, levels=True),
    Case("space_nu_0.4999"),
    Case("space_upper_soft"),
    Case("space_upper_stiff"),
    Case("space_swapped"),
    Case("space_fine_slave"),
    Case("space_fine_master", unsolved=("nodal",)),
    # Nodal: corners of the master go down between two nodes, which is violated.
    Case("space_overlap", quick=True, unsolved=("nodal",)),
    Case("space_rim"),
    Case("space_rim_off", force_free=1e-8),
    Case("space_reversal", full_slip=0.3),
    Case("space_reversal_90", full_slip=0.3),
    Case("space_circle", full_slip=0.3),
    Case("space_unload", force_free=1e-6),
    Case("space_penetration"),
    Case("space_zero_load", force_free=1e-12),
    Case("space_lengths_1e-6", same="space_friction_0.3", lengths=1e-6,
         forces=1e-12),
    Case("space_lengths_1e6", same="space_friction_0.3", lengths=1e6,
         forces=1e12),
    Case("space_unturned"),
    Case("space_turned", same="space_unturned", forces_only=True),
]
