/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

#include "solid/cell_kernel.h"
#include "solid/cell_point.h"
#include "solid/cell_tangent.h"
#include "solid/materials/linear_elastic.h"

namespace Contact
{
  namespace
  {
    /**
     * The cells of a body of any material; LinearElastic is known by its type.
     * With the measure of volume d, theta = P d and p = P U'(theta), P the
     * identity or the projection of Elasticity,
     *   S = shear part + p dd/dE,
     * and the tangent has the moduli of the shear part + p d2d/dE2 and
     *   sum_mn H_mn g_m g_n^T,   H_mn = sum_q JxW U''(theta) phi_m phi_n,
     * g_m the internal forces of the stresses T_m = phi_m dd/dE.
     *
     * Elastic cells of degree 1 with incompatible modes assume the strains
     *   E + sum_m alpha_m M_m,
     * E that of the displacement, the alpha_m those of the least energy: a cell
     * bends without shear (J. C. Simo and M. S. Rifai, Int. J. Numer. Methods
     * Eng. 29, 1990, 1595-1638; the incompatible modes of Wilson and Taylor).
     * With the Jacobian J, that in the centre J_0 and the coordinates xi_i from
     * -1/2 to 1/2 the modes are combinations of
     *   J_0^-T e_ij J_0^-1 xi_k / det J - its mean,   i <= j, k = i or j:
     * a constant stress does no work on them, so the patch test is passed. With
     * integral M_m : D : M_n = delta_mn and the stresses T_m = D M_m they leave
     * no unknown, in large displacement as well, because S is linear in the
     * strain:
     *   alpha_m = -integral T_m : E,   S = D E + sum_m alpha_m T_m,
     *   energy = that of E - 1/2 sum_m alpha_m^2,
     * and H_mn = -delta_mn. Cells that are compressed by much may buckle in the
     * pattern of an hourglass (P. Wriggers and S. Reese, Comput. Methods Appl.
     * Mech. Eng. 135, 1996, 201-209).
     */
    template<class Kinematics, class Symmetry, class Law>
    class CellIntegrals : public CellKernel<Symmetry::dim>
    {
    public:
      static constexpr int dim = Symmetry::dim;

      CellIntegrals(const Material &elastic, const Law &law)
        : CellKernel<dim>(law)
        , elastic(elastic)
        , law(law)
      {
      }

      bool is_small_strain() const override
      {
        return !is_large;
      }

      // In plane strain plastic strains leave a stress across the plane that
      // those in 2-D do not tell.
      double energy_density(const SymmetricTensor<2, 3> &stress) const override
      {
        return is_elastic ? Symmetry::energy_density(elastic, stress)
                          : elastic.energy_density(stress);
      }

      double forces(const CellTable<dim> &cell,
                    const Vector<double> &u,
                    const StressStiffness stress_stiffness,
                    FullMatrix<double>   *tangent,
                    Vector<double>       &forces) const override
      {
        const bool                         with_tangent = tangent != nullptr;
        const auto                         states       = this->states(cell, u);
        double                             smallest     = 1;
        CellAt                             at;
        StressFields<Kinematics, Symmetry> fields(cell);
        for (unsigned int q = 0; q < states.size(); ++q)
          {
            const State &state  = states[q];
            const auto   shears = this->shears(cell, q, state, with_tangent);
            at.reinit(cell, q, state.H, state.h);
            at.set_stress(shears.stress + state.stress);
            at.add_forces(forces);
            if constexpr (is_large)
              smallest =
                std::min({smallest,
                          at.volume_ratio(),
                          is_elastic ? 1. : law.volume_ratio(state.theta)});
            if (!with_tangent)
              continue;

            // In the tangent stresses are in nothing else.
            if (stress_stiffness == StressStiffness::without)
              at.set_stress(SymmetricTensor<2, 3>());
            const auto [moduli, of_volume] =
              this->moduli(cell, q, state, shears.tangent, stress_stiffness);
            at.add_tangent(moduli, *tangent);
            fields.add(q, state.volume.slope, of_volume, at);
          }
        if (with_tangent)
          {
            fields.add_to(*tangent);
            for (unsigned int i = 0; i < tangent->m(); ++i)
              for (unsigned int j = 0; j < i; ++j)
                (*tangent)(i, j) = (*tangent)(j, i);
          }
        return smallest;
      }

      double energy(const CellTable<dim> &cell,
                    const Vector<double> &u) const override
      {
        const auto states = this->states(cell, u);
        double     energy = 0;
        for (unsigned int q = 0; q < states.size(); ++q)
          energy += cell.JxW[q] * (law
                                     .shear_part(states[q].E,
                                                 this->history(cell, q),
                                                 /*with_tangent=*/false)
                                     .energy +
                                   states[q].energy);
        return energy;
      }

