/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The entries of a contact pair.

#include <deal.II/base/patterns.h>

#include "parameters/parameters.h"

namespace Contact
{
  namespace Parameters
  {
    void Contact::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection(section());
      add_surfaces(prm);
      add_law(prm);
      prm.leave_subsection();
    }



    // The two sides, and the points between them.
    void Contact::add_surfaces(ParameterHandler &prm)
    {
      prm.add_parameter(
        "Slave",
        slave,
        "Boundary group that carries the contact points [-]; "
        "empty, together with Master: no contact. More contact pairs "
        "have sections of their own, 'Contact NAME', with the "
        "same entries.");
      prm.add_parameter("Master",
                        master,
                        "Boundary group they are projected on [-].");
      prm.add_parameter(
        "Surfaces",
        surfaces,
        "Automatic: instead of Slave and Master all outer faces of all bodies, "
        "a contact pair 'Contact SLAVE MASTER' for each two that no other "
        "section pairs, and that share no nodes [-]; with self-contact also "
        "one of each body with itself; the other entries of this section are "
        "theirs.");
      prm.add_parameter(
        "Bodies",
        bodies,
        "With automatic surfaces, the bodies that they are of [-], separated "
        "by ','; empty: all.");
      prm.add_parameter(
        "Obstacle",
        obstacle,
        "A rigid master without a mesh, instead of Master "
        "[mm]: 'half plane: x, y, normal x, normal y', a point "
        "and the outward normal, or 'circle: x, y, radius', "
        "negative for a hole; in 3-D 'half space: x, y, z, "
        "normal x, normal y, normal z', 'sphere: x, y, z, "
        "radius', 'cylinder: x, y, z, axis x, axis y, axis z, "
        "radius'; in both 'profile: x, y, radius, x, y, "
        "radius, ...', a line in 2-D with rounded "
        "corners and the obstacle on its left, closed if it ends "
        "where it begins, else its ends have the radius 0 and "
        "go on for ever; in 3-D along z.");
      prm.add_parameter("Obstacle motion",
                        obstacle_motion,
                        "How the obstacle moves: 'x: formula; y: formula; z: "
                        "formula' [mm], 'angle: formula' [degrees], separated "
                        "by ';'; formulas in t or tables as those of 'Boundary "
                        "conditions/Histories'. It turns about the Obstacle "
                        "centre, which moves along. Empty: it stands still.",
                        Patterns::Map(Patterns::Anything(),
                                      Patterns::Anything(),
                                      0,
                                      Patterns::Map::max_int_value,
                                      ";"));
      prm.add_parameter("Obstacle centre",
                        obstacle_centre,
                        "The point x, y, in 3-D x, y, z, that the obstacle "
                        "turns about, and its moments are about [mm]. Empty: "
                        "the point that Obstacle begins with.");
      prm.add_parameter("Obstacle axis",
                        obstacle_axis,
                        "In 3-D the direction x, y, z of the axis that the "
                        "obstacle turns about [-]. Empty: that of a cylinder.");
      prm.add_parameter("Obstacle force",
                        obstacle_force,
                        "Motions of the obstacle that follow from what it "
                        "exerts on the slave: 'x: formula; y: formula; z: "
                        "formula' [N per mm of thickness, in rings and in "
                        "3-D N], as in Obstacle motion, which then does not "
                        "give them. It moves until it touches.",
                        Patterns::Map(Patterns::Anything(),
                                      Patterns::Anything(),
                                      0,
                                      Patterns::Map::max_int_value,
                                      ";"));
      prm.add_parameter(
        "Obstacle moment",
        obstacle_moment,
        "The same of its rotation: the moment on the slave about "
        "the Obstacle centre, in 3-D about the Obstacle axis "
        "[N mm per mm of thickness, in 3-D N mm]; a formula "
        "in t or a table. Empty: the rotation is given.");
      prm.add_parameter("Interference",
                        interference,
                        "Overlap of the surfaces that the mesh does not show "
                        "[mm], as that of a press fit that is "
                        "drawn with one radius; a formula in t or a table, as "
                        "those of 'Boundary conditions/Histories'. Negative: "
                        "clearance.");
      prm.add_parameter("Preload",
                        preload,
                        "Of glued surfaces, the two sides of a cut through a "
                        "bolt: the tension in the cut, along its normal [N per "
                        "mm of thickness, in rings and in 3-D N]; a formula "
                        "in t or a table. By how much the bolt is shortened "
                        "there follows from it.");
      prm.add_parameter("Preload end",
                        preload_end,
                        "Increments that begin at this load factor or behind "
                        "it keep the shortening, and the force follows [-].",
                        Patterns::Double(0, 1));
      prm.add_parameter("Discretization",
                        discretization,
                        "Where the contact points are [-]; nodal: in the nodes "
                        "of the slave; Gauss: in the Gauss points of its "
                        "faces; mortar: in the nodes, with gaps that are "
                        "weighted along the surface by dual functions.");
      prm.add_parameter(
        "Gauss points",
        n_gauss_points,
        "Gauss points per slave face [-]; only for the discretization "
        "Gauss.",
        Patterns::Integer(1, 10));
      prm.add_parameter(
        "Excluded points",
        excluded_points,
        "Groups of points, curves or faces whose nodes on the slave "
        "surface carry no contact point [-], separated by ','; for the "
        "discretizations nodal and mortar.");
    }



    // The law in these points.
    void Contact::add_law(ParameterHandler &prm)
    {
      prm.add_parameter("Tied",
                        tied,
                        "Glue the slave to the master wherever it faces it, "
                        "instead of contact [-]: what the same bodies cost "
                        "without contact; nodal discretization or mortar. The "
                        "moment of the shear over a gap between them is lost.");
      prm.add_parameter("Friction coefficient",
                        friction_coefficient,
                        "Coulomb's coefficient of friction [-]; 0: none.",
                        Patterns::Double(0));
      prm.add_parameter("Tresca limit",
                        tresca_limit,
                        "Bound of the tangential traction that does not "
                        "depend on the pressure [MPa]; 0: none.",
                        Patterns::Double(0));
      prm.add_parameter("Elastic slip",
                        elastic_slip,
                        "Slip at which the shear reaches its bound, in "
                        "proportion below it: a length [mm], or a share of "
                        "the slave's edge, '0.5 %'. Empty: none, below the "
                        "bound surfaces stick.");
      prm.add_parameter(
        "Augmentation parameter",
        augmentation_parameter,
        "Parameter c of the augmented Lagrangian p = max(0, "
        "lambda - c gap), by the stiffness E/h of the slave's "
        "edge [-]; > 0. Results of the nodal and mortar discretizations "
        "do not depend on it, those of the Gauss-point discretization do. In "
        "3-D the default means 1.");
      for (const auto &[now, former] :
           {std::make_pair("Discretization", "Rule"),
            std::make_pair("Augmentation parameter", "Complementarity")})
        prm.declare_alias(now, former, /*alias_is_deprecated=*/true);
    }
  } // namespace Parameters
} // namespace Contact
