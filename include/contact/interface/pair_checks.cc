/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/interface/pair_checks.h"

#include "base/dimension.h"
#include "base/errors.h"
#include "base/string_utilities.h"
#include "contact/surfaces/surface_checks.h"

namespace Contact
{
  namespace
  {
    // An obstacle whose normal points the other way would pull the slave.
    template<int dim>
    void check_side(const ContactPair<dim>    &contact_pair,
                    const Parameters::Contact &parameters)
    {
      const Surface<dim> &slave   = contact_pair.slave;
      const auto          normals = DeformedSurface<dim>(slave, {}).normals();
      double              depth   = 0;
      Point<dim>          deepest;
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        {
          const Point<dim> X       = slave.nodes[i].X;
          const auto       closest = contact_pair.obstacle->closest_point(X);
          if (normals[i] * closest.normal < 0)
            return;
          if ((closest.x - X) * closest.normal > depth)
            {
              depth   = (closest.x - X) * closest.normal;
              deepest = X;
            }
        }
      const double digits = 1e-6; // of a mesh file, by the length of an edge
      if (depth > digits * slave.reference_length(0))
        throw InputError(
          "the slave '" + parameters.slave + "' is inside of its obstacle, " +
            brief(depth) + " mm deep at (" + brief(deepest) +
            ") mm, and no node of it faces the obstacle",
          parameters.section() + "/Obstacle",
          "turn the obstacle's normal round: of a plane its last "
          "numbers, of a circle the sign of the radius, of a "
          "profile the order of its points; or correct the slave");
    }
  } // namespace



  // Two pairs of the same surfaces would share their force as they like, also
  // with slave and master swapped.
  template<int dim>
  void
  check_pairs(const std::vector<std::unique_ptr<const ContactPair<dim>>> &pairs,
              const std::vector<Parameters::Contact> &parameters)
  {
    const auto same_master = [&](const unsigned int i, const unsigned int j) {
      if (!pairs[i]->master || !pairs[j]->master)
        return !pairs[i]->master && !pairs[j]->master &&
               parameters[i].obstacle == parameters[j].obstacle;
      return overlap(*pairs[i]->master, *pairs[j]->master);
    };
    for (unsigned int j = 0; j < pairs.size(); ++j)
      for (unsigned int i = 0; i < j; ++i)
        {
          const std::string parts = Dimension<dim>::boundary + std::string("s");
          const bool both_have_masters = pairs[i]->master && pairs[j]->master;
          const bool is_same =
            overlap(pairs[i]->slave, pairs[j]->slave) && same_master(i, j);
          const bool is_swapped = both_have_masters &&
                                  overlap(pairs[i]->slave, *pairs[j]->master) &&
                                  overlap(*pairs[i]->master, pairs[j]->slave);
          if (is_same || is_swapped)
            throw InputError("two contact pairs have the same " + parts +
                               " as slave and master" +
                               (is_swapped ? ", swapped" : "") +
                               ": how they share the force is not determined",
                             "'" + parameters[i].section() + "' and '" +
                               parameters[j].section() + "'",
                             "remove one of them, or take the common " + parts +
                               " out of one");
        }
    for (unsigned int i = 0; i < pairs.size(); ++i)
      if (pairs[i]->obstacle && !pairs[i]->tied) // glue has no sides
        check_side(*pairs[i], parameters[i]);
  }

  template void
  check_pairs(const std::vector<std::unique_ptr<const ContactPair<2>>> &,
              const std::vector<Parameters::Contact> &);
  template void
  check_pairs(const std::vector<std::unique_ptr<const ContactPair<3>>> &,
              const std::vector<Parameters::Contact> &);
} // namespace Contact
