/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cad_entities_h
#define contact_cad_entities_h

#include <deal.II/base/point.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /// Questions to gmsh on the entities of its present model, which are known by
  /// dimension and tag. gmsh throws what it likes: see CadModel.
  namespace CadEntities
  {
    /// A label of the CAD file: the last part of gmsh's name of an entity, with
    /// '_' for characters that separate names in entries. What OpenCASCADE
    /// calls parts without a label is none.
    std::string label_of(const int dim, const int tag);

    std::vector<int> tags_of(const int dim);

    /// What an entity bounds, and what it is bounded by.
    std::pair<std::vector<int>, std::vector<int>> adjacent(const int dim,
                                                           const int tag);

    /// Volume, area or length, of a model of OpenCASCADE.
    double content(const int dim, const int tag);

    /// That of the box around an entity; of the whole model -1, -1.
    double diagonal(const int dim = -1, const int tag = -1);

    /// The place of a surface, curve or point that is closest to X.
    Point<3> closest_place(const int dim, const int tag, const Point<3> &X);

    /// The radius where a boundary is most round, of three places inside: at
    /// its ends are apices of cones and poles.
    double radius(const int dim, const int tag);

    /// Make a physical group, and the tags of all by their names.
    void                                    add_group(const int               dim,
                                                      const std::vector<int> &tags,
                                                      const std::string      &name);
    std::map<std::string, std::vector<int>> find_groups(const int dim);
  } // namespace CadEntities
} // namespace Contact

#endif
