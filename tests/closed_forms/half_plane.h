/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_tests_half_plane_h
#define contact_tests_half_plane_h

#include <vector>

#include "closed_forms/line_contact.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The line contact of Hertz with Coulomb friction: a cylinder (body 1) on a
   * half plane (body 2) in plane strain and small strain, both as elastic half
   * planes, the load applied in equal increments. Under the pressure p and the
   * shear traction q, which acts on body 1 along x and on body 2 against it,
   * the surfaces recede from each other by w and slide by s = u_x1 - u_x2,
   *
   *   dw/dx = 2/E* (-1/pi PV integral of p(t)/(x - t) dt + beta q),
   *   ds/dx = 2/E* (-1/pi PV integral of q(t)/(x - t) dt - beta p),
   *   beta  = 1/2 E* ((1 - 2 nu1)(1 + nu1)/E1 - (1 - 2 nu2)(1 + nu2)/E2)
   *
   * (Johnson, Contact Mechanics, 1985, sections 2.5 and 5.1). In contact the
   * gap x^2/(2R) + w - w0 is zero and p >= 0, outside the gap is open and p and
   * q are zero; the integral of p is the force P. |q| <= friction * p: points
   * that stick keep the s of the start of the increment, by the q that this
   * asks for; where points slip, |q| is at its bound and opposes the change of
   * s. For points that come into contact this is the same.
   *
   * p is even and q odd; q is positive at x > 0 if beta is, that is, the shear
   * on the softer body points away from the axis.
   *
   * Discretized by constant tractions on elements of equal length, integrated
   * exactly, and by w and s at their midpoints. The ends of contact and stick
   * are found between the elements, to about a tenth of their length.
   */
  class HalfPlaneContact
  {
  public:
    /**
     * Solve for the force of @p hertz in @p n_increments equal increments, with
     * @p n_elements elements over the half width of the frictionless contact. A
     * stick contact pair of less than a few elements is not resolved.
     */
    HalfPlaneContact(const HertzLineContact &hertz,
                     const double            friction,
                     const unsigned int      n_increments,
                     const unsigned int      n_elements);

    /// p [MPa] at @p x [mm] from the axis, between the midpoints linear.
    double pressure(const double x) const;

    /// q [MPa] likewise.
    double shear(const double x) const;

    /// The half width a [mm] of the contact.
    double half_width() const;

    /// The half width c [mm] of the contact pair that sticks in the last
    /// increment.
    double stick_half_width() const;

    /// The largest p [MPa] of all elements.
    double max_pressure() const;

    /// The largest |q| [MPa] of all elements.
    double max_shear() const;

  private:
    /// Tractions and positions in units of the frictionless p0 and a, gap and
    /// displacement in units of a^2/R.
    struct Element
    {
      double pressure = 0, shear = 0, gap = 0;
      double displacement = 0; // s
      double slip         = 0; // the change of s in the increment

      bool in_contact = false;
      int  direction  = 0; // of the shear traction in slip; 0 is stick
    };

    void solve_increment(const double load_factor);
    void solve_equations(const double               load_factor,
                         const std::vector<double> &start);
    bool updated_status();

    double position(const unsigned int i) const;
    double influence(const unsigned int i,
                     const unsigned int j,
                     const int          parity) const;
    double covered(const unsigned int i, const unsigned int j) const;
    double largest(double Element::*value) const;
    double edge(double Element::*value, const unsigned int first) const;
    double
    interpolate(double Element::*value, const int parity, const double x) const;

    const HertzLineContact hertz;
    const double           friction;
    const double           beta;
    const double           h; // the length of an element

    std::vector<double>  kernel;
    std::vector<Element> elements;
  };
} // namespace Contact

#endif
