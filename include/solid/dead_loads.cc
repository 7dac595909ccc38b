/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/dead_loads.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include "base/dimension.h"
#include "parameters/formula.h"

namespace Contact
{
  namespace
  {
    const std::string section = "Boundary conditions/";

    // Parameters are checked before the mesh is known, with all three
    // variables.
    template<int dim>
    std::function<double(const Point<dim> &)>
    function_of_place(const std::string &formula, const std::string &entry)
    {
      try
        {
          return parse_formula<dim>(formula,
                                    Dimension<dim>::coordinates,
                                    section + entry);
        }
      catch (const std::runtime_error &error)
        {
          throw InputError(error.what(),
                           section + entry,
                           "the mesh is plane: write a formula without z");
        }
    }
  } // namespace



  template<int dim>
  DeadLoads<dim>::DeadLoads(const Discretization<dim> &discretization)
    : discretization(discretization)
  {
    for (unsigned int c = 0; c < dim; ++c)
      {
        collect_forces(c);
        collect_densities(c);
      }
    for (const auto &[name, formula] : discretization.boundary.pressure)
      {
        const auto pressure = function_of_place<dim>(formula, "Pressure");
        load_of("Pressure") +=
          integrate_boundary(name,
                             "Pressure",
                             [&](const Point<dim>     &X,
                                 const Tensor<1, dim> &normal) {
                               return -pressure(X) * normal;
                             });
      }
    for (const auto &[entry, load] : loads)
      magnitudes[entry] = load.l1_norm();
  }



  // Forces in the direction c, spread over a boundary and at a point.
  template<int dim>
  void DeadLoads<dim>::collect_forces(const unsigned int c)
  {
    const auto          &boundary  = discretization.boundary;
    const Tensor<1, dim> direction = Point<dim>::unit_vector(c);

    const std::string spread = std::string("Resultant force ") + "xyz"[c];
    for (const auto &[name, force] : boundary.resultant_force[c])
      {
        // The shares add up to the length; of rings, to their area.
        const GhostedVector shares =
          integrate_boundary(name,
                             spread,
                             [&](const Point<dim> &, const Tensor<1, dim> &) {
                               return direction;
                             });
        const double area = shares.sum();
        if (!(area > 0))
          throw InputError("the boundary '" + name +
                             "' has no area that a force could be spread over",
                           section + spread,
                           "name one off the axis of symmetry");
        load_of(spread).add(force / area, shares);
      }

    const std::string nodal = std::string("Force ") + "xyz"[c];
    for (const auto &[name, force] : boundary.force[c])
      {
        if (boundary.rigid.count(name) > 0)
          continue; // it turns with the boundary
        const Place<dim> &place = discretization.place(name, section + nodal);
        for (const auto &[dof, weight] : place.unknowns[c])
          {
            load_of(nodal)[dof] += force * weight;
            nodal_forces.insert(dof);
          }
        loaded_cells.insert(place.coarse_cells.begin(),
                            place.coarse_cells.end());
      }
  }



  // Forces in the direction c by area and by volume, as formulas.
  template<int dim>
  void DeadLoads<dim>::collect_densities(const unsigned int c)
  {
    const auto          &boundary  = discretization.boundary;
    const Tensor<1, dim> direction = Point<dim>::unit_vector(c);

    const std::string traction = std::string("Traction ") + "xyz"[c];
    for (const auto &[name, formula] : boundary.traction[c])
      {
        const auto value = function_of_place<dim>(formula, traction);
        load_of(traction) +=
          integrate_boundary(name,
                             traction,
                             [&](const Point<dim> &X, const Tensor<1, dim> &) {
                               return value(X) * direction;
                             });
      }

    const std::string body_force = std::string("Body force ") + "xyz"[c];
    for (const auto &[name, formula] : boundary.body_force[c])
      {
        const auto value = function_of_place<dim>(formula, body_force);
        load_of(body_force) +=
          integrate_body(discretization.mesh.body(name, section + body_force),
                         [&](const Point<dim> &X) {
                           return value(X) * direction;
                         });
      }
  }



