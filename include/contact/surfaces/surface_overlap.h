/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_overlap_h
#define contact_surface_overlap_h

#include <deal.II/base/mpi.h>

#include "contact/surfaces/deformed_surface.h"

namespace Contact
{
  using namespace dealii;

  /// Places of a facet, with its nodes or between them only.
  template<int dim>
  std::vector<FacetPoint<dim>> places_of_facet(const bool with_nodes);
  template<>
  std::vector<FacetPoint<2>> places_of_facet<2>(const bool with_nodes);
  template<>
  std::vector<FacetPoint<3>> places_of_facet<3>(const bool with_nodes);

  /// A place of a surface that is behind the closest place of another one that
  /// it faces.
  template<int dim>
  struct OverlappingPlace
  {
    unsigned int    facet;
    FacetPoint<dim> xi;
    Projection<dim> opposite;
    double          depth; // [mm]
  };

  /**
   * Visit these places of @p own: of nodes and places between them, no deeper
   * behind @p facing than @p reach [mm]. Each process visits its share of the
   * facets.
   */
  template<int dim>
  void visit_overlaps(
    const DeformedSurface<dim>                               &own,
    const DeformedSurface<dim>                               &facing,
    const double                                              reach,
    const MPI_Comm                                            communicator,
    const std::function<void(const OverlappingPlace<dim> &)> &visit);

  /**
   * The depth by which the two surfaces of each pair overlap undeformed [mm]:
   * the deepest place of one that is inside of the other body, opposite to a
   * place that is inside of its own body. A far side of a body is none: a line
   * to it leaves one of the bodies. A place is inside of a body where it is
   * behind the closest of all of its surfaces in @p pairs.
   */
  template<int dim>
  std::vector<double> overlaps_as_drawn(
    const std::vector<std::pair<const Surface<dim> *, const Surface<dim> *>>
                  &pairs,
    const MPI_Comm communicator);
} // namespace Contact

#endif
