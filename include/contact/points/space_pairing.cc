/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The pairing of a contact point with the faces of the master.

#include <algorithm>
#include <map>

#include "contact/points/contact_points.h"

namespace Contact
{
  namespace
  {
    /// Add a node of the master, or those that it follows. On round boundaries
    /// a hanging node is beside the side that it follows: that is left.
    void add_parts(const Surface<3>               &master,
                   const unsigned int              node,
                   const double                    value,
                   std::map<unsigned int, double> &parts,
                   Point<3>                       &left)
    {
      if (master.parents[node].empty())
        {
          parts[node] += value;
          return;
        }
      Tensor<1, 3> beside(master.nodes[node].X);
      for (const auto &[parent, part] : master.parents[node])
        {
          parts[parent] += part * value;
          beside -= part * Tensor<1, 3>(master.nodes[parent].X);
        }
      left += value * beside;
    }



    bool is_held(const NodeDoFs<3>          &node,
                 const Tensor<1, 3>         &direction,
                 const DiscretizedBodies<3> &discretization)
    {
      const double round_off = 1e-8;
      return discretization.free_part(node, direction).norm() < round_off;
    }



    /// The directions that supports may hold a node in.
    std::vector<Tensor<1, 3>>
    directions_of_supports(const NodeDoFs<3>          &node,
                           const DiscretizedBodies<3> &discretization)
    {
      std::vector<Tensor<1, 3>> directions = discretization.held_normals(node);
      for (unsigned int c = 3; c-- > 0;)
        directions.insert(directions.begin(), Point<3>::unit_vector(c));
      return directions;
    }



    /// The components of the relative displacement of a point that supports
    /// prescribe, in all nodes, without those that are next to the normal.
    std::vector<Tensor<1, 3>>
    prescribed_components(const ContactPoint<3>      &point,
                          const DiscretizedBodies<3> &discretization)
    {
      const double              round_off = 1e-8, sine = 1e-3;
      std::vector<Tensor<1, 3>> components;
      for (const Tensor<1, 3> &direction :
           directions_of_supports(point.dofs(0), discretization))
        {
          double free = 0, all = 0;
          for (unsigned int a = 0; a < point.n_nodes; ++a)
            {
              all += std::abs(point.C[a]);
              free += std::abs(point.C[a]) *
                      discretization.free_part(point.dofs(a), direction).norm();
            }
          if (free <= round_off * all &&
              point.tangential_part(direction).norm() > sine)
            components.push_back(direction);
        }
      return components;
    }
  } // namespace



  std::vector<Tensor<1, 2>>
  free_slips(const ContactPoint<3>      &point,
             const DiscretizedBodies<3> &discretization)
  {
    const auto held = prescribed_components(point, discretization);
    if (held.empty())
      return {Tensor<1, 2>({1., 0.}), Tensor<1, 2>({0., 1.})};
    Tensor<1, 2> across = cross_product_2d(point.tangential_part(held[0]));
    across /= across.norm();
    const double sine = 1e-3;
    for (const auto &other : held)
      if (std::abs(point.tangential_part(other) * across) > sine)
        return {};
    return {across};
  }



  // The shortest one that has the prescribed components.
  Tensor<1, 2> prescribed_slip(const ContactPoint<3>      &point,
                               const DiscretizedBodies<3> &discretization,
                               const GhostedVector        &motion)
  {
    const double round_off = 1e-10;
    const auto   held      = prescribed_components(point, discretization);
    const auto   free      = free_slips(point, discretization);
    Tensor<2, 2> A;
    Tensor<1, 2> b;
    for (const auto &direction : held)
      {
        const Tensor<1, 2> along = point.tangential_part(direction);
        double             slip =
          point.along_tangents(along) * point.interference_at_start -
          direction * point.projection_motion;
        double size = std::abs(slip);
        for (unsigned int a = 0; a < point.n_nodes; ++a)
          for (unsigned int c = 0; c < 3; ++c)
            {
              const double share =
                point.C[a] * direction[c] * motion[point.dofs(a)[c]];
              slip += share;
              size += std::abs(share);
            }
        A += outer_product(along, along);
        if (std::abs(slip) > round_off * size)
          b += slip * along;
      }
    if (free.size() == 2 || b == Tensor<1, 2>())
      return {};
    for (const Tensor<1, 2> &direction : free)
      A += outer_product(direction, direction);
    return invert(A) * b;
  }



