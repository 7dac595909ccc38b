/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_choices_h
#define contact_choices_h

#include <deal.II/base/patterns.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace Contact
{
  using namespace dealii;

  namespace Parameters
  {
    /// The values of an entry by their names, for each enum below: where they
    /// are read, written, and made a pattern of.
    template<typename Enum>
    using NamedValues = std::vector<std::pair<std::string, Enum>>;

    /// The body that the plane of the mesh is a section of.
    enum class Symmetry
    {
      plane_strain,
      plane_stress,
      axisymmetric
    };

    inline NamedValues<Symmetry> named_values(const Symmetry)
    {
      return {{"plane strain", Symmetry::plane_strain},
              {"plane stress", Symmetry::plane_stress},
              {"axisymmetric", Symmetry::axisymmetric}};
    }



    /// The strain measure of the bodies.
    enum class Strains
    {
      small,
      large
    };

    inline NamedValues<Strains> named_values(const Strains)
    {
      return {{"small strain", Strains::small},
              {"large displacement", Strains::large}};
    }



    /// The material of a body.
    enum class MaterialModel
    {
      elastic,
      elastic_plastic,
      neo_hookean,
      mooney_rivlin
    };

    inline NamedValues<MaterialModel> named_values(const MaterialModel)
    {
      return {{"elastic", MaterialModel::elastic},
              {"elastic-plastic", MaterialModel::elastic_plastic},
              {"neo-Hookean", MaterialModel::neo_hookean},
              {"Mooney-Rivlin", MaterialModel::mooney_rivlin}};
    }



    /// The polynomial degree of the displacements; automatic: the mesh tells.
    enum class Degree
    {
      automatic,
      one,
      two
    };

    inline NamedValues<Degree> named_values(const Degree)
    {
      return {{"automatic", Degree::automatic},
              {"1", Degree::one},
              {"2", Degree::two}};
    }



    /// The ninth node of a quadratic quadrangle.
    enum class CentreNode
    {
      serendipity,
      free
    };

    inline NamedValues<CentreNode> named_values(const CentreNode)
    {
      return {{"serendipity", CentreNode::serendipity},
              {"free", CentreNode::free}};
    }



    /// The volume change of the bodies: as it is, or projected.
    enum class Dilatation
    {
      automatic,
      full,
      B_bar
    };

    inline NamedValues<Dilatation> named_values(const Dilatation)
    {
      return {{"automatic", Dilatation::automatic},
              {"full", Dilatation::full},
              {"B-bar", Dilatation::B_bar}};
    }



    /// The rigid masters without a mesh.
    enum class ObstacleShape
    {
      half_plane,
      circle,
      half_space,
      sphere,
      cylinder,
      profile
    };

    inline NamedValues<ObstacleShape> named_values(const ObstacleShape)
    {
      return {{"half plane", ObstacleShape::half_plane},
              {"circle", ObstacleShape::circle},
              {"half space", ObstacleShape::half_space},
              {"sphere", ObstacleShape::sphere},
              {"cylinder", ObstacleShape::cylinder},
              {"profile", ObstacleShape::profile}};
    }



    /// The surfaces of contact: those that are named, or of all bodies with
    /// each other, also with themselves.
    enum class ContactSurfaces
    {
      named,
      automatic,
      with_self_contact
    };

    inline NamedValues<ContactSurfaces> named_values(const ContactSurfaces)
    {
      return {{"named", ContactSurfaces::named},
              {"automatic", ContactSurfaces::automatic},
              {"automatic with self-contact",
               ContactSurfaces::with_self_contact}};
    }



    /// The discretization of contact.
    enum class ContactDiscretization
    {
      nodal,
      gauss,
      mortar
    };

    inline NamedValues<ContactDiscretization>
    named_values(const ContactDiscretization)
    {
      return {{"nodal", ContactDiscretization::nodal},
              {"Gauss", ContactDiscretization::gauss},
              {"mortar", ContactDiscretization::mortar}};
    }



    /// The way in which projections and normals follow the bodies.
    enum class GeometryLoop
    {
      automatic,
      undeformed,
      fixed_point,
      each_step,
      newton
    };

    inline NamedValues<GeometryLoop> named_values(const GeometryLoop)
    {
      return {{"automatic", GeometryLoop::automatic},
              {"undeformed", GeometryLoop::undeformed},
              {"fixed point", GeometryLoop::fixed_point},
              {"each step", GeometryLoop::each_step},
              {"Newton", GeometryLoop::newton}};
    }



    /// The way in which the bound of friction follows the pressure.
    enum class FrictionLoop
    {
      fixed_point,
      newton
    };

    inline NamedValues<FrictionLoop> named_values(const FrictionLoop)
    {
      return {{"fixed point", FrictionLoop::fixed_point},
              {"Newton", FrictionLoop::newton}};
    }



    /// The linear system.
    enum class SystemKind
    {
      automatic,
      saddle_point,
      condensed
    };

    inline NamedValues<SystemKind> named_values(const SystemKind)
    {
      return {{"automatic", SystemKind::automatic},
              {"saddle point", SystemKind::saddle_point},
              {"condensed", SystemKind::condensed}};
    }



    /// The solver of the linear system.
    enum class SolverKind
    {
      automatic,
      umfpack,
      cholmod,
      amg,
      gmg,
      mumps
    };

    inline NamedValues<SolverKind> named_values(const SolverKind)
    {
      return {{"automatic", SolverKind::automatic},
              {"UMFPACK", SolverKind::umfpack},
              {"CHOLMOD", SolverKind::cholmod},
              {"AMG", SolverKind::amg},
              {"GMG", SolverKind::gmg},
              {"MUMPS", SolverKind::mumps}};
    }



    /// The errors of probes: where a run has them from, beside the values of
    /// its levels.
    enum class Errors
    {
      automatic, // from the tangent at hand, where that is cheap
      none,
      dual_weighted_residuals,
      next_mesh
    };

    inline NamedValues<Errors> named_values(const Errors)
    {
      return {{"automatic", Errors::automatic},
              {"none", Errors::none},
              {"dual weighted residuals", Errors::dual_weighted_residuals},
              {"next mesh", Errors::next_mesh}};
    }



    /// The refinement between two levels.
    enum class Strategy
    {
      automatic,
      uniform,
      adaptive
    };

    inline NamedValues<Strategy> named_values(const Strategy)
    {
      return {{"automatic", Strategy::automatic},
              {"uniform", Strategy::uniform},
              {"adaptive", Strategy::adaptive}};
    }



    /// The output on the screen.
    enum class Screen
    {
      full,
      increments,
      table,
      none
    };

    inline NamedValues<Screen> named_values(const Screen)
    {
      return {{"full", Screen::full},
              {"increments", Screen::increments},
              {"table", Screen::table},
              {"none", Screen::none}};
    }



    /**
     * An entry that is one of the values of an enum. It is compared and
     * switched over as the value, and has the value's name.
     */
    template<typename Enum>
    class Choice
    {
    public:
      Choice(const Enum value)
        : value(value)
      {
      }

      /// Throws an exception if no value has this name.
      explicit Choice(const std::string &name)
        : value(find(name))
      {
      }

      Choice &operator=(const std::string &name)
      {
        value = find(name);
        return *this;
      }

      operator Enum() const
      {
        return value;
      }

      std::string name() const
      {
        for (const auto &[name, of_name] : named_values(Enum()))
          if (of_name == value)
            return name;
        AssertThrow(false, ExcInternalError());
        return "";
      }

      /// All names, as in the pattern of the entry.
      static std::string names(const std::string &separator = "|")
      {
        std::string all;
        for (const auto &[name, value] : named_values(Enum()))
          all += (all.empty() ? "" : separator) + name;
        return all;
      }

    private:
      static Enum find(const std::string &name)
      {
        for (const auto &[of_value, value] : named_values(Enum()))
          if (of_value == name)
            return value;
        AssertThrow(false, ExcMessage("no value is named '" + name + "'"));
        return Enum();
      }

      Enum value;
    };
  } // namespace Parameters
} // namespace Contact



namespace dealii
{
  namespace Patterns
  {
    namespace Tools
    {
      /// For ParameterHandler::add_parameter().
      template<typename Enum>
      struct Convert<Contact::Parameters::Choice<Enum>>
      {
        using Choice = Contact::Parameters::Choice<Enum>;

        static std::unique_ptr<PatternBase> to_pattern()
        {
          return std::make_unique<Selection>(Choice::names());
        }

        static std::string
        to_string(const Choice &choice,
                  const PatternBase & = *Convert<Choice>::to_pattern())
        {
          return choice.name();
        }

        static Choice
        to_value(const std::string &name,
                 const PatternBase & = *Convert<Choice>::to_pattern())
        {
          return Choice(name);
        }
      };
    } // namespace Tools
  }   // namespace Patterns
} // namespace dealii

#endif
