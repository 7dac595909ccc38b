/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mortar_integrals_h
#define contact_mortar_integrals_h

#include <map>
#include <set>

#include "contact/mortar/mortar_segments.h"

namespace Contact
{
  using namespace dealii;

  /// The contact point of a slave node: what class MortarDiscretization
  /// describes.
  template<typename Number>
  struct MortarPairing
  {
    bool                           facing = false;
    Number                         weight = 0; // D_k [mm]; of rings, [mm^2]
    Tensor<1, 2, Number>           normal;     // n_k, or that of the slave
    std::map<unsigned int, Number> slave;      // coefficients, by node
    std::map<unsigned int, Number> master;     // likewise, negative
    Number                         excess       = 0; // of the weighted gap [mm]
    unsigned int                   master_facet = 0; // most of it
  };



  /**
   * Dual functions and integrals of the mortar discretization, in one
   * configuration; see class MortarDiscretization. Of numbers that carry
   * derivatives, the integrals do.
   */
  template<typename Number>
  class MortarIntegrals
  {
  public:
    /// By edge and node, whether it carries a multiplier.
    using Carriers = std::vector<PerEdgeNode<bool>>;

    MortarIntegrals(const MortarGeometry<Number> &geometry,
                    const Carriers               &carries);

    /// Integrate over a slave edge, for all of its nodes or for one.
    void add_edge(const unsigned int   slave_facet,
                  const MortarOverlap &overlap,
                  const unsigned int   only = numbers::invalid_unsigned_int);

    /// The contact point of a node, by what was integrated.
    MortarPairing<Number> pairing(const unsigned int node) const;

  private:
    /// Integrals over the dual function of one slave node.
    struct OfNode
    {
      Number                         weight = 0; // D_k [mm]; of rings, [mm^2]
      std::map<unsigned int, Number> slave;      // Phi_k N_a, by slave node
      std::map<unsigned int, Number> master;     // Phi_k N_m, by master node
      std::map<unsigned int, Number> shift; // Phi_k dN_m/ds, by master node

      Tensor<1, 2, Number> slave_normal, master_normal; // times Phi_k
      Number               magnitude     = 0;           // of |Phi_k|
      Number               master_turn   = 0; // |Phi_k| times the squared angle
      Number               master_square = 0; // |Phi_k| times normals squared
      Tensor<1, 2, Number> master_mean;       // |Phi_k| times normals

      std::map<unsigned int, double> master_edges; // |Phi_k|, by edge

      std::vector<Tensor<1, 2, Number>> distances; // x_slave - x_master [mm]
    };

    /// Numbers by two of the nodes of an edge.
    using Table = std::array<std::array<Number, 3>, 3>;

    /// The nodes of an edge, by their number in it, that have a dual function.
    std::vector<unsigned int>
    carrying_nodes(const unsigned int   slave_facet,
                   const MortarOverlap &overlap) const;

    /// The functions that the dual functions of these nodes are biorthogonal
    /// to.
    std::array<Number, 3> test_functions(const std::vector<unsigned int> &nodes,
                                         const EdgeShapes<Number> &shape) const;

    /// The coefficients of the dual functions of these nodes: row k holds those
    /// of 1, xi, xi^2.
    Table
    dual_functions(const std::vector<unsigned int>         &nodes,
                   const std::vector<MortarSample<Number>> &samples) const;

    void add_normals(const unsigned int          slave_facet,
                     const unsigned int          a,
                     const MortarSample<Number> &sample,
                     const Number               &phi,
                     OfNode                     &integrals) const;

    /// The direction n_k of a node.
    Tensor<1, 2, Number> direction(const unsigned int node,
                                   const OfNode      &integrals) const;

    /// By how much the weighted gap is below all distances that it is a mean
    /// of.
    Number excess(const unsigned int           node,
                  const OfNode                &integrals,
                  const MortarPairing<Number> &pairing) const;

    const MortarGeometry<Number> &now;
    const Surface<2>             &slave, &master;
    const Carriers               &carries;

    std::map<unsigned int, OfNode> of_nodes;
  };
} // namespace Contact

#endif
