/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "base/all_ranks.h"

#include <deal.II/base/mpi.h>

#include <iostream>
#include <string>

#include "base/errors.h"

namespace Contact
{
  using namespace dealii;

  void on_all_ranks(const MPI_Comm               communicator,
                    const std::function<void()> &work)
  {
    std::string complaint;
    try
      {
        work();
      }
    catch (const InputError &error)
      {
        complaint = error.what();
      }
    for (const std::string &of_rank :
         Utilities::MPI::all_gather(communicator, complaint))
      if (!of_rank.empty())
        throw InputError(of_rank);
  }



  void end_all_ranks(const MPI_Comm communicator, const std::exception &error)
  {
    if (Utilities::MPI::n_mpi_processes(communicator) == 1)
      return;
    std::cerr << "Process " << Utilities::MPI::this_mpi_process(communicator)
              << " failed, and ends all; this is an error of the program:\n"
              << error.what() << std::endl;
    MPI_Abort(communicator, 4);
  }
} // namespace Contact
