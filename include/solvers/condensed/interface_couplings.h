/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_interface_couplings_h
#define contact_interface_couplings_h

#include "solid/discretization.h"
#include "solvers/condensed/contact_elimination.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The unknowns that an eliminated unknown may be expressed by: its partners,
   * for which the pattern of the condensed matrix has to provide.
   *
   * They begin with the nodes that the points of an unknown see, or that change
   * the pairing of these, and on the master those of one more edge to either
   * side: the bodies may slide a little
   * before a new pattern is due. Points that see slave nodes of each other are
   * eliminated into chains, whose length depends on the active set: what such
   * lines need beyond is added as it shows. Provided for in advance, a slave
   * of n nodes would fill n^2 entries that hardly ever are needed.
   *
   * All ranks have the same points and the same lines, and so the same partners
   * without a message.
   */
  template<int dim>
  class InterfaceCouplings
  {
  public:
    using Dofs = std::vector<types::global_dof_index>;

    /// @p interface may be null: nothing is coupled.
    InterfaceCouplings(const Discretization<dim>   &discretization,
                       const ContactInterface<dim> *interface);

    /// Take the partners from the points of now.
    void make();

    /// Whether they serve the points of now.
    bool serve() const;

    /// Add what the lines of @p elimination need. Returns whether anything was
    /// missing.
    bool add_missing(const ContactElimination<dim> &elimination);

    /// Add to @p coupled the partners of an unknown, if it has any, and those
    /// of the unknowns that it hangs on, with these.
    void add_partners(const types::global_dof_index      dof,
                      std::set<types::global_dof_index> &coupled) const;

    /// Add the couplings of the facets of the slaves around unknowns of this
    /// rank: a point's stiffness has those of cells of other ranks.
    void add_facets(DynamicSparsityPattern &pattern) const;

    /// Add the couplings of points of this rank whose pairing has a stiffness.
    void add_points(DynamicSparsityPattern &pattern) const;

    /// All unknowns of the points with all their partners, in ascending order.
    Dofs all() const;

  private:
    void collect_neighbors(const Surface<dim> &surface);
    Dofs reachable(const ContactPoint<dim> &point) const;

    /// Whether the tangent may have the stiffness of the pairing.
    bool changes_are_in_tangent() const;

    const Discretization<dim>   &discretization;
    const ContactInterface<dim> *interface;

    /// Whether the last pattern has room for that stiffness.
    bool has_room_for_changes = false;

    /// Of each point, the unknowns that it may see.
    std::vector<Dofs> provided;

    /// In ascending order.
    std::map<types::global_dof_index, Dofs> partners;

    /// Of the nodes where projections may be, by their first unknown: those of
    /// the edges around them, in ascending order.
    std::map<types::global_dof_index, Dofs> neighbors;
  };
} // namespace Contact

#endif
