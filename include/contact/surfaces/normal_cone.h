/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_normal_cone_h
#define contact_normal_cone_h

#include <functional>
#include <limits>

#include "contact/surfaces/self_contact.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The directions in which a place of a surface looks: the outward normal
   * there, and at a corner those of all facets; in 2-D also all between
   * the normals of the two edges of a convex one.
   */
  template<int dim>
  struct NormalCone
  {
    /// In 2-D in the order of the edges.
    std::vector<Tensor<1, dim>> normals;

    /// At an end of the surface, where the body has a side that is in no group:
    /// a face beside it counts if none is opposite.
    bool at_end = false;

    /// The normals of other sides that meet there: a face that is more opposite
    /// to one of them, by half of Surface::feature_angle, is theirs.
    std::vector<Tensor<1, dim>> others{};

    /// The distance beyond the end of a face up to which it looks [mm].
    double reach = std::numeric_limits<double>::max();

    /// Whether the place @p x may be further than that behind one of a face, as
    /// both bodies overlap there; it may if nothing is given.
    std::function<bool(const Point<dim> &x, const SurfacePlace<dim> &)>
      overlap{};

    /// Whether a facet comes into question; all do if nothing is given.
    std::function<bool(const unsigned int)> partners{};

    /**
     * Faces whose normals are further from opposite than this do not face each
     * other [degrees]: the side of a body beside a place that looks past it,
     * which tilts as the body bulges, is no partner, while the flanks of a
     * wedge of 30 degrees still are to what its tip stands on. (Other codes
     * have limits from 40 degrees on; a length that is projected grows by
     * 1/cos, here 3.9.)
     */
    static constexpr double largest_angle = 75;

    static double smallest_cosine()
    {
      return std::cos(largest_angle * numbers::PI / 180);
    }

    /// Whether a facet of this outward normal is face to face.
    bool faces(const Tensor<1, dim> &normal) const;

    /// False of a facet none of whose normals is face to face.
    bool may_face(const DirectionRange<dim> &normals_of_facet) const;

    /// Whether it is at least not back to back.
    bool is_beside(const Tensor<1, dim> &normal) const;

  private:
    /// The cosine of the angle between the opposite of a normal and the closest
    /// of the normals here.
    double largest_cosine(const Tensor<1, dim> &normal) const;
  };
} // namespace Contact

#endif
