/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/scene_notes.h"

#include <algorithm>
#include <functional>

#include "base/string_utilities.h"
#include "parameters/formula.h"
#include "solvers/rigid_body_modes.h"
#include "verification/rigid_fit.h"

namespace Contact
{
  namespace
  {
    /// A vector out of the body at a facet, undeformed.
    Tensor<1, 2> outward(const Surface<2> &surface, const unsigned int e)
    {
      const auto &nodes = surface.facets[e].nodes;
      return cross_product_2d(surface.nodes[nodes[1]].X -
                              surface.nodes[nodes[0]].X);
    }

    Tensor<1, 3> outward(const Surface<3> &surface, const unsigned int e)
    {
      const auto &nodes = surface.facets[e].nodes;
      return cross_product_3d(surface.nodes[nodes[1]].X -
                                surface.nodes[nodes[0]].X,
                              surface.nodes[nodes[2]].X -
                                surface.nodes[nodes[0]].X);
    }



    // Histories have their values at the ends of increments alone: where one
    // turns back in between, its peak is never there.
    void add_note_on_history(const std::string                   &entry,
                             const std::function<double(double)> &history,
                             const unsigned int                   n,
                             std::vector<std::string>            &notes)
    {
      const unsigned int n_samples = 32; // of an increment
      double             size = 0, missed = 0, where = 0;
      for (unsigned int k = 0; k < n; ++k)
        {
          const double first = history(1. * k / n);
          const double last  = history((k + 1.) / n);
          size = std::max({size, std::abs(first), std::abs(last)});
          for (unsigned int i = 1; i < n_samples; ++i)
            {
              const double t      = (k + 1. * i / n_samples) / n;
              const double factor = history(t);
              const double beyond = std::max(factor - std::max(first, last),
                                             std::min(first, last) - factor);
              if (beyond > missed)
                {
                  missed = beyond;
                  where  = t;
                }
            }
        }
      if (missed > 1e-3 * std::max(size, missed))
        notes.push_back(
          "the history of '" + entry +
          "' turns back inside an increment, at about t = " + brief(where) +
          ": only its values at the ends of increments are "
          "applied. Take more increments, so that one ends there");
    }



    template<int dim>
    void add_notes_on_histories(const Parameters::All     &parameters,
                                const Discretization<dim> &discretization,
                                std::vector<std::string>  &notes)
    {
      const unsigned int n = parameters.solution.n_increments;
      for (const auto &[entry, is_set] :
           parameters.boundary.entries_with_history())
        if (is_set && parameters.boundary.histories.count(entry) > 0)
          add_note_on_history(
            entry,
            [&, &entry = entry](const double t) {
              return discretization.factor(entry, t);
            },
            n,
            notes);
      for (const auto &contact_pair : parameters.pairs())
        for (const auto &[motion, formula] : contact_pair.obstacle_motion)
          {
            const std::string entry =
              contact_pair.section() + "/Obstacle motion";
            const auto history = parse_history(formula, entry);
            add_note_on_history(
              entry + " " + motion,
              [&](const double t) { return history(Point<1>(t)); },
              n,
              notes);
          }
    }



    // A slave that hardly deforms leaves the conditions of its many nodes to
    // the few of the master: too many for its displacements (inf-sup
    // condition). With moduli of 3, 5 and 10 to 1, quadratic elements and edges
    // of 0.6 to 1, the peak was 1.2, 1.6 and 1.8 times that of the exchanged
    // roles.
    template<int dim>
    void add_notes_on_roles(const Parameters::All    &parameters,
                            const ContactModel<dim>  &model,
                            std::vector<std::string> &notes)
    {
      struct Side
      {
        double length = 0, stiffness = 0;
      };
      const auto mean = [&](const Surface<dim> &surface) {
        Side side;
        for (unsigned int e = 0; e < surface.facets.size(); ++e)
          {
            side.length += surface.reference_length(e) / surface.facets.size();
            side.stiffness +=
              model.elasticity->youngs_modulus(surface.facets[e].body) /
              surface.facets.size();
          }
        return side;
      };
      const auto entries = parameters.pairs();
      for (unsigned int z = 0; z < entries.size(); ++z)
        {
          const ContactPair<dim> &contact_pair = *model.interface->pairs[z];
          if (!contact_pair.master || contact_pair.tied)
            continue;
          const Side slave  = mean(contact_pair.slave);
          const Side master = mean(*contact_pair.master);
          if (slave.stiffness > 5 * master.stiffness &&
              slave.length < 0.9 * master.length)
            notes.push_back(
              "the slave '" + entries[z].slave +
              "' is stiffer than its master and has shorter edges: "
              "pressures oscillate, and their peaks may be twice too "
              "high. Take the softer surface as slave");
        }
    }



