/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/dimension.h"
#include "base/string_utilities.h"
#include "contact/results/contact_depth.h"
#include "output/notes.h"
#include "solid/strain_range.h"
#include "solvers/rigid_pieces/rigid_body_modes.h"
#include "verification/rigid_fit.h"

namespace Contact
{
  namespace
  {
    // On an arc a chord of length L that rises by f is off by f as a polygon,
    // which the angles between chords tell, whether the arc is known or not,
    // and with elements of degree 2 by f^3/L^2: there R f = L^2/8, and the
    // parabola through the ends and the middle is R (L/2R)^4/32 from the circle
    // between them. The sides of the mesh file keep their parabolas where they
    // are refined: of L and f a side of level l has 2^-l and 4^-l.
    template<int dim>
    double out_of_round(const Surface<dim>      &surface,
                        const std::vector<bool> &in_contact,
                        const bool               keeps_parabolas)
    {
      double     largest = 0;
      const auto bounds  = surface.degree == 1
                             ? sagittas(DeformedSurface<dim>(surface, {}))
                             : std::vector<double>();
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        if (in_contact[e])
          {
            const SurfaceFacet<dim> &facet     = surface.facets[e];
            const unsigned int       n_corners = facet.kind->n_vertices;
            Tensor<1, dim>           centre;
            FacetNodes<dim>          X;
            for (unsigned int a = 0; a < facet.n_nodes(); ++a)
              X[a] = surface.nodes[facet.nodes[a]].X;
            for (unsigned int a = 0; a < n_corners; ++a)
              centre += X[a] / n_corners;
            const auto normal =
              facet_normal<dim>(*facet.kind, X, facet.kind->middle);
            const double rise  = std::abs((facet.middle - centre) * normal);
            const double chord = surface.nodes[facet.nodes[0]].X.distance(
              surface.nodes[facet.nodes[n_corners - 1]].X);
            const double parabola = rise * std::pow(rise / chord, 2);
            largest =
              std::max(largest,
                       keeps_parabolas ? parabola * std::pow(16., facet.level)
                       : surface.degree == 1 ? 0.
                                             : parabola);
            if (surface.degree == 1)
              largest = std::max(largest, bounds[e] / 2);
          }
      return largest;
    }



    template<int dim>
    void add_notes_on_roundness(const Parameters::All   &parameters,
                                const ContactModel<dim> &model,
                                const GhostedVector     &solution,
                                Findings                &findings)
    {
      const ContactInterface<dim> &interface = *model.interface;
      const auto fits    = fit_rigid_motions(*model.discretization, solution);
      const auto entries = parameters.pairs();
      for (unsigned int z = 0; z < entries.size(); ++z)
        {
          const ContactPair<dim> &contact_pair = *interface.pairs[z];
          std::vector<bool>       slave(contact_pair.slave.facets.size());
          std::vector<bool>       master(
            contact_pair.master ? contact_pair.master->facets.size() : 0);
          for (const ContactPoint<dim> &point :
               contact_pair.points_of_slave(interface.points()))
            if (point.status.kind != Status::open)
              {
                slave[point.slave_facet] = true;
                if (!master.empty())
                  master[point.master_facet] = true;
              }
          double moved =
            largest_deformation(contact_pair.slave, fits, solution);
          if (!master.empty())
            moved = std::max(moved,
                             largest_deformation(*contact_pair.master,
                                                 fits,
                                                 solution));
          const bool   keeps_parabolas = parameters.mesh.mid_side_nodes;
          const double off =
            out_of_round(contact_pair.slave, slave, keeps_parabolas) +
            (master.empty()
               ? 0
               : out_of_round(*contact_pair.master, master, keeps_parabolas));
          if (moved > 0 && off > 0.05 * moved)
            findings.push_back(
              {"the elements of '" + entries[z].slave +
               (master.empty() ? "" : "' and '" + entries[z].master) +
               "' are up to about " + brief(off) +
               " mm off their circles where they touch, " +
               (off < moved ? brief(100 * off / moved) + " %"
                            : brief(off / moved) + " times") +
               " of what the surfaces deform by: where the meshes "
               "do not match, gaps and overlaps of this size are the meshes', and "
               "pressures follow them. " +
               (keeps_parabolas
                  ? "Finer sides in the mesh file, or Mesh/Arcs without its "
                    "mid-side nodes: where they are refined they keep their shape"
                : contact_pair.slave.degree == 1
                  ? "Refine there, or take degree 2"
                  : "Refine there")});
        }
    }



