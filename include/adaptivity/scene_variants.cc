/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/scene_variants.h"

#include <algorithm>

#include "adaptivity/variant_list.h"

namespace Contact
{
  namespace
  {
    using Parameters::All;

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
      if (!of_pair.interference.empty())
        variants.add(section + "interference",
                     true,
                     {section + "Interference="},
                     [&](All &changed) {
                       pair_of(changed, name).interference.clear();
                     });
      const std::vector<std::string> at_rest = {section + "Obstacle motion=",
                                                section + "Obstacle centre=",
                                                section + "Obstacle axis="};
      const auto let_rest = [](Parameters::Contact &resting) {
        resting.obstacle_motion.clear();
        resting.obstacle_centre.clear();
        resting.obstacle_axis.clear();
      };
      if (!of_pair.obstacle_motion.empty())
        variants.add(section + "obstacle motion",
                     true,
                     at_rest,
                     [&](All &changed) { let_rest(pair_of(changed, name)); });
      variants.add(section + "the pair itself",
                   true,
                   {section + "Slave="},
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
      add_displacements(
        "Rotation z",
        [](auto &boundary) -> auto & { return boundary.rotation[2]; },
        variants);
      add_groups(
        "Moment z",
        [](auto &boundary) -> auto & { return boundary.moment[2]; },
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



    void add_thermal_strains(Variants &variants)
    {
      for (const auto &strain : variants.scene.solids.thermal_strain)
        {
          const auto others =
            without(strain.first, variants.scene.solids.thermal_strain);
          variants.add("thermal strain of " + strain.first,
                       true,
                       {entry_of("Solids/Thermal strain", others)},
                       [&](All &changed) {
                         changed.solids.thermal_strain = others;
                       });
        }
    }



    /// The elastic body instead of another one: what only that one has goes,
    /// but for the yield stress, which is a mere check then.
    void add_elastic(const std::string &effect,
                     const std::string &body,
                     Variants          &variants)
    {
      const Parameters::Solids &here   = variants.scene.solids;
      Parameters::Solids        solids = here;
      std::vector<std::string>  entries;
      const auto remove = [&](auto &values, const std::string &entry) {
        if (values.erase(body) > 0)
          entries.push_back(entry_of("Solids/" + entry, values));
      };
      remove(solids.material, "Material");
      remove(solids.hardening_modulus, "Hardening modulus");
      remove(solids.kinematic_hardening_modulus, "Kinematic hardening modulus");
      remove(solids.saturation_stress, "Saturation stress");
      remove(solids.saturation_rate, "Saturation rate");
      remove(solids.hardening_curve, "Hardening curve");
      remove(solids.mooney_rivlin_constant, "Mooney-Rivlin constant");
      variants.add(effect + " of " + body, true, entries, [&](All &changed) {
        changed.solids = solids;
      });
    }



    /// A yield stress of an elastic body asks how much it would change to
    /// yield there. Its cells are then those that plastic strains, which keep
    /// the volume, do not lock.
    void add_inelastic(Variants &variants)
    {
      using Parameters::MaterialModel;
      const Parameters::Solids &here = variants.scene.solids;
      for (const auto &[body, model] : here.material)
        if (model == MaterialModel::elastic_plastic)
          add_elastic("plasticity", body, variants);
        else if (model != MaterialModel::elastic)
          add_elastic(model.name() + " material", body, variants);
      for (const auto &of_body : here.yield_stress)
        {
          const std::string body = of_body.first;
          if (here.model_of(body) != MaterialModel::elastic)
            continue;
          auto material = here.material;
          material.insert_or_assign(body, MaterialModel::elastic_plastic);
          variants.add_or_tell("plasticity of " + body,
                               false,
                               {entry_of("Solids/Material", material)},
                               [&](All &changed) {
                                 changed.solids.material = material;
                               });
        }
      for (const std::string &body : here.incompatible_modes)
        {
          auto others = here.incompatible_modes;
          others.erase(std::find(others.begin(), others.end(), body));
          variants.add(
            "incompatible modes of " + body,
            true,
            {"Solids/Incompatible modes=" + Patterns::Tools::to_string(others)},
            [&](All &changed) { changed.solids.incompatible_modes = others; });
        }
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
    add_thermal_strains(variants);
    add_inelastic(variants);
    add_materials(variants);
    return variants.all;
  }
} // namespace Contact
