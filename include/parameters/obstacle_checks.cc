/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Checks of obstacles.

#include <algorithm>

#include "base/string_utilities.h"
#include "parameters/parameters.h"

namespace Contact
{
  namespace Parameters
  {
    void Contact::check_obstacle(const std::string &entry) const
    {
      if (obstacle.size() != 1)
        throw EntryError("A contact pair has one obstacle.",
                         {entry},
                         "give each its own section 'Contact NAME'");
      const auto &[shape, numbers] = *obstacle.begin();
      bool       is_complete       = false;
      const auto is_direction      = [&](const unsigned int first) {
        return std::any_of(numbers.begin() + first,
                           numbers.begin() + first + numbers.size() / 2,
                           [](const double x) { return x != 0; });
      };
      switch (shape)
        {
          case ObstacleShape::half_plane:
            is_complete = numbers.size() == 4 && is_direction(2);
            break;
          case ObstacleShape::circle:
            is_complete = numbers.size() == 3 && numbers[2] != 0;
            break;
          case ObstacleShape::half_space:
            is_complete = numbers.size() == 6 && is_direction(3);
            break;
          case ObstacleShape::sphere:
            is_complete = numbers.size() == 4 && numbers[3] != 0;
            break;
          case ObstacleShape::cylinder:
            is_complete =
              numbers.size() == 7 && is_direction(3) && numbers[6] != 0;
            break;
          case ObstacleShape::profile:
            is_complete = numbers.size() >= 6 && numbers.size() % 3 == 0;
            break;
        }
      if (!is_complete)
        throw EntryError("'" + shape.name() +
                           "' is no obstacle with these numbers.",
                         {entry},
                         "write 'half plane: x, y, normal x, normal y' or "
                         "'circle: x, y, radius', in a hole a negative "
                         "radius; in space 'half space: x, y, z, normal x, "
                         "normal y, normal z', 'sphere: x, y, z, radius' or "
                         "'cylinder: x, y, z, axis x, axis y, axis z, "
                         "radius'; or 'profile: x, y, radius, x, y, radius, "
                         "...'");
    }



    // A MovingObstacle knows what there is in the plane and in space.
    void Contact::check_obstacle_motion() const
    {
      const std::string entry = section() + "/Obstacle motion";
      for (const auto &[name, history] : obstacle_motion)
        {
          if (name != "x" && name != "y" && name != "z" && name != "angle")
            throw EntryError(in_quotes(name) + " is no motion.",
                             {entry},
                             "there are 'x', 'y', 'angle' and in space 'z'");
          check_history(history, entry);
        }
      if (tied && !obstacle_motion.empty())
        throw EntryError("A body is glued to an obstacle that moves.",
                         {entry, section() + "/Tied"},
                         "move supports of the body instead");
    }



    // Rings have no other rigid motion than that along their axis.
    void All::check_obstacles() const
    {
      for (const Contact &contact_pair : pairs())
        if (solids.symmetry == Symmetry::axisymmetric &&
            contact_pair.obstacle_motion.size() >
              contact_pair.obstacle_motion.count("y"))
          throw EntryError("An obstacle about the axis of rings moves along it "
                           "alone.",
                           {contact_pair.section() + "/Obstacle motion",
                            "Solids/Symmetry"},
                           "leave 'y' only");
    }
  } // namespace Parameters
} // namespace Contact
