/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed/contact_elimination.h"

#include <algorithm>
#include <cmath>

#include "base/exchange.h"

namespace Contact
{
  namespace
  {
    /// An unknown of its own node is the pivot of a point if no coefficient of
    /// the equation is a hundred times as large.
    const double smallest_of_own = 1e-2;

    /// The rest of an equation that follows from others is round-off: of the
    /// same sums in another order, and of the pairing.
    const double smallest_of_any = 1e-8;
  } // namespace



  template<int dim>
  ContactElimination<dim>::ContactElimination(
    const DiscretizedBodies<dim> &discretization,
    const ContactInterface<dim>  *interface)
    : discretization(discretization)
    , interface(interface)
    , rows(slave_dofs)
    , test_rows(slave_dofs)
  {
    if (interface != nullptr)
      for (const ContactPoint<dim> &point : interface->points())
        slave_dofs.insert(point.dofs(0).begin(), point.dofs(0).end());
  }



  template<int dim>
  void
  ContactElimination<dim>::add_base_lines(const Dofs &surroundings,
                                          AffineConstraints<double> &to) const
  {
    const auto &base = discretization.constraints;
    for (const auto dof : surroundings)
      if (base.is_constrained(dof))
        {
          to.add_line(dof);
          if (const auto *entries = base.get_constraint_entries(dof))
            to.add_entries(dof, *entries);
          to.set_inhomogeneity(dof, base.get_inhomogeneity(dof));
        }
  }



  template<int dim>
  void ContactElimination<dim>::add_contact_lines(
    const RowElimination      &rows,
    AffineConstraints<double> &to) const
  {
    for (const auto &[dof, line] : rows.lines())
      {
        to.add_line(dof);
        to.set_inhomogeneity(dof, line.constant);
        for (const auto &[other, coefficient] : line.entries)
          to.add_entry(dof, other, coefficient);
      }
    to.close();
  }



  template<int dim>
  void ContactElimination<dim>::make(const GhostedVector &solution,
                                     const GhostedVector &u_start,
                                     const Dofs          &surroundings,
                                     const GhostedVector &moved,
                                     const bool           any_rank_may_add)
  {
    lines.clear();
    test_lines.clear();
    eliminated.clear();
    rows.clear();
    test_rows.clear();
    contradictions = {};

    // A point that slips under a moving bound makes the matrix unsymmetric, and
    // a change of the pairing.
    symmetric = true;
    if (interface != nullptr && interface->bounds.follow)
      for (const ContactPoint<dim> &point : interface->points())
        if (!point.change.dofs.empty() ||
            ((point.status.has_direction() ||
              (point.status.kind == Status::stick && point.elastic_slip > 0)) &&
             interface->contact_pair(point).law.coulomb_coefficient > 0))
          symmetric = false;

    add_base_lines(surroundings, lines);
    turning.clear();
    of_pairing.clear();
    if (interface != nullptr)
      {
        if (!symmetric)
          of_pairing =
            PairingStiffness<dim>::terms(*interface, solution, u_start);
        turning = SlipDirectionStiffness<dim>::terms(*interface,
                                                     solution,
                                                     u_start,
                                                     any_rank_may_add);
        if (&moved != &solution)
          for (auto &term : turning)
            {
              const ContactPoint<dim> &point = interface->points()[term.point];
              const Tensor<1, dim>     load =
                point.weight *
                point.along_tangents(
                  term.of_slip *
                  (interface->state(point, solution, u_start).slip -
                   interface->state(point, moved, u_start).slip));
              for (unsigned int k = 0; k < term.load.size(); ++k)
                term.load[k] += point.C[k / dim] * load[k % dim];
            }
        const auto                     &points = interface->points();
        std::vector<Tensor<1, dim - 1>> rotations(points.size());
        for (const auto &term : turning)
          rotations[term.point] = term.rotation;
        for (unsigned int k = 0; k < points.size(); ++k)
          if (points[k].status.kind != Status::open)
            eliminate_point(points[k], rotations[k], moved, u_start);
      }

    add_contact_lines(rows, lines);
    for (const auto &line : rows.lines())
      eliminated.push_back(line.first);
    if (!symmetric)
      {
        add_base_lines(surroundings, test_lines);
        for (const auto dof : surroundings)
          if (test_lines.is_constrained(dof))
            test_lines.set_inhomogeneity(dof, 0);
        add_contact_lines(test_rows, test_lines);
      }
  }



