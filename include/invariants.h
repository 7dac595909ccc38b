/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_invariants_h
#define contact_invariants_h

#include <map>
#include <string>
#include <vector>

#include "contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /**
   * What has to hold after a load increment, whatever the mesh: how far it does
   * not. All ranks get the same numbers. Of several levels of refinement each
   * starts from the undeformed bodies.
   *
   * What is relative to the force F [N per mm] is so to the one that Newton's
   * method is relative to; a gap g becomes a force as w k g, with the weight w
   * of the point and the stiffness k = E/h of its slave edge.
   */
  struct Invariants
  {
    /// The forces of contact on slave and master together, and their moment
    /// about the middle of the slave by its size, by the sum of the magnitudes
    /// of all these forces.
    double force_imbalance  = 0;
    double moment_imbalance = 0;

    /// The norm of the forces that are left over where no support acts, by F.
    double equilibrium = 0;

    /// The largest of: a negative pressure in contact; a gap in contact, a
    /// multiplier where open (in the weak sense of the rule); with the nodal
    /// and the mortar rule, a penetration where open. By F.
    double complementarity = 0;

    /// The largest |q| - bound of the friction law under the present pressure,
    /// by the largest bound.
    double cone = 0;

    /// The largest slip of what sticks (in the weak sense of the rule) and,
    /// with the nodal and the mortar rule, slip along the shear instead of
    /// against it. By F.
    double slip = 0;

    /// The largest -gap [mm] of all points, also by the length of the slave
    /// edge, and where, undeformed. With the Gauss rule surfaces penetrate
    /// each other between the nodes: no violation.
    double   penetration          = 0;
    double   relative_penetration = 0;
    Point<2> deepest;

    /**
     * Energy and works since the start [N mm per mm of thickness]:
     *   strain energy = works of the loads and moved supports (external), of
     *     the pressures (contact), of the shears (friction), of what else holds
     *     the bodies (stabilization), and path work.
     * See InvariantCheck. The dissipation is that of the slip law, which is
     * never negative; it and minus the friction work agree in the limit of
     * many increments, where contact work and path work vanish.
     */
    double strain_energy      = 0;
    double external_work      = 0;
    double contact_work       = 0;
    double friction_work      = 0;
    double stabilization_work = 0;
    double path_work          = 0;
    double dissipation        = 0;

    /// What is missing to the equation above in this increment, by the larger
    /// of the sum of the magnitudes of its terms and of strain energy and
    /// external work.
    double energy_imbalance = 0;

    /// One sentence for each invariant that is violated: which, by how much,
    /// where, what to do.
    std::vector<std::string> violations;

    /// By name, for the summary.
    std::map<std::string, double> measures() const;
    std::map<std::string, double> works() const;
  };



  /**
   * Check the invariants of one increment after the other, by a computation
   * of its own: from the displacements, the decisions and multipliers of the
   * points, the energy and the forces of the bodies.
   *
   * @par Forces
   * A point exerts w (p n + q t) C_a on its node a. These add up to zero
   * because the C_a do. With r = sum C_a x_a = g n + o t their moment is
   *   w (g q - o p):
   * zero where the gap is, if the foot is the closest point (o = 0). With the
   * Gauss rule the gap is zero in the mean only; over a corner of the master
   * the foot stays behind; with the geometry frozen, the foot is that of the
   * last turn: |o| <= sqrt(2) sum |C_a| (geometry tolerance) max |du|. So much
   * is the method's own. With undeformed geometry the moments are those of the
   * undeformed bodies.
   *
   * @par Complementarity and friction
   * The weak conditions of the rule are what Newton's method has solved, for
   * each multiplier k,
   *   sum w psi_k (p - lambda_n)/c = 0,  sum w psi_k (q - lambda_t)/c = 0.
   * With a point per multiplier (nodal, mortar; there gap and slip are the
   * weighted ones) they say g = 0 in contact, lambda = 0 where open, s = 0
   * where it sticks; from p = max(0, lambda - c g) follow p >= 0 and g >= 0,
   * from the slip law q s <= 0, point by point. The Gauss rule has several
   * points per multiplier and promises the weak conditions and p >= 0. Gaps
   * are those of the pairing of the last turn. Where most points of an edge
   * face nothing, they pull its multipliers to zero, and what is left is a
   * penalty -c g, with c far below the stiffness of the bodies: if that makes
   * half of the largest pressure, the bodies pass through each other.
   *
   * @par Energy
   * Along the straight path from u_0 to u_1 = u_0 + d of an increment the
   * energy E changes by the integral of f(u_0 + t d) . d over t from 0 to 1, f
   * the internal forces. In small strain f is linear in t: the trapezoidal rule
   * is exact. In large displacement it is a polynomial of degree 3 (St.
   * Venant-Kirchhoff): Simpson's rule is exact,
   *   E_1 - E_0 = 1/2 (f_0 + f_1) . d + path work,
   *   path work = 2/3 (f_1/2 . d - 1/2 (f_0 + f_1) . d).
   * At both ends there is equilibrium: f = load + reactions + forces of contact
   * (+ forces that hold the bodies). Hence an identity without an error of time
   * discretization, with each work by the trapezoidal rule. It holds up to what
   * Newton's method leaves of the residual: |r . d| <= tolerance F |d|.
   *
   * Reactions work where supports are moved. Pressures would not work if points
   * touched along the whole path or not at all; those that open or close within
   * the increment do, of the second order in its length, and so do the turning
   * normals of large displacement. The dissipation is -sum w q s with the q of
   * the end, as the slip law has it (implicit Euler).
   *
   * @par Tolerances
   * An invariant is violated if it is further off than the tolerances of the
   * solution explain. Forces and gaps: Newton's tolerance times F. With the
   * bounds of the shear by a fixed point, they change by the friction tolerance
   * times the largest bound after the last Newton step. There are no others,
   * but round-off.
   *
   * @par Cost
   * Two passes over the cells without a tangent; a third in large displacement.
   */
  class InvariantCheck
  {
  public:
    /// The state at the start of an increment, all that the next one needs.
    struct State
    {
      /// Displacements [mm], and forces on the nodes [N per mm]: loads and
      /// reactions; of the pressures and the shears of contact; of what else
      /// holds the bodies. Full on all ranks.
      Vector<double> displacement;
      Vector<double> external, pressures, shears, holds;

      /// The works so far.
      double strain_energy = 0, external_work = 0, contact_work = 0,
             friction_work = 0, stabilization_work = 0, path_work = 0,
             dissipation = 0;

      template<class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &displacement &external &pressures &shears &holds;
        archive &strain_energy &external_work &contact_work &friction_work
          &stabilization_work &path_work &dissipation;
      }
    };

    /// Start from the undeformed bodies without loads. @p interface may be
    /// null.
    InvariantCheck(const Discretization       &discretization,
                   const Elasticity           &elasticity,
                   const ContactInterface     *interface,
                   const Parameters::Solution &parameters);

    /**
     * Check the converged state @p solution under @p load_factor. The residual
     * is below @p newton_tolerance times @p reference_force [N per mm; 0: as an
     * absolute value]. @p hold_forces are what else acts on the nodes, if
     * anything does.
     */
    Invariants check(const Vector<double> &solution,
                     const double          load_factor,
                     const double          newton_tolerance,
                     const double          reference_force,
                     const Vector<double> *hold_forces = nullptr);

    /// The increment that was checked last is accepted: the next one starts
    /// from its end. Without, the increment is repeated from the same start.
    void advance();

    /// For a restart.
    const State &state() const;
    void         restore(const State &state);

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &start;
    }

  private:
    /// What the tolerances leave open in this state.
    struct Slack
    {
      double force;           // Newton's tolerance [N per mm]
      double relative;        // Newton's tolerance
      double shear       = 0; // of the bounds by a fixed point [MPa]
      double shear_force = 0; // the same on all points [N per mm]
    };

    /// The largest value, and a sentence about the worst one.
    struct Worst
    {
      double      value  = 0; // of all
      double      excess = 0; // over its slack, of all
      std::string sentence;

      /// @p say is asked for the sentence if need be.
      template<class Say>
      void add(const double value, const double slack, const Say &say);

      bool is_violated() const;
    };

    void find_tractions(const Vector<double> &solution);
    void add_forces();
    void check_balance(const ContactZone &zone,
                       const Slack       &slack,
                       Invariants        &found) const;
    void check_normal(const Slack &slack, Invariants &found) const;
    void check_tangential(const Slack &slack, Invariants &found) const;
    void balance_bodies(const double          load_factor,
                        const double          force,
                        const Slack          &slack,
                        const Vector<double> *hold_forces,
                        Invariants           &found);
    void check_energy(const Slack &slack, Invariants &found);

    double   slave_edge_length(const ContactPoint &point) const;
    Point<2> place(const ContactPoint &point) const;

    const Discretization   &discretization;
    const Elasticity       &elasticity;
    const ContactInterface *interface;
    const bool              moving_bound, undeformed_geometry;
    const double            friction_tolerance, geometry_tolerance;

    State start, end;

    // Of the state that is checked, by point.
    std::vector<ContactState> states;
    std::vector<Traction>     tractions;
    double                    largest_bound = 0; // [MPa]
    double                    force         = 1; // F
  };
} // namespace Contact

#endif
