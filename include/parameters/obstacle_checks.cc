/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Checks of obstacles.

#include <algorithm>
#include <set>
#include <string>

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
      const auto                &shape        = obstacle.begin()->first;
      const std::vector<double> &numbers      = obstacle.begin()->second;
      bool                       is_complete  = false;
      const auto                 is_direction = [&](const unsigned int first) {
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
                         "radius; in 3-D 'half space: x, y, z, normal x, "
                         "normal y, normal z', 'sphere: x, y, z, radius' or "
                         "'cylinder: x, y, z, axis x, axis y, axis z, "
                         "radius'; or 'profile: x, y, radius, x, y, radius, "
                         "...'");
    }



    // A MovingObstacle knows what there is in 2-D and in 3-D.
    void Contact::check_obstacle_motion() const
    {
      const std::string entry = section() + "/Obstacle motion";
      for (const auto &[name, history] : obstacle_motion)
        {
          if (name != "x" && name != "y" && name != "z" && name != "angle")
            throw EntryError(in_quotes(name) + " is no motion.",
                             {entry},
                             "there are 'x', 'y', 'angle' and in 3-D 'z'");
          check_history(history, entry);
        }
      if (tied && !obstacle_motion.empty())
        throw EntryError("A body is glued to an obstacle that moves.",
                         {entry, section() + "/Tied"},
                         "move supports of the body instead");
    }



    // A motion is given, or what it exerts.
    void Contact::check_obstacle_force() const
    {
      const std::string force  = section() + "/Obstacle force",
                        moment = section() + "/Obstacle moment";
      const auto check         = [&](const std::string &motion,
                             const std::string &history,
                             const std::string &entry) {
        check_history(history, entry);
        if (obstacle.empty())
          throw EntryError("There is no obstacle to exert it.",
                           {entry, section() + "/Obstacle"},
                           "set the obstacle, or load the master");
        if (obstacle_motion.count(motion) > 0)
          throw EntryError("The motion " + in_quotes(motion) +
                             " of the obstacle is given, and what it exerts.",
                           {entry, section() + "/Obstacle motion"},
                           "leave one of the two");
        if (tied)
          throw EntryError("A body is glued to an obstacle that moves.",
                           {entry, section() + "/Tied"},
                           "load the body instead");
      };
      for (const auto &[axis, history] : obstacle_force)
        if (std::set<std::string>{"x", "y", "z"}.count(axis) == 0)
          throw EntryError(in_quotes(axis) + " is no force.",
                           {force},
                           "there are 'x', 'y' and in 3-D 'z'; the moment "
                           "has the entry " +
                             in_quotes(moment));
        else
          check(axis, history, force);
      if (!obstacle_moment.empty())
        check("angle", obstacle_moment, moment);
    }



    void Contact::check_preload() const
    {
      const std::string entry = section() + "/Preload";
      if (preload.empty())
        {
          if (preload_end < 1)
            throw EntryError("There is no preload that could end.",
                             {entry + " end", entry},
                             "set the preload, or remove its end");
          return;
        }
      check_history(preload, entry);
      if (preload_end == 0)
        throw EntryError("The preload would end before it acts.",
                         {entry + " end", entry},
                         "let it end at a load factor greater than 0, or "
                         "remove the preload");
      if (!tied || master.empty())
        throw EntryError("There is no cut with a preload.",
                         {entry, section() + "/Tied"},
                         "set slave and master, the two sides of the cut, and "
                         "'Tied = true'");
    }



    // Rings have no other rigid motion than that along their axis.
    void All::check_obstacles() const
    {
      for (const Contact &contact_pair : pairs())
        if (solids.symmetry == Symmetry::axisymmetric &&
            (contact_pair.obstacle_motion.size() +
                 contact_pair.obstacle_force.size() >
               contact_pair.obstacle_motion.count("y") +
                 contact_pair.obstacle_force.count("y") ||
             !contact_pair.obstacle_moment.empty()))
          throw EntryError("An obstacle about the axis of rings moves along it "
                           "alone.",
                           {contact_pair.section() + "/Obstacle motion",
                            contact_pair.section() + "/Obstacle force",
                            "Solids/Symmetry"},
                           "leave 'y' only");
    }
  } // namespace Parameters
} // namespace Contact
