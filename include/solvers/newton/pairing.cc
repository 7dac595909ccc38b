/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/newton/pairing.h"

#include <algorithm>

#include "base/errors.h"
#include "base/string_utilities.h"

namespace Contact
{
  using Parameters::GeometryLoop;

  template<int dim>
  Pairing<dim>::Pairing(const ContactModel<dim> &model,
                        const Parameters::All   &parameters,
                        TimerOutput             &timer)
    : model(model)
    , parameters(parameters)
    , timer(timer)
    , guard(parameters.solution.geometry_tolerance)
  {
  }



  template<int dim>
  void Pairing<dim>::begin_level(LinearSystem<dim> &system)
  {
    this->system = &system;
    freeze(false);
  }



  template<int dim>
  bool Pairing<dim>::follows() const
  {
    return model.geometry_follows(parameters.solution);
  }



  template<int dim>
  bool Pairing<dim>::follows_each_step() const
  {
    return follows() && parameters.solution.pairs_each_step();
  }



  // The tangent knows how projections and normals move as long as they do.
  template<int dim>
  void Pairing<dim>::freeze(const bool frozen)
  {
    is_frozen = frozen;
    present.moving_geometry =
      parameters.geometry(model.n_displacements()) == GeometryLoop::newton &&
      !frozen;
    if (dim == 3 && frozen && model.interface)
      model.interface->clear_changes();
  }



  // Unsymmetric condensed matrices in 3-D have the stiffness of the pairing,
  // but for bodies that springs hold: it may be negative, and stronger.
  template<int dim>
  bool Pairing<dim>::has_derivatives() const
  {
    return present.moving_geometry ||
           (dim == 3 && follows_each_step() && model.interface->bounds.follow &&
            (model.has_friction() || is_in_tangent) &&
            model.elasticity->springs.held().empty());
  }



  template<int dim>
  bool Pairing<dim>::use_consistent_tangent()
  {
    if (is_in_tangent || has_derivatives())
      return false;
    is_in_tangent = true;
    is_in_tangent = has_derivatives();
    return is_in_tangent;
  }



  template<int dim>
  void Pairing<dim>::pair(const GhostedVector &configuration)
  {
    pair(configuration, {has_derivatives()});
  }



  template<int dim>
  void Pairing<dim>::pair_near_contact(const GhostedVector &configuration,
                                       const bool           from_coarser_mesh)
  {
    PairingMode mode{has_derivatives()};
    mode.keeps_open_points = dim == 3 && follows_each_step();
    mode.leaves_far_points = mode.keeps_open_points && from_coarser_mesh;
    pair(configuration, mode);
  }



  template<int dim>
  bool Pairing<dim>::complete()
  {
    if (is_complete)
      return false;
    PairingMode mode{has_derivatives()};
    mode.is_rest = true;
    pair(GhostedVector(paired_at), mode);
    return true;
  }



  template<int dim>
  void Pairing<dim>::pair(const GhostedVector &configuration,
                          const PairingMode   &mode)
  {
    bool changed = false;
    {
      TimerOutput::Scope scope(timer, "search");
      paired_at   = configuration;
      is_complete = !mode.keeps_open_points;
      if (model.interface && !mode.is_rest)
        ++model.discretization->counters.pairings;
      if (follows() && !configuration.all_zero() && !mode.is_rest)
        ++model.discretization->counters.geometry_updates;
      const bool is_undeformed =
        parameters.solution.geometry == GeometryLoop::undeformed;
      changed = model.interface &&
                model.interface->pair(is_undeformed
                                        ? GhostedVector(
                                            model.discretization->distribution)
                                        : configuration,
                                      mode);
    }
    system->update_pattern(changed);
  }



  template<int dim>
  void Pairing<dim>::renew(const GhostedVector &solution,
                           Relaxation          &relaxation)
  {
    const double part =
      relaxation.length(model.discretization->displacements(solution));
    GhostedVector configuration = paired_at;
    configuration.sadd(1 - part, part, solution);
    pair(configuration);
  }



  template<int dim>
  void Pairing<dim>::add_contact(const IncrementState<dim> &state,
                                 GhostedVector             &rhs) const
  {
    if (!model.interface)
      return;
    rhs.zero_out_ghosts();
    ContactKernel<dim>(*model.interface)
      .assemble(state.solution, state.start, linearization(), rhs, nullptr);
    rhs.compress_add();
  }



  template<int dim>
  void Pairing<dim>::begin_newton()
  {
    guard      = PairingCycleControl(parameters.solution.geometry_tolerance);
    relaxation = Relaxation();
    jump.reset();
    freeze(false);
  }



  template<int dim>
  void Pairing<dim>::begin_increment(const double part)
  {
    this->part = part;
    if (model.interface)
      for (const auto &contact_pair : model.interface->pairs)
        contact_pair->begin_increment();
  }



