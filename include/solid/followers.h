/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_followers_h
#define contact_followers_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

#include "base/ghosted_vector.h"

namespace Contact
{
  using namespace dealii;

  template<int dim>
  class Discretization;

  /// A node of FE_Q(2) that follows others of its cell, and by how much.
  struct BoundNode
  {
    unsigned int                                 node;
    std::vector<std::pair<unsigned int, double>> leaders;
  };

  /// Those of a hypercube of degree 2, but for free ones.
  template<int dim>
  const std::vector<BoundNode> &bound_nodes_of_element();

  /// The bound nodes of a cell with serendipity; none of a triangle. The centre
  /// of a quadrangle of degree 2 follows the corners (-1/4) and the mid-side
  /// nodes (1/2), so do the centres of the faces of a hexahedron; its own
  /// centre follows its corners (-1/4) and its mid-side nodes (1/4). In 3-D the
  /// centre of a face that may touch is free: dual functions need one with
  /// positive weights, and the corners of a face of 8 nodes have negative ones.
  /// The centre of the cell follows it by 1/2, less what that face's corners
  /// and mid-sides would add.
  template<int dim>
  std::vector<BoundNode>
  bound_nodes(const Discretization<dim> &discretization,
              const typename DoFHandler<dim>::active_cell_iterator &cell);

  /// Add the constraints of serendipity elements on a mesh, which may be a
  /// coarser one, but of the active cells that are @p left_out. Nodes on faces
  /// that supports hold have none, nor those that hang: they follow the face of
  /// a larger cell, which is one of these elements.
  template<int dim, typename Number>
  void bind_centres(const Discretization<dim> &discretization,
                    const DoFHandler<dim>     &dof_handler,
                    AffineConstraints<Number> &constraints,
                    const std::vector<bool>   &left_out = {});

  /// Make the constraints of Discretization::followers().
  template<int dim>
  AffineConstraints<double>
  make_followers(const Discretization<dim> &discretization);

  /// Hand over forces on followers to the unknowns that they follow: then a
  /// node carries what it exerts on its support. Collective.
  template<int dim>
  void hand_over_from_followers(const Discretization<dim> &discretization,
                                GhostedVector             &forces);
} // namespace Contact

#endif
