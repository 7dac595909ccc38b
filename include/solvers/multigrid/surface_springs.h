/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_springs_h
#define contact_surface_springs_h

#include <algorithm>
#include <cmath>
#include <vector>

#include "solvers/multigrid/surface_values.h"

namespace Contact
{
  using namespace dealii;

  /// A spring between unknowns of the surfaces: of the energy k/2 (b . u)^2.
  struct SurfaceSpring
  {
    using Way = std::vector<std::pair<types::global_dof_index, double>>;

    double stiffness; // k
    Way    way;       // b
  };



  /**
   * Springs between the surfaces of contact on a level of a multigrid. Each is
   * of one rank, whoever owns its unknowns. Functions are collective.
   */
  template<typename Number>
  class SurfaceSprings
  {
  public:
    using Dof    = types::global_dof_index;
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    /// Those of this rank, in vectors whose unknowns @p owned are its own.
    void initialize(const std::vector<SurfaceSpring> &springs,
                    const IndexSet                   &owned,
                    const MPI_Comm                    communicator)
    {
      this->springs = springs;
      IndexSet         used(owned.size());
      std::vector<Dof> dofs;
      for (const auto &spring : springs)
        for (const auto &entry : spring.way)
          dofs.push_back(entry.first);
      std::sort(dofs.begin(), dofs.end());
      used.add_indices(dofs.begin(), dofs.end());
      exist =
        Utilities::MPI::max<unsigned int>(springs.size(), communicator) > 0;
      if (!exist)
        return;
      source.initialize(used, owned, communicator);
      target.initialize(used, owned, communicator);
    }

    /// Whether there are any, on whatever rank.
    bool are_any() const
    {
      return exist;
    }

    const std::vector<SurfaceSpring> &list() const
    {
      return springs;
    }

    /// Add the forces under the displacements @p u.
    void add_forces(Vector &forces, const Vector &u) const
    {
      if (!exist)
        return;
      source.read(u);
      target.clear();
      for (const auto &[stiffness, way] : springs)
        {
          double length = 0;
          for (const auto &[dof, factor] : way)
            length += factor * source(u, dof);
          for (const auto &[dof, factor] : way)
            target.add(forces, dof, stiffness * length * factor);
        }
      target.add_to(forces);
    }

    /// Add @p factor times the sums of the absolute values in each row of the
    /// matrix: as a diagonal one they are not smaller than that.
    void add_row_sums(const double factor, Vector &diagonal) const
    {
      if (!exist)
        return;
      target.clear();
      for (const auto &[stiffness, way] : springs)
        {
          double sum = 0;
          for (const auto &entry : way)
            sum += std::abs(entry.second);
          for (const auto &[dof, part] : way)
            target.add(diagonal,
                       dof,
                       factor * stiffness * sum * std::abs(part));
        }
      target.add_to(diagonal);
    }

  private:
    std::vector<SurfaceSpring> springs;
    bool                       exist = false; // on any rank
    SurfaceValues<Number>      source, target;
  };
} // namespace Contact

#endif
