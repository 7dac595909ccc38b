/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/error_estimator.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>

#include "adaptivity/refinement.h"
#include "contact/contact_results.h"

namespace Contact
{
  namespace
  {
    /// All boundary ids of the triangulation.
    std::set<types::boundary_id> all_boundaries(const Mesh<2> &mesh)
    {
      const auto ids = mesh.triangulation.get_boundary_ids();
      return {ids.begin(), ids.end()};
    }



    /// An edge is known by the first unknowns of its ends, in ascending order.
    using EdgeName =
      std::pair<types::global_dof_index, types::global_dof_index>;

    EdgeName edge_name(const NodeDoFs<2> &one, const NodeDoFs<2> &other)
    {
      return std::minmax(one[0], other[0]);
    }



    EdgeName edge_name(const Surface<2> &surface, const SurfaceFacet<2> &edge)
    {
      return edge_name(surface.nodes[edge.nodes[0]].dofs,
                       surface.nodes[edge.nodes[1]].dofs);
    }



    /// The edges of a surface by their names.
    std::map<EdgeName, unsigned int> name_edges(const Surface<2> &surface)
    {
      std::map<EdgeName, unsigned int> edges;
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        edges.emplace(edge_name(surface, surface.facets[e]), e);
      return edges;
    }



    bool is_tied(const Discretization<2> &discretization,
                 const Surface<2>        &surface,
                 const SurfaceFacet<2>   &edge)
    {
      for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
        for (const auto dof : surface.nodes[edge.nodes[a]].dofs)
          if (discretization.is_tied(dof))
            return true;
      return false;
    }
  } // namespace



  /// A place on an edge, and how it moves with the coordinate of the edge.
  struct ErrorEstimator::Place
  {
    Place(const Surface<2>      &surface,
          const SurfaceFacet<2> &edge,
          const double           xi,
          const Vector<double>  &u)
      : xi(xi)
      , shape(surface.degree, xi)
    {
      for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
        {
          const unsigned int node     = edge.nodes[a];
          const Point<2>     position = surface.position(node, u);
          x += shape.value[a] * position;
          along += shape.first[a] * position;
          along_undeformed += shape.first[a] * surface.nodes[node].X;
        }
    }

    /// Deformed by undeformed length.
    double stretch() const
    {
      return along.norm() / along_undeformed.norm();
    }

    const double    xi;
    const EdgeShape shape;
    Point<2>        x;                       // deformed
    Tensor<1, 2>    along, along_undeformed; // derivatives
  };



  /**
   * The tractions of contact on the edges of its surfaces. On the slave the
   * traction is p n + q t, on the master the opposite, n the outward normal of
   * the master and t that normal turned by +90 degrees (contact_points.h). In
   * terms of the edge's own outward normal, which on the slave is -n, both are
   *   -(p n + q t),  t = n turned by +90 degrees.
   */
  class ErrorEstimator::ContactTractions
  {
  public:
    ContactTractions(const Discretization<2>   &discretization,
                     const ContactInterface<2> &interface,
                     const ContactPair<2>      &contact_pair,
                     const Vector<double>      &solution)
      : discretization(discretization)
      , slave(contact_pair.slave)
      , solution(solution)
      , search(slave, solution)
      , slave_edges(name_edges(slave))
      , at_nodes(slave.nodes.size())
    {
      if (contact_pair.master)
        master_edges = name_edges(*contact_pair.master);
      for (unsigned int i = 0; i < slave.nodes.size(); ++i)
        {
          const unsigned int k = contact_pair.multipliers.of_node[i];
          if (k == numbers::invalid_unsigned_int)
            continue;
          at_nodes[i][0] = solution[interface.normal_index(k)];
          if (!contact_pair.law.is_frictionless())
            at_nodes[i][1] = solution[interface.tangential_index(k)];
        }
      const auto of_corners = corner_loads(interface, contact_pair, solution);
      for (unsigned int i = 0; i < of_corners.size(); ++i)
        at_nodes[i] += of_corners[i].traction();
    }