  // Normal and tangent of a sticking point span both coordinates.
  template<int dim>
  void
  ContactElimination<dim>::eliminate_point(const ContactPoint<dim>  &point,
                                           const Tensor<1, dim - 1> &rotation,
                                           const GhostedVector      &solution,
                                           const GhostedVector      &u_start)
  {
    const ContactState<dim> now = interface->state(point, solution, u_start);
    const auto moves = [&](const Tensor<1, dim> &direction, const double way) {
      return equation(point,
                      with_slide(point, direction, solution, u_start),
                      -way);
    };
    if (point.status.kind == Status::stick && !now.is_elastic)
      {
        ++discretization.counters.tangential_rows;
        const Tensor<1, dim> away =
          now.gap * point.normal + point.along_tangents(now.slip);
        for (const Tensor<1, dim> &direction : point.directions_of_slip())
          {
            const Row row = moves(direction, away * direction);
            eliminate(point,
                      row,
                      symmetric ? row : equation(point, direction, 0));
          }
        return;
      }
    const Row    row = moves(point.normal, now.gap);
    const double by_p =
      interface->contact_pair(point).law.bound_derivative(now.p_trial);
    const Tensor<1, dim> along =
      point.along_tangents(by_p * (point.status.direction() + rotation));
    eliminate(point,
              row,
              symmetric ? row : equation(point, point.normal + along, 0));
  }



  // Gaps are of the places of the nodes, slips of their ways.
  template<int dim>
  Tensor<1, dim>
  ContactElimination<dim>::with_slide(const ContactPoint<dim> &point,
                                      const Tensor<1, dim>    &direction,
                                      const GhostedVector     &solution,
                                      const GhostedVector     &u_start) const
  {
    Tensor<1, dim> sum = direction;
    if (symmetric)
      return sum;
    const Tensor<1, dim> along =
      point.along_tangents(point.tangential_part(direction));
    const Tensor<1, dim> across = direction - along;
    for (unsigned int a = 0; a < point.change.slide.size(); ++a)
      {
        double way = 0;
        for (unsigned int i = 0; i < dim; ++i)
          {
            const auto dof = point.dofs(a)[i];
            way += across[i] * (point.X(a)[i] + solution[dof]) +
                   along[i] * (solution[dof] - u_start[dof]);
          }
        sum += way * point.change.slide[a];
      }
    return sum;
  }



  // An unknown that is tied to another is replaced by that. One that is held
  // stays in the equation: it has a line of its own.
  template<int dim>
  typename ContactElimination<dim>::Row
  ContactElimination<dim>::equation(const ContactPoint<dim> &point,
                                    const Tensor<1, dim>    &direction,
                                    const double             constant) const
  {
    const auto &base = discretization.constraints;
    Row         row;
    row.constant = constant;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        {
          const Dof    dof = point.dofs(a)[i];
          const double c   = point.C[a] * direction[i];
          if (c == 0)
            continue;
          const auto *entries = base.get_constraint_entries(dof);
          if (entries == nullptr || entries->empty())
            row.entries[dof] += c;
          else
            {
              row.constant -= c * base.get_inhomogeneity(dof);
              for (const auto &entry : *entries)
                row.entries[entry.first] += c * entry.second;
            }
        }
    return row;
  }



  template<int dim>
  void ContactElimination<dim>::eliminate(const ContactPoint<dim> &point,
                                          Row                      row,
                                          Row                      test_row)
  {
    const double size    = row.largest();
    bool         is_held = true;
    for (const auto &entry : row.entries)
      is_held =
        is_held && discretization.constraints.is_constrained(entry.first);

    rows.reduce(row);
    if (!symmetric)
      test_rows.reduce(test_row);
    const Dof dof =
      pivot(point, row, symmetric ? row : test_row, smallest_of_any * size);
    if (dof == numbers::invalid_dof_index)
      {
        drop(point, row, is_held);
        return;
      }
    rows.eliminate(dof, row);
    if (!symmetric)
      {
        test_row.constant = 0;
        test_rows.eliminate(dof, test_row);
      }
  }



