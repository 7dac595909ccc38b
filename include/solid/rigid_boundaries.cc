/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/rigid_boundaries.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solid/rotations.h"

namespace Contact
{
  namespace
  {
    /// Below this part of a row it follows from others.
    const double smallest_rest = 1e-10;

    const double few_digits = 64 * std::numeric_limits<double>::epsilon();

    /// Orthonormal rows, with rotations by the way of the farthest node.
    struct Basis
    {
      const double              farthest; // [mm]
      std::vector<Tensor<1, 6>> rows;

      /// The part of a row beside these.
      Tensor<1, 6> rest(Tensor<1, 6> row) const
      {
        for (unsigned int k = 3; k < 6; ++k)
          row[k] /= farthest;
        for (unsigned int pass = 0; pass < 2; ++pass) // because of round-off
          for (const Tensor<1, 6> &other : rows)
            row -= (row * other) * other;
        return row;
      }

      void add(const Tensor<1, 6> &rest)
      {
        rows.push_back(rest / rest.norm());
      }
    };
  } // namespace



  template<int dim>
  RigidBoundary<dim>::RigidBoundary(const std::string       &name,
                                    const std::vector<Node> &nodes,
                                    const bool               is_large,
                                    const bool               is_ring)
    : name(name)
    , nodes(nodes)
    , is_large(is_large)
  {
    // The node that is the farthest from the first one, then that with the
    // largest triangle.
    const auto add_farthest = [&](const auto &distance) {
      unsigned int best = 0;
      for (unsigned int n = 0; n < nodes.size(); ++n)
        if (distance(n) > (1 + smallest_rest) * distance(best))
          best = n;
      frame.push_back(best);
    };
    frame = {0};
    add_farthest([&](const unsigned int n) {
      return (nodes[n].arm - nodes[0].arm).norm();
    });
    if (dim == 2)
      is_missing = {{is_ring, false, true, true, true, is_ring}};
    else
      add_farthest([&](const unsigned int n) {
        return cross_product_3d(nodes[n].arm - nodes[0].arm,
                                nodes[frame[1]].arm - nodes[0].arm)
          .norm();
      });
  }



  template<int dim>
  typename RigidBoundary<dim>::Row
  RigidBoundary<dim>::row(const Motion &motion, const Leader &unknown) const
  {
    const Tensor<1, 3> &arm = nodes[unknown.node].arm;
    const Tensor<2, 3>  W   = spin(is_large ? motion.R * arm : arm);
    Row                 row;
    row[unknown.component] = 1;
    for (unsigned int k = 0; k < 3; ++k)
      row[3 + k] = -W[unknown.component][k]; // omega x r = -r x omega
    return row;
  }



  template<int dim>
  Tensor<1, 3> RigidBoundary<dim>::rotation(const Motion &motion) const
  {
    return is_large ? rotation_vector(motion.R) : axis(motion.R);
  }



  // Rotations that are all prescribed do not vary about any axis.
  template<int dim>
  std::vector<typename RigidBoundary<dim>::Row>
  RigidBoundary<dim>::fixed_rows(const Motion  &motion,
                                 const Targets &targets) const
  {
    Tensor<2, 3> of_vector = identity();
    if (dim == 3 && is_large)
      of_vector = change_of_vector(rotation_vector(motion.R));
    const auto is_fixed = [&](const unsigned int k) {
      return is_missing[k] || targets.is_prescribed[k];
    };
    if (is_fixed(3) && is_fixed(4) && is_fixed(5))
      of_vector = identity();
    std::vector<Row> rows;
    for (unsigned int k = 0; k < 6; ++k)
      if (is_fixed(k))
        {
          Row row;
          for (unsigned int j = 0; j < 3; ++j)
            if (k < 3)
              row[j] = j == k;
            else
              row[3 + j] = of_vector[k - 3][j];
          rows.push_back(row);
        }
    return rows;
  }



