/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_automatic_pairs_h
#define contact_automatic_pairs_h

#include "mesh/msh_file.h"
#include "parameters/parameters.h"

namespace Contact
{
  /// Read the mesh file, and name its boundaries by place. If it has to have
  /// outer surfaces each body NAME has the group "NAME surface" of all faces
  /// that bound it; those between bodies that share their nodes bound none.
  /// Throws InputError if there is such a group.
  MshFile read_with_surfaces(const Parameters::Mesh &parameters);

  /**
   * In place of a section with "Surfaces = automatic" a contact pair for each
   * two bodies, between all of their outer faces, with the entries of the
   * section: for those that no other section pairs, and that have no node in
   * common. The slave is the softer body, of two that are equally stiff the one
   * with the smaller faces. "With self-contact" each body has one with itself.
   * Reads the mesh file; throws InputError.
   */
  void add_automatic_pairs(Parameters::All &parameters);
} // namespace Contact

#endif
