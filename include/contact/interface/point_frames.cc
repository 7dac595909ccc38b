/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/interface/point_frames.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "contact/points/point_joining.h"

namespace Contact
{
  namespace
  {
    /// The node of its own surface that a point belongs to.
    template<int dim>
    unsigned int own_node(const ContactPoint<dim> &point,
                          const Surface<dim>      &own)
    {
      for (const unsigned int i : own.facets[point.slave_facet].nodes)
        if (own.nodes[i].dofs == point.dofs(0))
          return i;
      AssertThrow(false, ExcInternalError());
      return 0;
    }



    /// The names of the facets of its own surface around the node of a point.
    template<int dim>
    std::set<FacetName<dim>> facets_around(const ContactPoint<dim> &point,
                                           const ContactPair<dim>  &pair)
    {
      const Surface<dim>      &own = pair.surface_of(point);
      std::set<FacetName<dim>> names;
      for (const unsigned int e : own.facets_of_node[own_node(point, own)])
        names.insert(own.facets[e].name);
      return names;
    }



    /// The connected part of the mesh that a point faces; all obstacles are
    /// one.
    template<int dim>
    unsigned int part_opposite(const ContactPoint<dim> &point,
                               const ContactPair<dim>  &pair)
    {
      const Surface<dim> *const other = pair.surface_opposite(point);
      if (!other)
        return numbers::invalid_unsigned_int;
      if (point.n_nodes == point.n_slave_nodes)
        return other->facets[0].part;
      const unsigned int node =
        point.nodes[point.n_slave_nodes] - other->nodes.data();
      return other->facets[other->facets_of_node[node].front()].part;
    }



    /// The cosine of half of Surface::feature_angle.
    template<int dim>
    double cosine_of_curves()
    {
      return std::cos(numbers::PI / 360 * Surface<dim>::feature_angle);
    }



    template<int dim>
    bool is_same(const FrictionLaw &a, const FrictionLaw &b)
    {
      return a.tresca_limit == b.tresca_limit &&
             a.coulomb_coefficient == b.coulomb_coefficient;
    }
  } // namespace



  // A point of the Gauss-point discretization belongs to no node.
  template<int dim>
  PointFrames<dim>::PointFrames(const std::vector<ContactPoint<dim>> &points,
                                const Pairs                          &pairs)
    : pairs(&pairs)
  {
    std::map<NodeDoFs<dim>, std::vector<unsigned int>> at_node;
    for (unsigned int q = 0; q < points.size(); ++q)
      if (points[q].n_multipliers == 1)
        at_node[points[q].dofs(0)].push_back(q);
    for (const auto &[dofs, of_node] : at_node)
      if (of_node.size() > 1)
        {
          points_at_nodes.push_back(of_node);
          for (const unsigned int q : of_node)
            {
              point_of_multiplier[points[q].multipliers[0]] = q;
              for (const unsigned int other : of_node)
                if (other != q)
                  others_at_node[q].push_back(other);
            }
        }
  }



  template<int dim>
  bool PointFrames<dim>::have_common_facets(const ContactPoint<dim> &a,
                                            const ContactPoint<dim> &b) const
  {
    const auto of_a = facets_around(a, *(*pairs)[a.contact_pair]);
    const auto of_b = facets_around(b, *(*pairs)[b.contact_pair]);
    return std::any_of(of_a.begin(), of_a.end(), [&](const auto &name) {
      return of_b.count(name) > 0;
    });
  }



  template<int dim>
  void PointFrames<dim>::find_other_sides(
    const std::vector<ContactPoint<dim>>  &points,
    const std::vector<ContactPair<dim> *> &to) const
  {
    const auto look_at_one_body = [&](const unsigned int a,
                                      const unsigned int b) {
      const auto &of_a = (*pairs)[a]->master, &of_b = (*pairs)[b]->master;
      return a == b ||
             (of_a && of_b && of_a->facets[0].part == of_b->facets[0].part);
    };
    for (const auto &[q, others] : others_at_node)
      for (const unsigned int other : others)
        if (!points[q].is_master_corner && !points[other].is_master_corner &&
            look_at_one_body(points[q].contact_pair,
                             points[other].contact_pair) &&
            !have_common_facets(points[q], points[other]))
          {
            ContactPair<dim>   &own = *to[points[q].contact_pair];
            const Surface<dim> &next =
              (*pairs)[points[other].contact_pair]->slave;
            own.other_sides[own_node(points[q], own.slave)]
              .emplace_back(&next, own_node(points[other], next));
          }
  }



