/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Materials that are not linear elastic, in 2-D, of rings and in 3-D,
// with the full and with the projected dilatation, yielding ones in small
// strain and at large strain:
//  - the tangent is the derivative of the forces, also while points yield, that
//    have yielded before;
//  - forces are the derivative of the energy (rubber);
//  - what is stored and dissipated is the work of the forces, in increments of
//    any size; an accepted increment leaves forces and energy as they are;
//  - uniaxial, equibiaxial stretch and simple shear of a neo-Hookean material
//    and of that of Mooney and Rivlin,
//    and cyclic uniaxial yielding with each kind of hardening are exact.

#include <cmath>

#include "derivatives.h"
#include "solid/materials/elastic_plastic.h"
#include "solid/materials/mooney_rivlin.h"
#include "volume_mesh.h"

using namespace Tests;

namespace
{
  Parameters::All plane(const unsigned int degree)
  {
    MeshText mesh;
    mesh.block(
      "Body",
      2,
      2,
      [](const double s, const double t) {
        const double bump = s * (1 - s) * t * (1 - t);
        return Point<2>(1 + 2 * s + bump, 2 * t - 0.7 * bump);
      },
      [](const unsigned int i, const unsigned int j) { return i + j == 2; });
    return make_parameters(mesh, {"Body"}, degree, "small strain", 1000, 0.4);
  }



  Parameters::All space(const unsigned int degree)
  {
    VolumeText text;
    text.block("Body", {{1, 1, 2}}, [](const Point<3> &s) {
      return Point<3>(s[0] + 0.1 * s[1] * s[2], s[1] - 0.1 * s[0], 2 * s[2]);
    });
    text.write("volume.msh");
    Parameters::All parameters = plane(degree);
    parameters.mesh.file       = "volume.msh";
    return parameters;
  }



  constexpr double C01 = 60; // of a shear modulus of 357



  /// By default rubber is in large displacement, a body that yields in small
  /// strain.
  void set_material(const std::string  &material,
                    const bool          yields_at_large_strain,
                    Parameters::Solids &solids)
  {
    const Parameters::Choice<Parameters::MaterialModel> model(material);
    solids.material.emplace("Body", model);
    if (model == Parameters::MaterialModel::mooney_rivlin)
      solids.mooney_rivlin_constant["Body"] = C01;
    if (model != Parameters::MaterialModel::elastic_plastic)
      {
        solids.kinematics = Parameters::Strains::large;
        return;
      }
    if (yields_at_large_strain)
      solids.kinematics = Parameters::Strains::large;
    solids.yield_stress["Body"]                = 10;
    solids.hardening_modulus["Body"]           = 50;
    solids.kinematic_hardening_modulus["Body"] = 30;
    solids.saturation_stress["Body"]           = 20;
    solids.saturation_rate["Body"]             = 40;
  }



  template<int dim>
  GhostedVector any(const BodiesIn<dim> &bodies, const double size)
  {
    static Random random;
    GhostedVector u(bodies.n_dofs());
    for (double &value : u)
      value = random(-size, size);
    return u;
  }



