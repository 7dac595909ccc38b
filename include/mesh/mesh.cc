/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/mesh.h"

#include <deal.II/distributed/shared_tria.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "mesh/arcs.h"
#include "mesh/coarse_mesh.h"

namespace Contact
{
  namespace
  {
    /// The group of this name, or an InputError with the names there are.
    template<typename T>
    const T &find(const std::map<std::string, T> &groups,
                  const char                     *kind,
                  const std::string              &name,
                  const std::string              &entry)
    {
      if (groups.count(name) > 0)
        return groups.at(name);

      std::string names;
      for (const auto &group : groups)
        names += (names.empty() ? "'" : ", '") + group.first + "'";
      throw InputError(std::string("the mesh has no ") + kind + " '" + name +
                         "'",
                       "entry '" + entry + "'",
                       "of this kind it has: " +
                         (names.empty() ? "none" : names));
    }



    /**
     * Put the cells as deal.II wants them. Its quadrangles have to agree on
     * the direction of the edges they share, which triangles need not: they
     * come last. Otherwise refinement would invert cells.
     */
    void order_cells(std::vector<CellData<2>> &cells)
    {
      const auto triangles =
        std::stable_partition(cells.begin(), cells.end(), [](const auto &cell) {
          return cell.vertices.size() == 4;
        });
      std::vector<CellData<2>> quadrangles(cells.begin(), triangles);
      for (auto &cell : quadrangles)
        std::swap(cell.vertices[2], cell.vertices[3]);
      if (!quadrangles.empty())
        GridTools::consistently_order_cells(quadrangles);
      std::copy(quadrangles.begin(), quadrangles.end(), cells.begin());
    }



    bool has_triangles(const MshFile &msh)
    {
      return std::any_of(msh.elements[2].begin(),
                         msh.elements[2].end(),
                         [](const auto &cell) {
                           return cell.nodes.size() == 3;
                         });
    }



    std::unique_ptr<Triangulation<2>>
    make_triangulation(const MshFile &msh, const MPI_Comm communicator)
    {
      if (Utilities::MPI::n_mpi_processes(communicator) == 1)
        return std::make_unique<Triangulation<2>>();
      if (has_triangles(msh))
        return std::make_unique<parallel::shared::Triangulation<2>>(
          communicator,
          Triangulation<2>::none,
          /*allow_artificial_cells=*/false,
          parallel::shared::Triangulation<2>::partition_zorder);
      return std::make_unique<parallel::distributed::Triangulation<2>>(
        communicator);
    }



    /**
     * The positions in the program of the points of the file: a body's own
     * move, then for all of them scale, rotation about the origin and shift.
     * Without any of these it changes no bit.
     */
    class Placement
    {
    public:
      /// Throws InputError if a body to be moved is not in @p bodies.
      Placement(const Parameters::Mesh                          &parameters,
                const std::map<std::string, types::material_id> &bodies)
        : scale(parameters.scale)
        , cosine(std::cos(parameters.rotation * numbers::PI / 180))
        , sine(std::sin(parameters.rotation * numbers::PI / 180))
        , shift({parameters.shift[0], parameters.shift[1]})
        , moves(bodies.size())
      {
        for (const auto &[name, move] : parameters.move)
          moves[find(bodies, "body", name, "Mesh/Move")] =
            Tensor<1, 2>({move[0], move[1]});
      }

      /// A point of the file that belongs to a body [mm].
      Point<2> operator()(const Point<2>          &p,
                          const types::material_id body) const
      {
        const Tensor<1, 2> q = scale * (p + moves[body]);
        return Point<2>(cosine * q[0] - sine * q[1] + shift[0],
                        sine * q[0] + cosine * q[1] + shift[1]);
      }

      /// Factor of all lengths [-].
      const double scale;

      /// Whether two bodies are moved alike, and stay together.
      bool move_alike(const types::material_id a,
                      const types::material_id b) const
      {
        return moves[a] == moves[b];
      }

    private:
      double                    cosine, sine;
      Tensor<1, 2>              shift;
      std::vector<Tensor<1, 2>> moves; // by body
    };