    /**
     * Pressure and shear (p, q) at a place of the edge @p name by undeformed
     * length [MPa]; zero where nothing faces the edge within its length
     * @p reach, no value where a tie carries what the multipliers do not know.
     */
    std::optional<Tensor<1, 2>> operator()(const EdgeName &name,
                                           const Place    &place,
                                           const double    reach) const
    {
      const auto own = slave_edges.find(name);
      if (own != slave_edges.end())
        return interpolate(slave.facets[own->second], place);
      if (master_edges.count(name) > 0)
        return of_facing_slave(place, reach);
      return Tensor<1, 2>();
    }

  private:
    Tensor<1, 2> interpolate(const SurfaceFacet<2> &edge,
                             const Place           &place) const
    {
      Tensor<1, 2> traction;
      for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
        traction += place.shape.value[a] * at_nodes[edge.nodes[a]];
      return traction;
    }

    /// Both sides agree on the force by deformed length.
    std::optional<Tensor<1, 2>> of_facing_slave(const Place &place,
                                                const double reach) const
    {
      const Projection<2> projection = search.closest_point(place.x);
      if (projection.off_the_end ||
          search.distance_square(place.x, projection) > reach * reach)
        return Tensor<1, 2>();

      const SurfaceFacet<2> &edge = slave.facets[projection.facet];
      if (is_tied(discretization, slave, edge))
        return {};

      // Values are not extrapolated to the overhang beyond the end.
      const Place there(slave,
                        edge,
                        std::max(-1., std::min(1., projection.xi)),
                        solution);
      return place.stretch() / there.stretch() * interpolate(edge, there);
    }

    const Discretization<2>               &discretization;
    const Surface<2>                      &slave;
    const Vector<double>                  &solution;
    const SurfaceSearch<2>                 search;
    const std::map<EdgeName, unsigned int> slave_edges;
    std::map<EdgeName, unsigned int>       master_edges;
    std::vector<Tensor<1, 2>>              at_nodes; // (p, q) of the slave
  };



  ErrorEstimator::ErrorEstimator(const Discretization<2> &discretization,
                                 const Elasticity<2>     &elasticity)
    : discretization(discretization)
    , elasticity(elasticity)
    , boundary(discretization,
               all_boundaries(discretization.mesh),
               "the whole boundary")
  {
    find_neighborhoods();
  }



