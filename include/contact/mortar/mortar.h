/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mortar_h
#define contact_mortar_h

#include <deal.II/base/array_view.h>

#include "contact/mortar/mortar_integrals.h"
#include "contact/points/contact_points.h"
#include "contact/surfaces/body_overlap.h"

namespace Contact
{
  using namespace dealii;

  template<int dim>
  class MortarDiscretization;



  /**
   * The mortar discretization: one contact point per slave node, whose gap is
   * weighted along the surface by a dual function Phi_k of the node,
   *   g_k = n_k . integral Phi_k (x_slave - x_master) ds / D_k,
   * D_k = integral Phi_k ds, x_master being the point of the master that the
   * slave's normal meets. The pressure is p = sum_k lambda_k Phi_k. The dual
   * functions are biorthogonal to the shape functions of the slave,
   *   integral Phi_k N_j ds = delta_kj D_k,
   * so that of the slave side only the node k itself is in g_k, as with the
   * nodal discretization: a mortar point is a nodal point that looks at its
   * surroundings. (B. Wohlmuth, SIAM J. Numer. Anal. 38, 2000; S. Hueeber and
   * B. Wohlmuth, Comput. Methods Appl. Mech. Engrg. 194, 2005; A. Popp, M. W.
   * Gee and W. A. Wall, Int. J. Numer. Meth. Engng. 79, 2009.)
   *
   * The integrals run over the segments of class MortarSegments.
   *
   * The direction n_k is that of the surface which bends less: without friction
   * a flat surface pushes along its own normal, whatever corner stands on it.
   * With n_s, n_m the normals of slave and master, those of the master weighted
   * by Phi_k, and b_s, b_m the angles by which the surfaces turn around the
   * node,
   *   n_k = b_m^2 n_s + b_s^2 n_m, normalized; n_s where the slave is flat, or
   * ends in a hollow of its body: what is there is a corner of the master.
   * The b are those of the undeformed surfaces: the strains of flat ones must
   * not decide. On smooth surfaces that touch, n_s and n_m are the same up to
   * the error of the discretization.
   *
   * Differences from the papers:
   *  - A dual function is negative somewhere, and weighted with it a gap that
   *    grows fast beside the node, as on a mesh that is coarse beside a round
   *    counterface, may come out far below all distances, also as a
   *    penetration where there is none. The gap is no less than the smallest of
   *    the distances that it is a mean of, less 1e-4 of an edge.
   *  - At a corner of the slave each edge is projected along its own normal.
   *    There the node is one on each side, see Surface.
   *  - At an edge that faces the master in part or in several parts (the master
   *    has holes, or several pieces), and at nodes that carry no
   *    multiplier (excluded, or where supports hold both sides), the dual
   *    functions of the edge are polynomials of a lower degree, as many as
   *    there are nodes left, that still sum up to one: a constant pressure is
   *    in the space everywhere, and D_k > 0. Other nodes of the edge are then
   *    in g_k, too.
   *  - On a symmetry line the normal is along the line.
   *  - The projection points of a node are shifted along the master such that
   *    x_slave - x_master, weighted, is parallel to n_k. The shift vanishes
   *    with the gap; with it the forces balance in moment exactly, not only up
   *    to the gap (the same end as in M. A. Puso and T. A. Laursen, Comput.
   *    Methods Appl. Mech. Engrg. 193, 2004).
   */
  template<>
  class MortarDiscretization<2>
  {
  public:
    MortarDiscretization(const Surface<2>             &slave,
                         const Surface<2>             &master,
                         const DiscretizedBodies<2>   &discretization,
                         const std::set<unsigned int> &excluded);

    /// The points, not paired yet, and their multipliers.
    std::vector<ContactPoint<2>>
    make_points(MultiplierSpace &multipliers) const;

    /**
     * Integrate in the configuration @p u, and fill in what belongs to the
     * pairing: weight, normal, nodes and coefficients. Points whose
     * surroundings do not face the master are marked so. Returns whether a
     * point has other unknowns than before.
     */
    bool pair(const ArrayView<ContactPoint<2>> &points,
              const GhostedVector              &u,
              const PairingMode                &mode,
              const BodyOverlap<2>             &bodies) const;

    /// Edges choose by distances alone: nothing is kept.
    void begin_increment() const
    {
    }

  private:
    void fill_in(const MortarGeometry<double> &now,
                 const MortarPairing<double>  &pairing,
                 const GhostedVector          &u,
                 ContactPoint<2>              &point) const;

    /// Whether a point is on a line that both bodies are symmetric to.
    bool is_on_symmetry_line(const ContactPoint<2> &point,
                             const GhostedVector   &u) const;

    /// The number of a node in the list of a point, or that of all. Near a fold
    /// of a surface in contact with itself a node is on both sides.
    unsigned int place_of(const SurfaceNode<2>  &node,
                          const ContactPoint<2> &point) const;

    void add_nodes(const MortarPairing<double> &pairing,
                   ContactPoint<2>             &point) const;

    /// The nodes of both surfaces that move the segments around a slave node.
    std::array<std::set<unsigned int>, 2>
    nodes_around(const unsigned int                node,
                 const std::vector<MortarOverlap> &overlaps) const;

    /// Fill in the derivatives of a point's pairing, by the segments of the
    /// edges around it.
    void differentiate(MortarGeometry<WithDerivatives>  &now,
                       const std::vector<MortarOverlap> &overlaps,
                       ContactPoint<2>                  &point) const;

    unsigned int slave_node(const ContactPoint<2> &point) const;

    const Surface<2>           &slave;
    const Surface<2>           &master;
    const DiscretizedBodies<2> &discretization;
    const bool                  is_with_itself;

    /// Whether a node of a slave edge carries a multiplier, as that edge sees
    /// it.
    std::vector<PerEdgeNode<bool>> carries;
  };
} // namespace Contact

#endif
