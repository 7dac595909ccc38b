/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Two blocks in a given configuration, and the profiles of their surfaces.

#ifndef contact_tests_postprocessing_h
#define contact_tests_postprocessing_h

#include "output/profile.h"
#include "tests.h"

namespace Tests
{
  using Stresses = std::vector<SymmetricTensor<2, 3>>;
  using Rows     = std::vector<ProfileRow<2>>;

  /// Each block has one cell cut into triangles; the wide lower one has other
  /// nodes than the upper one. The upper one may bulge towards x = 2/3.
  inline Parameters::All two_blocks(const unsigned int degree,
                                    const std::string &rule,
                                    const bool         wide  = false,
                                    const double       bulge = 0)
  {
    const auto cut = [](const unsigned int i, const unsigned int j) {
      return i == 1 && j == 0;
    };
    const auto upper = [=](const double s, const double t) {
      return Point<2>(2 * s, t + bulge * std::pow(2 * s - 2. / 3, 2));
    };
    MeshText mesh;
    if (wide)
      mesh.block("lower", 7, 2, rectangle({-1, -1}, {4, 0}), cut);
    else
      mesh.block("lower", 3, 2, rectangle({0, -1}, {2, 0}), cut);
    mesh.block("upper", 3, 2, upper, cut);

    auto parameters =
      make_parameters(mesh, {"lower", "upper"}, degree, "small strain");
    parameters.contact.slave          = "upper bottom";
    parameters.contact.master         = "lower top";
    parameters.contact.discretization = rule;
    return parameters;
  }



  /// A model in a given configuration, paired.
  struct PlacedModel : public TwoBodies
  {
    PlacedModel(const Parameters::All                           &parameters,
                const std::function<Point<2>(const Point<2> &)> &position)
      : TwoBodies(parameters)
    {
      const GhostedVector u = displacement(position);
      std::copy(u.begin(), u.end(), solution.begin());
      interface.pair(solution);
    }
  };



  /// The profiles of slave and master.
  inline std::array<Rows, 2> profiles(const TwoBodies &model,
                                      const Stresses  &stresses)
  {
    const auto &disc  = model.discretization;
    const Rows  slave = slave_profile(model.interface,
                                     *model.interface.pairs[0],
                                     disc,
                                     stresses,
                                     model.solution,
                                     model.start);
    return {{slave,
             master_profile(model.interface,
                            *model.interface.pairs[0],
                            disc,
                            stresses,
                            model.solution,
                            slave)}};
  }
} // namespace Tests

#endif
