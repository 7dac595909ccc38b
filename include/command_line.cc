/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "command_line.h"

#include <deal.II/base/config.h>

#include <ostream>

#include "errors.h"

namespace Contact
{
  void print_help(std::ostream &out)
  {
    out << "Frictional contact of two deformable bodies (plane strain,\n"
           "axisymmetry).\n"
           "\n"
           "usage: contact FILE [MORE ...] [options]\n"
           "\n"
           "FILE is a parameter file, NAME.prm or NAME.json.\n"
           "\n"
           "  --set \"Section/Entry=value\"   change an entry of all files\n"
           "  --quiet                       print the table only\n"
           "  --restart                     go on behind the last increment "
           "of an\n"
           "                                interrupted run\n"
           "  --parameters                  list all entries and their "
           "meaning\n"
           "  --version                     print the version\n"
           "  --help                        print this\n"
           "\n"
           "Results are written to output/<name of the file>/.\n"
           "Exit status: 0 all values within their tolerances, 1 one outside,\n"
           "2 the input is wrong, 3 a case did not converge, 5 interrupted.\n";
  }



  void print_version(std::ostream &out)
  {
    out << "contact " CONTACT_VERSION ", deal.II " DEAL_II_PACKAGE_VERSION "\n";
  }



  CommandLine parse_command_line(const int argc, char **argv)
  {
    CommandLine line;
    for (int i = 1; i < argc; ++i)
      {
        const std::string word = argv[i];
        if (word == "--set")
          {
            if (++i == argc)
              throw InputError("--set needs an assignment",
                               "command line",
                               "--set \"Section/Entry=value\"");
            line.overrides.push_back(argv[i]);
          }
        else if (word == "--quiet")
          line.quiet = true;
        else if (word == "--restart")
          line.restart = true;
        else if (word.rfind("--", 0) == 0)
          throw InputError("unknown option " + word,
                           "command line",
                           "see contact --help");
        else
          line.files.push_back(word);
      }
    if (line.files.empty())
      throw InputError("no parameter file is given",
                       "command line",
                       "contact FILE.prm; see contact --help");
    return line;
  }
} // namespace Contact
