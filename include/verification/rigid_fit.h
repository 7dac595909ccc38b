/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_rigid_fit_h
#define contact_rigid_fit_h

#include <map>

#include "contact/surfaces/surface.h"
#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /// The rigid motion X -> centre + R (X - centre_X) of a body that is closest
  /// to its displacement, in the mean of the squares over the corners of its
  /// cells (Kabsch, Acta Cryst. A 32, 1976). Of rings, their way along the
  /// axis.
  template<int dim>
  struct RigidFit
  {
    Tensor<1, dim> centre_X, centre;
    Tensor<2, dim> R = unit_symmetric_tensor<dim>();

    /// What is left of the displacement @p u at @p X [mm].
    Tensor<1, dim> deformation(const Point<dim>     &X,
                               const Tensor<1, dim> &u) const
    {
      return X + u - centre - R * (X - centre_X);
    }
  };

  template<int dim>
  using RigidFits = std::map<types::material_id, RigidFit<dim>>;

  /// Those of all bodies, by their number. Collective.
  template<int dim>
  RigidFits<dim> fit_rigid_motions(const Discretization<dim> &discretization,
                                   const GhostedVector       &u);

  /// The largest deformation of each body along +-@p direction, a unit vector,
  /// at the corners of its cells [mm]. Collective.
  template<int dim>
  std::map<types::material_id, double>
  deformations_along(const Discretization<dim> &discretization,
                     const RigidFits<dim>      &fits,
                     const GhostedVector       &u,
                     const Tensor<1, dim>      &direction);

  /// The largest deformation of a surface by the displacement @p u [mm].
  template<int dim>
  double largest_deformation(const Surface<dim>   &surface,
                             const RigidFits<dim> &fits,
                             const GhostedVector  &u);
} // namespace Contact

#endif