  template<int dim>
  typename PointFrames<dim>::Joined
  PointFrames<dim>::part(std::vector<ContactPoint<dim>> &points) const
  {
    Joined joined;
    for (const auto &[q, others] : others_at_node)
      if (points[q].joined)
        {
          joined[q] = points[q].joined->first;
          static_cast<PointPairing<dim> &>(points[q]) =
            points[q].joined->pairing;
          points[q].weight = points[q].joined->weight;
          points[q].joined.reset();
        }
    return joined;
  }



  template<int dim>
  bool PointFrames<dim>::are_on_one_body(const ContactPoint<dim> &a,
                                         const ContactPoint<dim> &b) const
  {
    return part_opposite(a, *(*pairs)[a.contact_pair]) ==
           part_opposite(b, *(*pairs)[b.contact_pair]);
  }



  template<int dim>
  bool PointFrames<dim>::see_one_surface(const ContactPoint<dim> &a,
                                         const ContactPoint<dim> &b) const
  {
    const ContactPair<dim> &of_a   = *(*pairs)[a.contact_pair];
    const ContactPair<dim> &of_b   = *(*pairs)[b.contact_pair];
    const auto              simple = [](const ContactPair<dim> &of) {
      return of.master && !of.interference->at && of.free_motions.empty();
    };
    return a.normal * b.normal > cosine_of_curves<dim>() &&
           are_on_one_body(a, b) &&
           (&of_a == &of_b || (simple(of_a) && simple(of_b) &&
                               of_a.is_mortar() == of_b.is_mortar() &&
                               is_same<dim>(of_a.law, of_b.law)));
  }



  namespace
  {
    /// The middle of the nodes of a facet.
    template<int dim>
    Tensor<1, dim> middle(const Surface<dim>  &surface,
                          const unsigned int   facet,
                          const GhostedVector &u)
    {
      const SurfaceFacet<dim> &of = surface.facets[facet];
      Tensor<1, dim>           sum;
      for (unsigned int a = 0; a < of.n_nodes(); ++a)
        sum += Tensor<1, dim>(surface.position(of.nodes[a], u));
      return sum / (1. * of.n_nodes());
    }



    /// The place of a node of a point.
    template<int dim>
    Tensor<1, dim> place(const ContactPoint<dim> &point,
                         const unsigned int       a,
                         const GhostedVector     &u)
    {
      Tensor<1, dim> x;
      for (unsigned int i = 0; i < dim; ++i)
        x[i] = point.X(a)[i] + u[point.dofs(a)[i]];
      return x;
    }



    /// The middle of the nodes of the other body by their part in a point.
    template<int dim>
    Tensor<1, dim> projection_point(const ContactPoint<dim> &point,
                                    const GhostedVector     &u)
    {
      Tensor<1, dim> sum;
      double         weight = 0;
      for (unsigned int a = point.n_slave_nodes; a < point.n_nodes; ++a)
        {
          sum += std::abs(point.C[a]) * place(point, a, u);
          weight += std::abs(point.C[a]);
        }
      return sum / weight;
    }
  } // namespace



  template<int dim>
  void PointFrames<dim>::leave_hidden(std::vector<ContactPoint<dim>> &points,
                                      const GhostedVector            &u) const
  {
    const auto gap = [&](const ContactPoint<dim> &point) {
      double sum = -(point.normal * Tensor<1, dim>(point.projection));
      for (unsigned int a = 0; a < point.n_nodes; ++a)
        sum += point.C[a] * (point.normal * place(point, a, u));
      return sum;
    };
    const auto is_candidate = [&](const ContactPoint<dim> &point) {
      return point.facing && !point.is_master_corner &&
             (*pairs)[point.contact_pair]->master &&
             !(*pairs)[point.contact_pair]->tied;
    };
    // Whether both facets of a are behind the planes of b: the own facet as
    // seen from the node, against the normal of the other body.
    const auto is_behind = [&](const ContactPoint<dim> &a,
                               const ContactPoint<dim> &b) {
      const ContactPair<dim> &of_a = *(*pairs)[a.contact_pair];
      return (middle(*of_a.master, a.master_facet, u) -
              projection_point(b, u)) *
                 b.normal <
               0 &&
             (middle(of_a.slave, a.slave_facet, u) - place(b, 0, u)) *
                 b.normal >
               0;
    };
    for (const auto &of_node : points_at_nodes)
      for (const unsigned int q : of_node)
        for (const unsigned int other : of_node)
          {
            ContactPoint<dim>       &a = points[q];
            const ContactPoint<dim> &b = points[other];
            if (q != other && is_candidate(a) && is_candidate(b) &&
                a.normal * b.normal < cosine_of_curves<dim>() &&
                are_on_one_body(a, b) && is_behind(a, b) && is_behind(b, a) &&
                std::make_pair(gap(a), q) < std::make_pair(gap(b), other))
              {
                a.facing = false;
                a.status = PointStatus<dim>();
              }
          }
  }