  void make_symmetric(ContactPoint<3>            &point,
                      const DiscretizedBodies<3> &discretization,
                      const GhostedVector        &u,
                      const double                tolerance)
  {
    const double sine = 0.9, smooth = Surface<3>::sine_of_smooth_slant();
    std::vector<Tensor<1, 3>> planes, slanted;
    for (const Tensor<1, 3> &across :
         directions_of_supports(point.dofs(0), discretization))
      {
        const auto x = [&](const unsigned int a) {
          double sum = 0;
          for (unsigned int c = 0; c < 3; ++c)
            sum += across[c] * (point.X(a)[c] + u[point.dofs(a)[c]]);
          return sum;
        };
        bool is_symmetric = false;
        for (unsigned int a = point.n_slave_nodes; a < point.n_nodes; ++a)
          is_symmetric =
            is_symmetric || (std::abs(x(a) - x(0)) < tolerance &&
                             discretization.are_held_alike(point.dofs(0),
                                                           point.dofs(a),
                                                           across));
        const double slant = std::abs(point.normal * across);
        if (is_symmetric && slant < sine)
          add_orthonormal(across, slant < smooth ? planes : slanted);
      }
    Tensor<1, 3> normal = point.normal;
    for (const Tensor<1, 3> &across : planes)
      normal -= (normal * across) * across;
    if (normal.norm() > 0)
      point.normal = normal / normal.norm();
    point.tangents_held_by_supports = planes;
    for (const Tensor<1, 3> &across : slanted)
      add_orthonormal(across - (point.normal * across) * point.normal,
                      point.tangents_held_by_supports);
    set_tangents(point);

    std::vector<Tensor<1, 2>> basis;
    for (const Tensor<1, 3> &across : point.tangents_held_by_supports)
      basis.push_back(point.tangential_part(across));
    point.rim_compliance = 0;
    for (const Tensor<1, 3> &held : point.dirichlet_edges)
      for (unsigned int a = point.n_slave_nodes; a < point.n_nodes; ++a)
        if (std::abs(point.normal * held) < sine &&
            !is_held(point.dofs(a), held, discretization))
          add_orthonormal(point.tangential_part(held), basis);
    for (unsigned int k = point.tangents_held_by_supports.size();
         k < basis.size();
         ++k)
      point.rim_compliance += outer_product(basis[k], basis[k]);
  }



  void mark_dirichlet_edges(const Surface<3>             &slave,
                            const MultiplierSpace        &multipliers,
                            const DiscretizedBodies<3>   &discretization,
                            std::vector<ContactPoint<3>> &points)
  {
    for (unsigned int node = 0; node < slave.nodes.size(); ++node)
      for (const Tensor<1, 3> &direction :
           directions_of_supports(slave.nodes[node].dofs, discretization))
        {
          bool one_is_free = false;
          for (const unsigned int e : slave.facets_of_node[node])
            for (unsigned int a = 0; a < slave.facets[e].n_nodes(); ++a)
              one_is_free = one_is_free ||
                            !is_held(slave.nodes[slave.facets[e].nodes[a]].dofs,
                                     direction,
                                     discretization);
          const unsigned int k = multipliers.of_node[node];
          if (k < points.size() && one_is_free &&
              is_held(slave.nodes[node].dofs, direction, discretization))
            points[k].dirichlet_edges.push_back(direction);
        }
  }



  namespace
  {
    /// The place of the master that lies along @p normal from @p x, closest at
    /// first: each pass goes on where the line reaches the plane there, which
    /// is off by the square of the slope. Beyond an end there may be none.
    Projection<3> find_along(const Tensor<1, 3>       &normal,
                             Point<3>                  x,
                             const NormalCone<3>      &directions,
                             const DeformedSurface<3> &now)
    {
      const unsigned int max_passes = 8;
      const double       round_off  = 1e-13;
      Projection<3>      foot       = now.closest_facing(x, directions);
      for (unsigned int pass = 1; pass < max_passes; ++pass)
        {
          const Tensor<1, 3> way   = now.position(foot.facet, foot.xi) - x;
          const Tensor<1, 3> along = (way * normal) * normal;
          if ((way - along).norm() <
              round_off * now.surface.reference_length(foot.facet))
            break;
          x += along;
          foot = now.closest_facing(x, directions);
        }
      return foot;
    }
  } // namespace



  // Where several facets have the same closest point, which of them was found
  // first must not matter: the normal is the mean of theirs.
  void face_master(ContactPoint<3>            &point,
                   const Projection<3>        &projection,
                   const NormalCone<3>        &directions,
                   const DeformedSurface<3>   &now,
                   const DiscretizedBodies<3> &discretization,
                   const GhostedVector        &u)
  {
    const Surface<3> &master = now.surface;
    Tensor<1, 3>      normal = now.normal(projection.facet, projection.xi);
    for (const auto &[twin, xi] : projection.twins)
      normal += now.normal(twin, xi);
    point.normal     = normal / normal.norm();
    point.projection = Point<3>();
    std::map<unsigned int, double> parts;
    for (unsigned int s = 0; s < point.n_slave_nodes; ++s)
      {
        Point<3> x = point.X(s);
        for (unsigned int i = 0; i < 3; ++i)
          x[i] += u[point.dofs(s)[i]];
        const auto             foot   = point.n_slave_nodes == 1
                                          ? projection
                                          : find_along(point.normal, x, directions, now);
        const SurfaceFacet<3> &facet  = master.facets[foot.facet];
        const auto             values = facet.kind->values(foot.xi);
        for (unsigned int a = 0; a < facet.n_nodes(); ++a)
          if (values[a] != 0)
            add_parts(master,
                      facet.nodes[a],
                      point.C[s] * values[a],
                      parts,
                      point.projection);
      }
    for (const auto &[node, part] : parts)
      point.add_node(master.nodes[node], -part);

    make_symmetric(point,
                   discretization,
                   u,
                   1e-6 * master.reference_length(projection.facet));
    point.projection_is_clipped = projection.clipped;
  }
} // namespace Contact
