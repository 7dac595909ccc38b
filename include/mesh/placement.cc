/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/placement.h"

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

#include "base/errors.h"
#include "mesh/groups.h"

namespace Contact
{
  namespace
  {
    /// The components of a vector, those that are not given zero.
    template<int dim>
    Tensor<1, dim> to_vector(const std::vector<double> &components,
                             const std::string         &entry)
    {
      if (components.size() > dim)
        throw InputError("a vector of " + std::to_string(components.size()) +
                           " components, but the mesh is plane",
                         "entry '" + entry + "'",
                         "write 'x, y'");
      Tensor<1, dim> vector;
      for (unsigned int d = 0; d < components.size(); ++d)
        vector[d] = components[d];
      return vector;
    }



    /// The rotation by an angle [degrees] that turns axis @p i toward axis
    /// @p j.
    template<int dim>
    Tensor<2, dim> rotation_in_plane(const double       angle,
                                     const unsigned int i,
                                     const unsigned int j)
    {
      const double   cosine = std::cos(angle * numbers::PI / 180);
      const double   sine   = std::sin(angle * numbers::PI / 180);
      Tensor<2, dim> R      = unit_symmetric_tensor<dim>();
      R[i][i] = R[j][j] = cosine;
      R[i][j]           = -sine;
      R[j][i]           = sine;
      return R;
    }



    /// A single angle turns about z, three about x, then y, then z.
    template<int dim>
    Tensor<2, dim> rotation_of(const std::vector<double> &angles)
    {
      if (angles.size() == 1)
        return rotation_in_plane<dim>(angles[0], 0, 1);
      if constexpr (dim == 3)
        return rotation_in_plane<3>(angles[2], 0, 1) *
               rotation_in_plane<3>(angles[1], 2, 0) *
               rotation_in_plane<3>(angles[0], 1, 2);
      throw InputError("there are three angles, but the mesh is plane",
                       "entry 'Mesh/Rotation'",
                       "set one angle, in degrees");
    }
  } // namespace



  template<int dim>
  Placement<dim>::Placement(
    const Parameters::Mesh                          &parameters,
    const std::map<std::string, types::material_id> &bodies)
    : scale(parameters.scale)
    , rotation(rotation_of<dim>(parameters.rotation))
    , shift(to_vector<dim>(parameters.shift, "Mesh/Shift"))
    , moves(bodies.size())
  {
    for (const auto &[name, move] : parameters.move)
      moves[find_group(bodies, "body", name, "Mesh/Move")] =
        to_vector<dim>(move, "Mesh/Move");
  }



  template class Placement<2>;
  template class Placement<3>;
} // namespace Contact
