/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_tests_h
#define contact_tests_h

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>

#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <random>
#include <sstream>

#include "contact/interface/contact_kernel.h"
#include "mesh/mesh.h"
#include "mpi_session.h"
#include "parameters/parameters.h"
#include "solid/discretization.h"
#include "solid/elasticity.h"
#include "solvers/direct/linear_solver.h"

namespace Contact
{
  inline void operator*=(GhostedVector &vector, const double factor)
  {
    static_cast<Vector<double> &>(vector) *= factor;
  }

  inline void operator/=(GhostedVector &vector, const double divisor)
  {
    static_cast<Vector<double> &>(vector) /= divisor;
  }
} // namespace Contact



/**
 * The tools of the unit tests: small meshes, models made by code, a plain
 * Newton loop, and checks that print the same on every machine. What a check
 * has measured goes to the file "measured" in the directory of the test.
 */
namespace Tests
{
  using namespace dealii;
  using namespace Contact;

  inline void check(const std::string &what, const bool holds)
  {
    std::cout << "  " << what << ": " << (holds ? "ok" : "FAILED") << std::endl;
  }



  /// A round-off, or an error, that has to stay below a bound.
  inline void
  check_small(const std::string &what, const double value, const double bound)
  {
    static std::ofstream measured("measured");
    measured << what << ": " << value << " < " << bound << std::endl;

    std::cout << "  " << what << " < " << bound << ": ";
    if (value < bound)
      std::cout << "ok" << std::endl;
    else
      std::cout << "FAILED, it is " << value << std::endl;
  }



  /// A number that is known to two digits only.
  inline std::string two_digits(const double value)
  {
    std::ostringstream text;
    text << std::setprecision(2) << value;
    return text.str();
  }



  inline void headline(const std::string &text)
  {
    std::cout << text << std::endl;
  }



  /// Reproducible numbers, evenly distributed.
  class Random
  {
  public:
    double operator()(const double low, const double high)
    {
      return low + (high - low) * (engine() / 4294967296.);
    }

  private:
    std::mt19937 engine{5489};
  };



  inline Tensor<2, 2> rotation(const double angle)
  {
    Tensor<2, 2> R;
    R[0][0] = R[1][1] = std::cos(angle);
    R[1][0]           = std::sin(angle);
    R[0][1]           = -R[1][0];
    return R;
  }



  /// The motion of a body that does not move.
  inline Point<2> stay(const Point<2> &X)
  {
    return X;
  }



  /// A place in 2-D for every place in the unit square.
  using Chart = std::function<Point<2>(const double s, const double t)>;

  inline Chart rectangle(const Point<2> &low, const Point<2> &high)
  {
    return [=](const double s, const double t) {
      return Point<2>(low[0] + s * (high[0] - low[0]),
                      low[1] + t * (high[1] - low[1]));
    };
  }



  /// A mesh made of blocks, written as a gmsh file.
  class MeshText
  {
  public:
    using Choice = std::function<bool(unsigned int i, unsigned int j)>;

    /**
     * The body @p name of @p nx times @p ny quadrangles; the ones that @p split
     * chooses are cut into two triangles. Its sides are the groups "NAME
     * bottom", "right", "top" and "left", its corners the groups "NAME bottom
     * left" and so on.
     */
    void block(const std::string &name,
               const unsigned int nx,
               const unsigned int ny,
               const Chart       &chart,
               const Choice      &split = {})
    {
      const unsigned int first = nodes.size() + 1;
      for (unsigned int j = 0; j <= ny; ++j)
        for (unsigned int i = 0; i <= nx; ++i)
          nodes.push_back(chart(1. * i / nx, 1. * j / ny));
      const auto node = [=](const unsigned int i, const unsigned int j) {
        return first + j * (nx + 1) + i;
      };

      for (unsigned int j = 0; j < ny; ++j)
        for (unsigned int i = 0; i < nx; ++i)
          {
            const unsigned int a = node(i, j), b = node(i + 1, j);
            const unsigned int c = node(i + 1, j + 1), d = node(i, j + 1);
            if (split && split(i, j))
              {
                add(2, name, {a, b, c});
                add(2, name, {a, c, d});
              }
            else
              add(2, name, {a, b, c, d});
          }
      for (unsigned int i = 0; i < nx; ++i)
        {
          add(1, name + " bottom", {node(i, 0), node(i + 1, 0)});
          add(1, name + " top", {node(i, ny), node(i + 1, ny)});
        }
      for (unsigned int j = 0; j < ny; ++j)
        {
          add(1, name + " left", {node(0, j), node(0, j + 1)});
          add(1, name + " right", {node(nx, j), node(nx, j + 1)});
        }
      add(0, name + " bottom left", {node(0, 0)});
      add(0, name + " bottom right", {node(nx, 0)});
      add(0, name + " top left", {node(0, ny)});
      add(0, name + " top right", {node(nx, ny)});
    }

