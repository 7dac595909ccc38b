/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// The linear elastic bodies.

#include "solid/cell_integrals.h"
#include "solid/material_cells.h"

namespace Contact
{
  namespace
  {
    template<class Kinematics, class Symmetry>
    class Solid : public CellIntegrals<Kinematics, Symmetry>
    {
    public:
      static constexpr int dim = Symmetry::dim;
      using Integrals          = CellIntegrals<Kinematics, Symmetry>;
      using Integrals::Integrals;

      bool is_linear() const override
      {
        return !Kinematics::has_geometric_stiffness;
      }

      double forces(const CellTable<dim> &cell,
                    const Vector<double> &u,
                    const StressStiffness stress_stiffness,
                    FullMatrix<double>   *tangent,
                    Vector<double>       &forces) const override;

      double energy(const CellTable<dim> &cell,
                    const Vector<double> &u) const override;

      std::vector<SymmetricTensor<2, 3>>
      stresses(const CellTable<dim> &cell,
               const Vector<double> &u) const override;

    private:
      using Integrals::n_max;
      using Integrals::n_modes;
      using Integrals::n_shears;
      using typename Integrals::AtPoints;
      using typename Integrals::PointState;

      template<bool with_tangent, bool projected>
      double assemble_cell(const CellTable<dim> &cell,
                           const Vector<double> &u,
                           const StressStiffness stress_stiffness,
                           FullMatrix<double>   &matrix,
                           Vector<double>       &residual) const;

      double integral_of_trace(const CellTable<dim> &cell,
                               const Vector<double> &u) const override
      {
        const AtPoints P_tr_E = dilatations(cell, u);
        double         sum    = 0;
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          sum += cell.JxW[q] *
                 (3 * cell.material->lambda * P_tr_E[q] +
                  2 * cell.material->mu * trace(Integrals::strain(cell, q, u)));
        return sum;
      }

      /// P tr E.
      static AtPoints dilatations(const CellTable<dim> &cell,
                                  const Vector<double> &u)
      {
        AtPoints dilatations{};
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          dilatations[q] =
            trace(Kinematics::strain(
              Integrals::displacement_gradient(cell, q, u))) +
            Kinematics::strain(Integrals::hoop_gradient(cell, q, u)) -
            3 * cell.thermal;
        if (!cell.modes.empty())
          Integrals::project(cell, dilatations);
        return dilatations;
      }

      template<bool projected>
      static DEAL_II_ALWAYS_INLINE void
      find_state_at(const CellTable<dim> &cell,
                    const unsigned int    q,
                    const Vector<double> &u,
                    const AtPoints       &P_tr_E,
                    PointState           &at)
      {
        const Tensor<2, dim> H = Integrals::displacement_gradient(cell, q, u);
        const double         h = Integrals::hoop_gradient(cell, q, u);
        const auto           E =
          Kinematics::strain(H) - cell.thermal * unit_symmetric_tensor<dim>();
        const double E33 = Kinematics::strain(h) - cell.thermal;
        const double tr_E =
          projected ? P_tr_E[q] : trace(E) + (dim == 2 ? E33 : 0.);

        at.JxW = cell.JxW[q];
        at.N_X = Symmetry::has_hoop ? &cell.hoop_gradients[q * cell.n_nodes()]
                                    : nullptr;
        at.F   = Kinematics::gradient_of_motion(H);
        at.f33 = Kinematics::gradient_of_motion(h);
        at.S   = cell.material->stress(E, tr_E);
        at.S33 = cell.material->hoop_stress(E33, tr_E);
      }

      /// JxW D B_a.
      static typename Symmetry::StrainRow
      isotropic(const typename Symmetry::StrainRow &B,
                const double                        JxW,
                const double                        lambda,
                const double                        mu)
      {
        typename Symmetry::StrainRow DB;
        const double                 tr = lambda * Symmetry::trace(B);
        for (unsigned int d = 0; d < dim; ++d)
          DB[d] = JxW * (tr + 2 * mu * B[d]);
        for (unsigned int k = dim; k < dim + n_shears; ++k)
          DB[k] = JxW * mu * B[k];
        if constexpr (Symmetry::has_hoop)
          DB[3] = JxW * (tr + 2 * mu * B[3]);
        return DB;
      }
    };



