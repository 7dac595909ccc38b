/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_placement_h
#define contact_placement_h

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>

#include <map>
#include <string>
#include <vector>

#include "parameters/parameters.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The positions in the program of the points of the file: a body's own
   * move, then for all of them scale, rotation about the origin and shift.
   * Without any of these it changes no bit.
   */
  template<int dim>
  class Placement
  {
  public:
    /// Throws InputError if a body to be moved is not in @p bodies, or a
    /// vector is not one of the space.
    Placement(const Parameters::Mesh                          &parameters,
              const std::map<std::string, types::material_id> &bodies);

    /// A point of the file that belongs to a body [mm].
    Point<dim> operator()(const Point<dim>        &p,
                          const types::material_id body) const
    {
      return Point<dim>(turned(scale * (p + moves[body])) + shift);
    }

    /// A direction of the file.
    Tensor<1, dim> turned(const Tensor<1, dim> &direction) const
    {
      return rotation * direction;
    }

    /// Factor of all lengths [-].
    const double scale;

    /// Whether two bodies are moved alike, and stay together.
    bool move_alike(const types::material_id a,
                    const types::material_id b) const
    {
      return moves[a] == moves[b];
    }

  private:
    Tensor<2, dim>              rotation;
    Tensor<1, dim>              shift;
    std::vector<Tensor<1, dim>> moves; // by body
  };
} // namespace Contact

#endif
