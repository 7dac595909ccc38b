/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_body_boundary_h
#define contact_body_boundary_h

#include <deal.II/base/mpi.h>

#include "contact/interface/contact_pair.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The whole boundary of the body of the slave or of the master of a contact
   * pair, by which a place is inside of it. Of two surfaces of one connected
   * body the surface of the pair alone.
   */
  template<int dim>
  struct BodyBoundary
  {
    BodyBoundary(const ContactPair<dim> &contact_pair, const bool of_master);

    /// The positions of its nodes under the displacement @p u [mm], put
    /// together from what each process owns. Collective.
    std::vector<Point<dim>> positions(const GhostedVector &u) const;

    const Surface<dim>           &surface;
    const DiscretizedBodies<dim> &discretization;
  };

  /// The depth of a place behind the closest place of the boundary of a body
  /// [mm]: at a convex edge it is behind all facets that meet there. Zero
  /// outside.
  template<int dim>
  double depth_behind(const DeformedSurface<dim> &boundary,
                      const Projection<dim>      &closest,
                      const Point<dim>           &x);

  /// Of the places that the processes found the deepest one. Collective.
  template<typename Place>
  Place deepest_of_all(const MPI_Comm communicator, const Place &own)
  {
    Place deepest = own;
    for (const Place &other : Utilities::MPI::all_gather(communicator, own))
      if (other.depth > deepest.depth)
        deepest = other;
    return deepest;
  }
} // namespace Contact

#endif
