/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_dead_loads_h
#define contact_dead_loads_h

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <map>
#include <set>
#include <string>

#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The forces that do not follow the bodies: on points, on boundaries and in
   * bodies, each entry of the boundary conditions with its history. What is
   * given by a formula is integrated over the undeformed bodies, times the
   * circumference. All ranks know all of them.
   */
  template<int dim>
  class DeadLoads
  {
  public:
    /// Throws InputError if the mesh has no such group. Collective.
    explicit DeadLoads(const Discretization<dim> &discretization);

    /// The forces under a load factor [N per mm of thickness; rings and
    /// volumes: N].
    GhostedVector at(const double load_factor) const;

    /// The sum of all their magnitudes under a load factor, in the same unit,
    /// and of those on rigid boundaries: what is small against it is small.
    double magnitude(const double load_factor) const;

    /// Whether a nodal force acts on this unknown.
    bool carries_nodal_force(const types::global_dof_index dof) const
    {
      return nodal_forces.count(dof) > 0;
    }

    /// Whether a force acts between the nodes of a cell of the coarse mesh.
    bool carries_inner_force(const types::coarse_cell_id cell) const
    {
      return loaded_cells.count(cell) > 0;
    }

    /// Whether a resultant force, a pressure or a traction acts on a boundary.
    bool is_loaded(const types::boundary_id id) const
    {
      return loaded.count(id) > 0;
    }

  private:
    void collect_forces(const unsigned int c);
    void collect_densities(const unsigned int c);

    /// Traction [MPa] by place and outward normal.
    using TractionField =
      std::function<Tensor<1, dim>(const Point<dim> &, const Tensor<1, dim> &)>;

    /// The forces of a traction on the boundary @p name that @p entry names.
    GhostedVector integrate_boundary(const std::string   &name,
                                     const std::string   &entry,
                                     const TractionField &traction);

    /// Force by volume [N/mm^3] by place.
    using BodyForceField = std::function<Tensor<1, dim>(const Point<dim> &)>;

    GhostedVector integrate_body(const types::material_id body,
                                 const BodyForceField    &force) const;

    /// Add the integrals of a density times the shape functions of a cell, over
    /// the cell or one of its faces.
    void add_integrals(
      const FEValuesBase<dim>                                   &values,
      const typename DoFHandler<dim>::active_cell_iterator      &cell,
      const std::function<Tensor<1, dim>(const unsigned int q)> &density,
      GhostedVector &integrals) const;

    /// The sum of the magnitudes of the forces of an entry.
    GhostedVector &load_of(const std::string &entry);

    const Discretization<dim>           &discretization;
    std::map<std::string, GhostedVector> loads;      // at their full values
    std::map<std::string, double>        magnitudes; // of them
    std::set<types::global_dof_index>    nodal_forces;
    std::set<types::coarse_cell_id>      loaded_cells;
    std::set<types::boundary_id>         loaded;
  };
} // namespace Contact

#endif
