/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "closed_forms/half_plane.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>

namespace Contact
{
  HalfPlaneContact::HalfPlaneContact(const HertzLineContact &hertz,
                                     const double            friction,
                                     const unsigned int      n_increments,
                                     const unsigned int      n_elements)
    : hertz(hertz)
    , friction(friction)
    , beta(hertz.dundurs())
    , h(1. / n_elements)
    // Friction only narrows the contact: a little more than its frictionless
    // width shows both sides of its end.
    , elements(n_elements + n_elements / 20 + 5)
  {
    // The integral of -1/pi log|t| over the elements at these distances.
    const auto primitive = [](const double t) {
      return (t - t * std::log(std::abs(t))) / numbers::PI;
    };
    for (unsigned int k = 0; k < 2 * elements.size(); ++k)
      kernel.push_back(primitive((k + 0.5) * h) - primitive((k - 0.5) * h));

    for (unsigned int k = 1; k <= n_increments; ++k)
      solve_increment(double(k) / n_increments);
  }



  double HalfPlaneContact::position(const unsigned int i) const
  {
    return (i + 0.5) * h;
  }



  // The influence of element j and its mirror image on the midpoint of element
  // i.
  double HalfPlaneContact::influence(const unsigned int i,
                                     const unsigned int j,
                                     const int          parity) const
  {
    return kernel[i > j ? i - j : j - i] + parity * kernel[i + j + 1];
  }



  // The part of element j between the axis and the midpoint of element i.
  double HalfPlaneContact::covered(const unsigned int i,
                                   const unsigned int j) const
  {
    return j < i ? h : j == i ? h / 2 : 0;
  }



  void HalfPlaneContact::solve_increment(const double load_factor)
  {
    std::vector<double> start;
    for (const Element &element : elements)
      start.push_back(element.displacement);
    for (unsigned int i = 0; i < elements.size(); ++i)
      elements[i].in_contact = position(i) < std::sqrt(load_factor);

    const unsigned int max_iterations = 100;
    unsigned int       iteration      = 0;
    do
      {
        AssertThrow(++iteration <= max_iterations,
                    ExcMessage("The states of contact and friction of the "
                               "half planes cycle."));
        solve_equations(load_factor, start);
      }
    while (updated_status());
    AssertThrow(!elements[elements.size() - 3].in_contact,
                ExcMessage("The half planes touch beyond their elements."));
  }



  // The problem is linear once the states are decided. Its unknowns are all p,
  // all q and w0.
  void HalfPlaneContact::solve_equations(const double               load_factor,
                                         const std::vector<double> &start)
  {
    const unsigned int       n = elements.size();
    LAPACKFullMatrix<double> matrix(2 * n + 1);
    Vector<double>           values(2 * n + 1);
    for (unsigned int i = 0; i < n; ++i)
      {
        const Element &element = elements[i];
        matrix(2 * n, i)       = 2 * h;
        if (element.in_contact)
          {
            for (unsigned int j = 0; j < n; ++j)
              {
                matrix(i, j)     = influence(i, j, 1);
                matrix(i, n + j) = beta * covered(i, j);
              }
            matrix(i, 2 * n) = -1;
            values[i]        = -position(i) * position(i) / 2;
          }
        else
          matrix(i, i) = 1;

        if (element.in_contact && element.direction == 0)
          {
            for (unsigned int j = 0; j < n; ++j)
              {
                matrix(n + i, j)     = -beta * covered(i, j);
                matrix(n + i, n + j) = influence(i, j, -1);
              }
            values[n + i] = start[i];
          }
        else
          {
            matrix(n + i, n + i) = 1;
            matrix(n + i, i)     = -element.direction * friction;
          }
      }
    values[2 * n] = numbers::PI / 2 * load_factor;
    matrix.compute_lu_factorization();
    matrix.solve(values);

    for (unsigned int i = 0; i < n; ++i)
      {
        Element &element     = elements[i];
        element.pressure     = values[i];
        element.shear        = values[n + i];
        element.gap          = position(i) * position(i) / 2 - values[2 * n];
        element.displacement = 0;
        for (unsigned int j = 0; j < n; ++j)
          {
            element.gap += influence(i, j, 1) * values[j] +
                           beta * covered(i, j) * values[n + j];
            element.displacement += influence(i, j, -1) * values[n + j] -
                                    beta * covered(i, j) * values[j];
          }
        element.slip = element.displacement - start[i];
      }
  }



