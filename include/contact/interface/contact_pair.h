/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_pair_h
#define contact_contact_pair_h

#include <deal.II/base/array_view.h>

#include <functional>
#include <optional>

#include "contact/obstacles/free_motion.h"
#include "contact/obstacles/obstacle.h"
#include "contact/points/contact_points.h"
#include "contact/surfaces/body_overlap.h"

namespace Contact
{
  using namespace dealii;

  template<int dim>
  class MortarDiscretization;



  /**
   * Two surfaces that may touch, and what all points between them have in
   * common: the discretization by which they are made and paired, and the law
   * of friction. The master is a surface of a body, or a rigid obstacle.
   *
   * The slave is cut into smooth sides, but for glue, which holds all
   * directions whatever the normal. The points are those of the discretization,
   * and behind them what it cannot see: with the mortar discretization at
   * degree 2 a nodal point for a node on an axis of symmetry, which has no dual
   * function; with the discretizations mortar and nodal the corners of the
   * master (corner_points.h).
   *
   * On an obstacle the nodal and mortar discretizations are one: of a gap that
   * is linear along the edge, which it is over a half plane, the dual functions
   * leave the value at the node.
   */
  template<int dim>
  class ContactPair
  {
  public:
    /// Throws InputError if the surfaces do not exist or have a common node.
    ContactPair(const DiscretizedBodies<dim> &discretization,
                const BodyStiffness          &elasticity,
                const Parameters::Contact    &parameters);
    ~ContactPair();

    const DiscretizedBodies<dim> &discretization;

    /// The section of the parameters is "Contact" or "Contact NAME".
    const std::string name;

    /// The surfaces are glued wherever they face each other undeformed: every
    /// such point sticks, and its gap is the change of the distance.
    const bool        tied;
    const FrictionLaw law;

    const Surface<dim>                   slave;
    const std::optional<Surface<dim>>    master;   // none: an obstacle
    const std::unique_ptr<Obstacle<dim>> obstacle; // none: a surface

    /// By how much the surfaces overlap otherwise than those of the mesh [mm].
    struct Interference
    {
      std::function<double(const Point<1> &)>
             at;      // by the load factor, if given
      double now = 0; // what it is of that

      /// The depth by which the surfaces of the mesh overlap, and the part of
      /// it by which they are kept apart: see
      /// ContactInterface::ramp_initial_penetration().
      double at_start = 0, initial_clearance = 0;

      double added() const
      {
        return now - initial_clearance;
      }
    };
    const std::unique_ptr<Interference> interference;

    /// Of a surface that is slave and master alike.
    std::optional<SelfContact<dim>> itself;

    /// Motions that follow from forces, and the number of the first one among
    /// those of all contact pairs.
    std::vector<std::unique_ptr<FreeMotion>> free_motions;
    unsigned int                             first_motion = 0;

    /// The c of all points, by the stiffness E/h of their slave edges [-].
    const double augmentation_parameter;

    /// Numbered among those of all contact pairs.
    MultiplierSpace multipliers;

    /// By nodes of the slave, the sides that meet there besides the one that
    /// the node is on: surfaces, and their nodes there.
    std::map<unsigned int,
             std::vector<std::pair<const Surface<dim> *, unsigned int>>>
      other_sides;

    /// The surfaces of all contact pairs on the bodies of slave and master.
    typename BodyOverlap<dim>::Surfaces surfaces_of_bodies;

    /// The whole boundaries of the bodies of slave and master; none of those
    /// that are one.
    std::array<std::shared_ptr<const Surface<dim>>, 2> boundaries;

    /// Their place among the points of all contact pairs.
    unsigned int first_point = 0, n_points = 0;

    /// The points, not paired yet, and their multipliers, behind those that
    /// there are already.
    std::vector<ContactPoint<dim>>
    make_points(const unsigned int first_multiplier,
                const unsigned int first_point);

    /// Pair the points of this contact pair in the configuration @p u. Returns
    /// whether one has other unknowns than before.
    bool pair(const ArrayView<ContactPoint<dim>> &points,
              const GhostedVector                &u,
              const PairingMode                  &mode) const;

    /// An increment begins where the points have been paired last: what a
    /// discretization has chosen there, it keeps.
    void begin_increment() const;

    /// The same by the closest points of the master, wherever on the slave the
    /// points lie.
    bool project(const ArrayView<ContactPoint<dim>> &points,
                 const GhostedVector                &u,
                 const PairingMode                  &mode = {}) const;

    /// The change of a pairing, for points in contact, if the mode asks for it.
    void differentiate(ContactPoint<dim>   &point,
                       const GhostedVector &u,
                       const PairingMode   &mode) const;

