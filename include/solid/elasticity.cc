/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/elasticity.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "parameters/formula.h"

namespace Contact
{
  namespace
  {
    template<int dim>
    std::map<types::material_id, std::unique_ptr<CellKernel<dim>>> make_kernels(
      const Discretization<dim>                    &discretization,
      const std::map<types::material_id, Material> &materials,
      const std::map<types::material_id, std::unique_ptr<MaterialLaw>> &laws,
      const Parameters::Solids &parameters)
    {
      std::map<types::material_id, std::unique_ptr<CellKernel<dim>>> kernels;
      for (const auto &[name, body] : discretization.mesh.bodies)
        kernels[body] =
          CellKernel<dim>::create(materials.at(body),
                                  *laws.at(body),
                                  parameters.kinematics.of(name) ==
                                    Parameters::Strains::small,
                                  discretization.axisymmetric);
      return kernels;
    }



    template<int dim>
    std::map<types::material_id, std::function<double(const Point<1> &)>>
    parse_thermal_strains(const Mesh<dim>          &mesh,
                          const Parameters::Solids &parameters)
    {
      const std::string entry = "Solids/Thermal strain";
      std::map<types::material_id, std::function<double(const Point<1> &)>>
        strains;
      for (const auto &[name, history] : parameters.thermal_strain)
        strains[mesh.body(name, entry)] = parse_history(history, entry);
      return strains;
    }



    template<int dim>
    std::set<types::material_id>
    find_enhanced(const Mesh<dim> &mesh, const Parameters::Solids &parameters)
    {
      std::set<types::material_id> enhanced;
      for (const std::string &name : parameters.incompatible_modes)
        enhanced.insert(mesh.body(name, "Solids/Incompatible modes"));
      return enhanced;
    }
  } // namespace



  // Lexicographic, so that it does not depend on the number of ranks which of
  // several equal ones is named.
  template<int dim>
  VolumeRatio<dim> smallest_of_all_ranks(const VolumeRatio<dim> &of_rank,
                                         const MPI_Comm          communicator)
  {
    using Numbers = std::array<double, 2 + dim>; // value, body, X
    Numbers of_this{{of_rank.value, 1. * of_rank.body}};
    for (unsigned int d = 0; d < dim; ++d)
      of_this[2 + d] = of_rank.X[d];
    const auto    of_all  = Utilities::MPI::all_gather(communicator, of_this);
    const Numbers numbers = *std::min_element(of_all.begin(), of_all.end());

    VolumeRatio<dim> smallest{numbers[0],
                              static_cast<types::material_id>(numbers[1]),
                              Point<dim>()};
    for (unsigned int d = 0; d < dim; ++d)
      smallest.X[d] = numbers[2 + d];
    return smallest;
  }



  template<int dim>
  Elasticity<dim>::Elasticity(const Discretization<dim> &discretization,
                              const Parameters::Solids  &parameters)
    : dead_loads(discretization)
    , discretization(discretization)
    , materials(find_materials(discretization.mesh, parameters))
    , laws(make_laws(discretization.mesh.bodies, materials, parameters))
    , enhanced(find_enhanced(discretization.mesh, parameters))
    , kernels(make_kernels(discretization, materials, laws, parameters))
    , projected(
        find_projected(materials, laws, parameters.dilatation, enhanced))
    , thermal_strains(parse_thermal_strains(discretization.mesh, parameters))
    , tables(tabulate_cells(discretization, materials, projected, enhanced))
    , springs(discretization, tables.own)
    , is_plane_stress(parameters.symmetry == Parameters::Symmetry::plane_stress)
  {
    for (auto *part : {&tables.own, &tables.neighbors})
      for (CellTable<dim> &cell : *part)
        {
          const MaterialLaw &law = *laws.at(cell.body);
          cell.kernel            = kernels.at(cell.body).get();
          cell.is_special = !law.is_linear() || !cell.stress_modes.empty();
          cell.history.resize(cell.JxW.size() * law.n_history());
        }
  }



  template<int dim>
  GhostedVector Elasticity<dim>::loads(const GhostedVector &u,
                                       const double         load_factor) const
  {
    GhostedVector load = dead_loads.at(load_factor);
    discretization.add_rigid_loads(u, load_factor, load);
    return load;
  }



  // With the strain of a stretch 1 + e in large displacement: such a body is
  // without stress where it is longer by e.
  template<int dim>
  void Elasticity<dim>::set_thermal_strain(const double from, const double to)
  {
    if (thermal_strains.empty())
      return;
    for (auto *part : {&tables.own, &tables.neighbors})
      for (CellTable<dim> &cell : *part)
        if (const auto found = thermal_strains.find(cell.body);
            found != thermal_strains.end())
          {
            const auto at = [&](const double load_factor) {
              const double e = found->second(Point<1>(load_factor));
              if (e <= -1)
                throw InputError("a body would shrink to nothing at the load "
                                 "factor " +
                                   brief(load_factor),
                                 "entry 'Solids/Thermal strain'",
                                 "a thermal strain is above -1");
              return cell.kernel->is_small_strain() ? e : e + 0.5 * e * e;
            };
            ++discretization.counters.thermal_cells;
            cell.thermal_before = from > 0 ? at(from) : 0.;
            cell.thermal        = at(to);
          }
    present_thermal_forces =
      internal_forces(GhostedVector(discretization.distribution)).l1_norm();
    ++n_heats;
  }



