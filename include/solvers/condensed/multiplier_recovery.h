/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_multiplier_recovery_h
#define contact_multiplier_recovery_h

#include "bodies/discretized_bodies.h"
#include "solvers/condensed/slip_direction_stiffness.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The multipliers of eliminated points, from the forces f that the bodies
   * exert on the nodes: sum over the active points of w C_k (p n + q t) = f_k.
   * The shear of a slipping point is known, or with a moving bound a part of
   * it: q = s (tresca_limit + mu p). Equations are those of the unknowns of
   * slave nodes that no support holds, and of what else was eliminated.
   *
   * Most points are alone with the equations of their node. The others are
   * solved for together: the least squares min |sum of w C (p n + q t) - f|^2,
   * because there may be more equations than multipliers; where active points
   * say the same twice, the multipliers with the smallest integral of their
   * square share the force.
   */
  template<int dim>
  class MultiplierRecovery
  {
  public:
    using Turned = typename SlipDirectionStiffness<dim>::Turned;

    /// @p eliminated: what the points eliminate; @p turned: by point, what is
    /// known of the shear besides its bound.
    MultiplierRecovery(const DiscretizedBodies<dim> &discretization,
                       const ContactInterface<dim>  &interface,
                       const std::vector<types::global_dof_index> &eliminated,
                       const std::vector<Turned>                  &turned);

    /// Pressure and shear of a point [MPa].
    struct Pair
    {
      double             p = 0;
      Tensor<1, dim - 1> q; // by tangent
    };

    /// Of all points, from @p residual, minus the residual of the bodies alone;
    /// zero for open ones, and of a slipping one the shear across its
    /// direction.
    std::vector<Pair> tractions(const GhostedVector &residual) const;

    /// Make them, and the shears at their bounds, the multipliers of a
    /// solution.
    void write(const GhostedVector &residual, GhostedVector &solution) const;

  private:
    using Dof = types::global_dof_index;

    /// The contributions of the points to an equation: the point, and its w C
    /// times the coordinate.
    struct Share
    {
      unsigned int point;
      unsigned int coordinate;
      double       factor;
    };

    /// The factors of the multipliers of a point in a share, and what is known.
    struct Factors
    {
      double              p;
      std::vector<double> q; // by direction
      double              known;
    };

    void    collect_equations(const std::vector<Dof> &eliminated);
    void    collect_shares();
    void    find_coupled_points();
    Factors factors(const Share &share) const;
    std::vector<Tensor<1, dim - 1>>
         find_shear_directions(const unsigned int point) const;
    Pair traction_of_single(const unsigned int   point,
                            const GhostedVector &residual) const;
    void solve_coupled(const GhostedVector &residual,
                       std::vector<Pair>   &tractions) const;

    /// A row of the least squares, and its right-hand side.
    struct Equation
    {
      std::map<unsigned int, double> row;
      double                         rhs;
    };

    /// The first unknown of each point, and the number of unknowns.
    std::vector<unsigned int> first_columns() const;
    std::vector<Equation>
    coupled_equations(const std::vector<unsigned int> &first_column,
                      const GhostedVector             &residual) const;
    static Vector<double> least_squares(const std::vector<Equation> &system,
                                        const unsigned int           n);

    const DiscretizedBodies<dim>         &discretization;
    const std::vector<ContactPoint<dim>> &points;
    const ContactInterface<dim>          &interface;
    const std::vector<Turned>             turned;

    std::map<Dof, std::vector<Share>> equations;
    std::vector<bool>                 coupled; // by point

    /// By point, the directions along the tangents in which its shear follows
    /// from the forces: where it sticks; in 3-D also where it slips, if its
    /// node is free and it has that for itself. Elsewhere it is known.
    std::vector<std::vector<Tensor<1, dim - 1>>> shear_directions;
  };
} // namespace Contact

#endif
