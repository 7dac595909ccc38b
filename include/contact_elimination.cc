/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact_elimination.h"

#include <deal.II/lac/full_matrix.h>

#include "counters.h"
#include "errors.h"

namespace Contact
{
  namespace
  {
    /// What holds a slave node can not be eliminated with it: the node would
    /// hold the master.
    [[noreturn]] void refuse_held(const ContactPoint &point,
                                  const std::string  &how)
    {
      throw InputError("the node of the slave at (" +
                         std::to_string(point.X[0][0]) + ", " +
                         std::to_string(point.X[0][1]) +
                         ") is held by a support " + how,
                       "Boundary conditions, Contact/Slave",
                       "exchange slave and master, set 'Rule = mortar', or "
                       "'System = saddle point'");
    }
  } // namespace



  ContactElimination::ContactElimination(const Discretization   &discretization,
                                         const ContactInterface *interface)
    : discretization(discretization)
    , interface(interface)
  {
    if (interface == nullptr)
      return;
    for (const ContactPoint &point : interface->points)
      slave_dofs.insert(point.dofs[0].begin(), point.dofs[0].end());
    if (interface->zones.size() > 1)
      check_zones();
  }



  // The force on a slave node that is eliminated tells the traction of one
  // point only.
  void ContactElimination::check_zones() const
  {
    std::map<types::global_dof_index, const ContactZone *> zone_of_slave;
    const auto refuse = [](const Surface::Node &node, const ContactZone &zone) {
      throw InputError("the node at (" + std::to_string(node.X[0]) + ", " +
                         std::to_string(node.X[1]) +
                         ") is on the slave of one zone and on a surface of "
                         "another one",
                       "section 'Contact" +
                         (zone.name.empty() ? "" : " " + zone.name) + "'",
                       "let the surfaces end before they meet, or set 'System "
                       "= saddle point'");
    };
    for (const auto &zone : interface->zones)
      for (const Surface::Node &node : zone->slave.nodes)
        if (!zone_of_slave.emplace(node.dofs[0], zone.get()).second)
          refuse(node, *zone);
    for (const auto &zone : interface->zones)
      if (zone->master)
        for (const Surface::Node &node : zone->master->nodes)
          if (zone_of_slave.count(node.dofs[0]) > 0)
            refuse(node, *zone);
  }



  void ContactElimination::add_base_line(const types::global_dof_index dof)
  {
    const auto &base = discretization.constraints;
    if (!base.is_constrained(dof) || lines.is_constrained(dof))
      return;
    lines.add_line(dof);
    if (const auto *entries = base.get_constraint_entries(dof))
      lines.add_entries(dof, *entries);
    lines.set_inhomogeneity(dof, base.get_inhomogeneity(dof));
  }



  void ContactElimination::make(const Vector<double> &solution,
                                const Vector<double> &u_start,
                                const Dofs           &surroundings)
  {
    lines.clear();
    eliminated.clear();
    contact_lines.clear();
    users_of_slave_dofs.clear();

    for (const auto dof : surroundings)
      add_base_line(dof);
    if (interface != nullptr)
      for (const ContactPoint &point : interface->points)
        if (point.decision.status != Status::open)
          {
            const ContactState now = interface->state(point, solution, u_start);
            if (point.decision.status == Status::stick)
              add_stick_lines(point, now.gap, now.slip);
            else
              add_normal_line(point, now.gap);
          }

    for (const auto &[dof, line] : contact_lines)
      {
        eliminated.push_back(dof);
        lines.add_line(dof);
        lines.set_inhomogeneity(dof, line.constant);
        for (const auto &[other, coefficient] : line.entries)
          lines.add_entry(dof, other, coefficient);
      }
    lines.close();
  }



