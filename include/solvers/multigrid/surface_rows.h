/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_rows_h
#define contact_surface_rows_h

#include <deal.II/lac/affine_constraints.h>

#include <map>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /// Unknowns of surfaces, each a sum over others: lines of contact, or fine
  /// unknowns by coarse ones.
  class SurfaceRows
  {
  public:
    using Dof  = types::global_dof_index;
    using Dofs = std::vector<Dof>;
    using Sum  = std::map<Dof, double>;

    SurfaceRows() = default;

    /// The lines of those of @p eliminated in closed @p constraints that are
    /// among @p owned, whatever their inhomogeneities.
    SurfaceRows(const Dofs                      &eliminated,
                const AffineConstraints<double> &constraints,
                const IndexSet                  &owned);

    Dofs                      dofs;
    std::vector<unsigned int> ends; // of each in the following
    Dofs                      others;
    std::vector<double>       factors;

    unsigned int size() const
    {
      return dofs.size();
    }
    unsigned int begin(const unsigned int row) const
    {
      return row == 0 ? 0 : ends[row - 1];
    }
    unsigned int end(const unsigned int row) const
    {
      return ends[row];
    }

    Dofs others_of(const unsigned int row) const
    {
      return {others.begin() + begin(row), others.begin() + end(row)};
    }

    /// Keep room for as many rows and entries as others have.
    void reserve(const SurfaceRows &rows);

    /// Add an entry of the next row, and end this.
    void add_entry(const Dof other, const double factor)
    {
      others.push_back(other);
      factors.push_back(factor);
    }
    void end_row(const Dof dof)
    {
      dofs.push_back(dof);
      ends.push_back(others.size());
    }
    void add_row(const Dof dof, const Sum &sum);

    /// Add rows of others.
    void add_row(const SurfaceRows &from, const unsigned int row);
    void append(const SurfaceRows &rows);

    /// In ascending order. Of several rows of an unknown the first one of those
    /// with the fewest entries stays.
    void sort();

    /// The row of an unknown, among rows in ascending order, or
    /// numbers::invalid_unsigned_int.
    unsigned int find(const Dof dof) const;
    bool         has(const Dof dof) const
    {
      return find(dof) != numbers::invalid_unsigned_int;
    }

    SurfaceRows owned_by(const IndexSet &owned) const;

    /// Those of all ranks, one rank behind the other. Collective.
    SurfaceRows of_all_ranks(const MPI_Comm communicator) const;

    bool has_pattern_of(const SurfaceRows &rows) const
    {
      return dofs == rows.dofs && ends == rows.ends && others == rows.others;
    }
    bool operator==(const SurfaceRows &rows) const
    {
      return has_pattern_of(rows) && factors == rows.factors;
    }

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &dofs &ends &others &factors;
    }
  };
} // namespace Contact

#endif