  template<int dim>
  void Pairing<dim>::follow(const GhostedVector &solution,
                            const bool           after_a_step)
  {
    if (!follows_each_step() || is_frozen)
      return;
    if (!after_a_step || has_derivatives())
      {
        extrapolation.forget();
        pair_near_contact(solution);
        return;
      }
    GhostedVector step = model.discretization->displacements(solution);
    step -= model.discretization->displacements(paired_at);
    const double  length        = extrapolation.length(step);
    GhostedVector configuration = paired_at;
    configuration.sadd(1 - length, length, solution);
    pair_near_contact(length == 1 ? solution : configuration);
  }



  template<int dim>
  double Pairing<dim>::misplacement(const IncrementState<dim> &state) const
  {
    return model.interface->largest_change(state.solution, paired_at);
  }



  template<int dim>
  double Pairing<dim>::way(const IncrementState<dim> &state) const
  {
    return model.interface->largest_change(state.solution, state.start);
  }



  template<int dim>
  void Pairing<dim>::advance(const IncrementState<dim> &state,
                             const GhostedVector       &last,
                             const bool                 progress)
  {
    if (!follows_each_step())
      return;
    guard.advance(model.interface->largest_change(state.solution, last),
                  way(state),
                  progress);
  }



  template<int dim>
  bool Pairing<dim>::has_been_frozen(const bool stands_still)
  {
    if (!follows_each_step() || is_frozen ||
        !(stands_still || guard.is_frozen()))
      return false;
    guard.freeze();
    freeze(true);
    return true;
  }



  // The closest points must make no difference to the gaps, nor to where forces
  // act, if the pairing does not come to rest. A jump does not
  // get smaller with the steps: its measure is the way of a whole increment.
  template<int dim>
  bool Pairing<dim>::accepts(const IncrementState<dim> &state)
  {
    if (!follows_each_step())
      return true;
    if (guard.accepts(misplacement(state), way(state)))
      return true;
    if (!guard.cycles())
      return false;
    const ProjectionMismatch found = mismatch_of(state);
    if (!guard.accepts(found, way(state) / part))
      return false;
    if (!found.is_below(Utilities::fixed_power<2>(
                          parameters.solution.geometry_tolerance),
                        way(state)))
      jump = found;
    return true;
  }



  template<int dim>
  ProjectionMismatch
  Pairing<dim>::mismatch_of(const IncrementState<dim> &state) const
  {
    return mismatch(*model.interface, state.solution, state.start);
  }



  // A pairing at rest has no projection point that has moved further than the
  // surfaces.
  template<int dim>
  double
  Pairing<dim>::shift_of_projections(const IncrementState<dim> &state) const
  {
    if (!follows())
      return 0;
    return jump ? jump->shift : misplacement(state);
  }



  template<int dim>
  void Pairing<dim>::renew(const IncrementState<dim> &state)
  {
    if (guard.cycles())
      {
        if (!use_consistent_tangent())
          throw NotConverged("the pairing jumps: " + unsettled(state));
        begin_newton();
      }
    guard.renew(misplacement(state));
    renew(state.solution, relaxation);
  }



  template<int dim>
  std::string Pairing<dim>::unsettled(const IncrementState<dim> &state) const
  {
    std::string what = "the surfaces are " + brief(misplacement(state)) +
                       " mm from where they were paired, of ";
    if (guard.cycles())
      {
        const ProjectionMismatch found = mismatch_of(state);
        what = "the closest points do not come to rest: their gaps differ by " +
               brief(found.gap) + " mm, and forces are moved by " +
               brief(100 * found.offset) + " % of the size of the slave" +
               (found.unheld > 0 ? ", " + brief(100 * found.unheld) +
                                     " % of them have no closest point"
                                 : "") +
               ", where the surfaces move by ";
      }
    const auto &pairs = model.interface->pairs;
    const bool  is_mortar =
      std::all_of(pairs.begin(), pairs.end(), [](const auto &contact_pair) {
        return contact_pair->is_mortar();
      });
    return what + brief(way(state)) +
           " mm in this step. Where a node of the slave slides over a corner of "
           "the master it may face the edges on either side in turn, and at the "
           "end of the master it and nothing: a finer master or one that "
           "reaches further, " +
           (is_mortar ? "or Mesh/Arcs"
                      : "Mesh/Arcs, or the mortar discretization");
  }



  template<int dim>
  std::string Pairing<dim>::note(const double moment_imbalance) const
  {
    if (!jump)
      return {};
    return "pairing: closest points jump between two places and do not come to "
           "rest; the points are paired with one of the two, which round-off may "
           "choose, and with the closest points gaps differ by up to " +
           brief(jump->gap) +
           " mm: by so much nodes may stand off or overlap there, and pressures "
           "near them are those of one place of two, and the moments of the "
           "contact on both bodies differ by " +
           brief(100 * moment_imbalance) +
           " % of its forces by the size of the slave. A finer master, another "
           "contact discretization, or 'Geometry = fixed point' may come to rest.";
  }

  template class Pairing<2>;
  template class Pairing<3>;
} // namespace Contact
