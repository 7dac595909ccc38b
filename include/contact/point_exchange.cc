/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/point_exchange.h"

#include <deal.II/base/mpi.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>
#include <numeric>
#include <sstream>

namespace Contact
{
  namespace
  {
    template<class Archive, typename T>
    void exchange(Archive &archive, PointPairing<3>::PerNode<T> &list)
    {
      unsigned int size = list.size();
      archive     &size;
      list.resize(size);
      for (T &entry : list)
        archive &entry;
    }



    /// All that MortarDiscretization<3>::pair() finds.
    template<class Archive>
    void exchange(Archive &archive, ContactPoint<3> &point)
    {
      archive &point.weight &point.facing &point.n_slave_nodes &point.n_nodes;
      exchange(archive, point.dofs);
      exchange(archive, point.X);
      exchange(archive, point.C);
      point.C1.resize(point.n_nodes);
      point.C2.resize(point.n_nodes);
      archive &point.normal &point.tangents &point.projection &point
        .tangential_row_is_void                               &point.void_slips;
    }
  } // namespace



  std::pair<unsigned int, unsigned int>
  share_of_rank(const unsigned int n, const MPI_Comm communicator)
  {
    const std::size_t rank  = Utilities::MPI::this_mpi_process(communicator);
    const std::size_t ranks = Utilities::MPI::n_mpi_processes(communicator);
    return {n * rank / ranks, n * (rank + 1) / ranks};
  }



  // Utilities::MPI::all_gather() would compress what is sent.
  void exchange_pairings(const ArrayView<ContactPoint<3>> &points,
                         const MPI_Comm                    communicator)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    if (n_ranks == 1)
      return;
    const auto [first, end] = share_of_rank(points.size(), communicator);
    std::ostringstream own(std::ios::binary);
    {
      boost::archive::binary_oarchive archive(own, boost::archive::no_header);
      for (unsigned int q = first; q < end; ++q)
        exchange(archive, points[q]);
    }
    const std::string send = own.str();

    const std::vector<int> sizes =
      Utilities::MPI::all_gather(communicator, static_cast<int>(send.size()));
    std::vector<int> starts(n_ranks + 1, 0);
    std::partial_sum(sizes.begin(), sizes.end(), starts.begin() + 1);
    std::string all(starts.back(), '\0');
    const int   error = MPI_Allgatherv(send.data(),
                                     send.size(),
                                     MPI_CHAR,
                                     &all[0],
                                     sizes.data(),
                                     starts.data(),
                                     MPI_CHAR,
                                     communicator);
    AssertThrowMPI(error);

    for (unsigned int rank = 0; rank < n_ranks; ++rank)
      {
        std::istringstream received(all.substr(starts[rank], sizes[rank]),
                                    std::ios::binary);
        boost::archive::binary_iarchive archive(received,
                                                boost::archive::no_header);
        for (unsigned int q = points.size() * std::size_t(rank) / n_ranks;
             q < points.size() * std::size_t(rank + 1) / n_ranks;
             ++q)
          exchange(archive, points[q]);
      }
  }
} // namespace Contact
