/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_files_h
#define contact_files_h

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <mpi.h>

namespace Contact
{
  /**
   * Create a directory and its parents, unless they exist. Throws InputError
   * if that fails, or if no file can be written there. No file in it is
   * touched.
   */
  void create_output_directory(const std::filesystem::path &directory);



  /**
   * Write a file by @p write, under another name until it is complete: an
   * interrupted run leaves the file of before or the new one, never half of
   * it. Throws InputError if it cannot be written.
   */
  void write_file(const std::filesystem::path               &file,
                  const std::function<void(std::ostream &)> &write);



  /// Go to the first character of a text, past the byte-order mark of UTF-8
  /// (EF BB BF) that some editors write in front of it.
  void skip_byte_order_mark(std::istream &text);



  /// The CRC-32 of a file, by which another content is another file.
  unsigned int checksum(const std::filesystem::path &file);



  /// Write a file on the first rank of @p communicator. Throws on all.
  void write_on_first_rank(const MPI_Comm               communicator,
                           const std::filesystem::path &file,
                           const std::function<void(std::ostream &)> &write);
} // namespace Contact

#endif
