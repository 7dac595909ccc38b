/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "base/command_line.h"

#include <deal.II/base/config.h>

#include <ostream>

#include "base/errors.h"

namespace Contact
{
  void print_help(std::ostream &out)
  {
    out
      << R"(Frictional contact of two deformable bodies in 2-D, with axisymmetry, and in 3-D.

usage: contact FILE [MORE ...] [options]

FILE is a parameter file, NAME.prm or NAME.json.

  --set "Section/Entry=value"   change an entry of all files
  --quiet                       print the table only
  --verbose                     print every iteration, as log.txt has them
  --restart                     go on behind the last increment of an
                                interrupted run
  --parameters                  list all entries and their meaning
  --version                     print the version
  --help                        print this

Results are written to output/<name of the file>/.
Exit status: 0 all values within their tolerances, 1 one outside or an
invariant violated, 2 the input is wrong or results cannot be written,
3 a case did not converge, 4 an error of the program itself, 5 interrupted.
Environment: OPENBLAS_NUM_THREADS, threads of the direct solvers (1 by ./run),
and what Open MPI knows.
)";
  }



  std::string program_version()
  {
    return "contact " CONTACT_VERSION ", deal.II " DEAL_II_PACKAGE_VERSION;
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
        else if (word == "--verbose")
          line.verbose = true;
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
