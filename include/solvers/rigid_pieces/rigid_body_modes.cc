/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/rigid_pieces/rigid_body_modes.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/errors.h"

namespace Contact
{
  namespace
  {
    /// A part of a displacement: @p factor times that of a piece at X.
    template<int dim>
    struct Share
    {
      unsigned int piece;
      Point<dim>   X;
      double       factor;
    };



    /// The resisted directions, in terms of the rigid motions of all pieces:
    /// displacements, and rotations about the centre times the size.
    template<int dim>
    class ResistedMotions
    {
    public:
      static constexpr unsigned int n_motions = dim * (dim + 1) / 2;

      ResistedMotions(const MeshPieces<dim> &pieces,
                      const Rotations<dim>  &rotations)
        : pieces(pieces)
        , rotations(rotations)
        , squares(n_motions * pieces.size(), n_motions * pieces.size())
      {
      }

      /// The sum of the shares is resisted along @p direction.
      void resist(const std::vector<Share<dim>> &shares,
                  const Tensor<1, dim>          &direction)
      {
        std::map<unsigned int, double> row;
        for (const auto &[piece, X, factor] : shares)
          {
            const auto    &box  = pieces[piece].box;
            const auto    &ends = box.get_boundary_points();
            Tensor<1, dim> arm =
              (X - box.center()) / (0.5 * ends.first.distance(ends.second));
            if (const auto turned = rotations.find(pieces[piece].body);
                turned != rotations.end())
              arm = turned->second * arm;
            for (unsigned int m = 0; m < n_motions; ++m)
              row[n_motions * piece + m] +=
                factor * (direction * rigid_motion(m, arm));
          }
        for (const auto &[i, a] : row)
          for (const auto &[j, b] : row)
            squares(i, j) += a * b;
      }

      /// A motion of each piece by itself is resisted.
      void resist(const unsigned int motion)
      {
        for (unsigned int piece = 0; piece < pieces.size(); ++piece)
          squares(n_motions * piece + motion, n_motions * piece + motion) += 1;
      }

      /// Add what the other ranks have.
      void sum(const MPI_Comm communicator)
      {
        Utilities::MPI::sum(squares, communicator, squares);
      }

      /// The orthogonal projection onto the motions that are free.
      FullMatrix<double> projection_onto_free() const;

    private:
      const MeshPieces<dim> &pieces;
      const Rotations<dim>  &rotations;
      FullMatrix<double>     squares;
    };



