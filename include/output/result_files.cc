/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/result_files.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <regex>

#include "base/all_ranks.h"
#include "base/files.h"
#include "output/contact_grid.h"
#include "output/node_table.h"
#include "output/vtu/body_grids.h"

namespace Contact
{
  namespace
  {
    // The names of files as regular expressions.
    const std::string series_and_tables =
      "(bodies|contact)[.]pvd|(history|profile|nodes)[.]csv";
    const std::string of_increments =
      "(bodies|contact)_[0-9._]+p?vtu|restart[0-9._]*bin";



    /// The unit of a force in the name of a column: one by thickness, or of a
    /// whole ring, or in 3-D.
    template<int dim>
    std::string force_unit(const Discretization<dim> &discretization)
    {
      return discretization.per_thickness().empty() ? "N" : "N_per_mm";
    }



    /// The columns of a profile, and their values in a row.
    std::string profile_columns(const Discretization<2> &discretization)
    {
      return "arc_length_mm,deformed_arc_length_mm,X_mm,Y_mm,"
             "displacement_x_mm,displacement_y_mm,pressure_MPa,shear_MPa,"
             "nodal_force_" +
             force_unit(discretization) + ",gap_mm,slip_mm";
    }

    std::vector<double> profile_values(const ProfileRow<2> &row)
    {
      return {row.arc_length,
              row.deformed_arc_length,
              row.X[0],
              row.X[1],
              row.u[0],
              row.u[1],
              row.pressure,
              row.shear,
              row.nodal_force,
              row.gap,
              row.slip};
    }

    std::string profile_columns(const Discretization<3> &)
    {
      return "X_mm,Y_mm,Z_mm,displacement_x_mm,displacement_y_mm,"
             "displacement_z_mm,pressure_MPa,shear_x_MPa,shear_y_MPa,"
             "shear_z_MPa,nodal_force_N,gap_mm,slip_x_mm,slip_y_mm,slip_z_mm";
    }

    std::vector<double> profile_values(const ProfileRow<3> &row)
    {
      std::vector<double> values;
      const auto          add = [&](const Tensor<1, 3> &vector) {
        for (unsigned int c = 0; c < 3; ++c)
          values.push_back(vector[c]);
      };
      add(row.X);
      add(row.u);
      values.push_back(row.pressure);
      add(row.shear_vector);
      values.push_back(row.nodal_force);
      values.push_back(row.gap);
      add(row.slip_vector);
      return values;
    }



    /// The file of a part of an increment, without its ending.
    std::string part_name(const std::string &series,
                          const unsigned int k,
                          const unsigned int part)
    {
      return series + '_' + Utilities::int_to_string(k, 4) + '_' +
             std::to_string(part);
    }



    template<int dim>
    void write_rows(std::ostream                       &out,
                    const std::string                  &surface,
                    const std::vector<ProfileRow<dim>> &rows)
    {
      for (const ProfileRow<dim> &row : rows)
        {
          out << surface;
          for (const double value : profile_values(row))
            out << ',' << value + 0.; // no "-0"
          out << ',' << row.status << ',' << row.extrapolated_pressure << ','
              << row.true_pressure << '\n';
        }
    }
  } // namespace



  bool is_result_file(const std::string &name)
  {
    return std::regex_match(name,
                            std::regex(series_and_tables + "|" + of_increments +
                                       "|summary[.]json|parameters[.]prm"));
  }



  template<int dim>
  ResultFiles<dim>::ResultFiles(const std::filesystem::path &directory,
                                const Discretization<dim>   &discretization)
    : directory(directory)
    , discretization(discretization)
  {
    create_output_directory(directory);
  }



  // Files of an earlier run would look as if they were of this one.
  template<int dim>
  void ResultFiles<dim>::remove_series() const
  {
    remove(series_and_tables);
  }



  template<int dim>
  void ResultFiles<dim>::remove_increments() const
  {
    remove(of_increments);
  }



  template<int dim>
  void ResultFiles<dim>::remove(const std::string &names) const
  {
    const std::regex                   name(names);
    std::vector<std::filesystem::path> found;
    if (rank() == 0)
      for (const auto &file : std::filesystem::directory_iterator(directory))
        if (std::regex_match(file.path().filename().string(), name))
          found.push_back(file.path());
    for (const auto &file : found)
      std::filesystem::remove(file);
  }



  template<int dim>
  unsigned int ResultFiles<dim>::rank() const
  {
    return Utilities::MPI::this_mpi_process(discretization.communicator);
  }



