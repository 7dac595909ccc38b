/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that any active points can be eliminated: that Gauss' elimination of
// sparse rows solves them, in time that does not double with each; that a
// master narrower than two edges of its slave, contact pairs with common nodes,
// a slave that is the master of another one, and slave nodes that supports hold
// have the solution of the system with multipliers; that points which say the
// same twice act as one; and that what supports press together is
// refused.

#include <deal.II/lac/full_matrix.h>

#include "condensed_model.h"

using namespace Tests;

namespace
{
  const double youngs_modulus = 1000;

  /// Each row sees all unknowns: the worst that a chain can become.
  void rows()
  {
    headline("rows that see each other");
    const unsigned int n = 60, n_free = 3;
    Random             random;

    std::set<types::global_dof_index> usual;
    for (unsigned int i = 0; i < n; ++i)
      usual.insert(i);
    RowElimination     rows(usual);
    FullMatrix<double> matrix(n, n);
    Vector<double>     rhs(n), x(n + n_free);
    for (unsigned int j = 0; j < n_free; ++j)
      x[n + j] = random(-1, 1);
    for (unsigned int i = 0; i < n; ++i)
      {
        RowElimination::Row row;
        row.constant = rhs[i] = random(-1, 1);
        for (unsigned int j = 0; j < n + n_free; ++j)
          {
            const double c = row.entries[j] = (i == j ? n : random(-1, 1));
            if (j < n)
              matrix(i, j) = c;
            else
              rhs[i] -= c * x[j];
          }
        rows.reduce(row);
        rows.eliminate(i, row);
      }
    matrix.gauss_jordan();
    Vector<double> y(n);
    matrix.vmult(y, rhs);

    double deviation = 0;
    for (const auto &[dof, line] : rows.lines())
      {
        double value = line.constant;
        for (const auto &[other, c] : line.entries)
          value += c * x[other];
        deviation = std::max(deviation, std::abs(value - y[dof]));
      }
    check("all are known", rows.lines().size() == n);
    check_small("by the free ones, deviation", deviation, 1e-13);
  }



  std::string counts(const ContactInterface<2> &interface)
  {
    const StatusCount count = interface.active_set.count();
    return std::to_string(interface.points().size() - count.active) +
           " open, " + std::to_string(count.stick) + " stick, " +
           std::to_string(count.active - count.stick) + " slip";
  }



  /// With multipliers and without, in two increments.
  void compare(const std::string &name, const Parameters::All &parameters)
  {
    TwoBodies      saddle(parameters);
    CondensedModel condensed(parameters);
    bool           converged = true;
    for (const double load_factor : {0.6, 1.})
      {
        converged = converged && saddle.solve(load_factor, false) > 0;
        converged = converged && condensed.solve(load_factor);
      }
    std::cout << "  " << name << ": " << counts(saddle.interface) << std::endl;
    check("both converge to the same decisions",
          converged && saddle.interface.active_set.signature() ==
                         condensed.interface->active_set.signature());
    const auto n = saddle.n_dofs();
    check_small("displacements",
                difference(condensed.solution, saddle.solution, 0, n),
                1e-9);
    check_small("multipliers",
                difference(condensed.solution,
                           saddle.solution,
                           n,
                           saddle.solution.size()),
                1e-9);
  }



  /// A block on another one that is narrower than two of its edges: their nodes
  /// are coupled from end to end.
  void narrow_master(const unsigned int degree, const double coulomb)
  {
    MeshText mesh;
    mesh.block("lower", 6, 2, rectangle({0.3, -1}, {1.7, 0}));
    mesh.block("upper", 2, 2, rectangle({0, 0}, {2, 1}));
    Parameters::All parameters              = make_parameters(mesh,
                                                 {"lower", "upper"},
                                                 degree,
                                                 "small strain",
                                                 youngs_modulus);
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = "mortar";
    parameters.contact.friction_coefficient = coulomb;
    parameters.boundary.displacement[0]     = {{"lower bottom", 0},
                                               {"upper top", 0.004}};
    parameters.boundary.displacement[1]     = {{"lower bottom", 0},
                                               {"upper top", -0.03}};
    compare("degree " + std::to_string(degree) +
              (coulomb > 0 ? ", Coulomb" : ", no friction"),
            parameters);
  }



