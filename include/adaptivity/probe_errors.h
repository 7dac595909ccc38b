/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_probe_errors_h
#define contact_probe_errors_h

#include <map>
#include <set>
#include <string>

namespace Contact
{
  /// The errors of the probes on a mesh, with sign, in the units of the probes:
  /// what is to be added for the true value.
  struct ProbeErrors
  {
    /// Of the discretization, by probe.
    std::map<std::string, double> mesh;

    /// What each loop has left, by probe and loop.
    std::map<std::string, std::map<std::string, double>> loops;

    /// Probes at corners in contact, see is_at_corner(): there stresses are
    /// singular, and an estimate sees the part of the error that one more level
    /// takes away.
    std::set<std::string> at_corners;

    /// Tractions in a zone of contact of fewer than four facets: as far as
    /// meshes do not resolve its width, they grow from mesh to mesh, by equal
    /// steps.
    std::set<std::string> unresolved;

    /// Why there are none though a run estimates them, or nothing.
    std::string not_estimated;
  };
} // namespace Contact

#endif