  template<int dim>
  void ResultFiles<dim>::write_first(
    const std::string                         &file,
    const std::function<void(std::ostream &)> &write) const
  {
    ++discretization.counters.files;
    write_on_first_rank(discretization.communicator, directory / file, write);
  }



  template<int dim>
  void ResultFiles<dim>::write_series(const std::string &name,
                                      const Series      &series) const
  {
    if (!series.empty())
      write_first(name + ".pvd",
                  [&](std::ostream &out) { write_pvd(series, out); });
  }



  template<int dim>
  void ResultFiles<dim>::write_series() const
  {
    write_series("bodies", bodies);
    write_series("contact", contact);
  }



  template<int dim>
  void ResultFiles<dim>::write_bodies(
    const unsigned int                        k,
    const double                              load_factor,
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
    const GhostedVector                      &solution,
    const GhostedVector                      &contact_forces,
    const std::vector<double>                &plastic_strains)
  {
    const BodyGrids<dim> grids(discretization,
                               vertex_stresses,
                               plastic_strains,
                               solution,
                               contact_forces);
    for (types::material_id id = 0; id < discretization.mesh.bodies.size();
         ++id)
      bodies.push_back({load_factor,
                        id,
                        discretization.mesh.body_name(id),
                        write_pieces(part_name("bodies", k, id),
                                     grids.grid(id),
                                     load_factor)});
    write_series("bodies", bodies);
  }



  template<int dim>
  std::string ResultFiles<dim>::write_pieces(const std::string &name,
                                             const VtuGrid     &grid,
                                             const double load_factor) const
  {
    const MPI_Comm communicator = discretization.communicator;
    const bool is_alone = Utilities::MPI::n_mpi_processes(communicator) == 1;
    const std::string piece =
      name + (is_alone ? "" : "." + Utilities::int_to_string(rank(), 4)) +
      ".vtu";
    const bool is_empty = grid.types.empty() && !is_alone;
    ++discretization.counters.files;
    on_all_ranks(communicator, [&]() {
      if (!is_empty)
        write_file(directory / piece, [&](std::ostream &out) {
          write_vtu(grid, load_factor, out);
        });
    });
    if (is_alone)
      return piece;
    std::vector<std::string> pieces;
    for (const std::string &of_rank :
         Utilities::MPI::all_gather(communicator,
                                    is_empty ? std::string() : piece))
      if (!of_rank.empty())
        pieces.push_back(of_rank);
    write_first(name + ".pvtu",
                [&](std::ostream &out) { write_pvtu(grid, pieces, out); });
    return name + ".pvtu";
  }



  template<int dim>
  void
  ResultFiles<dim>::write_contact(const unsigned int k,
                                  const double       load_factor,
                                  const std::vector<PairProfile<dim>> &pairs)
  {
    for (unsigned int part = 0; part < pairs.size(); ++part)
      {
        const std::string file = part_name("contact", k, part) + ".vtu";
        write_first(file, [&](std::ostream &out) {
          write_vtu(contact_grid(pairs[part]), load_factor, out);
        });
        const std::string &name = pairs[part].name;
        contact.push_back(
          {load_factor, part, name.empty() ? "Contact" : name, file});
      }
    write_series("contact", contact);
  }



  template<int dim>
  void ResultFiles<dim>::write_nodes(const GhostedVector &solution,
                                     const GhostedVector &contact_forces) const
  {
    const auto rows = collect_nodes(discretization, solution, contact_forces);
    write_first("nodes.csv", [&](std::ostream &out) {
      Contact::write_nodes(out,
                           discretization.mesh,
                           rows,
                           force_unit(discretization));
    });
  }



  template<int dim>
  void ResultFiles<dim>::write_profile(
    const std::vector<PairProfile<dim>> &pairs) const
  {
    write_first("profile.csv", [&](std::ostream &out) {
      out.precision(12);
      out << "surface," << profile_columns(discretization)
          << ",status_0_open_1_slip_2_stick,extrapolated_pressure_MPa,"
             "true_pressure_MPa\n";
      for (const PairProfile<dim> &contact_pair : pairs)
        {
          const std::string name =
            contact_pair.name.empty() ? "" : " " + contact_pair.name;
          write_rows(out, "slave" + name, contact_pair.slave_rows);
          write_rows(out, "master" + name, contact_pair.master_rows);
        }
    });
  }

  template class ResultFiles<2>;
  template class ResultFiles<3>;
} // namespace Contact
