/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_ghosted_vector_h
#define contact_ghosted_vector_h

#include <deal.II/base/partitioner.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/lac/vector.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /// The owners of the unknowns, and the others that this process holds: the
  /// ghosts, which are found at once. In a set of indices one would have to be
  /// searched for among its ranges, of which those of surfaces are many.
  class HeldUnknowns : public Utilities::MPI::Partitioner
  {
  public:
    using Dof = types::global_dof_index;

    /// Collective.
    HeldUnknowns(const IndexSet &owned,
                 const IndexSet &held,
                 const MPI_Comm  communicator);

    /// The number of an unknown among the ghosts, or
    /// numbers::invalid_unsigned_int.
    unsigned int ghost(const Dof i) const
    {
      std::size_t at = place(i);
      while (ghosts[at].first != i)
        {
          if (ghosts[at].first == numbers::invalid_dof_index)
            return numbers::invalid_unsigned_int;
          at = (at + 1) & (ghosts.size() - 1);
        }
      return ghosts[at].second;
    }

  private:
    /// The place in the table to begin the search of it.
    std::size_t place(const Dof i) const
    {
      return (i * golden_ratio) >> shift;
    }

    static constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15;

    std::vector<std::pair<Dof, unsigned int>> ghosts; // half of it is empty
    unsigned int                              shift;
  };

  using Distribution = std::shared_ptr<const HeldUnknowns>;

  /// deal.II's own, for its transfer between meshes and its output.
  using DistributedVector = LinearAlgebra::distributed::Vector<double>;

  /**
   * A vector of the unknowns of the bodies, and of multipliers behind them, of
   * which a process holds what it owns, copies of what others own (ghosts), and
   * all multipliers. An index is that of the whole vector.
   *
   * Arithmetic works on all that is held: copies that are right remain so
   * without a word to other processes, which deal.II's distributed vectors do
   * not offer. Functions named collective are for all processes together.
   *
   * A vector without distribution is held in full and alike by all processes;
   * on one process each is, and a Vector<double> to whom wants one.
   */
  class GhostedVector
  {
  public:
    using value_type = double; // for AffineConstraints

    GhostedVector() = default;

    /// Without distribution.
    explicit GhostedVector(const std::size_t n)
      : GhostedVector(Vector<double>(n))
    {
    }
    explicit GhostedVector(const Vector<double> &values)
      : values(values)
      , n_direct(values.size())
    {
    }

    /// Zero, with @p n_multipliers behind the unknowns that are distributed.
    explicit GhostedVector(const Distribution &distribution,
                           const std::size_t   n_multipliers = 0);

    /// Another one, all zero.
    GhostedVector zero() const
    {
      GhostedVector other(*this);
      other = 0;
      return other;
    }

    /// The number of all unknowns, and of those that are held.
    std::size_t size() const
    {
      return is_distributed()
               ? values.size() + distribution->size() - n_distributed_held()
               : values.size();
    }
    std::size_t n_held() const
    {
      return values.size();
    }

    /// Whether an unknown is held.
    bool holds(const types::global_dof_index i) const
    {
      return i - first < n_direct ||
             (is_distributed() &&
              (i >= distribution->size() ||
               distribution->ghost(i) != numbers::invalid_unsigned_int));
    }

    double operator()(const types::global_dof_index i) const
    {
      return values[position(i)];
    }
    double &operator()(const types::global_dof_index i)
    {
      return values[position(i)];
    }
    double operator[](const types::global_dof_index i) const
    {
      return values[position(i)];
    }
    double &operator[](const types::global_dof_index i)
    {
      return values[position(i)];
    }

    /// The values held: those owned, the ghosts, the multipliers.
    const double *begin() const
    {
      return values.begin();
    }
    double *begin()
    {
      return values.begin();
    }
    const double *end() const
    {
      return values.end();
    }
    double *end()
    {
      return values.end();
    }

    GhostedVector &operator=(const double value)
    {
      values = value;
      return *this;
    }
    GhostedVector &operator+=(const GhostedVector &other)
    {
      values += other.values;
      return *this;
    }
    GhostedVector &operator-=(const GhostedVector &other)
    {
      values -= other.values;
      return *this;
    }
    void add(const double factor, const GhostedVector &other)
    {
      values.add(factor, other.values);
    }
    void sadd(const double s, const double a, const GhostedVector &other)
    {
      values.sadd(s, a, other.values);
    }
    void add(const std::vector<types::global_dof_index> &indices,
             const Vector<double>                       &increments)
    {
      for (unsigned int i = 0; i < indices.size(); ++i)
        (*this)[indices[i]] += increments[i];
    }

    /// The values of some unknowns that are held.
    void extract(const std::vector<types::global_dof_index> &indices,
                 Vector<double>                             &local) const
    {
      if (local.size() != indices.size())
        local.reinit(indices.size(), /*omit_zeroing_entries=*/true);
      for (unsigned int i = 0; i < indices.size(); ++i)
        local[i] = (*this)[indices[i]];
    }

    Vector<double>
    extract(const std::vector<types::global_dof_index> &indices) const
    {
      Vector<double> local;
      extract(indices, local);
      return local;
    }

    /// Collective, each unknown once.
    double operator*(const GhostedVector &other) const;
    double l2_norm() const;
    double l1_norm() const;
    double linfty_norm() const;
    double sum() const;
    bool   all_zero() const;

    /// All get the sum of the values that processes have put on unknowns that
    /// they hold, and on multipliers. Collective.
    void compress_add();

    /// AffineConstraints asks before it adds: those here are added to as well.
    static bool has_ghost_elements()
    {
      return false;
    }

    /// Zero where another process is the owner; of multipliers the first one
    /// is. To add to what has been summed up, and sum up once more.
    void zero_out_ghosts();

    /// All get what the owner has. Collective.
    void update_ghosts();

    /// Of a vector that is held in full.
    operator const Vector<double> &() const
    {
      AssertThrow(!is_distributed(), ExcInternalError());
      return values;
    }
    operator Vector<double> &()
    {
      AssertThrow(!is_distributed(), ExcInternalError());
      return values;
    }

  private:
    bool is_distributed() const
    {
      return distribution && distribution->n_mpi_processes() > 1;
    }

    std::size_t n_distributed_held() const
    {
      return distribution->locally_owned_size() +
             distribution->n_ghost_indices();
    }

    std::size_t position(const types::global_dof_index i) const
    {
      const types::global_dof_index k = i - first;
      return k < n_direct ? k : position_of_other(i);
    }

    std::size_t position_of_other(const types::global_dof_index i) const;

    Distribution            distribution;
    Vector<double>          values;
    types::global_dof_index first    = 0; // of the owned
    types::global_dof_index n_direct = 0; // from there in this order
  };
} // namespace Contact

#endif
