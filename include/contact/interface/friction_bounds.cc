/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/interface/friction_bounds.h"

#include <algorithm>
#include <limits>

#include "contact/interface/contact_interface.h"

namespace Contact
{
  template<int dim>
  FrictionLaw FrictionBounds<dim>::law(const ContactPoint<dim> &point) const
  {
    return follow ? interface.contact_pair(point).law
                  : FrictionLaw{point.friction_bound, 0};
  }



  template<int dim>
  double FrictionBounds<dim>::update(const GhostedVector &solution,
                                     const GhostedVector &u_start)
  {
    double change = 0, largest = 0;
    for (ContactPoint<dim> &point : points)
      {
        if (interface.contact_pair(point).tied)
          continue;
        const FrictionLaw &law = interface.contact_pair(point).law;
        const double       bound =
          point.status.kind == Status::open
                  ? law.bound(0)
                  : law.bound(interface.state(point, solution, u_start).p_trial);
        change  = std::max(change, std::abs(bound - point.friction_bound));
        largest = std::max(largest, bound);
        point.friction_bound = bound;
      }
    return largest > 0 ? change / largest : 0;
  }



  template<int dim>
  void FrictionBounds<dim>::raise_unknown()
  {
    for (ContactPoint<dim> &point : points)
      if (interface.contact_pair(point).law.coulomb_coefficient > 0 &&
          point.friction_bound == 0)
        point.friction_bound = std::numeric_limits<double>::max();
  }



  template<int dim>
  Vector<double> FrictionBounds<dim>::values() const
  {
    Vector<double> bounds(points.size());
    for (unsigned int q = 0; q < points.size(); ++q)
      bounds[q] = points[q].friction_bound;
    return bounds;
  }



  template<int dim>
  void FrictionBounds<dim>::set(const Vector<double> &bounds)
  {
    for (unsigned int q = 0; q < points.size(); ++q)
      points[q].friction_bound = bounds[q];
  }



  template<int dim>
  void FrictionBounds<dim>::reset(const unsigned int point)
  {
    points[point].friction_bound =
      interface.contact_pair(points[point]).law.bound(0);
  }



  template<int dim>
  void FrictionBounds<dim>::reset_of_open_points()
  {
    for (unsigned int q = 0; q < points.size(); ++q)
      if (points[q].status.kind == Status::open)
        reset(q);
  }

  template class FrictionBounds<2>;
  template class FrictionBounds<3>;
} // namespace Contact