  template<int dim>
  void check_bodies(const std::string &what, Parameters::All parameters)
  {
    const std::string large = "elastic-plastic, large strain";
    for (const std::string &material : {std::string("elastic-plastic"),
                                        large,
                                        std::string("neo-Hookean"),
                                        std::string("Mooney-Rivlin")})
      for (const std::string dilatation : {"full", "B-bar"})
        {
          headline(what + ", " + material + ", " + dilatation);
          Parameters::All here   = parameters;
          here.solids.dilatation = dilatation;
          set_material(material == large ? "elastic-plastic" : material,
                       material == large,
                       here.solids);
          here.solids.check();
          const BodiesIn<dim> bodies(here);
          Elasticity<dim>    &elasticity = *bodies.elasticity;
          const bool          yields     = !here.solids.yield_stress.empty();
          const double size = !yields ? 0.05 : material == large ? 0.1 : 0.03;

          const GhostedVector zero(bodies.n_dofs());
          const GhostedVector first  = any(bodies, size);
          const auto          energy = [&](const GhostedVector &u) {
            return elasticity.strain_energy(u);
          };
          // Yielding has a dissipation beside its energy.
          const auto balance = [&](const GhostedVector &u_0,
                                   const GhostedVector &u_1) {
            GhostedVector mean = elasticity.forces(u_0, 0);
            mean += elasticity.forces(u_1, 0);
            GhostedVector d = u_1;
            d -= u_0;
            const auto   works = elasticity.works(u_0, u_1);
            const double work  = 0.5 * (mean * d);
            check_small("balance of the energy",
                        (std::abs(energy(u_1) - energy(u_0) +
                                  works.dissipation - work - works.path) -
                         works.error) /
                          energy(u_1),
                        1e-12);
            check("dissipation", yields == (works.dissipation > 0));
          };
          balance(zero, first);

          const GhostedVector before = elasticity.forces(first, 0);
          const double        stored = energy(first);
          elasticity.accept(first);
          GhostedVector after = elasticity.forces(first, 0);
          after -= before;
          check_small("accepted: change of the forces",
                      after.linfty_norm() / before.linfty_norm(),
                      1e-13);
          check_small("and of the energy",
                      std::abs(energy(first) / stored - 1),
                      1e-13);

          const GhostedVector second = any(bodies, size);
          balance(first, second);
          const auto found = compare_with_differences(bodies, second, energy);
          if (!yields)
            check_small("forces against differences of the energy",
                        found.forces,
                        1e-8);
          check_small("tangent against those of the forces",
                      found.tangent,
                      1e-7);
          check_small("asymmetry", found.asymmetry, 1e-13);
          check("not linear", !elasticity.is_linear());
        }
  }



  SymmetricTensor<2, 3> cauchy_stress(const MaterialLaw  &law,
                                      const Tensor<2, 3> &F)
  {
    const SymmetricTensor<2, 3> E =
      0.5 * (symmetrize(transpose(F) * F) - unit_symmetric_tensor<3>());
    const auto volume = law.volume(E);
    const auto S      = law.shear_part(E, nullptr, false).stress +
                   law.volume_energy(volume.value).pressure * volume.slope;
    return symmetrize(F * static_cast<Tensor<2, 3>>(S) * transpose(F)) /
           determinant(F);
  }



  // F of diagonal stretches, and the Cauchy stress by its principal values
  //   J sigma_i = 2 C10 J^(-2/3) (l_i^2 - I_1/3)
  //               + 2 C01 J^(-4/3) (l_i^2 (I_1 - l_i^2) - 2/3 I_2)
  //               + K/2 (J^2 - 1).
  void rubber(const std::string &name, const MaterialLaw &law, const double C01)
  {
    headline(name + ", closed forms");
    const Material elastic(1000, 0.4);
    const double   mu = elastic.mu, K = elastic.lambda + 2. / 3 * mu;
    const double   C10 = mu / 2 - C01;
    for (const auto &l : {Point<3>(1.7, 0.8, 0.8),
                          Point<3>(1.4, 1.4, 0.5),
                          Point<3>(0.4, 1, 1)})
      {
        Tensor<2, 3> F;
        for (unsigned int i = 0; i < 3; ++i)
          F[i][i] = l[i];
        const double J   = l[0] * l[1] * l[2];
        const double I_1 = l.norm_square();
        const double I_2 =
          J * J * (1 / (l[0] * l[0]) + 1 / (l[1] * l[1]) + 1 / (l[2] * l[2]));
        const auto sig   = cauchy_stress(law, F);
        double     error = 0;
        for (unsigned int i = 0; i < 3; ++i)
          {
            const double square = l[i] * l[i];
            error =
              std::max(error,
                       std::abs(
                         sig[i][i] -
                         (2 * C10 * std::pow(J, -2. / 3) * (square - I_1 / 3) +
                          2 * C01 * std::pow(J, -4. / 3) *
                            (square * (I_1 - square) - 2. / 3 * I_2) +
                          K / 2 * (J * J - 1)) /
                           J));
          }
        check_small("stretch", error / mu, 1e-13);
      }
    // Simple shear: sigma_xy = mu g, sigma_xx - sigma_zz = 2 C10 g^2, sigma_yy
    // - sigma_zz = -2 C01 g^2.
    const double g = 1.3;
    Tensor<2, 3> F = static_cast<Tensor<2, 3>>(unit_symmetric_tensor<3>());
    F[0][1]        = g;
    const auto sig = cauchy_stress(law, F);
    check_small("simple shear",
                std::abs(sig[0][1] / (mu * g) - 1) +
                  std::abs(sig[0][0] - sig[2][2] - 2 * C10 * g * g) / mu +
                  std::abs(sig[1][1] - sig[2][2] + 2 * C01 * g * g) / mu +
                  std::abs(trace(sig)) / mu,
                1e-13);
  }



