/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_projection_h
#define contact_surface_projection_h

#include <deal.II/lac/affine_constraints.h>

#include "solvers/definite_solver.h"
#include "solvers/surface_values.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The projection on the displacements that fulfil the lines of contact, B u =
   * 0, orthogonal in the diagonal D of the tangent of the bodies:
   *   P = 1 - D^-1 B^T S^-1 B,   S = B D^-1 B^T.
   * Whichever side is softer yields. As all ranks have all lines, each
   * factorizes S, which couples surfaces alone. Functions are collective.
   */
  template<typename Number>
  class SurfaceProjection
  {
  public:
    using Dof    = types::global_dof_index;
    using Dofs   = std::vector<Dof>;
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    /// Of the lines of @p eliminated in closed @p constraints, whatever their
    /// inhomogeneities, with the reciprocals @p inverse of the diagonal.
    void initialize(const Dofs                      &eliminated,
                    const AffineConstraints<double> &constraints,
                    const Vector                    &inverse);

    /// P v.
    void project(Vector &v) const;

    /// P^T v: forces that do the same work in displacements that fulfil the
    /// lines.
    void project_transposed(Vector &v) const;

  private:
    /// Unknowns of the surfaces that this rank owns, by their number here.
    std::vector<std::pair<unsigned int, Dof>> own;

    Dofs                  used; // unknowns of the surfaces
    std::vector<double>   flexibilities;
    SurfaceValues<Number> values;

    std::vector<unsigned int> ends; // of each line in the following
    std::vector<unsigned int> columns;
    std::vector<double>       factors;

    /// Work and pseudo forces by line, their forces by unknown.
    void solve() const;

    Counters                        counters;
    TrilinosWrappers::SparseMatrix  matrix;
    std::unique_ptr<DefiniteSolver> solver;
    mutable DefiniteSolver::Vector  violations, multipliers;
    mutable std::vector<double>     at_surfaces;
  };
} // namespace Contact

#endif
