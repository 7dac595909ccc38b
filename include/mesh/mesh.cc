/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/mesh.h"

#include <deal.II/distributed/shared_tria.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/dimension.h"
#include "base/errors.h"
#include "base/string_utilities.h"
#include "mesh/automatic_pairs.h"
#include "mesh/coarse_mesh.h"
#include "mesh/distributed_mesh.h"
#include "mesh/groups.h"
#include "mesh/joined_cells.h"
#include "mesh/placement.h"
#include "mesh/round_boundaries.h"

namespace Contact
{
  namespace
  {
    /**
     * Put the cells as deal.II wants them: its corners are in lexicographic
     * order, and cells have to agree on the direction of the edges they share,
     * which triangles and tetrahedra need not: they come last. Otherwise
     * refinement would invert cells.
     */
    template<int dim>
    void order_cells(std::vector<CellData<dim>> &cells)
    {
      const auto simplices =
        std::stable_partition(cells.begin(), cells.end(), [](const auto &cell) {
          return cell.vertices.size() == GeometryInfo<dim>::vertices_per_cell;
        });
      std::vector<CellData<dim>> hypercubes(cells.begin(), simplices);
      for (auto &cell : hypercubes)
        for (unsigned int layer = 0; layer < cell.vertices.size(); layer += 4)
          std::swap(cell.vertices[layer + 2], cell.vertices[layer + 3]);
      if (!hypercubes.empty())
        GridTools::consistently_order_cells(hypercubes);
      std::copy(hypercubes.begin(), hypercubes.end(), cells.begin());
    }



    /// Cells that share no more than a vertex differ by one level at most, as
    /// in p4est's forests of several processes: the refined mesh is the same
    /// on any number of them.
    template<int dim>
    std::unique_ptr<Triangulation<dim>>
    make_triangulation(const MshFile &msh, const MPI_Comm communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return std::make_unique<Triangulation<dim>>(
          msh.has_simplices()
            ? Triangulation<dim>::none
            : Triangulation<dim>::limit_level_difference_at_vertices);
      if (msh.has_simplices())
        return std::make_unique<parallel::shared::Triangulation<dim>>(
          communicator,
          Triangulation<dim>::none,
          /*allow_artificial_cells=*/false,
          parallel::shared::Triangulation<dim>::partition_zorder);
      return std::make_unique<DistributedMesh<dim>>(communicator);
    }



    /// Put the vertices where they belong; one that two bodies share cannot
    /// move with both.
    template<int dim>
    void place_vertices(const Placement<dim> &placement,
                        const MshFile        &msh,
                        CoarseMesh<dim>      &coarse)
    {
      const auto                     &cells  = coarse.cells;
      auto                           &points = coarse.vertices;
      std::vector<types::material_id> body(points.size(),
                                           numbers::invalid_material_id);
      for (const auto &cell : cells)
        for (const unsigned int v : cell.vertices)
          if (body[v] == numbers::invalid_material_id)
            body[v] = cell.material_id;
          else if (!placement.move_alike(body[v], cell.material_id))
            throw InputError("two bodies share the node at " +
                               to_string(points[v]) +
                               ", but only one of them is moved",
                             msh.name,
                             "move both alike in entry 'Mesh/Move', or none");
      for (unsigned int v = 0; v < points.size(); ++v)
        points[v] = placement(points[v], body[v]);
      for (auto &[side, middle] : coarse.mid_sides)
        middle = placement(middle, body[side[0]]);

      // Products of two areas are the largest and smallest numbers of the
      // geometry.
      for (const auto &cell : cells)
        {
          const double square =
            (points[cell.vertices[1]] - points[cell.vertices[0]]).norm_square();
          if (!std::isnormal(square * square))
            throw InputError("a cell has a side of " +
                               brief(std::sqrt(square)) +
                               " mm, too far from 1 mm for floating point",
                             msh.name + ", entry 'Mesh/Scale'",
                             "choose a scale that makes millimetres of the "
                             "lengths of the file");
        }
    }



    const std::string points_entry = "entry 'Mesh/Points'";

    /// The coordinates of a place that the user names.
    template<int dim>
    Point<dim> read_place(const std::string         &name,
                          const std::vector<double> &numbers)
    {
      if (numbers.size() != dim)
        throw InputError("the point '" + name + "' is no place",
                         points_entry,
                         std::string("write '") + Dimension<dim>::coordinates +
                           "', in mm");
      Point<dim> X;
      std::copy(numbers.begin(), numbers.end(), &X[0]);
      return X;
    }



    /// The bodies that a place may belong to: the one of 'name in body', which
    /// is taken off the name, or all.
    template<int dim>
    std::set<types::material_id> bodies_of(std::string     &name,
                                           const Mesh<dim> &mesh)
    {
      const std::string            in = " in ";
      std::set<types::material_id> ids;
      if (const auto position = name.rfind(in); position != std::string::npos)
        {
          ids.insert(
            mesh.body(name.substr(position + in.size()), "Mesh/Points"));
          name.erase(position);
        }
      else
        for (const auto &[body, id] : mesh.bodies)
          ids.insert(id);
      return ids;
    }