      std::vector<SymmetricTensor<2, 3>>
      stresses(const CellTable<dim> &cell,
               const Vector<double> &u) const override
      {
        const auto                         states = this->states(cell, u);
        std::vector<SymmetricTensor<2, 3>> stresses;
        stresses.reserve(states.size());
        for (unsigned int q = 0; q < states.size(); ++q)
          stresses.push_back(Kinematics::cauchy(states[q].H,
                                                states[q].h,
                                                stress(cell, q, states[q])));
        return stresses;
      }

      std::vector<SymmetricTensor<2, 3>>
      strains(const CellTable<dim> &cell,
              const Vector<double> &u) const override
      {
        std::vector<SymmetricTensor<2, 3>> strains;
        strains.reserve(cell.JxW.size());
        for (unsigned int q = 0; q < cell.JxW.size(); ++q)
          strains.push_back(strain(CellAt::displacement_gradient(cell, q, u),
                                   CellAt::hoop_gradient(cell, q, u),
                                   cell.thermal));
        return strains;
      }

      double integral_of_trace(const CellTable<dim> &cell,
                               const Vector<double> &u) const override
      {
        const auto states = this->states(cell, u);
        double     sum    = 0;
        for (unsigned int q = 0; q < states.size(); ++q)
          sum += cell.JxW[q] * trace(stress(cell, q, states[q]));
        return sum;
      }

      double work_of_pressures(const CellTable<dim> &cell,
                               const Vector<double> &u_0,
                               const Vector<double> &u_1) const override
      {
        const auto before = states(cell, u_0), after = states(cell, u_1);
        double     work = 0;
        for (unsigned int q = 0; q < after.size(); ++q)
          work += cell.JxW[q] * 0.5 * (before[q].p + after[q].p) *
                  (after[q].theta - before[q].theta);
        return work;
      }

      // d near one is known to its round-off, U(d) to p times that.
      double round_off_of_energy(const CellTable<dim> &cell,
                                 const Vector<double> &u) const override
      {
        const auto states = this->states(cell, u);
        double     error  = 0;
        for (unsigned int q = 0; q < states.size(); ++q)
          error += std::numeric_limits<double>::epsilon() * cell.JxW[q] *
                   std::abs(states[q].p);
        return error;
      }

    private:
      using CellAt = CellPoint<Kinematics, Symmetry>;

      static constexpr bool is_elastic = std::is_same_v<Law, LinearElastic>;
      static constexpr bool is_large   = Kinematics::has_geometric_stiffness;

      /// A point: the displacement gradient, the strain in 3-D, the measure of
      /// volume, what follows from P d, and the stress beside that of shears.
      struct State
      {
        Tensor<2, dim>        H;
        double                h;
        SymmetricTensor<2, 3> E;
        MaterialLaw::Volume   volume;
        double                theta, p, modulus, energy;
        SymmetricTensor<2, 3> stress;
      };
      using States = boost::container::static_vector<State, CellAt::n_max>;

      // Where the pressure is linear in theta, it is projected already.
      DEAL_II_ALWAYS_INLINE States states(const CellTable<dim> &cell,
                                          const Vector<double> &u) const
      {
        States states(cell.JxW.size(), boost::container::default_init);
        for (unsigned int q = 0; q < states.size(); ++q)
          {
            State &state = states[q];
            state.H      = CellAt::displacement_gradient(cell, q, u);
            state.h      = CellAt::hoop_gradient(cell, q, u);
            state.E      = strain(state.H, state.h, cell.thermal);
            state.volume = law.volume(state.E);
            state.theta  = state.volume.value;
          }
        project(cell, states, &State::theta);
        for (State &state : states)
          {
            const auto U  = law.volume_energy(state.theta);
            state.p       = U.pressure;
            state.modulus = U.modulus;
            state.energy  = U.energy;
          }
        if (!is_elastic)
          project(cell, states, &State::p);
        for (State &state : states)
          state.stress = state.p * state.volume.slope;
        if (!cell.stress_modes.empty())
          assume_strains(cell, states);
        return states;
      }

      /// The strain that has a stress, E - e I with the thermal strain e.
      static DEAL_II_ALWAYS_INLINE SymmetricTensor<2, 3>
      strain(const Tensor<2, dim> &H, const double h, const double thermal)
      {
        const auto            in_space = Kinematics::strain(H);
        SymmetricTensor<2, 3> E;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            E[i][j] = in_space[i][j];
        if constexpr (Symmetry::has_hoop)
          E[2][2] = Kinematics::strain(h);
        for (unsigned int i = 0; i < 3; ++i)
          E[i][i] -= thermal;
        return E;
      }

      /// The orthonormal modes phi_m of the cell take the place of all else:
      ///   P d = sum_m theta_m phi_m,   theta_m = sum_q JxW phi_m d.
      static void project(const CellTable<dim> &cell,
                          States               &states,
                          double State::*const value)
      {
        if (cell.modes.empty())
          return;
        std::array<double, dim + 1> theta{};
        for (unsigned int q = 0; q < states.size(); ++q)
          for (unsigned int m = 0; m < theta.size(); ++m)
            theta[m] += cell.JxW[q] * cell.modes[q][m] * states[q].*value;
        for (unsigned int q = 0; q < states.size(); ++q)
          {
            states[q].*value = 0;
            for (unsigned int m = 0; m < theta.size(); ++m)
              states[q].*value += theta[m] * cell.modes[q][m];
          }
      }

