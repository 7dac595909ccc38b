# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed forms of contact in 3-D, for the scripts beside this one and for the
references in parameters/verification/3d. Lengths in mm, forces in N, stresses
in MPa. Equations are those of K. L. Johnson, Contact Mechanics (1985), where
they are numbered; the others are derived where they stand."""

import dataclasses
import math

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk


@dataclasses.dataclass
class Hertz:
    """Spheres: 1/radius = 1/R1 + 1/R2, 1/modulus = sum of (1 - nu^2)/E over the
    bodies. Johnson, equations (4.22) to (4.24)."""

    radius: float
    modulus: float
    approach: float

    @property
    def a(self):
        return math.sqrt(self.radius * self.approach)

    @property
    def force(self):
        return 4 / 3 * self.modulus * math.sqrt(self.radius) * self.approach**1.5

    @property
    def p0(self):
        return 2 * self.modulus / math.pi * math.sqrt(self.approach / self.radius)

    def pressure(self, r):
        return self.p0 * np.sqrt(np.maximum(0, 1 - (r / self.a)**2))

    @classmethod
    def of_force(cls, radius, modulus, force):
        return cls(radius, modulus,
                   (3 * force / (4 * modulus * math.sqrt(radius)))**(2 / 3))


@dataclasses.dataclass
class Mindlin:
    """Equal spheres under a normal force, which then stays, and a tangential one
    Q: shift is that of the bodies against each other, in direction x. Johnson,
    section 7.2 (b), with (7.42) for the shift. Exact for nu = 0 only, where
    slip is along x everywhere; theory has shears along x for any nu."""

    hertz: Hertz
    friction: float
    shear_modulus: float
    poisson: float
    shift: float

    @property
    def compliance(self):
        """Shift at the beginning of sliding."""
        return (3 * self.friction * self.hertz.force / (16 * self.hertz.a)
                * 2 * (2 - self.poisson) / self.shear_modulus)

    @property
    def stick(self):
        return self.hertz.a * math.sqrt(1 - self.shift / self.compliance)

    @property
    def force(self):
        return self.friction * self.hertz.force * (
            1 - (self.stick / self.hertz.a)**3)

    @classmethod
    def of_force(cls, hertz, friction, shear_modulus, poisson, force):
        stick = hertz.a * (1 - force / (friction * hertz.force))**(1 / 3)
        sliding = cls(hertz, friction, shear_modulus, poisson, 0.).compliance
        return cls(hertz, friction, shear_modulus, poisson,
                   sliding * (1 - (stick / hertz.a)**2))

    def shear(self, r):
        inside = np.sqrt(np.maximum(0, 1 - (r / self.stick)**2))
        return self.friction * (self.hertz.pressure(r) - self.hertz.p0
                                * self.stick / self.hertz.a * inside)


@dataclasses.dataclass
class Lubkin:
    """A sphere that is pressed on another one or on a plane, then twisted about
    their normal: the middle sticks within the radius c = stick, q = mu p beyond.
    J. L. Lubkin, J. Appl. Mech. 18 (1951) 183; here by Abel transforms.

    With phi on 0 < t < a the half space has the shear and the displacement
      q(r) = -d/dr integral_r^a phi/sqrt(t^2 - r^2) dt,
      G u(r) = 1/r integral_0^r t phi/sqrt(r^2 - t^2) dt
    (Hankel transforms of J_1 with the density integral of phi(t) sin(xi t)).
    u = twist r within c gives phi = 4/pi G twist t there, q = mu p beyond c
    gives phi = 2/pi mu p0 t (K - E)(k), k^2 = 1 - (t/a)^2. Where both are equal
    at c the shear is bounded: twist = mu p0 (K - E)/(2 G) of each half space,
    and the torque is 4 pi integral of t phi over 0 < t < a."""

    hertz: Hertz
    friction: float
    shear_modulus: float
    stick: float

    def density(self, t):
        m = 1 - (t / self.hertz.a)**2
        return (2 / math.pi * self.friction * self.hertz.p0
                * (ellipk(m) - ellipe(m)))

    @property
    def twist(self):
        """Of one body against the surface of contact."""
        return math.pi / 4 * self.density(self.stick) / self.shear_modulus

    @property
    def torque(self):
        outer = quad(lambda t: t * t * self.density(t), self.stick,
                     self.hertz.a)[0]
        return 4 * math.pi * (self.density(self.stick) * self.stick**3 / 3
                              + outer)

    def shear(self, r):
        """-r times the integral of (phi/t)'/sqrt(t^2 - r^2) over c < t < a where
        the surfaces stick; d(K - E)/dm = E/(2 (1 - m))."""
        if r >= self.stick:
            return self.friction * float(self.hertz.pressure(r))
        a = self.hertz.a

        def integrand(t):
            m = 1 - (t / a)**2
            slope = ellipe(m) / (2 * (1 - m)) * 2 * t / a**2
            return slope / math.sqrt(t * t - r * r)
        return (2 / math.pi * self.friction * self.hertz.p0 * r
                * quad(integrand, self.stick, a, epsrel=1e-9)[0])

    @classmethod
    def of_torque(cls, hertz, friction, shear_modulus, torque):
        def excess(c):
            return cls(hertz, friction, shear_modulus, c).torque - torque
        return cls(hertz, friction, shear_modulus,
                   brentq(excess, 1e-6 * hertz.a, (1 - 1e-9) * hertz.a))


@dataclasses.dataclass
class Ellipse:
    """Bodies with the gap x^2/(2 R_x) + y^2/(2 R_y), R_x > R_y: the contact is
    an ellipse with half axes a > b along x and y. Johnson, equations (4.26) to
    (4.28) with e^2 = 1 - (b/a)^2:
      1/(2 R_x) = p0/modulus b/(e^2 a^2) (K - E),
      1/(2 R_y) = p0/modulus b/(e^2 a^2) ((a/b)^2 E - K),
      approach = p0/modulus b K,   force = 2/3 pi a b p0."""

    radius_x: float
    radius_y: float
    modulus: float
    approach: float

    def __post_init__(self):
        def ratio(m):
            k, e = ellipk(m), ellipe(m)
            return (e / (1 - m) - k) / (k - e) - self.radius_x / self.radius_y
        m = brentq(ratio, 1e-12, 1 - 1e-12, xtol=1e-15)
        k, e = ellipk(m), ellipe(m)
        # 1/(2 R_x) = approach (K - E)/(K m a^2).
        self.a = math.sqrt(2 * self.radius_x * self.approach * (k - e) / (k * m))
        self.b = self.a * math.sqrt(1 - m)
        self.p0 = self.approach * self.modulus / (self.b * k)
        self.force = 2 / 3 * math.pi * self.a * self.b * self.p0

    def pressure(self, x, y):
        return self.p0 * np.sqrt(np.maximum(
            0, 1 - (x / self.a)**2 - (y / self.b)**2))


@dataclasses.dataclass
class HollowSphere:
    """Lame's solution (S. P. Timoshenko and J. N. Goodier, Theory of Elasticity,
    1970, section 136): u = A r + B/r^2."""

    inner: float
    outer: float
    young: float
    poisson: float
    inner_pressure: float
    outer_pressure: float

    def displacement(self, r):
        a3, b3 = self.inner**3, self.outer**3
        p, q, nu = self.inner_pressure, self.outer_pressure, self.poisson
        return (r / self.young * ((1 - 2 * nu) * (p * a3 - q * b3)
                                  + (1 + nu) * (p - q) * a3 * b3 / (2 * r**3))
                / (b3 - a3))

    def energy(self):
        """Half the work of the pressures, of the whole sphere."""
        return 2 * math.pi * (
            self.inner_pressure * self.inner**2 * self.displacement(self.inner)
            - self.outer_pressure * self.outer**2
            * self.displacement(self.outer))


def nested_spheres(radii, youngs, poissons, pressure):
    """Two hollow spheres that touch without gap at radii[1], under a pressure
    within: both, inner and outer one."""
    def bodies(contact):
        return (HollowSphere(radii[0], radii[1], youngs[0], poissons[0],
                             pressure, contact),
                HollowSphere(radii[1], radii[2], youngs[1], poissons[1],
                             contact, 0.))

    def gap(contact):
        inner, outer = bodies(contact)
        return outer.displacement(radii[1]) - inner.displacement(radii[1])
    return bodies(brentq(gap, 0, pressure, xtol=1e-14 * pressure))
