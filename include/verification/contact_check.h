/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_check_h
#define contact_contact_check_h

#include "base/findings.h"
#include "base/string_utilities.h"
#include "contact/interface/contact_interface.h"
#include "solid/discretization.h"

namespace Contact
{
  using namespace dealii;

  struct Worst;

  /**
   * The conditions on bodies in contact, whatever the mesh, and by how much
   * they are not met. All ranks get the same numbers.
   *
   * The force F [N per mm] of relative quantities is the one that Newton's
   * method is relative to; a gap g becomes a force as w k g, with the weight w
   * of the point and the stiffness k = E/h of its slave edge.
   */
  struct ContactInvariants
  {
    /// The forces of contact on slave and master together, and their moment
    /// about the middle of the slave by its size, by the sum of the magnitudes
    /// of all these forces.
    double force_imbalance  = 0;
    double moment_imbalance = 0;

    /// The largest of: a negative pressure in contact; a gap in contact, a
    /// multiplier where open (in the weak sense of the discretization); with
    /// the nodal and the mortar discretization, a penetration where open. By F.
    double augmentation_parameter = 0;

    /// The largest |q| - bound of the friction law under the present pressure,
    /// by the largest bound.
    double cone = 0;

    /// The largest slip of what sticks (in the weak sense of the
    /// discretization) and, with the nodal and the mortar discretization, slip
    /// along the shear instead of against it. By F.
    double slip = 0;

    /// The largest -gap [mm] of all points, also by the length of the slave
    /// edge. With the Gauss-point discretization
    /// surfaces penetrate each other between the nodes: no violation.
    double penetration          = 0;
    double relative_penetration = 0;

    /// Which invariants are violated, by how much, where, what to do; and what
    /// a user should know of this state though the discrete equations hold.
    Findings findings;

    /// Add a violation if @p value is above @p limit, or not a number.
    void check(const std::string &name,
               const double       value,
               const double       limit,
               const std::string &sentence,
               const std::string &advice);
  };



  /// The uncertainty of a state due to the tolerances.
  struct Slack
  {
    double reference;       // F [N per mm]
    double relative;        // Newton's tolerance
    double force;           // the same times F [N per mm]
    double shear       = 0; // of the bounds by a fixed point [MPa]
    double shear_force = 0; // the same on all points [N per mm]
  };



  /**
   * Check the contact of one converged state, by a computation of its own: from
   * the displacements, the statuses and multipliers of the points.
   *
   * @par Forces
   * A point exerts w (p n + q t) C_a on its node a. These add up to zero
   * because the C_a do. With r = sum C_a x_a = g n + o t their moment is
   *   w (g q - o p):
   * zero where the gap is, if the projection is the closest point (o = 0). With
   * the Gauss-point discretization the gap is zero in the mean only; over a
   * corner of the master the projection stays behind; where the surfaces have
   * moved by d since they were paired, the projection is that of the pairing;
   * where closest points jump, d is the mean that they move the forces by:
   * |o| <= sqrt(2) sum |C_a| d. So much is the method's own. Glue has the gap
   * and the offset of the mesh, and may lose a hundredth of the moment by them.
   * With undeformed geometry the moments are those of the undeformed bodies.
   *
   * @par Complementarity and friction
   * The weak conditions of the discretization are what Newton's method has
   * solved, for each multiplier k, sum w psi_k (p - lambda_n)/c = 0,  sum w
   * psi_k (q - lambda_t)/c = 0. With a point per multiplier (nodal, mortar;
   * there gap and slip are the weighted ones) they say g = 0 in contact, lambda
   * = 0 where open, s = 0 where it sticks; from p = max(0, lambda - c g) follow
   * p >= 0 and g >= 0, from the slip law q s <= 0, point by point. The
   * Gauss-point discretization has several points per multiplier and promises
   * the weak conditions and p >= 0. Gaps are those of the pairing of the last
   * turn. Where most points of an edge face nothing, they pull its multipliers
   * to zero, and what is left is a penalty -c g, with c far below the stiffness
   * of the bodies: if that makes half of the largest pressure, the bodies pass
   * through each other.
   *
   * @par Depth
   * On a mesh that is too coarse the discrete conditions may hold while places
   * between the contact points are deep inside of the other body, or of an
   * obstacle. It is a violation if one is deeper than it was undeformed by more
   * than half of what the bodies deform by, without their rigid motions, and
   * where no force acts by what the surfaces deform by: a way until they touch
   * must not hide it. Before the end of a run, when they may not have deformed
   * yet, it is a note unless it is half of what the surfaces move by as well.
   * Overlaps that polygons or the mesh have to begin with count where no force
   * acts in the whole contact pair. A node that
   * goes through the other body in an increment is a violation, see
   * find_crossing().
   */
  template<int dim>
  class ContactCheck
  {
  public:
    /// Of the state @p solution at the end of an increment that began with the
    /// displacement @p u_start; by the pairing the projection points of the
    /// points may be off by @p moved [mm]. All arguments have to outlive the
    /// object.
    ContactCheck(const Discretization<dim>   &discretization,
                 const ContactInterface<dim> &interface,
                 const Parameters::Solution  &parameters,
                 const GhostedVector         &solution,
                 const GhostedVector         &u_start,
                 const double                 moved,
                 const bool                   ends_run);

