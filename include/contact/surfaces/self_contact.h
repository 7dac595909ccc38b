/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_self_contact_h
#define contact_self_contact_h

#include "contact/surfaces/surface.h"

namespace Contact
{
  using namespace dealii;

  /// A place of a surface, deformed [mm], and what it is undeformed.
  template<int dim>
  struct SurfacePlace
  {
    Point<dim>          x;
    const Surface<dim> &surface;
    unsigned int        facet;
    FacetPoint<dim>     xi;

    Point<dim> X() const
    {
      return surface.reference_place(facet, xi);
    }
  };



  /**
   * The contact of a surface with itself, which is slave and master alike. Of
   * two facets that may face each other one alone is of the slave: the one that
   * is further along a fixed direction, undeformed. The direction is one of
   * the mesh, which turns with it, and no axis of it: parts of a surface that
   * come to lie on each other, as the halves of a strip or opposite walls of a
   * tube, are one before the other one as a whole.
   *
   * A facet faces none of those around it that meet it or one of its neighbors,
   * whatever the angle between them.
   */
  template<int dim>
  class SelfContact
  {
  public:
    SelfContact(const Surface<dim> &slave, const Surface<dim> &master);

    bool may_face(const unsigned int slave_facet,
                  const unsigned int master_facet) const
    {
      return slave_places[slave_facet] > master_places[master_facet] &&
             around[slave_facet].count(master_facet) == 0;
    }

    /**
     * Whether a place is behind another one because the body is between them,
     * and not because its surface has gone through another part of it. Then it
     * is within 60 degrees of straight behind it undeformed as well, and about
     * as far: a depth is a small part of the undeformed distance, as where the
     * ends of a bar meet that is bent to a ring.
     */
    static bool are_back_to_back(const SurfacePlace<dim> &place,
                                 const SurfacePlace<dim> &other);

  private:
    /// Of the middle of facets along the direction [mm].
    std::vector<double> slave_places, master_places;

    /// By facet of the slave, those of the master that it cannot face.
    std::vector<std::set<unsigned int>> around;
  };
} // namespace Contact

#endif
