/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the tangent of contact is the derivative of its residual: both
// rules, both degrees, all friction laws, sticking and slipping in both
// directions and open, with finite penetration and slip on turned and curved
// edges. With moving geometry the points are paired anew in every state that
// the difference quotient visits, else never.

#include "tests.h"

using namespace Tests;

namespace
{
  struct Law
  {
    std::string name;
    double      tresca, coulomb;
  };



  ContactModel make_model(const unsigned int degree,
                          const std::string &rule,
                          const Law         &law)
  {
    // The slave's nodes and Gauss points lie within the edges of the master.
    MeshText mesh;
    mesh.block("lower", 3, 1, rectangle({ 0, -1 }, { 3, 0 }));
    mesh.block("upper", 2, 1, rectangle({ 0.35, 0 }, { 2.55, 1 }));
    Parameters::All parameters =
      make_parameters(mesh, { "lower", "upper" }, degree, "small strain");
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.rule                 = rule;
    parameters.contact.n_gauss_points       = degree + 1;
    parameters.contact.tresca_limit         = law.tresca;
    parameters.contact.friction_coefficient = law.coulomb;
    return ContactModel(parameters);
  }



  struct System
  {
    explicit System(const ContactModel &model)
      : rhs(model.solution.size())
    {
      DynamicSparsityPattern couplings(rhs.size(), rhs.size());
      model.interface.add_couplings(couplings);
      pattern.copy_from(couplings);
      matrix.reinit(pattern);
    }

    void assemble(const ContactInterface                &interface,
                  const Vector<double>                  &solution,
                  const Vector<double>                  &start,
                  const ContactInterface::Linearization &linearization)
    {
      matrix = 0;
      rhs    = 0;
      interface.assemble(solution, start, linearization, matrix, rhs);
    }

    SparsityPattern      pattern;
    SparseMatrix<double> matrix;
    Vector<double>       rhs;
  };



  // What the difference quotients say, and whether they were allowed to.
  struct Result
  {
    double error = 0; // relative to the largest entry
    bool   edges_kept = true, within_edges = true;
    double asymmetry = 0;
  };



  void randomize(ContactModel &model)
  {
    // All turned by a finite angle and all nodes moved a little, the upper body
    // pressed into the lower one; the start of the increment elsewhere.
    Random              random;
    const Tensor<2, 2>  R = rotation(0.6);
    const auto          X = model.support_points();
    const auto          c = model.components();
    ContactInterface   &interface = model.interface;
    std::set<types::global_dof_index> upper;
    for (const auto &node : interface.slave.nodes)
      upper.insert(node.dofs.begin(), node.dofs.end());
    for (unsigned int i = 0; i < model.n_dofs(); ++i)
      {
        Point<2> sunk = X[i];
        if (upper.count(i) > 0)
          sunk[1] -= 0.08;
        model.solution[i] =
          (R * sunk)[c[i]] - X[i][c[i]] + random(-0.03, 0.03);
        model.start[i] = model.solution[i] + random(-0.1, 0.1);
      }
    for (unsigned int i = model.n_dofs(); i < model.solution.size(); ++i)
      model.solution[i] = random(0.5, 1.5);
    for (ContactPoint &point : interface.points)
      point.tresca_bound = random(0.1, 0.5);
  }



  Result compare(ContactModel                          &model,
                 const ContactInterface::Linearization &linearization)
  {
    ContactInterface &interface = model.interface;
    interface.pair(model.solution);

    Result result;
    for (const ContactPoint &point : interface.points)
      result.within_edges = result.within_edges && point.facing &&
                            std::abs(point.master_xi) < 0.99;

    System here(model), beside(model);
    here.assemble(interface, model.solution, model.start, linearization);

    double       largest = 0;
    const double h       = 1e-6;
    for (unsigned int j = 0; j < model.solution.size(); ++j)
      {
        Vector<double> column(model.solution.size());
        for (const int side : { 1, -1 })
          {
            Vector<double> moved(model.solution);
            moved[j] += side * h;
            if (linearization.moving_geometry && interface.pair(moved))
              result.edges_kept = false;
            beside.assemble(interface, moved, model.start, linearization);
            column.add(-side / (2 * h), beside.rhs);
          }
        for (unsigned int i = 0; i < column.size(); ++i)
          {
            const double k = here.matrix.el(i, j);
            result.error = std::max(result.error, std::abs(k - column[i]));
            result.asymmetry =
              std::max(result.asymmetry, std::abs(k - here.matrix.el(j, i)));
            largest = std::max(largest, std::abs(k));
          }
      }
    result.error /= largest;
    result.asymmetry /= largest;
    return result;
  }



  void check_law(const unsigned int degree,
                 const std::string &rule,
                 const Law         &law)
  {
    ContactModel model = make_model(degree, rule, law);
    randomize(model);

    std::vector<std::pair<std::string, Decision>> decisions{
      { "open", { Status::open, 0 } }
    };
    if (model.interface.law.is_frictionless())
      decisions.push_back({ "contact", { Status::slip, 0 } });
    else
      {
        decisions.push_back({ "stick", { Status::stick, 0 } });
        decisions.push_back({ "slip forward", { Status::slip, 1 } });
        decisions.push_back({ "slip backward", { Status::slip, -1 } });
      }

    headline("degree " + std::to_string(degree) + ", " + rule + " rule, " +
             law.name);
    for (const auto &[name, decision] : decisions)
      {
        for (ContactPoint &point : model.interface.points)
          point.decision = decision;
        for (const bool moving_geometry : { false, true })
          for (const bool moving_bound : { false, true })
            if (decision.slip_direction != 0 || !moving_bound)
              {
                const Result result =
                  compare(model, { moving_geometry, moving_bound });
                check_small(name + (moving_geometry ? ", moving geometry" : "") +
                              (moving_bound ? ", moving bound" : ""),
                            result.error,
                            1e-8);
                if (!result.edges_kept || !result.within_edges)
                  std::cout << "  a point changed its edge" << std::endl;

                // Contact without friction has a potential; with it the
                // pairing is the tangent's only part that has none.
                if (decision.slip_direction == 0 &&
                    (model.interface.law.is_frictionless() ||
                     !moving_geometry))
                  check_small("  asymmetry", result.asymmetry, 1e-14);
              }
      }
  }
} // namespace



int main()
{
  const std::vector<Law> laws{ { "frictionless", 0, 0 },
                               { "Tresca", 0.3, 0 },
                               { "Coulomb", 0, 0.4 } };
  for (const unsigned int degree : { 1, 2 })
    for (const std::string rule : { "nodal", "Gauss" })
      for (const Law &law : laws)
        check_law(degree, rule, law);
}