    void write(const std::string &file) const
    {
      std::ofstream out(file);
      out.precision(17);
      out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
          << groups.size() << '\n';
      for (const auto &[group, tag] : groups)
        out << group.first << ' ' << tag << " \"" << group.second << "\"\n";
      out << "$EndPhysicalNames\n$Nodes\n" << nodes.size() << '\n';
      for (unsigned int i = 0; i < nodes.size(); ++i)
        out << i + 1 << ' ' << nodes[i] << " 0\n";
      out << "$EndNodes\n$Elements\n" << elements.size() << '\n';
      for (unsigned int i = 0; i < elements.size(); ++i)
        out << i + 1 << ' ' << elements[i] << '\n';
      out << "$EndElements\n";
    }

  private:
    void add(const unsigned int               dimension,
             const std::string               &group,
             const std::vector<unsigned int> &corners)
    {
      // gmsh's numbers of a point, a line, a triangle and a quadrangle.
      const std::array<unsigned int, 5> types{{0, 15, 1, 2, 3}};

      const auto tag =
        groups.emplace(std::make_pair(dimension, group), groups.size() + 1)
          .first->second;
      std::string text = std::to_string(types[corners.size()]) + " 2 " +
                         std::to_string(tag) + " 1";
      for (const unsigned int corner : corners)
        text += ' ' + std::to_string(corner);
      elements.push_back(text);
    }

    std::vector<Point<2>>                                        nodes;
    std::map<std::pair<unsigned int, std::string>, unsigned int> groups;
    std::vector<std::string>                                     elements;
  };



  /// Parameters of a mesh with the bodies @p names, all of the same material.
  inline Parameters::All make_parameters(const MeshText                 &mesh,
                                         const std::vector<std::string> &names,
                                         const unsigned int              degree,
                                         const std::string &kinematics,
                                         const double youngs_modulus = 1000,
                                         const double poisson        = 0.3)
  {
    mesh.write("test.msh");

    Parameters::All parameters;
    parameters.mesh.file         = "test.msh";
    parameters.element.degree    = degree;
    parameters.solids.kinematics = kinematics;
    for (const std::string &name : names)
      {
        parameters.solids.youngs_modulus[name] = youngs_modulus;
        parameters.solids.poisson[name]        = poisson;
      }
    return parameters;
  }



  /// Change all points of an interface, as no solution may have them.
  template<typename Change>
  void change_points(ContactInterface<2> &interface, const Change &change)
  {
    auto points = interface.points();
    for (ContactPoint<2> &point : points)
      change(point);
    interface.set_points(points);
  }


  /// The bodies of a case.
  template<int dim>
  struct BodiesIn
  {
    explicit BodiesIn(const Parameters::All &parameters)
      : mesh(parameters.mesh)
      , discretization(mesh, parameters)
      , elasticity(
          std::make_unique<Elasticity<dim>>(discretization, parameters.solids))
    {
    }

    unsigned int n_dofs() const
    {
      return discretization.dof_handler.n_dofs();
    }

    Surface<2> surface(const std::string &name) const
    {
      return Surface<2>(discretization, mesh.boundary(name, "test"), name);
    }

    /// The reference position of every unknown.
    std::vector<Point<dim>> support_points() const
    {
      std::vector<Point<dim>> points(n_dofs());
      DoFTools::map_dofs_to_support_points(discretization.mapping,
                                           discretization.dof_handler,
                                           points);
      return points;
    }

    /// The component of the displacement that every unknown is.
    std::vector<unsigned int> components() const
    {
      std::vector<unsigned int> components(n_dofs());
      for (unsigned int c = 0; c < dim; ++c)
        {
          ComponentMask mask(dim, false);
          mask.set(c, true);
          for (const auto dof :
               DoFTools::extract_dofs(discretization.dof_handler, mask))
            components[dof] = c;
        }
      return components;
    }

    /// The displacement that takes every node from X to @p position(X).
    GhostedVector displacement(
      const std::function<Point<dim>(const Point<dim> &)> &position) const
    {
      const auto    X = support_points();
      const auto    c = components();
      GhostedVector u(n_dofs());
      for (unsigned int i = 0; i < n_dofs(); ++i)
        u[i] = position(X[i])[c[i]] - X[i][c[i]];
      return u;
    }

    Mesh<dim>                        mesh;
    Discretization<dim>              discretization;
    std::unique_ptr<Elasticity<dim>> elasticity;
  };

