/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_scene_notes_h
#define contact_scene_notes_h

#include <string>
#include <vector>

#include "model/contact_model.h"

namespace Contact
{
  using namespace dealii;

  /// Likely mistakes in a scene: histories that turn back inside an
  /// increment, surfaces that face nothing, stiff slaves, polygons of circles,
  /// glue across a gap.
  template<int dim>
  std::vector<std::string> notes_on_scene(const ContactModel<dim> &model,
                                          const Parameters::All   &parameters);
} // namespace Contact

#endif
