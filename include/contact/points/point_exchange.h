/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_point_exchange_h
#define contact_point_exchange_h

#include <deal.II/base/array_view.h>

#include <array>
#include <mpi.h>
#include <vector>

#include "contact/points/contact_points.h"

namespace Contact
{
  /**
   * The shares of the contact points that the ranks pair, each its own for all:
   * numbers that follow each other. All take the same time, as far as is known
   * from the last pairing of each point, which takes longer with derivatives. A
   * pairing is the same whichever rank makes it.
   */
  class PointShares
  {
  public:
    using Numbers = std::vector<unsigned int>;

    PointShares(const unsigned int n_points, const MPI_Comm communicator);

    /// The share of this rank in a list of points, some of which, by number,
    /// get derivatives.
    Numbers own(const Numbers           &numbers,
                const std::vector<bool> &with_derivatives) const;

    /// Give the pairings and weights of the points of each share in such a list
    /// to all ranks, and the time each has taken: @p of_own, by number of a
    /// point, has that of the own ones. The nodes of the points are those of
    /// the two surfaces. Collective.
    void exchange(const ArrayView<ContactPoint<3>> &points,
                  const Surface<3>                 &slave,
                  const Surface<3>                 &master,
                  const Numbers                    &numbers,
                  const Numbers                    &own,
                  const std::vector<bool>          &with_derivatives,
                  const std::vector<float>         &of_own);

  private:
    const MPI_Comm     communicator;
    const unsigned int rank, n_ranks;

    /// By point, without and with derivatives; negative where it is not known.
    std::array<std::vector<float>, 2> seconds;
  };
} // namespace Contact

#endif
