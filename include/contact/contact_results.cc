/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/contact_results.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Contact
{
  namespace
  {
    /// A contact point as its contact pair looks from the side.
    struct Sample
    {
      double s; // arc length [mm]
      bool   touches, sticks;
      bool   is_held; // by a support: it can not slip
      double p;       // [MPa]
      double slip;    // magnitude [mm]
    };

    using Samples = std::vector<Sample>;
    using Inside  = bool Sample::*;



    /// The zero of a function that is linear in s and has the values f1 and f2
    /// at s1 and s2, but not outside of the two bounds.
    double root(const double s1,
                const double f1,
                const double s2,
                const double f2,
                const double bound_1,
                const double bound_2)
    {
      const double zero = f1 == f2 ? s1 : s1 - f1 * (s2 - s1) / (f2 - f1);
      return std::clamp(zero,
                        std::min(bound_1, bound_2),
                        std::max(bound_1, bound_2));
    }



    /// p^2 falls to zero linearly.
    double
    end_of_contact(const Sample *before, const Sample &last, const Sample &next)
    {
      if (before == nullptr || !before->touches || before->p <= last.p)
        return (last.s + next.s) / 2;
      return root(last.s,
                  last.p * last.p,
                  before->s,
                  before->p * before->p,
                  last.s,
                  next.s);
    }



    /// |slip|^(2/3) grows from zero linearly.
    double
    end_of_stick(const Sample &last, const Sample &next, const Sample *beyond)
    {
      if (next.is_held)
        return next.s;
      if (beyond == nullptr || !beyond->touches || beyond->slip <= next.slip)
        return (last.s + next.s) / 2;
      return root(next.s,
                  std::pow(next.slip, 2. / 3),
                  beyond->s,
                  std::pow(beyond->slip, 2. / 3),
                  last.s,
                  next.s);
    }



    /// The edges of a surface that hang together: the arc length goes on from
    /// one such chain to the next, over what is no surface.
    struct Chain
    {
      Samples samples;
      double  begin = 0, end = 0; // [mm]
      bool    is_closed = false;  // the end is the beginning
    };



    /// The sum over all patches, each from its first to its last end.
    double patch_lengths(const Chain &chain, const Inside inside)
    {
      // Of a loop four turns, so that each sample of the two in the middle has
      // neighbors.
      Samples   samples;
      const int n       = chain.samples.size();
      const int n_turns = chain.is_closed ? 4 : 1;
      for (int turn = 0; turn < n_turns; ++turn)
        for (Sample sample : chain.samples)
          {
            sample.s += turn * (chain.end - chain.begin);
            samples.push_back(sample);
          }
      const auto at = [&](const int i) {
        return 0 <= i && i < n_turns * n ? &samples[i] : nullptr;
      };
      const auto end_at = [&](const int i, const int outwards) {
        const Sample *next = at(i + outwards);
        if (next == nullptr)
          return outwards > 0 ? chain.end : chain.begin;
        return inside == &Sample::touches || !next->touches
                 ? end_of_contact(at(i - outwards), samples[i], *next)
                 : end_of_stick(samples[i], *next, at(i + 2 * outwards));
      };

      // A turn begins where a patch does not go on.
      int begin = 0;
      if (chain.is_closed && n > 0)
        {
          begin = n;
          while (begin < 2 * n && samples[begin].*inside)
            ++begin;
          if (begin == 2 * n)
            return chain.end - chain.begin;
        }
      double sum = 0;
      for (int i = begin; i < begin + n; ++i)
        {
          if (!(samples[i].*inside))
            continue;
          const int first = i;
          while (i + 1 < begin + n && samples[i + 1].*inside)
            ++i;
          sum += end_at(i, +1) - end_at(first, -1);
        }
      return sum;
    }



    /// The arc lengths of the nodes of an edge. That which closes a loop ends
    /// behind all others, not where the loop begins.
    std::vector<double> s_of_edge(const Surface<2>          &slave,
                                  const SurfaceFacet<2>     &edge,
                                  const std::vector<double> &s_of_node)
    {
      std::vector<double> s;
      for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
        s.push_back(s_of_node[edge.nodes[a]]);
      if (s[1] < s[0])
        {
          const unsigned int last = slave.degree == 2 ? 2 : 0;
          s[1] = s[last] + slave.nodes[edge.nodes[last]].X.distance(
                             slave.nodes[edge.nodes[1]].X);
        }
      return s;
    }



    /// The number of the chain of each edge.
    std::vector<unsigned int> chain_of_edges(const Surface<2> &surface)
    {
      std::vector<unsigned int> chains;
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        chains.push_back(
          e == 0 ? 0 : chains.back() + (surface.facets[e].previous != e - 1));
      return chains;
    }



    /// All of them, still without samples.
    std::vector<Chain> make_chains(const Surface<2>                &slave,
                                   const std::vector<unsigned int> &chain_of,
                                   const std::vector<double>       &s_of_node)
    {
      std::vector<Chain> chains;
      for (unsigned int e = 0; e < chain_of.size(); ++e)
        {
          const auto s = s_of_edge(slave, slave.facets[e], s_of_node);
          if (chain_of[e] == chains.size())
            {
              chains.emplace_back();
              chains.back().begin = s[0];
            }
          chains.back().end       = s[1];
          chains.back().is_closed = !slave.facets[e].ends_surface;
        }
      return chains;
    }



    /// Add the force of a point. Returns its traction, which at a corner of the
    /// master depends on the mesh size.
    template<int dim>
    Traction<dim> add_force(const ContactInterface<dim> &interface,
                            const ContactPoint<dim>     &point,
                            const ContactState<dim>     &now,
                            const bool                   moving_bound,
                            ContactResults              &results)
    {
      const Traction<dim> traction = interface.traction(point,
                                                        point.status,
                                                        now.p_trial,
                                                        now.q_trial,
                                                        moving_bound);
      results.normal_force += point.weight * traction.p;
      results.tangential_force += point.weight * traction.q[0];
      return traction;
    }



    std::string name_of_slip(const PointStatus<2> &status)
    {
      return status.slip_direction > 0 ? "slips along -t" : "slips along +t";
    }

    std::string name_of_slip(const PointStatus<3> &)
    {
      return "slips";
    }



    /// A status in a message; a point that slips does so against its shear.
    template<int dim>
    std::string describe(const PointStatus<dim> &status)
    {
      if (status.kind == Status::open)
        return "open";
      if (status.kind == Status::stick)
        return "sticks";
      return status.has_direction() ? name_of_slip(status) : "slips";
    }
  } // namespace



  std::map<std::string, double> ContactResults::by_name(const int dim) const
  {
    return {{"normal_force", normal_force},
            {"tangential_force", tangential_force},
            {"max_pressure", max_pressure},
            {"max_shear", max_shear},
            {dim == 2 ? "width" : "area", dim == 2 ? width : area},
            {dim == 2 ? "stick_width" : "stick_area",
             dim == 2 ? stick_width : stick_area}};
  }



  template<>
  ContactResults contact_results(const ContactInterface<2> &interface,
                                 const ContactPair<2>      &contact_pair,
                                 const GhostedVector       &solution,
                                 const GhostedVector       &u_start,
                                 const bool                 moving_bound)
  {
    const Surface<2>     &slave = contact_pair.slave;
    std::vector<Point<2>> X;
    for (const SurfaceNode<2> &node : slave.nodes)
      X.push_back(node.X);
    const auto s_of_node = slave.arc_length(X);

    const auto     chain_of = chain_of_edges(slave);
    auto           chains   = make_chains(slave, chain_of, s_of_node);
    ContactResults results;
    for (const ContactPoint<2> &point : interface.points_of(contact_pair))
      {
        const ContactState<2> now = interface.state(point, solution, u_start);
        if (point.is_master_corner || point.side > 0)
          {
            add_force(interface, point, now, moving_bound, results);
            continue;
          }
        Samples        &samples = chains[chain_of[point.slave_facet]].samples;
        const EdgeShape shape(slave.degree, point.slave_xi);
        const auto      s_of_nodes =
          s_of_edge(slave, slave.facets[point.slave_facet], s_of_node);
        double s = 0;
        for (unsigned int a = 0; a < s_of_nodes.size(); ++a)
          s += shape.value[a] * s_of_nodes[a];
        if (!point.facing || point.status.kind == Status::open)
          {
            samples.push_back({s, false, false, false, 0, 0});
            continue;
          }

        const Traction<2> traction =
          add_force(interface, point, now, moving_bound, results);
        results.max_pressure = std::max(results.max_pressure, traction.p);
        results.max_shear =
          std::max(results.max_shear, std::abs(traction.q[0]));
        samples.push_back(
          {s,
           true,
           point.status.kind == Status::stick,
           point.tangential_row_is_void && !point.status.has_direction(),
           traction.p,
           std::abs(now.slip[0])});
      }
    // The patches of all chains together.
    for (Chain &chain : chains)
      {
        std::sort(chain.samples.begin(),
                  chain.samples.end(),
                  [](const Sample &a, const Sample &b) { return a.s < b.s; });
        results.width += patch_lengths(chain, &Sample::touches);
        results.stick_width += patch_lengths(chain, &Sample::sticks);
      }
    return results;
  }



  template<>
  ContactResults contact_results(const ContactInterface<3> &interface,
                                 const ContactPair<3>      &contact_pair,
                                 const GhostedVector       &solution,
                                 const GhostedVector       &u_start,
                                 const bool                 moving_bound)
  {
    ContactResults results;
    Tensor<1, 3>   shear;
    for (const ContactPoint<3> &point : interface.points_of(contact_pair))
      {
        if (!point.facing || point.status.kind == Status::open)
          continue;
        const ContactState<3> now = interface.state(point, solution, u_start);
        const Traction<3>     t   = interface.traction(point,
                                                 point.status,
                                                 now.p_trial,
                                                 now.q_trial,
                                                 moving_bound);
        results.normal_force += point.weight * t.p;
        shear += point.weight * point.along_tangents(t.q);
        results.max_pressure = std::max(results.max_pressure, t.p);
        results.max_shear    = std::max(results.max_shear, t.q.norm());
        results.area += point.weight;
        if (point.status.kind == Status::stick)
          results.stick_area += point.weight;
      }
    results.tangential_force = shear.norm();
    return results;
  }



  // The multipliers of a solution are the tractions. A node without a point
  // that faces the master is pushed along the normal of the corner's.
  std::vector<CornerLoad> corner_loads(const ContactInterface<2> &interface,
                                       const ContactPair<2>      &contact_pair,
                                       const GhostedVector       &solution)
  {
    if (!contact_pair.has_corner_points())
      return {};
    MultiplierSpace numbering;
    const auto      own = make_nodal_points(contact_pair.slave, {}, numbering);
    std::vector<CornerLoad>                                    loads;
    std::map<types::global_dof_index, unsigned int>            node_of_dof;
    std::map<types::global_dof_index, const ContactPoint<2> *> facing;
    for (unsigned int n = 0; n < contact_pair.slave.nodes.size(); ++n)
      {
        node_of_dof[contact_pair.slave.nodes[n].dofs[0]] = n;
        loads.push_back({Tensor<1, 2>(), own[numbering.of_node[n]].weight});
      }
    for (const ContactPoint<2> &point : interface.points_of(contact_pair))
      if (!point.is_master_corner && point.side == 0 && point.facing)
        facing[point.dofs[0][0]] = &point;

    for (const ContactPoint<2> &point : interface.points_of(contact_pair))
      if (point.is_master_corner)
        {
          const ContactState<2> now =
            interface.state(point, solution, solution);
          const Tensor<1, 2> force =
            point.weight *
            (now.lambda_n * point.normal + now.lambda_t[0] * point.tangents[0]);
          for (unsigned int a = point.n_slave_nodes; a < point.n_nodes; ++a)
            {
              const auto         found = facing.find(point.dofs[a][0]);
              const Tensor<1, 2> normal =
                found == facing.end() ? -point.normal : found->second->normal;
              const Tensor<1, 2> on_node = point.C[a] * force;
              loads[node_of_dof.at(point.dofs[a][0])].force +=
                Tensor<1, 2>({on_node * normal,
                              on_node[1] * normal[0] - on_node[0] * normal[1]});
            }
        }
    return loads;
  }



  template<int dim>
  GhostedVector contact_forces(const ContactInterface<dim> &interface,
                               const GhostedVector         &solution,
                               const GhostedVector         &u_start,
                               const bool                   moving_bound)
  {
    GhostedVector forces = u_start.zero();
    for (const ContactPoint<dim> &point : interface.points())
      {
        const ContactState<dim> now = interface.state(point, solution, u_start);
        const Traction<dim>     traction = interface.traction(point,
                                                          point.status,
                                                          now.p_trial,
                                                          now.q_trial,
                                                          moving_bound);
        const Tensor<1, dim>    force =
          point.weight *
          (traction.p * point.normal + point.along_tangents(traction.q));
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int c = 0; c < dim; ++c)
            forces[point.dofs[a][c]] += point.C[a] * force[c];
      }
    return forces;
  }



  template<int dim>
  std::string describe_changes(const ContactInterface<dim>         &interface,
                               const std::vector<PointStatus<dim>> &statuses,
                               const GhostedVector                 &solution,
                               const GhostedVector                 &u_start)
  {
    const unsigned int max_lines = 10;
    unsigned int       n         = 0;
    std::ostringstream text;
    for (unsigned int q = 0; q < statuses.size(); ++q)
      {
        const ContactPoint<dim> &point = interface.points()[q];
        if (point.status == statuses[q] || ++n > max_lines)
          continue;
        const ContactState<dim> now = interface.state(point, solution, u_start);
        text << "\n        point " << q << " at X = ("
             << interface.contact_pair(point).place(point)
             << ") mm: " << describe(statuses[q]) << ", now "
             << describe(point.status) << "; gap " << now.gap
             << " mm, pressure " << now.lambda_n << " MPa, shear "
             << now.lambda_t << " MPa";
      }
    if (n > max_lines)
      text << "\n        and " << n - max_lines << " more";
    return text.str();
  }

  template GhostedVector contact_forces(const ContactInterface<2> &,
                                        const GhostedVector &,
                                        const GhostedVector &,
                                        const bool);
  template GhostedVector contact_forces(const ContactInterface<3> &,
                                        const GhostedVector &,
                                        const GhostedVector &,
                                        const bool);
  template std::string   describe_changes(const ContactInterface<2> &,
                                          const std::vector<PointStatus<2>> &,
                                          const GhostedVector &,
                                          const GhostedVector &);
  template std::string   describe_changes(const ContactInterface<3> &,
                                          const std::vector<PointStatus<3>> &,
                                          const GhostedVector &,
                                          const GhostedVector &);
} // namespace Contact
