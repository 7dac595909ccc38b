/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/stress_peaks.h"

#include <algorithm>

#include "solid/stress_recovery.h"

namespace Contact
{
  template<int dim>
  void StressPeaks<dim>::take(const ContactModel<dim>  &model,
                              const Parameters::Solids &parameters,
                              const GhostedVector      &u)
  {
    for (const auto &[name, yield_stress] : parameters.yield_stress)
      {
        if (parameters.model_of(name) != Parameters::MaterialModel::elastic)
          continue;
        const auto    id = model.mesh->body(name, "Solids/Yield stress");
        BodyStresses &body =
          bodies.try_emplace(name, BodyStresses{yield_stress, {}})
            .first->second;
        std::size_t k = 0;
        for (const CellTable<dim> &cell : model.elasticity->cells())
          {
            if (cell.body != id)
              continue;
            const auto stresses =
              cell.kernel->stresses(cell, u.extract(cell.dofs));
            for (unsigned int q = 0; q < stresses.size(); ++q, ++k)
              {
                if (k == body.points.size())
                  body.points.push_back({cell.JxW[q]});
                PointStress &point = body.points[k];
                point.last         = von_mises(stresses[q]);
                point.largest      = std::max(point.largest, point.last);
              }
          }
      }
  }



  template<int dim>
  bool StressPeaks<dim>::is_elastic(const std::string &body) const
  {
    const auto found = bodies.find(body);
    return found != bodies.end() &&
           std::all_of(found->second.points.begin(),
                       found->second.points.end(),
                       [&](const PointStress &point) {
                         return point.largest <= found->second.yield_stress;
                       });
  }



  template<int dim>
  double StressPeaks<dim>::share_gone(const std::string &body) const
  {
    const auto found = bodies.find(body);
    if (found == bodies.end())
      return 0;
    const double Y    = found->second.yield_stress;
    double       gone = 0, all = 0;
    for (const PointStress &point : found->second.points)
      {
        const double largest = std::max(point.largest, Y);
        gone += point.volume * (largest - std::max(point.last, Y));
        all += point.volume * (largest - Y);
      }
    return all > 0 ? gone / all : 0.;
  }

  template class StressPeaks<2>;
  template class StressPeaks<3>;
} // namespace Contact
