/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_stress_recovery_h
#define contact_stress_recovery_h

#include <deal.II/lac/full_matrix.h>

#include <functional>

#include "solid/elasticity.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Cauchy stress [MPa] at the vertices: in each cell the least-squares fit of
   * the vertex shape functions (bilinear or trilinear, linear in triangles) to
   * the values in the quadrature points, evaluated at the vertices; then the
   * mean over the cells at a vertex. With one point in a triangle the fit is
   * the constant.
   */
  template<int dim>
  class StressRecovery
  {
  public:
    StressRecovery(const Discretization<dim> &discretization);

    /// By vertex of the triangulation.
    std::vector<SymmetricTensor<2, 3>>
    vertex_stresses(const Elasticity<dim> &elasticity,
                    const GhostedVector   &u) const;

    /// The same of the equivalent plastic strain [-].
    std::vector<double> vertex_strains(const Elasticity<dim> &elasticity) const;

    /// The cells around the vertices of a place, by vertex, and the stress
    /// there by them alone. On one rank.
    using CellsOfVertices =
      std::map<unsigned int,
               std::vector<typename DoFHandler<dim>::active_cell_iterator>>;
    CellsOfVertices       cells_at(const Place<dim> &place) const;
    SymmetricTensor<2, 3> stress_at(const Place<dim>      &place,
                                    const CellsOfVertices &cells,
                                    const Elasticity<dim> &elasticity,
                                    const GhostedVector   &u) const;

  private:
    /// By vertex, of the values in the points that a function has for the
    /// index of an active cell.
    template<typename Value>
    std::vector<Value> vertex_values(
      const std::function<std::vector<Value>(unsigned int)> &values_of_cell)
      const;

    template<typename Value>
    Value at_vertex(const typename DoFHandler<dim>::active_cell_iterator &cell,
                    const unsigned int                                    v,
                    const std::vector<Value> &at_points) const;

    const Discretization<dim> &discretization;

    /// Quadrature point values -> vertex values, for each element.
    std::vector<FullMatrix<double>> fits;
  };



  /// sqrt(3/2 s : s), s the stress deviator.
  double von_mises(const SymmetricTensor<2, 3> &stress);
} // namespace Contact

#endif
