/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "base/ghosted_vector.h"

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Contact
{
  namespace
  {
    /// The terms of what is owned, from all processes, and of the multipliers.
    template<class Term>
    double add_up(const Utilities::MPI::Partitioner &distribution,
                  const std::size_t                  n_held,
                  const Term                        &term)
    {
      double            sum = 0, of_multipliers = 0;
      const std::size_t n_owned = distribution.locally_owned_size();
      for (std::size_t k = 0; k < n_owned; ++k)
        sum += term(k);
      for (auto k = n_owned + distribution.n_ghost_indices(); k < n_held; ++k)
        of_multipliers += term(k);
      return of_multipliers +
             Utilities::MPI::sum(sum, distribution.get_mpi_communicator());
    }
  } // namespace



  // Multiplication by the golden ratio strews numbers that follow each other
  // over a table whose size is a power of two (D. E. Knuth, The Art of Computer
  // Programming, volume 3, section 6.4).
  HeldUnknowns::HeldUnknowns(const IndexSet &owned,
                             const IndexSet &held,
                             const MPI_Comm  communicator)
    : Utilities::MPI::Partitioner(owned, held, communicator)
    , ghosts(2, {numbers::invalid_dof_index, 0})
    , shift(63)
  {
    while (ghosts.size() < 2 * std::size_t(n_ghost_indices()))
      {
        ghosts.resize(2 * ghosts.size(), ghosts[0]);
        --shift;
      }
    unsigned int number = 0;
    for (const Dof i : ghost_indices())
      {
        std::size_t at = place(i);
        while (ghosts[at].first != numbers::invalid_dof_index)
          at = (at + 1) & (ghosts.size() - 1);
        ghosts[at] = {i, number++};
      }
  }



  GhostedVector::GhostedVector(const Distribution &distribution,
                               const std::size_t   n_multipliers)
    : distribution(distribution)
    , values(n_distributed_held() + n_multipliers)
    , first(distribution->local_range().first)
    , n_direct(is_distributed() ? distribution->locally_owned_size()
                                : values.size())
  {
  }



  std::size_t
  GhostedVector::position_of_other(const types::global_dof_index i) const
  {
    AssertThrow(is_distributed(), ExcInternalError());
    if (i >= distribution->size())
      return n_distributed_held() + (i - distribution->size());
    const unsigned int k = distribution->ghost(i);
    AssertThrow(k != numbers::invalid_unsigned_int, ExcInternalError());
    return n_direct + k;
  }



  double GhostedVector::operator*(const GhostedVector &other) const
  {
    if (!is_distributed())
      return values * other.values;
    return add_up(*distribution, n_held(), [&](const std::size_t k) {
      return values[k] * other.values[k];
    });
  }



  double GhostedVector::l2_norm() const
  {
    return is_distributed() ? std::sqrt(*this * *this) : values.l2_norm();
  }



  double GhostedVector::l1_norm() const
  {
    if (!is_distributed())
      return values.l1_norm();
    return add_up(*distribution, n_held(), [&](const std::size_t k) {
      return std::abs(values[k]);
    });
  }



  double GhostedVector::linfty_norm() const
  {
    const double largest = values.linfty_norm();
    return is_distributed()
             ? Utilities::MPI::max(largest,
                                   distribution->get_mpi_communicator())
             : largest;
  }



  double GhostedVector::sum() const
  {
    if (!is_distributed())
      return values.mean_value() * values.size();
    return add_up(*distribution, n_held(), [&](const std::size_t k) {
      return values[k];
    });
  }



  bool GhostedVector::all_zero() const
  {
    return is_distributed() ? linfty_norm() == 0 : values.all_zero();
  }



  void GhostedVector::compress_add()
  {
    if (!is_distributed())
      return;
    const ArrayView<double>  owned(begin(), distribution->locally_owned_size());
    const ArrayView<double>  ghosts(owned.end(),
                                   distribution->n_ghost_indices());
    std::vector<double>      received(distribution->n_import_indices());
    std::vector<MPI_Request> requests;
    distribution->import_from_ghosted_array_start(VectorOperation::add,
                                                  0,
                                                  ghosts,
                                                  make_array_view(received),
                                                  requests);
    distribution->import_from_ghosted_array_finish(
      VectorOperation::add,
      ArrayView<const double>(received.data(), received.size()),
      owned,
      ghosts,
      requests);
    update_ghosts();
    if (ghosts.end() != end())
      Utilities::MPI::sum(
        ArrayView<const double>(ghosts.end(), end() - ghosts.end()),
        distribution->get_mpi_communicator(),
        ArrayView<double>(ghosts.end(), end() - ghosts.end()));
  }



  void GhostedVector::zero_out_ghosts()
  {
    if (!is_distributed())
      return;
    const bool is_first = Utilities::MPI::this_mpi_process(
                            distribution->get_mpi_communicator()) == 0;
    double *const ghosts = begin() + distribution->locally_owned_size();
    std::fill(ghosts, is_first ? begin() + n_distributed_held() : end(), 0.);
  }



  void GhostedVector::update_ghosts()
  {
    if (!is_distributed())
      return;
    const std::size_t        n_owned = distribution->locally_owned_size();
    const ArrayView<double>  ghosts(begin() + n_owned,
                                   distribution->n_ghost_indices());
    std::vector<double>      sent(distribution->n_import_indices());
    std::vector<MPI_Request> requests;
    distribution->export_to_ghosted_array_start(
      0,
      ArrayView<const double>(begin(), n_owned),
      make_array_view(sent),
      ghosts,
      requests);
    distribution->export_to_ghosted_array_finish(ghosts, requests);
  }
} // namespace Contact
