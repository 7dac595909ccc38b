/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cell_tables_h
#define contact_cell_tables_h

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "solid/discretization.h"
#include "solid/materials/kinematics.h"

namespace Contact
{
  using namespace dealii;

  /// Gradients of shape functions on the unit cell, by point, then node. Where
  /// the centre of a quadrangle is bound (of a hexahedron also those of its
  /// faces), they are those of the free nodes, so that the centre costs nothing
  /// in assembly.
  template<int dim>
  using UnitGradients = std::vector<Tensor<1, dim>>;

  template<int dim>
  class CellKernel;

  /// The data of a cell that stay the same on a mesh, but for its history.
  template<int dim>
  struct CellTable
  {
    unsigned int                         active_index;
    types::material_id                   body;
    unsigned int                         piece; // of its body, see MeshPieces
    const Material                      *material;
    const CellKernel<dim>               *kernel;
    std::vector<types::global_dof_index> dofs;          // (x, y, z) by node
    std::vector<double>                  JxW;           // by point
    Point<dim>                           centre;        // X
    double                               area;          // in 3-D the volume
    std::vector<Tensor<2, dim>>          gradient_maps; // J^-T by point
    const UnitGradients<dim>            *unit_gradients;
    std::vector<double>                  hoop_gradients; // N_a/X, of rings

    /// Modes of the projected dilatation: polynomials phi_m with sum_q JxW
    /// phi_m phi_n = delta_mn, by point. Else empty.
    std::vector<std::array<double, dim + 1>> modes;

    /// Stresses of the strains that the cell adds, by point, see
    /// CellIntegrals. Else empty.
    std::vector<std::array<SymmetricTensor<2, 3>, dim * dim>> stress_modes;

    /// Whether it has those, or is not elastic: its work is counted apart.
    bool is_special = false;

    /// Of its points at the start of the increment, see MaterialLaw. Else
    /// empty.
    std::vector<double> history;

    /// The thermal strain [-] at the start of the increment and now, by the
    /// measure of the kinematics.
    double thermal_before = 0, thermal = 0;

    /// The equivalent plastic strain at a point [-].
    double plastic_strain(const unsigned int q) const
    {
      return history.empty() ? 0. : history[q * (history.size() / JxW.size())];
    }

    unsigned int n_nodes() const
    {
      return dofs.size() / dim;
    }

    /// The unit gradients of the nodes at a point. Those with respect to the
    /// reference configuration are gradient_maps[q] times these.
    const Tensor<1, dim> *unit_gradients_at(const unsigned int q) const
    {
      return unit_gradients->data() + q * n_nodes();
    }

    /// The first nodes are the corners.
    unsigned int n_corners() const
    {
      const unsigned int of_simplex = dim + 1;
      return n_nodes() == of_simplex ||
                 n_nodes() == of_simplex * (of_simplex + 1) / 2
               ? of_simplex
               : GeometryInfo<dim>::vertices_per_cell;
    }
  };



  /// The cells of this rank, and the neighbors' cells beside them.
  template<int dim>
  struct CellTables
  {
    std::vector<CellTable<dim>> own, neighbors;

    /// By element and, for each node, what bound ones hand over to it.
    using Pattern =
      std::pair<unsigned int,
                std::vector<std::vector<std::pair<unsigned int, double>>>>;
    std::map<Pattern, UnitGradients<dim>> unit_gradients;
  };

  /// A body of a material that is linear elastic or St. Venant and Kirchhoff's.
  struct ElasticBody
  {
    Material material;
    bool     is_small_strain        = false;
    bool     is_projected           = false; // its dilatation
    bool     has_incompatible_modes = false;
  };

  /// The number of the modes of a projected dilatation: one, in quadrangles and
  /// hexahedra of degree 2 dim + 1.
  template<int dim>
  unsigned int n_dilatation_modes(const FiniteElement<dim> &fe)
  {
    return fe.degree == 2 && fe.reference_cell().is_hyper_cube() ? dim + 1 : 1;
  }

  /// The modes of the projected dilatation of a cell, by point, see CellTable;
  /// none if there are as many as points, where projecting changes nothing.
  template<int dim>
  std::vector<std::array<double, dim + 1>>
  dilatation_modes(const FiniteElement<dim>  &fe,
                   const Quadrature<dim>     &quadrature,
                   const std::vector<double> &JxW);

  /// The stresses of the incompatible modes of a cell, of which the maps of
  /// gradients, JxW and the material are known, by point: see CellIntegrals.
  template<int dim>
  std::vector<std::array<SymmetricTensor<2, 3>, dim * dim>>
  stress_modes(const Quadrature<dim> &quadrature, const CellTable<dim> &cell);

  /// Tabulate the cells. Those of bodies that are @p projected get modes of
  /// the dilatation, those of @p enhanced ones stress modes. Throws InputError
  /// if a triangle is enhanced. The tables point to @p materials, which have to
  /// outlive them.
  template<int dim>
  CellTables<dim>
  tabulate_cells(const Discretization<dim>                    &discretization,
                 const std::map<types::material_id, Material> &materials,
                 const std::set<types::material_id>           &projected,
                 const std::set<types::material_id>           &enhanced);
} // namespace Contact

#endif
