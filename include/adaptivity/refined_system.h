/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_refined_system_h
#define contact_refined_system_h

#include <map>
#include <set>
#include <vector>

#include "contact/interface/contact_kernel.h"
#include "model/increment_state.h"
#include "solvers/direct/linear_solver.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The tangent of a state on the mesh refined once, where it is not solved but
   * in parts: what it takes to know what a coarser solution misses is local.
   */
  class RefinedSystem
  {
  public:
    /// Assemble that of the @p state on the mesh of the @p model, under its
    /// statuses and pairing.
    RefinedSystem(const ContactModel<2>      &model,
                  const IncrementState<2>    &state,
                  const ContactLinearization &linearization);

    /// Minus the residual of the state.
    const GhostedVector &negative_residual() const
    {
      return rhs;
    }

    /**
     * The part of the solution under @p rhs that oscillates from node to node,
     * by @p n_sweeps of symmetric Gauss-Seidel relaxation: of all nodes but
     * those of the contact, which are one block with their multipliers. What it
     * leaves of the right-hand side is in @p rhs.
     */
    GhostedVector relax(GhostedVector &rhs, const unsigned int n_sweeps) const;

    /**
     * The dual solution of a value at a point is singular there: a unit force,
     * or for a stress a dipole, acts on a node, and no polynomial recovers that
     * from a coarser mesh. On the cells around these vertices, on both sides of
     * the contact, the dual problem is therefore solved, under the values of
     * @p dual at their edge; @p functional is the derivative of the value.
     */
    void solve_dual_around(const std::vector<unsigned int> &vertices,
                           const GhostedVector             &functional,
                           GhostedVector                   &dual);

  private:
    using Unknowns = std::set<types::global_dof_index>;

    /// A part of the system, and its factorization.
    struct Block
    {
      explicit Block(Counters &counters)
        : solver(counters)
      {
      }

      std::vector<types::global_dof_index> unknowns;
      DirectSolver                         solver;
    };

    void     find_couplings();
    void     assemble(const ContactLinearization &linearization);
    Unknowns unknowns_around(const std::vector<unsigned int> &vertices) const;
    void     remove_fixed(Unknowns &unknowns) const;
    void     add_multipliers(Unknowns &unknowns) const;
    void     factorize(const Unknowns &unknowns, Block &block) const;
    const Block &block_around(const std::vector<unsigned int> &vertices);

    const ContactModel<2>   &model;
    const IncrementState<2> &state;

    SparsityPattern      pattern;
    SparseMatrix<double> matrix;
    GhostedVector        rhs;
    Block                contact; // its nodes and multipliers

    /// Those around the vertices of probes; several may be of the same point.
    std::map<std::vector<unsigned int>, Block> around;
    std::vector<bool> relaxes; // by row: neither there nor fixed

    /// The cells at each vertex, and the vertices that each point couples.
    std::vector<std::set<Triangulation<2>::active_cell_iterator>> cells_at;
    std::vector<std::vector<unsigned int>> vertices_of_points;
  };
} // namespace Contact

#endif
