/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_values_h
#define contact_surface_values_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <memory>
#include <vector>

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
      partitioner.reset();
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return;
      IndexSet shared = used;
      shared.subtract_set(owned);
      partitioner = std::make_shared<Utilities::MPI::Partitioner>(owned,
                                                                  shared,
                                                                  communicator);
      ghosts.resize(partitioner->n_ghost_indices());
      messages.resize(partitioner->n_import_indices());
    }

    /// Get the values of @p v. Collective.
    void read(const Vector &v) const
    {
      if (!partitioner)
        return;
      partitioner->template export_to_ghosted_array_start<Number>(
        channel,
        ArrayView<const Number>(v.begin(), v.locally_owned_size()),
        make_array_view(messages),
        make_array_view(ghosts),
        requests);
      partitioner->template export_to_ghosted_array_finish<Number>(
        make_array_view(ghosts),
        requests);
    }

    Number operator()(const Vector &v, const Dof dof) const
    {
      return is_own(dof) ? v(dof) : ghost(dof);
    }

    /// Begin to add.
    void clear() const
    {
      std::fill(ghosts.begin(), ghosts.end(), Number(0));
    }

    void add(Vector &v, const Dof dof, const Number value) const
    {
      (is_own(dof) ? v(dof) : ghost(dof)) += value;
    }

    /// Add what all ranks have added to @p v. Collective.
    void add_to(Vector &v) const
    {
      if (!partitioner)
        return;
      partitioner->template import_from_ghosted_array_start<Number>(
        VectorOperation::add,
        channel,
        make_array_view(ghosts),
        make_array_view(messages),
        requests);
      partitioner->template import_from_ghosted_array_finish<Number>(
        VectorOperation::add,
        ArrayView<const Number>(messages.data(), messages.size()),
        ArrayView<Number>(v.begin(), v.locally_owned_size()),
        make_array_view(ghosts),
        requests);
    }

  private:
    bool is_own(const Dof dof) const
    {
      return !partitioner || partitioner->in_local_range(dof);
    }

    Number &ghost(const Dof dof) const
    {
      return ghosts[partitioner->ghost_indices().index_within_set(dof)];
    }

    static constexpr unsigned int channel = 0; // one exchange at a time

    std::shared_ptr<const Utilities::MPI::Partitioner> partitioner;
    mutable std::vector<Number>      ghosts; // what others own
    mutable std::vector<Number>      messages;
    mutable std::vector<MPI_Request> requests;
  };
} // namespace Contact

#endif
