/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_pairing_stiffness_h
#define contact_pairing_stiffness_h

#include <deal.II/lac/full_matrix.h>

#include "bodies/discretized_bodies.h"
#include "contact/interface/contact_interface.h"

namespace Contact
{
  using namespace dealii;

  /**
   * The stiffness of the pairing of a point: under tractions that stay its
   * forces w C_a (p n + q) change, because coefficients and normal do
   * (PairingChange), and with the normal the tangents:
   *   K_ab = -w (d_C_a (p n + q) + C_a (p d_n - n (q . d_n))) / d_u_b.
   * That the point neither penetrates nor slips changes with the pairing by
   * terms of the order of the gap and of the curvature, which are left out. K
   * is unsymmetric: of use where the matrix is. It is a sum of two products,
   * and kept as such: a row for each node, where the matrix has one for each
   * unknown.
   */
  template<int dim>
  class PairingStiffness
  {
  public:
    using Dofs = std::vector<types::global_dof_index>;

    Dofs rows, columns;

    /// @p force = K @p u, by row and by column [N, mm].
    void vmult(Vector<double> &force, const Vector<double> &u) const;

    /// K [N/mm].
    FullMatrix<double> matrix() const;

    /// Add few numbers that K depends on beside the lines of contact.
    void add_signature(std::vector<double> &signature) const;

    /// Of the points in contact whose changes this rank has. They may be at
    /// nodes of others.
    static std::vector<PairingStiffness>
    terms(const ContactInterface<dim> &interface,
          const GhostedVector         &solution,
          const GhostedVector         &u_start);

    /// Those of all ranks, on the one that owns the slave node. Collective.
    static std::vector<PairingStiffness>
    at_owners(const std::vector<PairingStiffness> &terms,
              const DiscretizedBodies<dim>        &discretization);

    template<class Archive>
    void serialize(Archive &archive, const unsigned int);

  private:
    std::vector<double> coefficients; // C, by node
    Tensor<1, dim>      traction;     // p n + q [MPa]

    /// By column: -w times the change of the coefficients, by node, and below
    /// them that of the traction, by direction [mm, N/mm].
    FullMatrix<double> changes;
  };



  template<int dim>
  template<class Archive>
  void PairingStiffness<dim>::serialize(Archive &archive, const unsigned int)
  {
    archive &rows &columns &coefficients &traction;
    archive &static_cast<Table<2, double> &>(changes);
  }
} // namespace Contact

#endif
