/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_all_ranks_h
#define contact_all_ranks_h

#include <functional>
#include <mpi.h>

namespace Contact
{
  /**
   * Do @p work, which must not wait for others, on all ranks: an InputError on
   * some of them is one on all, such that none waits for those that are gone.
   */
  void on_all_ranks(const MPI_Comm               communicator,
                    const std::function<void()> &work);
} // namespace Contact

#endif
