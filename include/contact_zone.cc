/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact_zone.h"

#include <algorithm>
#include <limits>

#include "counters.h"
#include "errors.h"

namespace Contact
{
  namespace
  {
    Surface make_surface(const Discretization &discretization,
                         const std::string    &name,
                         const std::string    &entry)
    {
      return {discretization, discretization.mesh.boundary(name, entry), name};
    }



    std::optional<Surface> make_master(const Discretization &discretization,
                                       const Parameters::Contact &parameters)
    {
      if (parameters.master.empty())
        return {};
      return make_surface(discretization,
                          parameters.master,
                          parameters.section() + "/Master");
    }
  } // namespace



  ContactZone::ContactZone(const Discretization      &discretization,
                           const Elasticity          &elasticity,
                           const Parameters::Contact &parameters)
    : name(parameters.name)
    , tied(parameters.tied)
    , law{tied ? std::numeric_limits<double>::max() : parameters.tresca_limit,
          parameters.friction_coefficient}
    , slave(make_surface(discretization,
                         parameters.slave,
                         parameters.section() + "/Slave"))
    , master(make_master(discretization, parameters))
    , complementarity(parameters.complementarity)
    , discretization(discretization)
    , elasticity(elasticity)
    , parameters(parameters)
  {
    const std::string section = parameters.section();
    if (!master)
      obstacle = Obstacle::create(parameters.obstacle, section + "/Obstacle");
    else
      for (const Surface::Node &a : slave.nodes)
        for (const Surface::Node &b : master->nodes)
          if (a.dofs == b.dofs)
            throw InputError("slave '" + parameters.slave + "' and master '" +
                               parameters.master +
                               "' overlap: both have the "
                               "node at (" +
                               std::to_string(a.X[0]) + ", " +
                               std::to_string(a.X[1]) + ")",
                             section + "/Slave, " + section + "/Master",
                             "name two surfaces without a common node");

    for (const std::string &point : parameters.excluded_points)
      {
        const auto &dofs =
          discretization.vertex_dofs
            [discretization.mesh.point(point, section + "/Excluded points")];
        for (unsigned int i = 0; i < slave.nodes.size(); ++i)
          if (slave.nodes[i].dofs == dofs)
            excluded.insert(i);
      }
    // Over a ring, the shape function of degree 2 of a node on the axis has the
    // integral zero: no pressure there has a weight.
    if (slave.degree == 2)
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        if (discretization.is_on_axis(slave.nodes[i].X))
          excluded.insert(i);
  }



  std::vector<ContactPoint>
  ContactZone::make_points(const unsigned int first_multiplier,
                           const unsigned int first_point)
  {
    std::vector<ContactPoint> points;
    if (parameters.rule == "mortar" && master)
      {
        mortar = std::make_unique<MortarRule>(slave,
                                              *master,
                                              discretization,
                                              excluded);
        points = mortar->make_points(multipliers);
      }
    else if (parameters.rule == "Gauss")
      points = make_gauss_points(slave, parameters.n_gauss_points, multipliers);
    else
      points = make_nodal_points(slave, excluded, multipliers);

    this->first_point = first_point;
    n_points          = points.size();
    for (unsigned int &k : multipliers.of_node)
      if (k != numbers::invalid_unsigned_int)
        k += first_multiplier;
    for (ContactPoint &point : points)
      {
        for (unsigned int k = 0; k < point.n_multipliers; ++k)
          point.multipliers[k] += first_multiplier;
        point.complementarity = complementarity * stiffness(point);
        point.tresca_bound    = law.bound(0);
      }
    return points;
  }



  // What is glued is glued where it faces each other undeformed.
  bool ContactZone::pair(const ArrayView<ContactPoint> &points,
                         const Vector<double>          &u) const
  {
    if (tied)
      {
        const Vector<double> undeformed(u.size());
        return mortar ? mortar->pair(points, undeformed)
                      : project(points, undeformed);
      }
    return mortar ? mortar->pair(points, u) : project(points, u);
  }



  bool ContactZone::project(const ArrayView<ContactPoint> &points,
                            const Vector<double>          &u) const
  {
    bool changed = false;
    if (obstacle)
      {
        for (ContactPoint &point : points)
          pair_with_obstacle(point, *obstacle, discretization, u);
        counters().projections += points.size();
        return changed;
      }

    const SurfaceSearch search(*master, u);
    for (ContactPoint &point : points)
      {
        const bool         was_paired = point.n_nodes > point.n_slave_nodes;
        const unsigned int last_edge  = point.master_edge;
        pair_with_master(point, *master, search, discretization, u);
        changed = changed || !was_paired || point.master_edge != last_edge;
      }
    return changed;
  }



  double ContactZone::stiffness(const ContactPoint &point) const
  {
    const double of_slave =
      elasticity.young(slave.edges[point.slave_edge].body);
    return (master ? std::min(of_slave, elasticity.young(master->edges[0].body))
                   : of_slave) /
           slave.reference_length(point.slave_edge);
  }



  bool ContactZone::has_point_per_multiplier() const
  {
    return parameters.has_point_per_multiplier();
  }



  Point<2> ContactZone::place(const ContactPoint &point) const
  {
    const EdgeShape shape(slave.degree, point.slave_xi);
    Point<2>        X;
    for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
      X +=
        shape.value[a] * slave.nodes[slave.edges[point.slave_edge].nodes[a]].X;
    return X;
  }
} // namespace Contact
