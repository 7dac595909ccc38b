/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_errors_h
#define contact_errors_h

#include <stdexcept>
#include <string>

namespace Contact
{
  /**
   * The input is wrong. The message has three parts: what is wrong, where
   * (file and line, entry, or mesh group), and the remedy. Ends the program
   * with exit status 2.
   */
  struct InputError : public std::runtime_error
  {
    InputError(const std::string &what,
               const std::string &where,
               const std::string &remedy)
      : std::runtime_error("error:  " + what + "\nwhere:  " + where +
                           "\nremedy: " + remedy)
    {
    }

    /// With all three parts.
    explicit InputError(const std::string &message)
      : std::runtime_error(message)
    {
    }
  };

  /**
   * A loop did not reach its tolerance. The message says which loop, in which
   * increment, and what it was left with. Ends the program with exit status 3.
   */
  struct NotConverged : public std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };

  /**
   * An iterative linear solver does not reach its tolerance, or does not know
   * the present lines of contact: another one goes on in the same step.
   */
  struct SolverStalls : public NotConverged
  {
    using NotConverged::NotConverged;
  };

  /**
   * Somebody ends the run from outside. What is finished stays; ends the
   * program with exit status 5.
   */
  struct Interrupted : public std::runtime_error
  {
    using std::runtime_error::runtime_error;
  };
} // namespace Contact

#endif
