/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solid/material_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solid/cell_integrals.h"

namespace Contact
{
  namespace
  {
    template<class Kinematics, class Symmetry>
    class MaterialCells : public CellIntegrals<Kinematics, Symmetry>
    {
    public:
      static constexpr int dim = Symmetry::dim;
      using Integrals          = CellIntegrals<Kinematics, Symmetry>;
      using Works              = typename CellKernel<dim>::Works;

      MaterialCells(const Material &elastic, const MaterialLaw &law)
        : Integrals(elastic)
        , law(law)
      {
      }

      bool is_linear() const override
      {
        return false;
      }

      bool is_elastic() const override
      {
        return false;
      }

      // In plane strain plastic strains leave a stress across the plane that
      // those in 2-D do not tell.
      double energy_density(const SymmetricTensor<2, 3> &stress) const override
      {
        return this->elastic.energy_density(stress);
      }

      double forces(const CellTable<dim> &cell,
                    const Vector<double> &u,
                    const StressStiffness stress_stiffness,
                    FullMatrix<double>   *tangent,
                    Vector<double>       &forces) const override
      {
        if (tangent == nullptr)
          return add_forces_alone(cell, u, forces);
        return cell.modes.empty()
                 ? assemble<false>(cell, u, stress_stiffness, *tangent, forces)
                 : assemble<true>(cell, u, stress_stiffness, *tangent, forces);
      }

      bool yields(const CellTable<dim> &cell,
                  const Vector<double> &u) const override
      {
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          if (law.yields(this->strain(cell, q, u), history(cell, q)))
            return true;
        return false;
      }

      double energy(const CellTable<dim> &cell,
                    const Vector<double> &u) const override;

      std::vector<SymmetricTensor<2, 3>>
      stresses(const CellTable<dim> &cell,
               const Vector<double> &u) const override;

      std::vector<double> history_at(const CellTable<dim> &cell,
                                     const Vector<double> &u) const override;

      Works works(const CellTable<dim> &cell,
                  const Vector<double> &u_0,
                  const Vector<double> &u_1) const override;

    private:
      double integral_of_trace(const CellTable<dim> &cell,
                               const Vector<double> &u) const override;

      using Integrals::n_max;
      using Integrals::n_modes;
      using Integrals::n_shears;
      using typename Integrals::AtPoints;
      using typename Integrals::PointState;

      /// By point the strain in 3-D, the measure of volume and what follows
      /// from P d.
      struct States
      {
        std::array<SymmetricTensor<2, 3>, n_max> E;
        std::array<MaterialLaw::Volume, n_max>   volume;
        AtPoints                                 theta, p, modulus, energy;
      };
      States states(const CellTable<dim> &cell, const Vector<double> &u) const;

      const double *history(const CellTable<dim> &cell,
                            const unsigned int    q) const
      {
        return cell.history.data() + q * law.n_history();
      }

      /// The indices of the strains that vary.
      static std::array<unsigned int, 2> indices(const unsigned int k)
      {
        return k < dim + n_shears ? Symmetry::components[k]
                                  : std::array<unsigned int, 2>{{2, 2}};
      }

      template<bool projected>
      double assemble(const CellTable<dim> &cell,
                      const Vector<double> &u,
                      const StressStiffness stress_stiffness,
                      FullMatrix<double>   &tangent,
                      Vector<double>       &residual) const;

      double add_forces_alone(const CellTable<dim> &cell,
                              const Vector<double> &u,
                              Vector<double>       &residual) const;

      /// Of a point with the stress @p of_shears in the part without U, which
      /// is left in @p at. Returns what may turn negative, at most one.
      double add_forces_at(const CellTable<dim>        &cell,
                           const unsigned int           q,
                           const Vector<double>        &u,
                           const States                &states,
                           const SymmetricTensor<2, 3> &of_shears,
                           PointState                  &at,
                           Vector<double>              &residual) const;

      const MaterialLaw &law;
    };



    template<class Kinematics, class Symmetry>
    typename MaterialCells<Kinematics, Symmetry>::States
    MaterialCells<Kinematics, Symmetry>::states(const CellTable<dim> &cell,
                                                const Vector<double> &u) const
    {
      States             states;
      const unsigned int n_points = cell.JxW.size();
      for (unsigned int q = 0; q < n_points; ++q)
        {
          states.E[q]      = this->strain(cell, q, u);
          states.volume[q] = law.volume(states.E[q]);
          states.theta[q]  = states.volume[q].value;
        }
      if (!cell.modes.empty())
        this->project(cell, states.theta);
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const auto U      = law.volume_energy(states.theta[q]);
          states.p[q]       = U.pressure;
          states.modulus[q] = U.modulus;
          states.energy[q]  = U.energy;
        }
      if (!cell.modes.empty())
        this->project(cell, states.p);
      return states;
    }



