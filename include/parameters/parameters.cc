/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "parameters/parameters.h"

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "base/string_utilities.h"
#include "parameters/geometry.h"
#include "parameters/parameter_file.h"

namespace Contact
{
  namespace
  {
    // ParameterHandler prints what is allowed only in a form that is not a
    // parameter file.
    void print_entry(const DeclaredEntry &entry, std::ostream &out)
    {
      for (const std::string &text :
           {entry.documentation, "Allowed: " + entry.allowed_values()})
        for (const std::string &line :
             Utilities::break_text_into_lines(text, 74))
          out << "  # " << line << '\n';
      out << "  set " << entry.name << " ="
          << (entry.default_value.empty() ? "" : " ") << entry.default_value
          << '\n';
    }
  } // namespace



  EntryError::EntryError(const std::string              &problem,
                         const std::vector<std::string> &entries,
                         const std::string              &remedy)
    : InputError(problem, Patterns::Tools::to_string(entries), remedy)
    , problem(problem)
    , entries(entries)
    , remedy(remedy)
  {
  }



  namespace Parameters
  {
    All::All()                       = default;
    All::All(const All &)            = default;
    All::All(All &&)                 = default;
    All &All::operator=(const All &) = default;
    All &All::operator=(All &&)      = default;
    All::~All()                      = default;



    void All::add_pair(const std::string &name, ParameterHandler &prm)
    {
      Contact &contact_pair = further_contacts[name];
      contact_pair.name     = name;
      contact_pair.add_parameters(prm);
    }



    void All::leave_out_pair(const std::string &assignment)
    {
      const auto [path, value]  = split_at(assignment, assignment.find('='));
      const auto [section, key] = split_at(path, path.find_last_of('/'));
      if (key != "Slave" || !value.empty())
        return;
      const std::string of        = with_single_blanks(section);
      const auto        leave_out = [&](Contact &contact_pair) {
        contact_pair.is_left_out =
          contact_pair.is_left_out || contact_pair.section() == of;
      };
      leave_out(contact);
      for (auto &further : further_contacts)
        leave_out(further.second);
    }



    std::vector<Contact> All::pairs() const
    {
      std::vector<Contact> pairs;
      if (contact.is_pair())
        pairs.push_back(contact);
      for (const auto &further : further_contacts)
        if (further.second.is_pair())
          pairs.push_back(further.second);
      return pairs;
    }



    void All::add_parameters(ParameterHandler &prm)
    {
      mesh.add_parameters(prm);
      element.add_parameters(prm);
      solids.add_parameters(prm);
      boundary.add_parameters(prm);
      contact.add_parameters(prm);
      solution.add_parameters(prm);
      refinement.add_parameters(prm);
      probes.add_parameters(prm);
      output.add_parameters(prm);
    }



    std::filesystem::path All::directory() const
    {
      return std::filesystem::path(output.directory) / name;
    }



    bool All::is_condensed(const std::size_t n_displacements) const
    {
      if (in_space)
        return true;
      if (solution.system != SystemKind::automatic)
        return solution.system == SystemKind::condensed;
      if (solution.linear_solver != SolverKind::automatic)
        return solution.linear_solver != SolverKind::umfpack;
      if (has_levels() || n_ranks > 1)
        return true;
      const auto pairs    = this->pairs();
      const auto all_have = [&](const auto &property) {
        return std::all_of(pairs.begin(), pairs.end(), property);
      };
      if (all_have(
            [](const Contact &contact_pair) { return contact_pair.tied; }))
        return true;

      // Beyond, a sparse direct solver of the saddle point takes too much time
      // and memory.
      const bool is_large = n_displacements > 100000;
      return is_large && solution.geometry != GeometryLoop::newton &&
             all_have([](const Contact &contact_pair) {
               return contact_pair.has_point_per_multiplier();
             });
    }



    namespace
    {
      // Whether polygons of two circles touch: where only one of them is
      // refined, what they are off each other counts as a gap.
      bool has_facing_polygons(const All &scene)
      {
        const auto pairs = scene.pairs();
        return scene.element.degree == 1 &&
               std::any_of(pairs.begin(),
                           pairs.end(),
                           [&](const Contact &pair) {
                             return scene.mesh.is_round(pair.slave) &&
                                    scene.mesh.is_round(pair.master);
                           });
      }
    } // namespace



    bool All::refines_adaptively(const bool has_only_hypercubes) const
    {
      return refinement.strategy == Strategy::adaptive ||
             (refinement.strategy == Strategy::automatic && follows_goals() &&
              has_only_hypercubes && !has_facing_polygons(*this));
    }