    // A node that a support holds along the normal of an obstacle takes no part
    // in contact: it goes where the support says.
    template<int dim>
    void add_notes_on_held_nodes(const Parameters::All       &parameters,
                                 const ContactInterface<dim> &interface,
                                 const GhostedVector         &solution,
                                 Findings                    &findings)
    {
      const double digits  = 1e-6; // of a gap, by the length of a facet
      const auto   entries = parameters.pairs();
      for (unsigned int z = 0; z < entries.size(); ++z)
        {
          const ContactPair<dim>  &contact_pair = *interface.pairs[z];
          double                   depth        = 0;
          const ContactPoint<dim> *deepest      = nullptr;
          if (!contact_pair.master)
            for (const ContactPoint<dim> &point :
                 contact_pair.points_among(interface.points()))
              if (const double gap =
                    interface.state(point, solution, solution).gap;
                  !is_free_along(point,
                                 point.n_slave_nodes,
                                 point.normal,
                                 interface.discretization) &&
                  -gap > depth &&
                  -gap > digits * contact_pair.edge_length(point))
                {
                  depth   = -gap;
                  deepest = &point;
                }
          if (deepest != nullptr)
            findings.push_back(
              {"supports hold nodes of the slave '" + entries[z].slave +
               "' inside of its obstacle, up to " + brief(depth) +
               " mm deep, there at X = (" +
               brief(contact_pair.place(*deepest)) +
               ") mm: no pressure acts on what they hold along its normal"});
        }
    }



    // Few nodes of the slave do not resolve a contact that ends between them:
    // five under the cylinder of Hertz have a peak that is 13 % off, six
    // under a ball in a groove an area and a force that are 70 % off.
    template<int dim>
    void add_notes_on_few_nodes(const Parameters::All       &parameters,
                                const ContactInterface<dim> &interface,
                                Findings                    &findings)
    {
      const unsigned int few     = dim == 2 ? 5 : 20;
      const auto         entries = parameters.pairs();
      for (unsigned int z = 0; z < entries.size(); ++z)
        {
          unsigned int n_active = 0, n_facing = 0;
          for (const ContactPoint<dim> &point :
               interface.pairs[z]->points_of_slave(interface.points()))
            {
              n_facing += point.facing;
              n_active += point.facing && point.status.kind != Status::open;
            }
          if (!entries[z].tied && n_active > 0 && n_active <= few &&
              n_active < n_facing)
            findings.push_back(
              {"only " + std::to_string(n_active) +
               (n_active == 1 ? " node" : " nodes") + " of '" +
               entries[z].slave +
               "' are in contact, which ends between them: pressures there "
               "follow the mesh" +
               (dim == 3 ? ", and of round bodies forces, too" : "") +
               ". Refine the slave"});
        }
    }



    /// How bodies in large displacement have turned, those of one piece: the
    /// pieces of others turn each by itself.
    template<int dim>
    Rotations<dim> rotations(const ContactModel<dim> &model,
                             const GhostedVector     &solution)
    {
      const MeshPieces<dim> &pieces = model.mesh->pieces;
      const RigidFits<dim>   fits =
        fit_rigid_motions(*model.discretization, solution);
      Rotations<dim> rotations;
      for (unsigned int p = 0; p < pieces.size(); ++p)
        if (pieces.is_whole_body(p) &&
            !model.elasticity->is_small_strain(pieces[p].body))
          rotations[pieces[p].body] = fits.at(pieces[p].body).R;
      return rotations;
    }



    // Springs of no force leave such a body anywhere. What presses no more than
    // round-off holds nothing.
    template<int dim>
    void add_notes_on_free_motions(const ContactModel<dim> &model,
                                   const GhostedVector     &solution,
                                   const double             round_off_force,
                                   Findings                &findings)
    {
      ContactInterface<dim>              &interface = *model.interface;
      const std::vector<PointStatus<dim>> statuses =
        interface.active_set.statuses();
      std::vector<PointStatus<dim>> pressed = statuses;
      for (unsigned int k = 0; k < pressed.size(); ++k)
        {
          const ContactPoint<dim> &point = interface.points()[k];
          const double             force =
            point.weight * interface.state(point, solution, solution).lambda_n;
          if (!interface.contact_pair(point).tied &&
              std::abs(force) <= round_off_force)
            pressed[k] = PointStatus<dim>();
        }
      interface.active_set.set_statuses(pressed);
      const auto free = rigid_body_modes<dim>(*model.discretization,
                                              &interface,
                                              Tangents::by_status,
                                              rotations(model, solution));
      interface.active_set.set_statuses(statuses);
      for (const RigidBodyMode &motion : free)
        findings.push_back(
          {"nothing holds " + model.mesh->piece_name(motion.piece) +
           " at the end against: " + motion.name +
           ". No force acts along it, and its displacement is one "
           "of many. Support it there, or with friction"});
    }



