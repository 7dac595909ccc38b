/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/results/contact_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/errors.h"
#include "base/string_utilities.h"

namespace Contact
{
  namespace
  {
    /// A place before and after.
    using Path = std::array<Point<2>, 2>;

    /// The smallest and the largest coordinates of places.
    struct Box
    {
      Point<2> low{std::numeric_limits<double>::max(),
                   std::numeric_limits<double>::max()};
      Point<2> high{-low};

      void add(const Path &path)
      {
        for (const Point<2> &x : path)
          for (unsigned int i = 0; i < 2; ++i)
            {
              low[i]  = std::min(low[i], x[i]);
              high[i] = std::max(high[i], x[i]);
            }
      }

      bool meets(const Box &other) const
      {
        return low[0] <= other.high[0] && other.low[0] <= high[0] &&
               low[1] <= other.high[1] && other.low[1] <= high[1];
      }
    };



    /// A straight piece of a surface between two nodes; the body is to the left
    /// of it.
    struct Piece
    {
      std::array<unsigned int, 2> nodes;
      std::array<Path, 2>         ends;
      Box                         box;

      /// The outward normal at the end of the path, times the length.
      Tensor<1, 2> outward() const
      {
        return cross_product_2d(ends[1][1] - ends[0][1]);
      }
    };



    double area(const Tensor<1, 2> &a, const Tensor<1, 2> &b)
    {
      return a[0] * b[1] - a[1] * b[0];
    }



    /// Of a place that moves past a piece: 1 if it goes into the body through
    /// the piece, -1 if it comes out, 0 if neither or both. With the time t
    /// from 0 to 1 it is on the line of the piece where the area that it spans
    /// with the two ends vanishes, a polynomial of degree two.
    int crossing(const Path &place, const Piece &piece)
    {
      const Tensor<1, 2> along_0 = piece.ends[1][0] - piece.ends[0][0];
      const Tensor<1, 2> along_1 =
        (piece.ends[1][1] - piece.ends[0][1]) - along_0;
      const Tensor<1, 2> r_0 = place[0] - piece.ends[0][0];
      const Tensor<1, 2> r_1 = (place[1] - piece.ends[0][1]) - r_0;
      const double       c   = area(along_0, r_0);
      const double       b   = area(along_0, r_1) + area(along_1, r_0);
      const double       a   = area(along_1, r_1);

      // The body is where the area is positive.
      const double discriminant = b * b - 4 * a * c;
      if (!(discriminant > 0))
        return 0;
      const double q   = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
      int          sum = 0;
      for (const double t : {q / a, c / q})
        if (t > 0 && t <= 1)
          {
            const Tensor<1, 2> along = along_0 + t * along_1;
            const double s = (r_0 + t * r_1) * along / along.norm_square();
            if (s >= 0 && s <= 1)
              sum += b + 2 * a * t > 0 ? 1 : -1;
          }
      return sum;
    }



    std::vector<Piece> pieces_of(const Surface<2>    &surface,
                                 const GhostedVector &from,
                                 const GhostedVector &to)
    {
      std::vector<Piece> pieces;
      for (const SurfaceFacet<2> &edge : surface.facets)
        {
          // The nodes of an edge are its two ends, then the one between.
          std::vector<unsigned int> nodes{edge.nodes[0], edge.nodes[1]};
          if (surface.n_nodes_per_facet() == 3)
            nodes.insert(nodes.begin() + 1, edge.nodes[2]);
          for (unsigned int k = 0; k + 1 < nodes.size(); ++k)
            {
              Piece piece;
              for (unsigned int a = 0; a < 2; ++a)
                {
                  piece.nodes[a] = nodes[k + a];
                  piece.ends[a]  = {{surface.position(nodes[k + a], from),
                                     surface.position(nodes[k + a], to)}};
                }
              piece.box.add(piece.ends[0]);
              piece.box.add(piece.ends[1]);
              pieces.push_back(piece);
            }
        }
      return pieces;
    }



    /// What the digits of a mesh file do not resolve [mm].
    template<int dim>
    double digits_of(const Surface<dim> &surface)
    {
      return 1e-9 * surface.reference_length(0);
    }



    /// The piece that a place which does not go in by any was in front of: the
    /// closest one to begin with.
    const Piece *closest_at_start(const Point<2>           &x,
                                  const std::vector<Piece> &pieces)
    {
      const Piece *closest  = nullptr;
      double       distance = std::numeric_limits<double>::max();
      for (const Piece &piece : pieces)
        {
          const Point<2>     a     = piece.ends[0][0];
          const Tensor<1, 2> along = piece.ends[1][0] - a;
          const double       s =
            std::max(0., std::min(1., (x - a) * along / along.norm_square()));
          if (const double d = x.distance(a + s * along); d < distance)
            {
              distance = d;
              closest  = &piece;
            }
        }
      return closest;
    }



