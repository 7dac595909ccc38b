/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mesh_h
#define contact_mesh_h

#include <deal.II/base/mpi.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "parameters.h"

namespace Contact
{
  using namespace dealii;

  /**
   * A boundary that is an arc of a circle: the circle and the chords of the
   * arc, which are its lines before any refinement. Between the ends of one
   * chord the boundary is round.
   */
  struct Arc
  {
    Point<2>                             center;
    double                               radius;
    std::vector<std::array<Point<2>, 2>> chords;

    /// How far from the circle a point of the arc may lie, by the radius: the
    /// digits an ASCII mesh may be short of, yet far less than an edge rises.
    static constexpr double tolerance = 1e-5;

    /// How far from the circle a point lies, by the radius.
    double misfit(const Point<2> &p) const;

    /// Whether a point lies on the circle.
    bool on_circle(const Point<2> &p) const;

    /// Whether two points lie on the piece of the circle over one chord.
    bool over_one_chord(const Point<2> &p, const Point<2> &q) const;
  };



  /**
   * A straight manifold, except between two points of the same piece of an
   * arc: there it answers with the point of the circle (the weighted mean is
   * moved radially).
   *
   * It serves quadrangles and triangles alike. The 6-node triangle on an arc
   * is why it has to be straight everywhere else: MappingFE asks for one
   * manifold for a whole triangle and its lines, hence (a line has two sides)
   * for all triangles that hang together, so one such object serves all arcs.
   * And it is why the chords have to be known: two points of a circle may as
   * well be joined by a line inside the body, or by another boundary that was
   * not said to be round.
   */
  class ArcManifold : public Manifold<2>
  {
  public:
    explicit ArcManifold(const std::vector<Arc> &arcs);

    std::unique_ptr<Manifold<2>> clone() const override;

    Point<2>
    get_new_point(const ArrayView<const Point<2>> &surrounding_points,
                  const ArrayView<const double>   &weights) const override;

  private:
    const std::vector<Arc> arcs;
  };



  /**
   * Where the points of the file are in the program: a body's own move, then
   * for all of them scale, rotation about the origin and shift. Without any of
   * these it changes no bit.
   */
  class Placement
  {
  public:
    /// Throws InputError if a body to be moved is not in @p bodies.
    Placement(const Parameters::Mesh                          &parameters,
              const std::map<std::string, types::material_id> &bodies);

    /// A point of the file that belongs to a body [mm].
    Point<2> operator()(const Point<2> &p, const types::material_id body) const;

    /// Factor of all lengths [-].
    const double scale;

    /// Whether two bodies are moved alike, and stay together.
    bool move_alike(const types::material_id a,
                    const types::material_id b) const;

  private:
    double                    cosine, sine;
    Tensor<1, 2>              shift;
    std::vector<Tensor<1, 2>> moves; // by body
  };



  struct MshFile;

  /**
   * The triangulation of all bodies and the names of its parts: bodies are
   * material ids (0, 1, ... in the order of gmsh's tags), boundaries are sets
   * of boundary ids (a line may belong to several groups: each combination of
   * groups has an id of its own; what is in no named group has the id 0),
   * points are vertices.
   *
   * Two nodes of the file stay two vertices even if they lie at the same
   * place, as those of two bodies that touch in a point do.
   */
  class Mesh
  {
  public:
    /**
     * Read a gmsh file in MSH format 2.2 or 4.1, ASCII, with physical names.
     * Quadrangles and triangles may be mixed; of elements of second order only
     * the corners are used; clockwise cells are turned round; lines inside a
     * body are ignored. Bodies are moved and the whole is placed, arcs get
     * their manifold, then the mesh is refined.
     * Throws InputError.
     */
    explicit Mesh(const Parameters::Mesh &parameters,
                  const MPI_Comm          communicator = MPI_COMM_SELF);

    /// Of all ranks that have a part of the mesh.
    const MPI_Comm communicator;

  private:
    // Before the reference to it.
    std::unique_ptr<Triangulation<2>> owned_triangulation;

