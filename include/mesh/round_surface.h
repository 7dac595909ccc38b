/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_round_surface_h
#define contact_round_surface_h

#include <deal.II/base/point.h>
#include <deal.II/grid/manifold.h>

#include <memory>

namespace Contact
{
  using namespace dealii;

  /**
   * A surface of revolution in space that boundaries lie on: the points at the
   * distance @p radius from a line (cylinder), from a point (sphere), from a
   * circle (torus), or at a fixed angle to an axis (cone). It answers with the
   * closest of its points.
   */
  class RoundSurface
  {
  public:
    virtual ~RoundSurface() = default;

    /// The point of the surface that is closest to @p p [mm].
    virtual Point<3> closest(const Point<3> &p) const = 0;

    /// A length [mm] that the distance of @p p from the surface is small
    /// against, if it is on the surface.
    virtual double size(const Point<3> &p) const = 0;
  };



  class Sphere : public RoundSurface
  {
  public:
    Sphere(const Point<3> &center, const double radius);

    Point<3> closest(const Point<3> &p) const override;
    double   size(const Point<3> &p) const override;

  private:
    const Point<3> center;
    const double   radius;
  };



  class Cylinder : public RoundSurface
  {
  public:
    /// Through @p point goes the axis.
    Cylinder(const Point<3>     &point,
             const Tensor<1, 3> &axis,
             const double        radius);

    Point<3> closest(const Point<3> &p) const override;
    double   size(const Point<3> &p) const override;

  private:
    const Point<3>     point;
    const Tensor<1, 3> axis; // of length 1
    const double       radius;
  };



  class Cone : public RoundSurface
  {
  public:
    /// Opens from the @p apex along the @p axis, at an angle to it [rad].
    Cone(const Point<3> &apex, const Tensor<1, 3> &axis, const double angle);

    Point<3> closest(const Point<3> &p) const override;

    /// The distance from the apex.
    double size(const Point<3> &p) const override;

  private:
    const Point<3>     apex;
    const Tensor<1, 3> axis; // of length 1
    const double       angle;
  };



  class Torus : public RoundSurface
  {
  public:
    /// A tube of radius @p tube along a circle of radius @p ring about the @p
    /// axis through @p center.
    Torus(const Point<3>     &center,
          const Tensor<1, 3> &axis,
          const double        ring,
          const double        tube);

    Point<3> closest(const Point<3> &p) const override;
    double   size(const Point<3> &p) const override;

  private:
    const Point<3>     center;
    const Tensor<1, 3> axis; // of length 1
    const double       ring, tube;
  };



  /// A boundary on a round surface: a new point is the point of the surface
  /// closest to the weighted mean.
  class RoundManifold : public Manifold<3>
  {
  public:
    explicit RoundManifold(const std::shared_ptr<const RoundSurface> &surface);

    std::unique_ptr<Manifold<3>> clone() const override;

    Point<3>
    get_new_point(const ArrayView<const Point<3>> &surrounding_points,
                  const ArrayView<const double>   &weights) const override;

  private:
    const std::shared_ptr<const RoundSurface> surface;
  };
} // namespace Contact

#endif
