/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_normal_supports_h
#define contact_normal_supports_h

#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/ghosted_vector.h"
#include "bodies/discretized_bodies.h"
#include "mesh/mesh.h"

namespace Contact
{
  using namespace dealii;

  /// One number for each entry of displacements: in x, y, z, and normal. Of
  /// factors by their histories, and of displacements at full value [mm].
  template<int dim>
  using PerSupportEntry = std::array<double, dim + 1>;

  /// The motion that supports prescribe under a load factor: the factors of
  /// their entries, and formulas of the place and the load factor [mm].
  template<int dim>
  struct SupportMotion
  {
    using Formula = std::function<double(const Point<dim> &X, const double t)>;

    PerSupportEntry<dim>        factors;
    double                      load_factor;
    const std::vector<Formula> &formulas;
  };



  /// A displacement that supports prescribe: its parts by entry times their
  /// factors [mm], or a formula by its number, at a place.
  template<int dim>
  struct Prescribed
  {
    PerSupportEntry<dim> parts{};
    unsigned int         formula = numbers::invalid_unsigned_int;
    Point<dim>           X{};

    double at(const SupportMotion<dim> &motion) const
    {
      if (has_formula())
        return motion.formulas[formula](X, motion.load_factor);
      double sum = 0;
      for (unsigned int k = 0; k <= dim; ++k)
        if (parts[k] != 0)
          sum += parts[k] * motion.factors[k];
      return sum;
    }

    bool has_formula() const
    {
      return formula != numbers::invalid_unsigned_int;
    }

    bool is_moved() const
    {
      return has_formula() || !(parts == PerSupportEntry<dim>());
    }

    bool operator!=(const Prescribed &other) const
    {
      return parts != other.parts || formula != other.formula || X != other.X;
    }

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      for (double &part : parts)
        archive &part;
      archive &formula &X;
    }
  };



  /**
   * Supports of flat boundaries along their outward normal n:
   *   n . u = value times its factor [mm]
   * at each node. With several of them at a node, or supports along the
   * coordinates, the equations of the node are solved for as many unknowns by
   * elimination with full pivoting: two planes leave one direction, three
   * none. A hanging node follows nodes of the same plane and has none.
   *
   * Throws InputError if a boundary is not flat, or a node is to be moved in
   * two ways.
   */
  template<int dim>
  class NormalSupports
  {
  public:
    using Dof = types::global_dof_index;

    /// u_pivot = prescribed + sum of c_k u_k, the u_k free unknowns of the same
    /// node.
    struct Line
    {
      Dof                                 pivot;
      std::vector<std::pair<Dof, double>> entries;
      Prescribed<dim>                     prescribed;

      /// The way of the pivot from @p u to where the supports want it, exactly
      /// zero within round-off [mm].
      double motion(const GhostedVector      &u,
                    const SupportMotion<dim> &motion) const;
    };

    /// @p values are by name of a boundary [mm].
    NormalSupports(const Mesh<dim>                     &mesh,
                   const std::map<std::string, double> &values);

    /// Find the nodes. Collective.
    void find_nodes(const DoFHandler<dim> &dof_handler);

    /// Solve for unknowns that @p prescribed does not have yet. Those without
    /// free unknowns are added to it.
    void solve(std::map<Dof, Prescribed<dim>> &prescribed);

    const std::vector<Line> &lines() const
    {
      return all_lines;
    }

    /// The line of a pivot, or null.
    const Line *line(const Dof dof) const;

    /// Whether the boundaries hold this node.
    bool hold(const NodeDoFs<dim> &node) const
    {
      return nodes.count(node[0]) > 0;
    }

    /// Take out of @p direction what these supports hold at a node.
    void make_free(const NodeDoFs<dim> &node, Tensor<1, dim> &direction) const;

    /// The normals that hold a node.
    std::vector<Tensor<1, dim>> normals(const NodeDoFs<dim> &node) const;

    /// Whether two nodes are moved along @p direction by planes of the same
    /// normal and value.
    bool hold_alike(const NodeDoFs<dim>  &a,
                    const NodeDoFs<dim>  &b,
                    const Tensor<1, dim> &direction) const;

    /// The unknowns of each boundary in direction @p component that take part.
    std::map<std::string, std::set<Dof>>
    unknowns(const unsigned int component) const;

    /// The largest prescribed displacement [mm].
    double largest(const SupportMotion<dim> &motion) const;

  private:
    struct Plane
    {
      std::string                  name;
      std::set<types::boundary_id> boundary_ids;
      Tensor<1, dim>               normal;
      double                       value; // [mm]
    };

    struct Node
    {
      NodeDoFs<dim>               dofs;
      std::set<unsigned int>      planes;
      std::vector<Tensor<1, dim>> held; // orthonormal, without coordinates
    };

    /// An equation of a node: normal . u = prescribed.
    struct Equation
    {
      Tensor<1, dim>  normal;
      Prescribed<dim> prescribed;
    };

    Tensor<1, dim> normal_of(const Mesh<dim> &mesh, const Plane &plane) const;

    std::vector<Equation>
    free_equations(const Node                           &node,
                   const std::map<Dof, Prescribed<dim>> &prescribed) const;

    static std::vector<Tensor<1, dim>>
    orthonormal(const std::vector<Equation> &equations);

    /// The unknown that each of the first equations is solved for; the others
    /// follow from these, and their left-hand sides are zero.
    static std::vector<unsigned int>
    eliminate(std::vector<Equation> &equations);

    /// Throws where equations that follow from others contradict them.
    void check(const Node                           &node,
               const unsigned int                    n_solved,
               const std::vector<Equation>          &equations,
               const std::map<Dof, Prescribed<dim>> &prescribed) const;

    std::vector<Plane>    planes;
    std::map<Dof, Node>   nodes; // by the first unknown
    std::vector<Line>     all_lines;
    std::map<Dof, size_t> line_of;
  };
} // namespace Contact

#endif