    template<int dim>
    bool is_held(const ContactPoint<dim>   &point,
                 const unsigned int         n_nodes,
                 const Discretization<dim> &discretization)
    {
      return !is_free_along(point, n_nodes, point.normal, discretization);
    }



    // A wrong group, or an obstacle whose normal points the other way, would
    // show as a scene without contact.
    template<int dim>
    void add_notes_on_facing(const Parameters::All       &parameters,
                             const ContactInterface<dim> &interface,
                             std::vector<std::string>    &notes)
    {
      const auto entries = parameters.pairs();
      for (unsigned int z = 0; z < entries.size(); ++z)
        {
          const auto          points = interface.points_of(*interface.pairs[z]);
          const Surface<dim> &slave  = interface.pairs[z]->slave;
          const auto          faces  = [&](const ContactPoint<dim> &point) {
            return point.facing &&
                   (point.is_master_corner || entries[z].obstacle.empty() ||
                    outward(slave, point.slave_facet) * point.normal < 0);
          };
          if (std::any_of(points.begin(), points.end(), faces))
            continue;
          // Also of no points: those were held.
          if (std::all_of(points.begin(),
                          points.end(),
                          [&](const ContactPoint<dim> &point) {
                            return is_held(point,
                                           point.n_nodes,
                                           interface.discretization);
                          }))
            notes.push_back("supports hold all of the slave '" +
                            entries[z].slave +
                            "', and what it faces, along the normals: no "
                            "pressure can act there, whatever the gaps are" +
                            (interface.pairs[z]->tied
                               ? ", and nothing is glued. Exchange slave and "
                                 "master, or take the mortar discretization"
                               : ""));
          else
            notes.push_back(
              "no point of the slave '" + entries[z].slave + "' faces its " +
              (entries[z].master.empty()
                 ? "obstacle"
                 : "master '" + entries[z].master + "'") +
              " to begin with: check the groups, and on which side of "
              "an obstacle its normal is");
        }
    }



    // Glue holds the displacements of both surfaces together, wherever they
    // are.
    template<int dim>
    void add_notes_on_glue(const Parameters::All       &parameters,
                           const ContactInterface<dim> &interface,
                           std::vector<std::string>    &notes)
    {
      const double digits  = 1e-9; // of a mesh file, by the length of an edge
      const auto   entries = parameters.pairs();
      for (unsigned int z = 0; z < entries.size(); ++z)
        {
          const ContactPair<dim> &contact_pair = *interface.pairs[z];
          if (!contact_pair.tied)
            continue;
          double     largest = 0;
          Point<dim> place;
          for (const ContactPoint<dim> &point :
               interface.points_of(contact_pair))
            {
              double gap = 0;
              for (unsigned int a = 0; a < point.n_nodes; ++a)
                gap += point.C[a] * (point.X[a] * point.normal);
              if (point.facing && std::abs(gap) > largest &&
                  std::abs(gap) > digits * contact_pair.edge_length(point))
                {
                  largest = std::abs(gap);
                  place   = contact_pair.place(point);
                }
            }
          if (largest > 0)
            notes.push_back("the glued surfaces '" + entries[z].slave +
                            "' and '" + entries[z].master + "' are up to " +
                            brief(largest) + " mm apart, there at X = (" +
                            brief(place) +
                            ") mm: the moment of the shear over the gap is "
                            "lost. Let them meet in the mesh");
        }
    }



