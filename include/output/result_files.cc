/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/result_files.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <deal.II/numerics/data_out.h>

#include <algorithm>
#include <regex>

#include "base/all_ranks.h"
#include "base/files.h"
#include "output/contact_patches.h"
#include "output/node_table.h"
#include "output/vertex_fields.h"

namespace Contact
{
  namespace
  {
    using DataComponentInterpretation::component_is_part_of_vector;

    /// The flags of all VTU files: no date, so that equal runs give equal
    /// files, cells of the given degree, and a compression that takes a sixth
    /// of the time of the best one.
    DataOutBase::VtkFlags vtk_flags(const unsigned int k,
                                    const double       load_factor,
                                    const unsigned int degree,
                                    const std::string &force_unit = "N/mm")
    {
      DataOutBase::VtkFlags flags(load_factor, k);
      flags.print_date_and_time = false;
      // The enumeration has another name since deal.II 9.5.
      flags.compression_level = decltype(flags.compression_level)::best_speed;
      flags.write_higher_order_cells = degree > 1;
      flags.physical_units           = {{"displacement", "mm"},
                                        {"contact_force", force_unit},
                                        {"stress_xx", "MPa"},
                                        {"stress_yy", "MPa"},
                                        {"stress_zz", "MPa"},
                                        {"stress_xy", "MPa"},
                                        {"stress_xz", "MPa"},
                                        {"stress_yz", "MPa"},
                                        {"von_mises", "MPa"},
                                        {"pressure", "MPa"},
                                        {"shear", "MPa"},
                                        {"gap", "mm"},
                                        {"slip", "mm"}};
      return flags;
    }



    /// The columns of a profile, and their values in a row.
    std::string profile_columns(const ProfileRow<2> &)
    {
      return "arc_length_mm,deformed_arc_length_mm,X_mm,Y_mm,"
             "displacement_x_mm,displacement_y_mm,pressure_MPa,shear_MPa,"
             "nodal_force_N_per_mm,gap_mm,slip_mm";
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

    std::string profile_columns(const ProfileRow<3> &)
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
          out << ',' << row.status << ',' << row.extrapolated_pressure << '\n';
        }
    }
  } // namespace



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
    remove("(bodies|contact)[.]pvd|(history|profile|nodes)[.]csv");
  }



  template<int dim>
  void ResultFiles<dim>::remove_increments() const
  {
    remove("(bodies|contact)_[0-9.]+p?vtu|restart[0-9._]*bin");
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
      write_first(name + ".pvd", [&](std::ostream &out) {
        DataOutBase::write_pvd_record(out, series);
      });
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
    const auto u = discretization.distributed(solution);

    const auto    &triangulation = discretization.mesh.triangulation;
    Vector<double> body(triangulation.n_active_cells());
    for (const auto &cell : triangulation.active_cell_iterators())
      body[cell->active_cell_index()] = cell->material_id();
    const VertexFields vertex_fields(discretization,
                                     vertex_stresses,
                                     plastic_strains);

    DataOut<dim> data_out;
    data_out.attach_dof_handler(discretization.dof_handler);
    data_out.set_flags(vtk_flags(k,
                                 load_factor,
                                 discretization.degree,
                                 "N" + discretization.per_thickness()));
    const auto add_vector = [&](const DistributedVector &values,
                                const std::string       &name) {
      data_out.add_data_vector(discretization.dof_handler,
                               values,
                               std::vector<std::string>(dim, name),
                               {std::size_t(dim), component_is_part_of_vector});
    };
    add_vector(u, "displacement");
    DistributedVector forces;
    if (contact_forces.size() > 0)
      {
        forces = discretization.distributed(contact_forces);
        add_vector(forces, "contact_force");
      }
    vertex_fields.attach(data_out);
    data_out.add_data_vector(body, "body", DataOut<dim>::type_cell_data);
    Vector<double> converged(triangulation.n_active_cells());
    converged = 1;
    data_out.add_data_vector(converged,
                             "converged",
                             DataOut<dim>::type_cell_data);
    data_out.build_patches(discretization.mapping,
                           discretization.degree,
                           DataOut<dim>::curved_inner_cells);

    bodies.emplace_back(load_factor,
                        write_pieces("bodies_" + Utilities::int_to_string(k, 4),
                                     data_out));
    write_series("bodies", bodies);
  }



  template<int dim>
  std::string
  ResultFiles<dim>::write_pieces(const std::string           &name,
                                 const DataOutInterface<dim> &data) const
  {
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(discretization.communicator);
    const auto piece = [&](const unsigned int r) {
      return name + (n_ranks > 1 ? "." + Utilities::int_to_string(r, 4) : "") +
             ".vtu";
    };
    ++discretization.counters.files;
    on_all_ranks(discretization.communicator, [&]() {
      write_file(directory / piece(rank()),
                 [&](std::ostream &out) { data.write_vtu(out); });
    });
    if (n_ranks == 1)
      return piece(0);
    write_first(name + ".pvtu", [&](std::ostream &out) {
      std::vector<std::string> pieces;
      for (unsigned int r = 0; r < n_ranks; ++r)
        pieces.push_back(piece(r));
      data.write_pvtu_record(out, pieces);
    });
    return name + ".pvtu";
  }



  template<int dim>
  void
  ResultFiles<dim>::write_contact(const unsigned int k,
                                  const double       load_factor,
                                  const std::vector<PairProfile<dim>> &pairs)
  {
    const std::string file =
      "contact_" + Utilities::int_to_string(k, 4) + ".vtu";
    write_first(file, [&](std::ostream &out) {
      DataOutBase::write_vtu(
        contact_patches(pairs),
        contact_fields<dim>(),
        contact_vectors<dim>(),
        vtk_flags(k, load_factor, contact_cell_degree(*pairs.front().slave)),
        out);
    });
    contact.emplace_back(load_factor, file);
    write_series("contact", contact);
  }



  template<int dim>
  void ResultFiles<dim>::write_nodes(const GhostedVector &solution,
                                     const GhostedVector &contact_forces) const
  {
    const auto rows = collect_nodes(discretization, solution, contact_forces);
    write_first("nodes.csv", [&](std::ostream &out) {
      Contact::write_nodes(out, discretization.mesh, rows);
    });
  }



  template<int dim>
  void ResultFiles<dim>::write_profile(
    const std::vector<PairProfile<dim>> &pairs) const
  {
    write_first("profile.csv", [&](std::ostream &out) {
      out.precision(12);
      out << "surface," << profile_columns(ProfileRow<dim>())
          << ",status_0_open_1_slip_2_stick,extrapolated_pressure_MPa\n";
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
