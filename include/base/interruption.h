/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_interruption_h
#define contact_interruption_h

#include <deal.II/base/mpi.h>

namespace Contact
{
  using namespace dealii;

  /// From now on SIGTERM and SIGINT are noted; a second one ends the program
  /// at once.
  void note_signals();

  /// Throws Interrupted on all ranks if a signal has come to one of them.
  void stop_if_interrupted(const MPI_Comm communicator);
} // namespace Contact

#endif
