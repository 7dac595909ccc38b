/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_invariants_h
#define contact_invariants_h

#include <array>
#include <boost/serialization/array.hpp>
#include <boost/serialization/vector.hpp>
#include <map>
#include <string>

#include "contact/interface/obstacle_forces.h"
#include "solid/elasticity.h"
#include "verification/contact_check.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Energy and works since the start [N mm per mm of thickness]:
   *   strain energy = works of the loads, moved supports and moved obstacles
   *     (external), of the pressures (contact), of the shears (friction), of
   *     what else holds the bodies (stabilization), and path work.
   * See InvariantCheck. The dissipation is that of the slip law, which is
   * never negative; it and minus the friction work agree in the limit of many
   * increments, where contact work and path work vanish.
   */
  struct Works
  {
    double strain_energy      = 0;
    double external_work      = 0;
    double contact_work       = 0;
    double friction_work      = 0;
    double stabilization_work = 0;
    double path_work          = 0;
    double dissipation        = 0;
    double plastic_work       = 0; // dissipated
    double thermal_work       = 0; // of thermal strains
  };



  /**
   * The invariants of contact and of the bodies after a load increment. Of
   * several levels of refinement each starts from the undeformed bodies.
   */
  struct Invariants
    : public ContactInvariants
    , public Works
  {
    /// The norm of the forces that are left over where no support acts, by F.
    double equilibrium = 0;

    /// The largest distance of a supported node from where it has to be [mm].
    double supports = 0;

    /// The imbalance of works and energy in this increment, by the larger of
    /// the sum of the magnitudes of its terms and of strain energy and external
    /// work.
    double energy_imbalance = 0;

    /// The reactions of each group of supports on the bodies, by direction, in
    /// the frame of the mesh [N per mm of thickness; axisymmetric: N]. A node
    /// of two groups counts in both.
    std::map<std::string, std::map<std::string, double>> reactions;

    /// By name, for the summary.
    std::map<std::string, double> measures() const
    {
      return {{"force_imbalance", force_imbalance},
              {"moment_imbalance", moment_imbalance},
              {"equilibrium", equilibrium},
              {"supports", supports},
              {"complementarity", augmentation_parameter},
              {"friction_cone", cone},
              {"slip", slip},
              {"penetration", penetration},
              {"relative_penetration", relative_penetration},
              {"energy_imbalance", energy_imbalance}};
    }
    std::map<std::string, double> works() const
    {
      return {{"strain_energy", strain_energy},
              {"external", external_work},
              {"contact", contact_work},
              {"friction", friction_work},
              {"stabilization", stabilization_work},
              {"path", path_work},
              {"dissipation", dissipation},
              {"plastic_dissipation", plastic_work},
              {"thermal", thermal_work}};
    }
  };



  /**
   * Check the invariants of one increment after the other, by a computation
   * of its own: from the energy and the forces of the bodies, and from what
   * ContactCheck finds.
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
   * discretization, with each work by the trapezoidal rule. Of materials the
   * path work is MaterialLaw::works(), and E_1 - E_0 has what yielding
   * dissipates beside it. It holds up to what
   * Newton's method leaves of the residual: |r . d| <= tolerance F |d|.
   *
   * Reactions work where supports are moved, and what obstacles exert where
   * these are, F . (motion of the centre) + M . rotation, and the preload of
   * cuts that are shortened, by the trapezoidal rule: that much of the works of
   * pressures and shears on the bodies comes from outside. Pressures would not
   * work if points touched along the whole path or not at all; those that open
   * or close within the increment do, of the second order in its length, and so
   * do the turning normals of large displacement. The dissipation is -sum w q s
   * with the q of the end, as the slip law has it (implicit Euler).
   *
   * @par Tolerances
   * An invariant is violated if it is further off than the tolerances of the
   * solution explain. Forces and gaps: Newton's tolerance times F. With the
   * bounds of the shear by a fixed point, they change by the friction tolerance
   * times the largest bound after the last Newton step. There are no others,
   * but round-off.
   *
   * @par Resolution
   * F knows the reactions, and the round-off of the stiffest body. A state with
   * the residual r has forces that are off by r . v, v the displacements of the
   * size of one that a unit force belongs to. So r has to be far below the
   * loads; where supports or obstacles move the bodies, far below the forces of
   * supports and contact in the state, which are off by no more than that, or
   * where none acts yet, below what the softest body resists the given way
   * with. Otherwise the loads, or the way, are not in the solution.
   *
   * @par Cost
   * Two passes over the cells without a tangent; a third in large displacement.
   */
  template<int dim>
  class InvariantCheck
  {
  public:
    /// The state at the start of an increment, all that the next one needs.
    struct State : public Works
    {
      /// Displacements [mm], and forces on the nodes [N per mm]: loads and
      /// reactions; of the pressures and the shears of contact; of what else
      /// holds the bodies. Forces of nothing that acts have size 0.
      GhostedVector displacement;
      GhostedVector external, pressures, shears, holds;

      /// Of each contact pair with an obstacle, see obstacle_forces().
      std::vector<std::array<ObstacleForce<dim>, 2>> obstacles;

      /// Of each free motion, for those of cuts: where it is [mm], and its
      /// force.
      std::vector<double> motions, motion_forces;

      /// All of them with the unknowns of @p distribution.
      std::vector<GhostedVector *> vectors(const Distribution &distribution)
      {
        const std::vector<GhostedVector *> all = {&displacement,
                                                  &external,
                                                  &pressures,
                                                  &shears,
                                                  &holds};
        for (GhostedVector *vector : all)
          if (vector->size() == 0)
            *vector = GhostedVector(distribution);
        return all;
      }

      template<class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &strain_energy &external_work &contact_work &friction_work
          &stabilization_work &path_work &dissipation &plastic_work
            &thermal_work &obstacles &motions &motion_forces;
      }
    };

    /// Start from the undeformed bodies without loads. @p interface may be
    /// null.
    InvariantCheck(const Discretization<dim>   &discretization,
                   const Elasticity<dim>       &elasticity,
                   const ContactInterface<dim> *interface,
                   const Parameters::Solution  &parameters);

    /**
     * Check the converged state @p solution under @p load_factor. The residual
     * is below @p newton_tolerance times @p reference_force [N per mm; 0: as an
     * absolute value]. @p hold_forces are what else acts on the nodes, if
     * anything does; by @p moved [mm] the pairing may have the projection
     * points of points off the closest ones. The data alone tell of forces of
     * the size of @p given_force [N per mm; 0: of none].
     */
    Invariants check(const GhostedVector &solution,
                     const double         load_factor,
                     const double         newton_tolerance,
                     const double         reference_force,
                     const GhostedVector *hold_forces = nullptr,
                     const double         moved       = 0,
                     const double         given_force = 0);

    /// The increment that was checked last is accepted: the next one starts
    /// from its end. Without, the increment is repeated from the same start.
    void advance()
    {
      start = std::move(end);
    }

    /// The start of the next increment.
    const State &state() const
    {
      return start;
    }
    void restore(const State &state)
    {
      start = state;
    }

  private:
    void        balance_bodies(const double         load_factor,
                               const Slack         &slack,
                               const GhostedVector *hold_forces,
                               const double         given_force,
                               Invariants          &found);
    void        judge_balance(const double residual,
                              const Slack &slack,
                              const bool   is_held,
                              Invariants  &found) const;
    void        judge_resolution(const double residual,
                                 const double given_force,
                                 const double acting,
                                 const Slack &slack,
                                 Invariants  &found);
    std::string in_words(const double force) const;

    /// The norm of the forces that free motions lack [N per mm].
    double missing_in_motions() const;

    void add_up(const GhostedVector &reactions, Invariants &found) const;
    void add_rigid(const RigidBoundary<dim> &boundary,
                   const double              load_factor,
                   const GhostedVector      &left,
                   GhostedVector            &reactions,
                   Invariants               &found) const;
    void check_energy(const Slack &slack, Invariants &found);

    /// The works of pressures and shears in the motion of the obstacles, and of
    /// preloads.
    std::array<double, 2> work_of_obstacles() const;

    /// The work of the internal forces in the middle of the increment along its
    /// whole way @p d.
    double work_at_middle(const GhostedVector &d) const;

    const Discretization<dim>   &discretization;
    const Elasticity<dim>       &elasticity;
    const ContactInterface<dim> *interface;
    const Parameters::Solution   parameters;

    State  start, end;
    double largest_load   = 0; // of free motions as well, of all increments
    double largest_acting = 0; // so far, of given displacements [N per mm]
  };
} // namespace Contact

#endif
