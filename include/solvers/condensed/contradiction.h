/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contradiction_h
#define contact_contradiction_h

#include <cmath>
#include <sstream>
#include <string>

#include "base/errors.h"
#include "contact/points/contact_point.h"

namespace Contact
{
  /**
   * The worst of the equations of contact points that cannot be met: they
   * follow from those of other points and from supports, but for a remainder.
   * No pressure helps against penetration where supports hold all; else the
   * statuses may be others in the next step.
   */
  template<int dim>
  class Contradiction
  {
  public:
    /// An equation of which @p left [mm] remains. Throws NotConverged where
    /// supports hold all that is in it.
    void
    add(const ContactPoint<dim> &point, const double left, const bool is_held)
    {
      if (std::abs(left) <= point.gap_round_off())
        return;
      if (is_held && left < 0)
        {
          std::ostringstream text;
          text
            << place(point)
            << " is over-constrained: supports hold it and what it faces, and "
               "move them "
            << -left
            << " mm into each other; let the supports end before the contact "
               "surfaces, or name the node in Contact/Excluded points";
          throw NotConverged(text.str());
        }
      if (std::abs(left) > largest)
        {
          largest = std::abs(left);
          worst   = &point;
        }
    }

    /// The end of the message of a Newton's method that does not converge;
    /// empty if there is none.
    std::string message() const
    {
      if (worst == nullptr)
        return "";
      std::ostringstream text;
      text
        << "; " << place(*worst)
        << " is over-constrained: what it has to do contradicts other points "
           "and supports by "
        << largest
        << " mm; exchange slave and master, or let the supports or the "
           "surfaces end before they meet";
      return text.str();
    }

  private:
    static std::string place(const ContactPoint<dim> &point)
    {
      std::ostringstream text;
      text << (point.is_on_slave(0) ? "the node of the slave"
                                    : "the corner of the master")
           << " at (" << point.X(0) << ")";
      return text.str();
    }

    const ContactPoint<dim> *worst   = nullptr;
    double                   largest = 0; // [mm]
  };
} // namespace Contact

#endif
