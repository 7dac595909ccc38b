/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "verification/exact_solution.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/hp/fe_values.h>

#include <algorithm>
#include <memory>

#include "verification/half_plane.h"
#include "verification/verification.h"

namespace Contact
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



    HertzLineContact hertz_contact(const Parameters::All   &parameters,
                                   const Discretization<2> &discretization,
                                   const ContactPair<2>    &contact_pair,
                                   const ContactResults    &results)
    {
      const auto &solids = parameters.solids;
      const auto &given  = parameters.probes.hertz;
      const auto  slave =
        discretization.mesh.body_name(contact_pair.slave.facets[0].body);
      const auto master =
        discretization.mesh.body_name(contact_pair.master->facets[0].body);
      return {given[0],
              given.size() > 1 ? given[1] : results.normal_force,
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



    ExactSolution make_hertz(const Parameters::All   &parameters,
                             const Discretization<2> &discretization,
                             const ContactPair<2>    &contact_pair,
                             const ContactResults    &results)
    {
      const HertzLineContact hertz =
        hertz_contact(parameters, discretization, contact_pair, results);
      const unsigned int node = first_touch(contact_pair);
      const double       axis = contact_pair.slave.nodes[node].X[0];

      ExactSolution exact;
      exact.values["half_width"]   = hertz.half_width();
      exact.values["max_pressure"] = hertz.max_pressure();
      exact.pressure               = [=](const Point<2> &X) {
        return hertz.pressure(X[0] - axis);
      };

      const double mu = contact_pair.law.coulomb_coefficient;
      if (mu == 0 || !parameters.probes.frictional_theory)
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
                      parameters.solution.n_increments,
                      axis,
                      along_x,
                      exact);
      return exact;
    }



    ExactSolution make_cylinders(const Parameters::All   &parameters,
                                 const Discretization<2> &discretization,
                                 const ContactPair<2>    &contact_pair)
    {
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
        const auto name = discretization.mesh.body_name(body);
        return ConcentricCylinders::Material{
          parameters.solids.youngs_modulus.at(name),
          parameters.solids.poisson.at(name)};
      };
      const auto &given = parameters.probes.concentric_cylinders;
      const auto  cylinders =
        std::make_shared<ConcentricCylinders>(given[0],
                                              given[1],
                                              given[2],
                                              material(inner),
                                              material(outer),
                                              given[3],
                                              given[4]);
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

      double relative(const MPI_Comm communicator) const
      {
        return std::sqrt(Utilities::MPI::sum(error, communicator) /
                         Utilities::MPI::sum(exact, communicator));
      }
    };



    /// Of a multiplier over the slave, which every rank has. Where contact ends
    /// the exact one has a kink within an edge: hence many points.
    double error_on_slave(const std::function<double(const Point<2> &)> &exact,
                          const ContactPair<2>      &contact_pair,
                          const std::vector<double> &values)
    {
      const Surface<2>  &slave = contact_pair.slave;
      const QIterated<1> quadrature(QGauss<1>(4), 4);
      Squares            squares;
      for (const SurfaceFacet<2> &edge : slave.facets)
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const EdgeShape shape(slave.degree, 2 * quadrature.point(q)[0] - 1);
            Point<2>        X;
            double          value = 0;
            for (unsigned int a = 0; a < slave.n_nodes_per_facet(); ++a)
              {
                X +=
                  shape.value[a] * Tensor<1, 2>(slave.nodes[edge.nodes[a]].X);
                value += shape.value[a] * values[edge.nodes[a]];
              }
            const double JxW =
              2 * quadrature.weight(q) * slave.reference_jacobian(edge, shape);
            const double reference = exact(X);
            squares.add(JxW * std::pow(value - reference, 2),
                        JxW * reference * reference);
          }
      return squares.relative(MPI_COMM_SELF);
    }



    void add_errors_in_bodies(const ExactSolution           &exact,
                              const Discretization<2>       &discretization,
                              const Elasticity<2>           &elasticity,
                              const GhostedVector           &solution,
                              std::map<std::string, double> &errors)
    {
      const DistributedVector u      = discretization.distributed(solution);
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
          if (!cell->is_locally_owned())
            continue;
          hp_fe_values.reinit(cell);
          const auto     &fe_values = hp_fe_values.get_present_fe_values();
          const auto      body      = cell->material_id();
          const Material &material  = elasticity.material(body);
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
      errors["displacement"] = square.relative(discretization.communicator);
      errors["energy"]       = energy.relative(discretization.communicator);
    }
  } // namespace



  std::optional<ExactSolution>
  make_exact_solution(const Parameters::All   &parameters,
                      const Discretization<2> &discretization,
                      const ContactPair<2>    &contact_pair,
                      const ContactResults    &results)
  {
    if (!parameters.probes.hertz.empty())
      return make_hertz(parameters, discretization, contact_pair, results);
    if (!parameters.probes.concentric_cylinders.empty())
      return make_cylinders(parameters, discretization, contact_pair);
    return {};
  }



  std::map<std::string, double>
  solution_errors(const ExactSolution       &exact,
                  const Discretization<2>   &discretization,
                  const Elasticity<2>       &elasticity,
                  const ContactInterface<2> &interface,
                  const ContactPair<2>      &contact_pair,
                  const GhostedVector       &solution)
  {
    std::map<std::string, double> errors;
    const auto                    add_on_slave =
      [&](const std::string &name, const auto &function, const auto &index) {
        std::vector<double> values(contact_pair.slave.nodes.size());
        for (unsigned int n = 0; n < values.size(); ++n)
          if (const unsigned int k = contact_pair.multipliers.of_node[n];
              k != numbers::invalid_unsigned_int)
            values[n] = solution[index(k)];
        errors[name] = error_on_slave(function, contact_pair, values);
      };
    if (exact.pressure)
      add_on_slave("pressure", exact.pressure, [&](const unsigned int k) {
        return interface.normal_index(k);
      });
    if (exact.shear)
      add_on_slave("shear", exact.shear, [&](const unsigned int k) {
        return interface.tangential_index(k);
      });
    if (exact.displacement)
      {
        GhostedVector u(discretization.distribution);
        std::copy_n(solution.begin(), u.size(), u.begin());
        add_errors_in_bodies(exact, discretization, elasticity, u, errors);
      }
    return errors;
  }
} // namespace Contact
