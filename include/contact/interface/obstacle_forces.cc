/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "contact/interface/obstacle_forces.h"

#include <algorithm>

#include "base/dimension.h"
#include "base/errors.h"

namespace Contact
{
  using Parameters::Choice;
  using Parameters::Quantity;

  template<int dim>
  std::array<ObstacleForce<dim>, 2>
  obstacle_forces(const ContactInterface<dim> &interface,
                  const ContactPair<dim>      &contact_pair,
                  const GhostedVector         &solution,
                  const GhostedVector         &u_start)
  {
    // Displacements that the pairing does not know move no force.
    const GhostedVector  undeformed(solution.size());
    const GhostedVector &configuration =
      interface.is_paired_undeformed() ? undeformed : solution;
    std::array<ObstacleForce<dim>, 2> forces;
    for (const ContactPoint<dim> &point : interface.acting_points(contact_pair))
      {
        const ContactState<dim> now = interface.state(point, solution, u_start);
        const Traction<dim>     t   = interface.active_set.traction(point, now);
        const Tensor<1, dim>    arm =
          point.projection - contact_pair.obstacle->centre();
        const Tensor<1, dim> gap =
          slave_position(point, configuration) - point.projection;
        forces[0].add(arm, gap, point.weight * t.p * point.normal);
        forces[1].add(arm, gap, point.weight * point.along_tangents(t.q));
      }
    return forces;
  }



  template<int dim>
  std::map<std::string, double>
  obstacle_values(const ContactInterface<dim> &interface,
                  const ContactPair<dim>      &contact_pair,
                  const GhostedVector         &solution,
                  const GhostedVector         &u_start)
  {
    if (!contact_pair.obstacle)
      {
        const unsigned int k = contact_pair.first_motion;
        return {{"preload",
                 interface.motions.forces(solution,
                                          u_start,
                                          /*of_multipliers=*/false)[k]},
                {"shortening", interface.motions.values(solution)[k]}};
      }
    const auto parts =
      obstacle_forces(interface, contact_pair, solution, u_start);
    const Tensor<1, dim> force = parts[0].force + parts[1].force;
    const Moment<dim>    moment =
      parts[0].moment + parts[1].moment + parts[0].over_gap + parts[1].over_gap;
    std::map<std::string, double> values;
    const auto                    travel = contact_pair.obstacle->travel();
    if (interface.discretization.axisymmetric)
      {
        values["obstacle_force_y"] = force[1];
        if (travel)
          values["obstacle_motion_y"] = travel->shift[1];
        return values;
      }
    if (travel)
      {
        for (unsigned int i = 0; i < dim; ++i)
          values[std::string("obstacle_motion_") + "xyz"[i]] = travel->shift[i];
        values["obstacle_turn"] = travel->angle;
      }
    for (unsigned int i = 0; i < dim; ++i)
      values[std::string("obstacle_force_") + "xyz"[i]] = force[i];
    for (unsigned int i = 0; i < Moment<dim>::dimension; ++i)
      values[std::string("obstacle_moment_") +
             "xyz"[Dimension<dim>::first_axis + i]] = moment[i];
    return values;
  }



  namespace
  {
    std::string key_of(const Quantity quantity)
    {
      std::string key = Choice<Quantity>(quantity).name();
      std::replace(key.begin(), key.end(), ' ', '_');
      return key;
    }



    /// Whether a contact pair has what exerts this: an obstacle (that moves) or
    /// a cut.
    template<int dim>
    bool has(const ContactPair<dim> &contact_pair, const Quantity quantity)
    {
      const bool is_way = quantity == Quantity::obstacle_turn ||
                          key_of(quantity).find("motion") != std::string::npos;
      return is_of_cut(quantity)
               ? contact_pair.tied && !contact_pair.free_motions.empty()
               : contact_pair.obstacle &&
                   (!is_way || contact_pair.obstacle->travel());
    }



    /// The contact pair of a section that has it, or nothing.
    template<int dim>
    const ContactPair<dim> *pair_of(const std::string           &section,
                                    const Quantity               quantity,
                                    const ContactInterface<dim> *interface)
    {
      if (interface != nullptr)
        for (const auto &contact_pair : interface->pairs)
          if (contact_pair->section() == section &&
              has(*contact_pair, quantity))
            return contact_pair.get();
      return nullptr;
    }



    /// The sections of all contact pairs that have it: "; here: 'Contact'".
    template<int dim>
    std::string list_of_sections(const Quantity               quantity,
                                 const ContactInterface<dim> *interface)
    {
      std::string list;
      if (interface != nullptr)
        for (const auto &contact_pair : interface->pairs)
          if (has(*contact_pair, quantity))
            list += (list.empty() ? "; here: '" : ", '") +
                    contact_pair->section() + "'";
      return list.empty() ? "; here there is none" : list;
    }
  } // namespace



  template<int dim>
  double obstacle_value(const Quantity               quantity,
                        const std::string           &section,
                        const ContactInterface<dim> *interface,
                        const GhostedVector         &solution,
                        const GhostedVector         &u_start)
  {
    return obstacle_values(*interface,
                           *pair_of(section, quantity, interface),
                           solution,
                           u_start)
      .at(key_of(quantity));
  }



  template<int dim>
  void check_obstacle(const std::string           &probe,
                      const Quantity               quantity,
                      const std::string           &section,
                      const ContactInterface<dim> *interface)
  {
    const bool of_rings =
      interface != nullptr && interface->discretization.axisymmetric &&
      !is_of_cut(quantity) && quantity != Quantity::obstacle_force_y &&
      quantity != Quantity::obstacle_motion_y;
    if (of_rings || pair_of(section, quantity, interface) == nullptr)
      throw InputError("there is no " + Choice<Quantity>(quantity).name() +
                         " of '" + section + "'",
                       "Probes/Probes, '" + probe + "'",
                       of_rings ? "of rings there are 'obstacle force y' and "
                                  "'obstacle motion y'"
                       : is_of_cut(quantity)
                         ? "name the section of a contact pair with a preload" +
                             list_of_sections(quantity, interface)
                         : "name the section of a contact pair with an "
                           "obstacle (that moves), 'Contact' or 'Contact "
                           "NAME'" +
                             list_of_sections(quantity, interface));
  }

#define INSTANTIATE(dim)                                        \
  template std::array<ObstacleForce<dim>, 2> obstacle_forces(   \
    const ContactInterface<dim> &,                              \
    const ContactPair<dim> &,                                   \
    const GhostedVector &,                                      \
    const GhostedVector &);                                     \
  template std::map<std::string, double> obstacle_values(       \
    const ContactInterface<dim> &,                              \
    const ContactPair<dim> &,                                   \
    const GhostedVector &,                                      \
    const GhostedVector &);                                     \
  template double obstacle_value(const Quantity,                \
                                 const std::string &,           \
                                 const ContactInterface<dim> *, \
                                 const GhostedVector &,         \
                                 const GhostedVector &);        \
  template void   check_obstacle(const std::string &,           \
                                 const Quantity,                \
                                 const std::string &,           \
                                 const ContactInterface<dim> *);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace Contact
