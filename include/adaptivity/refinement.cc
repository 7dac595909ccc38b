/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "adaptivity/refinement.h"

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <boost/serialization/utility.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <list>
#include <numeric>

#include "base/deal_ii_versions.h"
#include "base/dimension.h"
#include "base/errors.h"
#include "solid/followers.h"

namespace Contact
{
  namespace
  {
    /// On a mesh of which every rank has all cells.
    template<int dim>
    void transfer_complete(Mesh<dim>                  &mesh,
                           Discretization<dim>        &discretization,
                           std::vector<GhostedVector> &solutions)
    {
      SolutionTransfer<dim, Vector<double>> transfer(
        discretization.dof_handler);
      std::vector<Vector<double>> old, refined;
      for (const GhostedVector &solution : solutions)
        {
          old.emplace_back(discretization.dof_handler.n_dofs());
          for (unsigned int i = 0; i < old.back().size(); ++i)
            old.back()[i] = solution[i];
        }

      mesh.triangulation.prepare_coarsening_and_refinement();
      if (!old.empty())
        transfer.prepare_for_coarsening_and_refinement(old);
      mesh.triangulation.execute_coarsening_and_refinement();
      discretization.redistribute();

      refined.resize(old.size(),
                     Vector<double>(discretization.dof_handler.n_dofs()));
      if (!old.empty())
        interpolate(transfer, old, refined);
      for (unsigned int k = 0; k < solutions.size(); ++k)
        {
          solutions[k] = GhostedVector(discretization.distribution);
          for (unsigned int i = 0; i < refined[k].size(); ++i)
            solutions[k][i] = refined[k][i];
        }
    }



    /// The owned cells with a face at such boundaries, with the middle and the
    /// size of that.
    template<int dim, typename Visit>
    void for_faces(const Mesh<dim>                    &mesh,
                   const std::set<types::boundary_id> &ids,
                   const Visit                        &visit)
    {
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->is_locally_owned() && cell->at_boundary(f) &&
              ids.count(cell->face(f)->boundary_id()) > 0)
            visit(cell, cell->face(f)->center(), cell->face(f)->diameter());
    }



    /// Flag the cells with a face at such boundaries that has one of these
    /// places.
    template<int dim>
    void flag_around(const Mesh<dim>                    &mesh,
                     const std::set<types::boundary_id> &ids,
                     const std::vector<Point<dim>>      &places)
    {
      for_faces(mesh,
                ids,
                [&](const auto       &cell,
                    const Point<dim> &middle,
                    const double      size) {
                  if (std::any_of(places.begin(),
                                  places.end(),
                                  [&](const Point<dim> &place) {
                                    return middle.distance(place) < 0.75 * size;
                                  }))
                    cell->set_refine_flag();
                });
    }



    /// The undeformed place of a contact point on the slave or on the master,
    /// from the nodes @p begin to @p end of its list.
    template<int dim>
    Point<dim> mean_place(const ContactPoint<dim> &point,
                          const unsigned int       begin,
                          const unsigned int       end)
    {
      Point<dim> sum;
      double     whole = 0;
      for (unsigned int a = begin; a < end; ++a)
        {
          sum += point.C[a] * point.X(a);
          whole += point.C[a];
        }
      return Point<dim>(sum / whole);
    }