  template<int dim>
  void Elasticity<dim>::begin_first_step()
  {
    tangents_are_of_start =
      !thermal_strains.empty() &&
      std::any_of(tables.own.begin(),
                  tables.own.end(),
                  [](const CellTable<dim> &cell) {
                    return cell.thermal != cell.thermal_before &&
                           !cell.kernel->is_small_strain();
                  });
  }



  template<int dim>
  double Elasticity<dim>::cell_forces(const CellTable<dim> &cell,
                                      const Vector<double> &u,
                                      const StressStiffness stress_stiffness,
                                      FullMatrix<double>   *tangent,
                                      Vector<double>       &forces) const
  {
    Counters &counters = discretization.counters;
    counters.large_displacement_cells += !cell.kernel->is_small_strain();
    if (cell.is_special)
      {
        counters.material_cells += cell.stress_modes.empty();
        counters.enhanced_cells += !cell.stress_modes.empty();
        counters.return_mappings += cell.history.empty() ? 0 : cell.JxW.size();
      }
    if (tangent == nullptr || !tangents_are_of_start ||
        cell.thermal == cell.thermal_before || cell.kernel->is_small_strain())
      return cell.kernel->forces(cell, u, stress_stiffness, tangent, forces);

    CellTable<dim> start = cell;
    start.thermal        = cell.thermal_before;
    Vector<double> forces_before(forces.size());
    cell.kernel->forces(start, u, stress_stiffness, tangent, forces_before);
    return cell.kernel->forces(cell, u, stress_stiffness, nullptr, forces);
  }



  template<int dim>
  VolumeRatio<dim>
  Elasticity<dim>::visit_cells(const GhostedVector             &u,
                               const bool                       with_tangent,
                               const CellVisitor               &visitor,
                               const std::vector<unsigned int> *chosen,
                               const StressStiffness stress_stiffness) const
  {
    FullMatrix<double>  tangent;
    FullMatrix<double> *wanted = with_tangent ? &tangent : nullptr;
    Vector<double>      forces, of_cell;
    VolumeRatio<dim>    smallest;
    const unsigned int  n_visits = chosen ? chosen->size() : n_cells();
    for (unsigned int k = 0; k < n_visits; ++k)
      {
        ++discretization.counters.cell_forces;
        discretization.counters.cell_tangents += with_tangent;
        const CellTable<dim> &cell = tables.own[chosen ? (*chosen)[k] : k];
        const unsigned int    n    = cell.dofs.size();
        forces.reinit(n);
        if (with_tangent)
          tangent.reinit(n, n);
        u.extract(cell.dofs, of_cell);
        const double ratio =
          cell_forces(cell, of_cell, stress_stiffness, wanted, forces);
        if (ratio < smallest.value)
          smallest = {ratio, cell.body, cell.centre};
        springs.add_springs(cell, u, wanted, forces);
        visitor(cell.dofs, tangent, forces);
      }
    return smallest;
  }



  template<int dim>
  void Elasticity<dim>::add_loads(const GhostedVector &u,
                                  const double         load_factor,
                                  GhostedVector       &rhs) const
  {
    const auto load = loads(u, load_factor);
    for (const auto i : discretization.dof_handler.locally_owned_dofs())
      if (load[i] != 0)
        discretization.constraints.distribute_local_to_global(i, load[i], rhs);
  }



  // Bodies at rest exert nothing.
  template<int dim>
  VolumeRatio<dim> Elasticity<dim>::subtract_forces(const GhostedVector &u,
                                                    GhostedVector &rhs) const
  {
    if (springs.held().empty() && present_thermal_forces == 0 && u.all_zero())
      return VolumeRatio<dim>();
    Vector<double> of_cell;
    return visit_cells(u,
                       /*with_tangent=*/false,
                       [&](const std::vector<types::global_dof_index> &dofs,
                           const FullMatrix<double> &,
                           const Vector<double> &forces) {
                         of_cell.reinit(forces.size());
                         of_cell.add(-1, forces);
                         discretization.constraints
                           .distribute_local_to_global(of_cell, dofs, rhs);
                       });
  }



