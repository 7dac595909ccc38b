/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_cell_kernel_h
#define contact_cell_kernel_h

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

#include "solid/cell_tables.h"
#include "solid/materials/material_law.h"

namespace Contact
{
  using namespace dealii;

  /**
   * Whether the tangent knows that stresses turn with the material. Without
   * that part it is positive semidefinite whatever the stresses, and no body
   * yields to its own loads as it turns or buckles. Nothing in small strain.
   * Or, of cells that yield in small strain, what that makes of their tangent:
   * its change from that of the cell while it is elastic.
   */
  enum class StressStiffness
  {
    with,
    without,
    change_by_yielding
  };



  /// The integrals over a cell, of a body with its kinematics and its material.
  /// Displacements @p u are those of the unknowns of the cell.
  template<int dim>
  class CellKernel
  {
  public:
    explicit CellKernel(const MaterialLaw &law)
      : law(law)
    {
    }

    virtual ~CellKernel() = default;

    /// The kernel of a body of a material, which has to outlive it, with its
    /// moduli at zero strain.
    static std::unique_ptr<CellKernel> create(const Material    &elastic,
                                              const MaterialLaw &law,
                                              const bool is_small_strain,
                                              const bool axisymmetric);

    virtual bool is_small_strain() const = 0;

    /// The tangent does not depend on the displacement.
    bool is_linear() const
    {
      return law.is_linear() && is_small_strain();
    }

    /// Whether its tangent is not that of the elastic cell. In small strain and
    /// of materials with a history alone.
    bool yields(const CellTable<dim> &cell, const Vector<double> &u) const;

    /// s : D^-1 : s [MPa], twice the elastic energy by volume of a stress s.
    virtual double
    energy_density(const SymmetricTensor<2, 3> &stress) const = 0;

    /// Add internal forces and, if @p tangent is not null, write the tangent.
    /// Returns the smallest det F, at most one.
    virtual double forces(const CellTable<dim> &cell,
                          const Vector<double> &u,
                          const StressStiffness stress_stiffness,
                          FullMatrix<double>   *tangent,
                          Vector<double>       &forces) const = 0;

    /// The stored energy.
    virtual double energy(const CellTable<dim> &cell,
                          const Vector<double> &u) const = 0;

    /// Cauchy stress in the quadrature points.
    virtual std::vector<SymmetricTensor<2, 3>>
    stresses(const CellTable<dim> &cell, const Vector<double> &u) const = 0;

    /// The integral of the trace of the material stress.
    virtual double integral_of_trace(const CellTable<dim> &cell,
                                     const Vector<double> &u) const = 0;

    /// The work of the pressures on the projected volumes from @p u_0 to @p u_1
    /// by the trapezoidal rule: that of U, where it is quadratic.
    virtual double work_of_pressures(const CellTable<dim> &cell,
                                     const Vector<double> &u_0,
                                     const Vector<double> &u_1) const = 0;

    /// What energy() is known to at the least, of a material without a history.
    virtual double round_off_of_energy(const CellTable<dim> &cell,
                                       const Vector<double> &u) const = 0;

    /// The strain of the kinematics in the quadrature points, without the
    /// thermal one.
    virtual std::vector<SymmetricTensor<2, 3>>
    strains(const CellTable<dim> &cell, const Vector<double> &u) const = 0;

    /// The history of the cell at the end of an increment.
    std::vector<double> history_at(const CellTable<dim> &cell,
                                   const Vector<double> &u) const;

    /**
     * The dissipation of an increment from @p u_0 to @p u_1, and what that and
     * the change of the energy are more than its work by the trapezoidal rule,
     * see MaterialLaw::works(); the latter up to an error. And the energy that
     * thermal strains e bring in, minus the integral of tr S over e.
     */
    struct Works
    {
      double dissipation = 0, path = 0, error = 0, thermal = 0;
    };
    Works works(const CellTable<dim> &cell,
                const Vector<double> &u_0,
                const Vector<double> &u_1) const;

  protected:
    const double *history(const CellTable<dim> &cell,
                          const unsigned int    q) const
    {
      return cell.history.data() + q * law.n_history();
    }

  private:
    Works  works_by_rates(const CellTable<dim> &cell,
                          const Vector<double> &u_0,
                          const Vector<double> &u_1) const;
    double trapezoid(const CellTable<dim> &cell,
                     const Vector<double> &u_0,
                     const Vector<double> &u_1) const;

    const MaterialLaw &law;
  };
} // namespace Contact

#endif
