/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/point_exchange.h"

#include <deal.II/base/mpi.h>

#include <cstring>
#include <numeric>

#include "base/exchange.h"

namespace Contact
{
  namespace
  {
    /// Values of points one after the other, as they are in memory: an archive
    /// that is called for each would be most of the time of the exchange.
    struct Writer
    {
      std::vector<char> bytes;

      template<typename T>
      void plain(T *const values, const std::size_t n)
      {
        const char *const first = reinterpret_cast<const char *>(values);
        bytes.insert(bytes.end(), first, first + n * sizeof(T));
      }
    };

    struct Reader
    {
      const char *next;

      template<typename T>
      void plain(T *const values, const std::size_t n)
      {
        std::memcpy(static_cast<void *>(values), next, n * sizeof(T));
        next += n * sizeof(T);
      }
    };



    template<class Archive, typename T>
    void exchange(Archive &archive, T &value)
    {
      archive.plain(&value, 1);
    }

    template<class Archive, class List>
    void exchange_list(Archive &archive, List &list)
    {
      std::size_t size = list.size();
      archive.plain(&size, 1);
      list.resize(size);
      archive.plain(list.data(), size);
    }

    template<class Archive, typename T>
    void exchange(Archive &archive, std::vector<T> &list)
    {
      exchange_list(archive, list);
    }

    template<class Archive, typename T>
    void exchange(Archive &archive, PointPairing<3>::PerNode<T> &list)
    {
      exchange_list(archive, list);
    }

    template<class Archive>
    void exchange(Archive &archive, FullMatrix<double> &matrix)
    {
      std::array<std::size_t, 2> size{{matrix.m(), matrix.n()}};
      archive.plain(size.data(), 2);
      if (matrix.m() != size[0] || matrix.n() != size[1])
        matrix.reinit(size[0], size[1]);
      if (!matrix.empty())
        archive.plain(&matrix(0, 0), matrix.n_elements());
    }



    /// All that MortarDiscretization<3>::pair() finds.
    template<class Archive>
    void exchange_point(Archive &archive, ContactPoint<3> &point)
    {
      const auto exchange_all = [&](auto &...of_point) {
        (exchange(archive, of_point), ...);
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
                   point.change.slide,
                   point.dofs,
                   point.X,
                   point.C);
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



  std::vector<unsigned int>
  PointShares::own(const std::vector<unsigned int> &numbers) const
  {
    const auto place = [&](const unsigned int r) {
      return numbers.begin() +
             std::size_t(starts[r]) * numbers.size() / starts.back();
    };
    return {place(rank), place(rank + 1)};
  }



  void PointShares::exchange(const ArrayView<ContactPoint<3>> &points,
                             const std::vector<unsigned int>  &numbers) const
  {
    if (n_ranks == 1)
      return;
    Writer writer;
    for (const unsigned int q : own(numbers))
      exchange_point(writer, points[q]);

    const std::vector<char> all = gathered(writer.bytes, communicator);
    Reader                  reader{all.data()};
    for (const unsigned int q : numbers)
      exchange_point(reader, points[q]);
  }



  // Within a share all points are taken to cost the same.
  void PointShares::balance(const double of_rank)
  {
    const std::vector<double> seconds =
      Utilities::MPI::all_gather(communicator, of_rank);
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
