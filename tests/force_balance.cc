/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the forces of contact on both surfaces are opposite, that no
// force is left over at a node without support, and that the reactions of the
// supports balance each other and the loads, at large displacement with
// friction on a curved surface. The forces of contact have no moment together
// where the gap is zero in every point that carries a force, so with the nodal
// rule; with the Gauss-point discretization the gap is zero in the mean only,
// and the shear leaves a small moment. With the mortar discretization it is the
// weighted gap that is zero, while the surfaces are apart or overlap between
// the nodes; that the moment vanishes all the same is because the projection
// points of a node are shifted such that its weighted gap vector is parallel to
// its normal.

#include "tests.h"

using namespace Tests;

namespace
{
  // A force and its moment about the origin.
  struct Wrench
  {
    Tensor<1, 2> force;
    double       moment = 0;

    void add(const Wrench &other)
    {
      force += other.force;
      moment += other.moment;
    }
  };



  /// The current position of the node of every unknown.
  std::vector<Point<2>> current_positions(const TwoBodies &model)
  {
    const DoFHandler<2>        &dof_handler = model.discretization.dof_handler;
    const std::vector<Point<2>> X           = model.support_points();
    std::vector<Point<2>>       x(X.size());
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const auto &fe = cell->get_fe();
        dofs.resize(fe.n_dofs_per_cell());
        cell->get_dof_indices(dofs);
        for (unsigned int a = 0; a < fe.base_element(0).n_dofs_per_cell(); ++a)
          {
            const auto     dof_x = dofs[fe.component_to_system_index(0, a)];
            const auto     dof_y = dofs[fe.component_to_system_index(1, a)];
            const Point<2> u(model.solution[dof_x], model.solution[dof_y]);
            x[dof_x] = x[dof_y] = X[dof_x] + u;
          }
      }
    return x;
  }



  /// The sum of the nodal forces on those unknowns that @p counts wants.
  Wrench sum(const TwoBodies                               &model,
             const GhostedVector                           &forces,
             const std::function<bool(const unsigned int)> &counts)
  {
    const auto x = current_positions(model);
    const auto c = model.components();
    Wrench     wrench;
    for (unsigned int i = 0; i < forces.size(); ++i)
      if (counts(i))
        {
          wrench.force[c[i]] += forces[i];
          wrench.moment += (c[i] == 0 ? -x[i][1] : x[i][0]) * forces[i];
        }
    return wrench;
  }



  /// The reactions of the supports; the forces elsewhere have to vanish.
  GhostedVector reactions(const TwoBodies &model, const double magnitude)
  {
    GhostedVector reactions = model.elasticity->forces(model.solution, 1);
    reactions -= model.contact_forces();
    double left = 0;
    for (unsigned int i = 0; i < reactions.size(); ++i)
      if (!model.discretization.is_fixed(i))
        {
          left         = std::max(left, std::abs(reactions[i]));
          reactions[i] = 0;
        }
    check_small("forces left over", left / magnitude, 1e-10);
    return reactions;
  }



  bool all(const unsigned int)
  {
    return true;
  }



  std::set<unsigned int> unknowns_of(const Surface<2> &surface)
  {
    std::set<unsigned int> dofs;
    for (const auto &node : surface.nodes)
      dofs.insert(node.dofs.begin(), node.dofs.end());
    return dofs;
  }



  /// The places of the points of contact.
  struct Rule
  {
    std::string name;
    bool        flat_is_slave = false;
  };



  std::string named(const unsigned int degree, const Rule &rule)
  {
    return "degree " + std::to_string(degree) + ", " + rule.name + " rule" +
           (rule.flat_is_slave ? ", flat side slave" : "");
  }



  // A block with a round lower side on a flat block.
  Parameters::All make_case(const unsigned int degree, const Rule &rule)
  {
    const Point<2> center(0.1, 2);
    const double   radius = 2;
    MeshText       mesh;
    mesh.block("lower", 7, 2, rectangle({-1.5, -1}, {1.5, 0}));
    mesh.block("upper", 7, 2, [&](const double s, const double t) {
      const double x = center[0] + 1.6 * (s - 0.5);
      const double arc =
        center[1] - std::sqrt(radius * radius - std::pow(x - center[0], 2));
      return Point<2>(x, arc + t * (1 - arc));
    });
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, degree, "large displacement");

    parameters.mesh.arcs["upper bottom"] = {center[0], center[1], radius};
    parameters.contact.slave             = "upper bottom";
    parameters.contact.master            = "lower top";
    if (rule.flat_is_slave)
      std::swap(parameters.contact.slave, parameters.contact.master);
    parameters.contact.discretization                   = rule.name;
    parameters.contact.n_gauss_points                   = 3;
    parameters.contact.friction_coefficient             = 0.3;
    parameters.boundary.displacement[0]["lower bottom"] = 0;
    parameters.boundary.displacement[1]["lower bottom"] = 0;
    return parameters;
  }



  // As TwoBodies::solve(), but the tangent of the mortar discretization
  // keeps the pairing; that is repeated in each step, and moves less and less.
  bool solve(TwoBodies &model, const Rule &rule, const double load_factor)
  {
    if (rule.name != "mortar")
      return model.solve(load_factor, true) > 0;

    model.start = model.solution;
    model.discretization.constrain_update(model.solution, load_factor);
    model.pair();
    model.interface.active_set.initialize(model.solution);
    GhostedVector rhs(model.solution.size());
    for (unsigned int iteration = 0; iteration < 100; ++iteration)
      {
        model.pair();
        const bool changed = iteration == 0 || model.updated_status();
        model.matrix       = 0;
        rhs                = 0;
        model.elasticity->assemble(model.solution,
                                   load_factor,
                                   rhs,
                                   &model.matrix);
        ContactKernel<2>(model.interface)
          .assemble(model.solution, model.start, {false}, rhs, &model.matrix);
        for (unsigned int i = 0; i < model.n_dofs(); ++i)
          if (model.discretization.constraints.is_constrained(i))
            {
              model.matrix.diag_element(i) = 1;
              rhs[i]                       = 0;
            }
        const double scale =
          model.elasticity->forces(model.solution, load_factor).linfty_norm();
        if (!changed && rhs.linfty_norm() < 1e-12 * scale)
          return true;

        model.solver.factorize(model.matrix);
        model.solver.solve(rhs);
        model.discretization.distribute(model.discretization.constraints, rhs);
        model.solution += rhs;
        model.discretization.constrain_update(model.solution, load_factor);
      }
    return false;
  }



  void print_contact(const TwoBodies &model)
  {
    double largest_gap = 0;
    for (const ContactPoint<2> &point : model.interface.points())
      if (point.status.kind != Status::open)
        largest_gap = std::max(
          largest_gap,
          std::abs(
            model.interface.state(point, model.solution, model.start).gap));
    const StatusCount count = model.interface.active_set.count();
    std::cout << "  active " << count.active << ", stick " << count.stick
              << std::endl;
    std::cout << "  the gap is zero in "
              << (largest_gap < 1e-12 ? "every active point" : "the mean only")
              << std::endl;
  }



  // The upper side is pressed down and dragged along.
  void drag(const unsigned int degree, const Rule &rule)
  {
    headline("dragged, " + named(degree, rule));
    Parameters::All parameters                       = make_case(degree, rule);
    parameters.boundary.displacement[0]["upper top"] = 0.03;
    parameters.boundary.displacement[1]["upper top"] = -0.08;
    TwoBodies model(parameters);
    check("converges", solve(model, rule, 0.5) && solve(model, rule, 1));
    print_contact(model);

    const GhostedVector forces = model.elasticity->forces(model.solution, 1);
    const auto          slave  = unknowns_of(model.interface.pairs[0]->slave);
    const auto master = unknowns_of((*model.interface.pairs[0]->master));

    const auto on = [&](const auto &surface) {
      return sum(model, forces, [&](const unsigned int i) {
        return surface.count(i) > 0;
      });
    };
    const Wrench on_slave  = on(slave);
    Wrench       together  = on(master);
    const double magnitude = on_slave.force.norm();
    together.add(on_slave);
    check("there is a shear force",
          std::abs(on_slave.force[0]) > 0.05 * magnitude);
    check_small("force of contact on both bodies",
                together.force.norm() / magnitude,
                1e-10);

    // By the width of the block of 3 mm.
    const double moment = std::abs(together.moment) / (3 * magnitude);
    if (rule.name != "Gauss")
      check_small("moment of contact on both bodies", moment, 1e-10);
    else
      {
        check_small("moment of contact on both bodies", moment, 1e-5);
        check("but more than round-off", moment > 1e-10);
      }

    const Wrench held = sum(model, reactions(model, magnitude), all);
    check_small("reactions together", held.force.norm() / magnitude, 1e-10);
    check_small("moment of the stresses in both bodies",
                std::abs(sum(model, forces, all).moment) / (3 * magnitude),
                1e-10);
  }



  // Half of the problem, with a dead force on the symmetry line. The bodies
  // overlap at first: without contact nothing would hold the upper one.
  void load(const unsigned int degree, const Rule &rule)
  {
    headline("loaded, " + named(degree, rule));
    const double force = 6;
    MeshText     mesh;
    mesh.block("lower", 5, 2, rectangle({0, -1}, {1.5, 0}));
    mesh.block("upper", 4, 2, [&](const double s, const double t) {
      const double arc = 1.98 - std::sqrt(4 - s * s);
      return Point<2>(s, arc + t * (1 - arc));
    });
    Parameters::All       parameters = make_case(degree, rule);
    const Parameters::All description =
      make_parameters(mesh, {"lower", "upper"}, degree, "large displacement");
    parameters.mesh                                   = description.mesh;
    parameters.mesh.arcs["upper bottom"]              = {0, 1.98, 2};
    parameters.boundary.displacement[0]["lower left"] = 0;
    parameters.boundary.displacement[0]["upper left"] = 0;
    parameters.boundary.force[1]["upper top left"]    = -force;
    TwoBodies model(parameters);
    check("converges", solve(model, rule, 0.5) && solve(model, rule, 1));
    print_contact(model);

    const Wrench held = sum(model, reactions(model, force), all);
    check_small("vertical reactions and load",
                std::abs(held.force[1] - force) / force,
                1e-10);
    check_small("horizontal reactions", std::abs(held.force[0]) / force, 1e-10);
    // The load acts on the line x = 0, so that its moment vanishes.
    if (rule.name != "Gauss")
      check_small("moment of the reactions",
                  std::abs(held.moment) / (1.5 * force),
                  1e-10);
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    for (const Rule &rule :
         {Rule{"nodal"}, Rule{"Gauss"}, Rule{"mortar"}, Rule{"mortar", true}})
      {
        drag(degree, rule);
        load(degree, rule);
      }
  return 0;
}
