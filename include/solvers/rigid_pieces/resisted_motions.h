/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_resisted_motions_h
#define contact_resisted_motions_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "solvers/rigid_pieces/rigid_body_modes.h"

namespace Contact
{
  using namespace dealii;

  /// A part of a displacement: @p factor times that of a piece at X.
  template<int dim>
  struct Share
  {
    unsigned int piece;
    Point<dim>   X;
    double       factor;
  };



  /// The resisted directions, in terms of the rigid motions of all pieces:
  /// displacements, and rotations about the centre times the size.
  template<int dim>
  class ResistedMotions
  {
  public:
    static constexpr unsigned int n_motions = dim * (dim + 1) / 2;

    ResistedMotions(const MeshPieces<dim> &pieces,
                    const Rotations<dim>  &rotations)
      : pieces(pieces)
      , rotations(rotations)
      , squares(n_motions * pieces.size(), n_motions * pieces.size())
    {
    }

    /// The sum of the shares is resisted along @p direction.
    void resist(const std::vector<Share<dim>> &shares,
                const Tensor<1, dim>          &direction)
    {
      std::map<unsigned int, double> row;
      for (const auto &[piece, X, factor] : shares)
        {
          const auto    &box  = pieces[piece].box;
          const auto    &ends = box.get_boundary_points();
          Tensor<1, dim> arm =
            (X - box.center()) / (0.5 * ends.first.distance(ends.second));
          if (const auto turned = rotations.find(pieces[piece].body);
              turned != rotations.end())
            arm = turned->second * arm;
          for (unsigned int m = 0; m < n_motions; ++m)
            row[n_motions * piece + m] +=
              factor * (direction * rigid_motion(m, arm));
        }
      for (const auto &[i, a] : row)
        for (const auto &[j, b] : row)
          squares(i, j) += a * b;
    }

    /// A motion of each piece by itself is resisted.
    void resist(const unsigned int motion)
    {
      for (unsigned int piece = 0; piece < pieces.size(); ++piece)
        squares(n_motions * piece + motion, n_motions * piece + motion) += 1;
    }

    /// Add what the other ranks have.
    void sum(const MPI_Comm communicator)
    {
      Utilities::MPI::sum(squares, communicator, squares);
    }

    /// The orthogonal projection onto the motions that are free.
    FullMatrix<double> projection_onto_free() const;

  private:
    const MeshPieces<dim> &pieces;
    const Rotations<dim>  &rotations;
    FullMatrix<double>     squares;
  };



  // Rows that resist the same motion many times would hide others that one
  // row resists: all diagonal entries are scaled to one, but those that are
  // round-off beside the others of their piece.
  template<int dim>
  FullMatrix<double> ResistedMotions<dim>::projection_onto_free() const
  {
    const double        round_off = 1e-10;
    const unsigned int  n         = squares.m();
    std::vector<double> scale(n);
    for (unsigned int i = 0; i < n; ++i)
      {
        double largest = 0;
        for (unsigned int j = i - i % n_motions;
             j < i - i % n_motions + n_motions;
             ++j)
          largest = std::max(largest, squares(j, j));
        const double square = std::max(squares(i, i), round_off * largest);
        scale[i]            = square > 0 ? 1 / std::sqrt(square) : 1;
      }

    LAPACKFullMatrix<double> scaled(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j < n; ++j)
        scaled(i, j) = scale[i] * squares(i, j) * scale[j];
    Vector<double>     values;
    FullMatrix<double> modes;
    scaled.compute_eigenvalues_symmetric(-1, round_off, 0, values, modes);

    // Unscaled, the modes are no longer orthonormal (Gram and Schmidt, twice
    // because of round-off).
    FullMatrix<double>          projection(n, n);
    std::vector<Vector<double>> basis;
    for (unsigned int m = 0; m < values.size(); ++m)
      {
        Vector<double> mode(n);
        for (unsigned int i = 0; i < n; ++i)
          mode[i] = scale[i] * modes(i, m);
        mode /= mode.l2_norm();
        for (unsigned int pass = 0; pass < 2; ++pass)
          for (const Vector<double> &other : basis)
            mode.add(-(mode * other), other);
        mode /= mode.l2_norm();
        for (unsigned int i = 0; i < n; ++i)
          for (unsigned int j = 0; j < n; ++j)
            projection(i, j) += mode[i] * mode[j];
        basis.push_back(mode);
      }
    return projection;
  }
} // namespace Contact

#endif
