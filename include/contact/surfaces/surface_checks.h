/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_checks_h
#define contact_surface_checks_h

#include <set>

#include "contact/surfaces/surface.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Check that slave and master of a contact pair have no node in common, and
   * that neither has lines of a body of the other: they would be the closest
   * ones. Two surfaces of one and the same part, the lips of a slit, are meant
   * to touch. Throws InputError.
   */
  template<int dim>
  void check_surfaces(const Surface<dim>           &slave,
                      const Surface<dim>           &master,
                      const DiscretizedBodies<dim> &discretization,
                      const Parameters::Contact    &parameters);

  /// Check that no node of the slave but those @p excluded is tied to one of
  /// the master or of the slave: tie and contact would share one force as they
  /// like. Throws InputError.
  template<int dim>
  void check_ties(const Surface<dim>           &slave,
                  const Surface<dim>           *master,
                  const std::set<unsigned int> &excluded,
                  const DiscretizedBodies<dim> &discretization,
                  const Parameters::Contact    &parameters);

  /// Whether two surfaces have a facet in common.
  template<int dim>
  bool overlap(const Surface<dim> &a, const Surface<dim> &b);
} // namespace Contact

#endif
