/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_friction_bounds_h
#define contact_friction_bounds_h

#include <deal.II/lac/vector.h>

#include <vector>

#include "base/ghosted_vector.h"
#include "contact/points/contact_point.h"
#include "contact/points/friction_law.h"

namespace Contact
{
  using namespace dealii;

  template<int dim>
  class ContactInterface;

  /// The bounds of the shears of the points: they follow the pressures, or are
  /// frozen, which is Tresca's problem.
  template<int dim>
  class FrictionBounds
  {
  public:
    FrictionBounds(const ContactInterface<dim>    &interface,
                   std::vector<ContactPoint<dim>> &points)
      : interface(interface)
      , points(points)
    {
    }

    /// Whether the bounds follow the pressures.
    bool follow = true;

    /// The law of friction that a point obeys at present.
    FrictionLaw law(const ContactPoint<dim> &point) const;

    /// Set the bounds of the next Tresca problem from the present pressures;
    /// return the largest change, relative to the largest bound.
    double update(const GhostedVector &solution, const GhostedVector &u_start);

    /// Let points whose bound follows a pressure that is not known yet stick
    /// whatever their shear, until the bounds are updated.
    void raise_unknown();

    /// The bounds of all points [MPa].
    Vector<double> values() const;
    void           set(const Vector<double> &bounds);

    /**
     * A bound that was frozen while a point was under pressure may leave it no
     * solution as it opens: open it penetrates, closed and held by so much
     * friction it is pulled. It gets the bound of no pressure, until the bounds
     * are updated.
     */
    void reset(const unsigned int point);
    void reset_of_open_points();

  private:
    const ContactInterface<dim>    &interface;
    std::vector<ContactPoint<dim>> &points;
  };



  /// As long as it lives the bounds of shears follow the pressures, or are
  /// frozen.
  template<int dim>
  class BoundsWhile
  {
  public:
    BoundsWhile(FrictionBounds<dim> &bounds, const bool follow)
      : bounds(bounds)
      , before(bounds.follow)
    {
      bounds.follow = follow;
    }

    BoundsWhile(const BoundsWhile &) = delete;

    ~BoundsWhile()
    {
      bounds.follow = before;
    }

  private:
    FrictionBounds<dim> &bounds;
    const bool           before;
  };
} // namespace Contact

#endif
