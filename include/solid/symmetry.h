/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_symmetry_h
#define contact_symmetry_h

#include <array>

#include "solid/materials/kinematics.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The body that the mesh is, or that its plane is a section of. All have
   *  - dim: the dimension of the mesh;
   *  - components: the indices of the strains in that space, (1, 1) and so on
   *    before (1, 2) and so on;
   *  - has_hoop: whether the bodies strain across the plane;
   *  - StrainRow: what an unknown adds to these strains (E11, 2 E12, ... and,
   *    with a hoop, E33 at last), and the trace of that;
   *  - energy_density(material, s): s : D^-1 : s [MPa], twice the energy of a
   *    stress s by volume.
   *
   * In plane strain nothing strains across the plane; integrals are per mm of
   * thickness.
   */
  struct PlaneStrain
  {
    static constexpr int  dim      = 2;
    static constexpr bool has_hoop = false;

    static constexpr std::array<std::array<unsigned int, 2>, 3> components = {
      {{{0, 0}}, {{1, 1}}, {{0, 1}}}};

    using StrainRow = std::array<double, 3>;

    static double trace(const StrainRow &row)
    {
      return row[0] + row[1];
    }

    /// By the stress in 2-D alone, which determines that across it.
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
    static constexpr int  dim      = 2;
    static constexpr bool has_hoop = true;

    static constexpr std::array<std::array<unsigned int, 2>, 3> components =
      PlaneStrain::components;

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



  /// A body in 3-D: nothing is left out.
  struct Space
  {
    static constexpr int  dim      = 3;
    static constexpr bool has_hoop = false;

    static constexpr std::array<std::array<unsigned int, 2>, 6> components = {
      {{{0, 0}}, {{1, 1}}, {{2, 2}}, {{0, 1}}, {{0, 2}}, {{1, 2}}}};

    using StrainRow = std::array<double, 6>;

    static double trace(const StrainRow &row)
    {
      return row[0] + row[1] + row[2];
    }

    static double energy_density(const Material              &material,
                                 const SymmetricTensor<2, 3> &stress)
    {
      return material.energy_density(stress);
    }
  };
} // namespace Contact

#endif
