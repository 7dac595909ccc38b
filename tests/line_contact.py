# SPDX-License-Identifier: LGPL-2.1-or-later
"""The closed form of a cylinder on a block in plane strain, for the scripts
beside this one; with friction, and errors: closed_forms/. Lengths in mm, forces
in N per mm of thickness, stresses in MPa. K. L. Johnson, Contact Mechanics
(1985), section 4.2 (c) and equation (5.56)."""

import dataclasses
import math


@dataclasses.dataclass
class Hertz:
    """The force is that of the full cylinder; bodies are (E, nu)."""

    radius: float
    force: float
    cylinder: tuple
    block: tuple

    @property
    def half_width(self):
        compliance = sum((1 - nu**2) / E for E, nu in (self.cylinder, self.block))
        return math.sqrt(4 * self.force * self.radius * compliance / math.pi)

    @property
    def max_pressure(self):
        return 2 * self.force / (math.pi * self.half_width)

    @property
    def approach(self):
        """How far the centre of the cylinder approaches the contact."""
        young, poisson = self.cylinder
        return (self.force * (1 - poisson**2) / (math.pi * young) *
                (2 * math.log(4 * self.radius / self.half_width) - 1))


def ssnp154(force):
    """The bodies of parameters/ssnp154.prm."""
    return Hertz(50, force, (210000, 0.3), (70000, 0.3))
