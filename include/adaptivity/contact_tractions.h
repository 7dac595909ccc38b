/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_tractions_h
#define contact_contact_tractions_h

#include <map>
#include <optional>

#include "contact/interface/contact_interface.h"
#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /// A place on a facet, and how it moves with the coordinates of the facet.
  template<int dim>
  struct FacetPlace
  {
    FacetPlace(const Surface<dim>      &surface,
               const SurfaceFacet<dim> &facet,
               const FacetPoint<dim>   &xi,
               const GhostedVector     &u);

    /// Deformed by undeformed area.
    double stretch() const
    {
      return area.norm() / undeformed_area.norm();
    }

    const FacetShape<dim>               shape;
    Point<dim>                          x; // deformed
    std::array<Tensor<1, dim>, dim - 1> along;

    /// Outward normals, as long as the area by unit of coordinates.
    Tensor<1, dim> area, undeformed_area;
  };



  /// Whether a node of a facet is tied.
  template<int dim>
  bool is_tied(const Discretization<dim> &discretization,
               const Surface<dim>        &surface,
               const SurfaceFacet<dim>   &facet);



  /**
   * The tractions of contact on the facets of its surfaces, on the body that a
   * facet belongs to. On the slave the traction is p n + q t, on the master the
   * opposite, n the outward normal of the master and t its tangents
   * (contact_points.h).
   */
  template<int dim>
  class ContactTractions
  {
  public:
    ContactTractions(const Discretization<dim>   &discretization,
                     const ContactInterface<dim> &interface,
                     const ContactPair<dim>      &contact_pair,
                     const GhostedVector         &solution);

    /**
     * The traction at a place of the facet @p name by undeformed area [MPa];
     * zero where nothing faces the facet within its size @p reach, no value
     * where a tie carries what the multipliers do not know.
     */
    std::optional<Tensor<1, dim>> operator()(const FacetName<dim>  &name,
                                             const FacetPlace<dim> &place,
                                             const double reach) const;

  private:
    /// The values at the nodes that in_frame() knows.
    void find_values(const ContactInterface<dim> &interface);

    Tensor<1, dim> interpolate(const unsigned int     facet,
                               const FacetPlace<dim> &place) const;

    std::optional<Tensor<1, dim>>
    of_facing_slave(const unsigned int     master_facet,
                    const FacetPlace<dim> &place,
                    const double           reach) const;

    const Discretization<dim>             &discretization;
    const ContactPair<dim>                &contact_pair;
    const Surface<dim>                    &slave;
    const GhostedVector                   &solution;
    const DeformedSurface<dim>             slave_now;
    std::map<FacetName<dim>, unsigned int> slave_facets, master_facets;

    /// In 2-D (p, q), in 3-D the traction on the slave.
    std::vector<Tensor<1, dim>> at_nodes;
  };
} // namespace Contact

#endif
