/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_exchange_h
#define contact_exchange_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <type_traits>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /// The values of all ranks, one rank behind the other. They are sent as they
  /// are, where dealii::Utilities::MPI::all_gather() compresses them.
  /// Collective.
  template<typename T>
  std::vector<T> gathered(const std::vector<T> &own,
                          const MPI_Comm        communicator)
  {
    static_assert(std::is_trivially_copyable<T>::value);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    if (n_ranks == 1)
      return own;
    const int        n = own.size();
    std::vector<int> sizes(n_ranks), starts(n_ranks);
    int              error =
      MPI_Allgather(&n, 1, MPI_INT, sizes.data(), 1, MPI_INT, communicator);
    AssertThrowMPI(error);
    std::partial_sum(sizes.begin(), sizes.end() - 1, starts.begin() + 1);
    std::vector<T> all(starts.back() + sizes.back());
    MPI_Datatype   type;
    error = MPI_Type_contiguous(sizeof(T), MPI_BYTE, &type);
    AssertThrowMPI(error);
    error = MPI_Type_commit(&type);
    AssertThrowMPI(error);
    error = MPI_Allgatherv(own.data(),
                           n,
                           type,
                           all.data(),
                           sizes.data(),
                           starts.data(),
                           type,
                           communicator);
    AssertThrowMPI(error);
    error = MPI_Type_free(&type);
    AssertThrowMPI(error);
    return all;
  }



  /// Ask other ranks, each its own question, and get the answers by rank.
  /// Collective.
  template<typename Answer, typename Question, typename Function>
  std::map<unsigned int, Answer>
  ask(const std::map<unsigned int, Question> &questions,
      const Function                         &answer,
      const MPI_Comm                          communicator)
  {
    std::map<unsigned int, Answer> replies;
    for (const auto &[rank, question] :
         Utilities::MPI::some_to_some(communicator, questions))
      replies.emplace(rank, answer(question));
    return Utilities::MPI::some_to_some(communicator, replies);
  }



  /// The ranks that own the unknowns of a vector: one rank those behind the
  /// other's.
  class UnknownOwners
  {
  public:
    using Dof  = types::global_dof_index;
    using Dofs = std::vector<Dof>;

    /// Of this rank are @p owned. Collective.
    UnknownOwners(const IndexSet &owned, const MPI_Comm communicator)
      : ends(gathered(Dofs{owned.n_elements()}, communicator))
    {
      std::partial_sum(ends.begin(), ends.end(), ends.begin());
    }

    unsigned int owner(const Dof dof) const
    {
      return std::upper_bound(ends.begin(), ends.end(), dof) - ends.begin();
    }

    /// Ascending unknowns by the rank that owns them.
    std::map<unsigned int, Dofs> by_owner(const Dofs &dofs) const
    {
      std::map<unsigned int, Dofs> result;
      for (auto begin = dofs.begin(); begin != dofs.end();)
        {
          const unsigned int rank = owner(*begin);
          const auto end = std::lower_bound(begin, dofs.end(), ends[rank]);
          result.emplace(rank, Dofs(begin, end));
          begin = end;
        }
      return result;
    }

  private:
    Dofs ends;
  };



  /// In ascending order, each once.
  template<typename T>
  void sort_unique(std::vector<T> &values)
  {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }
} // namespace Contact

#endif
