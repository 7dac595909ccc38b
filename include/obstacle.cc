/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "obstacle.h"

#include <cmath>

#include "parameters.h"

namespace Contact
{
  namespace
  {
    class HalfPlane : public Obstacle
    {
    public:
      HalfPlane(const Point<2> &point, const Tensor<1, 2> &normal)
        : point(point)
        , normal(normal / normal.norm())
      {
      }

      Foot closest_point(const Point<2> &x) const override
      {
        return {x - ((x - point) * normal) * normal, normal, 0};
      }

    private:
      const Point<2>     point;
      const Tensor<1, 2> normal;
    };



    class Circle : public Obstacle
    {
    public:
      Circle(const Point<2> &centre, const double radius)
        : centre(centre)
        , radius(radius)
      {
      }

      // In its centre any direction is as good as another.
      Foot closest_point(const Point<2> &x) const override
      {
        Tensor<1, 2> normal = x - centre;
        if (normal.norm() == 0)
          normal[1] = 1;
        normal *= std::copysign(1 / normal.norm(), radius);
        return {centre + radius * normal, normal, radius};
      }

    private:
      const Point<2> centre;
      const double   radius;
    };
  } // namespace



  std::unique_ptr<const Obstacle> Obstacle::create(
    const std::map<std::string, std::vector<double>> &description,
    const std::string                                &entry)
  {
    if (description.size() != 1)
      throw EntryError("A zone has one obstacle.",
                       {entry},
                       "give each its own section 'Contact NAME'");

    const auto &[shape, numbers] = *description.begin();
    if (shape == "half plane" && numbers.size() == 4 &&
        (numbers[2] != 0 || numbers[3] != 0))
      return std::make_unique<HalfPlane>(Point<2>(numbers[0], numbers[1]),
                                         Tensor<1, 2>(
                                           {numbers[2], numbers[3]}));
    if (shape == "circle" && numbers.size() == 3 && numbers[2] != 0)
      return std::make_unique<Circle>(Point<2>(numbers[0], numbers[1]),
                                      numbers[2]);
    throw EntryError("'" + shape + "' is no obstacle with these numbers.",
                     {entry},
                     "write 'half plane: x, y, normal x, normal y' or "
                     "'circle: x, y, radius', in a hole a negative radius");
  }
} // namespace Contact
