/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/scene_variants.h"

#include <functional>

namespace Contact
{
  namespace
  {
    using Parameters::All;

    /// The variants of a scene as they are made.
    class Variants
    {
    public:
      explicit Variants(const All &scene)
        : scene(scene)
      {
      }

      /// The scene with a change; nothing if its entries then contradict each
      /// other.
      void add(const std::string                       &effect,
               const bool                               is_on,
               const std::vector<std::string>          &entries,
               const std::function<void(All &changed)> &change)
      {
        SceneVariant variant{effect, is_on, entries, scene};
        forget_theory(variant.parameters.probes);
        change(variant.parameters);
        try
          {
            variant.parameters.check();
          }
        catch (const EntryError &)
          {
            return;
          }
        all.push_back(variant);
      }

      const All                &scene;
      std::vector<SceneVariant> all;

    private:
      /// Closed forms are those of the scene itself, not of its variants.
      static void forget_theory(Parameters::Probes &probes)
      {
        probes.hertz.clear();
        probes.concentric_cylinders.clear();
        probes.frictional_theory = false;
      }
    };



    /// A map as its entry has it.
    template<typename Value>
    std::string entry_of(const std::string                  &name,
                         const std::map<std::string, Value> &values)
    {
      return name + "=" + Patterns::Tools::to_string(values);
    }



    /// One of formulas, which have commas of their own.
    std::string entry_of(const std::string                        &name,
                         const std::map<std::string, std::string> &formulas)
    {
      std::string entry = name + "=";
      for (const auto &[key, formula] : formulas)
        entry += (entry.back() == '=' ? "" : "; ") + key + ": " + formula;
      return entry;
    }



    /// The contact pair of a section in another scene.
    Parameters::Contact &pair_of(All &scene, const std::string &name)
    {
      return name.empty() ? scene.contact : scene.further_contacts.at(name);
    }



    void add_kinematics(Variants &variants)
    {
      using Parameters::GeometryLoop;
      using Parameters::Strains;
      const All &scene    = variants.scene;
      const bool is_large = !scene.solids.kinematics.all_are(Strains::small);
      const std::string geometry = "Solution/Geometry=";
      const auto        frozen   = [](All &changed) {
        changed.solution.geometry = GeometryLoop::undeformed;
      };
      const auto following = [](All &changed) {
        changed.solution.geometry = GeometryLoop::automatic;
      };

      if (is_large)
        variants.add("large displacement",
                     true,
                     {"Solids/Kinematics=small strain",
                      geometry + "undeformed"},
                     [&](All &changed) {
                       changed.solids.kinematics = Strains::small;
                       frozen(changed);
                     });
      else
        variants.add("large displacement",
                     false,
                     {"Solids/Kinematics=large displacement",
                      geometry + "automatic"},
                     [&](All &changed) {
                       changed.solids.kinematics = Strains::large;
                       following(changed);
                     });
      if (is_large || scene.pairs().empty())
        return;
      if (scene.solution.geometry == GeometryLoop::undeformed)
        variants.add("contact of deformed surfaces",
                     false,
                     {geometry + "automatic"},
                     following);
      else
        variants.add("contact of deformed surfaces",
                     true,
                     {geometry + "undeformed"},
                     frozen);
    }



    void add_friction(const Parameters::Contact &of_pair, Variants &variants)
    {
      const std::string section = of_pair.section() + "/";
      const std::string name    = of_pair.name;
      if (of_pair.frictional())
        variants.add(section + "friction",
                     true,
                     {section + "Friction coefficient=0",
                      section + "Tresca limit=0"},
                     [&](All &changed) {
                       pair_of(changed, name).friction_coefficient = 0;
                       pair_of(changed, name).tresca_limit         = 0;
                     });
      else
        variants.add(section + "friction 0.1",
                     false,
                     {section + "Friction coefficient=0.1"},
                     [&](All &changed) {
                       pair_of(changed, name).friction_coefficient = 0.1;
                     });
    }



