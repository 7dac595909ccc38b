/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_command_line_h
#define contact_command_line_h

#include <iosfwd>
#include <string>
#include <vector>

namespace Contact
{
  /// The arguments of the program.
  struct CommandLine
  {
    std::vector<std::string> files;
    std::vector<std::string> overrides;
    bool                     quiet   = false;
    bool                     verbose = false; // every iteration
    bool                     restart = false; // go on where a run ended
  };



  /// The usage of the program.
  void print_help(std::ostream &out);

  /// The versions of the program and of deal.II.
  std::string program_version();

  /// Throws InputError for an unknown option, or without a file.
  CommandLine parse_command_line(const int argc, char **argv);
} // namespace Contact

#endif
