/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */


#ifndef contact_parameters_scene_h
#define contact_parameters_scene_h

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/errors.h"
#include "parameters/choices.h"
#include "parameters/per_body.h"

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

  /// Check a history, see parse_history(). Throws EntryError.
  void check_history(const std::string &history, const std::string &entry);

  /// The same for a formula of the place.
  void check_place_formula(const std::string &formula,
                           const std::string &entry);



  /**
   * The parameters of a case, one plain structure per concern. Each structure
   * declares its entries once, in <code>add_parameters</code> (default,
   * pattern, meaning and unit), and checks in <code>check</code> what one
   * entry alone cannot know.
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

      /// Whether sides of cells go through the mid-side nodes of elements of
      /// second order, see make_round().
      bool mid_side_nodes = false;

      /// Not an entry: whether each body has a group of all its outer faces,
      /// see read_with_surfaces().
      bool has_outer_surfaces = false;

      /// Boundary group -> {centre x, centre y, radius} [mm].
      std::map<std::string, std::vector<double>> arcs;

      /// The same in 3-D: boundary group -> the numbers of its surface,
      /// lengths in mm: {centre, radius}; {point and direction of the axis,
      /// radius}; {apex, direction of the axis, angle [degrees]}; {centre,
      /// direction of the axis, radii of ring and tube}.
      std::map<std::string, std::vector<double>> spheres, cylinders, cones,
        tori;

      /// Whether a boundary is named as round.
      bool is_round(const std::string &name) const
      {
        return arcs.count(name) + spheres.count(name) + cylinders.count(name) +
                 cones.count(name) + tori.count(name) >
               0;
      }

      /// Boundary group -> those that it is made of.
      std::map<std::string, std::vector<std::string>> groups;

      /// Boundary group -> the condition that the corners of its faces meet, in
      /// the coordinates of the file.
      std::map<std::string, std::string> faces;

      /// A name for the node at {x, y} or {x, y, z} [mm], in the coordinates
      /// of the file.
      std::map<std::string, std::vector<double>> points;

      /// Body -> {dx, dy} or {dx, dy, dz} [mm], in the coordinates of the file.
      std::map<std::string, std::vector<double>> move;

      /// Changes of all coordinates of the file after that, in this order.
      double              scale    = 1;      // [-]
      std::vector<double> rotation = {0};    // about the origin [degrees]
      std::vector<double> shift    = {0, 0}; // [mm]

      void add_parameters(ParameterHandler &prm);
      void check() const;

    private:
      void check_vectors() const;
      void check_round_surfaces() const;
    };



    /// The finite element of the solids.
    struct Element
    {
      /// Of an automatic one 2 if there are tetrahedra, which the mesh tells.
      unsigned int degree              = 1;
      bool         degree_is_automatic = true;

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

      PerBody<Strains> kinematics = Strains::large;

      /// Body group -> its material; linear elastic without.
      std::map<std::string, Choice<MaterialModel>> material;

      /// Body group -> constants of plasticity [MPa], see Hardening; of elastic
      /// bodies the yield stress is a mere check.
      std::map<std::string, double> yield_stress, hardening_modulus,
        kinematic_hardening_modulus, saturation_stress;
      std::map<std::string, double>              saturation_rate; // [-]
      std::map<std::string, std::vector<double>> hardening_curve;

      MaterialModel model_of(const std::string &body) const
      {
        const auto found = material.find(body);
        return found == material.end() ? MaterialModel::elastic
                                       : MaterialModel(found->second);
      }

      /// Whether all bodies are linear elastic or St. Venant-Kirchhoff's.
      bool is_elastic() const;

      /// Whether any body is elastic-plastic.
      bool may_yield() const;

      /// Body group -> its free strain in all directions [-], a history, see
      /// parse_history().
      std::map<std::string, std::string> thermal_strain;

      /// Body group -> constant of the second invariant [MPa], see
      /// MooneyRivlin.
      std::map<std::string, double> mooney_rivlin_constant;

      /// See Elasticity.
      Choice<Dilatation> dilatation = Dilatation::automatic;

      /// Bodies whose cells bend, see CellIntegrals.
      std::vector<std::string> incompatible_modes;

      void add_parameters(ParameterHandler &prm);
      void check() const;

    private:
      void add_materials(ParameterHandler &prm);
      void check_kinematics() const;
      void check_materials() const;
      void check_modes() const;
      void check_hardening(const std::string &body) const;
    };



    /// Supports, ties and loads, all by group name.
    struct Boundary
    {
      /// By direction: the groups of an entry and their values. Those of z are
      /// of volumes only.
      template<typename Value>
      using ByDirection = std::array<std::map<std::string, Value>, 3>;

      /// Boundary or point group -> prescribed displacement [mm].
      ByDirection<double> displacement;

      /// Boundary or point group -> prescribed displacement [mm], a formula in
      /// x, y, of volumes z, and the load factor t.
      ByDirection<std::string> displacement_formula;

      /// Flat boundary group -> prescribed displacement along its outward
      /// normal [mm].
      std::map<std::string, double> displacement_normal;

      /// Boundary or point group -> point group: equal displacement.
      ByDirection<std::string> tied;

      /// Boundary group that moves as a rigid body -> the point that its
      /// displacements, forces and moments refer to.
      std::map<std::string, std::string> rigid;

      /// Such a group -> prescribed rotation [rad], and dead moment [N mm per
      /// mm of thickness] at full load; in 2-D about z.
      ByDirection<double> rotation, moment;

      /// Point group or rigid boundary -> dead force at full load [N per mm of
      /// thickness].
      ByDirection<double> force;

      /// Boundary group -> dead force at full load [N per mm of thickness],
      /// spread evenly over its undeformed length.
      ByDirection<double> resultant_force;

      /// Boundary group -> dead pressure at full load [MPa], a formula in x, y
      /// and of volumes z; normal to the undeformed boundary, positive in
      /// compression.
      std::map<std::string, std::string> pressure;

      /// Boundary group -> dead traction at full load by undeformed area [MPa],
      /// such a formula.
      ByDirection<std::string> traction;

      /// Body group -> dead force at full load by undeformed volume [N/mm^3],
      /// such a formula.
      ByDirection<std::string> body_force;

      /// Entry of this section -> its factor, a formula in the load factor t
      /// or a table, see parse_history().
      /// Those without grow as t.
      std::map<std::string, std::string> histories;

      void add_parameters(ParameterHandler &prm);
      void check() const;

      /// The entries of supports and loads, which may have histories, and
      /// whether each is set.
      std::vector<std::pair<std::string, bool>> entries_with_history() const;

      /// The first entry with values, or a history, in a direction that a plane
      /// mesh does not have, or nothing.
      std::string entry_in_space() const;

    private:
      void add_values(ParameterHandler &prm);
      void add_formulas(ParameterHandler &prm);
      void check_rigid() const;
    };



    /// One pair of surfaces that may touch: a contact pair.
    struct Contact
    {
      /// Of the section "Contact NAME"; empty for the section "Contact".
      std::string name;

      /// Not an entry: its slave has been taken away on the command line, and
      /// with it the pair, whatever else its section says.
      bool is_left_out = false;

      /// Not an entry: one of those that stand for an automatic section. Nodes
      /// that are tied or on a rigid boundary take no part in it.
      bool is_made = false;

      std::string slave;
      std::string master;

      /// Automatic: this section stands for pairs of all bodies, see
      /// add_automatic_pairs().
      Choice<ContactSurfaces> surfaces = ContactSurfaces::named;

      /// Those that automatic pairs are among; empty: all.
      std::vector<std::string> bodies;

      /// Instead of a master: see Obstacle.
      std::map<Choice<ObstacleShape>, std::vector<double>> obstacle;

      /// The motion of the obstacle: 'x', 'y', 'z' [mm] and 'angle' [degrees]
      /// by histories, see parse_history(); the point that it turns about, and
      /// in 3-D the direction of the axis there. Empty: those of the shape.
      std::map<std::string, std::string> obstacle_motion;
      std::vector<double>                obstacle_centre, obstacle_axis;

      /// Motions that are not given, but what they exert: forces along 'x',
      /// 'y', 'z' on the slave, and the moment about the axis, as histories.
      std::map<std::string, std::string> obstacle_force;
      std::string                        obstacle_moment;

      Choice<ContactDiscretization> discretization =
        ContactDiscretization::mortar;
      unsigned int n_gauss_points = 3;

      /// Points of the slave surface that carry no contact point.
      std::vector<std::string> excluded_points;

      /// The overlap of the surfaces in truth beyond that of the mesh [mm], a
      /// history, see parse_history(). Empty: not at all.
      std::string interference;

      /// The tension between glued surfaces along their normal [N per mm], a
      /// history, and the load factor behind which the shortening that it
      /// takes stays. Empty: none.
      std::string preload;
      double      preload_end = 1;

      /// Glue the surfaces where they face each other: no contact at all, but
      /// what the same bodies cost without it.
      bool tied = false;

      double friction_coefficient = 0; // Coulomb [-]
      double tresca_limit         = 0; // [MPa]; instead of Coulomb

      /// The slip at which the shear reaches the bound: a length [mm], or a
      /// share of the slave's edge with "%". Empty: exact sticking.
      std::string elastic_slip;

      /// The parameter c of the augmented Lagrangian, by the stiffness E/h of
      /// the slave's edge [-]. The active set of the nodal and mortar
      /// discretizations does not depend on it; with a status per Gauss point
      /// it enters the discrete problem.
      double augmentation_parameter = 1e-3;

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

      /// Whether motions of the pair follow from forces.
      bool has_free_motion() const
      {
        return !obstacle_force.empty() || !obstacle_moment.empty() ||
               !preload.empty();
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

      bool is_with_itself() const
      {
        return is_pair() && slave == master;
      }

      bool is_automatic() const
      {
        return surfaces != ContactSurfaces::named && !is_left_out;
      }

      void add_parameters(ParameterHandler &prm);
      void check() const;

    private:
      void add_surfaces(ParameterHandler &prm);
      void add_law(ParameterHandler &prm);
      void check_obstacle(const std::string &entry) const;
      void check_obstacle_motion() const;
      void check_obstacle_force() const;
      void check_preload() const;
      void check_surfaces() const;
      void check_friction() const;
      void check_excluded_points() const;
    };
  } // namespace Parameters
} // namespace Contact

#endif
