/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */


#ifndef contact_parameters_h
#define contact_parameters_h

#include <filesystem>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/findings.h"
#include "parameters/parameters_scene.h"
#include "parameters/parameters_solution.h"

namespace Contact
{
  using namespace dealii;

  namespace Parameters
  {
    /// All of them, and the name of the case: the stem of its file.
    struct All
    {
      // Their maps are compiled once, not in every file.
      All();
      All(const All &);
      All(All &&);
      All &operator=(const All &);
      All &operator=(All &&);
      ~All();

      std::string name;
      Findings    findings; // of its file

      Mesh       mesh;
      Element    element;
      Solids     solids;
      Boundary   boundary;
      Contact    contact; // the first contact pair
      Solution   solution;
      Refinement refinement;
      Probes     probes;
      Output     output;

      /// The contact pairs of the sections "Contact NAME".
      std::map<std::string, Contact> further_contacts;

      /// All contact pairs, none without contact.
      std::vector<Contact> pairs() const;

      /// Declare the entries of "Contact NAME", which are those of Contact.
      void add_pair(const std::string &name, ParameterHandler &prm);

      /// If an assignment of the command line empties the slave of a contact
      /// pair, leave the pair out.
      void leave_out_pair(const std::string &assignment);

      /// The directory of its results.
      std::filesystem::path directory() const;

      /// The number of processes that work on the case.
      unsigned int n_ranks = 1;

      /// Go on behind the last increment of an interrupted run.
      bool restart = false;

      /// Whether a run by other loops goes before this one.
      bool is_repeated = false;

      /// Whether the mesh is refined until probes are accurate.
      bool asks_for_accuracy() const
      {
        return !probes.accuracy.empty();
      }

      /// Whether there may be more than one mesh.
      bool has_levels() const
      {
        return refinement.n_levels > 0 || asks_for_accuracy();
      }

      /// Whether a mesh is refined cell by cell, one of quadrangles alone or
      /// another one.
      bool refines_adaptively(const bool has_only_hypercubes) const;

      /// The reason why probes have no dual problems, as the error of the
      /// @p entry that asks for these; none if all have one.
      std::optional<EntryError>
      missing_dual_problem(const std::string &entry) const;

      /// Whether an accuracy is reached by dual problems, which say where the
      /// errors come from; else by the values on three meshes.
      bool follows_goals() const
      {
        return asks_for_accuracy() && !missing_dual_problem("Probes/Accuracy");
      }

      /// Whether probes have their errors from dual problems: where these are
      /// asked for, and of a single mesh. Levels tell them by their values,
      /// and so does the mesh refined once, if there is a run on it.
      bool solves_dual_problems() const;

      /// Whether effects can be estimated from the state of a plane scene, if
      /// they are to be. Throws EntryError.
      void check_effects_in_plane() const;

      /// Why nothing tells the errors of probes on a single mesh, or nothing.
      std::string missing_errors() const;

      /// Whether the multipliers are eliminated from the linear system, of a
      /// mesh with so many displacements; 0: as far as the entries tell.
      bool is_condensed(const std::size_t n_displacements = 0) const;

      /// The geometry loop: Newton's where the system knows how the pairing
      /// moves, unless the file asks for another one.
      GeometryLoop geometry(const std::size_t n_displacements) const;

      /// The same problem by another loop of friction or of geometry, or in
      /// the other system, what converges most often first: Newton's method
      /// with projections and friction in its tangent, and with multipliers
      /// where one process and one mesh allow that; elsewhere, and of several
      /// pairs, which may share nodes, in the condensed system. Last, instead
      /// of uniform levels, their finest mesh alone, with multipliers.
      std::vector<All>
      with_other_loops(const std::size_t n_displacements) const;

      /// The mesh has volumes, which its file tells.
      bool in_space = false;

      /// The same case in 3-D, on a mesh with tetrahedra or without. Throws
      /// InputError where an entry is one for the plane.
      All for_space(const bool has_tetrahedra = false) const;

      void add_parameters(ParameterHandler &prm);

      /// The entries that are not at their defaults and have no effect, by
      /// "Section/Entry": why.
      std::map<std::string, std::string> idle_entries() const;

      /**
       * The checks of several entries together: every entry of one concern
       * against every other. Throws InputError.
       */
      void check() const;

    private:
      void check_obstacles() const;
      void check_points() const;
      void check_dual_problems() const;

      /// The part of missing_dual_problem() that holds of effects, too.
      std::optional<EntryError>
           missing_derivative(const std::string &entry) const;
      void check_limits() const;
      void check_ranks() const;
      void check_saddle_point() const;
      void check_condensed() const;

      /// The first contact pair whose multipliers share points, if there is
      /// one.
      std::optional<Contact> shared_pair() const;
    };
  } // namespace Parameters



  /**
   * Read a case from a .prm or .json file into @p parameters, with @p overrides
   * of the form "Section/Entry=value" on top, and check it. @p prm is the
   * handler that was filled, to print what was used; it refers to @p
   * parameters, which has to live as long. What both hold before is lost.
   *
   * The format is that of ParameterHandler with three differences. An
   * <code>include</code> is relative to the file that includes, and so is the
   * mesh file to the file that names it (an override names it relative to the
   * working directory); an entry set twice in one file is an error (a file may
   * override what it includes, and a later include an earlier one); an unknown
   * entry is answered with the nearest known one. Throws InputError with file
   * and line. A section "Contact NAME" is declared by its first mention.
   *
   * JSON is an object of sections, which are objects of entries, as
   * ParameterHandler writes it or shorter: a value may be a number, true or
   * false, an entry of names and values an object, a list an array. "include"
   * is a file or an array of files of either format, and what a file sets
   * itself goes before what it includes.
   */
  void read_parameters(const std::filesystem::path    &file,
                       const std::vector<std::string> &overrides,
                       ParameterHandler               &prm,
                       Parameters::All                &parameters);

  /**
   * Print every entry with its default, its allowed values, its meaning and
   * its unit, as a parameter file.
   */
  void print_parameters(std::ostream &out);
} // namespace Contact

#endif