    // Rows that resist the same motion many times would hide others that one
    // row resists: all diagonal entries are scaled to one, but those that are
    // round-off beside the others of their piece.
    template<int dim>
    FullMatrix<double> ResistedMotions<dim>::projection_onto_free() const
    {
      const double        round_off = 1e-10;
      const unsigned int  n         = squares.m();
      std::vector<double> scale(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          double largest = 0;
          for (unsigned int j = i - i % n_motions;
               j < i - i % n_motions + n_motions;
               ++j)
            largest = std::max(largest, squares(j, j));
          const double square = std::max(squares(i, i), round_off * largest);
          scale[i]            = square > 0 ? 1 / std::sqrt(square) : 1;
        }

      LAPACKFullMatrix<double> scaled(n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          scaled(i, j) = scale[i] * squares(i, j) * scale[j];
      Vector<double>     values;
      FullMatrix<double> modes;
      scaled.compute_eigenvalues_symmetric(-1, round_off, 0, values, modes);

      // Unscaled, the modes are no longer orthonormal (Gram and Schmidt, twice
      // because of round-off).
      FullMatrix<double>          projection(n, n);
      std::vector<Vector<double>> basis;
      for (unsigned int m = 0; m < values.size(); ++m)
        {
          Vector<double> mode(n);
          for (unsigned int i = 0; i < n; ++i)
            mode[i] = scale[i] * modes(i, m);
          mode /= mode.l2_norm();
          for (unsigned int pass = 0; pass < 2; ++pass)
            for (const Vector<double> &other : basis)
              mode.add(-(mode * other), other);
          mode /= mode.l2_norm();
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              projection(i, j) += mode[i] * mode[j];
          basis.push_back(mode);
        }
      return projection;
    }



    /// Supports, vertex by vertex, and what rings resist by themselves: growing
    /// and turning inside out.
    template<int dim>
    void resist_by_supports(const Discretization<dim> &discretization,
                            ResistedMotions<dim>      &motions)
    {
      const Mesh<dim> &mesh = discretization.mesh;
      for (const auto &cell : mesh.triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int v : cell->vertex_indices())
            {
              const NodeDoFs<dim> &node =
                discretization.vertex_dofs[cell->vertex_index(v)];
              auto held = discretization.normal_supports.normals(node);
              for (unsigned int c = 0; c < dim; ++c)
                if (discretization.is_fixed(node[c]))
                  held.push_back(Point<dim>::unit_vector(c));
              for (const Tensor<1, dim> &direction : held)
                motions.resist(
                  {{mesh.pieces.of_cell(cell), cell->vertex(v), 1}},
                  direction);
            }
      motions.sum(discretization.communicator);
      if (discretization.axisymmetric)
        for (const unsigned int motion : {0, 2})
          motions.resist(motion);
    }



    /// Ties, and the nodes that two pieces have in common.
    template<int dim>
    void resist_by_joints(const Discretization<dim> &discretization,
                          ResistedMotions<dim>      &motions)
    {
      const Mesh<dim> &mesh = discretization.mesh;
      for (const auto &[piece, other, X] : mesh.pieces.joints())
        for (unsigned int c = 0; c < dim; ++c)
          motions.resist({{piece, X, 1}, {other, X, -1}},
                         Point<dim>::unit_vector(c));

      const auto share = [&](const unsigned int vertex, const double factor) {
        return Share<dim>{mesh.pieces.of_coarse_vertex(vertex),
                          mesh.triangulation.get_vertices()[vertex],
                          factor};
      };
      for (unsigned int c = 0; c < dim; ++c)
        for (const auto &[name, partner] : discretization.boundary.tied[c])
          for (const unsigned int vertex : mesh.coarse_vertices(name))
            motions.resist({share(vertex, 1),
                            share(mesh.points.at(partner), -1)},
                           Point<dim>::unit_vector(c));
    }



    /// Rigid boundaries: all pieces move as the first one there, which does not
    /// move where they are prescribed to.
    template<int dim>
    void resist_by_rigid_boundaries(const Discretization<dim> &discretization,
                                    ResistedMotions<dim>      &motions)
    {
      const Mesh<dim> &mesh     = discretization.mesh;
      const auto      &places   = mesh.triangulation.get_vertices();
      const auto      &boundary = discretization.boundary;
      for (const auto &[name, point] : boundary.rigid)
        {
          const auto         vertices = mesh.coarse_vertices(name);
          const Point<dim>   P        = places[mesh.points.at(point)];
          const unsigned int piece =
            mesh.pieces.of_coarse_vertex(*vertices.begin());
          for (const unsigned int vertex : vertices)
            if (const auto other = mesh.pieces.of_coarse_vertex(vertex);
                other != piece)
              for (unsigned int c = 0; c < dim; ++c)
                motions.resist({{piece, places[vertex], 1},
                                {other, places[vertex], -1}},
                               Point<dim>::unit_vector(c));
          for (unsigned int c = 0; c < 3; ++c)
            {
              if (boundary.displacement[c].count(name) +
                    boundary.displacement_formula[c].count(name) >
                  0)
                motions.resist({{piece, P, 1}}, Point<dim>::unit_vector(c));
              if (boundary.rotation[c].count(name) == 0)
                continue;
              const double size =
                P.distance(places[*vertices.begin()]) +
                places[*vertices.begin()].distance(places[*vertices.rbegin()]);
              const Point<dim> beside =
                P + size * Point<dim>::unit_vector((c + 1) % 3);
              motions.resist({{piece, beside, 1}, {piece, P, -1}},
                             Point<dim>::unit_vector((c + 2) % 3));
            }
        }
    }



    /// Visit the nodes of all facets that may touch.
    template<int dim, typename Visit>
    void for_facets(const ContactInterface<dim> &interface, const Visit &visit)
    {
      const auto of_surface = [&](const Surface<dim> &surface) {
        for (const SurfaceFacet<dim> &facet : surface.facets)
          for (unsigned int a = 0; a < surface.n_nodes_per_facet(); ++a)
            visit(facet, surface.nodes[facet.nodes[a]]);
      };
      for (const auto &contact_pair : interface.pairs)
        {
          of_surface(contact_pair->slave);
          if (contact_pair->master)
            of_surface(*contact_pair->master);
        }
    }



    /// The points in contact.
    template<int dim>
    void resist_by_contact(const ContactInterface<dim> &interface,
                           const Tangents               tangents,
                           ResistedMotions<dim>        &motions)
    {
      std::map<types::global_dof_index, unsigned int> of_node;
      for_facets(interface, [&](const auto &facet, const auto &node) {
        of_node[node.dofs[0]] = facet.piece;
      });
      const bool only_glue = tangents == Tangents::glued;
      const auto sticks    = [&](const ContactPoint<dim> &point) {
        return only_glue ||
               (tangents == Tangents::by_status
                     ? point.status.kind == Status::stick
                     : tangents == Tangents::stuck &&
                      !interface.contact_pair(point).law.is_frictionless());
      };
      for (const ContactPoint<dim> &point : interface.points())
        {
          if (point.status.kind == Status::open ||
              (only_glue && !interface.contact_pair(point).tied))
            continue;
          std::vector<Share<dim>> shares;
          for (unsigned int a = 0; a < point.n_nodes; ++a)
            shares.push_back(
              {of_node.at(point.dofs(a)[0]), point.X(a), point.C[a]});
          motions.resist(shares, point.normal);
          if (sticks(point))
            for (const Tensor<1, dim> &tangent : point.tangents)
              motions.resist(shares, tangent);
        }
    }



    /// All nodes that may come into contact, whatever it be with.
    template<int dim>
    void resist_where_contact_may_be(const ContactInterface<dim> &interface,
                                     ResistedMotions<dim>        &motions)
    {
      for_facets(interface, [&](const auto &facet, const auto &node) {
        for (unsigned int c = 0; c < dim; ++c)
          motions.resist({{facet.piece, node.X, 1}},
                         Point<dim>::unit_vector(c));
      });
    }



    /// How many motions are in the range of a projection.
    unsigned int number_of_motions(const FullMatrix<double> &projection)
    {
      const unsigned int       size = projection.m();
      LAPACKFullMatrix<double> matrix(size);
      matrix = projection;
      Vector<double>     values;
      FullMatrix<double> vectors;
      matrix.compute_eigenvalues_symmetric(-1, 2 * size, 0, values, vectors);
      double largest = 0;
      for (const double value : values)
        largest = std::max(largest, value);
      return std::count_if(values.begin(),
                           values.end(),
                           [&](const double value) {
                             return value > 0.01 * largest;
                           });
    }



    /// The motions in the range of a projection, in words.
    std::string name_of_motions(const FullMatrix<double> &projection)
    {
      static const std::vector<std::string> in_plane{"displacement in x",
                                                     "displacement in y",
                                                     "rotation"},
        in_space{"displacement in x",
                 "displacement in y",
                 "displacement in z",
                 "rotation about x",
                 "rotation about y",
                 "rotation about z"};
      const auto &names   = projection.m() == 3 ? in_plane : in_space;
      double      largest = 0;
      for (unsigned int i = 0; i < names.size(); ++i)
        largest = std::max(largest, projection(i, i));
      std::vector<std::string> parts;
      for (unsigned int i = 0; i < names.size(); ++i)
        if (projection(i, i) > 0.01 * largest)
          parts.push_back(names[i]);
      const bool  is_one = number_of_motions(projection) == 1;
      std::string text   = parts[0];
      for (unsigned int i = 1; i < parts.size(); ++i)
        text += (is_one                 ? " with "
                 : i + 1 < parts.size() ? ", "
                                        : " and ") +
                parts[i];
      return text;
    }



    template<int dim>
    std::vector<RigidBodyMode> find_free(const MeshPieces<dim>      &pieces,
                                         const ResistedMotions<dim> &motions)
    {
      const FullMatrix<double>   projection = motions.projection_onto_free();
      constexpr unsigned int     n          = ResistedMotions<dim>::n_motions;
      std::vector<RigidBodyMode> free;
      for (unsigned int piece = 0; piece < pieces.size(); ++piece)
        {
          FullMatrix<double> part(n, n);
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j < n; ++j)
              part(i, j) = projection(n * piece + i, n * piece + j);
          // The square of its share in the motion of all.
          if (part.trace() > 1e-6)
            free.push_back(
              {piece, name_of_motions(part), number_of_motions(part)});
        }
      return free;
    }
  } // namespace