  /// A block in a corner: one slave node has the normals of two contact pairs.
  Parameters::All corner(const std::string &rule, const double coulomb)
  {
    MeshText mesh;
    mesh.block("block", 4, 4, rectangle({0, 0}, {1, 1}));
    mesh.block("floor", 5, 2, rectangle({-0.1, -0.5}, {1.5, 0}));
    mesh.block("wall", 2, 5, rectangle({-0.5, -0.1}, {0, 1.5}));
    Parameters::All     parameters = make_parameters(mesh,
                                                 {"block", "floor", "wall"},
                                                 1,
                                                 "small strain",
                                                 youngs_modulus);
    Parameters::Contact wall;
    wall.name                         = "wall";
    parameters.contact.slave          = "block bottom";
    parameters.contact.master         = "floor top";
    wall.slave                        = "block left";
    wall.master                       = "wall right";
    parameters.contact.discretization = wall.discretization = rule;
    parameters.contact.friction_coefficient                 = coulomb;
    wall.friction_coefficient                               = coulomb;
    parameters.further_contacts["wall"]                     = wall;
    parameters.boundary.displacement[0] = {{"floor bottom", 0},
                                           {"wall left", 0},
                                           {"block right", -0.02}};
    parameters.boundary.displacement[1] = {{"floor bottom", 0},
                                           {"wall left", 0},
                                           {"block top", -0.03}};
    return parameters;
  }



  /// A block between two others: its bottom is slave on the left, master on the
  /// right, and of a common node.
  Parameters::All chain(const std::string &rule)
  {
    MeshText mesh;
    mesh.block("upper", 5, 3, rectangle({0, 0}, {2, 1}));
    mesh.block("left", 3, 2, rectangle({-0.1, -1}, {0.9, 0}));
    mesh.block("right", 4, 2, rectangle({1.1, -1}, {2.1, 0}));
    Parameters::All     parameters = make_parameters(mesh,
                                                 {"upper", "left", "right"},
                                                 1,
                                                 "small strain",
                                                 youngs_modulus);
    Parameters::Contact other;
    other.name                        = "other";
    parameters.contact.slave          = "upper bottom";
    parameters.contact.master         = "left top";
    other.slave                       = "right top";
    other.master                      = "upper bottom";
    parameters.contact.discretization = other.discretization = rule;
    parameters.further_contacts["other"]                     = other;
    parameters.boundary.displacement[0] = {{"left bottom", 0},
                                           {"right bottom", 0},
                                           {"upper top", 0}};
    parameters.boundary.displacement[1] = {{"left bottom", 0},
                                           {"right bottom", 0},
                                           {"upper top", -0.03}};
    return parameters;
  }



  /// A slave whose nodes are all held in both directions: the multipliers come
  /// from the forces on the master.
  Parameters::All held(const bool in_x_only, const double coulomb)
  {
    MeshText mesh;
    mesh.block("lower", 9, 4, rectangle({-0.2, -1}, {2.2, 0}));
    mesh.block("upper", 4, 1, rectangle({0, 0}, {2, 1}));
    Parameters::All parameters              = make_parameters(mesh,
                                                 {"lower", "upper"},
                                                 1,
                                                 "small strain",
                                                 youngs_modulus);
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = "nodal";
    parameters.contact.friction_coefficient = coulomb;
    parameters.boundary.displacement[0]     = {{"lower bottom", 0},
                                               {"upper bottom", 0.004}};
    parameters.boundary.displacement[1]     = {{"lower bottom", 0},
                                               {"upper top", -0.03}};
    if (!in_x_only)
      parameters.boundary.displacement[1]["upper bottom"] = -0.03;
    return parameters;
  }



