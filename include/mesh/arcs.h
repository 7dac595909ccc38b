/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_arcs_h
#define contact_arcs_h

#include <deal.II/base/point.h>
#include <deal.II/grid/manifold.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

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

    /// The distance from the circle at which a point of the arc may lie, by the
    /// radius: the digits an ASCII mesh may be short of, yet far less than an
    /// edge rises.
    static constexpr double tolerance = 1e-5;

    /// The distance of a point from the circle, by the radius.
    double misfit(const Point<2> &p) const;

    /// Whether a point lies on the circle.
    bool on_circle(const Point<2> &p) const;

    /// Whether two points lie on the piece of the circle over one chord.
    bool over_one_chord(const Point<2> &p, const Point<2> &q) const;
  };



  /**
   * A boundary that is a parabola through the ends of an edge and a third point
   * [mm], half way in its coordinate s:
   *   x(s) = p + s (q - p) + 4 s (1 - s) (middle - (p + q)/2),   0 <= s <= 1.
   * The middle is within the middle half along q - p: s grows along the edge.
   */
  struct Parabola
  {
    Point<2> p, q, middle;

    Point<2> at(const double s) const;

    /// The coordinate of a point, or nothing if it is elsewhere.
    std::optional<double> coordinate(const Point<2> &x) const;
  };



  /**
   * A straight manifold, except between two points of the same piece of an
   * arc: there it answers with the point of the circle (the weighted mean is
   * moved radially). Between two points of a parabola it answers with that of
   * the mean coordinate.
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
    explicit ArcManifold(const std::vector<Arc>      &arcs,
                         const std::vector<Parabola> &parabolas = {});

    std::unique_ptr<Manifold<2>> clone() const override;

    Point<2>
    get_new_point(const ArrayView<const Point<2>> &surrounding_points,
                  const ArrayView<const double>   &weights) const override;

  private:
    const std::vector<Arc>      arcs;
    const std::vector<Parabola> parabolas;
  };
} // namespace Contact

#endif