  // Uniaxial stress along x to and fro, the strains across found by Newton's
  // method: without volume change of plastic strains the axial plastic strain p
  // and its total way a give
  //   |sigma - H_k p| = Y(a).
  void cyclic(const std::string &name, const Hardening &hardening)
  {
    const Material       elastic(1000, 0.3);
    const ElasticPlastic law(elastic, hardening);
    const double         K = elastic.lambda + 2. / 3 * elastic.mu;
    std::vector<double>  history(law.n_history());
    double               error = 0, way = 0, last = 0;
    for (const double strain : {0.03, 0.06, -0.05, -0.08, 0.04, 0.041})
      {
        SymmetricTensor<2, 3> E;
        E[0][0]       = strain;
        double across = -0.4 * strain, stress = 0;
        for (unsigned int step = 0; step < 30; ++step)
          {
            E[1][1] = E[2][2] = across;
            auto response     = law.shear_part(E, history.data(), true);
            response.stress += K * trace(E) * unit_symmetric_tensor<3>();
            const double slope = response.tangent[1][1][1][1] +
                                 response.tangent[1][1][2][2] + 2 * K;
            across -= response.stress[1][1] / slope;
            stress = response.stress[0][0];
          }
        law.advance(E, history.data());
        const double p = strain - stress / elastic.youngs_modulus;
        way += std::abs(p - last);
        last  = p;
        error = std::max({error,
                          std::abs(std::abs(stress - hardening.kinematic * p) -
                                   hardening.at(way).stress) /
                            hardening.initial,
                          std::abs(history[0] - way)});
      }
    check_small("cyclic, " + name, error, 1e-13);
  }



  // Sheared by any angle at once, a curve that is flat, steep and flat again
  // is met: sqrt(3) tau = Y(a).
  void steps()
  {
    Hardening hardening{10};
    hardening.kinematic = 1;
    hardening.curve     = {{0, 10},
                           {0.01, 10},
                           {0.0101, 18},
                           {0.0102, 18},
                           {0.011, 40}};
    const Material       elastic(1000, 0.3);
    const ElasticPlastic law(elastic, hardening);
    double               error = 0;
    for (unsigned int k = 1; k <= 1000; ++k)
      {
        SymmetricTensor<2, 3> E;
        E[0][1] = 5e-5 * k;
        std::vector<double> history(law.n_history());
        const double        tau =
          law.shear_part(E, history.data(), false).stress[0][1];
        law.advance(E, history.data());
        const double a = history[0];
        if (a > 0)
          error =
            std::max(error,
                     std::abs(std::sqrt(3.) * tau - hardening.kinematic * a -
                              hardening.at(a).stress) /
                       hardening.initial);
      }
    check_small("sheared, a curve of steps", error, 1e-12);
  }
} // namespace



int main()
{
  for (const unsigned int degree : {1, 2})
    {
      const std::string name = ", degree " + std::to_string(degree);
      check_bodies<2>("plane strain" + name, plane(degree));
      Parameters::All rings = plane(degree);
      rings.solids.symmetry = "axisymmetric";
      check_bodies<2>("rings" + name, rings);
    }
  check_bodies<3>("space, degree 1", space(1));
  const Material elastic(1000, 0.4);
  rubber("neo-Hookean", NeoHookean(elastic), 0);
  rubber("Mooney-Rivlin", MooneyRivlin(elastic, C01), C01);
  headline("yielding to and fro");
  cyclic("perfectly plastic", {10});
  cyclic("linear", {10, 50});
  cyclic("Voce", {10, 20, 10, 40});
  cyclic("kinematic", {10, 0, 0, 0, 100});
  Hardening curve{10};
  curve.kinematic = 20;
  curve.curve     = {{0, 10}, {0.02, 18}, {0.1, 20}, {0.15, 30}};
  cyclic("curve and kinematic", curve);
  steps();
  return 0;
}
