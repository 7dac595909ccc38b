/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/error_estimator.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <cmath>

#include "adaptivity/refinement.h"
#include "contact/results/contact_results.h"

namespace Contact
{
  namespace
  {
    /// All boundary ids of the triangulation.
    template<int dim>
    std::set<types::boundary_id> all_boundaries(const Mesh<dim> &mesh)
    {
      const auto ids = mesh.triangulation.get_boundary_ids();
      return {ids.begin(), ids.end()};
    }



    /// The rule of triangles and tetrahedra of degree 1 has one point.
    template<int dim>
    hp::QCollection<dim>
    quadratures_of_squares(const hp::QCollection<dim> &rules)
    {
      hp::QCollection<dim> finer;
      for (unsigned int k = 0; k < rules.size(); ++k)
        finer.push_back(rules[k].size() == 1
                          ? Quadrature<dim>(QGaussSimplex<dim>(2))
                          : rules[k]);
      return finer;
    }



    /// A quadrature point in the coordinates of a facet.
    double in_facet(const Point<1> &zeta)
    {
      return 2 * zeta[0] - 1;
    }

    Point<2> in_facet(const Point<2> &zeta)
    {
      return {2 * zeta[0] - 1, 2 * zeta[1] - 1};
    }
  } // namespace



  template<int dim>
  ErrorEstimator<dim>::ErrorEstimator(const Discretization<dim> &discretization,
                                      const Elasticity<dim>     &elasticity)
    : discretization(discretization)
    , elasticity(elasticity)
    , boundary(discretization,
               all_boundaries(discretization.mesh),
               "the whole boundary")
  {
    find_neighborhoods();
  }



