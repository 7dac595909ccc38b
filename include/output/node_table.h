/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_node_table_h
#define contact_node_table_h

#include <deal.II/lac/vector.h>

#include <array>
#include <boost/serialization/array.hpp>
#include <iosfwd>
#include <string>
#include <vector>

#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /// A node: its piece (MeshPieces), then X [mm], u [mm] and the force of
  /// contact on it [N per mm of thickness; rings: N].
  template<int dim>
  struct NodeRow
  {
    unsigned int                piece = 0;
    std::array<double, 3 * dim> values{};

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &piece &values;
    }
  };

  /// All nodes of all ranks, on the first one; nothing on the others. A node
  /// that several pieces have in common is there once. @p contact_forces is
  /// empty without contact. Collective.
  template<int dim>
  std::vector<NodeRow<dim>>
  collect_nodes(const Discretization<dim> &discretization,
                const GhostedVector       &u,
                const GhostedVector       &contact_forces);

  /// Write the nodes as lines of numbers that a reader gets back to the last
  /// bit, below a line with names and units, "N" or "N_per_mm" of forces.
  template<int dim>
  void write_nodes(std::ostream                    &out,
                   const Mesh<dim>                 &mesh,
                   const std::vector<NodeRow<dim>> &rows,
                   const std::string               &force_unit);
} // namespace Contact

#endif
