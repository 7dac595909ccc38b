/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Checks of the bodies and their materials.

#include <algorithm>

#include "base/string_utilities.h"
#include "parameters/entry_checks.h"
#include "parameters/parameters.h"

namespace Contact
{
  namespace Parameters
  {
    void Solids::check() const
    {
      const std::string E  = "Solids/Young's modulus";
      const std::string nu = "Solids/Poisson's ratio";
      check_keys(youngs_modulus, E, poisson, nu);
      check_keys(poisson, nu, youngs_modulus, E);
      if (youngs_modulus.empty())
        throw EntryError("No body has a material.",
                         {E, nu},
                         "set both, as in 'set Young's modulus = Block: "
                         "70000'");
      for (const auto &[body, value] : youngs_modulus)
        if (!(value > 0))
          throw EntryError("Young's modulus of " + in_quotes(body) +
                             " is not positive.",
                           {E},
                           "set a positive value in MPa");
      for (const auto &[body, value] : poisson)
        if (!(value > -1 && value < 0.5))
          throw EntryError("Poisson's ratio of " + in_quotes(body) +
                             " is not between -1 and 0.5.",
                           {nu},
                           "set a value greater than -1 and less than 0.5");
      check_kinematics();
      check_materials();
      check_keys(thermal_strain, "Solids/Thermal strain", youngs_modulus, E);
      for (const auto &[body, history] : thermal_strain)
        check_history(history, "Solids/Thermal strain");
      check_modes();
      if (symmetry == Symmetry::plane_stress &&
          (!is_elastic() || !kinematics.all_are(Strains::small) ||
           !thermal_strain.empty()))
        throw EntryError("Plane stress is that of elastic bodies in small "
                         "strain, without thermal strains.",
                         {"Solids/Symmetry"},
                         "set 'Kinematics = small strain', which follows "
                         "contact on deformed surfaces as well, or mesh the "
                         "body as a plate in 3-D");
    }



    void Solids::check_modes() const
    {
      const std::string entry = "Solids/Incompatible modes";
      for (const std::string &body : incompatible_modes)
        {
          if (youngs_modulus.count(body) == 0)
            throw EntryError("There is no body " + in_quotes(body) + ".",
                             {entry, "Solids/Young's modulus"},
                             "name bodies that have a material");
          if (model_of(body) != MaterialModel::elastic)
            throw EntryError("There are no incompatible modes of the " +
                               material.at(body).name() + ' ' +
                               in_quotes(body) + ".",
                             {entry, "Solids/Material"},
                             "remove it from " + entry +
                               ", where B-bar or degree 2 serve instead");
          if (dilatation == Dilatation::B_bar)
            throw EntryError("Cells with incompatible modes have no B-bar.",
                             {entry, "Solids/Dilatation"},
                             "set 'Dilatation = automatic', which leaves them "
                             "out");
        }
    }



    void Solids::check_kinematics() const
    {
      const std::string entry = "Solids/Kinematics";
      if (!kinematics.is_allowed())
        throw EntryError(in_quotes(kinematics.name()) + " is not allowed for " +
                           entry + ".",
                         {entry},
                         "set one of " + Choice<Strains>::names(", ") +
                           ", or 'body: kinematics' for each body");
      if (kinematics.by_body().empty())
        return;
      const std::string E = "Solids/Young's modulus";
      check_keys(kinematics.by_body(), entry, youngs_modulus, E);
      check_keys(youngs_modulus, E, kinematics.by_body(), entry);
    }



    bool Solids::is_elastic() const
    {
      return std::all_of(material.begin(), material.end(), [](const auto &of) {
        return of.second == MaterialModel::elastic;
      });
    }



    bool Solids::may_yield() const
    {
      return std::any_of(material.begin(), material.end(), [](const auto &of) {
        return of.second == MaterialModel::elastic_plastic;
      });
    }



