/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that no status of a contact point follows from round-off: an open
// point does not close by the pressure that the round-off of its gap is, and
// does by more; a slipping point goes on where its shear is its bound but for
// round-off, and sticks where it is less, or turns round.

#include "tests.h"

using namespace Tests;

namespace
{
  Parameters::All make_case()
  {
    MeshText mesh;
    mesh.block("lower", 5, 2, rectangle({0, -1}, {2.5, 0}));
    mesh.block("upper", 3, 2, rectangle({0.2, 0}, {1.8, 1}));
    Parameters::All parameters =
      make_parameters(mesh, {"lower", "upper"}, 1, "large displacement");
    parameters.contact.slave                = "upper bottom";
    parameters.contact.master               = "lower top";
    parameters.contact.discretization       = "nodal";
    parameters.contact.friction_coefficient = 0.2;
    parameters.boundary.displacement[0]     = {{"lower bottom", 0},
                                               {"upper top", 0}};
    parameters.boundary.displacement[1]     = {{"lower bottom", 0},
                                               {"upper top", -0.05}};
    return parameters;
  }



  std::string name(const PointStatus<2> &status)
  {
    if (status.kind == Status::open)
      return "open";
    return status.kind == Status::stick
             ? "sticks"
             : "slips " + std::to_string(status.slip_direction);
  }
} // namespace



int main()
{
  TwoBodies model(make_case());
  model.pair();
  const ContactPoint<2> &point      = model.interface.points()[1];
  const auto            &active_set = model.interface.active_set;

  headline("open, under a pressure by that of the round-off of its gap");
  const double smallest = std::numeric_limits<double>::epsilon() *
                          point.X(0).norm() * point.augmentation_parameter;
  for (const int part : {-1, 0, 1, 10000})
    std::cout << "  " << part << ": "
              << name(active_set.updated_status(point,
                                                PointStatus<2>(),
                                                part * smallest,
                                                Tensor<1, 1>()))
              << std::endl;

  headline("slips, under a shear by its bound");
  const std::pair<std::string, double> shears[] = {{"-1/2", -0.5},
                                                   {"1/2", 0.5},
                                                   {"1 - 1e-12", 1 - 1e-12},
                                                   {"1", 1.},
                                                   {"2", 2.}};
  const double                         p        = 10;
  for (const auto &[what, part] : shears)
    std::cout << "  " << what << ": "
              << name(active_set.updated_status(point,
                                                {Status::slip, 1},
                                                p,
                                                Tensor<1, 1>({0.2 * p * part})))
              << std::endl;
  return 0;
}
