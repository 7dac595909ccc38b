/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mortar_geometry_h
#define contact_mortar_geometry_h

#include <deal.II/base/tensor.h>
#include <deal.II/differentiation/ad/sacado_math.h>
#include <deal.II/differentiation/ad/sacado_product_types.h>

#ifndef DEAL_II_TRILINOS_WITH_SACADO
#  error "deal.II is built without Sacado: install Debian's libdeal.ii-dev."
#endif
#include <Sacado.hpp>
#include <map>
#include <set>
#include <vector>

#include "contact/surfaces/surface.h"

namespace Contact
{
  using namespace dealii;

  /// A number that carries its derivatives with respect to some unknowns along.
  using WithDerivatives = Sacado::Fad::DFad<double>;

  inline double value_of(const double x)
  {
    return x;
  }

  inline double value_of(const WithDerivatives &x)
  {
    return x.val();
  }

  template<typename Number>
  Tensor<1, 2> value_of(const Tensor<1, 2, Number> &x)
  {
    return Tensor<1, 2>({value_of(x[0]), value_of(x[1])});
  }

  template<typename Number>
  Number length(const Tensor<1, 2, Number> &a)
  {
    using std::sqrt;
    return sqrt(a * a);
  }



  /**
   * Slave and master in one configuration, and the projection between them:
   * along the normal field of the slave, which is continuous but at corners.
   * There each edge has its own normal; elsewhere the normals of the nodes are
   * the means of those of both edges, interpolated. On a symmetry line the
   * normal is along the line, as the mean with the mirror image of the edge is.
   *
   * Of numbers that carry derivatives, those with respect to the positions of
   * some nodes at a time: follow().
   */
  template<typename Number>
  class MortarGeometry
  {
  public:
    /// In the configuration @p u. The surfaces have to outlive the object.
    MortarGeometry(const Surface<2>           &slave,
                   const Surface<2>           &master,
                   const DiscretizedBodies<2> &discretization,
                   const GhostedVector        &u);

    /**
     * Take derivatives with respect to the positions of these nodes, and to
     * nothing else: two unknowns each, those of the slave first.
     */
    void follow(const std::set<unsigned int> &slave_nodes,
                const std::set<unsigned int> &master_nodes);

    /// A point of an edge, or its derivative along the edge.
    template<typename Shape>
    static Tensor<1, 2, Number>
    at(const std::vector<Tensor<1, 2, Number>> &values,
       const SurfaceFacet<2>                   &edge,
       const std::array<Shape, 3>              &shape)
    {
      // A shape function that an edge of degree 1 does not have is zero, and so
      // is the number of its node.
      Tensor<1, 2, Number> sum;
      for (unsigned int a = 0; a < 3; ++a)
        sum += shape[a] * values[edge.nodes[a]];
      return sum;
    }

    template<typename Shape>
    Tensor<1, 2, Number> slave_normal(const unsigned int          slave_facet,
                                      const std::array<Shape, 3> &shape) const
    {
      Tensor<1, 2, Number> sum;
      for (unsigned int a = 0; a < slave.n_nodes_per_edge(); ++a)
        sum += shape[a] * slave_normals[slave_facet][a];
      return sum;
    }

    /// A normal of the node @p a of a slave edge, normalized, and along the
    /// line on a symmetry line.
    Tensor<1, 2, Number> symmetric(const Tensor<1, 2, Number> &normal,
                                   const unsigned int          edge,
                                   const unsigned int          a) const;

    /// The coordinate at which the line through @p x along @p n meets a master
    /// edge, perhaps beyond its ends.
    Number projection_on_edge(const Tensor<1, 2, Number> &x,
                              const Tensor<1, 2, Number> &n,
                              const unsigned int          master_facet) const;

    /// The slave coordinate from where the normal meets the point @p x.
    Number slave_coordinate(const unsigned int          slave_facet,
                            const Tensor<1, 2, Number> &x) const;

    const Surface<2> &slave, &master;

    std::vector<Tensor<1, 2, Number>> slave_x, master_x; // of the nodes [mm]

    using Normals = std::vector<PerEdgeNode<Tensor<1, 2, Number>>>;

    /// By edge and node, out of the master: of the slave those that it is
    /// projected along.
    Normals slave_normals, master_normals;

  private:
    void find_symmetry_lines();
    void find_slave_normals(const unsigned int edge);
    void find_master_normals(const unsigned int edge);

    /// The edges whose normals depend on a node.
    static std::set<unsigned int>
    edges_around(const Surface<2>             &surface,
                 const std::set<unsigned int> &nodes);

    const DiscretizedBodies<2> &discretization;

    // By the slave edges that end on symmetry lines, and their node there: the
    // direction of the line.
    std::map<std::pair<unsigned int, unsigned int>, Tensor<1, 2>>
      symmetry_lines;

    // The nodes and edges that carry derivatives.
    std::set<unsigned int> followed_slave_nodes, followed_master_nodes;
    std::set<unsigned int> followed_slave_edges, followed_master_edges;
  };
} // namespace Contact

#endif
