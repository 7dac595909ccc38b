/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_body_results_h
#define contact_body_results_h

#include <map>
#include <string>

#include "model/contact_model.h"

namespace Contact
{
  using namespace dealii;

  /// The largest value in a body, and the centre of the undeformed cell [mm].
  template<int dim>
  struct Extreme
  {
    double     value = 0;
    Point<dim> X;
  };

  /**
   * The distance of a body from the range of its material. Of one that may
   * yield, the shares of its volume and of its surface in contact that have
   * yielded, or where von Mises' stress is above the yield stress that an
   * elastic body has as a check; of one of St. Venant and Kirchhoff the largest
   * strain, of Green and Lagrange, and the largest shortening, 1 - stretch. All
   * but the recovered stress are of the points of the quadrature, which lie
   * inside of the cells.
   */
  template<int dim>
  struct BodyResult
  {
    Extreme<dim> plastic_strain, von_mises, strain, shortening;
    Extreme<dim> recovered_von_mises; // at the vertices, of elastic bodies
    double       volume_share  = 0;
    double       contact_share = -1; // none without contact

    // The kinds of results that there are: stresses, recovered ones, strains.
    bool has_stresses = false, has_recovered = false, has_strains = false;

    /// By name; not a number where there is no value.
    std::map<std::string, double> by_name() const;
  };

  /// Of the bodies that have anything to tell, by name. The recovered stresses
  /// and plastic strains at the vertices and the forces of contact on the nodes
  /// may be empty. Collective.
  template<int dim>
  std::map<std::string, BodyResult<dim>>
  body_results(const ContactModel<dim>                  &model,
               const Parameters::Solids                 &parameters,
               const std::vector<SymmetricTensor<2, 3>> &vertex_stresses,
               const std::vector<double>                &plastic_strains,
               const GhostedVector                      &solution,
               const GhostedVector                      &contact_forces);

  /// Whether a body is compressed beyond where its law is one: where the stress
  /// of St. Venant and Kirchhoff's falls the more a body is compressed.
  template<int dim>
  bool gets_softer(const BodyResult<dim> &result);

  /// The result of a body in a line, or nothing if it is within its range.
  template<int dim>
  std::string describe(const std::string        &body,
                       const BodyResult<dim>    &result,
                       const Parameters::Solids &parameters);

  /// The same of an earlier increment, by its numbers by name, in which a body
  /// was farther from its range than in the @p last one; nothing if it was not.
  std::string describe_earlier(const std::string                   &body,
                               const double                         load_factor,
                               const std::map<std::string, double> &earlier,
                               const std::map<std::string, double> &last,
                               const Parameters::Solids            &parameters);
} // namespace Contact

#endif
