/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_stabilization_springs_h
#define contact_stabilization_springs_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <map>
#include <vector>

#include "base/dimension.h"
#include "solid/cell_tables.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The stiffness of the springs of a piece: k under a translation [N/mm per mm
   * of thickness; rings: N/mm], and kappa in addition under a rotation
   * [N mm per rad and mm of thickness].
   */
  struct SpringStiffness
  {
    SpringStiffness(const double translation = 0, const double rotation = 0)
      : translation(translation)
      , rotation(rotation)
    {
    }

    bool operator==(const SpringStiffness &other) const
    {
      return translation == other.translation && rotation == other.rotation;
    }

    double translation, rotation;
  };



  /**
   * Springs that hold a piece of a body (MeshPieces) for a while, before it
   * touches another one, from where it was under the displacement "rest": at
   * the corners of its cells, in all directions, and in each cell against its
   * mean rotation.
   */
  template<int dim>
  class StabilizationSprings
  {
  public:
    /// Of the pieces that the cells @p cells of all ranks make up. Holds
    /// nothing yet. Collective.
    StabilizationSprings(const Discretization<dim>         &discretization,
                         const std::vector<CellTable<dim>> &cells);

    /**
     * Hold pieces, by piece with a stiffness: under a rigid translation d away
     * from @p rest the springs of the piece exert k d together. Each cell gives
     * its corners equal shares of its part of the volume of the piece. With
     * theta the mean over a cell of (du_y/dx - du_x/dy)/2, in 3-D of curl
     * u/2, less that at rest, its part of the moment is kappa theta. A piece
     * that is not named, or without stiffness, is not held. Replaces what held
     * before. Not collective, but has to be the same on all ranks.
     */
    void hold(const std::map<unsigned int, SpringStiffness> &stiffness,
              const GhostedVector                           &rest);

    /// Hold nothing any longer.
    void release();

    /// The pieces that are held.
    const std::map<unsigned int, SpringStiffness> &held() const
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
    void add_springs(const CellTable<dim> &cell,
                     const GhostedVector  &u,
                     FullMatrix<double>   *tangent,
                     Vector<double>       &forces) const;

    /**
     * The energy of the springs of each held piece, 1/2 k |u - rest|^2 in total
     * if it is translated, and 1/2 kappa theta^2 in addition if it turns [N mm
     * per mm of thickness]. Collective.
     */
    std::map<unsigned int, double> energy(const GhostedVector &u) const;

    /// The largest rotation of a cell of the held pieces under the displacement
    /// @p du, in the mean over the cell [rad]. Collective.
    double largest_rotation(const GhostedVector &du) const;

    /// The volume of a piece by its area in 2-D [-]; of rings their mean
    /// circumference [mm]; in 3-D the edge of a cube of that volume [mm].
    double mean_depth(const unsigned int piece) const;

  private:
    static constexpr unsigned int n_axes = Dimension<dim>::n_rotations;

    /// The springs of a cell: of each corner, and of its rotation about each
    /// axis, whose derivative by the displacements of the cell is a row.
    struct CellSprings
    {
      double                             corner = 0, rotation = 0;
      std::array<Vector<double>, n_axes> rows;
    };

    CellSprings springs_of(const CellTable<dim> &cell) const;

    /// The derivative of the mean rotation of a cell about an axis.
    Vector<double> rotation_row(const CellTable<dim> &cell,
                                const unsigned int    axis) const;

    /// The rotation of a cell since it was at rest.
    double rotation(const CellTable<dim> &cell,
                    const Vector<double> &row,
                    const GhostedVector  &u) const;

    const Discretization<dim>         &discretization;
    const std::vector<CellTable<dim>> &cells;
    std::vector<double>                areas, volumes; // by piece, of all ranks
    GhostedVector                      rest;
    unsigned int                       n_changes = 0;

    std::map<unsigned int, SpringStiffness> stiffness;
  };
} // namespace Contact

#endif
