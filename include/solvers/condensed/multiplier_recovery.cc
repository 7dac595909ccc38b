/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed/multiplier_recovery.h"

#include <deal.II/lac/sparse_direct.h>

#include <algorithm>
#include <limits>

#include "base/constraint_entries.h"

namespace Contact
{
  template<int dim>
  MultiplierRecovery<dim>::MultiplierRecovery(
    const DiscretizedBodies<dim> &discretization,
    const ContactInterface<dim>  &interface,
    const std::vector<Dof>       &eliminated,
    const std::vector<Turned>    &turned)
    : discretization(discretization)
    , points(interface.points())
    , interface(interface)
    , turned(turned)
    , coupled(interface.points().size(), false)
  {
    for (unsigned int k = 0; k < points.size(); ++k)
      shear_directions.push_back(find_shear_directions(k));
    collect_equations(eliminated);
    collect_shares();
    find_coupled_points();
  }



  template<int dim>
  void
  MultiplierRecovery<dim>::collect_equations(const std::vector<Dof> &eliminated)
  {
    for (const ContactPoint<dim> &point : points)
      if (point.status.kind != Status::open)
        for (const auto dof : point.dofs(0))
          if (!discretization.constraints.is_constrained(dof))
            equations[dof];
    for (const auto dof : eliminated)
      equations[dof];
  }



  // The force on an unknown that is tied is in the equation of its partner.
  template<int dim>
  void MultiplierRecovery<dim>::collect_shares()
  {
    for (unsigned int k = 0; k < points.size(); ++k)
      if (points[k].status.kind != Status::open)
        for (unsigned int a = 0; a < points[k].n_nodes; ++a)
          for (unsigned int i = 0; i < dim; ++i)
            visit_leaders(discretization.constraints,
                          points[k].dofs(a)[i],
                          [&](const Dof dof, const double part) {
                            if (const auto equation = equations.find(dof);
                                equation != equations.end())
                              equation->second.push_back(
                                {k,
                                 i,
                                 part * (points[k].weight * points[k].C[a])});
                          });
  }



  // A point is alone if it shares the equations of its node with no other, has
  // no part in others, and no more multipliers than equations.
  template<int dim>
  void MultiplierRecovery<dim>::find_coupled_points()
  {
    std::vector<unsigned int> n_equations(points.size(), 0);
    for (const auto &[dof, shares] : equations)
      for (const Share &share : shares)
        {
          ++n_equations[share.point];
          if (shares.size() > 1 ||
              dof != points[share.point].dofs(0)[share.coordinate])
            coupled[share.point] = true;
        }
    for (unsigned int k = 0; k < points.size(); ++k)
      if (points[k].status.kind != Status::open &&
          n_equations[k] < (shear_directions[k].empty() ? 1 : dim))
        coupled[k] = true;
    for (unsigned int k = 0; k < points.size(); ++k)
      if (coupled[k] && points[k].status.kind == Status::slip)
        shear_directions[k].clear();
  }



  // What supports hold feels no shear.
  template<int dim>
  std::vector<Tensor<1, dim - 1>>
  MultiplierRecovery<dim>::find_shear_directions(const unsigned int k) const
  {
    const ContactPoint<dim> &point = points[k];
    if (turned[k].is_elastic)
      return {};
    if (point.status.kind == Status::stick)
      {
        std::vector<Tensor<1, dim - 1>> free;
        const Tensor<2, dim - 1>        compliance = point.stick_compliance();
        for (const Tensor<1, dim - 1> &slip : free_slips(point, discretization))
          {
            const Tensor<1, dim - 1> direction =
              point.without(point.tangents_held_by_supports, slip);
            add_orthonormal(direction - compliance * direction, free);
          }
        return free;
      }
    if (dim == 2 || !point.status.has_direction())
      return {};
    for (const auto dof : point.dofs(0))
      if (discretization.constraints.is_constrained(dof))
        return {};
    return free_slips(point, discretization);
  }



