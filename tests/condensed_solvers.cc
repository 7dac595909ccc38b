/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves of the system without multipliers that its matrix is symmetric and
// positive definite, that its solvers agree, that a system which was used
// before has the solution of a new one, and that tied surfaces move as one.

#include "condensed.h"
#include "condensed_model.h"

using namespace Tests;

namespace
{
  /// The largest |a_ij - a_ji| of a matrix by its largest entry, and whether
  /// random vectors x give x.Ax > 0.
  void check_matrix(const DefiniteSolver::Matrix &matrix)
  {
    double asymmetry = 0, largest = 0;
    for (const auto &entry : matrix)
      {
        asymmetry = std::max(asymmetry,
                             std::abs(entry.value() -
                                      matrix.el(entry.column(), entry.row())));
        largest   = std::max(largest, std::abs(entry.value()));
      }
    check_small("asymmetry", asymmetry / largest, 1e-14);

    Random                 random;
    DefiniteSolver::Vector x(matrix.locally_owned_domain_indices(),
                             matrix.get_mpi_communicator());
    bool                   positive = true;
    for (unsigned int k = 0; k < 10; ++k)
      {
        for (double &value : x)
          value = random(-1, 1);
        positive = positive && matrix.matrix_norm_square(x) > 0;
      }
    check("positive for ten vectors", positive);
  }



  /// In the middle of an increment, with friction and moving supports.
  void matrices_and_solvers(const CondensedCase &c)
  {
    headline(c.rule + " rule, degree " + std::to_string(c.degree) + ", " +
             c.kinematics);
    const Parameters::All parameters = make_case(c);
    CondensedModel        model(parameters);
    check("converges", model.solve(0.6));
    model.start = model.solution;
    model.discretization.constrain_update(model.solution, 1);
    model.assemble(1, false);

    const double  tolerance = 1e-12 * model.rhs.linfty_norm();
    GhostedVector reference;
    for (const std::string name : {"CHOLMOD", "MUMPS", "AMG"})
      {
        model.make_system(name);
        model.pair();
        model.condensed->solve(model.solution,
                               model.start,
                               model.rhs,
                               tolerance,
                               model.update);
        if (name == "CHOLMOD")
          {
            check_matrix(model.condensed->system_matrix());
            reference = model.update;
          }
        else
          check_small(name + " and CHOLMOD",
                      difference(reference, model.update, 0, reference.size()),
                      1e-9);

        // The same statuses: only the right-hand side is another one.
        GhostedVector again(model.update.size());
        model.condensed->solve(model.solution,
                               model.start,
                               model.rhs,
                               tolerance,
                               again);
        check_small(name + ", the same once more",
                    difference(model.update, again, 0, again.size()),
                    1e-9);
      }
  }



  // Other statuses on the same system: what is kept of the matrix serves.
  void other_decisions(const CondensedCase &c)
  {
    const Parameters::All parameters = make_case(c);
    CondensedModel        model(parameters);
    model.solve(0.6);
    model.start = model.solution;
    model.discretization.constrain_update(model.solution, 1);

    // With every third point in another state, and back again.
    const auto old_decisions = [&]() {
      std::vector<PointStatus<2>> statuses;
      for (const ContactPoint<2> &point : model.interface->points())
        statuses.push_back(point.status);
      return statuses;
    }();
    double worst = 0;
    for (unsigned int round = 0; round < 4; ++round)
      {
        std::vector<PointStatus<2>> statuses(old_decisions.size());
        for (unsigned int q = 0; q < old_decisions.size(); ++q)
          {
            statuses[q] = old_decisions[q];
            if (q % 3 != round || !model.interface->points()[q].facing)
              continue;
            if (statuses[q].kind == Status::slip)
              statuses[q] = PointStatus<2>();
            else
              statuses[q] = {Status::slip, round == 0 ? 1 : -1};
          }
        model.interface->active_set.set_statuses(statuses);
        model.assemble(1, false);
        model.condensed->solve(model.solution,
                               model.start,
                               model.rhs,
                               0,
                               model.update);

        ContactElimination<2> elimination(model.discretization,
                                          model.interface.get());
        AssembledSystem<2>    fresh(model.discretization,
                                 *model.elasticity,
                                 model.interface.get(),
                                 elimination,
                                 Parameters::SolverKind::cholmod,
                                 model.timer);
        fresh.update_pattern();
        GhostedVector update(model.update.size());
        fresh.solve(model.solution, model.start, model.rhs, 0, update);
        worst =
          std::max(worst, difference(update, model.update, 0, update.size()));
      }
    check_small(c.rule + " rule, degree " + std::to_string(c.degree) +
                  ", a system that was used before and a new one",
                worst,
                1e-10);
  }



