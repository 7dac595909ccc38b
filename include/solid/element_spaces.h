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

  /// The mappings, elements and quadratures of a degree for the kinds of cells
  /// that a mesh has: quadrangles before triangles, hexahedra before
  /// tetrahedra.
  template<int dim>
  hp::MappingCollection<dim> make_mapping(const Mesh<dim>   &mesh,
                                          const unsigned int degree);

  template<int dim>
  hp::FECollection<dim> make_fe(const Mesh<dim>   &mesh,
                                const unsigned int degree);

  template<int dim>
  hp::QCollection<dim> make_quadrature(const Mesh<dim>   &mesh,
                                       const unsigned int degree);

  /// Those of the faces of these cells, exact for polynomials of degree
  /// 2 degree + 1.
  template<int dim>
  hp::QCollection<dim - 1> make_face_quadrature(const Mesh<dim>   &mesh,
                                                const unsigned int degree);

  /// Number the unknowns of such a collection.
  template<int dim>
  void distribute_dofs(const hp::FECollection<dim> &fe,
                       DoFHandler<dim>             &dof_handler);

  /// Throws InputError on the rank that owns a triangle or tetrahedron which
  /// its curved sides turn inside out at one of its nodes. Of degree 2.
  template<int dim>
  void check_curved_simplices(const DoFHandler<dim>            &dof_handler,
                              const hp::MappingCollection<dim> &mapping);
} // namespace Contact

#endif
