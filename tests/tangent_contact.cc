/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that the tangent of contact is the derivative of its residual: both
// rules, both degrees, all friction laws, sticking and slipping in both
// directions and open, with finite penetration and slip on turned and curved
// edges; and of points at corners of the master. With moving geometry the
// points are paired anew in every state that the difference quotient visits,
// else never. The same on rigid obstacles.

#include "tests.h"

using namespace Tests;

namespace
{
  struct Law
  {
    std::string name;
    double      tresca, coulomb;
  };



  TwoBodies
  make_model(const unsigned int degree, const std::string &rule, const Law &law)
  {
    // The slave's nodes and Gauss points lie within the edges of the master.
    MeshText mesh;
    mesh.block("lower", 3, 1, rectangle({0, -1}, {3, 0}));
    mesh.block("upper", 2, 1, rectangle({0.4, 0}, {2.2, 1}));
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, degree, "small strain");
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = rule;
    parameters.contact.n_gauss_points       = 2;
    parameters.contact.tresca_limit         = law.tresca;
    parameters.contact.friction_coefficient = law.coulomb;
    return TwoBodies(parameters);
  }



  struct System
  {
    explicit System(const TwoBodies &model)
      : rhs(model.solution.size())
    {
      DynamicSparsityPattern couplings(rhs.size(), rhs.size());
      model.interface.add_couplings(couplings);
      pattern.copy_from(couplings);
      matrix.reinit(pattern);
    }

    void assemble(const ContactInterface<2>  &interface,
                  const GhostedVector        &solution,
                  const GhostedVector        &start,
                  const ContactLinearization &linearization)
    {
      matrix = 0;
      rhs    = 0;
      ContactKernel<2>(interface).assemble(solution,
                                           start,
                                           linearization,
                                           rhs,
                                           &matrix);
    }

    SparsityPattern      pattern;
    SparseMatrix<double> matrix;
    GhostedVector        rhs;
  };



  /// The displacements of both surfaces and the multipliers: all others take
  /// no part.
  std::set<types::global_dof_index> unknowns_of(const TwoBodies &model)
  {
    std::set<types::global_dof_index> unknowns;
    const auto                        add = [&](const Surface<2> &surface) {
      for (const auto &node : surface.nodes)
        unknowns.insert(node.dofs.begin(), node.dofs.end());
    };
    const ContactPair<2> &contact_pair = *model.interface.pairs[0];
    add(contact_pair.slave);
    if (contact_pair.master)
      add(*contact_pair.master);
    for (unsigned int i = model.n_dofs(); i < model.solution.size(); ++i)
      unknowns.insert(i);
    return unknowns;
  }



  /// All turned by a finite angle and all nodes moved a little, the slave moved
  /// against the master by @p gap; the start of the increment elsewhere.
  void randomize(TwoBodies &model, const double gap)
  {
    Random               random;
    const Tensor<2, 2>   R         = rotation(0.6);
    const auto           X         = model.support_points();
    const auto           c         = model.components();
    ContactInterface<2> &interface = model.interface;

    std::set<types::global_dof_index> slave;
    for (const auto &node : interface.pairs[0]->slave.nodes)
      slave.insert(node.dofs.begin(), node.dofs.end());
    for (unsigned int i = 0; i < model.n_dofs(); ++i)
      {
        Point<2> x = X[i];
        if (slave.count(i) > 0)
          x[1] += gap;
        model.solution[i] = (R * x)[c[i]] - X[i][c[i]] + random(-0.03, 0.03);
        model.start[i]    = model.solution[i] + random(-0.1, 0.1);
      }
    for (unsigned int i = model.n_dofs(); i < model.solution.size(); ++i)
      model.solution[i] = random(0.5, 1.5);
    change_points(interface, [&](ContactPoint<2> &point) {
      point.friction_bound = random(0.1, 0.5);
    });
  }



  /// The difference quotients, and whether they are valid.
  struct Result
  {
    double error      = 0; // both relative to the largest entry
    double asymmetry  = 0;
    bool   edges_kept = true;
  };



  Result compare(TwoBodies &model, const ContactLinearization &linearization)
  {
    ContactInterface<2> &interface       = model.interface;
    const bool           moving_geometry = linearization.moving_geometry;
    interface.pair(model.solution, {moving_geometry});

    System here(model), beside(model);
    here.assemble(interface, model.solution, model.start, linearization);

    Result       result;
    double       largest  = 0;
    const double h        = 1e-6;
    const auto   unknowns = unknowns_of(model);
    for (const auto j : unknowns)
      {
        GhostedVector column(model.solution.size());
        for (const int side : {1, -1})
          {
            GhostedVector moved(model.solution);
            moved[j] += side * h;
            if (moving_geometry && interface.pair(moved, {moving_geometry}))
              result.edges_kept = false;
            beside.assemble(interface, moved, model.start, linearization);
            column.add(-side / (2 * h), beside.rhs);
          }
        for (const auto i : unknowns)
          {
            const double k = here.matrix.el(i, j);
            result.error   = std::max(result.error, std::abs(k - column[i]));
            result.asymmetry =
              std::max(result.asymmetry, std::abs(k - here.matrix.el(j, i)));
            largest = std::max(largest, std::abs(k));
          }
      }
    result.error /= largest;
    result.asymmetry /= largest;
    return result;
  }



  /// The tangent with all points that face the master doing the same, whatever
  /// the state says.
  void check_decision(TwoBodies            &model,
                      const std::string    &name,
                      const PointStatus<2> &status)
  {
    change_points(model.interface, [&](ContactPoint<2> &point) {
      point.status = point.facing ? status : PointStatus<2>();
    });

    const bool slips = status.slip_direction != 0;
    bool       kept  = true;
    for (const bool moving_geometry : {false, true})
      for (const bool bounds_follow : {false, true})
        if (slips || !bounds_follow)
          {
            const BoundsWhile<2> bounds(model.interface.bounds, bounds_follow);
            const Result         result = compare(model, {moving_geometry});
            check_small(name + (moving_geometry ? ", moving geometry" : "") +
                          (bounds_follow ? ", moving bound" : ""),
                        result.error,
                        1e-8);
            kept = kept && result.edges_kept;

            // Contact without friction has a potential, but for what is
            // integrated along surfaces that move; sticking has one as long as
            // the pairing stands still.
            const bool is_mortar =
              model.interface.points()[0].change.dofs.size() > 0;
            if ((model.interface.pairs[0]->law.is_frictionless() &&
                 !is_mortar) ||
                (!slips && !moving_geometry))
              check_small(name + ", asymmetry", result.asymmetry, 1e-14);
          }
    if (!kept)
      check(name + ", edges are kept", false);
  }



  void
  check_law(const unsigned int degree, const std::string &rule, const Law &law)
  {
    headline("degree " + std::to_string(degree) + ", " + rule + " rule, " +
             law.name);
    TwoBodies model = make_model(degree, rule, law);
    randomize(model, -0.08);

    model.interface.pair(model.solution);
    bool within = true, curved = false;
    for (const ContactPoint<2> &point : points_of_slave(model.interface))
      {
        within = within && point.facing && std::abs(point.master_xi) < 0.98;
        Tensor<1, 2> kappa;
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int i = 0; i < 2; ++i)
            kappa[i] -=
              point.C2[a] * (point.X(a)[i] + model.solution[point.dofs(a)[i]]);
        curved = curved || std::abs(point.normal * kappa) > 1e-2;
      }
    check("all points face the inside of an edge", within);
    check("edges are curved at degree 2", curved == (degree == 2));

    check_decision(model, "open", {Status::open, 0});
    if (model.interface.pairs[0]->law.is_frictionless())
      check_decision(model, "contact", {Status::slip, 0});
    else
      {
        check_decision(model, "stick", {Status::stick, 0});
        check_decision(model, "slip forward", {Status::slip, 1});
        if (law.coulomb > 0)
          check_decision(model, "slip backward", {Status::slip, -1});
      }
  }



  /// The mortar discretization: edges that face the master as a whole, on both
  /// sides of its nodes, or in part.
  void check_mortar(const unsigned int degree, const Law &law, const bool whole)
  {
    headline("degree " + std::to_string(degree) + ", mortar rule, " + law.name +
             (whole ? "" : ", beyond the end"));
    MeshText mesh;
    mesh.block("lower", 3, 1, rectangle({0, -1}, {whole ? 3. : 1.9, 0}));
    mesh.block("upper", 2, 1, rectangle({0.4, 0}, {2.2, 1}));
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, degree, "small strain");
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = "mortar";
    parameters.contact.tresca_limit         = law.tresca;
    parameters.contact.friction_coefficient = law.coulomb;
    TwoBodies model(parameters);
    randomize(model, -0.08);

    model.interface.pair(model.solution);
    bool facing = true;
    for (const ContactPoint<2> &point : points_of_slave(model.interface))
      facing = facing && point.facing;
    check("all points face the master", facing == whole);

    check_decision(model, "open", {Status::open, 0});
    if (model.interface.pairs[0]->law.is_frictionless())
      check_decision(model, "contact", {Status::slip, 0});
    else
      {
        check_decision(model, "stick", {Status::stick, 0});
        check_decision(model, "slip forward", {Status::slip, 1});
      }
  }



  /// A slave node over a convex vertex of a master that the mesh has drawn as a
  /// polygon: there is no projection of a normal, and the vertex is what it
  /// faces.
  void check_corner(const unsigned int degree)
  {
    headline("degree " + std::to_string(degree) + ", over a corner");
    MeshText mesh;
    mesh.block("lower", 2, 1, [](const double s, const double t) {
      return Point<2>(2 * s - 1, t - 1 - 0.3 * std::abs(2 * s - 1));
    });
    mesh.block("upper", 1, 1, rectangle({-0.04, 0}, {0.06, 1}));
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, degree, "small strain");
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = "nodal";
    parameters.contact.friction_coefficient = 0.4;
    TwoBodies model(parameters);
    randomize(model, 1);

    model.interface.pair(model.solution);
    bool over_corner = true;
    for (const ContactPoint<2> &point : points_of_slave(model.interface))
      over_corner =
        over_corner && point.facing && std::abs(point.master_xi) == 1;
    check("all points face the corner", over_corner);

    check_decision(model, "stick", {Status::stick, 0});
    check_decision(model, "slip forward", {Status::slip, 1});
  }



  /// A corner of the master under the inside of a slave edge.
  void check_master_corner(const unsigned int degree, const std::string &rule)
  {
    headline("degree " + std::to_string(degree) + ", " + rule +
             " rule, a corner of the master");
    MeshText mesh;
    mesh.block("lower", 2, 1, [](const double s, const double t) {
      return Point<2>(2 * s - 1, t - 1 - std::abs(2 * s - 1));
    });
    mesh.block("upper", 1, 1, rectangle({-0.8, 0}, {0.4, 1}));
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, degree, "small strain");
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = rule;
    parameters.contact.friction_coefficient = 0.4;
    TwoBodies model(parameters);
    randomize(model, -0.08);

    model.interface.pair(model.solution);
    // Ends of the master are before and behind it.
    const auto            &points = model.interface.points();
    const ContactPoint<2> &corner = points[points.size() - 2];
    check("the last point but one is at the corner",
          corner.is_master_corner && corner.facing);
    check("and deep inside",
          model.interface.state(corner, model.solution, model.start).gap <
            -0.02);

    check_decision(model, "open", {Status::open, 0});
    check_decision(model, "stick", {Status::stick, 0});
    check_decision(model, "slip forward", {Status::slip, 1});
    check_decision(model, "slip backward", {Status::slip, -1});
  }



  /// On rigid obstacles, which turn the normal of a point as it moves along
  /// them. All is turned by the same angle as in randomize(). Those that move
  /// come from elsewhere.
  void check_obstacle(const unsigned int         degree,
                      const std::string         &rule,
                      const std::string         &shape,
                      const std::vector<double> &numbers,
                      const bool                 moves)
  {
    headline("degree " + std::to_string(degree) + ", " + rule + " rule, " +
             shape + (numbers.back() < 0 ? ", inside" : "") +
             (moves ? ", moving" : ""));
    MeshText mesh;
    mesh.block("upper", 2, 1, rectangle({0.4, 0}, {2.2, 1}));
    Parameters::All parameters =
      make_parameters(mesh, {"upper"}, degree, "small strain");
    parameters.contact.slave    = "upper bottom";
    parameters.contact.obstacle = {
      {Parameters::Choice<Parameters::ObstacleShape>(shape), numbers}};
    parameters.contact.discretization       = rule;
    parameters.contact.n_gauss_points       = 2;
    parameters.contact.friction_coefficient = 0.4;
    if (moves)
      {
        parameters.contact.obstacle_motion = {{"x", "t - 1"},
                                              {"angle", "90*(t - 1)"}};
        parameters.contact.obstacle_centre = {1, -0.5};
      }
    TwoBodies model(parameters);
    check("moves", model.interface.motions.move(0.4, 1) == moves);
    randomize(model, -0.08);

    check_decision(model, "open", {Status::open, 0});
    check_decision(model, "stick", {Status::stick, 0});
    check_decision(model, "slip forward", {Status::slip, 1});
    check_decision(model, "slip backward", {Status::slip, -1});
  }
} // namespace



