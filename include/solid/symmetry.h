/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_symmetry_h
#define contact_symmetry_h

#include <array>

#include "solid/kinematics.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The body that the plane of the mesh is a section of. Both symmetries have
   *  - has_hoop: whether the bodies strain across the plane;
   *  - StrainRow: what an unknown adds to the strains (E11, E22, 2 E12 and,
   *    with a hoop, E33), and the trace of that;
   *  - energy_density(material, s): s : D^-1 : s [MPa], twice the energy of a
   *    stress s by volume.
   *
   * In plane strain nothing strains across the plane; integrals are per mm of
   * thickness.
   */
  struct PlaneStrain
  {
    static constexpr bool has_hoop = false;

    using StrainRow = std::array<double, 3>;

    static double trace(const StrainRow &row)
    {
      return row[0] + row[1];
    }

    /// By the stress in the plane alone, which determines that across it.
    static double energy_density(const Material              &material,
                                 const SymmetricTensor<2, 3> &stress)
    {
      return material.energy_density(in_plane(stress));
    }
  };



  /**
   * A body of revolution without torsion: x is the radius, y the axis, and the
   * third direction is that of the hoops. With h = u_x/X a hoop stretches by
   * 1 + h; of the unknowns in x, N_a/X takes the place of a gradient. Integrals
   * are over whole rings.
   */
  struct Axisymmetric
  {
    static constexpr bool has_hoop = true;

    using StrainRow = std::array<double, 4>;

    static double trace(const StrainRow &row)
    {
      return row[0] + row[1] + row[3];
    }

    static double energy_density(const Material              &material,
                                 const SymmetricTensor<2, 3> &stress)
    {
      return material.energy_density(stress);
    }
  };
} // namespace Contact

#endif