    bool All::solves_dual_problems() const
    {
      const bool by_default = probes.errors == Errors::automatic &&
                              !probes.probes.empty() && !has_levels();
      return probes.errors == Errors::dual_weighted_residuals ||
             follows_goals() ||
             (by_default && !missing_dual_problem("Probes/Errors"));
    }



    std::string All::missing_errors() const
    {
      if (probes.errors != Errors::automatic || has_levels() ||
          solves_dual_problems())
        return "";
      const auto missing = missing_dual_problem("Probes/Errors");
      return missing ? missing->problem +
                         (in_space ? " 'Levels' or 'Errors = next mesh' tell "
                                     "them there."
                                   : "")
                     : "";
    }



    GeometryLoop All::geometry(const std::size_t n_displacements) const
    {
      if (solution.geometry != GeometryLoop::automatic)
        return solution.geometry;
      return is_condensed(n_displacements) ? GeometryLoop::each_step
                                           : GeometryLoop::newton;
    }



    std::vector<All>
    All::with_other_loops(const std::size_t n_displacements) const
    {
      const auto pairs   = this->pairs();
      const auto all_are = [&](const auto &property) {
        return std::all_of(pairs.begin(), pairs.end(), property);
      };
      if (all_are([](const Contact &pair) { return pair.tied; }))
        return {};

      All newton = *this;
      if (!all_are([](const Contact &pair) { return !pair.frictional(); }))
        newton.solution.friction = FrictionLoop::newton;
      if (solution.geometry != GeometryLoop::undeformed)
        newton.solution.geometry = GeometryLoop::automatic;

      std::vector<All> others;
      const auto       add = [&](All other, const SystemKind system) {
        other.solution.system = system;
        if (other.is_condensed() != is_condensed(n_displacements))
          other.solution.linear_solver = SolverKind::automatic;
        if (other.is_condensed() != is_condensed(n_displacements) ||
            other.solution.friction != solution.friction ||
            solution.geometry == GeometryLoop::fixed_point)
          others.push_back(other);
      };
      const bool can_have_multipliers =
        n_ranks == 1 && !has_levels() && !in_space;
      if (can_have_multipliers)
        add(newton, SystemKind::saddle_point);
      // Two points at one node that stick have redundant multipliers.
      const bool may_share_nodes =
        pairs.size() > 1 || !all_are([](const Contact &pair) {
          return !pair.frictional() ||
                 pair.discretization == ContactDiscretization::gauss;
        });
      if ((!can_have_multipliers || may_share_nodes) && !shared_pair())
        add(newton, SystemKind::condensed);

      // Uniform levels end with the mesh that these refinements make.
      const double most_of_direct_solver = 400000; // displacements
      if (n_ranks == 1 && refinement.n_levels > 0 && !asks_for_accuracy() &&
          !in_space && refinement.strategy != Strategy::adaptive &&
          std::ldexp(n_displacements, 2 * refinement.n_levels) <
            most_of_direct_solver)
        {
          newton.mesh.refinements += refinement.n_levels;
          newton.refinement.n_levels = 0;
          add(newton, SystemKind::saddle_point);
        }
      return others;
    }
  } // namespace Parameters



  void read_parameters(const std::filesystem::path    &file,
                       const std::vector<std::string> &overrides,
                       ParameterHandler               &prm,
                       Parameters::All                &parameters)
  {
    prm.clear();
    parameters      = Parameters::All();
    parameters.name = file.stem().string();
    parameters.add_parameters(prm);

    ParameterReader reader(prm, "Contact", [&](const std::string &name) {
      parameters.add_pair(name, prm);
    });
    reader.read_file(file);
    for (const std::string &assignment : overrides)
      {
        reader.read_override(assignment);
        parameters.leave_out_pair(assignment);
      }
    reader.resolve_path("Mesh", "File");

    // The checks know the entries, the reader knows where they were set.
    try
      {
        parameters.check();
      }
    catch (const EntryError &error)
      {
        throw InputError(error.problem,
                         reader.where(error.entries),
                         error.remedy);
      }
    auto idle = parameters.idle_entries();
    idle.merge(Parameters::Geometry(prm).idle_entries(parameters.mesh.file));
    reader.note_idle(idle);
    parameters.findings = reader.findings;
  }



  void print_parameters(std::ostream &out)
  {
    Parameters::All  parameters;
    ParameterHandler prm;
    parameters.add_parameters(prm);

    std::string section;
    for (const DeclaredEntry &entry : declared_entries(prm))
      {
        if (!entry.alias_of.empty())
          continue;
        if (section.empty())
          out << "subsection " << entry.section << '\n';
        else if (section != entry.section)
          out << "end\n\n\n\nsubsection " << entry.section << '\n';
        else
          out << '\n';
        print_entry(entry, out);
        section = entry.section;
      }
    out << "end\n";
  }
} // namespace Contact