    void look(const Surface<2>                  &surface,
              const Surface<2>                  &other,
              const bool                         is_master,
              const GhostedVector               &from,
              const GhostedVector               &to,
              std::optional<ContactCrossing<2>> &deepest)
    {
      const auto pieces = pieces_of(other, from, to);
      for (unsigned int i = 0; i < surface.nodes.size(); ++i)
        {
          const Path path{{surface.position(i, from), surface.position(i, to)}};
          Box        box;
          box.add(path);
          std::vector<const Piece *> in, out;
          for (const Piece &piece : pieces)
            if (box.meets(piece.box))
              {
                const int direction = crossing(path, piece);
                if (direction != 0)
                  (direction > 0 ? in : out).push_back(&piece);
              }
          if (!out.empty() && in.empty())
            in.push_back(closest_at_start(path[0], pieces));
          for (const Piece *entry : in)
            for (const Piece *exit : out)
              {
                const bool have_common_node =
                  std::find_first_of(entry->nodes.begin(),
                                     entry->nodes.end(),
                                     exit->nodes.begin(),
                                     exit->nodes.end()) != entry->nodes.end();
                if (have_common_node || entry->outward() * exit->outward() >= 0)
                  continue;
                const double depth = (entry->ends[0][1] - path[1]) *
                                     entry->outward() / entry->outward().norm();
                if (depth > (deepest ? deepest->depth : digits_of(surface)))
                  deepest = {is_master, surface.nodes[i].X, depth};
              }
        }
    }



    void look_at_bodies(const ContactPair<2>              &contact_pair,
                        const GhostedVector               &from,
                        const GhostedVector               &to,
                        std::optional<ContactCrossing<2>> &deepest)
    {
      const Surface<2> &slave = contact_pair.slave;
      look(slave, *contact_pair.master, false, from, to, deepest);
      look(*contact_pair.master, slave, true, from, to, deepest);
    }

    void look_at_bodies(const ContactPair<3> &,
                        const GhostedVector &,
                        const GhostedVector &,
                        std::optional<ContactCrossing<3>> &)
    {
    }



    /// Whether a straight path, against an obstacle that stands still, leads
    /// through it.
    template<int dim>
    bool goes_through(const Obstacle<dim> &obstacle,
                      const Point<dim>    &from,
                      const Point<dim>    &to)
    {
      const unsigned int n    = 32;
      auto               last = obstacle.closest_point(from);
      for (unsigned int k = 1; k <= n; ++k)
        {
          const Point<dim> x     = from + double(k) / n * (to - from);
          const auto       next  = obstacle.closest_point(x);
          const double     depth = -(next.normal * (x - next.x));
          if (depth > 0 && (last.normal * next.normal < 0 ||
                            (next.radius > 0 && depth > next.radius / 2)))
            return true;
          last = next;
        }
      return false;
    }



    template<int dim>
    void look_at_obstacle(const ContactPair<dim>              &contact_pair,
                          const GhostedVector                 &from,
                          const GhostedVector                 &to,
                          std::optional<ContactCrossing<dim>> &deepest)
    {
      const Obstacle<dim> &obstacle = *contact_pair.obstacle;
      const Surface<dim>  &slave    = contact_pair.slave;
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        {
          const Point<dim> start = obstacle.carried(slave.position(i, from));
          const Point<dim> end   = slave.position(i, to);
          const auto       in    = obstacle.closest_point(start);
          const auto       out   = obstacle.closest_point(end);
          const double     depth = in.normal * (in.x - end);
          if (depth > (deepest ? deepest->depth : digits_of(slave)) &&
              in.normal * out.normal < 0 && goes_through(obstacle, start, end))
            deepest = {false, slave.nodes[i].X, depth};
        }
    }
  } // namespace



  template<int dim>
  std::optional<ContactCrossing<dim>>
  find_crossing(const ContactPair<dim> &contact_pair,
                const GhostedVector    &from,
                const GhostedVector    &to)
  {
    std::optional<ContactCrossing<dim>> deepest;
    if (contact_pair.master)
      look_at_bodies(contact_pair, from, to, deepest);
    else
      look_at_obstacle(contact_pair, from, to, deepest);
    return deepest;
  }



  template<int dim>
  void check_obstacles(
    const std::vector<std::unique_ptr<const ContactPair<dim>>> &pairs,
    const GhostedVector                                        &from,
    const GhostedVector                                        &to)
  {
    for (const auto &contact_pair : pairs)
      if (contact_pair->obstacle && !contact_pair->tied)
        if (const auto crossing = find_crossing(*contact_pair, from, to))
          throw NotConverged(
            "an obstacle goes through its slave at X = (" + brief(crossing->X) +
            ") mm within the increment: the node is " + brief(crossing->depth) +
            " mm behind the side that it was in front of");
  }

  template std::optional<ContactCrossing<2>>
  find_crossing(const ContactPair<2> &,
                const GhostedVector &,
                const GhostedVector &);
  template std::optional<ContactCrossing<3>>
  find_crossing(const ContactPair<3> &,
                const GhostedVector &,
                const GhostedVector &);
  template void
  check_obstacles(const std::vector<std::unique_ptr<const ContactPair<2>>> &,
                  const GhostedVector &,
                  const GhostedVector &);
  template void
  check_obstacles(const std::vector<std::unique_ptr<const ContactPair<3>>> &,
                  const GhostedVector &,
                  const GhostedVector &);
} // namespace Contact
