/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_support_check_h
#define contact_support_check_h

#include "contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Whether every body is held. The two translations and the rotation of a
   * body are looked at by what holds them: supports, ties, and the points that
   * are in contact at the start, the partner taken as held. The 3x3 matrix
   *   sum over what holds of (value of the modes)^T (value of the modes)
   * is regular for a body that is held; its kernel is the free motion. Throws
   * InputError that names the body and the motion.
   */
  void check_supports(const Discretization   &discretization,
                      const ContactInterface *interface);
} // namespace Contact

#endif
