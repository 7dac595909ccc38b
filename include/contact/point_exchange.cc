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
      const auto exchange_all = [&](auto &...of_point) {
        (void(archive & of_point), ...);
      };
      exchange_all(point.weight,
                   point.facing,
                   point.n_slave_nodes,
                   point.n_nodes,
                   point.normal,
                   point.tangents,
                   point.projection,
                   point.tangential_row_is_void,
                   point.void_slips,
                   point.springs,
                   point.change.dofs,
                   point.change.C,
                   point.change.turn,
                   point.change.slide);
      exchange(archive, point.dofs);
      exchange(archive, point.X);
      exchange(archive, point.C);
      point.C1.resize(point.n_nodes); // zero
      point.C2.resize(point.n_nodes);
    }
  } // namespace



  PointShares::PointShares(const unsigned int n_points,
                           const MPI_Comm     communicator)
    : communicator(communicator)
    , rank(Utilities::MPI::this_mpi_process(communicator))
    , n_ranks(Utilities::MPI::n_mpi_processes(communicator))
  {
    for (std::size_t r = 0; r <= n_ranks; ++r)
      starts.push_back(n_points * r / n_ranks);
  }



  // Utilities::MPI::all_gather() would compress what is sent.
  void PointShares::exchange(const ArrayView<ContactPoint<3>> &points,
                             const double                      seconds)
  {
    if (n_ranks == 1)
      return;
    std::ostringstream own(std::ios::binary);
    {
      boost::archive::binary_oarchive archive(own, boost::archive::no_header);
      for (unsigned int q = first(); q < end(); ++q)
        Contact::exchange(archive, points[q]);
    }
    const std::string send = own.str();

    const std::vector<int> sizes =
      Utilities::MPI::all_gather(communicator, static_cast<int>(send.size()));
    std::vector<int> offsets(n_ranks + 1, 0);
    std::partial_sum(sizes.begin(), sizes.end(), offsets.begin() + 1);
    std::string all(offsets.back(), '\0');
    const int   error = MPI_Allgatherv(send.data(),
                                     send.size(),
                                     MPI_CHAR,
                                     &all[0],
                                     sizes.data(),
                                     offsets.data(),
                                     MPI_CHAR,
                                     communicator);
    AssertThrowMPI(error);

    for (unsigned int r = 0; r < n_ranks; ++r)
      {
        std::istringstream received(all.substr(offsets[r], sizes[r]),
                                    std::ios::binary);
        boost::archive::binary_iarchive archive(received,
                                                boost::archive::no_header);
        for (unsigned int q = starts[r]; q < starts[r + 1]; ++q)
          Contact::exchange(archive, points[q]);
      }
    balance(Utilities::MPI::all_gather(communicator, seconds));
  }



  // Within a share all points are taken to cost the same.
  void PointShares::balance(const std::vector<double> &seconds)
  {
    const double each =
      std::accumulate(seconds.begin(), seconds.end(), 0.) / n_ranks;
    const std::vector<unsigned int> old    = starts;
    double                          before = 0;
    unsigned int                    next   = 1;
    for (unsigned int r = 0; r < n_ranks; ++r)
      {
        for (; next < n_ranks && next * each < before + seconds[r]; ++next)
          starts[next] = old[r] + (next * each - before) / seconds[r] *
                                    (old[r + 1] - old[r]);
        before += seconds[r];
      }
  }
} // namespace Contact
