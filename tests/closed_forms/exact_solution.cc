/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "closed_forms/exact_solution.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/hp/fe_values.h>

#include "closed_forms/concentric_cylinders.h"
#include "closed_forms/half_plane.h"

namespace Tests
{
  namespace
  {
    /// The slave node with the smallest initial gap.
    unsigned int first_touch(const ContactPair<2> &contact_pair)
    {
      const DeformedSurface<2> master(*contact_pair.master, {});
      const auto               gap_square = [&](const SurfaceNode<2> &node) {
        return master.distance_square(node.X, master.closest_point(node.X));
      };
      const auto &nodes = contact_pair.slave.nodes;
      return std::min_element(nodes.begin(),
                              nodes.end(),
                              [&](const auto &a, const auto &b) {
                                return gap_square(a) < gap_square(b);
                              }) -
             nodes.begin();
    }



    /// Elements over the half width of contact of the half planes: their ends
    /// of contact and sticking are good to a tenth of one.
    constexpr unsigned int n_half_plane_elements = 200;



    HertzLineContact hertz_contact(const ClosedForm      &form,
                                   const Parameters::All &parameters,
                                   const TwoBodies       &model,
                                   const ContactResults  &results)
    {
      const auto &pair   = *model.interface.pairs[0];
      const auto &solids = parameters.solids;
      const auto  slave  = model.mesh.body_name(pair.slave.facets[0].body);
      const auto  master = model.mesh.body_name(pair.master->facets[0].body);
      return {form.numbers.at(0),
              form.numbers.size() > 1 ? form.numbers[1] : results.normal_force,
              solids.youngs_modulus.at(slave),
              solids.poisson.at(slave),
              solids.youngs_modulus.at(master),
              solids.poisson.at(master)};
    }



    /// Shear along the tangent of the master, as the force that was found.
    void add_mindlin(const HertzLineContact &hertz,
                     const double            mu,
                     const double            axis,
                     const ContactResults   &results,
                     ExactSolution          &exact)
    {
      // If all points slide, round-off must not make the shear larger than
      // friction.
      const double          limit = mu * hertz.force;
      const CattaneoMindlin mindlin{hertz,
                                    mu,
                                    std::clamp(results.tangential_force,
                                               -limit,
                                               limit)};
      exact.shear = [=](const Point<2> &X) {
        return mindlin.shear(X[0] - axis);
      };
      exact.values["stick_half_width"] = mindlin.stick_half_width();
      exact.values["max_shear"]        = mindlin.max_shear();
    }



    /// Both tractions; @p along_x is the sign of the tangent of the master.
    void add_half_planes(const HertzLineContact &hertz,
                         const double            mu,
                         const unsigned int      n_increments,
                         const double            axis,
                         const double            along_x,
                         ExactSolution          &exact)
    {
      const auto planes =
        std::make_shared<HalfPlaneContact>(hertz,
                                           mu,
                                           n_increments,
                                           n_half_plane_elements);
      exact.pressure = [=](const Point<2> &X) {
        return planes->pressure(X[0] - axis);
      };
      exact.shear = [=](const Point<2> &X) {
        return along_x * planes->shear(X[0] - axis);
      };
      exact.values["half_width"]       = planes->half_width();
      exact.values["max_pressure"]     = planes->max_pressure();
      exact.values["stick_half_width"] = planes->stick_half_width();
      exact.values["max_shear"]        = planes->max_shear();
    }



    ExactSolution make_hertz(const ClosedForm      &form,
                             const Parameters::All &parameters,
                             const TwoBodies       &model,
                             const ContactResults  &results)
    {
      const ContactPair<2>  &contact_pair = *model.interface.pairs[0];
      const HertzLineContact hertz =
        hertz_contact(form, parameters, model, results);
      const unsigned int node = first_touch(contact_pair);
      const double       axis = contact_pair.slave.nodes[node].X[0];

      ExactSolution exact;
      exact.values["half_width"]   = hertz.half_width();
      exact.values["max_pressure"] = hertz.max_pressure();
      exact.pressure               = [=](const Point<2> &X) {
        return hertz.pressure(X[0] - axis);
      };

      const double mu = contact_pair.law.coulomb_coefficient;
      if (form.name == "Hertz")
        return exact;
      if (std::abs(hertz.dundurs()) < 1e-12) // round-off
        {
          add_mindlin(hertz, mu, axis, results, exact);
          return exact;
        }

      // The tangent of the master is the normal of the slave turned by -90
      // degrees; body 1 is the slave.
      const double along_x =
        DeformedSurface<2>(contact_pair.slave, {}).normals()[node][1] > 0 ? 1.
                                                                          : -1.;
      add_half_planes(hertz,
                      mu,
                      parameters.solution.increments.size(),
                      axis,
                      along_x,
                      exact);
      return exact;
    }



