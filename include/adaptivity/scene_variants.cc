/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/scene_variants.h"

#include <algorithm>

#include "adaptivity/variant_list.h"
#include "probes/traction_probes.h"

namespace Contact
{
  Parameters::Probes without_tractions(const Parameters::Probes &probes)
  {
    Parameters::Probes left = probes;
    for (const auto &[name, probe] : probes.definitions())
      if (is_contact_traction(probe.quantity))
        {
          left.probes.erase(name);
          left.references.erase(name);
          left.tolerances.erase(name);
          left.accuracy.erase(name);
        }
    return left;
  }



  namespace
  {
    using Parameters::All;

    void add_kinematics(Variants &variants)
    {
      using Parameters::GeometryLoop;
      using Parameters::Strains;
      const All &scene    = variants.scene;
      const bool is_large = !scene.solids.kinematics.all_are(Strains::small);
      const std::string frozen    = "Solution/Geometry=undeformed";
      const std::string following = "Solution/Geometry=automatic";

      if (is_large)
        variants.add("large displacement",
                     true,
                     {"Solids/Kinematics=small strain", frozen});
      else
        variants.add("large displacement",
                     false,
                     {"Solids/Kinematics=large displacement", following});
      if (is_large || scene.pairs().empty())
        return;
      const bool follows = scene.solution.geometry != GeometryLoop::undeformed;
      variants.add("contact of deformed surfaces",
                   follows,
                   {follows ? frozen : following});
    }



    /// The scene without a contact pair. Without contact no point has a
    /// traction: the entries are those of a run without such probes.
    void add_pair_itself(const std::string &section, Variants &variants)
    {
      variants.add(section + "the pair itself", true, {section + "Slave="});
      if (variants.all.empty() ||
          variants.all.back().entries.front() != section + "Slave=")
        return;
      const Parameters::Probes left = without_tractions(variants.scene.probes);
      std::string              probes;
      for (const auto &[name, probe] : left.definitions())
        {
          probes +=
            (probes.empty() ? "" : "; ") + name + ": " + probe.quantity.name();
          for (const std::string &place : probe.places)
            probes += ", " + place;
        }
      if (left.probes.size() < variants.scene.probes.probes.size())
        for (const std::string &entry :
             {"Probes/Probes=" + probes,
              entry_of("Probes/References", left.references),
              entry_of("Probes/Tolerances", left.tolerances),
              "Probes/Accuracy=" + Patterns::Tools::to_string(left.accuracy)})
          variants.all.back().entries.push_back(entry);
    }



    void add_pair(const Parameters::Contact &of_pair, Variants &variants)
    {
      const std::string        section = of_pair.section() + "/";
      std::vector<std::string> no_friction{section + "Friction coefficient=0",
                                           section + "Tresca limit=0"};
      if (!of_pair.elastic_slip.empty())
        {
          no_friction.push_back(section + "Elastic slip=");
          variants.add(section + "elastic slip", true, {no_friction.back()});
        }
      if (of_pair.tied)
        variants.add(section + "glue", true, {section + "Tied=false"});
      else
        {
          if (of_pair.frictional())
            variants.add(section + "friction", true, no_friction);
          else
            variants.add(section + "friction 0.1",
                         false,
                         {section + "Friction coefficient=0.1"});
          std::vector<std::string> glue = no_friction;
          glue.insert(glue.begin(), section + "Tied=true");
          variants.add(section + "glue", false, glue);
        }
      if (!of_pair.interference.empty())
        variants.add(section + "interference",
                     true,
                     {section + "Interference="});
      if (!of_pair.preload.empty())
        variants.add(section + "preload", true, {section + "Preload="});
      if (!of_pair.obstacle_motion.empty())
        variants.add(section + "obstacle motion",
                     true,
                     {section + "Obstacle motion=",
                      section + "Obstacle centre=",
                      section + "Obstacle axis="});
      add_pair_itself(section, variants);
    }



    using Parameters::Boundary;

    /// An entry of the boundary conditions without one of its groups; a history
    /// of nothing goes, too.
    template<typename Groups>
    void add_without(const std::string &entry,
                     const std::string &group,
                     const Groups      &others,
                     Variants          &variants)
    {
      const std::string        section   = "Boundary conditions/";
      std::vector<std::string> entries   = {entry_of(section + entry, others)};
      auto                     histories = variants.scene.boundary.histories;
      if (others.empty() && histories.erase(entry) > 0)
        entries.push_back(entry_of(section + "Histories", histories));
      variants.add(entry + " of " + group, true, entries);
    }



