/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_coarser_level_h
#define contact_coarser_level_h

#include <vector>

#include "contact/interface/surface_transfer.h"
#include "model/contact_model.h"

namespace Contact
{
  using namespace dealii;

  /// The end of each increment on one mesh, where those on the next one start.
  template<int dim>
  struct CoarserLevel
  {
    std::vector<GhostedVector> solutions;  // transferred to the next mesh
    Vector<float>              indicators; // by cell, see GoalErrors

    /// An increment ends with @p solution.
    void add(const ContactModel<dim> &model, const GhostedVector &solution)
    {
      solutions.push_back(solution);
      if (!model.interface)
        return;
      surfaces.push_back(save_surfaces(*model.interface, solution));
      motions.push_back(model.interface->motions.values(solution));
    }

    /// The displacements of the increment, and motions of obstacles that do not
    /// stay where this mesh has left them.
    void set_start(const ContactModel<dim> &model,
                   const unsigned int       increment,
                   GhostedVector           &solution) const
    {
      const GhostedVector &u = solutions[increment - 1];
      std::copy(u.begin(), u.end(), solution.begin());
      if (model.interface)
        for (unsigned int k = 0; k < model.interface->motions.free.size(); ++k)
          if (!model.interface->motions.free[k]->stays)
            solution[model.interface->motions.index(k)] =
              motions[increment - 1][k];
    }

    /// Statuses, pressures and shears, once the points are paired.
    void set_surfaces(const ContactModel<dim> &model,
                      const unsigned int       increment,
                      GhostedVector           &solution) const
    {
      if (model.interface)
        restore_surfaces(surfaces[increment - 1], *model.interface, solution);
    }

  private:
    std::vector<std::vector<SurfaceState<dim>>> surfaces;
    std::vector<std::vector<double>>            motions;
  };
} // namespace Contact

#endif
