/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/results/body_boundary.h"

namespace Contact
{
  template<int dim>
  BodyBoundary<dim>::BodyBoundary(const ContactPair<dim> &contact_pair,
                                  const bool              of_master)
    : surface(contact_pair.boundaries[of_master]
                ? *contact_pair.boundaries[of_master]
                : (of_master ? *contact_pair.master : contact_pair.slave))
    , discretization(contact_pair.discretization)
  {
  }



  template<int dim>
  std::vector<Point<dim>>
  BodyBoundary<dim>::positions(const GhostedVector &u) const
  {
    std::vector<double> displacements;
    for (const SurfaceNode<dim> &node : surface.nodes)
      for (const auto dof : node.dofs)
        displacements.push_back(
          discretization.distribution->in_local_range(dof) ? u[dof] : 0.);
    Utilities::MPI::sum(displacements,
                        discretization.communicator,
                        displacements);
    std::vector<Point<dim>> positions;
    for (unsigned int i = 0; i < surface.nodes.size(); ++i)
      {
        positions.push_back(surface.nodes[i].X);
        for (unsigned int c = 0; c < dim; ++c)
          positions.back()[c] += displacements[i * dim + c];
      }
    return positions;
  }



  template<int dim>
  double depth_behind(const DeformedSurface<dim> &boundary,
                      const Projection<dim>      &closest,
                      const Point<dim>           &x)
  {
    const bool is_inside = !boundary.is_at_end(closest) &&
                           boundary.is_behind(x, closest, /*slack=*/0.);
    return is_inside ? x.distance(boundary.position(closest.facet, closest.xi))
                     : 0;
  }

  template struct BodyBoundary<2>;
  template struct BodyBoundary<3>;
  template double depth_behind(const DeformedSurface<2> &,
                               const Projection<2> &,
                               const Point<2> &);
  template double depth_behind(const DeformedSurface<3> &,
                               const Projection<3> &,
                               const Point<3> &);
} // namespace Contact
