/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_body_overlap_h
#define contact_body_overlap_h

#include <array>
#include <list>

#include "contact/surfaces/deformed_surface.h"
#include "contact/surfaces/self_contact.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Whether two bodies overlap between two places, in one configuration. What a
   * place of a surface faces behind it is either what it has gone through, or
   * the far side of a body. In an overlap the line between both is inside of
   * both bodies: its ends are inside of the other's, and its middle of both.
   * Surfaces that face each other are the shortest way out but for the angle
   * between them: where a body is less than that deep, other sides of it are
   * nearer, as where one that stands on another juts out over it.
   * Inside of a body is what lies behind the closest of all of its surfaces
   * that are known.
   */
  template<int dim>
  class BodyOverlap
  {
  public:
    /// The known surfaces of two bodies.
    using Surfaces = std::array<std::vector<const Surface<dim> *>, 2>;

    BodyOverlap(const Surfaces         &surfaces,
                const GhostedVector    &u,
                const SelfContact<dim> *itself = nullptr);

    /// Whether slave and master are one surface.
    bool is_with_itself() const
    {
      return itself != nullptr;
    }

    /// Whether a facet of the slave may face one of the master.
    bool may_face(const unsigned int slave_facet,
                  const unsigned int master_facet) const
    {
      return !is_with_itself() || itself->may_face(slave_facet, master_facet);
    }

    /// Whether the bodies overlap between a place of the body @p of_x and a
    /// place of the other one. Places no further outside of a body than
    /// DeformedSurface::overhang times the length of the closest facet, also
    /// beyond an end of its surfaces, count as inside.
    bool is_between(const SurfacePlace<dim> &place,
                    const unsigned int       of_place,
                    const SurfacePlace<dim> &other) const;

  private:
    bool is_inside(const Point<dim>  &x,
                   const unsigned int body,
                   const double       depth) const;

    const Surfaces      &surfaces;
    const GhostedVector &u;

    const SelfContact<dim> *const itself; // null: two bodies

    /// Made when they are first asked for.
    mutable std::array<std::list<DeformedSurface<dim>>, 2> deformed;
  };
} // namespace Contact

#endif