    template<class Kinematics, class Symmetry>
    DEAL_II_ALWAYS_INLINE inline double
    MaterialCells<Kinematics, Symmetry>::add_forces_at(
      const CellTable<dim>        &cell,
      const unsigned int           q,
      const Vector<double>        &u,
      const States                &states,
      const SymmetricTensor<2, 3> &of_shears,
      PointState                  &at,
      Vector<double>              &residual) const
    {
      constexpr bool is_large = Kinematics::has_geometric_stiffness;
      Tensor<2, dim> H;
      double         h = 0;
      if constexpr (is_large)
        {
          H = Integrals::displacement_gradient(cell, q, u);
          h = Integrals::hoop_gradient(cell, q, u);
        }
      const auto stress = of_shears + states.p[q] * states.volume[q].slope;

      at.JxW = cell.JxW[q];
      at.N_X =
        Symmetry::has_hoop ? &cell.hoop_gradients[q * cell.n_nodes()] : nullptr;
      at.F   = Kinematics::gradient_of_motion(H);
      at.f33 = Kinematics::gradient_of_motion(h);
      at.S   = in_space<dim>(stress);
      at.S33 = stress[2][2];
      this->add_forces(cell, q, at, residual);
      return is_large
               ? std::min({1., determinant(at.F) * at.f33, states.theta[q]})
               : 1.;
    }



    template<class Kinematics, class Symmetry>
    double MaterialCells<Kinematics, Symmetry>::add_forces_alone(
      const CellTable<dim> &cell,
      const Vector<double> &u,
      Vector<double>       &residual) const
    {
      const States states   = this->states(cell, u);
      double       smallest = 1;
      PointState   at;
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        smallest = std::min(smallest,
                            add_forces_at(cell,
                                          q,
                                          u,
                                          states,
                                          law.shear_stress(states.E[q],
                                                           history(cell, q)),
                                          at,
                                          residual));
      return smallest;
    }



    template<class Kinematics, class Symmetry>
    template<bool projected>
    double MaterialCells<Kinematics, Symmetry>::assemble(
      const CellTable<dim> &cell,
      const Vector<double> &u,
      const StressStiffness stress_stiffness,
      FullMatrix<double>   &tangent,
      Vector<double>       &residual) const
    {
      constexpr bool is_large = Kinematics::has_geometric_stiffness;
      const bool     without  = stress_stiffness == StressStiffness::without;
      using Row               = typename Symmetry::StrainRow;
      const unsigned int n    = cell.n_nodes();
      const unsigned int n_points = cell.JxW.size();
      const States       states   = this->states(cell, u);

      std::array<std::array<double, dim * n_max>, n_modes> g{};
      std::array<std::array<double, n_modes>, n_modes>     moduli{};
      double                                               smallest = 1;
      PointState                                           at;
      for (unsigned int q = 0; q < n_points; ++q)
        {
          const auto &volume = states.volume[q];
          auto response = law.shear_part(states.E[q], history(cell, q), true);
          smallest      = std::min(
            smallest,
            add_forces_at(cell, q, u, states, response.stress, at, residual));

          // Without their part of the tangent the moduli are those at rest.
          double modulus = states.modulus[q];
          if (is_large && without)
            {
              const SymmetricTensor<2, 3> rest;
              response.tangent =
                law.shear_part(rest, history(cell, q), true).tangent;
              modulus = law.volume_energy(law.volume(rest).value).modulus;
              at.drop_stresses();
            }
          else if (stress_stiffness == StressStiffness::change_by_yielding)
            {
              response.tangent -= law.elastic_moduli();
              modulus = 0;
            }
          else if constexpr (is_large)
            response.tangent += states.p[q] * law.volume_curvature(states.E[q]);
          if constexpr (!projected)
            response.tangent +=
              modulus * outer_product(volume.slope, volume.slope);

          std::array<Row, std::tuple_size<Row>::value> D;
          Row                                          slope;
          for (unsigned int k = 0; k < D.size(); ++k)
            {
              const auto [i, j] = indices(k);
              slope[k]          = at.JxW * volume.slope[i][j];
              for (unsigned int l = 0; l < D.size(); ++l)
                {
                  const auto [r, s] = indices(l);
                  D[k][l]           = at.JxW * response.tangent[i][j][r][s];
                }
            }
          const auto times = [](const Row &row, const Row &B) {
            double sum = 0;
            for (unsigned int l = 0; l < B.size(); ++l)
              sum += row[l] * B[l];
            return sum;
          };
          this->add_rows(cell, q, at);
          this->add_tangent(
            at,
            n,
            [&](const Row &B) {
              Row DB;
              for (unsigned int k = 0; k < B.size(); ++k)
                DB[k] = times(D[k], B);
              return DB;
            },
            tangent);
          if constexpr (projected)
            for (unsigned int m = 0; m < n_modes; ++m)
              {
                for (unsigned int a = 0; a < n; ++a)
                  for (unsigned int i = 0; i < dim; ++i)
                    g[m][dim * a + i] +=
                      cell.modes[q][m] * times(slope, at.B[a][i]);
                for (unsigned int l = 0; l < n_modes; ++l)
                  moduli[m][l] +=
                    at.JxW * modulus * cell.modes[q][m] * cell.modes[q][l];
              }
        }
      if constexpr (projected)
        for (unsigned int m = 0; m < n_modes; ++m)
          for (unsigned int i = 0; i < dim * n; ++i)
            {
              double Hg = 0;
              for (unsigned int l = 0; l < n_modes; ++l)
                Hg += moduli[m][l] * g[l][i];
              for (unsigned int j = i; j < dim * n; ++j)
                tangent(i, j) += Hg * g[m][j];
            }
      this->mirror(tangent);
      return smallest;
    }



