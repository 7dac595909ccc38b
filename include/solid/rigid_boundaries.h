/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_rigid_boundaries_h
#define contact_rigid_boundaries_h

#include <deal.II/base/index_set.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/ghosted_vector.h"

namespace Contact
{
  using namespace dealii;

  /**
   * A boundary that moves as a rigid body, in 2-D as part of space:
   *   u = U + (R - I) (X - P),
   * U the displacement of its point P and R a rotation; of small strain I and a
   * spin. A variation is linear in six numbers, the motions of the boundary,
   *   delta u = delta U + omega x r,   r = R (X - P), or X - P.
   * As many unknowns of its nodes as motions are free lead, and all others
   * follow them: no unknowns are added. Of large displacements the followers go
   * with the next update to where the leaders are, on the present tangent.
   *
   * Forces and moments are forces on three nodes (in 2-D two) with this
   * resultant about P, where it is now.
   */
  template<int dim>
  class RigidBoundary
  {
  public:
    using Dof = types::global_dof_index;

    /// Displacements of P [mm], then rotations about x, y, z [rad]; of forces,
    /// force [N] and moment [N mm].
    using PerMotion = std::array<double, 6>;

    struct Node
    {
      std::array<Dof, dim> dofs;
      Tensor<1, 3>         arm; // X - P [mm]
    };

    /// update of u_dof = sum of c_k times the updates of u_k + inhomogeneity.
    struct Line
    {
      Dof                                 dof;
      std::vector<std::pair<Dof, double>> entries;
      double                              inhomogeneity = 0;
    };

    /// The motions that are prescribed.
    struct Targets
    {
      std::array<bool, 6> is_prescribed{};
      PerMotion           value{};

      /// Whether the displacement of P is prescribed in some direction.
      bool holds_place() const
      {
        return is_prescribed[0] || is_prescribed[1] || is_prescribed[2];
      }
    };

    struct Motion
    {
      Tensor<1, 3> U;
      Tensor<2, 3> R;
    };

    /// Rings move along their axis alone. The leaders are no choice yet.
    RigidBoundary(const std::string       &name,
                  const std::vector<Node> &nodes,
                  const bool               is_large,
                  const bool               is_ring);

    const std::string       name;
    const std::vector<Node> nodes;
    const bool              is_large;

    /// Choose the leaders in a motion; unknowns that supports hold come first.
    /// Returns the unknowns of @p held that cannot be leaders: others or what
    /// is prescribed determine them.
    std::vector<Dof> choose_leaders(const Motion        &motion,
                                    const Targets       &targets,
                                    const std::set<Dof> &held);

    /// The smallest part [-] of what one of the leaders adds to the others:
    /// near zero they tell a motion badly.
    double quality(const Motion &motion, const Targets &targets) const;

    std::vector<Dof> leaders() const;

    /// Whether it is free to turn about some axis.
    bool turns(const Targets &targets) const
    {
      for (unsigned int k = 3; k < 6; ++k)
        if (!is_missing[k] && !targets.is_prescribed[k])
          return true;
      return false;
    }

    /// The motion that the leaders among @p u and the @p targets tell.
    Motion motion(const GhostedVector &u, const Targets &targets) const;

    /// All unknowns but those of @p held follow the leaders.
    std::vector<Line> lines(const GhostedVector &u,
                            const Targets       &targets,
                            const std::set<Dof> &held) const;

    /// The moment sum (x - C) f^T [N mm] of forces on the nodes x about the
    /// middle C of some nodes: those of the @p owned unknowns.
    Tensor<2, 3> moment(const Motion        &motion,
                        const GhostedVector &forces,
                        const IndexSet      &owned) const;

    /// The forces on the leaders that a resultant makes [N].
    Vector<double> on_leaders(const Motion    &motion,
                              const Targets   &targets,
                              const PerMotion &resultant) const;

    /**
     * What forces that keep their directions do to the tangent as the boundary
     * turns. With the turns omega_i of the leaders and
     *   V = moment() of the internal forces f - (P - C) F^T
     * with the force F that is applied in P, it is
     *   f . delta^2 u = omega_i . (sym V - tr(V) 1) omega_j   [N/mm],
     * but for what is zero in equilibrium. Left out is the part of a moment,
     * which is not symmetric in 3-D, and what rotations do that are prescribed
     * about one or two axes.
     */
    FullMatrix<double> stiffness(const Motion    &motion,
                                 const Targets   &targets,
                                 Tensor<2, 3>     V,
                                 const PerMotion &applied) const;

