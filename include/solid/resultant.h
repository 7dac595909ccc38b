/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_resultant_h
#define contact_resultant_h

#include <deal.II/base/index_set.h>

#include <set>

#include "solid/elasticity.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The resultant of the forces that supports, or contact, exert on a body at a
   * boundary or a point, in direction i:
   *   R_i = sum_a e_i . P_a f_a,
   * f the internal forces minus the loads, a the nodes there, P the projection
   * on what supports hold of a node, or on what they leave free [N per mm of
   * thickness; rings and volumes: N]. Hanging nodes and bound centres have
   * handed over their forces.
   */
  template<int dim>
  class Resultant
  {
  public:
    Resultant(const Elasticity<dim>              &elasticity,
              const Discretization<dim>          &discretization,
              const std::set<types::boundary_id> &boundary,
              const unsigned int                  direction,
              const bool                          of_supports);

    /// At these nodes.
    Resultant(const Elasticity<dim>            &elasticity,
              const Discretization<dim>        &discretization,
              const std::vector<NodeDoFs<dim>> &nodes,
              const unsigned int                direction,
              const bool                        of_supports);

    /// Without the forces @p left_out on the nodes, if there are any.
    /// Collective.
    double value(const GhostedVector &solution,
                 const double         load_factor,
                 const GhostedVector &left_out = {}) const;

    /// Add the derivative with respect to the displacements, times @p factor,
    /// to the @p derivative: K^T v, v the test function. On one rank.
    void add_derivative(const GhostedVector &solution,
                        const double         factor,
                        GhostedVector       &derivative) const;

    /// P_a e_i at these nodes, and what follows from that at those that follow
    /// them: R_i = v . f. Collective.
    GhostedVector test_function() const;

    /// The displacement unknowns of these nodes, on this rank.
    IndexSet unknowns() const;

  private:
    /// P_a e_i, by unknown, without zeros.
    const std::map<types::global_dof_index, double> weights;

    const Elasticity<dim>     &elasticity;
    const Discretization<dim> &discretization;
  };
} // namespace Contact

#endif
