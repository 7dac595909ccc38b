/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_notes_h
#define contact_notes_h

#include "base/findings.h"
#include "model/contact_model.h"
#include "output/summary.h"

namespace Contact
{
  using namespace dealii;

  /// Likely mistakes in a scene: histories that turn back inside an
  /// increment, surfaces that face nothing, stiff slaves, polygons of circles,
  /// glue across a gap.
  template<int dim>
  Findings notes_on_scene(const ContactModel<dim> &model,
                          const Parameters::All   &parameters);

  /// Whether bodies in small strain are beyond its range, by the edges of their
  /// cells; strains within cells are larger. A sentence, or nothing. Units that
  /// do not fit together show as thousands of per cent. Collective.
  template<int dim>
  std::string beyond_small_strain(const ContactModel<dim> &model,
                                  const GhostedVector     &solution);

  /// Likely mistakes in a result: that nothing is loaded or nothing
  /// touches, that strains are large, or that round boundaries are off their
  /// circle by as much as matters; and that another element would be solved
  /// faster.
  template<int dim>
  Findings notes_on_result(const ContactModel<dim> &model,
                           const Parameters::All   &parameters,
                           const GhostedVector     &solution,
                           const RunSummary        &summary);
} // namespace Contact

#endif
