/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The entries of the scene: mesh, element, bodies and loads.

#include <deal.II/base/patterns.h>

#include "parameters/geometry.h"
#include "parameters/parameters.h"

namespace Contact
{
  namespace Parameters
  {
    namespace
    {
      /// Formulas by name, separated by semicolons: there are commas in them.
      Patterns::Map formulas()
      {
        return {Patterns::Anything(),
                Patterns::Anything(),
                0,
                Patterns::Map::max_int_value,
                ";"};
      }
    } // namespace



    void Mesh::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Mesh");
      prm.add_parameter("File",
                        file,
                        "The mesh: a gmsh file in MSH format 2.2 or 4.1, or "
                        "a geometry that gmsh meshes: .geo, .step, .brep; "
                        "coordinates in mm, relative to the file that sets "
                        "this entry.");
      Geometry::add_parameters(prm);
      prm.add_parameter("Refinements",
                        refinements,
                        "How often the mesh is refined globally [-].",
                        Patterns::Integer(0));
      prm.add_parameter("Mid-side nodes",
                        mid_side_nodes,
                        "Whether sides of cells are curved as the mid-side "
                        "nodes of elements of second order are placed [-]; "
                        "boundaries that an entry below calls round are as it "
                        "says. Without, all others are straight.");
      prm.add_parameter("Arcs",
                        arcs,
                        "Boundary groups that are arcs of circles: 'group: "
                        "centre x, centre y, radius' [mm], separated by ';'; "
                        "in the coordinates of the file.");
      prm.add_parameter("Spheres",
                        spheres,
                        "Boundary groups of volumes that are parts of spheres: "
                        "'group: centre x, y, z, radius' [mm], separated by "
                        "';'; in the coordinates of the file.");
      prm.add_parameter("Cylinders",
                        cylinders,
                        "The same of cylinders: 'group: x, y, z of a point of "
                        "the axis, x, y, z of its direction, radius' [mm].");
      prm.add_parameter("Cones",
                        cones,
                        "The same of cones: 'group: x, y, z of the apex, x, y, "
                        "z of the axis, angle between axis and surface' [mm, "
                        "degrees].");
      prm.add_parameter("Tori",
                        tori,
                        "The same of tori: 'group: x, y, z of the centre, x, "
                        "y, z of the axis, radius of the ring, radius of the "
                        "tube' [mm].");
      prm.add_parameter("Groups",
                        groups,
                        "Boundary groups made of others: 'name: group, group', "
                        "separated by ';' [-].");
      prm.add_parameter("Faces",
                        faces,
                        "Names for outer faces by their place: 'name: "
                        "condition', separated by ';', as 'Top: y > 9.99' or "
                        "'Bore: x^2 + y^2 < 25.1'. All corners of a face meet "
                        "the condition, in the coordinates of the file [mm]; "
                        "'name in body: condition' for those of one body.",
                        formulas());
      prm.add_parameter("Points",
                        points,
                        "Names for places: 'name: x, y', of volumes 'x, y, z' "
                        "[mm], separated by ';', in the coordinates of the "
                        "file; 'name in body: x, y' where bodies touch. The "
                        "corner of a cell there, as a point group of the "
                        "file; between nodes a place for forces and probes.");
      prm.add_parameter("Move",
                        move,
                        "'body: dx, dy' [mm], separated by ';', of volumes "
                        "'dx, dy, dz'; shifts a body "
                        "against the others, in the coordinates of the file. "
                        "Its round boundaries move with it.");
      prm.add_parameter("Scale",
                        scale,
                        "Factor of all lengths of the file and of Move [-]; > "
                        "0.");
      prm.add_parameter("Rotation",
                        rotation,
                        "Turns the whole mesh about the origin, anticlockwise, "
                        "after Scale [degrees]; three angles turn a volume "
                        "about x, then y, then z.");
      prm.add_parameter("Shift",
                        shift,
                        "'x, y' or 'x, y, z' [mm]; shifts the whole mesh, "
                        "after Rotation.");
      prm.leave_subsection();
    }



