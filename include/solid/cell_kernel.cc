/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/cell_kernel.h"

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace Contact
{
  namespace
  {
    /// The integral of rates in the points of the rule of Gauss and Lobatto.
    double integral(const std::vector<double> &rates)
    {
      const QGaussLobatto<1> rule(rates.size());
      double                 sum = 0;
      for (unsigned int k = 0; k < rates.size(); ++k)
        sum += rule.weight(k) * rates[k];
      return sum;
    }



    /// The work by that rule, exact for rates of the degree 2 n - 3, minus that
    /// by the trapezoidal one.
    double path_work(const std::vector<double> &rates)
    {
      return integral(rates) - 0.5 * (rates.front() + rates.back());
    }



    template<int dim>
    CellTable<dim> with_thermal_strain(const CellTable<dim> &cell,
                                       const double          thermal)
    {
      CellTable<dim> copy = cell;
      copy.thermal        = thermal;
      return copy;
    }
  } // namespace



  template<int dim>
  bool CellKernel<dim>::yields(const CellTable<dim> &cell,
                               const Vector<double> &u) const
  {
    const auto strains = this->strains(cell, u);
    for (unsigned int q = 0; q < strains.size(); ++q)
      if (law.yields(strains[q], history(cell, q)))
        return true;
    return false;
  }



  template<int dim>
  std::vector<double> CellKernel<dim>::history_at(const CellTable<dim> &cell,
                                                  const Vector<double> &u) const
  {
    std::vector<double> history = cell.history;
    const auto          strains = this->strains(cell, u);
    for (unsigned int q = 0; q < strains.size(); ++q)
      law.advance(strains[q], history.data() + q * law.n_history());
    return history;
  }



  // Along the straight path from u_0 to u_1, on which thermal strains go
  // straight as well: the work of the forces by length, and minus the trace of
  // the stresses times the change of the thermal strain. Forces of elastic
  // bodies are at most cubic in the displacement. Others by two rules, whose
  // difference is an error bound.
  template<int dim>
  typename CellKernel<dim>::Works
  CellKernel<dim>::works_by_rates(const CellTable<dim> &cell,
                                  const Vector<double> &u_0,
                                  const Vector<double> &u_1) const
  {
    Vector<double> d(u_1);
    d -= u_0;
    const QGaussLobatto<1> rule(law.is_linear() ? 3 : 5);
    Vector<double>         u(d.size()), forces(d.size());
    const double           change = cell.thermal - cell.thermal_before;
    std::vector<double>    work, thermal;
    for (const Point<1> &point : rule.get_points())
      {
        const double s = point[0];
        u              = u_0;
        u.add(s, d);
        forces = 0;
        if (change == 0)
          this->forces(cell, u, StressStiffness::with, nullptr, forces);
        else
          {
            const auto at =
              with_thermal_strain(cell, cell.thermal_before + s * change);
            this->forces(at, u, StressStiffness::with, nullptr, forces);
            thermal.push_back(-change * integral_of_trace(at, u));
          }
        work.push_back(forces * d);
      }
    thermal.resize(rule.size());

    Works works;
    works.path    = path_work(work);
    works.thermal = integral(thermal);
    if (law.is_linear())
      return works;
    const auto coarse = [](const std::vector<double> &all) {
      return std::vector<double>{all[0], all[2], all[4]};
    };
    works.error = std::abs(works.path - path_work(coarse(work))) +
                  std::abs(works.thermal - integral(coarse(thermal))) +
                  round_off_of_energy(cell, u_0) +
                  round_off_of_energy(cell, u_1);
    return works;
  }



  // That of the forces.
  template<int dim>
  double CellKernel<dim>::trapezoid(const CellTable<dim> &cell,
                                    const Vector<double> &u_0,
                                    const Vector<double> &u_1) const
  {
    Vector<double> d(u_1), forces(u_1.size());
    d -= u_0;
    for (const Vector<double> *u : {&u_0, &u_1})
      this->forces(cell, *u, StressStiffness::with, nullptr, forces);
    return 0.5 * (forces * d);
  }



  // In large displacement forces turn on their way: their work by the
  // trapezoidal rule is another one than that of the law by its own strain.
  // Thermal strains of bodies that yield are refused there.
  template<int dim>
  typename CellKernel<dim>::Works
  CellKernel<dim>::works(const CellTable<dim> &cell,
                         const Vector<double> &u_0,
                         const Vector<double> &u_1) const
  {
    const double change = cell.thermal - cell.thermal_before;
    if (is_linear() && change == 0)
      return Works();
    if (law.n_history() == 0)
      return works_by_rates(cell, u_0, u_1);

    const auto start   = with_thermal_strain(cell, cell.thermal_before);
    const auto strains = this->strains(cell, u_1),
               before  = this->strains(start, u_0);
    Works works;
    for (unsigned int q = 0; q < strains.size(); ++q)
      {
        const auto at_point =
          law.works(before[q], strains[q], history(cell, q));
        works.dissipation += cell.JxW[q] * at_point.dissipation;
        works.path += cell.JxW[q] * at_point.path;
        if (!is_small_strain())
          works.path += cell.JxW[q] * at_point.trapezoid;
      }
    if (!is_small_strain())
      works.path +=
        work_of_pressures(cell, u_0, u_1) - trapezoid(cell, u_0, u_1);
    if (change != 0)
      works.thermal =
        -0.5 * change *
        (integral_of_trace(start, u_0) + integral_of_trace(cell, u_1));
    return works;
  }



  template class CellKernel<2>;
  template class CellKernel<3>;
} // namespace Contact
