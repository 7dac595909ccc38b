/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_all_ranks_h
#define contact_all_ranks_h

#include <exception>
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

  /**
   * Print @p error, one of the program itself, that this rank may have alone,
   * and end all ranks with status 4: the others would wait for this one. A
   * single rank returns. To be called while matrices, factorizations and meshes
   * live: their destructors are collective, and would wait for the others.
   */
  void end_all_ranks(const MPI_Comm communicator, const std::exception &error);
} // namespace Contact

#endif
