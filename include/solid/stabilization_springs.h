/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_stabilization_springs_h
#define contact_stabilization_springs_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>
#include <vector>

#include "solid/cell_tables.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Springs that hold a piece of a body (MeshPieces) for a while, before it
   * touches another one, at the corners of its cells, to x and to y, from where
   * these were under the displacement "rest".
   */
  class StabilizationSprings
  {
  public:
    /// Of the pieces that the cells @p cells of all ranks make up. Holds
    /// nothing yet. Collective.
    StabilizationSprings(const Discretization         &discretization,
                         const std::vector<CellTable> &cells);

    /**
     * Hold pieces, by piece with a stiffness k [N/mm per mm of thickness;
     * rings: N/mm]: under a rigid translation d away from @p rest the springs
     * of the piece exert k d together. Each cell gives its corners equal shares
     * of its part of the volume of the piece. A piece that is not named, or
     * with k = 0, is not held. Replaces what held before. Not collective, but
     * has to be the same on all ranks.
     */
    void hold(const std::map<unsigned int, double> &stiffness,
              const Vector<double>                 &rest);

    /// Hold nothing any longer.
    void release();

    /// The pieces that are held, and their stiffness k.
    const std::map<unsigned int, double> &held() const
    {
      return stiffness;
    }

    /// Grows whenever pieces are held, released, or held with another
    /// stiffness.
    unsigned int version() const
    {
      return n_changes;
    }

    /// Add the forces of the springs of a cell under the displacement @p u and,
    /// unless @p tangent is null, their stiffness.
    void add_springs(const CellTable      &cell,
                     const Vector<double> &u,
                     FullMatrix<double>   *tangent,
                     Vector<double>       &forces) const;

    /**
     * The energy of the springs of each held piece, 1/2 k |u - rest|^2 in total
     * if it is translated [N mm per mm of thickness]. Collective.
     */
    std::map<unsigned int, double> energy(const Vector<double> &u) const;

    /// The volume of a piece by its area in the plane [-]; rings: [mm].
    double mean_circumference(const unsigned int piece) const;

  private:
    /// The stiffness of each corner of a cell, as k.
    double spring(const CellTable &cell) const;

    const Discretization          &discretization;
    const std::vector<CellTable>  &cells;
    std::vector<double>            areas, volumes; // by piece, of all ranks
    std::map<unsigned int, double> stiffness;
    Vector<double>                 rest;
    unsigned int                   n_changes = 0;
  };
} // namespace Contact

#endif
