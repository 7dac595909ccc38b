/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_free_motions_h
#define contact_free_motions_h

#include <string>
#include <vector>

#include "contact_interface.h"
#include "discretization.h"

namespace Contact
{
  using namespace dealii;

  /// A rigid motion of a body that nothing resists.
  struct FreeMotion
  {
    types::material_id body;
    std::string        name; // as in "displacement in x with rotation"
  };



  /**
   * Of every body that something could move without resistance, one such rigid
   * motion: supports and ties hold it, and, unless @p interface is null, its
   * points in contact along their normals and, with @p friction, where they
   * stick along their tangents as well. Each resisted direction is a row over the three rigid
   * motions of the body; what is free is in the null space of the sum of the
   * rows' squares.
   */
  std::vector<FreeMotion> free_motions(const Discretization   &discretization,
                                       const ContactInterface *interface,
                                       const bool friction = true);

  /**
   * Check that every body is held, or can come to be: by supports, or by
   * contact if it has a surface that may touch another body. Throws InputError
   * with the name of the body and a motion that is free.
   */
  void check_supports(const Discretization   &discretization,
                      const ContactInterface *interface);
} // namespace Contact

#endif
