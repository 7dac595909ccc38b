/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/points/corner_sides.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Contact
{
  namespace
  {
    const double cosine_of_corner =
      std::cos(numbers::PI / 180 * Surface<2>::feature_angle);



    /// The middle of a facet, between its vertices.
    template<int dim>
    Point<dim> middle(const Surface<dim>  &surface,
                      const unsigned int   e,
                      const GhostedVector &u)
    {
      const unsigned int n = GeometryInfo<dim - 1>::vertices_per_cell;
      Point<dim>         x;
      for (unsigned int a = 0; a < n; ++a)
        x += surface.position(surface.facets[e].nodes[a], u) / n;
      return x;
    }



    /// Only what is opposite to one side, and more so than to the others.
    void look_along(NormalCone<2> &cone, const Tensor<1, 2> &normal)
    {
      cone.first = cone.last = normal;
    }

    void look_along(NormalCone<3> &cone, const Tensor<1, 3> &normal)
    {
      cone.normals = {normal};
    }



    /// The pairing of one node with the faces of the master that it sees.
    template<int dim>
    class PairingOfNode
    {
    public:
      PairingOfNode(const typename CornerSides<dim>::Node &node,
                    const ArrayView<ContactPoint<dim>>    &points,
                    const Surface<dim>                    &slave,
                    const Surface<dim>                    &master,
                    const SurfaceSearch<dim>              &search,
                    const FacetNormals<dim>               &normals,
                    const Discretization<dim>             &discretization,
                    const GhostedVector                   &u)
        : node(node)
        , points(points)
        , slave(slave)
        , master(master)
        , search(search)
        , normals(normals)
        , discretization(discretization)
        , u(u)
        , own(points[node.own])
      {
      }



      void pair(const bool keeps_facets)
      {
        std::vector<unsigned int> before;
        for (unsigned int i = 0; i < node.sides.size(); ++i)
          {
            if (of_side(i).facing)
              before.push_back(i);
            pair_side(i, keeps_facets);
          }
        own.weight = node.weight_towards(own.normal, normals);
        for (const unsigned int i : before)
          accept(i);

        // The node's own point keeps the side it sees, or takes another one
        // where that has a point already.
        std::vector<unsigned int> all(node.sides.size());
        std::iota(all.begin(), all.end(), 0);
        unsigned int of_own = own.facing && sees_one_face(own)
                                ? side_of(own.normal)
                                : numbers::invalid_unsigned_int;
        if (of_own != numbers::invalid_unsigned_int && !is_new(own, of_own))
          of_own = numbers::invalid_unsigned_int;
        const bool sees_it = of_own != numbers::invalid_unsigned_int;
        for (const unsigned int i : all)
          if (of_own == numbers::invalid_unsigned_int && of_side(i).facing &&
              is_new(of_side(i), i))
            of_own = i;
        if (of_own == numbers::invalid_unsigned_int)
          return forget({});
        const ContactPoint<dim> as_it_was = own;
        if (!sees_it)
          static_cast<PointPairing<dim> &>(own) = of_side(of_own);
        faces.push_back({&own, of_own});
        for (const unsigned int i : all)
          if (i != of_own)
            accept(i);
        forget(accepted);
        if (accepted.empty())
          own = as_it_was;
        else
          own.weight = node.sides[of_own].weight;
      }

    private:
      /// A point and the side that it looks from.
      struct Face
      {
        const ContactPoint<dim> *point;
        unsigned int             side;
      };

      ContactPoint<dim> &of_side(const unsigned int i) const
      {
        return points[node.first + i];
      }

      const Tensor<1, dim> &normal_of(const unsigned int i) const
      {
        return node.normal_of(node.sides[i], normals);
      }

      /// The side that a face of the master is most opposite to.
      unsigned int side_of(const Tensor<1, dim> &normal) const
      {
        unsigned int side = 0;
        for (unsigned int i = 1; i < node.sides.size(); ++i)
          if (normal * normal_of(i) < normal * normal_of(side))
            side = i;
        return side;
      }

      /// Not at an edge of the master, where the normal is the mean of two.
      bool sees_one_face(const ContactPoint<dim> &point) const
      {
        const double half = numbers::PI / 360 * Surface<dim>::feature_angle;
        return search.normal(point.master_facet, point.master_xi) *
                 point.normal >
               std::cos(half);
      }

      /// What is further behind the master than its facet is long has come
      /// there around it.
      void pair_side(const unsigned int i, const bool keeps_facets)
      {
        ContactPoint<dim> &point = of_side(i);
        NormalCone<dim>    cone;
        look_along(cone, normal_of(i));
        cone.reach = SurfaceSearch<dim>::overhang *
                     slave.reference_length(node.sides[i].facet());
        for (unsigned int j = 0; j < node.sides.size(); ++j)
          if (j != i)
            cone.others.push_back(normal_of(j));
        pair_with_master(point,
                         cone,
                         master,
                         search,
                         discretization,
                         u,
                         keeps_facets);
        const double behind = -(point.normal * way_to(point));
        point.facing =
          point.facing && behind < master.reference_length(point.master_facet);
      }

      /// From the master to the slave.
      Tensor<1, dim> way_to(const ContactPoint<dim> &point) const
      {
        Tensor<1, dim> way(slave_position(point, u) - point.projection);
        for (unsigned int a = point.n_slave_nodes; a < point.n_nodes; ++a)
          for (unsigned int c = 0; c < dim; ++c)
            way[c] += point.C[a] * (point.X(a)[c] + u[point.dofs(a)[c]]);
        return way;
      }

      /// Whether two faces of the master make a concave corner: each is before
      /// the other one.
      bool is_concave(const ContactPoint<dim> &a,
                      const ContactPoint<dim> &b) const
      {
        const auto is_before = [&](const ContactPoint<dim> &of,
                                   const ContactPoint<dim> &other) {
          const Tensor<1, dim> foot =
            Tensor<1, dim>(slave_position(of, u)) - way_to(of);
          return (Tensor<1, dim>(middle(master, other.master_facet, u)) -
                  foot) *
                   of.normal >
                 0;
        };
        return is_before(a, b) && is_before(b, a);
      }

      /// Whether a point sees another face than those that there are, and there
      /// is a corner between them, of the slave or of the master, in which the
      /// node touches both.
      bool is_new(const ContactPoint<dim> &point, const unsigned int side) const
      {
        return std::all_of(faces.begin(), faces.end(), [&](const Face &face) {
          return face.side != side &&
                 face.point->normal * point.normal < cosine_of_corner &&
                 (node.is_concave[face.side][side] ||
                  is_concave(*face.point, point));
        });
      }

      void accept(const unsigned int i)
      {
        if (!of_side(i).facing || !is_new(of_side(i), i))
          return;
        faces.push_back({&of_side(i), i});
        accepted.push_back(i);
      }

      /// All sides but some face nothing.
      void forget(const std::vector<unsigned int> &but) const
      {
        for (unsigned int i = 0; i < node.sides.size(); ++i)
          if (std::find(but.begin(), but.end(), i) == but.end())
            of_side(i).facing = false;
      }

      const typename CornerSides<dim>::Node &node;
      const ArrayView<ContactPoint<dim>>    &points;
      const Surface<dim>                    &slave;
      const Surface<dim>                    &master;
      const SurfaceSearch<dim>              &search;
      const FacetNormals<dim>               &normals;
      const Discretization<dim>             &discretization;
      const GhostedVector                   &u;
      ContactPoint<dim>                     &own;

      std::vector<Face>         faces;
      std::vector<unsigned int> accepted;
    };
  } // namespace



  template<int dim>
  void CornerSides<dim>::add_points(const Surface<dim>             &slave,
                                    MultiplierSpace                &multipliers,
                                    std::vector<ContactPoint<dim>> &points)
  {
    const auto normals = slave.facet_normals({});
    for (const SlaveCorner &corner : find_corners(slave, multipliers, points))
      {
        Node node{corner, static_cast<unsigned int>(points.size()), {}};
        for (const SlaveCorner::Side &side : node.sides)
          {
            std::vector<bool> is_concave;
            for (const SlaveCorner::Side &other : node.sides)
              is_concave.push_back(
                (middle(slave, other.facet(), {}) - slave.nodes[node.node].X) *
                  node.normal_of(side, normals) >
                0);
            node.is_concave.push_back(is_concave);
            ContactPoint<dim> point = points[node.own];
            point.side              = node.is_concave.size();
            point.slave_facet       = side.facet();
            point.slave_xi          = node_place<dim>(side.a);
            point.weight            = side.weight;
            point.multipliers[0]    = multipliers.n_multipliers++;
            multipliers.of_sides.emplace_back(point.multipliers[0], node.node);
            points.push_back(point);
          }
        nodes.push_back(node);
      }
  }



  template<int dim>
  void CornerSides<dim>::pair(const ArrayView<ContactPoint<dim>> &points,
                              const Surface<dim>                 &slave,
                              const Surface<dim>                 &master,
                              const SurfaceSearch<dim>           &search,
                              const FacetNormals<dim>            &normals,
                              const Discretization<dim> &discretization,
                              const GhostedVector       &u,
                              const bool                 keeps_facets) const
  {
    for (const Node &node : nodes)
      PairingOfNode<dim>(node,
                         points,
                         slave,
                         master,
                         search,
                         normals,
                         discretization,
                         u)
        .pair(keeps_facets);
  }



  template<int dim>
  std::vector<unsigned int>
  CornerSides<dim>::same_as(const ArrayView<ContactPoint<dim>> &points,
                            const unsigned int                  own,
                            const Tensor<1, dim>               &normal) const
  {
    const auto node =
      std::find_if(nodes.begin(), nodes.end(), [&](const Node &node) {
        return node.own == own;
      });
    if (node == nodes.end())
      return {own};
    std::vector<unsigned int> same, all{own};
    for (unsigned int i = 0; i < node->sides.size(); ++i)
      if (points[node->first + i].facing)
        all.push_back(node->first + i);
    if (all.size() == 1)
      return all;
    for (const unsigned int k : all)
      if (points[k].normal * normal >= cosine_of_corner)
        same.push_back(k);
    return same;
  }

  template class CornerSides<2>;
  template class CornerSides<3>;
} // namespace Contact
