/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */


#ifndef contact_parameters_solution_h
#define contact_parameters_solution_h

#include <deal.II/base/parameter_handler.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "parameters/increments.h"
#include "parameters/quantities.h"

namespace Contact
{
  using namespace dealii;

  namespace Parameters
  {
    /// Increments and the nested loops inside them.
    struct Solution
    {
      Increments   increments{2};
      unsigned int max_cuts = 6; // of an increment to half

      /// See All::geometry().
      Choice<GeometryLoop> geometry           = GeometryLoop::automatic;
      double               geometry_tolerance = 1e-3;

      Choice<FrictionLoop> friction           = FrictionLoop::newton;
      double               friction_tolerance = 1e-10;

      double       newton_tolerance      = 1e-8;
      unsigned int max_newton_iterations = 0;

      /// The entry, or if that is 0 a number that suffices for quadratic
      /// convergence, or for linear one.
      unsigned int newton_limit(const bool converges_linearly) const
      {
        return max_newton_iterations > 0 ? max_newton_iterations
               : converges_linearly      ? 100
                                         : 25;
      }

      /// Of iterative solvers, relative to the residual of the Newton step.
      double linear_tolerance = 1e-3;

      /// Estimate what effects do to the probes, see EffectEstimates.
      bool estimate_effects = false;

      Choice<SystemKind> system = SystemKind::automatic;

      Choice<SolverKind> linear_solver = SolverKind::automatic;

      /// Whether the points are paired before each Newton step.
      bool pairs_each_step() const
      {
        return geometry != GeometryLoop::undeformed &&
               geometry != GeometryLoop::fixed_point;
      }

      void add_parameters(ParameterHandler &prm);
      void check() const;

    private:
      void add_increments(ParameterHandler &prm);
      void add_loops(ParameterHandler &prm);
      void add_linear_system(ParameterHandler &prm);
    };



    /// Nested iteration: solve, refine, start from there, and so on.
    struct Refinement
    {
      unsigned int n_levels = 0; // refinements on top of the first mesh

      Choice<Strategy> strategy = Strategy::automatic;

      /// Of a run that an accuracy is asked of: "unknowns", "seconds" or
      /// "megabytes" -> no more than that.
      std::map<std::string, double> limits = {{"unknowns", 1e6}};

      double fraction  = 0;    // of the estimated error, in refined cells
      double tolerance = 1e-4; // Newton tolerance of all levels but the last

      void add_parameters(ParameterHandler &prm);
      void check() const;
    };



    /// Values to report, and to compare with a reference.
    struct Probes
    {
      /// Name -> {quantity, point group} or {quantity, point group, point
      /// group}; see the entry's documentation.
      std::map<std::string, std::vector<std::string>> probes;

      /// Their names as they are in the parameter file.
      std::vector<std::string> order;

      /// A quantity at a point group, for forces a boundary group and for
      /// energies a body, or its difference between two of them.
      struct Definition
      {
        Choice<Quantity>         quantity;
        std::vector<std::string> places;
      };

      /// The probes with their names, in the order of the parameter file. They
      /// have been checked.
      using Definitions = std::vector<std::pair<std::string, Definition>>;
      Definitions definitions() const;

      /// Name -> reference value, and its relative tolerance.
      std::map<std::string, double> references;
      std::map<std::string, double> tolerances;

      /// The estimate of the discretization error of the probes.
      Choice<Errors> errors = Errors::automatic;

      /// Name -> the error that is accepted, with its unit: %, mm or MPa.
      std::map<std::string, std::string> accuracy;

      /// A number and its unit.
      struct Request
      {
        double      value;
        std::string unit;

        /// Whether it is a part of the probe.
        bool is_relative() const
        {
          return unit == "%";
        }

        /// The error that is accepted of a probe with this value.
        double error_of(const double probe) const
        {
          return is_relative() ? value / 100 * std::abs(probe) : value;
        }
      };

      /// The accuracy that is asked for, by name. They have been checked.
      std::map<std::string, Request> requests() const;

      void add_parameters(ParameterHandler &prm);

      /// Units depend on the symmetry of the scene.
      void check(const Symmetry symmetry) const;

    private:
      void add_errors(ParameterHandler &prm);
      void check_quantities() const;
      void check_references() const;
      void check_accuracy(const Symmetry symmetry) const;
    };



    /// Files and screen.
    struct Output
    {
      std::string directory = "output";

      Choice<Screen> screen = Screen::increments;

      bool vtu     = false;
      bool profile = false;
      bool nodes   = false;

      void add_parameters(ParameterHandler &prm);
    };
  } // namespace Parameters
} // namespace Contact

#endif