  template<int dim>
  std::vector<RigidBodyMode>
  rigid_body_modes(const Discretization<dim>   &discretization,
                   const ContactInterface<dim> *interface,
                   const Tangents               tangents,
                   const Rotations<dim>        &rotations)
  {
    ResistedMotions<dim> motions(discretization.mesh.pieces, rotations);
    resist_by_supports(discretization, motions);
    resist_by_joints(discretization, motions);
    resist_by_rigid_boundaries(discretization, motions);
    if (interface != nullptr)
      resist_by_contact(*interface, tangents, motions);
    return find_free(discretization.mesh.pieces, motions);
  }



  template<int dim>
  void check_supports(const Discretization<dim>   &discretization,
                      const ContactInterface<dim> *interface)
  {
    const Rotations<dim> none;
    ResistedMotions<dim> motions(discretization.mesh.pieces, none);
    resist_by_supports(discretization, motions);
    resist_by_joints(discretization, motions);
    resist_by_rigid_boundaries(discretization, motions);
    if (interface != nullptr)
      resist_where_contact_may_be(*interface, motions);
    const auto free = find_free(discretization.mesh.pieces, motions);
    if (!free.empty())
      throw InputError("nothing holds " +
                         discretization.mesh.piece_name(free.front().piece) +
                         " against: " + free.front().name,
                       "Boundary conditions, Contact",
                       "support it in that motion, tie a point of it, or "
                       "give it a surface that can touch another body");
  }

#define INSTANTIATE(dim)                                                    \
  template std::vector<RigidBodyMode> rigid_body_modes(                     \
    const Discretization<dim>   &discretization,                            \
    const ContactInterface<dim> *interface,                                 \
    const Tangents               tangents,                                  \
    const Rotations<dim>        &rotations);                                       \
  template void check_supports(const Discretization<dim>   &discretization, \
                               const ContactInterface<dim> *interface);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
