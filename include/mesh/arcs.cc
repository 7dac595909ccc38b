/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/arcs.h"

#include <algorithm>
#include <cmath>

namespace Contact
{
  double Arc::misfit(const Point<2> &p) const
  {
    return std::abs(p.distance(center) - radius) / radius;
  }



  bool Arc::on_circle(const Point<2> &p) const
  {
    return misfit(p) < tolerance;
  }



  bool Arc::over_one_chord(const Point<2> &p, const Point<2> &q) const
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



  Point<2> Parabola::at(const double s) const
  {
    return p + s * (q - p) +
           4 * s * (1 - s) * ((middle - p + (middle - q)) / 2);
  }



  // Along q - p x(s) is s + b s (1 - s), |b| < 1.
  std::optional<double> Parabola::coordinate(const Point<2> &x) const
  {
    const Tensor<1, 2> chord  = q - p;
    const double       square = chord.norm_square();
    const double       t      = (x - p) * chord / square;
    if (t < -Arc::tolerance || t > 1 + Arc::tolerance)
      return {};
    const double b    = 2 * ((middle - p + (middle - q)) * chord) / square;
    const double root = (1 + b) * (1 + b) - 4 * b * t;
    const double s    = 2 * t / (1 + b + std::sqrt(std::max(0., root)));
    if (at(s).distance_square(x) > Arc::tolerance * Arc::tolerance * square)
      return {};
    return s;
  }



  ArcManifold::ArcManifold(const std::vector<Arc>      &arcs,
                           const std::vector<Parabola> &parabolas)
    : arcs(arcs)
    , parabolas(parabolas)
  {
  }



  std::unique_ptr<Manifold<2>> ArcManifold::clone() const
  {
    return std::make_unique<ArcManifold>(arcs, parabolas);
  }



  Point<2> ArcManifold::get_new_point(
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
        // At a place where two arcs touch, a point can lie on both up to the
        // tolerance: the one that fits better is meant.
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
        for (const Parabola &parabola : parabolas)
          if (const auto s = parabola.coordinate(p))
            if (const auto t = parabola.coordinate(q))
              return parabola.at(weights[ends[0]] * *s + weights[ends[1]] * *t);
      }
    return mean;
  }
} // namespace Contact
