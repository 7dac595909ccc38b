/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_result_files_h
#define contact_result_files_h

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "output/profile.h"
#include "output/vtu/vtu_file.h"

namespace Contact
{
  using namespace dealii;

  /// Whether a file in the directory of a case has the name of one that a run
  /// writes, besides log.txt.
  bool is_result_file(const std::string &name);



  /**
   * The files of one run for ParaView and for curves: two series, of the
   * bodies and of the slave surfaces, and the profiles of all surfaces. Both
   * series hold reference positions and the field "displacement", so that
   * "warp by vector" moves both alike; their time is the load factor.
   */
  template<int dim>
  class ResultFiles
  {
  public:
    /// Create the directory. Throws InputError if nothing can be written there.
    ResultFiles(const std::filesystem::path &directory,
                const Discretization<dim>   &discretization);

    /// Remove the series and the tables of an earlier run.
    void remove_series() const;

    /// Remove the increments of an earlier run that is not gone on with, and
    /// what it left to go on from.
    void remove_increments() const;

    /// Remove the files whose names match a regular expression.
    void remove(const std::string &names) const;

    /**
     * Write bodies_000k_B.vtu of increment @p k for each body B, and bodies.pvd
     * anew, which has their names: the grids of class BodyGrids. The forces of
     * contact on the nodes and the equivalent plastic strains at the vertices
     * may be empty.
     */
    void write_bodies(const unsigned int                        k,
                      const double                              load_factor,
                      const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
                      const GhostedVector                      &solution,
                      const GhostedVector       &contact_forces  = {},
                      const std::vector<double> &plastic_strains = {});

    /**
     * Write contact_000k_P.vtu of increment @p k for each contact pair P, and
     * contact.pvd anew: see contact_grid().
     */
    void write_contact(const unsigned int                   k,
                       const double                         load_factor,
                       const std::vector<PairProfile<dim>> &pairs);

    /// Write profile.csv: a line with names and units, then the rows of both
    /// surfaces, "slave" and "master" with the name of the contact pair, if it
    /// has one. Its fields are empty if there is no exact solution.
    void write_profile(const std::vector<PairProfile<dim>> &pairs) const;

    /// Write nodes.csv: see write_nodes() and collect_nodes(). Collective.
    void write_nodes(const GhostedVector &solution,
                     const GhostedVector &contact_forces) const;

    /// The increments written so far, for a restart.
    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &bodies &contact;
    }

    /// Write the series anew.
    void write_series() const;

    /// Write a file by @p write, if this is the first rank. Throws on all.
    void write_first(const std::string                         &file,
                     const std::function<void(std::ostream &)> &write) const;

    const std::filesystem::path directory;

  private:
    /// The files of all increments.
    using Series = std::vector<VtuPart>;

    void write_series(const std::string &name, const Series &series) const;

    /// Write what all ranks have as NAME.vtu, of several ranks as one piece
    /// each with a record NAME.pvtu. Returns the file to open.
    std::string write_pieces(const std::string &name,
                             const VtuGrid     &grid,
                             const double       load_factor) const;

    unsigned int rank() const;

    const Discretization<dim> &discretization;
    Series                     bodies, contact;
  };
} // namespace Contact

#endif
