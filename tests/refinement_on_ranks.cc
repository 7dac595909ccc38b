/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Several processes refine as one does, also where levels differ at a vertex
// alone. Displacements that both meshes can represent are transferred as they
// are: each of several ones, in all that a process holds of it, its own and
// ghosts. Run by mpirun.

#include <deal.II/dofs/dof_tools.h>

#include "adaptivity/refinement.h"
#include "refine_bodies.h"

using namespace Tests;

namespace
{
  /// A field of degree 2, another one for each number.
  double field(const Point<2>    &X,
               const unsigned int component,
               const unsigned int number)
  {
    return (number + 1.) * (component == 0
                              ? 1.2 + X[0] * X[0] - 2 * X[0] * X[1]
                              : -0.7 + X[1] * X[1] + number * X[0] * X[1]);
  }



  /// By how much a solution misses its field, in all that processes hold.
  double miss(const Discretization<2> &discretization,
              const GhostedVector     &solution,
              const unsigned int       number)
  {
    double                               largest = 0;
    std::vector<types::global_dof_index> dofs;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (!cell->is_artificial())
        {
          const auto &fe = cell->get_fe();
          dofs.resize(fe.n_dofs_per_cell());
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              const Point<2> X =
                discretization.mapping[0]
                  .transform_unit_to_real_cell(cell, fe.unit_support_point(i));
              const unsigned int c = fe.system_to_component_index(i).first;
              largest =
                std::max(largest,
                         std::abs(solution[dofs[i]] - field(X, c, number)));
            }
        }
    return Utilities::MPI::max(largest, discretization.communicator);
  }



  GhostedVector interpolate(const Discretization<2> &discretization,
                            const unsigned int       number)
  {
    GhostedVector solution(discretization.distribution);
    std::map<types::global_dof_index, Point<2>> X;
    DoFTools::map_dofs_to_support_points(discretization.mapping,
                                         discretization.dof_handler,
                                         X);
    for (unsigned int c = 0; c < 2; ++c)
      {
        ComponentMask mask(2, false);
        mask.set(c, true);
        for (const auto dof :
             DoFTools::extract_dofs(discretization.dof_handler, mask))
          solution[dof] = field(X.at(dof), c, number);
      }
    solution.update_ghosts();
    return solution;
  }


  /// Flag the cell to the lower left of a vertex: the cell on the other side of
  /// the vertex has none of its sides.
  void flag_cell_below(const Point<2> &place, Mesh<2> &mesh)
  {
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->vertex(3).distance(place) < 1e-10)
        cell->set_refine_flag();
  }
} // namespace



int main()
{
  const MPI_Comm     communicator = MPI_COMM_WORLD;
  const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
  Parameters::All    parameters;
  parameters.mesh.file           = "refinement_on_ranks.msh";
  parameters.element.degree      = 2;
  parameters.element.centre_node = "free";
  if (rank == 0)
    {
      MeshText text;
      text.block("block", 5, 4, rectangle({0, 0}, {2, 1}));
      text.write(parameters.mesh.file);
    }
  MPI_Barrier(communicator);

  Mesh<2>                    mesh(parameters.mesh, communicator);
  Mesh<2>                    of_one_process(parameters.mesh, MPI_COMM_SELF);
  Discretization<2>          discretization(mesh, parameters, communicator);
  std::vector<GhostedVector> solutions;
  const unsigned int         n_solutions = 3;
  for (unsigned int k = 0; k < n_solutions; ++k)
    solutions.push_back(interpolate(discretization, k));

  // First all cells, then to a place.
  const Point<2> place(0.8, 0.5);
  double         worst = 0;
  bool           alike = true;
  for (unsigned int level = 1; level <= 5; ++level)
    {
      for (Mesh<2> *one : {&mesh, &of_one_process})
        if (level == 1)
          flag_all_cells(*one);
        else
          flag_cell_below(place, *one);
      of_one_process.triangulation.execute_coarsening_and_refinement();
      refine_and_transfer(mesh, discretization, solutions);
      for (unsigned int k = 0; k < n_solutions; ++k)
        worst = std::max(worst, miss(discretization, solutions[k], k));
      alike = alike && mesh.triangulation.n_global_active_cells() ==
                         of_one_process.triangulation.n_active_cells();
    }
  const unsigned int fewest =
    Utilities::MPI::min(discretization.distribution->locally_owned_size(),
                        communicator);
  const bool hangs =
    Utilities::MPI::max(static_cast<unsigned int>(
                          mesh.triangulation.has_hanging_nodes()),
                        communicator) > 0;
  if (rank == 0)
    {
      check("each process has a part", fewest > 0);
      check("hanging nodes", hangs);
      check("as many cells as on one process", alike);
      check_small("displacements carried over", worst, 1e-13);
    }
}