    void Element::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Element");
      // The action follows at once: what is declared is what there is.
      prm.declare_entry("Degree",
                        degree_is_automatic ? "automatic"
                                            : std::to_string(degree),
                        Patterns::Selection(Choice<Degree>::names()),
                        "Polynomial degree of the displacements [-]; "
                        "automatic: 2 of a mesh with tetrahedra, which are "
                        "too stiff at degree 1, 1 of all others.");
      prm.add_action("Degree", [this](const std::string &value) {
        const Choice<Degree> choice(value);
        degree_is_automatic = choice == Degree::automatic;
        degree              = choice == Degree::two ? 2 : 1;
      });
      prm.add_parameter(
        "Centre node",
        centre_node,
        "The node in the middle of a quadrilateral of degree "
        "2 [-]; serendipity: half the sum of the mid-sides minus a "
        "quarter of the sum of the corners (8-node element; of a hexahedron, "
        "whose sides it holds for as well, the 20-node element), "
        "free: an unknown (9-node, in 3-D 27-node element).");
      prm.leave_subsection();
    }



    void Solids::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Solids");
      prm.add_parameter("Young's modulus",
                        youngs_modulus,
                        "'body: E' [MPa], separated by ','; E > 0.");
      prm.add_parameter("Poisson's ratio",
                        poisson,
                        "'body: nu' [-], separated by ','; the same bodies "
                        "as in Young's modulus, -1 < nu < 0.5.");
      prm.add_parameter(
        "Symmetry",
        symmetry,
        "2-D idealization [-]; plane strain: the mesh is a "
        "slice of 1 mm; plane stress: elastic bodies in small "
        "strain, free to become thinner; axisymmetric: rings about the axis x "
        "= 0, x >= 0 being the radius, without torsion. Forces "
        "are then those of whole rings [N], stress zz is that "
        "of the hoops, and u_x = 0 on the axis.");
      prm.add_parameter("Kinematics",
                        kinematics,
                        "How the bodies move [-]; large displacement: Green "
                        "strain and rotations of any size, small strain: "
                        "linear; or 'body: kinematics' of each, separated by "
                        "','.");
      prm.add_parameter(
        "Dilatation",
        dilatation,
        "The trace of the strain in a cell [-]; full: as it is, "
        "B-bar: its mean, in quadrangles of degree 2 its linear "
        "part, against locking, automatic: B-bar for bodies "
        "with nu > 5/11 or plasticity. Triangles of degree 1 lock either way.");
      prm.add_parameter("Incompatible modes",
                        incompatible_modes,
                        "Elastic bodies of quadrangles or hexahedra of degree "
                        "1 [-], separated by ','; strains that the modes of "
                        "their cells add let them bend, which they are too "
                        "stiff for otherwise. They take the place of B-bar.");
      add_materials(prm);
      prm.leave_subsection();
    }



    void Solids::add_materials(ParameterHandler &prm)
    {
      prm.add_parameter("Material",
                        material,
                        "'body: material' [-], separated by ','; elastic: "
                        "linear, in large displacement St. Venant and "
                        "Kirchhoff's, and so are bodies without an entry; "
                        "elastic-plastic: of von Mises, in large displacement "
                        "by logarithmic strains; "
                        "neo-Hookean: in large displacement, with modulus and "
                        "ratio at zero strain; Mooney-Rivlin: the same with "
                        "the constant below.");
      prm.add_parameter("Mooney-Rivlin constant",
                        mooney_rivlin_constant,
                        "'body: C01' [MPa], separated by ','; that of the "
                        "second invariant. C10, of the first one, is half the "
                        "shear modulus minus C01; both >= 0.");
      prm.add_parameter("Yield stress",
                        yield_stress,
                        "'body: stress' [MPa], separated by ','; where an "
                        "elastic-plastic body begins to yield. Of elastic "
                        "bodies a check: how much of the volume and of the "
                        "contact is above it.");
      prm.add_parameter("Hardening modulus",
                        hardening_modulus,
                        "'body: slope' [MPa] of the yield stress by the "
                        "equivalent plastic strain; >= 0.");
      prm.add_parameter("Kinematic hardening modulus",
                        kinematic_hardening_modulus,
                        "'body: slope' [MPa] of the uniaxial back stress by "
                        "the plastic strain; >= 0.");
      prm.add_parameter("Saturation stress",
                        saturation_stress,
                        "'body: stress' [MPa], which the yield stress tends to "
                        "besides the hardening modulus, as 1 - exp(-rate times "
                        "plastic strain) (Voce).");
      prm.add_parameter("Saturation rate",
                        saturation_rate,
                        "'body: rate' [-] of that; > 0.");
      prm.add_parameter("Hardening curve",
                        hardening_curve,
                        "'body: plastic strain, stress, plastic strain, ...' "
                        "[-, MPa], separated by ';'; the yield stress, linear "
                        "in between and behind the last one constant. At no "
                        "plastic strain it is Yield stress; that pair may be "
                        "left out.");
      prm.add_parameter("Thermal strain",
                        thermal_strain,
                        "'body: formula' [-], separated by ';'; the strain in "
                        "all directions of the body without stress, by heat or "
                        "swelling; a formula in the load factor t or a table, "
                        "as those of 'Boundary conditions/Histories', such as "
                        "'1e-3*t'.",
                        Patterns::Map(Patterns::Anything(),
                                      Patterns::Anything(),
                                      0,
                                      Patterns::Map::max_int_value,
                                      ";"));
    }



    void Boundary::add_parameters(ParameterHandler &prm)
    {
      prm.enter_subsection("Boundary conditions");
      add_values(prm);
      add_formulas(prm);
      prm.leave_subsection();
    }



    namespace
    {
      /// An entry with one for each direction, whose meaning that in x says.
      template<typename Value>
      void add_by_direction(
        ParameterHandler             &prm,
        const std::string            &name,
        Boundary::ByDirection<Value> &values,
        const std::string            &meaning,
        const std::string            &unit,
        const Patterns::PatternBase  &pattern =
          *Patterns::Tools::Convert<std::map<std::string, Value>>::to_pattern())
      {
        prm.add_parameter(name + " x", values[0], meaning, pattern);
        for (unsigned int c = 1; c < 3; ++c)
          prm.add_parameter(name + ' ' + "xyz"[c],
                            values[c],
                            "As " + name + " x, in direction " + "xyz"[c] +
                              (c == 2 ? " of volumes " : " ") + unit + ".",
                            pattern);
      }
    } // namespace



    // One number for a group, or its partner.
    void Boundary::add_values(ParameterHandler &prm)
    {
      const std::string per_mm = "[N per mm of thickness; axisymmetric: N]";
      add_by_direction(prm,
                       "Displacement",
                       displacement,
                       "'group: value' [mm], separated by ','; a boundary or "
                       "point group and its displacement at full load.",
                       "[mm]");
      prm.add_parameter("Displacement normal",
                        displacement_normal,
                        "'boundary: value' [mm], separated by ','; a flat "
                        "boundary group and its displacement along its outward "
                        "normal at full load. Zero: a plane of symmetry, in "
                        "any direction.");
      add_by_direction(prm,
                       "Tied",
                       tied,
                       "'group: point' [-], separated by ','; all nodes of a "
                       "boundary or point group move in x as the point does, "
                       "as those of a rigid platen with a guide.",
                       "[-]");
      prm.add_parameter("Rigid",
                        rigid,
                        "'boundary: point' [-], separated by ','; a boundary "
                        "group that moves as a rigid body, and the point that "
                        "moves with it, of the mesh or not. Displacement, "
                        "Force, Rotation and Moment of the boundary are those "
                        "of this point; without them it moves freely.");
      add_by_direction(prm,
                       "Rotation",
                       rotation,
                       "'boundary: value' [rad], separated by ','; a rigid "
                       "boundary of a volume and its rotation at full load, in "
                       "large displacement a component of the vector of "
                       "rotation.",
                       "and plane sections [rad]");
      add_by_direction(prm,
                       "Moment",
                       moment,
                       "'boundary: value' [N mm], separated by ','; a rigid "
                       "boundary of a volume and its dead moment at full load.",
                       "and plane sections [N mm; of these by mm of "
                       "thickness]");
      add_by_direction(prm,
                       "Force",
                       force,
                       "'point: value' [N per mm of thickness; axisymmetric: N "
                       "on the ring; volumes: N], separated by ','; a point "
                       "group or a rigid boundary and its dead force at full "
                       "load.",
                       per_mm);
      add_by_direction(prm,
                       "Resultant force",
                       resultant_force,
                       "'boundary: value' [N per mm of thickness; "
                       "axisymmetric: N on all rings; volumes: N], separated "
                       "by ','; a boundary group and its dead force at full "
                       "load, spread evenly over its undeformed area. Of a "
                       "nodal force the finer mesh sees the singularity.",
                       per_mm);
      for (const std::string component : {"x", "y"})
        prm.declare_alias("Resultant force " + component,
                          "Spread force " + component,
                          /*alias_is_deprecated=*/true);
    }



    // Entries that vary over a group, or with the load.
    void Boundary::add_formulas(ParameterHandler &prm)
    {
      prm.add_parameter("Pressure",
                        pressure,
                        "'boundary: formula' [MPa], separated by ';'; a "
                        "boundary group and the pressure on it at full load, a "
                        "formula in x, y and, of volumes, z [mm], positive in "
                        "compression. It acts along the normal of the "
                        "undeformed boundary. In all formulas x, y and z are "
                        "coordinates after Mesh/Move, Scale, Rotation and "
                        "Shift.",
                        formulas());
      add_by_direction(prm,
                       "Displacement formula",
                       displacement_formula,
                       "'group: formula' [mm], separated by ';'; a boundary or "
                       "point group and its displacement, a formula in x, y, "
                       "of volumes z [mm], and the load factor t from 0 to 1, "
                       "such as '-0.01*t*y'. It has no history beside.",
                       "[mm]",
                       formulas());
      add_by_direction(prm,
                       "Traction",
                       traction,
                       "'boundary: formula' [MPa], separated by ';'; a "
                       "boundary group and the force on it by undeformed area "
                       "at full load, a formula as that of a pressure [mm].",
                       "[MPa]",
                       formulas());
      add_by_direction(prm,
                       "Body force",
                       body_force,
                       "'body: formula' [N/mm^3], separated by ';'; a body and "
                       "the force on it by undeformed volume at full load, a "
                       "formula as that of a pressure [mm]; weight is -density "
                       "times gravity, of steel -7.7e-5.",
                       "[N/mm^3]",
                       formulas());
      prm.add_parameter("Histories",
                        histories,
                        "'entry: formula' [-], separated by ';'; an entry of "
                        "this section, and the factor of all its values as a "
                        "formula in the load factor t from 0 to 1, as in "
                        "'Force y: min(1, 2*t)', or as a table of t and the "
                        "factor, linear in between and constant beyond, as in "
                        "'Force y: table(0 0, 0.5 1, 1 -1)'. Without: t.",
                        formulas());
    }
  } // namespace Parameters
} // namespace Contact
