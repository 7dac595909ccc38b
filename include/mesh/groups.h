/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_groups_h
#define contact_groups_h

#include <deal.II/base/types.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/errors.h"

namespace Contact
{
  /// The group of this name, or an InputError with the names there are. @p
  /// entry is the entry of the parameters that names the group.
  template<typename T>
  const T &find_group(const std::map<std::string, T> &groups,
                      const char                     *kind,
                      const std::string              &name,
                      const std::string              &entry)
  {
    if (groups.count(name) > 0)
      return groups.at(name);

    std::string names;
    for (const auto &group : groups)
      names += (names.empty() ? "'" : ", '") + group.first + "'";
    throw InputError(std::string("the mesh has no ") + kind + " '" + name + "'",
                     "entry '" + entry + "'",
                     "of this kind it has: " +
                       (names.empty() ? "none" : names));
  }



  /// Add the boundary groups that the user makes of others, by name. @p
  /// with_inner_faces are those that bound bodies in part only.
  void unite_groups(
    const std::map<std::string, std::vector<std::string>>       &made_of,
    std::map<std::string, std::set<dealii::types::boundary_id>> &boundaries,
    std::set<std::string> &with_inner_faces);
} // namespace Contact

#endif