    // A mesh has only a polygon of a circle.
    template<int dim>
    void add_notes_on_arcs(const Parameters::All     &parameters,
                           const ContactModel<dim>   &model,
                           const Parameters::Contact &contact_pair,
                           std::vector<std::string>  &notes)
    {
      if (parameters.mesh.mid_side_nodes ||
          (parameters.element.degree == 1 && parameters.mesh.refinements == 0 &&
           !parameters.has_levels()))
        return;
      for (const std::string &name : {contact_pair.slave, contact_pair.master})
        {
          if (name.empty() || parameters.mesh.is_round(name))
            continue;
          const double bend =
            Surface<dim>(*model.discretization,
                         model.mesh->boundary(name, contact_pair.section()),
                         name)
              .largest_bend();
          if (bend > 0.1)
            notes.push_back(
              "'" + name + "' bends by up to " + brief(bend) +
              " degrees at a node and is no arc: at degree 2 and on finer "
              "meshes it keeps its corners. " +
              (dim == 2
                 ? "For a circle: Mesh/Arcs = " + name + ": x, y, radius"
                 : "If it is round: Mesh/Spheres, Cylinders, Cones or Tori"));
        }
    }



    // On an arc a chord of length L that rises by f is off by f as a polygon,
    // and with elements of degree 2 by f^3/L^2: there R f = L^2/8, and the
    // parabola through the ends and the middle is R (L/2R)^4/32 from the circle
    // between them. The sides of the mesh file keep their parabolas where they
    // are refined: of L and f a side of level l has 2^-l and 4^-l.
    template<int dim>
    double out_of_round(const Surface<dim>      &surface,
                        const std::vector<bool> &in_contact,
                        const bool               keeps_parabolas)
    {
      double largest = 0;
      for (unsigned int e = 0; e < surface.facets.size(); ++e)
        if (in_contact[e])
          {
            const SurfaceFacet<dim> &facet = surface.facets[e];
            const unsigned int       n_corners =
              GeometryInfo<dim - 1>::vertices_per_cell;
            Tensor<1, dim> centre;
            for (unsigned int a = 0; a < n_corners; ++a)
              centre += surface.nodes[facet.nodes[a]].X / n_corners;
            const double rise  = (facet.middle - centre).norm();
            const double chord = surface.nodes[facet.nodes[0]].X.distance(
              surface.nodes[facet.nodes[n_corners - 1]].X);
            const double parabola = rise * std::pow(rise / chord, 2);
            largest =
              std::max(largest,
                       keeps_parabolas
                         ? std::max(surface.degree == 1 ? rise : 0.,
                                    parabola * std::pow(16., facet.level))
                       : surface.degree == 1 ? rise
                                             : parabola);
          }
      return largest;
    }



    template<int dim>
    void add_notes_on_roundness(const Parameters::All       &parameters,
                                const ContactInterface<dim> &interface,
                                const GhostedVector         &solution,
                                std::vector<std::string>    &notes)
    {
      const auto fits = fit_rigid_motions(interface.discretization, solution);
      const auto entries = parameters.pairs();
      for (unsigned int z = 0; z < entries.size(); ++z)
        {
          const ContactPair<dim> &contact_pair = *interface.pairs[z];
          std::vector<bool>       slave(contact_pair.slave.facets.size());
          std::vector<bool>       master(
            contact_pair.master ? contact_pair.master->facets.size() : 0);
          for (const ContactPoint<dim> &point :
               interface.points_of(contact_pair))
            if (!point.is_master_corner && point.status.kind != Status::open)
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
            notes.push_back(
              "the elements of '" + entries[z].slave +
              (master.empty() ? "" : "' and '" + entries[z].master) +
              "' are up to about " + brief(off) +
              " mm off their circles where they touch, " +
              brief(100 * off / moved) +
              " % of what the surfaces deform by: where the meshes "
              "do not match, gaps and overlaps of this size are the meshes', and "
              "pressures follow them. " +
              (keeps_parabolas
                 ? "Finer sides in the mesh file, or Mesh/Arcs without its "
                   "mid-side nodes: where they are refined they keep their shape"
                 : "Refine there, or take degree 2"));
        }
    }



