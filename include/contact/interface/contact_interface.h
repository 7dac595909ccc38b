/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_interface_h
#define contact_contact_interface_h

#include <deal.II/base/index_set.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <map>

#include "contact/interface/point_frames.h"

namespace Contact
{
  using namespace dealii;

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
    double     p_trial; // lambda_n - c gap: in contact where positive
    Tangential q_trial; // lambda_t - c slip: sticks where within the bound
  };



  /// Pressure p and shear traction q of a point [MPa], and their derivatives
  /// with respect to the trial values.
  template<int dim>
  struct Traction
  {
    double             p = 0, dp_dp = 0;
    Tensor<1, dim - 1> q, dq_dp; // by tangent
    double             dq_dq = 0;
  };



  /// The number of active points of all contact pairs.
  struct StatusCount
  {
    unsigned int active = 0; // stick and slip
    unsigned int stick  = 0;
  };



  /**
   * All contact pairs: their points, the numbers of their multipliers, and the
   * active set. ContactKernel makes equations of them.
   *
   * The solution vector holds the displacement, then the normal multipliers,
   * and of contact pairs with friction the tangential ones. With the tractions
   *   p = lambda_n - c g  in contact,  0 if open,
   *   q = lambda_t - c s  if sticking, +-bound if slipping, 0 if open,
   * the discrete equations are, summed over the points,
   *   elastic forces_a - w (p n + q t) C_a = 0,
   *   w psi_k (p - lambda_n)/c = 0,   w psi_k (q - lambda_t)/c = 0:
   * the stationarity of the augmented Lagrangian of Alart and Curnier (Comput.
   * Methods Appl. Mech. Engrg. 92, 1991), whose semismooth Newton method with
   * the status kept in the points is the primal-dual active set of
   * Hintermueller, Ito and Kunisch (SIAM J. Optim. 13, 2003).
   */
  template<int dim>
  class ContactInterface
  {
  public:
    ContactInterface(const Discretization<dim>              &discretization,
                     const Elasticity<dim>                  &elasticity,
                     const std::vector<Parameters::Contact> &parameters);

    const Discretization<dim>                           &discretization;
    std::vector<std::unique_ptr<const ContactPair<dim>>> pairs;

    /// All points, contact pair by contact pair.
    const std::vector<ContactPoint<dim>> &points() const
    {
      return all_points;
    }

    /// The numbers of the points whose forces this process adds up: as many as
    /// any other has, wherever their nodes are.
    const IndexSet &own_points() const
    {
      return own;
    }

    const ContactPair<dim> &contact_pair(const ContactPoint<dim> &point) const
    {
      return *pairs[point.contact_pair];
    }

    ArrayView<const ContactPoint<dim>>
    points_of(const ContactPair<dim> &contact_pair) const;

    /// Of these those of the slave, which come first, and the corners of the
    /// master.
    ArrayView<const ContactPoint<dim>>
    points_of_slave(const ContactPair<dim> &contact_pair) const
    {
      return contact_pair.points_of_slave(all_points.data());
    }
    ArrayView<const ContactPoint<dim>>
    corners_of_master(const ContactPair<dim> &contact_pair) const
    {
      return contact_pair.corners_of_master(all_points.data());
    }

    /// Those of the slave for results: of points that are joined, see
    /// PointFrames, each with its part of the force.
    std::vector<ContactPoint<dim>>
    acting_points(const ContactPair<dim> &contact_pair) const;

    /// The normal multiplier that is the pressure of the point with the
    /// multiplier @p k.
    unsigned int acting_multiplier(const unsigned int k) const;

    /// All points as they would be paired in the configuration @p u, but for
    /// those of glue.
    std::vector<ContactPoint<dim>> paired_anew(const GhostedVector &u) const;

    /// Return to the points of an earlier state, or of one to be checked.
    void set_points(const std::vector<ContactPoint<dim>> &points)
    {
      AssertDimension(points.size(), all_points.size());
      all_points = points;
    }

    /// Whether there is nothing but glue: all contact pairs are tied.
    bool is_tied() const;

    /// Check that no two pairs are about the same lines, and that no slave is
    /// drawn inside of its obstacle. Throws InputError.
    void check_pairs(const std::vector<Parameters::Contact> &parameters) const;

    /// Whether a contact pair that is not tied has friction, and Coulomb's.
    bool has_friction() const;
    bool has_coulomb_friction() const;

    /// Whether a point has tangential multipliers.
    bool has_friction(const ContactPoint<dim> &point) const
    {
      return !contact_pair(point).law.is_frictionless();
    }

    /// All of them, with free motions, and those of the normal direction.
    unsigned int n_multipliers() const;
    unsigned int n_normal_multipliers() const;

    /// Their indices in the solution; the tangential ones, one for each
    /// tangent, only with friction.
    types::global_dof_index normal_index(const unsigned int multiplier) const;
    types::global_dof_index
    tangential_index(const unsigned int multiplier,
                     const unsigned int tangent = 0) const;

    /// The pressure that ContactPair::pressure_at describes, in a solution
    /// [MPa].
    double
    pressure(const std::vector<std::pair<unsigned int, double>> &multipliers,
             const GhostedVector &solution) const;

    /**
     * Pair all points with the master in the configuration @p u. Returns
     * whether a point changed its master edge: then the matrix couples other
     * unknowns than before.
     */
    bool pair(const GhostedVector &u, const PairingMode &mode = {});

    /// An increment begins at the load factor @p from with @p solution, in
    /// which the points are paired: they remember it. Call it before
    /// move_obstacles().
    void begin_increment(const double from, const GhostedVector &solution);

    /// The same in the configuration @p start, which the points are paired in
    /// first if they remember more than shears: an interference turns with
    /// them.
    void pair_and_begin_increment(const double         from,
                                  const GhostedVector &start);

    /// An increment moves the obstacles from where they are at one load factor
    /// and in @p start to another, and changes the interferences and the forces
    /// of free motions. Returns whether the points have to be paired anew.
    bool move_obstacles(const double         from,
                        const double         to,
                        const GhostedVector &start = {});

    /**
     * Surfaces that overlap in the mesh are parted along the first increment,
     * of which a step goes from the part @p from to the part @p to: the
     * surfaces of a contact pair are kept apart by (1 - to) of the largest
     * overlap at the
     * @p start, as if they had a clearance, so that each step closes a part of
     * it. An increment in one step closes all of it.
     */
    void ramp_initial_penetration(const double         from,
                                  const double         to,
                                  const GhostedVector &start);

    /// The obstacles are where they are in @p solution. With @p keeps_place the
    /// pairing stays that of before.
    void place_obstacles(const GhostedVector &solution, const bool keeps_place);

    /// All motions that follow from forces, contact pair by contact pair, and
    /// their indices in the solution, behind all multipliers.
    const std::vector<FreeMotion *> &free_motions() const
    {
      return all_motions;
    }

    types::global_dof_index motion_index(const unsigned int motion) const
    {
      return discretization.dof_handler.n_dofs() + n_multipliers() -
             all_motions.size() + motion;
    }

    /// A motion of the pair of @p point in a solution [mm, rad]; one without
    /// multipliers leaves it where the point was paired.
    double motion(const ContactPoint<dim> &point,
                  const unsigned int       number,
                  const GhostedVector     &solution) const
    {
      return solution.size() > discretization.dof_handler.n_dofs()
               ? solution[motion_index(contact_pair(point).first_motion +
                                       number)]
               : point.motions[number].paired;
    }

    /// All of them in a solution [mm, rad]; zero without multipliers.
    std::vector<double> motions(const GhostedVector &solution) const;

    /// The forces of pressures and shears along each free motion [N, of turns N
    /// mm; in 2-D per mm of thickness]: of the tractions in a state, or
    /// @p of_multipliers, which know how slip turns in a step.
    std::vector<double> motion_forces(const GhostedVector &solution,
                                      const GhostedVector &u_start,
                                      const bool of_multipliers) const;

    /// Obstacles that forces move and that touch nothing move until they
    /// touch: a guess of the active set, as activate_nearest().
    void begin_to_touch(const GhostedVector &u);

    /// A spring in the tangent, and there alone, for motions that nothing
    /// resists: next to nothing beside the bodies [N/mm, of turns N mm].
    double motion_spring(const FreeMotion &motion) const;

    /// A step goes this @p way because of a @p missing force. Throws
    /// NotConverged if it is the spring that takes a tenth of it.
    void check_motion(const FreeMotion &motion,
                      const double      way,
                      const double      missing) const;

    /// The largest angle by which an obstacle turns in this increment [rad].
    double largest_turn() const;

    /// Whether obstacles move in this increment.
    bool obstacles_move() const
    {
      return obstacles_are_moving;
    }

    /// Whether the points are paired where the surfaces are undeformed: forces
    /// of contact act there, too.
    bool is_paired_undeformed() const
    {
      return paired_undeformed;
    }

    /// The pairing stands still from now on.
    void clear_changes();

    /// The largest change of a displacement of the surfaces [mm].
    double largest_change(const GhostedVector &u,
                          const GhostedVector &from) const;

    /**
     * The first guess of the active set: points that touch, penetrate, or are
     * closer than a hundredth of the length of their slave edge. What it misses
     * costs time only: the search of the active set finds the rest. It leaves
     * corners of the master out: their conditions may follow from others.
     */
    void initialize_status(const GhostedVector &u);

    /**
     * If no point is in contact, begin with those that come first as the
     * bodies approach each other: the one with the smallest gap, and what is
     * no further than a hundredth of an edge behind it. A guess again. Corners
     * of the master, if no point of the slave is as close.
     */
    void activate_nearest(const GhostedVector &u);

    /// Whether the bounds of shears follow the pressures. Otherwise they are
    /// frozen: Tresca's problem.
    bool bounds_follow = true;

    /// The law of friction that a point obeys at present.
    FrictionLaw law(const ContactPoint<dim> &point) const
    {
      return bounds_follow ? contact_pair(point).law
                           : FrictionLaw{point.friction_bound, 0};
    }

    /// Set the bounds of the next Tresca problem from the present pressures;
    /// return the largest change, relative to the largest bound.
    double update_bounds(const GhostedVector &solution,
                         const GhostedVector &u_start);

    /// Let points whose bound follows a pressure that is not known yet stick
    /// whatever their shear, until the bounds are updated.
    void raise_unknown_bounds();

    /// The bounds of all points [MPa].
    Vector<double> bounds() const;
    void           set_bounds(const Vector<double> &bounds);

    /// Update the statuses of all points in the present state. Returns how many
    /// change; without @p keep they are counted only.
    unsigned int update_statuses(const GhostedVector &solution,
                                 const GhostedVector &u_start,
                                 const bool           keep);

    /// Update the status of the first point only whose status changes.
    void update_first_status(const GhostedVector &solution,
                             const GhostedVector &u_start);

    /**
     * A bound that was frozen while a point was under pressure may leave it no
     * solution as it opens: open it penetrates, closed and held by so much
     * friction it is pulled. It gets the bound of no pressure, until the bounds
     * are updated.
     */
    void reset_bound(const unsigned int point);
    void reset_bounds_of_open_points();

    /// Open the points that a new pairing has moved so far from the master that
    /// they would: to begin with them closed would pull the bodies together.
    void release_parted(const GhostedVector &solution);

    StatusCount count() const;

    /**
     * The norm of the constraint part of @p rhs as a force [N per mm of
     * thickness], to be compared with that of the forces: a gap times the
     * stiffness E/h of the bodies at the point, times its weight.
     */
    double constraint_norm(const GhostedVector &rhs) const;

    /// The statuses of all points, and as numbers.
    std::vector<PointStatus<dim>> statuses() const;
    void set_statuses(const std::vector<PointStatus<dim>> &all);
    std::vector<signed char> signature() const;

    /// The unknowns of a point: displacements of its nodes, its multipliers,
    /// and unknowns of other nodes that its pairing depends on.
    std::vector<types::global_dof_index>
    unknowns_of(const ContactPoint<dim> &point) const;

    /// Add the couplings of the points.
    void add_couplings(DynamicSparsityPattern &pattern) const;

    /// Without friction, where its tangential row is void, and where supports
    /// move it along a tangent, a point in contact slips.
    bool can_stick(const ContactPoint<dim> &point) const;

    /// Whether the normals of other points in contact hold the node of a point
    /// in contact already in all directions, see PointFrames: its tangential
    /// conditions are redundant. @p status_of gives the status of a point by
    /// its number.
    template<typename StatusOf>
    bool is_held_by_others(const unsigned int point,
                           const StatusOf    &status_of) const;

    /// The status of a point under trial values, after the one @p before.
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

    /// Those under the present status in a state.
    Traction<dim> traction(const ContactPoint<dim> &point,
                           const ContactState<dim> &state) const
    {
      return traction(point, point.status, state.p_trial, state.q_trial);
    }

    /// The slip is without what springs give way, see
    /// PointPairing::stick_compliance.
    ContactState<dim> state(const ContactPoint<dim> &point,
                            const GhostedVector     &solution,
                            const GhostedVector     &u_start) const;

  private:
    /// Tell contact pairs the surfaces of others on the same bodies.
    void find_bodies(const std::vector<ContactPair<dim> *> &of_pairs) const;

    /// The direction of slip of a point that cannot stick.
    typename PointStatus<dim>::Direction
    prescribed_direction(const ContactPoint<dim>  &point,
                         const Tensor<1, dim - 1> &q_trial) const;

    /// The slip [mm] with friction that supports prescribe in this increment.
    Tensor<1, dim - 1> slip_of_supports(const ContactPoint<dim> &point) const;

    /// Points that stick and are held by others slip in no direction.
    void release_held();

    /// The statuses or normals are others: in 3-D, the directions in which
    /// points of one node hold each other.
    void find_held_slips();

    void make_free_motions(ContactPair<dim>          &contact_pair,
                           const Parameters::Contact &parameters);
    bool touches(const ContactPair<dim> &contact_pair) const;
    void activate_nearest(const std::vector<const ContactPair<dim> *> &of,
                          const GhostedVector                         &u);

    void check_side(const ContactPair<dim>    &contact_pair,
                    const Parameters::Contact &parameters) const;

    std::vector<ContactPoint<dim>> all_points;
    PointFrames<dim>               frames;
    IndexSet                       own;
    GhostedVector                  support_motion; // of this increment
    bool                           obstacles_are_moving = false;
    bool                           paired_undeformed    = true;
    std::vector<FreeMotion *>      all_motions;
    bool equations_changed = false; // since the last pairing: of motions

    /// Of each normal multiplier the number of its tangential one.
    std::vector<unsigned int> tangential_number;
    unsigned int              n_tangential = 0;
  };



  template<int dim>
  template<typename StatusOf>
  bool ContactInterface<dim>::is_held_by_others(const unsigned int point,
                                                const StatusOf &status_of) const
  {
    return status_of(point).kind != Status::open &&
           frames.tangents_held_by_points(all_points, point, status_of)
               .size() == dim - 1;
  }



  /// As long as it lives the bounds of shears follow the pressures, or are
  /// frozen.
  template<int dim>
  class BoundsWhile
  {
  public:
    BoundsWhile(ContactInterface<dim> &interface, const bool follow)
      : interface(interface)
      , before(interface.bounds_follow)
    {
      interface.bounds_follow = follow;
    }

    BoundsWhile(const BoundsWhile &) = delete;

    ~BoundsWhile()
    {
      interface.bounds_follow = before;
    }

  private:
    ContactInterface<dim> &interface;
    const bool             before;
  };
} // namespace Contact

#endif