    /// Put the vertices where they belong; one that two bodies share can not
    /// move with both.
    void place_vertices(const std::vector<CellData<2>> &cells,
                        const Placement                &placement,
                        const MshFile                  &msh,
                        std::vector<Point<2>>          &points)
    {
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



    void check_arc(const Arc &arc, const Point<2> &p, const std::string &name)
    {
      if (!arc.on_circle(p))
        throw InputError("the point " + to_string(p) + " of the arc '" + name +
                           "' is " +
                           brief(p.distance(arc.center) - arc.radius) +
                           " mm away from its circle",
                         "entry 'Mesh/Arcs'",
                         "correct the circle, or the group in the mesh");
    }



    /// Make the boundaries of @p parameters round, whose lines are straight.
    /// An arc belongs to the body that it bounds, and moves with it.
    void set_arcs(const Parameters::Mesh &parameters,
                  const Placement        &placement,
                  Mesh                   &mesh)
    {
      const types::manifold_id arc_id = 1;
      std::vector<Arc>         arcs;
      for (const auto &[name, circle] : parameters.arcs)
        {
          const auto &ids = mesh.boundary(name, "Mesh/Arcs");
          std::map<types::material_id, Arc> of_body;
          for (const auto &cell : mesh.triangulation.active_cell_iterators())
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary() && ids.count(face->boundary_id()) > 0)
                {
                  const auto body = cell->material_id();
                  Arc       &arc  = of_body[body];
                  arc.center = placement(Point<2>(circle[0], circle[1]), body);
                  arc.radius = placement.scale * circle[2];
                  for (const unsigned int v : face->vertex_indices())
                    check_arc(arc, face->vertex(v), name);
                  arc.chords.push_back({{face->vertex(0), face->vertex(1)}});
                  face->set_manifold_id(arc_id);
                }
          for (const auto &[body, arc] : of_body)
            arcs.push_back(arc);
        }
      if (arcs.empty())
        return;

      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        if (cell->reference_cell() == ReferenceCells::Triangle)
          cell->set_all_manifold_ids(arc_id);
      mesh.triangulation.set_manifold(arc_id, ArcManifold(arcs));
    }
  } // namespace



  Mesh::Mesh(const Parameters::Mesh &parameters, const MPI_Comm communicator)
    : Mesh(parameters, read_msh(parameters.file), communicator)
  {
  }



  Mesh::Mesh(const Parameters::Mesh &parameters,
             const MshFile          &msh,
             const MPI_Comm          communicator)
    : communicator(communicator)
    , owned_triangulation(make_triangulation(msh, communicator))
    , triangulation(*owned_triangulation)
  {
    for (const auto &body : msh.names[2])
      bodies.emplace(body.second, bodies.size());

    const Placement placement(parameters, bodies);

    CoarseMesh coarse = make_coarse_mesh(msh, bodies);
    boundaries        = coarse.boundaries;
    points            = coarse.points;
    with_inner_lines  = coarse.with_inner_lines;
    place_vertices(coarse.cells, placement, msh, coarse.vertices);
    order_cells(coarse.cells);
    triangulation.create_triangulation(coarse.vertices,
                                       coarse.cells,
                                       coarse.lines);
    pieces.find(triangulation);
    set_arcs(parameters, placement, *this);
    refine(parameters.refinements);
  }



  Mesh::Mesh(const Mesh &other)
    : communicator(other.communicator)
    , owned_triangulation(std::make_unique<Triangulation<2>>())
    , triangulation(*owned_triangulation)
    , bodies(other.bodies)
    , boundaries(other.boundaries)
    , with_inner_lines(other.with_inner_lines)
    , points(other.points)
    , pieces(other.pieces)
  {
    AssertDimension(Utilities::MPI::n_mpi_processes(communicator), 1);
    triangulation.copy_triangulation(other.triangulation);
  }



  void Mesh::refine(const unsigned int n)
  {
    const double n_cells =
      std::ldexp(triangulation.n_global_active_cells(), 2 * n);
    if (n_cells > std::numeric_limits<unsigned int>::max())
      throw InputError("the mesh would have " + Utilities::to_string(n_cells) +
                         " cells, more than there are numbers for",
                       "entry 'Mesh/Refinements'",
                       "refine less often");
    triangulation.refine_global(n);
  }



  types::material_id Mesh::body(const std::string &name,
                                const std::string &entry) const
  {
    return find(bodies, "body", name, entry);
  }



  const std::set<types::boundary_id> &
  Mesh::boundary(const std::string &name, const std::string &entry) const
  {
    const auto &ids = find(boundaries, "boundary", name, entry);
    if (with_inner_lines.count(name) > 0)
      throw InputError("the boundary '" + name + "' has " +
                         (ids.empty() ? "only" : "also") +
                         " lines inside bodies",
                       "entry '" + entry + "'",
                       "name a group of lines that bound a body");
    return ids;
  }



  unsigned int Mesh::point(const std::string &name,
                           const std::string &entry) const
  {
    const unsigned int vertex = find(points, "point", name, entry);
    if (vertex == numbers::invalid_unsigned_int)
      throw InputError("the point group '" + name + "' has more than one point",
                       "entry '" + entry + "'",
                       "name a group of one point");
    return vertex;
  }



  bool Mesh::is_all_quadrilateral() const
  {
    return triangulation.all_reference_cells_are_hyper_cube();
  }



  bool Mesh::is_complete() const
  {
    return dynamic_cast<const parallel::distributed::Triangulation<2> *>(
             &triangulation) == nullptr;
  }



  std::string Mesh::body_name(const types::material_id id) const
  {
    for (const auto &[name, body] : bodies)
      if (body == id)
        return name;
    Assert(false, ExcMessage("There is no such body."));
    return "";
  }



  std::string Mesh::piece_name(const unsigned int piece) const
  {
    return pieces.describe(piece, body_name(pieces[piece].body));
  }
} // namespace Contact
