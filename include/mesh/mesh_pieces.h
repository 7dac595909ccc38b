/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_mesh_pieces_h
#define contact_mesh_pieces_h

#include <deal.II/base/bounding_box.h>
#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_accessor.h>
#include <deal.II/grid/tria_iterator.h>

#include <map>
#include <string>
#include <vector>

namespace Contact
{
  using namespace dealii;

  /**
   * The pieces that the bodies of a mesh consist of: cells of one body that
   * are connected through common edges, in 3-D common faces. Such a piece
   * moves as one rigid body, whatever the other pieces of its body do. They are
   * found on the coarse mesh, which all ranks have; a cell belongs to the piece
   * of its coarse ancestor.
   */
  template<int dim>
  class MeshPieces
  {
  public:
    struct Piece
    {
      types::material_id body;
      BoundingBox<dim>   box; // of its corners, undeformed [mm]
    };

    /// A vertex of the coarse mesh that two pieces have in common: a hinge, or
    /// one of several where two bodies are glued.
    struct Joint
    {
      unsigned int piece, other;
      Point<dim>   X; // [mm]
    };

    /// Call it after the coarse mesh was made.
    void find(const Triangulation<dim> &triangulation);

    unsigned int size() const
    {
      return pieces.size();
    }

    const Piece &operator[](const unsigned int piece) const
    {
      return pieces[piece];
    }

    const std::vector<Joint> &joints() const
    {
      return all_joints;
    }

    /// The piece that a cell of any level belongs to.
    unsigned int
    of_cell(const typename Triangulation<dim>::cell_iterator &cell) const;

    /// A piece that a vertex of the coarse mesh belongs to; the first one if
    /// there are several.
    unsigned int of_coarse_vertex(const unsigned int vertex) const
    {
      return by_vertex.at(vertex);
    }

    /// Whether its body consists of this piece alone.
    bool is_whole_body(const unsigned int piece) const;

    /// The name in messages of a piece of the body @p body: "the body 'A'", or,
    /// where there are several, "the piece of the body 'A' from (0, 0) to (2,
    /// 1) mm" by the corners of its box.
    std::string describe(const unsigned int piece,
                         const std::string &body) const;

  private:
    void find_joints(const Triangulation<dim> &triangulation);

    std::vector<Piece>                   pieces;
    std::vector<unsigned int>            by_coarse_cell;
    std::map<unsigned int, unsigned int> by_vertex;
    std::vector<Joint>                   all_joints;
  };
} // namespace Contact

#endif
