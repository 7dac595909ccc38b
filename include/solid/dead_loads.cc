/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/dead_loads.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include "parameters/formula.h"

namespace Contact
{
  namespace
  {
    const std::string section = "Boundary conditions/";
  }



  DeadLoads::DeadLoads(const Discretization &discretization)
    : discretization(discretization)
  {
    for (const unsigned int c : {0, 1})
      {
        collect_forces(c);
        collect_densities(c);
      }
    for (const auto &[name, formula] : discretization.boundary.pressure)
      {
        const auto pressure =
          parse_formula<2>(formula, "x,y", section + "Pressure");
        load_of("Pressure") +=
          integrate_boundary(name,
                             "Pressure",
                             [&](const Point<2>     &X,
                                 const Tensor<1, 2> &normal) {
                               return -pressure(X) * normal;
                             });
      }
  }



  // Forces in the direction c, spread over a boundary and on a point.
  void DeadLoads::collect_forces(const unsigned int c)
  {
    const auto        &boundary  = discretization.boundary;
    const Tensor<1, 2> direction = Point<2>::unit_vector(c);

    const std::string spread = std::string("Resultant force ") + "xy"[c];
    for (const auto &[name, force] :
         c == 0 ? boundary.resultant_force_x : boundary.resultant_force_y)
      {
        // The shares add up to the length; of rings, to their area.
        const Vector<double> shares =
          integrate_boundary(name,
                             spread,
                             [&](const Point<2> &, const Tensor<1, 2> &) {
                               return direction;
                             });
        const double area = shares.mean_value() * shares.size();
        if (!(area > 0))
          throw InputError("the boundary '" + name +
                             "' has no area that a force could be spread over",
                           section + spread,
                           "name one off the axis of symmetry");
        load_of(spread).add(force / area, shares);
      }

    const std::string nodal = std::string("Force ") + "xy"[c];
    for (const auto &[name, force] :
         c == 0 ? boundary.force_x : boundary.force_y)
      {
        const auto dof =
          discretization
            .vertex_dofs[discretization.mesh.point(name, section + nodal)][c];
        load_of(nodal)[dof] += force;
        nodal_forces.insert(dof);
      }
  }



  // Forces in the direction c by area and by volume, as formulas.
  void DeadLoads::collect_densities(const unsigned int c)
  {
    const auto        &boundary  = discretization.boundary;
    const Tensor<1, 2> direction = Point<2>::unit_vector(c);

    const std::string traction = std::string("Traction ") + "xy"[c];
    for (const auto &[name, formula] :
         c == 0 ? boundary.traction_x : boundary.traction_y)
      {
        const auto value = parse_formula<2>(formula, "x,y", section + traction);
        load_of(traction) +=
          integrate_boundary(name,
                             traction,
                             [&](const Point<2> &X, const Tensor<1, 2> &) {
                               return value(X) * direction;
                             });
      }

    const std::string body_force = std::string("Body force ") + "xy"[c];
    for (const auto &[name, formula] :
         c == 0 ? boundary.body_force_x : boundary.body_force_y)
      {
        const auto value =
          parse_formula<2>(formula, "x,y", section + body_force);
        load_of(body_force) +=
          integrate_body(discretization.mesh.body(name, section + body_force),
                         [&](const Point<2> &X) {
                           return value(X) * direction;
                         });
      }
  }



  // The integral of a traction times the shape functions, from all ranks.
  Vector<double> DeadLoads::integrate_boundary(const std::string   &name,
                                               const std::string   &entry,
                                               const TractionField &traction)
  {
    const auto &ids = discretization.mesh.boundary(name, section + entry);
    loaded.insert(ids.begin(), ids.end());

    const QGauss<1>     edge_quadrature(discretization.degree + 1);
    hp::FEFaceValues<2> hp_values(discretization.mapping,
                                  discretization.fe,
                                  hp::QCollection<1>(edge_quadrature,
                                                     edge_quadrature),
                                  update_values | update_JxW_values |
                                    update_quadrature_points |
                                    update_normal_vectors);
    Vector<double>      integrals(discretization.dof_handler.n_dofs());
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
    Utilities::MPI::sum(integrals, discretization.communicator, integrals);
    return integrals;
  }



  // The same of a body. A constant force times the radius times the shape
  // functions is integrated exactly on straight cells.
  Vector<double> DeadLoads::integrate_body(const types::material_id body,
                                           const BodyForceField    &force) const
  {
    hp::FEValues<2> hp_values(
      discretization.mapping,
      discretization.fe,
      hp::QCollection<2>(QGauss<2>(discretization.degree + 1),
                         QGaussSimplex<2>(discretization.degree + 1)),
      update_values | update_JxW_values | update_quadrature_points);
    Vector<double> integrals(discretization.dof_handler.n_dofs());
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
    Utilities::MPI::sum(integrals, discretization.communicator, integrals);
    return integrals;
  }



  void DeadLoads::add_integrals(
    const FEValuesBase<2>                                   &values,
    const DoFHandler<2>::active_cell_iterator               &cell,
    const std::function<Tensor<1, 2>(const unsigned int q)> &density,
    Vector<double>                                          &integrals) const
  {
    const auto                          &fe = values.get_fe();
    std::vector<types::global_dof_index> dofs(values.dofs_per_cell);
    cell->get_dof_indices(dofs);
    for (const unsigned int q : values.quadrature_point_indices())
      {
        const Tensor<1, 2> force =
          values.JxW(q) *
          discretization.circumference(values.quadrature_point(q)) * density(q);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          integrals[dofs[i]] += force[fe.system_to_component_index(i).first] *
                                values.shape_value(i, q);
      }
  }



  Vector<double> &DeadLoads::load_of(const std::string &entry)
  {
    Vector<double> &load = loads[entry];
    if (load.size() == 0)
      load.reinit(discretization.dof_handler.n_dofs());
    return load;
  }



  Vector<double> DeadLoads::at(const double load_factor) const
  {
    Vector<double> sum(discretization.dof_handler.n_dofs());
    for (const auto &[entry, load] : loads)
      sum.add(discretization.factor(entry, load_factor), load);
    return sum;
  }



  double DeadLoads::whole() const
  {
    double sum = 0;
    for (const auto &[entry, load] : loads)
      sum += load.l1_norm();
    return sum;
  }
} // namespace Contact
