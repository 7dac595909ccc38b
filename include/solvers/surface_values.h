/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_values_h
#define contact_surface_values_h

#include <deal.II/base/index_set.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <memory>
#include <vector>

#include "base/exchange.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Some unknowns of a vector, those of the surfaces, on the ranks that use
   * them, each its own ones: read what others own, or add to it. On one rank
   * these are the values of the vector itself.
   */
  template<typename Number>
  class SurfaceValues
  {
  public:
    using Dof    = types::global_dof_index;
    using Vector = LinearAlgebra::distributed::Vector<Number>;

    /// The unknowns @p used here, of vectors of which @p owned are this rank's.
    /// Collective.
    void initialize(const IndexSet &used,
                    const IndexSet &owned,
                    const MPI_Comm  communicator)
    {
      distributed = Utilities::MPI::n_mpi_processes(communicator) > 1;
      if (!distributed)
        return;
      IndexSet shared = used;
      shared.compress();
      IndexSet own = shared & owned;
      own.fill_index_vector(own_shared);
      shared.subtract_set(owned);
      copies = std::make_shared<Vector>(owned, shared, communicator);
      const auto &partitioner = *copies->get_partitioner();
      for (const auto &[begin, end] : partitioner.import_indices())
        for (unsigned int i = begin; i < end; ++i)
          own_shared.push_back(partitioner.local_to_global(i));
      sort_unique(own_shared);
    }

    /// Get the values of @p v. Collective.
    void read(const Vector &v) const
    {
      if (!distributed)
        return;
      for (const Dof dof : own_shared)
        (*copies)(dof) = v(dof);
      copies->update_ghost_values();
    }

    Number operator()(const Vector &v, const Dof dof) const
    {
      return distributed ? (*copies)(dof) : v(dof);
    }

    /// Begin to add.
    void clear() const
    {
      if (!distributed)
        return;
      copies->zero_out_ghost_values();
      for (const Dof dof : own_shared)
        (*copies)(dof) = 0;
    }

    void add(Vector &v, const Dof dof, const Number value) const
    {
      (distributed ? (*copies)(dof) : v(dof)) += value;
    }

    /// Add what all ranks have added to @p v. Collective.
    void add_to(Vector &v) const
    {
      if (!distributed)
        return;
      copies->compress(VectorOperation::add);
      for (const Dof dof : own_shared)
        v(dof) += (*copies)(dof);
    }

  private:
    bool             distributed = false;
    std::vector<Dof> own_shared; // of this rank, that some rank uses

    /// Assignment to a vector would keep the ghosts that it has.
    std::shared_ptr<Vector> copies;
  };
} // namespace Contact

#endif
