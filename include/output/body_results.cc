/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/body_results.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/string_utilities.h"
#include "solid/stress_recovery.h"

namespace Contact
{
  namespace
  {
    template<int dim>
    void take(const double value, const Point<dim> &X, Extreme<dim> &largest)
    {
      if (value > largest.value)
        largest = {value, X};
    }



    template<int dim>
    void find_among_ranks(const MPI_Comm communicator, Extreme<dim> &largest)
    {
      std::array<double, 1 + dim> numbers{{largest.value}};
      for (unsigned int d = 0; d < dim; ++d)
        numbers[1 + d] = largest.X[d];
      const auto of_all = Utilities::MPI::all_gather(communicator, numbers);
      numbers           = *std::max_element(of_all.begin(), of_all.end());
      largest.value     = numbers[0];
      for (unsigned int d = 0; d < dim; ++d)
        largest.X[d] = numbers[1 + d];
    }



    // Of the faces of the body by the part of their vertices.
    template<int dim, class IsAbove>
    double share_of_contact(const Discretization<dim> &discretization,
                            const types::material_id   body,
                            const GhostedVector       &contact_forces,
                            const IsAbove             &is_above)
    {
      double sum = 0, above = 0;
      for (const auto &cell :
           discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == body)
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary())
              for (const unsigned int v : face->vertex_indices())
                {
                  const unsigned int vertex     = face->vertex_index(v);
                  bool               in_contact = false;
                  for (const auto dof : discretization.vertex_dofs[vertex])
                    in_contact = in_contact || contact_forces[dof] != 0;
                  if (!in_contact)
                    continue;
                  const double area =
                    face->measure() / face->n_vertices() *
                    discretization.circumference(face->vertex(v));
                  sum += area;
                  above += is_above(vertex) ? area : 0.;
                }
      sum   = Utilities::MPI::sum(sum, discretization.communicator);
      above = Utilities::MPI::sum(above, discretization.communicator);
      return sum > 0 ? above / sum : -1.;
    }
  } // namespace



  template<int dim>
  std::map<std::string, double> BodyResult<dim>::by_name() const
  {
    const auto if_known = [](const bool is_known, const double value) {
      return is_known ? value : std::numeric_limits<double>::quiet_NaN();
    };
    return {{"plastic_strain", if_known(has_stresses, plastic_strain.value)},
            {"von_mises", if_known(has_stresses, von_mises.value)},
            {"von_mises_recovered",
             if_known(has_recovered, recovered_von_mises.value)},
            {"volume_share_above_yield", if_known(has_stresses, volume_share)},
            {"contact_share_above_yield",
             if_known(contact_share >= 0, contact_share)},
            {"strain", if_known(has_strains, strain.value)},
            {"shortening", if_known(has_strains, shortening.value)}};
  }



  template<int dim>
  std::map<std::string, BodyResult<dim>>
  body_results(const ContactModel<dim>                  &model,
               const Parameters::Solids                 &parameters,
               const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
               const std::vector<double>                &plastic_strains,
               const GhostedVector                      &solution,
               const GhostedVector                      &contact_forces)
  {
    using Parameters::MaterialModel;
    const auto communicator = model.discretization->communicator;
    std::map<std::string, BodyResult<dim>> results;
    for (const auto &[name, body] : model.mesh->bodies)
      {
        const bool is_elastic =
          parameters.model_of(name) == MaterialModel::elastic;
        const bool is_large =
          is_elastic && !model.elasticity->is_small_strain(body);
        const auto yield_stress = parameters.yield_stress.find(name);
        const bool may_yield    = yield_stress != parameters.yield_stress.end();
        if (!is_large && !may_yield)
          continue;
        BodyResult<dim> result;
        result.has_stresses = may_yield;
        result.has_strains  = is_large;
        result.has_recovered =
          is_elastic && may_yield && !vertex_stresses.empty();
        double         volume = 0, above = 0;
        Vector<double> u;
        for (const CellTable<dim> &cell : model.elasticity->cells())
          {
            if (cell.body != body)
              continue;
            solution.extract(cell.dofs, u);
            if (is_large)
              for (const auto &E : cell.kernel->strains(cell, u))
                {
                  // No principal strain is beyond the norm.
                  const double bound = E.norm();
                  if (bound <= result.strain.value &&
                      1 - std::sqrt(std::max(0., 1 - 2 * bound)) <=
                        result.shortening.value)
                    continue;
                  const auto   principal = eigenvalues(E);
                  const double least     = principal[2];
                  take(std::max(principal[0], -least),
                       cell.centre,
                       result.strain);
                  take(1 - std::sqrt(std::max(0., 1 + 2 * least)),
                       cell.centre,
                       result.shortening);
                }
            if (!may_yield)
              continue;
            const auto stresses = cell.kernel->stresses(cell, u);
            for (unsigned int q = 0; q < stresses.size(); ++q)
              {
                const double stress = von_mises(stresses[q]);
                const double strain = cell.plastic_strain(q);
                take(stress, cell.centre, result.von_mises);
                take(strain, cell.centre, result.plastic_strain);
                volume += cell.JxW[q];
                if (is_elastic ? stress > yield_stress->second : strain > 0)
                  above += cell.JxW[q];
              }
          }
        if (result.has_recovered)
          for (const auto &cell :
               model.discretization->dof_handler.active_cell_iterators())
            if (cell->is_locally_owned() && cell->material_id() == body)
              for (const unsigned int v : cell->vertex_indices())
                take(von_mises(vertex_stresses[cell->vertex_index(v)]),
                     cell->vertex(v),
                     result.recovered_von_mises);
        for (auto *extreme : {&result.plastic_strain,
                              &result.von_mises,
                              &result.recovered_von_mises,
                              &result.strain,
                              &result.shortening})
          find_among_ranks(communicator, *extreme);
        if (may_yield)
          {
            result.volume_share = Utilities::MPI::sum(above, communicator) /
                                  Utilities::MPI::sum(volume, communicator);
            if (contact_forces.size() > 0)
              result.contact_share =
                share_of_contact(*model.discretization,
                                 body,
                                 contact_forces,
                                 [&](const unsigned int vertex) {
                                   return is_elastic
                                            ? von_mises(
                                                vertex_stresses[vertex]) >
                                                yield_stress->second
                                            : plastic_strains[vertex] > 0;
                                 });
          }
        results[name] = result;
      }
    return results;
  }



  // Below the stretch 1/sqrt 3 the stress of the law of St. Venant and
  // Kirchhoff falls under compression.
  template<int dim>
  bool gets_softer(const BodyResult<dim> &result)
  {
    return result.shortening.value > 1 - 1 / std::sqrt(3.);
  }



  template<int dim>
  std::string describe(const std::string        &body,
                       const BodyResult<dim>    &result,
                       const Parameters::Solids &parameters)
  {
    const auto percent = [](const double part) {
      return brief(100 * part) + " %";
    };
    const auto at = [](const Extreme<dim> &extreme) {
      return " at (" + brief(extreme.X) + ") mm";
    };
    const std::string shares =
      percent(result.volume_share) + " of its volume" +
      (result.contact_share < 0
         ? ""
         : " and " + percent(result.contact_share) + " of its contact");
    std::string text;
    if (result.plastic_strain.value > 0)
      text = "yields in " + shares + ", plastic strain up to " +
             percent(result.plastic_strain.value) + at(result.plastic_strain);
    else if (parameters.yield_stress.count(body) > 0 &&
             parameters.model_of(body) == Parameters::MaterialModel::elastic)
      {
        text = "von Mises' stress is up to " + brief(result.von_mises.value) +
               " MPa" + at(result.von_mises);
        if (result.recovered_von_mises.value > result.von_mises.value)
          text += " inside of the cells, recovered up to " +
                  brief(result.recovered_von_mises.value) + " MPa" +
                  at(result.recovered_von_mises);
        text += ", above yield in " + shares;
      }

    // Beyond it the law of St. Venant and Kirchhoff is one of many.
    const double large_strain = 0.05;
    std::string  beyond;
    if (gets_softer(result))
      beyond = "a stretch of " + brief(1 - result.shortening.value) +
               at(result.shortening) +
               ", below 1/sqrt 3: St. Venant and Kirchhoff's material gets "
               "softer there the more it is compressed";
    else if (result.strain.value > large_strain)
      beyond = "strains up to " + percent(result.strain.value) +
               at(result.strain) +
               ", where St. Venant and Kirchhoff's law is a rough one";
    if (!beyond.empty())
      text += (text.empty() ? "" : "; ") + beyond;
    return text.empty() ? "" : "Body '" + body + "': " + text;
  }



  std::string describe_earlier(const std::string                   &body,
                               const double                         load_factor,
                               const std::map<std::string, double> &earlier,
                               const std::map<std::string, double> &last,
                               const Parameters::Solids            &parameters)
  {
    const double round_off  = 1e-9;
    const auto   is_farther = [&](const std::string &name) {
      return earlier.at(name) > (1 + round_off) * last.at(name);
    };
    std::string text;
    if (parameters.model_of(body) == Parameters::MaterialModel::elastic &&
        is_farther("von_mises"))
      text = "von Mises' stress up to " + brief(earlier.at("von_mises")) +
             " MPa, above yield in " +
             brief(100 * earlier.at("volume_share_above_yield")) +
             " % of its volume";
    if (is_farther("strain"))
      text += (text.empty() ? "" : "; ") + std::string("strains up to ") +
              brief(100 * earlier.at("strain")) + " %";
    return text.empty()
             ? ""
             : "Body '" + body + "' at t = " + brief(load_factor) + ": " + text;
  }



  template bool gets_softer(const BodyResult<2> &);
  template bool gets_softer(const BodyResult<3> &);
  template struct BodyResult<2>;
  template struct BodyResult<3>;
  template std::map<std::string, BodyResult<2>>
  body_results(const ContactModel<2> &,
               const Parameters::Solids &,
               const std::vector<SymmetricTensor<2, 3>> &,
               const std::vector<double> &,
               const GhostedVector &,
               const GhostedVector &);
  template std::map<std::string, BodyResult<3>>
                       body_results(const ContactModel<3> &,
                                    const Parameters::Solids &,
                                    const std::vector<SymmetricTensor<2, 3>> &,
                                    const std::vector<double> &,
                                    const GhostedVector &,
                                    const GhostedVector &);
  template std::string describe(const std::string &,
                                const BodyResult<2> &,
                                const Parameters::Solids &);
  template std::string describe(const std::string &,
                                const BodyResult<3> &,
                                const Parameters::Solids &);
} // namespace Contact
