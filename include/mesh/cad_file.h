/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cad_file_h
#define contact_cad_file_h

#include <mpi.h>

#include "parameters/parameters.h"

namespace Contact
{
  /**
   * If the mesh of a case is a CAD file or a .geo, mesh it on the first rank
   * and let the case have that mesh, which is kept in the directory of its
   * results; a finding says so. One that is there is taken as it is if neither
   * the file nor an entry has changed, by a fingerprint in its last lines.
   * Throws InputError on all ranks.
   */
  void mesh_cad_file(Parameters::All  &parameters,
                     ParameterHandler &prm,
                     const MPI_Comm    communicator);
} // namespace Contact

#endif
