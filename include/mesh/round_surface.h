/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_round_surface_h
#define contact_round_surface_h

#include <deal.II/base/point.h>
#include <deal.II/grid/manifold.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>

namespace Contact
{
  using namespace dealii;

  /**
   * A surface of revolution in 3-D that boundaries lie on. It answers with
   * the closest of its points.
   */
  struct RoundSurface
  {
    /// The point of the surface that is closest to another one [mm].
    std::function<Point<3>(const Point<3> &)> closest;

    /// A length [mm] that the distance of a point from the surface is small
    /// against, if it is on the surface.
    std::function<double(const Point<3> &)> size;
  };

  RoundSurface sphere(const Point<3> &center, const double radius);

  /// Through @p point goes the axis.
  RoundSurface cylinder(const Point<3>     &point,
                        const Tensor<1, 3> &axis,
                        const double        radius);

  /// Opens from the @p apex along the @p axis, at an angle to it [rad].
  RoundSurface
  cone(const Point<3> &apex, const Tensor<1, 3> &axis, const double angle);

  /// A tube of radius @p tube along a circle of radius @p ring about the @p
  /// axis through @p center.
  RoundSurface torus(const Point<3>     &center,
                     const Tensor<1, 3> &axis,
                     const double        ring,
                     const double        tube);



  /// A boundary on a round surface: a new point is the point of the surface
  /// closest to the weighted mean.
  class RoundManifold : public Manifold<3>
  {
  public:
    explicit RoundManifold(const RoundSurface &surface);

    std::unique_ptr<Manifold<3>> clone() const override;

    Point<3>
    get_new_point(const ArrayView<const Point<3>> &surrounding_points,
                  const ArrayView<const double>   &weights) const override;

  private:
    const RoundSurface surface;
  };



  /// A face with curved sides, by coordinates xi in the plane. A new point has
  /// the weighted mean of the coordinates.
  class CurvedFace : public ChartManifold<3, 3, 2>
  {
  public:
    /// By the method of Gauss and Newton.
    Point<2> pull_back(const Point<3> &p) const override;

  private:
    /// The first guess.
    virtual Point<2> middle() const = 0;
  };



  /**
   * A quadrangle with curved sides: its corners in deal.II's order, by line how
   * far the mid-side node is from the middle of the line, and its centre, if
   * there is a node [mm]. With coordinates xi of the unit square it is that of
   * 9 nodes, or of 8, x = sum_a N_a x_a + 4 sum_l f_l(xi) bulge_l
   *       + 16 xi_0 (1 - xi_0) xi_1 (1 - xi_1) bubble,
   * f of line 0 is (1 - xi_0) xi_1 (1 - xi_1), the others likewise.
   */
  class CurvedQuadrangle : public CurvedFace
  {
  public:
    CurvedQuadrangle(const std::array<Point<3>, 4>     &corners,
                     const std::array<Tensor<1, 3>, 4> &bulges,
                     const std::optional<Point<3>>     &centre);

    std::unique_ptr<Manifold<3>> clone() const override;

    Point<3> push_forward(const Point<2> &xi) const override;

  private:
    DerivativeForm<1, 2, 3>
    push_forward_gradient(const Point<2> &xi) const override;

    Point<2> middle() const override;

    const std::array<Point<3>, 4>     corners;
    const std::array<Tensor<1, 3>, 4> bulges;
    const std::optional<Point<3>>     centre;
    Tensor<1, 3>                      bubble;
  };



  /**
   * A triangle of 6 nodes: line l joins the corners l and l + 1. With lambda =
   * (1 - xi_0 - xi_1, xi_0, xi_1)
   *   x = sum_a lambda_a x_a + 4 sum_l lambda_l lambda_{l+1} bulge_l.
   */
  class CurvedTriangle : public CurvedFace
  {
  public:
    CurvedTriangle(const std::array<Point<3>, 3>     &corners,
                   const std::array<Tensor<1, 3>, 3> &bulges);

    std::unique_ptr<Manifold<3>> clone() const override;

    Point<3> push_forward(const Point<2> &xi) const override;

  private:
    DerivativeForm<1, 2, 3>
    push_forward_gradient(const Point<2> &xi) const override;

    Point<2> middle() const override;

    const std::array<Point<3>, 3>     corners;
    const std::array<Tensor<1, 3>, 3> bulges;
  };
} // namespace Contact

#endif