  public:
    /**
     * On one rank a Triangulation. On several, quadrangles alone make a
     * parallel::distributed one (p4est), of which a rank has its own cells and
     * their neighbors; a mesh with triangles a parallel::shared one, of which
     * every rank has all cells.
     */
    Triangulation<2>                                   &triangulation;
    std::map<std::string, types::material_id>           bodies;
    std::map<std::string, std::set<types::boundary_id>> boundaries;

    /// A group of several points is numbers::invalid_unsigned_int; points
    /// which are no corners of cells are left out.
    std::map<std::string, unsigned int> points;

    /// The groups above, or an InputError which says what there is instead.
    /// @p entry is the entry of the parameters that names the group.
    types::material_id body(const std::string &name,
                            const std::string &entry) const;
    const std::set<types::boundary_id> &
    boundary(const std::string &name, const std::string &entry) const;
    unsigned int point(const std::string &name, const std::string &entry) const;

    /// Whether there are no triangles, so that cells can be refined one by one.
    bool is_all_quadrilateral() const;

    /// Whether this rank has the whole mesh.
    bool is_complete() const;

    /// The name of a body by its id.
    std::string body_name(const types::material_id id) const;

  private:
    Mesh(const Parameters::Mesh &parameters,
         const MshFile          &msh,
         const MPI_Comm          communicator);

    /// Make the boundaries of @p parameters round, whose lines are straight.
    /// An arc belongs to the body that it bounds, and moves with it.
    void set_arcs(const Parameters::Mesh &parameters,
                  const Placement        &placement);
  };


  // ------------------------------------------------------------------
  // Arc and ArcManifold, inline

  inline double Arc::misfit(const Point<2> &p) const
  {
    return std::abs(p.distance(center) - radius) / radius;
  }



  inline bool Arc::on_circle(const Point<2> &p) const
  {
    return misfit(p) < tolerance;
  }



  inline bool Arc::over_one_chord(const Point<2> &p, const Point<2> &q) const
  {
    // Of the points of the circle, those beyond the chord as seen from the
    // centre are the piece over it. The ends are on the chord up to round-off.
    const auto beyond = [this](const Point<2> &a, const auto &chord) {
      const Tensor<1, 2> ray = 0.5 * (chord[0] - center + (chord[1] - center));
      return (a - center - ray) * ray > -1e-10 * radius * radius;
    };

    return on_circle(p) && on_circle(q) &&
           std::any_of(chords.begin(), chords.end(), [&](const auto &chord) {
             return beyond(p, chord) && beyond(q, chord);
           });
  }



  inline ArcManifold::ArcManifold(const std::vector<Arc> &arcs)
    : arcs(arcs)
  {
  }



  inline std::unique_ptr<Manifold<2>> ArcManifold::clone() const
  {
    return std::make_unique<ArcManifold>(arcs);
  }



  inline Point<2> ArcManifold::get_new_point(
    const ArrayView<const Point<2>> &surrounding_points,
    const ArrayView<const double>   &weights) const
  {
    // The corners of a triangle are all handed over, with the weight zero for
    // the one opposite to a mid-side.
    Point<2>                    mean;
    std::array<unsigned int, 2> ends           = {};
    unsigned int                n_contributing = 0;
    for (unsigned int i = 0; i < weights.size(); ++i)
      if (std::abs(weights[i]) > 1e-12)
        {
          mean += weights[i] * surrounding_points[i];
          if (n_contributing < 2)
            ends[n_contributing] = i;
          ++n_contributing;
        }

    if (n_contributing == 2)
      {
        // Where two arcs touch, a point can lie on both up to the tolerance:
        // the one that fits better is meant.
        const Point<2> &p      = surrounding_points[ends[0]];
        const Point<2> &q      = surrounding_points[ends[1]];
        const auto      misfit = [&](const Arc &arc) {
          return std::max(arc.misfit(p), arc.misfit(q));
        };
        const Arc *best = nullptr;
        for (const Arc &arc : arcs)
          if (arc.over_one_chord(p, q) &&
              (best == nullptr || misfit(arc) < misfit(*best)))
            best = &arc;
        if (best != nullptr)
          {
            const Tensor<1, 2> ray = mean - best->center;
            return best->center + best->radius / ray.norm() * ray;
          }
      }
    return mean;
  }
} // namespace Contact

#endif
