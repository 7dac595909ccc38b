/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/patch_recovery.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace Contact
{
  namespace
  {
    /// The undeformed places of all nodes, by unknown [mm].
    std::vector<Point<2>>
    support_points(const Discretization<2> &discretization)
    {
      std::vector<Point<2>> points(discretization.dof_handler.n_dofs());
      DoFTools::map_dofs_to_support_points(discretization.mapping,
                                           discretization.dof_handler,
                                           points);
      return points;
    }



    /// The values of the vertex shape functions of a cell in the support points
    /// of an element: by support point and vertex.
    using HatValues = std::vector<std::vector<double>>;

    HatValues hat_values(const FiniteElement<2>      &fe,
                         const std::vector<Point<2>> &vertices)
    {
      const ReferenceCell reference = fe.reference_cell();
      HatValues           hats(fe.dofs_per_cell);
      for (unsigned int i = 0; i < fe.dofs_per_cell; ++i)
        {
          Point<2> in_cell;
          for (unsigned int v = 0; v < vertices.size(); ++v)
            in_cell +=
              reference.d_linear_shape_function(fe.unit_support_point(i), v) *
              vertices[v];
          for (unsigned int v = 0; v < vertices.size(); ++v)
            hats[i].push_back(reference.d_linear_shape_function(in_cell, v));
        }
      return hats;
    }



    /// Those of the children of a cell.
    std::vector<HatValues> hat_values(const FiniteElement<2> &fe)
    {
      Triangulation<2> triangulation;
      GridGenerator::reference_cell(triangulation, fe.reference_cell());
      const auto cell = triangulation.begin();
      triangulation.refine_global(1);

      const auto vertices_of = [](const auto &of) {
        std::vector<Point<2>> vertices;
        for (const unsigned int v : of->vertex_indices())
          vertices.push_back(of->vertex(v));
        return vertices;
      };
      std::vector<HatValues> hats;
      for (unsigned int c = 0; c < cell->n_children(); ++c)
        hats.push_back(hat_values(fe, vertices_of(cell->child(c))));
      return hats;
    }
  } // namespace



  PatchRecovery::PatchRecovery(const Discretization<2>          &discretization,
                               const std::vector<GhostedVector> &fields)
    : discretization(discretization)
    , n_fields(fields.size())
  {
    const auto  X        = support_points(discretization);
    const auto &vertices = discretization.mesh.triangulation.get_vertices();
    for (const auto &[key, cells] : find_patches())
      patches[key] = fit(vertices[key.second], cells, X, fields);
  }



  std::map<PatchRecovery::Key, PatchRecovery::Cells>
  PatchRecovery::find_patches() const
  {
    std::map<Key, Cells> at_vertex;
    std::set<Key>        on_boundary;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      {
        const auto body = cell->material_id();
        for (const unsigned int v : cell->vertex_indices())
          at_vertex[{body, cell->vertex_index(v)}].insert(cell);
        for (const unsigned int f : cell->face_indices())
          if (cell->at_boundary(f) || cell->neighbor(f)->material_id() != body)
            for (const unsigned int v : cell->face(f)->vertex_indices())
              on_boundary.insert({body, cell->face(f)->vertex_index(v)});
      }

    std::map<Key, Cells> found = at_vertex;
    for (const Key &key : on_boundary)
      for (const auto &cell : at_vertex[key])
        for (const unsigned int v : cell->vertex_indices())
          {
            const Cells &more = at_vertex[{key.first, cell->vertex_index(v)}];
            found[key].insert(more.begin(), more.end());
          }
    return found;
  }



  // Normal equations: in scaled coordinates they are well conditioned. A body
  // one cell thick does not determine all coefficients; those of least norm are
  // as good as any.
  PatchRecovery::Patch
  PatchRecovery::fit(const Point<2>                   &center,
                     const Cells                      &cells,
                     const std::vector<Point<2>>      &X,
                     const std::vector<GhostedVector> &fields) const
  {
    std::map<types::global_dof_index, types::global_dof_index> nodes;
    std::vector<types::global_dof_index>                       dofs;
    Patch                                                      patch;
    patch.center = center;
    patch.size   = 0;
    for (const auto &cell : cells)
      {
        const auto &fe = cell->get_fe();
        dofs.resize(fe.dofs_per_cell);
        cell->get_dof_indices(dofs);
        std::array<std::vector<types::global_dof_index>, 2> by_component;
        for (unsigned int i = 0; i < dofs.size(); ++i)
          by_component[fe.system_to_component_index(i).first].push_back(
            dofs[i]);
        for (unsigned int a = 0; a < by_component[0].size(); ++a)
          {
            const auto dof = by_component[0][a];
            nodes[dof]     = by_component[1][a];
            patch.size     = std::max(patch.size, center.distance(X[dof]));
          }
      }

    const unsigned int       n = monomials(center, patch).size();
    LAPACKFullMatrix<double> gram(n), projections(n, 2 * n_fields);
    for (const auto &[x, y] : nodes)
      {
        const auto values = monomials(X[x], patch);
        for (unsigned int i = 0; i < n; ++i)
          {
            for (unsigned int j = 0; j < n; ++j)
              gram(i, j) += values[i] * values[j];
            for (unsigned int k = 0; k < n_fields; ++k)
              {
                projections(i, 2 * k) += values[i] * fields[k][x];
                projections(i, 2 * k + 1) += values[i] * fields[k][y];
              }
          }
      }
    const double round_off = 1e-12;
    for (unsigned int i = 0; i < n; ++i)
      gram(i, i) += round_off * nodes.size();
    gram.set_property(LAPACKSupport::symmetric);
    gram.compute_cholesky_factorization();
    gram.solve(projections);

    patch.coefficients.assign(2 * n_fields, std::vector<double>(n));
    for (unsigned int k = 0; k < 2 * n_fields; ++k)
      for (unsigned int i = 0; i < n; ++i)
        patch.coefficients[k][i] = projections(i, k);
    return patch;
  }



  std::vector<double> PatchRecovery::monomials(const Point<2> &X,
                                               const Patch    &patch) const
  {
    const Tensor<1, 2>  s = (X - patch.center) / patch.size;
    std::vector<double> values{1.};
    values.reserve(10); // of degree three
    // Of each degree: those of the one before times x, and the power of y.
    for (unsigned int d = 1; d <= discretization.degree + 1; ++d)
      {
        const std::size_t first = values.size() - d;
        for (unsigned int i = 0; i < d; ++i)
          values.push_back(values[first + i] * s[0]);
        values.push_back(values[first + d - 1] * s[1]);
      }
    return values;
  }



  void PatchRecovery::add_values(const Point<2>             &X,
                                 const Patch                &patch,
                                 const double                factor,
                                 const NodeDoFs<2>          &node,
                                 std::vector<GhostedVector> &values) const
  {
    const auto shapes = monomials(X, patch);
    for (unsigned int k = 0; k < n_fields; ++k)
      for (unsigned int c = 0; c < 2; ++c)
        values[k][node[c]] +=
          factor * std::inner_product(shapes.begin(),
                                      shapes.end(),
                                      patch.coefficients[2 * k + c].begin(),
                                      0.);
  }



  // Polynomials of neighbours are blended continuously: a node that cells share
  // has the same value from all of them.
  std::vector<GhostedVector>
  PatchRecovery::values(const Discretization<2> &refined) const
  {
    std::vector<std::vector<HatValues>> hats;
    for (unsigned int e = 0; e < refined.fe.size(); ++e)
      hats.push_back(hat_values(refined.fe[e]));

    const auto                           X = support_points(refined);
    std::vector<GhostedVector>           values(n_fields,
                                      GhostedVector(
                                        refined.dof_handler.n_dofs()));
    std::vector<bool>                    is_known(X.size(), false);
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : refined.dof_handler.active_cell_iterators())
      {
        const auto  &fe     = cell->get_fe();
        const auto   parent = cell->parent();
        unsigned int child  = 0;
        while (parent->child(child) != cell)
          ++child;
        std::vector<const Patch *> around;
        for (const unsigned int v : parent->vertex_indices())
          around.push_back(
            &patches.at({cell->material_id(), parent->vertex_index(v)}));
        dofs.resize(fe.dofs_per_cell);
        cell->get_dof_indices(dofs);
        for (unsigned int n = 0; n < fe.base_element(0).dofs_per_cell; ++n)
          {
            const unsigned int i   = fe.component_to_system_index(0, n);
            const auto         x   = dofs[i];
            const auto         y   = dofs[fe.component_to_system_index(1, n)];
            const auto        &hat = hats[cell->active_fe_index()][child][i];
            if (is_known[x])
              continue;
            is_known[x] = true;
            for (unsigned int v = 0; v < around.size(); ++v)
              if (hat[v] != 0)
                add_values(X[x], *around[v], hat[v], {{x, y}}, values);
          }
      }
    return values;
  }
} // namespace Contact