  template<int dim>
  void ErrorEstimator<dim>::find_neighborhoods()
  {
    std::map<FacetName<dim>, unsigned int> facets;
    for (unsigned int e = 0; e < boundary.facets.size(); ++e)
      facets.emplace(boundary.facets[e].name, e);
    neighborhoods.resize(boundary.facets.size());
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() &&
              !elasticity.dead_loads.is_loaded(face->boundary_id()))
            {
              const unsigned int e =
                facets.at(facet_name(discretization, face));
              neighborhoods[e].cell = cell->active_cell_index();
              auto &vertices        = neighborhoods[e].vertices;
              vertices.resize(face->n_vertices());
              for (unsigned int a = 0; a < vertices.size(); ++a)
                {
                  const Point<dim> &X =
                    boundary.nodes[boundary.facets[e].nodes[a]].X;
                  unsigned int nearest = 0;
                  for (unsigned int v = 1; v < vertices.size(); ++v)
                    if (face->vertex(v).distance(X) <
                        face->vertex(nearest).distance(X))
                      nearest = v;
                  vertices[a] = face->vertex_index(nearest);
                }
            }
  }



  template<int dim>
  Vector<float> ErrorEstimator<dim>::indicators(
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
    const ContactInterface<dim>              *interface,
    const GhostedVector                      &solution) const
  {
    Vector<double> eta_square(
      discretization.mesh.triangulation.n_active_cells());
    add_bulk_terms(vertex_stresses, solution, eta_square);
    add_boundary_terms(vertex_stresses, interface, solution, eta_square);
    clear_at_nodal_forces(eta_square);
    return Vector<float>(eta_square);
  }



  // The integral is over the undeformed cell, as all others are, in the points
  // of the stresses. In a triangle of degree 1 the stress has one point, for it
  // is constant; the recovered one is linear, and its square takes more points.
  template<int dim>
  void ErrorEstimator<dim>::add_bulk_terms(
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
    const GhostedVector                      &solution,
    Vector<double>                           &eta_square) const
  {
    const auto stresses = elasticity.stresses(solution);

    hp::FEValues<dim> hp_fe_values(
      discretization.mapping,
      discretization.fe,
      quadratures_of_squares(discretization.quadrature),
      update_JxW_values | update_quadrature_points);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          hp_fe_values.reinit(cell);
          const auto &fe_values  = hp_fe_values.get_present_fe_values();
          const auto &quadrature = fe_values.get_quadrature();
          const auto &at_points  = stresses[cell->active_cell_index()];
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              auto difference = -at_points[at_points.size() == 1 ? 0 : q];
              for (const unsigned int v : cell->vertex_indices())
                difference += cell->reference_cell().d_linear_shape_function(
                                quadrature.point(q),
                                v) *
                              vertex_stresses[cell->vertex_index(v)];
              eta_square[cell->active_cell_index()] +=
                elasticity.energy_density(cell->material_id(), difference) *
                discretization.circumference(fe_values.quadrature_point(q)) *
                fe_values.JxW(q);
            }
        }
  }



  template<int dim>
  void ErrorEstimator<dim>::add_boundary_terms(
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
    const ContactInterface<dim>              *interface,
    const GhostedVector                      &solution,
    Vector<double>                           &eta_square) const
  {
    std::list<ContactTractions<dim>> contact;
    if (interface != nullptr)
      for (const auto &contact_pair : interface->pairs)
        contact.emplace_back(discretization,
                             *interface,
                             *contact_pair,
                             solution);

    for (unsigned int e = 0; e < boundary.facets.size(); ++e)
      if (neighborhoods[e].cell != numbers::invalid_unsigned_int &&
          !is_tied(discretization, boundary, boundary.facets[e]))
        eta_square[neighborhoods[e].cell] +=
          boundary_term(e, vertex_stresses, contact, solution);
  }



  // The recovered stress is linear along a facet. On a straight edge the
  // residual is of the edge's degree: the points integrate its square.
  template<int dim>
  double ErrorEstimator<dim>::boundary_term(
    const unsigned int                        e,
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
    const std::list<ContactTractions<dim>>   &contact,
    const GhostedVector                      &solution) const
  {
    const SurfaceFacet<dim> &facet    = boundary.facets[e];
    const auto              &vertices = neighborhoods[e].vertices;
    const double             h        = boundary.reference_length(e);

    const auto cell =
      ReferenceCell::n_vertices_to_type(dim - 1, vertices.size());
    const Quadrature<dim - 1> quadrature =
      cell.template get_gauss_type_quadrature<dim - 1>(boundary.degree + 1);
    double integral = 0;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const Point<dim - 1> &zeta = quadrature.point(q);
        const FacetPlace<dim> place(boundary, facet, in_facet(zeta), solution);
        SymmetricTensor<2, dim> stress;
        for (unsigned int v = 0; v < vertices.size(); ++v)
          stress += cell.d_linear_shape_function(zeta, v) *
                    in_space<dim>(vertex_stresses[vertices[v]]);

        Tensor<1, dim> residual = stress_traction(stress, place, facet.body);
        bool           is_known = true;
        for (const ContactTractions<dim> &of_pair : contact)
          if (const auto traction = of_pair(facet.name, place, h))
            residual -= *traction;
          else
            is_known = false;
        if (!is_known)
          continue;

        const Tensor<1, dim> free = free_part(facet, residual);
        for (unsigned int c = 0; c < dim; ++c)
          integral += Utilities::fixed_power<dim - 1>(2.) *
                      quadrature.weight(q) *
                      boundary.reference_jacobian(facet, place.shape) *
                      std::pow(free[c], 2);
      }
    return h / elasticity.youngs_modulus(facet.body) * integral;
  }



  // As the tractions of contact, a force by undeformed area: the true stress
  // acts on the deformed one. To small strain both are the same.
  template<int dim>
  Tensor<1, dim>
  ErrorEstimator<dim>::stress_traction(const SymmetricTensor<2, dim> &stress,
                                       const FacetPlace<dim>         &place,
                                       const types::material_id body) const
  {
    return stress *
           (elasticity.is_small_strain(body) ? place.undeformed_area
                                             : place.area) /
           place.undeformed_area.norm();
  }



  template<int dim>
  Tensor<1, dim>
  ErrorEstimator<dim>::free_part(const SurfaceFacet<dim> &facet,
                                 const Tensor<1, dim>    &traction) const
  {
    const auto is_held = [&](const Tensor<1, dim> &direction) {
      const double round_off = 1e-8;
      for (unsigned int a = 0; a < facet.n_nodes(); ++a)
        if (discretization
              .free_part(boundary.nodes[facet.nodes[a]].dofs, direction)
              .norm() > round_off)
          return false;
      return true;
    };
    Tensor<1, dim> free = traction;
    for (unsigned int c = 0; c < dim; ++c)
      if (is_held(Point<dim>::unit_vector(c)))
        free[c] = 0;
    for (const Tensor<1, dim> &normal : discretization.normal_supports.normals(
           boundary.nodes[facet.nodes[0]].dofs))
      if (is_held(normal))
        free -= (free * normal) * normal;
    return free;
  }



  template<int dim>
  void
  ErrorEstimator<dim>::clear_at_nodal_forces(Vector<double> &eta_square) const
  {
    const auto carries_force = [this](const unsigned int vertex) {
      for (const auto dof : discretization.vertex_dofs[vertex])
        if (elasticity.dead_loads.carries_nodal_force(dof))
          return true;
      return false;
    };

    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          typename Triangulation<dim>::cell_iterator ancestor = cell;
          while (ancestor->level() > 0)
            ancestor = ancestor->parent();
          if (elasticity.dead_loads.carries_inner_force(
                ancestor->id().get_coarse_cell_id()))
            eta_square[cell->active_cell_index()] = 0;
          for (const unsigned int v : ancestor->vertex_indices())
            if (carries_force(ancestor->vertex_index(v)))
              eta_square[cell->active_cell_index()] = 0;
        }
  }



  namespace
  {
    /// Indicators of strains that do not differ by more than Newton's tolerance
    /// of all displacements would, at most the default one, are zero: where
    /// bodies move without stress, another number of processes or another
    /// solver would have others.
    template<int dim>
    void clear_what_is_lost(const ContactModel<dim>    &model,
                            const Parameters::Solution &parameters,
                            const GhostedVector        &solution,
                            Vector<float>              &indicators)
    {
      const auto  &discretization = *model.discretization;
      const double lost           = std::min(parameters.newton_tolerance,
                                   Parameters::Solution().newton_tolerance) *
                          discretization.displacements(solution).linfty_norm();
      for (const auto &cell :
           discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const double energy =
              model.elasticity->youngs_modulus(cell->material_id()) *
              std::pow(lost / cell->diameter(), 2) *
              discretization.circumference(cell->center()) * cell->measure();
            float &indicator = indicators[cell->active_cell_index()];
            if (indicator <= energy)
              indicator = 0;
          }
    }
  } // namespace



  template<int dim>
  void flag_by_estimate(const ContactModel<dim>                  &model,
                        const Parameters::All                    &parameters,
                        const std::vector<SymmetricTensor<2, 3>> &stresses,
                        const GhostedVector                      &solution)
  {
    ++model.discretization->counters.error_estimates;
    Vector<float> indicators =
      ErrorEstimator<dim>(*model.discretization, *model.elasticity)
        .indicators(stresses, model.interface.get(), solution);
    clear_what_is_lost(model, parameters.solution, solution, indicators);
    flag_by_indicators(model, parameters, indicators);
  }

  template class ErrorEstimator<2>;
  template class ErrorEstimator<3>;
  template void
  flag_by_estimate(const ContactModel<2>                    &model,
                   const Parameters::All                    &parameters,
                   const std::vector<SymmetricTensor<2, 3>> &stresses,
                   const GhostedVector                      &solution);
  template void
  flag_by_estimate(const ContactModel<3>                    &model,
                   const Parameters::All                    &parameters,
                   const std::vector<SymmetricTensor<2, 3>> &stresses,
                   const GhostedVector                      &solution);
} // namespace Contact
