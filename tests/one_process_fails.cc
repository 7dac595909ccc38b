/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// An error that one of two processes has alone ends both with a message and
// status 4, though the other waits for it. Run by mpirun.

#include <deal.II/base/mpi.h>

#include <stdexcept>

#include "base/all_ranks.h"

int main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 1)
    Contact::end_all_ranks(MPI_COMM_WORLD, std::runtime_error("no memory"));
  MPI_Barrier(MPI_COMM_WORLD);
}
