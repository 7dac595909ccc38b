/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/groups.h"

namespace Contact
{
  using namespace dealii;

  void
  unite_groups(const std::map<std::string, std::vector<std::string>> &made_of,
               std::map<std::string, std::set<types::boundary_id>> &boundaries,
               std::set<std::string> &with_inner_faces)
  {
    const std::string entry = "Mesh/Groups";
    for (const auto &[name, parts] : made_of)
      {
        std::set<types::boundary_id> all;
        for (const std::string &part : parts)
          {
            const auto &ids = find_group(boundaries, "boundary", part, entry);
            all.insert(ids.begin(), ids.end());
            if (with_inner_faces.count(part) > 0)
              with_inner_faces.insert(name);
          }
        if (!boundaries.emplace(name, all).second)
          throw InputError("the mesh has a group '" + name + "' of its own",
                           "entry '" + entry + "'",
                           "choose another name");
      }
  }
} // namespace Contact
