/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_patches_h
#define contact_contact_patches_h

#include <deal.II/base/data_out_base.h>

#include <string>
#include <tuple>
#include <vector>

#include "output/profile.h"

namespace Contact
{
  using namespace dealii;

  /// The fields of the file of the slave surfaces, a name for each component:
  /// displacement and gap, shear and slip (vectors in 3-D, along t in
  /// 2-D), pressure and status.
  template<int dim>
  const std::vector<std::string> &contact_fields();

  /// First and last component of each vector among them.
  using VectorFields = std::vector<
    std::tuple<unsigned int,
               unsigned int,
               std::string,
               DataComponentInterpretation::DataComponentInterpretation>>;

  template<int dim>
  VectorFields contact_vectors();

  /// The degree of the cells of this file. As curved lines deal.II 9.4 numbers
  /// their points wrongly: an edge of degree 2 is written as two lines through
  /// its middle node.
  unsigned int contact_cell_degree(const Surface<2> &slave);
  unsigned int contact_cell_degree(const Surface<3> &slave);

  /// The facets of the slave surfaces with these fields, then their position.
  template<int dim>
  std::vector<DataOutBase::Patch<dim - 1, dim>>
  contact_patches(const std::vector<PairProfile<dim>> &pairs);
} // namespace Contact

#endif