  using Bodies = BodiesIn<2>;



  /// Two bodies in contact.
  struct TwoBodies : public Bodies
  {
    explicit TwoBodies(const Parameters::All &parameters)
      : Bodies(parameters)
      , interface(discretization, *elasticity, parameters.pairs())
      , solution(n_dofs() + interface.n_multipliers())
      , start(solution)
    {
    }

    /// Pair, and make the matrix where the pattern changes.
    void pair()
    {
      if (!interface.pair(solution))
        return;
      const unsigned int     n = solution.size();
      DynamicSparsityPattern couplings(n, n);
      elasticity->add_couplings(couplings);
      interface.add_couplings(couplings);
      for (unsigned int i = 0; i < n; ++i)
        couplings.add(i, i);
      pattern.copy_from(couplings);
      matrix.reinit(pattern);
      solver.initialize(pattern);
    }

    /// Update all statuses. Returns whether one has changed.
    bool updated_status()
    {
      return interface.active_set.update(solution,
                                         start,
                                         /*keep=*/true) > 0;
    }

    /**
     * One increment by Newton's method with the bound of the friction moving;
     * with the geometry moving, too, or not in the tangent, or with the pairing
     * of the start kept. Until the residual is 1e-12 of the forces, or of
     * @p least_force. Returns the number of iterations, or 0 if there is no
     * convergence.
     */
    unsigned int solve(const double load_factor,
                       const bool   moving_geometry,
                       const bool   pairs_anew,
                       const double least_force = 0)
    {
      start = solution;
      discretization.constrain_update(solution, load_factor);
      pair();
      interface.active_set.initialize(solution);

      GhostedVector rhs(solution.size());
      for (unsigned int iteration = 0; iteration < 100; ++iteration)
        {
          if (pairs_anew)
            pair();
          const bool changed = iteration == 0 || updated_status();
          matrix             = 0;
          rhs                = 0;
          elasticity->assemble(solution, load_factor, rhs, &matrix);
          ContactKernel<2>(interface).assemble(solution,
                                               start,
                                               {moving_geometry},
                                               rhs,
                                               &matrix);
          for (unsigned int i = 0; i < n_dofs(); ++i)
            if (discretization.constraints.is_constrained(i))
              {
                matrix.diag_element(i) = 1;
                rhs[i]                 = 0;
              }

          const double scale =
            std::max(least_force,
                     elasticity->forces(solution, load_factor).linfty_norm());
          if (!changed && rhs.linfty_norm() < 1e-12 * scale)
            return iteration;

          solver.factorize(matrix);
          solver.solve(rhs);
          discretization.distribute(discretization.constraints, rhs);
          solution += rhs;
          discretization.constrain_update(solution, load_factor);
        }
      return 0;
    }

    /// The same, paired anew in each step if the geometry moves.
    unsigned int solve(const double load_factor, const bool moving_geometry)
    {
      return solve(load_factor, moving_geometry, moving_geometry);
    }

    /// The forces that the points of contact exert, from their definition.
    GhostedVector contact_forces() const
    {
      GhostedVector forces(n_dofs());
      for (const ContactPoint<2> &point : interface.points())
        {
          const ContactState<2> now = interface.state(point, solution, start);
          const Traction<2>     t   = interface.active_set.traction(point, now);
          for (unsigned int a = 0; a < point.n_nodes; ++a)
            for (unsigned int i = 0; i < 2; ++i)
              forces[point.dofs(a)[i]] +=
                point.weight * point.C[a] *
                (t.p * point.normal[i] + t.q[0] * point.tangents[0][i]);
        }
      return forces;
    }

    ContactInterface<2> interface;
    GhostedVector       solution, start;

    SparsityPattern      pattern;
    SparseMatrix<double> matrix;
    Counters             counters;
    DirectSolver         solver{counters};
  };



  /// The points of the slave, without corners of the master.
  inline std::vector<ContactPoint<2>>
  points_of_slave(const ContactInterface<2> &interface)
  {
    std::vector<ContactPoint<2>> points;
    for (const ContactPoint<2> &point : interface.points())
      if (!point.is_master_corner)
        points.push_back(point);
    return points;
  }



  /// The points that act: without those of slave nodes that a corner of the
  /// master stands for, and without corners that follow from others.
  inline std::vector<ContactPoint<2>>
  points_that_act(const ContactInterface<2> &interface)
  {
    std::vector<ContactPoint<2>> points;
    for (const ContactPoint<2> &point : interface.points())
      if (point.facing &&
          !(point.is_master_corner && point.status.kind == Status::open))
        points.push_back(point);
    return points;
  }
} // namespace Tests

#endif