    /// Let the slack know of bounds by a fixed point, and of the round-off of a
    /// sum over all points.
    void widen(Slack &slack) const;

    /// Add the forces of the pressures and of the shears on the nodes [N per
    /// mm], and what the shears dissipate in the increment [N mm per mm].
    void add_forces(GhostedVector &pressures,
                    GhostedVector &shears,
                    double        &dissipation) const;

    void check(const Slack &slack, ContactInvariants &found) const;

  private:
    void check_balance(const ContactPair<dim> &contact_pair,
                       const Slack            &slack,
                       ContactInvariants      &found) const;
    void check_depth(const ContactPair<dim> &contact_pair,
                     ContactInvariants      &found) const;
    void check_crossing(const ContactPair<dim> &contact_pair,
                        ContactInvariants      &found) const;

    /// The forces of a contact pair on both bodies together; the moment is
    /// about the middle of the slave, whose size [mm] is that of its box.
    struct Resultant
    {
      Tensor<1, dim> force;
      Moment<dim>    moment;
      double         magnitude = 0, size = 0;
    };

    Resultant resultant(const ContactPair<dim> &contact_pair) const;

    /// The moment that the discretization of contact leaves.
    double moment_of_discretization(const ContactPair<dim> &contact_pair) const;
    Point<dim> position(const SurfaceNode<dim> &node) const;

    /// Whether any node of the slave is pushed, or of another side of the same
    /// body by the same other one.
    bool carries_force(const ContactPair<dim> &contact_pair) const;
    /// Whether a node of a slave edge is pushed.
    bool carries_force(const ContactPair<dim> &contact_pair,
                       const unsigned int      slave_facet) const;
    void check_normal(const Slack &slack, ContactInvariants &found) const;
    void check_penalty(ContactInvariants &found) const;
    void check_tangential(const Slack &slack, ContactInvariants &found) const;
    void add_normal_condition(const unsigned int k,
                              const Slack       &slack,
                              Worst             &worst) const;
    void add_tangential_condition(const unsigned int k,
                                  const Slack       &slack,
                                  Worst             &cone,
                                  Worst             &slip) const;

    /// The weak conditions, by multiplier: what is left of them [mm^2], the
    /// stiffness at a point, the part that the slack of the bounds may have,
    /// and one of the points.
    struct WeakConditions
    {
      std::vector<double>       defect, stiffness, allowed;
      std::vector<unsigned int> point;
    };

    /// Of the normal direction: 0, or of the tangents: from 1 on.
    void           check_slip(const WeakConditions &weak,
                              const Slack          &slack,
                              Worst                &slip) const;
    WeakConditions weak_conditions(const unsigned int direction,
                                   const Slack       &slack) const;

    /// Of a point in contact [MPa]. The traction and the multiplier differ by c
    /// times the gap, also by its round-off.
    double pressure(const unsigned int k) const
    {
      return std::max(tractions[k].p, states[k].lambda_n);
    }

    /// The place of a point, in a sentence.
    std::string at(const ContactPoint<dim> &point) const;

    const Discretization<dim>   &discretization;
    const ContactInterface<dim> &interface;
    const Parameters::Solution  &parameters;
    const GhostedVector         &solution, &u_start;
    const double                 moved;
    const bool                   ends_run;

    // By point.
    std::vector<ContactState<dim>> states;
    std::vector<Traction<dim>>     tractions;
    double                         largest_bound = 0; // [MPa]
  };
} // namespace Contact

#endif