    ExactSolution make_cylinders(const ClosedForm      &form,
                                 const Parameters::All &parameters,
                                 const TwoBodies       &model)
    {
      const ContactPair<2> &contact_pair = *model.interface.pairs[0];

      // The inner body is the one with the convex surface.
      const auto slave  = contact_pair.slave.facets[0].body;
      const auto master = contact_pair.master->facets[0].body;
      const bool slave_is_inner =
        DeformedSurface<2>(contact_pair.slave, {}).normals()[0] *
          contact_pair.slave.nodes[0].X >
        0;
      const auto outer = slave_is_inner ? master : slave;
      const auto inner = slave_is_inner ? slave : master;

      const auto material = [&](const types::material_id body) {
        const auto name = model.mesh.body_name(body);
        return ConcentricCylinders::Material{
          parameters.solids.youngs_modulus.at(name),
          parameters.solids.poisson.at(name)};
      };
      const auto &given = form.numbers;
      const auto  cylinders =
        std::make_shared<ConcentricCylinders>(given.at(0),
                                              given[1],
                                              given[2],
                                              material(inner),
                                              material(outer),
                                              given[3],
                                              given.at(4));
      ExactSolution exact;
      exact.pressure = [=](const Point<2> &X) {
        return cylinders->pressure(X);
      };
      exact.displacement = [=](const Point<2>          &X,
                               const types::material_id body) {
        return cylinders->displacement(X, body == outer);
      };
      exact.stress = [=](const Point<2> &X, const types::material_id body) {
        return cylinders->stress(X, body == outer);
      };
      return exact;
    }



    /// Squares of an error and of what it is the error of.
    struct Squares
    {
      double error = 0, exact = 0;

      void add(const double error_square, const double exact_square)
      {
        error += error_square;
        exact += exact_square;
      }

      double relative() const
      {
        return std::sqrt(error / exact);
      }
    };



    /// Error of values that are interpolated between the nodes of a slave.
    /// The exact ones have a kink within an edge, at the end of contact: hence
    /// many points.
    double error_on_slave(const std::function<double(const Point<2> &)> &exact,
                          const SlaveTractions                          &slave,
                          const std::vector<double>                     &values)
    {
      const QIterated<1> quadrature(QGauss<1>(4), 4);
      Squares            squares;
      for (unsigned int n = 0; n + slave.degree < slave.X.size();
           n += slave.degree)
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const EdgeShape shape(slave.degree, 2 * quadrature.point(q)[0] - 1);
            const std::array<unsigned int, 3> nodes{
              {n, n + slave.degree, n + 1}}; // first, last, middle
            Point<2>     X;
            Tensor<1, 2> along;
            double       value = 0;
            for (unsigned int a = 0; a <= slave.degree; ++a)
              {
                const Tensor<1, 2> X_a(slave.X[nodes[a]]);
                X += shape.value[a] * X_a;
                along += 2 * shape.first[a] * X_a;
                value += shape.value[a] * values[nodes[a]];
              }
            const double JxW       = quadrature.weight(q) * along.norm();
            const double reference = exact(X);
            squares.add(JxW * std::pow(value - reference, 2),
                        JxW * reference * reference);
          }
      return squares.relative();
    }



    void add_errors_in_bodies(const ExactSolution           &exact,
                              const TwoBodies               &model,
                              std::map<std::string, double> &errors)
    {
      const Discretization<2> &discretization = model.discretization;
      GhostedVector            displacements(model.n_dofs());
      std::copy_n(model.solution.begin(),
                  displacements.size(),
                  displacements.begin());
      const DistributedVector u = discretization.distributed(displacements);
      const unsigned int      degree = discretization.degree;
      hp::FEValues<2>         hp_fe_values(
        discretization.mapping,
        discretization.fe,
        hp::QCollection<2>(QGauss<2>(degree + 2), QGaussSimplex<2>(degree + 2)),
        update_values | update_gradients | update_quadrature_points |
          update_JxW_values);
      const FEValuesExtractors::Vector   displacement(0);
      std::vector<Tensor<1, 2>>          values;
      std::vector<SymmetricTensor<2, 2>> strains;
      Squares                            square, energy;
      for (const auto &cell :
           discretization.dof_handler.active_cell_iterators())
        {
          hp_fe_values.reinit(cell);
          const auto     &fe_values = hp_fe_values.get_present_fe_values();
          const auto      body      = cell->material_id();
          const Material &material  = model.elasticity->material(body);
          values.resize(fe_values.n_quadrature_points);
          strains.resize(fe_values.n_quadrature_points);
          fe_values[displacement].get_function_values(u, values);
          fe_values[displacement].get_function_symmetric_gradients(u, strains);
          for (const unsigned int q : fe_values.quadrature_point_indices())
            {
              const Point<2> &X      = fe_values.quadrature_point(q);
              const double    JxW    = fe_values.JxW(q);
              const auto      u_X    = exact.displacement(X, body);
              const auto      stress = exact.stress(X, body);
              square.add(JxW * (values[q] - u_X).norm_square(),
                         JxW * u_X.norm_square());
              energy.add(JxW * material.energy_density(
                                 material.stress(strains[q]) - stress),
                         JxW * material.energy_density(stress));
            }
        }
      errors["displacement"] = square.relative();
      errors["energy"]       = energy.relative();
    }
  } // namespace



  ExactSolution exact_solution(const ClosedForm      &form,
                               const Parameters::All &parameters,
                               const TwoBodies       &model,
                               const ContactResults  &results)
  {
    if (form.name == "concentric cylinders")
      return make_cylinders(form, parameters, model);
    AssertThrow(form.name == "Hertz" || form.name == "Hertz with friction",
                ExcMessage("There is no closed form '" + form.name + "'."));
    return make_hertz(form, parameters, model, results);
  }



  std::map<std::string, double> solution_errors(const ExactSolution  &exact,
                                                const TwoBodies      &model,
                                                const SlaveTractions &slave)
  {
    std::map<std::string, double> errors;
    if (exact.pressure)
      errors["pressure"] =
        error_on_slave(exact.pressure, slave, slave.pressure);
    if (exact.shear)
      errors["shear"] = error_on_slave(exact.shear, slave, slave.shear);
    if (exact.displacement)
      add_errors_in_bodies(exact, model, errors);
    return errors;
  }
} // namespace Tests
