/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_given_bodies_h
#define contact_given_bodies_h

#include "bodies/discretized_bodies.h"
#include "mesh/mesh_pieces.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The bodies of a program that has a Triangulation, a DoFHandler and
   * AffineConstraints of its own, in one process. Of the constraints, lines
   * without entries are supports; their inhomogeneities are taken as what is
   * prescribed. Let both objects live as long as this one, and make a new one
   * when unknowns are numbered anew.
   */
  template<int dim>
  class GivenBodies
    : public DiscretizedBodies<dim>
    , public BodyStiffness
  {
  public:
    /// The groups of faces by the names that Parameters::Contact has for slave
    /// and master, and Young's modulus [MPa] of each body.
    using Boundaries = std::map<std::string, std::set<types::boundary_id>>;
    using Moduli     = std::map<types::material_id, double>;

    /// Throws InputError for an element that is no FE_Q or FE_SimplexP of
    /// degree 1 or 2 with dim components.
    GivenBodies(const Mapping<dim>              &mapping,
                const DoFHandler<dim>           &dof_handler,
                const AffineConstraints<double> &constraints,
                const Boundaries                &boundaries,
                const Moduli                    &moduli);

    const std::set<types::boundary_id> &
    boundary_ids(const std::string &name,
                 const std::string &entry) const override;
    std::vector<NodeDoFs<dim>>
    nodes_of(const std::string &name, const std::string &entry) const override;
    std::string  body_name(const types::material_id id) const override;
    unsigned int piece(
      const typename Triangulation<dim>::cell_iterator &cell) const override;
    bool   is_fixed(const types::global_dof_index dof) const override;
    bool   are_fixed_alike(const types::global_dof_index a,
                           const types::global_dof_index b) const override;
    double youngs_modulus(const types::material_id body) const override;

  private:
    const Boundaries boundaries;
    const Moduli     moduli;
    MeshPieces<dim>  pieces;
  };
} // namespace Contact

#endif