  void ContactElimination::add_normal_line(const ContactPoint &point,
                                           const double        gap)
  {
    const auto fixed = [&](const unsigned int i) {
      return discretization.is_fixed(point.dofs[0][i]);
    };
    const unsigned int i =
      fixed(0) ||
          (!fixed(1) && std::abs(point.normal[1]) >= std::abs(point.normal[0]))
        ? 1
        : 0;
    if (fixed(i))
      refuse_held(point, "in both directions");
    const double scale = point.C[0] * point.normal[i];
    const auto   dof   = point.dofs[0][i];

    Line line;
    line.constant = -gap / scale;
    for (unsigned int a = 0; a < point.n_nodes; ++a)
      for (unsigned int j = 0; j < 2; ++j)
        if (point.dofs[a][j] != dof && point.normal[j] != 0)
          line.entries[point.dofs[a][j]] -=
            point.C[a] * point.normal[j] / scale;
    eliminate(dof, line);
  }



  void ContactElimination::add_stick_lines(const ContactPoint &point,
                                           const double        gap,
                                           const double        slip)
  {
    ++counters().tangential_rows;
    for (unsigned int i = 0; i < 2; ++i)
      {
        if (discretization.is_fixed(point.dofs[0][i]))
          refuse_held(point, "and sticks");
        Line line;
        line.constant =
          -(gap * point.normal[i] + slip * point.tangent[i]) / point.C[0];
        for (unsigned int a = 1; a < point.n_nodes; ++a)
          line.entries[point.dofs[a][i]] -= point.C[a] / point.C[0];
        eliminate(point.dofs[0][i], line);
      }
  }



  // Where the mortar rule faces the master in part, points see the nodes of
  // each other: Gauss' elimination, of few lines.
  void ContactElimination::eliminate(const types::global_dof_index dof,
                                     Line                          line)
  {
    const auto substitute =
      [](Line &in, const types::global_dof_index what, const Line &by) {
        const double c = in.entries.at(what);
        in.entries.erase(what);
        in.constant += c * by.constant;
        for (const auto &[other, coefficient] : by.entries)
          in.entries[other] += c * coefficient;
      };

    const auto entries = line.entries;
    for (const auto &entry : entries)
      if (const auto known = contact_lines.find(entry.first);
          known != contact_lines.end())
        substitute(line, entry.first, known->second);

    if (const auto own = line.entries.find(dof); own != line.entries.end())
      {
        const double factor = 1 / (1 - own->second);
        line.entries.erase(own);
        line.constant *= factor;
        for (auto &entry : line.entries)
          entry.second *= factor;
      }

    std::set<types::global_dof_index> users;
    if (const auto found = users_of_slave_dofs.find(dof);
        found != users_of_slave_dofs.end())
      {
        users = std::move(found->second);
        users_of_slave_dofs.erase(found);
      }
    for (const auto user : users)
      substitute(contact_lines.at(user), dof, line);
    users.insert(dof);
    for (const auto &entry : line.entries)
      if (slave_dofs.count(entry.first) > 0)
        users_of_slave_dofs[entry.first].insert(users.begin(), users.end());
    contact_lines[dof] = line;
  }



  // The transpose of the elimination: the force on an eliminated unknown goes
  // to those that move it.
  void ContactElimination::condense(Vector<double> &rhs) const
  {
    for (const auto line : eliminated)
      {
        for (const auto &[dof, coefficient] :
             *lines.get_constraint_entries(line))
          rhs[dof] += coefficient * rhs[line];
        rhs[line] = 0;
      }
  }



  void ContactElimination::for_each_entry(
    const std::function<void(const types::global_dof_index line,
                             const types::global_dof_index dof)> &visit) const
  {
    for (const auto line : eliminated)
      for (const auto &entry : *lines.get_constraint_entries(line))
        visit(line, entry.first);
  }



  // The lines as numbers, to see whether they are others than before.
  std::vector<double> ContactElimination::signature() const
  {
    std::vector<double> signature;
    for (const auto line : eliminated)
      {
        signature.push_back(line);
        for (const auto &[dof, coefficient] :
             *lines.get_constraint_entries(line))
          {
            signature.push_back(dof);
            signature.push_back(coefficient);
          }
      }
    return signature;
  }



