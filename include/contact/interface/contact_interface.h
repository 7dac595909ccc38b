/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_interface_h
#define contact_contact_interface_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_matrix.h>

#include <algorithm>
#include <map>

#include "contact/interface/active_set.h"
#include "contact/interface/friction_bounds.h"
#include "contact/interface/obstacle_motions.h"
#include "contact/interface/point_frames.h"

namespace Contact
{
  using namespace dealii;

  /**
   * All contact pairs: their points, and the numbers of their multipliers.
   * ContactKernel makes equations of them.
   *
   * The solution vector holds the displacement, then the normal multipliers,
   * and of contact pairs with friction the tangential ones. With the tractions
   *   p = lambda_n - c g  in contact,  0 if open,
   *   q = lambda_t - c s  if sticking, +-bound if slipping, 0 if open,
   * the discrete equations are, summed over the points,
   *   elastic forces_a - w (p n + q t) C_a = 0,
   *   w psi_k (p - lambda_n)/c = 0,   w psi_k (q - lambda_t)/c = 0:
   * the stationarity of the augmented Lagrangian of Alart and Curnier (Comput.
   * Methods Appl. Mech. Engrg. 92, 1991), whose semismooth Newton method with
   * the status kept in the points is the primal-dual active set of
   * Hintermueller, Ito and Kunisch (SIAM J. Optim. 13, 2003).
   *
   * With an elastic slip e, where the bound b is reached, a point sticks if
   *   lambda_t = b zeta,   zeta = zeta_start - s/e,
   * zeta_start = q/b at the increment's start: perfect plasticity of the share
   * zeta of the bound. Its trial value is
   *   q_trial = lambda_t + kappa (b zeta - lambda_t),   kappa = min(1, c e/b),
   * by no stiffer springs than c: with b/e directions of slip find no end.
   */
  template<int dim>
  class ContactInterface
  {
  public:
    ContactInterface(const DiscretizedBodies<dim>           &discretization,
                     const BodyStiffness                    &elasticity,
                     const std::vector<Parameters::Contact> &parameters);

    ContactInterface(const ContactInterface &) = delete;

    const DiscretizedBodies<dim>                        &discretization;
    std::vector<std::unique_ptr<const ContactPair<dim>>> pairs;

    ObstacleMotions<dim> motions;
    FrictionBounds<dim>  bounds;
    ActiveSet<dim>       active_set;

    /// All points, contact pair by contact pair.
    const std::vector<ContactPoint<dim>> &points() const
    {
      return all_points;
    }

    /// The numbers of the points whose forces this process adds up: as many as
    /// any other has, wherever their nodes are.
    IndexSet own_points() const
    {
      return Utilities::MPI::create_evenly_distributed_partitioning(
        discretization.communicator,
        all_points.size());
    }

    const ContactPair<dim> &contact_pair(const ContactPoint<dim> &point) const
    {
      return *pairs[point.contact_pair];
    }

    /// The points of the slave for results: of points that are joined, see
    /// PointFrames, each with its part of the force.
    std::vector<ContactPoint<dim>>
    acting_points(const ContactPair<dim> &contact_pair) const;

    /// The normal multiplier that is the pressure of the point with the
    /// multiplier @p k.
    unsigned int acting_multiplier(const unsigned int k) const
    {
      return frames.acting_multiplier(all_points, k);
    }

    /// All points as they would be paired in the configuration @p u, but for
    /// those of glue.
    std::vector<ContactPoint<dim>> paired_anew(const GhostedVector &u) const;

    /// Return to the points of an earlier state, or of one to be checked.
    void set_points(const std::vector<ContactPoint<dim>> &points)
    {
      AssertDimension(points.size(), all_points.size());
      all_points = points;
    }

    /// Whether there is nothing but glue: all contact pairs are tied.
    bool is_tied() const
    {
      return !has_pair([](const auto &of) { return !of.tied; });
    }

    /// Whether a contact pair that is not tied has friction, and Coulomb's.
    bool has_friction() const
    {
      return has_pair(
        [](const auto &of) { return !of.tied && !of.law.is_frictionless(); });
    }
    bool has_coulomb_friction() const
    {
      return has_pair([](const auto &of) {
        return !of.tied && of.law.coulomb_coefficient > 0;
      });
    }

    /// Whether a point has tangential multipliers.
    bool has_friction(const ContactPoint<dim> &point) const
    {
      return !contact_pair(point).law.is_frictionless();
    }

    /// All of them, with free motions, and those of the normal direction.
    unsigned int n_multipliers() const
    {
      return n_normal_multipliers() + (dim - 1) * n_tangential +
             motions.free.size();
    }
    unsigned int n_normal_multipliers() const
    {
      return tangential_number.size();
    }

