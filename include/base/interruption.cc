/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "base/interruption.h"

#include <csignal>

#include "base/errors.h"

namespace Contact
{
  namespace
  {
    volatile std::sig_atomic_t noted = 0;

    extern "C" void note(int signal)
    {
      noted = signal;
      std::signal(signal, SIG_DFL);
    }
  } // namespace



  void note_signals()
  {
    std::signal(SIGTERM, note);
    std::signal(SIGINT, note);
  }



  void stop_if_interrupted(const MPI_Comm communicator)
  {
    if (Utilities::MPI::max(static_cast<int>(noted), communicator) != 0)
      throw Interrupted("interrupted by a signal; what is finished can be "
                        "read, and --restart goes on from there");
  }
} // namespace Contact