  void ContactElimination::distribute(Vector<double> &update) const
  {
    for (const auto &line : lines.get_lines())
      {
        double value = line.inhomogeneity;
        for (const auto &[dof, coefficient] : line.entries)
          value += coefficient * update[dof];
        update[line.index] = value;
      }
    discretization.constraints.distribute(update);
  }



  // The forces of the bodies on the slave nodes are
  //   sum over the points of w C_k (p n + q t) = f_k.
  // Most points see no slave node but their own; the others are solved for
  // together.
  std::vector<Tensor<1, 2>>
  ContactElimination::tractions(const Vector<double> &residual) const
  {
    const auto                                     &points = interface->points;
    std::map<types::global_dof_index, unsigned int> point_of_dof;
    for (unsigned int q = 0; q < points.size(); ++q)
      if (points[q].decision.status != Status::open)
        point_of_dof[points[q].dofs[0][0]] = q;

    std::vector<Tensor<1, 2>> tractions(points.size());
    std::set<unsigned int>    coupled;
    for (const auto &[dof, q] : point_of_dof)
      {
        for (unsigned int i = 0; i < 2; ++i)
          tractions[q][i] = -residual[points[q].dofs[0][i]] /
                            (points[q].weight * points[q].C[0]);
        for (unsigned int a = 1; a < points[q].n_slave_nodes; ++a)
          if (const auto other = point_of_dof.find(points[q].dofs[a][0]);
              other != point_of_dof.end())
            coupled.insert({q, other->second});
      }
    if (coupled.empty())
      return tractions;

    const std::vector<unsigned int> set(coupled.begin(), coupled.end());
    FullMatrix<double>              shares(set.size(), set.size());
    for (unsigned int k = 0; k < set.size(); ++k)
      for (unsigned int l = 0; l < set.size(); ++l)
        for (unsigned int a = 0; a < points[set[l]].n_slave_nodes; ++a)
          if (points[set[l]].dofs[a] == points[set[k]].dofs[0])
            shares(k, l) += points[set[l]].weight * points[set[l]].C[a];
    shares.gauss_jordan();
    for (unsigned int k = 0; k < set.size(); ++k)
      {
        tractions[set[k]] = Tensor<1, 2>();
        for (unsigned int l = 0; l < set.size(); ++l)
          for (unsigned int i = 0; i < 2; ++i)
            tractions[set[k]][i] -=
              shares(k, l) * residual[points[set[l]].dofs[0][i]];
      }
    return tractions;
  }



  void ContactElimination::recover_pressures(const Vector<double> &residual,
                                             Vector<double> &solution) const
  {
    const auto tractions = this->tractions(residual);
    for (unsigned int k = 0; k < tractions.size(); ++k)
      {
        const ContactPoint &point = interface->points[k];
        double &p = solution[interface->normal_index(point.multipliers[0])];
        p         = 0;
        if (point.decision.status == Status::open)
          continue;
        // Where a support takes a part of the force, the component that is
        // free tells the whole.
        double free = 0;
        for (unsigned int i = 0; i < 2; ++i)
          if (!discretization.is_fixed(point.dofs[0][i]))
            free += point.normal[i] * point.normal[i];
        p = tractions[k] * point.normal / free;
      }
  }



  void ContactElimination::recover_shears(const Vector<double> &residual,
                                          Vector<double>       &solution) const
  {
    if (interface->n_multipliers() == interface->n_normal_multipliers())
      return;
    const auto tractions = this->tractions(residual);
    for (unsigned int k = 0; k < tractions.size(); ++k)
      {
        const ContactPoint &point = interface->points[k];
        if (interface->zone(point).law.is_frictionless())
          continue;
        double &q = solution[interface->tangential_index(point.multipliers[0])];
        if (point.decision.status == Status::stick)
          q = tractions[k] * point.tangent;
        else if (point.decision.slip_direction != 0)
          q = point.decision.slip_direction * point.tresca_bound;
        else
          q = 0;
      }
  }
} // namespace Contact
