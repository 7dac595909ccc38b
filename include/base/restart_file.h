/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_restart_file_h
#define contact_restart_file_h

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>
#include <boost/serialization/map.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <streambuf>
#include <string>

#include "base/errors.h"

namespace Contact
{
  /// Hands over to a stream, whose state then tells whether the disk is full:
  /// an archive writes past the state of its stream, and sets its locale.
  class HandingOver : public std::streambuf
  {
  public:
    explicit HandingOver(std::ostream &to)
      : to(to)
    {
    }

  protected:
    std::streamsize xsputn(const char           *characters,
                           const std::streamsize n) override
    {
      to.write(characters, n);
      return n;
    }

    int_type overflow(const int_type character) override
    {
      to.put(traits_type::to_char_type(character));
      return character;
    }

  private:
    std::ostream &to;
  };



  /**
   * Write what @p parts serializes, behind @p key, which says what run it
   * belongs to.
   */
  template<class Parts>
  void
  write_restart(std::ostream &out, const std::string &key, const Parts &parts)
  {
    HandingOver                     to_out(out);
    boost::archive::binary_oarchive archive(to_out);
    archive                        &key;
    parts(archive);
  }



  /// Read it again. Throws InputError if it is of another run or damaged.
  template<class Parts>
  void read_restart(const std::filesystem::path &file,
                    const std::string           &key,
                    const Parts                 &parts)
  {
    bool is_of_this_run = false;
    try
      {
        std::ifstream                   in(file, std::ios::binary);
        boost::archive::binary_iarchive archive(in);
        std::string                     key_of_file;
        archive                        &key_of_file;
        is_of_this_run = key_of_file == key;
        if (is_of_this_run)
          parts(archive);
      }
    catch (const std::exception &)
      {
        throw InputError("the restart file is damaged",
                         file.string(),
                         "run without --restart");
      }
    if (!is_of_this_run)
      throw InputError("the restart file belongs to other parameters, to "
                       "another mesh, or to another number of processes",
                       file.string(),
                       "take the parameters, the mesh and the number of "
                       "processes of before, or run without --restart");
  }
} // namespace Contact

#endif