  /// The same contact pair twice: everything is said twice.
  void twice()
  {
    headline("the same zone twice");
    MeshText mesh;
    mesh.block("lower", 7, 2, rectangle({-0.2, -1}, {2.3, 0}));
    mesh.block("upper", 5, 2, rectangle({0, 0}, {2, 1}));
    Parameters::All parameters          = make_parameters(mesh,
                                                 {"lower", "upper"},
                                                 1,
                                                 "small strain",
                                                 youngs_modulus);
    parameters.contact.slave            = "upper bottom";
    parameters.contact.master           = "lower top";
    parameters.contact.discretization   = "nodal";
    parameters.boundary.displacement[0] = {{"lower bottom", 0},
                                           {"upper top", 0}};
    parameters.boundary.displacement[1] = {{"lower bottom", 0},
                                           {"upper top", -0.03}};
    CondensedModel once(parameters);
    parameters.further_contacts["again"]      = parameters.contact;
    parameters.further_contacts["again"].name = "again";
    CondensedModel twice(parameters);
    check("both converge", once.solve(1) && twice.solve(1));
    const auto n = once.n_dofs();
    check_small("displacements",
                difference(twice.solution, once.solution, 0, n),
                1e-9);
    double     deviation = 0, largest = 0;
    const auto n_k = once.interface->n_multipliers();
    for (unsigned int k = 0; k < n_k; ++k)
      {
        const double p = once.solution[n + k];
        largest        = std::max(largest, p);
        for (const unsigned int l : {k, k + n_k})
          {
            const auto acting = twice.interface->acting_multiplier(l);
            deviation =
              std::max(deviation, std::abs(twice.solution[n + acting] - p));
          }
      }
    check_small("the pressure of one zone in both", deviation / largest, 1e-5);
    double weights = 0;
    for (const auto &pair : twice.interface->pairs)
      for (const ContactPoint<2> &point : twice.interface->acting_points(*pair))
        weights += point.weight;
    for (const ContactPoint<2> &point : once.interface->points())
      if (!point.is_master_corner)
        weights -= point.weight;
    check_small("and its weights shared", std::abs(weights), 1e-12);
  }



  /// Two blocks that supports press together, face by face.
  void over_constrained()
  {
    MeshText mesh;
    mesh.block("lower", 2, 2, rectangle({0, -1}, {2, 0}));
    mesh.block("upper", 2, 2, rectangle({0, -0.03}, {2, 1}));
    Parameters::All parameters          = make_parameters(mesh,
                                                 {"lower", "upper"},
                                                 1,
                                                 "small strain",
                                                 youngs_modulus);
    parameters.contact.slave            = "upper bottom";
    parameters.contact.master           = "lower top";
    parameters.contact.discretization   = "nodal";
    parameters.boundary.displacement[0] = {{"lower top", 0},
                                           {"upper bottom", 0}};
    parameters.boundary.displacement[1] = {{"lower top", 0},
                                           {"upper bottom", 0}};
    headline("supports that press the surfaces together");
    try
      {
        CondensedModel(parameters).solve(1);
      }
    catch (const NotConverged &failure)
      {
        std::cout << "  refused: " << failure.what() << std::endl;
      }
  }
} // namespace



int main()
{
  rows();
  headline("a master narrower than two edges");
  for (const unsigned int degree : {1, 2})
    for (const double coulomb : {0., 0.1})
      narrow_master(degree, coulomb);
  headline("a block in a corner");
  for (const std::string rule : {"nodal", "mortar"})
    for (const double coulomb : {0., 0.1})
      compare(rule + (coulomb > 0 ? ", Coulomb" : ", no friction"),
              corner(rule, coulomb));
  headline("slave here, master there");
  for (const std::string rule : {"nodal", "mortar"})
    compare(rule, chain(rule));
  headline("a slave that supports hold");
  for (const double coulomb : {0., 0.1})
    {
      const std::string law = coulomb > 0 ? ", Coulomb" : ", no friction";
      compare("in x" + law, held(true, coulomb));
      compare("in x and y" + law, held(false, coulomb));
    }
  twice();
  over_constrained();
  return 0;
}
