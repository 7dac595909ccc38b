/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_stress_peaks_h
#define contact_stress_peaks_h

#include <map>
#include <string>
#include <vector>

#include "model/contact_model.h"

namespace Contact
{
  using namespace dealii;

  /// Von Mises' stresses [MPa] of elastic bodies that have a yield stress, at
  /// the ends of the increments on a mesh: whether points that would have
  /// yielded were unloaded later. Of the cells of this process.
  template<int dim>
  class StressPeaks
  {
  public:
    /// An increment ends with the displacements @p u.
    void take(const ContactModel<dim>  &model,
              const Parameters::Solids &parameters,
              const GhostedVector      &u);

    /// Whether a body has been nowhere above its yield stress.
    bool is_elastic(const std::string &body) const;

    /**
     * The stress s above the yield stress Y of a body that has been there, but
     * is no longer [-], 0 if there has been none:
     *   integral max(max_t s, Y) - max(s, Y) dX / integral max(max_t s, Y) - Y
     *   dX.
     */
    double share_gone(const std::string &body) const;

  private:
    struct PointStress
    {
      double volume;
      double last    = 0;
      double largest = 0;
    };
    struct BodyStresses
    {
      double                   yield_stress;
      std::vector<PointStress> points;
    };
    std::map<std::string, BodyStresses> bodies;
  };
} // namespace Contact

#endif
