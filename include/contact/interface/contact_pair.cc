/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/interface/contact_pair.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <boost/serialization/set.hpp>
#include <limits>

#include "base/errors.h"
#include "contact/mortar/face_mortar.h"
#include "contact/mortar/mortar.h"
#include "contact/obstacles/moving_obstacle.h"
#include "contact/points/corner_points.h"
#include "contact/surfaces/surface_checks.h"
#include "parameters/formula.h"

namespace Contact
{
  namespace
  {
    template<int dim>
    Surface<dim> make_surface(const DiscretizedBodies<dim> &discretization,
                              const std::string            &name,
                              const std::string            &entry,
                              const SurfaceCut              cut)
    {
      return {discretization,
              discretization.boundary_ids(name, entry),
              name,
              cut};
    }



    template<int dim>
    std::optional<Surface<dim>>
    make_master(const DiscretizedBodies<dim> &discretization,
                const Parameters::Contact    &parameters)
    {
      if (parameters.master.empty())
        return {};
      return make_surface(discretization,
                          parameters.master,
                          parameters.section() + "/Master",
                          SurfaceCut::none);
    }



    template<int dim>
    std::unique_ptr<Obstacle<dim>>
    make_obstacle(const Parameters::Contact &parameters)
    {
      if (parameters.obstacle.empty())
        return nullptr;
      auto shape = Obstacle<dim>::create(parameters.obstacle.begin()->first,
                                         parameters.obstacle.begin()->second);
      if (parameters.obstacle_motion.empty() &&
          parameters.obstacle_centre.empty() && !parameters.has_free_motion())
        return shape;
      return std::make_unique<MovingObstacle<dim>>(std::move(shape),
                                                   parameters);
    }



    template<int dim>
    std::unique_ptr<typename ContactPair<dim>::Interference>
    make_interference(const Parameters::Contact &parameters)
    {
      auto interference =
        std::make_unique<typename ContactPair<dim>::Interference>();
      if (!parameters.interference.empty())
        interference->at =
          parse_history(parameters.interference,
                        parameters.section() + "/Interference");
      return interference;
    }



    // The slave nodes that supports hold along the normal, and alike the node
    // of the master opposite, in the wall that both bodies are clamped in.
    // There the surfaces keep their distance. The weighted gap has the nodes
    // around as well, which would have to bend for the polygons to agree: a
    // pressure without bound as the edges get shorter.
    template<int dim>
    std::set<unsigned int>
    nodes_held_with_master(const Surface<dim>           &slave,
                           const Surface<dim>           &master,
                           const DiscretizedBodies<dim> &discretization)
    {
      std::set<unsigned int>     held;
      const DeformedSurface<dim> drawn(slave, {});
      for (unsigned int e = 0; e < slave.facets.size(); ++e)
        for (unsigned int a = 0; a < slave.facets[e].n_nodes(); ++a)
          {
            const unsigned int      i      = slave.facets[e].nodes[a];
            const SurfaceNode<dim> &node   = slave.nodes[i];
            const Tensor<1, dim>   &normal = drawn.facet_normals()[e][a];
            const double            h      = slave.reference_length(e);
            const auto keeps_distance = [&](const SurfaceNode<dim> &other) {
              if (!discretization.are_held_alike(node.dofs, other.dofs, normal))
                return false;
              const Tensor<1, dim> r = other.X - node.X;
              return r.norm() < h && r * normal > -1e-8 * h &&
                     (r - (r * normal) * normal).norm() < 1e-3 * h;
            };
            if ((!discretization.held_normals(node.dofs).empty() ||
                 std::any_of(node.dofs.begin(),
                             node.dofs.end(),
                             [&](const auto dof) {
                               return discretization.is_fixed(dof);
                             })) &&
                std::any_of(master.nodes.begin(),
                            master.nodes.end(),
                            keeps_distance))
              held.insert(i);
          }
      return held;
    }



    // Slave nodes that are tied, or on a rigid boundary.
    template<int dim>
    std::set<unsigned int>
    nodes_held_otherwise(const Surface<dim>           &slave,
                         const DiscretizedBodies<dim> &discretization)
    {
      std::set<types::global_dof_index> tied;
      std::set<unsigned int>            held;
      for (const auto &dofs : discretization.tied())
        tied.insert({dofs.first, dofs.second});
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        for (const auto dof : slave.nodes[i].dofs)
          if (tied.count(dof) > 0 || discretization.is_rigid(dof))
            held.insert(i);
      return held;
    }



    std::vector<ContactPoint<2>>
    make_points_of_gauss(const Surface<2>  &slave,
                         const unsigned int n,
                         MultiplierSpace   &multipliers)
    {
      return make_gauss_points(slave, n, multipliers);
    }