    template<class Kinematics, class Symmetry>
    double
    MaterialCells<Kinematics, Symmetry>::energy(const CellTable<dim> &cell,
                                                const Vector<double> &u) const
    {
      const States states = this->states(cell, u);
      double       energy = 0;
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        energy += cell.JxW[q] *
                  (law.shear_part(states.E[q], history(cell, q), false).energy +
                   states.energy[q]);
      return energy;
    }



    template<class Kinematics, class Symmetry>
    std::vector<SymmetricTensor<2, 3>>
    MaterialCells<Kinematics, Symmetry>::stresses(const CellTable<dim> &cell,
                                                  const Vector<double> &u) const
    {
      const States                       states = this->states(cell, u);
      std::vector<SymmetricTensor<2, 3>> stresses;
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        stresses.push_back(Kinematics::cauchy(
          Integrals::displacement_gradient(cell, q, u),
          Integrals::hoop_gradient(cell, q, u),
          law.shear_part(states.E[q], history(cell, q), false).stress +
            states.p[q] * states.volume[q].slope));
      return stresses;
    }



    template<class Kinematics, class Symmetry>
    double MaterialCells<Kinematics, Symmetry>::integral_of_trace(
      const CellTable<dim> &cell,
      const Vector<double> &u) const
    {
      const States states = this->states(cell, u);
      double       sum    = 0;
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        sum +=
          cell.JxW[q] *
          trace(law.shear_part(states.E[q], history(cell, q), false).stress +
                states.p[q] * states.volume[q].slope);
      return sum;
    }



    template<class Kinematics, class Symmetry>
    std::vector<double> MaterialCells<Kinematics, Symmetry>::history_at(
      const CellTable<dim> &cell,
      const Vector<double> &u) const
    {
      std::vector<double> history = cell.history;
      if (law.n_history() > 0)
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          law.advance(this->strain(cell, q, u), &history[q * law.n_history()]);
      return history;
    }



    // Without a history by two rules, whose difference is an error bound; d
    // near one is known to its round-off, U(d) to p times that.
    template<class Kinematics, class Symmetry>
    typename MaterialCells<Kinematics, Symmetry>::Works
    MaterialCells<Kinematics, Symmetry>::works(const CellTable<dim> &cell,
                                               const Vector<double> &u_0,
                                               const Vector<double> &u_1) const
    {
      Works works;
      if (law.n_history() == 0)
        {
          const auto rates  = this->work_rates(cell, u_0, u_1, 5);
          const auto coarse = [](const std::vector<double> &all) {
            return std::vector<double>{all[0], all[2], all[4]};
          };
          works.path    = this->path_work(rates.work);
          works.thermal = this->integral(rates.thermal);
          works.error =
            std::abs(works.path - this->path_work(coarse(rates.work))) +
            std::abs(works.thermal - this->integral(coarse(rates.thermal)));
          for (const auto *u : {&u_0, &u_1})
            {
              const States states = this->states(cell, *u);
              for (unsigned int q = 0; q < cell.JxW.size(); ++q)
                works.error += std::numeric_limits<double>::epsilon() *
                               cell.JxW[q] * std::abs(states.p[q]);
            }
          return works;
        }
      for (unsigned int q = 0; q < cell.JxW.size(); ++q)
        {
          const auto at_point =
            law.works(this->strain(cell, q, u_0, cell.thermal_before),
                      this->strain(cell, q, u_1),
                      history(cell, q));
          works.dissipation += cell.JxW[q] * at_point.dissipation;
          works.path += cell.JxW[q] * at_point.path;
        }
      const double change = cell.thermal - cell.thermal_before;
      if (change != 0)
        {
          CellTable<dim> start = cell;
          start.thermal        = cell.thermal_before;
          works.thermal =
            -0.5 * change *
            (integral_of_trace(start, u_0) + integral_of_trace(cell, u_1));
        }
      return works;
    }
  } // namespace



  template<int dim>
  std::unique_ptr<CellKernel<dim>>
  make_material_cells(const Material    &elastic,
                      const MaterialLaw &law,
                      const bool         is_small_strain,
                      const bool         axisymmetric)
  {
    return with_kinematics<dim>(
      is_small_strain,
      axisymmetric,
      [&](const auto kinematics,
          const auto symmetry) -> std::unique_ptr<CellKernel<dim>> {
        return std::make_unique<
          MaterialCells<std::decay_t<decltype(kinematics)>,
                        std::decay_t<decltype(symmetry)>>>(elastic, law);
      });
  }

  template std::unique_ptr<CellKernel<2>>
  make_material_cells(const Material &,
                      const MaterialLaw &,
                      const bool,
                      const bool);
  template std::unique_ptr<CellKernel<3>>
  make_material_cells(const Material &,
                      const MaterialLaw &,
                      const bool,
                      const bool);
} // namespace Contact