  template<int dim>
  typename MultiplierRecovery<dim>::Factors
  MultiplierRecovery<dim>::factors(const Share &share) const
  {
    const ContactPoint<dim> &point  = points[share.point];
    const FrictionLaw        law    = interface.bounds.law(point);
    const double             normal = point.normal[share.coordinate];
    Factors                  factors{share.factor * normal, {}, 0};
    for (const Tensor<1, dim - 1> &direction : shear_directions[share.point])
      factors.q.push_back(share.factor *
                          point.along_tangents(direction)[share.coordinate]);
    if (point.status.kind == Status::stick)
      factors.known =
        share.factor *
        point.along_tangents(turned[share.point].shear)[share.coordinate];
    if (!factors.q.empty() ||
        !(point.status.has_direction() || turned[share.point].is_elastic))
      return factors;
    const double along =
      point.along_tangents(point.status.direction() +
                           turned[share.point].rotation)[share.coordinate];
    factors.p = share.factor * (normal + law.coulomb_coefficient * along);
    factors.known += share.factor * law.tresca_limit * along;
    if (point.status.kind == Status::slip)
      factors.known +=
        share.factor *
        point.along_tangents(turned[share.point].shear)[share.coordinate];
    return factors;
  }



  template<int dim>
  std::vector<typename MultiplierRecovery<dim>::Pair>
  MultiplierRecovery<dim>::tractions(const GhostedVector &residual) const
  {
    std::vector<Pair> tractions(points.size());
    bool              any_coupled = false;
    for (unsigned int k = 0; k < points.size(); ++k)
      if (coupled[k])
        any_coupled = true;
      else if (points[k].status.kind != Status::open)
        tractions[k] = traction_of_single(k, residual);
    if (any_coupled)
      solve_coupled(residual, tractions);
    for (unsigned int k = 0; k < points.size(); ++k)
      {
        const Tensor<1, dim - 1> d = points[k].status.direction();
        const double             bound =
          interface.bounds.law(points[k]).bound(tractions[k].p);
        if (turned[k].is_elastic)
          tractions[k].q = turned[k].shear + bound * turned[k].rotation;
        else if (points[k].status.kind == Status::stick)
          tractions[k].q += turned[k].shear;
        else if (points[k].status.kind == Status::slip)
          tractions[k].q = shear_directions[k].empty()
                             ? turned[k].shear + bound * turned[k].rotation
                             : tractions[k].q - (tractions[k].q * d) * d;
      }
    return tractions;
  }



  // With both equations of a node the pressure is the force along the normal,
  // whatever the shear; with one of them, its part in that.
  template<int dim>
  typename MultiplierRecovery<dim>::Pair
  MultiplierRecovery<dim>::traction_of_single(
    const unsigned int   k,
    const GhostedVector &residual) const
  {
    const ContactPoint<dim> &point = points[k];
    const double             own   = point.weight * point.C[0];
    Tensor<1, dim>           traction, direction;
    unsigned int             n_equations = 0;
    for (unsigned int i = 0; i < dim; ++i)
      if (!discretization.constraints.is_constrained(point.dofs(0)[i]))
        {
          ++n_equations;
          traction[i]  = -residual[point.dofs(0)[i]] / own;
          direction[i] = point.normal[i];
        }
    if (n_equations < dim)
      for (unsigned int i = 0; i < dim; ++i)
        if (!discretization.constraints.is_constrained(point.dofs(0)[i]))
          {
            const Factors f = factors({k, i, 1});
            traction[i] -= f.known;
            direction[i] = f.p;
          }
    Pair pair{traction * direction / direction.norm_square(), {}};
    for (const Tensor<1, dim - 1> &along : shear_directions[k])
      pair.q += (point.tangential_part(traction) * along) * along;
    return pair;
  }



  template<int dim>
  std::vector<unsigned int> MultiplierRecovery<dim>::first_columns() const
  {
    std::vector<unsigned int> first_column(points.size() + 1, 0);
    for (unsigned int k = 0; k < points.size(); ++k)
      first_column[k + 1] =
        first_column[k] + (coupled[k] ? 1 + shear_directions[k].size() : 0);
    return first_column;
  }



  // The unknowns are the multipliers times the root of their weight.
  template<int dim>
  std::vector<typename MultiplierRecovery<dim>::Equation>
  MultiplierRecovery<dim>::coupled_equations(
    const std::vector<unsigned int> &first_column,
    const GhostedVector             &residual) const
  {
    std::vector<Equation> system;
    for (const auto &[dof, shares] : equations)
      if (!shares.empty() && coupled[shares.front().point])
        {
          Equation equation{{}, -residual[dof]};
          for (const Share &share : shares)
            {
              const Factors f    = factors(share);
              const double  root = std::sqrt(points[share.point].weight);
              const auto    j    = first_column[share.point];
              equation.row[j] += f.p / root;
              for (unsigned int t = 0; t < f.q.size(); ++t)
                equation.row[j + 1 + t] += f.q[t] / root;
              equation.rhs -= f.known;
            }
          system.push_back(std::move(equation));
        }
    return system;
  }