      /// Add the stresses and the energy of the strains that the cell assumes:
      /// -1/2 sum_m alpha_m^2 is the integral of half these stresses by E.
      static void assume_strains(const CellTable<dim> &cell, States &states)
      {
        std::array<double, dim * dim> alpha{};
        for (unsigned int q = 0; q < states.size(); ++q)
          for (unsigned int m = 0; m < alpha.size(); ++m)
            alpha[m] -= cell.JxW[q] * (cell.stress_modes[q][m] * states[q].E);
        for (unsigned int q = 0; q < states.size(); ++q)
          for (unsigned int m = 0; m < alpha.size(); ++m)
            {
              const auto stress = alpha[m] * cell.stress_modes[q][m];
              states[q].stress += stress;
              states[q].energy += 0.5 * (stress * states[q].E);
            }
      }

      DEAL_II_ALWAYS_INLINE MaterialLaw::Response
                            shears(const CellTable<dim> &cell,
                                   const unsigned int    q,
                                   const State          &state,
                                   const bool            with_tangent) const
      {
        if (with_tangent && !is_elastic)
          return law.shear_part(state.E, this->history(cell, q), with_tangent);
        MaterialLaw::Response shears;
        shears.stress = law.shear_stress(state.E, this->history(cell, q));
        return shears;
      }

      SymmetricTensor<2, 3> stress(const CellTable<dim> &cell,
                                   const unsigned int    q,
                                   const State          &state) const
      {
        return law.shear_stress(state.E, this->history(cell, q)) + state.stress;
      }

      /// The moduli at a point, and that of the volume, which they are without
      /// where it is projected. Without the part of the stresses that of the
      /// volume is the one at rest.
      DEAL_II_ALWAYS_INLINE auto moduli(const CellTable<dim> &cell,
                                        const unsigned int    q,
                                        const State          &state,
                                        SymmetricTensor<4, 3> tangent,
                                        const StressStiffness stiffness) const
      {
        const bool projected = !cell.modes.empty();
        double     of_volume = state.modulus;
        if constexpr (is_elastic)
          return std::make_pair(IsotropicModuli<Symmetry>{cell.JxW[q],
                                                          projected ? 0.
                                                                    : of_volume,
                                                          law.mu},
                                of_volume);
        else
          {
            if (is_large && stiffness == StressStiffness::without)
              {
                const SymmetricTensor<2, 3> rest;
                tangent =
                  law.moduli_without_stress(state.E, this->history(cell, q));
                of_volume = law.volume_energy(law.volume(rest).value).modulus;
              }
            else if (stiffness == StressStiffness::change_by_yielding)
              {
                tangent -= law.elastic_moduli();
                of_volume = 0;
              }
            else if (is_large)
              tangent += state.p * law.volume_curvature(state.E);
            if (!projected)
              tangent += of_volume *
                         outer_product(state.volume.slope, state.volume.slope);
            return std::make_pair(Moduli<Symmetry>(cell.JxW[q], tangent),
                                  of_volume);
          }
      }

      const Material &elastic;
      const Law      &law;
    };
  } // namespace



  template<int dim>
  std::unique_ptr<CellKernel<dim>>
  CellKernel<dim>::create(const Material    &elastic,
                          const MaterialLaw &law,
                          const bool         is_small_strain,
                          const bool         axisymmetric)
  {
    const auto with_law = [&](auto kinematics, auto symmetry, const auto &law) {
      return std::unique_ptr<CellKernel<dim>>(
        std::make_unique<CellIntegrals<decltype(kinematics),
                                       decltype(symmetry),
                                       std::decay_t<decltype(law)>>>(elastic,
                                                                     law));
    };
    const auto with_kinematics = [&](auto kinematics, auto symmetry) {
      if (const auto *linear = dynamic_cast<const LinearElastic *>(&law))
        return with_law(kinematics, symmetry, *linear);
      return with_law(kinematics, symmetry, law);
    };
    const auto with_symmetry = [&](auto symmetry) {
      return is_small_strain ? with_kinematics(SmallStrain(), symmetry)
                             : with_kinematics(LargeDisplacement(), symmetry);
    };
    if constexpr (dim == 3)
      return with_symmetry(Space());
    else
      return axisymmetric ? with_symmetry(Axisymmetric())
                          : with_symmetry(PlaneStrain());
  }

  template std::unique_ptr<CellKernel<2>>
  CellKernel<2>::create(const Material &,
                        const MaterialLaw &,
                        const bool,
                        const bool);
  template std::unique_ptr<CellKernel<3>>
  CellKernel<3>::create(const Material &,
                        const MaterialLaw &,
                        const bool,
                        const bool);
} // namespace Contact
