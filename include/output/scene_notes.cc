/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include <algorithm>
#include <functional>

#include "base/string_utilities.h"
#include "contact/results/contact_depth.h"
#include "output/notes.h"
#include "parameters/formula.h"
#include "solvers/rigid_pieces/rigid_body_modes.h"

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
                             const Parameters::Increments        &increments,
                             Findings                            &findings)
    {
      const unsigned int n_samples = 32; // of an increment
      double             size = 0, missed = 0, where = 0;
      for (unsigned int k = 0; k < increments.size(); ++k)
        {
          const double first = history(increments.at(k));
          const double last  = history(increments.at(k + 1));
          size = std::max({size, std::abs(first), std::abs(last)});
          for (unsigned int i = 1; i < n_samples; ++i)
            {
              const double t      = increments.at(k + 1. * i / n_samples);
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
        findings.push_back(
          {"the history of '" + entry +
           "' turns back inside an increment, at about t = " + brief(where) +
           ": only its values at the ends of increments are "
           "applied. Take more increments, so that one ends there"});
    }



    template<int dim>
    void add_notes_on_histories(const Parameters::All     &parameters,
                                const Discretization<dim> &discretization,
                                Findings                  &findings)
    {
      const auto &increments = parameters.solution.increments;
      for (const auto &[entry, is_set] :
           parameters.boundary.entries_with_history())
        if (is_set && parameters.boundary.histories.count(entry) > 0)
          add_note_on_history(
            entry,
            [&, &entry = entry](const double t) {
              return discretization.factor(entry, t);
            },
            increments,
            findings);
      for (const auto &contact_pair : parameters.pairs())
        for (const auto &[motion, formula] : contact_pair.obstacle_motion)
          {
            const std::string entry =
              contact_pair.section() + "/Obstacle motion";
            const auto history = parse_history(formula, entry);
            add_note_on_history(
              entry + " " + motion,
              [&](const double t) { return history(Point<1>(t)); },
              increments,
              findings);
          }
    }



    // A slave that hardly deforms leaves the conditions of its many nodes to
    // the few of the master: too many for its displacements (inf-sup
    // condition). With moduli of 3, 5 and 10 to 1, quadratic elements and edges
    // of 0.6 to 1, the peak was 1.2, 1.6 and 1.8 times that of the exchanged
    // roles.
    template<int dim>
    void add_notes_on_roles(const Parameters::All   &parameters,
                            const ContactModel<dim> &model,
                            Findings                &findings)
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
            findings.push_back(
              {"the slave '" + entries[z].slave +
               "' is stiffer than its master and has shorter edges: "
               "pressures oscillate, and their peaks may be twice too "
               "high. Take the softer surface as slave"});
        }
    }



    // A wrong group, or an obstacle whose normal points the other way, would
    // show as a scene without contact.
    template<int dim>
    void add_notes_on_facing(const Parameters::All       &parameters,
                             const ContactInterface<dim> &interface,
                             Findings                    &findings)
    {
      const auto entries = parameters.pairs();
      for (unsigned int z = 0; z < entries.size(); ++z)
        {
          const auto points =
            interface.pairs[z]->points_among(interface.points());
          const Surface<dim> &slave = interface.pairs[z]->slave;
          const auto          faces = [&](const ContactPoint<dim> &point) {
            return point.facing &&
                   (entries[z].obstacle.empty() ||
                    outward(slave, point.slave_facet) * point.normal < 0);
          };
          if (std::any_of(points.begin(), points.end(), faces))
            continue;
          // Also of no points: those were held.
          if (std::all_of(points.begin(),
                          points.end(),
                          [&](const ContactPoint<dim> &point) {
                            return !is_free_along(point,
                                                  point.n_nodes,
                                                  point.normal,
                                                  interface.discretization);
                          }))
            findings.push_back(
              {"supports hold all of the slave '" + entries[z].slave +
               "', and what it faces, along the normals: no "
               "pressure can act there, whatever the gaps are" +
               (interface.pairs[z]->tied
                  ? ", and nothing is glued. Exchange slave and "
                    "master, or take the mortar discretization"
                  : "")});
          else
            findings.push_back(
              {"no point of the slave '" + entries[z].slave + "' faces its " +
               (entries[z].master.empty()
                  ? "obstacle"
                  : "master '" + entries[z].master + "'") +
               " to begin with: check the groups, and on which side of "
               "an obstacle its normal is"});
        }
    }



    // As if all touched that face each other. In the solution normals have
    // turned a little, and seem to hold what slides over the waves.
    template<int dim>
    void add_notes_on_friction(const ContactModel<dim> &model,
                               Findings                &findings)
    {
      ContactInterface<dim> &interface = *model.interface;
      const auto             statuses  = interface.active_set.statuses();
      auto                   touching  = statuses;
      for (unsigned int k = 0; k < touching.size(); ++k)
        touching[k].kind =
          interface.points()[k].facing ? Status::stick : Status::open;
      interface.active_set.set_statuses(touching);
      const auto held_by = [&](const Tangents tangents) {
        return rigid_body_modes<dim>(*model.discretization,
                                     &interface,
                                     tangents);
      };
      if (held_by(Tangents::stuck).empty())
        for (const RigidBodyMode &motion : held_by(Tangents::free))
          findings.push_back({"friction alone holds " +
                              model.mesh->piece_name(motion.piece) +
                              " against: " + motion.name});
      interface.active_set.set_statuses(statuses);
    }



    // A press fit may be drawn so; a body in a wrong place is, too.
    template<int dim>
    void add_notes_on_overlaps(const ContactModel<dim> &model,
                               Findings                &findings)
    {
      const GhostedVector undeformed(model.discretization->distribution);
      for (const auto &contact_pair : model.interface->pairs)
        {
          // One piece is behind its own surfaces.
          if (contact_pair->tied ||
              (contact_pair->master && contact_pair->slave.facets[0].piece ==
                                         contact_pair->master->facets[0].piece))
            continue;
          const ContactDepth<dim> deepest =
            largest_depth(*contact_pair, undeformed, DepthOf::curves);
          if (deepest.depth >
              contact_pair->slave.unresolved_length(deepest.slave_facet))
            findings.push_back(
              {std::string("the bodies overlap by ") + brief(deepest.depth) +
               " mm in the mesh: there the place of the " +
               (deepest.of_master ? "master" : "slave") + " of '" +
               contact_pair->section() + "' at X = (" + brief(deepest.X) +
               ") mm is inside of the " +
               (contact_pair->obstacle ? "obstacle" : "other body") +
               ". The first increment presses them apart: move one of them, "
               "unless it is a press fit"});
        }
    }



    // Glue holds the displacements of both surfaces together, wherever they
    // are.
    template<int dim>
    void add_notes_on_glue(const Parameters::All       &parameters,
                           const ContactInterface<dim> &interface,
                           Findings                    &findings)
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
               contact_pair.points_among(interface.points()))
            {
              double gap = 0;
              for (unsigned int a = 0; a < point.n_nodes; ++a)
                gap += point.C[a] * (point.X(a) * point.normal);
              if (point.facing && std::abs(gap) > largest &&
                  std::abs(gap) > digits * contact_pair.edge_length(point))
                {
                  largest = std::abs(gap);
                  place   = contact_pair.place(point);
                }
            }
          if (largest > 0)
            findings.push_back({"the glued surfaces '" + entries[z].slave +
                                "' and '" + entries[z].master + "' are up to " +
                                brief(largest) + " mm apart, there at X = (" +
                                brief(place) +
                                ") mm: the moment of the shear over the gap is "
                                "lost. Let them meet in the mesh"});
        }
    }



    // One strain in a cell: as stiff as triangles in 2-D, and in 3-D there is
    // nothing else to mesh most parts with.
    template<int dim>
    void add_note_on_tetrahedra(const Discretization<dim> &discretization,
                                Findings                  &findings)
    {
      if (dim == 3 && discretization.degree == 1 &&
          !discretization.mesh.has_only_hypercubes())
        findings.push_back(
          {"tetrahedra of degree 1 are too stiff where bodies bend, and lock "
           "where they hardly change their volume. Set 'Element/Degree = 2'"});
      for (const auto &[body, n] : discretization.mesh.n_split)
        findings.push_back(
          {std::to_string(n) + " cells of '" + body +
           "' were split into tetrahedra: it has wedges or pyramids, or "
           "hexahedra that share nodes with tetrahedra. To keep hexahedra, mesh "
           "them as a body without these, tied to the others"});
    }



    // A mesh has only a polygon of a circle.
    template<int dim>
    void add_notes_on_arcs(const Parameters::All     &parameters,
                           const ContactModel<dim>   &model,
                           const Parameters::Contact &contact_pair,
                           Findings                  &findings)
    {
      if (parameters.mesh.mid_side_nodes ||
          (parameters.element.degree == 1 && parameters.mesh.refinements == 0 &&
           !parameters.has_levels()))
        return;
      std::set<std::string> names;
      for (const std::string &name : {contact_pair.slave, contact_pair.master})
        if (const auto parts = parameters.mesh.groups.find(name);
            parts != parameters.mesh.groups.end())
          names.insert(parts->second.begin(), parts->second.end());
        else
          names.insert(name);
      for (const std::string &name : names)
        {
          if (name.empty() || parameters.mesh.is_round(name))
            continue;
          const double bend =
            Surface<dim>(*model.discretization,
                         model.mesh->boundary(name, contact_pair.section()),
                         name)
              .largest_bend();
          if (bend > 0.1)
            findings.push_back(
              {"'" + name + "' bends by up to " + brief(bend) +
               " degrees at a node and is no arc: at degree 2 and on finer "
               "meshes it keeps its corners. " +
               (dim == 2
                  ? "For a circle: Mesh/Arcs = " + name + ": x, y, radius"
                  : "If it is round: Mesh/Spheres, Cylinders, Cones or Tori")});
        }
    }
  } // namespace



  template<int dim>
  Findings notes_on_scene(const ContactModel<dim> &model,
                          const Parameters::All   &parameters)
  {
    Findings findings;
    add_notes_on_histories(parameters, *model.discretization, findings);
    for (const std::string &group : model.mesh->inner_curves)
      findings.push_back({"the curve '" + group +
                          "' has lines that are no edges of cells on the "
                          "boundary: it is left out"});
    if (const std::string locking = model.elasticity->locking();
        !locking.empty())
      findings.push_back({locking + ": results are too stiff, and meshes agree "
                                    "on that. Set 'Element/Degree = 2'"});
    add_note_on_tetrahedra(*model.discretization, findings);
    if (!model.interface)
      return findings;
    for (const auto &contact_pair : parameters.pairs())
      add_notes_on_arcs(parameters, model, contact_pair, findings);
    add_notes_on_facing(parameters, *model.interface, findings);
    add_notes_on_overlaps(model, findings);
    add_notes_on_friction(model, findings);
    add_notes_on_glue(parameters, *model.interface, findings);
    add_notes_on_roles(parameters, model, findings);
    return findings;
  }

  template Findings notes_on_scene(const ContactModel<2> &,
                                   const Parameters::All &);
  template Findings notes_on_scene(const ContactModel<3> &,
                                   const Parameters::All &);
} // namespace Contact
