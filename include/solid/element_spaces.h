/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_element_spaces_h
#define contact_element_spaces_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/hp/fe_collection.h>
#include <deal.II/hp/mapping_collection.h>
#include <deal.II/hp/q_collection.h>

#include "mesh/mesh.h"

namespace Contact
{
  using namespace dealii;

  /// The mappings, elements and quadratures {for quadrangles, for triangles},
  /// or for hexahedra, of a degree.
  template<int dim>
  hp::MappingCollection<dim> make_mapping(const unsigned int degree);

  template<int dim>
  hp::FECollection<dim> make_fe(const unsigned int degree);

  template<int dim>
  hp::QCollection<dim> make_quadrature(const unsigned int degree);

  /// Number the unknowns of a collection {for quadrangles, for triangles}. A
  /// mesh of quadrangles or hexahedra alone takes the first element for all
  /// cells.
  template<int dim>
  void distribute_dofs(const Mesh<dim>             &mesh,
                       const hp::FECollection<dim> &fe,
                       DoFHandler<dim>             &dof_handler);
} // namespace Contact

#endif