  // The integral of a traction times the shape functions, from all ranks.
  template<int dim>
  GhostedVector
  DeadLoads<dim>::integrate_boundary(const std::string   &name,
                                     const std::string   &entry,
                                     const TractionField &traction)
  {
    const auto &ids = discretization.mesh.boundary(name, section + entry);
    loaded.insert(ids.begin(), ids.end());

    hp::FEFaceValues<dim> hp_values(discretization.mapping,
                                    discretization.fe,
                                    make_face_quadrature(discretization.mesh,
                                                         discretization.degree),
                                    update_values | update_JxW_values |
                                      update_quadrature_points |
                                      update_normal_vectors);
    GhostedVector         integrals(discretization.distribution);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->is_locally_owned() && cell->face(f)->at_boundary() &&
            ids.count(cell->face(f)->boundary_id()) > 0)
          {
            hp_values.reinit(cell, f);
            const auto &values = hp_values.get_present_fe_values();
            add_integrals(
              values,
              cell,
              [&](const unsigned int q) {
                return traction(values.quadrature_point(q),
                                values.normal_vector(q));
              },
              integrals);
          }
    integrals.compress_add();
    return integrals;
  }



  // The same of a body. A constant force times the radius times the shape
  // functions is integrated exactly on straight cells.
  template<int dim>
  GhostedVector
  DeadLoads<dim>::integrate_body(const types::material_id body,
                                 const BodyForceField    &force) const
  {
    hp::QCollection<dim> quadrature;
    for (unsigned int k = 0; k < discretization.fe.size(); ++k)
      quadrature.push_back(
        discretization.fe[k]
          .reference_cell()
          .template get_gauss_type_quadrature<dim>(discretization.degree + 1));
    hp::FEValues<dim> hp_values(discretization.mapping,
                                discretization.fe,
                                quadrature,
                                update_values | update_JxW_values |
                                  update_quadrature_points);
    GhostedVector     integrals(discretization.distribution);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() == body)
        {
          hp_values.reinit(cell);
          const auto &values = hp_values.get_present_fe_values();
          add_integrals(
            values,
            cell,
            [&](const unsigned int q) {
              return force(values.quadrature_point(q));
            },
            integrals);
        }
    integrals.compress_add();
    return integrals;
  }



  template<int dim>
  void DeadLoads<dim>::add_integrals(
    const FEValuesBase<dim>                                   &values,
    const typename DoFHandler<dim>::active_cell_iterator      &cell,
    const std::function<Tensor<1, dim>(const unsigned int q)> &density,
    GhostedVector                                             &integrals) const
  {
    const auto                          &fe = values.get_fe();
    std::vector<types::global_dof_index> dofs(values.dofs_per_cell);
    cell->get_dof_indices(dofs);
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const Tensor<1, dim> force =
          values.JxW(q) *
          discretization.circumference(values.quadrature_point(q)) * density(q);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          integrals[dofs[i]] += force[fe.system_to_component_index(i).first] *
                                values.shape_value(i, q);
      }
  }



  template<int dim>
  GhostedVector &DeadLoads<dim>::load_of(const std::string &entry)
  {
    GhostedVector &load = loads[entry];
    if (load.size() == 0)
      load = GhostedVector(discretization.distribution);
    return load;
  }



  template<int dim>
  GhostedVector DeadLoads<dim>::at(const double load_factor) const
  {
    GhostedVector sum(discretization.distribution);
    for (const auto &[entry, load] : loads)
      sum.add(discretization.factor(entry, load_factor), load);
    return sum;
  }



  template<int dim>
  double DeadLoads<dim>::magnitude(const double load_factor) const
  {
    double sum = discretization.rigid_load(load_factor);
    for (const auto &[entry, magnitude] : magnitudes)
      sum += std::abs(discretization.factor(entry, load_factor)) * magnitude;
    return sum;
  }



  template class DeadLoads<2>;
  template class DeadLoads<3>;
} // namespace Contact
