/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_parameters_h
#define contact_parameters_h

#include <deal.II/base/parameter_handler.h>

#include <filesystem>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/errors.h"
#include "parameters/choices.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Entries that can be read, but are wrong: the one by its value, or several
   * because they contradict each other. What checks a structure names them as
   * "Section/Entry"; read_parameters() adds where they were set.
   */
  struct EntryError : public InputError
  {
    EntryError(const std::string              &problem,
               const std::vector<std::string> &entries,
               const std::string              &remedy);

    const std::string              problem;
    const std::vector<std::string> entries;
    const std::string              remedy;
  };



  /**
   * The parameters of a case, one plain structure per concern. Each structure
   * declares its entries once, in <code>add_parameters</code> (default,
   * pattern, meaning and unit), and checks in <code>check</code> what one
   * entry alone can not know.
   *
   * Units: mm, N, MPa = N/mm^2; forces are per mm of thickness (plane strain),
   * which for the thickness 1 mm is the same number, or those of whole rings
   * (axisymmetric), in N.
   */
  namespace Parameters
  {
    /// The file of the mesh, and the boundaries that are arcs.
    struct Mesh
    {
      std::string  file;
      unsigned int refinements = 0;

      /// Boundary group -> {centre x, centre y, radius} [mm].
      std::map<std::string, std::vector<double>> arcs;

      /// Body -> {dx, dy} [mm], in the coordinates of the file.
      std::map<std::string, std::vector<double>> move;

      /// Changes of all coordinates of the file after that, in this order.
      double              scale    = 1;      // [-]
      double              rotation = 0;      // about the origin [degrees]
      std::vector<double> shift    = {0, 0}; // [mm]

      void add_parameters(ParameterHandler &prm);
      void check() const;
    };



    /// The finite element of the solids.
    struct Element
    {
      unsigned int degree = 1;

      /// Bound: the 8-node quadrilateral, free: the 9-node one.
      Choice<CentreNode> centre_node = CentreNode::serendipity;

      void add_parameters(ParameterHandler &prm);
      void check() const;
    };



    /// The materials of the bodies and their kinematics.
    struct Solids
    {
      /// Body group -> Young's modulus [MPa] and Poisson's ratio [-].
      std::map<std::string, double> youngs_modulus;
      std::map<std::string, double> poisson;

      /// See symmetry.h.
      Choice<Symmetry> symmetry = Symmetry::plane_strain;

      Choice<Strains> kinematics = Strains::large;

      /// See Elasticity.
      Choice<Dilatation> dilatation = Dilatation::automatic;

      void add_parameters(ParameterHandler &prm);
      void check() const;
    };



    /// Supports, ties and loads, all by group name.
    struct Boundary
    {
      /// Boundary or point group -> prescribed displacement [mm].
      std::map<std::string, double> displacement_x;
      std::map<std::string, double> displacement_y;

      /// Point group -> point group: equal displacement in y.
      std::map<std::string, std::string> tied_y;

      /// Point group -> dead force at full load [N per mm of thickness].
      std::map<std::string, double> force_x;
      std::map<std::string, double> force_y;

      /// Boundary group -> dead force at full load [N per mm of thickness],
      /// spread evenly over its undeformed length.
      std::map<std::string, double> resultant_force_x;
      std::map<std::string, double> resultant_force_y;

      /// Boundary group -> dead pressure at full load [MPa], a formula in x and
      /// y; normal to the undeformed boundary, positive in compression.
      std::map<std::string, std::string> pressure;

      /// Boundary group -> dead traction at full load by undeformed area [MPa],
      /// a formula in x and y.
      std::map<std::string, std::string> traction_x;
      std::map<std::string, std::string> traction_y;

      /// Body group -> dead force at full load by undeformed volume [N/mm^3], a
      /// formula in x and y.
      std::map<std::string, std::string> body_force_x;
      std::map<std::string, std::string> body_force_y;

      /// Entry of this section -> its factor, a formula in the load factor t
      /// or a table, see parse_history().
      /// Those without grow as t.
      std::map<std::string, std::string> histories;

      void add_parameters(ParameterHandler &prm);
      void check() const;

    private:
      void add_values(ParameterHandler &prm);
      void add_formulas(ParameterHandler &prm);
    };



    /// One pair of surfaces that may touch: a contact pair.
    struct Contact
    {
      /// Of the section "Contact NAME"; empty for the section "Contact".
      std::string name;

      std::string slave;
      std::string master;

      /// Instead of a master: see Obstacle.
      std::map<Choice<ObstacleShape>, std::vector<double>> obstacle;

      Choice<ContactDiscretization> discretization =
        ContactDiscretization::mortar;
      unsigned int n_gauss_points = 3;

      /// Points of the slave surface that carry no contact point.
      std::vector<std::string> excluded_points;

      /// Glue the surfaces where they face each other: no contact at all, but
      /// what the same bodies cost without it.
      bool tied = false;

      double friction_coefficient = 0; // Coulomb [-]
      double tresca_limit         = 0; // [MPa]; instead of Coulomb

      /// The parameter c of the augmented Lagrangian, by the stiffness E/h of
      /// the slave's edge [-]. The active set of the nodal and mortar
      /// discretizations does not depend on it; with a status per Gauss point
      /// it enters the discrete problem.
      double augmentation_parameter = 1e-3;

      /// Whether the ends of the master have points of their own, see
      /// make_corner_points(). No entry: it is tried where there is no solution
      /// otherwise.
      bool ends_are_corners = false;

      /// Whether each multiplier has a point of its own: only then it can be
      /// eliminated, excluded at a node, and live on one of several processes.
      bool has_point_per_multiplier() const
      {
        return discretization != ContactDiscretization::gauss;
      }

      bool frictional() const
      {
        return friction_coefficient > 0 || tresca_limit > 0;
      }

      std::string section() const
      {
        return name.empty() ? "Contact" : "Contact " + name;
      }

      /// Whether there is anything that may touch.
      bool is_pair() const
      {
        return !slave.empty();
      }

      void add_parameters(ParameterHandler &prm);
      void check() const;

    private:
      void check_obstacle(const std::string &entry) const;
      void check_surfaces() const;
      void check_friction() const;
      void check_excluded_points() const;
    };



    /// Increments and the nested loops inside them.
    struct Solution
    {
      unsigned int n_increments = 2;
      unsigned int max_cuts     = 6; // of an increment to half

      /// See All::geometry().
      Choice<GeometryLoop> geometry                = GeometryLoop::automatic;
      double               geometry_tolerance      = 1e-3;
      unsigned int         max_geometry_iterations = 30;

      Choice<FrictionLoop> friction                = FrictionLoop::newton;
      double               friction_tolerance      = 1e-10;
      unsigned int         max_friction_iterations = 60;

      double       newton_tolerance      = 1e-8;
      unsigned int max_newton_iterations = 25;

      /// Of iterative solvers, relative to the residual of the Newton step.
      double linear_tolerance = 1e-3;

      Choice<SystemKind> system = SystemKind::automatic;

      Choice<SolverKind> linear_solver = SolverKind::automatic;

      /// Whether the points are paired before each Newton step.
      bool pairs_each_step() const
      {
        return geometry != GeometryLoop::undeformed &&
               geometry != GeometryLoop::fixed_point;
      }

      /// Whether the bound of the shear is in the tangent.
      bool has_moving_bound() const
      {
        return friction == FrictionLoop::newton;
      }

      void add_parameters(ParameterHandler &prm);
      void check() const;

    private:
      void add_loops(ParameterHandler &prm);
      void add_linear_system(ParameterHandler &prm);
    };



    /// Nested iteration: solve, refine, start from there, and so on.
    struct Refinement
    {
      unsigned int n_levels = 0; // refinements on top of the first mesh

      Choice<Strategy> strategy = Strategy::uniform;

      double fraction  = 0.5;  // of the estimated error, in refined cells
      double tolerance = 1e-4; // Newton tolerance of all levels but the last

      void add_parameters(ParameterHandler &prm);
      void check() const;
    };



    /// Values to report, and to compare with a reference.
    struct Probes
    {
      /// Name -> {quantity, point group} or {quantity, point group, point
      /// group}; see the entry's documentation.
      std::map<std::string, std::vector<std::string>> probes;

      /// The quantities there are.
      static const std::vector<std::string> quantities;

      /// Name -> reference value, and its relative tolerance.
      std::map<std::string, double> references;
      std::map<std::string, double> tolerances;

      /// Hertz line contact to compare with: {radius [mm], force per length of
      /// the full cylinder [N/mm]} or {radius}: under the force that is found;
      /// empty: none.
      std::vector<double> hertz;

      /// Compare the shear with theory as well, not only with the pressure of
      /// Hertz without friction.
      bool frictional_theory = false;

      /// Concentric cylinders to compare with: {bore, radius of contact, outer
      /// radius [mm], mean pressure, amplitude of its cos(2 theta) [MPa]};
      /// empty: none.
      std::vector<double> concentric_cylinders;

      /// Estimate the discretization error of the probes on a refined mesh.
      bool estimate_errors = false;

      void add_parameters(ParameterHandler &prm);
      void check() const;

    private:
      void check_quantities() const;
      void check_references() const;
    };



    /// Files and screen.
    struct Output
    {
      std::string directory = "output";

      Choice<Screen> screen = Screen::full;

      bool vtu     = false;
      bool profile = false;
      bool nodes   = false;

      void add_parameters(ParameterHandler &prm);
    };



    /// All of them, and the name of the case: the stem of its file.
    struct All
    {
      std::string name;

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

      /// The directory of its results.
      std::filesystem::path directory() const;

      /// The number of processes that work on the case.
      unsigned int n_ranks = 1;

      /// Go on behind the last increment of an interrupted run.
      bool restart = false;

      /// Whether the multipliers are eliminated from the linear system, of a
      /// mesh with so many displacements; 0: as far as the entries tell.
      bool is_condensed(const std::size_t n_displacements = 0) const;

      /// The geometry loop: Newton's where the system knows how the pairing
      /// moves, unless the file asks for another one.
      GeometryLoop geometry(const std::size_t n_displacements) const;

      void add_parameters(ParameterHandler &prm);

      /**
       * The checks of several entries together: every entry of one concern
       * against every other. Throws InputError.
       */
      void check() const;

    private:
      void check_theory() const;
      void check_points() const;
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