    std::vector<ContactPoint<3>> make_points_of_gauss(const Surface<3> &,
                                                      const unsigned int,
                                                      MultiplierSpace &)
    {
      throw InputError("the Gauss-point discretization is one for the plane",
                       "Contact/Discretization",
                       "take the mortar or the nodal discretization");
    }
  } // namespace



  template<int dim>
  ContactPair<dim>::ContactPair(const DiscretizedBodies<dim> &discretization,
                                const BodyStiffness          &elasticity,
                                const Parameters::Contact    &parameters)
    : discretization(discretization)
    , name(parameters.name)
    , tied(parameters.tied)
    , law{tied ? std::numeric_limits<double>::max() : parameters.tresca_limit,
          parameters.friction_coefficient}
    , slave(make_surface(discretization,
                         parameters.slave,
                         parameters.section() + "/Slave",
                         tied ? SurfaceCut::none : SurfaceCut::into_sides))
    , master(make_master(discretization, parameters))
    , obstacle(make_obstacle<dim>(parameters))
    , interference(make_interference<dim>(parameters))
    , augmentation_parameter(parameters.augmentation_parameter)
    , elasticity(elasticity)
    , parameters(parameters)
  {
    if (parameters.is_with_itself())
      itself.emplace(slave, *master, dim == 3 && is_mortar() ? 2 : 1);
    else if (master)
      {
        check_surfaces(slave, *master, discretization, parameters);
        surfaces_of_bodies = {{{&slave}, {&*master}}};
      }

    for (const std::string &group : parameters.excluded_points)
      exclude(group, section() + "/Excluded points");
    if (parameters.is_made)
      excluded.merge(nodes_held_otherwise(slave, discretization));
    check_ties(slave,
               master ? &*master : nullptr,
               excluded,
               discretization,
               parameters);
    const bool has_mortars = master && is_mortar();
    if (has_mortars && !tied && !itself)
      excluded.merge(nodes_held_with_master(slave, *master, discretization));
    // Over a ring, the shape function of degree 2 of a node on the axis has the
    // integral zero: it has no dual function.
    if (slave.degree == 2 && has_mortars)
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        if (discretization.is_on_axis(slave.nodes[i].X) &&
            excluded.count(i) == 0)
          on_axis.insert(i);
  }



  // A process has cells at some of the nodes.
  template<int dim>
  void ContactPair<dim>::exclude(const std::string &group,
                                 const std::string &entry)
  {
    const auto                    nodes = discretization.nodes_of(group, entry);
    const std::set<NodeDoFs<dim>> of_group(nodes.begin(), nodes.end());
    std::set<unsigned int>        here;
    for (unsigned int i = 0; i < slave.nodes.size(); ++i)
      if (of_group.count(slave.nodes[i].dofs) > 0)
        here.insert(i);
    std::set<unsigned int> of_all_ranks;
    for (auto &of_rank :
         Utilities::MPI::all_gather(discretization.communicator, here))
      of_all_ranks.merge(of_rank);
    if (of_all_ranks.empty())
      throw InputError("no node of '" + group + "' is on the slave '" +
                         parameters.slave + "'",
                       "entry '" + entry + "'",
                       "name a group of its nodes, or leave it out");
    excluded.merge(of_all_ranks);
  }



  template<int dim>
  ContactPair<dim>::~ContactPair() = default;



  // In 3-D a vertex within a facet is held by all nodes of that, also by
  // those where no master is: mortars, which see it in the mean, have none.
  template<int dim>
  bool ContactPair<dim>::can_have_corner_points() const
  {
    const bool sees_vertices = dim == 3 && is_mortar();
    return master && !tied && !itself && has_point_per_multiplier() &&
           !sees_vertices;
  }



  // Not with glue, which the nodes of the discretization hold.
  template<int dim>
  void
  ContactPair<dim>::make_axis_points(std::vector<ContactPoint<dim>> &points)
  {
    if (on_axis.empty() || tied)
      return;
    MultiplierSpace numbering;
    auto            all = make_nodal_points(slave, {}, numbering);
    for (const unsigned int node : on_axis)
      {
        multipliers.of_node[node] = multipliers.n_multipliers++;
        ContactPoint<dim> &point  = all[numbering.of_node[node]];
        point.multipliers[0]      = multipliers.of_node[node];
        points.push_back(point);
      }
  }



  // An obstacle has no edges to cut those of the slave by.
  template<int dim>
  std::vector<ContactPoint<dim>> ContactPair<dim>::make_discretization_points()
  {
    switch (parameters.discretization)
      {
        case Parameters::ContactDiscretization::nodal:
          return make_nodal_points(slave, excluded, multipliers);
        case Parameters::ContactDiscretization::gauss:
          return make_points_of_gauss(slave,
                                      parameters.n_gauss_points,
                                      multipliers);
        case Parameters::ContactDiscretization::mortar:
          if (!master)
            return make_nodal_points(slave, excluded, multipliers);
          auto without_dual_function = excluded;
          without_dual_function.insert(on_axis.begin(), on_axis.end());
          mortar =
            std::make_unique<MortarDiscretization<dim>>(slave,
                                                        *master,
                                                        discretization,
                                                        without_dual_function);
          return mortar->make_points(multipliers);
      }
    AssertThrow(false, ExcInternalError());
    return {};
  }



