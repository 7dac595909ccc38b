/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_place_h
#define contact_place_h

#include <deal.II/base/mpi.h>

#include <array>
#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/set.hpp>
#include <map>
#include <set>
#include <vector>

#include "base/ghosted_vector.h"

namespace Contact
{
  using namespace dealii;

  /**
   * A material point where values are asked for or a force acts: the weights of
   * unknowns and of vertices there. At a node it is one of each, with weight
   * one; between nodes those of the cell that holds the point:
   *
   *   u_c = sum_i N_i(xi) u_ci,   sigma = sum_v L_v(xi) sigma_v,
   *
   * N the shape functions of the displacement, L those of the vertices alone
   * (bilinear, trilinear or linear). Nodes that hang are replaced by those that
   * they follow. All ranks have the unknowns; the vertices are numbered by the
   * one that owns the cell.
   */
  template<int dim>
  struct Place
  {
    using Weights = std::map<types::global_dof_index, double>;

    /// By component of the displacement.
    std::array<Weights, dim> unknowns;

    /// Of the triangulation of the owner; on other ranks empty.
    std::map<unsigned int, double> vertices;

    /// The cells of the coarse mesh that hold it, unless it is a node.
    std::set<types::coarse_cell_id> coarse_cells;

    bool is_between_nodes() const
    {
      return !coarse_cells.empty();
    }

    /// A component of the displacement [mm].
    double displacement(const unsigned int   component,
                        const GhostedVector &u) const
    {
      double value = 0;
      for (const auto &[dof, weight] : unknowns[component])
        value += weight * u[dof];
      return value;
    }

    /// The value here of a field given by vertex. Collective.
    template<typename Value>
    Value interpolate(const std::vector<Value> &at_vertices,
                      const MPI_Comm            communicator) const
    {
      Value value = Value();
      for (const auto &[vertex, weight] : vertices)
        value += weight * at_vertices[vertex];
      return Utilities::MPI::sum(value, communicator);
    }

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &unknowns &vertices &coarse_cells;
    }
  };
} // namespace Contact

#endif
