/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_place_search_h
#define contact_place_search_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/hp/mapping_collection.h>
#include <deal.II/lac/affine_constraints.h>

#include <string>
#include <utility>
#include <vector>

#include "mesh/mesh.h"
#include "solid/place.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The cells that hold the named places between nodes, on the present mesh.
   *
   * A place may lie off the mesh by the digits that it is typed with, and
   * before a round boundary by what the side of the cell there is off its
   * curve; then it is the closest point of the mesh. One that is as close to a
   * boundary as these digits, or to the curve behind it, is on it. Where two
   * bodies hold it, as on an interface of contact, it could be either's, and is
   * refused.
   */
  template<int dim>
  class PlaceSearch
  {
  public:
    PlaceSearch(const Mesh<dim>                  &mesh,
                const hp::MappingCollection<dim> &mapping,
                const DoFHandler<dim>            &dof_handler,
                const MPI_Comm                    communicator);

    /// The place of this name. Throws InputError, on all ranks, if no body or
    /// more than one is there. Collective.
    Place<dim> find(const std::string &name) const;

  private:
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    /// A cell that may hold a place, with the closest point in it.
    struct Candidate
    {
      double     distance  = 0; // of the point from the place [mm]
      double     allowed   = 0; // farther away the place is outside [mm]
      double     round_off = 0; // of the distance [mm]
      double     close     = 0; // more is another cell's [mm]
      CellId     cell;
      Place<dim> place;

      template<class Archive>
      void serialize(Archive &archive, const unsigned int)
      {
        archive &distance &allowed &round_off &close &cell &place;
      }
    };

    std::vector<Candidate> candidates(const NamedPlace<dim> &named) const;
    bool                   closest_point(const Cell       &cell,
                                         const Point<dim> &X,
                                         Point<dim>       &xi,
                                         double           &distance) const;
    void                   move_to_boundary(const Cell       &cell,
                                            const Point<dim> &X,
                                            const double      close,
                                            Point<dim>       &xi) const;
    Tensor<1, dim>         way_to_curve(const Cell        &cell,
                                        const unsigned int f,
                                        const Point<dim>  &xi) const;
    double distance_from_curve(const Cell &cell, const Point<dim> &xi) const;
    Place<dim> place_in(const Cell &cell, const Point<dim> &xi) const;

    const Mesh<dim>                  &mesh;
    const hp::MappingCollection<dim> &mapping;
    const DoFHandler<dim>            &dof_handler;
    const MPI_Comm                    communicator;
    AffineConstraints<double>         hanging;
  };
} // namespace Contact

#endif
