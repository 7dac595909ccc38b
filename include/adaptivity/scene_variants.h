/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_scene_variants_h
#define contact_scene_variants_h

#include <string>
#include <vector>

#include "parameters/parameters.h"

namespace Contact
{
  /// The same scene but for one effect, on the same mesh with the same
  /// elements.
  struct SceneVariant
  {
    std::string effect;
    bool        is_on; // in the scene itself; here it is the other way round

    /// The entries that make this variant of the scene, as the command line
    /// takes them: "Section/Entry=value".
    std::vector<std::string> entries;

    Parameters::All parameters;
  };



  /**
   * All that the entries of a scene allow: large displacement, contact on the
   * deformed bodies, friction, glue instead of contact, each contact pair, each
   * load and each prescribed displacement on or off; each Young's modulus 1 %
   * larger. Friction that is not there is tried with the coefficient 0.1.
   */
  std::vector<SceneVariant> scene_variants(const Parameters::All &scene);
} // namespace Contact

#endif
