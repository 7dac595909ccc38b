/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Proves that two blocks whose meshes do not match, refined locally so that
// both contact surfaces have hanging nodes, pass a uniform pressure to 1e-10
// with the mortar discretization: with elements of 8, 20 and 27 nodes, by one
// level with either side as slave, and by two; and that the weights of all
// points are positive and sum up to the area. The estimated error vanishes.

#include "adaptivity/error_estimator.h"
#include "adaptivity/refinement.h"
#include "condensed_model.h"
#include "error_indicators.h"
#include "volume_mesh.h"

using namespace Tests;

namespace
{
  const double pressure = 10, poisson = 0.3;

  struct Element
  {
    unsigned int degree;
    std::string  centre_node;
    std::string  name;
  };



  Parameters::All blocks(const Element &element, const bool low_is_slave)
  {
    VolumeText mesh;
    mesh.block("Low", {{3, 3, 2}}, box({0, 0, -1}, {1, 1, 0}));
    mesh.block("Up", {{2, 2, 2}}, box({0, 0, 0}, {1, 1, 1}));
    mesh.write("volume.msh");

    Parameters::All parameters;
    parameters.mesh.file           = "volume.msh";
    parameters.element.degree      = element.degree;
    parameters.element.centre_node = element.centre_node;
    parameters.solids.kinematics   = Parameters::Strains::small;
    for (const std::string body : {"Low", "Up"})
      {
        parameters.solids.youngs_modulus[body]               = youngs_modulus;
        parameters.solids.poisson[body]                      = poisson;
        parameters.boundary.displacement[0][body + " left"]  = 0;
        parameters.boundary.displacement[1][body + " front"] = 0;
      }
    parameters.boundary.displacement[2]["Low bottom"] = 0;
    parameters.boundary.pressure["Up top"] = std::to_string(pressure);
    parameters.contact.slave          = low_is_slave ? "Low top" : "Up bottom";
    parameters.contact.master         = low_is_slave ? "Up bottom" : "Low top";
    parameters.contact.discretization = "mortar";
    return parameters.for_space();
  }



  unsigned int n_hanging(const Surface<3> &surface)
  {
    unsigned int n = 0;
    for (const auto &parents : surface.parents)
      n += !parents.empty();
    return n;
  }



  /// The largest distance from the uniaxial state, by its displacement.
  double displacement_error(const CondensedModelIn<3> &model)
  {
    const auto   points     = model.support_points();
    const auto   components = model.components();
    const double strain     = pressure / youngs_modulus;
    double       error      = 0;
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        const double x = points[i][components[i]];
        const double exact =
          components[i] == 2 ? -strain * (x + 1) : poisson * strain * x;
        error = std::max(error, std::abs(model.solution[i] - exact));
      }
    return error / strain;
  }



  void check_patch(const Element     &element,
                   const bool         low_is_slave,
                   const unsigned int n_levels)
  {
    std::cout << element.name << ", " << (low_is_slave ? "lower" : "upper")
              << " block as slave, levels: " << n_levels << std::endl;
    const auto          parameters = blocks(element, low_is_slave);
    CondensedModelIn<3> model(parameters);
    for (unsigned int level = 0; level < n_levels; ++level)
      {
        const double radius = level == 0 ? 0.5 : 0.3;
        for (const auto &cell :
             model.mesh.triangulation.active_cell_iterators())
          if (cell->center().distance({0.2, 0.3, 0}) < radius)
            cell->set_refine_flag();
        std::vector<GhostedVector> none;
        refine_and_transfer(model.mesh, model.discretization, none);
      }
    model.make_anew(parameters, GhostedVector(model.n_dofs()));
    check("converges", model.solve(1));

    const ContactPair<3> &contact_pair = *model.interface->pairs[0];
    check("hanging nodes on both surfaces",
          n_hanging(contact_pair.slave) > 0 &&
            n_hanging(*contact_pair.master) > 0);
    double error = 0, area = 0, smallest = 1;
    for (const ContactPoint<3> &point : model.interface->points())
      {
        const double p =
          model.solution[model.interface->normal_index(point.multipliers[0])];
        error = std::max(error, std::abs(p / pressure - 1));
        area += point.weight;
        smallest = std::min(smallest, point.weight);
      }
    check_small("pressure", error, 1e-10);
    check_small("displacement", displacement_error(model), 1e-10);
    check_small("area", std::abs(area - 1), 1e-12);
    check("positive weights", smallest > 0);

    const auto stresses = StressRecovery<3>(model.discretization)
                            .vertex_stresses(*model.elasticity, model.solution);
    const ErrorEstimator<3> estimator(model.discretization, *model.elasticity);
    const auto estimate = [&](const ContactInterface<3> *interface) {
      return sum(estimator.indicators(stresses, interface, model.solution));
    };
    const double energy = pressure * pressure / youngs_modulus;
    check_small("estimated error",
                estimate(model.interface.get()) / energy,
                1e-18);
    check("without the pressure it does not vanish",
          estimate(nullptr) > 1e-3 * energy);
  }
} // namespace



int main()
{
  const Element linear{1, "free", "8 nodes"},
    serendipity{2, "serendipity", "20 nodes"}, quadratic{2, "free", "27 nodes"};
  for (const Element &element : {linear, serendipity, quadratic})
    for (const bool low_is_slave : {true, false})
      check_patch(element, low_is_slave, /*n_levels=*/1);
  check_patch(linear, /*low_is_slave=*/true, /*n_levels=*/2);
  check_patch(serendipity, /*low_is_slave=*/false, /*n_levels=*/2);
  check_patch(quadratic, /*low_is_slave=*/true, /*n_levels=*/2);
  return 0;
}
