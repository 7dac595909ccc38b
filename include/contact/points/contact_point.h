/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_point_h
#define contact_contact_point_h

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <memory>

#include "contact/obstacles/obstacle.h"
#include "contact/points/point_status.h"
#include "contact/surfaces/surface.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The change of a point's pairing with the displacements of the nodes around
   * it, where the discretization finds that by itself: derivatives with respect
   * to the unknowns @p dofs. A tangent turns with the normal. In 3-D one rank
   * alone has @p C and @p rotation, which are large.
   */
  template<int dim>
  struct PairingChange
  {
    std::vector<types::global_dof_index> dofs;

    FullMatrix<double> C; // of the coefficients, by node [1/mm]
    std::vector<Tensor<1, dim - 1>>
      rotation; // of the normal, by tangent [1/mm]

    // In 3-D, of the coefficients by a slip, by node [1/mm].
    std::vector<Tensor<1, dim>> slide;

    // In 2-D, of the weight, relative [1/mm], and of the projection's
    // place along the normal [1].
    std::vector<double> weight, projection;
  };



  /// The place of a contact point on the slave, the same during the whole run.
  template<int dim>
  struct PointPlace
  {
    static constexpr unsigned int max_multipliers = 3;

    // The contact pair that the point belongs to.
    unsigned int contact_pair = 0;

    // At a corner of the master: the same with both bodies exchanged in all
    // that follows, see corner_points.h.
    bool is_master_corner = false;

    unsigned int    slave_facet = 0; // in the slave surface
    FacetPoint<dim> slave_xi{};
    double          weight = 0; // undeformed length it stands for [mm]; of
                                // rings, and in 3-D, the area [mm^2]
    double augmentation_parameter = 0; // the c of p - c g [MPa/mm]
    double elastic_slip = 0; // at which the bound is reached [mm]; 0: none

    // Directions that supports hold the slave's node along, but not all nodes
    // around it: see mark_dirichlet_edges().
    std::vector<Tensor<1, dim>> dirichlet_edges;

    // The multipliers that act here: p = sum_k psi_k lambda_k.
    unsigned int                              n_multipliers = 0;
    std::array<unsigned int, max_multipliers> multipliers{};
    std::array<double, max_multipliers>       psi{};
  };



  /// Add what is new in @p direction, if anything, to an orthonormal basis.
  template<int dim>
  void add_orthonormal(const Tensor<1, dim>        &direction,
                       std::vector<Tensor<1, dim>> &basis)
  {
    const double   sine = 1e-3;
    Tensor<1, dim> rest = direction;
    for (unsigned int pass = 0; pass < 2; ++pass) // because of round-off
      for (const Tensor<1, dim> &other : basis)
        rest -= (rest * other) * other;
    if (rest.norm() > sine)
      basis.push_back(rest / rest.norm());
  }



  /// The pairing of a contact point with the master.
  template<int dim>
  struct PointPairing
  {
    /// Something of each node. Six are two quadratic edges; the mortar
    /// discretization, where a slave node may face many master edges, can have
    /// more.
    template<typename T>
    using PerNode = boost::container::small_vector<T, 6>;

    bool            facing = false; // false: off the end, nothing to touch
    unsigned int    master_facet = 0;
    FacetPoint<dim> master_xi{};

    // The nodes of both sides, slave first.
    unsigned int                      n_slave_nodes = 0;
    unsigned int                      n_nodes       = 0;
    PerNode<const SurfaceNode<dim> *> nodes;
    PerNode<double>                   C;  // coefficients
    PerNode<double>                   C1; // in 2-D, their derivatives
    PerNode<double>                   C2; // by the master coordinate

    /// The unknowns of a node, and its reference position [mm].
    const NodeDoFs<dim> &dofs(const unsigned int a) const
    {
      return nodes[a]->dofs;
    }
    const Point<dim> &X(const unsigned int a) const
    {
      return nodes[a]->X;
    }

    /// The round-off of a gap between these nodes [mm].
    double gap_round_off() const;

    /// Append a node, which a surface has as long as there is this pairing,
    /// with its coefficient and, in 2-D, the derivatives of that.
    void add_node(const SurfaceNode<dim> &node,
                  const double            c,
                  const double            c1 = 0,
                  const double            c2 = 0);

    /// Forget the nodes from the number @p n on.
    void keep_nodes(const unsigned int n);

    /// Forget one node.
    void remove_node(const unsigned int n);

    Tensor<1, dim>                      normal;
    std::array<Tensor<1, dim>, dim - 1> tangents;

    double metric = 1; // in 2-D, |d x_m / d xi| [mm]

    /// The vector with these components along the tangents.
    Tensor<1, dim> along_tangents(const Tensor<1, dim - 1> &components) const
    {
      Tensor<1, dim> sum = components[0] * tangents[0];
      for (unsigned int k = 1; k < dim - 1; ++k)
        sum += components[k] * tangents[k];
      return sum;
    }

    /// The components of a vector along the tangents.
    Tensor<1, dim - 1> tangential_part(const Tensor<1, dim> &v) const
    {
      Tensor<1, dim - 1> components;
      for (unsigned int k = 0; k < dim - 1; ++k)
        components[k] = tangents[k] * v;
      return components;
    }

    // On an obstacle, which has no nodes: the place x_m, and d^2 x_m / d xi^2;
    // what the material there moves in the increment, see
    // Obstacle::ClosestPoint.
    Point<dim>     projection;
    Tensor<1, dim> projection_curvature;
    Tensor<1, dim> projection_motion;
    double         projection_stretch = 0;

    // The ways of the master here by the free motions of the contact pair, see
    // FreeMotion.
    std::vector<MotionAt<dim>> motions;

    // Over a vertex of the master the projection stays there.
    bool projection_is_clipped = false;

    // Empty where master_xi and the derivatives of C with respect to it say how
    // the pairing changes.
    PairingChange<dim> change;

    // A tangential row that says no more than the normal one is dropped: so
    // at a slave node on a symmetry line.
    bool has_no_free_tangent = false;

    // In 3-D across planes of symmetry there is no slip, though nodes beside
    // them are in the row. Orthonormal.
    std::vector<Tensor<1, dim>> tangents_held_by_supports;

    // The projection on the rim, where the master is free along the surface: a
    // spring of the stiffness c holds what sticks there.
    Tensor<2, dim - 1> rim_compliance;
  };



  /// What a point that is joined to others of its node has without them, and
  /// the number of the first of these, which acts for all: see PointFrames.
  template<int dim>
  struct JoinedPoint
  {
    PointPairing<dim> pairing;
    double            weight = 0;
    unsigned int      first  = numbers::invalid_unsigned_int;
  };



  /**
   * The contact point, the idea that carries this program: a place on the
   * slave surface with a weight, the place on the master surface that it
   * faces, and the multipliers that act there.
   *
   * With the nodes of the slave edge (coefficient +N) and of the master edge
   * (coefficient -N) in one list, all that contact needs are sums over it:
   *   gap             g = n . sum_a C_a x_a          (negative: penetration)
   *                   (minus the place on the obstacle, if that is the master)
   *   slip            s = t . sum_a C_a (u_a - u_a at the increment's start)
   *                   (minus the motion of the obstacle's material there)
   *   force on node a     w (p n + q t) C_a
   * Sign conventions, stated here once: n is the unit normal of the master
   * edge, out of the master body; t its unit tangent, n turned by +90 degrees;
   * the pressure p is positive in compression; q is the component along t of
   * the traction on the slave.
   * In 3-D there are two tangents, perpendicular to each other and to n, and
   * slip and shear have two components. Which two directions these are means
   * nothing; they turn with the normal, and not about it.
   */
  template<int dim>
  struct ContactPoint
    : public PointPlace<dim>
    , public PointPairing<dim>
  {
    PointStatus<dim> status;

    // The distance that an interference put between the surfaces at the
    // increment's start [mm]: it turns with them, which is no slip.
    Tensor<1, dim> interference_at_start;

    // Bound of the shear traction while a Tresca problem is solved [MPa].
    double friction_bound = 0;

    // At the increment's start, which springs go on from [MPa], and as a share
    // of the bound there, which elastic slip goes on from [-].
    Tensor<1, dim - 1> shear_at_start, share_at_start;

    // Other points of its node touch what they face when the increment begins:
    // springs of the stiffness c hold it in all directions, see PointFrames.
    bool is_in_an_edge = false;

    // Of a point that is joined to others; else nothing.
    std::shared_ptr<const JoinedPoint<dim>> joined;

    /// The unit vectors, or what void and held slips and springs leave:
    /// orthonormal.
    std::vector<Tensor<1, dim>> directions_of_slip() const;

    /// The projection on the directions in which springs of the stiffness c
    /// take the place of sticking.
    Tensor<2, dim - 1> stick_compliance() const;

    /// A slip or shear without its part in directions along the tangents, which
    /// are orthonormal.
    Tensor<1, dim - 1> without(const std::vector<Tensor<1, dim>> &directions,
                               const Tensor<1, dim - 1>          &slip) const
    {
      Tensor<1, dim - 1> rest = slip;
      for (const Tensor<1, dim> &direction : directions)
        {
          const Tensor<1, dim - 1> along = this->tangential_part(direction);
          rest -= (rest * along) * along;
        }
      return rest;
    }

    /// The number of the node that has the multipliers, where it is one.
    unsigned int own_node() const
    {
      const auto smaller = [](const double a, const double b) {
        return std::abs(a) < std::abs(b);
      };
      const auto &C = this->C;
      return std::max_element(C.begin(),
                              C.begin() + this->n_slave_nodes,
                              smaller) -
             C.begin();
    }

    /// Whether the node @p a of the list is one of the slave.
    bool is_on_slave(const unsigned int a) const
    {
      return (a < this->n_slave_nodes) != this->is_master_corner;
    }
  };
} // namespace Contact

#endif
