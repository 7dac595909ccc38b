/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_model_h
#define contact_contact_model_h

#include <algorithm>
#include <memory>

#include "contact/interface/contact_interface.h"
#include "solid/elasticity.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The bodies of a scene and their contact, on the present mesh. Refinement
   * replaces the last two: a reference to the model always leads to the present
   * ones.
   */
  template<int dim>
  struct ContactModel
  {
    std::unique_ptr<Mesh<dim>>             mesh;
    std::unique_ptr<Discretization<dim>>   discretization;
    std::unique_ptr<Elasticity<dim>>       elasticity;
    std::unique_ptr<ContactInterface<dim>> interface; // none without contact

    std::size_t n_displacements() const
    {
      return discretization->dof_handler.n_dofs();
    }

    std::size_t n_multipliers() const
    {
      return interface ? interface->n_multipliers() : 0;
    }

    std::size_t n_unknowns() const
    {
      return n_displacements() + n_multipliers();
    }

    /// The undeformed bodies without tractions.
    GhostedVector zero() const
    {
      return GhostedVector(discretization->distribution, n_multipliers());
    }

    bool has_friction() const
    {
      return interface && interface->has_friction();
    }

    /// Whether stresses that turn with a body may be a negative stiffness.
    bool may_be_unstable() const
    {
      const auto &bodies = mesh->bodies;
      return std::any_of(bodies.begin(), bodies.end(), [&](const auto &body) {
        return !elasticity->is_small_strain(body.second);
      });
    }

    /// Whether points are paired with bodies that have moved.
    bool geometry_follows(const Parameters::Solution &parameters) const
    {
      return interface && !interface->is_tied() &&
             parameters.geometry != Parameters::GeometryLoop::undeformed;
    }
  };
} // namespace Contact

#endif
