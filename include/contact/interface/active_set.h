/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_active_set_h
#define contact_active_set_h

#include <vector>

#include "contact/interface/contact_pair.h"

namespace Contact
{
  using namespace dealii;

  template<int dim>
  class ContactInterface;

  /// Gap, slip and multipliers of a contact point in a given state.
  template<int dim>
  struct ContactState
  {
    /// By tangent.
    using Tangential = Tensor<1, dim - 1>;

    double     gap;      // [mm], negative: penetration
    Tangential slip;     // of this increment [mm]
    double     lambda_n; // interpolated multipliers [MPa]
    Tangential lambda_t;
    double     p_trial;    // lambda_n - c gap: in contact where positive
    Tangential q_trial;    // lambda_t - c slip: sticks where within the bound
    bool       is_elastic; // the shear follows the slip: elastic_shear()
  };



  /// Pressure p and shear traction q of a point [MPa], and their derivatives
  /// with respect to the trial values.
  template<int dim>
  struct Traction
  {
    double             p = 0, dp_dp = 0;
    Tensor<1, dim - 1> q, dq_dp; // by tangent
    Tensor<2, dim - 1> dq_dq;
  };



  /// The number of active points of all contact pairs.
  struct StatusCount
  {
    unsigned int active = 0; // stick and slip
    unsigned int stick  = 0;
  };



  /// The statuses of the points of all contact pairs, and the tractions that
  /// follow from them.
  template<int dim>
  class ActiveSet
  {
  public:
    ActiveSet(ContactInterface<dim>          &interface,
              std::vector<ContactPoint<dim>> &points)
      : interface(interface)
      , points(points)
    {
    }

    /**
     * The first guess of the active set: points that touch, penetrate, or are
     * closer than a hundredth of the length of their slave edge. What it misses
     * costs time only: the search of the active set finds the rest. It leaves
     * corners of the master out: their conditions may follow from others.
     */
    void initialize(const GhostedVector &u);

    /**
     * If no point is in contact, begin with those that come first as the
     * bodies approach each other: the one with the smallest gap, and what is
     * no further than a hundredth of an edge behind it. A guess again. Corners
     * of the master, if no point of the slave is as close.
     */
    void activate_nearest(const GhostedVector &u);

    /// Obstacles that forces move and that touch nothing move until they
    /// touch: a guess of the active set, as activate_nearest().
    void activate_free_obstacles(const GhostedVector &u);

    /// Update the statuses of all points in the present state. Returns how many
    /// change; without @p keep they are counted only.
    unsigned int update(const GhostedVector &solution,
                        const GhostedVector &u_start,
                        const bool           keep);

    /// Update the status of the first point only whose status changes.
    void update_first(const GhostedVector &solution,
                      const GhostedVector &u_start);

    /// Open the points that a new pairing has moved so far from the master that
    /// they would: to begin with them closed would pull the bodies together.
    void release_parted(const GhostedVector &solution);

    StatusCount count() const;

    /**
     * Whether multipliers are forces of the bodies, as without them in the
     * system, and not unknowns. A point in contact then stays in contact while
     * the bodies press there, whatever its gap: that is of second order in the
     * last step, but times c far more than the pressure of a slender body.
     */
    bool multipliers_are_forces = false;

    /// The statuses of all points, and as numbers.
    std::vector<PointStatus<dim>> statuses() const;
    void set_statuses(const std::vector<PointStatus<dim>> &all);
    std::vector<signed char> signature() const;

    /// Without friction, where its tangential row is void, and where supports
    /// move it along a tangent, a point in contact slips.
    bool can_stick(const ContactPoint<dim> &point) const;

    /// The status of a point under trial values, after the one @p before. None
    /// follows from round-off: an open point closes under more than the
    /// pressure of that of its gap, a slipping one sticks where its shear is
    /// below the bound in the first half of its digits.
    PointStatus<dim> updated_status(const ContactPoint<dim>  &point,
                                    const PointStatus<dim>   &before,
                                    const double              p_trial,
                                    const Tensor<1, dim - 1> &q_trial) const;

    /// The status of a point in a state, after its present one.
    PointStatus<dim> status_in(const ContactPoint<dim> &point,
                               const GhostedVector     &solution,
                               const GhostedVector     &u_start) const;

    /// The supports move in this increment by @p motion, zero elsewhere [mm]:
    /// a point that only they move along its tangent slips with them.
    void set_support_motion(const GhostedVector &motion);

    /// The tractions that follow from a status and trial values.
    Traction<dim> traction(const ContactPoint<dim>  &point,
                           const PointStatus<dim>   &status,
                           const double              p_trial,
                           const Tensor<1, dim - 1> &q_trial) const;

    /// The tractions under the present status in a state.
    Traction<dim> traction(const ContactPoint<dim> &point,
                           const ContactState<dim> &state) const
    {
      return traction(point, point.status, state.p_trial, state.q_trial);
    }

  private:
    /// The direction of slip of a point that cannot stick.
    typename PointStatus<dim>::Direction
    prescribed_direction(const ContactPoint<dim>  &point,
                         const Tensor<1, dim - 1> &q_trial) const;

    /// The slip [mm] with friction that supports prescribe in this increment.
    Tensor<1, dim - 1> slip_of_supports(const ContactPoint<dim> &point) const;

    void activate_nearest(const std::vector<const ContactPair<dim> *> &of,
                          const GhostedVector                         &u);

    ContactInterface<dim>          &interface;
    std::vector<ContactPoint<dim>> &points;
    GhostedVector                   support_motion; // of this increment
  };
} // namespace Contact

#endif
