/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/points/point_exchange.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstring>
#include <functional>

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



    /// Nodes of the slave and then of the master, by their numbers.
    struct Nodes
    {
      const Surface<3> &slave, &master;

      unsigned int number(const SurfaceNode<3> *node) const
      {
        const auto first = slave.nodes.data();
        const auto last  = first + slave.nodes.size();
        const bool of_slave =
          std::less_equal<>()(first, node) && std::less<>()(node, last);
        return of_slave ? node - first
                        : slave.nodes.size() + (node - master.nodes.data());
      }

      const SurfaceNode<3> *node(const unsigned int number) const
      {
        return number < slave.nodes.size()
                 ? &slave.nodes[number]
                 : &master.nodes[number - slave.nodes.size()];
      }
    };

    /// The findings of MortarDiscretization<3>::pair(), but for the changes
    /// that one rank alone has.
    template<class Archive>
    void
    exchange_point(Archive &archive, const Nodes &nodes, ContactPoint<3> &point)
    {
      const auto exchange_all = [&](auto &...of_point) {
        (exchange(archive, of_point), ...);
      };
      exchange_all(point.weight,
                   point.facing,
                   point.master_facet,
                   point.n_slave_nodes,
                   point.n_nodes,
                   point.normal,
                   point.tangents,
                   point.projection,
                   point.has_no_free_tangent,
                   point.tangents_held_by_supports,
                   point.rim_compliance,
                   point.change.dofs,
                   point.change.slide,
                   point.C);
      PointPairing<3>::PerNode<unsigned int> numbers;
      for (const SurfaceNode<3> *node : point.nodes)
        numbers.push_back(nodes.number(node));
      exchange(archive, numbers);
      point.nodes.resize(numbers.size());
      for (unsigned int a = 0; a < numbers.size(); ++a)
        point.nodes[a] = nodes.node(numbers[a]);
    }
  } // namespace



  PointShares::PointShares(const unsigned int n_points,
                           const MPI_Comm     communicator)
    : communicator(communicator)
    , rank(Utilities::MPI::this_mpi_process(communicator))
    , n_ranks(Utilities::MPI::n_mpi_processes(communicator))
    , seconds{
        {std::vector<float>(n_points, -1), std::vector<float>(n_points, -1)}}
  {
  }



  // Times that are not known are taken to be the mean of those that are, first
  // of points that are alike.
  PointShares::Numbers
  PointShares::own(const Numbers           &numbers,
                   const std::vector<bool> &with_derivatives) const
  {
    if (n_ranks == 1)
      return numbers;
    std::array<double, 2>       known{{0, 0}};
    std::array<unsigned int, 2> n_known{{0, 0}};
    for (const unsigned int q : numbers)
      if (const unsigned int kind = with_derivatives[q]; seconds[kind][q] >= 0)
        {
          known[kind] += seconds[kind][q];
          ++n_known[kind];
        }
    const double all     = known[0] + known[1];
    const auto   mean_of = [&](const unsigned int kind) {
      return known[kind] > 0 ? known[kind] / n_known[kind]
               : all > 0       ? all / (n_known[0] + n_known[1])
                               : 1.;
    };
    const std::array<double, 2> mean{{mean_of(0), mean_of(1)}};

    std::vector<double> until; // the end of each point
    double              sum = 0;
    for (const unsigned int q : numbers)
      {
        const unsigned int kind = with_derivatives[q];
        const double       last = seconds[kind][q];
        until.push_back(sum += all > 0 && last >= 0 ? last : mean[kind]);
      }
    const auto place = [&](const unsigned int r) {
      return r == n_ranks
               ? numbers.end()
               : numbers.begin() + (std::lower_bound(until.begin(),
                                                     until.end(),
                                                     sum * r / n_ranks) -
                                    until.begin());
    };
    return {place(rank), place(rank + 1)};
  }



  void PointShares::exchange(const ArrayView<ContactPoint<3>> &points,
                             const Surface<3>                 &slave,
                             const Surface<3>                 &master,
                             const Numbers                    &numbers,
                             const Numbers                    &own,
                             const std::vector<bool>          &with_derivatives,
                             const std::vector<float>         &of_own)
  {
    if (n_ranks == 1)
      return;
    const Nodes nodes{slave, master};
    Writer      writer;
    for (const unsigned int q : own)
      {
        exchange_point(writer, nodes, points[q]);
        writer.plain(&of_own[q], 1);
      }

    const std::vector<char> all = gathered(writer.bytes, communicator);
    Reader                  reader{all.data()};
    for (const unsigned int q : numbers)
      {
        exchange_point(reader, nodes, points[q]);
        reader.plain(&seconds[with_derivatives[q]][q], 1);
      }
  }
} // namespace Contact