  // A pivot has to serve both equations: what counts is its smaller part in the
  // largest coefficient of either.
  template<int dim>
  typename ContactElimination<dim>::Dof
  ContactElimination<dim>::pivot(const ContactPoint<dim> &point,
                                 const Row               &row,
                                 const Row               &test_row,
                                 const double             smallest) const
  {
    const auto is_free = [this](const Dof dof) {
      return !discretization.constraints.is_constrained(dof);
    };
    const auto largest_free = [&](const Row &of) {
      double largest = 0;
      for (const auto &[dof, coefficient] : of.entries)
        if (is_free(dof))
          largest = std::max(largest, std::abs(coefficient));
      return largest;
    };
    const double largest = largest_free(row), of_test = largest_free(test_row);
    if (largest <= smallest || of_test <= smallest)
      return numbers::invalid_dof_index;
    const auto share = [&](const Dof dof) {
      return is_free(dof) ? std::min(std::abs(row[dof]) / largest,
                                     std::abs(test_row[dof]) / of_test)
                          : 0.;
    };

    Dof own = point.dofs(0)[0];
    for (const Dof dof : point.dofs(0))
      if (share(dof) >= share(own))
        own = dof;
    if (share(own) >= smallest_of_own)
      return own;
    Dof best = own;
    for (const auto &entry : row.entries)
      if (share(entry.first) > share(best))
        best = entry.first;
    return share(best) > smallest_of_any ? best : numbers::invalid_dof_index;
  }



  // An equation that follows from others is redundant, or contradicts them.
  template<int dim>
  void ContactElimination<dim>::drop(const ContactPoint<dim> &point,
                                     const Row               &row,
                                     const bool               is_held)
  {
    double left = -row.constant;
    for (const auto &[dof, coefficient] : row.entries)
      left += coefficient * discretization.constraints.get_inhomogeneity(dof);
    contradictions.add(point, left, is_held);
  }



  template<int dim>
  void ContactElimination<dim>::condense(GhostedVector &rhs) const
  {
    for (const auto line : eliminated)
      {
        for (const auto &[dof, coefficient] :
             *test_constraints().get_constraint_entries(line))
          rhs[dof] += coefficient * rhs[line];
        rhs[line] = 0;
      }
  }



  template<int dim>
  void ContactElimination<dim>::for_each_entry(
    const std::function<void(const Dof line, const Dof dof)> &visit) const
  {
    for (const auto line : eliminated)
      {
        for (const auto &entry : *lines.get_constraint_entries(line))
          visit(line, entry.first);
        if (!symmetric)
          for (const auto &entry : *test_lines.get_constraint_entries(line))
            visit(line, entry.first);
      }
  }



  template<int dim>
  typename ContactElimination<dim>::Dofs
  ContactElimination<dim>::dofs_in_contact() const
  {
    Dofs dofs = eliminated;
    if (interface != nullptr)
      for (const ContactPoint<dim> &point : interface->points())
        if (point.status.kind != Status::open)
          dofs.insert(dofs.end(), point.dofs(0).begin(), point.dofs(0).end());
    sort_unique(dofs);
    return dofs;
  }



  // The lines as numbers, to see whether they are others than before.
  template<int dim>
  std::vector<double> ContactElimination<dim>::signature() const
  {
    std::vector<double> signature;
    const auto          add = [&](const AffineConstraints<double> &of) {
      for (const auto line : eliminated)
        {
          signature.push_back(line);
          for (const auto &[dof, coefficient] :
               *of.get_constraint_entries(line))
            {
              signature.push_back(dof);
              signature.push_back(coefficient);
            }
        }
    };
    add(lines);
    if (!symmetric)
      add(test_lines);
    for (const auto &term : turning)
      signature.insert(signature.end(),
                       term.stiffness.begin(),
                       term.stiffness.end());
    for (const auto &term : of_pairing)
      term.add_signature(signature);
    return signature;
  }



  template<int dim>
  void ContactElimination<dim>::distribute(GhostedVector &update) const
  {
    discretization.distribute(lines, update);
    discretization.distribute(discretization.constraints, update);
  }



  template<int dim>
  void
  ContactElimination<dim>::recover_multipliers(const GhostedVector &residual,
                                               const GhostedVector &u_start,
                                               GhostedVector &solution) const
  {
    MultiplierRecovery<dim>(
      discretization,
      *interface,
      eliminated,
      SlipDirectionStiffness<dim>::rotated_shears(turning,
                                                  *interface,
                                                  solution,
                                                  u_start))
      .write(residual, solution);
  }

  template class ContactElimination<2>;
  template class ContactElimination<3>;
} // namespace Contact
