/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_point_exchange_h
#define contact_point_exchange_h

#include <deal.II/base/array_view.h>

#include <mpi.h>
#include <vector>

#include "contact/contact_points.h"

namespace Contact
{
  /**
   * The shares of the contact points that the ranks pair, each its own for all:
   * numbers that follow each other. They are balanced by the time that each
   * rank has taken. A pairing is the same whichever rank makes it.
   */
  class PointShares
  {
  public:
    PointShares(const unsigned int n_points, const MPI_Comm communicator);

    /// The share of this rank in a list of points: of a part of them it is as
    /// large a part as of all.
    std::vector<unsigned int>
    own(const std::vector<unsigned int> &numbers) const;

    /// Give the pairings and weights of the points of each share in such a list
    /// to all ranks. Collective.
    void exchange(const ArrayView<ContactPoint<3>> &points,
                  const std::vector<unsigned int>  &numbers) const;

    /// This rank has taken @p seconds for its own: the next shares are such
    /// that all ranks would have taken the same time. Collective.
    void balance(const double seconds);

  private:
    const MPI_Comm            communicator;
    const unsigned int        rank, n_ranks;
    std::vector<unsigned int> starts; // and the end of the last
  };
} // namespace Contact

#endif
