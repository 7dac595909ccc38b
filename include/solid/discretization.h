/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_discretization_h
#define contact_discretization_h

#include <deal.II/lac/affine_constraints.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "base/counters.h"
#include "base/ghosted_vector.h"
#include "bodies/discretized_bodies.h"
#include "mesh/mesh.h"
#include "parameters/parameters.h"
#include "solid/element_spaces.h"
#include "solid/normal_supports.h"
#include "solid/place.h"
#include "solid/rigid_boundaries.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The finite element spaces of all bodies: quadrangles and hexahedra are
   * FE_Q, triangles and tetrahedra FE_SimplexP of the same degree, the geometry
   * is isoparametric.
   *
   * Quadrature: degree + 1 Gauss points in each direction; in triangles and
   * tetrahedra 1 point at degree 1, 3 and 8 points at degree 2.
   *
   * With <code>serendipity</code> the centre value of a quadrangle of degree 2
   * is 1/2 sum(mid-sides) - 1/4 sum(corners): the 8-node element; of hexahedra
   * the 20-node one (bound_nodes()).
   *
   * With axisymmetry x is the radius and y the axis. Whatever integrates
   * multiplies with circumference(); u_x = 0 on the axis without being asked
   * for.
   *
   * With several ranks each has the unknowns of its cells and their neighbors;
   * supports and the unknowns at named places are known to all. Vectors of the
   * displacement hold the former and, on every rank, the unknowns of all
   * contact faces and at named places.
   */
  template<int dim>
  class Discretization : public DiscretizedBodies<dim>
  {
  public:
    Discretization(const Mesh<dim>       &mesh,
                   const Parameters::All &parameters,
                   const MPI_Comm         communicator = MPI_COMM_SELF);

    using DiscretizedBodies<dim>::communicator;
    using DiscretizedBodies<dim>::degree;
    using DiscretizedBodies<dim>::axisymmetric;
    using DiscretizedBodies<dim>::mapping;
    using DiscretizedBodies<dim>::dof_handler;
    using DiscretizedBodies<dim>::constraints;
    using DiscretizedBodies<dim>::distribution;
    using DiscretizedBodies<dim>::vertex_dofs;
    using DiscretizedBodies<dim>::counters;

    /// Number the unknowns anew after the mesh was refined.
    void redistribute();

    const Mesh<dim> &mesh;
    const bool       serendipity;

    /// The faces that may touch or are rigid, whose centres serendipity does
    /// not bind.
    const std::set<types::boundary_id> free_centres;

    const hp::FECollection<dim> fe;
    const hp::QCollection<dim>  quadrature;

    /// Behind the unit N of a force: it is one by thickness, or of a whole
    /// ring, or in 3-D.
    std::string per_thickness() const
    {
      return axisymmetric || dim == 3 ? "" : "/mm";
    }

    /// Supports, ties and loads at their full values.
    const Parameters::Boundary boundary;

    /// The factor of an entry of the boundary conditions under a load factor,
    /// by its history.
    double factor(const std::string &entry, const double load_factor) const;

    /// Those of flat boundaries along their normal.
    NormalSupports<dim> normal_supports;

    /// By component: the groups that are supported, and the unknowns of each
    /// that this rank knows.
    std::array<std::map<std::string, std::set<types::global_dof_index>>, dim>
      supports;

    /// A point by its name, at a node or between nodes. Throws InputError with
    /// the @p entry that names it if there is none.
    const Place<dim> &place(const std::string &name,
                            const std::string &entry) const;

    /**
     * Make the constraints such that the next update brings the supported
     * unknowns from their value in @p u to the displacement prescribed under
     * @p load_factor. Costs nothing where nothing changes.
     */
    void constrain_update(const GhostedVector &u, const double load_factor);

    /**
     * Bring all supported unknowns of @p u, and those that follow them, to what
     * is prescribed under @p load_factor at once: the next update moves none.
     * For bodies whose tangent does not depend on the strains this makes.
     */
    void prescribe(GhostedVector &u, const double load_factor);

    /// The way of all supported unknowns from @p u to what is prescribed under
    /// @p load_factor [mm], zero elsewhere.
    GhostedVector support_motion(const GhostedVector &u,
                                 const double         load_factor) const;

    /// The displacements at the beginning of @p solution.
    GhostedVector displacements(const GhostedVector &solution) const
    {
      GhostedVector u(distribution);
      std::copy_n(solution.begin(), u.n_held(), u.begin());
      return u;
    }

    /// The displacements at the beginning of @p solution with ghosts on the
    /// cells of this rank and their neighbors alone. Collective.
    DistributedVector distributed(const GhostedVector &solution) const;


    /// Set the constrained unknowns at the beginning of @p v, a change under
    /// which supports rest: zero, or as the unknowns that they follow.
    void constrain_homogeneously(GhostedVector &v) const
    {
      for (const auto &line : constraints.get_lines())
        {
          v[line.index] = 0;
          for (const auto &[dof, factor] : line.entries)
            v[line.index] += factor * v[dof];
        }
    }

    /// Bring rigid boundaries of large displacement, whose leaders a step has
    /// moved, to where these are, and nodes that are held along normals to
    /// where they have to be, the round-off of the way there off. Collective.
    void project_on_rigid_motions(GhostedVector &u,
                                  const double   load_factor) const;

    /// Add the forces of forces and moments on rigid boundaries. At full values
    /// of the undeformed boundaries, the sum of their magnitudes.
    void add_rigid_loads(const GhostedVector &u,
                         const double         load_factor,
                         GhostedVector       &load) const;

    /// Whether a rigid boundary of large displacement may turn under a force,
    /// a moment or the reaction of a displacement.
    bool turns_with_loads(const RigidBoundary<dim> &of) const
    {
      const auto targets = this->targets(of, present_load_factor);
      return of.is_large && of.turns(targets) &&
             (targets.holds_place() ||
              applied(of, present_load_factor) !=
                typename RigidBoundary<dim>::PerMotion());
    }

    /// Add what the force on a rigid boundary of large displacement, applied or
    /// the reaction of a displacement, and the internal @p forces do to the
    /// tangent as it turns, with the present constraints, which are of the
    /// displacements @p u. Internal forces that are further from equilibrium
    /// than the applied ones are large are those of no state to linearise.
    /// Collective.
    template<typename Matrix>
    void add_rigid_stiffness(const GhostedVector &u,
                             const GhostedVector &forces,
                             Matrix              &matrix) const
    {
      using PerMotion   = typename RigidBoundary<dim>::PerMotion;
      const auto &owned = dof_handler.locally_owned_dofs();
      for (const RigidBoundary<dim> &of : rigid)
        {
          const auto leaders = of.leaders();
          if (!turns_with_loads(of) || leaders.empty())
            continue;
          PerMotion  applied = this->applied(of, present_load_factor);
          const auto targets = this->targets(of, present_load_factor);
          const auto motion  = of.motion(u, targets);
          PerMotion  net     = of.resultant(motion, forces, owned);
          Utilities::MPI::sum(ArrayView<const double>(net.data(), net.size()),
                              communicator,
                              ArrayView<double>(net.data(), net.size()));
          double force = 0; // [N]
          for (unsigned int k = 0; k < 6; ++k)
            {
              if (k < 3 && targets.is_prescribed[k])
                applied[k] = net[k];
              net[k] -= applied[k];
              force += k < 3 ? std::abs(applied[k]) : 0;
            }
          Tensor<2, 3> V =
            Utilities::MPI::sum(of.moment(motion, forces, owned), communicator);
          if (of.on_leaders(motion, targets, net).l2_norm() >
              force + of.on_leaders(motion, targets, applied).l2_norm())
            V = 0;
          if (owned.is_element(leaders[0]))
            constraints.distribute_local_to_global(
              of.stiffness(motion, targets, V, applied),
              leaders,
              matrix);
        }
    }

    /// The sum of the magnitudes of the nodal forces on undeformed bodies.
    double rigid_load(const double load_factor) const;

    /// The boundaries that move as rigid bodies.
    const std::vector<RigidBoundary<dim>> &rigid_boundaries() const
    {
      return rigid;
    }

    /// One of them, and the motions that are prescribed under a load factor.
    const RigidBoundary<dim> &rigid_boundary(const std::string &name,
                                             const std::string &entry) const;
    typename RigidBoundary<dim>::Targets
    targets(const RigidBoundary<dim> &boundary, const double load_factor) const;

    /// The point that one of them moves with, undeformed. It need not be one of
    /// the mesh: the axis of a hollow shaft is none.
    Point<dim> rigid_point(const std::string &boundary) const;

    /// Whether an unknown is of one of them.
    bool is_rigid(const types::global_dof_index dof) const override
    {
      return rigid_dofs.count(dof) > 0;
    }

    /// Grows whenever constraints couple other unknowns on the same mesh.
    unsigned int pattern_version() const
    {
      return n_patterns;
    }

    /// The largest displacement that a support prescribes now [mm].
    double largest_prescribed() const
    {
      return largest_displacement;
    }

    /// The largest distance of a supported unknown of @p u from its prescribed
    /// value under @p load_factor [mm].
    double distance_from_supports(const GhostedVector &u,
                                  const double         load_factor) const;

    /// The unknowns that follow others: hanging nodes, bound centres, ties;
    /// without supports. The constraints of an update no longer know of those
    /// whose leaders a support fixes. Made where they are first asked for.
    const AffineConstraints<double> &followers() const;

    /// Whether the next update moves a supported unknown.
    bool update_is_prescribed() const
    {
      return !updates_vanish;
    }

    const std::set<types::boundary_id> &
    boundary_ids(const std::string &name,
                 const std::string &entry) const override
    {
      return mesh.boundary(name, entry);
    }
    std::vector<NodeDoFs<dim>>
    nodes_of(const std::string &name, const std::string &entry) const override;
    std::string body_name(const types::material_id id) const override
    {
      return mesh.body_name(id);
    }
    unsigned int
    piece(const typename Triangulation<dim>::cell_iterator &cell) const override
    {
      return mesh.pieces.of_cell(cell);
    }

    bool is_fixed(const types::global_dof_index dof) const override;
    bool are_fixed_alike(const types::global_dof_index a,
                         const types::global_dof_index b) const override
    {
      return is_fixed(a) && is_fixed(b) &&
             !(prescribed.at(a) != prescribed.at(b));
    }

    /// Whether a support moves this unknown as the load grows.
    bool is_moved(const types::global_dof_index dof) const;

    std::vector<Tensor<1, dim>>
    held_normals(const NodeDoFs<dim> &node) const override
    {
      return normal_supports.normals(node);
    }
    Tensor<1, dim> free_part(const NodeDoFs<dim>  &node,
                             const Tensor<1, dim> &vector) const override;
    bool           are_held_alike(const NodeDoFs<dim>  &a,
                                  const NodeDoFs<dim>  &b,
                                  const Tensor<1, dim> &direction) const override;

    /// Whether this unknown is tied to another one, or another one to it.
    bool is_tied(const types::global_dof_index dof) const;

  private:
    SupportMotion<dim> motion_of_supports(const double load_factor) const;

    /// Whether both have the same values at all times.
    bool move_alike(const Prescribed<dim> &first,
                    const Prescribed<dim> &second) const;

    /// Visit the unknowns of this rank that supports hold, with their ways from
    /// @p u to where these want them, exactly zero within round-off [mm].
    void
    for_supported(const GhostedVector                         &u,
                  const SupportMotion<dim>                    &motion,
                  const std::function<void(const types::global_dof_index dof,
                                           const double way)> &visit) const;


    void check_radii();
    void hold_axis();
    void distribute_vectors();
    void gather_named_points();
    void find_places();
    void collect_supports();
    /// Computed where it is asked for: the mapping of a node costs more than
    /// all the rest of a visit.
    using PlaceOfNode = std::function<Point<dim>()>;
    using NodeVisitor = std::function<void(const types::global_dof_index dof,
                                           const PlaceOfNode            &place,
                                           const bool is_owned)>;
    void visit_group(const unsigned int component,
                     const std::string &entry,
                     const std::string &name,
                     const NodeVisitor &visitor) const;
    void hold(const unsigned int component,
              const std::string &entry,
              const std::string &name,
              const std::function<Prescribed<dim>(const PlaceOfNode &)> &at);
    void collect_formulas(const unsigned int component);
    void hold_parents_of_hanging_nodes();
    void collect_ties();
    void collect_rigid();
    /// The force and moment on a boundary.
    typename RigidBoundary<dim>::PerMotion
         applied(const RigidBoundary<dim> &of, const double load_factor) const;
    void choose_rigid_leaders(RigidBoundary<dim> &boundary);
    void update_rigid_leaders(const GhostedVector &u, const double load_factor);
    std::vector<typename RigidBoundary<dim>::Line>
    rigid_lines(const GhostedVector &u, const double load_factor) const;
    void
    make_constraints(const std::map<types::global_dof_index, double> &updates);

    using History = std::function<double(const Point<1> &)>;

    using DiscretizedBodies<dim>::axis_tolerance;
    using DiscretizedBodies<dim>::ties;

    DoFHandler<dim>                                    own_dof_handler;
    AffineConstraints<double>                          own_constraints;
    std::map<std::string, Place<dim>>                  places;
    std::map<std::string, History>                     histories;
    std::vector<typename SupportMotion<dim>::Formula>  formulas;
    std::map<types::global_dof_index, Prescribed<dim>> prescribed;
    std::set<types::global_dof_index>                  leaders;
    const std::set<types::material_id>                 small_strain;
    std::vector<RigidBoundary<dim>>                    rigid;
    std::set<types::global_dof_index>                  rigid_dofs;
    std::set<types::global_dof_index> rigid_held; // by supports, too
    std::vector<typename RigidBoundary<dim>::Line>       followers_of_rigid;
    unsigned int                                         n_patterns = 0;
    std::array<std::map<std::string, unsigned int>, dim> formula_of_rigid;
    mutable std::unique_ptr<AffineConstraints<double>>   known_followers;
    bool                                                 updates_vanish = true;
    double present_load_factor  = 0; // of the constraints
    double largest_displacement = 0;
  };
} // namespace Contact

#endif
