/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/slip_turning.h"

#include <algorithm>

namespace Contact
{
  namespace
  {
    using Term = SlipTurning<3>::Term;

    /// The load along @p across, and the stiffness @p k in the directions that
    /// @p projection leaves.
    Term make_term(const ContactPoint<3> &point,
                   const unsigned int     number,
                   const double           share,
                   const Tensor<2, 3>    &projection,
                   const double           k,
                   const Tensor<1, 3>    &load)
    {
      const unsigned int n = 3 * point.n_nodes;
      Term term{number, share, {}, FullMatrix<double>(n, n), Vector<double>(n)};
      for (unsigned int a = 0; a < point.n_nodes; ++a)
        for (unsigned int i = 0; i < 3; ++i)
          {
            term.dofs.push_back(point.dofs[a][i]);
            term.load[3 * a + i] = point.C[a] * load[i];
            for (unsigned int b = 0; b < point.n_nodes; ++b)
              for (unsigned int j = 0; j < 3; ++j)
                term.stiffness(3 * a + i, 3 * b + j) =
                  k * point.C[a] * point.C[b] * projection[i][j];
          }
      return term;
    }
  } // namespace



  template<>
  std::vector<SlipTurning<2>::Term>
  SlipTurning<2>::terms(const ContactInterface<2> &,
                        const Vector<double> &,
                        const Vector<double> &,
                        const bool)
  {
    return {};
  }



  template<>
  std::vector<SlipTurning<3>::Term>
  SlipTurning<3>::terms(const ContactInterface<3> &interface,
                        const Vector<double>      &solution,
                        const Vector<double>      &u_start,
                        const bool                 moving_bound)
  {
    std::vector<Term> all;
    for (unsigned int k = 0; k < interface.points().size(); ++k)
      {
        const ContactPoint<3> &point = interface.points()[k];
        if (point.status.kind != Status::slip || !point.status.has_direction())
          continue;
        const ContactState<3> now  = interface.state(point, solution, u_start);
        const double          size = now.q_trial.norm();
        if (size == 0) // supports move it, and nothing turns
          continue;
        const double bound =
          moving_bound ? interface.contact_pair(point).law.bound(now.p_trial)
                       : point.friction_bound;
        // A point that is about to stick, or begins to slip, would be stiffer
        // than the bodies without bound. A hundred times as stiff as a facet
        // holds it as well, and multigrid, whose smoother sees a penalty there,
        // still converges. The weight is less where the master covers a sliver.
        const double length  = interface.contact_pair(point).edge_length(point);
        const double largest = 100 * length * length / point.weight;
        const double beta    = std::min(bound / size, 1.);
        const double share =
          beta < largest * (1 - beta) ? beta / (1 - beta) : largest;

        const Tensor<1, 3> d = point.along_tangents(point.status.direction());
        Tensor<2, 3>       across;
        for (const Tensor<1, 3> &t : point.tangents)
          across += outer_product(t, t);
        across -= outer_product(d, d);
        all.push_back(
          make_term(point,
                    k,
                    share,
                    across,
                    point.weight * point.augmentation_parameter * share,
                    -point.weight * share *
                      (across * point.along_tangents(now.lambda_t))));
      }
    return all;
  }



  template<int dim>
  std::vector<Tensor<1, dim - 1>>
  SlipTurning<dim>::turned_shears(const std::vector<Term>     &terms,
                                  const ContactInterface<dim> &interface,
                                  const Vector<double>        &solution,
                                  const Vector<double>        &u_start)
  {
    std::vector<Tensor<1, dim - 1>> turned(interface.points().size());
    for (const Term &term : terms)
      {
        const ContactPoint<dim>  &point = interface.points()[term.point];
        const Tensor<1, dim - 1> &d     = point.status.direction();
        const Tensor<1, dim - 1>  slip =
          interface.state(point, solution, u_start).slip;
        turned[term.point] =
          -term.share * point.augmentation_parameter * (slip - (slip * d) * d);
      }
    return turned;
  }

  template class SlipTurning<2>;
  template class SlipTurning<3>;
} // namespace Contact