  template<int dim>
  std::vector<ContactPoint<dim>>
  ContactPair<dim>::make_points(const unsigned int first_multiplier,
                                const unsigned int first_point)
  {
    std::vector<ContactPoint<dim>> points = make_discretization_points();
    n_of_discretization                   = points.size();
    make_axis_points(points);
    n_of_slave = points.size();
    if (!tied && !law.is_frictionless())
      mark_dirichlet_edges(slave, multipliers, discretization, points);
    if (can_have_corner_points())
      for (ContactPoint<dim> &corner : make_corner_points(*master))
        {
          corner.multipliers[0] = multipliers.n_multipliers++;
          points.push_back(std::move(corner));
        }

    this->first_point      = first_point;
    this->first_multiplier = first_multiplier;
    n_points               = points.size();
    for (unsigned int &k : multipliers.of_node)
      if (k != numbers::invalid_unsigned_int)
        k += first_multiplier;
    for (ContactPoint<dim> &point : points)
      {
        for (unsigned int k = 0; k < point.n_multipliers; ++k)
          point.multipliers[k] += first_multiplier;
        point.augmentation_parameter =
          augmentation_parameter * stiffness(point);
        point.elastic_slip =
          parse_length(parameters.elastic_slip, edge_length(point));
        point.friction_bound = law.bound(0);
      }
    return points;
  }



  template<int dim>
  double ContactPair<dim>::stiffness(const ContactPoint<dim> &point) const
  {
    const Surface<dim> &own = surface_of(point);
    const double        of_own =
      elasticity.youngs_modulus(own.facets[point.slave_facet].body);
    const Surface<dim> *const other = surface_opposite(point);
    return (other ? std::min(of_own,
                             elasticity.youngs_modulus(other->facets[0].body))
                  : of_own) /
           edge_length(point);
  }



  template<int dim>
  const Surface<dim> &
  ContactPair<dim>::surface_of(const ContactPoint<dim> &point) const
  {
    return point.is_master_corner ? *master : slave;
  }



  template<int dim>
  const Surface<dim> *
  ContactPair<dim>::surface_opposite(const ContactPoint<dim> &point) const
  {
    return point.is_master_corner ? &slave : master ? &*master : nullptr;
  }



  template<int dim>
  double ContactPair<dim>::edge_length(const ContactPoint<dim> &point) const
  {
    return surface_of(point).reference_length(point.slave_facet);
  }



  // A parabola over the radius whose slope vanishes on the axis.
  template<int dim>
  std::vector<std::pair<unsigned int, double>>
  ContactPair<dim>::pressure_at(const unsigned int node) const
  {
    const auto multiplier = [&](const unsigned int i) {
      return multipliers.of_node[i];
    };
    const bool on_axis =
      slave.degree == 2 &&
      parameters.discretization != Parameters::ContactDiscretization::gauss &&
      discretization.is_on_axis(slave.nodes[node].X);
    if (on_axis)
      for (const SurfaceFacet<dim> &edge : slave.facets)
        for (unsigned int a = 0; a < 2; ++a)
          if (edge.nodes[a] == node)
            {
              const unsigned int middle = multiplier(edge.nodes[2]);
              const unsigned int end    = multiplier(edge.nodes[1 - a]);
              if (middle != numbers::invalid_unsigned_int &&
                  end != numbers::invalid_unsigned_int)
                return {{middle, 4. / 3}, {end, -1. / 3}};
            }
    std::vector<std::pair<unsigned int, double>> parts;
    for (const auto &[receiver, part] : slave.receivers(node))
      if (multiplier(receiver) != numbers::invalid_unsigned_int)
        parts.emplace_back(multiplier(receiver), part);
    return parts;
  }



  template<int dim>
  bool ContactPair<dim>::has_point_per_multiplier() const
  {
    return parameters.has_point_per_multiplier();
  }



  template<int dim>
  Point<dim>
  ContactPair<dim>::place_of_facets(const ContactPoint<dim> &point) const
  {
    const Surface<dim>       &own   = surface_of(point);
    const SurfaceFacet<dim>  &facet = own.facets[point.slave_facet];
    std::vector<unsigned int> around{point.slave_facet};
    for (unsigned int a = 0; a < facet.n_nodes(); ++a)
      if (facet.kind->places[a] == point.slave_xi)
        around = own.facets_of_node[facet.nodes[a]];
    Point<dim> sum;
    for (const unsigned int e : around)
      sum += own.facets[e].middle / (1. * around.size());
    return sum;
  }

  template class ContactPair<2>;
  template class ContactPair<3>;
} // namespace Contact
