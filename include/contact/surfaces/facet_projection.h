/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_facet_projection_h
#define contact_facet_projection_h

#include "contact/surfaces/facet_shapes.h"

namespace Contact
{
  using namespace dealii;

  /// The places of the nodes of a facet.
  template<int dim>
  using FacetNodes = PerFacetNode<dim, Point<dim>>;

  /// The closest point of a facet within its limits.
  template<int dim>
  struct FacetProjection
  {
    FacetPoint<dim> xi;
    FacetPoint<dim> unbounded; // of the facet as it goes on beyond them
  };

  /// The closest point to @p x.
  template<int dim>
  FacetProjection<dim>
  project_on_facet(const FacetKind<dim>                  &kind,
                   const Point<dim>                      &x,
                   const FacetNodes<dim>                 &nodes,
                   const typename FacetKind<dim>::Limits &limits);
} // namespace Contact

#endif