    // With F = (f_ij), the strains (E11, E22, 2 E12) vary with node a by
    //   B_a = [ f11 N,1            f21 N,1
    //           f12 N,2            f22 N,2
    //           f11 N,2 + f12 N,1  f21 N,2 + f22 N,1 ],
    // in 3-D likewise in the order of Symmetry::components, and the tangent
    // of the nodes a and b is
    //   K_ab = B_a^T D B_b + (grad N_a . S grad N_b) I,
    // symmetric: the upper half is computed and mirrored. Of rings E33 varies
    // by the row (f33 N/X, 0) of B_a, and S33 N_a N_b/X^2 is added to K_ab in
    // x. Projected, the part of D with lambda becomes
    //   lambda sum_m g_m g_m^T,   g_m = sum_q JxW phi_m (trace of B),
    // while S has the projected dilatation and all else stays.
    template<class Kinematics, class Symmetry>
    template<bool with_tangent, bool projected>
    double Solid<Kinematics, Symmetry>::assemble_cell(
      const CellTable<dim> &cell,
      const Vector<double> &u,
      const StressStiffness stress_stiffness,
      FullMatrix<double>   &matrix,
      Vector<double>       &residual) const
    {
      const unsigned int n      = cell.n_nodes();
      const double       lambda = projected ? 0. : cell.material->lambda;

      // Without projection they are neither filled nor read.
      AtPoints                                             P_tr_E;
      std::array<std::array<double, dim * n_max>, n_modes> g;
      if constexpr (projected)
        {
          P_tr_E = dilatations(cell, u);
          if constexpr (with_tangent)
            g = {};
        }

      double     smallest = 1;
      PointState at;
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          find_state_at<projected>(cell, q, u, P_tr_E, at);
          if constexpr (Kinematics::has_geometric_stiffness)
            {
              smallest = std::min(smallest, determinant(at.F) * at.f33);
            }
          this->add_forces(cell, q, at, residual);
          // In the tangent stresses are in nothing else.
          if (stress_stiffness == StressStiffness::without)
            at.drop_stresses();
          if constexpr (with_tangent)
            {
              this->add_rows(cell, q, at);
              this->add_tangent(
                at,
                n,
                [&](const auto &row) {
                  return isotropic(row, at.JxW, lambda, cell.material->mu);
                },
                matrix);
            }
          if constexpr (with_tangent && projected)
            for (unsigned int m = 0; m < n_modes; ++m)
              for (unsigned int a = 0; a < n; ++a)
                for (unsigned int i = 0; i < dim; ++i)
                  g[m][dim * a + i] +=
                    at.JxW * cell.modes[q][m] * Symmetry::trace(at.B[a][i]);
        }

      if constexpr (with_tangent && projected)
        for (unsigned int m = 0; m < n_modes; ++m)
          for (unsigned int i = 0; i < dim * n; ++i)
            for (unsigned int j = i; j < dim * n; ++j)
              matrix(i, j) += cell.material->lambda * g[m][i] * g[m][j];

      if constexpr (with_tangent)
        this->mirror(matrix);
      return smallest;
    }



    template<class Kinematics, class Symmetry>
    double
    Solid<Kinematics, Symmetry>::forces(const CellTable<dim> &cell,
                                        const Vector<double> &u,
                                        const StressStiffness stress_stiffness,
                                        FullMatrix<double>   *tangent,
                                        Vector<double>       &forces) const
    {
      const bool projected     = !cell.modes.empty();
      const auto assemble_with = [&](auto with_tangent, auto projected) {
        FullMatrix<double> none;
        return assemble_cell<with_tangent, projected>(cell,
                                                      u,
                                                      stress_stiffness,
                                                      with_tangent ? *tangent
                                                                   : none,
                                                      forces);
      };
      const std::true_type  yes;
      const std::false_type no;
      if (tangent == nullptr)
        return projected ? assemble_with(no, yes) : assemble_with(no, no);
      return projected ? assemble_with(yes, yes) : assemble_with(yes, no);
    }



    template<class Kinematics, class Symmetry>
    double Solid<Kinematics, Symmetry>::energy(const CellTable<dim> &cell,
                                               const Vector<double> &u) const
    {
      const AtPoints P_tr_E = dilatations(cell, u);
      double         energy = 0;
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          const auto E = this->strain(cell, q, u);
          energy +=
            cell.JxW[q] * cell.material->stored_energy(in_space<dim>(E),
                                                       dim == 2 ? E[2][2] : 0.,
                                                       P_tr_E[q]);
        }
      return energy;
    }



    template<class Kinematics, class Symmetry>
    std::vector<SymmetricTensor<2, 3>>
    Solid<Kinematics, Symmetry>::stresses(const CellTable<dim> &cell,
                                          const Vector<double> &u) const
    {
      std::vector<SymmetricTensor<2, 3>> stresses(cell.JxW.size());
      const AtPoints                     P_tr_E = dilatations(cell, u);
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          const Tensor<2, dim> H = this->displacement_gradient(cell, q, u);
          const double         h = this->hoop_gradient(cell, q, u);
          const auto           E = this->strain(cell, q, u);
          const auto inner = cell.material->stress(in_space<dim>(E), P_tr_E[q]);
          SymmetricTensor<2, 3> S;
          S[2][2] = cell.material->hoop_stress(E[2][2], P_tr_E[q]);
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j <= i; ++j)
              S[i][j] = inner[i][j];
          stresses[q] = Kinematics::cauchy(H, h, S);
        }
      return stresses;
    }
  } // namespace



  template<int dim>
  std::unique_ptr<CellKernel<dim>>
  CellKernel<dim>::create(const Material    &elastic,
                          const MaterialLaw *law,
                          const bool         is_small_strain,
                          const bool         axisymmetric)
  {
    if (law != nullptr)
      return make_material_cells<dim>(elastic,
                                      *law,
                                      is_small_strain,
                                      axisymmetric);
    return with_kinematics<dim>(
      is_small_strain,
      axisymmetric,
      [&](const auto kinematics,
          const auto symmetry) -> std::unique_ptr<CellKernel<dim>> {
        return std::make_unique<Solid<std::decay_t<decltype(kinematics)>,
                                      std::decay_t<decltype(symmetry)>>>(
          elastic);
      });
  }



  template std::unique_ptr<CellKernel<2>>
  CellKernel<2>::create(const Material &,
                        const MaterialLaw *,
                        const bool,
                        const bool);
  template std::unique_ptr<CellKernel<3>>
  CellKernel<3>::create(const Material &,
                        const MaterialLaw *,
                        const bool,
                        const bool);
} // namespace Contact
