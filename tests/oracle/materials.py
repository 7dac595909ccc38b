"""Materials that are not linear elastic, as functions of strains in 3-D.

A law has the energy W = shear part(E, history) + U(d(E)) by undeformed volume,
E the small strain or that of Green and Lagrange, d a measure of volume; the
elements put its projection P d in the place of d. All functions take arrays of
points, (..., 3, 3), and complex numbers: tangents are derivatives by complex
steps. Elastic-plastic bodies after J. C. Simo and T. J. R. Hughes, Computational
Inelasticity, 1998, boxes 3.1 and 3.2; rubber after sections 9.2 and 9.3."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np

ONE = np.eye(3)
# Of the yield stress: a state that was returned is not returned again.
RETURNED = 1e-12


def trace(A):
    return np.trace(A, axis1=-2, axis2=-1)


def deviator(A):
    return A - trace(A)[..., None, None] / 3 * ONE


def times(a, A):
    return np.asarray(a)[..., None, None] * A


def lame(young, poisson):
    return (young * poisson / ((1 + poisson) * (1 - 2 * poisson)),
            young / (2 * (1 + poisson)))


class Elastic:
    """Linear, in large displacement St. Venant and Kirchhoff's: d is tr E."""

    has_history = False

    def __init__(self, young, poisson):
        self.lame, self.mu = lame(young, poisson)

    def entries(self):
        """The entries of the section Solids besides modulus and ratio."""
        return {}

    def start(self, shape):
        return None

    def shear(self, E, history):
        return 2 * self.mu * E

    def shear_energy(self, E):
        return self.mu * (E * E).sum((-2, -1))

    def volume(self, E):
        """d and its derivative."""
        return trace(E), np.broadcast_to(ONE, E.shape)

    def pressure(self, d):
        """U'(d)."""
        return self.lame * d

    def volume_energy(self, d):
        return self.lame * d * d / 2


class Rubber(Elastic):
    """Neo-Hookean or of Mooney and Rivlin: C10 (I1 J^(-2/3) - 3) +
    C01 (I2 J^(-4/3) - 3) + K/4 (J^2 - 1 - 2 ln J), d is J."""

    def __init__(self, young, poisson, c01=0.0):
        super().__init__(young, poisson)
        self.c01, self.c10 = c01, self.mu / 2 - c01
        self.bulk = self.lame + 2 * self.mu / 3

    def entries(self):
        if self.c01:
            return {"Material": "Mooney-Rivlin",
                    "Mooney-Rivlin constant": "%.12g" % self.c01}
        return {"Material": "neo-Hookean"}

    # Cells turned inside out on the way to a solution give no numbers.
    @np.errstate(invalid="ignore")
    def shear(self, E, history):
        C = 2 * E + ONE
        G, I3 = np.linalg.inv(C), np.linalg.det(C)
        I1 = trace(C)
        I2 = (I1 * I1 - trace(C @ C)) / 2
        first = ONE - times(I1 / 3, G)
        second = times(I1, ONE) - C - times(2 * I2 / 3, G)
        return (times(2 * self.c10 * I3 ** (-1 / 3), first) +
                times(2 * self.c01 * I3 ** (-2 / 3), second))

    def shear_energy(self, E):
        C = 2 * E + ONE
        I3, I1 = np.linalg.det(C), trace(C)
        I2 = (I1 * I1 - trace(C @ C)) / 2
        return (self.c10 * (I1 * I3 ** (-1 / 3) - 3) +
                self.c01 * (I2 * I3 ** (-2 / 3) - 3))

    @np.errstate(invalid="ignore")
    def volume(self, E):
        C = 2 * E + ONE
        J = np.sqrt(np.linalg.det(C))
        return J, times(J, np.linalg.inv(C))

    def pressure(self, d):
        return self.bulk / 2 * (d - 1 / d)

    def volume_energy(self, d):
        return self.bulk / 4 * (d * d - 1 - 2 * np.log(d))