  // Update the status of all elements. Returns whether one has changed.
  bool HalfPlaneContact::updated_status()
  {
    const double round_off = 1e-12;

    bool changed = false;
    for (Element &element : elements)
      {
        const bool had_contact = element.in_contact;
        const int  had         = element.direction;

        element.in_contact = had_contact ? element.pressure > -round_off
                                         : element.gap < -round_off;
        if (!had_contact)
          // Slip: if the last element, which comes and goes, stuck, the states
          // would cycle.
          element.direction = element.slip > 0 ? -1 : 1;
        else if (had == 0)
          {
            if (std::abs(element.shear) >
                friction * element.pressure + round_off)
              element.direction = element.shear > 0 ? 1 : -1;
          }
        else if (had * element.slip > round_off)
          // Stick, not slip the other way: that cycles, too.
          element.direction = 0;

        changed = changed || element.in_contact != had_contact ||
                  (had_contact && element.direction != had);
      }
    return changed;
  }



  // The gap beyond the end of contact and the slip beyond that of stick both
  // grow with the power 3/2 of the distance. Unlike the tractions, slip does so
  // also with many increments, when the end of stick moves by less than an
  // element. The first element has the largest error.
  double HalfPlaneContact::edge(double Element::  *value,
                                const unsigned int first) const
  {
    const double v1 = std::cbrt(std::pow(elements[first + 1].*value, 2));
    const double v2 = std::cbrt(std::pow(elements[first + 2].*value, 2));
    return position(first + 1) - h * v1 / (v2 - v1);
  }



  double HalfPlaneContact::half_width() const
  {
    unsigned int first = 0;
    while (elements[first].in_contact)
      ++first;
    return hertz.half_width() * edge(&Element::gap, first);
  }



  double HalfPlaneContact::stick_half_width() const
  {
    unsigned int first = 0;
    while (elements[first].in_contact && elements[first].direction == 0)
      ++first;
    if (first == 0)
      return 0;
    // All stick, or all but a few elements.
    if (!elements[first + 2].in_contact)
      return half_width();
    return hertz.half_width() * edge(&Element::slip, first);
  }



  double HalfPlaneContact::interpolate(double Element::*value,
                                       const int        parity,
                                       const double     x) const
  {
    const double t = std::abs(x) / (h * hertz.half_width()) - 0.5;
    const int    i = std::floor(t);
    const auto   v = [&](const int k) {
      return k < 0                      ? parity * elements[0].*value
               : k < int(elements.size()) ? elements[k].*value
                                          : 0.;
    };
    return hertz.max_pressure() * (v(i) + (t - i) * (v(i + 1) - v(i)));
  }



  double HalfPlaneContact::pressure(const double x) const
  {
    return interpolate(&Element::pressure, 1, x);
  }



  double HalfPlaneContact::shear(const double x) const
  {
    return std::copysign(1., x) * interpolate(&Element::shear, -1, x);
  }



  double HalfPlaneContact::largest(double Element::*value) const
  {
    double result = 0;
    for (const Element &element : elements)
      result = std::max(result, std::abs(element.*value));
    return hertz.max_pressure() * result;
  }



  double HalfPlaneContact::max_pressure() const
  {
    return largest(&Element::pressure);
  }



  double HalfPlaneContact::max_shear() const
  {
    return largest(&Element::shear);
  }
} // namespace Contact
