/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_contact_depth_h
#define contact_contact_depth_h

#include "contact/interface/contact_pair.h"

namespace Contact
{
  using namespace dealii;

  /// The depth of a place of one surface inside of the other one, or of the
  /// slave inside of an obstacle.
  template<int dim>
  struct ContactDepth
  {
    double         depth     = 0; // [mm]
    bool           of_master = false;
    Point<dim>     X;               // the undeformed place [mm]
    unsigned int   slave_facet = 0; // that it is in, or belongs to
    Tensor<1, dim> normal;          // the shortest way out

    template<class Archive>
    void serialize(Archive &archive, const unsigned int)
    {
      archive &depth &of_master &X &slave_facet &normal;
    }
  };

  /// By how much each facet may be beside the curve that it stands for [mm]: a
  /// bound, twice the sagitta, by the angles between the facets that meet
  /// smoothly at its nodes, as drawn. Corners and ends stand for themselves.
  template<int dim>
  std::vector<double> sagittas(const DeformedSurface<dim> &drawn);

  /// The part of a depth that counts: all of it as drawn, that beyond what
  /// facets are beside their curves, or of this no more than bodies have moved.
  enum class DepthOf
  {
    mesh,
    curves,
    motion
  };

  /**
   * The deepest place of both surfaces of a contact pair under the displacement
   * @p u: nodes, places between them, and those where edges of both cross, as
   * far as they are behind the closest place of the whole boundary of the other
   * body, less what the facets of
   * both, by the angles between them, may be beside a curve. Of two surfaces of
   * one connected body, behind the other surface. On an obstacle the deepest of
   * some places of the slave, of its nodes only with the Gauss-point
   * discretization, which has no points there; an edge of the length h, if that
   * is no more than the radius R of a circle, may be inside of the circle by
   * h^2/(8 R), of which its two nodes know nothing. All this is allowed to
   * polygons unless the depth is that of the mesh.
   *
   * All contact discretizations let surfaces pass through each other between
   * the places where they look, which vanishes with the mesh size. On a mesh
   * that is too coarse for the scene, a corner of the master may be in a slave
   * edge as deep as it was pushed.
   */
  template<int dim>
  ContactDepth<dim> largest_depth(const ContactPair<dim> &contact_pair,
                                  const GhostedVector    &u,
                                  const DepthOf           kind);
} // namespace Contact

#endif
