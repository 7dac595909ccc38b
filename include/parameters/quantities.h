/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_quantities_h
#define contact_quantities_h

#include "parameters/choices.h"

namespace Contact
{
  using namespace dealii;

  namespace Parameters
  {
    /// The quantity of a probe.
    enum class Quantity
    {
      displacement_x,
      displacement_y,
      displacement_z,
      stress_xx,
      stress_yy,
      stress_zz,
      stress_xy,
      stress_xz,
      stress_yz,
      von_mises,
      pressure,
      true_pressure,
      shear,
      reaction_x,
      reaction_y,
      reaction_z,
      support_x,
      support_y,
      support_z,
      reaction_moment_x,
      reaction_moment_y,
      reaction_moment_z,
      rotation_x,
      rotation_y,
      rotation_z,
      contact_force_x,
      contact_force_y,
      contact_force_z,
      obstacle_force_x,
      obstacle_force_y,
      obstacle_force_z,
      obstacle_moment_x,
      obstacle_moment_y,
      obstacle_moment_z,
      obstacle_motion_x,
      obstacle_motion_y,
      obstacle_motion_z,
      obstacle_turn,
      preload,
      shortening,
      strain_energy,
      plastic_strain
    };

    inline NamedValues<Quantity> named_values(const Quantity)
    {
      return {{"displacement x", Quantity::displacement_x},
              {"displacement y", Quantity::displacement_y},
              {"displacement z", Quantity::displacement_z},
              {"stress xx", Quantity::stress_xx},
              {"stress yy", Quantity::stress_yy},
              {"stress zz", Quantity::stress_zz},
              {"stress xy", Quantity::stress_xy},
              {"stress xz", Quantity::stress_xz},
              {"stress yz", Quantity::stress_yz},
              {"von Mises", Quantity::von_mises},
              {"pressure", Quantity::pressure},
              {"true pressure", Quantity::true_pressure},
              {"shear", Quantity::shear},
              {"reaction x", Quantity::reaction_x},
              {"reaction y", Quantity::reaction_y},
              {"reaction z", Quantity::reaction_z},
              {"support x", Quantity::support_x},
              {"support y", Quantity::support_y},
              {"support z", Quantity::support_z},
              {"reaction moment x", Quantity::reaction_moment_x},
              {"reaction moment y", Quantity::reaction_moment_y},
              {"reaction moment z", Quantity::reaction_moment_z},
              {"rotation x", Quantity::rotation_x},
              {"rotation y", Quantity::rotation_y},
              {"rotation z", Quantity::rotation_z},
              {"contact force x", Quantity::contact_force_x},
              {"contact force y", Quantity::contact_force_y},
              {"contact force z", Quantity::contact_force_z},
              {"obstacle force x", Quantity::obstacle_force_x},
              {"obstacle force y", Quantity::obstacle_force_y},
              {"obstacle force z", Quantity::obstacle_force_z},
              {"obstacle moment x", Quantity::obstacle_moment_x},
              {"obstacle moment y", Quantity::obstacle_moment_y},
              {"obstacle moment z", Quantity::obstacle_moment_z},
              {"obstacle motion x", Quantity::obstacle_motion_x},
              {"obstacle motion y", Quantity::obstacle_motion_y},
              {"obstacle motion z", Quantity::obstacle_motion_z},
              {"obstacle turn", Quantity::obstacle_turn},
              {"preload", Quantity::preload},
              {"shortening", Quantity::shortening},
              {"strain energy", Quantity::strain_energy},
              {"plastic strain", Quantity::plastic_strain}};
    }

    /// The direction of a displacement or a force: 0 for x, and 0 for what has
    /// none.
    inline unsigned int component_of(const Quantity quantity)
    {
      switch (quantity)
        {
          case Quantity::displacement_y:
          case Quantity::reaction_y:
          case Quantity::support_y:
          case Quantity::contact_force_y:
          case Quantity::obstacle_force_y:
          case Quantity::obstacle_motion_y:
            return 1;
          case Quantity::displacement_z:
          case Quantity::reaction_z:
          case Quantity::support_z:
          case Quantity::contact_force_z:
          case Quantity::obstacle_force_z:
          case Quantity::obstacle_motion_z:
            return 2;
          default:
            return 0;
        }
    }

    /// Whether a quantity is there in 3-D alone.
    inline bool is_in_space(const Quantity quantity)
    {
      return component_of(quantity) == 2 || quantity == Quantity::stress_xz ||
             quantity == Quantity::stress_yz ||
             quantity == Quantity::obstacle_moment_x ||
             quantity == Quantity::obstacle_moment_y ||
             quantity == Quantity::reaction_moment_x ||
             quantity == Quantity::reaction_moment_y ||
             quantity == Quantity::rotation_x ||
             quantity == Quantity::rotation_y;
    }

    /// The unit of a quantity.
    inline std::string unit_of(const Quantity quantity,
                               const Symmetry symmetry,
                               const bool     in_space = false)
    {
      switch (quantity)
        {
          case Quantity::displacement_x:
          case Quantity::displacement_y:
          case Quantity::displacement_z:
          case Quantity::obstacle_motion_x:
          case Quantity::obstacle_motion_y:
          case Quantity::obstacle_motion_z:
          case Quantity::shortening:
            return "mm";
          case Quantity::obstacle_turn:
            return "degrees";
          case Quantity::stress_xx:
          case Quantity::stress_yy:
          case Quantity::stress_zz:
          case Quantity::stress_xy:
          case Quantity::stress_xz:
          case Quantity::stress_yz:
          case Quantity::von_mises:
          case Quantity::pressure:
          case Quantity::true_pressure:
          case Quantity::shear:
            return "MPa";
          case Quantity::reaction_x:
          case Quantity::reaction_y:
          case Quantity::reaction_z:
          case Quantity::support_x:
          case Quantity::support_y:
          case Quantity::support_z:
          case Quantity::contact_force_x:
          case Quantity::contact_force_y:
          case Quantity::contact_force_z:
          case Quantity::obstacle_force_x:
          case Quantity::obstacle_force_y:
          case Quantity::obstacle_force_z:
          case Quantity::preload:
            return symmetry != Symmetry::axisymmetric && !in_space ? "N/mm"
                                                                   : "N";
          case Quantity::plastic_strain:
            return "-";
          case Quantity::rotation_x:
          case Quantity::rotation_y:
          case Quantity::rotation_z:
            return "rad";
          case Quantity::reaction_moment_x:
          case Quantity::reaction_moment_y:
          case Quantity::reaction_moment_z:
          case Quantity::obstacle_moment_x:
          case Quantity::obstacle_moment_y:
          case Quantity::obstacle_moment_z:
          case Quantity::strain_energy:
            return symmetry != Symmetry::axisymmetric && !in_space ? "N mm/mm"
                                                                   : "N mm";
        }
      AssertThrow(false, ExcInternalError());
      return "";
    }
  } // namespace Parameters
} // namespace Contact

#endif