    /// Each group of an entry of loads.
    template<typename Groups>
    void add_groups(const std::string &entry,
                    const Groups      &values,
                    Variants          &variants)
    {
      for (const auto &of_group : values)
        add_without(entry,
                    of_group.first,
                    without(of_group.first, values),
                    variants);
    }



    /// Each support that moves: it rests.
    void add_displacements(const std::string                   &entry,
                           const std::map<std::string, double> &values,
                           Variants                            &variants)
    {
      for (const auto &[group, value] : values)
        if (value != 0)
          {
            auto others   = values;
            others[group] = 0;
            add_without(entry, group, others, variants);
          }
    }



    void add_loads(Variants &variants)
    {
      const Boundary &boundary       = variants.scene.boundary;
      const auto      for_directions = [&](const std::string &entry,
                                      const auto        &values) {
        for (unsigned int c = 0; c < 3; ++c)
          add_groups(entry + ' ' + "xyz"[c], values[c], variants);
      };
      for (unsigned int c = 0; c < 3; ++c)
        {
          add_displacements(std::string("Displacement ") + "xyz"[c],
                            boundary.displacement[c],
                            variants);
          add_displacements(std::string("Rotation ") + "xyz"[c],
                            boundary.rotation[c],
                            variants);
          add_groups(std::string("Moment ") + "xyz"[c],
                     boundary.moment[c],
                     variants);
        }
      add_displacements("Displacement normal",
                        boundary.displacement_normal,
                        variants);
      for_directions("Force", boundary.force);
      for_directions("Resultant force", boundary.resultant_force);
      add_groups("Pressure", boundary.pressure, variants);
      for_directions("Traction", boundary.traction);
      for_directions("Body force", boundary.body_force);
    }



    void add_thermal_strains(Variants &variants)
    {
      const auto &strains = variants.scene.solids.thermal_strain;
      for (const auto &strain : strains)
        variants.add("thermal strain of " + strain.first,
                     true,
                     {entry_of("Solids/Thermal strain",
                               without(strain.first, strains))});
    }



    /// The elastic body instead of another one: what only that one has goes,
    /// but for the yield stress, which is a mere check then.
    void add_elastic(const std::string &effect,
                     const std::string &body,
                     Variants          &variants)
    {
      const Parameters::Solids &solids = variants.scene.solids;
      std::vector<std::string>  entries;

      const auto remove = [&](const std::string &entry, const auto &values) {
        if (values.count(body) > 0)
          entries.push_back(entry_of("Solids/" + entry, without(body, values)));
      };
      remove("Material", solids.material);
      remove("Hardening modulus", solids.hardening_modulus);
      remove("Kinematic hardening modulus", solids.kinematic_hardening_modulus);
      remove("Saturation stress", solids.saturation_stress);
      remove("Saturation rate", solids.saturation_rate);
      remove("Hardening curve", solids.hardening_curve);
      remove("Mooney-Rivlin constant", solids.mooney_rivlin_constant);
      variants.add(effect + " of " + body, true, entries);
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
                               {entry_of("Solids/Material", material)});
        }
      for (const std::string &body : here.incompatible_modes)
        {
          auto others = here.incompatible_modes;
          others.erase(std::find(others.begin(), others.end(), body));
          variants.add("incompatible modes of " + body,
                       true,
                       {"Solids/Incompatible modes=" +
                        Patterns::Tools::to_string(others)});
        }
    }



    void add_materials(Variants &variants)
    {
      const auto &moduli = variants.scene.solids.youngs_modulus;
      for (const auto &of_body : moduli)
        {
          auto stiffer = moduli;
          stiffer[of_body.first] *= 1.01;
          variants.add("Young's modulus of " + of_body.first + " + 1 %",
                       false,
                       {entry_of("Solids/Young's modulus", stiffer)});
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



  SceneVariant quadratic_elements(const Parameters::All &scene)
  {
    SceneVariant variant{"quadratic elements",
                         false,
                         {"Element/Degree=2"},
                         scene};
    variant.parameters.element.degree = 2;
    if (!scene.solids.incompatible_modes.empty())
      variant.entries.push_back("Solids/Incompatible modes=");
    variant.parameters.solids.incompatible_modes.clear();
    return variant;
  }



  SceneVariant doubled_increments(const Parameters::All &scene)
  {
    const auto   increments = scene.solution.increments.doubled();
    SceneVariant variant{"increments doubled",
                         false,
                         {"Solution/Increments=" + increments.text()},
                         scene};
    variant.parameters.solution.increments = increments;
    return variant;
  }
} // namespace Contact
