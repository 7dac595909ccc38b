/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/rigid_pieces/rigid_body_stabilization.h"

#include <algorithm>
#include <limits>
#include <sstream>

#include "base/errors.h"

namespace Contact
{
  template<int dim>
  RigidBodyStabilization<dim>::RigidBodyStabilization(
    const ContactModel<dim> &model,
    ConditionalOStream      &screen)
    : model(model)
    , screen(screen)
  {
  }



  template<int dim>
  void RigidBodyStabilization<dim>::begin_level()
  {
    held.clear();
    is_stiff = false;
    if (model.interface)
      turning = turning_pieces(*model.discretization,
                               *model.elasticity,
                               *model.interface);
  }



  template<int dim>
  bool RigidBodyStabilization<dim>::stabilize_free_pieces(
    const ContactInterface<dim> *contact)
  {
    auto free = rigid_body_modes<dim>(*model.discretization, contact);
    for (const SpinningPiece &piece : turning)
      free.push_back({piece.piece, "rotation", 1});
    bool news = false;
    for (const RigidBodyMode &motion : free)
      if (std::none_of(held.begin(),
                       held.end(),
                       [&](const RigidBodyMode &known) {
                         return known.piece == motion.piece;
                       }))
        {
          held.push_back(motion);
          news = true;
          screen << "  nothing holds " << model.mesh->piece_name(motion.piece)
                 << " against: " << motion.name
                 << "; it is stabilized by springs" << std::endl;
        }
    return news;
  }



  template<int dim>
  void RigidBodyStabilization<dim>::begin_increment()
  {
    n_at_start = held.size();
  }



  template<int dim>
  void RigidBodyStabilization<dim>::end_increment()
  {
    held.clear();
  }



  template<int dim>
  bool RigidBodyStabilization<dim>::is_needed() const
  {
    return !held.empty();
  }



  template<int dim>
  bool RigidBodyStabilization<dim>::has_grown() const
  {
    return held.size() > n_at_start;
  }



  template<int dim>
  std::string RigidBodyStabilization<dim>::remark() const
  {
    std::string remark;
    for (const RigidBodyMode &motion : held)
      remark += (remark.empty() ? "; nothing but springs holds " : ", nor ") +
                model.mesh->piece_name(motion.piece) +
                " against: " + motion.name;
    return remark;
  }



  template<int dim>
  GhostedVector
  RigidBodyStabilization<dim>::release(const IncrementState<dim> &state)
  {
    Elasticity<dim> &elasticity = *model.elasticity;
    const bool       is_held    = !elasticity.springs.held().empty();
    if (!is_held)
      {
        elasticity.springs.release();
        return {};
      }
    GhostedVector springs =
      elasticity.forces(state.solution, state.load_factor);
    elasticity.springs.release();
    springs.sadd(-1, 1, elasticity.forces(state.solution, state.load_factor));
    return springs;
  }



  // Far softer than any body, yet far above the round-off of the stiffest. What
  // turns in itself is held as stiffly as by a body: the corners of polygons
  // that slide on each other turn it with the stiffness of the bodies times
  // (h/2R)^2, h the length of the edges, R the radius of the surface.
  template<int dim>
  void RigidBodyStabilization<dim>::choose_stiffness()
  {
    const auto  &springs = model.elasticity->springs;
    const double share   = is_stiff ? 1e-4 : 1e-6;
    double       softest = std::numeric_limits<double>::max();
    for (const auto &body : model.mesh->bodies)
      softest =
        std::min(softest, model.elasticity->youngs_modulus(body.second));
    stiffness.clear();
    stiffest.clear();
    for (const RigidBodyMode &motion : held)
      stiffest[motion.piece] = stiffness[motion.piece].translation =
        share * softest * springs.mean_depth(motion.piece);
    for (const SpinningPiece &piece : turning)
      {
        stiffest[piece.piece] = softest * springs.mean_depth(piece.piece);
        stiffness[piece.piece].rotation =
          stiffest[piece.piece] * piece.radius * piece.radius;
      }
  }



  // Against rotation, what turns in itself is held for good.
  template<int dim>
  void RigidBodyStabilization<dim>::attach(const GhostedVector &solution)
  {
    GhostedVector rest = solution;
    remove_rotations(*model.discretization, turning, rest);
    model.elasticity->springs.hold(stiffness, rest);
  }



  template<int dim>
  typename RigidBodyStabilization<dim>::Work
  RigidBodyStabilization<dim>::work(const GhostedVector &solution) const
  {
    GhostedVector u = solution;
    remove_rotations(*model.discretization, turning, u);
    const auto   works = model.elasticity->springs.energy(u);
    const auto   most  = std::max_element(works.begin(),
                                       works.end(),
                                       [](const auto &a, const auto &b) {
                                         return a.second < b.second;
                                       });
    const double work  = most->second;
    return {most->first, work, std::sqrt(2 * stiffest.at(most->first) * work)};
  }



  template<int dim>
  void
  RigidBodyStabilization<dim>::give_up(const Work        &work,
                                       const unsigned int n_iterations) const
  {
    const auto motion =
      std::find_if(held.begin(), held.end(), [&](const RigidBodyMode &motion) {
        return motion.piece == work.piece;
      });
    std::ostringstream message;
    message << "nothing stops " << model.mesh->piece_name(motion->piece)
            << " in its " << motion->name << ": stabilization still carries "
            << work.force << " N" << model.discretization->per_thickness()
            << " after " << n_iterations << " iterations";
    throw NotConverged(message.str());
  }

  template class RigidBodyStabilization<2>;
  template class RigidBodyStabilization<3>;
} // namespace Contact
