/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_results_h
#define contact_contact_results_h

#include <map>
#include <string>
#include <vector>

#include "base/dimension.h"
#include "contact/interface/contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /// The contact zone in a few numbers.
  struct ContactResults
  {
    /// On the slave: sum over the points of w p and of w q, along the normals
    /// and the tangents of the master [N per mm of thickness]; in 3-D the
    /// magnitude of the sum of the vectors w q [N].
    double normal_force     = 0;
    double tangential_force = 0;

    /// The largest p and |q| of the points [MPa].
    double max_pressure = 0;
    double max_shear    = 0;

    /// The lengths of all patches of contact, and of sticking, by the
    /// undeformed arc length of the slave [mm]: see ContactPatches. In 3-D
    /// the areas that the points in contact, and those that stick, stand for
    /// [mm^2].
    double extent       = 0;
    double stick_extent = 0;

    /// That of contact on the deformed slave.
    double deformed_extent = 0;

    /// With widths in 2-D, with areas in 3-D.
    template<int dim>
    std::map<std::string, double> by_name() const
    {
      const std::string name = Dimension<dim>::extent;
      return {{"normal_force", normal_force},
              {"tangential_force", tangential_force},
              {"max_pressure", max_pressure},
              {"max_shear", max_shear},
              {name, extent},
              {"deformed_" + name, deformed_extent},
              {"stick_" + name, stick_extent}};
    }
  };

  /// @p u_start is the solution at the start of the increment.
  template<int dim>
  ContactResults contact_results(const ContactInterface<dim> &interface,
                                 const ContactPair<dim>      &contact_pair,
                                 const GhostedVector         &solution,
                                 const GhostedVector         &u_start);

  /// The forces of contact on the nodes by displacement unknown, w (p n + q t)
  /// C summed over the points [N per mm of thickness; rings: N]. The vector is
  /// as long as @p u_start.
  template<int dim>
  GhostedVector contact_forces(const ContactInterface<dim> &interface,
                               const GhostedVector         &solution,
                               const GhostedVector         &u_start);

  /// The multiplier that is the pressure at a node of the slave, or
  /// numbers::invalid_unsigned_int.
  template<int dim>
  unsigned int multiplier_at(const ContactInterface<dim> &interface,
                             const ContactPair<dim>      &contact_pair,
                             const unsigned int           node);

  /// The pressure there [MPa]; zero where there is none.
  template<int dim>
  double pressure_at(const ContactInterface<dim> &interface,
                     const ContactPair<dim>      &contact_pair,
                     const unsigned int           node,
                     const GhostedVector         &solution);

  /**
   * The load of the points at corners of the master on the nodes of the slave:
   * the force along normal and tangent of the node's own point by the integral
   * of the node's shape function, over which it is spread, to be added to
   * pressure and shear (p, q) of that point [MPa]; in 3-D the pressure alone.
   * By slave node; empty if there are no such points.
   */
  template<int dim>
  std::vector<Tensor<1, 2>>
  corner_tractions(const ContactInterface<dim> &interface,
                   const ContactPair<dim>      &contact_pair,
                   const GhostedVector         &solution);

  /// The points that have changed their status since @p statuses, where, from
  /// what to what: a line each, at most ten.
  template<int dim>
  std::string describe_changes(const ContactInterface<dim>         &interface,
                               const std::vector<PointStatus<dim>> &statuses,
                               const GhostedVector                 &solution,
                               const GhostedVector                 &u_start);

  /// Whether a node is where a surface has a corner, or ends, and touches:
  /// there stresses are singular. The end at a line of symmetry is none where
  /// the surface and its mirror image have none, see
  /// Surface::sine_of_smooth_slant().
  bool is_at_corner(const ContactInterface<2> &interface,
                    const NodeDoFs<2>         &node);
} // namespace Contact

#endif
