/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_flexible_gmres_h
#define contact_flexible_gmres_h

#include <deal.II/lac/solver_control.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /**
   * GMRES with a preconditioner on the right whose results are kept (Y. Saad,
   * SIAM J. Sci. Comput. 14, 1993): n iterations apply it n times. deal.II's
   * SolverGMRES applies it once more for the solution, SolverFGMRES because it
   * knows of the convergence an iteration later; where a digit or two are asked
   * for, that is a third of all (of 25 s of nested_space_friction.prm with 1.18
   * million unknowns, 3.5 s).
   */
  template<class Vector>
  class FlexibleGMRES
  {
  public:
    explicit FlexibleGMRES(SolverControl &control)
      : control(control)
    {
    }

    /// Solve A x = b, from zero. Throws SolverControl::NoConvergence.
    template<class Matrix, class Preconditioner>
    void solve(const Matrix         &A,
               Vector               &x,
               const Vector         &b,
               const Preconditioner &preconditioner)
    {
      x                          = 0;
      Vector               r     = b;
      double               norm  = r.l2_norm();
      SolverControl::State state = control.check(0, norm);
      unsigned int         n     = 0;
      while (state == SolverControl::iterate)
        {
          std::vector<Vector>              basis, directions;
          std::vector<std::vector<double>> columns;
          std::vector<double>              rest{norm}; // of the residual
          std::vector<Rotation>            rotations;
          r /= norm;
          for (unsigned int j = 0;
               j < max_basis && state == SolverControl::iterate;
               ++j)
            {
              basis.push_back(r);
              directions.emplace_back();
              directions[j].reinit(r, /*omit_zeroing_entries=*/true);
              preconditioner.vmult(directions[j], basis[j]);
              A.vmult(r, directions[j]);

              // Gram and Schmidt, modified.
              columns.emplace_back();
              std::vector<double> &column = columns[j];
              column.push_back(r * basis[0]);
              for (unsigned int i = 1; i <= j; ++i)
                column.push_back(
                  r.add_and_dot(-column[i - 1], basis[i - 1], basis[i]));
              const double left =
                std::sqrt(std::max(0., r.add_and_dot(-column[j], basis[j], r)));

              for (unsigned int i = 0; i < j; ++i)
                rotations[i].turn(column[i], column[i + 1]);
              rotations.emplace_back(column[j], left);
              double below = left;
              rotations[j].turn(column[j], below);
              if (column[j] == 0) // A maps the direction to zero
                {
                  columns.pop_back();
                  state = SolverControl::failure;
                  break;
                }
              rest.push_back(0);
              rotations[j].turn(rest[j], rest[j + 1]);
              norm  = std::abs(rest[j + 1]);
              state = control.check(++n, norm);
              if (left > 0)
                r /= left;
              else if (state == SolverControl::iterate)
                state = SolverControl::failure; // no direction is left
            }

          for (unsigned int j = columns.size(); j-- > 0;)
            {
              rest[j] /= columns[j][j];
              for (unsigned int i = 0; i < j; ++i)
                rest[i] -= rest[j] * columns[j][i];
              x.add(rest[j], directions[j]);
            }
          if (state == SolverControl::iterate)
            {
              A.vmult(r, x);
              r.sadd(-1, 1, b);
              norm = r.l2_norm();
            }
        }
      if (state == SolverControl::failure)
        throw SolverControl::NoConvergence(n, norm);
    }

  private:
    /// Givens' rotation that takes the second one of two numbers to zero.
    struct Rotation
    {
      Rotation(const double a, const double b)
      {
        const double length = std::hypot(a, b);
        cosine              = length > 0 ? a / length : 1;
        sine                = length > 0 ? b / length : 0;
      }

      void turn(double &a, double &b) const
      {
        const double old = a;
        a                = cosine * old + sine * b;
        b                = cosine * b - sine * old;
      }

      double cosine, sine;
    };

    static constexpr unsigned int max_basis = 50;

    SolverControl &control;
  };
} // namespace Contact

#endif
