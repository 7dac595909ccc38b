/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "base/files.h"

#include <deal.II/base/mpi.h>

#include <boost/crc.hpp>
#include <fstream>
#include <iterator>
#include <unistd.h>

#include "base/all_ranks.h"
#include "base/errors.h"

namespace Contact
{
  using namespace dealii;

  void create_output_directory(const std::filesystem::path &directory)
  {
    std::error_code error;
    std::filesystem::create_directories(directory, error);

    // A name of its own, for processes that check at the same time.
    const auto probe = directory / (".writable." + std::to_string(::getpid()));
    const bool writable =
      !error && static_cast<bool>(std::ofstream(probe) << std::flush);
    std::filesystem::remove(probe, error);
    if (!writable)
      throw InputError("the output directory cannot be created or written to",
                       directory.string(),
                       "set Output/Directory to a place where you may write");
  }



  void write_file(const std::filesystem::path               &file,
                  const std::function<void(std::ostream &)> &write)
  {
    std::filesystem::path part = file;
    part += ".part";
    std::ofstream out(part);
    try
      {
        write(out);
      }
    catch (const ExcIO &)
      {
        // The stream knows.
      }
    out.close();

    std::error_code error;
    if (out)
      std::filesystem::rename(part, file, error);
    if (!out || error)
      {
        std::filesystem::remove(part, error);
        throw InputError("the file cannot be written",
                         file.string(),
                         "make room on the disk, or set Output/Directory to a "
                         "place where you may write");
      }
  }



  void skip_byte_order_mark(std::istream &text)
  {
    const std::string mark = "\xEF\xBB\xBF";
    std::string       begin(mark.size(), ' ');
    text.read(begin.data(), begin.size());
    if (text && begin == mark)
      return;
    text.clear();
    text.seekg(0);
  }



  unsigned int checksum(const std::filesystem::path &file)
  {
    std::ifstream      in(file, std::ios::binary);
    const std::string  content{std::istreambuf_iterator<char>(in), {}};
    boost::crc_32_type crc;
    crc.process_bytes(content.data(), content.size());
    return crc.checksum();
  }



  void write_on_first_rank(const MPI_Comm               communicator,
                           const std::filesystem::path &file,
                           const std::function<void(std::ostream &)> &write)
  {
    on_all_ranks(communicator, [&]() {
      if (Utilities::MPI::this_mpi_process(communicator) == 0)
        write_file(file, write);
    });
  }
} // namespace Contact
