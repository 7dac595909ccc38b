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

    /// Why there is no such scene, or nothing.
    std::string unknown = {};
  };



  /**
   * All that the entries of a scene allow: large displacement, contact on the
   * deformed bodies, friction, glue instead of contact, each contact pair, its
   * interference and the motion of its obstacle, each load, each prescribed
   * displacement and each thermal strain on or off; the plasticity of bodies
   * with a yield stress, rubber and incompatible modes instead of the elastic
   * material and its cells; each Young's modulus 1 % larger. Friction that is
   * not there is tried with the coefficient 0.1.
   */
  std::vector<SceneVariant> scene_variants(const Parameters::All &scene);

  /// The probes that a scene without contact has.
  Parameters::Probes without_tractions(const Parameters::Probes &probes);

  /// The scene with other cells and steps: quadratic elements instead of linear
  /// ones, and twice the increments.
  SceneVariant quadratic_elements(const Parameters::All &scene);
  SceneVariant doubled_increments(const Parameters::All &scene);
} // namespace Contact

#endif
