/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_profile_obstacle_h
#define contact_profile_obstacle_h

#include "contact/obstacles/obstacle.h"

namespace Contact
{
  using namespace dealii;

  /**
   * A rigid body whose boundary in 2-D is a polyline with rounded
   * corners, with the rigid body on its left; in 3-D it goes on along z. If
   * the last point is the first one the line is closed, else its first and last
   * edge go on without end. At a corner with the edges a and b, which turn by
   * the angle alpha, an arc of the radius r replaces r tan(|alpha|/2) of both:
   * the line has a tangent everywhere, and the closest point of it is the
   * projection point of a perpendicular on an edge or on an arc.
   */
  template<int dim>
  class ProfileObstacle : public Obstacle<dim>
  {
  public:
    /// The numbers are x, y and the radius of each point [mm]; those of the
    /// ends of an open line are 0. Throws InputError where an edge is too short
    /// for its arcs, or a corner is not round.
    explicit ProfileObstacle(const std::vector<double> &numbers);

    typename Obstacle<dim>::ClosestPoint
    closest_point(const Point<dim> &x) const override;

    Point<dim> centre() const override;

  private:
    /// From @p from along @p tangent, from the arc length @p begin to @p end.
    struct Edge
    {
      Point<2>     from;
      Tensor<1, 2> tangent;
      double       begin, end;
    };

    /// On both sides of the direction @p middle from the centre; the radius of
    /// a fillet is negative.
    struct Arc
    {
      Point<2>     centre;
      double       radius;
      Tensor<1, 2> middle;
      double       cosine; // of half of its angle
    };

    std::vector<Edge> edges;
    std::vector<Arc>  arcs;
    Point<2>          first;
  };
} // namespace Contact

#endif
