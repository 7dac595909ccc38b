/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mesh_h
#define contact_mesh_h

#include <deal.II/base/mpi.h>
#include <deal.II/grid/tria.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "mesh/level_meshes.h"
#include "mesh/mesh_pieces.h"
#include "parameters/parameters.h"

namespace Contact
{
  using namespace dealii;

  struct MshFile;

  /// A mesh in 2-D was asked for, and the file has volumes: the scene is
  /// one in 3-D.
  struct MeshOfVolumes
  {
    bool has_tetrahedra;
  };



  /// A place that the user names, at which no corner of a cell is.
  template<int dim>
  struct NamedPlace
  {
    /// Its place in each body that it may belong to: bodies may be moved by
    /// themselves [mm].
    std::map<types::material_id, Point<dim>> in_body;

    /// The corner of a cell next to it, and how far that is, both in the
    /// coordinates of the file [mm].
    Point<dim> closest_node;
    double     distance;
  };



  /**
   * The triangulation of all bodies and the names of its parts: bodies are
   * material ids (0, 1, ... in the order of gmsh's tags), boundaries are sets
   * of boundary ids (a face may belong to several groups: each combination of
   * groups has an id of its own; what is in no named group has the id 0),
   * points are vertices.
   *
   * Two nodes of the file stay two vertices even if they lie at the same
   * place, as those of two bodies that touch in a point do.
   */
  template<int dim>
  class Mesh
  {
  public:
    /**
     * Read a gmsh file in MSH format 2.2 or 4.1, ASCII, with physical names.
     * Quadrangles and triangles may be mixed, hexahedra and tetrahedra if they
     * share no nodes: otherwise, and with wedges and pyramids, all are split
     * into tetrahedra; of elements of second order only the corners are used;
     * left-handed cells are turned round; faces inside a body are ignored.
     * Bodies are moved and the whole is placed, round boundaries get their
     * manifold, then the mesh is refined.
     * Throws InputError.
     */
    explicit Mesh(const Parameters::Mesh &parameters,
                  const MPI_Comm          communicator = MPI_COMM_SELF);

    /// A copy to be refined by itself, of a mesh on one rank.
    Mesh(const Mesh &other);

    /// Of all ranks that have a part of the mesh.
    const MPI_Comm communicator;

  private:
    // Before the reference to it.
    std::unique_ptr<Triangulation<dim>> owned_triangulation;

  public:
    /**
     * On one rank a Triangulation. On several, quadrangles (hexahedra) alone
     * make a parallel::distributed one (p4est), of which a rank has its own
     * cells and their neighbors; a mesh with triangles (tetrahedra) a
     * parallel::shared one, of which every rank has all cells.
     */
    Triangulation<dim>                                 &triangulation;
    std::map<std::string, types::material_id>           bodies;
    std::map<std::string, std::set<types::boundary_id>> boundaries;

    /// In 3-D, of edges of cells.
    std::map<std::string, std::set<types::boundary_id>> curves;

    /// The groups of faces that bound bodies in part only.
    std::set<std::string> with_inner_faces;

    /// In 3-D the groups of lines that are not all on the boundary.
    std::set<std::string> inner_curves;

    /// Vertices by group: points which are no corners of cells are left out.
    std::map<std::string, std::vector<unsigned int>> points;

    /// Named places that are none of the points above.
    std::map<std::string, NamedPlace<dim>> places;

    /// The distance of a place from the one that is meant: what is typed has
    /// fewer digits than the file [mm].
    double typed_digits = 0;

    /// The pieces, each of which can move as a rigid body.
    MeshPieces<dim> pieces;

    /// Those of a multigrid on this mesh.
    LevelMeshes<dim> levels;

    /// Body -> how many of its cells were split into tetrahedra.
    std::map<std::string, unsigned int> n_split;

    /// The groups above, or an InputError which says what there is instead.
    /// @p entry is the entry of the parameters that names the group.
    types::material_id body(const std::string &name,
                            const std::string &entry) const;
    const std::set<types::boundary_id> &
    boundary(const std::string &name, const std::string &entry) const;
    unsigned int point(const std::string &name, const std::string &entry) const;

    /// An InputError on a place between nodes, where there has to be a node.
    void refuse_place(const std::string &name, const std::string &entry) const;

    /// The vertices of the coarse mesh on a boundary, curve or point group.
    std::set<unsigned int> coarse_vertices(const std::string &name) const;

    /// Whether there are no triangles and no tetrahedra, so that cells can be
    /// refined one by one.
    bool has_only_hypercubes() const
    {
      return triangulation.all_reference_cells_are_hyper_cube();
    }

    bool has_simplices() const
    {
      return !has_only_hypercubes();
    }

    bool has_hypercubes() const
    {
      return !triangulation.all_reference_cells_are_simplex();
    }

    /// Whether this rank has the whole mesh.
    bool is_complete() const;

    /// The name of a body by its id.
    std::string body_name(const types::material_id id) const;

    /// The name of a piece in messages, see MeshPieces::describe().
    std::string piece_name(const unsigned int piece) const
    {
      return pieces.describe(piece, body_name(pieces[piece].body));
    }

    /// Of the mesh @p msh, which has cells of this dimension.
    Mesh(const Parameters::Mesh &parameters,
         const MshFile          &msh,
         const MPI_Comm          communicator);

  private:
    /// Refine all cells n times.
    void refine(const unsigned int n);
  };
} // namespace Contact

#endif