  // Two blocks stretched and sheared as one. The stress is uniform where
  // nothing else than the top and the bottom is held in y.
  void
  tied(const std::string &rule, const unsigned int degree, const bool shear)
  {
    MeshText mesh;
    mesh.block("lower", 4, 2, rectangle({0, -1}, {2, 0}));
    mesh.block("upper", rule == "nodal" ? 4 : 7, 2, rectangle({0, 0}, {2, 1}));
    Parameters::All parameters =
      make_parameters(mesh,
                      {"lower", "upper"},
                      degree,
                      shear ? "large displacement" : "small strain",
                      youngs_modulus);
    parameters.contact.slave            = "upper bottom";
    parameters.contact.master           = "lower top";
    parameters.contact.discretization   = rule;
    parameters.contact.tied             = true;
    parameters.boundary.displacement[1] = {{"lower bottom", 0},
                                           {"upper top", 0.02}};
    if (shear)
      parameters.boundary.displacement[0] = {{"lower bottom", 0},
                                             {"upper top", 0.3}};
    else
      parameters.boundary.displacement[0] = {{"lower bottom left", 0},
                                             {"upper top left", 0}};
    CondensedModel model(parameters);
    headline("tied, " + rule + " rule, degree " + std::to_string(degree) +
             (shear ? ", stretched and sheared" : ", stretched"));
    check("converges, all points stick",
          model.solve(1) && model.interface->active_set.count().stick ==
                              model.interface->points().size());

    double relative = 0;
    for (const ContactPoint<2> &point : model.interface->points())
      {
        const auto now =
          model.interface->state(point,
                                 model.solution,
                                 GhostedVector(model.solution.size()));
        relative = std::max({relative, std::abs(now.gap), now.slip.norm()});
      }
    check_small("relative displacement", relative / 0.02, 1e-12);

    const GhostedVector forces = model.elasticity->forces(model.solution, 1);
    const auto          on     = [&](const std::string &name) {
      Tensor<1, 2> sum;
      for (const auto &node : model.surface(name).nodes)
        for (unsigned int i = 0; i < 2; ++i)
          sum[i] += forces[node.dofs[i]];
      return sum;
    };
    const Tensor<1, 2> below = on("lower bottom"), above = on("upper top"),
                       slave = on("upper bottom"), master = on("lower top");
    check_small("reactions", (below + above).norm() / below.norm(), 1e-10);
    check_small("forces between the bodies",
                ((slave + master).norm() + (above + slave).norm()) /
                  below.norm(),
                1e-10);
    if (shear)
      return;

    double       deviation = 0;
    const double stress    = youngs_modulus / (1 - 0.09) * 0.01;
    for (const auto &cell : model.elasticity->stresses(model.solution))
      for (const auto &s : cell)
        deviation = std::max({deviation,
                              std::abs(s[1][1] - stress),
                              std::abs(s[0][0]),
                              std::abs(s[0][1])});
    check_small("uniform stress", deviation / stress, 1e-10);
  }
} // namespace



int main()
{
  for (const std::string rule : {"nodal", "mortar"})
    {
      matrices_and_solvers({rule, 1, "small strain", 0.08});
      matrices_and_solvers({rule, 2, "large displacement", 0.08});
    }
  headline("decisions that change");
  for (const std::string rule : {"nodal", "mortar"})
    for (const unsigned int degree : {1, 2})
      other_decisions({rule, degree, "small strain", 0.08});
  for (const std::string rule : {"nodal", "mortar"})
    for (const unsigned int degree : {1, 2})
      for (const bool shear : {false, true})
        tied(rule, degree, shear);
  return 0;
}
