/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/condensed/slip_direction_stiffness.h"

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace Contact
{
  namespace
  {
    /// The slip with what springs give way.
    template<int dim>
    Tensor<1, dim - 1> way(const ContactPoint<dim> &point,
                           const ContactState<dim> &now)
    {
      if (now.is_elastic)
        return now.slip;
      return now.slip - point.stick_compliance() *
                          (now.lambda_t - point.shear_at_start) /
                          point.augmentation_parameter;
    }



    /// Make of @p term what the system gets, with the load of @p acting, a
    /// shear by tangent.
    template<int dim>
    void complete(const ContactPoint<dim>                    &point,
                  const Tensor<1, dim - 1>                   &acting,
                  typename SlipDirectionStiffness<dim>::Term &term)
    {
      const unsigned int n = dim * point.n_nodes;
      term.stiffness.reinit(n, n);
      term.load.reinit(n);
      const Tensor<1, dim> load = point.weight * point.along_tangents(acting);
      Tensor<2, dim>       k;
      for (unsigned int s = 0; s < dim - 1; ++s)
        for (unsigned int t = 0; t < dim - 1; ++t)
          k += point.weight * term.of_slip[s][t] *
               outer_product(point.tangents[s], point.tangents[t]);
      for (unsigned int a = 0; a < point.n_nodes; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          {
            term.dofs.push_back(point.dofs(a)[i]);
            term.load[dim * a + i] = point.C[a] * load[i];
            for (unsigned int b = 0; b < point.n_nodes; ++b)
              for (unsigned int j = 0; j < dim; ++j)
                term.stiffness(dim * a + i, dim * b + j) =
                  point.C[a] * point.C[b] * k[i][j];
          }
      // Jacobi's method: that by QL decomposition does not end where a shear of
      // next to nothing, 1e-84 of the other one, is in the tensor.
      for (const auto &[value, direction] :
           eigenvectors(symmetrize(term.of_slip),
                        SymmetricTensorEigenvectorMethod::jacobi))
        if (value > 0)
          {
            const Tensor<1, dim> along = point.along_tangents(direction);
            Vector<double>       way(n);
            for (unsigned int k = 0; k < n; ++k)
              way[k] = point.C[k / dim] * along[k % dim];
            term.springs.emplace_back(point.weight * value, way);
          }
    }
  } // namespace



  template<int dim>
  std::vector<typename SlipDirectionStiffness<dim>::Term>
  SlipDirectionStiffness<dim>::terms(const ContactInterface<dim> &interface,
                                     const GhostedVector         &solution,
                                     const GhostedVector         &u_start,
                                     const bool any_rank_may_add)
  {
    std::vector<Term>               all;
    std::vector<Tensor<1, dim - 1>> acting;
    for (unsigned int k = 0; k < interface.points().size(); ++k)
      {
        const ContactPoint<dim> &point = interface.points()[k];
        if (point.status.kind == Status::open || !interface.has_friction(point))
          continue;
        const ContactState<dim> now = interface.state(point, solution, u_start);
        const Tensor<1, dim - 1> whole_slip = way(point, now);
        const double bound   = interface.bounds.law(point).bound(now.p_trial);
        double       of_unit = point.augmentation_parameter;
        Tensor<2, dim - 1> compliance = point.stick_compliance();
        if (now.is_elastic)
          {
            const auto elastic = interface.elastic_shear(point, now);
            of_unit            = elastic.kappa * elastic.stiffness;
            compliance         = 0;
            for (unsigned int t = 0; t < dim - 1; ++t)
              compliance[t][t] = elastic.kappa;
            if (point.status.kind == Status::stick)
              {
                const Tensor<2, dim - 1> of_slip =
                  elastic.stiffness / elastic.kappa * compliance;
                all.push_back(
                  {k, elastic.zeta, of_slip, of_slip * whole_slip, true});
                acting.push_back(bound * elastic.zeta - now.q_trial);
              }
          }
        // The shear of the springs acts already.
        else if (point.status.kind == Status::stick && compliance.norm() > 0)
          {
            all.push_back({k,
                           {},
                           of_unit * compliance,
                           compliance * (now.q_trial + of_unit * whole_slip),
                           false});
            acting.emplace_back();
          }
        if constexpr (dim == 3)
          {
            const double size = now.q_trial.norm();
            // Supports move it: nothing turns.
            if (!point.status.has_direction() || size == 0)
              continue;
            // The exact stiffness of a point that hardly slips is without
            // bound: multigrid takes more iterations then, and active sets find
            // no end. A sliver of a facet has less weight.
            const double length =
              interface.contact_pair(point).edge_length(point);
            const double largest = 1000 * length * length / point.weight;
            const double beta    = std::min(bound / size, 1.);

            const Tensor<1, 2> &d      = point.status.direction();
            const Tensor<1, 2>  across = cross_product_2d(d);
            const Tensor<1, 2>  rigid  = across - compliance * across;
            const double        left   = 1 - beta * (across * rigid);
            const double share = beta < largest * left ? beta / left : largest;
            const Tensor<1, 2> rotation = share * (rigid * d) * across;
            Tensor<1, 2>       rest = -share * (rigid * now.lambda_t) * across;
            if (now.is_elastic) // the direction may be that of another state
              rest += share * (across * now.q_trial) * across;
            const Tensor<2, 2> of_slip =
              of_unit * share * outer_product(across, across);
            all.push_back(
              {k, rotation, of_slip, rest + of_slip * whole_slip, false});
            acting.push_back(bound * rotation + rest);
          }
      }

    const auto    &discretization = interface.discretization;
    const IndexSet share =
      Utilities::MPI::create_evenly_distributed_partitioning(
        discretization.communicator,
        all.size());
    const IndexSet &owned = discretization.dof_handler.locally_owned_dofs();
    for (unsigned int t = 0; t < all.size(); ++t)
      {
        const ContactPoint<dim> &point = interface.points()[all[t].point];
        if (any_rank_may_add ? share.is_element(t)
                             : owned.is_element(point.dofs(0)[0]))
          {
            complete<dim>(point, acting[t], all[t]);
            ++discretization.counters.slip_stiffnesses;
          }
      }
    return all;
  }



  template<int dim>
  std::vector<typename SlipDirectionStiffness<dim>::Turned>
  SlipDirectionStiffness<dim>::rotated_shears(
    const std::vector<Term>     &terms,
    const ContactInterface<dim> &interface,
    const GhostedVector         &solution,
    const GhostedVector         &u_start)
  {
    std::vector<Turned> turned(interface.points().size());
    for (const Term &term : terms)
      {
        const ContactPoint<dim> &point = interface.points()[term.point];
        if (!term.is_elastic || point.status.kind == Status::stick)
          turned[term.point] = {
            term.rotation,
            term.shear_at_rest -
              term.of_slip *
                way(point, interface.state(point, solution, u_start)),
            term.is_elastic};
      }
    return turned;
  }

  template class SlipDirectionStiffness<2>;
  template class SlipDirectionStiffness<3>;
} // namespace Contact
