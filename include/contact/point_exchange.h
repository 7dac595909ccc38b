/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_point_exchange_h
#define contact_point_exchange_h

#include <deal.II/base/array_view.h>

#include <mpi.h>
#include <utility>

#include "contact/contact_points.h"

namespace Contact
{
  /// The share [first, end) of @p n things that this rank does for all.
  std::pair<unsigned int, unsigned int>
  share_of_rank(const unsigned int n, const MPI_Comm communicator);

  /**
   * Each rank has paired its share of the points, see share_of_rank(): give the
   * pairings and weights to all. They are the same numbers on any number of
   * ranks.
   */
  void exchange_pairings(const ArrayView<ContactPoint<3>> &points,
                         const MPI_Comm                    communicator);
} // namespace Contact

#endif