  // Gram and Schmidt, with the largest rest next.
  template<int dim>
  std::vector<types::global_dof_index>
  RigidBoundary<dim>::choose_leaders(const Motion        &motion,
                                     const Targets       &targets,
                                     const std::set<Dof> &held)
  {
    Basis basis{extent(), {}};
    for (const Row &row : fixed_rows(motion, targets))
      basis.add(basis.rest(row));
    all_leaders.clear();
    std::vector<Dof>    dependent;
    std::vector<Leader> others;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const Leader unknown{n, c};
          if (held.count(dof(unknown)) == 0)
            {
              others.push_back(unknown);
              continue;
            }
          const Row rest = basis.rest(row(motion, unknown));
          if (rest.norm() > smallest_rest)
            {
              basis.add(rest);
              all_leaders.push_back(unknown);
            }
          else
            dependent.push_back(dof(unknown));
        }
    while (basis.rows.size() < 6)
      {
        Row    largest;
        Leader best{};
        for (const Leader &unknown : others)
          if (const Row rest = basis.rest(row(motion, unknown));
              rest.norm() > (1 + smallest_rest) * largest.norm())
            {
              largest = rest;
              best    = unknown;
            }
        Assert(largest.norm() > smallest_rest, ExcInternalError());
        basis.add(largest);
        all_leaders.push_back(best);
      }
    return dependent;
  }



  template<int dim>
  double RigidBoundary<dim>::quality(const Motion  &motion,
                                     const Targets &targets) const
  {
    std::vector<Row> rows = fixed_rows(motion, targets);
    for (const Leader &leader : all_leaders)
      rows.push_back(row(motion, leader));
    const Basis none{extent(), {}};
    Basis       basis    = none;
    double      smallest = 1;
    for (const Row &row : rows)
      {
        const Row rest = basis.rest(row);
        smallest = std::min(rest.norm() / none.rest(row).norm(), smallest);
        basis.add(rest);
      }
    return smallest;
  }



  template<int dim>
  std::vector<types::global_dof_index> RigidBoundary<dim>::leaders() const
  {
    std::vector<Dof> dofs;
    for (const Leader &leader : all_leaders)
      dofs.push_back(dof(leader));
    return dofs;
  }



  template<int dim>
  Tensor<2, 6> RigidBoundary<dim>::inverse(const Motion  &motion,
                                           const Targets &targets) const
  {
    std::vector<Row> rows = fixed_rows(motion, targets);
    for (const Leader &leader : all_leaders)
      rows.push_back(row(motion, leader));
    Tensor<2, 6>       A;
    FullMatrix<double> matrix(6);
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        matrix(i, j) = rows.at(i)[j];
    matrix.gauss_jordan();
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        A[i][j] = matrix(i, j);
    return A;
  }



  template<int dim>
  void RigidBoundary<dim>::prescribe(const Targets &targets,
                                     Motion        &motion) const
  {
    Tensor<1, 3> phi     = rotation(motion);
    bool         rotates = false;
    for (unsigned int k = 0; k < 3; ++k)
      {
        if (is_missing[k] || targets.is_prescribed[k])
          motion.U[k] = targets.value[k];
        if (is_missing[3 + k] || targets.is_prescribed[3 + k])
          {
            phi[k]  = targets.value[3 + k];
            rotates = rotates || targets.is_prescribed[3 + k] || is_missing[5];
          }
      }
    if (rotates)
      motion.R = is_large ? rotation_by(phi) : identity() + spin(phi);
  }



  template<int dim>
  typename RigidBoundary<dim>::Motion
  RigidBoundary<dim>::guess(const GhostedVector &u) const
  {
    Motion motion{{}, identity()};
    if (!is_large)
      return motion;
    const auto moved = [&](const unsigned int n) {
      Tensor<1, 3> x = nodes[n].arm;
      for (unsigned int c = 0; c < dim; ++c)
        x[c] += u[nodes[n].dofs[c]];
      return x;
    };
    const auto axes = [&](const auto &place) {
      const Tensor<1, 3> origin = place(frame[0]);
      Tensor<1, 3>       e[3];
      e[0] = place(frame[1]) - origin;
      e[0] /= e[0].norm();
      e[2][2] = 1;
      if (dim == 3)
        e[2] = cross_product_3d(e[0], place(frame[2]) - origin);
      e[2] /= e[2].norm();
      e[1] = cross_product_3d(e[2], e[0]);
      Tensor<2, 3> Q;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          Q[i][j] = e[j][i];
      return Q;
    };
    motion.R =
      axes(moved) *
      transpose(axes([&](const unsigned int n) { return nodes[n].arm; }));
    motion.U = moved(frame[0]) - motion.R * nodes[frame[0]].arm;
    return motion;
  }



  // Newton's method, without which the leaders and the targets would be met but
  // to the first order. Where a step has moved leaders too far for any motion,
  // three nodes tell it.
  template<int dim>
  typename RigidBoundary<dim>::Motion
  RigidBoundary<dim>::motion(const GhostedVector &u,
                             const Targets       &targets) const
  {
    const unsigned int max_steps = 20;
    Motion             first     = guess(u);
    prescribe(targets, first);
    Motion motion = first;
    for (unsigned int step = 0; step < max_steps; ++step)
      {
        const Tensor<2, 6> A = inverse(motion, targets);
        Row                rest, change;
        for (unsigned int l = 0; l < all_leaders.size(); ++l)
          {
            const auto [n, c] = all_leaders[l];
            rest[6 - all_leaders.size() + l] =
              u[nodes[n].dofs[c]] - displacement(motion, nodes[n])[c];
          }
        change = A * rest;
        Tensor<1, 3> omega;
        for (unsigned int k = 0; k < 3; ++k)
          {
            motion.U[k] += change[k];
            omega[k] = change[3 + k];
          }
        motion.R =
          is_large ? rotation_by(omega) * motion.R : motion.R + spin(omega);
        prescribe(targets, motion);
        if (!is_large ||
            rest.norm() <= few_digits * (extent() + motion.U.norm()))
          return motion;
      }
    return first;
  }



  // In large displacement a factor that is zero now gets room in the pattern of
  // matrices.
  template<int dim>
  std::vector<typename RigidBoundary<dim>::Line>
  RigidBoundary<dim>::lines(const GhostedVector &u,
                            const Targets       &targets,
                            const std::set<Dof> &held) const
  {
    const Motion       motion = this->motion(u, targets);
    const Tensor<2, 6> A      = inverse(motion, targets);
    const auto         leads  = leaders();
    const unsigned int first  = 6 - leads.size();
    const double       length = extent();
    std::vector<Line>  lines;
    for (unsigned int n = 0; n < nodes.size(); ++n)
      {
        const Tensor<1, 3> moved = displacement(motion, nodes[n]);
        for (unsigned int c = 0; c < dim; ++c)
          {
            Line line{nodes[n].dofs[c], {}};
            if (held.count(line.dof) > 0 ||
                std::count(leads.begin(), leads.end(), line.dof) > 0)
              continue;
            const Row row = this->row(motion, {n, c});
            for (unsigned int l = 0; l < leads.size(); ++l)
              {
                double factor = 0;
                for (unsigned int k = 0; k < 6; ++k)
                  factor += row[k] * A[k][first + l];
                if (is_large || std::abs(factor) > smallest_rest)
                  line.entries.emplace_back(
                    leads[l],
                    factor != 0 ? factor : std::numeric_limits<double>::min());
              }
            const double way = moved[c] - u[line.dof];
            if (std::abs(way) >
                few_digits *
                  (std::abs(u[line.dof]) + motion.U.norm() +
                   (moved - motion.U).norm() + (is_large ? length : 0.)))
              line.inhomogeneity = way;
            lines.push_back(line);
          }
      }
    return lines;
  }



  // Forces in the space of the rows: f = B (B^T B)^-1 g.
  template<int dim>
  std::vector<std::pair<types::global_dof_index, double>>
  RigidBoundary<dim>::nodal_forces(const Motion    &motion,
                                   const PerMotion &resultant) const
  {
    FullMatrix<double> squares(6);
    for (unsigned int k = 0; k < 6; ++k)
      squares(k, k) = is_missing[k];
    const auto visit = [&](const auto &visitor) {
      for (const unsigned int n : frame)
        for (unsigned int c = 0; c < dim; ++c)
          if (!is_missing[c])
            visitor(nodes[n].dofs[c], row(motion, {n, c}));
    };
    visit([&](const Dof, const Row &row) {
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          if (!is_missing[i] && !is_missing[j])
            squares(i, j) += row[i] * row[j];
    });
    squares.gauss_jordan();
    Row g;
    for (unsigned int i = 0; i < 6; ++i)
      for (unsigned int j = 0; j < 6; ++j)
        g[i] += squares(i, j) * resultant[j];
    std::vector<std::pair<Dof, double>> forces;
    visit([&](const Dof dof, const Row &row) {
      forces.emplace_back(dof, row * g);
    });
    return forces;
  }



  template<int dim>
  typename RigidBoundary<dim>::PerMotion
  RigidBoundary<dim>::resultant(const Motion        &motion,
                                const GhostedVector &forces,
                                const IndexSet      &owned) const
  {
    PerMotion sum{};
    for (unsigned int n = 0; n < nodes.size(); ++n)
      for (unsigned int c = 0; c < dim; ++c)
        if (owned.is_element(nodes[n].dofs[c]))
          {
            const Row row = this->row(motion, {n, c});
            for (unsigned int k = 0; k < 6; ++k)
              sum[k] += row[k] * forces[nodes[n].dofs[c]];
          }
    return sum;
  }

  template class RigidBoundary<2>;
  template class RigidBoundary<3>;
} // namespace Contact