class Plastic(Elastic):
    """Of von Mises in small strain. The yield stress is
        Y(a) = Y0 + H a + (Ys - Y0) (1 - exp(-r a))
    of the equivalent plastic strain a, or linear between the pairs (a, Y) of a
    curve and constant beyond; the back stress 2/3 Hk times the plastic strain.
    The history is (a, plastic strain)."""

    has_history = True

    def __init__(self, young, poisson, yield_stress, linear=0.0, kinematic=0.0,
                 saturation=None, rate=0.0, curve=()):
        super().__init__(young, poisson)
        self.bulk = self.lame + 2 * self.mu / 3
        self.curve = curve
        self.knots, self.stresses = np.array([(0, yield_stress), *curve]).T
        self.slopes = np.append(np.diff(self.stresses) / np.diff(self.knots), 0)
        self.initial, self.linear, self.kinematic = (yield_stress, linear,
                                                     kinematic)
        self.saturation, self.rate = saturation, rate

    def entries(self):
        found = {"Material": "elastic-plastic",
                 "Yield stress": "%.12g" % self.initial}
        for name, value in (("Hardening modulus", self.linear),
                            ("Kinematic hardening modulus", self.kinematic)):
            if value:
                found[name] = "%.12g" % value
        if self.saturation is not None:
            found["Saturation stress"] = "%.12g" % self.saturation
            found["Saturation rate"] = "%.12g" % self.rate
        if self.curve:
            found["Hardening curve"] = ", ".join(
                "%.12g" % v for pair in self.curve for v in pair)
        return found

    def start(self, shape):
        return np.zeros(shape), np.zeros(shape + (3, 3))

    def yield_stress(self, a):
        """Y and dY/da."""
        if self.curve:
            k = np.searchsorted(self.knots, a, side="right") - 1
            return (self.stresses[k] + self.slopes[k] * (a - self.knots[k]),
                    self.slopes[k])
        more = 0.0 if self.saturation is None else (self.saturation -
                                                    self.initial)
        decay = np.exp(-self.rate * a)
        return (self.initial + self.linear * a + more * (1 - decay),
                self.linear + more * self.rate * decay)

    def returned(self, E, history):
        """The plastic multiplier of the increment, the direction of flow."""
        a, plastic = history
        xi = (2 * self.mu * (deviator(E) - plastic) -
              2 / 3 * self.kinematic * plastic)
        size = np.sqrt((xi * xi).sum((-2, -1)))
        root = np.sqrt(2 / 3)
        stress, _ = self.yield_stress(a)
        yields = size.real > root * stress * (1 + RETURNED)
        direction = times(1 / np.where(yields, size, 1), xi)
        return self.multiplier(size, a, yields), direction

    def multiplier(self, size, a, yields):
        """That of the plastic strain, with which
            size - 2 (mu + Hk/3) gamma - sqrt(2/3) Y(a + sqrt(2/3) gamma)
        is zero."""
        root = np.sqrt(2 / 3)
        falls = 2 * (self.mu + self.kinematic / 3)
        if self.curve:
            # It falls from knot to knot: the piece in which it is zero.
            at = np.maximum(0, self.knots - np.asarray(a)[..., None]) / root
            left = size[..., None] - falls * at - root * np.interp(
                a[..., None] + root * at, self.knots, self.stresses)
            k = np.maximum((left.real > 0).sum(-1) - 1, 0)
            Y = self.stresses[k] + self.slopes[k] * (a - self.knots[k])
            return np.where(yields, (size - root * Y) / (
                falls + 2 / 3 * self.slopes[k]), 0)
        gamma = np.zeros_like(size)
        # It is convex: Newton's method comes from the left.
        for _ in range(100):
            stress, slope = self.yield_stress(a + root * gamma)
            step = (size - falls * gamma - root * stress) / (
                falls + 2 / 3 * slope)
            gamma = np.where(yields, gamma + step, 0)
            if not (yields & (np.abs(step) > 1e-15 * np.abs(gamma))).any():
                break
        return gamma

    def shear(self, E, history):
        gamma, direction = self.returned(E, history)
        return 2 * self.mu * (deviator(E) - history[1] -
                              times(gamma, direction))

    def advance(self, E, history):
        gamma, direction = self.returned(E, history)
        return (history[0] + np.sqrt(2 / 3) * gamma,
                history[1] + times(gamma, direction))

    def pressure(self, d):
        return self.bulk * d

    def volume_energy(self, d):
        return self.bulk * d * d / 2
