/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_body_materials_h
#define contact_body_materials_h

#include <deal.II/base/types.h>

#include <map>
#include <memory>
#include <set>
#include <string>

#include "mesh/mesh.h"
#include "parameters/parameters_scene.h"
#include "solid/materials/kinematics.h"
#include "solid/materials/material_law.h"

namespace Contact
{
  using namespace dealii;

  /// The moduli of the bodies, of those that are not linear at zero strain.
  /// Throws InputError if the names are not those of the mesh.
  template<int dim>
  std::map<types::material_id, Material>
  find_materials(const Mesh<dim> &mesh, const Parameters::Solids &parameters);

  /// The materials of the bodies.
  std::map<types::material_id, std::unique_ptr<MaterialLaw>>
  make_laws(const std::map<std::string, types::material_id> &bodies,
            const std::map<types::material_id, Material>    &materials,
            const Parameters::Solids                        &parameters);

  /// The bodies whose dilatation is projected: those that are, or become,
  /// nearly incompressible, unless their strains are @p enhanced.
  std::set<types::material_id> find_projected(
    const std::map<types::material_id, Material>                     &materials,
    const std::map<types::material_id, std::unique_ptr<MaterialLaw>> &laws,
    const Parameters::Dilatation        dilatation,
    const std::set<types::material_id> &enhanced);
} // namespace Contact

#endif