int main()
{
  const std::vector<Law> laws{{"frictionless", 0, 0},
                              {"Tresca", 0.3, 0},
                              {"Coulomb", 0, 0.4}};
  for (const unsigned int degree : {1, 2})
    for (const std::string rule : {"nodal", "Gauss"})
      for (const Law &law : laws)
        check_law(degree, rule, law);
  for (const unsigned int degree : {1, 2})
    for (const bool whole : {true, false})
      for (const Law &law : {laws[0], laws[2]})
        check_mortar(degree, law, whole);
  check_corner(1);
  for (const unsigned int degree : {1, 2})
    for (const std::string rule : {"nodal", "mortar"})
      check_master_corner(degree, rule);
  const Tensor<2, 2> R      = rotation(0.6);
  const Tensor<1, 2> normal = R * Point<2>(0, 1);
  const Tensor<1, 2> below  = R * Point<2>(1.3, -4);
  const Tensor<1, 2> above  = R * Point<2>(1.3, 4);
  for (const unsigned int degree : {1, 2})
    for (const std::string rule : {"nodal", "Gauss"})
      {
        for (const bool moves : {false, true})
          {
            check_obstacle(degree,
                           rule,
                           "half plane",
                           {0, 0, normal[0], normal[1]},
                           moves);
            check_obstacle(degree,
                           rule,
                           "circle",
                           {below[0], below[1], 4},
                           moves);
            check_obstacle(degree,
                           rule,
                           "circle",
                           {above[0], above[1], -4},
                           moves);
          }
      }
  return 0;
}