    /// The vector of rotation of a motion, or its spin [rad].
    Tensor<1, 3> rotation(const Motion &motion) const;

    /// The displacement of a node in a motion [mm]. R - I comes first: a spin
    /// is small beside I, and the arm would take its digits.
    static Tensor<1, 3> displacement(const Motion &motion, const Node &node)
    {
      Tensor<2, 3> rotation = motion.R;
      for (unsigned int k = 0; k < 3; ++k)
        rotation[k][k] -= 1;
      return motion.U + rotation * node.arm;
    }

    /// The nodal forces of a force and a moment about P.
    std::vector<std::pair<Dof, double>>
    nodal_forces(const Motion &motion, const PerMotion &resultant) const;

    /// The force and the moment about P of nodal forces, those of the @p owned
    /// unknowns.
    PerMotion resultant(const Motion        &motion,
                        const GhostedVector &forces,
                        const IndexSet      &owned) const;

    /// The largest distance of a node from P [mm].
    double extent() const
    {
      double largest = 0;
      for (const Node &node : nodes)
        largest = std::max(largest, node.arm.norm());
      return largest;
    }

  private:
    using Row = Tensor<1, 6>;
    struct Leader
    {
      unsigned int node, component;
    };

    Dof dof(const Leader &leader) const
    {
      return nodes[leader.node].dofs[leader.component];
    }

    /// The derivatives of an unknown by the motions.
    Row row(const Motion &motion, const Leader &unknown) const;

    /// The motions that do not vary: those that are prescribed or missing.
    std::vector<Row> fixed_rows(const Motion  &motion,
                                const Targets &targets) const;

    /// The motions by the leaders: their columns come last.
    Tensor<2, 6> inverse(const Motion &motion, const Targets &targets) const;

    /// C - P of moment() and stiffness().
    Tensor<1, 3> middle(const Motion &motion) const
    {
      Tensor<1, 3> C;
      for (const unsigned int n : frame)
        C += motion.R * nodes[n].arm / double(frame.size());
      return C;
    }

    /// Impose the targets.
    void prescribe(const Targets &targets, Motion &motion) const;

    /// The motion that three nodes tell, in large displacement.
    Motion guess(const GhostedVector &u) const;

    std::array<bool, 6>       is_missing{};
    std::vector<unsigned int> frame; // three nodes, in 2-D two
    std::vector<Leader>       all_leaders;
  };



  template<int dim>
  Tensor<2, 3> RigidBoundary<dim>::moment(const Motion        &motion,
                                          const GhostedVector &forces,
                                          const IndexSet      &owned) const
  {
    const Tensor<1, 3> C = middle(motion);
    Tensor<2, 3>       sum;
    for (const Node &node : nodes)
      for (unsigned int c = 0; c < dim; ++c)
        if (owned.is_element(node.dofs[c]))
          {
            const Tensor<1, 3> arm = motion.R * node.arm - C;
            for (unsigned int i = 0; i < 3; ++i)
              sum[i][c] += arm[i] * forces[node.dofs[c]];
          }
    return sum;
  }



  template<int dim>
  Vector<double>
  RigidBoundary<dim>::on_leaders(const Motion    &motion,
                                 const Targets   &targets,
                                 const PerMotion &resultant) const
  {
    const unsigned int n = all_leaders.size();
    const Tensor<2, 6> A = inverse(motion, targets);
    Vector<double>     forces(n);
    for (unsigned int l = 0; l < n; ++l)
      for (unsigned int k = 0; k < 6; ++k)
        forces[l] += A[k][6 - n + l] * resultant[k];
    return forces;
  }



  template<int dim>
  FullMatrix<double>
  RigidBoundary<dim>::stiffness(const Motion    &motion,
                                const Targets   &targets,
                                Tensor<2, 3>     V,
                                const PerMotion &applied) const
  {
    const Tensor<1, 3> C = middle(motion);
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        V[i][j] += C[i] * applied[j];
    V = 0.5 * (V + transpose(V)) - trace(V) * unit_symmetric_tensor<3>();

    const unsigned int        n = all_leaders.size();
    const Tensor<2, 6>        A = inverse(motion, targets);
    std::vector<Tensor<1, 3>> turns(n);
    for (unsigned int l = 0; l < n; ++l)
      for (unsigned int k = 0; k < 3; ++k)
        turns[l][k] = A[3 + k][6 - n + l];
    FullMatrix<double> stiffness(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        stiffness(i, j) = turns[i] * (V * turns[j]);
    return stiffness;
  }
} // namespace Contact

#endif
