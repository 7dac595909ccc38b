/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_entry_checks_h
#define contact_entry_checks_h

#include <deal.II/base/utilities.h>

#include <map>
#include <string>
#include <vector>

#include "base/string_utilities.h"
#include "parameters/parameters_scene.h"

namespace Contact
{
  // Patterns know closed intervals only, and a tolerance of zero is never
  // reached.
  inline void check_positive(const double value, const std::string &entry)
  {
    if (!(value > 0))
      throw EntryError(entry + " is " + Utilities::to_string(value) +
                         ", but has to be positive.",
                       {entry},
                       "set a value greater than 0");
  }



  // The keys of one map have to be keys of another one as well. Of two that
  // nearly agree nobody knows here which one is misspelt.
  template<typename A, typename B>
  void check_keys(const std::map<std::string, A> &map,
                  const std::string              &entry,
                  const std::map<std::string, B> &other,
                  const std::string              &other_entry)
  {
    for (const auto &[key, value] : map)
      if (other.count(key) == 0)
        {
          std::vector<std::string> unpaired;
          for (const auto &there : other)
            if (map.count(there.first) == 0)
              unpaired.push_back(there.first);
          const std::size_t i = nearest(key, unpaired);
          throw EntryError(in_quotes(key) + " is in " + entry +
                             ", but not in " + other_entry + ".",
                           {entry, other_entry},
                           i < unpaired.size()
                             ? other_entry + " has " + in_quotes(unpaired[i]) +
                                 ": write the name of the mesh in both"
                             : "add " + in_quotes(key) + " to " + other_entry +
                                 " or remove it from " + entry);
        }
  }
} // namespace Contact

#endif
