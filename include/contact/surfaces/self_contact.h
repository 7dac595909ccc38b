/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_self_contact_h
#define contact_self_contact_h

#include <cmath>

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
   * looks further along a fixed direction, undeformed, or, where both look the
   * same way, as on a strip that is folded later, the one that is further along
   * it. The direction is one of the mesh, which turns with it, and no axis of
   * it: parts of a surface that come to lie on each other, as the faces of a
   * slit, the halves of a strip or opposite walls of a tube, are one before the
   * other one as a whole.
   *
   * A facet faces none of those that meet it, whatever the angle between them,
   * nor those that meet one of these, and so on for a number of rings.
   */
  template<int dim>
  class SelfContact
  {
  public:
    SelfContact(const Surface<dim> &slave,
                const Surface<dim> &master,
                const unsigned int  n_rings);

    bool may_face(const unsigned int slave_facet,
                  const unsigned int master_facet) const
    {
      const double same   = 0.5; // of the difference of two unit vectors
      const Along &slave  = of_slave[slave_facet],
                  &master = of_master[master_facet];
      const double turn   = slave.normal - master.normal;
      return (std::abs(turn) > same ? turn : slave.middle - master.middle) >
               0 &&
             around[slave_facet].count(master_facet) == 0;
    }

    /**
     * Whether a place is behind another one because the body is between them,
     * and not because its surface has gone through another part of it: what was
     * in front of it undeformed has gone through, and what was behind has as
     * well if it is not as far by much: a depth is a small part of the
     * undeformed distance, as in a strip that is rolled up, or where the ends
     * of a bar meet that is bent to a ring.
     */
    static bool are_back_to_back(const SurfacePlace<dim> &place,
                                 const SurfacePlace<dim> &other);

  private:
    /// Of a facet along the direction: its middle [mm] and its normal.
    struct Along
    {
      double middle, normal;
    };

    std::vector<Along> of_slave, of_master;

    /// By facet of the slave, those of the master that it cannot face.
    std::vector<std::set<unsigned int>> around;
  };
} // namespace Contact

#endif