  template<int dim>
  void
  MultiplierRecovery<dim>::solve_coupled(const GhostedVector &residual,
                                         std::vector<Pair>   &tractions) const
  {
    const auto           first_column = first_columns();
    const Vector<double> x =
      least_squares(coupled_equations(first_column, residual),
                    first_column.back());
    for (unsigned int k = 0; k < points.size(); ++k)
      if (coupled[k])
        {
          const double root = std::sqrt(points[k].weight);
          const auto   j    = first_column[k];
          tractions[k].p    = x[j] / root;
          for (unsigned int t = 0; t < shear_directions[k].size(); ++t)
            tractions[k].q += x[j + 1 + t] / root * shear_directions[k][t];
        }
  }



  // By the normal equations. A little on the diagonal chooses among unknowns
  // that are not unique; where they are, it is taken back by iterating with the
  // residuals of the equations themselves, in which the condition of the normal
  // equations is not squared (A. Bjorck, Numerical Methods for Least Squares
  // Problems, SIAM 1996, section 2.9.2).
  template<int dim>
  Vector<double>
  MultiplierRecovery<dim>::least_squares(const std::vector<Equation> &system,
                                         const unsigned int           n)
  {
    DynamicSparsityPattern couplings(n, n);
    for (const Equation &equation : system)
      for (const auto &a : equation.row)
        for (const auto &b : equation.row)
          couplings.add(a.first, b.first);
    for (unsigned int j = 0; j < n; ++j)
      couplings.add(j, j);
    SparsityPattern pattern;
    pattern.copy_from(couplings);
    SparseMatrix<double> matrix(pattern);
    Vector<double>       x(n), change(n);
    for (const Equation &equation : system)
      for (const auto &a : equation.row)
        for (const auto &b : equation.row)
          matrix.add(a.first, b.first, a.second * b.second);
    double largest = 0;
    for (unsigned int j = 0; j < n; ++j)
      largest = std::max(largest, matrix.diag_element(j));
    if (largest == 0) // paired anew, nobody is left in the equations
      return x;

    // Surfaces that a step has folded have no normals, and Newton's method
    // takes back a step whose residual is not a number.
    if (!numbers::is_finite(matrix.frobenius_norm()))
      {
        std::fill(x.begin(), x.end(), std::numeric_limits<double>::quiet_NaN());
        return x;
      }

    SparseMatrix<double> shifted(pattern);
    shifted.copy_from(matrix);
    for (unsigned int j = 0; j < n; ++j)
      shifted.add(j, j, 1e-10 * largest);
    SparseDirectUMFPACK solver;
    solver.factorize(shifted);
    for (unsigned int iteration = 0; iteration < 10; ++iteration)
      {
        change = 0;
        for (const Equation &equation : system)
          {
            double left = equation.rhs;
            for (const auto &[j, coefficient] : equation.row)
              left -= coefficient * x[j];
            for (const auto &[j, coefficient] : equation.row)
              change[j] += coefficient * left;
          }
        solver.solve(change);
        x += change;
        if (change.l2_norm() <=
            std::numeric_limits<double>::epsilon() * x.l2_norm())
          break;
      }
    return x;
  }



  template<int dim>
  void MultiplierRecovery<dim>::write(const GhostedVector &residual,
                                      GhostedVector       &solution) const
  {
    const auto tractions = this->tractions(residual);
    for (unsigned int k = 0; k < tractions.size(); ++k)
      {
        const ContactPoint<dim> &point                         = points[k];
        solution[interface.normal_index(point.multipliers[0])] = tractions[k].p;
        if (interface.contact_pair(point).law.is_frictionless())
          continue;
        const double bound = interface.bounds.law(point).bound(tractions[k].p);
        Tensor<1, dim - 1> q;
        if (point.status.kind == Status::stick)
          q = tractions[k].q;
        else if (point.status.has_direction())
          q = point.status.direction() * bound + tractions[k].q;
        for (unsigned int t = 0; t < dim - 1; ++t)
          solution[interface.tangential_index(point.multipliers[0], t)] = q[t];
      }
  }

  template class MultiplierRecovery<2>;
  template class MultiplierRecovery<3>;
} // namespace Contact
