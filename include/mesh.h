/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mesh_h
#define contact_mesh_h

#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "parameters.h"

namespace Contact
{
  using namespace dealii;

  /**
   * A straight manifold, except midway between two points of a circle: there
   * it answers with the point of the circle (the mean is moved radially).
   * Serves quadrangles and triangles alike, which the 6-node triangle on an
   * arc needs: MappingFE asks for one manifold for a whole triangle.
   */
  class ArcManifold : public Manifold<2>
  {
  public:
    ArcManifold(const Point<2> &center, const double radius);

    std::unique_ptr<Manifold<2>> clone() const override;

    Point<2>
    get_new_point(const ArrayView<const Point<2>> &surrounding_points,
                  const ArrayView<const double>   &weights) const override;

  private:
    const Point<2> center;
    const double   radius;
  };



  /**
   * The triangulation of all bodies and the names of its parts: bodies are
   * material ids, boundaries are sets of boundary ids (a line may belong to
   * several groups: each combination of groups has an id of its own), points
   * are vertices.
   */
  class Mesh
  {
  public:
    /**
     * Read a gmsh file in MSH format 2.2 or 4.1, ASCII, with physical names.
     * Quadrangles and triangles of first order may be mixed; clockwise cells
     * are turned round; lines inside a body are ignored. Arcs get their
     * manifold, then the mesh is refined. Throws InputError.
     */
    explicit Mesh(const Parameters::Mesh &parameters);

    Triangulation<2>                                    triangulation;
    std::map<std::string, types::material_id>           bodies;
    std::map<std::string, std::set<types::boundary_id>> boundaries;
    std::map<std::string, std::vector<unsigned int>>    points;

    /// The groups below, or an InputError that names the groups there are.
    types::material_id body(const std::string &name,
                            const std::string &entry) const;
    const std::set<types::boundary_id> &
    boundary(const std::string &name, const std::string &entry) const;
    unsigned int point(const std::string &name, const std::string &entry) const;

    /// The name of a body by its id.
    std::string body_name(const types::material_id id) const;

  private:
    /// Lay the lines of a boundary group, and the triangles at it, on a circle.
    void attach_arc(const std::string &name,
                    const Point<2>    &center,
                    const double       radius);
  };
} // namespace Contact

#endif
