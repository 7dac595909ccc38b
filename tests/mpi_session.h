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
  /// of temporary vectors: it has to be made before. Since deal.II 9.7 Kokkos
  /// begins with the store.
  struct MpiSession
  {
    GrowingVectorMemory<TrilinosWrappers::MPI::Vector> store;

    int    argc = 0;
    char **argv = nullptr;
#if DEAL_II_VERSION_GTE(9, 7, 0)
    InitFinalize session{argc,
                         argv,
                         InitializeLibrary::MPI | InitializeLibrary::P4EST,
                         1};
#else
    Utilities::MPI::MPI_InitFinalize session{argc, argv, 1};
#endif
  };
  inline const MpiSession mpi_session;
} // namespace Tests

#endif
