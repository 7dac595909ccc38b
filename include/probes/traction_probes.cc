/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "probes/traction_probes.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/errors.h"
#include "contact/results/contact_results.h"

namespace Contact
{
  using Parameters::Choice;
  using Parameters::Quantity;

  bool is_contact_traction(const Quantity quantity)
  {
    return quantity == Quantity::pressure ||
           quantity == Quantity::true_pressure || quantity == Quantity::shear;
  }



  namespace
  {
    /// A place on the slave of a contact pair: nodes with a pressure, and
    /// their weights.
    template<int dim>
    struct PlaceOnSlave
    {
      const ContactPair<dim>                      *contact_pair;
      std::vector<std::pair<unsigned int, double>> nodes;
    };



    /// The node of a surface, or of a facet of it, that has this unknown, or
    /// none.
    template<int dim>
    unsigned int node_with(const Surface<dim>           &surface,
                           const types::global_dof_index dof)
    {
      for (unsigned int n = 0; n < surface.nodes.size(); ++n)
        if (surface.nodes[n].dofs[0] == dof)
          return n;
      return numbers::invalid_unsigned_int;
    }

    template<int dim>
    unsigned int node_with(const Surface<dim>           &surface,
                           const unsigned int            facet,
                           const types::global_dof_index dof)
    {
      for (unsigned int a = 0; a < surface.facets[facet].n_nodes(); ++a)
        if (const unsigned int n = surface.facets[facet].nodes[a];
            surface.nodes[n].dofs[0] == dof)
          return n;
      return numbers::invalid_unsigned_int;
    }



    /// The nodes of a place that is at the end of a side of the slave, on the
    /// side with the largest pressure in a solution, if there is one.
    template<int dim>
    void choose_side(const Place<dim>            &place,
                     const ContactInterface<dim> &interface,
                     const GhostedVector         &solution,
                     PlaceOnSlave<dim>           &here)
    {
      const Surface<dim> &slave = here.contact_pair->slave;
      double              most  = -std::numeric_limits<double>::max();
      for (unsigned int e = 0; e < slave.facets.size(); ++e)
        {
          std::vector<std::pair<unsigned int, double>> nodes;
          double                                       pressure = 0;
          for (const auto &[dof, weight] : place.unknowns[0])
            if (const unsigned int n = node_with(slave, e, dof);
                n != numbers::invalid_unsigned_int)
              {
                nodes.emplace_back(n, weight);
                pressure +=
                  weight *
                  pressure_at(interface, *here.contact_pair, n, solution);
              }
          if (nodes.size() == here.nodes.size() && pressure > most)
            {
              here.nodes = nodes;
              most       = pressure;
            }
        }
    }



    /// The place on all slaves that have it, at most one of each contact pair.
    template<int dim>
    std::vector<PlaceOnSlave<dim>>
    on_slaves(const Place<dim> &place, const ContactInterface<dim> *interface)
    {
      std::vector<PlaceOnSlave<dim>> found;
      if (interface == nullptr)
        return found;
      for (const auto &contact_pair : interface->pairs)
        {
          PlaceOnSlave<dim> here{contact_pair.get(), {}};
          for (const auto &[dof, weight] : place.unknowns[0])
            {
              const auto &nodes = contact_pair->slave.nodes;
              const auto  found =
                std::find_if(nodes.begin(), nodes.end(), [&](const auto &node) {
                  return node.dofs[0] == dof &&
                         !contact_pair->pressure_at(&node - &nodes[0]).empty();
                });
              if (found != nodes.end())
                here.nodes.emplace_back(found - nodes.begin(), weight);
            }
          if (here.nodes.size() == place.unknowns[0].size())
            found.push_back(here);
        }
      return found;
    }



    template<int dim>
    bool is_on(const Surface<dim> &surface, const Place<dim> &place)
    {
      return std::all_of(place.unknowns[0].begin(),
                         place.unknowns[0].end(),
                         [&](const auto &term) {
                           return node_with(surface, term.first) !=
                                  numbers::invalid_unsigned_int;
                         });
    }



    /// Why no multiplier is at a place.
    template<int dim>
    std::string why_no_multiplier(const Place<dim>            &place,
                                  const ContactInterface<dim> *interface)
    {
      if (interface == nullptr)
        return "the scene has no contact";
      for (const auto &contact_pair : interface->pairs)
        {
          const std::string name =
            contact_pair->name.empty()
              ? ""
              : " of the contact pair '" + contact_pair->name + "'";
          if (is_on(contact_pair->slave, place))
            return "it is on the slave" + name + ", but no point of contact is";
          if (contact_pair->master && is_on(*contact_pair->master, place))
            return "it is on the master" + name +
                   ", and the tractions are those of the slave";
        }
      return "it is on no slave";
    }



    /// A place that check_contact_traction() has found on a first mesh.
    template<int dim>
    PlaceOnSlave<dim> on_slave(const Place<dim>            &place,
                               const ContactInterface<dim> *interface,
                               const GhostedVector         &solution)
    {
      const auto found = on_slaves(place, interface);
      if (found.empty())
        throw InputError(
          "a place of a probe is on a side of the slave on the first mesh, and "
          "beside it on a refined one: " +
            why_no_multiplier(place, interface),
          "Probes/Probes, pressure or shear",
          "give a place on the round side itself, or on a flat one");
      PlaceOnSlave<dim> here = found.front();
      choose_side(place, *interface, solution, here);
      return here;
    }
  } // namespace