  template<int dim>
  VolumeRatio<dim>
  Elasticity<dim>::assemble(const GhostedVector  &u,
                            const double          load_factor,
                            GhostedVector        &rhs,
                            SparseMatrix<double> *matrix,
                            const StressStiffness stress_stiffness) const
  {
    add_loads(u, load_factor, rhs);
    if (matrix == nullptr)
      return subtract_forces(u, rhs);

    Vector<double>  of_cell;
    Vector<double> &whole = rhs; // of one rank
    return visit_cells(
      u,
      /*with_tangent=*/true,
      [&](const std::vector<types::global_dof_index> &dofs,
          const FullMatrix<double>                   &tangent,
          const Vector<double>                       &forces) {
        of_cell.reinit(forces.size());
        of_cell.add(-1, forces);
        discretization.constraints.distribute_local_to_global(tangent,
                                                              of_cell,
                                                              dofs,
                                                              *matrix,
                                                              whole);
      },
      nullptr,
      stress_stiffness);
  }



  template<int dim>
  GhostedVector Elasticity<dim>::internal_forces(
    const GhostedVector             &u,
    const std::vector<unsigned int> *chosen) const
  {
    GhostedVector forces(discretization.distribution);
    visit_cells(
      u,
      /*with_tangent=*/false,
      [&](const std::vector<types::global_dof_index> &dofs,
          const FullMatrix<double> &,
          const Vector<double> &of_cell) { forces.add(dofs, of_cell); },
      chosen);
    forces.compress_add();
    return forces;
  }



  template<int dim>
  GhostedVector
  Elasticity<dim>::forces(const GhostedVector             &u,
                          const double                     load_factor,
                          const std::vector<unsigned int> *chosen) const
  {
    GhostedVector forces = internal_forces(u, chosen);
    forces -= loads(u, load_factor);
    return forces;
  }



  template<int dim>
  std::vector<unsigned int>
  Elasticity<dim>::cells_at(const GhostedVector &v) const
  {
    std::vector<unsigned int> chosen;
    for (unsigned int c = 0; c < n_cells(); ++c)
      if (const auto &dofs = dofs_of_cell(c);
          std::any_of(dofs.begin(), dofs.end(), [&v](const auto dof) {
            return v[dof] != 0;
          }))
        chosen.push_back(c);
    return chosen;
  }



  template<int dim>
  std::vector<std::vector<SymmetricTensor<2, 3>>>
  Elasticity<dim>::stresses(const GhostedVector &u) const
  {
    std::vector<std::vector<SymmetricTensor<2, 3>>> stresses(
      discretization.mesh.triangulation.n_active_cells());
    for (const auto *part : {&tables.own, &tables.neighbors})
      for (const CellTable<dim> &cell : *part)
        stresses[cell.active_index] = stresses_in(cell, u);
    return stresses;
  }



  template<int dim>
  std::vector<SymmetricTensor<2, 3>>
  Elasticity<dim>::stresses_in(const CellTable<dim> &cell,
                               const GhostedVector  &u) const
  {
    auto stresses = cell.kernel->stresses(cell, u.extract(cell.dofs));
    if (is_plane_stress)
      for (SymmetricTensor<2, 3> &stress : stresses)
        stress[2][2] = 0;
    return stresses;
  }



  // The tables are in the order of the active cells.
  template<int dim>
  std::vector<SymmetricTensor<2, 3>>
  Elasticity<dim>::stresses(const unsigned int   active_index,
                            const GhostedVector &u) const
  {
    for (const auto *part : {&tables.own, &tables.neighbors})
      {
        const auto cell = std::lower_bound(part->begin(),
                                           part->end(),
                                           active_index,
                                           [](const CellTable<dim> &table,
                                              const unsigned int    index) {
                                             return table.active_index < index;
                                           });
        if (cell != part->end() && cell->active_index == active_index)
          return stresses_in(*cell, u);
      }
    Assert(false, ExcMessage("The cell is of another rank."));
    return {};
  }



  template<int dim>
  void Elasticity<dim>::add_internal_forces(const types::material_id body,
                                            const double             factor,
                                            const GhostedVector     &u,
                                            GhostedVector &forces) const
  {
    Vector<double> of_cell;
    for (const CellTable<dim> &cell : tables.own)
      if (cell.body == body)
        {
          of_cell.reinit(cell.dofs.size());
          cell_forces(cell,
                      u.extract(cell.dofs),
                      StressStiffness::with,
                      nullptr,
                      of_cell);
          for (unsigned int i = 0; i < cell.dofs.size(); ++i)
            forces[cell.dofs[i]] += factor * of_cell[i];
        }
  }



  template<int dim>
  void Elasticity<dim>::add_couplings(DynamicSparsityPattern &pattern) const
  {
    for (const CellTable<dim> &cell : tables.own)
      discretization.constraints.add_entries_local_to_global(
        cell.dofs,
        pattern,
        /*keep_constrained_entries=*/false);
  }

  template VolumeRatio<2> smallest_of_all_ranks(const VolumeRatio<2> &,
                                                const MPI_Comm);
  template class Elasticity<2>;
  template VolumeRatio<3> smallest_of_all_ranks(const VolumeRatio<3> &,
                                                const MPI_Comm);
  template class Elasticity<3>;
} // namespace Contact
