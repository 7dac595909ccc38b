/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/enhanced_cells.h"

#include "solid/cell_integrals.h"
#include "solid/material_cells.h"

namespace Contact
{
  namespace
  {
    template<class Kinematics, class Symmetry>
    class EnhancedCells : public CellIntegrals<Kinematics, Symmetry>
    {
    public:
      static constexpr int dim = Symmetry::dim;
      using Integrals          = CellIntegrals<Kinematics, Symmetry>;

      EnhancedCells(const Material                  &elastic,
                    std::unique_ptr<CellKernel<dim>> compatible)
        : Integrals(elastic)
        , compatible(std::move(compatible))
      {
      }

      bool is_linear() const override
      {
        return compatible->is_linear();
      }

      double forces(const CellTable<dim> &cell,
                    const Vector<double> &u,
                    const StressStiffness stress_stiffness,
                    FullMatrix<double>   *tangent,
                    Vector<double>       &forces) const override
      {
        const Amplitudes                         alpha = amplitudes(cell, u);
        std::array<Vector<double>, n_amplitudes> g;
        if (tangent != nullptr)
          for (auto &of_mode : g)
            of_mode.reinit(u.size());
        const double smallest =
          compatible->forces(cell, u, stress_stiffness, tangent, forces);

        PointState at;
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          {
            at.JxW = cell.JxW[q];
            if constexpr (Symmetry::has_hoop)
              at.N_X = &cell.hoop_gradients[q * cell.n_nodes()];
            at.F = Kinematics::gradient_of_motion(
              Integrals::displacement_gradient(cell, q, u));
            at.f33 = Kinematics::gradient_of_motion(
              Integrals::hoop_gradient(cell, q, u));
            set_stress(stress(cell, q, alpha), at);
            this->add_forces(cell, q, at, forces);
            if (tangent == nullptr)
              continue;
            if (Kinematics::has_geometric_stiffness &&
                stress_stiffness == StressStiffness::with)
              {
                this->add_rows(cell, q, at);
                this->add_tangent(
                  at,
                  cell.n_nodes(),
                  [](const auto &) { return typename Symmetry::StrainRow{}; },
                  *tangent);
              }
            for (unsigned int m = 0; m < n_amplitudes; ++m)
              {
                set_stress(cell.stress_modes[q][m], at);
                this->add_forces(cell, q, at, g[m]);
              }
          }

        if (tangent != nullptr)
          {
            for (const auto &of_mode : g)
              for (unsigned int i = 0; i < u.size(); ++i)
                for (unsigned int j = i; j < u.size(); ++j)
                  (*tangent)(i, j) -= of_mode[i] * of_mode[j];
            this->mirror(*tangent);
          }
        return smallest;
      }

      double energy(const CellTable<dim> &cell,
                    const Vector<double> &u) const override
      {
        double energy = compatible->energy(cell, u);
        for (const double alpha : amplitudes(cell, u))
          energy -= 0.5 * alpha * alpha;
        return energy;
      }

      std::vector<SymmetricTensor<2, 3>>
      stresses(const CellTable<dim> &cell,
               const Vector<double> &u) const override
      {
        const Amplitudes alpha    = amplitudes(cell, u);
        auto             stresses = compatible->stresses(cell, u);
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          stresses[q] +=
            Kinematics::cauchy(Integrals::displacement_gradient(cell, q, u),
                               Integrals::hoop_gradient(cell, q, u),
                               stress(cell, q, alpha));
        return stresses;
      }

    private:
      using typename Integrals::PointState;
      static constexpr unsigned int n_amplitudes = dim * dim;
      using Amplitudes = std::array<double, n_amplitudes>;

      /// The stresses of the modes have no mean.
      double integral_of_trace(const CellTable<dim> &cell,
                               const Vector<double> &u) const override
      {
        const Material &material = *cell.material;
        double          sum      = 0;
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          sum += cell.JxW[q] * (3 * material.lambda + 2 * material.mu) *
                 trace(Integrals::strain(cell, q, u));
        return sum;
      }

      static Amplitudes amplitudes(const CellTable<dim> &cell,
                                   const Vector<double> &u)
      {
        Amplitudes alpha{};
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          {
            const auto E = Integrals::strain(cell, q, u);
            for (unsigned int m = 0; m < n_amplitudes; ++m)
              alpha[m] -= cell.JxW[q] * (cell.stress_modes[q][m] * E);
          }
        return alpha;
      }

      /// That of all modes.
      static SymmetricTensor<2, 3> stress(const CellTable<dim> &cell,
                                          const unsigned int    q,
                                          const Amplitudes     &alpha)
      {
        SymmetricTensor<2, 3> stress;
        for (unsigned int m = 0; m < n_amplitudes; ++m)
          stress += alpha[m] * cell.stress_modes[q][m];
        return stress;
      }

      static void set_stress(const SymmetricTensor<2, 3> &stress,
                             PointState                  &at)
      {
        at.S   = in_space<dim>(stress);
        at.S33 = stress[2][2];
      }

      /// Those of the displacement alone.
      const std::unique_ptr<CellKernel<dim>> compatible;
    };
  } // namespace



  template<int dim>
  std::unique_ptr<CellKernel<dim>>
  make_enhanced_cells(const Material                  &elastic,
                      std::unique_ptr<CellKernel<dim>> compatible,
                      const bool                       axisymmetric)
  {
    return with_kinematics<dim>(
      compatible->is_small_strain(),
      axisymmetric,
      [&](const auto kinematics,
          const auto symmetry) -> std::unique_ptr<CellKernel<dim>> {
        return std::make_unique<
          EnhancedCells<std::decay_t<decltype(kinematics)>,
                        std::decay_t<decltype(symmetry)>>>(elastic,
                                                           std::move(
                                                             compatible));
      });
  }

  template std::unique_ptr<CellKernel<2>>
  make_enhanced_cells(const Material &,
                      std::unique_ptr<CellKernel<2>>,
                      const bool);
  template std::unique_ptr<CellKernel<3>>
  make_enhanced_cells(const Material &,
                      std::unique_ptr<CellKernel<3>>,
                      const bool);
} // namespace Contact
