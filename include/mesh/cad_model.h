/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cad_model_h
#define contact_cad_model_h

#include <deal.II/base/point.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "parameters/geometry.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The model that gmsh makes of a CAD file or of a description of its own
   * (.geo): named bodies and boundaries, sizes of cells, and the mesh. One at a
   * time. All members throw InputError.
   *
   * Names are those of physical groups; of a model without, labels of the CAD
   * file (STEP: of parts and faces). Bodies that have none are numbered by
   * volume, the largest first: 'Body 1'. Boundaries are also named by points on
   * them, Mesh/Boundaries.
   *
   * Sizes of a CAD file: that of a body is its volume by its surface (in the
   * plane area by perimeter), two cells across a plate and six along the edge
   * of a cube, or Mesh/Size. A boundary has that of its body, but at least
   * twelve cells a turn where it is round, and half of both on the surfaces of
   * contact: pressures vary along a part of the body alone. Mesh/Sizes goes
   * before all. A .geo has its own sizes, unless these entries are set.
   */
  class CadModel
  {
  public:
    /// Read the file, name its parts and choose their sizes. @p in_contact are
    /// the names of the surfaces of contact.
    CadModel(const std::string           &file,
             const Parameters::Geometry  &parameters,
             const std::set<std::string> &in_contact);

    /// The version of gmsh.
    static std::string version();

    /// Mesh all bodies, which share no node unless they share a boundary in the
    /// CAD file, and write a file in MSH format 4.1.
    void write_mesh(const std::string &msh_file);

    /// Bodies and boundaries, and the sizes that were chosen, in a line.
    std::string describe() const;

  private:
    /// gmsh is one for the whole program.
    struct Session
    {
      Session();
      ~Session();
    };

    /// gmsh's: dimension and tag.
    using Entity = std::pair<int, int>;

    /// The tags of entities by the name of a group.
    using Groups = std::map<std::string, std::vector<int>>;

    void call(const std::function<void()> &work,
              const std::string           &what,
              const std::string           &remedy) const;
    void name_bodies();
    void name_boundaries();
    void name_boundary(const std::string         &key,
                       const std::vector<double> &numbers) const;
    int  boundary_at(const Point<3>    &X,
                     const std::string &name,
                     const Groups      &among) const;
    void choose_sizes(const std::set<std::string> &in_contact);
    void set_size(const Entity &entity, const double size);
    void limit(const Entity &entity, const double size);

    const Session              session;
    const std::string          file;
    const Parameters::Geometry parameters;
    const bool                 is_geo;
    int                        dim;        // of the bodies
    bool                       has_groups; // physical ones, of bodies
    Groups                     bodies, boundaries;
    Groups                     parts; // bodies by their labels

    /// Of bodies, boundaries, curves and points [mm].
    std::map<Entity, double> sizes;
  };
} // namespace Contact

#endif
