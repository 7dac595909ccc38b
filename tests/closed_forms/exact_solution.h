/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_tests_exact_solution_h
#define contact_tests_exact_solution_h

#include "contact/results/contact_results.h"
#include "tests.h"

namespace Tests
{
  /**
   * A closed form by name, and its numbers:
   *  - "Hertz": line contact, {radius [mm], force per length of the full
   *    cylinder [N/mm]} or {radius}: under the force that is found;
   *  - "Hertz with friction": likewise, with the shear: Cattaneo and Mindlin's
   *    for bodies of one material, otherwise that of two half planes under the
   *    same increments; right only if the contact is small beside the radius;
   *  - "concentric cylinders" about the origin: {bore, radius of contact, outer
   *    radius [mm], p, alpha [MPa]} under p + alpha cos(2 theta) outside.
   */
  struct ClosedForm
  {
    std::string         name;
    std::vector<double> numbers;
  };



  /// The solution of a case; functions that its closed form does not give are
  /// empty.
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

  /// The axis of line contact is vertical through the slave node with the
  /// smallest initial gap; forces that are not given are those in @p results.
  ExactSolution exact_solution(const ClosedForm      &form,
                               const Parameters::All &parameters,
                               const TwoBodies       &model,
                               const ContactResults  &results = {});

  /// The tractions at the nodes of a slave, from one end to the other.
  struct SlaveTractions
  {
    unsigned int          degree;
    std::vector<Point<2>> X;
    std::vector<double>   pressure, shear;
  };

  /**
   * The errors of a solution by name, relative to the norm of the exact one,
   * as far as that is known:
   *  - "displacement", "energy": in L2 and in the norm of the energy (small
   *    strain) over all bodies;
   *  - "pressure", "shear": in L2 over the slave.
   */
  std::map<std::string, double> solution_errors(const ExactSolution  &exact,
                                                const TwoBodies      &model,
                                                const SlaveTractions &slave);
} // namespace Tests

#endif