    // A node that a support holds along the normal of an obstacle takes no part
    // in contact: it goes where the support says.
    template<int dim>
    void add_notes_on_held_nodes(const Parameters::All       &parameters,
                                 const ContactInterface<dim> &interface,
                                 const GhostedVector         &solution,
                                 std::vector<std::string>    &notes)
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
                 interface.points_of(contact_pair))
              if (const double gap =
                    interface.state(point, solution, solution).gap;
                  is_held(point,
                          point.n_slave_nodes,
                          interface.discretization) &&
                  -gap > depth &&
                  -gap > digits * contact_pair.edge_length(point))
                {
                  depth   = -gap;
                  deepest = &point;
                }
          if (deepest != nullptr)
            notes.push_back(
              "supports hold nodes of the slave '" + entries[z].slave +
              "' inside of its obstacle, up to " + brief(depth) +
              " mm deep, there at X = (" + brief(contact_pair.place(*deepest)) +
              ") mm: no pressure acts on what they hold along its normal");
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
    void add_notes_on_free_motions(const ContactModel<dim>  &model,
                                   const GhostedVector      &solution,
                                   const double              round_off_force,
                                   std::vector<std::string> &notes)
    {
      ContactInterface<dim>              &interface = *model.interface;
      const std::vector<PointStatus<dim>> statuses  = interface.statuses();
      std::vector<PointStatus<dim>>       pressed   = statuses;
      for (unsigned int k = 0; k < pressed.size(); ++k)
        {
          const ContactPoint<dim> &point = interface.points()[k];
          const double             force =
            point.weight * interface.state(point, solution, solution).lambda_n;
          if (!interface.contact_pair(point).tied &&
              std::abs(force) <= round_off_force)
            pressed[k] = PointStatus<dim>();
        }
      interface.set_statuses(pressed);
      const auto free = rigid_body_modes<dim>(*model.discretization,
                                              &interface,
                                              Tangents::by_status,
                                              rotations(model, solution));
      interface.set_statuses(statuses);
      for (const RigidBodyMode &motion : free)
        notes.push_back("nothing holds " +
                        model.mesh->piece_name(motion.piece) +
                        " at the end against: " + motion.name +
                        ". No force acts along it, and its displacement is one "
                        "of many. Support it there, or with friction");
    }



    template<int dim>
    void add_note_on_idleness(const RunSummary            &summary,
                              const ContactInterface<dim> &interface,
                              const GhostedVector         &solution,
                              std::vector<std::string>    &notes)
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
            touches = touches || values.at("max_pressure") != 0;
        }
      if (!is_loaded)
        notes.push_back("nothing is loaded: nothing moves and no force acts");
      else if (!touches && !interface.is_tied())
        notes.push_back(
          "nothing touches: no increment has a pressure of "
          "contact. Check gaps, groups and the direction of loads");
    }
  } // namespace



  template<int dim>
  std::vector<std::string> notes_on_scene(const ContactModel<dim> &model,
                                          const Parameters::All   &parameters)
  {
    std::vector<std::string> notes;
    add_notes_on_histories(parameters, *model.discretization, notes);
    if (!model.interface)
      return notes;
    for (const auto &contact_pair : parameters.pairs())
      add_notes_on_arcs(parameters, model, contact_pair, notes);
    add_notes_on_facing(parameters, *model.interface, notes);
    add_notes_on_glue(parameters, *model.interface, notes);
    add_notes_on_roles(parameters, model, notes);
    return notes;
  }



  template<int dim>
  std::vector<std::string> notes_on_result(const ContactModel<dim> &model,
                                           const Parameters::All   &parameters,
                                           const GhostedVector     &solution,
                                           const RunSummary        &summary)
  {
    std::vector<std::string> notes;
    add_note_on_idleness(summary, *model.interface, solution, notes);
    add_notes_on_roundness(parameters, *model.interface, solution, notes);
    add_notes_on_held_nodes(parameters, *model.interface, solution, notes);
    const double round_off_force =
      summary.increments.empty() ? 0.
                                 : summary.increments.back().round_off_force;
    add_notes_on_free_motions(model, solution, round_off_force, notes);
    return notes;
  }

  template std::vector<std::string> notes_on_scene(const ContactModel<2> &,
                                                   const Parameters::All &);
  template std::vector<std::string> notes_on_scene(const ContactModel<3> &,
                                                   const Parameters::All &);
  template std::vector<std::string> notes_on_result(const ContactModel<2> &,
                                                    const Parameters::All &,
                                                    const GhostedVector &,
                                                    const RunSummary &);
  template std::vector<std::string> notes_on_result(const ContactModel<3> &,
                                                    const Parameters::All &,
                                                    const GhostedVector &,
                                                    const RunSummary &);
} // namespace Contact
