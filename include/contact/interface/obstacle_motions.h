/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_obstacle_motions_h
#define contact_obstacle_motions_h

#include <vector>

#include "contact/interface/contact_pair.h"

namespace Contact
{
  using namespace dealii;

  template<int dim>
  class ContactInterface;

  /// The motions of the obstacles, given by the load factor or free: those
  /// follow from forces, and are unknowns behind all multipliers.
  template<int dim>
  class ObstacleMotions
  {
  public:
    explicit ObstacleMotions(const ContactInterface<dim> &interface)
      : interface(interface)
    {
    }

    /// All motions that follow from forces, contact pair by contact pair.
    std::vector<FreeMotion *> free;

    /// Add the free motions of the next contact pair.
    void add(ContactPair<dim>          &contact_pair,
             const Parameters::Contact &parameters);

    /// The index of a free motion in the solution.
    types::global_dof_index index(const unsigned int motion) const;

    /// A motion of the pair of @p point in a solution [mm, rad]; one without
    /// multipliers leaves it where the point was paired.
    double value(const ContactPoint<dim> &point,
                 const unsigned int       number,
                 const GhostedVector     &solution) const;

    /// All free motions in a solution [mm, rad]; zero without multipliers.
    std::vector<double> values(const GhostedVector &solution) const;

    /// The forces of pressures and shears along each free motion [N, of turns N
    /// mm; in 2-D per mm of thickness]: of the tractions in a state, or
    /// @p of_multipliers, which know how slip turns in a step.
    std::vector<double> forces(const GhostedVector &solution,
                               const GhostedVector &u_start,
                               const bool           of_multipliers) const;

    /// An increment moves the obstacles from where they are at one load factor
    /// and in @p start to another, and changes the interferences and the forces
    /// of free motions. Returns whether the points have to be paired anew.
    bool
    move(const double from, const double to, const GhostedVector &start = {});

    /// Whether obstacles move in this increment.
    bool are_moving() const
    {
      return moving;
    }

    /// Slip is the straight way of the obstacle's material between two ends of
    /// an increment; in 3-D shear is off its direction by half of the angle.
    /// Throws NotConverged where an obstacle turns by more than 90 degrees, in
    /// 3-D by 20, within this increment.
    void check_rotations() const;

    /// The obstacles are where they are in @p solution. With @p keeps_place the
    /// pairing stays that of before.
    void place(const GhostedVector &solution, const bool keeps_place);

    /// Place the obstacles for a new pairing. Returns whether other motions
    /// stay than in the last one: then the equations couple other unknowns.
    bool place_for_pairing(const GhostedVector &solution);

    /// A spring in the tangent, and there alone, for motions that nothing
    /// resists: next to nothing beside the bodies [N/mm, of turns N mm].
    double spring(const FreeMotion &motion) const;

    /// A step goes this @p way because of a @p missing force. Throws
    /// NotConverged if it is the spring that takes a tenth of it.
    void check(const FreeMotion &motion,
               const double      way,
               const double      missing) const;

  private:
    const ContactInterface<dim> &interface;
    bool                         moving            = false;
    bool                         equations_changed = false;
  };
} // namespace Contact

#endif
