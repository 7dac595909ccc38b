/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_loose_facets_h
#define contact_loose_facets_h

#include <boost/serialization/utility.hpp>
#include <optional>
#include <set>
#include <vector>

#include "contact/surfaces/surface.h"

namespace Contact
{
  using namespace dealii;

  /// A facet with its own nodes, as the ranks exchange it.
  template<int dim>
  struct LooseFacet
  {
    unsigned int                        n_vertices;
    PerFacetNode<dim, SurfaceNode<dim>> nodes;
    types::material_id                  body;
    unsigned int                        piece;
    unsigned int                        part;
    Point<dim>                          middle;
    unsigned int                        level;
    unsigned int                        coarse_cell;
    FacetName<dim>                      name;

    /// The first unknowns of the nodes that a hanging one follows, and by how
    /// much.
    PerFacetNode<dim, std::vector<std::pair<types::global_dof_index, double>>>
      parents;

    unsigned int n_nodes(const unsigned int degree) const
    {
      return facet_kind<dim>(n_vertices, degree).n_nodes;
    }

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &n_vertices;
      for (SurfaceNode<dim> &node : nodes)
        {
          for (auto &dof : node.dofs)
            archive &dof;
          archive &node.X;
        }
      archive &body &piece &part &middle &level &coarse_cell;
      for (auto &dof : name)
        archive &dof;
      for (auto &of_node : parents)
        archive &of_node;
    }
  };

  /// The faces of the own cells on these boundaries, or on those of one part of
  /// the mesh.
  template<int dim>
  std::vector<LooseFacet<dim>>
  loose_facets(const DiscretizedBodies<dim>       &discretization,
               const std::set<types::boundary_id> &boundary_ids,
               const std::optional<unsigned int>   part);
} // namespace Contact

#endif