  void ErrorEstimator::find_neighborhoods()
  {
    const auto &dofs  = discretization.vertex_dofs;
    const auto  edges = name_edges(boundary);
    neighborhoods.resize(boundary.facets.size());
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->at_boundary())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() &&
              !elasticity.dead_loads.is_loaded(face->boundary_id()))
            {
              std::array<unsigned int, 2> ends{
                {face->vertex_index(0), face->vertex_index(1)}};
              const unsigned int e =
                edges.at(edge_name(dofs[ends[0]], dofs[ends[1]]));

              const unsigned int first = boundary.facets[e].nodes[0];
              if (boundary.nodes[first].dofs != dofs[ends[0]])
                std::swap(ends[0], ends[1]);
              neighborhoods[e] = {cell->active_cell_index(), ends};
            }
  }



  Vector<float> ErrorEstimator::indicators(
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
    const ContactInterface<2>                *interface,
    const Vector<double>                     &solution) const
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
  void ErrorEstimator::add_bulk_terms(
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
    const Vector<double>                     &solution,
    Vector<double>                           &eta_square) const
  {
    const auto stresses = elasticity.stresses(solution);

    const Quadrature<2>     &of_triangles = discretization.quadrature[1];
    const hp::QCollection<2> quadratures(discretization.quadrature[0],
                                         of_triangles.size() == 1
                                           ? QGaussSimplex<2>(2)
                                           : of_triangles);
    hp::FEValues<2>          hp_fe_values(discretization.mapping,
                                 discretization.fe,
                                 quadratures,
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



  void ErrorEstimator::add_boundary_terms(
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
    const ContactInterface<2>                *interface,
    const Vector<double>                     &solution,
    Vector<double>                           &eta_square) const
  {
    std::list<ContactTractions> contact;
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



  // The recovered stress is linear along an edge. On a straight edge the
  // residual is of the edge's degree: the points integrate its square.
  double ErrorEstimator::boundary_term(
    const unsigned int                        e,
    const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
    const std::list<ContactTractions>        &contact,
    const Vector<double>                     &solution) const
  {
    const SurfaceFacet<2> &edge  = boundary.facets[e];
    const auto            &ends  = neighborhoods[e].vertices;
    const auto             first = in_plane(vertex_stresses[ends[0]]);
    const auto             last  = in_plane(vertex_stresses[ends[1]]);
    const double           h     = boundary.reference_length(e);

    const QGauss<1> quadrature(boundary.degree + 1);
    double          integral = 0;
    for (unsigned int q = 0; q < quadrature.size(); ++q)
      {
        const double zeta = quadrature.point(q)[0];
        const Place  place(boundary, edge, 2 * zeta - 1, solution);
        const auto   stress = (1 - zeta) * first + zeta * last;

        Tensor<1, 2>       residual = stress_traction(stress, place);
        const Tensor<1, 2> t        = place.along / place.along.norm();
        bool               is_known = true;
        for (const ContactTractions &of_pair : contact)
          if (const auto p_and_q = of_pair(edge_name(boundary, edge), place, h))
            residual += (*p_and_q)[0] * cross_product_2d(t) + (*p_and_q)[1] * t;
          else
            is_known = false;
        if (!is_known)
          continue;

        for (unsigned int c = 0; c < 2; ++c)
          if (!is_supported(edge, c))
            integral += 2 * quadrature.weight(q) *
                        boundary.reference_jacobian(edge, place.shape) *
                        std::pow(residual[c], 2);
      }
    return h / elasticity.youngs_modulus(edge.body) * integral;
  }



  // As the tractions of contact, a force by undeformed length: the true stress
  // acts on the deformed edge. To small strain both edges are the same.
  Tensor<1, 2>
  ErrorEstimator::stress_traction(const SymmetricTensor<2, 2> &stress,
                                  const Place                 &place) const
  {
    const Tensor<1, 2> &along =
      elasticity.is_linear() ? place.along_undeformed : place.along;
    return stress * cross_product_2d(along) / place.along_undeformed.norm();
  }



  bool ErrorEstimator::is_supported(const SurfaceFacet<2> &edge,
                                    const unsigned int     c) const
  {
    for (unsigned int a = 0; a < boundary.n_nodes_per_facet(); ++a)
      if (!discretization.is_fixed(boundary.nodes[edge.nodes[a]].dofs[c]))
        return false;
    return true;
  }



  void ErrorEstimator::clear_at_nodal_forces(Vector<double> &eta_square) const
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
          Triangulation<2>::cell_iterator ancestor = cell;
          while (ancestor->level() > 0)
            ancestor = ancestor->parent();
          for (const unsigned int v : ancestor->vertex_indices())
            if (carries_force(ancestor->vertex_index(v)))
              eta_square[cell->active_cell_index()] = 0;
        }
  }



  void flag_by_estimate(const ContactModel<2>                    &model,
                        const Parameters::All                    &parameters,
                        const std::vector<SymmetricTensor<2, 3>> &stresses,
                        const Vector<double>                     &solution)
  {
    ++model.discretization->counters.error_estimates;
    flag_by_indicators(model,
                       parameters,
                       ErrorEstimator(*model.discretization, *model.elasticity)
                         .indicators(stresses,
                                     model.interface.get(),
                                     solution));
  }
} // namespace Contact