    /// Their indices in the solution; the tangential ones, one for each
    /// tangent, only with friction.
    types::global_dof_index normal_index(const unsigned int multiplier) const
    {
      return discretization.dof_handler.n_dofs() + multiplier;
    }
    types::global_dof_index
    tangential_index(const unsigned int multiplier,
                     const unsigned int tangent = 0) const
    {
      return normal_index(n_normal_multipliers() +
                          (dim - 1) * tangential_number[multiplier] + tangent);
    }

    /// The pressure that ContactPair::pressure_at describes, in a solution
    /// [MPa].
    double
    pressure(const std::vector<std::pair<unsigned int, double>> &multipliers,
             const GhostedVector &solution) const;

    /**
     * Pair all points with the master in the configuration @p u. Returns
     * whether a point changed its master edge: then the matrix couples other
     * unknowns than before.
     */
    bool pair(const GhostedVector &u, const PairingMode &mode = {});

    /// An increment begins at the load factor @p from with @p solution, in
    /// which the points are paired: they remember it. Call it before
    /// ObstacleMotions::move().
    void begin_increment(const double from, const GhostedVector &solution);

    /// The same in the configuration @p start, which the points are paired in
    /// first if they remember more than shears: an interference turns with
    /// them.
    void pair_and_begin_increment(const double         from,
                                  const GhostedVector &start);

    /// Find the points of edges as an increment begins, see PointFrames.
    void find_edges(const GhostedVector &u_start);

    /// What else than the state the equations of contact follow: the statuses
    /// of all points, and which are in edges.
    std::vector<signed char> signature() const;

    /// Let points on springs and with elastic slip begin an increment with the
    /// shears of a state; if that is not the start, with those that lead to
    /// them.
    void set_shear_at_start(const GhostedVector &solution,
                            const GhostedVector &u_start);

    /**
     * Surfaces that overlap in the mesh are parted along the first increment,
     * of which a step goes from the part @p from to the part @p to: the
     * surfaces of a contact pair are kept apart by (1 - to) of the largest
     * overlap at the @p start, as if they had a clearance, so that each step
     * closes a part of it. An increment in one step closes all of it.
     */
    void ramp_initial_penetration(const double         from,
                                  const double         to,
                                  const GhostedVector &start);

    /// Whether the points are paired where the surfaces are undeformed: forces
    /// of contact act there, too.
    bool is_paired_undeformed() const
    {
      return paired_undeformed;
    }

    /// The pairing stands still from now on.
    void clear_changes()
    {
      for (ContactPoint<dim> &point : all_points)
        point.change = PairingChange<dim>();
    }

    /// The largest change of a displacement of the surfaces [mm].
    double largest_change(const GhostedVector &u,
                          const GhostedVector &from) const;

    /**
     * The norm of the constraint part of @p rhs as a force [N per mm of
     * thickness], to be compared with that of the forces: a gap times the
     * stiffness E/h of the bodies at the point, times its weight.
     */
    double constraint_norm(const GhostedVector &rhs) const;

    /// The unknowns of a point: displacements of its nodes, its multipliers,
    /// and unknowns of other nodes that its pairing depends on.
    std::vector<types::global_dof_index>
    unknowns_of(const ContactPoint<dim> &point) const;

    /// Add the couplings of the points.
    void add_couplings(DynamicSparsityPattern &pattern) const;

    /// Whether a pair that is not tied has an elastic slip.
    bool has_elastic_slip() const
    {
      return std::any_of(all_points.begin(),
                         all_points.end(),
                         [](const auto &point) {
                           return point.elastic_slip > 0;
                         });
    }

    /// The terms of a shear with elastic slip: bound b [MPa], stiffness b/e
    /// [MPa/mm], kappa and zeta.
    struct ElasticShear
    {
      double             bound, stiffness, kappa;
      Tensor<1, dim - 1> zeta;
    };

    ElasticShear elastic_shear(const ContactPoint<dim> &point,
                               const ContactState<dim> &now) const;

    /// Gap, slip and multipliers in a solution; the slip is without what
    /// springs give way, see ContactPoint::stick_compliance().
    ContactState<dim> state(const ContactPoint<dim> &point,
                            const GhostedVector     &solution,
                            const GhostedVector     &u_start) const;

  private:
    template<typename Predicate>
    bool has_pair(const Predicate &predicate) const
    {
      return std::any_of(pairs.begin(), pairs.end(), [&](const auto &pair) {
        return predicate(*pair);
      });
    }

    std::vector<ContactPoint<dim>> all_points;
    PointFrames<dim>               frames;
    bool                           paired_undeformed = true;

    /// Of each normal multiplier the number of its tangential one.
    std::vector<unsigned int> tangential_number;
    unsigned int              n_tangential = 0;
  };
} // namespace Contact

#endif
