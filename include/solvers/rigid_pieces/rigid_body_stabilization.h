/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_rigid_body_stabilization_h
#define contact_rigid_body_stabilization_h

#include <deal.II/base/conditional_ostream.h>

#include "model/increment_state.h"
#include "solvers/rigid_pieces/rigid_body_modes.h"
#include "solvers/rigid_pieces/rigid_rotation.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The stabilization of rigid body modes: a piece of a body that neither
   * supports nor contact hold is held by springs so soft that the load carries
   * it to where contact holds it. Then they are hung up where the piece is, and
   * so on: the proximal point method (Rockafellar, SIAM J. Control Optim. 14,
   * 1976), at whose end they do nothing. Where it goes on, nothing holds it.
   */
  template<int dim>
  class RigidBodyStabilization
  {
  public:
    RigidBodyStabilization(const ContactModel<dim> &model,
                           ConditionalOStream      &screen);

    /// Nothing is held; @p model has points that are paired. Collective.
    void begin_level();

    /// Hold the pieces that could move without resistance, those that points in
    /// contact with @p contact (may be null) hold excepted. Returns whether
    /// that is news. Collective.
    bool stabilize_free_pieces(const ContactInterface<dim> *contact);

    /// The increment that begins or is repeated; the next one needs none of
    /// what is held.
    void begin_increment();
    void end_increment();

    /// Whether a piece is held, and whether one more than at the increment's
    /// start.
    bool is_needed() const;
    bool has_grown() const;

    /// The bodies that springs hold, for the reason why there is no solution;
    /// empty if nothing is held.
    std::string remark() const;

    /// Take the springs away. Returns the forces that they exerted, by
    /// unknown [N per mm of thickness]; none if nothing was held. Collective.
    GhostedVector release(const IncrementState<dim> &state);

    /// Whether contact alone holds a piece, without springs. Collective.
    bool may_help() const
    {
      return held.empty() &&
             !rigid_body_modes<dim>(*model.discretization, nullptr).empty();
    }

    /// Stiffer springs after soft ones, on which bodies have gone astray: a
    /// long way takes more iterations on these. After stiffer ones soft ones,
    /// for smaller steps. Returns whether they are stiffer now.
    bool stiffen()
    {
      is_stiff = !is_stiff && !held.empty();
      return is_stiff;
    }

    /**
     * Choose the stiffness of the springs, in proportion to that of the softest
     * body. What turns in itself is held against that as by a body. Collective.
     */
    void choose_stiffness();

    /// Hang up the springs where the pieces are. Collective.
    void attach(const GhostedVector &solution);

    /// The work of the springs since then.
    struct Work
    {
      unsigned int piece = 0; // the one with the most
      double       work  = 0; // [N mm per mm of thickness]
      double       force = 0; // of its springs [N per mm of thickness]

      /// Whether the springs do nothing beside the bodies' strain energy and
      /// forces, or no more than Newton's tolerance leaves.
      bool is_little(const double energy,
                     const double force_scale,
                     const double tolerance) const
      {
        return (work <= 1e-8 * energy && force <= 1e-5 * force_scale) ||
               force <= tolerance * force_scale;
      }
    };

    Work work(const GhostedVector &solution) const;

    /// Throws NotConverged: nothing stops the piece.
    [[noreturn]] void give_up(const Work        &work,
                              const unsigned int n_iterations) const;

  private:
    const ContactModel<dim> &model;
    ConditionalOStream      &screen;

    std::vector<RigidBodyMode> held;
    std::size_t                n_at_start = 0;
    bool                       is_stiff   = false;
    std::vector<SpinningPiece> turning; // in itself, on this mesh

    // By piece, and the larger one of k and kappa/R^2.
    std::map<unsigned int, SpringStiffness> stiffness;
    std::map<unsigned int, double>          stiffest;
  };
} // namespace Contact

#endif
