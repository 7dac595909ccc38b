/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_projection_h
#define contact_surface_projection_h

#include "solvers/direct/factorizations.h"
#include "solvers/multigrid/surface_rows.h"
#include "solvers/multigrid/surface_values.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The projection on the displacements that fulfil the lines of contact,
   * B u = 0. Orthogonal in the diagonal D of the tangent of the bodies, it
   * moves the softer surface: P = 1 - D^-1 B^T S^-1 B,   S = B D^-1 B^T. S
   * couples unknowns of the surfaces alone. As all ranks have all lines, each
   * factorizes it. Functions are collective.
   *
   * P^T K P has no larger eigenvalues by D than K, whatever the lines are and
   * however much stiffer one body is than the other: what the smoother of a
   * multigrid needs. (D. Braess, W. Dahmen, C. Wieners, SIAM J. Numer. Anal.
   * 37, 1999.)
   */
  template<typename Number>
  class SurfaceProjection
  {
  public:
    using Dof    = types::global_dof_index;
    using Dofs   = std::vector<Dof>;
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    /// On the @p lines of all ranks, with the reciprocals @p inverse of the
    /// diagonal. What depends on the pattern alone is kept while that is the
    /// same.
    void initialize(const SurfaceRows &lines, const Vector &inverse);

    /// No projection, until there are lines.
    void disable()
    {
      is_active = false;
    }

    /// P v.
    void project(Vector &v) const;

    /// P^T v: the forces that do the same work in displacements that fulfil the
    /// lines.
    void project_transposed(Vector &v) const;

  private:
    void read_lines(const SurfaceRows &lines);
    void share_dofs(const Vector &like);
    void read_flexibilities(const Vector &inverse);
    void factorize(const bool new_pattern);

    /// By numbers: of each unknown the lines that it is in, and S.
    SurfaceRows lines_of_dofs() const;
    SurfaceRows compliance() const;

    /// at_surfaces = B^T S^-1 B at_surfaces.
    void make_reactions() const;

    Dofs                      dofs; // those in the lines, in ascending order
    std::vector<double>       flexibilities; // of them, 1 / D
    SurfaceValues<Number>     values;
    std::vector<unsigned int> own;               // of this rank, by number
    bool                      is_active = false; // there are lines

    std::vector<unsigned int> ends; // of each line in the following
    std::vector<unsigned int> columns;
    std::vector<double>       factors;

    Counters                       counters; // of surfaces, no one asks
    TrilinosWrappers::SparseMatrix matrix;
    std::unique_ptr<Factorization> solver;
    mutable DefiniteSolver::Vector gaps, pressures;
    mutable std::vector<double>    at_surfaces;
  };
} // namespace Contact

#endif