  template<int dim>
  void check_contact_traction(const std::string           &probe,
                              const Quantity               quantity,
                              const std::string           &point,
                              const ContactInterface<dim> *interface,
                              const Discretization<dim>   &discretization)
  {
    const Place<dim> &place = discretization.place(point, "Probes/Probes");
    if (dim == 3 && quantity == Quantity::shear && place.is_between_nodes())
      throw InputError("the point '" + point +
                         "' lies between nodes, whose shears have directions "
                         "of their own",
                       "Probes/Probes, '" + probe + "'",
                       "name a node; 'Output/Profile' has the vectors");
    const auto found = on_slaves(place, interface);
    if (found.empty())
      throw InputError("there is no " + Choice<Quantity>(quantity).name() +
                         " of contact at the point '" + point +
                         "': " + why_no_multiplier(place, interface),
                       "Probes/Probes, '" + probe + "'",
                       "name a point group on a slave, or a stress");
    if (found[0].contact_pair->itself)
      throw InputError("the point '" + point +
                         "' is on a surface in contact with itself, where one "
                         "of two sides has the tractions, the program's choice",
                       "Probes/Probes, '" + probe + "'",
                       "name two groups as slave and master, or a stress");
    if (found.size() > 1)
      throw InputError("the point '" + point + "' has a " +
                         Choice<Quantity>(quantity).name() +
                         " of contact in two contact pairs, '" +
                         found[0].contact_pair->name + "' and '" +
                         found[1].contact_pair->name + "'",
                       "Probes/Probes, '" + probe + "'",
                       "name a point of one contact pair only, or a stress; "
                       "'Output/Profile' has both");
  }



  namespace
  {
    /// The shear at a node of the slave without the force of a corner; in 3-D
    /// its magnitude.
    template<int dim>
    double shear_of_node(const ContactInterface<dim> &interface,
                         const ContactPair<dim>      &contact_pair,
                         const unsigned int           n,
                         const GhostedVector         &solution)
    {
      const unsigned int k = multiplier_at(interface, contact_pair, n);
      if (contact_pair.law.is_frictionless() ||
          k == numbers::invalid_unsigned_int)
        return 0;
      if (dim == 2)
        return solution[interface.tangential_index(k)];
      Tensor<1, dim - 1> shear;
      for (unsigned int t = 0; t < dim - 1; ++t)
        shear[t] = solution[interface.tangential_index(k, t)];
      return shear.norm();
    }
  } // namespace



  template<int dim>
  double contact_traction(const Quantity               quantity,
                          const Place<dim>            &place,
                          const ContactInterface<dim> *interface,
                          const GhostedVector         &solution)
  {
    if (interface == nullptr)
      return 0;
    const auto              found        = on_slave(place, interface, solution);
    const ContactPair<dim> &contact_pair = *found.contact_pair;
    const bool              is_normal    = quantity != Quantity::shear;
    const auto              of_corners =
      corner_tractions(*interface, contact_pair, solution);
    const auto stretches = quantity == Quantity::true_pressure
                             ? contact_pair.slave.stretches(solution)
                             : std::vector<double>();
    double     sum       = 0;
    for (const auto &[n, weight] : found.nodes)
      {
        const double of_multiplier =
          is_normal ? pressure_at(*interface, contact_pair, n, solution)
                    : shear_of_node(*interface, contact_pair, n, solution);
        const double of_corner =
          of_corners.empty() ? 0. : of_corners[n][is_normal ? 0 : 1];
        sum += weight * (of_multiplier + of_corner) /
               (stretches.empty() ? 1. : stretches[n]);
      }
    return sum;
  }



  template<int dim>
  void add_traction_derivative(const Quantity               quantity,
                               const Place<dim>            &place,
                               const double                 factor,
                               const ContactInterface<dim> &interface,
                               const GhostedVector         &solution,
                               GhostedVector               &derivative)
  {
    const auto [contact_pair, nodes] = on_slave(place, &interface, solution);
    for (const auto &[n, weight] : nodes)
      {
        const unsigned int k = multiplier_at(interface, *contact_pair, n);
        if (quantity != Quantity::pressure)
          {
            if (!contact_pair->law.is_frictionless() &&
                k != numbers::invalid_unsigned_int)
              derivative[interface.tangential_index(k)] += factor * weight;
          }
        else
          for (const auto &[m, part] : contact_pair->pressure_at(n))
            derivative[interface.normal_index(
              interface.acting_multiplier(m))] += factor * weight * part;
      }
  }

  template void   check_contact_traction(const std::string &,
                                         const Parameters::Quantity,
                                         const std::string &,
                                         const ContactInterface<2> *,
                                         const Discretization<2> &);
  template void   check_contact_traction(const std::string &,
                                         const Parameters::Quantity,
                                         const std::string &,
                                         const ContactInterface<3> *,
                                         const Discretization<3> &);
  template double contact_traction(const Parameters::Quantity,
                                   const Place<2> &,
                                   const ContactInterface<2> *,
                                   const GhostedVector &);
  template double contact_traction(const Parameters::Quantity,
                                   const Place<3> &,
                                   const ContactInterface<3> *,
                                   const GhostedVector &);
  template void   add_traction_derivative(const Parameters::Quantity,
                                          const Place<2> &,
                                          const double,
                                          const ContactInterface<2> &,
                                          const GhostedVector &,
                                          GhostedVector &);
  template void   add_traction_derivative(const Parameters::Quantity,
                                          const Place<3> &,
                                          const double,
                                          const ContactInterface<3> &,
                                          const GhostedVector &,
                                          GhostedVector &);
} // namespace Contact