  template<int dim>
  typename PointFrames<dim>::Joined
  PointFrames<dim>::join(std::vector<ContactPoint<dim>> &points,
                         const GhostedVector            &u) const
  {
    leave_hidden(points, u);
    const auto keep_own = [&](const unsigned int q, const unsigned int first) {
      points[q].joined = std::make_shared<const JoinedPoint<dim>>(
        JoinedPoint<dim>{points[q], points[q].weight, first});
    };
    for (const auto &of_node : points_at_nodes)
      {
        std::vector<unsigned int> glued, free;
        for (const unsigned int q : of_node)
          if (points[q].facing)
            ((*pairs)[points[q].contact_pair]->tied ? glued : free)
              .push_back(q);
        const auto is_glued = [&](const unsigned int q) {
          return std::any_of(glued.begin(), glued.end(), [&](const auto g) {
            return are_on_one_body(points[q], points[g]);
          });
        };
        for (const unsigned int q : free)
          if (is_glued(q))
            {
              keep_own(q, q);
              points[q].facing = false;
              points[q].status = PointStatus<dim>();
            }
        while (!free.empty())
          {
            std::vector<unsigned int> joined, rest;
            for (const unsigned int q : free)
              if (points[q].facing && !points[q].is_master_corner)
                (joined.empty() || see_one_surface(points[joined[0]], points[q])
                   ? joined
                   : rest)
                  .push_back(q);
            if (joined.size() > 1)
              {
                for (const unsigned int q : joined)
                  keep_own(q, joined[0]);
                join_to_first(joined, points);
              }
            free = rest;
          }
      }
    Joined joined;
    for (const auto &[q, others] : others_at_node)
      if (points[q].joined)
        joined[q] = points[q].joined->first;
    return joined;
  }



  template<int dim>
  void
  PointFrames<dim>::join_to_first(const std::vector<unsigned int> &joined,
                                  std::vector<ContactPoint<dim>>  &points) const
  {
    ContactPoint<dim> &first = points[joined[0]];
    if ((*pairs)[first.contact_pair]->is_mortar() &&
        (*pairs)[first.contact_pair]->master)
      join_equations(joined, points);
    else
      for (const unsigned int q : joined)
        if (!have_common_facets(first, points[q]))
          first.weight += points[q].weight;

    for (const unsigned int q : joined)
      if (q != joined[0])
        {
          if (first.status.kind == Status::open)
            first.status = points[q].status;
          points[q].facing = false;
          points[q].status = PointStatus<dim>();
          points[q].change = PairingChange<dim>();
        }
  }



  template<int dim>
  void PointFrames<dim>::find_edges(std::vector<ContactPoint<dim>> &points,
                                    const std::vector<bool> &touches) const
  {
    const auto meet = [&](const unsigned int q, const unsigned int other) {
      const ContactPoint<dim> &a = points[q], &b = points[other];
      return touches[q] && touches[other] &&
             (are_on_one_body(a, b) ||
              a.normal * b.normal < cosine_of_curves<dim>());
    };
    for (const auto &[q, others] : others_at_node)
      points[q].is_in_an_edge =
        std::any_of(others.begin(), others.end(), [&](const auto other) {
          return meet(q, other);
        });
  }



  template<int dim>
  unsigned int PointFrames<dim>::acting_multiplier(
    const std::vector<ContactPoint<dim>> &points,
    const unsigned int                    k) const
  {
    const auto q = point_of_multiplier.find(k);
    return q == point_of_multiplier.end() || !points[q->second].joined
             ? k
             : points[points[q->second].joined->first].multipliers[0];
  }



  template<int dim>
  ContactPoint<dim>
  PointFrames<dim>::as_it_acts(const std::vector<ContactPoint<dim>> &points,
                               const unsigned int                    q) const
  {
    ContactPoint<dim> point = points[q];
    if (!point.joined || !points[point.joined->first].facing)
      return point;
    const unsigned int       k     = point.joined->first;
    const ContactPoint<dim> &first = points[k];
    double                   all   = first.joined->weight;
    for (const unsigned int other : others_at_node.at(k))
      if (points[other].joined && points[other].joined->first == k)
        all += points[other].joined->weight;
    static_cast<PointPairing<dim> &>(point) = first;
    point.status                            = first.status;
    point.friction_bound                    = first.friction_bound;
    point.multipliers                       = first.multipliers;
    point.weight = first.weight * points[q].joined->weight / all;
    return point;
  }

  template class PointFrames<2>;
  template class PointFrames<3>;
} // namespace Contact
