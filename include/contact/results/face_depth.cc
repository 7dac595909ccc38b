/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The depth of surfaces in space inside of each other.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <boost/serialization/array.hpp>
#include <cmath>
#include <map>

#include "contact/results/contact_depth.h"

namespace Contact
{
  namespace
  {
    /// By how much a facet may be beside the surface that it stands for, at one
    /// of its nodes: by the angles between the facets that meet there smoothly.
    double sagitta(const Surface<3>      &surface,
                   const FacetNormals<3> &of_facets,
                   const FacetNormals<3> &means,
                   const unsigned int     e,
                   const unsigned int     a)
    {
      const double cosine = std::clamp(of_facets[e][a] * means[e][a], -1., 1.);
      return 2 * std::acos(cosine) * surface.reference_length(e) / 4;
    }



    /// The normals at the nodes by each facet alone.
    FacetNormals<3> single_normals(const Surface<3>       &surface,
                                   const SurfaceSearch<3> &search)
    {
      FacetNormals<3> normals(surface.facets.size());
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
          normals[e][a] = search.normal(e, node_place<3>(a));
      return normals;
    }



    /// The deepest node of @p surface; each rank looks at its share of the
    /// facets. A node further behind the other surface than its facet is long
    /// has come there around it.
    void look(const Surface<3>    &surface,
              const Surface<3>    &other,
              const bool           is_master,
              const IndexSet      &share,
              const GhostedVector &u,
              const bool           as_drawn,
              ContactDepth<3>     &deepest)
    {
      const SurfaceSearch<3> own(surface, u), search(other, u);
      const auto             normals       = surface.facet_normals(u);
      const auto             of_facets     = single_normals(surface, own);
      const auto             other_normals = other.facet_normals(u);
      const auto             of_other      = single_normals(other, search);
      double                 longest       = 0;
      for (unsigned int f = 0; f < other.facets.size(); ++f)
        longest = std::max(longest, other.reference_length(f));
      const auto is_close = search.may_be_close(own, longest);
      std::map<unsigned int, Projection<3>> closest;
      for (const unsigned int e : share)
        for (unsigned int a = 0; a < surface.n_nodes_per_facet() && is_close[e];
             ++a)
          {
            const unsigned int i = surface.facets[e].nodes[a];
            const Point<3>     x = surface.position(i, u);
            if (closest.count(i) == 0)
              closest[i] = search.closest_point(x);
            const Projection<3> &projection = closest[i];
            if (projection.off_the_end || projection.clipped)
              continue;
            const unsigned int f       = projection.facet;
            const Tensor<1, 3> outward = search.normal(f, projection.xi);
            const double       distance =
              std::sqrt(search.distance_square(x, projection));
            if ((x - search.position(projection)) * outward >= 0 ||
                outward * normals[e][a] >= 0 ||
                distance >= other.reference_length(f))
              continue;
            double of_master = 0;
            for (unsigned int b = 0; b < 4; ++b)
              of_master =
                std::max(of_master,
                         sagitta(other, of_other, other_normals, f, b));
            const double allowance =
              of_master + sagitta(surface, of_facets, normals, e, a);
            const double depth = as_drawn ? distance : distance - allowance;
            if (depth > deepest.depth)
              deepest = {depth,
                         is_master,
                         surface.nodes[i].X,
                         is_master ? f : e};
          }
    }



    /// Of those of all ranks the deepest one.
    void compare(const MPI_Comm communicator, ContactDepth<3> &deepest)
    {
      const std::array<double, 6> own{{deepest.depth,
                                       static_cast<double>(deepest.of_master),
                                       static_cast<double>(deepest.slave_facet),
                                       deepest.X[0],
                                       deepest.X[1],
                                       deepest.X[2]}};
      for (const auto &of : Utilities::MPI::all_gather(communicator, own))
        if (of[0] > deepest.depth)
          deepest = {of[0],
                     of[1] > 0,
                     Point<3>(of[3], of[4], of[5]),
                     static_cast<unsigned int>(of[2])};
    }
  } // namespace



  ContactDepth<3> largest_depth(const ContactPair<3> &contact_pair,
                                const GhostedVector  &u,
                                const bool            as_drawn)
  {
    const MPI_Comm  communicator = contact_pair.discretization.communicator;
    ContactDepth<3> deepest;
    if (contact_pair.master)
      {
        const Surface<3> &slave    = contact_pair.slave;
        const Surface<3> &master   = *contact_pair.master;
        const auto        share_of = [&](const Surface<3> &surface) {
          return Utilities::MPI::create_evenly_distributed_partitioning(
            communicator,
            surface.facets.size());
        };
        look(slave, master, false, share_of(slave), u, as_drawn, deepest);
        look(master, slave, true, share_of(master), u, as_drawn, deepest);
        compare(communicator, deepest);
      }
    else
      look_at_obstacle(contact_pair.slave,
                       *contact_pair.obstacle,
                       u,
                       as_drawn,
                       /*at_nodes=*/false,
                       deepest);
    return deepest;
  }
} // namespace Contact
