/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_findings_h
#define contact_findings_h

#include <string>
#include <vector>

namespace Contact
{
  /// A sentence on a scene or its result that a user should know, with the
  /// remedy, and the case and load factor, or file and line, that it is about.
  /// A note leaves the result valid, a violated invariant does not.
  struct Finding
  {
    std::string  text;
    bool         is_violated = false;
    std::string  where       = {};
    unsigned int level       = 0; // of refinement

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &text &is_violated &where &level;
    }
  };

  using Findings = std::vector<Finding>;

  /// The line of a finding, with its place and kind.
  std::string line_of(const Finding &finding);

  /// Print a finding on the standard error, on the first process, and add it to
  /// those that were @p told; no empty one, and no note that differs from one
  /// of them in its numbers alone.
  void tell(const Finding &finding, Findings &told);
} // namespace Contact

#endif
