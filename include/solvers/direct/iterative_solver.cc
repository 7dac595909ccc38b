/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/direct/iterative_solver.h"

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "base/errors.h"

namespace Contact
{
  IterativeSolver::IterativeSolver(
    std::unique_ptr<Preconditioner> preconditioner,
    Counters                       &counters)
    : DefiniteSolver(counters)
    , preconditioner(std::move(preconditioner))
  {
  }



  void IterativeSolver::set_matrix(const Matrix &matrix,
                                   const Matrix &nearby,
                                   const bool    new_pattern,
                                   const Dofs   &eliminated)
  {
    this->matrix      = &matrix;
    this->nearby      = &nearby;
    this->eliminated  = eliminated;
    this->new_pattern = this->new_pattern || new_pattern;
    is_new            = false;
    indefinite.reset();
    const double price = preconditioner->price();
    if (!is_made || (new_pattern && !preconditioner->is_inverse()) ||
        n_changed() > price ||
        (per_digit > 1.3 * per_digit_when_new && excess >= price))
      make();
  }



  void IterativeSolver::release()
  {
    preconditioner->clear();
    indefinite = false;
  }



  bool IterativeSolver::is_indefinite(const bool may_cost)
  {
    if (!indefinite && may_cost)
      {
        if (!is_symmetric())
          indefinite = preconditioner->has_indefinite_part(*matrix);
        else
          {
            if (preconditioner->is_inverse() && !is_new)
              make();
            indefinite = preconditioner->finds_indefinite(*matrix);
          }
      }
    return indefinite && *indefinite;
  }



  // A matrix with a definite symmetric part is that of a stable state; of
  // another unsymmetric one nothing is known.
  bool IterativeSolver::knows_definiteness() const
  {
    return is_symmetric() || (indefinite && !*indefinite);
  }



  unsigned int
  IterativeSolver::solve(const Vector &b, const double tolerance, Vector &x)
  {
    if (is_new && is_exact)
      {
        ++counters.linear_solves;
        preconditioner->vmult(x, b);
        return 1;
      }
    // Digits cost an inverse little, and the active set of an inexact step may
    // be another one.
    const double  digits_more = preconditioner->is_inverse() ? 1e-4 : 1.;
    SolverControl control(max_iterations(),
                          std::max(digits_more * tolerance,
                                   1e-12 * b.l2_norm()));
    try
      {
        iterate(control, b, x);
      }
    catch (const SolverControl::NoConvergence &)
      {
        if (!is_new)
          make();
        else if (preconditioner->make_inverse(*matrix))
          is_exact = true;
        else
          {
            std::ostringstream residual;
            residual << control.last_value();
            throw SolverStalls((is_for_cg() ? "conjugate gradients" : "GMRES") +
                               std::string(" with AMG stall at the residual ") +
                               residual.str() + " N/mm (rings: N) after " +
                               std::to_string(control.last_step()) +
                               " iterations");
          }
        return solve(b, tolerance, x);
      }

    // Solves of different depth compare by their iterations per digit.
    const double digits =
      std::log10(control.initial_value() / control.last_value());
    per_digit = digits > 0 ? control.last_step() / digits : 0.;
    if (is_new)
      {
        per_digit_when_new = per_digit;
        excess             = 0;
      }
    excess += std::max(0., control.last_step() - digits * per_digit_when_new);
    return control.last_step();
  }



  bool IterativeSolver::is_for_cg() const
  {
    return is_symmetric() && preconditioner->is_symmetric();
  }



  std::size_t IterativeSolver::n_changed() const
  {
    Dofs changed;
    std::set_symmetric_difference(eliminated.begin(),
                                  eliminated.end(),
                                  eliminated_when_new.begin(),
                                  eliminated_when_new.end(),
                                  std::back_inserter(changed));
    return changed.size();
  }



  // An inverse is made anew before it has cost more than that.
  unsigned int IterativeSolver::max_iterations() const
  {
    const unsigned int most = preconditioner->is_inverse() ? 100 : 500;
    return preconditioner->is_inverse() && !is_new
             ? std::min<unsigned int>(most, std::ceil(preconditioner->price()))
             : most;
  }



  void IterativeSolver::iterate(SolverControl &control,
                                const Vector  &b,
                                Vector        &x) const
  {
    ++counters.linear_solves;
    x = 0;
    if (is_for_cg())
      SolverCG<Vector>(control).solve(*matrix, x, b, *preconditioner);
    else // the residual of the system itself is what is measured
      SolverGMRES<Vector>(
        control,
        SolverGMRES<Vector>::AdditionalData(/*max_n_tmp_vectors=*/102,
                                            /*right_preconditioning=*/true))
        .solve(*matrix, x, b, *preconditioner);
  }



  void IterativeSolver::make()
  {
    is_made = false;
    preconditioner->make(*nearby, new_pattern);
    is_exact = preconditioner->is_inverse() && is_symmetric();
    is_made = is_new    = true;
    new_pattern         = false;
    eliminated_when_new = eliminated;
    per_digit_when_new = per_digit = excess = 0;
  }
} // namespace Contact
