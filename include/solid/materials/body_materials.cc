/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/materials/body_materials.h"

#include "base/errors.h"
#include "solid/materials/elastic_plastic.h"
#include "solid/materials/linear_elastic.h"
#include "solid/materials/logarithmic_strain.h"
#include "solid/materials/mooney_rivlin.h"
#include "solid/materials/neo_hookean.h"

namespace Contact
{
  namespace
  {
    double value_of(const std::map<std::string, double> &values,
                    const std::string                   &body)
    {
      const auto found = values.find(body);
      return found == values.end() ? 0. : found->second;
    }



    Hardening hardening_of(const std::string        &body,
                           const Parameters::Solids &parameters)
    {
      Hardening hardening;
      hardening.initial = parameters.yield_stress.at(body);
      hardening.linear  = value_of(parameters.hardening_modulus, body);
      hardening.kinematic =
        value_of(parameters.kinematic_hardening_modulus, body);
      if (parameters.saturation_stress.count(body) > 0)
        {
          hardening.saturation =
            parameters.saturation_stress.at(body) - hardening.initial;
          hardening.rate = parameters.saturation_rate.at(body);
        }
      if (const auto curve = parameters.hardening_curve.find(body);
          curve != parameters.hardening_curve.end())
        {
          hardening.curve = {{0., hardening.initial}};
          for (unsigned int k = 0; k < curve->second.size(); k += 2)
            if (curve->second[k] > 0)
              hardening.curve.emplace_back(curve->second[k],
                                           curve->second[k + 1]);
        }
      return hardening;
    }
  } // namespace



  // Plane stress is the plane strain of another material: with
  //   nu' = nu/(1 + nu),   E' = E (1 + 2 nu)/(1 + nu)^2
  // lambda' is 2 lambda mu/(lambda + 2 mu), and mu' is mu.
  template<int dim>
  std::map<types::material_id, Material>
  find_materials(const Mesh<dim> &mesh, const Parameters::Solids &parameters)
  {
    const std::string                      entry = "Solids/Young's modulus";
    std::map<types::material_id, Material> materials;
    for (const auto &[name, E] : parameters.youngs_modulus)
      {
        const double nu = parameters.poisson.at(name);
        materials.emplace(mesh.body(name, entry),
                          parameters.symmetry ==
                              Parameters::Symmetry::plane_stress
                            ? Material(E * (1 + 2 * nu) / ((1 + nu) * (1 + nu)),
                                       nu / (1 + nu))
                            : Material(E, nu));
      }
    for (const auto &[name, body] : mesh.bodies)
      if (materials.count(body) == 0)
        throw InputError("body '" + name + "' has no material",
                         entry,
                         "add '" + name + ": <value>' to the moduli");
    return materials;
  }

  template std::map<types::material_id, Material>
  find_materials(const Mesh<2> &, const Parameters::Solids &);
  template std::map<types::material_id, Material>
  find_materials(const Mesh<3> &, const Parameters::Solids &);



  std::map<types::material_id, std::unique_ptr<MaterialLaw>>
  make_laws(const std::map<std::string, types::material_id> &bodies,
            const std::map<types::material_id, Material>    &materials,
            const Parameters::Solids                        &parameters)
  {
    std::map<types::material_id, std::unique_ptr<MaterialLaw>> laws;
    for (const auto &[name, body] : bodies)
      {
        const Material &elastic = materials.at(body);
        switch (parameters.model_of(name))
          {
            case Parameters::MaterialModel::elastic:
              laws[body] = std::make_unique<LinearElastic>(elastic);
              break;
            case Parameters::MaterialModel::elastic_plastic:
              {
                const bool is_large =
                  parameters.kinematics.of(name) == Parameters::Strains::large;
                laws[body] =
                  std::make_unique<ElasticPlastic>(elastic,
                                                   hardening_of(name,
                                                                parameters),
                                                   /*loads_on=*/is_large);
                if (is_large)
                  laws[body] =
                    std::make_unique<LogarithmicStrain>(std::move(laws[body]));
              }
              break;
            case Parameters::MaterialModel::neo_hookean:
              laws[body] = std::make_unique<NeoHookean>(elastic);
              break;
            case Parameters::MaterialModel::mooney_rivlin:
              laws[body] = std::make_unique<MooneyRivlin>(
                elastic,
                parameters.mooney_rivlin_constant.at(name));
              break;
          }
      }
    return laws;
  }



  // Plastic strains change no volume.
  std::set<types::material_id> find_projected(
    const std::map<types::material_id, Material>                     &materials,
    const std::map<types::material_id, std::unique_ptr<MaterialLaw>> &laws,
    const Parameters::Dilatation        dilatation,
    const std::set<types::material_id> &enhanced)
  {
    std::set<types::material_id> projected;
    for (const auto &[body, material] : materials)
      if (dilatation == Parameters::Dilatation::B_bar ||
          (dilatation == Parameters::Dilatation::automatic &&
           enhanced.count(body) == 0 &&
           (material.is_nearly_incompressible() ||
            laws.at(body)->n_history() > 0)))
        projected.insert(body);
    return projected;
  }
} // namespace Contact
