/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_effect_runs_h
#define contact_effect_runs_h

#include "output/application.h"

namespace Contact
{
  /**
   * The effects of a scene in 3-D, by a run of each of its variants. On nested
   * meshes that ends on the one before the last, at an eighth of the unknowns:
   * an effect is a difference of two values with nearly the same error of the
   * mesh. Its uncertainty is twice how far it is from that on the mesh before,
   * its share of what the probe changes by to the last mesh, and what the
   * tolerances leave of both values. The whole way is computed, so
   * friction and plastic strains have the history that the variant gives them.
   *
   * The @p summary of the scene gets the estimates; each run leaves no files.
   */
  void estimate_effects_by_runs(const Parameters::All  &scene,
                                const ParameterHandler &prm,
                                const SolveCase        &solve,
                                RunSummary             &summary);
} // namespace Contact

#endif
