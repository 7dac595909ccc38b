/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_point_status_h
#define contact_point_status_h

#include <deal.II/base/tensor.h>

#include <type_traits>

namespace Contact
{
  using namespace dealii;

  /**
   * The status of a contact point: open, or under pressure and sticking, or
   * under pressure and slipping. A point without friction slips under a zero
   * bound.
   */
  enum class Status
  {
    open,
    stick,
    slip
  };



  /// A status, and for a slipping point the direction of its shear traction: in
  /// 2-D a sign, in 3-D a unit vector in the frame of the tangents.
  template<int dim>
  struct PointStatus
  {
    using Direction = std::conditional_t<dim == 2, int, Tensor<1, dim - 1>>;

    Status    kind = Status::open;
    Direction slip_direction{};

    /// The same as a vector.
    Tensor<1, dim - 1> direction() const;

    /// Whether there is a direction: not without friction.
    bool has_direction() const
    {
      return slip_direction != Direction();
    }

    /// A number of its own for each status; in 3-D directions are not told
    /// apart.
    signed char code() const;

    /// The status of this number.
    static PointStatus from_code(const signed char code);

    bool operator==(const PointStatus &other) const
    {
      return code() == other.code();
    }
  };



  template<>
  inline Tensor<1, 1> PointStatus<2>::direction() const
  {
    return Tensor<1, 1>({static_cast<double>(slip_direction)});
  }



  template<>
  inline Tensor<1, 2> PointStatus<3>::direction() const
  {
    return slip_direction;
  }



  template<>
  inline signed char PointStatus<2>::code() const
  {
    return 4 * static_cast<int>(kind) + slip_direction;
  }



  template<>
  inline signed char PointStatus<3>::code() const
  {
    return 4 * static_cast<int>(kind) + has_direction();
  }



  template<>
  inline PointStatus<2> PointStatus<2>::from_code(const signed char code)
  {
    const int kind = (code + 1) / 4;
    return {static_cast<Status>(kind), code - 4 * kind};
  }



  // The direction follows from the next state.
  template<>
  inline PointStatus<3> PointStatus<3>::from_code(const signed char code)
  {
    return {static_cast<Status>(code / 4), {}};
  }
} // namespace Contact

#endif