    /// The force that is round-off beside those that act, or, if bodies move
    /// as a whole and none acts, beside those that such displacements would
    /// need if they deformed them.
    template<int dim>
    double round_off_force(const ContactModel<dim> &model,
                           const GhostedVector     &solution,
                           const RunSummary        &summary)
    {
      double force = summary.increments.empty()
                       ? 0.
                       : summary.increments.back().round_off_force;
      for (const auto &contact_pair : model.interface->pairs)
        {
          const Surface<dim> &slave = contact_pair->slave;
          double              moved = 0;
          for (const SurfaceNode<dim> &node : slave.nodes)
            for (const auto dof : node.dofs)
              moved = std::max(moved, std::abs(solution[dof]));
          force =
            std::max(force,
                     1e3 * std::numeric_limits<double>::epsilon() *
                       model.elasticity->youngs_modulus(slave.facets[0].body) *
                       moved * std::pow(slave.reference_length(0), dim - 2));
        }
      return force;
    }



    template<int dim>
    void add_note_on_idleness(const RunSummary            &summary,
                              const ContactInterface<dim> &interface,
                              const GhostedVector         &solution,
                              const double                 round_off_force,
                              Findings                    &findings)
    {
      bool touches   = false;
      bool is_loaded = !solution.all_zero();
      for (const auto &contact_pair : interface.pairs)
        is_loaded = is_loaded || (contact_pair->obstacle &&
                                  contact_pair->obstacle->travel());
      for (const IncrementRecord &increment : summary.increments)
        {
          if (!increment.converged)
            continue;
          is_loaded = is_loaded || increment.works.at("strain_energy") != 0;
          for (const auto &[name, values] : increment.contact)
            touches =
              touches || std::abs(values.at("normal_force")) > round_off_force;
        }
      if (!is_loaded)
        findings.push_back(
          {"nothing is loaded: nothing moves and no force acts"});
      else if (!touches && !interface.is_tied())
        findings.push_back(
          {"nothing touches: no increment has a pressure of "
           "contact. Check gaps, groups and the direction of loads"});
    }

  } // namespace



  template<int dim>
  std::string beyond_small_strain(const ContactModel<dim> &model,
                                  const GhostedVector     &solution)
  {
    const double large_strain = 0.05;
    const double largest =
      change_of_edges(*model.discretization, *model.elasticity, solution);
    return largest > large_strain
             ? "edges of cells change their length by up to " +
                 brief(100 * largest) +
                 " %, beyond the range of small strain (Solids/Kinematics). If "
                 "that is not meant, check the units: moduli in MPa, lengths in "
                 "mm, loads in N"
             : "";
  }



  namespace
  {
    // By as much as that of their energy such cells are too stiff. Bodies that
    // no force deforms have some as well.
    template<int dim>
    void add_notes_on_bending(const ContactModel<dim> &model,
                              const GhostedVector     &solution,
                              Findings                &findings)
    {
      const double much = 0.1, little = 0.001;
      const double of_all = model.elasticity->strain_energy(solution);
      for (const auto &[name, body] : model.mesh->bodies)
        {
          const auto energy = model.elasticity->bending_energy(solution, body);
          if (energy.missing > much * energy.whole &&
              energy.missing > little * of_all)
            findings.push_back(
              {"the linear " + std::string(Dimension<dim>::hypercubes) +
               " of '" + name + "' are too stiff in bending: " +
               brief(100 * energy.missing / energy.whole) +
               " % of its strain energy would be gone if they could bend. Set "
               "'Degree = 2'" +
               (model.elasticity->may_yield(body)
                  ? ""
                  : ", or 'Incompatible modes = " + name + "'")});
        }
    }
  } // namespace



  template<int dim>
  Findings notes_on_result(const ContactModel<dim> &model,
                           const Parameters::All   &parameters,
                           const GhostedVector     &solution,
                           const RunSummary        &summary)
  {
    Findings findings;
    findings.push_back({beyond_small_strain(model, solution)});
    add_notes_on_bending(model, solution, findings);
    if (!model.interface)
      return findings;
    add_notes_on_roundness(parameters, model, solution, findings);
    add_notes_on_held_nodes(parameters, *model.interface, solution, findings);
    add_notes_on_few_nodes(parameters, *model.interface, findings);
    const double round_off = round_off_force(model, solution, summary);
    add_note_on_idleness(summary,
                         *model.interface,
                         solution,
                         round_off,
                         findings);
    add_notes_on_free_motions(model, solution, round_off, findings);
    return findings;
  }

  template std::string beyond_small_strain(const ContactModel<2> &,
                                           const GhostedVector &);
  template std::string beyond_small_strain(const ContactModel<3> &,
                                           const GhostedVector &);
  template Findings    notes_on_result(const ContactModel<2> &,
                                       const Parameters::All &,
                                       const GhostedVector &,
                                       const RunSummary &);
  template Findings    notes_on_result(const ContactModel<3> &,
                                       const Parameters::All &,
                                       const GhostedVector &,
                                       const RunSummary &);
} // namespace Contact