    void Solids::check_materials() const
    {
      const std::string E = "Solids/Young's modulus", M = "Solids/Material",
                        Y  = "Solids/Yield stress",
                        C  = "Solids/Mooney-Rivlin constant";
      const auto is_rubber = [](const MaterialModel model) {
        return model == MaterialModel::neo_hookean ||
               model == MaterialModel::mooney_rivlin;
      };
      check_keys(material, M, youngs_modulus, E);
      check_keys(yield_stress, Y, youngs_modulus, E);
      const auto check_constants = [&](const auto        &constants,
                                       const std::string &entry) {
        for (const auto &[body, value] : constants)
          if (model_of(body) != MaterialModel::elastic_plastic)
            throw EntryError(in_quotes(body) + " is in " + entry +
                               ", but not elastic-plastic.",
                             {entry, M},
                             "add '" + body + ": elastic-plastic' to " + M +
                               ", or remove it from " + entry);
      };
      check_constants(hardening_modulus, "Solids/Hardening modulus");
      check_constants(kinematic_hardening_modulus,
                      "Solids/Kinematic hardening modulus");
      check_constants(saturation_stress, "Solids/Saturation stress");
      check_constants(saturation_rate, "Solids/Saturation rate");
      check_constants(hardening_curve, "Solids/Hardening curve");
      for (const auto &[body, stress] : yield_stress)
        {
          check_positive(stress, Y);
          if (is_rubber(model_of(body)))
            throw EntryError("The " + material.at(body).name() + ' ' +
                               in_quotes(body) + " does not yield.",
                             {Y, M},
                             "remove it from " + Y);
        }
      for (const auto &[body, constant] : mooney_rivlin_constant)
        {
          if (model_of(body) != MaterialModel::mooney_rivlin)
            throw EntryError(in_quotes(body) + " is in " + C +
                               ", but not Mooney-Rivlin.",
                             {C, M},
                             "add '" + body + ": Mooney-Rivlin' to " + M +
                               ", or remove it from " + C);
          const double half =
            youngs_modulus.at(body) / (4 * (1 + poisson.at(body)));
          if (!(constant >= 0 && constant <= half))
            throw EntryError("C01 of " + in_quotes(body) +
                               " is not between 0 and half the shear modulus.",
                             {C, "Solids/Young's modulus"},
                             "set 0 (neo-Hookean) to " + brief(half) + " MPa");
        }
      for (const auto &[body, model] : material)
        {
          if (model == MaterialModel::elastic)
            continue;
          const Choice<Strains> large(Strains::large);
          if (is_rubber(model) && kinematics.of(body) != large)
            throw EntryError("The material " + model.name() + " of " +
                               in_quotes(body) + " is one of " + large.name() +
                               ".",
                             {M, "Solids/Kinematics"},
                             "set 'Kinematics = " + large.name() +
                               "', or 'Kinematics = " + body + ": " +
                               large.name() + ", ...' with all bodies");
          if (model == MaterialModel::elastic_plastic)
            {
              check_hardening(body);
              if (kinematics.of(body) == large &&
                  thermal_strain.count(body) > 0)
                throw EntryError("There is no thermal strain of the "
                                 "elastic-plastic " +
                                   in_quotes(body) + " in " + large.name() +
                                   ".",
                                 {"Solids/Thermal strain", "Solids/Kinematics"},
                                 "set 'Kinematics = small strain' of it, or "
                                 "take it out of Thermal strain");
            }
          if (model == MaterialModel::mooney_rivlin &&
              mooney_rivlin_constant.count(body) == 0)
            throw EntryError("The Mooney-Rivlin " + in_quotes(body) +
                               " has no constant.",
                             {C, M},
                             "add '" + body + ": <C01>' to " + C);
        }
    }



    // The yield stress never falls: the return to it is unique.
    void Solids::check_hardening(const std::string &body) const
    {
      const std::string Y = "Solids/Yield stress",
                        S = "Solids/Saturation stress",
                        r = "Solids/Saturation rate",
                        C = "Solids/Hardening curve";
      if (yield_stress.count(body) == 0)
        throw EntryError("The elastic-plastic " + in_quotes(body) +
                           " has no yield stress.",
                         {Y, "Solids/Material"},
                         "add '" + body + ": <stress>' to " + Y);
      for (const auto &[moduli, entry] :
           {std::make_pair(&hardening_modulus, "Solids/Hardening modulus"),
            std::make_pair(&kinematic_hardening_modulus,
                           "Solids/Kinematic hardening modulus")})
        if (moduli->count(body) > 0 && !(moduli->at(body) >= 0))
          throw EntryError(std::string(entry) + " of " + in_quotes(body) +
                             " is negative.",
                           {entry},
                           "set 0 or more");
      check_keys(saturation_stress, S, saturation_rate, r);
      check_keys(saturation_rate, r, saturation_stress, S);
      double stress = yield_stress.at(body);
      if (saturation_stress.count(body) > 0)
        {
          check_positive(saturation_rate.at(body), r);
          if (!(saturation_stress.at(body) >= stress))
            throw EntryError("The saturation stress of " + in_quotes(body) +
                               " is below its yield stress.",
                             {S, Y},
                             "set no less than the yield stress");
        }
      if (hardening_curve.count(body) == 0)
        return;
      if (hardening_modulus.count(body) + saturation_stress.count(body) > 0)
        throw EntryError(in_quotes(body) +
                           " has a hardening curve and other hardening.",
                         {C, S, "Solids/Hardening modulus"},
                         "keep one of them");
      const auto &curve  = hardening_curve.at(body);
      double      strain = 0;
      bool        grows  = curve.size() % 2 == 0;
      const bool  begins_with_yield_stress =
        curve.size() > 1 && curve[0] == 0 && curve[1] == stress;
      for (unsigned int k = begins_with_yield_stress ? 2 : 0;
           grows && k < curve.size();
           k += 2)
        {
          grows  = curve[k] > strain && curve[k + 1] >= stress;
          strain = curve[k];
          stress = curve[k + 1];
        }
      if (!grows)
        throw EntryError("The hardening curve of " + in_quotes(body) +
                           " is not one of pairs of a growing plastic strain "
                           "and a stress that does not fall.",
                         {C, Y},
                         "set pairs 'plastic strain, stress' beyond 0 and the "
                         "yield stress; 0 and the yield stress itself may come "
                         "first");
    }
  } // namespace Parameters
} // namespace Contact
