/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include <deal.II/base/timer.h>

#include <deal.II/lac/sparsity_pattern.h>

#include <iomanip>
#include <iostream>

#include "contact_interface.h"
#include "discretization.h"
#include "elasticity.h"
#include "errors.h"
#include "linear_solver.h"
#include "parameters.h"
#include "stress_recovery.h"

namespace Contact
{
  using namespace dealii;

  class ContactProblem
  {
  public:
    explicit ContactProblem(const Parameters::All &parameters);
    void run();

  private:
    void geometry_loop();
    void friction_loop();
    unsigned int newton_loop(const bool newton_friction);
    void pair();
    void setup_system();
    double assemble_system();

    const Parameters::All       parameters;
    Mesh                        mesh;
    Discretization              discretization;
    std::unique_ptr<Elasticity> elasticity;
    ContactInterface            interface;

    SparsityPattern elastic_pattern;
    SparsityPattern      pattern;
    SparseMatrix<double> matrix;
    Vector<double>       residual, solution, start;
    DirectSolver         solver;
    double load_factor = 0;
    bool newton_geometry, newton_friction;
    unsigned int n_it=0;
    ContactInterface::Linearization linearization;
    TimerOutput timer;
  };

  ContactProblem::ContactProblem(const Parameters::All &parameters)
  :parameters(parameters), mesh(parameters.mesh), discretization(mesh,parameters),
   elasticity(Elasticity::create(discretization, parameters.solids)),
   interface(discretization,*elasticity,parameters.contact), timer(std::cout, TimerOutput::summary, TimerOutput::cpu_times)
  {
    const unsigned int n= discretization.dof_handler.n_dofs()+interface.n_multipliers();
    solution.reinit(n); start.reinit(n); residual.reinit(n);
    DynamicSparsityPattern d(n,n);
    elasticity->add_couplings(d);
    for (unsigned int i=0;i<n;++i) d.add(i,i);
    elastic_pattern.copy_from(d);
    newton_geometry = parameters.solution.geometry == "Newton";
    newton_friction = parameters.solution.friction == "Newton";
  }

  void ContactProblem::pair()
  {
    TimerOutput::Scope t(timer, "pair");
    if (interface.pair(solution)) setup_system();
  }
  void ContactProblem::setup_system()
  {
    TimerOutput::Scope t(timer, "pattern");
    DynamicSparsityPattern d(solution.size(), solution.size());
    elasticity->add_couplings(d);
    for (unsigned int i=0;i<solution.size();++i) d.add(i,i);
    interface.add_couplings(d);
    pattern.copy_from(d);
    matrix.reinit(pattern);
    solver.initialize(pattern);
  }
  double ContactProblem::assemble_system()
  {
    TimerOutput::Scope t(timer, "assemble");
    matrix = 0; residual = 0;
    elasticity->assemble(solution, load_factor, matrix, residual);
    interface.assemble(solution, start, linearization, matrix, residual);
    for (unsigned int i=0;i<discretization.dof_handler.n_dofs();++i)
      if (discretization.constraints.is_constrained(i)) { matrix.diag_element(i)=1; residual[i]=0;}
    return residual.l2_norm();
  }
  unsigned int ContactProblem::newton_loop(const bool nf)
  {
    linearization = {newton_geometry, nf};
    for (unsigned int it=0; it<parameters.solution.max_newton_iterations; ++it)
    {
      if (newton_geometry) pair();
      const unsigned int changes = it==0 && n_it==0 ? 0 : interface.update_status(solution,start,nf);
      const double r = assemble_system();
      const auto c = interface.count();
      std::cout << "  it " << it << " changes " << changes << " active " << c.active << " stick " << c.stick << " residual " << r << std::endl;
      if (it>0 && changes==0 && r < 1e-8*17500) return it;
      if (it==0 && r < 1e-8*17500 && changes==0 && n_it>0) return it;
      {TimerOutput::Scope t(timer, "factorize");
      solver.factorize(matrix);}
      {TimerOutput::Scope t(timer, "solve");
      solver.solve(residual);}
      discretization.constraints.distribute(residual);
      solution -= residual;
      ++n_it;
    }
    throw NotConverged("Newton");
  }
  void ContactProblem::friction_loop()
  {
    if (interface.law.is_frictionless() || newton_friction) { newton_loop(newton_friction); return; }
    for (unsigned int k=0;k<parameters.solution.max_friction_iterations;++k)
    {
      newton_loop(false);
      const double change = interface.update_bounds(solution,start);
      std::cout << " friction change " << change << std::endl;
      if (k>0 && change < 1e-10) return;
    }
    throw NotConverged("friction");
  }
  void ContactProblem::geometry_loop()
  {
    if (newton_geometry) { friction_loop(); return;}
    for (unsigned int k=0;k<parameters.solution.max_geometry_iterations;++k)
    {
      Vector<double> last(solution);
      pair();
      if (n_it==0) interface.initialize_status(solution, 1e-2);
      friction_loop();
      double d=0, s=0;
      for (unsigned int i=0;i<discretization.dof_handler.n_dofs();++i)
        { d=std::max(d,std::abs(solution[i]-last[i])); s=std::max(s,std::abs(last[i]-start[i]));}
      std::cout << " geometry " << k << " " << d/s << std::endl;
      if (k>0 && d < parameters.solution.geometry_tolerance*s) return;
    }
    throw NotConverged("geometry");
  }
  void ContactProblem::run()
  {
    std::cout << discretization.dof_handler.n_dofs() << " " << interface.n_multipliers() << std::endl;
    StressRecovery recovery(discretization);
    const unsigned int B = mesh.point("B","x");
    for (unsigned int k=1;k<=parameters.solution.n_increments;++k)
    {
      load_factor = double(k)/parameters.solution.n_increments;
      start = solution;
      discretization.constrain_update(solution, load_factor);
      if (newton_geometry && k==1) { pair(); interface.initialize_status(solution,1e-2);}
      geometry_loop();
      std::cout << std::setprecision(12) << "DY " << solution[discretization.vertex_dofs[B][1]]
       << " SIYY " << recovery.vertex_stresses(*elasticity, solution)[B][1][1] << std::setprecision(6) << std::endl;
    }
  }
}
int main(int argc, char **argv)
{
  using namespace Contact;
  dealii::ParameterHandler prm; Parameters::All p;
  try {
  read_parameters(argv[1], std::vector<std::string>(argv+2,argv+argc), prm, p);
  ContactProblem(p).run();
  } catch (std::exception &e) { std::cerr << e.what() << std::endl; return 2;}
}