    /// The own points among all, those of the slave, and behind them the
    /// corners of the master.
    template<typename Points>
    auto points_among(Points &all_points) const
    {
      const auto first = all_points.data() + first_point;
      return make_array_view(first, first + n_points);
    }
    template<typename Points>
    auto points_of_slave(Points &all_points) const
    {
      const auto first = all_points.data() + first_point;
      return make_array_view(first, first + n_of_slave);
    }
    template<typename Points>
    auto corners_of_master(Points &all_points) const
    {
      const auto first = all_points.data() + first_point;
      return make_array_view(first + n_of_slave, first + n_points);
    }

    /// The surface that a point belongs to: but for corners of the master, the
    /// slave.
    const Surface<dim> &surface_of(const ContactPoint<dim> &point) const;

    /// The surface of the other body; none of an obstacle.
    const Surface<dim> *surface_opposite(const ContactPoint<dim> &point) const;

    /// The undeformed length of the edge that a point belongs to [mm].
    double edge_length(const ContactPoint<dim> &point) const;

    /// The stiffness E/h at a point [MPa/mm]: the softer body, the edge that
    /// the point belongs to.
    double stiffness(const ContactPoint<dim> &point) const;

    /**
     * The place of the slave, deformed, that faces a node or a place of a facet
     * of the master; off the end if there is none. It is the closest one; of a
     * surface in contact with itself, where that is the place itself, the
     * closest of those that face it.
     */
    Projection<dim>
    facing_slave(const DeformedSurface<dim>      &slave_now,
                 const Point<dim>                &x,
                 const NormalCone<dim>           &normals,
                 const std::vector<unsigned int> &master_facets) const;

    /// Whether there are points at corners of the master.
    bool has_corner_points() const
    {
      return n_of_slave < n_points;
    }

    /// Whether the mortar discretization is asked for.
    bool is_mortar() const
    {
      return parameters.discretization ==
             Parameters::ContactDiscretization::mortar;
    }

    /// Each multiplier belongs to one point: nodal and mortar discretizations.
    bool has_point_per_multiplier() const;

    /**
     * The normal multipliers that make the pressure at a node of the slave, and
     * their factors; none if there is no pressure there. On an axis of symmetry
     * at degree 2 no pressure at the node itself does work on the shape
     * functions: there it is that of the neighbors, continued.
     */
    std::vector<std::pair<unsigned int, double>>
    pressure_at(const unsigned int node) const;

    /// The section of the parameters.
    std::string section() const
    {
      return parameters.section();
    }

    /// The mean place of the undeformed facets around a point [mm], which tells
    /// points of one node by their sides.
    Point<dim> place_of_facets(const ContactPoint<dim> &point) const;

    /// The undeformed place of a point [mm].
    Point<dim> place(const ContactPoint<dim> &point) const
    {
      return surface_of(point).reference_place(point.slave_facet,
                                               point.slave_xi);
    }

  private:
    NormalCone<dim> directions(const ContactPoint<dim>    &point,
                               const DeformedSurface<dim> &now,
                               const GhostedVector        &u) const;
    void leave_to_other_sides(const ArrayView<ContactPoint<dim>> &points,
                              const GhostedVector                &u) const;
    void exclude(const std::string &group, const std::string &entry);
    bool can_have_corner_points() const;
    std::vector<ContactPoint<dim>> make_discretization_points();
    void make_axis_points(std::vector<ContactPoint<dim>> &points);
    bool pair_all(const ArrayView<ContactPoint<dim>> &points,
                  const GhostedVector                &u,
                  const PairingMode                  &mode) const;
    bool pair_corners(const ArrayView<ContactPoint<dim>> &corners,
                      const GhostedVector                &u,
                      const PairingMode                  &mode) const;

    const BodyStiffness      &elasticity;
    const Parameters::Contact parameters;
    std::set<unsigned int>    excluded; // nodes of the slave
    std::set<unsigned int>    on_axis;  // without a dual function
    std::unique_ptr<MortarDiscretization<dim>> mortar;

    /// Of the points those of the discretization, those with the ones on an
    /// axis, and all that belong to the slave.
    unsigned int n_of_discretization = 0, n_of_slave = 0;
    unsigned int first_multiplier = 0;
  };

  template<>
  void ContactPair<2>::differentiate(ContactPoint<2>     &point,
                                     const GhostedVector &u,
                                     const PairingMode   &mode) const;
  template<>
  void ContactPair<3>::differentiate(ContactPoint<3>     &point,
                                     const GhostedVector &u,
                                     const PairingMode   &mode) const;
} // namespace Contact

#endif