    /// The vertices that cells of these bodies have.
    template<int dim>
    std::vector<unsigned int>
    vertices_of(const std::set<types::material_id> &bodies,
                const CoarseMesh<dim>              &coarse)
    {
      std::set<unsigned int> vertices;
      for (const auto &cell : coarse.cells)
        if (bodies.count(cell.material_id) > 0)
          vertices.insert(cell.vertices.begin(), cell.vertices.end());
      return {vertices.begin(), vertices.end()};
    }



    /// The places that the user names, in the coordinates of the file, where
    /// two bodies that touch may have a vertex each.
    template<int dim>
    void name_points(const Parameters::Mesh &parameters,
                     const Placement<dim>   &placement,
                     const CoarseMesh<dim>  &coarse,
                     Mesh<dim>              &mesh)
    {
      const double typed = 1e-4; // of the size of the mesh
      double       size  = 0;
      for (const Point<dim> &vertex : coarse.vertices)
        size = std::max(size, vertex.distance(coarse.vertices.front()));
      mesh.typed_digits = typed * size * placement.scale;
      for (const auto &[key, numbers] : parameters.points)
        {
          std::string      name   = key;
          const auto       bodies = bodies_of(name, mesh);
          const Point<dim> X      = read_place<dim>(name, numbers);
          if (mesh.points.count(name) + mesh.places.count(name) > 0)
            throw InputError(coarse.points.count(name) > 0
                               ? "the mesh file has a point '" + name +
                                   "' of its own"
                               : "the point '" + name + "' is named twice",
                             points_entry,
                             "choose another name");
          const auto vertices = vertices_of(bodies, coarse);
          const auto distance = [&](const unsigned int v) {
            return X.distance(coarse.vertices[v]);
          };
          const auto closest =
            std::min_element(vertices.begin(),
                             vertices.end(),
                             [&](const auto a, const auto b) {
                               return distance(a) < distance(b);
                             });
          const Point<dim> node = coarse.vertices[*closest];
          if (distance(*closest) > typed * size)
            {
              NamedPlace<dim> &place = mesh.places[name];
              for (const auto body : bodies)
                place.in_body[body] = placement(X, body);
              place.closest_node = node;
              place.distance     = distance(*closest);
              continue;
            }
          if (std::count_if(vertices.begin(),
                            vertices.end(),
                            [&](const auto v) {
                              return coarse.vertices[v] == node;
                            }) > 1)
            throw InputError("two bodies have a node at the point '" + name +
                               "'",
                             points_entry,
                             "name the body, '" + name +
                               " in BODY: x, y', or the point in the file");
          mesh.points[name] = {*closest};
        }
    }
  } // namespace



  template<int dim>
  Mesh<dim>::Mesh(const Parameters::Mesh &parameters,
                  const MPI_Comm          communicator)
    : Mesh(parameters, read_with_surfaces(parameters), communicator)
  {
  }



  template<int dim>
  Mesh<dim>::Mesh(const Parameters::Mesh &parameters,
                  const MshFile          &msh,
                  const MPI_Comm          communicator)
    : communicator(communicator)
    , owned_triangulation(make_triangulation<dim>(msh, communicator))
    , triangulation(*owned_triangulation)
  {
    if (msh.dimension() > dim)
      throw MeshOfVolumes{msh.has_simplices()};
    if (msh.dimension() != dim)
      throw InputError("the mesh has no volumes",
                       msh.name,
                       "mesh volumes: gmsh -3");
    for (const auto &body : msh.names[dim])
      bodies.emplace(body.second, bodies.size());

    const Placement<dim> placement(parameters, bodies);

    CoarseMesh<dim> coarse = make_coarse_mesh<dim>(msh, bodies);
    boundaries             = coarse.boundaries;
    curves                 = coarse.curves;
    points                 = coarse.points;
    with_inner_faces       = coarse.with_inner_faces;
    inner_curves           = coarse.inner_curves;
    n_split                = msh.n_split;
    unite_groups(parameters.groups, boundaries, with_inner_faces);
    name_points(parameters, placement, coarse, *this);
    place_vertices(placement, msh, coarse);
    order_cells(coarse.cells);
    triangulation.create_triangulation(coarse.vertices,
                                       coarse.cells,
                                       coarse.faces);
    check_joined_cells(triangulation, boundaries, msh.name);
    pieces.find(triangulation);
    if (!parameters.mid_side_nodes)
      coarse.mid_sides.clear();
    else if (coarse.mid_sides.empty())
      throw InputError("the mesh has no elements of second order",
                       "entry 'Mesh/Mid-side nodes'",
                       "mesh with gmsh -order 2, or remove the entry");
    make_round(parameters, placement, coarse.mid_sides, *this);
    refine(parameters.refinements);
  }



