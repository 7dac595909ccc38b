/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_slip_direction_stiffness_h
#define contact_slip_direction_stiffness_h

#include <deal.II/lac/full_matrix.h>

#include "contact/interface/contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The turning of the shear of a slipping point in 3-D. Its shear traction
   * is q = b d, with the bound b and the direction d = q_trial/|q_trial|,
   * q_trial = lambda - c s. With beta = b/|q_trial| and the unit vector a
   * across d, Newton's method for q = lambda has the multiplier of the next
   * step lambda_new = b d - beta/(1 - beta) a a.(lambda + c ds), ds the change
   * of the slip: a load, and a stiffness across d, k = w c beta/(1 - beta),
   * which is symmetric and never negative, at most a thousand times c and the
   * square of a facet's length. At the solution k = w b/|s|, the derivative of
   * the exact law. In 2-D there is nothing to turn.
   *
   * Along a spring (ContactPoint::stick_compliance()) q_trial changes by -c ds
   * alone: with P the projection across springs, alpha = beta/(1 - beta a.P a),
   *   lambda_new = b (d + alpha a.P d a) - alpha a (a.P lambda + c a.ds).
   * A point that sticks has the stiffness c of its springs.
   *
   * Elastic slip (see ContactInterface) is a spring in all directions, of the
   * stiffness b/e, and with the bound the shear grows by q_trial/b: this is the
   * rotation of a point that sticks. Also in 2-D.
   */
  template<int dim>
  class SlipDirectionStiffness
  {
  public:
    /// What a point adds to the system, over unknowns of the displacement: of
    /// points that another rank adds, the shear alone.
    struct Term
    {
      unsigned int point;

      /// The shear by tangent is d + rotation times the bound, and
      /// shear_at_rest - of_slip times the slip [MPa/mm, MPa].
      Tensor<1, dim - 1> rotation;
      Tensor<2, dim - 1> of_slip;
      Tensor<1, dim - 1> shear_at_rest;
      bool               is_elastic; // sticks with elastic slip

      std::vector<types::global_dof_index> dofs = {};
      FullMatrix<double> stiffness = FullMatrix<double>(); // [N/mm]
      Vector<double>     load      = {};                   // [N]

      /// The stiffness as springs: a factor [N/mm], and the way by unknown.
      std::vector<std::pair<double, Vector<double>>> springs = {};

      /// Whether this rank adds it.
      bool is_own() const
      {
        return !dofs.empty();
      }
    };

    /// Of the slipping points in a state. All ranks add as many, if @p
    /// any_rank_may_add, else the owner of the point's node.
    static std::vector<Term> terms(const ContactInterface<dim> &interface,
                                   const GhostedVector         &solution,
                                   const GhostedVector         &u_start,
                                   const bool any_rank_may_add);

    /// Of a point, the rotation of the shear with the bound, and what the slip
    /// adds to the shear in the state behind a step.
    struct Turned
    {
      Tensor<1, dim - 1> rotation, shear;
      bool               is_elastic = false;
    };

    static std::vector<Turned>
    rotated_shears(const std::vector<Term>     &terms,
                   const ContactInterface<dim> &interface,
                   const GhostedVector         &solution,
                   const GhostedVector         &u_start);
  };
} // namespace Contact

#endif
