/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_obstacle_forces_h
#define contact_obstacle_forces_h

#include <array>
#include <map>
#include <string>

#include "contact/interface/contact_interface.h"
#include "parameters/dual_quantities.h"

namespace Contact
{
  using namespace dealii;

  /// The load of an obstacle on the slave: the forces [N per mm of thickness],
  /// and their moment about its centre, as they leave the obstacle; and what
  /// moment they have in addition at the slave, where an interference keeps the
  /// two apart.
  template<int dim>
  struct ObstacleForce
  {
    Tensor<1, dim> force;
    Moment<dim>    moment, over_gap;

    void add(const Tensor<1, dim> &arm,
             const Tensor<1, dim> &gap,
             const Tensor<1, dim> &f)
    {
      force += f;
      moment += moment_of(arm, f);
      over_gap += moment_of(gap, f);
    }

    /// Their work in a motion of the obstacle.
    double work(const typename Obstacle<dim>::Motion &motion) const
    {
      return force * motion.shift + moment * motion.rotation;
    }

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &force &moment &over_gap;
    }
  };

  /// Of the pressures and of the shears of a contact pair with an obstacle, at
  /// the material of the obstacle.
  template<int dim>
  std::array<ObstacleForce<dim>, 2>
  obstacle_forces(const ContactInterface<dim> &interface,
                  const ContactPair<dim>      &contact_pair,
                  const GhostedVector         &solution,
                  const GhostedVector         &u_start);

  /// Of both together, by names: "obstacle_force_x", in 2-D
  /// "obstacle_moment_z"; of one that can move "obstacle_motion_x" and
  /// "obstacle_turn" [mm, degrees]. Of rings those along the axis alone. Of a
  /// cut "preload" and "shortening".
  template<int dim>
  std::map<std::string, double>
  obstacle_values(const ContactInterface<dim> &interface,
                  const ContactPair<dim>      &contact_pair,
                  const GhostedVector         &solution,
                  const GhostedVector         &u_start);

  /// That of the contact pair whose section is @p section [N per mm of
  /// thickness, N].
  template<int dim>
  double obstacle_value(const Parameters::Quantity   quantity,
                        const std::string           &section,
                        const ContactInterface<dim> *interface,
                        const GhostedVector         &solution,
                        const GhostedVector         &u_start);

  /// Check that a section has an obstacle that exerts it. Throws InputError
  /// with the name of the @p probe.
  template<int dim>
  void check_obstacle(const std::string           &probe,
                      const Parameters::Quantity   quantity,
                      const std::string           &section,
                      const ContactInterface<dim> *interface);
} // namespace Contact

#endif