  template<int dim>
  Mesh<dim>::Mesh(const Mesh<dim> &other)
    : communicator(other.communicator)
    , owned_triangulation(std::make_unique<Triangulation<dim>>())
    , triangulation(*owned_triangulation)
    , bodies(other.bodies)
    , boundaries(other.boundaries)
    , curves(other.curves)
    , with_inner_faces(other.with_inner_faces)
    , inner_curves(other.inner_curves)
    , points(other.points)
    , places(other.places)
    , typed_digits(other.typed_digits)
    , pieces(other.pieces)
  {
    AssertDimension(Utilities::MPI::n_mpi_processes(communicator), 1);
    triangulation.copy_triangulation(other.triangulation);
  }



  template<int dim>
  void Mesh<dim>::refine(const unsigned int n)
  {
    const double n_cells =
      std::ldexp(triangulation.n_global_active_cells(), dim * n);
    if (n_cells > std::numeric_limits<unsigned int>::max())
      throw InputError("the mesh would have " + Utilities::to_string(n_cells) +
                         " cells, more than there are numbers for",
                       "entry 'Mesh/Refinements'",
                       "refine less often");
    for (unsigned int i = 0; i < n; ++i)
      {
        levels.keep(triangulation);
        triangulation.refine_global(1);
      }
  }



  template<int dim>
  types::material_id Mesh<dim>::body(const std::string &name,
                                     const std::string &entry) const
  {
    return find_group(bodies, "body", name, entry);
  }



  template<int dim>
  const std::set<types::boundary_id> &
  Mesh<dim>::boundary(const std::string &name, const std::string &entry) const
  {
    if (inner_curves.count(name) > 0 && boundaries.count(name) == 0)
      throw InputError("the curve '" + name +
                         "' has lines that are no edges of cells on the "
                         "boundary",
                       "entry '" + entry + "'",
                       "mesh the curve and the volume together, or name "
                       "another group");
    const auto &ids = find_group(boundaries, "boundary", name, entry);
    if (with_inner_faces.count(name) > 0)
      throw InputError("the boundary '" + name + "' has " +
                         (ids.empty() ? "only" : "also") + " " +
                         Dimension<dim>::boundary + "s inside bodies",
                       "entry '" + entry + "'",
                       std::string("name a group of ") +
                         Dimension<dim>::boundary + "s that bound a body");
    return ids;
  }



  template<int dim>
  unsigned int Mesh<dim>::point(const std::string &name,
                                const std::string &entry) const
  {
    refuse_place(name, entry);
    const auto &vertices = find_group(points, "point", name, entry);
    if (vertices.size() > 1)
      throw InputError("the point group '" + name + "' has more than one point",
                       "entry '" + entry + "'",
                       "name a group of one point");
    return vertices[0];
  }



  template<int dim>
  void Mesh<dim>::refuse_place(const std::string &name,
                               const std::string &entry) const
  {
    if (const auto place = places.find(name); place != places.end())
      throw InputError("the point '" + name +
                         "' lies between nodes, where there can be forces, "
                         "probes and the point of a rigid boundary alone",
                       "entry '" + entry + "'",
                       "name a corner of a cell in 'Mesh/Points': the closest "
                       "one is at " +
                         to_string(place->second.closest_node) + " mm, " +
                         brief(place->second.distance) +
                         " mm away, in the coordinates of the file");
  }



  template<int dim>
  std::set<unsigned int>
  Mesh<dim>::coarse_vertices(const std::string &name) const
  {
    if (const auto point = points.find(name); point != points.end())
      return {point->second.begin(), point->second.end()};
    std::set<unsigned int> vertices;
    const auto             insert = [&](const auto &part, const auto &ids) {
      if (ids.count(part->boundary_id()) > 0)
        for (const unsigned int v : part->vertex_indices())
          vertices.insert(part->vertex_index(v));
    };
    const auto curve = curves.find(name);
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      if (curve != curves.end())
        for (const unsigned int l : cell->line_indices())
          insert(cell->line(l), curve->second);
      else
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            insert(face, boundaries.at(name));
    return vertices;
  }



  template<int dim>
  bool Mesh<dim>::is_complete() const
  {
    return dynamic_cast<const parallel::distributed::Triangulation<dim> *>(
             &triangulation) == nullptr;
  }



  template<int dim>
  std::string Mesh<dim>::body_name(const types::material_id id) const
  {
    for (const auto &[name, body] : bodies)
      if (body == id)
        return name;
    Assert(false, ExcMessage("There is no such body."));
    return "";
  }

  template class Mesh<2>;
  template class Mesh<3>;
} // namespace Contact