    /// On a mesh of which a rank has a part.
    template<int dim>
    void transfer_distributed(Mesh<dim>                  &mesh,
                              Discretization<dim>        &discretization,
                              std::vector<GhostedVector> &solutions)
    {
      // A list leaves its vectors where they are: a copy, which a growing
      // std::vector makes, has no ghosts, and a cell at the border of a rank's
      // part has nodes that another rank owns.
      const auto                  &dof_handler = discretization.dof_handler;
      std::list<DistributedVector> old;
      std::vector<const DistributedVector *> old_pointers;
      for (const GhostedVector &solution : solutions)
        {
          old.push_back(discretization.distributed(solution));
          old_pointers.push_back(&old.back());
        }

      DistributedTransfer<dim, DistributedVector> transfer(dof_handler);
      mesh.triangulation.prepare_coarsening_and_refinement();
      transfer.prepare_for_coarsening_and_refinement(old_pointers);
      mesh.triangulation.execute_coarsening_and_refinement();
      discretization.redistribute();

      // Cells write on what neighbors own, too.
      const IndexSet relevant =
        DoFTools::extract_locally_relevant_dofs(dof_handler);
      std::vector<DistributedVector>   refined(solutions.size());
      std::vector<DistributedVector *> refined_pointers;
      for (DistributedVector &vector : refined)
        {
          vector.reinit(dof_handler.locally_owned_dofs(),
                        relevant,
                        discretization.communicator);
          refined_pointers.push_back(&vector);
        }
      transfer.interpolate(refined_pointers);

      for (unsigned int k = 0; k < solutions.size(); ++k)
        {
          solutions[k] = GhostedVector(discretization.distribution);
          std::copy(refined[k].begin(), refined[k].end(), solutions[k].begin());
          solutions[k].update_ghosts();
        }
    }
  } // namespace



  template<int dim>
  void check_adaptive(const Mesh<dim> &mesh)
  {
    if (!mesh.has_only_hypercubes())
      throw InputError(std::string("the mesh has ") +
                         Dimension<dim>::simplices +
                         ", and cannot be refined adaptively",
                       "entry 'Refinement/Strategy'",
                       std::string("set 'Strategy = uniform', or take a mesh "
                                   "of ") +
                         Dimension<dim>::hypercubes + " alone" +
                         (dim == 2 ? " (as meshes/ssnp154_quads.msh)" : ""));
  }



  // deal.II's GridRefinement knows this marking, but the one of distributed
  // meshes marks other cells than the one of a single process: results would
  // depend on the number of processes.
  template<int dim>
  void flag_cells(Mesh<dim>           &mesh,
                  const Vector<float> &indicators,
                  const double         fraction)
  {
    const auto        &triangulation = mesh.triangulation;
    std::vector<float> own, all;
    mesh.levels.forget();
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        own.push_back(indicators[cell->active_cell_index()]);
    for (const auto &of_rank :
         Utilities::MPI::all_gather(mesh.communicator, own))
      all.insert(all.end(), of_rank.begin(), of_rank.end());

    std::sort(all.begin(), all.end(), std::greater<float>());
    const double share = fraction * std::accumulate(all.begin(), all.end(), 0.);
    const double tie   = 1e-3;
    double       sum   = 0;
    auto         smallest = all.begin();
    while (sum < share)
      sum += *smallest++;
    if (smallest == all.begin())
      return;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() &&
          indicators[cell->active_cell_index()] >= (1 - tie) * *(smallest - 1))
        cell->set_refine_flag();
  }



  template<int dim>
  void flag_slave_like_master(Mesh<dim>                          &mesh,
                              const std::set<types::boundary_id> &slave,
                              const std::set<types::boundary_id> &master)
  {
    using Faces = std::vector<std::pair<Point<dim>, double>>;
    Faces flagged;
    for_faces(mesh,
              master,
              [&](const auto       &cell,
                  const Point<dim> &middle,
                  const double      size) {
                if (cell->refine_flag_set())
                  flagged.emplace_back(middle, size);
              });
    for (const Faces &of_rank :
         Utilities::MPI::all_gather(mesh.communicator, flagged))
      for_faces(
        mesh,
        slave,
        [&](const auto &cell, const Point<dim> &middle, const double size) {
          for (const auto &[other_middle, other_size] : of_rank)
            if (middle.distance(other_middle) < 0.75 * (size + other_size) &&
                size > 0.51 * other_size)
              cell->set_refine_flag();
        });
  }



  double cheapest_fraction(const Vector<float> &indicators,
                           const unsigned int   degree)
  {
    std::vector<double> sorted(indicators.begin(), indicators.end());
    std::sort(sorted.begin(), sorted.end(), std::greater<double>());
    const double sum   = std::accumulate(sorted.begin(), sorted.end(), 0.);
    const double to_go = std::log(std::max(2., 2 * sum));
    double       least = std::numeric_limits<double>::infinity();
    double       best  = 1;
    double       share = 0;
    for (unsigned int k = 0; k < sorted.size(); ++k)
      {
        share += sorted[k] / sum;
        const double growth = 1 + 3. * (k + 1) / sorted.size();
        const double left   = 1 - share * (1 - std::pow(2., -2. * degree));
        const double levels = std::max(1., to_go / -std::log(left));
        const double work =
          growth * (std::pow(growth, levels) - 1) / (growth - 1);
        if (work < least)
          {
            least = work;
            best  = share;
          }
      }
    return std::max(0.8, std::min(1., best));
  }



  template<int dim>
  void flag_by_indicators(const ContactModel<dim> &model,
                          const Parameters::All   &parameters,
                          const Vector<float>     &indicators)
  {
    Mesh<dim>   &mesh = *model.mesh;
    const double automatic =
      parameters.follows_goals()
        ? cheapest_fraction(indicators, parameters.element.degree)
        : 0.5;
    flag_cells(mesh,
               indicators,
               parameters.refinement.fraction > 0
                 ? parameters.refinement.fraction
                 : automatic);
    for (const auto &contact_pair : parameters.pairs())
      if (contact_pair.discretization ==
            Parameters::ContactDiscretization::nodal &&
          !contact_pair.master.empty())
        flag_slave_like_master(
          mesh,
          mesh.boundary(contact_pair.slave, contact_pair.section() + "/Slave"),
          mesh.boundary(contact_pair.master,
                        contact_pair.section() + "/Master"));
  }



  template<int dim>
  void flag_close_surfaces(const ContactModel<dim> &model,
                           const Parameters::All   &parameters,
                           const GhostedVector     &solution)
  {
    if (!model.interface)
      return;
    const ContactInterface<dim>           &interface = *model.interface;
    const std::vector<Parameters::Contact> of_pairs  = parameters.pairs();
    for (unsigned int k = 0; k < interface.pairs.size(); ++k)
      {
        const auto &contact_pair = *interface.pairs[k];
        const auto  points = contact_pair.points_among(interface.points());
        if (std::any_of(points.begin(), points.end(), [](const auto &point) {
              return point.status.kind != Status::open;
            }))
          continue;
        std::vector<Point<dim>> on_slave, on_master;
        for (const ContactPoint<dim> &point :
             contact_pair.points_of_slave(interface.points()))
          if (point.facing && interface.state(point, solution, solution).gap <
                                contact_pair.edge_length(point))
            {
              const unsigned int n = point.n_slave_nodes;
              on_slave.push_back(mean_place(point, 0, n));
              if (point.n_nodes > n)
                on_master.push_back(mean_place(point, n, point.n_nodes));
            }
        const Parameters::Contact &of_pair = of_pairs[k];
        const Mesh<dim>           &mesh    = *model.mesh;
        flag_around(mesh,
                    mesh.boundary(of_pair.slave, of_pair.section() + "/Slave"),
                    on_slave);
        if (!of_pair.master.empty())
          flag_around(mesh,
                      mesh.boundary(of_pair.master,
                                    of_pair.section() + "/Master"),
                      on_master);
      }
  }



  template<int dim>
  void flag_all_cells(Mesh<dim> &mesh)
  {
    mesh.levels.keep(mesh.triangulation);
    mesh.triangulation.set_all_refine_flags();
  }



  // In the 20-node element the centres of the new faces are bound, which the
  // free centre of an old face that may touch does not respect; and updates do
  // not bring back what is beside the constraints.
  template<int dim>
  void refine_and_transfer(Mesh<dim>                  &mesh,
                           Discretization<dim>        &discretization,
                           std::vector<GhostedVector> &solutions)
  {
    if (mesh.is_complete())
      transfer_complete(mesh, discretization, solutions);
    else
      transfer_distributed(mesh, discretization, solutions);

    const auto &constraints = discretization.followers();
    if (Utilities::MPI::max(constraints.n_constraints(),
                            discretization.communicator) > 0)
      for (GhostedVector &solution : solutions)
        discretization.distribute(constraints, solution);
  }

  template void flag_cells(Mesh<2>             &mesh,
                           const Vector<float> &indicators,
                           const double         fraction);
  template void
  flag_slave_like_master(Mesh<2>                            &mesh,
                         const std::set<types::boundary_id> &slave,
                         const std::set<types::boundary_id> &master);
#define INSTANTIATE(dim)                                                        \
  template void check_adaptive(const Mesh<dim> &mesh);                          \
  template void flag_by_indicators(const ContactModel<dim> &model,              \
                                   const Parameters::All   &parameters,         \
                                   const Vector<float>     &indicators);            \
  template void flag_close_surfaces(const ContactModel<dim> &model,             \
                                    const Parameters::All   &parameters,        \
                                    const GhostedVector     &solution);             \
  template void flag_all_cells(Mesh<dim> &mesh);                                \
  template void refine_and_transfer(Mesh<dim>                  &mesh,           \
                                    Discretization<dim>        &discretization, \
                                    std::vector<GhostedVector> &solutions);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
