/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "solvers/rigid_pieces/rigid_body_modes.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/errors.h"
#include "solvers/rigid_pieces/resisted_motions.h"

namespace Contact
{
  namespace
  {
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
                            share(mesh.points.at(partner)[0], -1)},
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
          const Point<dim>   P        = discretization.rigid_point(name);
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
          for (unsigned int a = 0; a < facet.n_nodes(); ++a)
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
        return only_glue || interface.contact_pair(point).tied ||
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



    /// Contact wherever it may be: slaves move with whatever piece of the
    /// master they may touch.
    template<int dim>
    void resist_where_contact_may_be(const ContactInterface<dim> &interface,
                                     ResistedMotions<dim>        &motions)
    {
      for (const auto &contact_pair : interface.pairs)
        {
          std::set<unsigned int> masters;
          if (contact_pair->master)
            for (const SurfaceFacet<dim> &facet : contact_pair->master->facets)
              masters.insert(facet.piece);
          const Surface<dim> &slave = contact_pair->slave;
          for (const SurfaceFacet<dim> &facet : slave.facets)
            for (unsigned int a = 0; a < facet.n_nodes(); ++a)
              for (unsigned int c = 0; c < dim; ++c)
                {
                  const Point<dim> &X = slave.nodes[facet.nodes[a]].X;
                  const auto        e = Point<dim>::unit_vector(c);
                  if (masters.empty())
                    motions.resist({{facet.piece, X, 1}}, e);
                  for (const unsigned int master : masters)
                    motions.resist({{facet.piece, X, 1}, {master, X, -1}}, e);
                }
        }
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
    if (free.empty())
      return;
    std::string pieces = discretization.mesh.piece_name(free[0].piece);
    for (unsigned int i = 1; i < free.size(); ++i)
      if (free[i].name == free[0].name)
        pieces +=
          ", nor with it " + discretization.mesh.piece_name(free[i].piece);
    throw InputError("nothing holds " + pieces + " against: " + free[0].name,
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