    void add_pair(const Parameters::Contact &of_pair, Variants &variants)
    {
      const std::string section = of_pair.section() + "/";
      const std::string name    = of_pair.name;
      if (of_pair.tied)
        variants.add(section + "glue",
                     true,
                     {section + "Tied=false"},
                     [&](All &changed) {
                       pair_of(changed, name).tied = false;
                     });
      else
        {
          add_friction(of_pair, variants);
          variants.add(section + "glue",
                       false,
                       {section + "Tied=true",
                        section + "Friction coefficient=0",
                        section + "Tresca limit=0"},
                       [&](All &changed) {
                         Parameters::Contact &glued = pair_of(changed, name);
                         glued.tied                 = true;
                         glued.friction_coefficient = 0;
                         glued.tresca_limit         = 0;
                       });
        }
      variants.add(section + "the pair itself",
                   true,
                   {section + "Slave=",
                    section + "Master=",
                    section + "Obstacle=",
                    section + "Obstacle motion=",
                    section + "Excluded points=",
                    section + "Friction coefficient=0",
                    section + "Tresca limit=0",
                    section + "Tied=false"},
                   [&](All &changed) {
                     if (name.empty())
                       changed.contact = Parameters::Contact();
                     else
                       changed.further_contacts.erase(name);
                   });
    }



    using Parameters::Boundary;



    /// An entry of the boundary conditions without one of its groups; a history
    /// of nothing goes, too.
    template<typename Groups, typename Access>
    void add_without(const std::string &entry,
                     const std::string &group,
                     const Groups      &others,
                     const Access      &values,
                     Variants          &variants)
    {
      const std::string        section   = "Boundary conditions/";
      std::vector<std::string> entries   = {entry_of(section + entry, others)};
      auto                     histories = variants.scene.boundary.histories;
      if (others.empty() && histories.erase(entry) > 0)
        entries.push_back(entry_of(section + "Histories", histories));
      variants.add(entry + " of " + group, true, entries, [&](All &changed) {
        values(changed.boundary)   = others;
        changed.boundary.histories = histories;
      });
    }



    /// Each group of an entry of loads.
    template<typename Access>
    void add_groups(const std::string &entry,
                    const Access      &values,
                    Variants          &variants)
    {
      for (const auto &[group, value] : values(variants.scene.boundary))
        {
          auto others = values(variants.scene.boundary);
          others.erase(group);
          add_without(entry, group, others, values, variants);
        }
    }



    /// Each support that moves: it rests.
    template<typename Access>
    void add_displacements(const std::string &entry,
                           const Access      &values,
                           Variants          &variants)
    {
      for (const auto &[group, value] : values(variants.scene.boundary))
        if (value != 0)
          {
            auto others   = values(variants.scene.boundary);
            others[group] = 0;
            add_without(entry, group, others, values, variants);
          }
    }



    /// Each group of an entry of loads, in each direction.
    template<typename Value>
    void add_directions(const std::string           &entry,
                        Boundary::ByDirection<Value> Boundary::*const values,
                        Variants                                     &variants)
    {
      for (const unsigned int c : {0, 1})
        add_groups(
          entry + ' ' + "xy"[c],
          [&](auto &boundary) -> auto & { return (boundary.*values)[c]; },
          variants);
    }



    void add_loads(Variants &variants)
    {
      for (const unsigned int c : {0, 1})
        add_displacements(
          std::string("Displacement ") + "xy"[c],
          [c](auto &boundary) -> auto & { return boundary.displacement[c]; },
          variants);
      add_displacements(
        "Displacement normal",
        [](auto &boundary) -> auto & { return boundary.displacement_normal; },
        variants);
      add_directions("Force", &Boundary::force, variants);
      add_directions("Resultant force", &Boundary::resultant_force, variants);
      add_groups(
        "Pressure",
        [](auto &boundary) -> auto & { return boundary.pressure; },
        variants);
      add_directions("Traction", &Boundary::traction, variants);
      add_directions("Body force", &Boundary::body_force, variants);
    }



    void add_materials(Variants &variants)
    {
      for (const auto &[body, modulus] : variants.scene.solids.youngs_modulus)
        {
          std::map<std::string, double> stiffer =
            variants.scene.solids.youngs_modulus;
          stiffer[body] *= 1.01;
          variants.add("Young's modulus of " + body + " + 1 %",
                       false,
                       {entry_of("Solids/Young's modulus", stiffer)},
                       [&](All &changed) {
                         changed.solids.youngs_modulus = stiffer;
                       });
        }
    }
  } // namespace



  std::vector<SceneVariant> scene_variants(const Parameters::All &scene)
  {
    Variants variants(scene);
    add_kinematics(variants);
    for (const Parameters::Contact &of_pair : scene.pairs())
      add_pair(of_pair, variants);
    add_loads(variants);
    add_materials(variants);
    return variants.all;
  }
} // namespace Contact
