/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_surface_transfer_h
#define contact_surface_transfer_h

#include "contact/interface/contact_interface.h"

namespace Contact
{
  using namespace dealii;

  template<int dim>
  struct SurfaceState;

  /// The part of the solution that belongs to the points, by the place on the
  /// slave: its reference arc length as a part of the whole.
  template<>
  struct SurfaceState<2>
  {
    std::vector<double>         place;
    std::vector<double>         pressure, shear, bound; // [MPa]
    std::vector<PointStatus<2>> statuses;

    /// Corners of the master, which every mesh has: force and shear [N per
    /// mm], bound [MPa].
    struct Corner
    {
      double         force, shear, bound;
      PointStatus<2> status;
    };
    std::vector<Corner> corners;
  };



  /// In 3-D by the undeformed places of the slave nodes and of the corners of
  /// the master, which every mesh has: of these with forces [N] for tractions.
  template<>
  struct SurfaceState<3>
  {
    struct OfPoint
    {
      double         pressure; // [MPa]
      Tensor<1, 3>   shear;    // [MPa]
      double         bound;    // [MPa]
      PointStatus<3> status;
      Tensor<1, 3>   slip_direction;
    };
    std::vector<Point<3>> places, corner_places;
    std::vector<OfPoint>  points, corners;
  };



  /// The states of all contact pairs, to be carried from one mesh to a finer
  /// one: of discretizations with a point per node.
  template<int dim>
  std::vector<SurfaceState<dim>>
  save_surfaces(const ContactInterface<dim> &interface,
                const GhostedVector         &solution);

  /// Set statuses and bounds of the points, and the multipliers in @p solution.
  template<int dim>
  void restore_surfaces(const std::vector<SurfaceState<dim>> &states,
                        ContactInterface<dim>                &interface,
                        GhostedVector                        &solution);
} // namespace Contact

#endif
