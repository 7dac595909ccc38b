/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_discretized_bodies_h
#define contact_discretized_bodies_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/hp/mapping_collection.h>
#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/counters.h"
#include "base/ghosted_vector.h"

namespace Contact
{
  using namespace dealii;

  /// The displacement unknowns of a node.
  template<int dim>
  using NodeDoFs = std::array<types::global_dof_index, dim>;

  /// The nodes of these faces that this process has cells at, as often as faces
  /// have them.
  template<int dim>
  std::vector<NodeDoFs<dim>>
  nodes_on(const DoFHandler<dim>              &dof_handler,
           const std::set<types::boundary_id> &boundary);



  /// The stiffness of the bodies, by which contact scales its equations.
  class BodyStiffness
  {
  public:
    virtual ~BodyStiffness() = default;

    /// Young's modulus [MPa] of a body.
    virtual double youngs_modulus(const types::material_id body) const = 0;
  };



  /**
   * The bodies as contact sees them: the unknowns and places of the nodes at
   * the boundary, names of its groups, and what supports hold. Bodies are
   * material ids, a displacement is an FESystem of degree 1 or 2 with dim
   * components, whose geometry is isoparametric.
   *
   * Discretization has them of a parameter file, GivenBodies of a DoFHandler
   * and AffineConstraints that a program has already.
   */
  template<int dim>
  class DiscretizedBodies
  {
  public:
    virtual ~DiscretizedBodies() = default;

    DiscretizedBodies(const DiscretizedBodies &) = delete;

    const MPI_Comm                   communicator;
    const unsigned int               degree;
    const bool                       axisymmetric;
    const hp::MappingCollection<dim> mapping;
    const DoFHandler<dim>           &dof_handler;

    /// Supports, ties, serendipity constraints and hanging nodes, for the next
    /// Newton update.
    const AffineConstraints<double> &constraints;

    /// The unknowns that vectors of the displacement hold on this rank.
    Distribution distribution;

    /// The unknowns of each vertex of the triangulation; invalid where no cell
    /// of this rank or its neighbors has it.
    std::vector<NodeDoFs<dim>> vertex_dofs;

    /// The costly operations on these spaces. Counting changes nothing.
    mutable Counters counters;

    /// The volume of the body by the area of the plane, at a place X: 1 in
    /// plane strain and in 3-D, the circumference 2 pi x of its ring with
    /// axisymmetry [mm].
    double circumference(const Point<dim> &X) const
    {
      return circumference_at(X[0]);
    }

    /// The same by the distance from the axis.
    template<typename Number>
    Number circumference_at(const Number &x) const
    {
      return axisymmetric ? Number(2 * numbers::PI * x) : Number(1);
    }

    /// Whether a place is on the axis of symmetry.
    bool is_on_axis(const Point<dim> &X) const
    {
      return axisymmetric && X[0] <= axis_tolerance;
    }

    /// The ids of a group of faces, the nodes of any group that this process
    /// has cells at, or an InputError; @p entry is the one that names it.
    virtual const std::set<types::boundary_id> &
    boundary_ids(const std::string &name, const std::string &entry) const = 0;
    virtual std::vector<NodeDoFs<dim>>
    nodes_of(const std::string &name, const std::string &entry) const = 0;

    /// The name of a body in messages.
    virtual std::string body_name(const types::material_id id) const = 0;

    /// The piece of its body that a cell belongs to, see MeshPieces.
    virtual unsigned int
    piece(const typename Triangulation<dim>::cell_iterator &cell) const = 0;

    /// Whether a support fixes this unknown.
    virtual bool is_fixed(const types::global_dof_index dof) const = 0;

    /// Whether supports move two unknowns by the same displacement, or none.
    virtual bool are_fixed_alike(const types::global_dof_index a,
                                 const types::global_dof_index b) const = 0;

    /// The normals along which supports hold a node, besides what is fixed.
    virtual std::vector<Tensor<1, dim>>
    held_normals(const NodeDoFs<dim> &) const
    {
      return {};
    }

    /// The part of a vector at a node that supports leave free.
    virtual Tensor<1, dim> free_part(const NodeDoFs<dim>  &node,
                                     const Tensor<1, dim> &vector) const;

    /// Whether supports move two nodes along @p direction by the same
    /// displacement, or none.
    virtual bool are_held_alike(const NodeDoFs<dim>  &a,
                                const NodeDoFs<dim>  &b,
                                const Tensor<1, dim> &direction) const;

    /// Whether an unknown is of a boundary that moves as a rigid body.
    virtual bool is_rigid(const types::global_dof_index) const
    {
      return false;
    }

    /// The unknowns that are tied, each with the one that it follows.
    const std::map<types::global_dof_index, types::global_dof_index> &
    tied() const
    {
      return ties;
    }

    /// Set the unknowns of @p u that @p lines constrain. A rank knows the
    /// constraints of its own unknowns, not those of all others. Collective.
    void distribute(const AffineConstraints<double> &lines,
                    GhostedVector                   &u) const;

  protected:
    /// References to what need not have been made yet.
    DiscretizedBodies(const DoFHandler<dim>            &dof_handler,
                      const AffineConstraints<double>  &constraints,
                      const hp::MappingCollection<dim> &mapping,
                      const unsigned int                degree,
                      const bool                        axisymmetric,
                      const MPI_Comm                    communicator);

    /// Call it when unknowns are numbered.
    void collect_vertex_dofs();

    double axis_tolerance = 0; // round-off of the radii [mm]
    std::map<types::global_dof_index, types::global_dof_index> ties;
  };
} // namespace Contact

#endif
