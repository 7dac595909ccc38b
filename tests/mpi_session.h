/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mpi_session_h
#define contact_mpi_session_h

#include <deal.II/base/mpi.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/lac/vector_memory.h>

namespace Tests
{
  using namespace dealii;

  /// MPI, from before main() until after it. The end of MPI empties the store
  /// of temporary vectors: it has to be made before.
  struct MpiSession
  {
    GrowingVectorMemory<TrilinosWrappers::MPI::Vector> store;

    int                              argc = 0;
    char                           **argv = nullptr;
    Utilities::MPI::MPI_InitFinalize session{argc, argv, 1};
  };
  inline const MpiSession mpi_session;
} // namespace Tests

#endif
