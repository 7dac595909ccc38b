/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_exact_solution_h
#define contact_exact_solution_h

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "contact/results/contact_results.h"

namespace Contact
{
  using namespace dealii;

  /// The closed form of a case; functions that it does not give are empty.
  struct ExactSolution
  {
    /// On the slave by reference position [MPa]; the shear as it acts on the
    /// slave, along the tangent of the master.
    std::function<double(const Point<2> &)> pressure, shear;

    /// In the bodies by reference position [mm, MPa].
    std::function<Tensor<1, 2>(const Point<2> &, const types::material_id)>
      displacement;
    std::function<SymmetricTensor<2, 2>(const Point<2> &,
                                        const types::material_id)>
      stress;

    /// Numbers by name: lengths in mm, stresses in MPa.
    std::map<std::string, double> values;
  };

  /**
   * The solution that the parameters ask to compare with, if they do: that of
   * Hertz (on request with friction: Cattaneo and Mindlin's for bodies of one
   * material, or that of two half planes under the same increments), or of
   * concentric cylinders. Its axis is vertical through the slave node with the
   * smallest initial gap. Where the force is not given, it is the one in @p
   * results.
   */
  std::optional<ExactSolution>
  make_exact_solution(const Parameters::All   &parameters,
                      const Discretization<2> &discretization,
                      const ContactPair<2>    &contact_pair,
                      const ContactResults    &results);

  /**
   * The errors of a solution by name, relative to the norm of the exact one,
   * as far as that is known:
   *  - "displacement", "energy": in L2 and in the norm of the energy (small
   *    strain) over all bodies;
   *  - "pressure", "shear": in L2 over the slave, the multipliers interpolated
   *    between the nodes.
   */
  std::map<std::string, double>
  solution_errors(const ExactSolution       &exact,
                  const Discretization<2>   &discretization,
                  const Elasticity<2>       &elasticity,
                  const ContactInterface<2> &interface,
                  const ContactPair<2>      &contact_pair,
                  const GhostedVector       &solution);
} // namespace Contact

#endif
